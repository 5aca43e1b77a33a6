"""Frames of a video: small ones made larger, each with a line of text below."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt
from PIL import Image, ImageDraw, ImageFont

from sdgen.agent.film.steps import Step
from sdgen.errors import SdgenError

#: So long is the longer side at least, in whole multiples of what the camera draws.
SIDE = 256
#: Height of the line of text, even as videos want it.
_BAND = 18

Pixels = npt.NDArray[np.uint8]


def seen(steps: Sequence[Step]) -> list[Pixels]:
    """The colour pictures of all steps, all of one size. Raises SdgenError where there are none."""
    pictures = [step.rgb for step in steps if step.rgb is not None]
    if not pictures or len(pictures) < len(steps):
        raise SdgenError("no colours to film: the agent's sensors need rgb (or ask for no video)")
    if len({picture.shape for picture in pictures}) > 1:
        raise SdgenError("pictures of several sizes make no video")
    return pictures


def larger(pixels: Pixels) -> Pixels:
    """Every pixel of a small picture as a square of pixels, so that a person sees something."""
    times = -(-SIDE // max(pixels.shape[:2]))
    return pixels.repeat(times, axis=0).repeat(times, axis=1) if times > 1 else pixels


def band(text: str, width: int) -> npt.NDArray[np.bool_]:
    """A line of text, (18, width), True where it is bright. What is too long is cut off."""
    image = Image.new("1", (width, _BAND))
    plain = text.encode("ascii", "replace").decode()  # all that every default font has
    ImageDraw.Draw(image).text((4, 3), plain, fill=1, font=ImageFont.load_default())
    return np.asarray(image, dtype=np.bool_)


def with_band(pixels: Pixels, text: str) -> Pixels:
    """A picture with a line of text below it."""
    line = band(text, pixels.shape[1])
    return np.concatenate([pixels, np.where(line, 255, 0).astype(np.uint8)[..., None].repeat(3, 2)])


def even(pixels: Pixels) -> Pixels:
    """With its last row or column once more, where there is an odd number of them."""
    high, wide = pixels.shape[:2]
    return np.pad(pixels, ((0, high % 2), (0, wide % 2), (0, 0)), mode="edge")
