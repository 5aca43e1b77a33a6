"""Chilled food in packs: sliced ham, sausages, fish fillets, pudding."""

from __future__ import annotations

import math

import numpy as np
from labels import foods
from toolkit import labels
from toolkit.materials import Material, label, metal, plain
from toolkit.mesh import Mesh
from toolkit.model import Model, Part, box_piece, cylinder_piece
from toolkit.sampling import noise_offset, pick, seed_of, uniform
from toolkit.shapes import box, lathe, loft, rounded_rectangle, superellipse, tube

from makers.projection import project_label


def tray(width: float, length: float, height: float, mat: Material, floor: float = 0.005) -> Mesh:
    """A hollow tray with a rolled rim, `length` along y."""
    rings = [
        (0.012, 0.0),
        (0.001, height - 0.004),
        (0.0, height),
        (0.008, height),
        (0.014, floor),
    ]
    shapes = [(rounded_rectangle(width - 2 * k, length - 2 * k, 0.02, 4), z) for k, z in rings]
    return loft([np.c_[q, np.full(len(q), z)] for q, z in shapes], mat=mat)


def sticker(size: tuple[float, float], at: tuple[float, float, float], picture) -> Mesh:
    """A thin printed label, upright for somebody at the front (+X)."""
    return box(*size, 0.0015, at, plain("ffffff", 0), labels={"+z": label(picture)}, weight=1.6)


def ham_top(kind: str, colour: str, brand: str, rng):
    """Print of the film: slices seen below, a coloured band above."""
    image, d = labels.canvas(400, 300, "#e9e4df")
    tones = {
        "HAM": ("#f2aaa6", "#ecdcc8", "#d98884"),
        "SMOKED HAM": ("#e08a80", "#8a4a2c", "#c06a64"),
        "SALAMI": ("#b8392e", "#e0c8b0", "#f2d0c0"),
    }
    foods.ham_slices(d, (10, 128, 390, 292), rng, *tones[kind])
    d.rectangle((0, 0, 400, 122), fill=colour)
    labels.text(d, brand, (20, 6, 200, 36), "italic", "#ffe9b0")
    labels.text(d, kind, (20, 36, 380, 98), "bold", "#ffffff")
    labels.text(d, "SLICED  ·  KEEP COLD", (60, 98, 340, 120), "bold", "#ffffff")
    return image


def sliced_ham(
    length=0.19, width=0.14, height=0.016, kind="HAM", colour="#1f4f9c", brand="Hofgut", seed=0
) -> Model:
    """A flat pack of slices under a printed film."""
    rng = np.random.default_rng(seed)
    film = plain("dfe3e4", 0.03)

    def ring(z: float, inset: float) -> np.ndarray:
        outline = rounded_rectangle(width - 2 * inset, length - 2 * inset, 0.014, 4)
        return np.c_[outline, np.full(len(outline), z)]

    z = height
    levels = [(0, 0.014), (z - 0.004, 0.011), (z - 0.003, 0), (z - 0.0005, 0), (z, 0.008)]
    body = loft([ring(*level) for level in levels], mat=film)
    body.bake_uv = None
    project_label(
        body, label(ham_top(kind, colour, brand, rng)), "+z", (0, 0), (length, width), 0.5
    )
    return Model(
        title=f"pack of sliced {kind.lower()}",
        parts={
            "body": Part([body], collision=[box_piece((0, 0, height / 2), (width, length, height))])
        },
        mass=0.15,
        friction=0.5,
    )


def sliced_ham_random(rng: np.random.Generator) -> dict:
    return {
        "length": uniform(rng, 0.175, 0.2),
        "width": uniform(rng, 0.13, 0.15),
        "brand": pick(rng, ["Hofgut", "Alba", "Dorfmetz"]),
        "seed": seed_of(rng),
    }


