"""Collision pieces that reach as far as what is drawn."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import numpy as np
import numpy.typing as npt
import shapely
from shapely.geometry import Polygon

from sdgen.geometry import Array
from sdgen.library.meshes import Hull, MeshData
from sdgen.library.outlines import joined
from sdgen.library.records import Asset, Support

#: So far a mesh may stand out of its pieces, metres: less than shows where things touch.
STANDS_OUT_M = 0.002
#: What stands out further is a piece of its own: a handle, a strap. Drawing the next piece out to
#: it would fill all that is between.
OWN_PIECE_M = 0.015
#: Feet are no longer than this, metres: rings under bowls, studs under trays. Legs have pieces.
FOOT_M = 0.03
#: A support this far above a piece is that of a cushion or a quilt on it, metres (shipped:
#: up to 0.04 m); further off, it is another shelf.
CUSHION_M = 0.045
#: So much of a support lies under a piece that is all over it: corners are thinned out.
COVERED = 0.9
#: Corners this near the highest one make a piece's top.
FLAT_TOP_M = 0.001
#: A piece this near to a support carries it, metres: both are written with four digits.
AS_IT_IS_M = 1e-4
#: Directions (N, 3) a piece's reach is measured in; on a ball of radius r it is known to 0.01 r.
_DIRECTIONS = 162


def reaching_meshes(
    hulls: Sequence[Hull], meshes: Mapping[str, MeshData], asset: Asset
) -> tuple[Hull, ...]:
    """The pieces, drawn out to what stands a little out of all of them, and more for the rest.

    Pieces cut an apple's cheeks and a board's handle off: the one sank 7 mm into the table, the
    other stuck in the wall. Of models that things stand on or in only the feet are reached for: a
    piece drawn out to the rim of a tray would lift what lies on it; but a piece just below or all
    over a support is brought to it, and a support far above all pieces gets one. Parts without any
    piece stay without: flames, steam; those whose pieces are ``complete`` stay as they are.
    """
    stood_on = bool(asset.supports or asset.containers)
    out = [_level_with_supports(hull, asset) for hull in hulls] if stood_on else list(hulls)
    lowest = min(float(hull.vertices_m[:, 2].min()) for hull in hulls)
    for part in dict.fromkeys(hull.part for hull in hulls):
        if any(hull.complete for hull in hulls if hull.part == part):
            continue
        feet = meshes[part].vertices[:, 2] < lowest - STANDS_OUT_M
        if stood_on and not feet.any():
            continue
        mine = [k for k, hull in enumerate(hulls) if hull.part == part]
        corners, same = np.unique(meshes[part].vertices, axis=0, return_inverse=True)
        beyond = np.array([_beyond(corners, hulls[k].vertices_m) for k in mine])
        nearest, least = beyond.argmin(axis=0), beyond.min(axis=0)
        near = (least > STANDS_OUT_M) & (least <= (FOOT_M if stood_on else OWN_PIECE_M))
        if stood_on:
            near &= corners[:, 2] < lowest - STANDS_OUT_M
        for place, k in enumerate(mine):
            added = corners[near & (nearest == place)]
            if len(added):
                out[k] = Hull(part, np.concatenate([out[k].vertices_m, _outer(added)]))
        if not stood_on:
            faces = same.reshape(-1)[meshes[part].faces]
            out += [Hull(part, points) for points in _own(corners, faces, least)]
    return (*out, *_cushions(out, asset))


def _level_with_supports(hull: Hull, asset: Asset) -> Hull:
    """The piece with its level top brought to the support that lies a little above it, or a little
    below all of it: what is put there stands on what is drawn."""
    if hull.complete:
        return hull
    points = hull.vertices_m
    top, level = _level_top(hull)
    own = [s for s in asset.supports if s.part == hull.part and _meets(points[level], s)]
    rises = {s.z_m: s.z_m - top for s in own if abs(s.z_m - top) <= OWN_PIECE_M}
    if any(abs(rise) <= AS_IT_IS_M for rise in rises.values()):
        return hull  # it carries one as it is
    for support in own:
        # The rim of a tray stands beside the support: only a top that lies all over it is lowered.
        rise = rises.get(support.z_m)
        if rise is not None and (rise > 0.0 or _covers(points[level], support)):
            moved = points.copy()
            moved[level, 2] = support.z_m
            return Hull(hull.part, moved, hull.complete)
    return hull


def _cushions(hulls: Sequence[Hull], asset: Asset) -> Iterator[Hull]:
    """A piece for each support that lies on what no piece reaches: a cushion, a folded quilt."""
    tops = [(*_level_top(hull), hull.vertices_m) for hull in hulls]
    for support in asset.supports:
        under = [
            (top, points[level])
            for top, level, points in tops
            if support.z_m - CUSHION_M <= top <= support.z_m + OWN_PIECE_M
            and _meets(points[level], support)
        ]
        highest = max((top for top, _ in under), default=np.inf)
        if highest < support.z_m - OWN_PIECE_M and any(_covers(p, support) for _, p in under):
            ring = np.array(support.polygon_m)
            ends = [np.column_stack([ring, np.full(len(ring), z)]) for z in (highest, support.z_m)]
            yield Hull(support.part, np.concatenate(ends))


def _level_top(hull: Hull) -> tuple[float, npt.NDArray[np.bool_]]:
    """How high a piece is, and which of its corners (N,) are its level top."""
    z = hull.vertices_m[:, 2]
    return float(z.max()), z > z.max() - FLAT_TOP_M


def _meets(points: Array, support: Support) -> bool:
    """Whether the box of points (N, 3), seen from above, shares something with a support's."""
    low, high = points[:, :2].min(axis=0), points[:, :2].max(axis=0)
    ring = np.array(support.polygon_m)
    return bool((high > ring.min(axis=0)).all() and (low < ring.max(axis=0)).all())


