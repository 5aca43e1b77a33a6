"""Spills on the floor or a table."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
from PIL import Image, ImageChops, ImageDraw, ImageFilter
from toolkit.materials import label
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part
from toolkit.sampling import pick, seed_of, uniform
from toolkit.shapes import loft

PIXELS = 512
LIGHT_FROM = 2.2  # where painted reflections sit, an angle in the plane

# liquid: (shallow, deep, rim, reflection, opacity)
LIQUIDS = {
    "water": ("#8094a0", "#6a808d", "#3a515f", "#ffffff", 0.64),
    "milk": ("#f8f6f0", "#efebdf", "#c9c2b0", "#ffffff", 0.97),
    "juice": ("#f7a823", "#ea8f10", "#a85a06", "#fff6dc", 0.92),
    "coffee": ("#4f2d15", "#361b0a", "#1a0c04", "#f0e0cc", 0.94),
    "oil": ("#e0b83a", "#c8981c", "#8a6408", "#fffbe0", 0.8),
    "soup": ("#d8502a", "#c23c18", "#7a1e08", "#fbe0d0", 0.97),
    "paint": ("#2f6fd0", "#2660c0", "#143a80", "#dcecff", 0.999),
    "detergent": ("#3aa0e0", "#1f80c8", "#0c4a80", "#f4fcff", 0.85),
    "wine": ("#84162c", "#5c0c1a", "#2b030a", "#f8dcdc", 0.94),
    "coffee with milk": ("#a97a4c", "#95673a", "#5c3a1a", "#fff4e4", 0.96),
    "cola": ("#40200f", "#281006", "#140703", "#f4dcc4", 0.93),
    "olive oil": ("#c8b434", "#ab961a", "#6a5a08", "#fdfbe0", 0.82),
    "tomato sauce": ("#cc2c14", "#b01e0a", "#6c0e04", "#ffd4c4", 0.999),
    "pumpkin soup": ("#f0a030", "#dd8818", "#8c4c08", "#fff0d4", 0.98),
    "pea soup": ("#9db44c", "#839a32", "#4a5a18", "#f6fade", 0.98),
    "green detergent": ("#62cc7e", "#3cb45e", "#166c3c", "#f2fff6", 0.85),
    "green paint": ("#2f9c4c", "#268a40", "#12542a", "#dcf6e2", 0.999),
    "yellow paint": ("#f4c820", "#e8b80e", "#98740a", "#fff8d4", 0.999),
}
#: What floats in a liquid: colours of its pieces and of their outlines; bubbles without pieces.
BITS: dict[str, tuple[tuple[str, ...], str]] = {
    "soup": (("#f0a040", "#5f9a34", "#f4e2b0"), "#8a2c10"),
    "pumpkin soup": (("#f8c060", "#5f9a34", "#fff0d0"), "#b06a14"),
    "pea soup": (("#f08a30", "#5a7a24", "#d8e08c"), "#566a20"),
    "tomato sauce": (("#e04a28", "#3f7a2c", "#8f1606"), "#7a1206"),
    "detergent": ((), "#f4fcff"),
    "green detergent": ((), "#f4fff8"),
    "cola": ((), "#c8a488"),
}

Outline = Callable[[float], float]
Pool = tuple[float, float, float, Outline, int]  # x, y, radius, outline(angle) -> factor, corners


def ring(
    pool: Pool, share: float, n: int | None = None, first=0.0, last=2 * math.pi
) -> list[tuple[float, float]]:
    """The pool's outline shrunk towards its centre, or a stretch of it."""
    x, y, radius, outline, corners = pool
    n = n or corners
    whole = last - first >= 2 * math.pi - 1e-9
    angles = [first + (last - first) * i / (n if whole else n - 1) for i in range(n)]
    return [
        (
            x + radius * outline(a) * share * math.cos(a),
            y + radius * outline(a) * share * math.sin(a),
        )
        for a in angles
    ]


def pool_mesh(pool: Pool, height: float, window: tuple[float, float, float]) -> Mesh:
    """A flat drop with a rounded edge; its label UV is the plane seen from above."""
    levels = [(1.0, 0.0), (0.98, height * 0.7), (0.93, height)]
    rings = [np.array([(x, y, z) for x, y in ring(pool, share)]) for share, z in levels]
    mesh = loft(rings)
    under = next(k for k, face in enumerate(mesh.f) if len(face) > 4 and mesh.v[face[0]][2] == 0)
    mesh.keep_faces([k for k in range(len(mesh.f)) if k != under])
    left, low, size = window
    plane = [
        [((mesh.v[i][0] - left) / size, (mesh.v[i][1] - low) / size) for i in face]
        for face in mesh.f
    ]
    mesh.label_uv, mesh.bake_uv = plane, [[(u * size, v * size) for u, v in face] for face in plane]
    return mesh


