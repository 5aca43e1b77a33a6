"""Electric fans; the variant `on` has blurred blades and a lit lamp."""

from __future__ import annotations

import math

import numpy as np
from toolkit.labels import canvas, text
from toolkit.materials import Material, glowing, metal, plain, shade
from toolkit.materials import label as printed
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part, box_piece, cylinder_piece
from toolkit.sampling import pick
from toolkit.shapes import box, ellipsoid, lathe, loft, rounded_rectangle, superellipse, tube

from makers.projection import project_label
from makers.soft_forms import bent, ring


def _blades(r: float, count: int, mat: Material) -> list[Mesh]:
    """Twisted blades about the x axis, facing +X."""
    meshes = [ellipsoid((0.03, r * 0.22, r * 0.22), (0, 0, 0), 8, 4, mat)]
    for k in range(count):
        rings = []
        for f, wide, twist in (
            (0.18, 0.2, 0.7),
            (0.55, 0.55, 0.5),
            (0.88, 0.6, 0.35),
            (0.97, 0.35, 0.3),
        ):
            c, s = math.cos(twist), math.sin(twist)
            half = wide * r * 0.55
            edge = np.array([(-half, -0.003), (half, -0.003), (half, 0.003), (-half, 0.003)])
            rings.append([(u * s + v * c, u * c - v * s + 0.1 * r, f * r) for u, v in edge])
        blade = loft(rings, mat)
        meshes.append(blade.turn(rx=k * math.tau / count))
    return meshes


def _blur(r: float, colour: str) -> list[Mesh]:
    """What the eye sees of turning blades: a disc of soft arcs."""
    picture, draw = canvas(256, 256, colour)
    for k in range(40):
        a, tone = 9 * k, 0.8 + 0.35 * (0.5 + 0.5 * math.sin(k * math.tau / 13))
        fill = "#" + "".join(f"{int(255 * c):02x}" for c in shade(colour, tone))
        draw.pieslice((0, 0, 255, 255), a, a + 9, fill=fill)
    for k in range(9):
        q = 18 + 13 * k
        fill = "#" + "".join(f"{int(255 * c):02x}" for c in shade(colour, 1.25 if k % 2 else 0.85))
        draw.arc((128 - q, 128 - q, 128 + q, 128 + q), 30 * k, 30 * k + 200, fill=fill, width=4)
    draw.ellipse((100, 100, 156, 156), fill="#d8dadc")
    mat = printed(picture)
    disc = lathe(
        [(0, -0.006), (r * 0.96, -0.006), (r * 0.96, 0.006), (0, 0.012)],
        14,
        mat=plain(colour, 0.02),
    )
    disc.turn(ry=math.pi / 2)
    return [
        project_label(disc, mat, "+x", (0, 0), (2 * r, 2 * r), 0.5),
        ellipsoid((0.03, r * 0.22, r * 0.22), (0, 0, 0), 8, 4, plain(shade(colour, 1.1), 0.02)),
    ]


def _cage(r: float, wire: Material, count: int) -> list[Mesh]:
    """A wire guard round the blades, domed in front and behind."""
    hoop = ring(16, r, r)[:, [2, 0, 1]]
    meshes = [tube(hoop, 0.012, 3, closed=True, mat=wire)]
    small = ring(10, r * 0.5, r * 0.5)[:, [2, 0, 1]] + [0.05, 0, 0]
    meshes.append(tube(small, 0.0035, 3, closed=True, mat=wire, weight=0.5))
    for k in range(count):
        a = k * math.tau / count
        c, s = math.cos(a), math.sin(a)
        for x in (0.055, -0.05):
            path = [
                (0, r * c, r * s),
                (x * 0.85, r * 0.6 * c, r * 0.6 * s),
                (x, r * 0.15 * c, r * 0.15 * s),
            ]
            if x > 0 or k % 2 == 0:
                meshes.append(tube(np.array(path), 0.0035, 3, mat=wire, weight=0.5))
    badge = lathe([(0, 0.05), (r * 0.17, 0.05), (r * 0.15, 0.062), (0, 0.064)], 12, mat=wire)
    return [*meshes, badge.turn(ry=math.pi / 2)]


def _fan(
    title: str, body: list[Mesh], off: list[Mesh], on: list[Mesh], lamp: tuple, pieces, mass: float
) -> Model:
    parts = {
        "body": Part(body, collision=pieces),
        "blades": Part([*off, ellipsoid(0.008, lamp, 5, 3, plain("#2a3a2e", 0))], collision="none"),
        "blades_turning": Part(on, collision="none"),
        "lamp_lit": Part(
            [ellipsoid(0.012, lamp, 5, 4, glowing("4aff5a"))],
            collision="none",
            rgba=(1.7, 1.7, 1.7, 1.0),
        ),
    }
    return Model(
        title,
        parts,
        mass=mass,
        variants={"default": ["body", "blades"], "on": ["body", "blades_turning", "lamp_lit"]},
        states=[
            {"state": "ON", "variants": ["on"], "parts": ["blades_turning", "lamp_lit"]},
            {"state": "OFF", "variants": ["default"], "parts": ["blades"]},
        ],
    )


