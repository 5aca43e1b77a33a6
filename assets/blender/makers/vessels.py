"""Packages of cleaners from tables of sizes: bottles with many heads, cans, cartons, pouches."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from PIL import Image
from toolkit.materials import Material, metal, plain, shade
from toolkit.materials import label as printed
from toolkit.mesh import Mesh, cube_project
from toolkit.model import Model, Part, box_piece, cylinder_piece
from toolkit.shapes import box, extrude, lathe, loft, spline, superellipse, tube

from makers.bottle_shapes import cap, oval_body
from makers.convex import few_corners
from makers.projection import project_label

Loop = tuple[float, tuple[tuple[float, float], ...]]  # radius, (y, z) of its middle line


def steps(table: str) -> tuple[tuple[float, ...], ...]:
    """The steps of a bottle from text: "height width depth, height width depth, ..."."""
    return tuple(tuple(float(x) for x in row.split()) for row in table.split(","))


@dataclass(frozen=True)
class Bottle:
    """Sizes of a bottle, metres; wide along y, label on +x and -x.

    steps  (height, share of width, share of depth) of its body from the bottom up
    label  middle height, width and height of the printed front
    top    kind of head, its radius, foot and height
    """

    width: float
    depth: float
    steps: tuple[tuple[float, float, float], ...]
    label: tuple[float, float, float]
    top: tuple[str, float, float, float]
    power: float = 3.0
    n: int = 18
    loops: tuple[Loop, ...] = ()
    shift: float = 0.0  # of neck and head along y


def trigger_head(neck: float, head: str, trigger: str, collar: float = 0.0175) -> list[Mesh]:
    """A trigger spray head on a neck that ends at a height; its nozzle points along -y."""
    white, red = plain(head, 0.02), plain(trigger, 0.02)
    ring = lathe(
        [
            (0, neck - 0.012),
            (collar, neck - 0.012),
            (collar - 0.001, neck + 0.014),
            (0.0, neck + 0.016),
        ],
        14,
        mat=white,
        rib=lambda k, i: 1 - 0.07 * (i % 2) if k == 1 else 1,
    )
    outline = [(-0.016, 0.012), (0.012, 0.012), (0.02, 0.034), (0.052, 0.036), (0.052, 0.056)]
    outline += [(0.044, 0.061), (0, 0.063), (-0.03, 0.058), (-0.042, 0.048), (-0.036, 0.038)]
    outline.append((-0.02, 0.03))
    hood = extrude(outline, 0.026, mat=white, axis="y", bevel_width=0.004).move(z=neck)
    nozzle = box(0.013, 0.019, 0.019, (0.057, 0, neck + 0.0385), red, bevel_width=0.002)
    lever_line = [(0.022, 0.036), (0.036, 0.036), (0.041, 0.024), (0.038, 0.01), (0.044, -0.006)]
    lever_line += [(0.056, -0.02), (0.05, -0.025), (0.038, -0.012), (0.03, 0.004)]
    lever = extrude(lever_line, 0.014, mat=red, axis="y", bevel_width=0.002).move(z=neck)
    for mesh in (hood, nozzle, lever):
        mesh.turn(rz=-math.pi / 2)
    return [ring, hood, nozzle, lever]


def pump_head(z: float, radius: float, colour: str) -> list[Mesh]:
    """A lotion pump: collar, stem and a spout along -y."""
    mat = plain(colour, 0.02)
    profile = [(0, z), (radius, z), (radius * 0.95, z + 0.018), (0.005, z + 0.02)]
    profile += [(0.005, z + 0.038), (0.0125, z + 0.04), (0.0125, z + 0.05), (0, z + 0.053)]
    spout = [(0, 0, z + 0.045), (0, -0.03, z + 0.046), (0, -0.045, z + 0.036)]
    return [
        lathe(profile, 14, mat=mat),
        tube(spline(spout, 2), 0.0055, 7, mat=mat, up=(1, 0, 0)),
    ]


def head_of(shape: Bottle, lid: str, accent: str, plastic: Material) -> list[Mesh]:
    """The head a bottle's table asks for."""
    kind, r, z, h = shape.top
    paint = plain(lid, 0.02)
    if kind == "trigger":
        return trigger_head(z, lid, accent, r)
    if kind == "pump":
        return pump_head(z, r, lid)
    if kind == "pull":  # push-pull cap of washing-up liquid
        profile = [(0, z), (r, z), (r * 0.97, z + 0.35 * h), (r * 0.56, z + 0.42 * h)]
        profile += [(r * 0.53, z + 0.74 * h), (r * 0.7, z + 0.78 * h), (r * 0.66, z + 0.96 * h)]
        return [lathe([*profile, (0, z + h)], 14, mat=paint)]
    if kind == "smooth":
        profile = [(0, z), (r, z), (r * 0.97, z + 0.85 * h), (r * 0.86, z + h), (0, z + h)]
        return [lathe(profile, 18, mat=paint)]
    if kind == "nozzle":  # a tapered spout with a little cap
        profile = [(0, z), (r, z), (r, z + 0.25 * h), (r * 0.55, z + 0.32 * h)]
        profile += [(r * 0.32, z + 0.75 * h), (0, z + 0.76 * h)]
        tip = [(0, z + 0.7 * h), (r * 0.5, z + 0.7 * h), (r * 0.42, z + h), (0, z + h)]
        return [lathe(profile, 14, mat=paint), lathe(tip, 12, mat=plain(accent, 0.02))]
    if kind == "duck":  # a neck bent over along +y
        bend = [(0, 0, z), (0, 0.002, z + 0.3 * h), (0, 0.45 * h, z + 0.68 * h)]
        bend.append((0, 0.95 * h, z + 0.62 * h))
        path = spline(bend, 3)
        neck = tube(path, np.linspace(r, 0.8 * r, len(path)), 10, mat=plastic, up=(1, 0, 0))
        top = cap(r * 1.08, 0, 0.034, paint, 14, 0.8).turn(rx=-1.75)
        return [neck, top.move(0, 0.9 * h, z + 0.63 * h)]
    return [cap(r, z, h, paint, 16, 0.92)]


