"""Salt shakers and ashtrays."""

from __future__ import annotations

import math

import numpy as np
from toolkit import labels
from toolkit.materials import Material, metal, plain, wood
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part, box_piece, cylinder_piece, ring_pieces
from toolkit.sampling import noise_offset
from toolkit.shapes import ellipsoid, lathe, tube

from makers.ware import squared, wall_profile

# radius, height, outline of the body in shares, columns, height of the cap's foot
SHAKERS = {
    "diner": (0.026, 0.092, [(0.94, 0), (1, 0.04), (1, 0.3), (0.9, 0.66), (0.8, 0.74)], 10, 0.74),
    "round": (
        0.031,
        0.066,
        [(0.6, 0), (0.86, 0.12), (1, 0.45), (0.86, 0.78), (0.5, 0.95), (0, 1)],
        16,
        0.0,
    ),
    "cube": (0.028, 0.06, [(0.94, 0), (1, 0.04), (1, 0.5), (1, 0.92), (0.92, 1), (0, 1)], 16, 0.0),
    "mill": (
        0.03,
        0.21,
        [(0.95, 0), (1, 0.03), (0.72, 0.22), (0.62, 0.45), (0.9, 0.66), (0.62, 0.7)],
        14,
        0.0,
    ),
    "tin": (0.034, 0.115, [(0.97, 0), (1, 0.02), (1, 0.3), (1, 0.8), (0.98, 0.86)], 18, 0.86),
    "hourglass": (
        0.029,
        0.085,
        [(1, 0), (0.96, 0.06), (0.66, 0.5), (0.84, 0.85), (0.78, 0.9)],
        16,
        0.9,
    ),
}


def shaker_label(words: str, ink: str, band: str):
    """SALT (or S) four times round, one of them in front."""
    image, draw = labels.canvas(768, 192, band or None)
    for k in range(5):
        x = 192 * k - 96
        labels.text(draw, words, (x + 14, 24, x + 178, 168), "bold", ink)
    return image


def cap_holes(x: float, z: float, radius: float, letter: str, tilt=0.0) -> list[Mesh]:
    """Dark holes in a cap: a ring of them, or the letter S."""
    dark = plain("1c1c1e", 0.0)
    spots = [(0, 0)] + [(0.62 * math.cos(a), 0.62 * math.sin(a)) for a in np.arange(5) * 1.2566]
    if letter == "S":  # read from the front, +X
        spots = [
            (-0.62, 0.38),
            (-0.78, -0.15),
            (-0.28, -0.4),
            (0, 0),
            (0.28, 0.4),
            (0.78, 0.15),
            (0.62, -0.38),
        ]
        spots = [(a, -b) for a, b in spots]
    hole = [(0.0032, 0), (0.003, 0.0008), (0, 0.0009)]
    return [
        lathe(hole, 6, mat=dark, weight=0.4).move(x + a * radius, b * radius, z) for a, b in spots
    ]


