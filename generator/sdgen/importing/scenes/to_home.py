"""A found scene as a base home: rooms, openings and furniture that a build takes, and a report.

Nothing is dropped without a word: what is left out stands in ``unresolved`` with why.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

from shapely.geometry import Point

from sdgen.catalog.home_shape import inner_ring, rooms_beside
from sdgen.catalog.records import Catalog, FurnitureItem, HomeSpec
from sdgen.errors import InputError
from sdgen.geometry import quat_from_matrix, quat_from_yaw, rotation_matrix
from sdgen.importing.scenes.fit import Fitter, Wanted, side_by_side
from sdgen.importing.scenes.found import FoundPiece, FoundScene
from sdgen.importing.scenes.naming import Named, Namer
from sdgen.importing.scenes.openings import LEAST_HEIGHT_M, openings_of
from sdgen.importing.scenes.rectangles import joined
from sdgen.importing.scenes.rooms import FoundRoom, level_and_square, rooms_of
from sdgen.library import Asset, Library
from sdgen.vocabulary import OPENINGS, Facing

#: Heights of rooms that a base home may have, metres, and that of one whose nobody knows.
_HIGHEST_M, _USUAL_M = 6.0, 2.6
#: A thing no further out than this is in the room that is nearest, metres.
_BESIDE_M = 0.6
#: What may end so low, for all that is known of it, stands on the floor, metres.
_STANDS_M = 0.35
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
    pieces = [_sorted(piece, namer, library) for piece in scene.pieces]
    scene = replace(scene, pieces=[one.piece for one in pieces])
    found = rooms_of(scene)
    by_room = _housed(found, pieces, scene)
    rooms = tuple(
        room.spec(_type_of(room, [p.category for p in by_room[k]], catalog))
        for k, room in enumerate(found)
    )
    openings, cut_off = openings_of(scene, rooms, height_m) if rooms else ((), [])
    for k in cut_off:
        lost = ", ".join(p.piece.name for p in by_room[k][:8])
        scene.unresolved.append(
            f"room {rooms[k].name!r}: no wall lets a door lead to it"
            + (f"; with it went {lost}" if lost else "")
        )
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
    )
    furnished = _furnished(spec, [by_room[k] for k in kept], scene, catalog, library)
    return Imported(
        spec=furnished,
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
            "furniture": sum(len(room.furniture) for room in furnished.rooms),
            "found": len(scene.pieces),
        },
    )


@dataclass(frozen=True)
class _Sorted:
    """A piece with its category and, where the library has it, its model."""

    piece: FoundPiece
    named: Named
    model: str | None = None

    @property
    def category(self) -> str | None:
        return self.named.category


def _height(scene: FoundScene) -> float:
    high = scene.height_m
    if high is None:
        tops = sorted(wall.high_m for wall in scene.walls)
        high = tops[len(tops) // 2] if tops else _USUAL_M
    fitting = round(min(max(high, LEAST_HEIGHT_M), _HIGHEST_M), 3)
    if abs(fitting - high) > 1e-3:
        scene.told.append(f"its rooms are {high:.2f} m high: drawn {fitting:g} m high")
    return fitting


def _sorted(piece: FoundPiece, namer: Namer, library: Library) -> _Sorted:
    """A piece with its category: as it says, as the library's model of it, as it is called."""
    if piece.note is not None:
        return _Sorted(piece, Named(piece.note.category, "it says so"))
    named = namer(piece)
    model = None if piece.source is None else _from_source(piece.source, library)
    if model is not None:
        named = replace(named, category=model.category, why=f"it is {model.id}", guessed=False)
    elif piece.category is not None:
        named = replace(named, category=piece.category, why="it says so", guessed=False)
    if named.front is not None and not piece.front:
        piece = _fronted(piece, named.front)
    if not piece.sized and named.category is not None:
        piece = _usual(piece, named.category, model, library)
    return _Sorted(piece, named)


