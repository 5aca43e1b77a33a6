"""What a state does to the colour of a surface: one function a look, all on top of a texture.

Each takes a `Surface` (the node graph so far, the sizes and places to work with) and returns the
socket of the new colour. They know no model: places are points of its skin, sizes follow from it.
`sdgen assets retexture` runs them through retexture.py.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from makers.spoilage import bruise, decay
from toolkit.materials import Material

SAUCES = ("a02c14", "6a3a16", "c8921c", "4f5a1e")
LIGHT = (0.35, -0.25, 0.9)  # where painted relief is lit from
DUST_OF_DARK, DUST_OF_LIGHT = "bdb6aa", "857d71"


@dataclass
class Surface:
    """A texture about to be worn.

    colour   socket of its colour so far
    kind     what it is made of: "produce", "bread", "meat", "ware" or "thing"
    size     how large a spot on it is, metres (the radius of a fruit)
    spots    (N, 3) points of the skin, far from one another, the best seen ones first
    light    mean brightness of the texture, 0..1
    """

    m: Material
    colour: object
    kind: str
    size: float
    spots: np.ndarray
    light: float
    rng: np.random.Generator

    def offset(self) -> tuple[float, ...]:
        """Where a pattern begins: another one for every seed and call."""
        return tuple(float(v) for v in self.rng.uniform(-3, 3, 3))

    def attribute(self, name: str, i: int):
        """Component of a vector stored at the vertices."""
        m = self.m
        return m._component(m._node("ShaderNodeAttribute", attribute_name=name).outputs[1], i)

    def up(self):
        """How far the surface looks upwards, -1..1."""
        return self.attribute("facing", 2)


# ---- helpers
def _signed(s: Surface, scale: float, strength: float, detail=4.0, stretch=(1, 1, 1)):
    """Noise about 0, in metres."""
    noise = s.m.noise(scale, detail, 0.6, offset=s.offset(), stretch=stretch)
    return s.m.math("MULTIPLY", s.m.math("SUBTRACT", noise, 0.5), strength)


def _near(s: Surface, points, scales, stretches=None):
    """Distance to the nearest of some points, metres; a scale makes its spot larger."""
    m, found = s.m, None
    for k, (point, scale) in enumerate(zip(points, scales, strict=True)):
        stretch = (1, 1, 1) if stretches is None else tuple(float(v) for v in stretches[k])
        d = m.distance(tuple(float(v) for v in point), stretch)
        d = m.math("DIVIDE", d, float(scale))
        found = d if found is None else m.math("MINIMUM", found, d)
    return found


def _relief(s: Surface, colour, scale: float, strength: float, stretch=(1, 1, 1), detail=3.0):
    """Shade the colour as if noise were its height, lit from LIGHT."""
    m, o, step = s.m, np.array(s.offset()), 0.22 / scale
    high = m.noise(scale, detail, offset=tuple(o), stretch=stretch)
    moved = tuple(o + np.array(LIGHT) * stretch * step)
    slope = m.math("SUBTRACT", high, m.noise(scale, detail, offset=moved, stretch=stretch))
    factor = m.math("ADD", m.math("MULTIPLY", slope, strength), 1.0)
    return m.mix(1.0, colour, m.math("MAXIMUM", factor, 0.25), "MULTIPLY")


def _over(m: Material, mask, colour, top, amount: float = 1.0):
    """Lay a colour over another where the mask is 1."""
    return m.mix(m.math("MULTIPLY", mask, amount), colour, top)


def _colonies(s: Surface, colour, reach: float, core: str, middle: str, rim: str):
    """Round patches of mould that begin at the spots: dark inside, woolly and pale at the rim."""
    m, a = s.m, s.size
    scales = s.rng.uniform(0.55, 1.15, len(s.spots))
    near = _near(s, s.spots, scales)
    edge = m.math("ADD", near, _signed(s, 4.0 / a, a * 0.55, 5))
    fluff = m.math("ADD", near, _signed(s, 11.0 / a, a * 0.5, 5))
    colour = _over(m, m.remap(edge, a * reach * 1.0, a * reach * 1.25, 1, 0), colour, rim, 0.55)
    colour = _over(m, m.remap(fluff, a * reach * 0.78, a * reach * 0.98, 1, 0), colour, rim, 0.95)
    colour = _over(m, m.remap(fluff, a * reach * 0.5, a * reach * 0.68, 1, 0), colour, middle, 0.95)
    dark = m.math("ADD", near, _signed(s, 7.0 / a, a * 0.35, 4))
    return _over(m, m.remap(dark, a * reach * 0.14, a * reach * 0.34, 1, 0), colour, core, 0.85)


def _specks(s: Surface, colour, cell: float, width: float, top: str, amount: float = 1.0):
    """Small dots, about one a cell (metres); width 0..1 of it."""
    m = s.m
    dots = m.math("ADD", m.voronoi(1 / cell, s.offset()), _signed(s, 3 / cell, 0.3, 2))
    return _over(m, m.remap(dots, width * 0.6, width * 0.85, 1, 0), colour, top, amount)


# ---- looks
def expired(s: Surface):
    """Rotten: browned, sunken and mouldy produce; green mould on the rest; grey-green meat."""
    m, a = s.m, s.size
    if s.kind == "produce":
        half = [(*map(float, p), float(k)) for p, k in zip(s.spots[:5], s.rng.uniform(0.7, 1, 5))]
        colour = decay(m, s.colour, a, half, s.offset(), amount=0.5)
        return _relief(s, colour, 2.6 / a, 3.0, (1, 1, 2.2))
    if s.kind == "meat":
        grey = m.remap(m.noise(1.6 / a, 4, offset=s.offset()), 0.36, 0.56)
        colour = m.mix(0.55, s.colour, "6e6a4c")
        colour = _over(m, grey, colour, "4e5a34", 0.8)
        brown = m.remap(m.noise(2.2 / a, 4, offset=s.offset()), 0.5, 0.62)
        colour = _over(m, brown, colour, "2f2415", 0.8)
        return _relief(s, _colonies(s, colour, 0.55, "56694a", "9fae8d", "e4e4d6"), 5 / a, 2.0)
    stale = "b3a684" if s.kind == "bread" else "8d7f5c"
    colour = m.mix(0.3, s.colour, stale)
    blotch = m.remap(m.noise(1.5 / a, 4, offset=s.offset()), 0.5, 0.64)
    colour = _over(m, blotch, colour, "6f6a45", 0.55)
    colour = _specks(s, colour, a * 0.35, 0.34, "46584a", 0.9)
    return _relief(s, _colonies(s, colour, 0.95, "26382f", "55806c", "e2e6da"), 6 / a, 1.6)


def overripe(s: Surface):
    """Dull, with soft brown blotches and freckles; no mould."""
    return _relief(s, bruise(s.m, s.colour, s.size, s.offset()), 2.2 / s.size, 1.2)


def dirty(s: Surface):
    """Dried sauce, runs, a greasy film and crumbs on ware; mud and grime on all else."""
    m, a, rng = s.m, s.size, s.rng
    if s.kind != "ware":
        return _grimy(s)
    film = m.remap(m.noise(1.2 / a, 4, offset=s.offset()), 0.4, 0.65)
    colour = _over(m, film, s.colour, "b08a4e", 0.45)
    groups = np.array_split(rng.permutation(len(s.spots)), len(SAUCES))
    for sauce, group in zip(SAUCES, groups, strict=True):
        if not len(group):
            continue
        stretch = rng.uniform(0.55, 1.5, (len(group), 3))
        near = _near(s, s.spots[group], rng.uniform(0.7, 1.25, len(group)), stretch)
        edge = m.math("ADD", near, _signed(s, 2.2 / a, a * 0.9, 4))
        streaks = m.noise(3.0 / a, 4, offset=s.offset(), stretch=(3, 1, 1))
        body = m.math("MULTIPLY", m.remap(edge, a * 0.5, a * 0.58, 1, 0),
                      m.remap(streaks, 0.3, 0.5, 0.5, 1))  # fmt: skip
        colour = _over(m, body, colour, sauce, 0.95)
        rim = m.math("MULTIPLY", m.remap(edge, a * 0.4, a * 0.48, 0, 1),
                     m.remap(edge, a * 0.52, a * 0.58, 1, 0))  # fmt: skip
        colour = _over(m, rim, colour, "2e1a0c", 0.55)
    colour = _specks(s, colour, a * 0.3, 0.26, "7a4a1e")
    return _specks(s, colour, a * 0.22, 0.2, "3a220e")


def _grimy(s: Surface):
    m, a = s.m, s.size
    film = m.remap(m.noise(0.9 / a, 5, offset=s.offset()), 0.36, 0.6)
    colour = _over(m, film, s.colour, "6b5c44", 0.65)
    splash = m.remap(m.noise(2.2 / a, 5, 0.65, offset=s.offset()), 0.53, 0.6)
    colour = _over(m, splash, colour, "46351f", 0.9)
    near = _near(s, s.spots, s.rng.uniform(0.6, 1.2, len(s.spots)))
    edge = m.math("ADD", near, _signed(s, 2.4 / a, a * 0.9, 5))
    colour = _over(m, m.remap(edge, a * 0.5, a * 0.6, 1, 0), colour, "3a2b18", 0.95)
    return _specks(s, colour, a * 0.25, 0.24, "2c2013")


def wet(s: Surface):
    """Darker, with a sheen where it looks up, and drops with a light and a dark side."""
    m, a = s.m, s.size
    colour = m.mix(1.0, s.colour, "b4bcc6" if s.light > 0.7 else "9098a2", "MULTIPLY")
    soaked = m.remap(m.noise(1.1 / a, 4, offset=s.offset()), 0.42, 0.58)
    colour = m.mix(
        m.math("MULTIPLY", soaked, 0.75), colour, m.mix(1.0, colour, "8a919c", "MULTIPLY")
    )
    runs = m.noise(3.2 / a, 3, offset=s.offset(), stretch=(1, 1, 0.22))
    colour = _over(m, m.remap(runs, 0.6, 0.63), colour, "ffffff", 0.35)
    for cell in (a * 0.42, a * 0.23):
        colour = _drops(s, colour, min(max(cell, 0.003), 0.016))
    return colour


def _drops(s: Surface, colour, cell: float):
    m, o = s.m, np.array(s.offset())
    scale = 1 / cell
    middle = m.voronoi(scale, tuple(o))
    size = m.remap(m.noise(1.3 / cell, 1, offset=s.offset()), 0.35, 0.65, 0.16, 0.4)
    inside = m.math("DIVIDE", middle, size)  # 1 at the drop's edge
    # the same drops seen from a step towards the light: their far side is dark, their near side lit
    step = np.array(LIGHT) * cell * 0.2
    lit = m.math("DIVIDE", m.voronoi(scale, tuple(o - step)), size)
    shaded = m.math("DIVIDE", m.voronoi(scale, tuple(o + step)), size)
    mask = m.remap(inside, 0.92, 1.0, 1, 0)
    body = m.mix(1.0, colour, "c9d2dc", "MULTIPLY")
    body = _over(m, m.remap(shaded, 0.75, 0.35, 0, 1), body, "20242a", 0.0)
    body = _over(m, m.remap(inside, 0.6, 0.98, 0, 1), body, "14181e", 0.6)
    body = _over(m, m.remap(lit, 0.42, 0.62, 1, 0), body, "ffffff", 0.95)
    return m.mix(mask, colour, body)


def dusty(s: Surface):
    """A grey film on what looks up, thinner on the sides, with fluff and lint."""
    m, a = s.m, s.size
    dust = DUST_OF_LIGHT if s.light > 0.45 else DUST_OF_DARK
    cover = m.remap(s.up(), -0.15, 0.75, 0.28, 0.9)
    patchy = m.remap(m.noise(2.0 / a, 5, 0.65, offset=s.offset()), 0.3, 0.62, 0.45, 1)
    colour = m.mix(m.math("MULTIPLY", cover, patchy), s.colour, dust)
    grain = m.remap(m.noise(30 / a, 3, offset=s.offset()), 0.4, 0.62, 0, 0.35)
    colour = m.mix(grain, colour, "d8d3ca" if dust == DUST_OF_DARK else "5f584e")
    lint = m.noise(6 / a, 2, distortion=2.5, offset=s.offset())
    thread = m.math("ABSOLUTE", m.math("SUBTRACT", lint, 0.5))
    return _over(m, m.remap(thread, 0.006, 0.014, 1, 0), colour, "efece6", 0.45)


LOOKS: dict[str, Callable[[Surface], object]] = {
    "expired": expired,
    "overripe": overripe,
    "dirty": dirty,
    "wet": wet,
    "dusty": dusty,
}
