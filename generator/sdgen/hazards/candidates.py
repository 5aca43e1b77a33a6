"""Which unique anomalies of a hazard a given home allows, and in which order they are tried."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Sequence
from dataclasses import dataclass

import numpy as np

from sdgen.catalog.records import Recipe, SetRecipe, UniqueAnomaly
from sdgen.home.context import HomeContext
from sdgen.home.layout import Layout
from sdgen.seeding import Rng

#: Recipes of weight 0 come last, in a random order.
LEAST_WEIGHT = 1e-9


@dataclass(frozen=True)
class Candidate:
    """One unique anomaly (or lookalike) that a home allows, and the recipe that makes it."""

    unique: UniqueAnomaly
    recipe: Recipe


def candidates(
    hazard: str, recipes: Sequence[Recipe], layout: Layout, context: HomeContext
) -> list[Candidate]:
    """All that these recipes allow with the models and the furniture at hand, in recipe order."""
    present = {item.category for item in layout.items.values()} | {"floor"}
    return [
        Candidate(unique, recipe)
        for recipe in recipes
        for category in recipe.categories
        if isinstance(recipe, SetRecipe) or context.models(category)
        for unique in _unique(hazard, recipe, category, present)
    ]


def _unique(
    hazard: str, recipe: Recipe, category: str, present: Collection[str]
) -> list[UniqueAnomaly]:
    """The unique anomalies that a recipe makes of one category with what is ``present``: one a
    target, if it has any."""
    relation = None if isinstance(recipe, SetRecipe) else recipe.relation
    targets = (None,) if isinstance(recipe, SetRecipe) else recipe.targets
    return [
        UniqueAnomaly(
            hazard=hazard, category=category, state=recipe.state, relation=relation, target=target
        )
        for target in targets
        if (target or category) in present
    ]


def weighted_order(among: Sequence[Candidate], rng: Rng) -> list[Candidate]:
    """Candidates in a random order by their recipes' weights; no category crowds out another.

    Efraimidis and Spirakis (2006): sorting by u^(1/w) draws without replacement by weight; its
    logarithm, log(u)/w, does not underflow where weights are tiny.
    """
    if not among:
        return []
    sharing = Counter((id(one.recipe), one.unique.category) for one in among)
    weights = np.array(
        [
            max(one.recipe.weight, LEAST_WEIGHT) / sharing[id(one.recipe), one.unique.category]
            for one in among
        ]
    )
    keys = np.log(np.maximum(rng.random(len(among)), np.finfo(float).tiny)) / weights
    return [among[k] for k in np.argsort(-keys, kind="stable").tolist()]
