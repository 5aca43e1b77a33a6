"""Everyday things: small objects where their category normally lives."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from sdgen.catalog.records import Abode, Category
from sdgen.geometry import Array
from sdgen.home.context import KEEP_CLEAR, SPOTS_TRIED, Everything, HomeContext
from sdgen.home.layout import Bulk, Intent, Layout
from sdgen.home.small_on_small import spot_on_small
from sdgen.library.records import Asset, AssetInfo
from sdgen.library.states import rest_states
from sdgen.scene import ObjectInstance, Room
from sdgen.seeding import Rng

#: A lived-in home holds at least 60 small things; a few more, since some will not stand.
LEAST_THINGS = 66
#: Bounds the search for room for them, in rounds of one thing more on every receptacle.
EXTRA_ROUNDS = 4
#: Draws for one thing where the home has enough of what was drawn: of twenty that fail, one does
#: so four times.
PICKS = 4
#: Searches of the whole home for room for what a household always has: where spots drawn in every
#: room failed once (of a hundred homes with pets in two), others are found; with 8 of them one
#: cat in 300 homes had no bowl.
ALWAYS_ROUNDS = 40
#: Things tried for one place on or in a small thing, most of which are too large: with six tries a
#: fifth fewer lie there.
HELD_TRIES = 12


def add_clutter(
    layout: Layout, context: HomeContext, rng: Rng, keep_off: Collection[int] = ()
) -> None:
    """Fill supports and containers of every room by the catalogue's priors, and what small things
    hold; nothing is put on or into the small things of ``keep_off``.

    A thing that finds no room is left out: clutter is never worth a retry. A small home whose
    priors give fewer than LEAST_THINGS gets one more on every receptacle, and again.
    """
    types = {t.name: t for t in context.catalog.room_types}
    abodes = _Abodes(context)
    stock = _Stock(layout)
    for category in context.catalog.categories:
        for _ in range(ALWAYS_ROUNDS if category.always else 0):
            if not stock.count(category.name):
                _place_somewhere(layout, category, stock, context, rng)
    receptacles: list[tuple[ObjectInstance, Room, _Choices]] = []
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
            receptacles.append((item, room, choices))
            for _ in range(wanted):
                _place(layout, item, room, choices, stock, context, rng)
        wanted = int(rng.integers(room_type.floor_clutter_min, room_type.floor_clutter_max + 1))
        choices = abodes.choices("floor", room)
        if choices is not None:
            for _ in range(wanted):
                _place_on_floor(layout, room, choices, stock, context, rng)
    _fill_small_things(layout, abodes, stock, context, keep_off, rng)
    for _ in range(EXTRA_ROUNDS):
        for receptacle, room, choices in receptacles:
            if _things(layout) >= LEAST_THINGS:
                return
            _place(layout, receptacle, room, choices, stock, context, rng)


def _things(layout: Layout) -> int:
    return sum(not item.fixed for item in layout.items.values())


class _Stock:
    """What a home has so far, counted as the catalogue bounds it."""

    def __init__(self, layout: Layout) -> None:
        self._home: Counter[str] = Counter()
        self._rooms: Counter[tuple[int, str]] = Counter()
        self._models: set[tuple[int, str]] = set()
        for item in layout.items.values():
            intent = layout.intents.get(item.id)
            self.add(item, None if intent is None else intent.target_id)

    def add(self, item: ObjectInstance, target_id: int | None) -> None:
        """Count a thing that was put on or in a target."""
        self._home[item.category] += 1
        self._rooms[item.room_id, item.category] += 1
        if target_id is not None:
            self._models.add((target_id, item.asset))

    def count(self, category: str) -> int:
        """How many of a category there are in all."""
        return self._home[category]

    def full(self, category: Category, room_id: int) -> bool:
        """True when the room, or the home, has as many of a category as it may."""
        name = category.name
        return category.at_most.reached(self._rooms[room_id, name], self._home[name])

    def stands_on(self, target_id: int, asset_id: str) -> bool:
        """True when one of this model is on or in the target."""
        return (target_id, asset_id) in self._models


@dataclass(frozen=True)
class _Choices:
    """What lives in one place: categories with how they lie there, and the sums of their weights
    up to each, as shares."""

    among: tuple[tuple[Category, Abode, Sequence[Asset]], ...]
    sums: Array

    def pick(
        self, room_id: int, target_id: int, stock: _Stock, rng: Rng
    ) -> tuple[Asset, Abode] | None:
        """A model by the abodes' weights, any of its category's; None when all that were drawn
        are there as often as they may be."""
        for _ in range(PICKS):
            # What rng.choice with weights does, without summing them again for every thing.
            k = int(self.sums.searchsorted(rng.random(), side="right"))
            category, abode, models = self.among[k]
            asset = models[int(rng.integers(len(models)))]
            if stock.full(category, room_id):
                continue
            if category.alike or not stock.stands_on(target_id, asset.id):
                return asset, abode
        return None


def living_so(category: Category, abode: Abode, models: Sequence[Asset]) -> Sequence[Asset]:
    """The models of a category that live as one of its abodes says.

    What comes in a state that some abode names (a cut apple) lives where such abodes say alone.
    """
    named = {other.state for other in category.lives} - {None}
    if not named:
        return models
    if abode.state is not None:
        return [model for model in models if abode.state in rest_states(model)]
    return [model for model in models if named.isdisjoint(rest_states(model))]


class _Abodes:
    """What lives where in a home, by the catalogue and the models at hand."""

    def __init__(self, context: HomeContext) -> None:
        self._by_target: dict[str, list[tuple[Category, Abode, Sequence[Asset]]]] = {}
        for category in context.catalog.categories:
            for abode in category.lives if category.kind == "small" else ():
                models = living_so(category, abode, context.models(category.name))
                for target in dict.fromkeys(abode.targets) if models else ():
                    self._by_target.setdefault(target, []).append((category, abode, models))

    def choices(self, target: str, room: Room) -> _Choices | None:
        """What lives on or in a target in a room; None when nothing does."""
        among = tuple(
            one
            for one in self._by_target.get(target, ())
            if not one[1].rooms or room.type in one[1].rooms
        )
        weights = np.array([abode.weight for _, abode, _ in among])
        if weights.sum() <= 0:
            return None
        sums = (weights / weights.sum()).cumsum()
        return _Choices(among, sums / sums[-1])


def _fill_small_things(
    layout: Layout,
    abodes: _Abodes,
    stock: _Stock,
    context: HomeContext,
    keep_off: Collection[int],
    rng: Rng,
) -> None:
    """Put things on and into small ones that hold some: those that lie open and are whole."""
    rooms = {room.id: room for room in context.home.rooms}
    holds = {c.name: c.holds for c in context.catalog.categories if c.holds is not None}
    holders = [item for item in layout.items.values() if item.category in holds]
    # What is put on one may hold more: a plate on a mat, and a roll on the plate.
    for holder in holders:
        held = holds[holder.category]
        lies_open = layout.intents[holder.id].relation == "ON" and holder.variant == "default"
        if holder.id in keep_off or not lies_open or rng.random() >= held.chance:
            continue
        info = layout.info(holder.id)
        if not info.supports and not info.containers:
            continue  # a book that lies open, or stands
        choices = abodes.choices(holder.category, rooms[holder.room_id])
        if choices is None:
            continue
        for _ in range(int(rng.integers(held.count[0], held.count[1] + 1))):
            # Most of what is drawn is too large for what would hold it.
            for _ in range(HELD_TRIES):
                room = rooms[holder.room_id]
                placed = _place(layout, holder, room, choices, stock, context, rng)
                if placed is not None:
                    holders += [placed] if placed.category in holds else []
                    break


def _place(
    layout: Layout,
    receptacle: ObjectInstance,
    room: Room,
    choices: _Choices,
    stock: _Stock,
    context: HomeContext,
    rng: Rng,
) -> ObjectInstance | None:
    picked = choices.pick(room.id, receptacle.id, stock, rng)
    if picked is None:
        return None
    asset, abode = picked
    may_hold = partial(context.may_hold, asset.category, receptacle.category)
    if context.reach.needed_m(asset) is not None:
        may_hold = partial(_behind_a_leaf, layout.info(receptacle.id), may_hold)
    # A fridge is as full when its door stands open as when no view looks in.
    shuts = not {"OPEN", "CLOSED"}.isdisjoint(receptacle.states)
    shut_in = abode.relation == "INSIDE" and shuts
    must_show = not shut_in and context.keeps_to_views(asset.category, rng)
    if must_show and not context.shows.anything_on(receptacle.id):
        return None
    for _ in range(SPOTS_TRIED):
        if receptacle.fixed:
            spot = layout.spot_on_object(asset, receptacle.id, abode.relation, rng, may_hold)
        else:
            spot = spot_on_small(
                layout, layout.library.info(asset.id), receptacle.id, abode.relation, rng
            )
        if spot is None:
            return None
        if must_show and not context.shows_at(Bulk(asset.extents_m), spot):
            continue
        if abode.relation == "ON" and not context.reach.beyond(asset, spot, room.id):
            continue
        if asset.category in layout.fronted and context.faces_wall(room.id, spot):
            continue
        item = layout.new_item(asset, spot, room.id)
        layout.put(item, Intent(abode.relation, receptacle.id))
        stock.add(item, receptacle.id)
        return item
    return None


def _behind_a_leaf(info: AssetInfo, may_hold: Callable[[str], bool], hollow: str) -> bool:
    """Whether a hollow that may hold a thing has a leaf that shuts it from children."""
    leaf = any(c.name == hollow and c.closed_by for c in info.containers)
    return (leaf or not hollow) and may_hold(hollow)


def _place_somewhere(
    layout: Layout, category: Category, stock: _Stock, context: HomeContext, rng: Rng
) -> None:
    """Put one of a category where it lives: the first of its abodes that has room for it, out of
    sight if it must be."""
    for where in (context, replace(context, shows=Everything())):
        for abode in category.lives:
            models = living_so(category, abode, context.models(category.name))
            if not models:
                continue
            only = _Choices(((category, abode, models),), np.ones(1))
            rooms = [r for r in context.home.rooms if not abode.rooms or r.type in abode.rooms]
            for room in [rooms[k] for k in rng.permutation(len(rooms)).tolist()]:
                if "floor" in abode.targets:
                    _place_on_floor(layout, room, only, stock, where, rng)
                for item in list(layout.items.values()):
                    if stock.count(category.name):
                        return
                    if item.fixed and item.room_id == room.id and item.category in abode.targets:
                        _place(layout, item, room, only, stock, where, rng)


def _place_on_floor(
    layout: Layout, room: Room, choices: _Choices, stock: _Stock, context: HomeContext, rng: Rng
) -> None:
    floor_id = context.floor_id(room.id)
    picked = choices.pick(room.id, floor_id, stock, rng)
    if picked is None:
        return
    asset, _ = picked
    ground = context.ground(room.id, KEEP_CLEAR)
    must_show = context.keeps_to_views(asset.category, rng)
    if must_show and not context.shows.anything_on(room.id):
        return
    for _ in range(SPOTS_TRIED):
        spot = layout.spot_on_floor(asset, ground, rng)
        if spot is None:
            return
        if must_show and not context.shows_at(Bulk(asset.extents_m), spot):
            continue
        item = layout.new_item(asset, spot, room.id)
        layout.put(item, Intent("ON", floor_id))
        stock.add(item, floor_id)
        return
