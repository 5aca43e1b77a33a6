"""Where on a piece of furniture a thing may be put so that it reaches to its edge, or over it."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import shapely

from sdgen.home.layout import DROP_M, GAP_M, TRIES, Bulk, Layout, Vec3Yaw, space_at, within_room
from sdgen.home.surfaces import PlacingSurface
from sdgen.library.drawn import drawn
from sdgen.library.supports import MARGIN_M
from sdgen.scene import Home, ObjectInstance
from sdgen.seeding import Rng

#: Beyond the edge so much is free below, metres: what stands there, lower by less, would catch it.
DROP_BELOW_M = 0.25
#: The end that reaches out points straight over the edge, give or take so many radians (9 degrees:
#: a pan that somebody put down).
SPREAD_RAD = 0.15
#: From the edge outwards so much floor is looked at, metres, where nothing reaches over it.
STEP_M = 0.1


def spot_at_edge(
    layout: Layout,
    home: Home,
    thing: ObjectInstance,
    target_id: int,
    reach_m: tuple[float, float],
    rng: Rng,
) -> Vec3Yaw | None:
    """A free spot on a placed object from which a thing reaches ``reach_m`` [least, most] metres
    beyond the edge of its surface, over open floor; less than 0 is within it.

    The end that is farthest from its middle, the handle of a pan, points outwards. Its middle is
    on the surface: whether it stands so is for physics to say.
    """
    target = layout.items[target_id]
    surfaces = [s for s in layout.surfaces_of(target_id) if s.support.container is None]
    if not surfaces:
        return None
    info, bulk = layout.library.info(thing.asset), layout.bulk_of(thing)
    far_end = _far_end(drawn(info, thing.variant, thing.joints).points_m[:, :2])
    for _ in range(TRIES):
        surface = surfaces[int(rng.integers(len(surfaces)))]
        headroom = surface.support.headroom_m
        if headroom is not None and bulk.size_m[2] > headroom:
            continue
        spot = _try(layout, home, target, surface, bulk, far_end, reach_m, rng)
        if spot is not None:
            return spot
    return None


def _far_end(points: np.ndarray) -> float:
    """The direction, in the object's frame, of what reaches farthest from its middle."""
    hull = shapely.MultiPoint(points).convex_hull
    middle = np.array([hull.centroid.x, hull.centroid.y])
    far = points[int(np.linalg.norm(points - middle, axis=1).argmax())] - middle
    return math.atan2(far[1], far[0])


def _try(
    layout: Layout,
    home: Home,
    target: ObjectInstance,
    surface: PlacingSurface,
    bulk: Bulk,
    far_end: float,
    reach_m: tuple[float, float],
    rng: Rng,
) -> Vec3Yaw | None:
    ring = shapely.get_coordinates(surface.shape.exterior)
    sides = [(a, b) for a, b in pairwise(ring) if np.linalg.norm(b - a) > GAP_M]
    start, end = sides[int(rng.integers(len(sides)))]
    along = (end - start) / np.linalg.norm(end - start)
    out = np.array([along[1], -along[0]])
    if not shapely.is_ccw(surface.shape.exterior):
        out = -out
    at_edge = start + rng.random() * (end - start) + MARGIN_M * out
    yaw = math.atan2(out[1], out[0]) - far_end + float(rng.normal(0.0, SPREAD_RAD))
    reach = float(rng.uniform(*reach_m))
    cos, sin = math.cos(yaw), math.sin(yaw)
    # How far its box reaches from its middle towards the edge.
    half = abs(out[0] * cos + out[1] * sin) * bulk.size_m[0] / 2
    half += abs(out[1] * cos - out[0] * sin) * bulk.size_m[1] / 2
    middle = at_edge + (reach - half) * out
    if not surface.shape.contains(shapely.Point(middle)):
        return None
    point = (float(middle[0]), float(middle[1]))
    block = space_at(bulk.size_m, (*point, surface.z_m), yaw, GAP_M, DROP_M)
    beyond = max(reach, 0.0) + STEP_M
    over = at_edge + (beyond / 2 + GAP_M) * out
    heading = math.atan2(out[1], out[0])
    width = min(bulk.size_m[:2])
    base = (float(over[0]), float(over[1]), surface.z_m - DROP_BELOW_M)
    air = space_at((beyond, width, DROP_BELOW_M), base, heading, 0.0)
    if not (layout.fits([block], ignore=target.id) and layout.fits([air], ignore=target.id)):
        return None
    if not within_room([air], home, target.room_id):
        return None
    return (*bulk.origin(point, yaw), surface.z_m), yaw
