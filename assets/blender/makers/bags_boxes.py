"""Bags, cardboard boxes and laundry baskets."""

from __future__ import annotations

import math

import numpy as np
from labels import prints
from makers.projection import project_label
from toolkit.labels import canvas, text
from toolkit.materials import Material, metal, plain, shade
from toolkit.materials import label as printed
from toolkit.mesh import Mesh
from toolkit.model import Container, Maker, Model, Part, Support, box_piece, rectangle
from toolkit.sampling import noise_offset, pick, seed_of, uniform
from toolkit.shapes import box, extrude, lathe, loft, rounded_rectangle, spline, superellipse, tube


def _woven(colour: str, offset: tuple[float, float, float], fineness: float = 420) -> Material:
    """Coarse nylon or canvas."""
    m = Material()
    weave = m.noise(fineness, 2, offset=offset)
    return m.colour(m.mix(m.remap(weave, 0.35, 0.65, 0, 0.3), m.mottle(colour, 0.07, 12, offset), shade(colour, 0.6)))


def backpack(height: float, colour: str, second: str, trim: str, seed: int) -> Model:
    """A school backpack standing on its base, its front pocket to +X."""
    rng = np.random.default_rng(seed)
    s = height / 0.44
    body_cloth, pocket_cloth = _woven(colour, noise_offset(rng)), _woven(second, noise_offset(rng))
    dark, zip_mat, steel = plain(trim, 0.05), plain("#1d1e21", 0.0), metal("b9bdc2", "6a7076")
    shape = [(0, 0.9, 0.86), (0.012, 1, 0.97), (0.12, 1.03, 1.02), (0.26, 1, 1.0), (0.35, 0.94, 0.9), (0.405, 0.8, 0.72), (0.432, 0.55, 0.45), (0.44, 0.2, 0.15)]

    def lean(x: float, z: float) -> float:
        return x - 0.06 * z  # slumps backwards a little

    rings = []
    for z, w, d in shape:
        ring = superellipse(0.085 * d, 0.15 * w, 3.2, 20, z)
        ring[:, 0] = [lean(x, z) for x in ring[:, 0]]
        rings.append(ring * s)
    body = loft(rings, mat=body_cloth)
    pocket_shape = [(0.03, 0.8, 0.55), (0.036, 0.98, 0.9), (0.1, 1.05, 1.08), (0.16, 1, 0.95), (0.19, 0.92, 0.7), (0.2, 0.75, 0.3)]
    pocket = loft([(superellipse(0.045 * d, 0.118 * w, 3.5, 16, z) + [0.078 - 0.06 * z, 0, 0]) * s for z, w, d in pocket_shape], mat=pocket_cloth)
    meshes = [body, pocket]
    # zips: an arch over the main compartment, a line over the pocket
    arch = [(0.07, -0.135, 0.2), (0.066, -0.137, 0.3), (0.05, -0.115, 0.375), (0.034, -0.06, 0.415), (0.03, 0, 0.422), (0.034, 0.06, 0.415), (0.05, 0.115, 0.375), (0.066, 0.137, 0.3), (0.07, 0.135, 0.2)]
    meshes.append(tube(spline([(lean(x, z) + 0.004, y, z) for x, y, z in arch], 2) * s, 0.0055 * s, 5, mat=zip_mat, weight=0.6))
    meshes.append(tube(np.array([(0.112, -0.1, 0.172), (0.117, 0, 0.178), (0.112, 0.1, 0.172)]) * s, 0.005 * s, 5, mat=zip_mat, weight=0.6))
    meshes.append(box(0.006, 0.012, 0.032, (0.119 * s, 0.05 * s, 0.145 * s), steel, 0.002))
    meshes.append(box(0.006, 0.01, 0.03, (0.06 * s, -0.121 * s, 0.335 * s), steel, 0.002))
    badge, draw = canvas(128, 80, second)
    draw.rounded_rectangle((4, 4, 123, 75), 18, fill="#f4f2ea")
    text(draw, "NORDO", (14, 20, 114, 60), "oblique", "#1d1e21")
    meshes.append(box(0.004, 0.07 * s, 0.042 * s, (0.1245 * s, 0, 0.08 * s), plain(second, 0.0), 0.001, labels={"+x": printed(badge)}))
    handle = [(-0.07, -0.03, 0.415), (-0.075, -0.026, 0.455), (-0.078, 0, 0.466), (-0.075, 0.026, 0.455), (-0.07, 0.03, 0.415)]
    meshes.append(tube(spline(handle, 2) * s, 0.008 * s, 6, mat=dark, flatten=0.6, up=(1, 0, 0)))
    for q in (-1, 1):
        strap = [(-0.09, q * 0.055, 0.4), (-0.125, q * 0.075, 0.36), (-0.14, q * 0.1, 0.25), (-0.125, q * 0.115, 0.13), (-0.08, q * 0.125, 0.035)]
        meshes.append(tube(spline(strap, 3) * s, np.interp(np.linspace(0, 1, 13), [0, 0.6, 0.75, 1], [0.024, 0.024, 0.012, 0.011]) * s, 6, mat=dark, flatten=0.32, up=(1, 0, 0.1)))
        side = loft([(superellipse(0.05 * d, 0.022 * d, 2.6, 10, z) + [-0.006, q * 0.148, 0]) * s for z, d in ((0.015, 0.8), (0.06, 1.05), (0.13, 1.0), (0.135, 0.9))], mat=pocket_cloth)
        meshes.append(side)
    pieces = [_hull(np.concatenate(rings[:5]), 30), _hull(np.concatenate(rings[4:]), 24), _hull(pocket.v, 24)]
    return Model("backpack", {"body": Part(meshes, collision=pieces)}, mass=2.5, friction=0.8)


