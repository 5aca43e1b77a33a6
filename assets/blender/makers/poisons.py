"""Cleaners that must be locked away: drain and toilet cleaner, detergent, tablets, pods, powder."""

from __future__ import annotations

import math

import numpy as np
from labels.hazards import cleaner_front
from toolkit.labels import canvas
from toolkit.materials import Material, plain, shade
from toolkit.materials import label as printed
from toolkit.mesh import Mesh
from toolkit.model import Model, Part, box_piece, cylinder_piece
from toolkit.sampling import pick, uniform
from toolkit.shapes import TAU, box, lathe, loft, spline, superellipse, tube

from makers.bottle_shapes import cap, oval_body
from makers.choking import loose
from makers.projection import project_label


def both_sides(
    body: Mesh, label: Material, z: float, width: float, tall: float, limit: float
) -> None:
    """A label on the front and back of an oval bottle, middle at height z."""
    for side in ("+x", "-x"):
        project_label(
            body,
            label,
            side,
            (0, z),
            (width, tall),
            0.3,
            lambda c: abs(c[2] - z) < tall / 2 and abs(c[1]) < limit,
        )


def drain_cleaner(
    height: float, body: str, paper: str, band: str, ink: str, lid: str, brand: str, kind: str
) -> Model:
    """A bottle of drain cleaner: 'gel' flat with sloping shoulders, 'granules' round."""
    s = height / 0.25
    plastic = plain(body, 0.03)
    words = ["DRAIN", "CLEANER"]
    label = printed(cleaner_front(brand, words, paper, band, ink, "pipe"), base=body)
    if kind == "gel":
        steps = [
            (0, 0.9, 0.88),
            (0.005, 1, 1),
            (0.15, 1, 1),
            (0.178, 0.86, 0.9),
            (0.2, 0.5, 0.64),
            (0.212, 0.32, 0.5),
            (0.222, 0.32, 0.5),
        ]
        width, depth = 0.094, 0.06
    else:
        steps = [
            (0, 0.95, 0.95),
            (0.004, 1, 1),
            (0.165, 1, 1),
            (0.19, 0.9, 0.9),
            (0.205, 0.62, 0.62),
            (0.222, 0.6, 0.6),
        ]
        width, depth = 0.084, 0.084
    power = 3.2 if kind == "gel" else 2.0
    bottle = oval_body([(z * s, w, d) for z, w, d in steps], width, depth, plastic, power)
    both_sides(bottle.weigh(1.2), label, 0.078 * s, width * 0.9, 0.136 * s, 0.44 * width)
    radius = 0.019 if kind == "gel" else 0.027
    lid_mesh = cap(radius, 0.215 * s, 0.035 * s, plain(lid, 0.02), 16, 0.9)
    pieces = [
        box_piece((0, 0, 0.085 * s), (depth * 0.97, width * 0.97, 0.17 * s)),
        cylinder_piece(depth / 2, 0.17 * s, 0.215 * s, 10, radius),
        cylinder_piece(radius, 0.215 * s, 0.25 * s, 10),
    ]
    part = Part([bottle, lid_mesh], collision=pieces)
    return Model(f"drain cleaner {kind}", {"body": part}, mass=0.95, friction=0.5)


def drain_cleaner_random(rng: np.random.Generator) -> dict:
    return {
        "height": uniform(rng, 0.235, 0.275),
        "brand": pick(rng, ["ROHRFIX", "DRAINEX", "PIPOX"]),
        "kind": pick(rng, ["gel", "granules"]),
    }


