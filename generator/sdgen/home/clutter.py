"""Everyday things: small objects where their category normally lives."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from shapely.geometry import Polygon
from shapely.geometry.base import BaseGeometry

from sdgen.catalog.records import Abode, Catalog, Category
from sdgen.freespace import union
from sdgen.home.furnish import Models
from sdgen.home.layout import Intent, Layout
from sdgen.scene import Home, Room, Zone
from sdgen.seeding import Rng

#: Floor clutter keeps out of these, or it would trip somebody.
KEEP_CLEAR = ("doorway", "walkway", "swing")
#: A lived-in home holds at least 60 small things; a few more, since some will not stand.
LEAST_THINGS = 66
#: Bounds the search for room for them, in rounds of one thing more on every receptacle.
EXTRA_ROUNDS = 4


def zone_shape(
    zones: Sequence[Zone], kinds: Sequence[str], room_id: int | None = None
) -> BaseGeometry:
    """Union of the zones of these kinds (of one room)."""
    return union(
        [
            Polygon(z.polygon_m)
            for z in zones
            if z.kind in kinds and (room_id is None or z.room_id == room_id)
        ]
    )


def add_clutter(
    layout: Layout, home: Home, zones: Sequence[Zone], catalog: Catalog, models: Models, rng: Rng
) -> None:
    """Fill supports and containers of every room by the catalogue's priors.

    A thing that finds no room is left out: clutter is never worth a retry. A small home whose
    priors give fewer than LEAST_THINGS gets one more on every receptacle, and again.
    """
    types = {t.name: t for t in catalog.room_types}
    holders: list[tuple[int, Room, list[Choice]]] = []
    for room in home.rooms:
        room_type = types.get(room.type)
        if room_type is None:
            continue
        counts = {prior.receptacle: prior for prior in room_type.clutter}
        receptacles = [
            item for item in list(layout.items.values()) if item.fixed and item.room_id == room.id
        ]
        for receptacle in receptacles:
            prior = counts.get(receptacle.category)
            if prior is None:
                continue
            wanted = int(rng.integers(prior.count_min, prior.count_max + 1))
            choices = _choices(catalog, models, receptacle.category, room)
            holders.append((receptacle.id, room, choices))
            for _ in range(wanted):
                _place(layout, receptacle.id, room, choices, models, rng)
        wanted = int(rng.integers(room_type.floor_clutter_min, room_type.floor_clutter_max + 1))
        choices = _choices(catalog, models, "floor", room)
        for _ in range(wanted):
            _place_on_floor(layout, home, room, zones, choices, models, rng)
    for _ in range(EXTRA_ROUNDS):
        for receptacle_id, room, choices in holders:
            if _things(layout) >= LEAST_THINGS:
                return
            _place(layout, receptacle_id, room, choices, models, rng)


def _things(layout: Layout) -> int:
    return sum(not item.fixed for item in layout.items.values())


Choice = tuple[Category, Abode]


def _choices(catalog: Catalog, models: Models, target: str, room: Room) -> list[Choice]:
    return [
        (category, abode)
        for category in catalog.categories
        if category.kind == "small" and models(category.name)
        for abode in category.lives
        if target in abode.targets and (not abode.rooms or room.type in abode.rooms)
    ]


def _pick(choices: Sequence[Choice], rng: Rng) -> Choice | None:
    if not choices:
        return None
    weights = np.array([abode.weight for _, abode in choices])
    if weights.sum() <= 0:
        return None
    return choices[int(rng.choice(len(choices), p=weights / weights.sum()))]


def _place(
    layout: Layout,
    receptacle_id: int,
    room: Room,
    choices: Sequence[Choice],
    models: Models,
    rng: Rng,
) -> None:
    choice = _pick(choices, rng)
    if choice is None:
        return
    category, abode = choice
    assets = models(category.name)
    asset = assets[int(rng.integers(len(assets)))]
    spot = layout.spot_on_object(asset, receptacle_id, abode.relation, rng)
    if spot is not None:
        item = layout.new_item(asset, spot, room.id)
        layout.put(item, Intent(abode.relation, receptacle_id))


def _place_on_floor(
    layout: Layout,
    home: Home,
    room: Room,
    zones: Sequence[Zone],
    choices: Sequence[Choice],
    models: Models,
    rng: Rng,
) -> None:
    choice = _pick(choices, rng)
    if choice is None:
        return
    assets = models(choice[0].name)
    asset = assets[int(rng.integers(len(assets)))]
    outline = Polygon(room.polygon_m)
    spot = layout.spot_on_floor(
        asset,
        outline.buffer(-0.1),
        outline,
        rng,
        avoid=zone_shape(zones, KEEP_CLEAR),
        avoid_share=0.15,
    )
    if spot is not None:
        layout.put(layout.new_item(asset, spot, room.id), Intent("ON", floor_ids(home)[room.id]))


def floor_ids(home: Home) -> Mapping[int, int]:
    """Floor structure of each room."""
    return {s.room_id: s.id for s in home.structures if s.category == "floor"}
