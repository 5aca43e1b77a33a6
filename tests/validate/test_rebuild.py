"""Scenes made again are compared to the last file, pictures included."""

import json
import shutil
from pathlib import Path
from types import SimpleNamespace

import pytest
from sdgen.cli.main import run
from sdgen.dataset import Dataset
from sdgen.dataset.versions import package_versions
from sdgen.library import load_library
from sdgen.validate import rebuild, validate
from sdgen.validate.rebuild import spread

from tests import toy
from tests.edits import edit_json, reseal
from tests.shared import Shared

Captured = pytest.CaptureFixture[str]


@pytest.fixture
def drawn(shared: Shared, tmp_path: Path) -> Path:
    """A scene of two small views and its twin, drawn by TinyRenderer."""

    def make(path: Path) -> None:
        options = "--n 1 --seed 7 --views 2 --size 64x48 --twins --renderer cpu --workers 1"
        assert run(["build", *options.split(), "--out", str(path)]) == 0

    return Path(shutil.copytree(shared.folder("drawn-by-tiny", make), tmp_path / "d"))


def _swap_views(scene: Path) -> None:
    """Views 0 and 1 change places in all that is written of them."""
    (scene / "views/00").rename(scene / "views/02")
    (scene / "views/01").rename(scene / "views/00")
    (scene / "views/02").rename(scene / "views/01")
    for k in (0, 1):
        edit_json(scene / f"views/0{k}/view.json", lambda data, k=k: data.update(index=k))

    def swap(data: dict[str, list[dict[str, object]]]) -> None:
        data["views"] = [{**view, "view": k} for k, view in enumerate(reversed(data["views"]))]
        for anomaly in data["anomalies"]:
            pixels = anomaly["evidence_pixels"]
            assert isinstance(pixels, list)
            anomaly["evidence_pixels"] = pixels[::-1]

    edit_json(scene / "visibility.json", swap)


@pytest.mark.slow
def test_swapped_views_are_found_when_the_scene_is_made_again(
    drawn: Path, capsys: Captured
) -> None:
    assert validate(drawn) == []
    again = rebuild(Dataset(drawn), load_library(), 1)
    assert again == ([], "", 1)
    for scene in (drawn / "scenes").iterdir():
        _swap_views(scene)
    reseal(drawn)
    assert validate(drawn) == []  # nothing in the files alone can tell
    capsys.readouterr()
    assert run(["validate", str(drawn), "--rebuild", "1", "--json"]) == 1
    told = json.loads(capsys.readouterr().out)
    assert (told["scenes"], told["made_again"], told["note"]) == (2, 1, "")
    assert {problem["check"] for problem in told["problems"]} == {"rebuild"}
    found = [problem["text"] for problem in told["problems"]]
    for name in ("000000", "000000-twin"):
        for file in ("rgb.png", "depth.png", "instance.png", "part.png", "view.json"):
            text = f"scenes/{name}/views/00/{file}: made again, it is another file"
            assert text in found, found


@pytest.mark.slow
def test_pictures_of_another_renderer_are_not_compared_and_it_says_so(
    drawn: Path, capsys: Captured
) -> None:
    edit_json(drawn / "dataset.json", lambda data: data.update(renderers=["Crayon 1.0"]))
    assert run(["validate", str(drawn), "--rebuild", "1"]) == 0
    told = capsys.readouterr()
    assert "1 made again, no problem found" in told.out
    assert "pictures not compared: drawn by Crayon 1.0, here is " in told.err


@pytest.mark.slow
def test_a_build_without_views_has_no_pictures_to_miss(tmp_path: Path, capsys: Captured) -> None:
    path = tmp_path / "d"
    options = "--n 1 --seed 7 --views 0 --workers 1"
    assert run(["build", *options.split(), "--out", str(path)]) == 0
    capsys.readouterr()
    assert run(["validate", str(path), "--rebuild", "1"]) == 0
    told = capsys.readouterr()
    assert "1 made again, no problem found" in told.out
    assert "pictures" not in told.err


def test_versions_that_decide_content_count_and_those_of_pictures_do_not(tmp_path: Path) -> None:
    versions = {**package_versions(), "deflate": "0.1", "pillow": "0.9", "numpy": "0.9"}
    with toy.open_writer(tmp_path, toy.small(n=1), versions=versions) as writer:
        toy.add_scene(writer, 0)
        writer.finish()
    data = Dataset(tmp_path)
    library = SimpleNamespace(sha256=data.info.assets_sha256, infos=toy.infos())
    ((problem,), note, made) = rebuild(data, library, 0)  # type: ignore[arg-type]
    assert "versions.numpy: 0.9 then" in str(problem)
    assert (note, made) == ("", 0)


def test_more_scenes_than_there_are_are_all_of_them() -> None:
    assert [len(spread(3, wanted)) for wanted in (0, 1, 2, 3, 4, 99)] == [0, 1, 2, 3, 3, 3]
    assert spread(3, 4) == [0, 1, 2]
    assert spread(10, 2) == [0, 5]
