"""What lights a world: sun and sky by the time of the day and the weather, lamps and windows."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from sdgen.render.backdrop.canvas import Floats
from sdgen.vocabulary import DayTime, Weather


class Light(NamedTuple):
    """``towards`` the sun (by night: the moon), its light on what faces it, that of the sky, the
    share of windows that are lit and how bright they are, and how bright street lamps are."""

    time: DayTime
    towards: Floats
    sun: Floats
    sky: Floats
    lit: float
    glow: float
    lamps: float

    def on(self, facing: tuple[float, float, float]) -> Floats:
        """The light (3,) on a face that looks this way."""
        up = 0.7 + 0.3 * facing[2]
        sun = max(0.0, float(self.towards @ np.array(facing, dtype=np.float32)))
        return np.asarray(self.sky * np.float32(up) + self.sun * np.float32(sun))


def _colour(*values: float) -> Floats:
    return np.array(values, dtype=np.float32)


#: Of the sun, by weather.
_SUN_SHARE: dict[Weather, float] = {"clear": 1.0, "cloudy": 0.55, "overcast": 0.0}
#: Of the sky, by weather, where the sun takes its share of the day.
_DAY_SKY: dict[Weather, Floats] = {
    "clear": _colour(0.48, 0.55, 0.66),
    "cloudy": _colour(0.7, 0.74, 0.81),
    "overcast": _colour(0.95, 0.97, 1.0),
}
_DUSK_SKY: dict[Weather, Floats] = {
    "clear": _colour(0.15, 0.155, 0.21),
    "cloudy": _colour(0.15, 0.15, 0.19),
    "overcast": _colour(0.14, 0.15, 0.18),
}


def light_of(time: DayTime, weather: Weather, azimuth: float, elevation: float) -> Light:
    """Of a time and a weather, with the sun in this direction, in radians."""
    towards = _colour(
        math.cos(azimuth) * math.cos(elevation),
        math.sin(azimuth) * math.cos(elevation),
        math.sin(elevation),
    )
    share = _SUN_SHARE[weather]
    if time == "night":
        moon = 0.012 if weather == "clear" else 0.0
        # The glow of a town under its own lamps.
        sky = _colour(0.024, 0.025, 0.034)
        return Light(time, towards, _colour(0.8, 0.9, 1.1) * moon, sky, 0.5, 0.95, 1.0)
    if time == "evening":
        sun = _colour(0.85, 0.5, 0.25) * share
        return Light(time, towards, sun, _DUSK_SKY[weather], 0.3, 0.75, 0.5)
    return Light(time, towards, _colour(1.0, 0.94, 0.82) * share, _DAY_SKY[weather], 0.0, 0.0, 0.0)
