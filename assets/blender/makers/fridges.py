"""Wide American fridges, a rounded one of the fifties, and a small one for under the worktop."""

from __future__ import annotations

import numpy as np
from toolkit import labels
from toolkit.materials import glowing, label, metal, plain
from toolkit.model import Container, Joint, Model
from toolkit.shapes import box, extrude, lathe, loft, rounded_rectangle

from .joinery import (
    SHOWS,
    Assembly,
    bar_handle,
    drawer_box,
    hinge,
    open_closed,
    sheet_steel,
    steel,
    surface,
)

Offset = tuple[float, float, float]
LINER, LAMP = (1.3, 1.3, 1.33, 1.0), (1.7, 1.7, 1.7, 1.0)
#: The box of a freezer drawer, a part of its own: hidden while the drawer is shut.
BOX = "freezer_box"


def tub(asm: Assembly, x: tuple, y: tuple, z: tuple, shell, liner, wall: float) -> None:
    """A cold compartment, open in front: shell outside, thin bright liner inside."""
    (x0, x1), (y0, y1), (z0, z1) = x, y, z
    asm.board("body", (x0, y0, z0), (x1, y0 + wall, z1), shell, 0.004)
    asm.board("body", (x0, y1 - wall, z0), (x1, y1, z1), shell, 0.004)
    asm.board("body", (x0, y0 + wall, z0), (x1, y1 - wall, z0 + wall), shell)
    asm.board("body", (x0, y0 + wall, z1 - wall), (x1, y1 - wall, z1), shell)
    asm.board("body", (x0, y0 + wall, z0 + wall), (x0 + wall, y1 - wall, z1 - wall), shell)
    line(asm, x, (y0 + wall, y1 - wall), (z0 + wall, z1 - wall), liner, wall)


def line(asm: Assembly, x: tuple, y: tuple, z: tuple, liner, wall: float) -> None:
    """The liner of a compartment between these inner faces."""
    (x0, x1), (ya, yb), (za, zb), t = x, y, z, 0.006
    for low, high in (
        ((x0 + wall, ya, za), (x0 + wall + t, yb, zb)),
        ((x0 + wall, ya, za), (x1 - 0.002, ya + t, zb)),
        ((x0 + wall, yb - t, za), (x1 - 0.002, yb, zb)),
        ((x0 + wall, ya, za), (x1 - 0.002, yb, za + t)),
        ((x0 + wall, ya, zb - t), (x1 - 0.002, yb, zb)),
    ):
        asm.board("interior", low, high, liner, solid=high[2] < low[2] + 0.01)


def _shelves(
    asm: Assembly, x: tuple, y: tuple, levels: list[float], roof: float, name: str
) -> list:
    """Glass shelves at these heights (the first is the floor); returns the supports."""
    glass, rim, out = plain("#cfe6ea", 0.06, 9), plain("#f2f6f6", 0.01), []
    for k, z in enumerate(levels):
        if k:
            asm.board("interior", (x[0], y[0], z - 0.008), (x[1], y[1], z), glass)
            lip = (x[1] - 0.012, y[0], z - 0.012), (x[1], y[1], z + 0.001)
            asm.board("interior", *lip, rim, solid=False)
        above = levels[k + 1] - 0.012 if k + 1 < len(levels) else roof
        label_ = f"{'freezer_shelf' if name == 'freezer' else 'shelf'}_{k + 1}"
        out.append(surface(label_, (x[0] + 0.01, y[0]), (x[1] - 0.01, y[1]), z, above - z, name))
    return out


def _leaf(asm: Assembly, part: str, x: float, y: tuple, z: tuple, shell, liner, seal) -> None:
    """A thick door whose back lies at x, with seal and inner panel."""
    asm.board(part, (x + 0.012, y[0], z[0]), (x + 0.055, y[1], z[1]), shell, 0.01, segments=2)
    low, high = (x + 0.001, y[0] + 0.015, z[0] + 0.015), (x + 0.013, y[1] - 0.015, z[1] - 0.015)
    asm.board(part, low, high, seal, solid=False)
    low, high = (x - 0.006, y[0] + 0.05, z[0] + 0.05), (x + 0.012, y[1] - 0.05, z[1] - 0.05)
    asm.board(part, low, high, liner, 0.004, solid=False)


