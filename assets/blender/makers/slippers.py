"""Pairs of slippers."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import Material, plain, shade
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model
from toolkit.sampling import pick
from toolkit.shapes import ellipsoid, tube

from makers.footwear import at, flat_sole, foot, pair, shaft, strap, tops
from makers.shoes import HALF_WIDTH, STATIONS, upper

_VAMP = [0, 0, 0, 0.08, 0.09, 0.088, 0.082, 0.074, 0.064, 0.034]


def _plaid(ground: str, first: str, second: str) -> Material:
    m = Material()
    base = m.mottle(ground, 0.08, 120)
    for axis in (0, 1):
        for cover, colour in ((0.4, first), (0.95, second)):
            wave = m.math("SINE", m.math("MULTIPLY", m.axis(axis), 190.0))
            base = m.mix(m.remap(wave, cover - 0.05, cover + 0.02, 0, 0.55), base, colour)
    return m.colour(base)


def _fur(colour: str) -> Material:
    m = Material()
    f = m.noise(170, 3, 0.7)
    return m.colour(m.mix(m.remap(f, 0.35, 0.65), shade(colour, 0.75), shade(colour, 1.1)))


def mule(colours: list[str]) -> list[Mesh]:
    """An open-backed house slipper with a chequered front."""
    lining = _fur(colours[3])
    meshes = [
        flat_sole(0.024, plain("#3a332e", 0.05), lining, 1.06),
        foot(_VAMP, _plaid(*colours[:3]), 4, 1.12, rear=plain(shade(colours[3], 0.4), 0.1)),
    ]
    edge = [
        (at(0.42), -0.042 * math.cos(a), 0.018 + 0.074 * math.sin(a) ** 0.85)
        for a in np.linspace(0.1, math.pi - 0.1, 7)
    ]
    meshes.append(tube(np.array(edge), 0.008, 5, mat=lining))
    return meshes


def bunny(fur: str, ear: str) -> list[Mesh]:
    """A plush slipper with a rabbit's face and long ears."""
    coat, pink, dark = _fur(fur), plain(ear, 0.06), plain("#1d1a1a", 0)
    meshes = [
        flat_sole(0.024, plain(shade(fur, 0.7), 0.05), _fur(ear), 1.1),
        foot(_VAMP, coat, 4, 1.2, rear=plain(shade(fur, 0.35), 0.1)),
        ellipsoid((0.011, 0.013, 0.009), (0.128, 0.008, 0.06), 6, 4, pink),
    ]
    for q in (-1, 1):
        meshes.append(
            ellipsoid((0.009, 0.009, 0.01), (0.108, 0.005 + q * 0.022, 0.075), 5, 3, dark)
        )
        stalk = np.array(
            [(0.03, q * 0.018, 0.085), (0.0, q * 0.032, 0.115), (-0.045, q * 0.04, 0.14)]
        )
        meshes.append(tube(stalk, [0.013, 0.019, 0.008], 5, mat=coat, flatten=0.5, up=(0.5, 0, 1)))
        inner = stalk * [1, 1, 1] + [0.004, 0, 0.008]
        meshes.append(tube(inner, [0.006, 0.011, 0.004], 3, mat=pink, flatten=0.4, up=(0.5, 0, 1)))
    return meshes


def moccasin(suede: str, fur: str) -> list[Mesh]:
    """A closed suede slipper with a fur collar and a stitched apron."""
    top = tops(60, 58, 54, 52, 54, 70, 70, 60, 50, 26)
    stitched = plain(suede, 0.1, 60)
    meshes = [
        upper(top, 0.47, stitched, _fur(fur)),
        flat_sole(0.022, plain("#5a3f2a", 0.06), _fur(fur)),
    ]
    t = np.array([0.03, 0.15, 0.4, 0.5])
    w = np.interp(t, STATIONS, HALF_WIDTH) * [0.3, 0.9, 0.9, 0.3]
    x = at(t)
    loop = np.r_[np.c_[x, -w], np.c_[x, w][::-1]]
    z = 0.058 + 0.012 * np.clip((loop[:, 0] + 0.04) / 0.04, 0, 1)
    meshes.append(tube(np.c_[loop, z], 0.013, 3, closed=True, mat=_fur(fur)))
    seam = [(at(0.62), -0.036, 0.06), (at(0.9), 0.004, 0.05), (at(0.62), 0.036, 0.06)]
    meshes.append(tube(seam, 0.004, 3, mat=plain(shade(suede, 1.5), 0.05)))
    return meshes


