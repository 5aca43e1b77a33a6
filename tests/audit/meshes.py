"""Triangles of GLB files, and measures on them."""

from __future__ import annotations

import json
import struct
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np
import numpy.typing as npt
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree
from trimesh.triangles import closest_point

Floats = npt.NDArray[np.float64]
Ints = npt.NDArray[np.int64]
Bools = npt.NDArray[np.bool_]

#: Distance of samples on a surface, metres: on things, and on what is larger than 0.3 m.
FINE_M, COARSE_M = 0.01, 0.03
#: Pieces whose surfaces come this near belong together, metres.
TOUCHING_M = 0.004

_TYPES = {5120: "i1", 5121: "u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
_WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}


@dataclass(frozen=True)
class Mesh:
    """Vertices (V, 3) in metres, Z up, and faces (F, 3), outward by the right-hand rule."""

    vertices: Floats
    faces: Ints

    @cached_property
    def corners(self) -> Floats:
        """(F, 3, 3) the corners of the faces that have an area."""
        corners = self.vertices[self.faces]
        sides = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        return corners[np.linalg.norm(sides, axis=1) > 1e-10]

    @cached_property
    def samples(self) -> tuple[Floats, Floats]:
        """Points spread over the surface (N, 3) and the outward normals there (N, 3)."""
        corners = self.vertices[self.faces]
        size = float(np.ptp(self.vertices, axis=0).max())
        return spread(corners, FINE_M if size <= 0.3 else COARSE_M)

    @cached_property
    def tree(self) -> cKDTree:
        return cKDTree(self.samples[0])

    @cached_property
    def pieces(self) -> list[Ints]:
        """The faces of each piece that hangs together."""
        _, same = np.unique(np.round(self.vertices, 5), axis=0, return_inverse=True)
        joined = same.reshape(-1)[self.faces]
        rows = np.concatenate([joined[:, 0], joined[:, 1]])
        columns = np.concatenate([joined[:, 1], joined[:, 2]])
        n = int(joined.max()) + 1
        graph = coo_matrix((np.ones(len(rows)), (rows, columns)), shape=(n, n))
        _, piece = connected_components(graph, directed=False)
        of_face = piece[joined[:, 0]]
        return [np.flatnonzero(of_face == k) for k in np.unique(of_face)]

    @cached_property
    def clusters(self) -> list[Ints]:
        """The faces of pieces that touch one another: a handle is on the shard it belongs to."""
        pieces = self.pieces
        if len(pieces) < 2:
            return pieces
        points = [spread(self.vertices[self.faces[f]], TOUCHING_M)[0] for f in pieces]
        owner = np.concatenate([np.full(len(p), k) for k, p in enumerate(points)])
        pairs = cKDTree(np.concatenate(points)).query_pairs(TOUCHING_M, output_type="ndarray")
        rows, columns = owner[pairs[:, 0]], owner[pairs[:, 1]]
        shape = (len(pieces), len(pieces))
        graph = coo_matrix((np.ones(len(rows)), (rows, columns)), shape=shape)
        _, cluster = connected_components(graph, directed=False)
        return [
            np.concatenate([pieces[k] for k in np.flatnonzero(cluster == c)])
            for c in np.unique(cluster)
        ]


def spread(corners: Floats, spacing: float) -> tuple[Floats, Floats]:
    """Points on triangles (F, 3, 3) at about ``spacing`` metres, with their normals."""
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    lengths = np.linalg.norm(normals, axis=1)
    keep = lengths > 1e-12
    corners, normals = corners[keep], normals[keep] / lengths[keep, None]
    longest = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2).max(1)
    many = np.ceil(np.maximum(lengths[keep] / spacing**2, longest / spacing)).astype(int)
    face = np.repeat(np.arange(len(many)), many)
    k = np.arange(len(face)) - np.repeat(np.cumsum(many) - many, many)
    # Roberts' R2 sequence covers the unit square evenly; what is beyond the diagonal folds back.
    s, t = (0.5 + k * 0.7548776662466927) % 1, (0.5 + k * 0.5698402909980532) % 1
    s, t = np.where(s + t > 1, 1 - s, s), np.where(s + t > 1, 1 - t, t)
    weights = np.stack([1 - s - t, s, t], axis=1)
    return np.einsum("kc,kcd->kd", weights, corners[face]), normals[face]


def join(meshes: list[Mesh]) -> Mesh:
    starts = np.cumsum([0] + [len(mesh.vertices) for mesh in meshes])
    faces = [mesh.faces + start for mesh, start in zip(meshes, starts, strict=False)]
    return Mesh(np.concatenate([mesh.vertices for mesh in meshes]), np.concatenate(faces))


