"""A crop as a row of numbers: histograms of edges and colours, the mask's shape, its place.

Edges as histograms of oriented gradients (Dalal and Triggs, 2005).
"""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from sdgen.detectors.pictures import PLACE, SIDE, Bytes, Crops, Floats

#: Cells of edges along a side, and directions told apart.
CELLS, DIRECTIONS = 6, 8
#: Bins of each colour, of the thing and of what is around it; cells of small pictures.
BINS, SMALL = 8, 8
#: Columns: edges of all and of the thing alone, colours twice, moments, small picture and mask.
WIDTH = (
    CELLS * CELLS * DIRECTIONS + DIRECTIONS + 2 * 3 * BINS + 2 * 6 + SMALL * SMALL * 4 + len(PLACE)
)
Real = npt.NDArray[np.floating]
#: Crops at once.
_LOT = 512


def columns_of(crops: Crops) -> Floats:
    """Rows of crops, (n, WIDTH)."""
    lots = [
        _columns(crops.pixels[k : k + _LOT], crops.place[k : k + _LOT])
        for k in range(0, len(crops.pixels), _LOT)
    ]
    return np.concatenate(lots) if lots else np.zeros((0, WIDTH), dtype=np.float32)


def _columns(pixels: Bytes, place: Floats) -> Floats:
    n = len(pixels)
    rgb = pixels[..., :3].astype(np.float32) / 255
    mask = pixels[..., 3].astype(np.float32) / 255
    opponent = np.stack(
        [rgb.mean(axis=-1), rgb[..., 0] - rgb[..., 1], rgb[..., 2] - rgb[..., :2].mean(axis=-1)], -1
    )
    small = pixels.astype(np.float32).reshape(n, SMALL, SIDE // SMALL, SMALL, SIDE // SMALL, 4)
    return np.hstack(
        [
            _edges(opponent[..., 0], mask),
            _colours(opponent, mask),
            _colours(opponent, 1 - mask),
            (small.mean(axis=(2, 4)) / 255).reshape(n, -1),
            place,
        ]
    ).astype(np.float32)


def _edges(gray: Real, mask: Real) -> Floats:
    """Oriented gradients by cell, each cell's scaled by the crop's, and those of the thing."""
    n = len(gray)
    dx, dy = np.zeros_like(gray), np.zeros_like(gray)
    dx[:, :, 1:-1] = gray[:, :, 2:] - gray[:, :, :-2]
    dy[:, 1:-1] = gray[:, 2:] - gray[:, :-2]
    strength = np.hypot(dx, dy)
    direction = ((np.arctan2(dy, dx) % np.pi) / np.pi * DIRECTIONS).astype(int) % DIRECTIONS
    cell = np.minimum(np.arange(SIDE) * CELLS // SIDE, CELLS - 1)
    cells = (cell[:, None] * CELLS + cell[None, :])[None]
    bins = CELLS * CELLS * DIRECTIONS
    place = (np.arange(n)[:, None, None] * bins + cells * DIRECTIONS + direction).reshape(-1)
    by_cell = np.bincount(place, strength.reshape(-1), n * bins).reshape(n, bins)
    own = (np.arange(n)[:, None, None] * DIRECTIONS + direction).reshape(-1)
    inside = np.bincount(own, (strength * mask).reshape(-1), n * DIRECTIONS).reshape(n, -1)
    inside = inside / np.maximum(mask.sum(axis=(1, 2)), 1.0)[:, None]
    norm = np.sqrt((by_cell**2).sum(axis=1, keepdims=True)) + 1.0
    return np.hstack([by_cell / norm, inside]).astype(np.float32)


def _colours(colours: Real, weight: Real) -> Floats:
    """Histograms, means and deviations of three channels, by weight."""
    n = len(colours)
    total = np.maximum(weight.sum(axis=(1, 2)), 1e-6)
    parts = []
    for channel, (low, high) in enumerate(((0.0, 1.0), (-0.5, 0.5), (-0.5, 0.5))):
        values = colours[..., channel]
        bins = np.clip(((values - low) / (high - low) * BINS).astype(int), 0, BINS - 1)
        place = (np.arange(n)[:, None, None] * BINS + bins).reshape(-1)
        counts = np.bincount(place, weight.reshape(-1), n * BINS).reshape(n, BINS)
        mean = (values * weight).sum(axis=(1, 2)) / total
        spread = ((values - mean[:, None, None]) ** 2 * weight).sum(axis=(1, 2)) / total
        parts += [counts / total[:, None], mean[:, None], np.sqrt(spread)[:, None]]
    return np.hstack(parts).astype(np.float32)