def sausage_pack(
    count=5, length=0.19, skin="#c0623c", word="SAUSAGES", band="#a81c24", brand="Dorfmetz", seed=0
) -> Model:
    """Sausages side by side in a foam tray, a printed band across."""
    rng = np.random.default_rng(seed)
    o = noise_offset(rng)
    r = 0.0135
    width, h = count * r * 2 + 0.034, 0.024
    m = Material(occlusion=0.9)
    c = m.mottle(skin, 0.14, 60, o)
    c = m.mix(m.remap(m.voronoi(260, o), 0.08, 0.16, 0.5, 0), c, "f2c8a8")
    shine = m.remap(m.noise(30, 1, offset=(o[1], 0, 0), stretch=(1, 0.3, 1)), 0.62, 0.7, 0, 0.5)
    m.colour(m.mix(shine, c, "fbe0cc"))
    meshes = [tray(width, length, h, plain("f1f0ec", 0.04, 200))]
    half = length / 2 - 0.026
    for i in range(count):
        x = (i - (count - 1) / 2) * r * 2
        sway = rng.uniform(-0.002, 0.002)
        path = [
            (x + sway * math.cos(t * 1.6) + (0.0012 if abs(t) > 1 else 0), t * half, 0.006 + r)
            for t in (-1.09, -1.05, -0.9, -0.4, 0, 0.4, 0.9, 1.05, 1.09)
        ]
        radii = np.array([0.25, 0.6, 0.95, 1, 1, 1, 0.95, 0.6, 0.25]) * r
        meshes.append(tube(path, radii, 7, mat=m, up=(0, 0, 1)))
    image, d = labels.canvas(300, 150, band)
    labels.text(d, brand, (60, 4, 240, 32), "italic", "#ffe9b0")
    labels.text(d, word, (8, 34, 292, 86), "bold", "#ffffff")
    foods.sausage(d, 110, 116, 150, 20, "#c0562c")
    labels.text(d, "KEEP COLD", (198, 100, 292, 134), "bold", "#bfe4ff")
    meshes.append(sticker((width * 0.6, length * 0.52), (0, 0, 0.006 + 2 * r - 0.0006), image))
    top = 0.007 + 2 * r
    solid = box_piece((0, 0, top / 2), (width - 0.006, length - 0.006, top))
    return Model(
        title=f"pack of {word.lower()}",
        parts={"body": Part(meshes, collision=[solid])},
        mass=0.35,
        friction=0.5,
    )


def sausage_pack_random(rng: np.random.Generator) -> dict:
    return {
        "length": uniform(rng, 0.18, 0.205),
        "brand": pick(rng, ["Dorfmetz", "Hofgut", "Wurstel"]),
        "seed": seed_of(rng),
    }


def flesh_of(kind: str, offset) -> Material:
    """Salmon: orange with pale chevrons; cod: white with soft flakes."""
    m = Material(occlusion=0.8)
    base, line = ("ee7a48", "f9c7a4") if kind == "SALMON" else ("efe9e0", "cdbfae")
    c = m.mottle(base, 0.08, 40, offset)
    # chevrons: bands along y, bent at the middle
    bent = m.math("ADD", m.axis(1), m.math("MULTIPLY", m.math("ABSOLUTE", m.axis(0)), 0.7))
    wobble = m.math("MULTIPLY", m.noise(30, 2, offset=offset), 0.012)
    wave = m.math("SINE", m.math("MULTIPLY", m.math("ADD", bent, wobble), 420.0))
    c = m.mix(m.remap(wave, 0.55, 0.95, 0, 0.85), c, line)
    return m.colour(c)


def fish_fillet(
    length=0.24, width=0.15, kind="SALMON", dish="#1f2124", band="#0f4f8a", brand="Nordhav", seed=0
) -> Model:
    """Two fillets on a foam tray with a label."""
    rng = np.random.default_rng(seed)
    flesh = flesh_of(kind, noise_offset(rng))
    skin = plain("8a9299" if kind == "SALMON" else "b9b2a4", 0.15, 120)
    meshes = [tray(width, length, 0.022, plain(dish, 0.05, 200))]
    for x in (-1, 1):
        a, b = width * 0.17, length * 0.42
        rings = []
        for k, z in ((0.94, 0.005), (1.0, 0.011), (0.93, 0.02), (0.72, 0.025), (0.25, 0.027)):
            ring = superellipse(a * k, b * k, 2.6, 20, z)
            ring[:, 0] *= 1 - 0.22 * (ring[:, 1] / b)  # a thinner tail end
            ring[:, 2] -= (ring[:, 2] - 0.005) * 0.3 * (0.5 + 0.5 * ring[:, 1] / b)
            rings.append(ring)
        piece = loft(rings, mats=[flesh, skin], mat_of_face=lambda k, i: int(k == 0))
        piece.bake_uv = None
        piece.keep_pattern()
        meshes.append(piece.turn(rz=0.04 * x).move(x * width * 0.2))
    image, d = labels.canvas(260, 170, band)
    labels.text(d, brand, (50, 4, 210, 34), "italic", "#ffe9b0")
    labels.text(d, kind, (8, 36, 252, 92), "bold", "#ffffff")
    foods.fish(d, 128, 130, 66, "#ffb48a" if kind == "SALMON" else "#dfeaf2")
    top = 0.0275
    meshes.append(sticker((width * 0.5, length * 0.36), (0, length * 0.02, top - 0.0055), image))
    solid = box_piece((0, 0, top / 2), (width - 0.006, length - 0.006, top))
    return Model(
        title=f"{kind.lower()} fillets on a tray",
        parts={"body": Part(meshes, collision=[solid])},
        mass=0.32,
        friction=0.5,
    )


