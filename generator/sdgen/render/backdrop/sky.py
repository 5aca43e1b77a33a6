"""The sky: its colours by the sun's place, clouds, and by night the moon and some stars."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from sdgen.render.backdrop.canvas import Canvas, Floats, between, looked_up, noise, soft
from sdgen.render.backdrop.light import Light
from sdgen.vocabulary import DayTime, Weather


def _colour(*values: float) -> Floats:
    return np.array(values, dtype=np.float32)


#: Colours at the horizon and overhead.
_SKIES: dict[tuple[DayTime, Weather], tuple[Floats, Floats]] = {
    ("day", "clear"): (_colour(0.66, 0.79, 0.95), _colour(0.19, 0.4, 0.8)),
    ("day", "cloudy"): (_colour(0.68, 0.77, 0.88), _colour(0.26, 0.43, 0.72)),
    ("day", "overcast"): (_colour(0.78, 0.81, 0.84), _colour(0.58, 0.61, 0.66)),
    ("evening", "clear"): (_colour(0.34, 0.3, 0.36), _colour(0.1, 0.16, 0.34)),
    ("evening", "cloudy"): (_colour(0.3, 0.28, 0.33), _colour(0.11, 0.15, 0.28)),
    ("evening", "overcast"): (_colour(0.23, 0.24, 0.29), _colour(0.12, 0.135, 0.18)),
    ("night", "clear"): (_colour(0.042, 0.039, 0.05), _colour(0.0045, 0.0075, 0.02)),
    ("night", "cloudy"): (_colour(0.046, 0.041, 0.049), _colour(0.008, 0.011, 0.023)),
    ("night", "overcast"): (_colour(0.052, 0.045, 0.049), _colour(0.014, 0.016, 0.026)),
}
#: How much of the sky clouds take.
_COVER: dict[Weather, float] = {"clear": 0.16, "cloudy": 0.55, "overcast": 0.8}
#: Colours of clouds in light and in their own shade.
_CLOUDS: dict[DayTime, tuple[Floats, Floats]] = {
    "day": (_colour(1.0, 0.99, 0.97), _colour(0.62, 0.66, 0.73)),
    "evening": (_colour(0.62, 0.4, 0.32), _colour(0.17, 0.17, 0.24)),
    "night": (_colour(0.034, 0.034, 0.042), _colour(0.02, 0.022, 0.032)),
}
_GREY: dict[DayTime, tuple[Floats, Floats]] = {
    "day": (_colour(0.83, 0.85, 0.88), _colour(0.58, 0.61, 0.66)),
    "evening": (_colour(0.25, 0.25, 0.3), _colour(0.13, 0.14, 0.19)),
    "night": (_colour(0.04, 0.038, 0.045), _colour(0.018, 0.02, 0.03)),
}
#: Low down the sky is what the far ground fades into: so far up, as a sine.
_LOW = 0.02
#: Cells of the field that clouds are taken from.
_CLOUDS_SIZE = 512


class _Coarse(NamedTuple):
    """Every other ray over the horizon: level directions (2, C), climbs and rises (R, 1)."""

    ways: Floats
    climbs: Floats
    rises: Floats


def paint_sky(canvas: Canvas, light: Light, weather: Weather, rng: np.random.Generator) -> None:
    """All above the horizon, and the haze below it."""
    count = int(np.sum(canvas.rises >= -0.02)) // 2 * 2
    rays = _Coarse(
        (canvas.ways[:, ::2] + canvas.ways[:, 1::2]) * np.float32(0.5),
        np.maximum(canvas.climbs[:count:2], 0)[:, None],
        np.maximum(canvas.rises[:count:2], 0)[:, None],
    )
    low, high = _SKIES[light.time, weather]
    height = (1 - np.exp(-3.2 * rays.rises))[..., None]
    picture = low + (high - low) * height + np.zeros((1, rays.ways.shape[1], 1), np.float32)
    level = np.sqrt(1 - rays.rises**2)
    aim = light.towards
    near = level * (rays.ways[0] * aim[0] + rays.ways[1] * aim[1])[None, :] + rays.rises * aim[2]
    angle = np.arccos(np.clip(near, -1, 1))
    if light.time != "night":
        picture += _round_the_sun(angle, rays.rises, light, weather)
    picture = _clouded(picture, rays, angle, light, weather, rng)
    if light.time == "night" and weather == "clear":
        moon = soft(0.0055, 0.004, angle)[..., None]
        halo = np.exp(-angle / 0.035)[..., None] * 0.05
        picture += (moon * 0.9 + halo) * _colour(1.0, 0.97, 0.86)
    canvas.colours[:count] = _doubled(picture)
    if light.time == "night":
        _add_stars(canvas, count, weather, rng)
    band = int(np.argmin(np.abs(canvas.rises - _LOW)))
    canvas.haze = canvas.colours[band - 6 : band + 6].mean(axis=0)
    canvas.colours[count:] = canvas.haze


def _doubled(picture: Floats) -> Floats:
    """Twice as many rows and columns, drawn out between those there are."""
    tall = np.empty((2 * len(picture), *picture.shape[1:]), dtype=np.float32)
    tall[::2] = picture
    tall[1:-1:2] = (picture[:-1] + picture[1:]) * np.float32(0.5)
    tall[-1] = picture[-1]
    out = np.empty((len(tall), 2 * picture.shape[1], 3), dtype=np.float32)
    part = tall * np.float32(0.25)
    tall -= part
    out[:, 2::2] = tall[:, 1:] + part[:, :-1]
    out[:, 0] = tall[:, 0] + part[:, -1]
    out[:, 1:-1:2] = tall[:, :-1] + part[:, 1:]
    out[:, -1] = tall[:, -1] + part[:, 0]
    return out


def _add_stars(canvas: Canvas, rows: int, weather: Weather, rng: np.random.Generator) -> None:
    """A lit town outshines all but the brightest stars."""
    count = {"clear": 500, "cloudy": 120, "overcast": 0}[weather]
    at = rng.integers(0, rows - 20, count), rng.integers(0, canvas.ways.shape[1], count)
    # Brighter than they look: each is one pixel only.
    canvas.colours[at] += (rng.random((count, 1)) ** 4 * 1.6 + 0.05).astype(np.float32)


def _round_the_sun(angle: Floats, rise: Floats, light: Light, weather: Weather) -> Floats:
    """What the air round the sun adds."""
    share = {"clear": 1.0, "cloudy": 0.6, "overcast": 0.12}[weather]
    if light.time == "day":
        wide = 0.16 * np.exp(-angle / 0.5) + 0.5 * np.exp(-angle / 0.1)
        return np.asarray(share * wide[..., None] * _colour(1.0, 0.96, 0.88))
    # In the evening the glow lies along the horizon.
    low = np.exp(-rise / 0.22)[..., None]
    wide = np.exp(-((angle / 0.85) ** 2))[..., None]
    close = np.exp(-angle / 0.13)[..., None]
    glow = low * wide * _colour(0.66, 0.29, 0.07) + close * _colour(0.85, 0.45, 0.16)
    return np.asarray(share * glow)


def _clouded(
    picture: Floats,
    rays: _Coarse,
    angle: Floats,
    light: Light,
    weather: Weather,
    rng: np.random.Generator,
) -> Floats:
    """Clouds lie on a level high above: the lower they stand the flatter they look."""
    fields = noise(rng, _CLOUDS_SIZE, 1.55, 2.0)
    climb = rays.climbs + 0.1
    size = np.float32((9.0 if weather == "overcast" else 16.0) * _CLOUDS_SIZE / 256)
    drift = rng.uniform(0, _CLOUDS_SIZE, 2).astype(np.float32)
    x, y = (rays.ways[k][None, :] * (size / climb) + drift[k] for k in (0, 1))
    here = between(fields, x, y)
    # Towards the sun there is less cloud on the lit side of one.
    aside = light.towards[:2] * np.float32(5.0 * _CLOUDS_SIZE / 256)
    there = looked_up(fields, x + aside[0], y + aside[1])
    cut = float(np.quantile(fields[::4, ::4], 1 - _COVER[weather]))
    amount = soft(cut - 0.08, cut + 0.55, here) * np.float32(0.94)
    # Nothing stands out at the horizon.
    amount *= soft(0.0, 0.14, rays.rises)
    bright, dark = (_GREY if weather == "overcast" else _CLOUDS)[light.time]
    lit = np.clip(0.55 + 0.3 * (here - there) - 0.12 * (here - cut), 0, 1)[..., None]
    if light.time == "evening" and weather != "overcast":
        lit = lit * np.exp(-angle / 1.1)[..., None]
        bright = bright + _colour(0.5, 0.22, 0.05) * np.exp(-angle / 0.4)[..., None]
    clouds = dark + (bright - dark) * lit
    return np.asarray(picture + (clouds - picture) * amount[..., None], dtype=np.float32)


def moon_of(rng: np.random.Generator) -> tuple[float, float]:
    """Where the moon stands: its azimuth and elevation, radians."""
    return float(rng.uniform(0, 2 * math.pi)), math.radians(float(rng.uniform(16, 36)))
