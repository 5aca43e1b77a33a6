"""Mugs, plates and bowls, each with a `broken` variant."""

from __future__ import annotations

import math

import numpy as np
from toolkit import labels
from toolkit.materials import Material, plain
from toolkit.model import (
    Container,
    Maker,
    Model,
    Part,
    Support,
    cylinder_piece,
    prism_piece,
    ring_pieces,
    round_polygon,
)
from toolkit.sampling import noise_offset, pick, seed_of, uniform
from toolkit.shapes import lathe, tube

from makers.breakage import BROKEN, broken, wall_seeds


def mug_print(style: str, words: str, accent: str):
    """The decoration all round, transparent elsewhere (u = 0.25 and 0.75 are front and back)."""
    w, h = 768, 256
    image, draw = labels.canvas(w, h)
    if style == "stripes":
        for y0, y1 in ((0.12, 0.2), (0.25, 0.28), (0.72, 0.75), (0.8, 0.88)):
            draw.rectangle((0, h * y0, w, h * y1), fill=accent)
    elif style == "heart":
        for cx in (w * 0.25, w * 0.75):
            r, cy = h * 0.19, h * 0.43
            draw.ellipse((cx - 2 * r, cy - r, cx, cy + r), fill=accent)
            draw.ellipse((cx, cy - r, cx + 2 * r, cy + r), fill=accent)
            low = cy + 0.38 * r
            draw.polygon(
                [(cx - 1.93 * r, low), (cx + 1.93 * r, low), (cx, cy + 2.3 * r)], fill=accent
            )
    elif style == "text":
        for cx in (w * 0.25, w * 0.75):
            labels.text(
                draw, words, (cx - w * 0.19, h * 0.22, cx + w * 0.19, h * 0.78), fill=accent
            )
    elif style == "dots":
        for row in range(4):
            for i in range(12):
                x, y = w * (i + 0.5 * (row % 2) + 0.25) / 12, h * (0.18 + 0.21 * row)
                draw.ellipse((x - h * 0.06, y - h * 0.06, x + h * 0.06, y + h * 0.06), fill=accent)
    return image


def mug(
    radius=0.041,
    height=0.095,
    taper=0.94,
    colour="#f4f1ea",
    inside="#f6f3ec",
    accent="#c92a36",
    style="heart",
    words="COFFEE",
    seed=0,
) -> Model:
    """A straight or slightly conical mug, its handle to +Y so that the print faces the front."""
    rng = np.random.default_rng(seed)
    wall, foot = 0.0045, radius * taper
    outer = Material()
    base = outer.mottle(colour, 0.04, 40, noise_offset(rng))
    outer.colour(outer.image(mug_print(style, words, accent), base))
    glaze = plain(inside, 0.03, 40, noise_offset(rng))
    unglazed = plain("d9cdbb", 0.08, 200)

    def r_at(z: float) -> float:
        return foot + (radius - foot) * z / height

    zs = np.linspace(0.012, height - 0.004, 3)
    profile = [
        (0, 0.003),
        (foot * 0.72, 0.003),
        (foot * 0.76, 0),
        (foot * 0.84, 0),
        (foot * 0.95, 0.004),
    ]
    profile += [(r_at(z), z) for z in zs]
    profile += [
        (radius - wall * k, height - d) for k, d in ((0.2, 0.0008), (0.5, 0), (0.8, 0.0008))
    ]
    profile += [(r_at(z) - wall, z) for z in zs[::-1][:-1]]
    profile += [(foot - wall - 0.002, 0.012), (foot * 0.72, 0.0075), (0, 0.0068)]
    mats = [2, 2, 2, 0, 0, 0, 0, 0, 0] + [1] * 10

    def shell(n: int):
        return lathe(
            profile,
            n,
            mats=[outer, glaze, unglazed],
            mat_of_segment=mats[: len(profile) - 1],
            label_z=(0.01, height),
            start=math.pi / 2,
        )

    z_mid, tall, deep = height * 0.5, height * 0.3, 0.03
    path = [
        (0, radius - 0.004 + deep * max(math.cos(t), 0) ** 0.8, z_mid + tall * math.sin(t))
        for t in np.linspace(-1.45, 1.45, 9)
    ]
    for end in (0, -1):
        path[end] = (0, r_at(path[end][2]) - 0.003, path[end][2])
    grip = plain(colour, 0.04, 40)
    handles = [tube(path, 0.0066, 7, mat=grip, up=(1.0, 0, 0), flatten=1.15) for _ in range(2)]
    raw = plain("e9ddc8", 0.12, 300)
    seeds = [*wall_seeds(radius, height, 4, rng), (0, radius + 0.02, z_mid)]
    shards = broken([shell(14), handles[1]], raw, seeds, (0.2 * radius) ** 2, seed)

    outside = [(foot, 0), (radius, height)]
    within = [(foot - wall, 0.007), (radius - wall, height)]
    half = 0.0075
    grip = [
        (-half, radius - 0.002),
        (half, radius - 0.002),
        (half, radius + deep),
        (-half, radius + deep),
    ]
    bars = [
        (z_mid - tall - 0.006, z_mid - tall + 0.008),
        (z_mid + tall - 0.008, z_mid + tall + 0.006),
    ]
    front = [(-half, radius + deep - 0.012), (half, radius + deep - 0.012), *grip[2:]]
    pieces = [*ring_pieces(outside, within), cylinder_piece(foot - wall, 0, 0.007)]
    pieces += [prism_piece(grip, *b) for b in bars] + [prism_piece(front, bars[0][0], bars[1][1])]
    return Model(
        title=f"mug, {style} pattern" if style != "none" else "plain mug",
        parts={"body": Part([shell(24), handles[0]], collision=pieces), "shards": shards},
        variants={"default": ["body"], "broken": ["shards"]},
        states=BROKEN,
        mass=0.32,
        texture_size=256 if style in ("heart", "text") else 128,
        containers=[
            Container(
                "inside", (0, 0, height / 2 + 0.004), (radius * 1.2, radius * 1.2, height - 0.008)
            )
        ],
    )


