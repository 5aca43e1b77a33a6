"""Buckets, empty or full of water."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import Material, metal, plain, shade
from toolkit.mesh import Mesh, cube_project
from toolkit.model import Container, Model, Part, cylinder_piece, ring_pieces
from toolkit.shapes import box, lathe, loft, spline, superellipse, tube

from makers.cleaner_forms import maker
from makers.convex import few_corners


def circle(radius: float, n: int, z: float) -> np.ndarray:
    """A level ring."""
    a = np.arange(n) * math.tau / n
    return np.c_[radius * np.cos(a), radius * np.sin(a), np.full(n, z)]


def water_surface(outline: np.ndarray) -> Mesh:
    """Water seen from above: pale light dancing on blue, a dark edge."""
    m = Material(occlusion=0.3)
    light = m.remap(m.voronoi(26, feature="SMOOTH_F1"), 0.35, 0.62)
    ripples = m.mix(light, "5f9fbc", "a8d8ea")
    glint = m.remap(m.noise(18, 2, distortion=1.5, stretch=(1, 2.2, 1)), 0.62, 0.68)
    m.colour(m.mix(glint, ripples, "f4fbff"))
    return cube_project(Mesh(outline, [tuple(range(len(outline)))], materials=[m]))


def filled(title: str, body: Part, outline: np.ndarray, inside: Container, mass: float) -> Model:
    """A bucket that may be full: `outline` is the water's edge."""
    water = Part([water_surface(outline)], collision="none", occlusion="water")
    return Model(
        title,
        {"body": body, "water": water},
        mass=mass,
        variants={"default": ["body"], "full": ["body", "water"]},
        states=[
            {"state": "FULL", "variants": ["full"], "parts": ["water"]},
            {"state": "EMPTY", "variants": ["default"], "parts": ["body"]},
        ],
        containers=[inside],
        texture_size=128,
        ground_shadow=True,
        prune=False,
    )


def bucket(radius: float, height: float, colour: str, metal_body: bool, bail_down: bool) -> Model:
    """A tapered bucket; its wire handle hangs at one side or stands up."""
    body = metal("c4c9cd", "7d858b") if metal_body else plain(colour, 0.04)
    inner = plain("#a9afb3" if metal_body else colour, 0.05)
    foot, wall = radius * 0.76, 0.006
    profile = [
        (0, 0.004),
        (foot * 0.93, 0.004),
        (foot, 0),
        (radius * 0.965, height - 0.026),
        (radius + 0.005, height - 0.024),
        (radius + 0.006, height - 0.004),
        (radius, height),
        (radius - wall, height),
        (foot - wall, 0.012),
        (0, 0.012),
    ]
    shell = lathe(profile, 24, mats=[body, inner], mat_of_segment=[0] * 7 + [1, 1]).weigh(1.2)
    wire = metal("b4b9bd", "6a7075")
    swing = -0.12 if bail_down else math.pi / 2
    reach = radius + 0.008
    arc = []
    for t in np.linspace(0, math.pi, 13):
        along, out = reach * math.cos(t), reach * math.sin(t)
        arc.append((out * math.cos(swing), along, height - 0.02 + out * math.sin(swing)))
    bail = tube(arc, 0.0035, 6, mat=wire, weight=0.7)
    grip_span = [p for p in arc if abs(p[1]) < 0.42 * reach]
    grip = tube(
        grip_span, 0.0085, 8, mat=plain("#2c2c2e" if metal_body else "#f2f2f0", 0.05), weight=0.8
    )
    ears = [
        box(0.022, 0.01, 0.026, (0, s * (radius + 0.004), height - 0.034), body, bevel_width=0.003)
        for s in (-1, 1)
    ]
    pieces = [
        cylinder_piece(foot, 0, 0.014, 14),
        *ring_pieces(
            [(foot, 0), (radius, height)], [(foot - wall, 0.008), (radius - wall, height)], 12
        ),
    ]
    side = 2 * 0.68 * foot
    inside = Container("inside", (0, 0, 0.014 + (height - 0.02) / 2), (side, side, height - 0.02))
    part = Part([shell, bail, grip, *ears], collision=pieces)
    level = 0.82 * height
    at = foot + (radius - foot) * level / height - wall
    title = "zinc bucket" if metal_body else "plastic bucket"
    return filled(title, part, circle(at, 24, level), inside, 0.9 if metal_body else 0.45)


