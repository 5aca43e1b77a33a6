"""Surfaces of one object that things stand on."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import shapely
from shapely.geometry.base import BaseGeometry

from sdgen.facts.thresholds import TILTED_M
from sdgen.geometry import Array, apply
from sdgen.kleene import NO, YES, Kleene
from sdgen.library.records import AssetInfo
from sdgen.library.states import drawn_supports
from sdgen.scene import ObjectInstance


class Surface(NamedTuple):
    """An upward surface in the world: whose, how high, its outline from above and its box, and
    the part it is of (None for a floor); ``level`` says whether it lies so level that it carries.
    """

    owner: int
    category: str
    z_m: float
    outline: BaseGeometry
    bounds: tuple[float, float, float, float]
    part: str | None = None
    level: Kleene = YES


def surfaces_of(
    item: ObjectInstance, info: AssetInfo, world_from_object: Array
) -> Iterator[Surface]:
    """The supports of an object that lie level, or nearly."""
    for support, moved in drawn_supports(info, item.variant, item.joints):
        points = apply(world_from_object @ moved, support.edge_m)
        low, high = points.min(axis=0), points.max(axis=0)
        level = TILTED_M.at_most(float(high[2] - low[2]))
        if level != NO:
            yield Surface(
                item.id,
                item.category,
                float(points[:, 2].mean()),
                shapely.polygons(points[:, :2]),
                (float(low[0]), float(low[1]), float(high[0]), float(high[1])),
                support.part,
                level,
            )
