"""A file of ``homes/`` read into a :class:`BaseHome`, and the checks a drawing can fail."""

from __future__ import annotations

from sdgen.catalog.reader import Reader
from sdgen.catalog.records import BaseHome, BaseOpening, BaseRoom, FurnitureItem
from sdgen.vocabulary import OPENINGS

Rect = tuple[float, float, float, float]
_EPS = 1e-6


def read_home(reader: Reader, categories: set[str], rooms: set[str]) -> BaseHome:
    """Read one base home; problems are noted in the reader's source."""
    home = BaseHome(
        id=reader.word("id"),
        title=reader.text("title"),
        height_m=reader.number("height_m", 2.6, low=2.0, high=6.0),
        rooms=tuple(_room(row, categories, rooms) for row in reader.rows("rooms")),
        openings=tuple(_opening(row) for row in reader.rows("openings")),
    )
    reader.flag("replaces")
    reader.done()
    if not reader.source.problems:
        _check_plan(reader, home)
    return home


def _room(reader: Reader, categories: set[str], rooms: set[str]) -> BaseRoom:
    rects: list[Rect] = []
    if reader.has("rectangles_m") and isinstance(reader.data["rectangles_m"], list):
        for index, value in enumerate(reader.data["rectangles_m"]):
            steps = ("rectangles_m", index)
            a, b, c, d = reader.vector(value, 4, steps, -1000.0, 1000.0)
            if a >= c or b >= d:
                reader.problem("expected [x_min, y_min, x_max, y_max]", *steps)
            rects.append((a, b, c, d))
    if not rects and reader.ok:
        reader.problem("missing rectangles_m: [[x_min, y_min, x_max, y_max], …]")
    kind = reader.word("type")
    if reader.ok and kind and kind not in rooms:
        reader.problem(f"unknown room type {kind!r} (one of: {', '.join(sorted(rooms))})", "type")
    room = BaseRoom(
        name=reader.word("name"),
        type=kind,
        rectangles_m=tuple(rects),
        furniture=tuple(_item(row, categories) for row in reader.rows("furniture", None)),
    )
    reader.done()
    return room


def _item(reader: Reader, categories: set[str]) -> FurnitureItem:
    names = reader.words("category", choices=categories, what="category")
    x, y, z = reader.numbers("position_m", 3, low=-1000.0, high=1000.0)
    item = FurnitureItem(
        category=names[0] if names else "",
        position_m=(x, y, z),
        yaw_deg=reader.number("yaw_deg", 0.0, low=-360.0, high=360.0),
        width_m=reader.span("width_m", high=20.0) if reader.has("width_m") else None,
        optional=reader.flag("optional"),
        on=_first(reader.words("on", (), choices=categories, what="category")),
        against_wall=reader.flag("against_wall"),
        jitter_m=reader.number("jitter_m", 0.0, low=0.0, high=0.5),
    )
    reader.done()
    return item


def _first(words: tuple[str, ...]) -> str | None:
    return words[0] if words else None


def _opening(reader: Reader) -> BaseOpening:
    x, y = reader.numbers("center_m", 2, low=-1000.0, high=1000.0)
    opening = BaseOpening(
        kind=reader.choice("kind", OPENINGS),
        center_m=(x, y),
        along=reader.choice("along", ("x", "y")),
        sill_m=reader.number("sill_m", 0.0, low=0.0, high=3.0),
        small=reader.flag("small"),
        hinge_flip=reader.flag("hinge_flip"),
    )
    reader.done()
    return opening


def _check_plan(reader: Reader, home: BaseHome) -> None:
    """Rooms apart, furniture inside its room, openings on walls, one front door."""
    names = [room.name for room in home.rooms]
    for index, room in enumerate(home.rooms):
        if room.name in names[:index]:
            reader.problem(f"a second room named {room.name!r}", "rooms", index, "name")
        for other in home.rooms[:index]:
            if any(_overlap(a, b) for a in room.rectangles_m for b in other.rectangles_m):
                reader.problem(f"overlaps room {other.name!r}", "rooms", index, "rectangles_m")
        for k, item in enumerate(room.furniture):
            steps = ("rooms", index, "furniture", k)
            if not any(_holds(rect, item.position_m) for rect in room.rectangles_m):
                message = f"{item.category} stands outside room {room.name!r}"
                reader.problem(message, *steps, "position_m")
            if item.on is not None and item.on not in [i.category for i in room.furniture[:k]]:
                reader.problem(f"no {item.on} is placed before it in this room", *steps, "on")
    for index, opening in enumerate(home.openings):
        beside = [room.name for room in home.rooms if _on_edge(room, opening)]
        wanted = {"door": (1, 2), "front_door": (1,), "window": (1,)}[opening.kind]
        if len(beside) not in wanted:
            where = f"has {len(beside)} rooms beside it ({', '.join(beside) or 'none'})"
            hint = "center_m must lie on a wall that runs along the axis 'along'"
            reader.problem(f"this {opening.kind} {where}; {hint}", "openings", index, "center_m")
    if sum(opening.kind == "front_door" for opening in home.openings) != 1:
        reader.problem("a home has exactly one front_door", "openings")


def _overlap(a: Rect, b: Rect) -> bool:
    return min(a[2], b[2]) - max(a[0], b[0]) > _EPS and min(a[3], b[3]) - max(a[1], b[1]) > _EPS


def _holds(rect: Rect, point: tuple[float, float, float]) -> bool:
    return rect[0] <= point[0] <= rect[2] and rect[1] <= point[1] <= rect[3]


def _on_edge(room: BaseRoom, opening: BaseOpening) -> bool:
    """True when the opening's centre lies on an edge of the room along its axis."""
    x, y = opening.center_m
    for x0, y0, x1, y1 in room.rectangles_m:
        if opening.along == "x" and x0 < x < x1 and min(abs(y - y0), abs(y - y1)) < _EPS:
            return True
        if opening.along == "y" and y0 < y < y1 and min(abs(x - x0), abs(x - x1)) < _EPS:
            return True
    return False
