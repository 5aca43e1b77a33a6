"""Candles; the `lit` variant adds flame and molten wax."""

from __future__ import annotations

import math

import numpy as np
from toolkit import labels
from toolkit.materials import Material, glowing, label, metal, plain, shade, srgb
from toolkit.model import Maker, Model, Part, cylinder_piece
from toolkit.sampling import noise_offset, pick, seed_of, uniform
from toolkit.shapes import lathe, spline, tube

SHINE = (1.7, 1.7, 1.7, 1.0)


def flame_mesh(z: float, height: float = 0.034):
    m = glowing("ffffff")
    t = m.remap(m.axis(2), z, z + height)
    stops = [
        (0, "5a78e0"),
        (0.1, "c98a4a"),
        (0.22, "ffc23a"),
        (0.42, "fff6c8"),
        (0.62, "ffe680"),
        (0.82, "ffb02a"),
        (1, "ff7a14"),
    ]
    m.colour(m.ramp(t, stops))
    profile = [
        (0, 0),
        (0.003, 0.0015),
        (0.0058, 0.006),
        (0.0068, 0.011),
        (0.0062, 0.016),
        (0.0046, 0.022),
        (0.0026, 0.028),
        (0, 0.034),
    ]
    mesh = lathe([(r, q * height / 0.034) for r, q in profile], 12, mat=m, discs=False)
    return mesh.warp(lambda x, y, q: (x + 0.0015 * math.sin(q / height * 2.5), y, q + z))


def molten(colour, z: float, radius: float):
    """A glowing pool of wax just above the solid top."""
    m = glowing("ffffff")
    m.colour(
        m.ramp(
            m.remap(m.distance((0, 0, z)), 0, radius),
            [(0, "fff3b4"), (0.35, "ffdf9a"), (1, colour)],
        )
    )
    return lathe(
        [(0, z - 0.002), (radius, z - 0.0005), (radius * 0.9, z + 0.0006), (0, z + 0.0006)],
        16,
        mat=m,
    )


