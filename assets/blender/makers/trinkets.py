"""Small things for small hands: toy figures, a limp balloon, hair clips."""

from __future__ import annotations

import math

import numpy as np
from toolkit.labels import canvas
from toolkit.materials import Material, metal, plain, shade
from toolkit.materials import label as printed
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part, box_piece, cylinder_piece
from toolkit.sampling import noise_offset, pick, seed_of, uniform
from toolkit.shapes import TAU, box, ellipsoid, extrude, lathe, loft, spline, superellipse, tube

from makers.choking import loose
from makers.convex import few_corners
from makers.projection import project_label


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
    solid = [
        box_piece((0.001, 0, 0.015), (0.02, 0.029, 0.03)),
        box_piece((0.003, 0, 0.041), (0.024, 0.05, 0.024)),
        cylinder_piece(0.014, 0.053, 0.081, 8),
    ]
    return Model(
        "toy robot" if metal_man else "toy fireman",
        {"body": Part(meshes, collision=[p * s for p in solid])},
        mass=0.025,
        friction=0.5,
        texture_size=256,
    )


def dinosaur(height: float, skin: str, belly: str, spikes: str, seed: int) -> Model:
    """A plastic dinosaur on two legs, its head towards +X."""
    rng = np.random.default_rng(seed)
    hide = Material()
    spots = hide.noise(160, 2, offset=noise_offset(rng))
    patched = hide.mix(hide.remap(spots, 0.54, 0.6), skin, shade(skin, 0.55))
    hide.colour(hide.mix(hide.remap(hide.normal(2), -0.75, -0.5, 1, 0), patched, belly))
    spine = [  # x, z, half height, half width
        (-0.068, 0.012, 0.0015, 0.0015),
        (-0.05, 0.014, 0.004, 0.004),
        (-0.03, 0.023, 0.009, 0.008),
        (-0.01, 0.034, 0.014, 0.0125),
        (0.01, 0.043, 0.012, 0.011),
        (0.02, 0.055, 0.0085, 0.008),
        (0.024, 0.066, 0.0085, 0.0085),
        (0.034, 0.069, 0.0085, 0.0085),
        (0.048, 0.066, 0.0055, 0.006),
        (0.052, 0.065, 0.003, 0.004),
    ]
    path = np.array([(x, z) for x, z, _, _ in spine])
    along = np.gradient(path, axis=0)
    rings = []
    for (x, z, tall, wide), (dx, dz) in zip(spine, along, strict=True):
        n = np.array([-dz, dx]) / math.hypot(dx, dz)
        ring = []
        for a in (TAU * k / 8 for k in range(8)):
            up = tall * math.cos(a)
            ring.append((x + n[0] * up, wide * math.sin(a), z + n[1] * up))
        rings.append(ring)
    meshes = [loft(rings, mat=hide)]
    foot, white, black = plain(shade(skin, 0.8), 0.05), plain("#f6f4ea", 0), plain("#141416", 0)
    for side in (-1, 1):
        leg = [
            (-0.008, side * 0.011, 0.034),
            (0.004, side * 0.014, 0.02),
            (-0.002, side * 0.014, 0.004),
        ]
        meshes.append(tube(leg, [0.0085, 0.0065, 0.005], 7, mat=hide))
        meshes.append(box(0.022, 0.012, 0.006, (0.005, side * 0.014, 0), foot, 0.0012))
        arm = [
            (0.017, side * 0.009, 0.046),
            (0.026, side * 0.011, 0.04),
            (0.031, side * 0.01, 0.043),
        ]
        meshes.append(tube(arm, [0.0038, 0.0028, 0.002], 5, mat=hide))
        meshes.append(ellipsoid(0.0026, (0.033, side * 0.0075, 0.0745), 6, 4, white))
        meshes.append(ellipsoid(0.0016, (0.0345, side * 0.0093, 0.0748), 5, 3, black))
    plate = plain(spikes, 0.03)
    for x, z, tall, _ in spine[1:7]:
        tip = [
            (x - 0.005, z + tall * 0.7),
            (x + 0.004, z + tall * 0.7),
            (x - 0.006, z + tall + 0.007),
        ]
        meshes.append(extrude(tip, 0.005, plate, axis="y"))
    jaw = box(0.014, 0.0085, 0.0025, (0.045, 0, 0.0615), white)
    meshes.append(jaw)
    s = height / 0.079
    for mesh in meshes:
        mesh.scale(s)
    pieces = [
        box_piece((0.004, 0, 0.02), (0.024, 0.04, 0.04)),
        np.concatenate(rings[:5]),
        np.concatenate(rings[4:]),
    ]
    return Model(
        "toy dinosaur",
        {"body": Part(meshes, collision=[few_corners(p * s) for p in pieces])},
        mass=0.03,
        friction=0.5,
        texture_size=256,
    )


