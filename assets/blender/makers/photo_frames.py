"""Framed photos that stand on furniture; their glass may be cracked."""

from __future__ import annotations

import math

import numpy as np
from labels import devices, photos
from toolkit.materials import Material, plain, shade, wood
from toolkit.materials import label as printed
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part
from toolkit.sampling import pick
from toolkit.shapes import box, extrude, lathe

from makers.projection import project_label
from makers.solids import solids

LEAN = -0.22


def _shards(where: list[tuple[float, float, float]]) -> list[Mesh]:
    """Splinters of glass that fell out, lying in front: (x, y, size)."""
    glass = Material()
    glint = glass.remap(glass.noise(60, 1), 0.45, 0.55)
    glass.colour(glass.mix(glint, "#9cc4d4", "#eef8fb"))
    out = []
    for k, (x, y, size) in enumerate(where):
        outline = (
            [(-0.5, -0.4), (0.55, -0.25), (0.2, 0.6)]
            if k % 2
            else [(-0.6, -0.2), (0.1, -0.5), (0.6, 0.1), (-0.1, 0.35)]
        )
        shard = extrude([(a * size, b * size) for a, b in outline], 0.005, glass)
        out.append(shard.turn(rz=1.1 * k).move(x, y, 0))
    return out


def _opening(kind: str, w: float, h: float, mat: Material, x: float, z: float, y=0.0) -> Mesh:
    """The picture behind its glass, facing +X."""
    back = plain("#f7f4ea", 0.0)
    if kind == "oval":
        disc = lathe([(0, -0.003), (0.5, -0.003), (0.5, 0.003), (0, 0.003)], 20, mat=back)
        disc.turn(ry=math.pi / 2).scale(1, w, h).move(x, y, z + h / 2)
        return project_label(disc, mat, "+x", (y, z + h / 2), (w, h), 0.9).weigh(1.6)
    return box(0.006, w, h, (x, y, z), back, labels={"+x": mat}, weight=1.6)


