"""Shipping boxes and oblong laundry baskets (the categories: boxes_more.py)."""

from __future__ import annotations

import math

import numpy as np
from labels import prints
from toolkit.labels import canvas
from toolkit.materials import Material, plain, shade
from toolkit.materials import label as printed
from toolkit.model import (
    Container,
    Model,
    Part,
    Support,
    box_piece,
    rectangle,
)
from toolkit.sampling import noise_offset, pick, seed_of, uniform
from toolkit.shapes import (
    box,
    loft,
    rounded_rectangle,
    spline,
    tube,
)

from makers.projection import project_label


def kraft(seed: int) -> Material:
    """Brown corrugated cardboard."""
    rng = np.random.default_rng(seed)
    m = Material()
    fibres = m.noise(9, 4, offset=noise_offset(rng), stretch=(1, 1, 14))
    return m.colour(
        m.mix(
            m.remap(fibres, 0.4, 0.65, 0, 0.3),
            m.mottle("#bb8d5c", 0.05, 30, noise_offset(rng)),
            "9c7245",
        )
    )


def cardboard_box(
    length: float, width: float, height: float, is_open: bool, marking: str, seed: int
) -> Model:
    """A shipping box: flaps taped shut, or standing open and empty."""
    rng = np.random.default_rng(seed)
    card, inner, wall = kraft(seed), plain("#a87f50", 0.06, 40), 0.006
    picture = prints.carton_side(marking, rng)
    print_mat = Material()
    print_mat.colour(
        print_mat.image(picture, print_mat.mottle("#bb8d5c", 0.05, 30, noise_offset(rng)))
    )
    seam, tape = plain("#8a6238", 0.03), plain("#d9b987", 0.04, 60)
    l2, w2 = length / 2, width / 2
    if not is_open:
        body = box(length, width, height - 0.005, (0, 0, 0), card, 0.003)
        for side in ("+x", "-x"):
            project_label(
                body,
                print_mat,
                side,
                (0, height * 0.48),
                (min(width * 0.9, height * 1.15), height * 0.9),
                0.9,
            )
        flaps = [
            box(length - 0.001, w2 - 0.0015, 0.005, (0, q * w2 / 2, height - 0.005), card, 0.001)
            for q in (-1, 1)
        ]
        strip = box(length + 0.003, 0.055, 0.0016, (0, 0, height - 0.0008), tape)
        ends = [
            box(0.0016, 0.055, 0.07, (q * (l2 + 0.0007), 0, height - 0.07), tape) for q in (-1, 1)
        ]
        whole = box_piece((0, 0, height / 2), (length, width, height))
        part = Part(
            [
                body,
                *flaps,
                box(length - 0.01, 0.006, 0.003, (0, 0, height - 0.004), seam),
                strip,
                *ends,
            ],
            collision=[whole],
        )
        support = Support("top", height + 0.0008, rectangle(length - 0.02, width - 0.02))
        return Model(
            "closed cardboard box",
            {"body": part},
            mass=round(160 * length * width * height, 2),
            supports=[support],
        )
    meshes = [box(length, width, wall, (0, 0, 0), card)]
    meshes.append(box(length - 2 * wall, width - 2 * wall, 0.001, (0, 0, wall - 0.0005), inner))
    pieces = [box_piece((0, 0, wall / 2), (length, width, wall))]
    for q in (-1, 1):
        side = "+x" if q > 0 else "-x"
        panel = box(wall, width, height, (q * (l2 - wall / 2), 0, 0), card)
        project_label(
            panel,
            print_mat,
            side,
            (0, height * 0.48),
            (min(width * 0.9, height * 1.15), height * 0.9),
            0.9,
        )
        meshes += [panel, box(length, wall, height, (0, q * (w2 - wall / 2), 0), card)]
        pieces += [
            box_piece((q * (l2 - wall / 2), 0, height / 2), (wall, width, height)),
            box_piece((0, q * (w2 - wall / 2), height / 2), (length, wall, height)),
        ]
        reach = w2 * 0.92
        droop_x, droop_y = float(rng.uniform(-0.35, 0.15)), float(rng.uniform(-0.55, -0.1))
        flap = box(reach, width - 0.006, wall, (reach / 2, 0, -wall), card).turn(ry=-droop_x)
        if q < 0:
            flap.turn(rz=math.pi)
        meshes.append(flap.move(q * (l2 - 0.001), 0, height))
        flap = box(length - 0.006, reach, wall, (0, reach / 2, -wall), card).turn(rx=droop_y)
        if q < 0:
            flap.turn(rz=math.pi)
        meshes.append(flap.move(0, q * (w2 - 0.001), height))
        pieces += [np.array(m.v) for m in meshes[-2:]]
    space = Container(
        "inside", (0, 0, (height + wall) / 2), (length - 2 * wall, width - 2 * wall, height - wall)
    )
    support = Support(
        "floor",
        wall + 0.0005,
        rectangle(length - 2 * wall - 0.02, width - 2 * wall - 0.02),
        container="inside",
    )
    return Model(
        "open cardboard box",
        {"body": Part(meshes, collision=pieces)},
        mass=0.6,
        containers=[space],
        supports=[support],
    )


def cardboard_box_random(rng: np.random.Generator) -> dict:
    return {
        "length": uniform(rng, 0.28, 0.36),
        "width": uniform(rng, 0.34, 0.44),
        "height": uniform(rng, 0.24, 0.32),
        "is_open": False,
        "marking": "fragile",
        "seed": seed_of(rng),
    }


