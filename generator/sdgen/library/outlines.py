"""What a mesh covers, in few points: the outermost ones of every piece of it that lies apart."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt
import shapely

from sdgen.geometry import Array, Vec3, vec3
from sdgen.library.meshes import MeshData

#: The outermost points of one piece, in the object's frame, joints at 0.
Points = tuple[Vec3, ...]

#: Pieces nearer than this from above count as one: leaves and stems of meshes that were made in
#: several shells, which nobody sees apart.
APART_M = 0.002
#: Directions that outermost points are sought in. On a ball of radius r 64 miss at most 0.02 r,
#: and 26 of them 0.06 r: enough for shards and crumbs of a few centimetres.
DIRECTIONS, DIRECTIONS_OF_SEVERAL = 64, 26
#: And so many level ones: most things stand upright, whichever way they are turned, and an arm or
#: a handle is missed between those by 2 cm.
LEVEL = 24

_Labels = npt.NDArray[np.intp]


def outlines_of(mesh: MeshData) -> tuple[Points, ...]:
    """The outline of each piece of a part's mesh that lies apart, seen from above."""
    of_vertex = pieces_of(mesh)
    pieces = [mesh.vertices[of_vertex == piece] for piece in np.unique(of_vertex)]
    directions = DIRECTIONS if len(pieces) == 1 else DIRECTIONS_OF_SEVERAL
    return tuple(sorted(outline(piece, directions) for piece in pieces))


def pieces_of(mesh: MeshData) -> _Labels:
    """The piece (N,) that each vertex of a mesh belongs to.

    What shares corners is of one piece, and so is what overlaps from above: a bulb and its shade.
    """
    # Meshes repeat a corner for every normal and texture coordinate it has.
    corners, same = np.unique(np.round(mesh.vertices, 5), axis=0, return_inverse=True)
    same = same.reshape(-1)
    shells = joined(same[mesh.faces], len(corners))
    return joined_from_above([corners[shells == k] for k in range(shells.max() + 1)])[shells[same]]


def joined_from_above(pieces: Sequence[Array]) -> _Labels:
    """Groups (K,) of pieces, each given as points (N, 3), whose hulls meet from above."""
    if len(pieces) < 2:
        return np.zeros(len(pieces), dtype=np.intp)
    of_point = np.repeat(np.arange(len(pieces)), [max(len(piece), 2) for piece in pieces])
    points = np.concatenate([piece if len(piece) > 1 else piece[[0, 0]] for piece in pieces])
    hulls = shapely.convex_hull(shapely.linestrings(points[:, :2], indices=of_point))
    meeting = shapely.STRtree(hulls).query(hulls, predicate="dwithin", distance=APART_M)
    return joined(meeting.T, len(pieces))


def joined(edges: npt.NDArray[np.int64], count: int) -> _Labels:
    """The connected component (N,) of each of ``count`` nodes, numbered from 0; ``edges`` (M, K)
    are nodes that belong together."""
    label = np.arange(count)
    while True:
        lower = label.copy()
        np.minimum.at(lower, edges, label[edges].min(axis=1, keepdims=True))
        lower = lower[lower]
        if np.array_equal(lower, label):
            return np.unique(label, return_inverse=True)[1].reshape(-1)
        label = lower


def outline(vertices: Array, directions: int = DIRECTIONS) -> Points:
    """Outermost of some points (N, 3) in evenly spread and level directions, along axes and
    diagonals.

    Metres, rounded to 0.1 mm, sorted.
    """
    k = np.arange(directions) + 0.5
    z = 1 - 2 * k / directions
    turn = np.pi * (1 + 5**0.5) * k
    flat = np.sqrt(1 - z * z)
    spread = np.stack([flat * np.cos(turn), flat * np.sin(turn), z], axis=1)
    yaw = np.arange(LEVEL) * 2 * np.pi / LEVEL
    level = np.stack([np.cos(yaw), np.sin(yaw), np.zeros(LEVEL)], axis=1)
    axes = np.concatenate([np.eye(3), -np.eye(3)])
    corners = np.array([(x, y, w) for x in (-1, 1) for y in (-1, 1) for w in (-1, 1)]) / 3**0.5
    outermost = np.argmax(vertices @ np.concatenate([spread, level, axes, corners]).T, axis=0)
    points = {vec3(np.round(vertices[i], 4) + 0.0) for i in outermost.tolist()}
    return tuple(sorted(points))
