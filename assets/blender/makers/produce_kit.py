"""Fruit and vegetables of every kind: skins that age, cut faces, and ways to lie together."""

from __future__ import annotations

import math
from collections.abc import Callable
from itertools import pairwise

import bmesh
import numpy as np
from toolkit.materials import Material, blend, plain
from toolkit.mesh import Mesh
from toolkit.model import Model, Part
from toolkit.shapes import lathe, loft, rounded_rectangle, spline, tube

from makers.convex import few_corners
from makers.spoilage import SPOILED, aged, bruise, on_table

Point = tuple[float, float, float]
WHITE_MOULD, GREEN_MOULD, BLUE_MOULD = "e6e7dc", "7f9a74", "5f7f7a"


# ---- ageing
def patches(r: float, z: float, seed: int = 0) -> list[tuple[float, ...]]:
    """Where a round thing about z goes mouldy: on all sides, large and small, none regular."""
    rng = np.random.default_rng(seed)
    out = []
    for k, (a, up, scale) in enumerate(
        (
            (0.35, 0.4, 1.0),
            (2.5, 0.3, 0.9),
            (-1.75, 0.45, 0.85),
            (1.35, 0.0, 0.55),
            (-0.5, -0.1, 0.5),
        )
    ):
        a += rng.uniform(-0.3, 0.3)
        out.append((r * 0.9 * math.cos(a), r * 0.9 * math.sin(a), z + r * up, scale))
        if k < 3:
            out.append(
                (r * 0.8 * math.cos(a + 0.75), r * 0.8 * math.sin(a + 0.75), z + r * 0.7, 0.4)
            )
    return out


def along(length: float, r: float, count: int = 4, axis: int = 1) -> list[tuple[float, ...]]:
    """Where something long that lies along an axis goes mouldy."""
    out = []
    for i in range(count):
        t = (i + 0.5) / count - 0.5
        p = [r * (0.55 if i % 2 else -0.35), 0.0, r * 1.6]
        p[axis], p[1 - axis] = length * t, p[0]
        out.append((*p, 1.0 - 0.25 * (i % 2)))
    return out


def rot(m: Material, c, size: float, spots, o, brown="3b200e", amount=0.45):
    """Browned all over, sunken dark blotches, and on them fuzz: white edges, grey-green hearts."""
    near = None
    for x, y, z, *scale in spots:
        d = m.math("DIVIDE", m.distance((x, y, z)), scale[0] if scale else 1.0)
        near = d if near is None else m.math("MINIMUM", near, d)

    def rough(scale: float, detail: float, much: float, offset):
        n = m.math("SUBTRACT", m.noise(scale / size, detail, 0.65, offset=offset), 0.5)
        return m.math("MULTIPLY", n, size * much)

    field = m.math("ADD", near, rough(1.6, 3, 1.3, o))
    c = m.mix(amount, c, "6b4520")
    c = m.mix(m.remap(field, size * 0.8, size * 1.05, 0.9, 0), c, "54321a")
    c = m.mix(m.remap(field, size * 0.62, size * 0.78, 1, 0), c, brown)
    fuzz = m.math("ADD", field, rough(5, 4, 0.7, (o[1], o[0], o[2])))
    c = m.mix(m.remap(fuzz, size * 0.5, size * 0.58, 1, 0), c, WHITE_MOULD)
    grain = m.remap(m.noise(7 / size, 3, offset=o), 0.35, 0.6, 0.25, 1)
    heart = m.math("MULTIPLY", m.remap(fuzz, size * 0.26, size * 0.44, 1, 0), grain)
    c = m.mix(heart, c, GREEN_MOULD)
    dark = m.remap(m.voronoi(5 / size, (o[2], 3, o[0])), 0.1, 0.22, 0.8, 0)
    return m.mix(m.math("MULTIPLY", dark, heart), c, BLUE_MOULD)


def matured(look: str, m: Material, c, size: float, spots, o, brown="3b200e", amount=0.45):
    """The colour of a skin fresh, overripe or rotten."""
    if look == "overripe":
        return bruise(m, c, size, o)
    return rot(m, c, size, spots, o, brown, amount) if look == "rotten" else c


