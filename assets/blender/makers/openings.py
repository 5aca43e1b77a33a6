"""Doors: they fill holes cut through walls 0.12 m thick, exactly.

The frame is centred on the wall; doors open into the room (+X) and hang on the right (+Y).
Handles stick out equally on both sides, so that the origin stays in the middle of the wall.
"""

from __future__ import annotations

import math

import numpy as np
from PIL import Image
from toolkit import labels
from toolkit.materials import Material, label, metal, plain, shade
from toolkit.model import Joint, Maker, Model
from toolkit.sampling import noise_offset, pick
from toolkit.shapes import lathe, tube

from .door_styles import glaze, grooved, louvre, planks
from .joinery import AJAR, Assembly, finish, open_closed, steel

Offset = tuple[float, float, float]
WALL = 0.12
LEAF = 0.044
# The hinge line lies on the wall's face, in front of the leaf: so the leaf clears its frame.
PIVOT_X = 0.062
HANDLE_REACH = 0.052


def _frame(
    asm: Assembly, width: float, height: float, jamb: float, mat: Material, sill: bool
) -> None:
    """Jambs and head as thick as the wall, with a stop behind the leaf."""
    half, x = width / 2, WALL / 2
    inner = half - jamb
    for low, high in (
        ((-x, -half, 0), (x, -inner, height)),
        ((-x, inner, 0), (x, half, height)),
        ((-x, -inner, height - jamb), (x, inner, height)),
    ):
        asm.board("body", low, high, mat)
    stop = 0.014
    x0, x1 = -LEAF / 2 - 0.022, -LEAF / 2 - 0.002
    for low, high in (
        ((x0, -inner, 0), (x1, -inner + stop, height - jamb)),
        ((x0, inner - stop, 0), (x1, inner, height - jamb)),
        ((x0, -inner + stop, height - jamb - stop), (x1, inner - stop, height - jamb)),
    ):
        asm.board("body", low, high, mat)
    if sill:
        asm.board("body", (-x, -inner, 0), (x, inner, 0.018), steel(10))


def _panels(
    asm: Assembly,
    z0: float,
    layout: list[tuple[float, float, float, float]],
    mat: Material,
    groove: Material,
) -> None:
    """Raised panels in a dark groove on both faces of the leaf; layout: (y0, z0, y1, z1)."""
    for face in (-1, 1):
        x = face * LEAF / 2
        for ya, za, yb, zb in layout:
            for grow, rise, m, bevel in ((0.0, 0.003, groove, 0.0), (-0.014, 0.01, mat, 0.006)):
                a, b = sorted((x - face * 0.004, x + face * rise))
                low, high = (a, ya - grow, z0 + za - grow), (b, yb + grow, z0 + zb + grow)
                asm.board("door", low, high, m, bevel, solid=False)


def _lever(
    asm: Assembly, y: float, z: float, towards: int, mat: Material, plate: float = 0.2
) -> None:
    """A lever handle on a long plate, the same on both faces."""
    for face in (-1, 1):
        x = face * LEAF / 2
        a, b = sorted((x, x + face * 0.008))
        asm.board(
            "door",
            (a, y - 0.02, z - plate * 0.62),
            (b, y + 0.02, z + plate * 0.38),
            mat,
            0.003,
            solid=False,
        )
        end = LEAF / 2 + HANDLE_REACH - 0.0095
        path = [
            (x, y, z),
            (face * end, y, z),
            (face * end, y + towards * 0.03, z),
            (face * end, y + towards * 0.12, z - 0.004),
        ]
        asm.add("door", tube(path, 0.0095, 6, mat=mat))
        hole = lathe([(0, 0), (0.009, 0), (0.008, 0.004), (0, 0.004)], 10, mat=plain("#2a2a2a", 0))
        hole.turn(ry=face * math.pi / 2).move(x + face * 0.007, y, z - plate * 0.4)
        asm.add("door", hole)
    asm.solid(
        "door",
        (-LEAF / 2 - HANDLE_REACH, min(y, y + towards * 0.12), z - 0.01),
        (-LEAF / 2, max(y, y + towards * 0.12), z + 0.01),
    )
    asm.solid(
        "door",
        (LEAF / 2, min(y, y + towards * 0.12), z - 0.01),
        (LEAF / 2 + HANDLE_REACH, max(y, y + towards * 0.12), z + 0.01),
    )


