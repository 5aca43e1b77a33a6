"""Doors and windows as base homes have them: of fixed sizes, in the middle of walls, one front
door, a way to every room.

What is found is moved to the wall that is nearest; what a base home cannot have is told. Where no
door leads to a room, one is added, and told as well.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Literal

import shapely
from shapely.geometry import Point, Polygon, box
from shapely.geometry.base import BaseGeometry

from sdgen.catalog.home_shape import FRAME_M, SMALL_WINDOW_M, frame_size, inner_ring, rooms_beside
from sdgen.catalog.records import OpeningSpec, RoomSpec
from sdgen.geometry import rotation_matrix
from sdgen.importing.scenes.found import FoundOpening, FoundPiece, FoundScene, footprint
from sdgen.importing.scenes.naming import OpeningWord
from sdgen.importing.scenes.walls import Wall, holes_in, walls_of
from sdgen.vocabulary import DOORS, HALF_WALL_M, INNER_DOORS, OPENINGS

#: A door or window is of a wall no further away than this, metres.
_NEAR_M = 0.7
#: What holds the largest door of a base home, with something above it, metres.
LEAST_HEIGHT_M = 2.3
#: Where something narrower may take a place, in the order in which it is tried.
_NARROWER = {
    "wide_passage": ("passage", "door"),
    "double_door": ("door",),
    "passage": ("door",),
    "door": (),
    "front_door": (),
    "window": (),
}
#: Narrower than this, metres, a window is a small one: between the two that there are.
_SMALL_M = (FRAME_M["window"][0] + SMALL_WINDOW_M[0]) / 2
#: Wider than this, metres, a way without a leaf is a wide one.
_WIDE_M = 1.6
#: What a door is no deeper than, shut, metres.
_OPEN_M = 0.35
#: Rooms that a front door is added to, the first that is there.
_ENTERED = ("hall", "corridor", "living_room", "kitchen", "dining_room")
#: Steps in which a place for a door is looked for, and how far before it stays free, metres.
_STEP_M, _FREE_M = 0.2, 1.0
#: What a door fills is as wide as its hole, but for its frame, metres.
_OTHER_WIDTH_M = 0.35
#: What hangs higher is walked under, metres.
_OVERHEAD_M = 2.0


def opening_from(piece: FoundPiece, kind: OpeningWord) -> FoundOpening:
    """A found door or window by its box: the wall runs along its longer side, or, where its front
    is known, across that."""
    deep, wide, high = piece.extents_m
    turn = rotation_matrix(piece.quat_xyzw)
    looks = turn[:, 0] if piece.front or deep <= wide else turn[:, 1]
    if kind == "passage" and max(deep, wide) > _WIDE_M:
        kind = "wide_passage"
    if kind == "door" and max(deep, wide) > _WIDE_M - 0.2 and not piece.front:
        kind = "double_door"
    along: Literal["x", "y"] | None = "y" if abs(looks[0]) > abs(looks[1]) else "x"
    if not piece.front and min(deep, wide) > _OPEN_M:
        along = None  # its leaf stands open, and its box is as deep as wide
    inward = (float(looks[0]), float(looks[1])) if piece.front else None
    width = wide if piece.front else max(deep, wide)
    return FoundOpening(piece.name, kind, piece.position_m, along, width, high, inward, piece.note)


def _turned(joints: Mapping[str, float]) -> dict[str, float]:
    """The joints that do not rest."""
    return {name: value for name, value in joints.items() if value}


@dataclass
class _Plan:
    rooms: Sequence[RoomSpec]
    scene: FoundScene
    height_m: float
    walls: list[Wall] = field(init=False)
    openings: list[OpeningSpec] = field(default_factory=list)

    def __post_init__(self) -> None:
        self.rings = [inner_ring(room) for room in self.rooms]
        self.walls = list(walls_of(self.rings))
        self.standing = _standing(self.scene.pieces)
        low = shapely.union_all([wall.at_knee(0.0) for wall in self.scene.walls])
        self.holes = [] if low.is_empty else [*holes_in(self.walls, low)]

    # --- what was found --------------------------------------------------------------------------

    def take(self, found: FoundOpening) -> None:
        """Take an opening to the wall it is in."""
        kinds = [found.kind, *_NARROWER[found.kind]]
        fronted = any(o.kind == "front_door" for o in self.openings)
        if found.kind in INNER_DOORS and not fronted:
            kinds.append("front_door")
        elif found.kind == "front_door" and fronted:
            kinds = ["door"]
        for kind in kinds:
            for wall in self._near(found, kind):
                spec = self._placed(found, kind, wall)
                if spec is not None:
                    self.openings.append(spec)
                    if kind != found.kind:
                        text = f"{found.name}: a {found.kind} that is built as {kind}"
                        self.scene.told.append(text)
                    return
        self.scene.unresolved.append(f"{found.name}: no wall near it has room for a {found.kind}")

    def _near(self, found: FoundOpening, kind: str) -> list[Wall]:
        """Walls that an opening of a kind may be in, the nearest first."""
        one_side = kind in ("front_door", "window")
        out = []
        for wall in self.walls:
            if (len(wall.rooms) == 1) != one_side and not (kind == "window" and not one_side):
                continue
            if found.along is not None and wall.along != found.along:
                continue
            axis = 0 if wall.along == "x" else 1
            across = abs(found.center_m[1 - axis] - wall.at)
            beside = max(0.0, wall.low - found.center_m[axis], found.center_m[axis] - wall.high)
            if across <= _NEAR_M and beside <= _NEAR_M:
                hole = self._hole(wall, found, found.width_m)
                out.append((hole is None, across + beside, wall))
        return [wall for *_, wall in sorted(out, key=lambda item: item[:2])]

    def _placed(self, found: FoundOpening, kind: str, wall: Wall) -> OpeningSpec | None:
        small = kind == "window" and found.width_m < _SMALL_M
        width, high = SMALL_WINDOW_M if small else FRAME_M[_kind(kind)]
        axis = 0 if wall.along == "x" else 1
        sill = 0.0
        if kind == "window":
            most = min(3.0, self.height_m - high)
            sill = round(min(max(found.center_m[2], 0.0), most), 3)
            if sill < 0:
                return None
        elif high > self.height_m:
            return None
        wanted = self._hole(wall, found, width)
        place = self._free_at(wall, found.center_m[axis] if wanted is None else wanted, width)
        if place is None:
            return None
        flip = False
        if found.inward is not None and len(wall.rooms) == 2:
            x, y = wall.center(place)
            probe = Point(x + found.inward[0] * 0.3, y + found.inward[1] * 0.3)
            flip = Polygon(self.rings[wall.rooms[1]]).buffer(0.01).covers(probe)
        return OpeningSpec(
            kind=_kind(kind),
            center_m=wall.center(place),
            along=wall.along,
            sill_m=sill,
            small=small,
            hinge_flip=flip,
            model=None if found.note is None else found.note.model,
            joints={} if found.note is None else _turned(found.note.joints),
        )

    def _hole(self, wall: Wall, found: FoundOpening, width: float) -> float | None:
        """The middle of the hole that a door is in: its own box is askew when it stands open."""
        if found.inward is not None or found.kind == "window":
            return None
        axis = 0 if wall.along == "x" else 1
        near = [
            (abs((low + high) / 2 - found.center_m[axis]), (low + high) / 2)
            for other, low, high in self.holes
            if other == wall and abs(high - low - width) < _OTHER_WIDTH_M
        ]
        apart, middle = min(near, default=(_NEAR_M, 0.0))
        return middle if apart < _NEAR_M else None

    def take_holes(self) -> None:
        """Ways through walls that nothing fills: passages, and out of the home a front door."""
        for wall, low, high in self.holes:
            kind: OpeningWord = "passage" if high - low < _WIDE_M else "wide_passage"
            if len(wall.rooms) == 1:
                if any(o.kind == "front_door" for o in self.openings):
                    continue
                kind = "front_door"
            x, y = wall.center((low + high) / 2)
            if any(
                o.along == wall.along and abs(o.center_m[0] - x) + abs(o.center_m[1] - y) < _NEAR_M
                for o in self.openings
            ):
                continue
            name = " and ".join(repr(self.rooms[k].name) for k in wall.rooms)
            hole = FoundOpening(
                f"the hole in the wall of {name}", kind, (x, y, 0.0), wall.along, high - low, 2.1
            )
            for one in (kind, *_NARROWER[kind]):
                spec = self._placed(hole, one, wall)
                if spec is not None:
                    self.openings.append(spec)
                    break

    def _free_at(self, wall: Wall, wanted: float, width: float) -> float | None:
        """The place on a wall nearest to ``wanted`` where an opening is whole and alone."""
        least, most = wall.low + width / 2, wall.high - width / 2
        if least > most + 1e-6:
            return None
        taken = [
            (o.center_m[0 if wall.along == "x" else 1], frame_size(o)[0] / 2 + width / 2)
            for o in self.openings
            if o.along == wall.along
            and abs(o.center_m[1 if wall.along == "x" else 0] - wall.at) < 2 * HALF_WALL_M
        ]
        # Beside what is there, or as near as may be.
        tries = [wanted, *(at + side * reach for at, reach in taken for side in (-1.0001, 1.0001))]
        free = [
            at
            for at in (min(max(one, least), most) for one in tries)
            if all(abs(at - other) >= reach - 1e-6 for other, reach in taken)
        ]
        if not free:
            return None
        # To the millimetre, but never over an end by rounding.
        place = min(free, key=lambda at: abs(at - wanted))
        rounded = round(place, 3)
        return rounded if least - 1e-6 <= rounded <= most + 1e-6 else round(place, 5)

    # --- what is missing -------------------------------------------------------------------------

    def complete(self) -> list[int]:
        """Add the front door and ways between rooms that are missing; the rooms that none leads
        to."""
        if not any(opening.kind == "front_door" for opening in self.openings):
            self._add_front()
        while True:
            cut_off = sorted(set(range(len(self.rooms))) - self._reached())
            if not cut_off or not self._add_way(set(cut_off)):
                return cut_off

    def _add_front(self) -> None:
        def rank(room: RoomSpec) -> int:
            return _ENTERED.index(room.type) if room.type in _ENTERED else len(_ENTERED)

        order = sorted(range(len(self.rooms)), key=lambda k: (rank(self.rooms[k]), k))
        for k in order:
            outer = [wall for wall in self.walls if wall.rooms == (k,)]
            spec = self._best("front_door", outer)
            if spec is not None:
                self.openings.append(spec)
                name = self.rooms[k].name
                self.scene.told.append(f"no front door was found: one was added to {name!r}")
                return

    def _add_way(self, cut_off: set[int]) -> bool:
        between = [w for w in self.walls if len(w.rooms) == 2 and len(cut_off & {*w.rooms}) == 1]
        for kind in ("door",):
            spec = self._best(kind, between)
            if spec is not None:
                self.openings.append(spec)
                names = [self.rooms[k].name for k in rooms_beside(self.rings, spec)]
                self.scene.told.append(f"no way into {' or '.join(names)}: a door was added")
                return True
        return False

    def _best(self, kind: str, walls: Sequence[Wall]) -> OpeningSpec | None:
        """A new opening where least stands in its way; None where no wall is wide enough."""
        best: tuple[float, float, Wall] | None = None
        width, _ = FRAME_M[_kind(kind)]
        for wall in walls:
            middle = (wall.low + wall.high) / 2
            count = max(0, int((wall.high - wall.low - width) / 2 / _STEP_M))
            for step in range(-count, count + 1):
                place = self._free_at(wall, middle + step * _STEP_M, width)
                if place is None:
                    continue
                in_way = self.standing.intersection(_before(wall, place, width)).area
                # Of as good ones, one near the end of its wall, as doors are.
                cost = in_way - 0.01 * abs(place - middle)
                if best is None or cost < best[0] - 1e-9:
                    best = (cost, place, wall)
        if best is None:
            return None
        _, place, wall = best
        return OpeningSpec(kind=_kind(kind), center_m=wall.center(place), along=wall.along)

    def _reached(self) -> set[int]:
        joined = [
            (opening.kind, set(rooms_beside(self.rings, opening)))
            for opening in self.openings
            if opening.kind in DOORS
        ]
        reached = {k for kind, rooms in joined if kind == "front_door" for k in rooms}
        while more := {k for _, rooms in joined if rooms & reached for k in rooms} - reached:
            reached |= more
        return reached


def openings_of(
    scene: FoundScene, rooms: Sequence[RoomSpec], height_m: float
) -> tuple[tuple[OpeningSpec, ...], list[int]]:
    """The openings of these rooms, and the rooms (by index) that no way leads to."""
    plan = _Plan(rooms, scene, height_m)
    # Front doors first: a door in an outer wall is one only where no other is.
    order = sorted(scene.openings, key=lambda found: found.kind != "front_door")
    for found in order:
        plan.take(found)
    plan.take_holes()
    cut_off = plan.complete()
    return tuple(plan.openings), cut_off


def _kind(word: str) -> OpeningWord:
    (kind,) = (one for one in OPENINGS if one == word)
    return kind


def _before(wall: Wall, place: float, width: float) -> BaseGeometry:
    """The floor before and behind a door."""
    x, y = wall.center(place)
    along, across = width / 2 + 0.05, _FREE_M
    half = (along, across) if wall.along == "x" else (across, along)
    return box(x - half[0], y - half[1], x + half[0], y + half[1])


def _standing(pieces: Iterable[FoundPiece]) -> BaseGeometry:
    """What stands on the floor, seen from above."""
    shapes = []
    for piece in pieces:
        if piece.top_m < 0.1 or piece.position_m[2] > _OVERHEAD_M:
            continue
        turn = rotation_matrix(piece.quat_xyzw)
        x, y = piece.extents_m[0] / 2, piece.extents_m[1] / 2
        corners = [(a * x, b * y, 0.0) for a in (-1, 1) for b in (-1, 1)]
        shapes.append(footprint(corners @ turn.T + piece.position_m))
    return shapely.union_all(shapes)
