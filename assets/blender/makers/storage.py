"""Free-standing storage: bookshelf, wardrobe, nightstand, tv stand."""

from __future__ import annotations

import numpy as np
from toolkit.model import Container, Joint, Maker, Model
from toolkit.sampling import noise_offset, pick
from toolkit.shapes import lathe, tube

from .bookcases import BOOKSHELVES, stocked
from .designs import extend
from .dressers import NIGHTSTANDS
from .joinery import (
    Assembly,
    bar_handle,
    carcass,
    drawer_box,
    finish,
    front,
    hinge,
    leg,
    open_closed,
    steel,
    surface,
)
from .media_units import TV_STANDS
from .wardrobes import WARDROBES

Offset = tuple[float, float, float]


def bookshelf(
    width: float = 0.8,
    height: float = 1.8,
    depth: float = 0.3,
    shelves: int = 5,
    wood: str = "oak",
    back_panel: bool = True,
    offset: Offset = (0, 0, 0),
) -> Model:
    """An open bookcase with `shelves` boards to stand things on, and a top."""
    asm, half, t = Assembly(), width / 2, 0.024
    x0, x1, plinth = -depth / 2, depth / 2, 0.07
    sides, boards = finish(wood, 2, offset), finish(wood, 1, offset)
    for y in (-half, half - t):
        asm.board("body", (x0, y, 0), (x1, y + t, height), sides, 0.003)
    asm.board("body", (x0, -half + t, height - t), (x1, half - t, height), boards, 0.002)
    asm.board("body", (x1 - 0.035, -half + t, 0), (x1 - 0.015, half - t, plinth), boards)
    if back_panel:
        low, high = (x0, -half + t, plinth), (x0 + 0.008, half - t, height - t)
        asm.board("body", low, high, sides)
    step = (height - t - plinth) / shelves
    supports = [surface("top", (x0, -half), (x1, half), height)]
    for i in range(shelves):
        z = plinth + i * step
        asm.board("body", (x0 + 0.008, -half + t, z), (x1 - 0.004, half - t, z + t), boards, 0.002)
        low, high = (x0 + 0.01, -half + t), (x1 - 0.004, half - t)
        supports.append(surface(f"shelf_{i + 1}", low, high, z + t, step - t))
    return Model(
        title=f"{'painted' if wood.startswith('#') else wood} bookshelf, {shelves} shelves",
        parts=asm.parts(),
        mass=30.0 * width,
        supports=supports,
        ground_shadow=True,
    )


def bookshelf_random(rng: np.random.Generator) -> dict:
    """Parameters of a random bookshelf."""
    return {
        "width": round(float(rng.uniform(0.7, 1.0)), 2),
        "height": round(float(rng.uniform(1.75, 2.0)), 2),
        "depth": round(float(rng.uniform(0.28, 0.33)), 2),
        "shelves": int(rng.integers(4, 6)),
        "wood": pick(rng, ["oak", "walnut", "#e9e7e1"]),
        "offset": noise_offset(rng),
    }


