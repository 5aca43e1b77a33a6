"""Teapots; broken ones leave spout, handle and lid on the floor."""

from __future__ import annotations

import math

import numpy as np
from toolkit import labels
from toolkit.fracture import fracture, scatter
from toolkit.materials import Material, metal, plain
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part, box_piece, cylinder_piece
from toolkit.sampling import noise_offset
from toolkit.shapes import ellipsoid, lathe, spline, tube

from makers.breakage import BROKEN
from makers.ware import r_at, wall_profile

# radius, height, outline in shares up to the mouth, handle, spout
TEAPOTS = {
    "round": (
        0.075,
        0.115,
        [(0.6, 0), (0.72, 0.05), (1, 0.42), (0.94, 0.7), (0.7, 0.92), (0.5, 1)],
        "ear",
        "swan",
    ),
    "tall": (
        0.066,
        0.185,
        [(0.94, 0), (1, 0.04), (0.9, 0.4), (0.72, 0.8), (0.66, 1)],
        "ear",
        "swan",
    ),
    "iron": (
        0.085,
        0.085,
        [(0.6, 0), (0.85, 0.12), (1, 0.45), (0.92, 0.75), (0.6, 1)],
        "over",
        "short",
    ),
    "squat": (
        0.084,
        0.1,
        [(0.7, 0), (0.84, 0.06), (1, 0.35), (0.98, 0.6), (0.66, 0.88), (0.58, 1)],
        "ring",
        "short",
    ),
    "drum": (
        0.068,
        0.125,
        [(0.98, 0), (1, 0.04), (1, 0.5), (1, 0.9), (0.7, 1)],
        "square",
        "straight",
    ),
    "pear": (
        0.072,
        0.15,
        [(0.58, 0), (0.66, 0.05), (1, 0.34), (0.82, 0.66), (0.52, 0.9), (0.5, 1)],
        "ear",
        "swan",
    ),
}


def tea_print(style: str, accent: str, second: str):
    """Decoration all round; u = 0.25 and 0.75 are the sides."""
    w, h = 1024, 256
    image, draw = labels.canvas(w, h)
    if style == "flowers":
        for i in range(8):
            x, y = w * (i + 0.5) / 8, h * (0.4 + 0.22 * (i % 2))
            draw.ellipse((x + 20, y + 18, x + 70, y + 44), fill="#4f8a3c")
            for k in range(6):
                a = k * math.pi / 3
                px, py, q = x + 30 * math.cos(a), y + 30 * math.sin(a), 23
                draw.ellipse((px - q, py - q, px + q, py + q), fill=accent)
            draw.ellipse((x - 16, y - 16, x + 16, y + 16), fill=second)
    elif style == "dots":
        for row in range(5):
            for i in range(18):
                x, y = w * (i + 0.5 * (row % 2) + 0.25) / 18, h * (0.14 + 0.18 * row)
                draw.ellipse((x - 15, y - 15, x + 15, y + 15), fill=accent)
    elif style == "text":
        for cx in (w * 0.25, w * 0.75):
            labels.text(draw, "TEA", (cx - 110, 50, cx + 110, 210), "serif", accent)
    elif style == "bands":
        draw.rectangle((0, 30, w, 60), fill=accent)
        draw.rectangle((0, 74, w, 84), fill=second)
        draw.rectangle((0, 210, w, 236), fill=accent)
    return image


def spout_of(kind: str, outer, r: float, h: float, mat: Material, n: int) -> Mesh:
    """A spout to +X."""
    if kind == "swan":
        start = (r_at(outer, 0.3 * h) - 0.008, 0, 0.3 * h)
        points = [start, (r + 0.03, 0, 0.48 * h), (r + 0.042, 0, 0.8 * h), (r + 0.066, 0, 1.0 * h)]
        path = spline(points, 2)
        radii = np.linspace(0.019, 0.0085, len(path))
    elif kind == "straight":
        path = np.array(
            [(r - 0.01, 0, 0.45 * h), (r + 0.02, 0, 0.66 * h), (r + 0.055, 0, 0.98 * h)]
        )
        radii = np.array([0.02, 0.015, 0.0095])
    else:
        path = np.array([(r * 0.8, 0, 0.5 * h), (r + 0.018, 0, 0.68 * h), (r + 0.044, 0, 1.0 * h)])
        radii = np.array([0.02, 0.016, 0.01])
    return tube(path, radii, n, mat=mat, up=(0, 1.0, 0))


def handle_of(kind: str, outer, r: float, h: float, mat: Material, n: int) -> list[Mesh]:
    """A handle to -X, or over the lid."""
    if kind == "over":
        turns = np.linspace(0.12, math.pi - 0.12, 9)
        arch = [(0.78 * r * math.cos(a), 0, 0.8 * h + 1.05 * r * math.sin(a)) for a in turns]
        return [tube(arch, 0.0055, n, mat=mat, up=(0, 1.0, 0), flatten=1.3)]
    z, tall, deep = 0.54 * h, 0.34 * h, 0.048
    if kind == "square":
        corners = [(-0.1, -1), (0.8, -1), (1, -0.8), (1, 0.8), (0.8, 1), (-0.1, 1)]
        path = [(-r - deep * u, 0, z + tall * w) for u, w in corners]
    else:
        power = 0.5 if kind == "ring" else 0.7
        turns = np.linspace(-1.5, 1.5, 9)
        path = [
            (-r * 0.9 - deep * max(math.cos(a), 0) ** power, 0, z + tall * math.sin(a))
            for a in turns
        ]
    path = [list(p) for p in path]
    for end in (0, -1):
        path[end][0] = -r_at(outer, path[end][2]) + 0.004
    return [tube(path, 0.0068, n, mat=mat, up=(0, 1.0, 0), flatten=1.15)]


