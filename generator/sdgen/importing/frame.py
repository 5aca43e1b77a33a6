"""Stands a scan in our frame: Z up, front to +X, origin in the middle of the bottom, metres.

Sources say some of it, a category's usual size tells much of the rest, and what is a guess is told.
"""

from __future__ import annotations

import math

import numpy as np

from sdgen.catalog.records import Catalog, Category
from sdgen.errors import AssetError
from sdgen.geometry import Z_UP_FROM_Y_UP, Array, Vec3, vec3
from sdgen.importing.categorise import Choice, categorise
from sdgen.importing.scan import Scan, Up
from sdgen.importing.sizes import misfit, misfit_as_it_stands
from sdgen.importing.table import Axis, Table

#: What turns an axis of a file up (4x4), by the axis's name.
_UPS: dict[Axis, Array] = {
    "+z": np.eye(4),
    "-z": np.diag([1.0, -1.0, -1.0, 1.0]),
    "+y": Z_UP_FROM_Y_UP,
    "-y": Z_UP_FROM_Y_UP.T,
    "+x": np.array([[0, 0, -1.0, 0], [0, 1, 0, 0], [1, 0, 0, 0], [0, 0, 0, 1]]),
    "-x": np.array([[0, 0, 1.0, 0], [0, 1, 0, 0], [-1, 0, 0, 0], [0, 0, 0, 1]]),
}
#: Which axes may be up, likeliest first, by what a file says.
_AXES: dict[Up, tuple[Axis, ...]] = {"y": ("+y",), "z": ("+z",), "unknown": ("+z", "+y")}
#: Turns about Z that bring an axis to +X, by the axis's name.
_TURNS = {"+x": 0.0, "+y": -math.pi / 2, "-x": math.pi, "-y": math.pi / 2}
#: No thing of a home is longer or shorter than this, metres.
_LONGEST_M, _SHORTEST_M = 8.0, 0.004
#: Less is no thickness that can be drawn, or stood on, metres.
_THINNEST_M = 0.0003
#: The outermost share of a model that is its back or its front.
_SKIN = 0.03


def stand(
    scan: Scan, name: str, table: Table, catalog: Catalog, notes: list[str]
) -> tuple[Scan, Choice]:
    """The scan in our frame, and which category it is; guesses on the way are noted.

    Raises AssetError for a size that no thing of a home has.
    """
    row = table.row(name)
    if row is not None and row.scale is not None:
        scan = scaled(scan, row.scale)
    ups = _AXES[scan.up] if row is None or row.up is None else (row.up,)
    tried = [_chosen(scan.moved(_UPS[up]), name, table, catalog) for up in ups]
    best = min(range(len(tried)), key=lambda k: (tried[k][0], k))
    if ups[best] == "+y" and len(ups) > 1:
        notes.append("Y taken for up: so it has the size of such a thing (a guess)")
    _, scan, choice = tried[best]
    if choice.unit is not None:
        notes.append(f"taken as {choice.unit:g} times as large as its file says: {choice.why}")
        _, scan, choice = _chosen(scaled(scan, choice.unit), name, table, catalog)
    category = None if choice.category is None else catalog.category(choice.category)
    return centred(facing(scan, choice.front, category)), choice


def _chosen(scan: Scan, name: str, table: Table, catalog: Catalog) -> tuple[float, Scan, Choice]:
    size: Vec3 = vec3(scan.extents_m)
    choice = categorise(name, size, table, catalog, scan.words)
    if choice.category is None:
        return math.inf, scan, choice
    return misfit(size, catalog.category(choice.category)), scan, choice


def facing(scan: Scan, front: str | None, category: Category | None) -> Scan:
    """The scan, Z up, with its front to +X: the table's, or by the size and shape of a category."""
    if front is not None:
        return scan.moved(_yaw(_TURNS[front]))
    if category is None:
        return scan
    deep, wide, high = vec3(scan.extents_m)
    turned = misfit_as_it_stands((wide, deep, high), category)
    if turned < misfit_as_it_stands((deep, wide, high), category) - 1e-9:
        scan = scan.moved(_yaw(math.pi / 2))
    return scan.moved(_yaw(math.pi)) if _backwards(scan, category) else scan


def centred(scan: Scan) -> Scan:
    """The scan with the middle of its bottom at the origin. Raises AssetError for a size that no
    thing of a home has."""
    points = scan.triangles.reshape(-1, 3)
    low, high = points.min(axis=0), points.max(axis=0)
    size = high - low
    if not _SHORTEST_M <= size.max() <= _LONGEST_M:
        shown = " x ".join(f"{v:.3g}" for v in size)
        raise AssetError([f"{shown} m: no size of a household thing (a wrong unit?)"])
    if size.min() < _THINNEST_M:
        raise AssetError([f"it is flat: its thinnest side is {1000 * size.min():.2g} mm"])
    shift = np.eye(4)
    shift[:3, 3] = (-(low[0] + high[0]) / 2, -(low[1] + high[1]) / 2, -low[2])
    return scan.moved(shift)


def scaled(scan: Scan, factor: float) -> Scan:
    """The scan, every length times ``factor``."""
    return scan if factor == 1.0 else scan.moved(np.diag([factor, factor, factor, 1.0]))


def _backwards(scan: Scan, category: Category) -> bool:
    """True when the flat or high side, where a piece has its back, is at +X."""
    corners = scan.triangles
    middles = corners.mean(axis=1)
    cross = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    area = np.linalg.norm(cross, axis=1)
    low, high = corners[:, :, 0].min(), corners[:, :, 0].max()
    skin = _SKIN * max(high - low, 1e-6)
    if "SITTABLE" in category.properties:
        top = middles[:, 2] > corners[:, :, 2].max() - 0.2 * np.ptp(corners[:, :, 2])
        return bool((area * middles[:, 0])[top].sum() > 0.02 * (high - low) * area[top].sum())
    if category.kind != "furniture":
        return False
    level = np.abs(cross[:, 0]) > 0.95 * np.maximum(area, 1e-15)
    behind = area[level & (middles[:, 0] < low + skin)].sum()
    before = area[level & (middles[:, 0] > high - skin)].sum()
    return bool(before > 1.15 * behind)


def _yaw(angle_rad: float) -> Array:
    c, s = round(math.cos(angle_rad)), round(math.sin(angle_rad))
    return np.array([[c, -s, 0, 0], [s, c, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]], dtype=np.float64)
