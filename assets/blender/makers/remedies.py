"""Medicine that tempts: syrup, vitamins, ointment, blister packs; and mouthwash."""

from __future__ import annotations

import math

import numpy as np
from labels.hazards import cleaner_front, front, remedy_band
from toolkit.labels import canvas, text
from toolkit.materials import Material, metal, plain, shade
from toolkit.materials import label as printed
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part, box_piece, cylinder_piece
from toolkit.sampling import pick, uniform
from toolkit.shapes import lathe, loft, rounded_rectangle, superellipse

from makers.bottle_shapes import cap, oval_body
from makers.choking import loose
from makers.poisons import both_sides
from makers.projection import project_label


def glassy(colour: str, height: float) -> Material:
    """Dark glass with a painted upright reflection."""
    m = Material(occlusion=0.6)
    shine = m.remap(m.math("ABSOLUTE", m.math("ADD", m.normal(1), 0.5)), 0.02, 0.1, 0.55, 0)
    z = m.remap(m.axis(2), 0, height)
    body = m.ramp(
        z, [(0, shade(colour, 0.6)), (0.1, colour), (0.8, colour), (1, shade(colour, 1.3))]
    )
    return m.colour(m.mix(shine, body, "ffffff"))


def cough_syrup(
    height: float, glass: str, paper: str, colour: str, lid: str, cup: bool, brand: str
) -> Model:
    """A brown bottle, its measuring cup over the cap or a plain child-proof cap."""
    s, r = height / 0.15, 0.029
    words = ["COUGH", "SYRUP"]
    label = printed(remedy_band(brand, words, paper, colour, "cross", "200 ml"))
    low, high = 0.014 * s, 0.086 * s
    profile = [(0, 0.0015), (r * 0.9, 0), (r, 0.004), (r, low), (r * 1.01, low), (r * 1.01, high)]
    profile += [(r, high), (r, 0.092 * s), (r * 0.86, 0.104 * s), (r * 0.5, 0.114 * s)]
    profile += [(r * 0.46, 0.122 * s), (0, 0.122 * s)]
    bottle = lathe(
        profile,
        20,
        mats=[glassy(glass, 0.12 * s), label],
        mat_of_segment=[1 if k == 4 else 0 for k in range(len(profile) - 1)],
        label_z=(low, high),
        start=-math.pi,
        weight=1.2,
    )
    z = 0.117 * s
    meshes = [bottle, cap(0.0165, z, 0.023 * s, plain(lid, 0.02), 18, 0.96)]
    pieces = [
        cylinder_piece(r, 0, 0.094 * s, 12),
        cylinder_piece(r * 0.9, 0.094 * s, z, 10, 0.016),
        cylinder_piece(0.017, z, z + 0.023 * s, 10),
    ]
    if cup:
        clear = plain("#e6eef2", 0.03)
        rings = [(0.0, z + 0.01), (0.0225, z + 0.01), (0.0195, z + 0.033 * s), (0, z + 0.034 * s)]
        meshes.append(lathe(rings, 16, mat=clear))
        pieces[-1] = cylinder_piece(0.022, z + 0.01, z + 0.034 * s, 10, 0.0195)
    return Model(
        "bottle of cough syrup", {"body": Part(meshes, collision=pieces)}, mass=0.32, friction=0.5
    )


def cough_syrup_random(rng: np.random.Generator) -> dict:
    return {
        "height": uniform(rng, 0.14, 0.165),
        "brand": pick(rng, ["TUSSILEX", "Bronchia", "HUSTOL"]),
    }


def vitamin_jar(
    height: float, radius: float, body: str, paper: str, colour: str, lid: str, words: list[str]
) -> Model:
    """A wide jar of vitamin tablets or gummies with a broad ribbed lid."""
    r, shoulder = radius, height * 0.76
    label = printed(remedy_band("VITALUX", words, paper, colour, "orange", "120"))
    low, high = 0.1 * height, 0.66 * height
    profile = [(0, 0.001), (r * 0.92, 0), (r, 0.004), (r, low), (r * 1.01, low), (r * 1.01, high)]
    profile += [
        (r, high),
        (r, shoulder - 0.008),
        (r * 0.84, shoulder),
        (r * 0.84, shoulder + 0.003),
    ]
    jar = lathe(
        [*profile, (0, shoulder + 0.003)],
        22,
        mats=[plain(body, 0.03), label],
        mat_of_segment=[1 if k == 4 else 0 for k in range(len(profile))],
        label_z=(low, high),
        start=-math.pi,
        weight=1.2,
    )
    top = cap(r * 0.98, shoulder + 0.002, height - shoulder - 0.002, plain(lid, 0.02), 26, 0.98)
    pieces = [cylinder_piece(r, 0, shoulder, 12), cylinder_piece(r, shoulder, height, 12)]
    return Model(
        "jar of vitamins", {"body": Part([jar, top], collision=pieces)}, mass=0.16, friction=0.5
    )


