"""More bread: baguettes, rolls, round loaves, toast; and croissants. Fresh and mouldy."""

from __future__ import annotations

import math

import numpy as np
from toolkit import labels
from toolkit.materials import Material, label, plain
from toolkit.mesh import Mesh
from toolkit.model import Model
from toolkit.sampling import noise_offset
from toolkit.shapes import box, extrude, lathe, loft

from makers.produce_kit import (
    baked_good,
    cut_face,
    footed,
    ground,
    halve,
    one_hull,
    rot,
    spread,
)

CRUSTS = {
    "golden": ("#d9a05a", "#a8682c"),
    "brown": ("#b9773a", "#7a4420"),
    "rye": ("#7a4f2c", "#4a2c16"),
}


def crumb_picture(light="#f6e8c8", dark="#e2c898", rim="#b0743a"):
    """Holes in a white crumb within a crust."""
    image, d = labels.canvas(128, 128, rim)
    d.rounded_rectangle((6, 6, 122, 122), 40, fill=light)
    rng = np.random.default_rng(4)
    for _ in range(80):
        x, y, q = rng.uniform(14, 114), rng.uniform(14, 114), rng.uniform(1.5, 4.5)
        d.ellipse((x - q, y - q * 0.7, x + q, y + q * 0.7), fill=dark)
    return image


def crust(
    rotten: bool, tones, size: float, spots, o, low: float, high: float, slashes=()
) -> Material:
    """Baked darker on top, floury; slashes: (y, half width, slant) of pale cuts across."""
    light, dark = tones
    m = Material()
    c = m.mix(m.remap(m.noise(30, 4, offset=o), 0.35, 0.65), dark, light)
    c = m.mix(
        m.remap(m.axis(2), low + (high - low) * 0.1, low + (high - low) * 0.6, 0.6, 0), c, "e8c890"
    )
    flour = m.remap(m.noise(90, 4, offset=(o[1], 0, o[0])), 0.5, 0.62, 0, 0.5)
    top = m.remap(m.axis(2), low + (high - low) * 0.5, high)
    c = m.mix(m.math("MULTIPLY", flour, top), c, "f6ecd8")
    for y, half, slant in slashes:
        line = m.math("ADD", m.axis(1), m.math("MULTIPLY", m.axis(0), slant))
        gap = m.math("ABSOLUTE", m.math("SUBTRACT", line, y))
        on_top = m.remap(m.axis(2), low + (high - low) * 0.55, low + (high - low) * 0.7)
        c = m.mix(m.math("MULTIPLY", m.remap(gap, half * 0.6, half, 1, 0), on_top), c, "f2dfb4")
    if rotten:
        c = rot(m, c, size, spots, o, "5a5236", 0.2)
    return m.colour(c)


def long_loaf(length: float, width: float, height: float, mat, rings=12, n=10, point=2.6) -> Mesh:
    """A loaf along y, pointed more or less."""
    out = []
    for t in np.linspace(-1, 1, rings):
        t = math.sin(t * math.pi / 2)
        k = max(0.12, max(0.0, 1 - abs(t) ** point) ** 0.5)
        ring = []
        for i in range(n):
            a = math.tau * i / n
            z = math.sin(a)
            z = height * (0.38 + (0.62 if z > 0 else 0.38) * z * (0.3 + 0.7 * k))
            ring.append((math.cos(a) * width / 2 * k, t * length / 2, z))
        out.append(ring)
    return loft(out, mat=mat)


def bun(radius: float, height: float, mat, n=12, ribs=0) -> Mesh:
    profile = [(0, 0), (0.8, 0.0), (1.0, 0.28), (0.96, 0.52), (0.78, 0.8), (0.42, 0.97), (0, 1.0)]
    mesh = lathe([(q * radius, z * height) for q, z in profile], n, mat=mat, discs=False)
    if ribs:
        mesh.warp(lambda x, y, z: (x * (1 + 0.04 * math.cos(ribs * math.atan2(y, x))), y, z))
    return mesh


