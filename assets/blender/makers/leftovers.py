"""Leftovers in plastic boxes: open, with what is in them fresh or mouldy, or shut with a lid."""

from __future__ import annotations

import math

import numpy as np
from toolkit import labels
from toolkit.materials import Material, label, plain
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part, box_piece
from toolkit.sampling import noise_offset, pick, seed_of, uniform
from toolkit.shapes import (
    box,
    ellipsoid,
    extrude,
    loft,
    rounded_rectangle,
    superellipse,
    tube,
)

from makers.bakery import mouldy
from makers.convex import few_corners
from makers.produce_kit import leaf, rot
from makers.spoilage import SPOILED


def shell(width: float, length: float, height: float, mat: Material, floor: float) -> Mesh:
    """An open box down to its floor (which the food covers), `length` along y."""
    levels = [
        (0.012, 0.0),
        (0.010, 0.003),
        (0.002, height - 0.006),
        (0.0, height - 0.006),
        (0.0, height),
        (0.004, height),
        (0.012, floor),
    ]
    rings = []
    for k, z in levels:
        outline = rounded_rectangle(width - 2 * k, length - 2 * k, 0.022, 4)
        rings.append(np.c_[outline, np.full(len(outline), z)])
    return loft(rings, mat=mat)


DISHES = {  # shape of the box; sauce, its dark tone, pieces
    "curry": ("round", "d8941c", "b8701a", ("e8c060", "4f8a2c", "d8d0c0")),
    "salad": ("deep", "5a9a2c", "3f7a24", ("d8342a", "f4f0e0", "8fc84a")),
    "pizza": ("flat", "e8c070", "c8904a", ("b8281c", "f6d878", "3f7a24")),
    "dinner": ("split", "f2e4b0", "e0cc88", ("8a4a24", "3f8a2c", "e8822c")),
    "soup": ("tall", "d05a24", "b8421a", ("f4e0a0", "4f8a2c", "e89040")),
}


def foods_aged(colour_of, rotten: bool, spots, o, size=0.032) -> Material:
    """A food's material, mouldy or not; colour_of(material) gives its colour."""
    m = Material(occlusion=0.8)
    c = colour_of(m)
    return m.colour(rot(m, c, size, spots, o, "5a4a2c", 0.3) if rotten else c)


def food_spots(w: float, d: float, z: float) -> list[tuple[float, ...]]:
    places = ((0.2, 0.24, 1.0), (-0.2, -0.05, 1.0), (0.18, -0.26, 0.9), (-0.24, 0.3, 0.8))
    return [(w * x, d * y, z, k) for x, y, k in places]


