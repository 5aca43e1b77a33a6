"""A FactSource made of plain values, and catalogue folders for tests."""

from __future__ import annotations

import math
from collections.abc import Collection
from dataclasses import dataclass, field
from pathlib import Path

import pytest
from sdgen.catalog.load import load_catalog
from sdgen.catalog.predicate import (
    Bearing,
    Member,
    Overlooked,
    ReachHeight,
    Related,
    Span,
    ZoneGap,
    ZoneShare,
)
from sdgen.errors import InputError
from sdgen.kleene import YES, Kleene

NOT_OVER = Span(0.0, 0.0, 0.0)
NO_EDGE = Span(math.inf, math.inf, math.inf)


@dataclass
class Thing:
    """What a predicate may ask of one object."""

    category: str = "knife"
    states: tuple[str, ...] = ()
    undecided: tuple[str, ...] = ()
    room: str = "kitchen"
    height_m: float = 0.75
    related: dict[str, tuple[Related, ...]] = field(default_factory=dict)
    zones: tuple[ZoneShare, ...] = ()
    gaps: dict[tuple[str, ...], tuple[tuple[float, int], ...]] = field(default_factory=dict)
    bearings: dict[tuple[str, ...], tuple[Bearing, ...]] = field(default_factory=dict)
    climbed_m: float = 0.0
    above: dict[tuple[str, ...], tuple[tuple[float, int], ...]] = field(default_factory=dict)
    zone_gaps: tuple[tuple[str, ZoneGap], ...] = ()
    elsewhere: dict[int, Kleene] = field(default_factory=dict)
    overhang: Span = NOT_OVER
    edge: Span = NO_EDGE
    overlooked: dict[tuple[str, ...], tuple[Overlooked, ...]] = field(default_factory=dict)
    sharing: tuple[Member, ...] = ()
    carried: dict[str, tuple[Member, ...]] = field(default_factory=dict)


@dataclass
class World:
    """Facts by object id; counts how often anything dear was asked."""

    things: dict[int, Thing]
    dear: int = 0

    def category(self, object_id: int) -> str:
        return self.things[object_id].category

    def states(self, object_id: int) -> tuple[str, ...]:
        return self.things[object_id].states

    def undecided_states(self, object_id: int) -> tuple[str, ...]:
        return self.things[object_id].undecided

    def room_types(self, object_id: int) -> tuple[str, ...]:
        return tuple(self.things[object_id].room.split("|"))

    def height(self, object_id: int) -> float:
        self.dear += 1
        return self.things[object_id].height_m

    def reach(self, object_id: int) -> ReachHeight:
        self.dear += 1
        thing = self.things[object_id]
        above = thing.height_m - thing.climbed_m
        return ReachHeight(thing.height_m, above, above, above, 99 if thing.climbed_m else None)

    def related(self, object_id: int, relation: str) -> tuple[Related, ...]:
        self.dear += 1
        return self.things[object_id].related.get(relation, ())

    def gaps(
        self, object_id: int, categories: Collection[str], from_above: bool = False
    ) -> tuple[tuple[float, int], ...]:
        self.dear += 1
        thing = self.things[object_id]
        return (thing.above if from_above else thing.gaps).get(tuple(categories), ())

    def zone_gaps(
        self, object_id: int, kinds: Collection[str], from_above: bool = False
    ) -> tuple[ZoneGap, ...]:
        self.dear += 1
        found = (gap for kind, gap in self.things[object_id].zone_gaps if kind in kinds)
        return tuple(gap._replace(level=YES) if from_above else gap for gap in found)

    def together(self, object_id: int, other: int) -> Kleene:
        return self.things[object_id].elsewhere.get(other, YES)

    def overhang(self, object_id: int) -> Span:
        self.dear += 1
        return self.things[object_id].overhang

    def edge(self, object_id: int) -> Span:
        self.dear += 1
        return self.things[object_id].edge

    def overlooked(self, object_id: int, categories: Collection[str]) -> tuple[Overlooked, ...]:
        self.dear += 1
        return self.things[object_id].overlooked.get(tuple(categories), ())

    def sharing(self, object_id: int, categories: Collection[str]) -> tuple[Member, ...]:
        self.dear += 1
        return self._of(self.things[object_id].sharing, categories)

    def carried(
        self, object_id: int, categories: Collection[str], relation: str
    ) -> tuple[Member, ...]:
        self.dear += 1
        return self._of(self.things[object_id].carried.get(relation, ()), categories)

    def _of(self, members: tuple[Member, ...], categories: Collection[str]) -> tuple[Member, ...]:
        return tuple(m for m in members if self.things[m.object_id].category in categories)

    def bearings(self, object_id: int, categories: Collection[str]) -> tuple[Bearing, ...]:
        self.dear += 1
        return self.things[object_id].bearings.get(tuple(categories), ())

    def zone_shares(self, object_id: int, kinds: Collection[str]) -> tuple[ZoneShare, ...]:
        self.dear += 1
        return tuple(share for share in self.things[object_id].zones if share.kind in kinds)


def on(target_id: int, category: str, holds: bool = True, sure: bool = True) -> Related:
    return Related(target_id, category, holds, sure, {"gap_m": 0.001})


HAZARD = """\
id: wobbly_vase
title: Vase at the edge
group: safety
concerns: {who: everyone}
urgency: low
message: The {object} stands badly on the {target} in the {room}.
source: nobody in particular
predicate:
  category: vase
  relation: ON
relation: ON
anomalies:
  - {place: vase, relation: ON, target: coffee_table}
remedy:
  - {action: put_on, target: bookshelf}
"""


def write(folder: Path, **files: str) -> Path:
    """Write files of a catalogue folder; ``hazards__x`` stands for ``hazards/x.yaml``."""
    for name, text in files.items():
        path = folder.joinpath(*f"{name}.yaml".split("__"))
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    return folder


def problems(*paths: Path) -> tuple[str, ...]:
    """Every problem of loading these on top of the shipped catalogue (there must be some)."""
    with pytest.raises(InputError) as caught:
        load_catalog(paths)
    return caught.value.problems
