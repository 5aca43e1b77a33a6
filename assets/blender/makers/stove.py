"""Free-standing ranges: four burners above an oven. Each burner can glow (variants on_1 … on_4)."""

from __future__ import annotations

import math

import numpy as np
from PIL import Image
from toolkit import labels
from toolkit.materials import Material, glowing, label, metal, plain
from toolkit.model import Container, Joint, Maker, Model
from toolkit.sampling import noise_offset, pick
from toolkit.shapes import box, lathe, tube

from .joinery import Assembly, bar_handle, open_closed, steel, surface
from .stove_extras import extras

Offset = tuple[float, float, float]
WIDTH, BACK, CASE_FRONT, DOOR_FRONT = 0.6, -0.30, 0.25, 0.285
HOB = 0.9
# (x, y, radius) of each burner: front left, front right, back left, back right
BURNERS = [(0.13, -0.145, 0.095), (0.13, 0.145, 0.08), (-0.13, -0.145, 0.08), (-0.13, 0.145, 0.095)]
GLOW = (1.7, 1.7, 1.7, 1.0)
# where the knob of each burner sits on the panel (y)
KNOBS = [-0.25, 0.25, -0.185, 0.185]


def _body(
    asm: Assembly, enamel: Material, panel: Material, digits: str, knob: Material, splash: float
) -> None:
    """Everything that the three kinds of range share: case, hollow oven, door, knobs."""
    half, dark = WIDTH / 2, plain("#26282b", 0.05, 20)
    oven = plain("#4b4d51", 0.08, 12)
    asm.board("body", (BACK + 0.02, -half + 0.02, 0), (CASE_FRONT - 0.03, half - 0.02, 0.06), dark)
    # oven: five thick walls
    z0, z1, w = 0.06, 0.745, 0.05
    asm.board("body", (BACK, -half, z0), (CASE_FRONT, -half + w, z1), enamel, 0.004, {"+y": oven})
    asm.board("body", (BACK, half - w, z0), (CASE_FRONT, half, z1), enamel, 0.004, {"-y": oven})
    asm.board("body", (BACK, -half + w, z0), (BACK + w, half - w, z1), enamel, 0, {"+x": oven})
    asm.board(
        "body", (BACK + w, -half + w, z0), (CASE_FRONT, half - w, 0.25), enamel, 0, {"+z": oven}
    )
    asm.board(
        "body", (BACK + w, -half + w, 0.68), (CASE_FRONT, half - w, z1), enamel, 0, {"-z": oven}
    )
    for z in (0.36, 0.5):
        for y in np.linspace(-half + w + 0.01, half - w - 0.01, 7):
            low, high = (BACK + w, y - 0.003, z - 0.006), (CASE_FRONT - 0.02, y + 0.003, z)
            asm.board("body", low, high, steel(), solid=False)
        low, high = (BACK + w, -half + w, z - 0.006), (CASE_FRONT - 0.02, half - w, z)
        asm.solid("body", low, high)
    # drawer front, control panel, hob slab
    asm.board(
        "body",
        (CASE_FRONT, -half + 0.002, 0.065),
        (DOOR_FRONT - 0.008, half - 0.002, 0.21),
        enamel,
        0.006,
    )
    asm.board("body", (BACK, -half, z1), (CASE_FRONT, half, HOB - 0.02), enamel, 0.003)
    face = box(0.035, WIDTH - 0.002, 0.125, (CASE_FRONT + 0.017, 0, 0.752), panel, 0.006)
    asm.add("body", face, solid=True)
    asm.board("body", (BACK, -half, HOB - 0.02), (DOOR_FRONT, half, HOB), enamel, 0.005, segments=2)
    if splash:
        asm.board("body", (BACK, -half, HOB), (BACK + 0.04, half, HOB + splash), enamel, 0.008)
    picture, draw = labels.canvas(96, 36, "#0a0c10")
    labels.text(draw, digits, (10, 4, 86, 32), "bold", "#39e6b0")
    clock = box(
        0.004,
        0.09,
        0.034,
        (DOOR_FRONT + 0.003, 0, 0.8),
        dark,
        labels={"+x": label(picture, occlusion=0.0)},
        weight=2.0,
    )
    asm.add("body", clock)
    mark = plain("#f2f2ef", 0)
    for y in (-0.25, -0.185, -0.12, 0.12, 0.185, 0.25):
        turned = [
            (0, 0),
            (0.024, 0),
            (0.024, 0.006),
            (0.019, 0.009),
            (0.017, 0.026),
            (0.013, 0.03),
            (0, 0.03),
        ]
        asm.add("body", lathe(turned, 6, mat=knob).turn(ry=math.pi / 2).move(DOOR_FRONT, y, 0.815))
        pointer = (DOOR_FRONT + 0.029, y - 0.0025, 0.815), (DOOR_FRONT + 0.032, y + 0.0025, 0.832)
        asm.board("body", *pointer, mark, solid=False)
    # oven door
    part, y = "oven_door", half - 0.003
    bottom, top = 0.216, 0.742
    asm.board(
        part, (CASE_FRONT + 0.002, -y, bottom), (DOOR_FRONT, y, top), enamel, 0.007, segments=2
    )
    window, pen = labels.canvas(128, 72, "#15181b")
    pen.polygon([(24, 72), (60, 0), (82, 0), (46, 72)], fill="#2c3238")
    pen.polygon([(54, 72), (90, 0), (96, 0), (60, 72)], fill="#242a2f")
    pen.rectangle((0, 0, 127, 71), outline="#3a3f44", width=3)
    low, high = (DOOR_FRONT - 0.004, -0.2, 0.31), (DOOR_FRONT + 0.004, 0.2, 0.58)
    asm.board(part, low, high, dark, 0.002, {"+x": label(window)}, 1.3, solid=False)
    glow, pen = labels.canvas(128, 72, "#f2b64a")
    pen.rectangle((0, 0, 127, 71), outline="#7a4a12", width=5)
    for z in (24, 48):
        pen.line((6, z, 122, z), fill="#8a5a1c", width=3)
    bright = {"+x": label(glow, occlusion=0.0)}
    low, high = (DOOR_FRONT + 0.001, -0.195, 0.315), (DOOR_FRONT + 0.0065, 0.195, 0.575)
    asm.board("oven_light", low, high, glowing("#7a4a12"), 0, bright, 1.0, solid=False)
    inner = (
        (CASE_FRONT - 0.008, -half + w + 0.006, 0.258),
        (CASE_FRONT + 0.003, half - w - 0.006, 0.672),
    )
    asm.board(part, *inner, oven, 0.002, solid=False)
    bar_handle(asm, part, DOOR_FRONT, 0, 0.68, 0.46, steel(), False, reach=0.045, radius=0.011)


