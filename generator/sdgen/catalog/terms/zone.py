"""``zone: [doorway, walkway]``: how much of the object's footprint lies in such a zone."""

from __future__ import annotations

from typing import Literal

from sdgen.catalog.predicate import Evidence, FactSource, Verdict, ZoneShare
from sdgen.catalog.reader import Reader
from sdgen.catalog.terms.term import ALWAYS, EITHER, NEVER, Can, Case, Scope, Term, either
from sdgen.kleene import at_least
from sdgen.vocabulary import ZONE_KINDS

OVERLAP = 0.5
#: Of a thing 0.3 m long, this is 4.5 cm: seen, not measured.
MARGIN = 0.15


class ZoneTerm(Term):
    """At least half of the object's footprint lies in a zone of one of these kinds."""

    kind: Literal["zone"] = "zone"
    any_of: tuple[str, ...]
    overlap: float = OVERLAP
    margin: float = MARGIN

    @classmethod
    def read(cls, reader: Reader, scope: Scope) -> ZoneTerm | None:
        """``zone: [doorway]`` or ``zone: {kind: [doorway], overlap: 0.5, margin: 0.15}``."""
        if not reader.has("zone"):
            return None
        if not isinstance(reader.data["zone"], dict):
            return cls(any_of=reader.words("zone", choices=ZONE_KINDS, what="zone"))
        below = reader.child("zone")
        term = cls(
            any_of=below.words("kind", choices=ZONE_KINDS, what="zone"),
            overlap=below.number("overlap", OVERLAP, low=0.01, high=1.0),
            margin=below.number("margin", MARGIN, low=0.0, high=0.5),
        )
        below.done()
        return term

    def evaluate(self, object_id: int, facts: FactSource) -> Verdict:
        share = self._share(object_id, facts)
        fraction = share.fraction if share is not None else 0.0
        value, sure = at_least(fraction, self.overlap, self.margin)
        if not value or share is None:
            return Verdict(value, sure)
        overlap = round(fraction, 4)
        return Verdict(
            True, sure, {"zone": share.kind, "zone_name": share.name, "zone_overlap": overlap}
        )

    def measure(self, object_id: int, facts: FactSource) -> Evidence:
        share = self._share(object_id, facts)
        return {"zone_overlap": round(share.fraction if share else 0.0, 4)}

    def _share(self, object_id: int, facts: FactSource) -> ZoneShare | None:
        shares = [share for share in facts.zones(object_id) if share.kind in self.any_of]
        return max(shares, key=lambda share: (share.fraction, share.name), default=None)

    def in_words(self) -> str:
        return f"at least {self.overlap:.0%} of it is in a {either(self.any_of)}"

    def possible(self, case: Case) -> Can:
        if case.zone and set(case.zone) <= set(self.any_of):
            return ALWAYS
        barred = case.relation is not None and set(self.any_of) <= set(case.avoid_zones)
        return NEVER if barred else EITHER
