"""Drinks cans: slim, tall, crushed and by the six."""

from __future__ import annotations

import math

import numpy as np
from labels import groceries
from toolkit import labels
from toolkit.materials import Material, label, metal, plain
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part, cylinder_piece
from toolkit.shapes import box, extrude, rounded_rectangle

from makers.pack_parts import by_style, vessel
from makers.packs_bottles import shade_hex


def can_print(word: str, sub: str, colour: str, accent: str, ink: str, motif):
    w, h = 250, 400
    image = labels.gradient(3 * w, h, colour, shade_hex(colour))
    from PIL import ImageDraw

    d = ImageDraw.Draw(image)
    rng = np.random.default_rng(3)
    for _ in range(60):  # drops of dew
        x, y, q = rng.uniform(0, 3 * w), rng.uniform(0, h), rng.uniform(2, 5)
        d.ellipse((x - q, y - q, x + q, y + q), outline="#ffffff")
    for k in range(3):
        x = k * w
        wave = [
            (x + u, h * (0.55 - 0.05 * math.sin(u / w * math.tau))) for u in range(0, w + 1, 10)
        ]
        low = [(q[0], q[1] + h * 0.08) for q in wave[::-1]]
        d.polygon(wave + low, fill=accent)
        labels.text(
            d, word, (x + 12, h * 0.2, x + w - 12, h * 0.48), "oblique", ink, 4, shade_hex(colour)
        )
        labels.text(d, sub, (x + 30, h * 0.1, x + w - 30, h * 0.19), "bold", accent)
        motif(d, x + w / 2, h * 0.78, w * 0.2)
    return image


def can_lid(radius: float, z: float, steel: Material, opened: bool) -> list[Mesh]:
    """The ring pull, and the black mouth of an opened can."""
    tab = extrude(rounded_rectangle(0.024, 0.016, 0.007, 3), 0.002, steel).move(-0.004, 0, z)
    meshes = [tab]
    mouth = extrude(
        rounded_rectangle(0.017, 0.022, 0.008, 4),
        0.0012,
        plain("#141210" if opened else "#a8aeb4", 0),
    ).move(radius * 0.45, 0, z - 0.0004)
    if opened:
        tab.turn(ry=0.5, pivot=(-0.012, 0, z))
    return [*meshes, mouth]


def soda_can(
    radius: float,
    height: float,
    word: str,
    sub: str,
    colour: str,
    accent: str,
    motif: str,
    ink: str = "#ffffff",
    state: str = "shut",
) -> Model:
    """A drinks can: shut, opened or crushed."""
    r, h = radius, height
    steel = metal("c9ced2", "868c91", (8, 8, 1), 60)
    art = label(can_print(word, sub, colour, accent, ink, getattr(groceries, motif)))
    crushed = state == "crushed"
    steps = [(0, 0.7), (0.012, 0.8), (0.05, 1.0)]
    steps += [(z, 1.0) for z in ((0.25, 0.42, 0.55, 0.72) if crushed else ())]
    steps += [(0.88, 1.0), (0.975, 0.84), (1.0, 0.84), (0.995, 0.8), (0.972, 0.78)]
    sections = [(z * h, k * r, k * r, 2.0) for z, k in steps]
    top = len(steps) - 5
    which = [0, 0, *([1] * (top - 2)), 1, 0, 0, 0]
    body = vessel(sections, [steel, art], which, 20)
    lid = can_lid(r, 0.972 * h, steel, state != "shut")
    solids = [cylinder_piece(r, 0.03 * h, 0.93 * h, 14), cylinder_piece(0.8 * r, 0, h, 12)]
    if crushed:
        rng = np.random.default_rng(4)
        phase = rng.uniform(0, 6.28, 3)

        def crush(x, y, z):
            t = z / h
            pinch = math.exp(-(((t - 0.5) / 0.2) ** 2))
            a = math.atan2(y, x)
            k = 1 - pinch * (
                0.28 + 0.2 * math.sin(3 * a + phase[0]) + 0.1 * math.sin(7 * t * 6 + phase[1])
            )
            lean = 0.016 * pinch
            q = 0.78 * z if t < 0.5 else 0.78 * z + 0.10 * x * (t - 0.5) * 2 * 4 * (t - 0.4)
            return x * k + lean * (t > 0) + 0.012 * max(0, t - 0.45), y * k * 1.03, q

        for mesh in (body, *lid):
            mesh.warp(crush)
        solids = "hull"
    kind = {"shut": "can of", "open": "opened can of", "crushed": "crushed can of"}[state]
    return Model(
        title=f"{kind} {word.lower()}",
        parts={"body": Part([body.weigh(1.2), *lid], collision=solids)},
        mass=0.02 if crushed else 0.12 + h * r * r * 2800,
        friction=0.45,
    )


