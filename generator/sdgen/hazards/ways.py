"""The ways a hazard can come about in a given home, and how one is brought about."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass

import numpy as np
from shapely.geometry import Polygon

from sdgen.actions import in_state
from sdgen.catalog.records import Catalog, PlaceRecipe, Recipe, SetRecipe, UniqueAnomaly
from sdgen.home.clutter import KEEP_CLEAR, floor_ids, zone_shape
from sdgen.home.furnish import Models
from sdgen.home.layout import DROP_M, Intent, Layout, Vec3Yaw, within_room
from sdgen.library.records import Asset
from sdgen.scene import Home, ObjectInstance, Zone
from sdgen.seeding import Rng
from sdgen.vocabulary import OPENINGS

#: What only exists as a hazard lies where it is put: half a millimetre proud of the surface.
FLUSH_M = 0.0005
TARGETS_TRIED = 4
#: Spots looked at on one target where only some heights will do (a high shelf of a bookcase).
SPOTS_TRIED = 6
ZONE_KEEP_SHARE = 0.7


@dataclass(frozen=True)
class Way:
    """One unique anomaly (or lookalike) and the recipe that makes it."""

    unique: UniqueAnomaly
    recipe: Recipe


@dataclass(frozen=True)
class Made:
    """A way brought about: the object, whether it is new, and what it was before."""

    hazard: str
    object_id: int
    way: Way
    before: ObjectInstance | None


@dataclass(frozen=True)
class Site:
    """Where things can be brought about: a furnished home and what may be used in it."""

    home: Home
    zones: Sequence[Zone]
    catalog: Catalog
    models: Models


def ways(hazard: str, recipes: Sequence[Recipe], layout: Layout, site: Site) -> list[Way]:
    """Every way these recipes allow with the models and the furniture at hand, in recipe order."""
    present = {item.category for item in layout.items.values()} | {"floor"}
    out: list[Way] = []
    for recipe in recipes:
        for category in recipe.categories:
            if isinstance(recipe, SetRecipe):
                if category in present:
                    unique = UniqueAnomaly(
                        hazard=hazard,
                        category=category,
                        state=recipe.state,
                        relation=None,
                        target=None,
                    )
                    out.append(Way(unique, recipe))
                continue
            if not site.models(category):
                continue
            for target in recipe.targets:
                if target in present:
                    unique = UniqueAnomaly(
                        hazard=hazard,
                        category=category,
                        state=recipe.state,
                        relation=recipe.relation,
                        target=target,
                    )
                    out.append(Way(unique, recipe))
    return out


def shuffled(found: Sequence[Way], rng: Rng) -> list[Way]:
    """Ways in a random order that follows the recipes' weights; no category crowds out another.

    Efraimidis and Spirakis (2006): sorting by u^(1/w) draws without replacement by weight; its
    logarithm, log(u)/w, does not underflow where weights are tiny.
    """
    if not found:
        return []
    per: dict[tuple[int, str], int] = {}
    for way in found:
        key = (id(way.recipe), way.unique.category)
        per[key] = per.get(key, 0) + 1
    weights = np.array(
        [max(way.recipe.weight, 1e-9) / per[(id(way.recipe), way.unique.category)] for way in found]
    )
    keys = np.log(np.maximum(rng.random(len(found)), np.finfo(float).tiny)) / weights
    return [found[k] for k in np.argsort(-keys, kind="stable").tolist()]


def bring_about(
    way: Way,
    layout: Layout,
    site: Site,
    taken: Collection[int],
    rng: Rng,
    keep_off: Collection[int] = (),
) -> Made | None:
    """Change ``layout`` so that the way holds; None (and no change) when it does not fit.

    ``taken`` are objects other anomalies or lookalikes already use; nothing is put on or into
    those of ``keep_off`` (a pot on a burning stove is no benign near miss of one).
    """
    if isinstance(way.recipe, SetRecipe):
        return _set(way, way.recipe, layout, site, taken, rng)
    return _place(way, way.recipe, layout, site, keep_off, rng)


def _room_types(site: Site) -> dict[int, str]:
    return {room.id: room.type for room in site.home.rooms}


def _set(
    way: Way, recipe: SetRecipe, layout: Layout, site: Site, taken: Collection[int], rng: Rng
) -> Made | None:
    types = _room_types(site)
    found = [
        item
        for item in layout.items.values()
        if item.category == way.unique.category
        and item.id not in taken
        and recipe.state not in item.states
        and (not recipe.rooms or types[item.room_id] in recipe.rooms)
    ]
    for k in rng.permutation(len(found)).tolist()[:TARGETS_TRIED]:
        before = found[k]
        after = in_state(before, layout.info(before.id), recipe.state, rng)
        if after is None or recipe.state not in after.states:
            continue
        stood = layout.blocks_of(before)
        opened = [block for block in layout.blocks_of(after) if block not in stood]
        if layout.clashes(opened, ignore=(before.id,), gap_m=0.0) is not None:
            continue
        if before.category not in OPENINGS and not within_room(opened, site.home, before.room_id):
            continue
        layout.put(after)
        return Made(way.unique.hazard, before.id, way, before)
    return None


def _place(
    way: Way, recipe: PlaceRecipe, layout: Layout, site: Site, keep_off: Collection[int], rng: Rng
) -> Made | None:
    models = [
        m
        for m in site.models(way.unique.category)
        if recipe.state is None or recipe.state in m.state_names
    ]
    if not models:
        return None
    asset = models[int(rng.integers(len(models)))]
    assert way.unique.target is not None
    if way.unique.target == "floor":
        return _place_on_floor(way, recipe, asset, layout, site, rng)
    types = _room_types(site)
    targets = [
        item
        for item in layout.items.values()
        if item.category == way.unique.target
        and item.id not in keep_off
        and (not recipe.rooms or types[item.room_id] in recipe.rooms)
    ]
    for k in rng.permutation(len(targets)).tolist()[:TARGETS_TRIED]:
        target = targets[k]
        spot = _spot(recipe, asset, target.id, layout, rng)
        if spot is not None:
            return _put(way, recipe, asset, spot, target.room_id, target.id, layout, site, rng)
    return None


def _spot(
    recipe: PlaceRecipe, asset: Asset, target_id: int, layout: Layout, rng: Rng
) -> Vec3Yaw | None:
    """A free spot of the target at a height the recipe allows."""
    for _ in range(SPOTS_TRIED):
        spot = layout.spot_on_object(asset, target_id, recipe.relation, rng)
        if spot is None or _height_fits(recipe, spot[0][2]):
            return spot
    return None


def _height_fits(recipe: PlaceRecipe, z: float) -> bool:
    low = recipe.min_height_m if recipe.min_height_m is not None else -1.0
    high = recipe.max_height_m if recipe.max_height_m is not None else 100.0
    return low <= z <= high


def _place_on_floor(
    way: Way, recipe: PlaceRecipe, asset: Asset, layout: Layout, site: Site, rng: Rng
) -> Made | None:
    rooms = [r for r in site.home.rooms if not recipe.rooms or r.type in recipe.rooms]
    floors = floor_ids(site.home)
    for k in rng.permutation(len(rooms)).tolist()[:TARGETS_TRIED]:
        room = rooms[k]
        outline = Polygon(room.polygon_m)
        inner = outline.buffer(-0.08)
        if recipe.zone:
            area = zone_shape(site.zones, recipe.zone, room.id).intersection(inner)
            spot = layout.spot_on_floor(asset, area, outline, rng, keep_share=ZONE_KEEP_SHARE)
        else:
            barred = recipe.avoid_zones or KEEP_CLEAR
            avoid = zone_shape(site.zones, barred)
            share = 0.2 if recipe.avoid_zones else 1.0
            spot = layout.spot_on_floor(asset, inner, outline, rng, avoid=avoid, avoid_share=share)
        if spot is not None:
            return _put(way, recipe, asset, spot, room.id, floors[room.id], layout, site, rng)
    return None


def _put(
    way: Way,
    recipe: PlaceRecipe,
    asset: Asset,
    spot: Vec3Yaw,
    room_id: int,
    target_id: int,
    layout: Layout,
    site: Site,
    rng: Rng,
) -> Made | None:
    lies = site.catalog.category(asset.category).kind == "hazard_only"
    item = layout.new_item(asset, spot, room_id, FLUSH_M if lies else DROP_M)
    if lies:
        item = item.model_copy(update={"fixed": True})
    if recipe.state is not None:
        changed = in_state(item, asset, recipe.state, rng)
        if changed is None:
            return None
        item = changed
    layout.put(item, Intent(recipe.relation, target_id))
    return Made(way.unique.hazard, item.id, way, None)
