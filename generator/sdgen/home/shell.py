"""The shell of a home: rooms, floors, walls with openings cut out, ceilings.

Rectangles of a base home lie on the walls' middle lines; a wall is 0.12 m thick, half of it on
each room's side, so that each room wears its own surface.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from shapely import box as shapely_box
from shapely.geometry import LineString, Point, Polygon
from shapely.geometry.polygon import orient
from shapely.ops import unary_union

from sdgen.catalog.records import HomeSpec, OpeningSpec, RoomSpec
from sdgen.geometry import Vec2
from sdgen.library import Library
from sdgen.scene import Box, Home, Opening, Room, Structure
from sdgen.seeding import Rng
from sdgen.vocabulary import HALF_WALL_M

#: Seen from one side only; thicker than what falls moves in a step (10 m/s: 4 cm).
FLOOR_THICKNESS_M = 0.1
CEILING_THICKNESS_M = 0.05
#: Outer frame sizes of the library's openings (width, height); walls are cut to exactly these. Not
#: in YAML: another size needs doors and windows modelled to it, which is assets' business.
FRAME_M = {"door": (0.90, 2.10), "front_door": (1.00, 2.10), "window": (1.20, 1.20)}
SMALL_WINDOW_M = (0.60, 0.60)


def frame_size(opening: OpeningSpec) -> tuple[float, float]:
    """Width and height of the hole an opening needs."""
    if opening.kind == "window" and opening.small:
        return SMALL_WINDOW_M
    return FRAME_M[opening.kind]


def build_shell(spec: HomeSpec, library: Library, ids: Iterator[int], rng: Rng) -> Home:
    """Rooms and structures of a home; openings get the ids of the objects to fill them."""
    outlines = [_outline(room) for room in spec.rooms]
    rooms = tuple(
        Room(
            id=next(ids),
            name=room.name,
            type=room.type,
            polygon_m=_ring(outline.buffer(-HALF_WALL_M, join_style="mitre")),
            height_m=spec.height_m,
        )
        for room, outline in zip(spec.rooms, outlines, strict=True)
    )
    openings = tuple(_opening(o, rooms, next(ids)) for o in spec.openings)
    structures: list[Structure] = []
    for source, room in zip(spec.rooms, rooms, strict=True):
        structures += _structures(source, room, openings, library, ids, rng)
    return Home(
        id=spec.id, kind=spec.kind, rooms=rooms, structures=tuple(structures), openings=openings
    )


def _outline(room: RoomSpec) -> Polygon:
    shape = unary_union([shapely_box(*r) for r in room.rectangles_m])
    return orient(shape.simplify(1e-6))


def _ring(polygon: Polygon) -> tuple[Vec2, ...]:
    points = list(orient(polygon).exterior.coords)[:-1]
    return tuple((round(x, 4) + 0.0, round(y, 4) + 0.0) for x, y in points)


def _opening(spec: OpeningSpec, rooms: Sequence[Room], object_id: int) -> Opening:
    width, height = frame_size(spec)
    spot = Point(spec.center_m)
    touching = [
        room.id
        for room in rooms
        if Polygon(room.polygon_m).buffer(2 * HALF_WALL_M, join_style="mitre").contains(spot)
    ]
    if spec.hinge_flip:
        touching.reverse()
    return Opening(
        object_id=object_id,
        kind=spec.kind,
        room_ids=tuple(touching),
        center_m=(spec.center_m[0], spec.center_m[1], spec.sill_m),
        along=spec.along,
        width_m=width,
        height_m=height,
    )


def _pick_surface(library: Library, kind: str, room_type: str, rng: Rng) -> str:
    fitting = [
        s.id
        for s in library.surfaces.values()
        if s.kind == kind and (not s.rooms or room_type in s.rooms)
    ] or [s.id for s in library.surfaces.values() if s.kind == kind]
    return fitting[int(rng.integers(len(fitting)))]


def _structures(
    source: RoomSpec,
    room: Room,
    openings: Sequence[Opening],
    library: Library,
    ids: Iterator[int],
    rng: Rng,
) -> list[Structure]:
    floor = _pick_surface(library, "floor", room.type, rng)
    wall = _pick_surface(library, "wall", room.type, rng)
    ceiling = _pick_surface(library, "ceiling", room.type, rng)
    out = [
        Structure(
            id=next(ids),
            category="floor",
            room_id=room.id,
            surface=floor,
            pieces=tuple(_slab(r, -FLOOR_THICKNESS_M, 0.0) for r in source.rectangles_m),
        ),
        Structure(
            id=next(ids),
            category="ceiling",
            room_id=room.id,
            surface=ceiling,
            pieces=tuple(
                _slab(r, room.height_m, room.height_m + CEILING_THICKNESS_M)
                for r in source.rectangles_m
            ),
        ),
    ]
    ring = room.polygon_m
    for k, start in enumerate(ring):
        end = ring[(k + 1) % len(ring)]
        outward = (_turns_left(ring, k), _turns_left(ring, (k + 1) % len(ring)))
        pieces = _wall_pieces(start, end, outward, room, openings)
        if pieces:
            out.append(
                Structure(
                    id=next(ids), category="wall", room_id=room.id, surface=wall, pieces=pieces
                )
            )
    return out


def _box(x0: float, y0: float, z0: float, x1: float, y1: float, z1: float) -> Box:
    low, high = (min(x0, x1), min(y0, y1), min(z0, z1)), (max(x0, x1), max(y0, y1), max(z0, z1))
    return Box(
        center_m=tuple(round((a + b) / 2, 5) for a, b in zip(low, high, strict=True)),
        size_m=tuple(round(b - a, 5) for a, b in zip(low, high, strict=True)),
    )


def _slab(rectangle: tuple[float, float, float, float], z0: float, z1: float) -> Box:
    x0, y0, x1, y1 = rectangle
    return _box(x0, y0, z0, x1, y1, z1)


def _turns_left(ring: Sequence[Vec2], k: int) -> bool:
    """True for a corner that points outwards (the outline is counter-clockwise)."""
    (ax, ay), (bx, by), (cx, cy) = ring[k - 1], ring[k], ring[(k + 1) % len(ring)]
    return (bx - ax) * (cy - by) - (by - ay) * (cx - bx) > 0


def _wall_pieces(
    start: Vec2,
    end: Vec2,
    outward_corners: tuple[bool, bool],
    room: Room,
    openings: Sequence[Opening],
) -> tuple[Box, ...]:
    """Boxes of one wall edge, split into strips around its openings.

    At a corner that points outwards the wall goes on to close it; at one that points into the
    room it ends there, or it would stand out of the other wall.
    """
    along = "x" if abs(end[1] - start[1]) < 1e-9 else "y"
    axis = 0 if along == "x" else 1
    across = 1 - axis
    ends = sorted(zip((start[axis], end[axis]), outward_corners, strict=True))
    (low, low_out), (high, high_out) = ends
    inner = start[across]
    # The outline is counter-clockwise, so the wall lies to the right of the edge.
    forward = end[axis] > start[axis]
    outward = (-1.0 if forward else 1.0) * (1.0 if axis == 0 else -1.0)
    outer = inner + outward * HALF_WALL_M
    edge = LineString([start, end])
    holes = []
    for opening in openings:
        if opening.along != along or room.id not in opening.room_ids:
            continue
        if edge.distance(Point(opening.center_m[:2])) > 1.5 * HALF_WALL_M:
            continue
        middle, half = opening.center_m[axis], opening.width_m / 2
        sill = opening.center_m[2]
        holes.append((middle - half, middle + half, sill, sill + opening.height_m))
    holes.sort()

    def piece(a: float, b: float, z0: float, z1: float) -> list[Box]:
        if b - a < 1e-6 or z1 - z0 < 1e-6:
            return []
        if axis == 0:
            return [_box(a, inner, z0, b, outer, z1)]
        return [_box(inner, a, z0, outer, b, z1)]

    out: list[Box] = []
    cursor = low - (HALF_WALL_M if low_out else 0.0)
    for a, b, z0, z1 in holes:
        out += piece(cursor, a, 0.0, room.height_m)
        out += piece(a, b, 0.0, z0)
        out += piece(a, b, z1, room.height_m)
        cursor = b
    out += piece(cursor, high + (HALF_WALL_M if high_out else 0.0), 0.0, room.height_m)
    return tuple(out)
