"""Sports things: dumbbell, skateboard."""

from __future__ import annotations

import math

import numpy as np
from labels import prints
from toolkit.materials import label as printed
from toolkit.materials import metal, plain, shade
from toolkit.mesh import Mesh
from toolkit.model import (
    Maker,
    Model,
    Part,
    Support,
    box_piece,
    cylinder_piece,
    rectangle,
)
from toolkit.sampling import pick
from toolkit.shapes import (
    TAU,
    box,
    extrude,
    lathe,
    loft,
    tube,
)

from makers.projection import project_label
from makers.solids import rod, solids


def _plates(length: float, rubber, steel) -> tuple[list[Mesh], list[np.ndarray]]:
    """A long bar with two iron plates at each end, held by star collars."""
    half = length / 2
    meshes = [rod((0, -half, 0), (0, half, 0), 0.013, steel, 10)]
    meshes.append(rod((0, -0.065, 0), (0, 0.065, 0), 0.0155, plain("#26282c", 0.1, 300), 10))
    for q in (-1, 1):
        for k, (r, thick) in enumerate(((0.085, 0.028), (0.068, 0.022))):
            y = q * (0.072 + 0.03 * k)
            ring = [(0, 0), (r * 0.9, 0), (r, thick * 0.2), (r, thick * 0.8), (r * 0.9, thick)]
            ring += [(r * 0.75, thick * 0.8), (0, thick * 0.8)]
            disc = lathe(ring, 14, mat=rubber).turn(rx=-q * math.pi / 2)
            meshes.append(disc.move(y=y))
        star = lathe(
            [(0, 0), (0.03, 0), (0.03, 0.018), (0, 0.018)],
            10,
            mat=plain("#d8202c", 0.04),
            rib=lambda k, i: 1.0 if i % 2 else 0.72,
        )
        meshes.append(star.turn(rx=-q * math.pi / 2).move(y=q * 0.132))
    for mesh in meshes:
        mesh.move(z=0.085)
    ends = [[m for m in meshes[2:] if m.v[:, 1].mean() * q > 0] for q in (-1, 1)]
    return meshes, solids(meshes[:2], *ends)


def _dumbbell(style: str, length: float, colour: str) -> tuple[list[Mesh], list[np.ndarray]]:
    """One hand weight lying on its side, along y."""
    rubber, steel = plain(colour, 0.06, 90), metal("c2c6ca", "767c82", (12, 1, 12), 60)
    if style == "plates":
        return _plates(length, rubber, steel)
    r = length * 0.2
    half = length / 2
    if style == "hex":
        n, profile = (
            6,
            [
                (0, 0),
                (r * 0.72, 0),
                (r, r * 0.28),
                (r, r * 1.2),
                (r * 0.72, r * 1.45),
                (0, r * 1.45),
            ],
        )
        height = r * math.cos(math.pi / 6)
        grip = lathe(
            [(0.013, -half + r), (0.0145, -0.03), (0.016, 0), (0.0145, 0.03), (0.013, half - r)],
            12,
            mat=steel,
        )
    else:
        n, profile = (
            10,
            [(0, 0), (r * 0.7, 0), (r, r * 0.3), (r, r * 1.0), (r * 0.75, r * 1.3), (0, r * 1.3)],
        )
        height = r
        grip = lathe([(0.015, -half + r), (0.0165, 0), (0.015, half - r)], 8, mat=rubber)
    start = 0.0
    heads = []
    for q in (-1, 1):
        head = lathe(profile, n, mat=rubber, start=start)
        if style == "hex":
            head.flat()
        heads.append(head.move(z=-half) if q < 0 else head.scale(1, 1, -1).move(z=half))
    plate = lathe(
        [(0, -0.0006), (r * 0.45, -0.0006), (r * 0.45, 0)], 8, mat=plain(shade(colour, 2.2), 0)
    ).move(z=-half)
    plate2 = plate.copy().scale(1, 1, -1)
    meshes = [*heads, grip, plate, plate2]
    pieces = [
        cylinder_piece(r, -half, -half + 1.4 * r, 8),
        cylinder_piece(r, half - 1.4 * r, half, 8),
        cylinder_piece(0.016, -half + r, half - r, 6),
    ]
    if style == "hex":
        angles = [start + TAU * i / 6 for i in range(6)]
        ends = ((-half, -half + 1.4 * r), (half - 1.4 * r, half))
        pieces[:2] = [
            np.array([(r * math.cos(a), r * math.sin(a), z) for z in span for a in angles])
            for span in ends
        ]
    turn = np.array([[1, 0, 0], [0, 0, 1], [0, -1, 0]])
    for mesh in meshes:
        mesh.turn(rx=-math.pi / 2).move(z=height)
    pieces = [p @ turn.T + [0, 0, height] for p in pieces]
    return meshes, pieces


