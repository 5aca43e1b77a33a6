"""Rugs, plants, paintings, bins and coat stands."""

from __future__ import annotations

import math

import numpy as np
from PIL import Image

from toolkit import labels
from toolkit.materials import Material, label, plain, shade
from toolkit.mesh import Mesh, cube_project
from toolkit.model import Container, Maker, Model, Support, cylinder_piece, ring_pieces, round_polygon
from toolkit.sampling import noise_offset, pick, seed_of
from toolkit.shapes import box, lathe, loft, spline, tube

from .joinery import Assembly, fabric, finish
from .pictures import painting

Offset = tuple[float, float, float]
NO_SHADOW = (1.0, 1.0, 1.0, 0.999)


# ---- rugs and mats
def rug_pattern(kind: str, tones: tuple[str, ...], width: int = 256, height: int = 176) -> Image.Image:
    """A woven pattern: "border", "stripes", "diamonds" or "hexagons"."""
    image, draw = labels.canvas(width, height, tones[0])
    w, h = width, height
    if kind == "border":
        for k, inset in enumerate((8, 20, 26)):
            draw.rectangle((inset, inset, w - inset, h - inset), fill=tones[(k + 1) % len(tones)])
        draw.rectangle((34, 34, w - 34, h - 34), fill=tones[0])
        for k in range(5):
            r = 44 - 9 * k
            draw.polygon([(w / 2 - 2 * r, h / 2), (w / 2, h / 2 - r), (w / 2 + 2 * r, h / 2), (w / 2, h / 2 + r)], fill=tones[(k + 1) % len(tones)])
    elif kind == "stripes":
        for k, x in enumerate(range(0, w, 16)):
            draw.rectangle((x, 0, x + 9 - 4 * (k % 3), h), fill=tones[1 + k % (len(tones) - 1)])
    elif kind == "diamonds":
        for j in range(-1, 6):
            for i in range(-1, 9):
                x, y = i * 32 + 16 * (j % 2), j * 36
                draw.polygon([(x, y + 18), (x + 16, y), (x + 32, y + 18), (x + 16, y + 36)], outline=tones[1], fill=tones[2] if (i + j) % 3 == 0 else None, width=3)
    else:
        s = 19.0
        for j in range(-1, 8):
            for i in range(-1, 9):
                cx, cy = (i + 0.5 * (j % 2)) * s * math.sqrt(3), j * 1.5 * s
                six = [(cx + s * math.sin(a), cy + s * math.cos(a)) for a in (k * math.pi / 3 for k in range(6))]
                draw.polygon(six, outline=tones[1], width=3)
    pixels = np.asarray(image.convert("RGB"), float)
    weave = 1 + 0.05 * np.random.default_rng(0).standard_normal((height, width, 1))
    return Image.fromarray((pixels * weave).clip(0, 255).astype(np.uint8))


def rug(
    length: float = 2.0, depth: float = 1.4, pattern: str = "border", tones: tuple[str, ...] = ("#d9cdb8", "#8c4a3f", "#41566b"),
    thickness: float = 0.008, corner: float = 0.01, title: str = "rug", offset: Offset = (0, 0, 0),
) -> Model:  # fmt: skip
    """A flat rug, its length along y."""
    asm = Assembly()
    side = plain(shade(tones[0], 0.8), 0.05, 60)
    face = label(rug_pattern(pattern, tones), occlusion=0.0)
    rug_mesh = box(depth, length, thickness, (0, 0, 0), side, 0.0, labels={"+z": face})
    asm.add("body", rug_mesh, solid=True)
    return Model(
        title=f"{title}, {pattern}",
        parts=asm.parts(),
        mass=round(2.2 * length * depth, 1),
        friction=0.8,
        supports=[],
        texture_size=256,
    )


RUG_TONES = [
    ("#d9cdb8", "#8c4a3f", "#41566b"),
    ("#e6e0d2", "#b8ab92", "#cfc4ad"),
    ("#6f7f88", "#d8d2c4", "#4d5a63"),
    ("#c7a26a", "#f0e6d2", "#7a5436"),
]


def rug_random(rng: np.random.Generator) -> dict:
    """Parameters of a random rug."""
    return {
        "length": round(float(rng.uniform(1.8, 2.3)), 2),
        "depth": round(float(rng.uniform(1.2, 1.6)), 2),
        "pattern": pick(rng, ["border", "stripes", "diamonds", "hexagons"]),
        "tones": pick(rng, RUG_TONES),
        "offset": noise_offset(rng),
    }


