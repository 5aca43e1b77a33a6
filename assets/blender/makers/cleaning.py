"""Cleaning things: trigger bottle, bleach, washing-up liquid, bucket, dustpan with brush."""

from __future__ import annotations

import math

import numpy as np
from labels import bottles
from makers.projection import project_label
from toolkit.materials import metal, plain
from toolkit.materials import label as printed
from toolkit.mesh import Mesh
from toolkit.model import Container, Maker, Model, Part, box_piece, cylinder_piece, ring_pieces
from toolkit.sampling import pick, uniform
from toolkit.shapes import box, extrude, lathe, loft, spline, superellipse, tube


def oval_body(
    profile: list[tuple[float, float, float]], width: float, depth: float, mat, power: float = 2.8, n: int = 18
) -> Mesh:
    """A bottle with an oval section, wide along y. profile: (z, width factor, depth factor)."""
    rings = [superellipse(depth / 2 * d, width / 2 * w, power, n, z) for z, w, d in profile]
    return loft(rings, mat=mat)


def cap(radius: float, z: float, height: float, mat, n: int = 16, taper: float = 0.94) -> Mesh:
    """A ribbed screw cap."""
    profile = [(0, z), (radius, z), (radius * taper, z + height * 0.9), (radius * taper * 0.86, z + height)]
    profile.append((0, z + height))
    return lathe(profile, n, mat=mat, rib=lambda k, i: 1 - 0.06 * (i % 2) if k in (1, 2) else 1)


def spray_cleaner(
    height: float, width: float, body: str, paper: str, band: str, accent: str, ink: str, head: str, trigger: str,
    brand: str, kind: str,
) -> Model:  # fmt: skip
    """A trigger bottle: label on both broad faces, the nozzle to the left of the label."""
    s = height / 0.26
    plastic = plain(body, 0.03)
    label = printed(
        bottles.cleaner_label(brand, kind, paper, band, accent, ink), base=body
    )
    steps = [
        (0, 0.9, 0.88), (0.004, 1, 1), (0.075, 1, 1), (0.105, 0.96, 0.95), (0.13, 0.85, 0.86),
        (0.15, 0.68, 0.72), (0.164, 0.45, 0.58), (0.172, 0.32, 0.54), (0.185, 0.3, 0.52),
    ]  # fmt: skip
    bottle = oval_body([(z * s, w, d) for z, w, d in steps], width, 0.056, plastic, 3.0).weigh(1.2)
    for side in ("+x", "-x"):
        project_label(
            bottle, label, side, (0, 0.072 * s), (width * 0.86, 0.125 * s), 0.3,
            lambda c: 0.004 * s < c[2] < 0.14 * s and abs(c[1]) < 0.42 * width,
        )  # fmt: skip
    neck = 0.185 * s
    white, red = plain(head, 0.02), plain(trigger, 0.02)
    collar = lathe(
        [(0, neck - 0.012), (0.0175, neck - 0.012), (0.0165, neck + 0.014), (0.0, neck + 0.016)], 14, mat=white,
        rib=lambda k, i: 1 - 0.07 * (i % 2) if k == 1 else 1,
    )  # fmt: skip
    outline = [
        (-0.016, 0.012), (0.012, 0.012), (0.02, 0.034), (0.052, 0.036), (0.052, 0.056), (0.044, 0.061),
        (0, 0.063), (-0.03, 0.058), (-0.042, 0.048), (-0.036, 0.038), (-0.02, 0.03),
    ]  # fmt: skip
    hood = extrude(outline, 0.026, mat=white, axis="y", bevel_width=0.004).move(z=neck)
    nozzle = box(0.013, 0.019, 0.019, (0.057, 0, neck + 0.0385), red, bevel_width=0.002)
    lever_outline = [
        (0.022, 0.036), (0.036, 0.036), (0.041, 0.024), (0.038, 0.01), (0.044, -0.006), (0.056, -0.02),
        (0.05, -0.025), (0.038, -0.012), (0.03, 0.004),
    ]  # fmt: skip
    lever = extrude(lever_outline, 0.014, mat=red, axis="y", bevel_width=0.002).move(z=neck)
    for mesh in (hood, nozzle, lever):
        mesh.turn(rz=-math.pi / 2)  # the nozzle points along -y, the label faces +x
    pieces = [
        box_piece((0, 0, 0.065 * s), (0.054, width * 0.96, 0.13 * s)),
        box_piece((0, 0, 0.157 * s), (0.036, width * 0.55, 0.056 * s)),
        box_piece((0, -0.01, neck + 0.04), (0.026, 0.1, 0.046)),
    ]
    part = Part([bottle, collar, hood, nozzle, lever], collision=pieces)
    return Model(f"trigger bottle of {kind.lower()}", {"body": part}, mass=0.55, friction=0.5)


