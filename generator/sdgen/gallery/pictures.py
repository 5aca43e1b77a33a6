"""Masks and depth as pictures a person can read."""

from __future__ import annotations

import io

import numpy as np
import numpy.typing as npt
from PIL import Image

Rgb = npt.NDArray[np.uint8]

#: Pixels: half as wide as the default picture.
THUMB_WIDTH = 320
#: Depth beyond this is one colour.
FAR_M = 8.0


def mask_colours(instance: npt.NDArray[np.uint16]) -> Rgb:
    """(H, W, 3): every node id a colour of its own, always the same; 0 is black."""
    ids = np.arange(65536, dtype=np.uint32)
    # Knuth's multiplicative hash spreads neighbouring ids over the colours.
    mixed = (ids * np.uint32(2654435761)) ^ (ids << np.uint32(7))
    table = np.stack([(mixed >> shift) & 0xFF for shift in (8, 16, 24)], axis=1)
    table = (55 + table * 190 // 255).astype(np.uint8)
    table[0] = 0
    return np.asarray(table[instance], dtype=np.uint8)


def depth_colours(depth_mm: npt.NDArray[np.uint16]) -> Rgb:
    """(H, W, 3): near is light yellow, far dark blue, nothing black."""
    t = np.clip(depth_mm / (1000.0 * FAR_M), 0.0, 1.0)[..., None]
    near, middle, far = np.array([(253, 231, 150), (50, 150, 140), (40, 20, 80)], dtype=float)
    colours = np.where(
        t < 0.5, near + (middle - near) * 2 * t, middle + (far - middle) * (2 * t - 1)
    )
    colours[depth_mm == 0] = 0
    return np.asarray(colours, dtype=np.uint8)


def small_png(rgb: Rgb) -> bytes:
    """A PNG of 64 colours: small, for looking at only."""
    buffer = io.BytesIO()
    # The median cut is exact for masks (few colours) and smooth enough for depth.
    Image.fromarray(rgb).quantize(64).save(buffer, "PNG", optimize=False, compress_level=6)
    return buffer.getvalue()


def thumbnail(rgb: Rgb) -> bytes:
    """A small JPEG of a colour picture."""
    image = Image.fromarray(rgb)
    height = max(1, round(image.height * THUMB_WIDTH / image.width))
    buffer = io.BytesIO()
    image.resize((THUMB_WIDTH, height)).save(buffer, "JPEG", quality=80)
    return buffer.getvalue()
