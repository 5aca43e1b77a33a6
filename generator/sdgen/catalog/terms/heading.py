"""What ``facing`` and ``facing_away`` share: the angle between the object's front and the direction
to the centre of something in its room, seen from above."""

from __future__ import annotations

import math
from abc import abstractmethod
from collections.abc import Iterable
from typing import ClassVar

from sdgen.catalog.predicate import Bearing, Evidence, FactSource, Verdict, any_verdict, rounded
from sdgen.catalog.terms.term import Term
from sdgen.kleene import Kleene, all_of


class HeadingTerm(Term):
    """A limit on that angle, kept towards some thing of the categories asked for."""

    #: What evidence calls the angle, and the thing.
    angle_name: ClassVar[str]
    thing_name: ClassVar[str]
    #: Whether the largest angle is the one that counts.
    widest: ClassVar[bool]

    @property
    @abstractmethod
    def towards(self) -> tuple[str, ...]:
        """The categories of what is faced, or not."""

    @abstractmethod
    def keeps(self, angle_deg: float) -> Kleene:
        """Whether an angle keeps the limit."""

    def evaluate(self, object_id: int, facts: FactSource) -> Verdict:
        return any_verdict(self._to(found) for found in self._best_first(object_id, facts))

    def _to(self, found: Bearing) -> Verdict:
        kept = self.keeps(math.degrees(found.angle_rad))
        kept = Kleene(kept.value, kept.sure and found.clear)
        value, sure = all_of((found.together, kept))
        return Verdict(value, sure, self._evidence(found) if value else {})

    def _best_first(self, object_id: int, facts: FactSource) -> Iterable[Bearing]:
        found = facts.bearings(object_id, self.towards)
        sign = -1.0 if self.widest else 1.0
        return sorted(found, key=lambda one: (sign * one.angle_rad, one.target_id))

    def measure(self, object_id: int, facts: FactSource) -> Evidence:
        return next(map(self._evidence, self._best_first(object_id, facts)), {})

    def _evidence(self, found: Bearing) -> Evidence:
        angle = rounded(math.degrees(found.angle_rad))
        return {self.angle_name: angle, self.thing_name: found.target_id}
