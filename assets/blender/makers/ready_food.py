"""Food that is ready to eat and must be kept cold: sandwiches, salad, sushi, shrimps."""

from __future__ import annotations

import math

import numpy as np
from toolkit import labels
from toolkit.materials import Material, plain, shade, wood
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part, box_piece, cylinder_piece
from toolkit.sampling import noise_offset
from toolkit.shapes import ellipsoid, extrude, lathe, loft, superellipse, tube

from makers.breads import crust, long_loaf
from makers.chilled import sticker, tray
from makers.packs_meat import on_tray
from makers.produce_kit import baked_good, halve, leaf, one_hull, rot


def seeded(rng: np.random.Generator) -> dict:
    return {"seed": 1}


# ---- sandwiches
FILLINGS = {  # colours of what lies on the lower slice, with its thickness and how far it reaches
    "ham": (("f0a4a0", 0.005, 1.0), ("f6cf48", 0.004, 1.03), ("5fa032", 0.004, 1.08)),
    "egg": (("f6dc7a", 0.011, 0.99), ("4f9a34", 0.004, 1.08)),
    "tomato": (("f8f4e6", 0.006, 1.0), ("d03424", 0.005, 1.03), ("4a9030", 0.004, 1.08)),
    "salmon": (("fbf8f0", 0.004, 0.99), ("f4845a", 0.006, 1.04), ("6aa63a", 0.004, 1.07)),
}
CRUMBS = {"white": ("f8ecd0", "c98f4e"), "brown": ("c89a62", "7a4a22")}


