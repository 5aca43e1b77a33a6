"""Balls and building bricks."""

from __future__ import annotations

import math

import numpy as np
from PIL import Image
from toolkit.labels import canvas, text
from toolkit.materials import Material, plain, shade
from toolkit.materials import label as printed
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part
from toolkit.sampling import pick
from toolkit.shapes import TAU, box, ellipsoid, lathe, tube

from makers.choking import loose
from makers.solids import flattened, solids


def _pattern(width: int, height: int) -> np.ndarray:
    """The direction on the sphere that each pixel of a ball's skin shows (H, W, 3)."""
    v, u = np.mgrid[0:height, 0:width]
    z = 1 - 2 * (v + 0.5) / height
    phi, r = TAU * (u + 0.5) / width, np.sqrt(1 - z * z)
    return np.stack([r * np.cos(phi), r * np.sin(phi), z], -1)


def _paint(image: Image.Image, where: np.ndarray, colour: str) -> None:
    image.paste(colour, (0, 0), Image.fromarray((where * 255).astype(np.uint8)))


def _football(light: str, dark: str) -> Image.Image:
    """Twelve dark pentagons among light hexagons, grey seams."""
    g = (1 + 5**0.5) / 2
    corner = np.array([p for a in (-1, 1) for b in (-g, g) for p in ((0, a, b), (a, b, 0))])
    corner = np.r_[corner, [(b, 0, a) for a in (-1, 1) for b in (-g, g)]] / math.hypot(1, g)
    near = corner @ corner.T > 0.4
    faces = [
        corner[i] + corner[j] + corner[k]
        for i in range(12)
        for j in range(i)
        for k in range(j)
        if near[i, j] and near[j, k] and near[i, k]
    ]
    hexagons = np.array(faces) / np.linalg.norm(faces, axis=1)[:, None]
    out = _pattern(768, 384)
    score = np.concatenate([out @ corner.T / 2.327, out @ hexagons.T / 2.267], -1)
    order = np.sort(score, -1)
    image = Image.new("RGB", (768, 384), light)
    _paint(image, score.argmax(-1) < 12, dark)
    _paint(image, order[..., -1] - order[..., -2] < 0.006, "#77787a")
    return image


def _basketball(paint: str) -> Image.Image:
    out = _pattern(768, 384)
    y, z = out[..., 1], out[..., 2]
    image = Image.new("RGB", (768, 384), paint)
    bent = np.abs(np.abs(y) - 0.56 - 0.22 * z * z)
    _paint(image, (np.abs(z) < 0.035) | (np.abs(y) < 0.035) | (bent < 0.035), "#1a1614")
    return image


def _tennis(paint: str) -> Image.Image:
    out = _pattern(256, 128)
    phi = np.arctan2(out[..., 1], out[..., 0])
    image = Image.new("RGB", (256, 128), paint)
    _paint(image, np.abs(out[..., 2] - 0.62 * np.sin(2 * phi)) < 0.11, "#f8f8f4")
    return image


def _play_ball(style: str, colours: list[str]) -> Image.Image:
    """'beach' (gores meeting at the poles), 'stripe' (band and stars) or 'dots'."""
    width, height = 768, 384
    picture, draw = canvas(width, height, colours[0])
    if style == "beach":
        for i in range(6):
            draw.rectangle(
                (128 * i, 0, 128 * i + 127, height),
                fill=["#f6f4ee", colours[0], "#f6f4ee", colours[1], "#f6f4ee", colours[2]][i],
            )
        draw.rectangle((0, 0, width, 26), fill="#f6f4ee")
        draw.rectangle((0, height - 26, width, height), fill="#f6f4ee")
    elif style == "stripe":
        draw.rectangle((0, 128, width, 256), fill=colours[1])
        draw.rectangle((0, 120, width, 134), fill="#f6f4ee")
        draw.rectangle((0, 250, width, 264), fill="#f6f4ee")
        for i in range(6):
            text(draw, "\u2605", (128 * i + 20, 140, 128 * i + 108, 244), "sans", colours[2])
    else:
        for j in range(4):
            for i in range(8):
                x, y = 96 * i + 48 * (j % 2) + 24, 60 + 88 * j
                draw.ellipse(
                    (x - 28, y - 24, x + 28, y + 24),
                    fill=[colours[1], "#f6f4ee", colours[2]][(i + j) % 3],
                )
    return picture


