"""Small electric things: remote control, laptop, phone, alarm clock, desk lamp, extension cord."""

from __future__ import annotations

import math

import numpy as np
from labels import prints
from makers.projection import project_label
from toolkit.materials import Material, glowing, metal, plain, shade
from toolkit.materials import label as printed
from toolkit.mesh import Mesh
from toolkit.model import Joint, Maker, Model, Part, Support, box_piece, cylinder_piece, rectangle
from toolkit.sampling import pick, uniform
from toolkit.shapes import TAU, box, ellipsoid, extrude, lathe, loft, rounded_rectangle, spline, tube


def remote_control(length: float, width: float, body: str, power: str) -> Model:
    """A remote control on its back, its sending end away from the front."""
    face = printed(prints.remote_face(body, power))
    shell = plain(body, 0.04)
    outline = rounded_rectangle(length, width, width * 0.3, 3)
    rings = [(0.0, 0.9), (0.006, 1.0), (0.015, 1.0), (0.019, 0.965), (0.0195, 0.94)]
    mesh = loft([np.c_[outline * [1 - (1 - f) * width / length, f], np.full(len(outline), z)] for z, f in rings], mat=shell)
    project_label(mesh, face, "+z", (0, 0), (width, length), 0.9, lambda c: c[2] > 0.0192)
    diode = box(0.004, 0.014, 0.008, (-length / 2, 0, 0.006), plain("#5a1a20", 0))
    piece = box_piece((0, 0, 0.00975), (length, width, 0.0195))
    return Model("remote control", {"body": Part([mesh.weigh(1.3), diode], collision=[piece])}, mass=0.11, friction=0.5)


def remote_control_random(rng: np.random.Generator) -> dict:
    return {
        "length": uniform(rng, 0.17, 0.21), "width": uniform(rng, 0.045, 0.052),
        "body": pick(rng, ["#232428", "#2c3038"]), "power": pick(rng, ["#e03a30", "#e8602c"]),
    }  # fmt: skip


def laptop(size: float, shell: str, key: str, hinged: bool) -> Model:
    """A laptop with its keyboard to the front. `hinged`: the lid is a joint, 0 = closed."""
    width, depth, base_height, lid_height = size, size * 0.69, 0.016, 0.009
    case = plain(shell, 0.02, 30)
    deck, dark, lit = (
        printed(prints.laptop_keyboard(shell, key)), printed(prints.desktop_screen(False)), printed(prints.desktop_screen(True), occlusion=0.0),
    )  # fmt: skip
    base = box(depth, width, base_height, (0, 0, 0), case, 0.004, labels={"+z": deck}, weight=1.2)
    hinge = lathe([(0, -0.4), (0.006, -0.4), (0.006, 0.4), (0, 0.4)], 8, mat=plain("#26282c", 0)).scale(1, 1, width).turn(rx=math.pi / 2)
    hinge.move(-depth / 2 + 0.004, 0, base_height + 0.001)
    # the lid is made closed, its hinge at the back edge; the screen looks down
    z = base_height + 0.002
    lid = box(depth, width, lid_height, (0, 0, z), case, 0.003)
    bezel = box(depth - 0.008, width - 0.008, 0.002, (0, 0, z - 0.001), plain("#17181b", 0.02))
    emblem = lathe([(0.014, 0), (0.013, 0.0006), (0, 0.0006)], 12, mat=plain(shade(shell, 0.6), 0)).move(0, 0, z + lid_height - 0.0001)

    def screen(material: Material) -> Mesh:
        # the closed lid's inside: the picture's top lies at the free edge (+X)
        panel = box(depth - 0.03, width - 0.03, 0.003, (0.002, 0, z - 0.0022), plain("#17181b", 0))
        project_label(panel, material, "-z", (0, 0.002), (width - 0.03, depth - 0.03), 0.9)
        return panel

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
        states += [{"state": "CLOSED", "joint": "lid", "max": 0.05}, {"state": "OPEN", "joint": "lid", "min": 0.8, "parts": ["lid"]}]
    else:
        angle = -1.85
        for mesh in (*lid_meshes, dark_screen, lit_screen):
            mesh.turn(ry=angle, pivot=pivot)
        c, s = math.cos(angle), math.sin(angle)
        turn = np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]])
        lid_piece = (lid_piece - pivot) @ turn.T + pivot
    parts = {
        "base": Part([base, hinge], collision=[base_piece]), "lid": Part(lid_meshes, joint=joint, collision=[lid_piece]),
        "screen": Part([dark_screen], joint=joint, collision="none"),
        "screen_on": Part([lit_screen], joint=joint, rgba=(1.4, 1.4, 1.4, 1.0), collision="none"),
    }  # fmt: skip
    return Model(
        "laptop", parts, mass=1.6, joints=joints, states=states,
        variants={"default": ["base", "lid", "screen"], "on": ["base", "lid", "screen_on"]},
    )  # fmt: skip


