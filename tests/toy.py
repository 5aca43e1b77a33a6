"""A hand-made two-room home with boxes for models, and whole data sets of it without a simulator.

Scene ``i`` has ``i % 4`` anomalies: a stove that is on, then a knife on the table, then milk out
of the fridge. A knife on a high shelf is the lookalike. Pictures are drawn box by box.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from functools import lru_cache
from pathlib import Path
from typing import Any

from sdgen.actions import at_rest
from sdgen.cameras.pinhole import intrinsics, matrix4
from sdgen.catalog.load import load_catalog
from sdgen.catalog.records import Catalog
from sdgen.dataset import DatasetWriter
from sdgen.dataset.records import ManifestEntry
from sdgen.dataset.scene_folder import SceneWriter
from sdgen.facts import bodies_of
from sdgen.freespace import free_shape, rounded_rings
from sdgen.geometry import look_at, quat_from_yaw, round_position, round_quat
from sdgen.hazards.certify import certificate, facts_of, survey
from sdgen.hazards.labels import anomaly_records
from sdgen.hazards.splits import Split, split_of_home
from sdgen.hazards.twin import with_changes
from sdgen.library.records import AssetInfo, Container, Joint, Part, StateRule, Support
from sdgen.library.states import derive_states
from sdgen.options import BuildOptions
from sdgen.pipeline.putting import Rest
from sdgen.pipeline.remedied import Remedied
from sdgen.pipeline.twins import twin_of, twin_with
from sdgen.pipeline.undoing import check_undone
from sdgen.rejection import Rejection
from sdgen.scene import (
    AgentStart,
    Anomalies,
    Box,
    Camera,
    Contact,
    Frame,
    Home,
    Household,
    Lookalike,
    Member,
    ObjectInstance,
    Opening,
    PhysicsReport,
    Pose,
    Room,
    Scene,
    SceneBundle,
    Structure,
    Undone,
    Visibility,
    toggle_id,
    twin_id,
)
from sdgen.truth import build_graph, visibility_of
from sdgen.zones import derive_zones, floor_obstacles

from tests import toy_pictures

ASSETS_SHA256 = "a" * 64
VERSIONS = {"sdgen": "test"}
SPLITS: tuple[Split, ...] = ("train", "val", "test")
#: A name of a home of each split.
HOMES = {split_of_home(f"toy_{k}"): f"toy_{k}" for k in range(60)}


def _info(name: str, size: tuple[float, float, float], **more: Any) -> AssetInfo:
    more.setdefault("parts", (Part(name="body", faces=12),))
    more.setdefault("variants", {"default": ("body",)})
    return AssetInfo(
        id=name,
        category=name[:-3],
        licence="CC0-1.0",
        source="test",
        extents_m=size,
        mass_kg=1.0,
        **more,
    )


def _top(size: tuple[float, float, float]) -> Support:
    x, y = size[0] / 2 - 0.01, size[1] / 2 - 0.01
    outline = ((-x, -y), (x, -y), (x, y), (-x, y))
    return Support(name="top", part="body", z_m=size[2], polygon_m=outline)


@lru_cache
def infos() -> dict[str, AssetInfo]:
    """Six models: plain boxes, a stove that can be lit, a fridge with a door and an inside."""
    door = Joint(
        name="door", type="revolute", origin_m=(0.3, 0.3, 0), axis=(0, 0, 1), lower=0, upper=1.9
    )
    table, shelf = (1.2, 0.8, 0.74), (0.4, 0.9, 1.8)
    found = [
        _info("kitchen_table_01", table, supports=(_top(table),)),
        _info("bookshelf_01", shelf, supports=(_top(shelf),)),
        _info("knife_01", (0.2, 0.03, 0.01)),
        _info("milk_carton_01", (0.07, 0.07, 0.2)),
        _info("cushion_01", (0.4, 0.4, 0.12)),
        _info("door_01", (0.05, 0.8, 2.0)),
        _info(
            "stove_01",
            (0.6, 0.6, 0.9),
            parts=(Part(name="body", faces=12), Part(name="glow", faces=12)),
            variants={"default": ("body",), "lit": ("body", "glow")},
            states=(
                StateRule(state="ON", variants=("lit",), parts=("glow",)),
                StateRule(state="OFF", variants=("default",), parts=("body",)),
            ),
        ),
        _info(
            "fridge_01",
            (0.6, 0.6, 1.8),
            parts=(Part(name="body", faces=12), Part(name="door", faces=12, joint="door")),
            variants={"default": ("body", "door")},
            joints=(door,),
            states=(
                StateRule(state="CLOSED", joint="door", max=0.03),
                StateRule(state="OPEN", joint="door", min=0.6, parts=("door",)),
            ),
            containers=(
                Container(
                    name="inside",
                    part="body",
                    center_m=(0, 0, 0.9),
                    size_m=(0.5, 0.5, 1.6),
                    closed_by="door",
                ),
            ),
        ),
    ]
    return {info.id: info for info in found}


@lru_cache
def catalog() -> Catalog:
    """The shipped catalogue."""
    return load_catalog()


def _home(name: str) -> Home:
    rooms = []
    structures = []
    for k, (kind, low, high) in enumerate([("kitchen", 0.0, 3.0), ("living_room", 3.1, 6.0)]):
        room_id = 100 + k
        outline = ((0.0, low), (4.0, low), (4.0, high), (0.0, high))
        rooms.append(Room(id=room_id, name=kind, type=kind, polygon_m=outline, height_m=2.5))
        middle = (low + high) / 2
        boxes = {
            "floor": Box(center_m=(2, middle, -0.05), size_m=(4, high - low, 0.1)),
            "ceiling": Box(center_m=(2, middle, 2.55), size_m=(4, high - low, 0.1)),
            "wall": Box(center_m=(-0.05, middle, 1.25), size_m=(0.1, high - low, 2.5)),
        }
        for j, (category, box) in enumerate(boxes.items()):
            structures.append(
                Structure(
                    id=200 + 10 * k + j,
                    category=category,
                    room_id=room_id,
                    surface=f"{category}_1",
                    pieces=(box,),
                )
            )
    door = Opening(
        object_id=42,
        kind="door",
        room_ids=(100, 101),
        center_m=(2, 3.05, 0),
        along="x",
        width_m=0.8,
        height_m=2.0,
    )
    return Home(
        id=name, kind="base", rooms=tuple(rooms), structures=tuple(structures), openings=(door,)
    )


def thing(
    number: int,
    asset: str,
    position: tuple[float, float, float],
    yaw: float = 0.0,
    room: int = 100,
    **more: Any,
) -> ObjectInstance:
    """An object of one of the toy models, states derived."""
    info = infos()[asset]
    variant, joints = more.get("variant", "default"), more.setdefault("joints", {})
    for joint in info.joints:
        joints.setdefault(joint.name, 0.0)
    return ObjectInstance(
        id=number,
        category=info.category,
        asset=asset,
        pose=Pose(position_m=round_position(position), quat_xyzw=round_quat(quat_from_yaw(yaw))),
        room_id=room,
        states=derive_states(info, variant, joints),
        parts=info.variants[variant],
        **more,
    )


def scene(index: int = 3, anomalies: int | None = None) -> Scene:
    """Scene ``index`` with ``index % 4`` anomalies (or as many as asked for)."""
    wanted = index % 4 if anomalies is None else anomalies
    milk = (1.4, 0.8, 0.74) if wanted > 2 else (0.5, 2.5, 0.2)
    objects = [
        thing(
            11, "stove_01", (3.5, 0.5, 0), variant="lit" if wanted > 0 else "default", fixed=True
        ),
        thing(305, "fridge_01", (0.5, 2.5, 0), fixed=True),
        thing(77, "kitchen_table_01", (1.5, 1.0, 0), yaw=0.1, fixed=True),
        thing(4000, "milk_carton_01", milk, yaw=0.3),
        thing(30, "bookshelf_01", (0.3, 5.0, 0), room=101, fixed=True),
        thing(512, "knife_01", (0.3, 5.0, 1.8), yaw=1.0, room=101),
        thing(42, "door_01", (2.0, 3.05, 0), yaw=1.570796, fixed=True),
        # Against the wall: in the middle of the floor somebody would trip over it.
        thing(65535, "cushion_01", (3.75, 5.75, 0), room=101),
    ]
    if wanted > 1:
        objects.append(thing(600, "knife_01", (1.7, 1.1, 0.74), yaw=0.5))
    objects.sort(key=lambda item: item.id)
    home = _home(HOMES[SPLITS[index % 3]])
    furniture = bodies_of([item for item in objects if item.fixed], infos())
    traits = {category.name: category.properties for category in catalog().categories}
    free = free_shape(home, floor_obstacles(furniture))
    return Scene(
        id=f"{index:06d}",
        index=index,
        home=home,
        zones=derive_zones(home, furniture, free, traits),
        free_space=rounded_rings(free),
        agent_start=AgentStart(position_m=(2.5, 2.0, 0.0), yaw_rad=0.5, room_id=100),
        objects=tuple(objects),
    )


def household(child_age: int | None = 5) -> Household:
    """Two adults, and a child if an age is given."""
    members = [Member(role="adult", age=38), Member(role="adult", age=36)]
    if child_age is not None:
        members.append(Member(role="child", age=child_age))
    return Household(template="toy", members=tuple(members))


#: Where the cameras stand and what they look at: the kitchen with all that can be wrong, and the
#: shelf with the knife that is not.
_LOOKS = (((2.3, 0.0, 2.0), (2.2, 1.0, 0.8)), ((1.8, 3.9, 2.3), (0.3, 5.0, 1.5)))


def camera(index: int, options: BuildOptions) -> Camera:
    """The first looks at the kitchen, the second at the living room, further ones as these."""
    width, height = options.width, options.height
    return Camera(
        index=index,
        kind="room",
        room_id=100 + index % 2,
        width=width,
        height=height,
        K=intrinsics(width, height),
        world_from_camera=matrix4(look_at(*_LOOKS[index % 2])),
        near_m=0.05,
        far_m=20.0,
    )


def bundle(
    index: int = 3, options: BuildOptions | None = None, who: Household | None = None
) -> SceneBundle:
    """A whole proved scene without its pictures."""
    options = options or small()
    who = who or household(5 if index % 2 else None)
    made = scene(index)
    facts = facts_of(made, infos(), catalog())
    result = survey(facts, catalog())
    assert all(p.verdict.sure and p.verdict.value for p in result.positives), result.positives
    shelf = catalog().hazard("sharp_object").predicate.measure(512, facts)
    return SceneBundle(
        scene=made,
        graph=build_graph(made, infos(), catalog(), facts),
        anomalies=Anomalies(
            anomalies=anomaly_records(
                result.positives,
                facts,
                catalog(),
                who,
                {(p.object_id, p.hazard) for p in result.positives},
            ),
            lookalikes=(Lookalike(object_id=512, near_miss_of="sharp_object", evidence=shelf),),
            certificate=certificate(catalog(), ASSETS_SHA256, result),
        ),
        household=who,
        physics=PhysicsReport(
            settled_drift_m={str(item.id): 0.001 for item in made.objects if not item.fixed},
            contacts=tuple(
                Contact(a=a, b=b, distance_m=0.0)
                for a, b in sorted(
                    tuple(sorted((item.id, held.target_id)))
                    for item in made.objects
                    if not item.fixed
                    for held in (*facts.on(item.id), *facts.inside(item.id))
                )
            ),
            steps=60,
            home_attempts=1,
            placement_attempts=1,
            rejections=(),
            taken_away=(),
        ),
        split=SPLITS[index % 3],
        cameras=tuple(camera(k, options) for k in range(options.views)),
    )


def frame(made: SceneBundle, index: int) -> Frame:
    """A view drawn by ``toy_pictures``."""
    return toy_pictures.frame(made.scene, made.cameras[index], infos())


def frames(made: SceneBundle) -> list[Frame]:
    """The painted views of all cameras."""
    return [frame(made, camera.index) for camera in made.cameras]


def visibility(
    made: SceneBundle, pictures: Iterable[Frame], options: BuildOptions | None = None
) -> Visibility:
    """Its visibility."""
    options = options or small()
    return visibility_of(
        made.scene, made.anomalies.anomalies, pictures, options.width, options.height
    )


def small(n: int = 4, **more: Any) -> BuildOptions:
    """Options of a small data set."""
    return BuildOptions(**{"n": n, "seed": 7, "views": 2, "width": 160, "height": 120, **more})


def open_writer(path: Path, options: BuildOptions | None = None, **more: Any) -> DatasetWriter:
    """A writer on ``path``."""
    more.setdefault("versions", VERSIONS)
    return DatasetWriter.open(path, options or small(), catalog(), infos(), ASSETS_SHA256, **more)


def painter(writer: DatasetWriter) -> SceneWriter:
    """What writes scenes, with the renderer's name."""
    return replace(writer.scene_writer, renderer="painted")