def _hinges(asm: Assembly, y: float, heights: list[float], mat: Material) -> None:
    """Knuckles on the hinge line."""
    for z in heights:
        barrel = lathe([(0, z), (0.007, z), (0.007, z + 0.09), (0, z + 0.09)], 8, mat=mat)
        asm.add("body", barrel.move(WALL / 2 - 0.008, y - 0.006, 0))


def front_door(
    colour: str = "#7a2e2a",
    frame: str = "#efece5",
    style: str = "six",
    brass: bool = True,
    number: str = "12",
    offset: Offset = (0, 0, 0),
) -> Model:
    """The entrance: a panelled leaf with letterbox, peephole, lock and house number.

    style: "six" panels, "glazed" with a row of small panes near the top, "half" glass, "planks"
    with iron straps, or "modern" with grooves and a strip of glass.
    """
    # The leaf swings over a doormat.
    asm, width, height, jamb, floor = Assembly(), 1.0, 2.1, 0.047, 0.022
    paint, groove = plain(colour, 0.025, 5, offset), plain(shade(colour, 0.62), 0.03, 5)
    _frame(asm, width, height, jamb, plain(frame, 0.015, 5), True)
    y0, y1, z1 = -width / 2 + jamb + 0.003, width / 2 - jamb - 0.003, height - jamb - 0.003
    asm.board("door", (-LEAF / 2, y0, floor), (LEAF / 2, y1, z1), paint, 0.003)
    fitting = metal("d8ac4e", "8f6a26", (1, 1, 6), 40) if brass else steel(30)
    a, b = 0.34, 0.04
    y_span, layout = (y0, floor, y1, z1), []
    if style == "half":
        glaze(asm, (-0.31, 1.12, 0.31, 1.92), (3, 3), paint)
        layout = [(-a, 0.16, a, 0.72)]
    elif style == "planks":
        iron = plain("#2b2c2e", 0.06, 30)
        planks(asm, y_span, 7, paint, groove, "straps", iron)
        glaze(asm, (-0.12, 1.62, 0.12, 1.86), (1, 1), iron)
    elif style == "modern":
        grooved(asm, y_span, 6, colour)
        glaze(asm, (0.16, 0.3, 0.3, 1.9), (1, 1), plain("#b9bec2", 0.03), True)
    elif style == "six":
        rows = [(0.16, 0.72), (1.1, 1.5), (1.58, 1.9)]
        layout = [(y, za, y + a - b, zb) for za, zb in rows for y in (-a, b)]
    else:
        layout = [(y, za, y + a - b, zb) for za, zb in [(0.16, 0.72), (1.1, 1.44)] for y in (-a, b)]
        glass = Material(occlusion=0.3)
        sky = glass.remap(glass.axis(2), 1.55, 1.9)
        glass.colour(glass.ramp(sky, [(0, "#9fb7bd"), (0.5, "#c4d8de"), (1, "#dcebf0")]))
        for k in range(4):
            y = -0.34 + k * 0.175
            low, high = (-LEAF / 2 - 0.002, y, 1.6), (LEAF / 2 + 0.002, y + 0.15, 1.9)
            asm.board("door", low, high, glass, solid=False)
            for ya, yb, za, zb in (
                (y - 0.012, y + 0.004, 1.588, 1.912),
                (y + 0.146, y + 0.162, 1.588, 1.912),
                (y + 0.004, y + 0.146, 1.588, 1.604),
                (y + 0.004, y + 0.146, 1.896, 1.912),
            ):
                asm.board(
                    "door",
                    (-LEAF / 2 - 0.008, ya, za),
                    (LEAF / 2 + 0.008, yb, zb),
                    paint,
                    solid=False,
                )
    _panels(asm, floor, layout, paint, groove)
    _lever(asm, y0 + 0.055, 1.02, 1, fitting)
    for face in (-1, 1):
        x = face * LEAF / 2
        # A letter plate as wide as two hands, far below the handle, its flap as the plate; the lock
        # is a round cylinder over the handle, flush: nobody is to take it for a second one.
        lo, hi = sorted((x, x + face * 0.006))
        slot_z = 0.76
        plate = ((lo, -0.12, slot_z), (hi, 0.12, slot_z + 0.07))
        asm.board("door", *plate, fitting, 0.002, solid=False)
        lo, hi = sorted((x + face * 0.005, x + face * 0.009))
        flap = ((lo, -0.1, slot_z + 0.02), (hi, 0.1, slot_z + 0.05))
        asm.board("door", *flap, plain("#2a2b2d", 0.02), 0.0, solid=False)
        bolt = lathe([(0, 0), (0.02, 0), (0.018, 0.005), (0, 0.006)], 16, mat=fitting)
        asm.add("door", bolt.turn(ry=face * math.pi / 2).move(x, y0 + 0.055, 1.2))
        ring = lathe(
            [(0, 0), (0.016, 0), (0.014, 0.006), (0.007, 0.006), (0, 0.004)],
            14,
            mats=[fitting, plain("#101214", 0)],
            mat_of_segment=[0, 0, 0, 1],
        )
        asm.add(
            "door",
            ring.turn(ry=face * math.pi / 2).move(
                x, 0, 1.0 if style == "half" else 1.54 if style == "six" else 1.5
            ),
        )
    plate = _number_plate(number)
    low_z = {"half": 0.96, "planks": 1.4}.get(style, 1.7)
    asm.board(
        "door",
        (-LEAF / 2 - 0.006, -0.06, low_z),
        (-LEAF / 2, 0.06, low_z + 0.1),
        fitting,
        0,
        {"-x": label(plate)},
        1.5,
        solid=False,
    )
    _hinges(asm, width / 2 - jamb, [0.25, 1.0, 1.75], fitting)
    return _door_model(
        asm,
        f"front door with {FRONTS[style]}",
        width,
        jamb,
        42.0,
        0.02,
        AJAR,
    )


