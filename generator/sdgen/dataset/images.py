"""Pictures to files and back. Lossless for depth and masks; bytes depend on the pixels and on the
versions of deflate (PNG) and Pillow (JPEG), which ``dataset.json`` records."""

from __future__ import annotations

import io
import struct
import zlib
from typing import Any

import deflate
import numpy as np
import numpy.typing as npt
from PIL import Image

from sdgen.errors import InputError

#: Near enough to lossless for training: no chroma is thrown away.
_JPEG: dict[str, Any] = {"quality": 95, "subsampling": 0}

_SIGNATURE = b"\x89PNG\r\n\x1a\n"
_GRAY, _RGB = 0, 2
#: The row filter "Up": with it files are smallest, and it is the cheapest one.
_UP = 2
#: libdeflate's fastest. (ISA-L's takes half the time, but packed one picture of a few thousand in
#: other bytes than another process did; zlib's fastest takes two to three times as long.)
_LEVEL = 1

#: Larger than any size a build can ask for (4096 x 4096).
MAX_PIXELS = 2**24


def rgb_bytes(rgb: npt.NDArray[np.uint8], kind: str) -> bytes:
    """An (H, W, 3) picture as ``png`` or ``jpg``."""
    if kind == "jpg":
        buffer = io.BytesIO()
        Image.fromarray(np.ascontiguousarray(rgb)).save(buffer, "JPEG", **_JPEG)
        return buffer.getvalue()
    return _png(rgb)


def gray_bytes(values: npt.NDArray[np.uint16] | npt.NDArray[np.uint8]) -> bytes:
    """An (H, W) array of 8 or 16 bits as PNG, value for value."""
    if values.dtype not in (np.uint8, np.uint16) or values.ndim != 2:
        raise TypeError(f"(H, W) of uint8 or uint16 expected, got {values.shape} {values.dtype}")
    return _png(values)


def _png(values: npt.NDArray[np.uint16] | npt.NDArray[np.uint8]) -> bytes:
    """PNG (ISO/IEC 15948) of (H, W) or (H, W, 3), every row as its difference from the one above.

    640x480 colours, depth and both masks take 9 ms; with zlib's fastest level 19 ms, for files
    10 % larger, and with Pillow, which tries all filters on every row, 39 ms.
    """
    height, width = values.shape[:2]
    wide = values.dtype == np.uint16
    raw = np.ascontiguousarray(values.astype(">u2") if wide else values)
    rows = raw.reshape(height, -1).view(np.uint8)
    lines = np.empty((height, rows.shape[1] + 1), dtype=np.uint8)
    lines[:, 0] = _UP
    lines[:1, 1:] = rows[:1]
    np.subtract(rows[1:], rows[:-1], out=lines[1:, 1:])
    head = struct.pack(
        ">IIBBBBB", width, height, 16 if wide else 8, _RGB if values.ndim == 3 else _GRAY, 0, 0, 0
    )
    data = bytes(deflate.zlib_compress(lines, _LEVEL))
    return _SIGNATURE + _chunk(b"IHDR", head) + _chunk(b"IDAT", data) + _chunk(b"IEND", b"")


def _chunk(kind: bytes, data: bytes) -> bytes:
    check = zlib.crc32(data, zlib.crc32(kind))
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", check)


def rgb_of(content: bytes, size: tuple[int, int], where: str) -> npt.NDArray[np.uint8]:
    """(H, W, 3) colours of a picture of ``size`` (width, height). Raises InputError."""
    return np.array(_open(content, size, ("RGB",), where), dtype=np.uint8)  # one may write to


def gray_of(content: bytes, size: tuple[int, int], bits: int, where: str) -> npt.NDArray[Any]:
    """(H, W) values of an 8- or 16-bit picture of ``size``. Raises InputError."""
    if bits == 8:
        return np.array(_open(content, size, ("L",), where), dtype=np.uint8)
    return np.asarray(_open(content, size, ("I;16", "I;16B", "I"), where)).astype(np.uint16)


def _open(content: bytes, size: tuple[int, int], modes: tuple[str, ...], where: str) -> Image.Image:
    try:
        with Image.open(io.BytesIO(content), formats=("PNG", "JPEG")) as image:
            if image.size != size:
                raise InputError([f"{where}: {image.size} pixels, the view says {size}"])
            if image.size[0] * image.size[1] > MAX_PIXELS or image.mode not in modes:
                raise InputError([f"{where}: mode {image.mode!r}, expected {modes[0]!r}"])
            image.load()
            picture: Image.Image = image
            return picture
    except (OSError, SyntaxError, ValueError, Image.DecompressionBombError) as error:
        raise InputError([f"{where}: not a readable picture ({error})"]) from None