def paint(pools: list[Pool], liquid: str, window: tuple[float, float, float], rng) -> Image.Image:
    """The spill from above: deep and shallow, a dark rim, crescent reflections along the edge."""
    shallow, deep, rim, glint, _ = LIQUIDS[liquid]
    left, low, size = window

    def pixels(points):
        return [((x - left) / size * PIXELS, (1 - (y - low) / size) * PIXELS) for x, y in points]

    def mask(shapes, blur: float) -> Image.Image:
        image = Image.new("L", (PIXELS, PIXELS), 0)
        draw = ImageDraw.Draw(image)
        for shape, value in shapes:
            draw.polygon(pixels(shape), fill=value)
        return image.filter(ImageFilter.GaussianBlur(blur))

    picture = Image.new("RGB", (PIXELS, PIXELS), rim)
    main_radius = max(p[2] for p in pools) / size * PIXELS
    body = mask([(ring(p, 0.93), 255) for p in pools], main_radius * 0.025)
    picture.paste(Image.new("RGB", picture.size, shallow), (0, 0), body)
    depth = mask([(ring(p, 0.6), 255) for p in pools], main_radius * 0.14)
    picture.paste(Image.new("RGB", picture.size, deep), (0, 0), depth)
    crescents = []
    for k, pool in enumerate(pools):
        large = k == 0
        spans = [
            (LIGHT_FROM, 1.5, 0.88, 0.8),
            (LIGHT_FROM + 0.25, 0.8, 0.72, 0.69),
            (LIGHT_FROM + math.pi, 0.9, 0.9, 0.865),
        ]
        if large:
            spans.append((LIGHT_FROM - 1.3, 0.35, 0.84, 0.79))
        for middle, width, outer, inner in spans if large else [(LIGHT_FROM, 1.8, 0.8, 0.5)]:
            middle += float(rng.normal(0, 0.15)) if large else 0
            steps = np.linspace(-1, 1, 24)
            angles = [middle + width / 2 * t for t in steps]
            thick = [
                (outer - inner) * math.sqrt(max(0, 1 - t * t)) for t in steps
            ]  # pointed at both ends
            x, y, radius, outline, _ = pool
            edge = [
                (
                    x + radius * outline(a) * outer * math.cos(a),
                    y + radius * outline(a) * outer * math.sin(a),
                )
                for a in angles
            ]
            back = [
                (
                    x + radius * outline(a) * (outer - t) * math.cos(a),
                    y + radius * outline(a) * (outer - t) * math.sin(a),
                )
                for a, t in zip(angles, thick, strict=True)
            ]
            crescents.append((edge + back[::-1], 250 if outer != 0.9 else 150))
    shine = mask(crescents, 2.2)
    sky = mask(
        [
            (
                ring(
                    (
                        x + r * 0.16 * math.cos(LIGHT_FROM),
                        y + r * 0.16 * math.sin(LIGHT_FROM),
                        r,
                        o,
                        n,
                    ),
                    0.5,
                ),
                90,
            )
            for x, y, r, o, n in pools[:1]
        ],
        main_radius * 0.12,
    )
    shine = ImageChops.lighter(shine, sky)
    picture.paste(Image.new("RGB", picture.size, glint), (0, 0), shine)
    if liquid in BITS:
        add_bits(picture, liquid, pools, pixels, rng)
    return picture


def add_bits(picture: Image.Image, liquid: str, pools: list[Pool], pixels, rng) -> None:
    """Vegetables and herbs in soup, bubbles in detergent."""
    draw = ImageDraw.Draw(picture)
    pieces, edge = BITS[liquid]
    x, y, radius, outline, _ = pools[0]
    for k in range(26):
        a, share = float(rng.uniform(0, 6.28)), math.sqrt(float(rng.uniform(0.02, 0.72)))
        far = radius * outline(a) * share
        cx, cy = pixels([(x + far * math.cos(a), y + far * math.sin(a))])[0]
        r = float(rng.uniform(6, 15))
        box = (cx - r, cy - r * 0.8, cx + r, cy + r * 0.8)
        if pieces:
            draw.ellipse(box, fill=pieces[k % len(pieces)], outline=edge)
        else:
            draw.ellipse(box, outline=edge, width=3)


