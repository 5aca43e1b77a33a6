"""What peppers, cucumbers and carrots look like; `produce_forms.serve` makes models of them."""

from __future__ import annotations

import math

from toolkit.mesh import Mesh
from toolkit.shapes import lathe, tube

from makers import produce_faces as faces
from makers.produce_forms import Fruit
from makers.produce_kit import green, stalk


def pepper_top(look: str, kind: str, z: float) -> list[Mesh]:
    mat = green(look, "4f8a2c")
    crown = lathe(
        [(0, -0.003), (0.015, 0.003), (0.009, 0.007), (0, 0.009)],
        8,
        mat=mat,
        rib=lambda k, i: 1 - 0.3 * (i % 2) if k == 1 else 1,
    ).move(z=z - 0.008)
    return [crown, stalk((0, 0, z - 0.004), 0.024, 0.005, mat, 0.3, 6)]


PEPPER_SKINS = {
    "red": {"tones": ("a81a16", "cc2a20"), "gloss": ((0.036, 0.01, 0.06), 0.02, "ff9a8a")},
    "yellow": {"tones": ("e0a010", "f6c424"), "gloss": ((0.036, 0.01, 0.06), 0.02, "fff0a8")},
    # rotting it stays green: browned all over, dark on dark, it passes for another fruit
    "green": {"tones": ("256a1c", "3a8a2c"), "gloss": ((0.036, 0.01, 0.06), 0.02, "a8d890")}
    | {"brown": "7a5424", "amount": 0.15},
    "orange": {"tones": ("d86a10", "f0861c"), "gloss": ((0.036, 0.01, 0.06), 0.02, "ffd0a0")},
}
PEPPER = Fruit(
    "bell pepper",
    "bell peppers",
    [
        (0, 0.009),
        (0.012, 0.003),
        (0.023, 0.001),
        (0.033, 0.014),
        (0.038, 0.036),
        (0.041, 0.058),
        (0.037, 0.074),
        (0.024, 0.081),
        (0.011, 0.075),
        (0, 0.069),
    ],
    0.18,
    PEPPER_SKINS,
    lambda kind: faces.hollow(
        {"red": "#a81a16", "yellow": "#e8ac14", "green": "#2a6a20"}.get(kind, "#e07a18"),
        {"red": "#e8503c", "yellow": "#f8d860", "green": "#8ac060"}.get(kind, "#f8a850"),
        {"red": "#8a1810", "yellow": "#b8840c", "green": "#2f5a1c"}.get(kind, "#a8500c"),
    ),
    top=pepper_top,
    lobes=(4, 0.09, 0),
    detail=(16, 11),
    wrinkle=0.17,
)
PEPPER_LONG = Fruit(
    "pointed pepper",
    "pointed peppers",
    [
        (0, 0.0),
        (0.006, 0.008),
        (0.013, 0.04),
        (0.02, 0.09),
        (0.025, 0.135),
        (0.023, 0.152),
        (0.013, 0.16),
        (0, 0.157),
    ],
    0.11,
    {
        "red": {"tones": ("a81a16", "cc2a20"), "gloss": ((0.006, 0.018, 0.09), 0.02, "ff9a8a")},
        "yellow": {"tones": ("e0a010", "f6c424"), "gloss": ((0.006, 0.018, 0.09), 0.02, "fff0a8")},
    },
    top=lambda look, kind, z: pepper_top(look, kind, z + 0.004),
    lies=True,
    lobes=(3, 0.06, 0),
    bend=0.06,
    wrinkle=0.2,
)

CUCUMBER = Fruit(
    "cucumber",
    "cucumbers",
    [
        (0, 0.0),
        (0.01, 0.002),
        (0.016, 0.012),
        (0.0195, 0.04),
        (0.02, 0.08),
        (0.0195, 0.12),
        (0.015, 0.15),
        (0.008, 0.159),
        (0, 0.16),
    ],
    0.17,
    {
        "green": {
            "tones": ("1f4f1c", "336f28"),
            "streak": ("7aa84a", (110, 110, 14), 0.54, 0.68),
            "freckle": ("9ac06a", 130, 0.1),
            "ends": [(2, 0.13, 0.165, "a8b85a")],
        }
    },
    lambda kind: faces.seedy("#2a5f22", "#d8e8a8", "#c4dc8c", "#f2f4d0"),
    top=lambda look, kind, z: [stalk((0, 0, z - 0.001), 0.008, 0.003, green(look), 0.2)],
    lies=True,
    bend=0.03,
    detail=(11, 10),
    wrinkle=0.2,
)


def carrot_greens(look: str, kind: str, z: float) -> list[Mesh]:
    """Feathery leaves; short when the carrot is round."""
    mat = green(look, "4f9a2c")
    out = []
    reach = 0.075 if kind != "round" else 0.05
    for a, b in ((-0.5, 0.15), (0.45, 0.3), (0.0, -0.3), (0.15, 0.55)):
        sag = 0.0 if look == "fresh" else -0.012
        end = (reach * math.sin(a), reach * math.sin(b) * 0.5 + sag, z + reach * math.cos(a))
        middle = (end[0] * 0.45, end[1] * 0.45 + 0.004, z + (end[2] - z) * 0.5)
        out.append(
            tube([(0, 0, z - 0.004), middle, end], [0.002, 0.009, 0.003], 4, mat=mat, flatten=0.5)
        )
    return out


def carrot_stub(look: str, kind: str, z: float) -> list[Mesh]:
    """What is left of the leaves of a carrot that is sold without: it has not been cut."""
    mat = green(look, "4f9a2c")
    return [
        tube([(0, 0, z - 0.006), (x, y, z + 0.012)], [0.004, 0.003], 5, mat=mat)
        for x, y in ((-0.006, 0.002), (0.005, 0.004), (0.001, -0.006))
    ]


def carrot_fruit(name: str, outline, mass: float, top, **more) -> Fruit:
    return Fruit(
        name,
        "carrots",
        outline,
        mass,
        {
            "orange" if outline[-1][1] > 0.06 else "round": {
                "tones": ("e0701a", "f08a2c"),
                "streak": ("a84c10", (40, 40, 330), 0.56, 0.64),
                "ends": [
                    (2, max(z for _, z in outline) * 0.95, max(z for _, z in outline), "7a8a2c")
                ],
            }
        },
        lambda kind: faces.stone_free("#e0701a", "#f6983a", "#f8bc6a"),
        top=top,
        along=False,
        lies=True,
        wrinkle=0.2,
        **more,
    )


LONG_CARROT = [
    (0, 0.0),
    (0.003, 0.008),
    (0.007, 0.04),
    (0.011, 0.085),
    (0.0145, 0.13),
    (0.015, 0.146),
    (0.009, 0.153),
    (0, 0.151),
]
STOUT_CARROT = [
    (0, 0.0),
    (0.008, 0.003),
    (0.0155, 0.03),
    (0.019, 0.07),
    (0.021, 0.1),
    (0.0195, 0.108),
    (0.013, 0.114),
    (0, 0.116),
]
ROUND_CARROT = [
    (0, 0.0),
    (0.004, 0.004),
    (0.014, 0.012),
    (0.021, 0.026),
    (0.02, 0.04),
    (0.011, 0.049),
    (0, 0.047),
]
CARROT = carrot_fruit("carrot", LONG_CARROT, 0.07, carrot_greens, detail=(9, 8))
CARROT_BARE = carrot_fruit("carrot", STOUT_CARROT, 0.1, carrot_stub, detail=(12, 9))
CARROT_ROUND = carrot_fruit("round carrot", ROUND_CARROT, 0.03, carrot_greens, detail=(12, 9))
