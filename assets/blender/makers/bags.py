"""A school backpack and a framed handbag (the categories: bags_more.py)."""

from __future__ import annotations

import numpy as np
from toolkit.labels import canvas, text
from toolkit.materials import Material, metal, plain, shade
from toolkit.materials import label as printed
from toolkit.model import (
    Model,
    Part,
    box_piece,
)
from toolkit.sampling import noise_offset, pick, seed_of, uniform
from toolkit.shapes import (
    box,
    extrude,
    loft,
    rounded_rectangle,
    spline,
    superellipse,
    tube,
)

from makers.convex import few_corners


def woven(colour: str, offset: tuple[float, float, float], fineness: float = 420) -> Material:
    """Coarse nylon or canvas."""
    m = Material()
    weave = m.noise(fineness, 2, offset=offset)
    return m.colour(
        m.mix(
            m.remap(weave, 0.35, 0.65, 0, 0.3),
            m.mottle(colour, 0.07, 12, offset),
            shade(colour, 0.6),
        )
    )


def backpack(height: float, colour: str, second: str, trim: str, seed: int) -> Model:
    """A school backpack standing on its base, its front pocket to +X."""
    rng = np.random.default_rng(seed)
    s = height / 0.44
    body_cloth, pocket_cloth = woven(colour, noise_offset(rng)), woven(second, noise_offset(rng))
    dark, zip_mat, steel = plain(trim, 0.05), plain("#1d1e21", 0.0), metal("b9bdc2", "6a7076")
    shape = [
        (0, 0.9, 0.86),
        (0.012, 1, 0.97),
        (0.12, 1.03, 1.02),
        (0.26, 1, 1.0),
        (0.35, 0.94, 0.9),
        (0.405, 0.8, 0.72),
        (0.432, 0.55, 0.45),
        (0.44, 0.2, 0.15),
    ]

    def lean(x: float, z: float) -> float:
        return x - 0.06 * z  # slumps backwards a little

    rings = []
    for z, w, d in shape:
        ring = superellipse(0.085 * d, 0.15 * w, 3.2, 14, z)
        ring[:, 0] = [lean(x, z) for x in ring[:, 0]]
        rings.append(ring * s)
    body = loft(rings, mat=body_cloth)
    pocket_shape = [
        (0.03, 0.8, 0.55),
        (0.036, 0.98, 0.9),
        (0.1, 1.05, 1.08),
        (0.16, 1, 0.95),
        (0.19, 0.92, 0.7),
        (0.2, 0.75, 0.3),
    ]
    pocket = loft(
        [
            (superellipse(0.045 * d, 0.118 * w, 3.5, 12, z) + np.array([0.078 - 0.06 * z, 0, 0]))
            * s
            for z, w, d in pocket_shape
        ],
        mat=pocket_cloth,
    )
    meshes = [body, pocket]
    # zips: an arch over the main compartment, a line over the pocket
    arch = [
        (0.07, -0.135, 0.2),
        (0.066, -0.137, 0.3),
        (0.05, -0.115, 0.375),
        (0.034, -0.06, 0.415),
        (0.03, 0, 0.422),
        (0.034, 0.06, 0.415),
        (0.05, 0.115, 0.375),
        (0.066, 0.137, 0.3),
        (0.07, 0.135, 0.2),
    ]
    meshes.append(
        tube(
            np.array([(lean(x, z) + 0.004, y, z) for x, y, z in arch]) * s,
            0.0055 * s,
            3,
            mat=zip_mat,
            weight=0.6,
        )
    )
    meshes.append(
        tube(
            np.array([(0.112, -0.1, 0.172), (0.117, 0, 0.178), (0.112, 0.1, 0.172)]) * s,
            0.005 * s,
            3,
            mat=zip_mat,
            weight=0.6,
        )
    )
    meshes.append(box(0.006, 0.012, 0.032, (0.119 * s, 0.05 * s, 0.145 * s), steel))
    meshes.append(box(0.006, 0.01, 0.03, (0.06 * s, -0.121 * s, 0.335 * s), steel))
    badge, draw = canvas(128, 80, second)
    draw.rounded_rectangle((4, 4, 123, 75), 18, fill="#f4f2ea")
    text(draw, "NORDO", (14, 20, 114, 60), "oblique", "#1d1e21")
    meshes.append(
        box(
            0.004,
            0.07 * s,
            0.042 * s,
            (0.1245 * s, 0, 0.08 * s),
            plain(second, 0.0),
            0.001,
            labels={"+x": printed(badge)},
        )
    )
    handle = [
        (-0.07, -0.03, 0.415),
        (-0.075, -0.026, 0.455),
        (-0.078, 0, 0.466),
        (-0.075, 0.026, 0.455),
        (-0.07, 0.03, 0.415),
    ]
    meshes.append(tube(np.array(handle) * s, 0.008 * s, 5, mat=dark, flatten=0.6, up=(1, 0, 0)))
    for q in (-1, 1):
        strap = [
            (-0.09, q * 0.055, 0.4),
            (-0.125, q * 0.075, 0.36),
            (-0.14, q * 0.1, 0.25),
            (-0.125, q * 0.115, 0.13),
            (-0.08, q * 0.125, 0.035),
        ]
        meshes.append(
            tube(
                spline(strap, 2) * s,
                np.interp(np.linspace(0, 1, 9), [0, 0.6, 0.75, 1], [0.024, 0.024, 0.012, 0.011])
                * s,
                5,
                mat=dark,
                flatten=0.32,
                up=(1, 0, 0.1),
            )
        )
        side = loft(
            [
                (superellipse(0.05 * d, 0.022 * d, 2.6, 8, z) + np.array([-0.006, q * 0.148, 0]))
                * s
                for z, d in ((0.015, 0.8), (0.06, 1.05), (0.13, 1.0), (0.135, 0.9))
            ],
            mat=pocket_cloth,
        )
        meshes.append(side)
    pieces = [
        few_corners(np.concatenate(rings[:5]), 30),
        few_corners(np.concatenate(rings[4:]), 24),
        few_corners(pocket.v, 24),
    ]
    return Model("backpack", {"body": Part(meshes, collision=pieces)}, mass=2.5, friction=0.8)


