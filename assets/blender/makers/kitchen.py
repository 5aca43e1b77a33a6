"""Fitted kitchen: base cabinets, the sink, wall cabinets. They match within a suite."""

from __future__ import annotations

import numpy as np
from toolkit.materials import Material, plain
from toolkit.model import Container, Joint, Maker, Model
from toolkit.sampling import noise_offset, pick
from toolkit.shapes import lathe, loft, rounded_rectangle, spline, tube

from .joinery import (
    Assembly,
    bar_handle,
    carcass,
    drawer_box,
    finish,
    front,
    hinge,
    open_closed,
    steel,
    stone,
    surface,
    timber,
)

SUITES = {
    "white": {"front": "#f0eee8", "style": "shaker", "case": "#f2f0ec", "top": "oak"},
    "sage": {"front": "#93a68f", "style": "slab", "case": "#efede7", "top": "stone"},
}
Offset = tuple[float, float, float]
BACK, CASE_FRONT, DOOR_FRONT, TOP_FRONT = -0.30, 0.26, 0.278, 0.284
PLINTH, CASE_TOP, WORKTOP = 0.10, 0.86, 0.90
DOOR = 0.018


def _worktop(suite: dict, offset: Offset) -> Material:
    if suite["top"] == "stone":
        return stone("#5b5d60", "#c9c7c0", offset)
    return timber(suite["top"], 1, offset)


def _base(
    asm: Assembly, width: float, suite: dict, offset: Offset, top: bool = True
) -> tuple[Material, Material]:
    """Plinth and case of a base cabinet; returns the materials of fronts and case."""
    half = width / 2
    fronts = finish(suite["front"], 2, offset)
    case = finish(suite["case"], 2, offset)
    asm.board(
        "body", (BACK, -half, 0), (CASE_FRONT - 0.04, half, PLINTH), plain("#3a3a3a", 0.04, 8)
    )
    carcass(asm, "body", (BACK, -half, PLINTH), (CASE_FRONT, half, CASE_TOP), case, case, top=top)
    return fronts, case


def _bay(
    asm: Assembly, y0: float, y1: float, z_top: float, case: Material
) -> tuple[list, Container]:
    """Shelf, supports and container of the space behind a door of a base cabinet."""
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
            z_top - middle,
            "inside",
        ),
    ]
    size = (CASE_FRONT - BACK - 0.01, y1 - y0, z_top - floor)
    center = ((CASE_FRONT + BACK + 0.01) / 2, (y0 + y1) / 2, (z_top + floor) / 2)
    return supports, Container("inside", center, size, "body", "door")


def kitchen_counter(width: float = 0.6, suite: str = "white", offset: Offset = (0, 0, 0)) -> Model:
    """A base cabinet: one door; from 1 m on also a stack of drawers, the top one of which opens."""
    look, asm, half = SUITES[suite], Assembly(), width / 2
    fronts, case = _base(asm, width, look, offset)
    metal = steel()
    asm.board(
        "body",
        (BACK, -half, CASE_TOP),
        (TOP_FRONT, half, WORKTOP),
        _worktop(look, offset),
        0.004,
        segments=2,
    )
    gap, z0, z1 = 0.002, PLINTH + 0.003, CASE_TOP - 0.004
    wide = width >= 1.0
    door_left = 0.0 if wide else -half
    inner_left = 0.009 if wide else -half + 0.018
    supports, container = _bay(asm, inner_left, half - 0.018, CASE_TOP - 0.018, case)
    supports.insert(0, surface("top", (BACK, -half), (TOP_FRONT, half), WORKTOP))
    front(
        asm,
        "door",
        CASE_FRONT,
        (door_left + gap, half - gap),
        (z0, z1),
        fronts,
        look["style"],
        DOOR,
    )
    bar_handle(asm, "door", DOOR_FRONT, door_left + 0.045, 0.72, 0.16, metal, reach=0.022)
    joints = {"door": hinge(DOOR_FRONT, half)}
    containers, states = [container], open_closed("door", "door")
    settings = {"door": {"joint": "door"}}
    if wide:
        # a partition, then three drawer fronts of which the lower two are dummies
        asm.board(
            "body", (BACK, -0.009, PLINTH + 0.018), (CASE_FRONT, 0.009, CASE_TOP - 0.018), case
        )
        rows = [(z0, 0.355), (0.359, 0.611), (0.615, z1)]
        for i, rows_z in enumerate(rows):
            part = "drawer" if i == 2 else "body"
            front(
                asm,
                part,
                CASE_FRONT,
                (-half + gap, -gap),
                rows_z,
                fronts,
                look["style"],
                DOOR,
                0.045,
            )
            handle_z = (rows_z[0] + rows_z[1]) / 2
            bar_handle(asm, part, DOOR_FRONT, -half / 2, handle_z, 0.18, metal, False, reach=0.022)
        low, high = (BACK + 0.06, -half + 0.03, 0.65), (CASE_FRONT, -0.02, 0.78)
        drawer_box(asm, "drawer", low, high, case)
        joints["drawer"] = Joint("prismatic", (0.0, -half / 2, 0.7), (1, 0, 0), 0.0, 0.4)
        settings["drawer"] = {"joint": "drawer"}
        states += open_closed("drawer", "drawer", 0.01, 0.15)
        inner = (low[0] + 0.012, low[1] + 0.012), (high[0], high[1] - 0.012)
        supports.append(surface("drawer_floor", *inner, 0.658, 0.16, "drawer", "drawer"))
        center = ((low[0] + high[0]) / 2, (low[1] + high[1]) / 2, 0.73)
        containers.append(
            Container("drawer", center, (0.48, half - 0.08, 0.14), "drawer", "drawer")
        )
    return Model(
        title=f"{suite} kitchen counter, {'door and drawers' if wide else 'one door'}",
        parts=asm.parts(**settings),
        mass=28 * width / 0.6,
        joints=joints,
        states=states,
        supports=supports,
        containers=containers,
        ground_shadow=True,
    )