def toilet_cleaner(
    height: float, body: str, paper: str, band: str, ink: str, lid: str, brand: str
) -> Model:
    """A bottle whose neck bends over to reach under the rim."""
    s = height / 0.27
    plastic = plain(body, 0.03)
    words = ["TOILET", "CLEANER"]
    label = printed(cleaner_front(brand, words, paper, band, ink, "toilet"), base=body)
    steps = [
        (0, 0.9, 0.88),
        (0.005, 1, 1),
        (0.13, 1, 1),
        (0.155, 0.9, 0.92),
        (0.178, 0.6, 0.7),
        (0.192, 0.36, 0.52),
    ]
    bottle = oval_body([(z * s, w, d) for z, w, d in steps], 0.088, 0.056, plastic, 3.0)
    both_sides(bottle.weigh(1.2), label, 0.07 * s, 0.08, 0.13 * s, 0.04)
    bend = [(0, 0, 0.186 * s), (0, 0.002, 0.208 * s), (0, 0.016, 0.228 * s), (0, 0.036, 0.24 * s)]
    path = spline(bend, 3)
    neck = tube(path, np.linspace(0.0152, 0.0125, len(path)), 10, mat=plastic, up=(1, 0, 0))
    end, angle = np.array(bend[-1]), 1.05
    top = cap(0.016, 0, 0.034 * s, plain(lid, 0.02), 14, 0.8)
    top.turn(rx=-angle).move(*(end - np.array([0, math.sin(angle), math.cos(angle)]) * 0.005))
    pieces = [
        box_piece((0, 0, 0.08 * s), (0.054, 0.086, 0.16 * s)),
        cylinder_piece(0.03, 0.16 * s, 0.2 * s, 8, 0.016),
        np.concatenate([neck.v, top.v]),
    ]
    part = Part([bottle, neck, top], collision=pieces)
    return Model("toilet cleaner", {"body": part}, mass=0.8, friction=0.5)


def toilet_cleaner_random(rng: np.random.Generator) -> dict:
    return {
        "height": uniform(rng, 0.255, 0.29),
        "brand": pick(rng, ["WC-STAR", "Bowlix", "RANDO"]),
    }


def laundry_detergent(
    height: float, body: str, paper: str, band: str, ink: str, lid: str, brand: str
) -> Model:
    """A broad jug with a handle and a measuring cap."""
    s = height / 0.28
    plastic = plain(body, 0.03)
    words = ["LAUNDRY", "DETERGENT"]
    picture = cleaner_front(brand, words, paper, band, ink, "shirt", "!", (300, 340))
    label = printed(picture, base=body)
    steps = [
        (0, 0.92, 0.88),
        (0.006, 1, 1),
        (0.13, 1, 1),
        (0.17, 0.95, 0.96),
        (0.2, 0.78, 0.84),
        (0.222, 0.46, 0.6),
        (0.234, 0.34, 0.5),
        (0.242, 0.34, 0.5),
    ]
    bottle = oval_body([(z * s, w, d) for z, w, d in steps], 0.16, 0.095, plastic, 3.2)
    both_sides(bottle.weigh(1.2), label, 0.086 * s, 0.135, 0.145 * s, 0.068)
    grip = [(0.02, 0.232), (0.052, 0.236), (0.08, 0.222), (0.088, 0.19), (0.078, 0.15)]
    path = spline([(0, y, z * s) for y, z in grip], 3)
    handle = tube(path, 0.0125, 8, mat=plastic, up=(1, 0, 0))
    lid_mesh = cap(0.031, 0.232 * s, 0.048 * s, plain(lid, 0.02), 18, 0.92)
    pieces = [
        box_piece((0, 0, 0.09 * s), (0.093, 0.158, 0.18 * s)),
        cylinder_piece(0.05, 0.18 * s, 0.232 * s, 10, 0.03),
        cylinder_piece(0.03, 0.232 * s, 0.28 * s, 10),
        handle.v,
    ]
    part = Part([bottle, handle, lid_mesh], collision=pieces)
    return Model("laundry detergent", {"body": part}, mass=1.9, friction=0.5)


def laundry_detergent_random(rng: np.random.Generator) -> dict:
    return {
        "height": uniform(rng, 0.26, 0.3),
        "brand": pick(rng, ["WELLENA", "Frisko", "LINEO"]),
    }


