"""Storage bins: clear boxes, cloth cubes, crates, rope baskets, open-fronted stackers."""

from __future__ import annotations

import math

import numpy as np
from toolkit.labels import canvas
from toolkit.materials import Material, plain, shade
from toolkit.materials import label as printed
from toolkit.mesh import Mesh
from toolkit.model import (
    Container,
    Maker,
    Model,
    Part,
    Support,
    box_piece,
    cylinder_piece,
    rectangle,
    ring_pieces,
    round_polygon,
)
from toolkit.sampling import noise_offset, seed_of
from toolkit.shapes import box, extrude, lathe, loft, rounded_rectangle, tube

from makers.joinery import fabric
from makers.projection import project_label
from makers.soft_forms import bent


def _walls(sx: float, sy: float, h: float, wall: float) -> list[np.ndarray]:
    pieces = [box_piece((0, 0, wall / 2), (sx, sy, wall))]
    for q in (-1, 1):
        pieces.append(box_piece((q * (sx - wall) / 2, 0, h / 2), (wall, sy, h)))
        pieces.append(box_piece((0, q * (sy - wall) / 2, h / 2), (sx, wall, h)))
    return pieces


def _tray(
    sx: float, sy: float, h: float, wall: float, taper: float, r: float, mats: list[Material]
) -> Mesh:
    """An open box; the foot is smaller by `taper`; mats: outside, inside."""
    rings = []
    for z, f, inset in (
        (0, taper, 0.01),
        (0.012, taper, 0),
        (h, 1, 0),
        (h, 1, wall),
        (wall, taper, wall),
    ):
        o = rounded_rectangle(sx * f - 2 * inset, sy * f - 2 * inset, r, 3)
        rings.append(np.c_[o, np.full(len(o), z)])
    return loft(rings, mats=mats, mat_of_face=lambda k, i: int(k >= 3))


def _model(title: str, meshes: list[Mesh], sx: float, sy: float, h: float, wall: float, **more):
    return Model(
        title,
        {"body": Part(meshes, collision=_walls(sx, sy, h, wall))},
        mass=more.pop("mass", 0.9),
        containers=[Container("inside", (0, 0, h / 2), (sx * 0.84, sy * 0.84, h - 2 * wall))],
        supports=[Support("floor", wall, rectangle(sx * 0.76, sy * 0.76), container="inside")],
        **more,
    )


