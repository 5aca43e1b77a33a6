"""Dining chairs of all kinds; those with slats, rungs or a panel are in `seating`."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import Material, metal, plain
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Support, round_polygon
from toolkit.sampling import noise_offset, pick
from toolkit.shapes import box, extrude, lathe, loft, rounded_rectangle, spline, superellipse, tube

from .forms import by_form
from .joinery import Assembly, cushion, fabric, finish, steel, surface
from .seating import chair as joined_chair

Offset = tuple[float, float, float]
NAMES = {"#e8e6e0": "white", "#f0efec": "white", "#d8a838": "yellow", "#3f6b66": "teal"}
SEAT = 0.45


def _rod(asm: Assembly, points, radius, mat: Material, n: int = 6, solid: bool = True) -> None:
    """A rod along points; it collides as the box of each of its ends' spans."""
    asm.add("body", tube(points, radius, n, mat=mat))
    if solid:
        p, r = np.asarray(points, float), float(np.max(radius))
        asm.piece(
            "body", np.concatenate([p[[0, -1]] + d for d in ((r, r, 0), (-r, -r, 0), (r, -r, 0))])
        )


def _back_piece(asm: Assembly, x: tuple, half: float, z: tuple) -> None:
    """A leaning slab that stands for the back."""
    asm.piece(
        "body",
        np.array(
            [
                (a + s, y, h)
                for a, h in zip(x, z, strict=True)
                for s in (-0.012, 0.012)
                for y in (-half, half)
            ]
        ),
    )


def _model(asm: Assembly, title: str, mass: float, seat: Support) -> Model:
    return Model(title=title, parts=asm.parts(), mass=mass, supports=[seat], ground_shadow=True)


def _rush(offset: Offset) -> Material:
    """A woven seat of paper cord: strands that meet on the diagonals."""
    m = Material()
    ax, ay = m.math("ABSOLUTE", m.axis(0)), m.math("ABSOLUTE", m.axis(1))
    strands = m.math("SINE", m.math("MULTIPLY", m.math("MAXIMUM", ax, ay), 420))
    base = m.mottle("#cdb184", 0.08, 40, offset)
    return m.colour(m.mix(m.remap(strands, -1, 0.6, 0.5, 0), base, "#8a6a3c"))


def joined(
    wood: str = "oak",
    seat: str | None = None,
    style: str = "slats",
    height: float = 0.86,
    offset: Offset = (0, 0, 0),
) -> Model:
    """The joiner's chair, with a plain name for painted ones."""
    model = joined_chair(wood, seat, style, height, offset)
    backs = {"slats": "upright slats", "rungs": "rungs", "panel": "panel back"}
    tone = NAMES.get(wood, wood)
    model.title = f"{tone} chair, {backs[style]}{' and a cushion' if seat else ''}"
    return model


