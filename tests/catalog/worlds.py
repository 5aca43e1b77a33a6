"""A FactSource made of plain values, and catalogue folders for tests."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass, field
from pathlib import Path

import pytest
from sdgen.catalog.load import load_catalog
from sdgen.catalog.predicate import Bearing, ReachHeight, Related, ZoneShare
from sdgen.errors import InputError


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

    def gaps(self, object_id: int, categories: Collection[str]) -> tuple[tuple[float, int], ...]:
        self.dear += 1
        return self.things[object_id].gaps.get(tuple(categories), ())

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
