"""A furnished home as a file of ``hazard_catalog/homes``: what was placed, where it stands.

Rooms, doors and windows are those of its plan. Every piece of furniture names its model, so that
the same home comes back. Small things are not in it: a base home has its own of every seed.
"""

from __future__ import annotations

import json
import math
from collections.abc import Iterator, Sequence
from typing import Any

from sdgen.catalog.records import HomeSpec
from sdgen.catalog.words import WORD
from sdgen.geometry import yaw_of
from sdgen.pipeline.furnished import FurnishedHome
from sdgen.scene import ObjectInstance
from sdgen.vocabulary import OPENINGS

#: Digits of degrees: at the far end of the longest piece less than a hundredth of a millimetre.
_YAW_DIGITS = 4


def home_yaml(name: str, spec: HomeSpec, furnished: FurnishedHome) -> str:
    """The YAML of a home under the id ``name``, which must be its file's name, too."""
    style = furnished.context.home.style
    lines = [
        f"# Written by sdgen home export from {spec.id}: change what you like.",
        f"# Check it with: sdgen catalog validate {name}.yaml",
        f"id: {name}",
        f"title: {json.dumps(spec.title, ensure_ascii=False)}",
        f"height_m: {_number(spec.height_m)}",
        *([f"style: {style}"] if style else []),
        "",
        "rooms:",
    ]
    rooms = {room.name: room.id for room in furnished.context.home.rooms}
    for room in spec.rooms:
        rectangles = ", ".join(_list(rectangle) for rectangle in room.rectangles_m)
        lines += [
            f"  - name: {room.name}",
            f"    type: {room.type}",
            f"    rectangles_m: [{rectangles}]",
        ]
        pieces = list(_pieces(furnished, rooms[room.name]))
        lines += ["    furniture:", *pieces] if pieces else []
        lines.append("")
    lines.append("openings:")
    for opening in spec.openings:
        given = opening.model_dump(mode="json", exclude_defaults=True)
        lines.append(f"  - {_flow(given)}")
    return "\n".join(lines) + "\n"


def _pieces(furnished: FurnishedHome, room_id: int) -> Iterator[str]:
    """The furniture of a room, one line a piece, in the order in which it was placed; what belongs
    to the building hangs in every home anew."""
    layout = furnished.layout
    fitted = {fitting.category for fitting in furnished.context.catalog.fittings}
    for item in layout.items.values():
        if item.room_id != room_id or item.category in {*OPENINGS, *fitted}:
            continue
        given: dict[str, Any] = {
            "category": item.category,
            "model": item.asset,
            "position_m": item.pose.position_m,
            "yaw_deg": _yaw(item),
        }
        intent = layout.intents.get(item.id)
        if intent is not None:
            given["on"] = layout.items[intent.target_id].category
        yield f"      - {_flow(given)}"


def _yaw(item: ObjectInstance) -> float:
    return round(math.degrees(yaw_of(item.pose.quat_xyzw)), _YAW_DIGITS) + 0.0


def _flow(given: dict[str, Any]) -> str:
    return "{" + ", ".join(f"{key}: {_value(value)}" for key, value in given.items()) + "}"


def _value(value: Any) -> str:
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, list | tuple):
        return _list(value)
    if isinstance(value, str):
        return value if WORD.fullmatch(value) else json.dumps(value)
    return _number(value)


def _list(values: Sequence[float]) -> str:
    return "[" + ", ".join(map(_number, values)) + "]"


def _number(value: float) -> str:
    return f"{value:.5f}".rstrip("0").rstrip(".")
