"""Tea lights, scented candles in jars and candelabra; the `lit` variant adds their flames."""

from __future__ import annotations

import math

import numpy as np
from toolkit import labels
from toolkit.materials import Material, glowing, label, metal, plain, shade, wood
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part, box_piece, cylinder_piece
from toolkit.sampling import noise_offset, seed_of
from toolkit.shapes import box, lathe, tube

from makers.candles import SHINE, blend_warm, molten, small_flame

WICK = ("2a2320", 0.2, 300.0)


def alight(
    title: str, body: list[Mesh], fire: list[Mesh], glow: list[Mesh], pieces, mass: float, **more
) -> Model:
    """Something that may burn: OFF as it comes, ON with its flames.

    Of four flames and more each second one is `flame`, the part that has to be seen: a few pixels
    spread over all of them would not show that they burn.
    """
    share = 2 if len(fire) > 3 else 1
    parts = {
        "body": Part(body, collision=pieces),
        "flame": Part(fire[::share], rgba=SHINE, collision="none"),
        "glow": Part(glow, rgba=(1.25, 1.25, 1.25, 1.0), collision="none"),
    }
    if share > 1:
        parts["more_flames"] = Part(fire[1::share], rgba=SHINE, collision="none")
    return Model(
        title=title,
        parts=parts,
        variants={"default": ["body"], "lit": list(parts)},
        states=[
            {"state": "ON", "variants": ["lit"], "parts": ["flame"]},
            {"state": "OFF", "variants": ["default"], "parts": ["body"]},
        ],
        mass=mass,
        friction=0.6,
        texture_size=128,
        **more,
    )


def wick(z: float, high: float = 0.009) -> Mesh:
    """A charred wick about the z axis, three-sided: there may be several."""
    path = [(0, 0, z - 0.002), (0.0012, 0, z + high)]
    return tube(path, 0.0013, 3, mat=plain(*WICK))


def slim(r: float, h: float, z: float, wax: Material, n: int = 7) -> list[Mesh]:
    """A slender candle with its wick, standing on z."""
    profile = [(0, z), (r, z), (r, z + h - 0.002), (0.7 * r, z + h), (0, z + h)]
    return [lathe(profile, n, mat=wax), wick(z + h)]


def lit_end(r: float, top: float, long: float, n: int = 5) -> Mesh:
    """The upper end of a slender candle, which lets the light of its flame through."""
    m = glowing("ffd870")
    m.colour(m.ramp(m.remap(m.axis(2), top - long, top), [(0, "e0a860"), (1, "ffd870")]))
    return lathe([(r, top - long), (r, top), (0, top)], n, mat=m)


def placed(meshes: list[Mesh], x: float, y: float) -> list[Mesh]:
    return [mesh.keep_pattern().move(x, y, 0) for mesh in meshes]


def waxen(colour: str, o) -> Material:
    wax = Material(occlusion=0.45)
    return wax.colour(wax.mottle(colour, 0.05, 50, o))


# ---- tea lights
def tin(z: float, wax: str, o, n: int = 14) -> list[Mesh]:
    """The aluminium cup of a tea light, its wax and its wick, standing on z."""
    silver = metal("c4c8cc", "80868c")
    top = plain(shade(wax, 0.96), 0.03, 60, o, occlusion=0.4)
    profile = [(0, 0), (0.0188, 0), (0.0195, 0.002), (0.0195, 0.016), (0.0178, 0.0165)]
    profile += [(0.0172, 0.0135), (0, 0.0135)]
    cup = lathe(
        [(r, q + z) for r, q in profile],
        n,
        mats=[silver, top],
        mat_of_segment=[0, 0, 0, 0, 0, 1],
    )
    return [cup, wick(z + 0.0135)]


def burning(z: float, colour: str, pool: float, high=0.042, n: int = 8) -> tuple[Mesh, Mesh]:
    """Flame and molten wax above wax that ends at z."""
    return small_flame(z + 0.004, high, min(n, 6)), molten(blend_warm(colour), z + 0.0007, pool, n)


