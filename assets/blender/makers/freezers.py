"""Upright freezers: frosted inside, shelves above, drawers below."""

from __future__ import annotations

import numpy as np
from toolkit.materials import Material, plain, shade
from toolkit.model import Container, Maker, Model
from toolkit.sampling import noise_offset, pick

from .appliances import LINER, compartment
from .chest_freezers import chest_freezer
from .designs import extend
from .joinery import SHOWS, Assembly, bar_handle, hinge, open_closed, sheet_steel, steel, surface

Offset = tuple[float, float, float]


def frosted(colour: str, offset: Offset, amount: float = 0.6) -> Material:
    """Plastic or metal under a thin, uneven coat of frost."""
    m = Material()
    crust = m.remap(m.noise(9, 5, 0.7, offset=offset), 0.42, 0.62, 0, amount)
    grain = m.remap(m.noise(90, 3, offset=offset), 0.35, 0.65, 0, 0.5)
    return m.colour(m.mix(crust, m.mix(grain, colour, shade(colour, 0.93)), "#fdfeff"))


def freezer(
    height: float = 1.4,
    width: float = 0.58,
    colour: str = "#f1f2f0",
    drawers: int = 2,
    shelves: int = 3,
    right_hung: bool = True,
    offset: Offset = (0, 0, 0),
) -> Model:
    """An upright freezer: `shelves` cold plates to put things on above `drawers` clear drawers."""
    asm, half = Assembly(), width / 2
    x0, case_front, thick, foot, wall = -0.29, 0.215, 0.05, 0.04, 0.045
    steel_look = colour == "steel"
    shell = sheet_steel(offset) if steel_look else plain(colour, 0.02, 6, offset)
    gasket, dark = plain("#8f959a", 0.03), plain("#2b2c2e", 0.05)
    liner, plate = frosted("#dfeaf1", offset), frosted("#b9cbd6", offset, 0.8)
    clear, grip = frosted("#a9cbdc", offset, 0.45), plain("#eef5f8", 0.01)
    asm.board("body", (x0 + 0.02, -half + 0.01, 0), (case_front, half - 0.01, foot), dark)
    compartment(asm, (x0, case_front), (-half, half), (foot, height), shell, liner, wall, 0.0)
    inner_y, back = half - wall - 0.008, x0 + wall + 0.006
    floor, roof, depth = foot + wall + 0.006, height - wall - 0.006, case_front - 0.045
    drawer_step = 0.21
    for k in range(drawers):
        z = floor + k * drawer_step
        low = (back + 0.002, -inner_y + 0.001, z + (0.004 if k else 0.022))
        high = (depth, inner_y - 0.006, z + drawer_step - 0.022)
        asm.board("interior", low, high, clear, 0.006)
        asm.board(
            "interior",
            (depth - 0.002, -0.1, high[2] - 0.05),
            (depth + 0.012, 0.1, high[2] - 0.028),
            grip,
            0.004,
            solid=False,
        )
    first = floor + drawers * drawer_step
    step = (roof - first) / shelves
    supports = [surface("top", (x0, -half), (case_front, half), height)]
    for k in range(shelves):
        z = first + k * step
        asm.board("interior", (back, -inner_y, z - 0.01), (depth, inner_y, z), plate)
        # the cooling pipe under the plate shows as a row of ribs along its front edge
        rim = (depth - 0.014, -inner_y, z - 0.016), (depth + 0.002, inner_y, z + 0.002)
        asm.board("interior", *rim, grip, 0.003, solid=False)
        low, high = (back + 0.01, -inner_y), (depth - 0.015, inner_y)
        supports.append(surface(f"shelf_{k + 1}", low, high, z, step - 0.018, "inside"))
    center = ((back + case_front) / 2, 0.0, (first + roof) / 2)
    size = (case_front - back - 0.01, 2 * inner_y, roof - first)
    outer, z0, z1 = case_front + thick, foot + 0.003, height - 0.002
    leaf = (case_front + 0.012, -half + 0.001, z0), (outer, half - 0.001, z1)
    asm.board("door", *leaf, shell, 0.012, segments=2)
    seal = (
        (case_front + 0.001, -half + 0.02, z0 + 0.02),
        (case_front + 0.013, half - 0.02, z1 - 0.02),
    )
    asm.board("door", *seal, gasket, solid=False, weight=0.7)
    panel = (
        (case_front - 0.012, -half + 0.055, z0 + 0.055),
        (case_front + 0.012, half - 0.055, z1 - 0.055),
    )
    asm.board("door", *panel, plain("#f4f7f8", 0.01, 6), 0.005, solid=False, weight=0.7)
    side = -1 if right_hung else 1
    length = 0.3 if height > 1.1 else 0.22
    handle = plain("#4a4e52", 0.05) if steel_look else steel()
    bar_handle(
        asm,
        "door",
        outer,
        side * (half - 0.05),
        height - 0.14 - length / 2,
        length,
        handle,
        reach=0.04,
        radius=0.01,
    )
    # a badge; much smaller marks would not get a texel of their own
    badge = (outer - 0.004, -0.05, z1 - 0.085), (outer + 0.002, 0.05, z1 - 0.06)
    asm.board("door", *badge, dark, solid=False, weight=2.5)
    return Model(
        title=f"{'steel' if steel_look else 'white'} upright freezer, {height:.2f} m",
        parts=asm.parts(door={"joint": "door"}, interior={"rgba": LINER}),
        mass=30.0 + 20 * (height - 0.85),
        joints={"door": hinge(outer, half if right_hung else -half)},
        states=[
            {"state": "CLOSED", "joint": "door", "max": 0.03, "parts": ["door"]},
            # The door alone seen from behind does not tell: the evidence is the inside.
            open_closed("door", "interior", opened=SHOWS)[1],
        ],
        supports=supports,
        containers=[Container("inside", center, size, "body", "door")],
        ground_shadow=True,
    )


