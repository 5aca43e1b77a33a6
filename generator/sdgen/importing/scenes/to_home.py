"""A found scene as a base home: rooms, openings and furniture that a build takes, and a report.

Nothing is dropped without a word: what is left out stands in ``unresolved`` with why.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

from shapely.geometry import Point

from sdgen.catalog.home_shape import inner_ring, rooms_beside
from sdgen.catalog.records import Catalog, HomeSpec
from sdgen.errors import InputError
from sdgen.importing.scenes.contents import Sorted, furnished, sort_piece
from sdgen.importing.scenes.found import FoundScene
from sdgen.importing.scenes.naming import Namer
from sdgen.importing.scenes.openings import LEAST_HEIGHT_M, openings_of
from sdgen.importing.scenes.rectangles import joined
from sdgen.importing.scenes.rooms import FoundRoom, level_and_square, rooms_of
from sdgen.library import Library

#: Heights of rooms that a base home may have, metres, and that of one whose nobody knows.
_HIGHEST_M, _USUAL_M = 6.0, 2.6
#: A thing no further out than this is in the room that is nearest, metres.
_BESIDE_M = 0.6
#: What a room is, by what stands in it: the first that does says it.
_TELLING: Sequence[tuple[str, tuple[str, ...]]] = (
    ("bathroom", ("bathtub", "shower")),
    ("toilet", ("toilet",)),
    ("child_room", ("crib", "child_bed", "bunk_bed")),
    ("bedroom", ("bed", "nightstand", "wardrobe")),
    ("living_room", ("sofa", "tv_stand", "armchair", "coffee_table", "tv")),
    ("kitchen", ("stove", "fridge", "sink_cabinet", "dishwasher", "kitchen_counter")),
    ("dining_room", ("dining_table", "kitchen_table")),
    ("office", ("desk", "filing_cabinet")),
    ("laundry", ("washing_machine", "dryer")),
    ("hall", ("shoe_rack", "coat_rack")),
)


@dataclass(frozen=True)
class Imported:
    """A base home, and what became of the scene: ``told`` is what was assumed, ``unresolved``
    what was left out, each with why. ``guessed``: pieces whose category is a guess."""

    spec: HomeSpec
    told: tuple[str, ...]
    unresolved: tuple[str, ...]
    guessed: tuple[str, ...] = ()
    counts: Mapping[str, int] = field(default_factory=dict)


def to_home(
    scene: FoundScene, name: str, catalog: Catalog, library: Library, namer: Namer
) -> Imported:
    """The base home called ``name`` of a found scene.

    Raises InputError when no room is left of it.
    """
    scene = level_and_square(scene)
    height_m = _height(scene)
    pieces = [sort_piece(piece, namer, library, catalog) for piece in scene.pieces]
    scene = replace(scene, pieces=[one.piece for one in pieces])
    found = rooms_of(scene)
    by_room = _housed(found, pieces, scene)
    rooms = tuple(
        room.spec(_type_of(room, [p.category for p in by_room[k]], catalog))
        for k, room in enumerate(found)
    )
    openings, cut_off = openings_of(scene, rooms, height_m) if rooms else ((), [])
    for k in cut_off:
        scene.unresolved.append(f"room {rooms[k].name!r}: no wall lets a door lead to it")
        for one in by_room[k]:
            scene.unresolved.append(f"{one.piece.name}: went with room {rooms[k].name!r}")
    kept = [k for k in range(len(rooms)) if k not in cut_off]
    if not kept:
        raise InputError([f"{scene.source}: no room was found in it"])
    rooms = tuple(rooms[k] for k in kept)
    if cut_off:
        rings = [inner_ring(room) for room in rooms]
        openings = tuple(o for o in openings if rooms_beside(rings, o))
    style = scene.style if scene.style in {style.name for style in catalog.styles} else None
    spec = HomeSpec(
        id=name,
        title=scene.title or name,
        height_m=height_m,
        rooms=rooms,
        openings=openings,
        style=style,
        as_drawn=scene.drawn,
    )
    full = furnished(spec, [by_room[k] for k in kept], scene, catalog, library)
    return Imported(
        spec=full,
        told=tuple(scene.told),
        unresolved=tuple(scene.unresolved),
        guessed=tuple(
            f"{p.piece.name}: {p.category} ({p.named.why})"
            for p in pieces
            if p.named.guessed and p.category is not None
        ),
        counts={
            "rooms": len(rooms),
            "openings": len(openings),
            "furniture": sum(len(room.furniture) for room in full.rooms),
            "things": sum(len(room.things) for room in full.rooms),
            "found": len(scene.pieces),
        },
    )


def _height(scene: FoundScene) -> float:
    high = scene.height_m
    if high is None:
        tops = sorted(wall.high_m for wall in scene.walls)
        high = tops[len(tops) // 2] if tops else _USUAL_M
    fitting = round(min(max(high, LEAST_HEIGHT_M), _HIGHEST_M), 3)
    if abs(fitting - high) > 1e-3:
        scene.told.append(f"its rooms are {high:.2f} m high: drawn {fitting:g} m high")
    return fitting


def _housed(
    rooms: Sequence[FoundRoom], pieces: Sequence[Sorted], scene: FoundScene
) -> list[list[Sorted]]:
    """The pieces of each room; what has no category of ours, or is in no room, is told."""
    shapes = [joined(room.rectangles_m) for room in rooms]
    names = {room.name: k for k, room in enumerate(rooms)}
    out: list[list[Sorted]] = [[] for _ in rooms]
    for one in pieces:
        if one.category is None:
            scene.unresolved.append(f"{one.piece.name}: {one.named.why}")
            continue
        at = Point(one.piece.position_m[:2])
        room = names.get(one.piece.room or "")
        if room is None or shapes[room].distance(at) > _BESIDE_M:
            gaps = [float(shape.distance(at)) for shape in shapes]
            room = min(range(len(gaps)), key=gaps.__getitem__, default=None)
            if room is None or gaps[room] > _BESIDE_M:
                scene.unresolved.append(f"{one.piece.name}: stands in no room")
                continue
        out[room].append(one)
    return out


def _type_of(room: FoundRoom, categories: Sequence[str | None], catalog: Catalog) -> str:
    types = [kind.name for kind in catalog.room_types]
    if room.type in types:
        return str(room.type)
    there = set(categories)
    for kind, telling in _TELLING:
        if kind in types and there & set(telling):
            return kind
    return "hall" if "hall" in types else types[0]
