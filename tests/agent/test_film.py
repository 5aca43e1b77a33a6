"""An episode as a folder: read back as it was, the same bytes each time, whole or not at all."""

from __future__ import annotations

import dataclasses
import json
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from sdgen.agent.film import folder
from sdgen.agent.film.folder import read_folder, write_folder
from sdgen.agent.film.steps import Film, Step
from sdgen.errors import InputError, SdgenError
from sdgen.scene import Camera

from tests.agent import film


def same(a: Film, b: Film) -> None:
    """Asserts that two episodes are one, to the last pixel."""
    assert (a.scene, a.household, a.options) == (b.scene, b.household, b.options)
    assert dict(a.summary) == dict(b.summary)
    assert len(a.steps) == len(b.steps)
    for one, other in zip(a.steps, b.steps, strict=True):
        for field in dataclasses.fields(Step):
            mine, theirs = getattr(one, field.name), getattr(other, field.name)
            if isinstance(mine, np.ndarray):
                assert mine.dtype == theirs.dtype
                np.testing.assert_array_equal(mine, theirs)
            else:
                assert mine == theirs, field.name


@pytest.mark.parametrize("video", ["gif", "none"])
def test_a_folder_is_read_as_it_was_written(tmp_path: Path, video: folder.Video) -> None:
    episode = film.episode()
    write_folder(episode, tmp_path / "walk", video)
    same(episode, read_folder(tmp_path / "walk"))
    assert (tmp_path / "walk" / "video.gif").exists() == (video == "gif")


def test_the_same_episode_is_the_same_bytes(tmp_path: Path) -> None:
    for name in ("a", "b"):
        write_folder(film.episode(), tmp_path / name)
    files = [
        {
            path.relative_to(tmp_path / name): path.read_bytes()
            for path in (tmp_path / name).rglob("*")
            if path.is_file()
        }
        for name in ("a", "b")
    ]
    assert files[0] == files[1]
    assert len(files[0]) == 3 + 3 * 8


def test_a_line_says_where_and_through_what_the_agent_looked(tmp_path: Path) -> None:
    episode = film.episode()
    write_folder(episode, tmp_path / "walk", "none")
    lines = [
        json.loads(line) for line in (tmp_path / "walk/trajectory.jsonl").read_text().splitlines()
    ]
    assert [line["action"] for line in lines][:3] == ["start", "forward", "turn_left"]
    assert lines[1]["refused"] == "a chair is in the way"
    for line, step in zip(lines, episode.steps, strict=True):
        assert line["position_m"] == [step.gaze.x_m, step.gaze.y_m, 0.0]
        assert Camera(**line["camera"]) == step.camera
        eye = [row[3] for row in line["camera"]["world_from_camera"]][:3]
        assert eye == pytest.approx([*step.gaze.point, episode.options.camera.height_m])
        for name in line["files"].values():
            assert (tmp_path / "walk" / name).is_file()


def test_an_agent_without_colours_is_stored_but_not_filmed(tmp_path: Path) -> None:
    episode = film.episode(rgb=False)
    with pytest.raises(SdgenError, match="no colours to film"):
        write_folder(episode, tmp_path / "walk")
    assert list(tmp_path.iterdir()) == []
    write_folder(episode, tmp_path / "walk", "none")
    same(episode, read_folder(tmp_path / "walk"))


def test_nothing_is_written_over_or_left_half_done(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "full").mkdir()
    (tmp_path / "full/mine.txt").write_text("mine")
    with pytest.raises(SdgenError, match="is not empty"):
        write_folder(film.episode(), tmp_path / "full")
    with pytest.raises(SdgenError, match="in the way"):
        write_folder(film.episode(), tmp_path / "full/mine.txt")
    assert (tmp_path / "full/mine.txt").read_text() == "mine"

    def full(*_: object) -> bytes:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(folder, "gray_bytes", full)
    with pytest.raises(OSError, match="No space left"):
        write_folder(film.episode(), tmp_path / "walk")
    assert [path.name for path in tmp_path.iterdir()] == ["full"]


def test_a_missing_package_is_named_and_leaves_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from sdgen.cli.main import describe

    monkeypatch.setitem(sys.modules, "av", None)
    with pytest.raises(ModuleNotFoundError) as caught:
        write_folder(film.episode(), tmp_path / "walk", "mp4")
    assert list(tmp_path.iterdir()) == []
    assert "pip install av" in describe(ModuleNotFoundError("No module named 'av'"))
    assert "[video]" in describe(ModuleNotFoundError("No module named 'av'"))
    assert caught.value.name == "av"


@pytest.mark.parametrize(
    ("file", "content", "says"),
    [
        ("episode.json", None, "episode.json"),
        ("trajectory.jsonl", b"", "not the 8 steps"),
        ("images/000002-depth.png", b"no picture", "000002-depth.png"),
        ("images/000002-rgb.png", None, "000002-rgb.png"),
    ],
)
def test_a_broken_folder_is_told(
    tmp_path: Path, file: str, content: bytes | None, says: str
) -> None:
    write_folder(film.episode(), tmp_path / "walk", "none")
    if content is None:
        (tmp_path / "walk" / file).unlink()
    else:
        (tmp_path / "walk" / file).write_bytes(content)
    with pytest.raises(InputError, match=says):
        read_folder(tmp_path / "walk")


def test_a_line_leads_out_of_no_folder(tmp_path: Path) -> None:
    write_folder(film.episode(), tmp_path / "walk", "none")
    path = tmp_path / "walk/trajectory.jsonl"
    path.write_text(path.read_text().replace("images/000000-rgb.png", "../../secret.png"))
    with pytest.raises(InputError, match=r"is not images/000000-rgb\.png"):
        read_folder(tmp_path / "walk")


def test_pictures_of_another_size_than_the_camera_are_refused() -> None:
    step = film.episode().steps[0]
    with pytest.raises(ValueError, match="step 0: rgb is"):
        dataclasses.replace(step, rgb=np.zeros((3, 4, 3), dtype=np.uint8))


def test_packages_that_few_have_are_loaded_when_they_are_used() -> None:
    code = (
        "import sys, sdgen.agent.film.folder, sdgen.agent.film.lerobot; "
        "assert not {'av', 'pyarrow', 'pandas', 'datasets', 'torch'} & set(sys.modules), 'heavy'"
    )
    subprocess.run([sys.executable, "-c", code], check=True, capture_output=True)
