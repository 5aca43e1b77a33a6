"""All the light in one home.

It comes from what belongs to the home: the shell, and what is fixed in it, all shut but for the
doors between rooms. So a scene and its twin have the same, but for lamps that are on in one alone.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from sdgen.library import Library
from sdgen.render.light import HAS_RAYS
from sdgen.render.light.floors import FloorShade, shade_of_floors
from sdgen.render.light.lamps import lamps_of
from sdgen.render.light.panes import panes_of
from sdgen.render.light.rooms import RoomLight, even_light, light_of_rooms
from sdgen.render.light.sky import Sky, sky_of
from sdgen.render.raster.drawn import Drawn, parts_of
from sdgen.render.shell import ceiling_level_m
from sdgen.scene import Home, Scene
from sdgen.vocabulary import DayTime

if TYPE_CHECKING:
    from sdgen.render.light.sunlight import SunMap

#: Of a home without a ceiling, metres.
_HIGH_M = 2.6
#: The sun comes in below a window's frame, metres, and falls before it meets a wall: where windows
#: reach up to the ceiling it stays so far below that.
_FRAME_M, _BELOW_M = 0.04, 0.15
_FRONT_DOOR = "front_door"


@dataclass(frozen=True, eq=False)
class HomeLight:
    """The light in the rooms of a home, the sky outside, the sun's map where it shines, and the
    shade of furniture on floors, where there is any."""

    time: DayTime
    rooms: list[RoomLight]
    sky: Sky
    sun: SunMap | None
    floor: FloorShade | None


def light_of_home(library: Library, scene: Scene, parts: Sequence[Drawn]) -> HomeLight:
    """Find the light of a scene whose drawn parts these are. Without rays it is even."""
    home = scene.home
    ceiling_m = ceiling_level_m(home.structures)
    high = ceiling_m if np.isfinite(ceiling_m) else _HIGH_M
    if not HAS_RAYS:
        sky = sky_of(home.daylight, home.outdoors.weather)
        return HomeLight(home.daylight.time, even_light(home.rooms, high), sky, None, None)
    # Not for the types alone: without embree there is no such module.
    from sdgen.render.light.sunlight import SunMap
    from sdgen.render.light.world import LightWorld

    standing = [*_standing(library, scene, parts)]
    world = LightWorld(standing, roofed=bool(np.isfinite(ceiling_m)))
    sky = sky_of(home.daylight, home.outdoors.weather)
    corners = np.array([c for room in home.rooms for c in room.polygon_m])
    low, top = (*corners.min(axis=0), 0.0), (*corners.max(axis=0), high)
    sun = None
    if sky.sun.any():
        highest = _highest_m(home, ceiling_m) if np.isfinite(ceiling_m) else math.inf
        sun = SunMap(world, sky.towards, np.array(low), np.array(top), highest)
    shining = None if sun is None else (sun, sky.sun)
    panes = panes_of(home)
    enclosed = any(one.category == "wall" for one in home.structures)
    lamps = lamps_of(scene, parts)
    rooms = light_of_rooms(world, home.rooms, high, sky.radiance, shining, lamps, panes, enclosed)
    floor = shade_of_floors(world, home.rooms, panes, lamps)
    return HomeLight(home.daylight.time, rooms, sky, sun, floor)


def _highest_m(home: Home, ceiling_m: float) -> float:
    """Above which height the sun shines on nothing."""
    tops = [one.center_m[2] + one.height_m for one in home.openings if one.kind == "window"]
    return min(max(tops, default=0.0) - _FRAME_M, ceiling_m - _BELOW_M)


def _standing(library: Library, scene: Scene, parts: Sequence[Drawn]) -> Iterator[Drawn]:
    """The parts that light meets."""
    between = {one.object_id for one in scene.home.openings if one.kind != _FRONT_DOOR}
    fixed = {item.id: item for item in scene.objects if item.fixed}
    moved = {
        key for key, item in fixed.items()
        if key not in between and (item.variant != "default" or any(item.joints.values()))
    }  # fmt: skip
    yield from (part for part in parts if part.number == 0 or part.node_id in fixed.keys() - moved)
    for key in sorted(moved):
        shut = fixed[key].model_copy(update={"variant": "default", "joints": {}})
        yield from parts_of(library, shut, lit=False)
