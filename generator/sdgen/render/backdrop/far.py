"""What closes the view: hills, and woods at the edge of the town."""

from __future__ import annotations

import numpy as np

from sdgen.geometry import Array
from sdgen.render.backdrop.builder import Place
from sdgen.render.backdrop.canvas import COLUMNS, PIXEL, Canvas, Floats, Ints, places_of, soft
from sdgen.render.backdrop.light import Light
from sdgen.render.backdrop.plants import grass_of
from sdgen.vocabulary import Season

#: Azimuths of the columns, and a radian's share over which land turns into sea.
_TURN = (np.arange(COLUMNS) + 0.5) / COLUMNS * 2 * np.pi
_SHORE = 0.25
#: Crowns on a hill are so many columns wide.
_CROWN = 3
#: By night such a share of a hill's pixels are windows and lamps.
_LIGHTS_SHARE = 0.006


def _off_street() -> Array:
    """How far columns are turned from +y, where the sea is, radians."""
    return np.asarray(np.abs((_TURN - np.pi / 2 + np.pi) % (2 * np.pi) - np.pi))


def paint_hills(
    canvas: Canvas, light: Light, place: Place, season: Season, rng: np.random.Generator
) -> None:
    """Hills, far and nearer, with woods; none over the sea."""
    land = np.clip((_off_street() - place.sea) / _SHORE, 0, 1) if place.sea else np.ones(COLUMNS)
    lit = light.sky + light.sun * np.float32(0.4)
    woods = grass_of(season) * np.float32(0.55)
    if place.snow:
        woods = woods * np.float32(0.5) + np.float32(0.3)
    for away_m, high in ((600.0, 0.45), (1300.0, 0.6), (2600.0, 1.0)):
        rise = _wave(3, rng) * 0.5 + 0.6
        top = np.clip(place.hills * high * rise, 0.004, None) * land - 0.002
        # Crowns of trees along the top.
        rough = 0.0012 * (1400 / away_m) * _ragged(rng)
        top = top + rough * land
        # What lies on the ground farther away is behind them.
        rows = canvas.rows(-canvas.eye_m / away_m, float(top.max()))
        cover = (canvas.rises[rows][:, None] < top.astype(np.float32)) & (land > 0)
        cover &= canvas.far_m[rows] > away_m
        r, c = np.nonzero(cover)
        speckle = rng.standard_normal((rows.stop - rows.start, COLUMNS // 2)).astype(np.float32)
        tone = 1 + 0.13 * speckle[r, c // 2]
        colours = woods * lit * tone[:, None]
        places = places_of(r + rows.start, c)
        canvas.fill(places, away_m, np.asarray(colours, dtype=np.float32))
        if light.lit and len(places):
            _add_lights(canvas, light, places, rng)


def _add_lights(canvas: Canvas, light: Light, places: Ints, rng: np.random.Generator) -> None:
    """In the dark far windows and lamps on hills are points of light."""
    some = places[rng.random(len(places)) < _LIGHTS_SHARE * light.lamps]
    tones = np.array((1.0, 0.7, 0.4), np.float32) * (0.3 + 1.1 * rng.random((len(some), 1)) ** 2)
    canvas.colours.reshape(-1, 3)[some] += tones.astype(np.float32)
    # Each is a little wider than a pixel.
    beside = np.where((some & (COLUMNS - 1)) < COLUMNS - 1, some + 1, some)
    canvas.colours.reshape(-1, 3)[beside] += (0.6 * tones).astype(np.float32)


def _ragged(rng: np.random.Generator) -> Array:
    """Crowns side by side, 0 to 1, each round at its top, (COLUMNS,)."""
    count = COLUMNS // _CROWN + 1
    at = (np.arange(COLUMNS) % _CROWN - (_CROWN - 1) / 2) / _CROWN
    high = rng.random(count).repeat(_CROWN)[:COLUMNS]
    return np.asarray(high * (1 - 1.2 * at**2))


def paint_woods(
    canvas: Canvas, light: Light, place: Place, season: Season, rng: np.random.Generator
) -> None:
    """Lines of trees at the edge of the town, with gaps."""
    leaves = grass_of(season) * np.float32(0.6 if season != "autumn" else 0.75)
    if season == "winter":
        leaves = leaves * np.float32(0.7)
    lit = light.sky * np.float32(0.8) + light.sun * np.float32(0.35)
    sea = _off_street() < place.sea
    for away_m in (240.0, 420.0):
        crowns = sum(np.abs(np.sin(_TURN * n + rng.uniform(0, 6))) for n in (97, 151, 263)) / 3
        twigs = rng.standard_normal(COLUMNS) * 0.4
        high = (13.0 * (0.55 + 0.45 * crowns) + twigs) * soft(-0.15, 0.25, _wave(4, rng))
        high = np.where(sea | (high < 1.0), -1e3, high)
        low = -canvas.eye_m / away_m
        top = ((high - canvas.eye_m) / away_m).astype(np.float32)
        rows = canvas.rows(low, float(top.max()))
        climbs = canvas.climbs[rows]
        if len(climbs) == 0:
            continue
        seen = (climbs[:, None] < top) & (canvas.far_m[rows] > away_m)
        r, c = np.nonzero(seen)
        rough = 1 + 0.2 * rng.standard_normal(len(r)).astype(np.float32)
        # Light from above on every crown, dark below.
        under = (top[c] - climbs[r]) / np.float32(6 * PIXEL)
        shade = 0.55 + 0.45 * np.clip((climbs[r] - low) / 0.04, 0, 1) + 0.25 * np.exp(-under)
        colours: Floats = (leaves * lit * (rough * shade)[:, None]).astype(np.float32)
        canvas.fill(places_of(r + rows.start, c), away_m, colours)


def _wave(first: int, rng: np.random.Generator) -> Array:
    """A line round the horizon, (COLUMNS,), of some -1 to 1."""
    waves = [(first, 0.5), (2 * first + 1, 0.3), (5 * first + 2, 0.2)]
    parts = [w * np.sin(n * _TURN + rng.uniform(0, 2 * np.pi)) for n, w in waves]
    return np.asarray(sum(parts))
