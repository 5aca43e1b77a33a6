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

# remains of food that stand out from a light and from a dark dish; the second one runs down
ON_LIGHT = ("a02c14", "6a3a16", "c8921c", "4f5a1e")
ON_DARK = ("e6d8b4", "b98a4e", "d8a722", "7d8a3a")
LIGHT = (0.35, -0.25, 0.9)  # where painted relief is lit from
DUST_OF_DARK, DUST_OF_LIGHT = "bdb6aa", "776d5f"


@dataclass
class Surface:
    """A texture about to be worn.

    colour   socket of its colour so far
    kind     what it is made of: "produce", "bread", "meat", "ware" or "thing"
    size     how large a spot on it is, metres (the radius of a fruit)
    spots    (N, 3) points of the skin, far from one another, most of them seen from above
    bottom   the point of it that looks up nearest to the middle: of a plate, where the food was
    light    mean brightness of the texture, 0..1
    """

    m: Material
    colour: object
    kind: str
    size: float
    spots: np.ndarray
    bottom: np.ndarray
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
    near = _near(s, s.spots, s.rng.uniform(0.4, 1.2, len(s.spots)))
    r = a * reach
    edge = m.math("ADD", near, _signed(s, 3.5 / a, a * 0.45, 5))
    fluff = m.math("ADD", near, _signed(s, 9.0 / a, a * 0.4, 5))
    dark = m.math("ADD", near, _signed(s, 6.0 / a, a * 0.3, 4))
    colour = _over(m, m.remap(edge, r * 1.0, r * 1.3, 1, 0), colour, rim, 0.35)
    colour = _over(m, m.remap(fluff, r * 0.82, r * 0.98, 1, 0), colour, rim, 0.95)
    colour = _over(m, m.remap(fluff, r * 0.6, r * 0.76, 1, 0), colour, middle, 0.95)
    return _over(m, m.remap(dark, r * 0.2, r * 0.45, 1, 0), colour, core, 0.85)


def _specks(s: Surface, colour, cell: float, width: float, top: str, amount: float = 1.0):
    """Small dots, about one a cell (metres); width 0..1 of it."""
    m = s.m
    dots = m.math("ADD", m.voronoi(1 / cell, s.offset()), _signed(s, 3 / cell, 0.3, 2))
    return _over(m, m.remap(dots, width * 0.6, width * 0.85, 1, 0), colour, top, amount)


def _where(s: Surface, first: float, second: float, scale: float, detail=4.0, stretch=(1, 1, 1)):
    """1 where noise is above the second limit, 0 below the first."""
    return s.m.remap(s.m.noise(scale, detail, 0.6, 0, s.offset(), stretch), first, second)


# ---- looks
def expired(s: Surface):
    """Rotten: browned, sunken and mouldy produce; green mould on the rest; grey-green meat."""
    m, a = s.m, s.size
    if s.kind == "produce":
        scale = s.rng.uniform(0.8, 1.25, len(s.spots))
        spots = [(*map(float, p), float(k)) for p, k in zip(s.spots[:6], scale, strict=False)]
        colour = decay(m, s.colour, a, spots, s.offset(), amount=0.55)
        return _relief(s, colour, 2.6 / a, 3.0, (1, 1, 2.2))
    if s.kind == "meat":
        colour = m.mix(0.4, s.colour, "6e6a4c")
        colour = _over(m, _where(s, 0.5, 0.62, 1.6 / a), colour, "4e5a34", 0.6)
        colour = _over(m, _where(s, 0.54, 0.64, 2.2 / a), colour, "2f2415", 0.8)
        return _relief(s, _colonies(s, colour, 0.36, "4a5a48", "8fa37c", "e0e0d2"), 5 / a, 2.0)
    if s.kind == "bread":
        colour = m.mix(0.2, s.colour, "a39a78")
        colour = _specks(s, colour, a * 0.4, 0.36, "3f5545", 0.9)
        return _relief(s, _colonies(s, colour, 0.62, "26382f", "55806c", "e2e6da"), 6 / a, 1.6)
    # what comes in a pack: it has leaked through, and there the mould is
    colour = _over(m, _where(s, 0.46, 0.58, 1.2 / a), s.colour, "6b5a30", 0.7)
    near = m.math("ADD", _near(s, s.spots, [1.0] * len(s.spots)), _signed(s, 2.4 / a, a * 0.8))
    colour = _over(m, m.remap(near, a * 0.6, a * 0.75, 1, 0), colour, "4a3d20", 0.75)
    return _relief(s, _colonies(s, colour, 0.5, "26382f", "55806c", "e2e6da"), 6 / a, 1.6)