def dumbbell(style: str, length: float, colour: str, layout: str) -> Model:
    """Hand weights lying about: 'hex' rubber heads, smooth 'round' vinyl or iron 'plates'; 'one',
    a 'pair', or 'rack' (three of growing weight, a rack under them)."""
    meshes: list[Mesh] = []
    pieces: list[np.ndarray] = []

    def put(one: tuple[list[Mesh], list[np.ndarray]], x: float, z: float, turn: float) -> None:
        c, s = math.cos(turn), math.sin(turn)
        matrix = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])
        meshes.extend(m.turn(rz=turn).move(x, 0, z) for m in one[0])
        pieces.extend(np.asarray(p) @ matrix.T + [x, 0, z] for p in one[1])

    if layout == "one":
        put(_dumbbell(style, length, colour), 0, 0, 0)
    elif layout == "pair":
        put(_dumbbell(style, length, colour), -0.055, 0, 0.1)
        put(_dumbbell(style, length, colour), 0.06, 0, -0.35)
    else:
        steel = plain("#3a3d43", 0.05)
        paints = ("#2f8fc0", "#2fa04a", "#e0609a")
        for k, paint in enumerate(paints):
            put(
                _dumbbell(style, length * (1 - 0.12 * k), paint), 0.1 - 0.1 * k, 0.03 + 0.045 * k, 0
            )
        for q in (-1, 1):
            side = [(0.16, 0), (0.16, 0.025), (-0.13, 0.15), (-0.15, 0.15), (-0.15, 0)]
            board = extrude(side, 0.014, mat=steel, axis="y").move(y=q * 0.03)
            meshes.append(board)
            pieces += solids([board])
        for mesh in meshes[:-2]:
            mesh.move(z=0.012)
    return Model(
        "dumbbell" if layout == "one" else "dumbbells",
        {"body": Part(meshes, collision=pieces)},
        mass=round(60 * length**2, 1) * {"one": 1, "pair": 2, "rack": 2}[layout],
        friction=0.7,
        texture_size=128,
    )


def dumbbell_random(rng: np.random.Generator) -> dict:
    return {"style": "hex", "length": 0.22, "colour": "#2a2c30", "layout": "one"}


def _deck_pieces(points: np.ndarray, kicked: bool) -> list[np.ndarray]:
    """One piece for a flat deck; apart from it what is bent up at its ends, where it is."""
    if not kicked:
        return [points]
    half = float(points[:, 0].max())
    cuts = ((-1.0, -0.6), (-0.65, 0.65), (0.6, 1.0))
    x = points[:, 0] / half
    return [points[(x > a - 0.01) & (x < b + 0.01)] for a, b in cuts]


