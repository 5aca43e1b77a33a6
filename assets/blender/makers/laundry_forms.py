"""Laundry detergent, dishwasher tablets, laundry pods and scouring powder in many packages.

Colours of a form: "body paper band ink lid accent".
"""

from __future__ import annotations

import math

from labels.hazards import cleaner_front
from toolkit.labels import canvas
from toolkit.materials import label as printed
from toolkit.materials import plain, shade
from toolkit.mesh import Mesh
from toolkit.model import Model, Part, cylinder_piece
from toolkit.shapes import box, ellipsoid, lathe

from makers import poisons
from makers.choking import loose
from makers.cleaner_forms import FORM, maker
from makers.poisons import pod
from makers.projection import project_label
from makers.vessels import Bottle, bottle, can, carton, pouch, steps, wrapped

DETERGENTS = {
    "round": Bottle(
        0.1,
        0.1,
        steps("0 .94 .94, .005 1 1, .19 1 1, .215 .88 .88, .235 .62 .62, .245 .58 .58"),
        (0.098, 0.082, 0.17),
        ("smooth", 0.034, 0.24, 0.062),
        2.0,
        20,
    ),
    "big": Bottle(
        0.24,
        0.15,
        steps(
            "0 0.95 0.93, 0.006 1 1, 0.21 1 1, 0.24 0.92 0.94, 0.262 0.6 0.7, "
            "0.275 0.34 0.5, 0.285 0.3 0.46"
        ),
        (0.11, 0.205, 0.19),
        ("cap", 0.036, 0.28, 0.05),
        5.0,
        22,
        ((0.016, ((0.0, 0.262), (0.045, 0.285), (0.1, 0.275), (0.112, 0.215), (0.105, 0.17))),),
        -0.05,
    ),
}
SCOURING = {
    "flat": Bottle(
        0.078,
        0.05,
        steps("0 .93 .9, .004 1 1, .15 1 1, .17 .94 .94, .186 .8 .8, .19 .72 .72"),
        (0.078, 0.068, 0.138),
        ("smooth", 0.021, 0.188, 0.03),
        3.4,
    ),
}


def tablet_meshes(colour: str) -> list[Mesh]:
    """One tablet, lying: white below, coloured above, a red ball pressed in."""
    low = box(0.038, 0.028, 0.009, (0, 0, 0), plain("#f4f6fa", 0.08, 400), 0.0015)
    top = box(0.038, 0.028, 0.009, (0, 0, 0.009), plain(colour, 0.08, 400), 0.003)
    ball = ellipsoid((0.009, 0.009, 0.006), (0, 0, 0.0175), 10, 5, plain("#d8202c", 0.04))
    return [low, top, ball]


def detergent_form(shape: str, brand: str, colours: str) -> Model:
    """Laundry detergent: a jug ("classic"), a big jug, a round bottle, powder, a refill pouch."""
    body, paper, band, ink, lid, accent = colours.split()
    if shape == "classic":
        return poisons.laundry_detergent(0.29450148197, body, paper, band, ink, lid, brand)
    words = ["LAUNDRY", "DETERGENT"]
    if shape == "powder":
        words = ["WASHING", "POWDER"]
    wide = (256, 340) if shape in ("round", "pouch") else (300, 300)
    picture = cleaner_front(brand, words, paper, band, ink, "shirt", "!", wide)
    if shape == "powder":
        return carton("box of washing powder", (0.11, 0.19, 0.24), picture, body, "handle", 2.6)
    if shape == "pouch":
        return pouch("refill pouch of detergent", 0.18, 0.26, 0.09, picture, body, 1.5, lid)
    mass = {"round": 1.4, "big": 3.3}[shape]
    return bottle("laundry detergent", DETERGENTS[shape], picture, body, lid, accent, mass)


def tablets_form(shape: str, brand: str, colours: str) -> Model:
    """Dishwasher tablets: a carton or a pouch, a tub, an open carton, loose ones."""
    body, paper, band, ink, lid, accent = colours.split()
    if shape in ("carton", "pouch"):
        return poisons.dishwasher_tablets(shape, paper, band, ink, brand)
    if shape == "loose":
        pieces = []
        for x, y, turn in ((0, -0.03, 0.3), (0.018, 0.02, 1.2), (-0.04, 0.004, 2.4)):
            pieces.append([m.turn(rz=turn).move(x, y) for m in tablet_meshes(accent)])
        pile = [m.turn(rx=0.08, rz=0.7).move(-0.008, -0.008, 0.0225) for m in tablet_meshes(accent)]
        return loose("loose dishwasher tablets", [*pieces, pile], 0.09)
    words = ["DISHWASHER", "TABLETS"]
    if shape == "tub":
        picture = cleaner_front(brand, words, paper, band, ink, "tablet", "!", (256, 230))
        return can("tub of dishwasher tablets", 0.068, 0.16, picture, body, lid, "lid", 0.9)
    picture = cleaner_front(brand, words, paper, band, ink, "tablet", "!", (300, 260))
    inside = []
    for k, (x, y, turn) in enumerate(
        ((-0.01, -0.045, 0.2), (0.012, 0.0, 1.2), (-0.008, 0.046, 0.5))
    ):
        inside += [
            m.turn(rx=0.15 * (k - 1), rz=turn).move(x, y, 0.0) for m in tablet_meshes(accent)
        ]
    size = (0.085, 0.165, 0.13)
    return carton("open box of dishwasher tablets", size, picture, body, "open", 0.7, inside)


