"""Where the walls of a specified home are, and which rooms an opening lies between.

Rectangles lie on the walls' middle lines; a room's floor ends half a wall inside them.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Literal

from shapely import box
from shapely.geometry import Polygon
from shapely.geometry.polygon import orient
from shapely.ops import unary_union

from sdgen.catalog.records import OpeningSpec, RoomSpec
from sdgen.geometry import Vec2
from sdgen.vocabulary import HALF_WALL_M, OpeningKind

Ring = tuple[Vec2, ...]

#: Outer frame sizes of the library's openings (width, height); walls are cut to exactly these. Not
#: in YAML: another size needs doors and windows modelled to it, which is assets' business.
FRAME_M: Mapping[OpeningKind, tuple[float, float]] = {
    "door": (0.90, 2.10),
    "double_door": (1.60, 2.10),
    "passage": (1.00, 2.10),
    "wide_passage": (2.20, 2.20),
    "front_door": (1.00, 2.10),
    "window": (1.20, 1.20),
}
SMALL_WINDOW_M = (0.60, 0.60)
#: What lines that are meant to be one differ by at most: centres of openings are written to the
#: millimetre, inner outlines to a tenth of one.
SAME_M = 1e-3


class OutlineError(ValueError):
    """The rectangles of a room make no room; says why."""


def frame_size(opening: OpeningSpec) -> tuple[float, float]:
    """Width and height of the hole an opening needs."""
    if opening.kind == "window" and opening.small:
        return SMALL_WINDOW_M
    return FRAME_M[opening.kind]


def inner_ring(room: RoomSpec) -> Ring:
    """Corners of a room's floor, counter-clockwise, metres.

    Raises OutlineError when the rectangles do not join, leave a court, or are so narrow that the
    walls leave no floor in one piece.
    """
    outline = unary_union([box(*r) for r in room.rectangles_m]).simplify(1e-6)
    if not isinstance(outline, Polygon):
        raise OutlineError("the rectangles do not join: each must share a side with another")
    if outline.interiors:
        raise OutlineError("the rectangles leave a hole: a room goes round no court")
    floor = orient(outline).buffer(-HALF_WALL_M, join_style="mitre")
    if not isinstance(floor, Polygon) or floor.is_empty:
        text = f"walls {2 * HALF_WALL_M:g} m thick leave no floor in one piece"
        raise OutlineError(f"the room is too narrow: {text}")
    points = list(orient(floor).exterior.coords)[:-1]
    return tuple((round(x, 4) + 0.0, round(y, 4) + 0.0) for x, y in points)


def rooms_beside(rings: Sequence[Ring], opening: OpeningSpec) -> dict[int, float]:
    """The rooms (by index, in order) in whose walls an opening lies, each with how much of its
    width does, metres."""
    width, _ = frame_size(opening)
    found = {}
    for index, ring in enumerate(rings):
        edges = zip(ring, (*ring[1:], ring[0]), strict=True)
        share = sum(in_wall(a, b, opening.center_m, opening.along, width) for a, b in edges)
        if share > SAME_M:
            found[index] = share
    return found


def in_wall(
    start: Vec2, end: Vec2, center: Sequence[float], along: Literal["x", "y"], width: float
) -> float:
    """How much of an opening's width lies in the wall behind an edge of a floor, metres; 0 when
    it is in another. The edge runs counter-clockwise round the floor."""
    axis = 0 if along == "x" else 1
    across = 1 - axis
    # The wall is to the right of the edge, its middle line half its thickness away.
    forward = end[axis] > start[axis]
    outward = HALF_WALL_M if forward == (along == "y") else -HALF_WALL_M
    level = abs(end[across] - start[across]) < SAME_M
    if not level or abs(start[across] + outward - center[across]) > SAME_M:
        return 0.0
    low, high = sorted((start[axis], end[axis]))
    low, high = max(low, center[axis] - width / 2), min(high, center[axis] + width / 2)
    return max(0.0, high - low)