def bath_mat(length: float = 0.8, depth: float = 0.5, colour: str = "#7fa0a8", offset: Offset = (0, 0, 0)) -> Model:
    """A thick, tufted mat."""
    asm, thickness = Assembly(), 0.015
    pile = Material()
    tufts = pile.remap(pile.voronoi(70, offset), 0.1, 0.6)
    pile.colour(pile.mix(tufts, shade(colour, 1.1), shade(colour, 0.82)))
    low = box(depth, length, thickness, (0, 0, 0), pile, 0.006, 2)
    asm.add("body", low, solid=True)
    frame = plain(shade(colour, 0.88), 0.05, 60)
    w = 0.012
    for x0, x1, y0, y1 in ((-1, 1, -1, -1), (-1, 1, 1, 1), (-1, -1, -1, 1), (1, 1, -1, 1)):
        ax, bx = x0 * (depth / 2 - 0.05) - w / 2, x1 * (depth / 2 - 0.05) + w / 2
        ay, by = y0 * (length / 2 - 0.05) - w / 2, y1 * (length / 2 - 0.05) + w / 2
        asm.board("body", (ax, ay, thickness - 0.004), (bx, by, thickness + 0.002), frame, solid=False)
    return Model(title="bath mat", parts=asm.parts(), mass=0.9, friction=0.8, texture_size=128)


def bath_mat_random(rng: np.random.Generator) -> dict:
    """Parameters of a random bath mat."""
    return {
        "length": round(float(rng.uniform(0.7, 0.9)), 2),
        "depth": round(float(rng.uniform(0.45, 0.55)), 2),
        "colour": pick(rng, ["#7fa0a8", "#cfc3ad", "#a77f78"]),
        "offset": noise_offset(rng),
    }


# ---- potted plants
def leaf(length: float, width: float, bend: float, mat: Material, thickness: float = 0.005) -> Mesh:
    """A leaf along +X, bending down, with a groove along the middle; closed, so seen from below too."""
    rings = []
    for t in np.linspace(0, 1, 6):
        half = width / 2 * math.sin(math.pi * min(1.0, 0.12 + 0.86 * t)) ** 0.8 + 0.002
        z = length * (0.35 * t - bend * t * t)
        x = length * t
        rings.append(np.array([(x, -half, z + half * 0.25), (x, 0, z), (x, half, z + half * 0.25), (x, 0, z - thickness)]))
    return cube_project(loft(rings, mat))


def plant_pot(
    kind: str = "broad", height: float = 1.0, pot: str = "#b5623f", seed: int = 0, offset: Offset = (0, 0, 0)
) -> Model:
    """A potted plant: "broad" leaves on stems, a "palm", or upright "blades"."""
    rng, asm = np.random.default_rng(seed), Assembly()
    r, tall = 0.15, 0.28
    clay = plain(pot, 0.05, 25, offset)
    profile = [(0, 0), (r * 0.72, 0), (r * 0.76, 0.01), (r, tall), (r * 1.02, tall + 0.004), (r * 0.9, tall + 0.004)]
    profile += [(r * 0.88, tall - 0.035), (0, tall - 0.03)]
    soil = plain("#4a3627", 0.25, 60)
    asm.add("body", lathe(profile, 24, mats=[clay, soil], mat_of_segment=[0, 0, 0, 0, 0, 0, 1]))
    asm.piece("body", cylinder_piece(r * 0.74, 0, tall, 12, r))
    green = Material(occlusion=0.7)
    tint = green.remap(green.noise(14, 3, offset=offset), 0.35, 0.65)
    green.colour(green.mix(tint, "#2f6b33", "#5f9c48"))
    stem = plain("#5f7a3c", 0.1, 40)
    base = np.array([0, 0, tall - 0.03])
    crown = height - tall
    count = {"broad": 12, "palm": 13, "blades": 15}[kind]
    for k in range(count):
        a = 2.4 * k + rng.uniform(-0.25, 0.25)  # golden angle: leaves avoid one another
        lift = (k + 0.5) / count
        if kind == "blades":
            length = crown * rng.uniform(0.75, 1.0)
            blade = leaf(length, 0.055, -0.05, green, 0.008).turn(ry=-(math.pi / 2 - 0.12 - 0.4 * rng.random())).turn(rz=a)
            foot = base + [0.05 * math.cos(a) * rng.random(), 0.05 * math.sin(a) * rng.random(), 0]
            asm.add("body", blade.move(*foot))
            continue
        reach = 0.06 + 0.1 * (1 - lift)
        top = base + [reach * math.cos(a), reach * math.sin(a), crown * (0.25 + 0.6 * lift)]
        bend = base + [reach * 0.25 * math.cos(a), reach * 0.25 * math.sin(a), crown * 0.5 * (0.25 + 0.6 * lift)]
        asm.add("body", tube(spline([base, bend, top], 2), [0.008, 0.007, 0.006, 0.005, 0.005], 5, mat=stem).weigh(0.5))
        if kind == "palm":
            for s in range(-2, 3):
                frond = leaf(crown * 0.42, 0.045, 0.45, green).turn(ry=-0.35 - 0.5 * lift).turn(rz=a + 0.42 * s)
                asm.add("body", frond.move(*top).weigh(0.7))
        else:
            size = rng.uniform(0.85, 1.15)
            blade = leaf(0.3 * size, 0.16 * size, 0.55, green).turn(ry=-0.25 - 0.7 * lift).turn(rz=a)
            asm.add("body", blade.move(*top))
    radius = 0.08 if kind == "blades" else 0.16
    asm.piece("body", cylinder_piece(radius, tall + 0.05, height * 0.9, 8))
    return Model(
        title=f"potted plant, {kind} leaves",
        parts=asm.parts(),
        mass=7.0,
        ground_shadow=True,
        prune=False,
    )


