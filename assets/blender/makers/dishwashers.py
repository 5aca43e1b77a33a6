"""Dishwashers: built in with a kitchen front, free-standing, slim, and for the worktop."""

from __future__ import annotations

import numpy as np
from PIL import ImageDraw
from toolkit import labels
from toolkit.materials import Material, label, metal, plain
from toolkit.model import Container, Joint, Maker, Model
from toolkit.sampling import noise_offset, pick
from toolkit.shapes import box, lathe, tube

from .casework import metal_or
from .joinery import Assembly, bar_handle, finish, front, open_closed, steel, surface
from .kitchen_suites import (
    DOOR,
    DOOR_FRONT,
    FIRST,
    FURTHER,
    REACH,
    STYLES,
    SUITES,
    TOP_FRONT,
    Offset,
    leaf,
    named,
    slab,
    worktop_material,
)

LINER = (1.2, 1.2, 1.22, 1.0)


def _plate_sign(draw: ImageDraw.ImageDraw, x: float, y: float, r: float, ink: str) -> None:
    """A plate under a spray of water: what the machine does."""
    draw.ellipse((x - r, y - r, x + r, y + r), outline=ink, width=3)
    draw.ellipse((x - 0.55 * r, y - 0.55 * r, x + 0.55 * r, y + 0.55 * r), outline=ink, width=2)
    for k in (-1, 0, 1):
        draw.line((x + r * 1.3, y + k * 8, x + r * 1.3 + 9, y + k * 11), fill=ink, width=3)


def _controls(width: int, ground: str, ink: str) -> Material:
    picture, draw = labels.canvas(width, 56, ground)
    _plate_sign(draw, 32, 28, 18, ink)
    labels.text(draw, "DISHWASHER", (76, 14, width * 0.55, 42), "bold", ink)
    draw.rectangle((width * 0.6, 12, width * 0.73, 44), fill="#0d1517")
    labels.text(draw, "2:10", (width * 0.61, 14, width * 0.72, 42), "bold", "#7fe3d0")
    for k in range(4):
        x = width * (0.77 + 0.055 * k)
        draw.ellipse((x, 20, x + 15, 35), outline=ink, width=3)
    return label(picture)


def _rack(asm: Assembly, x: tuple, y: tuple, z: float, mat: Material, tines: bool) -> None:
    """A wire basket, with rows of tines for plates."""
    (x0, x1), (y0, y1), tall = x, y, 0.085
    for height in (z, z + tall):
        ring = [(x0, y0, height), (x1, y0, height), (x1, y1, height), (x0, y1, height)]
        asm.add("interior", tube(ring, 0.0045, 4, closed=True, mat=mat))
    grid = Material()
    cells = grid.remap(grid.voronoi(40, randomness=0.0), 0.25, 0.4)
    grid.colour(grid.mix(cells, "#59626a", "#c5cdd3"))
    asm.board("interior", (x0, y0, z - 0.004), (x1, y1, z + 0.004), grid)
    for t in np.linspace(0, 1, 7):
        yy = y0 + (y1 - y0) * t
        for xx in (x0, x1):
            asm.add("interior", tube([(xx, yy, z), (xx, yy, z + tall)], 0.0035, 4, mat=mat))
    if tines:
        for xx in np.linspace(x0 + 0.06, x1 - 0.06, 5):
            for yy in (y0 + (y1 - y0) * 0.3, y0 + (y1 - y0) * 0.7):
                wire = [(xx, yy, z), (xx, yy, z + 0.075)]
                asm.add("interior", tube(wire, 0.0035, 3, mat=mat))


