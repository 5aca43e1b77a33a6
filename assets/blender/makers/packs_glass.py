"""Bottles of beer and whisky in the shapes they are sold in; each can break."""

from __future__ import annotations

from labels.hazards import front
from toolkit import labels
from toolkit.materials import Material, label, metal, plain, shade
from toolkit.model import Maker, Model, Part, box_piece, cylinder_piece
from toolkit.sampling import seed_of
from toolkit.shapes import box, lathe, tube

from makers.breakage import BROKEN
from makers.drinks import shiny
from makers.pack_parts import hollow, print_on, puddle, shards_of, vessel
from makers.spirits import amber


def glass_model(
    title: str,
    sections,
    which,
    mats: list[Material],
    closure: list,
    pieces: list,
    raw: str,
    spilled: str,
    mass: float,
    seed: int,
    n: int = 18,
    printed=None,
    spread: float = 1.0,
) -> Model:
    """The whole bottle, and its shards in a puddle. printed: puts a flat label on a mesh."""
    body, shell = vessel(sections, mats, which, n), hollow(sections, mats, which)
    for mesh in (body, shell):
        if printed:
            printed(mesh)
    widest, height = max(s[2] for s in sections), sections[-1][0]
    pool = puddle(1.7 * widest, spilled, seed)
    return Model(
        title=title,
        parts={
            "body": Part([body.weigh(1.2), *closure], collision=pieces),
            "shards": shards_of(shell, widest * spread, height, raw, seed),
            "spill": Part([pool], collision="none"),
        },
        mass=mass,
        friction=0.4,
        variants={"default": ["body"], "broken": ["shards", "spill"]},
        states=BROKEN,
    )


BEERS = {
    "longneck": [(0.5, 1.0), (0.58, 0.86), (0.66, 0.55), (0.75, 0.45), (0.95, 0.42)],
    "euro": [(0.6, 1.0), (0.68, 0.92), (0.76, 0.62), (0.86, 0.44), (0.95, 0.4)],
    "stubby": [(0.62, 1.0), (0.74, 0.9), (0.84, 0.6), (0.9, 0.46), (0.94, 0.45)],
    "swing": [(0.56, 1.0), (0.66, 0.93), (0.74, 0.66), (0.82, 0.5), (0.93, 0.44)],
}


def beer_bottle(
    shape: str,
    height: float,
    radius: float,
    glass: str,
    paper: str,
    accent: str,
    name: str,
    seed: int,
) -> Model:
    h, r = height, radius

    def one(d, cx, h):
        d.ellipse((cx - 122, h * 0.03, cx + 122, h * 0.97), fill=accent)
        d.ellipse((cx - 112, h * 0.08, cx + 112, h * 0.92), outline="#f4d35a", width=5)
        labels.text(d, name, (cx - 86, h * 0.14, cx + 86, h * 0.34), "italic", "#ffffff")
        labels.text(d, "BEER", (cx - 104, h * 0.36, cx + 104, h * 0.72), "bold", "#f4d35a")
        labels.text(d, "LAGER", (cx - 50, h * 0.74, cx + 50, h * 0.86), "bold", "#ffffff")

    image, d = labels.canvas(768, 256, paper)
    for cx in (128, 384, 640):
        one(d, cx, 256)
    steps = [(0, 0.9), (0.015, 1.0), (0.13, 1.0), (BEERS[shape][0][0] - 0.06, 1.0), *BEERS[shape]]
    steps += [(0.955, steps[-1][1] * 1.14), (0.98, steps[-1][1] * 1.1)]
    sections = [(z * h, k * r, k * r, 2.0) for z, k in steps]
    mouth = steps[-1][1] * r
    which = [0, 0, 1, 0, 0, 0, 2 if shape != "stubby" else 0]
    which += [2 if shape == "longneck" else 0] + [0] * (len(steps) - 1 - 8)
    z = 0.965 * h
    if shape == "swing":
        crown = lathe(
            [
                (0, z),
                (mouth * 1.02, z),
                (mouth, z + 0.016),
                (mouth * 0.6, z + 0.021),
                (0, z + 0.021),
            ],
            12,
            mat=plain("#f4f1ea", 0.03),
        )
        wire = metal("c6cacd", "868c91")
        closure = [crown]
        for s in (-1, 1):
            path = [
                (0.0, s * mouth * 0.9, z + 0.013),
                (0.012, s * mouth * 1.3, z - 0.004),
                (0.004, s * mouth * 1.15, z - 0.03),
                (mouth * 1.7, s * mouth * 0.9, z - 0.045),
            ]
            closure.append(tube(path, 0.0016, 4, mat=wire, weight=0.4))
        closure.append(box(0.004, 2 * mouth, 0.004, (mouth * 1.7, 0, z - 0.047), wire))
        closure.append(
            lathe(
                [(0, z - 0.004), (mouth * 1.15, z - 0.004), (mouth * 1.15, z), (0, z)],
                12,
                mat=plain("#c8322c", 0.03),
            )
        )
    else:
        gold = metal("d8b23a", "8a6a1c")
        crown = lathe(
            [
                (0, z),
                (mouth * 1.16, z),
                (mouth * 1.0, z + 0.0065),
                (mouth * 0.8, z + 0.008),
                (0, z + 0.008),
            ],
            14,
            mat=gold,
            rib=lambda k, i: 1 + 0.07 * (i % 2) if k == 1 else 1,
        )
        closure = [crown]
    shoulder = BEERS[shape][0][0] * h
    pieces = [
        cylinder_piece(r, 0, shoulder),
        cylinder_piece(r, shoulder, 0.86 * h, 10, mouth),
        cylinder_piece(mouth * 1.1, 0.86 * h, h * 0.975, 8),
    ]
    raw = "#c98f4a" if glass != "#1f4a24" else "#9fc49a"
    mats = [shiny(glass, h, 0.6), label(image), plain(accent, 0.05)]
    litres = 0.5 if r > 0.0325 else 0.33
    return glass_model(
        "beer bottle", sections, which, mats, closure, pieces, raw, "#e8c878", 0.4 + litres, seed
    )


