"""Fitted kitchen: base cabinets, and what all units share. They match within a suite."""

from __future__ import annotations

import numpy as np
from toolkit.materials import Material, plain
from toolkit.model import Container, Joint, Maker, Model
from toolkit.sampling import noise_offset, pick
from toolkit.shapes import lathe, loft, rounded_rectangle, spline, tube

from .joinery import (
    Assembly,
    carcass,
    drawer_box,
    finish,
    hinge,
    open_closed,
    surface,
)
from .kitchen_suites import (
    BACK,
    CASE_FRONT,
    CASE_TOP,
    DOOR_FRONT,
    FIRST,
    FURTHER,
    PLINTH,
    STYLES,
    SUITES,
    TOP_FRONT,
    WORKTOP,
    Offset,
    leaf,
    named,
    plinth_material,
    pull,
    slab,
    worktop_material,
)


def base(
    asm: Assembly,
    width: float,
    suite: dict,
    offset: Offset,
    top: bool = True,
) -> tuple[Material, Material]:
    """Plinth and case of a base cabinet; returns the materials of fronts and case."""
    half = width / 2
    fronts = finish(suite["front"], 2, offset)
    case = finish(suite["case"], 2, offset)
    low, high = (BACK, -half, 0), (CASE_FRONT - 0.04, half, PLINTH)
    asm.board("body", low, high, plinth_material(suite))
    # Outside as the fronts: a white edge would glint through the gaps between dark ones.
    low, high = (BACK, -half, PLINTH), (CASE_FRONT, half, CASE_TOP)
    carcass(asm, "body", low, high, fronts, case, top=top)
    return fronts, case


def bay(
    asm: Assembly, y0: float, y1: float, z_top: float, case: Material, bowl_z: float | None = None
) -> tuple[list, Container]:
    """Shelf, supports and container of the space behind a door of a base cabinet; `bowl_z` is the
    underside of what hangs into it from above.
    """
    floor, middle, t = PLINTH + 0.018, 0.47, 0.018
    asm.board("body", (BACK + 0.008, y0, middle - t), (CASE_FRONT - 0.06, y1, middle), case, 0.001)
    supports = [
        surface(
            "inside_floor", (BACK + 0.01, y0), (CASE_FRONT, y1), floor, middle - t - floor, "inside"
        ),
        surface(
            "inside_shelf",
            (BACK + 0.01, y0),
            (CASE_FRONT - 0.06, y1),
            middle,
            (z_top if bowl_z is None else bowl_z) - middle,
            "inside",
        ),
    ]
    size = (CASE_FRONT - BACK - 0.01, y1 - y0, z_top - floor)
    center = ((CASE_FRONT + BACK + 0.01) / 2, (y0 + y1) / 2, (z_top + floor) / 2)
    return supports, Container("inside", center, size, "body", "door")


def _drawers(asm: Assembly, look: dict, y: tuple[float, float], rows: list, fronts, case) -> list:
    """A stack of drawers between y[0] and y[1], the top one first in `rows`; returns its records.

    rows: (name of the part or None for a dummy, lowest z, highest z).
    """
    (y0, y1), made = y, []
    for name, low_z, high_z in rows:
        part = name or "body"
        face, z = (y0 + 0.002, y1 - 0.002), (low_z, high_z)
        leaf(asm, part, CASE_FRONT, face, z, look, fronts, 0.045)
        middle, handle_z = (y0 + y1) / 2, (low_z + high_z) / 2
        at = (DOOR_FRONT, middle, handle_z)
        pull(asm, part, look, at, 0.18, False, (middle, high_z))
        if name is None:
            continue
        low = (BACK + 0.06, y0 + 0.03, low_z + 0.035)
        high = (CASE_FRONT, y1 - 0.02, high_z - 0.076)
        drawer_box(asm, name, low, high, case)
        joint = Joint("prismatic", (0.0, middle, low[2] + 0.05), (1, 0, 0), 0.0, 0.4)
        inner = (low[0] + 0.012, low[1] + 0.012), (high[0], high[1] - 0.012)
        floor = low[2] + 0.008
        room = surface(f"{name}_floor", *inner, floor, high[2] + 0.03 - floor, name, name)
        center = ((low[0] + high[0]) / 2, (low[1] + high[1]) / 2, (low[2] + high[2]) / 2 + 0.015)
        size = (0.48, high[1] - low[1] - 0.03, high[2] - low[2] + 0.01)
        made.append((name, joint, room, Container(name, center, size, name, name)))
    return made


