"""What is wrong with a home drawn by hand that only the models' sizes tell.

Every piece is tried where it is drawn, as a build tries it, with the smallest model first: what
even that one cuts, no other clears. No simulator is asked.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import count
from pathlib import Path

import shapely
from shapely.geometry import Point, Polygon

from sdgen.actions import at_rest
from sdgen.catalog.folder import open_extra
from sdgen.catalog.records import Catalog, FurnitureItem, HomeSpec
from sdgen.errors import InputError, did_you_mean
from sdgen.facts import bodies_of
from sdgen.freespace import ROBOT_RADIUS_M, free_shape, unreachable_rooms
from sdgen.home.furnish import candidates_for, clashing, drawn_at, fill_openings, put_piece
from sdgen.home.layout import IN_WALL_M, Intent, Layout
from sdgen.home.shell import build_shell
from sdgen.home.style import HomeStyle
from sdgen.library import Asset, Library
from sdgen.rejection import Rejection
from sdgen.scene import Home, ObjectInstance, Room
from sdgen.seeding import lane
from sdgen.yaml_source import Path_
from sdgen.zones import doorway_blocked, floor_obstacles, swing_blocked

#: The back of what hangs, or is said to stand against a wall, is no further from it; pieces of
#: shipped homes stand 3 cm off.
OFF_WALL_M = 0.1
#: What is mounted lower stands on the floor, for all a drawing says.
HUNG_ABOVE_M = 0.05


def check_drawings(catalog: Catalog, library: Library, paths: Sequence[Path]) -> None:
    """Check the homes in extra catalogue folders or files, which read well as a catalogue.

    Raises InputError with every problem found, each ``file:line: key path: problem``.
    """
    homes = {home.id: home for home in catalog.homes}
    problems: list[str] = []
    for path in paths:
        for source in open_extra(path).sources.get("homes", ()):
            for where, text in drawing_problems(homes[Path(source.file).stem], catalog, library):
                source.problem(where, text)
            problems += source.problems
    if problems:
        raise InputError(problems)


@dataclass
class _Furnished:
    """A layout, its pieces by room and category, and where the drawing has each."""

    layout: Layout
    placed: dict[int, dict[str, list[int]]] = field(default_factory=dict)
    drawn: dict[int, Path_] = field(default_factory=dict)

    def copy(self) -> _Furnished:
        placed = {
            room: {category: list(ids) for category, ids in found.items()}
            for room, found in self.placed.items()
        }
        return _Furnished(self.layout.copy(), placed, dict(self.drawn))

    def inside(self, room: Room) -> Mapping[str, Sequence[int]]:
        """The pieces of a room by category."""
        return self.placed.get(room.id, {})

    def add(self, item: ObjectInstance, room: Room, path: Path_) -> None:
        """Note a piece that the layout has."""
        self.placed.setdefault(room.id, {}).setdefault(item.category, []).append(item.id)
        self.drawn[item.id] = path


def drawing_problems(
    spec: HomeSpec, catalog: Catalog, library: Library
) -> Iterator[tuple[Path_, str]]:
    """What is wrong with a home's furniture, each with its key path: models that do not exist,
    pieces through walls, other pieces or doors, pieces that hang in the air, rooms cut off."""
    ids, rng = count(1), lane(0, 0, f"drawing:{spec.id}")
    home = build_shell(spec, HomeStyle(), library, ids, rng)
    layout = fill_openings(spec, home, Layout(library, ids), HomeStyle(), library.by_category, rng)
    if isinstance(layout, Rejection):
        yield ("openings",), f"no {layout.cause.category} of the library has its size"
        return
    for item in list(layout.items.values()):  # inner doors stand as the seed has them: shut here
        layout.put(at_rest(item, library.assets[item.asset]))
    look = _Look(spec, home, catalog, library)
    yield from look.things()
    base = _Furnished(layout)
    for path, room, piece in look.pieces(optional=False):
        yield from ((path, text) for text in look.place(piece, room, base, path))
    yield from look.ways(base)
    # Optional pieces may stand in each other's place: each is tried beside the others' alone.
    with_optional: dict[tuple[int, str], _Furnished] = {}
    for path, room, piece in look.pieces(optional=True):
        on = (room.id, piece.on or "")
        stage = base if piece.on is None or piece.on in base.inside(room) else with_optional.get(on)
        if stage is None:
            continue  # what it stands on was told of
        stage = stage.copy()
        told = look.place(piece, room, stage, path)
        yield from ((path, text) for text in told)
        if not told:
            with_optional[room.id, piece.category] = stage


@dataclass(frozen=True)
class _Look:
    """A drawing held against the models."""

    spec: HomeSpec
    home: Home
    catalog: Catalog
    library: Library

    def pieces(self, optional: bool) -> Iterator[tuple[Path_, Room, FurnitureItem]]:
        """The pieces that must stand, or those that may, with their places in the file."""
        for r, (source, room) in enumerate(zip(self.spec.rooms, self.home.rooms, strict=True)):
            for k, piece in enumerate(source.furniture):
                if piece.optional == optional:
                    exact = piece.model_copy(update={"jitter_m": 0.0})
                    yield ("rooms", r, "furniture", k), room, exact

    def things(self) -> Iterator[tuple[Path_, str]]:
        """Things of models, variants or joints that the library does not have."""
        for r, room in enumerate(self.spec.rooms):
            for k, thing in enumerate(room.things):
                path: Path_ = ("rooms", r, "things", k)
                model = self.library.assets.get(thing.model)
                if model is None or model.category != thing.category:
                    known = [one.id for one in self.library.by_category(thing.category)]
                    near = did_you_mean(thing.model, known)
                    yield (*path, "model"), f"no model {thing.model!r} of {thing.category}{near}"
                    continue
                if thing.variant not in model.variants:
                    near = did_you_mean(thing.variant, list(model.variants))
                    yield (*path, "variant"), f"{model.id} has no variant {thing.variant!r}{near}"
                joints = [joint.name for joint in model.joints]
                for name in thing.joints:
                    if name not in joints:
                        near = did_you_mean(name, joints)
                        yield (*path, "joints"), f"{model.id} has no joint {name!r}{near}"

    def place(self, piece: FurnitureItem, room: Room, home: _Furnished, path: Path_) -> list[str]:
        """Put the piece into ``home``; why it cannot be, when no model will do."""
        models = candidates_for(piece, self.library.by_category, self.library)
        if not models:
            return [self._no_model(piece)]
        models = sorted(models, key=lambda m: (m.extents_m[0] * m.extents_m[1], m.id))
        smallest: list[str] | None = None
        for model in models:
            rng = lane(0, 0, "still")  # pieces are drawn without jitter: nothing is drawn from it
            found = drawn_at(piece, model, room, home.layout, home.inside(room), rng)
            if found is None and piece.on is not None:
                return []  # what it stands on was told of
            if found is None:
                continue  # a chimney of another length
            why = self._why_not(piece, model, *found, room, home)
            if not why:
                home.add(found[0], room, path)
                return []
            smallest = smallest or why
        lead = (
            f"{piece.category}: "
            if len(models) == 1
            else (f"{piece.category}: none of its {len(models)} models fits: of the smallest ")
        )
        return [f"{lead}{models[0].id} {why}" for why in smallest or ()]

    def _no_model(self, piece: FurnitureItem) -> str:
        known = self.library.by_category(piece.category)
        if not known:
            return f"the library has no model of {piece.category}"
        if piece.model is not None:
            return f"no model {piece.model!r} of {piece.category}" + did_you_mean(
                piece.model, [model.id for model in known]
            )
        widths = [model.extents_m[1] for model in known]
        return (
            f"{piece.category}: none of its {len(known)} models is as wide as width_m says; they "
            f"have {min(widths):.2f} to {max(widths):.2f} m"
        )

    def _why_not(
        self,
        piece: FurnitureItem,
        model: Asset,
        item: ObjectInstance,
        intent: Intent | None,
        room: Room,
        home: _Furnished,
    ) -> list[str]:
        """What keeps a model from standing as drawn; nothing when it stands there now."""
        (body,) = bodies_of([item], self.library.infos)
        points = shapely.points(body.corners[:, :2])
        beyond = float(shapely.distance(Polygon(room.polygon_m), points).max())
        why = []
        if beyond > IN_WALL_M:
            why.append(f"reaches {beyond:.2f} m into a wall of {room.name!r}")
        top = float(body.high[2])
        if top > room.height_m:
            why.append(f"ends {top:.2f} m up, and the ceiling is at {room.height_m:g} m")
        if (off := self._off_wall(piece, model, item, room)) is not None:
            why.append(off)
        blocks = home.layout.blocks_of(item)
        cut = sorted(set(clashing(blocks, model, home.layout, intent)))
        why += [f"cuts into {self._named(key, home)}" for key in cut]
        if not why and not put_piece(item, model, home.layout, intent, room, self.catalog):
            why.append(
                "has no room to open, or stands where something else opens (doors, lids and "
                "drawers swing out whole, and somebody stands before them)"
            )
        return why

    def _off_wall(
        self, piece: FurnitureItem, model: Asset, item: ObjectInstance, room: Room
    ) -> str | None:
        """Why the back of a piece is at no wall, where it should be."""
        x, y, z = item.pose.position_m
        hung = piece.on is None and z > HUNG_ABOVE_M
        under_ceiling = room.height_m - (z + model.extents_m[2]) <= OFF_WALL_M
        if not piece.against_wall and (not hung or under_ceiling):
            return None
        yaw, outline = math.radians(piece.yaw_deg), Polygon(room.polygon_m)
        depth = model.extents_m[0] / 2
        if piece.against_wall:
            x, y, depth = *piece.position_m[:2], 0.0
        back = Point(x - math.cos(yaw) * depth, y - math.sin(yaw) * depth)
        behind = Point(back.x - math.cos(yaw) * OFF_WALL_M, back.y - math.sin(yaw) * OFF_WALL_M)
        if not outline.covers(behind):
            return None
        what = "is to stand against a wall" if piece.against_wall else f"hangs {z:g} m up"
        far = outline.exterior.distance(back)
        return f"{what}, but no wall is behind its back (the nearest is {far:.2f} m away)"

    def _named(self, object_id: int, home: _Furnished) -> str:
        """A placed thing, and where the drawing has it."""
        category = home.layout.items[object_id].category
        path = home.drawn.get(object_id)
        return f"the {category}" if path is None else f"the {category} (furniture[{path[-1]}])"

    def ways(self, home: _Furnished) -> Iterator[tuple[Path_, str]]:
        """What stands in doorways, and rooms that furniture cuts off."""
        bodies = bodies_of([*home.layout.items.values()], self.library.infos)
        for text, blocked in (
            ("stands where a door swings", swing_blocked(bodies)),
            ("stands in a doorway", doorway_blocked(self.home, bodies)),
        ):
            for key in blocked:
                path = home.drawn.get(key, ("openings",))
                yield path, f"{home.layout.items[key].category} {text}"
        free = free_shape(self.home, floor_obstacles(bodies))
        cut_off = {room.id for room in unreachable_rooms(self.home, free)}
        for r, room in enumerate(self.home.rooms):
            if room.id in cut_off:
                wide = 2 * ROBOT_RADIUS_M
                text = f"furniture leaves no way {wide:g} m wide to room {room.name!r}"
                yield ("rooms", r), text
