"""Books and magazines lying flat."""

from __future__ import annotations

import math

import numpy as np
from labels import covers
from PIL import Image
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
from toolkit.sampling import pick
from toolkit.shapes import (
    box,
    extrude,
    lathe,
)

from makers.projection import project_label
from makers.solids import flattened, solids


def paper_edge(pitch: float = 0.0011) -> Material:
    """The cut edge of a stack of pages."""
    m = Material()
    lines = m.math("SINE", m.math("MULTIPLY", m.axis(2), 6.283 / pitch))
    streaks = m.noise(1, 3, stretch=(20, 20, 900))
    base = m.mix(m.remap(lines, -1, 1, 0, 0.35), "f4edda", "cdbf9f")
    return m.colour(m.mix(m.remap(streaks, 0.4, 0.65, 0, 0.4), base, "b9aa8a"))


def _closed(
    title: str,
    author: str,
    cover: str,
    accent: str,
    motif: str,
    width: float,
    height: float,
    thickness: float,
    seed: int,
) -> Model:
    """A hardback on its back cover, the title readable from the front."""
    rng = np.random.default_rng(seed)
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
        prune=False,
    )


def book(
    kind: str,
    title: str,
    author: str,
    cover: str,
    accent: str,
    motif: str,
    width: float,
    height: float,
    thickness: float,
) -> Model:
    """A book 'closed' on its back, 'open', 'down' (open, pages on the table), a 'stack' of three
    or a 'row' standing between book ends."""
    seed = 5
    if kind == "open":
        return _open_book(cover, width, height, np.random.default_rng(seed))
    if kind in ("closed", "down"):
        one = _closed(title, author, cover, accent, motif, width, height, thickness, seed)
        if kind == "closed":
            return one
        return _face_down(title, author, cover, accent, motif, width, height)
    meshes: list[Mesh] = []
    pieces: list[np.ndarray] = []
    total = 0.0
    if kind == "stack":
        z = 0.0
        for k, thick in enumerate((0.042, 0.024, 0.033)):
            shrink = 1 - 0.08 * k
            chosen = covers.BOOKS[(k + 2) % 5]
            one = _closed(
                **chosen, width=width * shrink, height=height * shrink, thickness=thick, seed=seed
            )
            turn = (0.0, 0.3, -0.16)[k]
            for mesh in one.parts["body"].meshes:
                meshes.append(mesh.keep_pattern().turn(rz=turn).move(z=z))
            pieces += solids(one.parts["body"].meshes)
            z, total = z + thick, total + one.mass
    else:
        y = -0.07
        for k, thick in enumerate((0.032, 0.046, 0.024, 0.038)):
            chosen = covers.BOOKS[k % 5]
            tall, deep = height * (1, 0.9, 0.97, 0.86)[k], width * (1, 0.92)[k % 2]
            one = _closed(**chosen, width=deep, height=tall, thickness=thick, seed=seed)
            # stand it up: the spine, at -Y, to the front; its top, at -X, upwards
            for mesh in one.parts["body"].meshes:
                mesh.keep_pattern().turn(ry=math.pi / 2).turn(rz=math.pi / 2)
                mesh.move(-deep / 2, y, tall / 2)
                meshes.append(mesh)
            y, total = y + thick, total + one.mass
        ends = plain("#8a9098", 0.05)
        low, high = min(m.v[:, 1].min() for m in meshes), max(m.v[:, 1].max() for m in meshes)
        deep = float(np.mean([m.v[:, 0].mean() for m in meshes]))
        row = list(meshes)
        for at, way in ((low, -1), (high, 1)):
            meshes.append(box(0.12, 0.006, 0.15, (deep, at + way * 0.003, 0), ends, 0.001))
            meshes.append(box(0.12, 0.07, 0.006, (deep, at + way * 0.035, 0), ends, 0.001))
        pieces = solids(row, *([m] for m in meshes[-4:]))
    name = "stack of books" if kind == "stack" else "row of books"
    body = Part(meshes, collision=pieces)
    return Model(name, {"body": body}, mass=round(total, 2), prune=False)


def _face_down(
    title: str, author: str, cover: str, accent: str, motif: str, width: float, height: float
) -> Model:
    """A book laid down open, its cover up like a low roof."""
    picture = covers.book_cover(title, author, cover, accent, motif, 0.16, np.random.default_rng(5))
    skin, edge, spine = printed(picture), paper_edge(0.0009), 0.16 * width
    us = np.array([-1, -0.75, -0.45, -0.15, -0.001, 0.001, 0.15, 0.45, 0.75, 1])
    half = width + spine / 2

    def line(lift: float, share: float) -> list[tuple[float, float]]:
        return [(share * u * half, lift + 0.05 * (1 - abs(u)) ** 0.7 * share) for u in us]

    cloth = plain(cover, 0.04, 90)
    roof = extrude([*line(0.006, 1.0), *line(0.0, 1.0)[::-1]], height, mat=cloth, axis="x")
    project_label(roof, skin, "+z", (0, 0), (2 * half, height), 0.3)
    block = extrude(
        [*line(-0.001, 0.96), (0.9 * half, 0), (0, 0.018), (-0.9 * half, 0)][::-1],
        height - 0.01,
        mat=edge,
        axis="x",
    )
    body = Part([roof, block], collision=solids([roof]))
    return Model("book, lying face down", {"body": body}, mass=0.4)


