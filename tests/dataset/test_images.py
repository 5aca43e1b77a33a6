"""Pictures keep every value; bad ones are one clear error."""

from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
from hypothesis import given
from hypothesis.extra import numpy as hnp
from PIL import Image
from sdgen.dataset.images import gray_bytes, gray_of, rgb_bytes, rgb_of
from sdgen.errors import InputError

SHAPES = hnp.array_shapes(min_dims=2, max_dims=2, min_side=1, max_side=9)


@given(hnp.arrays(np.uint16, SHAPES))
def test_sixteen_bits_survive(values: npt.NDArray[np.uint16]) -> None:
    assert np.array_equal(_back(gray_bytes(values), values.shape, 16), values)


@given(hnp.arrays(np.uint8, SHAPES))
def test_eight_bits_survive(values: npt.NDArray[np.uint8]) -> None:
    assert np.array_equal(_back(gray_bytes(values), values.shape, 8), values)


def test_colours_survive_png_and_nearly_jpg() -> None:
    rgb = np.zeros((20, 30, 3), dtype=np.uint8)
    rgb[5:15, 10:20] = (200, 40, 30)
    for kind, worst in (("png", 0), ("jpg", 40)):
        back = rgb_of(rgb_bytes(rgb, kind), (30, 20), "a")
        assert np.abs(back.astype(int) - rgb).max() <= worst


def test_same_pixels_same_bytes_whatever_their_layout() -> None:
    rgb = np.random.default_rng(0).integers(0, 255, (40, 30, 3), dtype=np.uint8)
    assert rgb_bytes(rgb, "png") == rgb_bytes(np.asfortranarray(rgb), "png")


def test_masks_of_other_kinds_are_refused() -> None:
    with pytest.raises(TypeError):
        gray_bytes(np.zeros((2, 2), dtype=np.int32))  # type: ignore[arg-type]


def test_bad_pictures_are_located() -> None:
    good = gray_bytes(np.full((8, 9), 700, dtype=np.uint16))
    cases: list[tuple[bytes, tuple[int, int], str]] = [
        (good[:-30], (9, 8), "not a readable picture"),
        (b"hello", (9, 8), "not a readable picture"),
        (good, (8, 9), "pixels, the view says"),
        (gray_bytes(np.zeros((8, 9), dtype=np.uint8)), (9, 8), "mode 'L'"),
    ]
    for data, size, expected in cases:
        with pytest.raises(InputError, match=expected):
            gray_of(data, size, 16, "m.png")


def test_a_picture_bomb_is_refused_before_it_is_decoded(tmp_path: Path) -> None:
    path = tmp_path / "bomb.png"
    Image.new("1", (30_000, 30_000)).save(path)
    with pytest.raises(InputError):
        gray_of(path.read_bytes(), (640, 480), 16, "bomb.png")


def _back(data: bytes, shape: tuple[int, ...], bits: int) -> Any:
    return gray_of(data, (shape[1], shape[0]), bits, "x")
