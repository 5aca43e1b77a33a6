"""Finds on a model where things stand and what they can be inside of.

Surfaces as everywhere (:mod:`sdgen.library.supports`); receptacle boxes of the source where it has
some; hollows that are open above by flooding the model's heights (Barnes et al., "Priority-flood",
Computers & Geosciences 62, 2014); those behind doors by looking which of their sides are shut.
"""

from __future__ import annotations

import heapq
import math
from collections.abc import Mapping, Sequence

import numpy as np
import numpy.typing as npt
from shapely.geometry import Polygon, box

from sdgen.geometry import Array
from sdgen.importing.scan import Box
from sdgen.library.meshes import MeshData
from sdgen.library.records import Container, Joint, Support
from sdgen.library.shape import corners_of
from sdgen.library.supports import MARGIN_M, carried_share, find_supports, headroom_m

#: Cells of the height map along the longer side.
_CELLS = 64
#: A hollow is at least this deep, of the height and in metres, and has this share of the footprint.
_DEEP_SHARE, _DEEP_M, _WIDE_SHARE = 0.18, 0.008, 0.08
#: A receptacle box lies on a surface at most so far from its bottom, metres.
_NEAR_M = 0.08
#: Receptacle boxes that are looked at: the largest thing of ReplicaCAD has a dozen.
_MOST_BOXES = 60
#: Nothing stands under less room than this; what reaches this far over a surface is above it.
_ROOM_M, _TOUCH_M = 0.04, 0.01
#: Walls of a space behind a door are nearer than this to its surface, metres.
_WALL_M = 0.15


def supports_of(
    meshes: Mapping[str, MeshData], boxes: Sequence[Box], fixed: Sequence[str]
) -> tuple[Support, ...]:
    """Surfaces of the parts that nothing moves (``fixed``); the source's boxes first.

    Left out is what a drawer fills, and what has no room over it."""
    still = {name: meshes[name] for name in fixed}
    moving = [mesh.vertices for name, mesh in meshes.items() if name not in still]
    everything = corners_of(list(meshes.values()))
    out: list[Support] = []
    for given in boxes[:_MOST_BOXES]:
        found = _under(given, everything, fixed[0])
        if found is not None and not any(_same(found, other) for other in out):
            out.append(found)
    for found in find_supports(still):
        if not any(_same(found, other) for other in out):
            out.append(found)
    out = [left for support in out if (left := _under_drawers(support, moving)) is not None]
    out.sort(key=lambda s: (s.z_m, s.polygon_m))
    return tuple(s.model_copy(update={"name": f"surface_{k}"}) for k, s in enumerate(out, 1))


def open_hollow(meshes: Sequence[MeshData], part: str) -> Container | None:
    """The largest hollow that is open above, as a box; None when there is none."""
    heights, low, cell = height_map(corners_of(meshes))
    level = flooded(heights)
    solid = np.isfinite(heights)
    depth = np.zeros_like(heights)
    depth[solid] = level[solid] - heights[solid]
    top = float(np.max(heights[np.isfinite(heights)]))
    wet = depth > max(_DEEP_M, _DEEP_SHARE * top)
    region = _largest(wet)
    if region.sum() < max(4, _WIDE_SHARE * np.isfinite(heights).sum()):
        return None
    rows, columns = np.nonzero(region)
    bottom = float(np.median(heights[region]))
    rim = float(np.median(level[region]))
    middle = np.array([np.mean(rows) + 0.5, np.mean(columns) + 0.5])
    # A box within a round hollow: half of its cells lie in the middle part of each side.
    size = [
        2 * float(np.quantile(np.abs(values + 0.5 - at), 0.8)) * cell
        for values, at in zip((rows, columns), middle, strict=True)
    ]
    center = (low + middle * cell).tolist()
    return Container(
        name="inside",
        part=part,
        center_m=(round(center[0], 4), round(center[1], 4), round((bottom + rim) / 2, 4)),
        size_m=(round(size[0], 4), round(size[1], 4), round(rim - bottom, 4)),
    )


