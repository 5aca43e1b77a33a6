"""How far things reach over edges, and how far off edges they are.

What would catch a thing that comes off is what carries it, and all that is fixed, as far as they
reach up to a little below its lowest point (``CAUGHT_M``): their outlines seen from above, parts
that stand open left out, and the surfaces of what carries it. Where else in the room there is no
wall and no narrow gap (``CLOSED_GAP_M``), a drop begins.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
import shapely

from sdgen.catalog.predicate import Span
from sdgen.facts.body import Body
from sdgen.facts.grounds import OUTLINE, Catcher, Ground
from sdgen.facts.measured import Measured
from sdgen.facts.thresholds import CAUGHT_M, CLOSED_GAP_M, ON_GAP_M
from sdgen.kleene import NO, YES, Kleene, all_of, any_of

#: An outline is measured at its corners and at points so far apart between them, metres: exact over
#: a straight edge, and at most half of this too little where what catches is hollowed out.
STEP_M = 0.005


class Brink(NamedTuple):
    """How a thing lies at the edge of what it is on: by how much it reaches beyond all that would
    catch it, and how far its outline is from where a drop begins (infinite: from nowhere)."""

    overhang: Span
    edge: Span


class _At(NamedTuple):
    """How far a thing reaches over, and how far it is from a drop."""

    overhang_m: float
    edge_m: float


_NOWHERE = _At(0.0, math.inf)


def brink(facts: Measured, object_id: int) -> Brink:
    """How a thing lies at edges: neither over nor near any where it is ON nothing, or where the
    floor itself would catch it."""
    body = facts.bodies[object_id]
    on = any_of(Kleene(r.holds, r.sure) for r in facts.on(object_id))
    high_up = all_of((on, CAUGHT_M.more(float(body.low[2]))))
    rooms = facts.room_ids(object_id)
    if high_up == NO or not rooms:
        return _brink(_NOWHERE, [])
    found = [at for room in rooms for at in _in_room(facts, body, room)]
    if not high_up.sure:
        found.append(_NOWHERE)
    return _brink(found[0] if high_up.value else _NOWHERE, found)


def carried_whole(facts: Measured, object_id: int) -> bool:
    """All of a thing is surely over one thing that carries it: it reaches over nothing, and most
    things are so."""
    body = facts.bodies[object_id]
    low = float(body.low[2])
    return any(
        all_of((carrier.either, _reaches(facts.bodies[key], low))) == YES
        and facts.bodies[key].trunk.covers(body.footprint)
        for key, carrier in facts.carriers(object_id).items()
        if key in facts.bodies
    )


def _brink(measured: _At, others: list[_At]) -> Brink:
    overhangs, edges = zip(measured, *others, strict=True)
    return Brink(
        Span(measured.overhang_m, min(overhangs), max(overhangs)),
        Span(measured.edge_m, min(edges), max(edges)),
    )


def _in_room(facts: Measured, body: Body, room_id: int) -> Iterator[_At]:
    """As measured, and with as little and with as much to catch it as there may be."""
    if room_id not in facts.rooms.by_id:
        yield _NOWHERE
        return
    catchers = sorted(_catchers(facts, body, room_id))
    measured = tuple(key for key, holds in catchers if holds.value)
    surely = tuple(key for key, holds in catchers if holds == YES)
    perhaps = tuple(key for key, _ in catchers)
    yield _at(body, facts.grounds.of(room_id, measured, CLOSED_GAP_M.limit))
    yield _at(body, facts.grounds.of(room_id, surely, CLOSED_GAP_M.below))
    yield _at(body, facts.grounds.of(room_id, perhaps, CLOSED_GAP_M.above))


def _catchers(facts: Measured, body: Body, room_id: int) -> Iterator[tuple[Catcher, Kleene]]:
    """What would catch a thing in a room, and how surely."""
    low = float(body.low[2])
    x0, y0, x1, y1 = facts.rooms.outline(room_id).bounds
    ids, lows, highs, tops = facts.fixtures
    near = (lows[:, 2] - low < ON_GAP_M.above) & (low - tops < CAUGHT_M.above)
    near &= (lows[:, 0] < x1) & (highs[:, 0] > x0) & (lows[:, 1] < y1) & (highs[:, 1] > y0)
    for index in np.flatnonzero(near).tolist():
        holds = _reaches(facts.bodies[ids[index]], low)
        if holds != NO and ids[index] != body.item.id:
            yield (ids[index], OUTLINE), holds
    for key, carrier in facts.carriers(body.item.id).items():
        other = facts.bodies.get(key)
        if other is None:
            continue
        holds = all_of((carrier.either, _reaches(other, low)))
        if holds != NO and not other.item.fixed:
            yield (key, OUTLINE), holds
        for number, surface in enumerate(other.surfaces):
            below = ON_GAP_M.at_most(surface.z_m - low), CAUGHT_M.at_most(low - surface.z_m)
            holds = all_of((carrier.either, surface.level, *below))
            if holds != NO and not other.trunk.covers(surface.outline):
                yield (key, number), holds


def _reaches(other: Body, low_m: float) -> Kleene:
    """It begins below ``low_m``, and its top is at most a little lower than that."""
    begins = ON_GAP_M.at_most(float(other.low[2]) - low_m)
    return all_of((begins, CAUGHT_M.at_most(low_m - other.top_m)))


def _at(body: Body, ground: Ground) -> _At:
    if ground.drop.is_empty:
        return _NOWHERE
    apart = float(ground.drop.distance(body.footprint))
    if apart > 0.0:
        return _At(0.0, apart)
    outline = shapely.points(shapely.get_coordinates(shapely.segmentize(body.footprint, STEP_M)))
    over = outline[shapely.intersects(ground.drop, outline)]
    # Nothing catches it in this room at all where it lies across the door to another.
    if ground.firm.is_empty:
        return _NOWHERE
    return _At(float(shapely.distance(over, ground.firm).max(initial=0.0)), 0.0)