def kitchen_counter(
    width: float = 0.6,
    suite: str = "white_shaker",
    layout: str = "door",
    offset: Offset = (0, 0, 0),
) -> Model:
    """A base cabinet; layout: one "door", two "doors", "drawers" or "wide" (both).

    In the wide one only the top drawer opens.
    """
    look, asm, half = SUITES[suite], Assembly(), width / 2
    fronts, case = base(asm, width, look, offset)
    gap, z0, z1 = 0.001, PLINTH + 0.003, CASE_TOP - 0.004
    slab(asm, (BACK, TOP_FRONT), (-half, half), worktop_material(look, offset))
    supports = [surface("top", (BACK, -half), (TOP_FRONT, half), WORKTOP)]
    joints: dict[str, Joint] = {}
    containers: list[Container] = []
    leaves: list[tuple[str, float, float, float]] = []
    drawers: list = []
    if layout == "wide":
        leaves = [("door", 0.0, half, 0.009)]
    elif layout == "door":
        leaves = [("door", -half, half, -half + 0.018)]
    elif layout == "doors":
        leaves = [("door", 0.0, half, -half + 0.018), ("door_left", -half, 0.0, 0.0)]
    if leaves:
        found, container = bay(asm, leaves[0][3], half - 0.018, CASE_TOP - 0.018, case)
        supports += found
        containers.append(container)
    for name, a, b, _ in leaves:
        face = (a + gap, b - gap)
        leaf(asm, name, CASE_FRONT, face, (z0, z1), look, fronts)
        handle = b - 0.04 if name == "door_left" else a + (0.045 if len(leaves) == 1 else 0.04)
        pull(asm, name, look, (DOOR_FRONT, handle, 0.72), 0.16, True, ((a + b) / 2, z1))
        joints[name] = hinge(DOOR_FRONT, a if name == "door_left" else b)
    if layout == "wide":
        low, high = (BACK, -0.009, PLINTH + 0.018), (CASE_FRONT, 0.009, CASE_TOP - 0.018)
        asm.board("body", low, high, case, labels={"+x": fronts})
        rows = [(None, z0, 0.355), (None, 0.359, 0.611), ("drawer", 0.615, z1)]
        drawers = _drawers(asm, look, (-half, 0.0), rows, fronts, case)
    elif layout == "drawers":
        rows = [("drawer", 0.655, z1), ("drawer_2", 0.385, 0.651), ("drawer_3", z0, 0.381)]
        drawers = _drawers(asm, look, (-half, half), rows, fronts, case)
    states = [s for name in joints for s in open_closed(name, name)]
    for name, joint, room, container in drawers:
        joints[name] = joint
        states += open_closed(name, name, 0.01, 0.15)
        supports.append(room)
        containers.append(container)
    what = {
        "door": "one door",
        "doors": "two doors",
        "wide": "door and drawers",
        "drawers": "three drawers",
    }
    title = f"kitchen counter, {what[layout]}, {named(suite)} fronts"
    return Model(
        title=title,
        parts=asm.parts(**{name: {"joint": name} for name in joints}),
        mass=28 * width / 0.6,
        joints=joints,
        states=states,
        supports=supports,
        containers=containers,
        ground_shadow=True,
    )


#: Layout and width of the counters, by name.
UNITS = {
    "narrow": ("door", 0.4),
    "door": ("door", 0.6),
    "drawers": ("drawers", 0.6),
    "doors": ("doors", 0.8),
    "wide": ("wide", 1.2),
}


def _unit(name: str, suite: str) -> dict:
    layout, width = UNITS[name]
    return {"width": width, "suite": suite, "layout": layout}


def kitchen_counter_random(rng: np.random.Generator) -> dict:
    """Parameters of a random counter."""
    unit = _unit(pick(rng, sorted(UNITS)), pick(rng, STYLES))
    return unit | {"offset": noise_offset(rng)}


