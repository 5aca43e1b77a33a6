"""Renders a scene's cameras to frames: colour, depth, and whose every pixel is."""

from __future__ import annotations

import tempfile
from collections.abc import Collection, Iterator, Sequence
from pathlib import Path
from types import TracebackType

import numpy as np
import numpy.typing as npt

from sdgen.cameras.parts import world_triangles
from sdgen.geometry import Array, apply, inverse, matrix, quat_from_matrix
from sdgen.library import Library
from sdgen.library.states import object_from_part
from sdgen.physics.bullet import pb, quiet
from sdgen.render.backend import Choice, Kind, choose_renderer, start_egl
from sdgen.render.coverage import coverage
from sdgen.render.opengl import (
    depth_from_buffer,
    projection_matrix,
    scaled,
    to_millimetres,
    view_matrix,
)
from sdgen.render.outdoors import paint_outdoors
from sdgen.render.shell import LIGHT_M, ShellFolder, structure_faces
from sdgen.scene import Camera, Frame, Scene, Structure

# The EGL window of the plugin; a larger picture would be scaled up from it without a word.
_TILE = (2560, 2048)

# The plugin's shadow map covers 10 m to each side of the world's origin, and its highlights are
# those a camera 0.26 m above the origin would see. So homes are drawn around the origin, with
# their floors above that camera: then no floor or table top shines.
_FLOOR_Z_M = 0.4

# A ceiling would shut out the light. Bodies with alpha < 1 cast no shadow, but the plugin draws
# them without writing depth: only ceilings, which nothing stands behind, may be like that.
_CEILING_ALPHA = 0.999

# The plugin holds 3.7 million vertices and draws nothing, silently, of what comes after.
_VERTEX_LIMIT = 2_500_000

_APART_M = np.array((0.0007, 0.0011, 0.0013))

Rgba = tuple[float, float, float, float]
Pixels = npt.NDArray[np.int64]


