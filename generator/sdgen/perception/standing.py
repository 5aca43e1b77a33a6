"""What stands on what, where the pictures leave it open: nothing floats.

A thing whose lower end is hidden goes on down to the highest surface below it; one whose lower end
is seen a little above a surface stands on that; one that is seen to end within a piece of furniture
where no surface was made out stands on a board that no camera looks at from above.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
import shapely
from shapely.geometry.base import BaseGeometry

from sdgen.geometry import Array
from sdgen.perception.levels import Level
from sdgen.perception.things import Piece, Thing

#: What is seen to end so little above a surface, metres, stands on it: a pixel or two.
TOUCHES_M = 0.03
#: So far a surface may seem to lie above the lower end of what stands on it, metres.
SUNK_M = 0.015
#: Of its outline, what stands on something has so much over it.
SHARE = 0.5
#: What hides behind the things on it is more of a surface than is seen: so far about, metres.
ABOUT_M = 0.12
#: And so far from all that is seen of it a thing may still stand on it that can stand nowhere else.
FAR_M = 0.4
#: A board's edge hides so much, metres, of what stands on it above the camera.
EDGE_M = 0.04
#: Nothing is flatter, metres.
LEAST_M = 0.001
#: Things may be so much taller than the tallest model of their class, metres.
TALLER_M = 0.02


def settle(things: Mapping[int, Thing]) -> None:
    """Let everything stand on something; things are changed in place, lowest first."""
    for thing in things.values():
        _finish_top(thing)
    order = sorted(things.values(), key=lambda t: (not t.fixed, t.body.low, t.id))
    owners = [t for t in order if t.kind.carries and t.upright]
    boxes = np.array([t.body.outline.bounds for t in owners]).reshape(-1, 4)
    boxes += (-FAR_M, -FAR_M, FAR_M, FAR_M)
    for thing in order:
        if not (thing.kind.hung or thing.opening):
            _settle(thing, _about(thing, owners, boxes))


def _finish_top(thing: Thing) -> None:
    """What is flat at the top is so all over, whether a camera looks down on it or not."""
    body = thing.body
    if not (thing.kind.flat and thing.upright):
        return
    top = next((level.z_m for level in thing.levels if body.high - level.z_m < EDGE_M), body.high)
    rest = [level for level in thing.levels if level.z_m < top]
    thing.levels = [Level(top, body.outline), *rest]


def _about(thing: Thing, owners: Sequence[Thing], boxes: Array) -> list[Thing]:
    """What a thing may stand on: furniture, and loose things that begin lower."""
    x0, y0, x1, y1 = thing.body.outline.bounds
    near = (boxes[:, 0] <= x1) & (boxes[:, 2] >= x0) & (boxes[:, 1] <= y1) & (boxes[:, 3] >= y0)
    found = [owners[k] for k in np.flatnonzero(near).tolist() if owners[k] is not thing]
    return [
        owner
        for owner in found
        if (owner.fixed or not thing.fixed)
        and (owner.body.low, owner.id) < (thing.body.low + SUNK_M, thing.id)
    ]


def _settle(thing: Thing, owners: Sequence[Thing]) -> None:
    body = thing.body
    # Below this no thing of its class reaches, as it lies.
    lowest = body.high - _tallest(thing) - TALLER_M
    hidden = not thing.ends or thing.fixed
    found = None
    for about in (0.0, ABOUT_M):
        below = [owner for owner in owners if _over(body.outline, owner.body.outline, about)]
        found = found or _carrier(body, below, lowest, hidden, about)
    if found is None and hidden and lowest > TOUCHES_M:
        # Too short to stand on the floor: on what is next to it, the rest of which is hidden.
        found = _nearest(body, owners, lowest)
    z = 0.0 if found is None else found[1].z_m
    if body.low - z <= TOUCHES_M or (hidden and z >= lowest):
        body.low = min(z, body.high - LEAST_M)
        if found is not None:
            _grow(*found, body)
    elif not thing.fixed:
        # It ends in the air: on a board that no camera looks down on, or it hangs.
        around = [t for t in below if t.fixed and t.body.low - SUNK_M <= body.low <= t.body.high]
        if around:
            board = min(around, key=lambda t: t.body.outline.area)
            board.levels.append(Level(body.low, _joined(board.body.outline, body.outline)))


def _tallest(thing: Thing) -> float:
    size = thing.kind.largest
    return float(size[2] if thing.upright else np.linalg.norm(size))


def _carrier(
    body: Piece, owners: Sequence[Thing], lowest: float, hidden: bool, about: float
) -> tuple[Thing, Level] | None:
    """The surface that a thing stands on: the one at its lower end or, where that may be hidden,
    the highest below it."""
    found = []
    for owner in owners:
        # The top of what nobody looks down on is where its sides end.
        top = Level(owner.body.high, owner.body.outline)
        tops = [top] if abs(body.low - top.z_m) <= EDGE_M else []
        for level in (*owner.levels, *tops):
            if lowest <= level.z_m <= body.low + SUNK_M and _over(
                body.outline, level.outline, about
            ):
                found.append((owner, level))
    near = [one for one in found if body.low - one[1].z_m <= TOUCHES_M]
    if near and not hidden:
        return min(near, key=lambda one: (round(abs(one[1].z_m - body.low), 3), -one[1].z_m))
    return max(found, key=lambda one: one[1].z_m, default=None)


def _nearest(body: Piece, owners: Sequence[Thing], lowest: float) -> tuple[Thing, Level] | None:
    """The surface next to a thing, of furniture, that it may stand on."""
    found = [
        (float(shapely.distance(level.outline, body.outline)), -level.z_m, owner, level)
        for owner in owners
        if owner.fixed
        for level in owner.levels
        if lowest <= level.z_m <= body.low + SUNK_M
    ]
    near = [one for one in found if one[0] <= FAR_M]
    return min(near, key=lambda one: one[:2])[2:] if near else None


def _grow(owner: Thing, level: Level, body: Piece) -> None:
    """A surface reaches as far as what stands on it does."""
    whole = Level(level.z_m, _joined(level.outline, body.outline))
    rest = [other for other in owner.levels if other is not level]
    owner.levels = [*rest, whole]


def _joined(one: BaseGeometry, other: BaseGeometry) -> BaseGeometry:
    return one if one.covers(other) else shapely.convex_hull(shapely.union_all([one, other]))


def _over(upper: BaseGeometry, lower: BaseGeometry, about: float) -> bool:
    """One outline lies over another, of which the part ``about`` it may be hidden; or the other, of
    which little is seen, lies under it."""
    shared = upper.intersection(lower.buffer(about, quad_segs=2) if about else lower).area
    return bool(shared > SHARE * min(upper.area, lower.area))
