"""The CPU renderer that is part of Bullet: slow and plain, but it starts everywhere."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from contextlib import ExitStack
from pathlib import Path
from typing import ClassVar, NamedTuple

import numpy as np
import numpy.typing as npt

from sdgen.geometry import Array, apply, quat_from_matrix
from sdgen.library import Library
from sdgen.library.states import object_from_part
from sdgen.physics.bullet import pb
from sdgen.render.opengl import depth_from_buffer, projection_matrix, scaled, view_matrix
from sdgen.render.outdoors import Outside
from sdgen.render.part_bodies import WITH_LINKS, Part, PartBodies
from sdgen.render.protocol import Picture, Probe, Renderer
from sdgen.render.shell import ShellFolder, ceiling_level_m, structure_faces
from sdgen.scene import Camera, ObjectInstance, Scene, Structure
from sdgen.scratch import scratch_folder

#: Where the light stands: almost overhead, and far away.
_LIGHT_M = (12.0, -14.0, 100.0)
#: Shapes of so many corners of triangles are kept for the next scenes.
_CORNER_LIMIT = 1_500_000

Rgba = tuple[float, float, float, float]


class _Shape(NamedTuple):
    """Bullet's id, and where the origin lies in the file's frame."""

    id: int
    origin_m: Array


class TinyRenderer(Renderer):
    """Bullet's TinyRenderer. It knows one light, and neither lamps nor shade."""

    name: ClassVar[str] = "the CPU renderer"
    renderer_string = "TinyRenderer"

    def __init__(self) -> None:
        self._held = ExitStack()
        self._shell = ShellFolder(self._held.enter_context(scratch_folder()))
        self._client: int = pb.connect(pb.DIRECT)
        #: Of an OBJ file in a colour.
        self._shapes: dict[tuple[Path, Rgba], _Shape] = {}
        self._bodies = PartBodies(self._client)
        self._parts: list[Part] = []
        self._outside: Outside | None = None
        self._corners = 0

    @staticmethod
    def probe() -> Probe:
        """It starts everywhere."""
        return Probe(True, TinyRenderer.renderer_string)

    def close(self) -> None:
        """Disconnect; a second call does nothing."""
        if self._client >= 0:
            pb.disconnect(physicsClientId=self._client)
            self._client = -1
            self._held.close()

    def load(self, library: Library, scene: Scene) -> None:
        """Put ``scene`` in place of what was loaded before."""
        self._clear()
        parts: list[Part] = []
        ceiling_m = ceiling_level_m(scene.home.structures)
        for structure in sorted(scene.home.structures, key=lambda s: s.id):
            parts += self._structure_parts(library, structure, ceiling_m)
        for item in sorted(scene.objects, key=lambda o: o.id):
            parts += self._object_parts(library, item)
        self._parts = parts
        self._outside = Outside(library, scene)
        self._bodies.put(parts)

    def show_only(self, node_ids: Collection[int] | None) -> None:
        """Draw of the loaded scene these nodes alone, by id; None: all."""
        every = node_ids is None
        self._bodies.remove()
        self._bodies.put([p for p in self._parts if every or p.node_id in (node_ids or ())])

    def draw(self, camera: Camera, colours: bool = True) -> Picture:
        """What ``camera`` sees of the loaded scene; without ``colours``, ``rgb`` is black."""
        size = (camera.width, camera.height)
        rgb, buffer, mask = self._image(camera, np.asarray(camera.K), size)
        instance, part = self._bodies.owners(self._bodies.index_of(mask))
        return Picture(
            rgb=self._painted(rgb, instance, part, camera) if colours else np.zeros_like(rgb),
            depth_m=depth_from_buffer(buffer, camera.near_m, camera.far_m),
            instance=instance,
            part=part,
        )

    def draw_colours(self, camera: Camera, factor: int) -> npt.NDArray[np.uint8]:
        """Its colours alone, ``factor`` times as many pixels along each side."""
        size = (camera.width * factor, camera.height * factor)
        rgb, _, mask = self._image(camera, scaled(np.asarray(camera.K), factor), size)
        return self._painted(rgb, *self._bodies.owners(self._bodies.index_of(mask)), camera)

    def _painted(
        self,
        rgb: npt.NDArray[np.uint8],
        instance: npt.NDArray[np.uint16],
        part: npt.NDArray[np.uint8],
        camera: Camera,
    ) -> npt.NDArray[np.uint8]:
        outside = self._outside
        return rgb if outside is None else outside.paint(rgb, instance, part, camera)

    def _clear(self) -> None:
        """Take all bodies away; shapes stay for the next scene, while there are not too many."""
        self._bodies.remove()
        if self._corners > _CORNER_LIMIT:
            pb.resetSimulation(physicsClientId=self._client)
            self._bodies = PartBodies(self._client)
            self._shapes = {}
            self._corners = 0

    def _structure_parts(
        self, library: Library, structure: Structure, ceiling_m: float
    ) -> Iterator[Part]:
        for face in structure_faces(structure, library.tile_m, ceiling_m):
            path = self._shell.write(face, library.surface_texture(face.surface))
            corners = 3 * len(face.vertices_m) // 2
            shape = self._shape(path, (1.0, 1.0, 1.0, 1.0), face.vertices_m, corners)
            yield _placed(structure.id, 0, shape, np.eye(4))

    def _object_parts(self, library: Library, item: ObjectInstance) -> Iterator[Part]:
        """The drawn parts, in their order."""
        info, pose = library.info(item.asset), item.pose.matrix()
        objs, meshes = library.objs(item.asset), library.mesh(item.asset)
        for number, name in enumerate(info.variants[item.variant], start=1):
            red, green, blue, _ = info.part(name).rgba
            mesh = meshes[name]
            # Opaque: what is seen through would have no depth.
            shape = self._shape(objs[name], (red, green, blue, 1.0), mesh.vertices, mesh.faces.size)
            yield _placed(item.id, number, shape, pose @ object_from_part(info, name, item.joints))

    def _shape(self, path: Path, rgba: Rgba, vertices_m: Array, corners: int) -> _Shape:
        """Visual shape that shows an OBJ file; its origin is the middle of the mesh."""
        if (path, rgba) not in self._shapes:
            ends = np.array([vertices_m.min(axis=0), vertices_m.max(axis=0)])
            middle = np.round(ends.mean(axis=0), 3)
            self._corners += corners
            made = pb.createVisualShape(
                pb.GEOM_MESH,
                fileName=str(path),
                rgbaColor=rgba,
                visualFramePosition=(-middle).tolist(),
                physicsClientId=self._client,
            )
            self._shapes[path, rgba] = _Shape(int(made), middle)
        return self._shapes[path, rgba]

    def _image(
        self, camera: Camera, k: Array, size: tuple[int, int]
    ) -> tuple[npt.NDArray[np.uint8], npt.NDArray[np.float32], npt.NDArray[np.int32]]:
        """Colour, depth buffer and Bullet's mask of a camera's view drawn at ``size`` (width,
        height)."""
        width, height = size
        image = pb.getCameraImage(
            width,
            height,
            view_matrix(np.asarray(camera.world_from_camera)),
            projection_matrix(k, 0, 0, width, height, camera.near_m, camera.far_m),
            lightDirection=_LIGHT_M,
            lightAmbientCoeff=0.65,
            lightDiffuseCoeff=0.4,
            lightSpecularCoeff=0.0,
            shadow=0,
            flags=WITH_LINKS,
            renderer=pb.ER_TINY_RENDERER,
            physicsClientId=self._client,
        )
        rgba = np.asarray(image[2], dtype=np.uint8).reshape(height, width, 4)
        return (
            np.ascontiguousarray(rgba[..., :3]),
            np.asarray(image[3], dtype=np.float32).reshape(height, width),
            np.asarray(image[4], dtype=np.int32).reshape(height, width),
        )


def _placed(node_id: int, number: int, shape: _Shape, pose: Array) -> Part:
    """A shape whose file's frame is at ``pose``."""
    position = apply(pose, shape.origin_m)[0].tolist()
    return Part(node_id, number, shape.id, position, quat_from_matrix(pose[:3, :3]))