def behind_doors(
    supports: Sequence[Support],
    meshes: Mapping[str, MeshData],
    joints: Sequence[Joint],
    joint_of: Mapping[str, str | None],
) -> tuple[tuple[Support, ...], tuple[Container, ...]]:
    """Supports with the container each lies in, and these: spaces with walls on three sides at
    least and something that turns or slides away on a further one."""
    inside: dict[str, list[Support]] = {}
    out: list[Support] = []
    for support in supports:
        door = _door_of(support, meshes, joint_of) if support.headroom_m is not None else None
        if door is None:
            out.append(support)
            continue
        inside.setdefault(door, []).append(support)
    containers = []
    for joint in joints:
        group = inside.get(joint.name)
        if not group:
            continue
        name = f"inside_{joint.name}" if len(inside) > 1 else "inside"
        corners = np.concatenate([np.array(s.polygon_m) for s in group])
        low = np.array([*(corners.min(axis=0) - MARGIN_M), min(s.z_m for s in group)])
        tops = [s.z_m + (s.headroom_m or 0.0) for s in group]
        high = np.array([*(corners.max(axis=0) + MARGIN_M), max(tops)])
        containers.append(
            Container(
                name=name,
                part=group[0].part,
                center_m=_rounded((low + high) / 2),
                size_m=_rounded(high - low),
                closed_by=joint.name,
            )
        )
        out += [s.model_copy(update={"container": name}) for s in group]
    out.sort(key=lambda s: (s.z_m, s.polygon_m))
    return tuple(out), tuple(containers)


def height_map(triangles: Array) -> tuple[Array, Array, float]:
    """Highest surface over a grid of cells (rows along x, columns along y; -inf where none), the
    grid's lower corner (2,), and the cells' side, metres."""
    flat = triangles[:, :, :2]
    low, high = flat.min(axis=(0, 1)), flat.max(axis=(0, 1))
    cell = float((high - low).max()) / _CELLS
    counts = np.maximum(np.ceil((high - low) / cell).astype(int), 1)
    heights = np.full(tuple(counts), -np.inf)
    for corners in triangles:
        first = np.floor((corners[:, :2].min(axis=0) - low) / cell).astype(int)
        last = np.floor((corners[:, :2].max(axis=0) - low) / cell).astype(int)
        first, last = np.clip(first, 0, counts - 1), np.clip(last, 0, counts - 1)
        rows, columns = np.meshgrid(
            np.arange(first[0], last[0] + 1), np.arange(first[1], last[1] + 1), indexing="ij"
        )
        points = low + (np.stack([rows, columns], axis=-1) + 0.5) * cell
        a, b, c = corners
        double = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])
        if abs(double) < 1e-14:
            continue
        x, y = points[..., 0] - a[0], points[..., 1] - a[1]
        v = (x * (c[1] - a[1]) - (c[0] - a[0]) * y) / double
        w = ((b[0] - a[0]) * y - x * (b[1] - a[1])) / double
        hit = (v >= -1e-9) & (w >= -1e-9) & (v + w <= 1 + 1e-9)
        z = a[2] + v * (b[2] - a[2]) + w * (c[2] - a[2])
        at = rows[hit], columns[hit]
        heights[at] = np.maximum(heights[at], z[hit])
    return heights, low, cell


def flooded(heights: Array) -> Array:
    """The level to which water stands on a height map, from whose edge it runs off."""
    rows, columns = heights.shape
    level = np.full_like(heights, np.inf)
    queue: list[tuple[float, int, int]] = []
    for i in range(rows):
        for j in range(columns):
            if i in (0, rows - 1) or j in (0, columns - 1) or heights[i, j] == -np.inf:
                level[i, j] = heights[i, j]
                queue.append((float(heights[i, j]), i, j))
    heapq.heapify(queue)
    while queue:
        height, i, j = heapq.heappop(queue)
        for u, v in ((i - 1, j), (i + 1, j), (i, j - 1), (i, j + 1)):
            if 0 <= u < rows and 0 <= v < columns and level[u, v] == np.inf:
                level[u, v] = max(float(heights[u, v]), height)
                heapq.heappush(queue, (float(level[u, v]), u, v))
    return level


