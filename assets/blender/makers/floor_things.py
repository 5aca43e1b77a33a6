"""Things left on the floor: dumbbell, skateboard, umbrella, pet bowl, watering can."""

from __future__ import annotations

import math

import numpy as np
from labels import prints
from makers.projection import project_label
from toolkit.materials import Material, metal, plain, shade, wood
from toolkit.materials import label as printed
from toolkit.mesh import Mesh
from toolkit.model import Container, Maker, Model, Part, Support, box_piece, cylinder_piece, rectangle, ring_pieces
from toolkit.sampling import pick, seed_of, uniform
from toolkit.shapes import TAU, box, ellipsoid, extrude, lathe, loft, spline, tube


def dumbbell(style: str, length: float, colour: str) -> Model:
    """A hand weight lying on its side: 'hex' rubber heads or smooth 'round' vinyl."""
    rubber, steel = plain(colour, 0.06, 90), metal("c2c6ca", "767c82", (12, 1, 12), 60)
    r = length * 0.2
    half = length / 2
    if style == "hex":
        n, profile = 6, [(0, 0), (r * 0.72, 0), (r, r * 0.28), (r, r * 1.2), (r * 0.72, r * 1.45), (0, r * 1.45)]
        height = r * math.cos(math.pi / 6)
        grip = lathe([(0.013, -half + r), (0.0145, -0.03), (0.016, 0), (0.0145, 0.03), (0.013, half - r)], 12, mat=steel)
    else:
        n, profile = 16, [(0, 0), (r * 0.7, 0), (r, r * 0.3), (r, r * 1.0), (r * 0.75, r * 1.3), (0, r * 1.3)]
        height = r
        grip = lathe([(0.015, -half + r), (0.0165, 0), (0.015, half - r)], 12, mat=rubber)
    start = 0.0
    heads = []
    for q in (-1, 1):
        head = lathe(profile, n, mat=rubber, start=start)
        if style == "hex":
            head.flat()
        heads.append(head.move(z=-half) if q < 0 else head.scale(1, 1, -1).move(z=half))
    plate = lathe([(0, -0.0006), (r * 0.45, -0.0006), (r * 0.45, 0)], 12, mat=plain(shade(colour, 2.2), 0)).move(z=-half)
    plate2 = plate.copy().scale(1, 1, -1)
    meshes = [*heads, grip, plate, plate2]
    pieces = [prism for prism in (cylinder_piece(r, -half, -half + 1.4 * r, 8), cylinder_piece(r, half - 1.4 * r, half, 8), cylinder_piece(0.016, -half + r, half - r, 6))]
    if style == "hex":
        angles = [start + TAU * i / 6 for i in range(6)]
        ends = ((-half, -half + 1.4 * r), (half - 1.4 * r, half))
        pieces[:2] = [np.array([(r * math.cos(a), r * math.sin(a), z) for z in span for a in angles]) for span in ends]
    turn = np.array([[1, 0, 0], [0, 0, 1], [0, -1, 0]])
    for mesh in meshes:
        mesh.turn(rx=-math.pi / 2).move(z=height)
    pieces = [p @ turn.T + [0, 0, height] for p in pieces]
    return Model("dumbbell", {"body": Part(meshes, collision=pieces)}, mass=round(60 * length**2, 1), friction=0.7, texture_size=128)


def dumbbell_random(rng: np.random.Generator) -> dict:
    return {"style": "hex", "length": uniform(rng, 0.19, 0.24), "colour": "#2a2c30"}


