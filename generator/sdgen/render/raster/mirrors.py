"""Mirrors of a scene, and the cameras that see what is in them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from sdgen.geometry import Array
from sdgen.render.raster.drawn import Drawn
from sdgen.scene import Camera

#: So many are looked into in one picture, the largest; smaller ones than so many pixels are not.
_MOST, _LEAST_PIXELS = 2, 40
#: What is seen in others: of this colour.
DULL = (150.0, 158.0, 160.0)
#: Faces belong to one side of a pane when their normals are nearly the same.
_SAME_SIDE = 0.99
#: Pictures in mirrors are as wide and high as a whole number of these pixels: few sizes are kept.
_GRAIN = 64
#: What is nearer to a mirror than this, metres, is not seen in it: it is the mirror.
_BEFORE_M = 0.003


class Mirror(NamedTuple):
    """Whose it is, which of its drawn parts, and its triangles in the world, (F, 3, 3)."""

    node_id: int
    number: int
    corners_m: Array

    def plane(self, eye_m: Array) -> tuple[Array, Array]:
        """A point on the side that faces an eye, and its normal."""
        cross = np.cross(
            self.corners_m[:, 1] - self.corners_m[:, 0], self.corners_m[:, 2] - self.corners_m[:, 0]
        )
        areas = np.linalg.norm(cross, axis=1)
        normals = cross / np.maximum(areas, 1e-12)[:, None]
        normal = normals[np.argmax(areas)]
        middle = self.corners_m.reshape(-1, 3).mean(axis=0)
        normal = normal if normal @ (eye_m - middle) > 0 else -normal
        side = normals @ normal > _SAME_SIDE
        # A sheet has one side only.
        side = side if side.any() else np.abs(normals @ normal) > _SAME_SIDE
        return self.corners_m[side].reshape(-1, 3).mean(axis=0), normal


class Looked(NamedTuple):
    """A camera that sees what is in a mirror: its pixel (0, 0) is pixel ``at`` (column, row) of the
    picture that the mirror is in; ``keep``: of points x what ``keep`` . (x, 1) > 0 lies before."""

    camera: Camera
    at: tuple[int, int]
    keep: tuple[float, float, float, float]


def mirrors_of(parts: Sequence[Drawn]) -> list[Mirror]:
    """All mirrors that are whole."""
    return [
        Mirror(part.node_id, part.number, part.vertices[part.faces].astype(np.float64))
        for part in parts
        if part.mirrors
    ]


def largest(counts: Sequence[int]) -> list[int]:
    """Which of the mirrors that cover so many pixels are looked into."""
    order = sorted(range(len(counts)), key=lambda k: -counts[k])
    return [k for k in order[:_MOST] if counts[k] >= _LEAST_PIXELS]


def looked_into(mirror: Mirror, camera: Camera, seen: npt.NDArray[np.bool_]) -> Looked | None:
    """What sees in the mirror the pixels ``seen`` of a camera's picture, (H, W); None from behind.

    The camera is turned over at the mirror's plane: so a thing and its image lie on one ray.
    """
    pose = np.asarray(camera.world_from_camera)
    point, normal = mirror.plane(pose[:3, 3])
    if normal @ (pose[:3, 3] - point) <= _BEFORE_M:
        return None
    over = np.eye(4)
    over[:3, :3] -= 2 * np.outer(normal, normal)
    over[:3, 3] = 2 * (normal @ point) * normal
    rows, columns = np.flatnonzero(seen.any(axis=1)), np.flatnonzero(seen.any(axis=0))
    left, top = int(columns[0]), int(rows[0])
    width, height = (
        -(-(int(one[-1]) + 1 - int(one[0])) // _GRAIN) * _GRAIN for one in (columns, rows)
    )
    k = np.array(camera.K)
    k[:2, 2] -= left, top
    cropped = camera.model_copy(
        update={
            "K": tuple(map(tuple, k.tolist())),
            "width": width,
            "height": height,
            "world_from_camera": tuple(map(tuple, (over @ pose).tolist())),
        }
    )
    x, y, z = normal.tolist()
    return Looked(cropped, (left, top), (x, y, z, -float(normal @ point) - _BEFORE_M))
