"""``zone: [doorway, walkway]``: how much of the object's footprint lies in such a zone."""

from __future__ import annotations

from typing import Literal

from sdgen.catalog.predicate import Evidence, FactSource, Verdict, ZoneShare, any_verdict, rounded
from sdgen.catalog.reader import Reader
from sdgen.catalog.terms.term import ALWAYS, EITHER, NEVER, Can, Case, Scope, Term, either
from sdgen.kleene import EPS, all_of, at_least
from sdgen.vocabulary import (
    ZONE_AVOID_SHARE,
    ZONE_KINDS,
    ZONE_SHARE,
    ZONE_SHARE_MARGIN,
)


class ZoneTerm(Term):
    """At least half of the object's footprint lies in zones of these kinds, taken together."""

    kind: Literal["zone"] = "zone"
    any_of: tuple[str, ...]
    overlap: float = ZONE_SHARE
    margin: float = ZONE_SHARE_MARGIN

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
            overlap=below.number("overlap", ZONE_SHARE, low=0.01, high=1.0),
            margin=below.number("margin", ZONE_SHARE_MARGIN, low=0.0, high=0.5),
        )
        if term.margin > min(term.overlap, 1.0 - term.overlap):
            below.problem(f"nothing is surely in or out of it: the margin is {term.margin:g}")
        below.done()
        return term

    def evaluate(self, object_id: int, facts: FactSource) -> Verdict:
        return any_verdict(self._in(share) for share in self._shares(object_id, facts))

    def _in(self, share: ZoneShare) -> Verdict:
        enough = at_least(share.fraction, self.overlap, self.margin)
        value, sure = all_of((enough, share.level))
        evidence: Evidence = {"zone": share.kind, "zone_name": share.name}
        evidence["zone_overlap"] = rounded(share.fraction)
        return Verdict(value, sure, evidence if value else {})

    def measure(self, object_id: int, facts: FactSource) -> Evidence:
        shares = self._shares(object_id, facts)
        return {"zone_overlap": rounded(shares[0].fraction if shares else 0.0)}

    def _shares(self, object_id: int, facts: FactSource) -> list[ZoneShare]:
        """Shares of zones of these kinds, largest first."""
        shares = facts.zone_shares(object_id, self.any_of)
        return sorted(shares, key=lambda share: (share.fraction, share.name), reverse=True)

    def in_words(self) -> str:
        return f"at least {self.overlap:.0%} of it is in a {either(self.any_of)}"

    def possible(self, case: Case) -> Can:
        """Zones are asked for or avoided on floors alone, and only up to a share."""
        if case.target != "floor":
            return EITHER
        if case.zone:
            surely = self.overlap + self.margin <= case.zone_share + EPS
            return ALWAYS if surely and set(case.zone) <= set(self.any_of) else EITHER
        surely_not = self.overlap - self.margin >= ZONE_AVOID_SHARE - EPS
        return NEVER if surely_not and set(self.any_of) <= set(case.avoid_zones) else EITHER
