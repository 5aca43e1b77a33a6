"""Cakes, fresh and mouldy."""

from __future__ import annotations

import math

import numpy as np
from toolkit import labels
from toolkit.materials import Material, blend, plain
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model
from toolkit.sampling import noise_offset, seed_of
from toolkit.shapes import box, ellipsoid, extrude, lathe, loft, rounded_rectangle, tube

from makers.produce_kit import baked_good, one_hull, rot

KINDS = {  # icing, sponge, filling, topping
    "cream": ("f8f2e6", "e8c074", "d83c44", "d0202c"),
    "chocolate": ("4a2814", "6a3c1e", "f4e6cc", "f4e6cc"),
    "pink": ("f2a8bc", "f0d890", "fbf4e8", "fdfdfd"),
    "lemon": ("f4d866", "ecc860", "fbf4e0", "fbf4e0"),
}


def layers_picture(kind: str):
    """The side of a cut cake: two layers of filling in the sponge, icing on top."""
    icing, sponge, filling, _ = (f"#{c}" for c in KINDS[kind])
    image, d = labels.canvas(96, 96, sponge)
    rng = np.random.default_rng(2)
    dark = "#" + "".join(f"{round(255 * v):02x}" for v in blend(sponge, "000000", 0.16))
    for _ in range(90):
        x, y = rng.uniform(0, 96, 2)
        d.ellipse((x - 1.5, y - 1, x + 1.5, y + 1), fill=dark)
    for y in (38, 68):
        d.rectangle((0, y, 96, y + 9), fill=filling)
    d.rectangle((0, 0, 96, 13), fill=icing)
    return image


