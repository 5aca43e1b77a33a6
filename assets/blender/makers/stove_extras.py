"""What tells free-standing ranges apart behind and below the hob."""

from __future__ import annotations

from toolkit import labels
from toolkit.materials import Material, label, metal, plain
from toolkit.shapes import tube

from .joinery import Assembly, steel

WIDTH, BACK, DOOR_FRONT, HOB = 0.6, -0.30, 0.285, 0.9


def extras(asm: Assembly, extra: str, enamel: Material, clock: str) -> None:
    """What tells ranges apart behind and below."""
    half = WIDTH / 2
    if extra == "lid":
        glass = Material()
        rise = glass.remap(glass.axis(2), HOB, HOB + 0.46)
        glass.colour(glass.mix(rise, "#23282c", "#343b40"))
        low, high = (BACK, -half + 0.01, HOB + 0.02), (BACK + 0.014, half - 0.01, HOB + 0.46)
        asm.board("body", low, high, glass)
        for y in (-0.24, 0.24):
            low, high = (BACK, y - 0.025, HOB), (BACK + 0.03, y + 0.025, HOB + 0.05)
            asm.board("body", low, high, steel(), 0.003)
    elif extra == "console":
        picture, draw = labels.canvas(300, 96, "#1b1d20")
        draw.rectangle((105, 22, 195, 74), fill="#0a1512")
        labels.text(draw, clock, (112, 28, 188, 68), "bold", "#46f0b4")
        for x in (40, 260):
            draw.ellipse((x - 26, 22, x + 26, 74), outline="#b9bec2", width=4)
            draw.line((x, 48, x, 26), fill="#f2f2ef", width=4)
        face = {"+x": label(picture)}
        asm.board("body", (BACK, -half, HOB), (BACK + 0.07, half, HOB + 0.22), enamel, 0.01)
        low, high = (BACK + 0.068, -half + 0.02, HOB + 0.04), (BACK + 0.074, half - 0.02, HOB + 0.2)
        asm.board("body", low, high, plain("#1b1d20", 0.02), 0, face, 1.5, solid=False)
    elif extra == "legs":
        brass = metal("d8ac4e", "8f6a26", (1, 1, 6), 40)
        rail = [(DOOR_FRONT + 0.045, y, 0.875) for y in (-0.28, 0.28)]
        asm.add("body", tube(rail, 0.009, 6, mat=brass))
        for y in (-0.26, 0.26):
            post = [(DOOR_FRONT, y, 0.875), (DOOR_FRONT + 0.045, y, 0.875)]
            asm.add("body", tube(post, 0.008, 5, mat=brass))
        asm.board("body", (BACK, -half, HOB), (BACK + 0.04, half, HOB + 0.3), enamel, 0.008)
        shelf = (BACK, -half, HOB + 0.3), (BACK + 0.14, half, HOB + 0.325)
        asm.board("body", *shelf, enamel, 0.006)
