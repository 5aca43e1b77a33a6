"""Small parts a child may swallow: each model is a few loose pieces lying close together."""

from __future__ import annotations

import math

import numpy as np
from toolkit.labels import canvas, text
from toolkit.materials import Material, metal, plain, shade
from toolkit.materials import label as printed
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part
from toolkit.sampling import noise_offset, pick, seed_of
from toolkit.shapes import TAU, box, ellipsoid, lathe, tube

from makers.convex import few_corners
from makers.projection import project_label

# a thin thing would throw shadow acne onto itself
NO_SHADOW = (1.0, 1.0, 1.0, 0.999)

Place = tuple[float, float]


def close_together(
    radii: list[float], rng: np.random.Generator, gap: float = 0.0015, spread: float = 0.012
) -> list[Place]:
    """Where discs lie when each has rolled as near to the middle as the earlier ones let it."""
    placed: list[Place] = []
    for k, radius in enumerate(radii):
        best: Place | None = None
        for angle in np.linspace(0, TAU, 25)[:-1] + rng.uniform(0, TAU):
            x, y = (math.cos(angle), math.sin(angle)) if k else (0.0, 0.0)
            away = 0.0
            room = gap + float(rng.uniform(0, spread))
            while any(
                math.hypot(x * away - a, y * away - b) < radius + radii[i] + room
                for i, (a, b) in enumerate(placed)
            ):
                away += 0.001
            if best is None or away < math.hypot(*best):
                best = (x * away, y * away)
        placed.append(best or (0.0, 0.0))
    return placed


def loose(
    title: str,
    pieces: list[list[Mesh]],
    mass: float,
    shadow: bool = True,
    size: int = 256,  # pieces of other colours lie next to one another in the atlas
) -> Model:
    """A model of loose pieces: each piece (some meshes) has a convex hull of its own."""
    hulls = [few_corners(np.concatenate([m.v for m in piece]), 22) for piece in pieces]
    meshes = [mesh for piece in pieces for mesh in piece]
    part = Part(meshes, collision=hulls, rgba=None if shadow else NO_SHADOW)
    return Model(title, {"body": part}, mass=mass, friction=0.4, texture_size=size)


def glass_swirl(base: str, vane: str, rng: np.random.Generator) -> Material:
    """A marble: a coloured vane inside clear glass, a window's reflection near the top."""
    m = Material(occlusion=0.5)
    twist = m.noise(70, 2, distortion=1.6, offset=noise_offset(rng))
    colour = m.ramp(twist, [(0.42, base), (0.48, vane), (0.56, vane), (0.62, base)])
    towards = m.math(
        "ADD",
        m.math("MULTIPLY", m.normal(2), 0.8),
        m.math("ADD", m.math("MULTIPLY", m.normal(0), 0.5), m.math("MULTIPLY", m.normal(1), -0.3)),
    )
    rim = m.mix(m.remap(m.normal(2), -0.7, 0.3, 0.45, 0), colour, shade(base, 0.35))
    return m.colour(m.mix(m.remap(towards, 0.9, 0.95), rim, "ffffff"))


def marbles(radii: list[float], colours: list[tuple[str, str]], seed: int) -> Model:
    """Glass marbles that have rolled to a stop."""
    rng = np.random.default_rng(seed)
    places = close_together(radii, rng, 0.0005)
    pieces = []
    for k, (radius, (x, y)) in enumerate(zip(radii, places, strict=True)):
        base, vane = colours[k % len(colours)]
        ball = ellipsoid(radius, (0, 0, 0), 9, 6, glass_swirl(base, vane, rng))
        pieces.append([ball.turn(*rng.uniform(0, 0.3, 3)).move(x, y, radius)])
    return loose("glass marbles", pieces, 0.05)


def marbles_random(rng: np.random.Generator) -> dict:
    return {"radii": [0.0125, *[0.008] * 5], "seed": seed_of(rng)}