def _covers(points: Array, support: Support) -> bool:
    """Whether the hull of points (N, 3), seen from above, covers nearly all of a support."""
    shape = shapely.convex_hull(shapely.multipoints(points[:, :2]))
    return bool(shape.intersection(Polygon(support.polygon_m)).area >= COVERED * support.area_m2)


def _beyond(points: Array, piece: Array) -> Array:
    """How far (N,) points (N, 3) stand out of the hull of a piece; negative inside."""
    reach = (piece @ _spread().T).max(axis=0)
    return np.asarray((points @ _spread().T - reach).max(axis=1), dtype=np.float64)


def _own(corners: Array, faces: npt.NDArray[np.int64], beyond: Array) -> Iterator[Array]:
    """The outermost corners of each patch of faces that stands far out of all pieces."""
    far = faces[(beyond[faces] > OWN_PIECE_M).any(axis=1)]
    used, local = np.unique(far, return_inverse=True)
    if not len(used):
        return
    patch = joined(local.reshape(far.shape), len(used))
    for k in range(patch.max() + 1):
        points = _outer(corners[used[patch == k]])
        if len(points) >= 4 and np.linalg.matrix_rank(points - points[0], tol=1e-4) == 3:
            yield points


def _outer(points: Array) -> Array:
    """Those of the points that are outermost in some direction: no more than a hull needs."""
    found: Array = points[np.unique((points @ _spread().T).argmax(axis=0))]
    return found


def _spread() -> Array:
    """Directions on a Fibonacci lattice, and the axes."""
    k = np.arange(_DIRECTIONS) + 0.5
    z = 1 - 2 * k / _DIRECTIONS
    turn = np.pi * (1 + 5**0.5) * k
    flat = np.sqrt(1 - z * z)
    spread = np.stack([flat * np.cos(turn), flat * np.sin(turn), z], axis=1)
    return np.concatenate([spread, np.eye(3), -np.eye(3)])
