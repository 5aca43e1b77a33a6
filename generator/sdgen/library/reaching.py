"""Collision pieces that reach as far as what is drawn."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import numpy as np
import numpy.typing as npt

from sdgen.geometry import Array
from sdgen.library.meshes import Hull, MeshData
from sdgen.library.outlines import joined
from sdgen.library.records import Asset

#: So far a mesh may stand out of its pieces, metres: less than shows where things touch.
STANDS_OUT_M = 0.002
#: What stands out further is a piece of its own: a handle, a strap. Drawing the next piece out to
#: it would fill all that is between.
OWN_PIECE_M = 0.015
#: Feet are no longer than this, metres: rings under bowls, studs under trays. Legs have pieces.
FOOT_M = 0.03
#: Corners this near the highest one make a piece's top.
FLAT_TOP_M = 0.001
#: Directions (N, 3) a piece's reach is measured in; on a ball of radius r it is known to 0.01 r.
_DIRECTIONS = 162


def reaching_meshes(
    hulls: Sequence[Hull], meshes: Mapping[str, MeshData], asset: Asset
) -> tuple[Hull, ...]:
    """The pieces, drawn out to what stands a little out of all of them, and more for the rest.

    Pieces cut an apple's cheeks and a board's handle off: the one sank 7 mm into the table, the
    other stuck in the wall. Of models that things stand on or in only the feet are reached for: a
    piece drawn out to the rim of a tray would lift what lies on it; but a piece just below a
    support is raised to it. Parts without any piece stay without: flames, steam; those whose
    pieces are ``complete`` stay as they are.
    """
    stood_on = bool(asset.supports or asset.containers)
    out = [_up_to_supports(hull, asset) for hull in hulls] if stood_on else list(hulls)
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
    return tuple(out)


def _up_to_supports(hull: Hull, asset: Asset) -> Hull:
    """The piece with its level top raised to the support that lies a little above it: what is put
    there stands on what is drawn."""
    if hull.complete:
        return hull
    points = hull.vertices_m
    top = float(points[:, 2].max())
    level = points[:, 2] > top - FLAT_TOP_M
    low, high = points[level, :2].min(axis=0), points[level, :2].max(axis=0)
    for support in asset.supports:
        ring = np.array(support.polygon_m)
        above = 0.0 < support.z_m - top <= OWN_PIECE_M and support.part == hull.part
        if above and (high > ring.min(axis=0)).all() and (low < ring.max(axis=0)).all():
            raised = points.copy()
            raised[level, 2] = support.z_m
            return Hull(hull.part, raised, hull.complete)
    return hull


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
