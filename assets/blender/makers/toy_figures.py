"""Toy figures a child could swallow parts of."""

from __future__ import annotations

import numpy as np
from toolkit.labels import canvas
from toolkit.materials import Material, metal, plain
from toolkit.materials import label as printed
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part
from toolkit.shapes import box, ellipsoid, lathe, tube

from makers.projection import project_label
from makers.solids import cylinder, grounded, grown, solids


def _limbs(meshes: list[Mesh], height: float) -> list[list[Mesh]]:
    """Legs, trunk, arms and head of a figure, by where they are."""
    groups: dict[str, list[Mesh]] = {}
    for mesh in meshes:
        _, y, z = mesh.v.mean(0) / height
        name = "legs" if z < 0.33 else "head" if z > 0.64 else "trunk"
        if name == "trunk" and abs(y) > 0.15:
            name = "left" if y > 0 else "right"
        groups.setdefault(name, []).append(mesh)
    return list(groups.values())


def little_man(
    height: float, coat: str, trousers: str, hat: str, skin: str, metal_man: bool
) -> Model:
    """A chunky plastic man with a helmet, or a robot, facing +X."""
    cloth, legs = plain(coat, 0.03), plain(trousers, 0.03)
    dark, light = plain("#26282c", 0.03), plain("#f2f2ee", 0.02)
    flesh, top = plain(skin, 0.03), plain(hat, 0.03)
    meshes: list[Mesh] = []
    for side in (-1, 1):
        meshes.append(box(0.017, 0.0125, 0.006, (0.002, side * 0.0075, 0), dark, 0.001))
        meshes.append(box(0.013, 0.0125, 0.022, (0, side * 0.0075, 0.006), legs, 0.001))
        arm = [(0, side * 0.015, 0.049), (0.003, side * 0.02, 0.04), (0.011, side * 0.02, 0.031)]
        meshes.append(tube(arm, 0.0045, 6, mat=cloth))
        meshes.append(ellipsoid(0.0052, (0.013, side * 0.02, 0.0295), 6, 4, flesh))
    chest, draw = canvas(96, 96, coat)
    if metal_man:
        draw.rectangle((18, 14, 78, 70), fill="#26282c")
        for k, colour in enumerate(("#e83a2c", "#f2c52a", "#2fc06a")):
            draw.ellipse((24 + 18 * k, 22, 38 + 18 * k, 36), fill=colour)
        draw.rectangle((26, 46, 70, 62), fill="#4fd0f0")
    else:
        draw.rectangle((0, 58, 96, 76), fill="#f4f040")
        draw.rectangle((42, 0, 54, 96), fill="#f2f2ee")
    body = box(0.019, 0.029, 0.026, (0, 0, 0.027), cloth, 0, 1, {"+x": printed(chest)})
    meshes.append(body.warp(lambda x, y, z: (x, y * (1 - 6 * (z - 0.027)), z)))
    face, draw = canvas(96, 96, skin)
    if metal_man:
        draw.rectangle((16, 24, 80, 50), fill="#1c1c20")
        for x in (24, 56):
            draw.ellipse((x, 28, x + 18, 46), fill="#f2c52a")
        for x in range(24, 76, 12):
            draw.rectangle((x, 62, x + 6, 80), fill="#1c1c20")
        head = box(0.02, 0.022, 0.02, (0, 0, 0.054), flesh, 0.0015, 1, {"+x": printed(face)})
        meshes.append(head)
        meshes.append(tube([(0, 0, 0.074), (0, 0, 0.08)], 0.0014, 5, mat=dark))
        meshes.append(ellipsoid(0.0032, (0, 0, 0.082), 6, 4, plain("#e83a2c", 0)))
    else:
        for x in (26, 56):
            draw.ellipse((x, 34, x + 13, 52), fill="#1c1c20")
        draw.arc((26, 40, 70, 78), 25, 155, fill="#a02020", width=6)
        profile = [
            (0, 0),
            (0.0085, 0.001),
            (0.0105, 0.007),
            (0.0105, 0.013),
            (0.008, 0.02),
            (0, 0.022),
        ]
        head = lathe(profile, 12, mat=flesh).move(z=0.053)
        project_label(head, printed(face, base=skin), "+x", (0, 0.063), (0.018, 0.018), 0.35)
        meshes.append(head)
        brim = [(0, 0), (0.017, 0), (0.0165, 0.002), (0.0122, 0.003), (0.011, 0.009), (0, 0.0135)]
        meshes.append(lathe(brim, 12, mat=top).move(-0.001, 0, 0.067))
        meshes.append(box(0.003, 0.007, 0.008, (0.0105, 0, 0.07), light, 0.0005))
    s = height / 0.081
    for mesh in meshes:
        mesh.scale(s)
    return Model(
        "toy robot" if metal_man else "toy fireman",
        {"body": Part(meshes, collision=solids(*_limbs(meshes, height)))},
        mass=0.09,
        friction=0.5,
        texture_size=256,
    )