def _hull(points: np.ndarray, directions: int) -> np.ndarray:
    """The extreme points in evenly spread directions: a light convex hull."""
    k = np.arange(directions) + 0.5
    z, a = 1 - 2 * k / directions, np.pi * (1 + 5**0.5) * k
    rays = np.c_[np.cos(a) * np.sqrt(1 - z * z), np.sin(a) * np.sqrt(1 - z * z), z]
    return points[np.unique((points @ rays.T).argmax(0))]


def backpack_random(rng: np.random.Generator) -> dict:
    colour, second, trim = pick(rng, [("#2f5fa8", "#f08a2c", "#1d2e50"), ("#3a3d44", "#8fc83a", "#1c1d20"), ("#c8304a", "#3a3d55", "#5a1422")])
    return {"height": uniform(rng, 0.4, 0.46), "colour": colour, "second": second, "trim": trim, "seed": seed_of(rng)}


def handbag(width: float, leather: str, trim: str, flap: bool) -> Model:
    """A standing handbag with two arched handles."""
    s = width / 0.3
    skin, edge, gold = plain(leather, 0.06, 25), plain(trim, 0.05), metal("d8b45a", "8a6a24")
    rings = []
    for z, w, d in ((0, 0.92, 0.9), (0.006, 1.0, 1.0), (0.08, 0.98, 0.92), (0.16, 0.9, 0.66), (0.205, 0.84, 0.4), (0.21, 0.82, 0.3)):
        outline = rounded_rectangle(0.115 * d, 0.3 * w, 0.022 * d, 3)
        rings.append(np.c_[outline, np.full(len(outline), z)] * s)
    body = loft(rings, mat=skin)
    meshes = [body]
    if flap:
        cover = [(0.027, 0.213), (0.03, 0.207), (0.044, 0.15), (0.055, 0.1), (0.0625, 0.1), (0.052, 0.15), (0.036, 0.212), (0.03, 0.219), (-0.028, 0.219), (-0.028, 0.21)]
        meshes.append(extrude(np.array(cover) * s, 0.25 * s, mat=edge, axis="y", bevel_width=0.001))
        clasp_at = (0.061, 0.105)
    else:
        meshes.append(box(0.05 * s, 0.255 * s, 0.01, (0, 0, 0.205 * s), edge, 0.003))
        for q in (-1, 1):
            strap = [(0.0585, 0.02), (0.0565, 0.08), (0.0435, 0.16), (0.031, 0.2), (0.026, 0.2), (0.038, 0.16), (0.05, 0.08), (0.052, 0.02)]
            meshes.append(extrude(np.array(strap) * s, 0.02 * s, mat=edge, axis="y").move(y=q * 0.075 * s))
        clasp_at = (0.036, 0.185)
    meshes.append(box(0.007, 0.034 * s, 0.026 * s, (clasp_at[0] * s, 0, clasp_at[1] * s), gold, 0.002))
    for q in (-1, 1):
        foot = 0.19
        arch = [(q * 0.034, -0.078, foot), (q * 0.036, -0.07, 0.26), (q * 0.03, -0.04, 0.32), (q * 0.028, 0, 0.338), (q * 0.03, 0.04, 0.32), (q * 0.036, 0.07, 0.26), (q * 0.034, 0.078, foot)]
        meshes.append(tube(spline(arch, 2) * s, 0.0065 * s, 7, mat=edge))
        for y in (-0.078, 0.078):
            meshes.append(box(0.008, 0.016 * s, 0.018 * s, (q * 0.034 * s, y * s, 0.19 * s), gold, 0.002))
    pieces = [_hull(np.concatenate(rings), 30), *[box_piece((q * 0.032 * s, 0, 0.27 * s), (0.014, 0.16 * s, 0.135 * s)) for q in (-1, 1)]]
    return Model("handbag", {"body": Part(meshes, collision=pieces)}, mass=1.2, friction=0.7)


