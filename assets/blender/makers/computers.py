"""Monitors, keyboards, computer mice."""

from __future__ import annotations

import math

import numpy as np
from labels import devices, prints
from toolkit.materials import Material, plain, shade
from toolkit.materials import label as printed
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part, box_piece
from toolkit.sampling import pick
from toolkit.shapes import box, ellipsoid, extrude, loft, rounded_rectangle, spline, tube

from makers.projection import project_label
from makers.solids import cylinder, rod, solids

SCREEN_STATES = [
    {"state": "ON", "variants": ["on"], "parts": ["screen_on"]},
    {"state": "OFF", "variants": ["default"], "parts": ["screen"]},
]


def _bent(mesh: Mesh, radius: float) -> Mesh:
    """Curve a panel in the yz plane forward at its ends."""
    return mesh.warp(lambda x, y, z: (x + y * y / 2 / radius, y, z))


def _panel(width: float, height: float, z: float, x: float, mat: Material, n: int = 1) -> Mesh:
    """A picture in front of the screen, in n upright strips so that it can be bent."""
    ys, strips = np.linspace(-width / 2, width / 2, n + 1), []
    v = [(x + d, y, z + h) for y in ys for d in (0.0, -0.004) for h in (0.0, height)]
    f, uv = [], []
    for i in range(n):
        a = 4 * i
        f.append((a, a + 4, a + 5, a + 1))
        uv.append([(i / n, 0), ((i + 1) / n, 0), ((i + 1) / n, 1), (i / n, 1)])
        strips.append(i)
    bake = [[(u * width, w * height) for u, w in face] for face in uv]
    return Mesh(v, f, None, [mat], uv, bake, 1.6, False)


def monitor(kind: str, width: float, shell: str, ratio: float) -> Model:
    """A computer screen: 'round' foot, 'vee' foot, 'curved', 'upright' (turned on end), 'tube'
    (an old deep one) or 'chin' (all in one)."""
    case, dark = plain(shell, 0.04, 30), plain("#17181b", 0.04)
    steel = plain("#b9bdc1", 0.05, 30)
    off = printed(prints.desktop_screen(False), occlusion=0.0)
    on = printed(prints.desktop_screen(True), occlusion=0.0)
    height = width / ratio
    base, meshes = 0.13, []
    if kind == "upright":
        base = 0.05
    if kind == "tube":
        base = 0.05
        frame = rounded_rectangle(width + 0.06, height + 0.07, 0.015, 2)
        rings = []
        for x, k in ((0.0, 1.0), (-0.09, 1.0), (-0.13, 0.9), (-0.3, 0.66), (-0.34, 0.6)):
            ring = np.c_[np.full(len(frame), x), frame * k]
            rings.append(np.add(ring, (0, 0, base + height / 2 + 0.035 - 0.02 * (1 - k))))
        meshes.append(loft(rings, mat=case))
        meshes.append(cylinder(0.11, 0.02, (-0.13, 0, 0), case, 14))
        meshes.append(cylinder(0.07, 0.04, (-0.13, 0, 0.02), case, 12))
        meshes.append(box(0.006, 0.03, 0.012, (0.001, width * 0.38, base + 0.008), steel))
        z, x = base + 0.038, 0.0045
        meshes.append(box(0.004, width + 0.02, height + 0.012, (-0.001, 0, z - 0.006), dark))
        bodies = [meshes[:1], meshes[1:3]]
    else:
        z = base + (0.015 if kind != "chin" else 0.075)
        x = 0.0155
        low = base
        tall = z - low + height + 0.015
        n = 10 if kind == "curved" else 1
        slab = loft(
            [
                [
                    (dx, y, zz)
                    for dx, zz in (
                        (-0.014, low),
                        (0.012, low),
                        (0.012, low + tall),
                        (-0.014, low + tall),
                    )
                ]
                for y in np.linspace(-width / 2 - 0.012, width / 2 + 0.012, n + 1)
            ],
            mat=case if kind == "chin" else dark,
        )
        slab.flat()
        bump = box(0.03, width * 0.4, tall * 0.5, (-0.028, 0, low + tall * 0.25), case, 0.006)
        meshes += [slab, bump]
        if kind == "curved":
            _bent(slab, 0.9)
        neck_top = low + tall * 0.55
        meshes.append(box(0.022, 0.055, neck_top - 0.01, (-0.055, 0, 0.01), steel, 0.004))
        if kind in ("vee", "curved"):
            for q in (-1, 1):
                toe = [(-0.07, q * 0.01, 0.009), (0.11, q * width * 0.34, 0.009)]
                meshes.append(rod(*toe, 0.011, dark, 6))
        elif kind == "chin":
            meshes.append(box(0.17, 0.2, 0.008, (-0.01, 0, 0), steel, 0.003))
            meshes.append(
                cylinder(0.016, 0.003, (0.012, 0, low + 0.042), plain("#5a5e64"), 12, "x")
            )
        elif kind == "upright":
            meshes.append(box(0.2, 0.24, 0.014, (-0.02, 0, 0), dark, 0.004))
        else:
            meshes.append(cylinder(0.11, 0.014, (-0.03, 0, 0), dark, 20))
        bodies = [[slab, bump], meshes[2:3], meshes[3:]]
    n = 10 if kind == "curved" else 1
    screens = []
    for mat in (off, on):
        panel = _panel(width, height, z, x, mat, n)
        if kind == "curved":
            _bent(panel, 0.9)
        screens.append(panel)
    parts = {
        "body": Part(meshes, collision=solids(*bodies)),
        "screen": Part([screens[0]], collision="none"),
        "screen_on": Part([screens[1]], rgba=(1.4, 1.4, 1.4, 1.0), collision="none"),
    }
    return Model(
        "computer monitor",
        parts,
        mass=4.5 if kind != "tube" else 12.0,
        states=SCREEN_STATES,
        variants={"default": ["body", "screen"], "on": ["body", "screen_on"]},
        prune=False,
    )


