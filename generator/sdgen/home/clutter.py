"""Everyday things: small objects where their category normally lives."""

from __future__ import annotations

from collections.abc import Callable, Collection
from dataclasses import replace
from functools import partial

import numpy as np

from sdgen.catalog.records import Category
from sdgen.home.activities import add_activities
from sdgen.home.context import KEEP_CLEAR, SPOTS_TRIED, Everything, HomeContext
from sdgen.home.layout import Bulk, Intent, Layout
from sdgen.home.rows import fill_rows
from sdgen.home.small_on_small import spot_on_small
from sdgen.home.stock import Abodes, Choices, Stock, living_so
from sdgen.library.records import AssetInfo
from sdgen.scene import ObjectInstance, Room
from sdgen.seeding import Rng

#: A lived-in home holds at least 60 small things; a few more, since some will not stand.
LEAST_THINGS = 66
#: Bounds the search for room for them, in rounds of one thing more on every receptacle.
EXTRA_ROUNDS = 4
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
    priors give fewer than LEAST_THINGS, rows aside, gets one more on every receptacle, and again.
    """
    types = {t.name: t for t in context.catalog.room_types}
    abodes = Abodes(context)
    stock = Stock(layout)
    for category in context.catalog.categories:
        for _ in range(ALWAYS_ROUNDS if category.always else 0):
            if not stock.count(category.name):
                _place_somewhere(layout, category, stock, context, rng)
    before = frozenset(layout.items)
    busy = add_activities(layout, context, stock, rng)
    # What is laid for somebody stays as it was laid.
    keep_off = {*keep_off, *(key for key in layout.items if key not in before)}
    rows = {c.name: c.rows for c in context.catalog.categories}
    rowed = 0
    receptacles: list[tuple[ObjectInstance, Room, Choices]] = []
    for room in context.home.rooms:
        room_type = types.get(room.type)
        if room_type is None:
            continue
        priors = {prior.receptacle: prior for prior in room_type.clutter}
        for item in list(layout.items.values()):
            if not item.fixed or item.room_id != room.id:
                continue
            filled_by = rows.get(item.category, ())
            rowed += fill_rows(layout, item, room, filled_by, abodes, stock, context, rng)
            prior = priors.get(item.category)
            if prior is None:
                continue
            # What somebody does there has brought some already: little else is strewn about.
            wanted = int(rng.integers(prior.count_min, prior.count_max + 1)) - busy[item.id]
            choices = abodes.choices(item.category, room)
            if choices is None:
                continue
            receptacles.append((item, room, choices))
            for _ in range(wanted):
                _place(layout, item, room, choices, stock, context, rng)
        wanted = int(rng.integers(room_type.floor_clutter_min, room_type.floor_clutter_max + 1))
        wanted = round(wanted * min(1.0, 2.0 * (1.0 - context.tidiness)))
        choices = abodes.choices("floor", room)
        if choices is not None:
            for _ in range(wanted):
                _place_on_floor(layout, room, choices, stock, context, rng)
    _fill_small_things(layout, abodes, stock, context, keep_off, rng)
    for _ in range(EXTRA_ROUNDS):
        for receptacle, room, choices in receptacles:
            if _things(layout) - rowed >= LEAST_THINGS:
                return
            _place(layout, receptacle, room, choices, stock, context, rng)


def _things(layout: Layout) -> int:
    return sum(not item.fixed for item in layout.items.values())


def _fill_small_things(
    layout: Layout,
    abodes: Abodes,
    stock: Stock,
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
        # What a drawing has somewhere may lie on nothing that anybody is sure of.
        intent = layout.intents.get(holder.id)
        lies_open = intent is not None and intent.relation == "ON" and holder.variant == "default"
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
    choices: Choices,
    stock: Stock,
    context: HomeContext,
    rng: Rng,
) -> ObjectInstance | None:
    picked = choices.pick(room.id, receptacle.id, stock, rng)
    if picked is None:
        return None
    _, abode, asset = picked
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
    layout: Layout, category: Category, stock: Stock, context: HomeContext, rng: Rng
) -> None:
    """Put one of a category where it lives: the first of its abodes that has room for it, out of
    sight if it must be."""
    for where in (context, replace(context, shows=Everything())):
        for abode in category.lives:
            models = living_so(category, abode, context.models(category.name))
            if not models:
                continue
            only = Choices(((category, abode, models),), np.ones(1))
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
    layout: Layout, room: Room, choices: Choices, stock: Stock, context: HomeContext, rng: Rng
) -> None:
    floor_id = context.floor_id(room.id)
    picked = choices.pick(room.id, floor_id, stock, rng)
    if picked is None:
        return
    asset = picked.asset
    must_show = context.keeps_to_views(asset.category, rng)
    if must_show and not context.shows.anything_on(room.id):
        return
    ground = context.ground(room.id, KEEP_CLEAR, in_view=must_show)
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
