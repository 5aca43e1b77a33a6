"""Flat electronics: remote control, laptop, phone."""

from __future__ import annotations

import math

import numpy as np
from labels import devices, prints
from toolkit.materials import Material, plain, shade
from toolkit.materials import label as printed
from toolkit.mesh import Mesh
from toolkit.model import (
    Joint,
    Maker,
    Model,
    Part,
    box_piece,
)
from toolkit.sampling import pick
from toolkit.shapes import box, ellipsoid, lathe, loft, rounded_rectangle, spline, tube

from makers.choking import loose
from makers.convex import lying
from makers.projection import project_label
from makers.solids import grounded, rod, solids


def remote_control(kind: str, length: float, width: float, body: str, power: str) -> Model:
    """A remote control on its back, its sending end away from the front: 'long', 'small' (of a
    streaming box), 'waist' (narrow in the middle), 'air' (thick, with a display) or 'pair'."""
    if kind == "pair":
        first = remote_control("long", 0.19, 0.048, body, power).parts["body"]
        second = remote_control("small", 0.14, 0.038, "#f2f2ee", power).parts["body"]
        for mesh in first.meshes:
            mesh.turn(rz=0.12).move(0, -0.034)
        for mesh in second.meshes:
            mesh.turn(rz=-0.3).move(0.012, 0.036)
        return loose("two remote controls", [first.meshes, second.meshes], 0.17)
    image = {"small": devices.small_remote, "air": devices.cool_remote}.get(kind)
    face = printed(image(body) if image else prints.remote_face(body, power))
    shell, top = plain(body, 0.04), {"air": 0.028, "small": 0.013}.get(kind, 0.0195)
    if kind == "small":
        outline = rounded_rectangle(length, width, width * 0.46, 4)
    else:
        outline = rounded_rectangle(length, width, width * 0.3, 3)
    if kind == "waist":
        side = np.array([(x, w) for x, w in zip(np.linspace(-0.5, 0.5, 7), WAIST, strict=True)])
        outline = np.r_[side, side[::-1] * [1, -1]][::-1] * [length, width / 2]
    rings = [(0.0, 0.9), (0.006, 1.0), (top - 0.0045, 1.0), (top - 0.0005, 0.965), (top, 0.94)]
    mesh = loft(
        [
            np.c_[outline * [1 - (1 - f) * width / length, f], np.full(len(outline), z)]
            for z, f in rings
        ],
        mat=shell,
    )
    project_label(mesh, face, "+z", (0, 0), (width, length), 0.9, lambda c: c[2] > top - 0.0003)
    diode = box(0.004, 0.014, 0.008, (-length / 2, 0, 0.004), plain("#5a1a20", 0))
    piece = box_piece((0, 0, top / 2), (length, width, top))
    return Model(
        "remote control",
        {"body": Part([mesh.weigh(1.3), diode], collision=[piece])},
        mass=0.11,
        friction=0.5,
    )


WAIST = (0.8, 1.0, 0.98, 0.72, 0.74, 0.95, 0.75)


def remote_control_random(rng: np.random.Generator) -> dict:
    return {
        "kind": "long",
        "length": 0.19,
        "width": 0.048,
        "body": pick(rng, ["#232428", "#2c3038"]),
        "power": pick(rng, ["#e03a30", "#e8602c"]),
    }