def sandwich(form="triangles", filling="ham", crumb="white", seed=0) -> Model:
    """form: "triangles" (two halves), "whole" (one, uncut), "sub" (a filled baguette), "stack"."""
    rng = np.random.default_rng(seed)
    o = noise_offset(rng)
    light, brown = CRUMBS[crumb]
    side, thick = 0.105, 0.015

    def dough(rotten: bool, spots) -> tuple[Material, Material]:
        """Crumb and crust."""
        made = []
        for tone in (light, brown):
            m = Material(occlusion=0.8)
            c = m.mix(m.remap(m.voronoi(170, o), 0.1, 0.3), shade(tone, 0.86), tone)
            if rotten:
                c = rot(m, c, 0.03, spots, o, "8a7a54", 0.25)
            made.append(m.colour(c))
        return made[0], made[1]

    def layers(outline, rotten: bool, spots) -> list[Mesh]:
        """Slice, filling, slice from z = 0; the outline's third side is the cut."""
        soft, hard = dough(rotten, spots)
        middle = np.mean(outline, axis=0)
        out, z = [], 0.0

        def slab(high: float) -> Mesh:
            mesh = extrude(outline, high, soft, hard)
            for k, face in enumerate(mesh.f):
                points = mesh.v[list(face)]
                cut = len(outline) == 3 and np.abs(points[:, 0] + points[:, 1]).max() < 1e-6
                mesh.mi[k] = 0 if cut else mesh.mi[k]
            return mesh

        out.append(slab(thick))
        z += thick
        for tone, high, reach in FILLINGS[filling]:
            grown = middle + (np.asarray(outline) - middle) * reach
            mat = plain(shade(tone, 0.62) if rotten else tone, 0.12, 80, o)
            if reach > 1.05:  # lettuce: frilled
                edge = []
                for a, b in zip(grown, np.roll(grown, -1, 0), strict=True):
                    for t in np.linspace(0, 1, 6)[:-1]:
                        wave = 1 + 0.05 * math.sin(40 * t + len(edge))
                        edge.append(middle + (a + (b - a) * t - middle) * wave)
                grown = np.array(edge)
            out.append(extrude(grown, high, mat).move(z=z))
            z += high
        out.append(slab(thick).move(z=z))
        return out

    def triangles(rotten: bool) -> list[Mesh]:
        h = 0.045
        spots = [(-0.02, -0.02, h, 1.0), (-0.045, 0.0, h, 0.8), (0.0, -0.045, h, 0.8)]
        spots += [(-0.02, -0.02, 0.01, 0.9), (0.02, -0.02, h, 0.7), (0.02, -0.02, 0.008, 0.8)]
        corner = -side / 2
        outline = [(corner, corner), (side / 2, corner), (corner, side / 2)]
        out, z = [], 0.0
        for yaw in (-1.15, -0.35):  # one on the other, their cut sides to the front
            group = [m.keep_pattern() for m in layers(np.array(outline), rotten, spots)]
            out += [m.turn(rz=yaw).move(z=z) for m in group]
            z = max(m.v[:, 2].max() for m in out)
        return out

    def whole(rotten: bool) -> list[Mesh]:
        h = 0.045
        spots = [(0.03, 0.02, h, 1.0), (-0.03, 0.03, h, 0.9), (-0.01, -0.035, h, 0.9)]
        spots += [(0.05, 0.0, 0.01, 0.9), (-0.05, -0.02, 0.01, 0.9), (0.0, 0.05, 0.01, 0.8)]
        spots += [(0.0, -0.05, 0.01, 0.8), (0.05, -0.04, h - 0.006, 0.8)]
        q, c = side / 2, 0.012
        outline = [(-q, -q), (q, -q), (q, q * 0.5), (q + 0.004, q * 0.75), (q - c, q)]
        outline += [(-q + c, q), (-q - 0.004, q * 0.75), (-q, q * 0.5)]
        return [m.turn(rz=0.4) for m in layers(np.array(outline), rotten, spots)]

    def sub(rotten: bool) -> list[Mesh]:
        """A baguette cut open, its filling looking out at the front."""
        spots = [(0.02, y, 0.05, k) for y, k in ((-0.08, 1.0), (0.0, 0.9), (0.075, 1.0))]
        spots += [(x, y, 0.03, 0.9) for x, y in ((-0.033, -0.05), (-0.033, 0.05), (0.036, 0.02))]
        tones = ("d9a054", "a8682c")
        mat = crust(
            rotten, tones, 0.036, spots, o, 0, 0.055, [(y, 0.01, 1.4) for y in (-0.06, 0.0, 0.06)]
        )
        face = plain(shade(light, 0.7) if rotten else light, 0.1, 120, o)
        loaf = long_loaf(0.23, 0.075, 0.056, mat, 10, 10, 3.0)
        base = halve(loaf, (0, 0, 0.024), (0, 0, 1), face, up=(-1, 0, 0)).keep_pattern()
        lid = halve(loaf, (0, 0, 0.024), (0, 0, -1), face, up=(1, 0, 0)).keep_pattern()
        out, z = [base], 0.023
        for tone, high, reach in FILLINGS[filling]:
            mat = plain(shade(tone, 0.62) if rotten else tone, 0.12, 80, o)
            edge = []
            for t in np.linspace(0, math.tau, 20, endpoint=False):
                frill = 1 + (0.07 * math.sin(9 * t) if reach > 1.05 else 0.02 * math.sin(5 * t))
                x, y = 0.042 * (reach + 0.05) * frill, 0.104 * (reach - 0.04)
                edge.append((x * math.cos(t) + 0.004, y * math.sin(t)))
            out.append(extrude(edge, high, mat).move(z=z))
            z += high
        return [*out, lid.turn(ry=-0.2).move(-0.004, 0, z - 0.02)]

    def stack(rotten: bool) -> list[Mesh]:
        """A club sandwich: two storeys held by a pick with an olive."""
        h = 0.09
        spots = [(0.0, 0.0, h, 1.0), (-0.03, -0.02, h, 0.8), (0.02, -0.03, h * 0.5)]
        spots += [(-0.05, -0.01, 0.03), (-0.02, -0.05, 0.05), (0.0, 0.0, 0.02), (-0.05, 0.02, h)]
        corner = -side / 2
        outline = np.array([(corner, corner), (side / 2, corner), (corner, side / 2)])
        low = layers(outline, rotten, spots)
        high = [m.move(z=max(low[-1].v[:, 2]) - thick) for m in layers(outline, rotten, spots)[1:]]
        top = max(high[-1].v[:, 2])
        pick_ = tube(
            [(-0.018, -0.018, top - 0.01), (-0.018, -0.018, top + 0.03)],
            0.0016,
            4,
            mat=plain("d8b878", 0.1),
        )
        olive = ellipsoid(0.008, (-0.018, -0.018, top + 0.022), 7, 5, plain("7f9a3c", 0.1, 90))
        return [m.turn(rz=0.8) for m in (*low, *high, pick_, olive)]

    shapes = {"triangles": triangles, "whole": whole, "sub": sub, "stack": stack}
    name = {"sub": "filled baguette", "stack": "club sandwich"}.get(form, "sandwich")
    with_ = {"ham": "ham and cheese", "egg": "egg", "tomato": "mozzarella and tomato"}
    title = f"{name} with {with_.get(filling, filling)}"
    return baked_good(title, shapes[form], 0.2, one_hull, 128)


