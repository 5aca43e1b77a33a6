"""Heaps and stacks of clothes: sheets laid over one another by height fields, no solver."""

from __future__ import annotations

import cloth
import numpy as np
from labels import garments
from labels.drawing import shade as tint
from PIL import Image
from toolkit.labels import canvas
from toolkit.materials import Material, plain, shade
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part, box_piece
from toolkit.sampling import noise_offset, seed_of
from toolkit.shapes import box, spline, tube

from makers.convex import few_corners
from makers.soft_forms import Field, drape, folds, mound
from makers.soft_things import folded

OUTLINES = {
    "shirt": cloth.SHIRT,
    "trousers": cloth.TROUSERS,
    "towel": cloth.TOWEL,
    "sock": cloth.SOCK,
}

# what lies where: position (cm), turn, squeeze; from the floor up
HEAPS: list[list[dict]] = [
    [
        {"kind": "trousers", "colour": "#3f5f94", "second": "#d8a24a", "at": (4, -6), "turn": 0.5},
        {"kind": "shirt", "colour": "#efeae0", "second": "#c8303a", "style": "stripes",
         "at": (-5, 7), "turn": 2.1},
        {"kind": "shirt", "colour": "#c8453a", "second": "#f4f0e6", "style": "print",
         "at": (3, 1), "turn": -1.1, "squeeze": 0.5},
        {"kind": "sock", "colour": "#f2f2ee", "second": "#2f5fa8", "at": (15, -17), "turn": 0.6},
    ],
    [
        {"kind": "towel", "colour": "#7fa8b8", "second": "#f4f4f0", "at": (2, 9), "turn": 0.5},
        {"kind": "trousers", "colour": "#34363e", "second": "#7a7e88", "at": (-4, -7), "turn": 1.9},
        {"kind": "shirt", "colour": "#f2c53a", "second": "#2f4f8a", "style": "print",
         "at": (4, -1), "turn": -1.8, "squeeze": 0.5},
        {"kind": "sock", "colour": "#c8303a", "second": "#f2f2ee", "at": (14, 14), "turn": 2.0},
    ],
    [
        {"kind": "shirt", "colour": "#f2f0ea", "second": "#2f4f8a", "style": "stripes",
         "at": (3, -16), "turn": 2.6},
        {"kind": "shirt", "colour": "#7fb0d0", "second": "#f4f4f0", "style": "buttons",
         "at": (-2, 12), "turn": -1.3, "squeeze": 0.55},
        {"kind": "trousers", "colour": "#4a6aa0", "second": "#e0b060", "at": (6, 0), "turn": 1.4,
         "squeeze": 0.55},
        {"kind": "sock", "colour": "#3a3a44", "second": "#e8862c", "at": (12, 22), "turn": 0.2},
    ],
]  # fmt: skip


def outside(garment: dict, rng: np.random.Generator) -> Material:
    """The garment's drawing with a little mottling."""
    kind, colour, second = garment["kind"], garment["colour"], garment["second"]
    if kind == "shirt":
        picture = garments.shirt(colour, second, garment.get("style", "plain"))
    else:
        draw = {"trousers": garments.trousers, "sock": garments.sock, "towel": garments.towel}
        picture = draw[kind](colour, second)
    m = Material()
    creases = m.noise(60, 3, offset=noise_offset(rng))
    dark = m.mix(0.25, m.image(picture), "#000000")
    return m.colour(m.mix(m.remap(creases, 0.35, 0.65, 0.45, 0), m.image(picture), dark))


def heap(
    things: list[dict],
    field: Field,
    rng: np.random.Generator,
    size: float,
    crumple: float,
    spacing: float = 0.085,
) -> list[Mesh]:
    """Garments laid one after the other over a height field; `size` scales them all."""
    meshes = []
    for g in things:
        s = size * g.get("squeeze", 0.62) / 0.62
        small = g["kind"] == "sock"
        mats = outside(g, rng), plain(shade(g["colour"], 0.72), 0.06, 60)
        fold = folds(rng, crumple * (0.3 if small else 1.0))
        mesh, field = drape(
            OUTLINES[g["kind"]],
            0.055 if small else spacing,
            field,
            fold,
            (g["at"][0] / 100, g["at"][1] / 100),
            g["turn"],
            (s * (1.5 if small else 1.0), s * (1.5 if small else 1.0)),
            mats,
        )
        meshes.append(mesh)
    return meshes


