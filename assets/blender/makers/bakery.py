"""Bread and cheese."""

from __future__ import annotations

import math

import numpy as np
from toolkit import labels
from toolkit.materials import Material, blend, plain, shade
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part
from toolkit.sampling import noise_offset, pick, seed_of, uniform
from toolkit.shapes import box, extrude, loft

from makers.breads import bread_served, croissant
from makers.cheeses import cheese_served
from makers.produce_kit import baked_good, one_hull, rot
from makers.spoilage import MOULD, MOULD_GREEN, SPOILED, on_table


def mouldy(m: Material, colour, spots, size: float, offset):
    """White-green patches around some points (x, y, z[, scale]); scale makes a patch larger."""
    fuzz = m.math(
        "MULTIPLY", m.math("SUBTRACT", m.noise(4 / size, 4, 0.7, offset=offset), 0.5), size * 1.4
    )
    for x, y, z, *scale in spots:
        away = m.distance((x, y, z))
        near = m.math("ADD", m.math("DIVIDE", away, scale[0]) if scale else away, fuzz)
        colour = m.mix(m.remap(near, size * 0.75, size, 1, 0), colour, "7c7a5a")
        colour = m.mix(m.remap(near, size * 0.55, size * 0.7, 1, 0), colour, MOULD)
        colour = m.mix(m.remap(near, size * 0.3, size * 0.5, 1, 0), colour, MOULD_GREEN)
    return colour


def crust(light: str, dark: str, height: float, offset, scale=30.0):
    """A crust material under construction, paler low down; returns it and its colour."""
    m = Material()
    c = m.mix(m.remap(m.noise(scale, 4, offset=offset), 0.35, 0.65), dark, light)
    c = m.mix(
        m.remap(m.axis(2), height * 0.15, height * 0.7, 0.6, 0), c, blend(light, "e8c890", 0.6)
    )
    return m, c


def loaf(
    length=0.24, width=0.12, height=0.09, light="#c98a48", dark="#8a5024", cuts=4, seed=0
) -> Model:
    """An oval country loaf along Y with scored, floury top."""
    rng = np.random.default_rng(seed)
    o = noise_offset(rng)

    def body(rot: bool) -> list[Mesh]:
        m, c = crust(light, dark, height, o)
        for i in range(cuts):
            y = (i - (cuts - 1) / 2) * length * 0.2
            slant = m.math("ADD", m.axis(1), m.math("MULTIPLY", m.axis(0), 0.55))
            gap = m.math("ABSOLUTE", m.math("SUBTRACT", slant, y))
            top = m.remap(m.axis(2), height * 0.62, height * 0.75)
            c = m.mix(m.math("MULTIPLY", m.remap(gap, 0.005, 0.009, 1, 0), top), c, "edd9ae")
        flour = m.math(
            "MULTIPLY",
            m.remap(m.noise(90, 4, offset=(o[1], 0, o[0])), 0.5, 0.62),
            m.remap(m.axis(2), height * 0.5, height * 0.9),
        )
        c = m.mix(m.math("MULTIPLY", flour, 0.6), c, "f6ecd8")
        if rot:
            c = m.mix(0.3, c, "6b5a3a")
            c = mouldy(
                m,
                c,
                [
                    (width * 0.38, length * 0.1, height * 0.6),
                    (width * 0.2, -length * 0.25, height * 0.85),
                    (0, length * 0.3, height * 0.9),
                    (-width * 0.42, -length * 0.06, height * 0.55, 1.2),
                    (-width * 0.3, length * 0.26, height * 0.65, 0.9),
                    (-width * 0.2, -length * 0.33, height * 0.7),
                    (width * 0.1, length * 0.47, height * 0.4, 0.9),
                    (width * 0.05, -length * 0.47, height * 0.35, 0.9),
                ],
                0.035,
                o,
            )
        m.colour(c)
        rings, n = [], 16
        for t in np.linspace(-1, 1, 13):
            t = math.sin(t * math.pi / 2)
            k = max(0.06, math.sqrt(max(0, 1 - abs(t) ** 2.4)))
            ring = []
            for i in range(n):
                a = 2 * math.pi * i / n
                x, z = math.cos(a) * width / 2 * k, math.sin(a)
                bump = 1 + 0.03 * math.sin(t * 14 + 1)
                z = height * 0.36 + (z * height * 0.64 * bump if z > 0 else z * height * 0.36) * (
                    0.35 + 0.65 * k
                )
                ring.append((x, t * length / 2, z))
            rings.append(np.array(ring))
        mesh = loft(rings, mat=m)
        mesh.bake_uv = None
        return [mesh]

    return bread_model("country loaf", body(False), body(True), 0.6)


