"""The picture that a world is painted on: linear colours, and how far away what they show is."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from sdgen.geometry import Array

#: Columns for a full turn: some eleven pixels a degree, where a picture of 640 has seven or eight.
COLUMNS = 4096
LOWEST, HIGHEST = -0.7, 0.7
#: Rows by elevation (sine): as close as columns round the horizon, which windows show, sparser
#: where there is the sky overhead or the ground at one's feet.
_RISE_KNOTS = (HIGHEST, 0.42, -0.36, LOWEST)
_ROW_KNOTS = (0.0, 60.0, 568.0, 640.0)
ROWS = int(_ROW_KNOTS[-1]) + 1
#: How wide a pixel is, in radians: what is finer than that is to be drawn fainter.
PIXEL = float(2 * np.pi / COLUMNS)

#: So far one sees through air as if there were none, metres.
_CLEAR_M = 40.0

Floats = npt.NDArray[np.float32]
Ints = npt.NDArray[np.intp]


def row_of(rise: Array) -> Array:
    """The row, with its fraction, of elevations given as sines."""
    return np.asarray(np.interp(-rise, [-knot for knot in _RISE_KNOTS], _ROW_KNOTS))


class Canvas:
    """All the way round an eye over the ground. Columns go with the azimuth, rows down; what is
    put there hides what is farther away. The nearest first, little is painted twice."""

    def __init__(self, eye_m: float) -> None:
        turn = (np.arange(COLUMNS) + 0.5) / COLUMNS * 2 * np.pi
        rise = np.interp(np.arange(ROWS), _ROW_KNOTS, _RISE_KNOTS)
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

    def before(self, rows: slice, columns: Ints) -> Floats:
        """How far away is what stands in a window of the picture, (R, C)."""
        if int(columns[-1]) - int(columns[0]) + 1 == len(columns):
            return self.far_m[rows, int(columns[0]) : int(columns[-1]) + 1]
        # Round the seam, or with gaps.
        return np.asarray(self.far_m[rows][:, columns])

    def fill(self, places: Ints, far_m: Array | Floats | float, colours: Floats) -> None:
        """Paint colours (N, 3) that lie so far away at places counted along the rows."""
        far = np.broadcast_to(np.asarray(far_m, dtype=np.float32), places.shape)
        # Near by there is none that one would see.
        deep = np.nonzero(far > _CLEAR_M)[0]
        if len(deep):
            clear = np.exp(far[deep] * np.float32(-1 / self.haze_m))[:, None]
            hazy = self.haze.take(places[deep] & (COLUMNS - 1), axis=0)
            if len(deep) == len(places):
                colours = hazy + (colours - hazy) * clear
            else:
                colours[deep] = hazy + (colours[deep] - hazy) * clear
        self.colours.reshape(-1, 3)[places] = colours
        self.far_m.reshape(-1)[places] = far

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


def places_of(rows: Ints, columns: Ints) -> Ints:
    """Places of a picture counted along its rows."""
    return np.asarray(rows * COLUMNS + columns, dtype=np.intp)


def noise(rng: np.random.Generator, size: int, slope: float, first: float = 1.0) -> Floats:
    """A field that repeats at its edges, (size, size), of mean 0 and deviation 1: waves from
    ``first`` to the field's width on, weaker the finer they are by ``slope``."""
    spectrum = np.fft.rfft2(rng.standard_normal((size, size)))
    up, along = np.fft.fftfreq(size, 1 / size)[:, None], np.fft.rfftfreq(size, 1 / size)[None, :]
    often = np.hypot(up, along)
    weight = np.where(often >= first, 1 / np.maximum(often, 1) ** slope, 0)
    field = np.fft.irfft2(spectrum * weight, s=(size, size))
    return np.asarray(field / field.std(), dtype=np.float32)


def _cells(x: Array | Floats, size: int) -> npt.NDArray[np.int32]:
    """The cells of a repeating field in which places lie."""
    return np.asarray(np.floor(x).astype(np.int32) & (size - 1))


def looked_up(field: Floats, x: Array | Floats, y: Array | Floats) -> Floats:
    """A repeating field at places counted in its cells."""
    size = len(field)
    return np.asarray(field.reshape(-1).take(_cells(y, size) * size + _cells(x, size)))


def between(field: Floats, x: Floats, y: Floats) -> Floats:
    """The same, drawn out between the cells: for what is looked at closely."""
    size, flat = len(field), field.reshape(-1)
    left, top = _cells(x, size), _cells(y, size) * size
    right, below = (left + 1) & (size - 1), (top + size) & (size * size - 1)
    across, down = x - np.floor(x), y - np.floor(y)
    above, under = flat.take(top + left), flat.take(below + left)
    above += (flat.take(top + right) - above) * across
    under += (flat.take(below + right) - under) * across
    above += (under - above) * down
    return np.asarray(above, dtype=np.float32)


def soft(low: float, high: float, value: Array | Floats) -> Floats:
    """0 below ``low``, 1 above ``high``, smooth between."""
    t = np.clip((np.asarray(value, dtype=np.float32) - low) / (high - low), 0, 1)
    return np.asarray(t * t * (3 - 2 * t), dtype=np.float32)


def linear(*eight_bit: float) -> Floats:
    """An sRGB colour from 0 to 255 in linear light."""
    share = np.array(eight_bit, dtype=np.float64) / 255
    bright = ((share + 0.055) / 1.055) ** 2.4
    return np.where(share <= 0.04045, share / 12.92, bright).astype(np.float32)
