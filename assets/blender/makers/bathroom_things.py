"""Toiletries: toilet paper, toothbrush cup, soap dispenser, shampoo, hairbrush, perfume."""

from __future__ import annotations

import math

import numpy as np
from labels import bottles
from makers.cleaning import oval_body
from makers.projection import project_label
from toolkit.materials import Material, metal, plain, shade
from toolkit.materials import label as printed
from toolkit.model import Maker, Model, Part, box_piece, cylinder_piece, ring_pieces
from toolkit.sampling import noise_offset, pick, seed_of, uniform
from toolkit.shapes import TAU, box, ellipsoid, extrude, lathe, loft, rounded_rectangle, spline, superellipse, tube


def toilet_paper(radius: float, pattern: bool, tail: bool, seed: int) -> Model:
    """A standing roll with its cardboard core and, if wanted, a loose end."""
    rng = np.random.default_rng(seed)
    height, core = 0.1, 0.021
    paper = Material()
    base = paper.mottle("#f5f3ee", 0.03, 120, noise_offset(rng))
    dots = paper.voronoi(90, noise_offset(rng), randomness=0.2)
    paper.colour(paper.mix(paper.remap(dots, 0.1, 0.35, 0.16 if pattern else 0.05, 0), base, "b9b4ac"))
    ends = Material()
    rings = ends.math("SINE", ends.math("MULTIPLY", ends.distance((0, 0, height), (1, 1, 0)), 1500))
    ends.colour(ends.mix(ends.remap(rings, -1, 1, 0, 0.22), "f5f3ee", "a9a49a"))
    card = plain("#b08a5e", 0.08, 200)
    profile = [
        (core, 0.001), (radius - 0.003, 0), (radius, 0.003), (radius, height - 0.003), (radius - 0.003, height),
        (core, height - 0.001), (core - 0.002, height - 0.0005), (core - 0.002, 0.0005), (core, 0.001),
    ]  # fmt: skip
    roll = lathe(profile, 26, mats=[paper, ends, card], mat_of_segment=[1, 0, 0, 0, 1, 2, 2, 2])
    meshes = [roll]
    if tail:
        points = [(radius - 0.004, -0.03), (radius + 0.002, 0.0), (radius + 0.006, 0.03), (radius + 0.02, 0.06)]
        curve = spline(points, 3)
        outline = np.r_[curve, curve[::-1] + [0.005, 0.0]]
        meshes.append(extrude(outline, height - 0.004, mat=paper).move(z=0.002))
    pieces = [cylinder_piece(radius, 0, height, 16)]
    return Model("roll of toilet paper", {"body": Part(meshes, collision=pieces)}, mass=0.12, friction=0.7, texture_size=128)


def toilet_paper_random(rng: np.random.Generator) -> dict:
    return {"radius": uniform(rng, 0.05, 0.06), "pattern": True, "tail": False, "seed": seed_of(rng)}