def sandwich_bread(
    length=0.2, width=0.11, height=0.11, light="#c98a48", dark="#8a5024", slices=3, seed=0
) -> Model:
    """A tin loaf along Y, some slices cut off and leaning at its end."""
    rng = np.random.default_rng(seed)
    o = noise_offset(rng)
    dome = [
        (-0.5, 0.0),
        (0.5, 0.0),
        (0.5, 0.6),
        (0.56, 0.72),
        (0.53, 0.88),
        (0.36, 0.98),
        (0, 1.0),
        (-0.36, 0.98),
        (-0.53, 0.88),
        (-0.56, 0.72),
        (-0.5, 0.6),
    ]
    outline = [(x * width * 0.9, z * height) for x, z in dome]

    def group(rot: bool) -> list[Mesh]:
        side, c = crust(light, dark, height, o)
        face = Material(occlusion=0.8)
        holes = face.mix(face.remap(face.voronoi(170, o), 0.1, 0.28), "d9bd8c", "f3e3c0")
        x = face.math("MULTIPLY", face.math("ABSOLUTE", face.axis(0)), 1 / (width * 0.5))
        edge = face.math(
            "MAXIMUM",
            face.remap(x, 0.86, 0.95),
            face.remap(face.axis(2), height * 0.93, height * 0.985),
        )
        f = face.mix(edge, holes, light)
        if rot:
            # the top, both sides, the cut end, then the slices
            spots = [
                (width * x, length * y, height * z, scale)
                for x, y, z, scale in (
                    (0.2, -0.26, 1.0, 1.1),
                    (-0.25, 0.02, 1.0, 0.9),
                    (0.22, 0.3, 1.0, 1.3),
                    (-0.3, 0.42, 0.95, 0.8),
                    (0.5, -0.2, 0.65, 1.2),
                    (0.5, 0.04, 0.3, 0.8),
                    (0.5, 0.27, 0.45, 1.3),
                    (-0.5, -0.16, 0.4, 1.1),
                    (-0.5, 0.2, 0.65, 1.4),
                    (-0.5, 0.42, 0.25, 0.8),
                    (0.05, 0.5, 0.55, 1.3),
                    (0.2, -0.62, 0.5, 1.2),
                    (-0.25, -0.48, 0.3, 1.0),
                    (0.5, -0.52, 0.6, 1.0),
                    (-0.5, -0.58, 0.55, 1.0),
                )
            ]
            c, f = (
                mouldy(side, side.mix(0.25, c, "6b5a3a"), spots, 0.032, o),
                mouldy(face, f, spots, 0.03, o),
            )
        side.colour(c)
        face.colour(f)
        rest = extrude(
            outline, length - 0.014 * slices, face, side, axis="y", bevel_width=0.0025
        ).move(0, 0.007 * slices, 0)
        out = [rest]
        y = -length / 2 + 0.007 * slices
        for i in range(slices):
            y -= 0.002
            piece = extrude(outline, 0.012, face, side, axis="y")
            lean = 0.1 + 0.16 * i
            piece.move(0, -0.006, 0).turn(rx=lean).move(0, y, 0.0005)
            y -= 0.013 / math.cos(lean) + 0.006
            out.append(piece)
        return out

    return bread_model("sliced tin loaf", group(False), group(True), 0.5)


def bread_model(title: str, fresh: list[Mesh], rotten: list[Mesh], mass: float) -> Model:
    on_table(fresh, rotten)
    return Model(
        title=title,
        mass=mass,
        friction=0.8,
        texture_size=256,
        parts={
            "body": Part(fresh, collision="hull"),
            "body_rotten": Part(rotten, collision="hull"),
        },
        variants={"default": ["body"], "rotten": ["body_rotten"]},
        states=SPOILED,
    )


def bread(style="loaf", **parameters) -> Model:
    if style.startswith("more:"):
        return bread_served(style[5:], parameters.get("tone", "golden"), parameters["seed"])
    parameters.pop("tone", None)
    return (loaf if style == "loaf" else sandwich_bread)(**parameters)


def bread_random(rng: np.random.Generator) -> dict:
    light, dark = pick(
        rng, [("#c98a48", "#8a5024"), ("#b9773a", "#6f3d1a"), ("#d9a05a", "#a06428")]
    )
    return {
        "style": "loaf",
        "length": uniform(rng, 0.2, 0.26),
        "light": light,
        "dark": dark,
        "seed": seed_of(rng),
    }


def cheese(style="wedge", **parameters) -> Model:
    """A wedge or a wrapped block, or one of the other forms (style more:...)."""
    if style.startswith("more:"):
        return cheese_served(style[5:], parameters["seed"])
    return old_cheese(style=style, **parameters)