def spray_cleaner_random(rng: np.random.Generator) -> dict:
    body, paper, accent, ink = pick(
        rng,
        [
            ("#2f7fd8", "#dff0ff", "#1f5fc4", "#16305c"), ("#f4f4f2", "#d8f0fb", "#1b9ad6", "#0c4a6a"),
            ("#f0d21e", "#f7ffe8", "#2d9a48", "#14622a"), ("#e9e4f4", "#f6eefc", "#7b3fb5", "#3a1a5c"),
        ],
    )  # fmt: skip
    return {
        "height": uniform(rng, 0.235, 0.28), "width": uniform(rng, 0.085, 0.1), "body": body, "paper": paper,
        "accent": accent, "ink": ink, "band": pick(rng, ["#d4202c", "#143a8c", "#e2661a"]),
        "head": pick(rng, ["#f5f5f5", "#d8262e", "#1f4fa8"]), "trigger": pick(rng, ["#d8262e", "#f08a1c", "#2f9a48"]),
        "brand": pick(rng, ["BRIZZO", "Klarenta", "SPLAZH", "Zappli"]),
        "kind": pick(rng, ["GLASS CLEANER", "MULTI SURFACE", "BATHROOM", "KITCHEN"]),
    }  # fmt: skip


def bleach_bottle(height: float, body: str, band: str, accent: str, lid: str, brand: str) -> Model:
    """A bottle with a moulded handle hole's loop at its side and a big ribbed cap."""
    s = height / 0.27
    plastic = plain(body, 0.03)
    label = printed(bottles.bleach_label(brand, "#ffffff", band, accent), base=body)
    steps = [
        (0, 0.88, 0.86), (0.005, 1, 1), (0.135, 1, 1), (0.16, 0.94, 0.92), (0.185, 0.72, 0.76),
        (0.21, 0.42, 0.56), (0.225, 0.3, 0.44), (0.24, 0.3, 0.44),
    ]  # fmt: skip
    bottle = oval_body([(z * s, w, d) for z, w, d in steps], 0.105, 0.07, plastic, 3.4).weigh(1.2)
    for side in ("+x", "-x"):
        project_label(
            bottle, label, side, (0, 0.075 * s), (0.09, 0.125 * s), 0.3,
            lambda c: 0.004 * s < c[2] < 0.15 * s and abs(c[1]) < 0.046,
        )  # fmt: skip
    handle = tube(
        spline([(0, 0.034, 0.205 * s), (0, 0.052, 0.2 * s), (0, 0.057, 0.17 * s), (0, 0.05, 0.145 * s)], 3),
        0.0085, 8, mat=plastic, up=(1, 0, 0),
    )  # fmt: skip
    lid_mesh = cap(0.021, 0.233 * s, 0.037 * s, plain(lid, 0.02))
    pieces = [
        box_piece((0, 0, 0.085 * s), (0.068, 0.103, 0.17 * s)),
        cylinder_piece(0.038, 0.17 * s, 0.23 * s, 10, 0.022),
        cylinder_piece(0.02, 0.23 * s, 0.27 * s, 10),
    ]
    part = Part([bottle, handle, lid_mesh], collision=pieces)
    return Model("bottle of bleach", {"body": part}, mass=1.05, friction=0.5)


def bleach_bottle_random(rng: np.random.Generator) -> dict:
    body, band, lid = pick(
        rng, [("#f6f6f2", "#1f4fa8", "#1f4fa8"), ("#f2cf2a", "#c4202c", "#c4202c"), ("#2a62b8", "#16305c", "#f5f5f5")]
    )
    return {
        "height": uniform(rng, 0.25, 0.29), "body": body, "band": band, "accent": pick(rng, ["#c4202c", "#1c1c20"]),
        "lid": lid, "brand": pick(rng, ["Blanqo", "Javelin", "Purexa"]),
    }  # fmt: skip