TOAST = [
    (-0.5, 0.0),
    (0.5, 0.0),
    (0.5, 0.66),
    (0.56, 0.78),
    (0.5, 0.95),
    (0.3, 1.0),
    (-0.3, 1.0),
    (-0.5, 0.95),
    (-0.56, 0.78),
    (-0.5, 0.66),
]


def bread_served(form="baguette", tone="golden", seed=0) -> Model:
    """Bread of another form: baguette, rolls, boule, toast, bag, cut, bun."""
    rng = np.random.default_rng(seed)
    o, tones = noise_offset(rng), CRUSTS[tone]

    def baguette(rotten: bool, length=0.42) -> list[Mesh]:
        spots = [
            (0.02, y, 0.05, k) for y, k in ((-0.14, 1.0), (-0.02, 0.9), (0.1, 1.1), (0.17, 0.6))
        ]
        spots += [(x, y, 0.026, 0.8) for x, y in ((-0.033, -0.08), (-0.033, 0.06), (0.033, 0.02))]
        slashes = [(y, 0.011, 1.4) for y in (-0.14, -0.07, 0.0, 0.07, 0.14)]
        mat = crust(rotten, tones, 0.036, spots, o, 0, 0.055, slashes)
        return [long_loaf(length, 0.068, 0.055, mat, 14, 10, 3.2).turn(rz=0.4)]

    def cut_baguette(rotten: bool) -> list[Mesh]:
        spots = [(0.02, y, 0.05, k) for y, k in ((-0.09, 0.9), (0.0, 1.0), (0.07, 0.8))]
        mat = crust(
            rotten, tones, 0.036, spots, o, 0, 0.055, [(y, 0.011, 1.4) for y in (-0.07, 0, 0.07)]
        )
        face = cut_face(
            "rotten" if rotten else "fresh",
            crumb_picture(),
            0.03,
            [(0.01, 0.06, 0.03, 0.8)],
            o,
            "8a7a54",
            0.15,
        )
        loaf = long_loaf(0.3, 0.07, 0.056, mat, 12, 10, 3.2)
        rest = halve(loaf, (0, 0.05, 0), (0, 1, 0), face).keep_pattern()
        coin = halve(loaf, (0, 0.068, 0), (0, 1, 0), face)
        coin = halve(coin, (0, 0.05, 0), (0, -1, 0), face).keep_pattern()
        flat = ground([coin.turn(rx=math.pi / 2)])
        flat = [m.move(-m.v[:, 0].mean(), -m.v[:, 1].mean()) for m in flat]
        places = [(0.035, 0.07, 0, 0.3), (0.055, 0.1, 0.012, 1.4, 0.15)]
        return [rest.turn(rz=-0.5).move(0, -0.03), *spread(flat, places)]

    def rolls(rotten: bool) -> list[Mesh]:
        spots = [(0.026, 0.008, 0.034), (-0.02, 0.024, 0.034, 0.8), (-0.006, -0.028, 0.034, 0.8)]
        mat = crust(rotten, tones, 0.024, spots, o, 0, 0.046, [(0, 0.006, 0.0)])
        places = [(0.035, -0.042, 0, 0.5), (0.03, 0.047, 0, 1.9), (-0.045, 0.002, 0, 3.9)]
        return spread([bun(0.043, 0.046, mat)], places)

    def boule(rotten: bool) -> list[Mesh]:
        spots = [
            (0.08, 0.03, 0.06),
            (-0.04, 0.08, 0.06),
            (-0.01, -0.08, 0.07, 0.9),
            (0.03, 0.02, 0.1, 0.7),
            (-0.09, -0.03, 0.045),
            (0.02, 0.095, 0.04, 0.9),
            (0.06, -0.07, 0.04, 0.9),
        ]
        mat = crust(rotten, tones, 0.045, spots, o, 0, 0.1, [(0, 0.009, 0.0), (0.0, 0.009, 30.0)])
        return [bun(0.1, 0.1, mat, 18)]

    def slice_at(
        rotten: bool, lean: float, x: float, y: float, yaw: float, z=0.0, k=0
    ) -> list[Mesh]:
        outline = [(a * 0.1, b * 0.105) for a, b in TOAST]
        spots = [
            (0.02, 0.006, 0.07),
            (-0.03, 0.006, 0.03, 0.8),
            (0.03, 0.006, 0.02, 0.6),
            (0, -0.006, 0.05),
        ]
        face = Material(occlusion=0.8)
        c = face.mix(face.remap(face.voronoi(170, (o[0], o[1], k)), 0.1, 0.28), "dfc08a", "f6e6c4")
        edge = face.math("ABSOLUTE", face.axis(0))
        high = face.math("SUBTRACT", face.axis(2), 0.051)
        rim = face.math("MAXIMUM", edge, face.math("ABSOLUTE", high))
        c = face.mix(face.remap(rim, 0.045, 0.05), c, tones[1])
        if rotten:
            c = rot(face, c, 0.026, spots, o, "8a7a54", 0.15)
        face.colour(c)
        side = crust(rotten, tones, 0.026, spots, o, 0, 0.1)
        mesh = extrude(outline, 0.013, face, side, axis="y").keep_pattern()
        mesh.turn(rx=lean).turn(rz=yaw)
        return [m.move(x, y, z) for m in ground([mesh])]

    def toast(rotten: bool) -> list[Mesh]:
        flat = slice_at(rotten, -math.pi / 2, 0.0, 0.05, 0.3)
        flat2 = slice_at(rotten, -math.pi / 2, 0.012, 0.045, 0.9, 0.013, 1)
        return flat + flat2

    def single(rotten: bool) -> list[Mesh]:
        return slice_at(rotten, -math.pi / 2, 0, 0, 1.3)

    def bagged(rotten: bool) -> list[Mesh]:
        """A loaf of toast in a clear bag with a printed band, gathered at one end."""
        film = Material()
        spots = [
            (0.055, -0.06, 0.06),
            (0.03, 0.07, 0.1),
            (-0.03, -0.02, 0.1, 0.9),
            (0.055, 0.08, 0.03, 0.7),
            (-0.055, -0.07, 0.055),
            (-0.055, 0.07, 0.06, 0.9),
            (0.0, 0.12, 0.06, 0.9),
            (0.02, -0.12, 0.06),
            (-0.055, 0.1, 0.03, 0.9),
            (-0.04, 0.085, 0.1, 0.8),
        ]
        wave = film.math("SINE", film.math("MULTIPLY", film.axis(1), 420.0))
        c = film.mix(film.remap(wave, -0.4, 0.7), "b07a3c", "e4c088")
        c = film.mix(
            film.remap(film.noise(22, 2, offset=o, stretch=(1, 0.4, 1)), 0.56, 0.66, 0, 0.55),
            c,
            "ffffff",
        )
        if rotten:
            c = rot(film, c, 0.04, spots, o, "5a5236", 0.2)
        film.colour(c)
        rings = []
        shape = np.array([(a * 0.1, b * 0.108) for a, b in TOAST])
        middle = np.array([0, 0.05])
        for y, k in (
            (-0.125, 0.93),
            (-0.12, 1.0),
            (0.11, 1.0),
            (0.13, 0.8),
            (0.15, 0.22),
            (0.158, 0.18),
            (0.19, 0.42),
        ):
            ring = (shape - middle) * k + middle * (0.5 + 0.5 * k)
            rings.append(np.c_[ring[:, 0], np.full(len(ring), y), ring[:, 1]])
        body = loft(rings, mat=film)
        image, d = labels.canvas(256, 160, "#c3262c")
        d.rectangle((0, 0, 256, 16), fill="#f6d24a")
        d.rectangle((0, 144, 256, 160), fill="#f6d24a")
        labels.text(d, "Kornhof", (60, 18, 196, 46), "italic", "#ffe9b0")
        labels.text(d, "BREAD", (10, 48, 246, 112))
        labels.text(d, "sliced", (70, 114, 186, 142), "bold", "#ffe9b0")
        band = box(
            0.114,
            0.11,
            0.1105,
            (0, -0.02, 0.0),
            plain("c3262c", 0.02),
            0.012,
            2,
            {"+x": label(image), "+z": label(image), "-x": label(image)},
            1.4,
        )
        clip = box(0.02, 0.008, 0.02, (0, 0.154, 0.018), plain("2f6fd0", 0.02))
        return [body, band, clip]

    def sandwich_buns(rotten: bool) -> list[Mesh]:
        """Burger buns with sesame, one cut open."""
        spots = [(0.03, 0.008, 0.034), (-0.02, 0.03, 0.034, 0.8), (-0.006, -0.03, 0.036, 0.8)]
        mat = crust(rotten, tones, 0.026, spots, o, 0, 0.05)
        face = cut_face(
            "rotten" if rotten else "fresh",
            crumb_picture(rim="#d8a860"),
            0.03,
            [(0.02, 0.01, 0.02, 0.8)],
            o,
            "8a7a54",
            0.15,
        )
        whole = bun(0.052, 0.05, mat, 14)
        top = halve(whole, (0, 0, 0.02), (0, 0, -1), face, up=(1, 0, 0)).keep_pattern()
        base = halve(whole, (0, 0, 0.02), (0, 0, 1), face, up=(-1, 0, 0)).keep_pattern()
        # On its cut face: stood on its rim it was taken for a potsherd.
        lid = ground([top])
        return spread([base], [(0.02, -0.056, 0, 0.4)]) + spread(lid, [(-0.02, 0.056, 0, 0.2)])

    shapes = {
        "baguette": (baguette, "baguette", 0.25),
        "cut_baguette": (cut_baguette, "cut baguette", 0.25),
        "rolls": (rolls, "three bread rolls", 0.2),
        "boule": (boule, "round loaf of bread", 0.7),
        "toast": (toast, "slices of bread", 0.2),
        "slice": (single, "slice of bread", 0.2),
        "bag": (bagged, "bag of sliced bread", 0.5),
        "bun": (sandwich_buns, "cut bun", 0.2),
    }
    shape, title, mass = shapes[form]
    pieces = footed if form in ("rolls", "toast") else one_hull
    return baked_good(title, shape, mass, pieces, 256 if form in ("bag", "boule") else 128)


