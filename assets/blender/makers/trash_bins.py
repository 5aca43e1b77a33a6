"""Bins: open ones, and others with a lid on a joint; FULL shows rubbish that sticks out."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import Material, metal, plain, shade
from toolkit.model import (
    Container,
    Joint,
    Maker,
    Model,
    Part,
    Support,
    box_piece,
    cylinder_piece,
    ring_pieces,
    round_polygon,
)
from toolkit.sampling import noise_offset, pick
from toolkit.shapes import box, ellipsoid, extrude, lathe, loft, rounded_rectangle

from .decor import trash_bin as open_bin
from .forms import by_form
from .joinery import AJAR, Assembly, surface

Offset = tuple[float, float, float]


def _rubbish(half: tuple[float, float], z: float, x: float = 0.0, y: float = 0.0) -> Part:
    """A heap on a bag's bulge: a carton, crumpled paper, a can, a peel, up to 12 cm above z."""
    hx, hy = half
    bag = plain("#e6e7e4", 0.1, 25)
    heap = ellipsoid((hx, hy, 0.07), (x, y, z - 0.005), 8, 5, bag)
    rng = np.random.default_rng(5)
    heap.v = heap.v + rng.normal(0, 0.0045, heap.v.shape)
    meshes = [heap]
    carton = box(0.07, 0.07, 0.15, (0, 0, 0), plain("#3f7fb8", 0.05))
    meshes.append(carton.turn(rx=0.7, ry=0.3, rz=0.4).move(x - 0.3 * hx, y - 0.25 * hy, z + 0.02))
    for k, (a, b) in enumerate(((0.45, 0.3), (-0.1, 0.55))):
        paper = ellipsoid(
            0.036, (0, 0, 0), 6, 4, plain(("#f3f0e6", "#d9b98c", "#f6f5f0")[k], 0.08, 90)
        )
        paper.v = paper.v * (1 + rng.normal(0, 0.1, (len(paper.v), 1)))
        meshes.append(paper.flat().move(x + a * hx, y + b * hy, z + 0.065))
    tin = [(0, 0), (0.03, 0), (0.033, 0.006), (0.033, 0.1), (0.028, 0.104), (0, 0.104)]
    can = lathe(tin, 8, mat=plain("#c23a30", 0.05))
    meshes.append(can.turn(rx=1.1, rz=0.8).move(x + 0.25 * hx, y - 0.05 * hy, z + 0.06))
    peel = plain("#e8c93a", 0.1, 60)
    for a in (0.2, 2.1, 4.2):
        strip = box(0.075, 0.024, 0.007, (0.035, 0, 0), peel)
        strip.warp(lambda px, py, pz: (px, py, pz - 7 * px * px))
        meshes.append(strip.turn(rz=a).move(x - 0.15 * hx, y + 0.2 * hy, z + 0.1))
    piece = box_piece((x, y, z + 0.03), (1.2 * hx, 1.2 * hy, 0.13))
    return Part(meshes, collision=[piece])


def _filled(model: Model, half: tuple[float, float], z: float, lid: bool, x: float = 0.0) -> Model:
    """Adds the variant `full`; a lid is then propped open, as `lid_up`."""
    model.parts["rubbish"] = _rubbish(half, z, x)
    model.variants = {"default": ["body", "lid"] if lid else ["body"]}
    model.variants["full"] = ["body", "rubbish", "lid_up"] if lid else ["body", "rubbish"]
    model.states = [{"state": "FULL", "variants": ["full"], "parts": ["rubbish"]}]
    if lid:
        both = {"joint": "lid", "variants": ["default"], "parts": ["lid"]}
        model.states += [
            {"state": "CLOSED", "max": 0.03, **both},
            {"state": "OPEN", "min": AJAR, **both},
        ]
    return model


def open_round(
    height: float = 0.42,
    radius: float = 0.15,
    colour: str = "#5b6470",
    bag: bool = True,
    offset: Offset = (0, 0, 0),
) -> Model:
    """The plain open bin."""
    model = open_bin(height, radius, colour, bag, offset)
    model.title = f"open waste bin{' with a bag' if bag else ''}"
    return _filled(model, (radius * 0.9, radius * 0.9), height, False)