def laptop_random(rng: np.random.Generator) -> dict:
    shell, key = pick(rng, [("#b9bdc1", "#26282c"), ("#3a3d43", "#17181a"), ("#d9c8b4", "#f2ece2")])
    return {"size": uniform(rng, 0.31, 0.35), "shell": shell, "key": key, "hinged": False}


def phone(length: float, rim: str) -> Model:
    """A phone on its back; variant `on` shows the home screen."""
    width, thick = length * 0.48, 0.0085
    frame = plain(rim, 0.03)
    outline = rounded_rectangle(length, width, 0.012, 3)

    def slab(material: Material | None, low: float, high: float, shrink: float) -> Mesh:
        ring = outline * [1 - shrink / length * 2, 1 - shrink / width * 2]
        mesh = loft([np.c_[ring, np.full(len(ring), z)] for z in (low, high)], mat=frame if material is None else plain("#101114", 0))
        if material is not None:
            project_label(mesh, material, "+z", (0, 0), (width - 0.003, length - 0.003), 0.9)
        return mesh

    body = [slab(None, 0, thick - 0.0006, 0.0)]
    off, on = printed(prints.phone_screen(False)), printed(prints.phone_screen(True), occlusion=0.0)
    piece = box_piece((0, 0, thick / 2), (length, width, thick))
    parts = {
        "body": Part(body, collision=[piece]),
        "screen": Part([slab(off, thick - 0.0012, thick, 0.0012)], collision="none"),
        "screen_on": Part([slab(on, thick - 0.0012, thick, 0.0012)], rgba=(1.4, 1.4, 1.4, 1.0), collision="none"),
    }  # fmt: skip
    return Model(
        "mobile phone", parts, mass=0.19, friction=0.5,
        variants={"default": ["body", "screen"], "on": ["body", "screen_on"]},
        states=[{"state": "ON", "variants": ["on"], "parts": ["screen_on"]}, {"state": "OFF", "variants": ["default"], "parts": ["screen"]}],
    )  # fmt: skip


def phone_random(rng: np.random.Generator) -> dict:
    return {"length": uniform(rng, 0.146, 0.162), "rim": pick(rng, ["#8a9096", "#26282c", "#c83a4a", "#3a6a9c"])}