def dishwasher_tablets(kind: str, paper: str, band: str, ink: str, brand: str) -> Model:
    """A carton, or a standing pouch, of dishwasher tablets."""
    words = ["DISHWASHER", "TABLETS"]
    size = (300, 340)
    picture = cleaner_front(brand, words, paper, band, ink, "tablet", "!", size)
    board = plain(paper, 0.03)
    label = printed(picture, base=paper)
    if kind == "carton":
        depth, width, height = 0.075, 0.155, 0.175
        lid = plain(band, 0.03)
        body = box(
            depth, width, height * 0.93, (0, 0, 0), board, 0, 1, {"+x": label, "-x": label}
        ).weigh(1.2)
        top = box(depth + 0.003, width + 0.003, height * 0.07, (0, 0, height * 0.93), lid, 0.001)
        meshes = [body, top]
        pieces = [box_piece((0, 0, height / 2), (depth + 0.003, width + 0.003, height))]
    else:
        width, height = 0.17, 0.22
        rings = []
        for z, d, w in ((0, 0.8, 0.93), (0.006, 0.9, 0.97), (0.06, 0.95, 1), (0.13, 0.66, 0.97)):
            rings.append(superellipse(0.038 * d, width / 2 * w, 4, 16, z))
        rings.append(superellipse(0.012, width / 2 * 0.97, 6, 16, 0.19))
        rings.append(superellipse(0.0035, width / 2 * 0.98, 8, 16, 0.2))
        rings.append(superellipse(0.0035, width / 2 * 0.98, 8, 16, height))
        pouch = loft(rings, mat=plain(band, 0.04)).weigh(1.2)
        both_sides(pouch, printed(picture, base=band), 0.098, 0.155, 0.185, 0.08)
        meshes, pieces = [pouch], [pouch.v]
    return Model(
        f"{kind} of dishwasher tablets",
        {"body": Part(meshes, collision=pieces)},
        mass=0.8,
        friction=0.5,
    )


def dishwasher_tablets_random(rng: np.random.Generator) -> dict:
    return {"brand": pick(rng, ["SPÜLFIX", "Glintz", "TABBO"])}


def pod(size: float, first: str, second: str) -> Mesh:
    """A soft two-coloured cushion of liquid in film, lying flat, its seam sticking out."""
    m = Material(occlusion=0.4)
    wave = m.math("MULTIPLY", m.math("SINE", m.math("MULTIPLY", m.axis(1), 150)), 0.005)
    swirl = m.math("ADD", m.axis(0), wave)
    half = m.mix(m.remap(swirl, -0.0005, 0.0005), first, second)
    seam = m.mix(m.remap(m.axis(2), 0.0045, 0.0046), "f4f8fa", half)
    glint = m.math(
        "ADD", m.math("MULTIPLY", m.normal(2), 0.85), m.math("MULTIPLY", m.normal(0), 0.4)
    )
    m.colour(m.mix(m.remap(glint, 0.93, 0.97, 0, 0.8), seam, "ffffff"))
    h = size / 2
    rings = [
        superellipse(h * f, h * f, 4, 16, z)
        for f, z in (
            (0.7, 0),
            (0.88, 0.0035),
            (1.0, 0.004),
            (1.0, 0.0052),
            (0.86, 0.0062),
            (0.78, 0.013),
            (0.45, 0.0165),
        )
    ]
    return loft(rings, mat=m)


