"""What people would rather not have where a piece stands: a doorway's line, its frame and its open
leaf crowded, windows with their radiators covered, seats pressed against other furniture."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import shapely
from shapely.geometry import Polygon

from sdgen.facts import bodies_of
from sdgen.geometry import Array, Vec2, yaw_of
from sdgen.home.anchors import PlacedAt
from sdgen.home.layout import Layout
from sdgen.scene import Opening, Room
from sdgen.vocabulary import HALF_WALL_M
from sdgen.zones import swing_sectors

#: Costs, in metres that a piece might as well stand further from where it would be (see
#: :mod:`sdgen.home.wishes`); all by eye, after what readers of pictures called in the way.
IN_LINE, BEHIND_LEAF, ELBOWS = 1.0, 0.6, 0.5
#: A piece is in a doorway's line up to so far before it, less and less over the last stretch, and
#: at its frame up to so far beside it.
LINE_M, LINE_FADES_M, FRAME_M = 1.4, 0.5, 0.35
#: What stands so far from a window's wall stands before it; radiators reach beyond the hole.
WINDOW_M, RADIATOR_M = 0.4, 0.1
#: Seats want so much to what they do not belong to.
ELBOW_M = 0.25


@dataclass(frozen=True)
class Mouths:
    """The openings of a room as seen from in it, one a row: the ``middles`` (N, 2) at the wall's
    face, ``alongs`` and ``inwards`` (N, 2, unit), half widths (N); which are ``windows`` (N), and
    the width of leaves (N) that open into the room, on the side ``hinges`` (N: -1, 0 or 1, along).
    """

    middles: Array
    alongs: Array
    inwards: Array
    halves: Array
    windows: Array
    leaves: Array
    hinges: Array


def mouths_of(room: Room, openings: Sequence[Opening], layout: Layout) -> Mouths:
    """The openings of a room, filled in the layout."""
    outline = Polygon(room.polygon_m)
    middles, alongs, inwards, leaves, hinges = [], [], [], [], []
    for opening in openings:
        along = np.array([1.0, 0.0] if opening.along == "x" else [0.0, 1.0])
        inward = along[::-1]
        middle = np.array(opening.center_m[:2])
        if not outline.contains(shapely.points(middle + 2 * HALF_WALL_M * inward)):
            inward = -inward
        middles.append(middle + HALF_WALL_M * inward)
        alongs.append(along)
        inwards.append(inward)
        leaf, hinge = _leaf(opening, outline, layout)
        leaves.append(leaf)
        hinges.append(0.0 if hinge is None else np.sign((np.array(hinge) - middle) @ along))
    return Mouths(
        middles=np.array(middles).reshape(-1, 2),
        alongs=np.array(alongs).reshape(-1, 2),
        inwards=np.array(inwards).reshape(-1, 2),
        halves=np.array([o.width_m / 2 for o in openings]),
        windows=np.array([o.kind == "window" for o in openings], dtype=bool),
        leaves=np.array(leaves),
        hinges=np.array(hinges),
    )


def _leaf(opening: Opening, room: Polygon, layout: Layout) -> tuple[float, Vec2 | None]:
    """Width and hinge of the one leaf that opens into a room; 0 and None where none does."""
    item = layout.items.get(opening.object_id)
    joints = layout.info(item.id).joints if item is not None else ()
    if item is None or opening.kind == "window" or len(joints) != 1:
        return 0.0, None
    (swept,) = swing_sectors(bodies_of([item], layout.library.infos))
    if not room.contains(swept.centroid):
        return 0.0, None
    x, y, _ = item.pose.position_m
    yaw, aside = yaw_of(item.pose.quat_xyzw), joints[0].origin_m[1]
    return opening.width_m, (x - math.sin(yaw) * aside, y + math.cos(yaw) * aside)


def crowding(poses: Sequence[PlacedAt], size: Vec2, mouths: Mouths, at_window: float) -> Array:
    """What openings cost a piece of this size (depth, width) in each of its poses (N), metres;
    ``at_window`` where it covers one."""
    if not len(mouths.halves) or not poses:
        return np.zeros(len(poses))
    at = np.array(poses)
    off = at[:, None, :2] - mouths.middles
    aside = (off * mouths.alongs).sum(axis=2)
    away = (off * mouths.inwards).sum(axis=2)
    reach_aside, reach_away = (_reach(at, size, axes) for axes in (mouths.alongs, mouths.inwards))
    near = away - reach_away
    beside = np.abs(aside) - reach_aside - mouths.halves

    depth = np.clip((LINE_M - near) / LINE_FADES_M, 0.0, 1.0) * (away > 0)
    cost = IN_LINE * np.clip(1.0 - beside / FRAME_M, 0.0, 1.0) * depth
    behind = mouths.hinges * aside - reach_aside - mouths.halves
    leaves = np.maximum(mouths.leaves, HALF_WALL_M)
    leaned = np.clip(1.0 - behind / leaves, 0.0, 1.0) * (near < leaves) * (away > 0)
    cost += BEHIND_LEAF * leaned * (mouths.hinges * aside > 0)

    covered = -(beside - RADIATOR_M) / (2 * np.minimum(reach_aside, mouths.halves))
    before = np.clip(covered, 0.0, 1.0) * (near < WINDOW_M) * (away > 0)
    window = at_window * before
    total: Array = np.where(mouths.windows, window, cost).sum(axis=1)
    return total


def elbows(poses: Sequence[PlacedAt], size: Vec2, others: Sequence[Polygon]) -> Array:
    """What it costs a piece of this size, in each of its poses (N), to stand by these, metres."""
    if not others or not poses:
        return np.zeros(len(poses))
    at = np.array(poses)
    boxes = shapely.bounds(np.array(others))
    middles, halves = (boxes[:, :2] + boxes[:, 2:]) / 2, (boxes[:, 2:] - boxes[:, :2]) / 2
    own = np.stack([_reach(at, size, np.array([axis])) for axis in ((1.0, 0.0), (0.0, 1.0))], 2)
    gaps = np.abs(at[:, None, :2] - middles) - halves - own
    apart = np.linalg.norm(np.maximum(gaps, 0.0), axis=2)
    total: Array = ELBOWS * np.clip(1.0 - apart / ELBOW_M, 0.0, 1.0).sum(axis=1)
    return total


def _reach(at: Array, size: Vec2, axes: Array) -> Array:
    """How far pieces reach from their middle along each axis (N, M)."""
    ahead = np.stack([np.cos(at[:, 3]), np.sin(at[:, 3])], axis=1)
    left = np.stack([-ahead[:, 1], ahead[:, 0]], axis=1)
    reach: Array = np.abs(ahead @ axes.T) * size[0] / 2 + np.abs(left @ axes.T) * size[1] / 2
    return reach
