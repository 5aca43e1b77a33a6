"""What belongs to the building and hangs on its walls: curtains, blinds, radiators, switches and
sockets.

All have their back at -X and hang with their lowest edge at z = 0.
"""

from __future__ import annotations

import math

import numpy as np
from toolkit.materials import plain, wood
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part, box_piece
from toolkit.sampling import pick
from toolkit.shapes import box, extrude, tube

CLOTHS = {
    "linen": "#d8cfbd",
    "white": "#f1efe9",
    "grey": "#9aa0a4",
    "sage": "#9fae93",
    "blue": "#6f8fae",
    "ochre": "#c79a4a",
    "rust": "#a85a3c",
    "navy": "#2f3f57",
}


def _drape(y0: float, y1: float, height: float, folds: int, mat: object) -> Mesh:
    """A gathered cloth from ``y0`` to ``y1``: folds as a wave seen from above."""
    steps = np.linspace(0.0, 1.0, 6 * folds + 1)
    wave = 0.018 * np.sin(2 * math.pi * folds * steps)
    ys = y0 + (y1 - y0) * steps
    front = [(0.006 + w, float(y)) for w, y in zip(wave, ys, strict=True)]
    back = [(-0.004 + w, float(y)) for w, y in zip(wave, ys, strict=True)]
    return extrude([*back[::-1], *front], height, mat=mat)


def curtain(
    cloth: str, rod: str = "steel", spread: float = 0.3, height: float = 1.45, outer: float = 0.8
) -> Model:
    """A pair of drapes drawn back beside a window of 1.2 m, on a rod above it, whose outer edges
    are twice ``outer`` apart."""
    fabric = plain(CLOTHS[cloth], 0.08, 220)
    bar = wood("#b48a5a") if rod == "wood" else plain("#8b9096" if rod == "steel" else "#232527")
    top = height + 0.03
    meshes = [_drape(-outer, -outer + spread, height, 5, fabric)]
    meshes.append(_drape(outer - spread, outer, height, 5, fabric))
    meshes.append(tube([(0, -outer - 0.08, top), (0, outer + 0.08, top)], 0.011, 8, mat=bar))
    for y in (-outer - 0.09, outer + 0.07):
        meshes.append(box(0.03, 0.02, 0.03, (0, y + 0.01, top - 0.015), bar, 0.006))
    for y in (-outer - 0.03, outer + 0.03):
        meshes.append(box(0.05, 0.012, 0.012, (-0.026, y, top - 0.006), bar))
    pieces = [
        box_piece((0, side * (outer - spread / 2), height / 2), (0.05, spread, height))
        for side in (-1, 1)
    ]
    return Model("pair of curtains", {"body": Part(meshes, collision=pieces)}, mass=2.5)


def curtain_random(rng: np.random.Generator) -> dict:
    return {
        "cloth": pick(rng, tuple(CLOTHS)),
        "rod": pick(rng, ("steel", "black", "wood")),
        "spread": float(rng.uniform(0.26, 0.32)),
    }


def blind(cloth: str, width: float = 1.26, drop: float = 0.45, slats: bool = False) -> Model:
    """A roller blind or a Venetian one before a window, let down by ``drop``."""
    fabric, metal = plain(CLOTHS[cloth], 0.05, 200), plain("#d5d6d4", 0.02)
    top = drop + 0.06
    meshes = [box(0.05, width, 0.055, (0.0, 0, drop + 0.005), metal, 0.008)]
    meshes.append(box(0.022, width - 0.02, 0.016, (0.004, 0, 0), metal, 0.005))
    if slats:
        for z in np.arange(0.02, drop, 0.024):
            # Turned shut, each over the next: of gaps and edges thinner than a pixel nothing but
            # specks would be left from across a room.
            slat = box(0.027, width - 0.02, 0.003, (0.004, 0, float(z)), fabric)
            meshes.append(slat.turn(ry=1.25, pivot=(0.004, 0, float(z) + 0.0015)))
        for y in (-0.35 * width, 0.35 * width):
            meshes.append(box(0.003, 0.006, drop, (0.004, y, 0.008), metal))
    else:
        meshes.append(box(0.004, width - 0.04, drop, (0.004, 0, 0.01), fabric))
    # Clear of the window's frame, which stands 18 mm out of the wall.
    for y in (-width / 2 + 0.03, width / 2 - 0.03):
        meshes.append(box(0.022, 0.02, 0.03, (-0.034, y, drop + 0.02), metal))
    side = width / 2 - 0.012
    meshes.append(tube([(0.022, side, drop), (0.022, side, 0.12)], 0.002, 5, mat=metal))
    piece = box_piece((0.0, 0, top / 2), (0.05, width, top))
    title = "Venetian blind" if slats else "roller blind"
    return Model(title, {"body": Part(meshes, collision=[piece])}, mass=round(1.4 * width, 1))


def blind_random(rng: np.random.Generator) -> dict:
    return {
        "cloth": pick(rng, tuple(CLOTHS)),
        "drop": float(rng.uniform(0.3, 0.55)),
        "slats": bool(rng.random() < 0.3),
    }


