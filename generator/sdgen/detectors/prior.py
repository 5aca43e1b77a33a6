"""How often things of a category are wrong: the least that anything learned has to beat.

A few examples are no rate: the rates of a category are drawn towards those of its superclass, and
these towards all, as if so many examples more had been seen there (an m-estimate, Cestnik 1990).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from sdgen.dataset import Dataset, SceneItem
from sdgen.detectors.layout import Layout
from sdgen.detectors.scored import Array, Floats, Hazards, Scored
from sdgen.detectors.told import things

Ints = npt.NDArray[np.int64]
#: Examples of its superclass that a category is given.
_DRAWN = 3.0


@dataclass(frozen=True)
class Rates:
    """Shares of things with an anomaly, and with each hazard: (n, 1 + hazards). The last row of
    ``by_kind`` is that of all."""

    by_category: Floats
    by_kind: Floats

    @classmethod
    def of(cls, layout: Layout, seen: Floats, wrong: Floats) -> Rates:
        """From counts by category: things ``seen`` (categories,), and ``wrong`` (categories,
        1 + hazards)."""
        kinds = np.array([layout.kind_number[name] for name in layout.superclasses], dtype=int)
        n_kinds = len(layout.kinds)
        of_kind, wrong_kind = np.zeros(n_kinds), np.zeros((n_kinds, wrong.shape[1]))
        np.add.at(of_kind, kinds, seen)
        np.add.at(wrong_kind, kinds, wrong)
        overall = wrong.sum(axis=0) / max(seen.sum(), 1.0)
        by_kind = (wrong_kind + _DRAWN * overall) / (of_kind + _DRAWN)[:, None]
        by_category = (wrong + _DRAWN * by_kind[kinds]) / (seen + _DRAWN)[:, None]
        return cls(by_category, np.vstack([by_kind, overall]))

    def __call__(self, category: Ints, kind: Ints) -> Floats:
        """The rates of rows by their numbers of category and superclass; those of an unknown
        category are its superclass's."""
        known = category < len(self.by_category)
        own = self.by_category[np.where(known, category, 0)]
        return np.where(known[:, None], own, self.by_kind[kind])

    def arrays(self) -> dict[str, Array]:
        """Its arrays by name."""
        return {"rates.by_category": self.by_category, "rates.by_kind": self.by_kind}

    @classmethod
    def from_arrays(cls, arrays: Mapping[str, Array], layout: Layout, hazards: int) -> Rates:
        """Rates out of a file. ValueError for what is missing or of another shape."""
        shapes = {"by_category": len(layout.categories), "by_kind": len(layout.kinds) + 1}
        found: dict[str, Any] = {}
        for name, rows in shapes.items():
            array = arrays.get(f"rates.{name}")
            if array is None or array.dtype != np.float64 or array.shape != (rows, 1 + hazards):
                raise ValueError(f"no array rates.{name} of {rows} by {1 + hazards} numbers")
            if not np.isfinite(array).all():
                raise ValueError(f"rates.{name}: a number that is none")
            found[name] = array
        return cls(**found)


@dataclass(frozen=True)
class Prior:
    """Scores a thing by its category alone."""

    layout: Layout
    hazards: Hazards
    rates: Rates

    def __call__(self, data: Dataset, item: SceneItem) -> tuple[Scored, ...]:
        nodes = things(item.shown_graph)
        none, other = len(self.layout.categories), len(self.layout.kinds)
        number, kind = self.layout.category_number, self.layout.kind_number
        rates = self.rates(
            np.array([number.get(n.class_name, none) for n in nodes], dtype=np.int64),
            np.array([kind.get(n.category, other) for n in nodes], dtype=np.int64),
        )
        return self.hazards.scored([n.id for n in nodes], rates[:, 0], rates[:, 1:])

    def arrays(self) -> dict[str, Array]:
        return self.rates.arrays()

    def words(self) -> dict[str, tuple[str, ...]]:
        return self.layout.words()

    @classmethod
    def from_file(
        cls, arrays: Mapping[str, Array], words: Mapping[str, tuple[str, ...]], hazards: Hazards
    ) -> Prior:
        """The prior that was kept. ValueError for what does not fit together."""
        layout = Layout.from_words(words)
        return cls(layout, hazards, Rates.from_arrays(arrays, layout, len(hazards.names)))
