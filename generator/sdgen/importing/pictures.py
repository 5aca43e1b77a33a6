"""Pictures of strangers: looked at before they are unpacked."""

from __future__ import annotations

import io
import warnings
from typing import Any

from sdgen.errors import AssetError

#: Suffixes of pictures that models bring along.
PICTURES = (".png", ".jpg", ".jpeg", ".bmp", ".tga", ".tif", ".tiff", ".webp", ".gif")
_FORMATS = ("PNG", "JPEG", "BMP", "TGA", "TIFF", "WEBP", "GIF")
#: Pixels unpacked at once: 8192 x 8192 RGB take 200 MB. JPEGs are unpacked smaller.
MAX_PIXELS = 8192 * 8192
_MAX_SIDE = 65_000
#: Pixels a side of a texture that is kept: those of ours have at most so many.
LARGEST_SIDE = 4096


def checked_picture(data: bytes, shown: str) -> Any:
    """A Pillow image, not yet unpacked. Raises AssetError, located, for what is none or too large.

    A JPEG of more than ``MAX_PIXELS`` is set to be unpacked at a half, a quarter or an eighth.
    """
    from PIL import Image

    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", Image.DecompressionBombWarning)
            image = Image.open(io.BytesIO(data), formats=_FORMATS)
    except Image.DecompressionBombError:
        raise AssetError([f"{shown}: a texture too large to be unpacked"]) from None
    except (OSError, SyntaxError, ValueError):
        raise AssetError([f"{shown}: is no picture"]) from None
    _check_size(image, shown)
    return image


def picture_of(data: bytes, shown: str) -> Any:
    """A Pillow image no larger than any texture of ours. Raises AssetError, located."""
    return bounded(checked_picture(data, shown), shown)


def bounded(image: Any, shown: str) -> Any:
    """The image, made smaller where one is larger than any texture of ours: models have many, and
    all are held at once. A large one is closed. Raises AssetError for one that is too large to be
    unpacked, or broken."""
    from PIL import Image

    _check_size(image, shown)
    if max(image.size) <= LARGEST_SIDE:
        return image
    if image.format == "JPEG":
        image.draft("RGB", (LARGEST_SIDE, LARGEST_SIDE))
    try:
        factor = -(-max(image.size) // LARGEST_SIDE)
        plain = image
        if image.mode not in ("RGB", "RGBA", "L", "LA"):
            plain = image.convert("RGBA" if "transparency" in image.info else "RGB")
        small = plain.reduce(factor)
        image.close()  # its pixels, which whoever still knows it would hold
        return small
    except (OSError, SyntaxError, ValueError, Image.DecompressionBombError) as error:
        raise AssetError([f"{shown}: the texture is broken ({error})"]) from None


def _check_size(image: Any, shown: str) -> None:
    width, height = image.size
    if width * height > MAX_PIXELS and image.format == "JPEG" and max(image.size) <= _MAX_SIDE:
        image.draft("RGB", (width // 2, height // 2))
        width, height = image.size
    if width * height > MAX_PIXELS:
        text = f"a texture of {width} x {height} pixels, at most {MAX_PIXELS} in all"
        raise AssetError([f"{shown}: {text}; make it smaller"])


def opened(image: Any, shown: str) -> Any:
    """The image unpacked as RGB over white where it is transparent. Raises AssetError for a broken
    one."""
    from PIL import Image

    try:
        if image.mode in ("RGBA", "LA", "PA") or "transparency" in image.info:
            full = image.convert("RGBA")
            ground = Image.new("RGBA", full.size, (255, 255, 255, 255))
            return Image.alpha_composite(ground, full).convert("RGB")
        return image.convert("RGB")
    except (OSError, SyntaxError, ValueError, Image.DecompressionBombError) as error:
        raise AssetError([f"{shown}: the texture is broken ({error})"]) from None
