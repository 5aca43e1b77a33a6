"""Hair dryers, lying on their side with their cord."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import plain
from toolkit.model import Maker, Model, Part
from toolkit.sampling import pick
from toolkit.shapes import box, lathe, loft, tube

from makers.soft_forms import bent, each_hull, footing, ring


def hair_dryer(kind: str, colour: str, accent: str) -> Model:
    """A hair dryer: "pistol", "diffuser", "folded" (travel), "ring" (hollow head) or "bonnet"."""
    shell, dark, cable = plain(colour, 0.03, 20), plain(accent, 0.04), plain("#2a2b2e", 0.04)
    fat = {"pistol": 1.0, "diffuser": 1.0, "folded": 0.8, "retro": 1.1}[kind]
    profile = [
        (0, -0.1),
        (0.034, -0.1),
        (0.046, -0.088),
        (0.048, -0.04),
        (0.042, 0.03),
        (0.033, 0.075),
        (0.033, 0.085),
        (0, 0.085),
    ]
    if kind == "retro":
        profile = [
            (0, -0.09),
            (0.03, -0.09),
            (0.056, -0.06),
            (0.06, -0.01),
            (0.046, 0.05),
            (0.03, 0.075),
            (0.03, 0.085),
            (0, 0.085),
        ]
    barrel = lathe([(r * fat, x * fat) for r, x in profile], 16, mat=shell, discs=False).turn(
        ry=math.pi / 2
    )
    meshes = [barrel]
    meshes.append(
        lathe([(0, -0.106), (0.03, -0.106), (0.034, -0.098), (0, -0.098)], 14, mat=dark)
        .scale(fat)
        .turn(ry=math.pi / 2)
    )
    for r in (0.02,):
        meshes.append(
            tube(
                ring(10, r * fat, r * fat)[:, [2, 0, 1]] + [-0.106 * fat, 0, 0],
                0.0025,
                3,
                closed=True,
                mat=plain("#c8ccd0", 0),
                weight=0.5,
            )
        )
    if kind == "diffuser":
        bowl = lathe(
            [
                (0, 0.08),
                (0.034, 0.08),
                (0.075, 0.115),
                (0.078, 0.13),
                (0.07, 0.13),
                (0.03, 0.1),
                (0, 0.1),
            ],
            14,
            mat=dark,
        ).turn(ry=math.pi / 2)
        meshes.append(bowl)
        for k in (0, 2, 4, 6):
            a = k * math.tau / 6
            r = 0.0 if k == 6 else 0.045
            meshes.append(
                tube(
                    [
                        (0.098, r * math.cos(a), r * math.sin(a)),
                        (0.15, r * math.cos(a), r * math.sin(a)),
                    ],
                    [0.008, 0.005],
                    5,
                    mat=dark,
                )
            )
    else:
        slot = [
            ring(10, 0.034 * fat, 0.034 * fat),
            ring(10, 0.03 * fat, 0.03 * fat),
            ring(10, 0.008, 0.042 * fat),
        ]
        rings = [
            np.c_[np.full(10, x * fat), r[:, 1], r[:, 0]]
            for r, x in zip(slot, (0.078, 0.1, 0.14), strict=True)
        ]
        meshes.append(loft(rings, mats=[dark]))
        meshes.append(box(0.003, 0.07 * fat, 0.008, (0.14 * fat, 0, -0.004), plain("#101112", 0)))
    tilt = 1.25 if kind == "folded" else 0.18
    grip = loft(
        [
            ring(10, 0.021, 0.018, -0.015),
            ring(10, 0.02, 0.017, -0.08),
            ring(10, 0.018, 0.016, -0.13),
            ring(10, 0.012, 0.011, -0.142),
        ][::-1],
        shell if kind != "retro" else dark,
    )
    button = box(0.01, 0.014, 0.03, (0.02, 0, -0.07), plain("#c8302c", 0), 0.002)
    button2 = box(0.01, 0.014, 0.018, (0.02, 0, -0.095), plain("#e8e8e4", 0), 0.002)
    for m in (grip, button, button2):
        meshes.append(m.scale(fat).turn(ry=tilt).move(-0.03 * fat, 0, -0.03 * fat))
    c, s = math.cos(tilt), math.sin(tilt)
    foot = np.array([-0.03 * fat - 0.14 * fat * s, 0, -0.03 * fat - 0.14 * fat * c])
    down = np.array([-s, 0, -c])
    # it lies on its side: the cord curls on the floor (z is then y)
    points = [
        foot,
        foot + down * 0.04,
        foot + down * 0.08 + np.array([-0.03, 0, 0]),
        foot + np.array([-0.12, 0, -0.09]),
    ]
    points += [
        foot + np.array([-0.17, 0, -0.02]),
        foot + np.array([-0.14, 0, 0.06]),
        foot + np.array([-0.08, 0, 0.03]),
        foot + np.array([-0.1, 0, -0.03]),
    ]
    lying = [p + np.array([0, 0.03 * min(1, k / 2), 0]) for k, p in enumerate(points)]
    meshes.append(bent(lying, 0.0045, cable, 3, 2, weight=0.6))
    for m in meshes:
        m.turn(rx=-math.pi / 2)
    low = min(float(m.v[:, 2].min()) for m in meshes)
    for m in meshes:
        m.move(z=-low)
    pieces = [*each_hull(meshes[:-1], 0.03, 20), footing(meshes)]
    return Model(
        "hair dryer" + {"diffuser": " with diffuser", "folded": ", folding"}.get(kind, ""),
        {"body": Part(meshes, collision=pieces)},
        mass=0.55,
        texture_size=128,
    )


def hair_dryer_random(rng: np.random.Generator) -> dict:
    return {"kind": "pistol", "colour": pick(rng, ["#2a2b2e", "#e8e6e2"]), "accent": "#54575c"}


MODELS = {
    "hair_dryer": Maker(
        hair_dryer,
        hair_dryer_random,
        6,
        [
            {"colour": "#2a2b2e", "accent": "#8a8d92"},
            {"kind": "diffuser", "colour": "#f0ece6", "accent": "#2a2b2e"},
            {"kind": "folded", "colour": "#c83a6a", "accent": "#2a2b2e"},
            {"kind": "retro", "colour": "#7fc0b8", "accent": "#f2efe6"},
            {"colour": "#b8303a", "accent": "#26282c"},
            {"kind": "diffuser", "colour": "#5a4a8a", "accent": "#2a2b2e"},
        ],
    ),
}
