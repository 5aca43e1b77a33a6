"""A built scene edited by hand, its digests made right again: every edit is named, and where."""

from __future__ import annotations

import math
import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from sdgen.catalog.load import load_catalog
from sdgen.cli.main import run
from sdgen.dataset import Dataset
from sdgen.facts import Body
from sdgen.geometry import quat_from_yaw, round_quat
from sdgen.hazards.certify import facts_of
from sdgen.library.records import AssetInfo
from sdgen.library.states import derive_states
from sdgen.scene import ObjectInstance, Scene
from sdgen.truth import build_graph
from sdgen.validate import validate
from sdgen.vocabulary import OPENINGS
from shapely.geometry import Polygon

from tests.edits import edit_json, reseal
from tests.shared import Shared

LAST = "scenes/000000"
Infos = dict[str, AssetInfo]
Changes = dict[str, Any]


@pytest.fixture(scope="module")
def built(shared: Shared) -> Path:
    """A scene and its twin, drawn small."""

    def make(path: Path) -> None:
        options = "--n 1 --seed 7 --views 2 --size 64x48 --twins --renderer cpu --workers 1"
        assert run(["build", *options.split(), "--out", str(path)]) == 0

    return shared.folder("drawn-by-tiny", make)


@pytest.fixture
def copy(built: Path, tmp_path: Path) -> Path:
    return Path(shutil.copytree(built, tmp_path / "d"))


def all_loose_on_furniture(scene: Scene, infos: Infos) -> list[ObjectInstance]:
    """Loose things well above the floor that lie on pieces of furniture."""
    facts = facts_of(scene, infos, load_catalog())
    return [
        item
        for item in scene.objects
        if not item.fixed
        and item.pose.position_m[2] > 0.5
        and any(r.holds and r.sure for r in facts.on(item.id))
        and not facts.inside(item.id)
    ]


def loose_on_furniture(scene: Scene, infos: Infos) -> ObjectInstance:
    return all_loose_on_furniture(scene, infos)[0]


def into_the_air(scene: Scene, infos: Infos) -> tuple[int, Changes]:
    item = loose_on_furniture(scene, infos)
    x, y, z = item.pose.position_m
    return item.id, {"pose": {**item.pose.model_dump(), "position_m": (x, y, round(z + 0.05, 5))}}


def off_its_support(scene: Scene, infos: Infos) -> tuple[int, Changes]:
    item = loose_on_furniture(scene, infos)
    room = next(r for r in scene.home.rooms if r.id == item.room_id)
    at = Polygon(room.polygon_m).representative_point()
    position = (round(at.x, 5), round(at.y, 5), item.pose.position_m[2])
    return item.id, {"pose": {**item.pose.model_dump(), "position_m": position}}


def into_a_wall(scene: Scene, infos: Infos) -> tuple[int, Changes]:
    """What is smaller than the wall is thick, so that it hangs in the wall alone."""
    loose = all_loose_on_furniture(scene, infos)
    item = min(loose, key=lambda item: max(infos[item.asset].extents_m))
    walls = (s for s in scene.home.structures if s.category == "wall")
    piece = next(s for s in walls if s.room_id == item.room_id).pieces[0]
    return item.id, {"pose": {**item.pose.model_dump(), "position_m": piece.center_m}}


def through_a_wall(scene: Scene, infos: Infos) -> tuple[int, Changes]:
    """A cupboard with its face to the wall, shut: a leaf that is opened there goes through it."""
    item, joint = next(
        (item, joint)
        for item in scene.objects
        if item.category in ("fridge", "wardrobe")
        for joint in infos[item.asset].joints
        if joint.type == "revolute" and abs(joint.axis[2]) == 1 and joint.upper > 1.4
    )
    info = infos[item.asset]
    joints = {**item.joints, joint.name: 1.4}
    yaw = 2 * math.atan2(item.pose.quat_xyzw[2], item.pose.quat_xyzw[3])
    quat = round_quat(quat_from_yaw(yaw + 3.14159265))
    return item.id, {
        "pose": {**item.pose.model_dump(), "quat_xyzw": quat},
        "joints": joints,
        "states": derive_states(info, item.variant, joints),
    }


def shards_over_the_edge(scene: Scene, infos: Infos) -> tuple[int, Changes]:
    """A whole glass becomes a broken one with its middle 4 cm from the edge of what it is on."""
    facts = facts_of(scene, infos, load_catalog())
    for item in scene.objects:
        info = infos[item.asset]
        if item.fixed or "broken" not in info.variants or "shards" not in info.variants["broken"]:
            continue
        for held in facts.on(item.id):
            owner = facts.bodies.get(held.target_id)
            for surface in owner.surfaces if owner is not None else ():
                if abs(surface.z_m - item.pose.position_m[2]) > 0.01:
                    continue
                x0, y0, _, y1 = surface.bounds
                position = (round(x0 + 0.04, 5), round((y0 + y1) / 2, 5), item.pose.position_m[2])
                changes = {
                    "pose": {"position_m": position, "quat_xyzw": (0.0, 0.0, 0.0, 1.0)},
                    "variant": "broken",
                    "parts": info.variants["broken"],
                    "states": derive_states(info, "broken", item.joints),
                }
                after = item.model_copy(update={"variant": "broken"})
                if len(Body(after, info).pieces) > 2:
                    return item.id, changes
    raise AssertionError("nothing in the scene could break")