def standing_fan(kind: str, colour: str, blade: str, r: float, height: float) -> Model:
    """A caged fan on a foot: "pedestal" (tall), "table" (short neck) or "drum" (in a bow)."""
    paint, leaf, wire = plain(colour, 0.03, 20), plain(blade, 0.03), metal("c8ccd0", "878d93")
    body: list[Mesh] = []
    z = height - r
    if kind == "drum":
        bow = [
            (0, math.sin(t) * (r + 0.035), z - math.cos(t) * (r + 0.035))
            for t in np.linspace(-1.6, 1.6, 9)
        ]
        body.append(tube(np.array(bow), 0.012, 5, mat=paint))
        for q in (-1, 1):
            foot = [(0.17, q * r * 0.62, 0.012), (-0.15, q * r * 0.62, 0.012)]
            body.append(tube(np.array(foot), 0.012, 6, mat=paint))
            body.append(
                tube([(0, q * r * 0.62, 0.012), (0, q * r * 0.66, 0.05)], 0.012, 5, mat=paint)
            )
        shell = lathe(
            [
                (r - 0.006, -0.07),
                (r + 0.012, -0.07),
                (r + 0.012, 0.07),
                (r - 0.006, 0.07),
                (r - 0.006, -0.07),
            ],
            16,
            mat=paint,
        )
        body.append(shell.outward().turn(ry=math.pi / 2).move(0, 0, z))
        lamp = (0.05, r + 0.03, z)
        pieces = [box_piece((0, 0, 0.012), (0.34, 1.3 * r, 0.024))]
    else:
        base = 0.19 if kind == "pedestal" else 0.11
        profile = [
            (0, 0),
            (base, 0),
            (base, 0.012),
            (base * 0.8, 0.028),
            (0.03, 0.045),
            (0.02, 0.06),
            (0, 0.06),
        ]
        body.append(lathe(profile, 12, mat=paint))
        body.append(
            tube(
                [(-0.05, 0, 0.04), (-0.05, 0, z)],
                0.014 if kind == "pedestal" else 0.02,
                7,
                mat=paint,
            ).move(0.05)
        )
        if kind == "pedestal":
            body.append(
                lathe(
                    [(0, 0.5), (0.022, 0.5), (0.022, 0.56), (0, 0.56)],
                    9,
                    mat=plain(shade(colour, 0.6), 0.03),
                )
            )
            lamp = (0.022, 0, z - r - 0.1)
            body.append(box(0.05, 0.06, 0.13, (0, 0, z - r - 0.15), paint))
        else:
            for k in range(4):
                body.append(
                    box(
                        0.02,
                        0.022,
                        0.014,
                        (0.085, (k - 1.5) * 0.03, 0.016),
                        plain(shade(colour, 1.3), 0.02),
                    )
                )
            lamp = (0.05, 0.0, 0.043)
        pieces = [cylinder_piece(base, 0, 0.03), box_piece((0, 0, z / 2), (0.05, 0.05, z))]
    motor = ellipsoid((0.07, 0.055, 0.055), (-0.075, 0, z), 8, 5, paint)
    if kind != "drum":
        body.append(motor)
    body += [m.move(0, 0, z) for m in _cage(r, wire, 6)]
    off = [m.move(0, 0, z) for m in _blades(r * 0.9, 3 if kind != "drum" else 4, leaf)]
    on = [m.move(0, 0, z) for m in _blur(r * 0.9, blade)]
    disc = cylinder_piece(r, -0.05, 0.06, 10)
    pieces.append(np.c_[disc[:, 2], disc[:, 0], disc[:, 1] + z])
    title = {"pedestal": "pedestal fan", "table": "table fan", "drum": "floor fan"}[kind]
    return _fan(title, body, off, on, lamp, pieces, 3.5 if kind == "pedestal" else 1.8)


