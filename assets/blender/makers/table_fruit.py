"""What the fruits look like; `produce_forms.serve` makes models of them."""

from __future__ import annotations

from toolkit.materials import plain
from toolkit.mesh import Mesh
from toolkit.shapes import ellipsoid, lathe

from makers import produce_faces as faces
from makers.produce_forms import Fruit
from makers.produce_kit import green, leaf, stalk, woody


def apple_top(look: str, kind: str, z: float) -> list[Mesh]:
    out = [stalk((0, 0, z - 0.009), 0.02, 0.0017, woody(look), 0.2)]
    if kind == "red":
        out.append(leaf(0.026, 0.015, green(look)).turn(rz=-0.8).move(0.001, 0, z + 0.002))
    return out


def star(look: str, reach: float, z: float, stem: float, count=5, colour="4f8a2c") -> list[Mesh]:
    """A green calyx with a stub of stalk."""
    mat = green(look, colour)
    crown = lathe(
        [(0, -0.001), (reach, 0.0015), (reach * 0.3, 0.004), (0, 0.005)],
        count * 2,
        mat=mat,
        rib=lambda k, i: 1 - 0.62 * (i % 2) if k == 1 else 1,
    ).move(z=z)
    return [crown, stalk((0, 0, z + 0.003), stem, reach * 0.13 + 0.0008, mat, 0.3)]


def peach_stone(look: str) -> list[Mesh]:
    return [ellipsoid((0.012, 0.007, 0.015), (0, 0.001, 0.034), 9, 6, plain("8a4f28", 0.3, 240))]


def avocado_pit(look: str) -> list[Mesh]:
    dark = {"fresh": "7a4a22", "overripe": "5a3416", "rotten": "38220f"}[look]
    return [ellipsoid((0.0165, 0.0165, 0.0165), (0, 0.003, 0.036), 10, 7, plain(dark, 0.12, 90))]


APPLE = Fruit(
    "apple",
    "apples",
    [
        (0, 0.01),
        (0.008, 0.002),
        (0.02, 0.002),
        (0.033, 0.018),
        (0.039, 0.04),
        (0.035, 0.059),
        (0.022, 0.07),
        (0.009, 0.067),
        (0, 0.057),
    ],
    0.17,
    {
        "red": {
            "tones": ("a31420", "c8262c"),
            "streak": ("e4a93a", (160, 160, 14), 0.56, 0.72),
            "freckle": ("f0d9a0", 230, 0.13),
            "gloss": ((0.03, -0.01, 0.06), 0.016, "ffd0c0"),
        },
        "green": {
            "tones": ("79a52c", "9cc544"),
            "blush": ("c9dc78", 0.52, 0.75),
            "freckle": ("e4ecb0", 230, 0.13),
            "gloss": ((0.03, -0.01, 0.06), 0.016, "f4ffd0"),
        },
        "golden": {
            "tones": ("d8b83a", "ecd45c"),
            "blush": ("d8702c", 0.56, 0.72),
            "freckle": ("8a7a34", 230, 0.11),
        },
    },
    lambda kind: faces.apple_core({"red": "#c8262c", "green": "#8ab838"}.get(kind, "#e0c44a")),
    top=apple_top,
    lobes=(5, 0.02, 0),
)

ORANGE = Fruit(
    "orange",
    "oranges",
    [
        (0, 0.002),
        (0.015, 0.004),
        (0.029, 0.014),
        (0.038, 0.036),
        (0.03, 0.06),
        (0.015, 0.071),
        (0, 0.0705),
    ],
    0.18,
    {
        "orange": {
            "tones": ("e47c0e", "f6a028"),
            "freckle": ("c86a0c", 420, 0.3),
            "gloss": ((0.026, -0.01, 0.062), 0.016, "ffe0b0"),
        },
        "blood": {
            "tones": ("e0600e", "ee8a20"),
            "freckle": ("b84a0c", 420, 0.3),
            "blush": ("b8281c", 0.5, 0.7),
        },
    },
    lambda kind: (
        faces.segments()
        if kind == "orange"
        else faces.segments("#d8601a", "#f8dcc0", "#a81c24", "#d8403a")
    ),
    along=False,
    top=lambda look, kind, z: star(look, 0.005, z - 0.001, 0.001, 5, "6f8a3a")[:1],
    detail=(14, 10),
    wrinkle=0.12,
    net="e2401c",
)


