"""Small things for small hands: hair clips."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import Material, metal, plain, shade
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model
from toolkit.sampling import pick, seed_of
from toolkit.shapes import box, ellipsoid, extrude, lathe, loft, spline, superellipse

from makers.choking import loose


def snap_clip(paint: str, flower: str) -> list[Mesh]:
    """A drop-shaped snap clip with a slot, and a flower at its broad end; along +X."""
    drop = spline(
        [
            (-0.026, 0),
            (-0.022, 0.0075),
            (-0.01, 0.0088),
            (0.008, 0.006),
            (0.026, 0.0028),
            (0.028, 0),
            (0.026, -0.0028),
            (0.008, -0.006),
            (-0.01, -0.0088),
            (-0.022, -0.0075),
        ],
        2,
        closed=True,
    )
    plate = extrude(drop, 0.005, plain(paint, 0.03))
    slot = box(0.03, 0.0042, 0.0008, (0.003, 0, 0.005), metal("c9cdd1", "7e858c"))
    meshes = [plate, slot]
    if flower:
        petals = lathe(
            [(0, 0), (0.009, 0.0005), (0.0092, 0.003), (0, 0.0035)],
            10,
            mat=plain(flower, 0.03),
            rib=lambda k, i: 1.0 if i % 2 else 0.62,
        )
        heart = ellipsoid((0.003, 0.003, 0.002), (-0.014, 0, 0.009), 6, 4, plain("#f6d32a", 0))
        meshes += [petals.move(-0.014, 0, 0.0056), heart]
    return meshes


def bow_clip(paint: str, dots: str) -> list[Mesh]:
    """A ribbon bow on a clip."""
    m = Material()
    cell = m.voronoi(150, randomness=0.0)
    m.colour(m.mix(m.remap(cell, 0.28, 0.32, 1, 0), paint, dots))
    meshes = []
    for side in (-1, 1):
        rings = []
        for x, wide, tall in (
            (0.002, 0.004, 0.004),
            (0.012, 0.011, 0.007),
            (0.023, 0.0145, 0.0075),
        ):
            ring = superellipse(wide, tall, 2.6, 10)
            rings.append(np.c_[np.full(10, side * x), ring[:, 0], ring[:, 1] + 0.008])
        rings.append(rings[-1] * [1, 0.7, 0.55] + [side * 0.0025, 0, 0.0036])
        meshes.append(loft(rings, mat=m))
    knot = plain(shade(paint, 0.7), 0.04)
    meshes.append(ellipsoid((0.005, 0.006, 0.0065), (0, 0, 0.0085), 8, 5, knot))
    meshes.append(box(0.044, 0.006, 0.004, (0, 0, 0), metal("c9cdd1", "7e858c")))
    return meshes


def hair_clips(kind: str, colours: list[tuple[str, str]], seed: int) -> Model:
    """Snap clips side by side, or two bows."""
    rng = np.random.default_rng(seed)
    pieces = []
    pitch = 0.021 if kind == "snap" else 0.036
    for k, (first, second) in enumerate(colours):
        piece = snap_clip(first, second) if kind == "snap" else bow_clip(first, second)
        turn = float(rng.uniform(-0.3, 0.3)) + math.pi * (k % 2)
        y = (k - (len(colours) - 1) / 2) * pitch
        x = float(rng.uniform(-0.006, 0.006))
        pieces.append([m.keep_pattern().turn(rz=turn).move(x, y) for m in piece])
    return loose("hair clips" if kind == "snap" else "hair bows", pieces, 0.02)


def hair_clips_random(rng: np.random.Generator) -> dict:
    return {"kind": pick(rng, ["snap", "bow"]), "seed": seed_of(rng)}


MODELS = {
    "hair_clips": Maker(
        hair_clips,
        hair_clips_random,
        2,
        [
            {
                "kind": "snap",
                "colours": [
                    ("#d8308a", "#ffffff"),
                    ("#2f8fd8", "#f07a1c"),
                    ("#7b3fb5", "#f6b0d0"),
                    ("#2fa05a", "#d8202c"),
                ],
            },
            {"kind": "bow", "colours": [("#d8202c", "#ffffff"), ("#1f4fb8", "#ffffff")]},
        ],
    ),
}
