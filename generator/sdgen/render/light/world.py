"""What light meets in a home: the triangles of what stands there, and how much each gives on."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt
from embreex import rtcore_scene
from embreex.mesh_construction import TriangleMesh

from sdgen.geometry import Array
from sdgen.render.light.colour import albedo_of
from sdgen.render.raster.drawn import Drawn

#: What is smaller than this, metres, throws no light back and no shade: it gets a contact shade.
_LARGE_M = 0.25
#: Rugs and what is spilt lie as flat as the floor they hide.
_FLAT_M = 0.03


_NONE = np.zeros((0, 3, 3))


class Met(NamedTuple):
    """What rays (N,) met: whether anything, where, the normal towards the light's side, the share
    of light that is given on (N, 3), and whether it was met from behind."""

    hit: npt.NDArray[np.bool_]
    point_m: Array
    normal: Array
    albedo: Array
    behind: npt.NDArray[np.bool_]
    distance_m: Array


class LightWorld:
    """The large parts of a scene and, where it is ``roofed``, a roof over them, for rays."""

    def __init__(self, parts: Sequence[Drawn], roofed: bool) -> None:
        large = [part for part in parts if _large(part)]
        corners = [part.vertices[part.faces] for part in large]
        roof = _roof(np.concatenate([part.box for part in large])) if roofed else _NONE
        self._triangles = np.concatenate([*corners, roof]).astype(np.float32)
        counts = [len(part.faces) for part in large]
        shell = np.repeat([part.number == 0 for part in large], counts)
        self._shell = np.concatenate([shell, np.ones(len(roof), dtype=bool)])
        albedo = np.array([albedo_of(part) for part in large]).reshape(-1, 3)
        self._albedo = np.concatenate([np.repeat(albedo, counts, axis=0), np.zeros((len(roof), 3))])
        sides = self._triangles[:, 1:] - self._triangles[:, :1]
        normals = np.cross(sides[:, 0], sides[:, 1]).astype(np.float64)
        length = np.linalg.norm(normals, axis=1, keepdims=True)
        self._normals = normals / np.maximum(length, 1e-12)
        self._scene = rtcore_scene.EmbreeScene()
        self._mesh = TriangleMesh(self._scene, self._triangles)

    def meet(self, origins_m: Array, directions: Array) -> Met:
        """The first thing that each ray (N, 3) meets; directions of length 1."""
        found = self._run(origins_m, directions)
        number, distance = found["primID"], found["tfar"].astype(np.float64)
        hit = number >= 0
        number = np.where(hit, number, 0)
        distance = np.where(hit, distance, np.inf)
        normal = self._normals[number]
        behind = hit & ((normal * directions).sum(axis=1) > 0)
        normal = np.where(behind[:, None], -normal, normal)
        point = origins_m + directions * np.where(hit, distance, 0.0)[:, None]
        return Met(hit, point, normal, self._albedo[number], behind, distance)

    def distance_m(self, origins_m: Array, directions: Array) -> Array:
        """How far each ray (N, 3) goes before it meets something; inf: for ever."""
        found = self._run(origins_m, directions)
        return np.where(found["primID"] >= 0, found["tfar"].astype(np.float64), np.inf)

    def shade(self, origins_m: Array, directions: Array) -> tuple[Array, npt.NDArray[np.bool_]]:
        """How far each ray (N, 3) goes, and whether the home's shell ends it or nothing does."""
        found = self._run(origins_m, directions)
        number = found["primID"]
        hit = number >= 0
        distance = np.where(hit, found["tfar"].astype(np.float64), np.inf)
        return distance, ~hit | self._shell[np.where(hit, number, 0)]

    def _run(self, origins_m: Array, directions: Array) -> dict[str, npt.NDArray[Any]]:
        found: dict[str, npt.NDArray[Any]] = self._scene.run(
            np.ascontiguousarray(origins_m, dtype=np.float32),
            np.ascontiguousarray(directions, dtype=np.float32),
            query="INTERSECT",
            output=True,
        )
        return found


def _roof(corners_m: Array) -> Array:
    """Two triangles over all of a home: walls are hollow, and open at their top."""
    (x0, y0, _), (x1, y1, _) = corners_m.min(axis=0) - 0.1, corners_m.max(axis=0) + 0.1
    top = corners_m[:, 2].max()
    a, b, c, d = (x0, y0, top), (x1, y0, top), (x1, y1, top), (x0, y1, top)
    return np.array([(a, b, c), (a, c, d)])


def _large(part: Drawn) -> bool:
    if part.number == 0:
        return True
    size = np.ptp(part.box, axis=0)
    see_through = part.clear or part.translucent or part.glows
    return not see_through and bool(size.max() > _LARGE_M and size[2] > _FLAT_M)
