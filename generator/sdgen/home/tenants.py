"""Whose home it is: which homes a household can live in, and what is there because it does.

Nothing of it decides a label: what is an anomaly follows from the scene.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass

from sdgen.catalog.records import (
    AgeGroup,
    Catalog,
    Category,
    FurnitureItem,
    Hazard,
    HomeMix,
    HomeSpec,
    HouseholdTemplate,
    PlaceRecipe,
    Recipe,
)
from sdgen.home.context import Models
from sdgen.library.records import Asset, AssetInfo
from sdgen.scene import Household, ObjectInstance
from sdgen.seeding import Rng

#: Width, metres, that a sleeper takes of a bed: beds for two begin at 1.3 m.
SLEEPER_M = 0.65


@dataclass(frozen=True)
class Tenants:
    """Who a home is furnished for. ``words`` are their pets, conditions and age groups, those of
    regular visitors too; ``beds`` is how many sleep there; ``asked`` are the drawn hazards;
    ``tidiness`` is 0 where things lie about, 1 where nothing does."""

    words: frozenset[str]
    beds: int
    asked: tuple[Hazard, ...] = ()
    tidiness: float = 0.5

    def have(self, belongs_to: Collection[str]) -> bool:
        """Whether what belongs to any of these words is theirs; what belongs to none always is."""
        return not belongs_to or not self.words.isdisjoint(belongs_to)

    def models(self, models: Models, catalog: Catalog) -> Models:
        """The models there may be in their home.

        What a drawn hazard cannot do without is there whoever lives there: the draw comes first.
        """
        not_theirs = {c.name for c in catalog.categories if not self.have(c.belongs_to)}
        for hazard in self.asked:
            if all(_kept_from(recipe, not_theirs) for recipe in hazard.anomalies):
                for recipe in hazard.anomalies:
                    not_theirs.difference_update(*_put_there(recipe))
        return lambda category: () if category in not_theirs else models(category)


def _put_there(recipe: Recipe) -> list[tuple[str, ...]]:
    """What a recipe puts into a home: of each of these, one."""
    if not isinstance(recipe, PlaceRecipe):
        return []
    near = recipe.near
    return [recipe.categories, *([near.to] if near is not None and near.bring else [])]


def _kept_from(recipe: Recipe, not_theirs: Collection[str]) -> bool:
    """Whether a recipe puts something there of which there is nothing in their home."""
    return any(set(names) <= set(not_theirs) for names in _put_there(recipe))


def wide_beds(models: Models, catalog: Catalog) -> Models:
    """The same models, but that beds for two are as wide as that."""
    sleeping = {c.name: c for c in catalog.categories if c.sleeps > 1}

    def wide(category: str) -> tuple[Asset, ...]:
        found = models(category)
        if category not in sleeping:
            return found
        full = sleeping[category].sleeps
        return tuple(m for m in found if sleepers(sleeping[category], m) == full) or found

    return wide


def sleepers(category: Category, model: AssetInfo) -> int:
    """How many sleep in a bed of this model: the category's, as far as it is wide enough."""
    return min(category.sleeps, max(1, int(model.extents_m[1] / SLEEPER_M)))


def beds_of(
    items: Iterable[ObjectInstance], infos: Mapping[str, AssetInfo], catalog: Catalog
) -> int:
    """How many can sleep in a home with these objects."""
    sleeping = {c.name: c for c in catalog.categories if c.sleeps}
    return sum(
        sleepers(sleeping[item.category], infos[item.asset])
        for item in items
        if item.category in sleeping
    )


def words_of(household: Household, groups: Sequence[AgeGroup], rng: Rng) -> frozenset[str]:
    """Pets, conditions and age groups of a household, and the age groups that visit it often.
    ``rng``: a lane of its own."""
    ages = [member.age for member in household.members]
    words = {*household.pets, *household.conditions}
    for group in groups:
        visited = rng.random() < group.visits
        if visited or any(age <= group.max_age for age in ages):
            words.add(group.name)
    return frozenset(words)


class Homes:
    """The homes of a catalogue, and which households can live in them."""

    def __init__(self, catalog: Catalog) -> None:
        self._catalog = catalog
        self._belongs = {t.name: t.belongs_to for t in catalog.room_types if t.belongs_to}
        self._sleeps = {c.name: c.sleeps for c in catalog.categories if c.sleeps}
        rules = {t.name: t.furniture for t in catalog.room_types}
        self._beds_by_rule = {
            name: sum(
                self._sleeps.get(rule.category, 0) * rule.count[0] for rule in found if rule.needed
            )
            for name, found in rules.items()
        }

    def fits(self, template: HouseholdTemplate, home: HomeMix | HomeSpec) -> bool:
        """Whether a household of this template can live in a home: it has the rooms they need, no
        room that belongs to others, and beds enough. A home for nobody is open to all."""
        return self._meant_for(template, home) or not any(
            self._meant_for(other, home) for other in self._catalog.households
        )

    def _meant_for(self, template: HouseholdTemplate, home: HomeMix | HomeSpec) -> bool:
        rooms = Counter(_rooms(home))
        theirs = _words_of_template(template, self._catalog.groups)
        return (
            Counter(template.rooms) <= rooms
            and template.sleepers <= self._beds(home)
            and all(theirs & set(self._belongs.get(room, theirs)) for room in rooms)
        )

    def _beds(self, home: HomeMix | HomeSpec) -> int:
        if isinstance(home, HomeMix):
            return sum(self._beds_by_rule.get(room, 0) for room in _rooms(home))
        pieces = (piece for room in home.rooms for piece in room.furniture if not piece.optional)
        return sum(self._sleepers(piece) for piece in pieces)

    def _sleepers(self, piece: FurnitureItem) -> int:
        """How many are sure to sleep in a piece: how wide a named model is only the library
        knows, and one finds a place in any."""
        places = self._sleeps.get(piece.category, 0)
        return places if piece.model is None else min(places, 1)

    def has_beds(self, home: HomeSpec, beds: int) -> bool:
        """Whether so many are sure to find beds in a home furnished for them."""
        if home.kind == "base":
            return self._beds(home) >= beds
        return sum(self._beds_by_rule.get(room, 0) for room in _rooms(home)) >= beds

    def needs_wide_beds(self, beds: int, home: HomeSpec) -> bool:
        """Whether so many only find beds there if those for two are for two."""
        rooms = [room for room in home.rooms if self._has_bed(room.type)]
        return beds > len(rooms)

    def _has_bed(self, room_type: str) -> bool:
        return self._beds_by_rule.get(room_type, 0) > 0


def _rooms(home: HomeMix | HomeSpec) -> tuple[str, ...]:
    if isinstance(home, HomeMix):
        return (home.hub, *home.rooms)
    return tuple(room.type for room in home.rooms)


def _words_of_template(template: HouseholdTemplate, groups: Sequence[AgeGroup]) -> set[str]:
    """The age groups of its youngest, and what pets and conditions it may have."""
    youngest = min(rule.age[0] for rule in template.members)
    young = {group.name for group in groups if youngest <= group.max_age}
    return {*young, *template.traits, ""}
