"""Coffee makers: a filter machine with its jug, espresso, capsules, beans to cup."""

from __future__ import annotations

import math

import numpy as np
from toolkit import labels
from toolkit.materials import Material, glowing, label, metal, plain
from toolkit.model import Maker, Model, cylinder_piece
from toolkit.sampling import noise_offset, pick
from toolkit.shapes import box, extrude, lathe, loft, rounded_rectangle, spline, tube

from .forms import by_form
from .joinery import Assembly

Offset = tuple[float, float, float]
COFFEE = "#2a1509"


def _shell(colour: str, offset: Offset) -> Material:
    if colour == "steel":
        return metal("c4c8cc", "7f858b", (1, 8, 1), 20)
    return plain(colour, 0.025, 14, offset)


def _block(asm: Assembly, low, high, mat: Material, r: float, taper: float = 0.0) -> None:
    """A box with round vertical edges, its top drawn in by `taper`; it collides."""
    (x0, y0, z0), (x1, y1, z1) = low, high
    rings = []
    for inset, z in ((0.0, z0), (0.0, z1 - 0.012), (0.002 + taper, z1 - 0.003), (0.01 + taper, z1)):
        outline = rounded_rectangle(x1 - x0 - 2 * inset, y1 - y0 - 2 * inset, r, 3)
        outline = outline + np.array([(x0 + x1) / 2, (y0 + y1) / 2])
        rings.append(np.c_[outline, np.full(len(outline), z)])
    asm.add("body", loft(rings, mat), solid=True)


def _lamp(asm: Assembly, low, high, colour: str = "#ff3b22") -> None:
    asm.board("body", low, high, plain("#4a1c16", 0.02), solid=False)
    low, high = np.subtract(low, (0, 0.003, 0.003)), np.add(high, (0.004, 0.003, 0.003))
    asm.board("light", low, high, glowing(colour), solid=False)


def _cup(asm: Assembly, x: float, y: float, z: float, colour: str, r: float = 0.03) -> None:
    """A small cup of coffee under the spout."""
    tall = r * 1.9
    outer = [(0, z), (r * 0.7, z), (r, z + tall), (r - 0.005, z + tall)]
    outer += [(r - 0.007, z + tall - 0.012), (0, z + tall - 0.012)]
    mats = [plain(colour, 0.02), plain(COFFEE, 0.1, 80)]
    asm.add("body", lathe(outer, 12, mats=mats, mat_of_segment=[0, 0, 0, 0, 1]).move(x, y, 0))


def _word(asm: Assembly, low, high, ground: str, ink: str, words: str = "COFFEE") -> None:
    picture, draw = labels.canvas(160, 48, ground)
    labels.text(draw, words, (8, 6, 152, 42), "bold", ink)
    face = {"+x": label(picture)}
    asm.board("body", low, high, plain(ground, 0.02), 0, face, 2.0, solid=False)


def _model(asm: Assembly, title: str, mass: float) -> Model:
    fixed = [name for name in asm.meshes if name != "light"]
    return Model(
        title=title,
        parts=asm.parts(light={"rgba": (1.6, 1.6, 1.6, 1.0)}),
        mass=mass,
        variants={"default": fixed, "on": [*fixed, "light"]},
        states=[
            {"state": "OFF", "variants": ["default"], "parts": ["body"]},
            {"state": "ON", "variants": ["on"], "parts": ["light"]},
        ],
        texture_size=128,
    )