def body_pieces(shape: Bottle) -> list[np.ndarray]:
    """Two convex pieces: up to the shoulder, and from there to the head."""
    levels = [s for s in shape.steps if s[1] >= 0.8]
    shoulder = levels[-1]

    def ring(z: float, w: float, d: float) -> np.ndarray:
        return superellipse(shape.depth / 2 * d, shape.width / 2 * w, shape.power, 12, z)

    pieces = [np.concatenate([ring(0.0, 0.96, 0.96), ring(shoulder[0], 0.98, 0.98)])]
    end = shape.steps[-1]
    if end[0] - shoulder[0] > 0.004:
        neck = ring(*end) + np.array([0, shape.shift, 0])
        pieces.append(np.concatenate([ring(*shoulder), neck]))
    return pieces


def bottle(
    title: str,
    shape: Bottle,
    picture: Image.Image,
    body: str,
    lid: str,
    accent: str,
    mass: float,
) -> Model:
    """A plastic bottle with its printed front on both broad sides."""
    plastic = plain(body, 0.03)
    shell = oval_body(
        list(shape.steps), shape.width, shape.depth, plastic, shape.power, shape.n
    ).weigh(1.5)
    if shape.power >= 4:  # flat sides: a strip all round would squeeze the print in its middle
        cube_project(shell)
    if shape.shift:
        low, high = max(s[0] for s in shape.steps if s[1] >= 0.8), shape.steps[-1][0]

        def lean(x: float, y: float, z: float) -> tuple[float, float, float]:
            return x, y + shape.shift * min(max((z - low) / (high - low), 0), 1), z

        shell.warp(lean)
    middle, wide, tall = shape.label
    front = printed(picture, base=body)
    for side in ("+x", "-x"):
        project_label(
            shell,
            front,
            side,
            (0, middle),
            (wide, tall),
            0.25,
            lambda c: abs(c[2] - middle) < tall / 2 and abs(c[1]) < wide / 2,
        )
    head = head_of(shape, lid, accent, plastic)
    for mesh in head:
        mesh.move(y=shape.shift)
    grips = [
        tube(spline([(0, y, z) for y, z in line], 3), radius, 8, mat=plastic, up=(1, 0, 0))
        for radius, line in shape.loops
    ]
    pieces = body_pieces(shape)
    pieces.append(few_corners(np.concatenate([m.v for m in head])))
    pieces += [few_corners(m.v) for m in grips]
    part = Part([shell, *head, *grips], collision=pieces)
    return Model(title, {"body": part}, mass=mass, friction=0.5)


