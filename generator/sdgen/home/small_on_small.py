"""Small things on and in small things: a cup on a saucer, fruit in a bowl, a book on a book.

Furniture is large beside what stands on it; here a thing may be as large as what carries it, and
what counts is that it stands: its base on the surface, or all of it within the hollow's box.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from weakref import WeakKeyDictionary

import numpy as np
import shapely
from shapely.geometry import Polygon
from shapely.geometry.base import BaseGeometry

from sdgen.freespace import Pieces
from sdgen.geometry import Array, Vec2, apply, yaw_of
from sdgen.home.headings import random_yaw
from sdgen.home.layout import DROP_M, Layout, Vec3Yaw, space_at
from sdgen.library.drawn import Drawn, drawn
from sdgen.library.records import AssetInfo
from sdgen.scene import ObjectInstance
from sdgen.seeding import Rng

#: Spots tried for one thing anywhere on a surface, and then square on its middle, as in a stack.
ANYWHERE, SQUARE = 4, 3
#: How neatly people stack: 1 cm and 5 degrees or so, by eye.
STACKED_M, STACKED_RAD = 0.01, 0.08
#: What is so near its lowest point, metres, is the base that a thing stands on.
BASE_M = 0.004
#: Of a thing's base, and of its shape from above, so much lies over the surface: the one so that it
#: stands, the other clearly more than ON asks for.
BASE_SHARE, OVER_SHARE = 0.85, 0.75
#: What rises so little beyond a surface, metres, is no rim; and by so much what lies within a rim
#: may miss its edge.
RIM_M, RIM_PLAY_M = 0.004, 0.002
#: Small things under the topmost of a stack. Higher ones creep in the simulation by a millimetre a
#: second, which is no rest: with two below 3 % of 250 did, with three 9 %, unbounded 16 %.
STACKED_MOST = 2
#: Left between things on or in one: they are small, and touch as they come to rest.
GAP_M = 0.004
#: The middle of a thing lies at least so deep in a hollow, metres: past the margin of INSIDE.
DEEP_M = 0.01


def spot_on_small(
    layout: Layout, asset: AssetInfo, target_id: int, relation: str, rng: Rng
) -> Vec3Yaw | None:
    """A spot on or in a small thing for a new one of this asset, at rest; None when none fits."""
    if relation == "INSIDE":
        return _in_hollow(layout, asset, layout.items[target_id], rng)
    return _spot_atop(layout, asset, (target_id,), ANYWHERE, rng)


def spot_square_on(
    layout: Layout, asset: AssetInfo, target_id: int, within_id: int, rng: Rng
) -> Vec3Yaw | None:
    """A spot on the middle of a small thing for a new one of this asset, as in a pile, in the
    furniture where it is."""
    return _spot_atop(layout, asset, (target_id, within_id), 0, rng)


def _spot_atop(
    layout: Layout, asset: AssetInfo, among: tuple[int, ...], anywhere: int, rng: Rng
) -> Vec3Yaw | None:
    """A spot on a small thing, the first of those that the new one may come to be ``among``: the
    first ``anywhere`` tries all over it, then on its middle."""
    target_id = among[0]
    target = layout.items[target_id]
    open_ones = [s for s in layout.surfaces_of(target_id) if s.support.container is None]
    if not open_ones or _stacked(layout, target_id) > STACKED_MOST:
        return None
    surface = open_ones[int(rng.integers(len(open_ones)))]
    edge = surface.edge
    shape = _Shape.of(asset)
    rim_m = target.pose.position_m[2] + layout.info(target_id).extents_m[2] - surface.z_m
    front, middle = yaw_of(target.pose.quat_xyzw), surface.shape.centroid
    for trial in range(anywhere + SQUARE):
        point: Vec2 | None
        if trial < anywhere:
            yaw, point = random_yaw(rng, front), surface.random_point(rng)
        else:
            yaw = front + float(rng.normal(0.0, STACKED_RAD))
            dx, dy = rng.normal(0.0, STACKED_M, 2).tolist()
            point = middle.x + dx, middle.y + dy
        if point is None or not shape.stands(edge, point, yaw, rim_m):
            continue
        spot = (*point, surface.z_m), yaw
        entered = layout.entered([space_at(asset.extents_m, *spot, GAP_M, DROP_M)])
        if all(owner in among for owner in entered):
            return spot
    return None


def _stacked(layout: Layout, thing_id: int) -> int:
    """How many small things a stack has, down from one of them."""
    many = 0
    while thing_id in layout.items and not layout.items[thing_id].fixed:
        many += 1
        intent = layout.intents.get(thing_id)
        if intent is None:
            break
        thing_id = intent.target_id
    return many


@dataclass(frozen=True, eq=False)
class _Shape:
    """A thing at rest from above, in its own frame: corners (N, 2) of it and of its base, and the
    points (N, 3) that it is drawn by."""

    whole: Array
    base: Array
    points: Array

    @classmethod
    def of(cls, asset: AssetInfo) -> _Shape:
        """The shape of a model, found once."""
        outline = drawn(asset, "default", {})
        if outline not in _shapes:
            points = outline.points_m
            low = points[:, 2] < points[:, 2].min() + BASE_M
            _shapes[outline] = cls(_corners(points), _corners(points[low]), points)
        return _shapes[outline]

    def stands(self, edge: Polygon, point: Vec2, yaw: float, rim_m: float = 0.0) -> bool:
        """Whether it stands on a surface there: on its base, not far over the edge, and not in a
        rim that rises so high around it."""
        base = _placed(self.base, point, yaw)
        if not edge.covers(base.centroid):
            return False
        if base.difference(edge).area > (1 - BASE_SHARE) * base.area:
            return False
        if rim_m > RIM_M:
            low = self.points[:, 2] < self.points[:, 2].min() + rim_m
            within = _placed(_corners(self.points[low]), point, yaw)
            if not edge.buffer(RIM_PLAY_M).covers(within):
                return False
        whole = _placed(self.whole, point, yaw)
        return bool(whole.difference(edge).area <= (1 - OVER_SHARE) * whole.area)


#: By outline, of which each model at rest has one.
_shapes: WeakKeyDictionary[Drawn, _Shape] = WeakKeyDictionary()


def _in_hollow(
    layout: Layout, asset: AssetInfo, target: ObjectInstance, rng: Rng
) -> Vec3Yaw | None:
    """A spot on the floor of a hollow, within its box or what carries things at its bottom: no
    mesh of the target is there, and its walls stand upright or lean outwards."""
    info = layout.info(target.id)
    if not info.containers:
        return None
    hollow = info.containers[int(rng.integers(len(info.containers)))]
    (x, y, z), (wide, deep, high) = hollow.center_m, hollow.size_m
    if asset.extents_m[2] / 2 > high - DEEP_M:
        return None
    box = shapely.box(x - wide / 2, y - deep / 2, x + wide / 2, y + deep / 2)
    bottoms = [s.edge_m[:, :2] for s in info.supports if s.container == hollow.name]
    floor = shapely.union_all([box, *map(shapely.polygons, bottoms)]) if bottoms else box
    whole = _Shape.of(asset).whole
    outline = floor.convex_hull
    shapely.prepare(outline)
    pieces, front = Pieces(floor), yaw_of(target.pose.quat_xyzw)
    for trial in range(ANYWHERE + SQUARE):
        turn = random_yaw(rng)
        point = pieces.random_point(rng) if trial < ANYWHERE else (x, y)
        if point is None or not outline.covers(_placed(whole, point, turn)):
            continue
        u, v, w = apply(target.pose.matrix(), [(*point, z - high / 2)])[0].tolist()
        spot = (u, v, w), turn + front
        if layout.fits([space_at(asset.extents_m, *spot, GAP_M, DROP_M)], ignore=target.id):
            return spot
    return None


def _corners(points: Array) -> Array:
    """Corners (N, 2) of the hull of points (M, 3) from above; all of two or fewer, or in a line."""
    hull = shapely.MultiPoint(points[:, :2]).convex_hull
    return np.array(hull.exterior.coords)[:-1] if isinstance(hull, Polygon) else points[:, :2]


def _placed(corners: Array, point: Vec2, yaw: float) -> BaseGeometry:
    """Corners (N, 2) as a polygon, turned about the origin and moved to a point."""
    cos, sin = math.cos(yaw), math.sin(yaw)
    turned = corners @ np.array([[cos, sin], [-sin, cos]]) + point
    return shapely.polygons(turned) if len(turned) > 2 else shapely.MultiPoint(turned)
