"""More knives: paring, steak, pocket, carving; cleavers; blocks and stands that hold knives."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import metal, plain, wood
from toolkit.mesh import Mesh
from toolkit.model import Container, Model, Part, box_piece, cylinder_piece
from toolkit.shapes import box, extrude, lathe, rounded_rectangle, spline, tube

from makers.cleaner_forms import maker
from makers.convex import few_corners
from makers.knives import NO_SHADOW, knife, knife_block

STEEL, STEEL_DARK = "c9cdd1", "a3a9ae"


def tool(title: str, hold: list[Mesh], blade: list[Mesh], pieces: list, mass: float) -> Model:
    """A lying blade with its handle."""
    for mesh in blade:
        for material in mesh.mats:
            material.block["occlusion"] = 0.4
    hulls = [few_corners(np.concatenate([m.v for m in blade]))]
    return Model(
        title,
        {
            "handle": Part(hold, collision=[few_corners(p) for p in pieces], occlusion="handle"),
            "blade": Part(blade, rgba=NO_SHADOW, collision=hulls, occlusion="blade"),
        },
        mass=mass,
        friction=0.5,
        texture_size=128,
    )


def flat_blade(outline, edge_line, z: float, thick: float = 0.0036) -> list[Mesh]:
    """A blade from above with a bright strip along its cutting edge."""
    steel, edge = metal(STEEL, STEEL_DARK, (1, 40, 1), 40), plain("f0f3f5", 0.02)
    blade = extrude(outline, thick, steel).move(z=z - thick / 2)
    rim = extrude(edge_line, thick + 0.0006, edge).move(z=z - thick / 2 - 0.0003)
    return [blade, rim]


def toothed(points, depth: float, teeth: int) -> list[tuple[float, float]]:
    """A cutting edge with scallops: between two points, the teeth towards -y."""
    (x0, y0), (x1, y1) = points
    out = []
    for k in range(2 * teeth + 1):
        t = k / (2 * teeth)
        out.append((x0 + (x1 - x0) * t, y0 + (y1 - y0) * t + (depth if k % 2 else 0.0)))
    return out


def grip_mesh(length: float, r: float, colour: str, wooden: bool, rivets: int) -> list[Mesh]:
    """A kitchen knife's handle along -x, its belly on z = 0; rivets on top."""
    mat = wood(colour, "3a2010", 0, 30) if wooden else plain(colour, 0.08, 200)
    line = [
        (0.002, -0.8 * r),
        (0.002, 0.85 * r),
        (-0.5 * length, 0.8 * r),
        (-0.92 * length, 1.1 * r),
    ]
    line += [(-length, 0.8 * r), (-length, -0.7 * r), (-0.94 * length, -1.25 * r)]
    line += [(-0.84 * length, -1.15 * r), (-0.5 * length, -0.8 * r), (-0.2 * length, -0.95 * r)]
    out = [extrude(line, 0.015, mat, bevel_width=0.0035)]
    steel = metal("cfd2d6", "8b9096")
    for k in range(rivets):
        pin = lathe([(0, 0.0146), (0.0032, 0.0146), (0.0026, 0.0156), (0, 0.0158)], 8, mat=steel)
        out.append(pin.move(-length * (0.2 + 0.28 * k), 0))
    return out


