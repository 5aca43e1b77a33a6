"""Where a thing may lie for its recipe's sake: on or in furniture, or on a floor, by height, zones,
edges and what it is to be near, where some view shows it."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial

import shapely

from sdgen.catalog.records import PlaceRecipe
from sdgen.freespace import LEAST_M2
from sdgen.hazards.candidates import Candidate
from sdgen.hazards.company import Nook, nook_by
from sdgen.hazards.evidence import evidence_of
from sdgen.home.context import SPOTS_TRIED, HomeContext
from sdgen.home.edges import spot_at_edge
from sdgen.home.layout import (
    DROP_M,
    FLOOR_GAP_M,
    Bulk,
    Intent,
    Layout,
    Vec3Yaw,
    at_spot,
)
from sdgen.library.records import Asset
from sdgen.scene import ObjectInstance, Room
from sdgen.seeding import Rng
from sdgen.vocabulary import ZONE_AVOID_SHARE

#: What only exists as a hazard lies where it is put: half a millimetre proud of the surface.
FLUSH_M = 0.0005
#: What is to lie in the way lies so far from furniture, metres, or where there is no such place, at
#: least the second: nearer, among a chair's feet or at the foot of a bed, it has been put aside for
#: all one sees (open floor, and half a body; a judgement).
IN_THE_WAY_M = (0.4, 0.25)
#: Bounds the search: pieces of furniture, or rooms with a free floor, looked at for one thing.
TARGETS_TRIED = 4
#: So many times as many spots are looked at where few will do: near something, at an edge, in a
#: zone.
MORE_SPOTS = 4


def put_by(
    candidate: Candidate,
    recipe: PlaceRecipe,
    thing: ObjectInstance,
    companion: ObjectInstance | None,
    layout: Layout,
    context: HomeContext,
    rng: Rng,
    benign: bool,
) -> int | None:
    """Put the thing at a spot that its recipe allows, near a ``companion`` if it has one.

    Its id; None, and no change, where there is no such spot.
    """
    asset = layout.library.assets[thing.asset]
    nook = nook_by(recipe, companion, layout)
    if nook is None:
        return None
    if candidate.unique.target == "floor":
        rooms = [
            room
            for room in context.home.rooms
            if (not recipe.rooms or room.type in recipe.rooms)
            and candidate.unique.room in (None, room.type)
            and nook.room_id in (None, room.id)
            and context.shows.anything_on(room.id)
            and not (benign and _beside_itself(asset, context.floor_id(room.id), layout, context))
            and not (benign and _enough(asset, room.id, layout, context))
        ]
        in_the_way = recipe.zone and not recipe.across and not benign
        for gap_m in IN_THE_WAY_M if in_the_way else (FLOOR_GAP_M,):
            put = _place_on_floor(
                candidate, recipe, thing, nook, rooms, layout, context, rng, gap_m
            )
            if put is not None:
                return put
        return None
    targets = [
        item
        for item in layout.items.values()
        if item.category == candidate.unique.target
        and not (benign and _beside_itself(asset, item.id, layout, context))
        and context.shows.anything_on(item.id)
        and (not recipe.rooms or context.room_type(item.room_id) in recipe.rooms)
        and nook.in_reach(item, layout)
    ]
    for k in rng.permutation(len(targets)).tolist()[:TARGETS_TRIED]:
        target = targets[k]
        may_hold = partial(context.may_hold, asset.category, target.category)
        harmless = benign and recipe.relation == "ON"
        fits = partial(
            _fits, candidate, recipe, thing, nook, layout, context, target.room_id, harmless
        )
        spot = _spot(recipe, thing, target.id, may_hold, fits, layout, context, rng)
        if spot is not None:
            return _put(recipe, thing, spot, target.room_id, target.id, layout)
    return None


def _beside_itself(asset: Asset, target_id: int, layout: Layout, context: HomeContext) -> bool:
    """Whether one of this model lies there and people have no sets of such things."""
    if context.catalog.category(asset.category).alike:
        return False
    there = (k for k, intent in layout.intents.items() if intent.target_id == target_id)
    return any(layout.items[k].asset == asset.id for k in there)


def _enough(asset: Asset, room_id: int, layout: Layout, context: HomeContext) -> bool:
    """Whether a room, or the home, has as many of its category as it is given: a mat at the tub."""
    alike = [item for item in layout.items.values() if item.category == asset.category]
    in_room = sum(item.room_id == room_id for item in alike)
    return context.catalog.category(asset.category).at_most.reached(in_room, len(alike))


def _spot(
    recipe: PlaceRecipe,
    thing: ObjectInstance,
    target_id: int,
    hollows: Callable[[str], bool],
    fits: Callable[[Vec3Yaw], bool],
    layout: Layout,
    context: HomeContext,
    rng: Rng,
) -> Vec3Yaw | None:
    """A free spot of the target that fits."""
    asset, bulk = layout.library.assets[thing.asset], layout.bulk_of(thing)
    picky = recipe.near is not None or recipe.over_edge is not None or bool(recipe.zone)
    for _ in range(SPOTS_TRIED * (MORE_SPOTS if picky else 1)):
        if recipe.over_edge is not None:
            at_edge = spot_at_edge(layout, context.home, thing, target_id, recipe.over_edge, rng)
            if at_edge is not None and fits(at_edge):
                return at_edge
            continue
        spot = layout.spot_on_object(asset, target_id, recipe.relation, rng, hollows, bulk)
        if spot is None or fits(spot):
            return spot
    return None


def _fits(
    candidate: Candidate,
    recipe: PlaceRecipe,
    thing: ObjectInstance,
    nook: Nook,
    layout: Layout,
    context: HomeContext,
    room_id: int,
    harmless: bool,
    spot: Vec3Yaw,
) -> bool:
    """Whether a spot is as high as the recipe asks, near what it names and in its zones, can be
    seen, what is looked at looks at no wall and what is to be ``harmless`` is beyond reach if it
    must be."""
    asset, bulk = layout.library.assets[thing.asset], layout.bulk_of(thing)
    return (
        _height_fits(recipe, spot[0][2])
        and nook.takes(bulk, spot)
        and _in_zones(recipe, bulk, spot, context)
        and not (asset.category in layout.fronted and context.faces_wall(room_id, spot))
        and (not harmless or context.reach.beyond(asset, spot, room_id))
        and _shows_at(candidate, thing, layout, context, spot)
    )


def _shows_at(
    candidate: Candidate, thing: ObjectInstance, layout: Layout, context: HomeContext, spot: Vec3Yaw
) -> bool:
    """Whether some view shows a thing at a spot, and what tells that it is a hazard or, were it
    elsewhere, would be one: a blade, a flame."""
    if not context.shows_at(layout.bulk_of(thing), spot):
        return False
    hazard, info = context.catalog.hazard(candidate.unique.hazard), layout.library.info(thing.asset)
    parts, pixels = evidence_of(hazard, info, thing)
    whole = len(parts) == len(info.variants[thing.variant])
    return whole or context.shows.telling(at_spot(thing, spot, 0), parts, pixels)


def _in_zones(recipe: PlaceRecipe, bulk: Bulk, spot: Vec3Yaw, context: HomeContext) -> bool:
    """Whether what fills this lies in the zones that a recipe asks for, on a rug say, and clear of
    those that it avoids."""
    if not recipe.zone and not recipe.avoid_zones:
        return True
    print_ = shapely.convex_hull(shapely.multipoints(bulk.corners(spot)[:, :2]))
    shape = context.zone_shape(recipe.zone or recipe.avoid_zones)
    share = shape.intersection(print_).area / max(print_.area, LEAST_M2)
    return bool(share >= recipe.zone_share if recipe.zone else share <= ZONE_AVOID_SHARE)


def _height_fits(recipe: PlaceRecipe, z: float) -> bool:
    low = recipe.min_height_m if recipe.min_height_m is not None else -1.0
    high = recipe.max_height_m if recipe.max_height_m is not None else 100.0
    return low <= z <= high


def _place_on_floor(
    candidate: Candidate,
    recipe: PlaceRecipe,
    thing: ObjectInstance,
    nook: Nook,
    rooms: Sequence[Room],
    layout: Layout,
    context: HomeContext,
    rng: Rng,
    gap_m: float,
) -> int | None:
    asset, bulk = layout.library.assets[thing.asset], layout.bulk_of(thing)
    floor = nook.floor(bulk)
    if floor is not None:
        rooms = [r for r in rooms if context.ground(r.id).outline.intersects(floor)]
    for k in rng.permutation(len(rooms)).tolist()[:TARGETS_TRIED]:
        room = rooms[k]
        ground = context.ground(
            room.id, recipe.avoid_zones, recipe.zone, recipe.zone_share, in_view=True
        )
        if floor is not None:
            ground = ground.within(floor)
        for _ in range(SPOTS_TRIED * (1 if floor is None else MORE_SPOTS)):
            spot = layout.spot_on_floor(asset, ground, rng, bulk, gap_m)
            if spot is None:
                break
            if nook.takes(bulk, spot) and _shows_at(candidate, thing, layout, context, spot):
                floor_id = context.floor_id(room.id)
                return _put(recipe, thing, spot, room.id, floor_id, layout)
    return None


def _put(
    recipe: PlaceRecipe,
    thing: ObjectInstance,
    spot: Vec3Yaw,
    room_id: int,
    target_id: int,
    layout: Layout,
) -> int:
    item = at_spot(thing, spot, room_id, FLUSH_M if thing.fixed else DROP_M)
    layout.put(item, Intent(recipe.relation, target_id))
    return item.id
