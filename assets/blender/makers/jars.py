"""Glass jars of several forms, empty or with contents; each with a `broken` variant."""

from __future__ import annotations

import numpy as np
from toolkit.fracture import fracture, scatter
from toolkit.labels import canvas, text
from toolkit.materials import Material, metal, plain, shade
from toolkit.materials import label as printed
from toolkit.mesh import Mesh
from toolkit.model import Container, Maker, Model, Part, cylinder_piece, ring_pieces
from toolkit.sampling import noise_offset
from toolkit.shapes import box, lathe, tube

from makers.breakage import BROKEN, wall_seeds
from makers.glassware import clear_glass
from makers.ware import smear

CLEAR = (1.0, 1.0, 1.0, 0.5)

# radius, height, outline up to the mouth in shares, columns
JARS = {
    "jam": (
        0.036,
        0.112,
        [(0.9, 0), (1, 0.05), (1, 0.2), (1, 0.62), (1, 0.74), (0.82, 0.84), (0.8, 0.98)],
        18,
    ),
    "tall": (
        0.04,
        0.172,
        [(0.92, 0), (1, 0.03), (1, 0.2), (1, 0.66), (1, 0.8), (0.84, 0.87), (0.82, 0.98)],
        18,
    ),
    "hexagon": (
        0.043,
        0.092,
        [(0.94, 0), (1, 0.05), (1, 0.18), (1, 0.6), (1, 0.7), (0.76, 0.82), (0.74, 0.98)],
        6,
    ),
    "preserving": (
        0.055,
        0.13,
        [(0.9, 0), (1, 0.05), (1, 0.2), (1, 0.6), (1, 0.76), (0.84, 0.84), (0.84, 0.9)],
        18,
    ),
    "storage": (
        0.052,
        0.205,
        [(0.96, 0), (1, 0.02), (1, 0.2), (1, 0.6), (1, 0.75), (1, 0.85), (1, 0.9)],
        18,
    ),
    "squat": (
        0.05,
        0.082,
        [(0.8, 0), (0.96, 0.1), (1, 0.22), (1, 0.62), (0.96, 0.72), (0.86, 0.82), (0.84, 0.98)],
        18,
    ),
}


def contents(filling: str, kind: str, height: float, level: float, offset) -> Material:
    """Jam, honey, pickles, pasta or biscuits behind glass."""
    m = Material(occlusion=0.5)
    if kind == "pickles":
        lumps = m.ramp(
            m.voronoi(48, offset, (1, 1, 0.45)),
            [(0, shade(filling, 1.35)), (0.45, filling), (0.8, shade(filling, 0.5))],
        )
    elif kind == "pasta":
        lumps = m.ramp(
            m.voronoi(70, offset, (1, 1, 0.5)),
            [(0, shade(filling, 1.25)), (0.5, filling), (0.75, shade(filling, 0.55))],
        )
    elif kind == "beans":
        lumps = m.ramp(
            m.voronoi(110, offset),
            [(0, shade(filling, 1.4)), (0.4, filling), (0.7, shade(filling, 0.45))],
        )
    elif kind == "honey":
        lumps = m.ramp(
            m.remap(m.axis(2), 0, height), [(0, shade(filling, 0.75)), (1, shade(filling, 1.2))]
        )
    else:
        lumps = m.ramp(
            m.noise(130, 3, offset=offset),
            [(0.35, shade(filling, 0.6)), (0.5, filling), (0.65, shade(filling, 1.4))],
        )
    full = m.mix(
        m.remap(m.axis(2), (level - 0.01) * height, (level + 0.01) * height), lumps, "dfeaec"
    )
    band = m.math("ABSOLUTE", m.math("ADD", m.normal(1), 0.5))
    return m.colour(m.mix(m.remap(band, 0.02, 0.1, 0.6, 0), full, "ffffff"))