def _racks(asm: Assembly, part: str, x: float, y: tuple, heights, mat) -> None:
    """Bottle racks on the inside of a door."""
    for z in heights:
        depth, (y0, y1) = 0.075, y
        for low, high in (
            ((x - depth, y0, z), (x, y1, z + 0.008)),
            ((x - depth, y0, z), (x - depth + 0.008, y1, z + 0.07)),
            ((x - depth, y0, z), (x, y0 + 0.008, z + 0.07)),
            ((x - depth, y1 - 0.008, z), (x, y1, z + 0.07)),
        ):
            asm.board(part, low, high, mat, solid=False)


def _finished(asm: Assembly, title: str, mass: float, joints: dict, supports, containers) -> Model:
    settings = {name: {"joint": name} for name in joints}
    states = []
    for name in joints:  # a front alone, seen from outside, does not tell: evidence is the inside
        slides = joints[name].type == "prismatic"
        shut, opened = open_closed(name, name, *((0.01, 0.12) if slides else (0.03, SHOWS)))
        states += [shut, opened | {"parts": [BOX, "interior"] if slides else ["interior"]}]
        if slides:
            settings[BOX] = {"joint": name, "rgba": LINER}
    return Model(
        title=title,
        parts=asm.parts(**settings, interior={"rgba": LINER}, lamp={"rgba": LAMP}),
        mass=mass,
        joints=joints,
        states=states,
        supports=supports,
        containers=containers,
        ground_shadow=True,
    )