def heap_pieces(points: np.ndarray) -> list[np.ndarray]:
    """Low convex pieces: the heap cut into four quarters about its middle."""
    middle = np.median(points[:, :2], 0)
    pieces = []
    for sx in (-1, 1):
        for sy in (-1, 1):
            near = ((points[:, :2] - middle) * [sx, sy] > -0.02).all(1)
            if near.sum() > 8:
                quarter = points[near]
                floor = quarter * [1, 1, 0]
                pieces.append(np.r_[few_corners(quarter, 22), few_corners(floor, 10)])
    return pieces


def clothes_pile(
    things: list[dict],
    radius: tuple[float, float],
    height: float,
    size: float,
    crumple: float,
    limb: str,
    seed: int,
) -> Model:
    """A heap of garments as dropped; `limb`: colour of a trouser leg sticking out, or none."""
    rng = np.random.default_rng(seed)
    field = mound(radius, height, rng)
    meshes = heap(things, field, rng, size, crumple)
    if limb:
        meshes += trouser_leg(limb, radius, rng)
    everything = np.concatenate([m.v for m in meshes])
    lowest = float(everything[:, 2].min())
    for mesh in meshes:
        mesh.move(z=-lowest)
    pieces = heap_pieces(np.concatenate([m.v for m in meshes]))
    names = {"shirt": "shirts"}
    kinds = ", ".join(sorted({names.get(g["kind"], g["kind"]) for g in things}))
    part = Part(meshes, collision=pieces)
    return Model(f"heap of clothes ({kinds})", {"body": part}, mass=1.5, friction=0.9)


def trouser_leg(colour: str, radius: tuple[float, float], rng: np.random.Generator) -> list[Mesh]:
    """A wrinkled trouser leg that runs out of the heap, its cuff open."""
    cloth_mat, dark = plain(colour, 0.12, 50), plain(shade(colour, 0.35), 0.05)
    rx, ry = radius
    points = [(0.0, 0.5 * ry, 0.1), (0.3 * rx, 0.95 * ry, 0.06), (0.55 * rx, 1.3 * ry, 0.05)]
    points += [(0.9 * rx, 1.5 * ry, 0.045), (1.2 * rx, 1.5 * ry, 0.045)]
    path = spline(points, 2)
    radii = 0.058 * (1 + 0.12 * np.sin(np.arange(len(path)) * 2.6 + rng.uniform(0, 6)))
    leg = tube(path, radii, 8, mat=cloth_mat, flatten=0.72, up=(0, 0, 1))
    along = path[-1] - path[-2]
    along = along / np.linalg.norm(along)
    cuff = tube([path[-1] - along * 0.03, path[-1] + along * 0.012], 0.064, 8,
                mat=plain(shade(colour, 1.25), 0.08), flatten=0.72, up=(0, 0, 1))  # fmt: skip
    hole = tube([path[-1], path[-1] + along * 0.013], 0.05, 8, mat=dark, flatten=0.7, up=(0, 0, 1))
    return [leg, cuff, hole]


def _folded_shirt(colour: str) -> Image.Image:
    """What shows of a shirt folded to a packet: collar, placket, buttons."""
    image, draw = canvas(192, 160, colour)
    seam = tint(colour, 0.6)
    draw.rectangle((82, 36, 110, 160), fill=tint(colour, 0.9), outline=seam, width=2)
    for k in range(4):
        y = 52 + 30 * k
        draw.ellipse((91, y, 101, y + 10), fill="#f8f4e8", outline=seam, width=2)
    draw.pieslice((62, -30, 130, 36), 0, 180, fill=tint(colour, 0.45))
    for q in (-1, 1):
        x = 96 + 36 * q
        draw.polygon(
            [(x, 0), (96, 40), (96 + 22 * q, 62), (x + 16 * q, 14)], fill=tint(colour, 1.15)
        )
        draw.line([(x, 0), (96, 40), (96 + 22 * q, 62), (x + 16 * q, 14)], fill=seam, width=4)
    draw.rectangle((124, 84, 168, 130), outline=seam, width=3)
    return image


