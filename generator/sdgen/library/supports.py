"""Finds on a mesh where things can stand, and how much room is above it.

The way of Holodeck and of ProcTHOR's receptacles: faces that look up, grouped by height, united to
polygons, with the headroom found by rays. Done once, when a model enters a library.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
import shapely
from shapely.geometry import MultiPolygon, Point, Polygon

from sdgen.geometry import Array
from sdgen.library.meshes import MeshData
from sdgen.library.records import Support
from sdgen.library.shape import corners_of

#: A face looks up when its normal is within 10 degrees of it.
_UP = float(np.cos(np.radians(10)))
#: Faces this close in height are one surface; stored polygons are drawn in by the margin.
LEVEL_M, MARGIN_M = 0.01, 0.01
_LEAST_AREA_M2, _LEAST_WIDTH_M, _LEAST_HEADROOM_M = 0.004, 0.04, 0.05
#: Rays along each side of a surface: 81 in all.
_PROBES = 9


def find_supports(meshes: Mapping[str, MeshData]) -> tuple[Support, ...]:
    """Level surfaces of at least 40 cm² and 4 cm width with 5 cm of headroom, lowest first.

    ``meshes`` are the drawn parts by name, joints at 0. Headroom counts every part.
    """
    everything = corners_of(list(meshes.values()))
    out: list[Support] = []
    for part, mesh in meshes.items():
        for level, polygon in _level_polygons(mesh.vertices[mesh.faces]):
            free = headroom_m(everything, polygon, level)
            if free is not None and free < _LEAST_HEADROOM_M:
                continue
            corners = np.round(np.array(polygon.exterior.coords)[:-1], 4)
            out.append(
                Support(
                    name="",
                    part=part,
                    z_m=round(level, 4),
                    polygon_m=tuple((float(x), float(y)) for x, y in corners),
                    headroom_m=None if free is None else round(free, 4),
                )
            )
    out.sort(key=lambda s: (s.z_m, s.part, s.polygon_m))
    return tuple(s.model_copy(update={"name": f"surface_{k}"}) for k, s in enumerate(out, 1))


def headroom_m(triangles: Array, polygon: Polygon, z_m: float) -> float | None:
    """Free height over ``polygon`` at ``z_m``, the least but for a tenth of it; None if open.

    ``triangles`` (N, 3, 3) are all that could be above.
    """
    found = sorted(h - z_m for h in _first_above(triangles, _probes(polygon), z_m + LEVEL_M))
    value = found[len(found) // 10] if found else np.inf
    return None if np.isinf(value) else float(value)


def carried_share(triangles: Array, polygon: Polygon, z_m: float) -> float:
    """Share of ``polygon`` at ``z_m`` with a surface within a centimetre below or above it."""
    probes = _probes(polygon)
    near = triangles[
        (triangles[:, :, 2].min(axis=1) < z_m + LEVEL_M)
        & (triangles[:, :, 2].max(axis=1) > z_m - LEVEL_M)
    ]
    below = _first_above(near, probes, z_m - LEVEL_M)
    return float(np.mean([h < z_m + LEVEL_M for h in below]))


def _level_polygons(triangles: Array) -> list[tuple[float, Polygon]]:
    """Surfaces of one part: height and outline, drawn in by the margin."""
    normals = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    length = np.linalg.norm(normals, axis=1)
    level = triangles[(normals[:, 2] > _UP * length) & (length > 1e-12)]
    if len(level) == 0:
        return []
    height = level[:, :, 2].mean(axis=1)
    order = np.argsort(height, kind="stable")
    groups = np.split(order, np.flatnonzero(np.diff(height[order]) > LEVEL_M) + 1)
    out = []
    for group in groups:
        flat = [Polygon(t) for t in level[group][:, :, :2]]
        # Neighbours share edges only up to rounding.
        united = shapely.union_all([p.buffer(1e-4, join_style="mitre") for p in flat if p.area > 0])
        usable = united.buffer(-MARGIN_M, join_style="mitre").simplify(0.002)
        pieces = usable.geoms if isinstance(usable, MultiPolygon) else [usable]
        weights = np.array([p.area for p in flat])
        z = float(np.average(height[group], weights=weights + 1e-12))
        for piece in pieces:
            wide = not piece.buffer(-_LEAST_WIDTH_M / 2).is_empty
            if isinstance(piece, Polygon) and piece.area >= _LEAST_AREA_M2 and wide:
                out.append((z, Polygon(piece.exterior)))
    return out


def _probes(polygon: Polygon) -> Array:
    """Points (N, 2) on a grid inside the polygon; at least one."""
    x0, y0, x1, y1 = polygon.bounds
    fractions = (np.arange(_PROBES) + 0.5) / _PROBES
    grid = [(x0 + (x1 - x0) * a, y0 + (y1 - y0) * b) for a in fractions for b in fractions]
    inside = [p for p in grid if polygon.contains(Point(p))]
    middle = polygon.representative_point()
    return np.array(inside or [(middle.x, middle.y)])


def _first_above(triangles: Array, probes: Array, z_m: float) -> list[float]:
    """Height of the lowest triangle above ``z_m`` over each probe (N, 2); inf where none is."""
    out = []
    a, b, c = triangles[:, 0, :2], triangles[:, 1, :2], triangles[:, 2, :2]
    double = (b[:, 0] - a[:, 0]) * (c[:, 1] - a[:, 1]) - (b[:, 1] - a[:, 1]) * (c[:, 0] - a[:, 0])
    usable = np.abs(double) > 1e-12
    a, b, c, double, z = a[usable], b[usable], c[usable], double[usable], triangles[usable][..., 2]
    for x, y in probes:
        first = ((b[:, 0] - x) * (c[:, 1] - y) - (b[:, 1] - y) * (c[:, 0] - x)) / double
        second = ((c[:, 0] - x) * (a[:, 1] - y) - (c[:, 1] - y) * (a[:, 0] - x)) / double
        third = 1 - first - second
        hit = (first >= 0) & (second >= 0) & (third >= 0)
        heights = (first * z[:, 0] + second * z[:, 1] + third * z[:, 2])[hit]
        above = heights[heights > z_m]
        out.append(float(above.min()) if len(above) else float("inf"))
    return out
