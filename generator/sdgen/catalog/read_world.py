"""Categories, room types and households read into their records."""

from __future__ import annotations

from sdgen.catalog.read_furniture import read_rules
from sdgen.catalog.reader import Reader, shown
from sdgen.catalog.records import (
    Abode,
    Category,
    ClutterPrior,
    HomeMix,
    HouseholdTemplate,
    ReachRow,
    RoomType,
)
from sdgen.errors import did_you_mean

#: VirtualHome's spelling; ``category`` of a node in graph.json.
SUPERCLASSES = (
    "Appliances",
    "Ceiling",
    "Decor",
    "Doors",
    "Electronics",
    "Floor",
    "Food",
    "Furniture",
    "Lamps",
    "Props",
    "Walls",
    "Windows",
)
#: VirtualHome's, and HEAT_SOURCE and WATER_SOURCE (of which zones are made).
PROPERTIES = (
    "CAN_OPEN",
    "CLOTHES",
    "CONTAINERS",
    "COVER_OBJECT",
    "CREAM",
    "CUTTABLE",
    "DRINKABLE",
    "EATABLE",
    "GRABBABLE",
    "HANGABLE",
    "HAS_PAPER",
    "HAS_PLUG",
    "HAS_SWITCH",
    "HEAT_SOURCE",
    "LIEABLE",
    "LOOKABLE",
    "MOVABLE",
    "POURABLE",
    "READABLE",
    "RECIPIENT",
    "SITTABLE",
    "SURFACES",
    "WATER_SOURCE",
)
CATEGORY_KINDS = ("small", "furniture", "opening", "structure", "hazard_only")
NOTIFY = ("now", "summary", "silent")


def read_category(name: str, reader: Reader, categories: set[str], rooms: set[str]) -> Category:
    """One entry of a ``categories/`` file."""
    small, large = _sizes(reader)
    light, heavy = reader.span("mass_kg", high=1000.0)
    if light <= 0 and reader.ok and reader.has("mass_kg"):
        reader.problem("masses must be above 0", "mass_kg")
    category = Category(
        name=name,
        superclass=reader.choice("superclass", SUPERCLASSES),
        extents_min_m=small,
        extents_max_m=large,
        mass_min_kg=light,
        mass_max_kg=heavy,
        properties=reader.words("properties", (), choices=PROPERTIES, what="property"),
        lives=tuple(_abode(row, categories, rooms) for row in reader.rows("lives", None)),
        kind=reader.choice("kind", CATEGORY_KINDS, "small"),
    )
    reader.text("source", "")  # for people: where the sizes come from
    reader.flag("replaces")
    reader.done()
    return category


def _sizes(
    reader: Reader,
) -> tuple[tuple[float, float, float], tuple[float, float, float]]:
    """``size_m: [[x, y, z] of the smallest, [x, y, z] of the largest]``."""
    zero = (0.0, 0.0, 0.0)
    if not reader.has("size_m"):
        if reader.ok:
            reader.problem("missing key 'size_m': [[x, y, z] smallest, [x, y, z] largest]")
        return zero, zero
    value = reader.data["size_m"]
    if not isinstance(value, list) or len(value) != 2:
        got = f"{len(value)} items" if isinstance(value, list) else shown(value)
        reader.problem(f"expected [[x, y, z] smallest, [x, y, z] largest], got {got}", "size_m")
        return zero, zero
    a = reader.vector(value[0], 3, ("size_m", 0), 0.0, 50.0)
    b = reader.vector(value[1], 3, ("size_m", 1), 0.0, 50.0)
    if any(x > y for x, y in zip(a, b, strict=True)):
        reader.problem("the smallest is larger than the largest", "size_m")
    return (a[0], a[1], a[2]), (b[0], b[1], b[2])