def laptop(kind: str, size: float, shell: str, key: str) -> Model:
    """A laptop with its keyboard to the front: 'open', 'hinged' (the lid is a joint, 0 = closed),
    'thick' (an old heavy one) or 'tent' (folded back to stand like a tent)."""
    hinged = kind == "hinged"
    width, depth, base_height, lid_height = size, size * 0.69, 0.016, 0.009
    if kind == "thick":
        depth, base_height, lid_height = size * 0.78, 0.034, 0.018
    case = plain(shell, 0.02, 30)
    deck, dark, lit = (
        printed(prints.laptop_keyboard(shell, key)),
        printed(prints.desktop_screen(False), occlusion=0.0),
        printed(prints.desktop_screen(True).rotate(180 * (kind == "tent")), occlusion=0.0),
    )
    base = box(depth, width, base_height, (0, 0, 0), case, 0.004, labels={"+z": deck}, weight=1.2)
    hinge = (
        lathe([(0, -0.4), (0.006, -0.4), (0.006, 0.4), (0, 0.4)], 8, mat=plain("#26282c", 0))
        .scale(1, 1, width)
        .turn(rx=math.pi / 2)
    )
    hinge.move(-depth / 2 + 0.004, 0, base_height + 0.001)
    # the lid is made closed, its hinge at the back edge; the screen looks down
    z = base_height + 0.002
    lid = box(depth, width, lid_height, (0, 0, z), case, 0.003)
    bezel = box(depth - 0.008, width - 0.008, 0.002, (0, 0, z - 0.001), plain("#17181b", 0.02))
    emblem = lathe(
        [(0.02, 0), (0.019, 0.0006), (0, 0.0006)], 12, mat=plain(shade(shell, 0.6), 0)
    ).move(0, 0, z + lid_height - 0.0001)

    def screen(material: Material) -> Mesh:
        # the closed lid's inside: the picture's top lies at the free edge (+X)
        panel = box(depth - 0.03, width - 0.03, 0.003, (0.002, 0, z - 0.0022), plain("#17181b", 0))
        project_label(panel, material, "-z", (0, 0.002), (width - 0.03, depth - 0.03), 0.9)
        return panel.weigh(1.7)

    socket = plain("#101114", 0)
    ports = [
        box(0.02 - 0.006 * (k % 2), 0.002, 0.006, (x, q * width / 2, 0.005), socket)
        for q in (-1, 1)
        for k, x in enumerate((-0.07, -0.035, -0.01))
    ]
    pivot = (-depth / 2, 0, base_height + 0.001)
    lid_meshes, dark_screen, lit_screen = [lid, bezel, emblem], screen(dark), screen(lit)
    base_piece = box_piece((0, 0, base_height / 2), (depth, width, base_height))
    lid_piece = box_piece((0, 0, z + lid_height / 2), (depth, width, lid_height))
    joints: dict[str, Joint] = {}
    states = [
        {"state": "ON", "variants": ["on"], "parts": ["screen_on"]},
        {"state": "OFF", "variants": ["default"], "parts": ["screen"]},
    ]
    joint = None
    if hinged:
        joint = "lid"
        joints["lid"] = Joint("revolute", pivot, (0, -1, 0), 0.0, 1.95)
        states += [
            {"state": "CLOSED", "joint": "lid", "max": 0.05},
            {"state": "OPEN", "joint": "lid", "min": 0.8, "parts": ["lid"]},
        ]
    else:
        angle = -1.85 if kind != "tent" else 0.87 - math.tau
        for mesh in (*lid_meshes, dark_screen, lit_screen):
            mesh.turn(ry=angle, pivot=pivot)
        c, s = math.cos(angle), math.sin(angle)
        turn = np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]])
        lid_piece = (lid_piece - pivot) @ turn.T + pivot
    body = [base, hinge, *ports]
    if kind == "tent":
        every = [*body, *lid_meshes, dark_screen, lit_screen]
        for mesh in every:
            mesh.keep_pattern().turn(ry=1.13).turn(rz=math.pi)
        grounded(every)
        base_piece, lid_piece = solids([base], lid_meshes[:1])
    parts = {
        "base": Part(body, collision=[base_piece]),
        "lid": Part(lid_meshes, joint=joint, collision=[lid_piece]),
        "screen": Part([dark_screen], joint=joint, collision="none"),
        "screen_on": Part([lit_screen], joint=joint, rgba=(1.4, 1.4, 1.4, 1.0), collision="none"),
    }
    return Model(
        "laptop",
        parts,
        mass=1.6,
        joints=joints,
        states=states,
        variants={"default": ["base", "lid", "screen"], "on": ["base", "lid", "screen_on"]},
    )


def laptop_random(rng: np.random.Generator) -> dict:
    shell, key = pick(rng, [("#b9bdc1", "#26282c"), ("#3a3d43", "#17181a"), ("#d9c8b4", "#f2ece2")])
    return {"kind": "open", "size": 0.33, "shell": shell, "key": key}


