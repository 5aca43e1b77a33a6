"""Where things lie on seats and mattresses: on what is drawn of them, which bulges.

A support is one level of one outline. Where the cushion under it bulges by more than is seen where
a thing lies, the support is laid anew: at the level, and on the rectangles, that share most of its
area with what is drawn there. Sofas so get one for each cushion. No Blender needed.
"""

from __future__ import annotations

import numpy as np
import shapely
from shapely.geometry import Polygon, box

#: What is padded; of other furniture the tops are level, or meant as they are (grates, slats).
SOFT = (
    *("armchair", "bar_stool", "bench", "chair", "office_chair", "ottoman", "sofa"),
    *("bed", "child_bed", "crib", "shoe_rack", "stool"),
)
#: What is drawn may be so much below a support and above it, metres: a gap of a centimetre is seen
#: (tests/audit), a cushion gives way by half of that.
BELOW_M, ABOVE_M = 0.0085, 0.0025
#: The piece that carries follows what bulges, and stays so much over it, metres: a small thing at
#: the edge of a cushion then lies as near to it as in its middle, and nothing rolls off.
LIFT_M = 0.003
#: What was laid is not laid again: cells then lie elsewhere, metres.
SLACK_M = 0.0005
#: Levels tried, and cells looked at, metres.
STEP_M, CELL_M = 0.0005, 0.01
#: Back cushions hang over the seat: what is drawn up to here is in the way of things on it.
HEADROOM_M = 0.5
#: Gaps between cushions are this deep, at most; where nothing is drawn above, there is no seat.
DEEP_M = 0.06
#: Round outlines are tried drawn in by so much, metres.
INWARD_M = (0.0, 0.01, 0.02, 0.03, 0.04)
#: Corners this near the highest one make a piece's top; it carries what lies on it with so much of
#: its area; heights are looked at in steps, metres.
LEVEL_M, CARRIED, SAMPLE_M = 0.001, 0.8, 0.015
#: Where its corners are thinned, heights count so much more than what is seen from above.
STEEP = 5.0
#: Another rectangle is worth having with this share of the first one's area; none is narrower.
SHARE, NARROW_M = 0.35, 0.12
#: A sofa has three cushions; what needs more rectangles is tufted, and lies better on one.
MOST = 3


def is_padded(category: str, support: dict) -> bool:
    """Whether a support (as the manifest has it) is one of a cushion or a mattress."""
    roomy = (support["headroom_m"] or np.inf) >= HEADROOM_M
    return category in SOFT and support["container"] is None and roomy


def heights(triangles: np.ndarray, points: np.ndarray, low: float, high: float) -> np.ndarray:
    """The height of the highest triangle (N, 3, 3) between two heights at each point (P, 2); -inf
    where there is none."""
    a = triangles[:, 0]
    u, v = triangles[:, 1, :2] - a[:, :2], triangles[:, 2, :2] - a[:, :2]
    area = u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]
    flat = np.abs(area) > 1e-12
    a, u, v, area, rise = a[flat], u[flat], v[flat], area[flat], triangles[flat, 1:, 2]
    out = np.full(len(points), -np.inf)
    for k, point in enumerate(points):
        w = point - a[:, :2]
        s = (w[:, 0] * v[:, 1] - w[:, 1] * v[:, 0]) / area
        t = (u[:, 0] * w[:, 1] - u[:, 1] * w[:, 0]) / area
        z = a[:, 2] + s * (rise[:, 0] - a[:, 2]) + t * (rise[:, 1] - a[:, 2])
        hit = (s >= -1e-9) & (t >= -1e-9) & (s + t <= 1 + 1e-9) & (z > low) & (z < high)
        out[k] = z[hit].max(initial=-np.inf)
    return out


def largest_rectangle(mask: np.ndarray) -> tuple[int, int, int, int]:
    """Rows and columns (first, last + 1 of both) of the largest rectangle of a mask that is all
    true and nowhere narrower than ``NARROW_M``; empty where there is none."""
    best, found = 0, (0, 0, 0, 0)
    least = round(NARROW_M / CELL_M)
    runs = np.zeros(mask.shape[1], dtype=int)
    for row in range(len(mask)):
        runs = np.where(mask[row], runs + 1, 0)
        stack: list[tuple[int, int]] = []
        for column, run in enumerate([*runs.tolist(), 0]):
            start = column
            while stack and stack[-1][1] >= run:
                start, high = stack.pop()
                wide = column - start
                if high * wide > best and min(high, wide) >= least:
                    best, found = high * wide, (row + 1 - high, row + 1, start, column)
            stack.append((start, run))
    return found


def _rectangles(mask: np.ndarray) -> list[tuple[int, int, int, int]]:
    mask, out = mask.copy(), []
    while True:
        r0, r1, c0, c1 = largest_rectangle(mask)
        area = (r1 - r0) * (c1 - c0)
        if not area or (out and area < SHARE * (out[0][1] - out[0][0]) * (out[0][3] - out[0][2])):
            return out
        out.append((r0, r1, c0, c1))
        if len(out) == MOST:
            return out
        mask[r0:r1, c0:c1] = False