def freezer_random(rng: np.random.Generator) -> dict:
    """Parameters of a random freezer."""
    tall = bool(rng.random() < 0.5)
    return {
        "height": 1.42 if tall else 0.85,
        "width": round(float(rng.uniform(0.55, 0.6)), 2),
        "colour": pick(rng, ["#f1f2f0", "steel"]),
        "drawers": 2 if tall else 1,
        "shelves": 3 if tall else 2,
        "right_hung": bool(rng.random() < 0.5),
        "offset": noise_offset(rng),
    }


MODELS = {
    "freezer": extend(
        Maker(
            freezer,
            freezer_random,
            2,
            [
                {
                    "height": 1.42,
                    "width": 0.58,
                    "colour": "#f1f2f0",
                    "drawers": 2,
                    "shelves": 3,
                    "right_hung": True,
                },
                {
                    "height": 0.86,
                    "width": 0.56,
                    "colour": "steel",
                    "drawers": 1,
                    "shelves": 2,
                    "right_hung": False,
                },
            ],
        ),
        [
            (chest_freezer, {"width": 0.95}),
            (chest_freezer, {"width": 0.57}),
            (
                freezer,
                {
                    "height": 1.42,
                    "width": 0.58,
                    "colour": "steel",
                    "drawers": 2,
                    "shelves": 3,
                    "right_hung": True,
                },
            ),
            (
                freezer,
                {
                    "height": 0.86,
                    "width": 0.56,
                    "colour": "#f1f2f0",
                    "drawers": 1,
                    "shelves": 2,
                    "right_hung": False,
                },
            ),
            (
                freezer,
                {
                    "height": 1.8,
                    "width": 0.6,
                    "colour": "#f1f2f0",
                    "drawers": 3,
                    "shelves": 4,
                    "right_hung": True,
                },
            ),
            (
                freezer,
                {
                    "height": 1.8,
                    "width": 0.6,
                    "colour": "steel",
                    "drawers": 3,
                    "shelves": 4,
                    "right_hung": True,
                },
            ),
        ],
    ),
}