def _coils(asm: Assembly) -> float:
    """Electric spirals in chrome bowls; the burner parts are the same spirals, glowing."""
    black, chrome = plain("#2a2a2c", 0.1, 60), metal("c9cdd1", "7b8187", (1, 1, 1), 30)
    # Low in their bowls, so that a pot beside one stands less than a centimetre over the enamel.
    top = HOB + 0.0115
    for k, (x, y, r) in enumerate(BURNERS, 1):
        bowl = [
            (0, HOB + 0.001),
            (r * 1.18, HOB + 0.001),
            (r * 1.2, HOB + 0.007),
            (r * 1.1, HOB + 0.009),
        ]
        bowl += [(r * 0.95, HOB + 0.005), (0, HOB + 0.005)]
        asm.add("body", lathe(bowl, 14, mat=chrome).move(x, y, 0))
        turns, per_turn = (2.6, 8) if r > 0.09 else (2.2, 8)
        t = np.linspace(0, 1, int(turns * per_turn) + 1)
        angle, radius = 2 * math.pi * turns * t, r * (0.24 + 0.74 * t)
        path = np.c_[
            x + radius * np.cos(angle), y + radius * np.sin(angle), np.full(len(t), top - 0.008)
        ]
        asm.add("body", tube(path, 0.0072, 4, mat=black, up=(0, 0, 1)))
        hot = Material(occlusion=0.0)
        heat = hot.remap(hot.distance((x, y, top)), 0, r)
        hot.colour(hot.ramp(heat, [(0, "#ffb060"), (0.45, "#ff6a22"), (1, "#ff3d0e")]))
        path[:, 2] += 0.001
        asm.add(f"burner_{k}", tube(path, 0.0088, 4, mat=hot, up=(0, 0, 1)).weigh(0.6))
        halo = Material(occlusion=0.0)
        fade = halo.remap(halo.distance((x, y, HOB)), r * 0.3, r * 1.12)
        halo.colour(halo.ramp(fade, [(0, "#e8480f"), (0.8, "#c23a10"), (1, "#5a2a1c")]))
        disc = [
            (0, HOB + 0.004),
            (r * 1.1, HOB + 0.004),
            (r * 1.1, HOB + 0.0085),
            (0, HOB + 0.0085),
        ]
        asm.add(f"burner_{k}", lathe(disc, 16, mat=halo).move(x, y, 0).weigh(0.6))
    # Coils are round on top, and what stands half beside one is over the rim of its bowl.
    carries = top - 0.0025
    asm.solid("body", (-0.24, -0.26, HOB), (0.24, 0.26, carries))
    return carries


