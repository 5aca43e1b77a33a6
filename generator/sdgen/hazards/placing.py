"""Puts one anomaly or lookalike into a layout: a thing to a place, or furniture to a state."""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass
from functools import partial

from sdgen.actions import in_state
from sdgen.catalog.records import PlaceRecipe, SetRecipe
from sdgen.hazards.candidates import Candidate
from sdgen.hazards.evidence import evidence_of
from sdgen.home.context import SPOTS_TRIED, HomeContext
from sdgen.home.layout import DROP_M, FLOOR_GAP_M, Intent, Layout, Vec3Yaw, at_spot, room_to_change
from sdgen.library.records import Asset
from sdgen.library.states import rest_states
from sdgen.scene import ObjectInstance, Room
from sdgen.seeding import Rng

#: What only exists as a hazard lies where it is put: half a millimetre proud of the surface.
FLUSH_M = 0.0005
#: What is to lie in the way lies so far from furniture, metres, or where there is no such place, at
#: least the second: nearer, among a chair's feet or at the foot of a bed, it has been put aside for
#: all one sees (open floor, and half a body; a judgement).
IN_THE_WAY_M = (0.4, 0.25)
#: Bounds the search: pieces of furniture, or rooms with a free floor, looked at for one thing.
TARGETS_TRIED = 4


@dataclass(frozen=True)
class Injected:
    """The object that shows an anomaly (or lookalike) of ``hazard``, and what it was before;
    None for one that is new."""

    hazard: str
    object_id: int
    before: ObjectInstance | None


def inject_candidate(
    candidate: Candidate,
    layout: Layout,
    context: HomeContext,
    taken: Collection[int],
    rng: Rng,
    benign: bool = False,
) -> Injected | None:
    """Change ``layout`` so that it holds this candidate; None, and no change, if nothing fits.

    ``taken`` are objects other anomalies or lookalikes already use: they are not set to another
    state. What is ``benign`` is not put within children's reach where it would be a hazard.
    """
    if isinstance(candidate.recipe, SetRecipe):
        return _set(candidate, candidate.recipe, layout, context, taken, rng)
    return _place(candidate, candidate.recipe, layout, context, rng, benign)


def _set(
    candidate: Candidate,
    recipe: SetRecipe,
    layout: Layout,
    context: HomeContext,
    taken: Collection[int],
    rng: Rng,
) -> Injected | None:
    found = [
        item
        for item in _concerned(candidate, recipe, layout, context)
        if item.id not in taken and recipe.state not in item.states
    ]
    for k in rng.permutation(len(found)).tolist()[:TARGETS_TRIED]:
        before = found[k]
        after = _changed(before, recipe.state, layout, context, rng)
        if after is None or recipe.state not in after.states:
            continue
        if not room_to_change(layout, context.home, before, after):
            continue
        layout.put(after)
        return Injected(candidate.unique.hazard, before.id, before)
    return None


def _changed(
    before: ObjectInstance, state: str, layout: Layout, context: HomeContext, rng: Rng
) -> ObjectInstance | None:
    """The object brought into a state in a way that some view shows: by another leaf, or opened
    less far, it might show in none."""
    ways = context.shows.set_to(before.id, state)
    if ways is None:
        return in_state(before, layout.info(before.id), state, rng)
    return ways[int(rng.integers(len(ways)))] if ways else None


def _concerned(
    candidate: Candidate, recipe: SetRecipe, layout: Layout, context: HomeContext
) -> list[ObjectInstance]:
    """What of its category stands in the rooms of a recipe that sets a state."""
    return [
        item
        for item in layout.items.values()
        if item.category == candidate.unique.category
        and (not recipe.rooms or context.room_type(item.room_id) in recipe.rooms)
    ]


def already_set(candidate: Candidate, layout: Layout, context: HomeContext) -> bool | None:
    """True when all that the candidate could set is in its state already; None when there is
    nothing of the kind in its rooms. Always False for a recipe that places something."""
    recipe = candidate.recipe
    if not isinstance(recipe, SetRecipe):
        return False
    found = _concerned(candidate, recipe, layout, context)
    return all(recipe.state in item.states for item in found) if found else None