FRONTS = {
    "six": "panels",
    "glazed": "small panes",
    "half": "a window",
    "planks": "iron straps",
    "modern": "a strip of glass",
}


def _number_plate(number: str) -> Image.Image:
    picture, draw = labels.canvas(96, 80, "#1f2b3a")
    labels.text(draw, number, (12, 10, 84, 70), "serif", "#f2ead2")
    return picture


def _door_model(
    asm: Assembly, title: str, width: float, jamb: float, mass: float, closed: float, opened: float
) -> Model:
    joint = Joint("revolute", (PIVOT_X, width / 2 - jamb, 0.0), (0, 0, 1), 0.0, 1.9)
    return Model(
        title=title,
        parts=asm.parts(door={"joint": "door"}),
        mass=mass,
        joints={"door": joint},
        states=open_closed("door", "door", closed, opened),
    )


def front_door_random(rng: np.random.Generator) -> dict:
    """Parameters of a random front door."""
    return {
        "colour": pick(rng, ["#7a2e2a", "#2f4f45", "#33475e", "#6b4527"]),
        "style": pick(rng, ["six", "glazed"]),
        "brass": bool(rng.random() < 0.6),
        "number": str(int(rng.integers(2, 60))),
        "offset": noise_offset(rng),
    }


def casing(
    wide: bool = False,
    colour: str = "#f1efea",
    jamb: float = 0.035,
    bead: bool = False,
    offset: Offset = (0, 0, 0),
) -> Model:
    """What lines a passage without a door: jambs and head as thick as the wall; bead: a strip
    along the middle."""
    asm, (width, height) = Assembly(), (2.2, 2.2) if wide else (1.0, 2.1)
    mat, half, x = finish(colour, 2, offset), width / 2, WALL / 2
    inner, top = half - jamb, height - jamb
    for low, high in (
        ((-x, -half, 0), (x, -inner, height)),
        ((-x, inner, 0), (x, half, height)),
        ((-x, -inner, top), (x, inner, height)),
    ):
        asm.board("body", low, high, mat, 0.003)
    if bead:
        b = 0.012
        for low, high in (
            ((-0.02, -inner, 0), (0.02, -inner + b, top)),
            ((-0.02, inner - b, 0), (0.02, inner, top)),
            ((-0.02, -inner + b, top - b), (0.02, inner - b, top)),
        ):
            asm.board("body", low, high, mat, 0.003)
    title = "wide passage, lined" if wide else "passage, lined"
    return Model(title=title, parts=asm.parts(), mass=18.0 if wide else 10.0)


def casing_random(rng: np.random.Generator) -> dict:
    """Parameters of a random casing."""
    return dict(pick(rng, CASINGS), offset=noise_offset(rng))


