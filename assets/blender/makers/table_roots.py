"""What the round vegetables look like; `produce_forms.serve` makes models of them."""

from __future__ import annotations

import math

from toolkit.materials import plain
from toolkit.mesh import Mesh
from toolkit.shapes import lathe, tube

from makers import produce_faces as faces
from makers.produce_forms import Fruit
from makers.produce_kit import green, stalk

POTATO = Fruit(
    "potato",
    "potatoes",
    [
        (0, 0.0),
        (0.014, 0.004),
        (0.027, 0.018),
        (0.031, 0.038),
        (0.03, 0.06),
        (0.024, 0.08),
        (0.012, 0.091),
        (0, 0.093),
    ],
    0.16,
    {
        "brown": {
            "tones": ("a8824a", "c8a468"),
            "freckle": ("6a4a24", 60, 0.2),
        },
        "red": {"tones": ("8f3f42", "b05a58"), "freckle": ("5a2428", 60, 0.18)},
        "pale": {"tones": ("d0b070", "e4cc90"), "freckle": ("9a7a40", 60, 0.16)},
    },
    lambda kind: faces.plain_face({"red": "#8f3f42"}.get(kind, "#9a743c"), "#f4e8b4", "#e4d494"),
    lies=True,
    lobes=(3, 0.06, 0),
    bend=0.03,
    detail=(11, 9),
    net="d87a1c",
)


def onion_top(look: str, kind: str, z: float) -> list[Mesh]:
    if look != "overripe":
        return []
    mat = plain("5a9a2c", 0.15, 200)
    return [
        tube(
            [(0, 0, z - 0.008), (a * 0.4, b * 0.4, z + 0.014), (a, b, z + 0.03)],
            [0.0036, 0.003, 0.001],
            5,
            mat=mat,
        )
        for a, b in ((0.008, 0.004), (-0.01, 0.006), (0.002, -0.012))
    ]


ONION = Fruit(
    "onion",
    "onions",
    [
        (0, 0.002),
        (0.008, 0.0),
        (0.024, 0.007),
        (0.035, 0.021),
        (0.037, 0.036),
        (0.031, 0.051),
        (0.018, 0.061),
        (0.007, 0.068),
        (0.0045, 0.077),
        (0.006, 0.085),
        (0, 0.084),
    ],
    0.13,
    {
        "brown": {
            "tones": ("b8742c", "d89a48"),
            "streak": ("7a4818", (330, 330, 8), 0.58, 0.68),
            "ends": [(2, 0.06, 0.075, "c8a468"), (2, 0.006, 0.001, "a89068")],
        },
        "red": {
            "tones": ("6a1c40", "8f3460"),
            "streak": ("c878a0", (190, 190, 6), 0.58, 0.72),
            "ends": [(2, 0.06, 0.075, "c8a468"), (2, 0.006, 0.001, "a89068")],
        },
        "white": {
            "tones": ("e4e0cc", "f4f2e4"),
            "streak": ("c8c89c", (190, 190, 6), 0.58, 0.72),
            "ends": [(2, 0.06, 0.075, "b8b484"), (2, 0.006, 0.001, "a89068")],
        },
    },
    lambda kind: faces.rings(
        {"red": "#6a1c40", "white": "#e4e0cc"}.get(kind, "#a8642a"),
        "#f8ecf0" if kind == "red" else "#fbf8e8",
        {"red": "#a84a7c"}.get(kind, "#d8d4a0"),
    ),
    along=False,
    top=onion_top,
    wrinkle=0.16,
    detail=(12, 11),
    net="e8862c",
)


def eggplant_top(look: str, kind: str, z: float) -> list[Mesh]:
    mat = green(look, "5a8a3a")
    cap = lathe(
        [(0, 0.006), (0.024, -0.02), (0.019, -0.006), (0.009, 0.005), (0.006, 0.009), (0, 0.009)][
            ::1
        ],
        10,
        mat=mat,
        rib=lambda k, i: 1 - 0.28 * (i % 2) if k == 1 else 1,
    ).move(z=z)
    return [cap, stalk((0, 0, z + 0.006), 0.026, 0.0055, mat, 0.35, 6)]


def eggplant(length: float, radius: float, neck: float, mass: float, **more) -> Fruit:
    r, h = radius, length
    return Fruit(
        "eggplant",
        "eggplants",
        [
            (0, 0.0),
            (r * 0.55, h * 0.02),
            (r * 0.9, h * 0.12),
            (r, h * 0.28),
            (r * (0.5 + neck * 0.45), h * 0.55),
            (r * neck, h * 0.8),
            (r * neck * 0.75, h * 0.95),
            (0, h),
        ],
        mass,
        {
            "purple": {
                "tones": ("2a1030", "42184c"),
                "gloss": ((r * 0.3, r * 0.75, h * 0.45), h * 0.11, "b89ac8"),
                "brown": "241408",
                "amount": 0.6,
            },
            "striped": {
                "tones": ("7a3a80", "9a5aa0"),
                "streak": ("f0e4f0", (160, 160, 12), 0.52, 0.62),
            },
        },
        lambda kind: faces.seedy("#42184c", "#f2ecc8", "#e4dca8"),
        top=eggplant_top,
        lies=True,
        **more,
    )