def wide_fridge(
    style: str = "side_by_side", colour: str = "steel", offset: Offset = (0, 0, 0)
) -> Model:
    """style: "side_by_side" (freezer left) or "french" (two doors above a freezer drawer)."""
    asm, half, height = Assembly(), 0.455, 1.78
    x0, front_x, wall, foot = -0.33, 0.28, 0.04, 0.05
    shell = sheet_steel(offset) if colour == "steel" else plain(colour, 0.02, 6, offset)
    liner, seal = plain("#f6f9fa", 0.01, 6), plain("#8f959a", 0.03)
    rim, dark = plain("#f2f6f6", 0.01), plain("#2b2c2e", 0.05)
    grip = plain("#3c4044", 0.05) if colour == "steel" else steel()
    asm.board("body", (x0 + 0.02, -half + 0.01, 0), (front_x, half - 0.01, foot), dark)
    french = style == "french"
    share, split = 0.62, -0.09
    cold_y, cold_z = ((-half, half), (share, height)) if french else ((split, half), (foot, height))
    cold_x = (x0, front_x)
    tub(asm, cold_x, cold_y, cold_z, shell, liner, wall)
    back, depth = x0 + wall + 0.006, front_x - 0.09
    inner = (cold_y[0] + wall + 0.008, cold_y[1] - wall - 0.008)
    floor, roof = cold_z[0] + wall + 0.006, cold_z[1] - wall - 0.006
    lamp = box(
        0.03, 0.16, 0.05, (back + 0.016, sum(inner) / 2, roof - 0.075), glowing("#fffdf0"), 0.005
    )
    asm.add("lamp", lamp)
    levels = [floor, *np.linspace(floor, roof, 5 if french else 6)[1:-1].tolist()]
    supports = [surface("top", (x0, -half), (front_x, half), height)]
    supports += _shelves(asm, (back, depth), inner, levels, roof, "inside")
    size = (depth - back, inner[1] - inner[0], roof - floor)
    center = ((back + depth) / 2, sum(inner) / 2, (roof + floor) / 2)
    containers = [Container("inside", center, size, "body", "door")]
    outer = front_x + 0.055
    z = (cold_z[0] + 0.003, height - 0.002)
    if french:
        leaves = {"door": (0.002, half - 0.001), "door_left": (-half + 0.001, -0.002)}
        joints = {"door": hinge(outer, half), "door_left": hinge(outer, -half)}
        tub(asm, cold_x, cold_y, (foot, share), shell, liner, wall)
        low, high = (
            (back + 0.02, -half + wall + 0.02, foot + wall + 0.03),
            (front_x + 0.001, half - wall - 0.02, 0.46),
        )
        drawer_box(asm, BOX, low, high, plain("#dfe9ee", 0.03))
        leaf = (-half + 0.001, half - 0.001), (foot + 0.003, share - 0.003)
        _leaf(asm, "freezer_door", front_x, *leaf, shell, liner, seal)
        bar_handle(asm, "freezer_door", outer, 0, share - 0.07, 0.6, grip, False, 0.05, 0.011)
        joints["freezer_door"] = Joint("prismatic", (0, 0, 0.3), (1, 0, 0), 0.0, 0.42)
        low_y, high_y = low[1] + 0.014, high[1] - 0.014
        supports.append(
            surface(
                "freezer_floor",
                (low[0] + 0.014, low_y),
                (high[0], high_y),
                low[2] + 0.008,
                0.3,
                "freezer",
                BOX,
            )
        )
        center = ((low[0] + high[0]) / 2, 0.0, low[2] + 0.17)
        containers.append(
            Container("freezer", center, (0.5, high_y - low_y, 0.32), BOX, "freezer_door")
        )
    else:
        leaves = {
            "door": (split + 0.002, half - 0.001),
            "freezer_door": (-half + 0.001, split - 0.002),
        }
        joints = {"door": hinge(outer, half), "freezer_door": hinge(outer, -half)}
        y = (-half, split)
        tub(asm, cold_x, y, cold_z, shell, liner, wall)
        narrow = (y[0] + wall + 0.008, y[1] - wall - 0.008)
        levels = [floor, *np.linspace(floor, roof, 6)[1:-1].tolist()]
        supports += _shelves(asm, (back, depth + 0.05), narrow, levels, roof, "freezer")
        center = ((back + depth) / 2, sum(narrow) / 2, (roof + floor) / 2)
        size = (depth - back, narrow[1] - narrow[0], roof - floor)
        containers.append(Container("freezer", center, size, "body", "freezer_door"))
    for part, y in leaves.items():
        _leaf(asm, part, front_x, y, z, shell, liner, seal)
        if part != "freezer_door":
            heights = np.linspace(z[0] + 0.12, z[1] - 0.32, 3)
            _racks(asm, part, front_x - 0.006, (y[0] + 0.07, y[1] - 0.07), heights, rim)
        at = y[0] + 0.045 if part == "door" else y[1] - 0.045
        bar_handle(
            asm,
            part,
            outer,
            at,
            sum(z) / 2,
            0.62 if french else 0.8,
            grip,
            reach=0.055,
            radius=0.012,
        )
    if not french:  # water and ice
        y = sum(leaves["freezer_door"]) / 2
        picture, draw = labels.canvas(64, 96, "#101214")
        labels.text(draw, "ICE", (8, 8, 56, 30), "bold", "#8fd8ff")
        draw.rectangle((10, 40, 54, 90), fill="#3a4147")
        draw.polygon([(28, 46), (36, 46), (38, 66), (26, 66)], fill="#aab3ba")
        low, high = (outer - 0.003, y - 0.09, 0.98), (outer + 0.006, y + 0.09, 1.25)
        asm.board("freezer_door", low, high, dark, 0.002, {"+x": label(picture)}, 1.5, solid=False)
    tone = {"steel": "steel", "#2b2d30": "black"}.get(colour, "white")
    kind = "French-door fridge with a freezer drawer" if french else "side-by-side fridge freezer"
    return _finished(asm, f"{tone} {kind}", 105.0, joints, supports, containers)


