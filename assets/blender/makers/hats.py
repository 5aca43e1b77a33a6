"""Hats, lying as they are put down: crown up."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import Material, plain, shade
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part
from toolkit.sampling import noise_offset, pick, seed_of
from toolkit.shapes import ellipsoid, lathe, loft, tube

from makers.convex import few_corners
from makers.soft_forms import ring


def _straw(colour: str, offset) -> Material:
    """Plaited straw: fine rings and flecks."""
    m = Material()
    radius = m.distance((0, 0, 0.0), (1, 1, 1))
    wave = m.math("SINE", m.math("MULTIPLY", radius, 700.0))
    fleck = m.remap(m.noise(130, 2, offset=offset), 0.35, 0.65, 0, 0.5)
    base = m.mix(m.remap(wave, -0.6, 0.6, 0, 0.4), colour, shade(colour, 0.68))
    return m.colour(m.mix(fleck, base, shade(colour, 0.75)))


def _crowned(
    crown: list[tuple[float, float]],
    brim: list[tuple[float, float]],
    felt: Material,
    band: Material | None,
    n: int = 18,
) -> list[Mesh]:
    """A hat of revolution: brim (outwards in, from below) and crown profile, banded at its foot."""
    profile = [*brim, *crown]
    mats = [felt, band or felt]
    kinds = [0] * (len(profile) - 1)
    kinds[len(brim)] = 1
    return [lathe(profile, n, mats=mats, mat_of_segment=kinds, discs=False)]


def _brim_bend(meshes: list[Mesh], start: float, side: float, front: float) -> None:
    """Turn the brim up at the sides and down in front; oval the head."""

    def bend(x: float, y: float, z: float) -> tuple[float, float, float]:
        r = math.hypot(x, y)
        if r > start:
            t = (r - start) / 0.08
            c = abs(y / r) ** 2
            z += side * c * t * t - front * (1 - c) * t
        return x * 1.06, y * 0.96, z

    for mesh in meshes:
        mesh.warp(bend)


def _sun_hat(c: list[str], offset) -> list[Mesh]:
    brim = [(0, 0.016), (0.085, 0.016), (0.19, 0.0), (0.194, 0.004), (0.19, 0.008), (0.094, 0.024)]
    crown = [
        (0.092, 0.026),
        (0.088, 0.058),
        (0.084, 0.09),
        (0.066, 0.112),
        (0.035, 0.12),
        (0, 0.122),
    ]
    meshes = _crowned(crown, brim, _straw(c[0], offset), plain(c[1], 0.04), 20)

    def wobble(x: float, y: float, z: float) -> tuple[float, float, float]:
        out = max(0.0, math.hypot(x, y) - 0.1) / 0.09
        return x, y, z + 0.012 * math.sin(3 * math.atan2(y, x)) * out

    meshes[0].warp(wobble)
    bow = plain(c[1], 0.05)
    for q in (-1, 1):
        tail = [(0.03 * q, -0.093, 0.045), (0.05 * q, -0.12, 0.03), (0.06 * q, -0.16, 0.025)]
        meshes.append(tube(np.array(tail), 0.014, 4, mat=bow, flatten=0.25, up=(0, 0, 1)))
        meshes.append(ellipsoid((0.026, 0.009, 0.016), (0.024 * q, -0.1, 0.046), 6, 4, bow))
    return meshes


def _fedora(c: list[str], offset) -> list[Mesh]:
    brim = [(0, 0.004), (0.08, 0.004), (0.145, 0.0), (0.149, 0.003), (0.145, 0.006), (0.088, 0.01)]
    crown = [
        (0.086, 0.012),
        (0.084, 0.042),
        (0.082, 0.05),
        (0.076, 0.1),
        (0.066, 0.122),
        (0.04, 0.124),
    ]
    crown.append((0, 0.108))
    meshes = _crowned(crown, brim, plain(c[0], 0.07, 50, offset), plain(c[1], 0.03))

    def pinch(x: float, y: float, z: float) -> tuple[float, float, float]:
        high = max(0.0, (z - 0.06) / 0.06)
        dent = 0.022 * high * math.exp(-((y / 0.02) ** 2)) * (1 if math.hypot(x, y) < 0.07 else 0)
        squeeze = 1 - 0.3 * high * max(0.0, x / 0.08)
        return x, y * squeeze, z - dent

    meshes[0].warp(pinch)
    _brim_bend(meshes, 0.09, 0.025, 0.012)
    meshes.append(ellipsoid((0.006, 0.008, 0.016), (-0.01, 0.083, 0.034), 6, 4, plain(c[1], 0.03)))
    return meshes


def _cowboy(c: list[str], offset) -> list[Mesh]:
    brim = [(0, 0.006), (0.08, 0.006), (0.13, 0.0), (0.172, 0.004), (0.172, 0.01), (0.13, 0.007)]
    brim.append((0.09, 0.012))
    crown = [
        (0.088, 0.014),
        (0.086, 0.036),
        (0.085, 0.05),
        (0.08, 0.11),
        (0.07, 0.14),
        (0.04, 0.146),
    ]
    crown.append((0, 0.13))
    meshes = _crowned(crown, brim, plain(c[0], 0.09, 40, offset), plain(c[1], 0.04), 20)

    def shape(x: float, y: float, z: float) -> tuple[float, float, float]:
        high = max(0.0, (z - 0.06) / 0.08)
        dent = 0.03 * high * math.exp(-((y / 0.022) ** 2))
        return x, y * (1 - 0.25 * high * max(0.0, x / 0.08)), z - dent

    meshes[0].warp(shape)
    _brim_bend(meshes, 0.095, 0.075, 0.012)
    return meshes


def _top_hat(c: list[str], offset) -> list[Mesh]:
    brim = [(0, 0.004), (0.08, 0.004), (0.14, 0.0), (0.144, 0.004), (0.14, 0.008), (0.086, 0.01)]
    crown = [
        (0.084, 0.012),
        (0.082, 0.05),
        (0.08, 0.054),
        (0.083, 0.12),
        (0.092, 0.16),
        (0.088, 0.164),
    ]
    crown.append((0, 0.164))
    meshes = _crowned(crown, brim, plain(c[0], 0.05, 40, offset), plain(c[1], 0.03))
    _brim_bend(meshes, 0.09, 0.03, 0.006)
    return meshes


def _bucket(c: list[str], offset) -> list[Mesh]:
    brim = [(0, 0.05), (0.09, 0.048), (0.142, 0.0), (0.147, 0.002), (0.146, 0.008), (0.1, 0.055)]
    crown = [(0.099, 0.058), (0.097, 0.07), (0.084, 0.128), (0.076, 0.136), (0, 0.138)]
    cloth = plain(c[0], 0.09, 90, offset)
    meshes = _crowned(crown, brim, cloth, plain(shade(c[0], 0.8), 0.05), 18)
    for z, r in ((0.02, 0.125), (0.036, 0.113)):
        meshes.append(_hoop(r, z, 0.003, plain(c[1], 0.03), 14))
    return meshes


def _hoop(r: float, z: float, thick: float, mat: Material, n: int = 14, sides: int = 3) -> Mesh:
    return tube(ring(n, r, r, z), thick, sides, closed=True, mat=mat, weight=0.5)


def _beanie(c: list[str], offset) -> list[Mesh]:
    knit = Material()
    angle = knit.math("ARCTAN2", knit.axis(1), knit.axis(0))
    rib = knit.remap(knit.math("SINE", knit.math("MULTIPLY", angle, 26)), -0.6, 0.6, 0, 0.5)
    z = knit.axis(2)
    stripe = knit.math("MULTIPLY", knit.remap(z, 0.085, 0.087), knit.remap(z, 0.118, 0.12, 1, 0))
    base = knit.mix(stripe, c[0], c[1])
    knit.colour(knit.mix(rib, base, shade(c[0], 0.55)))
    cuff = Material()
    a = cuff.math("ARCTAN2", cuff.axis(1), cuff.axis(0))
    lines = cuff.remap(cuff.math("SINE", cuff.math("MULTIPLY", a, 26)), -0.4, 0.6, 0, 0.6)
    cuff.colour(cuff.mix(lines, c[1], shade(c[1], 0.6)))
    profile = [(0, 0.0), (0.098, 0.0), (0.108, 0.012), (0.108, 0.05), (0.1, 0.06), (0.1, 0.066)]
    profile += [(0.102, 0.1), (0.092, 0.14), (0.066, 0.172), (0.03, 0.188), (0, 0.19)]
    body = lathe(
        profile, 18, mats=[knit, cuff], mat_of_segment=[1, 1, 1, 1, 0, 0, 0, 0, 0, 0], discs=False
    )
    fluff = Material()
    f = fluff.noise(190, 3, 0.7, offset=offset)
    fluff.colour(fluff.mix(fluff.remap(f, 0.35, 0.65), shade(c[2], 0.75), shade(c[2], 1.1)))
    pom = ellipsoid(0.038, (0, 0, 0.215), 10, 7, fluff)
    pom.warp(lambda x, y, q: (x * (1 + 0.06 * math.sin(90 * q)), y, q + 0.003 * math.sin(80 * x)))
    return [body, pom]


def _cap(c: list[str], offset) -> list[Mesh]:
    """A baseball cap: panelled dome, long peak to the front, a badge."""
    cloth, peak_mat = plain(c[0], 0.05, 90, offset), plain(c[1], 0.05, 90, offset)
    profile = [(0, 0.0), (0.09, 0.0), (0.094, 0.004), (0.094, 0.04), (0.086, 0.078), (0.064, 0.105)]
    profile += [(0.034, 0.12), (0, 0.124)]
    dome = lathe(profile, 18, mat=cloth, discs=False)
    dome.warp(lambda x, y, z: (x * 1.12, y * 0.92, z + (0.012 * x / 0.09 if z > 0.05 else 0)))
    n = 9
    t = np.linspace(-1, 1, n)
    inner = np.c_[0.105 * np.sqrt(np.clip(1 - (t * 0.9) ** 2, 0, 1)) - 0.01, t * 0.078]
    outer = np.c_[0.105 + 0.078 * np.sqrt(np.clip(1 - t**4, 0, 1)) * (1 - 0.0 * t), t * 0.08]
    outer[0], outer[-1] = inner[0] + [0.004, 0], inner[-1] + [0.004, 0]

    def level(p: np.ndarray, up: float) -> np.ndarray:
        drop = 0.018 * (p[:, 1] / 0.08) ** 2 + 0.05 * np.clip(p[:, 0] - 0.1, 0, 1)
        return np.c_[p, 0.02 - drop + up]

    rings = [
        [level(inner, 0.006)[i], level(outer, 0.006)[i], level(outer, 0.0)[i], level(inner, 0.0)[i]]
        for i in range(n)
    ]
    peak = loft(rings, peak_mat)
    button = ellipsoid((0.009, 0.009, 0.005), (0, 0, 0.125), 6, 4, peak_mat)
    badge = ellipsoid((0.008, 0.026, 0.02), (0.096, 0, 0.066), 8, 5, plain(c[2], 0.0))
    badge.turn(ry=-0.35, pivot=(0.096, 0, 0.066))
    meshes = [dome, peak, button, badge]
    low = min(float(m.v[:, 2].min()) for m in meshes)
    seam = plain(shade(c[0], 0.65), 0.0)
    for k in range(3):
        a = math.pi * k / 3 + math.pi / 6
        path = [
            (r * math.cos(a) * 1.12 * 1.005, r * math.sin(a) * 0.92 * 1.005, z + 0.001)
            for r, z in ((0.094, 0.035), (0.086, 0.078), (0.064, 0.106), (0, 0.125))
        ]
        full = path + [(-x, -y, z) for x, y, z in path[-2::-1]]
        full = [(x, y, z + (0.012 * x / 0.1 if z > 0.05 else 0)) for x, y, z in full]
        meshes.append(tube(np.array(full), 0.0018, 3, mat=seam, weight=0.4))
    return [m.move(z=-low) for m in meshes]


_KINDS = {
    "sun hat": _sun_hat,
    "felt hat": _fedora,
    "cowboy hat": _cowboy,
    "top hat": _top_hat,
    "bucket hat": _bucket,
    "woolly hat": _beanie,
    "baseball cap": _cap,
}


def hat(kind: str, colours: list[str], seed: int) -> Model:
    """A hat of one of `_KINDS`; colours: cloth, band or peak, trimming."""
    meshes = _KINDS[kind](colours, noise_offset(np.random.default_rng(seed)))
    low = min(float(m.v[:, 2].min()) for m in meshes)
    for m in meshes:
        m.move(z=-low)
    points = np.concatenate([m.v for m in meshes])
    height = float(points[:, 2].max())
    brim = points[points[:, 2] < height * 0.4]
    top = points[np.hypot(points[:, 0], points[:, 1]) < 0.11]
    part = Part(meshes, collision=[few_corners(brim, 26), few_corners(top, 26)])
    return Model(kind, {"body": part}, mass=0.15, friction=0.8, texture_size=128)


def hat_random(rng: np.random.Generator) -> dict:
    return {
        "kind": pick(rng, list(_KINDS)),
        "colours": pick(
            rng, [["#2f5f94", "#c8302c", "#f2f0ea"], ["#4a4038", "#1f1c1a", "#e0d8c8"]]
        ),
        "seed": seed_of(rng),
    }


MODELS = {
    "hat": Maker(
        hat,
        hat_random,
        8,
        [
            {"kind": "sun hat", "colours": ["#e2c482", "#b8303a", ""]},
            {"kind": "baseball cap", "colours": ["#2f4f8a", "#b8242c", "#f4f2ea"]},
            {"kind": "woolly hat", "colours": ["#b8303a", "#f2efe6", "#f2efe6"]},
            {"kind": "felt hat", "colours": ["#6a5644", "#2a211c", ""]},
            {"kind": "cowboy hat", "colours": ["#a8713f", "#4a2c18", ""]},
            {"kind": "top hat", "colours": ["#232326", "#8a1f2c", ""]},
            {"kind": "bucket hat", "colours": ["#7a8f5a", "#dfe0c8", ""]},
            {"kind": "baseball cap", "colours": ["#2a2b2f", "#2a2b2f", "#e0b83a"]},
        ],
    ),
}
