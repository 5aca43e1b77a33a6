"""What belongs to the building: curtains and blinds at windows, radiators below, switches by doors,
sockets, lamps at the ceilings, mats before doors; then what people hang on the walls.

Hung when the furniture stands, where it leaves room: a window behind a bookcase has no curtain.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import chain
from typing import NamedTuple

import numpy as np
import shapely
from shapely.geometry import Polygon
from shapely.geometry.base import BaseGeometry

from sdgen.actions import at_rest
from sdgen.catalog.records import Catalog, Fitting
from sdgen.facts import bodies_of
from sdgen.freespace import (
    LEAST_REACHED_M2,
    ROBOT_RADIUS_M,
    free_shape,
    opening_rectangle,
    polygons,
    union,
    unreachable_rooms,
)
from sdgen.geometry import Vec2, apply, quat_from_yaw, round_position, round_quat
from sdgen.home.anchors import (
    HUNG_GAP_M,
    PlacedAt,
    Side,
    against_walls,
    placed_from,
    sides_of,
)
from sdgen.home.clearances import Sight, sight_of
from sdgen.home.context import Models
from sdgen.home.furnish import put_piece
from sdgen.home.layout import IN_WALL_M, Layout, corners_of
from sdgen.home.wall_sets import WallSets, wall_behind
from sdgen.library.records import Asset
from sdgen.scene import Home, ObjectInstance, Opening, Pose, Room
from sdgen.seeding import Rng
from sdgen.vocabulary import DOORS, HALF_WALL_M, ON_BARE_WALLS
from sdgen.zones import DOORWAY_DEPTH_M, TOUCH_M2, floor_obstacles, swing_sectors

#: A rod hangs so far above the window, what is under it ends so far below the sill.
ABOVE_WINDOW_M = 0.07
BELOW_SILL_M = 0.04
#: What hangs at a window is no narrower than its hole but by this (a blind between its frames), and
#: wider by this at most: a rod, and drapes drawn aside.
NARROWER_M, WIDER_M = 0.05, 0.6
#: Between the hole of a door and what hangs beside it: the frame, and a hand's breadth; where that
#: is taken, a step further.
BESIDE_DOOR_M = (0.12, 0.35)
#: Between the wall of a door and what lies before it.
BEFORE_DOOR_M = 0.04
#: Between a piece of furniture and what hangs on the wall beside it.
BESIDE_PIECE_M = 0.06
#: A wall at the side of a seat is at hand when it is no further from it, and what hangs there is
#: so far behind its front: by eye.
AT_HAND_M, BEHIND_FRONT_M = 0.5, 0.12
#: The middle of a room is found to so much.
MIDDLE_M = 0.05
#: A lamp lights what lies straight before it and no further off than this; a room has one more
#: where so much of it is dark, but not more than so many. By points so far apart.
LIT_M, LEAST_DARK_M2, MOST_LAMPS, LIT_STEP_M = 4.5, 3.0, 3, 0.5
#: A wall is an opening's when its middle is in it.
SAME_WALL_M = HALF_WALL_M + 0.02

#: Models with the poses they may have, first the best.
Candidates = Iterable[tuple[Asset, PlacedAt]]


def add_fittings(home: Home, layout: Layout, catalog: Catalog, models: Models, rng: Rng) -> Layout:
    """The layout with what belongs to the building, of one model of each category a home, or of one
    suite in all of its sizes (pictures on walls are of any models); nothing that cuts a room off or
    stands where a door swings."""
    free = _Free(home, layout)
    dressed: set[int] = set()
    drawn: dict[str, list[Asset]] = {}
    for fitting in catalog.fittings:
        found = models(fitting.category)
        if fitting.where in ON_BARE_WALLS:
            drawn[fitting.category] = list(found)
        elif found and fitting.category not in drawn:
            drawn[fitting.category] = _sizes_of(found[int(rng.integers(len(found)))], found)
        sizes = drawn.get(fitting.category, [])
        for room in home.rooms:
            if sizes and (not fitting.rooms or room.type in fitting.rooms):
                hanging = _Hanging(fitting, sizes, room, home, layout, free, catalog)
                for candidates, window in hanging.wanted(dressed, rng):
                    if hanging.hang_first(candidates) and window is not None:
                        dressed.add(window)
    return layout


def _sizes_of(model: Asset, found: Sequence[Asset]) -> list[Asset]:
    """The models of its suite, the widest first."""
    suite = [m for m in found if m is model or (m.suite is not None and m.suite == model.suite)]
    return sorted(suite, key=lambda m: (-m.extents_m[1], -m.extents_m[2], m.id))


class _Left(NamedTuple):
    """Floor where a robot's middle can be, and in how many parts."""

    shape: BaseGeometry
    parts: int


