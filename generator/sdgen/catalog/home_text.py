"""A base home as the text of a file of ``hazard_catalog/homes``: read back, it is the same."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from sdgen.catalog.records import FurnitureItem, HomeSpec, RoomSpec
from sdgen.catalog.words import WORD
from sdgen.scene import Record


def home_text(spec: HomeSpec, lead: Sequence[str] = ()) -> str:
    """The YAML of a home; ``lead`` are the lines of a comment at its head."""
    lines = [
        *(f"# {line}".rstrip() for line in lead),
        f"id: {spec.id}",
        f"title: {json.dumps(spec.title, ensure_ascii=False)}",
        f"height_m: {_number(spec.height_m)}",
        *([f"style: {spec.style}"] if spec.style else []),
        *(["as_drawn: true"] if spec.as_drawn else []),
        "",
        "rooms:",
    ]
    for room in spec.rooms:
        lines += [*_room(room), ""]
    lines.append("openings:")
    lines += [f"  - {_flow(_given(opening))}" for opening in spec.openings]
    return "\n".join(lines) + "\n"


def _room(room: RoomSpec) -> Iterator[str]:
    rectangles = ", ".join(_list(rectangle) for rectangle in room.rectangles_m)
    yield f"  - name: {room.name}"
    yield f"    type: {room.type}"
    yield f"    rectangles_m: [{rectangles}]"
    if room.furniture:
        yield "    furniture:"
        yield from (f"      - {_flow(_piece(piece))}" for piece in room.furniture)
    if room.things:
        yield "    things:"
        yield from (f"      - {_flow(_given(thing))}" for thing in room.things)


def _piece(piece: FurnitureItem) -> dict[str, Any]:
    """What is written of a piece, in the order in which people write it."""
    given = _given(piece)
    first: dict[str, Any] = {key: given.pop(key) for key in ("category", "model") if key in given}
    place = {"position_m": given.pop("position_m"), "yaw_deg": piece.yaw_deg}
    given.pop("yaw_deg", None)
    return {**first, **place, **given}


def _given(record: Record) -> dict[str, Any]:
    return record.model_dump(mode="json", exclude_defaults=True)


def _flow(given: Mapping[str, Any]) -> str:
    return "{" + ", ".join(f"{key}: {_value(value)}" for key, value in given.items()) + "}"


def _value(value: Any) -> str:
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, Mapping):
        return _flow(value)
    if isinstance(value, list | tuple):
        return _list(value)
    if isinstance(value, str):
        bare = WORD.fullmatch(value) and value not in ("true", "false", "null")
        return value if bare else json.dumps(value)
    return _number(value)


def _list(values: Sequence[float]) -> str:
    return "[" + ", ".join(map(_number, values)) + "]"


def _number(value: float) -> str:
    return f"{value:.6f}".rstrip("0").rstrip(".")
