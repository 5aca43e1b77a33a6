"""Rooms as base homes draw them, from floors and walls as they were found.

Base homes are unions of rectangles on the middle lines of walls 0.12 m thick. So the home is turned
until its walls run along the axes, floors are cut at the inner faces of walls, and what lies
between two rooms, however thick, becomes one wall. Where nothing tells of rooms there is one,
around all things.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Literal

import numpy as np
import shapely
from pydantic import ValidationError
from shapely.geometry import Polygon, box
from shapely.geometry.base import BaseGeometry
from shapely.geometry.polygon import orient

from sdgen.catalog.home_shape import OutlineError, inner_ring
from sdgen.catalog.records import RoomSpec
from sdgen.geometry import quat_from_yaw, rotation_matrix, vec3
from sdgen.importing.scenes.found import FoundPiece, FoundScene, moved_down
from sdgen.importing.scenes.naming import room_word
from sdgen.importing.scenes.rectangles import Rect, joined, main_turn, rectangles_of, turned
from sdgen.vocabulary import HALF_WALL_M

#: Less is no room, square metres, but a niche, a shaft or what floors and walls leave between them.
LEAST_ROOM_M2 = 0.7
#: Between the sides of two rooms that face each other, so much is a wall, metres.
_THICKEST_M = 0.45
#: Walls in one line with no more between them than this have a doorway there, metres.
_DOORWAY_M = 1.4
#: What begins higher, metres, is over a door.
_LINTEL_M = 1.7
#: Things whose bottoms are no further apart than this stand on one floor, metres.
_LEVEL_M = 0.03
#: Tiles of one floor with no more between them than twice this, metres, are one floor.
_SEAM_M = 0.02
#: A room is wider than twice this everywhere, metres.
_HAIR_M = 0.1
#: Floors within this of each other, metres, are of one storey.
_STOREY_M = 0.8
#: A wall that covers less, square metres, is a face alone; so near to a wall it is that wall's.
_THIN_M2, _FACE_M = 0.01, 0.02
#: Left around things where nothing tells where walls are, metres.
_AROUND_M = 0.05


@dataclass(frozen=True)
class FoundRoom:
    """A room to be: ``type`` None where nobody says it."""

    name: str
    type: str | None
    rectangles_m: tuple[Rect, ...]

    def spec(self, kind: str) -> RoomSpec:
        """The room of a base home."""
        return RoomSpec(name=self.name, type=kind, rectangles_m=self.rectangles_m)


def level_and_square(scene: FoundScene) -> FoundScene:
    """The scene with its fullest storey's floor at 0 and its walls along the axes."""
    scene = _one_storey(scene)
    shapes = [wall.shape for wall in scene.walls] or [floor.shape for floor in scene.floors]
    turn = main_turn(shapes)
    if not turn:
        return scene
    scene.told.append(f"turned by {-math.degrees(turn):.2f} degrees: its walls run along the axes")
    return _turned(scene, -turn)


def _where_most_stand(scene: FoundScene) -> float:
    """The level of a floor that is not there: the lowest on which half as many things stand as
    on the one with most, for here and there one has sunk or lies on its side."""
    bottoms = np.sort([piece.position_m[2] for piece in scene.pieces])
    if len(bottoms) == 0:
        return 0.0
    standing = [int(np.sum(np.abs(bottoms - level) <= _LEVEL_M)) for level in bottoms]
    first = next(k for k, count in enumerate(standing) if 2 * count >= max(standing))
    return float(np.median(bottoms[np.abs(bottoms - bottoms[first]) <= _LEVEL_M]))


