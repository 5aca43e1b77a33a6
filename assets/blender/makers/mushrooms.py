"""Mushrooms and broccoli; fresh, overripe and rotten."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import Material, plain
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model
from toolkit.sampling import noise_offset, seed_of
from toolkit.shapes import ellipsoid, lathe, tube

from makers import produce_faces as faces
from makers.produce_kit import (
    cut_face,
    footed,
    fresh_produce,
    ground,
    halve,
    layout,
    leaf,
    matured,
    one_hull,
    patches,
    punnet,
    skin,
    spread,
)

# White button mushrooms would be eggs to whoever sees them from afar: these are buff.
CAPS = {"white": ("c09a6c", "e2cba4"), "brown": ("8a6038", "a87c4c"), "dark": ("5a3c24", "7a5634")}


def mushroom_face():
    """The section of a mushroom: white flesh, brown gills, the background in the cap's colour."""
    image, d = faces.labels.canvas(faces.N, faces.N, "#efe6d4")
    n = faces.N
    d.chord((8, 6, n - 8, n * 1.15), 180, 360, fill="#fffdf4")
    for side in (-1, 1):
        x = n / 2 + side * n * 0.29
        d.ellipse((x - n * 0.17, n * 0.46, x + n * 0.17, n * 0.62), fill="#7a5034")
    d.rectangle((n * 0.39, n * 0.4, n * 0.61, n), fill="#fffdf4")
    return image