def wrapped(front: Image.Image, paper: str, times: int = 3) -> Image.Image:
    """A front printed several times round a can, one of them facing +X."""
    w, h = front.size
    around = Image.new("RGBA", (w * times, h), paper)
    shift = 0 if times % 2 else -w // 2
    for k in range(times + 1):
        around.paste(front, (w * k + shift, 0), front)
    return around.convert("RGB")


def can(
    title: str,
    radius: float,
    height: float,
    front: Image.Image,
    paper: str,
    lid: str,
    top: str,
    mass: float,
    times: int = 3,
) -> Model:
    """A round can with a printed wall.

    top: "overcap" (aerosol with its cap on), "button" (aerosol, spray head showing, domed),
    "lid" (a canister's flat push-on lid), "screw" (a tub's screw lid)
    """
    r, h = radius, height
    steel, paint = metal("c9cdd1", "8b9096"), plain(lid, 0.03)
    wall_top = {"overcap": 0.76, "button": 0.8, "lid": 0.93, "screw": 0.8}[top] * h
    profile = [(0, 0.002), (r * 0.9, 0.002), (r * 0.96, 0), (r, 0.003), (r, 0.006)]
    profile.append((r, wall_top))
    segments = [0, 0, 0, 0, 1]
    if top == "overcap":
        profile += [(r * 0.97, wall_top + 0.004), (r * 0.93, wall_top + 0.006)]
        profile += [(r * 0.91, h - 0.006), (r * 0.8, h), (0, h)]
        segments += [0, 0, 2, 2, 2]
    elif top == "button":
        profile += [(r * 0.98, wall_top + 0.004), (r * 0.75, wall_top + 0.018)]
        profile += [
            (r * 0.42, wall_top + 0.026),
            (r * 0.42, wall_top + 0.032),
            (0, wall_top + 0.033),
        ]
        segments += [0, 0, 0, 0, 0]
    elif top == "lid":
        profile += [(r * 1.03, wall_top), (r * 1.03, h - 0.004), (r * 0.94, h), (0, h)]
        segments += [2, 2, 2, 2]
    else:
        profile += [(r * 0.92, wall_top + 0.008), (r * 0.99, wall_top + 0.009)]
        profile += [(r * 0.97, h - 0.003), (r * 0.9, h), (0, h)]
        segments += [3, 2, 2, 2, 2]
    shell = lathe(
        profile,
        22,
        mats=[steel, printed(wrapped(front, paper, times)), paint, plain(paper, 0.03)],
        mat_of_segment=segments,
        label_z=(0.006, wall_top),
        start=-math.pi,
        weight=1.4,
        rib=lambda k, i: 1 - 0.03 * (i % 2) if top == "screw" and k in (7, 8) else 1,
    )
    meshes, pieces = [shell], [cylinder_piece(r, 0, min(h, wall_top + 0.012), 14)]
    if top == "button":
        z = wall_top + 0.032
        stem = lathe([(0, z), (0.011, z), (0.011, h - 0.006), (0.008, h), (0, h)], 12, mat=paint)
        hole = box(0.004, 0.008, 0.008, (0.0095, 0, (z + h) / 2 - 0.004), plain("#1c1c20", 0.0))
        meshes += [stem, hole]
        pieces.append(cylinder_piece(0.012, wall_top, h, 10))
    elif top != "lid":
        pieces.append(cylinder_piece(r * 0.95, wall_top, h, 12))
    return Model(title, {"body": Part(meshes, collision=pieces)}, mass=mass, friction=0.5)


