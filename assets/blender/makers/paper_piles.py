"""Piles of newspapers, letters and loose sheets."""

from __future__ import annotations

import numpy as np
from PIL import Image
from toolkit import labels
from toolkit.materials import label, plain
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part, Support, rectangle
from toolkit.shapes import box, tube

from makers.books import paper_edge


def front_page(name: str, sky: str, seed: int) -> Image.Image:
    """Half of a newspaper's front page: its name, a headline, a photograph, columns."""
    w, h = 256, 200
    rng = np.random.default_rng(seed)
    image, draw = labels.canvas(w, h, "#e9e6dc")
    labels.text(draw, name, (10, 6, w - 10, 44), "serif", "#161616")
    draw.rectangle((8, 48, w - 8, 50), fill="#333333")
    labels.text(draw, "TOWN WINS AT LAST", (10, 54, w - 10, 80), "bold", "#1c1c1c")
    draw.rectangle((88, 88, 176, 152), fill=sky)
    draw.polygon([(88, 152), (112, 116), (132, 136), (150, 108), (176, 152)], fill="#4a5a4e")
    for x, y0 in ((8, 88), (184, 88)):
        labels.small_print(draw, (x, y0, x + 70, h - 8), 13, "#6a6a66", rng)
    labels.small_print(draw, (88, 160, 176, h - 8), 4, "#6a6a66", rng)
    return image.convert("RGB")


def envelope(paper: str, stamp: str, window: bool) -> Image.Image:
    """The front of a letter."""
    w, h = 256, 128
    image, draw = labels.canvas(w, h, paper)
    draw.rectangle((1, 1, w - 2, h - 2), outline="#a8a294", width=2)
    if window:
        draw.rounded_rectangle((26, 58, 136, 104), 6, fill="#f8fafc", outline="#9aa4ac", width=3)
    labels.small_print(draw, (36, 66, 124, 98), 3, "#444444")
    labels.small_print(draw, (14, 12, 80, 34), 3, "#5a6a8a")
    draw.rectangle((204, 12, 242, 52), fill=stamp, outline="#ffffff", width=3)
    for k in range(3):
        draw.arc((150, 8 + 9 * k, 214, 28 + 9 * k), 20, 160, fill="#3a3a3a", width=2)
    return image.convert("RGB")


def printed_sheet(seed: int) -> Image.Image:
    """A typed letter with its head and a table."""
    w, h = 256, 180
    rng = np.random.default_rng(seed)
    image, draw = labels.canvas(w, h, "#fbfaf6")
    draw.rectangle((14, 14, 74, 30), fill="#2f5f9a")
    labels.text(draw, "INVOICE", (150, 12, 240, 34), "bold", "#222222")
    labels.small_print(draw, (14, 44, 240, 100), 7, "#777777", rng)
    for k in range(4):
        y = 112 + 14 * k
        draw.rectangle((14, y, 240, y + 10), fill="#d6e2ee" if k % 2 else "#eef2f6")
    labels.small_print(draw, (20, 114, 200, 166), 4, "#555555", rng)
    return image.convert("RGB")


def pile(
    slabs: list[tuple[float, float, float]], turn: float, shift: float, seed: int,
    paint, top_weight: float = 3.0,
) -> tuple[list[Mesh], list[np.ndarray], float]:  # fmt: skip
    """Slabs (depth, width, height) on each other, each a little turned and shifted.

    paint(k): (side, top) materials of the k-th. Their meshes, collision pieces and the height.
    """
    rng = np.random.default_rng(seed)
    meshes, pieces, z = [], [], 0.0
    for k, (sx, sy, sz) in enumerate(slabs):
        side, top = paint(k)
        last = k == len(slabs) - 1
        angle = 0.0 if last else float(rng.normal(0, turn))
        dx, dy = (0.0, 0.0) if last else rng.normal(0, shift, 2)
        mesh = box(sx, sy, sz, (0, 0, 0), side, 0.0, labels={"+z": top})
        mesh.weigh(top_weight if last else 0.7)
        meshes.append(mesh.keep_pattern().turn(rz=angle).move(dx, dy, z))
        # drawn a little low, they sink into each other instead of leaving slits of light
        pieces.append(meshes[-1].v.copy())
        z += sz - 0.0004
    return meshes, pieces, z + 0.0004


