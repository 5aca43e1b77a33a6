"""Berries and small tomatoes in clusters, and what grey mould makes of them."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import Material, plain
from toolkit.mesh import Mesh
from toolkit.model import Model
from toolkit.sampling import noise_offset
from toolkit.shapes import ellipsoid, lathe, tube

from makers import produce_faces as faces
from makers.produce_kit import (
    BLUE_MOULD,
    GREEN_MOULD,
    WHITE_MOULD,
    cut_face,
    footed,
    fresh_produce,
    green,
    ground,
    halve,
    matured,
    one_hull,
    patches,
    punnet,
    skin,
    spread,
)


def fur(o, scale: float = 90.0) -> Material:
    """A thick coat of white and grey-green mould over brown."""
    m = Material(occlusion=0.7)
    c = m.mix(m.remap(m.noise(scale, 4, 0.7, offset=o), 0.4, 0.58), WHITE_MOULD, GREEN_MOULD)
    c = m.mix(
        m.remap(m.noise(scale * 2.2, 3, offset=(o[1], o[0], 2)), 0.6, 0.68, 0, 0.8), c, BLUE_MOULD
    )
    bare = m.noise(scale * 0.45, 3, offset=(o[2], 1, o[0]))
    return m.colour(m.mix(m.remap(bare, 0.62, 0.66, 0, 0.9), c, "4a2a16"))


def dull(o, tone, dark="24160c") -> Material:
    """Shrivelled and browned."""
    m = Material()
    c = m.mix(m.remap(m.noise(70, 3, offset=o), 0.35, 0.65), dark, tone)
    return m.colour(m.mix(m.remap(m.voronoi(210, o), 0.1, 0.25, 0.6, 0), c, "1a0e08"))


# ---- strawberries
def strawberry(look: str, size: float, o, coarse: bool) -> list[Mesh]:
    """One berry about z, its tip down, with its green star."""
    n, s = (7 if coarse else 11), size
    r = 0.0165 * s
    spots = [(*p[:3], p[3] * 1.15) for p in patches(r, 0.0, 4)]
    m = Material()
    c = m.mix(m.remap(m.noise(60, 2, offset=o), 0.35, 0.65), "b8141c", "dc262c")
    c = m.mix(m.remap(m.voronoi(330, o), 0.1, 0.2, 0.9, 0), c, "f4d068")
    m.colour(matured(look, m, c, r, spots, o, "2e0c12", 0.5))
    k = {"fresh": 1.0, "overripe": 0.95, "rotten": 0.87}[look]
    profile = [
        (0, -0.021),
        (0.0075, -0.017),
        (0.0135, -0.006),
        (0.0165, 0.006),
        (0.012, 0.014),
        (0, 0.015),
    ]
    if not coarse:
        profile = [
            (0, -0.0225),
            (0.005, -0.0205),
            (0.0105, -0.012),
            (0.0148, -0.001),
            (0.0165, 0.007),
            (0.0145, 0.0125),
            (0.008, 0.0155),
            (0, 0.0145),
        ]
    berry = lathe([(q * s * k, w * s * k) for q, w in profile], n, mat=m, discs=False)
    star = lathe(
        [(0, 0.0125 * s), (0.0165 * s, 0.0135 * s), (0, 0.0185 * s)],
        10 if coarse else 14,
        mat=green(look, "4a9a2a"),
        rib=lambda k, i: 1 - 0.62 * (i % 2),
    )
    return [mesh.keep_pattern() for mesh in (berry, star)]


def strawberry_half(look: str, size: float, o) -> list[Mesh]:
    berry, star = strawberry(look, size, o, False)
    r = 0.0165 * size
    face = cut_face(
        look, faces.berry_face(), r, [(r * 0.3, 0, 0, 0.8), (-r * 0.4, 0, -r * 0.5, 0.5)], o
    )
    berry.rest = None
    berry = halve(berry, (0, 0.0003, 0), (0, 1, 0), face).keep_pattern()
    return ground([m.turn(rx=math.pi / 2) for m in (berry, star)])


def strawberry_places(form: str, s: float) -> list[tuple[float, ...]]:
    """(x, y, z, spin, tilt, yaw) of every berry."""
    r = 0.0165 * s
    if form == "punnet":
        base = [
            (
                (i - 1) * r * 2.05,
                (j - 1) * r * 2.2,
                0.006,
                1.1 * i,
                1.35 + 0.2 * j,
                0.7 * i + 2.1 * j,
            )
            for i in range(3)
            for j in range(3)
        ]
        top = [(r * 0.9, r, r * 1.6, 0.5, 1.2, 0.3), (-r * 0.8, -r, r * 1.6, 2.0, 1.5, 3.6)]
        return base[1::2] + base[0::4] + top
    if form == "three":
        return [
            (0.6 * r, -1.25 * r, 0, 0.4, 1.3, -2.1),
            (0.5 * r, 1.25 * r, 0, 2.0, 1.4, 2.2),
            (-1.4 * r, 0.1 * r, 0, 4.0, 1.3, 0.9),
        ]
    return [(0, 0, 0, 0.4, 1.15, -1.9)]


def strawberries_served(form: str, size=1.0, seed=0) -> Model:
    """Strawberries in a punnet, three loose ones, or some cut in half."""
    rng = np.random.default_rng(seed)
    o, s = noise_offset(rng), size

    def placed(look: str, places, coarse: bool) -> list[Mesh]:
        out = []
        for x, y, z, spin, tilt, yaw in places:
            pair = strawberry(look, s, o, coarse)
            for mesh in pair:
                mesh.turn(rz=spin).turn(ry=tilt).turn(rz=yaw)
            ground(pair)
            out += [m.move(x, y, z) for m in pair]
        return out

    def shape(look: str) -> list[Mesh]:
        if form == "halves":
            r = 0.0165 * s
            out = spread(
                strawberry_half(look, s, o),
                [(0.9 * r, -1.2 * r, 0, 1.2), (1.1 * r, 1.5 * r, 0, -0.3)],
            )
            return out + placed(look, [(-1.3 * r, 0.1 * r, 0, 4.0, 1.3, 2.9)], False)
        out = placed(look, strawberry_places(form, s), form == "punnet")
        if form == "punnet":
            shell = punnet(0.118 * s, 0.124 * s, 0.03 * s, plain("4f9ac0", 0.06, 120))
            return [*out, shell]
        return out

    title = {"punnet": "punnet of strawberries", "halves": "strawberries, one cut in half"}
    mass = {"punnet": 0.18, "three": 0.06, "halves": 0.05}.get(form, 0.03)
    solids = footed if form == "three" else one_hull
    return fresh_produce(title.get(form, "strawberries"), shape, mass * s**3, solids)


# ---- grapes
GRAPES = {
    "green": ("a8bf4a", "c4d46a", "eef4b8"),
    "blue": ("3a2348", "54305f", "9a86b8"),
    "red": ("8a2434", "b0444c", "e0a0a0"),
}
BUNCHES = {  # (y, berries across, layers) from the tip to the shoulder
    "long": ((-0.1, 1), (-0.078, 2), (-0.055, 2), (-0.031, 3), (-0.007, 2), (0.017, 3), (0.041, 2)),
    "wide": ((-0.05, 1), (-0.027, 3), (-0.003, 4), (0.021, 4), (0.045, 2)),
    "small": ((-0.026, 1), (-0.004, 2), (0.019, 2)),
    "loose": (),
}


def grapes_served(form="long", kind="red", size=1.0, seed=0) -> Model:
    """A bunch of another shape, with a vine leaf; or loose berries."""
    rng = np.random.default_rng(seed)
    o, s = noise_offset(rng), size
    r = 0.0135 * s
    low, mid, bloom = GRAPES[kind]
    places = []
    for y, wide in BUNCHES[form]:
        places += [((j - (wide - 1) / 2) * r * 1.88, y * s, r) for j in range(wide)]
        places += [
            ((j - (wide - 2) / 2) * r * 1.9, (y + 0.01) * s, r * 2.4) for j in range(wide - 1)
        ]
    if form == "loose":
        for x, y in (
            (0, 0),
            (2.1, 0.3),
            (-2.0, 0.9),
            (0.6, 2.1),
            (-0.9, -2.2),
            (1.6, -1.9),
            (-1.3, 2.9),
        ):
            places.append((x * r, y * r, r))
        places += [(0.3 * r, 1.0 * r, r * 2.6), (-0.9 * r, -0.7 * r, r * 2.5)]
    jitter = rng.uniform(-0.12, 0.12, (len(places), 3)) * r
    centres = np.array([(r * 1.4, places[len(places) // 3][1], 2 * r), (-r, places[-1][1], 2 * r)])
    far = [min(np.linalg.norm(centres - p, axis=1)) for p in np.array(places)]
    furred = set(np.argsort(far)[: max(3, int(len(places) * 0.42))])
    fine = len(places) < 12

    def shape(look: str) -> list[Mesh]:
        if look == "rotten":
            mats = [dull(o, "6a4424"), fur(o)]
        else:
            m = Material()
            c = m.mix(m.remap(m.noise(60, 2, offset=o), 0.35, 0.65), low, mid)
            c = m.mix(m.remap(m.normal(2), 0.55, 1.0, 0, 0.55), c, bloom)
            if look == "overripe":
                c = m.mix(0.4, c, "7a4a24")
            m.colour(matured(look, m, c, r * 3, [(0, 0, 0)], o))
            mats = [m, m]
        k = {"fresh": 1.0, "overripe": 0.93, "rotten": 0.84}[look]
        out = []
        for i, ((x, y, z), (a, b, c)) in enumerate(zip(places, jitter, strict=True)):
            q = r * k * (1.1 if look == "rotten" and i in furred else 1.0)
            n, m_ = (8, 6) if fine else (6, 4)
            berry = ellipsoid((q, q * 1.12, q), n=n, m=m_, mat=mats[i in furred])
            if not fine:
                berry.keep_faces(range(6, len(berry.f)))  # nobody sees it from below
            out.append(berry.turn(rz=b * 200).move(x + a, y + b, r * k + (z - r) * k + c * 0.3))
        if form == "loose":
            return out
        top = places[-1][1] + r
        wood = plain("7a8a3a" if look == "fresh" else "5a3f1c", 0.2, 300)
        path = [
            (0, top - 2.5 * r, r * 1.8),
            (0.003, top + r, r * 2.5),
            (-0.004, top + 2.6 * r, r * 2.3),
        ]
        out.append(tube(path, [0.0024, 0.0024, 0.0032], 5, mat=wood))
        heart = np.array([p[1] for p in places])
        tone = "201408" if look == "rotten" else blend_dark(low)
        core = ellipsoid((r * 1.5, np.ptp(heart) * 0.42, r), n=7, m=4, mat=plain(tone, 0))
        out.append(core.move(0, heart.mean(), r * 1.1))
        if form == "wide":
            out.append(vine_leaf(look).turn(rz=0.5).move(-0.004, top + r, r * 2.4))
        return out

    title = "loose grapes" if form == "loose" else f"bunch of {kind} grapes"
    mass = {"long": 0.35, "wide": 0.4, "small": 0.15, "loose": 0.06}[form]
    return fresh_produce(title, shape, mass * s**3, one_hull)


def blend_dark(tone: str) -> tuple[float, ...]:
    return tuple(int(tone[i : i + 2], 16) / 255 * 0.55 for i in (0, 2, 4))


def vine_leaf(look: str) -> Mesh:
    """A lobed leaf, nearly flat, its stalk end at the origin, along +x."""
    mat = green(look, "3f8a2c")
    rim = []
    for i in range(15):
        a = -math.pi * 0.86 + i * math.pi * 1.72 / 14
        q = 0.03 * (1.0 + 0.22 * math.cos(5 * a)) * (0.8 + 0.25 * math.cos(a))
        rim.append((0.02 + q * math.cos(a), q * math.sin(a), -0.006 * abs(math.sin(2.5 * a))))
    upper = [(0.018, 0, 0.004), *rim]
    lower = [(x, y, z - 0.0012) for x, y, z in upper]
    n = len(rim)
    faces_ = [(0, i, i + 1) for i in range(1, n)] + [(0, n, 1)]
    faces_ += [tuple(j + n + 1 for j in f[::-1]) for f in faces_]
    return Mesh(upper + lower, faces_, None, [mat])


# ---- tomatoes on the vine
def vine_tomatoes(count=6, radius=0.016, colour=("b8201a", "dc3c28"), seed=0) -> Model:
    """Small tomatoes on both sides of a green truss along y."""
    rng = np.random.default_rng(seed)
    o, r = noise_offset(rng), radius
    spots = patches(r, r, seed)
    step = r * 1.25
    length = step * (count - 1)
    places = [
        ((-1) ** i * r * 1.12, i * step - length / 2, 0, float(rng.uniform(0, 6.28)))
        for i in range(count)
    ]

    def one(look: str) -> list[Mesh]:
        gloss = ((r * 0.5, -r * 0.2, r * 1.8), r * 0.5, "ffc8b4")
        k = {"fresh": 1.0, "overripe": 0.95, "rotten": 0.88}[look]
        mat = skin(look, colour, r, spots, o, gloss=gloss)
        n, m = (10, 7) if count < 5 else (8, 6)
        body = ellipsoid((r * k, r * k, r * 0.93 * k), (0, 0, r * 0.93 * k), n, m, mat)
        star = lathe(
            [(0, -0.0006), (r * 0.72, 0.0012), (0, 0.003)],
            10,
            mat=green(look),
            rib=lambda k_, i: 1 - 0.66 * (i % 2),
        ).move(z=r * 1.86 * k - 0.0008)
        return [body, star]

    def shape(look: str) -> list[Mesh]:
        mat, z = green(look, "5a8a34"), r * 2.12
        ys = np.linspace(-length / 2 - r * 0.6, length / 2 + r * 2.4, 6)
        stem = tube([(0.002 * math.sin(90 * y), y, z) for y in ys], 0.0028, 5, mat=mat)
        arms = [
            tube(
                [(0, y - r * 0.3, z), (x * 0.6, y, z + 0.002), (x * 0.95, y, r * 1.8)],
                0.0017,
                4,
                mat=mat,
            )
            for x, y, *_ in places
        ]
        return [*spread(one(look), places), stem, *arms]

    return fresh_produce("tomatoes on the vine", shape, count * 4.2e3 * r**3, one_hull)
