"""Small things that stand about: vase, photo frame, tissues, pen cup, clock, place mat, coaster."""

from __future__ import annotations

import math

import numpy as np
from labels import prints
from makers.projection import project_label
from toolkit.materials import Material, blend, metal, plain, shade, wood
from toolkit.materials import label as printed
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part, Support, box_piece, cylinder_piece, rectangle, ring_pieces, round_polygon
from toolkit.sampling import noise_offset, pick, seed_of, uniform
from toolkit.shapes import TAU, box, ellipsoid, extrude, lathe, loft, spline, tube


def _blossom(kind: str, radius: float, petal: str) -> list[Mesh]:
    """A flower looking up, its middle at the origin."""
    paint, heart = plain(petal, 0.08, 150), plain("#f0b92c" if kind == "daisy" else shade(petal, 0.7), 0.1, 300)
    if kind == "tulip":
        cup = [(0, -0.3), (0.4, -0.22), (0.56, 0.15), (0.5, 0.65), (0.42, 0.95), (0.3, 0.6), (0, 0.1)]
        bell = lathe([(r * radius, z * radius) for r, z in cup], 8, mat=paint, rib=lambda k, i: 1.12 - 0.24 * (i % 2) if k in (3, 4) else 1.0)
        return [bell]
    if kind == "rose":
        bud = [(0, -0.35), (0.5, -0.25), (0.72, 0.05), (0.66, 0.3), (0.45, 0.36), (0.42, 0.22), (0.2, 0.38), (0, 0.3)]
        return [lathe([(r * radius, z * radius) for r, z in bud], 9, mat=paint, rib=lambda k, i: 1 + 0.12 * math.sin(2.4 * i + k))]
    disc = [(0, -0.12), (1.0, 0.02), (0.95, 0.14), (0.3, 0.06), (0, 0.06)]
    petals = lathe([(r * radius, z * radius) for r, z in disc], 16, mat=paint, rib=lambda k, i: 1.0 if i % 2 else 0.55)
    return [petals, ellipsoid((radius * 0.34, radius * 0.34, radius * 0.2), (0, 0, radius * 0.1), 7, 4, heart)]


def _leaf(length: float, width: float, mat: Material) -> Mesh:
    """A long leaf rising along z from the origin and bending towards +X, 5 mm thick."""
    rings = []
    for t in np.linspace(0, 1, 6):
        w = width * math.sin(math.pi * min(1, 0.12 + 0.86 * t)) ** 0.8 / 2
        x, z = 0.35 * length * t**2.2, length * (t - 0.18 * t**3)
        rings.append([(x, -w, z), (x + 0.002, 0, z), (x, w, z), (x - 0.003, 0, z)])
    return loft(rings, mat=mat)


