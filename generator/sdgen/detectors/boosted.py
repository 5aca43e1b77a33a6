"""Boosted trees as plain arrays: scikit-learn grows them, numpy asks them.

A model is data from strangers. Arrays of numbers run nothing, are checked before use (no node
leads back or beyond), read the same with any version of scikit-learn, and without it.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.generic]
Floats = npt.NDArray[np.float64]

#: Nodes of all trees together, at most: what is larger is none of ours.
_MOST_NODES = 5_000_000
#: Trees at most: ours have some thousand.
_MOST_TREES = 50_000
#: How far scikit-learn's own answers may be from those of the arrays.
_AGREE = 1e-6
#: Rows of which this is checked.
_CHECKED = 500


@dataclass(frozen=True)
class Boosted:
    """Trees whose leaves are summed up.

    ``roots`` (rounds, outputs): where each tree begins; nodes have a ``feature`` (-1: a leaf), a
    ``threshold`` (at most that: ``left``, else ``right``) and a ``value``. ``start`` (outputs,) is
    what is added. One output is the log odds of the second of two classes, more are one a class;
    a single class needs none.
    """

    start: Floats
    roots: npt.NDArray[np.int64]
    feature: npt.NDArray[np.int64]
    threshold: Floats
    left: npt.NDArray[np.int64]
    right: npt.NDArray[np.int64]
    value: Floats

    def raw(self, x: npt.NDArray[np.floating]) -> Floats:
        """Sums of leaves for rows ``x`` (n, features): (n, outputs)."""
        rounds, outputs = self.roots.shape
        out = np.tile(self.start, (len(x), 1))
        if rounds == 0 or len(x) == 0:
            return out
        rows = np.arange(len(x))
        # All trees of a few rounds at once: fewer and larger steps for numpy.
        for first in range(0, rounds, 64):
            roots = self.roots[first : first + 64].reshape(-1)
            at = np.repeat(roots[:, None], len(x), axis=1)
            while True:
                feature = self.feature[at]
                inner = feature >= 0
                if not inner.any():
                    break
                seen = x[rows[None, :], np.maximum(feature, 0)]
                further = np.where(seen <= self.threshold[at], self.left[at], self.right[at])
                at = np.where(inner, further, at)
            out += self.value[at].reshape(-1, outputs, len(x)).sum(axis=0).T
        return out

    def probabilities(self, x: npt.NDArray[np.floating]) -> Floats:
        """Of each class, (n, classes)."""
        raw = self.raw(x)
        if raw.shape[1] == 0:
            return np.ones((len(x), 1))
        if raw.shape[1] == 1:
            odds = 1.0 / (1.0 + np.exp(-np.clip(raw, -500, 500)))
            return np.hstack([1.0 - odds, odds])
        raw = np.exp(raw - raw.max(axis=1, keepdims=True))
        return np.asarray(raw / raw.sum(axis=1, keepdims=True))

    def arrays(self, prefix: str) -> dict[str, Array]:
        """Its arrays by name, as ``from_arrays`` takes them."""
        return {f"{prefix}.{name}": getattr(self, name) for name in self.__dataclass_fields__}

    @classmethod
    def from_arrays(
        cls, arrays: Mapping[str, Array], prefix: str, features: int, classes: int
    ) -> Boosted:
        """Trees out of a file. ValueError for what is missing, or leads astray."""
        found: dict[str, Any] = {}
        for name in cls.__dataclass_fields__:
            array = arrays.get(f"{prefix}.{name}")
            if array is None:
                raise ValueError(f"no array {prefix}.{name}")
            dtype = np.float64 if name in ("start", "threshold", "value") else np.int64
            if array.dtype != dtype or array.ndim != (2 if name == "roots" else 1):
                raise ValueError(f"{prefix}.{name}: not what an array of that name is")
            found[name] = array
        made = cls(**found)
        made._check(prefix, features, classes)
        return made

    def _check(self, prefix: str, features: int, classes: int) -> None:
        nodes = len(self.feature)
        outputs = max(0, classes - 1) if classes <= 2 else classes
        large = nodes > _MOST_NODES or self.roots.size > _MOST_TREES
        if len(self.start) != outputs or self.roots.shape[1] != outputs or large:
            raise ValueError(f"{prefix}: trees of another size than the model says")
        if any(len(a) != nodes for a in (self.threshold, self.left, self.right, self.value)):
            raise ValueError(f"{prefix}: nodes that lack something")
        if self.roots.size and not (self.roots.min() >= 0 and self.roots.max() < nodes):
            raise ValueError(f"{prefix}: a tree that begins nowhere")
        inner = self.feature >= 0
        number = np.arange(nodes)[inner]
        for child in (self.left[inner], self.right[inner]):
            # Always further on: no walk goes round in circles.
            if child.size and not ((child > number).all() and child.max() < nodes):
                raise ValueError(f"{prefix}: a node that leads astray")
        if nodes and self.feature.max() >= features:
            raise ValueError(f"{prefix}: a node that asks for a column that is not there")
        if not all(np.isfinite(a).all() for a in (self.start, self.threshold, self.value)):
            raise ValueError(f"{prefix}: a number that is none")


@dataclass(frozen=True)
class Growth:
    """How trees are grown; a leaf has at least ``leaf_rows``."""

    rounds: int
    rate: float = 0.08
    leaves: int = 31
    leaf_rows: int = 20
    l2: float = 1.0
    share: float = 0.5


def grow(
    x: npt.NDArray[np.floating],
    y: npt.NDArray[np.int64],
    classes: int,
    growth: Growth,
    seed: int,
    weights: npt.NDArray[np.floating] | None = None,
) -> Boosted:
    """Trees that tell the classes 0 to ``classes - 1``, of which each is in ``y``.

    They grow in one thread: threads that wait for each other on a busy machine took ten times as
    long. ModuleNotFoundError without scikit-learn.
    """
    import sklearn
    from sklearn.ensemble import HistGradientBoostingClassifier
    from threadpoolctl import threadpool_limits

    if classes < 2:
        none = np.zeros(0, dtype=np.int64)
        roots = np.zeros((0, 0), dtype=np.int64)
        return Boosted(np.zeros(0), roots, none, np.zeros(0), none, none, np.zeros(0))
    model = HistGradientBoostingClassifier(
        max_iter=growth.rounds,
        learning_rate=growth.rate,
        max_leaf_nodes=growth.leaves,
        # Of few examples, leaves of a few.
        min_samples_leaf=max(1, min(growth.leaf_rows, len(y) // 50)),
        l2_regularization=growth.l2,
        max_features=growth.share,
        early_stopping=False,
        random_state=seed,
    )
    with threadpool_limits(limits=1):
        model.fit(x, y, sample_weight=weights)
    made = _as_arrays(model)
    few = x[:: max(1, len(x) // _CHECKED)]
    theirs = np.asarray(model.predict_proba(few))
    if np.abs(theirs - made.probabilities(few)).max() > _AGREE:
        raise ImportError(f"scikit-learn {sklearn.__version__} grows trees that sdgen cannot read")
    return made


def _as_arrays(model: object) -> Boosted:
    """What scikit-learn keeps of its trees: names with an underscore, so answers are compared."""
    rounds = model._predictors  # type: ignore[attr-defined]
    start = np.asarray(model._baseline_prediction, dtype=np.float64)  # type: ignore[attr-defined]
    roots: list[list[int]] = []
    parts, size = [], 0
    for trees in rounds:
        roots.append([])
        for tree in trees:
            roots[-1].append(size)
            parts.append((size, tree.nodes))
            size += len(tree.nodes)
    nodes = np.concatenate([part for _, part in parts])
    offset = np.concatenate([np.full(len(part), first) for first, part in parts])
    leaf = nodes["is_leaf"].astype(bool)

    def child(name: str) -> npt.NDArray[np.int64]:
        return np.where(leaf, 0, nodes[name].astype(np.int64) + offset)

    return Boosted(
        start=start.reshape(-1),
        roots=np.array(roots, dtype=np.int64),
        feature=np.where(leaf, -1, nodes["feature_idx"].astype(np.int64)),
        threshold=np.where(leaf, 0.0, nodes["num_threshold"]).astype(np.float64),
        left=child("left"),
        right=child("right"),
        value=nodes["value"].astype(np.float64),
    )