def wardrobe(
    width: float = 1.2,
    height: float = 2.0,
    depth: float = 0.58,
    wood: str = "#eceae5",
    style: str = "shaker",
    offset: Offset = (0, 0, 0),
) -> Model:
    """Two hinged doors: shelves behind the left one, a rail behind the right one."""
    asm, half, t, plinth = Assembly(), width / 2, 0.02, 0.07
    back, case_front = -depth / 2, depth / 2 - 0.02
    outside, inside = (
        finish(wood, 2, offset),
        finish("birch" if wood.startswith("#") else wood, 2, offset),
    )
    asm.board(
        "body", (back + 0.01, -half + 0.01, 0), (case_front - 0.02, half - 0.01, plinth), outside
    )
    carcass(
        asm, "body", (back, -half, plinth), (case_front, half, height - 0.03), outside, inside, t
    )
    cornice = (back, -half, height - 0.03), (case_front + 0.022, half, height)
    asm.board("body", *cornice, outside, 0.006, segments=2)
    asm.board("body", (back, -0.01, plinth + t), (case_front, 0.01, height - 0.03 - t), inside)
    floor, roof = plinth + t, height - 0.03 - t
    shelf_z = [floor + (roof - floor) * k / 4 for k in (1, 2, 3)]
    supports = []
    low, high = (back + 0.01, -half + t), (case_front - 0.03, -0.01)
    for name, z, following in zip(
        ("left_floor", "left_shelf_1", "left_shelf_2", "left_shelf_3"),
        (floor, *shelf_z),
        (*shelf_z, roof + t),
        strict=True,
    ):
        if z != floor:
            asm.board("body", (low[0], low[1], z - t), (high[0], high[1], z), inside)
        supports.append(surface(name, low, high, z, following - t - z, "inside_left"))
    rail_z = roof - 0.32
    asm.board(
        "body",
        (back + 0.01, 0.01, roof - 0.25 - t),
        (case_front - 0.03, half - t, roof - 0.25),
        inside,
    )
    rail = [(0, 0.01, rail_z), (0, half - t, rail_z)]
    asm.add("body", tube(rail, 0.013, 8, mat=steel()), solid=True)
    low, high = (back + 0.01, 0.01), (case_front - 0.03, half - t)
    supports.append(surface("right_floor", low, high, floor, rail_z - 0.02 - floor, "inside_right"))
    supports.append(surface("right_shelf", low, high, roof - 0.25, 0.25, "inside_right"))
    supports.append(surface("top", (back, -half), (case_front, half), height))
    joints, states, containers, outer = {}, [], [], case_front + 0.02
    for side, y0, y1 in (("left", -half, 0.0), ("right", 0.0, half)):
        door = f"door_{side}"
        z = (plinth + 0.003, height - 0.034)
        front(asm, door, case_front, (y0 + 0.002, y1 - 0.002), z, outside, style, 0.02, 0.075)
        bar_handle(
            asm, door, outer, -0.05 if side == "left" else 0.05, 1.02, 0.22, steel(), reach=0.028
        )
        joints[door] = hinge(outer, y0 if side == "left" else y1)
        states += open_closed(door, door)
        a, b = (y0 + t, -0.01) if side == "left" else (0.01, y1 - t)
        center = ((back + case_front) / 2, (a + b) / 2, (floor + roof) / 2)
        size = (case_front - back - 0.02, b - a, roof - floor)
        containers.append(Container(f"inside_{side}", center, size, "body", door))
    return Model(
        title=f"{'painted' if wood.startswith('#') else wood} wardrobe, two doors",
        parts=asm.parts(door_left={"joint": "door_left"}, door_right={"joint": "door_right"}),
        mass=85.0,
        joints=joints,
        states=states,
        supports=supports,
        containers=containers,
        ground_shadow=True,
    )


def wardrobe_random(rng: np.random.Generator) -> dict:
    """Parameters of a random wardrobe."""
    return {
        "width": round(float(rng.uniform(1.0, 1.3)), 2),
        "height": round(float(rng.uniform(1.9, 2.05)), 2),
        "wood": pick(rng, ["#eceae5", "oak", "walnut"]),
        "style": pick(rng, ["shaker", "slab"]),
        "offset": noise_offset(rng),
    }


