"""validate: silent on a sound data set, and one edit anywhere is found and located."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from PIL import Image
from sdgen.validate import validate

from tests import toy
from tests.edits import edit_json, edit_picture, reseal

LAST = "scenes/000003"
Edit = Callable[[Any], None]


def test_a_sound_data_set_has_no_problems(tmp_path: Path) -> None:
    calls: list[tuple[int, int]] = []
    found = validate(toy.build(tmp_path / "d"), on_scene=lambda a, b: calls.append((a, b)))
    assert found == []
    assert calls == [(1, 4), (2, 4), (3, 4), (4, 4)]


@pytest.mark.parametrize("sensors", [(), ("rgb",), ("depth",), ("instance",)])
def test_fewer_sensors_are_sound_too(tmp_path: Path, sensors: tuple[str, ...]) -> None:
    assert validate(toy.build(tmp_path / "d", toy.small(n=2, sensors=sensors))) == []


@pytest.fixture(scope="module")
def sound(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return toy.build(tmp_path_factory.mktemp("sound") / "d")


@pytest.fixture
def copy(sound: Path, tmp_path: Path) -> Path:
    import shutil

    return Path(shutil.copytree(sound, tmp_path / "d"))


def _put(path: str, value: Any) -> Edit:
    """An edit that sets ``a.b.0.c`` (``-`` deletes)."""

    def edit(data: Any) -> None:
        *steps, last = path.split(".")
        for step in steps:
            data = data[int(step) if isinstance(data, list) else step]
        key = int(last) if isinstance(data, list) else last
        if value == "-":
            del data[key]
        else:
            data[key] = value

    return edit


def _object(object_id: int, path: str, value: Any) -> Edit:
    def edit(data: Any) -> None:
        index = [o["id"] for o in data["objects"]].index(object_id)
        _put(f"objects.{index}.{path}", value)(data)

    return edit


def _node(node_id: int, path: str, value: Any) -> Edit:
    def edit(data: Any) -> None:
        index = [n["id"] for n in data["nodes"]].index(node_id)
        _put(f"nodes.{index}.{path}", value)(data)

    return edit


# (file of scene 3, edit, check that finds it, words of the problem)
EDITS: list[tuple[str, Edit, str, str]] = [
    # physics.json names nothing that is not there
    ("physics.json", _put("settled_drift_m", {"64999": 0.0}), "scene", "64999 is no object"),
    ("physics.json", _put("contacts.0.a", 1), "scene", "contacts[0]: 1 is no object"),
    # it speaks of every loose thing and of no other, within the limit
    ("physics.json", _put("settled_drift_m.512", "-"), "scene", "nothing of object 512 (knife)"),
    ("physics.json", _put("settled_drift_m.11", 0.0), "scene", "11 is no object of the scene that"),
    ("physics.json", _put("settled_drift_m.512", 0.5), "scene", "_m.512: 0.5 is not in 0 to 0.1"),
    ("physics.json", _put("settled_drift_m.512", -0.5), "scene", "_m.512: -0.5 is not in 0"),
    ("physics.json", _put("contacts", []), "scene", "contacts: object 512 (knife) touches nothing"),
    ("physics.json", _put("contacts.0.b", 1), "scene", "contacts: not one a pair, sorted"),
    # the agent begins on free floor
    (
        "scene.json",
        _put("agent_start.position_m", [2.5, -3.0, 0.0]),
        "scene",
        "agent_start.position_m: 3.25 m outside the free space",
    ),
    ("scene.json", _put("agent_start.position_m.2", 0.5), "scene", "0.5 m high, not on the floor"),
    ("scene.json", _put("agent_start.room_id", 101), "scene", "room_id: 101 stored, 100 derived"),
    # scene.json on its own
    ("scene.json", _put("index", 4), "scene", "are not the manifest's"),
    ("scene.json", _put("format_version", "0.9"), "scene", "format_version"),
    ("scene.json", _object(600, "pose.position_m.0", 1.7000012), "scene", "not rounded to 1e-5"),
    ("scene.json", _object(600, "pose.quat_xyzw.3", 0.9), "scene", "no unit quaternion"),
    ("scene.json", _object(11, "states", ["OFF"]), "scene", "object 11 (stove): states"),
    ("scene.json", _object(11, "variant", "default"), "scene", "parts: not those of variant"),
    ("scene.json", _object(11, "variant", "burning"), "scene", "none of the asset's"),
    ("scene.json", _object(305, "joints.door", 2.5), "scene", "joints.door: 2.5 is beyond"),
    ("scene.json", _object(305, "joints", {}), "scene", "joints: not exactly"),
    ("scene.json", _object(600, "asset", "sword_01"), "scene", "'sword_01' is not in assets"),
    ("scene.json", _object(600, "category", "fork"), "scene", "its asset is a knife"),
    ("scene.json", _object(600, "room_id", 102), "scene", "no room 102"),
    ("scene.json", _object(600, "room_id", 101), "scene", "room_id: 101 stored, [100] derived"),
    ("scene.json", _object(600, "id", 512), "scene", "id 512 is used 2 times"),
    ("scene.json", _object(600, "id", 70000), "scene", "70000 is not in 1 to 65535"),
    ("scene.json", _put("home.openings.0.object_id", 43), "scene", "object 43 or its rooms"),
    ("scene.json", _put("agent_start.room_id", 5), "scene", "room 5 does not exist"),
    ("scene.json", _put("zones.0.z_max_m", 1.0), "scene", "z_max_m: 1.0 stored"),
    ("scene.json", _put("zones.0", "-"), "scene", "nothing stored"),
    ("scene.json", _put("free_space.0.0.0", 0.123), "scene", "free_space: not what"),
    ("scene.json", _put("extra", 1), "file", "scene.json: extra: unknown key"),
    ("scene.json", _object(600, "pose.position_m", [1, 2]), "file", "pose.position_m"),
    # numbers that no home has are told where they are read, before anything is computed of them
    (
        "scene.json",
        _object(600, "pose.position_m.0", 1e308),
        "file",
        "pose.position_m[0]: input should be less than or equal to 1000000 (got the number 1e+308)",
    ),
    ("scene.json", _object(305, "joints.door", -1e308), "file", "joints.door: input should be"),
    ("scene.json", _put("zones.0.z_max_m", 10**30), "file", "zones[0].z_max_m: input should be"),
    ("physics.json", _put("settled_drift_m.512", 1e308), "file", "settled_drift_m.512: input"),
    # what follows from it
    ("scene.json", _object(600, "pose.position_m.2", 0.75), "graph", "nodes.600"),
    ("scene.json", _object(600, "pose.position_m.2", 1.5), "scene", "600 (knife): rests on"),
    ("graph.json", _node(11, "states", ["OFF"]), "graph", "nodes.11.states"),
    ("graph.json", _node(600, "class_name", "fork"), "graph", 'nodes.600.class_name: "fork"'),
    ("graph.json", _node(600, "tags", []), "graph", "nodes.600.tags"),
    ("graph.json", _node(600, "bounding_box.size.0", 9.0), "graph", "bounding_box.size[0]"),
    ("graph.json", _put("nodes.0", "-"), "graph", "nodes.11: nothing stored"),
    ("graph.json", _put("edges.0", "-"), "graph", "is missing"),
    ("graph.json", _put("edges.0.relation_type", "UNDER"), "graph", "UNDER"),
    # labels
    ("anomalies.json", _put("anomalies.0", "-"), "label", "stove_on: holds and is not listed"),
    ("anomalies.json", _put("anomalies.1.object_id", 512), "label", "listed and does not hold"),
    ("anomalies.json", _put("anomalies.1.report", False), "label", "anomalies[1].report"),
    ("anomalies.json", _put("anomalies.1.notify", "summary"), "label", "anomalies[1].notify"),
    ("anomalies.json", _put("anomalies.1.evidence.reach_height_m", 0.7), "label", "reach_height"),
    ("anomalies.json", _put("anomalies.0.evidence_parts", ["body"]), "label", "evidence_parts"),
    ("anomalies.json", _put("anomalies.0.evidence_pixels_needed", 9), "label", "pixels_needed: 9"),
    ("anomalies.json", _put("anomalies.0.message", "All is well."), "label", "message"),
    ("anomalies.json", _put("anomalies.1.target_id", 30), "label", "anomalies[1].target_id"),
    ("anomalies.json", _put("lookalikes.0.object_id", 600), "label", "600 is an anomaly"),
    ("anomalies.json", _put("lookalikes.0.object_id", 9), "label", "no object 9"),
    ("anomalies.json", _put("lookalikes.0.near_miss_of", "fire"), "label", "no hazard 'fire'"),
    ("anomalies.json", _put("lookalikes.0.evidence", {}), "label", "lookalikes[0]: evidence"),
    ("anomalies.json", _put("certificate.pairs_checked", 1), "label", "certificate.pairs_checked"),
    ("household.json", _put("members.2.age", 15), "label", "anomalies[1].report"),
    (
        "household.json",
        _put("notifications", {"refrigerated_food_out": "silent"}),
        "label",
        "report: true stored, false derived",
    ),
    # views
    ("visibility.json", _put("views.0.objects.0.bbox.0", 3), "view", "views[0].objects.11.bbox"),
    ("visibility.json", _put("views.0.objects.0.pixels", 3), "view", "objects.11.pixels"),
    ("visibility.json", _put("views.0.objects.0.parts.glow", 1), "view", "objects.11.parts.glow"),
    ("visibility.json", _put("views.0.objects.0", "-"), "view", "objects.11: nothing stored"),
    ("visibility.json", _put("views.0.objects.0.fraction", 1.5), "view", "fraction 1.5"),
    ("visibility.json", _put("views.1", "-"), "view", "not one entry a view"),
    ("visibility.json", _put("views.0.outdoors.42", 9), "view", "views[0].outdoors.42: 9 stored"),
    ("visibility.json", _put("anomalies.0.evidence_pixels.0", 9), "view", "evidence_pixels[0]"),
    ("visibility.json", _put("evidence_pixels_needed", 1), "view", "evidence_pixels_needed"),
    ("visibility.json", _put("all_visible", False), "view", "all_visible"),
    ("views/00/view.json", _put("index", 1), "view", "index: 1, expected 0"),
    # a camera is in the room where it stands, whatever it looks at
    ("views/00/view.json", _put("room_id", 101), "view", "room_id: 101 stored, 100 derived"),
    ("views/00/view.json", _put("room_id", 5), "view", "room_id: 5 stored, 100 derived"),
    ("views/00/view.json", _put("world_from_camera.1.3", -9.0), "view", "stands outdoors"),
    ("views/00/view.json", _put("width", 320), "view", "not that of the options"),
    ("views/00/view.json", _put("K.0.2", 80.0), "view", "K: not a pinhole"),
    ("views/00/view.json", _put("K", [[57, 0, 79.5], [0, 57, 59.5], [0, 0, 1]]), "view", "K: not"),
    ("views/00/view.json", _put("K.0.0", 1e4), "view", "K: not a pinhole"),
    ("views/00/view.json", _put("world_from_camera.0.0", 0.5), "view", "not a rotation"),
    (
        "views/00/view.json",
        _put("world_from_camera.1.3", -9.0),
        "view",
        "pixels lie off what the mask",
    ),
]


@pytest.mark.parametrize(("name", "edit", "check", "words"), EDITS)
def test_one_edit_is_found(copy: Path, name: str, edit: Edit, check: str, words: str) -> None:
    edit_json(copy / LAST / name, edit)
    assert any(p.check == "hash" and f"{LAST}/{name}" in p.text for p in validate(copy))
    reseal(copy)
    found = validate(copy)
    assert not [p for p in found if p.check == "hash"]
    hits = [p for p in found if p.check == check and words in p.text]
    assert hits, [str(p) for p in found]
    assert all(("000003" in p.text) for p in found), [str(p) for p in found]


def _relabel(mask: Any) -> None:
    mask[mask == 600] = 512


def _stranger(mask: Any) -> None:
    mask[0, 0] = 999


def _flat(depth: Any) -> None:
    depth[:] = 2000


def _deeper(depth: Any) -> None:
    depth[depth > 0] += 100


def _hole(depth: Any) -> None:
    depth[60, 60] = 0


@pytest.mark.parametrize(
    ("name", "edit", "words"),
    [
        ("instance.png", _relabel, "views[0].objects.512"),
        ("instance.png", _stranger, "id 999 is no node"),
        ("depth.png", _flat, "pixels lie off what the mask"),
        ("depth.png", _deeper, "pixels lie off what the mask"),
        ("depth.png", _hole, "do not cover the same pixels"),
    ],
)
def test_one_edited_picture_is_found(copy: Path, name: str, edit: Edit, words: str) -> None:
    edit_picture(copy / LAST / "views/00" / name, edit)
    reseal(copy)
    found = validate(copy)
    assert any(p.check == "view" and words in p.text for p in found), [str(p) for p in found]


def test_a_blank_colour_picture_is_found(copy: Path) -> None:
    Image.new("RGB", (160, 120), (9, 9, 9)).save(copy / LAST / "views/00/rgb.png")
    reseal(copy)
    assert any("one colour everywhere" in p.text for p in validate(copy))


def _broken_png(path: Path) -> None:
    (path / LAST / "views/00/rgb.png").write_bytes(b"\x89PNG broken")


def _missing_file(path: Path) -> None:
    (path / LAST / "graph.json").unlink()


def _extra_file(path: Path) -> None:
    (path / LAST / "views/77").mkdir()
    (path / LAST / "views/77/rgb.png").write_bytes(b"x")


def _missing_scene(path: Path) -> None:
    import shutil

    shutil.rmtree(path / LAST)


def _extra_scene(path: Path) -> None:
    (path / "scenes/000009").mkdir()


def _link(path: Path) -> None:
    (path / LAST / "graph.json").unlink()
    (path / LAST / "graph.json").symlink_to("/etc/hostname")


def _catalogue(path: Path) -> None:
    def edit(data: Any) -> None:
        hazard = next(h for h in data["hazards"] if h["id"] == "sharp_object")
        height = next(t for t in hazard["predicate"]["terms"] if t["kind"] == "height")
        height["max_m"] = 0.5

    edit_json(path / "catalogue.json", edit)


def _asset(path: Path) -> None:
    text = (path / "assets.jsonl").read_text(encoding="utf-8")
    (path / "assets.jsonl").write_text(text.replace('"z_m": 0.74', '"z_m": 0.6'), "utf-8")


def _no_asset(path: Path) -> None:
    lines = (path / "assets.jsonl").read_bytes().splitlines(keepends=True)
    (path / "assets.jsonl").write_bytes(b"".join(line for line in lines if b"knife" not in line))


def _count(path: Path) -> None:
    edit_json(path / "dataset.json", _put("counts.anomalies", 7))


def _split(path: Path) -> None:
    text = (path / "manifest.jsonl").read_text(encoding="utf-8")
    (path / "manifest.jsonl").write_text(text.replace('"train"', '"test"', 1), "utf-8")


def _manifest_count(path: Path) -> None:
    lines = (path / "manifest.jsonl").read_text(encoding="utf-8").splitlines()
    lines[3] = lines[3].replace('"stove_on": 1', '"stove_on": 2')
    (path / "manifest.jsonl").write_text("\n".join(lines) + "\n", "utf-8")


def _order(path: Path) -> None:
    lines = (path / "manifest.jsonl").read_bytes().splitlines(keepends=True)
    (path / "manifest.jsonl").write_bytes(b"".join(reversed(lines)))


def _readme(path: Path) -> None:
    (path / "README.md").unlink()


def _empty_readme(path: Path) -> None:
    (path / "README.md").write_text("\n")


@pytest.mark.parametrize(
    ("damage", "check", "words"),
    [
        (_empty_readme, "file", "README.md: empty"),
        (_broken_png, "hash", "rgb.png: changed"),
        (_broken_png, "view", "rgb.png: not a readable picture"),
        (_missing_file, "file", "graph.json: missing"),
        (_extra_file, "file", "views/77/rgb.png: the manifest does not list it"),
        (_missing_scene, "file", "scenes/000003: missing"),
        (_extra_scene, "file", "scenes/000009: the manifest does not list it"),
        (_link, "file", "graph.json: a symbolic link leads elsewhere"),
        (_catalogue, "hash", "catalogue.json: not the catalogue"),
        (_catalogue, "label", "object 600, sharp_object: listed and does not hold"),
        (_asset, "graph", "edges"),
        (_no_asset, "scene", "'knife_01' is not in assets.jsonl"),
        (_count, "count", "dataset.json: counts.anomalies: 7 stored, 6 derived"),
        (_split, "count", "split 'test', its home is 'train'"),
        (_manifest_count, "count", "scene 000003: anomalies, hazards or lookalikes"),
        (_order, "file", "not sorted by scene"),
        (_readme, "file", "README.md: missing"),
    ],
)
def test_damage_to_the_whole_is_found(
    copy: Path, damage: Callable[[Path], None], check: str, words: str
) -> None:
    damage(copy)
    found = validate(copy)
    assert any(p.check == check and words in p.text for p in found), [str(p) for p in found]


def test_files_of_one_s_own_are_no_problem(copy: Path) -> None:
    for name in ("notes.txt", ".DS_Store", "views/00/mine.png", "../.DS_Store", "../../notes.txt"):
        (copy / LAST / name).write_text("mine")
    assert validate(copy) == []


def test_no_data_set_at_all_is_one_problem(tmp_path: Path) -> None:
    (found,) = validate(tmp_path / "none")
    assert "no such folder" in found.text


def test_twins_are_sound_and_held_to_their_scenes(tmp_path: Path) -> None:
    path = toy.build_with_twins(tmp_path / "d", 4)
    assert validate(path) == []
    edit_json(path / "scenes/000003-twin/household.json", _put("members.2.age", 4))
    reseal(path)
    found = validate(path)
    assert [p.text for p in found] == [
        "manifest.jsonl: scenes/000003/household.json and scenes/000003-twin/household.json "
        "differ; a twin has its scene's"
    ]
    lines = (path / "manifest.jsonl").read_bytes().splitlines(keepends=True)
    (path / "manifest.jsonl").write_bytes(b"".join(line for line in lines if b"3-twin" not in line))
    assert any("000003: has no twin" in p.text for p in validate(path))


@pytest.fixture(scope="module")
def sound_twins(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return toy.build_with_twins(tmp_path_factory.mktemp("twins") / "d", 4)


@pytest.mark.parametrize(
    ("name", "edit", "words"),
    [
        (
            "scene.json",
            _object(512, "pose.position_m.0", 0.302),
            "object 512 (knife).pose.position_m[0]: 0.302 stored, 0.3 derived from 000003 with",
        ),
        ("scene.json", _object(512, "pose.quat_xyzw", [0, 0, 0, 1]), "512 (knife).pose.quat_xyzw"),
        ("scene.json", _object(305, "joints.door", 0.01), "object 305 (fridge).joints.door: 0.01"),
        ("scene.json", _object(65535, "fixed", True), "object 65535 (cushion).fixed: true stored"),
        ("scene.json", _put("agent_start.yaw_rad", 0.6), "agent_start.yaw_rad: 0.6 stored, 0.5"),
        ("physics.json", _put("settled_drift_m.512", 0.002), "settled_drift_m.512: 0.002 stored"),
        ("physics.json", _put("contacts", []), "physics.json: contacts: [] stored"),
        ("physics.json", _put("steps", 61), "physics.json: steps: 61 stored, 60 derived"),
        ("anomalies.json", _put("lookalikes", []), "anomalies.json: lookalikes: [] stored"),
    ],
)
def test_a_twin_is_its_scene_undone(
    sound_twins: Path, tmp_path: Path, name: str, edit: Edit, words: str
) -> None:
    import shutil

    path = Path(shutil.copytree(sound_twins, tmp_path / "d"))
    edit_json(path / LAST.replace("000003", "000003-twin") / name, edit)
    reseal(path)
    found = [p.text for p in validate(path) if p.check == "scene"]
    assert any(words in text for text in found), found
    assert all("000003-twin" in text for text in found), found


@pytest.mark.parametrize(
    ("edit", "words"),
    [
        (_put("undone", []), "undone: nothing of anomaly a00 of 000003"),
        (lambda a: a["undone"].reverse(), "undone: not sorted by anomaly_id"),
        (lambda a: a["undone"].pop(1), "undone: nothing of anomaly a01"),
        (_put("undone.0.object_id", 600), "undone[0]: no such anomaly of 000003"),
        (_put("undone.0.action", "put_out"), "action: 'put_out' is no remedy of stove_on"),
        (_put("undone.0.removed", True), "removed: true, object 11 is there"),
        (_put("undone.1.removed", False), "removed: false, object 600 is gone"),
        (_put("undone.2.target_id", 77), "target_id: 77 (kitchen_table) is no target of put_in"),
        (_put("undone.2.target_id", 999), "target_id: 999 (not there) is no target of put_in"),
        (_put("undone.2.target_id", None), "target_id: nothing, though the object was put"),
        (_put("undone.2.moved", False), "object 4000 (milk_carton).pose.position_m[0]: 0.5 stored"),
    ],
)
def test_a_twin_says_what_was_undone(
    sound_twins: Path, tmp_path: Path, edit: Edit, words: str
) -> None:
    import shutil

    path = Path(shutil.copytree(sound_twins, tmp_path / "d"))
    edit_json(path / "scenes/000003-twin/anomalies.json", edit)
    reseal(path)
    found = [p.text for p in validate(path) if p.check == "scene"]
    assert any(words in text for text in found), found
    assert all("000003-twin" in text for text in found), found


def test_what_was_put_somewhere_is_there(sound_twins: Path, tmp_path: Path) -> None:
    import shutil

    path = Path(shutil.copytree(sound_twins, tmp_path / "d"))
    edit_json(path / "scenes/000003-twin/scene.json", _object(4000, "pose.position_m.0", 2.5))
    reseal(path)
    found = [p.text for p in validate(path)]
    assert any("undone[2]: object 4000 is not INSIDE fridge 305" in text for text in found), found


@pytest.mark.parametrize(
    ("name", "value", "words"),
    [
        ("instance.png", 512, "1 pixels differ from those of 000003 and show nothing that was"),
        ("depth.png", 1234, "1 pixels of what is as in 000003 are not as deep: at 3, 2"),
    ],
)
def test_masks_of_a_twin_differ_where_something_was_changed(
    sound_twins: Path, tmp_path: Path, name: str, value: int, words: str
) -> None:
    import shutil

    path = Path(shutil.copytree(sound_twins, tmp_path / "d"))
    for view in (0, 1):
        where = path / f"scenes/000003-twin/views/0{view}/{name}"
        edit_picture(where, lambda pixels: pixels.__setitem__((2, 3), value))
    reseal(path)
    found = [p.text for p in validate(path)]
    assert any(words in text for text in found), found


def test_toggles_are_sound_and_held_to_their_scenes(tmp_path: Path) -> None:
    path = toy.build_with_twins(tmp_path / "d", 4, toggles=True)
    assert validate(path) == []
    toggle = path / "scenes/000003-undo-a01/anomalies.json"
    edit_json(toggle, _put("anomalies.0.id", "a07"))
    reseal(path)
    found = [p.text for p in validate(path)]
    assert any("undone: anomaly a07 of 000003-undo-a01 is none of 000003" in text for text in found)
    (path / "scenes/000002-undo-a00").rename(path / "scenes/000002-undo-a07")
    lines = (path / "manifest.jsonl").read_text().replace("2-undo-a00", "2-undo-a07")
    (path / "manifest.jsonl").write_text(lines)
    found = [p.text for p in validate(path)]
    assert (
        "manifest.jsonl: scene 000002: has no scene 000002-undo-a00, the options promise one"
        in (found)
    )
    assert any("000002-undo-a07: undoes none of the 2 anomalies of 000002" in t for t in found)


def test_a_twin_of_a_scene_that_is_not_sound_is_left_alone(
    sound_twins: Path, tmp_path: Path
) -> None:
    import shutil

    path = Path(shutil.copytree(sound_twins, tmp_path / "d"))
    edit_json(path / LAST / "scene.json", _object(512, "asset", "sword_01"))
    reseal(path)
    found = [p.text for p in validate(path)]
    assert found
    assert not any("000003-twin" in text for text in found), found
