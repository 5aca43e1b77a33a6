"""Bell peppers, cucumbers, carrots; fresh, overripe and rotten."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import Material, blend, plain, shade
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model
from toolkit.sampling import noise_offset, seed_of, uniform
from toolkit.shapes import lathe, loft, tube

from makers import table_garden as table
from makers.fruit import smooth_profile
from makers.produce_forms import served, with_forms
from makers.spoilage import age, aged, lying_pieces, spots_around, wither

PEPPERS = {"red": "c8201c", "yellow": "f2b814", "green": "2f7a24"}


def bell_pepper(size=1.0, kind="red", seed=0) -> Model:
    """A blocky pepper standing on its lobes, with a thick green stalk."""
    rng = np.random.default_rng(seed)
    o, phase, s = noise_offset(rng), rng.uniform(0, 6.28), size
    colour = PEPPERS[kind]
    r = 0.041 * s
    spots = spots_around(r, 0.038 * s)
    outline = [
        (0, 0.009),
        (0.012, 0.003),
        (0.023, 0.001),
        (0.033, 0.014),
        (0.038, 0.036),
        (0.041, 0.058),
        (0.037, 0.074),
        (0.024, 0.081),
        (0.011, 0.075),
        (0, 0.069),
    ]

    def skin(look: str) -> Material:
        m = Material()
        c = m.mix(m.remap(m.noise(20, 2, offset=o), 0.35, 0.65), shade(colour, 0.86), colour)
        light = blend(colour, "ffffff", 0.45)
        for point in (
            (r, r * 0.25, 0.062 * s),
            (r * 0.2, -r * 0.95, 0.06 * s),
            (-r * 0.9, r * 0.4, 0.06 * s),
        ):
            shine = m.distance(point, (1, 1, 0.45))
            c = m.mix(m.remap(shine, r * 0.1, r * 0.34, 0.7, 0), c, light)
        return m.colour(age(look, m, c, r, spots, o))

    def shape(look: str) -> list[Mesh]:
        mesh = lathe(
            smooth_profile([(q * s, z * s) for q, z in outline], 13),
            16,
            mat=skin(look),
            discs=False,
        )

        def lobes(x, y, z):
            a = math.atan2(y, x)
            f = 1 + 0.09 * math.cos(4 * a + phase) - 0.03 * math.cos(a)
            foot = 0.003 * s * math.cos(4 * a + phase) * max(0, 1 - z / (0.03 * s))
            return x * f, y * f, z - foot

        mesh.warp(lobes)
        wither(look, mesh, r, spots, 0.17)
        top = float(mesh.v[-1][2])
        green = plain("4f8a2c" if look == "fresh" else "6a5a2c", 0.15, 200)
        crown = lathe(
            [(0, -0.002), (0.015 * s, 0.004), (0.012 * s, 0.007), (0.004, 0.009), (0, 0.01)],
            8,
            mat=green,
            rib=lambda k, i: 1 - 0.3 * (i % 2) if k == 1 else 1,
        ).move(z=top)
        path = [(0, 0, top + 0.006), (0.002, 0.001, top + 0.017), (0.007, 0.003, top + 0.026)]
        stalk = tube(path, [0.0055 * s, 0.0045 * s, 0.006 * s], 6, mat=green)
        return [mesh, crown, stalk]

    return aged(f"{kind} bell pepper", shape, 0.18)


def bell_pepper_random(rng: np.random.Generator) -> dict:
    return {"size": uniform(rng, 0.95, 1.08), "seed": seed_of(rng)}


def rod(length: float, radii, bend: float, n: int, mat, rings: int, ribs: float = 0.0) -> Mesh:
    """A bent round rod lying along y on z = 0; radii along it are interpolated."""
    out = []
    for t in np.linspace(0, 1, rings):
        t = 0.5 - 0.5 * math.cos(math.pi * t)  # closer together towards the ends
        q = float(np.interp(t, np.linspace(0, 1, len(radii)), radii))
        x = bend * (1 - (2 * t - 1) ** 2)
        angles = [2 * math.pi * i / n for i in range(n)]
        out.append(
            np.array(
                [
                    (
                        x + q * math.cos(a) * (1 + ribs * math.cos(3 * a)),
                        (t - 0.5) * length,
                        max(radii) + q * math.sin(a) * (1 + ribs * math.cos(3 * a)),
                    )
                    for a in angles
                ]
            )
        )
    return loft(out, mat=mat)


def along_rod(length: float, r: float) -> list[tuple[float, ...]]:
    """Where something long goes bad: patches along its upper side."""
    return [
        (r * 0.5, -length * 0.3, r * 1.8),
        (-r * 0.6, length * 0.02, r * 1.6),
        (r * 0.4, length * 0.32, r * 1.7),
    ]


def droop(look: str, mesh: Mesh, length: float, r: float, phase: float) -> Mesh:
    """Limp when overripe; thin, wavy and caved in when rotten."""
    if look == "fresh":
        return mesh
    k = 0.05 if look == "overripe" else 0.13

    def sag(x, y, z):
        wave = math.sin(14 * y / length + phase)
        return x * (1 - k) + r * k * 1.5 * wave, y * (1 - k * 0.3), z * (1 - k * (1 + 0.8 * wave))

    return mesh.warp(sag)


def cucumber(length=0.26, radius=0.021, cut=False, seed=0) -> Model:
    """A long cucumber; cut: an end is gone and three slices lie beside it."""
    rng = np.random.default_rng(seed)
    o, phase = noise_offset(rng), rng.uniform(0, 6.28)
    r, span = radius, length * (0.62 if cut else 1.0)
    spots = along_rod(span, r)
    slices = [(0.0, span / 2 + 0.016, 0.35), (0.004, span / 2 + 0.036, 0.75)]

    def skin(look: str) -> Material:
        m = Material()
        c = m.mix(m.remap(m.noise(40, 3, offset=o), 0.35, 0.65), "1f4f1c", "336f28")
        streaks = m.noise(110, 3, offset=o, stretch=(1, 0.12, 1))
        c = m.mix(m.remap(streaks, 0.54, 0.68, 0, 0.6), c, "7aa84a")
        ends = m.remap(m.axis(1), -span * 0.34, -span * 0.5, 0, 0.6)
        c = m.mix(ends, c, "a8b85a")
        if look == "overripe":  # cucumbers turn yellow
            yellow = m.noise(22, 3, offset=(o[1], 3, o[2]))
            c = m.mix(m.remap(yellow, 0.38, 0.58, 0.2, 0.95), c, "c8a82c")
        return m.colour(age(look, m, c, r * 1.6, spots, o, "2a1c0c", 0.45))

    def face(look: str) -> Material:
        m = Material(occlusion=0.8)
        c = m.mix(m.remap(m.voronoi(260, o), 0.1, 0.3), "d8e8a8", "eef4cc")
        return m.colour(age(look, m, c, r * 1.6, spots, o, "2a1c0c", 0.5))

    def shape(look: str) -> list[Mesh]:
        radii = [0.35 * r, 0.8 * r, 0.95 * r, r, r, 0.98 * r, r] + (
            [r] if cut else [0.92 * r, 0.78 * r, 0.35 * r]
        )
        body = rod(span, radii, 0 if cut else 0.012, 12, skin(look), 11, 0.03)
        inside = face(look)
        if cut:
            body.mats.append(inside)
            body.mi[-1] = 1  # the far cap
        droop(look, body, span, r, phase)
        out = [body]
        for x, y, lean in slices if cut else ():
            n = 12
            rings = [
                [
                    (q * r * math.cos(a), w, r + q * r * math.sin(a))
                    for a in np.arange(n) * math.tau / n
                ]
                for q, w in ((1, -0.003), (1, 0.003))
            ]
            piece = loft(rings, mats=[skin(look), inside])
            piece.mi = [0] * n + [1, 1]
            out.append(piece.turn(rx=-lean).move(x, y + 0.012 * lean, 0))
            low = out[-1].v[:, 2].min()
            out[-1].move(z=-low)
        return out

    def solids(group: list[Mesh]) -> list[np.ndarray]:
        return lying_pieces(group[0], 3) + [m.v.copy() for m in group[1:]]

    return aged("cut cucumber" if cut else "cucumber", shape, 0.35 * span / 0.26, solids)


def cucumber_random(rng: np.random.Generator) -> dict:
    return {
        "length": uniform(rng, 0.24, 0.29),
        "radius": uniform(rng, 0.019, 0.023),
        "seed": seed_of(rng),
    }


def carrot(length=0.17, radius=0.015, count=1, seed=0) -> Model:
    """One carrot with its greens, or three side by side with short stalks."""
    rng = np.random.default_rng(seed)
    o = noise_offset(rng)
    sizes = rng.uniform(0.88, 1.05, count)
    turns = rng.uniform(-0.14, 0.14, count)
    bends = rng.uniform(-0.006, 0.006, count)
    r = radius
    xs = [(i - (count - 1) / 2) * r * 2.6 for i in range(count)]
    spots = [
        (x + dx, y, z)
        for x in xs
        for dx, y, z in [(r * 0.3, length * 0.2, r * 1.8), (-r * 0.5, -length * 0.1, r * 1.4)]
    ]

    def skin(look: str) -> Material:
        m = Material()
        c = m.mix(m.remap(m.noise(40, 3, offset=o), 0.35, 0.65), "e0701a", "f08a2c")
        rings = m.noise(330, 2, offset=o, stretch=(0.15, 1, 0.15))
        c = m.mix(m.remap(rings, 0.55, 0.64, 0, 0.65), c, "a84c10")
        c = m.mix(m.remap(m.axis(1), length * 0.44, length * 0.5, 0, 0.7), c, "7a8a2c")
        return m.colour(age(look, m, c, r * 1.7, spots, o, "2a1a0c", 0.4))

    def greens(look: str, top: tuple[float, float, float], yaw: float) -> list[Mesh]:
        tone = {"fresh": "4f9a2c", "overripe": "a89a3a", "rotten": "4a3a1c"}[look]
        out = []
        fan = (-0.6, -0.3, 0.0, 0.3, 0.6) if count == 1 else (-0.25, 0.3)
        reach = 0.055 if count == 1 else 0.022
        for i, a in enumerate(fan):
            rise = {"fresh": 0.02, "overripe": 0.002, "rotten": -0.004}[look] * (1 - i % 2)
            x, y, z = top
            end = (x + reach * math.sin(a + yaw), y + reach * math.cos(a + yaw), z + rise)
            middle = [(u + v) / 2 for u, v in zip(top, end, strict=True)]
            middle[2] += 0.004
            path = [top, middle, end]
            leaf = 0.008 if count == 1 else 0.0022
            out.append(
                tube(
                    path,
                    [0.002, leaf, leaf * 0.4],
                    5,
                    mat=plain(tone, 0.25, 200),
                    flatten=0.5,
                )
            )
        return out

    def shape(look: str) -> list[Mesh]:
        out, mat = [], skin(look)
        for x, size, turn, bend in zip(xs, sizes, turns, bends, strict=True):
            radii = np.array([0.08, 0.3, 0.5, 0.66, 0.8, 0.9, 1.0, 1.0, 0.5]) * r * size
            body = rod(
                length * size,
                list(radii),
                bend,
                8 if count == 1 else 7,
                mat,
                9 if count == 1 else 7,
            )
            droop(look, body, length, r, 1.0 + x * 90)
            body.turn(rz=turn).move(x)
            out.append(body)
            end = body.v[-7:].mean(0)
            out += greens(look, tuple(end), -turn)
        return out

    def solids(group: list[Mesh]) -> list[np.ndarray]:
        bodies = [m for m in group if len(m.v) > 40]
        leaves = [m.v for m in group if len(m.v) <= 40]
        return [
            *(piece for body in bodies for piece in lying_pieces(body, 2)),
            *([np.concatenate(leaves)] if leaves else []),
        ]

    title = "carrot" if count == 1 else f"{count} carrots"
    return aged(title, shape, 0.09 * count, solids)


def carrot_random(rng: np.random.Generator) -> dict:
    return {
        "length": uniform(rng, 0.155, 0.19),
        "radius": uniform(rng, 0.014, 0.017),
        "seed": seed_of(rng),
    }


MODELS = {
    "bell_pepper": Maker(
        with_forms(bell_pepper),
        bell_pepper_random,
        count=8,
        presets=[
            {"kind": "red"},
            {"kind": "yellow"},
            {"kind": "green"},
            served(table.PEPPER, "half", "red", 3),
            served(table.PEPPER_LONG, "one", "red", 4),
            served(table.PEPPER, "pair", "green", 5),
            served(table.PEPPER, "three", "red", 6),
            served(table.PEPPER, "half", "yellow", 3),
        ],
    ),
    "cucumber": Maker(
        with_forms(cucumber),
        cucumber_random,
        count=6,
        presets=[
            {},
            {"cut": True},
            served(table.CUCUMBER, "three", seed=3),
            served(table.CUCUMBER, "half", seed=4),
            served(table.CUCUMBER, "slices", seed=5),
            served(table.CUCUMBER, "one", seed=6),
        ],
    ),
    "carrot": Maker(
        with_forms(carrot),
        carrot_random,
        count=7,
        presets=[
            {},
            {"count": 3},
            served(table.CARROT, "pile", seed=3),
            served(table.CARROT_BARE, "one", seed=4),
            served(table.CARROT_BARE, "slices", seed=5),
            served(table.CARROT_ROUND, "three", seed=6),
            served(table.CARROT_BARE, "pile", seed=7),
        ],
    ),
}
