"""Classes no finer than their superclasses: a recogniser that says "Food" of all food."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from sdgen.catalog.records import Catalog, Category
from sdgen.perception.perceived import Perceived


def coarse(perceived: Perceived) -> Perceived:
    """The same home, every object named by its class's superclass.

    What is known of a class goes with its name: a superclass has the properties that all of its
    classes share, so that relations which ask for more (FACING: what is sat on, what is looked at)
    are gone, and predicates that ask for a class do not hold.
    """
    above = {category.name: category.superclass for category in perceived.catalog.categories}
    scene, infos = perceived.scene, perceived.infos
    return replace(
        perceived,
        scene=scene.model_copy(
            update={
                "objects": tuple(
                    item.model_copy(update={"category": above[item.category]})
                    for item in scene.objects
                )
            }
        ),
        infos={
            key: info.model_copy(update={"category": above[info.category]})
            for key, info in infos.items()
        },
        catalog=coarse_catalog(perceived.catalog),
    )


def coarse_catalog(catalog: Catalog) -> Catalog:
    """The catalogue with a category for each superclass."""
    members: dict[str, list[Category]] = {}
    for category in catalog.categories:
        members.setdefault(category.superclass, []).append(category)
    known = {category.name for category in catalog.categories}
    added = tuple(_above(name, of) for name, of in sorted(members.items()) if name not in known)
    return catalog.model_copy(update={"categories": (*catalog.categories, *added)})


def _above(name: str, of: Iterable[Category]) -> Category:
    first, *rest = of
    common = set(first.properties).intersection(*(other.properties for other in rest))
    return Category(
        name=name,
        superclass=name,
        extents_min_m=first.extents_min_m,
        extents_max_m=first.extents_max_m,
        mass_min_kg=first.mass_min_kg,
        mass_max_kg=first.mass_max_kg,
        properties=tuple(sorted(common)),
    )