def one_shaker(
    form: str, colour: str, ink: str, words: str, letter: str, cap: str, contents: str, offset
) -> tuple[list[Mesh], list, float]:
    r, h, shares, n, cap_at = SHAKERS[form]
    outer = [(r * q, h * z) for q, z in shares]
    glassy = not colour
    if glassy:
        m = Material(occlusion=0.3)
        level = 0.56 * h
        grains = m.mottle(contents, 0.12, 900, offset, 2.0)
        full = m.mix(m.remap(m.axis(2), level - 0.001, level + 0.001), grains, "c9d8dc")
        edge = m.remap(m.axis(2), 0, 0.1 * h, 0.6, 0)
        full = m.mix(edge, full, "b4c6ca")
        band = m.math("ABSOLUTE", m.math("ADD", m.normal(1), 0.45))
        m.colour(m.mix(m.remap(band, 0.0, 0.1, 0.7, 0), full, "ffffff"))
    elif colour == "wood":
        m = wood("9a5c2c", "4f2a10", 2, 20, offset)
    elif colour == "steel":
        m = metal("c8ccd0", "7c8288", (1, 1, 8), 50, offset)
    else:
        m = plain(colour, 0.04, 60, offset)
    mats = [m, m]
    if words:
        lettered = Material()
        base = lettered.mottle(
            "d9dee0" if glassy else colour if colour[0] == "#" else "c8ccd0", 0.02, 60
        )
        lettered.colour(lettered.image(shaker_label(words, ink, "#f6f2e6" if glassy else ""), base))
        mats = [m, lettered]
    top = outer[-1]
    profile = [(0, 0), *outer] + ([(0, top[1])] if top[0] else [])
    kinds = [0] * (len(profile) - 1)
    kinds[3] = 1
    body = lathe(
        profile,
        n,
        mats=mats,
        mat_of_segment=kinds,
        label_z=(outer[2][1], outer[3][1]),
        start=-math.pi,
    )
    if form == "cube":
        squared(body, 0.95, 0.95, 7)
    meshes = [body]
    pieces = [cylinder_piece(r, 0, h * 0.45, 12), cylinder_piece(r, h * 0.45, h, 12, 0.6 * r)]
    if form == "cube":
        pieces = [box_piece((0, 0, h / 2), (1.9 * r, 1.9 * r, h))]
    elif form == "tin":
        pieces = [cylinder_piece(r, 0, 0.95 * h, 14)]
    if form == "mill":
        crown = [
            (0, 0.69 * h),
            (0.62 * r, 0.69 * h),
            (0.95 * r, 0.76 * h),
            (0.98 * r, 0.84 * h),
            (0.6 * r, 0.93 * h),
            (0, 0.945 * h),
        ]
        meshes.append(lathe(crown, n, mat=m))
        meshes.append(
            ellipsoid((0.011, 0.011, 0.009), (0, 0, 0.965 * h), 10, 6, metal("d0d4d8", "7c8288"))
        )
        meshes.append(
            lathe(
                [(0.64 * r, 0.685 * h), (0.66 * r, 0.69 * h), (0.64 * r, 0.7 * h)],
                n,
                mat=metal("d0d4d8", "7c8288"),
            )
        )
        return meshes, pieces, h
    if cap_at:
        z, q = cap_at * h, top[0] + 0.002
        dome = [
            (0, z - 0.002),
            (q, z - 0.002),
            (q, z + 0.008),
            (q * 0.86, h * 0.965),
            (q * 0.6, h),
            (0, h),
        ]
        lid = metal("d2d6da", "7c8288", (1, 1, 1), 40) if cap == "steel" else plain(cap, 0.04)
        meshes.append(lathe(dome, n, mat=lid))
        meshes += cap_holes(0, h - 0.0004, q * 0.62, letter)
    elif form == "cube":
        meshes += cap_holes(0, h - 0.0002, r * 0.66, letter)
    else:
        meshes += [m.move(z=0) for m in cap_holes(0, h * 0.985, r * 0.4, letter)]
    return meshes, pieces, h


def salt_shaker(
    form="diner", colour="", ink="#22406a", words="SALT", letter="", cap="steel", pair=False, look=0
) -> Model:
    """A salt shaker; pair: the pepper shaker stands beside it."""
    rng = np.random.default_rng(look)
    meshes, pieces, _ = one_shaker(
        form, colour, ink, words, letter, cap, "f6f6f2", noise_offset(rng)
    )
    if pair:
        r = SHAKERS[form][0]
        second = "#2a2a2c" if colour and colour[0] == "#" else colour
        other, more, _ = one_shaker(
            form,
            second,
            "#f2efe6",
            "PEPPER" if words == "SALT" else "P",
            "",
            cap,
            "4a3a30",
            noise_offset(rng),
        )
        meshes = [m.keep_pattern().move(y=-1.15 * r) for m in meshes]
        meshes += [m.keep_pattern().move(y=1.15 * r) for m in other]
        pieces = [p + np.array([0, -1.15 * r, 0]) for p in pieces] + [
            p + np.array([0, 1.15 * r, 0]) for p in more
        ]
    return Model(
        "salt and pepper shakers"
        if pair
        else "salt mill"
        if form == "mill"
        else f"{form} salt shaker",
        {"body": Part(meshes, collision=pieces)},
        mass=0.12 * (2 if pair else 1),
        texture_size=256 if words else 128,
    )


