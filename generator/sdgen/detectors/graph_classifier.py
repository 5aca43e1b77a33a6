"""Trees over what is said of a thing: by an object list, in words, or by the whole graph."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from sdgen.dataset import Dataset, SceneItem
from sdgen.detectors.boosted import Boosted, Growth, grow
from sdgen.detectors.examples import FOLDS, Examples
from sdgen.detectors.graph_rows import Floats, Rows, rows_of
from sdgen.detectors.layout import Layout
from sdgen.detectors.prior import Rates
from sdgen.detectors.scored import Array, Hazards, Scored
from sdgen.seeding import lane

#: What each kind sees of a thing beside what is usual of its category; ``bag``: how many of each
#: category are in the home.
SEES: Mapping[str, tuple[str, ...]] = {
    "objects": ("bag",),
    "description": ("kind", "state", "room"),
    "graph": (
        "kind",
        "state",
        "room",
        "property",
        "tag",
        "shape",
        "held",
        "on",
        "inside",
        "on_state",
        "inside_state",
        "from",
        "to",
        "around",
        "count",
    ),
}
#: Whether something is wrong: chosen on val, the more the more there is to see.
FINDING: Mapping[str, Growth] = {
    "objects": Growth(rounds=60, rate=0.05, leaves=4),
    "description": Growth(rounds=100, rate=0.15),
    "graph": Growth(rounds=200, rate=0.1),
}
#: And what.
NAMING = Growth(rounds=40, leaves=8, leaf_rows=5)
#: Rarer is as good as never.
_LEAST_RATE = 1e-4
#: A column that is other than its commonest value in fewer rows than this tells nothing.
_FEWEST = 5


@dataclass(frozen=True)
class GraphClassifier:
    """Rates of the category and the columns that vary, asked of two lots of trees: ``finding``
    whether something is wrong, ``naming`` which of the hazards ``named``."""

    layout: Layout
    hazards: Hazards
    rates: Rates
    columns: tuple[int, ...]
    bagged: tuple[int, ...]
    named: tuple[int, ...]
    finding: Boosted
    naming: Boosted

    def __call__(self, data: Dataset, item: SceneItem) -> tuple[Scored, ...]:
        rows = rows_of(item.shown_graph, self.layout)
        x = self._seen(rows)
        scores = self.finding.probabilities(x)[:, 1]
        shares = np.zeros((len(x), len(self.hazards.names)))
        shares[:, self.named] = self.naming.probabilities(x)
        return self.hazards.scored(rows.ids, scores, shares)

    def _seen(self, rows: Rows) -> Floats:
        bag = np.bincount(rows.category, minlength=len(self.layout.categories) + 1)
        bags = np.tile(bag[list(self.bagged)], (len(rows.ids), 1))
        return _matrix(self.rates(rows.category, rows.kind), rows.x[:, list(self.columns)], bags)

    def arrays(self) -> dict[str, Array]:
        return {
            **self.rates.arrays(),
            "columns": np.array(self.columns, dtype=np.int64),
            "bagged": np.array(self.bagged, dtype=np.int64),
            "named": np.array(self.named, dtype=np.int64),
            **self.finding.arrays("finding"),
            **self.naming.arrays("naming"),
        }

    def words(self) -> dict[str, tuple[str, ...]]:
        return self.layout.words()

    @classmethod
    def from_file(
        cls, arrays: Mapping[str, Array], words: Mapping[str, tuple[str, ...]], hazards: Hazards
    ) -> GraphClassifier:
        """The classifier that was kept. ValueError for what does not fit together."""
        layout = Layout.from_words(words)
        count = len(hazards.names)
        columns = numbers(arrays, "columns", len(layout.columns))
        bagged = numbers(arrays, "bagged", len(layout.categories))
        named = numbers(arrays, "named", count)
        width = 1 + count + len(columns) + len(bagged)
        return cls(
            layout=layout,
            hazards=hazards,
            rates=Rates.from_arrays(arrays, layout, count),
            columns=columns,
            bagged=bagged,
            named=named,
            finding=Boosted.from_arrays(arrays, "finding", width, 2),
            naming=Boosted.from_arrays(arrays, "naming", width, len(named)),
        )


def numbers(arrays: Mapping[str, Array], name: str, below: int) -> tuple[int, ...]:
    """A list of places out of a file, each once, below a bound. ValueError for another."""
    array = arrays.get(name)
    if array is None or array.dtype != np.int64 or array.ndim != 1:
        raise ValueError(f"no list of numbers {name!r}")
    if len(set(array.tolist())) != len(array) or any(not 0 <= k < below for k in array.tolist()):
        raise ValueError(f"{name}: a number beyond {below - 1}, or twice")
    return tuple(array.tolist())


def _matrix(rates: npt.NDArray[np.float64], x: Floats, bags: npt.NDArray[np.generic]) -> Floats:
    # Rates in half octaves: those of the folds differ a little from those of all, and trees that
    # may look closer tell the folds apart, and know no stove when they meet it with all rates.
    steps = np.round(2 * np.log2(np.maximum(rates, _LEAST_RATE)))
    return np.hstack([steps, x, bags]).astype(np.float32)


def fit(examples: Examples, hazards: Hazards, kind: str, seed: int) -> GraphClassifier:
    """Train one of the kinds ``SEES`` names. The object list cannot tell a scene from its twin, so
    it learns from scenes alone."""
    layout, sees = examples.layout, SEES[kind]
    rows = ~examples.twin if "bag" in sees else np.full(len(examples.twin), True)
    columns = [k for k in layout.columns_of(sees) if _varies(examples.x[rows, k])]
    bagged = [k for k in range(len(layout.categories)) if _varies(examples.bags[:, k])]
    bagged = bagged if "bag" in sees else []
    shown = _matrix(
        _rates_of_others(examples)[rows],
        examples.x[rows][:, columns],
        examples.bags[examples.bag[rows]][:, bagged],
    )
    hazard = examples.hazard[rows]
    wrong = hazard >= 0
    named = sorted(set(hazard[wrong].tolist()))
    place = {number: k for k, number in enumerate(named)}
    which = np.array([place[k] for k in hazard[wrong].tolist()], dtype=np.int64)
    start = int(lane(seed, 0, f"train:{kind}").integers(2**31))
    return GraphClassifier(
        layout=layout,
        hazards=hazards,
        rates=Rates.of(layout, examples.seen.sum(axis=0), examples.wrong.sum(axis=0)),
        columns=tuple(columns),
        bagged=tuple(bagged),
        named=tuple(named),
        finding=grow(shown, wrong.astype(np.int64), 2, FINDING[kind], start),
        naming=grow(shown[wrong], which, len(named), NAMING, start + 1),
    )


def _varies(column: Floats) -> bool:
    values, counts = np.unique(column, return_counts=True)
    return len(values) > 1 and len(column) - counts.max() >= min(_FEWEST, len(column) // 10)


def _rates_of_others(examples: Examples) -> npt.NDArray[np.float64]:
    """The rates of each row's category in the scenes of other folds: those of its own would tell
    the answer."""
    out = np.zeros((len(examples.x), examples.wrong.shape[2]))
    for fold in range(FOLDS):
        here = examples.fold == fold
        others = [k for k in range(FOLDS) if k != fold]
        rates = Rates.of(
            examples.layout, examples.seen[others].sum(axis=0), examples.wrong[others].sum(axis=0)
        )
        out[here] = rates(examples.category[here], examples.kind[here])
    return out
