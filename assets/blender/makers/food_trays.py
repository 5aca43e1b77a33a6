"""Eggs in a pulp box, yogurt, and raw meat in a tray."""

from __future__ import annotations

import math

import numpy as np
from toolkit import labels
from toolkit.materials import Material, label, metal, plain
from toolkit.mesh import Mesh
from toolkit.model import (
    Joint,
    Model,
    Part,
    box_piece,
    cylinder_piece,
)
from toolkit.sampling import noise_offset, pick, seed_of, uniform
from toolkit.shapes import box, ellipsoid, extrude, lathe, loft, rounded_rectangle


def tapered_box(sx, sy, z0, z1, inset, mat, radius=0.012) -> Mesh:
    """A tray-like solid: smaller at the bottom by `inset` on each side."""
    rings = []
    for z, k in ((z0, inset), (z1, 0.0)):
        outline = rounded_rectangle(sx - 2 * k, sy - 2 * k, radius, 3)
        rings.append(np.c_[outline, np.full(len(outline), z)])
    return loft(rings, mat=mat)


def egg_carton(colour="#a9a79c", paper="#f4e6b8", ink="#7a4a1c", egg="#d9a878", seed=0) -> Model:
    """A pulp box of six eggs; the lid opens towards the back."""
    rng = np.random.default_rng(seed)
    pulp = Material()
    pulp.colour(pulp.mottle(colour, 0.12, 220, noise_offset(rng)))
    sx, sy, rim, top = 0.105, 0.155, 0.042, 0.078
    base = [tapered_box(sx, sy, rim - 0.008, rim, 0.001, pulp, 0.01)]
    eggs = []
    shell = plain(egg, 0.08, 260, noise_offset(rng))
    for x in (-0.0245, 0.0245):
        for y in (-0.05, 0, 0.05):
            cup = [(0, 0), (0.013, 0), (0.016, 0.003), (0.0235, rim - 0.004), (0, rim - 0.004)]
            base.append(lathe(cup, 6, mat=pulp, start=math.pi / 8).move(x, y))
            one = ellipsoid((0.0205, 0.0205, 0.027), (x, y, rim - 0.003), 8, 6, shell)
            one.v[:, 2] += 0.004 * ((one.v[:, 2] - rim) / 0.027) ** 2
            eggs.append(one)
    # a hollow lid: outer and inner skin joined at the rim
    image, d = labels.canvas(240, 170, paper)
    d.rectangle((6, 6, 234, 164), outline=ink, width=5)
    labels.text(d, "6 EGGS", (24, 14, 216, 76), "bold", ink)
    labels.text(d, "free range", (40, 78, 200, 104), "italic", ink)
    for i in range(3):
        d.ellipse((52 + 50 * i, 108, 86 + 50 * i, 154), fill=egg, outline=ink, width=2)
    lid_z = [(rim + 0.0005, 0.0), (rim + 0.004, 0.001), (top - 0.008, 0.006), (top, 0.013)]
    outer = [
        np.c_[q, np.full(len(q), z)]
        for z, k in lid_z
        for q in [rounded_rectangle(sx - 2 * k, sy - 2 * k, 0.014, 3)]
    ]
    inner = [
        np.c_[q, np.full(len(q), z - 0.004 * (i > 0))]
        for i, (z, k) in enumerate(lid_z)
        for q in [rounded_rectangle(sx - 2 * k - 0.01, sy - 2 * k - 0.01, 0.01, 3)]
    ]
    lid = loft([inner[3], inner[2], inner[0], outer[0], outer[1], outer[2], outer[3]], mat=pulp)
    sticker = box(
        0.066,
        0.108,
        0.0012,
        (0, 0, top - 0.0004),
        mat=pulp,
        labels={"+z": label(image)},
        weight=1.5,
    )
    tongue = box(0.004, 0.05, 0.016, (sx / 2 + 0.001, 0, rim - 0.012), pulp, 0.0015)
    hinge = Joint("revolute", (-sx / 2, 0, rim), (0, -1, 0), 0.0, 2.2)
    lid_pieces = [box_piece((0, 0, top - 0.003), (sx - 0.02, sy - 0.02, 0.006))]
    lid_pieces += [
        box_piece((s * (sx / 2 - 0.006), 0, (rim + top) / 2), (0.008, sy - 0.006, top - rim))
        for s in (-1, 1)
    ]
    lid_pieces += [
        box_piece((0, s * (sy / 2 - 0.006), (rim + top) / 2), (sx - 0.006, 0.008, top - rim))
        for s in (-1, 1)
    ]
    return Model(
        title="egg carton, six eggs",
        parts={
            "body": Part(base, collision=[box_piece((0, 0, rim / 2), (sx * 0.94, sy * 0.96, rim))]),
            "eggs": Part(eggs, collision="none", occlusion="fixed"),
            "lid": Part([lid, sticker, tongue], joint="lid", collision=lid_pieces),
        },
        joints={"lid": hinge},
        mass=0.42,
        friction=0.7,
        states=[
            {"state": "CLOSED", "joint": "lid", "max": 0.05},
            {"state": "OPEN", "joint": "lid", "min": 0.6, "parts": ["lid", "eggs"]},
        ],
    )


