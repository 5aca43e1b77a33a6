"""Which unique anomalies of a hazard a given home allows, and in which order they are tried."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from sdgen.catalog.cases import cases, unique_anomaly
from sdgen.catalog.records import Recipe, SetRecipe, UniqueAnomaly
from sdgen.catalog.terms.term import Case
from sdgen.home.context import HomeContext
from sdgen.home.layout import Layout
from sdgen.seeding import Rng, weighted_keys


@dataclass(frozen=True)
class Candidate:
    """One unique anomaly (or lookalike) that a home allows, and the recipe that makes it."""

    unique: UniqueAnomaly
    recipe: Recipe


def candidates(
    hazard: str, recipes: Sequence[Recipe], layout: Layout, context: HomeContext
) -> list[Candidate]:
    """All that these recipes allow with the models, rooms and furniture at hand, in their order."""
    present = {item.category for item in layout.items.values()} | {"floor"}
    rooms = {room.type for room in context.home.rooms}
    return [
        Candidate(unique_anomaly(hazard, case), recipe)
        for recipe in recipes
        if not recipe.rooms or not rooms.isdisjoint(recipe.rooms)
        for case in _possible(recipe, present, context)
    ]


def lacking(recipes: Sequence[Recipe], layout: Layout, context: HomeContext) -> str | None:
    """What the home has none of, nor may get, and each of the recipes needs: the first such thing
    of the first recipe that is kept from its rooms by nothing else. None: something else fails."""
    present = {item.category for item in layout.items.values()} | {"floor"}
    wanting: list[str] = []
    for recipe in recipes:
        needs = [recipe.categories] if isinstance(recipe, SetRecipe) else [recipe.targets]
        brought = [] if isinstance(recipe, SetRecipe) else [recipe.categories]
        if recipe.near is not None:
            (brought if recipe.near.bring else needs).append(recipe.near.to)
        found = [names for names in needs if present.isdisjoint(names)]
        found += [
            names
            for names in brought
            if present.isdisjoint(names) and not any(context.models(name) for name in names)
        ]
        if not found:
            return None
        wanting.append(found[0][0])
    return wanting[0] if wanting else None


def _possible(recipe: Recipe, present: Collection[str], context: HomeContext) -> Iterator[Case]:
    """What :func:`~sdgen.catalog.cases.cases` says of a recipe, as far as the home has it."""
    near = recipe.near
    if near is not None and not any(
        name in present or (near.bring and context.models(name)) for name in near.to
    ):
        return
    rooms = {room.type for room in context.home.rooms}
    for case in cases(recipe):
        there = case.target in present and bool(context.models(case.category))
        if isinstance(recipe, SetRecipe):
            there = case.category in present
        if there and (not case.rooms or not rooms.isdisjoint(case.rooms)):
            yield case


def weighted_order(among: Sequence[Candidate], rng: Rng) -> list[Candidate]:
    """Candidates in a random order by their recipes' weights; no category crowds out another."""
    sharing = Counter((id(one.recipe), one.unique.category) for one in among)
    weights = [one.recipe.weight / sharing[id(one.recipe), one.unique.category] for one in among]
    keys = weighted_keys(rng, weights)
    return [among[k] for k in np.argsort(-keys, kind="stable").tolist()]