def candle(style="pillar", radius=0.034, height=0.1, colour="#f3e7cf", melt=0.6, seed=0) -> Model:
    """A pillar, a candle in a glass jar, or a taper on a brass stick."""
    rng = np.random.default_rng(seed)
    o, r, h = noise_offset(rng), radius, height
    wax = Material(occlusion=0.45)
    wax.colour(wax.mottle(colour, 0.05, 50, o))
    top_wax = plain(shade(colour, 0.94), 0.03, 60, o, occlusion=0.5)
    meshes, pieces, wick_at, pool = [], [], h - 0.006, r * 0.72
    if style == "jar":
        big, rim = r * 1.25, h
        wick_at = h * 0.7
        pool = big - 0.004
        art, d = labels.canvas(768, 256)
        for cx in (0, 384, 768):
            d.rounded_rectangle(
                (cx - 96, 60, cx + 96, 200), 14, fill="#fbf7ec", outline="#8a7a55", width=4
            )
            labels.text(d, "CANDLE", (cx - 82, 80, cx + 82, 120), "serif", "#5b4a2a")
            labels.text(d, "vanilla", (cx - 72, 130, cx + 72, 175), "italic", "#8a7a55")
        glass = Material(occlusion=0.5)
        filled = shade(colour, 0.97)
        glass.colour(
            glass.ramp(
                glass.remap(glass.axis(2), 0, h),
                [
                    (0, "9fb2b8"),
                    (0.05, filled),
                    (0.69, filled),
                    (0.72, "cfdde0"),
                    (0.97, "e4eef0"),
                    (1, "f6fbfc"),
                ],
            )
        )
        profile = [
            (0, 0),
            (big * 0.93, 0),
            (big, 0.004),
            (big, 0.01),
            (big, wick_at * 0.94),
            (big, rim - 0.001),
            (big - 0.001, rim),
            (big - 0.003, rim - 0.001),
            (big - 0.003, wick_at),
            (0, wick_at),
        ]
        mats = [glass, label(art, filled), top_wax]
        meshes.append(
            lathe(
                profile,
                26,
                mats=mats,
                mat_of_segment=[0, 0, 0, 1, 0, 0, 0, 0, 2],
                label_z=(0.01, wick_at * 0.94),
                start=-math.pi,
            )
        )
        pieces.append(cylinder_piece(big, 0, rim, 12))
    else:
        if style == "taper":
            r, h = 0.011, max(h * 1.7, 0.17)
            wick_at, pool = h - 0.004, r * 0.75
        waves = rng.uniform(0, 6.28, 4)
        steps = (0, 0.25, 0.5, 0.75) if style == "pillar" else (0, 0.5)
        profile = [
            (0, 0),
            (r * 0.98, 0),
            *((r, max(0.0015, h * k)) for k in steps),
            (r, h - 0.006),
            (r * 0.97, h - 0.001),
            (r * 0.88, h),
            (r * 0.78, h - 0.003),
            (r * 0.5, h - 0.006),
            (0, h - 0.0065),
        ]
        n = 22 if style == "pillar" else 12
        body = lathe(
            profile, n, mats=[wax, top_wax], mat_of_segment=[0] * (len(profile) - 4) + [1] * 3
        )

        def soften(x, y, z):
            a, k = math.atan2(y, x), max(0, (z - h * 0.8) / (h * 0.2))
            f = 1 + (0.03 * math.sin(2 * a + waves[0]) + 0.02 * math.sin(5 * a + waves[1])) * k
            up = 0.004 * melt * (math.sin(2 * a + waves[2]) + 0.6 * math.sin(3 * a + waves[3])) * k
            return x * f, y * f, z + up * (math.hypot(x, y) > r * 0.3)

        meshes.append(body.warp(soften))
        for _ in range(int(2 + melt * 5)):
            a, long = uniform(rng, 0, 2 * math.pi), uniform(rng, 0.15, 0.6) * h
            path = [
                (r * 0.985 * math.cos(a), r * 0.985 * math.sin(a), h - 0.004 - long * t)
                for t in np.linspace(0, 1, 4)
            ]
            width = 1.0 if style == "pillar" else 0.5
            meshes.append(
                tube(
                    path,
                    [0.0024 * width, 0.0022 * width, 0.003 * width, 0.0018 * width],
                    5,
                    mat=wax,
                ).weigh(0.8)
            )
        pieces.append(cylinder_piece(r, 0, h, 10))
    wick = spline(
        [(0, 0, wick_at - 0.003), (0, 0, wick_at + 0.006), (0.0012, 0, wick_at + 0.011)], 2
    )
    meshes.append(tube(wick, 0.0012, 5, mat=plain("2a2320", 0.2, 300)))
    fire = [flame_mesh(wick_at + 0.006)]
    glow = [molten(blend_warm(colour), wick_at + 0.0007, pool)]
    if style == "taper":
        stand = [
            (0, 0),
            (0.042, 0),
            (0.045, 0.003),
            (0.04, 0.006),
            (0.02, 0.008),
            (0.008, 0.016),
            (0.007, 0.03),
            (0.01, 0.034),
            (0.016, 0.04),
            (0.0165, 0.052),
            (0.0135, 0.054),
            (0.0115, 0.05),
            (0, 0.05),
        ]
        for mesh in (*meshes, *fire, *glow):
            mesh.keep_pattern().move(z=0.046)
        meshes.append(lathe(stand, 18, mat=metal("d0a545", "8a6420")))
        pieces = [p + np.array([0, 0, 0.046]) for p in pieces] + [
            cylinder_piece(0.045, 0, 0.006),
            cylinder_piece(0.014, 0.006, 0.054, 8),
        ]
    return Model(
        title=f"{style} candle" if style != "taper" else "taper candle on a brass stick",
        parts={
            "wax": Part(meshes, collision=pieces),
            "flame": Part(fire, rgba=SHINE, collision="none"),
            "glow": Part(glow, rgba=(1.25, 1.25, 1.25, 1.0), collision="none"),
        },
        variants={"default": ["wax"], "lit": ["wax", "flame", "glow"]},
        states=[
            {"state": "ON", "variants": ["lit"], "parts": ["flame"]},
            {"state": "OFF", "variants": ["default"], "parts": ["wax"]},
        ],
        mass=0.3,
        friction=0.6,
        texture_size=128 if style != "jar" else 256,
    )


def blend_warm(colour) -> tuple[float, float, float]:
    """The colour of wax lit from within."""
    return tuple((srgb(colour) * 0.6 + srgb("ffcf80") * 0.4).clip(0, 1))


def candle_random(rng: np.random.Generator) -> dict:
    return {
        "radius": uniform(rng, 0.03, 0.038),
        "height": uniform(rng, 0.08, 0.13),
        "colour": pick(rng, ["#f3e7cf", "#a8262c", "#e9d6e6", "#d8c48a", "#6f8f6a"]),
        "melt": uniform(rng, 0.2, 1.0),
        "seed": seed_of(rng),
    }


MODELS = {
    "candle": Maker(
        candle,
        candle_random,
        count=3,
        presets=[
            {"style": "pillar", "colour": "#f3e7cf"},
            {"style": "jar", "colour": "#a8262c"},
            {"style": "taper", "colour": "#f3e7cf"},
        ],
    ),
}
