"""The predicate language as people write it, read into the tagged records.

``{category: [knife], height: {max_m: 1.3}}`` means that all of it holds; ``all``, ``any`` and
``not`` nest. See ``hazard_catalog/README.md``.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from sdgen.catalog.reader import Reader, shown
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
from sdgen.yaml_source import Path_, Source

RELATIONS = (
    "ON",
    "INSIDE",
    "BETWEEN",
    "CLOSE",
    "FACING",
    "UNDER",
    "BLOCKS",
    "NEAR_HEAT",
    "NEAR_WATER",
)
ZONE_KINDS = ("doorway", "walkway", "swing", "heat", "water", "child_reach")
TERMS = ("category", "state", "relation", "room", "height", "distance", "zone", "all", "any", "not")


def read_predicate(
    source: Source, path: Path_, value: Any, categories: set[str], rooms: set[str]
) -> Predicate:
    """Read one predicate; problems are noted in ``source`` and a stand-in is returned."""
    if isinstance(value, list):
        terms = [
            read_predicate(source, (*path, index), item, categories, rooms)
            for index, item in enumerate(value)
        ]
        if not terms:
            source.problem(path, "expected at least one term")
        return AllTerm(terms=tuple(terms))
    reader = Reader(source, path, value)
    if reader.ok and not reader.data:
        reader.problem(f"expected one of the terms {', '.join(TERMS)}")
    found: list[Predicate] = []
    if reader.has("category"):
        names = reader.words("category", choices=categories, what="category")
        found.append(CategoryTerm(any_of=names))
    if reader.has("state"):
        found.append(StateTerm(any_of=reader.states("state")))
    if reader.has("room"):
        names = reader.words("room", choices=rooms, what="room type")
        found.append(RoomTerm(any_of=names))
    if reader.has("relation"):
        found.append(_relation(reader, categories))
    elif reader.has("target") or reader.has("target_state"):
        reader.problem("'target' needs a 'relation' beside it (such as relation: ON)")
    if reader.has("height"):
        found.append(_height(reader.child("height")))
    if reader.has("distance"):
        found.append(_distance(reader.child("distance"), categories))
    if reader.has("zone"):
        found.append(_zone(reader))
    if reader.has("all"):
        found.append(AllTerm(terms=tuple(_listed(reader, "all", categories, rooms))))
    if reader.has("any"):
        found.append(AnyTerm(terms=tuple(_listed(reader, "any", categories, rooms))))
    if reader.has("not"):
        inner = read_predicate(source, (*path, "not"), reader.data["not"], categories, rooms)
        found.append(NotTerm(term=inner))
    for key in reader.data:
        if key in TERMS and reader.data[key] is None:
            reader.problem("is empty", key)
    reader.done()
    return found[0] if len(found) == 1 else AllTerm(terms=tuple(found))


def _listed(reader: Reader, key: str, categories: set[str], rooms: set[str]) -> Iterator[Predicate]:
    value = reader.data[key]
    if not isinstance(value, list) or not value:
        reader.problem(f"expected a list of terms, got {shown(value)}", key)
        return
    for index, item in enumerate(value):
        yield read_predicate(reader.source, (*reader.path, key, index), item, categories, rooms)


def _relation(reader: Reader, categories: set[str]) -> RelationTerm:
    state = reader.state("target_state", None)
    return RelationTerm(
        relation=reader.choice("relation", RELATIONS),
        targets=reader.words("target", (), choices=categories, what="category"),
        target_state=state,
    )


def _limits(reader: Reader) -> tuple[float | None, float | None]:
    low = reader.number("min_m", None, low=0.0, high=100.0)
    high = reader.number("max_m", None, low=0.0, high=100.0)
    if low is None and high is None and reader.ok:
        reader.problem("needs min_m or max_m (metres)")
    if low is not None and high is not None and low > high:
        reader.problem(f"min_m ({low:g}) is above max_m ({high:g})", "min_m")
    return low, high


def _height(reader: Reader) -> HeightTerm:
    low, high = _limits(reader)
    term = HeightTerm(
        min_m=low,
        max_m=high,
        margin_m=reader.number("margin_m", 0.03, low=0.0, high=1.0),
        evidence=reader.choice("evidence", ("height_m", "reach_height_m"), "height_m"),
    )
    reader.done()
    return term


def _distance(reader: Reader, categories: set[str]) -> DistanceTerm:
    low, high = _limits(reader)
    term = DistanceTerm(
        to=reader.words("to", choices=categories, what="category"),
        to_state=reader.state("to_state", None),
        min_m=low,
        max_m=high,
        margin_m=reader.number("margin_m", 0.05, low=0.0, high=1.0),
    )
    reader.done()
    return term


def _zone(reader: Reader) -> ZoneTerm:
    """``zone: [doorway]`` or ``zone: {kind: [doorway], overlap: 0.5, margin: 0.15}``."""
    if not isinstance(reader.data["zone"], dict):
        return ZoneTerm(any_of=reader.words("zone", choices=ZONE_KINDS, what="zone"))
    below = reader.child("zone")
    term = ZoneTerm(
        any_of=below.words("kind", choices=ZONE_KINDS, what="zone"),
        overlap=below.number("overlap", 0.5, low=0.01, high=1.0),
        margin=below.number("margin", 0.15, low=0.0, high=0.5),
    )
    below.done()
    return term