def skin(
    look: str,
    tones: tuple,
    r: float,
    spots,
    o,
    scale: float = 30.0,
    streak: tuple | None = None,
    freckle: tuple | None = None,
    blush: tuple | None = None,
    ends: list[tuple] | None = None,
    gloss: tuple | None = None,
    grid: str | None = None,
    brown: str = "3b200e",
    amount: float = 0.45,
) -> Material:
    """The skin of a fruit.

    tones: two colours it is mottled with. streak: (colour, stretch, low, high) of stretched
    noise; freckle: (colour, scale, size) dots; blush: (colour, low, high) of wide noise;
    ends: [(axis, from, to, colour)]; gloss: (point, radius, colour); grid: colour of a net.
    """
    m = Material()
    c = m.mix(m.remap(m.noise(scale, 3, offset=o), 0.35, 0.65), *tones)
    if streak:
        colour, stretch, low, high = streak
        c = m.mix(m.remap(m.noise(1, 3, offset=o, stretch=stretch), low, high, 0, 0.85), c, colour)
    if blush:
        colour, low, high = blush
        c = m.mix(
            m.remap(m.noise(0.6 / r, 3, offset=(o[1], o[2], 0)), low, high, 0, 0.9), c, colour
        )
    if freckle:
        colour, dots, size = freckle
        c = m.mix(m.remap(m.voronoi(dots, o), size * 0.6, size, 0.8, 0), c, colour)
    for axis, start, end, colour in ends or ():
        c = m.mix(m.remap(m.axis(axis), start, end, 0, 0.85), c, colour)
    if gloss and look == "fresh":
        point, radius, colour = gloss
        c = m.mix(m.remap(m.distance(point), 0, radius, 0.6, 0), c, colour)
    c = matured(look, m, c, r, spots, o, brown, amount)
    if grid:
        for k in (-1, 1):
            around = m.math("ADD", m.axis(0), m.math("MULTIPLY", m.axis(1), k))
            t = m.math("ADD", m.axis(2), m.math("MULTIPLY", around, 0.7 * k))
            wave = m.math("ABSOLUTE", m.math("SINE", m.math("MULTIPLY", t, 2.6 / r)))
            c = m.mix(m.remap(wave, 0.1, 0.24, 0.9, 0), c, grid)
    return m.colour(c)


def cut_face(look: str, picture, r: float, spots, o, brown="4a2c14", amount=0.4) -> Material:
    """A drawn cut face that ages with the rest."""
    m = Material(occlusion=0.8)
    return m.colour(matured(look, m, m.image(picture), r, spots, o, brown, amount))


# ---- shapes
def outline_points(points, count: int, s: float = 1.0) -> list[tuple[float, float]]:
    """A smooth lathe profile through (radius, z) points."""
    curve = spline([(q * s, z * s) for q, z in points], 8)
    steps = np.r_[0, np.cumsum(np.linalg.norm(np.diff(curve, axis=0), axis=1))]
    at = np.linspace(0, steps[-1], count)
    profile = [
        (max(0.0, float(np.interp(t, steps, curve[:, 0]))), float(np.interp(t, steps, curve[:, 1])))
        for t in at
    ]
    profile[0], profile[-1] = (0.0, profile[0][1]), (0.0, profile[-1][1])
    return profile


def turned(points, n: int, count: int, mat=None, s: float = 1.0, lobes=(0, 0.0, 0.0)) -> Mesh:
    """A fruit turned about z from its outline; lobes: (how many, how deep, phase)."""
    mesh = lathe(outline_points(points, count, s), n, mat=mat, discs=False)
    waves, deep, phase = lobes
    if waves:

        def bulge(x, y, z):
            f = 1 + deep * math.cos(waves * math.atan2(y, x) + phase)
            return x * f, y * f, z

        mesh.warp(bulge)
    return mesh


