"""Batteries in their charging docks: of power tools and of electric bicycles."""

from __future__ import annotations

import math

import numpy as np
from PIL import Image
from toolkit.labels import canvas, text
from toolkit.materials import glowing, metal, plain
from toolkit.materials import label as printed
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part
from toolkit.sampling import pick
from toolkit.shapes import box, lathe

from makers.convex import few_corners, lying
from makers.soft_forms import bars, bent

SHINE = (1.5, 1.5, 1.5, 1.0)
BAND_M = 0.016  # height of the strip of light


def _sign(paint: str, ink: str, words: str = "") -> Image.Image:
    """A battery with a bolt of lightning on it; on a wide one how many volts."""
    image, draw = canvas(160 if words else 64, 64, paint)
    draw.rounded_rectangle((8, 16, 50, 48), 5, outline=ink, width=5)
    draw.rectangle((50, 25, 56, 39), fill=ink)
    draw.polygon([(33, 18), (19, 34), (28, 34), (24, 47), (39, 29), (30, 29)], fill=ink)
    if words:
        text(draw, words, (60, 14, 154, 50), "bold", ink)
    return image


def _lead(points: list, mat, turn: float) -> list[Mesh]:
    """A cable along points, its plug lying at the last of them."""
    cable = bent(points, 0.005, mat, 5, 3)
    profile = [(0, 0), (0.008, 0), (0.0155, 0.014), (0.0165, 0.034), (0, 0.034)]
    plug = lathe(profile, 8, mat=mat).turn(ry=math.pi / 2)
    pins = bars([[(0.032, q * 0.008, 0), (0.05, q * 0.008, 0)] for q in (-1, 1)], 0.003, metal(), 4)
    at = np.array(points[-1])
    at[2] = 0.0165
    return [cable, *(m.turn(rz=turn).move(*at) for m in (plug, *pins))]


def _band(x: float, y: float, z: float) -> list[Mesh]:
    """A lit strip around the front and the sides of a dock of half sizes x and y."""
    green, out = glowing("#3cff6a"), 0.002
    strip = [box(2 * out, 2 * y - 0.02, BAND_M, (x, 0, z), green)]
    return strip + [box(2 * x - 0.02, 2 * out, BAND_M, (0, q * y, z), green) for q in (-1, 1)]


def _pack(shell: str, accent: str) -> list[Mesh]:
    """A battery of a power tool, 0.12 m long, standing on z = 0."""
    case, lid = plain(shell, 0.04), plain(accent, 0.03)
    sign = printed(_sign(accent, "#f4f4f0"))
    foot = box(0.118, 0.078, 0.05, (0, 0, 0), case, 0.006, labels={"+x": sign}, weight=1.3)
    hood = box(0.108, 0.086, 0.022, (-0.002, 0, 0.047), lid, 0.008, labels={"+z": sign}, weight=1.3)
    latches = [box(0.03, 0.006, 0.02, (0.02, q * 0.0405, 0.022), lid) for q in (-1, 1)]
    return [foot, hood, *latches]


def battery_charger(kind: str, shell: str, accent: str, dock: str) -> Model:
    """A battery being charged: a "tool" battery in its dock, "twin" (two of them), or a "bike"
    battery in its cradle. Variant `on`: a strip of light around the dock glows green."""
    base, rubber = plain(dock, 0.03), plain("#26272a", 0.03)
    if kind == "bike":
        x, y, high = 0.06, 0.17, 0.045
        body = [box(2 * x, 2 * y, high, (0, 0, 0), base, 0.006)]
        case, lid = plain(shell, 0.04), plain(accent, 0.03)
        sign = printed(_sign(shell, "#f4f4f0", "48V"))
        faces = {"+x": sign, "+z": sign, "-x": sign}
        body.append(
            box(0.088, 0.27, 0.085, (0, 0.012, high - 0.006), case, 0.014, 2, faces, weight=1.3)
        )
        body.append(box(0.092, 0.03, 0.078, (0, -0.1, high - 0.004), lid, 0.01))
        grip = [(0, 0.135, high + 0.055), (0, 0.168, high + 0.05), (0, 0.165, high + 0.006)]
        body.append(bent(grip, 0.009, rubber, 6, 3))
        title, mass = "bicycle battery in its charger", 3.4
    else:
        x, y, high = (0.085, 0.075, 0.06) if kind == "tool" else (0.085, 0.155, 0.06)
        body = [box(2 * x, 2 * y, high, (0, 0, 0), base, 0.008)]
        vent = plain("#141518", 0)
        body += [box(0.002, 0.05, 0.004, (x, 0, z), vent) for z in (0.008, 0.015)]
        for at in (0.0,) if kind == "tool" else (-0.075, 0.075):
            body.append(box(0.135, 0.096, 0.012, (-0.004, at, high - 0.002), rubber, 0.003))
            body += [m.move(0.004, at, high + 0.008) for m in _pack(shell, accent)]
        title = "battery in its charger" if kind == "tool" else "two batteries in their charger"
        mass = 1.3 if kind == "tool" else 2.4
    solid = [m for m in body if np.ptp(m.v, axis=0).min() > 0.02]
    route = [(-x + 0.004, 0.0, 0.016), (-x - 0.026, -0.01, 0.006), (-x - 0.03, -0.4 * y, 0.005)]
    route += [(-x - 0.012, -y - 0.022, 0.005), (0.0, -y - 0.034, 0.005)]
    lead = _lead(route, rubber, 0.12)
    pieces = [few_corners(m.v, 40) for m in solid]
    pieces.append(few_corners(lead[1].v, 20))
    pieces += lying(route[1:], 0.005)
    parts = {
        "body": Part([*body, *lead], collision=pieces),
        "led": Part(_band(x, y, 0.024), collision="none", rgba=SHINE),
    }
    return Model(
        title,
        parts,
        mass=mass,
        variants={"default": ["body"], "on": ["body", "led"]},
        states=[
            {"state": "ON", "variants": ["on"], "parts": ["led"]},
            {"state": "OFF", "variants": ["default"], "parts": ["body"]},
        ],
        texture_size=128,
    )


def battery_charger_random(rng: np.random.Generator) -> dict:
    return {
        "kind": "tool",
        "shell": "#26282c",
        "accent": pick(rng, ["#e0a81c", "#1f8a8a"]),
        "dock": "#34363b",
    }


MODELS = {
    "battery_charger": Maker(
        battery_charger,
        battery_charger_random,
        4,
        [
            {"accent": "#d89a10"},
            {"accent": "#1a7f86", "dock": "#4a4f55"},
            {"kind": "twin", "accent": "#c8302c"},
            {"kind": "bike", "shell": "#3a3d44", "accent": "#c8cdd2", "dock": "#1f2023"},
        ],
    ),
}
