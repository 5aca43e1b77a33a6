"""Brings a scene's drawn anomalies and some lookalikes about."""

from __future__ import annotations

from collections.abc import Collection, Sequence

from sdgen.catalog.records import Hazard, PlaceRecipe, UniqueAnomaly
from sdgen.hazards.candidates import Candidate, candidates, lacking, weighted_order
from sdgen.hazards.placing import (
    Injected,
    already_set,
    inject_candidate,
    is_set_so,
    set_further,
)
from sdgen.hazards.splits import withheld_anomaly, withholds
from sdgen.home.context import HomeContext
from sdgen.home.layout import Layout
from sdgen.rejection import Rejection, reject
from sdgen.scene import ObjectInstance
from sdgen.seeding import Rng

#: Bound the search; a try that finds no place is cheap and the next is drawn anew.
CANDIDATES_TRIED = 20
#: Of the hazards, this many have a near miss in a scene, so that having one says little.
LOOKALIKE_SHARE = 0.85
LOOKALIKE_CANDIDATES_TRIED = 30
#: The check that fails where all that a recipe could set is in that state from the start.
ALREADY_SET = "already_set"


def inject(
    hazards: Sequence[str], layout: Layout, context: HomeContext, training: bool, rng: Rng
) -> tuple[Injected, ...] | Rejection:
    """One anomaly of each drawn hazard. ``training`` leaves withheld unique anomalies out."""
    anomalies: list[Injected] = []
    for hazard_id in hazards:
        hazard = context.catalog.hazard(hazard_id)
        allowed = candidates(hazard_id, hazard.anomalies, layout, context)
        if training and withholds(hazard):
            allowed = [one for one in allowed if not withheld_anomaly(one.unique)]
        taken = _objects(anomalies)
        order = weighted_order(allowed, rng)[:CANDIDATES_TRIED]
        injected = _brought_already(order, anomalies, layout, context)
        injected = injected or _inject_first(order, layout, context, taken, rng)
        injected = injected or _of_the_same(order, anomalies, layout, context, rng)
        if injected is None:
            return _no_place(hazard_id, allowed, layout, context)
        anomalies.append(injected)
    return tuple(anomalies)


def inject_unique(
    unique: UniqueAnomaly, layout: Layout, context: HomeContext, rng: Rng
) -> Injected | Rejection | None:
    """This anomaly by the recipes that make it, and no other; None where the home has nothing for
    it."""
    recipes = context.catalog.hazard(unique.hazard).anomalies
    every = candidates(unique.hazard, recipes, layout, context)
    allowed = [
        one
        for one in every
        if one.unique == unique and already_set(one, layout, context) is not None
    ]
    if not allowed:
        return None
    order = weighted_order(allowed, rng)
    injected = _inject_first(order, layout, context, (), rng)
    return injected or _no_place(unique.hazard, allowed, layout, context)


def _objects(injected: Sequence[Injected]) -> set[int]:
    """Ids of what these put, changed and brought along."""
    return {key for one in injected for key in (one.object_id, *one.brought)}


def _brought_already(
    order: Sequence[Candidate],
    anomalies: Sequence[Injected],
    layout: Layout,
    context: HomeContext,
) -> Injected | None:
    """What another anomaly brought into the very state that this hazard is: the stove that was
    switched on under a pan."""
    for candidate in order:
        for other in anomalies:
            for key in other.brought:
                if is_set_so(candidate, layout.items[key], layout, context):
                    return Injected(candidate.unique.hazard, key, layout.items[key])
    return None


def _of_the_same(
    order: Sequence[Candidate],
    anomalies: Sequence[Injected],
    layout: Layout,
    context: HomeContext,
    rng: Rng,
) -> Injected | None:
    """What another anomaly is already, or becomes and stays what it was for that one: the only bath
    of a home, full, that runs over."""
    for candidate in order:
        for other in anomalies:
            item = layout.items[other.object_id]
            if is_set_so(candidate, item, layout, context):
                return Injected(candidate.unique.hazard, item.id, item)
            kept = _states_of(item, anomalies, context)
            further = set_further(candidate, item, kept, layout, context, rng)
            if further is not None:
                return further
    return None


