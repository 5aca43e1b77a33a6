"""Colours of drawn parts as light has them: linear, and a part's mean."""

from __future__ import annotations

from functools import lru_cache
from pathlib import Path

import numpy as np
from PIL import Image

from sdgen.geometry import Array
from sdgen.render.raster.drawn import Drawn

#: sRGB to linear, near enough.
_GAMMA = 2.2


def albedo_of(part: Drawn) -> Array:
    """The share of red, green and blue light that a part gives on, (3,)."""
    return np.asarray(mean_colour(part.texture) * np.minimum(part.rgb, 1.0) ** _GAMMA)


@lru_cache(maxsize=4096)
def mean_colour(texture: Path) -> Array:
    """A texture's mean colour, linear, (3,)."""
    with Image.open(texture) as image:
        small = image.convert("RGB").resize((1, 1), Image.Resampling.BOX)
    return np.asarray((np.asarray(small, dtype=np.float64).reshape(3) / 255) ** _GAMMA)
