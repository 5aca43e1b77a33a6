"""Kitchen sink units: a single bowl, two bowls, or a ceramic trough with an open front."""

from __future__ import annotations

import numpy as np
from toolkit.materials import Material, plain
from toolkit.model import Container, Maker, Model
from toolkit.sampling import noise_offset, pick
from toolkit.shapes import lathe

from .joinery import Assembly, hinge, open_closed, steel, surface
from .kitchen import base, basin, bay, stream, switched, tap
from .kitchen_suites import (
    BACK,
    CASE_FRONT,
    CASE_TOP,
    DOOR_FRONT,
    FIRST,
    PLINTH,
    STYLES,
    SUITES,
    TOP_FRONT,
    WORKTOP,
    Offset,
    leaf,
    named,
    pull,
    slab,
    worktop_material,
)

TAP_X, REACH, TAP_HEIGHT = -0.235, 0.2, 0.27


def _worktop_with_holes(
    asm: Assembly, half: float, x: tuple[float, float], holes: list[tuple[float, float]], mat
) -> None:
    """Boards round the holes, which run from x[0] to x[1] and each from one y to another."""
    asm.board("body", (BACK, -half, CASE_TOP), (x[0], half, WORKTOP), mat)
    if x[1] < TOP_FRONT:
        slab(asm, (x[1], TOP_FRONT), (-half, half), mat)
    edges = [-half, *(y for hole in sorted(holes) for y in hole), half]
    for a, b in zip(edges[::2], edges[1::2], strict=True):
        if x[1] < TOP_FRONT:
            asm.board("body", (x[0], a, CASE_TOP), (x[1], b, WORKTOP), mat)
        else:
            slab(asm, (x[0], TOP_FRONT), (a, b), mat)


def _trough(asm: Assembly, y0: float, y1: float, x0: float, china: Material) -> float:
    """A farmhouse sink: thick ceramic walls, its front showing; returns the height of its floor."""
    x1, z0, z1, wall = TOP_FRONT + 0.03, 0.665, WORKTOP + 0.002, 0.03
    floor = z0 + 0.035
    asm.board("body", (x0, y0, z0), (x1, y1, floor), china, 0.006)
    asm.board("body", (x1 - wall, y0, z0), (x1, y1, z1), china, 0.01, segments=2)
    asm.board("body", (x0, y0, z0), (x0 + wall, y1, z1), china, 0.006)
    for a in (y0, y1 - wall):
        asm.board("body", (x0 + 0.01, a, z0), (x1 - 0.012, a + wall, z1), china, 0.006)
    drain = [(0, floor), (0.03, floor), (0.032, floor + 0.004), (0.02, floor + 0.004)]
    drain.append((0, floor + 0.002))
    mesh = lathe(drain, 12, mat=plain("#55585b", 0.05, 40))
    asm.add("body", mesh.move((x0 + x1) / 2, (y0 + y1) / 2, 0))
    return floor