def _under(given: Box, triangles: Array, part: str) -> Support | None:
    """The surface on which a receptacle box of the source lies."""
    low = given.center_m - given.size_m / 2
    high = given.center_m + given.size_m / 2
    polygon = box(*low[:2], *high[:2]).buffer(-MARGIN_M, join_style="mitre")
    if polygon.is_empty or not np.isfinite([*low, *high]).all():
        return None
    levels = np.arange(-_NEAR_M, _NEAR_M + 1e-9, 0.005)
    shares = [carried_share(triangles, polygon, float(low[2] + step)) for step in levels]
    best = int(np.argmax([share - 0.2 * abs(s) for share, s in zip(shares, levels, strict=True)]))
    if shares[best] < 0.3:
        return None
    near = triangles[:, :, 2]
    z = float(low[2] + levels[best])
    at = near[(np.abs(near - z) < 0.01).all(axis=1)]
    z = float(np.median(at)) if len(at) else z
    free = headroom_m(triangles, polygon, z)
    corners = np.round(np.array(polygon.exterior.coords)[:-1], 4)
    return Support(
        name="",
        part=part,
        z_m=round(z, 4),
        polygon_m=tuple((float(x), float(y)) for x, y in corners),
        headroom_m=None if free is None else round(free, 4),
    )


def _under_drawers(support: Support, moving: Sequence[Array]) -> Support | None:
    """The surface with the room that drawers, whose corners are in ``moving``, leave over it; None
    when that is too little."""
    polygon = Polygon(support.polygon_m)
    room = math.inf if support.headroom_m is None else support.headroom_m
    for points in moving:
        low, high = points.min(axis=0), points.max(axis=0)
        over = high[2] > support.z_m + _TOUCH_M and low[2] < support.z_m + room
        if over and box(*low[:2], *high[:2]).intersection(polygon).area > 0.5 * polygon.area:
            room = float(low[2]) - support.z_m
    if room < _ROOM_M:
        return None
    return support.model_copy(update={"headroom_m": None if room == math.inf else round(room, 4)})


def _same(one: Support, other: Support) -> bool:
    """True when two supports are one surface."""
    if abs(one.z_m - other.z_m) > 0.02:
        return False
    a, b = Polygon(one.polygon_m), Polygon(other.polygon_m)
    return bool(a.intersection(b).area > 0.5 * min(a.area, b.area))


def _door_of(
    support: Support, meshes: Mapping[str, MeshData], joint_of: Mapping[str, str | None]
) -> str | None:
    """The joint of the part that shuts the space over a surface; None for an open one."""
    polygon = Polygon(support.polygon_m)
    middle = polygon.representative_point()
    height = support.z_m + min(0.5 * (support.headroom_m or 0.0), 0.2)
    x0, y0, x1, y1 = polygon.bounds
    reach = {(1, 0): x1 - middle.x, (-1, 0): middle.x - x0, (0, 1): y1 - middle.y}
    reach[(0, -1)] = middle.y - y0
    walls, doors = 0, []
    for direction, far in reach.items():
        towards = np.array([*direction, 0.0])
        start = np.array([middle.x, middle.y, height])
        hits = {}
        for part, mesh in meshes.items():
            at = _first_hit(mesh.vertices[mesh.faces], start, towards)
            if at is not None and at <= far + _WALL_M:
                hits[part] = at
        if not hits:
            continue
        nearest = joint_of[min(hits, key=lambda name: hits[name])]
        if nearest is None:
            walls += 1
        else:
            doors.append(nearest)
    return doors[0] if walls >= 2 and doors else None


def _first_hit(triangles: Array, start: Array, towards: Array) -> float | None:
    """How far a ray goes (Moeller and Trumbore, 1997); None when it meets nothing."""
    a = triangles[:, 0]
    e1, e2 = triangles[:, 1] - a, triangles[:, 2] - a
    p = np.cross(towards, e2)
    det = np.einsum("ij,ij->i", e1, p)
    safe = np.where(np.abs(det) < 1e-15, 1.0, det)
    t = start - a
    u = np.einsum("ij,ij->i", t, p) / safe
    q = np.cross(t, e1)
    v = (q @ towards) / safe
    at = np.einsum("ij,ij->i", e2, q) / safe
    hit = (np.abs(det) >= 1e-15) & (u >= 0) & (v >= 0) & (u + v <= 1) & (at > 1e-6)
    return float(at[hit].min()) if hit.any() else None


def _largest(cells: npt.NDArray[np.bool_]) -> npt.NDArray[np.bool_]:
    """The largest region of cells that touch."""
    from scipy import ndimage

    labels, count = ndimage.label(cells)
    if count == 0:
        return np.zeros_like(cells)
    sizes = np.bincount(labels.ravel())[1:]
    return np.asarray(labels == int(np.argmax(sizes)) + 1)


def _rounded(values: Array) -> tuple[float, float, float]:
    x, y, z = (round(float(v), 4) for v in values)
    return (x, y, z)
