"""Washing machines filled from above, and dryers with a square door; both hollow."""

from __future__ import annotations

import math

from toolkit import labels
from toolkit.materials import Material, glowing, label, metal, plain
from toolkit.model import Container, Joint, Model
from toolkit.shapes import lathe

from .joinery import Assembly, open_closed, surface

Offset = tuple[float, float, float]


def _shell(colour: str, offset: Offset) -> Material:
    return plain(colour, 0.02, 6, offset)


def _perforated(axis: int, centre: float, reach: float) -> Material:
    m = Material()
    holes = m.remap(m.voronoi(34, randomness=0.0), 0.22, 0.3)
    shine = m.remap(m.axis(axis), centre - reach, centre + reach)
    base = m.ramp(shine, [(0, "#b4bac0"), (0.4, "#dfe3e6"), (0.7, "#b6bcc1"), (1, "#9fa6ac")])
    return m.colour(m.mix(holes, "#5e646a", base))


def _console(asm: Assembly, x: float, half: float, z0: float, z1: float, word: str, dark) -> None:
    """Drawn controls on a strip that faces the front, and the lit part `display`."""
    width = int(900 * half)
    ink = "#e6e8ea" if dark else "#33383b"
    picture, draw = labels.canvas(width, 90, "#26292c" if dark else "#dfe2e3")
    labels.text(draw, word, (16, 22, width * 0.42, 70), "bold", ink)
    for k in range(9):
        a = math.pi * (0.75 + 1.5 * k / 8)
        x_, y_ = width * 0.53 + 38 * math.cos(a), 45 + 38 * math.sin(a)
        draw.ellipse((x_ - 3, y_ - 3, x_ + 3, y_ + 3), fill=ink)
    draw.rectangle((width * 0.66, 20, width * 0.84, 70), fill="#10181a")
    for k in range(2):
        draw.ellipse(
            (width * 0.88, 20 + k * 30, width * 0.88 + 18, 38 + k * 30), outline=ink, width=3
        )
    face = {"+x": label(picture)}
    low, high = (x - 0.006, -half + 0.012, z0), (x + 0.002, half - 0.012, z1)
    asm.board("body", low, high, plain("#3a3d40", 0.03), 0, face, 2.0, solid=False)
    span, tall = 2 * half - 0.024, z1 - z0
    y = [-half + 0.012 + span * f for f in (0.665, 0.835)]
    lit, draw = labels.canvas(120, 60, "#0c3a36")
    labels.text(draw, "0:45", (8, 6, 112, 54), "bold", "#b8fff0")
    low, high = (x, y[0], z0 + 0.24 * tall), (x + 0.007, y[1], z0 + 0.76 * tall)
    glow = {"+x": label(lit, occlusion=0.0)}
    asm.board("display", low, high, glowing("#3fd0b4"), 0, glow, 2.5, solid=False)
    dial = [(0, 0), (0.026, 0), (0.023, 0.02), (0, 0.022)]
    knob = lathe(dial, 14, mat=metal("c9ced2", "80878d", (1, 1, 1), 20)).turn(ry=math.pi / 2)
    asm.add("body", knob.move(x + 0.001, -half + 0.012 + span * 0.53, (z0 + z1) / 2))


def _switching(asm: Assembly) -> tuple[dict, list]:
    fixed = [name for name in asm.meshes if name != "display"]
    states = [
        {"state": "OFF", "variants": ["default"], "parts": ["body"]},
        {"state": "ON", "variants": ["on"], "parts": ["display"]},
        *open_closed("door", "door"),
    ]
    return {"default": fixed, "on": [*fixed, "display"]}, states


