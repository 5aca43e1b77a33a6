"""Panoramas: the views of a turn, and two up and down, sampled to one equirectangular picture."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import lru_cache
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from sdgen.cameras.turn import poles_of
from sdgen.geometry import Array
from sdgen.scene import Camera, Panorama

Rgb = npt.NDArray[np.uint8]
Ids = npt.NDArray[np.uint16]
Ints = npt.NDArray[np.int32]

#: Colours between pixels are mixed in parts of this.
_PARTS = 256
#: Where a picture ends, what is nearest to its last pixels still counts as seen.
_HALF_PIXEL = 0.5


class _Samples(NamedTuple):
    """Which pixels of a panorama one picture fills (numbers, (N,)), and from which of its own: the
    nearest; the one to the left and above, and how far it is from there to the right and down."""

    filled: Ints
    nearest: Ints
    corner: Ints
    right: npt.NDArray[np.uint16]
    down: npt.NDArray[np.uint16]


def stitched_rgb(panorama: Panorama, view: Camera, pictures: Sequence[Rgb]) -> Rgb:
    """Colours (H, W, 3) of a panorama from those of its turn, in order, and then of its poles
    (:func:`~sdgen.cameras.turn.poles_of`); black where none of them sees. ``view`` is one of the
    turn's cameras."""
    out = np.zeros((panorama.height * panorama.width, 3), dtype=np.uint8)
    for picture, one in zip(pictures, _samples_of(panorama, view), strict=False):
        width = picture.shape[1]
        flat = picture.reshape(-1, 3)
        right, down = one.right[:, None], one.down[:, None]
        above = _mixed(flat[one.corner], flat[one.corner + 1], right)
        below = _mixed(flat[one.corner + width], flat[one.corner + width + 1], right)
        out[one.filled] = _mixed(above, below, down)
    return out.reshape(panorama.height, panorama.width, 3)


def stitched_ids(panorama: Panorama, view: Camera, masks: Sequence[Ids]) -> Ids:
    """Node ids (H, W) of a panorama, as :func:`stitched_rgb` has its colours, but those of the
    nearest pixels; 0 where none of the ``masks`` sees."""
    out = np.zeros(panorama.height * panorama.width, dtype=np.uint16)
    for mask, one in zip(masks, _samples_of(panorama, view), strict=False):
        out[one.filled] = mask.ravel()[one.nearest]
    return out.reshape(panorama.height, panorama.width)


def seen_by_turn(panorama: Panorama, view: Camera) -> npt.NDArray[np.bool_]:
    """Which pixels (H, W) of a panorama are those of its turn's views; the rest are its poles'."""
    out = np.zeros(panorama.height * panorama.width, dtype=np.bool_)
    for one in _samples_of(panorama, view)[: len(panorama.views)]:
        out[one.filled] = True
    return out.reshape(panorama.height, panorama.width)


def _mixed(one: Rgb, other: Rgb, part: npt.NDArray[np.uint16]) -> Rgb:
    mixed = one * (_PARTS - part) + other * part + np.uint16(_PARTS // 2)
    return np.asarray(mixed >> 8, dtype=np.uint8)


def _samples_of(panorama: Panorama, view: Camera) -> tuple[_Samples, ...]:
    poles = poles_of(panorama, view)
    lenses = tuple((one.width, one.height, one.K) for one in (view, poles[0]))
    return _samples((panorama.width, panorama.height), len(panorama.views), *lenses)


_Lens = tuple[int, int, tuple[tuple[float, float, float], ...]]


@lru_cache(maxsize=2)
def _samples(size: tuple[int, int], count: int, view: _Lens, pole: _Lens) -> tuple[_Samples, ...]:
    """The samples of ``count`` views of a turn, of the view up and of the one down: the same for
    every panorama of a build, since each begins with its first view in the middle."""
    width, height = size
    # Rows first, so that each picture's samples are near one another in both pictures.
    right = (np.arange(width) - (width - 1) / 2) * (2 * math.pi / width)
    up = ((height - 1) / 2 - np.arange(height)) * (math.pi / height)
    longitude, latitude = (one.ravel() for one in np.meshgrid(right, up))
    level, rise = np.cos(latitude), np.sin(latitude)
    step = 2 * math.pi / count
    # A turn goes to the left, longitudes to the right.
    owner = np.round(-longitude / step).astype(int) % count
    left = np.arange(len(longitude))
    out = []
    for k in range(count):
        mine = left[owner == k]
        around = longitude[mine] + k * step
        axes = level[mine] * np.sin(around), -rise[mine], level[mine] * np.cos(around)
        out.append(_sampled(mine, axes, view))
    seen = np.zeros(len(longitude), dtype=np.bool_)
    for one in out:
        seen[one.filled] = True
    for sign in (1.0, -1.0):
        mine = left[~seen & (sign * rise > 0)]
        across, ahead = np.sin(longitude[mine]), np.cos(longitude[mine])
        axes = level[mine] * across, sign * level[mine] * ahead, sign * rise[mine]
        out.append(_sampled(mine, axes, pole))
    return tuple(out)


def _sampled(
    among: npt.NDArray[np.int64], axes: tuple[Array, Array, Array], lens: _Lens
) -> _Samples:
    """Of the panorama's pixels ``among``, in these directions (right, down, ahead), those that a
    picture shows."""
    width, height, k = lens
    x, y, z = axes
    ahead = z > 1e-6
    depth = np.where(ahead, z, 1.0)
    u, v = k[0][0] * x / depth + k[0][2], k[1][1] * y / depth + k[1][2]
    ahead &= (np.abs(u - k[0][2]) <= width / 2) & (np.abs(v - k[1][2]) <= height / 2)
    u, v = u[ahead], v[ahead]
    columns, rows = (
        np.clip(np.floor(at + _HALF_PIXEL), 0, most - 1).astype(np.int32)
        for at, most in ((u, width), (v, height))
    )
    left, top = (
        np.clip(np.floor(at), 0, max(most - 2, 0)).astype(np.int32)
        for at, most in ((u, width), (v, height))
    )
    right, down = (
        np.clip(np.floor((at - first) * _PARTS + _HALF_PIXEL), 0, _PARTS).astype(np.uint16)
        for at, first in ((u, left), (v, top))
    )
    return _Samples(
        among[ahead].astype(np.int32), rows * width + columns, top * width + left, right, down
    )
