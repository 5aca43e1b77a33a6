"""Mains leads lying loose, whole or with torn insulation."""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import Material, metal, plain, shade
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part
from toolkit.sampling import pick
from toolkit.shapes import box, lathe, spline, tube

from makers.convex import few_corners
from makers.soft_forms import bars

# where a lead lies, seen from above: from its plug to its coupling
LINES = {
    "long": (
        *((0.06, -0.52), (-0.06, -0.34), (-0.1, -0.14), (0.0, 0.0)),
        *((0.1, 0.14), (0.07, 0.33), (-0.05, 0.5)),
    ),
    "wavy": (
        *((-0.06, -0.4), (-0.19, -0.3), (-0.12, -0.14), (0.1, -0.12), (0.2, -0.02), (0.1, 0.09)),
        *((-0.1, 0.1), (-0.2, 0.2), (-0.1, 0.31), (0.08, 0.33), (0.2, 0.4)),
    ),
}
TORN_M = 0.095  # how far the insulation is torn open
RAISED_M = 0.0175  # middle of plug and coupling above the floor


def _along(path: np.ndarray) -> np.ndarray:
    return np.r_[0, np.cumsum(np.linalg.norm(np.diff(path, axis=0), axis=1))]


def _at(path: np.ndarray, metres) -> np.ndarray:
    """Points of a path at these lengths from its start."""
    s = _along(path)
    return np.stack([np.interp(metres, s, path[:, k]) for k in range(3)], -1)


def _plug(colour: str) -> list[Mesh]:
    """A round plug, its pins towards +X, around the x axis."""
    profile = [(0, 0), (0.009, 0), (0.011, 0.012), (0.0175, 0.022), (0.0175, 0.046), (0, 0.046)]
    body = lathe(profile, 9, mat=plain(colour, 0.03)).turn(ry=math.pi / 2)
    pins = [[(0.044, q * 0.0095, 0), (0.066, q * 0.0095, 0)] for q in (-1, 1)]
    return [body, *bars(pins, 0.0034, metal(), 4)]


def _coupling(colour: str) -> list[Mesh]:
    """What goes into the appliance: a block with three slots, towards +X."""
    block = box(0.05, 0.03, 0.024, (0.025, 0, -0.012), plain(colour, 0.03), 0.004)
    slot = plain("#08080a", 0)
    slots = [
        box(0.002, 0.0045, 0.008, (0.0498, y, z), slot)
        for y, z in ((-0.008, -0.007), (0.008, -0.007), (0.0, 0.0))
    ]
    return [block, *slots]