def salt_shaker_random(rng: np.random.Generator) -> dict:
    return {"look": int(rng.integers(1_000_000))}


# half width, height, outline, squareness (2: round), columns, notches
ASHTRAYS = {
    "round": (0.068, 0.034, [(0.86, 0), (0.95, 0.1), (1, 0.5), (0.97, 1)], 2, 20, 3),
    "square": (0.058, 0.032, [(0.92, 0), (0.98, 0.1), (1, 0.5), (0.97, 1)], 7, 16, 4),
    "dish": (0.082, 0.024, [(0.5, 0), (0.66, 0.12), (0.95, 0.8), (1, 1)], 2, 20, 3),
    "hexagon": (0.07, 0.04, [(0.8, 0), (0.86, 0.1), (1, 0.6), (0.98, 1)], 2, 6, 0),
    "pot": (0.05, 0.055, [(0.72, 0), (0.8, 0.06), (1, 0.6), (1, 1)], 2, 20, 3),
    "long": (0.085, 0.03, [(0.92, 0), (0.97, 0.1), (1, 0.5), (0.97, 1)], 7, 16, 4),
}


def cigarette(length: float, burnt: bool = True) -> list[Mesh]:
    """A stub lying along x from the origin, its filter outwards."""
    r = 0.0042
    filter_, paper, ash = (
        plain("d8923c", 0.2, 300),
        plain("f6f4ee", 0.02),
        plain("3c3834", 0.4, 300),
    )
    path = [(0, 0, 0), (0.018, 0, 0), (length - 0.004, 0, 0), (length, 0, 0.0004)]
    mesh = tube(path, [r, r, r, 0.7 * r], 4, mat=paper)
    mesh.mats = [paper, filter_, ash]
    for i, face in enumerate(mesh.f):
        x = mesh.v[list(face)].mean(0)[0]
        mesh.mi[i] = 1 if x < 0.0175 else 2 if x > length - 0.0045 else 0
    return [mesh]