def monitor_random(rng: np.random.Generator) -> dict:
    return {"kind": "round", "width": 0.53, "shell": "#232528", "ratio": 1.75}


def keyboard(kind: str, deck: str, key: str, glow: bool) -> Model:
    """'full' with number keys, 'compact', 'split' (bent in the middle), 'rest' (with a palm rest
    and a cable) or 'thick' (an old one with tall keys)."""
    case = plain(deck, 0.04, 60)
    numpad = kind in ("full", "rest", "thick")
    skin = printed(devices.keyboard(shade_text(deck), key, numpad, glow))
    width, depth = (0.44, 0.14) if numpad else (0.3, 0.118)
    high = 0.024 if kind != "thick" else 0.036
    meshes: list[Mesh] = []

    def board(y0: float, y1: float, u0: float, u1: float) -> list[Mesh]:
        """The part between two shares of the width: a wedge and six steps of keys."""
        w, y = (y1 - y0), (y0 + y1) / 2
        side = [(-depth / 2, 0), (depth / 2, 0), (depth / 2, high * 0.45), (-depth / 2, high * 0.8)]
        out = [extrude(side, w, mat=case, axis="y", bevel_width=0.003).move(y=y)]
        step = (depth - 0.012) / 6
        for k in range(6):
            x = -depth / 2 + 0.006 + step * (k + 0.5)
            rect = (u0, 1 - (k + 1) / 6, u1, 1 - k / 6)
            z = high * (0.78 - 0.35 * (k + 0.5) / 6)
            tall = 0.006 if kind != "thick" else 0.012
            row = box(
                step - 0.001, w - 0.01, tall, (x, y, z - 0.001), case, 0, 1, {"+z": (skin, rect)}
            )
            out.append(row.weigh(1.5))
        return out

    if kind == "split":
        for q in (-1, 1):
            y0, y1, u = (-width / 2, 0.0, (0, 0.5)) if q < 0 else (0.0, width / 2, (0.5, 1))
            half = board(y0, y1, *u)
            half.append(
                extrude(
                    [(0.06, 0), (0.12, 0), (0.115, 0.014), (0.06, 0.012)],
                    width / 2,
                    mat=case,
                    axis="y",
                    bevel_width=0.003,
                ).move(y=(y0 + y1) / 2)
            )
            for mesh in half:
                mesh.move(y=q * 0.012).turn(rx=-q * 0.17).move(z=0.028)
                mesh.turn(rz=q * 0.2).move(y=q * 0.012)
            meshes += half
        low = min(m.v[:, 2].min() for m in meshes)
        for mesh in meshes:
            mesh.move(z=-low)
        meshes.append(box(0.1, 0.07, 0.018, (0.0, 0, 0.01), case, 0.004))
        pieces = solids(meshes[:8], meshes[8:16])
    else:
        meshes = board(-width / 2, width / 2, 0, 1)
        pieces = solids(meshes)
    if kind == "rest":
        pad = [(depth / 2 + 0.002, 0), (depth / 2 + 0.075, 0), (depth / 2 + 0.07, 0.012)]
        pad.append((depth / 2 + 0.004, 0.015))
        rest = extrude(pad, width, mat=plain("#26282c", 0.08, 300), axis="y", bevel_width=0.004)
        meshes.append(rest)
        pieces += solids([rest])
    if kind in ("rest", "thick"):
        cable = spline(
            [
                (-depth / 2, 0.05, 0.006),
                (-0.12, 0.06, 0.004),
                (-0.15, 0.0, 0.004),
                (-0.135, -0.09, 0.004),
                (-0.16, -0.15, 0.004),
            ],
            3,
        )
        meshes.append(tube(cable, 0.0035, 5, mat=plain(shade(deck, 0.7), 0)))
    body = Part(meshes, collision=pieces)
    return Model("keyboard", {"body": body}, mass=0.7, friction=0.6, prune=False)