def ladder(wood: str = "oak", offset: Offset = (0, 0, 0)) -> Model:
    """A tall ladder-back with a rush seat."""
    asm, timber, cross = Assembly(), finish(wood, 2, offset), finish(wood, 1, offset)
    w, top = 0.2, 1.04
    for y in (-w, w):
        _rod(asm, [(0.2, y * 1.05, 0), (0.195, y * 1.05, SEAT + 0.01)], 0.019, timber, 8)
        _rod(asm, [(-0.2, y, 0), (-0.195, y, SEAT), (-0.255, y, top - 0.02)], 0.019, timber, 8)
        asm.add(
            "body",
            lathe(
                [(0, 0), (0.02, 0), (0.023, 0.014), (0.012, 0.03), (0, 0.034)], 8, mat=timber
            ).move(-0.255, y, top - 0.025),
        )
        for z in (0.14, 0.3):
            _rod(asm, [(0.2, y, z), (-0.2, y, z)], 0.01, timber, 5, False)
    for z in (0.18, 0.36):
        _rod(asm, [(0.2, -w, z), (0.2, w, z)], 0.01, cross, 5, False)
    _rod(asm, [(-0.2, -w, 0.2), (-0.2, w, 0.2)], 0.01, cross, 5, False)
    for k, z in enumerate((0.57, 0.7, 0.83, 0.95)):
        x = -0.195 - 0.06 * (z - SEAT) / (top - SEAT)
        tall = 0.05 + 0.008 * k
        arc = [(-w, 0.0), (-w / 2, -0.018), (0, -0.024), (w / 2, -0.018), (w, 0.0)]
        outline = [(b, a) for a, b in arc] + [(b - 0.014, a) for a, b in arc[::-1]]
        asm.add("body", extrude(outline, tall, mat=cross).move(x + 0.007, 0, z - tall / 2))
    seat = extrude(
        rounded_rectangle(0.43, 0.45, 0.03, 3), 0.035, mat=_rush(offset), bevel_width=0.012
    )
    asm.add("body", seat.move(0, 0, SEAT - 0.03), solid=True)
    _back_piece(asm, (-0.2, -0.255), w, (0.5, top))
    support = surface("seat", (-0.19, -0.2), (0.2, 0.2), SEAT + 0.005)
    return _model(asm, f"{NAMES.get(wood, wood)} ladder-back chair with a rush seat", 4.5, support)


def wishbone(wood: str = "oak", offset: Offset = (0, 0, 0)) -> Model:
    """A curved rail on bent legs, a Y in the back, a woven seat."""
    asm, timber = Assembly(), finish(wood, 2, offset)
    rail = [(0.08, -0.265, 0.7), (-0.08, -0.272, 0.71), (-0.21, -0.2, 0.735), (-0.265, 0, 0.755)]
    rail += [(x, -y, z) for x, y, z in rail[:3][::-1]]
    asm.add("body", tube(spline(rail, 4), 0.0165, 7, mat=finish(wood, 1, offset)))
    for s in (-1, 1):
        _rod(asm, [(0.21, 0.235 * s, 0), (0.2, 0.225 * s, 0.45)], [0.012, 0.019], timber, 8)
        leg = [
            (-0.21, 0.2 * s, 0),
            (-0.2, 0.2 * s, 0.3),
            (-0.17, 0.225 * s, 0.52),
            (-0.09, 0.27 * s, 0.7),
        ]
        asm.add(
            "body",
            tube(spline(leg, 3), [*np.linspace(0.013, 0.019, 5), *[0.018] * 5], 7, mat=timber),
        )
        asm.solid("body", (-0.225, 0.2 * s - 0.02, 0), (-0.185, 0.2 * s + 0.02, 0.45))
        low, high = sorted((0.2 * s, 0.285 * s))
        asm.solid("body", (-0.22, low, 0.45), (0.09, high, 0.73))
        _rod(asm, [(0.2, 0.225 * s, 0.24), (-0.2, 0.2 * s, 0.24)], 0.01, timber, 5, False)
        fork = [(-0.215, 0.008 * s, 0.56), (-0.235, 0.05 * s, 0.66), (-0.258, 0.075 * s, 0.745)]
        asm.add("body", tube(fork, 0.011, 5, mat=timber))
    asm.add("body", tube([(-0.19, 0, 0.42), (-0.217, 0, 0.58)], 0.014, 6, mat=timber))
    for x, y in ((0.2, 0.225), (-0.2, 0.2)):
        _rod(asm, [(x, -y, 0.32), (x, y, 0.32)], 0.01, timber, 5, False)
    outline = [(0.22, -0.245), (0.22, 0.245), (-0.215, 0.215), (-0.215, -0.215)]
    asm.add(
        "body",
        extrude(outline, 0.032, mat=_rush(offset), bevel_width=0.012).move(0, 0, SEAT - 0.03),
        solid=True,
    )
    _back_piece(asm, (-0.21, -0.26), 0.19, (0.52, 0.77))
    support = surface("seat", (-0.2, -0.2), (0.2, 0.2), SEAT + 0.002)
    return _model(asm, f"{NAMES.get(wood, wood)} wishbone chair with a woven seat", 4.6, support)