def toothbrush_cup(cup: str, first: str, second: str, paste: str, height: float) -> Model:
    """A cup with two toothbrushes and a tube of toothpaste standing in it."""
    r, wall = 0.037, 0.0045
    ceramic, inner = plain(cup, 0.04), plain(shade(cup, 0.9), 0.03)
    profile = [
        (0, 0.002), (r * 0.84, 0.0), (r * 0.9, 0.003), (r, height - 0.002), (r - wall / 2, height),
        (r - wall, height - 0.002), (r * 0.9 - wall, 0.008), (0, 0.007),
    ]  # fmt: skip
    vessel = lathe(profile, 20, mats=[ceramic, inner], mat_of_segment=[0] * 5 + [1, 1])
    meshes = [vessel]
    hair = plain("#f4f6f8", 0.05)
    for colour, lean, turn in ((first, 0.2, 0.5), (second, -0.17, 2.5)):
        stick = extrude(
            [(-0.0045, 0), (0.0045, 0), (0.006, 0.06), (0.0035, 0.12), (0.0042, 0.15), (0.0065, 0.16), (0.0065, 0.185),
             (-0.0065, 0.185), (-0.0065, 0.16), (-0.0042, 0.15), (-0.0035, 0.12), (-0.006, 0.06)],
            0.0062, mat=plain(colour, 0.03), axis="y", bevel_width=0.0012,
        )  # fmt: skip
        bristles = box(0.0115, 0.012, 0.026, (0, -0.009, 0.158), hair)
        tip = box(0.0118, 0.003, 0.009, (0, -0.0145, 0.158), plain(colour, 0.03))
        for mesh in (stick, bristles, tip):
            mesh.turn(rz=turn).turn(ry=lean).move(-math.sin(lean) * 0.06, 0.004 * lean, 0.01)
            meshes.append(mesh)
    tube_mat, lid = plain(paste, 0.02), plain("#f7f7f5", 0.02)
    rings = [superellipse(0.017 * a, 0.017 * b, 2, 12, z) for z, a, b in ((0.02, 0.8, 0.8), (0.05, 1, 1), (0.1, 1.1, 0.7), (0.165, 1.28, 0.12))]
    squeeze = loft(rings, mat=tube_mat)
    band = loft([superellipse(0.0175 * a, 0.0175 * b, 2, 12, z) for z, a, b in ((0.09, 1.09, 0.78), (0.125, 1.18, 0.5))], mat=plain("#f2f4f6", 0.0))
    for mesh in (squeeze, band):
        meshes.append(mesh.turn(rz=1.2).turn(rx=0.14).move(0.002, 0.012, 0))
    meshes.append(lathe([(0, 0.008), (0.011, 0.008), (0.012, 0.022), (0, 0.022)], 10, mat=lid).move(0, 0.012, 0))
    pieces = [
        cylinder_piece(r * 0.9, 0, 0.01, 12),
        *ring_pieces([(r * 0.9, 0), (r, height)], [(r * 0.9 - wall, 0.008), (r - wall, height)], 8),
        box_piece((0, 0.006, 0.1), (0.03, 0.03, 0.13)),
    ]
    return Model("cup with toothbrushes and toothpaste", {"body": Part(meshes, collision=pieces)}, mass=0.32)


def toothbrush_cup_random(rng: np.random.Generator) -> dict:
    first, second = pick(rng, [("#d8303a", "#2f7fd8"), ("#2f9a5a", "#e8862c"), ("#8a4fc0", "#1fa8b0")])
    return {
        "cup": pick(rng, ["#f4f3ee", "#8fc3cf", "#3a5a78"]), "first": first, "second": second,
        "paste": pick(rng, ["#1f8fd0", "#2fa07a", "#d8303a"]), "height": uniform(rng, 0.095, 0.11),
    }  # fmt: skip


