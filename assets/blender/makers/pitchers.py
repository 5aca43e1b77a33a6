"""Pitchers and jugs: empty, full or broken."""

from __future__ import annotations

import math

import numpy as np
from toolkit.fracture import fracture, scatter
from toolkit.materials import Material, metal, plain
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part, box_piece
from toolkit.sampling import noise_offset
from toolkit.shapes import lathe, spline, tube

from makers.breakage import BROKEN
from makers.glassware import CLEAR, DRINKS, SPLINTERS, clear_glass, drink
from makers.ware import FULL, hollow, r_at, surface_of, wall_pieces, wall_profile

# radius, height, outline in shares, handle, columns, lip in metres
PITCHERS = {
    "straight": (
        0.055,
        0.23,
        [(0.92, 0), (0.96, 0.03), (1, 0.5), (0.98, 0.94), (1.02, 1)],
        "square",
        18,
        0.02,
    ),
    "belly": (
        0.078,
        0.2,
        [(0.6, 0), (0.72, 0.05), (1, 0.36), (0.82, 0.66), (0.56, 0.84), (0.68, 1)],
        "ear",
        18,
        0.024,
    ),
    "tall": (
        0.058,
        0.26,
        [(1, 0), (1.02, 0.02), (0.86, 0.45), (0.72, 0.85), (0.8, 1)],
        "ear",
        18,
        0.022,
    ),
    "carafe": (
        0.062,
        0.255,
        [(0.8, 0), (0.96, 0.05), (1, 0.25), (0.6, 0.58), (0.42, 0.78), (0.62, 1)],
        "",
        16,
        0.008,
    ),
    "creamer": (
        0.045,
        0.09,
        [(0.66, 0), (0.8, 0.08), (1, 0.42), (0.84, 0.8), (0.92, 1)],
        "ear",
        16,
        0.016,
    ),
    "facet": (0.07, 0.19, [(0.8, 0), (0.84, 0.04), (1, 0.5), (0.94, 0.8), (1, 1)], "ear", 8, 0.022),
}


def lipped(mesh: Mesh, h: float, lip: float) -> Mesh:
    """Pull the rim to a pouring lip at +X."""

    def pull(x, y, z):
        k = max(0.0, (z / h - 0.8) / 0.2) ** 1.5 * max(0.0, math.cos(math.atan2(y, x))) ** 8
        return x + lip * k, y * (1 - 0.25 * k), z + 0.25 * lip * k

    return mesh.warp(pull)


