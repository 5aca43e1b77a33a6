"""What packages are made of: bottles of any section, standing bags, puddles and shards."""

from __future__ import annotations

import inspect
import math
from collections.abc import Callable, Sequence

import numpy as np
from toolkit.materials import Material, label, plain
from toolkit.mesh import Mesh
from toolkit.model import Model, Part, box_piece
from toolkit.shapes import box, loft, rounded_rectangle, superellipse

from makers.breakage import broken
from makers.projection import project_label

Section = tuple[float, float, float, float]  # z, half depth (x), half width (y), power


def by_style(name: str, styles: dict[str, Callable[..., Model]]) -> Callable[..., Model]:
    """One maker for several forms; what a form does not know of is left out."""

    def make(style: str, **values) -> Model:
        known = inspect.signature(styles[style]).parameters
        return styles[style](**{k: v for k, v in values.items() if k in known})

    make.__name__ = name
    return make


def round_sections(profile: Sequence[tuple[float, float]]) -> list[Section]:
    """(radius, z) pairs as sections."""
    return [(z, r, r, 2.0) for r, z in profile]


def vessel(
    sections: Sequence[Section],
    mats: Sequence[Material],
    which: Sequence[int] | None = None,
    n: int = 20,
) -> Mesh:
    """A solid of stacked rings. which: the material of each segment; 1 is a label wrapped round,
    its middle to the front, stretched over all segments that wear it."""
    rings = [superellipse(a, b, power, n, z) for z, a, b, power in sections]
    which = list(which) if which else [0] * (len(sections) - 1)
    mesh = loft(rings, mats=list(mats), mat_of_face=lambda k, i: which[k])
    worn = [k for k, m in enumerate(which) if m == 1]
    if not worn:
        return mesh
    low, high = sections[worn[0]][0], sections[worn[-1] + 1][0]
    for number, face in enumerate(mesh.f):
        if number >= n * len(which) or mesh.mi[number] != 1:
            continue
        column = number % n
        start = (column / n + 0.25) % 1
        mesh.label_uv[number] = [
            (start + (0 if v % n == column else 1 / n), (mesh.v[v][2] - low) / (high - low))
            for v in face
        ]
    return mesh


def hollow(
    sections: Sequence[Section],
    mats: Sequence[Material],
    which: Sequence[int] | None = None,
    wall: float = 0.005,
    n: int = 10,
) -> Mesh:
    """The same, coarser, open at the top and with a wall: to be broken."""
    which = list(which) if which else [0] * (len(sections) - 1)
    height = sections[-1][0]
    keep = [0]
    for k in range(1, len(sections) - 1):  # no slivers, and the label's ends stay
        ends = {which[k - 1], which[k]} == {0, 1}
        far = sections[k][0] - sections[keep[-1]][0] > 0.07 * height
        if ends or (far and height - sections[k][0] > 0.05 * height):
            keep.append(k)
    keep.append(len(sections) - 1)
    outer = [sections[k] for k in keep]
    worn = [which[k] for k in keep[:-1]]
    inner = [(z, max(a - wall, 0.003), max(b - wall, 0.003), p) for z, a, b, p in outer[::-1]]
    inner = [s for k, s in enumerate(inner) if s[0] > 0.05 * height and (k == 0 or k % 2)]
    foot, last = outer[:2]
    a, b = (foot[i] + (last[i] - foot[i]) * 0.008 / last[0] - wall for i in (1, 2))
    inner.append((0.008, a, b, last[3]))
    return vessel([*outer, *inner], mats, worn + [0] * len(inner), n)


def shards_of(
    shell: Mesh,
    radius: float,
    height: float,
    raw: str,
    seed: int,
    neck: float = 0.86,
    around: int = 3,
) -> Part:
    """A bottle in pieces: its foot stands, the neck stays whole, the wall lies around."""
    rng = np.random.default_rng(seed)
    turn = rng.uniform(0, math.tau)
    seeds = [(-0.3 * radius * math.cos(turn), -0.3 * radius * math.sin(turn), 0.1 * height)]
    for i in range(around):
        a = turn + math.tau * (i + rng.normal(0, 0.1)) / around
        z = height * (0.58 if i % 2 else 0.42)
        seeds.append((1.1 * radius * math.cos(a), 1.1 * radius * math.sin(a), z))
    seeds.append((0, 0, neck * height))
    return broken(
        [shell], plain(raw, 0.0, occlusion=0.2), seeds, (0.3 * radius) ** 2, seed, edge=0.06
    )


def puddle(radius: float, colour, seed: int = 0, height: float = 0.005) -> Mesh:
    """What has run out: a flat lobed pool."""
    rng = np.random.default_rng(seed)
    phase = rng.uniform(0, 6.28, 3)
    n = 18
    t = np.arange(n) * math.tau / n
    lobes = 1 + 0.16 * np.sin(2 * t + phase[0]) + 0.1 * np.sin(3 * t + phase[1])
    lobes += 0.06 * np.sin(5 * t + phase[2])
    rings = [
        np.c_[radius * k * lobes * np.cos(t), radius * k * lobes * np.sin(t), np.full(n, z)]
        for k, z in ((1.0, 0.0), (0.92, height))
    ]
    m = Material(occlusion=0.3)
    shine = m.remap(m.noise(18, 1, offset=(seed % 7, 0, 0)), 0.58, 0.66, 0, 0.35)
    m.colour(m.mix(shine, colour, "ffffff"))
    mesh = loft(rings, mat=m)
    mesh.bake_uv = [[(float(mesh.v[i][0]), float(mesh.v[i][1])) for i in f] for f in mesh.f]
    return mesh