def beer_bottle_random(rng) -> dict:
    return {"shape": "longneck", "height": 0.23, "radius": 0.0305, "seed": seed_of(rng) % 1000}


WHISKIES = {
    "square": (
        0.26,
        0.086,
        0.08,
        [
            (0, 0.93, 0.92),
            (0.02, 1, 1),
            (0.6, 1, 1),
            (0.67, 0.88, 0.9),
            (0.73, 0.45, 0.5),
            (0.77, 0.34, 0.36),
            (0.87, 0.31, 0.33),
        ],
        5.0,
    ),
    "round": (
        0.28,
        0.074,
        0.074,
        [
            (0, 0.93, 0.93),
            (0.02, 1, 1),
            (0.52, 1, 1),
            (0.6, 0.96, 0.96),
            (0.67, 0.72, 0.72),
            (0.73, 0.44, 0.44),
            (0.88, 0.38, 0.38),
        ],
        2.0,
    ),
    "flask": (
        0.2,
        0.09,
        0.042,
        [
            (0, 0.95, 0.85),
            (0.03, 1, 1),
            (0.35, 1.03, 1),
            (0.66, 1, 0.96),
            (0.76, 0.8, 0.9),
            (0.8, 0.34, 0.72),
            (0.88, 0.3, 0.64),
        ],
        3.0,
    ),
    "decanter": (
        0.23,
        0.1,
        0.1,
        [
            (0, 0.86, 0.86),
            (0.03, 1, 1),
            (0.3, 1.0, 1.0),
            (0.46, 0.86, 0.86),
            (0.58, 0.42, 0.42),
            (0.66, 0.3, 0.3),
            (0.8, 0.36, 0.36),
        ],
        3.6,
    ),
    "bell": (
        0.3,
        0.1,
        0.1,
        [
            (0, 0.95, 0.95),
            (0.02, 1, 1),
            (0.28, 0.96, 0.96),
            (0.46, 0.7, 0.7),
            (0.6, 0.42, 0.42),
            (0.7, 0.34, 0.34),
            (0.88, 0.3, 0.3),
        ],
        2.0,
    ),
}


