"""What is spilled dry: flour and rice, in a heap that runs out into a fan."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import Material, plain, shade
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part
from toolkit.sampling import noise_offset
from toolkit.shapes import box, loft


def fan(rng: np.random.Generator, radius: float, spread: float, n: int):
    """How far a heap reaches at an angle: farthest to one side, ragged all round."""
    phase, way = rng.uniform(0, 6.28, 4), float(rng.uniform(0, 6.28))

    def reach(a: float) -> float:
        rough = sum(
            s * math.sin(f * a + p)
            for s, f, p in zip((0.1, 0.08, 0.07, 0.05), (3, 5, 8, 13), phase, strict=True)
        )
        return radius * (1 + rough + spread * max(0.0, math.cos(a - way)) ** 2)

    return [reach(math.tau * i / n) for i in range(n)]


def heap(edge: list[float], levels, mat: Material) -> Mesh:
    """A low mound: shares of its edge and heights, from the floor to its top."""
    n = len(edge)
    rings = [
        [
            (share * q * math.cos(math.tau * i / n), share * q * math.sin(math.tau * i / n), z)
            for i, q in enumerate(edge)
        ]
        for share, z in levels
    ]
    mesh = loft(rings, mat=mat)
    mesh.bake_uv = [[(float(mesh.v[i][0]), float(mesh.v[i][1])) for i in f] for f in mesh.f]
    under = next(k for k, f in enumerate(mesh.f) if len(f) > 4 and mesh.v[f[0]][2] == 0)
    mesh.keep_faces([k for k in range(len(mesh.f)) if k != under])
    return mesh


def model(title: str, meshes: list[Mesh], mass: float) -> Model:
    return Model(
        title=title,
        parts={"grains": Part(meshes, collision="hull")},
        states=[{"state": "SPILLED", "variants": ["default"], "parts": ["grains"]}],
        mass=mass,
        friction=0.3,
        texture_size=128,
        prune=False,
        smooth_deg=70,
    )


def flour_spill(radius=0.1, spread=0.9, tone="#f7f3ea", seed=0) -> Model:
    """A drift of flour: a soft heap with furrows, thin at its ragged edge, clots around it.

    What is white all over looks flat: the slopes away from the light are painted darker.
    """
    rng = np.random.default_rng(seed)
    o = noise_offset(rng)
    powder = Material(occlusion=0.9)
    lumps = powder.remap(powder.noise(60, 4, 0.6, offset=o), 0.34, 0.66)
    c = powder.mix(lumps, shade(tone, 0.9), tone)
    slope = powder.math(
        "ADD",
        powder.math("MULTIPLY", powder.normal(0), 0.8),
        powder.math("MULTIPLY", powder.normal(1), -0.6),
    )
    c = powder.mix(powder.remap(slope, 0.0, 0.3, 0, 0.6), c, "b9ae9c")
    powder.colour(powder.mix(powder.remap(slope, -0.05, -0.3, 0, 0.8), c, "ffffff"))
    edge = [q * float(rng.uniform(0.88, 1.12)) for q in fan(rng, radius, spread, 44)]
    soft = [float(np.mean([edge[(i + k) % 44] for k in range(-3, 4)])) for i in range(44)]
    levels = [(1.0, 0.0), (0.9, 0.003), (0.62, 0.009), (0.34, 0.022), (0.1, 0.028)]
    mesh = heap(edge, levels, powder)
    away = {k: soft[k % 44] / edge[k % 44] for k in range(len(mesh.v))}
    for k in range(2 * 44, len(mesh.v)):  # ragged below, round above
        mesh.v[k][:2] *= away[k]
    meshes = [mesh]
    for _ in range(24):
        a, far = rng.uniform(0, math.tau), 1.05 + min(0.5, abs(float(rng.normal(0, 0.3))))
        q = edge[int(a / math.tau * len(edge)) % len(edge)] * far
        small = fan(rng, float(rng.uniform(0.003, 0.009)), 0.5, 6)
        clot = heap(small, [(1, 0), (0.5, 0.004)], powder)
        meshes.append(clot.move(q * math.cos(a), q * math.sin(a)))
    return model("spilled flour", meshes, 0.25)


def rice_spill(radius=0.08, spread=0.7, tone="#f4eedc", seed=0) -> Model:
    """A heap of rice and single grains strewn around it."""
    rng = np.random.default_rng(seed)
    o = noise_offset(rng)
    pile = Material(occlusion=0.9)
    grains = pile.voronoi(105, o, (1, 0.5, 1))
    c = pile.mix(pile.remap(grains, 0.3, 0.62), tone, shade(tone, 0.72))
    pile.colour(pile.mix(pile.remap(grains, 0.66, 0.9), c, shade(tone, 0.56)))
    edge = fan(rng, radius, spread, 28)
    meshes = [heap(edge, [(1.0, 0.0), (0.93, 0.005), (0.55, 0.017), (0.2, 0.026)], pile)]
    single = plain(tone, 0.06, 90, o)
    for _ in range(42):
        a = rng.uniform(0, math.tau)
        q = edge[int(a / math.tau * len(edge)) % len(edge)] * (1.0 + abs(rng.normal(0, 0.3)))
        grain = box(0.0125, 0.0045, 0.0035, mat=single).turn(rz=rng.uniform(0, 3.14))
        meshes.append(grain.move(q * math.cos(a), q * math.sin(a)))
    return model("spilled rice", meshes, 0.2)


def drawn(rng: np.random.Generator) -> dict:
    return {"seed": 1}


MODELS = {
    "flour_spill": Maker(
        flour_spill,
        drawn,
        count=3,
        presets=[
            {"seed": 1},
            {"radius": 0.065, "spread": 0.8, "seed": 2},
            {"radius": 0.09, "spread": 0.3, "seed": 3},
        ],
    ),
    "rice_spill": Maker(
        rice_spill,
        drawn,
        count=3,
        presets=[
            {"seed": 1},
            {"radius": 0.06, "spread": 1.2, "seed": 2},
            {"tone": "#d0a468", "seed": 1},
        ],
    ),
}