def spa_slide(colour: str, word_colour: str) -> list[Mesh]:
    """An open-toed towelling slipper."""
    terry = _fur(colour)
    meshes = [flat_sole(0.018, plain(shade(colour, 0.8), 0.06), _fur(shade(colour, 0.95)), 1.06)]
    band = strap(0.7, 0.08, 0.1, terry, 1.02, 0.012)
    meshes.append(band)
    mark = [(at(0.7), 0.0, 0.085)]
    meshes.append(ellipsoid((0.02, 0.02, 0.006), mark[0], 10, 4, plain(word_colour, 0.04)))
    return meshes


def boot_slipper(knit: str, fur: str) -> list[Mesh]:
    """An ankle-high knitted slipper with a fluffy cuff and a pompon."""
    m = Material()
    wave = m.math("SINE", m.math("MULTIPLY", m.axis(2), 420.0))
    m.colour(m.mix(m.remap(wave, -0.4, 0.6, 0, 0.5), m.mottle(knit, 0.06, 120), shade(knit, 0.6)))
    top = tops(80, 90, 100, 105, 100, 90, 76, 64, 54, 30)
    meshes = [
        foot(top, m, 3, 1.08),
        shaft(0.15, m, plain(shade(fur, 0.5), 0.1), _fur(fur), 1.02),
        flat_sole(0.02, plain("#6a5a4a", 0.06), _fur(fur), 1.05),
    ]
    cuff = [
        (-0.08 + 0.058 * math.cos(a), 0.048 * math.sin(a), 0.148)
        for a in np.arange(8) * math.tau / 8
    ]
    meshes.append(tube(np.array(cuff), 0.021, 3, closed=True, mat=_fur(fur)))
    meshes.append(ellipsoid(0.02, (0.008, 0, 0.115), 6, 4, _fur(fur)))
    return meshes


_MAKE = {
    "mule": (mule, "pair of slippers"),
    "bunny": (bunny, "pair of bunny slippers"),
    "moccasin": (moccasin, "pair of fur-lined slippers"),
    "spa": (spa_slide, "pair of spa slippers"),
    "boot slipper": (boot_slipper, "pair of slipper boots"),
}


def slippers(style: str, **parameters) -> Model:
    """A pair of slippers."""
    model = pair(*_MAKE[style], tall=style == "boot slipper", **parameters)
    model.mass, model.texture_size = 0.35, 128
    return model


def slippers_random(rng: np.random.Generator) -> dict:
    return {
        "style": "mule",
        "length": 0.27,
        "look": {"colours": pick(rng, [["#8a2f34", "#26303c", "#e9dcc0", "#e8dcc4"]])},
        "turn": 0.12,
        "slip": -0.015,
    }


MODELS = {
    "slippers": Maker(
        slippers,
        slippers_random,
        7,
        [
            {},
            {"style": "bunny", "look": {"fur": "#f0e6e6", "ear": "#e89aa8"}},
            {"style": "moccasin", "look": {"suede": "#9a6236", "fur": "#f0e6d0"}},
            {"style": "spa", "look": {"colour": "#f2f1ec", "word_colour": "#3f7fa8"}},
            {"style": "boot slipper", "look": {"knit": "#7a8fae", "fur": "#f0ece4"}},
            {"look": {"colours": ["#3f5f8a", "#1f2a3a", "#e8e4d8", "#d8d4c8"]}},
            {"style": "bunny", "look": {"fur": "#9a8f86", "ear": "#e8b8a8"}},
        ],
    ),
}