def _shell_mesh(mat: Material) -> Mesh:
    """A moulded seat and back in one, as thick as cast plastic."""
    # (x, z, half width, how far its sides curl forward and up, direction of the outside)
    path = [(0.23, 0.425, 0.2, 0.0), (0.19, 0.452, 0.225, 0.008), (0.05, 0.45, 0.235, 0.03)]
    path += [(-0.12, 0.44, 0.235, 0.045), (-0.2, 0.475, 0.235, 0.06), (-0.235, 0.56, 0.232, 0.06)]
    path += [(-0.255, 0.68, 0.22, 0.05), (-0.272, 0.79, 0.19, 0.03), (-0.28, 0.835, 0.12, 0.012)]
    p = np.array(path)
    tangent = np.gradient(p[:, :2], axis=0)
    tangent /= np.linalg.norm(tangent, axis=1)[:, None]
    inward = np.c_[tangent[:, 1], -tangent[:, 0]]  # up on the seat, forward on the back
    rings, t = [], 0.011
    for (x, z, half, curl), n in zip(path, inward, strict=True):
        upper, lower = [], []
        for u in np.linspace(-1, 1, 7):
            lift = curl * u * u
            base = np.array([x, z]) + n * lift
            upper.append((base[0], u * half, base[1]))
            low = base - n * t
            lower.append((low[0], u * half, low[1]))
        rings.append(np.array(upper + lower[::-1]))
    return loft(rings, mat).outward()


def shell(colour: str = "#f0efec", legs: str = "oak", offset: Offset = (0, 0, 0)) -> Model:
    """A plastic shell on splayed wooden legs, or on a steel wire base (legs "wire")."""
    asm = Assembly()
    asm.add("body", _shell_mesh(plain(colour, 0.02, 8, offset)))
    asm.solid("body", (-0.2, -0.22, 0.425), (0.22, 0.22, 0.452))
    _back_piece(asm, (-0.22, -0.28), 0.2, (0.47, 0.84))
    dark = plain("#1f2123", 0.04)
    wire = legs == "wire"
    mat = steel(20) if wire else finish(legs, 2, offset)
    r = 0.009 if wire else [0.011, 0.017]
    for sx, sy in ((1, 1), (1, -1), (-1, 1), (-1, -1)):
        foot, head = (0.22 * sx - 0.01, 0.22 * sy, 0), (0.12 * sx, 0.13 * sy, 0.43)
        _rod(asm, [foot, head], r, mat, 6)
    for y in (-0.165, 0.165):
        _rod(asm, [(0.155, y, 0.22), (-0.17, y, 0.22)], 0.006, dark, 5, False)
        _rod(asm, [(0.155, y, 0.22), (0.1, -0.7 * y, 0.42)], 0.005, dark, 4, False)
        _rod(asm, [(-0.17, y, 0.22), (-0.1, -0.7 * y, 0.42)], 0.005, dark, 4, False)
    tone = NAMES.get(colour, "coloured")
    what = "a wire base" if wire else "wooden legs"
    return _model(
        asm,
        f"{tone} shell chair on {what}",
        4.2,
        surface("seat", (-0.15, -0.17), (0.18, 0.17), 0.462),
    )