def _one_storey(scene: FoundScene) -> FoundScene:
    levels = sorted({round(floor.level_m, 2) for floor in scene.floors})
    if not levels:
        low = min((wall.low_m for wall in scene.walls), default=_where_most_stand(scene))
        return moved_down(scene, low)
    storeys = [[levels[0]]]
    for level in levels[1:]:
        if level - storeys[-1][-1] > _STOREY_M:
            storeys.append([])
        storeys[-1].append(level)

    def area(storey: Sequence[float]) -> float:
        inside = (f for f in scene.floors if storey[0] - 0.01 <= f.level_m <= storey[-1] + 0.01)
        return float(sum(floor.shape.area for floor in inside))

    chosen = max(storeys, key=area)
    floor_m = float(np.median(chosen))
    if len(storeys) == 1:
        return moved_down(scene, floor_m)
    higher = [storey[0] for storey in storeys if storey[0] > chosen[0]]
    low, high = chosen[0] - _STOREY_M, min(higher, default=math.inf) - 0.2
    scene.told.append(
        f"it has {len(storeys)} storeys; base homes have one: that with most floor was taken"
    )
    for piece in scene.pieces:
        if not low <= piece.position_m[2] < high:
            scene.unresolved.append(f"{piece.name}: stands in another storey")
    kept = replace(
        scene,
        floors=[f for f in scene.floors if chosen[0] - 0.01 <= f.level_m <= chosen[-1] + 0.01],
        walls=[w for w in scene.walls if w.low_m < high - 0.5 and w.high_m > low + 1.0],
        openings=[o for o in scene.openings if low <= o.center_m[2] < high],
        pieces=[p for p in scene.pieces if low <= p.position_m[2] < high],
    )
    return moved_down(kept, floor_m)


def _turned(scene: FoundScene, angle: float) -> FoundScene:
    turn = rotation_matrix(quat_from_yaw(angle))

    def piece(one: FoundPiece) -> FoundPiece:
        x, y, z, w = one.quat_xyzw
        c, s = math.cos(angle / 2), math.sin(angle / 2)
        quat = (c * x - s * y, c * y + s * x, c * z + s * w, c * w - s * z)
        return replace(one, position_m=vec3(turn @ one.position_m), quat_xyzw=quat)

    quarter = abs(round(math.degrees(angle))) >= 45
    swapped: dict[str | None, Literal["x", "y"] | None] = {"x": "y", "y": "x", None: None}
    return replace(
        scene,
        floors=[replace(f, shape=turned(f.shape, angle)) for f in scene.floors],
        walls=[
            replace(
                wall,
                shape=turned(wall.shape, angle),
                low_shape=None if wall.low_shape is None else turned(wall.low_shape, angle),
            )
            for wall in scene.walls
        ],
        openings=[
            replace(
                o,
                center_m=vec3(turn @ o.center_m),
                along=swapped[o.along] if quarter else o.along,
                inward=None if o.inward is None else tuple((turn @ (*o.inward, 0.0))[:2].tolist()),
            )
            for o in scene.openings
        ],
        pieces=[piece(one) for one in scene.pieces],
    )


def rooms_of(scene: FoundScene) -> list[FoundRoom]:
    """The rooms of a scene that stands level and square, largest first where nobody orders them."""
    if scene.drawn:
        return _as_drawn(scene)
    floors = list(_inner_floors(scene, _closed(scene)))
    taken: list[tuple[str, str | None, BaseGeometry]] = []
    for name, kind, inner in floors:
        # Hairs between pieces of wall would become spikes.
        plain = inner.buffer(-_HAIR_M, join_style="mitre")
        parts = shapely.get_parts(plain.buffer(_HAIR_M + HALF_WALL_M, join_style="mitre"))
        shape = max(parts, key=lambda part: part.area, default=Polygon())
        if shape.area > LEAST_ROOM_M2:
            taken.append((name, kind, shape))
        else:
            scene.unresolved.append(f"floor {name!r}: leaves no room of {LEAST_ROOM_M2} m2")
    drawn = _apart(_snapped([rectangles_of(shape) for _, _, shape in taken]))
    rooms: list[FoundRoom] = []
    for (name, kind, _), rectangles in zip(taken, drawn, strict=True):
        room = FoundRoom(_fresh(name, rooms), kind, rectangles)
        mended = _sound(room)
        if mended is None:
            scene.unresolved.append(f"room {name!r}: its outline cannot be drawn with rectangles")
        else:
            rooms.append(mended)
    return rooms