def clothes_stack(items: list[tuple[str, str]], seed: int) -> Model:
    """Neatly folded garments on one another, the fold of each to the front."""
    rng = np.random.default_rng(seed)
    meshes, pieces, z = [], [], 0.0
    for kind, colour in items:
        jeans = kind == "jeans"
        long, wide, layer = (0.24, 0.3, 0.024) if jeans else (0.25, 0.27, 0.018)
        m = Material()
        base = m.mottle(colour, 0.1, 70, noise_offset(rng))
        if kind == "stripes":
            wave = m.math("SINE", m.math("MULTIPLY", m.axis(1), 230.0))
            base = m.mix(m.remap(wave, 0.1, 0.2), base, "#f4f2ec")
        m.colour(base)
        sheet = folded(long, wide, layer, 2, m, rng)[0]
        sheet.keep_pattern()
        sheet.turn(rz=float(np.pi + rng.normal(0, 0.05)))
        sheet.move(*(float(q) for q in rng.normal(0, 0.008, 2)), z)
        meshes.append(sheet)
        low, high = sheet.v.min(0), sheet.v.max(0)
        pieces.append(box_piece((low + high) / 2, high - low))
        z = float(high[2])
    top = meshes[-1].v
    middle = (top.min(0) + top.max(0)) / 2
    face = Material()
    face.colour(face.image(_folded_shirt(items[-1][1])))
    sheet = box(0.2, 0.24, 0.002, (middle[0], middle[1], z - 0.0005), face, labels={"+z": face})
    meshes.append(sheet)
    part = Part(meshes, collision=pieces)
    return Model("stack of folded clothes", {"body": part}, mass=1.8, friction=0.9)


def clothes_pile_any(shape: str, **more) -> Model:
    return clothes_stack(**more) if shape == "stack" else clothes_pile(**more)


def clothes_pile_random(rng: np.random.Generator) -> dict:
    return {"shape": "heap", "seed": seed_of(rng)}


def _heap(things: list[dict], radius, height, size=0.64, crumple=0.035, limb="") -> dict:
    return {
        "things": things,
        "radius": radius,
        "height": height,
        "size": size,
        "crumple": crumple,
        "limb": limb,
    }


MODELS = {
    "clothes_pile": Maker(
        clothes_pile_any,
        clothes_pile_random,
        6,
        [
            _heap(HEAPS[0], (0.27, 0.27), 0.14),
            _heap(HEAPS[1], (0.25, 0.25), 0.2, 0.62, 0.04, "#4a6aa0"),
            _heap(HEAPS[2], (0.2, 0.31), 0.13, 0.6, 0.05),
            {
                "shape": "stack",
                "items": [
                    ("jeans", "#3f5f94"),
                    ("plain", "#c8453a"),
                    ("stripes", "#2f4f8a"),
                    ("plain", "#efeae0"),
                ],
            },
            _heap(
                [
                    {
                        "kind": "shirt",
                        "colour": "#d8d4c8",
                        "second": "#3a7f5a",
                        "style": "stripes",
                        "at": (0, 0),
                        "turn": 1.2,
                        "squeeze": 0.6,
                    },
                    {
                        "kind": "trousers",
                        "colour": "#5b6f8f",
                        "second": "#e0b060",
                        "at": (0, 5),
                        "turn": 0.1,
                        "squeeze": 0.62,
                    },
                ],
                (0.3, 0.2),
                0.08,
                0.8,
                0.06,
                "",
            ),
            {
                "shape": "stack",
                "items": [
                    ("jeans", "#2b2f3a"),
                    ("jeans", "#5f86b8"),
                    ("stripes", "#b8404c"),
                    ("plain", "#7fb0d0"),
                ],
            },
        ],
    ),
}
