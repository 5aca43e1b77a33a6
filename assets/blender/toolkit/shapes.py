"""Primitive shapes: each returns a closed `Mesh` with sensible label and bake UVs."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

import numpy as np

from .mesh import Mesh, bevel, cube_project

TAU = 2 * math.pi
BOX_FACES = ("-x", "+x", "-y", "+y", "-z", "+z")


def box(
    sx: float,
    sy: float,
    sz: float,
    at=(0, 0, 0),
    mat=None,
    bevel_width: float = 0.0,
    segments: int = 1,
    labels: dict[str, tuple] | None = None,
    weight: float = 1.0,
) -> Mesh:
    """A box standing on `at` (centre of its bottom face).

    labels: face name ("+x", "-y", ...) -> material, or (material, (u0, v0, u1, v1)) to show that
    rectangle of the drawn label upright; the other faces wear `mat`.
    """
    x, y = sx / 2, sy / 2
    v = [(a, b, c) for a in (-x, x) for b in (-y, y) for c in (0, sz)]
    f = [(0, 1, 3, 2), (6, 7, 5, 4), (4, 5, 1, 0), (2, 3, 7, 6), (2, 6, 4, 0), (1, 5, 7, 3)]
    mats, mi, luv = [mat], [0] * 6, [[(0.02, 0.02)] * 4 for _ in range(6)]
    for name, value in (labels or {}).items():
        material, rect = value if isinstance(value, tuple) else (value, (0, 0, 1, 1))
        k = BOX_FACES.index(name)
        if material not in mats:
            mats.append(material)
        mi[k] = mats.index(material)
        u0, v0, u1, v1 = rect
        # corner order of each face above, so that the label reads upright from outside;
        # the top reads upright when seen from the front (+x)
        luv[k] = {
            "-x": [(u1, v0), (u1, v1), (u0, v1), (u0, v0)],
            "+x": [(u1, v0), (u1, v1), (u0, v1), (u0, v0)],
            "-y": [(u1, v0), (u1, v1), (u0, v1), (u0, v0)],
            "+y": [(u1, v0), (u1, v1), (u0, v1), (u0, v0)],
            "-z": [(u0, v1), (u0, v0), (u1, v0), (u1, v1)],
            "+z": [(u0, v1), (u0, v0), (u1, v0), (u1, v1)],
        }[name]
    mesh = cube_project(Mesh(v, f, mi, mats, luv, weight=weight))
    if bevel_width:
        mesh = bevel(mesh, min(bevel_width, 0.45 * min(sx, sy, sz)), segments)
    return mesh.move(*at)


def lathe(
    profile: Sequence[tuple[float, float]],
    n: int = 24,
    mat=None,
    mats: Sequence | None = None,
    mat_of_segment: Sequence[int] | None = None,
    label_z: tuple[float, float] | None = None,
    start: float = 0.0,
    rib: Callable[[int, int], float] | None = None,
    discs: bool = True,
    weight: float = 1.0,
) -> Mesh:
    """Revolve (radius, z) pairs about z, listed from the bottom's centre outwards and up.

    label_z: the band a label's v covers; label u runs anticlockwise from angle `start`
    (so u = 0.5 faces +X when start = -pi). rib(segment, column) scales a column's radius.
    """
    profile = [(max(r, 0.0), z) for r, z in profile]
    vertices, index = [], []
    for k, (r, z) in enumerate(profile):
        if r < 1e-9:
            index.append([len(vertices)] * (n + 1))
            vertices.append((0, 0, z))
            continue
        row = []
        for i in range(n):
            a, q = start + TAU * i / n, r * (rib(k, i) if rib else 1)
            row.append(len(vertices))
            vertices.append((q * math.cos(a), q * math.sin(a), z))
        index.append([*row, row[0]])
    widest = max(r for r, _ in profile)
    spacing = 8 * max(widest, 0.5 * np.ptp([z for _, z in profile]))
    z0, z1 = label_z or (min(z for _, z in profile), max(z for _, z in profile))
    faces, mi, luv, buv = [], [], [], []
    island, climbed, previous = 0.0, 0.0, None
    for k in range(len(profile) - 1):
        (r0, za), (r1, zb) = profile[k], profile[k + 1]
        length = math.hypot(r1 - r0, zb - za)
        if length < 1e-9:
            continue
        disc = discs and abs(r1 - r0) > abs(zb - za) * 1.7
        angle = math.atan2(zb - za, r1 - r0)
        if previous is None or disc != previous[0] or abs(angle - previous[1]) > 0.9:
            island, climbed = island + 1, 0.0
        for i in range(n):
            quad = [index[k][i], index[k][i + 1], index[k + 1][i + 1], index[k + 1][i]]
            corners = (
                [0, 2, 3]
                if quad[0] == quad[1]
                else [0, 1, 2]
                if quad[2] == quad[3]
                else [0, 1, 2, 3]
            )
            faces.append([quad[c] for c in corners])
            mi.append(mat_of_segment[k] if mat_of_segment else 0)
            us, zs, rs = (
                [i / n, (i + 1) / n, (i + 1) / n, i / n],
                [za, za, zb, zb],
                [r0, r0, r1, r1],
            )
            if r0 < 1e-9:
                us[0] = (i + 0.5) / n
            if r1 < 1e-9:
                us[2] = us[3] = (i + 0.5) / n
            luv.append([(us[c], (zs[c] - z0) / (z1 - z0 + 1e-9)) for c in corners])
            if disc:
                polar = [(rs[c], start + TAU * us[c]) for c in corners]
                # a disc seen from below is mirrored, otherwise its texels would be
                flip = 1 if r1 < r0 else -1
                buv.append(
                    [(island * spacing + flip * r * math.cos(a), r * math.sin(a)) for r, a in polar]
                )
            else:
                around = TAU * widest * 0.9
                buv.append(
                    [
                        (island * spacing + us[c] * around, climbed + (0 if c < 2 else length))
                        for c in corners
                    ]
                )
        climbed += length
        previous = (disc, angle)
    return Mesh(vertices, faces, mi, mats or [mat], luv, buv, weight).outward()


def tube(
    points,
    radius,
    n: int = 8,
    closed: bool = False,
    mat=None,
    flatten: float = 1.0,
    up=None,
    weight: float = 1.0,
) -> Mesh:
    """A tube along points; radius may vary per point; flatten scales it along `up`."""
    path = np.asarray(points, float)
    m = len(path)
    radii = np.broadcast_to(radius, (m,))
    tangents = (np.roll(path, -1, 0) - np.roll(path, 1, 0)) if closed else np.gradient(path, axis=0)
    tangents = tangents / (np.linalg.norm(tangents, axis=1)[:, None] + 1e-12)
    u = np.array(
        up if up is not None else (0, 0, 1.0) if abs(tangents[0][2]) < 0.9 else (1.0, 0, 0)
    )
    vertices = []
    for point, tangent, r in zip(path, tangents, radii, strict=True):
        b = u - tangent * (u @ tangent)
        b = b / (np.linalg.norm(b) + 1e-12)
        if up is None:
            u = b
        c = np.cross(tangent, b)
        vertices += [
            point + r * (math.cos(a) * b * flatten + math.sin(a) * c)
            for a in (TAU * i / n for i in range(n))
        ]
    loop = np.r_[path, path[:1]] if closed else path
    length = np.r_[0, np.cumsum(np.linalg.norm(np.diff(loop, axis=0), axis=1))]
    widest = float(np.max(radii))
    step = TAU * widest / n
    faces, luv, buv = [], [], []
    for k in range(m if closed else m - 1):
        k2 = (k + 1) % m
        for i in range(n):
            j = (i + 1) % n
            faces.append((k * n + i, k * n + j, k2 * n + j, k2 * n + i))
            a, b = length[k], length[k + 1]
            buv.append([(i * step, a), ((i + 1) * step, a), ((i + 1) * step, b), (i * step, b)])
            a, b = a / length[-1], b / length[-1]
            luv.append([(i / n, a), ((i + 1) / n, a), ((i + 1) / n, b), (i / n, b)])
    if not closed:
        for k, back in ((0, True), (m - 1, False)):
            face = [k * n + i for i in range(n)]
            away = -4 * length[-1] * (1 + (k > 0))
            ring = [
                (away + widest * math.cos(TAU * i / n), widest * math.sin(TAU * i / n))
                for i in range(n)
            ]
            faces.append(tuple(face[::-1] if back else face))
            buv.append(ring[::-1] if back else ring)
            luv.append([(0, 0)] * n)
    return Mesh(vertices, faces, None, [mat], luv, buv, weight).outward()


def extrude(
    outline,
    height: float,
    mat=None,
    side_mat=None,
    bevel_width: float = 0.0,
    segments: int = 1,
    axis: str = "z",
    weight: float = 1.0,
) -> Mesh:
    """A prism from a 2D outline.

    axis "z": outline in xy, standing on z = 0; "y": outline in xz, centred on y = 0;
    "x": outline in yz, centred on x = 0. Label UV on both caps spans the outline's bounds.
    """
    p = np.asarray(outline, float)
    n = len(p)
    if sum(p[i][0] * p[(i + 1) % n][1] - p[(i + 1) % n][0] * p[i][1] for i in range(n)) < 0:
        p = p[::-1]
    v = [(x, y, 0) for x, y in p] + [(x, y, height) for x, y in p]
    f = [tuple(range(n))[::-1], tuple(range(n, 2 * n))]
    f += [(i, (i + 1) % n, n + (i + 1) % n, n + i) for i in range(n)]
    low, high = p.min(0), p.max(0)
    uv = [tuple((q - low) / (high - low + 1e-9)) for q in p]
    luv = [uv[::-1], uv] + [[uv[i], uv[(i + 1) % n], uv[(i + 1) % n], uv[i]] for i in range(n)]
    mats = [mat, side_mat] if side_mat is not None else [mat]
    mesh = Mesh(v, f, [0, 0] + [len(mats) - 1] * n, mats, luv, weight=weight)
    mesh = bevel(mesh, bevel_width, segments) if bevel_width else cube_project(mesh)
    if axis == "y":
        mesh.v = np.c_[mesh.v[:, 0], height / 2 - mesh.v[:, 2], mesh.v[:, 1]]
    if axis == "x":
        mesh.v = np.c_[mesh.v[:, 2] - height / 2, mesh.v[:, 0], mesh.v[:, 1]]
    return mesh


def loft(
    rings,
    mat=None,
    mats: Sequence | None = None,
    caps=(True, True),
    mat_of_face: Callable[[int, int], int] | None = None,
    closed: bool = True,
    weight: float = 1.0,
) -> Mesh:
    """Skin a list of rings with equally many points; label UV: u around, v along."""
    rings = [np.asarray(r, float) for r in rings]
    n, m = len(rings[0]), len(rings)
    perimeter = max(sum(np.linalg.norm(r[i] - r[(i + 1) % n]) for i in range(n)) for r in rings)
    centres = [r.mean(0) for r in rings]
    spread = [np.linalg.norm(r - c, axis=1).mean() for r, c in zip(rings, centres, strict=True)]
    steps = [
        np.linalg.norm(centres[k + 1] - centres[k]) + 0.5 * abs(spread[k + 1] - spread[k])
        for k in range(m - 1)
    ]
    along = np.r_[0, np.cumsum(steps)]
    count = n if closed else n - 1
    faces, mi, luv, buv = [], [], [], []
    for k in range(m - 1):
        for i in range(count):
            j = (i + 1) % n
            faces.append((k * n + i, k * n + j, (k + 1) * n + j, (k + 1) * n + i))
            mi.append(mat_of_face(k, i) if mat_of_face else 0)
            u0, u1, a, b = i / count, (i + 1) / count, along[k], along[k + 1]
            buv.append(
                [(u0 * perimeter, a), (u1 * perimeter, a), (u1 * perimeter, b), (u0 * perimeter, b)]
            )
            a, b = a / along[-1], b / along[-1]
            luv.append([(u0, a), (u1, a), (u1, b), (u0, b)])
    for end, (k, back) in enumerate(((0, True), (m - 1, False))):
        if not (caps[end] and closed):
            continue
        face = [k * n + i for i in range(n)]
        flat = rings[k] - centres[k]
        a, b = np.argsort(-flat.std(0))[:2]
        ring = [(-6 * max(perimeter, along[-1]) * (1 + end) + q[a], q[b]) for q in flat]
        faces.append(tuple(face[::-1] if back else face))
        mi.append(mat_of_face(0 if back else m - 2, 0) if mat_of_face else 0)
        buv.append(ring[::-1] if back else ring)
        luv.append([(0, 0 if back else 1)] * n)
    mesh = Mesh(np.concatenate(rings), faces, mi, mats or [mat], luv, buv, weight)
    return mesh.outward() if closed and all(caps) else mesh


def ellipsoid(radii, at=(0, 0, 0), n: int = 14, m: int = 9, mat=None, weight: float = 1.0) -> Mesh:
    """An ellipsoid centred on `at` (one radius or three)."""
    radii = np.broadcast_to(radii, (3,)).astype(float)
    profile = [(math.sin(math.pi * k / m), -math.cos(math.pi * k / m)) for k in range(m + 1)]
    profile[0], profile[-1] = (0.0, -1.0), (0.0, 1.0)
    mesh = lathe(profile, n, mat=mat, discs=False, weight=weight)
    mesh.v = mesh.v * radii
    mesh.bake_uv = [[(u * radii[0], v * radii[2]) for u, v in face] for face in mesh.bake_uv]
    return mesh.move(*at)


def superellipse(a: float, b: float, power: float = 2.5, n: int = 24, z: float = 0.0) -> np.ndarray:
    """A ring between an ellipse (power 2) and a rectangle (power -> infinity)."""
    t = np.arange(n) * TAU / n - math.pi / 2
    c, s = np.cos(t), np.sin(t)
    x, y = a * np.sign(c) * abs(c) ** (2 / power), b * np.sign(s) * abs(s) ** (2 / power)
    return np.c_[x, y, np.full(n, z)]


def rounded_rectangle(sx: float, sy: float, radius: float, per_corner: int = 4) -> np.ndarray:
    """A 2D outline, anticlockwise, centred on 0."""
    out = []
    for cx, cy, a0 in ((1, -1, -0.25), (1, 1, 0), (-1, 1, 0.25), (-1, -1, 0.5)):
        for i in range(per_corner):
            a = TAU * (a0 + 0.25 * i / max(per_corner - 1, 1))
            x, y = cx * (sx / 2 - radius), cy * (sy / 2 - radius)
            out.append((x + radius * math.cos(a), y + radius * math.sin(a)))
    return np.array(out)


def spline(points, per_span: int = 6, closed: bool = False) -> np.ndarray:
    """Catmull-Rom curve through the points (2D or 3D)."""
    p = np.asarray(points, float)
    n, out = len(p), []
    for i in range(n if closed else n - 1):
        if closed:
            a, b, c, d = (p[(i + k) % n] for k in (-1, 0, 1, 2))
        else:
            a, b, c, d = p[max(i - 1, 0)], p[i], p[i + 1], p[min(i + 2, n - 1)]
        for j in range(per_span):
            t = j / per_span
            cubic = (2 * a - 5 * b + 4 * c - d) * t * t + (3 * b - a - 3 * c + d) * t**3
            out.append(0.5 * (2 * b + (c - a) * t + cubic))
    if not closed:
        out.append(p[-1])
    return np.array(out)
