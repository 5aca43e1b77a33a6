"""All the light in one home."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from sdgen.geometry import Array
from sdgen.render.light.rooms import Lamp, RoomLight, light_of_rooms
from sdgen.render.light.sky import Sky, sky_of
from sdgen.render.light.sunlight import SunMap
from sdgen.render.light.world import LightWorld
from sdgen.render.raster.drawn import Drawn
from sdgen.render.shell import ceiling_level_m
from sdgen.scene import Scene

#: Of a home without a ceiling, metres.
_HIGH_M = 2.6
#: A ceiling lamp hangs so far below its origin, metres, and gives so much, W/sr.
_BELOW_M = 0.2
_LAMP = np.array((5.0, 4.1, 2.9))


@dataclass(frozen=True, eq=False)
class HomeLight:
    """The light in the rooms of a home, the sky outside, and the sun's map."""

    rooms: list[RoomLight]
    sky: Sky
    sun: SunMap
    lamps: tuple[Lamp, ...]


def light_of_home(scene: Scene, parts: Sequence[Drawn]) -> HomeLight:
    """Find the light of a scene whose drawn parts these are."""
    world = LightWorld(parts)
    daylight = scene.home.daylight
    sky = sky_of(daylight, scene.home.outdoors.weather)
    ceiling = ceiling_level_m(scene.home.structures)
    high = ceiling if np.isfinite(ceiling) else _HIGH_M
    corners = np.array([c for room in scene.home.rooms for c in room.polygon_m])
    low, top = (*corners.min(axis=0), 0.0), (*corners.max(axis=0), high)
    sun = SunMap(world, sky.towards, np.array(low), np.array(top))
    lamps: tuple[Lamp, ...] = ()
    if daylight.time != "day":
        lamps = tuple(_ceiling_lamps(scene))
    shining = (sun, sky.sun) if sky.sun.any() else None
    rooms = light_of_rooms(world, scene.home.rooms, high, sky.radiance, shining, lamps)
    return HomeLight(rooms, sky, sun, lamps)


def _ceiling_lamps(scene: Scene) -> list[Lamp]:
    down: Array = np.array((0.0, 0.0, _BELOW_M))
    return [
        Lamp(np.array(item.pose.position_m) - down, _LAMP)
        for item in scene.objects
        if item.category == "ceiling_lamp"
    ]