def mushrooms(form="three", kind="white", cap=0.03, seed=0) -> Model:
    """Mushrooms with a domed cap on a stout stem: one, some, a tray, halves, upside down."""
    rng = np.random.default_rng(seed)
    o, r = noise_offset(rng), cap
    flat = form in ("flat", "upturned")
    tall = 0.55 if flat else 0.8 if kind == "white" else 0.95
    # height of the cap's rim; under pale caps, which could be eggs, more of the stem shows
    hs = r * (0.55 if flat else 1.1 if kind == "white" else 0.85)
    spots = patches(r, hs + r * 0.25, seed)
    fine = form in ("one", "flat", "upturned", "half")
    n = 14 if fine else 8 if form == "tray" else 9

    def one(look: str) -> list[Mesh]:
        k = {"fresh": 1.0, "overripe": 0.95, "rotten": 0.86}[look]
        coat = skin(look, CAPS[kind], r, spots, o, 40, brown="2f2014", amount=0.5)
        gills = Material(occlusion=0.8)
        c = gills.mix(gills.remap(gills.noise(300, 2, offset=o), 0.4, 0.6), "5a3a26", "8f6648")
        gills.colour(matured(look, gills, c, r, spots, o, amount=0.6))
        arc = [(math.cos(a) * r, hs + math.sin(a) * r * tall * k) for a in (0.0, 0.4, 0.8, 1.2)]
        rim = [(r * 0.3, hs + r * 0.06), (r * 0.86, hs - r * 0.13), (r * 0.98, hs - r * 0.06)]
        profile = [(0, hs), *rim, *arc, (0, hs + r * tall * k)]
        hat = lathe(profile, n, mats=[coat, gills], mat_of_segment=[1, 1, 0, 0, 0, 0, 0, 0])
        hat.bake_uv = hat.bake_uv
        stem_r = r * (0.3 if flat else 0.42 if kind == "white" else 0.38)
        pale = plain({"fresh": "f4eee0", "overripe": "c8b088", "rotten": "6a5438"}[look], 0.1, 150)
        stem = lathe(
            [
                (0, 0),
                (stem_r * 1.05, 0.001),
                (stem_r * 0.9, hs * 0.5),
                (stem_r, hs + r * 0.1),
                (0, hs),
            ],
            max(7, n * 2 // 3),
            mat=pale,
        )
        return [hat, stem]

    def half(look: str) -> list[Mesh]:
        face = cut_face(look, mushroom_face(), r, [(r * 0.4, 0, hs + r * 0.4, 0.7)], o)
        hat, stem = one(look)
        hat = halve(hat, (0, 0.0005, 0), (0, 1, 0), face)
        low, high = hat.v[:, 2].min(), hat.v[:, 2].max()
        # the picture spans the whole mushroom; the cap shows its upper part
        share = (low - 0.0) / high
        hat.label_uv[-1] = [(u, share + v * (1 - share)) for u, v in hat.label_uv[-1]]
        pale = cut_face(look, faces.plain_face("#efe6d4", "#fffdf4"), r, [(0, 0, 0, 0.3)], o)
        stem = halve(stem, (0, 0.0012, 0), (0, 1, 0), pale)
        return [m.keep_pattern() for m in (hat, stem)]

    def shape(look: str) -> list[Mesh]:
        if form in ("one", "flat"):
            return one(look)
        if form == "upturned":
            return ground([m.turn(rx=math.pi - 0.25) for m in one(look)])
        if form == "half":
            flat_ = ground([m.turn(rx=math.pi / 2) for m in half(look)])
            up = ground([m.turn(ry=0.0).turn(rz=-math.pi / 2 + 0.1) for m in half(look)])
            return spread(up, [(-r * 0.2, -r * 1.2, 0, 0.2)]) + spread(
                flat_, [(r * 0.4, r * 1.25, 0, 1.9)]
            )
        if form == "three":
            tilted = ground([m.keep_pattern().turn(rx=math.pi - 0.45) for m in one(look)])
            return spread(one(look), layout("pair", r * 1.04)) + spread(
                tilted, [(r * 2.1, r * 0.2, 0, 2.2)]
            )
        if form == "tray":
            places = [
                ((i - 0.5) * r * 1.9, (j - 1) * r * 1.9, 0.0, 1.3 * i + j)
                for i in range(2)
                for j in range(3)
            ]
            over = ground([m.keep_pattern().turn(rx=math.pi - 0.3) for m in one(look)])
            blue = plain("3f78b8", 0.08, 120)
            shell = punnet(r * 4.2, r * 6.1, r * 1.05, blue)
            # every other one shows its gills and its stem
            return [*spread(one(look), places[::2]), *spread(over, places[1::2]), shell]
        places = [(x, y, z, yaw) for x, y, z, yaw in layout("five", r * 1.0)]
        return spread(one(look), places[:4]) + spread(
            ground([m.keep_pattern().turn(rx=0.5) for m in one(look)]), [(0, 0, r * 1.35, 0.3)]
        )

    title = {"one": "mushroom", "flat": "large flat mushroom", "tray": "tray of mushrooms"}
    mass = {"one": 0.03, "flat": 0.08, "upturned": 0.08, "three": 0.06, "tray": 0.25}
    solids = one_hull if form in ("tray", "half") else footed
    return fresh_produce(title.get(form, "mushrooms"), shape, mass.get(form, 0.05), solids)


def mushrooms_random(rng: np.random.Generator) -> dict:
    return {"seed": seed_of(rng)}


def bury(meshes: list[Mesh]) -> None:
    """Drop faces of blobs well inside another one (which saves the search for them)."""
    blobs = [m for m in meshes if len(m.v) == 34]
    middles = [m.v.mean(0) for m in blobs]
    radius = min(np.linalg.norm(m.v - c, axis=1).min() for m, c in zip(blobs, middles, strict=True))
    for i, mesh in enumerate(blobs):
        others = np.array([c for j, c in enumerate(middles) if j != i])
        keep = [
            k
            for k, f in enumerate(mesh.f)
            if np.linalg.norm(others - mesh.v[list(f)].mean(0), axis=1).min() > radius * 0.97
        ]
        mesh.keep_faces(keep)


def broccoli(form="head", size=1.0, seed=0) -> Model:
    """A thick pale stalk that branches into a knobbly dark green crown; or florets cut from one."""
    rng = np.random.default_rng(seed)
    o, s = noise_offset(rng), size
    r = 0.062 * s
    spots = [*patches(r * 1.25, 0.1 * s, seed), (0, 0, 0.155 * s, 0.7)]
    spots += [(r * math.cos(a), r * math.sin(a), 0.075 * s, 0.6) for a in (0.0, 2.1, -2.0, -1.1)]
    small = [
        (0.026, 0.008, 0.036),
        (-0.02, 0.02, 0.036, 0.9),
        (0.0, -0.026, 0.034),
        (0, 0, 0.058, 0.8),
    ]

    def knobs(look: str, patchy, width: float) -> Material:
        m = Material()
        buds = m.voronoi(150, o)
        c = m.mix(m.remap(buds, 0.1, 0.5), "5f9a3c", "1c4a1c")
        c = m.mix(m.remap(m.noise(30, 2, offset=o), 0.4, 0.65, 0, 0.6), c, "2f6a2a")
        if look != "fresh":  # broccoli turns yellow; brown and green it passes for a small tree
            c = m.mix(
                m.remap(m.noise(26, 3, offset=(o[1], 1, 2)), 0.38, 0.56, 0.25, 0.95), c, "d0b83a"
            )
        return m.colour(matured(look, m, c, width * 1.15, patchy, o, "4a3414", 0.2))

    def blob(at, q: float, mat, n: int, m: int) -> Mesh:
        mesh = ellipsoid((q, q, q * 0.86), (0, 0, 0), n, m, mat)
        a, b, c = rng_of(at)
        mesh.warp(
            lambda x, y, z: tuple(
                np.array([x, y, z])
                * (
                    1
                    + 0.1 * math.sin(230 / s * x + a) * math.sin(230 / s * y + b)
                    + 0.05 * math.sin(190 * z + c)
                )
            )
        )
        return mesh.move(*at)

    def rng_of(at) -> np.ndarray:
        return np.random.default_rng([seed, *(int(abs(v) * 1e5) for v in at)]).uniform(0, 6, 3)

    def pale(look: str) -> Material:
        tone = {"fresh": "a8c878", "overripe": "c8b868", "rotten": "a8904c"}[look]
        return plain(tone, 0.14, 90)

    def head(look: str, count: int = 10) -> list[Mesh]:
        green, white = knobs(look, spots, r * 0.85), pale(look)
        out = [
            lathe(
                [
                    (0, 0),
                    (0.019 * s, 0.001),
                    (0.018 * s, 0.05 * s),
                    (0.03 * s, 0.085 * s),
                    (0, 0.1 * s),
                ],
                8,
                mat=white,
            )
        ]
        k = 1.0 if look == "fresh" else 0.95 if look == "overripe" else 0.88
        ring = count - 4
        for i in range(ring):
            a = math.tau * i / ring + 0.3
            q = 0.036 * s * k
            out.append(
                blob((r * 0.68 * math.cos(a), r * 0.68 * math.sin(a), 0.092 * s), q, green, 8, 5)
            )
            if i % 2 == 0:
                arm = [(0, 0, 0.045 * s), (r * 0.5 * math.cos(a), r * 0.5 * math.sin(a), 0.09 * s)]
                out.append(tube(arm, [0.011 * s, 0.014 * s], 5, mat=white))
        for i in range(3):
            a = math.tau * i / 3 + 0.9
            at = (r * 0.32 * math.cos(a), r * 0.32 * math.sin(a), 0.122 * s * (k + 0.02))
            out.append(blob(at, 0.036 * s * k, green, 8, 5))
        bury(out)
        return [m.keep_pattern() for m in out]

    def floret(look: str) -> list[Mesh]:
        green, white = knobs(look, small, 0.022), pale(look)
        k = 1.0 if look == "fresh" else 0.92
        out = [
            tube([(0, 0, 0), (0, 0, 0.014), (0, 0, 0.03)], [0.0075, 0.0085, 0.013], 6, mat=white)
        ]
        for i in range(3):
            a = math.tau * i / 3 + 0.3
            out.append(
                blob((0.0125 * math.cos(a), 0.0125 * math.sin(a), 0.034), 0.0165 * k, green, 7, 4)
            )
        out.append(blob((0, 0, 0.042), 0.0165 * k, green, 7, 4))
        return [m.keep_pattern() for m in out]

    def sprig(look: str, i: int) -> list[Mesh]:
        """Tender-stem broccoli: a long stalk that lies along y, its crown at the near end."""
        green, white = knobs(look, small, 0.022), pale(look)
        stem = [(0, 0, -0.13), (0.004, 0, -0.06), (0, 0, 0.012), (0, 0, 0.03)]
        out = [tube(stem, [0.006, 0.006, 0.0075, 0.012], 6, mat=white)]
        for j in range(3):
            a = math.tau * j / 3 + i
            at = (0.011 * math.cos(a), 0.011 * math.sin(a), 0.03 + 0.004 * (j % 2))
            out.append(blob(at, 0.0145, green, 7, 4))
        out.append(blob((0, 0, 0.044), 0.0135, green, 7, 4))
        out.append(leaf(0.05, 0.022, green, 0.2).turn(ry=-0.9).turn(rz=i * 2.0).move(z=-0.04))
        turn = (0.5, 0.2, -0.12)[i]
        out = ground([m.keep_pattern().turn(rx=math.pi / 2).turn(rz=turn) for m in out])
        return [m.move((i - 1) * 0.04, 0.02 * (i % 2)) for m in out]

    def shape(look: str) -> list[Mesh]:
        if form == "head":
            return head(look)
        if form == "lying":
            return ground([m.turn(rx=math.pi / 2 - 0.15).turn(rz=-0.6) for m in head(look)])
        if form == "floret":
            return floret(look)
        if form == "long":
            return [m for i in range(3) for m in sprig(look, i)]
        lie = ground([m.turn(rx=1.4) for m in floret(look)])
        return [
            *spread(floret(look), [(0, -0.028, 0, 0.4), (-0.03, 0.022, 0, 2.0)]),
            *spread(lie, [(0.034, 0.03, 0, 0.9)]),
        ]

    title = {
        "head": "head of broccoli",
        "lying": "head of broccoli",
        "floret": "broccoli floret",
        "long": "tender-stem broccoli",
    }
    mass = {"head": 0.4, "lying": 0.4, "long": 0.12, "floret": 0.015}.get(form, 0.045)
    return fresh_produce(title.get(form, "broccoli florets"), shape, mass * s**3, one_hull)


def broccoli_random(rng: np.random.Generator) -> dict:
    return {"seed": seed_of(rng)}


MODELS = {
    "mushrooms": Maker(
        mushrooms,
        mushrooms_random,
        count=7,
        presets=[
            {"form": "three"},
            {"form": "tray"},
            {"form": "one", "kind": "brown", "seed": 3},
            {"form": "upturned", "kind": "dark", "cap": 0.05},
            {"form": "half"},
            {"form": "pile", "kind": "brown"},
            {"form": "one", "kind": "white", "seed": 3},
        ],
    ),
    "broccoli": Maker(
        broccoli,
        broccoli_random,
        count=6,
        presets=[
            {"form": "head"},
            {"form": "lying"},
            {"form": "florets"},
            {"form": "floret"},
            {"form": "long"},
            {"form": "head", "size": 0.78},
        ],
    ),
}
