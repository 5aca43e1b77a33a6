"""What sofas and armchairs share: walls bent round a seat, rolled arms, buttoned cloth."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

import numpy as np
from toolkit.materials import Material, plain, shade
from toolkit.mesh import Mesh
from toolkit.shapes import ellipsoid, loft, rounded_rectangle

from .joinery import Assembly

Point = Sequence[float]


def buttoned(
    colour: str, step: float = 0.13, offset: Point = (0, 0, 0), rise: float = 0.0
) -> Material:
    """Diamonds, light in their middle, dark along their seams: on upright faces, or, with `rise`
    (their height; `step` is their width), on a mesh that `unrolled` has measured."""
    m = Material()
    if rise:
        along = m.math("MULTIPLY", m.drawn(0), 1.0 / step)
        up, start = m.math("MULTIPLY", m.drawn(1), 1.0 / rise), 0.5
    else:
        along = m.math("MULTIPLY", m.math("ADD", m.axis(0), m.axis(1)), 1.0 / step)
        up, start = m.math("MULTIPLY", m.axis(2), 1.0 / step), 0.0
    fields = []
    for sign in ("ADD", "SUBTRACT"):
        phase = m.math("FRACT", m.math("ADD", m.math(sign, along, up), start))
        fields.append(m.math("ABSOLUTE", m.math("SUBTRACT", phase, 0.5)))
    away = m.math("MAXIMUM", *fields)
    body = m.mottle(colour, 0.06, 25, tuple(offset))
    swell = m.mix(m.remap(away, 0.05, 0.36, 0.22, 0), body, shade(colour, 1.6))
    return m.colour(m.mix(m.remap(away, 0.34, 0.5, 0, 0.8), swell, shade(colour, 0.45)))


def unrolled(mesh: Mesh, path: np.ndarray, ring: np.ndarray, bare: range, origin: Point) -> Mesh:
    """Give a `wall` a label UV in metres from `origin`: along its path, and along its cut from the
    foot of the inner face, its last point but one. What spans only the points `bare` of the cut,
    and its ends, lie in the middle of a diamond."""
    n = len(ring)
    start = n - 2
    order = [(start + k) % n for k in range(n)]
    steps = np.linalg.norm(np.diff(ring[order], axis=0), axis=1)
    height = dict(zip(order, np.r_[0, np.cumsum(steps)], strict=True))
    length = np.r_[0, np.cumsum(np.linalg.norm(np.diff(path, axis=0), axis=1))]
    mesh.label_uv = []
    for face in mesh.f:
        if len(face) > 4 or all(v % n in bare for v in face):
            mesh.label_uv.append([(0.0, 0.0)] * len(face))
            continue
        spots = [(length[v // n] - origin[0], height[v % n] - origin[1]) for v in face]
        mesh.label_uv.append(spots)
    return mesh


def leather(colour: str, offset: Point = (0, 0, 0)) -> Material:
    """Worn leather: lighter where it is rubbed, finely creased."""
    m = Material()
    worn = m.remap(m.noise(4, 4, offset=tuple(offset)), 0.35, 0.7, 0, 0.8)
    light = tuple(min(1.0, c) for c in shade(colour, 1.28))
    base = m.mix(worn, colour, light)
    crease = m.remap(m.noise(60, 4, 0.7, offset=tuple(offset)), 0.5, 0.66, 0, 0.35)
    return m.colour(m.mix(crease, base, shade(colour, 0.6)))


def velvet_studs(asm: Assembly, spots: Sequence[Point], colour: str, r: float = 0.013) -> None:
    """Buttons sunk into a back."""
    mat = plain(shade(colour, 0.5), 0.05, 20)
    for p in spots:
        asm.add("body", ellipsoid((r, r, r), p, 6, 4, mat))


def horseshoe(
    x0: float, x1: float, half: float, radius: float, arc: int = 5, arm: int = 2, back: int = 2
) -> np.ndarray:
    """From the left arm's front round the back to the right arm's front."""
    r = min(radius, half - 1e-3)
    points = [(x, -half) for x in np.linspace(x1, x0 + r, arm + 1)]
    points += [
        (x0 + r - r * math.sin(t), -half + r - r * math.cos(t))
        for t in np.linspace(0, math.pi / 2, arc + 1)[1:]
    ]
    points += [(x0, y) for y in np.linspace(-half + r, half - r, back + 1)[1:]]
    points += [(x, -y) for x, y in points[: arm + arc + 1][::-1][1:]]
    return np.array(points)


def section(thick: float, z0: float, z1: float, soft: float = 0.04) -> np.ndarray:
    """A wall's cut: rounded above, (outwards, z)."""
    ring = rounded_rectangle(thick, z1 - z0, min(soft, 0.45 * thick), 3)
    return np.add(ring, [0, (z0 + z1) / 2])


def scroll(thick: float, z0: float, z1: float, r: float) -> np.ndarray:
    """A wall's cut with a roll on top that hangs over outwards."""
    inner, outer = -thick / 2, thick / 2
    cx, cz = inner + r * 0.9, z1 - r
    a = np.linspace(math.pi * 0.89, -math.pi * 0.42, 8)
    roll = [(cx + r * math.cos(t), cz + r * math.sin(t)) for t in a]
    foot = [(outer, z1 - 2.1 * r), (outer, z0), (inner, z0), (inner, z1 - 2.0 * r)]
    return np.array([*roll, *foot])


def wall(
    path: np.ndarray, cut: Callable[[float], np.ndarray], mat: Material, lean: float = 0.0
) -> Mesh:
    """Sweep cut(s), s = 0..1 along the path, outwards to its left; `lean` tips its top out."""
    tangents = np.gradient(path, axis=0)
    tangents /= np.linalg.norm(tangents, axis=1)[:, None]
    steps = np.r_[0, np.cumsum(np.linalg.norm(np.diff(path, axis=0), axis=1))]
    rings = []
    for p, t, s in zip(path, tangents, steps / steps[-1], strict=True):
        normal = np.array([-t[1], t[0]])
        shape = cut(float(s))
        low = shape[:, 1].min()
        out = shape[:, 0] + lean * (shape[:, 1] - low)
        rings.append(np.c_[p + out[:, None] * normal, shape[:, 1]])
    return loft(rings, mat).outward()


def solid_path(
    asm: Assembly, path: np.ndarray, thick: float, z0: float, z1: Callable[[float], float]
) -> None:
    """Collision boxes along a bent wall, a few points each."""
    n = len(path)
    step = max(1, n // 7)
    for i in range(0, n - 1, step):
        j = min(i + step, n - 1)
        a, b = path[i], path[j]
        t = (b - a) / (np.linalg.norm(b - a) + 1e-9)
        normal = np.array([-t[1], t[0]]) * thick / 2
        top = max(z1(i / (n - 1)), z1(j / (n - 1)))
        corners = [(*(p + s * normal), z) for p in (a, b) for s in (-1, 1) for z in (z0, top)]
        asm.piece("body", np.array(corners))