def skateboard(length: float, ground: str, accent: str, wheel: str, pose: str, shape: str) -> Model:
    """A skateboard: 'popsicle' (both ends bent up), 'long' (flat, pointed nose) or 'penny' (short,
    one coloured plastic, a tail); on its 'wheels' or on its 'back'."""
    share = {"popsicle": 0.255, "long": 0.235, "penny": 0.27}[shape]
    width, z0, thick = length * share, 0.082, 0.011
    grip, art = (
        printed(prints.skateboard_deck(ground, accent, True)),
        printed(prints.skateboard_deck(ground, accent, False)),
    )
    ply = plain("#c99a5c", 0.08, 120)
    rings = []
    for t in np.linspace(-1, 1, 17):
        x = t * length / 2
        bend = max(0.0, abs(t) - 0.68) / 0.32
        w = width / 2 * math.sqrt(max(0.02, 1 - max(0.0, (abs(t) - 0.72) / 0.285) ** 2.2))
        if shape == "long":
            bend = 0.0
            w = width / 2 * (1 - abs(t) ** (2.2 if t > 0 else 4.0)) ** 0.7 + 0.006
        elif shape == "penny":
            bend *= 1.3 if t < 0 else 0.15
            w *= 0.86 + 0.14 * math.cos(1.4 * t - 0.3)
        z = z0 + 0.042 * bend**1.5
        dish = 0.004 * (1 - bend)
        rings.append(
            [
                (x, -w, z + dish),
                (x, -w, z + dish + thick),
                (x, 0, z + thick),
                (x, w, z + dish + thick),
                (x, w, z + dish),
                (x, 0, z),
            ]
        )
    deck = loft(rings, mat=ply if shape != "penny" else plain(ground, 0.03))
    if shape != "penny":
        project_label(deck, grip, "+z", (0, 0), (width, length), 0.4)
        project_label(deck, art, "-z", (0, 0), (width, length), 0.4)
    for i, face in enumerate(deck.f):  # the drawings lie along the board
        if deck.mi[i]:
            deck.label_uv[i] = [
                (deck.v[j][0] / length + 0.5, deck.v[j][1] / width + 0.5) for j in face
            ]
    steel, tyre = metal("b4b9be", "62686e"), plain(wheel, 0.04)
    meshes = [deck]
    radius = 0.029
    pieces = [box_piece((0, 0, z0 + 0.006), (length * 0.72, width, 0.016))]
    for q in (-1, 1):
        x = q * length * 0.3
        pieces.append(
            box_piece((q * length * 0.43, 0, z0 + 0.03), (length * 0.14, width * 0.9, 0.03))
        )
        meshes.append(box(0.075, 0.05, 0.012, (x, 0, z0 - 0.011), steel, 0.002))
        meshes.append(
            extrude(
                [(-0.04, 0), (0.04, 0), (0.016, 0.04), (-0.016, 0.04)], 0.022, mat=steel, axis="x"
            ).move(x, 0, 0.034)
        )
        meshes.append(
            tube([(x, -width * 0.42, radius), (x, width * 0.42, radius)], 0.006, 6, mat=steel)
        )
        for s in (-1, 1):
            w = 0.017
            profile = [(0, -w), (0.024, -w), (radius, -w * 0.6), (radius, w * 0.6), (0.024, w)]
            disc = lathe(
                [*profile, (0, w)], 10, mats=[tyre, steel], mat_of_segment=[0, 0, 0, 0, 0]
            ).turn(rx=math.pi / 2)
            meshes.append(disc.move(x, s * width * 0.42, radius))
            pieces.append(
                cylinder_piece(radius, -w, w, 10) @ np.array([[1, 0, 0], [0, 0, 1], [0, 1, 0]])
                + [x, s * width * 0.42, radius]
            )
    if shape != "popsicle":  # flat: one piece for the whole deck
        wheels = [p for p in pieces if np.ptp(p[:, 0]) < 0.07]
        pieces = [*wheels, *_deck_pieces(deck.v, kicked=shape == "penny")]
    supports = [Support("deck", z0 + thick + 0.002, rectangle(length * 0.6, width - 0.04))]
    if pose != "wheels":
        for mesh in meshes:
            mesh.keep_pattern().turn(rx=math.pi)
        low = min(float(m.v[:, 2].min()) for m in meshes)
        pieces = [p * [1, -1, -1] - [0, 0, low] for p in pieces]
        for mesh in meshes:
            mesh.move(z=-low)
        supports = []
    return Model(
        "skateboard",
        {"body": Part(meshes, collision=pieces)},
        mass=2.4,
        friction=0.3,
        supports=supports,
    )


def skateboard_random(rng: np.random.Generator) -> dict:
    ground, accent = pick(
        rng, [("#2a6fb0", "#f2c53a"), ("#c8302c", "#f6f4ee"), ("#2f8a5a", "#f2a83a")]
    )
    return {
        "length": 0.78,
        "pose": "wheels",
        "shape": "popsicle",
        "ground": ground,
        "accent": accent,
        "wheel": pick(rng, ["#f2ead0", "#e8502c", "#3fa0c8"]),
    }


MODELS = {
    "dumbbell": Maker(
        dumbbell,
        dumbbell_random,
        6,
        [
            {},
            {"style": "round", "colour": "#c8306a", "length": 0.2},
            {"style": "round", "colour": "#2f8fc0", "length": 0.18, "layout": "pair"},
            {"style": "plates", "length": 0.36},
            {"layout": "pair"},
            {"style": "round", "layout": "rack", "length": 0.2},
        ],
    ),
    "skateboard": Maker(
        skateboard,
        skateboard_random,
        6,
        [
            {"ground": "#2a6fb0", "accent": "#f2c53a", "wheel": "#f2ead0"},
            {"ground": "#c8302c", "accent": "#e8502c", "wheel": "#e8502c"},
            {"ground": "#c8302c", "accent": "#f2c53a", "wheel": "#f2ead0", "pose": "back"},
            {
                "ground": "#2f8a5a",
                "accent": "#f2a83a",
                "wheel": "#e8702c",
                "shape": "long",
                "length": 0.94,
            },
            {
                "ground": "#1fb0c0",
                "accent": "#f2c53a",
                "wheel": "#f0407a",
                "shape": "penny",
                "length": 0.58,
            },
            {
                "ground": "#e8b92c",
                "accent": "#f2f2ee",
                "wheel": "#3fa0c8",
                "shape": "long",
                "length": 0.94,
                "pose": "back",
            },
        ],
    ),
}
