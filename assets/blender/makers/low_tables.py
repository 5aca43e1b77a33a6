"""Coffee and side tables in further shapes."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import Material, plain
from toolkit.model import Model, cylinder_piece, prism_piece
from toolkit.shapes import extrude, lathe, superellipse, tube

from .casework import Case, cane, metal_or, oval, smoked_glass, spot
from .joinery import Assembly, finish, leg, stone, surface

Offset = tuple[float, float, float]


def _hairpin(asm: Assembly, x: float, y: float, z: float, out: tuple, mat: Material) -> None:
    """A bent rod: two prongs that meet at the foot."""
    ox, oy = out
    side = np.array([-oy, ox]) / (math.hypot(ox, oy) or 1) * 0.045
    for s in (-1, 1):
        path = [(x + s * side[0], y + s * side[1], z), (x + ox, y + oy, 0.006)]
        asm.add("body", tube(path, 0.006, 6, mat=mat))
    asm.solid("body", (x + ox - 0.01, y + oy - 0.01, 0), (x + ox + 0.01, y + oy + 0.01, z))


def table_oval(
    length: float = 1.15,
    depth: float = 0.6,
    height: float = 0.42,
    wood: str = "walnut",
    hairpin: bool = True,
    offset: Offset = (0, 0, 0),
) -> Model:
    """An oval top on four hairpin legs."""
    asm, t = Assembly(), 0.03
    rx, ry = depth / 2, length / 2
    outline = superellipse(rx, ry, 2.2, 36)[:, :2]
    top = extrude(outline, t, finish(wood, 1, offset), bevel_width=0.006).move(z=height - t)
    asm.add("body", top.weigh(1.3))
    asm.piece("body", prism_piece(outline[::3], height - t, height))
    for sx in (-1, 1):
        for sy in (-1, 1):
            x, y = sx * rx * 0.58, sy * ry * 0.62
            _hairpin(asm, x, y, height - t, (sx * 0.035, sy * 0.05), metal_or("iron"))
    return Model(
        "oval coffee table on hairpin legs",
        asm.parts(),
        12.0,
        supports=[oval("top", rx, ry, height, margin=0.02)],
        ground_shadow=True,
    )


def table_drum(
    radius: float = 0.36,
    height: float = 0.4,
    colour: str = "oak",
    ribs: int = 30,
    top: str | None = None,
    title: str = "drum coffee table",
    mass: float = 15.0,
    offset: Offset = (0, 0, 0),
) -> Model:
    """A drum: a fluted wall and a flat top."""
    asm, r = Assembly(), radius
    n = 2 * ribs
    wall = [(0, 0), (r * 0.92, 0), (r * 0.92, 0.03), (r * 0.96, 0.03), (r * 0.96, height - 0.03)]
    mesh = lathe(
        [*wall, (0, height - 0.03)], n, mat=finish(colour, 2, offset),
        rib=lambda k, i: 1.0 if i % 2 else 0.965,
    )  # fmt: skip
    asm.add("body", mesh)
    lid = [(0, height - 0.03), (r, height - 0.03), (r, height - 0.004), (r - 0.004, height)]
    asm.add(
        "body", lathe([*lid, (0, height)], 36, mat=finish(top or colour, 1, offset), weight=1.3)
    )
    asm.piece("body", cylinder_piece(r, 0, height, 16))
    return Model(
        title,
        asm.parts(),
        mass,
        supports=[spot("top", 0, 0, r - 0.012, height)],
        ground_shadow=True,
    )


def table_glass(
    length: float = 1.1,
    depth: float = 0.6,
    height: float = 0.43,
    metal: str = "brass",
    shelf: str = "glass",
    offset: Offset = (0, 0, 0),
) -> Model:
    """A glass top on a metal frame, a shelf of glass or wood under it."""
    asm, hx, hy, r = Assembly(), depth / 2, length / 2, 0.012
    rod = metal_or(metal)
    for x in (-hx, hx - 2 * r):
        for y in (-hy, hy - 2 * r):
            asm.board("body", (x, y, 0), (x + 2 * r, y + 2 * r, height - 0.012), rod)
    for z, k in ((height - 0.036, 0), (0.14, 1)):
        for x in (-hx, hx - 2 * r):
            asm.board("body", (x, -hy, z), (x + 2 * r, hy, z + 0.022), rod, solid=False)
        for y in (-hy, hy - 2 * r):
            asm.board("body", (-hx, y, z), (hx, y + 2 * r, z + 0.022), rod, solid=False)
        mat = smoked_glass() if k == 0 or shelf == "glass" else finish(shelf, 1, offset)
        inset = 0.0 if k == 0 else 2 * r
        top = z + 0.036 if k == 0 else z + 0.024
        low, high = (-hx + inset, -hy + inset, top - 0.014), (hx - inset, hy - inset, top)
        asm.board("body", low, high, mat, 0.003)
    supports = [surface("top", (-hx, -hy), (hx, hy), height)]
    low, high = (-hx + 2 * r, -hy + 2 * r), (hx - 2 * r, hy - 2 * r)
    supports.append(surface("shelf_1", low, high, 0.164, height - 0.04 - 0.164))
    return Model(
        "glass coffee table with a shelf", asm.parts(), 18.0, supports=supports, ground_shadow=True
    )


def table_tiers(radius: float = 0.4, wood: str = "oak", offset: Offset = (0, 0, 0)) -> Model:
    """A round top and a shelf near the floor, of one wood between four upright legs at the rim, so
    that it reads as one table."""
    asm, t, height, low = Assembly(), 0.024, 0.43, 0.16
    supports = []
    for name, r, z in (("top", radius, height), ("shelf_1", radius - 0.045, low)):
        lid = [(0, z - t), (r - 0.005, z - t), (r, z - t + 0.005), (r, z - 0.004), (r - 0.004, z)]
        asm.add("body", lathe([*lid, (0, z)], 32, mat=finish(wood, 1, offset), weight=1.3))
        asm.piece("body", cylinder_piece(r, z - t, z, 14))
        supports.append(spot(name, 0, 0, r - 0.02, z))
    supports[1].headroom = height - t - low
    for k in range(4):
        a = math.pi / 4 + k * math.pi / 2
        at = ((radius - 0.04) * math.cos(a), (radius - 0.04) * math.sin(a))
        leg(asm, "body", at, at, (0, height - t), (0.02, 0.02), finish(wood, 2, offset), 10)
    return Model(
        "round coffee table with a shelf", asm.parts(), 12.0, supports=supports, ground_shadow=True
    )


def table_drawer(
    length: float = 1.05,
    depth: float = 0.62,
    height: float = 0.42,
    wood: str = "pine",
    frame: str = "#eceae5",
    offset: Offset = (0, 0, 0),
) -> Model:
    """Thick square legs, a drawer under half the top and an open bay beside it."""
    case = Case(frame, wood, wood, "cup", pull_finish="iron", offset=offset)
    half, x = length / 2, (-depth / 2 + 0.02, depth / 2 - 0.04)
    top = finish(wood, 1, offset)
    case.legs((-depth / 2, depth / 2), (-half, half), height - 0.03, 0.045, (0.034, 0.036), sides=4)
    z0, z1 = 0.16, height - 0.03
    case.carcass(x, (-half + 0.02, half - 0.02), (z0, z1), outside=case.wood)
    case.top((-depth / 2, depth / 2), (-half, half), (z1, height), top)
    case.board(x, (-0.009, 0.009), (z0 + 0.018, z1), case.inside)
    case.drawer("drawer", x, (-half + 0.08, 0.0), (z0, z1))
    low, high = (x[0] + 0.02, 0.01), (x[1], half - 0.08)
    case.supports.append(surface("shelf_1", low, high, z0 + 0.018, z1 - z0 - 0.036))
    return case.model("coffee table with a drawer and an open bay", 20.0)


# ---- side tables
def side_c(
    width: float = 0.46,
    height: float = 0.6,
    wood: str = "oak",
    metal: str = "iron",
    offset: Offset = (0, 0, 0),
) -> Model:
    """A C-shaped table that reaches over a sofa's seat."""
    asm, h, d = Assembly(), width / 2, 0.4
    rod, r, x0, x1 = metal_or(metal), 0.014, -d / 2, d / 2
    board = finish(wood, 1, offset)
    asm.board("body", (x0, -h, height - 0.024), (x1, h, height), board, 0.004)
    for y in (-h + 0.03, h - 0.03 - 2 * r):
        asm.board("body", (x0, y, 0), (x0 + 2 * r, y + 2 * r, height - 0.024), rod)
        asm.board("body", (x0, y, 0), (x1, y + 2 * r, 0.022), rod)
        asm.board("body", (x0, y, height - 0.05), (x1 - 0.02, y + 2 * r, height - 0.024), rod)
    asm.board("body", (x0, -h + 0.03, 0), (x0 + 2 * r, h - 0.03, 0.022), rod)
    support = surface("top", (x0, -h), (x1, h), height)
    return Model("C-shaped side table", asm.parts(), 5.0, supports=[support], ground_shadow=True)


