"""Bananas, single or in a hand; fresh, overripe and rotten."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import Material, plain
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model
from toolkit.sampling import noise_offset, seed_of, uniform
from toolkit.shapes import loft, tube

from makers import produce_faces as faces
from makers.produce_kit import cut_face, ground, halve, leaf, matured, one_hull, spread
from makers.spoilage import MOULD, MOULD_GREEN, aged


def banana(length=0.19, count=1, ripeness=0.15, seed=0, form="lying", tint="") -> Model:
    """One banana on its side, a hand of several, standing ones, one peeled, or one cut.

    form: lying, standing (on their tips and stalk), apart, peeled, cut. tint: of unripe skin.
    """
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
        if tint:
            c = m.mix(0.75, c, tint)
        spots = m.math(
            "ADD",
            m.voronoi(130, o, (1, 0.5, 1)),
            m.math("MULTIPLY", m.noise(160, 2, offset=o), 0.5),
        )
        c = m.mix(m.remap(spots, 0.22 + ripeness, 0.3 + ripeness, 0.85, 0), c, "6b421a")
        if look == "overripe":  # freckled, and plainly good to eat
            c = m.mix(0.12, c, "c89a2c")
            c = m.mix(m.remap(m.voronoi(85, (o[2], 0, 1)), 0.22, 0.32, 0.9, 0), c, "5a3814")
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
        rings, m = [], 13 if count < 4 else 9
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

    def apart(look: str) -> list[Mesh]:
        """Two, one beside the other."""
        meshes = [m.keep_pattern() for m in one(skin(look), 8, look)]
        return spread(meshes, [(0.05 * s, 0, 0, 0.2), (-0.015 * s, 0.01, 0, 0.45)])

    def peeled(look: str) -> list[Mesh]:
        """Half out of its skin, three strips of which hang down."""
        inside = Material(occlusion=0.8)
        c = inside.mix(inside.remap(inside.noise(30, 3, offset=o), 0.35, 0.65), "f6e8b8", "fcf6d8")
        inside.colour(matured(look, inside, c, 0.02, [(0, 0.03, 0.03), (-0.03, 0.07, 0.03)], o))
        mat = skin(look)
        body, _, stalk = one(mat, 10, look)
        rings = body.v.reshape(13, 10, 3)
        lower = loft(rings[:8], mat=mat)
        flesh = rings[6:].copy()
        flesh = flesh.mean(1)[:, None] + (flesh - flesh.mean(1)[:, None]) * 0.84
        out = [lower, loft(flesh, mat=inside), stalk]
        at = rings[7].mean(0)
        for yaw, lift in ((-0.9, -0.05), (2.6, -0.05), (0.9, 0.45)):
            strip = leaf(0.085 * s, 0.03 * s, mat, lift if lift > 0 else 0.12).turn(rz=yaw)
            x, y, z = at
            up = 0.012 if lift > 0 else -0.006
            strip.move(x + 0.006 * math.cos(yaw), y + 0.006 * math.sin(yaw), z + up)
            out.append(strip)
        return out

    def cut(look: str) -> list[Mesh]:
        """One half, and slices of the other."""
        image, d = faces.round_face("#e8c43a", "#faf2cc")
        faces.disc(d, 0.4, "#f4e4a8")
        for i in range(3):
            a = math.tau * i / 3
            faces.disc(d, 0.09, "#5a4424", 0.09, 0.5 + 0.09 * math.cos(a), 0.5 + 0.09 * math.sin(a))
        face = cut_face(look, image, 0.02, [(0, 0.005, 0.02, 0.6)], o)
        body, _, stalk = one(skin(look), 10, look)
        half = halve(body, (0, 0.005, 0), (0, 1, 0), face)
        coin = halve(body, (0, 0.004, 0), (0, 1, 0), face)
        coin = halve(coin, (0, -0.004, 0), (0, -1, 0), face, up=(0, 0, -1)).keep_pattern()
        coin = ground([coin.turn(rx=math.pi / 2).move(-coin.v[:, 0].mean())])
        places = [(0.045, 0.01, 0, 0.3), (0.03, 0.05, 0, 1.2), (0.055, 0.045, 0.006, 2.0, 0.15)]
        out = [m.keep_pattern() for m in (half, stalk)]
        return ground(out) + spread(coin, places)

    def shape(look: str) -> list[Mesh]:
        if form in ("apart", "peeled", "cut"):
            return {"apart": apart, "peeled": peeled, "cut": cut}[form](look)
        mat, group = skin(look), []
        for i in range(count):
            meshes = one(mat, (10 if count < 2 else 8 if count < 4 else 6), look)
            for mesh in meshes:
                if form == "standing":
                    fan = 0.13 * (i - (count - 1) / 2)
                    mesh.keep_pattern().turn(ry=-math.pi / 2).turn(rz=math.pi)
                    mesh.turn(rz=fan, pivot=(0, -0.12 * s, 0)).move(x=0.031 * s * (i - 1))
                    continue
                if count > 3:
                    mesh.keep_pattern()
                if count > 1:  # fan about the common stalk
                    mesh.turn(rz=0.16 * (i - 1), pivot=(-0.09 * s, -0.11 * s, 0)).move(
                        -0.03 * s * i
                    )
            group += meshes
        return group

    def solids(group: list[Mesh]) -> list[np.ndarray]:
        """Three stretches of every banana, set flat on the ground."""
        if form in ("peeled", "cut", "standing"):
            return one_hull(group)
        out = []
        for body in group[::3]:
            rings = np.array_split(body.v, 13 if count < 4 else 9)
            for part in (rings[:5], rings[4:-4], rings[-5:]):
                points = np.concatenate(part)
                foot = points[:: max(1, len(points) // 12)] * [1, 1, 0]
                middle = foot.mean(0)
                out.append(np.concatenate([points, middle + (foot - middle) * 0.8]))
        return out

    title = "banana" if count == 1 else f"hand of {count} bananas"
    title = {"peeled": "peeled banana", "cut": "cut banana", "apart": "two bananas"}.get(
        form, title
    )
    mass = {"apart": 0.26, "cut": 0.09}.get(form, 0.13 * count)
    return aged(title, shape, mass, solids, 256 if form == "lying" else 128)


def banana_random(rng: np.random.Generator) -> dict:
    return {
        "length": uniform(rng, 0.17, 0.2),
        "ripeness": uniform(rng, -0.12, -0.02),
        "seed": seed_of(rng),
    }


MODELS = {
    "banana": Maker(
        banana,
        banana_random,
        count=7,
        presets=[
            {"count": 1},
            {"count": 3},
            {"count": 5, "length": 0.18, "seed": 3},
            {"form": "peeled", "length": 0.19, "seed": 4},
            {"form": "standing", "count": 3, "length": 0.19, "seed": 5},
            {"form": "cut", "length": 0.19, "seed": 6},
            {"form": "apart", "length": 0.185, "seed": 7, "tint": "9ab83a"},
        ],
    ),
}