def toy_figure(kind: str, height: float, colours: list[str], seed: int) -> Model:
    """A fireman, a robot or a dinosaur."""
    if kind == "dinosaur":
        return dinosaur(height, *colours[:3], seed)
    return little_man(height, *colours[:4], kind == "robot")


def toy_figure_random(rng: np.random.Generator) -> dict:
    return {"height": uniform(rng, 0.078, 0.09), "seed": seed_of(rng)}


def limp_balloon(paint: str, length: float, rng: np.random.Generator) -> list[Mesh]:
    """A deflated balloon on its side: a wrinkled bag, a neck, a rolled lip. Along +X."""
    m = Material(occlusion=0.9)
    creases = m.noise(90, 3, distortion=1.0, offset=noise_offset(rng), stretch=(0.5, 1.6, 1))
    base = m.ramp(creases, [(0.36, shade(paint, 0.6)), (0.5, paint), (0.68, shade(paint, 1.15))])
    glint = m.remap(m.noise(60, 1, offset=noise_offset(rng)), 0.62, 0.68, 0, 0.55)
    m.colour(m.mix(glint, base, "ffffff"))
    s = length / 0.09
    phase = rng.uniform(0, TAU, 3)
    rings = []
    for x, wide, tall in (
        (-0.045, 0.004, 0.003),
        (-0.043, 0.012, 0.0055),
        (-0.03, 0.021, 0.0065),
        (-0.012, 0.0235, 0.0068),
        (0.006, 0.018, 0.0062),
        (0.018, 0.009, 0.0055),
        (0.026, 0.006, 0.005),
        (0.039, 0.0052, 0.0048),
    ):
        ring = superellipse(wide, tall, 2.2, 14)
        ripple = 1 + 0.09 * np.sin(3 * np.arange(14) * TAU / 14 * 2 + phase[0] + 90 * x)
        bend = 0.004 * math.sin(40 * x + phase[1])
        rings.append(np.c_[np.full(14, x), ring[:, 0] * ripple + bend, ring[:, 1] * ripple])
    bag = loft([r * s for r in rings], mat=m)
    lip_path = [
        (0.04 * s, 0.0075 * s * math.cos(a), 0.0055 * s * math.sin(a))
        for a in (TAU * k / 10 for k in range(10))
    ]
    bend = rings[-1][:, 1].mean() * s
    lip = tube(lip_path, 0.0022 * s, 5, closed=True, mat=plain(shade(paint, 0.85), 0.05))
    lip.move(y=float(bend))
    return [bag, lip]


def balloon(paints: list[str], length: float, seed: int) -> Model:
    """One limp balloon or two across one another's ends."""
    rng = np.random.default_rng(seed)
    pieces = []
    for k, paint in enumerate(paints):
        piece = limp_balloon(paint, length, rng)
        low = min(float(m.v[:, 2].min()) for m in piece)
        for mesh in piece:
            mesh.keep_pattern().turn(rz=0.5 if k == 0 else 2.6).move(0, -0.024 + 0.055 * k, -low)
        pieces.append(piece)
    if len(paints) == 1:
        for mesh in pieces[0]:
            mesh.move(y=0.024)
    return loose("deflated balloon" + "s" * (len(paints) - 1), pieces, 0.003 * len(paints))


def balloon_random(rng: np.random.Generator) -> dict:
    return {"length": uniform(rng, 0.085, 0.1), "seed": seed_of(rng)}