def vase(shape: str, height: float, glaze: str, band: str, flower: str, petals: list[str], stems: int, seed: int) -> Model:
    """A vase with a bunch of flowers."""
    rng = np.random.default_rng(seed)
    s = height / 0.2
    profiles = {
        "belly": [(0.034, 0), (0.05, 0.02), (0.066, 0.07), (0.06, 0.115), (0.036, 0.155), (0.028, 0.175), (0.037, 0.2)],
        "cylinder": [(0.036, 0), (0.04, 0.004), (0.041, 0.07), (0.042, 0.14), (0.044, 0.2)],
        "flare": [(0.032, 0), (0.036, 0.01), (0.03, 0.05), (0.034, 0.1), (0.045, 0.155), (0.058, 0.2)],
    }
    wall = 0.005
    outer = [(r * s, z * s) for r, z in profiles[shape]]
    rim, low = outer[-1], outer[-2]
    inner = [(rim[0] - wall / 2, rim[1] + 0.002), (rim[0] - wall, rim[1]), (low[0] - wall, low[1]), (0, low[1])]
    clay = Material()
    base = clay.mottle(glaze, 0.06, 40, noise_offset(rng))
    wave = clay.math("SINE", clay.math("MULTIPLY", clay.axis(2), 150 / s))
    inside_band = clay.math("MULTIPLY", clay.remap(clay.axis(2), 0.05 * s, 0.056 * s), clay.remap(clay.axis(2), 0.115 * s, 0.121 * s, 1, 0))
    clay.colour(clay.mix(clay.math("MULTIPLY", inside_band, clay.remap(wave, 0.0, 0.25)), base, band))
    pot = lathe([(0, 0), *outer, *inner], 22, mats=[clay, plain(shade(glaze, 0.5), 0.03)], mat_of_segment=[0] * (len(outer) + 2) + [1, 1])
    green = plain("#4f8a3c", 0.12, 120)
    leaf_mat = plain("#5f9a44", 0.15, 80)
    meshes = [pot]
    top = rim[1]
    for k in range(stems):
        a, spread = TAU * (k * 0.618 % 1) + float(rng.normal(0, 0.2)), 0.0 if k == 0 else float(rng.uniform(0.03, 0.075)) * s**0.5
        tall = top + float(rng.uniform(0.09, 0.15)) - 0.6 * spread
        tip = (spread * math.cos(a), spread * math.sin(a), tall)
        start = (rim[0] * 0.5 * math.cos(a), rim[0] * 0.5 * math.sin(a), top - 0.03)
        middle = np.array(start) * 0.4 + np.array(tip) * 0.6 - [0.25 * tip[0], 0.25 * tip[1], 0]
        meshes.append(tube([start, middle, tip], 0.0026, 4, mat=green, weight=0.5))
        lean = 0.25 + 6.0 * spread if k else 0.15
        for mesh in _blossom(flower, float(rng.uniform(0.026, 0.033)), petals[k % len(petals)]):
            meshes.append(mesh.turn(ry=lean).turn(rz=a).move(*tip))
    for k in range(4):
        blade = _leaf(float(rng.uniform(0.1, 0.15)), 0.03, leaf_mat)
        meshes.append(blade.move(x=rim[0] * 0.3).turn(ry=0.25).turn(rz=1.3 * k + 0.6).move(z=top - 0.012))
    widest = max(r for r, _ in outer)
    pieces = [cylinder_piece(outer[0][0] + 0.006, 0, 0.03 * s, 12, widest), cylinder_piece(widest, 0.03 * s, 0.12 * s, 12), cylinder_piece(widest * 0.8, 0.12 * s, top, 12, rim[0]),
              cylinder_piece(0.05, top, top + 0.13, 8, 0.08)]  # fmt: skip
    return Model("vase of flowers", {"body": Part(meshes, collision=pieces)}, mass=0.9)


def vase_random(rng: np.random.Generator) -> dict:
    return {
        "shape": "belly", "height": uniform(rng, 0.18, 0.24), "glaze": pick(rng, ["#3a6a9c", "#e9e2d2", "#2f7f78", "#b85a3a"]),
        "band": "#f2ead6", "flower": pick(rng, ["tulip", "rose", "daisy"]), "petals": ["#d8303a", "#f2c52a"], "stems": 6, "seed": seed_of(rng),
    }  # fmt: skip


def photo_frame(width: float, height: float, border: float, frame: str, wooden: bool, picture: str) -> Model:
    """A framed photo leaning back on its stand."""
    mat = wood(frame, shade(frame, 0.6), 1, 14) if wooden else plain(frame, 0.04)
    photo = printed(prints.photo(picture))
    depth, lean = 0.016, -0.22
    w, h = width / 2, height / 2
    meshes = []
    for sx, sz, y, z in ((width, border, 0, 0), (width, border, 0, height - border), (border, height - 2 * border, -w + border / 2, border), (border, height - 2 * border, w - border / 2, border)):
        meshes.append(box(depth, sx, sz, (0, y, z), mat, 0.003))
    mount = box(0.006, width - 2 * border + 0.004, height - 2 * border + 0.004, (-0.004, 0, border - 0.002), plain("#f7f4ea", 0.0))
    print_face = box(0.006, width - 2 * border - 0.02, height - 2 * border - 0.02, (-0.003, 0, border + 0.01), plain("#f7f4ea", 0.0), labels={"+x": photo}, weight=1.6)
    back = box(0.005, width - border, height - border, (-0.0085, 0, border / 2), plain("#2c2a28", 0.05))
    meshes += [mount, print_face, back]
    for mesh in meshes:
        mesh.turn(ry=lean)
    hinge = (-math.sin(-lean) * h * 1.25 - 0.01, 0, math.cos(lean) * h * 1.25)
    foot_x = -height * 0.52
    stand = extrude([(hinge[0], hinge[2]), (foot_x, 0.002), (foot_x - 0.006, 0.003), (hinge[0] - 0.004, hinge[2] + 0.004)], width * 0.28, mat=plain("#2c2a28", 0.05), axis="y")
    meshes.append(stand)
    turn = np.array([[math.cos(lean), 0, math.sin(lean)], [0, 1, 0], [-math.sin(lean), 0, math.cos(lean)]])
    pieces = [box_piece((0, 0, h), (depth, width, height)) @ turn.T, np.array([(x, y, z) for x, z in ((hinge[0], hinge[2]), (foot_x, 0), (foot_x - 0.006, 0.002)) for y in (-width * 0.14, width * 0.14)])]
    return Model("photo in a frame", {"body": Part(meshes, collision=pieces)}, mass=0.35)


