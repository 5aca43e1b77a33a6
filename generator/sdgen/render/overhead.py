"""What the EGL plugin draws without depth: ceilings, and lamps that hug them.

Both are drawn see-through, for what is opaque there would put the floor in shadow, and what is
see-through throws none. But it has no depth either; that is found here.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from sdgen.cameras.parts import world_triangles
from sdgen.geometry import Array
from sdgen.library import Library
from sdgen.render.shell import ceiling_level_m
from sdgen.scene import Camera, ObjectInstance, Scene, Structure

#: What ends so near the ceiling hugs it, if it hangs down no further than this, metres.
TOUCH_M, DEEP_M = 0.02, 0.3
#: A corner may stand so far out of the plane of a face of what is convex: rounding of meshes.
FLAT_M = 5e-4


@dataclass(frozen=True)
class Solid:
    """A convex thing: planes (N, 4) of its faces, normal and offset, outside above 0."""

    node_id: int
    planes: Array


def overhead(library: Library, scene: Scene) -> tuple[Solid, ...]:
    """The fixed things that hug a ceiling and are convex: of these no face hides another, so that
    they can be drawn without depth."""
    ceiling_m = ceiling_level_m(scene.home.structures)
    found = (_solid(library, item, ceiling_m) for item in scene.objects if item.fixed)
    return tuple(solid for solid in found if solid is not None)


def _solid(library: Library, item: ObjectInstance, ceiling_m: float) -> Solid | None:
    # Most things are told apart without a look at their mesh.
    if not ceiling_m - DEEP_M <= item.pose.position_m[2] < ceiling_m:
        return None
    triangles = world_triangles(library, item).reshape(-1, 3, 3)
    if abs(float(triangles[..., 2].max()) - ceiling_m) > TOUCH_M:
        return None
    normals = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    sizes = np.linalg.norm(normals, axis=1)
    normals, corners = normals[sizes > 0] / sizes[sizes > 0, None], triangles[sizes > 0, 0]
    offsets = -(normals * corners).sum(axis=1)
    if float((triangles.reshape(-1, 3) @ normals.T + offsets).max()) > FLAT_M:
        return None
    return Solid(item.id, np.column_stack([normals, offsets]))


def fill_overhead(
    depth_m: Array, instance: npt.NDArray[np.uint16], camera: Camera, solids: Sequence[Solid]
) -> None:
    """Write the depth of the pixels of these things: where a ray has come in through all planes
    that face it."""
    k, pose = np.asarray(camera.K), np.asarray(camera.world_from_camera)
    for solid in solids:
        shown = instance == solid.node_id
        if not shown.any():
            continue
        rows, columns = np.nonzero(shown)
        x, y = (columns - k[0, 2]) / k[0, 0], (rows - k[1, 2]) / k[1, 1]
        rays = np.column_stack([x, y, np.ones(len(x))]) @ pose[:3, :3].T
        towards = rays @ solid.planes[:, :3].T
        away = solid.planes[:, :3] @ pose[:3, 3] + solid.planes[:, 3]
        with np.errstate(divide="ignore", invalid="ignore"):
            depths = np.where(towards < -1e-9, -away / towards, -np.inf)
        depth_m[rows, columns] = depths.max(axis=1)


def fill_ceilings(
    depth_m: Array,
    instance: npt.NDArray[np.uint16],
    camera: Camera,
    ceilings: Sequence[Structure],
) -> None:
    """Write the depth of ceiling pixels, from their planes."""
    k, pose = np.asarray(camera.K), np.asarray(camera.world_from_camera)
    for ceiling in ceilings:
        shown = instance == ceiling.id
        if not shown.any():  # most ceilings of a home, and much cheaper than to list no pixels
            continue
        rows, columns = np.nonzero(shown)
        underside = min(piece.center_m[2] - piece.size_m[2] / 2 for piece in ceiling.pieces)
        # World-vertical part of the ray that moves one metre along the camera's axis.
        rise = (
            pose[2, 0] * (columns - k[0, 2]) / k[0, 0]
            + pose[2, 1] * (rows - k[1, 2]) / k[1, 1]
            + pose[2, 2]
        )
        depth_m[rows, columns] = (underside - pose[2, 3]) / np.where(rise > 1e-9, rise, np.inf)
