"""Train, val and test, fixed by hash before anything is sampled.

A scene's split is its home's. Some assets and unique anomalies are withheld from train, so that
val and test show things and situations never seen in training.
"""

from __future__ import annotations

from typing import Literal

from sdgen.catalog.records import UniqueAnomaly
from sdgen.library import Asset, Library
from sdgen.seeding import unit_hash

Split = Literal["train", "val", "test"]

TRAIN_SHARE = 0.7
VAL_SHARE = 0.15
WITHHELD_ASSETS = 0.2
WITHHELD_ANOMALIES = 0.15
#: A category with fewer models than this is never withheld: train would lose it.
FEWEST_MODELS = 3


def split_of_home(home_id: str) -> Split:
    """The split of every scene in this home."""
    value = unit_hash("home", home_id)
    if value < TRAIN_SHARE:
        return "train"
    return "val" if value < TRAIN_SHARE + VAL_SHARE else "test"


def withheld_asset(asset_id: str, library: Library) -> bool:
    """True for an asset that train never shows: at most a third of a category."""
    peers = [peer.id for peer in library.by_category(library.assets[asset_id].category)]
    if len(peers) < FEWEST_MODELS:
        return False
    drawn = [p for p in peers if unit_hash("asset", p) > 1.0 - WITHHELD_ASSETS]
    drawn.sort(key=lambda p: (-unit_hash("asset", p), p))
    return asset_id in drawn[: len(peers) // 3]


def withheld_anomaly(anomaly: UniqueAnomaly) -> bool:
    """True for a unique anomaly that train never shows."""
    key = (anomaly.hazard, anomaly.category, anomaly.state, anomaly.relation, anomaly.target)
    # A hazard with one way to happen (fridge_open) has no target and is never withheld.
    return anomaly.target is not None and unit_hash("anomaly", *key) < WITHHELD_ANOMALIES


class SplitModels:
    """The models a split may show: ``models(category)``."""

    def __init__(self, library: Library, split: Split) -> None:
        self._models = {
            category: tuple(
                asset
                for asset in library.by_category(category)
                if split != "train" or not withheld_asset(asset.id, library)
            )
            for category in library.categories
        }

    def __call__(self, category: str) -> tuple[Asset, ...]:
        """Models of a category, sorted by id; empty when there is none."""
        return self._models.get(category, ())