def plant_pot_random(rng: np.random.Generator) -> dict:
    """Parameters of a random potted plant."""
    return {
        "kind": pick(rng, ["broad", "palm", "blades"]),
        "height": round(float(rng.uniform(0.85, 1.2)), 2),
        "pot": pick(rng, ["#b5623f", "#e4e1da", "#4d5b63"]),
        "seed": seed_of(rng),
        "offset": noise_offset(rng),
    }


# ---- pictures
def picture_frame(
    width: float = 0.7, height: float = 0.5, kind: str = "landscape", frame: str = "oak", seed: int = 0, offset: Offset = (0, 0, 0)
) -> Model:
    """A framed painting to hang on a wall (back at -X)."""
    asm, t = Assembly(), 0.03
    wood, cross = finish(frame, 2, offset), finish(frame, 1, offset)
    for y0, y1 in ((-width / 2, -width / 2 + t), (width / 2 - t, width / 2)):
        asm.board("body", (0, y0, 0), (0.02, y1, height), wood, 0.004)
    for z0, z1 in ((0, t), (height - t, height)):
        asm.board("body", (0, -width / 2 + t, z0), (0.02, width / 2 - t, z1), cross, 0.004)
    mount = plain("#f2efe8", 0.01, 20)
    asm.board("body", (0, -width / 2 + t, t), (0.012, width / 2 - t, height - t), mount)
    m = t + 0.045
    art = label(painting(kind, seed, 256, int(256 * (height - 2 * m) / (width - 2 * m))))
    low, high = (0.006, -width / 2 + m, m), (0.015, width / 2 - m, height - m)
    asm.board("picture", low, high, mount, 0, {"+x": art}, 3.0, solid=False)
    # It lies so close to the mount that it would cast a blotchy shadow on itself.
    return Model(
        title=f"framed painting, {kind}", parts=asm.parts(picture={"rgba": NO_SHADOW}), mass=1.8
    )


def picture_frame_random(rng: np.random.Generator) -> dict:
    """Parameters of a random painting."""
    upright = bool(rng.random() < 0.35)
    long, short = round(float(rng.uniform(0.6, 0.85)), 2), round(float(rng.uniform(0.45, 0.55)), 2)
    return {
        "width": short if upright else long,
        "height": long if upright else short,
        "kind": pick(rng, ["landscape", "abstract", "flower"]),
        "frame": pick(rng, ["oak", "walnut", "black", "#f0efec"]),
        "seed": seed_of(rng),
        "offset": noise_offset(rng),
    }