def _vessel(
    asm: Assembly, size: tuple, r: float, mats: tuple, taper: float = 0.0, wall: float = 0.01
) -> None:
    """A hollow bin of rounded rectangular plan on the floor; collides as floor and four walls."""
    sx, sy, h = size

    def ring(shrink: float, z: float) -> np.ndarray:
        s = shrink + taper * (1 - z / h)
        outline = rounded_rectangle(
            sx - 2 * s, sy - 2 * s, max(min(r, (min(sx, sy)) / 2 - 0.001) - s, 0.01), 4
        )
        return np.c_[outline, np.full(len(outline), z)]

    rings = [ring(0.006, 0), ring(0, 0.01), ring(0, h - 0.004), ring(0.002, h), ring(wall, h)]
    rings += [ring(wall, 0.03), ring(wall + 0.012, 0.02)]
    asm.add("body", loft(rings, mats=list(mats), mat_of_face=lambda k, i: 0 if k < 4 else 1))
    a, b = sx / 2, sy / 2
    asm.solid("body", (-a + taper, -b + taper, 0), (a - taper, b - taper, 0.02))
    asm.solid("body", (-a, -b, 0.02), (-a + wall + taper, b, h))
    asm.solid("body", (a - wall - taper, -b, 0.02), (a, b, h))
    asm.solid("body", (-a, -b, 0.02), (a, -b + wall + taper, h))
    asm.solid("body", (-a, b - wall - taper, 0.02), (a, b, h))


def _lidded(
    asm: Assembly, title: str, mass: float, size: tuple, joint: Joint, lid, angle: float, r: float
) -> Model:
    """The model of a bin whose lid hangs on `joint`; `lid`: its meshes when shut."""
    sx, sy, h = size
    points = np.concatenate([m.v for m in lid])
    low, high = points.min(0), points.max(0)
    hull = [box_piece((low + high) / 2, high - low)]
    up = [m.copy() for m in lid]
    for mesh in up:
        mesh.turn(ry=-angle, pivot=joint.origin)
    points = np.concatenate([m.v for m in up])
    low, high = points.min(0), points.max(0)
    parts = asm.parts()
    parts["lid"] = Part(lid, joint="lid", collision=hull)
    parts["lid_up"] = Part(up, collision=[box_piece((low + high) / 2, high - low)])
    inner = (0.5 * (sx - 0.05), 0.5 * (sy - 0.05))
    floor = surface("floor", (-inner[0], -inner[1]), inner, 0.02, None, "inside", margin=0.25 * r)
    space = Container(
        "inside", (0, 0, h / 2 + 0.01), (1.7 * inner[0], 1.7 * inner[1], h - 0.04), "body", "lid"
    )
    model = Model(
        title=title,
        parts=parts,
        mass=mass,
        joints={"lid": joint},
        supports=[floor],
        containers=[space],
        ground_shadow=True,
        texture_size=128,
    )
    return _filled(model, (inner[0] * 0.95, inner[1] * 0.95), h, True)


def pedal(
    height: float = 0.62, width: float = 0.3, colour: str = "steel", offset: Offset = (0, 0, 0)
) -> Model:
    """A round pedal bin with a domed lid."""
    asm = Assembly()
    shell = (
        metal("c4c8cc", "7f858b", (1, 1, 6), 14)
        if colour == "steel"
        else plain(colour, 0.02, 10, offset)
    )
    dark, inner = plain("#232528", 0.03), plain("#5b6066", 0.05)
    r, h = width / 2, height * 0.86
    _vessel(asm, (width, width, h), r, (shell, inner))
    ring = ring_pieces([(r, 0.0), (r, h)], [(r - 0.012, 0.0), (r - 0.012, h)], 10)
    asm.pieces["body"] = [*ring, cylinder_piece(r, 0, 0.02)]
    foot = [(0, 0), (r + 0.004, 0), (r + 0.004, 0.03), (0, 0.03)]
    asm.add(
        "body", lathe([*foot[1:3], (r - 0.01, 0.031), (r - 0.01, 0.001), foot[1]], 16, mat=dark)
    )
    asm.add("body", box(0.06, 0.1, 0.014, (r + 0.018, 0, 0.012), dark, 0.004), solid=True)
    asm.board("body", (-r - 0.016, -0.06, h - 0.09), (-r + 0.01, 0.06, h + 0.004), dark, 0.004)
    dome = [(0, h + 0.004), (r + 0.004, h + 0.004), (r + 0.004, h + 0.02)]
    rise = height - h - 0.02
    for a in (0.35, 0.75, 1.15):
        dome.append((r * math.cos(a), h + 0.02 + rise * math.sin(a)))
    dome.append((0, height))
    rim = lathe(dome, 16, mats=[inner, dark, shell], mat_of_segment=[0, 1, 2, 2, 2, 2])
    joint = Joint("revolute", (-r - 0.006, 0, h + 0.004), (0, -1, 0), 0.0, 1.45)
    tone = "steel" if colour == "steel" else "coloured"
    return _lidded(asm, f"{tone} pedal bin", 2.8, (width, width, h), joint, [rim], 0.8, 0.4 * width)