def side_pedestal(
    radius: float = 0.23,
    height: float = 0.58,
    top: str = "#e9e6e0",
    foot: str = "#2c2e30",
    marble: bool = True,
    offset: Offset = (0, 0, 0),
) -> Model:
    """A round top on one turned column with a trumpet foot."""
    asm, r = Assembly(), radius
    column = [(0, 0), (0.17, 0), (0.172, 0.008), (0.13, 0.02), (0.06, 0.06), (0.028, 0.15)]
    column += [(0.022, 0.3), (0.024, height - 0.1), (0.06, height - 0.024), (0, height - 0.024)]
    asm.add("body", lathe(column, 24, mat=metal_or(foot)))
    mat = stone(top, "#8d8a86", offset) if marble else finish(top, 1, offset)
    lid = [
        (0, height - 0.024),
        (r - 0.006, height - 0.024),
        (r, height - 0.014),
        (r, height - 0.006),
    ]
    asm.add("body", lathe([*lid, (r - 0.005, height), (0, height)], 36, mat=mat, weight=1.3))
    for z0, z1, q in ((0, 0.02, 0.17), (0.02, height - 0.024, 0.03), (height - 0.024, height, r)):
        asm.piece("body", cylinder_piece(q, z0, z1, 12))
    support = spot("top", 0, 0, r - 0.012, height)
    return Model(
        "round side table on a pedestal", asm.parts(), 7.0, supports=[support], ground_shadow=True
    )