class _Free:
    """The floor where a robot's middle can be, less what is hung there, and where doors swing."""

    def __init__(self, home: Home, layout: Layout) -> None:
        self._home = home
        bodies = bodies_of(list(layout.items.values()), layout.library.infos)
        shape = free_shape(home, floor_obstacles(bodies))
        self._left = _Left(shape, len(polygons(shape)))
        # A home that is cut off as it stands is rejected for that, not for a switch.
        self._cut = {room.id for room in unreachable_rooms(home, shape)}
        depth = HALF_WALL_M + DOORWAY_DEPTH_M
        ways = [opening_rectangle(o, depth) for o in home.openings if o.kind in DOORS]
        self.swings = union(swing_sectors(bodies))
        self._doors = union([self.swings, *ways])
        shapely.prepare(self._doors)

    def take(self, left: _Left) -> None:
        """Note what is left when a piece hangs."""
        self._left = left

    def left_by(self, item: ObjectInstance, layout: Layout) -> _Left | None:
        """What one piece more leaves; None where a door would swing against it or some room could
        not be got to any more."""
        standing = floor_obstacles(bodies_of([item], layout.library.infos))
        if any(self._doors.intersection(shape).area > TOUCH_M2 for shape in standing):
            return None
        taken = union([shape.buffer(ROBOT_RADIUS_M, quad_segs=2) for shape in standing])
        shape, parts = self._left
        if not taken.intersects(shape):
            return self._left
        after = shape.difference(taken)
        left = _Left(after, len(polygons(after)))
        # A bite out of the edge, smaller than what a room needs, cuts nothing off.
        if left.parts == parts and shape.area - after.area < LEAST_REACHED_M2 / 4:
            return left
        cut = {room.id for room in unreachable_rooms(self._home, after)}
        return left if cut <= self._cut else None