def photo_frame_random(rng: np.random.Generator) -> dict:
    return {
        "width": uniform(rng, 0.14, 0.19), "height": uniform(rng, 0.18, 0.23), "border": uniform(rng, 0.014, 0.02),
        "frame": pick(rng, ["#b98552", "#7a4a2a"]), "wooden": True, "picture": pick(rng, ["lake", "family", "dog"]),
    }  # fmt: skip


def tissue_box(cube: bool, ground: str, accent: str, second: str, pattern: str, seed: int) -> Model:
    """A box of paper tissues with one pulled half out."""
    rng = np.random.default_rng(seed)
    skin = printed(prints.tissue_pattern(ground, accent, second, pattern, rng))
    sx, sy, sz = (0.115, 0.115, 0.125) if cube else (0.115, 0.225, 0.075)
    long = (0, 0, 1, 1) if not cube else (0, 0, 0.6, 1)
    short = (0, 0, 0.6, 1)
    body = box(sx, sy, sz, (0, 0, 0), plain(ground, 0.03), 0.003, labels={
        "+x": (skin, long), "-x": (skin, long), "+y": (skin, short), "-y": (skin, short), "+z": (skin, long),
    })  # fmt: skip
    slot = loft([np.c_[0.024 * np.cos(t), 0.052 * np.sin(t), np.full(16, z)] for z, t in ((sz - 0.0004, np.arange(16) * TAU / 16), (sz + 0.0006, np.arange(16) * TAU / 16))], mat=plain("#cfd6da", 0.0))
    paper = plain("#fbfbf9", 0.03, 60)
    rings = []
    n = 18
    for z, wide, deep, wave in ((0, 0.034, 0.007, 0.2), (0.018, 0.03, 0.008, 0.3), (0.045, 0.042, 0.013, 0.45), (0.066, 0.05, 0.016, 0.7), (0.071, 0.042, 0.01, 0.8)):
        ring = []
        for i in range(n):
            t = TAU * i / n
            r = 1 + wave * 0.4 * math.sin(4 * t + 1.1)
            lift = 0.018 * wave * math.sin(3 * t + 0.7) if z > 0.03 else 0.0
            ring.append((deep * r * math.cos(t), wide * r * math.sin(t), sz + z + lift))
        rings.append(ring)
    tissue = loft(rings, mat=paper)
    pieces = [box_piece((0, 0, sz / 2), (sx, sy, sz)), box_piece((0, 0, sz + 0.03), (0.02, 0.07, 0.06))]
    return Model("box of tissues", {"body": Part([body, slot, tissue], collision=pieces)}, mass=0.2)


def tissue_box_random(rng: np.random.Generator) -> dict:
    ground, accent, second = pick(rng, [("#8fc3cf", "#f4f2ea", "#3a7a94"), ("#f3e3e6", "#d9708c", "#7ab0c8"), ("#2f5f7a", "#f2c52a", "#e9eef0")])
    return {"cube": False, "ground": ground, "accent": accent, "second": second, "pattern": pick(rng, ["flowers", "dots", "leaves"]), "seed": seed_of(rng)}