def coin_face(words: str, ring: str, core: str) -> Material:
    """A coin from above: raised rim, value, a ring of another metal or none."""
    picture, draw = canvas(96, 96, ring)
    dark = "#" + "".join(f"{int(255 * c):02x}" for c in shade(core, 0.38))
    rim = "#" + "".join(f"{int(255 * c):02x}" for c in shade(ring, 0.62))
    light = "#" + "".join(f"{int(255 * c):02x}" for c in shade(ring, 1.25))
    draw.ellipse((1, 1, 94, 94), fill=light)
    draw.ellipse((6, 6, 90, 90), fill=rim)
    draw.ellipse((9, 9, 87, 87), fill=ring)
    if core != ring:
        draw.ellipse((19, 19, 77, 77), fill=core)
    text(draw, words, (24, 22, 72, 74), "bold", dark)
    return printed(picture, occlusion=0.6)


METALS = {
    "gold": ("#d9a93a", "#d9a93a"),
    "copper": ("#b5683a", "#b5683a"),
    "silver": ("#c3c7cb", "#c3c7cb"),
    "two": ("#d9a93a", "#cfd3d6"),
    "owt": ("#cfd3d6", "#d9a93a"),
}


def coins(values: list[tuple[str, str, float]], stack: int, seed: int) -> Model:
    """Some change: (value, metal, radius) of each coin; the last `stack` lie on the first ones."""
    rng = np.random.default_rng(seed)
    radii = [r for _, _, r in values]
    flat = len(values) - stack
    places = close_together(radii[:flat], rng, 0.0006)
    pieces, tall = [], 0.0024
    for k, (value, kind, radius) in enumerate(values):
        ring, core = METALS[kind]
        edge = plain(shade(ring, 0.72), 0.05, occlusion=0.5)
        coin = lathe([(0, 0), (radius, 0), (radius, tall), (0, tall)], 14, mat=edge)
        project_label(coin, coin_face(value, ring, core), "+z", (0, 0), (2 * radius, 2 * radius))
        coin.turn(rz=float(rng.uniform(-0.9, 0.9)))
        x, y = places[k] if k < flat else np.array(places[k - flat]) + rng.normal(0, 0.002, 2)
        pieces.append([coin.move(float(x), float(y), 0.0 if k < flat else tall)])
    return loose("loose coins", pieces, 0.045, shadow=False)


def coins_random(rng: np.random.Generator) -> dict:
    return {
        "values": [
            ("2", "two", 0.0129),
            ("1", "owt", 0.0117),
            ("50", "gold", 0.0121),
            ("5", "copper", 0.0107),
            ("20", "gold", 0.0111),
            ("2", "copper", 0.0094),
            ("1", "silver", 0.0117),
            ("10", "gold", 0.0099),
        ],
        "stack": 2,
        "seed": seed_of(rng),
    }


def cell_top(words: str, sign: str) -> Material:
    """A button cell from above: bright steel, big + (or a plain pole with its dark seal)."""
    picture, draw = canvas(128, 128, "#aab0b6")
    draw.ellipse((2, 2, 126, 126), fill="#d3d7db")
    if sign == "+":
        draw.ellipse((10, 10, 118, 118), fill="#c2c7cc", outline="#9097a0", width=3)
        draw.rectangle((56, 18, 72, 66), fill="#3c4248")
        draw.rectangle((40, 34, 88, 50), fill="#3c4248")
        text(draw, words, (16, 74, 112, 104), "bold", "#3c4248")
    else:
        draw.ellipse((8, 8, 120, 120), fill="#3b4046")
        draw.ellipse((17, 17, 111, 111), fill="#dadee1", outline="#8d949c", width=3)
        draw.pieslice((28, 28, 100, 100), 200, 250, fill="#ffffff")
    return printed(picture, occlusion=0.5)


def button_cell(radius: float, tall: float, words: str, sign: str) -> Mesh:
    """One cell lying on its flat."""
    steel = metal("c4c9ce", "7e858c", occlusion=0.5)
    profile = [(0, 0), (radius * 0.97, 0), (radius, tall * 0.12), (radius, tall * 0.88)]
    cell = lathe([*profile, (radius * 0.95, tall), (0, tall)], 12, mat=steel)
    across = 2 * radius * 0.96
    return project_label(cell, cell_top(words, sign), "+z", (0, 0), (across, across), 0.8)