def basket_wall(style: str, colour: str):
    """The wall of a basket unrolled, and its rim's colour: slots in plastic, or wicker."""

    def tone(factor: float) -> str:
        return "#" + "".join(f"{int(255 * c):02x}" for c in shade(colour, factor))

    picture, draw = canvas(1536, 256, colour if style == "slotted" else tone(0.4))
    if style == "slotted":
        for i in range(40):
            for j in range(3):
                x, y = 38.4 * i + 10, 44 + 60 * j
                draw.rounded_rectangle((x, y, x + 18, y + 46), 9, fill=tone(0.25))
        return picture, tone(0.92)
    for i in range(32):
        for j in range(9):
            x, y = 48 * i, 4 + 28 * j
            over = (i + j) % 2 == 0
            draw.rounded_rectangle(
                (x - 10, y, x + 58, y + 22) if over else (x + 14, y - 2, x + 34, y + 26),
                9,
                fill=tone(1.12 if over else 0.75),
            )
            if over:
                draw.line((x - 4, y + 5, x + 52, y + 5), fill=tone(1.3), width=3)
    return picture, tone(0.75)


def laundry_basket(style: str, width: float, height: float, colour: str) -> Model:
    """An open basket, tapered, of slotted plastic or woven wicker."""
    depth, wall = width * 0.72, 0.008
    picture, rim_colour = basket_wall(style, colour)
    outside, inside, rim_mat = printed(picture), printed(picture), plain(rim_colour, 0.08, 90)
    levels = [(0, 0.78), (0.01, 0.8), (height * 0.5, 0.91), (height - 0.025, 1.0)]

    def ring(z: float, f: float, inset: float) -> np.ndarray:
        outline = rounded_rectangle(depth * f - 2 * inset, width * f - 2 * inset, 0.07 * f, 4)
        return np.c_[outline, np.full(len(outline), z)]

    shell = (
        [ring(z, f, 0) for z, f in levels]
        + [ring(height - 0.025, 1.0, wall)]
        + [ring(max(z, 0.012), f, wall) for z, f in levels[:0:-1][1:]]
    )
    body = loft(shell, mats=[outside, inside], mat_of_face=lambda k, i: 0 if k < 3 else 1).weigh(
        1.2
    )
    # the drawing is wrapped around by arc length and covers one height, inside and outside alike
    loop = np.r_[shell[0], shell[0][:1]]
    along = np.r_[0, np.cumsum(np.linalg.norm(np.diff(loop, axis=0), axis=1))]
    girth, n = along[-1], len(shell[0])
    along /= girth
    for i, face in enumerate(body.f):
        if len(face) == 4:
            first = i % n
            us = (along[first], along[first + 1], along[first + 1], along[first])
            body.label_uv[i] = [
                (float(u), float(body.v[j][2]) / height) for u, j in zip(us, face, strict=True)
            ]
            body.bake_uv[i] = [
                (float(u) * girth, v) for u, (_, v) in zip(us, body.bake_uv[i], strict=True)
            ]
    rim_rings = [
        ring(height - 0.03, 1.0, -0.004),
        ring(height - 0.03, 1.0, -0.012),
        ring(height, 1.0, -0.013),
        ring(height, 1.0, wall + 0.002),
        ring(height - 0.03, 1.0, wall + 0.001),
    ]
    rim = loft([*rim_rings, rim_rings[0]], mat=rim_mat, caps=(False, False))
    meshes = [body, rim.outward()]
    for q in (-1, 1):
        grip = [
            (-0.06, q * (width / 2 + 0.008), height - 0.018),
            (-0.045, q * (width / 2 + 0.04), height - 0.012),
            (0.045, q * (width / 2 + 0.04), height - 0.012),
            (0.06, q * (width / 2 + 0.008), height - 0.018),
        ]
        meshes.append(tube(spline(grip, 2), 0.009, 6, mat=rim_mat, up=(0, 0, 1)))
    low, high = levels[0][1], 1.0
    pieces = [box_piece((0, 0, 0.006), (depth * low, width * low, 0.012))]
    for q in (-1, 1):
        pieces.append(
            np.array(
                [
                    (q * x * depth / 2 - q * d, y * width / 2 * x, z)
                    for x, z in ((low, 0), (high, height))
                    for d in (0, wall)
                    for y in (-1, 1)
                ]
            )
        )
        pieces.append(
            np.array(
                [
                    (y * depth / 2 * x, q * x * width / 2 - q * d, z)
                    for x, z in ((low, 0), (high, height))
                    for d in (0, wall)
                    for y in (-1, 1)
                ]
            )
        )
    space = Container(
        "inside",
        (0, 0, height / 2 + 0.006),
        (depth * low - 0.02, width * low - 0.02, height - 0.012),
    )
    support = Support(
        "floor", 0.012, rectangle(depth * low - 0.04, width * low - 0.04), container="inside"
    )
    title = "plastic laundry basket" if style == "slotted" else "wicker laundry basket"
    return Model(
        title,
        {"body": Part(meshes, collision=pieces)},
        mass=1.1,
        containers=[space],
        supports=[support],
    )


def laundry_basket_random(rng: np.random.Generator) -> dict:
    return {
        "style": "slotted",
        "width": uniform(rng, 0.5, 0.58),
        "height": uniform(rng, 0.26, 0.32),
        "colour": pick(rng, ["#f2f2ef", "#7fb4d0", "#b8a0c8"]),
    }
