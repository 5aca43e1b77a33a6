"""Everyday things: small objects where their category normally lives."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from shapely.geometry import Polygon

from sdgen.catalog.records import Abode, Category
from sdgen.home.context import KEEP_CLEAR, HomeContext
from sdgen.home.layout import Intent, Layout
from sdgen.library.records import Asset
from sdgen.scene import Room
from sdgen.seeding import Rng

#: A lived-in home holds at least 60 small things; a few more, since some will not stand.
LEAST_THINGS = 66
#: Bounds the search for room for them, in rounds of one thing more on every receptacle.
EXTRA_ROUNDS = 4


def add_clutter(layout: Layout, context: HomeContext, rng: Rng) -> None:
    """Fill supports and containers of every room by the catalogue's priors.

    A thing that finds no room is left out: clutter is never worth a retry. A small home whose
    priors give fewer than LEAST_THINGS gets one more on every receptacle, and again.
    """
    types = {t.name: t for t in context.catalog.room_types}
    small = [
        (category, abode)
        for category in context.catalog.categories
        if category.kind == "small" and context.models(category.name)
        for abode in category.lives
    ]
    receptacles: list[tuple[int, Room, list[Choice]]] = []
    for room in context.home.rooms:
        room_type = types.get(room.type)
        if room_type is None:
            continue
        priors = {prior.receptacle: prior for prior in room_type.clutter}
        for item in list(layout.items.values()):
            prior = priors.get(item.category)
            if not item.fixed or item.room_id != room.id or prior is None:
                continue
            wanted = int(rng.integers(prior.count_min, prior.count_max + 1))
            choices = _choices(small, item.category, room)
            receptacles.append((item.id, room, choices))
            for _ in range(wanted):
                _place(layout, item.id, room, choices, context, rng)
        wanted = int(rng.integers(room_type.floor_clutter_min, room_type.floor_clutter_max + 1))
        choices = _choices(small, "floor", room)
        for _ in range(wanted):
            _place_on_floor(layout, room, choices, context, rng)
    for _ in range(EXTRA_ROUNDS):
        for receptacle_id, room, choices in receptacles:
            if _things(layout) >= LEAST_THINGS:
                return
            _place(layout, receptacle_id, room, choices, context, rng)


def _things(layout: Layout) -> int:
    return sum(not item.fixed for item in layout.items.values())


#: A category and one of the places it lives in.
Choice = tuple[Category, Abode]


def _choices(small: Sequence[Choice], target: str, room: Room) -> list[Choice]:
    return [
        (category, abode)
        for category, abode in small
        if target in abode.targets and (not abode.rooms or room.type in abode.rooms)
    ]


def _pick(choices: Sequence[Choice], context: HomeContext, rng: Rng) -> tuple[Asset, Abode] | None:
    """A model by the abodes' weights; None when nothing lives there."""
    weights = np.array([abode.weight for _, abode in choices])
    if weights.sum() <= 0:
        return None
    category, abode = choices[int(rng.choice(len(choices), p=weights / weights.sum()))]
    models = context.models(category.name)
    return models[int(rng.integers(len(models)))], abode


def _place(
    layout: Layout,
    receptacle_id: int,
    room: Room,
    choices: Sequence[Choice],
    context: HomeContext,
    rng: Rng,
) -> None:
    picked = _pick(choices, context, rng)
    if picked is None:
        return
    asset, abode = picked
    spot = layout.spot_on_object(asset, receptacle_id, abode.relation, rng)
    if spot is not None:
        item = layout.new_item(asset, spot, room.id)
        layout.put(item, Intent(abode.relation, receptacle_id))


def _place_on_floor(
    layout: Layout, room: Room, choices: Sequence[Choice], context: HomeContext, rng: Rng
) -> None:
    picked = _pick(choices, context, rng)
    if picked is None:
        return
    asset, _ = picked
    outline = Polygon(room.polygon_m)
    spot = layout.spot_on_floor(
        asset,
        outline.buffer(-0.1),
        outline,
        rng,
        avoid=context.zone_shape(KEEP_CLEAR),
        avoid_share=0.15,
    )
    if spot is not None:
        item = layout.new_item(asset, spot, room.id)
        layout.put(item, Intent("ON", context.floor_id(room.id)))