def fish_fillet_random(rng: np.random.Generator) -> dict:
    return {
        "length": uniform(rng, 0.22, 0.255),
        "width": uniform(rng, 0.14, 0.16),
        "brand": pick(rng, ["Nordhav", "Fjordal", "Marisol"]),
        "seed": seed_of(rng),
    }


PUDDINGS = {  # flavour: (pudding, light, cup, ink)
    "CHOCOLATE": ("#5a2f1a", "#8a5230", "#e8cfa8", "#4a2010"),
    "VANILLA": ("#f0cf62", "#fbeaa8", "#3f7fc0", "#1c3f7a"),
    "CARAMEL": ("#b8702a", "#e0a050", "#f4e2c4", "#7a3f10"),
}


def pudding_cup(radius=0.038, height=0.062, flavour="CHOCOLATE", brand="Cremosa", seed=0) -> Model:
    """A plastic cup under a printed foil."""
    pudding, light, cup, ink = PUDDINGS[flavour]
    w, h = 240, 190
    wrap, d = labels.canvas(3 * w, h, cup)
    d.rectangle((0, h * 0.86, 3 * w, h), fill=pudding)
    lettering = ink if flavour != "VANILLA" else "#ffffff"
    for x in (0, w, 2 * w):  # one of them faces the front
        labels.text(d, brand, (x + 50, 4, x + 190, 32), "italic", lettering)
        labels.text(d, "PUDDING", (x + 16, 34, x + 224, 78), "bold", lettering)
        foods.swirl(d, x + 120, 124, 74, pudding, light)
    low = radius * 0.78
    body = lathe(
        [
            (0, 0.003),
            (low * 0.9, 0.003),
            (low * 0.95, 0),
            (low, 0.001),
            (radius, height - 0.004),
            (radius + 0.004, height - 0.004),
            (radius + 0.004, height - 0.0015),
            (0, height - 0.0015),
        ],
        22,
        mats=[plain(cup, 0.02), label(wrap)],
        mat_of_segment=[0, 0, 0, 1, 0, 0, 0],
        label_z=(0.001, height - 0.004),
        start=-math.pi,
        weight=1.2,
    )
    top, d = labels.canvas(256, 256, "#d9dde0")
    d.ellipse((8, 8, 248, 248), fill=cup)
    labels.text(d, "PUDDING", (28, 62, 228, 112), "bold", lettering)
    foods.swirl(d, 128, 178, 62, pudding, light)
    labels.text(d, flavour, (60, 36, 196, 62), "bold", lettering)
    r = radius + 0.0045
    foil = lathe(
        [(0, height - 0.0014), (r, height - 0.0014), (r, height), (0, height)],
        22,
        mat=metal("d9dde0", "a4abb0"),
    )
    project_label(foil, label(top), "+z", (0, 0), (2 * r, 2 * r), 0.9)
    # the pull tab
    tab = box(0.014, 0.016, 0.0012, (r + 0.004, 0, height - 0.0013), metal("d9dde0", "a4abb0"))
    solid = cylinder_piece(low, 0, height, 12, radius + 0.004)
    return Model(
        title=f"cup of {flavour.lower()} pudding",
        parts={"body": Part([body, foil, tab], collision=[solid])},
        mass=0.15,
        friction=0.5,
    )


def pudding_cup_random(rng: np.random.Generator) -> dict:
    return {
        "radius": uniform(rng, 0.035, 0.041),
        "height": uniform(rng, 0.055, 0.07),
        "brand": pick(rng, ["Cremosa", "Alba", "Dolcina"]),
        "seed": seed_of(rng),
    }
