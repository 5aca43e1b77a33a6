"""Books and magazines lying flat."""

from __future__ import annotations

import numpy as np
from labels import covers
from toolkit.materials import Material, plain
from toolkit.materials import label as printed
from toolkit.mesh import Mesh
from toolkit.model import (
    Maker,
    Model,
    Part,
    Support,
    box_piece,
    rectangle,
)
from toolkit.sampling import pick, seed_of, uniform
from toolkit.shapes import (
    box,
    extrude,
)

from makers.projection import project_label


def paper_edge(pitch: float = 0.0011) -> Material:
    """The cut edge of a stack of pages."""
    m = Material()
    lines = m.math("SINE", m.math("MULTIPLY", m.axis(2), 6.283 / pitch))
    streaks = m.noise(1, 3, stretch=(20, 20, 900))
    base = m.mix(m.remap(lines, -1, 1, 0, 0.35), "f4edda", "cdbf9f")
    return m.colour(m.mix(m.remap(streaks, 0.4, 0.65, 0, 0.4), base, "b9aa8a"))


def book(
    title: str,
    author: str,
    cover: str,
    accent: str,
    motif: str,
    width: float,
    height: float,
    thickness: float,
    is_open: bool,
    seed: int,
) -> Model:
    """A hardback on its back cover, the title readable from the front; or lying open."""
    rng = np.random.default_rng(seed)
    if is_open:
        return _open_book(cover, width, height, rng)
    spine = thickness / width
    picture = covers.book_cover(title, author, cover, accent, motif, spine, rng)
    total = 2 + spine
    front = printed(picture)
    board = 0.004
    cloth = plain(cover, 0.04, 90)
    # seen from +X the title is upright: the cover's top points to -X, its spine lies at -Y
    top = box(
        height,
        width,
        board,
        (0, 0, thickness - board),
        cloth,
        0.0012,
        labels={"+z": (front, ((1 + spine) / total, 0, 1, 1))},
    )
    bottom = box(height, width, board, (0, 0, 0), cloth, 0.0012)
    back = box(height, board, thickness, (0, -width / 2 + board / 2, 0), cloth, 0.0012)
    back = _label_spine(back, front, (1 / total, (1 + spine) / total), height, thickness)
    pages = box(
        height - 0.008,
        width - 0.008,
        thickness - 2 * board + 0.001,
        (0, 0.001, board - 0.0005),
        paper_edge(),
    )
    whole = box_piece((0, 0, thickness / 2), (height, width, thickness))
    support = Support("top", thickness, rectangle(height - 0.02, width - 0.02))
    part = Part([top, bottom, back, pages], collision=[whole])
    words = title.replace("\n", " ").title()
    return Model(
        f"book, {words}",
        {"body": part},
        mass=round(700 * width * height * thickness, 3),
        supports=[support],
    )


def book_random(rng: np.random.Generator) -> dict:
    chosen = pick(rng, covers.BOOKS)
    return chosen | {
        "width": uniform(rng, 0.13, 0.17),
        "height": uniform(rng, 0.2, 0.24),
        "thickness": uniform(rng, 0.022, 0.045),
        "is_open": False,
        "seed": seed_of(rng),
    }


def _label_spine(
    mesh: Mesh, material: Material, span: tuple[float, float], height: float, thickness: float
) -> Mesh:
    """Show the strip `span` of the unfolded cover on the -Y face, its top towards -X."""
    project_label(mesh, material, "-y", (0, 0), (1, 1), 0.7)
    number = mesh.mats.index(material)
    for i, face in enumerate(mesh.f):
        if mesh.mi[i] == number:
            points = mesh.v[list(face)]
            u = span[0] + (span[1] - span[0]) * (points[:, 2] / thickness)
            v = 0.5 - points[:, 0] / height
            mesh.label_uv[i] = list(zip(u.tolist(), v.tolist(), strict=True))
    return mesh


def _open_book(cover: str, width: float, height: float, rng: np.random.Generator) -> Model:
    """A book lying open: two gently arched blocks of pages on the spread cover."""
    pages, edge, cloth = printed(covers.book_pages(rng)), paper_edge(0.0009), plain(cover, 0.04, 90)
    us = np.linspace(0, 1, 9)
    arch = 0.004 + 0.017 * np.sin(np.pi * np.clip(us * 0.82 + 0.12, 0, 1)) ** 0.8
    arch[0] = 0.008
    half = [(float(u * width * 0.97), float(z)) for u, z in zip(us, arch, strict=True)]
    outline = [(-y, z) for y, z in half[:0:-1]] + half
    outline = [(half[-1][0], 0.003), *outline[::-1], (-half[-1][0], 0.003)]
    block = extrude(outline, height, mat=edge, axis="x")
    project_label(block, pages, "+z", (0, 0), (2 * width * 0.97, height), 0.4)
    boards = box(height + 0.008, 2 * width + 0.008, 0.005, (0, 0, 0), cloth, 0.0015)
    part = Part(
        [boards, block.weigh(1.2)], collision=[box_piece((0, 0, 0.011), (height, 2 * width, 0.022))]
    )
    return Model("open book", {"body": part}, mass=0.4)


def magazine(
    name: str,
    sky: str,
    ground: str,
    ink: str,
    subject: str,
    thickness: float,
    curl: float,
    seed: int,
) -> Model:
    """A magazine lying flat, its free edge lifted a little."""
    rng = np.random.default_rng(seed)
    width, height = 0.205, 0.275
    cover = printed(covers.magazine_cover(name, sky, ground, ink, subject, rng))
    edge = paper_edge(0.0012)
    us = np.linspace(0, 1, 9)
    top = [
        (float(u - 0.5) * width, thickness + curl * float(max(0, u - 0.45) / 0.55) ** 2) for u in us
    ]
    bottom = [(y, max(0.0, z - thickness)) for y, z in top]
    block = extrude([*bottom, *top[::-1]], height, mat=edge, axis="x")
    project_label(block, cover, "+z", (0, 0), (width, height), 0.4)
    part = Part(
        [block],
        collision=[
            box_piece((0, 0, (thickness + 0.2 * curl) / 2), (height, width, thickness + 0.2 * curl))
        ],
    )
    return Model(f"magazine, {name.title()}", {"body": part}, mass=0.2, friction=0.5)


def magazine_random(rng: np.random.Generator) -> dict:
    return pick(rng, covers.MAGAZINES) | {
        "thickness": uniform(rng, 0.006, 0.009),
        "curl": uniform(rng, 0.003, 0.008),
        "seed": seed_of(rng),
    }


MODELS = {
    "book": Maker(
        book,
        book_random,
        5,
        [
            covers.BOOKS[0],
            covers.BOOKS[1] | {"width": 0.19, "height": 0.245, "thickness": 0.024},
            covers.BOOKS[2] | {"thickness": 0.042},
            covers.BOOKS[3] | {"is_open": True},
            covers.BOOKS[4],
        ],
    ),
    "magazine": Maker(magazine, magazine_random, 3, list(covers.MAGAZINES)),
}
