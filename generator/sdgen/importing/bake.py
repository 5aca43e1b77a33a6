"""Gives a light mesh one texture that shows what its source showed.

A source within the budget, of one picture, keeps its texture coordinates, and the picture is made
smaller. Any other (thinned, of several pictures or none, of repeated pictures or coloured vertices)
is unwrapped anew by xatlas, and every texel takes the colour of the source's surface nearest to it
that looks the same way.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from sdgen.geometry import Array
from sdgen.importing.pictures import opened
from sdgen.importing.scan import Ints, Piece
from sdgen.importing.simplify import Solid, corner_normals, welded
from sdgen.library.meshes import MeshData
from sdgen.library.shape import surface_points

Pixels = npt.NDArray[np.uint8]

#: Points on the source's surface among which the nearest is looked for.
_SAMPLES = 300_000
#: Surfaces that look the other way count as this share of the diagonal further off, twice over: the
#: two sides of a mug's wall.
_FACING = 0.03
#: Texels between islands, and how much finer the source is read than the texture.
_PADDING, _FINER = 3, 2
#: Texture coordinates this far outside are rounding.
_OUTSIDE = 0.02


@dataclass(frozen=True)
class Baked:
    """Meshes by part, and the one texture of them all (H, W, 3)."""

    meshes: Mapping[str, MeshData]
    texture: Pixels


def kept(parts: Mapping[str, Sequence[Piece]], doubled: bool, side: int) -> Baked | None:
    """The pieces with their own texture coordinates; None where these cannot be kept."""
    pieces = [piece for group in parts.values() for piece in group]
    image = pieces[0].paint.image
    for piece in pieces:
        paint = piece.paint
        if paint.image is None or paint.image is not image or not paint.plain or paint.uv:
            return None
        if piece.uvs is None or piece.uvs.min() < -_OUTSIDE or piece.uvs.max() > 1 + _OUTSIDE:
            return None
    meshes = {}
    for name, group in parts.items():
        solid = welded(group)
        corners = np.concatenate([piece.triangles for piece in group])
        uvs = np.concatenate([_of(piece.uvs)[piece.faces] for piece in group])
        normals = _normals_like(corners, solid)
        meshes[name] = _mesh(corners, uvs, normals, doubled)
    picture = opened(image, "its texture")
    scale = min(1.0, side / max(picture.size))
    size = tuple(max(4, round(v * scale)) for v in picture.size)
    small = picture if scale == 1.0 else picture.resize(size, _lanczos(), reducing_gap=2.0)
    return Baked(meshes, np.asarray(small))


def baked(source: Sequence[Piece], parts: Mapping[str, Solid], side: int) -> Baked:
    """The parts unwrapped, and the colours of ``source`` on them, ``side`` pixels a side."""
    from scipy import ndimage

    flat = {name: _single(solid) for name, solid in parts.items()}
    charts = _unwrapped(flat, side)
    normals = {name: corner_normals(solid) for name, solid in flat.items()}
    position, normal, covered = _rasterised(flat, charts, side)
    colour = np.zeros((side, side, 3))
    density = float(np.sqrt(covered.sum() / max(sum(map(_area, flat.values())), 1e-12)))
    colour[covered] = _Surface(source, density).colours(position[covered], normal[covered])
    _, nearest = ndimage.distance_transform_edt(~covered, return_indices=True)
    filled = colour[tuple(nearest)]
    texture = np.clip(np.round(filled * 255), 0, 255).astype(np.uint8)
    meshes = {
        name: _mesh(flat[name].triangles, charts[name], normals[name], parts[name].doubled)
        for name in parts
    }
    return Baked(meshes, texture)


def _unwrapped(parts: Mapping[str, Solid], side: int) -> dict[str, Array]:
    """Texture coordinates (M, 3, 2) of the corners of every part, v upwards, in one square."""
    import xatlas

    atlas = xatlas.Atlas()
    for solid in parts.values():
        atlas.add_mesh(solid.vertices.astype(np.float32), solid.faces.astype(np.uint32))
    charts, packing = xatlas.ChartOptions(), xatlas.PackOptions()
    charts.max_iterations = 2
    packing.resolution = side
    packing.padding = _PADDING
    packing.bilinear = True
    atlas.generate(charts, packing)
    out = {}
    for index, (name, solid) in enumerate(parts.items()):
        mapping, faces, uvs = atlas[index]
        corners = np.asarray(uvs, np.float64)[np.asarray(faces)]
        # Faces come back in their order; corners, too.
        assert (np.asarray(mapping)[np.asarray(faces)] == solid.faces).all()
        out[name] = corners
    return out


def _rasterised(
    parts: Mapping[str, Solid], charts: Mapping[str, Array], side: int
) -> tuple[Array, Array, npt.NDArray[np.bool_]]:
    """For every texel (row, column): the point of the surface there, its normal, whether any."""
    position, normal = np.zeros((side, side, 3)), np.zeros((side, side, 3))
    covered = np.zeros((side, side), dtype=bool)
    for name, solid in parts.items():
        corners = solid.triangles
        faces = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        faces /= np.maximum(np.linalg.norm(faces, axis=1, keepdims=True), 1e-15)
        pixels = charts[name] * side - 0.5
        pixels[:, :, 1] = side - 1 - pixels[:, :, 1]
        for p, c, n in zip(pixels, corners, faces, strict=True):
            low = np.maximum(np.floor(p.min(axis=0)).astype(int), 0)
            high = np.minimum(np.ceil(p.max(axis=0)).astype(int), side - 1)
            (x0, y0), (x1, y1) = low, high
            if x1 < x0 or y1 < y0:
                continue
            xs, ys = np.meshgrid(np.arange(x0, x1 + 1), np.arange(y0, y1 + 1))
            (ax, ay), (bx, by), (cx, cy) = p
            double = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay)
            if abs(double) < 1e-9:
                continue
            v = ((xs - ax) * (cy - ay) - (cx - ax) * (ys - ay)) / double
            w = ((bx - ax) * (ys - ay) - (xs - ax) * (by - ay)) / double
            u = 1 - v - w
            # A texel half outside is shown, too.
            slack = 0.6 * max(abs(cx - bx), abs(cy - by), abs(bx - ax), abs(by - ay), 1.0)
            inside = np.minimum(np.minimum(u, v), w) > -min(slack / abs(double), 0.5)
            at_y, at_x = ys[inside], xs[inside]
            weights = np.clip(np.stack([u, v, w], axis=-1)[inside], 0, 1)
            weights /= weights.sum(axis=1, keepdims=True)
            position[at_y, at_x] = weights @ c
            normal[at_y, at_x] = n
            covered[at_y, at_x] = True
    return position, normal, covered


class _Surface:
    """The source's surface: what colour is near a point."""

    def __init__(self, pieces: Sequence[Piece], density: float) -> None:
        from scipy.spatial import cKDTree

        self._corners = np.concatenate([piece.triangles for piece in pieces])
        self._owner = np.repeat(np.arange(len(pieces)), [len(piece.faces) for piece in pieces])
        self._face = np.concatenate([np.arange(len(piece.faces)) for piece in pieces])
        self._pieces = pieces
        self._density = density
        points, self._at = surface_points(self._corners, _SAMPLES)
        cross = np.cross(
            self._corners[:, 1] - self._corners[:, 0], self._corners[:, 2] - self._corners[:, 0]
        )
        cross /= np.maximum(np.linalg.norm(cross, axis=1, keepdims=True), 1e-15)
        self._weight = _FACING * float(np.linalg.norm(np.ptp(points, axis=0)))
        self._tree = cKDTree(np.hstack([points, cross[self._at] * self._weight]))

    def colours(self, points: Array, normals: Array) -> Array:
        """Colours (N, 3) 0-1 of the surface nearest to points (N, 3) that looks as they do."""
        _, nearest = self._tree.query(np.hstack([points, normals * self._weight]))
        face = self._at[nearest]
        weights = _closest(self._corners[face], points)
        out = np.empty((len(points), 3))
        for index, piece in enumerate(self._pieces):
            mine = self._owner[face] == index
            if mine.any():
                out[mine] = _colours(
                    piece, self._face[face[mine]], weights[mine], normals[mine], self._density
                )
        return out


