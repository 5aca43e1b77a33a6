"""Fridge and microwave. The stove has a file of its own."""

from __future__ import annotations

import numpy as np
from toolkit import labels
from toolkit.materials import glowing, label, plain
from toolkit.model import Container, Maker, Model
from toolkit.sampling import noise_offset, pick
from toolkit.shapes import box, lathe

from .designs import extend
from .fridges import round_fridge, small_fridge, wide_fridge
from .joinery import (
    SHOWS,
    Assembly,
    bar_handle,
    front,
    hinge,
    open_closed,
    sheet_steel,
    steel,
    surface,
)
from .microwaves import (
    GLOW,
    NAMES,
    SWITCHED,
    dial_microwave,
    drop_microwave,
    retro_microwave,
    window_light,
)

Offset = tuple[float, float, float]
LINER = (1.3, 1.3, 1.33, 1.0)


def compartment(
    asm: Assembly,
    x: tuple[float, float],
    y: tuple[float, float],
    z: tuple[float, float],
    shell,
    liner,
    wall: float,
    bevel: float = 0.004,
) -> None:
    """Five walls of a cold compartment, open to the front: shell outside, liner inside."""
    (x0, x1), (y0, y1), (z0, z1) = x, y, z
    asm.board("body", (x0, y0, z0), (x1, y0 + wall, z1), shell, bevel)
    asm.board("body", (x0, y1 - wall, z0), (x1, y1, z1), shell, bevel)
    asm.board("body", (x0, y0 + wall, z0), (x1, y1 - wall, z0 + wall), shell)
    asm.board("body", (x0, y0 + wall, z1 - wall), (x1, y1 - wall, z1), shell)
    asm.board("body", (x0, y0 + wall, z0 + wall), (x0 + wall, y1 - wall, z1 - wall), shell)
    # The liner is a thin tub of its own so that it can be lit more brightly than the shell.
    t, a = 0.006, wall
    for low, high in (
        ((x0 + a, y0 + a, z0 + a), (x0 + a + t, y1 - a, z1 - a)),
        ((x0 + a, y0 + a, z0 + a), (x1 - 0.002, y0 + a + t, z1 - a)),
        ((x0 + a, y1 - a - t, z0 + a), (x1 - 0.002, y1 - a, z1 - a)),
        ((x0 + a, y0 + a, z0 + a), (x1 - 0.002, y1 - a, z0 + a + t)),
        ((x0 + a, y0 + a, z1 - a - t), (x1 - 0.002, y1 - a, z1 - a)),
    ):
        asm.board("interior", low, high, liner, solid=high[2] < low[2] + 0.01)