def skateboard(length: float, ground: str, accent: str, wheel: str) -> Model:
    """A skateboard on its wheels: grip tape on top, both ends bent up."""
    width, z0, thick = length * 0.255, 0.082, 0.011
    grip, art = printed(prints.skateboard_deck(ground, accent, True)), printed(prints.skateboard_deck(ground, accent, False))
    ply = plain("#c99a5c", 0.08, 120)
    rings = []
    for t in np.linspace(-1, 1, 17):
        x = t * length / 2
        bend = max(0.0, abs(t) - 0.68) / 0.32
        w = width / 2 * math.sqrt(max(0.02, 1 - max(0.0, (abs(t) - 0.72) / 0.285) ** 2.2))
        z = z0 + 0.042 * bend**1.5
        dish = 0.004 * (1 - bend)
        rings.append([(x, -w, z + dish), (x, -w, z + dish + thick), (x, 0, z + thick), (x, w, z + dish + thick), (x, w, z + dish), (x, 0, z)])
    deck = loft(rings, mat=ply)
    project_label(deck, grip, "+z", (0, 0), (width, length), 0.4)
    project_label(deck, art, "-z", (0, 0), (width, length), 0.4)
    for i, face in enumerate(deck.f):  # the drawings lie along the board
        if deck.mi[i]:
            deck.label_uv[i] = [(deck.v[j][0] / length + 0.5, deck.v[j][1] / width + 0.5) for j in face]
    steel, tyre = metal("b4b9be", "62686e"), plain(wheel, 0.04)
    meshes = [deck]
    radius = 0.029
    pieces = [box_piece((0, 0, z0 + 0.006), (length * 0.72, width, 0.016))]
    for q in (-1, 1):
        x = q * length * 0.3
        pieces.append(box_piece((q * length * 0.43, 0, z0 + 0.03), (length * 0.14, width * 0.9, 0.03)))
        meshes.append(box(0.075, 0.05, 0.012, (x, 0, z0 - 0.011), steel, 0.002))
        meshes.append(extrude([(-0.04, 0), (0.04, 0), (0.016, 0.04), (-0.016, 0.04)], 0.022, mat=steel, axis="x").move(x, 0, 0.034))
        meshes.append(tube([(x, -width * 0.42, radius), (x, width * 0.42, radius)], 0.006, 6, mat=steel))
        for s in (-1, 1):
            w = 0.017
            profile = [(0, -w), (0.011, -w), (0.024, -w), (radius, -w * 0.6), (radius, w * 0.6), (0.024, w), (0.011, w), (0, w)]
            disc = lathe(profile, 12, mats=[tyre, steel], mat_of_segment=[1, 0, 0, 0, 0, 0, 1]).turn(rx=math.pi / 2)
            meshes.append(disc.move(x, s * width * 0.42, radius))
            pieces.append(cylinder_piece(radius, -w, w, 10) @ np.array([[1, 0, 0], [0, 0, 1], [0, 1, 0]]) + [x, s * width * 0.42, radius])
    top = Support("deck", z0 + thick + 0.002, rectangle(length * 0.6, width - 0.04))
    return Model("skateboard", {"body": Part(meshes, collision=pieces)}, mass=2.4, friction=0.3, supports=[top])


def skateboard_random(rng: np.random.Generator) -> dict:
    ground, accent = pick(rng, [("#2a6fb0", "#f2c53a"), ("#c8302c", "#f6f4ee"), ("#2f8a5a", "#f2a83a")])
    return {"length": uniform(rng, 0.74, 0.8), "ground": ground, "accent": accent, "wheel": pick(rng, ["#f2ead0", "#e8502c", "#3fa0c8"])}


def umbrella(length: float, cloth: str, second: str, crook: bool) -> Model:
    """A closed umbrella lying on its side."""
    s = length / 0.85
    r = 0.036
    skin = Material()
    folds = skin.math("SINE", skin.math("ADD", skin.math("MULTIPLY", skin.math("ARCTAN2", skin.axis(1), skin.math("SUBTRACT", skin.axis(2), r * s)), 8), skin.math("MULTIPLY", skin.axis(0), 26)))
    skin.colour(skin.mix(skin.remap(folds, -1, 0.6, 0.5, 0), cloth, shade(cloth, 0.4)))
    profile = [(0, 0.02), (0.009, 0.03), (0.016, 0.12), (0.026, 0.3), (r, 0.5), (r * 1.02, 0.56), (0.024, 0.585), (0.014, 0.58), (0, 0.57)]
    canopy = lathe([(a * s, z * s) for a, z in profile], 16, mat=skin, rib=lambda k, i: 1 + (0.13 if i % 2 else -0.1) * min(1.0, k / 3), discs=False)
    strap = lathe([(0.032 * s, 0.4 * s), (0.0365 * s, 0.405 * s), (0.0375 * s, 0.43 * s), (0.034 * s, 0.435 * s)], 14, mat=plain(second, 0.03))
    steel, grip = metal("b9bdc2", "6a7076"), wood("8a5a34", "4a2c18", 0, 20) if crook else plain(second, 0.04)
    tip = lathe([(0, 0), (0.003 * s, 0), (0.005 * s, 0.04 * s), (0, 0.045 * s)], 8, mat=steel)
    stick = tube([(0, 0, 0.57 * s), (0, 0, 0.75 * s)], 0.0055, 8, mat=steel)
    upright = [canopy, strap, tip, stick]
    if crook:
        bend = [(0, 0, 0.68), (0, 0, 0.78)] + [(0.0, 0.055 - 0.055 * math.cos(t), 0.79 + 0.055 * math.sin(t)) for t in np.linspace(0.2, math.pi, 8)] + [(0, 0.11, 0.765)]
        upright.append(tube(np.array(bend) * s, 0.011, 8, mat=grip))
    else:
        upright.append(lathe([(0, 0.68 * s), (0.012, 0.68 * s), (0.014, 0.76 * s), (0.017, 0.84 * s), (0.012, 0.85 * s), (0, 0.85 * s)], 10, mat=grip))
    for mesh in upright:
        mesh.turn(ry=math.pi / 2).move(-0.42 * s, 0, r * s)
    lowest = min(float(mesh.v[:, 2].min()) for mesh in upright)
    for mesh in upright:
        mesh.move(z=-lowest)
    pieces = [np.array([(x * s - 0.42 * s, y, z) for x, w in ((0.03, 0.01), (0.5, 0.036), (0.58, 0.03)) for y in (-w, w) for z in (r * s - w - lowest, r * s + w - lowest)]),
              box_piece((0.24 * s, 0, r * s - lowest), (0.2 * s, 0.02, 0.02))]  # fmt: skip
    if crook:
        pieces.append(box_piece((0.4 * s, 0.055 * s, r * s - lowest), (0.09 * s, 0.13 * s, 0.022)))
    return Model("closed umbrella", {"body": Part(upright, collision=pieces)}, mass=0.45)