def handbag_random(rng: np.random.Generator) -> dict:
    leather, trim = pick(rng, [("#a8502c", "#6a2f18"), ("#26282c", "#3c3e44"), ("#b8304a", "#7a1c2e")])
    return {"width": uniform(rng, 0.27, 0.33), "leather": leather, "trim": trim, "flap": True}


def kraft(seed: int) -> Material:
    """Brown corrugated cardboard."""
    rng = np.random.default_rng(seed)
    m = Material()
    fibres = m.noise(9, 4, offset=noise_offset(rng), stretch=(1, 1, 14))
    return m.colour(m.mix(m.remap(fibres, 0.4, 0.65, 0, 0.3), m.mottle("#bb8d5c", 0.05, 30, noise_offset(rng)), "9c7245"))


def cardboard_box(length: float, width: float, height: float, is_open: bool, marking: str, seed: int) -> Model:
    """A shipping box: flaps taped shut, or standing open and empty."""
    rng = np.random.default_rng(seed)
    card, inner, wall = kraft(seed), plain("#a87f50", 0.06, 40), 0.006
    picture = prints.carton_side(marking, rng)
    print_mat = Material()
    print_mat.colour(print_mat.image(picture, print_mat.mottle("#bb8d5c", 0.05, 30, noise_offset(rng))))
    seam, tape = plain("#8a6238", 0.03), plain("#d9b987", 0.04, 60)
    l2, w2 = length / 2, width / 2
    if not is_open:
        body = box(length, width, height - 0.005, (0, 0, 0), card, 0.003)
        for side in ("+x", "-x"):
            project_label(body, print_mat, side, (0, height * 0.48), (min(width * 0.9, height * 1.15), height * 0.9), 0.9)
        flaps = [box(length - 0.001, w2 - 0.0015, 0.005, (0, q * w2 / 2, height - 0.005), card, 0.001) for q in (-1, 1)]
        strip = box(length + 0.003, 0.055, 0.0016, (0, 0, height - 0.0008), tape)
        ends = [box(0.0016, 0.055, 0.07, (q * (l2 + 0.0007), 0, height - 0.07), tape) for q in (-1, 1)]
        whole = box_piece((0, 0, height / 2), (length, width, height))
        part = Part([body, *flaps, box(length - 0.01, 0.006, 0.003, (0, 0, height - 0.004), seam), strip, *ends], collision=[whole])
        support = Support("top", height + 0.0008, rectangle(length - 0.02, width - 0.02))
        return Model("closed cardboard box", {"body": part}, mass=round(160 * length * width * height, 2), supports=[support])
    meshes = [box(length, width, wall, (0, 0, 0), card)]
    meshes.append(box(length - 2 * wall, width - 2 * wall, 0.001, (0, 0, wall - 0.0005), inner))
    pieces = [box_piece((0, 0, wall / 2), (length, width, wall))]
    for q in (-1, 1):
        side = "+x" if q > 0 else "-x"
        panel = box(wall, width, height, (q * (l2 - wall / 2), 0, 0), card)
        project_label(panel, print_mat, side, (0, height * 0.48), (min(width * 0.9, height * 1.15), height * 0.9), 0.9)
        meshes += [panel, box(length, wall, height, (0, q * (w2 - wall / 2), 0), card)]
        pieces += [box_piece((q * (l2 - wall / 2), 0, height / 2), (wall, width, height)), box_piece((0, q * (w2 - wall / 2), height / 2), (length, wall, height))]
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
    space = Container("inside", (0, 0, (height + wall) / 2), (length - 2 * wall, width - 2 * wall, height - wall))
    support = Support("floor", wall + 0.0005, rectangle(length - 2 * wall - 0.02, width - 2 * wall - 0.02), container="inside")
    return Model(
        "open cardboard box", {"body": Part(meshes, collision=pieces)}, mass=0.6, containers=[space], supports=[support],
    )  # fmt: skip