def egg_carton_random(rng: np.random.Generator) -> dict:
    return {"egg": pick(rng, ["#d9a878", "#f0e6d6", "#c98f60"]), "seed": seed_of(rng)}


def yogurt_cup(
    radius=0.034,
    height=0.075,
    flavour="STRAWBERRY",
    colour="#f4f0ee",
    fruit="#d8283a",
    brand="Alba",
    seed=0,
) -> Model:
    """A tapered cup, foil on top."""
    w, h = 768, 256
    image, d = labels.canvas(w, h, colour)
    d.rectangle((0, 0, w, h * 0.12), fill=fruit)
    for cx in (0, w / 2, w):
        labels.text(d, brand, (cx - 130, h * 0.16, cx + 130, h * 0.44), "italic", "#2a3a6e")
        labels.text(d, flavour, (cx - 120, h * 0.46, cx + 120, h * 0.58), "bold", fruit)
        for dx, dy in ((-50, 0), (0, 14), (50, 0)):
            x, y = cx + dx, h * 0.77 + dy
            d.polygon(
                [
                    (x - 30, y - 22),
                    (x + 30, y - 22),
                    (x + 14, y + 22),
                    (x, y + 34),
                    (x - 14, y + 22),
                ],
                fill=fruit,
            )
            d.polygon([(x - 22, y - 22), (x, y - 40), (x + 22, y - 22)], fill="#3f8a2c")
    for cx in (w / 4, 3 * w / 4):
        labels.small_print(d, (cx - 50, h * 0.3, cx + 50, h * 0.85), 8, "#8a8a90")
    foil_art, d2 = labels.canvas(200, 200, "#dfe3e8")
    d2.ellipse((4, 4, 196, 196), fill="#e9edf1")
    d2.rectangle((0, 62, 200, 138), fill=fruit)
    labels.text(d2, brand, (30, 70, 170, 130), "italic")
    low = radius * 0.78
    skin, foil = label(image), metal("e2e5e8", "aeb4ba")
    profile = [
        (0, 0.002),
        (low * 0.9, 0.002),
        (low, 0),
        (low + 0.001, 0.003),
        (radius, height - 0.004),
        (radius, height - 0.003),
    ]
    profile += [
        (radius + 0.004, height - 0.003),
        (radius + 0.004, height - 0.001),
        (0, height - 0.001),
    ]
    body = lathe(
        profile,
        26,
        mats=[plain(colour, 0.02), skin],
        mat_of_segment=[0, 0, 0, 1, 0, 0, 0, 0],
        label_z=(0.003, height - 0.004),
        start=-math.pi,
    )
    angles = np.linspace(0, 2 * math.pi, 25)[:-1]
    outline = [
        (
            (radius + 0.0045) * math.cos(a) * (1.22 if abs(a - math.pi / 2) < 0.2 else 1),
            (radius + 0.0045) * math.sin(a) * (1.22 if abs(a - math.pi / 2) < 0.2 else 1),
        )
        for a in angles
    ]
    lid = extrude(outline, 0.0016, foil)
    lid.mats, lid.mi = [foil, label(foil_art)], [0, 1] + [0] * len(outline)
    lid.turn(rz=math.pi / 2).move(z=height - 0.001)
    return Model(
        title=f"yogurt, {flavour.lower()}",
        parts={
            "body": Part(
                [body, lid], collision=[cylinder_piece(low, 0, height, 12, radius + 0.004)]
            )
        },
        mass=0.16,
        friction=0.5,
    )


def yogurt_cup_random(rng: np.random.Generator) -> dict:
    return {
        "radius": uniform(rng, 0.032, 0.038),
        "height": uniform(rng, 0.07, 0.09),
        "brand": pick(rng, ["Alba", "Cremosa"]),
        "seed": seed_of(rng),
    }