def small_knife(kind: str, colour: str, wooden: bool) -> Model:
    """A paring, a steak or a bread knife."""
    if kind == "paring":
        hold = grip_mesh(0.088, 0.0095, colour, wooden, 0)
        line = spline([(0.0, -0.009), (0.035, -0.0085), (0.06, -0.0045), (0.076, 0.0045)], 3)
        top = [(0.05, 0.0072), (0.0, 0.0085)]
        rim = [*line, *[(x - 0.001, y + 0.0035) for x, y in line[::-1]]]
        blades = flat_blade([*line, *top], rim, 0.0075)
        return tool("paring knife", hold, blades, [hold[0].v], 0.06)
    if kind == "steak":
        hold = grip_mesh(0.105, 0.0105, colour, wooden, 3)
        teeth = toothed(((0.012, -0.0085), (0.09, -0.0075)), 0.0024, 9)
        tip = [(0.105, -0.002), (0.116, 0.008)]
        top = [(0.08, 0.0085), (0.0, 0.0085)]
        line = [(0.0, -0.0075), *teeth, *tip]
        rim = [
            *line,
            *[(x - 0.001, y + 0.004) for x, y in ((0.1, 0.0), (0.085, -0.004), (0.002, -0.0045))],
        ]
        blades = flat_blade([*line, *top], rim, 0.0075)
        return tool("steak knife", hold, blades, [hold[0].v], 0.08)
    hold = grip_mesh(0.125, 0.0135, colour, wooden, 3)
    teeth = toothed(((0.02, -0.0155), (0.2, -0.0135)), 0.0042, 12)
    line = [(0.0, -0.0145), *teeth, (0.222, -0.006), (0.236, 0.006)]
    top = [(0.232, 0.012), (0.0, 0.0145)]
    rim = [*line, (0.214, -0.001), (0.002, -0.0085)]
    blades = flat_blade([*line, *top], rim, 0.0075)
    return tool("bread knife", hold, blades, [hold[0].v], 0.15)


def pocket_knife(colour: str) -> Model:
    """A folding pocket knife, half open, with a white plate on its scale."""
    paint, steel = plain(colour, 0.05), metal(STEEL, STEEL_DARK)
    shell = extrude(rounded_rectangle(0.1, 0.026, 0.0125, 4), 0.019, paint, bevel_width=0.003)
    hold = [shell.move(-0.05, 0, 0)]
    for x in (-0.01, -0.09):
        pin = lathe([(0, 0.0185), (0.0042, 0.0185), (0.0036, 0.0196), (0, 0.02)], 8, mat=steel)
        hold.append(pin.move(x))
    hold.append(box(0.018, 0.011, 0.0016, (-0.05, 0, 0.0185), plain("#f2f2ee", 0.02), 0.0006))
    hold.append(box(0.084, 0.0275, 0.003, (-0.05, 0, 0.008), metal("aab0b6", "6f757b")))
    line = spline([(-0.012, -0.0085), (0.03, -0.0105), (0.055, -0.0075), (0.076, 0.006)], 3)
    top = [(0.05, 0.0082), (0.0, 0.0105), (-0.012, 0.0085)]
    rim = [*line[2:], *[(x - 0.001, y + 0.004) for x, y in line[:1:-1]]]
    blades = flat_blade([*line, *top], rim, 0.0095, 0.004)
    nick = box(0.014, 0.0028, 0.0046, (0.02, 0.0055, 0.0072), plain("#6f757b", 0.0))
    for mesh in (*blades, nick):
        mesh.turn(rz=0.95).move(-0.008, 0.003, 0)
    return tool("pocket knife", hold, [*blades, nick], [shell.v], 0.09)


def carving_set(colour: str) -> Model:
    """A long carving knife and its two-pronged fork, side by side."""
    hold = grip_mesh(0.12, 0.0125, colour, True, 3)
    line = spline([(0.0, -0.0135), (0.12, -0.0145), (0.19, -0.01), (0.225, 0.006)], 4)
    top = [(0.15, 0.0125), (0.0, 0.0135)]
    rim = [*line, *[(x - 0.001, y + 0.0045) for x, y in line[::-1]]]
    blades = flat_blade([*line, *top], rim, 0.0075)
    steel = metal(STEEL, "858b91")
    fork = grip_mesh(0.12, 0.0115, colour, True, 3)
    prongs = [tube([(0, 0, 0.0075), (0.07, 0, 0.0075)], 0.0045, 7, mat=steel)]
    for side in (-1, 1):
        path = [(0.064, 0, 0.0075), (0.08, side * 0.011, 0.0075), (0.1, side * 0.0125, 0.0075)]
        path += [(0.16, side * 0.0115, 0.0085)]
        curve = spline(path, 2)
        prongs.append(
            tube(curve, np.linspace(0.004, 0.0022, len(curve)), 6, mat=steel, up=(0, 0, 1))
        )
    for mesh in (*fork, *prongs):
        mesh.turn(rz=0.12).move(0.0, 0.052, 0)
    return tool(
        "carving knife and fork",
        [*hold, *fork, *prongs],
        blades,
        [hold[0].v, fork[0].v, np.concatenate([m.v for m in prongs])],
        0.32,
    )