def cardboard_box_random(rng: np.random.Generator) -> dict:
    return {
        "length": uniform(rng, 0.28, 0.36), "width": uniform(rng, 0.34, 0.44), "height": uniform(rng, 0.24, 0.32),
        "is_open": False, "marking": "fragile", "seed": seed_of(rng),
    }  # fmt: skip


def laundry_basket(style: str, width: float, height: float, colour: str, seed: int) -> Model:
    """An open basket, tapered, of slotted plastic or woven wicker."""
    rng = np.random.default_rng(seed)
    depth, wall = width * 0.72, 0.008
    if style == "slotted":
        picture, draw = canvas(1024, 256, colour)
        dark = "#%02x%02x%02x" % tuple(int(255 * c) for c in shade(colour, 0.28))
        for i in range(32):
            for j in range(3):
                x, y = 32 * i + 8, 40 + 62 * j
                draw.rounded_rectangle((x, y, x + 15, y + 48), 7, fill=dark)
        outside = printed(picture)
        inside = printed(picture, occlusion=1.0)
        rim_mat = plain(shade(colour, 0.92), 0.03)
    else:
        outside, inside = Material(), Material()
        for m in (outside, inside):
            rows = m.math("SINE", m.math("MULTIPLY", m.axis(2), 300))
            columns = m.math("SINE", m.math("MULTIPLY", m.math("ADD", m.axis(0), m.axis(1)), 260))
            weave = m.math("MULTIPLY", rows, columns)
            m.colour(m.ramp(m.remap(weave, -0.9, 0.9), [(0, shade(colour, 0.42)), (0.35, shade(colour, 0.8)), (0.6, colour), (1, shade(colour, 1.25))]))
        rim_mat = plain(shade(colour, 0.75), 0.15, 120)
    levels = [(0, 0.78), (0.01, 0.8), (height * 0.5, 0.91), (height - 0.025, 1.0)]

    def ring(z: float, f: float, inset: float) -> np.ndarray:
        outline = rounded_rectangle(depth * f - 2 * inset, width * f - 2 * inset, 0.07 * f, 4)
        return np.c_[outline, np.full(len(outline), z)]

    shell = [ring(z, f, 0) for z, f in levels] + [ring(height - 0.025, 1.0, wall)] + [ring(max(z, 0.012), f, wall) for z, f in levels[:0:-1][1:]]
    body = loft(shell, mats=[outside, inside], mat_of_face=lambda k, i: 0 if k < 3 else 1).weigh(1.2)
    # the drawing covers one height, inside and outside alike
    for i, face in enumerate(body.f):
        if len(face) == 4:
            body.label_uv[i] = [(u, float(body.v[j][2]) / height) for (u, _), j in zip(body.label_uv[i], face, strict=True)]
    rim_rings = [ring(height - 0.03, 1.0, -0.004), ring(height - 0.03, 1.0, -0.012), ring(height, 1.0, -0.013), ring(height, 1.0, wall + 0.002), ring(height - 0.03, 1.0, wall + 0.001)]
    rim = loft([*rim_rings, rim_rings[0]], mat=rim_mat, caps=(False, False))
    meshes = [body, rim.outward()]
    for q in (-1, 1):
        grip = [(-0.06, q * (width / 2 + 0.008), height - 0.018), (-0.045, q * (width / 2 + 0.04), height - 0.012), (0.045, q * (width / 2 + 0.04), height - 0.012), (0.06, q * (width / 2 + 0.008), height - 0.018)]
        meshes.append(tube(spline(grip, 2), 0.009, 6, mat=rim_mat, up=(0, 0, 1)))
    low, high = levels[0][1], 1.0
    pieces = [box_piece((0, 0, 0.006), (depth * low, width * low, 0.012))]
    for q in (-1, 1):
        pieces.append(np.array([(q * x * depth / 2 - q * d, y * width / 2 * x, z) for x, z in ((low, 0), (high, height)) for d in (0, wall) for y in (-1, 1)]))
        pieces.append(np.array([(y * depth / 2 * x, q * x * width / 2 - q * d, z) for x, z in ((low, 0), (high, height)) for d in (0, wall) for y in (-1, 1)]))
    space = Container("inside", (0, 0, height / 2 + 0.006), (depth * low - 0.02, width * low - 0.02, height - 0.012))
    support = Support("floor", 0.012, rectangle(depth * low - 0.04, width * low - 0.04), container="inside")
    title = "plastic laundry basket" if style == "slotted" else "wicker laundry basket"
    return Model(title, {"body": Part(meshes, collision=pieces)}, mass=1.1, containers=[space], supports=[support])