def dish_soap(height: float, liquid: str, band: str, fruit: str, lid: str, brand: str) -> Model:
    """A waisted bottle of coloured washing-up liquid with a push-pull cap."""
    s = height / 0.23
    liquid_mat = plain(liquid, 0.04, 30)
    label = printed(bottles.dish_soap_label(brand, "#fbfce8", band, fruit), base=liquid)
    steps = [
        (0, 0.86, 0.84), (0.005, 1, 1), (0.05, 0.97, 0.98), (0.09, 0.86, 0.92), (0.125, 0.9, 0.94),
        (0.155, 0.82, 0.86), (0.175, 0.5, 0.6), (0.186, 0.36, 0.46),
    ]  # fmt: skip
    bottle = oval_body([(z * s, w, d) for z, w, d in steps], 0.078, 0.046, liquid_mat, 2.6).weigh(1.2)
    for side in ("+x", "-x"):
        project_label(
            bottle, label, side, (0, 0.08 * s), (0.066, 0.13 * s), 0.3,
            lambda c: 0.004 * s < c[2] < 0.16 * s and abs(c[1]) < 0.036,
        )  # fmt: skip
    top = plain(lid, 0.02)
    z = 0.183 * s
    spout = lathe(
        [(0, z), (0.016, z), (0.0155, z + 0.014), (0.009, z + 0.018), (0.0085, z + 0.032), (0.011, z + 0.034),
         (0.0105, z + 0.041), (0, z + 0.043)],
        14, mat=top,
    )  # fmt: skip
    pieces = [
        box_piece((0, 0, 0.08 * s), (0.042, 0.07, 0.16 * s)),
        cylinder_piece(0.016, 0.16 * s, z + 0.043, 10, 0.01),
    ]
    part = Part([bottle, spout], collision=pieces)
    return Model("washing-up liquid", {"body": part}, mass=0.52, friction=0.5)


def dish_soap_random(rng: np.random.Generator) -> dict:
    liquid, band, fruit = pick(
        rng, [("#8fc83a", "#2c8f4a", "#c8d838"), ("#f2c52a", "#e2762a", "#f2d23a"), ("#3aa0d8", "#1f5fa8", "#f08a3c")]
    )
    return {
        "height": uniform(rng, 0.21, 0.25), "liquid": liquid, "band": band, "fruit": fruit,
        "lid": pick(rng, ["#f5f5f5", "#e2402c", "#1f5fa8"]), "brand": pick(rng, ["Plinka", "Tellora", "Glanzy"]),
    }  # fmt: skip


def bucket(radius: float, height: float, colour: str, metal_body: bool, bail_down: bool) -> Model:
    """A tapered bucket; its wire handle hangs at one side or stands up."""
    body = metal("c4c9cd", "7d858b") if metal_body else plain(colour, 0.04)
    inner = plain("#a9afb3" if metal_body else colour, 0.05)
    foot, wall = radius * 0.76, 0.006
    profile = [
        (0, 0.004), (foot * 0.93, 0.004), (foot, 0), (radius * 0.965, height - 0.026), (radius + 0.005, height - 0.024),
        (radius + 0.006, height - 0.004), (radius, height), (radius - wall, height), (foot - wall, 0.012), (0, 0.012),
    ]  # fmt: skip
    shell = lathe(profile, 28, mats=[body, inner], mat_of_segment=[0] * 7 + [1, 1]).weigh(1.2)
    wire = metal("b4b9bd", "6a7075")
    swing = -0.12 if bail_down else math.pi / 2
    reach = radius + 0.008
    arc = []
    for t in np.linspace(0, math.pi, 15):
        along, out = reach * math.cos(t), reach * math.sin(t)
        arc.append((out * math.cos(swing), along, height - 0.02 + out * math.sin(swing)))
    bail = tube(arc, 0.0035, 6, mat=wire, weight=0.7)
    grip_span = [p for p in arc if abs(p[1]) < 0.42 * reach]
    grip = tube(grip_span, 0.0085, 8, mat=plain("#2c2c2e" if metal_body else "#f2f2f0", 0.05), weight=0.8)
    ears = [
        box(0.022, 0.01, 0.026, (0, s * (radius + 0.004), height - 0.034), body, bevel_width=0.003) for s in (-1, 1)
    ]
    pieces = [
        cylinder_piece(foot, 0, 0.014, 14),
        *ring_pieces([(foot, 0), (radius, height)], [(foot - wall, 0.008), (radius - wall, height)], 12),
    ]
    side = 2 * 0.68 * foot
    inside = Container("inside", (0, 0, 0.014 + (height - 0.02) / 2), (side, side, height - 0.02))
    part = Part([shell, bail, grip, *ears], collision=pieces)
    return Model(
        "zinc bucket" if metal_body else "plastic bucket", {"body": part}, mass=0.9 if metal_body else 0.45,
        containers=[inside], texture_size=128, ground_shadow=True,
    )  # fmt: skip