def carton(
    title: str,
    size: tuple[float, float, float],
    picture: Image.Image,
    board: str,
    top: str,
    mass: float,
    inside: list[Mesh] | None = None,
    side: Image.Image | None = None,
) -> Model:
    """A cardboard box with a printed front and back.

    top: "flat", "handle" (a plastic strap), "open" (flaps up, `inside` showing)
    """
    depth, width, height = size
    plain_board, print_front = plain(board, 0.03), printed(picture, base=board)
    labels = {"+x": print_front, "-x": print_front}
    if side is not None:
        labels |= {"+y": printed(side, base=board), "-y": printed(side, base=board)}
    shell = box(depth, width, height, (0, 0, 0), plain_board, 0, 1, labels).weigh(1.3)
    meshes = [shell]
    pieces = [box_piece((0, 0, height / 2), (depth, width, height))]
    if top == "handle":
        strap = [(0, -0.32 * width, height), (0, -0.2 * width, height + 0.03)]
        strap += [(0, 0.2 * width, height + 0.03), (0, 0.32 * width, height)]
        meshes.append(tube(spline(strap, 3), 0.006, 6, mat=plain("#f2f2ee", 0.03), up=(1, 0, 0)))
        pieces.append(few_corners(meshes[-1].v))
    elif top == "flat":
        seam = plain(shade(board, 0.75), 0.03)
        meshes.append(box(0.0035, width * 0.98, 0.0008, (0, 0, height), seam))
    else:  # open: the top is dark, with what is in it, and the four flaps stand out
        dark = plain(shade(board, 0.45), 0.05)
        meshes.append(box(depth - 0.008, width - 0.008, 0.001, (0, 0, height), dark))
        inner = plain(shade("#d9cdb8", 0.98), 0.04)
        for turn, far, near in ((0, depth, width), (1, width, depth)):
            for sign in (-1, 1):
                flap = box(0.005, near * 0.97, 0.45 * depth, (0, 0, 0), inner)
                flap.turn(ry=sign * (0.75 if turn == 0 else 1.0)).move(x=sign * far / 2, z=height)
                meshes.append(flap.turn(rz=turn * math.pi / 2))
                pieces.append(few_corners(flap.v))
        meshes += [m.move(z=height) for m in inside or []]
        pieces += [few_corners(m.v) for m in inside or [] if len(m.f) > 12]
    part = Part(meshes, collision=pieces)
    return Model(title, {"body": part}, mass=mass, friction=0.5)


def pouch(
    title: str,
    width: float,
    height: float,
    thick: float,
    picture: Image.Image,
    film: str,
    mass: float,
    spout: str = "",
) -> Model:
    """A standing pouch, seam on top; `spout`: colour of a screw cap on its corner."""
    rings = []
    for share, d, w in ((0, 0.8, 0.93), (0.03, 0.95, 0.97), (0.27, 1, 1), (0.6, 0.72, 0.97)):
        rings.append(superellipse(thick / 2 * d, width / 2 * w, 4, 16, share * height))
    rings.append(superellipse(thick * 0.17, width / 2 * 0.97, 6, 16, 0.87 * height))
    for share in (0.92, 1.0):
        rings.append(superellipse(0.0035, width / 2 * 0.98, 8, 16, share * height))
    bag = loft(rings, mat=plain(film, 0.04)).weigh(1.2)
    front = printed(picture, base=film)
    for side in ("+x", "-x"):
        project_label(
            bag,
            front,
            side,
            (0, 0.445 * height),
            (width * 0.92, height * 0.85),
            0.3,
            lambda c: abs(c[2] - 0.445 * height) < 0.43 * height,
        )
    meshes, pieces = [bag], [few_corners(bag.v, 30)]
    if spout:
        y, z = 0.3 * width, 0.93 * height
        screw = cap(0.016, 0, 0.03, plain(spout, 0.02), 12).move(0, y, z)
        meshes.append(screw)
        pieces.append(few_corners(screw.v))
    return Model(title, {"body": Part(meshes, collision=pieces)}, mass=mass, friction=0.5)
