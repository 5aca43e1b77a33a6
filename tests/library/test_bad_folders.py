"""Asset folders from strangers: every problem is one located line, and no file name leads out."""

import copy
import json
import os
import shutil
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import yaml
from sdgen.errors import AssetError
from sdgen.library import Library, load_library
from sdgen.library.glb import glb_document
from sdgen.library.meshes import read_glb
from sdgen.library.quantized import plain_glb
from sdgen.resources import data_path

Folder = dict[str, Any]


@cache
def _shipped() -> tuple[Folder, Folder]:
    """A model and a surface as the shipped manifest has them."""
    text = data_path("assets", "manifest.yaml").read_text(encoding="utf-8")
    start = text.index("- id: fridge_01\n")
    surfaces = yaml.safe_load(text[text.index("\nsurfaces:") :])["surfaces"]
    return yaml.safe_load(text[start : text.index("\n- id:", start)])[0], surfaces[0]


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A folder with one model of the shipped library under another name, and one surface."""
    model, surface = copy.deepcopy(_shipped())
    parts = [part["texture"] for part in model["parts"] if part.get("texture")]
    names = {model["mesh"], model["hulls"], model["texture"], surface["texture"], *parts}
    for name in names:
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(data_path("assets", name), tmp_path / name)
    model["id"], surface["id"] = "my_fridge", "my_surface"
    write(tmp_path, {"assets": [model], "surfaces": [surface]})
    return tmp_path


def write(folder: Path, data: Folder) -> None:
    (folder / "manifest.yaml").write_text(yaml.safe_dump(data), encoding="utf-8")


def problems(folder: Path) -> str:
    """What is wrong with a folder; on its own, for the shipped one takes seconds to read."""
    with pytest.raises(AssetError) as caught:
        Library([folder]).check_files(folder)
    return "\n".join(caught.value.problems)


def test_a_good_folder_adds_to_the_shipped_library(folder: Path) -> None:
    library = load_library([folder])
    assert {"my_fridge", "fridge_01"} <= set(library.assets)
    assert "my_surface" in library.surfaces


def _part(model: Folder, surface: Folder) -> None:
    model["parts"][0]["name"] = "../../../evil"


def _id(model: Folder, surface: Folder) -> None:
    model["id"] = "a/b"


def _texture(model: Folder, surface: Folder) -> None:
    model["texture"] = "../outside.png"


def _surface_texture(model: Folder, surface: Folder) -> None:
    surface["texture"] = "/etc/passwd"


def _mesh(model: Folder, surface: Folder) -> None:
    model["mesh"] = "meshes/none.glb"


def _state_on(model: Folder, surface: Folder) -> None:
    model["states"][0]["state"] = True


def _nan(model: Folder, surface: Folder) -> None:
    model["joints"][0]["lower"] = float("nan")


def _quoted(model: Folder, surface: Folder) -> None:
    model["mass_kg"] = "inf"


def _axis(model: Folder, surface: Folder) -> None:
    model["joints"][0]["axis"] = [0, 0, 0]


def _crossed(model: Folder, surface: Folder) -> None:
    model["supports"][0]["polygon_m"] = [[0, 0], [1, 1], [1, 0], [0, 1]]


def _key(model: Folder, surface: Folder) -> None:
    model["mas_kg"] = 3


def _variant(model: Folder, surface: Folder) -> None:
    model["variants"]["default"] = ["nope"]


def _crowded(model: Folder, surface: Folder) -> None:
    names = [f"p{k}" for k in range(np.iinfo(np.uint8).max + 1)]  # part.png has eight bits
    model["parts"] += [{"name": name, "faces": 1} for name in names]
    model["variants"] |= {"all": names, "most": names[1:]}


def _heavy(model: Folder, surface: Folder) -> None:
    model["mass_kg"] = 1000000


def _light(model: Folder, surface: Folder) -> None:
    model["mass_kg"] = 0.001


def _nowhere_up(model: Folder, surface: Folder) -> None:
    model["resting"] = [{"up": [0, 0, 0], "share": 1.0}]


def _reserved(model: Folder, surface: Folder) -> None:
    model["licence"] = "all rights reserved"


@pytest.mark.parametrize(
    ("edit", "words"),
    [
        (_heavy, "my_fridge: mass_kg: 1e+06 kg in"),
        (_light, "my_fridge: mass_kg: 0.001 kg in"),
        (_nowhere_up, "my_fridge: resting[0].up: [0.0, 0.0, 0.0] is not a direction"),
        (_reserved, "my_fridge: licence: 'all rights reserved' lets nobody pass a data set on"),
        (_part, "my_fridge: parts[0].name: string should match"),
        (_id, "a/b: id: string should match"),
        (_texture, "my_fridge: ../outside.png: leaves the asset folder"),
        (_surface_texture, "my_surface: /etc/passwd: leaves the asset folder"),
        (_mesh, "my_fridge: meshes/none.glb: no such file"),
        (_state_on, "my_fridge: states[0].state: expected text, got true"),
        (_nan, "my_fridge: joints[0].lower: expected a number, got text '.nan'"),
        (_quoted, "my_fridge: mass_kg: expected a number, got text 'inf'"),
        (_axis, "axis has no direction"),
        (_crossed, "polygon_m is no simple polygon"),
        (_key, "unknown key (did you mean 'mass_kg'?)"),
        (_variant, "variants.default[0]: no part 'nope'"),
        (_crowded, "variants.all: draws 256 parts; a variant draws at most 255"),
    ],
)
def test_bad_entries_are_located(
    folder: Path, edit: Callable[[Folder, Folder], None], words: str
) -> None:
    data = yaml.safe_load((folder / "manifest.yaml").read_text(encoding="utf-8"))
    edit(data["assets"][0], data["surfaces"][0])
    write(folder, data)
    told = problems(folder)
    assert words in told
    assert told.startswith(f"{folder / 'manifest.yaml'}:")


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("", ":1: is empty"),
        ("[1, 2]", ":1: expected a mapping"),
        ("assets: 3", ":1: assets: expected a list, got the number 3"),
        ("assets: []\nasets: []", ":2: asets: unknown key (did you mean 'assets'?)"),
        ("assets: []\nassets: []", ":2: assets: duplicate key"),
        ("assets: [3]", ":1: 0: "),
        ("assets: !!python/object:os.system []", ":1: assets: tags are not allowed"),
        ("assets: [", "not valid YAML"),
    ],
)
def test_bad_manifests_are_located(tmp_path: Path, text: str, words: str) -> None:
    (tmp_path / "manifest.yaml").write_text(text, encoding="utf-8")
    assert words in problems(tmp_path)


def test_all_problems_of_a_manifest_come_at_once(folder: Path) -> None:
    data = yaml.safe_load((folder / "manifest.yaml").read_text(encoding="utf-8"))
    _key(data["assets"][0], {})
    data["assets"].append({"id": "other"})
    data["surfaces"].append(data["surfaces"][0])
    write(folder, data)
    told = problems(folder)
    assert "did you mean 'mass_kg'" in told
    assert "other: missing key 'category': expected text" in told
    assert "my_surface: id: appears twice" in told


def _cut(path: Path) -> None:
    path.write_bytes(path.read_bytes()[: path.stat().st_size // 2])


def _scrambled(path: Path) -> None:
    raw = bytearray(path.read_bytes())
    raw[24:60] = bytes(range(200, 236))
    path.write_bytes(raw)


def _version(path: Path) -> None:
    raw = bytearray(path.read_bytes())
    raw[4] = 1
    path.write_bytes(raw)


def _flat(path: Path) -> None:
    data = json.loads(path.read_text())
    data["pieces"][0]["vertices_m"] = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]]
    path.write_text(json.dumps(data))


def _not_a_number(path: Path) -> None:
    data = json.loads(path.read_text())
    data["pieces"][0]["vertices_m"][0] = [float("nan"), 0, 0]
    path.write_text(json.dumps(data))


def _no_piece(path: Path) -> None:
    path.write_text('{"pieces": []}')


def _junk(path: Path) -> None:
    path.write_bytes(b"[" * 100_000)


def _no_list(path: Path) -> None:
    path.write_text("{}")


def _a_number(path: Path) -> None:
    path.write_text('{"pieces": [{"part": "body", "vertices_m": 7}]}')


def _header_only(path: Path) -> None:
    path.write_bytes(b"\x89PNG\r\n\x1a\nnothing")


@pytest.mark.parametrize(
    ("name", "damage", "words"),
    [
        ("meshes/fridge_01.glb", _cut, "mesh of my_fridge cannot be read: it is cut off"),
        ("meshes/fridge_01.glb", _junk, "mesh of my_fridge cannot be read: it is no GLB"),
        ("meshes/fridge_01.glb", _scrambled, "cannot be read: its JSON chunk is damaged"),
        ("meshes/fridge_01.glb", _version, "cannot be read: it is not of glTF version 2"),
        ("meshes/fridge_01.hulls.json", _cut, "hulls of my_fridge cannot be read: not JSON: "),
        ("meshes/fridge_01.hulls.json", _junk, "cannot be read: nested too deeply"),
        ("meshes/fridge_01.hulls.json", _no_list, "cannot be read: missing key 'pieces': expected"),
        ("meshes/fridge_01.hulls.json", _a_number, "pieces[0].vertices_m: expected a list, got"),
        ("meshes/fridge_01.hulls.json", _flat, "a piece is flat"),
        ("meshes/fridge_01.hulls.json", _not_a_number, "four points of three numbers"),
        ("meshes/fridge_01.hulls.json", _no_piece, "no piece"),
        ("textures/fridge_01.jpg", _cut, "no whole PNG or JPEG"),
        ("textures/fridge_01.jpg", _header_only, "no whole PNG or JPEG"),
        ("textures/fridge_01.jpg", _junk, "neither PNG nor JPEG"),
    ],
)
def test_broken_files_are_named(
    folder: Path, name: str, damage: Callable[[Path], None], words: str
) -> None:
    damage(folder / name)
    (told,) = problems(folder).splitlines()
    assert words in told
    assert told.startswith(f"{folder / name}: ")


def edit_glb(path: Path, edit: Callable[[Any], None]) -> None:
    """Change the JSON chunk of a GLB."""
    raw = path.read_bytes()
    size = int.from_bytes(raw[12:16], "little")
    document = json.loads(raw[20 : 20 + size])
    edit(document)
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    rest = raw[20 + size :]
    head = raw[:8] + (20 + len(text) + len(rest)).to_bytes(4, "little")
    path.write_bytes(head + len(text).to_bytes(4, "little") + raw[16:20] + text + rest)


@pytest.mark.parametrize(
    ("key", "value", "words"),
    [
        ("accessors.0.count", 10**9, "accessors[0]: reaches beyond its bufferView"),
        ("accessors.0.byteOffset", -4, "accessors[0].byteOffset: "),
        ("accessors.0.componentType", 1, "accessors[0].componentType: glTF has no 1"),
        ("accessors.0.sparse", {"count": 10**9}, "accessors[0]: sparse or compressed data"),
        ("buffers.0.uri", "file:///etc/passwd", "buffers[0].uri: another file"),
        ("meshes.0.primitives.0.indices", "a", "expected a whole number, got text 'a'"),
        ("meshes.0.primitives.0.mode", 1, "mode: 1 is not triangles"),
        ("meshes", 7, "meshes: expected a list, got the number 7"),
        ("nodes.0.children", [0], "nodes[0]: is a child of its own"),
        ("nodes.0.mesh", 99, "nodes[0].mesh: there is no 99"),
        ("nodes.0.name", [1], "nodes[0].name: expected text, got a list"),
        ("materials", 7, "not a valid GLB of triangles ("),
    ],
)
def test_a_mesh_that_contradicts_itself_is_told_in_plain_words(
    folder: Path, key: str, value: object, words: str
) -> None:
    def edit(document: Any) -> None:
        *way, last = (int(step) if step.isdecimal() else step for step in key.split("."))
        for step in way:
            document = document[step]
        document[last] = value

    edit_glb(folder / "meshes/fridge_01.glb", edit)
    (told,) = problems(folder).splitlines()
    assert ": mesh of my_fridge cannot be read: " in told
    assert words in told


def test_nodes_in_a_circle_are_told(folder: Path) -> None:
    def edit(document: Any) -> None:
        document["nodes"] += [{"children": [len(document["nodes"]) + 1]}]
        document["nodes"] += [{"children": [len(document["nodes"]) - 1]}]

    edit_glb(folder / "meshes/fridge_01.glb", edit)
    assert "is a child of its own" in problems(folder)


@pytest.mark.filterwarnings("error")
def test_a_scale_beyond_all_numbers_is_told_once(folder: Path) -> None:
    def edit(document: Any) -> None:
        document["nodes"][0]["scale"] = [1e308] * 3

    edit_glb(folder / "meshes/fridge_01.glb", edit)
    assert "is empty or not finite" in problems(folder)


def test_a_mesh_that_is_not_the_manifests_is_told(folder: Path) -> None:
    data = yaml.safe_load((folder / "manifest.yaml").read_text(encoding="utf-8"))
    data["assets"][0]["parts"][0]["faces"] = 10**9
    write(folder, data)
    assert "faces, the manifest says 1000000000" in problems(folder)


@pytest.mark.parametrize(
    ("turn", "words"),
    [
        (lambda x, y, z: [2 * x, 2 * y, 2 * z], "the mesh measures"),
        (lambda x, y, z: [x, z, y], "GLB files are read Y up"),
    ],
)
def test_extents_that_are_not_the_meshs_are_told(
    folder: Path, turn: Callable[[float, float, float], list[float]], words: str
) -> None:
    data = yaml.safe_load((folder / "manifest.yaml").read_text(encoding="utf-8"))
    model = data["assets"][0]
    model["extents_m"] = turn(*model["extents_m"])
    model["mass_kg"] = 60.0
    write(folder, data)
    told = problems(folder)
    assert words in told
    assert told.startswith(f"{folder / 'meshes/fridge_01.glb'}: my_fridge: ")


def test_a_mesh_without_normals_gets_them(folder: Path, caplog: pytest.LogCaptureFixture) -> None:
    path = folder / "meshes/fridge_01.glb"
    asset = Library([folder]).assets["my_fridge"]
    small = path.read_bytes()
    raw = bytearray(plain_glb(small, glb_document(small)))
    size = int.from_bytes(raw[12:16], "little")
    # Another name for the attribute, of the same length: the file has no normals then.
    raw[20 : 20 + size] = raw[20 : 20 + size].replace(b'"NORMAL"', b'"_NORMA"')
    path.write_bytes(raw)
    for name, mesh in read_glb(path, asset).items():
        assert np.allclose(np.linalg.norm(mesh.normals, axis=1), 1.0), name
    assert not caplog.records


def test_a_file_far_too_large_is_not_read(folder: Path) -> None:
    # Of nothing but holes: it takes no room on the disk.
    for name, size in (("textures/large.png", 301 * 10**6), ("meshes/fridge_01.glb", 201 * 10**6)):
        with (folder / name).open("wb") as file:
            file.write(b"\x89PNG")
            file.truncate(size)
    data = yaml.safe_load((folder / "manifest.yaml").read_text(encoding="utf-8"))
    data["assets"][0]["texture"] = "textures/large.png"
    write(folder, data)
    told = problems(folder)
    assert "textures/large.png: is larger than 300000 kB" in told
    assert "meshes/fridge_01.glb: is larger than 200000 kB" in told
    with pytest.raises(AssetError, match="is larger than"):
        _ = Library([folder]).sha256


def test_a_pipe_among_the_files_is_named(folder: Path) -> None:
    (folder / "textures/pipe.png").unlink(missing_ok=True)
    os.mkfifo(folder / "textures/pipe.png")
    data = yaml.safe_load((folder / "manifest.yaml").read_text(encoding="utf-8"))
    data["surfaces"][0]["texture"] = "textures/pipe.png"
    write(folder, data)
    assert "my_surface: textures/pipe.png: is a FIFO, not a file" in problems(folder)
    (folder / "manifest.yaml").unlink()
    os.mkfifo(folder / "manifest.yaml")
    assert "manifest.yaml: is a FIFO, not a file" in problems(folder)


def test_an_id_or_surface_of_the_shipped_library_is_told(folder: Path) -> None:
    data = yaml.safe_load((folder / "manifest.yaml").read_text(encoding="utf-8"))
    data["assets"][0]["id"] = "fridge_01"
    write(folder, data)
    with pytest.raises(AssetError, match="fridge_01: an asset folder before has this id"):
        load_library([folder])