def tea_light(holder="glass", tone="#b8403c", wax="#f8f3e6", seed=0) -> Model:
    """holder: "glass" (a low votive), "stone" (a block), "board" (three on wood), "flower"."""
    o = noise_offset(np.random.default_rng(seed))
    body: list[Mesh] = []
    fire: list[Mesh] = []
    glow: list[Mesh] = []

    def light(x: float, y: float, z: float, n: int = 14) -> None:
        body.extend(placed(tin(z, wax, o, n), x, y))
        flame, pool = placed([*burning(z + 0.0135, wax, 0.0155)], x, y)
        fire.append(flame)
        glow.append(pool)

    if holder == "glass":
        glass = Material(occlusion=0.5)
        height = glass.remap(glass.axis(2), 0, 0.04)
        stops = [(0, shade(tone, 0.7)), (0.15, tone), (0.8, tone), (1, shade(tone, 1.5))]
        glass.colour(glass.ramp(height, stops))
        cup = [(0, 0), (0.026, 0), (0.03, 0.005), (0.034, 0.04), (0.031, 0.04), (0.027, 0.014)]
        body.append(lathe([*cup, (0, 0.014)], 18, mat=glass))
        light(0, 0, 0.014)
        pieces, title, mass = [cylinder_piece(0.028, 0, 0.04, 12, 0.034)], "in a glass", 0.12
    elif holder == "stone":
        rock = Material(occlusion=0.7)
        veins = rock.remap(rock.noise(26, 5, 0.6, 1.2, o), 0.3, 0.7)
        rock.colour(rock.mix(veins, shade(tone, 0.72), shade(tone, 1.12)))
        body.append(box(0.078, 0.078, 0.046, mat=rock, bevel_width=0.006, segments=2))
        light(0, 0, 0.038)
        pieces, title, mass = [box_piece((0, 0, 0.023), (0.076, 0.076, 0.046))], "in a stone", 0.5
    elif holder == "board":
        body.append(box(0.07, 0.21, 0.014, mat=wood(tone, shade(tone, 0.6), 1), bevel_width=0.003))
        pieces = [box_piece((0, 0, 0.007), (0.068, 0.208, 0.014))]
        for y in (-0.066, 0.0, 0.066):
            light(0, y, 0.0142, 12)
            pieces.append(cylinder_piece(0.019, 0.014, 0.03, 10) + np.array([0, y, 0]))
        title, mass = "on a board", 0.3
    else:
        petals = plain(tone, 0.08, 50, o)
        profile = [(0, 0), (0.026, 0), (0.04, 0.012), (0.054, 0.034), (0.047, 0.034)]
        profile += [(0.031, 0.014), (0.024, 0.008), (0, 0.008)]
        body.append(
            lathe(
                profile,
                24,
                mat=petals,
                rib=lambda k, i: 1 - (0.16 if k in (3, 4) and i % 4 == 0 else 0),
            )
        )
        light(0, 0, 0.008)
        pieces, title, mass = [cylinder_piece(0.027, 0, 0.034, 12, 0.053)], "in a flower dish", 0.2
    lights = "three tea lights" if holder == "board" else "tea light"
    return alight(f"{lights} {title}", body, fire, glow, pieces, mass)


# ---- jars
def jar_label(words: str, paper: str, ink: str):
    """Twice around the jar: its name in a frame, a drop above it."""
    art, d = labels.canvas(768, 192)
    for cx in (192, 576):
        d.rounded_rectangle((cx - 112, 8, cx + 112, 184), 10, fill=paper, outline=ink, width=5)
        d.ellipse((cx - 15, 28, cx + 15, 62), fill=ink)
        d.polygon([(cx - 14, 40), (cx, 14), (cx + 14, 40)], fill=ink)
        labels.text(d, words, (cx - 100, 70, cx + 100, 128), "serif", ink)
        labels.text(d, "candle", (cx - 80, 132, cx + 80, 172), "italic", ink)
    return art


