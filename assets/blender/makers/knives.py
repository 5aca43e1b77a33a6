"""Kitchen knives and the knife block. A knife rests on its side."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import Material, metal, plain, wood
from toolkit.mesh import Mesh, cube_project
from toolkit.model import Container, Model, Part, prism_piece
from toolkit.sampling import noise_offset, pick, seed_of, uniform
from toolkit.shapes import box, extrude, lathe, loft, rounded_rectangle, spline

NO_SHADOW = (1.0, 1.0, 1.0, 0.999)  # a thin blade would throw acne onto itself


STEEL, STEEL_DARK = "c9cdd1", "9aa0a6"


def along(curve: np.ndarray, t: float) -> np.ndarray:
    """The point at share t of a curve's length."""
    s = np.r_[0, np.cumsum(np.linalg.norm(np.diff(curve, axis=0), axis=1))]
    return np.array([np.interp(t * s[-1], s, curve[:, 0]), np.interp(t * s[-1], s, curve[:, 1])])


BLADES = {  # cutting edge and spine, as shares of (length, height), both from the handle to the tip
    "chef": (
        [(0, -0.5), (0.3, -0.55), (0.6, -0.45), (0.82, -0.2), (0.94, 0.12), (1, 0.36)],
        [(0, 0.5), (0.4, 0.5), (0.8, 0.47), (1, 0.36)],
    ),
    "santoku": (
        [(0, -0.5), (0.5, -0.53), (0.85, -0.46), (0.99, -0.36)],
        [(0, 0.5), (0.5, 0.5), (0.78, 0.46), (0.9, 0.3), (0.97, 0.02), (1, -0.3)],
    ),
    "cleaver": (
        [(0, -0.62), (0.5, -0.64), (0.97, -0.62)],
        [(0, 0.4), (0.97, 0.4), (1, 0.36), (1, -0.58)],
    ),
    "bread": (
        [(0, -0.32), (0.85, -0.32), (0.97, -0.2), (1, 0)],
        [(0, 0.32), (0.9, 0.32), (0.97, 0.2), (1, 0.02)],
    ),
}


def blade_mesh(length: float, height: float, style: str, steel: Material, edge: Material) -> Mesh:
    """A wedge-ground blade in the xy plane, edge towards -y, heel at x = 0."""
    scale = 1.9 if style == "cleaver" else 1.0
    cut, spine = (
        spline([(x * length, y * height * scale) for x, y in c], 4) for c in BLADES[style]
    )
    rows = []
    for t in np.linspace(0, 1, 14):
        e, s = along(cut, t), along(spine, t)
        bevel, thick = e + (s - e) * 0.2, 0.0012 * (1 - 0.6 * t)
        rows.append([(*e, 0), (*bevel, thick), (*s, thick), (*s, -thick), (*bevel, -thick)])
    mesh = loft(rows, mats=[steel, edge], mat_of_face=lambda k, i: int(i in (0, 4)))
    return cube_project(mesh).flat()


def knife(blade=0.19, height=0.042, style="chef", handle="#1c1c1e", wooden=False, seed=0) -> Model:
    """A kitchen knife on its side, handle towards -X."""
    rng = np.random.default_rng(seed)
    steel = metal(STEEL, "a3a9ae", (1, 40, 1), 40, noise_offset(rng))
    y0 = height * (0.2 if style == "cleaver" else 0.5 if style != "bread" else 0.4) - 0.0135
    timber = wood(handle, "3a2010", 0, 30, noise_offset(rng))
    grip = timber if wooden else plain(handle, 0.1, 200)
    outline = [
        (0.004, 0.013),
        (-0.03, 0.0125),
        (-0.06, 0.0115),
        (-0.09, 0.013),
        (-0.108, 0.0165),
        (-0.115, 0.0125),
        (-0.115, -0.008),
        (-0.109, -0.0165),
        (-0.097, -0.0175),
        (-0.085, -0.0135),
        (-0.055, -0.0115),
        (-0.03, -0.0125),
        (-0.012, -0.0145),
        (0.004, -0.0115),
    ]
    bolster = metal("cfd2d6", "8b9096")
    hold = [extrude(outline, 0.016, grip, bevel_width=0.004, segments=1).move(0, y0, -0.008)]
    hold.append(box(0.014, 0.03, 0.0175, (0.008, y0, -0.00875), bolster, 0.003))
    hold.append(extrude([(x, y * 1.03) for x, y in outline], 0.0026, bolster).move(0, y0, -0.0013))
    for x in (-0.025, -0.055, -0.085):
        rivet = [(0, -0.0087), (0.0034, -0.0087), (0.0034, 0.0086), (0.0028, 0.009), (0, 0.009)]
        hold.append(lathe(rivet, 8, mat=bolster).move(x, y0 - 0.001))
    edge = plain("e8ebee", 0.02, occlusion=0.4)
    steel.block["occlusion"] = 0.4
    blade_part = blade_mesh(blade, height, style, steel, edge)
    for mesh in (*hold, blade_part):
        mesh.move(z=0.009)
    low, high = blade_part.v.min(0), blade_part.v.max(0)
    pieces = [np.array([(x, y + y0, z) for z in (0.001, 0.017) for x, y in outline])]
    pointed = [
        (0, low[1]),
        (blade * 0.6, low[1]),
        (blade, height * 0.3),
        (blade * 0.9, high[1]),
        (0, high[1]),
    ]
    if style in ("cleaver", "santoku"):
        pointed = [(0, low[1]), (blade, low[1]), (blade, high[1] * 0.6), (0, high[1])]
    return Model(
        title=f"{style} knife" if style != "chef" else "chef's knife",
        parts={
            "handle": Part(hold, collision=pieces, occlusion="handle"),
            # taller than the steel, so that a falling knife does not slip through things
            "blade": Part(
                [blade_part],
                rgba=NO_SHADOW,
                collision=[prism_piece(pointed, 0.005, 0.013)],
                occlusion="blade",
            ),
        },
        mass=0.2,
        friction=0.5,
        texture_size=128,
    )