# ---- salad
def green_salad(form="bowl", tone="#f4f2ec", seed=0) -> Model:
    """Leaves, tomatoes and cucumber in a "bowl", one of "wood" or a takeaway "box"."""
    rng = np.random.default_rng(seed)
    o = noise_offset(rng)
    r, h = (0.098, 0.072) if form != "box" else (0.085, 0.055)
    level = h - 0.014
    stuff = wood(tone, shade(tone, 0.6), 0, 14) if form == "wood" else plain(tone, 0.03)
    profile = [(0, 0), (r * 0.5, 0), (r * 0.84, h * 0.4), (r, h), (r - 0.005, h)]
    profile += [(r * 0.86, level - 0.006), (0, level - 0.006)]
    if form == "box":
        rings = [
            superellipse(r * k, r * k * 1.15, 5, 14, z)
            for k, z in ((0.86, 0), (0.98, h), (1.02, h), (0.94, h), (0.9, level))
        ]
        shell = loft(rings, mat=stuff)
    else:
        shell = lathe(profile, 16, mat=stuff)
    leafy = []
    for low, high in (("3f7f24", "7fb83e"), ("5f9a30", "b4d868"), ("7a2a3a", "4f7a2c")):
        m = Material(occlusion=0.5)
        veins = m.remap(m.noise(70, 3, 0.6, 1.0, o), 0.35, 0.62)
        leafy.append(m.colour(m.mix(veins, low, high)))
    food = [
        lathe(
            [(r * 0.88, level - 0.004), (r * 0.5, level + 0.012), (0, level + 0.018)],
            10,
            mat=leafy[0],
        )
    ]
    for i in range(13):
        a = math.tau * i / 9 + float(rng.uniform(-0.2, 0.2))
        far = r * (0.52 if i < 9 else 0.12)
        piece = leaf(r * 0.62, r * 0.5, leafy[i % 3 if i % 5 else 1], 0.3, 3)
        piece.turn(rx=float(rng.uniform(-0.5, 0.5)), ry=-0.22 if i < 9 else -0.5).turn(rz=a)
        high = level + (0.006 if i < 9 else 0.016)
        food.append(piece.move(far * math.cos(a), far * math.sin(a), high))
    red = Material(occlusion=0.6)
    red.colour(red.mottle("cc2820", 0.1, 60, o))
    for k in range(4):
        a = math.tau * k / 4 + 0.3
        far = r * (0.5 if k % 2 else 0.62)
        at = (far * math.cos(a), far * math.sin(a), level + 0.02)
        food.append(ellipsoid(0.0135, at, 6, 4, red))
    rind, flesh = plain("2f6a2c", 0.1), plain("d8ecb0", 0.08, 120, o)
    for k in range(4):
        a = math.tau * k / 4 + 0.9
        far = r * (0.32 if k % 2 else 0.55)
        coin = extrude(
            [(0.019 * math.cos(t), 0.019 * math.sin(t)) for t in np.linspace(0, math.tau, 9)[:-1]],
            0.004,
            flesh,
            rind,
        )
        coin.turn(rx=0.35, ry=0.3 * (-1) ** k)
        food.append(coin.move(far * math.cos(a), far * math.sin(a), level + 0.024))
    onion = plain("b878a8", 0.15, 120)
    for k in range(2):
        turns = np.linspace(0, math.tau, 9)[:-1]
        ring = [(0.017 * math.cos(t), 0.017 * math.sin(t), 0.0) for t in turns]
        hoop = tube(ring, 0.0026, 4, closed=True, mat=onion).turn(rx=0.4, ry=0.5 * (-1) ** k)
        food.append(hoop.move(0.02 * (-1) ** k, 0.03 * (k - 0.5), level + 0.034))
    solid = cylinder_piece(r * 0.6, 0, h + 0.012, 12, r)
    return Model(
        title={"box": "takeaway salad"}.get(form, "green salad in a bowl"),
        parts={"body": Part([shell, *food], collision=[solid])},
        mass=0.45,
        friction=0.5,
        texture_size=128,
    )


