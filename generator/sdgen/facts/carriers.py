"""What carries a thing, however indirectly: the plate under the cup, and the table under both.

What is fixed carries itself: nothing is on the floor because the table it is on stands there.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import NamedTuple, Protocol

from sdgen.catalog.predicate import Related
from sdgen.facts.body import Body
from sdgen.kleene import NO, YES, Kleene, all_of, any_of


class Carrier(NamedTuple):
    """Whether something carries a thing by what is on it, and by what is in it."""

    on: Kleene = NO
    inside: Kleene = NO

    @property
    def either(self) -> Kleene:
        """It carries the thing, in whichever way."""
        return any_of((self.on, self.inside))


class Holding(Protocol):
    """What is asked of the measured scene."""

    @property
    def bodies(self) -> Mapping[int, Body]:
        """Bodies by id."""
        ...

    def on(self, object_id: int) -> Iterable[Related]:
        """What a thing is ON, or nearly."""
        ...

    def inside(self, object_id: int) -> Iterable[Related]:
        """What a thing is INSIDE, or nearly."""
        ...


def carriers_of(facts: Holding, object_id: int) -> dict[int, Carrier]:
    """By id all that carries a thing, or may: what it is ON or INSIDE and, where that is loose,
    what carries that. Two things may each be in the other's hollow (bowls in a stack): a carrier is
    looked at again only as long as it is more surely one."""
    found: dict[int, Carrier] = {}
    todo = [(object_id, YES)]
    while todo:
        key, so_far = todo.pop()
        links = [(r, True) for r in facts.on(key)] + [(r, False) for r in facts.inside(key)]
        for related, on in links:
            other = related.target_id
            holds = all_of((so_far, Kleene(related.holds, related.sure)))
            if holds == NO or other == object_id:
                continue
            before = found.get(other, Carrier())
            if on:
                after = before._replace(on=any_of((before.on, holds)))
            else:
                after = before._replace(inside=any_of((before.inside, holds)))
            if after != before:
                found[other] = after
                body = facts.bodies.get(other)
                if body is not None and not body.item.fixed:
                    todo.append((other, after.either))
    return found