def paper_stack(form: str, size: tuple[float, float], count: int, seed: int, **art) -> Model:
    """A pile: "newspapers" (folded), "tied" with string, "letters" or loose "sheets"."""
    rng = np.random.default_rng(seed)
    sx, sy = size
    if form in ("newspapers", "tied"):
        edge = paper_edge(0.0016)
        faces = [label(front_page(art["name"], art["sky"], seed)), edge]
        slabs = [(sx, sy, float(rng.uniform(0.009, 0.014))) for _ in range(count)]
        spread = (0.045, 0.007) if form == "newspapers" else (0.02, 0.004)
        last = count - 1
        meshes, pieces, z = pile(
            slabs, *spread, seed, lambda k: (edge, faces[0 if k == last else 1])
        )
        title, mass = "pile of newspapers", 60.0 * sx * sy * z * 10
        if form == "tied":
            cord = plain("#b98a4a", 0.2, 300)
            for along in (0, 1):
                half = (sx if along == 0 else sy) / 2 + 0.006
                line = [(-half, 0.002), (half, 0.002), (half, z + 0.003), (-half, z + 0.003)]
                path = [(a, 0, h) if along == 0 else (0, a, h) for a, h in line]
                up = (0, 1.0, 0) if along == 0 else (1.0, 0, 0)
                meshes.append(tube(path, 0.003, 4, closed=True, mat=cord, up=up, weight=0.5))
            for s in (-1, 1):
                bow = [(0, 0, z + 0.004), (s * 0.022, 0.02, z + 0.01), (s * 0.04, 0.004, z + 0.006)]
                meshes.append(tube(bow, 0.003, 4, mat=cord, weight=0.5))
            title = "bundle of newspapers"
    elif form == "letters":
        kinds = [("#f6f3ea", "#c8323a", True), ("#d9b988", "#2f6fb0", False)]
        kinds += [("#e6eef6", "#3a8a4a", False)]
        paints = [
            (plain(paper, 0.05, 200), label(envelope(paper, stamp, window)))
            for paper, stamp, window in kinds
        ]
        slabs = [
            (sx * float(rng.uniform(0.9, 1.05)), sy * float(rng.uniform(0.92, 1.04)),
             float(rng.uniform(0.003, 0.006)))
            for _ in range(count)
        ]  # fmt: skip
        slabs[-1] = (sx, sy, 0.004)
        last = count - 1
        meshes, pieces, z = pile(slabs, 0.16, 0.009, seed, lambda k: paints[(last - k) % 3], 2.0)
        title, mass = "pile of letters", 0.02 * count
    else:
        edge, white = paper_edge(0.0013), plain("#f4f2ea", 0.03, 120)
        face = label(printed_sheet(seed))
        slabs = [(sx, sy, float(rng.uniform(0.003, 0.009))) for _ in range(count)]
        last = count - 1
        meshes, pieces, z = pile(
            slabs, 0.1, 0.012, seed, lambda k: (edge, face if k == last else white)
        )
        title, mass = "stack of papers", 700 * sx * sy * z
    top = rectangle(0.8 * sx, 0.8 * sy)
    return Model(
        title,
        {"body": Part(meshes, collision=pieces)},
        mass=round(min(mass, 9.0), 2),
        friction=0.6,
        # Nothing stands on a knot.
        supports=[] if form == "tied" else [Support("top", z, top)],
        texture_size=128,
        prune=False,
    )


def paper_stack_random(rng: np.random.Generator) -> dict:
    return {}


MODELS = {
    "paper_stack": Maker(
        paper_stack,
        paper_stack_random,
        4,
        [
            {"form": "newspapers", "size": (0.29, 0.38), "count": 6, "seed": 4}
            | {"name": "DAILY POST", "sky": "#8fb4d8"},
            {"form": "letters", "size": (0.115, 0.23), "count": 9, "seed": 8},
            {"form": "sheets", "size": (0.297, 0.21), "count": 8, "seed": 3},
            {"form": "tied", "size": (0.27, 0.36), "count": 9, "seed": 6}
            | {"name": "THE HERALD", "sky": "#c8b08a"},
        ],
    )
}
