"""A scene's bodies in Bullet, and pictures of them: what both of its renderers share."""

from __future__ import annotations

from contextlib import ExitStack
from pathlib import Path

import numpy as np
import numpy.typing as npt

from sdgen.geometry import Array, apply, quat_from_matrix
from sdgen.library import Library
from sdgen.library.states import object_from_part
from sdgen.physics.bullet import pb
from sdgen.render.opengl import depth_from_buffer, projection_matrix, scaled, view_matrix
from sdgen.render.protocol import Picture
from sdgen.render.shell import LIGHT_M, ShellFolder, structure_faces
from sdgen.scene import Camera, ObjectInstance, Scene, Structure
from sdgen.scratch import scratch_folder

# The EGL window of the plugin; a larger picture would be scaled up from it without a word.
_TILE = (2560, 2048)

# The plugin's shadow map covers 10 m to each side of the world's origin, and its highlights are
# those a camera 0.26 m above the origin would see. So homes are drawn around the origin, with
# their floors above that camera: then no floor or table top shines.
_FLOOR_Z_M = 0.4

# A ceiling would shut out the light. Bodies with alpha < 1 cast no shadow, but the plugin draws
# them without writing depth: only ceilings, which nothing stands behind, may be like that.
_CEILING_ALPHA = 0.999

# The plugin holds 3.7 million vertices and draws nothing, silently, of what comes after; a third
# is left for the scene that is loaded when the limit is passed.
_VERTEX_LIMIT = 2_500_000

# What origins of parts are moved by, a step each: more than Bullet's rounding, in no direction
# that two parts of a model have in common.
_APART_M = np.array((0.0007, 0.0011, 0.0013))

Rgba = tuple[float, float, float, float]


