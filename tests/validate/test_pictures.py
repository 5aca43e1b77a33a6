"""Views that no longer belong to their scene are found, digests mended; sound ones are not."""

import re
import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image
from sdgen.dataset.images import gray_bytes, rgb_bytes
from sdgen.validate import validate
from sdgen.validate.colours import follows_mask

from tests import toy
from tests.edits import edit_json, reseal

SAMPLE = Path(__file__).parents[2] / "output" / "sample"
VIEW = "scenes/000001/views/01"


@pytest.fixture
def sample(tmp_path: Path) -> Path:
    """Rendered scenes, as strangers get them."""
    return Path(shutil.copytree(SAMPLE, tmp_path / "sample"))


def _camera(change: Callable[[dict[str, Any]], None]) -> Callable[[Path], None]:
    return lambda path: edit_json(path / VIEW / "view.json", change)


def _half_focal(camera: dict[str, Any]) -> None:
    camera["K"][0][0] /= 2
    camera["K"][1][1] /= 2


def _far_focal(camera: dict[str, Any]) -> None:
    camera["K"][0][0] = camera["K"][1][1] = 1e4


def _moved(axis: int) -> Callable[[Path], None]:
    def move(camera: dict[str, Any]) -> None:
        camera["world_from_camera"][axis][3] += 0.05

    return _camera(move)


def _colours(change: Callable[[Any], Any]) -> Callable[[Path], None]:
    def edit(path: Path) -> None:
        picture = path / VIEW / "rgb.jpg"
        rgb = np.asarray(Image.open(picture))
        picture.write_bytes(rgb_bytes(np.ascontiguousarray(change(rgb)), "jpg"))

    return edit


def _swapped(path: Path) -> None:
    one, other = path / VIEW / "rgb.jpg", path / "scenes/000001/views/00/rgb.jpg"
    first, second = one.read_bytes(), other.read_bytes()
    one.write_bytes(second)
    other.write_bytes(first)


def _another_scenes(path: Path) -> None:
    shutil.copy(path / VIEW.replace("000001", "000002") / "rgb.jpg", path / VIEW / "rgb.jpg")


def _deeper(path: Path) -> None:
    picture = path / VIEW / "depth.png"
    depth = np.asarray(Image.open(picture)).astype(np.uint16)
    picture.write_bytes(gray_bytes(np.where(depth > 0, depth + 100, 0).astype(np.uint16)))


@pytest.mark.parametrize(
    ("damage", "words"),
    [
        (_camera(_half_focal), "view.json: K: not a pinhole camera"),
        (_camera(_far_focal), "view.json: K: not a pinhole camera"),
        (_moved(0), "depth.png: .* of the pixels lie off what the mask says"),
        (_moved(1), "depth.png: .* of the pixels lie off what the mask says"),
        (_moved(2), "depth.png: .* of the pixels lie off what the mask says"),
        (_deeper, "depth.png: .* of the pixels lie off what the mask says"),
        (_colours(lambda rgb: rgb[:, ::-1]), "rgb.jpg: shows something else than instance.png"),
        (_colours(lambda rgb: rgb[::-1]), "rgb.jpg: shows something else than instance.png"),
        (_swapped, "rgb.jpg: shows something else than instance.png"),
        (_another_scenes, "rgb.jpg: shows something else than instance.png"),
    ],
)
def test_a_view_that_is_not_its_scenes_is_found(
    sample: Path, damage: Callable[[Path], None], words: str
) -> None:
    damage(sample)
    reseal(sample)
    found = [problem.text for problem in validate(sample) if problem.check == "view"]
    assert any(re.search(f"{VIEW}/{words}", text) for text in found), found
    assert all("scenes/000001/views" in text for text in found), found


def test_pale_homes_follow_their_masks_and_few_edges_say_nothing() -> None:
    frame = toy.frame(toy.bundle(3), 0)
    pale = (250 - frame.rgb.astype(int) // 24).astype(np.uint8)
    assert follows_mask(pale, frame.instance)
    assert not follows_mask(pale[:, ::-1], frame.instance)
    assert not follows_mask(np.full_like(pale, 250), frame.instance)
    assert follows_mask(pale[:, ::-1], np.full_like(frame.instance, 7))


def test_a_door_whose_white_frame_ends_at_a_white_wall_says_nothing():
    ids = np.full((480, 640), 7, dtype=np.uint16)
    ids[:, 155:430] = 8
    rgb = np.full((480, 640, 3), 190, dtype=np.uint8)
    rgb[:, 155:430] = 192
    rgb[:, 172:415] = (33, 66, 55)
    assert follows_mask(rgb, ids)
    ids[200:240, 40:80] = 9  # one thing more, and the picture has to show it
    ids[300:340, 40:80] = 9
    assert not follows_mask(rgb, ids)