def _states_of(
    item: ObjectInstance, anomalies: Sequence[Injected], context: HomeContext
) -> frozenset[str]:
    """The states that make a thing the anomalies that it is."""
    return frozenset(
        recipe.state
        for one in anomalies
        if one.object_id == item.id
        for recipe in context.catalog.hazard(one.hazard).anomalies
        if recipe.state is not None
        and item.category in recipe.categories
        and recipe.state in item.states
    )


def _no_place(
    hazard_id: str, allowed: Sequence[Candidate], layout: Layout, context: HomeContext
) -> Rejection:
    """``lacks`` with a category of which the home has none, where each recipe needs one;
    ``already_set`` with the category and the state, where all recipes ask for what there is
    already; else ``no_place``."""
    if not allowed:
        missing = lacking(context.catalog.hazard(hazard_id).anomalies, layout, context)
        if missing is not None:
            return reject("hazards", "lacks", hazard=hazard_id, category=missing)
    already = [already_set(one, layout, context) for one in allowed]
    if True in already and False not in already:
        unique = allowed[already.index(True)].unique
        return reject(
            "hazards", ALREADY_SET, hazard=hazard_id, category=unique.category, state=unique.state
        )
    return reject("hazards", "no_place", hazard=hazard_id)


def add_lookalikes(
    layout: Layout,
    context: HomeContext,
    anomalies: Sequence[Injected],
    rng: Rng,
    only: Collection[str] = (),
) -> tuple[Injected, ...]:
    """One benign near miss for most hazards (of ``only``, unless it is empty), whether or not they
    were drawn.

    A home holds as many things of a kind with an anomaly as without: where a hazard's anomaly was
    put, it stands for the near miss of its own kind, or a second candle would tell of a lit one.
    What comes to lie on or in an anomaly (a kettle on a burning stove, as on a cold one) is an
    everyday thing, and no near miss.
    """
    lookalikes: list[Injected] = []
    anomalous = _objects(anomalies)
    put = {other.hazard for other in anomalies if other.before is None}
    for hazard in context.catalog.hazards:
        if only and hazard.id not in only:
            continue
        wanted = rng.random() < LOOKALIKE_SHARE
        order = weighted_order(candidates(hazard.id, hazard.lookalikes, layout, context), rng)
        if not wanted:
            continue
        taken = _objects([*anomalies, *lookalikes])
        order = order[:LOOKALIKE_CANDIDATES_TRIED]
        injected = _inject_first(order, layout, context, taken, rng, benign=True)
        if injected is None:
            continue
        if hazard.id in put and layout.items[injected.object_id].category in _put_kinds(hazard):
            layout.drop(injected.object_id)
        elif injected.before is not None or _target(layout, injected) not in anomalous:
            lookalikes.append(injected)
    return tuple(lookalikes)


def _put_kinds(hazard: Hazard) -> frozenset[str]:
    """What a hazard's recipes put somewhere."""
    return frozenset(
        category
        for recipe in hazard.anomalies
        if isinstance(recipe, PlaceRecipe)
        for category in recipe.categories
    )


def _target(layout: Layout, injected: Injected) -> int:
    """What a new thing was put on or in."""
    return layout.intents[injected.object_id].target_id


def _inject_first(
    order: Sequence[Candidate],
    layout: Layout,
    context: HomeContext,
    taken: Collection[int],
    rng: Rng,
    benign: bool = False,
) -> Injected | None:
    """The first candidate that fits; None, and nothing changed, when none does."""
    for candidate in order:
        injected = inject_candidate(candidate, layout, context, taken, rng, benign)
        if injected is not None:
            return injected
    return None