def alarm_clock(style: str, radius: float, colour: str, paper: str, ink: str, hour: float) -> Model:
    """A twin-bell alarm clock, or a box with lit digits ('digital')."""
    paint = plain(colour, 0.03)
    if style == "digital":
        minutes = int(hour % 1 * 60)
        panel = printed(prints.digital_time(f"{int(hour):02d}:{minutes:02d}", ink), occlusion=0.0)
        body = extrude([(-0.035, 0), (0.035, 0), (0.027, 0.07), (-0.033, 0.07)], 0.15, mat=paint, axis="y", bevel_width=0.005)
        face = box(0.004, 0.126, 0.05, (0, 0, 0), plain("#0b0d10", 0), labels={"+x": panel}, weight=1.4)
        face.turn(ry=-0.114).move(0.0325, 0, 0.009)
        button = box(0.02, 0.06, 0.006, (-0.003, 0, 0.069), plain(shade(colour, 1.6), 0.02), 0.002)
        pieces = [box_piece((0, 0, 0.037), (0.07, 0.15, 0.074))]
        return Model("digital alarm clock", {"body": Part([body, face, button], collision=pieces)}, mass=0.25)
    r, centre = radius, radius + 0.016
    dial = printed(prints.clock_face(paper, ink, hour))
    steel = metal("c9cdd1", "80878d")
    ring = [(0, -0.022), (r * 0.8, -0.022), (r, -0.012), (r, 0.02), (r * 0.93, 0.024), (r * 0.9, 0.018), (0, 0.018)]
    case = lathe(ring, 28, mats=[paint], weight=1.0)
    case.turn(ry=math.pi / 2).move(0, 0, centre)
    project_label(case, dial, "+x", (0, centre), (1.8 * r, 1.8 * r), 0.9, lambda c: abs(c[0] - 0.018) < 0.001)
    meshes = [case.weigh(1.4)]
    for q in (-1, 1):
        bell = lathe([(0, 0.02), (0.014, 0.016), (0.021, 0.004), (0.0215, 0), (0.018, 0), (0, 0.004)], 12, mat=steel)
        lean = q * 0.62
        meshes.append(bell.turn(rx=-lean).move(0, math.sin(lean) * (r + 0.003), centre + math.cos(lean) * (r + 0.003)))
        foot = tube([(0, q * r * 0.5, 0.018), (0, q * r * 0.72, 0.001)], [0.005, 0.0065], 7, mat=steel)
        meshes.append(foot)
    top = centre + r
    loop = [(0, y, top + 0.012 + 0.022 * math.sqrt(max(0, 1 - (y / 0.034) ** 2))) for y in np.linspace(-0.034, 0.034, 9)]
    meshes.append(tube(loop, 0.003, 6, mat=steel))
    meshes.append(lathe([(0, 0), (0.003, 0), (0.003, 0.016), (0.006, 0.018), (0.006, 0.024), (0, 0.026)], 8, mat=steel).move(0, 0, top - 0.002))
    pieces = [
        cylinder_piece(r, -0.022, 0.024, 14) @ np.array([[0, 0, -1], [0, 1, 0], [1, 0, 0]]) + [0, 0, centre],
        box_piece((0, 0, 0.008), (0.012, r * 1.6, 0.016)), box_piece((0, 0, top + 0.012), (0.04, 0.08, 0.03)),
    ]  # fmt: skip
    return Model("twin-bell alarm clock", {"body": Part(meshes, collision=pieces)}, mass=0.3)


def alarm_clock_random(rng: np.random.Generator) -> dict:
    return {
        "style": "bells", "radius": uniform(rng, 0.048, 0.056), "colour": pick(rng, ["#c8303a", "#2f8f8a", "#26282c", "#e8b92c"]),
        "paper": "#fffdf4", "ink": "#222222", "hour": uniform(rng, 1, 11.9),
    }  # fmt: skip