def side_drum(
    radius: float = 0.2,
    height: float = 0.46,
    wall: str = "cane",
    wood: str = "oak",
    offset: Offset = (0, 0, 0),
) -> Model:
    """A woven drum with a wooden lid, waisted in the middle."""
    asm, r = Assembly(), radius
    k = [(0, 0), (r * 0.96, 0), (r, 0.01), (r * 0.8, height * 0.32), (r * 0.74, height * 0.5)]
    k += [(r * 0.8, height * 0.68), (r, height - 0.034), (0, height - 0.034)]
    mat = cane() if wall == "cane" else plain(wall, 0.04, 14, offset)
    asm.add("body", lathe(k, 28, mat=mat))
    lid = [
        (0, height - 0.034),
        (r, height - 0.034),
        (r + 0.01, height - 0.026),
        (r + 0.01, height - 0.005),
    ]
    asm.add(
        "body", lathe([*lid, (r + 0.005, height), (0, height)], 32, mat=finish(wood, 1, offset))
    )
    asm.piece("body", cylinder_piece(r, 0, height, 14))
    return Model(
        "drum side table",
        asm.parts(),
        5.0,
        supports=[spot("top", 0, 0, r, height)],
        ground_shadow=True,
    )


def side_nest(
    wood: str = "walnut",
    width: float = 0.5,
    offset: Offset = (0, 0, 0),
) -> Model:
    """Three tables, one pushed under another."""
    asm = Assembly()
    top, up = finish(wood, 1, offset), finish(wood, 2, offset)
    supports, d = [], 0.42
    for k, (w, h, shift) in enumerate(
        ((width, 0.56, 0.0), (width - 0.1, 0.5, 0.008), (width - 0.2, 0.44, 0.016))
    ):
        half, x0, x1 = w / 2, -d / 2 + shift, d / 2 + shift - 0.02 * k
        asm.board("body", (x0, -half, h - 0.02), (x1, half, h), top, 0.004)
        for x in (x0 + 0.01, x1 - 0.034):
            for y in (-half + 0.006, half - 0.03):
                asm.board("body", (x, y, 0), (x + 0.024, y + 0.024, h - 0.02), up)
        for y in (-half + 0.01, half - 0.026):
            asm.board(
                "body", (x0 + 0.03, y, h - 0.045), (x1 - 0.03, y + 0.016, h - 0.02), up, solid=False
            )
        if k == 0:
            supports.append(surface("top", (x0, -half), (x1, half), h))
    return Model(
        "nest of three side tables", asm.parts(), 9.0, supports=supports, ground_shadow=True
    )


COFFEE_TABLES = [
    (table_oval, {}),
    (table_drum, {}),
    (table_glass, {}),
    (table_tiers, {}),
    (table_drawer, {}),
    (table_glass, {"metal": "iron", "shelf": "walnut"}),
]
SIDE_TABLES = [(side_c, {}), (side_pedestal, {}), (side_drum, {}), (side_nest, {})]
SIDE_TABLES += [(side_pedestal, {"top": "oak", "marble": False, "foot": "#e9e7e1"})]
