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


def flame_mesh(z: float, height: float = 0.05):
    """A flame as large as a quiet one gets: some pixels of a picture taken from across a room.

    Its colours are those that, 1.7 times as bright (SHINE), are yellow with an orange rim: white
    would be lost on a pale wall.
    """
    m = glowing("ffffff")
    t = m.remap(m.axis(2), z, z + height)
    stops = [
        (0, "3a50b0"),
        (0.08, "a04808"),
        (0.2, "d88810"),
        (0.42, "fff0a0"),
        (0.6, "f4c828"),
        (0.8, "c86808"),
        (1, "a83c04"),
    ]
    m.colour(m.ramp(t, stops))
    profile = [
        (0, 0),
        (0.15, 0.05),
        (0.21, 0.24),
        (0.21, 0.36),
        (0.17, 0.52),
        (0.08, 0.78),
        (0, 1),
    ]
    mesh = lathe([(r * height, q * height) for r, q in profile], 8, mat=m, discs=False)
    return mesh.warp(lambda x, y, q: (x + 0.0015 * math.sin(q / height * 2.5), y, q + z))


def molten(colour, z: float, radius: float, n: int = 16):
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
        n,
        mat=m,
    )


def sleeve(radius: float, top: float, long: float, n: int):
    """The upper end of a slender candle, which lets the light of its flame through."""
    m = glowing("ffffff")
    m.colour(m.ramp(m.remap(m.axis(2), top - long, top), [(0, "e0a860"), (1, "ffd870")]))
    r = radius + 0.0012
    return lathe([(0.9 * radius, top - long), (r, top - 0.8 * long), (r, top), (0, top)], n, mat=m)


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
        wick_at = h * 0.85  # so near the rim that the flame shows above it
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
                    (0.84, filled),
                    (0.86, "cfdde0"),
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
            (big, wick_at * 0.92),
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
                20,
                mats=mats,
                mat_of_segment=[0, 0, 0, 1, 0, 0, 0, 0, 2],
                label_z=(0.01, wick_at * 0.92),
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
        n = 22 if style == "pillar" else 10
        body = lathe(
            profile, n, mats=[wax, top_wax], mat_of_segment=[0] * (len(profile) - 4) + [1] * 3
        )

        def soften(x, y, z):
            a, k = math.atan2(y, x), max(0, (z - h * 0.8) / (h * 0.2))
            f = 1 + (0.03 * math.sin(2 * a + waves[0]) + 0.02 * math.sin(5 * a + waves[1])) * k
            up = 0.004 * melt * (math.sin(2 * a + waves[2]) + 0.6 * math.sin(3 * a + waves[3])) * k
            return x * f, y * f, z + up * (math.hypot(x, y) > r * 0.3)

        meshes.append(body.warp(soften))
        for _ in range(int(2 + melt * 3) if style == "pillar" else 2):
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
        glow.append(sleeve(r, h + 0.0005, 0.03, 10))
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
    title = f"{style} candle" if style != "taper" else "taper candle on a brass stick"
    return lit_model(title, meshes, fire, glow, pieces, 128 if style != "jar" else 256)


def lit_model(title: str, meshes, fire, glow, pieces, size: int = 128) -> Model:
    """A candle that may burn."""
    return Model(
        title=title,
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
        texture_size=size,
    )


def stick(r: float, h: float, z: float, wax, top, n: int = 12) -> list:
    """A plain body of wax with its wick, standing on z."""
    profile = [(0, z), (r, z), (r, z + h - 0.003), (0.85 * r, z + h), (0.5 * r, z + h - 0.002)]
    mats = [0, 0, 0, 1, 1]
    body = lathe([*profile, (0, z + h - 0.003)], n, mats=[wax, top], mat_of_segment=mats)
    wick = tube(
        [(0, 0, z + h - 0.004), (0, 0, z + h + 0.004), (0.0012, 0, z + h + 0.009)],
        0.0012,
        4,
        mat=plain("2a2320", 0.2, 300),
    )
    return [body, wick]


