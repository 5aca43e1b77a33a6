"""Asset folders from strangers: every problem is one located line, and no file name leads out."""

import json
import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
import yaml
from sdgen.errors import AssetError
from sdgen.library import load_library
from sdgen.resources import data_path

Folder = dict[str, Any]


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A folder with one model of the shipped library under another name, and one surface."""
    shipped = yaml.safe_load(data_path("assets", "manifest.yaml").read_text(encoding="utf-8"))
    model = next(entry for entry in shipped["assets"] if entry["id"] == "fridge_01")
    surface = shipped["surfaces"][0]
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
    with pytest.raises(AssetError) as caught:
        load_library([folder])
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


@pytest.mark.parametrize(
    ("edit", "words"),
    [
        (_part, "my_fridge: parts.0.name: String should match"),
        (_id, "a/b: id: String should match"),
        (_texture, "my_fridge: ../outside.png: leaves the asset folder"),
        (_surface_texture, "my_surface: /etc/passwd: leaves the asset folder"),
        (_mesh, "my_fridge: meshes/none.glb: no such file"),
        (_state_on, "my_fridge: states.0.state: Input should be a valid string"),
        (_nan, "my_fridge: joints.0.lower: Input should be a valid number"),
        (_quoted, "my_fridge: mass_kg: Input should be a valid number"),
        (_axis, "axis has no direction"),
        (_crossed, "polygon_m is no simple polygon"),
        (_key, "unknown key (did you mean 'mass_kg'?)"),
        (_variant, "variants.default: no part 'nope'"),
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
        ("assets: 3", ":1: assets: expected a list, found int"),
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
    assert "other: category: Field required" in told
    assert "my_surface: id: appears twice" in told


def _cut(path: Path) -> None:
    path.write_bytes(path.read_bytes()[: path.stat().st_size // 2])


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


def _header_only(path: Path) -> None:
    path.write_bytes(b"\x89PNG\r\n\x1a\nnothing")


@pytest.mark.parametrize(
    ("name", "damage", "words"),
    [
        ("meshes/fridge_01.glb", _cut, "mesh of my_fridge cannot be read"),
        ("meshes/fridge_01.glb", _junk, "mesh of my_fridge cannot be read"),
        ("meshes/fridge_01.hulls.json", _cut, "hulls of my_fridge cannot be read"),
        ("meshes/fridge_01.hulls.json", _junk, "hulls of my_fridge cannot be read"),
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


def test_a_mesh_that_is_not_the_manifests_is_told(folder: Path) -> None:
    data = yaml.safe_load((folder / "manifest.yaml").read_text(encoding="utf-8"))
    data["assets"][0]["parts"][0]["faces"] = 10**9
    write(folder, data)
    assert "faces, the manifest says 1000000000" in problems(folder)


def test_an_id_or_surface_of_the_shipped_library_is_told(folder: Path) -> None:
    data = yaml.safe_load((folder / "manifest.yaml").read_text(encoding="utf-8"))
    data["assets"][0]["id"] = "fridge_01"
    write(folder, data)
    assert "fridge_01: an asset folder before has this id" in problems(folder)
