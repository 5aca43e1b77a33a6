"""A scene's bodies in Bullet, and pictures of them: what both of its renderers share."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator
from contextlib import ExitStack
from pathlib import Path
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from sdgen.geometry import Array, apply, quat_from_matrix
from sdgen.library import Library
from sdgen.library.states import object_from_part
from sdgen.physics.bullet import pb
from sdgen.render.misread import read_again
from sdgen.render.opengl import depth_from_buffer, projection_matrix, scaled, view_matrix
from sdgen.render.part_bodies import WITH_LINKS, Part, PartBodies
from sdgen.render.protocol import Picture
from sdgen.render.shell import LIGHT_M, ShellFolder, ceiling_level_m, structure_faces
from sdgen.scene import Camera, ObjectInstance, Scene, Structure
from sdgen.scratch import scratch_folder

# The EGL window of the plugin; a larger picture would be scaled up from it without a word.
_TILE = (2560, 2048)

# The plugin's shadow map covers 10 m to each side of the world's origin, and its highlights are
# those a camera 0.26 m above the origin would see. So homes are drawn around the origin, with
# their floors above that camera: then no floor or table top shines.
_FLOOR_Z_M = 0.4

# A ceiling would shut out the light, and a lamp at it throw a disc of shadow. Bodies with alpha < 1
# cast none, but the plugin draws them after all others and without writing depth: only ceilings,
# which nothing stands behind, and what hugs them may be like that.
_OVERHEAD_ALPHA = 0.999

# The plugin draws see-through parts in the order of how far their origins are along the view. So
# that lamps come after ceilings from wherever one looks, each is drawn with its origin so far off,
# metres, in four directions: there is always one further that way than any ceiling.
_OFF_M = 100.0 * np.array(((1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1)))

# The plugin holds 3.7 million vertices and draws nothing, silently, of what comes after; a scene
# has up to 0.4 million. It also looks at every shape it holds, those of homes that are gone
# included, whenever a part is put in or taken out (25 ns each): to start anew less often saves no
# time, and this often it holds the textures of some 25 scenes, half a gigabyte.
_VERTEX_LIMIT = 1_500_000

# What origins of parts are moved by, a step each: more than Bullet's rounding, in no direction
# that two parts of a model have in common.
_APART_M = np.array((0.0007, 0.0011, 0.0013))

#: A speck of one triangle.
_SPARE_OBJ = """\
v 0 0 0
v 0.001 0 0
v 0 0.001 0
vt 0 0
vn 0 0 1
f 1/1/1 2/1/1 3/1/1
"""

Rgba = tuple[float, float, float, float]


class _Shape(NamedTuple):
    """Bullet's id, where the origin lies in the file's frame, and the box around all of it in the
    frame of the origin, (2, 3)."""

    id: int
    origin_m: Array
    box_m: Array


class BulletGraphics:
    """A Bullet world that is only looked at.

    ``device`` is one of PyBullet's renderers; with ``face_levels`` each face of the shell is
    drawn at the brightness that undoes the EGL plugin's shader. ``on_reset`` is called when the
    world has been emptied of everything that was ever loaded, ``before_tile`` before a picture of
    this width and height is drawn.
    """

    def __init__(
        self,
        device: int,
        face_levels: bool,
        on_reset: Callable[[], None] = lambda: None,
        before_tile: Callable[[int, int], None] = lambda _width, _height: None,
    ) -> None:
        self._device = device
        self._on_reset = on_reset
        self._before_tile = before_tile
        self._face_levels = face_levels
        self._held = ExitStack()
        self._folder = self._held.enter_context(scratch_folder())
        self._shell = ShellFolder(self._folder)
        self.client: int = pb.connect(pb.DIRECT)
        #: Of an OBJ file in a colour, its origin moved.
        self._shapes: dict[tuple[Path, Rgba, tuple[float, ...]], _Shape] = {}
        self._bodies = self._no_bodies()
        #: Those of the loaded scene, and those of them that are in the world.
        self._all_parts: list[Part] = []
        self._parts: list[Part] = []
        self._vertices = 0
        self._shift = np.eye(4)

    def close(self) -> None:
        """Disconnect; a second call does nothing."""
        if self.client >= 0:
            pb.disconnect(physicsClientId=self.client)
            self.client = -1
            self._held.close()

    def load(self, library: Library, scene: Scene, overhead: Collection[int] = ()) -> None:
        """Put the scene, moved by :func:`drawing_shift`, into the emptied world; what is
        ``overhead``, by id, so that it throws no shadow."""
        self._clear()
        self._shift = drawing_shift(scene)
        parts: list[Part] = []
        ceiling_m = ceiling_level_m(scene.home.structures)
        for structure in sorted(scene.home.structures, key=lambda s: s.id):
            parts += self._structure_parts(library, structure, ceiling_m)
        for item in sorted(scene.objects, key=lambda o: o.id):
            parts += self._object_parts(library, item, item.id in overhead)
        self._all_parts = parts
        self._put(parts)

    def show_only(self, node_ids: Collection[int] | None) -> None:
        """Have of the loaded scene these nodes alone in the world; None: all."""
        parts = self._all_parts
        if node_ids is not None:
            parts = [part for part in parts if part.node_id in node_ids]
        self._bodies.remove()
        self._put(parts)

    def _put(self, parts: list[Part]) -> None:
        self._parts = parts
        self._bodies.put(parts)

    def draw(self, camera: Camera) -> Picture:
        """Colour, depth and whose every pixel is."""
        size = (camera.width, camera.height)
        rgb, buffer, mask = self._image(camera, np.asarray(camera.K), size, mask=True)
        depth_m = depth_from_buffer(buffer, camera.near_m, camera.far_m)
        index = self._bodies.index_of(mask)
        if self._device == pb.ER_BULLET_HARDWARE_OPENGL:
            nodes, _ = self._bodies.owners(index)
            pose = self._shift @ np.asarray(camera.world_from_camera)
            index = read_again(index, nodes, depth_m, camera, pose, self._parts)
        instance, part = self._bodies.owners(index)
        return Picture(
            rgb=rgb,
            depth_m=depth_m,
            instance=instance,
            part=part,
        )

    def draw_colours(self, camera: Camera, factor: int) -> npt.NDArray[np.uint8]:
        """The camera's colours with ``factor`` times as many pixels along each side."""
        size = (camera.width * factor, camera.height * factor)
        k = scaled(np.asarray(camera.K), factor)
        return self._image(camera, k, size, mask=False)[0]

    def _no_bodies(self) -> PartBodies:
        if self._device != pb.ER_BULLET_HARDWARE_OPENGL:
            return PartBodies(self.client, None)
        spare = self._folder / "spare.obj"
        spare.write_text(_SPARE_OBJ, encoding="utf-8")
        shape = pb.createVisualShape(pb.GEOM_MESH, fileName=str(spare), physicsClientId=self.client)
        return PartBodies(self.client, int(shape))

    def _clear(self) -> None:
        """Take all bodies away; shapes and textures stay for the next scene.

        ``resetSimulation``, after which every texture is uploaded again, is for the day when the
        vertices run out.
        """
        self._bodies.remove()
        if self._vertices > _VERTEX_LIMIT:
            pb.resetSimulation(physicsClientId=self.client)
            self._bodies = self._no_bodies()
            self._shapes = {}
            self._vertices = 0
            self._on_reset()

    def _structure_parts(
        self, library: Library, structure: Structure, ceiling_m: float
    ) -> Iterator[Part]:
        alpha = _OVERHEAD_ALPHA if structure.category == "ceiling" else 1.0
        for face in structure_faces(structure, library.tile_m, ceiling_m):
            path = self._shell.write(face, library.surface_texture(face.surface))
            level = face.brightness if self._face_levels else 1.0
            rgba = (level, level, level, alpha)
            shape = self._shape(
                path, rgba, face.vertices_m, 3 * len(face.vertices_m) // 2, face.number * _APART_M
            )
            yield _placed(structure.id, 0, shape, self._shift, deep=alpha == 1.0)

    def _object_parts(
        self, library: Library, item: ObjectInstance, overhead: bool
    ) -> Iterator[Part]:
        """The drawn parts, in their order."""
        info = library.info(item.asset)
        objs, meshes = library.objs(item.asset), library.mesh(item.asset)
        pose = self._shift @ item.pose.matrix()
        apart = {part.name: index for index, part in enumerate(info.parts)}
        for number, name in enumerate(info.variants[item.variant], start=1):
            red, green, blue, _ = info.part(name).rgba
            # Opaque but there: the plugin gives see-through bodies no depth.
            rgba = (red, green, blue, _OVERHEAD_ALPHA if overhead else 1.0)
            mesh = meshes[name]
            placed = pose @ object_from_part(info, name, item.joints)
            for off in _OFF_M if overhead else (apart[name] * _APART_M,):
                shape = self._shape(objs[name], rgba, mesh.vertices, mesh.faces.size, off)
                yield _placed(item.id, number, shape, placed, deep=not overhead)

    def _shape(
        self, path: Path, rgba: Rgba, vertices_m: Array, corners: int, apart_m: Array
    ) -> _Shape:
        """Visual shape that shows an OBJ file.

        The plugin makes a vertex of each of the ``corners`` of its triangles.
        The origin is the middle of the mesh plus ``apart_m``: the plugin draws parts in the order
        of their origins' depth, and where faces coincide the first one drawn wins. Parts with one
        common origin would be drawn in an order that depends on what the process has drawn before.
        """
        key = path, rgba, tuple(apart_m.tolist())
        if key not in self._shapes:
            ends = np.array([vertices_m.min(axis=0), vertices_m.max(axis=0)])
            middle = np.round(ends.mean(axis=0), 3) + apart_m
            self._vertices += corners
            made = pb.createVisualShape(
                pb.GEOM_MESH,
                fileName=str(path),
                rgbaColor=rgba,
                visualFramePosition=(-middle).tolist(),
                physicsClientId=self.client,
            )
            self._shapes[key] = _Shape(int(made), middle, ends - middle)
        return self._shapes[key]

    def _image(
        self, camera: Camera, k: Array, size: tuple[int, int], mask: bool
    ) -> tuple[npt.NDArray[np.uint8], npt.NDArray[np.float32], npt.NDArray[np.int32]]:
        """Colour, depth buffer and Bullet's mask of a camera's view drawn at ``size`` (width,
        height), in tiles no larger than the EGL window."""
        width, height = size
        rgb = np.empty((height, width, 3), dtype=np.uint8)
        depth = np.empty((height, width), dtype=np.float32)
        owner = np.empty((height, width), dtype=np.int32)
        view = view_matrix(self._shift @ np.asarray(camera.world_from_camera))
        for y0 in range(0, height, _TILE[1]):
            for x0 in range(0, width, _TILE[0]):
                w, h = min(_TILE[0], width - x0), min(_TILE[1], height - y0)
                lens = projection_matrix(k, x0, y0, w, h, camera.near_m, camera.far_m)
                self._before_tile(w, h)
                image = pb.getCameraImage(
                    w,
                    h,
                    view,
                    lens,
                    lightDirection=LIGHT_M,
                    lightAmbientCoeff=0.65,
                    lightDiffuseCoeff=0.4,
                    lightSpecularCoeff=0.0,
                    shadow=0,
                    flags=WITH_LINKS if mask else pb.ER_NO_SEGMENTATION_MASK,
                    renderer=self._device,
                    physicsClientId=self.client,
                )
                rows, columns = slice(y0, y0 + h), slice(x0, x0 + w)
                rgba = np.asarray(image[2], dtype=np.uint8).reshape(h, w, 4)
                for channel in range(3):  # twice as fast as all at once
                    rgb[rows, columns, channel] = rgba[..., channel]
                depth[rows, columns] = np.asarray(image[3], dtype=np.float32).reshape(h, w)
                if mask:
                    owner[rows, columns] = np.asarray(image[4], dtype=np.int32).reshape(h, w)
        return rgb, depth, owner


def _placed(node_id: int, number: int, shape: _Shape, pose: Array, deep: bool) -> Part:
    """A shape whose file's frame is at ``pose``."""
    position = apply(pose, shape.origin_m)[0].tolist()
    turn = quat_from_matrix(pose[:3, :3])
    return Part(node_id, number, shape.id, position, turn, shape.box_m, deep)


def drawing_shift(scene: Scene) -> Array:
    """4x4 that brings the middle of the home's rooms above the world's origin."""
    out = np.eye(4)
    corners = [corner for room in scene.home.rooms for corner in room.polygon_m]
    if corners:
        middle = (np.min(corners, axis=0) + np.max(corners, axis=0)) / 2
        out[:2, 3] = -middle
    out[2, 3] = _FLOOR_Z_M
    return out
