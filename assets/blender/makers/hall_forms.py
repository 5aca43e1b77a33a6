"""Coat racks and shoe racks in further shapes."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
from toolkit.materials import plain, shade
from toolkit.mesh import Mesh
from toolkit.model import Model, cylinder_piece
from toolkit.shapes import ellipsoid, extrude, lathe, loft, spline, tube

from .casework import Case, metal_or
from .garments_hung import coat, hang, hat
from .joinery import Assembly, finish, surface

Offset = tuple[float, float, float]


def rack_tree(wood: str = "birch", height: float = 1.75, offset: Offset = (0, 0, 0)) -> Model:
    """A trunk with branches on a round foot, things on most of them."""
    asm, timber = Assembly(), finish(wood, 2, offset)
    base = [(0, 0), (0.2, 0), (0.205, 0.01), (0.2, 0.026), (0, 0.026)]
    asm.add("body", lathe(base, 24, mat=timber))
    trunk = spline([(0, 0, 0.02), (0.012, 0.008, 0.6), (-0.01, 0, 1.2), (0.0, 0.0, height)], 3)
    asm.add("body", tube(trunk, np.linspace(0.027, 0.016, len(trunk)), 8, mat=timber))
    for k, z in enumerate((0.95, 1.1, 1.25, 1.38, 1.5, 1.6)):
        a = k * 2.4
        c, s = math.cos(a), math.sin(a)
        reach = 0.2 - 0.016 * k
        branch = [
            (0, 0, z),
            (0.5 * reach * c, 0.5 * reach * s, z + 0.05),
            (reach * c, reach * s, z + 0.15),
        ]
        asm.add("body", tube(spline(branch, 3), np.linspace(0.014, 0.009, 7), 7, mat=timber))
    for mesh in hat("#5a4632"):
        asm.add("body", mesh.move(0, 0, height))
    for k, what in ((1, ("bag", "#8a5632", "#5f3a22")), (3, ("jacket", "#5d6b52", "#d8b25a"))):
        a, reach = k * 2.4, 0.2 - 0.016 * k
        z = (0.95, 1.1, 1.25, 1.38, 1.5, 1.6)[k] + 0.11
        hang(asm, what, (0.8 * reach * math.cos(a), 0.8 * reach * math.sin(a), z), a)
    hang(asm, ("scarf", "#a8423a", "#e8dcc6"), (-0.07, -0.08, 1.66), -2.3)
    asm.piece("body", cylinder_piece(0.205, 0, 0.026, 12))
    asm.solid("body", (-0.025, -0.025, 0.026), (0.025, 0.025, height))
    return Model("coat tree with a hat, a bag and a jacket", asm.parts(), 7.5, ground_shadow=True)


def rack_rail(metal: str = "iron", wood: str = "oak", offset: Offset = (0, 0, 0)) -> Model:
    """A clothes rail on two A-shaped ends, coats on it, a board for shoes below."""
    asm, rod = Assembly(), metal_or(metal)
    hy, height = 0.36, 1.5
    for s in (-1, 1):
        y = s * hy
        for e in (-1, 1):
            path = [(e * 0.21, y, 0.012), (e * 0.02, y, height)]
            asm.add("body", tube(path, 0.012, 6, mat=rod))
            square = [(p, q) for p in (-0.012, 0.012) for q in (-0.012, 0.012)]
            ends = ((e * 0.21, 0.0), (e * 0.02, height))
            asm.piece("body", np.array([(x + p, y + q, z) for x, z in ends for p, q in square]))
    asm.add(
        "body",
        tube([(0, -hy - 0.03, height), (0, hy + 0.03, height)], 0.014, 8, mat=rod),
        solid=True,
    )
    asm.board(
        "body", (-0.18, -hy + 0.01, 0.14), (0.18, hy - 0.01, 0.16), finish(wood, 1, offset), 0.003
    )
    worn = ((-0.2, "#8a3f35", 0.86), (-0.05, "#3f5568", 0.74), (0.12, "#b59a6a", 0.8))
    for k, (y, colour, length) in enumerate(worn):
        for mesh in coat(colour, shade(colour, 0.8), offset, length):
            asm.add("body", mesh.turn(rz=math.pi / 2 + 0.15 * (k - 1)).move(0, y, height - 0.07))
        hook = [
            (0, y, height - 0.11),
            (0, y, height - 0.03),
            (0.014, y, height + 0.01),
            (0, y, height + 0.018),
        ]
        asm.add("body", tube(spline(hook, 2), 0.005, 5, mat=metal_or("steel")))
    asm.solid("body", (-0.14, -0.28, height - 0.95), (0.14, 0.22, height - 0.13))
    return Model("clothes rail with coats", asm.parts(), 9.0, ground_shadow=True)


def rack_hall(wood: str = "#eceae5", height: float = 1.75, offset: Offset = (0, 0, 0)) -> Model:
    """A hall stand: a panelled back with hooks over two low shelves for shoes."""
    asm, hy = Assembly(), 0.38
    up, along = finish(wood, 2, offset), finish(wood, 1, offset)
    x0, x1 = -0.19, 0.19
    for k in range(5):
        w = 2 * hy / 5
        y = -hy + k * w
        asm.board(
            "body", (x0, y + 0.002, 0.1), (x0 + 0.018, y + w - 0.002, height - 0.04), up, 0.003
        )
    asm.board(
        "body",
        (x0, -hy - 0.01, height - 0.05),
        (x0 + 0.14, hy + 0.01, height - 0.028),
        along,
        0.004,
    )
    asm.board("body", (x0 + 0.016, -hy, 1.42), (x0 + 0.032, hy, 1.52), along, 0.004)
    for y in np.linspace(-hy + 0.1, hy - 0.1, 4):
        hook = [(x0 + 0.03, y, 1.47), (x0 + 0.09, y, 1.45), (x0 + 0.11, y, 1.5)]
        asm.add("body", tube(spline(hook, 3), 0.009, 6, mat=metal_or("iron")))
    hang(asm, ("coat", "#4b5a45", "#3a4636"), (x0 + 0.1, -0.15, 1.48))
    hang(asm, ("tote", "#d8cbb0", "#8a3f35"), (x0 + 0.1, 0.2, 1.48))
    for mesh in hat("#3a3f4a"):
        asm.add("body", mesh.scale(0.8).move(x0 + 0.1, -0.2, height - 0.02))
    for y in (-hy, hy - 0.022):
        asm.board("body", (x0, y, 0), (x1, y + 0.022, 0.28), up, 0.003)
    asm.board("body", (x0, -hy, 0.28), (x1 + 0.01, hy, 0.302), along, 0.004)
    asm.board("body", (x0 + 0.01, -hy + 0.022, 0.1), (x1 - 0.01, hy - 0.022, 0.118), along)
    pair(asm, (0.02, 0.24, 0.302), "#3a3a3c", "#26221f")
    pair(asm, (0.02, -0.2, 0.118), "#8a5a32")
    return Model("hall stand with hooks, a coat and shoes", asm.parts(), 14.5, ground_shadow=True)


def rack_bent(
    colour: str = "#7a3f22",
    height: float = 1.82,
    worn: tuple[tuple[str, ...], ...] = (),
    offset: Offset = (0, 0, 0),
) -> Model:
    """The coffee-house one of bent wood: S-shaped arms, a ring for umbrellas."""
    asm, timber = Assembly(), finish(colour, 2, offset)
    pole = [
        (0, 0.08),
        (0.022, 0.08),
        (0.02, height - 0.04),
        (0.03, height - 0.02),
        (0.018, height),
        (0, height),
    ]
    asm.add("body", lathe(pole, 10, mat=timber))
    for k in range(4):
        a = math.pi / 4 + k * math.pi / 2
        c, s = math.cos(a), math.sin(a)

        def curve(points, c=c, s=s):
            return spline([(q * c, q * s, z) for q, z in points], 2)

        foot = curve([(0.02, 0.45), (0.1, 0.4), (0.13, 0.2), (0.2, 0.06), (0.28, 0.014)])
        asm.add("body", tube(foot, 0.014, 5, mat=timber))
        asm.solid(
            "body",
            (0.28 * c - 0.015, 0.28 * s - 0.015, 0),
            (0.28 * c + 0.015, 0.28 * s + 0.015, 0.03),
        )
        arm = curve(
            [
                (0.02, height - 0.3),
                (0.1, height - 0.28),
                (0.13, height - 0.16),
                (0.2, height - 0.14),
                (0.24, height - 0.02),
            ]
        )
        asm.add("body", tube(arm, 0.012, 5, mat=timber))
        small = curve([(0.02, height - 0.42), (0.1, height - 0.46), (0.15, height - 0.38)])
        asm.add("body", tube(small, 0.01, 5, mat=timber))
    t = np.linspace(0, 2 * math.pi, 15)[:-1]
    ring = np.c_[0.15 * np.cos(t), 0.15 * np.sin(t), np.full(14, 0.5)]
    asm.add("body", tube(ring, 0.01, 5, closed=True, mat=timber))
    asm.solid("body", (-0.02, -0.02, 0.0), (0.02, 0.02, height))
    for k, what in enumerate(worn):
        a = math.pi / 4 + (0, 2, 1, 3)[k] * math.pi / 2
        hang(asm, what, (0.15 * math.cos(a), 0.15 * math.sin(a), height - 0.15), a)
    return Model("bentwood coat rack with clothes", asm.parts(), 7.0, ground_shadow=True)


# ---- shoe racks
def shoe(colour: str, sole: str = "#f1efe8") -> list[Mesh]:
    """A plain low shoe, its toe to +X, standing on 0; few faces."""
    upper, edge = plain(colour, 0.06, 25), plain(sole, 0.03, 20)
    rings = []
    for x, w, h in (
        (-0.125, 0.03, 0.03),
        (-0.115, 0.055, 0.085),
        (-0.05, 0.062, 0.09),
        (0.0, 0.07, 0.078),
        (0.06, 0.084, 0.052),
        (0.105, 0.07, 0.04),
        (0.13, 0.03, 0.025),
    ):
        a = np.linspace(0, math.pi, 6)
        top = [(x, w / 2 * math.cos(t) * 1.0, 0.018 + (h - 0.018) * math.sin(t) ** 0.7) for t in a]
        rings.append(np.array([*top]))
    body = loft(rings, upper).outward()
    ring = [
        (x * 1.03, y)
        for x, y in (
            (-0.125, -0.03),
            (-0.04, -0.034),
            (0.06, -0.044),
            (0.12, -0.03),
            (0.134, 0),
            (0.12, 0.03),
            (0.06, 0.044),
            (-0.04, 0.034),
            (-0.125, 0.03),
        )
    ]
    hole = ellipsoid((0.045, 0.02, 0.008), (-0.07, 0, 0.088), 8, 4, plain("#1d1a18", 0))
    return [body, extrude(ring, 0.02, edge), hole]


def pair(asm: Assembly, at: tuple[float, float, float], colour: str, sole: str = "#f1efe8") -> None:
    """Two shoes side by side, toes to the front."""
    x, y, z = at
    for s in (-1, 1):
        for mesh in shoe(colour, sole):
            asm.add("body", mesh.move(x, y + s * 0.052, z))
    asm.solid("body", (x - 0.12, y - 0.09, z), (x + 0.13, y + 0.09, z + 0.08))


def shoes_metal(
    tiers: int = 4, width: float = 0.62, metal: str = "steel", offset: Offset = (0, 0, 0)
) -> Model:
    """Sloping rods between two side frames, tier over tier; shoes on the lower ones."""
    asm, rod = Assembly(), metal_or(metal)
    half, d = width / 2, 0.28
    height = 0.1 + 0.2 * tiers
    supports = []
    for s in (-1, 1):
        y = s * (half - 0.012)
        frame = [(-d / 2, y, 0.0), (-d / 2, y, height), (d / 2, y, height - 0.06), (d / 2, y, 0.0)]
        for a, b in pairwise(frame):
            asm.add("body", tube([a, b], 0.012, 6, mat=rod))
        for x in (-d / 2, d / 2):
            asm.solid("body", (x - 0.012, y - 0.012, 0), (x + 0.012, y + 0.012, height - 0.06))
    for k in range(tiers):
        z = 0.1 + 0.2 * k
        for x in np.linspace(-d / 2 + 0.02, d / 2 - 0.02, 5):
            asm.add("body", tube([(x, -half + 0.012, z), (x, half - 0.012, z)], 0.008, 5, mat=rod))
        asm.solid("body", (-d / 2, -half, z - 0.008), (d / 2, half, z + 0.008))
        name = "top" if k == tiers - 1 else f"shelf_{k + 1}"
        worn = TIERS[k] if k < len(TIERS) else ()
        for n, colour in enumerate(worn):
            pair(asm, (0, -half + 0.14 + 0.19 * n, z + 0.008), colour)
        low = -half + (0.04 + 0.19 * len(worn) if worn else 0.03)
        room = 0.18 if k < tiers - 1 else None
        supports.append(surface(name, (-d / 2, low), (d / 2, half - 0.03), z + 0.008, room))
    return Model(
        "shoe rack of metal rods with shoes",
        asm.parts(),
        4.0,
        supports=supports,
        ground_shadow=True,
    )


def shoes_bench(
    width: float = 0.85, wood: str = "birch", rows: int = 4, offset: Offset = (0, 0, 0)
) -> Model:
    """Rows of four pigeonholes, some with a pair of shoes: too high for a seat."""
    case, d = Case(wood, offset=offset), 0.32
    half, t, height = width / 2, 0.018, 0.03 + 0.2 * rows
    x = (-d / 2, d / 2)
    case.carcass(x, (-half, half), (0.03, height), outside=case.wood)
    case.plinth((x[0], x[1] + 0.01), (-half, half), 0.03)
    floors = [0.03 + (height - 0.03) * k / rows for k in range(rows)]
    cell = (width - 2 * t) / 4
    for z in floors[1:]:
        case.board(x, (-half + t, half - t), (z - t / 2, z + t / 2), case.across)
    for k in range(1, 4):
        y = -half + t + k * cell
        case.board((x[0], x[1] - 0.004), (y - t / 2, y + t / 2), (0.03 + t, height - t), case.wood)
    case.supports.append(surface("top", (x[0], -half), (x[1], half), height))
    n = 0
    for r, floor in enumerate(floors):
        z = floor + (t if r == 0 else t / 2)
        for c in range(4):
            y = -half + t + c * cell
            if (r, c) in SHOES_IN:
                pair(case.asm, (0.01, y + cell / 2, z), SHOES_IN[r, c])
                continue
            n += 1
            low, high = (x[0] + 0.01, y + t / 2), (x[1], y + cell - t / 2)
            case.supports.append(surface(f"shelf_{n}", low, high, z, 0.17, margin=0.004))
    return case.model("shoe shelves of pigeonholes", 16.0)


def shoes_cabinet(
    width: float = 0.75, height: float = 0.98, depth: float = 0.26, wood: str = "#eceae5",
    face: str | None = None, offset: Offset = (0, 0, 0),
) -> Model:  # fmt: skip
    """A shallow shoe cupboard: two fronts that tip open over shelves."""
    case = Case(wood, face, "birch", "groove", offset=offset)
    half, t = width / 2, case.t
    x = (-depth / 2, depth / 2 - 0.018)
    case.plinth((x[0], x[1]), (-half, half), 0.05)
    case.carcass(x, (-half, half), (0.05, height - 0.02))
    case.top((x[0], depth / 2 + 0.006), (-half - 0.006, half + 0.006), (height - 0.02, height))
    middle = 0.05 + (height - 0.07) / 2
    case.board(x, (-half + t, half - t), (middle - t / 2, middle + t / 2), case.inside)
    for k, (z0, z1) in enumerate(((0.05, middle), (middle, height - 0.02))):
        name = f"flap_{k + 1}"
        low, high = z0 + (t if k == 0 else t / 2), z1 - (t / 2 if k == 0 else t)
        case.bay(
            f"inside_{k + 1}",
            (x[0], x[1] - 0.02),
            (-half + t, half - t),
            (low, high),
            1,
            name,
            f"inside_{k + 1}",
        )
        case.flap(name, x[1], (-half, half), (z0, z1), 1.1)
    return case.model("shoe cabinet with two tipping fronts", 22.0)


def shoes_ladder(wood: str = "pine", width: float = 0.7, offset: Offset = (0, 0, 0)) -> Model:
    """Four slatted shelves in a tall narrow frame with arched ends."""
    case, d, height = Case(wood, offset=offset), 0.3, 0.95
    half, x0, x1 = width / 2, -0.15, 0.15
    for s in (-1, 1):
        y = s * (half - 0.011)
        for x in (x0, x1 - 0.03):
            case.board((x, x + 0.03), (y - 0.011, y + 0.011), (0, height - 0.06), case.wood, 0.003)
        ts = np.linspace(0, math.pi, 9)
        arch = [(d / 2 * math.cos(t), height - 0.06 + 0.06 * math.sin(t)) for t in ts]
        arch += [
            ((d / 2 - 0.03) * math.cos(t), height - 0.07 + 0.03 * math.sin(t)) for t in ts[::-1]
        ]
        case.asm.add("body", extrude(arch, 0.022, case.wood, axis="y").move(0, y, 0))
    for k in range(4):
        z = 0.12 + 0.21 * k
        for i in range(4):
            a = x0 + 0.004 + i * 0.074
            case.board((a, a + 0.062), (-half + 0.022, half - 0.022), (z - 0.014, z), case.across)
        name = "top" if k == 3 else f"shelf_{k + 1}"
        worn = TIERS[k + 1] if k + 1 < len(TIERS) else ()
        for n, colour in enumerate(worn):
            pair(case.asm, (0, -half + 0.14 + 0.19 * n, z), colour)
        low = -half + (0.05 + 0.19 * len(worn) if worn else 0.03)
        case.supports.append(
            surface(name, (x0, low), (x1, half - 0.03), z, 0.19 if k < 3 else None)
        )
    return case.model("tall shoe rack of slats", 7.0)


#: In which pigeonholes (row, column) a pair of what colour is.
SHOES_IN = {(0, 1): "#2f3f55", (1, 3): "#8a5a32", (2, 0): "#b8b2a4", (3, 2): "#3a3a3c"}
SHOES_IN |= {(0, 2): "#6e322a", (1, 0): "#c0392b", (2, 1): "#4b5a45", (3, 0): "#7a6a5a"}
#: The colours of the pairs on each tier of a rack, from below.
TIERS = (("#c0392b", "#2f3f55"), ("#8a5a32",), ("#3a3a3c", "#b8b2a4"))
BENT_WORN = (("coat", "#3f5568", "#33465a"), ("scarf", "#c9b48a", "#7a3f35"))
BLACK_WORN = (
    ("jacket", "#8a4a3a", "#d8cbb0"),
    ("umbrella", "#2f3a52"),
    ("cap", "#3f5568", "#e6dfcf"),
)
COAT_RACKS = [(rack_tree, {}), (rack_rail, {}), (rack_hall, {}), (rack_bent, {"worn": BENT_WORN})]
COAT_RACKS += [(rack_bent, {"colour": "black", "worn": BLACK_WORN})]
SHOE_RACKS = [(shoes_metal, {}), (shoes_bench, {}), (shoes_cabinet, {}), (shoes_ladder, {})]
SHOE_RACKS += [(shoes_metal, {"tiers": 2, "width": 0.75, "metal": "iron"})]