@dataclass(frozen=True)
class _Hanging:
    """A fitting, in the ``sizes`` that it has (the widest first), in a room."""

    fitting: Fitting
    sizes: Sequence[Asset]
    room: Room
    home: Home
    layout: Layout
    free: _Free
    catalog: Catalog

    def wanted(self, dressed: set[int], rng: Rng) -> Iterator[tuple[Candidates, int | None]]:
        """For each piece that is asked for where it may be, and the window that it is for.
        ``dressed``: windows that have something at them, by the object that fills them."""
        fitting, sides = self.fitting, sides_of(self.room.polygon_m)
        if fitting.where == "wall":
            model = self.sizes[0]
            deep, wide, _ = model.extents_m
            for _ in range(int(rng.integers(fitting.count[0], fitting.count[1] + 1))):
                spots = against_walls(sides, (deep, wide), fitting.z_m, rng, snap=0.0)
                if rng.random() < fitting.chance:
                    yield [(model, spot) for spot in spots], None
        elif fitting.where == "ceiling":
            high = self.room.height_m - HUNG_GAP_M
            for x, y in _lamp_places(self.room):
                if rng.random() < fitting.chance:
                    yield [(m, (x, y, high - m.extents_m[2], 0.0)) for m in self.sizes], None
        elif fitting.where in ON_BARE_WALLS:
            yield from self._on_walls(rng)
        elif fitting.where in ("beside", "at_hand"):
            for item in list(self.layout.items.values()):
                beside = item.room_id == self.room.id and item.category in fitting.of
                if beside and rng.random() < fitting.chance:
                    at_hand = self._at_hand(item, sides) if fitting.where == "at_hand" else ()
                    yield chain(at_hand, self._beside(item, sides)), None
        else:
            for opening in self.home.openings:
                found = _side_of(opening, sides) if self.room.id in opening.room_ids else None
                if found is None or not self._is_at(opening):
                    continue
                window = opening.object_id if fitting.where == "window" else None
                if window not in dressed and rng.random() < fitting.chance:
                    yield self._at_opening(opening, *found), window

    def _on_walls(self, rng: Rng) -> Iterator[tuple[Candidates, None]]:
        """Each piece of each set that is hung over furniture or on bare walls."""
        fitting, room = self.fitting, self.room
        mine = [o for o in self.home.openings if room.id in o.room_ids]
        openings = list(zip(mine, self._sights, strict=True))
        sides, swings = sides_of(room.polygon_m), self.free.swings
        walls = WallSets(fitting, self.sizes, room, self.layout, sides, openings, swings, rng)
        if fitting.where == "bare_wall":
            sets = walls.bare()
        else:
            items = list(self.layout.items.values())
            below = [i for i in items if i.room_id == room.id and i.category in fitting.of]
            sets = (walls.over(item) for item in below if rng.random() < fitting.chance)
        for pieces in sets:
            for piece in pieces:
                yield [piece], None

    @cached_property
    def _inside(self) -> Polygon:
        return Polygon(self.room.polygon_m).buffer(IN_WALL_M, join_style="mitre")

    @cached_property
    def _sights(self) -> list[Sight]:
        return [sight_of(o) for o in self.home.openings if self.room.id in o.room_ids]

    def hang_first(self, candidates: Candidates) -> bool:
        """Hang what first has room; False where nothing has, or where there are enough."""
        room, layout = self.room, self.layout
        there = [i for i in layout.items.values() if i.category == self.fitting.category]
        bound = self.catalog.category(self.fitting.category).at_most
        if bound.reached(sum(i.room_id == room.id for i in there), len(there)):
            return False
        for model, (x, y, z, yaw) in candidates:
            shape = Polygon(corners_of(model, x, y, yaw))
            if not self._inside.covers(shape):
                continue
            # What is for a window alone hangs before an opening.
            top = z + model.extents_m[2]
            covers = any(s.hidden_by(shape, z, top) for s in self._sights)
            if covers and self.fitting.where != "window":
                continue
            item = ObjectInstance(
                id=next(layout.ids),
                category=model.category,
                asset=model.id,
                pose=Pose(
                    position_m=round_position((x, y, z)), quat_xyzw=round_quat(quat_from_yaw(yaw))
                ),
                room_id=room.id,
                fixed=True,
            )
            item = at_rest(item, model)
            left = self.free.left_by(item, layout)
            if left is not None and put_piece(item, model, layout, None, room, self.catalog):
                self.free.take(left)
                return True
        return False

    def _is_at(self, opening: Opening) -> bool:
        """Whether the fitting is one for such an opening."""
        if self.fitting.where == "before_door":
            return opening.kind in self.fitting.of
        return (opening.kind in DOORS) == (self.fitting.where == "beside_door")

    def _at_opening(self, opening: Opening, side: Side, along: float) -> Candidates:
        fitting = self.fitting
        low, high = opening.center_m[2], opening.center_m[2] + opening.height_m
        if fitting.where == "beside_door":
            model = self.sizes[0]
            for t in self._beside_door(opening, side, along, model.extents_m[1] / 2):
                yield from _hung(model, side, t, fitting.z_m)
            return
        for model in self.sizes:
            deep, wide, tall = model.extents_m
            if fitting.where == "before_door":
                x, y = side.at(along, BEFORE_DOOR_M + deep / 2)
                yield model, (x, y, 0.0, side.yaw)
            elif fitting.where == "window":
                if -NARROWER_M <= wide - opening.width_m <= WIDER_M:
                    top = min(high + ABOVE_WINDOW_M, self.room.height_m - HUNG_GAP_M)
                    yield from _hung(model, side, along, top - tall)
            elif fitting.z_m + tall <= low - BELOW_SILL_M:
                yield from _hung(model, side, along, fitting.z_m)

    def _beside_door(
        self, opening: Opening, side: Side, along: float, half_m: float
    ) -> Iterator[float]:
        """Where along the wall: at the latch; at the hinges only where no latch is, or where the
        leaf opens into the other room."""
        item = self.layout.items[opening.object_id]
        joints = self.layout.info(item.id).joints
        ends = [(along, sign) for sign in (-1.0, 1.0)]
        if len(joints) == 1:
            hinge = apply(item.pose.matrix(), [joints[0].origin_m])[0]
            latch = math.copysign(1.0, along - side.measure((hinge[0], hinge[1]))[0])
            (swept,) = swing_sectors(bodies_of([item], self.layout.library.infos))
            into = side.measure(swept.centroid.coords[0])[1] > 0
            ends = [(along, latch)] if into else [(along, latch), (along, -latch)]
        for middle, sign in ends:
            for off in BESIDE_DOOR_M:
                yield middle + sign * (opening.width_m / 2 + off + half_m)

    def _beside(self, item: ObjectInstance, sides: Sequence[Side]) -> Candidates:
        """On the wall at the back of a piece, to its left and right."""
        wide = self.layout.info(item.id).extents_m[1]
        model = self.sizes[0]
        reach = wide / 2 + BESIDE_PIECE_M + model.extents_m[1] / 2
        behind = wall_behind(item, self.layout, sides)
        if behind is not None:
            side, along = behind
            for t in (along - reach, along + reach):
                yield from _hung(model, side, t, self.fitting.z_m)

    def _at_hand(self, item: ObjectInstance, sides: Sequence[Side]) -> Candidates:
        """On a wall at the side of a piece, by who sits on it; the nearer wall first."""
        deep, wide, _ = self.layout.info(item.id).extents_m
        ahead = deep / 2 - BEHIND_FRONT_M
        x, y, _, yaw = placed_from(item, ahead, 0.0)
        found = []
        for side in sides:
            along, away = side.measure((x, y))
            if abs(math.cos(yaw - side.yaw)) < 0.01 and 0 < away - wide / 2 < AT_HAND_M:
                found.append((away, side, along))
        for _, side, along in sorted(found, key=lambda one: one[0]):
            yield from _hung(self.sizes[0], side, along, self.fitting.z_m)


