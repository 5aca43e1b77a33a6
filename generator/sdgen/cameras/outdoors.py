"""What is seen of the outdoors through an opening of an outer wall."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from sdgen.cameras.framing import Bools
from sdgen.cameras.pinhole import intrinsics
from sdgen.cameras.sight import HEIGHT, WIDTH, Cast, Ints, target_rays
from sdgen.geometry import Array
from sdgen.scene import Home, Opening


class Rays(NamedTuple):
    """How an opening's rectangle is looked through: rays across and down it, and how far behind it
    they end, metres."""

    across: int
    down: int
    beyond_m: float


#: A door ajar is open by a slit from top to bottom, a twentieth of its rectangle or less: many rays
#: across tell, as many in both, since one column more or less decides. First roughly, past a leaf
#: that opens outwards; what is left, and to count in the end, finely, past all walls of the home.
ROUGH, FINE = Rays(96, 3, 2.0), Rays(96, 12, 25.0)
#: Narrower than this, in pixels at 640x480, a strip of the outdoors tells nobody that a door is
#: open: between hinge and frame 882 to 1,078 pixels, 2 or 3 wide, were taken for a shut door's.
STRIP_PIXELS = 6


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


def in_strips(seen: Bools, least: Array | float) -> Ints:
    """How many of each row of ``seen``, (rows, W), stand beside each other in strips of ``least``
    (rows,) or more, (rows,)."""
    edges = np.diff(np.pad(seen, ((0, 0), (1, 1))).astype(np.int8), axis=1)
    row, first = np.nonzero(edges == 1)
    lengths = np.nonzero(edges == -1)[1] - first
    wide = lengths >= np.broadcast_to(least, len(seen))[row]
    return np.bincount(row[wide], weights=lengths[wide], minlength=len(seen)).astype(np.int64)


def looks_out(
    cast: Cast,
    poses: Sequence[Array],
    opening: Opening | None,
    pixels: float,
    rays: Rays = FINE,
) -> Bools:
    """Which camera poses would see so many pixels, at 640x480, of the outdoors through an opening,
    (poses,), in strips that tell; none through no opening."""
    if opening is None or not len(poses):
        return np.zeros(len(poses), dtype=np.bool_)
    cameras = np.asarray(poses).reshape(-1, 4, 4)
    origins, ends, each = target_rays(cameras, _corners(opening), rays[:2], rays.beyond_m)
    out = np.zeros(len(cameras))
    if len(origins):
        free = (cast(origins, ends).object_id == 0) & passes(opening, origins, ends - origins)
        rows = free.reshape(-1, rays.across)
        least = STRIP_PIXELS / _column_pixels(cameras[each > 0], origins, ends, rays)
        told = in_strips(rows, np.repeat(least, rays.down))
        out[each > 0] = told.reshape(-1, rays.down).sum(axis=1)
    return np.asarray(out * each >= pixels)


def _column_pixels(cameras: Array, origins: Array, ends: Array, rays: Rays) -> Array:
    """How many pixels wide the columns of rays are, for (N, 4, 4) poses, (N,)."""
    two = (ends - origins).reshape(len(cameras), -1, 3)[:, :2] @ cameras[:, :3, :3]
    at = intrinsics(WIDTH, HEIGHT)[0][0] * two[..., 0] / two[..., 2]
    return np.asarray(at[:, 1] - at[:, 0])


def _corners(opening: Opening) -> Array:
    """The corners of an opening in the middle of its wall, (4, 3)."""
    x, y, z = opening.center_m
    half = opening.width_m / 2
    dx, dy = (half, 0.0) if opening.along == "x" else (0.0, half)
    top = z + opening.height_m
    return np.array([(x + s * dx, y + s * dy, at) for s in (-1, 1) for at in (z, top)])