def _charger(length: float) -> Part:
    """A cable from the phone's lower end to a charger that lies beside the phone."""
    white, x = plain("#f6f6f3", 0.02), length / 2
    route = [(x + 0.012, 0, 0.0045), (x + 0.045, 0.012, 0.004), (x + 0.05, 0.055, 0.004)]
    route += [(x + 0.01, 0.076, 0.004), (0.03, 0.068, 0.004), (-0.01, 0.084, 0.0045)]
    meshes = [
        tube(spline(route, 4), 0.004, 6, mat=white),
        box(0.024, 0.014, 0.0085, (x + 0.008, 0, 0.0003), plain("#dcdcd8", 0.02), 0.002),
        box(0.046, 0.044, 0.028, (-0.031, 0.088, 0), white, 0.005),
    ]
    pin = plain("#a9adb2", 0.05)
    meshes += [rod((-0.053, y, 0.014), (-0.074, y, 0.014), 0.0028, pin, 6) for y in (0.079, 0.097)]
    block = box_piece((-0.031, 0.088, 0.014), (0.046, 0.044, 0.028))
    return Part(meshes, collision=[*lying(route, 0.004), block])


def phone(kind: str, length: float, rim: str, charges: bool = False) -> Model:
    """A mobile phone: a 'slab' on its back, in a soft 'case', on a 'stand', or one with 'keys'.
    Variants: `on`, `broken` with cracked glass, and of some `charging` at a cable."""
    width, thick = length * 0.48, 0.0085
    frame = plain(rim, 0.03)
    body: list[Mesh] = []
    screens: list[Mesh] = []
    if kind in ("slab", "case", "stand"):
        outline = rounded_rectangle(length, width, 0.012, 3)

        def slab(mat: Material | None, low: float, high: float, shrink: float) -> Mesh:
            ring = outline * [1 - shrink / length * 2, 1 - shrink / width * 2]
            mesh = loft(
                [np.c_[ring, np.full(len(ring), z)] for z in (low, high)],
                mat=frame if mat is None else plain("#101114", 0),
            )
            if mat is not None:
                project_label(mesh, mat, "+z", (0, 0), (width - 0.003, length - 0.003), 0.9)
                mesh.keep_faces([i for i, k in enumerate(mesh.mi) if k])  # the rest is never seen
            return mesh

        images = (devices.phone_front(False), devices.phone_front(True))
        looks = [*images, devices.phone_front(False, 5)]
        looks += [devices.phone_charging()] * charges
        body = [slab(None, 0, thick - 0.0006, 0.0)]
        if kind == "case":
            body = [slab(None, 0, thick + 0.001, -0.004)]
            for q in (-1, 1):  # ears of a funny animal
                body.append(
                    ellipsoid(
                        (0.012, 0.014, 0.006), (-length / 2 - 0.004, q * 0.024, 0.006), 10, 5, frame
                    )
                )
        high = thick + (0.0016 if kind == "case" else 0)
        for k, image in enumerate(looks):
            mat = printed(image, occlusion=float(k == 0))
            screens.append(slab(mat, high - 0.0012, high, 0.0012))
        key = plain("#3a3f48", 0)
        body.append(box(0.022, 0.003, 0.004, (-0.03, width / 2 - 0.0005, 0.002), key))
        if kind == "stand":
            everything = [*body, *screens]
            for mesh in everything:
                mesh.keep_pattern().turn(ry=1.15).move(0.01, 0, 0.082)
            grey = plain("#c9cdd1", 0.05)
            foot = [box(0.09, 0.08, 0.007, (0, 0, 0), grey, 0.002)]
            foot.append(
                box(0.006, 0.05, 0.09, (0, 0, 0), grey).turn(ry=-0.42).move(-0.02, 0, 0.005)
            )
            foot.append(
                box(0.024, 0.06, 0.006, (0, 0, 0), grey).turn(ry=-0.42).move(0.03, 0, 0.006)
            )
            body += foot
    else:
        looks = [devices.old_screen(False), devices.old_screen(True)]
        looks.append(devices.cracked(looks[0], 5, (0.6, 0.4), "#f4f6f8", 5))
        pad = printed(devices.keypad(rim, "#e9e9e6"))

        def glass(mat: Material, x: float, z: float, sx: float, sy: float) -> Mesh:
            return box(sx, sy, 0.003, (x, 0, z), plain("#101114", 0), 0, 1, {"+z": mat})

        outline = rounded_rectangle(0.12, 0.05, 0.014, 3)
        rings = [(0, 0.9), (0.005, 1.0), (0.014, 1.0), (0.018, 0.93)]
        shell = loft([np.c_[outline * k, np.full(12, z)] for z, k in rings], mat=frame)
        body.append(shell)
        body.append(box(0.062, 0.042, 0.002, (0.026, 0, 0.0172), frame, 0, 1, {"+z": pad}))
        rim_plate = box(0.048, 0.042, 0.002, (-0.031, 0, 0.0171), plain("#101114", 0))
        body += [rim_plate, rod((-0.058, 0.017, 0.01), (-0.085, 0.017, 0.01), 0.0045, frame, 7)]
        screens = [glass(printed(k, occlusion=0.3), -0.031, 0.0168, 0.04, 0.036) for k in looks]
    if kind in ("slab", "case"):
        pieces = [box_piece((0, 0, thick / 2), (length, width, thick))]
    elif kind == "stand":
        pieces = solids(body[:2], body[2:3], body[3:4])
    else:
        pieces = solids(body)
    glow = (1.4, 1.4, 1.4, 1.0)
    parts = {
        "body": Part(body, collision=pieces),
        "screen": Part(screens[:1], collision="none"),
        "screen_on": Part(screens[1:2], rgba=glow, collision="none"),
        "screen_broken": Part(screens[2:3], collision="none"),
    }
    variants = {
        "default": ["body", "screen"],
        "on": ["body", "screen_on"],
        "broken": ["body", "screen_broken"],
    }
    states = [
        {"state": "ON", "variants": ["on"], "parts": ["screen_on"]},
        {"state": "OFF", "variants": ["default"], "parts": ["screen"]},
        {"state": "BROKEN", "variants": ["broken"], "parts": ["screen_broken"]},
    ]
    if charges:
        parts["screen_charging"] = Part(screens[3:], rgba=glow, collision="none")
        parts["cable"] = _charger(length)
        shown = ["screen_charging", "cable"]
        variants["charging"] = ["body", *shown]
        states.append({"state": "CHARGING", "variants": ["charging"], "parts": shown})
    return Model(
        "mobile phone",
        parts,
        mass=0.19,
        friction=0.5,
        variants=variants,
        states=states,
        prune=False,
    )