def kitchen_counter_random(rng: np.random.Generator) -> dict:
    """Parameters of a random counter."""
    return {
        "width": pick(rng, [0.6, 0.6, 1.2]),
        "suite": pick(rng, sorted(SUITES)),
        "offset": noise_offset(rng),
    }


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


def sink_cabinet(
    width: float = 0.8,
    suite: str = "white",
    steel_basin: bool = True,
    offset: Offset = (0, 0, 0),
) -> Model:
    """A base cabinet with a basin and a tap on one side and free worktop on the other."""
    look, asm, half = SUITES[suite], Assembly(), width / 2
    fronts, case = _base(asm, width, look, offset, top=False)
    metal, top = steel(), _worktop(look, offset)
    sx, sy, cx = 0.36, 0.42, 0.03
    cy = half - 0.05 - sy / 2
    x0, x1, y0, y1 = (
        cx - sx / 2 - 0.002,
        cx + sx / 2 + 0.002,
        cy - sy / 2 - 0.002,
        cy + sy / 2 + 0.002,
    )
    for low, high in (
        ((BACK, -half), (TOP_FRONT, y0)),
        ((BACK, y1), (TOP_FRONT, half)),
        ((BACK, y0), (x0, y1)),
        ((x1, y0), (TOP_FRONT, y1)),
    ):
        asm.board("body", (*low, CASE_TOP), (*high, WORKTOP), top)
    bowl = metal if steel_basin else plain("#f1f1ee", 0.02, 10)
    basin(asm, (cx, cy), (sx, sy), WORKTOP, 0.17, bowl)
    tap(asm, -0.235, cy, WORKTOP, 0.2, 0.27, metal)
    gap, z = 0.002, (PLINTH + 0.003, CASE_TOP - 0.004)
    supports, container = _bay(asm, -half + 0.018, half - 0.018, WORKTOP - 0.19, case)
    front(asm, "door", CASE_FRONT, (gap, half - gap), z, fronts, look["style"], DOOR)
    front(asm, "door_left", CASE_FRONT, (-half + gap, -gap), z, fronts, look["style"], DOOR)
    bar_handle(asm, "door", DOOR_FRONT, 0.04, 0.72, 0.16, metal, reach=0.022)
    bar_handle(asm, "door_left", DOOR_FRONT, -0.04, 0.72, 0.16, metal, reach=0.022)
    supports.insert(0, surface("top", (BACK, -half), (TOP_FRONT, y0 - 0.01), WORKTOP))
    low, high = (cx - sx / 2 + 0.05, cy - sy / 2 + 0.05), (cx + sx / 2 - 0.05, cy + sy / 2 - 0.05)
    supports.append(surface("basin_floor", low, high, WORKTOP - 0.166, None, "basin"))
    bowl_space = Container("basin", (cx, cy, WORKTOP - 0.085), (sx - 0.02, sy - 0.02, 0.17))
    return Model(
        title=f"{suite} sink cabinet, {'steel' if steel_basin else 'ceramic'} basin",
        parts=asm.parts(door={"joint": "door"}, door_left={"joint": "door_left"}),
        mass=34.0,
        joints={"door": hinge(DOOR_FRONT, half), "door_left": hinge(DOOR_FRONT, -half)},
        states=open_closed("door", "door") + open_closed("door_left", "door_left"),
        supports=supports,
        containers=[container, bowl_space],
        ground_shadow=True,
    )