def ashtray(form="round", colour="", tint="#b9ced2", look=0) -> Model:
    """An ashtray, clean; full: heaped with stubs and ash, some on its rim."""
    rng = np.random.default_rng(look)
    half, height, shares, power, n, notches = ASHTRAYS[form]
    outer = [(half * q, height * z) for q, z in shares]
    wall, floor = 0.011, 0.008
    if form in ("dish",):
        wall = 0.004
    profile, kinds = wall_profile(outer, wall, floor, 0.001)
    if not colour:
        glaze = Material(occlusion=0.5)
        facets = glaze.remap(glaze.voronoi(90), 0.0, 0.5)
        base = glaze.mix(facets, tint, "f6fbfc")
        band = glaze.math("ABSOLUTE", glaze.math("ADD", glaze.normal(1), 0.4))
        glaze.colour(glaze.mix(glaze.remap(band, 0, 0.12, 0.6, 0), base, "ffffff"))
    elif colour == "steel":
        glaze = metal("c6cace", "7c8288", (6, 6, 1), 50, noise_offset(rng))
    else:
        glaze = plain(colour, 0.05, 60, noise_offset(rng))
    dish = lathe(profile, n, mats=[glaze] * 4, mat_of_segment=kinds)
    stretch = 0.62 if form == "long" else 1.0
    squared(dish, stretch, 1.0, power)
    turns = (
        [math.pi / 4 + math.pi / 2 * k for k in range(4)]
        if notches == 4
        else [0.4 + math.tau / 3 * k for k in range(3)]
    )
    if form == "long":
        turns = [-0.5, 0.5, math.pi - 0.5, math.pi + 0.5]
    elif form == "hexagon":
        turns = [0.0]
    if notches:

        def dent(x, y, z):
            if z < 0.75 * height:
                return x, y, z
            near = min(abs(math.remainder(math.atan2(y, x * 1.0) - t, math.tau)) for t in turns)
            return x, y, z - 0.008 * max(0.0, 1 - near / 0.3)

        dish.warp(dent)

    def on_rim(a: float, length: float) -> list[Mesh]:
        rim_r = outer[-1][0] * (stretch if form == "long" and abs(math.cos(a)) > 0.7 else 1)
        drop = height - (0.006 if notches else 0) + 0.0036
        stub = cigarette(length)
        for mesh in stub:
            mesh.turn(ry=0.3, rz=0).move(-0.02, 0, 0.006)
            mesh.turn(rz=a + math.pi).move(
                (rim_r + 0.002) * math.cos(a), (rim_r + 0.002) * math.sin(a), drop
            )
        return stub

    ash = plain("8c8882", 0.35, 160)
    low = min(outer[0][0], half * 0.8) - wall * 0.8
    heap = [(low * 0.96, floor + 0.001), (low * 0.6, floor + 0.009), (0, floor + 0.012)]
    mound = lathe(heap, 12, mat=ash).scale(stretch, 1, 1)
    butts: list[Mesh] = [mound, *on_rim(turns[0], 0.058)]
    for k in range(8):
        a, far = 2.4 * k, low * (0.25 + 0.055 * k)
        for mesh in cigarette(float(rng.uniform(0.026, 0.038))):
            mesh.move(-0.016, 0, 0).turn(ry=float(rng.uniform(-0.5, 0.35)), rz=0).turn(
                rz=1.1 * k + 0.5
            )
            z = floor + 0.014 + 0.0016 * (k % 4)
            butts.append(mesh.move(far * stretch * math.cos(a), far * math.sin(a), z))
    if len(turns) > 1:
        butts += on_rim(turns[1], 0.036)
    pieces = [cylinder_piece(outer[0][0], 0, floor, 12)]
    inner = [(outer[0][0] - wall, 0), (outer[-1][0] - wall, height)]
    pieces += ring_pieces([outer[0], outer[-1]], inner, 8)
    if power > 4:  # a circle's wedges would leave the corners out
        side = 2 * outer[-1][0]
        pieces = [box_piece((0, 0, floor / 2), (side, side, floor))]
        for e in (-1, 1):
            at = e * (side - wall) / 2
            pieces.append(box_piece((at, 0, height / 2), (wall, side, height)))
            pieces.append(box_piece((0, at, height / 2), (side, wall, height)))
    pieces = [p * [stretch, 1, 1] for p in pieces]
    return Model(
        f"{form} ashtray",
        {
            "body": Part([dish], collision=pieces),
            "filling": Part(butts, collision="none", open=True),
        },
        mass=0.35,
        variants={"default": ["body"], "full": ["body", "filling"]},
        states=[{"state": "FULL", "variants": ["full"], "parts": ["filling"]}],
        texture_size=128,
    )


def ashtray_random(rng: np.random.Generator) -> dict:
    return {"look": int(rng.integers(1_000_000))}


MODELS = {
    "salt_shaker": Maker(
        salt_shaker,
        salt_shaker_random,
        7,
        [
            {"form": "diner", "words": "SALT", "cap": "#c8302c"},
            {"form": "round", "colour": "#2f8a86", "words": "", "letter": "S"},
            {"form": "cube", "colour": "#f4f1e8", "ink": "#c8302c", "words": "SALT", "letter": "S"},
            {"form": "mill", "colour": "wood", "words": ""},
            {"form": "tin", "colour": "#2f5f9a", "ink": "#ffffff", "words": "SALT"}
            | {"cap": "#f2efe6"},
            {
                "form": "hourglass",
                "colour": "#f4f1e8",
                "ink": "#22406a",
                "words": "S",
                "pair": True,
            },
            {"form": "diner", "words": "SALT", "pair": True, "cap": "#26272b"},
        ],
    ),
    "ashtray": Maker(
        ashtray,
        ashtray_random,
        7,
        [
            {"form": "round"},
            {"form": "square", "tint": "#c88a3a"},
            {"form": "dish", "colour": "steel"},
            {"form": "hexagon", "colour": "#26272b"},
            {"form": "pot", "colour": "#b5553a"},
            {"form": "long", "colour": "#2f5f6e"},
            {"form": "round", "colour": "#c8302c"},
        ],
    ),
}
