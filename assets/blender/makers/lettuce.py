"""Lettuce: open heads, iceberg balls, hearts of romaine, loose leaves; fresh, overripe, rotten."""

from __future__ import annotations

import math

import numpy as np
from toolkit import labels
from toolkit.materials import Material, blend
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model
from toolkit.sampling import noise_offset, seed_of, uniform
from toolkit.shapes import ellipsoid

from makers import produce_faces as faces
from makers.produce_kit import (
    cut_face,
    footed,
    fresh_produce,
    ground,
    halve,
    matured,
    one_hull,
    spread,
)

LETTUCES = {
    "green": ("#4f9a2c", "#8fc84a", "#e8f4c0"),
    "red": ("#6a2438", "#7a9a3a", "#e0e8b0"),
    "pale": ("#86b84a", "#b8d878", "#f0f6d4"),
}
# tiers of leaves: how many, (distance, height) along a leaf, half widths
HEAD = [
    (
        6,
        ((0.012, 0.004), (0.064, 0.012), (0.106, 0.042), (0.122, 0.088)),
        (0.022, 0.06, 0.084, 0.06),
    ),
    (4, ((0.014, 0.01), (0.066, 0.034), (0.084, 0.08), (0.078, 0.126)), (0.022, 0.064, 0.08, 0.05)),
]
ROMAINE = [
    (5, ((0.012, 0.0), (0.036, 0.08), (0.05, 0.17), (0.062, 0.24)), (0.016, 0.034, 0.052, 0.03)),
    (4, ((0.008, 0.0), (0.024, 0.08), (0.03, 0.17), (0.03, 0.235)), (0.014, 0.03, 0.042, 0.026)),
]
HEARTS = [
    (4, ((0.012, 0.0), (0.036, 0.08), (0.046, 0.15), (0.03, 0.21)), (0.018, 0.044, 0.05, 0.02)),
    (2, ((0.008, 0.0), (0.024, 0.08), (0.03, 0.16), (0.012, 0.235)), (0.014, 0.034, 0.04, 0.016)),
]
WRAP = [
    (4, ((0.014, 0.0), (0.076, 0.03), (0.088, 0.075), (0.076, 0.125)), (0.02, 0.07, 0.085, 0.06)),
]


