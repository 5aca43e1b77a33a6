"""Light in the air of each room, in cells of a grid: from six sides, as ambient cubes have it.

From the middle of each cell rays go out evenly on the sphere. What they meet gives on light that it
gets from the sun, from lamps and from the cells before it; through windows they see the sky. That
is repeated, a bounce at a time. (Ambient cubes: McTaggart 2004, "Half-Life 2 / Valve Source
Shading"; irradiance volumes: Greger et al. 1998.)
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt
import shapely
from shapely.geometry import Polygon

from sdgen.geometry import Array
from sdgen.render.light.panes import Panes
from sdgen.scene import Room

if TYPE_CHECKING:
    from sdgen.render.light.sunlight import SunMap
    from sdgen.render.light.world import LightWorld

#: Edges of the cells, metres, near enough for whole numbers of them to fill a room; longer where
#: a home would have more cells than this: what light costs grows with them.
CELL_M = 0.3
_MOST_CELLS = 3200
_RAYS = 48
_BOUNCES = 4
#: Lamps light so far, metres, and cells nearer than this as if they were so far off.
_LAMP_REACH_M, _LAMP_NEAR_M = 6.0, 0.55
#: Nearer to a piece of a pane than this, metres, cells get no more light than so far off; and a ray
#: through one goes on for so long at least.
_PANE_NEAR_M, _BEYOND_M = 0.3, 2.0
#: Light that comes from nowhere, by side: all of it where no rays are traced, and so little of it
#: that it is seen only where there is no other.
_EVEN = np.array((0.8, 0.8, 0.7, 0.7, 1.0, 0.6), dtype=np.float32)
_DIM = 0.03
#: A cell of whose rays more than this share meet things from behind lies within one.
_WITHIN = 0.3
#: What lights a surface is found so far before it, metres.
BEFORE_M = 0.14
#: Directions of the six sides: +x, -x, +y, -y, +z, -z.
_SIDES = np.concatenate([np.eye(3), -np.eye(3)])[[0, 3, 1, 4, 2, 5]]


@dataclass(frozen=True)
class Lamp:
    """A lamp that is on: where, how far its own body reaches, and the light that it gives, W/sr in
    red, green and blue."""

    at_m: Array
    radius_m: float
    power: Array


@dataclass(frozen=True, eq=False)
class RoomLight:
    """The light in one room: where its grid begins, the edges of its cells, and ``cube``, light
    from the six sides, (X, Y, Z, 6, 3)."""

    room: Room
    corner_m: Array
    cell_m: Array
    cube: npt.NDArray[np.float32]


class _Grid:
    """A room's cells: their middles, and what their numbers among all cells are; -1: outside."""

    def __init__(self, room: Room, height_m: float, cell_m: float, first: int) -> None:
        self.room = room
        outline = Polygon(room.polygon_m)
        x0, y0, x1, y1 = outline.bounds
        size = np.array([x1 - x0, y1 - y0, height_m])
        counts = np.maximum(2, np.rint(size / cell_m).astype(int))
        self.corner_m, self.cell_m = np.array([x0, y0, 0.0]), size / counts
        at = np.stack(np.meshgrid(*(np.arange(n) + 0.5 for n in counts), indexing="ij"), axis=-1)
        middles = at * self.cell_m + self.corner_m
        inside = shapely.contains_xy(outline, middles[:, :, 0, 0], middles[:, :, 0, 1])
        self.inside = np.repeat(inside[:, :, None], counts[2], axis=2)
        self.middles = middles[self.inside]
        self.number = np.full(tuple(counts), -1)
        self.number[self.inside] = first + np.arange(len(self.middles))

    def at(self, points_m: Array) -> npt.NDArray[np.int64]:
        """Numbers of the cells of points (N, 3); -1: in none."""
        cell = np.floor((points_m - self.corner_m) / self.cell_m).astype(int)
        inside = ((cell >= 0) & (cell < self.number.shape)).all(axis=1)
        out = np.full(len(points_m), -1)
        out[inside] = self.number[tuple(cell[inside].T)]
        return out


