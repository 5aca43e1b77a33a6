"""Soft toys: a teddy bear."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import Material, blend, plain, shade
from toolkit.mesh import Mesh
from toolkit.model import (
    Maker,
    Model,
    Part,
)
from toolkit.sampling import noise_offset, pick, seed_of, uniform
from toolkit.shapes import (
    TAU,
    ellipsoid,
    spline,
    tube,
)


def _furry(mesh: Mesh, rng: np.random.Generator, amount: float) -> Mesh:
    """Push vertices in and out a little (the same for vertices that coincide)."""
    _, group = np.unique(np.round(mesh.v, 6), axis=0, return_inverse=True)
    group = group.ravel()
    push = rng.normal(0, amount, group.max() + 1)[group]
    away = mesh.v - mesh.v.mean(0)
    away /= np.linalg.norm(away, axis=1)[:, None] + 1e-9
    mesh.v = mesh.v + away * push[:, None]
    return mesh


def teddy_bear(height: float, fur: str, bow: str | None, seed: int) -> Model:
    """A sitting teddy bear."""
    rng = np.random.default_rng(seed)
    offset = noise_offset(rng)
    s = height / 0.29
    pelt, light = Material(), Material()
    tufts, patches = pelt.noise(260, 4, 0.7, 0.8, offset), pelt.noise(30, 2, offset=offset)
    coat = pelt.mix(pelt.remap(tufts, 0.32, 0.68), shade(fur, 0.66), shade(fur, 1.22))
    pelt.colour(pelt.mix(pelt.remap(patches, 0.35, 0.7, 0, 0.25), coat, shade(fur, 1.3)))
    pale = blend(fur, "#fff6e6", 0.55)
    light.colour(
        light.mix(
            light.remap(light.noise(260, 4, offset=offset), 0.3, 0.7), shade(pale, 0.86), pale
        )
    )
    black, thread = plain("#14110f", 0), plain("#2a1a12", 0)

    def ball(radii, at, mat=pelt, n=10, m=7, turn=(0, 0, 0)):
        return _furry(
            ellipsoid(radii, (0, 0, 0), n, m, mat).turn(*turn),
            rng,
            0.0018 if mat in (pelt, light) else 0,
        ).move(*at)

    parts = [
        ball((0.060, 0.070, 0.080), (0, 0, 0.078), n=12, m=7),
        ball((0.022, 0.046, 0.052), (0.044, 0, 0.076), light, 10, 6),
        ball((0.058, 0.064, 0.056), (0.006, 0, 0.205), n=13, m=8),
        ball((0.026, 0.030, 0.024), (0.056, 0, 0.193), light, 10, 6),
        ball((0.007, 0.0115, 0.008), (0.081, 0, 0.202), black, 6, 4),
    ]
    for q in (-1, 1):
        parts += [
            ball((0.014, 0.027, 0.027), (0, q * 0.052, 0.250), n=9, m=6),
            ball((0.008, 0.016, 0.016), (0.011, q * 0.049, 0.248), light, 7, 5),
            ball(
                (0.024, 0.024, 0.054), (0.018, q * 0.080, 0.113), n=9, m=6, turn=(q * 0.75, -0.4, 0)
            ),
            ball((0.060, 0.033, 0.032), (0.062, q * 0.052, 0.032), n=9, m=6, turn=(0, 0, q * 0.35)),
            ball((0.010, 0.025, 0.025), (0.118, q * 0.073, 0.034), light, 9, 5, (0, 0, q * 0.35)),
            ball((0.006, 0.0085, 0.009), (0.0575, q * 0.024, 0.219), black, 6, 4),
            tube(
                spline(
                    [(0.0828, 0, 0.188), (0.081, q * 0.008, 0.182), (0.077, q * 0.014, 0.185)], 2
                ),
                0.0014,
                3,
                mat=thread,
                weight=0.5,
            ),
        ]
    if bow:
        ribbon = plain(bow, 0.08, 120)
        ring = [
            (0.008 + 0.048 * math.cos(t), 0.044 * math.sin(t), 0.150)
            for t in np.linspace(0, TAU, 11, endpoint=False)
        ]
        parts += [
            tube(ring, 0.006, 4, closed=True, mat=ribbon, flatten=1.3),
            ball((0.009, 0.009, 0.009), (0.060, 0, 0.148), ribbon, 6, 5),
        ]
        for q in (-1, 1):
            parts.append(
                ball(
                    (0.009, 0.023, 0.016), (0.058, q * 0.026, 0.148), ribbon, 7, 4, (q * 0.2, 0, 0)
                )
            )
    for mesh in parts:
        mesh.scale(s)
    lowest = min(mesh.v[:, 2].min() for mesh in parts)
    for mesh in parts:
        mesh.move(z=-lowest)
    pieces = [ellipsoid((0.06 * s, 0.07 * s, 0.08 * s), (0, 0, 0.079 * s), 7, 4).v]
    pieces.append(ellipsoid((0.062 * s, 0.066 * s, 0.056 * s), (0.012 * s, 0, 0.206 * s), 7, 4).v)
    for q in (-1, 1):
        leg = ellipsoid((0.068 * s, 0.033 * s, 0.032 * s), (0, 0, 0), 7, 4).turn(rz=q * 0.35)
        pieces.append(leg.move(0.062 * s, q * 0.052 * s, 0.033 * s).v)
    return Model("teddy bear", {"body": Part(parts, collision=pieces)}, mass=0.25, friction=0.8)


def teddy_bear_random(rng: np.random.Generator) -> dict:
    return {
        "height": uniform(rng, 0.24, 0.36),
        "fur": pick(rng, ["#a8713c", "#c79a62", "#d9c3a0", "#8f8a86"]),
        "bow": pick(rng, ["#c8242c", "#2a5fb8", "#2f8a4c"]),
        "seed": seed_of(rng),
    }


MODELS = {
    "teddy_bear": Maker(
        teddy_bear,
        teddy_bear_random,
        3,
        [
            {"fur": "#a8713c", "bow": "#c8242c"},
            {"fur": "#d9c3a0", "bow": "#2a5fb8"},
            {"fur": "#8f8a86", "bow": None},
        ],
    ),
}