def jar_label(words: str, second: str, colour: str):
    """A paper band, four times round, one of them in front."""
    picture, draw = canvas(1024, 192, "#f8f2e0")
    for k in range(5):
        x = 256 * k - 128
        draw.rectangle((x + 6, 8, x + 249, 183), outline=colour, width=6)
        text(draw, words, (x + 16, 16, x + 240, 96), "bold", colour)
        text(draw, second, (x + 40, 102, x + 216, 178), "bold", colour)
    return picture


def closure(kind: str, r: float, h: float, mouth: float, colour: str, n: int) -> list[Mesh]:
    """A screw lid, a glass lid with rubber ring and wire clip, or a cork."""
    if kind == "clip":
        rubber, wire = plain("#d8702a", 0.05), metal("b9bec2", "6a7075")
        dome = [(0, 0.915 * h), (mouth + 0.005, 0.915 * h), (mouth + 0.005, 0.955 * h)]
        dome += [(mouth * 0.7, 0.985 * h), (0, h)]
        ring = [
            (0, 0.885 * h),
            (mouth + 0.008, 0.885 * h),
            (mouth + 0.008, 0.915 * h),
            (0, 0.916 * h),
        ]
        lid = [lathe(dome, n, mat=clear_glass("#c4dce0", h)), lathe(ring, n, mat=rubber)]
        x = mouth + 0.012
        hasp = [
            (x, -0.018, 0.72 * h),
            (x + 0.004, -0.018, 0.98 * h),
            (x, 0, 1.0 * h),
            (x + 0.004, 0.018, 0.98 * h),
            (x, 0.018, 0.72 * h),
        ]
        lid.append(tube(hasp, 0.003, 4, mat=wire))
        return lid
    if kind in ("cork", "wood"):
        m = plain("#c49a66" if kind == "cork" else "#9a6a3a", 0.2, 180)
        wide = mouth + (0.003 if kind == "wood" else -0.004)
        top = [(0, 0.86 * h), (wide * 0.94, 0.86 * h), (wide, 0.99 * h), (wide - 0.003, h), (0, h)]
        return [lathe(top, n, mat=m)]
    tin = plain(colour, 0.04) if colour != "steel" else metal("d0b25a", "8f7430")
    wide = mouth + 0.0035
    top = [(0, 0.87 * h), (wide, 0.87 * h), (wide, 0.985 * h), (wide - 0.003, h), (0, h)]
    rib = (lambda k, i: 1 - 0.03 * (i % 2) if k in (1, 2) else 1) if colour == "steel" else None
    return [lathe(top, n, mat=tin, rib=rib)]


