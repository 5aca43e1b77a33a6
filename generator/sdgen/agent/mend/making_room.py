"""Room made in something full: one thing less is in it, and lies where such things lie."""

from __future__ import annotations

from sdgen.agent.mend.hands import Hands
from sdgen.agent.mend.records import Pair
from sdgen.hazards.remedies import goes_on

#: For what is taken out so many places are tried.
PLACES_TRIED = 4


def in_the_way(hands: Hands, target: int) -> list[int]:
    """The things in a target, the largest first, that lie elsewhere in this home, too, and without
    which there would be room in it for what is in the hand."""
    facts = hands.mending.facts
    inside = [
        (-body.footprint.area, key)
        for key, body in facts.bodies.items()
        if not body.item.fixed
        and any(r.holds and r.target_id == target for r in facts.inside(key))
        and not hands.on_top(key)
        and _usual(hands, body.item.category)
    ]
    return [key for _, key in sorted(inside) if hands.fits(target, "put_in", key)]


def room_made(
    hands: Hands,
    key: int,
    target: int,
    other: int,
    under: int | None,
    may_hold: frozenset[Pair],
) -> bool:
    """Whether what is in the hand (``key``) went into a target after an ``other`` thing was taken
    out of it; if not, it is in the hand again.

    Meanwhile it lies on what it was ``under``, or aside. No pairs but those that ``may_hold`` come
    about.
    """
    if not hands.lay_down(under):
        return False
    moved = hands.fetch(other) and _put_where_it_lies(hands, other, may_hold)
    if hands.mending.in_hand == other and not hands.store(other, target):
        hands.lay_down()
    return hands.fetch(key) and moved and hands.store(key, target)


def _usual(hands: Hands, category: str) -> list[str]:
    """The furniture of this home that such things lie on."""
    mending = hands.mending
    there = {body.item.category for body in mending.facts.bodies.values() if body.item.fixed}
    return [name for name in sorted(there) if goes_on(mending.setting.catalog, category, name)]


def _put_where_it_lies(hands: Hands, other: int, may_hold: frozenset[Pair]) -> bool:
    mending = hands.mending
    held = mending.state.held
    if held is None:
        return False
    for place in hands.nearest(_usual(hands, held.item.category), other)[:PLACES_TRIED]:
        if not (hands.at(place, nearest=True) and hands.do("put_on", other, place)):
            continue
        if frozenset(mending.pairs) <= may_hold:
            return True
        if not hands.do("grab", other):
            return False
    return False
