"""What a camera does to the colours of a picture: exposure, white balance, vignetting, blur, noise.

In linear light, in the order in which lens and sensor do it (Hasinoff et al. 2010 and Foi et al.
2008 for noise: shot noise, whose variance goes with the light, and read noise, which does not).
All arithmetic is of single sums, products and roots, which processors agree on, and of tables that
are rounded: the same bytes everywhere.
"""

from __future__ import annotations

import math
from functools import lru_cache
from statistics import NormalDist

import numpy as np
import numpy.typing as npt

from sdgen.scene import Look
from sdgen.seeding import lane

Light = npt.NDArray[np.float32]
Rgb = npt.NDArray[np.uint8]
#: Half a kernel that is the same to both sides, its middle first.
Taps = tuple[float, ...]

#: Steps of linear light from black to white, a third of a step of sRGB at the darkest.
_STEPS = 16383
#: Tables and kernels are whole multiples of this: no two libraries disagree by as much.
_GRID = 2.0**-20
#: A streak is so many exposures one after another.
_MOMENTS = 33
#: Taps of a kernel below this are left out.
_LEAST_TAP = 1e-3
#: Rows that are worked on at once: all of it stays near the processor.
_BAND = 48
#: Noise has so many values, equally likely: 16 bits are drawn for each.
_VALUES = 2**16


def as_seen(rgb: Rgb, look: Look | None, wraps: bool = False) -> Rgb:
    """The picture (H, W, 3) as a camera with this look takes it; itself without one.

    ``wraps``: its last column is beside its first, as in a panorama.
    """
    if look is None:
        return rgb
    height, width = rgb.shape[:2]
    tables = _exposures(look)
    kept = _corners(height, width, look.vignetting) if look.vignetting else None
    across, down = _taps(look.focus_px, look.motion_px), _taps(look.focus_px, 0.0)
    reach = len(down) - 1
    noise = _noise(look, rgb.size)
    out = np.empty_like(rgb)
    for first in range(0, height, _BAND):
        end = min(first + _BAND, height)
        # With the rows that blur into these; beyond the picture it goes on as it ends.
        rows = np.clip(np.arange(first - reach, end + reach), 0, height - 1)
        light = _exposed(rgb[rows], tables)
        if kept is not None:
            light *= kept[rows]
        light = _blurred(light, across, down, wraps)
        if noise is not None:
            _add_noise(light, noise[3 * width * first : 3 * width * end], look)
        np.clip(light, 0.0, 1.0, out=light)
        light *= np.float32(_STEPS)
        light += np.float32(0.5)
        _srgb().take(light.astype(np.uint16), out=out[first:end], mode="clip")
    return out


def _exposures(look: Look) -> tuple[Light, ...]:
    """Linear light of each value of sRGB, exposed and balanced, (256,) a channel."""
    stops = 2.0**look.exposure_stops
    return tuple(
        _on_grid(_linear() * (stops * gain)).astype(np.float32) for gain in look.white_balance
    )


def _exposed(rgb: Rgb, tables: tuple[Light, ...]) -> Light:
    light = np.empty(rgb.shape, dtype=np.float32)
    for channel, table in enumerate(tables):
        light[..., channel] = table.take(rgb[..., channel])
    return light


@lru_cache(maxsize=8)
def _corners(height: int, width: int, lost: float) -> Light:
    """What of the light each pixel keeps, (H, W, 1): 1 in the middle, 1 - ``lost`` in the corners.

    cos⁴ of the angle to the axis is (1 + tan²)⁻²; the lens is as long as makes up for ``lost``.
    """
    reach = 1.0 / math.sqrt(1.0 - lost) - 1.0
    v = (np.arange(height) - (height - 1) / 2)[:, None]
    u = (np.arange(width) - (width - 1) / 2)[None, :]
    corner = max(((height - 1) / 2) ** 2 + ((width - 1) / 2) ** 2, 1.0)
    kept = 1.0 / (1.0 + reach * (u * u + v * v) / corner) ** 2
    return _on_grid(kept).astype(np.float32)[..., None]


