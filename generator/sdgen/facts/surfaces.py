"""Surfaces of one object that things stand on."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import shapely
from shapely.geometry.base import BaseGeometry

from sdgen.facts.thresholds import TILTED_M
from sdgen.geometry import Array, apply
from sdgen.library.records import AssetInfo
from sdgen.library.states import object_from_part
from sdgen.scene import ObjectInstance


class Surface(NamedTuple):
    """An upward surface in the world: whose, how high, its outline from above and its box, and
    the part it is of (None for a floor)."""

    owner: int
    category: str
    z_m: float
    outline: BaseGeometry
    bounds: tuple[float, float, float, float]
    part: str | None = None


def surfaces_of(
    item: ObjectInstance, info: AssetInfo, world_from_object: Array
) -> Iterator[Surface]:
    """The supports of an object that lie level."""
    drawn = info.variants[item.variant]
    for support in info.supports:
        if support.part not in drawn:
            continue
        local = object_from_part(info, support.part, item.joints)
        points = apply(world_from_object @ local, support.edge_m)
        low, high = points.min(axis=0), points.max(axis=0)
        if high[2] - low[2] <= TILTED_M:
            yield Surface(
                item.id,
                item.category,
                float(points[:, 2].mean()),
                shapely.polygons(points[:, :2]),
                (float(low[0]), float(low[1]), float(high[0]), float(high[1])),
                support.part,
            )