class BulletGraphics:
    """A Bullet world that is only looked at.

    ``device`` is one of PyBullet's renderers; with ``face_levels`` each face of the shell is
    drawn at the brightness that undoes the EGL plugin's shader.
    """

    def __init__(self, device: int, face_levels: bool) -> None:
        self._device = device
        self._face_levels = face_levels
        self._held = ExitStack()
        self._shell = ShellFolder(self._held.enter_context(scratch_folder()))
        self.client: int = pb.connect(pb.DIRECT)
        #: Visual shape of an OBJ file in a colour, and the middle of its mesh.
        self._shapes: dict[tuple[Path, Rgba], tuple[int, Array]] = {}
        self._bodies: list[int] = []
        self._vertices = 0
        self._set_owners({})
        self._shift = np.eye(4)

    def close(self) -> None:
        """Disconnect; a second call does nothing."""
        if self.client >= 0:
            pb.disconnect(physicsClientId=self.client)
            self.client = -1
            self._held.close()

    def load(self, library: Library, scene: Scene) -> None:
        """Put the scene, moved by :func:`drawing_shift`, into the emptied world."""
        self._clear()
        self._shift = drawing_shift(scene)
        owners: dict[int, tuple[int, int]] = {}
        for structure in sorted(scene.home.structures, key=lambda s: s.id):
            for body in self._add_structure(library, structure):
                owners[body] = (structure.id, 0)
        for item in sorted(scene.objects, key=lambda o: o.id):
            for number, body in enumerate(self._add_object(library, item), start=1):
                owners[body] = (item.id, number)
        self._set_owners(owners)

    def draw(self, camera: Camera) -> Picture:
        """Colour, depth and whose every pixel is."""
        size = (camera.width, camera.height)
        rgb, buffer, body = self._image(camera, np.asarray(camera.K), size, mask=True)
        return Picture(
            rgb=rgb,
            depth_m=depth_from_buffer(buffer, camera.near_m, camera.far_m),
            instance=self._node_of[body],
            part=self._part_of[body],
        )

    def draw_colours(self, camera: Camera, factor: int) -> npt.NDArray[np.uint8]:
        """The camera's colours with ``factor`` times as many pixels along each side."""
        size = (camera.width * factor, camera.height * factor)
        return self._image(camera, scaled(np.asarray(camera.K), factor), size, mask=False)[0]

    def _set_owners(self, owners: dict[int, tuple[int, int]]) -> None:
        # One row more than bodies, zeros, which the mask's background, -1, reads.
        count = max(owners, default=-1) + 2
        self._node_of = np.zeros(count, dtype=np.uint16)
        self._part_of = np.zeros(count, dtype=np.uint8)
        for body, (node_id, part) in owners.items():
            self._node_of[body], self._part_of[body] = node_id, part

    def _clear(self) -> None:
        """Take all bodies away; shapes and textures stay for the next scene.

        ``resetSimulation`` would upload every texture again, which EGL never frees: it is for
        the day when the vertices run out.
        """
        # Last in, first out, so that handles, and with them the order of drawing, come out the
        # same whatever was drawn before: where faces coincide the first one drawn wins.
        for body in reversed(self._bodies):
            pb.removeBody(body, physicsClientId=self.client)
        self._bodies = []
        if self._vertices > _VERTEX_LIMIT:
            pb.resetSimulation(physicsClientId=self.client)
            self._shapes = {}
            self._vertices = 0

    def _add_structure(self, library: Library, structure: Structure) -> list[int]:
        surface = library.surfaces[structure.surface]
        texture = library.surface_texture(structure.surface)
        alpha = _CEILING_ALPHA if structure.category == "ceiling" else 1.0
        bodies = []
        for index, face in enumerate(structure_faces(structure, surface.size_m)):
            path = self._shell.write(face, texture)
            level = face.brightness if self._face_levels else 1.0
            rgba = (level, level, level, alpha)
            bodies.append(self._body(path, rgba, face.vertices_m, index, self._shift))
        return bodies

    def _add_object(self, library: Library, item: ObjectInstance) -> list[int]:
        """A body for each drawn part, in their order."""
        info = library.info(item.asset)
        objs, meshes = library.objs(item.asset), library.mesh(item.asset)
        pose = self._shift @ item.pose.matrix()
        apart = {part.name: index for index, part in enumerate(info.parts)}
        bodies = []
        for name in info.variants[item.variant]:
            red, green, blue, _ = info.part(name).rgba
            # Opaque always: the plugin gives see-through bodies no depth.
            rgba = (red, green, blue, 1.0)
            placed = pose @ object_from_part(info, name, item.joints)
            bodies.append(self._body(objs[name], rgba, meshes[name].vertices, apart[name], placed))
        return bodies

    def _body(self, path: Path, rgba: Rgba, vertices_m: Array, apart: int, pose: Array) -> int:
        """A body that shows an OBJ file at ``pose``.

        Its origin is the middle of the mesh, plus a little for each step ``apart``: the plugin
        draws bodies in the order of their origins' depth, and where faces coincide the first one
        drawn wins. Parts with one common origin would be drawn in an order that depends on what the
        process has drawn before.
        """
        if (path, rgba) not in self._shapes:
            middle = np.round((vertices_m.min(axis=0) + vertices_m.max(axis=0)) / 2, 3)
            middle += apart * _APART_M
            # Triangles share few vertices once normals and texture coordinates count.
            self._vertices += 3 * len(vertices_m)
            made = pb.createVisualShape(
                pb.GEOM_MESH,
                fileName=str(path),
                rgbaColor=rgba,
                visualFramePosition=(-middle).tolist(),
                physicsClientId=self.client,
            )
            self._shapes[path, rgba] = (int(made), middle)
        shape, middle = self._shapes[path, rgba]
        body = pb.createMultiBody(
            0,
            -1,
            shape,
            basePosition=apply(pose, middle)[0].tolist(),
            baseOrientation=quat_from_matrix(pose[:3, :3]),
            physicsClientId=self.client,
        )
        self._bodies.append(int(body))
        return int(body)

    def _image(
        self, camera: Camera, k: Array, size: tuple[int, int], mask: bool
    ) -> tuple[npt.NDArray[np.uint8], npt.NDArray[np.float32], npt.NDArray[np.int32]]:
        """Colour, depth buffer and body of every pixel of a camera's view drawn at ``size``
        (width, height), in tiles no larger than the EGL window."""
        width, height = size
        rgb = np.empty((height, width, 3), dtype=np.uint8)
        depth = np.empty((height, width), dtype=np.float32)
        body = np.empty((height, width), dtype=np.int32)
        view = view_matrix(self._shift @ np.asarray(camera.world_from_camera))
        for y0 in range(0, height, _TILE[1]):
            for x0 in range(0, width, _TILE[0]):
                w, h = min(_TILE[0], width - x0), min(_TILE[1], height - y0)
                lens = projection_matrix(k, x0, y0, w, h, camera.near_m, camera.far_m)
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
                    flags=0 if mask else pb.ER_NO_SEGMENTATION_MASK,
                    renderer=self._device,
                    physicsClientId=self.client,
                )
                rows, columns = slice(y0, y0 + h), slice(x0, x0 + w)
                rgb[rows, columns] = np.asarray(image[2], dtype=np.uint8).reshape(h, w, 4)[..., :3]
                depth[rows, columns] = np.asarray(image[3], dtype=np.float32).reshape(h, w)
                if mask:
                    body[rows, columns] = np.asarray(image[4], dtype=np.int32).reshape(h, w)
        return rgb, depth, body


def drawing_shift(scene: Scene) -> Array:
    """4x4 that brings the middle of the home's rooms above the world's origin."""
    out = np.eye(4)
    corners = [corner for room in scene.home.rooms for corner in room.polygon_m]
    if corners:
        middle = (np.min(corners, axis=0) + np.max(corners, axis=0)) / 2
        out[:2, 3] = -middle
    out[2, 3] = _FLOOR_Z_M
    return out
