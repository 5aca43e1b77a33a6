"""What reaches into walls, floors and ceilings, by its outline: no collision pieces are needed."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import shapely

from sdgen.facts.body import Body, rows
from sdgen.facts.measured import Measured
from sdgen.geometry import Array
from sdgen.scene import Violation

#: So deep, metres, nobody sees it: physics lets hulls overlap by 4 mm, and meshes and hulls differ
#: by a millimetre or two.
ENTERED_M = 0.006


def entered_structures(measured: Measured) -> Iterator[Violation]:
    """Objects deeper than ``ENTERED_M`` in a wall, a floor or a ceiling: (object, structure).

    Outermost points say it of all; of a part that a joint has moved, which may stand right through
    a wall with all its corners beyond, its outline from above does.
    """
    pieces = [(s.id, box) for s in measured.structures.values() for box in s.pieces]
    centers = rows([box.center_m for _, box in pieces], 3)
    halves = rows([box.size_m for _, box in pieces], 3) / 2
    low, high = centers - halves, centers + halves
    rings = shapely.box(*(low + ENTERED_M)[:, :2].T, *(high - ENTERED_M)[:, :2].T)
    for key, body in sorted(measured.bodies.items()):
        near = np.minimum(high, body.high) - np.maximum(low, body.low) > ENTERED_M
        deepest: dict[int, float] = {}
        for k in np.flatnonzero(near.all(axis=1)).tolist():
            depth = _depth(body.corners, low[k], high[k])
            if depth <= ENTERED_M and _leaf_within(body, rings[k], low[k, 2], high[k, 2]):
                depth = float(2 * halves[k].min())
            if depth > ENTERED_M:
                deepest[pieces[k][0]] = max(depth, deepest.get(pieces[k][0], 0.0))
        for structure, depth in sorted(deepest.items()):
            yield Violation(
                check="penetrates",
                objects=(key, structure),
                measured=round(depth, 6),
                limit=ENTERED_M,
            )


def _depth(points: Array, low: Array, high: Array) -> float:
    """How deep the deepest of some points (N, 3) lies in a box; negative when none is in it."""
    return float(np.minimum(points - low, high - points).min(axis=1).max())


def _leaf_within(body: Body, ring: shapely.Polygon, low_m: float, high_m: float) -> bool:
    """A part that a joint has moved shares space with a box drawn in by ``ENTERED_M``."""
    for piece in range(body.outline.still, len(body.outline.starts)):
        heights = body.outline.within(body.corners, piece)[:, 2]
        reaches = min(high_m, heights.max()) - max(low_m, heights.min()) > ENTERED_M
        if reaches and body.pieces[piece].intersects(ring):
            return True
    return False
