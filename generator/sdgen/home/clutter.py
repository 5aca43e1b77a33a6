"""Everyday things: small objects where their category normally lives."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from shapely.geometry import Polygon

from sdgen.catalog.records import Abode, Category
from sdgen.geometry import Array
from sdgen.home.context import KEEP_CLEAR, HomeContext
from sdgen.home.layout import FLOOR_OFF_WALLS_M, Intent, Layout
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
    abodes = _Abodes(context)
    receptacles: list[tuple[int, Room, _Choices]] = []
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
            choices = abodes.choices(item.category, room)
            if choices is None:
                continue
            receptacles.append((item.id, room, choices))
            for _ in range(wanted):
                _place(layout, item.id, room, choices, context, rng)
        wanted = int(rng.integers(room_type.floor_clutter_min, room_type.floor_clutter_max + 1))
        choices = abodes.choices("floor", room)
        if choices is not None:
            for _ in range(wanted):
                _place_on_floor(layout, room, choices, context, rng)
    for _ in range(EXTRA_ROUNDS):
        for receptacle_id, room, choices in receptacles:
            if _things(layout) >= LEAST_THINGS:
                return
            _place(layout, receptacle_id, room, choices, context, rng)


def _things(layout: Layout) -> int:
    return sum(not item.fixed for item in layout.items.values())


@dataclass(frozen=True)
class _Choices:
    """What lives in one place: categories with how they lie there, and the sums of their weights
    up to each, as shares."""

    among: tuple[tuple[Category, Abode], ...]
    sums: Array

    def pick(self, context: HomeContext, rng: Rng) -> tuple[Asset, Abode]:
        """A model by the abodes' weights, any of its category's."""
        # What rng.choice with weights does, without summing them again for every thing.
        category, abode = self.among[int(self.sums.searchsorted(rng.random(), side="right"))]
        models = context.models(category.name)
        return models[int(rng.integers(len(models)))], abode


class _Abodes:
    """What lives where in a home, by the catalogue and the models at hand."""

    def __init__(self, context: HomeContext) -> None:
        self._by_target: dict[str, list[tuple[Category, Abode]]] = {}
        for category in context.catalog.categories:
            if category.kind == "small" and context.models(category.name):
                for abode in category.lives:
                    for target in dict.fromkeys(abode.targets):
                        self._by_target.setdefault(target, []).append((category, abode))

    def choices(self, target: str, room: Room) -> _Choices | None:
        """What lives on or in a target in a room; None when nothing does."""
        among = tuple(
            (category, abode)
            for category, abode in self._by_target.get(target, ())
            if not abode.rooms or room.type in abode.rooms
        )
        weights = np.array([abode.weight for _, abode in among])
        if weights.sum() <= 0:
            return None
        sums = (weights / weights.sum()).cumsum()
        return _Choices(among, sums / sums[-1])


def _place(
    layout: Layout,
    receptacle_id: int,
    room: Room,
    choices: _Choices,
    context: HomeContext,
    rng: Rng,
) -> None:
    asset, abode = choices.pick(context, rng)
    spot = layout.spot_on_object(asset, receptacle_id, abode.relation, rng)
    if spot is not None:
        item = layout.new_item(asset, spot, room.id)
        layout.put(item, Intent(abode.relation, receptacle_id))


def _place_on_floor(
    layout: Layout, room: Room, choices: _Choices, context: HomeContext, rng: Rng
) -> None:
    asset, _ = choices.pick(context, rng)
    outline = Polygon(room.polygon_m)
    spot = layout.spot_on_floor(
        asset,
        outline.buffer(-FLOOR_OFF_WALLS_M),
        outline,
        rng,
        avoid=context.zone_shape(KEEP_CLEAR),
    )
    if spot is not None:
        item = layout.new_item(asset, spot, room.id)
        layout.put(item, Intent("ON", context.floor_id(room.id)))
