"""A tall larder: a door above three drawers."""

from __future__ import annotations

import numpy as np
from toolkit.materials import plain
from toolkit.model import Container, Joint, Model

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
    surface,
)

Offset = tuple[float, float, float]


def larder(
    width: float = 0.6,
    height: float = 2.0,
    depth: float = 0.56,
    wood: str = "#e7e8e6",
    offset: Offset = (0, 0, 0),
) -> Model:
    """Shelves behind a framed door, three drawers below."""
    asm, half, t, plinth = Assembly(), width / 2, 0.018, 0.1
    back, case_front, split = -depth / 2, depth / 2 - 0.018, 0.86
    outside, metal = finish(wood, 2, offset), steel()
    inside = finish("#efede8" if wood.startswith("#") else "birch", 2, offset)
    kick = plain("#4a4c4e", 0.04, 8)
    asm.board("body", (back, -half + 0.01, 0), (case_front - 0.03, half - 0.01, plinth), kick)
    carcass(asm, "body", (back, -half, plinth), (case_front, half, height), outside, inside, t)
    a, b = (back + 0.008, -half + t), (case_front - 0.02, half - t)
    asm.board("body", (*a, split - t), (case_front, half - t, split), inside)
    supports = [surface("top", (back, -half), (case_front, half), height)]
    roof = height - t
    levels = [float(z) for z in np.linspace(split, roof, 5)[:4]]
    for k, z in enumerate(levels):
        if k:
            asm.board("body", (*a, z - t), (*b, z), inside, 0.001)
        above = levels[k + 1] - t if k + 1 < len(levels) else roof
        name = f"inside_shelf_{k}" if k else "inside_floor"
        supports.append(surface(name, a, b, z, above - z, "inside"))
    size = (case_front - back - 0.01, width - 2 * t, roof - split)
    center = ((back + case_front) / 2, 0.0, (split + roof) / 2)
    containers = [Container("inside", center, size, "body", "door")]
    face = (-half + 0.002, half - 0.002)
    outer = case_front + 0.018
    front(asm, "door", case_front, face, (split - 0.006, height - 0.002), outside, "shaker")
    bar_handle(asm, "door", outer, face[0] + 0.04, 1.1, 0.3, metal, reach=0.026)
    joints = {"door": hinge(outer, half)}
    states = open_closed("door", "door")
    tall = (split - 0.01 - plinth - 0.003) / 3
    for k in range(3):
        part = "drawer" if k == 2 else f"drawer_{3 - k}"
        z0 = plinth + 0.003 + k * tall
        front(asm, part, case_front, face, (z0, z0 + tall - 0.004), outside, "shaker", rail=0.045)
        bar_handle(asm, part, outer, 0, z0 + tall / 2, 0.2, metal, False, reach=0.026)
        low = (back + 0.05, -half + 0.03, z0 + 0.03)
        high = (case_front, half - 0.03, z0 + tall - 0.07)
        drawer_box(asm, part, low, high, inside)
        joints[part] = Joint("prismatic", (0, 0, z0 + tall / 2), (1, 0, 0), 0.0, 0.36)
        states += open_closed(part, part, 0.01, 0.13)
        low_y, high_y = (low[0] + 0.012, low[1] + 0.012), (high[0], high[1] - 0.012)
        floor = low[2] + 0.008
        supports.append(
            surface(f"{part}_floor", low_y, high_y, floor, high[2] + 0.03 - floor, part, part)
        )
        middle = ((low[0] + high[0]) / 2, 0.0, (low[2] + high[2]) / 2 + 0.01)
        room = (high[0] - low[0] - 0.03, high[1] - low[1] - 0.03, high[2] - low[2])
        containers.append(Container(part, middle, room, part, part))
    tone = "painted" if wood.startswith("#") else wood
    return Model(
        title=f"tall larder cupboard, {tone}, door above drawers",
        parts=asm.parts(**{name: {"joint": name} for name in joints}),
        mass=62.0,
        joints=joints,
        states=states,
        supports=supports,
        containers=containers,
        ground_shadow=True,
    )