def _zone_picture(lit: bool, induction: bool = False, size: int = 128) -> Image.Image:
    """A cooking zone from above: printed rings, or glowing heater bands."""
    y, x = np.mgrid[0:size, 0:size]
    d = np.hypot(x - size / 2 + 0.5, y - size / 2 + 0.5) / (size / 2)
    image = np.zeros((size, size, 3))
    if induction:
        image[:] = (0.07, 0.072, 0.078)
        u, v = abs(x - size / 2 + 0.5), abs(y - size / 2 + 0.5)
        cross = ((u < 2) | (v < 2)) & (d > 0.45) & (d < 0.85)
        image[cross] = (0.8, 0.82, 0.84)
        if lit:
            image[np.abs(d - 0.86) < 0.1] = (1.0, 0.28, 0.2)
            image[d < 0.35] = (0.95, 0.3, 0.2)
    elif lit:
        bands = 0.5 + 0.5 * np.cos(d * 2 * math.pi * 4.0)
        heat = np.clip(1.1 - 0.25 * d, 0, 1) * (0.42 + 0.58 * bands) * (d < 0.96)
        image = np.stack([0.2 + 0.65 * heat, 0.36 * heat**2.2, 0.07 * heat**3], -1)
        image[d >= 0.96] = (0.09, 0.05, 0.05)
    else:
        ring = (np.abs(d - 0.93) < 0.025) | (np.abs(d - 0.62) < 0.02)
        image[:] = (0.07, 0.072, 0.078)
        image[ring] = (0.42, 0.43, 0.45)
    return Image.fromarray((image.clip(0, 1) * 255).astype(np.uint8))


def _ceramic(asm: Assembly, induction: bool = False) -> float:
    """Black glass with printed zones; a lit zone shows red heater bands.

    induction: crosses mark the zones; a lit one shows a bright ring.
    """
    glass, top = plain("#131416", 0.04, 20), HOB + 0.006
    asm.board("body", (BACK + 0.045, -0.285, HOB - 0.002), (0.265, 0.285, top), glass, 0.002)
    cold = label(_zone_picture(False, induction))
    hot = label(_zone_picture(True, induction), occlusion=0.0)
    for k, (x, y, r) in enumerate(BURNERS, 1):
        for part, material, rise in (("body", cold, 0.003), (f"burner_{k}", hot, 0.007)):
            radius = r * (1.12 if part == "body" else 1.18)
            asm.add(
                part, _round_plate(x, y, radius, top - 0.004 + rise, top + rise, glass, material)
            )
    return top


def _round_plate(
    x: float, y: float, r: float, z0: float, z1: float, side: Material, face: Material
):
    """A flat disc with a picture on top (label UV over its square bounds)."""
    disc = lathe(
        [(0, z0), (r, z0), (r, z1), (0, z1)],
        28,
        mats=[side, face],
        mat_of_segment=[0, 0, 1],
        weight=1.4,
    )
    disc.label_uv = [
        [(0.5 + disc.v[i][1] / (2 * r), 0.5 - disc.v[i][0] / (2 * r)) for i in corners]
        for corners in disc.f
    ]
    return disc.move(x, y, 0)