def leaf_picture(edge: str, middle: str, vein: str):
    """A leaf from its pale foot (bottom) to its frilly edge (top), with branching veins."""
    from PIL import ImageDraw

    image = labels.gradient(128, 128, edge, middle)
    d = ImageDraw.Draw(image)
    d.polygon([(48, 128), (80, 128), (68, 16), (60, 16)], fill=vein)
    for k in range(5):
        y = 112 - 20 * k
        for side in (-1, 1):
            x = 64 + side * (48 - 3 * k)
            d.line((64, y, 64 + side * 24, y - 15, x, y - 24), fill=vein, width=4 - k // 2)
    return image


def labels_hex(colour) -> str:
    return "#" + "".join(f"{round(255 * v):02x}" for v in colour)


def sheet_leaf(
    path, widths, turn: float, mat, ruffle: float, cup: float, phase: float, columns=6
) -> Mesh:
    """A double-sided leaf that leaves the axis at angle `turn`; cup > 0 wraps its edges inwards."""
    nu = columns
    points, uv = [], []
    out = np.array([math.cos(turn), math.sin(turn), 0])
    across = np.array([-math.sin(turn), math.cos(turn), 0])
    for j, ((q, z), w) in enumerate(zip(path, widths, strict=True)):
        v = j / (len(path) - 1)
        for i in range(nu):
            u = 2 * i / (nu - 1) - 1
            wave = ruffle * v * v * (1 if i % 2 else -1) * (0.7 + 0.3 * math.sin(phase + 3 * u))
            p = out * (q - cup * w * u * u + wave) + across * u * w
            p[2] = z - 0.5 * w * u * u * v**3 + wave * 0.35
            points.append(p)
            uv.append((0.5 + u / 2, v))
    quads = [
        (j * nu + i, j * nu + i + 1, (j + 1) * nu + i + 1, (j + 1) * nu + i)
        for j in range(len(path) - 1)
        for i in range(nu - 1)
    ]
    n = len(points)
    back = [tuple(p - out * 0.0012 + np.array([0, 0, 0.0008])) for p in points]
    both = quads + [tuple(i + n for i in f[::-1]) for f in quads]
    return Mesh([*points, *back], both, None, [mat], [[uv[i % n] for i in f] for f in both])


def lettuce(form="head", size=1.0, kind="green", seed=0) -> Model:
    """An open head, an iceberg (whole or halved), romaine, or some leaves."""
    rng = np.random.default_rng(seed)
    o, s = noise_offset(rng), size
    edge, middle, vein = LETTUCES[kind]
    shift = rng.uniform(0, 6.28, 30)
    around = [(math.cos(a), math.sin(a)) for a in (0.35, 1.5, 2.6, 3.7, 4.8, 5.9)]
    if form in ("romaine", "hearts"):
        spots = [(0.05 * x, 0.05 * y, 0.06 + 0.03 * i) for i, (x, y) in enumerate(around)]
        spots += [(0.04 * y, 0.05 * abs(x), 0.2 - 0.03 * i) for i, (x, y) in enumerate(around[:4])]
    elif form in ("iceberg", "half"):
        spots = [(0.075 * x, 0.075 * y, 0.07 + 0.035 * (i % 2)) for i, (x, y) in enumerate(around)]
    elif form == "leaves":
        spots = [(0.06, -0.06, 0.02), (0.0, -0.055, 0.02), (-0.06, 0.07, 0.03, 0.8)]
        spots += [(0.05, 0.06, 0.03, 0.7), (0.0, 0.02, 0.03, 0.6), (-0.02, 0.09, 0.02, 0.6)]
    else:
        spots = [(0.118 * x, 0.118 * y, 0.048, 0.9) for x, y in around[::2]]
        spots += [(0.085 * x, 0.085 * y, 0.075, 0.9) for x, y in around[1::2]]
        spots += [(0.085 * x, 0.085 * y, 0.025, 0.7) for x, y in around[1::2]]
        spots += [(0.03, 0.02, 0.115, 0.8), (-0.03, -0.01, 0.115, 0.7), (0.0, -0.04, 0.11, 0.6)]
    spots = [(*(np.array(p[:3]) * s), *p[3:]) for p in spots]

    def leaf_mat(look: str, tier: int) -> Material:
        m = Material(occlusion=0.35)
        pale = 0.0 if form in ("iceberg", "leaves") else 0.25 * tier
        tones = [labels_hex(blend(t, vein, pale)) for t in (edge, middle)]
        c = m.image(leaf_picture(*tones, vein))
        c = m.mix(m.remap(m.noise(50, 3, offset=o), 0.42, 0.65, 0, 0.3), c, edge)
        if look == "overripe":
            c = m.mix(0.5, c, "d8c04a")
        return m.colour(matured(look, m, c, 0.056 * s, spots, o, "2a1c0e", 0.6))

    def tiers(look: str, plan, ruffle: float, cup: float) -> list[Mesh]:
        out, k = [], 0
        low = {"fresh": 1.0, "overripe": 0.84, "rotten": 0.66}[look]
        wide = {"fresh": 1.0, "overripe": 1.05, "rotten": 1.02}[look]
        for tier, (count, path, widths) in enumerate(plan):
            mat = leaf_mat(look, tier)
            for i in range(count):
                a = math.tau * (i + 0.5 * tier) / count + 0.12 * math.sin(shift[k])
                grow = 1 + 0.06 * math.sin(2 * shift[k])
                bent = [(q * wide * s * grow, z * low * s * grow) for q, z in path]
                broad = [w * s for w in widths]
                cupped = cup + 0.2 * tier
                out.append(
                    sheet_leaf(
                        bent,
                        broad,
                        a,
                        mat,
                        ruffle * s,
                        cupped,
                        shift[k],
                        6 if tier == 0 and plan is not HEARTS else 5,
                    )
                )
                k += 1
        return out

    def ball(look: str, n=16, rows=10) -> Mesh:
        k = {"fresh": 1.0, "overripe": 0.95, "rotten": 0.86}[look]
        m = Material(occlusion=0.8)
        c = m.mix(m.remap(m.noise(22, 3, offset=o), 0.35, 0.65), middle, blend(middle, vein, 0.5))
        c = m.mix(m.remap(m.noise(1, 2, 0.5, 1.2, o, (60, 60, 9)), 0.55, 0.63, 0, 0.8), c, vein)
        if look == "overripe":
            c = m.mix(0.5, c, "d8c04a")
        m.colour(matured(look, m, c, 0.056 * s, spots, o, "2a1c0e", 0.6))
        return ellipsoid(
            (0.078 * s * k, 0.078 * s * k, 0.068 * s * k), (0, 0, 0.068 * s), n, rows, m
        )

    def loose(look: str) -> list[Mesh]:
        mat, out = leaf_mat(look, 0), []
        bow = 1.0 if look == "fresh" else 0.7
        for i, (x, y, yaw, k) in enumerate(
            ((0.02, -0.06, 0.2, 1.0), (-0.03, 0.045, 2.3, 1.1), (0.055, 0.06, -0.9, 0.85))
        ):
            path = [(-0.07, 0.004), (-0.02, 0.02 * bow), (0.03, 0.026 * bow), (0.075, 0.014)]
            path = [(q * k * s, z * s + 0.006 * i) for q, z in path]
            widths = [0.014 * s, 0.04 * s * k, 0.055 * s * k, 0.038 * s * k]
            out.append(
                sheet_leaf(path, widths, yaw, mat, 0.012 * s, 0.0, shift[i]).move(x * s, y * s)
            )
        return ground(out)

    def shape(look: str) -> list[Mesh]:
        if form == "iceberg":
            return ground([ball(look), *tiers(look, WRAP, 0.006, 0.5)])
        if form == "half":
            face = cut_face(
                look,
                faces.leaves_face(),
                0.05 * s,
                [(0.03, 0, 0.09, 0.9), (-0.03, 0, 0.04, 0.8)],
                o,
                "4a3014",
                0.5,
            )
            mesh = halve(ball(look), (0, 0, 0), (0, 1, 0), face).keep_pattern()
            return ground([mesh.turn(rx=math.pi / 2).turn(ry=0.5).turn(rz=0.3)])
        if form in ("romaine", "hearts"):
            one = [
                m.keep_pattern()
                for m in tiers(look, ROMAINE if form == "romaine" else HEARTS, 0.007, 0.45)
            ]
            one = ground([m.move(z=-0.115 * s).turn(rx=math.pi / 2) for m in one])
            if form == "romaine":
                return [m.turn(rz=0.35) for m in one]
            return spread(one, [(-0.045 * s, 0, 0, 0.1), (0.05 * s, 0.01, 0, -0.2)])
        if form == "leaves":
            return loose(look)
        heart = ball(look, 13, 8)
        heart.v = (heart.v - [0, 0, 0.068 * s]) * [0.86, 0.86, 0.94] + [0, 0, 0.072 * s]
        return ground([heart, *tiers(look, HEAD, 0.008, 0.25)])

    title = {
        "iceberg": "iceberg lettuce",
        "half": "half a lettuce",
        "romaine": "romaine lettuce",
        "leaves": "lettuce leaves",
    }.get(form, f"head of {kind} lettuce")
    mass = {"half": 0.3, "leaves": 0.15, "iceberg": 0.5, "hearts": 0.3}.get(form, 0.35)
    model = fresh_produce(
        title, shape, mass, footed if form == "half" else one_hull, 256 if form == "head" else 128
    )
    for part in model.parts.values():
        part.open = True  # leaves curl away from one another: their backs show in the gaps
    return model


def lettuce_random(rng: np.random.Generator) -> dict:
    return {"size": uniform(rng, 0.95, 1.1), "seed": seed_of(rng)}


MODELS = {
    "lettuce": Maker(
        lettuce,
        lettuce_random,
        count=7,
        presets=[
            {"size": 1.0, "seed": 1},
            {"size": 1.0, "seed": 1, "kind": "red"},
            {"form": "iceberg", "kind": "pale"},
            {"form": "half", "kind": "pale"},
            {"form": "romaine"},
            {"form": "leaves"},
            {"form": "hearts", "kind": "pale", "size": 0.66},
        ],
    ),
}
