"""Masks, depth and colours as pictures a person can read, small enough to look at only."""

from __future__ import annotations

import io

import numpy as np
import numpy.typing as npt
from PIL import Image, ImageDraw

Rgb = npt.NDArray[np.uint8]
Box = tuple[int, int, int, int]

#: Pixels: half as wide as the default picture.
THUMB_WIDTH, THUMB_HEIGHT = 320, 240
#: Depth beyond this is one colour; a step of the colours.
FAR_M, STEP_MM = 8.0, 100
#: A crop shows this many times the thing, and at least this share of the picture.
_AROUND, _LEAST_SHARE = 2.6, 0.22
_MARK = (255, 59, 59)


def mask_colours(instance: npt.NDArray[np.uint16]) -> Rgb:
    """(H, W, 3): every node id a colour of its own, always the same; 0 is black."""
    return np.asarray(_MASK_TABLE[instance], dtype=np.uint8)


def _mask_table() -> Rgb:
    ids = np.arange(65536, dtype=np.uint32)
    # Knuth's multiplicative hash spreads neighbouring ids over the colours.
    mixed = (ids * np.uint32(2654435761)) ^ (ids << np.uint32(7))
    table = np.stack([(mixed >> shift) & 0xFF for shift in (8, 16, 24)], axis=1)
    table = (55 + table * 190 // 255).astype(np.uint8)
    table[0] = 0
    return np.asarray(table, dtype=np.uint8)


_MASK_TABLE = _mask_table()


def depth_colours(depth_mm: npt.NDArray[np.uint16]) -> Rgb:
    """(H, W, 3): near is light yellow, far dark blue, nothing black."""
    t = np.clip(depth_mm / (1000.0 * FAR_M), 0.0, 1.0)[..., None]
    near, middle, far = np.array([(253, 231, 150), (50, 150, 140), (40, 20, 80)], dtype=float)
    colours = np.where(
        t < 0.5, near + (middle - near) * 2 * t, middle + (far - middle) * (2 * t - 1)
    )
    colours[depth_mm == 0] = 0
    return np.asarray(colours, dtype=np.uint8)


def mask_png(instance: npt.NDArray[np.uint16]) -> bytes:
    """The mask in colours, as a PNG with a palette where 256 are enough."""
    here = np.flatnonzero(np.bincount(instance.reshape(-1), minlength=65536))
    if len(here) > 256:
        return _png(Image.fromarray(mask_colours(instance)))
    place = np.zeros(65536, dtype=np.uint8)
    place[here] = np.arange(len(here))
    return _paletted(place[instance], _MASK_TABLE[here])


def depth_png(depth_mm: npt.NDArray[np.uint16]) -> bytes:
    """Depth in colours, in steps of 0.1 m, as a PNG with a palette."""
    steps = int(1000 * FAR_M) // STEP_MM
    place = np.minimum(depth_mm // STEP_MM, steps - 1).astype(np.uint8) + np.uint8(1)
    place[depth_mm == 0] = 0
    middles = np.arange(steps) * STEP_MM + STEP_MM // 2
    palette = depth_colours(np.array([0, *middles.tolist()], dtype=np.uint16))
    return _paletted(place, palette)


def _paletted(values: npt.NDArray[np.uint8], palette: Rgb) -> bytes:
    image = Image.fromarray(values)
    image.putpalette(palette.tobytes())
    return _png(image)


def _png(image: Image.Image) -> bytes:
    buffer = io.BytesIO()
    image.save(buffer, "PNG", optimize=False, compress_level=4)
    return buffer.getvalue()


def thumbnail(rgb: Rgb) -> bytes:
    """A small JPEG of a colour picture."""
    image = Image.fromarray(rgb)
    high = max(1, round(image.height * THUMB_WIDTH / image.width))
    return _jpeg(image.resize((THUMB_WIDTH, high)))


def crop(rgb: Rgb, box: Box) -> tuple[bytes, bool]:
    """A small JPEG of a thing in a picture, 4 to 3, with what is about it; ``box`` (x, y, w, h) is
    drawn around it. True when the thing is in its right half: it lay near the picture's edge."""
    height, width = rgb.shape[:2]
    x, y, w, h = box
    wide = max(_AROUND * w, _AROUND * h * 4 / 3, _LEAST_SHARE * width)
    wide = min(wide, width, height * 4 / 3)
    high = wide * 3 / 4
    left = min(max(x + w / 2 - wide / 2, 0.0), width - wide)
    top = min(max(y + h / 2 - high / 2, 0.0), height - high)
    scale = THUMB_WIDTH / wide
    area = (left, top, left + wide, top + high)
    image = Image.fromarray(rgb).resize(
        (THUMB_WIDTH, THUMB_HEIGHT), Image.Resampling.BICUBIC, box=area
    )
    # Within the picture: of a thing that fills it one would else see a line that means nothing.
    low = (max((x - left) * scale - 4, 1), max((y - top) * scale - 4, 1))
    far = (
        min((x + w - left) * scale + 3, THUMB_WIDTH - 2),
        min((y + h - top) * scale + 3, THUMB_HEIGHT - 2),
    )
    ImageDraw.Draw(image).rectangle((*low, *far), outline=_MARK, width=2)
    return _jpeg(image), x + w / 2 > left + wide * 0.55


def _jpeg(image: Image.Image) -> bytes:
    buffer = io.BytesIO()
    image.save(buffer, "JPEG", quality=80)
    return buffer.getvalue()