def _gas(asm: Assembly) -> float:
    """Burner caps under cast-iron grates; lit: a crown of blue flames with warm tips."""
    iron, cap = plain("#1d1e20", 0.12, 60), metal("6b6f73", "33363a")
    ring, tray = metal("b9bdc0", "7d8286"), plain("#2a2c2f", 0.05, 20)
    base, top = HOB + 0.005, HOB + 0.045
    asm.board("body", (BACK + 0.05, -0.28, HOB - 0.002), (0.262, 0.28, base), tray, 0.001)
    for k, (x, y, r) in enumerate(BURNERS, 1):
        q = r * 0.5
        crown = [
            (q * 1.15, base),
            (q * 1.15, base + 0.01),
            (q * 0.95, base + 0.012),
            (0, base + 0.012),
        ]
        asm.add("body", lathe([(0, base), *crown], 14, mat=ring).move(x, y, 0))
        lid = [
            (0, base + 0.012),
            (q * 0.9, base + 0.012),
            (q * 0.92, base + 0.016),
            (q * 0.85, base + 0.019),
            (0, base + 0.019),
        ]
        asm.add("body", lathe(lid, 14, mat=cap).move(x, y, 0))
        flame = Material(occlusion=0.0)
        height = flame.remap(flame.axis(2), base + 0.006, base + 0.082)
        stops = [
            (0, "#1b3cff"),
            (0.3, "#2f78ff"),
            (0.52, "#86ccff"),
            (0.68, "#ffd98a"),
            (1, "#ff7a1e"),
        ]
        flame.colour(flame.ramp(height, stops))
        tongue = [(0, 0), (0.014, 0.014), (0.0145, 0.028), (0.008, 0.056), (0, 0.08)]
        for j in range(10):
            a = 2 * math.pi * j / 10
            mesh = lathe(tongue, 4, mat=flame, discs=False).turn(ry=0.55).turn(rz=a).weigh(0.6)
            asm.add(
                f"burner_{k}",
                mesh.move(x + math.cos(a) * q * 1.12, y + math.sin(a) * q * 1.12, base + 0.006),
            )
        hot = Material(occlusion=0.0)
        fade = hot.remap(hot.distance((x, y, base)), q * 1.1, q * 2.4)
        hot.colour(hot.ramp(fade, [(0, "#c86a30"), (0.25, "#4a5fb0"), (1, "#1b1c20")]))
        pool = [(0, base), (q * 2.3, base), (q * 2.3, base + 0.004), (0, base + 0.004)]
        asm.add(f"burner_{k}", lathe(pool, 18, mat=hot).move(x, y, 0).weigh(0.6))
    t = 0.009
    for side in (-1, 1):
        cy, w, d = side * 0.145, 0.255, 0.5
        z0, z1 = top - t, top
        bars = [((x - t / 2, cy - w / 2), (x + t / 2, cy + w / 2)) for x in (-d / 2, 0.0, d / 2)]
        bars += [((-d / 2, y - t / 2), (d / 2, y + t / 2)) for y in (cy - w / 2, cy + w / 2)]
        for x in (-0.13, 0.13):
            reach = 0.04
            bars += [
                ((x - t / 2, cy - w / 2), (x + t / 2, cy - reach)),
                ((x - t / 2, cy + reach), (x + t / 2, cy + w / 2)),
            ]
            bars += [
                ((x - 0.115, cy - t / 2), (x - reach, cy + t / 2)),
                ((x + reach, cy - t / 2), (x + 0.115, cy + t / 2)),
            ]
        for low, high in bars:
            asm.board("body", (*low, z0), (*high, z1), iron, solid=False)
        for x in (-d / 2, d / 2):
            for y in (cy - w / 2, cy + w / 2):
                asm.board(
                    "body",
                    (x - t / 2, y - t / 2, base),
                    (x + t / 2, y + t / 2, z0),
                    iron,
                    solid=False,
                )
    asm.solid("body", (-0.25, -0.275, HOB), (0.25, 0.275, top))
    return top


