"""Puts one anomaly or lookalike into a layout: a thing to a place, or furniture to a state."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass
from itertools import product

from sdgen.actions import in_state
from sdgen.catalog.cases import cases, unique_anomaly
from sdgen.catalog.records import Near, PlaceRecipe, SetRecipe
from sdgen.hazards.candidates import Candidate
from sdgen.hazards.company import companions, near_some
from sdgen.hazards.spots import TARGETS_TRIED, put_by
from sdgen.hazards.states import changed
from sdgen.home.context import KEEP_CLEAR, HomeContext
from sdgen.home.layout import Layout, room_to_change
from sdgen.library.records import Asset
from sdgen.library.states import rest_states
from sdgen.scene import ObjectInstance
from sdgen.seeding import Rng

#: What is brought along lies at least clear of these, where it cannot be put aside.
AT_LEAST_CLEAR = ("doorway", "swing")


@dataclass(frozen=True)
class Injected:
    """The object that shows an anomaly (or lookalike) of ``hazard``, and what it was before;
    None for one that is new. ``brought`` are other objects that were put there, or changed, so
    that it is one: the heater beside the laundry."""

    hazard: str
    object_id: int
    before: ObjectInstance | None
    brought: tuple[int, ...] = ()


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
    return _place(candidate, candidate.recipe, layout, context, taken, rng, benign)


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
        after = _in_state(found[k], recipe, layout, context, rng)
        if after is not None:
            layout.put(after)
            return Injected(candidate.unique.hazard, after.id, found[k])
    return None


def _in_state(
    before: ObjectInstance, recipe: SetRecipe, layout: Layout, context: HomeContext, rng: Rng
) -> ObjectInstance | None:
    after = changed(before, recipe.state, layout, context, rng)
    if after is None or recipe.state not in after.states:
        return None
    return after if room_to_change(layout, context.home, before, after) else None


def set_further(
    candidate: Candidate,
    item: ObjectInstance,
    kept: Collection[str],
    layout: Layout,
    context: HomeContext,
    rng: Rng,
) -> Injected | None:
    """Bring a thing into the candidate's state as well, where it stays in those that are to be
    ``kept``; None, and no change, where it does not."""
    recipe = candidate.recipe
    if not isinstance(recipe, SetRecipe) or item not in _concerned(
        candidate, recipe, layout, context
    ):
        return None
    after = _in_state(item, recipe, layout, context, rng)
    if after is None or not set(kept) <= set(after.states):
        return None
    layout.put(after)
    return Injected(candidate.unique.hazard, item.id, item)


def _concerned(
    candidate: Candidate, recipe: SetRecipe, layout: Layout, context: HomeContext
) -> list[ObjectInstance]:
    """What of its category stands in the room of a candidate that sets a state, near what its
    recipe names."""
    rooms = recipe.rooms if candidate.unique.room is None else (candidate.unique.room,)
    found = [
        item
        for item in layout.items.values()
        if item.category == candidate.unique.category
        and (not rooms or context.room_type(item.room_id) in rooms)
    ]
    return near_some(recipe, found, layout)


def is_set_so(
    candidate: Candidate, item: ObjectInstance, layout: Layout, context: HomeContext
) -> bool:
    """Whether a thing is what the candidate would set, in the state that it would set it to."""
    recipe = candidate.recipe
    return (
        isinstance(recipe, SetRecipe)
        and recipe.state in item.states
        and item in _concerned(candidate, recipe, layout, context)
    )


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
    taken: Collection[int],
    rng: Rng,
    benign: bool,
) -> Injected | None:
    thing = _thing(candidate, recipe, layout, context, rng)
    if thing is None:
        return None
    hazard = candidate.unique.hazard
    if recipe.near is None:
        put = put_by(candidate, recipe, thing, None, layout, context, rng, benign)
        return None if put is None else Injected(hazard, put, None)
    several = recipe.near.count > 1
    found = () if several else companions(recipe.near, layout, context, taken, rng)
    for companion in found:
        # First, since what comes to stand on a burner is in its flame's way.
        if companion.before is not None:
            layout.put(companion.item)
        put = put_by(candidate, recipe, thing, companion.item, layout, context, rng, benign)
        if put is not None:
            changes = companion.before is not None
            return Injected(hazard, put, None, (companion.item.id,) if changes else ())
        if companion.before is not None:
            layout.put(companion.before)
    if not recipe.near.bring:
        return None
    put = put_by(candidate, recipe, thing, None, layout, context, rng, benign)
    if put is None:
        return None
    brought: list[int] = []
    while len(brought) < recipe.near.count:
        item, in_the_way = layout.items[put], bool(recipe.zone or recipe.before)
        other = _brought_along(candidate, recipe.near, item, in_the_way, layout, context, rng)
        if other is None:
            for key in (put, *brought):
                layout.drop(key)
            return None
        brought.append(other)
    return Injected(hazard, put, None, tuple(brought))


def _brought_along(
    candidate: Candidate,
    near: Near,
    item: ObjectInstance,
    in_the_way: bool,
    layout: Layout,
    context: HomeContext,
    rng: Rng,
) -> int | None:
    """Put what a thing is to be near beside it, on what the thing itself is on or else on the
    floor; its id, or None where there is no room. Furniture is never brought.

    What only helps to make it one lies aside or, where it cannot, at least clear of doors, unless
    the thing itself is to be ``in_the_way``.
    """
    names = [n for n in near.to if context.catalog.category(n).kind != "furniture"]
    targets = dict.fromkeys((candidate.unique.target or "floor", "floor"))
    keep_clear = ((),) if in_the_way else (KEEP_CLEAR, AT_LEAST_CLEAR)
    for target, clear in product(targets, keep_clear):
        if target != "floor" and clear == AT_LEAST_CLEAR:
            continue
        for k in rng.permutation(len(names)).tolist():
            recipe = PlaceRecipe(
                categories=(names[k],),
                state=near.to_state,
                relation="ON",
                targets=(target,),
                rooms=(context.room_type(item.room_id),),
                avoid_zones=clear,
                near=Near(to=(item.category,), max_m=near.max_m),
            )
            other = Candidate(unique_anomaly(candidate.unique.hazard, cases(recipe)[0]), recipe)
            thing = _thing(other, recipe, layout, context, rng)
            if thing is not None:
                put = put_by(other, recipe, thing, item, layout, context, rng, False)
                if put is not None:
                    return put
    return None


def _thing(
    candidate: Candidate, recipe: PlaceRecipe, layout: Layout, context: HomeContext, rng: Rng
) -> ObjectInstance | None:
    """A new thing in the recipe's state, nowhere yet: what it fills decides where it fits."""
    models = [m for m in context.models(candidate.unique.category) if _will_do(m, recipe)]
    if not models:
        return None
    asset = models[int(rng.integers(len(models)))]
    thing = layout.new_thing(asset)
    if context.catalog.category(asset.category).kind == "hazard_only":
        thing = thing.model_copy(update={"fixed": True})
    return thing if recipe.state is None else in_state(thing, asset, recipe.state, rng)


def _will_do(model: Asset, recipe: PlaceRecipe) -> bool:
    """Whether a model can be in the recipe's state, and does not come in one that it excludes."""
    return (recipe.state is None or recipe.state in model.state_names) and set(
        recipe.not_state
    ).isdisjoint(rest_states(model))