def nightstand(
    width: float = 0.45,
    height: float = 0.5,
    depth: float = 0.4,
    wood: str = "oak",
    legs: bool = True,
    offset: Offset = (0, 0, 0),
) -> Model:
    """A bedside table: a drawer above an open compartment."""
    asm, half, t = Assembly(), width / 2, 0.018
    back, case_front = -depth / 2, depth / 2 - 0.018
    base = 0.14 if legs else 0.0
    case, knob = finish(wood, 1, offset), steel()
    carcass(asm, "body", (back, -half, base), (case_front, half, height - 0.02), case, case, t)
    asm.board(
        "body", (back, -half - 0.008, height - 0.02), (depth / 2, half + 0.008, height), case, 0.004
    )
    if legs:
        for x, y in (
            (a, b) for a in (back + 0.05, case_front - 0.05) for b in (-half + 0.05, half - 0.05)
        ):
            spread = (1 if x > 0 else -1) * 0.025, (1 if y > 0 else -1) * 0.025
            leg(
                asm, "body", (x + spread[0], y + spread[1]), (x, y), (0, base), (0.011, 0.017), case
            )
    drawer_low = height - 0.19
    asm.board(
        "body", (back + 0.008, -half + t, drawer_low - t), (case_front, half - t, drawer_low), case
    )
    y, z = (-half + 0.003, half - 0.003), (drawer_low - 0.014, height - 0.024)
    front(asm, "drawer", case_front, y, z, case, "slab")
    sphere = [
        (0, 0),
        (0.008, 0),
        (0.007, 0.008),
        (0.014, 0.014),
        (0.015, 0.02),
        (0.01, 0.026),
        (0, 0.027),
    ]
    round_knob = lathe(sphere, 12, mat=knob).turn(ry=np.pi / 2)
    asm.add("drawer", round_knob.move(depth / 2, 0, (z[0] + z[1]) / 2))
    low, high = (
        (back + 0.03, -half + 0.028, drawer_low + 0.006),
        (case_front, half - 0.028, height - 0.065),
    )
    drawer_box(asm, "drawer", low, high, finish("birch", 1, offset))
    size = np.subtract(high, low) - [0.012, 0.024, 0.0]
    center = np.add(high, low) / 2
    inner = (low[0] + 0.012, low[1] + 0.012), (high[0], high[1] - 0.012)
    open_floor = base + t
    room = drawer_low - t - open_floor
    compartment = (back + 0.01, -half + t), (case_front, half - t)
    return Model(
        title=f"{'painted' if wood.startswith('#') else wood} nightstand with a drawer",
        parts=asm.parts(drawer={"joint": "drawer"}),
        mass=13.0,
        joints={"drawer": Joint("prismatic", (0, 0, drawer_low), (1, 0, 0), 0.0, depth * 0.62)},
        states=open_closed("drawer", "drawer", 0.01, 0.1),
        supports=[
            surface("top", (back, -half), (depth / 2, half), height),
            surface(
                "drawer_floor", *inner, low[2] + 0.008, high[2] + 0.01 - low[2], "drawer", "drawer"
            ),
            surface("compartment", *compartment, open_floor, room, "compartment"),
        ],
        containers=[
            Container("drawer", tuple(center), tuple(size), "drawer", "drawer"),
            Container(
                "compartment",
                ((back + case_front) / 2, 0.0, open_floor + room / 2),
                (depth - 0.04, width - 2 * t, room),
            ),
        ],
        ground_shadow=True,
    )


def nightstand_random(rng: np.random.Generator) -> dict:
    """Parameters of a random nightstand."""
    return {
        "width": round(float(rng.uniform(0.4, 0.5)), 2),
        "height": round(float(rng.uniform(0.46, 0.56)), 2),
        "wood": pick(rng, ["oak", "walnut", "#e9e7e1"]),
        "legs": bool(rng.random() < 0.6),
        "offset": noise_offset(rng),
    }