def _smile(skin: str, eyes: str = "#1c1c20") -> Material:
    """A face to project."""
    face, draw = canvas(96, 96, skin)
    for x in (26, 56):
        draw.ellipse((x, 34, x + 13, 52), fill=eyes)
    draw.arc((26, 40, 70, 78), 25, 155, fill="#a02020", width=6)
    return printed(face, base=skin)


def _ball_head(z: float, skin: str, radius: float = 0.0105) -> Mesh:
    head = ellipsoid((radius, radius, radius * 1.1), (0, 0, z), 12, 7, plain(skin, 0.03))
    return project_label(head, _smile(skin), "+x", (0, z), (0.018, 0.018), 0.35)


def _legs(paint: Material, boots: Material) -> list[Mesh]:
    out = []
    for side in (-1, 1):
        out.append(box(0.018, 0.0125, 0.007, (0.002, side * 0.0075, 0), boots, 0.001))
        out.append(box(0.013, 0.0125, 0.022, (0, side * 0.0075, 0.006), paint, 0.001))
    return out


def knight(coat: str, plume: str) -> list[Mesh]:
    """In armour, with a helmet, a shield and a raised sword."""
    steel, cloth, dark = metal("c2c7cc", "767d84"), plain(coat, 0.03), plain("#17181a", 0)
    cross, draw = canvas(96, 96, coat)
    draw.rectangle((38, 0, 58, 96), fill="#f6f4ee")
    draw.rectangle((0, 30, 96, 50), fill="#f6f4ee")
    meshes = _legs(steel, steel)
    meshes.append(box(0.019, 0.029, 0.027, (0, 0, 0.027), cloth, 0, 1, {"+x": printed(cross)}))
    helmet = [(0.0105, 0), (0.0118, 0.012), (0.0105, 0.02), (0.006, 0.0255), (0, 0.0265)]
    meshes.append(lathe([(0, 0), *helmet], 12, mat=steel).move(z=0.054))
    meshes.append(box(0.006, 0.017, 0.0032, (0.0095, 0, 0.0655), dark))
    meshes.append(box(0.0055, 0.003, 0.011, (0.0098, 0, 0.0545), dark))
    feather = [(0, 0, 0.079), (-0.004, 0, 0.089), (-0.014, 0, 0.09), (-0.02, 0, 0.08)]
    meshes.append(tube(feather, [0.002, 0.0045, 0.0045, 0.0015], 6, mat=plain(plume, 0.1, 300)))
    arms = [[(0, 0.016, 0.05), (0.007, 0.023, 0.044), (0.018, 0.023, 0.043)]]
    arms.append([(0, -0.016, 0.05), (0.006, -0.023, 0.042), (0.017, -0.025, 0.047)])
    meshes += [tube(p, 0.005, 6, mat=steel) for p in arms]
    meshes.append(
        box(0.005, 0.024, 0.03, (0.023, 0.02, 0.026), cloth, 0, 1, {"+x": printed(cross)})
    )
    blade = box(0.0045, 0.0065, 0.045, (0.019, -0.026, 0.054), metal("e2e6ea", "9aa2aa"))
    guard = box(0.0045, 0.018, 0.0045, (0.019, -0.026, 0.05), plain("#d8a828", 0.03))
    hilt = box(0.0045, 0.0045, 0.012, (0.019, -0.026, 0.04), dark)
    return [*meshes, blade, guard, hilt]