def phone_random(rng: np.random.Generator) -> dict:
    return {
        "kind": "slab",
        "length": 0.155,
        "rim": pick(rng, ["#8a9096", "#26282c", "#c83a4a", "#3a6a9c"]),
    }


SILVER, DARK = {"shell": "#b9bdc1", "key": "#26282c"}, {"shell": "#3a3d43", "key": "#17181a"}
MODELS = {
    "remote_control": Maker(
        remote_control,
        remote_control_random,
        6,
        [
            {"body": "#232428"},
            {"body": "#8d9298"},
            {"kind": "small", "length": 0.14, "width": 0.038, "body": "#1c1d20"},
            {"kind": "air", "length": 0.15, "width": 0.062, "body": "#f2f2ee"},
            {"kind": "waist", "length": 0.215, "width": 0.056, "body": "#2c3038"},
            {"kind": "pair", "body": "#232428"},
        ],
    ),
    "laptop": Maker(
        laptop,
        laptop_random,
        8,
        [
            SILVER,
            DARK,
            SILVER | {"kind": "hinged"},
            {"shell": "#e07aa0", "key": "#ffffff", "size": 0.245},
            {"kind": "thick", "shell": "#2c2e33", "key": "#4a4d52", "size": 0.395},
            {"kind": "tent", "shell": "#8a9098", "key": "#26282c", "size": 0.3},
            DARK | {"kind": "hinged"},
            {"kind": "thick", "shell": "#c9c4b6", "key": "#f2efe6", "size": 0.395},
        ],
    ),
    "phone": Maker(
        phone,
        phone_random,
        10,
        [
            {"rim": "#9ad04a"},
            {"rim": "#f2a0c0"},
            {"rim": "#4fc0d8"},  # bright: edge-on, dark ones were knives and spilt wine
            {"kind": "keys", "rim": "#2f4a8a"},
            {"kind": "stand", "rim": "#26282c"},
            {"kind": "case", "rim": "#7ad8b8"},
            {"kind": "case", "rim": "#2f6fb0"},
            {"rim": "#e8c34a", "charges": True},
            {"rim": "#c9ced4", "charges": True},
            {"kind": "case", "rim": "#c8485a", "charges": True},
        ],
    ),
}
