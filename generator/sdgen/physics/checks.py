"""Plausibility checks: nothing penetrates, nothing floats. A world in, violations out."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence

import numpy as np

from sdgen.facts.thresholds import ON_GAP_M
from sdgen.physics.client import ContactPoint
from sdgen.physics.world import Placed, World
from sdgen.scene import Violation

#: Twice what 16 built scenes had at most: 2 mm, hulls of furniture that reach below their feet;
#: things at rest had less than half a millimetre.
PENETRATION_LIMIT_M = 0.004
#: Up to here a thing is ON another; in 16 scenes all loose things had something within 1 mm.
GAP_LIMIT_M = ON_GAP_M.limit


def penetrations(
    world: World, ids: Collection[int] | None = None, limit_m: float = PENETRATION_LIMIT_M
) -> list[Violation]:
    """Pairs that overlap by more than ``limit_m``, deepest of each pair, sorted by ids.

    Everything is tested against everything, furniture against furniture, walls, doors and windows
    too, by the convex pieces of what is drawn, joints applied. Two exceptions: floors, walls and
    ceilings are not tested against one another, and furniture presses into the rug it stands on
    (a fixed thing no thicker than ``PRESSED_M``); the leaf of a door does not. ``ids`` restricts to
    pairs with one of these objects.
    """
    deepest: dict[tuple[int, int], float] = {}
    # No overlap is deeper than that of the boxes; Bullet's skin may add a fraction of a millimetre.
    for a, b, points in _closest(world, ids, -limit_m / 2, 0.0):
        for point in points:
            key = (min(a.owner, b.owner), max(a.owner, b.owner))
            deepest[key] = max(deepest.get(key, 0.0), -point.distance_m)
    return [
        Violation(check="penetrates", objects=pair, measured=round(depth, 6), limit=limit_m)
        for pair, depth in sorted(deepest.items())
        if depth > limit_m
    ]


def unsupported(
    world: World, ids: Collection[int] | None = None, gap_m: float = GAP_LIMIT_M
) -> list[Violation]:
    """Things that are not fixed and have nothing under them within ``gap_m``.

    ``measured`` is 1.0: nothing was near.
    """
    held: set[int] = set()
    for a, b, points in _closest(world, ids, gap_m, gap_m):
        for point in points:
            up = point.normal_on_b[2]
            if up > 0.5:
                held.add(a.owner)
            elif up < -0.5:
                held.add(b.owner)
    checked = {
        one.owner
        for one in world.placed
        if one.item is not None and not one.item.fixed and (ids is None or one.owner in ids)
    }
    return [
        Violation(check="unsupported", objects=(key,), measured=1.0, limit=gap_m)
        for key in sorted(checked - held)
    ]


def _closest(
    world: World, ids: Collection[int] | None, near_m: float, reach_m: float
) -> Iterator[tuple[Placed, Placed, Sequence[ContactPoint]]]:
    """Closest points within ``reach_m`` of every pair whose boxes come within ``near_m``."""
    for a, b in _near_pairs(world.placed, ids, near_m):
        yield a, b, world.client.closest(a.body, b.body, reach_m)


def _near_pairs(
    bodies: list[Placed], ids: Collection[int] | None, gap_m: float
) -> list[tuple[Placed, Placed]]:
    """Pairs of different owners whose boxes come within ``gap_m`` (negative: overlap by more), in
    a fixed order; none of the shell alone, and no furniture with the rug under it."""
    if not bodies:
        return []
    low = np.array([b.bounds[0] for b in bodies]) - gap_m
    high = np.array([b.bounds[1] for b in bodies])
    owner = np.array([b.owner for b in bodies])
    shell = np.array([b.shell for b in bodies])
    covering = np.array([b.covering for b in bodies])
    heavy = np.array([b.heavy for b in bodies])
    pressed = covering[:, None] & heavy
    wanted = np.isin(owner, np.array(sorted(ids if ids is not None else set(owner.tolist()))))
    near = (owner[:, None] != owner) & (wanted[:, None] | wanted)
    near &= ~(shell[:, None] & shell) & ~(pressed | pressed.T)
    for axis in range(3):
        near &= low[:, None, axis] <= high[None, :, axis]
        near &= low[None, :, axis] <= high[:, None, axis]
    return [(bodies[i], bodies[j]) for i, j in np.argwhere(np.triu(near, 1)).tolist()]