def teapot(
    shape="round",
    colour="#f2efe6",
    style="flowers",
    accent="#c8405c",
    second="#f2c230",
    material="",
    look=0,
    seed=0,
) -> Model:
    """A teapot, its spout to the front."""
    rng = np.random.default_rng(look)
    r, h, shares, ear, beak = TEAPOTS[shape]
    outer = [(r * q, h * z) for q, z in shares]
    wall, floor = 0.0045, 0.007
    profile, kinds = wall_profile(outer, wall, floor)
    glaze = Material()
    base = glaze.mottle(colour, 0.06, 40, noise_offset(rng))
    if material == "iron":
        bumps = glaze.remap(glaze.voronoi(130), 0.0, 0.5)
        base = glaze.mix(bumps, "5a6068", colour)
    glaze.colour(glaze.image(tea_print(style, accent, second), base))
    trim = plain(colour if material != "iron" else "#1c1d20", 0.05, 40)
    if material == "steel":
        glaze = metal("c6cace", "80868c", (1, 1, 10), 40)
        trim = glaze
    accent_mat = plain(accent, 0.03) if style in ("bands", "dots") else trim
    inside = plain("ded8c8", 0.03)
    grip = plain("#26262a", 0.05) if material in ("steel", "iron") else accent_mat

    def shell(n: int):
        return lathe(
            profile,
            n,
            mats=[glaze, inside, inside, trim],
            mat_of_segment=kinds,
            label_z=(0.05 * h, 0.95 * h),
            start=0.0,
        )

    def lid(n: int) -> list[Mesh]:
        q = outer[-1][0]
        dome = [(0, 0), (q + 0.003, 0), (q + 0.004, 0.004), (q * 0.7, 0.014), (0, 0.019)]
        knob = ellipsoid(0.0105, (0, 0, 0.027), 7, 4, grip)
        return [lathe(dome, n, mat=glaze if material else trim), knob]

    spout, ring = spout_of(beak, outer, r, h, trim, 8), handle_of(ear, outer, r, h, grip, 6)
    lids = [m.move(z=h - 0.001) for m in lid(16)]
    whole = [shell(8), spout_of(beak, outer, r, h, trim, 5), *handle_of(ear, outer, r, h, grip, 4)]
    turn = 0.8
    seeds = [(0.2 * r, 0.3 * r, 0.1 * h)]
    for k, z in enumerate((0.85, 0.7, 0.9)):
        a = turn + 2 * math.pi / 3 * k
        seeds.append((1.1 * r * math.cos(a), 1.1 * r * math.sin(a), z * h))
    seeds += [
        (r + 0.07, 0, 0.75 * h),
        (-r - 0.06, 0, 0.55 * h) if ear != "over" else (0, 0, h + 1.0 * r),
    ]
    weights = [(0.65 * r) ** 2] + [0.0] * 5
    raw = plain("d8c8a8" if material != "iron" else "6a6a6c", 0.12, 300)
    shards = fracture(whole, seeds, raw, weights, seed, 0.003, 0.12)
    fallen = scatter(shards, np.random.default_rng(seed))
    aside = [m.keep_pattern().move(-1.3 * r, 1.6 * r, 0) for m in lid(9)]
    shards += aside
    fallen.append(np.concatenate([m.v for m in aside]))
    picks = [outer[0], outer[len(outer) // 2], outer[-1]]
    pieces = [
        cylinder_piece(a[0], a[1], b[1], 12, b[0])
        for a, b in ((picks[0], picks[1]), (picks[1], picks[2]))
    ]
    pieces.append(cylinder_piece(outer[-1][0], h, h + 0.036, 10, 0.01))
    pieces.append(spout.v.copy())
    if ear == "over":
        pieces.append(box_piece((0, 0, 0.8 * h + 1.0 * r), (r, 0.015, 0.02)))
    else:
        pieces.append(box_piece((-r - 0.035, 0, 0.54 * h), (0.02, 0.016, 0.6 * h)))
    return Model(
        f"{shape} teapot" + (f", {material}" if material else ""),
        {
            "body": Part([shell(18), *lids, spout, *ring], collision=pieces),
            "shards": Part(shards, collision=fallen),
        },
        mass=0.8 if material != "iron" else 1.4,
        texture_size=256 if style in ("flowers", "text") else 128,
        variants={"default": ["body"], "broken": ["shards"]},
        states=BROKEN,
        front="-y",  # the spout to the right: seen from the front it would hide the handle
    )


def teapot_random(rng: np.random.Generator) -> dict:
    return {"look": int(rng.integers(1_000_000)), "seed": 3}


MODELS = {
    "teapot": Maker(
        teapot,
        teapot_random,
        8,
        [
            {"shape": "round", "style": "flowers", "colour": "#f4f1e8", "accent": "#d0486a"},
            {"shape": "tall", "style": "bands", "colour": "#3a6a9c", "accent": "#f4f1e8"},
            {"shape": "iron", "style": "none", "colour": "#24262a", "material": "iron"},
            {"shape": "squat", "style": "none", "colour": "#6b3a1e"},
            {"shape": "drum", "style": "dots", "colour": "#c8302c", "accent": "#fbf7ee"},
            {"shape": "pear", "style": "none", "material": "steel"},
            {"shape": "round", "style": "text", "colour": "#8fb8a0", "accent": "#1f3f30"},
            {"shape": "tall", "style": "flowers", "colour": "#f4f1e8", "accent": "#3a62b0"},
        ],
    ),
}
