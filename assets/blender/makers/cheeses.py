"""More cheese: wheels, holed blocks, slices, red wax, soft rounds. Fresh and mouldy."""

from __future__ import annotations

import math

import numpy as np
from toolkit import labels
from toolkit.materials import Material, label, plain, shade
from toolkit.mesh import Mesh
from toolkit.model import Model
from toolkit.sampling import noise_offset
from toolkit.shapes import box, ellipsoid, extrude, lathe

from makers.produce_kit import baked_good, footed, halve, one_hull, rot, spread


def paste(rotten: bool, colour, spots, o, size=0.024, holes: float = 0.3) -> Material:
    """The inside of a cheese, with holes (0: none)."""
    m = Material(occlusion=0.8)
    c = m.mottle(colour, 0.05, 40, o)
    for scale, wide in ((38, holes), (70, holes * 0.8)) if holes else ():
        field = m.voronoi(scale, (o[0], o[1], scale))
        c = m.mix(m.remap(field, wide, wide + 0.05, 1, 0), c, shade(colour, 0.72))
        c = m.mix(m.remap(field, wide * 0.6, wide, 0.8, 0), c, shade(colour, 0.52))
    return m.colour(rot(m, c, size, spots, o, "5c5234", 0.15) if rotten else c)


def rind(rotten: bool, colour, spots, o, size=0.026) -> Material:
    m = Material()
    c = m.mottle(colour, 0.07, 50, o)
    return m.colour(rot(m, c, size, spots, o, "4a4028", 0.15) if rotten else c)


def missing_piece(outer, faces_of, r: float, h: float, gap: float, turn: float, n=20) -> Mesh:
    """A round of cheese with a piece taken out at angle `turn`; the cut sides are `faces_of`."""
    a = np.linspace(gap / 2 + turn, math.tau - gap / 2 + turn, n)
    mesh = extrude([(0, 0), *[(r * math.cos(t), r * math.sin(t)) for t in a]], h, outer)
    mesh.mats = [outer, faces_of]
    for i, f in enumerate(mesh.f):
        points = mesh.v[list(f)]
        if np.ptp(points[:, 2]) > h * 0.5 and np.hypot(points[:, 0], points[:, 1]).min() < r * 0.1:
            mesh.mi[i] = 1
    return mesh


