"""What predicates ask of a scene, and what they say of an object: true or false, how surely,
and the measured proof.

A term near its threshold (within its margin) is *unsure*. An unsure verdict is neither a
certified positive nor a certified negative: such a scene is rejected, so that anyone who
evaluates the published poses again agrees. The terms are in ``sdgen.catalog.terms``.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType
from typing import NamedTuple, Protocol

from sdgen.kleene import YES, Kleene
from sdgen.scene import EvidenceValue

Evidence = dict[str, EvidenceValue]


def rounded(measured: float) -> float:
    """A measurement as evidence has it, to 1e-4; never -0.0."""
    return round(measured, 4) + 0.0


class Related(NamedTuple):
    """A candidate of a relation: whether it holds, whether surely, and what was measured.

    ``states`` and ``undecided``, when given, are those of the part of the target that the object
    is in (its drawer, say) and stand for the target's own: a thing in the open compartment of a
    nightstand whose drawer is CLOSED is not shut in.
    """

    target_id: int
    target_category: str
    holds: bool
    sure: bool
    evidence: Mapping[str, float] = MappingProxyType({})
    states: tuple[str, ...] | None = None
    undecided: tuple[str, ...] = ()


@dataclass(frozen=True)
class ZoneShare:
    """``fraction`` (0-1) of an object's footprint that lies in a zone, or in several of which this
    one has most; ``level`` says whether its range of heights meets the zone's."""

    name: str
    kind: str
    fraction: float
    level: Kleene = YES


@dataclass(frozen=True)
class Bearing:
    """Where another thing is, seen from an object's front: ``angle_rad`` 0 straight ahead, pi
    behind. ``clear`` is False when the angle means nothing (they are one above the other, say);
    ``together`` says whether both are in one room."""

    target_id: int
    angle_rad: float
    clear: bool = True
    together: Kleene = YES


class ReachHeight(NamedTuple):
    """How high an object's lowest point is, metres: above the floor, and above where a child gets
    to stand near it (``climbed_id``: on what, None: the floor). ``least_m`` and ``most_m`` are
    what that may be where it is undecided whether something is near enough."""

    height_m: float
    above_m: float
    least_m: float
    most_m: float
    climbed_id: int | None = None


class Span(NamedTuple):
    """A length as measured, metres, and the least and the most that it may be where something it
    hangs on is undecided."""

    measured_m: float
    least_m: float
    most_m: float


class Overlooked(NamedTuple):
    """Something lower than an object: the gap between their outlines seen from above, and how far
    its top lies below the object's lowest point, metres; whether both are in one room."""

    target_id: int
    gap_m: float
    drop_m: float
    together: Kleene = YES


class ZoneGap(NamedTuple):
    """A zone, the gap to it from an object's footprint, metres, and what makes it (None: no
    object). ``level`` says whether its range of heights meets the object's, ``together`` whether
    it is in the object's room."""

    gap_m: float
    name: str
    source_id: int | None = None
    level: Kleene = YES
    together: Kleene = YES


class Member(NamedTuple):
    """Something that may be one of several, and whether it is."""

    object_id: int
    belongs: Kleene


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

    def room_types(self, object_id: int) -> tuple[str, ...]:
        """Types of the rooms it may be in, nearest first: one where that is decided; none (or an
        empty word among them) outdoors."""
        ...

    def height(self, object_id: int) -> float:
        """Height of the object's lowest point above the floor, metres."""
        ...

    def reach(self, object_id: int) -> ReachHeight:
        """How high the object is for a child, who climbs."""
        ...

    def related(self, object_id: int, relation: str) -> tuple[Related, ...]:
        """Candidates of ``relation`` with the object as its source, unsure ones too."""
        ...

    def gaps(
        self, object_id: int, categories: Collection[str], from_above: bool = False
    ) -> Sequence[tuple[float, int]]:
        """Gap in metres to each other object of these categories, and its id, nearest first:
        between the boxes or, ``from_above``, between the outlines on the floor plan."""
        ...

    def zone_gaps(
        self, object_id: int, kinds: Collection[str], from_above: bool = False
    ) -> Sequence[ZoneGap]:
        """Zones of these kinds that the object does not make itself, nearest first: those at its
        heights or, ``from_above``, at any."""
        ...

    def together(self, object_id: int, other: int) -> Kleene:
        """Whether two objects are in one room."""
        ...

    def overhang(self, object_id: int) -> Span:
        """How far the object reaches beyond all that would catch it: 0 where it is ON nothing."""
        ...

    def edge(self, object_id: int) -> Span:
        """How far the object's outline is from where a drop begins; infinite where there is none,
        and where it is ON nothing."""
        ...

    def overlooked(self, object_id: int, categories: Collection[str]) -> Sequence[Overlooked]:
        """Things of these categories that are, or may be, in the object's room, nearest first."""
        ...

    def sharing(self, object_id: int, categories: Collection[str]) -> Sequence[Member]:
        """Other objects of these categories, and whether they are ON or INSIDE something that the
        object is ON or INSIDE, too; by id."""
        ...

    def carried(
        self, object_id: int, categories: Collection[str], relation: str
    ) -> Sequence[Member]:
        """Objects of these categories, and whether the object holds them, ON or INSIDE; by id."""
        ...

    def bearings(self, object_id: int, categories: Collection[str]) -> Sequence[Bearing]:
        """Where things of these categories are that are, or may be, in the object's room."""
        ...

    def zone_shares(self, object_id: int, kinds: Collection[str]) -> Sequence[ZoneShare]:
        """What of the object's footprint lies in zones of these kinds, taken together: in those
        at its height and, where that is undecided of some, in all that may be."""
        ...


class Verdict(NamedTuple):
    """``value`` as measured; ``sure`` when it clears every margin that matters.

    ``evidence`` holds the measured terms that made it true; it is empty when it is false.
    """

    value: bool
    sure: bool
    evidence: Mapping[str, EvidenceValue] = MappingProxyType({})


def add_evidence(evidence: Evidence, more: Mapping[str, EvidenceValue]) -> None:
    """Add what a further term measured. What says something else under a key that is there (a
    second relation, say) goes under the key and ``_2``, or the first number that is free."""
    clashing = {key for key, value in more.items() if evidence.get(key, value) != value}
    number = 2
    while any(f"{key}_{number}" in evidence for key in clashing):
        number += 1
    for key, value in more.items():
        evidence[f"{key}_{number}" if key in clashing else key] = value


def all_verdicts(verdicts: Iterable[Verdict]) -> Verdict:
    """Strong Kleene conjunction; ends at the first that is surely false."""
    value, sure = True, True
    evidence: Evidence = {}
    for verdict in verdicts:
        if not verdict.value and verdict.sure:
            return Verdict(False, True)
        value = value and verdict.value
        sure = sure and verdict.sure
        add_evidence(evidence, verdict.evidence)
    return Verdict(value, sure, evidence if value else {})


def any_verdict(verdicts: Iterable[Verdict]) -> Verdict:
    """Strong Kleene disjunction; ends at the first that is surely true, and has its evidence."""
    value, sure = False, True
    evidence: Mapping[str, EvidenceValue] = {}
    for verdict in verdicts:
        if verdict.value and verdict.sure:
            return verdict
        if verdict.value and not value:
            evidence = verdict.evidence
        value = value or verdict.value
        sure = sure and verdict.sure
    return Verdict(value, sure, evidence)