def pen_cup(radius: float, height: float, colour: str, mesh_metal: bool, seed: int) -> Model:
    """A cup full of pens, pencils and a ruler."""
    rng = np.random.default_rng(seed)
    wall = 0.005
    out = metal("5a5f66", "2c2f33", (9, 9, 9), 160) if mesh_metal else plain(colour, 0.04)
    profile = [(0, 0), (radius, 0), (radius, height), (radius - wall, height), (radius - wall, height * 0.6), (0, height * 0.6)]
    cup = lathe(profile, 18, mats=[out, plain(shade(colour, 0.5), 0.02)], mat_of_segment=[0, 0, 0, 1, 1])
    meshes = [cup]
    colours = ["#d8303a", "#2f6fc0", "#f2b92c", "#2f9a5a", "#26282c", "#e87a2c"]
    for k in range(6):
        a = TAU * k / 6 + float(rng.normal(0, 0.15))
        tall = float(rng.uniform(0.145, 0.175))
        if k % 2:
            shape = [(0, 0), (0.0038, 0), (0.0038, tall - 0.018), (0.0010, tall - 0.002), (0, tall)]
            stick = lathe(shape, 6, mats=[plain(colours[k], 0.02), plain("#e2bd88", 0.05)], mat_of_segment=[0, 0, 1, 1])
        else:
            shape = [(0, 0), (0.0045, 0), (0.0045, tall - 0.05), (0.0056, tall - 0.05), (0.005, tall), (0, tall)]
            stick = lathe(shape, 7, mats=[plain("#f0f0ee", 0.0), plain(colours[k], 0.02)], mat_of_segment=[0, 0, 1, 1, 1])
        lean = float(rng.uniform(0.1, 0.22))
        meshes.append(stick.turn(ry=lean).move(-0.1 * math.sin(lean) + radius * 0.55, 0, 0.006).turn(rz=a))
    ruler = box(0.004, 0.024, 0.2, (0, 0, 0), plain("#e9cf7a", 0.05)).turn(rx=-0.1).move(-0.008, -0.004, 0.006)
    pieces = [cylinder_piece(radius, 0, height, 12), cylinder_piece(radius * 0.6, height, height + 0.07, 8, radius * 1.1)]
    return Model("cup of pens", {"body": Part([*meshes, ruler], collision=pieces)}, mass=0.22)


def pen_cup_random(rng: np.random.Generator) -> dict:
    return {"radius": uniform(rng, 0.036, 0.042), "height": uniform(rng, 0.095, 0.105), "colour": pick(rng, ["#2f7f8f", "#e8e2d4", "#c8402c"]), "mesh_metal": False, "seed": seed_of(rng)}


def wall_clock(radius: float, rim: str, paper: str, ink: str, hour: float) -> Model:
    """A round clock to hang on a wall (back at its rear face)."""
    paint = plain(rim, 0.04)
    dial = printed(prints.clock_face(paper, ink, hour))
    r = radius
    case = lathe([(0, 0), (r, 0), (r, 0.03), (r - 0.008, 0.036), (r - 0.018, 0.034), (r - 0.02, 0.024), (0, 0.024)], 32, mats=[paint])
    case.turn(ry=math.pi / 2).move(0, 0, r)
    project_label(case, dial, "+x", (0, r), (2 * r - 0.036, 2 * r - 0.036), 0.9, lambda c: abs(c[0] - 0.024) < 0.001)
    pieces = [cylinder_piece(r, 0, 0.036, 16) @ np.array([[0, 0, -1], [0, 1, 0], [1, 0, 0]]) + [0, 0, r]]
    return Model("wall clock", {"body": Part([case.weigh(1.2)], collision=pieces)}, mass=0.7)


def wall_clock_random(rng: np.random.Generator) -> dict:
    return {"radius": uniform(rng, 0.13, 0.16), "rim": pick(rng, ["#26282c", "#8a5a34", "#c8402c"]), "paper": "#fbf8ee", "ink": "#222222", "hour": uniform(rng, 1, 11.9)}


def placemat(size: tuple[float, float], colours: list[str], pattern: str, is_round: bool) -> Model:
    """A cloth place mat, quite flat."""
    cloth = printed(prints.woven(colours, pattern))
    thick, edge = 0.005, plain(colours[1], 0.08, 150)
    if is_round:
        r = size[0] / 2
        mat = lathe([(0, 0), (r, 0), (r, thick - 0.001), (r - 0.004, thick), (0, thick)], 28, mats=[edge])
        whole, polygon = cylinder_piece(r, 0, thick, 16), round_polygon(r - 0.01)
    else:
        mat = box(size[0], size[1], thick, (0, 0, 0), edge, 0.002)
        whole, polygon = box_piece((0, 0, thick / 2), (*size, thick)), rectangle(size[0] - 0.02, size[1] - 0.02)
    project_label(mat, cloth, "+z", (0, 0), (size[1], size[0]), 0.9)
    return Model("place mat", {"body": Part([mat], collision=[whole])}, mass=0.12, friction=0.8, supports=[Support("top", thick, polygon)])