def umbrella_random(rng: np.random.Generator) -> dict:
    return {"length": uniform(rng, 0.8, 0.9), "cloth": pick(rng, ["#26282c", "#2f4f8a", "#c8302c", "#2f7f5a"]), "second": "#1c1d20", "crook": True}


def pet_bowl(radius: float, height: float, colour: str, steel: bool, content: str, seed: int) -> Model:
    """A pet's bowl, wider at its foot, with water or dry food in it."""
    rng = np.random.default_rng(seed)
    shell = metal("c9cdd1", "7b8187") if steel else plain(colour, 0.04)
    inner = metal("dfe3e6", "9aa0a5") if steel else plain(shade(colour, 1.1), 0.03)
    rim, wall, level = radius * 0.84, 0.008, height * 0.72
    profile = [(0, 0.002), (radius * 0.94, 0.002), (radius, 0), (radius, 0.006), (rim + 0.004, height - 0.004), (rim, height), (rim - wall, height - 0.003), (rim * 0.8, level), (0, level - 0.001)]
    bowl = lathe(profile, 26, mats=[shell, inner], mat_of_segment=[0] * 5 + [1] * 3)
    meshes = [bowl]
    if content == "water":
        water = Material(occlusion=0.3)
        swirl = water.noise(22, 2, distortion=1.5)
        water.colour(water.ramp(swirl, [(0.3, "7fb0c8"), (0.5, "a9cfde"), (0.56, "e6f4fa"), (0.6, "a9cfde"), (0.8, "8fbdd2")]))
        meshes.append(lathe([(rim * 0.86, level + 0.001), (rim * 0.84, level + 0.003), (0, level + 0.003)], 22, mat=water))
    else:
        kibble = plain("#8a5a30", 0.3, 200)
        heap = lathe([(rim * 0.84, level), (rim * 0.6, level + 0.006), (rim * 0.3, level + 0.011), (0, level + 0.012)], 16, mat=kibble)
        meshes.append(heap)
        for _ in range(14):
            a, q = float(rng.uniform(0, TAU)), rim * 0.74 * math.sqrt(float(rng.random()))
            z = level + 0.012 - 0.009 * q / rim
            meshes.append(lathe([(0, 0), (0.0065, 0), (0.007, 0.003), (0.005, 0.006), (0, 0.006)], 4, mat=plain(pick(rng, ["#9a6636", "#7a4a26", "#b07a44"]), 0.1), weight=0.6).move(q * math.cos(a), q * math.sin(a), z))
    if not steel:
        bone = plain("#f7f4ea", 0.0)
        paw = [box(0.002, 0.045, 0.012, (0, 0, -0.006), bone)] + [ellipsoid((0.0012, 0.009, 0.009), (0, q * 0.022, w * 0.007), 8, 5, bone) for q in (-1, 1) for w in (-1, 1)]
        slope = math.atan2(radius - rim - 0.004, height - 0.01)
        for mesh in paw:
            meshes.append(mesh.turn(ry=-slope).move((radius + rim + 0.004) / 2 - 0.0005, 0, height / 2))
    pieces = [cylinder_piece(radius, 0, level, 14, radius * 0.9), *ring_pieces([(radius * 0.92, level * 0.9), (rim + 0.004, height)], [(rim * 0.85, level * 0.9), (rim - wall, height)], 10)]
    inside = Container("inside", (0, 0, (level + height) / 2 + 0.002), (rim * 1.1, rim * 1.1, max(0.01, height - level)))
    return Model(f"pet bowl with {content}", {"body": Part(meshes, collision=pieces)}, mass=0.5, containers=[inside], ground_shadow=True)