# ---- croissants
def crescent(bend: float, length: float, width: float, mat, n=9, rings=15) -> Mesh:
    """Rolled dough along y: stepped ridges, thick in the middle, the ends bent towards -x."""
    out = []
    steps = rings - 1
    for k in range(rings):
        t = 2 * k / steps - 1
        ridge = (k % 2) * 0.13 * (1 - abs(t) ** 3)  # each turn of the dough overlaps the next
        q = width / 2 * (max(0.13, (1 - abs(t) ** 1.7)) ** 0.85 * (0.9 + ridge))
        a = t * bend
        reach = length / 2 / max(bend, 1e-3)
        if bend > 0.05:
            cx, cy = reach * (math.cos(a) - 1), reach * math.sin(a)
        else:
            cx, cy = 0.0, t * length / 2
        radial = np.array([math.cos(a), math.sin(a), 0]) if bend > 0.05 else np.array([1.0, 0, 0])
        ring = []
        for i in range(n):
            b = math.tau * i / n
            z = math.sin(b) * q * (0.95 if math.sin(b) > 0 else 0.6)
            ring.append(np.array([cx, cy, z + q * 0.6]) + radial * q * math.cos(b))
        out.append(ring)
    return loft(out, mat=mat)


def croissant(form="one", bend=1.5, drizzle=False, seed=0) -> Model:
    """Flaky crescents: one, two, on a plate, in a basket, straight, cut open."""
    rng = np.random.default_rng(seed)
    o = noise_offset(rng)
    length, width = 0.15, 0.062

    def coat(rotten: bool, period: float) -> Material:
        m = Material()
        c = m.mix(m.remap(m.noise(36, 3, offset=o), 0.35, 0.65), "c8782a", "e8ac54")
        wobble = m.math("MULTIPLY", m.noise(50, 2, offset=o), 0.006)
        turns = m.math("MULTIPLY", m.math("ADD", m.axis(1), wobble), math.tau / period)
        wave = m.math("COSINE", turns)  # the ridges are where it is 1
        c = m.mix(m.remap(wave, -0.35, -0.85, 0, 0.85), c, "8a4616")
        c = m.mix(m.remap(wave, 0.5, 1.0, 0, 0.4), c, "f4c878")
        c = m.mix(m.remap(m.axis(2), 0.012, 0.03, 0.55, 0), c, "f0cc88")
        c = m.mix(m.remap(m.normal(2), 0.8, 1.0, 0, 0.3), c, "fbe0a8")
        if drizzle:
            wave = m.math("SINE", m.math("MULTIPLY", m.axis(1), 260.0))
            where = m.math("MULTIPLY", m.remap(wave, 0.55, 0.75), m.remap(m.normal(2), 0.2, 0.45))
            c = m.mix(where, c, "3a1c0c")
        if rotten:
            spots = [
                (0.01, 0.01, 0.045),
                (-0.016, 0.05, 0.035, 0.85),
                (-0.012, -0.048, 0.035, 0.85),
                (0.026, -0.02, 0.02, 0.7),
            ]
            c = rot(m, c, 0.026, spots, o, "4f4630", 0.25)
        return m.colour(c)

    def one(rotten: bool, coarse=False, b=bend) -> list[Mesh]:
        rings = 11 if coarse else 15
        period = length * (0.9 if b > 0.05 else 1.0) / (rings // 2)
        return [crescent(b, length, width, coat(rotten, period), 7 if coarse else 9, rings)]

    def plate() -> list[Mesh]:
        profile = [(0, 0), (0.05, 0), (0.055, 0.003), (0.1, 0.013), (0.1, 0.017), (0.054, 0.008)]
        return [lathe([*profile, (0, 0.008)], 22, mat=plain("f2f1ec", 0.03))]

    def basket() -> list[Mesh]:
        weave = Material()
        c = weave.mix(weave.remap(weave.noise(60, 2, offset=o), 0.35, 0.65), "a8743a", "c8965a")
        w = weave.math("SINE", weave.math("MULTIPLY", weave.axis(2), 520.0))
        weave.colour(weave.mix(weave.remap(w, 0.2, 0.6, 0, 0.7), c, "6a4420"))
        profile = [(0, 0), (0.085, 0), (0.118, 0.055), (0.122, 0.062), (0.112, 0.06), (0.08, 0.008)]
        return [lathe([*profile, (0, 0.008)], 18, mat=weave).scale(0.85, 1.15, 1)]

    def shape(rotten: bool) -> list[Mesh]:
        if form == "pair":
            return spread(one(rotten, True), [(0.045, -0.02, 0, 0.2), (-0.035, 0.03, 0, 2.9)])
        if form == "plate":
            return spread(one(rotten, True), [(0.03, 0, 0.007, 0.1)])
        if form == "basket":
            places = [
                (0.04, -0.05, 0.042, 0.2),
                (-0.04, 0.0, 0.042, 2.9),
                (0.045, 0.06, 0.042, -0.2),
            ]
            places.append((0.01, 0.01, 0.08, 1.3))
            return spread(one(rotten, True), places)
        if form == "three":
            places = [(0.07, -0.01, 0, 0.15), (0, 0.01, 0, 0.0), (-0.07, 0, 0, -0.12)]
            return spread(one(rotten, True), places)
        return one(rotten)

    title = {
        "pair": "two croissants",
        "three": "three croissants",
        "plate": "croissant on a plate",
        "basket": "basket of croissants",
    }
    mass = {"pair": 0.12, "three": 0.18, "plate": 0.4, "basket": 0.45}.get(form, 0.06)
    pieces = footed if form in ("pair", "three") else one_hull
    dish = {"plate": plate, "basket": basket}.get(form)
    return baked_good(title.get(form, "croissant"), shape, mass, pieces, 128, dish)
