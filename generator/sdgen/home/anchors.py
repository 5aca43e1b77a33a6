"""Where a piece of furniture may stand in a room: poses proposed, best first; nothing is checked.

A piece faces +X; its origin is the middle of its bottom. Poses are (x, y, z, yaw).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
import shapely
from shapely.geometry import Polygon
from shapely.geometry.base import BaseGeometry

from sdgen.freespace import polygons
from sdgen.geometry import Vec2, yaw_of
from sdgen.library.records import AssetInfo
from sdgen.library.sweep import Reach
from sdgen.scene import ObjectInstance
from sdgen.seeding import Rng

#: Between a back and the wall; a hung piece touches it.
BACK_GAP_M = 0.03
HUNG_GAP_M = 0.005
#: Between neighbours and from corners: clear of touching after rounding, too narrow to look empty.
SIDE_GAP_M = 0.02
#: Chosen by eye: furniture mostly stands at the ends of walls, where it leaves the middle free.
SNAP_CHANCE = 0.65
#: Bounds the work: three more spots a wall, beside its two ends.
DRAWS_A_WALL = 3
#: By eye: the middle of a room is sought this far from its walls, and missed by so much, since
#: nobody measures; a quarter of the pieces stand across the room instead of along it.
MIDDLE_OFF_WALLS_M = 0.4
MIDDLE_SPREAD_M = 0.15
ACROSS_CHANCE = 0.25
#: Bound the work: free parts of the floor looked at, largest first, and poses in each.
MIDDLE_PARTS, MIDDLE_DRAWS = 2, 6
#: What lies flat is tried at so many spots along either side of the free floor: bounds the work.
FLAT_SPOTS = 9
#: Who sits this near the middle of an edge of a table sits at it.
ACROSS_M = 0.4
#: A seat reaches so far under the table it stands at: pushed in as far as its legs let it.
TUCKED_M = (0.24, 0.16, 0.08)
#: One that stands off its table, as armchairs do, gives way by so much.
FURTHER_M = (0.0, 0.15, 0.3, 0.45)
#: A piece before another stands in its middle or, where that is taken, so far beside it: by eye.
BEFORE_BESIDE_M = 0.1
#: Half a table's side that has room for two chairs (0.45 m each) side by side, and where they then
#: stand, in shares of that half.
TWO_SEATS_M, SEAT_AT = 0.55, 0.5
#: Opposite: within 26 degrees of right across (a cosine); between a walk past and the end of a
#: living room, metres; and by eye so far beside right across, nearest first, at most this much
#: where the wall begins or ends there.
OPPOSITE_COS = 0.9
OPPOSITE_M = (1.6, 6.0)
OPPOSITE_MOST_M = 0.8
OPPOSITE_BESIDE_M = (0.0, 0.15, -0.15, 0.3, -0.3, 0.45, -0.45, 0.6, -0.6)
#: On top: what is shallower than this share of the piece stands at its back, so far from its edges;
#: and by eye four spots within this share of the rest of its width.
SHALLOW_SHARE = 0.7
TOP_EDGE_M = 0.04
TOP_SPOTS, TOP_SPREAD = 4, 0.8

PlacedAt = tuple[float, float, float, float]
#: Of what does not open beyond its own box.
NO_REACH = Reach()


@dataclass(frozen=True)
class Side:
    """An inner wall of a room: from ``start`` along ``along`` for ``length_m``; ``inward`` points
    into the room (unit vectors)."""

    start: Vec2
    along: Vec2
    inward: Vec2
    length_m: float

    @property
    def yaw(self) -> float:
        """Heading of a piece with its back to this wall."""
        return math.atan2(self.inward[1], self.inward[0])

    def at(self, t: float, off_m: float) -> Vec2:
        """The point ``t`` along the wall and ``off_m`` away from it."""
        return (
            self.start[0] + self.along[0] * t + self.inward[0] * off_m,
            self.start[1] + self.along[1] * t + self.inward[1] * off_m,
        )

    def measure(self, point: Vec2) -> tuple[float, float]:
        """(along, away) coordinates of a point."""
        dx, dy = point[0] - self.start[0], point[1] - self.start[1]
        return (
            dx * self.along[0] + dy * self.along[1],
            dx * self.inward[0] + dy * self.inward[1],
        )


def sides_of(polygon_m: Sequence[Vec2]) -> tuple[Side, ...]:
    """Inner walls of a counter-clockwise room outline."""
    out = []
    for (x0, y0), (x1, y1) in pairwise([*polygon_m, polygon_m[0]]):
        length = math.hypot(x1 - x0, y1 - y0)
        along = ((x1 - x0) / length, (y1 - y0) / length)
        out.append(Side((x0, y0), along, (-along[1], along[0]), length))
    return tuple(out)


def back_gap(reach: Reach) -> float:
    """Between a back and the wall: what opens beyond the back needs more."""
    return max(BACK_GAP_M, reach.back_m)


def end_gaps(reach: Reach) -> Vec2:
    """Between a piece at a wall and the walls at its left and at its right."""
    return max(SIDE_GAP_M, reach.left_m), max(SIDE_GAP_M, reach.right_m)


def against_walls(
    sides: Sequence[Side],
    size: Vec2,
    z: float,
    rng: Rng,
    snap: float = SNAP_CHANCE,
    reach: Reach = NO_REACH,
    centred: bool = False,
) -> list[PlacedAt]:
    """Poses with the back to a wall: at its ends mostly, and anywhere; ``centred``: in its middle
    before that. ``size`` (depth, width); ``reach``: how far beyond it leaves and lids go."""
    if not sides:
        return []
    gap = HUNG_GAP_M if z > 0 else back_gap(reach)
    depth, width = size
    # Along the wall its left comes first: it looks to the left of the wall's own direction.
    left, right = end_gaps(reach)
    out: list[PlacedAt] = []
    lengths = np.array([side.length_m for side in sides])
    order = rng.choice(len(sides), len(sides), replace=False, p=lengths / lengths.sum())
    for k in order.tolist():
        side = sides[k]
        low, high = width / 2 + left, side.length_m - width / 2 - right
        ends = [low, high] if rng.random() < 0.5 else [high, low]
        spots = [float(t) for t in rng.uniform(low, max(low, high), DRAWS_A_WALL)]
        first = rng.random() < snap
        if low > high:
            continue
        middle = [side.length_m / 2] if centred else []
        for t in (*middle, *ends, *spots) if first else (*middle, *spots, *ends):
            out.append((*side.at(t, depth / 2 + gap), z, side.yaw))
    return out


def in_corners(
    sides: Sequence[Side], size: Vec2, rng: Rng, reach: Reach = NO_REACH
) -> list[PlacedAt]:
    """Poses in the room's outward corners, back to either of the two walls."""
    depth, width = size
    left, right = end_gaps(reach)
    back = SIDE_GAP_M + back_gap(reach)
    out: list[PlacedAt] = []
    for k in rng.permutation(len(sides)).tolist():
        side, before = sides[k], sides[k - 1]
        turn = before.along[0] * side.along[1] - before.along[1] * side.along[0]
        if turn <= 0:
            continue
        first = width / 2 + BACK_GAP_M + left, side
        last = before.length_m - width / 2 - BACK_GAP_M - right, before
        both = [first, last] if rng.random() < 0.5 else [last, first]
        out += [(*wall.at(t, depth / 2 + back), 0.0, wall.yaw) for t, wall in both]
    return out