def round_fridge(colour: str = "#b03a30", offset: Offset = (0, 0, 0)) -> Model:
    """A fridge of the fifties: all corners round, chrome handle and badge."""
    asm, half, height = Assembly(), 0.3, 1.5
    x0, front_x, wall, foot = -0.3, 0.24, 0.045, 0.06
    shell, chrome = plain(colour, 0.02, 6, offset), metal("d3d7da", "82888e", (1, 1, 5), 30)
    liner, seal = plain("#f6f9fa", 0.01, 6), plain("#8f959a", 0.03)
    middle, tall = (foot + height) / 2, height - foot

    def outline(shrink: float, r: float) -> np.ndarray:
        return rounded_rectangle(2 * (half - shrink), tall - 2 * shrink, r, 5)

    rings = []
    for x, shrink, r in (
        (x0 + 0.02, 0.03, 0.08),
        (x0, 0.05, 0.07),
        (x0, wall, 0.02),
        (front_x, wall, 0.02),
        (front_x, 0.0, 0.11),
        (x0 + 0.03, 0.0, 0.11),
        (x0 + 0.02, 0.03, 0.08),
    ):
        flat = outline(shrink, r)
        rings.append(np.c_[np.full(len(flat), x), flat[:, 0], flat[:, 1] + middle])
    asm.add("body", loft([*rings[2:], *rings[1:3]], shell, caps=(False, False)).outward())
    asm.board(
        "body",
        (x0 - 0.001, -half + 0.03, foot + 0.03),
        (x0 + wall, half - 0.03, height - 0.03),
        shell,
        0.01,
    )
    line(asm, (x0, front_x), (-half + wall, half - wall), (foot + wall, height - wall), liner, wall)
    for low, high in (
        ((x0, -half, foot), (front_x, -half + wall, height)),
        ((x0, half - wall, foot), (front_x, half, height)),
        ((x0, -half, foot), (front_x, half, foot + wall)),
        ((x0, -half, height - wall), (front_x, half, height)),
    ):
        asm.solid("body", low, high)
    for x in (x0 + 0.06, front_x - 0.06):
        for y in (-half + 0.08, half - 0.08):
            foot_p = [(0, 0), (0.022, 0), (0.018, foot + 0.01), (0, foot + 0.01)]
            asm.add("body", lathe(foot_p, 8, mat=chrome).move(x, y, 0), solid=True)
    back, depth, inner = x0 + wall + 0.006, front_x - 0.09, half - wall - 0.008
    floor, roof = foot + wall + 0.006, height - wall - 0.006
    asm.add(
        "lamp", box(0.03, 0.14, 0.05, (back + 0.016, 0, roof - 0.075), glowing("#fffdf0"), 0.005)
    )
    levels = [floor, *np.linspace(floor, roof, 6)[1:-1].tolist()]
    supports = [surface("top", (x0 + 0.03, -half + 0.08), (front_x, half - 0.08), height)]
    supports += _shelves(asm, (back, depth), (-inner, inner), levels, roof, "inside")
    center = ((back + depth) / 2, 0.0, (roof + floor) / 2)
    containers = [
        Container("inside", center, (depth - back, 2 * inner, roof - floor), "body", "door")
    ]
    leaf = extrude(outline(0.001, 0.11), 0.06, mat=shell, axis="x", bevel_width=0.02, segments=2)
    asm.add("door", leaf.move(front_x + 0.043, 0, middle), solid=True)
    flat = extrude(outline(0.02, 0.09), 0.012, mat=seal, axis="x")
    asm.add("door", flat.move(front_x + 0.007, 0, middle))
    panel = extrude(outline(0.06, 0.04), 0.02, mat=liner, axis="x")
    asm.add("door", panel.move(front_x + 0.002, 0, middle))
    _racks(
        asm,
        "door",
        front_x - 0.006,
        (-half + 0.09, half - 0.09),
        np.linspace(foot + 0.14, height - 0.42, 3),
        plain("#f2f6f6", 0.01),
    )
    outer = front_x + 0.073
    bar_handle(asm, "door", outer, -half + 0.075, 0.98, 0.26, chrome, reach=0.055, radius=0.015)
    asm.board(
        "door",
        (outer - 0.004, -half + 0.06, 0.92),
        (outer + 0.012, -half + 0.09, 1.04),
        chrome,
        0.004,
        solid=False,
    )
    picture, draw = labels.canvas(200, 60, "#d8dcdf")
    labels.text(draw, "FROSTA", (10, 6, 190, 54), "italic", "#3a3f44")
    badge = (outer - 0.004, -0.06, 1.24), (outer + 0.006, 0.13, 1.3)
    asm.board("door", *badge, chrome, 0.002, {"+x": label(picture)}, 2.0, solid=False)
    band = (outer - 0.004, -half + 0.03, 0.4), (outer + 0.004, half - 0.03, 0.415)
    asm.board("door", *band, chrome, solid=False)
    tone = {"#b03a30": "red", "#eee3c8": "cream"}.get(colour, "blue")
    return _finished(
        asm,
        f"{tone} retro fridge, rounded",
        62.0,
        {"door": hinge(outer, half)},
        supports,
        containers,
    )


