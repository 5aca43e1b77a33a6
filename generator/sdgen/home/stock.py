"""What a home has so far of everyday things, and what more may lie where."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from sdgen.catalog.records import Abode, Category
from sdgen.geometry import Array, Vec3
from sdgen.home.context import HomeContext
from sdgen.home.layout import Layout
from sdgen.library.records import Asset
from sdgen.library.states import rest_states
from sdgen.scene import ObjectInstance, Room
from sdgen.seeding import Rng

#: Draws for one thing where the home has enough of what was drawn, or the room has one already.
PICKS = 6
#: How often what a room has one of is passed over for something else, unless it comes in several.
SECOND_PASSED_OVER = 0.7
#: So many of one model lie about in a home; rows and piles have as many as they need.
COPIES_MOST = 3


class Stock:
    """What a home has so far, counted as the catalogue bounds it."""

    def __init__(self, layout: Layout) -> None:
        self._home: Counter[str] = Counter()
        self._rooms: Counter[tuple[int, str]] = Counter()
        self._models: set[tuple[int, str]] = set()
        self._copies: Counter[str] = Counter()
        for item in layout.items.values():
            intent = layout.intents.get(item.id)
            self.add(item, None if intent is None else intent.target_id)

    def add(self, item: ObjectInstance, target_id: int | None) -> None:
        """Count a thing that was put on or in a target."""
        self._home[item.category] += 1
        self._rooms[item.room_id, item.category] += 1
        self._copies[item.asset] += 1
        if target_id is not None:
            self._models.add((target_id, item.asset))

    def count(self, category: str) -> int:
        """How many of a category there are in all."""
        return self._home[category]

    def full(self, category: Category, room_id: int, more: int = 0) -> bool:
        """True when the room, or the home, has as many of a category as it may, ``more`` of them
        not counted yet."""
        name = category.name
        in_room, in_home = self._rooms[room_id, name] + more, self._home[name] + more
        return category.at_most.reached(in_room, in_home)

    def enough(self, category: Category, room_id: int, rng: Rng) -> bool:
        """Draws whether one in a room will do: a second clock beside the first looks put there by
        a machine."""
        there = self._rooms[room_id, category.name]
        return bool(there and not category.alike and rng.random() < SECOND_PASSED_OVER)

    def too_common(self, asset_id: str) -> bool:
        """True when a visitor would notice how many of this model there are."""
        return self._copies[asset_id] >= COPIES_MOST

    def stands_on(self, target_id: int, asset_id: str) -> bool:
        """True when one of this model is on or in the target."""
        return (target_id, asset_id) in self._models


class Pick(NamedTuple):
    """A model to be put somewhere, as one of its category's abodes says."""

    category: Category
    abode: Abode
    asset: Asset


@dataclass(frozen=True)
class Choices:
    """What lives in one place: categories with how they lie there, and the sums of their weights
    up to each, as shares."""

    among: tuple[tuple[Category, Abode, Sequence[Asset]], ...]
    sums: Array

    def pick(self, room_id: int, target_id: int, stock: Stock, rng: Rng) -> Pick | None:
        """A model by the abodes' weights, any of its category's; None when all that were drawn
        are there as often as they may be."""
        for _ in range(PICKS):
            picked = self.draw(rng)
            category, asset = picked.category, picked.asset
            if stock.full(category, room_id) or stock.enough(category, room_id, rng):
                continue
            if stock.too_common(asset.id):
                continue
            if category.alike or not stock.stands_on(target_id, asset.id):
                return picked
        return None

    def no_larger(self, size_m: Vec3, full: Callable[[Category], bool]) -> Choices | None:
        """The same but for models that are deeper, wider or higher and categories of which there
        are enough; None when none is left."""
        smaller = (
            (category, abode, [m for m in models if _within(m, size_m)])
            for category, abode, models in self.among
            if not full(category)
        )
        return choices_of([one for one in smaller if one[2]])

    @property
    def narrowest_m(self) -> float:
        """How wide the narrowest of the models is."""
        return min(model.extents_m[1] for _, _, models in self.among for model in models)

    def draw(self, rng: Rng) -> Pick:
        """A model by the abodes' weights, whatever the home has already."""
        # What rng.choice with weights does, without summing them again for every thing.
        k = int(self.sums.searchsorted(rng.random(), side="right"))
        category, abode, models = self.among[k]
        return Pick(category, abode, models[int(rng.integers(len(models)))])


def choices_of(among: Sequence[tuple[Category, Abode, Sequence[Asset]]]) -> Choices | None:
    """Choices among these by the abodes' weights; None of nothing."""
    weights = np.array([abode.weight for _, abode, _ in among])
    if weights.sum() <= 0:
        return None
    sums = (weights / weights.sum()).cumsum()
    return Choices(tuple(among), sums / sums[-1])


def _within(model: Asset, size_m: Vec3) -> bool:
    return all(a <= b for a, b in zip(model.extents_m, size_m, strict=True))


def living_so(category: Category, abode: Abode, models: Sequence[Asset]) -> Sequence[Asset]:
    """The models of a category that live as one of its abodes says.

    What comes in a state that some abode names (a cut apple) lives where such abodes say alone.
    """
    named = {other.state for other in category.lives} - {None}
    if not named:
        return models
    if abode.state is not None:
        return [model for model in models if abode.state in rest_states(model)]
    return [model for model in models if named.isdisjoint(rest_states(model))]


class Abodes:
    """What lives where in a home, by the catalogue and the models at hand."""

    def __init__(self, context: HomeContext) -> None:
        self._by_target: dict[str, list[tuple[Category, Abode, Sequence[Asset]]]] = {}
        self._known: dict[object, Choices | None] = {}
        for category in context.catalog.categories:
            for abode in category.lives if category.kind == "small" else ():
                models = living_so(category, abode, context.models(category.name))
                for target in dict.fromkeys(abode.targets) if models else ():
                    self._by_target.setdefault(target, []).append((category, abode, models))

    def choices(
        self,
        target: str,
        room: Room,
        of: tuple[str, ...] | None = None,
        but: tuple[str, ...] = (),
        relation: str | None = None,
    ) -> Choices | None:
        """What lives on or in a target in a room, ``of`` these categories (None: any) ``but``
        those, in this relation (None: either); None when nothing does."""
        key = (target, room.type, of, but, relation)
        if key not in self._known:
            self._known[key] = choices_of(
                [
                    (category, abode, models)
                    for category, abode, models in self._by_target.get(target, ())
                    if (not abode.rooms or room.type in abode.rooms)
                    and (of is None or category.name in of)
                    and category.name not in but
                    and relation in (None, abode.relation)
                ]
            )
        return self._known[key]