def button_batteries(cells: list[tuple[float, float, str]], card: str, seed: int) -> Model:
    """Loose button cells, or (card: its colour) a torn card of them beside a loose one."""
    rng = np.random.default_rng(seed)
    pieces = []
    if card:
        picture, draw = canvas(256, 192, card)
        draw.rectangle((0, 0, 256, 44), fill="#f2c21e")
        text(draw, "VOLTRIX  CR2032", (10, 6, 246, 38), "bold", "#1c1c20")
        text(draw, "LITHIUM 3V", (20, 162, 236, 188), "bold", "#ffffff")
        board = box(
            0.07, 0.092, 0.0035, (0, 0, 0), plain("#e8e6e0", 0.02), 0, 1, {"+z": printed(picture)}
        )
        pieces.append([board])
        for k, (x, y) in enumerate(((-0.016, -0.024), (-0.016, 0.0), (-0.016, 0.024), (0.01, 0.0))):
            cell = button_cell(0.0102, 0.0034, "CR2032", "+" if k % 2 else "-")
            pieces.append([cell.move(x + 0.004, y, 0.0035)])
        loose_one = button_cell(0.01, 0.0034, "CR2032", "+")
        pieces.append([loose_one.move(0.0475, 0.012)])
        return loose("card of button batteries", pieces, 0.025, shadow=False)
    radii = [r for r, _, _ in cells]
    places = close_together(radii, rng, 0.0006)
    for k, ((radius, tall, words), (x, y)) in enumerate(zip(cells, places, strict=True)):
        cell = button_cell(radius, tall, words, "-" if k % 3 == 1 else "+")
        pieces.append([cell.turn(rz=float(rng.uniform(-0.8, 0.8))).move(x, y)])
    on_top = button_cell(cells[0][0], cells[0][1], cells[0][2], "+").turn(ry=0.13, rz=0.5)
    pieces.append([on_top.move(places[0][0] + 0.005, places[0][1] + 0.005, cells[0][1] + 0.0012)])
    return loose("button batteries", pieces, 0.018, shadow=False)


def button_batteries_random(rng: np.random.Generator) -> dict:
    large, small = (0.0115, 0.0042, "CR2450"), (0.0075, 0.0054, "LR44")
    return {"cells": [large, large, small, large, small, large], "card": "", "seed": seed_of(rng)}


PIPS = {1: [0], 2: [-4, 4], 3: [-4, 0, 4], 4: [-4, -2, 2, 4], 5: [-4, -2, 0, 2, 4]}
PIPS[6] = [-4, -2, 2, 4, -1, 1]
PLACES = {0: (0, 0), -4: (-1, -1), 4: (1, 1), -2: (-1, 1), 2: (1, -1), -1: (-1, 0), 1: (1, 0)}


def die_face(count: int, body: str, pip: str) -> Material:
    """One face of a die with its pips."""
    picture, draw = canvas(64, 64, body)
    for k in PIPS[count]:
        x, y = 32 + 18 * PLACES[k][0], 32 + 18 * PLACES[k][1]
        draw.ellipse((x - 7.5, y - 7.5, x + 7.5, y + 7.5), fill=pip)
    return printed(picture, occlusion=0.7)


def dice(edge: float, colours: list[tuple[str, str]], seed: int) -> Model:
    """Thrown dice."""
    rng = np.random.default_rng(seed)
    places = close_together([edge * 0.62] * len(colours), rng, 0.0)
    pieces = []
    for (body, pip), (x, y) in zip(colours, places, strict=True):
        faces = {"+x": 2, "-x": 5, "+y": 3, "-y": 4, "+z": 1, "-z": 6}
        order = list(rng.permutation(list(faces.values())))
        sides = {k: die_face(int(n), body, pip) for k, n in zip(faces, order, strict=True)}
        cube = box(edge, edge, edge, (0, 0, 0), plain(body, 0.02), edge * 0.1, 1, sides)
        pieces.append([cube.turn(rz=float(rng.uniform(0, TAU))).move(x, y)])
    return loose("dice", pieces, 0.006 * len(colours))


def dice_random(rng: np.random.Generator) -> dict:
    return {"edge": 0.017, "seed": seed_of(rng)}


def bead(radius: float, paint: str, round_one: bool) -> Mesh:
    """A wooden bead, its hole along z, standing on z = 0."""
    colour, hole = plain(paint, 0.09, 90), plain("#2a1a10", 0.0)
    h = radius * 0.86
    rings = [(0.34, 0), (0.93, 0.62), (0.93, 1.38), (0.34, 2)]
    if not round_one:
        rings = [(0.34, 0), (0.9, 0.1), (0.9, 1.9), (0.34, 2)]
    profile = [(0, 0.05 * h), *[(r * radius, z * h) for r, z in rings], (0, 1.95 * h)]
    return lathe(profile, 9, mats=[colour, hole], mat_of_segment=[1, 0, 0, 0, 1])


