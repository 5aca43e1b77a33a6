"""What is seen of the outdoors through an opening of an outer wall."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from sdgen.cameras.framing import Bools
from sdgen.cameras.sight import Cast, target_rays
from sdgen.geometry import Array
from sdgen.scene import Home, Opening


class Rays(NamedTuple):
    """How an opening's rectangle is looked through: rays across and down it, and how far behind it
    they end, metres."""

    across: int
    down: int
    beyond_m: float


#: A door ajar is open by a slit from top to bottom, a twentieth of its rectangle or less: many rays
#: across tell, as many in both, since one column more or less decides. To choose views, past a leaf
#: that opens outwards will do; to count in the end, past all walls of the home.
ROUGH, FINE = Rays(96, 3, 2.0), Rays(96, 12, 25.0)


def outer_openings(home: Home) -> tuple[Opening, ...]:
    """The openings whose other side is outdoors."""
    return tuple(opening for opening in home.openings if len(opening.room_ids) == 1)


def outer_opening(home: Home, object_id: int) -> Opening | None:
    """The opening to outdoors that an object fills; None when it fills none."""
    return next((o for o in outer_openings(home) if o.object_id == object_id), None)


def passes(opening: Opening, origins_m: Array, directions: Array) -> Bools:
    """Which rays, from (N, 3) or one origin along (N, 3), pass through an opening, (N,)."""
    along = 0 if opening.along == "x" else 1
    toward = directions[:, 1 - along]
    safe = np.where(toward == 0.0, np.inf, toward)
    steps = (opening.center_m[1 - along] - origins_m[..., 1 - along]) / safe
    at = origins_m + steps[:, None] * directions
    low, high = opening.center_m[2], opening.center_m[2] + opening.height_m
    aside = np.abs(at[:, along] - opening.center_m[along])
    within = (aside <= opening.width_m / 2) & (at[:, 2] >= low) & (at[:, 2] <= high)
    return np.asarray((steps > 0.0) & within)


def looks_out(
    cast: Cast,
    poses: Sequence[Array],
    opening: Opening | None,
    pixels: float,
    rays: Rays = FINE,
) -> Bools:
    """Which camera poses would see so many pixels, at 640x480, of the outdoors through an opening,
    (poses,); none through no opening."""
    if opening is None or not len(poses):
        return np.zeros(len(poses), dtype=np.bool_)
    cameras = np.asarray(poses).reshape(-1, 4, 4)
    origins, ends, each = target_rays(cameras, _corners(opening), rays[:2], rays.beyond_m)
    out = np.zeros(len(cameras))
    if len(origins):
        free = (cast(origins, ends).object_id == 0) & passes(opening, origins, ends - origins)
        out[each > 0] = free.reshape(-1, rays.across * rays.down).sum(axis=1)
    return np.asarray(out * each >= pixels)


def _corners(opening: Opening) -> Array:
    """The corners of an opening in the middle of its wall, (4, 3)."""
    x, y, z = opening.center_m
    half = opening.width_m / 2
    dx, dy = (half, 0.0) if opening.along == "x" else (0.0, half)
    top = z + opening.height_m
    return np.array([(x + s * dx, y + s * dy, at) for s in (-1, 1) for at in (z, top)])