def in_middle(room: Polygon, taken: BaseGeometry, rng: Rng) -> list[PlacedAt]:
    """Poses about the middle of the largest free part of the floor, square to the room."""
    free = polygons(room.buffer(-MIDDLE_OFF_WALLS_M, join_style="mitre").difference(taken))
    out: list[PlacedAt] = []
    x0, y0, x1, y1 = room.bounds
    long_y = y1 - y0 > x1 - x0
    for part in free[:MIDDLE_PARTS]:
        middle = shapely.maximum_inscribed_circle(part, tolerance=0.05).coords[0]
        for _ in range(MIDDLE_DRAWS):
            x = float(middle[0] + rng.normal(0.0, MIDDLE_SPREAD_M))
            y = float(middle[1] + rng.normal(0.0, MIDDLE_SPREAD_M))
            across = rng.random() < ACROSS_CHANCE
            # A piece is wider (y) than deep, so it lies along the room at yaw 0 if that is y.
            yaw = 0.0 if long_y != across else math.pi / 2
            out.append((x, y, 0.0, yaw))
    return out


def on_free_floor(free: BaseGeometry, size: Vec2) -> list[PlacedAt]:
    """Poses of what lies flat on the largest parts of a free floor, wholly on them, along them
    before across, those nearest the middle of each first."""
    deep, wide = size
    out: list[PlacedAt] = []
    for part in polygons(free)[:MIDDLE_PARTS]:
        x0, y0, x1, y1 = part.bounds
        shapely.prepare(part)
        middle = np.array(part.centroid.coords[0])
        turns = (0.0, math.pi / 2) if y1 - y0 > x1 - x0 else (math.pi / 2, 0.0)
        for yaw in turns:
            u, v = (deep / 2, wide / 2) if yaw == 0.0 else (wide / 2, deep / 2)
            if 2 * u > x1 - x0 or 2 * v > y1 - y0:
                continue
            xs = np.linspace(x0 + u, x1 - u, FLAT_SPOTS)
            ys = np.linspace(y0 + v, y1 - v, FLAT_SPOTS)
            spots = np.stack(np.meshgrid(xs, ys), axis=-1).reshape(-1, 2)
            half = np.array((u, v))
            boxes = shapely.box(*(spots - half).T, *(spots + half).T)
            spots = spots[shapely.covers(part, boxes)]
            order = np.argsort(np.hypot(*(spots - middle).T), kind="stable")
            out += [(x, y, 0.0, yaw) for x, y in spots[order].tolist()]
    return out