def dishwasher(
    suite: str | None = None,
    colour: str = "#f3f4f3",
    width: float = 0.6,
    height: float = 0.85,
    racks: int = 2,
    depth: float = 0.56,
    offset: Offset = (0, 0, 0),
) -> Model:
    """suite: a kitchen front and worktop at 0.90 m; None: a free-standing one in `colour`."""
    asm, half = Assembly(), width / 2
    look = SUITES[suite] if suite else None
    shell = finish(look["front"], 2, offset) if look else _paint(colour, offset)
    plinth, wall, thick = (0.1 if racks > 1 else 0.03), 0.03, 0.035
    x0, x1 = -0.3, -0.3 + depth
    if look:
        height, x1 = 0.86, DOOR_FRONT - thick
    z0, z1 = plinth, height - 0.03
    dark = plain(look["plinth"] if look else "#2d2f31", 0.04, 8)
    asm.board("body", (x0, -half + 0.01, 0), (x1 - 0.03, half - 0.01, plinth), dark)
    for a in (-half, half - wall):
        asm.board("body", (x0, a, z0), (x1, a + wall, height - 0.02), shell, 0.001)
    asm.board("body", (x0, -half + wall, z0), (x1, half - wall, z0 + wall), shell)
    asm.board("body", (x0, -half + wall, z0 + wall), (x0 + wall, half - wall, z1), shell)
    asm.board("body", (x0, -half + wall, z1 - wall), (x1, half - wall, height - 0.02), shell)
    if look:
        asm.board("body", (x0, -half, height - 0.02), (x1, half, height), dark)
        slab(asm, (x0, TOP_FRONT), (-half, half), worktop_material(look, offset))
        top = 0.9
    else:
        low, high = (x0, -half, height - 0.02), (x1 + thick - 0.005, half, height)
        asm.board("body", low, high, shell, 0.005, segments=2)
        top = height
    # the tub: bright steel sheets of their own
    tub = metal("d3d7da", "9aa1a7", (1, 1, 6), 14)
    t, ya, yb, za, zb = 0.004, -half + wall, half - wall, z0 + wall, z1 - wall
    for a, b in (
        ((x0 + wall, ya, za), (x0 + wall + t, yb, zb)),
        ((x0 + wall, ya, za), (x1 - 0.002, ya + t, zb)),
        ((x0 + wall, yb - t, za), (x1 - 0.002, yb, zb)),
        ((x0 + wall, ya, za), (x1 - 0.002, yb, za + t)),
        ((x0 + wall, ya, zb - t), (x1 - 0.002, yb, zb)),
    ):
        asm.board("interior", a, b, tub, solid=False)
    wire, arm_mat = plain("#c5cdd3", 0.03), plain("#8a9299", 0.03)
    rx, ry = (x0 + wall + 0.02, x1 - 0.03), (ya + 0.02, yb - 0.02)
    step = (zb - za - 0.06) / racks
    supports, containers = [surface("top", (x0, -half), (x1, half), top)], []
    for k in range(racks):
        z = za + 0.055 + k * step
        _rack(asm, rx, ry, z, wire, k == 0)
        middle = (rx[0] + rx[1]) / 2
        arm = box(0.045, 0.7 * (ry[1] - ry[0]), 0.014, (middle, 0, z - 0.04), arm_mat, 0.004)
        asm.add("interior", arm)
        name = ("rack_lower", "rack_upper")[k]
        supports.append(
            surface(
                name, (rx[0], ry[0]), (rx[1], ry[1]), z + 0.004, step - 0.06, "inside", margin=0.02
            )
        )
    size = (rx[1] - rx[0], ry[1] - ry[0], zb - za - 0.01)
    center = (sum(rx) / 2, 0.0, (za + zb) / 2)
    containers.append(Container("inside", center, size, "body", "door"))
    # the door: a leaf with the control strip above the front
    outer, strip = x1 + thick, height - 0.115
    door_low, y = plinth + 0.004, (-half + 0.003, half - 0.003)
    panel_ink = ("#2c2f31", "#e6e8ea") if look or colour != "#f3f4f3" else ("#e4e6e6", "#33383b")
    # built in, narrower than the front: steel would glint through the gaps beside it
    slim_by = 0.008 if look else 0.0
    low = (x1 + 0.001, y[0] + slim_by, door_low)
    inner = low, (x1 + thick - 0.018, y[1] - slim_by, height - 0.024)
    asm.board("door", *inner, tub, 0.002)
    facing = finish(look["front"], 2, offset) if look else shell
    if look:
        leaf(asm, "door", outer - DOOR, y, (door_low, strip - 0.002), look, facing)
    else:
        front(asm, "door", outer - DOOR, y, (door_low, strip - 0.002), facing)
    face = {"+x": _controls(480 if width > 0.5 else 400, *panel_ink)}
    low, high = (outer - 0.018, y[0], strip), (outer, y[1], height - 0.024)
    asm.board("door", low, high, plain(panel_ink[0], 0.02), 0, face, 2.2)
    bar, reach = (metal_or(look["metal"]), REACH) if look else (steel(), 0.035)
    bar_handle(asm, "door", outer, 0, strip - 0.055, width * 0.6, bar, False, reach=reach)
    for s in (-1, 1):  # salt and soap lids on the inside of the door
        lid = [(0, 0), (0.035, 0), (0.035, 0.006), (0, 0.008)]
        mesh = lathe(lid, 12, mat=arm_mat).turn(ry=-np.pi / 2)
        asm.add("door", mesh.move(x1 + 0.003, s * 0.07, (door_low + height) / 2))
    slim = "slim " if width < 0.5 else "table-top " if racks == 1 else ""
    kind = (
        f"built-in dishwasher, {named(suite)} fronts"
        if look
        else f"{slim}dishwasher, {_name(colour)}"
    )
    return Model(
        title=kind,
        parts=asm.parts(door={"joint": "door"}, interior={"rgba": LINER}),
        mass=(46.0 if width > 0.5 else 36.0) if racks > 1 else 21.0,
        joints={"door": Joint("revolute", (outer, 0, door_low), (0, 1, 0), 0.0, 1.5)},
        states=[
            {"state": "CLOSED", "joint": "door", "max": 0.03, "parts": ["door"]},
            open_closed("door", "interior")[1],
        ],
        supports=supports,
        containers=containers,
        ground_shadow=True,
    )


def _paint(colour: str, offset: Offset) -> Material:
    return steel(3.0) if colour == "steel" else plain(colour, 0.02, 6, offset)


def _name(colour: str) -> str:
    return {"steel": "steel", "#f3f4f3": "white", "#33363a": "black"}.get(colour, "red")


def dishwasher_random(rng: np.random.Generator) -> dict:
    """Parameters of a random dishwasher."""
    return {
        "suite": pick(rng, [None, *STYLES]),
        "colour": pick(rng, ["#f3f4f3", "steel", "#33363a"]),
        "width": 0.6,
        "offset": noise_offset(rng),
    }


MODELS = {
    "dishwasher": Maker(
        dishwasher,
        dishwasher_random,
        13,
        [
            *({"suite": suite, "width": 0.6} for suite in FIRST),
            {"suite": None, "colour": "#f3f4f3", "width": 0.6},
            {"suite": None, "colour": "steel", "width": 0.6},
            {"suite": None, "colour": "#f3f4f3", "width": 0.45},
            {
                "suite": None,
                "colour": "#f3f4f3",
                "width": 0.55,
                "height": 0.44,
                "racks": 1,
                "depth": 0.45,
            },
            *({"suite": suite, "width": 0.6} for suite in FURTHER),
        ],
    ),
}