def up_the_wall(scene: Scene, infos: Infos) -> tuple[int, Changes]:
    item = next(i for i in scene.objects if i.fixed and i.category == "wardrobe")
    x, y, z = item.pose.position_m
    return item.id, {"pose": {**item.pose.model_dump(), "position_m": (x, y, round(z + 0.05, 5))}}


def off_the_wall(scene: Scene, infos: Infos) -> tuple[int, Changes]:
    """What hangs comes 10 cm forward, into the room that is before its back, over nothing that
    it could then stand on."""
    facts = facts_of(scene, infos, load_catalog())
    for item in scene.objects:
        x, y, z = item.pose.position_m
        if not item.fixed or item.category in OPENINGS or not 0.5 < z < 1.8:
            continue
        forward = item.pose.matrix()[:3, 0] * 0.1
        position = (round(x + forward[0], 5), round(y + forward[1], 5), z)
        changes = {"pose": {**item.pose.model_dump(), "position_m": position}}
        body = facts.bodies[item.id]
        below = Body(item.model_validate({**item.model_dump(), **changes}), body.info).footprint
        others = (other for other in facts.bodies.values() if other is not body)
        if not any(below.intersects(other.footprint) for other in others):
            return item.id, changes
    raise AssertionError("the scene has nothing that hangs alone")


Change = Callable[[Scene, Infos], tuple[int, Changes]]


@pytest.mark.slow
@pytest.mark.parametrize(
    ("change", "words"),
    [
        (into_the_air, "rests on nothing"),
        (off_its_support, "rests on nothing"),
        (into_a_wall, " into wall "),
        (through_a_wall, " into wall "),
        (shards_over_the_edge, "a piece of it rests on nothing"),
        (up_the_wall, "is fixed in the air: on nothing, "),
        (off_the_wall, "is fixed in the air: on nothing, "),
    ],
)
def test_an_edit_is_named_though_the_graph_was_made_to_agree(
    copy: Path, change: Change, words: str
) -> None:
    data = Dataset(copy)
    infos = dict(data.infos)
    key, changes = change(data[0].scene, infos)

    def edit(scene: Any) -> None:
        index = [thing["id"] for thing in scene["objects"]].index(key)
        scene["objects"][index].update(changes)

    edit_json(copy / LAST / "scene.json", edit)
    scene = Dataset(copy, partial=True)[0].scene
    facts = facts_of(scene, infos, data.catalog)
    graph = build_graph(scene, infos, data.catalog, facts).model_dump_json()
    (copy / LAST / "graph.json").write_text(graph, encoding="utf-8")
    reseal(copy)
    found = [p for p in validate(copy) if f"{LAST}/scene.json: object {key} " in p.text]
    # What is in a wall between two rooms is in the wall of each.
    assert {p.check for p in found if words in p.text} == {"scene"}, found


@pytest.mark.slow
def test_a_thing_pushed_aside_is_named_by_what_followed_from_it(copy: Path) -> None:
    """5 cm further on the same table: no law is broken, but it is not where the graph has it."""
    data = Dataset(copy)
    key = loose_on_furniture(data[0].scene, dict(data.infos)).id

    def edit(scene: Any) -> None:
        thing = next(thing for thing in scene["objects"] if thing["id"] == key)
        thing["pose"]["position_m"][0] = round(thing["pose"]["position_m"][0] + 0.05, 5)

    edit_json(copy / LAST / "scene.json", edit)
    reseal(copy)
    assert any(f"nodes.{key}.obj_transform.position" in p.text for p in validate(copy))


@pytest.mark.slow
def test_a_household_that_is_another_is_named_by_what_it_would_have_reported(copy: Path) -> None:
    anomalies = Dataset(copy)[0].anomalies.anomalies
    catalog = load_catalog()
    # What concerns children alone may be reported for a pet, and there is none then.
    told, anomaly = next(
        (k, one)
        for k, one in enumerate(anomalies)
        if one.report and catalog.hazard(one.hazard).concerns.who == "everyone"
    )
    other = "now" if anomaly.notify == "summary" else "summary"

    def edit(household: Any) -> None:
        # Nobody that the hazard is raised by: then the choice is what counts.
        household["pets"], household["conditions"] = [], []
        household["notifications"] = {anomaly.hazard: other}

    edit_json(copy / LAST / "household.json", edit)
    reseal(copy)
    named = f"anomalies[{told}].notify: "
    found = [p.text for p in validate(copy)]
    assert any(named in text and other in text for text in found), found
