"""What things lie on is what is seen: collision pieces against the drawn mesh, from above.

Things rest on pieces and are looked at on meshes (``tests/audit`` finds what is 5 mm in or 10 mm
over what carries it). Heights of both are compared by vertical rays over every support, and over
the floor of every hollow that small things have.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
import pytest
import shapely
from scipy.ndimage import maximum_filter
from scipy.spatial import ConvexHull
from sdgen.geometry import Array
from sdgen.library.records import Asset
from sdgen.library.shape import corners_of
from shapely.geometry import Polygon, box

from tests.shipped import shipped_library

#: What is drawn may be so much above the pieces (things sink in) and below them (things hang),
#: metres, but for a share of the region: with the 2 mm that a piece of the thing itself may be off
#: (reaching.py) a thing stays within what an audit takes.
SINKS_M, HANGS_M, SHARE = 0.003, 0.005, 0.05
#: A thing that lies there is at least twice as long, and spans slots and grooves; it stays so far
#: from steep walls as its own width, metres.
SPANNED_M, WALL_M = 0.03, 0.008
#: Rays are at least so far apart and at most so many along a side; supports end where things stop
#: (their border may be a wall); what is higher than this over the floor carries nothing, metres.
STEP_M, ALONG, BORDER_M, ROOM_M = 0.004, 60, 0.003, 0.15
#: Further below is no floor but a gap, metres.
DEEP_M = 0.045

#: Convex pieces cannot follow these, and what they carry spans them or is rarely put there: how far
#: small things hang over what is drawn, metres.
HOLLOWED = {
    # grates and rings of hobs: what stands there is a pan
    "stove": 0.046,
    # seats hollowed like a saddle, and woven ones that sag
    "bar_stool_05": 0.0065,
    "stool_04": 0.0055,
    # a quilt with a step
    "bed_01": 0.0075,
}


@dataclass(frozen=True)
class Region:
    """Where something is put: the outline (seen from above), its floor and the room over it."""

    name: str
    shape: Polygon
    z_m: float
    room_m: float
    steep: bool


def regions(asset: Asset, full: bool) -> Iterator[Region]:
    for s in asset.supports:
        room = min(s.headroom_m or ROOM_M, ROOM_M)
        yield Region(s.name, Polygon(s.polygon_m), s.z_m, 0.9 * room, False)
    if max(asset.extents_m) > 0.6 or full:
        return  # into furniture things are put on its supports, into what is full none are
    for hollow in (c for c in asset.containers if not c.closed_by and c.name != "slots"):
        (x, y, z), (wide, deep, high) = hollow.center_m, hollow.size_m
        ends = box(x - wide / 2, y - deep / 2, x + wide / 2, y + deep / 2)
        room = 0.9 * min(high, ROOM_M)
        yield Region(f"in {hollow.name}", ends, z - high / 2, room, True)


def crossings(triangles: Array, xs: Array, ys: Array) -> tuple[Array, Array]:
    """Where vertical rays on a grid meet triangles (N, 3, 3): index of the ray, height."""
    low, high = triangles[:, :, :2].min(axis=1), triangles[:, :, :2].max(axis=1)
    i0, i1 = np.searchsorted(xs, low[:, 0]), np.searchsorted(xs, high[:, 0])
    j0, j1 = np.searchsorted(ys, low[:, 1]), np.searchsorted(ys, high[:, 1])
    count = (i1 - i0) * (j1 - j0)
    tri = np.repeat(np.arange(len(triangles)), count)
    k = np.arange(len(tri)) - np.repeat(np.cumsum(count) - count, count)
    across = np.maximum(j1 - j0, 1)[tri]
    i, j = i0[tri] + k // across, j0[tri] + k % across
    corners = triangles[tri]
    a = corners[:, :, :2] - np.stack([xs[i], ys[j]], axis=1)[:, None]
    b = np.roll(a, -1, axis=1)
    areas = np.roll(a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0], -1, axis=1)
    total = areas.sum(axis=1)
    met = (np.abs(total) > 1e-14) & (areas * np.sign(total)[:, None] >= 0).all(axis=1)
    heights = (areas[met] * corners[met, :, 2]).sum(axis=1) / total[met]
    return i[met] * len(ys) + j[met], heights


def off(drawn: Array, pieces: Sequence[Array], region: Region) -> tuple[Array, Array]:
    """How far things sink into what is drawn, and hang over it, at points of a region, metres."""
    x0, y0, x1, y1 = region.shape.bounds
    step = max(STEP_M, max(x1 - x0, y1 - y0) / ALONG)
    xs, ys = (np.arange(a + 1.1e-5, b, step) for a, b in ((x0, x1), (y0, y1)))
    rays = len(xs) * len(ys)
    top, floor = region.z_m + region.room_m, region.z_m - DEEP_M
    seen, carried = np.full(rays, floor), np.full(rays, floor)
    ray, z = crossings(drawn, xs, ys)
    np.maximum.at(seen, ray[z <= top], z[z <= top])
    for piece in pieces:
        lowest, highest = np.full(rays, np.inf), np.full(rays, -np.inf)
        ray, z = crossings(piece, xs, ys)
        np.minimum.at(lowest, ray, z)
        np.maximum.at(highest, ray, z)
        within = lowest < top - BORDER_M
        carried[within] = np.maximum(carried[within], np.minimum(highest[within], top))

    def near(heights: Array, reach: float) -> Array:
        wide = 2 * int(reach / step) + 1
        return maximum_filter(heights.reshape(len(xs), len(ys)), wide).ravel()

    grid = np.meshgrid(xs, ys, indexing="ij")
    inner = region.shape.buffer(-BORDER_M)
    inside = shapely.contains_xy(inner, grid[0].ravel(), grid[1].ravel())
    sinks = seen - (near(carried, WALL_M) if region.steep else carried)
    hangs = carried - near(seen, SPANNED_M if not region.steep else WALL_M)
    return sinks[inside & (seen > floor)], hangs[inside & (carried > floor)]


def triangles_of(points: Array) -> Array:
    return points[ConvexHull(points).simplices]


def found() -> Iterator[tuple[Asset, Region, Array, Array]]:
    """Every region once, skins of one shape together."""
    library, known = shipped_library(), set()
    for asset in library.assets.values():
        if not (asset.supports or asset.containers):
            continue
        parts = asset.variants["default"]
        hulls = [hull for hull in library.hulls(asset.id) if hull.part in parts]
        solid = {hull.part for hull in hulls}  # the others are water and lights
        full = bool(asset.containers) and not solid.issuperset(parts)
        new = [r for r in regions(asset, full) if (asset.mesh, r) not in known]
        known |= {(asset.mesh, region) for region in new}
        if new:
            pieces = [triangles_of(hull.vertices_m) for hull in hulls]
            meshes = library.mesh(asset.id)
            drawn = corners_of([meshes[part] for part in solid])
            for region in new:
                yield asset, region, *off(drawn, pieces, region)


@pytest.mark.library
def test_nothing_sinks_into_what_it_lies_on_or_hangs_over_it() -> None:
    problems, count = [], 0
    for asset, region, sinks, hangs in found():
        count += 1
        allowed = HOLLOWED.get(asset.id, HOLLOWED.get(asset.category, HANGS_M))
        for what, depth, limit in (("sink in", sinks, SINKS_M), ("hang over", hangs, allowed)):
            share = float((depth > limit).mean()) if len(depth) else 0.0
            if share > SHARE:
                worst = 1000 * float(np.percentile(depth, 98))
                problems.append(f"{asset.id} {region.name}: {what} {worst:.1f} mm, {share:.2f}")
    assert count > 900
    assert not problems, "\n".join(problems)