def toy_ball(radius: float, style: str, colours: list[str]) -> Model:
    """A ball to play with: 'beach', 'stripe', 'dots', 'football', 'basketball', 'rugby', 'hopper'
    (with two horns to hold on to) or 'tennis' (three of them)."""
    if style == "tennis":
        skin = printed(_tennis(colours[0]))
        spots = ((0, 0), (2.06, 0.1), (0.95, 1.8))
        balls = [
            ellipsoid(radius, (0, 0, 0), 14, 9, skin)
            .turn(0.5 + k, 0.4, 1.3 * k)
            .move(x * radius, y * radius, radius)
            for k, (x, y) in enumerate(spots)
        ]
        return loose("three tennis balls", [[b] for b in balls], 0.17)
    if style == "football":
        skin = printed(_football(colours[0], colours[1]))
    elif style == "basketball":
        skin = printed(_basketball(colours[0]))
    elif style in ("rugby", "hopper"):
        skin = plain(colours[0], 0.06, 30)
    else:
        skin = printed(_play_ball(style, colours))
    if style == "rugby":
        m = Material()
        leather = m.mottle(colours[0], 0.08, 200)
        band = m.math("ABSOLUTE", m.math("SUBTRACT", m.math("ABSOLUTE", m.axis(1)), 0.085))
        m.colour(m.mix(m.remap(band, 0.007, 0.009, 1, 0), leather, "f6f4ee"))
        ball = ellipsoid((radius, radius, radius * 1.55), (0, 0, 0), 18, 12, m)
        ball.turn(rx=math.pi / 2).keep_pattern().move(z=radius)
        white = plain("#f6f4ee", 0)
        laces = [box(0.006, 0.06, 0.005, (0, 0, 2 * radius - 0.002), white)]
        laces += [
            box(0.026, 0.005, 0.006, (0, 0.011 * k, 2 * radius - 0.002), white)
            for k in (-2, -1, 0, 1, 2)
        ]
        flattened([ball, *laces], 0.003)
        body = Part([ball, *laces], collision=solids([ball]))
        return Model("rugby ball", {"body": body}, mass=0.42, friction=0.6, texture_size=128)
    ball = ellipsoid(radius, (0, 0, radius), 20, 12, skin)
    if style == "hopper":
        ball = ellipsoid((radius, radius, radius), (0, 0, radius), 24, 14, skin)
        meshes = [ball]
        for q in (-1, 1):
            horn = [
                (0, q * 0.2 * radius, 1.9 * radius),
                (0, q * 0.3 * radius, 2.2 * radius),
                (0, q * 0.52 * radius, 2.34 * radius),
            ]
            meshes.append(
                tube(horn, [0.14 * radius, 0.11 * radius, 0.14 * radius], 10, mat=plain(colours[0]))
            )
        face, draw = canvas(128, 128)
        for x in (34, 78):
            draw.ellipse((x, 20, x + 18, 56), fill=colours[1])
        draw.arc((24, 30, 106, 104), 20, 160, fill=colours[1], width=9)
        patch = printed(face, colours[0])
        ball.mats.append(patch)
        for i, f in enumerate(ball.f):
            p = ball.v[list(f)]
            if p[:, 0].mean() > 0.55 * radius:
                ball.mi[i] = 1
                ball.label_uv[i] = [
                    (q[1] / radius / 1.5 + 0.5, (q[2] / radius - 1) / 1.5 + 0.5) for q in p
                ]
        flattened(meshes, 0.012)
        return Model(
            "space hopper",
            {"body": Part(meshes, collision=solids([ball], meshes[1:]))},
            mass=0.7,
            friction=0.7,
        )
    ball.turn(0.45, 0.3, 0.2, pivot=(0, 0, radius))
    shell = [ellipsoid(radius, (0, 0, radius), 8, 5).v]
    name = {"football": "football", "basketball": "basketball"}.get(style, "toy ball")
    return Model(name, {"body": Part([ball], collision=shell)}, mass=0.3, friction=0.6)


def toy_ball_random(rng: np.random.Generator) -> dict:
    return {
        "radius": 0.1,
        "style": "beach",
        "colours": pick(
            rng, [["#d8303a", "#2f6fc0", "#f2c52a"], ["#e8862c", "#2f9a5a", "#3f7fd0"]]
        ),
    }