def tv_stand(
    width: float = 1.5,
    height: float = 0.48,
    depth: float = 0.4,
    wood: str = "walnut",
    offset: Offset = (0, 0, 0),
) -> Model:
    """A low board: an open bay with a shelf in the middle, doors left and right."""
    asm, half, t, base = Assembly(), width / 2, 0.022, 0.12
    x0, x1, third = -depth / 2, depth / 2, width / 6
    case = finish(wood, 1, offset)
    carcass(asm, "body", (x0, -half, base), (x1, half, height), case, case, t, bevel=0.003)
    for y in (-third, third):
        asm.board("body", (x0, y - t / 2, base + t), (x1 - 0.002, y + t / 2, height - t), case)
    middle = (base + height) / 2
    asm.board(
        "body",
        (x0 + 0.01, -third + t / 2, middle - 0.009),
        (x1 - 0.03, third - t / 2, middle + 0.009),
        case,
    )
    fronts = finish("#e6e2d8" if wood != "birch" else "birch", 1, offset)
    joints, settings, states, containers, floors = {}, {}, [], [], []
    for side, y0, y1 in (
        ("left", -half + t, -third - t / 2),
        ("right", third + t / 2, half - t),
    ):
        door = f"door_{side}"
        low, high = (
            (x1 - 0.024, y0 + 0.002, base + t + 0.002),
            (x1 - 0.004, y1 - 0.002, height - t - 0.002),
        )
        asm.board(door, low, high, fronts, 0.002)
        groove = (y0 + y1) / 2
        slot = (
            (x1 - 0.006, groove - 0.06, height - t - 0.03),
            (x1 + 0.004, groove + 0.06, height - t - 0.018),
        )
        asm.board(door, *slot, steel(), solid=False)
        outer = y0 + 0.002 if side == "left" else y1 - 0.002
        joints[door], settings[door] = hinge(x1 - 0.004, outer), {"joint": door}
        states += open_closed(door, door)
        room = height - base - 2 * t
        center = ((x0 + x1) / 2 - 0.01, (y0 + y1) / 2, base + t + room / 2)
        size = (depth - 0.05, y1 - y0 - 0.004, room - 0.004)
        containers.append(Container(f"inside_{side}", center, size, "body", door))
        at = (x0 + 0.01, y0), (x1 - 0.026, y1)
        name = f"inside_{side}"
        floors.append(surface(f"{name}_floor", *at, base + t, room, name))
    for x in (x0 + 0.05, x1 - 0.05):
        for y in (-half + 0.1, half - 0.1):
            leg(asm, "body", (x, y), (x, y), (0, base), (0.013, 0.02), case)
    low, high = (x0 + 0.01, -third + t / 2), (x1, third - t / 2)
    return Model(
        title=f"{wood} tv stand",
        parts=asm.parts(**settings),
        mass=32.0,
        joints=joints,
        states=states,
        containers=containers,
        supports=[
            surface("top", (x0, -half), (x1, half), height),
            surface("shelf_1", low, high, base + t, middle - 0.009 - base - t),
            surface(
                "shelf_2", low, (x1 - 0.03, high[1]), middle + 0.009, height - t - middle - 0.009
            ),
            *floors,
        ],
        ground_shadow=True,
    )


def tv_stand_random(rng: np.random.Generator) -> dict:
    """Parameters of a random tv stand."""
    return {
        "width": round(float(rng.uniform(1.3, 1.7)), 2),
        "height": round(float(rng.uniform(0.42, 0.52)), 2),
        "wood": pick(rng, ["walnut", "oak", "black"]),
        "offset": noise_offset(rng),
    }


MODELS = {
    "bookshelf": extend(
        Maker(
            stocked(bookshelf, {"shelf_2": "novels", "shelf_4": "pastels"}),
            bookshelf_random,
            3,
            [
                {"wood": "oak", "shelves": 5, "height": 1.85},
                {"wood": "#e9e7e1", "shelves": 4, "height": 1.75},
                {"wood": "walnut", "shelves": 5, "width": 0.95},
            ],
        ),
        BOOKSHELVES,
    ),
    "wardrobe": extend(
        Maker(
            wardrobe,
            wardrobe_random,
            2,
            [{"wood": "#eceae5", "style": "shaker"}, {"wood": "oak", "style": "slab"}],
        ),
        WARDROBES,
    ),
    "nightstand": extend(
        Maker(
            nightstand,
            nightstand_random,
            2,
            [{"wood": "oak", "legs": True}, {"wood": "#e9e7e1", "legs": False}],
        ),
        NIGHTSTANDS,
    ),
    "tv_stand": extend(
        Maker(tv_stand, tv_stand_random, 2, [{"wood": "walnut"}, {"wood": "oak"}]), TV_STANDS
    ),
}