def top_loader(colour: str = "#f3f4f3", width: float = 0.68, offset: Offset = (0, 0, 0)) -> Model:
    """A machine with its lid on top: slim and European, or broad with an upright console."""
    asm, half, broad = Assembly(), width / 2, width > 0.5
    shell, dark = _shell(colour, offset), plain("#2a2c2e", 0.05)
    x0, x1, height, wall = -0.3, 0.3, 0.9, 0.03
    deck = 0.1 if broad else 0.13  # of the top, behind the lid
    for a in (-half, half - wall):
        asm.board("body", (x0, a, 0.02), (x1, a + wall, height), shell, 0.006)
    asm.board("body", (x1 - wall, -half + wall, 0.02), (x1, half - wall, height), shell, 0.004)
    asm.board("body", (x0, -half + wall, 0.02), (x0 + wall, half - wall, height), shell)
    asm.board("body", (x0 + wall, -half + wall, 0.02), (x1 - wall, half - wall, 0.2), shell)
    asm.board("body", (x0, -half, height - 0.03), (x0 + deck, half, height), shell, 0.004)
    asm.board("body", (x0 + 0.02, -half + 0.02, 0), (x1 - 0.03, half - 0.02, 0.022), dark)
    # tub rim and drum: open above, with an agitator
    r, floor = min(half - wall - 0.012, 0.235), 0.2005
    cx = 0.02 + (0.02 if broad else 0.0)
    # its floor as good as level with that of the case, which shows where nobody sees the drum's
    drum = [(0, 0.19), (r, 0.19), (r, height - 0.06), (r - 0.006, height - 0.06)]
    drum += [(r - 0.012, height - 0.09), (r - 0.012, floor), (0, floor)]
    perforated = _perforated(1, 0.0, r)
    asm.add("body", lathe(drum, 22, mat=perforated, weight=0.6).move(cx, 0, 0))
    collar = (x0 + deck, -half + wall, height - 0.062), (cx - r + 0.02, half - wall, height - 0.05)
    asm.board("body", *collar, dark, solid=False)
    for low, high in (
        ((cx + r - 0.02, -half + wall), (x1 - wall, half - wall)),
        ((cx - r + 0.02, -half + wall), (cx + r - 0.02, -r + 0.012)),
        ((cx - r + 0.02, r - 0.012), (cx + r - 0.02, half - wall)),
    ):
        asm.board("body", (*low, height - 0.062), (*high, height - 0.05), dark, solid=False)
    if broad:
        fin = [(0, 0.21), (0.075, 0.212), (0.05, 0.3), (0.04, 0.55), (0.03, 0.62), (0, 0.625)]
        ribs = lathe(fin, 12, mat=plain("#dfe4e8", 0.03), rib=lambda k, i: 1 if i % 3 else 1.3)
        asm.add("body", ribs.move(cx, 0, 0))
        asm.solid("body", (cx - 0.04, -0.04, 0.21), (cx + 0.04, 0.04, 0.62))
    asm.solid("body", (x0 + wall, -half + wall, 0.06), (x1 - wall, half - wall, floor))
    # lid, hinged behind
    lid = (
        (x0 + deck + 0.002, -half + 0.012, height - 0.022),
        (x1 - 0.01, half - 0.012, height + 0.012),
    )
    asm.board("door", *lid, shell, 0.008, segments=2)
    grip = (x1 - 0.02, -0.07, height - 0.008), (x1 + 0.008, 0.07, height + 0.006)
    asm.board("door", *grip, dark if broad else shell, 0.003, solid=False)
    if broad:
        glass = Material()
        slant = glass.math("ADD", glass.axis(0), glass.math("MULTIPLY", glass.axis(1), 0.6))
        stops = [
            (0, "#2a333a"),
            (0.45, "#46535c"),
            (0.5, "#91a2ac"),
            (0.6, "#54626c"),
            (1, "#303a42"),
        ]
        glass.colour(glass.ramp(glass.remap(slant, -0.3, 0.4), stops))
        pane = (
            (x0 + deck + 0.07, -half + 0.1, height + 0.008),
            (x1 - 0.08, half - 0.1, height + 0.015),
        )
        asm.board("door", *pane, glass, solid=False)
    top = 1.07 if broad else 0.9
    if broad:
        asm.board("body", (x0, -half, height), (x0 + 0.09, half, top), shell, 0.012, segments=2)
        _console(asm, x0 + 0.091, half, height + 0.035, top - 0.02, "WASHER", colour != "#f3f4f3")
    else:
        _console(asm, x1 + 0.001, half, 0.76, 0.85, "WASH", False)
    lid_top = height + (0.015 if broad else 0.012)
    joint = Joint("revolute", (x0 + deck + 0.002, 0, height + 0.012), (0, -1, 0), 0.0, 1.6)
    variants, states = _switching(asm)
    inner = 0.62 * r
    # beside the agitator where there is one
    low, high = (
        ((cx + 0.05, -inner), (cx + inner + 0.05, inner))
        if broad
        else ((cx - inner, -inner), (cx + inner, inner))
    )
    center = ((low[0] + high[0]) / 2, 0.0, floor + 0.3)
    tone = "white" if colour == "#f3f4f3" else "grey"
    return Model(
        title=f"{tone} top-loading washing machine{'' if broad else ', slim'}",
        parts=asm.parts(door={"joint": "door"}, display={"rgba": (1.6, 1.6, 1.6, 1.0)}),
        mass=68.0 if broad else 58.0,
        variants=variants,
        joints={"door": joint},
        states=states,
        supports=[
            surface("drum_floor", low, high, floor, 0.6, "inside"),
            surface("top", lid[0][:2], lid[1][:2], lid_top, part="door", margin=0.02),
        ],
        containers=[
            Container("inside", center, (high[0] - low[0], high[1] - low[1], 0.58), "body", "door")
        ],
        ground_shadow=True,
    )


