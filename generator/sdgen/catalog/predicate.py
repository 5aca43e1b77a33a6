"""What a predicate says of an object: true or false, how surely, and the measured proof.

A term near its threshold (within its margin) is *unsure*. An unsure verdict is neither a
certified positive nor a certified negative: such a scene is rejected, so that anyone who
evaluates the published poses again agrees.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from typing import Protocol

from sdgen.catalog.records import (
    AllTerm,
    AnyTerm,
    CategoryTerm,
    DistanceTerm,
    HeightTerm,
    NotTerm,
    Predicate,
    RelationTerm,
    RoomTerm,
    StateTerm,
    ZoneTerm,
)
from sdgen.scene import EvidenceValue

Evidence = dict[str, EvidenceValue]

# Float noise of a threshold test: poses are on a grid of 1e-5 m.
_EPS = 1e-9


@dataclass(frozen=True)
class Related:
    """A candidate of a relation: whether it holds, whether surely, and what was measured.

    ``states`` and ``undecided``, when given, are those of the part of the target that the object
    is in (its drawer, say) and stand for the target's own: a thing in the open compartment of a
    nightstand whose drawer is CLOSED is not shut in.
    """

    target_id: int
    target_category: str
    holds: bool
    sure: bool
    evidence: Mapping[str, float] = field(default_factory=dict)
    states: tuple[str, ...] | None = None
    undecided: tuple[str, ...] = ()


@dataclass(frozen=True)
class ZoneShare:
    """``fraction`` (0–1) of an object's footprint that lies in one zone."""

    name: str
    kind: str
    fraction: float


class FactSource(Protocol):
    """Everything a predicate may ask about a scene. It has no household in it."""

    def category(self, object_id: int) -> str:
        """The object's category (``floor`` and ``wall`` for structures)."""
        ...

    def states(self, object_id: int) -> tuple[str, ...]:
        """States that hold."""
        ...

    def undecided_states(self, object_id: int) -> tuple[str, ...]:
        """States whose joint lies in the dead band."""
        ...

    def room_type(self, object_id: int) -> str:
        """Type of the room the object is in."""
        ...

    def height(self, object_id: int) -> float:
        """Height of the object's lowest point above the floor, metres."""
        ...

    def related(self, object_id: int, relation: str) -> tuple[Related, ...]:
        """Candidates of ``relation`` with the object as its source, unsure ones too."""
        ...

    def distance(
        self, object_id: int, categories: tuple[str, ...], state: str | None
    ) -> tuple[float, int | None]:
        """Gap in metres to the nearest such object, and its id; (inf, None) when none is."""
        ...

    def zones(self, object_id: int) -> tuple[ZoneShare, ...]:
        """Zones the object's footprint touches."""
        ...


@dataclass(frozen=True)
class Verdict:
    """``value`` as measured; ``sure`` when it clears every margin that matters.

    ``evidence`` holds the measured terms that made it true; it is empty when it is false.
    """

    value: bool
    sure: bool
    evidence: Evidence = field(default_factory=dict)


def evaluate(predicate: Predicate, object_id: int, facts: FactSource) -> Verdict:
    """Evaluate a predicate for one object.

    Strong Kleene logic over (value, sure). Cheap terms come first: most pairs of object and
    hazard end at the category.
    """
    if isinstance(predicate, CategoryTerm):
        return Verdict(facts.category(object_id) in predicate.any_of, True)
    if isinstance(predicate, StateTerm):
        return _state(predicate.any_of, object_id, facts)
    if isinstance(predicate, RoomTerm):
        return Verdict(facts.room_type(object_id) in predicate.any_of, True)
    if isinstance(predicate, AllTerm):
        return _all(predicate, object_id, facts)
    if isinstance(predicate, AnyTerm):
        return _any(evaluate(term, object_id, facts) for term in predicate.terms)
    if isinstance(predicate, NotTerm):
        inner = evaluate(predicate.term, object_id, facts)
        return Verdict(not inner.value, inner.sure)
    if isinstance(predicate, RelationTerm):
        return _relation(predicate, object_id, facts)
    if isinstance(predicate, HeightTerm):
        return _height(predicate, object_id, facts)
    if isinstance(predicate, DistanceTerm):
        return _distance(predicate, object_id, facts)
    return _zone(predicate, object_id, facts)


def measure(predicate: Predicate, object_id: int, facts: FactSource) -> Evidence:
    """What every positive term measures for the object, whether or not the predicate holds.

    The evidence of a near miss: the height of a knife on a high shelf, say.
    """
    if isinstance(predicate, AllTerm | AnyTerm):
        out: Evidence = {}
        for term in predicate.terms:
            out.update(measure(term, object_id, facts))
        return out
    if isinstance(predicate, HeightTerm):
        return {predicate.evidence: round(facts.height(object_id), 4)}
    if isinstance(predicate, DistanceTerm):
        gap, nearest = facts.distance(object_id, predicate.to, predicate.to_state)
        return {} if nearest is None else {"distance_m": round(gap, 4), "nearest_id": nearest}
    if isinstance(predicate, ZoneTerm):
        share = _share(predicate, object_id, facts)
        return {"zone_overlap": round(share.fraction if share else 0.0, 4)}
    if isinstance(predicate, NotTerm):
        return {}
    return dict(evaluate(predicate, object_id, facts).evidence)