def _apart(rooms: Sequence[tuple[Rect, ...]]) -> list[tuple[Rect, ...]]:
    """The rooms without what an earlier one has already."""
    before: BaseGeometry = Polygon()
    out = []
    for room in rooms:
        shape = joined(room)
        out.append(
            room
            if shape.intersection(before).area < 1e-6
            else rectangles_of(shape.difference(before))
        )
        before = before.union(shape)
    return out


def _as_drawn(scene: FoundScene) -> list[FoundRoom]:
    """The rooms of our own export: their floors are what was drawn."""
    rooms: list[FoundRoom] = []
    for floor in scene.floors:
        room = FoundRoom(_fresh(floor.name, rooms), floor.type, rectangles_of(floor.shape))
        mended = _sound(room)
        if mended is not None:
            rooms.append(mended)
        else:
            scene.unresolved.append(f"room {floor.name!r}: its floor is none that we drew")
    return rooms


def _fresh(name: str, rooms: Sequence[FoundRoom]) -> str:
    word = room_word(name, "room")
    taken = {room.name for room in rooms}
    number = 2
    fresh = word
    while fresh in taken:
        fresh, number = f"{word}_{number}", number + 1
    return fresh


def _closed(scene: FoundScene) -> BaseGeometry:
    """What walls and openings cover, seen from above, with doorways between walls filled."""
    shapes = [wall.shape for wall in scene.walls]
    thick = shapely.union_all([shape for shape in shapes if shape.area > _THIN_M2])
    # A face by itself is a wall only where no wall is behind it: tiles and papers are none.
    near = thick.buffer(_FACE_M, join_style="mitre")
    shapes = [shape for shape in shapes if shape.area > _THIN_M2 or not near.covers(shape)]
    whole = shapely.union_all(shapes)
    if any(wall.low_m > _LINTEL_M for wall in scene.walls):
        return whole  # what is over doors closes them
    boxes = [shape.bounds for shape in shapes if not shape.is_empty]
    fills = []
    for k, a in enumerate(boxes):
        for b in boxes[:k]:
            for axis in (0, 1):
                gap = max(a[axis], b[axis]) - min(a[axis + 2], b[axis + 2])
                low = max(a[1 - axis], b[1 - axis])
                high = min(a[3 - axis], b[3 - axis])
                thick = max(a[3 - axis] - a[1 - axis], b[3 - axis] - b[1 - axis])
                if 0.02 < gap < _DOORWAY_M and high - low >= 0 and thick < _THICKEST_M:
                    start, end = min(a[axis + 2], b[axis + 2]), max(a[axis], b[axis])
                    ends = (start, low, end, high) if axis == 0 else (low, start, high, end)
                    fills.append(box(*ends))
    return shapely.union_all([whole, *fills]) if fills else whole


def _inner_floors(
    scene: FoundScene, walls: BaseGeometry
) -> Iterator[tuple[str, str | None, BaseGeometry]]:
    """What is walked on in each room: its name, its type where that is known, and its shape."""
    for floor in scene.floors:
        whole = floor.shape.buffer(_SEAM_M, join_style="mitre")
        inner = whole.buffer(-_SEAM_M, join_style="mitre").difference(walls)
        # What floor lies under a door is no part of the room, nor is what is left beyond walls.
        parts = [p for p in shapely.get_parts(inner) if p.area > LEAST_ROOM_M2]
        if not parts:
            yield floor.name, floor.type, inner
        several = len(parts) > 1
        for number, part in enumerate(sorted(parts, key=lambda p: -p.area), start=1):
            yield (f"{floor.name}_{number}" if several else floor.name), floor.type, part
    if scene.floors:
        return
    holes = [
        Polygon(hole)
        for part in shapely.get_parts(walls)
        if isinstance(part, Polygon)
        for hole in part.interiors
    ]
    holes = [hole for hole in holes if hole.area > LEAST_ROOM_M2]
    if holes:
        scene.told.append("no floors are there: rooms are what walls go round")
        for number, hole in enumerate(sorted(holes, key=lambda h: -h.area), start=1):
            yield f"room_{number}", None, hole
        return
    ends = [_reach(piece) for piece in scene.pieces]
    if not ends:
        return
    scene.told.append("neither floors nor walls are there: one room was drawn around all things")
    around = shapely.union_all([box(*e) for e in ends]).buffer(_AROUND_M, join_style="mitre")
    yield "room", None, around.envelope


