"""A scene as one GLB: shell and objects as named nodes with textures, metres, Y up as glTF is."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image

from sdgen.catalog.records import HomeSpec
from sdgen.geometry import Z_UP_FROM_Y_UP, Array
from sdgen.home.notes import KEY, HomeNote, ThingNote, home_note, thing_notes
from sdgen.library import Library, MeshData
from sdgen.library.states import object_from_part
from sdgen.render.shell import Face, structure_faces
from sdgen.scene import ObjectInstance, Record, Scene, Structure

_GLTF_FROM_OURS = Z_UP_FROM_Y_UP.T


def home_glb(scene: Scene, library: Library, spec: HomeSpec | None = None) -> bytes:
    """The scene as a GLB. Its root is the home; below it are a node for each structure and, named
    by category and id, for each object, with its drawn parts below that, where joints put them.

    A model's meshes are in the file once, however often it stands there. ``extras`` of the home's
    and the objects' nodes say what no shape tells (:mod:`sdgen.home.notes`); ``spec`` is
    what the home was made from, where it is at hand.
    """
    made = _Made(library, scene.home.id, home_note(scene, spec))
    names = {room.id: room.name for room in scene.home.rooms}
    for structure in scene.home.structures:
        made.structure(structure, names[structure.room_id])
    for item, said in thing_notes(scene):
        made.object(item, said)
    data: bytes = made.scene.export(file_type="glb")
    return data


class _Made:
    """A trimesh scene in the making."""

    def __init__(self, library: Library, root: str, note: HomeNote) -> None:
        import trimesh

        self._trimesh: Any = trimesh
        self._library = library
        self._root = root
        self._materials: dict[Path, Any] = {}
        self.scene: Any = trimesh.Scene(base_frame="world")
        self._node(root, "world", _GLTF_FROM_OURS, note=note)

    def structure(self, structure: Structure, room: str) -> None:
        """Add a floor, wall or ceiling, its texture running on across pieces."""
        groups: dict[str, list[Face]] = {}
        for face in structure_faces(structure, self._library.tile_m):
            groups.setdefault(face.surface, []).append(face)
        node = f"{structure.category}_{structure.id}_{room}"
        for surface, faces in groups.items():
            vertices = np.concatenate([face.vertices_m for face in faces])
            corners = np.arange(0, len(vertices), 4)[:, None] + (0, 1, 2, 0, 2, 3)
            name = node if surface == structure.surface else f"{node}/{surface}"
            self.scene.geometry[name] = self._trimesh.Trimesh(
                vertices=vertices,
                faces=corners.reshape(-1, 3),
                visual=self._visual(
                    np.concatenate([face.uvs for face in faces]),
                    self._library.surface_texture(surface),
                ),
                process=False,
            )
            self._node(name, self._root, np.eye(4), name)

    def object(self, item: ObjectInstance, said: ThingNote) -> None:
        """Add an object as it stands."""
        asset = self._library.assets[item.asset]
        meshes: Mapping[str, MeshData] = self._library.mesh(item.asset)
        node = f"{item.category}_{item.id}"
        self._node(node, self._root, item.pose.matrix(), note=said)
        for part in asset.variants[item.variant]:
            geometry = f"{item.asset}/{part}"
            if geometry not in self.scene.geometry:
                texture = asset.part(part).texture or asset.texture
                mesh = meshes[part]
                self.scene.geometry[geometry] = self._trimesh.Trimesh(
                    vertices=mesh.vertices,
                    faces=mesh.faces,
                    vertex_normals=mesh.normals,
                    visual=self._visual(mesh.uvs, self._library.file(item.asset, texture)),
                    process=False,
                )
            self._node(f"{node}/{part}", node, object_from_part(asset, part, item.joints), geometry)

    def _node(
        self,
        name: str,
        parent: str,
        matrix: Array,
        geometry: str | None = None,
        note: Record | None = None,
    ) -> None:
        # Trimesh writes a node's metadata as its extras.
        said = note and {KEY: note.model_dump(mode="json", exclude_defaults=True)}
        self.scene.graph.update(
            frame_to=name, frame_from=parent, matrix=matrix, geometry=geometry, metadata=said
        )

    def _visual(self, uvs: Array, texture: Path) -> Any:
        visual = self._trimesh.visual
        if texture not in self._materials:
            image = Image.open(texture)
            image.load()
            self._materials[texture] = visual.material.PBRMaterial(
                name=texture.stem,
                baseColorTexture=image,
                metallicFactor=0.0,
                roughnessFactor=0.8,
            )
        return visual.TextureVisuals(uv=uvs, material=self._materials[texture])