def _colours(piece: Piece, faces: Ints, weights: Array, normals: Array, density: float) -> Array:
    """Colours of points of a piece, given by face and barycentric weights."""
    tint = np.array(piece.paint.colour[:3])
    if piece.colours is not None:
        return np.asarray(
            np.einsum("nk,nkd->nd", weights, piece.colours[piece.faces[faces]]) * tint
        )
    if piece.paint.image is None or piece.uvs is None:
        # What has no picture gets the light of the sky, or it would look cut from paper.
        light = 0.82 + 0.18 * (normals[:, 2:] + 1) / 2
        return np.asarray(tint * light)
    uvs = _of(piece.uvs)
    if piece.paint.uv is not None:
        uvs = (np.column_stack([uvs, np.ones(len(uvs))]) @ np.array(piece.paint.uv).T)[:, :2]
    pixels = _readable(piece, uvs, density)
    at = np.einsum("nk,nkd->nd", weights, uvs[piece.faces[faces]])
    return np.asarray(_bilinear(pixels, at) * tint)


def _readable(piece: Piece, uvs: Array, density: float) -> Array:
    """The picture (H, W, 3) 0-1, made about as fine as the texture needs; only texels that the
    mesh shows count, or the ground between islands would bleed in."""
    from PIL import Image, ImageDraw

    picture = opened(piece.paint.image, "its texture")
    width, height = picture.size
    corners = uvs[piece.faces]
    sides = corners[:, 1:] - corners[:, :1]
    area = np.abs(sides[:, 0, 0] * sides[:, 1, 1] - sides[:, 0, 1] * sides[:, 1, 0]).sum() / 2
    surface = _area(Solid(piece.vertices, piece.faces))
    own = float(np.sqrt(area * width * height / max(surface, 1e-12)))
    factor = int(own / max(density * _FINER, 1e-9))
    if factor < 2:
        return np.asarray(picture, dtype=np.float64) / 255.0
    factor = min(factor, 32, min(width, height) // 4 or 1)
    repeated = corners.min() < -_OUTSIDE or corners.max() > 1 + _OUTSIDE
    if repeated or factor < 2:
        return np.asarray(picture.reduce(max(factor, 1)), dtype=np.float64) / 255.0
    mask = Image.new("L", picture.size, 0)
    draw = ImageDraw.Draw(mask)
    scaled = corners * (width, -height) + (0, height)
    for a, b, c in scaled.tolist():
        draw.polygon([tuple(a), tuple(b), tuple(c)], fill=255, outline=255)
    shown = Image.composite(picture, Image.new("RGB", picture.size), mask).reduce(factor)
    share = np.asarray(mask.reduce(factor), dtype=np.float64)[..., None] / 255.0
    whole = np.asarray(shown, dtype=np.float64) / 255.0
    pixels = np.where(share > 0.02, whole / np.maximum(share, 0.02), 0.0)
    from scipy import ndimage

    _, nearest = ndimage.distance_transform_edt(share[..., 0] <= 0.02, return_indices=True)
    return np.asarray(np.clip(pixels[tuple(nearest)], 0, 1))


def _bilinear(pixels: Array, uvs: Array) -> Array:
    """Colours of a picture that repeats itself, at texture coordinates with v upwards."""
    height, width = pixels.shape[:2]
    x = (uvs[:, 0] % 1.0 if _beyond(uvs[:, 0]) else np.clip(uvs[:, 0], 0, 1)) * width - 0.5
    v = uvs[:, 1] % 1.0 if _beyond(uvs[:, 1]) else np.clip(uvs[:, 1], 0, 1)
    y = (1 - v) * height - 0.5
    x0, y0 = np.floor(x).astype(int), np.floor(y).astype(int)
    fx, fy = (x - x0)[:, None], (y - y0)[:, None]
    left, right = np.clip(x0, 0, width - 1), np.clip(x0 + 1, 0, width - 1)
    top, bottom = np.clip(y0, 0, height - 1), np.clip(y0 + 1, 0, height - 1)
    upper = pixels[top, left] * (1 - fx) + pixels[top, right] * fx
    lower = pixels[bottom, left] * (1 - fx) + pixels[bottom, right] * fx
    return np.asarray(upper * (1 - fy) + lower * fy)


def _beyond(values: Array) -> bool:
    return bool(values.min(initial=0.0) < -_OUTSIDE or values.max(initial=1.0) > 1 + _OUTSIDE)


def _closest(triangles: Array, points: Array) -> Array:
    """Barycentric weights (N, 3) of the point of each triangle's plane below a point, kept to the
    triangle."""
    a, b, c = triangles[:, 0], triangles[:, 1], triangles[:, 2]
    e0, e1, d = b - a, c - a, points - a
    d00, d01, d11 = (e0 * e0).sum(1), (e0 * e1).sum(1), (e1 * e1).sum(1)
    d20, d21 = (d * e0).sum(1), (d * e1).sum(1)
    det = np.maximum(d00 * d11 - d01 * d01, 1e-30)
    v = (d11 * d20 - d01 * d21) / det
    w = (d00 * d21 - d01 * d20) / det
    weights = np.clip(np.stack([1 - v - w, v, w], axis=1), 0, None)
    return np.asarray(weights / np.maximum(weights.sum(axis=1, keepdims=True), 1e-12))


def _mesh(corners: Array, uvs: Array, normals: Array, doubled: bool) -> MeshData:
    """A mesh of corners (M, 3, ...), equal ones shared; doubled: every face from behind, too."""
    if doubled:
        corners = np.concatenate([corners, corners[:, ::-1]])
        uvs = np.concatenate([uvs, uvs[:, ::-1]])
        normals = np.concatenate([normals, -normals[:, ::-1]])
    table = np.hstack([corners.reshape(-1, 3), normals.reshape(-1, 3), uvs.reshape(-1, 2)])
    keys = np.round(table * (1e6, 1e6, 1e6, 100, 100, 100, 4e4, 4e4)).astype(np.int64)
    _, first, inverse = np.unique(keys, axis=0, return_index=True, return_inverse=True)
    order = np.argsort(first, kind="stable")
    rank = np.empty(len(first), dtype=np.int64)
    rank[order] = np.arange(len(first))
    chosen = table[first[order]]
    faces = rank[inverse.ravel()].reshape(-1, 3)
    whole = (faces[:, 0] != faces[:, 1]) & (faces[:, 1] != faces[:, 2])
    whole &= faces[:, 2] != faces[:, 0]
    return MeshData(chosen[:, :3], chosen[:, 3:6], np.clip(chosen[:, 6:], 0, 1), faces[whole])


def _normals_like(corners: Array, solid: Solid) -> Array:
    """Smooth normals for corners (M, 3, 3) whose mesh, welded, is ``solid``."""
    from scipy.spatial import cKDTree

    _, index = cKDTree(solid.vertices).query(corners.reshape(-1, 3))
    return corner_normals(Solid(solid.vertices, index.reshape(-1, 3)))


def _single(solid: Solid) -> Solid:
    return Solid(solid.vertices, solid.faces[: len(solid.faces) // 2]) if solid.doubled else solid


def _area(solid: Solid) -> float:
    corners = solid.triangles
    cross = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    return float(np.linalg.norm(cross, axis=1).sum() / 2)


def _of(uvs: Array | None) -> Array:
    assert uvs is not None
    return uvs


def _lanczos() -> Any:
    from PIL import Image

    return Image.Resampling.LANCZOS