def laundry_basket_random(rng: np.random.Generator) -> dict:
    return {"style": "slotted", "width": uniform(rng, 0.5, 0.58), "height": uniform(rng, 0.26, 0.32), "colour": pick(rng, ["#f2f2ef", "#7fb4d0", "#b8a0c8"]), "seed": seed_of(rng)}


MODELS = {
    "backpack": Maker(backpack, backpack_random, 3, [{"colour": "#2f5fa8", "second": "#f08a2c", "trim": "#1d2e50"}, {"colour": "#3a3d44", "second": "#6a707a", "trim": "#1c1d20"}, {"colour": "#c8304a", "second": "#3a3d55", "trim": "#5a1422"}]),
    "handbag": Maker(handbag, handbag_random, 3, [{"leather": "#a8502c", "trim": "#6a2f18"}, {"leather": "#26282c", "trim": "#3c3e44", "flap": False}, {"leather": "#b8304a", "trim": "#7a1c2e"}]),
    "cardboard_box": Maker(cardboard_box, cardboard_box_random, 4, [{}, {"is_open": True}, {"marking": "shipping", "length": 0.24, "width": 0.3, "height": 0.16}, {"is_open": True, "marking": "shipping", "length": 0.36, "width": 0.48, "height": 0.22}]),
    "laundry_basket": Maker(laundry_basket, laundry_basket_random, 3, [{"colour": "#f2f2ef"}, {"style": "wicker", "colour": "#c09558"}, {"colour": "#7fb4d0"}]),
}  # fmt: skip
