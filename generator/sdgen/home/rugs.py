"""Where rugs lie: on free floor, or under the pieces of a group and well beyond them.

Poses proposed, best first; nothing stands half on a rug but what is deep enough for a strip of it.
"""

from __future__ import annotations

import math

import numpy as np
import shapely
from shapely.geometry import Polygon
from shapely.geometry.base import BaseGeometry
from shapely.ops import unary_union

from sdgen.geometry import Array, yaw_of
from sdgen.home.anchors import PlacedAt, on_free_floor, placed_from
from sdgen.home.layout import corners_of
from sdgen.home.room_try import RoomTry
from sdgen.library.records import AssetInfo
from sdgen.vocabulary import FLAT_M

#: What lies flat keeps so far off walls and what stands: less looks pushed there.
FLAT_OFF_M = 0.08
#: Where that leaves no place it reaches so far under what stands, but leaves it so much beyond.
FLAT_UNDER_M, BEYOND_M = 0.4, 0.3
#: Two that are larger than this keep so far apart: patterns side by side clash.
LARGE_M2, APART_M = 1.0, 0.6
#: Under a piece a rug lies within so much of where the rule has it, metres, in such steps: large
#: ones would reach under shelves else. Aside it is missed more.
SHIFT_M, STEP_M, ASIDE_COSTS = 0.8, 0.2, 1.5
#: And so much of it lies beyond the piece, or it is hardly seen.
SEEN_SHARE = 0.6


def lying(asset: AssetInfo, target_id: int | None, gap_m: float, tried: RoomTry) -> list[PlacedAt]:
    """The poses of what lies flat: under a piece, ``gap_m`` before its middle, or on free floor."""
    if target_id is not None:
        return _under(asset, target_id, gap_m, tried)
    size = (asset.extents_m[0], asset.extents_m[1])
    lies = unary_union(_flat(tried, size[0] * size[1]))
    clear = on_free_floor(_bare_floor(tried, lies), size)
    return clear or on_free_floor(_bare_floor(tried, lies, tucked=True), size)


def _under(asset: AssetInfo, target_id: int, gap_m: float, tried: RoomTry) -> list[PlacedAt]:
    """Poses under a piece, nearest to where it is meant first, along its width before across; what
    can be shifted stands on the rug as a whole, what cannot keeps off."""
    target = tried.layout.items[target_id]
    steps = np.arange(-SHIFT_M, SHIFT_M + STEP_M / 2, STEP_M)
    ahead, aside = (axis.ravel() for axis in np.meshgrid(steps, steps))
    order = np.argsort(np.abs(ahead) + ASIDE_COSTS * np.abs(aside), kind="stable")
    poses = [
        (*placed_from(target, gap_m + x, y)[:2], 0.0, yaw_of(target.pose.quat_xyzw) + turn)
        for turn in (0.0, math.pi / 2)
        for x, y in zip(ahead[order].tolist(), aside[order].tolist(), strict=True)
    ]
    boxes = shapely.polygons([corners_of(asset, x, y, yaw) for x, y, _, yaw in poses])
    return [poses[k] for k in _lying_well(boxes, target_id, tried)]


def _lying_well(boxes: Array, target_id: int, tried: RoomTry) -> list[int]:
    """Numbers of the outlines (N) of a rug under a piece that lie well, as far as all else goes."""
    floor = tried.outline.buffer(-FLAT_OFF_M, join_style="mitre").difference(tried.swings)
    shapely.prepare(floor)
    good = np.flatnonzero(shapely.covers(floor, boxes))
    under = shapely.area(shapely.intersection(boxes[good], tried.prints[target_id]))
    good = good[under < (1 - SEEN_SHARE) * shapely.area(boxes[good])]
    for k, shape in tried.prints.items():
        if k == target_id:
            continue
        left = boxes[good]
        fair = ~shapely.intersects(left, _beyond_strip(shape, tried.layout.info(k)))
        if "MOVABLE" in tried.catalog.category(tried.layout.items[k].category).properties:
            fair |= shapely.covers(left, shape)
        good = good[fair]
    for flat in _flat(tried, float(shapely.area(boxes[0]))):
        good = good[~shapely.intersects(boxes[good], flat)]
    found: list[int] = good.tolist()
    return found


def _bare_floor(tried: RoomTry, lies: BaseGeometry, tucked: bool = False) -> BaseGeometry:
    """The floor on which nothing stands or ``lies`` and no door swings, a little less of it; with
    ``tucked``, also a strip under what is deep enough: beds, not shelves."""
    stands: list[BaseGeometry] = list(tried.prints.values())
    if tucked:
        stands = [_beyond_strip(shape, tried.layout.info(k)) for k, shape in tried.prints.items()]
    grown = unary_union([lies, *stands]).buffer(FLAT_OFF_M, join_style="mitre")
    within = tried.outline.buffer(-FLAT_OFF_M, join_style="mitre")
    return within.difference(unary_union([grown, tried.swings]))


def _flat(tried: RoomTry, area_m2: float) -> list[BaseGeometry]:
    """What lies flat on the floor, with as much around it as a thing of this area keeps off it."""
    lies = [
        shapely.polygons(corners_of(info, x, y, yaw_of(item.pose.quat_xyzw)))
        for item in (tried.layout.items[k] for ids in tried.placed.values() for k in ids)
        for x, y, z in [item.pose.position_m]
        for info in [tried.layout.info(item.id)]
        if info.extents_m[2] <= FLAT_M and z < FLAT_M
    ]
    return [
        shape.buffer(APART_M, join_style="mitre") if min(area_m2, shape.area) > LARGE_M2 else shape
        for shape in lies
    ]


def _beyond_strip(shape: Polygon, info: AssetInfo) -> BaseGeometry:
    """What of a piece's floor nothing flat reaches under."""
    strip_m = min(FLAT_UNDER_M, (min(info.extents_m[:2]) - BEYOND_M) / 2)
    return shape.buffer(-max(0.0, strip_m), join_style="mitre")
