"""Hammers and pliers lying flat, handles towards -X (turned at export to lie along y)."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import metal, plain, wood
from toolkit.mesh import Mesh
from toolkit.model import Model, Part
from toolkit.shapes import box, extrude, lathe, loft, spline, tube

from makers.cleaner_forms import maker
from makers.convex import few_corners


def lying(title: str, groups: list[list[Mesh]], mass: float, size: int = 128) -> Model:
    """A model of some groups of meshes, each with one convex hull; along y at export."""
    hulls = [few_corners(np.concatenate([m.v for m in group])) for group in groups]
    part = Part([m for group in groups for m in group], collision=hulls)
    return Model(title, {"body": part}, mass=mass, friction=0.5, texture_size=size, front="-y")


# ---- hammers
def shaft(
    length: float, thick: float, wooden: bool, colour: str, grip: str, z: float
) -> list[Mesh]:
    """A hammer's handle from the head's middle to -x; its rear half is the grip."""
    front = wood(colour, "7d5230", 0, 12) if wooden else metal(colour, "5c6268")
    back = wood(colour, "7d5230", 0, 12) if wooden else plain(grip, 0.06, 150)

    def bar(stations, mat) -> Mesh:
        rings = []
        for x, w, t in stations:
            a = np.arange(8) * math.tau / 8 + math.pi / 8
            rings.append([(x, w * math.cos(b), z + t * math.sin(b)) for b in a])
        return loft(rings, mat=mat)

    w, mid = thick, -0.48 * length
    near = bar(
        [
            (0.012, 0.8 * w, 0.62 * w),
            (-0.12 * length, 0.72 * w, 0.6 * w),
            (mid, 0.85 * w, 0.62 * w),
        ],
        front,
    )
    far = [(mid + 0.004, 1.0 * w, 0.72 * w), (-0.62 * length, 1.12 * w, 0.8 * w)]
    far += [(-0.8 * length, 1.0 * w, 0.75 * w), (-0.94 * length, 1.22 * w, 0.85 * w)]
    return [near, bar([*far, (-length, 0.95 * w, 0.62 * w)], back)]


def along_y(profile, mat, n: int = 12) -> Mesh:
    """A turned piece with its axis along y: (radius, y) pairs."""
    return lathe(profile, n, mat=mat).turn(rx=-math.pi / 2)


def hammer_head(kind: str, steel, dark) -> list[Mesh]:
    """The head at the origin, its striking face towards -y."""
    if kind == "claw":
        face = [(0, -0.062), (0.0135, -0.062), (0.0155, -0.059), (0.0155, -0.046), (0.0105, -0.038)]
        out = [along_y([*face, (0.0115, -0.012), (0, -0.01)], steel)]
        out.append(box(0.032, 0.036, 0.03, (0, 0, -0.015), steel, 0.004))
        for side in (-1, 1):
            rings = []
            for t in np.linspace(0, 1, 6):
                y, x = 0.012 + 0.072 * t, 0.002 - 0.036 * t**2.0
                w, h = 0.011 * (1 - 0.72 * t), 0.0052 * (1 - 0.35 * t)
                c, z = ((-w, -h), (w, -h), (w, h), (-w, h)), side * (0.006 + 0.005 * t)
                rings.append([(x + a, y, z + b) for a, b in c])
            out.append(loft(rings, mat=steel))
        return out
    if kind == "ball":
        line = [(0, -0.044), (0.0125, -0.044), (0.014, -0.041), (0.014, -0.03), (0.01, -0.024)]
        line += [(0.012, -0.01), (0.012, 0.01), (0.008, 0.019), (0.011, 0.025), (0.013, 0.032)]
        return [along_y([*line, (0.011, 0.04), (0.006, 0.0445), (0, 0.0455)], steel, 14)]
    if kind == "club":
        body = box(0.046, 0.1, 0.046, (0, 0, -0.023), dark, 0.007)
        ends = [box(0.036, 0.008, 0.036, (0, s * 0.053, -0.018), steel, 0.003) for s in (-1, 1)]
        return [body, *ends]
    if kind == "mallet":
        line = [(0, -0.058), (0.027, -0.058), (0.032, -0.052), (0.03, -0.03), (0.03, 0.03)]
        return [along_y([*line, (0.032, 0.052), (0.027, 0.058), (0, 0.058)], dark, 18)]
    wedge = [(-0.013, 0.012), (0.013, 0.012), (0.006, 0.055), (0.0, 0.058), (-0.004, 0.055)]
    body = box(0.026, 0.068, 0.026, (0, -0.021, -0.013), dark, 0.003)
    face = box(0.024, 0.01, 0.024, (0, -0.058, -0.012), steel, 0.003)
    return [body, face, extrude(wedge, 0.026, steel).move(z=-0.013)]


HAMMERS = {  # length, half thickness of the handle, mass
    "claw": (0.31, 0.0155, 0.7),
    "ball": (0.235, 0.0125, 0.45),
    "club": (0.225, 0.0175, 1.3),
    "mallet": (0.32, 0.016, 0.6),
    "pein": (0.27, 0.0145, 0.4),
}


def hammer(kind: str, wooden: bool, colour: str, grip: str, head: str) -> Model:
    """A hammer on its side."""
    length, thick, mass = HAMMERS[kind]
    steel, dark = metal("b8bcc0", "6f757b"), plain(head or "#26282c", 0.08, 80)
    meshes = hammer_head(kind, steel, dark)
    lift = -min(m.v[:, 2].min() for m in meshes)
    for mesh in meshes:
        mesh.move(z=lift)
    # the handle's end rests on the floor: the whole leans a little
    handle = shaft(length, thick, wooden, colour, grip, 0.0)
    drop = math.atan2(lift - 0.85 * thick, length)
    for mesh in handle:
        mesh.turn(ry=-drop).move(z=lift)
    nub = box(
        0.012, 1.3 * thick, 1.0 * thick, (0.016, 0, lift - 0.5 * thick), meshes[0].mats[0], 0.002
    )
    if kind in ("claw", "pein", "ball"):
        meshes.append(nub)
    title = {"ball": "ball-peen hammer", "mallet": "rubber mallet", "pein": "hammer"}.get(
        kind, f"{kind} hammer"
    )
    return lying(title, [meshes, handle], mass)


# ---- pliers
# jaw from above (side +y): outline; handle: middle line of the half whose handle lies at +y
PLIERS = {
    "combination": (
        [
            (-0.012, 0.0),
            (-0.012, 0.013),
            (0.002, 0.0155),
            (0.02, 0.0145),
            (0.046, 0.0085),
            (0.047, 0.0),
        ],
        [(-0.008, 0.009), (-0.03, 0.017), (-0.07, 0.025), (-0.115, 0.022), (-0.135, 0.026)],
        12,
    ),
    "needle": (
        [
            (-0.011, 0.0),
            (-0.011, 0.011),
            (0.004, 0.0125),
            (0.02, 0.0085),
            (0.082, 0.0024),
            (0.083, 0.0),
        ],
        [(-0.008, 0.008), (-0.028, 0.016), (-0.062, 0.023), (-0.1, 0.019), (-0.115, 0.022)],
        16,
    ),
    "flat": (  # broad, square-ended jaws; short handles, open: shut, one sees a knife
        [
            (-0.011, 0.0),
            (-0.011, 0.0125),
            (0.004, 0.0145),
            (0.014, 0.0105),
            (0.06, 0.008),
            (0.06, 0),
        ],
        [(-0.008, 0.009), (-0.022, 0.013), (-0.05, 0.0115), (-0.082, 0.0105), (-0.1, 0.0135)],
        30,
    ),
    "pincers": (
        [
            (-0.01, 0.002),
            (-0.006, 0.014),
            (0.012, 0.029),
            (0.034, 0.03),
            (0.05, 0.018),
            (0.054, 0.0),
            (0.046, 0.0),
            (0.036, 0.0145),
            (0.022, 0.0165),
            (0.008, 0.008),
            (0.002, 0.0),
        ],
        [(-0.006, 0.008), (-0.03, 0.014), (-0.08, 0.022), (-0.13, 0.027), (-0.155, 0.03)],
        4,
    ),
    "slip": (
        [
            (-0.012, 0.0),
            (-0.012, 0.014),
            (0.004, 0.0165),
            (0.024, 0.0165),
            (0.044, 0.009),
            (0.046, 0.002),
            (0.024, 0.004),
        ],
        [(-0.008, 0.01), (-0.03, 0.018), (-0.075, 0.026), (-0.12, 0.021), (-0.14, 0.024)],
        52,
    ),
}

#: Where the jaws are grooved: the first groove, the step to the next, how many.
TEETH = {
    "combination": (0.026, 0.004, 4),
    "slip": (0.026, 0.004, 4),
    "needle": (0.04, 0.008, 5),
    "flat": (0.026, 0.0055, 6),
}


def pliers_half(kind: str, side: int, steel, grip) -> list[Mesh]:
    """One half: the jaw on one side of the pivot, its handle on the other."""
    jaw, line, angle = PLIERS[kind]
    steel_jaw = extrude(jaw, 0.011, steel, bevel_width=0.0012)
    steel_jaw.scale(1, side, 1)
    path = spline([(x, -side * y, 0.0065) for x, y in line], 3)
    radii = np.interp(
        np.linspace(0, 1, len(path)), [0, 0.25, 0.6, 1], [0.0055, 0.0058, 0.0082, 0.0075]
    )
    cut = len(path) // 4
    bare = tube(path[: cut + 1], radii[: cut + 1], 6, mat=steel, up=(0, 0, 1.0))
    sleeve = tube(path[cut:], radii[cut:] * 1.12, 7, mat=grip, up=(0, 0, 1.0))
    teeth = []
    if kind in TEETH:
        start, step, count = TEETH[kind]
        dark = plain("4a4f55", 0.0)
        for k in range(count):
            line_k = box(0.0012, 0.0045, 0.0114, (start + step * k, side * 0.0022, -0.0002), dark)
            teeth.append(line_k)
    group = [steel_jaw, bare, sleeve, *teeth]
    for mesh in group:
        mesh.turn(rz=side * math.radians(angle / 2)).move(z=0.0012)
    return group


def pump_pliers(colour: str) -> Model:
    """Long water-pump pliers with bent jaws."""
    steel, grip, dark = metal("8a9096", "4c5258"), plain(colour, 0.05), plain("3a3f45", 0.0)
    upper = [(-0.02, -0.008), (0.004, -0.013), (0.026, 0.004), (0.046, 0.034), (0.04, 0.043)]
    upper += [(0.026, 0.036), (0.006, 0.014), (-0.018, 0.012)]
    lower = [(-0.01, -0.012), (0.03, -0.014), (0.062, 0.008), (0.071, 0.022), (0.058, 0.03)]
    lower += [(0.05, 0.02), (0.034, 0.004), (-0.008, 0.01)]
    a = [extrude(upper, 0.011, steel, bevel_width=0.001).move(z=0.003)]
    b = [extrude(lower, 0.008, dark, bevel_width=0.001).move(z=0.001)]
    for group, line in (
        (a, [(-0.012, 0.002), (-0.06, -0.02), (-0.12, -0.042), (-0.19, -0.046)]),
        (b, [(-0.006, 0.0), (-0.05, 0.018), (-0.11, 0.03), (-0.185, 0.026)]),
    ):
        path = spline([(x, y, 0.0085) for x, y in line], 3)
        group.append(tube(path[:3], 0.0065, 6, mat=steel, up=(0, 0, 1.0)))
        group.append(
            tube(path[2:], np.linspace(0.0075, 0.0088, len(path) - 2), 7, mat=grip, up=(0, 0, 1.0))
        )
    pin = lathe([(0, 0), (0.0075, 0), (0.006, 0.003), (0, 0.0032)], 10, mat=steel).move(
        0.006, 0, 0.0135
    )
    a.append(pin)
    return lying("water-pump pliers", [a, b], 0.35)


def pliers(kind: str, colour: str) -> Model:
    """Pliers lying a little open."""
    if kind == "pump":
        return pump_pliers(colour)
    steel = metal("9a9fa5", "4c5258")
    grip = metal("8a9096", "4c5258") if colour == "steel" else plain(colour, 0.05)
    groups = [pliers_half(kind, side, steel, grip) for side in (-1, 1)]
    for mesh in groups[1]:
        mesh.move(z=0.0006)
    pin = lathe(
        [(0, 0), (0.0085, 0), (0.007, 0.003), (0, 0.0034)], 12, mat=metal("c3c7cb", "7a8086")
    )
    groups[0].append(pin.move(z=0.0125))
    titles = {"needle": "needle-nose pliers", "flat": "flat-nose pliers", "pincers": "pincers"}
    return lying(titles.get(kind, f"{kind} pliers"), groups, 0.22)


MODELS = {
    "hammer": maker(
        hammer,
        ("kind", "wooden", "colour", "grip", "head"),
        [
            ("claw", True, "#c8935a", "", ""),
            ("ball", True, "#b98552", "", ""),
            ("club", True, "#d0a060", "", "#2f5fa8"),
            ("mallet", True, "#c8935a", "", "#26282c"),
            ("pein", True, "#d8b078", "", "#26282c"),
            ("claw", False, "#b8bcc0", "#1f5fb0", ""),
            ("club", False, "#3a3f45", "#e8781c", "#26282c"),
        ],
    ),
    "pliers": maker(
        pliers,
        ("kind", "colour"),
        [
            ("combination", "#d8202c"),
            ("needle", "#1f5fb0"),
            ("flat", "#e8781c"),
            ("pump", "#c8202c"),
            ("pincers", "#1c1c20"),
            ("slip", "#f2c21e"),
            ("combination", "#2f8f4a"),
        ],
    ),
}