def drip(colour: str = "#26282b", trim: str = "#b9bec2", offset: Offset = (0, 0, 0)) -> Model:
    """A filter machine: tank and column behind, a glass jug of coffee on the hot plate."""
    asm, shell, metal_ = Assembly(), _shell(colour, offset), _shell(trim, offset)
    _block(asm, (-0.11, -0.095, 0), (0.11, 0.095, 0.045), shell, 0.03)
    _block(asm, (-0.11, -0.095, 0.045), (-0.03, 0.095, 0.24), shell, 0.025)
    _block(asm, (-0.11, -0.095, 0.235), (0.095, 0.095, 0.33), shell, 0.03, 0.006)
    plate = [(0, 0.045), (0.07, 0.045), (0.066, 0.05), (0, 0.05)]
    asm.add("body", lathe(plate, 18, mat=plain("#3c3f42", 0.05)).move(0.032, 0, 0))
    # the jug: coffee shows dark below, clear glass above
    glass = Material()
    stops = [
        (0, "#1d0e06"),
        (0.62, "#3a1d0c"),
        (0.64, "#8a5a30"),
        (0.68, "#bccfd4"),
        (1, "#dbe8ea"),
    ]
    glass.colour(glass.ramp(glass.remap(glass.axis(2), 0.05, 0.185), stops, "LINEAR"))
    jug = [(0, 0.052), (0.05, 0.052), (0.062, 0.07), (0.066, 0.11), (0.056, 0.155)]
    jug += [(0.05, 0.185), (0, 0.185)]
    asm.add("body", lathe(jug, 18, mat=glass, discs=False, weight=1.5).move(0.032, 0, 0))
    asm.piece("body", cylinder_piece(0.064, 0.05, 0.2, 10) + np.array([0.032, 0, 0]))
    band = [(0.05, 0.165), (0.054, 0.167), (0.054, 0.187), (0.048, 0.2), (0, 0.205)]
    dark = plain("#1f2124", 0.03)
    asm.add("body", lathe(band, 16, mat=dark).move(0.032, 0, 0))
    grip = [(0.08, 0, 0.18), (0.125, 0, 0.175), (0.128, 0, 0.13), (0.095, 0, 0.085)]
    asm.add("body", tube(spline(grip, 2), 0.0085, 6, mat=dark))
    asm.board("body", (0.094, -0.06, 0.25), (0.099, 0.06, 0.315), metal_, 0.003, solid=False)
    ground, ink = ("#b9bec2", "#22252a") if trim == "#b9bec2" else ("#2b2d30", "#f0f1f1")
    _word(asm, (0.098, -0.05, 0.262), (0.102, 0.05, 0.302), ground, ink)
    asm.board("body", (0.105, 0.035, 0.01), (0.113, 0.075, 0.036), metal_, 0.003, solid=False)
    _lamp(asm, (0.11, -0.075, 0.014), (0.115, -0.05, 0.032))
    return _model(asm, "filter coffee maker with a glass jug", 1.9)


def espresso(colour: str = "steel", trim: str = "#202225", offset: Offset = (0, 0, 0)) -> Model:
    """An espresso machine: group head with a portafilter, drip tray, gauge and steam wand."""
    asm, shell, dark = Assembly(), _shell(colour, offset), plain(trim, 0.03)
    chrome = metal("d3d7da", "82888e", (1, 1, 5), 30)
    _block(asm, (-0.15, -0.13, 0.015), (0.02, 0.13, 0.31), shell, 0.02)
    _block(asm, (-0.15, -0.13, 0.23), (0.13, 0.13, 0.315), shell, 0.02)
    _block(asm, (-0.15, -0.13, 0), (0.14, 0.13, 0.05), shell, 0.02)
    slots = plain("#303336", 0.05)
    for y in np.linspace(-0.09, 0.09, 5):
        asm.board("body", (0.03, y - 0.009, 0.05), (0.125, y + 0.009, 0.054), slots, solid=False)
    head = [(0, 0.2), (0.036, 0.2), (0.036, 0.235), (0, 0.235)]
    asm.add("body", lathe(head, 12, mat=chrome).move(0.08, -0.02, 0))
    cup = [(0, 0.168), (0.02, 0.17), (0.03, 0.185), (0.033, 0.202), (0, 0.202)]
    asm.add("body", lathe(cup, 12, mat=chrome).move(0.08, -0.02, 0))
    handle = [(0.1, -0.02, 0.19), (0.15, -0.028, 0.186), (0.205, -0.038, 0.178)]
    asm.add("body", tube(handle, [0.009, 0.0125, 0.0145], 6, mat=dark))
    for y in (-0.03, -0.01):
        asm.add("body", tube([(0.08, y, 0.17), (0.08, y, 0.152)], 0.006, 6, mat=chrome))
    wand = [(0.1, 0.085, 0.24), (0.125, 0.09, 0.2), (0.13, 0.092, 0.11)]
    asm.add("body", tube(wand, 0.006, 5, mat=chrome))
    _cup(asm, 0.08, -0.02, 0.054, "#f4f3ef", 0.032)
    dial, draw = labels.canvas(64, 64, "#f4f4f1")
    draw.arc((6, 6, 58, 58), 140, 400, fill="#c8352a", width=5)
    draw.line((32, 34, 50, 18), fill="#111", width=4)
    face = [(0, 0), (0.03, 0), (0.03, 0.008), (0.026, 0.01), (0, 0.01)]
    gauge = lathe(face, 16, mats=[chrome, label(dial)], mat_of_segment=[0, 0, 0, 1], weight=2.0)
    gauge.label_uv = [
        [(0.5 + gauge.v[i][1] / 0.052, 0.5 - gauge.v[i][0] / 0.052) for i in f] for f in gauge.f
    ]
    asm.add("body", gauge.turn(ry=math.pi / 2).move(0.13, 0.0, 0.275))
    knob = [(0, 0), (0.02, 0), (0.017, 0.022), (0, 0.024)]
    for y in (-0.085,):
        asm.add("body", lathe(knob, 10, mat=dark).turn(ry=math.pi / 2).move(0.129, y, 0.275))
    _lamp(asm, (0.126, 0.06, 0.285), (0.133, 0.08, 0.3))
    _lamp(asm, (0.126, 0.09, 0.285), (0.133, 0.11, 0.3), "#5bff6a")
    for y in (-0.05,):  # a cup warming on top
        r = 0.036
        body = [(0, 0.315), (r * 0.6, 0.315), (r, 0.37), (r - 0.006, 0.37), (r * 0.5, 0.325)]
        body.append((0, 0.325))
        asm.add("body", lathe(body, 10, mat=plain("#f4f3ef", 0.02)).move(-0.05, y, 0))
    return _model(asm, "espresso machine", 6.5)


