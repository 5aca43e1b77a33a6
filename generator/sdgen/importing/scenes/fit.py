"""Furniture as it was found, with models of the library where a home takes them.

Every piece is tried as a build tries it: through no wall, into no other piece, in no door's way,
with room to open. One of ours keeps its model and place; of another the models of its category are
tried, the nearest in size first, a little aside where it does not fit. What fits nowhere is told.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import count
from typing import Any

import numpy as np
import shapely
from shapely.geometry import Point, Polygon

from sdgen.actions import at_rest
from sdgen.catalog.records import Catalog, FurnitureItem, HomeSpec
from sdgen.errors import InputError
from sdgen.facts import bodies_of
from sdgen.freespace import free_shape, unreachable_rooms
from sdgen.geometry import Vec3, rotation_matrix, round_position, yaw_of
from sdgen.home.anchors import BACK_GAP_M
from sdgen.home.furnish import clashing, drawn_at, fill_openings, put_piece, top_of
from sdgen.home.layout import IN_WALL_M, Intent, Layout
from sdgen.home.shell import build_shell
from sdgen.home.style import HomeStyle
from sdgen.importing.scenes.found import FoundPiece
from sdgen.importing.scenes.likeness import models_like, unlike
from sdgen.library import Asset, Library
from sdgen.rejection import Rejection
from sdgen.scene import Home, ObjectInstance, Room
from sdgen.seeding import lane
from sdgen.zones import doorway_blocked, floor_obstacles, swing_blocked

#: A piece whose back is no further from a wall than this stood against it, metres.
_AGAINST_M = 0.3
#: What stands so near below a piece, up or down, carries it, metres.
_CARRIES_M = 0.12
#: What ends lower above the floor stands on it, metres.
_ON_FLOOR_M = 0.15
#: How far aside a piece may be put, metres.
_ASIDE_M = (0.0, 0.05, 0.1, 0.2, 0.3, 0.4)
#: As like as this (a logarithm), it stands where the piece stood.
_SAME = 0.03
#: Off the axes by less than this, degrees, a piece stands along them.
_SQUARE_DEG = 3.0
#: A seat looks at a table no further away than this, metres.
_AT_TABLE_M = 1.1
#: Digits of angles: at the far end of the longest piece less than a hundredth of a millimetre.
_DIGITS = 4


@dataclass(frozen=True)
class Wanted:
    """A piece of furniture to be: what was found, its category, and the model that it must be.
    ``exact``: just as it was found, as we had it."""

    piece: FoundPiece
    category: str
    room: int
    model: str | None = None
    exact: bool = False


@dataclass(frozen=True)
class Fitted:
    """A piece that stands: how it is drawn, in which room (by index), and what it was."""

    item: FurnitureItem
    room: int
    wanted: Wanted
    object_id: int


class Fitter:
    """A home with its doors and windows, that furniture is put into. Changes as it is."""

    def __init__(self, spec: HomeSpec, catalog: Catalog, library: Library) -> None:
        self._catalog, self._library = catalog, library
        self._rng = lane(0, 0, f"import:{spec.id}")
        ids = count(1)
        self.home: Home = build_shell(spec, HomeStyle(), library, ids, self._rng)
        empty = Layout(library, ids)
        models = library.by_category
        layout = fill_openings(spec, self.home, empty, HomeStyle(), models, self._rng)
        if isinstance(layout, Rejection):
            raise InputError(
                [f"the library has no {layout.cause.category} of the size of openings"]
            )
        for item in list(layout.items.values()):
            layout.put(at_rest(item, library.assets[item.asset]))
        self.layout = layout
        self._doors = bodies_of(list(layout.items.values()), library.infos)
        self._placed: list[dict[str, list[int]]] = [{} for _ in spec.rooms]
        self.fitted: list[Fitted] = []

    def fit(self, wanted: Wanted) -> str | None:
        """Put a piece; why it cannot be, when it cannot."""
        room = self.home.rooms[wanted.room]
        why: str | None = None
        models = self._models(wanted)
        if not models:
            return f"the library has no {wanted.category} of about its size"
        exact = wanted.exact
        for asset in models:
            for item in self._draws(wanted, asset, room, exact):
                told = self._put(item, asset, wanted)
                if told is None:
                    return None
                why = why or f"{told} (as {asset.id})"
        return why

    def _models(self, wanted: Wanted) -> list[Asset]:
        if wanted.model is None:
            return models_like(wanted.category, wanted.piece.extents_m, self._library)
        known = self._library.by_category(wanted.category)
        return [model for model in known if model.id == wanted.model]

    # --- where -----------------------------------------------------------------------------------

    def _draws(
        self, wanted: Wanted, asset: Asset, room: Room, exact: bool
    ) -> Iterator[FurnitureItem]:
        """Ways to draw a piece, the truest first."""
        piece = wanted.piece
        x, y, z = piece.position_m
        yaw = yaw_of(piece.quat_xyzw)
        if not exact:
            yaw = math.remainder(self._heading(wanted, asset, room), 2 * math.pi)
            if unlike(asset.extents_m, piece.extents_m) > _SAME or not piece.sized:
                x, y = self._backed(piece, asset, yaw, room)
        on = self._carrier(wanted, (x, y, z))
        if not exact and on is None:
            z = 0.0 if z < _ON_FLOOR_M else z
            z = max(0.0, min(z, room.height_m - asset.extents_m[2]))
        for aside in (0.0,) if exact else _ASIDE_M:
            ways = ((0, 0),) if not aside else ((1, 0), (-1, 0), (0, 1), (0, -1), (1, 1), (-1, -1))
            for dx, dy in ways:
                # Along and across the piece: a row of cabinets moves along its wall.
                cos, sin = math.cos(yaw), math.sin(yaw)
                at = (x + aside * (cos * dx - sin * dy), y + aside * (sin * dx + cos * dy), z)
                yield FurnitureItem(
                    category=wanted.category,
                    model=asset.id,
                    position_m=round_position(at),
                    yaw_deg=round(math.degrees(yaw), _DIGITS) + 0.0,
                    on=on,
                    **(_standing(piece) if exact else {}),
                )

    def _heading(self, wanted: Wanted, asset: Asset, room: Room) -> float:
        """Which way a piece looks: as it says, or with its back to the nearest wall, a seat at its
        table."""
        piece = wanted.piece
        yaw = yaw_of(piece.quat_xyzw)
        quarter = math.pi / 2
        off = math.degrees(math.remainder(yaw, quarter))
        if abs(off) < _SQUARE_DEG:
            yaw = round(yaw / quarter) * quarter
        if piece.front:
            return yaw
        deep, wide, _ = piece.extents_m
        straight = unlike(asset.extents_m, piece.extents_m, turned=False)
        across = unlike(asset.extents_m, (wide, deep, piece.extents_m[2]), turned=False)
        turns = [0, 1, 2, 3]
        if abs(straight - across) > 0.1:
            turns = [0, 2] if straight < across else [1, 3]
        outline = Polygon(room.polygon_m)
        seat = "SITTABLE" in self._catalog.category(wanted.category).properties
        table = self._table_of(piece) if seat else None

        def open_before(turn: int) -> tuple[float, float]:
            heading = yaw + turn * quarter
            way = np.array([math.cos(heading), math.sin(heading)])
            middle = np.array(piece.position_m[:2])
            if table is not None:
                return float(way @ (table - middle)), 0.0
            half = (deep if turn % 2 == 0 else wide) / 2
            behind = Point(middle - way * (half + _AGAINST_M))
            before = Point(middle + way * (half + 0.6))
            backed = 0.0 if outline.covers(behind) else 1.0
            free = 1.0 if outline.covers(before) else 0.0
            return backed + free, outline.exterior.distance(before)

        return yaw + max(turns, key=open_before) * quarter

    def _table_of(self, piece: FoundPiece) -> np.ndarray[tuple[int], np.dtype[np.float64]] | None:
        near = []
        for item in self.layout.items.values():
            if "SAT_AT" not in self._catalog.category(item.category).properties:
                continue
            apart = math.dist(item.pose.position_m[:2], piece.position_m[:2])
            half = max(self._library.assets[item.asset].extents_m[:2]) / 2
            if apart - half < _AT_TABLE_M:
                near.append((apart, item.pose.position_m[:2]))
        return np.array(min(near)[1]) if near else None

    def _backed(
        self, piece: FoundPiece, asset: Asset, yaw: float, room: Room
    ) -> tuple[float, float]:
        """Where the model's middle goes: its back at the wall where the piece's was."""
        x, y = piece.position_m[:2]
        way = np.array([math.cos(yaw), math.sin(yaw)])
        turn = np.abs(rotation_matrix(piece.quat_xyzw))[:2, :2]
        half = float(np.abs(way) @ (turn @ piece.extents_m[:2])) / 2
        outline = Polygon(room.polygon_m)
        ray = shapely.LineString([(x, y), tuple(np.array((x, y)) - way * (half + _AGAINST_M))])
        if outline.covers(ray) or not outline.covers(Point(x, y)):
            return x, y
        wall = outline.exterior.intersection(ray)
        to_wall = wall.distance(Point(x, y))
        reach = self._library.reach(asset.id)
        gap = 0.005 if piece.position_m[2] > 0.3 else BACK_GAP_M
        away = asset.extents_m[0] / 2 + max(gap, reach.back_m)
        moved = np.array((x, y)) + way * (away - to_wall)
        return float(moved[0]), float(moved[1])

    def _carrier(self, wanted: Wanted, at: Vec3) -> str | None:
        """The category of what carries a piece; None when it stands on the floor, or hangs."""
        if at[2] < 0.05:
            return None
        point = Point(at[:2])
        if not wanted.exact:
            return self._carrier_found(wanted, point, at[2])
        for category, ids in self._placed[wanted.room].items():
            for key in ids:
                under = any(b.shape.distance(point) < 1e-6 for b in self.layout.space_of(key))
                if under and abs(top_of(self.layout, key) - at[2]) < 1e-3:
                    return category
        return None

    def _carrier_found(self, wanted: Wanted, point: Point, z: float) -> str | None:
        """The same of what was found: its carrier may have another height here."""
        for other in self.fitted:
            if other.room != wanted.room or other.wanted.piece is wanted.piece:
                continue
            under = any(
                b.shape.distance(point) < 1e-6 for b in self.layout.space_of(other.object_id)
            )
            if under and abs(other.wanted.piece.top_m - z) < _CARRIES_M:
                return other.item.category
        return None

    # --- whether ---------------------------------------------------------------------------------

    def _put(self, item: FurnitureItem, asset: Asset, wanted: Wanted) -> str | None:
        room = self.home.rooms[wanted.room]
        placed = self._placed[wanted.room]
        drawn = drawn_at(item, asset, room, self.layout, placed, self._rng)
        if drawn is None:
            return "nothing carries it"
        thing, intent = drawn
        why = self._why_not(thing, asset, intent, room)
        if why is not None:
            return why
        if not put_piece(thing, asset, self.layout, intent, room, self._catalog):
            return "what opens of it, or of another beside it, has no room to"
        if intent is None and wanted.exact:
            z = thing.pose.position_m[2]
            if abs(z - wanted.piece.position_m[2]) > 0.01:
                item = item.model_copy(update={"on": None})
        placed.setdefault(item.category, []).append(thing.id)
        self.fitted.append(Fitted(item, wanted.room, wanted, thing.id))
        return None

    def _why_not(
        self, thing: ObjectInstance, asset: Asset, intent: Intent | None, room: Room
    ) -> str | None:
        (body,) = bodies_of([thing], self._library.infos)
        points = shapely.points(body.corners[:, :2])
        beyond = float(shapely.distance(Polygon(room.polygon_m), points).max())
        if beyond > IN_WALL_M:
            return f"reaches {beyond:.2f} m into a wall of {room.name!r}"
        if body.high[2] > room.height_m:
            return f"ends {body.high[2]:.2f} m up, above the ceiling"
        cut = sorted(set(clashing(self.layout.blocks_of(thing), asset, self.layout, intent)))
        if cut:
            names = ", ".join(self.layout.items[key].category for key in cut)
            return f"cuts into {names}"
        if swing_blocked([*self._doors, body]):
            return "stands where a door swings"
        if doorway_blocked(self.home, [body]):
            return "stands in a doorway"
        return None

    # --- ways ------------------------------------------------------------------------------------

    def clear_ways(self) -> list[tuple[Fitted, str]]:
        """Take out what cuts rooms off, the least piece that opens the way first; what went."""
        gone: list[tuple[Fitted, str]] = []
        while cut_off := self._cut_off(self.fitted):
            standing = [one for one in self.fitted if one.item.position_m[2] < 0.3]
            standing.sort(
                key=lambda one: (
                    self._library.assets[one.item.model or ""].extents_m[0]
                    * self._library.assets[one.item.model or ""].extents_m[1]
                )
            )
            freed = next(
                (
                    one
                    for one in standing
                    if len(self._cut_off([f for f in self.fitted if f is not one])) < len(cut_off)
                ),
                None,
            )
            if freed is None:
                # No single one: of the room that is cut off, the largest, and look again.
                inside = [o for o in standing if self.home.rooms[o.room].name == cut_off[0]]
                freed = (inside or standing or [None])[-1]  # type: ignore[list-item]
            if freed is None:
                return gone
            for one in self._with_what_it_carries(freed):
                self.fitted.remove(one)
                self.layout.drop(one.object_id)
                self._placed[one.room][one.item.category].remove(one.object_id)
                gone.append((one, f"would leave no way to room {cut_off[0]!r}"))
        return gone

    def _with_what_it_carries(self, piece: Fitted) -> Sequence[Fitted]:
        above = [
            one
            for one in self.fitted
            if (intent := self.layout.intents.get(one.object_id)) is not None
            and intent.target_id == piece.object_id
        ]
        return [piece, *above]

    def _cut_off(self, standing: Sequence[Fitted]) -> list[str]:
        """Names of rooms that nobody gets to."""
        items = [self.layout.items[one.object_id] for one in standing]
        bodies = bodies_of(items, self._library.infos)
        free = free_shape(self.home, floor_obstacles(bodies))
        return [room.name for room in unreachable_rooms(self.home, free)]


def _standing(piece: FoundPiece) -> dict[str, Any]:
    """How a piece of ours stands: its variant, and the joints that do not rest."""
    if piece.note is None:
        return {}
    joints = {name: value for name, value in piece.note.joints.items() if value}
    return {"variant": piece.note.variant, "joints": joints}
