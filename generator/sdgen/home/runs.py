"""Kitchens: runs of units are drawn, told good from bad by rules of thumb of those who plan
kitchens, and the best that finds a place is taken.
"""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np
from shapely.geometry import Polygon

from sdgen.catalog.records import FurnitureRule
from sdgen.home import anchors
from sdgen.home.anchors import Side
from sdgen.home.room_try import RoomTry, with_placed
from sdgen.home.run_shapes import DEPTH_M, STRAIGHT, TALL_M, TURNING, Leg, Run, Walls, spots
from sdgen.library.records import Asset

#: Bound the search: runs drawn of a shape, some of them as short as may be, for small kitchens; and
#: of these, the best first, tried in the room.
DRAWN, SHORT, TRIED = 20, 6, 16
#: As narrow as the narrowest are models this little wider.
NARROW_M = 0.05
#: How often each shape is tried first, where the room has corners and a corner unit: by eye.
SHAPES = {"corner": 0.4, "wall": 0.15, "galley": 0.1, "u": 0.35}
#: Where none of these finds a place.
APART = ("apart", "apart_corner")
#: How often what comes after a tall first unit is the other way round.
TURNED_CHANCE = 0.4
#: How often each extra unit of a rule is asked for.
EXTRA_CHANCE = 0.7
#: A sink this near the middle of a window, along the wall, is at it.
AT_WINDOW_M = 0.5
#: A hood over a stove is so deep, and takes at least the heights from here to there.
HOOD_DEEP_M, HOOD_M = 0.5, (1.6, 1.85)
#: What a metre more of worktop is worth, up to so many; what else is, or costs, in metres.
WORKTOP_WORTH, WORKTOP_MOST_M = 0.35, 4.5
SINK_AT_WINDOW, NO_HOOD, NO_TOP_BESIDE_STOVE = -1.2, 4.0, 0.8
#: Where a leg of low units ends in the open, and where any leg ends beside a doorway.
OPEN_END, END_AT_DOOR = 0.35, 0.5
#: A dishwasher stands in the leg of the sink.
DISHWASHER, SPLIT_FROM_SINK = -0.3, 0.8
#: Each shape less wished for than the one before it.
LESS_WISHED = 0.4
#: What chance makes of these (one sigma): not every kitchen is planned alike.
CHANCE = 0.3


def with_row(rule: FurnitureRule, tried: RoomTry) -> RoomTry | None:
    """The room with units side by side against one wall, either way round."""
    return _best(rule, {"wall": 0.0}, tried)


def with_run(rule: FurnitureRule, tried: RoomTry) -> RoomTry | None:
    """The room with a run of units of some shape, with what extra units find a place."""
    names = list(SHAPES)
    weights = np.array([SHAPES[name] for name in names])
    order = tried.rng.choice(len(names), len(names), replace=False, p=weights / weights.sum())
    wished = {names[k]: LESS_WISHED * number for number, k in enumerate(order.tolist())}
    return _best(rule, wished, tried) or _best(rule, dict.fromkeys(APART, 0.0), tried)


def _best(rule: FurnitureRule, shapes: Mapping[str, float], tried: RoomTry) -> RoomTry | None:
    """The room with the best of some runs of these shapes that finds a place; what speaks against
    each shape."""
    walls = Walls.of(tried)
    runs = []
    for shape, against in shapes.items():
        for number in range(DRAWN):
            run = _drawn(rule, shape, walls, number < SHORT)
            if run is not None:
                chance = float(tried.rng.normal(0.0, CHANCE))
                runs.append((against + _cost(run, walls) + chance, run))
    runs.sort(key=lambda pair: pair[0])
    for _, run in runs[:TRIED]:
        made = _with(rule, run, tried)
        if made is not None:
            return made
    return None


