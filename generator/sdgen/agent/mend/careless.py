"""The planner that tidies up and never asks who lives there."""

from __future__ import annotations

from collections.abc import Iterable

from sdgen.agent.mend.hands import Hands
from sdgen.agent.mend.mending import Mending
from sdgen.agent.mend.planning import Left, carries, cupboards, in_order, why_left
from sdgen.agent.mend.records import Pair


def careless_planner(
    mending: Mending, pairs: Iterable[Pair] | None = None, shuts: bool = False
) -> tuple[Left, ...]:
    """Switches off, shuts and wipes up as it should, but puts each thing away in or on the nearest
    piece of furniture where such things could be kept, whoever lives there; leaves stay open behind
    it unless it ``shuts`` them."""
    left = []
    for pair in in_order(mending, pairs):
        since = len(mending.outcomes)
        if pair in mending.pairs and not _tidied(mending, pair, shuts):
            left.append(Left(pair, why_left(mending, since)))
    return tuple(left)


def _tidied(mending: Mending, pair: Pair, shuts: bool) -> bool:
    key, hazard = pair
    hands = Hands(mending)
    for rule in mending.setting.catalog.hazard(hazard).remedy:
        if not carries(rule):
            return hands.at(key) and hands.do(rule.action, key)
    under = hands.under(key)
    if not hands.fetch(key):
        return False
    for target in hands.nearest(_kept_in(mending, pair), key):
        if target != under and (
            hands.store(key, target, shuts)
            or (hands.at(target, True) and hands.do("put_on", key, target))
        ):
            return True
    hands.lay_down(under)
    return False


def _kept_in(mending: Mending, pair: Pair) -> list[str]:
    """The furniture that such things are kept in or on, by anybody."""
    catalog = mending.setting.catalog
    category = mending.start.facts.category(pair[0])
    rules = catalog.hazard(pair[1]).remedy
    abodes = (t for abode in catalog.category(category).lives for t in abode.targets)
    return sorted({*abodes, *(t for rule in rules for t in rule.targets), *cupboards(mending)})