def stove(
    kind: str = "coil",
    colour: str = "#f1f1ee",
    panel: str = "#e3e4e3",
    clock: str = "12:45",
    splash: float = 0.09,
    extra: str = "",
    offset: Offset = (0, 0, 0),
) -> Model:
    """A range of `kind` "coil", "ceramic", "induction" or "gas".

    extra: a raised glass "lid" behind the burners, a broad "console" there, or "legs" and a rail.
    """
    asm = Assembly()
    enamel = steel(3.0) if colour == "steel" else plain(colour, 0.02, 8, offset)
    panel_material = plain(panel, 0.03, 10)
    knob = plain("#d5d7d9" if panel < "#6" else "#2a2b2e", 0.03)
    _body(asm, enamel, panel_material, clock, knob, splash)
    hobs = {"coil": _coils, "ceramic": _ceramic, "gas": _gas}
    top = _ceramic(asm, True) if kind == "induction" else hobs[kind](asm)
    extras(asm, extra, enamel, clock)
    for k, y in enumerate(KNOBS, 1):  # a pilot lamp below the knob, for those who see no hob
        low, high = (DOOR_FRONT, y - 0.009, 0.776), (DOOR_FRONT + 0.006, y + 0.009, 0.786)
        asm.board(f"burner_{k}", low, high, glowing("#ff4a1c"), solid=False)
    fixed = ["body", "oven_door"]
    burners = [f"burner_{k}" for k in (1, 2, 3, 4)]
    variants = {"default": fixed, **{f"on_{k}": [*fixed, f"burner_{k}"] for k in (1, 2, 3, 4)}}
    states = [{"state": "OFF", "variants": ["default"], "parts": ["body"]}]
    states += [
        {"state": "ON", "variants": [f"on_{k}"], "parts": [f"burner_{k}"]} for k in (1, 2, 3, 4)
    ]
    states += open_closed("oven_door", "oven_door")
    low, high = (BACK + 0.05, -0.25), (CASE_FRONT - 0.02, 0.25)
    hob_low, hob_high = ((-0.24, -0.26), (0.24, 0.26))
    names = {
        "coil": "electric coils",
        "ceramic": "glass-ceramic hob",
        "induction": "induction hob",
        "gas": "gas burners",
    }
    more = {"lid": ", glass lid up", "console": ", back console", "legs": ", old-fashioned"}
    lit = [name for name in asm.meshes if name == "oven_light"]
    variants |= {"oven_lit": [*fixed, *lit]}
    return Model(
        title=f"stove with {names[kind]} and an oven{more.get(extra, '')}",
        parts=asm.parts(
            oven_door={"joint": "oven_door"},
            oven_light={"joint": "oven_door", "rgba": GLOW},
            **{
                b: {"rgba": GLOW if kind not in ("ceramic", "induction") else (1.9, 1.9, 1.9, 1.0)}
                for b in burners
            },
        ),
        mass=48.0,
        variants=variants,
        joints={"oven_door": Joint("revolute", (DOOR_FRONT, 0, 0.216), (0, 1, 0), 0.0, 1.5)},
        states=states,
        supports=[
            surface("top", hob_low, hob_high, top, 0.25 if extra == "legs" else None),
            surface("oven_floor", low, high, 0.25, 0.1, "oven"),
            surface("oven_rack_1", low, high, 0.36, 0.13, "oven"),
            surface("oven_rack_2", low, high, 0.5, 0.175, "oven"),
        ],
        containers=[
            Container(
                "oven", ((low[0] + high[0]) / 2, 0, 0.465), (0.48, 0.5, 0.43), "body", "oven_door"
            )
        ],
        ground_shadow=True,
    )


def stove_random(rng: np.random.Generator) -> dict:
    """Parameters of a random range."""
    return {
        "kind": pick(rng, ["coil", "ceramic", "gas"]),
        "colour": pick(rng, ["#f1f1ee", "steel", "#2c2e31"]),
        "panel": pick(rng, ["#e3e4e3", "#2a2c2f"]),
        "clock": pick(rng, ["12:45", "8:15", "18:30", "9:05"]),
        "splash": pick(rng, [0.0, 0.09]),
        "offset": noise_offset(rng),
    }


PLAIN = {"colour": "#f1f1ee", "panel": "#e3e4e3", "splash": 0.0}
MODELS = {
    "stove": Maker(
        stove,
        stove_random,
        7,
        [
            {"kind": "coil", "colour": "#f1f1ee", "panel": "#e3e4e3", "splash": 0.09},
            {"kind": "ceramic", "colour": "steel", "panel": "#2a2c2f", "splash": 0.0},
            {"kind": "gas", "colour": "#f1f1ee", "panel": "#2a2c2f", "splash": 0.09},
            {"kind": "gas", **PLAIN, "extra": "lid"},
            {"kind": "induction", "colour": "#2c2e31", "panel": "#2a2c2f", "splash": 0.0},
            {"kind": "coil", **PLAIN, "extra": "console"},
            {"kind": "gas", **PLAIN, "colour": "#7d9a86", "panel": "#e9e2cc", "extra": "legs"},
        ],
    ),
}
