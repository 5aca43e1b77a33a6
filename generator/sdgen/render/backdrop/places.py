"""Where a home lies: what stands on the street before it, behind it and far away."""

from __future__ import annotations

import numpy as np

from sdgen.render.backdrop.builder import (
    FRAMES,
    GRAVEL,
    PAVING,
    PLASTER,
    ROOFS,
    SAND,
    SEA,
    SNOW,
    Builder,
    Place,
)
from sdgen.render.backdrop.canvas import linear
from sdgen.render.backdrop.facades import Facade, Plain
from sdgen.render.backdrop.ground import Patch
from sdgen.scene import Outdoors

#: Kinds of places by storey, and how often.
_LOW = {"suburb": 0.5, "street": 0.15, "park": 0.2, "sea": 0.15}
_MIDDLE = {"suburb": 0.25, "street": 0.3, "park": 0.15, "flats": 0.2, "sea": 0.1}
_HIGH = {"street": 0.4, "park": 0.15, "flats": 0.3, "sea": 0.15}


def _suburb(b: Builder) -> None:
    end = b.street(11.0)
    front = b.hedge if b.rng.random() < 0.6 else b.fence
    for x in np.arange(-64, 64, 16.0).tolist():
        y = end + b.between(9, 12)
        b.house(x + b.between(-1.5, 1.5), y, b.between(9.5, 12), b.between(8, 9.5))
        front((x - 7.6, end + 0.3), (x + 4.6, end + 0.8), b.between(0.8, 1.3))
        b.road((x + 4.8, end), (x + 7.4, y), GRAVEL)
        b.tree(x + b.between(-6, 4), end + b.between(2, 4), 2.5, 6.5)
        if abs(x) > 15:
            b.house(x + np.sign(x) * b.between(0, 3), b.between(-7, 4), b.between(9.5, 11.5), 8.6)
        b.house(x + 7 + b.between(-2, 2), b.between(-50, -42), b.between(9.5, 12), b.between(8, 10))
        b.tree(x + b.between(-6, 6), b.between(-38, -30), 5.0, 10.0)
    b.garden(b.between(19, 24), b.between(11, 13))
    b.place.patches.append(Patch((-0.9, 3.0), (0.9, 11.0), b.paving, 0.06, slabs_m=0.5))
    for x in (-8.5, -5.5, 4.5, 8.0):
        b.bush(x + b.between(-1, 1), b.between(8.6, 10))
    b.town(75, 260, 34, (0, 2 * np.pi))


def _street(b: Builder) -> None:
    near = 7.5
    b.place.patches.append(Patch((-400, 4.5), (400, near), b.paving, 0.05, slabs_m=0.6))
    b.place.patches.append(Patch((-3.4, -5), (3.4, 4.5), b.paving, 0.06, slabs_m=0.5))
    end = b.street(near)
    b.row(end, b.between(10, 12), 95.0, (3, 5))
    # At a corner there is a square on one side.
    corner = int(b.rng.integers(3)) - 1
    for sign in (-1, 1):
        for k in range(4 if sign != corner else 0):
            low, high = sorted((sign * (17.0 + 12 * k), sign * (29.0 + 12 * k)))
            count = int(b.rng.integers(3, 5))
            facade = Facade(b.pick(PLASTER), b.pick(FRAMES), floors=count)
            roof = SNOW if b.snow else b.pick(ROOFS)
            b.block((low, -6.0), (high, 4.5), count * 2.9 + 0.4, facade, roof, 0.7, 0)
        b.hedge((sign * 16.0 - 0.4, -6.0), (sign * 16.0 + 0.4, 4.0), b.between(1.0, 1.8))
        for _ in range(2 if sign != corner else 8):
            far = 15 if sign != corner else 40
            b.tree(sign * b.between(11.5, far), b.between(-7, 4), 3.5, 9.0)
        b.bush(sign * b.between(9, 12), b.between(-4, 4))
    for x in np.arange(-60, 60, 11.0).tolist():
        b.tree(x + b.between(-1, 1), near + 0.9, 5.0, 8.0)
        b.tree(x + 5 + b.between(-1, 1), end - 0.9, 5.0, 8.0)
    # A courtyard behind.
    b.road((-60, -18.5), (60, -16.5), GRAVEL)
    b.trees_about((-30, -26), (30, -13), 9, (4.0, 9.0))
    b.hedge((-14, -12.4), (-5, -11.8), 1.1)
    b.row(-42.0, 11.0, 70.0, (3, 5))
    b.town(80, 300, 34, (0, 2 * np.pi))