def wavy(rng: np.random.Generator, stretch: float, form: str) -> Outline:
    """The outline of a pool: lobed, nearly round, drawn out to a run, or spiky as it splashed."""
    phase, size = rng.uniform(0, 6.28, 6), rng.uniform(0.5, 1, 6)
    waves = {
        "round": ((0.035, 2), (0.03, 3), (0.015, 5)),
        "run": ((0.06, 2), (0.07, 3), (0.05, 5), (0.03, 9)),
        "splash": ((0.1, 3), (0.13, 7), (0.14, 11), (0.06, 17)),
    }.get(form, ((0.17, 2), (0.13, 3), (0.08, 5), (0.045, 8)))

    def outline(a: float) -> float:
        wave = 1 + sum(s * size[k] * math.sin(f * a + phase[k]) for k, (s, f) in enumerate(waves))
        if form == "run":
            return wave / math.hypot(math.cos(a) / stretch, math.sin(a) * stretch)
        return wave * math.hypot(math.cos(a) * stretch, math.sin(a) / stretch)

    return outline


def puddle(
    liquid="water", radius=0.16, drops=5, stretch=1.25, form="pool", seed=0, deep=0.0035, pixels=256
) -> Model:
    """A spill with a rounded rim and some drops around it.

    form: "pool", "round", "run" (drawn out), "splash", "twin" (two pools) or "trail" (drips).
    """
    rng = np.random.default_rng(seed)
    outline = wavy(rng, stretch, form)
    pools: list[Pool] = [(0.0, 0.0, radius, outline, 48 if form != "splash" else 64)]
    if form == "twin":
        other = wavy(rng, 1.05, "round")
        away = radius * (outline(0.5) + 0.72)
        pools.append((away * math.cos(0.5), away * math.sin(0.5), 0.6 * radius, other, 32))
    if form == "trail":
        away, turn = radius * outline(0.0), 0.0
        for k in range(9):
            r = radius * (0.34 - 0.024 * k) * uniform(rng, 0.8, 1.2)
            away, turn = (
                away + r + radius * uniform(rng, 0.12, 0.4),
                turn + uniform(rng, -0.03, 0.09),
            )
            drop = wavy(rng, 1.08, "round")
            pools.append((away * math.cos(turn), away * math.sin(turn), r, drop, 10))
            away += r
    kept = len(pools)
    shore = np.concatenate([ring(p, 1.0, 90) for p in pools])
    for _ in range(drops * 8):
        a, r, turn = (
            uniform(rng, 0, 2 * math.pi),
            radius * uniform(rng, 0.05, 0.14),
            uniform(rng, 0, 6.28),
        )
        away = radius * outline(a) + r * 1.2 + radius * uniform(rng, 0.04, 0.3)
        x, y = away * math.cos(a), away * math.sin(a)
        apart = all(math.hypot(x - p[0], y - p[1]) > r + p[2] + 0.004 for p in pools[kept:])
        if apart and np.hypot(*(shore - [x, y]).T).min() > r * 1.15:
            pools.append((x, y, r, lambda t, w=turn: 1 + 0.12 * math.sin(2 * t + w), 14))
        if len(pools) > drops + kept - 1:
            break
    points = np.concatenate([ring(p, 1.0) for p in pools])
    low, high = points.min(0), points.max(0)
    span = float((high - low).max()) * 1.02
    window = (float((low + high)[0] / 2 - span / 2), float((low + high)[1] / 2 - span / 2), span)
    material = label(paint(pools, liquid, window, rng), occlusion=0.0)
    meshes = [pool_mesh(p, deep if k == 0 else 0.8 * deep, window) for k, p in enumerate(pools)]
    for mesh in meshes:
        mesh.mats = [material]
    gain = (
        1.3 if liquid == "water" else 1.0
    )  # keeps reflections white although half of the floor shows
    part = Part(meshes, rgba=(gain, gain, gain, LIQUIDS[liquid][4]), collision="hull")
    states = [
        {"state": s, "variants": ["default"], "parts": ["liquid"]} for s in ("SPILLED", "WET")
    ]
    return Model(
        title=f"puddle of {liquid}",
        parts={"liquid": part},
        states=states,
        mass=0.1,
        friction=0.15,
        prune=False,
        texture_size=pixels,
    )


def puddle_random(rng: np.random.Generator) -> dict:
    return {
        "liquid": pick(rng, list(LIQUIDS)),
        "radius": uniform(rng, 0.09, 0.18),
        "drops": int(rng.integers(3, 8)),
        "stretch": uniform(rng, 1.0, 1.35),
        "seed": seed_of(rng),
    }