def pitcher(
    shape="straight",
    material="glass",
    colour="#dcebef",
    accent="#2f5f9a",
    liquid="water",
    style="",
    look=0,
    seed=0,
) -> Model:
    """A pitcher, its lip to the front; material: glass, ceramic or steel."""
    rng = np.random.default_rng(look)
    r, h, shares, ear, n, lip = PITCHERS[shape]
    outer = [(r * q, h * z) for q, z in shares]
    wall, floor = 0.0045, 0.009
    profile, kinds = wall_profile(outer, wall, floor)
    clear = material == "glass"
    if clear:
        glaze = clear_glass(colour, h)
        mats, grip = [glaze] * 4, glaze
    elif material == "steel":
        glaze = metal("c6cace", "80868c", (1, 1, 10), 40)
        mats, grip = [glaze] * 4, glaze
    else:
        glaze = Material()
        base = glaze.mottle(colour, 0.05, 40, noise_offset(rng))
        z = glaze.axis(2)
        for low, high in {
            "bands": [(0.6, 0.66), (0.7, 0.72)],
            "dipped": [(0.55, 2)],
            "rim": [(0.95, 2)],
        }.get(style, []):
            inside = glaze.math(
                "MULTIPLY",
                glaze.math("GREATER_THAN", z, low * h),
                glaze.math("LESS_THAN", z, high * h),
            )
            base = glaze.mix(inside, base, accent)
        glaze.colour(base)
        inner = plain("eeeae0", 0.03)
        mats = [glaze, inner, inner, plain(accent if style in ("rim", "dipped") else colour, 0.03)]
        grip = plain(accent if style == "rim" else colour, 0.05)

    def shell(count: int) -> Mesh:
        body = lathe(profile, count, mats=list(mats), mat_of_segment=kinds)
        return lipped(body.keep_pattern(), h, lip)

    def handles(count: int) -> list[Mesh]:
        if not ear:
            return []
        low, high, deep = 0.3 * h, 0.86 * h, 0.3 * r + 0.028
        a, b = r_at(outer, low) - 0.003, r_at(outer, high) - 0.003
        far = -max(r_at(outer, 0.6 * h), b) - deep
        if ear == "square":
            path = [
                (-b, 0, high),
                (far + 0.008, 0, high),
                (far, 0, high - 0.012),
                (far, 0, low + 0.02),
                (far + 0.008, 0, low),
                (-a, 0, low),
            ]
        else:
            path = spline(
                [
                    (-b, 0, high),
                    (far, 0, high - 0.06 * h),
                    (far - 0.004, 0, 0.55 * h),
                    (-a, 0, low),
                ],
                3,
            )
        thick = 0.0068 if h > 0.12 else 0.005
        return [tube(path, thick, count, mat=grip, up=(0, 1.0, 0), flatten=1.3)]

    meshes = [shell(n), *handles(6)]
    whole = [shell(min(n, 8)), *handles(5)]
    seeds = [(0, 0.1 * r, 0.1 * h)]
    for k, z in enumerate((0.85, 0.62, 0.9, 0.66)):
        a = 0.8 + math.pi / 2 * k
        seeds.append((1.1 * r * math.cos(a), 1.1 * r * math.sin(a), z * h))
    weights = [(0.28 * h) ** 2] + [0.0] * 4
    if ear:
        seeds.append((-r - 0.07, 0, 0.6 * h))
        weights.append(0.0)
    raw = plain("f2fafb" if clear else "d8c8a8", 0.0 if clear else 0.12, 300)
    shards = fracture(whole, seeds, raw, weights, seed, 0.003, 0.14)
    fallen = scatter(shards, np.random.default_rng(seed))
    top = 0.72 * h if clear else 0.88 * h
    if clear:  # just outside the glass: seen through it, colours would pale
        steps = np.linspace(floor, top, 5)
        skin = [(r_at(outer, z) + 0.0005, z) for z in steps]
        poured = drink(DRINKS[liquid], skin[-1][0], top, top - floor)
        contents = [lathe([(0, floor), *skin, (0, top + 0.0004)], n, mat=poured)]
    else:
        contents = [surface_of(DRINKS[liquid], r_at(outer, top) - wall, top, 16)]
    if liquid in ("lemonade", "water") and clear:
        peel = plain("f2cf3a", 0.05)
        for k in range(2):
            slice_ = [(0, 0), (0.02, 0), (0.02, 0.004), (0.016, 0.0046), (0, 0.0046)]
            disc = lathe(
                slice_, 10, mats=[peel, plain("f8eaa0", 0.1, 200)], mat_of_segment=[0, 0, 0, 1]
            )
            contents.append(
                disc.turn(ry=0.25 * (1 - 2 * k)).move(0.014 * (1 - 2 * k), 0.012 * k, top - 0.0005)
            )
    pieces = wall_pieces(outer, wall, floor)
    if ear:
        far = min(float(m.v[:, 0].min()) for m in handles(5))
        pieces.append(box_piece((far + 0.007, 0, 0.58 * h), (0.014, 0.016, 0.5 * h)))
    clear_rgba = CLEAR if clear else None
    name = {"carafe": "carafe", "creamer": "milk jug"}.get(shape, "pitcher")
    return Model(
        f"{material} {name}, {shape}",
        {
            "body": Part(meshes, rgba=clear_rgba, collision=pieces),
            "filling": Part(contents, collision="none"),
            "shards": Part(shards, rgba=SPLINTERS if clear else None, collision=fallen),
        },
        mass=0.9 if h > 0.12 else 0.25,
        friction=0.5,
        texture_size=128,
        variants={"default": ["body"], "full": ["filling", "body"], "broken": ["shards"]},
        states=[*BROKEN, *FULL],
        prune=False,
        front="-y",  # the lip to the right
        containers=[hollow(outer, wall, floor)],
    )


def pitcher_random(rng: np.random.Generator) -> dict:
    return {"look": int(rng.integers(1_000_000)), "seed": 5}


MODELS = {
    "pitcher": Maker(
        pitcher,
        pitcher_random,
        8,
        [
            {"shape": "straight", "material": "glass", "liquid": "lemonade"},
            {"shape": "belly", "material": "ceramic", "colour": "#f2efe6", "style": "bands"}
            | {"liquid": "milk"},
            {"shape": "tall", "material": "ceramic", "colour": "#e9e6de", "accent": "#22406a"}
            | {"style": "rim", "liquid": "water"},
            {"shape": "carafe", "material": "glass", "liquid": "water"},
            {"shape": "creamer", "material": "ceramic", "colour": "#e8c33a", "accent": "#f6f2e4"}
            | {"style": "dipped", "liquid": "milk"},
            {"shape": "facet", "material": "glass", "colour": "#bfe0d6", "liquid": "juice"},
            {"shape": "tall", "material": "steel", "liquid": "water"},
            {"shape": "straight", "material": "glass", "colour": "#e6e2ee", "liquid": "tomato"},
        ],
    ),
}
