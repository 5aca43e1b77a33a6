"""Pineapples and corn cobs; fresh, overripe and rotten."""

from __future__ import annotations

import math

import numpy as np
from toolkit import labels
from toolkit.materials import Material, blend, plain
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model
from toolkit.sampling import noise_offset, seed_of
from toolkit.shapes import lathe, loft, tube

from makers import produce_faces as faces
from makers.produce_kit import (
    cut_face,
    footed,
    fresh_produce,
    ground,
    halve,
    matured,
    one_hull,
    outline_points,
    patches,
    spread,
)
from makers.spoilage import wither


def eyes_picture(base: str, dark: str, light: str, across: int, up: int):
    """Rows of diamonds, set off by half, for the rind of a pineapple (wraps round)."""
    w, h = 40 * across, 40 * up
    image, d = labels.canvas(w, h, dark)
    for j in range(-1, 2 * up + 1):
        for i in range(-1, across + 1):
            x, y = 40 * i + (20 if j % 2 else 0) + 20, 20 * j + 20
            d.polygon([(x, y - 17), (x + 17, y), (x, y + 17), (x - 17, y)], fill=base)
            d.polygon([(x, y - 9), (x + 9, y), (x, y + 8), (x - 9, y)], fill=light)
            d.ellipse((x - 3, y - 3, x + 3, y + 3), fill=dark)
    return image.resize((w // 2, h // 2))


def pineapple_face():
    image, d = labels.canvas(faces.N, faces.N, "#9a6a24")
    faces.disc(d, 0.93, "#f8d84a")
    for i in range(20):
        a = math.tau * i / 20
        line = [
            (faces.N / 2 * (1 + q * math.cos(a)), faces.N / 2 * (1 + q * math.sin(a)))
            for q in (0.3, 0.86)
        ]
        d.line(line, fill="#e8b828", width=3)
    faces.disc(d, 0.28, "#faf0b0")
    return image


PINEAPPLES = {
    "ripe": ("#d8962c", "#6a4a1c", "#f0c858"),
    "green": ("#7a8a34", "#3a4a1c", "#b0a848"),
}


def pineapple(form="standing", kind="ripe", radius=0.056, height=0.15, leaves=16, seed=0) -> Model:
    """A rind of diamonds and a crown of stiff leaves: standing, lying, cut along, in rings."""
    rng = np.random.default_rng(seed)
    o, r, h = noise_offset(rng), radius, height
    spots = [
        *patches(r, h * 0.5, seed),
        (r * 0.8, r * 0.2, h * 0.2, 0.8),
        (0, r * 0.9, h * 0.8, 0.7),
    ]
    outline = [
        (0, 0.0),
        (r * 0.6, 0.002),
        (r * 0.88, h * 0.12),
        (r, h * 0.4),
        (r * 0.95, h * 0.66),
        (r * 0.76, h * 0.88),
        (r * 0.35, h * 0.99),
        (0, h),
    ]

    def body(look: str) -> Mesh:
        m = Material()
        c = m.image(eyes_picture(*PINEAPPLES[kind], 9, 8))
        if kind == "ripe":
            c = m.mix(m.remap(m.axis(2), h * 0.55, h, 0, 0.45), c, "6a8a34")
        c = m.mix(m.remap(m.noise(26, 3, offset=o), 0.45, 0.7, 0, 0.35), c, "b8742c")
        m.colour(matured(look, m, c, r * 0.9, spots, o, "2c1c0c", 0.5))
        mesh = lathe(outline_points(outline, 10), 14, mat=m, discs=False, label_z=(0, h))
        return wither(look, mesh, r, spots, 0.12)

    def crown(look: str) -> list[Mesh]:
        tones = {
            "fresh": ("3f6a34", "5a8a44"),
            "overripe": ("8a7f44", "6a7a3c"),
            "rotten": ("5a4624", "3f3018"),
        }
        mats = [plain(t, 0.2, 120) for t in tones[look]]
        draw = np.random.default_rng(seed + 1)
        out = []
        for i in range(leaves):
            t = i / leaves
            up = 0.45 + 0.95 * t  # the outer ones bend away
            if look == "rotten":
                up -= 0.35
            reach = h * (0.55 + 0.35 * t) * draw.uniform(0.85, 1.1)
            a = i * 2.4 + draw.uniform(-0.2, 0.2)
            rings = []
            for s, wide in ((0.0, 0.011), (0.45, 0.009), (0.8, 0.005), (1.0, 0.0006)):
                bend = up + 0.45 * (1 - t) * (0.3 - s)
                x, z = reach * s * math.cos(bend), reach * s * math.sin(bend)
                x, k = x + 0.008, wide * r / 0.056
                rings.append(
                    [(x, -k, z + k * 0.35), (x, k, z + k * 0.35), (x + 0.0012, 0, z - k * 0.4)]
                )
            out.append(
                loft(rings, mat=mats[i % 2], caps=(False, True)).turn(rz=a).move(z=h * 0.965)
            )
        return [m if m.signed_volume() > 0 else m.flip() for m in out]

    def ring(look: str) -> list[Mesh]:
        face = cut_face(look, pineapple_face(), r, [(r * 0.4, r * 0.3, h * 0.45, 0.7)], o)
        mesh = halve(body(look), (0, 0, h * 0.46), (0, 0, 1), face, up=(-1, 0, 0))
        mesh = halve(mesh, (0, 0, h * 0.37), (0, 0, -1), face, up=(1, 0, 0))
        return ground([mesh.keep_pattern()])

    def shape(look: str) -> list[Mesh]:
        face = cut_face(
            look, pineapple_face(), r, [(r * 0.3, 0, h * 0.6, 0.8), (-r * 0.4, 0, h * 0.3, 0.6)], o
        )
        if form == "half":
            out = [halve(body(look), (0, 0, 0), (0, 1, 0), face).keep_pattern()]
            out += [m for m in crown(look) if m.v[:, 1].mean() < 0.004]
            for m in out:
                m.turn(rx=math.pi / 2)
            return ground(out)
        if form == "rings":
            piece = ring(look)
            flat = spread(piece, [(0, -r * 0.5, 0, 0.3), (r * 0.3, r * 0.75, h * 0.085, 2.0)])
            up = ground([m.copy().turn(ry=1.1) for m in piece])
            return flat + spread(up, [(-r * 1.2, r * 0.5, 0, -0.1)])
        if form == "stump":  # the top cut off
            cut = halve(body(look), (0, 0, h * 0.62), (0, 0, 1), face, up=(-1, 0, 0))
            return [cut]
        whole = [m.keep_pattern() for m in (body(look), *crown(look))]
        if form == "lying":
            whole = ground([m.turn(rx=math.pi / 2 - 0.06).turn(rz=0.35) for m in whole])
        return whole

    title = {"half": "half a pineapple", "rings": "pineapple rings", "stump": "cut pineapple"}
    mass = {"half": 0.6, "rings": 0.3, "stump": 0.8}.get(form, 1.3) * (r / 0.056) ** 3
    return fresh_produce(
        title.get(form, "pineapple"), shape, mass, footed if form == "rings" else one_hull, 256
    )


def kernels_picture(tones, across: int, up: int):
    """Rows of kernels round a cob."""
    image, d = labels.canvas(16 * across, 16 * up, tones[2])
    rng = np.random.default_rng(1)
    for i in range(across):
        for j in range(up):
            x, y = 16 * i, 16 * j + (8 if i % 2 else 0)
            d.rounded_rectangle((x + 1, y + 1, x + 15, y + 15), 5, fill=tones[int(rng.integers(2))])
            d.ellipse((x + 5, y + 4, x + 9, y + 8), fill="#fff6c8")
    return image


def cob_face():
    image, d = faces.round_face("#d89a14", "#f8c828")
    faces.disc(d, 0.62, "#fbf6e2")
    for i in range(14):
        a = math.tau * i / 14
        ends = [
            (faces.N / 2 * (1 + q * math.cos(a)), faces.N / 2 * (1 + q * math.sin(a)))
            for q in (0.64, 0.95)
        ]
        d.line(ends, fill="#b07a10", width=3)
    faces.disc(d, 0.26, "#d8c48c")
    return image


def corn(form="husk", length=0.19, radius=0.024, seed=0) -> Model:
    """A yellow cob: bare, with its husk peeled back, shut in it, two, or cut in pieces."""
    rng = np.random.default_rng(seed)
    o, r, h = noise_offset(rng), radius, length
    tones = ("#f4c42c", "#fad858", "#b87c10")
    spots = [
        (r * 0.5, r * 0.8, h * 0.25, 1.1),
        (-r * 0.4, r * 0.9, h * 0.62, 1.0),
        (r * 0.9, r * 0.1, h * 0.8, 0.8),
        (r * 0.9, -r * 0.2, h * 0.5, 0.6),
    ]

    def cob(look: str, start: float = 0.0) -> Mesh:
        m = Material()
        c = m.image(kernels_picture(tones, 14, 24))
        m.colour(matured(look, m, c, r * 1.3, spots, o, "2c1c0c", 0.45))
        outline = [
            (0, start),
            (r * 0.85, start + 0.002),
            (r, start + h * 0.12),
            (r * 0.97, h * 0.55),
            (r * 0.78, h * 0.82),
            (r * 0.45, h * 0.95),
            (0, h),
        ]
        mesh = lathe(outline_points(outline, 9), 12, mat=m, discs=False, label_z=(0, h))
        return wither(look, mesh, r, spots, 0.12)

    def husk_leaf(look: str, a: float, reach: float, open_: float, wide: float) -> Mesh:
        tone = {"fresh": "86b04a", "overripe": "c8b468", "rotten": "7a6a40"}[look]
        m = Material()
        lines = m.noise(1, 2, stretch=(260, 260, 14), offset=o)
        c = m.mix(m.remap(lines, 0.4, 0.62), tone, blend(tone, "f0f0c0", 0.45))
        m.colour(matured(look, m, c, r * 1.2, spots, o, "3a2a14", 0.3))
        rings = []
        for t in np.linspace(0, 1, 6):
            out = r * (0.55 + 0.62 * min(1, t * 4)) + open_ * reach * t * t
            z = -0.012 + reach * (t - 0.55 * open_ * t * t * t)
            half = wide * math.sin(math.pi * min(0.96, 0.2 + t * 0.76)) ** 0.7
            ring = []
            for s, q in ((-1, 1.0), (-0.5, 1.06), (0.5, 1.06), (1, 1.0), (0.5, 1.0), (-0.5, 1.0)):
                b = a + s * half * (1 - 0.4 * open_ * t)
                q = out * q if t < 0.98 else out
                ring.append((q * math.cos(b), q * math.sin(b), z))
            rings.append(ring)
        return loft(rings, mat=m)

    def stub(look: str) -> Mesh:
        tone = {"fresh": "9ab868", "overripe": "c0b070", "rotten": "5a4a2c"}[look]
        return tube(
            [(0, 0, -0.032), (0, 0, -0.014), (0, 0, 0.006)],
            [0.0105, 0.011, r * 0.7],
            7,
            mat=plain(tone, 0.15, 150),
        )

    def silk(look: str) -> list[Mesh]:
        mat = plain("b8863c" if look == "fresh" else "6a4420", 0.3, 400)
        out = []
        for i in range(5):
            a = i * 1.26
            x, y = 0.012 * math.cos(a), 0.012 * math.sin(a)
            path = [(0, 0, h * 0.93), (x * 0.6, y * 0.6, h * 1.04), (x * 1.6, y * 1.6, h * 1.11)]
            out.append(tube(path, [0.004, 0.0032, 0.001], 4, mat=mat))
        return out

    def lay(group: list[Mesh], turn: float = 0.0) -> list[Mesh]:
        group = [m if m.rest is not None else m.keep_pattern() for m in group]
        low = min(m.v[:, 2].min() for m in group)
        high = max(m.v[:, 2].max() for m in group)
        return ground(
            [m.move(z=-(low + high) / 2).turn(rx=math.pi / 2).turn(rz=turn) for m in group]
        )

    def piece(look: str, low: float, high: float) -> list[Mesh]:
        face = cut_face(look, cob_face(), r, [(r * 0.3, r * 0.2, high, 0.6)], o)
        mesh = cob(look)
        if high < h:
            mesh = halve(mesh, (0, 0, high), (0, 0, 1), face, up=(-1, 0, 0))
        mesh = halve(mesh, (0, 0, low), (0, 0, -1), face, up=(1, 0, 0))
        return ground([mesh.keep_pattern()])

    def shape(look: str) -> list[Mesh]:
        if form == "bare":
            return lay([cob(look), stub(look)], 0.3)
        if form == "pair":
            return spread(
                lay([cob(look), stub(look)]), [(-r * 1.15, 0, 0, 0.12), (r * 1.3, 0.01, 0, -0.25)]
            )
        if form == "shut":
            leaves = [
                husk_leaf(look, a, h * q, 0.02, 1.15)
                for a, q in ((0.3, 1.0), (2.4, 0.97), (4.5, 0.99))
            ]
            return lay([cob(look), *leaves, *silk(look), stub(look)], 0.3)
        if form == "pieces":
            up = piece(look, h * 0.12, h * 0.24)
            tip = ground([m.turn(rx=math.pi / 2) for m in piece(look, h * 0.4, h)])
            return spread(up, [(r * 1.9, -r * 0.4, 0, 0.3), (r * 1.1, r * 1.9, 0, 1.5)]) + spread(
                tip, [(-r * 0.7, -r * 0.2, 0, 0.35)]
            )
        if form == "standing":  # in its husk as on the stalk
            leaves = [husk_leaf(look, a, h * 0.72, 0.3, 0.8) for a in (0.2, 1.8, 3.3, 4.8)]
            return ground([m.keep_pattern() for m in (cob(look), *leaves)])
        open_ = 0.34
        leaves = [husk_leaf(look, a, h * 0.8, open_, 0.75) for a in (-1.0, -2.4, 3.1)]
        return lay([cob(look), *leaves, stub(look)], 0.3)

    title = {
        "pieces": "pieces of corn on the cob",
        "pair": "two corn cobs",
        "shut": "corn in its husk",
    }
    mass = {"pair": 0.5, "pieces": 0.2}.get(form, 0.28)
    solids = footed if form in ("pair", "pieces") else one_hull
    return fresh_produce(title.get(form, "corn cob"), shape, mass, solids, 256)


def any_random(rng: np.random.Generator) -> dict:
    return {"seed": seed_of(rng)}


MODELS = {
    "pineapple": Maker(
        pineapple,
        any_random,
        count=6,
        presets=[
            {"form": "standing"},
            {"form": "lying"},
            {"form": "half"},
            {"form": "rings"},
            {"form": "standing", "kind": "green", "radius": 0.045, "height": 0.1, "leaves": 14},
            {"form": "stump"},
        ],
    ),
    "corn": Maker(
        corn,
        any_random,
        count=6,
        presets=[
            {"form": "husk"},
            {"form": "bare"},
            {"form": "shut"},
            {"form": "pair"},
            {"form": "pieces"},
            {"form": "bare", "length": 0.14, "radius": 0.026},
        ],
    ),
}