def upholstered(colour: str = "#8b8f94", wood: str = "walnut", offset: Offset = (0, 0, 0)) -> Model:
    """A padded dining chair with a high, straight back."""
    asm, cloth, timber = Assembly(), fabric(colour, offset), finish(wood, 2, offset)
    for sx in (-1, 1):
        for sy in (-1, 1):
            foot, head = (
                (sx * 0.2 - (0.03 if sx < 0 else 0), sy * 0.19, 0),
                (sx * 0.19, sy * 0.19, 0.38),
            )
            _rod(asm, [foot, head], [0.013, 0.021], timber, 6)
    asm.add(
        "body", cushion((0.46, 0.47, 0.11), (0.02, 0, 0.36), cloth, 0.05, 0.012, 0.03), solid=True
    )
    rest = cushion((0.62, 0.46, 0.08), (0, 0, 0), cloth, 0.05, 0.01, 0.03)
    rest.turn(ry=-math.pi / 2 - 0.13).move(-0.165, 0, 0.7)
    asm.add("body", rest)
    _back_piece(asm, (-0.2, -0.28), 0.22, (0.42, 1.0))
    return _model(
        asm, "upholstered dining chair", 7.0, surface("seat", (-0.15, -0.2), (0.22, 0.2), 0.484)
    )


def folding(colour: str = "#3a3d40", wood: str | None = None, offset: Offset = (0, 0, 0)) -> Model:
    """Crossed frames, a flat seat and a narrow back: it folds flat."""
    asm, frame = Assembly(), finish(colour, 2, offset)
    panel = finish(wood or colour, 1, offset)
    for s in (-1, 1):
        y = 0.205 * s
        bent = [(0.22, y, 0), (-0.12, y, 0.45), (-0.225, y, 0.8)]
        _rod(asm, bent[:2], 0.0115, frame, 6)
        _rod(asm, bent[1:], 0.0115, frame, 6)
        _rod(asm, [(-0.24, y * 0.9, 0), (0.15, y * 0.9, 0.435)], 0.0115, frame, 6)
    for x, z, y in ((0.18, 0.08, 0.205), (-0.17, 0.08, 0.185), (-0.223, 0.795, 0.205)):
        _rod(asm, [(x, -y, z), (x, y, z)], 0.0095, frame, 6, False)
    if wood:
        for k in range(5):
            x = -0.16 + 0.085 * k
            asm.board("body", (x, -0.2, 0.43), (x + 0.072, 0.2, 0.448), panel, 0.003)
    else:
        asm.board("body", (-0.16, -0.2, 0.43), (0.25, 0.2, 0.452), panel, 0.01, segments=2)
    for z in (0.63, 0.73) if wood else (0.68,):
        x = -0.12 - 0.3 * (z - 0.45)
        tall = 0.06 if wood else 0.15
        slat = box(0.016, 0.4, tall, (0, 0, -tall / 2), panel, 0.005)
        asm.add("body", slat.turn(ry=-0.29).move(x, 0, z))
    _back_piece(asm, (-0.15, -0.225), 0.2, (0.56, 0.8))
    seat_z = 0.448 if wood else 0.452
    kind = "wooden" if wood else "metal"
    return _model(
        asm, f"{kind} folding chair", 3.6, surface("seat", (-0.09, -0.18), (0.24, 0.18), seat_z)
    )


