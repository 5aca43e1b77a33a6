"""What planners share: in which order anomalies are taken, and why one is left."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import NamedTuple

from sdgen.agent.mend.mending import Mending
from sdgen.agent.mend.records import Pair
from sdgen.catalog.records import RemedyRule
from sdgen.hazards.twin import GONE, SET_BACK


class Left(NamedTuple):
    """An anomaly that a planner could not remove, and why: the last sentence it was told."""

    pair: Pair
    why: str


def in_order(mending: Mending, pairs: Iterable[Pair] | None) -> list[Pair]:
    """These anomalies, or all there are; what is only switched off or shut comes first: things go
    into a fridge that is shut."""
    catalog = mending.setting.catalog
    wanted = mending.start.pairs if pairs is None else pairs

    def key(pair: Pair) -> tuple[bool, Pair]:
        return catalog.hazard(pair[1]).remedy[0].action not in SET_BACK, pair

    return sorted(wanted, key=key)


def why_left(mending: Mending, since: int) -> str:
    """The last refusal since so many actions."""
    told = [one.refused for one in mending.outcomes[since:] if one.refused is not None]
    return told[-1] if told else "nothing in this home takes it"


def carries(rule: RemedyRule) -> bool:
    """Whether a remedy takes the thing elsewhere."""
    return rule.action not in (*SET_BACK, *GONE)


def cupboards(mending: Mending) -> Iterator[str]:
    """All that has a hollow with a leaf before it."""
    for body in mending.start.facts.bodies.values():
        if body.item.fixed and any(hollow.closed_by for hollow in body.info.containers):
            yield body.item.category