def laundry_pods(
    kind: str, first: str, second: str, body: str, lid: str, brand: str, paper: str
) -> Model:
    """Three loose pods, or a tub of them, shut or (open) with pods on top."""
    if kind == "loose":
        pieces = []
        for x, y, turn in ((0, -0.022, 0.2), (0.012, 0.025, 0.9), (-0.038, 0.006, 0.5)):
            one = pod(0.041, first, second).keep_pattern().turn(rz=turn)
            pieces.append([one.move(x, y)])
        return loose("loose laundry pods", pieces, 0.07)
    picture = cleaner_front(brand, ["LAUNDRY", "PODS"], paper, first, "#1c1c30", "pod", "!")
    label = printed(picture, base=body)
    plastic = plain(body, 0.03)
    steps = [(0, 0.9, 0.9), (0.005, 0.93, 0.93), (0.1, 1, 1), (0.112, 1, 1)]
    tub = oval_body(steps, 0.14, 0.11, plastic, 3.4)
    both_sides(tub.weigh(1.2), label, 0.054, 0.1, 0.098, 0.056)
    meshes = [tub]
    pieces = [box_piece((0, 0, 0.057), (0.108, 0.138, 0.114))]
    if kind == "shut":
        rings = [(0.11, 1.04, 1.05), (0.128, 1.04, 1.05), (0.138, 0.9, 0.88)]
        meshes.append(oval_body(rings, 0.14, 0.11, plain(lid, 0.03), 3.4))
        pieces.append(box_piece((0, 0, 0.124), (0.11, 0.14, 0.028)))
    else:
        rim = [(0.1, 0.98, 0.98), (0.111, 1.03, 1.04), (0.118, 1.03, 1.04), (0.118, 0.96, 0.95)]
        rim.append((0.104, 0.93, 0.92))
        meshes.append(oval_body(rim, 0.14, 0.11, plain(shade(body, 0.9), 0.03), 3.4))
        heap = ((-0.022, -0.038, 0.2), (0.024, -0.026, 0.8), (-0.02, 0.012, 0.5))
        for k, (x, y, turn) in enumerate((*heap, (0.022, 0.034, 0.1))):
            one = pod(0.041, first, second).keep_pattern().turn(rx=0.2 * (k % 3 - 1), rz=turn)
            meshes.append(one.move(x, y, 0.104 + 0.003 * (k % 2)))
        pieces.append(box_piece((0, 0, 0.116), (0.09, 0.12, 0.012)))
    return Model(
        f"{'open ' if kind == 'open' else ''}tub of laundry pods",
        {"body": Part(meshes, collision=pieces)},
        mass=0.6,
        friction=0.5,
    )


def laundry_pods_random(rng: np.random.Generator) -> dict:
    return {"brand": pick(rng, ["LINEO", "Frisko"]), "paper": "#ffffff"}


def scouring_powder(
    height: float, radius: float, paper: str, band: str, ink: str, lid: str, brand: str
) -> Model:
    """A cardboard canister with a sprinkler top."""
    r, h = radius, height
    front = cleaner_front(brand, ["SCOURING", "POWDER"], paper, band, ink, "star", "!")
    around, _ = canvas(1024, 340, paper)
    for k in range(5):  # four times round, one of them facing +X
        around.paste(front, (256 * k - 128, 0), front)
    top_picture, draw = canvas(128, 128, lid)
    for n, away in ((1, 0.0), (6, 22.0), (10, 42.0)):
        for i in range(n):
            x, y = 64 + away * math.cos(TAU * i / n), 64 + away * math.sin(TAU * i / n)
            draw.ellipse((x - 6, y - 6, x + 6, y + 6), fill="#2a2a2e")
    steel = plain("#c9cdd1", 0.05)
    profile = [(0, 0), (r, 0), (r, 0.005), (r * 0.985, 0.006), (r * 0.985, h - 0.012)]
    profile += [(r, h - 0.011), (r, h - 0.004), (r * 0.9, h), (0, h)]
    can = lathe(
        profile,
        20,
        mats=[steel, printed(around.convert("RGB")), plain(lid, 0.03)],
        mat_of_segment=[0, 0, 0, 1, 2, 2, 2, 2],
        label_z=(0.006, h - 0.012),
        start=-math.pi,
        weight=1.2,
    )
    across = 1.7 * r
    project_label(can, printed(top_picture), "+z", (0, 0), (across, across), 0.9)
    part = Part([can], collision=[cylinder_piece(r, 0, h, 14)])
    return Model("scouring powder", {"body": part}, mass=0.6, friction=0.5)


def scouring_powder_random(rng: np.random.Generator) -> dict:
    return {
        "height": uniform(rng, 0.19, 0.23),
        "radius": uniform(rng, 0.034, 0.038),
        "brand": pick(rng, ["SCOURA", "Blitzan"]),
    }
