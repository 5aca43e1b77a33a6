"""Trains the offline baselines: on train, with the threshold that is best on val."""

from __future__ import annotations

import importlib
import platform
from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass
from functools import cached_property
from importlib.metadata import version
from pathlib import Path
from typing import get_args

import sdgen
from sdgen.dataset import Dataset
from sdgen.dataset.disk import file_sha256, sha256_hex
from sdgen.detectors import cnn, graph_classifier, image_classifier
from sdgen.detectors.examples import Examples, gather, hazards_of, train_split
from sdgen.detectors.model_file import (
    Kind,
    Model,
    TrainedOn,
    ValScores,
    array_bytes,
    write_model,
)
from sdgen.detectors.pictures import PictureExamples, gather_crops, need_pictures
from sdgen.detectors.prior import Prior, Rates
from sdgen.detectors.scored import Hazards, Scored, Scorer, best_threshold, mean_f1

KINDS: tuple[Kind, ...] = get_args(Kind)
#: What each kind needs beyond sdgen's own.
NEEDS: Mapping[Kind, tuple[str, ...]] = {
    "prior": (),
    "objects": ("sklearn",),
    "description": ("sklearn",),
    "graph": ("sklearn",),
    "image": ("sklearn",),
    "cnn": ("torch",),
}
PICTURES: tuple[Kind, ...] = ("image", "cnn")
_PACKAGES = {"sklearn": "scikit-learn", "torch": "torch"}
#: Says what goes on, how far it is, and of how much.
Told = Callable[[str, int, int], None]


@dataclass
class Lessons:
    """What is learned from in a data set, read once for all kinds that want it."""

    data: Dataset
    seed: int = 0
    told: Told | None = None

    @cached_property
    def hazards(self) -> Hazards:
        """The hazards of the data set and their labels."""
        names = tuple(self.data.info.hazards_enabled)
        return Hazards(names, tuple(self.data.catalog.hazard(name).label for name in names))

    @cached_property
    def examples(self) -> Examples:
        """Rows of scene graphs."""
        return gather(self.data, self.hazards.names, self.seed, self._told("reading graphs"))

    @cached_property
    def crops(self) -> PictureExamples:
        """Crops of pictures."""
        return gather_crops(
            self.data, self.hazards.names, self.seed, self._told("reading pictures")
        )

    def _told(self, what: str) -> Callable[[int, int], None] | None:
        told = self.told
        return None if told is None else lambda done, total: told(what, done, total)

    def fit(self, kind: Kind) -> tuple[Scorer, int, int]:
        """A scorer of a kind, how many examples it had, and of how many wrong things."""
        if kind in PICTURES:
            crops = self.crops
            wrong = int((crops.hazard >= 0).sum())
            scorer: Scorer = (
                cnn.fit_cnn(crops, self.hazards, self.seed, self._told("training cnn"))
                if kind == "cnn"
                else image_classifier.fit_images(crops, self.hazards, self.seed)
            )
            return scorer, len(crops.hazard), wrong
        rows = self.examples
        if kind == "prior":
            rates = Rates.of(rows.layout, rows.seen.sum(axis=0), rows.wrong.sum(axis=0))
            counts = rows.seen.sum(), rows.wrong[:, :, 0].sum()
            return Prior(rows.layout, self.hazards, rates), int(counts[0]), int(counts[1])
        made = graph_classifier.fit(rows, self.hazards, kind, self.seed)
        return made, len(rows.hazard), int((rows.hazard >= 0).sum())


def check_needs(data: Dataset, kinds: tuple[Kind, ...]) -> None:
    """Before any work: InputError for a data set without a train split, or without the pictures
    some kind wants, ModuleNotFoundError for a package that is missing."""
    train_split(data)
    if any(kind in PICTURES for kind in kinds):
        need_pictures(data)
    for kind in kinds:
        for name in NEEDS[kind]:
            importlib.import_module(name)


