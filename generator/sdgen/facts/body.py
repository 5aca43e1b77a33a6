"""World geometry of one object: its outline in the world, and gaps between outlines."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from functools import cached_property
from itertools import islice

import numpy as np
import shapely
from shapely.geometry.base import BaseGeometry

from sdgen.facts.hollows import Hollow, hollows_of
from sdgen.facts.surfaces import Surface, surfaces_of
from sdgen.geometry import Array, apply, lowest_highest
from sdgen.library.drawn import drawn, shut
from sdgen.library.records import AssetInfo
from sdgen.scene import ObjectInstance

#: A footprint of less area, square metres, has no share in anything: it is a line or a point.
LEAST_M2 = 1e-9


class Body:
    """World geometry of one object as it is drawn, its joints where they are: ``corners`` (N, 3) of
    its outline, ``low`` and ``high`` of its box, and its ``center``: the middle of its variant's
    box, wherever its joints are."""

    def __init__(self, item: ObjectInstance, info: AssetInfo) -> None:
        self.item = item
        self.info = info
        self.world_from_object = item.pose.matrix()
        self.outline = drawn(info, item.variant, item.joints)
        self.corners = apply(self.world_from_object, self.outline.points_m)
        self.low, self.high = lowest_highest(self.corners)
        self.center = center_of(self.world_from_object, info, item.variant)

    @cached_property
    def surfaces(self) -> tuple[Surface, ...]:
        """What things can stand on."""
        return tuple(surfaces_of(self.item, self.info, self.world_from_object))

    @cached_property
    def hollows(self) -> tuple[Hollow, ...]:
        """What things can be inside of."""
        return tuple(hollows_of(self.item, self.info, self.world_from_object))

    @cached_property
    def pieces(self) -> tuple[BaseGeometry, ...]:
        """The convex outlines, seen from above, of the pieces that lie apart: of what no joint has
        moved first, then of each part that stands open."""
        return tuple(_hulls([self]))

    @cached_property
    def footprint(self) -> BaseGeometry:
        """All that the object covers from above."""
        return _united(self.pieces)

    @cached_property
    def trunk(self) -> BaseGeometry:
        """What it covers but for the parts that stand open."""
        return _united(self.pieces[: self.outline.still] or self.pieces)

    @cached_property
    def top_m(self) -> float:
        """How high its highest level surface is: what people use of a bed, a sofa, a sink; of what
        has none, the top of its box."""
        return max((s.z_m for s in self.surfaces if s.level.value), default=float(self.high[2]))

    def covered_by(self, shape: BaseGeometry) -> float:
        """Share (0-1) of the footprint that lies in a shape."""
        # Nearly all of what is asked for lies wholly within or wholly beside.
        if shape.covers(self.footprint) and self.footprint.area >= LEAST_M2:
            return 1.0
        shared = shape.intersection(self.footprint).area
        return float(shared / max(self.footprint.area, LEAST_M2))


def with_footprints(bodies: Sequence[Body]) -> Sequence[Body]:
    """The same bodies, the outlines they do not have yet computed in one call."""
    missing = [body for body in bodies if "pieces" not in vars(body)]
    hulls = iter(_hulls(missing))
    for body in missing:
        body.pieces = tuple(islice(hulls, len(body.outline.starts)))
    return bodies


def bodies_of(objects: Iterable[ObjectInstance], infos: Mapping[str, AssetInfo]) -> list[Body]:
    """The bodies of objects, their footprints not computed yet."""
    return [Body(item, infos[item.asset]) for item in objects]


def _hulls(bodies: Sequence[Body]) -> list[BaseGeometry]:
    """The convex outlines of the pieces of bodies seen from above, one body after another."""
    if not bodies:
        return []
    starts = [body.outline.starts for body in bodies]
    ends = [(*body.outline.starts[1:], len(body.corners)) for body in bodies]
    sizes = np.concatenate(ends) - np.concatenate(starts)
    points = np.concatenate([body.corners for body in bodies])[:, :2]
    # A line has the hull of its points, and needs no geometry of its own for each of them.
    lines = shapely.linestrings(points, indices=np.repeat(np.arange(len(sizes)), sizes))
    shapes: list[BaseGeometry] = shapely.convex_hull(lines).tolist()
    return shapes


def _united(shapes: Sequence[BaseGeometry]) -> BaseGeometry:
    return shapes[0] if len(shapes) == 1 else shapely.union_all(shapes)


def center_of(world_from_object: Array, info: AssetInfo, variant: str) -> Array:
    """The middle of a variant's box in the world (3,)."""
    return world_from_object[:3, :3] @ shut(info, variant).middle_m + world_from_object[:3, 3]


def gaps(low: Array, high: Array, lows: Array, highs: Array) -> Array:
    """Distances (N,) of one axis-aligned box to N others, 0 where they touch."""
    apart = np.maximum(lows - high, low - highs).clip(min=0)
    return np.asarray(np.linalg.norm(apart, axis=-1), dtype=np.float64)


def rows(values: Sequence[object], *shape: int) -> Array:
    """The values as an array (N, *shape), also when there are none."""
    return np.array(values, dtype=np.float64).reshape(len(values), *shape)
