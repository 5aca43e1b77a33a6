"""Train, val and test, fixed by hash before anything is sampled.

A scene's split is its home's. Some assets and unique anomalies are withheld from train, so that
val and test show things and situations never seen in training.
"""

from __future__ import annotations

from collections.abc import Collection
from functools import cache
from typing import Literal

from sdgen.catalog.records import Catalog, Hazard, PlaceRecipe, UniqueAnomaly
from sdgen.library import Asset, Library
from sdgen.seeding import unit_hash

Split = Literal["train", "val", "test"]

#: The usual 70/15/15.
TRAIN_SHARE = 0.7
VAL_SHARE = 0.15
#: Enough that val and test have models and ways to happen that are new, few enough that train keeps
#: most of each kind.
WITHHELD_ASSETS = 0.2
WITHHELD_ANOMALIES = 0.15
#: A category with fewer models than this is never withheld: train would lose it.
FEWEST_MODELS = 3
#: And of a hazard with fewer ways to happen than this none is: train might lose them all.
FEWEST_WAYS = 10


def split_of_home(home_id: str) -> Split:
    """The split of every scene in this home."""
    value = unit_hash("home", home_id)
    if value < TRAIN_SHARE:
        return "train"
    return "val" if value < TRAIN_SHARE + VAL_SHARE else "test"


@cache
def _withheld(peers: tuple[tuple[str, str | None], ...]) -> frozenset[str]:
    """Of the models of a category (ids and suites), those that train never shows, at most a third;
    hashed once a process. What belongs together is withheld together: a suite, by its name."""
    if len(peers) < FEWEST_MODELS:
        return frozenset()
    values = {peer: unit_hash("asset", suite or peer) for peer, suite in peers}
    drawn = [p for p, value in values.items() if value > 1.0 - WITHHELD_ASSETS]
    drawn.sort(key=lambda p: (-values[p], p))
    return frozenset(drawn[: len(peers) // 3])


def withholds(hazard: Hazard) -> bool:
    """Whether some of a hazard's unique anomalies may be withheld from train."""
    placed = (recipe for recipe in hazard.anomalies if isinstance(recipe, PlaceRecipe))
    ways = {
        (category, recipe.state, recipe.relation, target)
        for recipe in placed
        for category in recipe.categories
        for target in recipe.targets
    }
    return len(ways) >= FEWEST_WAYS


def withheld_anomaly(anomaly: UniqueAnomaly) -> bool:
    """True for a unique anomaly that train never shows, of a hazard that withholds some."""
    key = [anomaly.hazard, anomaly.category, anomaly.state, anomaly.relation, anomaly.target]
    if anomaly.room is not None:
        key.append(anomaly.room)
    # What is only set to a state (an open fridge) has no target and is never withheld.
    return anomaly.target is not None and unit_hash("anomaly", *key) < WITHHELD_ANOMALIES


def _own(models: tuple[Asset, ...], library: Library) -> tuple[Asset, ...]:
    """Models of further folders than the first, and those of it whose states they lack."""
    theirs = [m for m in models if library.folder_of(m.id) != library.folders[0]]
    if not theirs:
        return models
    states = {state for model in theirs for state in model.state_names}
    return tuple(m for m in models if m in theirs or set(m.state_names) - states)


def small_categories(catalog: Catalog) -> frozenset[str]:
    """Categories of small things; furniture is planned with the sizes that ours has."""
    return frozenset(c.name for c in catalog.categories if c.kind in ("small", "hazard_only"))


class SplitModels:
    """The models a split may show: ``models(category)``.

    Of the categories ``own`` only models of further folders are shown where there are some; of ours
    those stay that can be in a state that none of these can.
    """

    def __init__(self, library: Library, split: Split, own: Collection[str] = ()) -> None:
        self._models: dict[str, tuple[Asset, ...]] = {}
        for category in library.categories:
            models = library.by_category(category)
            if category in own:
                models = _own(models, library)
            barred = _withheld(tuple((m.id, m.suite) for m in models)) if split == "train" else ()
            self._models[category] = tuple(m for m in models if m.id not in barred)

    def __call__(self, category: str) -> tuple[Asset, ...]:
        """Models of a category, sorted by id; empty when there is none."""
        return self._models.get(category, ())