def mandarin_top(look: str, kind: str, z: float) -> list[Mesh]:
    out = [stalk((0, 0, z - 0.002), 0.014, 0.0016, green(look, "4f7a2c"), 0.3)]
    for turn, length in ((-0.5, 0.044), (1.9, 0.036)):
        out.append(
            leaf(length, 0.019, green(look, "2f6a24")).turn(rz=turn).move(0.003, 0, z + 0.01)
        )
    return out


MANDARIN = Fruit(
    "orange with leaves",
    "oranges",
    [
        (0, 0.006),
        (0.013, 0.002),
        (0.027, 0.01),
        (0.034, 0.026),
        (0.028, 0.043),
        (0.013, 0.051),
        (0, 0.05),
    ],
    0.13,
    {"orange": {"tones": ("ea780c", "f8962a"), "freckle": ("d0680c", 420, 0.3)}},
    top=mandarin_top,
    lobes=(8, 0.015, 0),
    detail=(14, 9),
)

TOMATO = Fruit(
    "tomato",
    "tomatoes",
    [
        (0, 0.006),
        (0.014, 0.003),
        (0.028, 0.012),
        (0.036, 0.032),
        (0.03, 0.051),
        (0.015, 0.058),
        (0, 0.052),
    ],
    0.12,
    {
        "red": {
            "tones": ("b8241a", "d8402a"),
            "gloss": ((0.026, -0.008, 0.05), 0.014, "ffc0a8"),
        },
        "yellow": {
            "tones": ("e8a81c", "f6c83a"),
            "gloss": ((0.026, -0.008, 0.05), 0.014, "fff0c0"),
        },
    },
    lambda kind: faces.chambers(),
    along=False,
    top=lambda look, kind, z: star(look, 0.022, z - 0.004, 0.008),
    lobes=(5, 0.03, 0),
    detail=(14, 9),
    wrinkle=0.18,
)
ROMA = Fruit(
    "plum tomato",
    "plum tomatoes",
    [
        (0, 0.0),
        (0.01, 0.002),
        (0.02, 0.014),
        (0.024, 0.035),
        (0.022, 0.055),
        (0.012, 0.068),
        (0, 0.068),
    ],
    0.09,
    {"red": {"tones": ("b8241a", "d8402a"), "gloss": ((0.008, 0.021, 0.045), 0.012, "ffc0a8")}},
    top=lambda look, kind, z: star(look, 0.017, z - 0.001, 0.007),
    lies=True,
    detail=(10, 9),
    wrinkle=0.18,
)

PEAR = Fruit(
    "pear",
    "pears",
    [
        (0, 0.005),
        (0.014, 0.0),
        (0.029, 0.011),
        (0.036, 0.031),
        (0.031, 0.052),
        (0.021, 0.07),
        (0.015, 0.084),
        (0.009, 0.093),
        (0, 0.092),
    ],
    0.18,
    {
        "green": {
            "tones": ("9fae3a", "c0c84c"),
            "freckle": ("7a6a2c", 300, 0.14),
            "blush": ("b8863a", 0.55, 0.75),
        },
        "yellow": {
            "tones": ("d8b83a", "ecd45c"),
            "freckle": ("9a7a2c", 300, 0.14),
            "blush": ("c8742c", 0.52, 0.7),
        },
        "red": {"tones": ("8a2a24", "b0483a"), "freckle": ("d8a060", 300, 0.13)},
    },
    lambda kind: faces.apple_core({"green": "#b0bc44", "red": "#9a342c"}.get(kind, "#e0c44a")),
    top=lambda look, kind, z: [stalk((0, 0, z - 0.001), 0.02, 0.0018, woody(look), 0.35)],
)

LEMON = Fruit(
    "lemon",
    "lemons",
    [
        (0, 0.0),
        (0.006, 0.003),
        (0.009, 0.009),
        (0.019, 0.019),
        (0.027, 0.033),
        (0.029, 0.046),
        (0.0265, 0.06),
        (0.018, 0.074),
        (0.009, 0.083),
        (0.006, 0.089),
        (0, 0.092),
    ],
    0.12,
    {
        "yellow": {
            "tones": ("e4be14", "f8dc30"),
            "freckle": ("d0a814", 380, 0.3),
            "gloss": ((0.008, 0.025, 0.055), 0.016, "fff8c8"),
        },
        "pale": {"tones": ("e8d43a", "f6e864"), "ends": [(2, 0.07, 0.092, "9aa83a")]},
    },
    lambda kind: faces.segments("#f0cc1c", "#fbf6dc", "#f2dc5a", "#faf0a0", 9),
    along=False,
    lies=True,
    detail=(12, 11),
    wrinkle=0.13,
    net="f0b81c",
)

