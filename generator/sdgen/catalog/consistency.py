"""Can a recipe make what its hazard's predicate asks for? Told before anything is built."""

from __future__ import annotations

from typing import NamedTuple

from sdgen.catalog.reader import Reader
from sdgen.catalog.records import (
    AllTerm,
    AnyTerm,
    CategoryTerm,
    Hazard,
    HeightTerm,
    NotTerm,
    PlaceRecipe,
    Predicate,
    Recipe,
    RelationTerm,
    RoomTerm,
    StateTerm,
    ZoneTerm,
)

_OPPOSITE = {"ON": "OFF", "OFF": "ON", "OPEN": "CLOSED", "CLOSED": "OPEN"}


class Can(NamedTuple):
    """What a predicate could be of an object that follows a recipe, as far as the recipe says."""

    be_true: bool
    be_false: bool


_EITHER, _TRUE, _FALSE = Can(True, True), Can(True, False), Can(False, True)


def check_recipes(reader: Reader, hazard: Hazard) -> None:
    """Note anomalies that could never be one, and lookalikes that always would be."""
    for index, recipe in enumerate(hazard.anomalies):
        for name, category, target in _cases(recipe):
            if not can(hazard.predicate, recipe, category, target).be_true:
                message = f"{name} can never satisfy the predicate"
                reader.problem(message, "anomalies", index)
    for index, recipe in enumerate(hazard.lookalikes):
        for name, category, target in _cases(recipe):
            if not can(hazard.predicate, recipe, category, target).be_false:
                message = f"{name} satisfies the predicate: it would be an anomaly"
                reader.problem(message, "lookalikes", index)


def _cases(recipe: Recipe) -> list[tuple[str, str, str | None]]:
    if isinstance(recipe, PlaceRecipe):
        return [
            (f"{category} {recipe.relation} {target}", category, target)
            for category in recipe.categories
            for target in recipe.targets
        ]
    return [(f"{category} {recipe.state}", category, None) for category in recipe.categories]


def can(predicate: Predicate, recipe: Recipe, category: str, target: str | None) -> Can:
    """Possible values of a predicate for a category and target of a recipe."""
    if isinstance(predicate, AllTerm | AnyTerm):
        parts = [can(term, recipe, category, target) for term in predicate.terms]
        if isinstance(predicate, AllTerm):
            return Can(all(p.be_true for p in parts), any(p.be_false for p in parts))
        return Can(any(p.be_true for p in parts), all(p.be_false for p in parts))
    if isinstance(predicate, NotTerm):
        inner = can(predicate.term, recipe, category, target)
        return Can(inner.be_false, inner.be_true)
    if isinstance(predicate, CategoryTerm):
        return _TRUE if category in predicate.any_of else _FALSE
    if isinstance(predicate, StateTerm):
        if recipe.state in predicate.any_of:
            return _TRUE
        return _FALSE if set(predicate.any_of) == {_OPPOSITE.get(recipe.state or "")} else _EITHER
    if isinstance(predicate, RoomTerm):
        inside = set(recipe.rooms) & set(predicate.any_of)
        return _FALSE if recipe.rooms and not inside else _EITHER
    if isinstance(recipe, PlaceRecipe) and target is not None:
        return _placed(predicate, recipe, target)
    return _EITHER


def _placed(predicate: Predicate, recipe: PlaceRecipe, target: str) -> Can:
    if isinstance(predicate, RelationTerm) and predicate.relation == recipe.relation:
        if predicate.targets and target not in predicate.targets:
            return _FALSE
        return _EITHER if predicate.target_state else _TRUE
    if isinstance(predicate, HeightTerm):
        floor = target == "floor" and recipe.relation == "ON"
        low = 0.0 if floor else recipe.min_height_m
        high = 0.0 if floor else recipe.max_height_m
        under = high is not None and predicate.min_m is not None and high < predicate.min_m
        over = low is not None and predicate.max_m is not None and low > predicate.max_m
        return _FALSE if under or over else _EITHER
    if isinstance(predicate, ZoneTerm):
        if set(recipe.zone) and set(recipe.zone) <= set(predicate.any_of):
            return _TRUE
        return _FALSE if set(predicate.any_of) <= set(recipe.avoid_zones) else _EITHER
    return _EITHER