def windsor(wood: str = "black", offset: Offset = (0, 0, 0)) -> Model:
    """A saddle seat on turned, splayed legs; spindles under a bent bow."""
    asm, timber = Assembly(), finish(wood, 2, offset)
    outline = superellipse(0.215, 0.225, 2.6, 16)[:, :2]
    seat = extrude(outline, 0.038, mat=finish(wood, 1, offset), bevel_width=0.012)
    asm.add("body", seat.move(0, 0, SEAT - 0.038), solid=True)
    for sx in (-1, 1):
        for sy in (-1, 1):
            foot, head = np.array([sx * 0.22, sy * 0.22, 0]), np.array([sx * 0.13, sy * 0.14, 0.42])
            points = [foot + (head - foot) * t for t in (0, 0.3, 0.5, 0.62, 0.7, 1)]
            radii = [0.012, 0.018, 0.023, 0.014, 0.02, 0.016]
            _rod(asm, points, radii, timber, 6)
    for s in (-1, 1):
        _rod(asm, [(0.185, 0.19 * s, 0.16), (-0.185, 0.19 * s, 0.16)], 0.0105, timber, 5, False)
    _rod(asm, [(0, -0.19, 0.16), (0, 0.19, 0.16)], 0.0105, timber, 5, False)
    bow = [
        (-0.15, -0.19, SEAT - 0.01),
        (-0.2, -0.215, 0.66),
        (-0.235, -0.16, 0.86),
        (-0.25, 0, 0.945),
    ]
    bow += [(x, -y, z) for x, y, z in bow[:3][::-1]]
    asm.add("body", tube(spline(bow, 4), 0.0125, 6, mat=timber))
    for k in range(7):
        u = (k - 3) / 3
        top = 0.935 - 0.13 * u * u
        y, x = 0.15 * u, -0.15 - 0.1 * (top - SEAT) / 0.5
        _rod(asm, [(-0.165, 0.8 * y, SEAT - 0.005), (x, y * 1.02, top)], 0.0065, timber, 5, False)
    _back_piece(asm, (-0.17, -0.25), 0.2, (0.5, 0.94))
    support = surface("seat", (-0.13, -0.16), (0.17, 0.16), SEAT)
    return _model(asm, f"{NAMES.get(wood, wood)} Windsor chair", 5.2, support)


def cantilever(colour: str = "#26272a", offset: Offset = (0, 0, 0)) -> Model:
    """A bent steel tube without back legs, slung with leather."""
    asm, chrome = Assembly(), metal("d3d7da", "82888e", (1, 1, 5), 30)
    hide = plain(colour, 0.06, 30, offset)
    for s in (-1, 1):
        y = 0.225 * s
        path = [(-0.24, y, 0.014), (0.2, y, 0.014), (0.25, y, 0.03), (0.255, y, 0.1)]
        path += [(0.25, y, 0.38), (0.235, y, 0.44), (0.18, y, 0.452), (-0.12, y, 0.43)]
        path += [(-0.19, y, 0.45), (-0.215, y, 0.52), (-0.28, y, 0.86)]
        asm.add("body", tube(spline(path, 2), 0.012, 6, mat=chrome))
        asm.solid("body", (-0.24, y - 0.012, 0), (0.26, y + 0.012, 0.027))
        asm.solid("body", (0.235, y - 0.012, 0.02), (0.262, y + 0.012, 0.44))
    _rod(asm, [(-0.24, -0.225, 0.014), (-0.24, 0.225, 0.014)], 0.012, chrome, 6, False)
    _rod(asm, [(-0.28, -0.225, 0.86), (-0.28, 0.225, 0.86)], 0.012, chrome, 6, False)
    asm.board("body", (-0.15, -0.235, 0.43), (0.22, 0.235, 0.466), hide, 0.012, segments=2)
    pad = box(0.028, 0.47, 0.24, (0, 0, -0.12), hide, 0.01, 2)
    asm.add("body", pad.turn(ry=-0.18).move(-0.252, 0, 0.735))
    _back_piece(asm, (-0.22, -0.285), 0.22, (0.52, 0.87))
    return _model(
        asm,
        "cantilever chair of steel tube",
        6.0,
        surface("seat", (-0.13, -0.19), (0.2, 0.19), 0.466),
    )


