"""Where a model's leaves, lids and drawers go on their way open, as placing needs it."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np
import shapely

from sdgen.geometry import Array, apply, joint_matrix
from sdgen.library.above import Above, seen_from_above
from sdgen.library.meshes import Hull, MeshData
from sdgen.library.records import AssetInfo, Joint

#: A leaf or lid opens as far as people need at a right angle (or its own limit, if that is less):
#: drawers and baskets behind it come out, and a lid stays up. A drawer comes out all the way.
OPEN_RAD = math.pi / 2
#: A turn is followed in steps of 10 degrees: of a leaf 0.6 m wide the arc between two lies 2 mm
#: beyond their hull.
STEP_RAD = math.radians(10)
#: Of a way the outermost 4 mm may be taken: play of hinges, and less than what counts as entering.
PLAY_M = 0.004
#: Added to how far a way goes, so that what stands off by it stays clear when poses are rounded.
SURE_M = 0.001


class Reach(NamedTuple):
    """How far what opens goes beyond the box of its model: behind it, and to its left (+Y) and
    right, metres."""

    back_m: float = 0.0
    left_m: float = 0.0
    right_m: float = 0.0


def way_of(info: AssetInfo, meshes: Mapping[str, MeshData], hulls: Sequence[Hull]) -> Above | None:
    """What the moving parts of the default variant pass through from shut to open, without the
    outermost ``PLAY_M``; None when nothing of it opens. By what is drawn (handles stand out of
    collision pieces) and by what collides (a lid's piece may stand out of its rim)."""
    pieces = list(_pieces(info, meshes, hulls))
    return _narrowed(seen_from_above(pieces)) if pieces else None


def reach_of(info: AssetInfo, way: Above | None) -> Reach:
    """How far a way goes beyond the model's box."""
    if way is None:
        return Reach()
    (x0, y0), (_, y1) = way.points_m.min(axis=0), way.points_m.max(axis=0)
    depth, width, _ = info.extents_m
    return Reach(
        back_m=max(0.0, float(-x0) - depth / 2 + SURE_M),
        left_m=max(0.0, float(y1) - width / 2 + SURE_M),
        right_m=max(0.0, float(-y0) - width / 2 + SURE_M),
    )


def _pieces(
    info: AssetInfo, meshes: Mapping[str, MeshData], hulls: Sequence[Hull]
) -> Iterator[Array]:
    for part in info.variants["default"]:
        name = info.part(part).joint
        if name is None:
            continue
        joint = info.joint(name)
        mine = [hull.vertices_m for hull in hulls if hull.part == part]
        points = np.concatenate([meshes[part].vertices, *mine])
        passed = [
            apply(joint_matrix(joint.type, joint.origin_m, joint.axis, value), points)
            for value in _values(joint)
        ]
        for before, after in pairwise(passed):
            yield np.concatenate([before, after])


def _values(joint: Joint) -> list[float]:
    shut = min(max(0.0, joint.lower), joint.upper)
    far = max((joint.lower, joint.upper), key=lambda value: abs(value - shut))
    if joint.type == "prismatic":
        return [shut, far]
    far = shut + math.copysign(min(abs(far - shut), OPEN_RAD), far - shut)
    steps = max(1, math.ceil(abs(far - shut) / STEP_RAD))
    return [shut + (far - shut) * k / steps for k in range(steps + 1)]


def _narrowed(way: Above) -> Above | None:
    """The pieces without ``PLAY_M`` on all sides; those that have no more are left out."""
    ends = [*way.starts[1:].tolist(), len(way.points_m)]
    rings, lows, highs = [], [], []
    for k, (start, end) in enumerate(zip(way.starts.tolist(), ends, strict=True)):
        inner = shapely.polygons(way.points_m[start:end]).buffer(-PLAY_M, join_style="mitre")
        low, high = way.low_m[k] + PLAY_M, way.high_m[k] - PLAY_M
        if inner.is_empty or low >= high:
            continue
        rings.append(shapely.get_coordinates(inner))
        lows.append(low)
        highs.append(high)
    if not rings:
        return None
    starts = np.cumsum([0, *(len(ring) for ring in rings[:-1])])
    return Above(np.concatenate(rings), starts, np.array(lows), np.array(highs))