def glass_jar(
    shape="jam",
    filling="",
    kind="jam",
    lid="#c8202c",
    cover="screw",
    words="",
    second="JAM",
    colour="#444444",
    look=0,
    seed=0,
) -> Model:
    """A jar of a form of JARS with its cover."""
    rng = np.random.default_rng(look)
    r, h, shares, n = JARS[shape]
    t = 0.0035
    outer = [(r * q, h * z) for q, z in shares]
    mouth = outer[-1][0]
    glass = clear_glass("#cfe3e4", h)
    if filling:
        glass = contents(filling, kind, h, 0.78, noise_offset(rng))
    inner = [(max(q - t, 0.004), z) for q, z in outer[::-1] if z > 0.15 * h]
    inner.append((outer[1][0] - t, 0.008))
    profile = [(0, 0.002), *outer, *inner, (0, 0.006)]
    mats = [glass, printed(jar_label(words, second, colour))] if words else [glass, glass]

    def shell(count: int):
        return lathe(
            profile,
            count,
            mats=mats,
            mat_of_segment=[1 if k == 3 else 0 for k in range(len(profile) - 1)],
            label_z=(outer[2][1], outer[3][1]),
            start=-np.pi,
        )

    shoulder = outer[-2]
    pieces = [cylinder_piece(r, 0, 0.008, 12)]
    high = outer[-3][1]
    pieces += ring_pieces([(r, 0), (r, high)], [(r - t, 0.008), (r - t, high)], 10)
    pieces.append(cylinder_piece(r, high, shoulder[1], 12, shoulder[0]))
    seeds = wall_seeds(r, h, 3, np.random.default_rng(seed))
    raw = plain("e6f4f2", 0.0, occlusion=0.2)
    rgba = None if filling else CLEAR
    weights = [(0.75 * r) ** 2] + [0.0] * 3
    count = 6 if n == 6 else 9
    shards = fracture([shell(count).weigh(0.6)], seeds, raw, weights, seed, 0.003, 0.07)
    fallen = scatter(shards, np.random.default_rng(seed))
    cap = closure(cover, r, h, mouth, lid, 16)
    size = "large" if shape in ("storage", "tall") else "small"
    dropped = [
        m.keep_pattern().move(-2.4 * r, 1.6 * r, -0.86 * h)
        for m in closure(cover, r, h, mouth, lid, 10)
    ]
    parts = {
        "body": Part([shell(n).weigh(1.4)], rgba=rgba, collision=pieces),
        "lid": Part(cap, collision=[cylinder_piece(mouth, 0.86 * h, h, 12)]),
        "shards": Part(shards, rgba=rgba and (1.0, 1.0, 1.0, 0.66), collision=fallen),
        "dropped": Part(dropped, collision="hull"),
    }
    if filling:  # what was in it lies among the shards
        mess = plain(filling, 0.25, 120)
        spots = [(0.2 * r, 0.1 * r, 1.3), (1.9 * r, 0.6 * r, 0.6), (-0.4 * r, -1.8 * r, 0.5)]
        spill = [smear(x, y, 0, q * r, rng, mess, 0.005) for x, y, q in spots]
        if kind in ("pasta", "beans", "pickles"):
            for k in range(4):
                a, far = 2.4 * k, r * (0.9 + 0.17 * k)
                long = 0.02 if kind != "beans" else 0.01
                scrap = box(long, 0.007, 0.006, mat=mess).turn(rz=1.3 * k)
                spill.append(scrap.move(far * np.cos(a), far * np.sin(a), 0))
        parts["spill"] = Part(spill, collision="none")
    name = (
        f"{words.lower()} {second.lower()}".strip() if words else f"{kind} jar" if filling else ""
    )
    return Model(
        f"jar of {name}"
        if words
        else (f"jar with {kind}" if filling else f"empty {size} glass jar"),
        parts,
        mass=0.5 if filling else 0.28,
        friction=0.5,
        variants={
            "default": ["body", "lid"],
            "broken": ["shards", "dropped", *(["spill"] if filling else [])],
        },
        states=BROKEN,
        texture_size=256 if words else 128,
        prune=False,
        containers=[]
        if filling
        else [Container("inside", (0, 0, 0.42 * h), (1.2 * r, 1.2 * r, 0.7 * h), closed_by=None)],
    )


def glass_jar_random(rng: np.random.Generator) -> dict:
    return {"look": int(rng.integers(1_000_000)), "seed": 2}


MODELS = {
    "glass_jar": Maker(
        glass_jar,
        glass_jar_random,
        8,
        [
            {"shape": "jam", "filling": "#b01822", "lid": "#c8202c", "words": "CHERRY"}
            | {"colour": "#a0182a"},
            {"shape": "tall", "lid": "steel"},
            {"shape": "jam", "filling": "#d8741a", "lid": "#2f6a3a", "words": "APRICOT"}
            | {"colour": "#b8620c"},
            {"shape": "hexagon", "filling": "#d8920f", "kind": "honey", "lid": "steel"}
            | {"words": "HONEY", "second": "pure", "colour": "#8a5208"},
            {"shape": "tall", "filling": "#6f8a2c", "kind": "pickles", "lid": "#2f7a3a"}
            | {"words": "PICKLES", "second": "crisp", "colour": "#2c5a22"},
            {"shape": "preserving", "cover": "clip"},
            {"shape": "storage", "filling": "#e6bc5c", "kind": "pasta", "cover": "cork"},
            {"shape": "squat", "filling": "#5a2c16", "kind": "beans", "cover": "wood"}
            | {"words": "COFFEE", "second": "beans", "colour": "#4a2410"},
        ],
    ),
}
