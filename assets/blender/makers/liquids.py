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
    "wine": ("#84162c", "#5c0c1a", "#2b030a", "#f8dcdc", 0.94),
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
    return picture


def puddle(liquid="water", radius=0.16, drops=5, stretch=1.25, seed=0) -> Model:
    """A spill with a rounded rim and some drops around it."""
    rng = np.random.default_rng(seed)
    phase, size = rng.uniform(0, 6.28, 6), rng.uniform(0.5, 1, 6)

    def outline(a: float) -> float:
        waves = ((0.17, 2), (0.13, 3), (0.08, 5), (0.045, 8))
        wave = 1 + sum(s * size[k] * math.sin(f * a + phase[k]) for k, (s, f) in enumerate(waves))
        return wave * math.hypot(math.cos(a) * stretch, math.sin(a) / stretch)

    pools: list[Pool] = [(0.0, 0.0, radius, outline, 48)]
    shore = np.array(ring(pools[0], 1.0, 90))
    for _ in range(drops * 8):
        a, r, turn = (
            uniform(rng, 0, 2 * math.pi),
            radius * uniform(rng, 0.05, 0.14),
            uniform(rng, 0, 6.28),
        )
        away = radius * outline(a) + r * 1.2 + radius * uniform(rng, 0.04, 0.3)
        x, y = away * math.cos(a), away * math.sin(a)
        apart = all(math.hypot(x - p[0], y - p[1]) > r + p[2] + 0.004 for p in pools[1:])
        if apart and np.hypot(*(shore - [x, y]).T).min() > r * 1.15:
            pools.append((x, y, r, lambda t, w=turn: 1 + 0.12 * math.sin(2 * t + w), 14))
        if len(pools) > drops:
            break
    points = np.concatenate([ring(p, 1.0) for p in pools])
    low, high = points.min(0), points.max(0)
    span = float((high - low).max()) * 1.02
    window = (float((low + high)[0] / 2 - span / 2), float((low + high)[1] / 2 - span / 2), span)
    material = label(paint(pools, liquid, window, rng), occlusion=0.0)
    meshes = [pool_mesh(p, 0.0035 if k == 0 else 0.0028, window) for k, p in enumerate(pools)]
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
    )


def puddle_random(rng: np.random.Generator) -> dict:
    return {
        "liquid": pick(rng, list(LIQUIDS)),
        "radius": uniform(rng, 0.09, 0.18),
        "drops": int(rng.integers(3, 8)),
        "stretch": uniform(rng, 1.0, 1.35),
        "seed": seed_of(rng),
    }


MODELS = {
    "puddle": Maker(
        puddle,
        puddle_random,
        count=7,
        presets=[
            {"liquid": "water", "radius": 0.17},
            {"liquid": "milk", "radius": 0.13},
            {"liquid": "juice", "radius": 0.11},
            {"liquid": "coffee", "radius": 0.09},
            {"liquid": "wine", "radius": 0.1},
            {"liquid": "water", "radius": 0.1},
            {"liquid": "milk", "radius": 0.09},
        ],
    ),
}