def kitchen_bin(
    colour: str = "#3a3e43",
    lid: str = "#5f8f4f",
    height: float = 0.64,
    slim: bool = False,
    offset: Offset = (0, 0, 0),
) -> Model:
    """A rectangular kitchen bin with a flat, coloured lid."""
    asm = Assembly()
    sx, sy = (0.4, 0.22) if slim else (0.33, 0.4)
    h = height - 0.045
    shell, top = plain(colour, 0.03, 14, offset), plain(lid, 0.03, 14, offset)
    _vessel(asm, (sx, sy, h), 0.04, (shell, plain(shade(colour, 0.7), 0.04)), 0.014)
    rim = rounded_rectangle(sx + 0.012, sy + 0.012, 0.045, 4)
    crown = rounded_rectangle(sx - 0.03, sy - 0.03, 0.035, 4)
    rings = [
        np.c_[o, np.full(len(o), z)]
        for o, z in ((rim, h + 0.002), (rim, h + 0.03), (crown, height))
    ]
    cap = loft(rings, top)
    grip = box(0.02, 0.1, 0.016, (sx / 2 + 0.01, 0, h + 0.008), top, 0.004)
    joint = Joint("revolute", (-sx / 2 - 0.006, 0, h + 0.002), (0, -1, 0), 0.0, 1.5)
    mark = Material()
    ring = mark.remap(mark.distance((sx / 2, 0, 0.55 * h), (0, 1, 1)), 0.028, 0.034)
    core = mark.remap(mark.distance((sx / 2, 0, 0.55 * h), (0, 1, 1)), 0.05, 0.055)
    mark.colour(mark.mix(core, mark.mix(ring, colour, lid), colour))
    asm.board(
        "body",
        (sx / 2 - 0.012, -0.06, 0.55 * h - 0.06),
        (sx / 2 + 0.002, 0.06, 0.55 * h + 0.06),
        mark,
        solid=False,
        weight=1.5,
    )
    return _lidded(
        asm,
        f"{'slim ' if slim else ''}kitchen bin with a flat lid",
        2.2,
        (sx, sy, h),
        joint,
        [cap, grip],
        0.75,
        0.04,
    )


def swing(
    colour: str = "#d9d6cf", hood: str = "#4a4f55", height: float = 0.68, offset: Offset = (0, 0, 0)
) -> Model:
    """A bin under a hood, whose front flap swings open."""
    asm, sx, sy = Assembly(), 0.3, 0.36
    h = height * 0.68
    shell, cover = plain(colour, 0.03, 14, offset), plain(hood, 0.03, 14, offset)
    _vessel(asm, (sx, sy, h), 0.05, (shell, plain(shade(colour, 0.7), 0.04)), 0.016)
    # the hood: two cheeks, a back and a top, with the flap between them in front
    a, b, t = sx / 2, sy / 2, 0.012
    side = [(-a, h), (a, h), (a - 0.03, h + 0.05), (0.03, height), (-0.07, height), (-a, h + 0.06)]
    for s in (-1, 1):
        cheek = extrude(side, t, mat=cover, axis="y", bevel_width=0.003)
        asm.add("body", cheek.move(0, s * (b - t / 2), 0), solid=True)
    asm.board("body", (-a, -b + t, h), (-a + t, b - t, h + 0.06), cover)
    back = [
        (-a, h + 0.05),
        (-a + t, h + 0.05),
        (-0.06, height - t),
        (0.03, height - t),
        (0.03, height),
        (-0.07, height),
    ]
    asm.add("body", extrude(back, sy - 2 * t, mat=cover, axis="y"), solid=False)
    asm.piece("body", np.array([(x, y, z) for x, z in back for y in (-b, b)]))
    flap_o = [
        (0.032, height - 0.002),
        (a - 0.028, h + 0.052),
        (a - 0.002, h + 0.002),
        (a - 0.014, h + 0.002),
        (a - 0.04, h + 0.05),
        (0.022, height - 0.008),
    ]
    flap = extrude(flap_o, sy - 2 * t - 0.004, mat=plain(shade(hood, 1.25), 0.03, 14), axis="y")
    joint = Joint("revolute", (0.03, 0, height - 0.002), (0, -1, 0), 0.0, 1.2)
    word = box(0.004, 0.1, 0.03, (a - 0.002, 0, h - 0.12), cover)
    asm.add("body", word)
    model = _lidded(asm, "swing-top bin", 2.0, (sx, sy, h), joint, [flap], 0.9, 0.05)
    return model


