"""Front loaders with a hollow drum: washing machines, and dryers of the same build."""

from __future__ import annotations

import math

import numpy as np
from toolkit import labels
from toolkit.materials import Material, glowing, label, metal, plain
from toolkit.mesh import Mesh
from toolkit.model import Container, Joint, Maker, Model
from toolkit.sampling import noise_offset, pick
from toolkit.shapes import box, lathe, loft

from .forms import by_form
from .joinery import Assembly, open_closed, surface
from .laundry_square import square_dryer, top_loader

Offset = tuple[float, float, float]
FRONT, HEIGHT, FOOT = 0.265, 0.85, 0.015
HOLE_Z, HOLE, DRUM, RIM = 0.42, 0.168, 0.225, 0.212


def _facing(mesh: Mesh, x: float) -> Mesh:
    """Something turned about z, to face the front: its z becomes x."""
    return mesh.turn(ry=math.pi / 2).move(x, 0, HOLE_Z)


def _front_plate(half: float, z: tuple[float, float], mat: Material, n: int = 32) -> Mesh:
    """A plate with a round hole in it."""
    middle, tall = (z[0] + z[1]) / 2, (z[1] - z[0]) / 2
    rim, hole = [], []
    for i in range(n):
        c, s = math.cos(2 * math.pi * i / n), math.sin(2 * math.pi * i / n)
        hole.append((HOLE * c, HOLE_Z + HOLE * s))
        if i % (n // 4) == n // 8:
            rim.append((half * np.sign(c), middle + tall * np.sign(s)))
        else:
            t = min(half / max(abs(c), 1e-9), tall / max(abs(s), 1e-9))
            rim.append((t * c, middle + t * s))
    rings = [
        np.c_[np.full(n, x), outline]
        for x, outline in (
            (FRONT - 0.03, rim),
            (FRONT, rim),
            (FRONT, hole),
            (FRONT - 0.03, hole),
            (FRONT - 0.03, rim),
        )
    ]
    return loft(rings, mat, caps=(False, False), weight=0.8).outward()


def _drum_steel() -> Material:
    """Perforated steel."""
    m = Material()
    holes = m.remap(m.voronoi(34, randomness=0.0), 0.22, 0.3)
    shine = m.remap(m.axis(2), HOLE_Z - DRUM, HOLE_Z + DRUM)
    base = m.ramp(shine, [(0, "#c4c9cd"), (0.35, "#dfe3e6"), (0.6, "#b6bcc1"), (1, "#9fa6ac")])
    return m.colour(m.mix(holes, "#5e646a", base))


def _controls(width: int, ground: str, ink: str, words: tuple[str, str]) -> Material:
    """Brand, programme marks and display; the dial and the drawer are solid."""
    picture, draw = labels.canvas(width, 64, ground)
    labels.text(draw, words[0], (width * 0.3, 8, width * 0.47, 30), "bold", ink)
    labels.text(draw, words[1], (width * 0.3, 36, width * 0.45, 52), "sans", ink)
    for k in range(10):
        a = math.pi * (0.75 + 1.5 * k / 9)
        x, y = width * 0.55 + 27 * math.cos(a), 32 + 27 * math.sin(a)
        draw.ellipse((x - 2, y - 2, x + 2, y + 2), fill=ink)
    draw.rectangle((width * 0.67, 14, width * 0.82, 48), fill="#10181a")
    labels.text(draw, "1:15", (width * 0.68, 17, width * 0.81, 45), "bold", "#3f5d58")
    for k in range(3):
        x = width * (0.86 + 0.045 * k)
        draw.ellipse((x, 26, x + 9, 35), outline=ink, width=2)
    return label(picture)


def lit_display(asm: Assembly, x: float, y: tuple, z: tuple, words: str = "1:15") -> None:
    """The part `display`: what glows while the machine runs."""
    picture, draw = labels.canvas(120, 60, "#0c3a36")
    labels.text(draw, words, (8, 6, 112, 54), "bold", "#b8fff0")
    face = {"+x": label(picture, occlusion=0.0)}
    low, high = (x, y[0], z[0]), (x + 0.006, y[1], z[1])
    asm.board("display", low, high, glowing("#3fd0b4"), 0, face, 2.5, solid=False)


def front_loader(
    kind: str = "washer",
    colour: str = "#f3f4f3",
    ring: str = "#c9ced2",
    ink: str = "#3c4347",
    back: float = -0.29,
    offset: Offset = (0, 0, 0),
) -> Model:
    """60 cm wide: round door with a window, drum, dial and a drawer; kind: "washer" or "dryer".

    ON: the display is lit. back: where the rear is; nearer to 0 for a slim one.
    """
    asm, half, t = Assembly(), 0.295, 0.03
    dryer = kind == "dryer"
    shell, dark = plain(colour, 0.015, 6, offset), plain("#2a2c2e", 0.05)
    panel_z, plate_z = 0.725, 0.1
    for x in (back + 0.05, FRONT - 0.06):
        for y in (-half + 0.05, half - 0.05):
            foot = lathe([(0, 0), (0.022, 0), (0.022, 0.02), (0, 0.02)], 8, mat=dark)
            asm.add("body", foot.move(x, y, 0), solid=True)
    asm.board("body", (back, -half, FOOT), (FRONT - t, -half + t, HEIGHT - t), shell, weight=0.5)
    asm.board("body", (back, half - t, FOOT), (FRONT - t, half, HEIGHT - t), shell, weight=0.5)
    asm.board(
        "body", (back, -half + t, FOOT), (back + 0.02, half - t, HEIGHT - t), shell, weight=0.3
    )
    asm.board("body", (back, -half + t, FOOT), (FRONT - t, half - t, 0.05), shell, weight=0.3)
    lid = (back, -half - 0.002, HEIGHT - t), (FRONT + 0.004, half + 0.002, HEIGHT)
    asm.board("body", *lid, shell, 0.007, segments=2, weight=0.7)
    asm.board("body", (FRONT - t, -half, FOOT), (FRONT - 0.004, half, plate_z), shell)
    flap = (FRONT - 0.01, 0.12, FOOT + 0.015), (FRONT - 0.003, 0.26, plate_z - 0.015)
    asm.board("body", *flap, shell, solid=False, weight=1.5)
    asm.add("body", _front_plate(half, (plate_z, panel_z), shell))
    for low, high in (
        ((-half, plate_z), (half, HOLE_Z - 0.15)),
        ((-half, HOLE_Z + 0.15), (half, panel_z)),
        ((-half, HOLE_Z - 0.15), (-0.155, HOLE_Z + 0.15)),
        ((0.155, HOLE_Z - 0.15), (half, HOLE_Z + 0.15)),
    ):
        asm.solid("body", (FRONT - t, *low), (FRONT, *high))
    # controls, with the drawer (for detergent, or a dryer's water) on the left
    words = ("DRYER", "8 kg warm air") if dryer else ("LAVARO", "7 kg  1400")
    face = box(
        t + 0.004,
        2 * half,
        HEIGHT - t - panel_z,
        (FRONT - t / 2 + 0.002, 0, panel_z),
        shell,
        0,
        labels={"+x": _controls(360, colour, ink, words)},
        weight=1.8,
    )
    asm.add("body", face, solid=True)
    drawer = (FRONT - 0.01, -half + 0.012, panel_z + 0.012), (FRONT + 0.008, -half + 0.17, 0.812)
    asm.board("body", *drawer, shell, 0.004, solid=False, weight=2.0)
    groove = (FRONT, -half + 0.05, panel_z + 0.01), (FRONT + 0.0095, -half + 0.13, panel_z + 0.022)
    asm.board("body", *groove, dark, solid=False, weight=2.0)
    bright = metal("c9ced2", "80878d", (1, 1, 1), 20)
    dial = [(0, 0), (0.03, 0), (0.03, 0.012), (0.026, 0.02), (0, 0.02)]
    knob = lathe(dial, 18, mat=plain(ring, 0.02, 20)).turn(ry=math.pi / 2)
    asm.add("body", knob.move(FRONT + 0.003, 0.03, 0.773))
    asm.board(
        "body",
        (FRONT + 0.022, 0.028, 0.775),
        (FRONT + 0.025, 0.032, 0.798),
        dark,
        solid=False,
        weight=2.0,
    )
    wide = 2 * half
    spots = [-half + wide * f for f in (0.675, 0.815)]
    lit_display(asm, FRONT + 0.003, tuple(spots), (0.751, 0.797))
    if dryer:  # louvres of the heat exchanger
        for k in range(5):
            low = (FRONT - 0.006, -0.25, FOOT + 0.014 + 0.013 * k)
            asm.board("body", low, (FRONT - 0.001, 0.05, low[2] + 0.006), dark, solid=False)
    # drum, gasket, and the paddle that is the flat floor inside
    deep, mouth = back + 0.07, 0.19
    cup = [(0, 0), (DRUM + 0.012, 0), (DRUM + 0.012, mouth - deep), (RIM, mouth - deep)]
    cup += [(RIM, mouth - deep - 0.006), (DRUM, mouth - deep - 0.02), (DRUM, 0.012), (0, 0.012)]
    asm.add("body", _facing(lathe(cup, 22, mat=_drum_steel(), weight=0.6), deep))
    seal = [(HOLE - 0.003, 0.0), (RIM + 0.004, -0.045), (RIM + 0.008, -0.03), (HOLE + 0.012, 0.008)]
    rubber = lathe([*seal, seal[0]], 24, mat=plain("#8b9094", 0.06, 30), discs=False, weight=0.8)
    asm.add("body", _facing(rubber, FRONT - 0.028))
    floor = HOLE_Z - DRUM + 0.028
    asm.board(
        "body", (deep + 0.014, -0.105, floor - 0.012), (mouth - 0.03, 0.105, floor), bright, 0.003
    )
    asm.solid("body", (back + 0.02, -half + t, 0.05), (mouth, half - t, floor - 0.02))
    for s in (-1, 1):
        a, b = sorted((s * 0.2, s * (half - t)))
        asm.solid("body", (back + 0.02, a, floor - 0.02), (FRONT - t, b, HOLE_Z + 0.2))
    asm.solid("body", (back + 0.02, -0.2, floor - 0.02), (deep + 0.012, 0.2, HOLE_Z + 0.2))
    # door: a ring round a bowl of glass that reaches into the mouth of the drum
    outer, inner, thick = (0.225, 0.145, 0.045) if dryer else (0.205, 0.122, 0.036)
    # turned in steps of less than a right angle, so that it unrolls into one broad strip
    section = [(inner + 0.006, 0.0), (outer - 0.006, 0.0), (outer, 0.006), (outer, 0.024)]
    section += [(outer - 0.008, 0.032), (outer - 0.03, thick), (inner + 0.02, thick)]
    section += [(inner + 0.006, 0.022), (inner, 0.01), (inner + 0.006, 0.0)]
    hoop = lathe(section, 28, mat=plain(ring, 0.015, 8, offset), discs=False, weight=1.6)
    asm.add("door", _facing(hoop, FRONT + 0.002))
    pane = Material()
    slant = pane.math("ADD", pane.axis(2), pane.math("MULTIPLY", pane.axis(1), 0.7))
    stops = [(0, "#20282f"), (0.42, "#39454e"), (0.46, "#7f909b"), (0.56, "#8fa0aa")]
    stops += [(0.6, "#3d4a54"), (0.68, "#36424b"), (1, "#5a6873")]
    pane.colour(pane.ramp(pane.remap(slant, HOLE_Z - 0.16, HOLE_Z + 0.16), stops))
    bowl = [(0, -0.085), (0.06, -0.08), (0.098, -0.055), (0.115, -0.01), (inner + 0.004, 0.006)]
    if dryer:
        bowl = [(0, -0.012), (0.05, -0.012), (0.1, -0.01), (0.13, -0.004), (inner + 0.004, 0.006)]
    bowl += [(inner + 0.004, 0.02), (0.1, 0.018), (0.05, 0.026), (0, 0.028)]
    glass = lathe(
        bowl,
        24,
        mats=[plain("#b9c3c8", 0.06, 18, offset), pane],
        mat_of_segment=[0, 0, 0, 0, 0, 1, 1, 1],
        discs=False,
        weight=1.5,
    )
    asm.add("door", _facing(glass, FRONT + 0.002))
    catch = (
        (FRONT + 0.024, outer - 0.05, HOLE_Z - 0.045),
        (FRONT + thick + 0.004, outer - 0.022, HOLE_Z + 0.045),
    )
    asm.board("door", *catch, dark, solid=False, weight=2.0)
    eight = [
        (outer * math.cos(a), HOLE_Z + outer * math.sin(a)) for a in np.arange(12) * math.pi / 6
    ]
    asm.piece("door", np.array([(x, *p) for x in (FRONT + 0.002, FRONT + thick) for p in eight]))
    reach = (deep + 0.014, mouth - 0.02)
    center = ((reach[0] + reach[1]) / 2, 0.0, floor + 0.14)
    fixed = [name for name in asm.meshes if name != "display"]
    tone = {"#f3f4f3": "white", "#7b8085": "graphite"}.get(colour, "black")
    slim = "slim " if back > -0.2 else ""
    return Model(
        title=f"{slim}{tone} {'tumble dryer' if dryer else 'washing machine'}",
        parts=asm.parts(door={"joint": "door"}, display={"rgba": (1.6, 1.6, 1.6, 1.0)}),
        variants={"default": fixed, "on": [*fixed, "display"]},
        mass=(45.0 if dryer else 65.0) - (8.0 if slim else 0.0),
        joints={"door": Joint("revolute", (FRONT + thick, -outer, HOLE_Z), (0, 0, -1), 0.0, 2.0)},
        states=[
            {"state": "OFF", "variants": ["default"], "parts": ["body"]},
            {"state": "ON", "variants": ["on"], "parts": ["display"]},
            *open_closed("door", "door"),
        ],
        supports=[
            surface("top", (back, -half), (FRONT, half), HEIGHT),
            surface("drum_floor", (reach[0], -0.1), (reach[1], 0.1), floor, 0.27, "inside"),
        ],
        containers=[Container("inside", center, (reach[1] - reach[0], 0.36, 0.28), "body", "door")],
        ground_shadow=True,
    )


WHITE = {"colour": "#f3f4f3", "ring": "#c9ced2", "ink": "#3c4347"}
GRAPHITE = {"colour": "#7b8085", "ring": "#303336", "ink": "#f0f1f2"}
BLACK = {"colour": "#2d2f32", "ring": "#b9bec2", "ink": "#e8eaeb"}


def washing_machine_random(rng: np.random.Generator) -> dict:
    """Parameters of a random washing machine."""
    return {"form": "front", "offset": noise_offset(rng), **pick(rng, [WHITE, GRAPHITE])}


def tumble_dryer_random(rng: np.random.Generator) -> dict:
    """Parameters of a random dryer."""
    return {
        "form": "front",
        "kind": "dryer",
        "offset": noise_offset(rng),
        **pick(rng, [WHITE, GRAPHITE]),
    }


MODELS = {
    "washing_machine": Maker(
        by_form("washing_machine", {"front": front_loader, "top": top_loader}),
        washing_machine_random,
        7,
        [
            {"form": "front", **WHITE},
            {"form": "front", **GRAPHITE},
            {"form": "front", **WHITE, "back": -0.125},
            {"form": "front", **BLACK, "back": -0.125},
            {"form": "top", "colour": "#f3f4f3", "width": 0.4},
            {"form": "top", "colour": "#f3f4f3", "width": 0.68},
            {"form": "top", "colour": "#8d9296", "width": 0.68},
        ],
    ),
    "tumble_dryer": Maker(
        by_form("tumble_dryer", {"front": front_loader, "square": square_dryer}),
        tumble_dryer_random,
        7,
        [
            {"form": "front", **WHITE},
            {"form": "front", **GRAPHITE},
            {"form": "square", "colour": "#f3f4f3"},
            {"form": "square", "colour": "#8d9296"},
            {"form": "square", "colour": "#f3f4f3", "compact": True},
            {"form": "square", "colour": "#2d2f32", "compact": True},
            {"form": "front", **WHITE, "back": -0.125},
        ],
    ),
}