def old_cheese(
    style="wedge", radius=0.1, height=0.06, angle_deg=42.0, colour="#f4c93e", rind="#d99a1c", seed=0
) -> Model:
    """A wedge of holed cheese, or a wrapped block (style block)."""
    rng = np.random.default_rng(seed)
    o = noise_offset(rng)
    if style == "block":
        return wrapped_block((radius * 0.75, radius * 1.35, height * 0.75), colour, o)
    half = math.radians(angle_deg) / 2
    arc = [(radius * math.cos(a), radius * math.sin(a)) for a in np.linspace(-half, half, 8)]
    outline = [(0, 0), *arc]
    spots = [
        (radius * 0.75, radius * 0.22, height * 0.7),
        (radius * 0.45, 0.0, height),
        (radius * 0.85, -radius * 0.2, height, 0.9),
        (radius * 0.4, radius * 0.16, height * 0.25, 0.8),
        (radius * 0.6, -radius * 0.24, height * 0.5, 0.9),
    ]

    def wedge(rotten: bool) -> list[Mesh]:
        inside = Material(occlusion=0.8)
        base = inside.mottle(colour, 0.05, 40, o)
        for scale, size in ((45, 0.3), (80, 0.24)):
            holes = inside.voronoi(scale, (o[0], o[1], scale))
            base = inside.mix(
                inside.remap(holes, size, size + 0.05, 1, 0), base, shade(colour, 0.72)
            )
            base = inside.mix(
                inside.remap(holes, size * 0.6, size, 0.8, 0), base, shade(colour, 0.55)
            )
        inside.colour(rot(inside, base, 0.024, spots, o, "5c5234", 0.15) if rotten else base)
        wax = plain(rind, 0.06, 60, o)
        mesh = extrude(outline, height, inside, bevel_width=0.0015)
        mesh.mats = [inside, wax]
        for i, face in enumerate(mesh.f):  # the arc is rind
            centre = mesh.v[list(face)].mean(0)
            if math.hypot(*centre[:2]) > radius * 0.985:
                mesh.mi[i] = 1
        # turned so that a cut face looks to the front
        return [mesh.keep_pattern().turn(rz=math.radians(100))]

    return baked_good("wedge of cheese", wedge, 0.25, one_hull, 128)


def wrapped_block(size: tuple[float, float, float], colour: str, o) -> Model:
    """A block in printed film."""
    top, d = labels.canvas(256, 170, colour)
    d.rectangle((0, 0, 256, 60), fill="#c3262c")
    labels.text(d, "GOUDA", (30, 6, 226, 54))
    labels.text(d, "young & mild", (40, 66, 216, 92), "italic", "#7a1712")
    for x, y, r in ((60, 130, 18), (120, 118, 12), (180, 138, 20), (215, 110, 9)):
        tone = tuple(int(255 * v) for v in shade(colour, 0.75))
        d.ellipse((x - r, y - r, x + r, y + r), fill=tone)
    sx, sy, sz = size
    spots = [
        (sx * 0.4, sy * 0.3, sz),
        (-sx * 0.2, -sy * 0.3, sz, 0.9),
        (sx * 0.5, -sy * 0.2, sz * 0.4),
    ]

    def block(rotten: bool) -> list[Mesh]:
        def worn(m: Material, c) -> Material:
            return m.colour(rot(m, c, 0.026, spots, o, "5c5234", 0.15) if rotten else c)

        skin, print_ = Material(), Material()
        worn(skin, skin.mottle(colour, 0.06, 60, o))
        worn(print_, print_.image(top))
        sides = {"+z": print_, "+x": (print_, (0, 0.6, 1, 1))}
        return [box(sx, sy, sz, mat=skin, bevel_width=0.004, labels=sides)]

    return baked_good("block of cheese", block, 0.4, one_hull)


def croissant_random(rng: np.random.Generator) -> dict:
    return {"seed": seed_of(rng)}


def cheese_random(rng: np.random.Generator) -> dict:
    return {
        "radius": uniform(rng, 0.095, 0.12),
        "height": uniform(rng, 0.05, 0.065),
        "angle_deg": uniform(rng, 36, 50),
        "seed": seed_of(rng),
    }


MODELS = {
    "bread": Maker(
        bread,
        bread_random,
        count=9,
        presets=[
            {"style": "loaf"},
            {"style": "sandwich"},
            {"style": "more:baguette", "seed": 3},
            {"style": "more:rolls", "seed": 4},
            {"style": "more:boule", "tone": "rye", "seed": 5},
            {"style": "more:toast", "seed": 6},
            {"style": "more:bag", "seed": 7},
            {"style": "more:cut_baguette", "seed": 8},
            {"style": "more:bun", "seed": 9},
        ],
    ),
    "croissant": Maker(
        croissant,
        croissant_random,
        count=7,
        presets=[
            {"form": "one", "seed": 1},
            {"form": "pair"},
            {"form": "plate"},
            {"form": "one", "bend": 0.02},
            {"form": "basket"},
            {"form": "three"},
            {"form": "one", "drizzle": True, "seed": 1},
        ],
    ),
    "cheese": Maker(
        cheese,
        cheese_random,
        count=8,
        presets=[
            {"style": "wedge"},
            {"style": "block"},
            {"style": "more:wheel", "seed": 3},
            {"style": "more:holed", "seed": 4},
            {"style": "more:slices", "seed": 5},
            {"style": "more:red", "seed": 6},
            {"style": "more:soft", "seed": 7},
            {"style": "more:cubes", "seed": 8},
        ],
    ),
}