def _reach(piece: FoundPiece) -> Rect:
    turn = np.abs(rotation_matrix(piece.quat_xyzw))[:2, :2]
    x, y = (turn @ piece.extents_m[:2] / 2).tolist()
    return (
        piece.position_m[0] - x,
        piece.position_m[1] - y,
        piece.position_m[0] + x,
        piece.position_m[1] + y,
    )


def _snapped(rooms: Sequence[tuple[Rect, ...]]) -> list[tuple[Rect, ...]]:
    """The rooms with sides that face each other across a wall on one line, its middle."""
    sides = [list(_sides(joined(room))) for room in rooms]
    lines = _Lines()
    for k, first in enumerate(sides):
        for second in sides[:k]:
            for a in first:
                for b in second:
                    lines.face(a, b)
    if not lines.any:
        return list(rooms)
    out = []
    for room in rooms:
        moved = [
            (lines.at(0, a), lines.at(1, b), lines.at(0, c), lines.at(1, d)) for a, b, c, d in room
        ]
        out.append(tuple(r for r in moved if r[2] - r[0] > 1e-3 and r[3] - r[1] > 1e-3))
    return out


#: A side of an outline: axis across it, its place there, from and to along it, which way is out.
_Side = tuple[int, float, float, float, float]


def _sides(outline: BaseGeometry) -> Iterator[_Side]:
    for part in shapely.get_parts(outline):
        ring = shapely.get_coordinates(orient(part).exterior)
        for (ax, ay), (bx, by) in pairwise(ring.tolist()):
            if abs(ax - bx) < 1e-9:  # counter-clockwise: out is +x where it goes up
                yield 0, ax, min(ay, by), max(ay, by), math.copysign(1.0, by - ay)
            else:
                yield 1, ay, min(ax, bx), max(ax, bx), math.copysign(1.0, ax - bx)


class _Lines:
    """Lines of sides that are to be one, by axis and place."""

    def __init__(self) -> None:
        self._same: dict[tuple[int, float], set[tuple[int, float]]] = {}

    @property
    def any(self) -> bool:
        """True when some line is to move."""
        return bool(self._same)

    def face(self, a: _Side, b: _Side) -> None:
        """Join the lines of two sides that face each other across a wall."""
        if a[0] != b[0] or a[4] == b[4] or min(a[3], b[3]) - max(a[2], b[2]) < 0.3:
            return
        between = (b[1] - a[1]) * a[4]
        if not 1e-4 < abs(between) < _THICKEST_M:
            return
        first, second = (a[0], round(a[1], 4)), (b[0], round(b[1], 4))
        group = self._same.get(first, {first}) | self._same.get(second, {second})
        for line in group:
            self._same[line] = group

    def at(self, axis: int, place: float) -> float:
        """Where a line is to be: in the middle of those that are one with it."""
        group = self._same.get((axis, round(place, 4)))
        if group is None:
            return place
        places = [line[1] for line in group]
        return round((min(places) + max(places)) / 2, 4)


def _sound(room: FoundRoom) -> FoundRoom | None:
    """The room, or the part of it that a base home can have."""
    for shape in (None, 0.2, 0.5):
        rectangles = room.rectangles_m
        if shape is not None:
            outline = joined(rectangles)
            open_ = outline.buffer(-shape, join_style="mitre").buffer(shape, join_style="mitre")
            parts = sorted(shapely.get_parts(open_), key=lambda p: -p.area)
            if not parts or parts[0].area < LEAST_ROOM_M2:
                return None
            rectangles = rectangles_of(Polygon(parts[0].exterior))
        if not rectangles:
            return None
        tried = replace(room, rectangles_m=rectangles)
        try:
            inner_ring(tried.spec("hall"))
        except (OutlineError, ValidationError):  # of one piece; out of any home
            continue
        return tried
    return None