#: To the inner doors of the same number.
CASINGS = [
    {"colour": "#f1efea", "bead": True},
    {"colour": "oak"},
    {"colour": "#f1efea", "jamb": 0.045, "bead": True},
    {"colour": "oak", "jamb": 0.05},
    {"colour": "#d9dcd8"},
    {"colour": "#e8e4da", "bead": True},
    {"colour": "walnut", "bead": True},
    {"colour": "#f1efea", "jamb": 0.025},
    {"colour": "#c4c8c6", "jamb": 0.025},
    {"colour": "#f1efea", "jamb": 0.05},
]
#: Double doors, likewise.
DOUBLE_DOORS = [
    {"colour": "#f1efea", "style": "panels"},
    {"colour": "oak", "style": "flush"},
    {"colour": "#f1efea", "style": "glazed"},
    {"colour": "oak", "style": "panels"},
    {"colour": "#d9dcd8", "style": "glazed"},
    {"colour": "#e8e4da", "style": "glazed"},
    {"colour": "walnut", "style": "panels"},
    {"colour": "#f1efea", "style": "flush"},
    {"colour": "#c4c8c6", "style": "glazed"},
    {"colour": "#f1efea", "style": "glazed", "panes": 6},
]


def double_door(
    colour: str = "#f1efea", style: str = "glazed", panes: int = 4, offset: Offset = (0, 0, 0)
) -> Model:
    """An interior double door; style: "glazed" down to a panel, "panels" or "flush"."""
    asm, width, height, jamb, floor = Assembly(), 1.6, 2.1, 0.04, 0.006
    wood = not colour.startswith("#")
    paint = finish(colour, 2, offset)
    groove = plain("#6d4a2a" if wood else shade(colour, 0.78), 0.03, 5)
    _frame(asm, width, height, jamb, paint, False)
    top = height - jamb - 0.003
    for part, y0, y1 in (
        ("door", 0.0015, width / 2 - jamb - 0.003),
        ("left_door", -width / 2 + jamb + 0.003, -0.0015),
    ):
        leaf = Assembly()
        leaf.board("door", (-LEAF / 2, y0, floor), (LEAF / 2, y1, top), paint, 0.003)
        a, b = y0 + 0.1, y1 - 0.1
        if style == "glazed":
            glaze(leaf, (a, 0.72, b, top - 0.14), (2, panes), paint)
            _panels(leaf, 0.0, [(a, 0.18, b, 0.58)], paint, groove)
        elif style == "panels":
            _panels(leaf, 0.0, [(a, 0.18, b, 0.86), (a, 1.12, b, 1.88)], paint, groove)
        handle, towards = (y0 + 0.06, 1) if part == "door" else (y1 - 0.06, -1)
        _lever(leaf, handle, 1.03, towards, steel(30), 0.18)
        for mesh in leaf.meshes["door"]:
            asm.add(part, mesh)
        for piece in leaf.pieces["door"]:
            asm.piece(part, piece)
    for side in (-1, 1):
        for z in (0.25, 1.75):
            barrel = lathe([(0, z), (0.007, z), (0.007, z + 0.09), (0, z + 0.09)], 8, mat=steel(30))
            hinge = side * (width / 2 - jamb - 0.006)
            asm.add("body", barrel.move(WALL / 2 - 0.008, hinge, 0))
    inner = width / 2 - jamb
    return Model(
        title={"glazed": "glazed double door", "panels": "panelled double door"}.get(
            style, "flush double door"
        ),
        parts=asm.parts(door={"joint": "door"}, left_door={"joint": "left_door"}),
        mass=36.0,
        joints={
            "door": Joint("revolute", (PIVOT_X, inner, 0.0), (0, 0, 1), 0.0, 1.9),
            "left_door": Joint("revolute", (PIVOT_X, -inner, 0.0), (0, 0, -1), 0.0, 1.9),
        },
        states=open_closed("door", "door", 0.02, AJAR)
        + open_closed("left_door", "left_door", 0.02, AJAR),
    )


def double_door_random(rng: np.random.Generator) -> dict:
    """Parameters of a random double door."""
    return dict(pick(rng, DOUBLE_DOORS), offset=noise_offset(rng))