def soap_dispenser(round_body: bool, height: float, body: str, accent: str, ink: str, pump: str, brand: str) -> Model:
    """A pump bottle of hand soap."""
    s = height / 0.17
    colour = plain(body, 0.03)
    picture = bottles.soap_label(brand, "hand soap", "#ffffff", ink, accent)
    label = printed(picture, base=body)
    if round_body:
        profile = [(0, 0.001), (0.031, 0), (0.034, 0.003), (0.034, 0.095 * s), (0.03, 0.105 * s), (0.014, 0.114 * s), (0.014, 0.12 * s)]
        bottle = lathe(profile, 22, mat=colour, start=-TAU / 2)
        width, pieces = 0.06, [cylinder_piece(0.034, 0, 0.1 * s, 14), cylinder_piece(0.014, 0.1 * s, 0.15 * s, 8)]
    else:
        steps = [(0, 0.94, 0.92), (0.003, 1, 1), (0.09, 1, 1), (0.104, 0.9, 0.88), (0.114, 0.36, 0.6), (0.12, 0.34, 0.56)]
        bottle = oval_body([(z * s, w, d) for z, w, d in steps], 0.078, 0.05, colour, 3.2)
        width, pieces = 0.064, [box_piece((0, 0, 0.052 * s), (0.05, 0.078, 0.104 * s)), cylinder_piece(0.014, 0.1 * s, 0.15 * s, 8)]
    project_label(bottle, label, "+x", (0, 0.05 * s), (width, 0.084 * s), 0.3, lambda c: 0.003 < c[2] < 0.1 * s)
    plastic = plain(pump, 0.02)
    z = 0.118 * s
    neck = lathe(
        [(0, z - 0.004), (0.0165, z - 0.004), (0.016, z + 0.012), (0.0065, z + 0.014), (0.0055, z + 0.036), (0, z + 0.036)],
        14, mat=plastic,
    )  # fmt: skip
    head = lathe([(0, z + 0.034), (0.012, z + 0.034), (0.0135, z + 0.046), (0.01, z + 0.05), (0, z + 0.05)], 14, mat=plastic)
    path = spline([(0, 0, z + 0.043), (0.025, 0, z + 0.044), (0.038, 0, z + 0.041), (0.043, 0, z + 0.032)], 3)
    spout = tube(path, np.linspace(0.0062, 0.0042, len(path)), 8, mat=plastic)
    pieces.append(box_piece((0.016, 0, z + 0.04), (0.058, 0.022, 0.02)))
    part = Part([bottle.weigh(1.3), neck, head, spout], collision=pieces)
    return Model("hand soap dispenser", {"body": part}, mass=0.34, friction=0.5)


def soap_dispenser_random(rng: np.random.Generator) -> dict:
    return {
        "round_body": True, "height": uniform(rng, 0.155, 0.185), "body": pick(rng, ["#e7f0ea", "#f2d9de", "#cfe6ef"]),
        "accent": pick(rng, ["#d9708c", "#f08a3c", "#8a6ad0"]), "ink": pick(rng, ["#2a5a5a", "#3a2a5c"]),
        "pump": pick(rng, ["#f7f7f5", "#2a2c30"]), "brand": pick(rng, ["Albina", "Lavara", "Senta"]),
    }  # fmt: skip


def shampoo_bottle(height: float, body: str, paper: str, ink: str, accent: str, lid: str, brand: str, kind: str) -> Model:
    """An oval bottle with a wide flip cap."""
    s = height / 0.22
    colour = plain(body, 0.03, 40)
    label = printed(bottles.shampoo_label(brand, kind, paper, ink, accent), base=body)
    steps = [(0, 0.9, 0.88), (0.004, 1, 1), (0.1, 1.0, 1.0), (0.15, 0.93, 0.95), (0.172, 0.76, 0.82), (0.18, 0.64, 0.76)]
    bottle = oval_body([(z * s, w, d) for z, w, d in steps], 0.074, 0.043, colour, 2.5).weigh(1.2)
    for side in ("+x", "-x"):
        project_label(
            bottle, label, side, (0, 0.08 * s), (0.062, 0.14 * s), 0.3,
            lambda c: 0.004 < c[2] < 0.165 * s and abs(c[1]) < 0.035,
        )  # fmt: skip
    rings = [(0.178, 0.66, 0.8), (0.179, 0.72, 0.86), (0.212, 0.68, 0.8), (0.218, 0.6, 0.7)]
    lid_mat = plain(lid, 0.03)
    top = oval_body([(z * s, w, d) for z, w, d in rings], 0.074, 0.043, lid_mat, 2.5)
    seam = oval_body([(0.206 * s, 0.715, 0.855), (0.2075 * s, 0.715, 0.855)], 0.074, 0.043, plain(shade(lid, 0.7), 0))
    pieces = [box_piece((0, 0, 0.09 * s), (0.041, 0.072, 0.18 * s)), box_piece((0, 0, 0.2 * s), (0.034, 0.05, 0.038 * s))]
    part = Part([bottle, top, seam], collision=pieces)
    return Model("shampoo bottle", {"body": part}, mass=0.33, friction=0.5)


