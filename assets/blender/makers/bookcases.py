"""Bookshelves and wall shelves in further shapes."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping

import numpy as np
from toolkit.materials import plain
from toolkit.model import Model
from toolkit.shapes import box, extrude, tube

from .book_rows import with_books
from .casework import Case, metal_or, smoked_glass
from .joinery import Assembly, finish, surface

Offset = tuple[float, float, float]


def bookcase_doors(
    width: float = 0.9,
    height: float = 1.95,
    depth: float = 0.36,
    wood: str = "#eceae5",
    glazed: bool = False,
    offset: Offset = (0, 0, 0),
) -> Model:
    """Open shelves over a cupboard with two doors; `glazed` closes the upper part as well."""
    case = Case(wood, None, wood, "knob", "shaker", "brass", offset, 0.02)
    half, t, base = width / 2, case.t, 0.07
    x = (-depth / 2, depth / 2 - 0.02)
    case.plinth(x, (-half, half), base, case.wood)
    case.carcass(x, (-half, half), (base, height - 0.03))
    case.top((x[0], depth / 2 + 0.012), (-half - 0.012, half + 0.012), (height - 0.03, height))
    middle, inner = 0.72, (-half + t, half - t)
    case.board(x, inner, (middle - t, middle), case.across)
    upper = (middle, height - 0.03 - t)
    shelf_x = (x[0], x[1] - 0.004)
    if glazed:
        case.bay("inside_top", shelf_x, inner, upper, 3, "door_top_left", "top")
    else:
        case.bay("", shelf_x, inner, upper, 3, prefix=None, container=False, setback=0.004)
        for k, support in enumerate(case.supports[1:]):
            support.name = f"shelf_{k + 1}"
    case.bay("inside", shelf_x, inner, (base + t, middle - t), 1, "door_left", "inside")
    for side, y in (("left", (-half, 0.0)), ("right", (0.0, half))):
        right = side == "right"
        case.door(f"door_{side}", x[1], y, (base, middle - t / 2), right, pull_z=middle - 0.12)
        if glazed:
            case.panel = smoked_glass("4c4f4c")
            z = (middle - t / 2, height - 0.032)
            case.door(f"door_top_{side}", x[1], y, z, right, rail=0.05)
            case.panel = None
            pane = (y[0] + 0.055, y[1] - 0.055)
            step = (upper[1] - upper[0] + t) / 4
            boards = [upper[0] + k * step for k in range(4)]
            _shine_through(case.asm, f"door_top_{side}", x[1] + 0.0135, pane, boards, right)
    return case.model(f"bookcase with {'glass ' if glazed else ''}doors", 42.0)


#: What is seen through a pane, in rows: half of an outline in y and z, its colour, how far apart.
BEHIND = (
    (((0.08, 0), (0.09, 0.02), (0.09, 0.1), (0.06, 0.115)), ("a39d8f", "7a5243"), 0.2),
    (((0.03, 0), (0.008, 0.012), (0.008, 0.09), (0.036, 0.11), (0.03, 0.18)), ("8c9899",), 0.082),
    (
        ((0.075, 0), (0.1, 0.07), (0.105, 0.1), (0.09, 0.1), (0.07, 0.135)),
        ("a8a59b", "66797f"),
        0.225,
    ),
    (((0.034, 0), (0.038, 0.105)), ("84918f",), 0.088),
)


def _shine_through(
    asm: Assembly, part: str, x: float, y: tuple[float, float], boards: list[float], right: bool
) -> None:
    """Draws on a pane, which is opaque, what stands on the boards behind it."""
    low, high = y
    for k, z in enumerate(boards):
        if k:
            asm.add(
                part,
                box(0.001, high - low, 0.018, (x, (low + high) / 2, z - 0.018), plain("8d8478")),
            )
        half, colours, apart = BEHIND[(k + 2 * right) % len(BEHIND)]
        outline = [*half, *((-u, v) for u, v in half[::-1])]
        many = int((high - low - 0.02) / apart)
        first = (low + high - (many - 1) * apart) / 2
        z = max(z, boards[0] + 0.045)  # the rail hides the lowest board
        for i in range(many):
            shape = extrude(outline, 0.001, plain(colours[i % len(colours)]), axis="x")
            asm.add(part, shape.move(x, first + i * apart, z))


def bookcase_cubes(
    columns: int = 3,
    rows: int = 5,
    cell: float = 0.31,
    depth: float = 0.32,
    wood: str = "#eceae5",
    baskets: bool = True,
    offset: Offset = (0, 0, 0),
) -> Model:
    """A grid of square cubes, some filled with boxes of cloth."""
    case, t = Case(wood, offset=offset), 0.022
    width, height = columns * cell + (columns + 1) * t, rows * cell + (rows + 1) * t
    half, x = width / 2, (-depth / 2, depth / 2)
    for c in range(columns + 1):
        y = -half + c * (cell + t)
        case.board(x, (y, y + t), (0, height), case.wood, 0.002)
    case.board((x[0], x[0] + 0.008), (-half + t, half - t), (0, height), case.wood)
    names = []
    for r in range(rows + 1):
        z = r * (cell + t)
        for c in range(columns):
            y = -half + t + c * (cell + t)
            case.board((x[0] + 0.008, x[1]), (y, y + cell), (z, z + t), case.across)
    colours = ("#7f9a8c", "#c98f5a", "#8a9fb5")
    cloths = [finish(c, 2, offset) for c in colours]
    k = 0
    for r in range(rows - 1, -1, -1):
        for c in range(columns):
            y, z = -half + t + c * (cell + t), r * (cell + t) + t
            boxed = baskets and r < 2 and (r + c) % 2 == 0
            if boxed:
                span = (y + 0.008, y + cell - 0.008)
                case.board(
                    (x[0] + 0.02, x[1] - 0.012), span, (z + 0.015, z + cell - 0.03),
                    cloths[k % 3], 0.01,
                )  # fmt: skip
                hole = (x[1] - 0.014, x[1] - 0.0105)
                case.board(hole, (y + 0.11, y + cell - 0.11), (z + 0.19, z + 0.21), solid=False)
                k += 1
                continue
            names.append((y, z))
    case.supports.append(surface("top", (x[0], -half), (x[1], half), height))
    for i, (y, z) in enumerate(names):
        low, high = (x[0] + 0.01, y), (x[1], y + cell)
        case.supports.append(surface(f"shelf_{i + 1}", low, high, z, cell))
    return case.model(f"cube shelf, {columns} by {rows}", 34.0)


def bookcase_ladder(
    width: float = 0.66,
    height: float = 1.82,
    wood: str = "oak",
    rail: str = "iron",
    offset: Offset = (0, 0, 0),
) -> Model:
    """Five shelves that get deeper downwards between two leaning ladders."""
    case, half, t = Case(wood, offset=offset), width / 2, 0.02
    depth, n = 0.42, 5
    x0 = -depth / 2
    frame = metal_or(rail, 2, offset)

    def front_x(z: float) -> float:
        return depth / 2 - (depth - 0.06) * z / height

    for y in (-half, half - 0.026):
        case.board((x0, x0 + 0.026), (y, y + 0.026), (0, height - 0.1), frame)
        outline = [(front_x(0) - 0.05, 0), (front_x(0), 0), (front_x(height), height)]
        outline += [(front_x(height) - 0.05, height)]
        mesh = extrude(outline, 0.026, frame, axis="y").move(0, y + 0.013, 0)
        case.asm.add("body", mesh)
        case.asm.piece("body", mesh.v)
    for k in range(n):
        z = 0.12 + k * (height - 0.28) / (n - 1)
        xf = front_x(z) - 0.012
        case.board((x0, xf), (-half + 0.026, half - 0.026), (z - t, z), case.across, 0.003)
        case.board((x0, x0 + 0.012), (-half + 0.026, half - 0.026), (z, z + 0.04), case.across)
        room = (height - 0.28) / (n - 1) - t if k < n - 1 else None
        name = "top" if k == n - 1 else f"shelf_{k + 1}"
        low, high = (x0 + 0.012, -half + 0.026), (xf, half - 0.026)
        case.supports.append(surface(name, low, high, z, room))
    return case.model("ladder shelf", 15.5)


def bookcase_frame(
    width: float = 0.95,
    height: float = 1.72,
    depth: float = 0.34,
    wood: str = "walnut",
    metal: str = "iron",
    tiers: int = 4,
    cross: bool = True,
    offset: Offset = (0, 0, 0),
) -> Model:
    """Boards in a frame of metal, crossed rods behind."""
    case, half, t, r = Case(wood, offset=offset), width / 2, 0.03, 0.014
    x0, x1 = -depth / 2, depth / 2
    rod = metal_or(metal)
    for x in (x0, x1 - 2 * r):
        for y in (-half, half - 2 * r):
            case.board((x, x + 2 * r), (y, y + 2 * r), (0, height), rod)
    for k in range(tiers):
        z = 0.14 + k * (height - 0.14) / (tiers - 1)
        for y in (-half, half - 2 * r):
            span = (x0 + 2 * r, x1 - 2 * r)
            case.board(span, (y, y + 2 * r), (z - t - 0.02, z - t), rod, solid=False)
        low = -half + (0.004 if k == tiers - 1 else 2 * r)
        case.board((x0 + 0.002, x1 - 0.002), (low, -low), (z - t, z), case.across, 0.004)
        room = (height - 0.14) / (tiers - 1) - t if k < tiers - 1 else None
        name = "top" if k == tiers - 1 else f"shelf_{k + 1}"
        case.supports.append(surface(name, (x0, low), (x1, -low), z, room))
    if cross:
        for s in (-1, 1):
            ends = [
                (x0 + 0.01, s * (half - 0.03), 0.2),
                (x0 + 0.01, -s * (half - 0.03), height - 0.1),
            ]
            case.asm.add("body", tube(ends, 0.006, 5, mat=rod))
    case.asm.solid("body", (x0, -half + 0.03, 0.14), (x0 + 0.02, half - 0.03, height - 0.03))
    return case.model("bookshelf of boards in a metal frame", 24.0)


def bookcase_zigzag(
    width: float = 0.75,
    height: float = 1.78,
    depth: float = 0.26,
    wood: str = "birch",
    offset: Offset = (0, 0, 0),
) -> Model:
    """A tree of boards: short shelves step to the left and right of one trunk."""
    case, half, t = Case(wood, offset=offset), width / 2, 0.022
    x = (-depth / 2, depth / 2)
    case.board(x, (-half, half), (0, 0.03), case.across, 0.004)
    case.board(x, (-t / 2, t / 2), (0.03, height), case.wood, 0.003)
    levels = np.linspace(0.22, height - 0.2, 7)
    for k, z in enumerate(levels):
        y = (-half, 0.13) if k % 2 == 0 else (-0.13, half)
        z = float(z)
        side = (-half, -t / 2) if k % 2 == 0 else (t / 2, half)
        rest = (t / 2, 0.13) if k % 2 == 0 else (-0.13, -t / 2)
        for span in (side, rest):
            case.board(x, span, (z - t, z), case.across, 0.002)
        end = y[0] if k % 2 == 0 else y[1] - t
        case.board(x, (end, end + t), (z, z + 0.19), case.wood, 0.002)
        inner = (side[0] + t, side[1]) if k % 2 == 0 else (side[0], side[1] - t)
        room = 0.2
        low, high = (x[0], inner[0]), (x[1], inner[1])
        case.supports.append(surface(f"shelf_{k + 1}", low, high, z, room))
    for name, a, b in (("base_left", -half, -t / 2), ("base_right", t / 2, half)):
        case.supports.append(surface(name, (x[0], a), (x[1], b), 0.03, 0.16))
    top = surface("top", (x[0], -0.13), (x[1], -t / 2), float(levels[-1]))
    case.supports.append(top)
    return case.model("bookshelf like a tree", 15.5)


# ---- wall shelves
def shelf_cubes(
    size: float = 0.3,
    depth: float = 0.22,
    count: int = 3,
    wood: str = "oak",
    offset: Offset = (0, 0, 0),
) -> Model:
    """Cubes hung stepwise beside one another, open to the front."""
    asm, t, x0, x1 = Assembly(), 0.018, -depth / 2, depth / 2
    across, up = finish(wood, 1, offset), finish(wood, 2, offset)
    supports = []
    width = count * size + (count - 1) * 0.03
    for k in range(count):
        y, z = -width / 2 + k * (size + 0.03), 0.1 * (k % 2)
        for a in (y, y + size - t):
            asm.board("body", (x0, a, z), (x1, a + t, z + size), up, 0.002)
        for b in (z, z + size - t):
            asm.board("body", (x0, y + t, b), (x1, y + size - t, b + t), across, 0.0)
        asm.board("body", (x0, y + t, z + t), (x0 + 0.006, y + size - t, z + size - t), up)
        low, high = (x0 + 0.006, y + t), (x1, y + size - t)
        name = "top" if k == 0 else f"top_{k + 1}"
        supports.append(surface(name, (x0, y), (x1, y + size), z + size))
        supports.append(surface(f"shelf_{k + 1}", low, high, z + t, size - 2 * t))
    return Model("wall shelf, cubes", asm.parts(), 6.0, supports=supports)


def shelf_tiers(
    width: float = 0.62,
    depth: float = 0.2,
    height: float = 0.385,
    wood: str = "pine",
    rope: bool = True,
    offset: Offset = (0, 0, 0),
) -> Model:
    """Two boards hung on ropes, or held by two side frames of metal."""
    asm, half, x0, x1, t = Assembly(), width / 2, -depth / 2, depth / 2, 0.02
    board = finish(wood, 1, offset)
    line = finish("#d8c9a8") if rope else metal_or("iron")
    supports = []
    low_z, high_z = 0.02, 0.2 if rope else 0.22
    for name, z in (("top", high_z), ("shelf_1", low_z)):
        asm.board("body", (x0, -half, z), (x1, half, z + t), board, 0.003)
        room = high_z - low_z - t if name == "shelf_1" else None
        inner = half - 0.04
        supports.append(surface(name, (x0, -inner), (x1, inner), z + t, room))
    for s in (-1, 1):
        y = s * (half - 0.035)
        if rope:
            for x in (x0 + 0.02, x1 - 0.02):
                path = [(x, y, 0.004), (x, y, high_z + 0.02), (x0 + 0.012, y, height)]
                asm.add("body", tube(path, 0.006, 6, mat=line))
            knob = [(x0, y, height), (x0 + 0.02, y, height)]
            asm.add("body", tube(knob, 0.014, 8, mat=metal_or("iron")))
        else:
            for x in (x0, x1 - 0.012):
                asm.board("body", (x, y - 0.006, 0), (x + 0.012, y + 0.006, height), line)
            for z in (0.0, height - 0.012):
                asm.board("body", (x0, y - 0.006, z), (x1, y + 0.006, z + 0.012), line)
    title = "wall shelf, two boards " + ("on ropes" if rope else "in metal frames")
    return Model(title, asm.parts(), 4.0, supports=supports)


def shelf_half_round(
    width: float = 0.6,
    depth: float = 0.25,
    wood: str = "walnut",
    offset: Offset = (0, 0, 0),
) -> Model:
    """A half-round board on a carved console."""
    asm, half, x0 = Assembly(), width / 2, -depth / 2
    a = np.linspace(-math.pi / 2, math.pi / 2, 17)
    edge = [(x0 + depth * math.cos(t), half * math.sin(t)) for t in a]
    height, t = 0.24, 0.026
    top = finish(wood, 1, offset)
    asm.add("body", extrude(edge, t, top, bevel_width=0.005).move(z=height - t))
    flat = np.array([(*p, z) for p in edge[::2] for z in (height - t, height)])
    asm.piece("body", flat)
    curve = [(x0, 0.0), (x0 + 0.02, 0.01)]
    curve += [
        (x0 + 0.03 + 0.85 * depth * s**2.2, 0.02 + (height - t - 0.02) * s**0.9)
        for s in np.linspace(0.1, 0.9, 8)
    ]
    curve += [(x0 + 0.8 * depth, height - t), (x0, height - t)]
    for y in (-0.13, 0.13):
        mesh = extrude(curve, 0.035, finish(wood, 2, offset), axis="y").move(0, y, 0)
        asm.add("body", mesh)
        asm.piece("body", np.array([(p[0], y + s, p[1]) for p in curve for s in (-0.017, 0.017)]))
    support = surface("top", (x0, -half * 0.8), (x0 + depth * 0.6, half * 0.8), height)
    support.polygon = [(px * 0.97 - 0.004, py * 0.95) for px, py in edge[1:-1:2]]
    return Model("wall shelf, half round on brackets", asm.parts(), 4.0, supports=[support])


def shelf_pegs(
    width: float = 0.9,
    depth: float = 0.18,
    wood: str = "#dfe6e2",
    offset: Offset = (0, 0, 0),
) -> Model:
    """A board between two curved cheeks before a back that rises over it; pegs below."""
    asm, half, x0, x1 = Assembly(), width / 2, -depth / 2, depth / 2
    across, up = finish(wood, 1, offset), finish(wood, 2, offset)
    height, t, z = 0.3, 0.022, 0.13
    ys = np.linspace(half - 0.02, -half + 0.02, 13)
    back = [(-half + 0.02, 0.03), (half - 0.02, 0.03)]
    back += [(float(y), height - 0.07 + 0.07 * math.cos(1.5 * y / half) ** 2) for y in ys]
    asm.add("body", extrude(back, 0.016, across, axis="x").move(x0 + 0.008, 0, 0))
    asm.solid("body", (x0, -half + 0.02, 0.03), (x0 + 0.016, half - 0.02, height - 0.05))
    asm.board("body", (x0 + 0.016, -half, z - t), (x1, half, z), finish("oak", 1, offset), 0.004)
    cheek = [(x0, 0.0), (x0 + 0.03, 0.0), (x0 + 0.06, 0.06), (x1 - 0.01, z - t), (x1 - 0.01, z)]
    cheek += [(x1 - 0.05, z + 0.05), (x0 + 0.05, 0.2), (x0 + 0.02, height - 0.06)]
    for y in (-half + 0.03, half - 0.03):
        mesh = extrude([*cheek, (x0, height - 0.06)], 0.022, up, axis="y").move(0, y, 0)
        asm.add("body", mesh)
        asm.solid("body", (x0, y - 0.011, 0), (x0 + 0.06, y + 0.011, height - 0.06))
    for y in np.linspace(-half + 0.14, half - 0.14, 5):
        peg = [(x0 + 0.014, y, 0.06), (x0 + 0.075, y, 0.075)]
        asm.add("body", tube(peg, (0.009, 0.012), 8, mat=finish("oak")), solid=True)
    support = surface("top", (x0 + 0.016, -half + 0.045), (x1, half - 0.045), z)
    return Model("wall shelf with a back and pegs", asm.parts(), 4.5, supports=[support])


#: Boards that come with books, by number, of what has many small ones.
CUBES_WITH = {2: "bright", 4: "novels", 8: "pastels", 11: "grey"}
TREE_WITH = {1: "novels", 3: "pastels", 5: "bright", 6: "grey"}


def stocked(of: Callable[..., Model], boards: Mapping[str, str]) -> Callable[..., Model]:
    """The same piece, some of its boards full of books of a palette."""

    def make(**parameters: object) -> Model:
        return with_books(of(**parameters), boards)

    make.__name__ = of.__name__
    return make


BOOKSHELVES = [
    (stocked(bookcase_doors, {"shelf_2": "novels", "shelf_4": "grey"}), {}),
    (stocked(bookcase_cubes, {f"shelf_{k}": c for k, c in CUBES_WITH.items()}), {}),
    (stocked(bookcase_ladder, {"shelf_2": "pastels"}), {}),
    (stocked(bookcase_frame, {"shelf_2": "bright"}), {}),
    (bookcase_doors, {"wood": "walnut", "glazed": True}),
    (stocked(bookcase_zigzag, {f"shelf_{k}": c for k, c in TREE_WITH.items()}), {}),
]
WALL_SHELVES = [
    (shelf_cubes, {}),
    (shelf_tiers, {}),
    (shelf_half_round, {}),
    (shelf_tiers, {"rope": False, "wood": "walnut", "width": 0.8, "height": 0.36}),
    (shelf_pegs, {}),
]