def _usual(piece: FoundPiece, category: str, model: Asset | None, library: Library) -> FoundPiece:
    """The piece, of which only the middle is known, with the size of such things: of its model, or
    of the library's middling one."""
    known = sorted(library.by_category(category), key=lambda m: math.prod(m.extents_m))
    if model is None and not known:
        return piece
    extents = (model or known[len(known) // 2]).extents_m
    x, y, z = piece.position_m
    low = z - extents[2] / 2
    return replace(
        piece,
        position_m=(x, y, 0.0 if low < _STANDS_M else low),
        extents_m=extents,
    )


def _from_source(source: str, library: Library) -> Asset | None:
    """The library's model that was made from this one of a source."""
    return next((model for model in library.assets.values() if model.source == source), None)


def _fronted(piece: FoundPiece, front: Facing) -> FoundPiece:
    """The piece with its front along its own +x, of one whose front looks along ``front``."""
    turn = {"+x": 0.0, "+y": 0.5, "-x": 1.0, "-y": -0.5}[front] * math.pi
    deep, wide, high = piece.extents_m
    swapped = (deep, wide, high) if front in ("+x", "-x") else (wide, deep, high)
    turned = rotation_matrix(piece.quat_xyzw) @ rotation_matrix(quat_from_yaw(turn))
    return replace(piece, quat_xyzw=quat_from_matrix(turned), extents_m=swapped, front=True)


def _housed(
    rooms: Sequence[FoundRoom], pieces: Sequence[_Sorted], scene: FoundScene
) -> list[list[_Sorted]]:
    """The pieces of each room; what has no category of ours, or is in no room, is told."""
    shapes = [joined(room.rectangles_m) for room in rooms]
    names = {room.name: k for k, room in enumerate(rooms)}
    out: list[list[_Sorted]] = [[] for _ in rooms]
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


def _furnished(
    spec: HomeSpec,
    by_room: Sequence[Sequence[_Sorted]],
    scene: FoundScene,
    catalog: Catalog,
    library: Library,
) -> HomeSpec:
    """The home with its furniture; what has no place is told."""
    fitter = Fitter(spec, catalog, library)
    fitted = {fitting.category for fitting in catalog.fittings}
    small: Counter[str] = Counter()
    for k, pieces in enumerate(by_room):
        furniture = []
        for one in pieces:
            category = catalog.category(one.category or "")
            loose = one.piece.loose
            if category.name in OPENINGS:
                continue
            if category.name in fitted or loose or (category.kind != "furniture" and loose is None):
                small[category.name] += 1
            elif _model_of(one, library) is not None:
                furniture.append(one)
            else:
                parts = side_by_side(one.piece, category.name, library)
                furniture += [replace(one, piece=part) for part in parts]
                if len(parts) > 1:
                    wide = max(one.piece.extents_m[:2])
                    scene.told.append(
                        f"{one.piece.name}: {wide:.2f} m wide: {len(parts)} of ours side by side"
                    )
        # What carries others first; of those in the order of the source.
        furniture.sort(key=lambda one: one.piece.position_m[2] > 0.05)
        for one in furniture:
            model, name = _model_of(one, library), one.category or ""
            exact = model is not None and one.piece.note is not None
            told = fitter.fit(Wanted(one.piece, name, k, model, exact))
            if told is not None and model is not None:
                told = fitter.fit(Wanted(replace(one.piece, note=None), name, k))
            if told is not None:
                scene.unresolved.append(
                    f"{one.piece.name}: no place for this {one.category}: {told}"
                )
    for gone, why in fitter.clear_ways():
        scene.unresolved.append(f"{gone.wanted.piece.name}: {why}")
    if small:
        total = sum(small.values())
        scene.told.append(
            f"{total} small things and fittings: every home that is built has its own"
        )
    rooms = [
        room.model_copy(update={"furniture": tuple(_of_room(fitter, k))})
        for k, room in enumerate(spec.rooms)
    ]
    return spec.model_copy(update={"rooms": tuple(rooms)})


def _of_room(fitter: Fitter, room: int) -> list[FurnitureItem]:
    return [one.item for one in fitter.fitted if one.room == room]


def _model_of(one: _Sorted, library: Library) -> str | None:
    """The library's model that a piece is: by its id, or by what its source calls it."""
    note = one.piece.note
    known = {model.id: model for model in library.by_category(one.category or "")}
    if note is not None and note.model in known:
        return note.model
    if one.piece.source is None:
        return None
    model = _from_source(one.piece.source, library)
    return None if model is None else model.id