def bistro(wood: str = "walnut", offset: Offset = (0, 0, 0)) -> Model:
    """A café chair of bent wood: round seat, two loops for a back."""
    asm, timber = Assembly(), finish(wood, 2, offset)
    cane = Material()
    weave = cane.voronoi(70, randomness=0.0)
    cane.colour(cane.ramp(weave, [(0.25, "#d9bd8a"), (0.4, "#a07c48")]))
    disc = [
        (0, SEAT - 0.03),
        (0.19, SEAT - 0.03),
        (0.2, SEAT - 0.015),
        (0.195, SEAT),
        (0.165, SEAT + 0.002),
    ]
    disc += [(0.16, SEAT - 0.004), (0, SEAT - 0.004)]
    asm.add(
        "body", lathe(disc, 20, mats=[finish(wood, 1, offset), cane], mat_of_segment=[0] * 5 + [1])
    )
    asm.solid("body", (-0.18, -0.18, SEAT - 0.03), (0.18, 0.18, SEAT))
    for sy in (1, -1):
        _rod(
            asm, [(0.19, 0.17 * sy, 0), (0.125, 0.115 * sy, SEAT - 0.02)], [0.012, 0.018], timber, 7
        )
    big = [(-0.24, -0.19, 0), (-0.17, -0.155, 0.43), (-0.22, -0.175, 0.68), (-0.245, -0.13, 0.83)]
    big.append((-0.255, 0, 0.885))
    big += [(x, -y, z) for x, y, z in big[:4][::-1]]
    asm.add("body", tube(spline(big, 4), 0.0145, 7, mat=timber))
    for s in (-1, 1):
        asm.solid("body", (-0.25, 0.17 * s - 0.03, 0), (-0.16, 0.17 * s + 0.03, SEAT))
    small = [
        (-0.18, -0.075, 0.45),
        (-0.215, -0.095, 0.62),
        (-0.235, -0.06, 0.76),
        (-0.24, 0, 0.795),
    ]
    small += [(x, -y, z) for x, y, z in small[:3][::-1]]
    asm.add("body", tube(spline(small, 4), 0.011, 6, mat=timber))
    angles = np.arange(16) * math.pi / 8
    hoop = [(0.155 * math.cos(a) - 0.02, 0.155 * math.sin(a), 0.21) for a in angles]
    asm.add("body", tube(hoop, 0.009, 5, closed=True, mat=timber))
    _back_piece(asm, (-0.18, -0.255), 0.16, (0.5, 0.89))
    polygon = round_polygon(0.155, 12)
    return _model(asm, f"{wood} bentwood chair", 3.8, Support("seat", SEAT, polygon))


FORMS = {
    "joined": joined,
    "ladder": ladder,
    "wishbone": wishbone,
    "shell": shell,
    "upholstered": upholstered,
    "folding": folding,
    "windsor": windsor,
    "cantilever": cantilever,
    "bistro": bistro,
}


def chair_random(rng: np.random.Generator) -> dict:
    """Parameters of a random chair."""
    return {
        "form": pick(rng, sorted(FORMS)),
        "wood": pick(rng, ["oak", "walnut", "#e8e6e0", "black"]),
        "seat": pick(rng, [None, "#7a8a99", "#a3644c", "#8d9a7b"]),
        "style": pick(rng, ["slats", "rungs", "panel"]),
        "height": round(float(rng.uniform(0.82, 0.94)), 2),
        "offset": noise_offset(rng),
    }


MODELS = {
    "chair": Maker(
        by_form("chair", FORMS),
        chair_random,
        13,
        [
            {"form": "joined", "wood": "oak", "seat": "#7a8a99", "style": "slats"},
            {"form": "joined", "wood": "#e8e6e0", "seat": None, "style": "rungs"},
            {"form": "joined", "wood": "walnut", "seat": "#8d9a7b", "style": "panel"},
            {"form": "joined", "wood": "black", "seat": None, "style": "slats"},
            {"form": "ladder", "wood": "oak"},
            {"form": "wishbone", "wood": "oak"},
            {"form": "shell", "colour": "#f0efec", "legs": "oak"},
            {"form": "shell", "colour": "#d8a838", "legs": "oak"},
            {"form": "upholstered", "colour": "#8b8f94", "wood": "walnut"},
            {"form": "folding", "colour": "oak", "wood": "oak"},
            {"form": "windsor", "wood": "black"},
            {"form": "cantilever", "colour": "#26272a"},
            {"form": "bistro", "wood": "walnut"},
        ],
    ),
}
