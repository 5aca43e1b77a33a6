"""Bottles of wine in the shapes they are sold in; each can break."""

from __future__ import annotations

from labels import groceries
from labels.hazards import front
from toolkit import labels
from toolkit.materials import label, plain
from toolkit.model import Maker, Model, box_piece, cylinder_piece
from toolkit.sampling import pick, seed_of, uniform

from makers.drinks import shiny
from makers.pack_parts import print_on
from makers.packs_glass import glass_model

WINES = {
    "bordeaux": [(0.6, 1.0), (0.645, 0.94), (0.685, 0.68), (0.73, 0.41), (0.8, 0.38)],
    "burgundy": [(0.4, 1.0), (0.5, 0.93), (0.6, 0.72), (0.69, 0.48), (0.8, 0.36)],
    "flute": [(0.42, 1.0), (0.55, 0.93), (0.68, 0.68), (0.78, 0.46), (0.85, 0.4)],
    "champagne": [(0.36, 1.0), (0.48, 0.95), (0.6, 0.72), (0.68, 0.48), (0.74, 0.36)],
}


def wine_print(name: str, word: str, paper: str, accent: str):
    """The label of a wine, three times round."""

    def one(d, cx, h):
        d.rectangle((cx - 118, 5, cx + 118, h - 6), outline=accent, width=6)
        labels.text(d, name, (cx - 100, h * 0.06, cx + 100, h * 0.27), "italic", accent)
        groceries.castle(d, cx, h * 0.41, h * 0.11, accent)
        labels.text(d, word.split()[0], (cx - 108, h * 0.55, cx + 108, h * 0.74), "bold", "#1c1c20")
        labels.text(d, word.split()[1], (cx - 108, h * 0.75, cx + 108, h * 0.94), "bold", "#1c1c20")

    image, d = labels.canvas(768, 256, paper)
    for cx in (128, 384, 640):
        one(d, cx, 256)
    return image


def wine_bottle(
    shape: str,
    height: float,
    radius: float,
    glass: str,
    word: str,
    name: str,
    paper: str,
    accent: str,
    spilled: str,
    seed: int,
) -> Model:
    """Bordeaux, burgundy, flute or champagne; a bocksbeutel is flat."""
    h, r = height, radius
    glassy = shiny(glass, h, 0.6)
    wrap, foil = label(wine_print(name, word, paper, accent)), plain(accent, 0.06, 90)
    low, high = (0.13, 0.38) if shape != "bordeaux" else (0.16, 0.48)
    if shape == "bocksbeutel":
        steps = [
            (0, 0.6, 0.55),
            (0.02, 0.72, 0.66),
            (0.2, 1, 0.95),
            (0.4, 1, 1),
            (0.56, 0.72, 0.74),
        ]
        steps += [(0.64, 0.4, 0.5), (0.7, 0.24, 0.42), (0.8, 0.22, 0.4), (0.97, 0.21, 0.39)]
        steps += [(0.972, 0.25, 0.46), (1.0, 0.24, 0.44)]
        sections = [(z * h, 0.55 * r * d, r * b, 2.0) for z, b, d in steps]
        which = [0] * 7 + [2] * 3

        def printed(mesh):
            art = front(name, word.split(), "#1c1c20", accent, paper)
            print_on(mesh, label(art, base=glass), 1.35 * r, 0.3 * h, 0.45, 0.16 * h)
            for i, f in enumerate(mesh.f):  # only where the paper is
                z = mesh.v[list(f)][:, 2].mean()
                if mesh.mi[i] == len(mesh.mats) - 1 and not 0.12 * h < z < 0.5 * h:
                    mesh.mi[i] = 0 if z < 0.7 * h else 2

        pieces = [
            box_piece((0, 0, 0.25 * h), (1.0 * r, 1.8 * r, 0.5 * h)),
            cylinder_piece(0.5 * r, 0.5 * h, 0.66 * h, 10, 0.24 * r),
            cylinder_piece(0.24 * r, 0.66 * h, h, 10),
        ]
    else:
        neck = WINES[shape][-1][1] * r
        body = [(0, 0.9 * r), (0.012, r), (low, r), (high, r)]
        steps = [*body, *((z, k * r) for z, k in WINES[shape])]
        wide = 1.5 if shape == "champagne" else 1.12
        top = 0.9 if shape == "champagne" else 0.962
        steps += [(top, neck * 0.95), (top + 0.004, neck * wide), (0.985, neck * wide)]
        steps += [(1.0, neck * (1.1 if shape == "champagne" else 1.0))]
        sections = [(z * h, q, q, 2.0) for z, q in steps]
        seal = 6 if shape in ("champagne", "burgundy") else 7
        which = [0, 0, 1] + [0] * (seal - 3) + [2] * (len(steps) - 1 - seal)
        printed = None
        shoulder, end = WINES[shape][0][0] * h, WINES[shape][-1][0] * h
        pieces = [
            cylinder_piece(r, 0, shoulder),
            cylinder_piece(r, shoulder, end, 10, neck),
            cylinder_piece(neck * 1.1, end, h, 8),
        ]
    mass = 1.6 if shape == "champagne" else 1.25
    mats = [glassy, wrap, foil]
    raw = "#b8cfa4" if spilled != "#e9dc9a" else "#dfe8c0"
    return glass_model(
        f"bottle of {word.lower()}",
        sections,
        which,
        mats,
        [],
        pieces,
        raw,
        spilled,
        mass,
        seed,
        printed=printed,
        spread=0.6 if shape == "bocksbeutel" else 1.0,
    )