def pet_bowl_random(rng: np.random.Generator) -> dict:
    return {"radius": uniform(rng, 0.095, 0.115), "height": uniform(rng, 0.055, 0.068), "colour": pick(rng, ["#c8302c", "#2f6fb0", "#3a9a8a"]), "steel": False, "content": "water", "seed": seed_of(rng)}


def watering_can(height: float, colour: str, zinc: bool) -> Model:
    """A watering can with a long spout and rose, and a loop handle."""
    s = height / 0.24
    paint = metal("b9c0c4", "767e84") if zinc else plain(colour, 0.04)
    wall = 0.005
    body = lathe([(0, 0), (0.082, 0), (0.088, 0.004), (0.08, 0.15), (0.082, 0.156), (0.076, 0.156), (0.078, 0.05), (0, 0.05)], 22, mats=[paint, plain(shade(colour, 0.45), 0.02)], mat_of_segment=[0] * 5 + [1, 1])
    hood = lathe([(0.081, 0.15), (0.07, 0.172), (0.045, 0.182), (0, 0.186)], 14, mat=paint)

    front_hood = hood.copy()
    front_hood.keep_faces([i for i, face in enumerate(hood.f) if hood.v[list(face)].mean(0)[0] > 0.02])
    inner_hood = front_hood.copy().scale(0.97, 0.97, 0.999).flip()
    spout = tube(spline([(0.07, 0, 0.035), (0.12, 0, 0.08), (0.18, 0, 0.16), (0.21, 0, 0.2)], 3), np.linspace(0.019, 0.0105, 10), 9, mat=paint)
    direction = 0.68
    rose = lathe([(0, 0), (0.011, 0), (0.03, 0.024), (0.03, 0.03), (0, 0.034)], 14, mats=[paint, plain(shade(colour, 0.6), 0.3, 500)], mat_of_segment=[0, 0, 0, 1]).turn(ry=direction).move(0.206, 0, 0.196)
    brace = tube([(0.075, 0, 0.152), (0.165, 0, 0.146)], 0.0045, 6, mat=paint)
    handle = tube(spline([(0.03, 0, 0.178), (0.0, 0, 0.235), (-0.08, 0, 0.245), (-0.135, 0, 0.19), (-0.13, 0, 0.1), (-0.082, 0, 0.045)], 3), 0.0085, 8, mat=paint, up=(0, 1, 0))
    meshes = [body, front_hood, inner_hood, spout, rose, brace, handle]

    for mesh in meshes:
        mesh.scale(s)
    pieces = [cylinder_piece(0.088, 0, 0.156, 14, 0.081), np.array([(x, y * w, z) for x, z, w in ((0.075, 0.02, 0.018), (0.08, 0.06, 0.018), (0.21, 0.19, 0.012), (0.235, 0.23, 0.03), (0.25, 0.19, 0.03)) for y in (-1, 1)]),
              box_piece((-0.06, 0, 0.235), (0.16, 0.018, 0.03)), box_piece((-0.125, 0, 0.14), (0.03, 0.018, 0.16))]  # fmt: skip
    pieces = [p * s for p in pieces]
    return Model("watering can", {"body": Part(meshes, collision=pieces)}, mass=0.7)


def watering_can_random(rng: np.random.Generator) -> dict:
    return {"height": uniform(rng, 0.22, 0.26), "colour": pick(rng, ["#2f8a5a", "#3a7fb0"]), "zinc": False}


MODELS = {
    "dumbbell": Maker(dumbbell, dumbbell_random, 3, [{}, {"style": "round", "colour": "#c8306a"}, {"style": "round", "colour": "#2f8fc0", "length": 0.17}]),
    "skateboard": Maker(skateboard, skateboard_random, 2, [{"ground": "#2a6fb0", "accent": "#f2c53a", "wheel": "#f2ead0"}, {"ground": "#c8302c", "accent": "#e8502c", "wheel": "#e8502c"}]),
    "umbrella": Maker(umbrella, umbrella_random, 3, [{"cloth": "#2f4f8a"}, {"cloth": "#26282c", "crook": False}, {"cloth": "#c8302c"}]),
    "pet_bowl": Maker(pet_bowl, pet_bowl_random, 3, [{"colour": "#c8302c"}, {"steel": True}, {"colour": "#2f6fb0", "content": "food"}]),
    "watering_can": Maker(watering_can, watering_can_random, 2, [{"colour": "#2f8a5a"}, {"zinc": True, "colour": "#b9c0c4"}]),
}  # fmt: skip