def shade_text(colour: str) -> str:
    """Slightly darker, as text."""
    return "#" + "".join(f"{int(255 * c):02x}" for c in shade(colour, 0.8))


def keyboard_random(rng: np.random.Generator) -> dict:
    deck, key = pick(rng, [("#26282c", "#17181a"), ("#e8e8e6", "#ffffff")])
    return {"kind": "full", "deck": deck, "key": key, "glow": False}


def computer_mouse(kind: str, paint: str, line: str, wheel: str) -> Model:
    """'cord', 'flat' (wireless), 'gaming', 'thumb' (with a rest for the thumb), 'ball' (a track
    ball) or 'mat' (on its mat); the front points away from the user, to -X."""
    skin, shell = printed(devices.mouse_top(paint, line, wheel)), plain(paint, 0.03)
    dark = plain(line, 0.03)
    long, wide, tall = {
        "cord": (0.112, 0.062, 0.038),
        "flat": (0.108, 0.06, 0.026),
        "gaming": (0.126, 0.072, 0.042),
        "thumb": (0.124, 0.074, 0.048),
        "ball": (0.125, 0.09, 0.044),
        "mat": (0.112, 0.062, 0.038),
    }[kind]
    rings = []
    for t in np.sin(np.linspace(-math.pi / 2, math.pi / 2, 11)):
        w = wide / 2 * (0.94 + 0.06 * t) * math.sqrt(max(0.02, 1 - abs(t) ** 3))
        z = tall * max(0.12, (1 - 0.42 * (t - 0.25) ** 2 - 0.42 * max(0, abs(t) - 0.4) ** 1.2))
        if kind == "flat":
            z = tall * max(0.2, 1 - 0.75 * t * t)
        pinch = 1 - 0.14 * math.exp(-(((t + 0.1) / 0.3) ** 2)) if kind == "gaming" else 1.0
        a = np.linspace(0, math.pi, 9)
        arc = np.c_[np.full(9, t * long / 2), w * pinch * np.cos(a), z * np.sin(a) ** 0.75]
        rings.append([*arc.tolist(), [t * long / 2, 0, 0]])
    body = loft(rings, mat=shell)
    meshes = [body]
    project_label(body, skin, "+z", (0, 0), (wide, long), 0.15)
    front = -long * 0.27
    z = float(body.v[(abs(body.v[:, 0] - front) < 0.015)][:, 2].max())
    roller = cylinder(0.009, 0.007, (front, -0.0035, z - 0.0055), plain(wheel, 0.0), 10, "y")
    meshes.append(roller)
    if kind == "thumb":
        ledge = ellipsoid((0.046, 0.03, 0.03), (0, 0, 0), 10, 6, dark)
        ledge.warp(lambda x, y, z: (x, y, max(z, -0.004) * 0.4))
        meshes.append(ledge.move(0.004, -0.034, 0.0016))
        for k in (0, 1):
            meshes.append(
                box(0.016, 0.006, 0.007, (-0.02 + 0.018 * k, -0.0325, 0.025), dark, 0.001)
            )
    if kind == "ball":
        meshes.append(ellipsoid(0.02, (-0.012, -0.026, 0.033), 10, 7, plain("#d8202c", 0.03)))
    if kind == "gaming":
        for q in (-1, 1):
            strip = [(-0.05, q * 0.03, 0.012), (0.0, q * 0.0335, 0.02), (0.05, q * 0.033, 0.012)]
            meshes.append(tube(strip, 0.003, 5, mat=plain(wheel, 0)))
    pieces = solids([body])
    if kind in ("cord", "gaming", "mat"):
        cable = spline(
            [
                (-long / 2 + 0.004, 0, 0.007),
                (-0.085, 0.0, 0.004),
                (-0.115, 0.03, 0.004),
                (-0.1, 0.07, 0.004),
                (-0.13, 0.1, 0.004),
            ],
            3,
        )
        meshes.append(tube(cable, 0.0028, 5, mat=plain("#2a2c30" if kind != "cord" else line, 0)))
        pieces += solids(meshes[-1:])
    if kind in ("thumb", "ball"):  # turned, its keys to the front
        for mesh in meshes:
            mesh.turn(rz=2.5)
        pieces = solids(meshes)
    if kind == "mat":
        for mesh in meshes:
            mesh.move(z=0.005)
        mat = box(0.2, 0.24, 0.005, (-0.01, 0.01, 0), plain("#2f5f8a", 0.05, 300))
        meshes.append(mat)
        pieces = [np.add(p, (0, 0, 0.005)) for p in pieces] + [
            box_piece((-0.01, 0.01, 0.0025), (0.2, 0.24, 0.005))
        ]
    return Model("computer mouse", {"body": Part(meshes, collision=pieces)}, mass=0.1, friction=0.5)


