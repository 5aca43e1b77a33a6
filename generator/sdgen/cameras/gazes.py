"""What would be seen of a thing from many places, looking in many directions: by few rays a place.

What hides a thing from an eye does not depend on where the eye looks. So rays are cast from each
eye over the thing alone, each for its share of the sphere; and a ray that is met counts for so
many pixels of every camera there whose picture it is in: f² / cos³ of how far aside it is a
steradian (the Jacobian of the pinhole projection).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from sdgen.cameras.lens import Gaze, Lens, pose_at
from sdgen.cameras.outdoors import STRIP_PIXELS, passes
from sdgen.cameras.sight import Cast, Hits
from sdgen.geometry import Array, look_at, vec3
from sdgen.scene import Opening
from sdgen.vocabulary import REFERENCE_SIZE

Bools = npt.NDArray[np.bool_]

#: Rays along each side of a thing's rectangle, about as many as pixels that tell a thing.
GRID = 16
#: Rays across and down the rectangle of an opening: a slit beside a leaf is narrow.
OPENING_GRID = (96, 12)
#: What is further aside of a thing's middle than this tangent is left out: one stands before it.
_ASIDE = 3.0
_NEAREST_M = 0.05
#: Rays end so far behind a thing, and past all walls of a home behind an opening.
_BEYOND_M, _PAST_HOME_M = 0.5, 25.0
#: Numbers that are held at once when pixels are counted.
_AT_ONCE = 8_000_000


@dataclass(frozen=True, eq=False)
class Glimpse:
    """Unit directions (E, R, 3) of rays from E eyes, and of each the steradians (E, R) that it
    stands for where it met what was wanted, else 0. ``across``: rays beside each other in a row,
    where strips of them count alone."""

    directions: Array
    steradians: Array
    across: int = 0

    def pixels(self, turns: Array, lens: Lens) -> Array:
        """Pixels that cameras with the axes ``turns`` (P, 3, 3), ``world_from_camera``, see of what
        was met, from each eye, (E, P)."""
        eyes, rays, _ = self.directions.shape
        out = np.zeros((eyes, len(turns)))
        some = max(1, _AT_ONCE // max(1, len(turns) * rays))
        for first in range(0, eyes, some):
            part = slice(first, first + some)
            local = np.einsum("erk,pkj->eprj", self.directions[part], turns)
            cosine = np.maximum(local[..., 2], 1e-6)
            x = lens.focal_px * local[..., 0] / cosine
            y = lens.focal_px * local[..., 1] / cosine
            inside = (np.abs(x) <= lens.width / 2) & (np.abs(y) <= lens.height / 2)
            inside &= local[..., 2] > 1e-6
            counted = self.steradians[part, None] * (lens.focal_px**2 / cosine**3) * inside
            if self.across:
                counted *= self._in_strips(counted > 0.0, x, lens)
            out[part] = counted.sum(axis=2)
        return out

    def _in_strips(self, seen: Bools, x: Array, lens: Lens) -> Bools:
        """Which of the seen rays lie in strips that are wide enough to tell, in whole pixels."""
        rows, at = seen.reshape(-1, self.across), x.reshape(-1, self.across)
        width = np.abs(np.diff(at, axis=1, append=2 * at[:, -1:] - at[:, -2:-1]))
        total = np.cumsum(np.where(rows, width, 0.0), axis=1)
        total = np.pad(total, ((0, 0), (1, 0)))
        edges = np.diff(np.pad(rows, ((0, 0), (1, 1))).astype(np.int8), axis=1)
        (row, first), (_, last) = np.nonzero(edges == 1), np.nonzero(edges == -1)
        least = math.ceil(STRIP_PIXELS * lens.width / REFERENCE_SIZE[0])
        tells = total[row, last] - total[row, first] >= least
        marks = np.zeros((len(rows), self.across + 1), dtype=np.int8)
        marks[row[tells], first[tells]] += 1
        marks[row[tells], last[tells]] -= 1
        return np.asarray(np.cumsum(marks, axis=1)[:, :-1].reshape(seen.shape) > 0)


def turns_of(yaws_rad: Sequence[float], pitches_rad: Sequence[float]) -> Array:
    """Axes (P, 3, 3), ``world_from_camera``, of all pitches at all yaws, yaws varying fastest."""
    return np.array(
        [
            pose_at(Gaze(0.0, 0.0, yaw, pitch), 1.0)[:3, :3]
            for pitch in pitches_rad
            for yaw in yaws_rad
        ]
    ).reshape(-1, 3, 3)


def glimpse(
    cast: Callable[[Array, Array], Bools],
    eyes_m: Array,
    points_m: Array,
    grid: tuple[int, int] = (GRID, GRID),
    beyond_m: float = _BEYOND_M,
    across: bool = False,
) -> Glimpse:
    """Rays from eyes (E, 3) over the rectangle around points (N, 3); ``cast`` says which segments
    from origins to targets, (M, 3) each, meet what is wanted."""
    columns, rows = grid
    middle = vec3((points_m.min(axis=0) + points_m.max(axis=0)) / 2)
    turns = np.array([look_at(vec3(eye), middle)[:3, :3] for eye in eyes_m]).reshape(-1, 3, 3)
    local = points_m @ turns - eyes_m[:, None] @ turns
    depth = local[..., 2]
    ahead = depth > _NEAREST_M
    safe = np.where(ahead, depth, 1.0)
    low, high = [], []
    for axis in (0, 1):
        along = local[..., axis] / safe
        low.append(np.maximum(np.where(ahead, along, np.inf).min(axis=1), -_ASIDE))
        high.append(np.minimum(np.where(ahead, along, -np.inf).max(axis=1), _ASIDE))
    size = np.maximum(np.stack(high, axis=1) - np.stack(low, axis=1), 0.0)
    size[~np.isfinite(size)] = 0.0
    start = np.where(np.isfinite(np.stack(low, axis=1)), np.stack(low, axis=1), 0.0)
    u = start[:, None, None, 0] + (np.arange(columns) + 0.5) / columns * size[:, None, None, 0]
    v = start[:, None, None, 1] + ((np.arange(rows) + 0.5) / rows)[:, None] * size[:, None, None, 1]
    u, v = np.broadcast_arrays(u, v)
    flat = np.stack([u, v, np.ones_like(u)], axis=-1).reshape(len(eyes_m), -1, 3)
    length = np.linalg.norm(flat, axis=2)
    each = size.prod(axis=1)[:, None] / (columns * rows) / length**3
    directions = np.einsum("erj,ekj->erk", flat / length[..., None], turns)
    reach = np.linalg.norm(points_m - eyes_m[:, None], axis=2).max(axis=1) + beyond_m
    origins = np.repeat(eyes_m, columns * rows, axis=0)
    targets = origins + (directions * reach[:, None, None]).reshape(-1, 3)
    wanted = (each > 0.0).reshape(-1)
    met = np.zeros(len(origins), dtype=np.bool_)
    if wanted.any():
        met[wanted] = cast(origins[wanted], targets[wanted])
    return Glimpse(directions, each * met.reshape(each.shape), columns if across else 0)


def most_pixels(eyes_m: Array, points_m: Array, lens: Lens) -> Array:
    """More pixels than a camera at each eye (E,) can see of a thing within these points, wherever
    it looks: those of the ball around them, seen in a corner of the picture."""
    middle = (points_m.min(axis=0) + points_m.max(axis=0)) / 2
    radius = float(np.linalg.norm(points_m - middle, axis=1).max())
    far = np.linalg.norm(eyes_m - middle, axis=1)
    sine = np.clip(radius / np.maximum(far, 1e-9), 0.0, 1.0)
    steradians = 2 * math.pi * (1 - np.sqrt(1 - sine**2))
    corner = math.hypot(lens.width, lens.height) / 2 / lens.focal_px
    return np.asarray(steradians * lens.focal_px**2 * (1 + corner**2) ** 1.5)


def of_parts(cast: Cast, object_id: int, parts: npt.NDArray[np.int64]) -> Callable[..., Bools]:
    """Whether segments meet one of these parts of an object first."""

    def met(origins: Array, targets: Array) -> Bools:
        hits: Hits = cast(origins, targets)
        return np.asarray((hits.object_id == object_id) & np.isin(hits.part, parts))

    return met


def through(cast: Cast, opening: Opening) -> Callable[..., Bools]:
    """Whether segments pass through an opening of an outer wall and meet nothing."""

    def met(origins: Array, targets: Array) -> Bools:
        hits: Hits = cast(origins, targets)
        return np.asarray((hits.object_id == 0) & passes(opening, origins, targets - origins))

    return met


def outdoors_glimpse(cast: Cast, eyes_m: Array, opening: Opening) -> Glimpse:
    """The outdoors seen through an opening, in rows whose strips count."""
    x, y, z = opening.center_m
    half = opening.width_m / 2
    dx, dy = (half, 0.0) if opening.along == "x" else (0.0, half)
    top = z + opening.height_m
    corners = np.array([(x + s * dx, y + s * dy, at) for s in (-1, 1) for at in (z, top)])
    rays = through(cast, opening)
    return glimpse(rays, eyes_m, corners, OPENING_GRID, _PAST_HOME_M, across=True)
