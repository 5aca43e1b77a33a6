"""Shade on floors, of what stands on them: finer than the cells of rooms can tell.

At each point of a grid, what reaches the floor of the light of the room's windows and lamps, and of
what comes from all around, as a share of what would if nothing stood there.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
import numpy.typing as npt
import shapely
from shapely.geometry import Point, Polygon

from sdgen.geometry import Array
from sdgen.render.light.panes import Panes
from sdgen.render.light.rooms import Lamp
from sdgen.scene import Room

if TYPE_CHECKING:
    from sdgen.render.light.world import LightWorld

#: How far apart points lie, and how high over the floor, metres: rugs lie on it.
STEP_M, _OVER_M = 0.1, 0.03
#: Of a window's pieces every so manieth is looked at; a lamp's light comes from points so far from
#: its middle, metres, so that its shade is soft.
_EVERY, _WIDE_M = 3, 0.12
_LAMP_POINTS = np.array([(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0)])
#: Directions from all around, how far they are followed, metres, how much of the light comes that
#: way, and how much what they meet gives on.
_ROUND, _NEAR_M, _AROUND, _GIVEN = 10, 1.6, 0.5, 0.3
#: A lamp is never nearer than this, metres.
_LEAST_M = 0.3


class FloorShade(NamedTuple):
    """Share of its light that the floor gets, (H, W), rows along y: the first point lies at
    ``corner_m``, the next :data:`STEP_M` on."""

    corner_m: Array
    share: npt.NDArray[np.float32]


def shade_of_floors(
    world: LightWorld, rooms: Sequence[Room], panes: Mapping[int, Panes], lamps: Sequence[Lamp]
) -> FloorShade:
    """The shade on all floors of what stands in ``world``."""
    outlines = {room.id: Polygon(room.polygon_m) for room in rooms}
    x0, y0, x1, y1 = shapely.union_all([*outlines.values()]).bounds
    columns, rows = (math.ceil(length / STEP_M) + 1 for length in (x1 - x0, y1 - y0))
    corner = np.array([x0, y0])
    at = np.stack(np.meshgrid(np.arange(columns), np.arange(rows)), axis=-1) * STEP_M + corner
    share = np.ones((rows, columns), dtype=np.float32)
    for key, outline in outlines.items():
        inside = shapely.contains_xy(outline, at[..., 0], at[..., 1])
        if not inside.any():
            continue
        points = np.column_stack([at[inside], np.full(int(inside.sum()), _OVER_M)])
        own = [lamp for lamp in lamps if outline.contains(Point(lamp.at_m[:2]))]
        share[inside] = _share(world, points, panes.get(key), own)
    return FloorShade(corner, _smooth(share))


def _share(world: LightWorld, points: Array, panes: Panes | None, lamps: Sequence[Lamp]) -> Array:
    """The share of its light that points (N, 3) of one room's floor get, (N,)."""
    got, whole = np.zeros(len(points)), np.zeros(len(points))
    for source, weight, beyond_m in _sources(panes, lamps):
        to = source - points
        far = np.maximum(np.linalg.norm(to, axis=1), _LEAST_M)
        ways = to / far[:, None]
        strength = weight * np.clip(ways[:, 2], 0.0, None) / far**2
        met_m, shell = world.shade(points, ways)
        free = met_m > far - beyond_m
        # What walls hide the cells of rooms know.
        got += strength * free
        whole += strength * (free | ~shell)
    k = np.arange(_ROUND) + 0.5
    turn, flat = math.pi * (1 + 5**0.5) * k, np.sqrt(k / _ROUND)
    around = np.stack([flat * np.cos(turn), flat * np.sin(turn), np.sqrt(1 - flat**2)], axis=1)
    met_m, shell = world.shade(np.repeat(points, _ROUND, axis=0), np.tile(around, (len(points), 1)))
    free = shell | (met_m > _NEAR_M)
    open_ = np.where(free, 1.0, _GIVEN).reshape(len(points), _ROUND).mean(axis=1)
    straight = np.where(whole > 0, got / np.maximum(whole, 1e-9), open_)
    return np.asarray((1 - _AROUND) * straight + _AROUND * open_)


def _sources(panes: Panes | None, lamps: Sequence[Lamp]) -> list[tuple[Array, float, float]]:
    """Where light comes from, how much, and from how near before that nothing hides it."""
    out: list[tuple[Array, float, float]] = []
    if panes is not None:
        for at, area_m2 in zip(panes.points_m[::_EVERY], panes.areas_m2[::_EVERY], strict=True):
            out.append((at, _EVERY * float(area_m2), 0.1))
    for lamp in lamps:
        power = float(lamp.power.mean()) / len(_LAMP_POINTS)
        out += [(lamp.at_m + _WIDE_M * by, power, lamp.radius_m) for by in _LAMP_POINTS]
    return out


def _smooth(share: npt.NDArray[np.float32]) -> npt.NDArray[np.float32]:
    """A little of the shade of the points beside each."""
    for axis in (0, 1):
        wide = np.pad(share, [(1, 1) if k == axis else (0, 0) for k in (0, 1)], mode="edge")
        before, after = (np.take(wide, np.arange(share.shape[axis]) + k, axis=axis) for k in (0, 2))
        share = (0.5 * share + 0.25 * (before + after)).astype(np.float32)
    return share