def was_puddle(
    liquid: str, radius: float, drops: int, stretch: float, seed: int, form="pool"
) -> dict:
    """The preset of a model that was made as a `puddle`, whose numbers were drawn for that."""
    numbers = {"radius": radius, "drops": drops, "stretch": stretch, "seed": seed}
    return {"liquid": liquid, "form": form, **numbers}


def of(liquid: str, form: str, radius: float, stretch: float, drops: int, **more) -> dict:
    """The preset of a puddle with a small texture."""
    numbers = {"radius": radius, "stretch": stretch, "drops": drops}
    return {"liquid": liquid, "form": form, "pixels": 128, **numbers, **more}


#: Of its first fifteen models those of other liquids have categories of their own now.
PUDDLES = [
    {"liquid": "water", "radius": 0.17},
    {},
    {},
    {},
    {},
    {"liquid": "water", "radius": 0.1},
    *[{}] * 8,
    {"liquid": "water", "radius": 0.15, "form": "twin", "stretch": 1.2, "drops": 4},
    of("water", "splash", 0.13, 1.1, 6),
    of("water", "trail", 0.12, 1.2, 0),
]


def spilled(*presets: dict) -> Maker:
    return Maker(puddle, puddle_random, len(presets), list(presets))


MODELS = {
    "puddle": Maker(puddle, puddle_random, len(PUDDLES), PUDDLES, (*range(2, 6), *range(7, 15))),
    "milk_puddle": spilled(
        was_puddle("milk", 0.13, 6, 1.0776595446118802, 789630863),
        was_puddle("milk", 0.09, 4, 1.0525726001036737, 123265939),
        of("milk", "splash", 0.12, 1.15, 7),
        of("milk", "run", 0.11, 1.6, 4),
    ),
    "juice_puddle": spilled(
        was_puddle("juice", 0.11, 5, 1.0934601081420232, 369195149),
        was_puddle("juice", 0.1, 4, 1.55, 882429363, "run"),
        of("juice", "splash", 0.12, 1.1, 6),
        of("juice", "twin", 0.1, 1.2, 4),
    ),
    "coffee_puddle": spilled(
        was_puddle("coffee", 0.09, 3, 1.3423230600529017, 666221986),
        was_puddle("coffee", 0.1, 1, 1.1, 659110214, "trail"),
        of("coffee with milk", "splash", 0.11, 1.1, 7),
        of("coffee", "round", 0.1, 1.1, 5),
    ),
    "wine_puddle": spilled(
        was_puddle("wine", 0.1, 3, 1.342025275320939, 705827486),
        was_puddle("wine", 0.12, 7, 1.2, 856039904, "splash"),
        of("wine", "run", 0.1, 1.6, 4),
        of("wine", "twin", 0.11, 1.15, 4),
    ),
    "oil_puddle": spilled(
        was_puddle("oil", 0.12, 2, 1.0, 180445134, "round"),
        of("olive oil", "twin", 0.11, 1.1, 3),
        of("oil", "run", 0.11, 1.5, 2),
        of("olive oil", "round", 0.12, 1.15, 4),
    ),
    "soup_puddle": spilled(
        was_puddle("soup", 0.13, 7, 1.05, 91885628, "splash"),
        of("pumpkin soup", "pool", 0.11, 1.15, 5, deep=0.005),
        of("pea soup", "splash", 0.12, 1.1, 6, deep=0.005),
    ),
    "paint_puddle": spilled(
        was_puddle("paint", 0.11, 3, 1.7, 384954563, "run"),
        of("green paint", "splash", 0.12, 1.1, 6),
        of("yellow paint", "trail", 0.1, 1.1, 1),
        of("paint", "round", 0.11, 1.1, 5),
    ),
    "detergent_puddle": spilled(
        was_puddle("detergent", 0.12, 3, 1.1, 464672674, "twin"),
        of("green detergent", "round", 0.12, 1.1, 3, deep=0.005),
        of("detergent", "run", 0.11, 1.5, 3),
        of("green detergent", "splash", 0.11, 1.15, 6),
    ),
    "cola_puddle": spilled(
        of("cola", "pool", 0.12, 1.15, 5),
        of("cola", "splash", 0.11, 1.1, 7),
        of("cola", "run", 0.11, 1.6, 4),
    ),
    "tomato_sauce_puddle": spilled(
        of("tomato sauce", "splash", 0.11, 1.1, 7, deep=0.007),
        of("tomato sauce", "round", 0.1, 1.2, 5, deep=0.007),
        of("tomato sauce", "twin", 0.1, 1.1, 5, deep=0.007),
    ),
}
