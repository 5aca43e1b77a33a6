"""Trees over crops: a small classifier of pictures that needs no network."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from sdgen.dataset import Dataset, SceneItem
from sdgen.detectors.boosted import Boosted, Growth, grow
from sdgen.detectors.graph_classifier import numbers
from sdgen.detectors.picture_columns import WIDTH, columns_of
from sdgen.detectors.pictures import TELL_VIEWS, Crops, PictureExamples, by_thing, crops_of
from sdgen.detectors.scored import Array, Hazards, Scored
from sdgen.detectors.told import things
from sdgen.seeding import lane

FINDING = Growth(rounds=200, rate=0.1, leaves=24, share=0.15)
NAMING = Growth(rounds=40, leaves=8, leaf_rows=5, share=0.15)


@dataclass(frozen=True)
class ImageClassifier:
    """Scores each thing that some view shows, the mean of what it says of its best views."""

    hazards: Hazards
    named: tuple[int, ...]
    finding: Boosted
    naming: Boosted

    def __call__(self, data: Dataset, item: SceneItem) -> tuple[Scored, ...]:
        wanted = {node.id for node in things(item.shown_graph)}
        crops = crops_of(item, wanted, TELL_VIEWS)
        if not len(crops.ids):
            return ()
        x = columns_of(crops)
        shares = np.zeros((len(x), len(self.hazards.names)))
        shares[:, self.named] = self.naming.probabilities(x)
        ids, means = by_thing(crops.ids, np.hstack([self.finding.probabilities(x)[:, 1:], shares]))
        return self.hazards.scored(ids, means[:, 0], means[:, 1:])

    def arrays(self) -> dict[str, Array]:
        return {
            "named": np.array(self.named, dtype=np.int64),
            **self.finding.arrays("finding"),
            **self.naming.arrays("naming"),
        }

    def words(self) -> dict[str, tuple[str, ...]]:
        return {}

    @classmethod
    def from_file(
        cls, arrays: Mapping[str, Array], words: Mapping[str, tuple[str, ...]], hazards: Hazards
    ) -> ImageClassifier:
        """The classifier that was kept. ValueError for what does not fit together."""
        named = numbers(arrays, "named", len(hazards.names))
        return cls(
            hazards=hazards,
            named=named,
            finding=Boosted.from_arrays(arrays, "finding", WIDTH, 2),
            naming=Boosted.from_arrays(arrays, "naming", WIDTH, len(named)),
        )


def fit_images(examples: PictureExamples, hazards: Hazards, seed: int) -> ImageClassifier:
    """Train on crops."""
    crops = Crops(np.arange(len(examples.hazard)), examples.pixels, examples.place)
    x = columns_of(crops)
    wrong = examples.hazard >= 0
    named = sorted(set(examples.hazard[wrong].tolist()))
    place = {number: k for k, number in enumerate(named)}
    which = np.array([place[k] for k in examples.hazard[wrong].tolist()], dtype=np.int64)
    start = int(lane(seed, 0, "train:image").integers(2**31))
    return ImageClassifier(
        hazards=hazards,
        named=tuple(named),
        finding=grow(x, wrong.astype(np.int64), 2, FINDING, start),
        naming=grow(x[wrong], which, len(named), NAMING, start + 1),
    )