def clear_box(sx: float, sy: float, h: float, lid_colour: str, wheels: bool, seed: int) -> Model:
    """A see-through box with a lid, clips, and things showing through its walls."""
    rng = np.random.default_rng(seed)
    picture, draw = canvas(320, 192, "#cfdde0")
    tones = ["#d8867a", "#7fa8c8", "#e0cf8a", "#8fb890", "#b8a0c8", "#e8e4da"]
    x = 12
    while x < 300:
        w, tall = int(rng.integers(26, 62)), int(rng.integers(80, 150))
        tone = tones[int(rng.integers(len(tones)))]
        draw.rounded_rectangle((x, 188 - tall, x + w, 188), 9, fill=tone)
        draw.line((x + 4, 188 - tall / 2, x + w - 4, 188 - tall / 2), fill="#ffffff", width=4)
        x += w + 3
    for x0 in (40, 200):
        draw.polygon([(x0, 0), (x0 + 26, 0), (x0 - 40, 192), (x0 - 66, 192)], fill="#eef6f7")
    draw.rectangle((0, 0, 319, 191), outline="#f4fafa", width=8)
    glass, show = plain("#d5e2e5", 0.02, 20), printed(picture)
    lid, clip = plain(lid_colour, 0.03, 20), plain(shade(lid_colour, 0.75), 0.03)
    z0 = 0.03 if wheels else 0.0
    rings = []
    for z, f in ((z0, 0.88), (z0 + 0.01, 0.9), (h - 0.03, 1.0)):
        o = rounded_rectangle(sx * f, sy * f, 0.03, 3)
        rings.append(np.c_[o, np.full(len(o), z)])
    body = loft(rings, glass)
    for side, w in (("+x", sy), ("-x", sy), ("+y", sx), ("-y", sx)):
        project_label(body, show, side, (0, (h + z0) / 2), (w * 0.92, h - z0 - 0.05), 0.9)
    meshes = [body]
    rings = []
    for z, f in ((h - 0.034, 0.03), (h - 0.008, 0.036), (h, 0.02), (h, -0.03), (h - 0.008, -0.04)):
        o = rounded_rectangle(sx + f, sy + f, 0.035, 3)
        rings.append(np.c_[o, np.full(len(o), z)])
    meshes.append(loft(rings, lid))
    for q in (-1, 1):
        meshes.append(box(sx * 0.32, 0.012, 0.07, (0, q * (sy / 2 + 0.016), h - 0.07), clip, 0.003))
        if wheels:
            for x in (-1, 1):
                wheel = lathe(
                    [(0, -0.01), (0.03, -0.01), (0.03, 0.01), (0, 0.01)],
                    9,
                    mat=plain("#2a2b2e", 0.05),
                )
                wheel.turn(rx=math.pi / 2).move(x * sx * 0.34, q * sy * 0.4, 0.03)
                meshes.append(wheel)
    top = Support("top", h - 0.008, rectangle(sx - 0.06, sy - 0.06))
    part = Part(meshes, collision=[box_piece((0, 0, h / 2), (sx, sy, h))])
    return Model("clear storage box with a lid", {"body": part}, mass=2.0, supports=[top])


def cloth_cube(size: float, h: float, colour: str, print_colour: str, seed: int) -> Model:
    """A cloth-covered cube with a pull ring on its front, open on top."""
    rng = np.random.default_rng(seed)
    picture, draw = canvas(192, 192, colour)
    if print_colour:
        for i in range(6):
            for j in range(6):
                x, y = 16 + 32 * i + 16 * (j % 2), 16 + 32 * j
                draw.ellipse((x - 7, y - 7, x + 7, y + 7), fill=print_colour)
    cloth, inner = (
        fabric(colour, noise_offset(rng), 0.1),
        fabric(shade(colour, 0.75), (0, 0, 0), 0.08),
    )
    shell = _tray(size, size, h, 0.012, 0.98, 0.02, [cloth, inner])
    if print_colour:
        for side in ("+x", "-x", "+y", "-y"):
            face = printed(picture)
            project_label(
                shell,
                face,
                side,
                (0, h / 2),
                (size, h),
                0.9,
                lambda c: np.hypot(c[0], c[1]) > size * 0.47,
            )
    edge = rounded_rectangle(size, size, 0.02, 3)
    binding = plain(shade(colour, 0.6), 0.05)
    meshes = [shell, tube(np.c_[edge, np.full(12, h - 0.003)], 0.008, 4, closed=True, mat=binding)]
    steel = plain("#b9bdc2", 0.08)
    eye = lathe([(0.02, 0), (0.034, 0), (0.034, 0.006), (0.02, 0.006), (0.02, 0)], 14, mat=steel)
    hole = lathe([(0, 0), (0.021, 0), (0.021, 0.002), (0, 0.002)], 12, mat=plain("#2a2724", 0))
    for m in (eye.outward(), hole):
        meshes.append(m.turn(ry=math.pi / 2).move(size / 2 - 0.001, 0, h * 0.6))
    return _model("cloth storage cube", meshes, size, size, h, 0.012)


