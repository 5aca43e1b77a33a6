"""Flat electronics: remote control, laptop, phone."""

from __future__ import annotations

import math

import numpy as np
from labels import prints
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
from toolkit.sampling import pick, uniform
from toolkit.shapes import (
    box,
    lathe,
    loft,
    rounded_rectangle,
)

from makers.projection import project_label


def remote_control(length: float, width: float, body: str, power: str) -> Model:
    """A remote control on its back, its sending end away from the front."""
    face = printed(prints.remote_face(body, power))
    shell = plain(body, 0.04)
    outline = rounded_rectangle(length, width, width * 0.3, 3)
    rings = [(0.0, 0.9), (0.006, 1.0), (0.015, 1.0), (0.019, 0.965), (0.0195, 0.94)]
    mesh = loft(
        [
            np.c_[outline * [1 - (1 - f) * width / length, f], np.full(len(outline), z)]
            for z, f in rings
        ],
        mat=shell,
    )
    project_label(mesh, face, "+z", (0, 0), (width, length), 0.9, lambda c: c[2] > 0.0192)
    diode = box(0.004, 0.014, 0.008, (-length / 2, 0, 0.006), plain("#5a1a20", 0))
    piece = box_piece((0, 0, 0.00975), (length, width, 0.0195))
    return Model(
        "remote control",
        {"body": Part([mesh.weigh(1.3), diode], collision=[piece])},
        mass=0.11,
        friction=0.5,
    )


def remote_control_random(rng: np.random.Generator) -> dict:
    return {
        "length": uniform(rng, 0.17, 0.21),
        "width": uniform(rng, 0.045, 0.052),
        "body": pick(rng, ["#232428", "#2c3038"]),
        "power": pick(rng, ["#e03a30", "#e8602c"]),
    }


def laptop(size: float, shell: str, key: str, hinged: bool) -> Model:
    """A laptop with its keyboard to the front. `hinged`: the lid is a joint, 0 = closed."""
    width, depth, base_height, lid_height = size, size * 0.69, 0.016, 0.009
    case = plain(shell, 0.02, 30)
    deck, dark, lit = (
        printed(prints.laptop_keyboard(shell, key)),
        printed(prints.desktop_screen(False), occlusion=0.0),
        printed(prints.desktop_screen(True), occlusion=0.0),
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
        [(0.014, 0), (0.013, 0.0006), (0, 0.0006)], 12, mat=plain(shade(shell, 0.6), 0)
    ).move(0, 0, z + lid_height - 0.0001)

    def screen(material: Material) -> Mesh:
        # the closed lid's inside: the picture's top lies at the free edge (+X)
        panel = box(depth - 0.03, width - 0.03, 0.003, (0.002, 0, z - 0.0022), plain("#17181b", 0))
        project_label(panel, material, "-z", (0, 0.002), (width - 0.03, depth - 0.03), 0.9)
        return panel.weigh(1.7)

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
        angle = -1.85
        for mesh in (*lid_meshes, dark_screen, lit_screen):
            mesh.turn(ry=angle, pivot=pivot)
        c, s = math.cos(angle), math.sin(angle)
        turn = np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]])
        lid_piece = (lid_piece - pivot) @ turn.T + pivot
    parts = {
        "base": Part([base, hinge], collision=[base_piece]),
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
    return {"size": uniform(rng, 0.31, 0.35), "shell": shell, "key": key, "hinged": False}


def phone(length: float, rim: str) -> Model:
    """A phone on its back; variant `on` shows the home screen."""
    width, thick = length * 0.48, 0.0085
    frame = plain(rim, 0.03)
    outline = rounded_rectangle(length, width, 0.012, 3)

    def slab(material: Material | None, low: float, high: float, shrink: float) -> Mesh:
        ring = outline * [1 - shrink / length * 2, 1 - shrink / width * 2]
        mesh = loft(
            [np.c_[ring, np.full(len(ring), z)] for z in (low, high)],
            mat=frame if material is None else plain("#101114", 0),
        )
        if material is not None:
            project_label(mesh, material, "+z", (0, 0), (width - 0.003, length - 0.003), 0.9)
            mesh.keep_faces([i for i, kind in enumerate(mesh.mi) if kind])  # the rest is never seen
        return mesh

    body = [slab(None, 0, thick - 0.0006, 0.0)]
    off, on = printed(prints.phone_screen(False)), printed(prints.phone_screen(True), occlusion=0.0)
    piece = box_piece((0, 0, thick / 2), (length, width, thick))
    parts = {
        "body": Part(body, collision=[piece]),
        "screen": Part([slab(off, thick - 0.0012, thick, 0.0012)], collision="none"),
        "screen_on": Part(
            [slab(on, thick - 0.0012, thick, 0.0012)], rgba=(1.4, 1.4, 1.4, 1.0), collision="none"
        ),
    }
    return Model(
        "mobile phone",
        parts,
        mass=0.19,
        friction=0.5,
        variants={"default": ["body", "screen"], "on": ["body", "screen_on"]},
        states=[
            {"state": "ON", "variants": ["on"], "parts": ["screen_on"]},
            {"state": "OFF", "variants": ["default"], "parts": ["screen"]},
        ],
    )


def phone_random(rng: np.random.Generator) -> dict:
    return {
        "length": uniform(rng, 0.146, 0.162),
        "rim": pick(rng, ["#8a9096", "#26282c", "#c83a4a", "#3a6a9c"]),
    }


MODELS = {
    "remote_control": Maker(
        remote_control, remote_control_random, 2, [{"body": "#232428"}, {"body": "#8d9298"}]
    ),
    "laptop": Maker(
        laptop,
        laptop_random,
        3,
        [
            {"shell": "#b9bdc1", "key": "#26282c"},
            {"shell": "#3a3d43", "key": "#17181a"},
            {"hinged": True, "shell": "#b9bdc1", "key": "#26282c"},
        ],
    ),
    "phone": Maker(phone, phone_random, 2),
}