def six_pack(
    radius: float, height: float, word: str, sub: str, colour: str, accent: str, motif: str
) -> Model:
    """Six cans held by a sheet of film below their rims."""
    r, h = radius, height
    steel = metal("c9ced2", "868c91", (8, 8, 1), 60)
    art = label(can_print(word, sub, colour, accent, "#ffffff", getattr(groceries, motif)))
    steps = [(0, 0.78), (0.05, 1.0), (0.88, 1.0), (0.975, 0.84), (1.0, 0.84), (0.972, 0.78)]
    can = [
        vessel([(z * h, k * r, k * r, 2.0) for z, k in steps], [steel, art], [0, 1, 0, 0, 0], 10),
        box(0.022, 0.014, 0.002, (-0.004, 0, 0.972 * h), plain("#8c9298", 0)),
    ]
    middles = [(x, y) for x in (-r, r) for y in (-2 * r, 0, 2 * r)]
    meshes = [mesh.copy().move(x, y) for x, y in middles for mesh in can]
    film = box(3.4 * r, 5.4 * r, 0.0015, (0, 0, 0.86 * h), plain("#dfe6ea", 0.03))
    return Model(
        title=f"six-pack of {word.lower()}",
        parts={
            "body": Part(
                [*meshes, film],
                collision=[cylinder_piece(r, 0, h, 10) + np.array([x, y, 0]) for x, y in middles],
            )
        },
        mass=2.1,
        friction=0.5,
    )


COLA = {
    "word": "COLA",
    "sub": "ORIGINAL",
    "colour": "#c8141e",
    "accent": "#ffffff",
    "motif": "cola",
}

# Not orange: small in a picture, such a can is an amber bottle of pills.
BERRY = {
    "word": "BERRY",
    "sub": "SODA",
    "colour": "#d8357a",
    "accent": "#ffffff",
    "motif": "cola",
}

LEMON = {"word": "LEMON", "sub": "SODA", "colour": "#3f9a2c", "accent": "#fbec3a", "motif": "lemon"}

ENERGY = {
    "word": "ENERGY",
    "sub": "DRINK",
    "colour": "#8fd02a",
    "accent": "#14301c",
    "motif": "cola",
}

STANDARD = {"radius": 0.033, "height": 0.1155}

MODELS = {
    "soda_can": Maker(
        by_style("soda_can", {"can": soda_can, "pack": six_pack}),
        lambda rng: {},
        count=8,
        presets=[
            {"style": "can", **STANDARD, **COLA},
            {"style": "can", **STANDARD, **BERRY},
            {"style": "can", "radius": 0.0265, "height": 0.134, **ENERGY},
            {"style": "can", "radius": 0.033, "height": 0.168, **LEMON},
            {"style": "can", "radius": 0.0265, "height": 0.09, **BERRY},
            {"style": "pack", **STANDARD, **COLA},
            {"style": "can", "radius": 0.033, "height": 0.168, **ENERGY},
            {"style": "can", **STANDARD, **COLA, "state": "crushed"},
        ],
    ),
}
