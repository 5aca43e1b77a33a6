"""Which poses show so many pixels of a thing's parts: few rays decide what is plain."""

from __future__ import annotations

from collections.abc import Collection

import numpy as np

from sdgen.cameras.framing import Bools
from sdgen.cameras.parts import part_numbers, part_points
from sdgen.cameras.sight import Cast, estimate_pixels, rectangle_pixels
from sdgen.geometry import Array
from sdgen.library import Library
from sdgen.scene import ObjectInstance

#: Rays along a side of the few. In shares of what is needed, what they say is surely too little or
#: enough; of the rest, and where one of the few would stand for the lower share alone, many count.
_ROUGH_GRID, _SURELY = 6, (0.3, 2.0)


def shows_pixels(
    library: Library,
    item: ObjectInstance,
    cast: Cast,
    poses: Array,
    parts: Collection[str],
    needed: float,
    too_little: float = _SURELY[0],
) -> Bools:
    """Which poses (N, 4, 4) show so many pixels of these parts of an object (all when empty), (N,).

    ``too_little`` is the share of what is needed below which few rays decide.
    """
    points = part_points(library, item, parts)
    numbers = part_numbers(library, item, parts)
    rough = estimate_pixels(cast, poses, points, item.id, numbers, _ROUGH_GRID)
    coarse = rectangle_pixels(poses, points) > too_little * needed * _ROUGH_GRID**2
    out = np.asarray(~coarse & (rough >= _SURELY[1] * needed))
    unsure = np.flatnonzero((coarse | (rough >= too_little * needed)) & ~out)
    out[unsure] = estimate_pixels(cast, poses[unsure], points, item.id, numbers) >= needed
    return out
