"""What recipes make: each of their categories with each of their targets."""

from __future__ import annotations

from functools import cache

from sdgen.catalog.records import Recipe, SetRecipe, UniqueAnomaly
from sdgen.catalog.terms.term import Case


def cases(recipe: Recipe) -> list[Case]:
    """What a recipe can make, in its order: one case a category and target, if it has targets."""
    # What stands in each of the rooms that it names, or lies on its floor, is a way of its own to
    # happen: "stove" and "floor" alone say too little.
    rooms: list[tuple[str, ...]] = [(room,) for room in recipe.rooms] or [()]
    if isinstance(recipe, SetRecipe):
        return [
            Case(category, recipe.state, room) for category in recipe.categories for room in rooms
        ]
    return [
        Case(
            category,
            recipe.state,
            room,
            recipe.relation,
            target,
            recipe.zone,
            recipe.avoid_zones,
            recipe.min_height_m,
            recipe.max_height_m,
            recipe.not_state,
            recipe.zone_share,
        )
        for category in recipe.categories
        for target in recipe.targets
        for room in (rooms if target == "floor" else [recipe.rooms])
    ]


def placements(recipe: Recipe) -> int:
    """How many cases a recipe has, told without making them."""
    rooms = max(1, len(recipe.rooms))
    if isinstance(recipe, SetRecipe):
        return len(recipe.categories) * rooms
    return len(recipe.categories) * sum(rooms if t == "floor" else 1 for t in recipe.targets)


@cache
def unique_anomaly(hazard: str, case: Case) -> UniqueAnomaly:
    """The case as an anomaly (or a near miss) of a hazard; made once a process."""
    return UniqueAnomaly(
        hazard=hazard,
        category=case.category,
        state=case.state,
        relation=case.relation,
        target=case.target,
        room=case.rooms[0] if case.rooms and case.target in (None, "floor") else None,
    )
