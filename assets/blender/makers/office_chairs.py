"""Swivel chairs for a desk."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import Material, plain
from toolkit.mesh import Mesh, cube_project
from toolkit.model import Maker, Model
from toolkit.sampling import noise_offset, pick
from toolkit.shapes import lathe, loft, rounded_rectangle, spline, tube

from .chair_forms import OFFICE_CHAIRS
from .designs import extend
from .joinery import Assembly, fabric, steel, surface

Offset = tuple[float, float, float]


def _star(asm: Assembly, radius: float, hub_z: float, frame: Material, tyre: Material) -> None:
    """Five arms, each ending on a castor."""
    hub = [(0, hub_z - 0.035), (0.04, hub_z - 0.035), (0.04, hub_z + 0.02), (0.03, hub_z + 0.035)]
    asm.add("body", lathe([*hub, (0, hub_z + 0.035)], 14, mat=frame))
    for k in range(5):
        a = 2 * math.pi * k / 5 + math.pi / 5
        c, s = math.cos(a), math.sin(a)
        rings = []
        for r, z, wide, tall in (
            (0.02, hub_z, 0.026, 0.024),
            (0.6 * radius, hub_z - 0.006, 0.02, 0.017),
            (radius, hub_z - 0.03, 0.016, 0.01),
        ):
            section = rounded_rectangle(2 * wide, 2 * tall, 0.4 * tall, 2)
            rings.append(np.array([(r * c - w * s, r * s + w * c, z + h) for w, h in section]))
        asm.add("body", loft(rings, frame))
        asm.piece("body", np.concatenate([ring[::2] for ring in rings]))
        x, y = radius * c, radius * s
        wheel = [(0, -0.022), (0.022, -0.022), (0.027, -0.016), (0.027, 0.016), (0.022, 0.022)]
        mesh = lathe([*wheel, (0, 0.022)], 12, mat=tyre).turn(rx=math.pi / 2).turn(rz=a + 0.9)
        asm.add("body", mesh.move(x, y, 0.027))
        asm.solid("body", (x - 0.022, y - 0.022, 0), (x + 0.022, y + 0.022, 0.06))


def _pad(tall: float, wide: float, thick: float, bend: float, mat: Material) -> Mesh:
    """An upholstered pad, its face up: `tall` along x, `wide` along y, its sides bent upwards."""
    rings = []
    for u in (-1, -0.97, -0.88, -0.72, -0.45, 0, 0.45, 0.72, 0.88, 0.97, 1):
        # rounded in plan and in section: short and thin rings at both ends
        plump = (1 - abs(u) ** 5) ** 0.5
        section = rounded_rectangle(
            tall * (0.66 + 0.34 * plump),
            thick * (0.3 + 0.7 * plump),
            thick * (0.13 + 0.3 * plump),
            3,
        )
        y = u * wide / 2
        rings.append(np.array([(a, y, b + bend * y * y) for a, b in section]))
    return loft(rings, mat, weight=1.2)


def office_chair(
    colour: str = "#3c434a",
    frame: str = "#2a2c2e",
    height: float = 1.02,
    arms: bool = True,
    mesh_back: bool = False,
    offset: Offset = (0, 0, 0),
) -> Model:
    """A five-star base on castors, gas spring, padded seat and back; arm rests if wanted."""
    asm, seat_z = Assembly(), 0.49
    cloth, plastic, tyre = (
        fabric(colour, offset),
        plain(frame, 0.05, 20, offset),
        plain("#1f2021", 0.06),
    )
    base = steel(20) if frame.startswith("#d") else plastic
    _star(asm, 0.27, 0.105, base, tyre)
    column = [(0, 0.13), (0.027, 0.13), (0.027, 0.27), (0.016, 0.275), (0.016, 0.4), (0, 0.4)]
    asm.add("body", lathe(column, 12, mat=base), solid=True)
    asm.board("body", (-0.1, -0.08, 0.385), (0.1, 0.08, 0.425), plastic, 0.012)
    lever = tube([(0.02, -0.07, 0.4), (0.03, -0.2, 0.395)], 0.007, 6, mat=plastic)
    asm.add("body", lever)
    asm.board("body", (-0.19, -0.2, 0.42), (0.19, 0.2, 0.432), plastic, 0.004)
    asm.add("body", _pad(0.47, 0.48, 0.062, 0.0, cloth).move(0.01, 0, 0.459))
    asm.solid("body", (-0.21, -0.22, 0.43), (0.23, 0.22, seat_z - 0.001))
    # back: a curved pad on a bent bar, or a net in a frame
    low_z, tilt = seat_z + 0.1, -0.13
    tall, wide = height - low_z, 0.44

    def back_x(z: float) -> float:
        return -0.235 + (z - low_z) * math.tan(tilt)

    bar = [(-0.06, 0, 0.405), (-0.22, 0, 0.41), (-0.275, 0, 0.47), (back_x(0.66) - 0.05, 0, 0.66)]
    bar += [(back_x(low_z + 0.6 * tall) - 0.04, 0, low_z + 0.6 * tall)]
    flat = 0.45
    asm.add("body", tube(spline(bar, 3), 0.03, 8, mat=plastic, flatten=flat, up=(1, 0, 0.01)))
    if mesh_back:
        net = Material()
        holes = net.remap(net.voronoi(70, offset=offset, randomness=0.0), 0.3, 0.42)
        net.colour(net.mix(holes, "#17191b", colour))
        rim = rounded_rectangle(tall - 0.02, wide - 0.02, 0.09, 5)
        hoop = tube(
            [(x, y, 1.1 * y * y) for x, y in rim], 0.015, 6, closed=True, mat=plastic, up=(0, 0, 1)
        )
        parts = [_pad(tall - 0.02, wide - 0.02, 0.014, 1.1, net), hoop]
    else:
        shell = _pad(tall - 0.05, wide - 0.04, 0.03, 1.1, plastic).move(z=-0.026)
        parts = [_pad(tall, wide, 0.06, 1.1, cloth), shell]
    for part in parts:
        part.turn(ry=math.pi / 2 + tilt).move(back_x(low_z + tall / 2), 0, low_z + tall / 2)
        asm.add("body", part)
    corners = [
        (back_x(z) + dx, y, z) for z in (low_z, height) for dx in (-0.02, 0.06) for y in (-0.2, 0.2)
    ]
    asm.piece("body", np.array(corners))
    if arms:
        for s in (-1, 1):
            y = s * 0.275
            path = [(-0.05, s * 0.19, 0.415), (-0.05, y - s * 0.02, 0.42), (-0.05, y, 0.47)]
            path += [(-0.05, y, 0.66)]
            asm.add("body", tube(spline(path, 3), 0.016, 6, mat=plastic))
            rest = rounded_rectangle(0.26, 0.07, 0.03, 3)
            top = [
                np.c_[rest * k, np.full(len(rest), z)]
                for k, z in ((0.9, 0.655), (1, 0.67), (0.92, 0.685))
            ]
            asm.add("body", cube_project(loft(top, plastic).move(-0.01, y, 0)))
            asm.solid("body", (-0.14, y - 0.035, 0.655), (0.12, y + 0.035, 0.685))
            asm.solid("body", (-0.066, y - 0.016, 0.42), (-0.034, y + 0.016, 0.655))
    return Model(
        title=f"office chair{' with arm rests' if arms else ''}",
        parts=asm.parts(),
        mass=13.0 if arms else 10.0,
        supports=[surface("seat", (-0.16, -0.19), (0.2, 0.19), seat_z)],
        ground_shadow=True,
    )


def office_chair_random(rng: np.random.Generator) -> dict:
    """Parameters of a random office chair."""
    return {
        "colour": pick(rng, ["#3c434a", "#5b6f80", "#7c4a3c", "#60705d"]),
        "frame": pick(rng, ["#2a2c2e", "#d5d7d8"]),
        "height": round(float(rng.uniform(0.92, 1.06)), 2),
        "arms": bool(rng.random() < 0.6),
        "mesh_back": bool(rng.random() < 0.4),
        "offset": noise_offset(rng),
    }


MODELS = {
    "office_chair": extend(
        Maker(
            office_chair,
            office_chair_random,
            2,
            [
                {
                    "colour": "#3f464d",
                    "frame": "#2a2c2e",
                    "height": 1.04,
                    "arms": True,
                    "mesh_back": True,
                },
                {
                    "colour": "#557a86",
                    "frame": "#d5d7d8",
                    "height": 0.92,
                    "arms": False,
                    "mesh_back": False,
                },
            ],
        ),
        OFFICE_CHAIRS,
    ),
}
