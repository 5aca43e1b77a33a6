"""Cut flowers in vases: lilies, and bunches without any."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
from PIL import Image
from toolkit import labels
from toolkit.materials import Material, label, plain, shade
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part, cylinder_piece
from toolkit.sampling import noise_offset
from toolkit.shapes import TAU, lathe, tube

#: Outlines of vases, (radius, height) of one 0.2 m high.
VASES = {
    "tall": [(0.04, 0), (0.046, 0.006), (0.043, 0.08), (0.05, 0.16), (0.058, 0.2)],
    "belly": [(0.04, 0), (0.062, 0.03), (0.074, 0.08), (0.052, 0.14), (0.04, 0.165), (0.052, 0.2)],
    "jug": [(0.05, 0), (0.056, 0.008), (0.066, 0.06), (0.05, 0.13), (0.056, 0.2)],
}


def pot(shape: str, height: float, glaze: str, rng: np.random.Generator, n: int = 10) -> Mesh:
    """A vase; one looks into it to where the stems go."""
    s = height / 0.2
    outer = [(r * s, z * s) for r, z in VASES[shape]]
    (rim, top), clay = outer[-1], plain(glaze, 0.08, 40, noise_offset(rng))
    inner = [(rim - 0.006, top), (0, top - 0.02)]
    count = len(outer)
    return lathe(
        [(0, 0), *outer, *inner],
        n,
        mats=[clay, plain("#4f6a3c", 0.2, 120)],
        mat_of_segment=[0] * (count + 1) + [1],
    )


def petal(stations: list[tuple[float, float, float]], cup: float, mat: Material) -> Mesh:
    """A pointed petal out along +x: (x, z, half its width) up to its tip, seen from both sides.

    cup: how far its edges stand above its middle, as a share of half its width.
    """
    vertices, rows = [], []
    for x, z, w in stations[:-1]:
        rows.append(len(vertices))
        vertices += [(x, -w, z + cup * w), (x, 0, z), (x, w, z + cup * w)]
    x, z, _ = stations[-1]
    tip = len(vertices)
    vertices.append((x, 0, z))
    faces = []
    for a, b in pairwise(rows):
        faces += [(a, b, b + 1, a + 1), (a + 1, b + 1, b + 2, a + 2)]
    faces += [(rows[-1], tip, rows[-1] + 1), (rows[-1] + 1, tip, rows[-1] + 2)]
    points = np.array(vertices)
    along = (points[:, 0] - points[0, 0]) / (x - points[0, 0])
    widest = max(w for _, _, w in stations)
    drawn = [(0.5 + 0.5 * v[1] / widest, t) for v, t in zip(vertices, along, strict=True)]
    length = float(np.linalg.norm(np.diff([(q[0], q[1]) for q in stations], axis=0), axis=1).sum())
    flat = [(v[1], t * length) for v, t in zip(vertices, along, strict=True)]
    below = len(points)
    back = [tuple(i + below for i in f[::-1]) for f in faces]
    thick = np.zeros((below, 3))
    thick[[r + 1 for r in rows], 2] = 0.002  # a lens: both sides meet at the rim
    points = np.r_[points, points - thick]
    both = faces + back
    luv = [[drawn[i % below] for i in f] for f in both]
    buv = [[flat[i] for i in f] for f in faces]
    buv += [[(3 * widest - flat[i - below][0], flat[i - below][1]) for i in f] for f in back]
    return Mesh(points, both, None, [mat], luv, buv)


def lily_petal(ground: str, middle: str, throat: str, dots: str) -> Image.Image:
    """A petal from its throat (below) to its tip."""
    image, draw = labels.canvas(64, 128, ground)
    draw.polygon([(32, 2), (46, 50), (42, 128), (22, 128), (18, 50)], fill=middle)
    draw.polygon([(32, 60), (64, 128), (0, 128)], fill=throat)
    draw.line([(32, 0), (32, 128)], fill=shade_hex(middle, 0.86), width=3)
    if dots:
        rng = np.random.default_rng(2)
        for _ in range(26):
            x, y = 32 + rng.normal(0, 9), rng.uniform(52, 112)
            draw.ellipse((x - 1.8, y - 2.4, x + 1.8, y + 2.4), fill=dots)
    return image.convert("RGB")


def shade_hex(colour: str, factor: float) -> str:
    """A darker or lighter colour as Pillow takes it."""
    return "#" + "".join(f"{int(255 * c):02x}" for c in shade(colour, factor))


def trumpet(size: float, mats: tuple[Material, Material, Material]) -> list[Mesh]:
    """An open lily looking up: six petals that bend out and back, orange anthers on filaments."""
    out: list[Mesh] = []
    for k in range(6):
        inner = k % 2  # three broad petals above three narrow ones
        w = (0.27 if inner else 0.2) * size
        low = 0.0 if inner else -0.012 * size
        stations = [(0.05, 0.0, 0.08 * size), (0.26, 0.4, 0.8 * w), (0.66, 0.64, w)]
        stations = [(x * size, z * size + low, half) for x, z, half in stations]
        stations.append((1.06 * size, 0.5 * size + low, 0.0))
        out.append(petal(stations, 0.3, mats[0]).turn(rz=k * TAU / 6))
    throat = [(0, -0.28 * size), (0.09 * size, 0.02 * size), (0, 0.1 * size)]
    out.append(lathe(throat, 4, mat=mats[1]))
    for k in range(5):
        a = k * TAU / 5 + 0.3
        r, z, long = 0.3 * size, 0.78 * size, 0.1 * size
        ends = [(r, -long, z), (r, long, z), (r - 0.03 * size, 0, z + 0.07 * size)]
        ends.append((0.08 * size, 0, 0.1 * size))  # one thin spike is filament and anther
        faces = [(0, 1, 2), (0, 3, 1), (0, 2, 3), (1, 3, 2)]
        anther = Mesh(ends, faces, None, [mats[2]])
        out.append(anther.outward().turn(rz=a).weigh(0.6))
    return out


def bud(size: float, mat: Material) -> list[Mesh]:
    """A lily that is still shut, upright."""
    shape = [(0, -0.3), (0.12, -0.1), (0.2, 0.4), (0.13, 0.85), (0, 1.05)]
    return [lathe([(r * size, z * size) for r, z in shape], 5, mat=mat)]


def blade(length: float, width: float, mat: Material) -> Mesh:
    """A long pointed leaf out along +x, bending down."""
    stations = [(0.0, 0.0, 0.3), (0.35, 0.3, 1.0), (0.75, 0.34, 0.7), (1.0, 0.18, 0.0)]
    shape = [(x * length, z * length, w * width / 2) for x, z, w in stations]
    return petal(shape, 0.35, mat)


def stem(start, tip, mat: Material, radius: float = 0.004) -> Mesh:
    a, b = np.array(start, float), np.array(tip, float)
    middle = 0.45 * a + 0.55 * b - [0.2 * b[0], 0.2 * b[1], 0]
    return tube([a, middle, b], radius, 3, mat=mat, weight=0.4)


def arranged(
    shape: str, height: float, glaze: str, meshes: list[Mesh], title: str, seed: int, sides: int
) -> Model:
    """The model of a vase with what stands in it."""
    body = pot(shape, height, glaze, np.random.default_rng(seed), sides)
    s = height / 0.2
    outline = [(r * s, z * s) for r, z in VASES[shape]]
    pieces = [
        cylinder_piece(r0, z0, z1, 10, r1)
        for (r0, z0), (r1, z1) in pairwise(outline)
        if z1 - z0 > 0.01
    ]
    pieces[0] = cylinder_piece(outline[0][0], 0, outline[2][1], 10, outline[2][0])
    points = np.concatenate([m.v for m in meshes])
    crown = points[points[:, 2] > height + 0.02]
    reach = float(np.quantile(np.linalg.norm(crown[:, :2], axis=1), 0.9))
    top = float(points[:, 2].max())
    third = height + 0.3 * (top - height)
    pieces.append(cylinder_piece(outline[-1][0], height, third, 8, 0.8 * reach))
    pieces.append(cylinder_piece(reach, third, top - 0.01, 8, 0.8 * reach))
    return Model(
        title,
        {"body": Part([body, *meshes], collision=pieces)},
        mass=1.6,
        friction=0.6,
        texture_size=128,
        prune=False,
        occlusion_strength=0.8,
    )


def lilies(shape: str, height: float, glaze: str, petals: tuple[str, ...], seed: int) -> Model:
    """Three open lilies and two buds in a vase."""
    rng = np.random.default_rng(seed)
    s = height / 0.2
    green, dark = plain("#5f9a44", 0.16, 60), plain("#3f7a38", 0.16, 60)
    face = label(lily_petal(*petals), occlusion=0.5)
    mats = face, plain("#a8c46a", 0.05), plain("#d8701c", 0.1, 200)
    bud_mat = plain(shade(petals[1], 0.96), 0.08, 60)
    meshes: list[Mesh] = []
    base = height - 0.02
    turn = 0.35
    places = [(0.0, 0.075, 0.2, 0.95), (2.1, 0.085, 0.15, 1.0), (4.2, 0.08, 0.11, 1.1)]
    for k, (a, reach, up, lean) in enumerate(places):
        a += turn + float(rng.normal(0, 0.1))
        tip = np.array([reach * s * math.cos(a), reach * s * math.sin(a), height + up * s])
        meshes.append(stem((0.02 * math.cos(a), 0.02 * math.sin(a), base), tip, green))
        size = 0.082 + 0.004 * (k % 2)
        for mesh in trumpet(size, mats):
            meshes.append(mesh.turn(rz=0.4 * k).turn(ry=lean).turn(rz=a).move(*tip))
    for a, reach, up, lean in ((1.0, 0.05, 0.24, 0.35), (5.2, 0.07, 0.2, 0.55)):
        a += turn
        tip = np.array([reach * math.cos(a), reach * math.sin(a), height + up * s])
        meshes.append(stem((0, 0.01, base), tip, green))
        meshes += [m.turn(ry=lean).turn(rz=a).move(*tip) for m in bud(0.075, bud_mat)]
    for k in range(5):
        a = turn + k * TAU / 5 + 0.5
        leaf = blade(0.13 + 0.02 * (k % 2), 0.034, dark).turn(ry=-0.5 + 0.2 * (k % 2)).turn(rz=a)
        meshes.append(leaf.move(0.02 * math.cos(a), 0.02 * math.sin(a), height + 0.02 * (k % 3)))
    return arranged(shape, height, glaze, meshes, "vase of lilies", seed, 9)


# ---- other flowers
def rose(size: float, colour: str) -> list[Mesh]:
    """A rose looking up, its petals in two whorls about a dark heart."""
    outer, inner = plain(colour, 0.1, 150), plain(shade(colour, 0.72), 0.12, 200)
    shape = [(0, -0.5), (0.72, -0.2), (1.0, 0.3), (0.72, 0.36), (0.74, 0.62), (0.4, 0.5), (0, 0.72)]
    mesh = lathe(
        [(r * size, z * size) for r, z in shape],
        7,
        mats=[outer, inner],
        mat_of_segment=[0, 0, 1, 0, 1, 0],
        rib=lambda k, i: 1 + 0.1 * math.sin(2.6 * i + 1.7 * k),
    )
    return [mesh]


def tulip(size: float, colour: str) -> list[Mesh]:
    """A tulip's cup with its pointed rim."""
    paint = plain(colour, 0.1, 120)
    shape = [(0, -0.55), (0.66, -0.3), (0.84, 0.3), (0.6, 1.15), (0.36, 0.7), (0, 0.1)]
    return [
        lathe(
            [(r * size, z * size) for r, z in shape],
            6,
            mat=paint,
            rib=lambda k, i: 1.14 - 0.26 * (i % 2) if k in (2, 3) else 1.0,
        )
    ]