def bucket_random(rng: np.random.Generator) -> dict:
    return {
        "radius": uniform(rng, 0.13, 0.15), "height": uniform(rng, 0.25, 0.29), "metal_body": False,
        "colour": pick(rng, ["#d8303a", "#2f6fc0", "#e8b92c", "#3a9a5a"]), "bail_down": True,
    }  # fmt: skip


def broom_dustpan(colour: str, bristle: str, width: float) -> Model:
    """A dustpan with a hand brush lying in it."""
    pan_mat = plain(colour, 0.04)
    length = 0.22
    floor = [(-0.11, 0.004), (0.11, 0.0), (0.11, 0.006), (-0.11, 0.012)]
    base = extrude(floor, width, mat=pan_mat, axis="y")
    back = box(0.008, width, 0.055, (-length / 2 + 0.004, 0, 0.002), pan_mat, bevel_width=0.002)
    sides = []
    for s in (-1, 1):
        outline = [(-length / 2, 0.002), (length / 2, 0.001), (length / 2, 0.01), (-length / 2 + 0.02, 0.057), (-length / 2, 0.057)]
        sides.append(extrude(outline, 0.007, mat=pan_mat, axis="y", bevel_width=0.001).move(y=s * (width / 2 - 0.0035)))
    handle = tube(
        [(-length / 2, 0, 0.045), (-length / 2 - 0.05, 0, 0.04), (-length / 2 - 0.12, 0, 0.026)],
        [0.012, 0.011, 0.014], 8, mat=pan_mat, up=(0, 1, 0),
    )  # fmt: skip
    brush_mat, hair = plain(colour, 0.04), plain(bristle, 0.25, 400)
    block = box(0.135, 0.032, 0.02, (0.02, 0, 0), brush_mat, bevel_width=0.006)
    tuft = box(0.13, 0.04, 0.036, (0.02, 0, -0.035), hair, bevel_width=0.004)
    grip = tube(
        spline([(-0.04, 0, 0.01), (-0.09, 0, 0.014), (-0.16, 0, 0.016)], 3),
        np.interp(np.linspace(0, 1, 7), [0, 0.5, 1], [0.011, 0.009, 0.012]), 8, mat=brush_mat, up=(0, 1, 0),
    )  # fmt: skip
    brush = [block, tuft, grip]
    for mesh in brush:
        mesh.turn(rz=0.16).move(x=0.0, y=0.005, z=0.046)
    pieces = [
        box_piece((0, 0, 0.006), (length, width, 0.012)),
        box_piece((-length / 2 + 0.004, 0, 0.03), (0.008, width, 0.055)),
        box_piece((-0.02, 0, 0.05), (0.24, 0.07, 0.03)),
        box_piece((-length / 2 - 0.06, 0, 0.03), (0.14, 0.03, 0.03)),
    ]
    part = Part([base, back, *sides, handle, *brush], collision=pieces)
    return Model("dustpan with a hand brush", {"body": part}, mass=0.35, texture_size=128)


def broom_dustpan_random(rng: np.random.Generator) -> dict:
    return {
        "colour": pick(rng, ["#2f7fc0", "#c8303a", "#3a9a6a"]), "bristle": pick(rng, ["#e9e2cc", "#26262a"]),
        "width": uniform(rng, 0.21, 0.24),
    }  # fmt: skip


MODELS = {
    "spray_cleaner": Maker(
        spray_cleaner, spray_cleaner_random, 3,
        [{"body": "#2f7fd8", "paper": "#dff0ff", "accent": "#1f5fc4", "ink": "#16305c", "brand": "BRIZZO"},
         {"body": "#f0d21e", "paper": "#f7ffe8", "accent": "#2d9a48", "ink": "#14622a", "brand": "Zappli"}],
    ),
    "bleach_bottle": Maker(
        bleach_bottle, bleach_bottle_random, 3,
        [{"body": "#f6f6f2", "band": "#1f4fa8", "lid": "#1f4fa8"}, {"body": "#f2cf2a", "band": "#c4202c", "lid": "#c4202c"}],
    ),
    "dish_soap": Maker(
        dish_soap, dish_soap_random, 3,
        [{"liquid": "#8fc83a", "band": "#2c8f4a", "fruit": "#c8d838"}, {"liquid": "#f2c52a", "band": "#e2762a", "fruit": "#f2d23a"},
         {"liquid": "#3aa0d8", "band": "#1f5fa8", "fruit": "#f08a3c"}],
    ),
    "bucket": Maker(bucket, bucket_random, 3, [{"colour": "#2f6fc0"}, {"metal_body": True}, {"bail_down": False}]),
    "broom_dustpan": Maker(broom_dustpan, broom_dustpan_random, 2),
}  # fmt: skip