def princess(dress: str, hair: str, skin: str) -> list[Mesh]:
    """A wide gown, long hair and a crown."""
    gown, gold, flesh = plain(dress, 0.04), plain("#f2b91c", 0.03), plain(skin, 0.03)
    skirt = [(0, 0), (0.023, 0), (0.0235, 0.004), (0.016, 0.022), (0.0085, 0.035), (0.0105, 0.048)]
    meshes = [lathe([*skirt, (0.006, 0.053), (0, 0.054)], 14, mat=gown)]
    meshes.append(cylinder(0.0092, 0.003, (0, 0, 0.034), gold, 10))
    for q in (-1, 1):
        arm = [(0, q * 0.01, 0.048), (0.005, q * 0.017, 0.039), (0.013, q * 0.012, 0.036)]
        meshes.append(tube(arm, [0.0036, 0.0034, 0.0034], 6, mat=flesh))
        meshes.append(ellipsoid((0.005, 0.0055, 0.005), (0, q * 0.011, 0.048), 6, 4, gown))
    meshes.append(_ball_head(0.0625, skin))
    locks = plain(hair, 0.15, 300)
    meshes.append(ellipsoid((0.0105, 0.0122, 0.0125), (-0.0035, 0, 0.0645), 9, 6, locks))
    meshes.append(ellipsoid((0.006, 0.0115, 0.02), (-0.0085, 0, 0.051), 8, 5, locks))
    crown = [(0.0075, 0), (0.0095, 0.0085), (0.0078, 0.005), (0.006, 0.0005)]
    meshes.append(
        lathe(crown, 10, mat=gold, rib=lambda k, i: 1.15 if k == 1 and i % 2 else 1.0).move(
            z=0.0735
        )
    )
    return meshes


def astronaut(suit: str, badge: str) -> list[Mesh]:
    """A thick white suit, a round helmet with a dark visor, a back pack."""
    white, grey, red = plain(suit, 0.03), plain("#9aa2aa", 0.04), plain(badge, 0)
    meshes = []
    panel, draw = canvas(96, 96, suit)
    draw.rounded_rectangle((16, 34, 80, 84), 8, fill="#9aa2aa")
    for k, colour in enumerate(("#e83a2c", "#f2c52a", "#2fa04a")):
        draw.ellipse((22 + 19 * k, 42, 36 + 19 * k, 56), fill=colour)
    draw.rectangle((24, 64, 72, 76), fill="#2f6fd0")
    for q in (-1, 1):
        meshes.append(box(0.02, 0.0145, 0.008, (0.002, q * 0.0085, 0), grey, 0.002))
        meshes.append(cylinder(0.0078, 0.022, (0, q * 0.0085, 0.007), white, 9))
        arm = [(0, q * 0.015, 0.048), (0.003, q * 0.024, 0.041), (0.012, q * 0.027, 0.034)]
        meshes.append(tube(arm, 0.0062, 7, mat=white))
        meshes.append(ellipsoid(0.0065, (0.015, q * 0.0275, 0.0325), 6, 4, red))
    meshes.append(box(0.021, 0.031, 0.027, (0, 0, 0.027), white, 0, 1, {"+x": printed(panel)}))
    meshes.append(box(0.013, 0.027, 0.03, (-0.0165, 0, 0.028), grey, 0.002))
    meshes.append(ellipsoid(0.0165, (0, 0, 0.0665), 12, 8, white))
    visor = Material()
    glint = visor.remap(visor.distance((0.016, 0.006, 0.073)), 0.003, 0.004, 1, 0)
    visor.colour(visor.mix(glint, "#1d2a44", "#ffffff"))
    meshes.append(ellipsoid((0.0125, 0.0125, 0.0105), (0.0062, 0, 0.067), 10, 6, visor))
    return meshes


