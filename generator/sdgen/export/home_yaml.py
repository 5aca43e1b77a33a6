"""A furnished home as a file of ``hazard_catalog/homes``: what was placed, where it stands.

Rooms, doors and windows are those of its plan. Every piece of furniture names its model, so that
the same home comes back. Small things are not in it: a base home has its own of every seed.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

from sdgen.catalog.home_text import home_text
from sdgen.catalog.records import FurnitureItem, HomeSpec
from sdgen.geometry import yaw_of
from sdgen.pipeline.furnished import FurnishedHome
from sdgen.scene import ObjectInstance
from sdgen.vocabulary import OPENINGS

#: Digits of degrees: at the far end of the longest piece less than a hundredth of a millimetre.
_YAW_DIGITS = 4


def home_yaml(name: str, spec: HomeSpec, furnished: FurnishedHome) -> str:
    """The YAML of a home under the id ``name``, which must be its file's name, too."""
    home = furnished.context.home
    ids = {room.name: room.id for room in home.rooms}
    rooms = tuple(
        room.model_copy(update={"furniture": tuple(_pieces(furnished, ids[room.name]))})
        for room in spec.rooms
    )
    written = spec.model_copy(update={"id": name, "style": home.style or None, "rooms": rooms})
    lead = (
        f"Written by sdgen home export from {spec.id}: change what you like.",
        f"Check it with: sdgen catalog validate {name}.yaml",
    )
    return home_text(written, lead)


def _pieces(furnished: FurnishedHome, room_id: int) -> Iterator[FurnitureItem]:
    """The furniture of a room, in the order in which it was placed; what belongs to the building
    hangs in every home anew."""
    layout = furnished.layout
    fitted = {fitting.category for fitting in furnished.context.catalog.fittings}
    for item in layout.items.values():
        if item.room_id != room_id or item.category in {*OPENINGS, *fitted}:
            continue
        intent = layout.intents.get(item.id)
        yield FurnitureItem(
            category=item.category,
            model=item.asset,
            position_m=item.pose.position_m,
            yaw_deg=_yaw(item),
            on=None if intent is None else layout.items[intent.target_id].category,
        )


def _yaw(item: ObjectInstance) -> float:
    return round(math.degrees(yaw_of(item.pose.quat_xyzw)), _YAW_DIGITS) + 0.0
