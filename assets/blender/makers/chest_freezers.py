"""Chest freezers, opened from above."""

from __future__ import annotations

from toolkit import labels
from toolkit.materials import Material, label, plain
from toolkit.model import Container, Joint, Model
from toolkit.shapes import tube

from .fridges import LINER
from .joinery import SHOWS, Assembly, surface

Offset = tuple[float, float, float]


def chest_freezer(width: float = 0.9, colour: str = "#f3f4f3", offset: Offset = (0, 0, 0)) -> Model:
    """A chest freezer: white tub, its lid hinged behind, a wire basket and frost inside."""
    asm, half, height = Assembly(), width / 2, 0.85
    x0, x1, wall, deck = -0.3, 0.3, 0.06, 0.8
    shell, dark = plain(colour, 0.02, 6, offset), plain("#2b2c2e", 0.05)
    frost = Material()
    crust = frost.remap(frost.noise(26, 4, offset=offset), 0.5, 0.62, 0, 0.6)
    frost.colour(frost.mix(crust, frost.mottle("#dfeaf1", 0.05, 60, offset), "#fdfeff"))
    asm.board("body", (x0 + 0.03, -half + 0.03, 0), (x1 - 0.03, half - 0.03, 0.04), dark)
    for a in (-half, half - wall):
        asm.board("body", (x0, a, 0.03), (x1, a + wall, deck), shell, 0.004)
    asm.board("body", (x0, -half + wall, 0.03), (x0 + wall, half - wall, deck), shell)
    asm.board("body", (x1 - wall, -half + wall, 0.03), (x1, half - wall, deck), shell, 0.004)
    asm.board("body", (x0 + wall, -half + wall, 0.03), (x1 - wall, half - wall, 0.12), shell)
    t, a, b = 0.006, half - wall, 0.12
    for low, high in (
        ((x0 + wall, -a, b), (x0 + wall + t, a, deck - 0.01)),
        ((x1 - wall - t, -a, b), (x1 - wall, a, deck - 0.01)),
        ((x0 + wall, -a, b), (x1 - wall, -a + t, deck - 0.01)),
        ((x0 + wall, a - t, b), (x1 - wall, a, deck - 0.01)),
        ((x0 + wall, -a, b), (x1 - wall, a, b + t)),
    ):
        asm.board("interior", low, high, frost, solid=False)
    lid = (x0, -half - 0.003, deck + 0.006), (x1 + 0.012, half + 0.003, height)
    asm.board("lid", *lid, shell, 0.012, segments=2)
    asm.board(
        "lid",
        (x0 + 0.05, -half + 0.05, deck - 0.008),
        (x1 - 0.05, half - 0.05, deck + 0.008),
        plain("#eef2f4", 0.02),
        0.004,
        solid=False,
    )
    asm.board(
        "lid",
        (x1 + 0.006, -0.09, deck + 0.01),
        (x1 + 0.026, 0.09, deck + 0.032),
        dark,
        0.005,
        solid=False,
    )
    picture, draw = labels.canvas(300, 60, "#dfe3e6")
    labels.text(draw, "FREEZER", (10, 8, 180, 52), "bold", "#2c5f8a")
    for k, tone in enumerate(("#3fbf5a", "#e0b030", "#d84a3a")):
        draw.ellipse((200 + 32 * k, 20, 220 + 32 * k, 40), fill=tone)
    sign = (
        (x1 - 0.002, -0.02 if width > 0.7 else -half + 0.04, 0.1),
        (x1 + 0.004, half - 0.06, 0.16),
    )
    asm.board("body", *sign, dark, 0, {"+x": label(picture)}, 2.0, solid=False)
    wire = plain("#c9d0d5", 0.03)
    low, high = (x0 + wall + 0.012, -a + 0.012, 0.56), (x1 - wall - 0.012, -a + 0.27, 0.76)
    grid = Material()
    cells = grid.remap(grid.voronoi(45, randomness=0.0), 0.25, 0.4)
    grid.colour(grid.mix(cells, "#8fa2ae", "#e4eaee"))
    asm.board("interior", low, (high[0], high[1], low[2] + 0.009), grid)
    corners = [(low[0], low[1]), (high[0], low[1]), (high[0], high[1]), (low[0], high[1])]
    for z in (0.63, high[2]):
        ring = [(x, y, z) for x, y in corners]
        asm.add("interior", tube(ring, 0.005, 4, closed=True, mat=wire))
    for k in range(6):
        x = low[0] + (high[0] - low[0]) * k / 5
        for y in (low[1], high[1]):
            asm.add("interior", tube([(x, y, low[2]), (x, y, high[2])], 0.004, 4, mat=wire))
    asm.solid("interior", (low[0], high[1] - 0.006, low[2]), high)
    floor = b + t
    supports = [
        surface("top", (x0, -half), (x1, half), height, part="lid"),
        surface(
            "inside_floor",
            (x0 + wall + t, high[1] + 0.01),
            (x1 - wall - t, a - t),
            floor,
            0.6,
            "inside",
        ),
        surface("basket", low[:2], high[:2], low[2] + 0.009, 0.2, "inside", margin=0.02),
    ]
    center = ((x0 + x1) / 2, 0.0, (floor + deck) / 2)
    size = (x1 - x0 - 2 * wall - 0.02, 2 * a - 0.02, deck - floor - 0.02)
    return Model(
        title=f"{'large' if width > 0.7 else 'small'} chest freezer",
        parts=asm.parts(lid={"joint": "lid"}, interior={"rgba": LINER}),
        mass=44.0 if width > 0.7 else 32.0,
        joints={"lid": Joint("revolute", (x0, 0, height), (0, -1, 0), 0.0, 1.35)},
        states=[
            {"state": "CLOSED", "joint": "lid", "max": 0.03, "parts": ["lid"]},
            {"state": "OPEN", "joint": "lid", "min": SHOWS, "parts": ["interior", "lid"]},
        ],
        supports=supports,
        containers=[Container("inside", center, size, "body", "lid")],
        ground_shadow=True,
    )
