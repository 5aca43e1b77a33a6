"""Melons and watermelons, small tomatoes and blueberries; fresh, overripe and rotten."""

from __future__ import annotations

import math

import numpy as np
from toolkit import labels
from toolkit.materials import Material, blend, plain
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model
from toolkit.sampling import noise_offset
from toolkit.shapes import ellipsoid, lathe, tube

from makers import produce_faces as faces
from makers.clusters import dull, fur
from makers.produce_forms import Fruit, served, with_forms
from makers.produce_kit import (
    fresh_produce,
    green,
    matured,
    one_hull,
    patches,
    punnet,
    woody,
)


def water_face(rim="#2f6a2c", pith="#e4f0cc", flesh="#dc2c34", light="#ee5450"):
    """A watermelon, cut through its poles: red with black seeds in two bows."""
    image, d = labels.canvas(faces.N, faces.N, rim)
    faces.disc(d, 0.95, pith)
    faces.disc(d, 0.86, flesh)
    faces.disc(d, 0.46, light)
    for i in range(22):
        a = math.tau * (i + 0.5) / 22
        q = 0.31 + 0.05 * (i % 2)
        faces.disc(d, 0.055, "#1c1210", 0.034, 0.5 + q * math.cos(a), 0.5 + q * math.sin(a))
    return image


def bulb(r: float, h: float) -> list[tuple[float, float]]:
    """The outline of a fruit as wide as 2 r and as high as h."""
    angles = np.linspace(0, math.pi, 11)
    return [(r * math.sin(a) ** 0.92, h / 2 * (1 - math.cos(a))) for a in angles]


def stub(look: str, kind: str, z: float) -> list[Mesh]:
    """The scar of its stalk."""
    mat = woody(look) if look == "rotten" else plain("8a7a4a", 0.2, 300)
    return [lathe([(0.009, -0.002), (0.006, 0.004), (0, 0.004)], 6, mat=mat).move(z=z - 0.001)]


def curl(look: str, kind: str, z: float) -> list[Mesh]:
    """The dried end of the vine, bent over."""
    bow = ((0, -0.004), (0.003, 0.008), (0.014, 0.011), (0.022, 0.006))
    path = [(x, 0.2 * x * (x > 0.02), z + up) for x, up in bow]
    return [tube(path, [0.005, 0.0035, 0.003, 0.0026], 5, mat=woody(look))]


def muskmelon(outline, lobes, skins: dict, face) -> Fruit:
    return Fruit(
        "melon", "melons", outline, 1.2, skins, face, top=stub, detail=(14, 9), lobes=lobes
    )


def orange_inside(kind: str):
    return faces.pulp("#a8a060", "#f89a3c", "#d86a1c", size=0.5)


def pale_inside(kind: str):
    return faces.pulp("#e8dc84", "#dff0b0", "#c8d88a", size=0.5)


CANTALOUPE = muskmelon(
    bulb(0.072, 0.135),
    (9, 0.035, 0.0),
    {
        "cantaloupe": {
            "tones": ("b8a878", "d4c496"),
            "freckle": ("f4ecd2", 80, 0.42),
            "streak": ("7f8a52", (36, 36, 3), 0.54, 0.62),
        }
    },
    orange_inside,
)
HONEYDEW = muskmelon(
    bulb(0.068, 0.17),
    (0, 0.0, 0.0),
    {
        "honeydew": {
            "tones": ("ecc93a", "f8e268"),
            "streak": ("d09a1c", (70, 70, 4), 0.52, 0.58),
            "gloss": ((0.05, -0.03, 0.13), 0.03, "fff6d0"),
        }
    },
    pale_inside,
)
WATERMELON = Fruit(
    "watermelon",
    "watermelons",
    bulb(0.1, 0.19),
    3.2,
    {
        "striped": {
            "tones": ("5aa844", "7cc058"),
            "streak": ("163e1a", (34, 34, 2), 0.47, 0.52),
        },
        "dark": {"tones": ("3a7a36", "4c8c40"), "streak": ("0e2a12", (30, 30, 2), 0.43, 0.48)},
    },
    lambda kind: water_face(),
    top=curl,
    detail=(16, 9),
)


def heap(rng: np.random.Generator, r: float, wide: float) -> list[tuple[float, ...]]:
    """Places of balls of radius r in a heap: a ring, a narrower one on it, one on top."""
    places = []
    for reach, z in ((wide, r), (wide - 1.5 * r, 2.3 * r), (0.0, 3.2 * r)):
        count = max(1, int(math.tau * reach / (2.05 * r)))
        turn = float(rng.uniform(0, 6.28))
        for i in range(count):
            a = turn + math.tau * i / count
            places.append((reach * math.cos(a), reach * math.sin(a), z))
    return places


SMALL = {  # radius, how far the heap reaches, tones, shine, what is seen in its gaps
    "blueberry": (0.0095, 0.034, ("2c3560", "43528c"), "98a6cc", "20264a"),
    "red cherry tomato": (0.0145, 0.046, ("bc1a14", "de3628"), "f48a74", "6a1410"),
    "yellow cherry tomato": (0.0145, 0.046, ("eca41a", "f8c636"), "fdeaa4", "8a5a10"),
}