def knife_form(shape: str, colour: str, wooden: bool) -> Model:
    """A chef's or santoku knife, bread, paring, steak or pocket knife, a carving set."""
    if shape == "chef":
        return knife(0.16453432240071966, 0.032132703271213044, "chef", colour, wooden, 894047601)
    if shape == "santoku":
        return knife(0.14364947782105322, 0.0426473704644104, "santoku", colour, wooden, 787999273)
    if shape == "pocket":
        return pocket_knife(colour)
    if shape == "carving":
        return carving_set(colour)
    return small_knife(shape, colour, wooden)


# ---- cleavers
def cleaver_parts(kind: str, colour: str) -> tuple[list[Mesh], list[Mesh]]:
    """Handle and blade of a cleaver lying flat, the edge towards -y."""
    length, deep, up = {"meat": (0.17, 0.078, 0.018), "chinese": (0.21, 0.108, 0.022)}.get(
        kind, (0.1, 0.056, 0.014)
    )
    if kind == "chinese":
        timber = wood(colour, "3a2010", 0, 30)
        profile = [(0, -0.115), (0.013, -0.112), (0.0155, -0.09), (0.012, -0.04), (0.0145, -0.01)]
        grip = lathe([*profile, (0.0135, 0), (0, 0)], 12, mat=timber)
        grip = grip.turn(ry=math.pi / 2).move(z=0.0155)
        hold, z = [grip], 0.0155
        ring = lathe([(0.0142, -0.014), (0.0152, -0.012), (0.0152, -0.002), (0.013, 0.001)], 12)
        ring.mats = [metal("cfd2d6", "8b9096")]
        hold.append(ring.turn(ry=math.pi / 2).move(z=z))
    else:
        hold, z = (
            grip_mesh(0.125 if kind == "meat" else 0.1, 0.0135, colour, kind == "meat", 3),
            0.0075,
        )
    low, high = up - deep, up
    outline = [(0, high - 0.008), (0.0, low + 0.012), (0.008, low), (length * 0.5, low - 0.002)]
    outline += [(length * 0.97, low), (length, low + 0.004), (length, high - 0.01)]
    outline += [(length * 0.97, high), (0.02, high)]
    rim = [(0.008, low), (length * 0.5, low - 0.0024), (length * 0.97, low), (length, low + 0.004)]
    rim += [(length, low + 0.013), (0.004, low + 0.012)]
    blades = flat_blade(outline, rim, z, 0.0055)
    if kind == "meat":
        hole = lathe([(0, -0.0034), (0.0075, -0.0034), (0.0075, 0.0034), (0, 0.0034)], 12)
        hole.mats = [plain("#4a4038", 0.0)]
        blades.append(hole.move(length - 0.02, high - 0.02, z))
    return hold, blades


def cleaver_form(shape: str, colour: str) -> Model:
    """A cleaver lying ("meat", "chinese", "small"), or struck into a board ("board", "log")."""
    if shape in ("meat", "chinese", "small"):
        hold, blades = cleaver_parts(shape, colour)
        mass = {"meat": 0.65, "chinese": 0.45}.get(shape, 0.3)
        return tool("cleaver", hold, blades, [hold[0].v], mass)
    hold, blades = cleaver_parts("meat", colour)
    timber = wood("#c89a62", "8a5a30", 1, 12)
    if shape == "board":
        block = box(0.2, 0.28, 0.025, (0, 0, 0), timber, 0.005)
        piece, top = box_piece((0, 0, 0.0125), (0.2, 0.28, 0.025)), 0.025
    else:
        bark = wood("#7a5230", "4a2f1a", 2, 14)
        block = lathe(
            [(0, 0), (0.105, 0), (0.11, 0.01), (0.108, 0.075), (0.1, 0.08), (0, 0.08)],
            20,
            mats=[bark, timber],
            mat_of_segment=[0, 0, 0, 1, 1],
        )
        piece, top = cylinder_piece(0.108, 0, 0.08, 14), 0.08
    for mesh in (*hold, *blades):  # upright, its edge down in the wood, the handle along +y
        mesh.move(-0.085, 0.06, -0.0075).turn(rx=math.pi / 2).turn(rz=-math.pi / 2)
        mesh.turn(rx=0.22).move(0, 0, top - 0.004 + 0.012)
    model = tool("cleaver struck into a board", [block, *hold], blades, [hold[0].v], 1.6)
    model.parts["handle"].collision.append(piece)
    model.texture_size = 256
    return model