def vitamin_jar_random(rng: np.random.Generator) -> dict:
    return {"height": uniform(rng, 0.105, 0.125), "radius": uniform(rng, 0.033, 0.037)}


def ointment_tube(
    length: float, body: str, band: str, ink: str, lid: str, words: list[str]
) -> Model:
    """A tube lying on its back, cap towards -Y, label up."""
    s = length / 0.13
    rings = []
    for y, wide, tall in (
        (-0.043, 0.0125, 0.0125),
        (-0.038, 0.0165, 0.0145),
        (-0.01, 0.0175, 0.0125),
        (0.03, 0.019, 0.0075),
        (0.06, 0.0205, 0.003),
        (0.068, 0.021, 0.003),
    ):
        ring = superellipse(wide, tall, 2.1, 14)
        rings.append(np.c_[ring[:, 0], np.full(14, y * s), ring[:, 1] + tall * 0.96])
    foil = loft(rings, mat=plain(body, 0.03)).weigh(1.2)
    picture, draw = canvas(384, 128, body)
    draw.rectangle((0, 0, 384, 46), fill=band)
    text(draw, words[0], (20, 4, 364, 42), "oblique", "#ffffff")
    text(draw, words[1], (96, 52, 376, 102), "bold", ink)
    draw.rectangle((20, 76, 80, 92), fill="#d01828")
    draw.rectangle((42, 54, 58, 114), fill="#d01828")
    draw.rectangle((110, 108, 330, 114), fill=ink)
    # the words run along the tube: turned a quarter, so that they read from its side
    label = printed(picture.convert("RGB").transpose(2), base=body)
    project_label(foil, label, "+z", (0.012 * s, 0), (0.11 * s, 0.036), 0.2)
    foil.label_uv = [[(1 - v, u) for u, v in face] for face in foil.label_uv]
    lid_mesh = lathe(
        [(0, 0), (0.012, 0), (0.0135, 0.022 * s), (0, 0.022 * s)],
        12,
        mat=plain(lid, 0.02),
        rib=lambda k, i: 1 - 0.05 * (i % 2) if k in (1, 2) else 1,
    )
    lid_mesh.turn(rx=math.pi / 2).move(0, -0.042 * s, 0.0132)
    meshes = [foil, lid_mesh]
    pieces = [np.concatenate(rings[:3]), np.concatenate(rings[2:]), lid_mesh.v]
    return Model(
        "tube of ointment", {"body": Part(meshes, collision=pieces)}, mass=0.06, friction=0.5
    )


def ointment_tube_random(rng: np.random.Generator) -> dict:
    return {"length": uniform(rng, 0.125, 0.145)}


