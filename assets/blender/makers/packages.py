"""Cartons, boxes, tins, cups and trays with printed labels."""

from __future__ import annotations

import math

import numpy as np
from toolkit import labels
from toolkit.materials import label, plain
from toolkit.mesh import Mesh, bevel, cube_project
from toolkit.model import Model, Part
from toolkit.sampling import pick, seed_of, uniform
from toolkit.shapes import box, lathe


def cow(draw, cx: float, cy: float, s: float) -> None:
    """A simple cow's face."""
    for q in (-1, 1):
        draw.ellipse(
            (cx + (q * 0.7 - 0.25) * s, cy - 0.55 * s, cx + (q * 0.7 + 0.25) * s, cy - 0.2 * s),
            fill="#2b2b2b",
        )
        horn = [
            (cx + q * 0.45 * s, cy - 0.5 * s),
            (cx + q * 0.6 * s, cy - 0.95 * s),
            (cx + q * 0.25 * s, cy - 0.6 * s),
        ]
        draw.polygon(horn, fill="#e8d9a0")
    draw.ellipse(
        (cx - 0.55 * s, cy - 0.75 * s, cx + 0.55 * s, cy + 0.6 * s),
        fill="#fff",
        outline="#222",
        width=4,
    )
    draw.pieslice(
        (cx - 0.5 * s, cy - 0.7 * s, cx + 0.1 * s, cy + 0.1 * s), 150, 330, fill="#2b2b2b"
    )
    draw.ellipse(
        (cx - 0.45 * s, cy + 0.05 * s, cx + 0.45 * s, cy + 0.7 * s),
        fill="#f2a9a4",
        outline="#222",
        width=3,
    )
    for q in (-1, 1):
        eye = (cx + (q * 0.25 - 0.09) * s, cy - 0.25 * s, cx + (q * 0.25 + 0.09) * s, cy - 0.05 * s)
        draw.ellipse(eye, fill="#111" if q > 0 else "#fff")
        x = cx + q * 0.18 * s
        draw.ellipse((x - 0.08 * s, cy + 0.28 * s, x + 0.08 * s, cy + 0.42 * s), fill="#7a3b38")


def full_glass(draw, cx: float, cy: float, s: float) -> None:
    glass = [(-0.4, -0.7), (0.4, -0.7), (0.3, 0.7), (-0.3, 0.7)]
    draw.polygon(
        [(cx + x * s, cy + y * s) for x, y in glass], fill="#8cc4e6", outline="#2a6a96", width=5
    )
    milk = [(-0.37, -0.4), (0.37, -0.4), (0.3, 0.7), (-0.3, 0.7)]
    draw.polygon(
        [(cx + x * s, cy + y * s) for x, y in milk], fill="#fffdf6", outline="#2a6a96", width=4
    )


def milk_print(width, height, roof, colour, dark, grass, brand, word, fat, motif, rng):
    """Four panels side by side (front, right, back, left), wall and roof."""
    w = 256
    h0, r = int(w * height / width), int(w * roof / width)
    h = h0 + r
    image, d = labels.canvas(4 * w, h, "#fbfaf4")
    d.rectangle((0, 0, 4 * w, r + h0 * 0.16), fill=colour)
    for k in range(4):
        x0 = k * w
        waves = [math.sin(i / w * 2 * math.pi) for i in range(0, w + 1, 4)]
        top = [(x0 + 4 * i, r + h0 * (0.16 + 0.035 * s)) for i, s in enumerate(waves)]
        d.polygon([(x0, r), *top, (x0 + w, r)], fill=colour)
        low = [(x0 + 4 * i, r + h0 * (0.8 - 0.05 * s)) for i, s in enumerate(waves)]
        d.polygon([(x0, h), *low, (x0 + w, h)], fill=grass)
        if k % 2 == 0:
            labels.text(
                d, brand, (x0 + 0.08 * w, r + h0 * 0.02, x0 + 0.92 * w, r + h0 * 0.14), "italic"
            )
            box_ = (x0 + 0.04 * w, r + h0 * 0.2, x0 + 0.96 * w, r + h0 * 0.42)
            labels.text(d, word, box_, fill=dark, stroke=2, stroke_fill="#fff")
            (cow if motif == "cow" else full_glass)(d, x0 + 0.5 * w, r + h0 * 0.62, w * 0.35)
            labels.text(d, fat, (x0 + 0.08 * w, r + h0 * 0.86, x0 + 0.92 * w, r + h0 * 0.97))
        else:
            title = "NUTRITION" if k == 1 else brand
            labels.text(
                d, title, (x0 + 0.1 * w, r + h0 * 0.22, x0 + 0.9 * w, r + h0 * 0.3), fill=dark
            )
            d.rectangle(
                (x0 + 0.12 * w, r + h0 * 0.32, x0 + 0.88 * w, r + h0 * 0.62), outline=dark, width=3
            )
            labels.small_print(
                d, (x0 + 0.17 * w, r + h0 * 0.345, x0 + 0.83 * w, r + h0 * 0.61), 7, "#555", rng
            )
            labels.barcode(d, (x0 + 0.25 * w, r + h0 * 0.66, x0 + 0.75 * w, r + h0 * 0.76), rng)
        d.line((x0, 0, x0, h), fill="#dddddd", width=2)
    return image


