"""Kitchen wall cabinets, as wide as the counters below, and one whose door lifts up."""

from __future__ import annotations

import numpy as np
from toolkit.model import Container, Joint, Maker, Model
from toolkit.sampling import noise_offset, pick

from .joinery import (
    Assembly,
    carcass,
    finish,
    hinge,
    open_closed,
    surface,
)
from .kitchen_suites import DOOR, FIRST, FURTHER, STYLES, SUITES, Offset, leaf, named, pull

DEPTH, T = 0.33, 0.018


def wall_cabinet(
    width: float = 0.6,
    height: float = 0.7,
    suite: str = "white_shaker",
    lift: bool = False,
    offset: Offset = (0, 0, 0),
) -> Model:
    """A cabinet to hang on a wall; up to 0.6 m one door, beyond that two with a partition.

    lift: one door across the width, hinged at its upper edge.
    """
    look, asm, half = SUITES[suite], Assembly(), width / 2
    back, case_front = -DEPTH / 2, DEPTH / 2 - 0.02
    fronts, case = finish(look["front"], 2, offset), finish(look["case"], 2, offset)
    carcass(asm, "body", (back, -half, 0), (case_front, half, height), fronts, case)
    single = lift or width <= 0.6
    bays = {"": (-half, half)} if single else {"_left": (-half, 0.0), "_right": (0.0, half)}
    if not single:
        asm.board(
            "body", (back, -0.009, T), (case_front, 0.009, height - T), case, labels={"+x": fronts}
        )
    joints, states, containers, settings = {}, [], [], {}
    supports = [surface("top", (back, -half), (case_front, half), height)]
    outer = case_front + DOOR
    shelves = 0 if lift else 1
    levels = [T] + [height * (k + 1) / (shelves + 1) for k in range(shelves)]
    for suffix, (y0, y1) in bays.items():
        door, inside = f"door{suffix}", f"inside{suffix}"
        right_hung = suffix != "_left"
        a, b = y0 + T * (1 if y0 == -half else 0.5), y1 - T * (1 if y1 == half else 0.5)
        for z in levels[1:]:
            asm.board("body", (back + 0.008, a, z - T), (case_front - 0.02, b, z), case)
        face, z = (y0 + 0.002, y1 - 0.002), (0.002, height - 0.002)
        leaf(asm, door, case_front, face, z, look, fronts)
        if lift:
            pull(asm, door, look, (outer, 0.0, 0.05), 0.3, False, (0.0, z[0]))
            joints[door] = Joint("revolute", (outer, 0.0, height), (0, -1, 0), 0.0, 1.6)
        else:
            handle_y = y0 + 0.04 if right_hung else y1 - 0.04
            pull(asm, door, look, (outer, handle_y, 0.12), 0.14, True, (sum(face) / 2, z[0]))
            joints[door] = hinge(outer, y1 if right_hung else y0)
        states += open_closed(door, door)
        settings[door] = {"joint": door}
        low, high = (back + 0.01, a), (case_front - 0.02, b)
        for k, z0 in enumerate(levels):
            name = f"{inside}_floor" if k == 0 else f"{inside}_shelf{f'_{k}' if k > 1 else ''}"
            above = levels[k + 1] - T if k + 1 < len(levels) else height - T
            supports.append(surface(name, low, high, z0, above - z0, inside))
        center = ((back + case_front) / 2, (a + b) / 2, height / 2)
        size = (case_front - back - 0.02, b - a, height - 2 * T)
        containers.append(Container(inside, center, size, "body", door))
    what = "lift-up door" if lift else "one door" if single else "two doors"
    return Model(
        title=f"wall cabinet, {what}, {named(suite)} fronts",
        parts=asm.parts(**settings),
        mass=16 * width / 0.6 * (0.8 if lift else 1.0),
        joints=joints,
        states=states,
        supports=supports,
        containers=containers,
    )


SIZES = {"narrow": (0.4, 0.7), "one": (0.6, 0.7), "two": (0.8, 0.7), "lift": (0.8, 0.42)}


def _sized(kind: str, suite: str) -> dict:
    width, height = SIZES[kind]
    return {"width": width, "height": height, "suite": suite, "lift": kind == "lift"}


def wall_cabinet_random(rng: np.random.Generator) -> dict:
    """Parameters of a random wall cabinet."""
    return _sized(pick(rng, sorted(SIZES)), pick(rng, STYLES)) | {"offset": noise_offset(rng)}


MODELS = {
    "wall_cabinet": Maker(
        wall_cabinet,
        wall_cabinet_random,
        29,
        [
            *(_sized(kind, suite) for suite in FIRST for kind in ("one", "two")),
            *(_sized("narrow", suite) for suite in ("white_shaker", "oak_flat")),
            *(_sized("lift", suite) for suite in ("white_flat", "grey_flat")),
            *(_sized("narrow", suite) for suite in ("sage_shaker", "navy_shaker", "grey_flat")),
            *(_sized(kind, suite) for suite in FURTHER for kind in ("narrow", "one", "two")),
        ],
    ),
}