def _brick(columns: int, rows: int, unit: float, colour: str) -> list[Mesh]:
    """One studded brick; unit is the pitch of its studs."""
    m = plain(colour, 0.02, 200)
    height = unit * 1.2
    meshes = [box(columns * unit, rows * unit, height, (0, 0, 0), m, bevel_width=unit * 0.05)]
    r = unit * 0.31
    light = plain(shade(colour, 1.12), 0.02)
    for i in range(columns):
        for j in range(rows):
            stud = lathe([(r, 0), (r, unit * 0.24), (0, unit * 0.24)], 8, mat=light)
            meshes.append(
                stud.move((i - (columns - 1) / 2) * unit, (j - (rows - 1) / 2) * unit, height)
            )
    return meshes


RED, BLUE, YELLOW, GREEN, WHITE = "#d0161c", "#1157b8", "#f4c812", "#12873c", "#f2f2ee"
# columns, rows, colour (index), x, y, layer (in units), turn
SETS = {
    "strewn": [
        (4, 2, 0, -1.2, -1.6, 0, 0.25),
        (2, 2, 2, 1.9, -0.7, 0, 0.9),
        (4, 2, 1, 0.9, 2.1, 0, -0.5),
        (2, 1, 3, -2.1, 1.2, 0, 1.2),
    ],
    "tower": [
        (4, 2, 1, 0, 0, 0, 0),
        (2, 2, 2, 1, 0, 1, 0),
        (2, 2, 0, 0, 0, 2, 0),
        (2, 2, 3, 0, 0, 3, 0),
        (2, 2, 2, -0.6, 3.1, 0, 0.5),
    ],
    "wall": [
        (2, 4, 0, 0, -2.05, 0, 0),
        (2, 4, 2, 0, 2.05, 0, 0),
        (2, 4, 1, 0, 0, 1, 0),
    ],
    "heap": [
        (4, 2, 0, 0, -1.2, 0, 0.3),
        (4, 2, 2, 0.2, 1.5, 0, -0.2),
        (2, 2, 1, 0.2, 0.1, 1.22, 0.9),
        (1, 2, 3, 2.8, 0.4, 0, 0.5),
        (1, 1, 4, -2.9, 0.6, 0, 0.2),
    ],
}


def toy_brick(layout: str, unit: float, colours: list[str]) -> Model:
    """A few studded building bricks: strewn, stuck together or heaped up."""
    pieces = []
    for columns, rows, tint, x, y, layer, turn in SETS[layout]:
        brick = _brick(columns, rows, unit, colours[tint])
        for mesh in brick:
            mesh.turn(rz=turn).move(x * unit, y * unit, layer * 1.2 * unit)
        pieces.append(brick)
    model = loose("building bricks", pieces, round(900 * unit**3 * 6 * len(pieces), 3), size=128)
    return model


def toy_brick_random(rng: np.random.Generator) -> dict:
    return {"layout": "strewn", "unit": 0.014, "colours": [RED, BLUE, YELLOW, GREEN, WHITE]}


MODELS = {
    "toy_ball": Maker(
        toy_ball,
        toy_ball_random,
        8,
        [
            {},
            {"style": "stripe", "colours": ["#2f6fc0", "#d8303a", "#f2c52a"]},
            {"style": "dots", "colours": ["#e8c22c", "#d8303a", "#2f8fc0"]},
            {"style": "football", "radius": 0.11, "colours": ["#f6f6f2", "#17181a"]},
            {"style": "basketball", "radius": 0.12, "colours": ["#d8692a"]},
            {"style": "tennis", "radius": 0.033, "colours": ["#c8e032"]},
            {"style": "rugby", "radius": 0.095, "colours": ["#8a4522"]},
            {"style": "hopper", "radius": 0.21, "colours": ["#d8202c", "#f6e04a"]},
        ],
    ),
    "toy_brick": Maker(
        toy_brick,
        toy_brick_random,
        6,
        [
            {},
            {"layout": "tower"},
            {"layout": "wall", "unit": 0.011},
            {"layout": "heap", "unit": 0.012},
            {"colours": [YELLOW, RED, BLUE, WHITE, GREEN]},
            {"layout": "tower", "colours": [WHITE, GREEN, RED, YELLOW, BLUE]},
        ],
    ),
}
