"""What closes the view: hills, and woods at the edge of the town."""

from __future__ import annotations

import numpy as np

from sdgen.geometry import Array
from sdgen.render.backdrop.builder import Place
from sdgen.render.backdrop.canvas import COLUMNS, Canvas, soft
from sdgen.render.backdrop.light import Light
from sdgen.render.backdrop.plants import grass_of
from sdgen.vocabulary import Season

#: Azimuths of the columns, and a radian's share over which land turns into sea.
_TURN = (np.arange(COLUMNS) + 0.5) / COLUMNS * 2 * np.pi
_SHORE = 0.25


def _off_street() -> Array:
    """How far columns are turned from +y, where the sea is, radians."""
    return np.asarray(np.abs((_TURN - np.pi / 2 + np.pi) % (2 * np.pi) - np.pi))


def paint_hills(
    canvas: Canvas, light: Light, place: Place, season: Season, rng: np.random.Generator
) -> None:
    """Hills, far and nearer, with woods; none over the sea."""
    land = np.clip((_off_street() - place.sea) / _SHORE, 0, 1) if place.sea else np.ones(COLUMNS)
    everywhere = np.arange(COLUMNS)
    lit = light.sky + light.sun * 0.4
    woods = grass_of(season) * np.float32(0.55)
    if place.snow:
        woods = woods * np.float32(0.5) + np.float32(0.3)
    for away_m, high in ((2600.0, 1.0), (1300.0, 0.6), (600.0, 0.45)):
        rise = _wave(3, rng) * 0.5 + 0.6
        top = np.clip(place.hills * high * rise, 0.004, None) * land - 0.002
        # Crowns of trees along the top.
        rough = 0.0012 * (1400 / away_m) * np.repeat(rng.random(COLUMNS // 4), 4)
        top = top + rough * land
        rows = canvas.rows(-0.02, 0.3)
        cover = np.clip((top[None, :] - canvas.rises[rows][:, None]) * 400, 0, 1)
        speckle = 1 + 0.1 * rng.standard_normal((len(cover), COLUMNS // 4)).repeat(4, axis=1)
        colours = woods * lit * speckle[..., None]
        canvas.put(rows, everywhere, np.float32(away_m), colours, cover * (land > 0))
    # The ground is put over the foot of the hills.
    canvas.far_m[:] = np.inf


def paint_woods(
    canvas: Canvas, light: Light, place: Place, season: Season, rng: np.random.Generator
) -> None:
    """Lines of trees at the edge of the town, with gaps."""
    leaves = grass_of(season) * np.float32(0.6 if season != "autumn" else 0.75)
    if season == "winter":
        leaves = leaves * np.float32(0.7)
    lit = light.sky * 0.8 + light.sun * 0.35
    sea = _off_street() < place.sea
    for away_m in (420.0, 240.0):
        crowns = sum(np.abs(np.sin(_TURN * n + rng.uniform(0, 6))) for n in (97, 151, 263)) / 3
        high = 13.0 * (0.55 + 0.45 * crowns) * soft(-0.15, 0.25, _wave(4, rng))
        high = np.where(sea, 0, high)
        low, top = -canvas.eye_m / away_m, (high - canvas.eye_m) / away_m
        rows = canvas.rows(low, (13.0 - canvas.eye_m) / away_m)
        climbs = canvas.climbs[rows][:, None]
        cover = np.clip((top - climbs) * 300 + 0.5, 0, 1) * (high > 1.0)
        rough = 1 + 0.2 * rng.standard_normal(cover.shape)
        shade = 0.6 + 0.4 * np.clip((climbs - low) / 0.04, 0, 1)
        colours = leaves * lit * (rough * shade)[..., None]
        canvas.put(rows, np.arange(COLUMNS), np.float32(away_m), colours, cover)


def _wave(first: int, rng: np.random.Generator) -> Array:
    """A line round the horizon, (COLUMNS,), of some -1 to 1."""
    waves = [(first, 0.5), (2 * first + 1, 0.3), (5 * first + 2, 0.2)]
    parts = [w * np.sin(n * _TURN + rng.uniform(0, 2 * np.pi)) for n, w in waves]
    return np.asarray(sum(parts))
