"""The registry of relations: a name of the vocabulary -> how its candidates are found.

A candidate that surely does not hold is left out; one within a margin is there, unsure.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING

from sdgen.catalog.predicate import Related
from sdgen.facts import spatial
from sdgen.kleene import Kleene, any_of

if TYPE_CHECKING:
    from sdgen.facts.front import Facts


def _on(facts: Facts, object_id: int) -> Iterable[Related]:
    inside: dict[int, Kleene] = {}
    for r in facts.related(object_id, "INSIDE"):
        before = inside.get(r.target_id, Kleene(False))
        inside[r.target_id] = any_of((before, Kleene(r.holds, r.sure)))
    return facts.supports.on(facts.bodies[object_id], inside)


def _inside(facts: Facts, object_id: int) -> Iterable[Related]:
    return facts.containers.inside(facts.bodies[object_id])


def _between(facts: Facts, object_id: int) -> Iterable[Related]:
    return facts.rooms.between(object_id)


def _blocks(facts: Facts, object_id: int) -> Iterable[Related]:
    body = facts.bodies[object_id]
    for target, holds in facts.zone_index.blocks(body, facts.zones(object_id)).items():
        yield Related(target, facts.category(target), *holds)


def _near(relation: str) -> Callable[[Facts, int], Iterable[Related]]:
    def find(facts: Facts, object_id: int) -> Iterable[Related]:
        for target, holds in facts.zone_index.near(facts.bodies[object_id], relation).items():
            yield Related(target, facts.category(target), *holds)

    return find


FINDERS: dict[str, Callable[[Facts, int], Iterable[Related]]] = {
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
