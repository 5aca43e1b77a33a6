"""Toasters: two slots, four, one long one, and a rounded retro one."""

from __future__ import annotations

import numpy as np
from toolkit.materials import Material, glowing, metal, plain, shade
from toolkit.model import Maker, Model, box_piece
from toolkit.sampling import noise_offset, pick
from toolkit.shapes import box, extrude, loft, rounded_rectangle

from .joinery import Assembly

Offset = tuple[float, float, float]

# form -> (x, y, z, corner radius, [(x, y) of the slots' middles], length of a slot)
FORMS = {
    "two": (0.17, 0.28, 0.185, 0.03, [(-0.035, 0), (0.035, 0)], 0.15),
    "four": (0.29, 0.3, 0.19, 0.03, [(-0.09, 0), (-0.035, 0), (0.035, 0), (0.09, 0)], 0.16),
    "long": (0.12, 0.4, 0.2, 0.035, [(0, 0)], 0.28),
    "retro": (0.2, 0.31, 0.215, 0.075, [(-0.033, 0), (0.033, 0)], 0.15),
}


def _toast(x: float, y: float, z: float) -> list:
    """A browned slice with its crust, standing in a slot along y."""
    outline = [(-0.058, 0), (0.058, 0), (0.058, 0.075), (0.066, 0.092), (0.056, 0.112)]
    outline += [(0.03, 0.12), (-0.03, 0.12), (-0.056, 0.112), (-0.066, 0.092), (-0.058, 0.075)]
    crumb = Material()
    spots = crumb.remap(crumb.noise(70, 3), 0.35, 0.65)
    crumb.colour(crumb.mix(spots, "#e0ad62", "#b97a34"))
    slab = extrude(outline, 0.017, mat=crumb, side_mat=plain("#8a5426", 0.1, 60), axis="x")
    return [slab.move(x, y, z)]


