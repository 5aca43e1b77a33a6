"""Wet cleaning: sponges, mops and rubber gloves."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import Material, blend, metal, plain, shade, wood
from toolkit.mesh import Mesh
from toolkit.model import Model, Part, box_piece, cylinder_piece, ring_pieces
from toolkit.shapes import (
    box,
    ellipsoid,
    extrude,
    lathe,
    rounded_rectangle,
    tube,
)

from makers.cleaner_forms import maker
from makers.convex import few_corners


def porous(colour: str, scale: float = 260.0, deep: float = 0.62, wide: float = 0.0) -> Material:
    """Sponge: a colour with dark pores of two sizes."""
    m = Material()
    small = m.remap(m.voronoi(scale), 0.16 + wide, 0.34 + wide)
    large = m.remap(m.voronoi(scale * 0.42, offset=(3, 1, 2)), 0.16 + wide, 0.3 + wide)
    holes = m.math("MULTIPLY", small, large)
    return m.colour(m.mix(holes, shade(colour, deep), m.mottle(colour, 0.06, 40)))


def scourer(colour: str) -> Material:
    """The rough green fleece on a sponge's back."""
    m = Material()
    return m.colour(m.mix(m.remap(m.noise(900, 4), 0.35, 0.65), shade(colour, 0.6), colour))