def _hung(model: Asset, side: Side, along: float, z: float) -> Iterator[tuple[Asset, PlacedAt]]:
    """The model with its middle there, if the wall goes on behind all of it."""
    deep, wide, _ = model.extents_m
    if wide / 2 <= along <= side.length_m - wide / 2:
        yield model, (*side.at(along, deep / 2 + HUNG_GAP_M), z, side.yaw)


def _lamp_places(room: Room) -> Iterator[Vec2]:
    """The middle of a room, and of what light from there and from those before does not reach."""
    outline = Polygon(room.polygon_m)
    x0, y0, x1, y1 = outline.bounds
    steps = (
        np.arange(low + LIT_STEP_M / 2, high, LIT_STEP_M) for low, high in ((x0, x1), (y0, y1))
    )
    points = np.stack(np.meshgrid(*steps), axis=-1).reshape(-1, 2)
    points = points[shapely.contains_xy(outline, points[:, 0], points[:, 1])]
    inside = outline.buffer(SAME_WALL_M)
    shapely.prepare(inside)
    place = _middle_of(room)
    for _ in range(MOST_LAMPS):
        yield place
        ways = shapely.linestrings([[place, point] for point in points.tolist()])
        lit = shapely.covers(inside, ways) & (np.hypot(*(points - place).T) < LIT_M)
        points = points[~lit]
        if len(points) * LIT_STEP_M**2 < LEAST_DARK_M2:
            return
        x, y = points[np.argmin(np.hypot(*(points - points.mean(axis=0)).T))]
        place = (round(float(x), 3), round(float(y), 3))


def _middle_of(room: Room) -> Vec2:
    """The middle of a room, or of the widest part of one that is no rectangle."""
    outline = Polygon(room.polygon_m)
    if outline.area > 0.99 * outline.envelope.area:
        return outline.envelope.centroid.x, outline.envelope.centroid.y
    middle, _ = shapely.maximum_inscribed_circle(outline, MIDDLE_M).coords
    return float(middle[0]), float(middle[1])


def _side_of(opening: Opening, sides: tuple[Side, ...]) -> tuple[Side, float] | None:
    """The wall of a room that an opening is in, and how far along it its middle is."""
    for side in sides:
        along, away = side.measure(opening.center_m[:2])
        if abs(away) < SAME_WALL_M and 0 < along < side.length_m:
            return side, along
    return None