def basin(
    asm: Assembly,
    centre: tuple[float, float],
    size: tuple[float, float],
    z_top: float,
    depth: float,
    mat: Material,
    rim: float = 0.026,
    radius: float = 0.05,
    wall: float = 0.012,
) -> None:
    """A hollow basin let into a surface at z_top, with a drain; collides as floor and four walls.

    The rim hides the corners of a hole of the basin's size: rim > 0.42 * radius + 3 mm.
    """
    (cx, cy), (sx, sy) = centre, size

    def ring(grow: float, z: float) -> np.ndarray:
        outline = rounded_rectangle(sx + 2 * grow, sy + 2 * grow, max(radius + grow, 0.01), 5)
        return np.c_[np.add(outline, [cx, cy]), np.full(len(outline), z)]

    floor = z_top - depth
    rings = [
        ring(-0.03, floor - 0.01),
        ring(wall, floor + 0.05),
        ring(wall, z_top - 0.002),
        ring(rim, z_top),
        ring(rim - 0.003, z_top + 0.006),
        ring(0.003, z_top + 0.006),
        ring(-0.004, z_top - 0.004),
        ring(-0.012, floor + 0.05),
        ring(-0.03, floor + 0.012),
        ring(-0.06, floor),
    ]
    asm.add("body", loft(rings, mat))
    x0, x1, y0, y1 = cx - sx / 2, cx + sx / 2, cy - sy / 2, cy + sy / 2
    asm.solid("body", (x0, y0, floor - 0.01), (x1, y1, floor))
    asm.solid("body", (x0 - wall, y0 - wall, floor), (x0, y1 + wall, z_top + 0.006))
    asm.solid("body", (x1, y0 - wall, floor), (x1 + wall, y1 + wall, z_top + 0.006))
    asm.solid("body", (x0, y0 - wall, floor), (x1, y0, z_top + 0.006))
    asm.solid("body", (x0, y1, floor), (x1, y1 + wall, z_top + 0.006))
    drain = [
        (0, floor),
        (0.026, floor),
        (0.028, floor + 0.003),
        (0.02, floor + 0.004),
        (0, floor + 0.002),
    ]
    asm.add("body", lathe(drain, 14, mat=plain("#55585b", 0.05, 40)).move(cx, cy, 0))


def tap(
    asm: Assembly, x: float, y: float, z: float, reach: float, height: float, mat: Material
) -> None:
    """A mixer tap standing at (x, y, z), its spout arching towards +X."""
    foot = [
        (0, 0),
        (0.026, 0),
        (0.026, 0.006),
        (0.018, 0.012),
        (0.017, 0.06),
        (0.013, 0.066),
        (0, 0.066),
    ]
    asm.add("body", lathe(foot, 14, mat=mat).move(x, y, z))
    arch = [
        (x, y, z + 0.06),
        (x, y, z + height * 0.75),
        (x + reach * 0.18, y, z + height * 0.97),
        (x + reach * 0.6, y, z + height),
        (x + reach * 0.95, y, z + height * 0.86),
        (x + reach, y, z + height * 0.62),
    ]
    asm.add("body", tube(spline(arch, 3), 0.011, 8, mat=mat))
    lever = tube([(0, 0, 0), (0, 0.05, 0.012), (0, 0.075, 0.03)], [0.009, 0.007, 0.006], 6, mat=mat)
    asm.add("body", lever.move(x, y, z + 0.045))
    asm.solid("body", (x - 0.02, y - 0.02, z), (x + 0.02, y + 0.02, z + height))
    asm.solid("body", (x - 0.009, y + 0.02, z + 0.036), (x + 0.009, y + 0.081, z + 0.081))


def stream(
    asm: Assembly, x: float, y: float, z_top: float, z_floor: float, r: float = 0.01
) -> None:
    """Running water, the part `water`: a stream from a spout and where it spreads on a floor."""
    water = Material(occlusion=0.15)
    fall = water.noise(60, 2, stretch=(6, 6, 0.5))
    stops = [(0.3, "#8fc4e6"), (0.5, "#c9e6f7"), (0.62, "#f4fbff")]
    water.colour(water.ramp(fall, stops))
    profile = [(0, z_top + 0.006), (r, z_top + 0.004), (1.15 * r, (z_top + z_floor) / 2)]
    profile += [(1.1 * r, z_floor + 0.03), (2.4 * r, z_floor + 0.01), (5.5 * r, z_floor + 0.006)]
    profile += [(6 * r, z_floor + 0.001), (0, z_floor + 0.001)]
    asm.add("water", lathe(profile[::-1], 12, mat=water, discs=False).move(x, y, 0))


def switched(asm: Assembly, part: str, evidence: str = "body") -> dict:
    """Variants and states of a thing whose `part` is drawn only while it is ON."""
    fixed = [name for name in asm.meshes if name != part]
    return {
        "variants": {"default": fixed, "on": [*fixed, part]},
        "states": [
            {"state": "OFF", "variants": ["default"], "parts": [evidence]},
            {"state": "ON", "variants": ["on"], "parts": [part]},
        ],
    }


# No unit with open shelves: bleach there would be within a child's reach.
MODELS = {
    "kitchen_counter": Maker(
        kitchen_counter,
        kitchen_counter_random,
        41,
        [
            *(_unit(name, suite) for suite in FIRST for name in ("door", "wide")),
            *(_unit("drawers", suite) for suite in FIRST),
            *(_unit("doors", suite) for suite in FIRST),
            *(_unit("narrow", suite) for suite in FIRST),
            *(
                _unit(name, suite)
                for suite in FURTHER
                for name in ("narrow", "door", "drawers", "doors")
            ),
        ],
    ),
}