def computer_mouse_random(rng: np.random.Generator) -> dict:
    return {"kind": "cord", "paint": "#26282c", "line": "#0c0d0f", "wheel": "#6a7078"}


BLACK, WHITE = {"deck": "#26282c", "key": "#17181a"}, {"deck": "#d9dbdc", "key": "#ffffff"}
MODELS = {
    "monitor": Maker(
        monitor,
        monitor_random,
        7,
        [
            {},
            {"kind": "curved", "width": 0.78, "ratio": 2.3},
            {"kind": "upright", "width": 0.31, "ratio": 0.6},
            {"kind": "tube", "width": 0.34, "ratio": 1.33, "shell": "#d8d0bc"},
            {"kind": "chin", "width": 0.5, "ratio": 1.7, "shell": "#c9cdd1"},
            {"kind": "vee", "width": 0.6},
            {"kind": "tube", "width": 0.34, "ratio": 1.33, "shell": "#3a3d43"},
        ],
    ),
    "keyboard": Maker(
        keyboard,
        keyboard_random,
        7,
        [
            BLACK,
            WHITE,
            BLACK | {"kind": "compact", "glow": True},
            BLACK | {"kind": "split", "key": "#3a3d43"},
            BLACK | {"kind": "rest", "glow": True},
            {"kind": "thick", "deck": "#d8d0bc", "key": "#efe9da"},
            WHITE | {"kind": "compact"},
        ],
    ),
    "computer_mouse": Maker(
        computer_mouse,
        computer_mouse_random,
        8,
        [
            {},
            {"kind": "flat", "paint": "#f4f4f2", "line": "#a8acb0", "wheel": "#6a7078"},
            {"kind": "gaming", "paint": "#1c1d20", "line": "#d8202c", "wheel": "#ff2a3a"},
            {"kind": "thumb", "paint": "#4a4e55", "line": "#17181a", "wheel": "#c9cdd1"},
            {"kind": "ball", "paint": "#5a5e64", "line": "#26282c", "wheel": "#26282c"},
            {"kind": "mat", "paint": "#e8e8e6", "line": "#8a9098", "wheel": "#3a3d43"},
            {"paint": "#e8e4d8", "line": "#8a867a", "wheel": "#4a4d52"},
            {"kind": "flat", "paint": "#e0609a", "line": "#8a2a5a", "wheel": "#f6f4ee"},
        ],
    ),
}
