"""Pieces of a data set, joined, are the bytes of the whole; what does not fit is refused."""

import json
import os
import shutil
from pathlib import Path
from typing import Any

import pytest
from sdgen.dataset import Dataset
from sdgen.dataset.merge import merge
from sdgen.dataset.scene_folder import BUILD_FOLDER
from sdgen.dataset.text import record_bytes
from sdgen.dataset.transfer import pack, unpack
from sdgen.errors import InputError, SdgenError, UsageError
from sdgen.rejection import Cause

from tests import toy


def tree(path: Path) -> dict[str, bytes]:
    """Every file below a folder by its relative name."""
    return {
        str(p.relative_to(path)): p.read_bytes() for p in sorted(path.rglob("*")) if p.is_file()
    }


def piece(path: Path, indices: range, n: int = 4, **options: Any) -> Path:
    """A finished data set of some scenes."""
    with toy.open_writer(path, toy.small(n=n, **options)) as writer:
        for index in indices:
            toy.add_scene(writer, index)
        writer.finish()
    return path


@pytest.fixture
def pieces(tmp_path: Path) -> list[Path]:
    return [piece(tmp_path / "a", range(2)), piece(tmp_path / "b", range(2, 4))]


@pytest.mark.parametrize("turn", [1, -1])
def test_the_whole_has_the_bytes_of_one_build(
    tmp_path: Path, pieces: list[Path], turn: int
) -> None:
    before = [tree(path) for path in pieces]
    seen: list[tuple[int, int]] = []
    merged = merge(pieces[::turn], tmp_path / "m", lambda *done: seen.append(done))
    assert merged.missing == ()
    assert tree(tmp_path / "m") == tree(toy.build(tmp_path / "whole"))
    assert seen == [(1, 4), (2, 4), (3, 4), (4, 4)]
    assert [tree(path) for path in pieces] == before


def test_pieces_of_another_n_are_of_the_same_build(tmp_path: Path) -> None:
    pieces = [piece(tmp_path / "a", range(2), n=2), piece(tmp_path / "b", range(2, 4))]
    merge(pieces, tmp_path / "m")
    assert tree(tmp_path / "m") == tree(toy.build(tmp_path / "whole"))


def test_equal_duplicates_are_fine_and_others_are_named(tmp_path: Path, pieces: list[Path]) -> None:
    twice = piece(tmp_path / "c", range(1, 3))
    merge([*pieces, twice], tmp_path / "m")
    assert tree(tmp_path / "m") == tree(toy.build(tmp_path / "whole"))
    manifest = (twice / "manifest.jsonl").read_text()
    digest = json.loads(manifest.splitlines()[0])["files"]["views/00/rgb.png"]
    (twice / "manifest.jsonl").write_text(manifest.replace(digest, "0" * 64))
    with pytest.raises(InputError) as caught:
        merge([*pieces, twice], tmp_path / "n")
    assert caught.value.problems == (
        f"{twice}: scene 000001 is not that of {pieces[0]}: views/00/rgb.png",
    )
    assert not (tmp_path / "n").exists()


def test_what_is_missing_or_could_not_be_made_is_said(tmp_path: Path) -> None:
    with toy.open_writer(tmp_path / "a", toy.small(n=9)) as writer:
        toy.add_scene(writer, 1)
        toy.add_scene(writer, 5)
        writer.finish(failed={"000002": {Cause("home", "no_free_floor"): 5}})
    merged = merge([tmp_path / "a"], tmp_path / "m")
    assert merged.missing == ((0, 1), (3, 5), (6, 9))
    assert list(merged.info.failed) == ["000002"]
    assert tree(tmp_path / "m") == tree(tmp_path / "a")


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"seed": 8}, "seed 8 (A has 7)"),
        ({"views": 3}, "views 3 (A has 2)"),
        ({"rgb": "jpg"}, "rgb jpg (A has png)"),
        ({"only": ("spill",)}, "only spill (A has none)"),
    ],
)
def test_pieces_of_other_builds_are_refused_and_nothing_is_written(
    tmp_path: Path, pieces: list[Path], options: dict[str, Any], words: str
) -> None:
    other = piece(tmp_path / "c", range(2, 3), **options)
    with pytest.raises(InputError) as caught:
        merge([*pieces, other], tmp_path / "m")
    (problem,) = caught.value.problems
    assert problem == f"{other}: of another build: {words.replace('A', str(pieces[0]))}"
    assert not (tmp_path / "m").exists()


def test_other_catalogues_assets_and_models_are_refused(tmp_path: Path, pieces: list[Path]) -> None:
    info = json.loads((pieces[1] / "dataset.json").read_text())
    catalog = toy.catalog()
    fewer = catalog.model_copy(update={"hazards": catalog.hazards[1:]})
    other = {"catalogue_sha256": fewer.sha256, "assets_sha256": "2" * 64}
    (pieces[1] / "dataset.json").write_text(json.dumps({**info, **other}))
    (pieces[1] / "catalogue.json").write_bytes(record_bytes(fewer))
    with pytest.raises(InputError, match="of another build: another catalogue; other assets"):
        merge(pieces, tmp_path / "m")
    (pieces[1] / "dataset.json").write_text(json.dumps(info))
    with pytest.raises(InputError) as caught:
        merge(pieces, tmp_path / "m")
    assert caught.value.problems == (
        f"{pieces[1]}: catalogue.json: not the catalogue whose digest dataset.json has",
    )
    (pieces[1] / "catalogue.json").write_bytes(record_bytes(catalog))
    lines = (pieces[1] / "assets.jsonl").read_text().splitlines()
    first = json.loads(lines[0])
    first["mass_kg"] = 77.5
    (pieces[1] / "assets.jsonl").write_text("\n".join([json.dumps(first), *lines[1:]]) + "\n")
    with pytest.raises(InputError, match=f"model {first['id']} is not that of"):
        merge(pieces, tmp_path / "m")
    assert not (tmp_path / "m").exists()