def shampoo_bottle_random(rng: np.random.Generator) -> dict:
    body, paper, ink, accent, lid = pick(
        rng,
        [
            ("#e8d3c2", "#fbf4ee", "#5a2c50", "#c98a5a", "#5a2c50"), ("#2f8f7a", "#e9f6ef", "#12473c", "#2f8f7a", "#f4f4f0"),
            ("#3a5fb0", "#eaf0fb", "#1c2f66", "#e8a33a", "#26282e"),
        ],
    )  # fmt: skip
    return {
        "height": uniform(rng, 0.2, 0.24), "body": body, "paper": paper, "ink": ink, "accent": accent, "lid": lid,
        "brand": pick(rng, ["Silvane", "Orelia", "Hairo"]), "kind": pick(rng, ["repair & shine", "daily care", "volume"]),
    }  # fmt: skip


def hairbrush(wooden: bool, colour: str, pad: str, length: float) -> Model:
    """A paddle brush on its back, bristles up."""
    s = length / 0.24
    handle_mat = plain(colour, 0.08 if wooden else 0.03, 60)
    outline = spline(
        [(0.12, 0), (0.105, 0.028), (0.065, 0.036), (0.02, 0.026), (-0.01, 0.011), (-0.06, 0.009), (-0.105, 0.0125),
         (-0.12, 0), (-0.105, -0.0125), (-0.06, -0.009), (-0.01, -0.011), (0.02, -0.026), (0.065, -0.036), (0.105, -0.028)],
        2, closed=True,
    ) * s  # fmt: skip
    body = extrude(outline, 0.014 * s, mat=handle_mat, bevel_width=0.004)
    cushion = ellipsoid((0.046 * s, 0.028 * s, 0.009 * s), (0.065 * s, 0, 0.013 * s), 16, 6, plain(pad, 0.04))
    meshes = [body, cushion]
    pin_mat = plain("#2a2a2e" if pad != "#26262a" else "#d8d4cc", 0.0)
    for i in range(-3, 4):
        for j in range(-2, 3):
            x, y = 0.012 * i * s, (0.0105 * j + 0.005 * (i % 2)) * s
            if (x / 0.042) ** 2 + (y / 0.026) ** 2 > 1.05 * s * s:
                continue
            z = 0.019 * s
            pin = [(0.0017, z - 0.006), (0.0015, z + 0.013), (0, z + 0.015)]
            meshes.append(lathe(pin, 4, mat=pin_mat, weight=0.3).move(0.065 * s + x, y))
    pieces = [
        box_piece((0.065 * s, 0, 0.014 * s), (0.105 * s, 0.066 * s, 0.028 * s)),
        box_piece((-0.05 * s, 0, 0.007 * s), (0.14 * s, 0.022 * s, 0.014 * s)),
    ]
    return Model("hairbrush", {"body": Part(meshes, collision=pieces)}, mass=0.09, texture_size=128)


def hairbrush_random(rng: np.random.Generator) -> dict:
    return {
        "wooden": True, "colour": pick(rng, ["#b07a45", "#8a5a30"]), "pad": pick(rng, ["#c8453a", "#26262a"]),
        "length": uniform(rng, 0.22, 0.25),
    }  # fmt: skip


