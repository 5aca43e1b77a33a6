"""What is made out of one object: its outline, how high it reaches, what is level on it."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
import shapely
from shapely.geometry.base import BaseGeometry

from sdgen.freespace import opening_rectangle
from sdgen.geometry import Array, quat_from_yaw, rotation_matrix, yaw_of
from sdgen.perception.clouds import Cloud
from sdgen.perception.kinds import Kind
from sdgen.perception.levels import Level, levels_of, outline_of
from sdgen.scene import ObjectInstance, Opening
from sdgen.vocabulary import HALF_WALL_M

#: What leans less than this (its cosine) stands upright.
UPRIGHT = 0.999
#: The lower end of an object is seen when its outline ends, with nothing before it, within so much
#: of its lowest point, metres.
ENDS_WITHIN_M = 0.015
#: So far the frame of a door or window stands out of its wall, metres.
FRAME_M = 0.01
#: Fewer points say nothing of a leaf of its own.
LEAST_LEAF = 20


@dataclass
class Piece:
    """A part of a thing as an upright prism: its outline from above and its heights, metres.
    ``slides``: it is a drawer."""

    outline: BaseGeometry
    low: float
    high: float
    slides: bool = False


@dataclass
class Thing:
    """An object as it was made out: ``name`` of its class and what is known of that; ``turn`` (3,
    3), its axes in the world; its body, leaves that stand open, and level surfaces; ``ends``: its
    lower end is seen, not hidden; ``opening``: it fills one."""

    id: int
    name: str
    kind: Kind
    fixed: bool
    quat: tuple[float, float, float, float]
    body: Piece
    leaves: list[Piece]
    levels: list[Level]
    ends: bool
    states: tuple[str, ...] = ()
    opening: bool = False

    @property
    def turn(self) -> Array:
        """Its axes in the world, (3, 3)."""
        return rotation_matrix(self.quat)

    @property
    def upright(self) -> bool:
        """It stands as it was made to."""
        return bool(self.turn[2, 2] > UPRIGHT)


def thing_of(
    item: ObjectInstance,
    name: str,
    kind: Kind,
    fixed: bool,
    cloud: Cloud,
    open_parts: Collection[tuple[int, bool]],
    opening: Opening | None = None,
) -> Thing:
    """What the points of an object make it out to be. ``open_parts``: values of its parts that
    stand open, and whether they slide; ``opening``: what it fills, as the plan has it."""
    upright = rotation_matrix(item.pose.quat_xyzw)[2, 2] > UPRIGHT
    quat = quat_from_yaw(yaw_of(item.pose.quat_xyzw)) if upright else item.pose.quat_xyzw
    leaves = []
    still = np.ones(len(cloud.points), dtype=np.bool_)
    for value, slides in open_parts:
        mine = cloud.part == value
        if mine.sum() >= LEAST_LEAF:
            leaves.append(_piece(cloud, mine, slides))
            still &= ~mine
    if not still.any():
        still[:] = True
        # Of a door the plan tells where the rest is; of furniture, a leaf alone is all there is.
        leaves = leaves if opening is not None else []
    body = _piece(cloud, still)
    if upright and kind.boxy:
        body.outline = rectangle(body.outline, rotation_matrix(quat))
    levels: list[Level] = []
    if upright and kind.carries:
        levels = levels_of(cloud.points[still], cloud.upward[still], cloud.rim[still])
    ends = cloud.points[still & cloud.ends, 2]
    seen = bool(len(ends) and float(ends.min()) <= body.low + ENDS_WITHIN_M)
    if opening is not None:
        _fill(body, opening)
    return Thing(
        item.id, name, kind, fixed, quat, body, leaves, levels, seen, opening=opening is not None
    )


def rectangle(outline: BaseGeometry, turn: Array) -> BaseGeometry:
    """The rectangle around an outline that is turned as a thing is: of a box whose far corner is
    hidden, the whole."""
    flat = turn[:2, :2]
    own = shapely.get_coordinates(outline) @ flat
    (x0, y0), (x1, y1) = own.min(axis=0), own.max(axis=0)
    return shapely.polygons(np.array([(x0, y0), (x1, y0), (x1, y1), (x0, y1)]) @ flat.T)


def _fill(body: Piece, opening: Opening) -> None:
    """Let a door or window fill its opening: a leaf is seen from one side."""
    sill = opening.center_m[2]
    body.outline = opening_rectangle(opening, HALF_WALL_M + FRAME_M)
    body.low = min(body.low, sill)
    body.high = max(body.high, sill + opening.height_m)


def _piece(cloud: Cloud, mine: npt.NDArray[np.bool_], slides: bool = False) -> Piece:
    points = cloud.points[mine]
    heights = points[:, 2]
    outline = outline_of(points, cloud.rim[mine])
    return Piece(outline, float(heights.min()), float(heights.max()), slides)