def snap_clip(paint: str, flower: str) -> list[Mesh]:
    """A drop-shaped snap clip with a slot, and a flower at its broad end; along +X."""
    drop = spline(
        [
            (-0.026, 0),
            (-0.022, 0.0075),
            (-0.01, 0.0088),
            (0.008, 0.006),
            (0.026, 0.0028),
            (0.028, 0),
            (0.026, -0.0028),
            (0.008, -0.006),
            (-0.01, -0.0088),
            (-0.022, -0.0075),
        ],
        2,
        closed=True,
    )
    plate = extrude(drop, 0.005, plain(paint, 0.03))
    slot = box(0.03, 0.0042, 0.0008, (0.003, 0, 0.005), metal("c9cdd1", "7e858c"))
    meshes = [plate, slot]
    if flower:
        petals = lathe(
            [(0, 0), (0.009, 0.0005), (0.0092, 0.003), (0, 0.0035)],
            10,
            mat=plain(flower, 0.03),
            rib=lambda k, i: 1.0 if i % 2 else 0.62,
        )
        heart = ellipsoid((0.003, 0.003, 0.002), (-0.014, 0, 0.009), 6, 4, plain("#f6d32a", 0))
        meshes += [petals.move(-0.014, 0, 0.0056), heart]
    return meshes


def bow_clip(paint: str, dots: str) -> list[Mesh]:
    """A ribbon bow on a clip."""
    m = Material()
    cell = m.voronoi(150, randomness=0.0)
    m.colour(m.mix(m.remap(cell, 0.28, 0.32, 1, 0), paint, dots))
    meshes = []
    for side in (-1, 1):
        rings = []
        for x, wide, tall in (
            (0.002, 0.004, 0.004),
            (0.012, 0.011, 0.007),
            (0.023, 0.0145, 0.0075),
        ):
            ring = superellipse(wide, tall, 2.6, 10)
            rings.append(np.c_[np.full(10, side * x), ring[:, 0], ring[:, 1] + 0.008])
        rings.append(rings[-1] * [1, 0.7, 0.55] + [side * 0.0025, 0, 0.0036])
        meshes.append(loft(rings, mat=m))
    knot = plain(shade(paint, 0.7), 0.04)
    meshes.append(ellipsoid((0.005, 0.006, 0.0065), (0, 0, 0.0085), 8, 5, knot))
    meshes.append(box(0.044, 0.006, 0.004, (0, 0, 0), metal("c9cdd1", "7e858c")))
    return meshes


def hair_clips(kind: str, colours: list[tuple[str, str]], seed: int) -> Model:
    """Snap clips side by side, or two bows."""
    rng = np.random.default_rng(seed)
    pieces = []
    pitch = 0.021 if kind == "snap" else 0.036
    for k, (first, second) in enumerate(colours):
        piece = snap_clip(first, second) if kind == "snap" else bow_clip(first, second)
        turn = float(rng.uniform(-0.3, 0.3)) + math.pi * (k % 2)
        y = (k - (len(colours) - 1) / 2) * pitch
        x = float(rng.uniform(-0.006, 0.006))
        pieces.append([m.keep_pattern().turn(rz=turn).move(x, y) for m in piece])
    return loose("hair clips" if kind == "snap" else "hair bows", pieces, 0.02)


def hair_clips_random(rng: np.random.Generator) -> dict:
    return {"kind": pick(rng, ["snap", "bow"]), "seed": seed_of(rng)}


MODELS = {
    "toy_figure": Maker(
        toy_figure,
        toy_figure_random,
        3,
        [
            {"kind": "fireman", "colours": ["#c8202c", "#1c2a50", "#f2c52a", "#f0c49a"]},
            {"kind": "dinosaur", "height": 0.078, "colours": ["#4fa83a", "#e8e0a0", "#e8641c"]},
            {"kind": "robot", "colours": ["#2f7fd0", "#8a929a", "#c9cdd1", "#c0c8d0"]},
        ],
    ),
    "balloon": Maker(
        balloon,
        balloon_random,
        3,
        [{"paints": ["#d8202c"]}, {"paints": ["#1f6fd8", "#f2c21e"]}, {"paints": ["#2fa04a"]}],
    ),
    "hair_clips": Maker(
        hair_clips,
        hair_clips_random,
        2,
        [
            {
                "kind": "snap",
                "colours": [
                    ("#d8308a", "#ffffff"),
                    ("#2f8fd8", "#f07a1c"),
                    ("#7b3fb5", "#f6b0d0"),
                    ("#2fa05a", "#d8202c"),
                ],
            },
            {"kind": "bow", "colours": [("#d8202c", "#ffffff"), ("#1f4fb8", "#ffffff")]},
        ],
    ),
}
