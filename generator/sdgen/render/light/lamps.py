"""Which things in a home give light, and how much."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from itertools import groupby

import numpy as np
from shapely.geometry import Polygon

from sdgen.geometry import Array
from sdgen.render.light.colour import mean_colour
from sdgen.render.light.rooms import Lamp
from sdgen.render.raster.drawn import CEILING_LAMP, Drawn
from sdgen.scene import Scene

#: What lamps give, W/sr, on the scale on which a clear sky gives some 3 W/sr from a square metre.
_POWER = {CEILING_LAMP: 4.2, "floor_lamp": 2.4, "table_lamp": 1.2, "desk_lamp": 1.2}
#: Of a lamp at the ceiling in a room of so many square metres, and how much less or more others
#: give.
_ROOM_M2, _SHARES = 16.0, (0.3, 1.6)
#: By day they are on in dark rooms, and seem dimmer beside others.
_BY_DAY = 0.5
_WARM = np.array((1.12, 0.94, 0.68))
#: What else is lit - screens, flames, burners - gives as much from a square metre, W/sr, and no
#: more than this.
_RADIANCE, _MOST = 1.3, 1.0
#: Less than this lights nothing but itself: lamps of switches, displays.
_LEAST = 0.004
#: A lamp's own body may hide it from so near, metres, beyond its lit part.
_BODY_M = 0.2


def lamps_of(scene: Scene, parts: Sequence[Drawn]) -> list[Lamp]:
    """What gives light, one lamp an object: at ceilings as much together as a room is large."""
    areas = {room.id: Polygon(room.polygon_m).area for room in scene.home.rooms}
    hung = [item for item in scene.objects if item.category == CEILING_LAMP]
    count = Counter(item.room_id for item in hung)
    by_hour = _BY_DAY if scene.home.daylight.time == "day" else 1.0
    share = {}
    for item in hung:
        area = areas.get(item.room_id, _ROOM_M2) / count[item.room_id]
        share[item.id] = by_hour * float(np.clip(area / _ROOM_M2, *_SHARES))
    glowing = sorted((part for part in parts if part.glows), key=lambda part: part.node_id)
    return [
        lamp
        for key, group in groupby(glowing, key=lambda part: part.node_id)
        for lamp in _lamp([*group], share.get(key, 1.0))
    ]


def _lamp(parts: Sequence[Drawn], share: float) -> Iterator[Lamp]:
    areas = np.array([_area_m2(part) for part in parts])
    if areas.sum() <= 0:
        return
    boxes = np.array([part.box for part in parts])
    middles = boxes.mean(axis=1)
    at: Array = (middles * areas[:, None]).sum(axis=0) / areas.sum()
    radius = float(np.ptp(boxes, axis=1).max()) / 2 + _BODY_M
    power = _POWER.get(parts[0].category)
    if power is not None:
        yield Lamp(at, radius, share * power * _WARM)
        return
    # A quarter of a body's surface is how large it looks, from all sides in the mean (Cauchy).
    colours = np.array([mean_colour(part.texture) * part.rgb for part in parts])
    given = _RADIANCE * (colours * areas[:, None]).sum(axis=0) / 4
    if given.max() >= _LEAST:
        yield Lamp(at, radius, given * min(1.0, _MOST / given.max()))


def _area_m2(part: Drawn) -> float:
    corners = part.vertices[part.faces].astype(np.float64)
    sides = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    return float(np.linalg.norm(sides, axis=1).sum() / 2)
