"""How high a thing is for a child: above the floor, or above what it can climb on beside it.

Children climb onto couches and chairs without help by 18 months (CDC, developmental milestones).
The catalogue says what is climbed on, and about how high one stands there (``climb_m``); a model
with a surface of its own at about that height says how high exactly.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping
from typing import NamedTuple

from sdgen.catalog.predicate import ReachHeight
from sdgen.facts.body import Body, gaps, rows
from sdgen.facts.rooms import same_room
from sdgen.facts.thresholds import CLIMB_NEAR_M
from sdgen.geometry import Array
from sdgen.kleene import NO, Kleene, all_of

#: A surface this far from ``climb_m`` is another one than what one stands on, metres: models of a
#: category differ by less (shipped: a stool of 0.64 m where most have 0.45 m), the cistern over a
#: toilet's lid and the shelf below a bench are further off.
OWN_TOP_M = 0.25


class _Near(NamedTuple):
    """Something climbed on that may be near: where one stands, and whether it is near."""

    stand_m: float
    id: int
    holds: Kleene


class Climbs:
    """What children climb on in a scene. ``climbs`` maps a category to about how high one stands on
    it, metres above its bottom."""

    def __init__(self, bodies: Iterable[Body], climbs: Mapping[str, float]) -> None:
        found = [body for body in bodies if body.item.category in climbs]
        self._ids = [body.item.id for body in found]
        self._stand = [_stand_m(body, climbs[body.item.category]) for body in found]
        self._low = rows([body.low[:2] for body in found], 2)
        self._high = rows([body.high[:2] for body in found], 2)

    def heights(
        self, low: Array, high: Array, rooms: Mapping[int, Collection[int]], own: int
    ) -> ReachHeight:
        """The heights of a box (3,), (3,) that is object ``own``'s. ``rooms`` says which rooms
        that and each thing climbed on may be in."""
        height = float(low[2])
        near = list(self._near(low, high, rooms, own))
        measured = max((n for n in near if n.holds.value), default=None)
        surely = max((n.stand_m for n in near if n.holds.value and n.holds.sure), default=0.0)
        perhaps = max((n.stand_m for n in near), default=0.0)
        return ReachHeight(
            height_m=height,
            above_m=height - (measured.stand_m if measured else 0.0),
            least_m=height - perhaps,
            most_m=height - surely,
            climbed_id=measured.id if measured else None,
        )

    def _near(
        self, low: Array, high: Array, rooms: Mapping[int, Collection[int]], own: int
    ) -> Iterator[_Near]:
        """What stands near enough to a box and lower than it: for what lies lower than a seat one
        need not climb."""
        if not self._ids:
            return
        apart = gaps(low[:2], high[:2], self._low, self._high).tolist()
        for gap, stand, other in zip(apart, self._stand, self._ids, strict=True):
            if other == own or gap >= CLIMB_NEAR_M.above or stand > low[2]:
                continue
            together = same_room(rooms[own], rooms[other])
            holds = all_of((together, CLIMB_NEAR_M.at_most(gap)))
            if holds != NO:
                yield _Near(stand, other, holds)


def _stand_m(body: Body, climb_m: float) -> float:
    """How high above the floor one stands on a thing: on its level surface that is nearest to
    ``climb_m`` above its bottom, or just there where it has none that is near."""
    about = float(body.low[2]) + climb_m
    nearest = min((s.z_m for s in body.surfaces), key=lambda z: abs(z - about), default=about)
    return nearest if abs(nearest - about) <= OWN_TOP_M else about