# ---- bins and coat stands
def trash_bin(height: float = 0.42, radius: float = 0.15, colour: str = "#5b6470", bag: bool = True, offset: Offset = (0, 0, 0)) -> Model:
    """An open bin, hollow; `bag` turns a white liner over its rim."""
    asm, r0 = Assembly(), radius * 0.8
    shell, inner = plain(colour, 0.03, 20, offset), plain("#f0f0ee" if bag else shade(colour, 0.7), 0.04, 25, offset)
    t = 0.008
    profile = [(0, 0), (r0, 0), (r0 + 0.004, 0.01), (radius, height - 0.01), (radius + 0.004, height), (radius - t + 0.004, height)]
    profile += [(radius - t, height - 0.02), (r0 - t, 0.02), (0, 0.016)]
    asm.add("body", lathe(profile, 28, mats=[shell, inner], mat_of_segment=[0, 0, 0, 0, 1, 1, 1, 1]))
    if bag:
        hem = height - 0.07
        q = radius - (radius - r0) * 0.07 / height
        fold = [(q + 0.002, hem), (q + 0.007, hem), (radius + 0.012, height - 0.004), (radius + 0.006, height + 0.006), (radius - 0.008, height + 0.004), (radius - 0.004, height - 0.01)]
        asm.add("body", lathe(fold, 28, mat=inner, rib=lambda k, i: 1 + 0.008 * math.sin(7.3 * i) * (k in (0, 1))))
    for piece in ring_pieces([(r0, 0.0), (radius, height)], [(r0 - t, 0.0), (radius - t, height)], 10):
        asm.piece("body", piece)
    asm.piece("body", cylinder_piece(r0, 0, 0.016))
    return Model(
        title="open bin",
        parts=asm.parts(),
        mass=1.4,
        supports=[Support("floor", 0.016, round_polygon(r0 - 0.02, 12), "body", None, "inside")],
        containers=[Container("inside", (0, 0, height / 2 + 0.01), (1.35 * r0, 1.35 * r0, height - 0.02))],
        ground_shadow=True,
    )


def trash_bin_random(rng: np.random.Generator) -> dict:
    """Parameters of a random bin."""
    return {
        "height": round(float(rng.uniform(0.34, 0.48)), 2),
        "radius": round(float(rng.uniform(0.13, 0.17)), 3),
        "colour": pick(rng, ["#5b6470", "#b9bdc0", "#3f6b52", "#d9d6cf"]),
        "bag": bool(rng.random() < 0.5),
        "offset": noise_offset(rng),
    }


def coat(colour: str, collar: str, offset: Offset = (0, 0, 0)) -> list[Mesh]:
    """A coat hanging from a hook at (0, 0, 0): body, sleeves, collar; its front to +X."""
    cloth = fabric(colour, offset, 0.08)
    rings = []
    # (z, width across, depth, bulge to the front)
    for z, w, d, x in ((-0.98, 0.34, 0.14, 0.02), (-0.7, 0.31, 0.13, 0.015), (-0.4, 0.29, 0.12, 0.01), (-0.2, 0.3, 0.12, 0.005), (-0.1, 0.26, 0.1, 0.0), (-0.03, 0.13, 0.07, 0.0)):
        t = np.arange(16) * 2 * math.pi / 16
        fold = 1 + 0.09 * np.sin(5 * t + 7 * z) * min(1.0, -z * 1.6)
        rings.append(np.c_[x + d / 2 * np.cos(t) * fold, w / 2 * np.sin(t) * fold, np.full(16, z)])
    meshes = [loft(rings, cloth)]
    for s in (-1, 1):
        arm = spline([(0, s * 0.1, -0.1), (0.005, s * 0.17, -0.22), (0.02, s * 0.185, -0.45), (0.035, s * 0.17, -0.68)], 2)
        meshes.append(tube(arm, [0.05, 0.058, 0.058, 0.055, 0.05, 0.047, 0.044], 9, mat=cloth))
    band = fabric(collar, offset, 0.06)
    ring = [(0.045 * math.cos(a) + 0.005, 0.07 * math.sin(a), -0.05 + 0.02 * math.cos(a)) for a in np.arange(10) * 2 * math.pi / 10]
    meshes.append(tube(np.array(ring), 0.022, 6, closed=True, mat=band))
    strip = box(0.008, 0.022, 0.86, (0.074, 0, -0.95), plain(shade(colour, 0.62), 0.05, 40))
    meshes.append(strip.turn(ry=0.012))
    return meshes