def rider(horse: str, mane: str, shirt: str, skin: str) -> list[Mesh]:
    """A cowboy on a horse."""
    coat, dark = plain(horse, 0.08, 200), plain(mane, 0.08, 200)
    meshes = [ellipsoid((0.027, 0.0125, 0.0135), (0, 0, 0.036), 9, 6, coat)]
    for x, q in ((-0.018, -1), (-0.018, 1), (0.017, -1), (0.019, 1)):
        leg = [(x, q * 0.0075, 0.034), (x, q * 0.0075, 0.016), (x, q * 0.0075, 0)]
        meshes.append(tube(leg, [0.0058, 0.004, 0.0044], 5, mat=coat))
        meshes.append(cylinder(0.0052, 0.005, (x, q * 0.0075, 0), dark, 5))
    neck = [(0.018, 0, 0.042), (0.03, 0, 0.06), (0.034, 0, 0.066)]
    meshes.append(tube(neck, [0.0105, 0.0075, 0.0065], 6, mat=coat))
    nose = [(0.03, 0, 0.066), (0.046, 0, 0.058), (0.051, 0, 0.055)]
    meshes.append(tube(nose, [0.0072, 0.0058, 0.0045], 6, mat=coat))
    crest = [(0.036, 0, 0.073), (0.026, 0, 0.066), (0.015, 0, 0.05)]
    meshes.append(tube(crest, [0.003, 0.0042, 0.003], 4, mat=dark))
    tail = [(-0.026, 0, 0.042), (-0.036, 0, 0.034), (-0.037, 0, 0.014)]
    meshes.append(tube(tail, [0.003, 0.0055, 0.002], 5, mat=dark))
    for q in (-1, 1):
        meshes.append(cylinder(0.0025, 0.007, (0.031, q * 0.0045, 0.07), coat, 5, top=0.0006))
        leg = [(-0.003, q * 0.006, 0.05), (0.006, q * 0.015, 0.042), (0.003, q * 0.0155, 0.026)]
        meshes.append(tube(leg, 0.0048, 5, mat=plain("#2a4a80", 0.04)))
        arm = [(-0.002, q * 0.009, 0.069), (0.006, q * 0.013, 0.06), (0.017, q * 0.006, 0.06)]
        meshes.append(tube(arm, 0.0037, 5, mat=plain(shirt, 0.03)))
    meshes.append(box(0.02, 0.018, 0.006, (-0.002, 0, 0.046), plain("#5a2f18", 0.05)))
    meshes.append(box(0.012, 0.018, 0.025, (-0.003, 0, 0.049), plain(shirt, 0.03)))
    face = _ball_head(0.081, skin, 0.0082)
    meshes.append(face.move(x=-0.002))
    hat = [(0, 0), (0.0155, 0.001), (0.016, 0.003), (0.0085, 0.003), (0.0075, 0.0115), (0, 0.0125)]
    brown = plain("#7a4a22", 0.05)
    brim = lathe(hat, 10, mat=brown).warp(lambda x, y, z: (x, y, z + 12 * y * y * (z < 0.005)))
    meshes.append(brim.move(-0.003, 0, 0.0875))
    return meshes


def toy_figure(kind: str, height: float, colours: list[str]) -> Model:
    """'fireman', 'robot', 'knight', 'princess', 'astronaut' or 'rider'."""
    if kind in ("fireman", "robot"):
        return little_man(height, *colours[:4], kind == "robot")
    makers = {"knight": knight, "princess": princess, "astronaut": astronaut, "rider": rider}
    meshes = makers[kind](*colours)
    tall = max(float(m.v[:, 2].max()) for m in meshes)
    grounded(grown(meshes, height / tall))
    low = [m for m in meshes if m.v[:, 2].mean() < 0.55 * height]
    high = [m for m in meshes if not m.v[:, 2].mean() < 0.55 * height]
    body = Part(meshes, collision=solids(low, high))
    name = "toy cowboy on a horse" if kind == "rider" else f"toy {kind}"
    return Model(name, {"body": body}, mass=0.09, friction=0.5)


def toy_figure_random(rng: np.random.Generator) -> dict:
    # As large as toddlers' figures are: smaller ones read as bricks' men, which are small parts.
    return {"height": 0.14}


MODELS = {
    "toy_figure": Maker(
        toy_figure,
        toy_figure_random,
        7,
        [
            {"kind": "fireman", "colours": ["#c8202c", "#1c2a50", "#f2c52a", "#f0c49a"]},
            {"kind": "knight", "height": 0.16, "colours": ["#2f5fc0", "#d8202c"]},
            {
                "kind": "robot",
                "height": 0.17,
                "colours": ["#2f7fd0", "#8a929a", "#c9cdd1", "#c0c8d0"],
            },
            {"kind": "princess", "colours": ["#e0609a", "#f0c040", "#f0c49a"]},
            {"kind": "astronaut", "height": 0.16, "colours": ["#f2f2ee", "#e8641c"]},
            {
                "kind": "rider",
                "height": 0.17,
                "colours": ["#8a5228", "#2a1a12", "#c8202c", "#f0c49a"],
            },
            {"kind": "fireman", "colours": ["#e8701c", "#3a4a5a", "#f6d32a", "#c98a5c"]},
        ],
    ),
}
