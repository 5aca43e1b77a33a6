"""Speakers and headphones."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import Material, metal, plain, shade
from toolkit.materials import wood as timber
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part
from toolkit.sampling import pick
from toolkit.shapes import TAU, box, ellipsoid, lathe, tube

from makers.choking import loose
from makers.solids import along, cylinder, grounded, rod, solids


def _cone(radius: float, at, cone: str = "#26282c", ring: str = "#8a9098", n: int = 16) -> Mesh:
    """A loudspeaker's chassis looking to +X: rim, rubber roll, cone, dust cap."""
    rim, dark, cap = plain(ring, 0.03), plain(cone, 0.05, 200), plain(shade(cone, 1.9), 0.03)
    r = radius
    profile = [(r, 0), (r, 0.011), (0.9 * r, 0.013), (0.8 * r, 0.012), (0.36 * r, 0.003)]
    profile += [(0.32 * r, 0.006), (0, 0.009)]
    mats = [0, 0, 1, 1, 2, 2]
    mesh = lathe(profile, n, mats=[rim, dark, cap], mat_of_segment=mats)
    return along(mesh, "x").move(*at)


def _grille(colour: str) -> Material:
    """A cloth or punched metal grille."""
    m = Material()
    dots = m.voronoi(260, randomness=0.0)
    return m.colour(m.mix(m.remap(dots, 0.25, 0.4), shade(colour, 0.6), shade(colour, 1.25)))


def _cabinet(d: float, w: float, h: float, body: Material, cones, z: float = 0.0) -> list[Mesh]:
    """A box with chassis: (radius, height above the floor)."""
    front = plain("#2c2e32", 0.04)
    meshes = [box(d, w, h, (0, 0, z), body, 0.004)]
    meshes.append(box(0.005, w - 0.014, h - 0.014, (d / 2, 0, z + 0.007), front))
    for radius, height in cones:
        big = radius > 0.03
        meshes.append(
            _cone(
                radius,
                (d / 2 + 0.003, 0, z + height),
                "#3a3d42" if big else "#c9cdd1",
                "#b4b9be" if big else "#55595f",
                16 if big else 12,
            )
        )
    return meshes