def book_random(rng: np.random.Generator) -> dict:
    chosen = pick(rng, covers.BOOKS)
    return chosen | {"kind": "closed", "width": 0.15, "height": 0.22, "thickness": 0.032}


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
    return Model("open book", {"body": part}, mass=0.4, prune=False)


def _flat_magazine(
    name: str,
    sky: str,
    ground: str,
    ink: str,
    subject: str,
    thickness: float,
    curl: float,
) -> Model:
    """A magazine lying flat, its free edge lifted a little."""
    rng = np.random.default_rng(5)
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


def _shut(chosen: dict, curl: float) -> list[Mesh]:
    return _flat_magazine(**chosen, thickness=0.007, curl=curl).parts["body"].meshes


def magazine(
    kind: str, name: str, sky: str, ground: str, ink: str, subject: str, curl: float
) -> Model:
    """A magazine: 'flat', 'rolled' up, lying 'open', or a 'fan' of three."""
    chosen = {"name": name, "sky": sky, "ground": ground, "ink": ink, "subject": subject}
    if kind == "flat":
        return _flat_magazine(**chosen, thickness=0.007, curl=curl)
    if kind == "fan":
        meshes, pieces = [], []
        for k in range(3):
            (mesh,) = _shut(covers.MAGAZINES[(k + 1) % 3], 0.001)
            mesh.keep_pattern().turn(rz=0.5 - 0.42 * k).move(0.012 * k, 0.03 * k, 0.0085 * k)
            meshes.append(mesh)
        pieces = solids(*([m] for m in meshes))
        return Model("magazines", {"body": Part(meshes, collision=pieces)}, mass=0.6, friction=0.5)
    cover = printed(covers.magazine_cover(**chosen, rng=np.random.default_rng(5)))
    if kind == "rolled":
        r, n = 0.032, 20
        roll = lathe(
            [(0, 0), (r, 0), (r, 0.275), (0, 0.275)],
            n,
            mats=[paper_edge(), cover],
            mat_of_segment=[0, 1, 0],
            start=-2.0,
            rib=lambda k, i: 1 - 0.1 * i / n,  # a spiral: its step is the free edge
        )
        roll.turn(ry=math.pi / 2).move(-0.1375, 0, r)
        holes = [
            lathe([(0.014, 0), (0, 0.001)], 12, mat=plain("#6a6458", 0.1))
            .turn(ry=q * math.pi / 2)
            .move(q * 0.1376, 0, r)
            for q in (-1, 1)
        ]
        meshes = flattened([roll, *holes], 0.004)
        return Model("rolled magazine", {"body": Part(meshes, collision=solids([roll]))}, 0.2)
    w, h = 0.205, 0.275
    us = np.linspace(0, 1, 7)
    half = [(float(u * w), 0.004 + 0.014 * math.sin(math.pi * min(1, u * 0.9 + 0.1))) for u in us]
    outline = [(-y, z) for y, z in half[:0:-1]] + half
    block = extrude([*outline, (w, 0.0), (-w, 0.0)][::-1], h, mat=paper_edge(), axis="x")
    spread = Image.new("RGB", (512, 340), "#ffffff")
    spread.paste(
        covers.magazine_cover(**chosen, rng=np.random.default_rng(9)).convert("RGB"), (256, 0)
    )
    spread.paste(covers.book_pages(np.random.default_rng(3)).crop((0, 0, 256, 340)), (0, 0))
    project_label(block, printed(spread), "+z", (0, 0), (2 * w, h), 0.3)
    return Model("open magazine", {"body": Part([block], collision=solids([block]))}, mass=0.2)


def magazine_random(rng: np.random.Generator) -> dict:
    return pick(rng, covers.MAGAZINES) | {
        "kind": "flat",
        "curl": 0.006,
    }


MODELS = {
    "book": Maker(
        book,
        book_random,
        8,
        [
            covers.BOOKS[0],
            covers.BOOKS[1] | {"width": 0.19, "height": 0.245, "thickness": 0.024},
            covers.BOOKS[2] | {"kind": "stack", "width": 0.17, "height": 0.24},
            covers.BOOKS[3] | {"kind": "open"},
            covers.BOOKS[4] | {"kind": "row", "width": 0.14, "height": 0.21},
            covers.BOOKS[3] | {"width": 0.14, "height": 0.2, "thickness": 0.075},
            covers.BOOKS[4] | {"kind": "down"},
            covers.BOOKS[2],
        ],
    ),
    "magazine": Maker(
        magazine,
        magazine_random,
        6,
        [
            *covers.MAGAZINES,
            covers.MAGAZINES[0] | {"kind": "rolled"},
            covers.MAGAZINES[1] | {"kind": "fan"},
            covers.MAGAZINES[2] | {"kind": "open"},
        ],
    ),
}