def rayed(size: float, colour: str, heart: str, share: float, rays: int, back: str) -> list[Mesh]:
    """A daisy or a sunflower looking up: many blunt petals about a round heart."""
    paint, middle = plain(colour, 0.1, 160), plain(heart, 0.25, 260)
    shape = [(0, -0.14), (1.0, 0.02), (share, 0.1), (0, 0.24)]
    mesh = lathe(
        [(r * size, z * size) for r, z in shape],
        2 * rays,
        mats=[plain(back, 0.12, 90), paint, middle],
        mat_of_segment=[0, 1, 2],
        rib=lambda k, i: 1.0 if i % 2 or k != 1 else 0.8,
    )
    return [mesh]


HEADS = {
    "rose": lambda c: rose(0.034, c),
    "tulip": lambda c: tulip(0.034, c),
    "sunflower": lambda c: rayed(0.075, c, "#4a2c14", 0.5, 13, "#7a8a34"),
    "daisy": lambda c: rayed(0.036, c, "#eaa81c", 0.42, 9, "#dfe2cc"),
}
#: Flowers in a bunch, so that it stays light.
COUNT = {"rose": 6, "tulip": 8, "sunflower": 3, "daisy": 6, "mixed": 7}


def bouquet(
    shape: str, height: float, glaze: str, flower: str, petals: tuple[str, ...], seed: int
) -> Model:
    """A bunch of one kind, or "mixed" of roses, daisies and tulips."""
    rng = np.random.default_rng(seed)
    green, leaf_mat = plain("#4f8a3c", 0.15, 80), plain("#3f7a38", 0.18, 60)
    meshes: list[Mesh] = []
    count, big = COUNT[flower], flower == "sunflower"
    for k in range(count):
        kind = ("rose", "daisy", "tulip")[k % 3] if flower == "mixed" else flower
        first = k == 0 and not big
        a = TAU * k / max(count - (not big), 1) + float(rng.normal(0, 0.15)) + 0.3
        reach = 0.0 if first else (0.075 if big else float(rng.uniform(0.065, 0.088)))
        up = 0.15 if first else float(rng.uniform(0.075, 0.125)) + (0.05 if big else 0.0)
        tip = np.array([reach * math.cos(a), reach * math.sin(a), height + up])
        start = (0.02 * math.cos(a), 0.02 * math.sin(a), height - 0.02)
        meshes.append(stem(start, tip, green, 0.0045 if big else 0.003))
        lean = 0.1 if first else 0.95 if big else 0.7 if kind == "daisy" else 0.45
        for mesh in HEADS[kind](petals[k % len(petals)]):
            meshes.append(mesh.turn(ry=lean).turn(rz=a).move(*tip))
    for k in range(5):
        a = k * TAU / 5 + 0.9
        long, wide = (0.1, 0.055) if flower != "tulip" else (0.14, 0.03)
        leaf = blade(long, wide, leaf_mat).turn(ry=-0.5 + 0.3 * (k % 2)).turn(rz=a)
        meshes.append(leaf.move(0.02 * math.cos(a), 0.02 * math.sin(a), height + 0.01))
    names = {"mixed": "mixed flowers"}
    title = f"vase of {names.get(flower, flower.replace('daisy', 'daisie') + 's')}"
    return arranged(shape, height, glaze, meshes, title, seed, 10)


