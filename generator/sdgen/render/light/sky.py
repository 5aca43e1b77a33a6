"""Sun and sky by the time of day and the weather: what comes in through windows."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from sdgen.geometry import Array
from sdgen.scene import Daylight
from sdgen.vocabulary import Weather

#: Light of the sun on what faces it, by weather, and of the sky: at noon, and in the evening.
_SUN = np.array((14.0, 12.4, 10.2))
_LOW_SUN = np.array((5.4, 3.1, 1.4))
_CLEAR, _GREY, _DUSK = (
    np.array((2.5, 2.9, 3.4)),
    np.array((3.0, 3.1, 3.2)),
    np.array((1.3, 1.2, 1.5)),
)
_NIGHT = np.array((0.015, 0.02, 0.035))
_SUN_SHARE = {"clear": 1.0, "cloudy": 0.45, "overcast": 0.0}


class Sky(NamedTuple):
    """``towards`` the sun, its light on what faces it, and the radiance of the sky overhead, each
    (3,)."""

    towards: Array
    sun: Array
    overhead: Array

    def radiance(self, directions: Array) -> Array:
        """Of the sky and of the ground outside, (N, 3), by direction (N, 3)."""
        rise = directions[:, 2:]
        share = np.where(rise > 0, 0.75 + 0.6 * rise, 0.35 + 0.25 * (1 + rise))
        return np.asarray(share * self.overhead)


def sky_of(daylight: Daylight, weather: Weather) -> Sky:
    """What comes from the sky at a time of day under such weather."""
    turn, rise = (
        math.radians(angle) for angle in (daylight.sun_azimuth_deg, daylight.sun_elevation_deg)
    )
    towards = np.array(
        [math.cos(turn) * math.cos(rise), math.sin(turn) * math.cos(rise), math.sin(rise)]
    )
    if daylight.time == "night":
        return Sky(towards, np.zeros(3), _NIGHT)
    share = _SUN_SHARE[weather]
    if daylight.time == "evening":
        return Sky(towards, share * _LOW_SUN, _DUSK)
    return Sky(towards, share * _SUN, _CLEAR if share == 1.0 else _GREY)
