"""Small things of a scene on the furniture that stands there now.

A counter of ours is not just as high as the one that was found, and scenes let things hover: so
each goes up or down to what it stood on, with all that lay on it.
"""

from __future__ import annotations

from collections.abc import Sequence

import shapely

from sdgen.home.surfaces import PlacingSurface
from sdgen.importing.scenes.found import FoundPiece

#: What is so near below or above a thing's bottom carries it, metres.
_CARRIES_M = 0.12
#: What lies on another thing is no further from its top, metres.
_ON_TOP_M = 0.02


def shifts_m(
    pieces: Sequence[FoundPiece], surfaces: Sequence[PlacingSurface], floor_m: float = 0.0
) -> list[float]:
    """How far each thing of a room goes up, metres; 0 for one that nothing carries.

    ``surfaces`` are those of the furniture in the room.
    """
    out = [0.0] * len(pieces)
    order = sorted(range(len(pieces)), key=lambda k: pieces[k].position_m[2])
    for place, k in enumerate(order):
        x, y, z = pieces[k].position_m
        under = [j for j in order[:place] if _lies_on(pieces[k], pieces[j])]
        if under:
            out[k] = out[under[-1]]
            continue
        point = shapely.Point(x, y)
        levels = [surface.z_m for surface in surfaces if surface.edge.covers(point)]
        nearest = min([*levels, floor_m], key=lambda level: abs(level - z))
        if abs(nearest - z) <= _CARRIES_M:
            out[k] = nearest - z
    return out


def _lies_on(one: FoundPiece, other: FoundPiece) -> bool:
    """True when a thing's middle is over another, at its top."""
    x, y, z = one.position_m
    if abs(other.top_m - z) > _ON_TOP_M:
        return False
    reach = max(other.extents_m[:2]) / 2
    return max(abs(x - other.position_m[0]), abs(y - other.position_m[1])) <= reach