def box_fan(colour: str, blade: str, size: float) -> Model:
    """A square fan with a grille of rings, a handle and a switch."""
    paint, leaf, wire = (
        plain(colour, 0.03, 20),
        plain(blade, 0.03),
        plain(shade(colour, 0.75), 0.03),
    )
    d, z = 0.12, size / 2 + 0.02
    outer, inner = (
        rounded_rectangle(size, size, 0.04, 3),
        rounded_rectangle(size * 0.93, size * 0.93, 0.03, 3),
    )
    rings = [
        np.c_[np.full(12, x), o]
        for x, o in ((-d / 2, outer), (d / 2, outer), (d / 2, inner), (-d / 2, inner))
    ]
    frame = loft([*rings, rings[0]], paint, caps=(False, False)).outward()
    body = [frame]
    back = box(
        0.006, size * 0.93, size * 0.93, (-d / 2 + 0.006, 0, -size * 0.465), plain("#2c2f33", 0.03)
    )
    body.append(back)
    for r in (0.16, 0.3, 0.43):
        body.append(
            tube(
                ring(18, size * r, size * r)[:, [2, 0, 1]] + [d / 2 - 0.006, 0, 0],
                0.004,
                3,
                closed=True,
                mat=wire,
                weight=0.5,
            )
        )
    for k in range(6):
        a = k * math.pi / 6
        c, s = math.cos(a) * size * 0.47, math.sin(a) * size * 0.47
        body.append(
            tube([(d / 2 - 0.005, -c, -s), (d / 2 - 0.005, c, s)], 0.004, 3, mat=wire, weight=0.5)
        )
    body.append(
        bent(
            [
                (0, -0.08, size / 2 - 0.004),
                (0, -0.06, size / 2 + 0.03),
                (0, 0.06, size / 2 + 0.03),
                (0, 0.08, size / 2 - 0.004),
            ],
            0.01,
            wire,
            5,
            1,
        )
    )
    knob = lathe([(0.028, 0), (0.024, 0.02), (0, 0.02)], 12, mat=plain("#c8302c", 0.02))
    body.append(knob.turn(ry=math.pi / 2).move(d / 2 - 0.002, size * 0.4, size * 0.4))
    for q in (-1, 1):
        body.append(box(d + 0.08, 0.03, 0.03, (0, q * size * 0.38, -size / 2 - 0.02), wire, 0.005))
    off, on = _blades(size * 0.41, 5, leaf), _blur(size * 0.41, blade)
    lamp = (d / 2, -size * 0.41, size * 0.41)
    for m in (*body, *off, *on):
        m.move(0, 0, z)
    lamp = (lamp[0], lamp[1], lamp[2] + z)
    return _fan(
        "box fan",
        body,
        off,
        on,
        lamp,
        [box_piece((0, 0, (z + size / 2) / 2), (d, size, z + size / 2))],
        3.0,
    )


def tower_fan(colour: str, blade: str, height: float) -> Model:
    """A slim column with a slotted outlet and a lit display."""
    paint, dark = plain(colour, 0.03, 20), plain(blade, 0.04)
    rings = [superellipse(0.07, 0.08, 2.4, 14, z) for z in (0.03, height - 0.03)]
    rings.append(superellipse(0.055, 0.065, 2.4, 14, height))
    body = [
        loft(rings, paint),
        lathe([(0, 0), (0.13, 0), (0.125, 0.018), (0.06, 0.032), (0, 0.032)], 18, mat=dark),
    ]
    h = height * 0.6
    picture, draw = canvas(96, 64, "#101214")
    text(draw, "3", (10, 6, 86, 58), "bold", "#5affa0")
    on_face = printed(picture, occlusion=0)

    def outlet(lit: bool) -> list[Mesh]:
        image, pen = canvas(64, 256, "#1a1c1f" if not lit else "#6a7478")
        for k in range(30):
            pen.line(
                (0, 8 * k + 4, 64, 8 * k + (4 if not lit else 1)),
                fill="#7a7e84" if not lit else "#c8d4d8",
                width=3,
            )
        return [box(0.02, 0.085, h, (0.062, 0, 0.1), dark, labels={"+x": printed(image)})]

    body.append(box(0.02, 0.05, 0.034, (0.06, 0, height * 0.86), dark))
    model = _fan(
        "tower fan",
        body,
        outlet(False),
        outlet(True),
        (0.07, 0, height * 0.81),
        [cylinder_piece(0.125, 0, 0.03), box_piece((0, 0, height / 2), (0.14, 0.16, height))],
        2.5,
    )
    screen = box(0.004, 0.044, 0.03, (0.071, 0, height * 0.862), dark, labels={"+x": on_face})
    model.parts["lamp_lit"].meshes.append(screen)
    return model


def fan(kind: str, colour: str, blade: str, **size) -> Model:
    """A fan: "pedestal", "table", "drum", "box" or "tower"."""
    if kind == "box":
        return box_fan(colour, blade, **size)
    if kind == "tower":
        return tower_fan(colour, blade, **size)
    return standing_fan(kind, colour, blade, **size)


def fan_random(rng: np.random.Generator) -> dict:
    return {"kind": "table", "colour": pick(rng, ["#f0efea", "#2f3136"]), "blade": "#7fb4d0"}


MODELS = {
    "fan": Maker(
        fan,
        fan_random,
        7,
        [
            {"kind": "pedestal", "r": 0.21, "height": 1.2, "colour": "#f0efea", "blade": "#5fa8c8"},
            {"r": 0.16, "height": 0.42, "colour": "#2f5f7a", "blade": "#9fc8d8"},
            {"kind": "tower", "height": 0.85, "colour": "#2a2c30", "blade": "#17181a"},
            {"kind": "box", "size": 0.48, "colour": "#e8e8e4", "blade": "#7a9ab0"},
            {"kind": "drum", "r": 0.22, "height": 0.52, "colour": "#26282c", "blade": "#c8ccd0"},
            {"r": 0.16, "height": 0.42, "colour": "#f0efea", "blade": "#f0b84a"},
            {"kind": "pedestal", "r": 0.21, "height": 1.2, "colour": "#2a2c30", "blade": "#8a9096"},
        ],
    ),
}