# ---- sponges
def waisted(length: float, width: float, pinch: float, n: int = 20) -> list[tuple[float, float]]:
    """A sponge's outline, drawn in at its middle for the fingers."""
    out = rounded_rectangle(width, length, 0.012, max(n // 4, 2))
    dense = []
    for i in range(len(out)):
        a, b = out[i], out[(i + 1) % len(out)]
        steps = 5 if np.linalg.norm(b - a) > 0.04 else 1
        dense += [a + (b - a) * k / steps for k in range(steps)]
    return [(x * (1 - pinch * math.exp(-((y / (0.22 * length)) ** 2))), y) for x, y in dense]


def kitchen_sponge(colour: str, back: str, outline, thick: float) -> list[Mesh]:
    """A block of sponge with a scouring fleece on top."""
    soft = extrude(outline, thick * 0.76, porous(colour), bevel_width=0.002)
    fleece = extrude(outline, thick * 0.24, scourer(back), bevel_width=0.001)
    return [soft, fleece.move(z=thick * 0.76)]


def sponge(kind: str, colour: str, back: str) -> Model:
    """A sponge: "block", "waist", "stack", "car", "natural", "round", or in use with "suds"."""
    block = [tuple(p) for p in rounded_rectangle(0.07, 0.11, 0.006, 3)]
    size = 128
    if kind == "block":
        groups = [kitchen_sponge(colour, back, block, 0.034)]
    elif kind == "waist":
        groups = [kitchen_sponge(colour, back, waisted(0.13, 0.085, 0.3), 0.045)]
    elif kind == "stack":
        groups = []
        tints = (colour, "#e8608a", "#3aa0d8")
        for k, turn in enumerate((0.1, -0.28, 0.4)):
            one = kitchen_sponge(tints[k], back, block, 0.03)
            groups.append(
                [m.keep_pattern().turn(rz=turn).move(0.004 * k, 0, 0.03 * k) for m in one]
            )
        size = 256
    elif kind == "car":
        groups = [
            [extrude(waisted(0.2, 0.115, 0.36), 0.06, porous(colour, 170), bevel_width=0.012)]
        ]
    elif kind == "natural":
        rng = np.random.default_rng(5)
        ball = ellipsoid((0.055, 0.075, 0.042), (0, 0, 0.038), 20, 12)
        bumps = rng.normal(0, 1, (7, 3))

        def lump(x: float, y: float, z: float) -> tuple[float, float, float]:
            p = np.array([x, y, z - 0.038])
            wave = sum(
                math.sin(110 * float(p @ b) / np.linalg.norm(b) + k) for k, b in enumerate(bumps)
            )
            q = p * (1 + 0.035 * wave)
            return float(q[0]), float(q[1]), max(0.0, float(q[2]) + 0.038)

        ball.mats = [porous(colour, 170, 0.72, 0.04)]
        groups = [[ball.warp(lump)]]
    elif kind == "round":
        disc = [(0.052 * math.cos(a), 0.052 * math.sin(a)) for a in np.arange(20) * math.tau / 20]
        groups = [kitchen_sponge(colour, back, disc, 0.042)]
    else:  # in use, soap suds on it
        groups = [kitchen_sponge(colour, back, waisted(0.125, 0.08, 0.22), 0.04)]
        rng, suds = np.random.default_rng(8), plain("#f6fafc", 0.1, 300)
        for _ in range(6):
            x, y, r = (
                rng.uniform(-0.022, 0.022),
                rng.uniform(-0.045, 0.03),
                rng.uniform(0.009, 0.019),
            )
            groups[0].append(ellipsoid((r, r, 0.8 * r), (x, y, 0.04 + 0.4 * r), 7, 5, suds))
    hulls = [few_corners(np.concatenate([m.v for m in g])) for g in groups]
    if kind in ("block", "waist", "stack", "car"):
        hulls = []
        for g in groups:
            points = np.concatenate([m.v for m in g])
            low, high = points.min(0), points.max(0)
            hulls.append(box_piece((low + high) / 2, high - low))
    part = Part([m for g in groups for m in g], collision=hulls)
    titles = {"car": "car sponge", "natural": "bath sponge", "stack": "stack of sponges"}
    return Model(
        titles.get(kind, "kitchen sponge"),
        {"body": part},
        mass=0.03,
        friction=0.8,
        texture_size=size,
    )


# ---- mops
def stick(
    length: float, colour: str, z0: float, r: float = 0.013, tip: str = "#26282c"
) -> list[Mesh]:
    """A mop's handle along z from a height."""
    mat = wood(colour, "8a6238", 2, 9) if tip == "wood" else plain(colour, 0.05)
    pole = lathe([(0, z0), (r, z0), (r, z0 + length - 0.1), (0, z0 + length - 0.1)], 8, mat=mat)
    end = plain(tip if tip != "wood" else colour, 0.05)
    hold = lathe(
        [
            (0, z0 + length - 0.14),
            (1.35 * r, z0 + length - 0.13),
            (1.4 * r, z0 + length - 0.02),
            (0.9 * r, z0 + length),
            (0, z0 + length),
        ],
        10,
        mat=end,
    )
    return [pole, hold]


def strings(colour: str, count: int, length: float, spread: float, seed: int) -> list[Mesh]:
    """Cotton strands hanging from the origin and spreading out on the floor below, z down to 0."""
    rng = np.random.default_rng(seed)
    mats = [
        plain(c, 0.25, 500) for c in (colour, shade(colour, 0.82), blend(colour, "#ffffff", 0.4))
    ]
    out = []
    for k in range(count):
        a = math.tau * k / count + rng.normal(0, 0.1)
        reach = spread * rng.uniform(0.65, 1.0)
        c, s = math.cos(a), math.sin(a)
        turn = rng.normal(0, 0.25)
        c2, s2 = math.cos(a + turn), math.sin(a + turn)
        path = [(0.018 * c, 0.018 * s, length), (0.05 * c, 0.05 * s, 0.75 * length)]
        path += [(0.5 * reach * c, 0.5 * reach * s, 0.22 * length)]
        path += [(0.8 * reach * c2, 0.8 * reach * s2, 0.0155), (reach * c2, reach * s2, 0.0145)]
        radii = [0.01, 0.014, 0.0155, 0.0155, 0.014]
        out.append(tube(path, radii, 5, mat=mats[k % 3]))
    return out


def string_mop(pole: str, clamp: str, length: float) -> list[list[Mesh]]:
    """A string mop upright, without its strands."""
    grip = lathe(
        [(0, 0.215), (0.05, 0.215), (0.052, 0.25), (0.03, 0.29), (0.022, 0.35), (0, 0.35)],
        12,
        mat=plain(clamp, 0.04),
    )
    return [[grip], stick(length - 0.32, pole, 0.32, 0.015)]


def flat_mop(colour: str, pole: str, clamp: str, length: float, lean: float) -> list[list[Mesh]]:
    """A flat mop: a broad pad with a joint and a leaning handle."""
    pad = extrude(
        rounded_rectangle(0.13, 0.42, 0.03, 3), 0.022, plain(colour, 0.2, 350), bevel_width=0.006
    )
    plate = extrude(
        rounded_rectangle(0.09, 0.34, 0.02, 3), 0.014, plain(clamp, 0.04), bevel_width=0.003
    )
    joint = box(0.05, 0.045, 0.04, (0, 0, 0.032), plain(shade(clamp, 0.7), 0.04), 0.006)
    yarn = plain(shade(colour, 0.8), 0.2)
    fringe = [
        box(0.016, 0.03, 0.012, (s * 0.068, -0.19 + 0.042 * k, 0), yarn)
        for k in range(10)
        for s in (-1, 1)
    ]
    neck = lathe([(0, 0.04), (0.02, 0.04), (0.017, 0.12), (0, 0.12)], 8, mat=plain(clamp, 0.04))
    handle = [neck, *stick(length - 0.1, pole, 0.1)]
    for mesh in handle:
        mesh.turn(ry=-lean, pivot=(0, 0, 0.045))
    return [[pad, plate.move(z=0.02), joint, *fringe], handle]


def sponge_mop(colour: str, pole: str, clamp: str, length: float) -> list[list[Mesh]]:
    """A sponge mop: a thick sponge roller in a metal frame, a lever on the handle."""
    block = extrude(
        rounded_rectangle(0.075, 0.28, 0.02, 3), 0.06, porous(colour, 160), bevel_width=0.012
    )
    plate = box(0.06, 0.26, 0.014, (0, 0, 0.058), plain(clamp, 0.04), 0.003)
    wings = [
        box(0.05, 0.012, 0.03, (0, s * 0.12, 0.066), metal("b8bcc0", "6f757b"), 0.003)
        for s in (-1, 1)
    ]
    neck = lathe([(0, 0.066), (0.024, 0.066), (0.018, 0.15), (0, 0.15)], 8, mat=plain(clamp, 0.04))
    lever = tube(
        [(0.012, 0, 0.32), (0.07, 0, 0.36), (0.09, 0, 0.46)], 0.008, 6, mat=plain(clamp, 0.04)
    )
    return [[block, plate, *wings], [neck, *stick(length - 0.12, pole, 0.12)], [lever]]


def mop(kind: str, colour: str, pole: str, clamp: str) -> Model:
    """A mop that lies: "string" with its strands spread, "string bunched"; "flat", "flat turned" on
    its joint; "sponge" on its side. Or one "in bucket": without it no mop stands."""
    groups: list[list[Mesh]]
    extra: list[np.ndarray] = []
    if kind.startswith("string"):
        groups = [[], *string_mop(pole, clamp, 1.05)]
    elif kind.startswith("flat"):
        groups = flat_mop(colour, pole, clamp, 1.1, 0.0)
    elif kind == "sponge":
        groups = sponge_mop(colour, pole, clamp, 1.05)
        for group in groups:  # on the side of its sponge and the end of its handle
            for mesh in group:
                mesh.turn(ry=-math.pi / 2 - 0.019).move(z=0.0375)
    else:
        groups, extra = mop_in_bucket(colour, pole, clamp)
    if kind.startswith("string"):
        groups = [lying_strands(colour, 0.55 if kind.endswith("bunched") else 0.9), *groups[1:]]
        for group in groups[1:]:
            for mesh in group:
                mesh.move(z=-0.235).turn(ry=-math.pi / 2)
        for mesh in (*groups[1], *groups[2]):
            mesh.move(z=0.05)
    elif kind.startswith("flat"):
        for mesh in groups[1]:  # the pad lies flat, the handle folded down behind it
            mesh.move(z=-0.05).turn(ry=-1.601).move(x=-0.01, z=0.05)
            if kind.endswith("turned"):
                mesh.turn(rz=0.33)
    hulls = [few_corners(np.concatenate([m.v for m in g])) for g in groups]
    if kind.startswith(("flat", "sponge")):
        head = groups[0][:3] if kind != "sponge" else groups[0]
        hulls[:1] = [few_corners(m.v) for m in head]
    elif extra:
        hulls = [*extra, *hulls[1:]]
    part = Part([m for g in groups for m in g], collision=hulls)
    name = {"flat": "flat mop", "sponge": "sponge mop"}.get(kind.split()[0], "mop")
    if kind == "in bucket":
        name = "mop in its bucket"
    front = "+x" if kind == "in bucket" else "-y"
    return Model(name, {"body": part}, mass=1.0, friction=0.8, ground_shadow=True, front=front)


def lying_strands(colour: str, fan: float) -> list[Mesh]:
    """Strands of a mop that lies: a fan along +x, ``fan`` radians to both sides."""
    rng = np.random.default_rng(4)
    mats = [
        plain(c, 0.25, 500) for c in (colour, shade(colour, 0.82), blend(colour, "#ffffff", 0.4))
    ]
    out = []
    for k in range(21):
        a = (k - 10) / 10 * fan + rng.normal(0, 0.06)
        reach = rng.uniform(0.26, 0.34)
        b = a + rng.normal(0, 0.12)
        z = 0.016 + 0.014 * (k % 3)
        path = [(0.0, 0.025 * a, 0.05), (0.07 * math.cos(a), 0.1 * math.sin(a), z + 0.018)]
        path += [(0.65 * reach * math.cos(a), 0.75 * reach * math.sin(a), z)]
        path.append((reach * math.cos(b), reach * math.sin(b), 0.0145))
        out.append(tube(path, [0.016, 0.0175, 0.0165, 0.0145], 5, mat=mats[k % 3]))
    return out


def mop_in_bucket(colour: str, pole: str, clamp: str) -> tuple[list[list[Mesh]], list[np.ndarray]]:
    """A string mop standing in a bucket of water."""
    r, h = 0.15, 0.27
    paint = plain(clamp, 0.04)
    profile = [(0, 0), (0.76 * r, 0), (0.97 * r, h - 0.026), (r + 0.006, h - 0.022)]
    profile += [(r + 0.006, h - 0.004), (r, h), (r - 0.008, h), (0.9 * r, 0.17), (0, 0.17)]
    water = plain("#5a8a9a", 0.12, 30)
    shell = lathe(profile, 24, mats=[paint, water], mat_of_segment=[0] * 7 + [1])
    head = strings(colour, 14, 0.17, 0.15, 6)
    for mesh in head:
        mesh.scale(0.75, 0.75, 1).move(z=0.14)
    grip = lathe(
        [(0, 0.28), (0.034, 0.28), (0.036, 0.32), (0.022, 0.35), (0.018, 0.4), (0, 0.4)],
        12,
        mat=plain("#2f6fc0", 0.04),
    )
    tool = [*head, grip, *stick(0.78, pole, 0.37)]
    for mesh in tool:
        mesh.turn(rx=0.09, pivot=(0, 0, 0.17))
    foot = 0.76 * r
    pieces = [
        cylinder_piece(0.9 * r, 0, 0.16, 14, 0.9 * r),
        *ring_pieces([(foot, 0), (r, h)], [(foot - 0.01, 0.008), (r - 0.01, h)], 10),
    ]
    return [[shell, *head], [grip, *tool[-2:]]], pieces


MODELS = {
    "sponge": maker(
        sponge,
        ("kind", "colour", "back"),
        [
            ("block", "#f2cf2a", "#2f8f4a"),
            ("waist", "#f2a02a", "#2f6f3a"),
            ("stack", "#f2cf2a", "#2f8f4a"),
            ("car", "#e8708f", ""),
            ("natural", "#7cc6da", ""),
            ("suds", "#3aa0d8", "#1f5f8a"),
            ("round", "#f2cf2a", "#2f8f4a"),
            ("block", "#e8608a", "#5a2f6a"),
        ],
    ),
    "mop": maker(
        mop,
        ("kind", "colour", "pole", "clamp"),
        [
            ("string bunched", "#ece6d6", "#c8935a", "#2f6fc0"),
            ("flat turned", "#3aa0d8", "#d8dce0", "#f4f4f2"),
            ("string", "#e8e2d2", "#2f8f4a", "#26282c"),
            ("sponge", "#f2cf2a", "#d8dce0", "#d8202c"),
            ("in bucket", "#ece6d6", "#c8935a", "#d8303a"),
            ("flat", "#7fc83a", "#26282c", "#2f8f4a"),
            ("string bunched", "#7fb8e0", "#d8202c", "#f4f4f2"),
        ],
    ),
}