class Renderer:
    """Draws scenes with Bullet. One a process (EGL allows no more), used as a context manager.

    ``kind`` is what the user asked for, or the :class:`~sdgen.render.backend.Choice` another
    process has made already. ``renderer_string`` says what drew the pictures. Raises
    RendererError when EGL was asked for and does not start.
    """

    def __init__(self, kind: Kind | Choice = "auto") -> None:
        self.choice = kind if isinstance(kind, Choice) else choose_renderer(kind)
        self.renderer_string = self.choice.renderer_string
        self._folder = tempfile.TemporaryDirectory(prefix="sdgen-shell-")
        self._shell = ShellFolder(Path(self._folder.name))
        self.client: int = pb.connect(pb.DIRECT)
        self._shapes: dict[tuple[Path, Rgba], int] = {}
        self._bodies: list[int] = []
        self._vertices = 0
        self._egl = self.choice.kind == "egl"
        if self._egl:
            found = start_egl(self.client)
            self.renderer_string = found or self.renderer_string
            with quiet():
                self._warm_up()

    def __enter__(self) -> Renderer:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()

    def close(self) -> None:
        """Let go of the graphics; a second call does nothing."""
        if self.client >= 0:
            with quiet():
                pb.disconnect(physicsClientId=self.client)
            self.client = -1
            self._folder.cleanup()

    def render(
        self,
        library: Library,
        scene: Scene,
        cameras: Sequence[Camera],
        sensors: Collection[str] = ("rgb", "depth", "instance"),
        supersample: int = 1,
    ) -> Iterator[Frame]:
        """One frame a camera, in order; none when ``sensors`` is empty.

        With ``supersample`` 2 the colours are drawn at twice the size and averaged; masks and
        depth never are. The scene stays loaded until the iterator is done: finish one before
        beginning the next.
        """
        if not sensors or not cameras:
            return
        owner = self.load(library, scene)
        # The mask's background, -1, reads the last row.
        ids, parts = owner[:, 0].astype(np.uint16), owner[:, 1].astype(np.uint8)
        shift = drawing_shift(scene)
        triangles: dict[int, Array] = {}
        objects = {item.id: item for item in scene.objects}
        ceilings = [s for s in scene.home.structures if s.category == "ceiling"]
        for camera in cameras:
            k = np.asarray(camera.K)
            rgb, buffer, body = self._draw(camera, shift, k, 1, mask=True)
            if supersample > 1 and "rgb" in sensors:
                large, _, _ = self._draw(
                    camera, shift, scaled(k, supersample), supersample, mask=False
                )
                rgb = _box_filter(large, supersample)
            if "rgb" in sensors:
                rgb = paint_outdoors(rgb, body < 0, camera)
            instance = ids[body]
            depth = depth_from_buffer(buffer, camera.near_m, camera.far_m)
            if self._egl:
                _fill_ceilings(depth, instance, camera, ceilings)
            alone: dict[int, int] = {}
            pixels = np.bincount(instance.ravel())
            for key in np.flatnonzero(pixels).tolist():
                if key not in objects:
                    continue
                if key not in triangles:
                    triangles[key] = world_triangles(library, objects[key])
                alone[key] = int(pixels[key]) + _hidden(triangles[key], camera, instance, key)
            yield Frame(
                camera=camera,
                rgb=rgb,
                depth_mm=to_millimetres(depth, instance > 0),
                instance=instance,
                part=parts[body],
                alone_pixels=alone,
            )

    def _warm_up(self) -> None:
        """The first two frames of a process differ from all later ones by a rounding level."""
        view = pb.computeViewMatrix((3, 0, 1), (0, 0, 0), (0, 0, 1))
        lens = pb.computeProjectionMatrixFOV(60, 1.0, 0.1, 10.0)
        box = pb.createVisualShape(
            pb.GEOM_BOX,
            halfExtents=(0.5, 0.5, 0.5),
            rgbaColor=(1, 1, 1, 1),
            physicsClientId=self.client,
        )
        body = pb.createMultiBody(0, -1, box, physicsClientId=self.client)
        for _ in range(3):
            pb.getCameraImage(
                32,
                32,
                view,
                lens,
                lightDirection=LIGHT_M,
                renderer=pb.ER_BULLET_HARDWARE_OPENGL,
                physicsClientId=self.client,
            )
        pb.removeBody(body, physicsClientId=self.client)

    def load(self, library: Library, scene: Scene) -> npt.NDArray[np.int64]:
        """Put the scene, moved by :func:`drawing_shift`, into the emptied world.

        Returns (bodies + 1, 2) of node id and part number. The last row, zeros, is what the
        mask's background (−1) reads.
        """
        self._clear()
        shift = drawing_shift(scene)
        owner: dict[int, tuple[int, int]] = {}
        for structure in sorted(scene.home.structures, key=lambda s: s.id):
            surface = library.surfaces[structure.surface]
            texture = library.surface_texture(structure.surface)
            alpha = _CEILING_ALPHA if structure.category == "ceiling" else 1.0
            for index, face in enumerate(structure_faces(structure, surface.size_m)):
                path = self._shell.write(face, texture)
                level = face.brightness if self._egl else 1.0
                rgba = (level, level, level, alpha)
                owner[self._body(path, rgba, face.vertices_m, index, shift)] = (structure.id, 0)
        for item in sorted(scene.objects, key=lambda o: o.id):
            info = library.info(item.asset)
            objs, meshes = library.objs(item.asset), library.mesh(item.asset)
            pose = shift @ matrix(item.pose.position_m, item.pose.quat_xyzw)
            apart = {part.name: index for index, part in enumerate(info.parts)}
            for number, name in enumerate(info.variants[item.variant], start=1):
                red, green, blue, _ = info.part(name).rgba
                # Opaque always: the plugin gives see-through bodies no depth.
                rgba = (red, green, blue, 1.0)
                placed = pose @ object_from_part(info, name, item.joints)
                body = self._body(objs[name], rgba, meshes[name].vertices, apart[name], placed)
                owner[body] = (item.id, number)
        table = np.zeros((max(owner, default=-1) + 2, 2), dtype=np.int64)
        for body, pair in owner.items():
            table[body] = pair
        return table

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

    def _body(self, path: Path, rgba: Rgba, vertices_m: Array, apart: int, pose: Array) -> int:
        """A body that shows an OBJ file at ``pose``.

        Its origin is the middle of the mesh, plus a little for each step ``apart``: the plugin
        draws bodies in the order of their origins' depth, and where faces coincide the first one
        drawn wins. Parts with one common origin would be drawn in an order that depends on what the
        process has drawn before.
        """
        middle = np.round((vertices_m.min(axis=0) + vertices_m.max(axis=0)) / 2, 3)
        middle += apart * _APART_M
        if (path, rgba) not in self._shapes:
            # Triangles share few vertices once normals and texture coordinates count.
            self._vertices += 3 * len(vertices_m)
            self._shapes[path, rgba] = pb.createVisualShape(
                pb.GEOM_MESH,
                fileName=str(path),
                rgbaColor=rgba,
                visualFramePosition=(-middle).tolist(),
                physicsClientId=self.client,
            )
        body = pb.createMultiBody(
            0,
            -1,
            self._shapes[path, rgba],
            basePosition=apply(pose, middle)[0].tolist(),
            baseOrientation=quat_from_matrix(pose[:3, :3]),
            physicsClientId=self.client,
        )
        self._bodies.append(int(body))
        return int(body)

    def _draw(
        self, camera: Camera, shift: Array, k: Array, factor: int, mask: bool
    ) -> tuple[npt.NDArray[np.uint8], Array, Pixels]:
        """Colour, depth buffer and body of every pixel of a camera's view at ``factor`` times
        its size, in tiles no larger than the EGL window."""
        width, height = camera.width * factor, camera.height * factor
        rgb = np.zeros((height, width, 3), dtype=np.uint8)
        depth = np.ones((height, width))
        body = np.full((height, width), -1, dtype=np.int64)
        view = view_matrix(shift @ np.asarray(camera.world_from_camera))
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
                    renderer=pb.ER_BULLET_HARDWARE_OPENGL if self._egl else pb.ER_TINY_RENDERER,
                    physicsClientId=self.client,
                )
                rows, columns = slice(y0, y0 + h), slice(x0, x0 + w)
                rgb[rows, columns] = np.asarray(image[2], dtype=np.uint8).reshape(h, w, 4)[..., :3]
                depth[rows, columns] = np.asarray(image[3], dtype=np.float64).reshape(h, w)
                if mask:
                    body[rows, columns] = np.asarray(image[4], dtype=np.int64).reshape(h, w)
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