def _blurred(light: Light, across: Taps, down: Taps, wraps: bool) -> Light:
    """Blurred by focus both ways, by motion along the rows (a camera turns, it does not nod);
    without the rows that were only there to blur into others."""
    if len(down) > 1:
        light = _summed(light, down, axis=0)
    if len(across) > 1:
        pad = ((0, 0), (len(across) - 1, len(across) - 1), (0, 0))
        light = _summed(np.pad(light, pad, "wrap" if wraps else "edge"), across, axis=1)
    return light


def _summed(padded: Light, taps: Taps, axis: int) -> Light:
    """The sum of shifted pictures by a kernel that is the same to both sides: ``taps`` from its
    middle on. Pads of ``len(taps) - 1`` on both sides of the axis are gone afterwards."""
    reach = len(taps) - 1
    size = padded.shape[axis] - 2 * reach

    def shifted(by: int) -> Light:
        part = slice(reach + by, reach + by + size)
        return padded[part] if axis == 0 else padded[:, part]

    out = shifted(0) * np.float32(taps[0])
    both = np.empty_like(out)
    for by, tap in enumerate(taps[1:], start=1):
        np.add(shifted(-by), shifted(by), out=both)
        both *= np.float32(tap)
        out += both
    return np.asarray(out)


@lru_cache(maxsize=64)
def _taps(focus_px: float, motion_px: float) -> Taps:
    """The kernel: a Gaussian over each pixel's width, averaged along the
    streak; in all 1."""
    root = focus_px * math.sqrt(2.0)

    def below(edge: float) -> float:
        if root == 0.0:
            return 0.5 + 0.5 * float(np.sign(edge))
        return 0.5 + 0.5 * math.erf(edge / root)

    moments = [motion_px * ((k + 0.5) / _MOMENTS - 0.5) for k in range(_MOMENTS)]
    taps: list[float] = []
    for by in range(1, math.ceil(4 * focus_px + motion_px / 2) + 2):
        tap = sum(below(by + 0.5 - at) - below(by - 0.5 - at) for at in moments) / _MOMENTS
        if tap < _LEAST_TAP:
            break
        taps.append(round(tap / _GRID) * _GRID)
    return (1.0 - 2 * sum(taps), *taps)


def _noise(look: Look, size: int) -> npt.NDArray[np.uint16] | None:
    """What noise each of ``size`` values gets, as numbers of :func:`_normal`: where two pictures of
    one seed are alike, so is their noise."""
    if not (look.shot_noise or look.read_noise):
        return None
    return np.frombuffer(lane(look.noise_seed, 0, "noise").bytes(2 * size), dtype="<u2")


def _add_noise(light: Light, noise: npt.NDArray[np.uint16], look: Look) -> None:
    """Shot and read noise, in place."""
    spread = light * np.float32(look.shot_noise**2)
    spread += np.float32(look.read_noise**2)
    np.sqrt(spread, out=spread)
    spread *= _normal().take(noise).reshape(light.shape)
    light += spread


@lru_cache(maxsize=1)
def _normal() -> Light:
    """Values of a normal distribution of spread 1, each as likely as any other."""
    inverse = NormalDist().inv_cdf
    values = [inverse((k + 0.5) / _VALUES) for k in range(_VALUES // 2, _VALUES)]
    half = _on_grid(np.array(values))
    return np.concatenate([-half[::-1], half]).astype(np.float32)


@lru_cache(maxsize=1)
def _linear() -> npt.NDArray[np.float64]:
    """Linear light of each value of sRGB (IEC 61966-2-1), (256,)."""
    values = np.arange(256) / 255.0
    return np.where(values <= 0.04045, values / 12.92, ((values + 0.055) / 1.055) ** 2.4)


@lru_cache(maxsize=1)
def _srgb() -> Rgb:
    """sRGB of each step of linear light."""
    light = np.arange(_STEPS + 1) / _STEPS
    curved = 1.055 * light ** (1 / 2.4) - 0.055
    values = np.where(light <= 0.0031308, 12.92 * light, curved)
    return np.asarray(np.floor(255.0 * values + 0.5), dtype=np.uint8)


def _on_grid(values: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
    return np.asarray(np.round(values / _GRID) * _GRID)