def beside(target: ObjectInstance, info: AssetInfo, size: Vec2, rng: Rng) -> list[PlacedAt]:
    """Poses to the left and right of a piece, backs in line."""
    depth, width = size
    x = -info.extents_m[0] / 2 + depth / 2
    y = info.extents_m[1] / 2 + width / 2 + SIDE_GAP_M
    both = [placed_from(target, x, y), placed_from(target, x, -y)]
    return both if rng.random() < 0.5 else both[::-1]


def before(target: ObjectInstance, info: AssetInfo, size: Vec2, gap_m: float) -> list[PlacedAt]:
    """The pose in front of a piece, facing it."""
    x = info.extents_m[0] / 2 + gap_m + size[0] / 2
    return [
        placed_from(target, x, dy, turn=math.pi) for dy in (0.0, BEFORE_BESIDE_M, -BEFORE_BESIDE_M)
    ]


def around(
    target: ObjectInstance,
    info: AssetInfo,
    size: Vec2,
    seated: Sequence[Vec2],
    rng: Rng,
    gap_m: float = 0.0,
) -> list[PlacedAt]:
    """Poses around a table, facing it: across from who is ``seated`` there (where, seen from
    above), then along its long sides; each seat as far under it as may be, then less, or
    ``gap_m`` from it and more."""
    deep, wide = info.extents_m[0] / 2, info.extents_m[1] / 2
    ys = (-wide * SEAT_AT, wide * SEAT_AT) if wide > TWO_SEATS_M else (0.0,)
    sides = [(x, y, turn) for y in ys for x, turn in ((deep, math.pi), (-deep, 0.0))]
    ends = [(0.0, wide, -math.pi / 2), (0.0, -wide, math.pi / 2)]
    seats = [*(sides[k] for k in rng.permutation(len(sides)).tolist()), *ends]

    def is_across(seat: tuple[float, float, float]) -> bool:
        x, y, _ = seat
        other = placed_from(target, -x, y) if x else placed_from(target, 0.0, -y)
        return any(math.dist(other[:2], taken) < ACROSS_M for taken in seated)

    steps = tuple(-gap_m - further for further in FURTHER_M) if gap_m > 0 else TUCKED_M
    return [
        placed_from(target, x - math.cos(turn) * away, y - math.sin(turn) * away, turn)
        for x, y, turn in sorted(seats, key=lambda seat: not is_across(seat))
        for away in (size[0] / 2 - tucked for tucked in steps)
    ]


