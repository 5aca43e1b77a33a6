"""Folded towels and blankets, square cushions (the categories: linen.py, cushions.py)."""

from __future__ import annotations

import math

import numpy as np
from labels import prints
from toolkit.materials import Material, plain, shade
from toolkit.materials import label as printed
from toolkit.mesh import Mesh
from toolkit.model import (
    Model,
    Part,
    Support,
    box_piece,
    rectangle,
)
from toolkit.sampling import noise_offset, pick, seed_of, uniform
from toolkit.shapes import (
    box,
    extrude,
)


def folded(
    length: float, width: float, layer: float, folds: int, mat: Material, rng: np.random.Generator
) -> list[Mesh]:
    """A cloth folded `folds` times back and forth: one thick ribbon, its bends at +X and -X."""
    centre: list[tuple[float, float]] = []
    for k in range(folds):
        z = layer * (k + 0.5)
        first, last = (-length / 2, length / 2) if k % 2 == 0 else (length / 2, -length / 2)
        if k:  # round the bend from the layer below
            out = math.copysign(layer * 0.5, first)
            centre += [
                (first + out * math.sin(t), z - layer * 0.5 * (1 + math.cos(t)))
                for t in (0.8, math.pi / 2, math.pi - 0.8)
            ]
        spare = float(rng.uniform(0.0, 0.015)) if k in (0, folds - 1) else 0.0
        tip = last - math.copysign(spare, last) if k == folds - 1 else last
        centre += [(first, z), ((first + last) / 2, z + float(rng.normal(0, 0.0006))), (tip, z)]
    path = np.array(centre)
    along = np.gradient(path, axis=0)
    along /= np.linalg.norm(along, axis=1)[:, None]
    across = np.c_[-along[:, 1], along[:, 0]] * layer * 0.44
    outline = np.r_[path + across, (path - across)[::-1]]
    ribbon = extrude(outline, width, mat=mat, axis="y", bevel_width=min(0.002, layer * 0.15))
    phase = rng.uniform(0, 6.28, 3)

    def soften(x: float, y: float, z: float) -> tuple[float, float, float]:
        height = z / (layer * folds)
        sag = 1 - 0.05 * (2 * y / width) ** 2 * height
        return (
            x * (1 + 0.012 * math.sin(9 * y / width + phase[0])),
            y * (1 + 0.015 * math.sin(5 * z / layer / folds + phase[1])),
            z * sag,
        )

    return [ribbon.warp(soften)]


def block(cloth: Mesh, margin: float) -> tuple[np.ndarray, Support]:
    """The box around a folded cloth, and the surface on top of it."""
    low, high = cloth.v.min(0), cloth.v.max(0)
    piece = box_piece((low + high) / 2, high - low)
    size = high - low - margin
    return piece, Support(
        "top", float(high[2]), rectangle(size[0], size[1], *((low + high) / 2)[:2])
    )


def terry(
    colour: str,
    band: str,
    at: list[tuple[float, float]],
    axis: int,
    rng: np.random.Generator,
    fluff: float,
) -> Material:
    """Fluffy cloth with woven bands at the given coordinates along an axis."""
    m = Material()
    loops = m.noise(fluff, 3, 0.7, offset=noise_offset(rng))
    base = m.mix(m.remap(loops, 0.35, 0.65), shade(colour, 0.85), shade(colour, 1.12))
    for low, high in at:
        coordinate = m.axis(axis)
        edge = 0.001
        inside = m.math(
            "MULTIPLY",
            m.remap(coordinate, low - edge, low + edge),
            m.remap(coordinate, high - edge, high + edge, 1, 0),
        )
        base = m.mix(inside, base, band)
    return m.colour(base)


def towel(
    length: float, width: float, layer: float, folds: int, colour: str, band: str, seed: int
) -> Model:
    """A folded terry towel with woven stripes."""
    rng = np.random.default_rng(seed)
    bands = [
        (width * 0.28, width * 0.34),
        (width * 0.37, width * 0.39),
        (width * 0.22, width * 0.24),
    ]
    mat = terry(colour, band, bands, 1, rng, 330)
    meshes = folded(length, width, layer, folds, mat, rng)
    piece, support = block(meshes[0], 0.04)
    return Model(
        "folded towel",
        {"body": Part(meshes, collision=[piece])},
        mass=0.45,
        friction=0.9,
        supports=[support],
        texture_size=128,
        occlusion_strength=1.2,
    )