def cake(form="layer", kind="cream", radius=0.11, height=0.085, seed=0) -> Model:
    """A round cake whole or with a piece taken, a piece, a ring, a loaf, one with candles."""
    rng = np.random.default_rng(seed)
    o = noise_offset(rng)
    icing, sponge, _, topping = KINDS[kind]
    r, h = radius, height
    if form == "piece":
        spots = [
            (0.0, -0.005, h),
            (-0.02, -0.04, h, 0.8),
            (0.025, -0.012, h * 0.5),
            (-0.022, 0.01, h * 0.5),
            (-0.022, -0.048, h * 0.45, 0.9),
            (0.022, 0.045, h * 0.6, 0.7),
        ]
    elif form == "loaf":
        spots = [
            (0.05, 0.05, h * 0.8),
            (0.02, -0.07, h),
            (0.05, -0.03, h * 0.4, 0.8),
            (-0.03, 0.0, h),
        ]
    else:
        spots = [
            (r * 0.55, r * 0.2, h),
            (r * 0.95, r * 0.1, h * 0.5, 1.0),
            (-r * 0.4, r * 0.5, h, 0.9),
            (0.0, -r * 0.65, h, 0.8),
            (r * 0.6, r * 0.75, h * 0.6, 0.8),
            (-r * 0.9, -r * 0.3, h * 0.55),
            (-r * 0.3, r * 0.9, h * 0.5, 0.9),
            (r * 0.1, -r * 0.95, h * 0.6),
        ]

    if form == "opened":
        spots += [
            (-r * 0.65, -r * 0.1, h, 0.9),
            (r * 0.7, -r * 0.7, h * 0.5, 1.1),
            (-r * 0.72, r * 0.68, h * 0.45),
            (-r * 0.55, -r * 0.82, h * 0.55, 0.9),
        ]
    elif form == "square":
        spots += [
            (-r * 0.45, -r * 0.35, h, 0.9),
            (r * 0.35, r * 0.75, h, 0.8),
            (-r * 0.72, r * 0.1, h * 0.5, 0.9),
            (r * 0.72, -r * 0.5, h * 0.5),
            (-r * 0.1, r * 0.9, h * 0.5, 0.8),
        ]

    def aged(m: Material, c, rotten: bool, size=0.036) -> Material:
        return m.colour(rot(m, c, size, spots, o, "54482e", 0.25) if rotten else c)

    def coat(rotten: bool, tone: str) -> Material:
        m = Material()
        return aged(m, m.mottle(tone, 0.06, 40, o), rotten)

    def sliced(rotten: bool) -> Material:
        m = Material(occlusion=0.8)
        return aged(m, m.image(layers_picture(kind)), rotten)

    def cherries(rotten: bool, count: int, at: float, start=0.0, span=math.tau) -> list[Mesh]:
        cream = coat(rotten, "fbf6ea" if kind != "cream" else "fdfaf2")
        fruit = plain(topping if not rotten else "4a2418", 0.08, 100)
        out = []
        for i in range(count):
            a = start + span * (i + 0.5) / count
            x, y = at * math.cos(a), at * math.sin(a)
            blob = lathe([(0.014, 0.0), (0.01, 0.008), (0.003, 0.014), (0, 0.014)], 6, mat=cream)
            out += [blob.move(x, y, h - 0.0005), ellipsoid(0.0075, (x, y, h + 0.014), 6, 4, fruit)]
        return out

    def plate(rotten: bool, size: float) -> Mesh:
        return lathe(
            [
                (0, 0),
                (size * 0.62, 0),
                (size, 0.008),
                (size, 0.012),
                (size * 0.6, 0.006),
                (0, 0.006),
            ],
            20,
            mat=plain("eef0f2", 0.03),
        )

    def round_cake(rotten: bool, gap: float) -> list[Mesh]:
        """gap: angle of the piece that is missing, in front."""
        top, n = coat(rotten, icing), 24
        if not gap:
            profile = [(0, 0), (r, 0), (r, h * 0.93), (r * 0.96, h), (0, h)]
            return [lathe(profile, n, mat=top)]
        a = np.linspace(gap / 2 + 0.45, math.tau - gap / 2 + 0.45, n)
        outline = [(0, 0), *[(r * math.cos(t), r * math.sin(t)) for t in a]]
        mesh = extrude(outline, h, top)
        face = sliced(rotten)
        mesh.mats.append(face)
        for i, f in enumerate(mesh.f):
            points = mesh.v[list(f)]
            flat = np.ptp(points[:, 2]) > h * 0.5
            if flat and np.hypot(points[:, 0], points[:, 1]).min() < r * 0.1:
                mesh.mi[i] = 1
                mesh.label_uv[i] = [(math.hypot(p[0], p[1]) / r, p[2] / h) for p in points]
        return [mesh]

    def piece(rotten: bool) -> list[Mesh]:
        half = 0.3
        reach = r * 1.1
        arc = [(reach * math.cos(t), reach * math.sin(t)) for t in np.linspace(-half, half, 6)]
        mesh = extrude([(0, 0), *arc], h, coat(rotten, icing))
        face = sliced(rotten)
        mesh.mats.append(face)
        for i, f in enumerate(mesh.f):
            points = mesh.v[list(f)]
            if np.ptp(points[:, 2]) > h * 0.5 and np.hypot(points[:, 0], points[:, 1]).min() < 0.01:
                mesh.mi[i] = 1
                mesh.label_uv[i] = [(math.hypot(p[0], p[1]) / reach, p[2] / h) for p in points]
        out = [
            mesh.move(-0.06),
            *[m.move(-0.06) for m in cherries(rotten, 1, reach * 0.72, -0.3, 0.6)],
        ]
        out = [m.turn(rz=-2.0).move(z=0.006) for m in out]
        return [plate(rotten, 0.095), *out]

    def ring_cake(rotten: bool) -> list[Mesh]:
        m = Material()
        c = m.mix(
            m.remap(m.noise(30, 4, offset=o), 0.35, 0.65), sponge, blend(sponge, "6a3c14", 0.45)
        )
        wave = m.noise(14, 2, offset=(o[1], o[0], 1))
        edge = m.math("ADD", m.axis(2), m.math("MULTIPLY", wave, h * 0.5))
        aged(m, m.mix(m.remap(edge, h * 0.93, h * 0.97), c, icing), rotten)
        profile = [
            (r * 0.3, h * 0.5),
            (r * 0.34, 0.0),
            (r * 0.92, 0.0),
            (r, h * 0.25),
            (r * 0.95, h * 0.65),
            (r * 0.74, h),
            (r * 0.52, h * 0.97),
            (r * 0.34, h * 0.8),
        ]
        n = 24
        rings = [
            [
                (
                    q * (1 + 0.05 * math.cos(8 * a) * (q > r * 0.6)) * math.cos(a),
                    q * (1 + 0.05 * math.cos(8 * a) * (q > r * 0.6)) * math.sin(a),
                    z,
                )
                for a in (math.tau * i / n for i in range(n))
            ]
            for q, z in [*profile, profile[0]]
        ]
        return [loft(rings, mat=m, caps=(False, False)).outward()]

    def loaf_cake(rotten: bool) -> list[Mesh]:
        m = Material()
        c = m.mix(m.remap(m.noise(40, 4, offset=o), 0.35, 0.65), "a8642a", "c8843c")
        crack = m.math("ABSOLUTE", m.math("SUBTRACT", m.noise(20, 3, offset=o), 0.5))
        c = m.mix(
            m.remap(m.math("ADD", m.math("ABSOLUTE", m.axis(0)), crack), 0.0, 0.024, 0.9, 0),
            c,
            "f0c868",
        )
        drip = m.math(
            "ADD", m.axis(2), m.math("MULTIPLY", m.noise(45, 2, offset=(1, o[0], 2)), h * 0.45)
        )
        aged(m, m.mix(m.remap(drip, h * 1.0, h * 1.04), c, "fbf6ea"), rotten)
        inside = Material(occlusion=0.8)
        k = inside.mix(
            inside.remap(inside.voronoi(150, o), 0.1, 0.3), blend(sponge, "6a3c14", 0.2), sponge
        )
        aged(inside, k, rotten)
        w = 0.05
        outline = [
            (-w * 0.82, 0),
            (w * 0.82, 0),
            (w, h * 0.72),
            (w * 0.7, h * 0.9),
            (0, h),
            (-w * 0.7, h * 0.9),
            (-w, h * 0.72),
        ]
        rest = extrude(outline, 0.13, inside, m, axis="y").move(0, 0.03)
        out, y = [rest], -0.05
        for i in range(2):
            lean = 0.25 + 0.6 * i
            slab = extrude(outline, 0.016, inside, m, axis="y").turn(rx=lean)
            y -= 0.012 + 0.02 * i
            out.append(slab.move(0, y, 0))
            slab.move(z=-slab.v[:, 2].min())
        return out

    def candles() -> list[Mesh]:
        out = []
        for i in range(5):
            a = math.tau * i / 5
            x, y = r * 0.55 * math.cos(a), r * 0.55 * math.sin(a)
            colour = ("3f8ad0", "e8503c", "f2c23a")[i % 3]
            out.append(
                tube([(x, y, h - 0.002), (x, y, h + 0.05)], 0.0042, 4, mat=plain(colour, 0.03))
            )
            out.append(
                ellipsoid(
                    (0.0042, 0.0042, 0.009),
                    (x, y, h + 0.058),
                    5,
                    4,
                    plain("ffb43a", 0.1, 200, occlusion=0),
                )
            )
        return out

    def square(rotten: bool) -> list[Mesh]:
        """A tray bake: a low block with sugar hearts of icing."""
        face = sliced(rotten)
        block = box(0.16, 0.2, h, mat=face, labels={"+z": coat(rotten, icing)})
        for i in range(len(block.f)):
            if block.mi[i] == 0:
                points = block.v[list(block.f[i])]
                block.label_uv[i] = [((p[0] + p[1]) / 0.4 + 0.5, p[2] / h) for p in points]
        rim = rounded_rectangle(0.2, 0.24, 0.01, 3)
        tray = loft(
            [np.c_[rim, np.full(len(rim), z)] for z in (0.0, 0.006)], mat=plain("c8ccd0", 0.05)
        )
        dots = []
        mat = coat(rotten, topping)
        for i in range(3):
            for j in range(4):
                dots.append(
                    ellipsoid(
                        (0.012, 0.012, 0.006),
                        ((i - 1) * 0.05, (j - 1.5) * 0.05, h + 0.006),
                        7,
                        4,
                        mat,
                    )
                )
        return [tray, block.move(z=0.006), *dots]

    def shape(rotten: bool) -> list[Mesh]:
        if form == "piece":
            return piece(rotten)
        if form == "ring":
            return ring_cake(rotten)
        if form == "loaf":
            return loaf_cake(rotten)
        if form == "square":
            return square(rotten)
        gap = 0.95 if form == "opened" else 0.0
        start, span = (0.475 + 0.45, math.tau - 0.95) if gap else (0.0, math.tau)
        out = round_cake(rotten, gap) + cherries(
            rotten, {"opened": 7, "candles": 6}.get(form, 8), r * 0.8, start, span
        )
        if form == "candles":
            out += candles()
        out = [m.move(z=0.006) for m in out]
        return [plate(rotten, r * 1.22), *out]

    title = {
        "piece": "piece of cake",
        "ring": "ring cake",
        "loaf": "loaf cake",
        "candles": "birthday cake",
        "opened": f"{kind} cake with a piece cut out",
        "square": "tray cake",
    }.get(form, f"{kind} cake")
    mass = {"piece": 0.35, "ring": 0.7, "loaf": 0.5, "square": 0.9}.get(form, 1.2)
    return baked_good(title, shape, mass, one_hull, 128)


def cake_random(rng: np.random.Generator) -> dict:
    return {"seed": seed_of(rng)}


MODELS = {
    "cake": Maker(
        cake,
        cake_random,
        count=8,
        presets=[
            {"form": "layer", "kind": "cream", "seed": 1},
            {"form": "piece", "kind": "cream", "seed": 2},
            {"form": "opened", "kind": "chocolate", "seed": 3},
            {"form": "ring", "kind": "chocolate", "radius": 0.105, "seed": 4},
            {"form": "loaf", "kind": "lemon", "height": 0.075, "seed": 5},
            {"form": "candles", "kind": "pink", "radius": 0.1, "height": 0.08, "seed": 6},
            {"form": "piece", "kind": "chocolate", "seed": 2},
            {"form": "square", "kind": "chocolate", "height": 0.045, "seed": 7},
        ],
    ),
}