def small_flame(z: float, height: float, n: int = 6):
    """A flame of fewer faces, for things with several."""
    mesh = flame_mesh(z, height)
    levels = [(0, 0), (0.17, 0.12), (0.21, 0.34), (0.13, 0.66), (0, 1)]
    profile = [(r * height, z + height * share) for r, share in levels]
    return lathe(profile, n, mats=mesh.mats, discs=False)


def candles(style="trio", colour="#f3e7cf", second="#d8c48a", look=0) -> Model:
    """style: "trio" on a dish, "tealights", "candelabra", "bowl" (three wicks) or "ball"."""
    rng = np.random.default_rng(look)
    o = noise_offset(rng)
    wax, top = Material(occlusion=0.45), plain(shade(colour, 0.94), 0.03, 60, o, occlusion=0.5)
    wax.colour(wax.mottle(colour, 0.05, 50, o))
    warm = blend_warm(colour)
    meshes, fire, glow, pieces = [], [], [], []

    def burn(x: float, y: float, z: float, pool: float, high: float = 0.046) -> None:
        fire.append(small_flame(z + 0.004, high).keep_pattern().move(x, y, 0))
        glow.append(
            molten(warm, z - 0.0012, pool, 10 if pool > 0.01 else 5).keep_pattern().move(x, y, 0)
        )

    if style == "trio":
        slate = [(0, 0), (0.072, 0), (0.075, 0.004), (0.073, 0.008), (0, 0.008)]
        meshes.append(lathe(slate, 24, mat=plain("4a4e54", 0.12, 60)))
        pieces.append(cylinder_piece(0.074, 0, 0.008))
        places = ((0.03, 0.024, 0.055), (-0.032, 0.018, 0.115), (0.004, -0.036, 0.085))
        for x, y, h in places:
            for mesh in stick(0.024, h, 0.008, wax, top, 14):
                meshes.append(mesh.keep_pattern().move(x, y, 0))
            pieces.append(cylinder_piece(0.024, 0.008, 0.008 + h, 10) + np.array([x, y, 0]))
            burn(x, y, 0.008 + h, 0.016)
        title = "three pillar candles on a dish"
    elif style == "tealights":
        # In glasses of different colours: bare tins read as button cells from across a room.
        cup = [(0, 0), (0.025, 0), (0.0275, 0.004), (0.031, 0.05), (0.0285, 0.05)]
        cup += [(0.0268, 0.03), (0, 0.03)]
        glasses = (("b8403c", 0, 0), ("d9962e", 0.078, 0.012), ("3f7f86", 0.026, 0.076))
        for hue, x, y in glasses:
            glass = plain(hue, 0.1, 40, o)
            body = lathe(cup, 16, mats=[glass, top], mat_of_segment=[0, 0, 0, 0, 0, 1])
            wick = tube(
                [(0, 0, 0.029), (0, 0, 0.036), (0.001, 0, 0.04)],
                0.0012,
                4,
                mat=plain("2a2320", 0.2),
            )
            meshes += [m.keep_pattern().move(x, y, 0) for m in (body, wick)]
            piece = cylinder_piece(0.0265, 0, 0.05, 12, 0.031)
            pieces.append(piece + np.array([x, y, 0]))
            burn(x, y, 0.0335, 0.022, 0.04)
        title = "three tealights in glasses"
    elif style == "candelabra":
        brass = metal("d0a545", "8a6420")
        foot = [(0, 0), (0.055, 0), (0.056, 0.005), (0.03, 0.012), (0.009, 0.024), (0.0075, 0.1)]
        foot += [(0.013, 0.11), (0.0065, 0.12), (0.0065, 0.15), (0, 0.15)]
        meshes.append(lathe(foot, 10, mat=brass))
        pieces += [cylinder_piece(0.055, 0, 0.01), cylinder_piece(0.01, 0.01, 0.15, 8)]
        arc = [(0, 0.0, 0.11), (0, 0.03, 0.09), (0, 0.062, 0.104), (0, 0.068, 0.14)]
        for s in (-1, 1):
            path = spline([(x, s * y, z) for x, y, z in arc], 2)
            meshes.append(tube(path, 0.0048, 5, mat=brass, up=(1.0, 0, 0)))
        for y, z in ((-0.068, 0.138), (0, 0.15), (0.068, 0.138)):
            cup = [(0, z), (0.007, z), (0.017, z + 0.006), (0.0175, z + 0.008), (0, z + 0.009)]
            meshes.append(lathe(cup, 8, mat=brass).move(y=y))
            for mesh in stick(0.0092, 0.11, z + 0.008, wax, top, 6):
                meshes.append(mesh.keep_pattern().move(y=y))
            pieces.append(cylinder_piece(0.012, z - 0.02, z + 0.118, 8) + np.array([0, y, 0]))
            burn(0, y, z + 0.118, 0.0065)
            glow.append(sleeve(0.0092, z + 0.118, 0.022, 5).move(y=y))
        title = "candelabra with three candles"
    elif style == "bowl":
        outer = [(0.05, 0), (0.066, 0.01), (0.072, 0.035), (0.07, 0.05)]
        inner = [(0.066, 0.05), (0.066, 0.044), (0, 0.044)]
        glaze = plain(second, 0.06, 50, o)
        kinds = [0] * (len(outer)) + [0, 0, 1]
        profile = [(0, 0), *outer, *inner]
        meshes.append(
            lathe(profile, 22, mats=[glaze, top], mat_of_segment=kinds[: len(profile) - 1])
        )
        pieces.append(cylinder_piece(0.06, 0, 0.05, 12, 0.071))
        for k in range(3):
            a = 2.1 * k
            x, y = 0.03 * math.cos(a), 0.03 * math.sin(a)
            wick = tube(
                [(x, y, 0.042), (x, y, 0.05), (x + 0.001, y, 0.054)],
                0.0012,
                4,
                mat=plain("2a2320", 0.2),
            )
            meshes.append(wick)
            burn(x, y, 0.046, 0.022)
        title = "candle with three wicks in a bowl"
    else:  # a ball
        r = 0.042
        turns = np.linspace(0.35, 2.95, 9)
        profile = [(0, 0.0018)] + [(r * math.sin(a), r * 0.94 - r * math.cos(a)) for a in turns]
        profile.append((0, profile[-1][1]))
        meshes.append(lathe(profile, 18, mats=[wax]))
        z = profile[-1][1]
        meshes.append(
            tube(
                [(0, 0, z - 0.002), (0, 0, z + 0.006), (0.0012, 0, z + 0.01)],
                0.0013,
                4,
                mat=plain("2a2320", 0.2),
            )
        )
        pieces.append(meshes[0].v.copy())
        burn(0, 0, z + 0.002, 0.008)
        title = "ball candle"
    return lit_model(title, meshes, fire, glow, pieces)


def any_candle(kind="candle", **parameters) -> Model:
    """A single candle, or one of several (kind: "candles")."""
    if kind == "candles":
        keys = ("style", "colour", "second", "look")
        return candles(**{k: v for k, v in parameters.items() if k in keys})
    return candle(**{k: v for k, v in parameters.items() if k not in ("second", "look")})


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
        any_candle,
        candle_random,
        count=8,
        presets=[
            {"style": "pillar", "colour": "#f3e7cf"},
            {"style": "jar", "colour": "#7d62b4", "height": 0.09, "radius": 0.034},
            {"style": "taper", "colour": "#f3e7cf"},
            {"kind": "candles", "style": "trio", "colour": "#e9dcc0"},
            {"kind": "candles", "style": "candelabra", "colour": "#f6f0e2"},
            {"kind": "candles", "style": "tealights", "colour": "#fbf8f0"},
            {"kind": "candles", "style": "bowl", "colour": "#efe2c8", "second": "#3f6f6a"},
            {"kind": "candles", "style": "ball", "colour": "#a8262c"},
        ],
    ),
}