def knife_random(rng: np.random.Generator) -> dict:
    return {
        "blade": uniform(rng, 0.13, 0.21),
        "height": uniform(rng, 0.03, 0.046),
        "style": pick(rng, ["chef", "chef", "santoku", "cleaver", "bread"]),
        "handle": pick(rng, ["#1c1c1e", "#6b3d1e", "#7a1f1f"]),
        "wooden": bool(rng.random() < 0.4),
        "seed": seed_of(rng),
    }


def knife_block(height=0.22, light="#b98552", dark="#7d5230", handle="#1c1c1e", seed=0) -> Model:
    """A slanted wooden block holding five knives, handles up and to the front."""
    rng = np.random.default_rng(seed)
    skin = wood(light, dark, 2, 9, noise_offset(rng))
    lean, width, depth = 0.42, 0.1, 0.11  # the slots lean this far from the vertical
    up, out = (
        np.array([math.sin(lean), math.cos(lean)]),
        np.array([math.cos(lean), -math.sin(lean)]),
    )
    back = np.array([-0.1, 0.0])
    top_back = back + up * height
    top_front = top_back + out * depth
    outline = [tuple(back), (float(top_front[0]) - 0.035, 0.0), tuple(top_front), tuple(top_back)]
    block = extrude(outline, width, skin, axis="y", bevel_width=0.004)
    grip, steel, slit = plain(handle, 0.08, 150), metal("c3c7cb", "868c92"), plain("2a1a10", 0.0)
    meshes = [block]
    for row, share in ((0, 0.3), (1, 0.72)):
        for y in (-0.028, 0, 0.028) if row == 0 else (-0.016, 0.016):
            foot = top_back + out * depth * share
            size = 0.095 if row == 0 else 0.075
            hilt = extrude(rounded_rectangle(0.024, 0.015, 0.005, 2), size, grip).move(z=0.012)
            ring = box(0.02, 0.011, 0.014, (0, 0, 0), steel)
            hole = box(0.034, 0.006, 0.0015, (0, 0, 0), slit)
            for mesh in (hilt, ring, hole):
                mesh.turn(ry=lean).move(foot[0], y, foot[1])
            meshes += [hilt, ring, hole]
    z = height * 0.5
    hilts = []
    for share, y_span, size in ((0.3, 0.072, 0.107), (0.72, 0.05, 0.087)):
        foot = top_back + out * depth * share
        corners = [foot + out * w for w in (-0.012, 0.012)]
        corners += [c + up * size for c in corners]
        hilts.append(np.array([(x, y, zz) for y in (-y_span / 2, y_span / 2) for x, zz in corners]))
    solid = np.array([(x, y, zz) for y in (-width / 2, width / 2) for x, zz in outline])
    middle = top_back + out * depth / 2 - up * 0.08
    return Model(
        title="wooden knife block with five knives",
        parts={"body": Part(meshes, collision=[solid, *hilts])},
        mass=2.2,
        friction=0.7,
        containers=[
            Container(
                "slots",
                (float(middle[0]), 0, float(min(middle[1], z + 0.05))),
                (0.06, width * 0.8, 0.1),
            )
        ],
    )


def knife_block_random(rng: np.random.Generator) -> dict:
    light, dark = pick(
        rng, [("#b98552", "#7d5230"), ("#d9b27c", "#a87a48"), ("#6b4426", "#3d2413")]
    )
    return {
        "height": uniform(rng, 0.19, 0.24),
        "light": light,
        "dark": dark,
        "handle": pick(rng, ["#1c1c1e", "#3a3f46", "#5a2b1c"]),
        "seed": seed_of(rng),
    }