def wooden_beads(radius: float, paints: list[str], string: str, seed: int) -> Model:
    """Coloured beads, loose or (string: its colour) threaded in a ring."""
    rng = np.random.default_rng(seed)
    pieces = []
    if string:
        ring = 0.052 - radius
        for k, paint in enumerate(paints):
            a = TAU * (k + 0.4) / (len(paints) + 1.2)
            one = bead(radius, paint, k % 3 != 2).move(z=-radius * 0.86).turn(rx=math.pi / 2)
            one.turn(rz=a).move(ring * math.cos(a), ring * math.sin(a), radius * 0.93)
            pieces.append([one])
        turns = [TAU * k / 14 for k in range(14)]
        path = [(ring * math.cos(a), ring * math.sin(a), radius * 0.6) for a in turns]
        pieces[0].append(tube(path, 0.0022, 4, closed=True, mat=plain(string, 0.1, 300)))
        model = loose("string of wooden beads", [p[:1] for p in pieces], 0.035)
        model.parts["body"].meshes.append(pieces[0][1])
        return model
    places = close_together([radius] * len(paints), rng, 0.0008)
    for k, (paint, (x, y)) in enumerate(zip(paints, places, strict=True)):
        one = bead(radius, paint, k % 3 != 2)
        if k % 2:
            one.turn(rx=math.pi / 2, rz=float(rng.uniform(0, TAU)))
            one.move(z=-one.v[:, 2].min())
        pieces.append([one.move(x, y)])
    return loose("loose wooden beads", pieces, 0.02)


def wooden_beads_random(rng: np.random.Generator) -> dict:
    return {
        "radius": 0.0095,
        "paints": ["#d8303a", "#f2c52a", "#2f6fc0", "#2f9a5a", "#e8862c", "#c8548a", "#d8b27c"],
        "string": "",
        "seed": seed_of(rng),
    }


def crown_cap(paint: str, mark: str, over: bool) -> Mesh:
    """A crown cap with its fluted edge, or (over) upside down, its lining to be seen."""
    tin, r, h = metal("c9cdd1", "8b9198", occlusion=0.6), 0.016, 0.006
    if over:
        lining = plain("#e9e6dc", 0.04, occlusion=0.7)
        profile = [(0, 0), (r * 0.78, 0), (r, h), (r * 0.9, h), (r * 0.76, 0.002), (0, 0.002)]
        wall = lathe(
            profile,
            18,
            mats=[plain(paint, 0.03), tin, lining],
            mat_of_segment=[0, 0, 1, 1, 2],
            rib=lambda k, i: 1 - 0.07 * (i % 2) if k in (2, 3) else 1,
        )
        return wall
    picture, draw = canvas(96, 96, paint)
    draw.ellipse((8, 8, 88, 88), outline="#ffffff", width=6)
    text(draw, mark, (22, 20, 74, 76), "bold", "#ffffff")
    profile = [(0, 0.0005), (r * 0.9, 0), (r, 0), (r * 0.84, h * 0.8), (r * 0.74, h), (0, h)]
    lid = lathe(
        profile,
        18,
        mat=plain(paint, 0.03),
        rib=lambda k, i: 1 - 0.07 * (i % 2) if k == 2 else 1,
    )
    across = 2 * r * 0.84
    return project_label(lid, printed(picture, base=paint), "+z", (0, 0), (across, across), 0.6)


def screw_cap(paint: str, over: bool) -> Mesh:
    """A ribbed plastic cap of a soft-drink bottle."""
    r, h = 0.0145, 0.014
    colour, inside = plain(paint, 0.03), plain(shade(paint, 0.6), 0.03)
    if over:
        profile = [(0, 0), (r, 0), (r, h), (r * 0.88, h), (r * 0.86, 0.003), (0, 0.003)]
        mats = [0, 0, 0, 1, 1]
    else:
        profile = [(0, 0), (r, 0), (r * 0.99, h * 0.85), (r * 0.88, h), (0, h)]
        mats = [0, 0, 0, 0]
    return lathe(
        profile,
        16,
        mats=[colour, inside],
        mat_of_segment=mats,
        rib=lambda k, i: 1 - 0.05 * (i % 2) if k in (1, 2) else 1,
    )


