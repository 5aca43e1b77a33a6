"""Where the sky is seen from indoors: the windows of each room, in pieces."""

from __future__ import annotations

from collections import defaultdict
from typing import NamedTuple

import numpy as np

from sdgen.geometry import Array
from sdgen.scene import Home, Opening

#: Pieces across and up each window.
_ACROSS, _UP = 4, 4


class Panes(NamedTuple):
    """Middles of pieces, (N, 3), their normals, (N, 3), and how large they are, (N,)."""

    points_m: Array
    normals: Array
    areas_m2: Array


def panes_of(home: Home) -> dict[int, Panes]:
    """The windows of each room that has any, by the room's id."""
    found: dict[int, list[Opening]] = defaultdict(list)
    for opening in home.openings:
        if opening.kind == "window":
            found[opening.room_ids[0]].append(opening)
    out = {}
    for key, windows in found.items():
        points = np.concatenate([_pieces(one) for one in windows])
        normals = np.array([(0, 1, 0) if one.along == "x" else (1, 0, 0) for one in windows])
        count = _ACROSS * _UP
        areas = np.array([one.width_m * one.height_m / count for one in windows])
        out[key] = Panes(points, np.repeat(normals, count, axis=0), np.repeat(areas, count))
    return out


def _pieces(window: Opening) -> Array:
    """Middles of a window's pieces, (N, 3)."""
    along = ((np.arange(_ACROSS) + 0.5) / _ACROSS - 0.5) * window.width_m
    up = ((np.arange(_UP) + 0.5) / _UP) * window.height_m + window.center_m[2]
    x, y, _ = window.center_m
    u, v = (k.ravel() for k in np.meshgrid(along, up))
    flat = np.zeros_like(u)
    if window.along == "x":
        return np.column_stack([x + u, y + flat, v])
    return np.column_stack([x + flat, y + u, v])