def _strands(torn: np.ndarray, radius: float, rng: np.random.Generator) -> list[Mesh]:
    """Copper wires along the torn stretch, bulging, some of them broken and standing out."""
    copper = Material(occlusion=0.35)
    streaks = copper.noise(420, 2, stretch=(1, 1, 1))
    stops = [(0.3, "#b4501c"), (0.48, "#e8863c"), (0.62, "#ffc487"), (0.75, "#e07a34")]
    copper.colour(copper.ramp(streaks, stops))
    ahead = torn[-1] - torn[0]
    ahead /= np.linalg.norm(ahead)
    aside = np.array([-ahead[1], ahead[0], 0.0])
    meshes = []
    for k in range(7):
        a = math.tau * k / 7
        t = np.linspace(0, 1, 7)
        wide = radius * 0.45 + 0.011 * np.sin(math.pi * t) * float(rng.uniform(0.75, 1.15))
        p = _at(torn, t * _along(torn)[-1])
        p = p + np.outer(wide * math.cos(a), aside)
        p[:, 2] = np.maximum(p[:, 2] + 0.8 * wide * math.sin(a), 0.0024)
        meshes.append(tube(p, 0.0024, 3, mat=copper, up=(0, 0, 1)))
    for k in range(4):  # broken ones
        back, side = k % 2, (-1, 1)[k // 2]
        t = np.array([0.0, 0.25, 0.45, 0.55])
        p = _at(torn, (1 - t if back else t) * _along(torn)[-1])
        p = p + np.outer(np.array([0.2, 0.9, 1.7, 2.3]) * 0.009 * side, aside)
        p[:, 2] += np.array([0.002, 0.006, 0.011, 0.009]) * float(rng.uniform(0.8, 1.4))
        meshes.append(tube(p, 0.0022, 3, mat=copper, up=(0, 0, 1)))
    return meshes


def _rags(torn: np.ndarray, radius: float, colour: str) -> list[Mesh]:
    """Torn ends of the insulation, and two of the wires inside in their own colours."""
    whole = _along(torn)[-1]
    dark = plain(shade(colour, 0.25), 0.3, 200)  # scorched, so that one sees where it ends
    meshes = []
    for start, end in ((-0.001, 0.012), (whole + 0.001, whole - 0.012)):
        p = _at(torn, np.array([max(start, 0), (start + end) / 2, end]).clip(0, whole))
        rag = tube(p, [radius * 1.03, radius * 1.2, radius * 1.3], 6, mat=dark, up=(0, 0, 1))
        rag.v[:, 2] = np.maximum(rag.v[:, 2], 0.0)
        meshes.append(rag)
    ahead = torn[-1] - torn[0]
    aside = np.array([-ahead[1], ahead[0], 0.0]) / np.linalg.norm(ahead[:2])
    for side, paint in ((-1, "#2f62c8"), (1, "#6a3a1c")):
        t = np.linspace(0, 1, 5)
        p = _at(torn, t * whole) + np.outer(side * (0.003 + 0.013 * np.sin(math.pi * t)), aside)
        p[:, 2] = 0.0028
        meshes.append(tube(p, 0.0028, 3, mat=plain(paint, 0.05), up=(0, 0, 1)))
    return meshes


def power_cable(line: str, colour: str, ends: str, radius: float, seed: int) -> Model:
    """A mains lead on the floor in a "long" or "wavy" line, a plug at one end and a coupling at
    the other. Variant `frayed`: its insulation torn open, the copper bare."""
    rng = np.random.default_rng(seed)
    flat = np.c_[np.array(LINES[line]), np.full(len(LINES[line]), radius)]
    path = spline(flat, 5 if line == "long" else 4)
    whole = _along(path)[-1]
    for k in (0, -1):  # the ends lie in the middle of plug and coupling
        far = np.abs(_along(path) - (0 if k == 0 else whole))
        path[:, 2] += (RAISED_M - radius) * np.clip(1 - far / 0.06, 0, 1)
    middle = whole * (0.52 if line == "long" else 0.5)
    cut = np.array([middle - TORN_M / 2, middle + TORN_M / 2])
    s = _along(path)
    stretches = [
        np.concatenate([_at(path, [a]), path[(s > a + 0.004) & (s < b - 0.004)], _at(path, [b])])
        for a, b in ((0.0, cut[0]), tuple(cut), (cut[1], whole))
    ]
    sheath = plain(colour, 0.04, 40)
    hoses = [tube(p, radius, 5, mat=sheath, up=(0, 0, 1), weight=0.7) for p in stretches]
    body = [hoses[0], hoses[2]]
    pieces = []
    for end, after, made in ((0, 1, _plug(ends)), (-1, -2, _coupling(ends))):
        away = path[end] - path[after]
        for mesh in made:
            mesh.turn(rz=math.atan2(away[1], away[0]))
            mesh.move(path[end][0], path[end][1], RAISED_M)
        body += made
        pieces.append(few_corners(made[0].v, 24))
    for p in stretches:
        for k in range(0, len(p) - 1, 2):
            near = p[k : k + 3]
            ahead = np.gradient(near[:, :2], axis=0)
            aside = np.c_[-ahead[:, 1], ahead[:, 0]] / np.linalg.norm(ahead, axis=1)[:, None]
            low = np.concatenate([near[:, :2] + q * radius * aside for q in (-1, 1)])
            rise = np.tile(near[:, 2], 2)
            pieces.append(np.r_[np.c_[low, rise - radius], np.c_[low, rise + radius]])
    parts = {
        "body": Part(body, collision=pieces),
        "sheath": Part([hoses[1]], collision="none"),
        "torn": Part(_rags(stretches[1], radius, colour), collision="none"),
        "copper": Part(
            _strands(stretches[1], radius, rng), collision="none", rgba=(1.25, 1.2, 1.15, 1.0)
        ),
    }
    return Model(
        "mains cable",
        parts,
        mass=0.25,
        friction=0.8,
        variants={"default": ["body", "sheath"], "frayed": ["body", "torn", "copper"]},
        states=[{"state": "FRAYED", "variants": ["frayed"], "parts": ["copper", "torn"]}],
        texture_size=128,
        prune=False,
    )


def power_cable_random(rng: np.random.Generator) -> dict:
    colour = pick(rng, ["#232427", "#eeeeea"])
    return {"line": "long", "colour": colour, "ends": colour, "radius": 0.0058, "seed": 5}


MODELS = {
    "power_cable": Maker(
        power_cable,
        power_cable_random,
        4,
        [
            {"colour": "#232427", "ends": "#2c2d31"},
            {"colour": "#eeeeea", "ends": "#f4f4f0"},
            {"line": "wavy", "colour": "#ea6a1e", "ends": "#26272a", "radius": 0.0065},
            {"line": "wavy", "colour": "#6b4226", "ends": "#4a2c18", "radius": 0.0065},
        ],
    ),
}