def opposite(
    target: ObjectInstance,
    sides: Sequence[Side],
    size: Vec2,
    rng: Rng,
    reach: Reach = NO_REACH,
) -> list[PlacedAt]:
    """Poses against the wall a piece faces, right across first."""
    yaw = yaw_of(target.pose.quat_xyzw)
    x, y, _ = target.pose.position_m
    depth, width = size
    first = 1 if rng.random() < 0.5 else -1
    out: list[PlacedAt] = []
    for side in sides:
        facing = math.cos(yaw) * side.inward[0] + math.sin(yaw) * side.inward[1]
        t, away = side.measure((x, y))
        if facing > -OPPOSITE_COS or not OPPOSITE_M[0] < away < OPPOSITE_M[1]:
            continue
        left, right = end_gaps(reach)
        low, high = width / 2 + left, side.length_m - width / 2 - right
        for shift in OPPOSITE_BESIDE_M:
            spot = min(max(t + first * shift, low), high)
            if low <= high and abs(spot - t) < OPPOSITE_MOST_M:
                out.append((*side.at(spot, depth / 2 + back_gap(reach)), 0.0, side.yaw))
    return out


def above(
    target: ObjectInstance, info: AssetInfo, size: Vec2, z: float, sides: Sequence[Side]
) -> list[PlacedAt]:
    """The pose on the wall above a piece that stands against it."""
    gap = gap_behind(target, info, sides)
    x = -info.extents_m[0] / 2 - gap + HUNG_GAP_M + size[0] / 2
    return [(*placed_from(target, x, 0.0)[:2], z, yaw_of(target.pose.quat_xyzw))]


def gap_behind(
    target: ObjectInstance, info: AssetInfo, sides: Sequence[Side], right: bool = False
) -> float:
    """Between the back of a piece, or its right, and the wall that it stands against, metres."""
    x, y, _ = target.pose.position_m
    half = info.extents_m[1 if right else 0] / 2
    yaw = yaw_of(target.pose.quat_xyzw) + (math.pi / 2 if right else 0.0)
    gaps = []
    for side in sides:
        along, away = side.measure((x, y))
        if math.cos(yaw - side.yaw) > 0.99 and 0 <= along <= side.length_m and away > half - 0.05:
            gaps.append(away - half)
    return min(gaps, default=BACK_GAP_M)


def on_top(
    target: ObjectInstance,
    info: AssetInfo,
    size: Vec2,
    top_m: float,
    rng: Rng,
    centred: bool = False,
) -> list[PlacedAt]:
    """Poses on a piece, square to it: shallow things at its back, others in its middle;
    ``centred``: in the middle of its width, too."""
    depth, width = size
    x = 0.0
    if depth < SHALLOW_SHARE * info.extents_m[0]:
        x = -info.extents_m[0] / 2 + TOP_EDGE_M + depth / 2
    slack = 0.0 if centred else max(0.0, (info.extents_m[1] - width) / 2 - TOP_EDGE_M)
    spots = (float(rng.uniform(-slack, slack)) * TOP_SPREAD for _ in range(TOP_SPOTS))
    return [(*placed_from(target, x, y)[:2], top_m, yaw_of(target.pose.quat_xyzw)) for y in spots]


def placed_from(target: ObjectInstance, x: float, y: float, turn: float = 0.0) -> PlacedAt:
    """A pose given in a piece's own frame."""
    yaw = yaw_of(target.pose.quat_xyzw)
    px, py, pz = target.pose.position_m
    c, s = math.cos(yaw), math.sin(yaw)
    return px + c * x - s * y, py + s * x + c * y, pz, yaw + turn