def served_box(dish: str, plastic: str, lid: str, seed: int) -> Model:
    """Open boxes of other shapes: a round one, a deep one, a flat one, one with a partition."""
    rng = np.random.default_rng(seed)
    o = noise_offset(rng)
    style, tone, dark, bits = DISHES[dish]
    w, d, h = {
        "round": (0.15, 0.15, 0.07),
        "deep": (0.15, 0.15, 0.095),
        "flat": (0.185, 0.235, 0.045),
        "split": (0.15, 0.215, 0.05),
        "tall": (0.115, 0.115, 0.085),
    }[style]
    level = h - 0.016
    tub = plain(plastic, 0.03)
    spots = food_spots(w, d, level + 0.008)

    def rim(k: float, n=24) -> np.ndarray:
        if style in ("round", "tall"):
            a = np.arange(n) * math.tau / n
            return np.c_[np.cos(a), np.sin(a)] * (w / 2 - k)
        return rounded_rectangle(w - 2 * k, d - 2 * k, 0.024, 4)

    taper = 0.012 if style != "tall" else 0.004
    levels = [(taper, 0.0), (0.002, h - 0.006), (0.0, h - 0.006), (0.0, h), (0.004, h)]
    levels.append((taper, level - 0.002))
    walls = loft([np.c_[rim(k), np.full(len(rim(k)), z)] for k, z in levels], mat=tub)

    def food(rotten: bool) -> list[Mesh]:
        def sauce(m: Material):
            c = m.mix(m.remap(m.noise(60, 3, offset=o), 0.38, 0.62), dark, tone)
            return m.mix(m.remap(m.voronoi(120, o), 0.08, 0.16, 0.5, 0), c, bits[0])

        wide = 0.032 if style in ("flat", "split") else 0.044
        base = foods_aged(sauce, rotten, spots, o, wide)
        rise = 0.004 if style in ("tall", "flat") else 0.012
        rings = [
            np.c_[rim(0.008) * k, np.full(len(rim(0)), level + rise * (1 - k))]
            for k in (1, 0.7, 0.3)
        ]
        paper = plain("efe8d8", 0.06) if style == "flat" else base
        mound = loft(rings, mat=paper, caps=(False, True))
        mound.bake_uv = None
        if mound.signed_volume() < 0:
            mound.flip()
        out = [mound]
        mats = [
            foods_aged(lambda m, b=b: m.mottle(b, 0.14, 110, o), rotten, spots, o, wide)
            for b in bits
        ]
        draw = np.random.default_rng(seed + 1)
        if style == "flat":  # two pieces of pizza
            for sign in (-1, 1):
                wedge = [(-0.06, -0.045), (-0.06, 0.045), (0.075, 0.0)]
                slab = extrude(wedge, 0.014, base).move(0.0, 0, level + 0.002)
                crust = tube(
                    [(-0.062, y, 0.008) for y in (-0.045, 0, 0.045)], 0.011, 7, mat=mats[1]
                )
                group = [slab, crust.move(z=level + 0.003)]
                for x, y in ((-0.03, -0.018), (-0.025, 0.02), (0.012, 0.0)):
                    group.append(
                        ellipsoid((0.014, 0.014, 0.005), (x, y, level + 0.016), 8, 4, mats[0])
                    )
                for x, y in ((-0.005, -0.014), (0.035, 0.004), (-0.045, 0.003)):
                    group.append(
                        ellipsoid((0.008, 0.005, 0.004), (x, y, level + 0.017), 6, 4, mats[2])
                    )
                for m in group:
                    m.turn(rz=math.pi * (sign < 0) + 0.1).move(0.006 * sign, 0.052 * sign)
                out += group
            return out
        if style == "split":  # meat, greens and carrots beside the mash
            for i in range(3):
                patty = ellipsoid(
                    (0.02, 0.026, 0.011), (-0.03 + 0.03 * i, -0.062, level + 0.008), 9, 5, mats[0]
                )
                out.append(patty.turn(rz=0.1 * i))
            for i in range(8):
                x, y = draw.uniform(-0.05, 0.05), draw.uniform(0.045, 0.088)
                out.append(ellipsoid(0.0085, (x, y, level + 0.008), 6, 4, mats[1 + i % 2]))
            out.append(box(w - 0.012, 0.006, h - 0.006, (0, 0.028, 0.001), tub))
            return out
        for i in range(14):
            x, y = draw.uniform(-0.33, 0.33) * w, draw.uniform(-0.33, 0.33) * d
            mat, z = mats[i % 3], level + rise * 0.5
            if style == "deep" and i % 3 == 2:  # salad leaves
                piece = leaf(0.05, 0.03, mat, 0.35).move(-0.02).turn(rz=draw.uniform(0, 6))
                out.append(piece.move(x, y, z + 0.006))
            elif style == "deep" and i % 3 == 0:
                out.append(ellipsoid(0.011, (x, y, z + 0.006), 7, 5, mat))
            else:
                side = draw.uniform(0.013, 0.02) * (0.8 if style == "tall" else 1)
                cube = box(side, side * 0.8, side * 0.6, mat=mat)
                cube.turn(0.3 * draw.standard_normal(), 0.0, draw.uniform(0, 3))
                out.append(cube.move(x * 0.9, y * 0.9, z + 0.002))
        return out

    cover = plain(lid, 0.03)
    outline = rim(-0.003)
    top = loft(
        [
            np.c_[outline * k, np.full(len(outline), z)]
            for k, z in ((1, 0), (1, 0.007), (0.94, 0.01))
        ],
        mat=cover,
    )
    top.turn(ry=-1.15 if style != "tall" else -1.2)
    top.move(z=-top.v[:, 2].min()).move(x=-w / 2 - np.ptp(top.v[:, 0]) * 0.42)
    boxes = [box_piece((0, 0, h / 2), (w - 0.006, d - 0.006, h))]
    with_lid = style in ("round", "deep", "tall")
    body = [walls, top] if with_lid else [walls]
    if with_lid:
        boxes.append(few_corners(top.v, 16))
    return Model(
        title=f"box of leftover {dish}",
        mass=0.55,
        friction=0.5,
        texture_size=256,
        parts={
            "body": Part(body, collision=boxes),
            "food": Part(food(False), collision="none"),
            "food_rotten": Part(food(True), collision="none"),
        },
        variants={"default": ["body", "food"], "rotten": ["body", "food_rotten"]},
        states=[{"state": "EXPIRED", "variants": ["rotten"], "parts": ["food_rotten"]}],
    )