def towel_random(rng: np.random.Generator) -> dict:
    colour, band = pick(
        rng, [("#7fb0c8", "#f4f4f0"), ("#f2efe6", "#8a6a4a"), ("#c8707c", "#f6e8e6")]
    )
    return {
        "length": uniform(rng, 0.2, 0.25),
        "width": uniform(rng, 0.3, 0.36),
        "layer": uniform(rng, 0.017, 0.022),
        "folds": 4,
        "colour": colour,
        "band": band,
        "seed": seed_of(rng),
    }


def blanket_wool(
    colours: list[str], pattern: str, width: float, rng: np.random.Generator
) -> Material:
    """Plaid or striped wool; stripes run across y within `width`."""
    m = Material()
    wool = m.noise(240, 3, 0.7, offset=noise_offset(rng))
    base = m.mix(m.remap(wool, 0.35, 0.65), shade(colours[0], 0.84), shade(colours[0], 1.1))
    if pattern == "plaid":
        for axis in (0, 1):
            for frequency, cover, colour in ((38.0, 0.35, colours[1]), (38.0, 0.95, colours[2])):
                wave = m.math("SINE", m.math("MULTIPLY", m.axis(axis), frequency))
                base = m.mix(m.remap(wave, cover - 0.02, cover + 0.02, 0, 0.55), base, colour)
    else:
        for low, high, colour in (
            (-0.3, -0.16, 1),
            (-0.13, -0.1, 2),
            (0.1, 0.13, 2),
            (0.16, 0.3, 1),
        ):
            inside = m.math(
                "MULTIPLY",
                m.remap(m.axis(1), low * width, low * width + 0.002),
                m.remap(m.axis(1), high * width - 0.002, high * width, 1, 0),
            )
            base = m.mix(m.math("MULTIPLY", inside, 0.85), base, colours[colour])
    return m.colour(base)


def blanket(
    length: float,
    width: float,
    layer: float,
    folds: int,
    colours: list[str],
    pattern: str,
    fringe: bool,
    seed: int,
) -> Model:
    """A thick folded blanket, plaid or striped, with a fringe or without."""
    rng = np.random.default_rng(seed)
    m = blanket_wool(colours, pattern, width, rng)
    meshes = folded(length, width, layer, folds, m, rng)
    height = layer * folds
    if fringe:
        tassel = plain(shade(colours[0], 1.05), 0.15, 200)
        for i in range(16):
            y = (i - 7.5) / 16 * width
            z = height - layer * 0.6
            x = length / 2 - 0.02 if folds % 2 else -length / 2 + 0.02
            q = 1 if folds % 2 else -1
            meshes.append(
                box(0.045, 0.009, 0.006, (0, 0, 0), tassel)
                .turn(ry=0.35 * q, rz=float(rng.normal(0, 0.15)))
                .move(x + q * 0.03, y, z)
            )
    piece, support = block(meshes[0], 0.05)
    return Model(
        "folded blanket",
        {"body": Part(meshes, collision=[piece])},
        mass=1.4,
        friction=0.9,
        supports=[support],
        texture_size=128,
        occlusion_strength=1.2,
    )


def blanket_random(rng: np.random.Generator) -> dict:
    return {
        "length": uniform(rng, 0.32, 0.38),
        "width": uniform(rng, 0.42, 0.5),
        "layer": uniform(rng, 0.032, 0.04),
        "folds": 3,
        "colours": pick(
            rng, [["#a8323a", "#26303c", "#e9dcc0"], ["#3a5a4a", "#1f2c28", "#e0cf9a"]]
        ),
        "pattern": "plaid",
        "fringe": True,
        "seed": seed_of(rng),
    }


