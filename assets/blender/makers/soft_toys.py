"""Soft toys: teddy bears."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import Material, blend, plain, shade
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part
from toolkit.sampling import noise_offset, pick
from toolkit.shapes import TAU, ellipsoid, tube

from makers.solids import flattened, grown, solids


def _furry(mesh: Mesh, rng: np.random.Generator, amount: float) -> Mesh:
    """Push vertices in and out a little (the same for vertices that coincide)."""
    _, group = np.unique(np.round(mesh.v, 6), axis=0, return_inverse=True)
    group = group.ravel()
    push = rng.normal(0, amount, group.max() + 1)[group]
    away = mesh.v - mesh.v.mean(0)
    away /= np.linalg.norm(away, axis=1)[:, None] + 1e-9
    mesh.v = mesh.v + away * push[:, None]
    return mesh


def _fur(colour: str, rng: np.random.Generator) -> Material:
    offset, pelt = noise_offset(rng), Material()
    tufts, patches = pelt.noise(260, 4, 0.7, 0.8, offset), pelt.noise(30, 2, offset=offset)
    coat = pelt.mix(pelt.remap(tufts, 0.32, 0.68), shade(colour, 0.7), shade(colour, 1.2))
    return pelt.colour(pelt.mix(pelt.remap(patches, 0.35, 0.7, 0, 0.25), coat, shade(colour, 1.3)))


# centre, radii and turn of arm, leg and sole (left; mirrored), for each pose
LIMBS = {
    "sitting": (
        ((0.018, 0.080, 0.113), (0.024, 0.024, 0.054), (0.75, -0.4, 0)),
        ((0.062, 0.052, 0.032), (0.060, 0.033, 0.032), (0, 0, 0.35)),
        ((0.118, 0.073, 0.034), (0.010, 0.025, 0.025), (0, 0, 0.35)),
    ),
    "standing": (
        ((0.012, 0.086, 0.108), (0.024, 0.024, 0.056), (0.55, -0.15, 0)),
        ((0.004, 0.038, -0.022), (0.032, 0.032, 0.062), (0.12, 0, 0)),
        ((0.014, 0.044, -0.074), (0.042, 0.031, 0.02), (0, 0, 0.2)),
    ),
    "hugging": (
        ((0.05, 0.07, 0.105), (0.052, 0.023, 0.023), (0, 0.25, -0.45)),
        ((0.056, 0.056, 0.03), (0.060, 0.033, 0.032), (0, 0, 0.5)),
        ((0.106, 0.083, 0.032), (0.010, 0.025, 0.025), (0, 0, 0.5)),
    ),
    "prone": (
        ((0.01, 0.07, 0.17), (0.024, 0.024, 0.058), (-0.3, 0, 0)),
        ((-0.02, 0.056, -0.012), (0.032, 0.032, 0.062), (0.4, 0, 0)),
        ((-0.02, 0.078, -0.066), (0.026, 0.026, 0.012), (0.4, 0, 0)),
    ),
}


def teddy_bear(
    height: float, fur: str, limbs: str, bow: str | None, pose: str, heart: str | None
) -> Model:
    """A teddy bear that sits, stands, hugs a heart or lies on its tummy; `height` sitting."""
    rng = np.random.default_rng(7)
    pelt, dark_pelt = _fur(fur, rng), _fur(limbs, rng)
    light = plain(blend(fur, "#fff6e6", 0.55), 0.1, 260)
    inner = plain(blend(limbs, "#fff6e6", 0.5 if limbs == fur else 0.05), 0.1, 260)
    black, soft = plain("#14110f", 0), (pelt, dark_pelt)

    def ball(radii, at, mat=pelt, n=10, m=6, turn=(0, 0, 0)):
        amount = 0.0018 if mat in soft else 0
        return _furry(ellipsoid(radii, (0, 0, 0), n, m, mat).turn(*turn), rng, amount).move(*at)

    trunk = [
        ball((0.060, 0.070, 0.080), (0, 0, 0.078), n=10, m=5),
        ball((0.022, 0.046, 0.052), (0.044, 0, 0.076), light, 8, 4),
    ]
    head = [
        ball((0.058, 0.064, 0.056), (0.006, 0, 0.205)),
        ball((0.026, 0.030, 0.024), (0.056, 0, 0.193), light, 8, 4),
        ball((0.007, 0.0115, 0.008), (0.081, 0, 0.202), black, 5, 3),
    ]
    arms, legs = ([], []), ([], [])
    patch = dark_pelt if limbs != fur else None
    for k, q in enumerate((-1, 1)):
        head += [
            ball((0.014, 0.027, 0.027), (0, q * 0.052, 0.250), dark_pelt, 6, 4),
            ball((0.008, 0.016, 0.016), (0.011, q * 0.049, 0.248), inner, 5, 3),
            ball((0.006, 0.0085, 0.009), (0.0585, q * 0.024, 0.219), black, 5, 3),
        ]
        if patch:
            head.append(ball((0.008, 0.016, 0.019), (0.0515, q * 0.025, 0.216), patch, 6, 3))
        (at, radii, turn), (at2, radii2, turn2), (at3, radii3, turn3) = LIMBS[pose]
        for to, centre, size, angles, mat, n, m in (
            (arms[k], at, radii, turn, dark_pelt, 6, 5),
            (legs[k], at2, radii2, turn2, dark_pelt, 6, 5),
            (legs[k], at3, radii3, turn3, inner, 6, 3),
        ):
            mirrored = (q * angles[0], angles[1], q * angles[2])
            to.append(ball(size, (centre[0], q * centre[1], centre[2]), mat, n, m, mirrored))
    extra = []
    if bow:
        ribbon = plain(bow, 0.08, 120)
        ring = [
            (0.008 + 0.048 * math.cos(t), 0.044 * math.sin(t), 0.150)
            for t in np.linspace(0, TAU, 8, endpoint=False)
        ]
        extra += [
            tube(ring, 0.006, 3, closed=True, mat=ribbon, flatten=1.3),
            ball((0.009, 0.009, 0.009), (0.060, 0, 0.148), ribbon, 5, 3),
        ]
        for q in (-1, 1):
            at = (0.058, q * 0.026, 0.148)
            extra.append(ball((0.009, 0.023, 0.016), at, ribbon, 5, 3, (q * 0.2, 0, 0)))
    if heart:
        red = plain(heart, 0.05, 100)
        for q in (-1, 1):
            at = (0.092, q * 0.015, 0.107)
            extra.append(ball((0.02, 0.02, 0.036), at, red, 7, 4, (-q * 0.72, 0, 0)))
    parts = [*trunk, *head, *arms[0], *arms[1], *legs[0], *legs[1], *extra]
    if pose == "prone":  # on its tummy, the head up
        for mesh in parts:
            mesh.keep_pattern()
        for mesh in head:
            mesh.move(0.165, 0, -0.205 + 0.045)
        for mesh in (*trunk, *arms[0], *arms[1], *legs[0], *legs[1]):
            mesh.turn(ry=math.pi / 2)
    flattened(grown(parts, height / 0.29), 0.011 if pose != "prone" else 0.028)
    pieces = solids(trunk, head, *arms, *legs)
    return Model("teddy bear", {"body": Part(parts, collision=pieces)}, mass=0.25, friction=0.8)


def teddy_bear_random(rng: np.random.Generator) -> dict:
    fur = pick(rng, ["#a8713c", "#c79a62", "#d9c3a0", "#8f8a86"])
    return {
        "height": 0.34,
        "fur": fur,
        "limbs": fur,
        "bow": pick(rng, ["#c8242c", "#2a5fb8", "#2f8a4c"]),
        "pose": "sitting",
        "heart": None,
    }


def _coat(fur: str, limbs: str | None = None) -> dict:
    return {"fur": fur, "limbs": limbs or fur}


MODELS = {
    "teddy_bear": Maker(
        teddy_bear,
        teddy_bear_random,
        7,
        [
            _coat("#a8713c") | {"bow": "#c8242c"},
            _coat("#d9c3a0") | {"bow": "#2a5fb8"},
            _coat("#8f8a86") | {"bow": None, "pose": "prone", "height": 0.32},
            _coat("#b07a3e") | {"bow": "#2f8a4c", "pose": "standing"},
            _coat("#f2efe6", "#26242a") | {"bow": None},
            _coat("#c99a5c") | {"bow": None, "pose": "hugging", "heart": "#d8202c"},
            _coat("#7a4a2a") | {"bow": "#f2c52a", "pose": "standing"},
        ],
    ),
}
