"""Leftovers in plastic boxes: open, with what is in them fresh or mouldy, or shut with a lid."""

from __future__ import annotations

import math

import numpy as np
from toolkit import labels
from toolkit.materials import Material, label, plain
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part, box_piece
from toolkit.sampling import noise_offset, pick, seed_of, uniform
from toolkit.shapes import box, loft, rounded_rectangle, superellipse, tube

from makers.bakery import mouldy


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


def leftovers_box(
    dish="pasta", length=0.18, width=0.13, height=0.06, plastic="#cfe3ee", lid="#3f7fc0", seed=0
) -> Model:
    rng = np.random.default_rng(seed)
    o = noise_offset(rng)
    solid = [box_piece((0, 0, height / 2), (width - 0.006, length - 0.006, height))]
    tub = plain(plastic, 0.03)
    level = height - 0.022
    if dish == "closed":
        parts = {"body": Part(closed_box(width, length, height, tub, lid, rng), collision=solid)}
        return Model(title="box of leftovers with a lid", parts=parts, mass=0.6, friction=0.5)
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
            for _ in range(15):
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
        count=2,
        presets=[{"dish": "rice"}, {"dish": "closed"}],
    ),
}