# ---- blocks
def hilt(size: float, grip, steel, at, lean: float = 0.0, wide: float = 0.024) -> list[Mesh]:
    """A knife's handle standing out of a block."""
    shaft = extrude(rounded_rectangle(wide, 0.016, 0.005, 2), size, grip).move(z=0.012)
    ring = box(wide * 0.85, 0.012, 0.014, (0, 0, 0), steel)
    return [m.turn(ry=lean).move(*at) for m in (shaft, ring)]


def round_block(colour: str, handle: str) -> Model:
    """A round stand full of bristles, knives standing in it."""
    r, h = 0.062, 0.2
    profile = [(0, 0), (r, 0), (r, 0.006), (r * 0.98, h - 0.004), (r * 0.95, h)]
    shell = lathe(
        [*profile, (r * 0.86, h - 0.006), (0, h - 0.006)],
        24,
        mats=[plain(colour, 0.04), plain("#26282c", 0.35, 500)],
        mat_of_segment=[0, 0, 0, 0, 0, 1],
    )
    grip, steel = plain(handle, 0.08, 150), metal("c3c7cb", "868c92")
    meshes = [shell]
    for x, y, size in (
        (0.02, 0, 0.1),
        (-0.02, 0.026, 0.115),
        (-0.02, -0.026, 0.09),
        (0.005, 0.042, 0.08),
    ):
        meshes += hilt(size, grip, steel, (x, y, h - 0.008))
    meshes += hilt(0.085, grip, steel, (0.008, -0.04, h - 0.008))
    pieces = [cylinder_piece(r, 0, h, 14), box_piece((0, 0, h + 0.05), (0.06, 0.09, 0.1))]
    inside = Container("slots", (0, 0, h - 0.06), (0.06, 0.06, 0.1))
    return Model(
        "round knife block with five knives",
        {"body": Part(meshes, collision=pieces)},
        mass=1.8,
        friction=0.7,
        containers=[inside],
    )


def magnet_stand(light: str, dark: str, handle: str) -> Model:
    """An upright wooden board that holds four knives by magnets, their blades showing."""
    timber = wood(light, dark, 2, 9)
    foot = box(0.13, 0.26, 0.022, (0, 0, 0), timber, 0.004)
    slab = box(0.035, 0.25, 0.23, (-0.02, 0, 0.02), timber, 0.004)
    grip, steel, edge = plain(handle, 0.08, 150), metal("cdd1d5", "9aa0a6"), plain("f0f3f5", 0.0)
    meshes = [foot, slab]
    for y, length, width in ((-0.09, 0.165, 0.038), (-0.03, 0.15, 0.034), (0.028, 0.16, 0.026)):
        meshes += standing_knife(y, length, width, grip, steel, edge)
    meshes += standing_knife(0.085, 0.1, 0.022, grip, steel, edge)
    pieces = [
        box_piece((0, 0, 0.011), (0.13, 0.26, 0.022)),
        box_piece((-0.02, 0, 0.135), (0.035, 0.25, 0.23)),
        box_piece((0.004, 0, 0.19), (0.018, 0.21, 0.26)),
    ]
    inside = Container("slots", (0.01, 0, 0.14), (0.02, 0.22, 0.16))
    return Model(
        "magnetic knife stand with four knives",
        {"body": Part(meshes, collision=pieces)},
        mass=2.4,
        friction=0.7,
        containers=[inside],
    )