def toaster(
    form: str = "two",
    colour: str = "steel",
    trim: str = "#26282b",
    toast: bool = False,
    offset: Offset = (0, 0, 0),
) -> Model:
    """ON: the lever is down, the slots glow and a lamp is lit."""
    sx, sy, sz, r, slots, length = FORMS[form]
    asm = Assembly()
    shell = metal("c4c8cc", "7f858b", (1, 8, 1), 20) if colour == "steel" else None
    shell = shell or plain(colour, 0.02, 10, offset)
    dark, chrome = plain(trim, 0.03, 30), metal("cfd3d6", "848a90", (1, 1, 4), 30)
    round_top = 0.09 if form == "retro" else 0.028
    steps = [(0.012, 0.012), (0.0, 0.03), (0.0, sz - round_top)]
    steps += [(0.1 * round_top, sz - 0.5 * round_top), (0.35 * round_top, sz - 0.13 * round_top)]
    steps.append((0.75 * round_top, sz))
    rings = []
    for inset, z in steps:
        a, b = sx - 2 * inset * (0.6 if form == "retro" else 1), sy - 2 * inset
        outline = rounded_rectangle(a, b, min(r, 0.45 * min(a, b)), 4)
        rings.append(np.c_[outline, np.full(len(outline), z)])
    asm.add("body", loft(rings, shell))
    foot = rounded_rectangle(sx - 0.03, sy - 0.03, 0.03, 3)
    asm.add("body", extrude(foot, 0.014, mat=dark))
    hot = Material(occlusion=0.0)
    hot.colour(hot.ramp(hot.remap(hot.noise(40, 2), 0.3, 0.7), [(0, "#ff6a1c"), (1, "#ffb04a")]))
    for k, (x, y) in enumerate(slots):
        low, high = (x - 0.02, y - length / 2, sz - 0.004), (x + 0.02, y + length / 2, sz + 0.003)
        asm.board("body", low, high, chrome, 0.002, solid=False)
        mouth = (x - 0.0125, y - length / 2 + 0.007, sz), (x + 0.0125, y + length / 2 - 0.007, sz)
        top = (mouth[1][0], mouth[1][1], sz + 0.0045)
        asm.board("body", mouth[0], top, plain("#141210", 0.05), solid=False, weight=0.7)
        low = (mouth[0][0] + 0.001, mouth[0][1] + 0.001, sz + 0.002)
        high = (top[0] - 0.001, top[1] - 0.001, sz + 0.0075)
        asm.board("glow", low, high, hot, solid=False)
        if toast and (len(slots) < 3 or k % 2):
            for mesh in _toast(x, y + (0.005 if k % 2 else -0.004), sz - 0.05):
                asm.add("body", mesh)
            low, high = (x - 0.009, y - 0.06, sz), (x + 0.009, y + 0.06, sz + 0.07)
            asm.solid("body", low, high)
    # lever, dial and lamp on the right end, facing the front where the toaster is deep
    end = sy / 2
    asm.board(
        "body", (-0.006, end - 0.002, 0.05), (0.006, end + 0.002, sz - 0.05), dark, solid=False
    )
    for part, z in (("lever_up", sz - 0.07), ("lever_down", 0.06)):
        knob = box(0.05, 0.028, 0.02, (0, end + 0.014, z), dark, 0.005)
        asm.add(part, knob)
    front_x = sx / 2
    band = (front_x - 0.003, end - 0.09, 0.035), (front_x + 0.004, end - 0.03, 0.075)
    asm.board("body", *band, dark, 0.003, solid=False)
    dial = box(0.012, 0.024, 0.024, (front_x + 0.008, end - 0.072, 0.043), chrome, 0.006)
    asm.add("body", dial)
    lamp = (front_x + 0.003, end - 0.048, 0.047), (front_x + 0.009, end - 0.036, 0.063)
    asm.board("body", *lamp, plain("#5a1f16", 0.02), solid=False)
    asm.board(
        "glow",
        (lamp[0][0], lamp[0][1] - 0.002, lamp[0][2] - 0.002),
        (lamp[1][0] + 0.003, lamp[1][1] + 0.002, lamp[1][2] + 0.002),
        glowing("#ff5a22"),
        solid=False,
    )
    asm.solid("body", (-sx / 2, -sy / 2, 0), (sx / 2, sy / 2, sz))
    words = {"two": "two-slice", "four": "four-slice", "long": "long-slot", "retro": "retro"}
    parts = asm.parts(glow={"rgba": (1.5, 1.5, 1.5, 1.0)})
    parts["lever_up"].collision = [box_piece((0, end + 0.014, sz - 0.06), (0.05, 0.028, 0.02))]
    parts["lever_down"].collision = [box_piece((0, end + 0.014, 0.07), (0.05, 0.028, 0.02))]
    return Model(
        title=f"{words[form]} toaster{' with toast' if toast else ''}",
        parts=parts,
        mass={"two": 1.4, "four": 2.6, "long": 1.7, "retro": 2.1}[form],
        variants={"default": ["body", "lever_up"], "on": ["body", "lever_down", "glow"]},
        states=[
            {"state": "OFF", "variants": ["default"], "parts": ["body"]},
            {"state": "ON", "variants": ["on"], "parts": ["glow", "lever_down"]},
        ],
        texture_size=128,
    )


def toaster_random(rng: np.random.Generator) -> dict:
    """Parameters of a random toaster."""
    return {
        "form": pick(rng, sorted(FORMS)),
        "colour": pick(rng, ["steel", "#f0efe9", "#a8322c", "#2b2d30"]),
        "toast": bool(rng.random() < 0.4),
        "offset": noise_offset(rng),
    }


MODELS = {
    "toaster": Maker(
        toaster,
        toaster_random,
        8,
        [
            {"form": "two", "colour": "steel", "toast": True},
            {"form": "two", "colour": "#2d2f32", "toast": True, "trim": "#c3c7ca"},
            {"form": "four", "colour": "steel", "toast": False},
            {"form": "four", "colour": "#b03a30", "toast": False},
            {"form": "long", "colour": "#f1efe9", "toast": False},
            {"form": "long", "colour": "steel", "toast": False},
            {"form": "retro", "colour": "#9fd0c6", "toast": True, "trim": shade("#8a8f94", 0.6)},
            {"form": "retro", "colour": "#f1e3c4", "toast": True},
        ],
    ),
}