def _flats(b: Builder) -> None:
    end = b.street(12.0)
    for x, y, turned in (
        (-34, end + 24, 0),
        (26, end + 18, 0),
        (78, end + 40, 1),
        (-92, end + 30, 1),
        (56, -8, 1),
        (-58, -16, 1),
        (-16, -52, 0),
        (44, -66, 0),
        (-84, -80, 0),
        (8, end + 80, 0),
    ):
        size = b.between(34, 48), b.between(11, 13)
        wide, deep = size[::-1] if turned else size
        floors = int(b.rng.integers(4, 9))
        b.slab(x + b.between(-3, 3), y + b.between(-3, 3), wide, deep, floors)
    for y, bend in ((-14.0, 1.5), (-34.0, 3.0), (end + 6.0, 1.0)):
        path = linear(160, 152, 140)
        b.place.patches.append(Patch((-80, y), (80, y + 1.6), path, 0.06, bend))
    b.road((-20, -27), (14, -19))
    for x in np.arange(-18, 12, 2.9).tolist():
        if b.rng.random() < 0.6:
            b.car(x, -24.5, 1)
    b.trees_about((-50, -45), (50, -10), 20, (4.0, 11.0))
    b.trees_about((-60, end + 2), (60, end + 14), 16, (4.0, 10.0))
    for _ in range(10):
        b.bush(b.between(-20, 20), b.between(-16, -10))
    b.town(130, 320, 26, (0, 2 * np.pi))


def _park(b: Builder) -> None:
    end = b.street(9.0)
    path = linear(176, 164, 144)
    for y, bend in ((end + 9, 2.5), (end + 32, 5.0)):
        b.place.patches.append(Patch((-120, y), (120, y + 2.2), path, 0.06, bend))
    b.place.patches.append(Patch((6, end + 2), (8, end + 80), path, 0.06))
    if b.rng.random() < 0.5:
        water = linear(70, 92, 92)
        b.place.patches.append(Patch((-40, end + 14), (-6, end + 27), water, 0.02, 3.0, 0.8))
    b.hedge((-60, end + 0.2), (5.5, end + 0.9), 0.9)
    b.hedge((8.5, end + 0.2), (60, end + 0.9), 0.9)
    b.trees_about((-75, end + 4), (75, end + 30), 22, (5.0, 12.0))
    b.trees_about((-120, end + 34), (120, end + 110), 46, (8.0, 15.0))
    for sign in (-1, 1):
        for k in range(3):
            x, y = sign * (b.between(19, 22) + 17 * k), b.between(-6, 2)
            b.house(x, y, 11.5, 9.5, int(b.rng.integers(2, 4)))
    b.garden(b.between(18, 22), b.between(11, 14))
    for x in np.arange(-50, 50, 17.0).tolist():
        b.house(x, b.between(-46, -40), b.between(10, 13), 9.5, int(b.rng.integers(2, 4)))
        b.tree(x + 8, b.between(-38, -28), 5.0, 9.0)
    b.town(150, 320, 26, (0, 2 * np.pi))


def _sea(b: Builder) -> None:
    end = b.street(10.0)
    b.place.patches.append(Patch((-3000, end), (3000, end + 3.5), PAVING, 0.05, slabs_m=1.0))
    b.place.patches.append(Patch((-3000, end + 3.5), (3000, end + 26), SAND, 0.08))
    b.place.patches.append(Patch((-9000, end + 24), (9000, 90000), SEA, 0.02, 1.5, 0.75))
    wall = linear(186, 182, 174)
    b.block((-90, end + 3.3), (90, end + 3.6), 0.7, Plain(wall), wall)
    for x in np.arange(-70, 70, 14.0).tolist():
        if b.rng.random() < 0.6:
            b.tree(x + b.between(-2, 2), end + 1.4, 4.0, 7.0)
    for sign in (-1, 1):
        for k in range(5):
            x, y = sign * (b.between(18, 21) + 14 * k), b.between(-6, 1)
            b.house(x, y, 10.5, 9.0, int(b.rng.integers(1, 4)))
    b.garden(b.between(17, 20), b.between(11, 13))
    for x in np.arange(-60, 60, 15.0).tolist():
        b.house(x, b.between(-44, -36), b.between(9, 12), 9.0)
        b.tree(x + 7, b.between(-34, -26), 4.0, 8.0)
    b.place.hills = float(b.rng.choice((0.07, 0.11)))
    b.place.sea = b.between(1.15, 1.4)
    b.town(70, 260, 30, (np.pi * 1.06, np.pi * 1.94))


_KINDS = {"suburb": _suburb, "street": _street, "flats": _flats, "park": _park, "sea": _sea}


def place_random(outdoors: Outdoors, rng: np.random.Generator) -> Place:
    """One of the places where a home so high up may lie."""
    chances = _LOW if outdoors.storey == 0 else _MIDDLE if outdoors.storey < 3 else _HIGH
    kind = tuple(chances)[int(rng.choice(len(chances), p=tuple(chances.values())))]
    builder = Builder(outdoors, rng)
    _KINDS[kind](builder)
    return builder.place