def mug_random(rng: np.random.Generator) -> dict:
    return {
        "radius": uniform(rng, 0.037, 0.045),
        "height": uniform(rng, 0.082, 0.105),
        "taper": uniform(rng, 0.88, 1.0),
        "colour": pick(rng, ["#f4f1ea", "#2d5f8a", "#d9532c", "#e8c33a", "#8fb8a0"]),
        "accent": pick(rng, ["#c92a36", "#20487a", "#222222", "#2c8060"]),
        "style": pick(rng, ["stripes", "heart", "text", "dots", "none"]),
        "words": pick(rng, ["COFFEE", "HELLO", "No. 1", "TEA"]),
        "seed": seed_of(rng),
    }


def plate(
    radius=0.13, height=0.022, colour="#f3f1ea", accent="#2d5f8a", style="rim", seed=0
) -> Model:
    """A dinner plate with a broad rim; style rim, rings or plain."""
    rng = np.random.default_rng(seed)
    m = Material(occlusion=0.8)
    base = m.mottle(colour, 0.03, 25, noise_offset(rng))
    bands = {"rim": [(0.9, 1.01)], "rings": [(0.7, 0.73), (0.77, 0.79), (0.93, 0.96)], "plain": []}[
        style
    ]
    r_now = m.distance((0, 0, height / 2), (1, 1, 0))
    for low, high in bands:
        inside = m.math(
            "MULTIPLY",
            m.math("GREATER_THAN", r_now, low * radius),
            m.math("LESS_THAN", r_now, high * radius),
        )
        base = m.mix(inside, base, accent)
    m.colour(base)
    r, t = radius, 0.005
    profile = [
        (0, 0.002),
        (r * 0.55, 0.002),
        (r * 0.57, 0),
        (r * 0.62, 0),
        (r * 0.7, height * 0.45),
    ]
    profile += [(r * 0.99, height - 0.003), (r, height - 0.001), (r * 0.985, height)]
    profile += [
        (r * 0.72, height * 0.45 + t),
        (r * 0.64, 0.002 + t),
        (r * 0.3, 0.0015 + t),
        (0, 0.0015 + t),
    ]
    dish = lathe(profile, 28, mat=m)
    whole = lathe(profile, 20, mat=m)
    angle = rng.uniform(0, 2 * math.pi)
    seeds = [
        (r * q * math.cos(angle + a), r * q * math.sin(angle + a), 0.01)
        for q, a in ((0.2, 0.4), (0.75, 1.3), (0.8, 2.5), (0.7, 3.7), (0.8, 5.2))
    ]
    shards = broken(
        [whole], plain("ded6c6", 0.1, 300), seeds, 0.0, seed, roughness=0.005, edge=0.03
    )
    floor = [cylinder_piece(r * 0.62, 0, 0.0065, 12)]
    rim = ring_pieces(
        [(r * 0.6, 0), (r, height - 0.004)], [(r * 0.6, 0.0065), (r * 0.98, height)], 10
    )
    return Model(
        title=f"dinner plate, {style}",
        mass=0.55,
        texture_size=256,
        parts={"body": Part([dish], collision=floor + rim), "shards": shards},
        variants={"default": ["body"], "broken": ["shards"]},
        states=BROKEN,
        supports=[Support("inside", 0.0065, round_polygon(r * 0.54))],
    )


