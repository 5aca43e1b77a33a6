"""Recipes as lines of YAML."""

from __future__ import annotations

from sdgen.catalog.records import PlaceRecipe, Recipe


def recipe_line(recipe: Recipe) -> str:
    """``{place: vase, relation: ON, target: floor}``: a recipe as the catalogue reads it."""
    if isinstance(recipe, PlaceRecipe):
        return _mapping(
            place=recipe.categories,
            state=recipe.state,
            not_state=recipe.not_state,
            relation=recipe.relation,
            target=recipe.targets,
            zone=recipe.zone,
            avoid_zones=recipe.avoid_zones,
            rooms=recipe.rooms,
            min_height_m=recipe.min_height_m,
            max_height_m=recipe.max_height_m,
        )
    return _mapping(set=recipe.categories, state=recipe.state, rooms=recipe.rooms)


def _mapping(**values: tuple[str, ...] | str | float | None) -> str:
    parts = [f"{key}: {_value(value)}" for key, value in values.items() if value not in (None, ())]
    return f"{{{', '.join(parts)}}}"


def _value(value: tuple[str, ...] | str | float | None) -> str:
    if isinstance(value, tuple):
        return value[0] if len(value) == 1 else f"[{', '.join(value)}]"
    return f"{value:g}" if isinstance(value, float) else str(value)