# ---- sushi
def sushi(form="mixed", dish="#1c1c20", seed=0) -> Model:
    """A tray of sushi: "mixed" rolls and slices of fish on rice, or "rolls" alone."""
    o = noise_offset(np.random.default_rng(seed))
    shell = tray(0.135, 0.205, 0.02, plain(dish, 0.04), 0.005)
    rice = Material(occlusion=0.8)
    rice.colour(rice.mix(rice.remap(rice.voronoi(330, o), 0.12, 0.4), "fbfaf4", "d4d0c2"))
    nori = plain("1c2a22", 0.2, 120, o)
    hearts = [plain(t, 0.08, 120, o) for t in ("f07a3c", "6fae3a", "c82c34")]
    meshes: list[Mesh] = [shell]

    def roll(x: float, y: float, heart: Material) -> None:
        r, high = 0.0155, 0.026
        profile = [(r, 0), (r, high), (r * 0.9, high + 0.001), (r * 0.45, high + 0.001), (0, high)]
        mats = [nori, rice, heart]
        meshes.append(lathe(profile, 8, mats=mats, mat_of_segment=[0, 0, 1, 2]).move(x, y, 0.005))

    def slice_(x: float, y: float, tone: str, line: str) -> None:
        fish = Material(occlusion=0.8)
        wave = fish.math("SINE", fish.math("MULTIPLY", fish.axis(0), 900.0))
        fish.colour(fish.mix(fish.remap(wave, 0.4, 0.9, 0, 0.8), tone, line))
        meshes.append(ellipsoid((0.028, 0.0125, 0.012), (x, y, 0.014), 7, 4, rice))
        rings = []
        for t in np.linspace(-1, 1, 5):
            z, w = 0.024 - 0.008 * t * t, 0.0145 * (1 - 0.18 * t * t)
            px = 0.034 * t
            rings.append(
                [
                    (px, -w, z - 0.004),
                    (px, w, z - 0.004),
                    (px, w * 0.9, z + 0.003),
                    (px, -w * 0.9, z + 0.003),
                ]
            )
        top = loft(rings, mat=fish).keep_pattern()
        meshes.append(top.move(x, y, 0))

    rows, wasabi = (-0.04, 0.0, 0.04), plain("9ac44a", 0.1)
    if form == "mixed":
        for i, x in enumerate(rows):
            for j, y in enumerate((-0.072, -0.037)):
                roll(x, y, hearts[(i + j) % 2])
        kinds = (("f4743c", "ffd0b0"), ("c8303a", "e8807c"), ("f4743c", "ffd0b0"))
        for k, (tone, line) in enumerate(kinds):
            slice_(-0.02 + 0.008 * (k % 2), 0.002 + 0.034 * k, tone, line)
        meshes.append(ellipsoid((0.012, 0.009, 0.008), (0.04, 0.0, 0.01), 7, 4, wasabi))
        ginger = plain("f4b8a8", 0.15, 120, o)
        for k in range(3):
            at = (0.042 - 0.004 * k, 0.05 + 0.012 * k, 0.009 + 0.003 * k)
            meshes.append(ellipsoid((0.012, 0.01, 0.004), at, 5, 3, ginger))
    else:
        for i, x in enumerate(rows):
            for j, y in enumerate((-0.07, -0.03, 0.01)):
                roll(x, y, hearts[(i + 2 * j) % 3])
        meshes.append(ellipsoid((0.014, 0.01, 0.008), (-0.03, 0.074, 0.01), 7, 4, wasabi))
        art, d = labels.canvas(200, 110, "#c8202c")
        labels.text(d, "SUSHI", (10, 12, 190, 66), "bold", "#ffffff")
        labels.text(d, "KEEP COLD", (20, 72, 180, 100), "bold", "#ffe0a0")
        meshes.append(sticker((0.03, 0.06), (0.045, 0.066, 0.02), art))
    solids = [box_piece((0, 0, 0.016), (0.129, 0.199, 0.032))]
    return Model(
        title="tray of sushi" if form == "mixed" else "tray of sushi rolls",
        parts={"body": Part(meshes, collision=solids)},
        mass=0.3,
        friction=0.5,
        texture_size=128,
    )