@pytest.mark.parametrize("other", [{"seed": 8}, {"n": 9}])
def test_a_data_set_of_something_else_is_no_destination(
    tmp_path: Path, pieces: list[Path], other: dict[str, Any]
) -> None:
    out = piece(tmp_path / "m", range(1), **other)
    before = tree(out)
    with pytest.raises(SdgenError, match=r"holds a data set .*; choose another --out$"):
        merge(pieces, out)
    assert {k: v for k, v in tree(out).items() if k in before} == before


def test_all_bad_pieces_are_named_with_their_folders(tmp_path: Path, pieces: list[Path]) -> None:
    (pieces[1] / "dataset.json").write_text("{")
    with pytest.raises(InputError) as caught:
        merge([pieces[0], pieces[1], tmp_path / "none"], tmp_path / "m")
    bad, none = caught.value.problems
    assert bad.startswith(f"{pieces[1]}: dataset.json")
    assert none == f"{tmp_path / 'none'}: no such folder"


@pytest.mark.parametrize("how", ["edit", "link", "missing", "pipe"])
def test_a_changed_file_is_located_and_mending_it_goes_on(
    tmp_path: Path, pieces: list[Path], how: str
) -> None:
    target = pieces[1] / "scenes/000003/graph.json"
    good = target.read_bytes()
    target.unlink()
    if how == "edit":
        target.write_bytes(good + b" ")
    elif how == "link":
        (tmp_path / "graph.json").write_bytes(good)
        target.symlink_to(tmp_path / "graph.json")
    elif how == "pipe":
        os.mkfifo(target)
    with pytest.raises(InputError) as caught:
        merge(pieces, tmp_path / "m")
    assert caught.value.problems[0].startswith(f"{target}: ")
    assert not (tmp_path / "m/dataset.json").exists()
    assert not list((tmp_path / "m" / BUILD_FOLDER).glob("*.partial"))
    target.unlink(missing_ok=True)
    target.write_bytes(good)
    merge(pieces, tmp_path / "m")
    assert tree(tmp_path / "m") == tree(toy.build(tmp_path / "whole"))


def test_the_destination_must_lie_apart(tmp_path: Path, pieces: list[Path]) -> None:
    for out in (pieces[0], pieces[0] / "scenes" / "x", tmp_path):
        with pytest.raises(UsageError, match="apart"):
            merge(pieces, out)
    with pytest.raises(UsageError, match="twice"):
        merge([pieces[0], pieces[0]], tmp_path / "m")
    assert sorted(path.name for path in tmp_path.iterdir()) == ["a", "b"]


def test_names_that_lead_out_of_a_piece_are_refused(tmp_path: Path, pieces: list[Path]) -> None:
    manifest = (pieces[1] / "manifest.jsonl").read_text()
    (pieces[1] / "manifest.jsonl").write_text(manifest.replace("graph.json", "../../x.json", 1))
    with pytest.raises(InputError, match="is no file that sdgen writes"):
        merge(pieces, tmp_path / "m")
    assert not (tmp_path / "m").exists()


@pytest.mark.parametrize(
    "keys", [{"versions": {}}, {"failed": {"9" * 5000: []}}, {"failed": {"no number": []}}]
)
def test_what_a_piece_says_of_itself_is_checked_before_anything_is_written(
    tmp_path: Path, pieces: list[Path], keys: dict[str, object]
) -> None:
    for path in pieces:
        data = json.loads((path / "dataset.json").read_text())
        (path / "dataset.json").write_text(json.dumps({**data, **keys}))
    with pytest.raises(InputError, match=f"dataset.json: {next(iter(keys))}"):
        merge(pieces, tmp_path / "m")
    assert not (tmp_path / "m").exists()


def test_twins_come_along(tmp_path: Path) -> None:
    whole = toy.build_with_twins(tmp_path / "whole", 2, toggles=True)
    pieces = []
    for index in range(2):
        path = tmp_path / str(index)
        shutil.copytree(whole, path)
        with toy.open_writer(path, toy.small(n=2, twins=True, toggles=True)) as writer:
            other = f"{1 - index:06d}"
            for name in [name for name in writer.done if name.startswith(other)]:
                shutil.rmtree(path / "scenes" / name)
                del writer.done[name]
            writer.finish()
        pieces.append(path)
    merge(pieces, tmp_path / "m")
    assert len(Dataset(tmp_path / "m", twins=True)) == 2
    assert len(Dataset(tmp_path / "m", toggles=True)) == 1
    assert tree(tmp_path / "m/scenes") == tree(whole / "scenes")
    assert (tmp_path / "m/manifest.jsonl").read_bytes() == (whole / "manifest.jsonl").read_bytes()


def test_a_scene_is_packed_and_unpacked_whole(tmp_path: Path) -> None:
    with (
        toy.open_writer(tmp_path / "a", toy.small(n=1)) as there,
        toy.open_writer(tmp_path / "b", toy.small(n=1)) as here,
    ):
        toy.add_scene(there, 0)
        packed = pack(there.root, "000000")
        assert list((there.root / "scenes").iterdir()) == []
        broken = {**packed.files, "graph.json": b"{}"}
        with pytest.raises(InputError, match=r"graph\.json: changed"):
            unpack(here.root, type(packed)(packed.done, broken))
        assert not (here.root / "scenes").exists()
        unpack(here.root, packed)
        here.finish()
    assert tree(tmp_path / "b") == tree(toy.build(tmp_path / "whole", toy.small(n=1)))
