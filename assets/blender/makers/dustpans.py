"""Dustpans with their brushes and brooms."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import metal, plain, wood
from toolkit.mesh import Mesh
from toolkit.model import Model, Part, box_piece, cylinder_piece
from toolkit.shapes import box, extrude, lathe, loft, spline, tube

from makers.cleaner_forms import maker
from makers.convex import few_corners


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


def pan(width: float, length: float, tall: float, mat) -> list[Mesh]:
    """A dustpan's tray: open towards +x."""
    h = length / 2
    floor = [(-h, 0.004), (h, 0.0), (h, 0.006), (-h, 0.012)]
    out = [extrude(floor, width, mat=mat, axis="y")]
    out.append(box(0.008, width, tall, (-h + 0.004, 0, 0.002), mat, 0.002))
    outline = [(-h, 0.002), (h, 0.001), (h, 0.012), (-h + 0.25 * length, tall), (-h, tall)]
    for s in (-1, 1):
        wall = extrude(outline, 0.007, mat=mat, axis="y", bevel_width=0.001)
        out.append(wall.move(y=s * (width / 2 - 0.0035)))
    return out


def bristles(length: float, depth: float, tall: float, colour: str, flare: float = 1.15) -> Mesh:
    """A block of bristles, flaring downwards, its foot on z = 0, long along y."""
    mat = plain(colour, 0.3, 420)
    rings = []
    for z, f in ((0, flare), (0.5 * tall, 1.06), (tall, 1.0)):
        a, b = depth / 2 * f, length / 2 * (1 + (f - 1) * 0.5)
        corners = [(-a, -b), (a, -b), (a, b), (-a, b)]
        rings.append([(x, y, z) for x, y in corners])
    return loft(rings, mat=mat)


def pole(z0: float, z1: float, mat, grip, r: float = 0.0125) -> list[Mesh]:
    """An upright handle with a grip at its end."""
    shaft = lathe([(0, z0), (r, z0), (r, z1 - 0.08), (0, z1 - 0.08)], 8, mat=mat)
    profile = [(0, z1 - 0.12), (1.3 * r, z1 - 0.11), (1.35 * r, z1 - 0.015), (0.8 * r, z1), (0, z1)]
    return [shaft, lathe(profile, 10, mat=grip)]


def beside(colour: str, bristle: str) -> Model:
    """A metal dustpan and a wooden hand brush lying beside it, bristles to the side."""
    steel, timber = plain(colour, 0.05), wood("#c8935a", "8a6238", 0, 12)
    tray = pan(0.22, 0.2, 0.05, steel)
    grip = tube([(-0.1, 0, 0.03), (-0.15, 0, 0.03), (-0.23, 0, 0.02)], [0.011, 0.012, 0.013], 8)
    grip.mats = [steel]
    back = box(0.17, 0.022, 0.045, (0.03, 0, 0.0), timber, 0.006)
    hair = box(0.16, 0.06, 0.036, (0.03, 0.036, 0.004), plain(bristle, 0.3, 420), 0.005)
    handle = spline([(-0.05, 0, 0.024), (-0.1, 0, 0.022), (-0.17, 0, 0.02)], 3)
    stem = tube(handle, np.interp(np.linspace(0, 1, 7), [0, 0.5, 1], [0.012, 0.0105, 0.014]), 8)
    stem.mats = [timber]
    brush = [back, hair, stem]
    for mesh in brush:
        mesh.keep_pattern().turn(rz=-0.25).move(-0.02, 0.19, 0)
    pieces = [
        box_piece((0, 0, 0.006), (0.2, 0.22, 0.012)),
        box_piece((-0.096, 0, 0.028), (0.008, 0.22, 0.05)),
        few_corners(grip.v),
        few_corners(np.concatenate([back.v, hair.v])),
        few_corners(stem.v),
    ]
    part = Part([*tray, grip, *brush], collision=pieces)
    return Model("dustpan and brush", {"body": part}, mass=0.5, texture_size=128)