def perfume_bottle(square: bool, height: float, liquid: str, lid: str, ink: str, brand: str) -> Model:
    """A small thick-glass flask with tinted content and a bright cap."""
    s = height / 0.1
    glass = Material(occlusion=0.6)
    level = glass.ramp(
        glass.remap(glass.axis(2), 0, 0.07 * s),
        [(0, "e9f2f4"), (0.12, "f4fafb"), (0.16, liquid), (0.7, shade(liquid, 1.12)), (0.74, "eef5f7"), (1, "fbfdfe")],
    )
    glass.colour(level)
    label = printed(bottles.perfume_label(brand, ink), base=liquid)
    if square:
        outline = rounded_rectangle(0.03, 0.058, 0.006, 3)
        rings = [np.c_[outline * f, np.full(len(outline), z)] for z, f in ((0, 0.93), (0.003, 1), (0.062 * s, 1), (0.068 * s, 0.86))]
        flask = loft(rings, mat=glass)
    else:
        flask = lathe(
            [(0, 0), (0.024, 0), (0.028, 0.003), (0.033, 0.02 * s), (0.031, 0.042 * s), (0.018, 0.06 * s), (0.009, 0.066 * s), (0, 0.067 * s)],
            20, mat=glass, discs=False,
        )  # fmt: skip
    size = (0.048, 0.044 * s) if square else (0.046, 0.04 * s)
    project_label(flask, label, "+x", (0, 0.033 * s if square else 0.03 * s), size, 0.55, lambda c: 0.012 * s < c[2] < 0.055 * s)
    gold = metal("d8b45a", "8a6a24") if lid == "gold" else metal("c8ccd0", "7a8086")
    z = 0.067 * s
    top = lathe([(0, z - 0.002), (0.0085, z - 0.002), (0.0085, z + 0.006), (0.0125, z + 0.006), (0.0125, z + 0.03 * s), (0.011, z + 0.033 * s), (0, z + 0.033 * s)], 16, mat=gold)
    wide = (0.03, 0.058) if square else (0.058, 0.058)
    pieces = [box_piece((0, 0, 0.034 * s), (*wide, 0.068 * s)), cylinder_piece(0.0125, z, z + 0.033 * s, 8)]
    return Model("perfume bottle", {"body": Part([flask, top], collision=pieces)}, mass=0.18, friction=0.5)


def perfume_bottle_random(rng: np.random.Generator) -> dict:
    return {
        "square": True, "height": uniform(rng, 0.09, 0.11), "liquid": pick(rng, ["#e8b06a", "#e79ab0", "#9ac0e0"]),
        "lid": pick(rng, ["gold", "silver"]), "ink": pick(rng, ["#6a4a2a", "#3a3a4a"]),
        "brand": pick(rng, ["Lunaire", "Amara", "Nuvole"]),
    }  # fmt: skip


MODELS = {
    "toilet_paper": Maker(toilet_paper, toilet_paper_random, 2, [{"tail": True}, {"pattern": False}]),
    "toothbrush_cup": Maker(
        toothbrush_cup, toothbrush_cup_random, 2,
        [{"cup": "#f4f3ee", "first": "#d8303a", "second": "#2f7fd8", "paste": "#1f8fd0"}, {"cup": "#8fc3cf", "first": "#2f9a5a", "second": "#e8862c"}],
    ),
    "soap_dispenser": Maker(soap_dispenser, soap_dispenser_random, 3, [{}, {"round_body": False, "body": "#cfe6ef", "accent": "#f08a3c"}]),
    "shampoo_bottle": Maker(
        shampoo_bottle, shampoo_bottle_random, 3,
        [{}, {"body": "#2f8f7a", "paper": "#e9f6ef", "ink": "#12473c", "accent": "#2f8f7a", "lid": "#f4f4f0"},
         {"body": "#3a5fb0", "paper": "#eaf0fb", "ink": "#1c2f66", "accent": "#e8a33a", "lid": "#26282e"}],
    ),
    "hairbrush": Maker(hairbrush, hairbrush_random, 2, [{"pad": "#c8453a"}, {"wooden": False, "colour": "#2a2c34", "pad": "#d88aa8"}]),
    "perfume_bottle": Maker(perfume_bottle, perfume_bottle_random, 2, [{"lid": "gold"}, {"square": False, "liquid": "#e79ab0", "lid": "silver"}]),
}  # fmt: skip