def placemat_random(rng: np.random.Generator) -> dict:
    return {"size": (uniform(rng, 0.29, 0.33), uniform(rng, 0.4, 0.46)), "colours": ["#f2ecdc", "#3a6a9c", "#c8402c"], "pattern": "check", "is_round": False}


def coaster(size: float, kind: str, light: str, dark: str) -> Model:
    """A drinks coaster: a ring-stained cork disc or a square tile."""
    if kind == "cork":
        m = Material()
        grains = m.voronoi(420)
        m.colour(m.mix(m.remap(m.noise(90, 3), 0.35, 0.65, 0, 0.4), m.ramp(grains, [(0, dark), (0.35, light), (1, blend(light, "#ffffff", 0.2))]), light))
        r = size / 2
        disc = lathe([(0, 0), (r, 0), (r, 0.006), (r - 0.002, 0.0075), (r * 0.86, 0.0075), (r * 0.84, 0.0065), (0, 0.0065)], 24, mat=m)
        whole, polygon = cylinder_piece(r, 0, 0.0075, 14), round_polygon(r - 0.01)
        mesh, z = disc, 0.0075
    else:
        tile = printed(prints.woven([light, dark, blend_hex(light, dark)], "diamonds"))
        mesh, z = box(size, size, 0.008, (0, 0, 0), plain(dark, 0.03), 0.002, labels={"+z": (tile, (0, 0, 0.5, 0.5))}), 0.008
        whole, polygon = box_piece((0, 0, 0.004), (size, size, 0.008)), rectangle(size - 0.02, size - 0.02)
    return Model("coaster", {"body": Part([mesh], collision=[whole])}, mass=0.05, supports=[Support("top", z, polygon)], texture_size=128)


def blend_hex(a: str, b: str) -> str:
    """The colour halfway between two, as text."""
    return "#%02x%02x%02x" % tuple(int(255 * c) for c in blend(a, b, 0.5))


def coaster_random(rng: np.random.Generator) -> dict:
    return {"size": uniform(rng, 0.092, 0.105), "kind": "cork", "light": "#c99a62", "dark": "#6a4526"}


MODELS = {
    "vase": Maker(vase, vase_random, 3, [{"flower": "tulip", "petals": ["#d8303a", "#f2b92c"], "glaze": "#e9e2d2", "band": "#3a6a9c"}, {"shape": "cylinder", "flower": "daisy", "petals": ["#f8f6ee"], "glaze": "#2f7f78"}, {"shape": "flare", "flower": "rose", "petals": ["#d8486a", "#f3b7c0"], "glaze": "#3a4f78"}]),
    "photo_frame": Maker(photo_frame, photo_frame_random, 3, [{"picture": "family"}, {"picture": "lake", "wooden": False, "frame": "#f2f0ea", "width": 0.22, "height": 0.17}, {"picture": "dog", "wooden": False, "frame": "#26282c"}]),
    "tissue_box": Maker(tissue_box, tissue_box_random, 3, [{"pattern": "leaves"}, {"cube": True, "pattern": "flowers", "ground": "#f3e3e6", "accent": "#d9708c", "second": "#7ab0c8"}, {"pattern": "dots", "ground": "#2f5f7a", "accent": "#f2c52a", "second": "#e9eef0"}]),
    "pen_cup": Maker(pen_cup, pen_cup_random, 2, [{}, {"mesh_metal": True}]),
    "wall_clock": Maker(wall_clock, wall_clock_random, 2, [{"rim": "#26282c"}, {"rim": "#8a5a34"}]),
    "placemat": Maker(placemat, placemat_random, 3, [{}, {"pattern": "stripes", "colours": ["#d9c7a2", "#7a5a34", "#a8402c"]}, {"is_round": True, "size": (0.36, 0.36), "pattern": "leaves", "colours": ["#8fb8a0", "#f4f0e0", "#3f6a4c"]}]),
    "coaster": Maker(coaster, coaster_random, 2, [{}, {"kind": "tile", "light": "#eef2f0", "dark": "#2f5f8a"}]),
}  # fmt: skip