def walls(rings: list[np.ndarray], inner: list[np.ndarray]) -> list[np.ndarray]:
    """Convex pieces of an angular vessel: its wall between four outer and four inner corners."""
    n = len(rings[0])
    pieces = []
    for k in range(8):
        i, j = k * n // 8, (k + 1) * n // 8 % n
        points = [r[m] for r in (*rings, *inner) for m in (i, (i + j) // 2 if j > i else i, j)]
        pieces.append(np.array(points))
    return pieces


def angular_bucket(colour: str, wringer: bool) -> Model:
    """A square bucket, or an oval mop bucket with a wringer basket."""
    power = 2.8 if wringer else 6.0
    (a, b), h = ((0.145, 0.2), 0.27) if wringer else ((0.13, 0.13), 0.27)
    n, wall = 24, 0.007

    def ring(f: float, z: float, less: float = 0.0) -> np.ndarray:
        return superellipse(a * f - less, b * f - less, power, n, z)

    outer = [ring(0.8, 0), ring(0.97, h - 0.024), ring(1.03, h - 0.022), ring(1.03, h - 0.002)]
    inner = [ring(1.0, h), ring(0.99, h, wall), ring(0.8, 0.012, wall)]
    body, inside_mat = plain(colour, 0.04), plain(shade(colour, 0.9), 0.05)
    shell = loft(
        [*outer, *inner], mats=[body, inside_mat], mat_of_face=lambda k, i: int(k >= 5)
    ).weigh(1.2)
    meshes = [shell]
    wire = metal("b4b9bd", "6a7075")
    reach = b + 0.012
    arc = []
    for t in np.linspace(0, math.pi, 13):
        y, up = reach * math.cos(t), 0.85 * reach * math.sin(t)
        arc.append((0.0, y, h - 0.03 + up))
    meshes.append(tube(arc, 0.0045, 6, mat=wire, up=(1, 0, 0)))
    meshes.append(tube(arc[5:8], 0.0105, 8, mat=plain("#2c2c2e", 0.05), up=(1, 0, 0)))
    top = np.concatenate([ring(0.8, 0), ring(0.8, 0.014)])
    pieces = [top, *walls([outer[0], outer[3]], [inner[2], inner[1]])]
    if wringer:  # a funnel of slots hangs in one half
        dark, grid = plain("#26282c", 0.04), plain("#3a3f45", 0.3, 220)
        rings = []
        for f, z in ((0.45, h - 0.11), (1.0, h + 0.012), (1.06, h + 0.012), (1.06, h + 0.03)):
            rings.append(superellipse(0.105 * f, 0.088 * f, 3, 16, z) + np.array([0, -0.1, 0]))
        for f, z in ((0.94, h + 0.03), (0.9, h - 0.0), (0.34, h - 0.1)):
            rings.append(superellipse(0.105 * f, 0.088 * f, 3, 16, z) + np.array([0, -0.1, 0]))
        funnel = loft(rings, mats=[grid, dark], mat_of_face=lambda k, i: int(2 <= k <= 4 or i % 2))
        meshes.append(funnel)
        pieces.append(few_corners(funnel.v))
    level = 0.8 * h
    f = 0.8 + 0.19 * level / h
    side = 1.3 * 0.8 * a
    inside = Container("inside", (0, 0, 0.014 + (h - 0.02) / 2), (side, side, h - 0.02))
    part = Part(meshes, collision=pieces)
    title = "mop bucket with a wringer" if wringer else "square bucket"
    return filled(title, part, ring(f, level, wall), inside, 1.1 if wringer else 0.6)


def rubber_tub(colour: str) -> Model:
    """A low flexible bucket with two loop handles."""
    r, h, wall = 0.195, 0.24, 0.01
    foot = 0.72 * r
    body, inner = plain(colour, 0.05), plain(shade(colour, 0.85), 0.06)
    profile = [(0, 0.003), (foot * 0.94, 0.003), (foot, 0), (0.99 * r, h - 0.02), (r, h - 0.008)]
    profile += [(r - 0.004, h), (r - wall, h - 0.004), (foot - wall, 0.014), (0, 0.012)]
    shell = lathe(profile, 26, mats=[body, inner], mat_of_segment=[0] * 6 + [1, 1]).weigh(1.2)
    meshes = [shell]
    for s in (-1, 1):
        path = [(-0.075, s * 0.17, h - 0.012), (-0.06, s * 0.192, h + 0.045)]
        path += [(0.06, s * 0.192, h + 0.045), (0.075, s * 0.17, h - 0.012)]
        meshes.append(tube(spline(path, 3), 0.0125, 7, mat=body, up=(0, 1, 0)))
    pieces = [
        cylinder_piece(foot, 0, 0.014, 14),
        *ring_pieces([(foot, 0), (r, h)], [(foot - wall, 0.008), (r - wall, h)], 12),
        *[few_corners(m.v) for m in meshes[1:]],
    ]
    side = 1.3 * foot
    inside = Container("inside", (0, 0, 0.014 + (h - 0.02) / 2), (side, side, h - 0.02))
    level = 0.78 * h
    edge = circle(foot + (r - foot) * level / h - wall, 26, level)
    return filled("flexible bucket", Part(meshes, collision=pieces), edge, inside, 0.8)


def bucket_form(shape: str, colour: str) -> Model:
    """A bucket: round with its handle "down" or "up", "square", with a "wringer", a "tub".

    colour "zinc": of metal.
    """
    zinc = colour == "zinc"
    if shape == "down":
        return bucket(0.13109132215612623, 0.26080181659297397, colour, zinc, True)
    if shape == "up":
        return bucket(0.14422281241238372, 0.2886004846447464, colour, zinc, False)
    return rubber_tub(colour) if shape == "tub" else angular_bucket(colour, shape == "wringer")


MODELS = {
    "bucket": maker(
        bucket_form,
        ("shape", "colour"),
        [
            ("down", "#2f6fc0"),
            ("down", "zinc"),
            ("up", "#e8b92c"),
            ("square", "#d8303a"),
            ("wringer", "#f2c21e"),
            ("tub", "#3a9a5a"),
            ("up", "zinc"),
            ("square", "#5a6068"),
        ],
    )
}
