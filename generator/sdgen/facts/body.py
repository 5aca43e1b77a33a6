"""World geometry of one object: its outline in the world, and gaps between outlines."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from functools import cached_property

import numpy as np
import shapely
from shapely.geometry.base import BaseGeometry

from sdgen.facts.hollows import Hollow, hollows_of
from sdgen.facts.surfaces import Surface, surfaces_of
from sdgen.geometry import Array, apply
from sdgen.library.records import AssetInfo
from sdgen.scene import ObjectInstance

#: A footprint of less area, square metres, has no share in anything: it is a line or a point.
LEAST_M2 = 1e-9


class Body:
    """World geometry of one object: ``corners`` (N, 3) of its outline, ``low`` and ``high`` of its
    box, and its ``center``: the middle of its extents, wherever its joints are."""

    def __init__(self, item: ObjectInstance, info: AssetInfo) -> None:
        self.item = item
        self.info = info
        self.world_from_object = item.pose.matrix()
        self.corners = apply(self.world_from_object, info.outermost_m)
        self.low = self.corners.min(axis=0)
        self.high = self.corners.max(axis=0)
        self.center = center_of(self.world_from_object, info)

    @cached_property
    def surfaces(self) -> tuple[Surface, ...]:
        """What things can stand on."""
        return tuple(surfaces_of(self.item, self.info, self.world_from_object))

    @cached_property
    def hollows(self) -> tuple[Hollow, ...]:
        """What things can be inside of."""
        return tuple(hollows_of(self.item, self.info, self.world_from_object))

    @cached_property
    def footprint(self) -> BaseGeometry:
        """The convex outline seen from above."""
        return footprints([self])[0]

    def covered_by(self, shape: BaseGeometry) -> float:
        """Share (0-1) of the footprint that lies in a shape."""
        # Nearly all of what is asked for lies wholly within or wholly beside.
        if shape.covers(self.footprint) and self.footprint.area >= LEAST_M2:
            return 1.0
        shared = shape.intersection(self.footprint).area
        return float(shared / max(self.footprint.area, LEAST_M2))


def with_footprints(bodies: Sequence[Body]) -> Sequence[Body]:
    """The same bodies, the footprints they do not have yet computed in one call."""
    missing = [body for body in bodies if "footprint" not in vars(body)]
    for body, shape in zip(missing, footprints(missing), strict=True):
        body.footprint = shape
    return bodies


def bodies_of(objects: Iterable[ObjectInstance], infos: Mapping[str, AssetInfo]) -> list[Body]:
    """The bodies of objects, their footprints not computed yet."""
    return [Body(item, infos[item.asset]) for item in objects]


def footprints(bodies: Sequence[Body]) -> list[BaseGeometry]:
    """The convex outlines of bodies seen from above."""
    if not bodies:
        return []
    body_of = np.repeat(np.arange(len(bodies)), [len(body.corners) for body in bodies])
    points = np.concatenate([body.corners for body in bodies])[:, :2]
    # A line has the hull of its points, and needs no geometry of its own for each of them.
    shapes: list[BaseGeometry] = shapely.convex_hull(
        shapely.linestrings(points, indices=body_of)
    ).tolist()
    return shapes


def center_of(world_from_object: Array, info: AssetInfo) -> Array:
    """The middle of an object's extents in the world (3,)."""
    rise = world_from_object[:3, 2] * (info.extents_m[2] / 2)
    return np.asarray(world_from_object[:3, 3] + rise, dtype=np.float64)


def gaps(low: Array, high: Array, lows: Array, highs: Array) -> Array:
    """Distances (N,) of one axis-aligned box to N others, 0 where they touch."""
    apart = np.maximum(lows - high, low - highs).clip(min=0)
    return np.asarray(np.linalg.norm(apart, axis=-1), dtype=np.float64)


def rows(values: Sequence[object], *shape: int) -> Array:
    """The values as an array (N, *shape), also when there are none."""
    return np.array(values, dtype=np.float64).reshape(len(values), *shape)