def _place(
    candidate: Candidate,
    recipe: PlaceRecipe,
    layout: Layout,
    context: HomeContext,
    rng: Rng,
    benign: bool,
) -> Injected | None:
    models = [
        m
        for m in context.models(candidate.unique.category)
        if (recipe.state is None or recipe.state in m.state_names)
        and (not recipe.not_state or set(recipe.not_state).isdisjoint(rest_states(m)))
    ]
    if not models:
        return None
    asset = models[int(rng.integers(len(models)))]
    thing = _thing(recipe, asset, layout, context, rng)
    if thing is None:
        return None
    if candidate.unique.target == "floor":
        rooms = [
            room
            for room in context.home.rooms
            if (not recipe.rooms or room.type in recipe.rooms)
            and context.shows.anything_on(room.id)
            and not (benign and _beside_itself(asset, context.floor_id(room.id), layout, context))
            and not (benign and _enough(asset, room.id, layout, context))
        ]
        for gap_m in IN_THE_WAY_M if recipe.zone and not benign else (FLOOR_GAP_M,):
            put = _place_on_floor(candidate, recipe, thing, rooms, layout, context, rng, gap_m)
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
    ]
    for k in rng.permutation(len(targets)).tolist()[:TARGETS_TRIED]:
        target = targets[k]
        may_hold = partial(context.may_hold, asset.category, target.category)
        harmless = benign and recipe.relation == "ON"
        fits = partial(_fits, candidate, recipe, thing, layout, context, target.room_id, harmless)
        spot = _spot(recipe, thing, target.id, may_hold, fits, layout, rng)
        if spot is not None:
            return _put(candidate, recipe, thing, spot, target.room_id, target.id, layout)
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


def _thing(
    recipe: PlaceRecipe, asset: Asset, layout: Layout, context: HomeContext, rng: Rng
) -> ObjectInstance | None:
    """A new thing in the recipe's state, nowhere yet: what it fills decides where it fits."""
    thing = layout.new_thing(asset)
    if context.catalog.category(asset.category).kind == "hazard_only":
        thing = thing.model_copy(update={"fixed": True})
    return thing if recipe.state is None else in_state(thing, asset, recipe.state, rng)


def _spot(
    recipe: PlaceRecipe,
    thing: ObjectInstance,
    target_id: int,
    hollows: Callable[[str], bool],
    fits: Callable[[Vec3Yaw], bool],
    layout: Layout,
    rng: Rng,
) -> Vec3Yaw | None:
    """A free spot of the target that fits."""
    asset, bulk = layout.library.assets[thing.asset], layout.bulk_of(thing)
    for _ in range(SPOTS_TRIED):
        spot = layout.spot_on_object(asset, target_id, recipe.relation, rng, hollows, bulk)
        if spot is None or fits(spot):
            return spot
    return None


def _fits(
    candidate: Candidate,
    recipe: PlaceRecipe,
    thing: ObjectInstance,
    layout: Layout,
    context: HomeContext,
    room_id: int,
    harmless: bool,
    spot: Vec3Yaw,
) -> bool:
    """Whether a spot is as high as the recipe asks, can be seen, what is looked at looks at no wall
    and what is to be ``harmless`` is beyond reach if it must be."""
    asset = layout.library.assets[thing.asset]
    return (
        _height_fits(recipe, spot[0][2])
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


def _height_fits(recipe: PlaceRecipe, z: float) -> bool:
    low = recipe.min_height_m if recipe.min_height_m is not None else -1.0
    high = recipe.max_height_m if recipe.max_height_m is not None else 100.0
    return low <= z <= high


def _place_on_floor(
    candidate: Candidate,
    recipe: PlaceRecipe,
    thing: ObjectInstance,
    rooms: Sequence[Room],
    layout: Layout,
    context: HomeContext,
    rng: Rng,
    gap_m: float,
) -> Injected | None:
    asset, bulk = layout.library.assets[thing.asset], layout.bulk_of(thing)
    for k in rng.permutation(len(rooms)).tolist()[:TARGETS_TRIED]:
        room = rooms[k]
        ground = context.ground(room.id, recipe.avoid_zones, recipe.zone)
        for _ in range(SPOTS_TRIED):
            spot = layout.spot_on_floor(asset, ground, rng, bulk, gap_m)
            if spot is None:
                break
            if _shows_at(candidate, thing, layout, context, spot):
                floor_id = context.floor_id(room.id)
                return _put(candidate, recipe, thing, spot, room.id, floor_id, layout)
    return None


def _put(
    candidate: Candidate,
    recipe: PlaceRecipe,
    thing: ObjectInstance,
    spot: Vec3Yaw,
    room_id: int,
    target_id: int,
    layout: Layout,
) -> Injected:
    item = at_spot(thing, spot, room_id, FLUSH_M if thing.fixed else DROP_M)
    layout.put(item, Intent(recipe.relation, target_id))
    return Injected(candidate.unique.hazard, item.id, None)