def read_glb(path: Path) -> dict[str, Mesh]:
    """The mesh of each node of a GLB by its name; glTF's Y up becomes our Z up."""
    data = path.read_bytes()
    (length,) = struct.unpack_from("<I", data, 12)
    header = json.loads(data[20 : 20 + length])
    binary = data[28 + length :]

    def read(index: int) -> npt.NDArray[np.generic]:
        accessor = header["accessors"][index]
        view = header["bufferViews"][accessor["bufferView"]]
        kind, width = np.dtype(_TYPES[accessor["componentType"]]), _WIDTHS[accessor["type"]]
        stride = view.get("byteStride", kind.itemsize * width)
        start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        return np.ndarray(
            (accessor["count"], width), kind, binary, start, (stride, kind.itemsize)
        ).copy()

    meshes = {}
    for node in header["nodes"]:
        if "mesh" not in node:
            continue
        vertices, faces, so_far = [], [], 0
        for primitive in header["meshes"][node["mesh"]]["primitives"]:
            points = read(primitive["attributes"]["POSITION"]).astype(float)
            points = points * node.get("scale", [1, 1, 1]) + node.get("translation", [0, 0, 0])
            vertices.append(np.stack([points[:, 0], -points[:, 2], points[:, 1]], axis=1))
            faces.append(read(primitive["indices"]).astype(np.int64).reshape(-1, 3) + so_far)
            so_far += len(points)
        meshes[node["name"]] = Mesh(np.concatenate(vertices), np.concatenate(faces))
    return meshes


def winding(points: Floats, triangles: Floats) -> Floats:
    """How often a surface (F, 3, 3) goes round each point: 1 within a closed one, 0 without."""
    a, b, c = (triangles[None, :, k] - points[:, None] for k in range(3))
    la, lb, lc = (np.linalg.norm(v, axis=2) for v in (a, b, c))
    top = np.einsum("pfd,pfd->pf", a, np.cross(b, c))
    dots = [np.einsum("pfd,pfd->pf", u, v) for u, v in ((a, b), (b, c), (c, a))]
    bottom = la * lb * lc + dots[0] * lc + dots[1] * la + dots[2] * lb
    return np.asarray(np.arctan2(top, bottom).sum(1) / (2 * np.pi))


def distances(points: Floats, triangles: Floats) -> Floats:
    """From each point to the nearest of the triangles, metres."""
    pairs = np.repeat(points, len(triangles), axis=0)
    nearest = closest_point(np.tile(triangles, (len(points), 1, 1)), pairs)
    return np.asarray(np.linalg.norm(nearest - pairs, axis=1).reshape(len(points), -1).min(1))


def depths(points: Floats, mesh: Mesh, least: float) -> Floats:
    """How deep points (in the mesh's frame) lie within it, metres; 0 for less than ``least``.

    Samples near each point say which may be deep; of these, winding number and distance decide.
    """
    deep = np.zeros(len(points))
    samples, normals = mesh.samples
    far, index = mesh.tree.query(points, min(6, len(samples)))
    below = -np.einsum("pkd,pkd->pk", points[:, None] - samples[index], normals[index])
    # The nearest sample says on which side a point is; the flattest of a few, how deep at most.
    depth = np.minimum(np.abs(below).min(1), far[:, 0])
    suspects = np.flatnonzero((below[:, 0] > 0) & (depth > 0.6 * least))
    if len(suspects) > 24:
        suspects = suspects[np.argsort(-depth[suspects], kind="stable")[:24]]
    if len(suspects):
        triangles = mesh.corners
        # Exactly 1 within what is closed; a pile without an underside has 0.5 at its border.
        inside = winding(points[suspects], triangles) > 0.8
        if inside.any():
            depth = distances(points[suspects][inside], triangles)
            deep[suspects[inside]] = np.where(depth > least, depth, 0)
    return deep


def drop(points: Floats, triangles: Floats, slack: float = 0.003) -> Floats:
    """How high each point is over the highest triangle below it, metres.

    A triangle up to ``slack`` above a point counts as touched; infinite where nothing is below.
    """
    if not len(points) or not len(triangles):
        return np.full(len(points), np.inf)
    a = triangles[:, 0]
    u, v = triangles[:, 1, :2] - a[:, :2], triangles[:, 2, :2] - a[:, :2]
    area = u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]
    flat = np.abs(area) > 1e-12
    rise = (triangles[:, 1:, 2] - a[:, None, 2])[flat]
    a, u, v, area = a[flat], u[flat], v[flat], area[flat]
    w = points[:, None, :2] - a[None, :, :2]
    s = (w[..., 0] * v[:, 1] - w[..., 1] * v[:, 0]) / area
    t = (u[:, 0] * w[..., 1] - u[:, 1] * w[..., 0]) / area
    within = (s >= -1e-9) & (t >= -1e-9) & (s + t <= 1 + 1e-9)
    gap = points[:, None, 2] - (a[:, 2] + s * rise[:, 0] + t * rise[:, 1])
    gap = np.where(within & (gap >= -slack), np.maximum(gap, 0), np.inf)
    return np.asarray(gap.min(1, initial=np.inf))
