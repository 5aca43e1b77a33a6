"""The shell of a home: rooms, floors, walls with openings cut out, ceilings.

Rectangles of a base home lie on the walls' middle lines; a wall is 0.12 m thick, half of it on
each room's side, so that each room wears its own surface.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from sdgen.catalog.home_shape import frame_size, in_wall, inner_ring, rooms_beside
from sdgen.catalog.records import HomeSpec, OpeningSpec, RoomSpec
from sdgen.geometry import Vec2
from sdgen.home.outdoors import outdoors_random
from sdgen.home.style import HomeStyle
from sdgen.home.wall_bands import skirting_of
from sdgen.library import Library
from sdgen.scene import Box, Home, Opening, Room, Structure
from sdgen.seeding import Rng
from sdgen.vocabulary import HALF_WALL_M, StructureKind

#: Seen from one side only; thicker than what falls moves in a step (10 m/s: 4 cm).
FLOOR_THICKNESS_M = 0.1
CEILING_THICKNESS_M = 0.05


def build_shell(
    spec: HomeSpec, style: HomeStyle, library: Library, ids: Iterator[int], rng: Rng
) -> Home:
    """Rooms and structures of a home; openings get the ids of the objects to fill them."""
    rings = [inner_ring(room) for room in spec.rooms]
    rooms = tuple(
        Room(
            id=next(ids),
            name=room.name,
            type=room.type,
            polygon_m=ring,
            height_m=spec.height_m,
        )
        for room, ring in zip(spec.rooms, rings, strict=True)
    )
    openings = tuple(_opening(o, rooms, next(ids)) for o in spec.openings)
    structures: list[Structure] = []
    for source, room in zip(spec.rooms, rooms, strict=True):
        structures += _structures(source, room, openings, style, library, ids, rng)
    return Home(
        id=spec.id,
        kind=spec.kind,
        style=style.name,
        outdoors=outdoors_random(rng),
        rooms=rooms,
        structures=tuple(structures),
        openings=openings,
    )


def _opening(spec: OpeningSpec, rooms: Sequence[Room], object_id: int) -> Opening:
    width, height = frame_size(spec)
    touching = [rooms[k].id for k in rooms_beside([room.polygon_m for room in rooms], spec)]
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


def _pick_surface(
    style: HomeStyle, library: Library, kind: StructureKind, room_type: str, rng: Rng
) -> str:
    """The surface of the home's style, or where it says nothing any that suits the room."""
    styled = style.surface(kind, room_type)
    if styled is not None:
        return styled
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
    style: HomeStyle,
    library: Library,
    ids: Iterator[int],
    rng: Rng,
) -> list[Structure]:
    floor = _pick_surface(style, library, "floor", room.type, rng)
    wall = _pick_surface(style, library, "wall", room.type, rng)
    skirting = style.surface("skirting", room.type)
    ceiling = _pick_surface(style, library, "ceiling", room.type, rng)
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
            foot = () if skirting is None else (skirting_of(start, end, library, skirting),)
            out.append(
                Structure(
                    id=next(ids),
                    category="wall",
                    room_id=room.id,
                    surface=wall,
                    pieces=pieces,
                    bands=foot,
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
    holes = []
    for opening in openings:
        if room.id not in opening.room_ids:
            continue
        if not in_wall(start, end, opening.center_m, opening.along, opening.width_m):
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
