"""What there is to learn from: the things of the training scenes and of their twins, as rows."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from sdgen.dataset import Dataset, SceneItem
from sdgen.detectors.graph_rows import Floats, rows_of
from sdgen.detectors.layout import Layout
from sdgen.errors import InputError
from sdgen.seeding import lane

Ints = npt.NDArray[np.int64]
Progress = Callable[[int, int], None]

#: Of things of categories that nothing was ever wrong with, so many are kept: they are easy.
_KEPT_EASY = 0.1
#: Scenes are dealt to so many folds: a scene's rates of categories come from the other folds.
FOLDS = 5


@dataclass(frozen=True)
class Examples:
    """Rows of training scenes and twins.

    ``hazard`` is the number of the first hazard of a thing, -1 where it has none; ``fold`` that of
    its scene, ``bag`` the row of ``bags`` (scenes, categories) that counts what its home holds.
    ``seen`` (folds, categories) and ``wrong`` (folds, categories, 1 + hazards) count all things of
    the scenes, without twins.
    """

    layout: Layout
    x: Floats
    category: Ints
    kind: Ints
    hazard: Ints
    fold: Ints
    bag: Ints
    bags: Floats
    twin: npt.NDArray[np.bool_]
    seen: npt.NDArray[np.float64]
    wrong: npt.NDArray[np.float64]


def train_split(data: Dataset) -> Dataset:
    """The scenes that are learned from. InputError where there are none."""
    kept = data.filter(split="train")
    if not len(kept):
        raise InputError(
            [f"{data.path}: no scene of the split 'train' to learn from; build more (--n)"]
        )
    return kept


def hazards_of(item: SceneItem) -> dict[int, list[str]]:
    """The hazards of each thing that has some, in the order of the file."""
    found: dict[int, list[str]] = {}
    for anomaly in item.anomalies.anomalies:
        found.setdefault(anomaly.object_id, []).append(anomaly.hazard)
    return found


def gather(
    data: Dataset, hazards: tuple[str, ...], seed: int, on_scene: Progress | None = None
) -> Examples:
    """Rows of the train split. InputError where there is none, or nothing is wrong in it."""
    kept = train_split(data)
    layout = Layout.of(data)
    suspects = {a.category for item in kept for a in item.anomalies.anomalies}
    if not suspects:
        raise InputError([f"{data.path}: no scene of the split 'train' has an anomaly"])
    doubtful = np.array([*(name in suspects for name in layout.categories), False])
    number = {name: k for k, name in enumerate(hazards)}
    shape = (FOLDS, len(layout.categories) + 1)
    seen, wrong = np.zeros(shape), np.zeros((*shape, 1 + len(hazards)))
    parts: list[tuple[Floats, Ints, Ints, Ints, int, int, bool]] = []
    bags: list[Floats] = []
    for done, item, is_twin in _with_twins(kept):
        rows = rows_of(item.shown_graph, layout)
        found = hazards_of(item)
        fold = item.entry.index % FOLDS
        first = [number[found[k][0]] if k in found else -1 for k in rows.ids]
        hazard = np.array(first, dtype=np.int64)
        if not is_twin:
            np.add.at(seen[fold], rows.category, 1.0)
            for k, row in zip(rows.ids, rows.category, strict=True):
                for column in {0, *(1 + number[h] for h in found.get(k, ()))} if k in found else ():
                    wrong[fold, row, column] += 1.0
        near = {one.object_id for one in item.anomalies.lookalikes}
        rng = lane(seed, item.entry.index, f"train:rows:{item.id}")
        chosen = doubtful[rows.category] | (hazard >= 0) | (rng.random(len(first)) < _KEPT_EASY)
        chosen |= np.array([k in near for k in rows.ids], dtype=bool)
        bag = np.bincount(rows.category, minlength=shape[1]).astype(np.float32)
        parts.append(
            (
                rows.x[chosen],
                rows.category[chosen],
                rows.kind[chosen],
                hazard[chosen],
                fold,
                len(bags),
                is_twin,
            )
        )
        bags.append(bag[:-1])
        if on_scene is not None:
            on_scene(done, len(kept))
    sizes = [len(part[0]) for part in parts]
    return Examples(
        layout=layout,
        x=np.concatenate([part[0] for part in parts]),
        category=np.concatenate([part[1] for part in parts]),
        kind=np.concatenate([part[2] for part in parts]),
        hazard=np.concatenate([part[3] for part in parts]),
        fold=np.repeat([part[4] for part in parts], sizes),
        bag=np.repeat([part[5] for part in parts], sizes),
        bags=np.array(bags),
        twin=np.repeat([part[6] for part in parts], sizes),
        seen=seen[:, :-1],
        wrong=wrong[:, :-1],
    )


def _with_twins(kept: Dataset) -> Iterator[tuple[int, SceneItem, bool]]:
    """How many scenes there were, a scene or twin, and whether it is a twin. One after another:
    what an item has read is gone with it."""
    for done, item in enumerate(kept, start=1):
        yield done, item, False
        twin = item.twin
        if twin is not None:
            yield done, twin, True
