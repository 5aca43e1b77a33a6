"""Lamps that stand on a desk or a bedside table."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import Material, glowing, metal, plain, shade
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part, box_piece, cylinder_piece
from toolkit.sampling import pick
from toolkit.shapes import box, ellipsoid, lathe, loft, spline, tube

from makers.solids import cylinder, rod, solids

GLOW = (1.8, 1.8, 1.7, 1.0)


def _lamp(parts: dict[str, Part]) -> Model:
    lit = [name for name in parts if name.endswith("_lit")]
    return Model(
        "desk lamp",
        parts,
        mass=1.3,
        texture_size=128,
        variants={"default": ["body", "shade"], "on": ["body", *lit]},
        states=[
            {"state": "ON", "variants": ["on"], "parts": ["bulb_lit"]},
            {"state": "OFF", "variants": ["default"], "parts": ["shade"]},
        ],
    )


def _jointed(height: float, colour: str, steel_arm: bool = True) -> Model:
    """Two jointed arms and a conical hood."""
    s = height / 0.42
    paint, arm = plain(colour, 0.03), metal() if steel_arm else plain(shade(colour, 0.85), 0.03)
    base = lathe(
        [
            (0, 0),
            (0.078, 0),
            (0.082, 0.004),
            (0.08, 0.014),
            (0.068, 0.02),
            (0.016, 0.024),
            (0, 0.024),
        ],
        24,
        mat=paint,
    )
    elbow, neck = (-0.105 * s, 0, 0.235 * s), (0.04 * s, 0, 0.385 * s)
    foot = (0, 0, 0.022)
    meshes = [base]
    for q in (-1, 1):
        shift = np.array([0, 0.011 * q, 0])
        meshes += [
            tube([np.add(foot, shift), np.add(elbow, shift)], 0.004, 6, mat=arm),
            tube([np.add(elbow, shift), np.add(neck, shift)], 0.004, 6, mat=arm),
        ]
    knob = plain("#26282c", 0.04)
    for at, radius in ((foot, 0.012), (elbow, 0.014), (neck, 0.013)):
        knuckle = lathe(
            [(0, -0.019), (radius, -0.019), (radius, 0.019), (0, 0.019)], 10, mat=knob
        ).turn(rx=math.pi / 2)
        meshes.append(knuckle.move(at[0], 0, at[2] + (0.006 if at is foot else 0)))
    wall = 0.005
    outer = [(0, 0.075), (0.018, 0.075), (0.026, 0.066), (0.034, 0.05), (0.066, 0.012), (0.072, 0)]
    inner = [(0.072 - wall, 0), (0.06, 0.012), (0.029, 0.05), (0, 0.056)]

    def hood(material: Material) -> Mesh:
        return lathe(
            [*outer, *inner][::-1], 18, mats=[paint, material], mat_of_segment=[1] * 3 + [0] * 6
        )

    def place(mesh: Mesh) -> Mesh:
        return mesh.scale(s).turn(ry=-0.55).move(neck[0] + 0.04 * s, 0, neck[2] - 0.058 * s)

    glow_inside = Material(occlusion=0.0)
    glow_inside.colour("#ffe9b0")
    bulb_shape = [(0, 0), (0.014, 0.006), (0.02, 0.018), (0.018, 0.03), (0.011, 0.045), (0, 0.05)]
    bulb_off, bulb_on = plain("#f4f2ea", 0.02), glowing("#fff6d0")
    parts = {
        "body": Part(
            meshes,
            collision=[
                cylinder_piece(0.082, 0, 0.022, 12),
                *(
                    np.r_[box_piece(a, (0.016, 0.03, 0.016)), box_piece(b, (0.016, 0.03, 0.016))]
                    for a, b in ((foot, elbow), (elbow, neck))
                ),
                box_piece(
                    (neck[0] + 0.03 * s, 0, neck[2] - 0.03 * s), (0.13 * s, 0.12 * s, 0.08 * s)
                ),
            ],
        ),
        "shade": Part(
            [place(hood(plain("#f3f0e6", 0.02))), place(lathe(bulb_shape, 8, mat=bulb_off))],
            collision="none",
        ),
        "shade_lit": Part([place(hood(glow_inside))], collision="none"),
        "bulb_lit": Part(
            [place(lathe(bulb_shape, 8, mat=bulb_on))], rgba=(1.8, 1.8, 1.7, 1.0), collision="none"
        ),
    }
    return _lamp(parts)


def _neck(colour: str) -> Model:
    """A bent neck that carries a round hood looking down."""
    paint, chrome = plain(colour, 0.03), metal()
    foot = [(0, 0), (0.085, 0), (0.088, 0.006), (0.08, 0.018), (0.02, 0.026), (0, 0.026)]
    path = [(-0.035, 0, 0.02), (-0.055, 0, 0.18), (-0.03, 0, 0.31), (0.045, 0, 0.35)]
    path += [(0.1, 0, 0.32)]
    body = [lathe(foot, 20, mat=paint), tube(spline(path, 3), 0.007, 7, mat=chrome)]
    body.append(cylinder(0.009, 0.006, (0.045, 0, 0.02), plain("#e03a30", 0), 8))
    outer = [(0.062, 0), (0.06, 0.03), (0.04, 0.062), (0.016, 0.076), (0, 0.078)]
    inner = [(0, 0.066), (0.034, 0.054), (0.054, 0.028), (0.057, 0)]

    def hood(mat: Material) -> Mesh:
        bowl = lathe([*inner, *outer], 18, mats=[paint, mat], mat_of_segment=[1] * 3 + [0] * 5)
        return bowl.turn(ry=-0.45).move(0.118, 0, 0.248)

    bulb = [(0, 0), (0.018, 0.006), (0.026, 0.022), (0.02, 0.04), (0, 0.05)]

    def lamp(mat: Material) -> Mesh:
        return lathe(bulb, 10, mat=mat).turn(ry=-0.45).move(0.115, 0, 0.256)

    warm = Material("#ffe9b0", occlusion=0.0)
    cap = hood(plain("#f3f0e6", 0.02))
    return _lamp(
        {
            "body": Part(body, collision=solids(body[:1], body[1:2], [cap])),
            "shade": Part([cap, lamp(plain("#f4f2ea", 0.02))], collision="none"),
            "shade_lit": Part([hood(warm)], collision="none"),
            "bulb_lit": Part([lamp(glowing("#fff6d0"))], rgba=GLOW, collision="none"),
        }
    )


def _bar(colour: str) -> Model:
    """A slim arm with a flat bar of light."""
    paint, dark = plain(colour, 0.03), plain("#26282c", 0.03)
    body = [box(0.18, 0.17, 0.018, (0, 0, 0), paint, 0.005)]
    body.append(rod((-0.07, 0, 0.014), (-0.07, 0, 0.36), 0.011, paint, 8))
    body.append(cylinder(0.016, 0.044, (-0.07, -0.022, 0.36), dark, 10, "y"))
    body.append(box(0.012, 0.03, 0.002, (0.05, 0, 0.0175), plain("#3ad0ff", 0)))

    def strip(mat: Material) -> list[Mesh]:
        head = box(0.26, 0.045, 0.014, (0.055, 0, 0.362), paint, 0.004)
        light = box(0.23, 0.053, 0.008, (0.062, 0, 0.356), mat)
        return [mesh.turn(ry=0.12, pivot=(-0.07, 0, 0.36)) for mesh in (head, light)]

    off, on = strip(plain("#f4f2ea", 0.0)), strip(glowing("#fff6d0"))
    pieces = solids(body[:1], body[1:3], off[:1])
    return _lamp(
        {
            "body": Part([*body, off[0]], collision=pieces),
            "shade": Part(off[1:], collision="none"),
            "bulb_lit": Part(on[1:], rgba=GLOW, collision="none"),
        }
    )


def _shaded(colour: str, cloth: str, kind: str) -> Model:
    """A pot with a cloth shade ('cloth') or a ball of glass on a stem ('ball')."""
    if kind == "ball":
        stem = [(0, 0), (0.07, 0), (0.073, 0.008), (0.066, 0.016), (0.012, 0.022), (0.01, 0.12)]
        stem += [(0.034, 0.13), (0.036, 0.15), (0, 0.15)]
        body = [lathe(stem, 18, mat=metal("d8b868", "8a6a2a"))]
        ball = [(0, 0), (0.05, 0.012), (0.085, 0.05), (0.094, 0.092), (0.085, 0.134), (0.05, 0.172)]
        profile, z = [*ball, (0, 0.184)], 0.138
    else:
        pot = [(0, 0), (0.055, 0), (0.06, 0.01), (0.078, 0.07), (0.07, 0.12), (0.03, 0.165)]
        pot += [(0.014, 0.18), (0.012, 0.24), (0, 0.24)]
        body = [lathe(pot, 18, mat=plain(colour, 0.05, 40))]
        profile = [(0.118, 0), (0.12, 0.004), (0.075, 0.17), (0.072, 0.172), (0, 0.165)]
        profile, z = [(0, 0.004), *profile], 0.215
    weave = Material()
    threads = weave.noise(260, 2, stretch=(1, 1, 0.2))
    weave.colour(weave.mix(weave.remap(threads, 0.4, 0.6), shade(cloth, 0.93), cloth))
    dark, light = lathe(profile, 20, mat=weave), lathe(profile, 20, mat=glowing("#fff0c0"))
    for mesh in (dark, light):
        mesh.move(z=z)
    return _lamp(
        {
            "body": Part(body, collision=solids(body, [dark])),
            "shade": Part([dark], collision="none"),
            "bulb_lit": Part([light], rgba=(1.55, 1.5, 1.35, 1.0), collision="none"),
        }
    )


def _banker(colour: str) -> Model:
    """Brass, with a long green glass shade."""
    brass, glass = metal("d8b050", "8a6a20"), plain(colour, 0.06, 30)
    foot = [(0, 0), (0.088, 0), (0.092, 0.008), (0.08, 0.02), (0.02, 0.03), (0, 0.03)]
    body = [lathe(foot, 18, mat=brass), rod((0, 0, 0.025), (0, 0, 0.25), 0.009, brass, 8)]
    body.append(ellipsoid(0.018, (0, 0, 0.13), 8, 6, brass))
    for q in (-1, 1):
        arm = [(0, 0, 0.24), (0, q * 0.1, 0.25), (0.0, q * 0.132, 0.3)]
        body.append(tube(arm, 0.006, 6, mat=brass))
        body.append(cylinder(0.02, 0.008, (0, q * 0.13 - 0.004, 0.3), brass, 10, "y"))
    body.append(rod((0.03, 0.03, 0.25), (0.03, 0.03, 0.17), 0.0028, brass, 4))
    t = np.linspace(-0.25, math.pi + 0.25, 9)

    def hood(mat: Material) -> Mesh:
        outer, inner = (np.c_[r * np.cos(t), r * 0.9 * np.sin(t)] for r in (0.062, 0.056))
        ring = np.r_[outer, inner[::-1]]
        rings = [np.c_[ring[:, 0], np.full(18, y), ring[:, 1] + 0.29] for y in (-0.13, 0.13)]
        return loft(rings, mats=[glass, mat], mat_of_face=lambda k, i: int(9 <= i < 17))

    def tube_light(mat: Material) -> Mesh:
        return rod((0, -0.11, 0.295), (0, 0.11, 0.295), 0.016, mat, 10)

    cover = hood(plain("#e8efe0", 0.02))
    return _lamp(
        {
            "body": Part(body, collision=solids(body[:1], body[1:3], [cover])),
            "shade": Part([cover, tube_light(plain("#f4f2ea", 0))], collision="none"),
            "shade_lit": Part([hood(Material("#f6ffd8", occlusion=0.0))], collision="none"),
            "bulb_lit": Part([tube_light(glowing("#fff6d0"))], rgba=GLOW, collision="none"),
        }
    )


def desk_lamp(kind: str, height: float, colour: str, cloth: str) -> Model:
    """'jointed', 'neck' (bent), 'bar' (of light), 'banker', 'cloth' or 'ball' (bedside); the
    variant `on` has a glowing bulb."""
    if kind == "jointed":
        return _jointed(height, colour)
    if kind in ("cloth", "ball"):
        return _shaded(colour, cloth, kind)
    return {"neck": _neck, "bar": _bar, "banker": _banker}[kind](colour)


def desk_lamp_random(rng: np.random.Generator) -> dict:
    return {
        "kind": "jointed",
        "height": 0.42,
        "colour": pick(rng, ["#c8302c", "#26282c", "#2f7f8f", "#e8c23a"]),
        "cloth": "#f2e6cc",
    }


MODELS = {
    "desk_lamp": Maker(
        desk_lamp,
        desk_lamp_random,
        8,
        [
            {"colour": "#c8302c"},
            {"colour": "#26282c"},
            {"kind": "neck", "colour": "#e8c23a"},
            {"kind": "banker", "colour": "#1f7a4a"},
            {"kind": "bar", "colour": "#f2f2ee"},
            {"kind": "cloth", "colour": "#2f7f8f"},
            {"kind": "ball", "colour": "#d8b868", "cloth": "#f6f2e4"},
            {"kind": "cloth", "colour": "#c86a4a", "cloth": "#e8d8b8"},
        ],
    ),
}
