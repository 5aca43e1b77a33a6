"""What is known of a class of things before one is seen: how its kind is usually made.

Whoever recognises a fridge knows that it holds things behind a door, that things stand on tables,
and that no mug is half a metre tall. All of that is of classes, taken over the models of a data
set and never of the one model that a thing is.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np
import shapely

from sdgen.catalog.records import Catalog, Category
from sdgen.geometry import Array
from sdgen.library.drawn import shut
from sdgen.library.records import AssetInfo, Container

#: A hollow is a class's when so large a share of its models have one of that name.
USUAL = 0.3
#: The top of a model is flat when something can stand so high on it, in shares of its height.
FLAT_TOP = 0.97
#: What covers so much of its box from above is a rectangle, with rounded corners at most.
BOXY = 0.92
#: So many of the nearest classes in size may be mixed up with one.
ALIKE = 3


@dataclass(frozen=True)
class Hollow:
    """Where things of a class have a hollow, in shares of their box: ``low`` and ``high`` (3,), 0
    to 1; ``shut``: by a leaf, so that one only sees into it when that stands open."""

    name: str
    low: Array
    high: Array
    shut: bool


@dataclass(frozen=True)
class Kind:
    """What is known of a class: ``largest`` (3,) and ``usual`` (3,) extents of its models, metres;
    it ``carries`` what stands on it, on its very top if that is ``flat``; it is ``hung`` on a wall
    or a ceiling; from above it is a rectangle (``boxy``); and its hollows."""

    largest: Array
    usual: Array
    carries: bool = False
    flat: bool = False
    hung: bool = False
    boxy: bool = False
    hollows: tuple[Hollow, ...] = ()


class Kinds:
    """Knowledge of classes, from a catalogue and the models of a data set."""

    def __init__(self, catalog: Catalog, infos: Iterable[AssetInfo]) -> None:
        self.catalog = catalog
        self._models: dict[str, list[AssetInfo]] = {}
        for info in infos:
            self._models.setdefault(info.category, []).append(info)
        self._known: dict[str, Kind] = {}

    def __getitem__(self, name: str) -> Kind:
        if name not in self._known:
            self._known[name] = self._kind(name)
        return self._known[name]

    def _kind(self, name: str) -> Kind:
        models = self._models.get(name, [])
        if not models:
            largest = np.asarray(self.catalog.category(name).extents_max_m, dtype=np.float64)
            return Kind(largest, largest, hung=name in self._hung)
        sizes = np.array([model.extents_m for model in models], dtype=np.float64)
        tops = [max((s.z_m for s in m.supports), default=0.0) / m.extents_m[2] for m in models]
        return Kind(
            largest=sizes.max(axis=0),
            usual=np.median(sizes, axis=0),
            carries=any(model.supports for model in models),
            flat=sum(top > FLAT_TOP for top in tops) * 2 > len(tops),
            hung=name in self._hung,
            boxy=bool(np.median([_filled(model) for model in models]) > BOXY),
            hollows=_hollows(models),
        )

    @cached_property
    def _hung(self) -> frozenset[str]:
        """Classes that the catalogue hangs on walls and ceilings, and in windows."""
        fitted = {f.category for f in self.catalog.fittings if f.where != "before_door"}
        rules = (rule for room in self.catalog.room_types for rule in room.furniture)
        placed = {
            name
            for rule in rules
            if rule.z_m > 0 or rule.where in ("above", "over")
            for name in (rule.category, *rule.row, *rule.extra)
        }
        return frozenset(fitted | placed) - {""}

    def alike(self, name: str) -> tuple[str, ...]:
        """The classes that one is taken for: of its superclass, fixed or loose as it is, and next
        to it in size; none where nothing is like it."""
        mine = self._by_name[name]
        size = self[name].usual
        near = []
        for other in sorted(self._models.keys() & self._by_name.keys()):
            theirs = self._by_name[other]
            same = (theirs.superclass, theirs.kind) == (mine.superclass, mine.kind)
            if other != name and same:
                ratio = np.log(np.maximum(self[other].usual, 1e-3) / np.maximum(size, 1e-3))
                near.append((round(float(np.linalg.norm(ratio)), 6), other))
        return tuple(other for _, other in sorted(near)[:ALIKE])

    @cached_property
    def _by_name(self) -> Mapping[str, Category]:
        return {category.name: category for category in self.catalog.categories}


def _filled(model: AssetInfo) -> float:
    """The share of its box that a model covers, as seen from above."""
    points = shut(model, "default").points_m[:, :2]
    hull = shapely.convex_hull(shapely.multipoints(points))
    x0, y0, x1, y1 = hull.bounds
    return float(hull.area / max((x1 - x0) * (y1 - y0), 1e-9))


def _hollows(models: list[AssetInfo]) -> tuple[Hollow, ...]:
    """The hollows that things of a class usually have, where they usually are; those behind leaves
    as one, for which leaf shuts which of them differs from model to model."""
    found: dict[tuple[str, bool], list[Array]] = {}
    for model in models:
        boxes: dict[tuple[str, bool], list[Array]] = {}
        for container in model.containers:
            if model.part(container.part).joint is None:  # a drawer's goes where the drawer goes
                shut = container.closed_by is not None
                key = ("behind", True) if shut else (container.name, False)
                boxes.setdefault(key, []).append(_in_shares(model, container))
        for key, mine in boxes.items():
            low, high = np.min(mine, axis=0)[0], np.max(mine, axis=0)[1]
            found.setdefault(key, []).append(np.stack([low, high]))
    usual = []
    for (name, shut), ends in sorted(found.items()):
        if len(ends) >= USUAL * len(models):
            # Of what stands open all that is seen in it is in it, however deep its model reaches.
            lows, highs = np.swapaxes(ends, 0, 1)
            low = lows.min(axis=0) if shut else lows.mean(axis=0)
            high = highs.max(axis=0) if shut else highs.mean(axis=0)
            usual.append(Hollow(name, low, high, shut))
    return tuple(usual)


def _in_shares(model: AssetInfo, container: Container) -> Array:
    """The lowest and the highest corner (2, 3) of a hollow, in shares of its model's box."""
    size = np.maximum(np.asarray(model.extents_m), 1e-6)
    corner = np.array([-size[0] / 2, -size[1] / 2, 0.0])
    center = (np.asarray(container.center_m) - corner) / size
    half = np.asarray(container.size_m) / size / 2
    return np.stack([center - half, center + half])