def lobby_set(colour: str, bristle: str) -> Model:
    """A long-handled dustpan standing upright with its broom clipped beside the handle."""
    mat, grip, steel = plain(colour, 0.04), plain("#26282c", 0.04), metal("b8bcc0", "7d858b")
    tray = [m.move(x=0.02) for m in pan(0.27, 0.25, 0.11, mat)]
    top = box(0.09, 0.27, 0.008, (-0.06, 0, 0.106), mat, 0.002)
    stem = pole(0.1, 0.86, steel, grip, 0.013)
    for mesh in stem:
        mesh.move(x=-0.085, y=-0.03)
    head = bristles(0.24, 0.045, 0.09, bristle).move(z=0.012)
    shoe = box(0.04, 0.24, 0.035, (0, 0, 0.1), mat, 0.008)
    broom = [head, shoe, *pole(0.13, 0.98, steel, plain(colour, 0.04), 0.013)]
    for mesh in broom:
        mesh.move(x=0.02, y=0.02)
    clip = box(0.12, 0.05, 0.02, (-0.035, -0.005, 0.62), grip, 0.004)
    pieces = [
        box_piece((0.02, 0, 0.006), (0.25, 0.27, 0.012)),
        box_piece((-0.06, 0, 0.058), (0.09, 0.27, 0.112)),
        few_corners(np.concatenate([head.v, shoe.v])),
        cylinder_piece(0.017, 0.13, 0.98, 8) + np.array([0.02, 0.02, 0]),
        cylinder_piece(0.017, 0.1, 0.86, 8) + np.array([-0.085, -0.03, 0]),
    ]
    part = Part([*tray, top, *stem, *broom, clip], collision=pieces)
    return Model("long-handled dustpan with its broom", {"body": part}, mass=1.1)


def broom_and_pan(colour: str, bristle: str) -> Model:
    """A room broom on its side, a dustpan beside it on the floor."""
    timber, mat = wood("#d0a468", "8a6238", 2, 9), plain(colour, 0.04)
    head = bristles(0.34, 0.06, 0.1, bristle, 1.25)
    block = box(0.07, 0.34, 0.045, (0, 0, 0.095), mat, 0.012)
    neck = lathe([(0, 0.13), (0.026, 0.13), (0.018, 0.19), (0, 0.19)], 10, mat=mat)
    broom = [head, block, neck, *pole(0.16, 1.1, timber, timber, 0.014)]
    for mesh in broom:  # on the side of its head and the end of its handle
        mesh.turn(ry=-math.pi / 2 - 0.02).move(z=0.0375)
    tray = pan(0.24, 0.2, 0.055, mat)
    grip = tube([(-0.1, 0, 0.045), (-0.14, 0, 0.04), (-0.2, 0, 0.03)], [0.012, 0.011, 0.014], 8)
    grip.mats = [mat]
    scoop = [*tray, grip]
    for mesh in scoop:
        mesh.turn(rz=2.6).move(-0.45, 0.18, 0)
    pieces = [
        few_corners(np.concatenate([head.v, block.v])),
        few_corners(np.concatenate([m.v for m in broom[2:]])),
        few_corners(tray[0].v),
        few_corners(tray[1].v),
        few_corners(grip.v),
    ]
    part = Part([*broom, *scoop], collision=pieces)
    return Model("broom and dustpan", {"body": part}, mass=1.0, front="-y")


def broom_dustpan_form(shape: str, colour: str, bristle: str) -> Model:
    """A dustpan: brush "in" it or "beside" it, "lobby" with long handles, with a "broom"."""
    if shape == "in":
        return broom_dustpan(colour, bristle, 0.22698879787673815)
    return {"beside": beside, "lobby": lobby_set, "broom": broom_and_pan}[shape](colour, bristle)


MODELS = {
    "broom_dustpan": maker(
        broom_dustpan_form,
        ("shape", "colour", "bristle"),
        [
            ("in", "#2f7fc0", "#e9e2cc"),
            ("in", "#3a9a6a", "#e9e2cc"),
            ("beside", "#a8aeb4", "#2a2018"),
            ("lobby", "#c8303a", "#26262a"),
            ("broom", "#3a9a6a", "#e8d8a8"),
            ("in", "#c8303a", "#26262a"),
            ("broom", "#7a4fb0", "#c8303a"),
        ],
    )
}
