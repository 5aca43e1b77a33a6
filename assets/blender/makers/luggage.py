"""Suitcases and travel bags."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import Material, metal, plain, shade
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part, box_piece
from toolkit.sampling import noise_offset, seed_of
from toolkit.shapes import box, lathe, loft, rounded_rectangle, tube

from makers.joinery import fabric
from makers.soft_forms import bent


def _wheel(x: float, y: float, r: float, mat: Material) -> Mesh:
    profile = [(0, -0.01), (r, -0.01), (r, 0.01), (0, 0.01)]
    return lathe(profile, 7, mat=mat).turn(rx=math.pi / 2).move(x, y, r)


def _shell(d: float, w: float, h: float, z: float, r: float, mats: list[Material], ribs: int):
    """A rounded hard case standing on `z`, its two halves met by a band, ribbed front and back."""
    rings = []
    steps = [(0.0, 0.86), (0.012, 0.96), (0.05, 1.0), (h - 0.05, 1.0), (h - 0.012, 0.96), (h, 0.86)]
    for q, f in steps:
        outline = rounded_rectangle(d * f, w - (1 - f) * d, r, 3)
        rings.append(np.c_[outline, np.full(len(outline), z + q)])
    meshes = [loft(rings, mats[0])]
    for k in range(ribs):
        y = (k + 0.5) / ribs * (w - 2 * r) - (w / 2 - r)
        for q in (-1, 1):
            bar = box(0.009, 0.5 * (w - 2 * r) / ribs, h - 0.12, (0, 0, 0), mats[0])
            meshes.append(bar.move(q * (d / 2 + 0.002), y, z + 0.06))
    band = loft(
        [
            np.c_[rounded_rectangle(w + 0.004, h + 0.004, 0.05, 3), np.full(12, x)][:, [2, 0, 1]]
            for x in (-0.007, 0.007)
        ],
        mats[1],
    )
    meshes.append(band.move(0, 0, z + h / 2))
    return meshes


def trolley(
    d: float, w: float, h: float, colour: str, trim: str, handle: float, soft: bool, seed: int
) -> Model:
    """A wheeled suitcase standing upright, hard and ribbed or of cloth with pockets."""
    rng = np.random.default_rng(seed)
    dark, steel = plain(trim, 0.04), metal("b9bdc2", "6a7076")
    z = 0.045
    if soft:
        cloth = fabric(colour, noise_offset(rng), 0.12)
        rings = []
        for q, f in ((0, 0.94), (0.02, 1.0), (h - 0.03, 1.0), (h - 0.008, 0.96), (h, 0.88)):
            outline = rounded_rectangle(d * f, w * (0.5 + f / 2), 0.04, 3)
            rings.append(np.c_[outline, np.full(len(outline), z + q)])
        meshes = [loft(rings, cloth)]
        for low, high, out in ((0.05, 0.5, 0.035), (0.54, 0.9, 0.025)):
            tall = (high - low) * h
            pocket = box(
                out, w * 0.84, tall, (d / 2 + out / 2 - 0.004, 0, z + low * h), cloth, 0.014, 2
            )
            meshes.append(pocket)
            zipper = [
                (d / 2 + out - 0.002, q * w * 0.4, z + low * h + v * tall)
                for q, v in ((-1, 0.1), (-1, 0.9), (1, 0.9), (1, 0.1))
            ]
            meshes.append(tube(np.array(zipper), 0.004, 3, mat=dark, weight=0.4))
            pull = (d / 2 + out + 0.003, w * 0.3, z + low * h + 0.8 * tall)
            meshes.append(box(0.006, 0.012, 0.04, pull, steel))
        for q in (-1, 1):
            piping = [
                (q * (d / 2 - 0.006), a * (w / 2 - 0.006), z + b * h)
                for a, b in ((-1, 0.03), (-1, 0.97), (1, 0.97), (1, 0.03))
            ]
            meshes.append(tube(np.array(piping), 0.008, 4, mat=dark, weight=0.5))
    else:
        shell = plain(colour, 0.035, 20, noise_offset(rng))
        meshes = _shell(d, w, h, z, 0.05, [shell, dark], 4)
        meshes.append(box(0.012, 0.05, 0.07, (0, w / 2 + 0.002, z + 0.55 * h), steel, 0.004))
    for x in (-1, 1):
        for y in (-1, 1):
            at = x * (d / 2 - 0.045), y * (w / 2 - 0.05)
            meshes.append(_wheel(*at, 0.026, plain("#2a2b2e", 0.05)))
            meshes.append(box(0.045, 0.035, 0.018, (*at, 0.036), dark, 0.003))
    top = z + h
    grip = [
        (0, -0.075, top - 0.01),
        (0, -0.06, top + 0.025),
        (0, 0.06, top + 0.025),
        (0, 0.075, top - 0.01),
    ]
    if handle:
        x = -d / 2 + 0.03
        for q in (-1, 1):
            meshes.append(
                tube([(x, q * 0.09, top - 0.02), (x, q * 0.09, top + handle)], 0.008, 6, mat=steel)
            )
        meshes.append(box(0.03, 0.24, 0.032, (x, 0, top + handle - 0.012), dark, 0.01))
    meshes.append(bent(grip, 0.011, dark, 6, 2))
    side = [(0.0, w / 2 - 0.005, z + h * f) for f in (0.35, 0.65)]
    ends = [side[0], (0, w / 2 + 0.025, z + h * 0.39), (0, w / 2 + 0.025, z + h * 0.61), side[1]]
    if soft:
        meshes.append(bent(ends, 0.009, dark, 5, 1))
    pieces = [box_piece((0, 0, top / 2), (d, w, top))]
    if handle:
        pieces.append(box_piece((-d / 2 + 0.03, 0, top + handle / 2), (0.03, 0.24, handle)))
    name = "suitcase on wheels" + (", handle out" if handle else "")
    return Model(name, {"body": Part(meshes, collision=pieces)}, mass=3.2)


def vintage(
    d: float, w: float, h: float, leather: str, corner: str, flat: bool, seed: int
) -> Model:
    """An old leather case with straps, corner caps and a top handle; standing or lying."""
    rng = np.random.default_rng(seed)
    hide, cap, brass = (
        plain(leather, 0.12, 18, noise_offset(rng)),
        plain(corner, 0.08, 40),
        metal("d8b45a", "8a6a24"),
    )
    meshes = [box(d, w, h, (0, 0, 0), hide, 0.018, 2)]
    for y in (-0.28 * w, 0.28 * w):
        meshes.append(box(d + 0.008, 0.035, h + 0.008, (0, y, -0.002), cap, 0.003))
        meshes.append(box(0.008, 0.05, 0.04, (d / 2 + 0.004, y, h * 0.7), brass, 0.002))
        meshes.append(box(0.03, 0.014, 0.02, (0.0, y, h - 0.002), brass, 0.002))
    for x in (-1, 1):
        for y in (-1, 1):
            for top in (0, 1):
                at = (x * (d / 2 - 0.022), y * (w / 2 - 0.022), top * (h - 0.048) - 0.002)
                meshes.append(box(0.052, 0.052, 0.052, at, cap, 0.012, 1))
    seam = box(0.007, w + 0.004, h + 0.005, (0, 0, -0.0015), plain(shade(leather, 0.55), 0.05))
    meshes.append(seam)
    grip = [(0, -0.07, h), (0, -0.055, h + 0.04), (0, 0.055, h + 0.04), (0, 0.07, h)]
    meshes.append(bent(grip, 0.011, cap, 6, 2))
    for q in (-1, 1):
        meshes.append(box(0.03, 0.02, 0.012, (0, q * 0.07, h), brass, 0.002))
    pieces = [box_piece((0, 0, h / 2), (d, w, h)), box_piece((0, 0, h + 0.02), (0.02, 0.15, 0.05))]
    if flat:  # on its back, the handle to the front
        for m in meshes:
            m.turn(ry=math.pi / 2)
        low = min(float(m.v[:, 2].min()) for m in meshes)
        for m in meshes:
            m.move(z=-low)
        pieces = [box_piece((h / 2, 0, d / 2 + 0.006), (h, w, d + 0.008))]
    return Model("leather suitcase", {"body": Part(meshes, collision=pieces)}, mass=3.5)


def open_case(d: float, w: float, colour: str, lining: str, seed: int) -> Model:
    """A suitcase lying open on the floor, packed with folded clothes."""
    rng = np.random.default_rng(seed)
    shell, inner, dark = plain(colour, 0.04, 20), plain(lining, 0.08, 60), plain("#2a2b2e", 0.04)
    depth, wall = 0.11, 0.012
    meshes: list[Mesh] = []
    pieces = []

    def tray(mesh_list: list[Mesh]) -> None:
        rings = []
        for z, f in ((0, 0.03), (0.02, 0.006), (depth, 0.0)):
            o = rounded_rectangle(d - 2 * f, w - 2 * f, 0.05, 3)
            rings.append(np.c_[o, np.full(len(o), z)])
        for z, f in ((depth, wall), (0.02, wall + 0.004)):
            o = rounded_rectangle(d - 2 * f, w - 2 * f, 0.045, 3)
            rings.append(np.c_[o, np.full(len(o), z)])
        mesh_list.append(loft(rings, mats=[shell, inner], mat_of_face=lambda k, i: int(k >= 3)))

    tray(meshes)
    meshes.append(box(0.02, w * 0.86, 0.006, (0, 0, depth * 0.3), dark))
    tones = ["#3f5f94", "#e8e0d0", "#c8453a", "#f2c53a", "#5a8a6a", "#7fb0d0"]
    for i in range(2):
        for j in range(3):
            sx, sy = d * 0.42, w * 0.285
            x, y = (i - 0.5) * d * 0.45, (j - 1) * w * 0.3
            for k in range(2):
                tone = tones[(i * 3 + j + 2 * k) % 6]
                high = 0.03 + 0.045 * k
                jitter = rng.normal(0, 0.005, 2)
                stuff = fabric(tone, noise_offset(rng))
                at = (x + jitter[0], y + jitter[1], high - 0.012)
                cloth = box(sx - 0.01 * k, sy - 0.008 * k, 0.042, at, stuff, 0.014)
                meshes.append(cloth)
    lid: list[Mesh] = []
    tray(lid)
    strap = plain(shade(lining, 0.5), 0.05)
    lid.append(box(d * 0.9, 0.03, 0.008, (0, 0, 0.03), strap).turn(rz=0.55))
    lid.append(box(d * 0.9, 0.03, 0.008, (0, 0, 0.031), strap).turn(rz=-0.55))
    for m in lid:  # leans back a little beyond upright, hinged at the rear edge
        m.turn(ry=1.92).move(-d / 2 - 0.005, 0, depth + 0.0)
    low = min(float(m.v[:, 2].min()) for m in lid)
    for m in lid:
        m.move(z=-low + depth - 0.035)
    meshes += lid
    grip = [
        (d / 2, -0.07, 0.06),
        (d / 2 + 0.028, -0.055, 0.058),
        (d / 2 + 0.028, 0.055, 0.058),
        (d / 2, 0.07, 0.06),
    ]
    meshes.append(bent(grip, 0.01, dark, 5, 2))
    pieces.append(box_piece((0, 0, depth / 2), (d, w, depth)))
    points = np.concatenate([m.v for m in lid])
    lo, hi = points.min(0), points.max(0)
    pieces.append(box_piece((lo + hi) / 2, hi - lo))
    return Model("open suitcase", {"body": Part(meshes, collision=pieces)}, mass=6.0)


def duffel(length: float, colour: str, trim: str, seed: int) -> Model:
    """A sports travel bag: a soft roll with end panels, straps and two handles."""
    rng = np.random.default_rng(seed)
    r = 0.14
    cloth, dark, steel = fabric(colour, noise_offset(rng), 0.12), plain(trim, 0.05), metal()
    rings = []
    n = 16
    a = np.arange(n) * math.tau / n
    for y, f in (
        (-1, 0.8),
        (-0.985, 0.96),
        (-0.9, 1.0),
        (-0.35, 0.97),
        (0.35, 0.97),
        (0.9, 1.0),
        (0.985, 0.96),
        (1, 0.8),
    ):
        x, z = r * f * np.cos(a), r * f * np.sin(a) * 0.92
        z = np.maximum(z, -r * 0.72)
        rings.append(np.c_[x, np.full(n, y * length / 2), z + r * 0.72])
    meshes = [loft(rings, mats=[cloth, dark], mat_of_face=lambda k, i: int(k in (0, 1, 5, 6)))]
    top = r * 0.92 * 0.97 + r * 0.72
    meshes.append(box(0.012, length * 0.8, 0.008, (0, 0, top - 0.004), plain("#1d1e21", 0)))
    meshes.append(box(0.012, 0.04, 0.01, (0, length * 0.36, top), steel, 0.002))
    for y in (-0.2 * length, 0.2 * length):
        band = [
            (r * 1.005 * math.cos(t), y, r * 0.92 * 1.005 * math.sin(t) + r * 0.72)
            for t in np.linspace(-0.6, math.pi + 0.6, 11)
        ]
        meshes.append(_band(band, 0.035, dark))
    for q in (-1, 1):
        h = [(q * 0.05, -0.2 * length, top - 0.02), (q * 0.05, -0.13 * length, top + 0.1)]
        h += [
            (q * 0.04, 0.0, top + 0.13),
            (q * 0.05, 0.13 * length, top + 0.1),
            (q * 0.05, 0.2 * length, top - 0.02),
        ]
        meshes.append(bent(h, 0.011, dark, 5, 2))
    pocket = box(0.03, 0.3 * length, 0.13, (r * 0.9 + 0.008, 0, 0.04), cloth, 0.012, 2)
    meshes.append(pocket)
    pieces = [
        box_piece((0, 0, top / 2), (2 * r * 0.85, length, top)),
        box_piece((0, 0, top + 0.05), (0.1, 0.4 * length, 0.1)),
    ]
    return Model("travel bag", {"body": Part(meshes, collision=pieces)}, mass=3.0)


def _band(path: list, wide: float, mat: Material) -> Mesh:
    """A flat strap along y-width on a path in the xz-plane."""
    p = np.array(path)
    tangent = np.gradient(p, axis=0)
    normal = np.c_[tangent[:, 2], np.zeros(len(p)), -tangent[:, 0]]
    normal /= np.linalg.norm(normal, axis=1)[:, None]
    across = np.array([0, wide / 2, 0])
    rings = [
        [
            q - across - nn * 0.004,
            q + across - nn * 0.004,
            q + across + nn * 0.004,
            q - across + nn * 0.004,
        ]
        for q, nn in zip(p, normal, strict=True)
    ]
    return loft(rings, mat)


def suitcase(kind: str, **parameters) -> Model:
    """A suitcase: "trolley", "vintage", "open" or "duffel"."""
    make = {"trolley": trolley, "vintage": vintage, "open": open_case, "duffel": duffel}
    return make[kind](**parameters)


def suitcase_random(rng: np.random.Generator) -> dict:
    return {"kind": "trolley", "seed": seed_of(rng)}


_CABIN = {"d": 0.22, "w": 0.36, "h": 0.5, "handle": 0.0, "soft": False}
_LARGE = {"d": 0.27, "w": 0.44, "h": 0.62, "handle": 0.36, "soft": False}
_SOFT = {"d": 0.24, "w": 0.4, "h": 0.55, "handle": 0.0, "soft": True}

MODELS = {
    "suitcase": Maker(
        suitcase,
        suitcase_random,
        8,
        [
            {**_CABIN, "colour": "#c8a02c", "trim": "#2a2b2e", "seed": 1},
            {**_LARGE, "colour": "#2f6f8f", "trim": "#26282c", "seed": 2},
            {**_SOFT, "colour": "#3a3f4a", "trim": "#1c1d20", "seed": 3},
            {
                "kind": "vintage",
                "d": 0.16,
                "w": 0.52,
                "h": 0.36,
                "leather": "#8a5a34",
                "corner": "#4a2c18",
                "flat": False,
            },
            {"kind": "open", "d": 0.42, "w": 0.6, "colour": "#8a2f3a", "lining": "#b8b0a4"},
            {
                "kind": "vintage",
                "d": 0.16,
                "w": 0.52,
                "h": 0.36,
                "leather": "#3f5f4a",
                "corner": "#8a5a34",
                "flat": True,
            },
            {**_CABIN, "colour": "#b03a5a", "trim": "#2a2b2e", "seed": 1},
            {"kind": "duffel", "length": 0.56, "colour": "#2f5f94", "trim": "#1f2024"},
        ],
    ),
}