# ---- shrimps
def shrimps(tone="#f08a6c", dark="#d8583c", dish="#f2f2ee", words="SHRIMPS", seed=0) -> Model:
    """Curled shrimps on a foam tray with its label."""
    rng = np.random.default_rng(seed)
    o = noise_offset(rng)
    shell = Material(occlusion=0.7)
    turn = shell.math("ARCTAN2", shell.axis(1), shell.axis(0))
    bands = shell.math("SINE", shell.math("MULTIPLY", turn, 11.0))
    c = shell.mix(shell.remap(shell.noise(60, 3, offset=o), 0.35, 0.65), tone, shade(tone, 1.14))
    shell.colour(shell.mix(shell.remap(bands, 0.2, 0.8, 0, 0.75), c, dark))
    tail = plain(dark, 0.15, 120, o)
    meshes: list[Mesh] = []
    q = 0.0185
    bend = np.linspace(-2.0, 1.5, 7)
    path = np.array([(q * math.cos(a), q * math.sin(a), 0.0) for a in bend])
    radii = [0.0085, 0.0112, 0.0098, 0.0106, 0.0088, 0.0068, 0.0042]  # in rings
    for i in range(8):
        row, column = i % 2, i // 2
        x, y = -0.03 + 0.052 * row + (0.008 if column % 2 else 0), -0.078 + 0.043 * column
        body = tube(path, radii, 5, mat=shell)
        fins = []
        for turn in (-0.5, 0.5):
            blade = ((-0.002, -0.002), (0.016, -0.008), (0.019, 0), (0.016, 0.008), (-0.002, 0.002))
            fin = extrude(blade, 0.003, tail).turn(rz=float(bend[-1]) + 1.57 + turn)
            fins.append(fin.move(*path[-1]))
        yaw = 0.5 + 3.1 * (i % 2) + float(rng.uniform(-0.5, 0.5))
        for mesh in (body, *fins):
            mesh.keep_pattern().turn(rz=yaw).move(x, y, 0.0175 + 0.004 * (i % 2))
            meshes.append(mesh)
    at, band = (0.02, 0.072, 0.032), "#1f6fb0"
    return on_tray("tray of shrimps", meshes, 0.14, 0.21, dish, words, band, at, 0.3, 0.03)


def shrimp_tray(**parameters) -> Model:
    model = shrimps(**parameters)
    model.texture_size = 128
    return model


MODELS = {
    "sandwich": Maker(
        sandwich,
        seeded,
        count=6,
        presets=[
            {"form": "triangles", "filling": "ham", "seed": 1},
            {"form": "sub", "filling": "tomato", "seed": 2},
            {"form": "whole", "filling": "salmon", "crumb": "brown", "seed": 3},
            {"form": "stack", "filling": "ham", "seed": 4},
            {"form": "triangles", "filling": "egg", "crumb": "brown", "seed": 1},
            {"form": "sub", "filling": "ham", "seed": 2},
        ],
    ),
    "green_salad": Maker(
        green_salad,
        seeded,
        count=5,
        presets=[
            {"form": "bowl", "tone": "#f2f2f0", "seed": 1},
            {"form": "wood", "tone": "#a8703c", "seed": 1},
            {"form": "box", "tone": "#2a2c30", "seed": 2},
            {"form": "bowl", "tone": "#3f6f8a", "seed": 1},
            {"form": "box", "tone": "#d8c49a", "seed": 2},
        ],
    ),
    "sushi_tray": Maker(
        sushi,
        seeded,
        count=4,
        presets=[
            {"form": "mixed", "seed": 1},
            {"form": "rolls", "seed": 2},
            {"form": "mixed", "dish": "#9a2424", "seed": 1},
            {"form": "rolls", "dish": "#8a6a3c", "seed": 2},
        ],
    ),
    "shrimp_tray": Maker(
        shrimp_tray,
        seeded,
        count=3,
        presets=[
            {"seed": 1},
            {"tone": "#f8b49c", "dark": "#ee7c5a", "dish": "#2a4a7a", "seed": 1},
            {"tone": "#f4a088", "dark": "#e86a4c", "dish": "#1f2124", "seed": 3},
        ],
    ),
}
