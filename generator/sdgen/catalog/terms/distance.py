"""``distance: {to: [stove], to_state: ON, max_m: 0.5}``: how near the nearest such thing is.

``to_zone: [heat, water]`` in place of ``to`` asks for the nearest such zone.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Literal, NamedTuple

from sdgen.catalog.predicate import Evidence, FactSource, Verdict, rounded
from sdgen.catalog.reader import Reader
from sdgen.catalog.terms.limits import limits_in_words, read_limits
from sdgen.catalog.terms.state import of_state
from sdgen.catalog.terms.term import Scope, Term, either
from sdgen.kleene import NO, YES, Kleene, all_of, any_of, at_least, at_most
from sdgen.vocabulary import ZONE_KINDS

#: Gaps are between axis-aligned boxes, which a turn of a degree or two changes by centimetres.
MARGIN_M = 0.05


class _Near(NamedTuple):
    """A thing or a zone, and how far off it is. ``counts`` says what is known of whether it is
    asked for; ``source_id`` is the thing whose state and room further decide."""

    gap_m: float
    evidence: Evidence
    source_id: int | None
    counts: Kleene = YES


class DistanceTerm(Term):
    """Gap between the object's box and the nearest object of one of these categories (between their
    outlines, where it is seen from above), or between its footprint and the nearest zone."""

    kind: Literal["distance"] = "distance"
    to: tuple[str, ...] = ()
    to_zone: tuple[str, ...] = ()
    to_state: str | None = None
    from_above: bool = False
    same_room: bool = False
    min_m: float | None = None
    max_m: float | None = None
    margin_m: float = MARGIN_M

    @classmethod
    def read(cls, reader: Reader, scope: Scope) -> DistanceTerm | None:
        if not reader.has("distance"):
            return None
        below = reader.child("distance")
        low, high, margin = read_limits(below, MARGIN_M)
        zones = below.words("to_zone", (), choices=ZONE_KINDS, what="zone")
        things: tuple[str, ...] = ()
        if below.has("to") or not below.has("to_zone"):
            things = below.words("to", choices=scope.categories, what="category")
        if below.has("to") and below.has("to_zone"):
            below.problem("give either 'to' or 'to_zone'", "to_zone")
        term = cls(
            to=things,
            to_zone=zones,
            to_state=below.state("to_state", None),
            from_above=below.flag("from_above", False),
            same_room=below.flag("same_room", False),
            min_m=low,
            max_m=high,
            margin_m=margin,
        )
        below.done()
        return term

    def evaluate(self, object_id: int, facts: FactSource) -> Verdict:
        """Nothing that counts is nearer than ``min_m``, and something is within ``max_m``. Which
        things count may be undecided, too: those whose state, room or height is."""
        found = self._found(object_id, facts)
        parts = []
        if self.min_m is not None:
            low = self.min_m
            nearer = (at_least(one.gap_m, low, self.margin_m).negated() for one in found)
            parts.append(self._any(nearer, found, object_id, facts).negated())
        if self.max_m is not None:
            high = self.max_m
            within = (at_most(one.gap_m, high, self.margin_m) for one in found)
            parts.append(self._any(within, found, object_id, facts))
        value, sure = all_of(parts)
        return Verdict(value, sure, self.measure(object_id, facts) if value else {})

    def _found(self, object_id: int, facts: FactSource) -> Sequence[_Near]:
        """What it may be near, nearest first."""
        if not self.to_zone:
            gaps = facts.gaps(object_id, self.to, self.from_above)
            return [_Near(gap, {"nearest_id": other}, other) for gap, other in gaps]
        return [
            _Near(
                zone.gap_m,
                {"zone_name": zone.name},
                zone.source_id,
                all_of((zone.level, zone.together)) if self.same_room else zone.level,
            )
            for zone in facts.zone_gaps(object_id, self.to_zone, self.from_above)
        ]

    def _any(
        self, limits: Iterable[Kleene], found: Sequence[_Near], object_id: int, facts: FactSource
    ) -> Kleene:
        """Some thing keeps the limit and counts."""
        return any_of(
            NO if limit == NO else all_of((limit, self._counts(one, object_id, facts)))
            for limit, one in zip(limits, found, strict=True)
        )

    def _counts(self, one: _Near, object_id: int, facts: FactSource) -> Kleene:
        parts = [one.counts]
        if self.to_state is not None:
            source = one.source_id
            parts.append(NO if source is None else of_state(source, self.to_state, facts))
        if self.same_room and not self.to_zone and one.source_id is not None:
            parts.append(facts.together(object_id, one.source_id))
        return all_of(parts)

    def measure(self, object_id: int, facts: FactSource) -> Evidence:
        for one in self._found(object_id, facts):
            if self._counts(one, object_id, facts).value:
                return {"distance_m": rounded(one.gap_m), **one.evidence}
        return {}

    def in_words(self) -> str:
        state = f" that is {self.to_state}" if self.to_state else ""
        seen = ", seen from above," if self.from_above else ""
        room = " in its room" if self.same_room else ""
        what = either(self.to)
        if self.to_zone:
            what = f"a {either(self.to_zone)} zone"
            state = f" of something{state}" if state else ""
        return f"it is {limits_in_words(self.min_m, self.max_m)}{seen} from {what}{state}{room}"