def plate_random(rng: np.random.Generator) -> dict:
    return {
        "radius": uniform(rng, 0.105, 0.14),
        "height": uniform(rng, 0.018, 0.026),
        "colour": pick(rng, ["#f3f1ea", "#eceae4", "#d9e3e4", "#e6dcc8"]),
        "accent": pick(rng, ["#2d5f8a", "#a33b35", "#4c7a54", "#3a3a3e"]),
        "style": pick(rng, ["rim", "rings", "plain"]),
        "seed": seed_of(rng),
    }


def bowl(radius=0.08, height=0.065, colour="#4f7f86", inside="#f3efe4", band=True, seed=0) -> Model:
    """A cereal bowl, glazed in two colours."""
    rng = np.random.default_rng(seed)
    outer = Material()
    base = outer.mottle(colour, 0.07, 40, noise_offset(rng))
    if band:
        z = outer.axis(2)
        top = outer.math("GREATER_THAN", z, height * 0.84)
        low = outer.math("LESS_THAN", z, height * 0.2)
        base = outer.mix(outer.math("MAXIMUM", top, low), base, inside)
    outer.colour(base)
    inner = plain(inside, 0.04, 40, noise_offset(rng))
    t, foot = 0.005, radius * 0.48
    curve = [(math.sin(a), 1 - math.cos(a)) for a in np.linspace(0.42, math.pi / 2, 6)]
    low = curve[0]
    outside = [
        (
            foot + (radius - foot) * (x - low[0]) / (1 - low[0]),
            0.008 + (height - 0.009) * (y - low[1]) / (1 - low[1]),
        )
        for x, y in curve
    ]
    within = [(max(r - t, 0), z + t * (1 - k / 5)) for k, (r, z) in enumerate(outside)][::-1]
    profile = [
        (0, 0.003),
        (foot * 0.8, 0.003),
        (foot * 0.85, 0),
        (foot * 0.97, 0),
        (foot, 0.004),
        *outside,
    ]
    edge = len(profile) - 1
    profile += [(radius - t / 2, height), *within, (0, 0.013)]
    mats = [0 if k < edge else 1 for k in range(len(profile) - 1)]
    body, whole = (lathe(profile, n, mats=[outer, inner], mat_of_segment=mats) for n in (22, 14))
    seeds = wall_seeds(radius, height, 5, rng)
    shards = broken([whole], plain("ded6c6", 0.1, 300), seeds, (0.25 * radius) ** 2, seed)
    pieces = [cylinder_piece(foot, 0, 0.013, 12)]
    mid = outside[2]
    pieces += ring_pieces([(foot, 0.004), mid], [(foot - 0.002, 0.013), (mid[0] - t, mid[1])], 8)
    pieces += ring_pieces([mid, (radius, height)], [(mid[0] - t, mid[1]), (radius - t, height)], 8)
    return Model(
        title="bowl",
        mass=0.4,
        texture_size=128,
        parts={"body": Part([body], collision=pieces), "shards": shards},
        variants={"default": ["body"], "broken": ["shards"]},
        states=BROKEN,
        supports=[Support("bottom", 0.013, round_polygon(foot * 0.75), container="inside")],
        containers=[
            Container("inside", (0, 0, height * 0.6), (radius * 1.1, radius * 1.1, height * 0.75))
        ],
    )


def bowl_random(rng: np.random.Generator) -> dict:
    return {
        "radius": uniform(rng, 0.07, 0.095),
        "height": uniform(rng, 0.055, 0.075),
        "colour": pick(rng, ["#4f7f86", "#b5533c", "#3c4a6b", "#c9b27c", "#efece4"]),
        "inside": pick(rng, ["#f3efe4", "#e9e2d0"]),
        "band": bool(rng.random() < 0.5),
        "seed": seed_of(rng),
    }


MODELS = {
    "mug": Maker(
        mug,
        mug_random,
        count=3,
        presets=[
            {"style": "heart", "colour": "#f4f1ea", "accent": "#c92a36"},
            {"style": "stripes", "colour": "#2d5f8a", "accent": "#ffffff"},
            {"style": "text", "colour": "#e8c33a", "accent": "#222222", "words": "COFFEE"},
        ],
    ),
    "plate": Maker(
        plate,
        plate_random,
        count=3,
        presets=[
            {"style": "rim", "colour": "#f3f1ea"},
            {"style": "rings"},
            {"style": "plain", "radius": 0.095, "colour": "#d9e3e4"},
        ],
    ),
    "bowl": Maker(
        bowl,
        bowl_random,
        count=3,
        presets=[
            {"colour": "#4f7f86"},
            {"colour": "#b5533c"},
            {"colour": "#efece4", "band": False},
        ],
    ),
}