def desk_lamp(height: float, colour: str, steel_arm: bool) -> Model:
    """A jointed desk lamp; variant `on` has a glowing bulb and a warm glow inside the shade."""
    s = height / 0.42
    paint, arm = plain(colour, 0.03), metal() if steel_arm else plain(shade(colour, 0.85), 0.03)
    base = lathe([(0, 0), (0.078, 0), (0.082, 0.004), (0.08, 0.014), (0.068, 0.02), (0.016, 0.024), (0, 0.024)], 24, mat=paint)
    elbow, neck = (-0.105 * s, 0, 0.235 * s), (0.04 * s, 0, 0.385 * s)
    foot = (0, 0, 0.022)
    meshes = [base]
    for q in (-1, 1):
        shift = np.array([0, 0.011 * q, 0])
        meshes += [tube([np.add(foot, shift), np.add(elbow, shift)], 0.004, 6, mat=arm), tube([np.add(elbow, shift), np.add(neck, shift)], 0.004, 6, mat=arm)]
    knob = plain("#26282c", 0.04)
    for at, radius in ((foot, 0.012), (elbow, 0.014), (neck, 0.013)):
        knuckle = lathe([(0, -0.019), (radius, -0.019), (radius, 0.019), (0, 0.019)], 10, mat=knob).turn(rx=math.pi / 2)
        meshes.append(knuckle.move(at[0], 0, at[2] + (0.006 if at is foot else 0)))
    wall = 0.005
    outer = [(0, 0.075), (0.018, 0.075), (0.026, 0.066), (0.034, 0.05), (0.066, 0.012), (0.072, 0)]
    inner = [(0.072 - wall, 0), (0.06, 0.012), (0.029, 0.05), (0, 0.056)]

    def hood(material: Material) -> Mesh:
        return lathe([*outer, *inner][::-1], 22, mats=[paint, material], mat_of_segment=[1] * 3 + [0] * 6)

    def place(mesh: Mesh) -> Mesh:
        return mesh.scale(s).turn(ry=-0.55).move(neck[0] + 0.04 * s, 0, neck[2] - 0.058 * s)

    glow_inside = Material(occlusion=0.0)
    glow_inside.colour("#ffe9b0")
    bulb_shape = [(0, 0), (0.014, 0.006), (0.02, 0.018), (0.018, 0.03), (0.011, 0.045), (0, 0.05)]
    bulb_off, bulb_on = plain("#f4f2ea", 0.02), glowing("#fff6d0")
    parts = {
        "body": Part(meshes, collision=[
            cylinder_piece(0.082, 0, 0.022, 12), *(np.r_[box_piece(a, (0.016, 0.03, 0.016)), box_piece(b, (0.016, 0.03, 0.016))] for a, b in ((foot, elbow), (elbow, neck))),
            box_piece((neck[0] + 0.03 * s, 0, neck[2] - 0.03 * s), (0.13 * s, 0.12 * s, 0.08 * s)),
        ]),
        "shade": Part([place(hood(plain("#f3f0e6", 0.02))), place(lathe(bulb_shape, 10, mat=bulb_off))], collision="none"),
        "shade_lit": Part([place(hood(glow_inside))], collision="none"),
        "bulb_lit": Part([place(lathe(bulb_shape, 10, mat=bulb_on))], rgba=(1.8, 1.8, 1.7, 1.0), collision="none"),
    }  # fmt: skip
    return Model(
        "desk lamp", parts, mass=1.3,
        variants={"default": ["body", "shade"], "on": ["body", "shade_lit", "bulb_lit"]},
        states=[{"state": "ON", "variants": ["on"], "parts": ["bulb_lit"]}, {"state": "OFF", "variants": ["default"], "parts": ["shade"]}],
    )  # fmt: skip


def desk_lamp_random(rng: np.random.Generator) -> dict:
    return {"height": uniform(rng, 0.38, 0.45), "colour": pick(rng, ["#c8302c", "#26282c", "#2f7f8f", "#e8c23a"]), "steel_arm": True}