def crate(sx: float, sy: float, h: float, colour: str, seed: int) -> Model:
    """A folding plastic crate: lattice walls, grip holes in the ends."""
    picture, draw = canvas(256, 192, colour)
    dark = "#" + "".join(f"{int(255 * c):02x}" for c in shade(colour, 0.3))
    for i in range(7):
        for j in range(4):
            x, y = 14 + 33 * i, 16 + 42 * j
            if not (j == 0 and 2 <= i <= 4):
                draw.rounded_rectangle((x, y, x + 25, y + 32), 5, fill=dark)
    draw.rounded_rectangle((84, 18, 172, 46), 12, fill=dark)
    face, frame = printed(picture), plain(colour, 0.04, 30)
    shell = _tray(sx, sy, h, 0.012, 0.99, 0.012, [frame, frame])
    for side, w in (("+x", sy), ("-x", sy), ("+y", sx), ("-y", sx)):
        project_label(shell, face, side, (0, h / 2), (w * 0.95, h * 0.92), 0.8)
    meshes = [shell]
    for x in (-1, 1):
        for y in (-1, 1):
            at = (x * (sx / 2 - 0.012), y * (sy / 2 - 0.012), 0)
            meshes.append(box(0.035, 0.035, h + 0.008, at, frame, 0.004))
    edge = rounded_rectangle(sx + 0.004, sy + 0.004, 0.012, 3)
    meshes.append(tube(np.c_[edge, np.full(12, h - 0.004)], 0.009, 4, closed=True, mat=frame))
    return _model("plastic storage crate", meshes, sx, sy, h, 0.012)


def rope_basket(radius: float, h: float, colour: str, second: str, seed: int) -> Model:
    """A round basket of coiled cotton rope with two loops for handles."""
    rng = np.random.default_rng(seed)
    rope = Material()
    coil = rope.remap(
        rope.math("SINE", rope.math("MULTIPLY", rope.axis(2), 420.0)), -0.8, 0.4, 0.55, 0
    )
    angle = rope.math("ARCTAN2", rope.axis(1), rope.axis(0))
    stitch = rope.remap(rope.math("SINE", rope.math("MULTIPLY", angle, 60)), 0.3, 0.9, 0, 0.25)
    base = rope.mix(
        rope.remap(rope.axis(2), h * 0.5, h * 0.505),
        second,
        rope.mottle(colour, 0.08, 60, noise_offset(rng)),
    )
    rope.colour(rope.mix(rope.math("ADD", coil, stitch, clamp=True), base, shade(colour, 0.4)))
    profile = [(0, 0), (radius * 0.86, 0), (radius * 0.98, 0.03), (radius * 1.04, h * 0.45)]
    profile += [
        (radius * 0.98, h - 0.012),
        (radius * 0.97, h),
        (radius * 0.92, h),
        (radius * 0.98, h * 0.45),
    ]
    profile += [(radius * 0.86, 0.014), (0, 0.014)]
    meshes = [lathe(profile, 20, mat=rope)]
    cord = plain(shade(colour, 0.9), 0.12, 90)
    for q in (-1, 1):
        y = q * radius * 0.97
        loop = [(-0.06, y, h - 0.05), (-0.05, y * 1.03, h + 0.02), (0.0, y * 1.04, h + 0.045)]
        loop += [(0.05, y * 1.03, h + 0.02), (0.06, y, h - 0.05)]
        meshes.append(bent(loop, 0.012, cord, 6, 2))
    outer, inner = [(radius * 0.9, 0), (radius, h)], [(radius * 0.82, 0.014), (radius * 0.92, h)]
    return Model(
        "rope storage basket",
        {
            "body": Part(
                meshes,
                collision=[cylinder_piece(radius * 0.88, 0, 0.014), *ring_pieces(outer, inner, 10)],
            )
        },
        mass=0.7,
        containers=[Container("inside", (0, 0, h / 2), (radius * 1.2, radius * 1.2, h - 0.03))],
        supports=[Support("floor", 0.014, round_polygon(radius * 0.75), container="inside")],
    )