def square_dryer(
    colour: str = "#f3f4f3", compact: bool = False, offset: Offset = (0, 0, 0)
) -> Model:
    """A dryer with a square door in front; console on top, or compact with its controls above."""
    asm = Assembly()
    half, depth, height = (0.3, 0.46, 0.68) if compact else (0.33, 0.6, 0.9)
    shell, dark = _shell(colour, offset), plain("#2a2c2e", 0.05)
    x0, x1, wall = -depth / 2, depth / 2 - 0.02, 0.03
    top = height if compact else 1.07
    opening_y = 0.2 if compact else 0.22
    z0, z1 = (0.14, 0.52) if compact else (0.3, 0.74)
    low_z, high_z = z0 - 0.06, z1 + 0.06
    asm.board("body", (x0 + 0.02, -half + 0.02, 0), (x1 - 0.03, half - 0.02, 0.03), dark)
    for a in (-half, half - wall):
        asm.board("body", (x0, a, 0.025), (x1, a + wall, height), shell, 0.004)
    asm.board("body", (x0, -half + wall, 0.025), (x0 + wall, half - wall, height), shell)
    asm.board("body", (x0, -half + wall, height - 0.03), (x1, half - wall, height), shell, 0.002)
    under = (z0 + z1) / 2 - min(half - wall - 0.02, (z1 - z0) / 2 + 0.06) - 0.012
    low, high = (x0 + wall, -half + wall, 0.025), (x1 - 0.029, half - wall, under)
    asm.board("body", low, high, shell)
    for low, high in (
        ((-half + wall, 0.025), (half - wall, z0)),
        ((-half + wall, z1), (half - wall, height - 0.03)),
        ((-half + wall, z0), (-opening_y, z1)),
        ((opening_y, z0), (half - wall, z1)),
    ):
        asm.board("body", (x1 - 0.03, *low), (x1, *high), shell)
    # the drum
    middle, r = (z0 + z1) / 2, min(half - wall - 0.02, (z1 - z0) / 2 + 0.06)
    deep = x0 + 0.06
    mouth = x1 - 0.034
    cup = [(0, 0), (r + 0.01, 0), (r + 0.01, mouth - deep), (r, mouth - deep)]
    cup += [(r, 0.01), (0, 0.01)]
    steel_ = _perforated(2, middle, r)
    asm.add(
        "body", lathe(cup, 22, mat=steel_, weight=0.6).turn(ry=math.pi / 2).move(deep, 0, middle)
    )
    floor = middle - r + 0.03
    bright = metal("c9ced2", "80878d", (1, 1, 1), 20)
    low = (deep + 0.012, -0.11, floor - 0.012)
    asm.board("body", low, (mouth - 0.02, 0.11, floor), bright, 0.003)
    asm.solid("body", (x0 + wall, -half + wall, 0.06), (mouth, half - wall, floor - 0.012))
    # the door: square leaf, with a round window on the compact one
    y, outer = opening_y + 0.05, x1 + 0.03
    leaf = (x1 + 0.001, -y, low_z), (outer, y, high_z)
    asm.board("door", *leaf, shell, 0.012, segments=2)
    rim = (x1 - 0.02, -opening_y + 0.012, z0 + 0.012), (x1 + 0.002, opening_y - 0.012, z1 - 0.012)
    asm.board("door", *rim, bright, 0.004, solid=False)
    if compact:
        pane = Material()
        slant = pane.math("ADD", pane.axis(2), pane.math("MULTIPLY", pane.axis(1), 0.7))
        stops = [(0, "#20282f"), (0.42, "#39454e"), (0.46, "#7f909b"), (0.56, "#3d4a54")]
        stops.append((1, "#5a6873"))
        pane.colour(pane.ramp(pane.remap(slant, middle - 0.16, middle + 0.16), stops))
        ring = [(0, 0), (0.16, 0), (0.155, 0.014), (0.13, 0.018), (0.125, 0.012), (0, 0.012)]
        mats = [plain("#c3c8cc", 0.02), pane]
        mesh = lathe(ring, 24, mats=mats, mat_of_segment=[0, 0, 0, 0, 1], weight=1.3)
        asm.add("door", mesh.turn(ry=math.pi / 2).move(outer - 0.002, 0, middle))
    else:
        panel = (outer - 0.004, -y + 0.05, low_z + 0.05), (outer + 0.006, y - 0.05, high_z - 0.05)
        asm.board("door", *panel, shell, 0.005, solid=False)
    grip = (outer - 0.004, y - 0.075, middle - 0.07), (outer + 0.016, y - 0.045, middle + 0.07)
    asm.board("door", *grip, dark, 0.004, solid=False)
    painted_dark = colour != "#f3f4f3"
    if compact:
        _console(asm, x1 + 0.001, half, height - 0.09, height - 0.015, "DRYER", painted_dark)
    else:
        asm.board("body", (x0, -half, height), (x0 + 0.09, half, top), shell, 0.012, segments=2)
        _console(asm, x0 + 0.091, half, height + 0.035, top - 0.02, "DRYER", painted_dark)
    for k in range(5):  # louvres
        z = 0.05 + 0.016 * k
        y0 = -0.2 if compact else -0.24
        asm.board("body", (x1 - 0.002, y0, z), (x1 + 0.004, -y0, z + 0.007), dark, solid=False)
    variants, states = _switching(asm)
    reach = (deep + 0.012, mouth - 0.01)
    size = (reach[1] - reach[0], 0.34, 2 * r - 0.12)
    center = ((reach[0] + reach[1]) / 2, 0.0, floor + size[2] / 2)
    free = (x0 + (0.0 if compact else 0.1), -half), (x1, half)
    tone = {"#f3f4f3": "white", "#2d2f32": "black"}.get(colour, "grey")
    return Model(
        title=f"{tone} {'compact ' if compact else ''}tumble dryer with a square door",
        parts=asm.parts(door={"joint": "door"}, display={"rgba": (1.6, 1.6, 1.6, 1.0)}),
        mass=22.0 if compact else 50.0,
        variants=variants,
        joints={"door": Joint("revolute", (outer, -y, middle), (0, 0, -1), 0.0, 2.0)},
        states=states,
        supports=[
            surface("top", *free, height),
            surface("drum_floor", (reach[0], -0.1), (reach[1], 0.1), floor, 2 * r - 0.1, "inside"),
        ],
        containers=[Container("inside", center, size, "body", "door")],
        ground_shadow=True,
    )
