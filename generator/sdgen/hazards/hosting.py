"""Which hazards a build of one home alone has anything for: no stove is on where there is none.

Where there are several homes, or generated ones, a hazard that has no place anywhere is a mistake
in the catalogue, and told as one.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence

from sdgen.catalog.records import Catalog, Hazard, HomeSpec, Recipe, SetRecipe
from sdgen.errors import UsageError, did_you_mean


def hosted(
    catalog: Catalog, homes: Sequence[HomeSpec], generated: bool, only: Collection[str] = ()
) -> tuple[str, ...]:
    """Ids of the hazards that are drawn in these base homes and, if so, ``generated`` ones: all,
    or those of ``only``, but for those that an only home has nothing for. The rest are proved
    absent all the same."""
    asked = [hazard for hazard in catalog.hazards if not only or hazard.id in only]
    if generated or len(homes) != 1:
        return tuple(hazard.id for hazard in asked)
    (home,) = homes
    return tuple(hazard.id for hazard in asked if hosts(home, hazard, catalog))


def hosts(home: HomeSpec, hazard: Hazard, catalog: Catalog) -> bool:
    """True when a base home draws what a recipe of the hazard is about, in a room of its kind."""
    types = {room.type for room in home.rooms}
    there = {item.category for room in home.rooms for item in room.furniture}
    there |= {opening.kind for opening in home.openings} | {"floor"}
    there |= {fitting.category for fitting in catalog.fittings}
    return any(
        (not recipe.rooms or not types.isdisjoint(recipe.rooms))
        and not there.isdisjoint(_needed(recipe))
        for recipe in hazard.anomalies
    )


def _needed(recipe: Recipe) -> Sequence[str]:
    """Categories of which a recipe needs one to be there."""
    return recipe.categories if isinstance(recipe, SetRecipe) else recipe.targets


def check_named(names: Sequence[str], catalog: Catalog) -> None:
    """Raise UsageError for names that no hazard of the catalogue has, all of them."""
    known = [hazard.id for hazard in catalog.hazards]
    wrong = [f"{name!r}{did_you_mean(name, known)}" for name in names if name not in known]
    if wrong:
        raise UsageError(f"no hazard {', '.join(wrong)}")
