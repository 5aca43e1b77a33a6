"""Where people walk: a grid of the floor, of the audit's own, and ways on it."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
import numpy.typing as npt
import shapely
from scipy.ndimage import distance_transform_edt, label
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import dijkstra

from tests.audit.dataset import Scene, Thing

Floats = npt.NDArray[np.float64]
Bools = npt.NDArray[np.bool_]

CELL_M = 0.05
#: Half the width of a person who walks (0.5 m: shoulder breadth of a large adult, DIN 33402-2).
BODY_M = 0.25
#: People keep off walls and furniture by this much where there is room for it (judgement).
EASE_M = 0.5
#: Furniture whose lowest point is above this does not stand in the way (judgement: head height).
HEAD_M = 1.6
#: What is flatter than this is walked on.
FLAT_M = 0.03


def hull(points: Floats) -> shapely.Geometry:
    return shapely.convex_hull(shapely.multipoints(points[:, :2]))


@dataclass(frozen=True)
class Ground:
    """The floor of a home in cells of 5 cm: ``at[i, j]`` lies at ``origin + CELL_M * (i, j)``."""

    scene: Scene

    @cached_property
    def blocks(self) -> dict[int, shapely.Geometry]:
        """The footprints of furniture that stands in the way; leaves shut, below head height."""
        found = {}
        for thing in self.scene.furniture:
            if thing.bottom > HEAD_M or thing.height < FLAT_M:
                continue
            shut = [part for part in thing.parts if part.joint is None]
            points = np.concatenate([part.vertices for part in shut])
            found[thing.id] = hull(points)
        return found

    @cached_property
    def floor(self) -> shapely.Geometry:
        """All rooms, and the holes of doors between them."""
        holes = []
        for opening in self.scene.scene["home"]["openings"]:
            if opening["kind"] != "window" and len(opening["room_ids"]) == 2:
                x, y, _ = opening["center_m"]
                along, across = opening["width_m"] / 2 - 0.04, 0.07
                dx, dy = (along, across) if opening["along"] == "x" else (across, along)
                holes.append(shapely.box(x - dx, y - dy, x + dx, y + dy))
        return shapely.union_all([*self.scene.floors.values(), *holes])

    @cached_property
    def free(self) -> shapely.Geometry:
        return self.floor.difference(shapely.union_all(list(self.blocks.values())))

    @cached_property
    def origin(self) -> Floats:
        return np.array(self.floor.bounds[:2]) - CELL_M

    @cached_property
    def points(self) -> Floats:
        """(I, J, 2) the middles of the cells."""
        size = np.array(self.floor.bounds[2:]) - self.origin + CELL_M
        i, j = (np.arange(int(np.ceil(side / CELL_M))) * CELL_M for side in size)
        return np.stack(np.meshgrid(i, j, indexing="ij"), axis=-1) + self.origin

    @cached_property
    def open(self) -> Bools:
        """Cells that nothing stands on."""
        shapely.prepare(self.free)
        return np.asarray(shapely.contains_xy(self.free, self.points[..., 0], self.points[..., 1]))

    @cached_property
    def clear(self) -> Floats:
        """From each cell to the nearest wall or furniture, metres."""
        return np.asarray(distance_transform_edt(self.open) * CELL_M)

    @cached_property
    def walkable(self) -> Bools:
        return np.asarray(self.clear >= BODY_M)

    @cached_property
    def island(self) -> npt.NDArray[np.int32]:
        """Which walkable cells hang together: 0 is not walkable."""
        return np.asarray(label(self.walkable, np.ones((3, 3)))[0])

    def cell(self, point: Floats) -> tuple[int, int]:
        i, j = np.clip(np.round((point - self.origin) / CELL_M), 0, np.array(self.open.shape) - 1)
        return int(i), int(j)

    def nearest(self, point: Floats, within: float) -> tuple[int, int] | None:
        """The walkable cell nearest to a point, at most ``within`` metres away."""
        far = np.linalg.norm(self.points - point, axis=2)
        far[~self.walkable] = np.inf
        best = np.unravel_index(int(np.argmin(far)), far.shape)
        return (int(best[0]), int(best[1])) if far[best] <= within else None

    @cached_property
    def _steps(self) -> coo_matrix:
        """The graph of steps to neighbours: longer the nearer walls and furniture are."""
        index = np.arange(self.walkable.size).reshape(self.walkable.shape)
        dear = 1 + 2 * np.clip((EASE_M - self.clear) / (EASE_M - BODY_M), 0, 1)
        rows, columns, costs = [], [], []
        for di, dj in ((1, 0), (0, 1), (1, 1), (1, -1)):
            a = (slice(None, -di or None), slice(max(0, -dj), -dj if dj > 0 else None))
            b = (slice(di, None), slice(max(0, dj), dj if dj < 0 else None))
            both = self.walkable[a] & self.walkable[b]
            rows.append(index[a][both])
            columns.append(index[b][both])
            costs.append((dear[a][both] + dear[b][both]) / 2 * np.hypot(di, dj) * CELL_M)
        data = (np.concatenate(costs), (np.concatenate(rows), np.concatenate(columns)))
        return coo_matrix(data, shape=(index.size, index.size)).tocsr()

    def doors(self) -> list[tuple[int, tuple[int, ...], Floats]]:
        """Object, rooms and middle of each door."""
        return [
            (o["object_id"], tuple(o["room_ids"]), np.array(o["center_m"][:2]))
            for o in self.scene.scene["home"]["openings"]
            if o["kind"] != "window"
        ]

    def stand(self, thing: Thing) -> tuple[int, int] | None:
        """Where one stands to use a piece of furniture: before it, or else nearest to it."""
        at = self.blocks[thing.id]
        middle = np.array(at.centroid.coords[0])
        front = thing.front[:2] / (np.linalg.norm(thing.front[:2]) or 1)
        depth = float(np.abs((np.array(at.exterior.coords) - middle) @ front).max())
        return self.nearest(middle + front * (depth + BODY_M), 0.3) or self.nearest(
            middle, depth + 0.6
        )

    @cached_property
    def routes(self) -> list[tuple[int, shapely.LineString]]:
        """Where to, and the way: from each door of a room to its other doors and its furniture."""
        found = []
        doors = [
            (id, rooms, cell)
            for id, rooms, at in self.doors()
            if (cell := self.nearest(at, 0.5)) is not None
        ]
        goals = [
            (thing.room, thing.id, cell)
            for thing in self.scene.furniture
            if thing.id in self.blocks
            and thing.bottom < FLAT_M
            and (cell := self.stand(thing)) is not None
        ]
        shape = self.walkable.shape
        for id, rooms, start in doors:
            begin = int(np.ravel_multi_index(start, shape))
            cost, before = dijkstra(self._steps, False, begin, return_predecessors=True)
            ends = [(r, d, c) for d, rs, c in doors if d > id for r in rs] + goals
            for room, goal, cell in ends:
                at = int(np.ravel_multi_index(cell, shape))
                if room not in rooms or not np.isfinite(cost[at]):
                    continue
                path = [at]
                while path[-1] != begin:
                    path.append(int(before[path[-1]]))
                cells = np.unravel_index(np.array(path), shape)
                way = self.points[cells]
                if len(way) > 1:
                    found.append((goal, shapely.LineString(way)))
        return found

    def routes_by(self, footprint: shapely.Geometry, within: float) -> set[int]:
        """Where to the ways lead whose middle comes that near to a footprint."""
        return {goal for goal, way in self.routes if way.distance(footprint) <= within}

    def room_about(self, footprint: shapely.Geometry) -> float:
        """From a footprint to the nearest wall or furniture, metres: 0 within or below it."""
        return float(shapely.distance(footprint, self.obstacles))

    @cached_property
    def obstacles(self) -> shapely.Geometry:
        around = shapely.box(*self.floor.bounds).buffer(1).difference(self.floor)
        return shapely.union_all([around, *self.blocks.values()])
