"""``sdgen assets retexture``: a further variant of a model, whole or not at all."""

from __future__ import annotations

import json
import stat
import sys
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner, Result
from hypothesis import given
from hypothesis import strategies as st
from PIL import Image
from sdgen.catalog.load import load_catalog
from sdgen.cli.assets import assets as command
from sdgen.cli.main import run as main
from sdgen.errors import AssetError, UsageError
from sdgen.importing import blender, shelf
from sdgen.importing.blender import BlenderError, find_blender
from sdgen.importing.manifest import entry_of, with_entry
from sdgen.importing.retexture import texture
from sdgen.importing.retexture.looks import WORN, kind_of, worn_word
from sdgen.importing.retexture.run import retexture
from sdgen.importing.retexture.texture import BakeError
from sdgen.importing.retexture.variants import glb_with_nodes, renamed, with_variant
from sdgen.library import Library, load_library
from sdgen.library.meshes import read_glb
from sdgen.library.records import Asset
from sdgen.library.states import derive_states, drawn_supports, state_parts
from sdgen.resources import data_path
from sdgen.validate.assets import check_assets
from sdgen.yaml_source import parse_yaml

from tests.importing.boxes import write_library
from tests.shipped import shipped_library

#: A Blender that paints: what is after "--" are its job and result.
PAINT = """
import sys
import numpy as np
job, result, look, kind, seed = sys.argv[sys.argv.index("--") + 1 :]
given = np.load(job)
before = given["texture"]
rng = np.random.default_rng(int(seed))
after = rng.integers(0, 120, before.shape, dtype=np.uint8)
covered = np.ones(before.shape[:2], bool)
with open({log!r}, "a") as file:
    print(look, kind, len(given["faces"]), file=file)
"""
SAVE = "np.savez(result, texture=after, covered=covered)\n"


@pytest.fixture
def library(tmp_path: Path) -> Path:
    return write_library(tmp_path / "mine")


