"""Trained detectors: opened from their folder, they report what scores high enough."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path

from sdgen.dataset import Dataset, SceneItem
from sdgen.dataset.graph_views import GraphView
from sdgen.dataset.records import Report
from sdgen.detectors.cnn import Cnn
from sdgen.detectors.graph_classifier import GraphClassifier
from sdgen.detectors.image_classifier import ImageClassifier
from sdgen.detectors.model_file import ARRAYS, Kind, read_model
from sdgen.detectors.prior import Prior
from sdgen.detectors.scored import Array, Hazards, Scorer
from sdgen.detectors.told import Told
from sdgen.errors import InputError, UsageError

#: What makes a scorer of a kind out of its arrays and words; ValueError where they do not fit.
FromFile = Callable[[Mapping[str, Array], Mapping[str, tuple[str, ...]], Hazards], Scorer]
LOADERS: Mapping[Kind, FromFile] = {
    "prior": Prior.from_file,
    "objects": GraphClassifier.from_file,
    "description": GraphClassifier.from_file,
    "graph": GraphClassifier.from_file,
    "image": ImageClassifier.from_file,
    "cnn": Cnn.from_file,
}


@dataclass(frozen=True)
class Trained:
    """A detector: a scorer, the least score that is reported, and what it learned from."""

    scorer: Scorer = field(repr=False)
    threshold: float
    kind: Kind
    graph_view: GraphView

    def __call__(self, data: Dataset, item: SceneItem) -> tuple[Report, ...]:
        """Reports of a scene, sorted by id; the score says how sure it is."""
        told = Told(data.catalog)
        found = sorted(self.scorer(data, item), key=lambda one: one.object_id)
        return tuple(
            Report(
                object_id=one.object_id,
                label=one.label,
                notify=told(one.label, item.household, one.hazard),
                score=round(one.score, 6),
            )
            for one in found
            if one.score >= self.threshold
        )


def load_trained(folder: Path, threshold: float | None = None) -> Trained:
    """The detector that ``sdgen train`` wrote; with another ``threshold`` than its own, where one
    is given (0: every thing is reported, with its score).

    InputError for a folder that is none, that changed, or whose numbers do not fit together;
    UsageError for a threshold beyond 0 to 1.
    """
    if threshold is not None and not 0.0 <= threshold <= 1.0:
        raise UsageError(f"threshold {threshold}: 0 to 1 expected")
    model, arrays = read_model(folder)
    hazards = Hazards(model.hazards, model.labels)
    try:
        scorer = LOADERS[model.kind](arrays, model.words, hazards)
    except ValueError as error:
        raise InputError(
            [f"{folder / ARRAYS}: no detector of kind {model.kind} ({error})"]
        ) from None
    least = model.threshold if threshold is None else threshold
    return Trained(scorer, least, model.kind, model.graph_view)