def bottle_caps(kind: str, colours: list[str], seed: int) -> Model:
    """Crown caps or plastic screw caps."""
    rng = np.random.default_rng(seed)
    radius = 0.016 if kind == "crown" else 0.0145
    places = close_together([radius] * len(colours), rng, 0.001)
    pieces = []
    for k, (paint, (x, y)) in enumerate(zip(colours, places, strict=True)):
        over = k == 2
        one = crown_cap(paint, "\u2605", over) if kind == "crown" else screw_cap(paint, over)
        pieces.append([one.turn(rz=float(rng.uniform(-1, 1))).move(x, y)])
    return loose("bottle caps", pieces, 0.012)


def bottle_caps_random(rng: np.random.Generator) -> dict:
    return {
        "kind": pick(rng, ["crown", "screw"]),
        "colours": ["#c8202c", "#1f5fb0", "#d8a82a", "#1f7a3c"],
        "seed": seed_of(rng),
    }


CLEAR = [
    ("#8fc8d8", "#1f5fc0"),
    ("#a8d8b0", "#d8303a"),
    ("#e8e0c0", "#e8862c"),
    ("#9ab8e8", "#f2c52a"),
    ("#b8e0d8", "#7b3fb5"),
    ("#d0e8f0", "#2f9a5a"),
]
SOLID = [
    ("#1f4fc0", "#f4f4f4"),
    ("#c8202c", "#f2c52a"),
    ("#12873c", "#f4f4f4"),
    ("#e8862c", "#2a2a2c"),
    ("#6a2fa0", "#9fe0f0"),
    ("#f0f0ea", "#d8303a"),
]
MODELS = {
    "marbles": Maker(
        marbles,
        marbles_random,
        3,
        [
            {"colours": CLEAR},
            {"colours": SOLID, "radii": [0.008, 0.0125, *[0.008] * 4]},
            {"colours": CLEAR[::-1], "radii": [0.0125, 0.0125, *[0.009] * 4]},
        ],
    ),
    "coins": Maker(
        coins,
        coins_random,
        3,
        [
            {},
            {
                "values": [
                    ("1", "silver", 0.0117),
                    ("5", "silver", 0.0129),
                    ("1", "copper", 0.0105),
                    ("10", "silver", 0.0095),
                    ("1", "copper", 0.0105),
                    ("25", "silver", 0.0121),
                    ("1", "copper", 0.0105),
                ],
                "stack": 1,
            },
            {"stack": 3},
        ],
    ),
    "button_batteries": Maker(
        button_batteries,
        button_batteries_random,
        3,
        [{}, {"card": "#1f4fa8"}, {"cells": [(0.0102, 0.0036, "CR2032")] * 6}],
    ),
    "dice": Maker(
        dice,
        dice_random,
        3,
        [
            {"colours": [("#f6f4ec", "#1c1c20")] * 3 + [("#c8202c", "#ffffff")] * 2},
            {
                "colours": [
                    ("#c8202c", "#ffffff"),
                    ("#1f5fc0", "#ffffff"),
                    ("#12873c", "#ffffff"),
                    ("#f2c52a", "#1c1c20"),
                    ("#f6f4ec", "#1c1c20"),
                ]
            },
            {"colours": [("#6a2fa8", "#ffffff")] * 3 + [("#f28a1c", "#1c1c20")] * 3},
        ],
    ),
    "wooden_beads": Maker(
        wooden_beads,
        wooden_beads_random,
        3,
        [
            {},
            {"string": "#e8e2d2", "radius": 0.0098},
            {
                "paints": ["#2f8fc0", "#f6f4ee", "#d8548a", "#7fb83a", "#f2c52a", "#7b3fb5"],
                "radius": 0.0105,
            },
        ],
    ),
    "bottle_caps": Maker(
        bottle_caps,
        bottle_caps_random,
        3,
        [
            {"kind": "crown"},
            {"kind": "screw", "colours": ["#1f6fd0", "#f0f0ee", "#d8202c", "#2f9a48", "#1f6fd0"]},
            {"kind": "crown", "colours": ["#e8b92c", "#1c5a34", "#b0202c", "#1c1c22"]},
        ],
    ),
}