def jar_candle(
    form="tumbler", wax="#f0dfb8", words="VANILLA", glass="", paper="#fbf7ec", ink="#5b4a2a", seed=0
) -> Model:
    """Scented wax in a glass jar with a label: a "tumbler" or "wide" with three wicks.

    glass: the colour of the jar, "" for clear: then its wax shows.
    """
    o = noise_offset(np.random.default_rng(seed))
    r, h = (0.041, 0.088) if form == "tumbler" else (0.056, 0.072)
    level = h * 0.86
    tone = glass or shade(wax, 0.97)
    side = Material(occlusion=0.5)
    empty = shade(glass, 1.25) if glass else "d4e2e4"
    stops = [(0, shade(glass, 0.6) if glass else "a4b6bc"), (0.05, tone), (0.85, tone)]
    side.colour(side.ramp(side.remap(side.axis(2), 0, h), [*stops, (0.88, empty), (1, "f6fbfc")]))
    top = plain(shade(wax, 0.95), 0.03, 60, o, occlusion=0.5)
    z0, z1 = h * 0.16, h * 0.76
    profile = [(0, 0), (r * 0.94, 0), (r, 0.005), (r, z0), (r, z1), (r, h - 0.0008)]
    profile += [(r - 0.0012, h), (r - 0.0035, h - 0.001), (r - 0.0035, level), (0, level)]
    body = [
        lathe(
            profile,
            20,
            mats=[side, label(jar_label(words, paper, ink), tone), top],
            mat_of_segment=[0, 0, 0, 1, 0, 0, 0, 0, 2],
            label_z=(z0, z1),
            start=-math.pi / 2,
        )
    ]
    fire, glow = [], []
    wicks = 1 if form == "tumbler" else 3
    for k in range(wicks):
        away = 0.0 if wicks == 1 else r * 0.5
        x, y = away * math.cos(2.1 * k + 0.4), away * math.sin(2.1 * k + 0.4)
        pool = r * 0.72 if wicks == 1 else r * 0.34
        flame, melt = burning(level, wax, pool, 0.046, 14 if wicks == 1 else 8)
        body.extend(placed([wick(level)], x, y))
        fire.extend(placed([flame], x, y))
        glow.extend(placed([melt], x, y))
    title = "scented candle in a jar" if wicks == 1 else "scented candle with three wicks in a jar"
    return alight(title, body, fire, glow, [cylinder_piece(r, 0, h, 12)], 0.4)