def small_fridge(colour: str = "#f1f2f0", offset: Offset = (0, 0, 0)) -> Model:
    """A fridge to stand under a worktop, with a small ice box."""
    asm, half, height = Assembly(), 0.275, 0.85
    x0, front_x, wall, foot = -0.3, 0.21, 0.04, 0.03
    shell = sheet_steel(offset) if colour == "steel" else plain(colour, 0.02, 6, offset)
    liner, seal = plain("#f6f9fa", 0.01, 6), plain("#8f959a", 0.03)
    dark = plain("#2b2c2e", 0.05)
    asm.board("body", (x0 + 0.02, -half + 0.01, 0), (front_x - 0.02, half - 0.01, foot), dark)
    tub(asm, (x0, front_x), (-half, half), (foot, height - 0.015), shell, liner, wall)
    lid = (x0, -half - 0.002, height - 0.022), (front_x + 0.056, half + 0.002, height)
    asm.board("body", *lid, shell, 0.006)
    back, depth, inner = x0 + wall + 0.006, front_x - 0.09, half - wall - 0.008
    floor, roof = foot + wall + 0.006, height - wall - 0.021
    ice = roof - 0.13
    asm.board(
        "interior",
        (back, -inner, ice),
        (depth - 0.02, inner, ice + 0.01),
        plain("#dceaf2", 0.05, 20),
    )
    asm.board(
        "interior",
        (depth - 0.03, -inner, ice),
        (depth - 0.02, inner, roof),
        plain("#cfe3ee", 0.05, 20),
    )
    asm.add(
        "lamp",
        box(0.05, 0.03, 0.03, (back + 0.12, inner - 0.017, ice - 0.06), glowing("#fffdf0"), 0.004),
    )
    levels = [floor, floor + 0.19, floor + 0.36]
    supports = [surface("top", (x0, -half), (front_x, half), height)]
    supports += _shelves(asm, (back, depth), (-inner, inner), levels, ice, "inside")
    center = ((back + depth) / 2, 0.0, (ice + floor) / 2)
    containers = [
        Container("inside", center, (depth - back, 2 * inner, ice - floor), "body", "door")
    ]
    z = (foot + 0.003, height - 0.026)
    _leaf(asm, "door", front_x, (-half + 0.001, half - 0.001), z, shell, liner, seal)
    _racks(
        asm,
        "door",
        front_x - 0.006,
        (-half + 0.07, half - 0.07),
        (0.14, 0.42),
        plain("#f2f6f6", 0.01),
    )
    outer = front_x + 0.055
    bar_handle(
        asm,
        "door",
        outer,
        -half + 0.045,
        0.66,
        0.2,
        plain("#4a4e52", 0.05),
        reach=0.04,
        radius=0.01,
    )
    badge = (outer - 0.003, 0.06, 0.74), (outer + 0.003, 0.2, 0.77)
    asm.board("door", *badge, dark, solid=False, weight=2.0)
    tone = "steel" if colour == "steel" else "white"
    return _finished(
        asm,
        f"small {tone} fridge, under-counter",
        30.0,
        {"door": hinge(outer, half)},
        supports,
        containers,
    )
