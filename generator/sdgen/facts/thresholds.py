"""Every threshold of a relation, and the margin within which it is undecided.

Margins are far above what re-evaluation can move (poses are rounded to 1e-5 m before they are
proved) and wide enough that a person would call the thing borderline, too. Three limits have
none, since no label follows from them: each says why it needs none.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from sdgen import vocabulary
from sdgen.kleene import EPS, Kleene


class Threshold(NamedTuple):
    """A limit, and the values from which a measurement is surely below or surely above it."""

    limit: float
    below: float
    above: float

    def at_most(self, measured: float) -> Kleene:
        """``measured`` is at most the limit."""
        return Kleene(measured <= self.limit + EPS, self._clear(measured))

    def at_least(self, measured: float) -> Kleene:
        """``measured`` is at least the limit."""
        return Kleene(measured >= self.limit - EPS, self._clear(measured))

    def more(self, measured: float) -> Kleene:
        """``measured`` is more than the limit."""
        return self.at_most(measured).negated()

    def less(self, measured: float) -> Kleene:
        """``measured`` is less than the limit."""
        return self.at_least(measured).negated()

    def _clear(self, measured: float) -> bool:
        return measured <= self.below + EPS or measured >= self.above - EPS


def around(limit: float, margin: float) -> Threshold:
    """A threshold with the same margin on both sides."""
    return Threshold(limit, limit - margin, limit + margin)


#: ON: the gap between an object's lowest point and the surface, metres (VirtualHome: 1 cm).
#: Settled things lie within a millimetre or two; what floats 2 cm is on something else.
ON_GAP_M = Threshold(0.01, 0.007, 0.02)
#: ON: more than half of the footprint over the surface, or it would topple.
ON_SHARE = around(0.5, 0.1)
#: ON: of surfaces that would carry a thing, the highest does. Lower by this is another level.
ON_LEVEL_M = around(1e-3, 5e-4)
#: ON, UNDER: height between a surface's lowest and highest corner, metres. What is tilted more
#: carries nothing: its owner lies on its side or leans on something, or it is a lid held open.
TILTED_M = around(0.02, 0.005)
#: What is no further from a wall or a ceiling hangs on it, metres. A check of homes, not a label,
#: and nothing comes near it: hung things are fixed and put 5 mm off, what stands keeps 2 cm at its
#: sides and 3 cm at its back.
HUNG_M = 0.015
#: INSIDE: how far the centre lies within the hollow's box, metres.
INSIDE_M = around(0.0, 0.003)
#: CLOSE: the gap between the boxes, metres (VirtualHome).
CLOSE_M = around(1.5, 0.05)
#: FACING: the angle between the front and the direction to the other's centre (VirtualHome).
FACING_RAD = around(math.radians(75), math.radians(vocabulary.HEADING_MARGIN_DEG))
#: FACING of what is sat at, a table or a desk: gap between the boxes, metres. A chair drawn back
#: for somebody to get up stands 0.45 to 0.6 m off (common planning rules); further off, it is
#: another seat of the room.
SAT_AT_M = around(0.5, 0.05)
#: A bearing needs the other's centre at least this far away, metres, and a front that points
#: along the floor (cosine): nearer or steeper, a small change would turn it about. Beyond these
#: a bearing is unsure, never false: they are themselves the edge of a margin.
BEARING_LEAST_M = 0.1
BEARING_LEVEL = 0.5
#: UNDER: share of the footprint below the other's.
UNDER_SHARE = around(0.5, 0.1)
#: UNDER: how far a thing's top lies below the other's highest surface, metres.
UNDER_M = around(0.0, 0.005)
#: BLOCKS: share of the footprint in a doorway's zones. A zone term has the same unless a hazard
#: says otherwise; tags are such terms.
ZONE_SHARE = around(vocabulary.ZONE_SHARE, vocabulary.ZONE_SHARE_MARGIN)
#: Zones: how far the object's range of heights and the zone's overlap, metres.
ZONE_LEVEL_M = around(0.0, 0.02)
#: BLOCKS: a thing lower than this, metres, is stepped over without noticing.
BLOCKING_HEIGHT_M = around(vocabulary.FLAT_M, 0.005)
#: NEAR_HEAT: gap to the heat zone, metres: radiant heat ignites paper and cloth so near a hob.
NEAR_HEAT_M = around(0.3, 0.05)
#: NEAR_WATER: gap to the basin, metres: about how far a splash or an arm carries water.
NEAR_WATER_M = around(0.5, 0.05)
#: Room: how much farther the next room's outline is than the nearest one's, metres. Inside a room
#: that is at least a wall's thickness; only in a doorway or a wall is it less.
ROOM_M = around(0.0, 0.04)
#: Room: farther than this from every room's outline, metres, is outdoors: the shell ends half a
#: wall outside, windows and doors stick out of it by their frames.
OUTDOORS_M = around(0.13, 0.02)
#: Reach: gap, seen from above, to what a child climbs on, metres. A judgement: about the arm that a
#: three-year-old stretches out when it leans over.
CLIMB_NEAR_M = around(0.5, 0.05)
#: Overhang, edge: how far below an object's lowest point something still catches what comes off,
#: metres. A judgement: over the neighbouring worktop or a bench a hand's length lower nothing falls
#: deep; a seat under a table's top is lower.
CAUGHT_M = around(0.25, 0.02)
#: Overhang, edge: a gap so narrow, metres, between two tops or a top and the wall, is no edge: a
#: plate or a pan cannot go down there. A judgement.
CLOSED_GAP_M = around(0.1, 0.02)
#: Tag NEAR_EDGE: the centre's distance from the edge of the surface, metres. Tags say what is
#: measured, within a margin too, and no predicate can ask for this one.
NEAR_EDGE_M = 0.05