def coat_rack(wood: str = "walnut", coats: tuple[str, ...] = ("#8a3f35", "#3f5568"), offset: Offset = (0, 0, 0)) -> Model:
    """A standing coat rack with up to three coats."""
    asm, timber, height = Assembly(), finish(wood, 2, offset), 1.72
    pole = [(0, 0.1), (0.024, 0.1), (0.02, 0.5), (0.018, height - 0.03), (0.026, height - 0.02), (0.016, height), (0, height)]
    asm.add("body", lathe(pole, 12, mat=timber))
    for k in range(4):
        a = math.pi / 4 + k * math.pi / 2
        c, s = math.cos(a), math.sin(a)
        foot = spline([(0.01 * c, 0.01 * s, 0.16), (0.12 * c, 0.12 * s, 0.1), (0.24 * c, 0.24 * s, 0.016)], 3)
        asm.add("body", tube(foot, 0.015, 6, mat=timber))
        asm.solid("body", (min(0, 0.24 * c), min(0, 0.24 * s), 0), (max(0, 0.24 * c), max(0, 0.24 * s), 0.03))
    hooks = 6
    for k in range(hooks):
        a = 2 * math.pi * k / hooks
        c, s = math.cos(a), math.sin(a)
        z = height - 0.12 - 0.1 * (k % 2)
        curve = spline([(0.01 * c, 0.01 * s, z), (0.07 * c, 0.07 * s, z + 0.01), (0.115 * c, 0.115 * s, z + 0.07)], 3)
        asm.add("body", tube(curve, 0.009, 6, mat=timber))
    asm.solid("body", (-0.02, -0.02, 0.03), (0.02, 0.02, height))
    for k, colour in enumerate(coats):
        a = (0.0, 2 * math.pi / 3, 4 * math.pi / 3)[k % 3]
        for mesh in coat(colour, shade(colour, 0.8), offset):
            asm.add("body", mesh.turn(rz=a).move(0.1 * math.cos(a), 0.1 * math.sin(a), height - 0.1))
        x, y = 0.1 * math.cos(a), 0.1 * math.sin(a)
        asm.solid("body", (x - 0.07, y - 0.1, height - 1.0), (x + 0.07, y + 0.1, height - 0.2))
    return Model(
        title=f"coat rack with {len(coats)} coat{'s' if len(coats) != 1 else ''}",
        parts=asm.parts(),
        mass=8.0,
        ground_shadow=True,
    )


def coat_rack_random(rng: np.random.Generator) -> dict:
    """Parameters of a random coat rack."""
    pool = ["#8a3f35", "#3f5568", "#b59a6a", "#4b5a45", "#2f3136"]
    order = [pool[int(i)] for i in rng.permutation(len(pool))]
    return {
        "wood": pick(rng, ["walnut", "oak", "black"]),
        "coats": tuple(order[: int(rng.integers(1, 3))]),
        "offset": noise_offset(rng),
    }


MODELS = {
    "rug": Maker(
        rug,
        rug_random,
        3,
        [
            {"pattern": "border", "tones": RUG_TONES[0], "length": 2.2, "depth": 1.5},
            {"pattern": "hexagons", "tones": RUG_TONES[1], "length": 1.9, "depth": 1.3},
            {"pattern": "stripes", "tones": RUG_TONES[2], "length": 1.8, "depth": 1.2},
        ],
    ),
    "bath_mat": Maker(bath_mat, bath_mat_random, 2, [{"colour": "#7fa0a8"}, {"colour": "#cfc3ad"}]),
    "plant_pot": Maker(plant_pot, plant_pot_random, 2, [{"kind": "broad", "pot": "#e4e1da"}, {"kind": "blades", "pot": "#b5623f"}]),
    "picture_frame": Maker(
        picture_frame,
        picture_frame_random,
        3,
        [{"kind": "landscape", "frame": "oak"}, {"kind": "abstract", "frame": "black"}, {"kind": "flower", "frame": "#f0efec", "width": 0.46, "height": 0.62}],
    ),
    "trash_bin": Maker(trash_bin, trash_bin_random, 2, [{"colour": "#5b6470", "bag": True}, {"colour": "#b9bdc0", "bag": False}]),
    "coat_rack": Maker(coat_rack, coat_rack_random, 2, [{"coats": ("#8a3f35", "#3f5568")}, {"wood": "black", "coats": ("#b59a6a",)}]),
}