def wine_bottle_random(rng) -> dict:
    height = uniform(rng, 0.29, 0.315)
    return {
        "shape": "bordeaux",
        "height": height,
        "radius": uniform(rng, 0.036, 0.039),
        "name": pick(rng, ["Castell", "Montegra", "Rebenhof"]),
        "seed": seed_of(rng) % 1000,
    }


RED = {
    "glass": "#1c2a1c",
    "word": "RED WINE",
    "paper": "#f3ead2",
    "accent": "#7a1326",
    "spilled": "#5a0c1e",
}

WHITE = {
    "glass": "#8f9f4a",
    "word": "WHITE WINE",
    "paper": "#f6f2e4",
    "accent": "#1f4f5a",
    "spilled": "#e9dc9a",
}

MODELS = {
    "wine_bottle": Maker(
        wine_bottle,
        wine_bottle_random,
        count=7,
        presets=[
            {**RED, "height": 0.3, "radius": 0.0375, "name": "Castell", "seed": 11},
            {**WHITE, "height": 0.3, "radius": 0.0375, "name": "Montegra", "seed": 11},
            {
                **RED,
                "shape": "burgundy",
                "height": 0.295,
                "radius": 0.043,
                "name": "Rebenhof",
                "accent": "#4a1a5a",
                "paper": "#fbf7ec",
            },
            {
                **WHITE,
                "shape": "flute",
                "height": 0.345,
                "radius": 0.0365,
                "name": "Rieslinghof",
                "glass": "#2f6a3a",
            },
            {
                "shape": "champagne",
                "height": 0.315,
                "radius": 0.0445,
                "name": "Belleval",
                "glass": "#1f3a1c",
                "word": "SPARKLING WINE",
                "paper": "#fbf4dc",
                "accent": "#c8a23a",
                "spilled": "#efe2ae",
            },
            {
                **WHITE,
                "shape": "bocksbeutel",
                "height": 0.225,
                "radius": 0.058,
                "name": "Frankenhof",
                "seed": 3,
                "glass": "#3f7a3a",
                "accent": "#a8242c",
            },
            {
                "height": 0.3,
                "radius": 0.0375,
                "seed": 11,
                "name": "Rosalba",
                "glass": "#e59a94",
                "word": "ROSE WINE",
                "paper": "#fff4f0",
                "accent": "#c0486a",
                "spilled": "#e8a09a",
            },
        ],
    ),
}