def light_of_rooms(
    world: LightWorld,
    rooms: Sequence[Room],
    height_m: float,
    sky: Callable[[Array], Array],
    sun: tuple[SunMap, Array] | None,
    lamps: Sequence[Lamp],
    panes: Mapping[int, Panes],
    enclosed: bool = True,
) -> list[RoomLight]:
    """The light in each room. ``sky`` gives radiance by direction (N, 3); ``sun``: its map, and
    its light on a surface that faces it; ``panes``: those of the windows of a room, by its id.
    Where nothing is ``enclosed`` by walls, light is nearly the same everywhere, and found at a few
    places only."""
    grids = _grids(rooms, height_m, enclosed)
    middles = np.concatenate([grid.middles for grid in grids])
    rays = _even_directions(_RAYS)
    directions = np.tile(rays, (len(middles), 1))
    met = world.meet(np.repeat(middles, _RAYS, axis=0), directions)
    within = met.behind.reshape(-1, _RAYS).mean(axis=1) > _WITHIN
    at, normals = met.point_m[met.hit], met.normal[met.hit]
    cell = _cells(grids, at + BEFORE_M * normals, np.flatnonzero(met.hit) // _RAYS)
    shone_on = [_shone_on(world, middles, lamp) for lamp in lamps]
    # What is met gets light straight from the sun and from lamps: whether it sees a lamp is taken
    # from the cell before it.
    first = np.zeros((len(at), 3))
    if sun is not None:
        first += sun[0].shines(at, normals)[:, None] * sun[1]
    for lamp, cells in zip(lamps, shone_on, strict=True):
        lit = np.flatnonzero((cell >= 0) & cells[cell])
        first[lit] += _from_lamp(lamp, at[lit], normals[lit, None])[:, 0]
    # Of a room with windows, sky is found through these: rays of all cells alike would see them or
    # not, in steps.
    of_panes = np.concatenate(
        [_from_sky(world, grid.middles, sky, panes.get(grid.room.id)) for grid in grids]
    )
    bare = np.concatenate([np.full(len(one.middles), one.room.id not in panes) for one in grids])
    open_sky = ~met.hit & np.repeat(bare, _RAYS)
    radiance = np.where(open_sky[:, None], sky(directions), 0.0).astype(np.float32)
    weights = np.clip(rays @ _SIDES.T, 0.0, None)
    weights = (weights * math.pi / weights.sum(axis=0)).T.astype(np.float32)
    sides, share = _facing(normals)
    gives, got = met.albedo[met.hit] / math.pi, first
    for bounce in range(_BOUNCES):
        radiance[met.hit] = gives * got
        cube = weights @ radiance.reshape(len(middles), _RAYS, 3) + of_panes
        cubes = [_filled(grid, cube, within) for grid in grids]
        if bounce + 1 < _BOUNCES:
            known = np.concatenate(
                [one[grid.inside] for one, grid in zip(cubes, grids, strict=True)]
            )
            there = (known[cell[:, None], sides] * share[..., None]).sum(axis=1)
            got = first + np.where(cell[:, None] >= 0, there, 0.0)
    straight = _straight(lamps, shone_on, middles)
    return [
        RoomLight(
            grid.room,
            grid.corner_m,
            grid.cell_m,
            _smooth(one + _filled(grid, straight, within)) + _DIM * _EVEN[:, None],
        )
        for grid, one in zip(grids, cubes, strict=True)
    ]


def _grids(rooms: Sequence[Room], height_m: float, enclosed: bool) -> list[_Grid]:
    """The cells of all rooms, numbered on from room to room."""
    volume = sum(Polygon(room.polygon_m).area for room in rooms) * height_m
    cell_m = max(CELL_M, (volume / _MOST_CELLS) ** (1 / 3)) if enclosed else math.inf
    grids: list[_Grid] = []
    for room in rooms:
        grids.append(_Grid(room, height_m, cell_m, sum(len(grid.middles) for grid in grids)))
    return grids


def _cells(
    grids: Sequence[_Grid], points_m: Array, seen_from: npt.NDArray[np.int64]
) -> npt.NDArray[np.int64]:
    """Numbers of the cells of points (N, 3), each seen from a cell; -1: in none. These come room
    by room, and most points are in the room that they are seen from."""
    first = np.cumsum([0, *(len(grid.middles) for grid in grids)])
    begin = np.searchsorted(seen_from, first)
    out = np.concatenate(
        [grid.at(points_m[a:b]) for grid, a, b in zip(grids, begin, begin[1:], strict=False)]
    )
    rest = np.flatnonzero(out < 0)
    out[rest] = np.max([grid.at(points_m[rest]) for grid in grids], axis=0)
    return out


def _straight(
    lamps: Sequence[Lamp], shone_on: Sequence[npt.NDArray[np.bool_]], middles: Array
) -> Array:
    """What cells get straight from the lamps that shine on them, on each side, (N, 6, 3)."""
    out = np.zeros((len(middles), 6, 3))
    for lamp, cells in zip(lamps, shone_on, strict=True):
        every = np.broadcast_to(_SIDES, (int(cells.sum()), 6, 3))
        out[cells] += _from_lamp(lamp, middles[cells], every)
    return out


def _from_sky(
    world: LightWorld,
    middles: Array,
    sky: Callable[[Array], Array],
    panes: Panes | None,
) -> Array:
    """What cells (N, 3) get straight from the sky through panes, on each side, (N, 6, 3)."""
    out = np.zeros((len(middles), 6, 3))
    if panes is None:
        return out
    for at, normal, area_m2 in zip(*panes, strict=True):
        to = at - middles
        far = np.maximum(np.linalg.norm(to, axis=1), 1e-6)
        ways = to / far[:, None]
        free = world.distance_m(middles, ways) > far + _BEYOND_M
        slant = np.abs(ways @ normal)
        solid = area_m2 * slant / np.maximum(far, _PANE_NEAR_M) ** 2
        strength = np.where(free, solid, 0.0)[:, None] * np.clip(ways @ _SIDES.T, 0.0, None)
        out += strength[..., None] * sky(ways)[:, None]
    return out


def even_light(rooms: Sequence[Room], height_m: float) -> list[RoomLight]:
    """The same light everywhere, a little more from above."""
    cube = np.broadcast_to(_EVEN[:, None], (2, 2, 2, 6, 3))
    out = []
    for room in rooms:
        x0, y0, x1, y1 = Polygon(room.polygon_m).bounds
        size = np.array([x1 - x0, y1 - y0, height_m]) / 2
        out.append(RoomLight(room, np.array([x0, y0, 0.0]), size, cube))
    return out


def _shone_on(world: LightWorld, middles: Array, lamp: Lamp) -> npt.NDArray[np.bool_]:
    """Which cells a lamp shines on, (N,)."""
    to = lamp.at_m - middles
    far = np.linalg.norm(to, axis=1)
    out = far < _LAMP_REACH_M
    ways = to[out] / np.maximum(far[out], 1e-6)[:, None]
    out[out] = world.distance_m(middles[out], ways) > far[out] - lamp.radius_m
    return np.asarray(out)


def _from_lamp(lamp: Lamp, points_m: Array, normals: Array) -> Array:
    """Light that surfaces at points (N, 3) that face M ways each (N, M, 3) get from a lamp that
    shines on them, (N, M, 3)."""
    to = lamp.at_m - points_m
    far = np.linalg.norm(to, axis=1)
    slant = np.einsum("nmk,nk->nm", normals, to / np.maximum(far, 1e-6)[:, None])
    strength = np.clip(slant, 0.0, None) / np.maximum(far, _LAMP_NEAR_M)[:, None] ** 2
    return np.asarray(strength[..., None] * lamp.power)


def _even_directions(count: int) -> Array:
    """Directions spread evenly on the sphere, (N, 3): a Fibonacci lattice."""
    k = np.arange(count) + 0.5
    z = 1 - 2 * k / count
    turn = math.pi * (1 + 5**0.5) * k
    flat = np.sqrt(1 - z * z)
    return np.stack([flat * np.cos(turn), flat * np.sin(turn), z], axis=1)


def _facing(normals: Array) -> tuple[npt.NDArray[np.int64], Array]:
    """The three sides that light each normal (N, 3), and their shares."""
    side = np.arange(3) * 2 + (normals < 0)
    return side.astype(np.int64), normals**2


def _filled(grid: _Grid, cube: npt.NDArray[np.floating], within: npt.NDArray[np.bool_]) -> Array:
    """A room's cells, (X, Y, Z, 6, 3): those that lie within things or beyond the walls have what
    is around them."""
    out = np.full((*grid.number.shape, 6, 3), np.nan, dtype=np.float32)
    numbers = grid.number[grid.inside]
    known = cube[numbers]
    known[within[numbers]] = np.nan
    out[grid.inside] = known
    while True:
        empty = np.isnan(out[..., 0, 0])
        if not empty.any() or empty.all():
            return np.nan_to_num(out)
        beside = np.stack([_shifted(out, axis, step) for axis in range(3) for step in (-1, 1)])
        there = ~np.isnan(beside[..., :1, :1])
        total = np.where(there, beside, 0.0).sum(axis=0)
        count = there.sum(axis=0)
        filled = empty & (count[..., 0, 0] > 0)
        out[filled] = (total / np.maximum(count, 1))[filled]


def _smooth(cube: Array) -> npt.NDArray[np.float32]:
    """A room's cells with a little of their neighbours' light."""
    for axis in range(3):
        beside = _shifted(cube, axis, -1, edge=True) + _shifted(cube, axis, 1, edge=True)
        cube = 0.5 * cube + 0.25 * beside
    return cube.astype(np.float32)


def _shifted(values: Array, axis: int, step: int, edge: bool = False) -> Array:
    """Each cell's neighbour along an axis; beyond the grid nothing, or the cell itself."""
    out = np.roll(values, step, axis=axis)
    rim = [slice(None)] * values.ndim
    rim[axis] = slice(0, 1) if step > 0 else slice(-1, None)
    out[tuple(rim)] = values[tuple(rim)] if edge else np.nan
    return out