def write_scene(writer: SceneWriter, made: SceneBundle, pictures: Sequence[Frame]) -> ManifestEntry:
    """Write a whole scene, as workers do."""
    with writer.begin(made) as folder:
        for picture in pictures:
            folder.add(picture)
        return folder.finish(visibility(made, pictures))


def add_scene(writer: DatasetWriter, index: int) -> None:
    """Write toy scene ``index``."""
    made = bundle(index, writer.build.options)
    pictures = frames(made) if writer.build.options.sensors else []
    write_scene(painter(writer), made, pictures)


def build(path: Path, options: BuildOptions | None = None) -> Path:
    """A finished data set."""
    options = options or small()
    with open_writer(path, options) as writer:
        for index in range(options.n):
            if f"{index:06d}" not in writer.done:
                add_scene(writer, index)
        writer.finish()
    return path


def twin(made: SceneBundle) -> SceneBundle:
    """The benign twin of a bundle, the plain way."""
    found = check_undone(made.scene, made.anomalies.anomalies, catalog(), infos())
    assert not isinstance(found, Rejection), found
    return twin_of(made, catalog(), infos(), *found)


def remedied(made: SceneBundle, only: str | None = None) -> SceneBundle:
    """The twin of a bundle, or the scene with one anomaly undone (its id), by hand and without a
    simulator: the stove switched off, the milk back in the fridge, the knife taken away."""
    anomalies = [one for one in made.anomalies.anomalies if only in (None, one.id)]
    after: dict[int, ObjectInstance | None] = {}
    undone = []
    for one in anomalies:
        item, step = (
            made.scene.object(one.object_id),
            Undone(
                anomaly_id=one.id, hazard=one.hazard, object_id=one.object_id, action="take_away"
            ),
        )
        if item.category == "stove":
            after[item.id] = at_rest(item, infos()[item.asset])
            step = step.model_copy(update={"action": "switch_off"})
        elif item.category == "milk_carton":
            pose = Pose(position_m=(0.5, 2.5, 0.2), quat_xyzw=item.pose.quat_xyzw)
            after[item.id] = item.model_copy(update={"pose": pose})
            step = step.model_copy(update={"action": "put_in", "target_id": 305, "moved": True})
        else:
            after[item.id] = None
            step = step.model_copy(update={"removed": True})
        undone.append(step)
    name = made.scene.id
    changes = {
        "id": twin_id(name) if only is None else toggle_id(name, only),
        "twin_of": name,
        "objects": with_changes(made.scene, after, infos()),
    }
    facts = facts_of(made.scene.model_copy(update=changes), infos(), catalog())
    moved = {one.object_id: Rest(0.002, ()) for one in undone if one.moved}
    found = Remedied(facts, survey(facts, catalog()), rests=moved)
    return twin_with(made, catalog(), infos(), found, tuple(undone))


def build_with_twins(path: Path, n: int = 4, toggles: bool = False) -> Path:
    """A finished data set with every scene's twin, and its toggles."""
    with open_writer(path, small(n=n, twins=True, toggles=toggles)) as writer:
        for index in range(n):
            if f"{index:06d}" not in writer.done:
                made = bundle(index, writer.build.options)
                ids = [one.id for one in made.anomalies.anomalies] if toggles else []
                for benign in (remedied(made), *(remedied(made, only) for only in ids)):
                    write_scene(painter(writer), benign, frames(benign))
                add_scene(writer, index)
        writer.finish()
    return path
