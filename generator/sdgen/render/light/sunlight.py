"""Where the sun shines: how far its rays come into a home, as a picture from where it stands."""

from __future__ import annotations

import math

import numpy as np
import numpy.typing as npt

from sdgen.geometry import Array
from sdgen.render.light.world import LightWorld

#: Rays lie so far apart, metres: a window's bar is two of them wide.
_APART_M = 0.025
#: They begin so far before the home, and are drawn over so much beside it, metres.
_BEFORE_M, _BESIDE_M = 5.0, 0.3


class SunMap:
    """Depth along the sun's rays, (H, W): the first thing that each meets.

    ``towards`` is the direction to the sun; ``axes`` are right, up and along the rays, in rows.
    Nothing above ``highest_m`` is lit: light that goes down from windows never reaches higher than
    their tops, but where walls meet a ceiling the map is too coarse to tell.
    """

    def __init__(
        self,
        world: LightWorld,
        towards: Array,
        low_m: Array,
        high_m: Array,
        highest_m: float = math.inf,
    ) -> None:
        along = -towards
        right = np.cross((0.0, 0.0, 1.0), along)
        right /= np.linalg.norm(right)
        self.towards = towards
        self.highest_m = highest_m
        self.axes = np.stack([right, np.cross(along, right), along])
        corners = np.array(
            [(x, y, z) for x in (low_m[0], high_m[0]) for y in (low_m[1], high_m[1])
             for z in (low_m[2], high_m[2])]
        )  # fmt: skip
        seen = corners @ self.axes.T
        self.corner_m = seen.min(axis=0) - _BESIDE_M
        size = seen.max(axis=0) + _BESIDE_M - self.corner_m
        self.step_m = _APART_M
        columns, rows = (math.ceil(k / _APART_M) for k in size[:2])
        u, v = np.meshgrid(np.arange(columns) + 0.5, np.arange(rows) + 0.5)
        start = np.stack([u, v], axis=-1).reshape(-1, 2) * _APART_M + self.corner_m[:2]
        begin = self.corner_m[2] - _BEFORE_M
        origins = start @ self.axes[:2] + begin * along
        far = world.distance_m(origins, np.broadcast_to(along, origins.shape))
        # What meets nothing in the home ends at the ground that it stands on, or light would come
        # in beneath the walls.
        ground = -origins[:, 2] / along[2] if along[2] < 0 else np.full(len(origins), np.inf)
        depth = np.minimum(np.minimum(far, ground) + begin, 1e6)
        self.depth_m = _without_slits(depth.reshape(rows, columns).astype(np.float32))

    def shines(self, points_m: Array, normals: Array) -> Array:
        """How much of the sun's light points (N, 3) on surfaces get, 0 to 1."""
        seen = (points_m + 0.03 * normals) @ self.axes.T
        cell = np.floor((seen[:, :2] - self.corner_m[:2]) / self.step_m).astype(int)
        rows, columns = self.depth_m.shape
        inside = (cell >= 0).all(axis=1) & (cell[:, 0] < columns) & (cell[:, 1] < rows)
        depth = np.full(len(points_m), -np.inf)
        depth[inside] = self.depth_m[cell[inside, 1], cell[inside, 0]]
        lit = (depth > seen[:, 2] - 0.02) & (points_m[:, 2] < self.highest_m)
        return np.asarray(lit * np.clip(normals @ self.towards, 0.0, None))


def _without_slits(depth: npt.NDArray[np.float32]) -> npt.NDArray[np.float32]:
    """The map without what is deep in less than two cells across (a morphological opening): gaps
    beside frames and between slats, which rays so far apart make rows of specks of."""
    least = np.minimum(depth[:-1], depth[1:])
    least = np.minimum(least[:, :-1], least[:, 1:])
    wide = np.pad(least, 1, constant_values=-np.inf)
    most = np.maximum(wide[:-1], wide[1:])
    return np.asarray(np.maximum(most[:, :-1], most[:, 1:]))