def heap_of_pods(places, first: str, second: str) -> list[list[Mesh]]:
    """Pods lying about: (x, y, z, turn) each."""
    return [
        [pod(0.041, first, second).keep_pattern().turn(rz=turn).move(x, y, z)]
        for x, y, z, turn in places
    ]


def pods_form(shape: str, brand: str, colours: str) -> Model:
    """Laundry pods: loose, one alone, tubs shut and open, a pouch, a round canister, a box.

    Colours: "first second body lid paper ink".
    """
    first, second, body, lid, paper, ink = colours.split()
    if shape in ("loose", "shut", "open"):
        return poisons.laundry_pods(shape, first, second, body, lid, brand, paper)
    if shape == "single":
        return loose("laundry pod", heap_of_pods([(0, 0, 0, 0.3)], first, second), 0.025, size=128)
    words = ["LAUNDRY", "PODS"]
    if shape == "pouch":
        picture = cleaner_front(brand, words, paper, first, ink, "pod", "!")
        return pouch("pouch of laundry pods", 0.19, 0.225, 0.1, picture, body, 0.75)
    picture = cleaner_front(brand, words, paper, first, ink, "pod", "!", (256, 230))
    if shape == "drum":
        return can("tub of laundry pods", 0.075, 0.19, picture, body, lid, "lid", 0.9)
    picture = cleaner_front(brand, words, paper, first, ink, "pod", "!", (300, 210))
    inside = [
        pod(0.044, first, second).keep_pattern().turn(rz=turn).move(x, y)
        for x, y, turn in ((-0.004, -0.05, 0.2), (0.008, 0.002, 0.9), (-0.006, 0.052, 0.4))
    ]
    size = (0.1, 0.18, 0.115)
    return carton("open box of laundry pods", size, picture, body, "open", 0.8, inside)


def scouring_form(shape: str, brand: str, colours: str) -> Model:
    """Scouring powder: a tall canister, a flat bottle, a squat tin, a carton, a bag."""
    body, paper, band, ink, lid, accent = colours.split()
    if shape == "classic":
        return poisons.scouring_powder(0.22418682542, 0.03410181522, paper, band, ink, lid, brand)
    words = ["SCOURING", "POWDER"]
    if shape == "flat":
        picture = cleaner_front(brand, words, paper, band, ink, "star", "!")
        return bottle("scouring powder", SCOURING["flat"], picture, body, lid, accent, 0.6)
    if shape == "box":
        picture = cleaner_front(brand, words, paper, band, ink, "star", "!")
        return carton("box of scouring powder", (0.055, 0.115, 0.17), picture, body, "flat", 0.7)
    if shape == "bag":
        picture = cleaner_front(brand, words, paper, band, ink, "star", "!")
        return pouch("bag of scouring powder", 0.13, 0.19, 0.06, picture, body, 0.5)
    return shaker(brand, paper, band, ink, lid)


def shaker(brand: str, paper: str, band: str, ink: str, lid: str) -> Model:
    """A squat tin with a domed sprinkler top, its holes showing."""
    r, h = 0.047, 0.155
    front = cleaner_front(brand, ["SCOURING", "POWDER"], paper, band, ink, "star", "!", (256, 270))
    top_picture, draw = canvas(128, 128, lid)
    for n, away in ((1, 0.0), (6, 20.0), (12, 40.0)):
        for i in range(n):
            x = 64 + away * math.cos(math.tau * i / n)
            y = 64 + away * math.sin(math.tau * i / n)
            draw.ellipse((x - 6, y - 6, x + 6, y + 6), fill="#2a2a2e")
    paint = plain(lid, 0.03)
    profile = [(0, 0), (r, 0), (r, 0.005), (r * 0.985, 0.006), (r * 0.985, h - 0.03)]
    profile += [(r * 1.02, h - 0.029), (r * 1.02, h - 0.022), (r * 0.9, h - 0.014)]
    profile += [(r * 0.74, h - 0.005), (r * 0.62, h), (0, h + 0.003)]
    tin = lathe(
        profile,
        22,
        mats=[plain(shade(paper, 0.8), 0.03), printed(wrapped(front, paper, 3)), paint],
        mat_of_segment=[0, 0, 0, 1, 2, 2, 2, 2, 2, 2],
        label_z=(0.006, h - 0.03),
        start=-math.pi,
        weight=1.3,
    )
    across = 1.75 * r
    project_label(tin, printed(top_picture), "+z", (0, 0), (across, across), 0.6)
    pieces = [cylinder_piece(r, 0, h - 0.02, 14), cylinder_piece(r, h - 0.02, h, 12, 0.6 * r)]
    return Model("scouring powder", {"body": Part([tin], collision=pieces)}, mass=0.7, friction=0.5)


