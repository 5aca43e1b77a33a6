"""Where on furniture people do something: places as they see them who sit or stand there."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

from shapely.geometry import LineString
from shapely.geometry.base import BaseGeometry

from sdgen.catalog.activity import Side, Where
from sdgen.catalog.records import Catalog
from sdgen.geometry import Vec2, Vec3, yaw_of
from sdgen.home.layout import Layout
from sdgen.home.surfaces import PlacingSurface
from sdgen.scene import ObjectInstance
from sdgen.seeding import Rng

#: A table so far, metres, before the front of a seat is one that people sit at; farther, they get
#: up (arms are 0.7 m long).
AT_HAND_M = 0.5
#: What is no farther than this, metres, from something is near it: a step.
STEP_M = 0.8
#: Left free at both ends of an edge, metres, where an activity is anywhere along it.
END_M = 0.22
#: Longer than any piece of furniture, metres.
FAR_M = 5.0


@dataclass(frozen=True)
class Frame:
    """A point of a surface, and which way (radians) somebody there looks over it."""

    origin: Vec2
    heading: float

    def point(self, at: Vec2) -> Vec2:
        """The point so far ahead and to the left."""
        (x, y), (ahead, left) = self.origin, at
        cos, sin = math.cos(self.heading), math.sin(self.heading)
        return x + ahead * cos - left * sin, y + ahead * sin + left * cos

    def moved(self, at: Vec2, turn: float) -> Frame:
        """The frame at another point, turned."""
        return Frame(self.point(at), self.heading + turn)


def beside(
    middle: Vec2, half: Vec2, own_half: Vec2, side: Side, gap_m: float, frame: Frame
) -> Vec2:
    """The middle of what stands on a side of something, of which the middle is given; ``half`` and
    ``own_half`` are how far either reaches ahead and to the left."""
    off = gap_m + (half[1] + own_half[1] if side in ("left", "right") else half[0] + own_half[0])
    steps: dict[Side, Vec2] = {
        "left": (0.0, off),
        "right": (0.0, -off),
        "ahead": (off, 0.0),
        "before": (-off, 0.0),
    }
    return Frame(middle, frame.heading).point(steps[side])


def half_reach(size: Vec3, turn: float) -> Vec2:
    """How far a box of a size reaches ahead and to the left, turned so against the frame."""
    cos, sin = abs(math.cos(turn)), abs(math.sin(turn))
    return (cos * size[0] + sin * size[1]) / 2, (sin * size[0] + cos * size[1]) / 2


def main_surface(layout: Layout, object_id: int) -> PlacingSurface | None:
    """The largest open surface of a piece; None when it has none."""
    open_ones = [s for s in layout.surfaces_of(object_id) if s.support.container is None]
    return max(open_ones, key=lambda s: s.support.area_m2, default=None)


def frames(
    layout: Layout,
    piece: ObjectInstance,
    surface: PlacingSurface,
    where: Where,
    catalog: Catalog,
    rng: Rng,
) -> Iterator[Frame]:
    """Where people do something on a piece, in a random order: without end but for seats."""
    if where == "seat":
        seats = _seats(layout, piece, surface, catalog)
        yield from [seats[k] for k in rng.permutation(len(seats)).tolist()]
        return
    front = yaw_of(piece.pose.quat_xyzw)
    wide = layout.info(piece.id).extents_m[1] / 2
    middle = surface.shape.centroid
    centre = Frame((middle.x, middle.y), front + math.pi)
    while True:
        if where == "anywhere":
            point = surface.random_point(rng)
            if point is None:
                return
            yield Frame(point, centre.heading)
            continue
        if where == "middle":
            yield centre
            continue
        along = float(rng.uniform(-1.0, 1.0)) * max(0.0, wide - END_M)
        ray = -FAR_M if where == "front" else FAR_M
        start = centre.point((0.0, along))
        edge = _last(surface.shape, start, centre.point((ray, along)))
        yield Frame(edge or start, centre.heading)


def near(layout: Layout, piece: ObjectInstance, categories: tuple[str, ...]) -> bool:
    """Whether something of these categories stands within a step of a piece, in its room."""
    return any(
        other.category in categories
        and other.room_id == piece.room_id
        and _apart(layout, piece, other) <= STEP_M
        for other in layout.items.values()
        if other.fixed
    )


def _apart(layout: Layout, a: ObjectInstance, b: ObjectInstance) -> float:
    """About how far two pieces are from each other, as if they were round."""
    reach = sum(min(layout.info(item.id).extents_m[:2]) / 2 for item in (a, b))
    return math.dist(a.pose.position_m[:2], b.pose.position_m[:2]) - reach


def _seats(
    layout: Layout, piece: ObjectInstance, surface: PlacingSurface, catalog: Catalog
) -> list[Frame]:
    """The edge before each seat that faces a piece."""
    seats = {c.name for c in catalog.categories if "SITTABLE" in c.properties}
    found = []
    for seat in layout.items.values():
        if seat.category not in seats or seat.room_id != piece.room_id or seat.id == piece.id:
            continue
        x, y, _ = seat.pose.position_m
        deep = layout.info(seat.id).extents_m[0] / 2
        view = Frame((x, y), yaw_of(seat.pose.quat_xyzw))
        back = view.point((-FAR_M, 0.0))
        edge = _first(surface.shape, view.point((-deep, 0.0)), view.point((FAR_M, 0.0)))
        # Seats that are pushed in reach over the edge; one that is crossed has its back to it.
        if edge is not None and math.dist(edge, back) - FAR_M <= deep + AT_HAND_M:
            found.append(Frame(edge, view.heading))
    return found


def _first(shape: BaseGeometry, start: Vec2, end: Vec2) -> Vec2 | None:
    """Where a line from ``start`` enters a shape; None where it does not."""
    crossed = LineString([start, end]).intersection(shape)
    if crossed.is_empty:
        return None
    points = [
        (float(x), float(y))
        for part in getattr(crossed, "geoms", [crossed])
        for x, y in part.coords
    ]
    return min(points, key=lambda point: math.dist(point, start))


def _last(shape: BaseGeometry, start: Vec2, end: Vec2) -> Vec2 | None:
    """Where a line from ``start`` leaves a shape; None where it does not cross it."""
    return _first(shape, end, start)