def sink_cabinet(
    width: float = 0.8,
    suite: str = "white_shaker",
    steel_basin: bool = True,
    bowls: str = "one",
    offset: Offset = (0, 0, 0),
) -> Model:
    """A base cabinet with bowl and tap on one side and free worktop on the other.

    bowls: "one", "two", or a farmhouse "trough". ON: the tap runs.
    """
    look, asm, half = SUITES[suite], Assembly(), width / 2
    fronts, case = base(asm, width, look, offset, top=False)
    metal, top = steel(), worktop_material(look, offset)
    china = plain("#f1f1ee", 0.02, 10)
    bowl = metal if steel_basin else china
    depth, sx, cx, low_top = 0.17, 0.36, 0.03, CASE_TOP
    sy = {"one": 0.42, "two": 0.36, "trough": 0.56}[bowls]
    cy = half - (0.03 if bowls == "trough" else 0.05) - sy / 2
    middles = [cy, cy - sy - 0.06] if bowls == "two" else [cy]
    x = (cx - sx / 2 - 0.002, cx + sx / 2 + 0.002)
    holes = [(y - sy / 2 - 0.002, y + sy / 2 + 0.002) for y in middles]
    floor = WORKTOP - 0.166
    if bowls == "trough":
        x = (-0.19, TOP_FRONT)
        holes = [(cy - sy / 2, cy + sy / 2)]
        _worktop_with_holes(asm, half, x, holes, top)
        for a, b in ((-half, holes[0][0]), (holes[0][1], half)):
            low, high = (CASE_FRONT, a + 0.001, 0.662), (DOOR_FRONT, b - 0.001, CASE_TOP)
            asm.board("body", low, high, fronts, 0.001)
        floor, low_top = _trough(asm, *holes[0], x[0], china), 0.66
        sx, cx, sy = 0.4, 0.06, sy - 0.06
    else:
        _worktop_with_holes(asm, half, x, holes, top)
        for y in middles:
            basin(asm, (cx, y), (sx, sy), WORKTOP, depth, bowl)
    tap(asm, TAP_X, cy, WORKTOP, REACH, TAP_HEIGHT, metal)
    stream(asm, TAP_X + REACH, cy, WORKTOP + 0.62 * TAP_HEIGHT, floor - 0.004)
    gap, z = 0.001, (PLINTH + 0.003, low_top - 0.004)
    under = None if bowls == "trough" else WORKTOP - depth - 0.012
    supports, container = bay(asm, -half + 0.018, half - 0.018, low_top - 0.03, case, under)
    leaf(asm, "door", CASE_FRONT, (gap, half - gap), z, look, fronts)
    leaf(asm, "door_left", CASE_FRONT, (-half + gap, -gap), z, look, fronts)
    handle_z = 0.72 if bowls != "trough" else 0.53
    for name, side in (("door", 1), ("door_left", -1)):
        at, lip = (DOOR_FRONT, side * 0.04, handle_z), (side * half / 2, z[1])
        pull(asm, name, look, at, 0.16, True, lip)
    free = min(a for a, _ in holes)
    supports.insert(0, surface("top", (BACK, -half), (TOP_FRONT, free - 0.008), WORKTOP))
    containers = [container]
    for k, y in enumerate(middles):
        name = f"basin_{k + 1}" if k else "basin"
        low = (cx - sx / 2 + 0.05, y - sy / 2 + 0.05)
        high = (cx + sx / 2 - 0.05, y + sy / 2 - 0.05)
        supports.append(surface(f"{name}_floor", low, high, floor, None, name))
        tall = WORKTOP - floor
        size = (sx - 0.02, sy - 0.02, tall)
        containers.append(Container(name, (cx, y, floor + tall / 2), size))
    switch = switched(asm, "water")
    joints = {"door": hinge(DOOR_FRONT, half), "door_left": hinge(DOOR_FRONT, -half)}
    states = open_closed("door", "door") + open_closed("door_left", "door_left")
    what = {"one": f"{'steel' if steel_basin else 'ceramic'} basin", "two": "two basins"}
    return Model(
        title=f"sink cabinet, {what.get(bowls, 'farmhouse sink')}, {named(suite)} fronts",
        parts=asm.parts(
            door={"joint": "door"},
            door_left={"joint": "door_left"},
            water={"rgba": (1.15, 1.15, 1.15, 1.0)},
        ),
        mass=34.0 if width < 1.1 else 46.0,
        variants=switch["variants"],
        joints=joints,
        states=switch["states"] + states,
        supports=supports,
        containers=containers,
        ground_shadow=True,
    )


def sink_cabinet_random(rng: np.random.Generator) -> dict:
    """Parameters of a random sink cabinet."""
    return {
        "width": pick(rng, [0.8, 1.0]),
        "suite": pick(rng, STYLES),
        "steel_basin": bool(rng.random() < 0.6),
        "offset": noise_offset(rng),
    }


def _one(width: float, suite: str) -> dict:
    return {"width": width, "suite": suite, "steel_basin": width < 0.9}


def _bowls(bowls: str, width: float, suite: str) -> dict:
    return {"width": width, "suite": suite, "bowls": bowls, "steel_basin": True}


MODELS = {
    "sink_cabinet": Maker(
        sink_cabinet,
        sink_cabinet_random,
        18,
        [
            _one(0.8, "white_shaker"),
            _one(1.0, "sage_shaker"),
            *(_one(0.8, suite) for suite in FIRST[1:]),
            *(_one(1.0, suite) for suite in FIRST if suite != "sage_shaker"),
            _bowls("trough", 0.8, "white_shaker"),
            _bowls("trough", 0.8, "cream_farmhouse"),
            _bowls("two", 1.2, "white_shaker"),
            _bowls("two", 1.2, "grey_flat"),
            _one(0.8, "birch_flat"),
            _one(0.8, "cream_farmhouse") | {"steel_basin": False},
            _one(0.8, "anthracite_flat"),
            _one(0.8, "white_flat"),
        ],
    ),
}