MODELS = {
    "laundry_detergent": maker(
        detergent_form,
        FORM,
        [
            ("classic", "WELLENA", "#1f55b8 #ffffff #e8641c #1f3f8c #e8641c #e8641c"),
            ("classic", "Frisko", "#e8641c #fff6c8 #1c3f9a #b01820 #1c3f9a #1c3f9a"),
            ("classic", "LINEO", "#6a3fa8 #ffffff #2f9a5a #4a1f80 #f2f2f2 #f2f2f2"),
            ("powder", "WELLENA", "#1f9a5a #ffffff #c8202c #0c5a34 #f2f2f2 #f2f2f2"),
            ("round", "LINEO", "#f4f4f2 #f4f4f2 #b02080 #7a1058 #e83a9a #e83a9a"),
            ("big", "Frisko", "#c8202c #ffffff #1c3f9a #b01820 #f2c52a #f2c52a"),
            ("pouch", "WELLENA", "#3aa0d8 #ffffff #1f55b8 #1f3f8c #1f55b8 #1f55b8"),
            ("powder", "Frisko", "#e8641c #fff6c8 #1c3f9a #b01820 #f2f2f2 #f2f2f2"),
        ],
    ),
    "dishwasher_tablets": maker(
        tablets_form,
        FORM,
        [
            ("carton", "TABBO", "#f4f8fc #f4f8fc #1f4fa8 #c8161e #1f4fa8 #1f4fa8"),
            ("pouch", "Glintz", "#127a4a #f2c52a #127a4a #0c3a5c #127a4a #127a4a"),
            ("tub", "SPÜLFIX", "#ffffff #ffffff #c8202c #143a8c #1f5fd0 #1f5fd0"),
            ("open", "TABBO", "#2f8fd8 #ffffff #143a8c #c8161e #1f4fa8 #2f7fe0"),
            ("loose", "", "#ffffff #ffffff #ffffff #ffffff #ffffff #2f7fe0"),
            ("pouch", "SPÜLFIX", "#b02060 #ffffff #b02060 #143a8c #b02060 #b02060"),
            ("carton", "Glintz", "#f2c52a #f2c52a #c8202c #143a8c #c8202c #c8202c"),
        ],
    ),
    "laundry_pods": maker(
        pods_form,
        FORM,
        [
            ("loose", "LINEO", "#1f5fd0 #f07a1c #ffffff #ffffff #ffffff #1c1c30"),
            ("shut", "LINEO", "#7b2fb5 #2fb070 #e8641c #7b2fb5 #ffffff #1c1c30"),
            ("open", "Frisko", "#1f5fd0 #2fb070 #f2c52a #ffffff #ffffff #1c1c30"),
            ("pouch", "WELLENA", "#1f5fd0 #e83a9a #3aa0d8 #ffffff #ffffff #1c1c30"),
            ("drum", "Frisko", "#c8202c #f2c52a #ffffff #c8202c #ffffff #143a8c"),
            ("box", "LINEO", "#7b2fb5 #2fb0d0 #2f9a5a #ffffff #ffffff #1c1c30"),
            ("loose", "WELLENA", "#7b2fb5 #2fb070 #ffffff #ffffff #ffffff #1c1c30"),
        ],
    ),
    "scouring_powder": maker(
        scouring_form,
        FORM,
        [
            ("classic", "SCOURA", "#c9cdd1 #2f9a48 #c8161e #ffffff #f2c52a #f2c52a"),
            ("classic", "SCOURA", "#c9cdd1 #1f5fb0 #f08a1c #ffffff #c8161e #c8161e"),
            ("flat", "BLITZAN", "#f4f4f0 #f4f4f0 #2f9a48 #14622a #2f9a48 #2f9a48"),
            ("squat", "BLITZAN", "#f2c52a #f2c52a #c8161e #8a1010 #c8161e #c8161e"),
            ("box", "SCOURA", "#2f7fd8 #ffffff #c8161e #143a8c #f2f2f2 #f2f2f2"),
            ("bag", "BLITZAN", "#e8641c #fff6c8 #1c3f9a #1c3f9a #f2f2f2 #f2f2f2"),
            ("squat", "SCOURA", "#1f5fb0 #1f5fb0 #f2c52a #ffffff #f4f4f0 #f4f4f0"),
        ],
    ),
}