def backpack_random(rng: np.random.Generator) -> dict:
    colour, second, trim = pick(
        rng,
        [
            ("#2f5fa8", "#f08a2c", "#1d2e50"),
            ("#3a3d44", "#8fc83a", "#1c1d20"),
            ("#c8304a", "#3a3d55", "#5a1422"),
        ],
    )
    return {
        "height": uniform(rng, 0.4, 0.46),
        "colour": colour,
        "second": second,
        "trim": trim,
        "seed": seed_of(rng),
    }


def handbag(width: float, leather: str, trim: str, flap: bool) -> Model:
    """A standing handbag with two arched handles."""
    s = width / 0.3
    skin, edge, gold = plain(leather, 0.06, 25), plain(trim, 0.05), metal("d8b45a", "8a6a24")
    rings = []
    for z, w, d in (
        (0, 0.92, 0.9),
        (0.006, 1.0, 1.0),
        (0.08, 0.98, 0.92),
        (0.16, 0.9, 0.66),
        (0.205, 0.84, 0.4),
        (0.21, 0.82, 0.3),
    ):
        outline = rounded_rectangle(0.115 * d, 0.3 * w, 0.022 * d, 3)
        rings.append(np.c_[outline, np.full(len(outline), z)] * s)
    body = loft(rings, mat=skin)
    meshes = [body]
    if flap:
        cover = [
            (0.027, 0.213),
            (0.03, 0.207),
            (0.044, 0.15),
            (0.055, 0.1),
            (0.0625, 0.1),
            (0.052, 0.15),
            (0.036, 0.212),
            (0.03, 0.219),
            (-0.028, 0.219),
            (-0.028, 0.21),
        ]
        meshes.append(extrude(np.array(cover) * s, 0.25 * s, mat=edge, axis="y", bevel_width=0.001))
        clasp_at = (0.061, 0.105)
    else:
        meshes.append(box(0.05 * s, 0.255 * s, 0.01, (0, 0, 0.205 * s), edge, 0.003))
        for q in (-1, 1):
            strap = [
                (0.0585, 0.02),
                (0.0565, 0.08),
                (0.0435, 0.16),
                (0.031, 0.2),
                (0.026, 0.2),
                (0.038, 0.16),
                (0.05, 0.08),
                (0.052, 0.02),
            ]
            meshes.append(
                extrude(np.array(strap) * s, 0.02 * s, mat=edge, axis="y").move(y=q * 0.075 * s)
            )
        clasp_at = (0.036, 0.185)
    meshes.append(
        box(0.007, 0.034 * s, 0.026 * s, (clasp_at[0] * s, 0, clasp_at[1] * s), gold, 0.002)
    )
    for q in (-1, 1):
        foot = 0.19
        arch = [
            (q * 0.034, -0.078, foot),
            (q * 0.036, -0.07, 0.26),
            (q * 0.03, -0.04, 0.32),
            (q * 0.028, 0, 0.338),
            (q * 0.03, 0.04, 0.32),
            (q * 0.036, 0.07, 0.26),
            (q * 0.034, 0.078, foot),
        ]
        meshes.append(tube(spline(arch, 2) * s, 0.0065 * s, 6, mat=edge))
        for y in (-0.078, 0.078):
            meshes.append(
                box(0.008, 0.016 * s, 0.018 * s, (q * 0.034 * s, y * s, 0.19 * s), gold, 0.002)
            )
    pieces = [
        few_corners(np.concatenate(rings), 30),
        *[box_piece((q * 0.032 * s, 0, 0.27 * s), (0.014, 0.16 * s, 0.135 * s)) for q in (-1, 1)],
    ]
    return Model(
        "handbag",
        {"body": Part(meshes, collision=pieces)},
        mass=1.2,
        friction=0.7,
        texture_size=128,
    )


def handbag_random(rng: np.random.Generator) -> dict:
    leather, trim = pick(
        rng, [("#a8502c", "#6a2f18"), ("#26282c", "#3c3e44"), ("#b8304a", "#7a1c2e")]
    )
    return {"width": uniform(rng, 0.27, 0.33), "leather": leather, "trim": trim, "flap": True}
