"""Tea towels and oven mitts."""

from __future__ import annotations

import math

import numpy as np
from PIL import Image
from toolkit import labels
from toolkit.materials import Material, label, plain, shade
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part, box_piece
from toolkit.shapes import box, loft, superellipse, tube

from makers.convex import few_corners
from makers.soft_forms import drape, folds, mound, rectangle_outline
from makers.soft_things import block

#: The whole cloth, metres.
CLOTH = (0.45, 0.65)


def weave(kind: str, ground: str, ink: str) -> Image.Image:
    """The pattern of a whole cloth, its length across: "check", "pane" (thin double lines) or
    "stripes" near both ends."""
    w, h = 260, 180
    image, draw = labels.canvas(w, h, ground)
    if kind == "check":
        pixels = np.asarray(image.convert("RGB"), float)
        dark = np.array([int(ink[i : i + 2], 16) for i in (1, 3, 5)], float)
        bands = [((np.arange(n) // 15) % 2).astype(float) for n in (h, w)]
        share = (bands[0][:, None] + bands[1][None])[..., None] * 0.46
        return Image.fromarray((pixels * (1 - share) + dark * share).astype(np.uint8))
    if kind == "pane":
        for step, total in ((36, w), (36, h)):
            for k in range(12, total, step):
                for a in (k, k + 7):
                    line = (a, 0, a + 3, h) if total == w else (0, a, w, a + 3)
                    draw.rectangle(line, fill=ink)
    else:
        for x, width in ((14, 16), (36, 5), (47, 5), (58, 16)):
            for a in (x, w - x - width):
                draw.rectangle((a, 0, a + width, h), fill=ink)
        draw.rectangle((w // 2 - 3, 0, w // 2 + 3, h), fill=ink)
    return image.convert("RGB")


def folded(size: tuple[float, float], layers: int, face: Material, edge: Material) -> list[Mesh]:
    """A cloth folded to an oblong: soft slabs on each other, round at the front (+x)."""
    sx, sy = size
    thick, meshes = 0.0085, []
    for k in range(layers):
        t = np.linspace(-math.pi / 2, math.pi / 2, 5)
        nose = [(sx / 2 + thick / 2 * math.cos(a), thick / 2 * (1 + math.sin(a))) for a in t]
        outline = [(-sx / 2 - 0.004 * (k % 2), 0.0), *nose, (-sx / 2 - 0.004 * (k % 2), thick)]
        across = np.array([-1.0, 1.0]) * (sy / 2 - 0.003 * (k % 2))
        rings = [[(x, y, z) for x, z in outline] for y in across]
        mesh = loft(rings, mats=[edge, face])
        for i, f in enumerate(mesh.f):
            points = mesh.v[list(f)]
            if (len(f) == 4 and points[:, 2].min() > 0.8 * thick) or points[:, 0].min() > sx / 2:
                mesh.mi[i] = 1
            mesh.label_uv[i] = [
                (0.5 + y / CLOTH[1], 0.5 - (x + 0.9 * (z - thick)) / CLOTH[0]) for x, y, z in points
            ]
        meshes.append(mesh.weigh(2.0 if k == layers - 1 else 0.7).move(z=k * (thick - 0.0006)))
    return meshes


def tea_towel(form: str, kind: str, ground: str, ink: str, seed: int) -> Model:
    """A cloth: "folded", laid "flat" or "crumpled"."""
    rng = np.random.default_rng(seed)
    face, edge = label(weave(kind, ground, ink)), plain(shade(ground, 0.86), 0.08, 200)
    supports = []
    if form == "folded":
        meshes = folded((0.17, 0.24), 3, face, edge)
        low = np.min([m.v.min(0) for m in meshes], axis=0)
        high = np.max([m.v.max(0) for m in meshes], axis=0)
        whole = box(*(high - low)).move(*((low + high) / 2 * [1, 1, 0]))
        piece, support = block(whole, 0.03)
        pieces, supports = [piece], [support]
    else:
        heap, size = form == "crumpled", (0.34, 0.5) if form == "crumpled" else CLOTH
        field = mound((0.1, 0.13), 0.05, rng) if heap else lambda p: np.zeros(len(p))
        fold = folds(rng, 0.045 if heap else 0.006, 0.75 if heap else 1.6)
        lifts = (lambda p: fold(p) * np.clip(1.3 - (p**2).sum(1) / 0.02, 0.2, 1)) if heap else fold
        squeeze = (0.72, 0.72) if heap else (0.97, 0.97)
        mesh, _ = drape(
            rectangle_outline(*size), 0.034 if heap else 0.05, field, lifts, (0, 0),
            0.5 if heap else 0.0, squeeze, (face, edge), 0.008 if heap else 0.006,
        )  # fmt: skip
        # the pattern runs along the cloth's length, which is y
        mesh.label_uv = [[(v, 1 - u) for u, v in corner] for corner in mesh.label_uv]
        mesh.move(z=-float(mesh.v[:, 2].min()))
        low, high = mesh.v.min(0), mesh.v.max(0)
        flat = box_piece((low + high) / 2 * [1, 1, 0.9], (high - low) * [1, 1, 0.9])
        meshes, pieces = [mesh], [few_corners(mesh.v, 30)] if heap else [flat]
    return Model(
        f"tea towel, {form}",
        {"body": Part(meshes, collision=pieces, open=form != "folded")},
        mass=0.08,
        friction=0.9,
        supports=supports,
        texture_size=128,
        occlusion_strength=1.2,
        prune=False,
    )


def quilted(colour: str, stitch: str, kind: str) -> Material:
    """Padded cloth sewn in diamonds, or gingham."""
    m = Material()
    x, y = m.axis(0), m.axis(1)
    if kind == "gingham":
        bands = [
            m.remap(m.math("SINE", m.math("MULTIPLY", a, 190)), -0.1, 0.1, 0, 0.5) for a in (x, y)
        ]
        return m.colour(m.mix(m.math("ADD", *bands), colour, stitch))
    lines = [
        m.math("ABSOLUTE", m.math("SINE", m.math("MULTIPLY", m.math(op, x, y), 75)))
        for op in ("ADD", "SUBTRACT")
    ]
    seam = m.remap(m.math("MINIMUM", *lines), 0.1, 0.28, 1, 0)
    return m.colour(m.mix(seam, m.mottle(colour, 0.06, 120), stitch))


def mitt(cloth: Material, trim: str, right: bool) -> list[Mesh]:
    """A padded glove lying flat, its round tip towards +x, the thumb to one side."""
    edge, hole = plain(trim, 0.08, 120), plain(shade(trim, 0.4), 0.1)
    h = 0.024  # half its thickness
    stations = [
        (-0.165, 0.084, 1.0),
        (-0.14, 0.083, 0.95),
        (-0.12, 0.08, 0.85),
        (-0.06, 0.074, 0.88),
    ]
    stations += [(0.0, 0.077, 0.92), (0.06, 0.078, 0.88), (0.105, 0.066, 0.74), (0.13, 0.044, 0.5)]
    stations += [(0.14, 0.02, 0.25)]
    rings = []
    for x, half, t in stations:
        ring = superellipse(t * h, half, 2.4, 12)
        rings.append([(x, y, z + h) for z, y, _ in ring])
    mouth = [(x, 0.9 * y, h + 0.7 * (z - h)) for x, y, z in rings[0]]
    deep = [(x + 0.04, y, z) for x, y, z in mouth]
    palm = loft(
        [deep, mouth, *rings],
        mats=[cloth, hole, edge],
        mat_of_face=lambda k, i: 1 if k == 0 else 2 if k in (1, 2, 3) else 0,
    )
    thumb = [(-0.06, 0.05, h), (-0.02, 0.088, h), (0.025, 0.115, 0.9 * h), (0.052, 0.122, 0.86 * h)]
    thumb += [(0.068, 0.123, 0.84 * h)]
    finger = tube(thumb, [0.034, 0.033, 0.028, 0.02, 0.008], 8, mat=cloth, flatten=0.66)
    loop = [
        (-0.155, 0.078, h),
        (-0.18, 0.098, h),
        (-0.195, 0.09, h),
        (-0.19, 0.074, h),
        (-0.16, 0.07, h),
    ]
    out = [palm, finger, tube(loop, 0.004, 4, mat=edge, weight=0.5)]
    low = min(float(m.v[:, 2].min()) for m in out)
    for mesh in out:
        mesh.move(z=-low)
        if right:
            mesh.scale(1, -1, 1)
    return out


def oven_mitt(form: str, kind: str, colour: str, stitch: str, trim: str) -> Model:
    """One mitt, or a "pair" of which one lies on the other."""
    cloth = quilted(colour, stitch, kind)
    groups = [mitt(cloth, trim, False)]
    if form == "pair":
        groups.append(mitt(cloth, trim, True))
        for mesh in groups[0]:
            mesh.keep_pattern().turn(rz=0.3)
        for mesh in groups[1]:
            mesh.keep_pattern().turn(rz=-0.35).move(0.0, 0.02, 0.045)
    pieces = [few_corners(np.concatenate([m.v for m in g[:2]]), 30) for g in groups]
    return Model(
        "oven mitt" if form == "single" else "pair of oven mitts",
        {"body": Part([m for g in groups for m in g], collision=pieces)},
        mass=0.13 * len(groups),
        friction=0.9,
        texture_size=128,
        front="-y",
        prune=False,
    )


def nothing_random(rng: np.random.Generator) -> dict:
    return {}


MODELS = {
    "tea_towel": Maker(
        tea_towel,
        nothing_random,
        4,
        [
            {"form": "folded", "kind": "check", "ground": "#f6f2e8", "ink": "#c0283a", "seed": 1},
            {"form": "flat", "kind": "stripes", "ground": "#f2eee2", "ink": "#2f5f9a", "seed": 2},
            {"form": "crumpled", "kind": "check", "ground": "#f4f4ee", "ink": "#2f7a4a", "seed": 3},
            {"form": "folded", "kind": "pane", "ground": "#eee6d4", "ink": "#2a4a78", "seed": 1},
        ],
    ),
    "oven_mitt": Maker(
        oven_mitt,
        nothing_random,
        3,
        [
            {"form": "single", "kind": "quilt", "colour": "#c02a32", "stitch": "#7a141c"}
            | {"trim": "#f0ead8"},
            {"form": "single", "kind": "gingham", "colour": "#f2f0e6", "stitch": "#2f6a9a"}
            | {"trim": "#2f6a9a"},
            {"form": "pair", "kind": "quilt", "colour": "#7f8a8a", "stitch": "#4a5454"}
            | {"trim": "#e8b83a"},
        ],
    ),
}
