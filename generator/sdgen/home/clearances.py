"""What furniture keeps clear: the floor before a piece, the sight of doors and windows."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import shapely
from shapely.geometry import Polygon

from sdgen.freespace import opening_rectangle
from sdgen.home.anchors import PlacedAt
from sdgen.library.records import AssetInfo
from sdgen.scene import Opening

#: The floor kept clear before a piece is narrower than the piece by this on both sides, so that
#: neighbours in a row do not touch it.
FRONT_INSET_M = 0.02
#: Heights an opening must stay clear in start this much above its sill, and the floor before it
#: reaches this far to both sides of the middle of its wall: pieces against the wall stand in it.
SILL_SLACK_M = 0.02
WINDOW_SIGHT_M, DOOR_SIGHT_M = 0.32, 0.52
#: Of the widths of two pieces that face each other, the middle that sees the other: by eye.
SEEN_SHARE = 0.7


class Sight(NamedTuple):
    """Heights from which to which an opening must not be covered, and the floor at it."""

    low_m: float
    high_m: float
    before: Polygon

    def hidden_by(self, shape: Polygon, low_m: float, high_m: float) -> bool:
        """True when a piece of this outline and these heights stands before the opening."""
        return high_m > self.low_m and low_m < self.high_m and self.before.intersects(shape)


def sight_of(opening: Opening) -> Sight:
    """The sight of a door or a window, from both rooms."""
    sill = opening.center_m[2]
    depth = WINDOW_SIGHT_M if opening.kind == "window" else DOOR_SIGHT_M
    before = opening_rectangle(opening, depth)
    shapely.prepare(before)
    return Sight(sill + SILL_SLACK_M, sill + opening.height_m, before)


def front_of(asset: AssetInfo, pose: PlacedAt, front_m: float) -> Polygon | None:
    """The floor before a piece that stays clear."""
    if front_m <= 0:
        return None
    x, y, _, yaw = pose
    half, wide = asset.extents_m[0] / 2, asset.extents_m[1] / 2 - FRONT_INSET_M
    local = np.array([(half, -wide), (half + front_m, -wide), (half + front_m, wide), (half, wide)])
    turn = np.array([[np.cos(yaw), -np.sin(yaw)], [np.sin(yaw), np.cos(yaw)]])
    return shapely.polygons(local @ turn.T + (x, y))


def between(one: AssetInfo, at: PlacedAt, other: AssetInfo, other_at: PlacedAt) -> Polygon:
    """The floor between the fronts of two pieces that face each other: nothing stands between a
    sofa and its television."""
    ends = []
    for asset, (x, y, _, yaw) in ((one, at), (other, other_at)):
        half, wide = asset.extents_m[0] / 2 + FRONT_INSET_M, asset.extents_m[1] / 2 * SEEN_SHARE
        c, s = np.cos(yaw), np.sin(yaw)
        ends += [(x + c * half - s * w, y + s * half + c * w) for w in (wide, -wide)]
    return shapely.convex_hull(shapely.multipoints(ends))
