"""Which room a thing is in, from its pose alone.

It is the room whose outline is nearest to the thing's centre: 0 for the room it stands in; what
hangs in a wall or stands in a doorway belongs to the side its centre is on, and is undecided in
the very middle. Doors and windows fill an opening and belong to the room that is named first.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence

import numpy as np
import shapely
from shapely.geometry import Point, Polygon

from sdgen.catalog.predicate import Related
from sdgen.facts.body import center_of, rows
from sdgen.facts.thresholds import OUTDOORS_M, ROOM_M
from sdgen.geometry import Array
from sdgen.kleene import NO, YES, Kleene
from sdgen.library.records import AssetInfo
from sdgen.scene import Home, ObjectInstance, Room


class Rooms:
    """The rooms of a home, and who is in them."""

    def __init__(self, home: Home) -> None:
        self.by_id = {room.id: room for room in home.rooms}
        self._ids = [room.id for room in home.rooms]
        self._outlines = np.array([Polygon(room.polygon_m) for room in home.rooms])
        self._openings = {o.object_id: o for o in home.openings}

    def outline(self, room_id: int) -> Polygon:
        """The outline of a room's floor."""
        found: Polygon = self._outlines[self._ids.index(room_id)]
        return found

    def of(self, object_ids: Sequence[int], centers: Array) -> Iterator[tuple[int, ...]]:
        """For each thing with its centre (N, 3) the ids of the rooms it may be in, nearest first:
        one where that is decided, none where it is surely outdoors (and 0 among them where it may
        be)."""
        points = shapely.points(centers[:, :2])
        apart = shapely.distance(self._outlines, points[:, None]).tolist()
        for object_id, far in zip(object_ids, apart, strict=True):
            opening = self._openings.get(object_id)
            yield self._nearest(far) if opening is None else opening.room_ids[:1]

    def _nearest(self, far: Sequence[float]) -> tuple[int, ...]:
        """The rooms that a thing may be in, so far from each."""
        order = sorted(range(len(far)), key=far.__getitem__)
        nearest = far[order[0]]
        outdoors = OUTDOORS_M.at_least(nearest)
        if outdoors == YES:
            return ()
        maybe = [self._ids[k] for k in order if far[k] - nearest < ROOM_M.above]
        if outdoors == NO:
            return tuple(maybe)
        return (0, *maybe) if outdoors.value else (*maybe, 0)

    def room_ids(
        self, items: Sequence[ObjectInstance], infos: Mapping[str, AssetInfo]
    ) -> dict[int, int]:
        """The room each object is in by its pose; what it had where it is outdoors."""
        centers = rows(
            [center_of(item.pose.matrix(), infos[item.asset], item.variant) for item in items], 3
        )
        found = self.of([item.id for item in items], centers)
        return {
            item.id: next(filter(None, rooms), item.room_id)
            for item, rooms in zip(items, found, strict=True)
        }

    def between(self, object_id: int) -> Iterable[Related]:
        """Rooms a door is BETWEEN: known from the plan, so exact."""
        opening = self._openings.get(object_id)
        if opening is not None and opening.kind != "window":
            for room_id in opening.room_ids:
                yield Related(room_id, self.by_id[room_id].type, True, True)


def same_room(a: Collection[int], b: Collection[int]) -> Kleene:
    """Whether two things are in one room, given the rooms each may be in, nearest first."""
    if not set(a) & set(b):
        return NO
    return Kleene(next(iter(a)) == next(iter(b)), len(a) == len(b) == 1)


def room_at(rooms: Iterable[Room], x: float, y: float) -> Room | None:
    """The room whose outline holds the point or is nearest to it; None outdoors."""
    point = Point(x, y)
    near = [(Polygon(room.polygon_m).distance(point), room) for room in rooms]
    gap, room = min(near, key=lambda found: found[0], default=(OUTDOORS_M.limit + 1, None))
    return room if gap <= OUTDOORS_M.limit else None


def types_of(rooms: Mapping[int, Room], ids: Collection[int]) -> tuple[str, ...]:
    """Types of rooms, without repeats; "" for outdoors."""
    return tuple(dict.fromkeys(rooms[k].type if k in rooms else "" for k in ids))