def fridge(
    width: float = 0.6,
    height: float = 1.7,
    colour: str = "#f1f2f0",
    freezer: str | None = "top",
    shelves: int = 4,
    right_hung: bool = True,
    offset: Offset = (0, 0, 0),
) -> Model:
    """A fridge with a lit, hollow inside; freezer: "top", "bottom" or None (a larder fridge)."""
    asm, half = Assembly(), width / 2
    x0, case_front, thick, foot, wall = -0.31, 0.25, 0.05, 0.05, 0.035
    steel_look = colour == "steel"
    shell = sheet_steel(offset) if steel_look else plain(colour, 0.02, 6, offset)
    liner, gasket = plain("#f6f9fa", 0.01, 6), plain("#8f959a", 0.03)
    glass, rim = plain("#cfe6ea", 0.06, 9, offset), plain("#f2f6f6", 0.01)
    crisper = plain("#c3dbe2", 0.05, 7)
    handle = plain("#4a4e52", 0.05) if steel_look else steel()
    asm.board(
        "body",
        (x0 + 0.02, -half + 0.01, 0),
        (case_front, half - 0.01, foot),
        plain("#2b2c2e", 0.05),
    )
    share = height * 0.3
    if freezer == "top":
        cold, frozen = (foot, height - share), (height - share, height)
    elif freezer == "bottom":
        cold, frozen = (foot + share, height), (foot, foot + share)
    else:
        cold, frozen = (foot, height), None
    compartment(asm, (x0, case_front), (-half, half), cold, shell, liner, wall)
    inner_y, floor, roof = half - wall - 0.008, cold[0] + wall + 0.006, cold[1] - wall - 0.006
    back = x0 + wall + 0.006
    lamp = box(0.03, 0.14, 0.05, (back + 0.016, 0, roof - 0.075), glowing("#fffdf0"), 0.005)
    asm.add("lamp", lamp)
    # two crispers under a glass sheet, then shelves up to the roof
    drawer_top = floor + 0.19
    for side in (-1, 1):
        low = (back + 0.03, min(0.004 * side, side * (inner_y - 0.006)), floor)
        high = (case_front - 0.09, max(0.004 * side, side * (inner_y - 0.006)), drawer_top - 0.015)
        asm.board("interior", low, high, crisper, 0.008)
        grip = (case_front - 0.092, side * inner_y / 2 - 0.05, drawer_top - 0.06)
        asm.board(
            "interior",
            grip,
            (case_front - 0.082, grip[1] + 0.1, drawer_top - 0.045),
            gasket,
            solid=False,
        )
    step = (roof - drawer_top) / shelves
    supports = [surface("top", (x0, -half), (case_front, half), height)]
    for k in range(shelves):
        z = drawer_top + k * step
        depth = case_front - 0.09  # leaves room for the racks on the door
        asm.board("interior", (back, -inner_y, z - 0.008), (depth, inner_y, z), glass)
        lip = (depth - 0.012, -inner_y, z - 0.012), (depth, inner_y, z + 0.001)
        asm.board("interior", *lip, rim, solid=False)
        low, high = (back + 0.01, -inner_y), (depth - 0.01, inner_y)
        supports.append(surface(f"shelf_{k + 1}", low, high, z, step - 0.012, "inside"))
    center = ((back + case_front) / 2, 0.0, (drawer_top + roof) / 2)
    size = (case_front - back - 0.02, 2 * inner_y, roof - drawer_top)
    containers = [Container("inside", center, size, "body", "door")]
    hinge_y = half if right_hung else -half
    joints, states = (
        {"door": hinge(case_front + thick, hinge_y)},
        open_closed("door", "door", opened=SHOWS),
    )
    settings = {
        "door": {"joint": "door"},
        "interior": {"rgba": LINER},
        "lamp": {"rgba": (1.7, 1.7, 1.7, 1.0)},
    }
    doors = [("door", cold, True)]
    if frozen:
        compartment(asm, (x0, case_front), (-half, half), frozen, shell, liner, wall)
        middle, low_z, high_z = (
            (frozen[0] + frozen[1]) / 2,
            frozen[0] + wall + 0.006,
            frozen[1] - wall - 0.006,
        )
        asm.board(
            "interior",
            (back, -inner_y, middle - 0.008),
            (case_front - 0.04, inner_y, middle),
            glass,
        )
        a, b = (back + 0.01, -inner_y), (case_front - 0.04, inner_y)
        supports.append(surface("freezer_floor", a, b, low_z, middle - 0.01 - low_z, "freezer"))
        supports.append(surface("freezer_shelf", a, b, middle, high_z - middle, "freezer"))
        center = ((back + case_front) / 2, 0.0, (low_z + high_z) / 2)
        containers.append(
            Container("freezer", center, (size[0], size[1], high_z - low_z), "body", "freezer_door")
        )
        joints["freezer_door"] = hinge(case_front + thick, hinge_y)
        states += open_closed("freezer_door", "freezer_door", opened=SHOWS)
        settings["freezer_door"] = {"joint": "freezer_door"}
        doors.append(("freezer_door", frozen, False))
    side = -1 if right_hung else 1
    for part, (z0, z1), racks in doors:
        z0, z1 = z0 + 0.003, z1 - 0.003
        # case_front + 0.012: room for the gasket, which the leaf carries
        leaf = (case_front + 0.012, -half + 0.001, z0), (case_front + thick, half - 0.001, z1)
        asm.board(part, *leaf, shell, 0.01, segments=2)
        seal = (
            (case_front + 0.001, -half + 0.02, z0 + 0.02),
            (case_front + 0.013, half - 0.02, z1 - 0.02),
        )
        asm.board(part, *seal, gasket, solid=False)
        panel = (
            (case_front - 0.006, -half + 0.05, z0 + 0.05),
            (case_front + 0.012, half - 0.05, z1 - 0.05),
        )
        asm.board(part, *panel, liner, 0.004, solid=False)
        length = min(0.4, (z1 - z0) * 0.5)
        if racks:
            centre_z = z1 - 0.12 - length / 2 if freezer == "top" else z0 + 0.1 + length / 2 + 0.12
            for z in np.linspace(z0 + 0.12, z1 - 0.32, 3):
                _door_rack(asm, part, case_front - 0.006, half - 0.07, float(z), rim)
        else:
            centre_z = z0 + 0.06 + length / 2 if freezer == "top" else z1 - 0.06 - length / 2
        bar_handle(
            asm,
            part,
            case_front + thick,
            side * (half - 0.05),
            centre_z,
            length,
            handle,
            reach=0.05,
            radius=0.011,
        )
    where = {"top": ", freezer on top", "bottom": ", freezer below", None: ""}[freezer]
    names = {"#f1f2f0": "white", "steel": "steel", "#b24a3c": "red", "#9fc3bb": "mint"}
    return Model(
        title=f"{names.get(colour, 'coloured')} fridge{where}",
        parts=asm.parts(**settings),
        mass=60.0,
        variants=None,
        joints=joints,
        # The door alone seen from behind does not tell: the evidence is the inside.
        states=[s | {"parts": ["interior"]} if s["state"] == "OPEN" else s for s in states],
        supports=supports,
        containers=containers,
        ground_shadow=True,
    )