def laid(triangles: np.ndarray, support: dict) -> list[dict]:
    """A support (as the manifest has it) as it is, or what takes its place on the drawn triangles
    (N, 3, 3)."""
    shape, z_m = Polygon(support["polygon_m"]), support["z_m"]
    x0, y0, x1, y1 = shape.bounds
    columns, rows = (max(2, round((b - a) / CELL_M)) for a, b in ((x0, x1), (y0, y1)))
    xs, ys = np.linspace(x0, x1, columns + 1), np.linspace(y0, y1, rows + 1)
    grid = np.stack(np.meshgrid(xs, ys), axis=-1)
    within = shapely.intersects_xy(shape.buffer(1e-6), grid[..., 0], grid[..., 1])
    z = np.full(within.shape, np.nan)
    z[within] = heights(triangles, grid[within], z_m - DEEP_M, z_m + HEADROOM_M)
    low, high = z_m - BELOW_M - SLACK_M, z_m + ABOVE_M + SLACK_M
    if (z[within] >= low).all() and (z[within] <= high).all():
        return [support]
    near = z[np.isfinite(z) & (np.abs(z - z_m) < DEEP_M / 2)]
    found: tuple[float, float, float, list[Polygon]] = (0.0, 0.0, z_m, [])
    for level in np.arange(near.min() - ABOVE_M, near.max() + BELOW_M, STEP_M).tolist():
        with np.errstate(invalid="ignore"):
            good = within & (z >= level - BELOW_M) & (z <= level + ABOVE_M)
        ends = [(xs[c0], ys[r0], xs[c1 - 1], ys[r1 - 1]) for r0, r1, c0, c1 in _rectangles(good)]
        shapes = [box(*corners) for corners in ends]
        whole = _drawn_in(shape, grid, within, good)
        if whole is not None and whole.area >= sum(s.area for s in shapes):
            shapes = [whole]
        if shapes:
            area, off = sum(s.area for s in shapes), float(np.abs(z[good] - level).mean())
            # Of levels that share as much, the one nearest to what is drawn.
            found = max(found, (round(area, 3), -round(off, 4), level, shapes), key=lambda f: f[:2])
    return [_named(support, k, found[2], shape) for k, shape in enumerate(found[3])] or [support]


def _drawn_in(
    shape: Polygon, grid: np.ndarray, within: np.ndarray, good: np.ndarray
) -> Polygon | None:
    """The outline drawn in until all of it is good: round seats stay round."""
    for inward in INWARD_M:
        smaller = shape.buffer(-inward, join_style="mitre") if inward else shape
        inside = shapely.intersects_xy(smaller, grid[..., 0], grid[..., 1]) & within
        if inside.any() and good[inside].all() and isinstance(smaller, Polygon):
            return smaller
    return None


def capped(triangles: np.ndarray, points: np.ndarray, supports: list[dict]) -> list[np.ndarray]:
    """Convex pieces in place of one (its corners, (N, 3)) whose top carries padded supports: flat
    where the drawn triangles (M, 3, 3) are nearly as high as the support, falling with them at its
    edges. One for each support; the piece itself where it carries none."""
    top = float(points[:, 2].max())
    level = points[points[:, 2] > top - LEVEL_M]
    outline = shapely.convex_hull(shapely.multipoints(level[:, :2]))
    own = []
    for support in supports:
        shape = Polygon(support["polygon_m"])
        if abs(support["z_m"] - top) < DEEP_M / 2:
            own += [support] * bool(outline.intersection(shape).area > CARRIED * shape.area)
    if not own:
        return [points]
    x0, y0, x1, y1 = outline.bounds
    xs, ys = (
        np.linspace(a, b, max(2, round((b - a) / SAMPLE_M)) + 1) for a, b in ((x0, x1), (y0, y1))
    )
    grid = np.stack(np.meshgrid(xs, ys), axis=-1).reshape(-1, 2)
    ring = np.array(outline.exterior.coords)[:-1]
    spots = np.concatenate([grid[shapely.intersects_xy(outline, grid[:, 0], grid[:, 1])], ring])
    shapes = [Polygon(s["polygon_m"]) for s in own]
    nearest = np.argmin([shapely.distance(s, shapely.points(spots)) for s in shapes], axis=0)
    out = []
    for k, support in enumerate(own):
        mine, z_m = spots[nearest == k], support["z_m"]
        z = heights(triangles, mine, z_m - DEEP_M, z_m + DEEP_M / 2)
        drawn = np.isfinite(z)
        within = shapely.intersects_xy(shapes[k], mine[:, 0], mine[:, 1]) & drawn
        if len(own) == 1 and (z[within] > z_m - LIFT_M).all():
            return [points]  # as good as level: reading it brings it to the support
        carries = np.column_stack([mine[drawn], np.minimum(z[drawn] + LIFT_M, z_m)])
        under = points[points[:, 2] <= top - LEVEL_M]
        if len(own) > 1:
            under = np.column_stack([mine[drawn], np.full(drawn.sum(), points[:, 2].min())])
        out.append(np.concatenate([carries, under]))
    return out


def _named(support: dict, k: int, z_m: float, shape: Polygon) -> dict:
    ring = np.round(np.array(shape.normalize().exterior.coords)[:-1], 4)[::-1] + 0.0
    name = f"{support['name']}_{k + 1}" if k else support["name"]
    return support | {"name": name, "z_m": round(z_m, 4), "polygon_m": ring.tolist()}
