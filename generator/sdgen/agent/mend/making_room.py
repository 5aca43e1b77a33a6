"""Room made in something full: one thing less is in it, and lies where such things lie."""

from __future__ import annotations

from sdgen.agent.mend.hands import Hands
from sdgen.agent.mend.records import Pair
from sdgen.hazards.remedies import goes_on

#: So many things are tried, the largest first, and for each so many places.
THINGS_TRIED, PLACES_TRIED = 3, 4


def room_made(
    hands: Hands, key: int, target: int, under: int | None, may_hold: frozenset[Pair]
) -> bool:
    """Whether what is in the hand (``key``) went into a target after something was taken out of it;
    if not, it is in the hand again.

    Meanwhile it lies on what it was ``under``, or aside. No pairs but those that ``may_hold`` come
    about.
    """
    for other in _contents(hands, target)[:THINGS_TRIED]:
        if not hands.lay_down(under):
            return False
        moved = hands.fetch(other) and _put_where_it_lies(hands, other, may_hold)
        if hands.mending.in_hand == other and not hands.store(other, target):
            hands.lay_down()
        if not hands.fetch(key):
            return False
        if moved and hands.store(key, target):
            return True
    return False


def _contents(hands: Hands, target: int) -> list[int]:
    facts = hands.mending.facts
    inside = [
        (-body.footprint.area, key)
        for key, body in facts.bodies.items()
        if not body.item.fixed
        and any(r.holds and r.target_id == target for r in facts.inside(key))
        and not hands.on_top(key)
        and _usual(hands, body.item.category)
    ]
    return [key for _, key in sorted(inside)]


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