def extension_cord(colour: str, block: str, sockets: int, coiled: bool, seed: int) -> Model:
    """A multi-socket block with its cable lying on the floor, in loose loops or a coil."""
    rng = np.random.default_rng(seed)
    length = 0.05 + 0.05 * sockets
    white, dark = plain(block, 0.03), plain("#2a2b2e", 0.03)
    meshes = [box(length, 0.056, 0.038, (0.06, 0, 0), white, 0.006)]
    for i in range(sockets):
        x = 0.06 - length / 2 + 0.05 + 0.05 * i
        well = lathe([(0.019, 0.0), (0.0185, 0.0008), (0, 0.0008)], 14, mat=plain(shade(block, 0.78), 0.0)).move(x, 0, 0.0378)
        meshes.append(well)
        for q in (-1, 1):
            meshes.append(lathe([(0.003, 0), (0, 0.0006)], 6, mat=dark, weight=0.6).move(x, q * 0.0095, 0.0387))
    meshes.append(box(0.012, 0.02, 0.006, (0.06 - length / 2 + 0.014, 0, 0.0365), plain("#d8302c", 0), 0.001))
    start = (0.06 - length / 2 + 0.004, 0.0)
    if coiled:
        turns = [(-0.16 + (0.085 + 0.01 * math.sin(3 * t)) * math.cos(t), 0.06 + (0.085 + 0.011 * math.sin(2 * t + 1)) * math.sin(t)) for t in np.linspace(-1.2, 3.2 * TAU - 1.2, 34)]
        points = [start, (start[0] - 0.05, -0.01), *turns, (-0.3, 0.1), (-0.33, 0.02)]
        heights = np.r_[0.018, 0.0045, 0.0045 + np.arange(34) / 33 * 0.026, 0.0045, 0.0045]
    else:
        points = [start, (start[0] - 0.06, 0.0)]
        x = start[0] - 0.1
        for k in range(4):
            q = 1 if k % 2 else -1
            points += [(x, q * float(rng.uniform(0.03, 0.09))), (x - 0.04, q * float(rng.uniform(0.09, 0.14))), (x - 0.08, q * 0.03)]
            x -= 0.1
        points += [(x, 0.02), (x - 0.05, 0.0)]
        heights = np.r_[0.018, np.full(len(points) - 1, 0.0045)]
    path = spline(np.c_[np.array(points), heights], 2)
    meshes.append(tube(path, 0.0045, 5, mat=plain(colour, 0.03), up=(0, 0, 1), weight=0.6))
    end, towards = path[-1], path[-1] - path[-2]
    turn = math.atan2(towards[1], towards[0])
    plug = lathe([(0, 0), (0.009, 0), (0.016, 0.014), (0.0175, 0.034), (0, 0.034)], 10, mat=plain(block, 0.03)).turn(ry=math.pi / 2)
    prongs = [tube([(0.03, q * 0.008, 0), (0.052, q * 0.008, 0)], 0.0026, 6, mat=metal()) for q in (-1, 1)]
    for mesh in (plug, *prongs):
        meshes.append(mesh.turn(rz=turn).move(end[0] - 0.004 * math.cos(turn), end[1], 0.0175))
    pieces = [box_piece((0.06, 0, 0.02), (length, 0.056, 0.04)), box_piece((end[0], end[1], 0.0175), (0.04, 0.034, 0.034))]
    flat = path[4:]
    for a in range(0, len(flat) - 1, 6):
        span = flat[a : a + 7]
        low, high = span.min(0) - 0.0045, span.max(0) + 0.0045
        pieces.append(box_piece((low + high) / 2, high - low))
    return Model("extension lead", {"body": Part(meshes, collision=pieces)}, mass=0.4, friction=0.7)


def extension_cord_random(rng: np.random.Generator) -> dict:
    return {"colour": pick(rng, ["#f1f1ee", "#2a2b2e", "#e8702c"]), "block": pick(rng, ["#f1f1ee", "#3a3c40"]), "sockets": 3, "coiled": True, "seed": int(rng.integers(1e9))}


MODELS = {
    "remote_control": Maker(remote_control, remote_control_random, 2, [{"body": "#232428"}, {"body": "#8d9298"}]),
    "laptop": Maker(laptop, laptop_random, 3, [{"shell": "#b9bdc1", "key": "#26282c"}, {"shell": "#3a3d43", "key": "#17181a"}, {"hinged": True, "shell": "#b9bdc1", "key": "#26282c"}]),
    "phone": Maker(phone, phone_random, 2),
    "alarm_clock": Maker(alarm_clock, alarm_clock_random, 3, [{"colour": "#c8303a"}, {"style": "digital", "colour": "#2a2c30", "ink": "#ff5a3a"}, {"colour": "#2f8f8a"}]),
    "desk_lamp": Maker(desk_lamp, desk_lamp_random, 3, [{"colour": "#c8302c"}, {"colour": "#26282c"}, {"colour": "#e8c23a"}]),
    "extension_cord": Maker(extension_cord, extension_cord_random, 3, [{"colour": "#f1f1ee", "block": "#f1f1ee"}, {"coiled": False, "colour": "#2a2b2e", "block": "#3a3c40"}, {"coiled": False, "colour": "#e8702c", "block": "#2a2b2e"}]),
}  # fmt: skip
