"""The picture that a world is painted on: linear colours, and how far away what they show is."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from sdgen.geometry import Array

#: Columns for a full turn, and rows between the lowest and the highest elevation (sine): some six
#: pixels a degree, as many as a picture of 640 pixels has.
COLUMNS, ROWS = 2048, 320
LOWEST, HIGHEST = -0.7, 0.7

Floats = npt.NDArray[np.float32]


class Canvas:
    """All the way round an eye over the ground. Columns go with the azimuth, rows down; what is
    put there hides what is farther away."""

    def __init__(self, eye_m: float) -> None:
        turn = (np.arange(COLUMNS) + 0.5) / COLUMNS * 2 * np.pi
        rise = np.linspace(HIGHEST, LOWEST, ROWS)
        self.eye_m = eye_m
        #: Level directions (2, COLUMNS), and what a ray climbs a metre of its way, (ROWS,).
        self.ways: Floats = np.stack([np.cos(turn), np.sin(turn)]).astype(np.float32)
        self.climbs: Floats = (rise / np.sqrt(1 - rise**2)).astype(np.float32)
        self.rises: Floats = rise.astype(np.float32)
        self.colours: Floats = np.zeros((ROWS, COLUMNS, 3), dtype=np.float32)
        self.far_m: Floats = np.full((ROWS, COLUMNS), np.inf, dtype=np.float32)
        #: Colours (COLUMNS, 3) that what is far away fades into, and how fast, metres.
        self.haze: Floats = np.zeros((COLUMNS, 3), dtype=np.float32)
        self.haze_m = 1000.0

    def rows(self, low: float, high: float) -> slice:
        """The rows whose rays climb from ``low`` to ``high``."""
        first = int(np.searchsorted(-self.climbs, -high))
        return slice(first, int(np.searchsorted(-self.climbs, -low, side="right")))

    def put(
        self,
        rows: slice,
        columns: npt.NDArray[np.intp],
        far_m: Array | Floats,
        colours: Array | Floats,
        share: Array | Floats,
    ) -> None:
        """Paint colours (R, C, 3) that lie so far (R, C), or (C,), away where nothing nearer is,
        covering a share (R, C) of what is there."""
        window = (rows, slice(int(columns[0]), int(columns[-1]) + 1))
        if int(columns[-1]) - int(columns[0]) + 1 != len(columns):
            # Round the seam, or with gaps.
            window = np.ix_(np.arange(rows.start, rows.stop), columns)  # type: ignore[assignment]
        before_m, before = self.far_m[window], self.colours[window]
        far = np.broadcast_to(np.asarray(far_m, dtype=np.float32), before_m.shape)
        seen = np.where(far < before_m, share, np.float32(0)).astype(np.float32)
        clear = np.exp(-far / np.float32(self.haze_m))[..., None]
        hazy = colours * clear + self.haze[columns] * (1 - clear)
        self.colours[window] = before + (hazy - before) * seen[..., None]
        self.far_m[window] = np.where(seen > 0.5, far, before_m)

    def add(self, azimuth: float, rise: float, radius: float, colour: Array) -> None:
        """Light round a lamp or the moon: it fades with the angle from there, in radians."""
        reach = 3.0 * radius
        across = int(np.ceil(reach / (2 * np.pi) * COLUMNS))
        middle = azimuth / (2 * np.pi) * COLUMNS
        columns = np.arange(int(middle) - across, int(middle) + across + 1)
        rows = np.nonzero(np.abs(self.rises - rise) < reach)[0]
        if len(rows) == 0:
            return
        aside = (columns + 0.5 - middle) / COLUMNS * 2 * np.pi
        away = np.hypot(aside[None, :], (self.rises[rows] - rise)[:, None]) / radius
        window = np.ix_(rows, columns % COLUMNS)
        light = np.clip(1 - away / 3, 0, 1) ** 2 * np.exp(-away)
        self.colours[window] += (light[..., None] * colour).astype(np.float32)


def noise(rng: np.random.Generator, size: int, slope: float, first: float = 1.0) -> Floats:
    """A field that repeats at its edges, (size, size), of mean 0 and deviation 1: waves from
    ``first`` to the field's width on, weaker the finer they are by ``slope``."""
    spectrum = np.fft.rfft2(rng.standard_normal((size, size)))
    up, along = np.fft.fftfreq(size, 1 / size)[:, None], np.fft.rfftfreq(size, 1 / size)[None, :]
    often = np.hypot(up, along)
    weight = np.where(often >= first, 1 / np.maximum(often, 1) ** slope, 0)
    field = np.fft.irfft2(spectrum * weight, s=(size, size))
    return np.asarray(field / field.std(), dtype=np.float32)


def looked_up(field: Floats, x: Array | Floats, y: Array | Floats) -> Floats:
    """A repeating field at places counted in its cells."""
    size = len(field)
    rows, columns = (np.floor(a).astype(np.int32) & (size - 1) for a in (y, x))
    return np.asarray(field[rows, columns], dtype=np.float32)


def soft(low: float, high: float, value: Array | Floats) -> Floats:
    """0 below ``low``, 1 above ``high``, smooth between."""
    t = np.clip((np.asarray(value, dtype=np.float32) - low) / (high - low), 0, 1)
    return np.asarray(t * t * (3 - 2 * t), dtype=np.float32)


def linear(*eight_bit: float) -> Floats:
    """An sRGB colour from 0 to 255 in linear light."""
    share = np.array(eight_bit, dtype=np.float64) / 255
    bright = ((share + 0.055) / 1.055) ** 2.4
    return np.where(share <= 0.04045, share / 12.92, bright).astype(np.float32)
