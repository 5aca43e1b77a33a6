"""A scene's drawn triangles in the world, part by part."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import numpy.typing as npt

from sdgen.geometry import Array, apply
from sdgen.library import Library
from sdgen.library.states import object_from_part
from sdgen.render.shell import ceiling_level_m, structure_faces
from sdgen.scene import ObjectInstance, Scene, Structure

Floats = npt.NDArray[np.float32]
Ints = npt.NDArray[np.uint32]

#: A part whose colour factor is this or more gives light of its own: burners, flames, screens.
_GLOWS = 1.4
#: Parts of windows that light comes through.
_PANES = ("pane", "frosted")
#: Faces of the shell reach so far over their edges, metres: where they meet, rounding would leave
#: cracks between them.
_OVER_M = 0.0015


@dataclass(frozen=True, eq=False)
class Drawn:
    """One part: whose it is (``number`` counts an object's drawn parts from 1, and is 0 for
    structures), its triangles in the world, and how it looks. ``glows``: it gives light; ``clear``:
    light comes through it."""

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

    def box(self) -> Array:
        """Lowest and highest corner of the box around it, (2, 3)."""
        return np.array([self.vertices.min(axis=0), self.vertices.max(axis=0)], dtype=np.float64)


def drawn_parts(library: Library, scene: Scene) -> list[Drawn]:
    """All parts of a scene: structures by id, then objects by id."""
    ceiling_m = ceiling_level_m(scene.home.structures)
    out: list[Drawn] = []
    for structure in sorted(scene.home.structures, key=lambda s: s.id):
        out += _of_structure(library, structure, ceiling_m)
    for item in sorted(scene.objects, key=lambda o: o.id):
        out += _of_object(library, item)
    return out


def _of_structure(library: Library, structure: Structure, ceiling_m: float) -> Iterator[Drawn]:
    for face in structure_faces(structure, library.tile_m, ceiling_m):
        quads = face.vertices_m.reshape(-1, 4, 3)
        flat = np.cross(quads[:, 1] - quads[:, 0], quads[:, 2] - quads[:, 0])
        flat /= np.maximum(np.linalg.norm(flat, axis=1, keepdims=True), 1e-12)
        middles = quads.mean(axis=1, keepdims=True)
        quads = quads + _OVER_M * np.sign(np.round(quads - middles, 6))
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


def _of_object(library: Library, item: ObjectInstance) -> Iterator[Drawn]:
    info, meshes = library.info(item.asset), library.mesh(item.asset)
    textures, pose = library.textures(item.asset), item.pose.matrix()
    for number, name in enumerate(info.variants[item.variant], start=1):
        mesh, red_green_blue = meshes[name], info.part(name).rgba[:3]
        placed = pose @ object_from_part(info, name, item.joints)
        yield Drawn(
            item.id,
            number,
            apply(placed, mesh.vertices).astype(np.float32),
            (mesh.normals @ placed[:3, :3].T).astype(np.float32),
            mesh.uvs.astype(np.float32),
            mesh.faces.astype(np.uint32),
            textures[name],
            red_green_blue,
            max(red_green_blue) >= _GLOWS or name == "glow",
            item.category == "window" and name in _PANES,
        )