def door(
    colour: str = "#f1efea", panels: int = 2, style: str = "panels", offset: Offset = (0, 0, 0)
) -> Model:
    """An interior door; style: "panels" (0: flush), "glazed", "half" glazed, "louvre", "barn"."""
    asm, width, height, jamb, floor = Assembly(), 0.9, 2.1, 0.04, 0.006
    wood = not colour.startswith("#")
    paint = finish(colour, 2, offset)
    groove = plain("#6d4a2a" if wood else shade(colour, 0.78), 0.03, 5)
    _frame(asm, width, height, jamb, finish("#f1efea" if not wood else colour, 2, offset), False)
    y0, y1, z1 = -width / 2 + jamb + 0.003, width / 2 - jamb - 0.003, height - jamb - 0.003
    asm.board("door", (-LEAF / 2, y0, floor), (LEAF / 2, y1, z1), paint, 0.003)
    low, high = floor + 0.14, z1 - 0.14
    if style == "glazed":
        glaze(asm, (-0.3, 0.24, 0.3, high), (2, 5), paint)
    elif style == "half":
        glaze(asm, (-0.27, 1.12, 0.27, high), (1, 1), paint, True)
        _panels(asm, 0.0, [(-0.27, 0.18, 0.27, 0.86)], paint, groove)
    elif style == "louvre":
        for z in ((low, 0.96), (1.1, high)):
            louvre(asm, (-0.3, z[0], 0.3, z[1]), 11, paint, groove)
    elif style == "barn":
        planks(asm, (y0, floor, y1, z1), 6, paint, groove, "z")
    elif panels:
        rows = {
            2: [(0.18, 0.86), (1.12, 1.88)],
            1: [(0.18, 1.88)],
            4: [(0.18, 0.86), (1.12, 1.88)],
        }[panels]
        spans = [(-0.27, 0.27)] if panels < 4 else [(-0.28, -0.03), (0.03, 0.28)]
        layout = [(a, za, b, zb) for za, zb in rows for a, b in spans]
        _panels(asm, 0.0, layout, paint, groove)
    _lever(asm, y0 + 0.06, 1.03, 1, steel(30), 0.18)
    _hinges(asm, width / 2 - jamb, [0.25, 1.75], steel(30))
    kinds = {
        "panels": f"interior door, {panels} panels" if panels else "flush interior door",
        "glazed": "interior door with glass panes",
        "half": "interior door, half glazed",
        "louvre": "louvred interior door",
        "barn": "plank door with a Z brace",
    }
    return _door_model(asm, kinds[style], width, jamb, 24.0, 0.02, AJAR)


def door_random(rng: np.random.Generator) -> dict:
    """Parameters of a random interior door."""
    return {
        "colour": pick(rng, ["#f1efea", "#f1efea", "oak", "#d9dcd8"]),
        "panels": pick(rng, [0, 1, 2, 4]),
        "offset": noise_offset(rng),
    }


MODELS = {
    "front_door": Maker(
        front_door,
        front_door_random,
        7,
        [
            {"colour": "#7a2e2a", "style": "six", "brass": True},
            {"colour": "#2f4f45", "style": "glazed", "brass": False},
            {"colour": "#33475e", "style": "six", "brass": False},
            {"colour": "#efece5", "style": "half", "brass": True},
            {"colour": "#6b4527", "style": "planks", "brass": False},
            {"colour": "#3c4044", "style": "modern", "brass": False},
            {"colour": "#5d7f8c", "style": "half", "brass": False},
        ],
    ),
    "passage": Maker(casing, casing_random, 10, CASINGS),
    "wide_passage": Maker(casing, casing_random, 10, [{"wide": True, **c} for c in CASINGS]),
    "double_door": Maker(double_door, double_door_random, 10, DOUBLE_DOORS),
    "door": Maker(
        door,
        door_random,
        10,
        [
            {"colour": "#f1efea", "panels": 2},
            {"colour": "oak", "panels": 0},
            {"colour": "#f1efea", "style": "glazed"},
            {"colour": "oak", "style": "barn"},
            {"colour": "#d9dcd8", "style": "louvre"},
            {"colour": "#e8e4da", "style": "half"},
            {"colour": "walnut", "panels": 4},
            {"colour": "#f1efea", "panels": 0},
            {"colour": "#c4c8c6", "panels": 0},
            {"colour": "#f1efea", "panels": 4},
        ],
    ),
}
