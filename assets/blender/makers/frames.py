"""Pictures and mirrors that hang on a wall (back at -X); each may be broken."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
from labels import photos
from toolkit.materials import Material, label, plain
from toolkit.mesh import Mesh, cube_project
from toolkit.model import Maker, Model, Part
from toolkit.sampling import noise_offset, pick, seed_of
from toolkit.shapes import box, extrude, loft, rounded_rectangle, tube

from .convex import few_corners
from .joinery import finish
from .pictures import painting
from .projection import project_label
from .soft_forms import pane_shards

Offset = tuple[float, float, float]
Outline = Callable[[float], np.ndarray]  # the (y, z) outline, shrunk by an inset

BROKEN = [{"state": "BROKEN", "variants": ["broken"], "parts": ["shards"]}]


def outline_of(form: str, width: float, height: float) -> Outline:
    """An outline centred on 0: "rectangle", "oval" or "arch"."""

    def rectangle(d: float) -> np.ndarray:
        return rounded_rectangle(width - 2 * d, height - 2 * d, 0.004, 2)

    def oval(d: float) -> np.ndarray:
        t = np.arange(28) * math.tau / 28
        return np.c_[(width / 2 - d) * np.cos(t), (height / 2 - d) * np.sin(t)]

    def arch(d: float) -> np.ndarray:
        r = width / 2
        t = np.linspace(0, math.pi, 15)
        bow = np.c_[(r - d) * np.cos(t), height / 2 - r + (r - d) * np.sin(t)]
        return np.r_[bow, [(-r + d, -height / 2 + d), (r - d, -height / 2 + d)]]

    return {"rectangle": rectangle, "oval": oval, "arch": arch}[form]


def moulding(outline: Outline, wide: float, deep: float, mat: Material) -> Mesh:
    """The frame itself: a ring with a bevelled front, closed towards the pane."""
    section = [(0.0, 0.0), (0.0, deep * 0.7), (wide * 0.25, deep), (wide * 0.75, deep)]
    section += [(wide, deep * 0.75), (wide, 0.0)]
    rings = []
    for inset, x in section:
        p = outline(inset)
        rings.append(np.c_[np.full(len(p), x), p])
    mesh = loft([*rings, rings[0]], mat, caps=(False, False)).outward()
    return cube_project(mesh) if len(rings[0]) < 12 else mesh


def pane(outline: np.ndarray, x0: float, x1: float, mat: Material, weight: float = 1.0) -> Mesh:
    mesh = extrude(outline, x1 - x0, mat, axis="x").move((x0 + x1) / 2)
    return mesh.weigh(weight)


def breakable(
    body: list[Mesh],
    whole: list[Mesh],
    outline: np.ndarray,
    x: float,
    glass: Callable[[Mesh], Mesh],
    blank: Material,
    back: Material,
    seed: int,
) -> tuple[dict[str, Part], dict[str, list[str]]]:
    """Parts and variants: `pane` whole, or `shards` over a dark back; glass(mesh) dresses one."""
    rng = np.random.default_rng(seed)
    size = np.ptp(outline, axis=0)
    centre = (0.14 * size[0], 0.12 * size[1])
    pieces = [glass(m) for m in pane_shards(outline, x, blank, rng, centre)]
    pieces.append(pane(outline, x - 0.012, x - 0.005, back))
    points = np.concatenate([m.v for m in body])
    parts = {
        "body": Part(body, collision=[few_corners(points, 40)]),
        "pane": Part(whole, collision="none"),
        "shards": Part(pieces, collision="none"),
    }
    return parts, {"default": ["body", "pane"], "broken": ["body", "shards"]}


# ---- pictures
def art(kind: str, seed: int, width: float, height: float):
    """A picture of the right shape."""
    if kind in ("family", "dog", "lake"):
        return photos.photo(kind)
    if kind == "landscape":
        return photos.oil(seed, 256, int(256 * height / width))
    return painting(kind, seed, 256, int(256 * height / width))


def picture_frame(
    form: str,
    width: float,
    height: float,
    kind: str,
    frame: str,
    seed: int,
    offset: Offset,
    wide: float = 0.03,
    mount: float = 0.045,
) -> Model:
    """A framed picture; in the variant `broken` its glass is in pieces, one of them gone."""
    outline = outline_of(form, width, height)
    wood = finish(frame, 2, offset)
    paper = plain("#f2efe8", 0.01, 20)
    body = [moulding(outline, wide, 0.024, wood)]
    body.append(pane(outline(wide * 0.6), 0.0, 0.007, plain("#6a5a48", 0.05)))
    inner = outline(wide)
    seen = outline(wide + mount)
    size = np.ptp(seen, axis=0)
    picture = label(art(kind, seed, *size))
    body.append(pane(inner, 0.004, 0.009, paper))
    whole = [pane(seen, 0.006, 0.0145, picture, 3.0)]
    edge = plain("#eef4f4", 0.02)

    def dress(mesh: Mesh) -> Mesh:
        return project_label(mesh, picture, "+x", (0, 0), (size[0], size[1]), 0.7).weigh(1.6)

    parts, variants = breakable(
        body, whole, seen, 0.0145, dress, edge, plain("#2c2825", 0.03), seed % 1000
    )
    title = f"framed {'photograph' if kind in ('family', 'dog', 'lake') else 'painting'}, {kind}"
    return Model(title, parts, mass=1.8, variants=variants, states=BROKEN)


def gallery(
    width: float, height: float, kinds: list[str], frame: str, seed: int, offset: Offset
) -> Model:
    """Three small pictures side by side on one board."""
    wood = finish(frame, 1, offset)
    body = [box(0.012, width, height, (0.006, 0, -height / 2), plain("#efe9dc", 0.03))]
    whole, each = [], width / 3
    outline = outline_of("rectangle", each - 0.03, height - 0.06)
    for k, kind in enumerate(kinds):
        y = (k - 1) * each
        body.append(moulding(outline, 0.022, 0.026, wood).move(0.005, y))
        picture = label(art(kind, seed + k, each - 0.07, height - 0.1))
        seen = outline(0.022)
        if k == 1:
            middle, main = seen, picture
        target = whole if k == 1 else body
        target.append(pane(seen, 0.01, 0.019, picture, 2.0).move(0, y))
    size = np.ptp(middle, axis=0)

    def dress(mesh: Mesh) -> Mesh:
        return project_label(mesh, main, "+x", (0, 0), (size[0], size[1]), 0.7).weigh(1.6)

    parts, variants = breakable(
        body, whole, middle, 0.019, dress, plain("#eef4f4", 0.02), plain("#2c2825", 0.03), seed
    )
    return Model("three framed pictures", parts, mass=2.5, variants=variants, states=BROKEN)


def picture_any(form: str, **parameters) -> Model:
    if form == "gallery":
        return gallery(
            **{k: parameters[k] for k in ("width", "height", "kinds", "frame", "seed", "offset")}
        )
    return picture_frame(form=form, **parameters)


def picture_frame_random(rng: np.random.Generator) -> dict:
    return {
        "form": "rectangle",
        "width": 0.7,
        "height": 0.5,
        "kind": pick(rng, ["landscape", "abstract", "flower"]),
        "frame": pick(rng, ["oak", "walnut", "black"]),
        "seed": seed_of(rng),
        "offset": noise_offset(rng),
    }


# ---- mirrors
def mirror_glass(height: float) -> Material:
    """What it mirrors is hinted at by bright, slanting bands."""
    glass = Material(occlusion=0.3)
    slant = glass.math("ADD", glass.math("MULTIPLY", glass.axis(1), 0.9), glass.axis(2))
    span = glass.remap(slant, -height / 2, height / 2 + 0.2)
    stops = [
        (0, "#a9bcc6"),
        (0.3, "#c3d3da"),
        (0.33, "#e4eef2"),
        (0.46, "#eef6f8"),
        (0.48, "#c6d5dc"),
        (0.62, "#b4c7d0"),
        (0.64, "#d6e3e8"),
        (0.7, "#dfeaee"),
        (0.72, "#bccdd5"),
        (1, "#dfe9ed"),
    ]
    return glass.colour(glass.ramp(span, stops))


def mirror(form: str, width: float, height: float, frame: str, trim: str, offset: Offset) -> Model:
    """A wall mirror; trim: "", "shelf" below it, "strap" it hangs by, or "rays" around it."""
    outline = outline_of(form, width, height)
    wood = finish(frame, 2, offset)
    wide = 0.025 if form == "oval" else 0.035
    body = [moulding(outline, wide, 0.026, wood)]
    body.append(pane(outline(wide * 0.6), 0.0, 0.005, plain("#4a4038", 0.05)))
    if trim == "shelf":
        body.append(box(0.11, width, 0.02, (0.055, 0, -height / 2 - 0.02), wood, 0.004))
        for y in (-0.35, 0.35):
            body.append(
                box(0.05, 0.016, 0.04, (0.025, y * width, -height / 2 - 0.055), wood, 0.003)
            )
    elif trim == "strap":
        strap, knob = plain("#6a4026", 0.08, 30), finish("black", 2, offset)
        top = height / 2
        for q in (-1, 1):
            band = [(0.014, q * width * 0.36, top * 0.68), (0.014, q * 0.012, top + 0.17)]
            body.append(tube(np.array(band), 0.016, 4, mat=strap, flatten=0.35, up=(1, 0, 0)))
        body.append(box(0.06, 0.034, 0.034, (0.03, 0, top + 0.155), knob, 0.008))
    elif trim == "rays":
        for k in range(24):
            a = k * math.tau / 24
            long = 0.13 if k % 2 else 0.2
            c, s = math.cos(a), math.sin(a)
            r0, r1 = width / 2 - 0.012, width / 2 + long
            ray = [(0.01, r0 * c, r0 * s), (0.01, r1 * c, r1 * s)]
            body.append(tube(np.array(ray), [0.013, 0.005], 4, mat=wood))
    glass = mirror_glass(height)
    inner = outline(wide)
    whole = [pane(inner, 0.004, 0.016, glass, 1.4)]

    def dress(mesh: Mesh) -> Mesh:
        mesh.mats = [mirror_glass(height * float(0.8 + 0.5 * abs(mesh.v[:, 1].mean())))]
        return mesh.move(0.0)

    parts, variants = breakable(
        body, whole, inner, 0.016, dress, glass, plain("#1f1c1a", 0.03), int(width * 1000)
    )
    names = {"oval": "round mirror" if width == height else "oval mirror", "arch": "arched mirror"}
    title = names.get(form, "mirror") + {"shelf": " with a shelf", "rays": " with rays"}.get(
        trim, ""
    )
    return Model(title, parts, mass=6.0, variants=variants, states=BROKEN)


def mirror_random(rng: np.random.Generator) -> dict:
    """Parameters of a random mirror."""
    return {
        "form": "rectangle",
        "width": 0.6,
        "height": 0.8,
        "frame": pick(rng, ["oak", "walnut", "black"]),
        "trim": "",
        "offset": noise_offset(rng),
    }


_GOLD = "#b8923a"

MODELS = {
    "picture_frame": Maker(
        picture_any,
        picture_frame_random,
        8,
        [
            {"kind": "landscape", "frame": "oak", "seed": 1},
            {"kind": "abstract", "frame": "black", "seed": 1},
            {"kind": "flower", "frame": "#f0efec", "width": 0.46, "height": 0.62, "seed": 3},
            {"kind": "landscape", "frame": "walnut", "width": 0.9, "height": 0.42, "seed": 5},
            {
                "form": "oval",
                "kind": "family",
                "frame": _GOLD,
                "width": 0.4,
                "height": 0.5,
                "mount": 0.0,
                "seed": 6,
            },
            {
                "kind": "dog",
                "frame": "black",
                "width": 0.4,
                "height": 0.4,
                "mount": 0.07,
                "wide": 0.022,
                "seed": 7,
            },
            {
                "form": "gallery",
                "kinds": ["lake", "family", "dog"],
                "frame": "oak",
                "width": 0.9,
                "height": 0.4,
                "seed": 8,
            },
            {"kind": "landscape", "frame": _GOLD, "width": 0.46, "height": 0.62, "seed": 9},
        ],
    ),
    "mirror": Maker(
        mirror,
        mirror_random,
        7,
        [
            {"frame": "oak"},
            {"form": "oval", "frame": "black", "width": 0.62, "height": 0.62},
            {"form": "arch", "frame": _GOLD, "width": 0.55, "height": 0.9},
            {"frame": "walnut", "width": 0.5, "height": 0.6, "trim": "shelf"},
            {"form": "oval", "frame": _GOLD, "width": 0.45, "height": 0.45, "trim": "rays"},
            {"form": "oval", "frame": "black", "width": 0.5, "height": 0.5, "trim": "strap"},
            {"frame": "#f0efec"},
        ],
    ),
}
