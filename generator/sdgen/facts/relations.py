"""The registry of relations: a name of the vocabulary -> how its candidates are found.

A candidate that surely does not hold is left out; one within a margin is there, unsure.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable

from sdgen.catalog.predicate import Related
from sdgen.facts import spatial
from sdgen.facts.measured import Measured


def _on(facts: Measured, object_id: int) -> Iterable[Related]:
    return facts.on(object_id)


def _inside(facts: Measured, object_id: int) -> Iterable[Related]:
    return facts.inside(object_id)


def _between(facts: Measured, object_id: int) -> Iterable[Related]:
    return facts.rooms.between(object_id)


def _blocks(facts: Measured, object_id: int) -> Iterable[Related]:
    body = facts.bodies[object_id]
    for target, holds in facts.zone_index.blocks(body, facts.zones(object_id)).items():
        yield Related(target, facts.category(target), *holds)


def _near(relation: str) -> Callable[[Measured, int], Iterable[Related]]:
    def find(facts: Measured, object_id: int) -> Iterable[Related]:
        for target, near in facts.zone_index.near(facts.bodies[object_id], relation).items():
            yield Related(target, facts.category(target), *near.holds, {"gap_m": near.gap_m})

    return find


FINDERS: dict[str, Callable[[Measured, int], Iterable[Related]]] = {
    "ON": _on,
    "INSIDE": _inside,
    "BETWEEN": _between,
    "CLOSE": spatial.close,
    "FACING": spatial.facing,
    "UNDER": spatial.under,
    "BLOCKS": _blocks,
    "NEAR_HEAT": _near("NEAR_HEAT"),
    "NEAR_WATER": _near("NEAR_WATER"),
}
