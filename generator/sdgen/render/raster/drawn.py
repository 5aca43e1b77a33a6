"""A scene's drawn triangles in the world, part by part."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np
import numpy.typing as npt
from shapely.geometry import Polygon

from sdgen.geometry import Array, apply
from sdgen.library import Library
from sdgen.library.meshes import MeshData
from sdgen.library.states import object_from_part
from sdgen.render.outdoors import CLEAR_PANE
from sdgen.render.shell import ceiling_level_m, structure_faces
from sdgen.scene import Home, ObjectInstance, Scene, Structure
from sdgen.vocabulary import HALF_WALL_M

Floats = npt.NDArray[np.float32]
Ints = npt.NDArray[np.uint32]

#: A part whose colour factor is this or more gives light of its own: burners, flames, screens.
_GLOWS = 1.4
#: And so do parts that are called so.
_GLOW, _LIT = "glow", "_lit"
#: Shorter than this a normal is none.
_NO_NORMAL = 1e-6
#: Lamps that are on when it is dark, and how much window a room needs by day not to be, of its
#: floor's area: building codes ask for an eighth or a tenth.
CEILING_LAMP = "ceiling_lamp"
MIRROR = "mirror"
_LEAST_GLASS = 0.06
#: Less opaque than this a part is seen through.
_OPAQUE = 0.99
#: Parts of windows that light comes through.
_PANES = (CLEAR_PANE, "frosted")
#: Faces of the shell reach so far over their edges, metres: where they meet, rounding would leave
#: cracks between them. Not those across a wall, which would stand out of it, nor where tiles and
#: plaster of one wall meet, or one would be seen in dots on the other.
_OVER_M = 0.0015


@dataclass(frozen=True, eq=False)
class Drawn:
    """One part: whose it is (``number`` counts an object's drawn parts from 1, and is 0 for
    structures), its triangles in the world, and how it looks. ``glows``: it gives light; ``clear``:
    it is a window's pane, ``painted``: what is seen there is painted in, the world outside or,
    where it ``mirrors``, this one; ``alpha``: how much it hides of what is behind it."""

    node_id: int
    number: int
    vertices: Floats
    normals: Floats
    uvs: Floats
    faces: Ints
    texture: Path
    rgb: tuple[float, float, float]
    glows: bool = False
    clear: bool = False
    painted: bool = False
    mirrors: bool = False
    alpha: float = 1.0
    category: str = ""

    @property
    def translucent(self) -> bool:
        """Whether it is seen through, as a glass is. What is behind a window's pane is painted."""
        return self.alpha < _OPAQUE and not self.clear

    @cached_property
    def box(self) -> Array:
        """Lowest and highest corner of the box around it, (2, 3)."""
        return np.array([self.vertices.min(axis=0), self.vertices.max(axis=0)], dtype=np.float64)


def drawn_parts(library: Library, scene: Scene) -> list[Drawn]:
    """All parts of a scene: structures by id, then objects by id."""
    ceiling_m = ceiling_level_m(scene.home.structures)
    out: list[Drawn] = []
    for structure in sorted(scene.home.structures, key=lambda s: s.id):
        out += _of_structure(library, structure, ceiling_m)
    dark = dark_rooms(scene.home)
    for item in sorted(scene.objects, key=lambda o: o.id):
        out += parts_of(library, item, item.room_id in dark)
    return out


def dark_rooms(home: Home) -> set[int]:
    """Rooms in which lamps at the ceiling are on: in the evening and by night all, by day those
    with little or no window for their size."""
    if home.daylight.time != "day":
        return {room.id for room in home.rooms}
    glass = {room.id: 0.0 for room in home.rooms}
    for opening in home.openings:
        if opening.kind == "window":
            glass[opening.room_ids[0]] += opening.width_m * opening.height_m
    return {
        room.id for room in home.rooms
        if glass[room.id] < _LEAST_GLASS * Polygon(room.polygon_m).area
    }  # fmt: skip