def capsule(colour: str = "#26282b", trim: str = "#c3c7cb", offset: Offset = (0, 0, 0)) -> Model:
    """A slim capsule machine: arched body, lever, a cup under the spout, a tank behind."""
    asm, shell, chrome = (
        Assembly(),
        _shell(colour, offset),
        metal("cfd3d6", "848a90", (1, 1, 4), 30),
    )
    side = [(-0.1, 0.0), (0.12, 0.0), (0.12, 0.03), (0.0, 0.035), (-0.02, 0.06), (-0.02, 0.15)]
    side += [(0.0, 0.17), (0.1, 0.172), (0.112, 0.19), (0.105, 0.225), (0.05, 0.25)]
    side += [(-0.04, 0.255), (-0.1, 0.235)]
    asm.add("body", extrude(side, 0.115, mat=shell, axis="y", bevel_width=0.008))
    asm.solid("body", (-0.1, -0.057, 0), (0.12, 0.057, 0.035))
    asm.solid("body", (-0.1, -0.057, 0.035), (-0.015, 0.057, 0.255))
    asm.solid("body", (-0.015, -0.057, 0.165), (0.112, 0.057, 0.25))
    tank = plain("#a9c4cf", 0.06, 12)
    _block(asm, (-0.17, -0.05, 0.01), (-0.1, 0.05, 0.23), tank, 0.03)
    spout = [(0, 0.148), (0.012, 0.148), (0.016, 0.175), (0, 0.175)]
    asm.add("body", lathe(spout, 10, mat=chrome).move(0.06, 0, 0))
    lever = [(0.0, -0.048, 0.25), (0.06, -0.048, 0.275), (0.115, -0.03, 0.262)]
    lever += [(0.115, 0.03, 0.262), (0.06, 0.048, 0.275), (0.0, 0.048, 0.25)]
    asm.add("body", tube(lever, 0.008, 6, mat=chrome))
    grate = plain("#3a3d40", 0.06, 40)
    asm.add("body", box(0.085, 0.09, 0.007, (0.065, 0, 0.03), grate, 0.002))
    _cup(asm, 0.06, 0, 0.037, "#f4f3ef", 0.034)
    dark = colour in ("#26282b", "#a8322c")
    _word(asm, (0.106, -0.04, 0.182), (0.113, 0.04, 0.206), colour, "#f4f4f4" if dark else "#333")
    _lamp(asm, (0.0, -0.012, 0.25), (0.024, 0.012, 0.258), "#5bff8a")
    return _model(asm, "capsule coffee machine", 2.8)