def overripe(s: Surface):
    """Dull, with soft brown blotches and freckles; no mould."""
    return _relief(s, bruise(s.m, s.colour, s.size, s.offset()), 2.2 / s.size, 1.2)


def dirty(s: Surface):
    """Dried sauce, runs, a greasy film and crumbs on ware; mud and grime on all else."""
    if s.kind != "ware":
        return _grimy(s)
    m, a, rng = s.m, s.size, s.rng
    film, sauces = ("a8824a", ON_LIGHT) if s.light > 0.4 else ("5a3c20", ON_DARK)
    colour = _over(m, _where(s, 0.46, 0.62, 1.4 / a), s.colour, film, 0.35)
    sides = m.remap(m.math("ABSOLUTE", s.up()), 0.5, 0.8, 1, 0)
    runs = _where(s, 0.56, 0.59, 2.6 / a, 2, (1, 1, 0.16))
    broken = _where(s, 0.36, 0.46, 1.6 / a, 3)
    runs = m.math("MULTIPLY", m.math("MULTIPLY", runs, sides), broken)
    colour = _over(m, runs, colour, sauces[1], 0.85)
    some = [s.bottom, *s.spots[: max(4, len(s.spots) * 2 // 3)]]
    for k, spot in enumerate(some):
        stretch = rng.uniform(0.6, 1.5, (1, 3))
        near = _near(s, [spot], [1.5 if k == 0 else float(rng.uniform(0.45, 1.0))], stretch)
        edge = m.math("ADD", near, _signed(s, 2.6 / a, a * 0.7, 5))
        inside = m.remap(edge, a * 0.46, a * 0.52, 1, 0)
        thick = _where(s, 0.35, 0.55, 4.0 / a, 4, (2.5, 1, 1))
        body = m.math("MULTIPLY", inside, m.remap(thick, 0, 1, 0.7, 1))
        colour = _over(m, body, colour, sauces[k % len(sauces)], 0.95)
        crust = m.math("MULTIPLY", inside, m.remap(edge, a * 0.36, a * 0.46, 0, 1))
        colour = _over(m, crust, colour, "2e1a0c", 0.6)
    colour = _specks(s, colour, min(a * 0.3, 0.02), 0.22, "7a4a1e")
    return _specks(s, colour, min(a * 0.22, 0.014), 0.18, "3a220e")


def _grimy(s: Surface):
    m, a = s.m, s.size
    less = 0.07 if a > 0.07 else 0.0  # furniture is never dirty all over
    colour = _over(m, _where(s, 0.4 + less, 0.6 + less, 0.9 / a, 5), s.colour, "6b5c44", 0.6)
    colour = _over(m, _where(s, 0.54 + less, 0.61 + less, 2.2 / a, 5), colour, "46351f", 0.9)
    near = _near(s, s.spots, s.rng.uniform(0.6, 1.2, len(s.spots)))
    edge = m.math("ADD", near, _signed(s, 2.4 / a, a * 0.9, 5))
    colour = _over(m, m.remap(edge, a * 0.42, a * 0.52, 1, 0), colour, "3a2b18", 0.95)
    return _specks(s, colour, min(a * 0.25, 0.012), 0.22, "2c2013")


def wet(s: Surface):
    """Darker and glossier, covered with drops lit from one side, trickles on the sides."""
    m, a = s.m, s.size
    colour = m.mix(1.0, s.colour, "c4cad4" if s.light > 0.6 else "d4d8dc", "MULTIPLY")
    soaked = _where(s, 0.46, 0.54, 0.8 / a, 3)
    colour = m.mix(soaked, colour, m.mix(1.0, colour, "b8c0cc", "MULTIPLY"))
    pools = m.math("MULTIPLY", _where(s, 0.5, 0.66, 1.1 / a, 2), m.remap(s.up(), 0.8, 0.95))
    colour = _over(m, pools, colour, "b4c4d8", 0.16)  # the sky in what stands on level places
    sides = m.remap(m.math("ABSOLUTE", s.up()), 0.5, 0.7, 1, 0)
    o, stretch = np.array(s.offset()), (1, 1, 0.08)
    trickle = m.noise(2.4 / a, 2, 0.4, offset=tuple(o), stretch=stretch)
    beside = tuple(o + np.array([LIGHT[0], LIGHT[1], 0]) * a * 0.12)
    slope = m.math("SUBTRACT", trickle, m.noise(2.4 / a, 2, 0.4, offset=beside, stretch=stretch))
    dark = m.math("MULTIPLY", m.remap(trickle, 0.585, 0.6), sides)
    lit = m.math("MULTIPLY", m.remap(slope, 0.02, 0.032), dark)
    colour = m.mix(dark, colour, m.mix(1.0, colour, "8a929e", "MULTIPLY"))
    colour = _over(m, lit, colour, "f4f8ff", 0.55)
    for cell in (a * 0.8, a * 0.5, a * 0.32):
        colour = _drops(s, colour, min(max(cell, 0.006), 0.035))
    return colour


def _drops(s: Surface, colour, cell: float):
    """Drops of water, at most one a cell (metres): a shadow, a dark and a light side, a glint."""
    m, o, scale = s.m, np.array(s.offset()), 1 / cell
    size = m.remap(m.noise(0.9 / cell, 1, offset=s.offset()), 0.42, 0.6, 0.2, 0.38)

    def shape(step: float):
        """How far from a drop's middle, 1 at its brim, if it lay a step (in cells) to the light."""
        moved = m.voronoi(scale, tuple(o - np.array(LIGHT) * step * cell))
        return m.math("DIVIDE", moved, size)

    inside, glint = shape(0.0), shape(0.13)
    shadow = m.remap(shape(-0.09), 0.85, 1.1, 1, 0)
    colour = m.mix(shadow, colour, m.mix(1.0, colour, "6e747e", "MULTIPLY"))
    # what is seen through a drop is brighter, most on its far side; of a dark thing it stays dark
    white = float(np.interp(s.light, [0.5, 0.8], [0.012, 0.5]))
    far = m.mix(white, m.mix(1.0, colour, (2.2, 2.2, 2.2), "MULTIPLY"), "ffffff")
    near = m.mix(1.0, colour, "7c8088", "MULTIPLY")
    body = m.mix(1.0, colour, (1.2, 1.2, 1.2), "MULTIPLY")
    body = m.mix(m.remap(shape(-0.2), 0.5, 1.3, 1, 0), body, far)
    body = m.mix(m.remap(shape(0.2), 0.4, 1.0, 0.5, 0), body, near)
    body = _over(m, m.remap(glint, 0.22, 0.32, 1, 0), body, "ffffff", 1.0)
    return m.mix(m.remap(inside, 0.93, 1.0, 1, 0), colour, body)


def dusty(s: Surface):
    """A grey film on what looks up, thin on the sides, with lint, and wiped off by a finger."""
    m, a = s.m, s.size
    dust, grains = (DUST_OF_LIGHT, "5f584e") if s.light > 0.45 else (DUST_OF_DARK, "d8d3ca")
    sides = 0.45 if s.light > 0.45 else 0.12
    cover = m.remap(s.up(), -0.2, 0.8, sides, 0.96)
    patchy = m.remap(m.noise(2.0 / a, 5, 0.65, offset=s.offset()), 0.3, 0.6, 0.6, 1)
    cover = m.math("MULTIPLY", cover, patchy)
    wide = min(0.012, a * 0.3)
    for k, spot in enumerate(s.spots[:3]):
        stretch = [(0.22, 1, 1), (1, 0.22, 1), (0.3, 1, 1)][k]
        wiped = m.math("ADD", _near(s, [spot], [1.0], [stretch]), _signed(s, 4 / wide, wide * 0.3))
        cover = m.math("MULTIPLY", cover, m.remap(wiped, wide * 0.9, wide * 1.15, 0.08, 1))
    colour = m.mix(cover, s.colour, dust)
    grain = m.math("MULTIPLY", _where(s, 0.45, 0.62, 30 / a, 3), cover)
    colour = _over(m, grain, colour, grains, 0.4)
    lint = m.noise(6 / a, 2, distortion=2.5, offset=s.offset())
    thread = m.math("ABSOLUTE", m.math("SUBTRACT", lint, 0.5))
    return _over(m, m.remap(thread, 0.004, 0.01, 1, 0), colour, "efece6", 0.4)


LOOKS: dict[str, Callable[[Surface], object]] = {
    "expired": expired,
    "overripe": overripe,
    "dirty": dirty,
    "wet": wet,
    "dusty": dusty,
}