def _all(predicate: AllTerm, object_id: int, facts: FactSource) -> Verdict:
    terms = predicate.terms
    cheap = [t for t in terms if isinstance(t, CategoryTerm | StateTerm | RoomTerm)]
    dear = [t for t in terms if not isinstance(t, CategoryTerm | StateTerm | RoomTerm)]
    value, sure = True, True
    evidence: Evidence = {}
    for term in (*cheap, *dear):
        verdict = evaluate(term, object_id, facts)
        if not verdict.value and verdict.sure:
            return Verdict(False, True)
        value = value and verdict.value
        sure = sure and verdict.sure
        evidence.update(verdict.evidence)
    return Verdict(value, sure, evidence if value else {})


def _any(verdicts: Iterable[Verdict]) -> Verdict:
    value, sure = False, True
    evidence: Evidence = {}
    for verdict in verdicts:
        if verdict.value and verdict.sure:
            return verdict
        if verdict.value and not value:
            evidence = verdict.evidence
        value = value or verdict.value
        sure = sure and verdict.sure
    return Verdict(value, sure, evidence)


def _state(wanted: tuple[str, ...], object_id: int, facts: FactSource) -> Verdict:
    return _in_state(wanted, facts.states(object_id), lambda: facts.undecided_states(object_id))


def _in_state(
    wanted: tuple[str, ...], holding: tuple[str, ...], undecided: Callable[[], tuple[str, ...]]
) -> Verdict:
    for state in wanted:
        if state in holding:
            return Verdict(True, True, {"state": state})
    open_question = undecided()
    return Verdict(False, not any(state in open_question for state in wanted))


def _relation(term: RelationTerm, object_id: int, facts: FactSource) -> Verdict:
    def one(item: Related) -> Verdict:
        evidence: Evidence = {"relation": term.relation, "target_id": item.target_id}
        evidence["target_category"] = item.target_category
        evidence.update({key: round(value, 4) + 0.0 for key, value in item.evidence.items()})
        if term.target_state is None:
            return Verdict(item.holds, item.sure, evidence if item.holds else {})
        wanted = (term.target_state,)
        if item.states is None:
            state = _state(wanted, item.target_id, facts)
        else:
            state = _in_state(wanted, item.states, lambda: item.undecided)
        if (not item.holds and item.sure) or (not state.value and state.sure):
            return Verdict(False, True)
        value = item.holds and state.value
        evidence["target_state"] = term.target_state
        return Verdict(value, item.sure and state.sure, evidence if value else {})

    candidates = facts.related(object_id, term.relation)
    if term.targets:
        candidates = tuple(c for c in candidates if c.target_category in term.targets)
    return _any(one(item) for item in candidates)


def _within(
    measured: float, low: float | None, high: float | None, margin: float
) -> tuple[bool, bool]:
    """(inside the limits, at least ``margin`` away from the limit that decides it)."""
    slack = min(
        (measured - low) if low is not None else float("inf"),
        (high - measured) if high is not None else float("inf"),
    )
    return slack >= -_EPS, abs(slack) >= margin - _EPS


def _height(term: HeightTerm, object_id: int, facts: FactSource) -> Verdict:
    height = facts.height(object_id)
    value, sure = _within(height, term.min_m, term.max_m, term.margin_m)
    return Verdict(value, sure, {term.evidence: round(height, 4)} if value else {})


def _distance(term: DistanceTerm, object_id: int, facts: FactSource) -> Verdict:
    gap, nearest = facts.distance(object_id, term.to, term.to_state)
    if nearest is None:
        # Nothing there: nearer than something is false, farther than it is true.
        return Verdict(term.max_m is None, True)
    value, sure = _within(gap, term.min_m, term.max_m, term.margin_m)
    evidence: Evidence = {"distance_m": round(gap, 4), "nearest_id": nearest}
    return Verdict(value, sure, evidence if value else {})


def _share(term: ZoneTerm, object_id: int, facts: FactSource) -> ZoneShare | None:
    shares = [share for share in facts.zones(object_id) if share.kind in term.any_of]
    return max(shares, key=lambda share: (share.fraction, share.name), default=None)


def _zone(term: ZoneTerm, object_id: int, facts: FactSource) -> Verdict:
    share = _share(term, object_id, facts)
    fraction = share.fraction if share is not None else 0.0
    value = fraction >= term.overlap - _EPS
    sure = abs(fraction - term.overlap) >= term.margin - _EPS
    if not value or share is None:
        return Verdict(value, sure)
    overlap = round(fraction, 4)
    return Verdict(
        True, sure, {"zone": share.kind, "zone_name": share.name, "zone_overlap": overlap}
    )
