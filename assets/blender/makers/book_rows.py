"""Rows of books and of files, each one thing: what fills a shelf without a body for every book."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace

import numpy as np
from toolkit.materials import plain
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part, box_piece
from toolkit.sampling import pick
from toolkit.shapes import box

from makers.books import paper_edge

#: Cloth and paper of spines, and of the bands on them.
NOVELS = ("#7a2f2b", "#23486b", "#c9b37e", "#3c5a41", "#d9d2c3", "#8a5a2c", "#40343f", "#b9452f")
PASTELS = ("#e8dcc8", "#a9c3c9", "#d9a29a", "#cdd3b0", "#f0ead9", "#8fa5b8", "#e3c58f", "#b6a7b9")
BRIGHT = ("#d8342b", "#f2b632", "#2f7fb8", "#3f9b56", "#7a4a97", "#f0efe9", "#e8762c", "#22262c")
LEATHER = ("#5b2d22", "#6b3f26", "#3d2a21", "#4a1f22", "#2e3a33", "#71502f")
GREY = ("#3a3f45", "#6c7178", "#a9adb2", "#e4e4e1", "#24272b", "#5b6b7d")
BANDS = ("#e9d9a8", "#f2efe6", "#c9a227", "#1f2227")
PALETTES = {
    "novels": NOVELS,
    "pastels": PASTELS,
    "bright": BRIGHT,
    "leather": LEATHER,
    "grey": GREY,
}

#: Pages end so far inside the boards.
INSET = 0.004


def _upright(
    deep: float, thick: float, tall: float, cover: str, band: str, style: int
) -> list[Mesh]:
    """A book with its spine at +X, standing at x <= 0, y from 0 to ``thick``."""
    cloth = plain(cover, 0.05, 80)
    board = min(0.003, thick / 5)
    meshes = [
        box(deep, board, tall, (-deep / 2, board / 2, 0), cloth),
        box(deep, board, tall, (-deep / 2, thick - board / 2, 0), cloth),
        box(board, thick, tall, (-board / 2, thick / 2, 0), cloth),
        box(
            deep - INSET,
            thick - 2 * board,
            tall - 2 * INSET,
            (-deep / 2 - INSET / 2, thick / 2, INSET),
            paper_edge(),
        ),
    ]
    mark = plain(band, 0.04)
    heights = (((0.8, 0.02),), ((0.55, 0.28),), ())[style]
    for low, high in heights:
        meshes.append(box(0.0012, thick * 0.84, tall * high, (0.0002, thick / 2, tall * low), mark))
    return meshes


def book_row(
    colours: str,
    length: float = 0.3,
    height: float = 0.22,
    lean: bool = False,
    seed: int = 1,
) -> Model:
    """Books side by side, spines to the front; ``lean``: the last one leans on the others."""
    rng = np.random.default_rng(seed)
    palette = PALETTES[colours]
    meshes: list[Mesh] = []
    y, front, tops = 0.0, 0.0, []
    end = length - (0.055 if lean else 0.0)
    while y < end - 0.012:
        thick = float(min(rng.uniform(0.02, 0.045), end - y))
        if end - y - thick < 0.012:
            thick = end - y
        tall = height * float(rng.uniform(0.82, 1.0))
        deep = tall * float(rng.uniform(0.62, 0.7))
        cover, band = pick(rng, palette), pick(rng, BANDS)
        back = float(rng.uniform(0.0, 0.008))
        for mesh in _upright(deep, thick, tall, cover, band, int(rng.integers(3))):
            meshes.append(mesh.keep_pattern().move(front - back, y, 0))
        y += thick + 0.0005
        tops.append((deep, tall))
    if lean:
        tall, thick = height * 0.92, 0.022
        turn = math.asin(0.032 / tall)
        for mesh in _upright(tall * 0.66, thick, tall, pick(rng, palette), pick(rng, BANDS), 0):
            # Its foot stands off; its upper edge rests on the last book.
            meshes.append(mesh.keep_pattern().turn(rx=turn).move(0, y + 0.033, 0))
    deep = float(np.mean([d for d, _ in tops]))
    tall = float(min(t for _, t in tops))
    pieces = [box_piece((-deep / 2, y / 2, tall / 2), (deep, y, tall))]
    if lean:
        pieces.append(box_piece((-deep / 2, y + 0.027, 0.02), (deep, 0.05, 0.04)))
    body = Part(meshes, collision=pieces)
    mass = round(450 * length * deep * height, 2)
    return Model("row of books", {"body": body}, mass=mass, prune=False)


def book_stack(colours: str, wide: float, high: float, seed: int = 1) -> Model:
    """Books that lie on each other, the larger below, spines to the front."""
    rng, palette = np.random.default_rng(seed), PALETTES[colours]
    meshes: list[Mesh] = []
    z, most = 0.0, wide
    while z < high - 0.012:
        thick = min(float(rng.uniform(0.02, 0.04)), high - z)
        tall = most * float(rng.uniform(0.9, 1.0))
        most = tall
        askew, aside = rng.normal(0.0, 0.03), rng.uniform(-0.5, 0.5) * (wide - tall)
        book = _upright(
            tall * 0.68, thick, tall, pick(rng, palette), pick(rng, BANDS), int(rng.integers(3))
        )
        for mesh in book:
            # Turned about the spine: its height lies along y.
            mesh = mesh.keep_pattern().move(0, 0, -tall / 2).turn(rx=math.pi / 2)
            meshes.append(mesh.turn(rz=askew).move(-0.006, aside, z + thick))
        z += thick + 0.0004
    low = min(float(mesh.v[:, 2].min()) for mesh in meshes)
    for mesh in meshes:
        mesh.move(0, 0, -low)
    deep = wide * 0.66
    body = Part(meshes, collision=[box_piece((-deep / 2, 0, z / 2), (deep, wide * 0.9, z))])
    mass = round(450 * wide * deep * high, 2)
    return Model("stack of books lying", {"body": body}, mass=mass, prune=False)


def book_row_random(rng: np.random.Generator) -> dict:
    return {
        "colours": pick(rng, ("novels", "pastels", "bright", "leather", "grey")),
        "length": float(rng.uniform(0.16, 0.4)),
        "height": float(rng.uniform(0.19, 0.26)),
        "lean": bool(rng.random() < 0.4),
        "seed": int(rng.integers(1000)),
    }


def book_stack_random(rng: np.random.Generator) -> dict:
    return {
        "colours": pick(rng, tuple(PALETTES)),
        "wide": float(rng.uniform(0.21, 0.3)),
        "high": float(rng.uniform(0.07, 0.18)),
        "seed": int(rng.integers(1000)),
    }


def with_books(model: Model, boards: Mapping[str, str]) -> Model:
    """A piece of furniture some of whose boards, by the name of their support, come full of books
    of a palette: spines in line before the front edge, and nothing else goes there."""
    body = model.parts["body"]
    pieces = list(body.collision)
    for seed, (name, colours) in enumerate(boards.items(), 40):
        board = next(support for support in model.supports if support.name == name)
        xs, ys = zip(*board.polygon, strict=True)
        length, headroom = max(ys) - min(ys) - 0.03, board.headroom or 0.3
        # Larger boards' books lean at the end; a hand's room stays above.
        row = book_row(colours, length, min(0.25, headroom - 0.06), length > 0.5, seed)
        meshes = row.parts["body"].meshes
        left = min(float(mesh.v[:, 1].min()) for mesh in meshes)
        x, y = max(xs) - 0.03, min(ys) + 0.012 - left
        body.meshes += [mesh.keep_pattern().move(x, y, board.z) for mesh in meshes]
        pieces += [np.add(piece, (x, y, board.z)) for piece in row.parts["body"].collision]
        model.supports.remove(board)
    body.collision = pieces
    return replace(model, mass=model.mass + 9.0 * len(boards))


def file_row(colours: str, count: int = 4, seed: int = 1) -> Model:
    """Lever-arch files side by side, their labels to the front."""
    rng = np.random.default_rng(seed)
    palette = {"black": ("#26282b",), "mixed": BRIGHT, "grey": ("#6c7178", "#a9adb2")}[colours]
    deep, tall, meshes, y = 0.28, 0.315, [], 0.0
    for _ in range(count):
        thick = float(rng.choice((0.052, 0.078)))
        cover = plain(pick(rng, palette), 0.04, 60)
        meshes.append(box(deep, thick - 0.001, tall, (-deep / 2, y + thick / 2, 0), cover, 0.002))
        label = plain("#f3f2ec", 0.03)
        meshes.append(box(0.001, thick * 0.68, 0.15, (0.0003, y + thick / 2, tall * 0.38), label))
        ring = plain("#3b3d40", 0.02)
        meshes.append(box(0.002, 0.026, 0.026, (0.0003, y + thick / 2, 0.05), ring, 0.004))
        y += thick
    pieces = [box_piece((-deep / 2, y / 2, tall / 2), (deep, y, tall))]
    body = Part(meshes, collision=pieces)
    return Model("row of files", {"body": body}, mass=round(0.9 * count, 2), prune=False)


def file_row_random(rng: np.random.Generator) -> dict:
    return {
        "colours": pick(rng, ("black", "mixed", "grey")),
        "count": int(rng.integers(2, 6)),
        "seed": int(rng.integers(1000)),
    }


MODELS = {
    "book_row": Maker(
        book_row,
        book_row_random,
        23,
        [
            {"colours": "novels", "length": 0.3, "height": 0.22, "seed": 1},
            {"colours": "novels", "length": 0.18, "height": 0.19, "lean": True, "seed": 2},
            {"colours": "pastels", "length": 0.26, "height": 0.21, "lean": True, "seed": 3},
            {"colours": "pastels", "length": 0.4, "height": 0.2, "seed": 4},
            {"colours": "bright", "length": 0.22, "height": 0.25, "lean": True, "seed": 5},
            {"colours": "bright", "length": 0.34, "height": 0.18, "seed": 6},
            {"colours": "leather", "length": 0.36, "height": 0.24, "seed": 7},
            {"colours": "leather", "length": 0.2, "height": 0.22, "seed": 8},
            {"colours": "grey", "length": 0.28, "height": 0.26, "lean": True, "seed": 9},
            {"colours": "grey", "length": 0.15, "height": 0.2, "seed": 10},
            {"colours": "novels", "length": 0.4, "height": 0.24, "lean": True, "seed": 11},
            {"colours": "bright", "length": 0.15, "height": 0.17, "seed": 12},
            {"colours": "novels", "length": 0.5, "height": 0.21, "seed": 13},
            {"colours": "pastels", "length": 0.64, "height": 0.24, "lean": True, "seed": 14},
            {"colours": "bright", "length": 0.62, "height": 0.22, "seed": 15},
            {"colours": "grey", "length": 0.52, "height": 0.19, "lean": True, "seed": 16},
            {"colours": "leather", "length": 0.62, "height": 0.25, "seed": 17},
            {"colours": "novels", "length": 0.68, "height": 0.23, "lean": True, "seed": 18},
            {"colours": "pastels", "length": 0.42, "height": 0.18, "seed": 19},
            {"colours": "bright", "length": 0.66, "height": 0.2, "lean": True, "seed": 20},
            # For boards that are short or low.
            {"colours": "leather", "length": 0.26, "height": 0.165, "seed": 21},
            {"colours": "grey", "length": 0.24, "height": 0.165, "lean": True, "seed": 22},
            {"colours": "pastels", "length": 0.28, "height": 0.165, "seed": 23},
        ],
    ),
    "book_stack": Maker(
        book_stack,
        book_stack_random,
        8,
        [
            {"colours": "bright", "wide": 0.25, "high": 0.14, "seed": 24},
            {"colours": "novels", "wide": 0.24, "high": 0.12, "seed": 25},
            {"colours": "grey", "wide": 0.27, "high": 0.1, "seed": 26},
            {"colours": "pastels", "wide": 0.26, "high": 0.09, "seed": 27},
            {"colours": "leather", "wide": 0.22, "high": 0.15, "seed": 28},
            {"colours": "novels", "wide": 0.29, "high": 0.13, "seed": 29},
            {"colours": "bright", "wide": 0.28, "high": 0.08, "seed": 30},
            {"colours": "pastels", "wide": 0.23, "high": 0.17, "seed": 31},
        ],
    ),
    "file_row": Maker(
        file_row,
        file_row_random,
        4,
        [
            {"colours": "black", "count": 4, "seed": 1},
            {"colours": "mixed", "count": 5, "seed": 2},
            {"colours": "grey", "count": 3, "seed": 3},
            {"colours": "mixed", "count": 2, "seed": 4},
        ],
    ),
}