def halve(mesh: Mesh, point, normal, face: Material, up=(0, 0, 1.0)) -> Mesh:
    """Cut away what lies beyond a plane; the cut face shows `face`, upright along `up`."""
    normal = np.asarray(normal, float) / np.linalg.norm(normal)
    bm = bmesh.new()
    verts = [bm.verts.new(p) for p in mesh.v]
    layers = [bm.loops.layers.uv.new(k) for k in ("label", "bake")]
    for i, f in enumerate(mesh.f):
        new = bm.faces.new([verts[j] for j in f])
        new.material_index = mesh.mi[i]
        for layer, values in zip(layers, (mesh.label_uv, mesh.bake_uv), strict=True):
            for loop, uv in zip(new.loops, values[i] if values else (), strict=False):
                loop[layer].uv = uv
    everything = bm.verts[:] + bm.edges[:] + bm.faces[:]
    bmesh.ops.bisect_plane(
        bm, geom=everything, dist=1e-6, plane_co=point, plane_no=normal, clear_outer=True
    )
    rim = {v: [e.other_vert(v) for e in v.link_edges if e.is_boundary] for v in bm.verts}
    start = next(v for v, near in rim.items() if near)
    loop, here, last = [start], rim[start][0], start
    while here is not start:
        loop.append(here)
        here, last = next(v for v in rim[here] if v is not last), here
    points = np.array([v.co[:] for v in loop])
    right = np.cross(np.asarray(up, float) - normal * np.dot(up, normal), normal)
    right /= np.linalg.norm(right)
    upward = np.cross(normal, right)
    flat = np.c_[points @ right, points @ upward]
    area = sum(a[0] * b[1] - b[0] * a[1] for a, b in pairwise([*flat, flat[0]]))
    if area < 0:
        loop, flat = loop[::-1], flat[::-1]
    cap = bm.faces.new(loop)
    cap.material_index = len(mesh.mats)
    low, size = flat.min(0), np.ptp(flat, axis=0)
    far = 20 * float(np.ptp(mesh.v, axis=0).max()) * (len(mesh.mats) + 1)
    for corner, q in zip(cap.loops, flat, strict=True):
        corner[layers[0]].uv = (q - low) / size
        corner[layers[1]].uv = (q[0] + far, q[1])
    bm.verts.index_update()
    label, bake = ([[lp[k].uv[:] for lp in f.loops] for f in bm.faces] for k in layers)
    out = Mesh(
        [v.co[:] for v in bm.verts],
        [[v.index for v in f.verts] for f in bm.faces],
        [f.material_index for f in bm.faces],
        [*mesh.mats, face],
        label,
        bake if mesh.bake_uv else None,
        mesh.weight,
        mesh.smooth,
    )
    bm.free()
    return out


def ground(meshes: list[Mesh]) -> list[Mesh]:
    """Set a group of meshes on z = 0."""
    low = min(m.v[:, 2].min() for m in meshes)
    return [m.move(z=-low) for m in meshes]


def leaf(length: float, width: float, mat, lift: float = 0.25, rings: int = 4) -> Mesh:
    """A flat pointed leaf from the origin along +x, bending up, then down."""
    out = []
    for t in np.linspace(0, 1, rings):
        w = max(width / 2 * math.sin(math.pi * min(0.97, t * 0.93 + 0.04)) ** 0.8, 2e-4)
        z = length * lift * math.sin(t * 2.3)
        x = t * length
        out.append([(x, -w, z), (x, 0, z - w * 0.3), (x, w, z), (x, 0, z - w * 0.3 - 0.0012)])
    return loft(out, mat=mat)


def stalk(base: Point, height: float, radius: float, mat, lean: float = 0.15, n: int = 5) -> Mesh:
    x, y, z = base
    path = [
        (x, y, z - radius),
        (x + lean * height * 0.3, y, z + height * 0.5),
        (x + lean * height, y, z + height),
    ]
    return tube(path, [radius, radius * 0.85, radius * 1.25], n, mat=mat)


def green(look: str, colour="4f8a2c") -> Material:
    """Stalks and leaves, which dry up."""
    tone = {"fresh": colour, "overripe": blend(colour, "8a7a34", 0.65), "rotten": "5a4824"}[look]
    return plain(tone, 0.2, 200)


def woody(look: str) -> Material:
    return plain("5a3a1c" if look != "rotten" else "3f2a14", 0.2, 300)


def punnet(width: float, length: float, height: float, mat, floor: float = 0.004) -> Mesh:
    """An open tray, `length` along y."""
    rings = []
    for k, z in ((0.008, 0), (0.0, height), (0.004, height), (0.011, floor)):
        outline = rounded_rectangle(width - 2 * k, length - 2 * k, 0.014, 3)
        rings.append(np.c_[outline, np.full(len(outline), z)])
    return loft(rings, mat=mat)


