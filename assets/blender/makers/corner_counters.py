"""Corner base units: an L round which two runs of a kitchen meet, with one worktop."""

from __future__ import annotations

import math

import numpy as np
from toolkit.model import Container, Maker, Model
from toolkit.sampling import noise_offset, pick

from .joinery import Assembly, finish, hinge, open_closed, surface
from .kitchen_suites import (
    BACK,
    CASE_FRONT,
    CASE_TOP,
    DOOR,
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

SIDE, T = 0.9, 0.018
HALF = SIDE / 2
#: Front of the case and of the worktop, from the middle of the square; both arms are alike.
CASE, TOP = CASE_FRONT - BACK - HALF, TOP_FRONT - BACK - HALF


def _blind(asm: Assembly, y: tuple[float, float], z: tuple[float, float], mat, look: dict) -> None:
    """A front that stays shut and faces +Y, before the arm along the other wall; `y` as it would
    lie before turning."""
    alone = Assembly()
    leaf(alone, "body", CASE, y, z, look, mat)
    for mesh in alone.meshes["body"]:
        asm.add("body", mesh.turn(rz=math.pi / 2))
    asm.solid("body", (-y[1], CASE, z[0]), (-y[0], CASE + DOOR, z[1]))


def corner_counter(suite: str = "white_shaker", offset: Offset = (0, 0, 0)) -> Model:
    """An L with walls at -X and -Y; the runs go on at its +X and its +Y end. The door is in the arm
    along the -X wall."""
    look, asm = SUITES[suite], Assembly()
    fronts, case = finish(look["front"], 2, offset), finish(look["case"], 2, offset)
    kick, a, inner = plinth_material(look), -HALF, CASE - 0.04
    asm.board("body", (a, a, 0), (inner, HALF, PLINTH), kick)
    asm.board("body", (inner, a, 0), (HALF, inner, PLINTH), kick)
    # case: floor and roof of both arms, two backs, the two ends where neighbours stand
    edges = {"+x": fronts, "+y": fronts}
    for z in ((PLINTH, PLINTH + T), (CASE_TOP - T, CASE_TOP)):
        asm.board("body", (a, a, z[0]), (CASE, HALF, z[1]), case, labels=edges)
        asm.board("body", (CASE, a, z[0]), (HALF, CASE, z[1]), case, labels=edges)
    low, high = PLINTH + T, CASE_TOP - T
    asm.board("body", (a, a, low), (a + 0.008, HALF - T, high), case)
    asm.board("body", (a + 0.008, a, low), (HALF - T, a + 0.008, high), case)
    asm.board("body", (a, HALF - T, low), (CASE, HALF, high), fronts, labels={"-y": case})
    asm.board("body", (HALF - T, a, low), (HALF, CASE, high), fronts, labels={"-x": case})
    middle = 0.47
    asm.board("body", (a + 0.008, a + 0.008, middle - T), (CASE - 0.06, HALF - T, middle), case)
    z0, z1 = PLINTH + 0.003, CASE_TOP - 0.004
    asm.board("body", (CASE, CASE, z0), (CASE + DOOR - 0.001, CASE + DOOR - 0.001, z1), fronts)
    face = (CASE + DOOR + 0.004, HALF - 0.002)
    _blind(asm, (-face[1], -face[0]), (z0, z1), fronts, look)
    leaf(asm, "door", CASE, face, (z0, z1), look, fronts)
    at = (CASE + DOOR, face[0] + 0.045, 0.72)
    pull(asm, "door", look, at, 0.16, True, (sum(face) / 2, z1))
    # one worktop: a square in the corner and two pieces whose fronts are rounded
    along, across = worktop_material(look, offset), worktop_material(look, offset, 0)
    asm.board("body", (a, a, CASE_TOP), (TOP, TOP, WORKTOP), along)
    slab(asm, (a, TOP), (TOP, HALF), along)
    slab(asm, (a, TOP), (-HALF, -TOP), across, turned=True)
    supports = [
        surface("top", (a, a), (TOP, HALF), WORKTOP),
        surface("top_2", (TOP, a), (HALF, TOP), WORKTOP),
        surface(
            "inside_floor", (a + 0.01, a + 0.01), (CASE, HALF - T), low, middle - T - low, "inside"
        ),
        surface(
            "inside_shelf",
            (a + 0.01, a + 0.01),
            (CASE - 0.06, HALF - T),
            middle,
            high - middle,
            "inside",
        ),
    ]
    center = ((CASE + a + 0.01) / 2, (a + 0.01 + HALF - T) / 2, (low + high) / 2)
    size = (CASE - a - 0.01, SIDE - 0.01 - T, high - low)
    return Model(
        title=f"corner counter, one door, {named(suite)} fronts",
        parts=asm.parts(door={"joint": "door"}),
        mass=42.0,
        joints={"door": hinge(CASE + DOOR, HALF)},
        states=open_closed("door", "door"),
        supports=supports,
        containers=[Container("inside", center, size, "body", "door")],
        ground_shadow=True,
    )


def corner_counter_random(rng: np.random.Generator) -> dict:
    """Parameters of a random corner unit."""
    return {"suite": pick(rng, STYLES), "offset": noise_offset(rng)}


MODELS = {
    "corner_counter": Maker(
        corner_counter,
        corner_counter_random,
        len(STYLES),
        [{"suite": suite} for suite in (*FIRST, *FURTHER)],
    ),
}