def photo_frame(
    kind: str, width: float, height: float, border: float, frame: str, wooden: bool, picture: str
) -> Model:
    """A framed photo leaning back on its stand: 'plain', 'oval', 'double' (two that fold) or
    'heart' (a thick block with a heart). Variant `broken`: cracked glass, splinters before it."""
    mat = wood(frame, shade(frame, 0.6), 1, 14) if wooden else plain(frame, 0.04)
    dark, depth = plain("#2c2a28", 0.05), 0.016
    other = {"family": "dog", "dog": "lake", "lake": "family"}[picture]
    fixed: list[Mesh] = []
    whole: list[Mesh] = []
    cracked: list[Mesh] = []

    def picture_at(shape: str, w: float, h: float, x: float, z: float, name: str) -> None:
        image = photos.photo(name)
        broken = devices.cracked(image, 4, (0.55, 0.4), "#ffffff", 5)
        draw = devices.ImageDraw.Draw(broken)
        hole = [(118, 70), (178, 62), (206, 112), (150, 148), (120, 120)]
        draw.polygon(hole, fill="#2a2724", outline="#ffffff")
        for to, look in ((whole, image), (cracked, broken)):
            to.append(_opening(shape, w, h, printed(look), x, z))

    def frame_of(width: float) -> list[Mesh]:
        w = width / 2
        sides = (
            (width, border, 0, 0),
            (width, border, 0, height - border),
            (border, height - 2 * border, -w + border / 2, border),
            (border, height - 2 * border, w - border / 2, border),
        )
        return [box(depth, sx, sz, (0, y, z), mat, 0.003) for sx, sz, y, z in sides]

    inner_w, inner_h = width - 2 * border, height - 2 * border
    if kind == "double":
        for q in (-1, 1):
            first = len(whole)
            half = frame_of(width)
            half.append(
                box(0.006, inner_w + 0.004, inner_h + 0.004, (-0.004, 0, border - 0.002), dark)
            )
            picture_at("plain", inner_w, inner_h, -0.001, border, picture if q < 0 else other)
            for mesh in (*half, whole[first], cracked[first]):
                mesh.move(y=q * width / 2).turn(rz=q * 0.5)
            fixed += half
        pieces = solids(fixed[:5], fixed[5:])
    elif kind == "heart":
        block = box(0.03, width, height, (0, 0, 0), mat, 0.004)
        fixed = [block]
        picture_at("plain", width * 0.52, height * 0.6, 0.0135, height * 0.2, picture)
        red = plain("#d8202c", 0.03)
        t = np.linspace(0, math.tau, 14, endpoint=False)
        line = np.c_[
            16 * np.sin(t) ** 3,
            13 * np.cos(t) - 5 * np.cos(2 * t) - 2 * np.cos(3 * t) - np.cos(4 * t),
        ]
        for q, size in ((-1, 0.0014), (1, 0.0011)):
            heart = extrude(line * size, 0.008, mat=red, axis="x")
            fixed.append(heart.move(0.017, q * width * 0.38, height * (0.28 if q < 0 else 0.75)))
        pieces = solids([block])
    else:
        if kind == "oval":
            ring = [(0.5, -0.008), (0.5, 0.004), (0.46, 0.011), (0.41, 0.006), (0.39, -0.002)]
            oval = lathe([(0, -0.008), *ring, (0, -0.002)], 24, mat=mat)
            oval.turn(ry=math.pi / 2).scale(1, width, height).move(0, 0, height / 2)
            fixed = [oval]
            size = (0.8 * width, 0.8 * height)
            picture_at("oval", *size, -0.002, 0.1 * height, picture)
            inner_w = size[0]
        else:
            fixed = frame_of(width)
            fixed.append(
                box(
                    0.006,
                    inner_w + 0.004,
                    inner_h + 0.004,
                    (-0.005, 0, border - 0.002),
                    plain("#f7f4ea", 0),
                )
            )
            picture_at("plain", inner_w - 0.012, inner_h - 0.012, -0.0035, border + 0.006, picture)
            fixed.append(
                box(0.005, width - border, height - border, (-0.0085, 0, border / 2), dark)
            )
        for mesh in (*fixed, *whole, *cracked):
            mesh.turn(ry=LEAN)
        h = height * 0.62
        hinge, foot = (math.sin(LEAN) * h - 0.01, math.cos(LEAN) * h), -height * 0.52
        prop = [
            (hinge[0], hinge[1]),
            (foot, 0.002),
            (foot - 0.006, 0.003),
            (hinge[0] - 0.004, hinge[1] + 0.004),
        ]
        low = min(float(m.v[:, 2].min()) for m in fixed)
        for mesh in (*fixed, *whole, *cracked):
            mesh.move(z=-low)
        stand = extrude(prop, width * 0.28, mat=dark, axis="y")
        stand.move(z=-float(stand.v[:, 2].min()))
        pieces = solids(fixed, [stand])
        fixed.append(stand)
    spots = [(0.035, -0.2 * width, 0.026), (0.05, 0.1 * width, 0.02), (0.03, 0.3 * width, 0.016)]
    front = max(float(m.v[:, 0].max()) for m in fixed)
    splinters = _shards([(front + x, y, s) for x, y, s in spots])
    return Model(
        "photo in a frame",
        {
            "body": Part(fixed, collision=pieces),
            "picture": Part(whole, collision="none"),
            "cracked": Part([*cracked, *splinters], collision="none"),
        },
        mass=0.35,
        variants={"default": ["body", "picture"], "broken": ["body", "cracked"]},
        states=[{"state": "BROKEN", "variants": ["broken"], "parts": ["cracked"]}],
    )


def photo_frame_random(rng: np.random.Generator) -> dict:
    return {
        "kind": "plain",
        "width": 0.16,
        "height": 0.2,
        "border": 0.018,
        "frame": pick(rng, ["#b98552", "#7a4a2a"]),
        "wooden": True,
        "picture": pick(rng, ["lake", "family", "dog"]),
    }


MODELS = {
    "photo_frame": Maker(
        photo_frame,
        photo_frame_random,
        7,
        [
            {"picture": "family"},
            {"picture": "lake", "wooden": False, "frame": "#f2f0ea", "width": 0.23, "height": 0.17},
            {"picture": "dog", "wooden": False, "frame": "#26282c"},
            {
                "kind": "oval",
                "picture": "family",
                "wooden": False,
                "frame": "#d8a838",
                "height": 0.22,
                "width": 0.17,
            },
            {
                "kind": "double",
                "picture": "dog",
                "wooden": False,
                "frame": "#b4b9be",
                "width": 0.13,
                "height": 0.17,
                "border": 0.013,
            },
            {
                "kind": "heart",
                "picture": "dog",
                "wooden": False,
                "frame": "#f4f0e6",
                "width": 0.25,
                "height": 0.15,
            },
            {
                "kind": "double",
                "picture": "family",
                "frame": "#8a5a34",
                "width": 0.13,
                "height": 0.17,
                "border": 0.013,
            },
        ],
    ),
}