def nothing_random(rng: np.random.Generator) -> dict:
    return {}


_WHITE = ("#f8f6ee", "#f2f0e2", "#b8cc7a", "")
_STARGAZER = ("#fbe9ef", "#e05a8c", "#c8d488", "#9a1f4a")
_PINK = ("#f4bccb", "#f8dbe2", "#cdd68a", "")
_TALL = {"shape": "tall", "height": 0.24, "seed": 3}
_ROUND = {"shape": "belly", "height": 0.19, "seed": 8}

MODELS = {
    "lilies": Maker(
        lilies,
        nothing_random,
        4,
        [
            {"petals": _WHITE, "glaze": "#3f6f8f", **_TALL},
            {"petals": _STARGAZER, "glaze": "#e9e6dc", **_TALL},
            {"petals": _PINK, "glaze": "#5a6a5c", **_ROUND},
            {"petals": _WHITE, "glaze": "#b56a4a", **_ROUND},
        ],
    ),
    "bouquet": Maker(
        bouquet,
        nothing_random,
        5,
        [
            {"flower": "rose", "petals": ("#c81e34", "#d83a4a"), "glaze": "#dfe6e6"}
            | {"shape": "tall", "height": 0.2, "seed": 1},
            {"flower": "tulip", "petals": ("#e8b01c", "#d8303a", "#e86a2a"), "glaze": "#3a5f94"}
            | {"shape": "jug", "height": 0.19, "seed": 2},
            {"flower": "sunflower", "petals": ("#f2b81c",), "glaze": "#8a4a30"}
            | {"shape": "jug", "height": 0.22, "seed": 3},
            {"flower": "daisy", "petals": ("#fbf9f2",), "glaze": "#4f8f8a"}
            | {"shape": "belly", "height": 0.15, "seed": 4},
            {"flower": "mixed", "petals": ("#d8486a", "#fbf9f2", "#8a4ab0"), "glaze": "#e6d9bc"}
            | {"shape": "belly", "height": 0.18, "seed": 5},
        ],
    ),
}