# ---- ways to lie together: copies of a group at (x, y, z, yaw)
def spread(group: list[Mesh], places) -> list[Mesh]:
    out = []
    for x, y, z, yaw, *lean in places:
        for mesh in group:
            twin = mesh.copy()
            if twin.rest is None:
                twin.keep_pattern()
            if lean:
                twin.turn(ry=lean[0])
            out.append(twin.turn(rz=yaw).move(x, y, z))
    return out


def layout(form: str, r: float, gap: float = 1.0) -> list[tuple[float, ...]]:
    """Places of round things of radius r (across) for the names of common groups."""
    d = r * gap
    if form == "pair":
        return [(0.1 * d, -d, 0, 0.4), (-0.1 * d, d, 0, 2.7)]
    if form == "three":
        return [(0.62 * d, -d, 0, 0.4), (0.5 * d, d, 0, 2.9), (-1.14 * d, 0.05 * d, 0, 4.4)]
    if form == "pile":
        base = [(0.62 * d, -d, 0, 0.4), (0.5 * d, d, 0, 2.9), (-1.14 * d, 0.05 * d, 0, 4.4)]
        return [*base, (0, 0, 1.55 * d, 1.7)]
    if form == "row":
        return [(0.15 * d * (-1) ** i, (i - 1) * 2.02 * d, 0, 0.4 + 2 * i) for i in range(3)]
    if form == "five":
        base = [(d, -d, 0, 0.4), (d, d, 0, 2.9), (-d, -d, 0, 4.4), (-d, d, 0, 1.2)]
        return [*base, (0, 0, 1.35 * d, 1.7)]
    raise ValueError(form)


# ---- models
def footed(group: list[Mesh]) -> list[np.ndarray]:
    """A hull for every larger mesh; those on the ground get a flat foot, not to roll away."""
    spans = [float(np.ptp(m.v, axis=0).max()) for m in group]
    pieces = []
    for mesh, span in zip(group, spans, strict=True):
        if span < 0.42 * max(spans):
            continue
        points = few_corners(mesh.v, 24)
        if points[:, 2].min() < 0.004:
            middle, half = points.mean(0), np.ptp(points, axis=0) * 0.3
            foot = [
                (middle[0] + a * half[0], middle[1] + b * half[1], 0.0)
                for a in (-1, 1)
                for b in (-1, 1)
            ]
            points = np.concatenate([points, foot])
        pieces.append(points)
    return pieces


def one_hull(group: list[Mesh]) -> list[np.ndarray]:
    points = few_corners(np.concatenate([m.v for m in group]), 40)
    return [np.concatenate([points, points * [0.8, 0.8, 0.0]])]


def fresh_produce(
    title: str,
    shape: Callable[[str], list[Mesh]],
    mass: float,
    pieces: Callable[[list[Mesh]], list[np.ndarray]] = footed,
    texture_size: int = 128,
) -> Model:
    """A model with the looks fresh, overripe and rotten."""
    return aged(title, shape, mass, pieces, texture_size)


def baked_good(
    title: str,
    shape: Callable[[bool], list[Mesh]],
    mass: float,
    pieces: Callable[[list[Mesh]], list[np.ndarray]] = footed,
    texture_size: int = 256,
    dish: Callable[[], list[Mesh]] | None = None,
) -> Model:
    """A model fresh and mouldy: `shape(rotten)`.

    What it is served on, if anything, stays as it is and shows nothing: `dish` stands on z = 0, a
    part of its own.
    """
    fresh, rotten = shape(False), shape(True)
    under = {}
    if dish:
        served = dish()
        under["dish"] = Part(served, collision=footed(served))
    else:
        on_table(fresh, rotten)
    return Model(
        title=title,
        mass=mass,
        friction=0.7,
        texture_size=texture_size,
        parts={
            **under,
            "body": Part(fresh, collision=pieces(fresh)),
            "body_rotten": Part(rotten, collision=pieces(rotten)),
        },
        variants={"default": [*under, "body"], "rotten": [*under, "body_rotten"]},
        states=SPOILED,
        smooth_deg=55,
    )