# ---- candelabra
def candelabra(arms=5, form="curved", tone="brass", wax="#f6f0e2", seed=0) -> Model:
    """Slender candles on one foot: on "curved" arms or side by side on a "bar"."""
    o = noise_offset(np.random.default_rng(seed))
    finish = {
        "brass": ("d0a545", "8a6420"),
        "silver": ("c8ccd2", "767c84"),
        "iron": ("3c3f44", "1c1e22"),
    }[tone]
    stuff, candle = metal(*finish), waxen(wax, o)
    body, fire, glow, pieces = [], [], [], []
    step = 0.062 if form == "curved" else 0.056
    ys = [(k - (arms - 1) / 2) * step for k in range(arms)]
    if form == "curved":
        foot = [(0, 0), (0.06, 0), (0.061, 0.005), (0.03, 0.014), (0.01, 0.03), (0.008, 0.12)]
        foot += [(0.015, 0.13), (0.007, 0.142), (0.007, 0.2), (0, 0.2)]
        body.append(lathe(foot, 8, mat=stuff))
        pieces += [cylinder_piece(0.06, 0, 0.012), cylinder_piece(0.011, 0.01, 0.2, 8)]
        for y in ys:
            if y:
                arc = [(0, 0, 0.128), (0, y * 0.4, 0.104), (0, y * 0.85, 0.112), (0, y, 0.14)]
                arc.append((0, y, 0.173))
                body.append(tube(arc, 0.0048, 4, mat=stuff, up=(1.0, 0, 0)))
        tops = [0.2 if not y else 0.172 for y in ys]
    else:
        long = ys[-1] - ys[0] + 0.05
        body.append(box(0.07, long * 0.6, 0.012, mat=stuff, bevel_width=0.002))
        body.append(box(0.014, 0.014, 0.11, (0, 0, 0.01), stuff))
        body.append(box(0.016, long, 0.012, (0, 0, 0.115), stuff, 0.002))
        pieces += [
            box_piece((0, 0, 0.006), (0.068, long * 0.6, 0.012)),
            box_piece((0, 0, 0.065), (0.014, 0.014, 0.11)),
            box_piece((0, 0, 0.121), (0.016, long, 0.012)),
        ]
        tops = [0.126 for _ in ys]
    tall = 0.12
    for y, z in zip(ys, tops, strict=True):
        cup = [(0.004, z - 0.002), (0.017, z + 0.005), (0.0178, z + 0.009), (0, z + 0.009)]
        parts = [lathe(cup, 6, mat=stuff), *slim(0.0095, tall, z + 0.007, candle, 5)]
        body += placed(parts, 0, y)
        end = z + 0.007 + tall
        fire += placed([small_flame(end + 0.003, 0.044, 5)], 0, y)
        glow += placed([lit_end(0.0107, end + 0.0004, 0.024)], 0, y)
        pieces.append(cylinder_piece(0.013, z - 0.004, end, 8) + np.array([0, y, 0]))
    count = {3: "three", 4: "four", 5: "five"}[arms]
    return alight(f"{tone} candelabra with {count} candles", body, fire, glow, pieces, 1.1)


def seeded(rng: np.random.Generator) -> dict:
    return {"seed": seed_of(rng)}


MODELS = {
    "tea_light": Maker(
        tea_light,
        lambda rng: {"seed": 1},
        count=6,
        presets=[
            {"holder": "glass", "tone": "#b8403c"},
            {"holder": "glass", "tone": "#3f7f86"},
            {"holder": "stone", "tone": "#e0a890"},
            {"holder": "board", "tone": "#b98552"},
            {"holder": "flower", "tone": "#f2ece0"},
            {"holder": "flower", "tone": "#4f6f9a"},
        ],
    ),
    "jar_candle": Maker(
        jar_candle,
        lambda rng: {"seed": 2},
        count=6,
        presets=[
            {"wax": "#f2e4c2", "words": "VANILLA"},
            {"wax": "#b9a4d8", "words": "LAVENDER", "ink": "#4a3a78"},
            {"wax": "#e8d2a8", "words": "CEDAR", "glass": "#7a4216", "paper": "#f4ead2"},
            {"form": "wide", "wax": "#f4efe6", "words": "SEA SALT", "ink": "#2a5a6a"},
            {"form": "wide", "wax": "#d8848c", "words": "ROSE", "ink": "#7a2430"},
            {"wax": "#9ab89a", "words": "PINE", "ink": "#24502c"},
        ],
    ),
    "candelabra": Maker(
        candelabra,
        seeded,
        count=5,
        presets=[
            {"arms": 5, "form": "curved", "tone": "silver", "seed": 1},
            {"arms": 3, "form": "curved", "tone": "brass", "wax": "#f2e2c0", "seed": 2},
            {"arms": 4, "form": "bar", "tone": "iron", "wax": "#f6f0e2", "seed": 3},
            {"arms": 5, "form": "curved", "tone": "brass", "wax": "#a8262c", "seed": 1},
            {"arms": 4, "form": "bar", "tone": "iron", "wax": "#3f6a54", "seed": 3},
        ],
    ),
}
