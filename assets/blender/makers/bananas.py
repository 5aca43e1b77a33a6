"""Bananas, single or in a hand; fresh, overripe and rotten."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import Material, plain
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model
from toolkit.sampling import noise_offset, seed_of, uniform
from toolkit.shapes import loft, tube

from makers.spoilage import MOULD, MOULD_GREEN, aged


def banana(length=0.19, count=1, ripeness=0.15, seed=0) -> Model:
    """One banana on its side, or a hand of several."""
    rng = np.random.default_rng(seed)
    o = noise_offset(rng)
    s = length / 0.19

    def skin(look: str) -> Material:
        m = Material()
        c = m.mix(m.remap(m.noise(14, 3, offset=o), 0.3, 0.7), "f0c62c", "f7d94e")
        ends = m.math(
            "MAXIMUM",
            m.remap(m.axis(1), 0.05 * s, 0.085 * s),
            m.remap(m.axis(1), -0.05 * s, -0.08 * s),
        )
        c = m.mix(m.math("MULTIPLY", ends, 0.6), c, "a8b04a")
        spots = m.math(
            "ADD",
            m.voronoi(130, o, (1, 0.5, 1)),
            m.math("MULTIPLY", m.noise(160, 2, offset=o), 0.5),
        )
        c = m.mix(m.remap(spots, 0.22 + ripeness, 0.3 + ripeness, 0.85, 0), c, "6b421a")
        if look == "overripe":  # brown freckles and streaks over dull yellow
            c = m.mix(0.3, c, "a87a24")
            c = m.mix(m.remap(m.voronoi(85, (o[2], 0, 1)), 0.3, 0.42, 0.95, 0), c, "3d2410")
            streaks = m.noise(30, 3, offset=(o[1], 2, o[0]), stretch=(1, 0.4, 1))
            c = m.mix(m.remap(streaks, 0.5, 0.6, 0, 0.8), c, "5a3716")
        if look == "rotten":
            c = m.mix(
                m.remap(m.noise(16, 4, offset=(o[1], o[0], 1)), 0.36, 0.5, 0.75, 0.96), c, "2a190c"
            )
            c = m.mix(m.remap(m.voronoi(60, (o[2], 0, 1)), 0.2, 0.3, 0.9, 0), c, "1c100a")
            near = None
            for y in (-0.06, 0.0, 0.055):
                d = m.distance((-0.03 * abs(y) / 0.06 * s, y * s, 0.03), (0.6, 1, 0.5))
                near = d if near is None else m.math("MINIMUM", near, d)
            fuzz = m.math("ADD", near, m.math("MULTIPLY", m.noise(110, 4, offset=o), 0.03))
            c = m.mix(m.remap(fuzz, 0.031, 0.035, 1, 0), c, MOULD)
            c = m.mix(m.remap(fuzz, 0.021, 0.026, 0.9, 0), c, MOULD_GREEN)
        return m.colour(c)

    dark = plain("3a2412", 0.15, 200)

    def one(mat: Material, n: int, look: str) -> list[Mesh]:
        # bent in the xy plane, lying on its side; the bulge points to +x
        reach, bend = 0.105 * s, 1.15
        rings, m = [], 13
        widths = np.interp(
            np.linspace(0, 1, m),
            [0, 0.06, 0.18, 0.35, 0.7, 0.88, 0.96, 1],
            [0.45, 0.42, 0.6, 0.95, 1.0, 0.7, 0.4, 0.3],
        )
        for t, w in zip(np.linspace(-1, 1, m), widths, strict=True):
            a = t * bend
            cx, cy = reach * (math.cos(a) - 1) * 0.9, reach * math.sin(a)
            radial, r = (
                np.array([math.cos(a), math.sin(a), 0]),
                0.0175 * s * w * (0.86 if look == "rotten" else 0.95 if look == "overripe" else 1),
            )
            ring = []
            for k in range(n):
                q = 2 * math.pi * k / n
                rr = r * (1 + 0.05 * math.cos(5 * q))
                ring.append(
                    np.array([cx, cy, 0])
                    + radial * rr * math.cos(q)
                    + np.array([0, 0, rr * math.sin(q)])
                )
            rings.append(np.array(ring))
        body = loft(rings, mat=mat)
        tip = tube(
            [
                rings[-1].mean(0) - [0, 0.002 * 0, 0],
                rings[-1].mean(0) + np.array([-math.sin(bend), math.cos(bend), 0]) * 0.006 * s,
            ],
            [0.0056 * s, 0.0035 * s],
            6,
            mat=dark,
        )
        start = rings[0].mean(0)
        back = np.array([-math.sin(bend), -math.cos(bend), 0])
        stalk = tube(
            [start, start + back * 0.012 * s, start + back * 0.022 * s],
            [0.0078 * s, 0.0062 * s, 0.007 * s],
            6,
            mat=mat,
        )
        return [body, tip, stalk]

    def shape(look: str) -> list[Mesh]:
        mat, group = skin(look), []
        for i in range(count):
            meshes = one(mat, 8 if count > 1 else 10, look)
            for mesh in meshes:
                if count > 1:  # fan about the common stalk
                    mesh.turn(rz=0.16 * (i - 1), pivot=(-0.09 * s, -0.11 * s, 0)).move(
                        -0.03 * s * i
                    )
            group += meshes
        return group

    def solids(group: list[Mesh]) -> list[np.ndarray]:
        """Three stretches of every banana, set flat on the ground."""
        out = []
        for body in group[::3]:
            rings = np.array_split(body.v, 13)
            for part in (rings[:5], rings[4:9], rings[8:]):
                points = np.concatenate(part)
                foot = points[:: max(1, len(points) // 12)] * [1, 1, 0]
                middle = foot.mean(0)
                out.append(np.concatenate([points, middle + (foot - middle) * 0.8]))
        return out

    title = "banana" if count == 1 else f"hand of {count} bananas"
    return aged(title, shape, 0.13 * count, solids)


def banana_random(rng: np.random.Generator) -> dict:
    return {
        "length": uniform(rng, 0.17, 0.2),
        "ripeness": uniform(rng, -0.12, -0.02),
        "seed": seed_of(rng),
    }


MODELS = {
    "banana": Maker(banana, banana_random, count=2, presets=[{"count": 1}, {"count": 3}]),
}