def opened_box(
    width: float, length: float, height: float, tub: Material, lid: str, o
) -> list[Mesh]:
    """The clip-lid box found open: its lid leans on it, grey mould over what was stew."""
    level = height - 0.018
    walls = shell(width, length, height, tub, level - 0.002)
    spots = food_spots(width, length, level + 0.008)
    stew = foods_aged(
        lambda m: m.mix(m.remap(m.noise(60, 3, offset=o), 0.38, 0.62), "8a4a1c", "b8702c"),
        True,
        spots,
        o,
        0.04,
    )
    rings = []
    for k, rise in ((1.0, 0.0), (0.7, 0.005), (0.25, 0.007)):
        rings.append(
            superellipse((width - 0.016) / 2 * k, (length - 0.016) / 2 * k, 5, 20, level + rise)
        )
    mound = loft(rings, mat=stew, caps=(False, True))
    mound.bake_uv = None
    if mound.signed_volume() < 0:
        mound.flip()
    colour = plain(lid, 0.03)
    outline = rounded_rectangle(width + 0.004, length + 0.004, 0.024, 4)
    levels = [(1.0, 0), (1.0, 0.008), (0.97, 0.01)]
    top = loft([np.c_[outline * k, np.full(len(outline), z)] for k, z in levels], mat=colour)
    top.turn(ry=-1.0)
    top.move(z=-top.v[:, 2].min()).move(x=-width / 2 - np.ptp(top.v[:, 0]) * 0.4)
    return [walls, mound, top]


def leftovers_box(
    dish="pasta", length=0.18, width=0.13, height=0.06, plastic="#cfe3ee", lid="#3f7fc0", seed=0
) -> Model:
    rng = np.random.default_rng(seed)
    o = noise_offset(rng)
    solid = [box_piece((0, 0, height / 2), (width - 0.006, length - 0.006, height))]
    tub = plain(plastic, 0.03)
    level = height - 0.022
    if dish == "closed":
        fresh = closed_box(width, length, height, tub, lid, rng)
        return Model(
            title="box of leftovers with a lid",
            mass=0.6,
            friction=0.5,
            parts={
                "body": Part(fresh, collision=solid),
                "body_rotten": Part(
                    opened_box(width, length, height, tub, lid, o), collision=solid
                ),
            },
            variants={"default": ["body"], "rotten": ["body_rotten"]},
            states=SPOILED,
        )
    if dish in DISHES:
        return served_box(dish, plastic, lid, seed)
    spots = [
        (width * 0.2, length * 0.22, level + 0.012),
        (-width * 0.18, -length * 0.02, level + 0.012),
        (width * 0.16, -length * 0.26, level + 0.012),
        (-width * 0.24, length * 0.3, level + 0.01),
    ]

    def aged_colour(m: Material, colour, rotten: bool) -> Material:
        if rotten:
            colour = mouldy(m, m.mix(0.6, colour, "5a4a2c"), spots, 0.034, o)
        return m.colour(colour)

    def food(rotten: bool) -> list[Mesh]:
        sauce = Material(occlusion=0.8)
        if dish == "pasta":
            c = sauce.mix(sauce.remap(sauce.noise(45, 3, offset=o), 0.4, 0.6), "b8301c", "d85a2c")
            c = sauce.mix(sauce.remap(sauce.voronoi(90, o), 0.1, 0.18, 0.8, 0), c, "3f7a24")
        else:
            c = sauce.mix(
                sauce.remap(sauce.voronoi(210, o, (1, 0.5, 1)), 0.1, 0.4), "cfbf98", "f6f0dc"
            )
        aged_colour(sauce, c, rotten)
        bumps = rng.uniform(0, 6.28, 3)
        rings = []
        for k, rise in ((1.0, 0.0), (0.85, 0.006), (0.55, 0.01), (0.2, 0.011)):
            ring = superellipse(
                (width - 0.018) / 2 * k, (length - 0.018) / 2 * k, 5, 20, level + rise
            )
            ring[:, 2] += (
                0.003
                * np.sin(ring[:, 0] * 120 + bumps[0])
                * np.sin(ring[:, 1] * 90 + bumps[1])
                * (k < 1)
            )
            rings.append(ring)
        mound = loft(rings, mat=sauce, caps=(False, True))
        if mound.signed_volume() < 0:
            mound.flip()
        mound.bake_uv = None
        pieces = [mound]
        draw = np.random.default_rng(seed + 1)  # the same pieces, fresh or not
        if dish == "pasta":
            noodle = Material(occlusion=0.8)
            tone = noodle.mottle("f0c860", 0.1, 90, o)
            smear = noodle.remap(noodle.noise(60, 3, offset=o), 0.5, 0.62, 0, 0.9)
            aged_colour(noodle, noodle.mix(smear, tone, "d8502c"), rotten)
            for _ in range(13):
                x, y = draw.uniform(-0.36, 0.36) * width, draw.uniform(-0.4, 0.4) * length
                a, tilt = draw.uniform(0, math.pi), draw.uniform(-0.25, 0.25)
                d = np.array([math.cos(a), math.sin(a), tilt]) * 0.017
                centre = np.array([x, y, level + 0.013 + draw.uniform(0, 0.003)])
                pieces.append(tube([centre - d, centre, centre + d], 0.0052, 6, mat=noodle))
            return pieces
        mats = []
        for colour in ("4f9a2c", "f08a1c", "c8482c"):
            m = Material(occlusion=0.8)
            mats.append(aged_colour(m, m.mottle(colour, 0.1, 120, o), rotten))
        for i in range(26):
            x, y = draw.uniform(-0.38, 0.38) * width, draw.uniform(-0.4, 0.4) * length
            side = draw.uniform(0.009, 0.014)
            cube = box(side, side, side * 0.7, (0, 0, 0), mats[i % 3])
            cube.turn(
                0.3 * draw.standard_normal(), 0.3 * draw.standard_normal(), draw.uniform(0, 3)
            )
            pieces.append(cube.move(x, y, level + 0.007))
        return pieces

    return Model(
        title=f"open box of leftover {'pasta' if dish == 'pasta' else 'rice and vegetables'}",
        mass=0.55,
        friction=0.5,
        parts={
            "body": Part([shell(width, length, height, tub, level - 0.002)], collision=solid),
            "food": Part(food(False), collision="none"),
            "food_rotten": Part(food(True), collision="none"),
        },
        variants={"default": ["body", "food"], "rotten": ["body", "food_rotten"]},
        states=[{"state": "EXPIRED", "variants": ["rotten"], "parts": ["food_rotten"]}],
    )