def stacker(sx: float, sy: float, h: float, colour: str, tiers: int, seed: int) -> Model:
    """Open-fronted bins on one another, as for toys or vegetables."""
    meshes, pieces, t = [], [], 0.01
    tones = [colour, shade(colour, 1.0), colour]
    for k in range(tiers):
        mat = plain(tones[k % 3], 0.03, 20)
        inside = plain(shade(colour, 0.72), 0.04, 20)
        z = k * h
        x0, x1 = -sx / 2, sx / 2
        profile = [
            (x0, z),
            (x1 - 0.03, z),
            (x1, z + h * 0.42),
            (x1 - 0.04, z + h * 0.5),
            (x0 + 0.06, z + h - 0.012),
            (x0, z + h - 0.012),
        ]
        for q in (-1, 1):
            meshes.append(extrude(profile, t, mat=mat, axis="y").move(y=q * (sy - t) / 2))
        meshes.append(box(sx - 0.03, sy - 2 * t, t, (-0.015, 0, z), mat, labels={"+z": inside}))
        meshes.append(box(t, sy - 2 * t, h - 0.012, (x0 + t / 2, 0, z), mat, labels={"+x": inside}))
        lip = box(t, sy - 2 * t, h * 0.44, (0, 0, 0), mat, labels={"-x": inside})
        meshes.append(lip.turn(ry=0.17).move(x1 - 0.034, 0, z))
        pieces += [
            box_piece((0, 0, z + t / 2), (sx, sy, t)),
            box_piece((x0 + t / 2, 0, z + h / 2), (t, sy, h)),
        ]
        pieces += [box_piece((0, q * (sy - t) / 2, z + h * 0.4), (sx, t, h * 0.8)) for q in (-1, 1)]
        pieces.append(box_piece((x1 - 0.012, 0, z + h * 0.21), (0.03, sy, h * 0.42)))
    space = Container("inside", (-0.02, 0, (tiers - 0.5) * h), (sx * 0.75, sy - 0.04, h * 0.8))
    floor = Support(
        "floor", (tiers - 1) * h + t, rectangle(sx * 0.7, sy - 0.06, -0.02), container="inside"
    )
    title = "stacked storage bins" if tiers > 1 else "open-fronted storage bin"
    return Model(
        title,
        {"body": Part(meshes, collision=pieces)},
        mass=0.8 * tiers,
        containers=[space],
        supports=[floor],
        texture_size=128,
    )


def storage_bin(kind: str, **parameters) -> Model:
    """A storage bin: "clear", "cube", "crate", "rope" or "stacker"."""
    make = {
        "clear": clear_box,
        "cube": cloth_cube,
        "crate": crate,
        "rope": rope_basket,
        "stacker": stacker,
    }
    return make[kind](**parameters)


def storage_bin_random(rng: np.random.Generator) -> dict:
    return {"kind": "cube", "seed": seed_of(rng)}


_CLEAR = {"kind": "clear", "sx": 0.36, "sy": 0.5, "h": 0.27, "wheels": False, "seed": 3}
_CUBE = {"size": 0.3, "h": 0.3, "seed": 4}

MODELS = {
    "storage_bin": Maker(
        storage_bin,
        storage_bin_random,
        8,
        [
            {**_CLEAR, "lid_colour": "#2f6fb0"},
            {**_CUBE, "colour": "#8a8f94", "print_colour": ""},
            {"kind": "crate", "sx": 0.36, "sy": 0.48, "h": 0.24, "colour": "#3f9a5a"},
            {"kind": "rope", "radius": 0.19, "h": 0.3, "colour": "#e8dfca", "second": "#5a6f7a"},
            {"kind": "stacker", "sx": 0.34, "sy": 0.4, "h": 0.2, "colour": "#e0a83a", "tiers": 2},
            {
                "kind": "clear",
                "sx": 0.4,
                "sy": 0.56,
                "h": 0.42,
                "wheels": True,
                "lid_colour": "#c8483a",
            },
            {**_CUBE, "colour": "#d8707a", "print_colour": "#f6ece4"},
            {**_CLEAR, "lid_colour": "#7a7f86"},
        ],
    ),
}
