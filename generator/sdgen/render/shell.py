"""Floors, walls and ceilings as OBJ files with flat normals and textures in metres."""

from __future__ import annotations

import hashlib
import math
import shutil
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path

import numpy as np

from sdgen.geometry import Array
from sdgen.scene import Band, Structure
from sdgen.vocabulary import FACINGS, HALF_WALL_M

#: Outward normals of a box's six faces.
_NORMALS = ((1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1))
_UP = _NORMALS.index((0, 0, 1))


def _corners(index: int) -> Array:
    """Corners (4, 3) of one face of a box from -1 to 1, counter-clockwise seen from outside."""
    normal = np.asarray(_NORMALS[index], dtype=float)
    first = np.eye(3)[(index // 2 + 1) % 3]
    second = np.cross(normal, first)
    turns = ((-1, -1), (1, -1), (1, 1), (-1, 1))
    return np.array([normal + a * first + b * second for a, b in turns])


_CORNERS = [_corners(index) for index in range(len(_NORMALS))]

# Homes are planned in millimetres.
_ROUNDING_M = 1e-4


@dataclass(frozen=True)
class Face:
    """All faces of a structure that look one way and wear one surface, four vertices a quad.

    ``number`` is the group's among those that such a structure can show.
    """

    number: int
    surface: str
    vertices_m: Array
    normals: Array
    uvs: Array


def structure_faces(
    structure: Structure, tile_m: Callable[[str], float], ceiling_m: float = math.inf
) -> list[Face]:
    """Quads of the structure's boxes, grouped by direction and surface.

    Texture coordinates are world metres / ``tile_m`` of the surface, so the pattern runs on across
    pieces.
    Floors show their top and ceilings their underside only, and no camera comes above
    ``ceiling_m``.
    """
    wanted = {"floor": (_UP,), "ceiling": (5,), "wall": (0, 1, 2, 3, 4, 5)}[structure.category]
    boxes = np.array([(piece.center_m, piece.size_m) for piece in structure.pieces])
    centres, halves = boxes[:, 0], boxes[:, 1] / 2
    out = []
    for number, index in enumerate(wanted):
        if index == _UP and (centres + halves)[:, 2].min() > ceiling_m - _ROUNDING_M:
            continue
        side = structure.category == "wall" and index < 4
        bands = [b for b in structure.bands if b.facing == FACINGS[index]] if side else []
        groups = _by_surface(structure.surface, (centres, halves), bands)
        for k, (surface, middles, reaches) in enumerate(groups):
            quads = (middles[:, None] + reaches[:, None] * _CORNERS[index]).reshape(-1, 3)
            normals = np.repeat([_NORMALS[index]], len(quads), axis=0).astype(np.float64)
            across, up = ((1, 2), (0, 2), (0, 1))[index // 2]
            uvs = quads[:, [across, up]] / tile_m(surface)
            number_ = number + k * len(_NORMALS)
            out.append(Face(number_, surface, quads, normals, uvs))
    return out


def _by_surface(
    surface: str, boxes: tuple[Array, Array], bands: Sequence[Band]
) -> list[tuple[str, Array, Array]]:
    """Boxes cut at the edges of bands, as middles and half sizes, by the surface that they wear:
    of bands that overlap the first's."""
    middles, reaches = boxes
    if not bands:
        return [(surface, middles, reaches)]
    along = 1 if bands[0].facing in ("+x", "-x") else 0
    # What ends in a corner goes on behind the wall that it meets there: between both no line of
    # what is beside it would be seen.
    low = (middles - reaches)[:, along].min() + HALF_WALL_M + _ROUNDING_M
    high = (middles + reaches)[:, along].max() - HALF_WALL_M - _ROUNDING_M
    for axis, k in ((along, 0), (2, 1)):
        edges = sorted({edge[k] for band in bands for edge in (band.low_m, band.high_m)})
        if axis == along:
            edges = [edge for edge in edges if low < edge < high]
        middles, reaches = _cut(middles, reaches, np.array(edges), axis)
    worn = np.full(len(middles), len(bands))
    for number, band in reversed(list(enumerate(bands))):
        at = middles[:, [along, 2]]
        worn[((at > band.low_m) & (at < band.high_m)).all(axis=1)] = number
    names = [*(band.surface for band in bands), surface]
    every = np.array(names)[worn]
    return [
        (name, middles[every == name], reaches[every == name])
        for name in dict.fromkeys((surface, *names))
        if (every == name).any()
    ]


def _cut(centres: Array, halves: Array, at_m: Array, axis: int) -> tuple[Array, Array]:
    """Boxes, as middles and half sizes (N, 3), sliced across an axis at those of the places, in
    rising order, that they span."""
    out = []
    for middle, half in zip(centres.tolist(), halves.tolist(), strict=True):
        low, high = middle[axis] - half[axis], middle[axis] + half[axis]
        inner = [h for h in at_m.tolist() if low + 1e-6 < h < high - 1e-6]
        for a, b in pairwise([low, *inner, high]):
            one, reach = [*middle], [*half]
            one[axis], reach[axis] = (a + b) / 2, (b - a) / 2
            out.append((one, reach))
    boxes = np.array(out)
    return boxes[:, 0], boxes[:, 1]


def face_obj(face: Face, mtl: str) -> str:
    """The face group as a Wavefront OBJ of triangles."""
    count = len(face.vertices_m)
    # One format for all rows of a kind: a home has some 150 faces, each of dozens of rows.
    text = f"mtllib {mtl}\nusemtl m\n"
    text += ("v %.5f %.5f %.5f\n" * count) % tuple(face.vertices_m.ravel().tolist())
    text += ("vt %.5f %.5f\n" * count) % tuple(face.uvs.ravel().tolist())
    text += ("vn %.4f %.4f %.4f\n" * count) % tuple(face.normals.ravel().tolist())
    corners = np.arange(1, count + 1, 4)[:, None] + (0, 1, 2, 0, 2, 3)
    numbers = np.repeat(corners.ravel(), 3).tolist()
    text += ("f %d/%d/%d %d/%d/%d %d/%d/%d\n" * (count // 2)) % tuple(numbers)
    return text


class ShellFolder:
    """Writes shell meshes into a folder, named by content, one MTL a texture."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._written: set[Path] = set()

    def write(self, face: Face, texture: Path) -> Path:
        """OBJ file of a face group that wears ``texture``."""
        image = self._folder / texture.name
        mtl = self._folder / f"{texture.stem}.mtl"
        if mtl not in self._written:
            self._written.add(mtl)
            shutil.copyfile(texture, image)
            mtl.write_text(
                f"newmtl m\nKa 1 1 1\nKd 1 1 1\nKs 0 0 0\nmap_Kd {image.name}\n", encoding="utf-8"
            )
        # By what decides the text, which takes longer to write than this to hash.
        arrays = (face.vertices_m, face.normals, face.uvs)
        digest = hashlib.sha256(mtl.name.encode() + b"".join(array.tobytes() for array in arrays))
        path = self._folder / f"{digest.hexdigest()[:20]}.obj"
        if path not in self._written:
            path.write_bytes(face_obj(face, mtl.name).encode("ascii"))
            self._written.add(path)
        return path


def ceiling_level_m(structures: Iterable[Structure]) -> float:
    """Height of the highest ceiling's underside, infinite without one."""
    pieces = [piece for s in structures if s.category == "ceiling" for piece in s.pieces]
    return max((p.center_m[2] - p.size_m[2] / 2 for p in pieces), default=math.inf)