EGGPLANT = eggplant(0.2, 0.042, 0.62, 0.3)
EGGPLANT_ROUND = eggplant(0.125, 0.055, 0.8, 0.32)
EGGPLANT_LONG = eggplant(0.25, 0.024, 0.8, 0.15, bend=0.05)


def pumpkin_top(look: str, kind: str, z: float) -> list[Mesh]:
    mat = plain({"fresh": "6f7a3a", "overripe": "8a6f3a", "rotten": "4a3a1c"}[look], 0.25, 120)
    return [
        tube(
            [(0, 0, z - 0.03), (0, 0, z - 0.008), (0.006, 0, z + 0.012), (0.022, 0.004, z + 0.03)],
            [0.019, 0.012, 0.0095, 0.012],
            6,
            mat=mat,
        )
    ]


def pumpkin(width: float, height: float, ribs: int, deep: float, mass: float) -> Fruit:
    r, h = width / 2, height
    return Fruit(
        "pumpkin",
        "pumpkins",
        [
            (0, h * 0.1),
            (r * 0.35, 0.0),
            (r * 0.8, h * 0.14),
            (r, h * 0.48),
            (r * 0.85, h * 0.82),
            (r * 0.45, h),
            (r * 0.14, h * 0.93),
            (0, h * 0.86),
        ],
        mass,
        {
            "orange": {
                "tones": ("d86a14", "ee8a24"),
                "freckle": ("f8b050", 60 * 0.1 / r, 0.14),
            },
            "green": {"tones": ("2f4a2c", "4a6a3c"), "blush": ("b8a04a", 0.55, 0.68)},
            "white": {"tones": ("dcd4bc", "f0ead8"), "blush": ("c8b890", 0.55, 0.7)},
        },
        lambda kind: faces.pulp(
            {"green": "#2f4a2c", "white": "#e0d8c0"}.get(kind, "#d8701a"), "#f6ab3c", "#d8782a"
        ),
        top=pumpkin_top,
        lobes=(ribs, deep, 0),
        detail=(ribs * 3, 9),
        wrinkle=0.1,
    )


PUMPKIN = pumpkin(0.2, 0.15, 9, 0.075, 1.8)
PUMPKIN_TALL = pumpkin(0.17, 0.19, 8, 0.07, 1.9)
PUMPKIN_FLAT = pumpkin(0.22, 0.1, 10, 0.09, 1.6)
PUMPKIN_SMALL = pumpkin(0.1, 0.07, 8, 0.08, 0.3)


GARLIC = Fruit(
    "garlic bulb",
    "garlic",
    [
        (0, 0.003),
        (0.008, 0.0),
        (0.021, 0.006),
        (0.028, 0.018),
        (0.022, 0.031),
        (0.01, 0.041),
        (0.0055, 0.05),
        (0.0045, 0.064),
        (0, 0.065),
    ],
    0.055,
    {
        "white": {
            "tones": ("e8e2d4", "f8f4ec"),
            "streak": ("c8b8a8", (330, 330, 8), 0.56, 0.66),
            "ends": [(2, 0.05, 0.066, "c8b48a"), (2, 0.004, 0.0, "a89068")],
        },
        "purple": {
            "tones": ("e0d4d8", "f2eaec"),
            "streak": ("9a5a86", (300, 300, 8), 0.5, 0.6),
            "ends": [(2, 0.05, 0.066, "c8b48a"), (2, 0.004, 0.0, "a89068")],
        },
    },
    lambda kind: garlic_face(),
    along=False,
    lobes=(6, 0.085, 0),
    detail=(18, 10),
    wrinkle=0.12,
    net="f0f0f0",
)


def garlic_face():
    image, d = faces.round_face("#e4dcd0", "#f4efe4")
    for i in range(6):
        a = math.tau * i / 6
        x, y = 0.5 + 0.29 * math.cos(a), 0.5 + 0.29 * math.sin(a)
        faces.disc(d, 0.31, "#c8a8b0", 0.31, x, y)
        faces.disc(d, 0.26, "#fbf6dc", 0.26, x, y)
        faces.disc(d, 0.07, "#dce4a8", 0.07, x, y)
    faces.disc(d, 0.14, "#d8c8a0")
    return image
