"""Turns and panoramas that are not whole, or not of their views, are found; sound ones are not."""

import shutil
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from sdgen.cameras.turn import Post, panoramas_of, turn_cameras
from sdgen.dataset import Dataset
from sdgen.dataset.images import gray_bytes, rgb_bytes
from sdgen.looks import PRESETS, drawn_look
from sdgen.render.looks import as_seen
from sdgen.render.stitching import Stitching
from sdgen.seeding import lane
from sdgen.validate import validate

from tests import toy, toy_pictures
from tests.edits import edit_json, reseal

SCENE = "scenes/000000"
POSTS = [Post(100, np.array([2.2, 0.2, 1.2]), 0.4), Post(101, np.array([1.6, 4.0, 1.2]), -1.0)]


def build(path: Path, **more) -> Path:
    """A toy data set of two scenes whose rooms have turns."""
    options = toy.small(n=2, views_mode="panorama", equirect=True, width=96, height=72, **more)
    with toy.open_writer(path, options) as writer:
        for index in range(options.n):
            made = toy.bundle(index, options)
            cameras = turn_cameras(POSTS, (options.width, options.height))
            panoramas = panoramas_of(cameras)
            if options.look:
                looks = [drawn_look(options.look, 0.2, lane(7, index, f"{k}")) for k in range(14)]
                seen = zip(cameras, looks, strict=False)
                cameras = tuple(one.model_copy(update={"look": look}) for one, look in seen)
                seen = zip(panoramas, looks[12:], strict=True)
                panoramas = tuple(one.model_copy(update={"look": look}) for one, look in seen)
            made = replace(made, cameras=cameras, panoramas=panoramas)
            stitching = Stitching(panoramas, options.sensors)
            frames = []
            with toy.painter(writer).begin(made) as folder:
                for camera in stitching.cameras(cameras):
                    frame = toy_pictures.frame(made.scene, camera, toy.infos())
                    done = stitching.add(frame)
                    if done is not None:
                        folder.add_panorama(*done)
                    if not stitching.wants_only(frame):
                        frames.append(frame)
                        folder.add(replace(frame, rgb=as_seen(frame.rgb, camera.look)))
                folder.finish(toy.visibility(made, frames, options))
        writer.finish()
    return path


@pytest.fixture(scope="module")
def sound(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return build(tmp_path_factory.mktemp("turns") / "d")


def texts(path: Path) -> list[str]:
    reseal(path)
    return [problem.text for problem in validate(path)]


@pytest.mark.parametrize(
    "more",
    [
        {},
        {"look": PRESETS["robot"]},
        {"rgb": "jpg"},
        {"sensors": ("rgb",)},
        {"sensors": ("depth", "instance")},
    ],
)
def test_sound_turns_pass_and_are_read(tmp_path: Path, more) -> None:
    path = build(tmp_path / "d", **more)
    assert [problem.text for problem in validate(path)] == []
    data = Dataset(path)
    assert "turns of views" in repr(data)
    item = data[0]
    assert [one.room_id for one in item.panoramas] == [100, 101]
    sensors = data.info.options.sensors
    if "rgb" in sensors:
        assert item.panorama_rgb(1).shape == (154, 308, 3)
    if "instance" in sensors:
        assert item.panorama_instance(1).shape == (154, 308)
        assert 11 in item.panorama_instance(0)  # the stove, all in all


@pytest.fixture
def path(sound: Path, tmp_path: Path) -> Path:
    return Path(shutil.copytree(sound, tmp_path / "d"))


@pytest.mark.parametrize(
    ("file", "change", "told"),
    [
        ("views/03/view.json", {"kind": "near", "turn": None}, "kind: 'near', the options say"),
        ("views/03/view.json", {"turn": None}, "turn: only views of kind 'turn'"),
        ("views/03/view.json", {"turn": {"step": 2, "of": 6}}, "turn: not 6 views one after"),
        ("views/03/view.json", {"room_id": 101}, "room_id: not that of the whole turn"),
        ("panoramas/01/panorama.json", {"room_id": 100}, "panoramas: not those of the turns"),
        ("panoramas/01/panorama.json", {"width": 306}, "panoramas: not those of the turns"),
    ],
)
def test_changed_records_are_found(path: Path, file: str, change: dict, told: str) -> None:
    edit_json(path / SCENE / file, lambda value: value.update(change))
    assert any(told in text for text in texts(path))


def test_a_view_that_is_turned_otherwise_is_found(path: Path) -> None:
    def swap(value: dict) -> None:
        value["world_from_camera"] = [list(row) for row in other]

    other = Dataset(path)[0].cameras[4].world_from_camera
    edit_json(path / SCENE / "views/03/view.json", swap)
    assert any("step 3 is not level, in place" in text for text in texts(path))


def test_pictures_of_something_else_are_found(path: Path) -> None:
    item = Dataset(path)[0]
    folder = path / SCENE / "panoramas/00"
    (folder / "rgb.png").write_bytes(rgb_bytes(item.panorama_rgb(0)[:, ::-1], "png"))
    (folder / "instance.png").write_bytes(gray_bytes(item.panorama_instance(1)))
    found = texts(path)
    assert any("panoramas/00/rgb.png: not the pictures of its views" in text for text in found)
    assert any("panoramas/00/instance.png: not the masks of its views" in text for text in found)


def test_missing_panoramas_are_found(path: Path) -> None:
    shutil.rmtree(path / SCENE / "panoramas/01")
    assert any("panoramas/01/rgb.png: missing" in problem.text for problem in validate(path))


def test_views_without_the_look_that_the_options_say_are_found(tmp_path: Path) -> None:
    path = build(tmp_path / "d", look=PRESETS["phone"])
    for name in ("views/03/view.json", "panoramas/00/panorama.json"):
        edit_json(path / SCENE / name, lambda value: value.update(look=None))
    found = texts(path)
    assert sum("look: none, the options say phone" in text for text in found) == 2