def whisky_bottle(
    shape: str, drink: str, paper: str, ink: str, accent: str, lid: str, brand: str, seed: int
) -> Model:
    """A bottle of amber spirit."""
    h, width, depth, steps, power = WHISKIES[shape]
    sections = [
        (z * h, depth / 2 * d, width / 2 * w, power if z < 0.7 else 2.0) for z, w, d in steps
    ]
    glassy = amber(drink, 0.88 * h)
    which = [0] * (len(steps) - 1)
    mats: list[Material] = [glassy]
    printed = None
    if shape in ("round", "bell"):
        art, d = labels.canvas(768, 256, paper)
        for cx in (128, 384, 640):
            labels.text(d, brand, (cx - 108, 14, cx + 108, 84), "serif", accent)
            d.rectangle((cx - 100, 94, cx + 100, 102), fill=accent)
            labels.text(d, "WHISKY", (cx - 118, 112, cx + 118, 206), "bold", ink)
            labels.text(d, "12 YEARS", (cx - 70, 212, cx + 70, 246), "bold", accent)
        mats.append(label(art))
        which[1] = 1
    else:
        z0, tall = 0.1 * h, (0.3 if shape == "decanter" else 0.46) * h

        def printed(mesh):
            art = label(front(brand, ["WHISKY"], ink, accent, paper), base=drink)
            print_on(mesh, art, width * 0.9, tall, 0.5, z0)
            for i, f in enumerate(mesh.f):
                if mesh.mi[i] == len(mesh.mats) - 1:
                    z = mesh.v[list(f)][:, 2].mean()
                    if not 0.03 * h < z < 0.62 * h:
                        mesh.mi[i] = 0

    neck = steps[-1][1] * width / 2
    z = 0.84 * h if shape != "decanter" else 0.79 * h
    q = neck * 1.12
    if shape == "decanter":
        stopper = [(0, z), (neck * 0.8, z), (neck * 0.8, z + 0.006), (0.024, z + 0.018)]
        stopper += [(0.026, z + 0.034), (0.012, h), (0, h)]
        closure = [lathe(stopper, 8, mat=metal("e8d8b0", "a07c3a")).flat()]
    else:
        top = [(0, z), (q, z), (q, 0.975 * h), (q * 0.88, h), (0, h)]
        closure = [lathe(top, 14, mat=plain(lid, 0.03))]
    shoulder = steps[4][0] * h
    pieces = [
        box_piece((0, 0, shoulder / 2), (depth * 0.95, width * 0.95, shoulder)),
        cylinder_piece(min(depth, width) * 0.4, shoulder, 0.86 * h, 10, q),
        cylinder_piece(q, 0.86 * h, h, 10),
    ]
    if shape == "bell":  # it narrows from low down
        half = width / 2
        pieces[:2] = [
            cylinder_piece(half, 0, 0.28 * h, 12),
            cylinder_piece(half, 0.28 * h, 0.6 * h, 12, 0.42 * half),
            cylinder_piece(0.4 * half, 0.6 * h, 0.86 * h, 10, q),
        ]
    return glass_model(
        "bottle of whisky",
        sections,
        which,
        mats,
        closure,
        pieces,
        "#efe2c4",
        shade(drink, 1.05),
        1.15 if shape != "flask" else 0.6,
        seed,
        n=20,
        printed=printed,
    )


def whisky_bottle_random(rng) -> dict:
    return {"shape": "square", "seed": seed_of(rng) % 1000}


HERON = {
    "drink": "#b8620f",
    "paper": "#1c1c20",
    "ink": "#f4ecd8",
    "accent": "#d8b45a",
    "lid": "#1c1c20",
    "brand": "OLD HERON",
}

TORVIE = {
    "drink": "#c8781a",
    "paper": "#f4ead0",
    "ink": "#5a1a14",
    "accent": "#8a1a1a",
    "lid": "#8a1a1a",
    "brand": "Glen Torvie",
}

MOORE = {
    "drink": "#a8540c",
    "paper": "#e8dcb4",
    "ink": "#1f3a24",
    "accent": "#1f4a2c",
    "lid": "#c8a24a",
    "brand": "Moorhall",
}

BROWN, GREEN = "#5a2c0e", "#1f4a24"

MODELS = {
    "beer_bottle": Maker(
        beer_bottle,
        beer_bottle_random,
        count=7,
        presets=[
            {
                "glass": BROWN,
                "paper": "#f0e2b8",
                "accent": "#1f5a2c",
                "name": "Dorfbräu",
                "seed": 5,
            },
            {
                "glass": GREEN,
                "paper": "#f0e2b8",
                "accent": "#a3202c",
                "name": "Nordstern",
                "seed": 5,
            },
            {
                "shape": "euro",
                "height": 0.26,
                "radius": 0.034,
                "glass": BROWN,
                "paper": "#ffffff",
                "accent": "#1f4f9c",
                "name": "Hafenbräu",
            },
            {
                "shape": "stubby",
                "height": 0.19,
                "radius": 0.036,
                "glass": BROWN,
                "paper": "#f6e6b0",
                "accent": "#8a1a14",
                "name": "Steinbock",
                "seed": 7,
            },
            {
                "shape": "swing",
                "height": 0.262,
                "radius": 0.0345,
                "glass": GREEN,
                "paper": "#f4ead0",
                "accent": "#14301c",
                "name": "Klosterhof",
            },
            {
                "glass": "#e0b45a",
                "paper": "#ffffff",
                "accent": "#c89a1c",
                "name": "Solara",
                "seed": 5,
            },
            {
                "shape": "stubby",
                "height": 0.19,
                "radius": 0.036,
                "glass": GREEN,
                "paper": "#ffffff",
                "accent": "#1f5a2c",
                "name": "Waldquell",
                "seed": 7,
            },
        ],
    ),
    "whisky_bottle": Maker(
        whisky_bottle,
        whisky_bottle_random,
        count=6,
        presets=[
            {**HERON, "seed": 21},
            {**TORVIE, "shape": "round"},
            {**MOORE, "shape": "flask"},
            {**TORVIE, "shape": "decanter", "brand": "Kilbrae"},
            {**MOORE, "shape": "bell", "brand": "Ardwyn"},
            {
                **TORVIE,
                "seed": 21,
                "brand": "Brannoch",
                "paper": "#1f3a6a",
                "ink": "#ffffff",
                "accent": "#e8c45a",
            },
        ],
    ),
}