@pytest.fixture
def fake(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[[str], Path]:
    """Puts a Blender of our own in the place of any other; returns its log."""

    def install(rest: str = SAVE) -> Path:
        log, program = tmp_path / "baked.txt", tmp_path / "blender"
        program.write_text(f"#!{sys.executable}\n{PAINT.format(log=str(log))}{rest}")
        program.chmod(program.stat().st_mode | stat.S_IXUSR)
        monkeypatch.setenv(blender.VARIABLE, str(program))
        return log

    return install


def snapshot(folder: Path) -> dict[str, bytes]:
    return {
        str(path.relative_to(folder)): path.read_bytes()
        for path in folder.rglob("*")
        if path.is_file()
    }


def call(*words: str) -> Result:
    return CliRunner().invoke(command, ["retexture", *words], catch_exceptions=False)


# ---- what comes of it
def test_a_model_gets_a_variant_that_is_the_state(library: Path, fake: Callable[..., Path]) -> None:
    log = fake()
    before = Library([library])
    done = retexture("mug_a", "dirty", [library])
    assert (done.asset_id, done.state, done.variant) == ("mug_a", "DIRTY", "dirty")
    assert log.read_text().split() == ["dirty", "ware", "12"]
    after = load_library([library])  # every file is read
    asset = after.info("mug_a")
    assert derive_states(asset, "dirty", {}) == ("DIRTY",)
    assert derive_states(asset, "default", {}) == ()
    assert state_parts(asset, "DIRTY", "dirty", {}) == ("body_dirty",)
    meshes = after.mesh("mug_a")
    for name in ("vertices", "normals", "uvs", "faces"):
        assert np.array_equal(getattr(meshes["body"], name), getattr(meshes["body_dirty"], name))
    part = after.assets["mug_a"].part("body_dirty")
    with Image.open(library / str(part.texture)) as image:
        assert image.size == (256, 256)  # the old one has 64: too few for spots
        assert np.asarray(image).mean() < 80  # what the fake painted
    assert after.assets["mug_a"].part("body").texture is None
    assert before.assets["cupboard"] == after.assets["cupboard"]
    # Nothing lies about: each file is named by a record.
    named = {"manifest.yaml"}
    for one in after.assets.values():
        if after.folder_of(one.id) == library:
            named |= {
                one.mesh,
                one.hulls,
                one.texture,
                *(p.texture for p in one.parts if p.texture),
            }
    assert set(snapshot(library)) == named
    assert (library / "manifest.yaml").read_text().startswith("# my things\n# for tests\n")


def test_all_that_names_a_part_names_its_new_texture_too(
    library: Path, fake: Callable[..., Path]
) -> None:
    log = fake()
    done = retexture("cupboard", "dusty", [library])
    assert "no hazard of the shipped catalogue asks for DUSTY" in done.notes[0]
    # A bake for each texture there was; what glows keeps its own.
    assert len(log.read_text().splitlines()) == 2
    after = load_library([library])
    asset = after.info("cupboard")
    assert asset.variants["dusty"] == ("body_dusty", "door_dusty", "lamp")
    textures = [after.assets["cupboard"].part(n).texture for n in ("body_dusty", "door_dusty")]
    assert textures == ["textures/cupboard_dusty.jpg", "textures/cupboard_dusty_2.jpg"]
    assert asset.part("door_dusty").joint == "door"
    assert derive_states(asset, "dusty", {}) == ("CLOSED", "DUSTY", "EMPTY")
    assert derive_states(asset, "dusty", {"door": 1.0}) == ("DUSTY", "EMPTY", "OPEN")
    assert state_parts(asset, "CLOSED", "dusty", {}) == ("door_dusty",)
    assert state_parts(asset, "CLOSED", "default", {}) == ("door",)
    ((support, _),) = drawn_supports(asset, "dusty", {})
    assert (support.name, support.container) == ("shelf_dusty", "inside_dusty")
    assert asset.containers[1].closed_by == "door"
    parts = {hull.part for hull in after.hulls("cupboard")}
    assert parts == {"body", "door", "lamp", "body_dusty", "door_dusty"}


def test_a_second_state_joins_the_first(library: Path, fake: Callable[..., Path]) -> None:
    fake()
    retexture("mug_a", "dirty", [library])
    retexture("mug_a", "wet", [library])
    asset = load_library([library]).assets["mug_a"]
    assert asset.state_names == ("DIRTY", "WET")
    assert list(asset.variants) == ["default", "dirty", "wet"]
    assert sorted(path.name for path in (library / "meshes").glob("mug_a*")) == [
        "mug_a.glb",
        "mug_a_wet.hulls.json",
    ]


def test_what_is_there_stays_until_it_is_to_be_overwritten(
    library: Path, fake: Callable[..., Path]
) -> None:
    log = fake()
    retexture("mug_a", "dirty", [library])
    first = snapshot(library)
    again = retexture("mug_a", "stained", [library], seed=5)  # another word for it
    assert again.files == ()
    assert snapshot(library) == first
    retexture("mug_a", "dirty", [library], overwrite=True)
    assert snapshot(library) == first  # the same seed
    done = retexture("mug_a", "dirty", [library], seed=5, overwrite=True)
    assert done.files == ("textures/mug_a_dirty.jpg",)
    changed = {name for name, data in snapshot(library).items() if data != first[name]}
    assert changed == set(done.files)
    assert len(log.read_text().splitlines()) == 3


def test_a_shipped_model_is_copied_and_mixes_with_the_rest(
    tmp_path: Path, fake: Callable[..., Path]
) -> None:
    fake()
    out = tmp_path / "new" / "folder"
    done = retexture("apple_01", "wet", out=out)
    assert (done.asset_id, done.folder) == ("apple_01_copy", out)
    retexture("apple_01", "dusty", out=out)  # the copy that is there already
    retexture("apple_02", "wet", out=out)
    mixed = load_library([out])
    copy, original = mixed.assets["apple_01_copy"], mixed.assets["apple_01"]
    assert set(copy.state_names) == {"EXPIRED", "OVERRIPE", "WET", "DUSTY"}
    assert (copy.category, copy.licence, copy.source) == (
        original.category,
        original.licence,
        original.source,
    )
    assert {a.id for a in mixed.assets.values() if mixed.folder_of(a.id) == out} == {
        "apple_01_copy",
        "apple_02_copy",
    }
    assert check_assets([out], load_catalog()) == []


def test_the_next_import_keeps_the_variant(library: Path, fake: Callable[..., Path]) -> None:
    fake()
    origin = shelf.Origin(
        source="folder",
        name="mug",
        kind="mesh",
        entry="mug.obj",
        root="",
        digest="0",
        how="table",
        why="",
        placed=True,
        asset=Library([library]).assets["mug_a"],
    )
    shelf.put(library, origin, {})
    retexture("mug_a", "dirty", [library])
    retexture("mug_01", "wet", out=library)
    shelf.write_manifest(library, list(shelf.origins(library).values()))
    after = load_library([library]).assets
    assert after["mug_a"].state_names == ("DIRTY",)
    # Models that were never imported stay, too.
    assert "WET" in after["mug_01_copy"].state_names
    assert "cupboard" in after


# ---- what is refused
@pytest.mark.parametrize(
    ("rest", "said"),
    [
        ("print('first'); print('no memory left'); sys.exit(3)", "no memory left"),
        ("raise RuntimeError('bake failed')", "bake failed"),
        ("import os, signal; os.kill(os.getpid(), signal.SIGKILL)", "ended by signal 9"),
        ("", "without a texture"),
        ("open(result, 'w').write('nonsense')", "without a texture"),
        ("np.savez(result, texture=after)", "without a texture"),
        ("after = after[:8]; " + SAVE, r"baked \(8, 256, 3\), not \(256, 256, 3\)"),
        ("after[:] = 0; " + SAVE, "blank: 1 colours"),
        ("after = before; " + SAVE, "changes nothing that one sees"),
        ("covered[:] = False; " + SAVE, "its UVs are no surface"),
    ],
)
def test_a_bake_that_fails_changes_nothing(
    library: Path, fake: Callable[..., Path], rest: str, said: str
) -> None:
    fake(rest)
    before = snapshot(library)
    with pytest.raises((BlenderError, BakeError), match=said):
        retexture("mug_a", "dirty", [library])
    assert snapshot(library) == before
    with pytest.raises((BlenderError, BakeError), match=said):
        retexture("mug_01", "wet", out=library.parent / "out")
    assert not (library.parent / "out").exists()


def test_only_the_end_of_what_blender_says_is_told(
    library: Path, fake: Callable[..., Path]
) -> None:
    fake("print('x' * 1000000)\nfor k in range(50): print(f'line {k}')\nsys.exit(1)")
    with pytest.raises(BlenderError) as caught:
        retexture("mug_a", "dirty", [library])
    lines = str(caught.value).splitlines()
    assert lines[-1].strip() == "line 49"
    assert len(lines) < 20


def test_a_disk_that_is_full_leaves_nothing_behind(
    library: Path, fake: Callable[..., Path], monkeypatch: pytest.MonkeyPatch
) -> None:
    fake()
    before = snapshot(library)
    write = run_module().write_output

    def full(path: Path, data: bytes) -> None:
        if path.suffix == ".json":
            raise OSError(28, "No space left on device", str(path))
        write(path, data)

    monkeypatch.setattr(run_module(), "write_output", full)
    with pytest.raises(OSError, match="No space"):
        retexture("mug_a", "dirty", [library])
    after = snapshot(library)
    # The mesh has a node more, which nobody asks for.
    assert set(after) == set(before)
    assert {name for name in before if after[name] != before[name]} <= {"meshes/mug_a.glb"}
    load_library([library])
    monkeypatch.undo()
    fake()
    retexture("mug_a", "dirty", [library])
    assert load_library([library]).assets["mug_a"].state_names == ("DIRTY",)


def run_module() -> object:
    return sys.modules["sdgen.importing.retexture.run"]


def test_files_of_other_models_are_never_written_over(
    library: Path, fake: Callable[..., Path]
) -> None:
    fake()
    text = (library / "manifest.yaml").read_text()
    (library / "textures/mug_a_dirty.jpg").write_bytes(
        (library / "textures/cupboard.jpg").read_bytes()
    )
    text = text.replace("textures/cupboard.jpg", "textures/mug_a_dirty.jpg")
    (library / "manifest.yaml").write_text(text)
    before = snapshot(library)
    with pytest.raises(AssetError, match=r"mug_a_dirty\.jpg: cupboard has it already"):
        retexture("mug_a", "dirty", [library])
    assert snapshot(library) == before


def test_one_command_at_a_time(library: Path, fake: Callable[..., Path]) -> None:
    fake()
    with shelf.held(library), pytest.raises(AssetError, match="another"):
        retexture("mug_a", "dirty", [library])
    assert retexture("mug_a", "dirty", [library]).files
    assert {path.name for path in library.iterdir()} == {"manifest.yaml", "meshes", "textures"}


@pytest.mark.parametrize(
    ("word", "said"),
    [
        ("dirt", "did you mean 'dirty'"),
        ("broken", "is another shape"),
        ("OPEN", "is another shape"),
        ("", "no look ''"),
        ("x" * 5000, "no look"),
    ],
)
def test_a_word_for_no_look(word: str, said: str) -> None:
    with pytest.raises(UsageError, match=said) as caught:
        worn_word(word)
    assert len(str(caught.value)) < 300


def test_models_and_folders_that_make_no_sense(
    library: Path, tmp_path: Path, fake: Callable[..., Path], capsys: pytest.CaptureFixture[str]
) -> None:
    log = fake()
    file = tmp_path / "file"
    file.write_text("")
    link = tmp_path / "link"
    link.symlink_to(data_path("assets"))
    for words, said in (
        (["mug_b", "--as", "dirty", "--assets", str(library)], "did you mean 'mug_a'"),
        (["apple_01", "--as", "wet"], "a shipped model"),
        (["apple_01", "--as", "wet", "--out", str(link)], "never changed"),
        (["apple_01", "--as", "wet", "--out", str(file)], "is no folder"),
        (["apple_01", "--as", "wet", "--assets", str(data_path("assets"))], "a shipped model"),
        (["mug_a", "--as", "dirty", "--assets", str(tmp_path / "nowhere")], "does not exist"),
        (["mug_a", "--as", "cut", "--assets", str(library)], "another shape"),
    ):
        assert main(["assets", "retexture", *words]) == 2
        assert said in capsys.readouterr().err
    assert not log.exists()


def test_a_state_that_the_model_came_with_stays(tmp_path: Path, fake: Callable[..., Path]) -> None:
    fake()
    out = tmp_path / "out"
    done = retexture("apple_01", "expired", out=out)
    assert (done.asset_id, done.files) == ("apple_01", ())
    with pytest.raises(UsageError, match="no work of retexturing"):
        retexture("apple_01", "expired", out=out, overwrite=True)
    assert not out.exists()


def test_a_broken_model_is_told_and_left(library: Path, fake: Callable[..., Path]) -> None:
    fake()
    mesh = library / "meshes/mug_a.glb"
    whole = mesh.read_bytes()
    mesh.write_bytes(whole[: len(whole) // 2])
    with pytest.raises(AssetError, match=r"mug_a\.glb.*cut off"):
        retexture("mug_a", "dirty", [library])
    mesh.write_bytes(whole)
    (library / "textures/mug_a.jpg").write_bytes(b"\xff\xd8 nothing")
    with pytest.raises(AssetError, match="no whole PNG or JPEG"):
        retexture("mug_a", "dirty", [library])


# ---- the command
def test_the_command_says_what_it_did(library: Path, fake: Callable[..., Path]) -> None:
    fake()
    words = ["mug_a", "--as", "expired", "--assets", str(library)]
    first = call(*words)
    assert first.exit_code == 0
    assert "mug_a: EXPIRED is its variant 'expired', baked by" in first.output
    assert str(library / "textures/mug_a_expired.jpg") in first.output
    assert "a mug is no food: nobody expects it to be EXPIRED" in first.output
    assert "already; nothing was changed" in call(*words).output


def test_help_names_the_looks() -> None:
    shown = call("--help").output
    assert "|".join(WORN) in shown
    assert "Example: sdgen assets retexture" in shown


# ---- which Blender
def test_without_blender_it_says_what_to_install(
    library: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.delenv(blender.VARIABLE, raising=False)
    monkeypatch.setenv("PATH", str(library))
    find = blender.find_spec
    monkeypatch.setattr(blender, "find_spec", lambda name: None if name == "bpy" else find(name))
    assert main(["assets", "retexture", "mug_a", "--as", "dirty", "--assets", str(library)]) == 1
    said = capsys.readouterr().err
    assert "apt install blender" in said
    assert "bpy" in said
    assert "Traceback" not in said
    for python, words in (((3, 11), "bpy>=4.2,<5.1"), ((3, 13), "bpy>=5.1"), ((3, 12), "no rel")):
        assert words in blender._missing(python)


def test_the_blender_that_is_named_comes_first(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in ("blender", "other"):
        (tmp_path / name).write_text("#!/bin/sh\n")
        (tmp_path / name).chmod(0o755)
    monkeypatch.setenv("PATH", str(tmp_path))
    find = blender.find_spec
    monkeypatch.setattr(blender, "find_spec", lambda name: None if name == "bpy" else find(name))
    monkeypatch.delenv(blender.VARIABLE, raising=False)
    assert find_blender().command[0] == str(tmp_path / "blender")
    monkeypatch.setattr(blender, "find_spec", lambda name: object())
    assert find_blender().command == (sys.executable,)
    monkeypatch.setenv(blender.VARIABLE, str(tmp_path / "other"))
    assert find_blender().command[0] == str(tmp_path / "other")
    monkeypatch.setenv(blender.VARIABLE, str(tmp_path / "none"))
    with pytest.raises(BlenderError, match="no such program"):
        find_blender()


# ---- its pieces
def test_states_are_those_of_the_catalogue() -> None:
    text = "\n".join(path.read_text() for path in data_path("hazard_catalog").rglob("*.yaml"))
    for worn in WORN.values():
        assert worn.asked_for is (f"state: {worn.state}" in text), worn


def test_kinds_follow_from_names() -> None:
    kinds = {c.name: kind_of(c.name, c.superclass == "Food") for c in load_catalog().categories}
    for kind, names in {
        "produce": ("apple", "banana", "bell_pepper", "lettuce", "pumpkin"),
        "bread": ("bread", "croissant", "cake", "cheese", "frozen_pizza"),
        "meat": ("raw_meat", "sliced_ham", "fish_fillet", "sausage_pack"),
        "ware": ("plate", "mug", "wine_glass", "frying_pan", "cutting_board", "stove"),
        "thing": ("milk_carton", "jam_jar", "yogurt_cup", "sofa", "teddy_bear", "laptop"),
    }.items():
        assert {kinds[name] for name in names} == {kind}


@given(st.integers(0, 2**32 - 1), st.integers(1, 40), st.integers(1, 40))
def test_gutters_take_the_colours_beside_them(seed: int, height: int, width: int) -> None:
    rng = np.random.default_rng(seed)
    pixels = rng.integers(0, 256, (height, width, 3), dtype=np.uint8)
    covered = rng.random((height, width)) < 0.3
    covered[rng.integers(height), rng.integers(width)] = True
    filled = texture._fill(pixels, covered)
    assert np.array_equal(filled[covered], pixels[covered])
    low, high = pixels[covered].min(axis=0), pixels[covered].max(axis=0)
    assert (filled >= low).all()
    assert (filled <= high).all()


@pytest.mark.parametrize("asset_id", ["apple_01", "fridge_01", "mug_01", "laptop_01"])
def test_nodes_show_the_same_mesh_again(asset_id: str) -> None:
    # Ours are quantized; the nodes' meshes are read as those of the parts are.
    library = shipped_library()
    asset = library.assets[asset_id]
    names = renamed(asset, "dirty")
    raw = library.file(asset_id, asset.mesh).read_bytes()
    more = glb_with_nodes(raw, names)
    assert glb_with_nodes(more, names) == more
    after = with_variant(asset, "dirty2", "DIRTY", dict.fromkeys(names, asset.texture))
    meshes = read_glb(Path("x.glb"), after, glb_with_nodes(more, renamed(asset, "dirty2")))
    for old, new in renamed(asset, "dirty2").items():
        assert np.array_equal(meshes[old].vertices, meshes[new].vertices)
        assert np.array_equal(meshes[old].uvs, meshes[new].uvs)
    with pytest.raises(ValueError, match="no node 'nose'"):
        glb_with_nodes(raw, {"nose": "nose_dirty"})
    other = {next(iter(names)): "taken"}
    if len(names) > 1:
        taken = glb_with_nodes(raw, {list(names)[1]: "taken"})
        with pytest.raises(ValueError, match="shows another mesh"):
            glb_with_nodes(taken, other)


@given(st.text(max_size=30), st.sampled_from(["on", "12", "1e3", "null", "~", "a: b", "# c", "é"]))
def test_a_manifest_that_is_written_says_the_same(free: str, word: str) -> None:
    asset = shipped_library().assets["fridge_01"]
    title = "".join(c for c in free if c.isprintable()) + word
    renamed_one = asset.model_copy(update={"title": title, "id": "mine"})
    raw = with_entry(with_entry(None, "x", renamed_one), "x", asset)
    source = parse_yaml(raw, "x")
    assert source.problems == []
    read = [Asset.model_validate_json(json.dumps(entry)) for entry in source.value["assets"]]
    assert read == [renamed_one, asset]
    assert with_entry(raw, "x", asset) == raw
    assert set(entry_of(asset)) <= set(Asset.model_fields)


# ---- the real thing
def _blender() -> str | None:
    try:
        return find_blender().name
    except BlenderError:
        return None


needs_blender = pytest.mark.skipif(
    _blender() is None, reason="no Blender: neither bpy nor blender is installed here"
)


@needs_blender
@pytest.mark.parametrize("word", sorted(WORN))
def test_blender_bakes_each_look(library: Path, word: str) -> None:
    retexture("mug_a", word, [library], seed=3)
    asset = load_library([library]).assets["mug_a"]
    name = str(asset.part(f"body_{word}").texture)
    with Image.open(library / name) as image, Image.open(library / asset.texture) as old:
        after = np.asarray(image).astype(float)
        before = np.asarray(old.resize(image.size)).astype(float)
    assert np.abs(after - before).mean() > texture.LEAST_CHANGE
    assert after.std(axis=(0, 1)).min() > 4  # patches, not one colour
    first = (library / name).read_bytes()
    retexture("mug_a", word, [library], seed=3, overwrite=True)
    assert (library / name).read_bytes() == first
    retexture("mug_a", word, [library], seed=4, overwrite=True)
    assert (library / name).read_bytes() != first


@needs_blender
def test_dust_lies_on_what_looks_up(library: Path) -> None:
    retexture("mug_a", "dusty", [library])
    with Image.open(library / "textures/mug_a_dusty.jpg") as image:
        pixels = np.asarray(image).astype(float)
    # Sides of the box lie three by two: -x -y -z below, +x +y +z above (v runs upwards).
    height, width = pixels.shape[:2]
    inner = slice(height // 16, height * 7 // 16), slice(width * 17 // 24, width * 23 // 24)
    top = pixels[inner]
    bottom = pixels[height // 2 :][inner]
    colourful = [np.ptp(side.mean(axis=(0, 1))) for side in (top, bottom)]
    assert colourful[0] < 0.6 * colourful[1]  # grey over warm colours


@needs_blender
def test_a_texture_that_repeats_is_baked_whole(library: Path) -> None:
    # The door's UVs reach from 0 to 2.
    retexture("cupboard", "dirty", [library])
    with Image.open(library / "textures/cupboard_dirty_2.jpg") as image:
        pixels = np.asarray(image).astype(int)
    assert len(np.unique(pixels.reshape(-1, 3), axis=0)) > 1000


@needs_blender
def test_the_scripts_of_ours_get_no_litter(library: Path) -> None:
    scripts = data_path("assets", "blender")
    before = set(scripts.rglob("*"))
    assert scripts / "retexture.py" in before
    retexture("mug_a", "wet", [library])
    assert set(scripts.rglob("*")) == before
