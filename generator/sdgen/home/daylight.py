"""When a home is seen, and where the sun stands then. It decides no label."""

from __future__ import annotations

import math

from sdgen.scene import Daylight
from sdgen.seeding import Rng
from sdgen.vocabulary import DayTime, Season

#: How often a home is seen at each time of the day.
TIMES: dict[DayTime, float] = {"day": 0.6, "evening": 0.2, "night": 0.2}
#: How high the sun stands at noon, degrees, some 50 degrees north.
_NOON_DEG: dict[Season, float] = {"spring": 45.0, "summer": 62.0, "autumn": 35.0, "winter": 18.0}
#: How high it may stand in the evening, degrees.
_EVENING_DEG = (4.0, 14.0)
#: By day it is seen so far from noon, as a share of the half day.
_BY_DAY = 0.75


def daylight_random(season: Season, rng: Rng) -> Daylight:
    """Time of the day, and the sun's place: homes face any way, and so does the sun."""
    time = tuple(TIMES)[int(rng.choice(len(TIMES), p=tuple(TIMES.values())))]
    azimuth = round(float(rng.uniform(0.0, 360.0)), 1) % 360.0
    hour = float(rng.uniform(-_BY_DAY, _BY_DAY))
    low = float(rng.uniform(*_EVENING_DEG))
    high = _NOON_DEG[season] * math.cos(hour * math.pi / 2)
    elevation = low if time == "evening" else max(high, _EVENING_DEG[1])
    return Daylight(time=time, sun_azimuth_deg=azimuth, sun_elevation_deg=round(elevation, 1))