def cushion(
    size: float, puff: float, colours: list[str], pattern: str, seed: int, aspect: float = 1.0
) -> Model:
    """A square sofa cushion lying flat, its corners drawn out, with a dent in the middle."""
    rng = np.random.default_rng(seed)
    n = 12
    us = np.sin(np.linspace(-1, 1, n + 1) * math.pi / 2)
    front = (
        printed(prints.woven(colours, pattern))
        if pattern != "plain"
        else plain(colours[0], 0.08, 140)
    )
    back, piping = plain(colours[1], 0.08, 140), plain(shade(colours[1], 0.8), 0.05)
    vertices, index = [], {}
    bumps = rng.uniform(0, 6.28, 4)
    for side in (1, -1):
        for i, u in enumerate(us):
            for j, v in enumerate(us):
                pull = 0.07 * (1 - u * u) * abs(v) ** 3, 0.07 * (1 - v * v) * abs(u) ** 3
                x = u * (1 - pull[1]) * size / 2 * aspect
                y = v * (1 - pull[0]) * size / 2
                swell = (max(0.0, 1 - abs(u) ** 2.3) * max(0.0, 1 - abs(v) ** 2.3)) ** 0.6
                dent = (
                    0.14 * math.exp(-((u - 0.1) ** 2 + (v + 0.05) ** 2) / 0.12) if side > 0 else 0.0
                )
                crease = 0.03 * math.sin(5 * u + bumps[0]) * math.sin(4 * v + bumps[1])
                # its own weight presses it flat below, so that its seam does not hang in the air
                z = 0.006 * side + side * puff / 2 * swell * (1 - dent + crease) * (
                    1.55 if side > 0 else 0.4
                )
                index[side, i, j] = len(vertices)
                vertices.append((x, y, z))
    faces, kinds, luv, buv = [], [], [], []
    for side in (1, -1):
        for i in range(n):
            for j in range(n):
                cells = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)]
                cells = cells if side > 0 else cells[::-1]
                faces.append([index[side, a, b] for a, b in cells])
                kinds.append(0 if side > 0 else 1)
                uv = [((us[b] + 1) / 2, 1 - (us[a] + 1) / 2) for a, b in cells]
                luv.append(uv)
                buv.append([(u + (0 if side > 0 else 1.5), v) for u, v in uv])
    border = (
        [(i, 0) for i in range(n)]
        + [(n, j) for j in range(n)]
        + [(i, n) for i in range(n, 0, -1)]
        + [(0, j) for j in range(n, 0, -1)]
    )
    for k, (a, b) in enumerate(border):
        c, d = border[(k + 1) % len(border)]
        faces.append([index[-1, a, b], index[-1, c, d], index[1, c, d], index[1, a, b]])
        kinds.append(2)
        luv.append([(0, 0)] * 4)
        buv.append(
            [(0.02 * k, -0.3), (0.02 * (k + 1), -0.3), (0.02 * (k + 1), -0.28), (0.02 * k, -0.28)]
        )
    mesh = Mesh(vertices, faces, kinds, [front, back, piping], luv, buv).outward()
    low = float(mesh.v[:, 2].min())
    mesh.v[:, 2] = (
        np.maximum(mesh.v[:, 2] - low, 0.18 * puff * 0.5) - 0.18 * puff * 0.5
    )  # lies on a flat belly
    top = float(mesh.v[:, 2].max())
    flat, inner = size * 0.96, size * 0.62
    piece = np.r_[
        box_piece((0, 0, top * 0.42), (flat * aspect, flat, 0.02)),
        box_piece((0, 0, top / 2), (inner * aspect, inner, top * 0.98)),
    ]
    return Model("sofa cushion", {"body": Part([mesh], collision=[piece])}, mass=0.5, friction=0.9)


def cushion_random(rng: np.random.Generator) -> dict:
    return {
        "size": uniform(rng, 0.4, 0.46),
        "puff": uniform(rng, 0.12, 0.15),
        "colours": ["#e9e0cc", "#b8402c", "#2f5f7a"],
        "pattern": "stripes",
        "seed": seed_of(rng),
    }