def cheese_served(form="wheel", seed=0) -> Model:
    """A wheel, a block with holes, slices, red balls, a soft white round, cubes on a board."""
    rng = np.random.default_rng(seed)
    o = noise_offset(rng)

    def wheel(rotten: bool) -> list[Mesh]:
        r, h = 0.09, 0.06
        spots = [
            (0.07, -0.045, 0.045),
            (0.03, 0.02, h, 0.9),
            (-0.05, 0.01, h),
            (0.03, 0.045, 0.03, 0.9),
            (0, -0.06, h, 0.7),
            (-0.085, -0.03, 0.035),
            (-0.045, 0.075, 0.03, 0.9),
            (-0.02, -0.085, 0.025, 0.8),
        ]
        outer = rind(rotten, "e0a024", spots, o)
        inner = paste(rotten, "f6d458", spots, o)
        return [missing_piece(outer, inner, r, h, 1.15, 0.5)]

    def holed(rotten: bool) -> list[Mesh]:
        spots = [
            (0.036, 0.03, 0.05),
            (0.036, -0.04, 0.03, 0.9),
            (0, 0.0, 0.07),
            (-0.01, -0.05, 0.07, 0.8),
            (-0.036, 0.035, 0.045),
            (-0.036, -0.03, 0.03, 0.9),
            (0.012, 0.075, 0.045),
            (-0.012, -0.075, 0.03),
        ]
        mesh = box(
            0.075, 0.15, 0.07, mat=paste(rotten, "f6d050", spots, o, 0.026), bevel_width=0.003
        )
        return [mesh]

    def slices(rotten: bool) -> list[Mesh]:
        out = []
        for i in range(5):
            spots = [
                (0.02, 0.015, 0),
                (-0.025, -0.02, 0, 0.8),
                (0.035, -0.035, 0, 0.7),
                (-0.02, 0.04, 0, 0.6),
            ]
            mat = paste(rotten, "f8cc3c", spots, (o[0] + i, o[1], o[2]), 0.022, 0.24)
            piece = box(0.1, 0.1, 0.005, mat=mat).keep_pattern()
            out.append(
                piece.turn(rz=0.12 * math.sin(2.2 * i)).move(0.011 * i, 0.006 * i, 0.0051 * i)
            )
        return out

    def red_half(rotten: bool) -> list[Mesh]:
        r = 0.062
        spots = [
            (0.0, 0.02, 0.104),
            (0.055, 0.025, 0.06),
            (-0.055, 0.022, 0.065),
            (0.0, 0.06, 0.05, 0.9),
            (0.035, -0.048, 0.065),
            (-0.035, -0.048, 0.06, 0.9),
        ]
        wax = rind(rotten, "b81c22", spots, o)
        ball = ellipsoid((r, r, r * 0.85), (0, 0, r * 0.85), 16, 10, wax)
        mesh = halve(
            ball,
            (0, 0.002, 0),
            (0, 1, 0),
            paste(rotten, "f6d060", [(0.03, 0, 0.07), (-0.025, 0, 0.035, 0.8)], o, 0.026, 0.28),
        )
        whole = ball.copy().keep_pattern().move(-0.035, -0.1)
        cut = mesh.keep_pattern().turn(rz=-1.15).move(0.03, 0.04)
        return [whole, cut]

    def soft(rotten: bool) -> list[Mesh]:
        r, h = 0.055, 0.032
        spots = [
            (0.02, -0.03, h),
            (-0.03, 0.01, h, 0.9),
            (0.045, -0.02, 0.02, 0.9),
            (0.02, 0.02, 0.02, 0.6),
            (-0.05, -0.02, 0.022, 0.8),
            (-0.01, 0.052, 0.024, 0.8),
        ]
        outer = rind(rotten, "f2ede0", spots, o, 0.03)
        mesh = missing_piece(outer, paste(rotten, "f4dc8c", spots, o, 0.024, 0.0), r, h, 1.0, 0.5)
        return [mesh.move(z=0.005)]

    def round_box() -> list[Mesh]:
        """The camembert's box, its lid leaning on it."""
        wood = plain("d8b47c", 0.12, 90)
        base = lathe(
            [(0, 0), (0.066, 0), (0.066, 0.018), (0.062, 0.018), (0.062, 0.005), (0, 0.005)],
            22,
            mat=wood,
        )
        image, d = labels.canvas(200, 200, "#2f5aa8")
        d.ellipse((4, 4, 196, 196), fill="#f4ecd2", outline="#b81c22", width=8)
        labels.text(d, "CAMEMBERT", (18, 78, 182, 122), "bold", "#1c2a5a")
        labels.text(d, "Val Doré", (50, 46, 150, 74), "italic", "#b81c22")
        lid = lathe([(0, 0), (0.068, 0), (0.068, 0.014), (0, 0.014)], 20, mat=wood)
        from makers.projection import project_label

        project_label(lid, label(image), "+z", (0, 0), (0.136, 0.136), 0.8)
        lid.keep_pattern().turn(ry=1.05).move(-0.065, -0.01)
        lid.move(z=-lid.v[:, 2].min())
        return [base, lid]

    def cubes(rotten: bool) -> list[Mesh]:
        spots = [(0.01, 0.004, 0.02), (-0.006, 0.01, 0.01, 0.9)]
        mat = paste(rotten, "f6ce4a", spots, o, 0.014, 0.26)
        cube = box(0.024, 0.024, 0.022, mat=mat)
        wedge = extrude(
            [(0, -0.03), (0.075, -0.012), (0.075, 0.012), (0, 0.03)],
            0.045,
            paste(rotten, "f6ce4a", [(0.05, 0, 0.045), (0.02, 0.02, 0.03)], o, 0.02),
        )
        wedge.keep_pattern().turn(rz=1.4).move(-0.01, 0.025, 0.014)
        grid = [
            (0.035, -0.07),
            (0.038, -0.035),
            (0.03, -0.002),
            (0.004, -0.06),
            (-0.03, -0.045),
            (0.002, -0.028),
            (0.045, 0.03),
        ]
        places = [(x, y, 0.014, 0.7 * i) for i, (x, y) in enumerate(grid)]
        return [
            wedge,
            *spread([cube], places),
            *spread([cube], [(0.018, -0.045, 0.036, 0.4)]),
        ]

    def board() -> list[Mesh]:
        wood = Material()
        c = wood.mix(
            wood.remap(wood.noise(1, 3, offset=o, stretch=(90, 9, 90)), 0.4, 0.62),
            "c89a5c",
            "a8783c",
        )
        wood.colour(c)
        return [box(0.13, 0.2, 0.014, mat=wood, bevel_width=0.003)]

    shapes = {
        "wheel": (wheel, "wheel of cheese with a piece cut out", 1.1),
        "holed": (holed, "block of cheese with holes", 0.6),
        "slices": (slices, "slices of cheese", 0.12),
        "red": (red_half, "red-waxed cheese, one cut in half", 0.9),
        "soft": (soft, "camembert in its box", 0.25),
        "cubes": (cubes, "cheese on a board", 0.4),
    }
    shape, title, mass = shapes[form]
    size = 256 if form == "soft" else 128
    dish = {"soft": round_box, "cubes": board}.get(form)
    return baked_good(title, shape, mass, footed if form == "red" else one_hull, size, dish)