def standing_knife(y: float, length: float, width: float, grip, steel, edge) -> list[Mesh]:
    """A knife upright on the stand's front, point down, its edge to the right."""
    top = 0.225
    outline = [
        (0, top),
        (-width, top),
        (-width, top - 0.5 * length),
        (-0.35 * width, top - 0.9 * length),
    ]
    outline += [(0, top - length)]
    blade = extrude([(a + width / 2, b) for a, b in outline], 0.006, steel, axis="x")
    rim_line = [(-width, top), (-width, top - 0.5 * length), (-0.35 * width, top - 0.9 * length)]
    rim_line += [(-0.25 * width, top - 0.84 * length), (-0.8 * width, top - 0.48 * length)]
    rim_line += [(-0.8 * width, top)]
    rim = extrude([(a + width / 2, b) for a, b in rim_line], 0.0068, edge, axis="x")
    handle = box(0.017, 0.024, 0.105, (0, 0, top), grip, 0.005)
    return [m.move(0.0015, y, 0) for m in (blade, rim, handle)]


def tower_block(colour: str, handle: str) -> Model:
    """A narrow upright steel block, five hilts leaning out of its slanted top in one row."""
    body = metal(colour, "7d858b", (1, 1, 20), 60)
    outline = [(-0.075, 0), (0.075, 0), (0.075, 0.15), (-0.075, 0.21)]
    block = extrude(outline, 0.075, body, axis="y", bevel_width=0.004)
    base = box(0.16, 0.085, 0.012, (0, 0, 0), plain("#26282c", 0.03), 0.003)
    grip, steel = plain(handle, 0.08, 150), metal("c3c7cb", "868c92")
    meshes = [block, base]
    for k, x in enumerate((-0.055, -0.027, 0.001, 0.029, 0.057)):
        z = 0.21 - (x + 0.075) * 0.4
        meshes += hilt(0.11 - 0.012 * k, grip, steel, (x, 0, z - 0.002), 0.0, 0.02)
    solid = np.array([(x, y, z) for y in (-0.04, 0.04) for x, z in outline])
    pieces = [solid, box_piece((0, 0, 0.23), (0.13, 0.016, 0.16))]
    inside = Container("slots", (0, 0, 0.12), (0.12, 0.05, 0.1))
    return Model(
        "steel knife block with five knives",
        {"body": Part(meshes, collision=pieces)},
        mass=2.0,
        friction=0.7,
        containers=[inside],
    )


def knife_block_form(shape: str, light: str, dark: str, handle: str) -> Model:
    """A block with its knives: slanted wood, round, magnetic stand, steel tower."""
    if shape == "slanted":
        return knife_block(0.2340939362206139, light, dark, handle, 284335821)
    if shape == "round":
        return round_block(light, handle)
    return magnet_stand(light, dark, handle) if shape == "magnet" else tower_block(light, handle)


MODELS = {
    "knife": maker(
        knife_form,
        ("shape", "colour", "wooden"),
        [
            ("chef", "#1c1c1e", False),
            ("santoku", "#6b3d1e", True),
            ("bread", "#8a2a22", False),
            ("paring", "#f2c21e", False),
            ("steak", "#7a4a26", True),
            ("pocket", "#c8202c", False),
            ("carving", "#6b3d1e", True),
            ("chef", "#8a5a30", True),
            ("paring", "#2f8fd8", False),
        ],
    ),
    "knife_block": maker(
        knife_block_form,
        ("shape", "light", "dark", "handle"),
        [
            ("slanted", "#b98552", "#7d5230", "#1c1c1e"),
            ("slanted", "#6b4426", "#3d2413", "#1c1c1e"),
            ("round", "#2a2c30", "", "#8a8f94"),
            ("tower", "#c4c9cd", "", "#1c1c1e"),
            ("round", "#c8202c", "", "#1c1c1e"),
        ],
    ),
    "knife_stand": maker(
        knife_block_form,
        ("shape", "light", "dark", "handle"),
        [("magnet", "#b98552", "#7d5230", "#1c1c1e")],
    ),
    "cleaver": maker(
        cleaver_form,
        ("shape", "colour"),
        [
            ("meat", "#8a5a30"),
            ("chinese", "#a8703a"),
            ("small", "#1c1c1e"),
            ("board", "#1c1c1e"),
            ("log", "#8a5a30"),
            ("small", "#c8202c"),
            ("chinese", "#4a2f1a"),
        ],
    ),
}