def wire(colour: str = "#26282b", offset: Offset = (0, 0, 0)) -> Model:
    """A waste-paper basket of mesh."""
    asm, r, h = Assembly(), 0.145, 0.33
    m = Material()
    cells = m.remap(m.voronoi(75, randomness=0.0), 0.22, 0.34)
    m.colour(m.mix(cells, shade(colour, 1.0), "#8d8a84"))
    rim = plain(colour, 0.04)
    outer = [(0, 0), (0.105, 0), (0.108, 0.012), (r, h), (r - 0.008, h), (0.1, 0.016), (0, 0.014)]
    asm.add("body", lathe(outer, 20, mats=[m, rim], mat_of_segment=[1, 1, 0, 1, 0, 0]))
    for z, q in ((h, r), (0.012, 0.108)):
        hoop = [
            (q - 0.006, z - 0.006),
            (q + 0.005, z - 0.006),
            (q + 0.005, z + 0.006),
            (q - 0.006, z + 0.006),
        ]
        asm.add("body", lathe([*hoop, hoop[0]], 20, mat=rim, discs=False))
    for piece in ring_pieces([(0.105, 0.0), (r, h)], [(0.095, 0.0), (r - 0.01, h)], 10):
        asm.piece("body", piece)
    asm.piece("body", cylinder_piece(0.105, 0, 0.014))
    model = Model(
        title="waste-paper basket of wire mesh",
        parts=asm.parts(),
        mass=0.8,
        supports=[Support("floor", 0.014, round_polygon(0.085, 12), "body", None, "inside")],
        containers=[Container("inside", (0, 0, h / 2), (0.14, 0.14, h - 0.02))],
        ground_shadow=True,
        texture_size=128,
    )
    return _filled(model, (0.13, 0.13), h, False)


FORMS = {"open": open_round, "pedal": pedal, "kitchen": kitchen_bin, "swing": swing, "wire": wire}


def trash_bin_random(rng: np.random.Generator) -> dict:
    """Parameters of a random bin."""
    return {
        "form": "open",
        "height": round(float(rng.uniform(0.34, 0.48)), 2),
        "radius": round(float(rng.uniform(0.13, 0.17)), 3),
        "colour": pick(rng, ["#5b6470", "#b9bdc0", "#3f6b52", "#d9d6cf"]),
        "bag": bool(rng.random() < 0.5),
        "offset": noise_offset(rng),
    }


MODELS = {
    "trash_bin": Maker(
        by_form("trash_bin", FORMS),
        trash_bin_random,
        8,
        [
            {"colour": "#5b6470", "bag": True},
            {"colour": "#b9bdc0", "bag": False},
            {"form": "pedal", "colour": "steel", "height": 0.62, "width": 0.3},
            {"form": "pedal", "colour": "#e9e7e2", "height": 0.33, "width": 0.21},
            {"form": "kitchen", "colour": "#3a3e43", "lid": "#5f8f4f", "height": 0.64},
            {"form": "kitchen", "colour": "#b4b8bb", "lid": "#3f6fa8", "height": 0.6, "slim": True},
            {"form": "swing", "colour": "#d9d6cf", "hood": "#4a4f55", "height": 0.68},
            {"form": "wire", "colour": "#26282b"},
        ],
    ),
}
