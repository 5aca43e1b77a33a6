"""Can a recipe make what its hazard's predicate asks for? Told before anything is built."""

from __future__ import annotations

from sdgen.catalog.entry import Entry
from sdgen.catalog.records import Hazard, PlaceRecipe, Recipe
from sdgen.catalog.terms.term import Case


def check_recipes(entry: Entry, hazard: Hazard) -> None:
    """Note anomalies that could never be one, and lookalikes that always would be."""
    for index, recipe in enumerate(hazard.anomalies):
        for name, case in cases(recipe):
            if not hazard.predicate.possible(case).be_true:
                message = f"{name} can never satisfy the predicate"
                entry.problem(message, "anomalies", index)
    for index, recipe in enumerate(hazard.lookalikes):
        for name, case in cases(recipe):
            if not hazard.predicate.possible(case).be_false:
                message = f"{name} satisfies the predicate: it would be an anomaly"
                entry.problem(message, "lookalikes", index)


def cases(recipe: Recipe) -> list[tuple[str, Case]]:
    """What a recipe can make, by name: one case a category and target."""
    if not isinstance(recipe, PlaceRecipe):
        return [
            (f"{category} {recipe.state}", Case(category, recipe.state, recipe.rooms))
            for category in recipe.categories
        ]
    return [
        (
            f"{category} {recipe.relation} {target}",
            Case(
                category,
                recipe.state,
                recipe.rooms,
                recipe.relation,
                target,
                recipe.zone,
                recipe.avoid_zones,
                recipe.min_height_m,
                recipe.max_height_m,
            ),
        )
        for category in recipe.categories
        for target in recipe.targets
    ]