def blister(colour: str, first: str, rows: int, word: str, empty: set[int]) -> list[Mesh]:
    """A blister of tablets, cells up; a few pressed out. Long along y."""
    wide, long = 0.048, 0.019 * rows
    picture, draw = canvas(128, 48 * rows, "#c9ced3")
    for y in range(-128, 48 * rows, 22):
        draw.line((0, y, 128, y + 64), fill="#aeb5bc", width=4)
    draw.rectangle((50, 0, 78, 48 * rows), fill="#f2f4f6")
    strip, pen = canvas(48 * rows, 26)
    text(pen, word, (6, 2, 48 * rows - 6, 24), "bold", colour)
    turned = strip.rotate(90, expand=True)
    picture.paste(turned, (51, 0), turned)
    foil = metal("c9ced3", "969da4", occlusion=0.5)
    outline = rounded_rectangle(wide, long, 0.004, 2)
    card = loft([np.c_[outline, np.full(len(outline), z)] for z in (0, 0.0045)], mat=foil)
    project_label(card, printed(picture, occlusion=0.6), "+z", (0, 0), (long, wide))
    # laid on anew: the words run along y
    card.label_uv = [
        [(card.v[i][0] / wide + 0.5, card.v[i][1] / long + 0.5) for i in face] for face in card.f
    ]
    meshes = [card]
    clear, hole = plain(first, 0.02, occlusion=0.7), plain("#54595f", 0.1, occlusion=0.6)
    for k in range(rows * 2):
        x, y = (-1 if k % 2 else 1) * 0.0145, (k // 2 - (rows - 1) / 2) * 0.0182
        if k in empty:
            flat = [(0, 0), (0.0066, 0), (0.006, 0.0004), (0, 0.0004)]
            meshes.append(lathe(flat, 8, mat=hole).move(x, y, 0.0044))
            continue
        dome = [(0.0072, 0), (0.0058, 0.0036), (0, 0.0045)]
        meshes.append(lathe(dome, 8, mat=clear).move(x, y, 0.0044))
    return meshes


def blister_pack(pairs: list[tuple[str, str, str]], rows: int, empty: list[int]) -> Model:
    """One blister pack, or two side by side: (colour of the words, tablets, words)."""
    pieces = []
    for k, (colour, tablet, word) in enumerate(pairs):
        piece = blister(colour, tablet, rows, word, set(empty) if k == 0 else set())
        if len(pairs) > 1:
            for mesh in piece:
                mesh.turn(rz=-0.2 + 0.55 * k).move(-0.028 + 0.06 * k, 0.004 * k)
        pieces.append(piece)
    return loose("blister pack of tablets", pieces, 0.012 * len(pairs), shadow=False)


def blister_pack_random(rng: np.random.Generator) -> dict:
    return {"rows": 5, "empty": [1, 4]}


def mouthwash(
    height: float, liquid: str, paper: str, band: str, ink: str, lid: str, brand: str
) -> Model:
    """A flat clear bottle of bright liquid with a big cap that measures."""
    s = height / 0.2
    m = Material(occlusion=0.5)
    z = m.remap(m.axis(2), 0, 0.17 * s)
    shine = m.remap(m.math("ABSOLUTE", m.math("ADD", m.normal(1), 0.5)), 0.02, 0.12, 0.5, 0)
    stops = [(0, shade(liquid, 0.75)), (0.08, liquid), (0.82, shade(liquid, 1.15))]
    m.colour(m.mix(shine, m.ramp(z, [*stops, (0.84, "dfeef2"), (1, "eef6f8")]), "ffffff"))
    picture = cleaner_front(brand, ["MOUTH", "WASH"], paper, band, ink, "drop", "")
    steps = [
        (0, 0.9, 0.88),
        (0.005, 1, 1),
        (0.118, 1, 1),
        (0.14, 0.9, 0.92),
        (0.156, 0.5, 0.66),
        (0.166, 0.42, 0.6),
    ]
    bottle = oval_body([(h * s, w, d) for h, w, d in steps], 0.084, 0.052, m, 3.4).weigh(1.2)
    both_sides(bottle, printed(picture, base=liquid), 0.064 * s, 0.066, 0.098 * s, 0.035)
    lid_mesh = cap(0.0215, 0.16 * s, 0.04 * s, plain(lid, 0.02), 18, 0.93)
    pieces = [
        box_piece((0, 0, 0.072 * s), (0.05, 0.082, 0.144 * s)),
        cylinder_piece(0.022, 0.144 * s, 0.2 * s, 10),
    ]
    part = Part([bottle, lid_mesh], collision=pieces)
    return Model("bottle of mouthwash", {"body": part}, mass=0.58, friction=0.5)


def mouthwash_random(rng: np.random.Generator) -> dict:
    return {"height": uniform(rng, 0.185, 0.225), "brand": pick(rng, ["DENTIVA", "Frescol"])}


def face_cream(radius: float, height: float, body: str, lid: str, ink: str, brand: str) -> Model:
    """A low jar of cream, its name on the lid and the front."""
    r, seam = radius, height * 0.56
    jar = lathe(
        [(0, 0), (r * 0.9, 0), (r, 0.004), (r, seam), (r * 0.9, seam + 0.001), (0, seam + 0.001)],
        22,
        mat=plain(body, 0.03),
    )
    label = printed(front(brand, ["FACE CREAM"], ink, ink), base=body)
    project_label(jar, label, "+x", (0, seam / 2), (r * 1.3, seam * 0.95), 0.55)
    top_label = printed(front(brand, ["FACE", "CREAM"], ink, ink), base=lid)
    top = lathe(
        [(0, seam), (r * 1.03, seam), (r * 1.03, height - 0.003), (r * 0.97, height), (0, height)],
        22,
        mat=plain(lid, 0.03),
    )
    project_label(top, top_label, "+z", (0, 0), (r * 1.7, r * 1.7), 0.9)
    pieces = [cylinder_piece(r * 1.02, 0, height, 14)]
    part = Part([jar.weigh(1.1), top], collision=pieces)
    return Model("jar of face cream", {"body": part}, mass=0.12, friction=0.5)


def face_cream_random(rng: np.random.Generator) -> dict:
    return {"radius": uniform(rng, 0.032, 0.038), "height": uniform(rng, 0.045, 0.055)}


MODELS = {
    "cough_syrup": Maker(
        cough_syrup,
        cough_syrup_random,
        3,
        [
            {
                "glass": "#5a2a0c",
                "paper": "#ffffff",
                "colour": "#b01828",
                "lid": "#f4f4f0",
                "cup": False,
            },
            {
                "glass": "#6a340e",
                "paper": "#fff2c8",
                "colour": "#1f7a3c",
                "lid": "#f4f4f0",
                "cup": True,
            },
            {
                "glass": "#8a1428",
                "paper": "#ffffff",
                "colour": "#5a2a8c",
                "lid": "#5a2a8c",
                "cup": False,
            },
        ],
    ),
    "vitamin_jar": Maker(
        vitamin_jar,
        vitamin_jar_random,
        3,
        [
            {
                "body": "#f4f4ee",
                "paper": "#fff4d0",
                "colour": "#e05a0c",
                "lid": "#e05a0c",
                "words": ["VITAMIN", "C"],
            },
            {
                "body": "#5a2c0c",
                "paper": "#ffffff",
                "colour": "#1f7a3c",
                "lid": "#f4f4ee",
                "words": ["MULTI", "VITAMIN"],
            },
            {
                "body": "#f2c52a",
                "paper": "#ffffff",
                "colour": "#1f5fb8",
                "lid": "#1f5fb8",
                "words": ["VITAMIN", "D3"],
            },
        ],
    ),
    "ointment_tube": Maker(
        ointment_tube,
        ointment_tube_random,
        2,
        [
            {
                "body": "#f4f4f0",
                "band": "#1f5fb8",
                "ink": "#1f3f8c",
                "lid": "#1f5fb8",
                "words": ["DERMAZOL", "OINTMENT"],
            },
            {
                "body": "#f6d84a",
                "band": "#c8202c",
                "ink": "#8a1420",
                "lid": "#c8202c",
                "words": ["ARNIVEN", "PAIN GEL"],
            },
        ],
    ),
    "blister_pack": Maker(
        blister_pack,
        blister_pack_random,
        3,
        [
            {"pairs": [("#1f4fa8", "#3f86e0", "DOLOREX 400")]},
            {
                "pairs": [
                    ("#b01828", "#e8483a", "FEBRAN 200"),
                    ("#1f4fa8", "#3f86e0", "DOLOREX 400"),
                ]
            },
            {"pairs": [("#1f7a3c", "#f2c52a", "ALLERGINA")], "empty": [0, 5, 6]},
        ],
    ),
    "mouthwash": Maker(
        mouthwash,
        mouthwash_random,
        2,
        [
            {
                "liquid": "#1fa0d8",
                "paper": "#ffffff",
                "band": "#143a8c",
                "ink": "#143a8c",
                "lid": "#f4f4f4",
                "brand": "DENTIVA",
            },
            {
                "liquid": "#2fb86a",
                "paper": "#0f5a3c",
                "band": "#0a3a28",
                "ink": "#ffffff",
                "lid": "#1c1c20",
                "brand": "Frescol",
            },
        ],
    ),
    "face_cream": Maker(
        face_cream,
        face_cream_random,
        2,
        [
            {"body": "#f2dbe0", "lid": "#f8f4f0", "ink": "#a0305c", "brand": "Lavara"},
            {"body": "#2f6fb8", "lid": "#1f4f94", "ink": "#f4f8ff", "brand": "SENTA"},
        ],
    ),
}
