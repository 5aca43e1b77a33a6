"""CLOSE, FACING and UNDER, gaps and bearings: how bodies stand to each other."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence

import numpy as np
import shapely

from sdgen.catalog.predicate import Bearing, Overlooked, Related
from sdgen.facts.body import Body, gaps, rows
from sdgen.facts.measured import Measured
from sdgen.facts.rooms import same_room
from sdgen.facts.thresholds import (
    BEARING_LEAST_M,
    BEARING_LEVEL,
    CLOSE_M,
    FACING_RAD,
    SAT_AT_M,
    UNDER_M,
    UNDER_SHARE,
)
from sdgen.kleene import NO, Kleene, all_of


def close(facts: Measured, object_id: int) -> Iterable[Related]:
    """Things of the same room within reach of a few steps."""
    for other, gap, holds in _near(facts, object_id):
        # Most are surely near: what the rooms say then holds as it is.
        if gap > CLOSE_M.below:
            holds = all_of((holds, CLOSE_M.less(gap)))
        if holds != NO:
            category = facts.bodies[other].item.category
            yield Related(other, category, *holds, {"gap_m": max(gap, 0.0)})


def close_to(facts: Measured, object_id: int) -> list[int]:
    """Ids of what an object is CLOSE to, as measured: some twenty each, so without the rest of what
    :func:`close` tells of them."""
    return [
        other
        for other, gap, holds in _near(facts, object_id)
        if holds.value and (gap <= CLOSE_M.below or CLOSE_M.less(gap).value)
    ]


def _near(facts: Measured, object_id: int) -> Iterable[tuple[int, float, Kleene]]:
    """Things that may be close: their ids, the gaps, and whether they are in the same room."""
    body = facts.bodies[object_id]
    ids, lows, highs = facts.boxes
    apart = gaps(body.low, body.high, lows, highs)
    mine = facts.room_ids(object_id)
    together: dict[tuple[int, ...], Kleene] = {}
    near = np.flatnonzero(apart < CLOSE_M.above)
    for index, gap in zip(near.tolist(), apart[near].tolist(), strict=True):
        other = ids[index]
        if other == object_id:
            continue
        rooms = facts.room_ids(other)
        holds = together.get(rooms)
        if holds is None:
            holds = together[rooms] = same_room(mine, rooms)
        yield other, gap, holds


def apart(
    facts: Measured, object_id: int, others: Iterable[int], from_above: bool
) -> tuple[tuple[float, int], ...]:
    """Gaps to others and their ids, nearest first: between boxes, or between outlines on the floor
    plan."""
    body, ids = facts.bodies[object_id], [k for k in others if k != object_id]
    if from_above:
        outlines = np.array([facts.bodies[k].footprint for k in ids], dtype=object)
        found: Sequence[float] = shapely.distance(body.footprint, outlines).tolist()
    else:
        lows = rows([facts.bodies[k].low for k in ids], 3)
        highs = rows([facts.bodies[k].high for k in ids], 3)
        found = gaps(body.low, body.high, lows, highs).tolist()
    return tuple(sorted(zip(found, ids, strict=True)))


def overlooked(facts: Measured, object_id: int, others: Iterable[int]) -> Iterable[Overlooked]:
    """Others that are, or may be, in the same room, nearest first as seen from above, and how far
    below the object their tops are."""
    low = float(facts.bodies[object_id].low[2])
    mine = facts.room_ids(object_id)
    for gap, other in apart(facts, object_id, others, from_above=True):
        together = same_room(mine, facts.room_ids(other))
        if together != NO:
            yield Overlooked(other, gap, low - facts.bodies[other].top_m, together)


def bearing(body: Body, other: Body) -> tuple[float, bool]:
    """Angle between an object's front and the direction to another's centre, seen from above, 0
    to pi; False when the other is too near, or the front too steep, to say."""
    x, y = body.world_from_object[:2, 0]
    dx, dy = (other.center - body.center)[:2]
    turn = math.atan2(dy, dx) - math.atan2(y, x)
    clear = math.hypot(dx, dy) >= BEARING_LEAST_M and math.hypot(x, y) >= BEARING_LEVEL
    return abs(math.atan2(math.sin(turn), math.cos(turn))), clear


def bearings(facts: Measured, object_id: int, others: Iterable[int]) -> Iterable[Bearing]:
    """Bearings of other things that are, or may be, in the same room."""
    body = facts.bodies[object_id]
    for other in others:
        together = same_room(facts.room_ids(object_id), facts.room_ids(other))
        if other != object_id and together != NO:
            angle, clear = bearing(body, facts.bodies[other])
            yield Bearing(other, angle, clear, together)


def facing(facts: Measured, object_id: int) -> Iterable[Related]:
    """What is looked at, or sat at, before something that can be sat on."""
    if object_id not in facts.having("SITTABLE"):
        return
    looked_at, body = facts.having("LOOKABLE"), facts.bodies[object_id]
    others = (*looked_at, *(k for k in facts.having("SAT_AT") if k not in looked_at))
    for found in bearings(facts, object_id, others):
        ahead = FACING_RAD.less(found.angle_rad)
        ahead = Kleene(ahead.value, ahead.sure and found.clear)
        evidence = {"facing_deg": math.degrees(found.angle_rad)}
        parts = [found.together, ahead]
        if found.target_id not in looked_at:
            other = facts.bodies[found.target_id]
            gap = float(gaps(body.low, body.high, other.low[None], other.high[None])[0])
            parts.append(SAT_AT_M.less(gap))
            evidence["gap_m"] = gap
        yield from _related(facts, found.target_id, all_of(parts), evidence)


def under(facts: Measured, object_id: int) -> Iterable[Related]:
    """Built-in things with a surface over the object, unless it is inside something or on them."""
    body = facts.bodies[object_id]
    free = [Kleene(r.holds, r.sure).negated() for r in facts.inside(object_id)]
    on = {r.target_id: Kleene(r.holds, r.sure) for r in facts.on(object_id)}
    ids, tops, boxes = facts.roofs
    room = tops - body.high[2]
    over = room > UNDER_M.below
    over &= (boxes[:, 0] <= body.high[0]) & (boxes[:, 2] >= body.low[0])
    over &= (boxes[:, 1] <= body.high[1]) & (boxes[:, 3] >= body.low[1])
    for index in np.flatnonzero(over):
        other = facts.bodies[ids[index]]
        if other is body:
            continue
        off = on.get(ids[index], NO).negated()
        share, below = body.covered_by(other.trunk), float(room[index])
        level = facts.supports.over(ids[index], float(body.high[2]))
        holds = all_of((*free, off, level, UNDER_SHARE.more(share)))
        measured = {"overlap": min(share, 1.0), "below_m": below}
        yield from _related(facts, ids[index], holds, measured)


def _related(
    facts: Measured, target: int, holds: Kleene, evidence: Mapping[str, float]
) -> Iterable[Related]:
    if holds != NO:
        yield Related(target, facts.category(target), *holds, evidence)