def radiator(width: float = 0.8, height: float = 0.5, kind: str = "panel") -> Model:
    """A panel radiator with a valve, or one of upright columns."""
    paint, steel = plain("#f0efeb", 0.02), plain("#a9adb0", 0.03)
    meshes: list[Mesh] = []
    if kind == "panel":
        meshes.append(box(0.06, width, height, (0.012, 0, 0), paint, 0.008))
        count = round(width / 0.085)
        for k in range(count):
            y = -width / 2 + (k + 0.5) * width / count
            meshes.append(box(0.008, 0.022, height - 0.08, (0.044, y, 0.04), paint))
        meshes.append(box(0.066, width, 0.01, (0.012, 0, height - 0.001), paint))
    else:
        count = round(width / 0.055)
        for k in range(count):
            y = -width / 2 + (k + 0.5) * width / count
            meshes.append(box(0.07, 0.03, height, (0.014, y, 0), paint, 0.012))
        for z in (0.04, height - 0.07):
            meshes.append(box(0.03, width - 0.02, 0.03, (0.014, 0, z), paint))
    meshes.append(box(0.03, 0.05, 0.03, (0.012, width / 2 + 0.022, height - 0.09), steel, 0.006))
    meshes.append(box(0.045, 0.055, 0.045, (0.012, width / 2 + 0.06, height - 0.1), paint, 0.012))
    for y in (-width / 4, width / 4):
        meshes.append(box(0.02, 0.03, height * 0.6, (-0.027, y, height * 0.2), steel))
    whole = box_piece((0.012, 0.02, height / 2), (0.1, width + 0.13, height))
    title = "radiator" if kind == "panel" else "column radiator"
    return Model(title, {"body": Part(meshes, collision=[whole])}, mass=round(30 * width, 1))


def radiator_random(rng: np.random.Generator) -> dict:
    return {
        "width": float(rng.uniform(0.5, 1.1)),
        "height": float(rng.uniform(0.4, 0.55)),
        "kind": pick(rng, ("panel", "columns")),
    }


def light_switch(frame: str = "#f3f2ee", double: bool = False) -> Model:
    """A rocker switch in its frame, or two of them one above the other."""
    plate, count = plain(frame, 0.02), 2 if double else 1
    meshes = [box(0.01, 0.082, 0.082 * count, (0, 0, 0), plate, 0.003)]
    for k in range(count):
        rocker = box(
            0.006, 0.056, 0.056, (0.006, 0, 0.013 + 0.082 * k), plain("#fbfaf7", 0.0), 0.002
        )
        meshes.append(rocker)
    piece = box_piece((0.001, 0, 0.041 * count), (0.014, 0.082, 0.082 * count))
    return Model("light switch", {"body": Part(meshes, collision=[piece])}, mass=0.12)


def light_switch_random(rng: np.random.Generator) -> dict:
    return {
        "frame": pick(rng, ("#f3f2ee", "#d9d9d6", "#2c2e31")),
        "double": bool(rng.random() < 0.5),
    }


def power_socket(frame: str = "#f3f2ee", count: int = 2) -> Model:
    """Earthed sockets side by side in one frame."""
    plate, dark = plain(frame, 0.02), plain("#33363a", 0.0)
    wide = 0.071 * count + 0.011
    meshes = [box(0.01, wide, 0.082, (0, 0, 0), plate, 0.003)]
    for k in range(count):
        y = (k - (count - 1) / 2) * 0.071
        meshes.append(box(0.003, 0.046, 0.046, (0.0055, y, 0.018), plain("#e4e3de", 0.0), 0.001))
        for off in (-0.0095, 0.0095):
            meshes.append(box(0.002, 0.006, 0.006, (0.0075, y + off, 0.038), dark))
    piece = box_piece((0.001, 0, 0.041), (0.014, wide, 0.082))
    return Model("power sockets", {"body": Part(meshes, collision=[piece])}, mass=0.15)


def power_socket_random(rng: np.random.Generator) -> dict:
    return {"frame": pick(rng, ("#f3f2ee", "#d9d9d6", "#2c2e31")), "count": int(rng.integers(1, 4))}


DRAPES = (
    {"cloth": "linen"},
    {"cloth": "white", "rod": "black"},
    {"cloth": "grey", "spread": 0.27},
    {"cloth": "sage", "rod": "wood"},
    {"cloth": "blue", "rod": "wood"},
    {"cloth": "ochre", "rod": "black"},
    {"cloth": "rust", "rod": "wood", "spread": 0.27},
    {"cloth": "navy"},
)
#: The same cloths where furniture stands below the window or beside it.
SHORT = {"spread": 0.19, "height": 1.2, "outer": 0.67}
BLINDS = (
    {"cloth": "white", "drop": 0.4, "slats": False},
    {"cloth": "linen", "drop": 0.5, "slats": False},
    {"cloth": "grey", "drop": 0.35, "slats": False},
    {"cloth": "sage", "drop": 0.45, "slats": False},
    {"cloth": "blue", "drop": 0.38, "slats": False},
    {"cloth": "white", "drop": 0.45, "slats": True},
    {"cloth": "linen", "drop": 0.5, "slats": True},
)
#: The same before windows of 0.6 m.
SMALL = {"width": 0.66, "drop": 0.22}

MODELS = {
    "curtain": Maker(
        curtain,
        curtain_random,
        2 * len(DRAPES),
        [*DRAPES, *(drapes | SHORT for drapes in DRAPES)],
    ),
    "blind": Maker(
        blind,
        blind_random,
        2 * len(BLINDS),
        [*BLINDS, *(wide | SMALL for wide in BLINDS)],
    ),
    "radiator": Maker(
        radiator,
        radiator_random,
        4,
        [
            {"width": 0.8, "kind": "panel"},
            {"width": 1.0, "kind": "panel"},
            {"width": 0.6, "height": 0.55, "kind": "panel"},
            {"width": 0.8, "height": 0.52, "kind": "columns"},
        ],
    ),
    "light_switch": Maker(
        light_switch, light_switch_random, 2, [{"double": False}, {"double": True}]
    ),
    "power_socket": Maker(
        power_socket,
        power_socket_random,
        2,
        [{"count": 2, "frame": "#f3f2ee"}, {"count": 2, "frame": "#d9d9d6"}],
    ),
}
