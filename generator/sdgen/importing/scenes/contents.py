"""What was found in the rooms of a scene, sorted, as furniture and things of a base home."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from sdgen.catalog.records import Catalog, HomeSpec, ThingItem
from sdgen.geometry import (
    quat_from_matrix,
    quat_from_yaw,
    rotation_matrix,
    round_position,
    round_quat,
)
from sdgen.importing.scenes.fit import Fitter, Wanted
from sdgen.importing.scenes.found import FoundPiece, FoundScene
from sdgen.importing.scenes.likeness import side_by_side
from sdgen.importing.scenes.naming import Named, Namer
from sdgen.importing.scenes.standing import shifts_m
from sdgen.library import Asset, Library
from sdgen.vocabulary import OPENINGS, Facing

#: What may end so low, for all that is known of it, stands on the floor, metres.
_STANDS_M = 0.35


@dataclass(frozen=True)
class Sorted:
    """A piece with its category and, where the library has it, its model."""

    piece: FoundPiece
    named: Named
    model: str | None = None

    @property
    def category(self) -> str | None:
        """Ours; None when it has none."""
        return self.named.category


def sort_piece(piece: FoundPiece, namer: Namer, library: Library, catalog: Catalog) -> Sorted:
    """A piece with its category: as it says, as the library's model of it, as it is called."""
    known_as = {category.name for category in catalog.categories}
    if piece.note is not None and piece.note.category not in known_as:
        # Exported with a catalogue that has more.
        return Sorted(piece, Named(None, f"no category is called {piece.note.category!r}"))
    if piece.note is not None:
        said = library.assets.get(piece.note.model)
        known = said is not None and said.category == piece.note.category
        named = Named(piece.note.category, "it says so")
        return Sorted(piece, named, piece.note.model if known else None)
    named = namer(piece)
    model = None if piece.source is None else _from_source(piece.source, library)
    if model is not None and model.category not in known_as:
        model = None  # it was imported, and nobody knew what it is
    if model is not None:
        named = replace(named, category=model.category, why=f"it is {model.id}", guessed=False)
    elif piece.category is not None:
        named = replace(named, category=piece.category, why="it says so", guessed=False)
    if named.front is not None and not piece.front:
        piece = _fronted(piece, named.front)
    if not piece.sized and named.category is not None:
        piece = _usual(piece, named.category, model, library)
    return Sorted(piece, named, None if model is None else model.id)


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


def furnished(
    spec: HomeSpec,
    by_room: Sequence[Sequence[Sorted]],
    scene: FoundScene,
    catalog: Catalog,
    library: Library,
) -> HomeSpec:
    """The home with its furniture, and with the things whose models the library has; what has no
    place is told."""
    fitter = Fitter(spec, catalog, library)
    fitted = {fitting.category for fitting in catalog.fittings}
    loose: list[list[Sorted]] = [[] for _ in spec.rooms]
    anew = 0
    for k, pieces in enumerate(by_room):
        furniture = []
        for one in pieces:
            category = catalog.category(one.category or "")
            fixed = one.piece.loose is False or (
                one.piece.loose is None and category.kind == "furniture"
            )
            if category.name in OPENINGS:
                text = (
                    f"taken for a {category.name}, but its own name says none: no opening is made"
                )
                scene.unresolved.append(f"{one.piece.name}: {text}")
                continue
            if not fixed and one.model is not None:
                loose[k].append(one)
            elif not fixed or (category.name in fitted and not spec.as_drawn):
                anew += 1
            elif one.model is not None:
                furniture.append(one)
            else:
                furniture += _parts(one, category.name, scene, library)
        # What carries others first, and what hangs on walls last; of these in the source's order.
        furniture.sort(key=lambda one: (one.category in fitted, one.piece.position_m[2] > 0.05))
        for one in furniture:
            _fit(one, k, fitter, scene)
    for gone, why in fitter.clear_ways():
        scene.unresolved.append(f"{gone.wanted.piece.name}: {why}")
    if anew:
        scene.told.append(f"{anew} small things and fittings: homes that are built have their own")
    rooms = tuple(
        room.model_copy(
            update={
                "furniture": tuple(one.item for one in fitter.fitted if one.room == k),
                "things": tuple(_things(loose[k], k, fitter, library)),
            }
        )
        for k, room in enumerate(spec.rooms)
    )
    return spec.model_copy(update={"rooms": rooms})


def _fit(one: Sorted, room: int, fitter: Fitter, scene: FoundScene) -> None:
    """Put a piece: as the model that it is, or as one like it; else why it cannot be is told."""
    name = one.category or ""
    exact = one.model is not None and one.piece.note is not None
    why = fitter.fit(Wanted(one.piece, name, room, one.model, exact))
    if why is not None and one.model is not None:
        as_it_is, why = why, fitter.fit(Wanted(replace(one.piece, note=None), name, room))
        if why is None:
            scene.told.append(f"{one.piece.name}: another {name} in its place: {as_it_is}")
    if why is not None:
        scene.unresolved.append(f"{one.piece.name}: no place for this {name}: {why}")


def _parts(one: Sorted, category: str, scene: FoundScene, library: Library) -> Iterator[Sorted]:
    """A piece, or several of ours for a long one."""
    parts = side_by_side(one.piece, category, library)
    if len(parts) > 1:
        wide = max(one.piece.extents_m[:2])
        text = f"{one.piece.name}: {wide:.2f} m wide: {len(parts)} of ours side by side"
        scene.told.append(text)
    yield from (replace(one, piece=part) for part in parts)


def _things(
    loose: Sequence[Sorted], room: int, fitter: Fitter, library: Library
) -> Iterator[ThingItem]:
    """Small things of a room: ours as they lie, others on the furniture that is there now."""
    others = [one.piece for one in loose if one.piece.note is None]
    surfaces = [
        surface
        for fitted in fitter.fitted
        if fitted.room == room
        for surface in fitter.layout.surfaces_of(fitted.object_id)
    ]
    shifts = iter(shifts_m(others, surfaces))
    for one in loose:
        x, y, z = one.piece.position_m
        up = next(shifts) if one.piece.note is None else 0.0
        yield _thing(replace(one, piece=replace(one.piece, position_m=(x, y, z + up))), library)


def _thing(one: Sorted, library: Library) -> ThingItem:
    """A small thing as it lies."""
    note, asset = one.piece.note, library.assets[one.model or ""]
    known = {joint.name for joint in asset.joints}
    variant = "default" if note is None else note.variant
    return ThingItem(
        category=asset.category,
        model=asset.id,
        position_m=round_position(one.piece.position_m),
        quat_xyzw=round_quat(one.piece.quat_xyzw),
        variant=variant if variant in asset.variants else "default",
        joints={} if note is None else {k: v for k, v in note.joints.items() if k in known and v},
    )
