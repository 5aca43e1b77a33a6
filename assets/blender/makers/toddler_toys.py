"""Toys of small children: stacking rings, a rocking horse."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import plain, shade, wood
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part
from toolkit.sampling import pick
from toolkit.shapes import TAU, box, ellipsoid, extrude, lathe, tube

from makers.choking import loose
from makers.solids import cylinder, grounded, grown, rod, solids

RAINBOW = ["#d8202c", "#f07a1c", "#f2c81e", "#2fa04a", "#1f6fd8", "#7b3fb5"]


def _ring(radius: float, thick: float, colour: str, n: int = 12) -> Mesh:
    """A fat ring lying on z = 0."""
    r = thick / 2
    section = [(r * math.cos(a), r + r * math.sin(a)) for a in np.linspace(0, TAU, 6)[::-1]]
    middle = radius - r
    return lathe([(middle + x, z) for x, z in section], n, mat=plain(colour, 0.04), discs=False)


def stacking_rings(kind: str, size: float, colours: list[str]) -> Model:
    """'tower' of rings on a rocking foot, 'half' unstacked, 'discs', 'squares' or 'posts'."""
    pieces: list[list[Mesh]] = []
    n = len(colours)
    if kind in ("tower", "half"):
        thick = 0.03
        foot = [(0, 0), (0.05, 0), (0.085, 0.012), (0.088, 0.022), (0.02, 0.03), (0, 0.03)]
        stand = [lathe(foot, 14, mat=plain("#f2f2ee", 0.04))]
        stand.append(cylinder(0.016, 0.15, (0, 0, 0.028), plain("#f2f2ee", 0.04), 10, top=0.009))
        on = n if kind == "tower" else 2
        for k, colour in enumerate(colours):
            ring = _ring(0.078 - 0.0085 * k, thick, colour)
            if k < on:
                stand.append(ring.move(z=0.03 + thick * 0.92 * k))
            else:
                a = -0.5 + 0.95 * (k - on)
                pieces.append([ring.move(0.165 * math.cos(a), 0.165 * math.sin(a), 0)])
        if kind == "tower":
            top = 0.03 + thick * 0.92 * n
            stand.append(ellipsoid(0.019, (0, 0, top + 0.014), 8, 6, plain("#d8202c", 0.03)))
        pieces.insert(0, stand)
    elif kind == "discs":  # plain wooden discs, every one smaller, a knob on top
        stand = []
        for k, colour in enumerate(colours):
            r = 0.07 - 0.0085 * k
            slab = [(0, 0), (r - 0.003, 0), (r, 0.004), (r, 0.018), (r - 0.003, 0.022), (0, 0.022)]
            stand.append(lathe(slab, 12, mat=plain(colour, 0.08, 90)).move(z=0.024 * k + 0.02))
        beech = wood("d8b27c", "b98a52", 0, 12)
        stand.insert(0, cylinder(0.082, 0.02, (0, 0, 0), beech, 16))
        top = 0.024 * n + 0.018
        stand.append(cylinder(0.01, 0.02, (0, 0, top), beech, 8))
        stand.append(ellipsoid(0.017, (0, 0, top + 0.03), 8, 6, beech))
        pieces = [stand]
    elif kind == "squares":
        stand = [box(0.15, 0.15, 0.018, (0, 0, 0), wood("d8b27c", "b98a52", 0, 12), 0.004)]
        for k, colour in enumerate(colours):
            side = 0.125 - 0.016 * k
            slab = box(side, side, 0.024, (0, 0, 0), plain(colour, 0.08, 90), 0.004)
            stand.append(slab.turn(rz=0.16 * (-1) ** k).move(z=0.019 + 0.025 * k))
        stand.append(cylinder(0.01, 0.03, (0, 0, 0.019 + 0.025 * n), plain("#d8b27c"), 8))
        pieces = [stand]
    else:  # two posts side by side
        stand = [box(0.1, 0.24, 0.02, (0, 0, 0), wood("d8b27c", "b98a52", 1, 12), 0.005)]
        for side, count in ((-1, 4), (1, 2)):
            post = cylinder(0.009, 0.125, (0, side * 0.062, 0.02), plain("#d8b27c", 0.08), 8)
            stand.append(post)
            for k in range(count):
                ring = _ring(0.045, 0.026, colours[(k + (side > 0) * 4) % n], 11)
                stand.append(ring.move(0, side * 0.062, 0.02 + 0.026 * k))
        pieces = [stand]
    for piece in pieces:
        for mesh in piece:
            mesh.scale(size)
    model = loose("stacking rings", pieces, 0.5, size=128)
    whole = pieces[0]
    cut = 0.3 * max(float(m.v[:, 2].max()) for m in whole)
    low = [m for m in whole if m.v[:, 2].mean() < cut]
    high = [m for m in whole if not m.v[:, 2].mean() < cut]
    model.parts["body"].collision = solids(low, high, *pieces[1:])
    return model


def stacking_rings_random(rng: np.random.Generator) -> dict:
    return {"kind": "tower", "size": 1.0, "colours": RAINBOW[:5]}


def _plank_horse(c: dict, meshes: list[Mesh]) -> None:
    """A plank seat, a flat head in front, on rockers."""
    body, dark, red = c["body"], c["mane"], c["saddle"]
    head = [(0.16, 0.36), (0.17, 0.55), (0.24, 0.7), (0.3, 0.75), (0.31, 0.7), (0.43, 0.62)]
    head += [(0.42, 0.56), (0.34, 0.57), (0.31, 0.5), (0.3, 0.36)]
    meshes.append(extrude(head, 0.045, mat=body, axis="y", bevel_width=0.006))
    crest = [(0.165, 0.45), (0.14, 0.58), (0.2, 0.72), (0.275, 0.775), (0.29, 0.73), (0.215, 0.62)]
    meshes.append(extrude([*crest, (0.2, 0.5)], 0.055, mat=dark, axis="y"))
    meshes.append(box(0.5, 0.16, 0.035, (0, 0, 0.36), body, 0.01))
    meshes.append(box(0.26, 0.2, 0.03, (-0.03, 0, 0.392), red, 0.01))
    back = [(-0.17, 0.4), (-0.15, 0.4), (-0.19, 0.55), (-0.22, 0.53)]
    meshes.append(extrude(back, 0.19, mat=red, axis="y", bevel_width=0.005))
    tail = [(-0.24, 0, 0.38), (-0.33, 0, 0.4), (-0.36, 0, 0.3), (-0.37, 0, 0.2)]
    meshes.append(tube(tail, [0.015, 0.03, 0.03, 0.008], 7, mat=dark))


def _round_horse(c: dict, meshes: list[Mesh]) -> None:
    """A stuffed horse: round body, neck and head."""
    body, dark, red = c["body"], c["mane"], c["saddle"]
    meshes.append(ellipsoid((0.25, 0.12, 0.13), (0, 0, 0.42), 14, 8, body))
    neck = [(0.14, 0, 0.46), (0.24, 0, 0.6), (0.27, 0, 0.68)]
    meshes.append(tube(neck, [0.105, 0.08, 0.07], 9, mat=body))
    meshes.append(ellipsoid((0.085, 0.068, 0.08), (0.275, 0, 0.7), 9, 6, body))
    meshes.append(ellipsoid((0.09, 0.052, 0.055), (0.37, 0, 0.655), 9, 6, c["muzzle"]))
    crest = [(0.3, 0, 0.79), (0.2, 0, 0.75), (0.13, 0, 0.62), (0.1, 0, 0.54)]
    meshes.append(tube(crest, [0.02, 0.038, 0.038, 0.02], 7, mat=dark))
    for q in (-1, 1):
        ear = cylinder(0.022, 0.07, (0, 0, 0), body, 7, top=0.003)
        meshes.append(ear.turn(rx=-0.25 * q).move(0.265, q * 0.04, 0.76))
        meshes.append(ellipsoid(0.014, (0.335, q * 0.06, 0.715), 7, 5, plain("#17120f", 0)))
        bridle = [(0.29, q * 0.07, 0.66), (0.2, q * 0.11, 0.62), (0.05, q * 0.1, 0.56)]
        meshes.append(tube(bridle, 0.007, 5, mat=red))
    seat = [(-0.11, 0.535), (0.09, 0.53), (0.1, 0.56), (0, 0.562), (-0.1, 0.59), (-0.13, 0.57)]
    meshes.append(extrude(seat, 0.16, mat=red, axis="y", bevel_width=0.008))
    for q in (-1, 1):
        meshes.append(box(0.16, 0.012, 0.16, (0, q * 0.117, 0.38), red, 0.004))
    tail = [(-0.23, 0, 0.47), (-0.31, 0, 0.48), (-0.35, 0, 0.36), (-0.34, 0, 0.24)]
    meshes.append(tube(tail, [0.02, 0.036, 0.036, 0.01], 7, mat=dark))


def _seat_horse(c: dict, meshes: list[Mesh]) -> None:
    """For toddlers: a seat with a back between two horse-shaped sides."""
    body, dark, red = c["body"], c["mane"], c["saddle"]
    side = [(-0.26, 0.1), (-0.27, 0.3), (-0.23, 0.44), (-0.05, 0.42), (0.06, 0.46), (0.1, 0.58)]
    side += [(0.14, 0.62), (0.15, 0.58), (0.27, 0.5), (0.26, 0.45), (0.18, 0.44), (0.2, 0.3)]
    side += [(0.2, 0.1)]
    for q in (-1, 1):
        meshes.append(extrude(side, 0.022, mat=body, axis="y", bevel_width=0.004).move(y=q * 0.13))
        mane = [(0.045, 0.46), (0.075, 0.57), (0.13, 0.63), (0.11, 0.58), (0.09, 0.48)]
        meshes.append(extrude(mane, 0.03, mat=dark, axis="y").move(y=q * 0.13))
        meshes.append(ellipsoid(0.014, (0.16, q * 0.144, 0.54), 7, 5, plain("#17120f", 0)))
    meshes.append(box(0.24, 0.25, 0.022, (-0.07, 0, 0.24), red, 0.004))
    meshes.append(box(0.022, 0.25, 0.22, (-0.2, 0, 0.26), red, 0.004))
    meshes.append(rod((0.1, -0.13, 0.4), (0.1, 0.13, 0.4), 0.014, c["rocker"], 8))


def rocking_horse(kind: str, body: str, mane: str, saddle: str, rocker: str) -> Model:
    """A rocking horse facing +X: sawn 'planks', a 'plush' one, or a toddler's 'seat'."""
    light = wood(rocker, shade(rocker, 0.7), 0, 10)
    c = {
        "body": plain(body, 0.06, 60),
        "mane": plain(mane, 0.15, 120),
        "saddle": plain(saddle, 0.06, 60),
        "muzzle": plain(shade(body, 1.25), 0.06, 60),
        "rocker": light,
    }
    upper: list[Mesh] = []
    {"planks": _plank_horse, "plush": _round_horse, "seat": _seat_horse}[kind](c, upper)
    lower: list[Mesh] = []
    half, y = (0.44, 0.14) if kind != "seat" else (0.36, 0.135)

    def rise(x: float) -> float:
        return 0.12 * max(0.0, (x / half) ** 2 - 0.17)  # flat where it rests

    arc = [(half * t, rise(half * t)) for t in np.linspace(-1, 1, 11)]
    curve = arc + [(x * 0.985, z + 0.035) for x, z in arc[::-1]]
    sides: list[list[Mesh]] = []
    for q in (-1, 1):
        side = [extrude(curve, 0.028, mat=light, axis="y").move(y=q * y)]
        if kind != "seat":
            for x, top in ((-0.17, -0.12), (0.2, 0.15)):
                foot, hip = (x, q * y, 0.04), (top, q * 0.07, 0.38)
                side.append(rod(foot, hip, 0.026, c["body"], 8, 0.036))
                side.append(cylinder(0.034, 0.03, (x, q * y, 0.035), c["mane"], 8))
        sides.append(side)
    for x in (-0.3, 0.3) if kind != "seat" else (-0.22, 0.24):
        z = rise(x) + 0.02
        lower.append(rod((x, -y, z), (x, y, z), 0.013, light, 7))
    if kind == "planks":
        black = plain("#17120f", 0)
        upper.append(rod((0.235, -0.14, 0.57), (0.235, 0.14, 0.57), 0.013, light, 8))
        for q in (-1, 1):
            upper.append(ellipsoid(0.02, (0.235, q * 0.14, 0.57), 7, 5, c["saddle"]))
            eye = ellipsoid((0.016, 0.008, 0.016), (0.335, q * 0.023, 0.665), 7, 5, black)
            upper.append(eye)
            upper.append(box(0.1, 0.006, 0.014, (0.365, q * 0.0245, 0.6), c["saddle"]))
    parts = grounded([*upper, *sides[0], *sides[1], *lower])
    if kind == "plush":  # for the smallest
        grown(parts, 0.8)
    high = [m for m in upper if m.v[:, 2].mean() > (0.5 if kind != "plush" else 0.4)]
    low = [m for m in upper if not m.v[:, 2].mean() > (0.5 if kind != "plush" else 0.4)]
    if kind == "seat":
        walls = ([m for m in upper if np.sign(m.v[:, 1].mean().round(3)) == q] for q in (-1, 1))
        boards = [m for m in upper if abs(m.v[:, 1].mean()) < 0.01]
        pieces = solids(*walls, *([m] for m in boards), sides[0][:1], sides[1][:1])
    else:
        pieces = solids(high, low)
        for side in sides:
            pieces += solids(side[:1], side[1:3], side[3:])
    return Model("rocking horse", {"body": Part(parts, collision=pieces)}, mass=6.0, friction=0.6)