def milk_carton(
    width=0.07,
    height=0.17,
    roof=0.045,
    colour="#1f5fc4",
    dark="#123a80",
    grass="#3f9b46",
    brand="Meadow",
    word="MILK",
    fat="3.5% fat",
    motif="cow",
    cap="#ffffff",
    seed=0,
) -> Model:
    """A gable-top carton; modelled facing -Y."""
    rng = np.random.default_rng(seed)
    printed = label(
        milk_print(width, height, roof, colour, dark, grass, brand, word, fat, motif, rng)
    )
    a, thin = width / 2, 0.0012
    v_wall, ridge = height / (height + roof), height + roof * 0.72

    def panel(k, v0, v1):
        return [(k / 4, v0), ((k + 1) / 4, v0), ((k + 1) / 4, v1), (k / 4, v1)]

    v = [(x, y, z) for z in (0, height) for x, y in ((-a, -a), (a, -a), (a, a), (-a, a))]
    f = [(0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7), (3, 2, 1, 0), (4, 5, 6, 7)]
    uv = [panel(k, 0, v_wall) for k in range(4)] + [[(0.01, 0.99)] * 4] * 2
    parts = [bevel(Mesh(v, f, None, [printed], uv), 0.0022, 1, 60).weigh(1.3)]
    # the two roof slopes, as slabs
    for k, s in ((0, -1), (2, 1)):
        x0, x1 = (-a, a) if s < 0 else (a, -a)
        top = [
            (x0, s * a, height - 0.0005),
            (x1, s * a, height - 0.0005),
            (x1, s * thin, ridge),
            (x0, s * thin, ridge),
        ]
        normal = np.cross(np.subtract(top[1], top[0]), np.subtract(top[3], top[0]))
        normal /= np.linalg.norm(normal)
        low = [tuple(np.array(q) - normal * 0.007 - [0, 0, 0.003]) for q in top]
        low[2:] = [(q[0], s * 0.0004, q[2]) for q in low[2:]]
        faces = [(0, 1, 2, 3), (7, 6, 5, 4), (0, 4, 5, 1), (1, 5, 6, 2), (3, 2, 6, 7), (0, 3, 7, 4)]
        slab_uv = [panel(k, v_wall, 1)] + [[(k / 4 + 0.02, 0.95)] * 4] * 5
        parts.append(cube_project(Mesh(top + low, faces, None, [printed], slab_uv, smooth=False)))
    # the folded-in gable sides, double-sided
    for s, k in ((1, 1), (-1, 3)):
        v = [(s * a * 0.985, -a * 0.97, height - 0.001), (s * a * 0.985, a * 0.97, height - 0.001)]
        v += [
            (s * a * 0.3, 0, ridge - 0.003),
            (s * a * 0.95, -thin, ridge - 0.001),
            (s * a * 0.95, thin, ridge - 0.001),
        ]
        f = [(0, 1, 2), (0, 2, 3), (1, 4, 2)] if s > 0 else [(1, 0, 2), (2, 0, 3), (4, 1, 2)]
        f += [face[::-1] for face in f[1:]]
        corner = [(k / 4 + 0.1, v_wall + 0.02), (k / 4 + 0.2, v_wall + 0.02), (k / 4 + 0.15, 0.9)]
        parts.append(
            cube_project(Mesh(v, f, None, [printed], [corner] * len(f), weight=0.7, smooth=False))
        )
    plain_print = {
        name: (printed, (k / 4 + 0.01, 0.96, k / 4 + 0.03, 0.98))
        for name, k in (("-y", 0), ("+y", 2))
    }
    parts.append(
        box(width, 0.0036, 0.018, (0, 0, ridge - 0.004), printed, 0.0008, labels=plain_print)
    )
    if cap:
        r = min(0.0125, width * 0.17)
        profile = [
            (0, 0),
            (r * 1.15, 0),
            (r * 1.15, 0.002),
            (r, 0.002),
            (r, 0.01),
            (r * 0.85, 0.0115),
            (0, 0.0115),
        ]
        lid = lathe(
            profile,
            18,
            mat=plain(cap, 0.02),
            rib=lambda k, i: 1 - 0.04 * (i % 2) if k in (3, 4) else 1,
        )
        lid.turn(rx=math.atan2(ridge - height, a))
        parts.append(lid.move(0, -a * 0.52, height + (ridge - height) * 0.47))
    return Model(
        title=f"milk carton, {fat}",
        parts={"body": Part(parts, collision="hull")},
        mass=1.03,
        friction=0.5,
        front="-y",
    )


def milk_carton_random(rng: np.random.Generator) -> dict:
    colour, dark, grass = pick(
        rng,
        [
            ("#1f5fc4", "#123a80", "#3f9b46"),
            ("#c4262e", "#8c141c", "#c4262e"),
            ("#2c8f4a", "#14582a", "#7fbf3f"),
        ],
    )
    return {
        "width": uniform(rng, 0.068, 0.09),
        "height": uniform(rng, 0.15, 0.19),
        "colour": colour,
        "dark": dark,
        "grass": grass,
        "brand": pick(rng, ["Meadow", "Alpina", "Daisy", "Hofgut"]),
        "word": pick(rng, ["MILK", "MILK", "LAIT"]),
        "fat": pick(rng, ["3.5% fat", "1.5% fat", "WHOLE"]),
        "motif": pick(rng, ["cow", "cow", "glass"]),
        "cap": pick(rng, ["#ffffff", "#1f5fc4", "#c4262e"]),
        "seed": seed_of(rng),
    }