def _hidden(
    triangles: Array, camera: Camera, instance: npt.NDArray[np.uint16], object_id: int
) -> int:
    """Pixels an object would cover with nothing in front of it, beyond those it is seen in."""
    camera_from_world = inverse(np.asarray(camera.world_from_camera))
    local = apply(camera_from_world, triangles.reshape(-1, 3)).reshape(-1, 3, 3)
    k = np.asarray(camera.K)
    mask, rows, columns = coverage(local, k, camera.width, camera.height, camera.near_m)
    return int((mask & (instance[rows, columns] != object_id)).sum())


def _fill_ceilings(
    depth_m: Array,
    instance: npt.NDArray[np.uint16],
    camera: Camera,
    ceilings: Sequence[Structure],
) -> None:
    """Write the depth of ceiling pixels, which the plugin leaves out, from their planes."""
    k, pose = np.asarray(camera.K), np.asarray(camera.world_from_camera)
    for ceiling in ceilings:
        rows, columns = np.nonzero(instance == ceiling.id)
        if len(rows) == 0:
            continue
        underside = min(piece.center_m[2] - piece.size_m[2] / 2 for piece in ceiling.pieces)
        # World-vertical part of the ray that moves one metre along the camera's axis.
        rise = (
            pose[2, 0] * (columns - k[0, 2]) / k[0, 0]
            + pose[2, 1] * (rows - k[1, 2]) / k[1, 1]
            + pose[2, 2]
        )
        depth_m[rows, columns] = (underside - pose[2, 3]) / np.where(rise > 1e-9, rise, np.inf)


def _box_filter(image: npt.NDArray[np.uint8], factor: int) -> npt.NDArray[np.uint8]:
    """Mean of every ``factor`` x ``factor`` block, rounded half up."""
    height, width = image.shape[0] // factor, image.shape[1] // factor
    blocks = image.reshape(height, factor, width, factor, 3).astype(np.uint16)
    area = factor * factor
    mean = (blocks.sum(axis=(1, 3)) + area // 2) // area
    return np.asarray(mean, dtype=np.uint8)