def _drawn(rule: FurnitureRule, shape: str, walls: Walls, short: bool) -> Run | None:
    """A run of a shape, of models and at walls drawn at random (``short``: without extra units,
    of the narrowest models); None where it is too long."""
    rng = walls.tried.rng
    extra = () if short else tuple(c for c in rule.extra if rng.random() < EXTRA_CHANCE)
    units = []
    for category in (*rule.row, *extra):
        found = walls.tried.models(category)
        if not found:
            return None
        if short:
            least = min(m.extents_m[1] for m in found)
            found = tuple(m for m in found if m.extents_m[1] < least + NARROW_M)
        units.append(found[int(rng.integers(len(found)))])
    if rule.where == "run" and rng.random() < TURNED_CHANCE:
        # A fridge at its beginning stays there, by the sink then.
        units[1:] = units[:0:-1]
    if rng.random() < 0.5:
        units.reverse()
    if shape in STRAIGHT:
        return STRAIGHT[shape](units, walls)
    corners = walls.tried.models(rule.corner) if rule.corner else ()
    if not corners:
        return None
    return TURNING[shape](units, corners[int(rng.integers(len(corners)))], walls)


def _cost(run: Run, walls: Walls) -> float:
    """What speaks against a run, in metres of worktop; below 0: for it."""
    tried = walls.tried
    total = 0.0
    worktop = sum(2 * corner.extents_m[1] - DEPTH_M for corner, _ in run.corners)
    for number, leg in enumerate(run.legs):
        windows = walls.windows[leg.wall]
        # Beside each unit: another, or the corner unit that the leg joins.
        before = 0 < number <= len(run.corners)
        after = number < len(run.corners)
        total += _ends_cost(leg, before, after, walls)
        topped = [before, *(unit.extents_m[2] <= TALL_M for unit in leg.units), after]
        traits = [tried.catalog.category(unit.category).properties for unit in leg.units]
        wet = any("WATER_SOURCE" in its for its in traits)
        for i, (unit, middle) in enumerate(spots(leg, tried)):
            off = min((abs(t - middle) for t, _ in windows), default=math.inf)
            if "HEAT_SOURCE" in traits[i]:
                total += 0.0 if _has_hood(leg.side, unit, middle, tried) else NO_HOOD
                total += NO_TOP_BESIDE_STOVE * (2 - topped[i] - topped[i + 2])
            elif topped[i + 1]:
                worktop += unit.extents_m[1]
            if "WATER_SOURCE" in traits[i] and off < AT_WINDOW_M:
                total += SINK_AT_WINDOW
            if unit.category == "dishwasher":
                total += DISHWASHER if wet else SPLIT_FROM_SINK
    return total - WORKTOP_WORTH * min(worktop, WORKTOP_MOST_M)


def _ends_cost(leg: Leg, before: bool, after: bool, walls: Walls) -> float:
    """What speaks against the ends of a leg, but those ``before`` and ``after`` it that join a
    corner unit."""
    last, middle = list(spots(leg, walls.tried))[-1]
    ends = [] if before else [(leg.units[0], leg.start_m)]
    ends += [] if after else [(last, middle + last.extents_m[1] / 2)]
    total = 0.0
    for unit, at_m in ends:
        total += END_AT_DOOR if walls.at_doorway(leg.wall, at_m) else 0.0
        open_end = unit.extents_m[2] <= TALL_M and not walls.in_corner(leg.wall, at_m)
        total += OPEN_END if open_end else 0.0
    return total


def _has_hood(side: Side, stove: Asset, middle_m: float, tried: RoomTry) -> bool:
    """Whether a hood over a stove hides no window."""
    half = stove.extents_m[1] / 2
    ends = (middle_m - half, middle_m + half)
    near, far = ([side.at(t, off) for t in ends] for off in (0.0, HOOD_DEEP_M))
    shape = Polygon([*near, *far[::-1]])
    return not any(sight.hidden_by(shape, *HOOD_M) for sight in tried.sights)


def _with(rule: FurnitureRule, run: Run, tried: RoomTry) -> RoomTry | None:
    """The room with all units of a run; None when one of them finds no place."""
    # Before a corner unit stand its neighbours.
    joint = rule.model_copy(update={"front_m": 0.0})
    at_walls = [(joint, corner, at) for corner, at in run.corners]
    for leg in run.legs:
        for unit, middle in spots(leg, tried):
            back = anchors.back_gap(tried.layout.library.reach(unit.id))
            spot = leg.side.at(middle, unit.extents_m[0] / 2 + back)
            at_walls.append((rule, unit, (*spot, 0.0, leg.side.yaw)))
    # The tallest first: a fridge before a window fails soonest.
    at_walls.sort(key=lambda spot: -spot[1].extents_m[2])
    for its_rule, unit, at in at_walls:
        more = with_placed(its_rule, unit, at, None, tried)
        if more is None:
            return None
        tried = more
    return tried