BAG_TOPS = {  # (height, width, depth) as shares, from where the bag narrows
    "seal": [(0.72, 0.99, 0.86), (0.86, 1.0, 0.5), (0.94, 1.02, 0.06), (1.0, 1.02, 0.05)],
    "open": [(0.75, 1.0, 0.92), (0.9, 1.02, 0.85), (1.0, 1.05, 0.9)],
    "block": [(0.85, 1.0, 1.0), (0.99, 0.985, 0.95), (1.0, 0.93, 0.86)],
}


def standing_bag(
    width: float,
    depth: float,
    height: float,
    mat: Material,
    top: str = "seal",
    bulge: float = 0.08,
    crumple: float = 0.02,
    form: int = 1,
    n: int = 20,
) -> Mesh:
    """A bag on a flat bottom, wide along y; an open one shows its hollow top."""
    rng = np.random.default_rng(form)
    phase = rng.uniform(0, 6.28, 4)
    levels = [(0.0, 0.94, 0.9), (0.015, 1.0, 0.98), (0.2, 1 + bulge / 4, 1 + bulge)]
    levels += [(0.5, 1.0, 1 + bulge), *BAG_TOPS[top]]
    rings = []
    for t, w, d in levels:
        power = 6.0 if t < 0.1 or top == "block" else 3.4
        ring = superellipse(depth / 2 * d, width / 2 * w, power, n, t * height)
        if 0.1 < t < 0.9:
            wave = np.sin(38 * ring[:, 1] / width + 9 * t + phase[0])
            ring[:, 0] *= 1 + crumple * wave
            ring[:, 1] *= 1 + crumple * 0.5 * math.sin(14 * t + phase[1])
        rings.append(ring)
    if top == "open":
        last = rings[-1].copy()
        for k, z in ((0.93, 1.0), (0.9, 0.82)):
            ring = last * [k, k, 1]
            ring[:, 2] = z * height
            rings.append(ring)
    mesh = loft(rings, mat=mat)
    mesh.bake_uv = None
    return mesh


def print_on(
    mesh: Mesh, picture, width: float, height: float, facing: float = 0.3, low: float = 0.0
) -> Mesh:
    """A label on the front and the back of an upright thing."""
    material = picture if isinstance(picture, Material) else label(picture)
    for side, sign in (("+x", 1), ("-x", -1)):  # not on the inside of an open one
        place = (0, low + height / 2)
        project_label(
            mesh, material, side, place, (width, height), facing, lambda c, s=sign: c[0] * s > 0
        )
    return mesh


def carton(
    depth: float,
    width: float,
    height: float,
    front,
    side=None,
    top=None,
    colour: str = "#ffffff",
    end=None,
    bevel: float = 0.0015,
) -> Mesh:
    """A printed box; front on +-x, side on +-y, top on +z."""
    faces = {"+x": label(front), "-x": label(front)}
    if side is not None:
        faces |= dict.fromkeys(("+y", "-y"), label(side))
    if top is not None:
        faces["+z"] = label(top)
    if end is not None:
        faces["-x"] = label(end)
    return box(depth, width, height, mat=plain(colour, 0.03), bevel_width=bevel, labels=faces)


def carton_piece(depth: float, width: float, height: float) -> np.ndarray:
    return box_piece((0, 0, height / 2), (depth, width, height))


def tub_ring(depth: float, width: float, radius: float, z: float, inset: float = 0.0, n: int = 4):
    """A rounded rectangle as a ring at a height."""
    outline = rounded_rectangle(depth - 2 * inset, width - 2 * inset, max(radius - inset, 0.002), n)
    return np.c_[outline, np.full(len(outline), z)]


def flap(
    length: float, reach: float, rise: float, thick: float, mat: Material, drop: float = 0.0
) -> Mesh:
    """A carton's open flap: hinged at the origin along y, reaching towards +x and up by `rise`."""
    n = np.array([-rise, reach]) / math.hypot(reach, rise) * thick
    profile = [(0, -drop), (reach, rise), (reach + n[0], rise + n[1]), (n[0], n[1])]
    y = length / 2
    v = [(x, s * y, z) for s in (-1, 1) for x, z in profile]
    f = [(0, 1, 2, 3), (7, 6, 5, 4), (0, 4, 5, 1), (1, 5, 6, 2), (2, 6, 7, 3), (3, 7, 4, 0)]
    return Mesh(v, f, None, [mat], smooth=False).outward()


def lump(radii, at, mat: Material, form: int = 1, n: int = 10, m: int = 6, rough: float = 0.15):
    """An uneven roundish piece lying on z = at[2]."""
    from toolkit.shapes import ellipsoid

    rng = np.random.default_rng(form)
    p = rng.uniform(0, 6.28, 3)
    mesh = ellipsoid(radii, (0, 0, 0), n, m, mat)
    scale = np.asarray(radii, float)
    unit = mesh.v / scale
    wave = np.sin(2.3 * unit[:, 0] + p[0]) + np.sin(2.9 * unit[:, 1] + p[1])
    mesh.v = mesh.v * (1 + rough * 0.5 * wave)[:, None]
    mesh.v[:, 2] = np.maximum(mesh.v[:, 2], -0.75 * scale[2])
    return mesh.move(at[0], at[1], at[2] - float(mesh.v[:, 2].min()))
