"""What was found in a furnished scene, whatever its format: the one thing that readers return.

Metres, Z up, right-handed, the floor at z = 0; nothing is snapped, and nothing left out but what
``unresolved`` names.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, replace
from typing import Literal

import numpy as np
import shapely
from shapely.geometry import Polygon
from shapely.geometry.base import BaseGeometry

from sdgen.geometry import Array, Quat, Vec3, matrix, quat_from_matrix, vec3
from sdgen.home.notes import ThingNote

#: A box whose upright axis leans further than this (cosine; 8 degrees) lies, it does not stand.
_UPRIGHT = 0.99
#: A quaternion that is shorter has no direction.
_LEAST_QUAT = 1e-9
#: Above thresholds, below sills, metres.
KNEE_M = 0.4
#: Nobody's home has a piece beyond this, metres: a wrong unit, or a sky.
FARTHEST_M = 1000.0


@dataclass(frozen=True)
class FoundPiece:
    """A thing by its box: ``position_m`` is the middle of the box's base, ``quat_xyzw`` turns the
    box, ``extents_m`` are its sides along its own axes.

    ``names``: what the source calls it, the best first: its own name, its model's, its group's.
    ``front``: its own +X is its front; else nobody knows which side is. ``note``: what our own
    export says of it; ``source``: what its model is called where it is from; ``room``: the name of
    the room that it is said to be in; ``category``: ours, where the source itself says it;
    ``sized``: its size is known; else ``position_m`` is its middle.
    """

    name: str
    position_m: Vec3
    quat_xyzw: Quat
    extents_m: Vec3
    names: tuple[str, ...] = ()
    front: bool = False
    note: ThingNote | None = None
    source: str | None = None
    room: str | None = None
    category: str | None = None
    loose: bool | None = None
    sized: bool = True

    @property
    def top_m(self) -> float:
        """How high it ends."""
        return self.position_m[2] + self.extents_m[2]


@dataclass(frozen=True)
class FoundFloor:
    """The floor of a room, seen from above, and what the source calls the room."""

    name: str
    shape: BaseGeometry
    type: str | None = None
    level_m: float = 0.0


@dataclass(frozen=True)
class FoundWall:
    """A piece of wall, seen from above, between two heights. ``low_shape``: what of it is there at
    :data:`KNEE_M` above its foot, where only ways through it are holes; None: all of it."""

    name: str
    shape: BaseGeometry
    low_m: float
    high_m: float
    low_shape: BaseGeometry | None = None

    def at_knee(self, floor_m: float) -> BaseGeometry:
        """What of it is in the way of a knee."""
        if self.low_shape is not None:
            return self.low_shape
        return self.shape if self.low_m < floor_m + KNEE_M < self.high_m else Polygon()


@dataclass(frozen=True)
class FoundOpening:
    """A hole in a wall, or the door or window that fills it. ``kind``: what is known of it."""

    name: str
    kind: Literal["door", "front_door", "window", "passage", "double_door", "wide_passage"]
    center_m: Vec3
    """On the floor for doors, on the sill for windows."""
    along: Literal["x", "y"] | None
    width_m: float
    height_m: float
    inward: tuple[float, float] | None = None
    """The way its front looks: into the room that its leaf opens into."""
    note: ThingNote | None = None


@dataclass
class FoundScene:
    """A furnished scene. ``drawn``: our own export says what it is, so that its floors end on the
    middle lines of walls; ``unresolved``: what is there and nothing is made of, each with why;
    ``told``: what was assumed."""

    source: str
    title: str = ""
    style: str = ""
    height_m: float | None = None
    drawn: bool = False
    floors: list[FoundFloor] = field(default_factory=list)
    walls: list[FoundWall] = field(default_factory=list)
    openings: list[FoundOpening] = field(default_factory=list)
    pieces: list[FoundPiece] = field(default_factory=list)
    unresolved: list[str] = field(default_factory=list)
    told: list[str] = field(default_factory=list)


def pose_of(position_m: Sequence[float], quat_xyzw: Sequence[float]) -> Array:
    """4x4 of a pose; a quaternion without length, as some write, turns nothing."""
    sound = math.hypot(*quat_xyzw) > _LEAST_QUAT
    return matrix(position_m, quat_xyzw if sound else (0.0, 0.0, 0.0, 1.0))


def check_reach(points: Array) -> None:
    """Raise ValueError for points (N, 3) that lie out of any home, or are not finite."""
    if not np.abs(points).max(initial=0.0) <= FARTHEST_M:
        raise ValueError(f"it lies or reaches further than {FARTHEST_M:g} m: is its unit metres?")


def box_piece(name: str, world_from_box: Array, low: Array, high: Array) -> FoundPiece:
    """A piece from the box (lowest and highest corner) in its own frame, whichever of its axes is
    up; what lies aslant gets the box along the world's axes.

    Raises ValueError for what is not finite, has no size, or lies out of any home.
    """
    numbers = np.concatenate([world_from_box.ravel(), low, high])
    if not np.isfinite(numbers).all():
        raise ValueError("its place or size is not finite")
    scales = np.linalg.norm(world_from_box[:3, :3], axis=0)
    if scales.min() < 1e-9:
        raise ValueError("its scale is zero")
    turned = world_from_box[:3, :3] / scales
    middle = world_from_box[:3, :3] @ ((low + high) / 2) + world_from_box[:3, 3]
    sides = (high - low) * scales
    check_reach(np.array([middle, sides]))
    upright = int(np.argmax(np.abs(turned[2])))
    if abs(turned[2, upright]) < _UPRIGHT:
        sides = np.abs(turned) @ sides
        axes = np.eye(3)
    else:
        axes, sides = _upright(turned, sides, upright)
    return FoundPiece(
        name=name,
        position_m=vec3(middle - (0.0, 0.0, sides[2] / 2)),
        quat_xyzw=quat_from_matrix(axes),
        extents_m=vec3(np.maximum(sides, 1e-4)),
    )


def _upright(turned: Array, sides: Array, upright: int) -> tuple[Array, Array]:
    """The frame with z up that has a box's axes, and its sides along it: x is the first of the
    other two axes, so that a frame that stands already stays as it is."""
    first = (upright + 1) % 3 if upright == 2 else min(k for k in range(3) if k != upright)
    second = 3 - upright - first
    x = turned[:, first].copy()
    x[2] = 0.0
    x /= np.linalg.norm(x)
    axes = np.column_stack([x, np.cross((0.0, 0.0, 1.0), x), (0.0, 0.0, 1.0)])
    return axes, sides[[first, second, upright]]


def footprint(points: Array) -> BaseGeometry:
    """What points (N, 3) cover, seen from above: their hull."""
    return shapely.MultiPoint(points[:, :2]).convex_hull


def triangles_from_above(triangles: Array) -> BaseGeometry:
    """What triangles (N, 3, 3) cover, seen from above; upright ones leave their line, a
    millimetre thick, where nothing else is."""
    flat = triangles[:, :, :2]
    (ax, ay), (bx, by) = (flat[:, 1] - flat[:, 0]).T, (flat[:, 2] - flat[:, 0]).T
    level = flat[np.abs(ax * by - ay * bx) > 2e-8]
    if len(level):
        return shapely.union_all([Polygon(ring) for ring in level], grid_size=1e-5)
    lines = [shapely.LineString(ring) for ring in flat]
    return shapely.union_all(lines).buffer(5e-4, cap_style="flat", join_style="mitre")


def triangles_at(triangles: Array, level_m: float) -> BaseGeometry:
    """Where a level cuts triangles (N, 3, 3), seen from above: lines."""
    above = triangles[:, :, 2] > level_m
    lines = []
    for corners, side in zip(triangles, above, strict=True):
        if side.all() or not side.any():
            continue
        ends = []
        for k in range(3):
            a, b = corners[k], corners[(k + 1) % 3]
            if side[k] != side[(k + 1) % 3]:
                share = (level_m - a[2]) / (b[2] - a[2])
                ends.append(tuple((a + share * (b - a))[:2].tolist()))
        lines.append(shapely.LineString(ends))
    return shapely.MultiLineString(lines)


def moved_down(scene: FoundScene, level_m: float) -> FoundScene:
    """The scene with its floor at 0."""

    def down(position: Sequence[float]) -> Vec3:
        return (position[0], position[1], position[2] - level_m)

    def each(walls: Iterable[FoundWall]) -> list[FoundWall]:
        return [
            replace(wall, low_m=wall.low_m - level_m, high_m=wall.high_m - level_m)
            for wall in walls
        ]

    return replace(
        scene,
        floors=[replace(floor, level_m=floor.level_m - level_m) for floor in scene.floors],
        walls=each(scene.walls),
        openings=[replace(one, center_m=down(one.center_m)) for one in scene.openings],
        pieces=[replace(one, position_m=down(one.position_m)) for one in scene.pieces],
    )