def _abode(reader: Reader, categories: set[str], rooms: set[str]) -> Abode:
    abode = Abode(
        relation=reader.choice("relation", ("ON", "INSIDE")),
        targets=reader.words("target", choices=categories, what="category"),
        rooms=reader.words("rooms", (), choices=rooms, what="room type"),
        weight=reader.number("weight", 1.0, low=0.001, high=1000.0),
    )
    reader.done()
    return abode


def read_room_type(name: str, reader: Reader, categories: set[str]) -> RoomType:
    """One entry of ``rooms.yaml``."""
    priors: list[ClutterPrior] = []
    below = reader.child("clutter")
    for receptacle in below.data:
        if receptacle not in categories:
            near = did_you_mean(receptacle, sorted(categories))
            below.problem(f"unknown category {receptacle!r}{near}", receptacle)
        least, most = _counts(below, receptacle)
        priors.append(ClutterPrior(receptacle=receptacle, count_min=least, count_max=most))
    least, most = _counts(reader, "floor_clutter")
    room_type = RoomType(
        name=name,
        area_m2=reader.span("area_m2", low=1.0, high=200.0) if reader.has("area_m2") else (8, 16),
        narrowest_m=reader.number("narrowest_m", 2.0, low=0.9, high=10.0),
        furniture=read_rules(reader, categories),
        clutter=tuple(priors),
        floor_clutter_min=least,
        floor_clutter_max=most,
    )
    reader.flag("replaces")
    reader.done()
    return room_type


def read_mix(name: str, reader: Reader, rooms: set[str]) -> HomeMix:
    """One entry of ``plans.yaml``."""
    hub = reader.words("hub", choices=rooms, what="room type")
    others: list[str] = []
    for index, item in enumerate(reader.listed("rooms", "room types")):
        if item in rooms:
            others.append(item)
        else:
            near = did_you_mean(str(item), sorted(rooms))
            reader.problem(f"unknown room type {item!r}{near}", "rooms", index)
    mix = HomeMix(
        name=name,
        weight=reader.number("weight", 1.0, low=0.001, high=1000.0),
        hub=hub[0] if hub else "",
        rooms=tuple(others),
    )
    reader.flag("replaces")
    reader.done()
    return mix


def _counts(reader: Reader, key: str) -> tuple[int, int]:
    least, most = reader.span(key, high=100.0)
    if least != int(least) or most != int(most):
        reader.problem("expected whole numbers", key)
    return int(least), int(most)


def read_household(name: str, reader: Reader, hazards: set[str]) -> HouseholdTemplate:
    """One entry of ``templates`` in ``households.yaml``."""
    members: list[tuple[str, int, int]] = []
    for row in reader.rows("members"):
        role = row.text("role")
        least, most = row.span("age", high=120.0)
        members.append((role, int(least), int(most)))
        row.done()
    chosen: dict[str, tuple[str, ...]] = {}
    if reader.has("notifications"):
        below = reader.child("notifications")
        for hazard in below.data:
            if hazard in hazards:
                chosen[hazard] = below.words(hazard, choices=NOTIFY, what="choice")
        below.asked.extend(sorted(hazards))
        below.done()
    template = HouseholdTemplate.model_validate(
        {
            "name": name,
            "weight": reader.number("weight", 1.0, low=0.001, high=1000.0),
            "members": tuple(members),
            "pets": reader.words("pets", (), what="pet"),
            "conditions": reader.words("conditions", (), what="condition"),
            "notifications": chosen,
        }
    )
    reader.flag("replaces")
    reader.done()
    return template


def read_reach(reader: Reader) -> tuple[ReachRow, ...]:
    """``reach`` of ``households.yaml``: rows by rising age."""
    rows: list[ReachRow] = []
    for row in reader.rows("rows"):
        age = row.integer("max_age", low=0, high=17)
        height = row.number("reach_m", low=0.1, high=2.5)
        if rows and (age <= rows[-1].max_age or height < rows[-1].reach_m):
            row.problem("ages and reaches must rise from row to row")
        rows.append(ReachRow(max_age=age, reach_m=height))
        row.done()
    reader.text("source", "")
    reader.done()
    return tuple(rows)