def beans(colour: str = "#2b2d30", trim: str = "#b9bec2", offset: Offset = (0, 0, 0)) -> Model:
    """A bean-to-cup machine: tall box, display, two spouts, beans in a hopper on top."""
    asm, shell = Assembly(), _shell(colour, offset)
    chrome = metal("cfd3d6", "848a90", (1, 1, 4), 30)
    _block(asm, (-0.2, -0.13, 0.0), (0.05, 0.13, 0.34), shell, 0.02)
    _block(asm, (-0.2, -0.13, 0.0), (0.17, 0.13, 0.05), shell, 0.02)
    _block(asm, (-0.2, -0.13, 0.22), (0.14, 0.13, 0.345), shell, 0.025)
    asm.board(
        "body", (0.055, -0.11, 0.05), (0.16, 0.11, 0.055), plain("#5c6165", 0.1, 60), solid=False
    )
    _block(asm, (0.07, -0.035, 0.15), (0.155, 0.035, 0.225), _shell(trim, offset), 0.015)
    for y in (-0.018, 0.018):
        asm.add("body", tube([(0.12, y, 0.152), (0.12, y, 0.138)], 0.007, 6, mat=chrome))
    _cup(asm, 0.112, 0.0, 0.055, "#f4f3ef", 0.036)
    bean = Material()
    cells = bean.voronoi(75, offset)
    bean.colour(bean.ramp(cells, [(0.05, "#7a4a26"), (0.35, "#4a2812"), (0.6, "#1f0f06")]))
    hopper = [(-0.12, -0.09), (0.06, -0.09), (0.06, 0.09), (-0.12, 0.09)]
    asm.add(
        "body", extrude(hopper, 0.045, mat=bean, side_mat=bean, bevel_width=0.012).move(0, 0, 0.345)
    )
    rim = [(-0.12, -0.09, 0.35), (0.06, -0.09, 0.35), (0.06, 0.09, 0.35), (-0.12, 0.09, 0.35)]
    asm.add("body", tube(rim, 0.007, 5, closed=True, mat=chrome))
    picture, draw = labels.canvas(160, 80, "#0e1113")
    labels.text(draw, "COFFEE", (10, 10, 150, 44), "bold", "#e9edef")
    for k in range(5):
        draw.ellipse((18 + k * 27, 54, 34 + k * 27, 70), outline="#e9edef", width=2)
    face = {"+x": label(picture)}
    low, high = (0.13, -0.08, 0.26), (0.144, 0.08, 0.33)
    asm.board("body", low, high, plain("#0e1113", 0.02), 0, face, 2.0, solid=False)
    lit, draw = labels.canvas(160, 80, "#bfe6ff")
    labels.text(draw, "COFFEE", (10, 10, 150, 44), "bold", "#0b3550")
    for k in range(5):
        draw.ellipse((18 + k * 27, 54, 34 + k * 27, 70), fill="#0b3550")
    bright = label(lit, occlusion=0.0)
    low, high = (0.138, -0.082, 0.258), (0.149, 0.082, 0.332)
    asm.board("light", low, high, glowing("#bfe6ff"), 0, {"+x": bright}, 2.0, solid=False)
    return _model(asm, "bean-to-cup coffee machine", 9.0)


def coffee_maker_random(rng: np.random.Generator) -> dict:
    """Parameters of a random coffee maker."""
    return {
        "form": pick(rng, ["drip", "espresso", "capsule", "beans"]),
        "colour": pick(rng, ["#26282b", "#f0efe9", "#a8322c"]),
        "offset": noise_offset(rng),
    }


MODELS = {
    "coffee_maker": Maker(
        by_form(
            "coffee_maker",
            {"drip": drip, "espresso": espresso, "capsule": capsule, "beans": beans},
        ),
        coffee_maker_random,
        8,
        [
            {"form": "drip", "colour": "#26282b"},
            {"form": "drip", "colour": "#efeeea", "trim": "#2b2d30"},
            {"form": "espresso", "colour": "steel"},
            {"form": "espresso", "colour": "#b23a30"},
            {"form": "capsule", "colour": "#26282b"},
            {"form": "capsule", "colour": "#a8322c"},
            {"form": "beans", "colour": "#2b2d30"},
            {"form": "beans", "colour": "steel"},
        ],
    ),
}