def _door_rack(asm: Assembly, part: str, x: float, half: float, z: float, mat) -> None:
    """A bottle rack on the inside of a fridge door."""
    depth = 0.075
    for low, high in (
        ((x - depth, -half, z), (x, half, z + 0.008)),
        ((x - depth, -half, z), (x - depth + 0.008, half, z + 0.07)),
        ((x - depth, -half, z), (x, -half + 0.008, z + 0.07)),
        ((x - depth, half - 0.008, z), (x, half, z + 0.07)),
    ):
        asm.board(part, low, high, mat, solid=False)


def fridge_random(rng: np.random.Generator) -> dict:
    """Parameters of a random fridge."""
    return {
        "width": round(float(rng.uniform(0.57, 0.66)), 2),
        "height": round(float(rng.uniform(1.5, 1.82)), 2),
        "colour": pick(rng, ["#f1f2f0", "steel", "#b24a3c", "#9fc3bb"]),
        "freezer": pick(rng, ["top", "bottom", None]),
        "shelves": int(rng.integers(3, 5)),
        "right_hung": bool(rng.random() < 0.3),
        "offset": noise_offset(rng),
    }


def microwave(
    width: float = 0.48, colour: str = "#e9eaea", clock: str = "12:45", offset: Offset = (0, 0, 0)
) -> Model:
    """A microwave oven: hinged window door, controls on the right, a plate inside."""
    asm, half, height, depth = Assembly(), width / 2, 0.28, 0.36
    x0, case_front = -depth / 2, depth / 2 - 0.03
    shell, dark = plain(colour, 0.02, 10, offset), plain("#202224", 0.04, 20)
    liner, panel_y = plain("#dcdedd", 0.02, 10), half - 0.11
    for x in (x0 + 0.04, case_front - 0.04):
        for y in (-half + 0.05, half - 0.05):
            asm.board("body", (x - 0.012, y - 0.012, 0), (x + 0.012, y + 0.012, 0.013), dark)
    z0, z1, w = 0.012, height, 0.02
    asm.board("body", (x0, -half, z0), (case_front, -half + w, z1), shell, 0.004, {"+y": liner})
    asm.board("body", (x0, panel_y, z0), (case_front, half, z1), shell, 0.004, {"-y": liner})
    asm.board("body", (x0, -half + w, z0), (case_front, panel_y, z0 + w), shell, 0, {"+z": liner})
    asm.board("body", (x0, -half + w, z1 - w), (case_front, panel_y, z1), shell, 0, {"-z": liner})
    asm.board("body", (x0, -half + w, z0 + w), (x0 + w, panel_y, z1 - w), shell, 0, {"+x": liner})
    centre_y = (-half + w + panel_y) / 2
    plate = [(0, 0), (0.11, 0), (0.128, 0.008), (0.126, 0.012), (0.1, 0.006), (0, 0.006)]
    inside = (case_front + x0 + w) / 2
    asm.add(
        "body",
        lathe(plate, 24, mat=plain("#cfe0e2", 0.04, 20)).move(inside, centre_y, z0 + w + 0.008),
    )
    asm.solid(
        "body",
        (inside - 0.09, centre_y - 0.09, z0 + w),
        (inside + 0.09, centre_y + 0.09, z0 + w + 0.014),
    )
    # control panel, drawn
    picture, draw = labels.canvas(128, 320, "#26282b")
    draw.rectangle((14, 18, 114, 62), fill="#0a1512")
    labels.text(draw, clock, (20, 24, 108, 58), "bold", "#46f0b4")
    for row in range(4):
        for col in range(3):
            x, y = 16 + col * 34, 84 + row * 30
            draw.rounded_rectangle((x, y, x + 28, y + 22), 5, fill="#4a4e53")
            labels.text(
                draw, str(row * 3 + col + 1), (x + 6, y + 4, x + 22, y + 19), "bold", "#d8dadc"
            )
    draw.rounded_rectangle((16, 216, 60, 246), 6, fill="#a33a30")
    draw.rounded_rectangle((68, 216, 112, 246), 6, fill="#3d8a56")
    draw.ellipse((40, 258, 88, 306), fill="#6a6f74", outline="#9aa0a5", width=3)
    controls = box(
        0.03,
        half - panel_y - 0.004,
        height - z0 - 0.004,
        (case_front + 0.015, (panel_y + half) / 2, z0 + 0.002),
        dark,
        0,
        labels={"+x": label(picture)},
        weight=2.0,
    )
    asm.add("body", controls, solid=True)
    # door: a frame round dark glass with a perforated look
    y0, y1, x1 = -half + 0.001, panel_y - 0.002, depth / 2
    window, pen = labels.canvas(128, 96, "#1b1d1f")
    for k in range(0, 96, 6):
        for j in range(0, 128, 6):
            pen.point((j + (k // 6 % 2) * 3, k), fill="#3a3e42")
    pen.polygon([(10, 96), (48, 0), (76, 0), (38, 96)], fill="#2b3034")
    front(asm, "door", case_front + 0.001, (y0, y1), (z0, z1), shell, "slab", 0.022)
    low, high = (case_front + 0.02, y0 + 0.035, z0 + 0.04), (x1, y1 - 0.05, z1 - 0.04)
    asm.board("door", low, high, dark, 0.003, {"+x": label(window)}, 1.5, solid=False)
    window_light(asm, "light", x1, (y0 + 0.035, y1 - 0.05), (z0 + 0.04, z1 - 0.04))
    back_window = (
        (case_front - 0.005, y0 + 0.04, z0 + 0.045),
        (case_front + 0.002, y1 - 0.055, z1 - 0.045),
    )
    asm.board("door", *back_window, dark, 0, solid=False)
    bar_handle(
        asm, "door", x1 - 0.008, y1 - 0.022, (z0 + z1) / 2, 0.17, steel(), reach=0.03, radius=0.007
    )
    low, high = (x0 + w, -half + w), (case_front, panel_y)
    support = surface(
        "plate",
        (inside - 0.08, centre_y - 0.08),
        (inside + 0.08, centre_y + 0.08),
        z0 + w + 0.014,
        height - w - 0.05,
        "inside",
    )
    center = ((low[0] + high[0]) / 2, centre_y, (z0 + z1) / 2)
    size = (high[0] - low[0], high[1] - low[1], z1 - z0 - 2 * w)
    return Model(
        title=f"{NAMES.get(colour, 'coloured')} microwave oven",
        parts=asm.parts(door={"joint": "door"}, light={"joint": "door", "rgba": GLOW}),
        mass=12.0,
        variants={"default": ["body", "door"], "on": ["body", "door", "light"]},
        joints={"door": hinge(x1 - 0.007, -half)},
        states=SWITCHED + open_closed("door", "door"),
        supports=[surface("top", (x0, -half), (case_front, half), height), support],
        containers=[Container("inside", center, size, "body", "door")],
    )


def microwave_random(rng: np.random.Generator) -> dict:
    """Parameters of a random microwave."""
    return {
        "width": round(float(rng.uniform(0.45, 0.52)), 2),
        "colour": pick(rng, ["#e9eaea", "#2c2e31", "#b9bdc0"]),
        "clock": pick(rng, ["12:45", "8:15", "18:30"]),
        "offset": noise_offset(rng),
    }


MODELS = {
    "fridge": extend(
        Maker(
            fridge,
            fridge_random,
            3,
            [
                {
                    "colour": "#f1f2f0",
                    "freezer": "top",
                    "height": 1.72,
                    "shelves": 3,
                    "right_hung": False,
                },
                {
                    "colour": "steel",
                    "freezer": "bottom",
                    "height": 1.84,
                    "shelves": 4,
                    "right_hung": False,
                },
                {
                    "colour": "#9fc3bb",
                    "freezer": None,
                    "height": 1.46,
                    "shelves": 4,
                    "right_hung": False,
                },
            ],
        ),
        [
            (
                fridge,
                {
                    "colour": "#f1f2f0",
                    "freezer": "bottom",
                    "height": 1.84,
                    "shelves": 4,
                    "width": 0.58,
                    "right_hung": False,
                },
            ),
            (wide_fridge, {"style": "side_by_side", "colour": "steel"}),
            (wide_fridge, {"style": "french", "colour": "steel"}),
            (wide_fridge, {"style": "french", "colour": "#2b2d30"}),
            (round_fridge, {"colour": "#b03a30"}),
            (round_fridge, {"colour": "#eee3c8"}),
            (small_fridge, {"colour": "#f1f2f0"}),
            (small_fridge, {"colour": "steel"}),
        ],
    ),
    "microwave": extend(
        Maker(microwave, microwave_random, 2, [{"colour": "#e9eaea"}, {"colour": "#2c2e31"}]),
        [
            (microwave, {"colour": "#b9bdc0", "width": 0.5, "clock": "18:30"}),
            (retro_microwave, {"colour": "#efe4cb"}),
            (retro_microwave, {"colour": "#a8322c"}),
            (drop_microwave, {"colour": "steel"}),
            (drop_microwave, {"colour": "#26282b"}),
            (dial_microwave, {"colour": "#f1f1ee"}),
        ],
    ),
}