def sink_cabinet_random(rng: np.random.Generator) -> dict:
    """Parameters of a random sink cabinet."""
    return {
        "width": pick(rng, [0.8, 1.0]),
        "suite": pick(rng, sorted(SUITES)),
        "steel_basin": bool(rng.random() < 0.6),
        "offset": noise_offset(rng),
    }


def wall_cabinet(
    width: float = 0.6,
    height: float = 0.7,
    suite: str = "white",
    offset: Offset = (0, 0, 0),
) -> Model:
    """A cabinet to hang on a wall; up to 0.6 m one door, beyond that two with a partition."""
    look, asm, half, depth = SUITES[suite], Assembly(), width / 2, 0.33
    back, case_front = -depth / 2, depth / 2 - 0.02
    fronts, case, metal = finish(look["front"], 2, offset), finish(look["case"], 2, offset), steel()
    carcass(asm, "body", (back, -half, 0), (case_front, half, height), case, case)
    bays = {"": (-half, half)} if width <= 0.6 else {"_left": (-half, 0.0), "_right": (0.0, half)}
    if width > 0.6:
        asm.board("body", (back, -0.009, 0.018), (case_front, 0.009, height - 0.018), case)
    joints, states, containers, settings = {}, [], [], {}
    supports = [surface("top", (back, -half), (case_front, half), height)]
    t, middle, outer = 0.018, height / 2, case_front + DOOR
    for suffix, (y0, y1) in bays.items():
        door, inside = f"door{suffix}", f"inside{suffix}"
        right_hung = suffix != "_left"
        a, b = y0 + t * (1 if y0 == -half else 0.5), y1 - t * (1 if y1 == half else 0.5)
        asm.board("body", (back + 0.008, a, middle - t), (case_front - 0.02, b, middle), case)
        front(
            asm,
            door,
            case_front,
            (y0 + 0.002, y1 - 0.002),
            (0.002, height - 0.002),
            fronts,
            look["style"],
        )
        handle_y = y0 + 0.04 if right_hung else y1 - 0.04
        bar_handle(asm, door, outer, handle_y, 0.12, 0.14, metal, reach=0.022)
        joints[door] = hinge(outer, y1 if right_hung else y0)
        states += open_closed(door, door)
        settings[door] = {"joint": door}
        low, high = (back + 0.01, a), (case_front - 0.02, b)
        supports.append(surface(f"{inside}_floor", low, high, t, middle - 2 * t, inside))
        supports.append(surface(f"{inside}_shelf", low, high, middle, height - t - middle, inside))
        center = ((back + case_front) / 2, (a + b) / 2, height / 2)
        size = (case_front - back - 0.02, b - a, height - 2 * t)
        containers.append(Container(inside, center, size, "body", door))
    return Model(
        title=f"{suite} wall cabinet, {'one door' if width <= 0.6 else 'two doors'}",
        parts=asm.parts(**settings),
        mass=16 * width / 0.6,
        joints=joints,
        states=states,
        supports=supports,
        containers=containers,
    )


def wall_cabinet_random(rng: np.random.Generator) -> dict:
    """Parameters of a random wall cabinet."""
    return {
        "width": pick(rng, [0.6, 0.8]),
        "height": round(float(rng.uniform(0.65, 0.75)), 2),
        "suite": pick(rng, sorted(SUITES)),
        "offset": noise_offset(rng),
    }


MODELS = {
    "kitchen_counter": Maker(
        kitchen_counter,
        kitchen_counter_random,
        4,
        [{"width": w, "suite": s} for s in ("white", "sage") for w in (0.6, 1.2)],
    ),
    "sink_cabinet": Maker(
        sink_cabinet,
        sink_cabinet_random,
        2,
        [
            {"width": 0.8, "suite": "white", "steel_basin": True},
            {"width": 1.0, "suite": "sage", "steel_basin": False},
        ],
    ),
    "wall_cabinet": Maker(
        wall_cabinet,
        wall_cabinet_random,
        4,
        [{"width": w, "suite": s, "height": 0.7} for s in ("white", "sage") for w in (0.6, 0.8)],
    ),
}