def small_fruit(kind: str, form="heap", seed=0) -> Model:
    """Many small fruits: a loose "heap", a "punnet" full or a "bowl"."""
    rng = np.random.default_rng(seed)
    o = noise_offset(rng)
    r, wide, tones, shine, gaps = SMALL[kind]
    lift = {"heap": 0.0, "punnet": 0.02, "bowl": 0.024}[form]
    places = heap(rng, r, wide)
    jitter = rng.uniform(-0.12, 0.12, (len(places), 3)) * r
    spots = patches(wide * 0.8, lift + 1.5 * r, seed)
    blue = kind == "blueberry"

    def skin(look: str) -> Material:
        m = Material()
        c = m.mix(m.remap(m.noise(90, 2, offset=o), 0.35, 0.65), *tones)
        c = m.mix(m.remap(m.normal(2), 0.3, 0.95, 0, 0.55), c, shine)
        if blue:  # the crown
            c = m.mix(m.remap(m.normal(2), 0.9, 0.95, 0, 0.75), c, "1a2040")
        return m.colour(matured(look, m, c, wide * 0.9, spots, o, "2c1c18", 0.3))

    def shape(look: str) -> list[Mesh]:
        mats = [skin(look)] * 2
        if look == "rotten":
            mats = [dull(o, "4a3440" if blue else "6a3418"), fur(o)]
        k = {"fresh": 1.0, "overripe": 0.93, "rotten": 0.88}[look]
        out = []
        for i, ((x, y, z), (a, b, c)) in enumerate(zip(places, jitter, strict=True)):
            n = 6
            ball = ellipsoid((r * k, r * k, r * 0.92 * k), n=n, m=4, mat=mats[i % 5 < 2])
            ball.keep_faces(range(n, len(ball.f)))  # nobody sees it from below
            at = (x + a, y + b, lift + r * k + (z - r) * k + c * 0.3)
            out.append(ball.move(*at))
            if not blue and i % 2 == 0:
                leafy = green(look)
                profile = [(r * 0.62, -0.001), (0, 0.0015)]
                calyx = lathe(profile, 10, mat=leafy, rib=lambda k_, j: 1 - 0.6 * (j % 2))
                out.append(calyx.turn(rx=0.5 * (a > 0), ry=0.4).move(*at).move(z=r * 0.88 * k))
        dark = plain(blend(gaps, "201408", 0.0 if look == "fresh" else 0.6), 0)
        inner = [(wide * 0.98, lift), (wide * 0.8, lift + 1.2 * r), (0, lift + 2.2 * r)]
        out.append(lathe([(0, lift), *inner], 8, mat=dark))
        if form == "punnet":
            side = 2 * (wide + 1.3 * r)
            tone = "cfe0e6" if blue else "4f9ac0"
            out.append(punnet(side, side * 1.05, lift + 1.4 * r, plain(tone, 0.04), lift))
        elif form == "bowl":
            rim = wide + 1.9 * r
            bowl = [(0, 0), (rim * 0.5, 0), (rim * 0.9, 0.02), (rim, 0.038), (rim * 0.94, 0.038)]
            out.append(lathe([*bowl, (rim * 0.84, lift), (0, lift)], 14, mat=plain("e9ebec", 0.03)))
        return out

    many = "blueberries" if blue else "cherry tomatoes"
    title = many if form == "heap" else f"{form} of {many}"
    return fresh_produce(title, shape, 0.15 if blue else 0.25, one_hull)


def seeded(rng: np.random.Generator) -> dict:
    return {"seed": 1}


def _table(name: str, presets: list[dict]) -> Maker:
    def make(**parameters) -> Model:
        raise NotImplementedError(f"a {name} comes from the table, by a preset")

    make.__name__ = name
    return Maker(with_forms(make), seeded, len(presets), presets)


MODELS = {
    "melon": _table(
        "melon",
        [
            served(CANTALOUPE, "one", "cantaloupe", 1),
            served(HONEYDEW, "one", "honeydew", 1),
            served(CANTALOUPE, "half", "cantaloupe", 2),
            served(HONEYDEW, "wedges", "honeydew", 3),
            served(CANTALOUPE, "wedges", "cantaloupe", 4),
            served(HONEYDEW, "half", "honeydew", 2),
        ],
    ),
    "watermelon": _table(
        "watermelon",
        [
            served(WATERMELON, "one", "striped", 1),
            served(WATERMELON, "half", "striped", 2),
            served(WATERMELON, "wedges", "striped", 3, 0.85),
            served(WATERMELON, "one", "dark", 1),
            served(WATERMELON, "half", "dark", 2),
        ],
    ),
    "cherry_tomatoes": Maker(
        small_fruit,
        seeded,
        count=4,
        presets=[
            {"kind": "red cherry tomato", "form": "punnet", "seed": 1},
            {"kind": "red cherry tomato", "form": "heap", "seed": 2},
            {"kind": "yellow cherry tomato", "form": "punnet", "seed": 1},
            {"kind": "red cherry tomato", "form": "bowl", "seed": 3},
        ],
    ),
    "blueberries": Maker(
        small_fruit,
        seeded,
        count=3,
        presets=[
            {"kind": "blueberry", "form": "punnet", "seed": 1},
            {"kind": "blueberry", "form": "heap", "seed": 2},
            {"kind": "blueberry", "form": "bowl", "seed": 3},
        ],
    ),
}