def raw_meat(length=0.2, width=0.14, tray="#1f2124", kind="steak", seed=0) -> Model:
    """A butcher's foam tray of raw meat."""
    rng = np.random.default_rng(seed)
    foam = plain(tray, 0.05, 200)
    h, t = 0.024, 0.007
    rim = [
        rounded_rectangle(width - 2 * k, length - 2 * k, 0.02, 4)
        for k in (0.012, 0.001, 0.0, 0.008, 0.016)
    ]
    levels = (0.0, h - 0.004, h, h, t)
    dish = loft([np.c_[q, np.full(len(q), z)] for q, z in zip(rim, levels, strict=True)], mat=foam)
    o = noise_offset(rng)
    flesh = Material(occlusion=0.7)
    red, dark, fat = (
        ("b3202c", "7d0f1c", "f2d9cc") if kind == "steak" else ("c8433c", "a02c2c", "efc4b4")
    )
    base = flesh.mix(
        flesh.remap(flesh.noise(30, 4, offset=o, stretch=(1, 3, 1)), 0.35, 0.65), dark, red
    )
    if kind == "steak":
        veins = flesh.noise(26, 3, distortion=2.5, offset=(o[1], o[0], o[2]))
        thin = flesh.math("ABSOLUTE", flesh.math("SUBTRACT", veins, 0.5))
        base = flesh.mix(flesh.remap(thin, 0.008, 0.022, 0.8, 0), base, fat)
    else:  # minced: strands
        strands = flesh.voronoi(150, o, (1, 0.35, 1))
        base = flesh.mix(flesh.remap(strands, 0.15, 0.55), base, "7d1a1e")
        base = flesh.mix(flesh.remap(flesh.voronoi(130, (o[1], 1, 0)), 0.1, 0.2, 0.9, 0), base, fat)
    shine = flesh.noise(22, 1, offset=(o[2], 0, 1), stretch=(1, 2.5, 1))
    base = flesh.mix(flesh.remap(shine, 0.66, 0.7, 0, 0.6), base, "ffe9e4")
    flesh.colour(base)
    rind = plain("f1e0cf", 0.06, 60)
    meshes = [dish]
    blocks = (
        ((0, 0.0, 0.46, 0.43, 0),)
        if kind != "steak"
        else ((0.0, -0.045, 0.43, 0.205, 0.12), (0.0, 0.042, 0.42, 0.205, -0.2))
    )
    for x, y, a, b, yaw in blocks:
        n, p1, p2 = 26, rng.uniform(0, 6.3), rng.uniform(0, 6.3)
        angles = [2 * math.pi * i / n for i in range(n)]
        shape = [
            1
            + (0.07 * math.sin(2 * q + p1) + 0.05 * math.sin(3 * q + p2) if kind == "steak" else 0)
            for q in angles
        ]
        power = 2.4 if kind == "steak" else 5.0

        def ring(k, z, a=a, b=b, shape=shape, power=power, angles=angles):
            c = [
                (
                    np.sign(math.cos(q)) * abs(math.cos(q)) ** (2 / power),
                    np.sign(math.sin(q)) * abs(math.sin(q)) ** (2 / power),
                )
                for q in angles
            ]
            return [
                ((width - 0.03) * a * s * k * cx, (length - 0.03) * b * s * k * cy, z)
                for s, (cx, cy) in zip(shape, c, strict=True)
            ]

        top = t + 0.02
        piece = loft(
            [
                ring(0.94, t),
                ring(1.0, t + 0.008),
                ring(0.97, top - 0.003),
                ring(0.86, top),
                ring(0.3, top + 0.001),
            ],
            mats=[flesh, rind],
            mat_of_face=lambda k, i: int(kind == "steak" and k < 3 and 3 < i < 12),
        )
        piece.bake_uv = None
        meshes.append(piece.turn(rz=yaw).move(x, y))
    image, d = labels.canvas(180, 110, "#ffffff")
    d.rectangle((0, 0, 180, 30), fill="#c3262c")
    labels.text(d, "BEEF" if kind == "steak" else "MINCED BEEF", (8, 3, 172, 27))
    labels.text(d, "KEEP COLD", (8, 34, 110, 50), "bold", "#1f4f9c", align="left")
    labels.small_print(d, (8, 56, 100, 100), 4, "#777777")
    labels.barcode(d, (116, 48, 170, 96), rng)
    sticker = box(
        0.042,
        0.06,
        0.0015,
        (width / 2 - 0.042, length / 2 - 0.055, t + 0.0206),
        mat=plain("ffffff", 0),
        labels={"+z": label(image)},
        weight=1.5,
    )
    solid = box_piece((0, 0, (t + 0.024) / 2), (width - 0.006, length - 0.006, t + 0.024))
    return Model(
        title="raw beef steaks in a tray" if kind == "steak" else "minced beef in a tray",
        parts={"body": Part([*meshes, sticker], collision=[solid])},
        mass=0.45,
        friction=0.5,
    )


def raw_meat_random(rng: np.random.Generator) -> dict:
    return {
        "length": uniform(rng, 0.18, 0.22),
        "width": uniform(rng, 0.125, 0.15),
        "seed": seed_of(rng),
    }