def train(lessons: Lessons, kind: Kind, folder: Path) -> Model:
    """Train one kind and write its folder, whole or not at all. The same data and seed make the
    same detector, with the same versions of packages on the same kind of machine."""
    data = lessons.data
    scorer, examples, wrong_examples = lessons.fit(kind)
    split = "val" if len(data.filter(split="val")) else "train"
    scenes = data.filter(split=split)
    told = lessons._told(f"choosing the threshold of {kind}")
    scored: dict[str, tuple[Scored, ...]] = {}
    wrong: dict[str, set[int]] = {}
    for done, item in enumerate(scenes, start=1):
        scored[item.id] = scorer(data, item)
        wrong[item.id] = set(hazards_of(item))
        if told is not None:
            told(done, len(scenes))
    threshold = best_threshold(scored, wrong)
    arrays = array_bytes(scorer.arrays())
    learned = train_split(data)
    model = Model(
        kind=kind,
        seed=lessons.seed,
        graph_view=data.graph_view,
        hazards=lessons.hazards.names,
        labels=lessons.hazards.labels,
        words=scorer.words(),
        threshold=threshold,
        examples=examples,
        examples_wrong=wrong_examples,
        settings=settings(kind),
        trained_on=TrainedOn(
            dataset=data.path.resolve().name,
            seed=data.info.seed,
            manifest_sha256=file_sha256(data.path / "manifest.jsonl"),
            catalogue_sha256=data.info.catalogue_sha256,
            train_scenes=len(learned),
            train_twins=sum(item.twin is not None for item in learned),
            train_anomalies=sum(entry.anomalies for entry in learned.shown),
            val_scenes=len(data.filter(split="val")),
        ),
        val=_scores("val" if split == "val" else "train", scored, wrong, threshold),
        versions=_versions(kind),
        arrays_sha256=sha256_hex(arrays),
    )
    view = "" if data.graph_view == "full" else f" --graph-view {data.graph_view}"
    seed = f" --seed {lessons.seed}" if lessons.seed else ""
    write_model(
        folder, model, arrays, f"sdgen train DATASET --kind {kind}{view}{seed} -o {folder.name}"
    )
    return model


def settings(kind: Kind) -> dict[str, dict[str, float]]:
    """The numbers a kind is trained with."""
    if kind == "prior":
        return {}
    if kind == "cnn":
        return {
            "net": {
                "epochs": cnn.EPOCHS,
                "lot": cnn.LOT,
                "rate": cnn.RATE,
                "decay": cnn.DECAY,
                "right_a_wrong": cnn.RIGHT_A_WRONG,
            }
        }
    if kind == "image":
        growth = {"finding": image_classifier.FINDING, "naming": image_classifier.NAMING}
    else:
        growth = {
            "finding": graph_classifier.FINDING[kind],
            "naming": graph_classifier.NAMING,
        }
    return {name: asdict(one) for name, one in growth.items()}


def _versions(kind: Kind) -> dict[str, str]:
    found = {"sdgen": sdgen.__version__, "machine": platform.machine(), "numpy": version("numpy")}
    return found | {_PACKAGES[name]: version(_PACKAGES[name]) for name in NEEDS[kind]}


def _scores(
    split: str,
    scored: Mapping[str, tuple[Scored, ...]],
    wrong: Mapping[str, set[int]],
    threshold: float,
) -> ValScores:
    precision, recall, alarms = [], [], []
    for scene, found in scored.items():
        said = {one.object_id for one in found if one.score >= threshold}
        hits = len(said & wrong[scene])
        alarms.append(len(said) - hits)
        if said:
            precision.append(hits / len(said))
        if wrong[scene]:
            recall.append(hits / len(wrong[scene]))
    return ValScores.model_validate(
        {
            "split": split,
            "f1": _rounded([mean_f1(scored, wrong, threshold)]),
            "precision": _rounded(precision),
            "recall": _rounded(recall),
            "false_alarms_per_scene": _rounded(alarms) or 0.0,
        }
    )


def _rounded(values: list[float] | list[int]) -> float | None:
    return round(sum(values) / len(values), 4) if values else None