def closed_box(
    width: float, length: float, height: float, tub: Material, lid: str, rng
) -> list[Mesh]:
    """The box with a clip lid, and a strip of tape that says what is inside."""
    walls = shell(width, length, height, tub, height - 0.01)
    colour = plain(lid, 0.03)
    outline = rounded_rectangle(width + 0.004, length + 0.004, 0.024, 4)
    rings = [(1.0, height - 0.004), (1.0, height + 0.004), (0.97, height + 0.006)]
    top = loft([np.c_[outline * k, np.full(len(outline), z)] for k, z in rings], mat=colour)
    clips = [
        box(0.005, 0.034, 0.016, (s * (width / 2 + 0.003), 0, height - 0.012), colour, 0.001)
        for s in (-1, 1)
    ]
    image, d = labels.canvas(300, 110, "#f4ecd2")
    labels.text(d, "LEFTOVERS", (10, 10, 290, 66), "bold", "#1c2a5a")
    labels.text(d, "eat by Friday", (50, 70, 250, 104), "italic", "#1c2a5a")
    size = (0.05, min(0.13, length * 0.75))
    tape = box(
        *size,
        0.0012,
        (0, 0, height + 0.0055),
        plain("f4ecd2", 0),
        labels={"+z": label(image)},
        weight=1.8,
    )
    return [walls, top, *clips, tape]


def leftovers_box_random(rng: np.random.Generator) -> dict:
    return {
        "length": uniform(rng, 0.165, 0.19),
        "width": uniform(rng, 0.12, 0.135),
        "height": uniform(rng, 0.055, 0.068),
        "plastic": pick(rng, ["#cfe3ee", "#dfe8e2", "#c4dcc8"]),
        "lid": pick(rng, ["#3f7fc0", "#c8483c", "#3f9a5a"]),
        "seed": seed_of(rng),
    }


MODELS = {
    "leftovers_box": Maker(
        leftovers_box,
        leftovers_box_random,
        count=8,
        presets=[
            {"dish": "rice"},
            {"dish": "closed"},
            {"dish": "pasta"},
            {"dish": "curry", "plastic": "#e4e8ea", "lid": "#3f9a5a"},
            {"dish": "salad", "plastic": "#d4e4ec", "lid": "#c8483c"},
            {"dish": "pizza", "plastic": "#c0c8d4"},
            {"dish": "dinner", "plastic": "#3a3f46"},
            {"dish": "soup", "plastic": "#e8e4d4", "lid": "#e8a02c"},
        ],
    ),
}
