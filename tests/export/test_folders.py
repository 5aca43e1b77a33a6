"""What all formats that write folders keep: whole or not at all, the same bytes, no bad place."""

import hashlib
from pathlib import Path

import pytest
from sdgen.dataset import Dataset
from sdgen.errors import InputError, SdgenError
from sdgen.export import FORMATS, export

from tests import toy

FOLDERS = [name for name, known in FORMATS.items() if known.output == "folder" and not known.models]
CLIENTS = {
    "huggingface": "datasets",
    "croissant": "datasets",
    "coco": "pycocotools",
    "rerun": "rerun",
}


@pytest.fixture(scope="module")
def path(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return toy.build_with_twins(tmp_path_factory.mktemp("toy") / "d", n=4)


def digests(folder: Path) -> dict[str, str]:
    files = (p for p in sorted(folder.rglob("*")) if p.is_file())
    return {
        p.relative_to(folder).as_posix(): hashlib.sha256(p.read_bytes()).hexdigest() for p in files
    }


@pytest.mark.parametrize("name", [name for name in FOLDERS if name != "rerun"])
def test_the_same_bytes_for_the_same_data_set(path: Path, tmp_path: Path, name: str) -> None:
    pytest.importorskip(CLIENTS.get(name, "sdgen"))
    export(Dataset(path), name, tmp_path / "one")
    export(Dataset(path), name, tmp_path / "two")
    assert digests(tmp_path / "one") == digests(tmp_path / "two") != {}


@pytest.mark.parametrize("name", FOLDERS)
def test_a_changed_file_leaves_nothing_behind(tmp_path: Path, name: str) -> None:
    pytest.importorskip(CLIENTS.get(name, "sdgen"))
    path = toy.build(tmp_path / "d", toy.small(n=2))
    folder = Dataset(path)[1].folder
    for name_of_file in ("graph.json", "views/00/rgb.png"):  # a picture, and what has none
        file = folder / name_of_file
        file.write_bytes(file.read_bytes() + b" ")
    with pytest.raises(InputError, match=r"(graph.json|rgb.png): changed since it was written"):
        export(Dataset(path), name, tmp_path / "out" / "x")
    assert list((tmp_path / "out").iterdir()) == []


@pytest.mark.parametrize("name", FOLDERS)
def test_a_scene_that_disagrees_with_itself_is_one_clear_error(tmp_path: Path, name: str) -> None:
    pytest.importorskip(CLIENTS.get(name, "sdgen"))
    path = toy.build(tmp_path / "d", toy.small(n=1))
    (path / "assets.jsonl").write_text("")
    with pytest.raises(InputError, match=r"scenes/000000/scene.json: object \d+: asset"):
        export(Dataset(path), name, tmp_path / "x")


@pytest.mark.parametrize("name", FOLDERS)
def test_progress_counts_every_scene(path: Path, tmp_path: Path, name: str) -> None:
    pytest.importorskip(CLIENTS.get(name, "sdgen"))
    told: list[tuple[int, int]] = []
    export(Dataset(path), name, tmp_path / "x", lambda done, total: told.append((done, total)))
    assert told == [(k, 8) for k in range(1, 9)]


def test_a_folder_with_something_in_it_is_not_written_over(path: Path, tmp_path: Path) -> None:
    (tmp_path / "x").mkdir()
    export(Dataset(path), "webdataset", tmp_path / "x")  # an empty one is
    with pytest.raises(SdgenError, match="is not empty; name a new folder"):
        export(Dataset(path), "webdataset", tmp_path / "x")
    (tmp_path / "f").write_text("mine")
    with pytest.raises(SdgenError, match="is in the way"):
        export(Dataset(path), "webdataset", tmp_path / "f")
    (tmp_path / "l").symlink_to(tmp_path / "elsewhere")
    with pytest.raises(SdgenError, match="is a symbolic link"):
        export(Dataset(path), "webdataset", tmp_path / "l")
    assert (tmp_path / "f").read_text() == "mine"


@pytest.mark.parametrize("place", ["scenes/x", "scenes/000000/x"])
def test_a_place_among_the_scenes_is_refused(path: Path, place: str) -> None:
    with pytest.raises(SdgenError, match="belongs to the data set"):
        export(Dataset(path), "webdataset", path / place)


@pytest.mark.parametrize(
    ("name", "words"), [("webdataset", "no pictures"), ("coco", "sensors rgb")]
)
def test_formats_of_pictures_say_that_there_are_none(tmp_path: Path, name: str, words: str) -> None:
    pytest.importorskip(CLIENTS.get(name, "sdgen"))
    path = toy.build(tmp_path / "d", toy.small(n=1, sensors=()))
    with pytest.raises(SdgenError, match=words):
        export(Dataset(path), name, tmp_path / "x")