PEACH = Fruit(
    "peach",
    "peaches",
    [
        (0, 0.006),
        (0.012, 0.001),
        (0.027, 0.011),
        (0.036, 0.032),
        (0.031, 0.053),
        (0.016, 0.064),
        (0.006, 0.061),
        (0, 0.055),
    ],
    0.15,
    {
        "peach": {
            "tones": ("f0a848", "f8c878"),
            "blush": ("d2483c", 0.42, 0.62),
        },
        "nectarine": {
            "tones": ("e0802c", "ee9c3a"),
            "blush": ("a81c24", 0.36, 0.55),
            "gloss": ((0.026, -0.01, 0.055), 0.015, "ffc8b0"),
        },
        "white": {"tones": ("f4dcb0", "f8e8cc"), "blush": ("d86a78", 0.46, 0.66)},
    },
    lambda kind: faces.stone_face("#d86a34", "#f8c050", "#d8582c"),
    top=lambda look, kind, z: [
        stalk((0, 0, z - 0.009), 0.008, 0.002, woody(look), 0.1),
        leaf(0.05, 0.015, green(look, "4a8a2c")).turn(rz=0.9).move(0.002, 0, z - 0.002),
    ],
    stone=peach_stone,
)

AVOCADO = Fruit(
    "avocado",
    "avocados",
    [
        (0, 0.0),
        (0.017, 0.003),
        (0.031, 0.018),
        (0.034, 0.036),
        (0.029, 0.058),
        (0.021, 0.076),
        (0.014, 0.089),
        (0, 0.096),
    ],
    0.2,
    {
        "green": {"tones": ("2c5a1c", "4a7a2c"), "freckle": ("90b050", 260, 0.36)},
        "dark": {"tones": ("2a2a1c", "3f3f2a"), "freckle": ("565a38", 260, 0.36)},
    },
    lambda kind: avocado_face(),
    top=lambda look, kind, z: [ellipsoid((0.004, 0.004, 0.003), (0, 0, z), 6, 4, woody(look))],
    lies=True,
    stone=avocado_pit,
    detail=(12, 10),
)


def avocado_face():
    image, d = faces.round_face("#3a5a1c", "#a8c24a")
    faces.disc(d, 0.76, "#e8e48c", 0.72)
    return image


MANGO = Fruit(
    "mango",
    "mangoes",
    [
        (0, 0.0),
        (0.016, 0.003),
        (0.034, 0.02),
        (0.042, 0.045),
        (0.041, 0.068),
        (0.032, 0.092),
        (0.018, 0.107),
        (0, 0.112),
    ],
    0.38,
    {
        "red": {
            "tones": ("d89a24", "f0b838"),
            "blush": ("c83a20", 0.44, 0.6),
            "ends": [(2, 0.055, 0.0, "6f9a34")],
            "freckle": ("f8e0a0", 180, 0.12),
        },
        "green": {
            "tones": ("5f8f2c", "86a83a"),
            "blush": ("c8481c", 0.52, 0.68),
            "freckle": ("d8dc90", 180, 0.12),
        },
        "yellow": {
            "tones": ("eeb424", "f8cc48"),
            "blush": ("f08a2c", 0.55, 0.75),
            "freckle": ("c8902c", 180, 0.1),
        },
    },
    lambda kind: faces.checked("#c8862a", "#f8a81c", "#d87c0c"),
    top=lambda look, kind, z: [stalk((0, 0, z - 0.002), 0.014, 0.003, woody(look), 0.3)],
    lies=True,
    bend=0.06,
    cut_at=-0.012,
)

KIWI = Fruit(
    "kiwi",
    "kiwis",
    [
        (0, 0.001),
        (0.008, 0.0),
        (0.018, 0.008),
        (0.0245, 0.024),
        (0.025, 0.036),
        (0.02, 0.054),
        (0.008, 0.065),
        (0, 0.066),
    ],
    0.09,
    {
        "green": {
            "tones": ("6a4a22", "8f6c3a"),
            "streak": ("4f3414", (420, 420, 60), 0.52, 0.6),
            "ends": [(2, 0.062, 0.066, "3a2410")],
        },
        "gold": {"tones": ("8a6a34", "a8884a"), "ends": [(2, 0.062, 0.066, "4a3214")]},
    },
    lambda kind: (
        faces.kiwi_face() if kind == "green" else faces.kiwi_face("#8a6a34", "#e8b82c", "#f4d464")
    ),
    along=False,
    top=lambda look, kind, z: [ellipsoid((0.005, 0.005, 0.003), (0, 0, z), 6, 4, woody(look))],
    lies=True,
    detail=(12, 9),
    tray="8cc63f",
)
