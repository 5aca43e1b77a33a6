"""Buckets, and a dustpan with its brush."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import metal, plain
from toolkit.model import (
    Container,
    Maker,
    Model,
    Part,
    box_piece,
    cylinder_piece,
    ring_pieces,
)
from toolkit.sampling import pick, uniform
from toolkit.shapes import (
    box,
    extrude,
    lathe,
    spline,
    tube,
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
    shell = lathe(profile, 28, mats=[body, inner], mat_of_segment=[0] * 7 + [1, 1]).weigh(1.2)
    wire = metal("b4b9bd", "6a7075")
    swing = -0.12 if bail_down else math.pi / 2
    reach = radius + 0.008
    arc = []
    for t in np.linspace(0, math.pi, 15):
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
    return Model(
        "zinc bucket" if metal_body else "plastic bucket",
        {"body": part},
        mass=0.9 if metal_body else 0.45,
        containers=[inside],
        texture_size=128,
        ground_shadow=True,
    )


def bucket_random(rng: np.random.Generator) -> dict:
    return {
        "radius": uniform(rng, 0.13, 0.15),
        "height": uniform(rng, 0.25, 0.29),
        "metal_body": False,
        "colour": pick(rng, ["#d8303a", "#2f6fc0", "#e8b92c", "#3a9a5a"]),
        "bail_down": True,
    }


def broom_dustpan(colour: str, bristle: str, width: float) -> Model:
    """A dustpan with a hand brush lying in it."""
    pan_mat = plain(colour, 0.04)
    length = 0.22
    floor = [(-0.11, 0.004), (0.11, 0.0), (0.11, 0.006), (-0.11, 0.012)]
    base = extrude(floor, width, mat=pan_mat, axis="y")
    back = box(0.008, width, 0.055, (-length / 2 + 0.004, 0, 0.002), pan_mat, bevel_width=0.002)
    sides = []
    for s in (-1, 1):
        outline = [
            (-length / 2, 0.002),
            (length / 2, 0.001),
            (length / 2, 0.01),
            (-length / 2 + 0.02, 0.057),
            (-length / 2, 0.057),
        ]
        sides.append(
            extrude(outline, 0.007, mat=pan_mat, axis="y", bevel_width=0.001).move(
                y=s * (width / 2 - 0.0035)
            )
        )
    handle = tube(
        [(-length / 2, 0, 0.045), (-length / 2 - 0.05, 0, 0.04), (-length / 2 - 0.12, 0, 0.026)],
        [0.012, 0.011, 0.014],
        8,
        mat=pan_mat,
        up=(0, 1, 0),
    )
    brush_mat, hair = plain(colour, 0.04), plain(bristle, 0.25, 400)
    block = box(0.135, 0.032, 0.02, (0.02, 0, 0), brush_mat, bevel_width=0.006)
    tuft = box(0.13, 0.04, 0.036, (0.02, 0, -0.035), hair, bevel_width=0.004)
    grip = tube(
        spline([(-0.04, 0, 0.01), (-0.09, 0, 0.014), (-0.16, 0, 0.016)], 3),
        np.interp(np.linspace(0, 1, 7), [0, 0.5, 1], [0.011, 0.009, 0.012]),
        8,
        mat=brush_mat,
        up=(0, 1, 0),
    )
    brush = [block, tuft, grip]
    for mesh in brush:
        mesh.turn(rz=0.16).move(x=0.0, y=0.005, z=0.046)
    pieces = [
        box_piece((0, 0, 0.006), (length, width, 0.012)),
        box_piece((-length / 2 + 0.004, 0, 0.03), (0.008, width, 0.055)),
        box_piece((-0.02, 0, 0.05), (0.24, 0.07, 0.03)),
        box_piece((-length / 2 - 0.06, 0, 0.03), (0.12, 0.03, 0.03)),
    ]
    part = Part([base, back, *sides, handle, *brush], collision=pieces)
    return Model("dustpan with a hand brush", {"body": part}, mass=0.35, texture_size=128)


def broom_dustpan_random(rng: np.random.Generator) -> dict:
    return {
        "colour": pick(rng, ["#2f7fc0", "#c8303a", "#3a9a6a"]),
        "bristle": pick(rng, ["#e9e2cc", "#26262a"]),
        "width": uniform(rng, 0.21, 0.24),
    }


MODELS = {
    "bucket": Maker(
        bucket,
        bucket_random,
        3,
        [{"colour": "#2f6fc0"}, {"metal_body": True}, {"bail_down": False}],
    ),
    "broom_dustpan": Maker(broom_dustpan, broom_dustpan_random, 2),
}
