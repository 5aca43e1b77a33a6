"""Pictures of strangers are held no larger than any texture of ours."""

from __future__ import annotations

import io

import numpy as np
import pytest
from PIL import Image
from sdgen.errors import AssetError
from sdgen.importing.pictures import LARGEST_SIDE, opened, picture_of


def png(size: tuple[int, int], mode: str = "RGB", kind: str = "PNG") -> bytes:
    out = io.BytesIO()
    Image.new("RGB", size, "red").convert(mode).save(out, kind)
    return out.getvalue()


@pytest.mark.parametrize(
    ("size", "mode", "kind"),
    [
        ((5000, 40), "RGB", "PNG"),
        ((40, 9000), "RGBA", "PNG"),
        ((6000, 30), "L", "PNG"),
        ((6000, 30), "P", "PNG"),
        ((5000, 100), "RGB", "JPEG"),
        ((5000, 100), "CMYK", "JPEG"),
    ],
)
def test_large_pictures_are_made_smaller(size: tuple[int, int], mode: str, kind: str) -> None:
    picture = opened(picture_of(png(size, mode, kind), "a.png"), "a.png")
    assert max(picture.size) <= LARGEST_SIDE
    assert picture.size[0] / picture.size[1] == pytest.approx(size[0] / size[1], rel=0.1)
    red = (76, 76, 76) if mode == "L" else (255, 0, 0)
    assert np.allclose(np.asarray(picture)[0, 0], red, atol=6)


def test_small_ones_stay_as_they_are() -> None:
    assert picture_of(png((300, 200)), "a.png").size == (300, 200)


@pytest.mark.parametrize("data", [b"", b"no picture", png((9000, 9000))], ids=["0", "text", "9k"])
def test_what_cannot_be_unpacked_is_located(data: bytes) -> None:
    with pytest.raises(AssetError, match=r"^a\.png: "):
        picture_of(data, "a.png")


def test_a_picture_cut_short_is_broken() -> None:
    data = png((5000, 40))
    with pytest.raises(AssetError, match=r"^a\.png: the texture is broken"):
        opened(picture_of(data[: len(data) // 2], "a.png"), "a.png")