def speaker(kind: str, paint: str, second: str) -> Model:
    """'shelf', 'pair' (of a computer), 'tower', 'tube' (portable), 'round' (smart), 'party' (with a
    handle) or 'sub' (a cube)."""
    body = plain(paint, 0.04, 40)
    if kind in ("shelf", "tower"):
        veneer = timber(paint, shade(paint, 0.7), 2, 8)
        if kind == "shelf":
            meshes = _cabinet(0.2, 0.18, 0.3, veneer, [(0.068, 0.095), (0.034, 0.22)])
            mass = 5.0
        else:
            cones = [(0.075, 0.25), (0.075, 0.46), (0.075, 0.67), (0.036, 0.84)]
            meshes = _cabinet(0.28, 0.2, 0.95, veneer, cones, 0.02)
            meshes.append(box(0.3, 0.24, 0.02, (0, 0, 0), plain("#1c1d20", 0.04), 0.004))
            mass = 16.0
        return Model("loudspeaker", {"body": Part(meshes, collision=solids(meshes))}, mass, 0.6)
    if kind == "pair":
        pieces = []
        for q in (-1, 1):
            piece = _cabinet(0.11, 0.1, 0.19, body, [(0.038, 0.062), (0.021, 0.135)])
            if q > 0:
                piece.append(cylinder(0.008, 0.012, (0.057, -0.03, 0.17), plain("#c9cdd1"), 8, "x"))
            for mesh in piece:
                mesh.turn(rz=-0.2 * q).move(0, q * 0.1, 0)
            pieces.append(piece)
        return loose("computer speakers", pieces, 1.4)
    if kind == "tube":
        r, length = 0.042, 0.19
        net = _grille(paint)
        shell = [(0, 0), (r * 0.86, 0), (r, 0.008), (r, length - 0.008), (r * 0.86, length)]
        roll = lathe(
            [*shell, (0, length)],
            18,
            mats=[plain(second, 0.03), net],
            mat_of_segment=[0, 0, 1, 0, 0],
        )
        meshes = [roll.turn(rx=-math.pi / 2).move(0, -length / 2, r)]
        for y in (-length / 2, length / 2):
            disc = lathe(
                [(0.032, 0), (0.03, 0.003), (0.012, -0.002), (0, 0.001)],
                12,
                mats=[plain("#8a9098"), plain("#26282c")],
                mat_of_segment=[0, 1, 1],
            )
            side = 1 if y > 0 else -1
            meshes.append(disc.turn(rx=-side * math.pi / 2).move(0, y + side * 0.001, r))
        meshes.append(box(0.018, 0.09, 0.006, (0, 0, 2 * r - 0.004), plain(second, 0.03), 0.002))
        for k in (-1, 0, 1):
            meshes.append(
                cylinder(0.005, 0.003, (0, 0.026 * k, 2 * r + 0.001), plain("#f2f2ee"), 8)
            )
        loop = [(0.0, length / 2 + 0.004, r), (0.02, length / 2 + 0.03, r * 0.6)]
        loop += [(0.04, length / 2 + 0.02, 0.008), (0.035, length / 2 - 0.02, 0.005)]
        meshes.append(tube(loop, 0.003, 5, mat=plain(second, 0.03)))
        body_part = Part(meshes, collision=solids(meshes[:1]))
        return Model("portable speaker", {"body": body_part}, 0.6, 0.6)
    if kind == "round":
        r, h = 0.05, 0.15
        net = _grille(paint)
        shell = [(0, 0), (r, 0), (r + 0.003, 0.006), (r + 0.003, h - 0.03), (r, h - 0.01)]
        shell += [(r - 0.012, h), (0, h)]
        can = lathe(shell, 20, mats=[plain(second, 0.03), net], mat_of_segment=[0, 0, 1, 0, 0, 0])
        ring = [
            ((r - 0.007) * math.cos(a), (r - 0.007) * math.sin(a), h - 0.001)
            for a in np.linspace(0, TAU, 14, endpoint=False)
        ]
        meshes = [can, tube(ring, 0.0028, 4, closed=True, mat=plain("#3ad0ff", 0))]
        for x, y in ((0.015, 0), (-0.015, 0), (0, 0.015), (0, -0.015)):
            meshes.append(cylinder(0.004, 0.002, (x, y, h), plain("#f2f2ee", 0), 6))
        return Model("smart speaker", {"body": Part(meshes, collision=solids([can]))}, 0.8, 0.6)
    if kind == "party":
        w, h, d = 0.46, 0.24, 0.16
        meshes = [box(d, w, h, (0, 0, 0), body, 0.016)]
        meshes.append(box(0.008, w * 0.24, 0.06, (d / 2, 0, h * 0.56), plain("#101114", 0)))
        meshes.append(box(0.009, w * 0.2, 0.03, (d / 2, 0, h * 0.62), plain("#3a8fe8", 0)))
        for q in (-1, 1):
            meshes.append(_cone(0.09, (d / 2 + 0.002, q * 0.135, 0.115), "#26282c", second, 18))
            meshes.append(rod((0, q * 0.16, h - 0.01), (0, q * 0.16, h + 0.05), 0.011, body, 6))
        for k in range(4):
            knob = cylinder(
                0.011, 0.012, (d / 2, -0.036 + 0.024 * k, h * 0.3), plain("#c9cdd1"), 8, "x"
            )
            meshes.append(knob)
        meshes.append(rod((0, -0.17, h + 0.05), (0, 0.17, h + 0.05), 0.014, body, 8))
        body_part = Part(meshes, collision=solids(meshes[:5], meshes[-1:]))
        return Model("party speaker", {"body": body_part}, 4.0, 0.6)
    side = 0.3
    meshes = [box(side, side, side, (0, 0, 0.03), body, 0.008)]
    meshes.append(_cone(0.12, (side / 2 + 0.002, 0, side / 2 + 0.03), "#33363b", second, 20))
    for x in (-1, 1):
        for y in (-1, 1):
            meshes.append(cylinder(0.02, 0.03, (x * 0.11, y * 0.11, 0), plain("#17181a"), 8))
    return Model("subwoofer", {"body": Part(meshes, collision=solids(meshes))}, 9.0, 0.6)


def speaker_random(rng: np.random.Generator) -> dict:
    return {"kind": "shelf", "paint": "#8a5a34", "second": "#b4b9be"}