def _of_structure(library: Library, structure: Structure, ceiling_m: float) -> Iterator[Drawn]:
    ends = [np.round(_ends_m(structure, axis), 5) for axis in range(3)]
    for face in structure_faces(structure, library.tile_m, ceiling_m):
        quads = face.vertices_m.reshape(-1, 4, 3)
        flat = np.cross(quads[:, 1] - quads[:, 0], quads[:, 2] - quads[:, 0])
        flat /= np.maximum(np.linalg.norm(flat, axis=1, keepdims=True), 1e-12)
        if _wide(quads, structure.category):
            middles = quads.mean(axis=1, keepdims=True)
            over = np.sign(np.round(quads - middles, 6))
            for axis in range(3):
                over[..., axis] *= np.isin(np.round(quads[..., axis], 5), ends[axis])
            quads = quads + _OVER_M * over
        corners = np.arange(0, 4 * len(quads), 4)[:, None] + (0, 1, 2, 0, 2, 3)
        yield Drawn(
            structure.id,
            0,
            quads.reshape(-1, 3).astype(np.float32),
            np.repeat(flat, 4, axis=0).astype(np.float32),
            face.uvs.astype(np.float32),
            corners.reshape(-1, 3).astype(np.uint32),
            library.surface_texture(face.surface),
            (1.0, 1.0, 1.0),
        )


def _ends_m(structure: Structure, axis: int) -> Array:
    """Where the boxes of a structure end along an axis, metres."""
    boxes = np.array([(piece.center_m[axis], piece.size_m[axis]) for piece in structure.pieces])
    return np.concatenate([boxes[:, 0] - boxes[:, 1] / 2, boxes[:, 0] + boxes[:, 1] / 2])


def _wide(quads: Array, category: str) -> bool:
    """Whether faces (N, 4, 3) of one direction are those of a wall's sides, or a floor's."""
    if category != "wall":
        return True
    size = np.ptp(quads, axis=1)
    upright = size[:, 2].max() > 0
    return bool(upright and size[:, :2].max() > 2.5 * HALF_WALL_M)


def parts_of(library: Library, item: ObjectInstance, lit: bool) -> Iterator[Drawn]:
    """An object's drawn parts. ``lit``: a lamp at the ceiling is on."""
    info, meshes = library.info(item.asset), library.mesh(item.asset)
    textures, pose = library.textures(item.asset), item.pose.matrix()
    for number, name in enumerate(info.variants[item.variant], start=1):
        mesh, (*rgb, alpha) = meshes[name], info.part(name).rgba
        mirrors = item.category == MIRROR and name == CLEAR_PANE and item.variant == "default"
        placed = pose @ object_from_part(info, name, item.joints)
        yield Drawn(
            item.id,
            number,
            apply(placed, mesh.vertices).astype(np.float32),
            (_normals(mesh) @ placed[:3, :3].T).astype(np.float32),
            mesh.uvs.astype(np.float32),
            mesh.faces.astype(np.uint32),
            textures[name],
            (rgb[0], rgb[1], rgb[2]),
            _gives_light(name, max(rgb)) and (lit or item.category != CEILING_LAMP),
            item.category == "window" and name in _PANES,
            mirrors or (item.category == "window" and name == CLEAR_PANE),
            mirrors,
            alpha,
            item.category,
        )


def _gives_light(name: str, factor: float) -> bool:
    return factor >= _GLOWS or name == _GLOW or name.endswith(_LIT)


def _normals(mesh: MeshData) -> Array:
    """A mesh's normals; where it has none, those of the triangles at each corner."""
    normals = np.asarray(mesh.normals, dtype=np.float64)
    bare = np.linalg.norm(normals, axis=1) < _NO_NORMAL
    if not bare.any():
        return normals
    corners = np.asarray(mesh.vertices)[mesh.faces]
    flat = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    summed = np.zeros_like(normals)
    for corner in range(3):
        np.add.at(summed, mesh.faces[:, corner], flat)
    length = np.linalg.norm(summed, axis=1, keepdims=True)
    summed = np.where(length > 0, summed / np.maximum(length, 1e-12), (0.0, 0.0, 1.0))
    return np.where(bare[:, None], summed, normals)