def rocking_horse_random(rng: np.random.Generator) -> dict:
    return {
        "kind": "planks",
        "body": pick(rng, ["#d8a868", "#f2efe6"]),
        "mane": "#5a3820",
        "saddle": "#c8242c",
        "rocker": "#c8965a",
    }


MODELS = {
    "stacking_rings": Maker(
        stacking_rings,
        stacking_rings_random,
        7,
        [
            {},
            {"kind": "half"},
            {"kind": "discs", "colours": RAINBOW},
            {"kind": "squares", "colours": RAINBOW[:5][::-1]},
            {"kind": "posts", "colours": RAINBOW},
            {"colours": ["#5fb8b0", "#f2a8a0", "#f2d890", "#8fb8e0", "#e07a6a"]},
            {"kind": "discs", "colours": RAINBOW[::-1]},
        ],
    ),
    "rocking_horse": Maker(
        rocking_horse,
        rocking_horse_random,
        6,
        [
            {"body": "#d8a868"},
            {"kind": "plush", "body": "#8a5228", "mane": "#f0dca8", "saddle": "#c8242c"},
            {"kind": "seat", "body": "#f2efe6", "mane": "#c8242c", "saddle": "#2f6fb0"},
            {"kind": "plush", "body": "#c9c2b8", "mane": "#4a3a30", "saddle": "#2f6fb0"},
            {"body": "#f2efe6", "mane": "#8a8f96", "saddle": "#e0609a", "rocker": "#e8dcc8"},
            {"kind": "seat", "body": "#d8a868", "mane": "#5a3820", "saddle": "#2f8a5a"},
        ],
    ),
}