def headphones(kind: str, paint: str, pad: str) -> Model:
    """'upright', 'lying', 'stand' (on a stand), 'headset' (with a microphone), 'ears' (a child's,
    with cat's ears) or 'light' (thin band, foam pads)."""
    shell, foam, steel = plain(paint, 0.03), plain(pad, 0.06, 200), metal("c2c6ca", "7a8086")
    light = kind == "light"
    span = 0.082
    cup = 0.036 if light else 0.043
    t = np.linspace(0, math.pi, 11)
    band = [(0, span * math.cos(a), 0.09 + 0.1 * math.sin(a)) for a in t]
    band = [(0, span * 1.0, 0.06), *band, (0, -span, 0.06)]
    if light:
        head = [tube(band, 0.005, 6, mat=steel)]
    else:
        head = [tube(band, 0.0075, 6, mat=shell, flatten=0.6, up=(0, 0, 1))]
        soft = [(0, 0.06 * math.cos(a), 0.105 + 0.08 * math.sin(a)) for a in t[2:-2]]
        head.append(tube(soft, 0.011, 7, mat=foam))
    cups = []
    for q in (-1, 1):
        if light:
            disc = [(0, 0), (cup, 0.002), (cup, 0.016), (0, 0.02)]
            mats = [1, 1, 0]
        else:
            disc = [(0, 0.006), (cup * 0.62, 0.0), (cup * 0.98, 0.002), (cup, 0.014)]
            disc += [(cup * 0.86, 0.018), (cup * 0.9, 0.03), (cup * 0.6, 0.034), (0, 0.034)]
            mats = [1, 1, 1, 1, 0, 0, 0]
        ear = lathe(disc, 14, mats=[shell, foam], mat_of_segment=mats)
        ear.scale(1.12, 1, 1) if not light else None
        ear.turn(rx=-q * math.pi / 2).turn(rx=q * 0.1).move(0, q * (span - 0.026), cup + 0.006)
        cups.append(ear)
    meshes = [*head, *cups]
    if kind == "ears":
        for q in (-1, 1):
            ear = cylinder(0.027, 0.045, (0, 0, 0), shell, 4, top=0.003).scale(0.45, 1, 1)
            inner = cylinder(0.015, 0.026, (0.007, 0, 0.006), foam, 4, top=0.003).scale(0.5, 1, 1)
            for mesh in (ear, inner):
                meshes.append(mesh.turn(rx=-0.5 * q).move(0, q * 0.045, 0.172))
    if kind == "headset":
        boom = [(0.01, span + 0.004, 0.05), (0.06, span - 0.002, 0.028), (0.1, span - 0.03, 0.024)]
        meshes.append(tube(boom, 0.004, 6, mat=plain("#17181a", 0)))
        meshes.append(ellipsoid((0.014, 0.011, 0.011), (0.108, span - 0.036, 0.024), 8, 6, foam))
    if kind in ("lying", "light"):
        for mesh in meshes:
            mesh.keep_pattern().turn(ry=-(0.315 if not light else 0.215) - math.pi / 2)
    pieces = solids(head, *([c] for c in cups))
    if kind == "stand":
        for mesh in meshes:
            mesh.move(z=0.075)
        wooden = timber("c8965a", "8a5a30", 2, 10)
        post = [
            cylinder(0.065, 0.014, (0, 0, 0), wooden, 18),
            cylinder(0.012, 0.235, (0, 0, 0.01), wooden, 10),
        ]
        rest = [
            (0, 0.05 * math.cos(a), 0.2 + 0.05 * math.sin(a)) for a in np.linspace(0.3, 2.84, 7)
        ]
        post.append(tube(rest, 0.016, 7, mat=wooden))
        meshes += post
        pieces = [np.add(p, (0, 0, 0.075)) for p in pieces] + solids(post[:1], post[1:])
    else:
        low = min(float(m.v[:, 2].min()) for m in meshes)
        grounded(meshes)
        pieces = [np.add(p, (0, 0, -low)) for p in pieces]
    name = "headset" if kind == "headset" else "headphones"
    return Model(name, {"body": Part(meshes, collision=pieces)}, mass=0.25, friction=0.6)


def headphones_random(rng: np.random.Generator) -> dict:
    return {"kind": "upright", "paint": pick(rng, ["#26282c", "#e8e8e6"]), "pad": "#4a4d52"}


MODELS = {
    "speaker": Maker(
        speaker,
        speaker_random,
        8,
        [
            {},
            {"kind": "pair", "paint": "#26282c"},
            {"kind": "tower", "paint": "#3a2a20"},
            {"kind": "tube", "paint": "#1f6fd8", "second": "#17181a"},
            {"kind": "round", "paint": "#8a9098", "second": "#e8e8e6"},
            {"kind": "party", "paint": "#2a2c30", "second": "#d8202c"},
            {"kind": "sub", "paint": "#26282c", "second": "#f2b01c"},
            {"kind": "tube", "paint": "#d8303a", "second": "#26282c"},
        ],
    ),
    "headphones": Maker(
        headphones,
        headphones_random,
        7,
        [
            {"paint": "#26282c", "pad": "#5a5e64"},
            {"kind": "lying", "paint": "#e8e4da", "pad": "#8a6a4a"},
            {"kind": "stand", "paint": "#2a2c30", "pad": "#8a4a2a"},
            {"kind": "headset", "paint": "#c8202c", "pad": "#26282c"},
            {"kind": "ears", "paint": "#7a4fc0", "pad": "#2a2c30"},
            {"kind": "light", "paint": "#26282c", "pad": "#f07a1c"},
            {"paint": "#2f6fb0", "pad": "#e8e8e6"},
        ],
    ),
}
