"""Cleaners in the forms shops sell: sprays, bleach, washing-up liquid, drain and toilet cleaner.

Colours of a form: "body paper band ink lid accent".
"""

from __future__ import annotations

import numpy as np
from labels.hazards import cleaner_front
from toolkit.materials import plain
from toolkit.model import Maker, Model
from toolkit.sampling import pick

from makers import cleaning, poisons
from makers.vessels import Bottle, bottle, can, pouch, steps

MOTIF_OF = {
    "GLASS CLEANER": ("window", "!"),
    "BATH CLEANER": ("drop", "!"),
    "FLOOR CLEANER": ("drop", "!"),
    "KITCHEN CLEANER": ("star", "!"),
    "OVEN CLEANER": ("oven", "corrosive"),
}

SPRAYS = {
    "round": Bottle(
        0.078,
        0.078,
        steps(
            "0 0.94 0.94, 0.004 1 1, 0.15 1 1, 0.172 0.86 0.86, "
            "0.19 0.5 0.5, 0.2 0.38 0.38, 0.225 0.36 0.36"
        ),
        (0.078, 0.064, 0.136),
        ("trigger", 0.0175, 0.225, 0),
        2.0,
    ),
    "jug": Bottle(
        0.125,
        0.075,
        steps(
            "0 0.94 0.92, 0.005 1 1, 0.11 1 1, 0.13 0.8 0.86, 0.15 0.52 0.66, "
            "0.175 0.44 0.6, 0.195 0.5 0.6, 0.21 0.3 0.46, 0.225 0.28 0.44"
        ),
        (0.058, 0.112, 0.1),
        ("trigger", 0.0185, 0.225, 0),
        4.5,
        20,
    ),
    "squat": Bottle(
        0.088,
        0.088,
        steps("0 0.93 0.93, 0.004 1 1, 0.1 1 1, 0.115 0.84 0.84, 0.128 0.42 0.42, 0.145 0.38 0.38"),
        (0.052, 0.08, 0.09),
        ("trigger", 0.0185, 0.145, 0),
        5,
        20,
    ),
}
BLEACHES = {
    "jug": Bottle(
        0.142,
        0.142,
        steps(
            "0 0.93 0.93, 0.006 1 1, 0.17 1 1, 0.2 0.88 0.88, 0.24 0.62 0.62, "
            "0.275 0.32 0.32, 0.285 0.29 0.29"
        ),
        (0.088, 0.126, 0.15),
        ("cap", 0.024, 0.278, 0.034),
        4.5,
        20,
        ((0.0135, ((0.016, 0.268), (0.052, 0.27), (0.074, 0.24), (0.076, 0.18), (0.066, 0.15))),),
    ),
    "round": Bottle(
        0.104,
        0.104,
        steps("0 0.94 0.94, 0.005 1 1, 0.16 1 1, 0.185 0.88 0.88, 0.21 0.6 0.6, 0.235 0.36 0.36"),
        (0.084, 0.084, 0.148),
        ("smooth", 0.023, 0.232, 0.045),
        2.0,
    ),
    "canister": Bottle(
        0.19,
        0.13,
        steps("0 0.95 0.94, 0.006 1 1, 0.235 1 1, 0.255 0.9 0.86, 0.262 0.55 0.5"),
        (0.118, 0.17, 0.2),
        ("cap", 0.028, 0.258, 0.036),
        7,
        24,
        ((0.014, ((-0.075, 0.25), (-0.07, 0.288), (-0.02, 0.298), (0.03, 0.288), (0.034, 0.25))),),
        0.062,
    ),
}
DISH_SOAPS = {
    "round": Bottle(
        0.068,
        0.068,
        steps(
            "0 0.92 0.92, 0.004 1 1, 0.14 1 1, 0.165 0.92 0.92, "
            "0.185 0.66 0.66, 0.196 0.44 0.44, 0.2 0.44 0.44"
        ),
        (0.074, 0.056, 0.132),
        ("pull", 0.0165, 0.198, 0.05),
        2.0,
    ),
    "inverted": Bottle(
        0.088,
        0.054,
        steps(
            "0 0.62 0.8, 0.032 0.64 0.82, 0.036 0.78 0.9, 0.06 0.94 0.98, 0.1 1 1, "
            "0.14 0.96 0.96, 0.165 0.8 0.84, 0.18 0.4 0.5"
        ),
        (0.098, 0.078, 0.115),
        ("smooth", 0.0005, 0.1795, 0.0005),
        2.8,
    ),
    "pump": Bottle(
        0.088,
        0.066,
        steps("0 0.92 0.92, 0.004 1 1, 0.115 1 1, 0.132 0.86 0.88, 0.145 0.4 0.5, 0.152 0.36 0.48"),
        (0.06, 0.08, 0.105),
        ("pump", 0.0165, 0.15, 0),
        4.0,
        20,
    ),
}
DRAINS = {
    "handled": Bottle(
        0.145,
        0.088,
        steps("0 0.92 0.9, 0.005 1 1, 0.105 1 1, 0.13 0.84 0.9, 0.155 0.5 0.66, 0.178 0.26 0.4"),
        (0.056, 0.13, 0.1),
        ("cap", 0.021, 0.172, 0.038),
        3.4,
        20,
        ((0.0105, ((0.016, 0.168), (0.052, 0.174), (0.068, 0.15), (0.068, 0.12), (0.058, 0.1))),),
    ),
    "slim": Bottle(
        0.066,
        0.066,
        steps(
            "0 0.93 0.93, 0.004 1 1, 0.15 1 1, 0.18 0.82 0.82, "
            "0.215 0.5 0.5, 0.25 0.4 0.4, 0.27 0.4 0.4"
        ),
        (0.078, 0.056, 0.138),
        ("nozzle", 0.017, 0.262, 0.055),
        2.0,
    ),
}
TOILETS = {
    "slim": Bottle(
        0.07,
        0.052,
        steps("0 0.9 0.9, 0.005 1 1, 0.16 0.96 0.98, 0.185 0.8 0.88, 0.2 0.6 0.72, 0.212 0.46 0.6"),
        (0.086, 0.064, 0.15),
        ("duck", 0.0145, 0.206, 0.075),
        2.6,
    ),
    "wide": Bottle(
        0.12,
        0.062,
        steps("0 0.9 0.88, 0.005 1 1, 0.115 1 1, 0.145 0.84 0.9, 0.17 0.5 0.66, 0.185 0.3 0.5"),
        (0.063, 0.108, 0.108),
        ("duck", 0.0165, 0.178, 0.07),
        3.2,
        20,
        ((0.009, ((-0.012, 0.178), (-0.044, 0.178), (-0.058, 0.15), (-0.052, 0.115))),),
    ),
    "straight": Bottle(
        0.11,
        0.072,
        steps("0 0.92 0.9, 0.005 1 1, 0.115 1 1, 0.14 0.8 0.86, 0.158 0.44 0.6, 0.168 0.32 0.48"),
        (0.061, 0.1, 0.105),
        ("nozzle", 0.0175, 0.163, 0.085),
        3.2,
    ),
}


def spray_form(shape: str, words: str, brand: str, colours: str) -> Model:
    """A trigger bottle or an aerosol can of cleaner; "classic": the one with a waist."""
    body, paper, band, ink, lid, accent = colours.split()
    if shape == "classic":
        return cleaning.spray_cleaner(
            height=0.2687303395455654,
            width=0.09862518973354627,
            body=body,
            paper=paper,
            band=band,
            accent=accent,
            ink=ink,
            head=lid,
            trigger=accent if accent != paper else band,
            brand=brand,
            kind=words,
        )
    motif, sign = MOTIF_OF[words]
    picture = cleaner_front(brand, words.split(), paper, band, ink, motif, sign)
    title = f"{words.lower()} spray"
    if shape == "aerosol":
        return can(title, 0.033, 0.265, picture, body, lid, "button", 0.45)
    return bottle(title, SPRAYS[shape], picture, body, lid, accent, 0.75)


def bleach_form(shape: str, brand: str, colours: str) -> Model:
    """Bleach: a slim handled bottle ("classic"), a big jug, a round bottle or a canister."""
    body, paper, band, ink, lid, accent = colours.split()
    if shape == "classic":
        return cleaning.bleach_bottle(0.28756359834410816, body, band, ink, lid, brand)
    size = (256, 340) if shape == "round" else (300, 310)
    picture = cleaner_front(brand, ["BLEACH"], paper, band, ink, "drop", "corrosive", size)
    mass = {"jug": 2.1, "round": 1.1, "canister": 2.9}[shape]
    return bottle("bottle of bleach", BLEACHES[shape], picture, body, lid, accent, mass)


def dish_soap_form(shape: str, brand: str, colours: str) -> Model:
    """Washing-up liquid: waisted ("classic"), round, standing on its cap, or with a pump."""
    body, paper, band, ink, lid, accent = colours.split()
    if shape == "classic":
        return cleaning.dish_soap(0.22687934113138353, body, band, accent, lid, brand)
    picture = cleaner_front(brand, ["DISH", "SOAP"], paper, band, ink, "plate", "")
    made = bottle("washing-up liquid", DISH_SOAPS[shape], picture, body, lid, accent, 0.6)
    if shape == "inverted":  # it stands on its cap: the foot wears the cap's colour
        shell = made.parts["body"].meshes[0]
        shell.mats.append(plain(lid, 0.03))
        for i, face in enumerate(shell.f):
            if shell.v[list(face)][:, 2].mean() < 0.033:
                shell.mi[i] = len(shell.mats) - 1
    return made


def drain_form(shape: str, brand: str, colours: str) -> Model:
    """Drain cleaner: a flat gel bottle, granules, a handled bottle, a long spout, a bag, a tub."""
    body, paper, band, ink, lid, accent = colours.split()
    if shape in ("gel", "granules"):
        height = 0.27072834166255955 if shape == "gel" else 0.26226713838671695
        return poisons.drain_cleaner(height, body, paper, band, ink, lid, brand, shape)
    words = ["DRAIN", "CLEANER"]
    if shape == "tub":
        picture = cleaner_front(brand, words, paper, band, ink, "pipe", "corrosive", (256, 260))
        return can("drain cleaner crystals", 0.056, 0.15, picture, body, lid, "screw", 1.1)
    picture = cleaner_front(brand, words, paper, band, ink, "pipe")
    if shape == "bag":
        return pouch("bag of drain cleaner", 0.145, 0.205, 0.06, picture, body, 0.6)
    return bottle("drain cleaner", DRAINS[shape], picture, body, lid, accent, 1.1)


def toilet_form(shape: str, brand: str, colours: str) -> Model:
    """Toilet cleaner: necks bent over ("classic", "slim", "wide") or a straight nozzle."""
    body, paper, band, ink, lid, accent = colours.split()
    if shape == "classic":
        return poisons.toilet_cleaner(0.2713190917617109, body, paper, band, ink, lid, brand)
    picture = cleaner_front(brand, ["TOILET", "CLEANER"], paper, band, ink, "toilet")
    return bottle("toilet cleaner", TOILETS[shape], picture, body, lid, accent, 0.85)


def insect_spray(shape: str, words: str, brand: str, colours: str) -> Model:
    """Poison against insects: aerosol cans, a trigger bottle or a small pump bottle."""
    body, paper, band, ink, lid, accent = colours.split()
    picture = cleaner_front(brand, words.split(), paper, band, ink, "insect", "flame")
    title = f"{words.lower()}"
    if shape == "tall":
        return can(title, 0.0325, 0.27, picture, body, lid, "overcap", 0.42)
    if shape == "short":
        return can(title, 0.031, 0.19, picture, body, lid, "overcap", 0.28)
    if shape == "button":
        return can(title, 0.035, 0.235, picture, body, lid, "button", 0.42)
    if shape == "fogger":
        return can(title, 0.045, 0.15, picture, body, lid, "button", 0.35)
    return bottle(title, SPRAYS[shape], picture, body, lid, accent, 0.8)


def one_of(presets: list[dict]):
    """A sampler that draws one of the presets whole."""

    def sample(rng: np.random.Generator) -> dict:
        return dict(pick(rng, presets))

    return sample


def maker(make, keys: tuple[str, ...], rows: list[tuple[str, ...]]) -> Maker:
    """A Maker from a table of parameters, one row a model."""
    presets = [dict(zip(keys, row, strict=True)) for row in rows]
    return Maker(make, one_of(presets), len(presets), presets)


FORM = ("shape", "brand", "colours")
SPRAY = ("shape", "words", "brand", "colours")

MODELS = {
    "spray_cleaner": maker(
        spray_form,
        SPRAY,
        [
            ("classic", "BATHROOM", "BRIZZO", "#2f7fd8 #dff0ff #e2661a #16305c #f5f5f5 #1f5fc4"),
            (
                "classic",
                "GLASS CLEANER",
                "Zappli",
                "#f0d21e #f7ffe8 #143a8c #14622a #1f4fa8 #2d9a48",
            ),
            ("classic", "KITCHEN", "Klarenta", "#e9e4f4 #f6eefc #d4202c #3a1a5c #f5f5f5 #7b3fb5"),
            (
                "round",
                "GLASS CLEANER",
                "KRISTALO",
                "#4fb4e8 #ffffff #1f5fc4 #123a7c #f5f5f5 #1f5fc4",
            ),
            ("jug", "BATH CLEANER", "Frischo", "#2fa86a #ffffff #127a4a #0c4a2c #f5f5f5 #f08a1c"),
            (
                "squat",
                "KITCHEN CLEANER",
                "FETTEX",
                "#f08a1c #fff8d8 #c8202c #a81820 #26282c #c8202c",
            ),
            (
                "aerosol",
                "OVEN CLEANER",
                "FORNAX",
                "#c8202c #fff2c8 #26282c #111111 #f5f5f5 #f5f5f5",
            ),
            (
                "round",
                "KITCHEN CLEANER",
                "Zappli",
                "#f2d23a #ffffff #2d9a48 #14622a #2d9a48 #d8262e",
            ),
            ("jug", "FLOOR CLEANER", "SPLAZH", "#8a5fc0 #ffffff #5a2f9a #3a1a5c #f5f5f5 #d8262e"),
        ],
    ),
    "bleach_bottle": maker(
        bleach_form,
        FORM,
        [
            ("classic", "Blanqo", "#f6f6f2 #ffffff #1f4fa8 #1c1c20 #1f4fa8 #1f4fa8"),
            ("classic", "Blanqo", "#f2cf2a #ffffff #c4202c #c4202c #c4202c #c4202c"),
            ("classic", "Javelin", "#2a62b8 #ffffff #16305c #16305c #f5f5f5 #f5f5f5"),
            ("jug", "Purexa", "#f4f4f0 #f4f4f0 #1f4fa8 #143a8c #1f4fa8 #1f4fa8"),
            ("round", "JAVELIN", "#f2cf2a #ffffff #c4202c #111111 #c4202c #c4202c"),
            ("canister", "Blanqo", "#f4f4f0 #ffffff #c4202c #c4202c #1f4fa8 #c4202c"),
            ("jug", "JAVELIN", "#2a62b8 #ffffff #c4202c #143a8c #f5f5f5 #f5f5f5"),
        ],
    ),
    "dish_soap": maker(
        dish_soap_form,
        FORM,
        [
            ("classic", "Tellora", "#8fc83a #fbfce8 #2c8f4a #1c1c20 #f5f5f5 #c8d838"),
            ("classic", "Plinka", "#f2c52a #fbfce8 #e2762a #1c1c20 #e2402c #f2d23a"),
            ("classic", "Glanzy", "#3aa0d8 #fbfce8 #1f5fa8 #1c1c20 #1f5fa8 #f08a3c"),
            ("round", "SPÜLI", "#2fb06a #ffffff #127a4a #0c5a34 #f5f5f5 #127a4a"),
            ("inverted", "Glanzy", "#2f8fe0 #ffffff #143a8c #143a8c #f5f5f5 #f5f5f5"),
            ("pump", "PLINKA", "#f2a02a #fff8e0 #c8401c #8a2a0c #f5f5f5 #f5f5f5"),
            ("inverted", "Tellora", "#e8608a #ffffff #b02060 #8a1048 #f5f5f5 #f5f5f5"),
        ],
    ),
    "drain_cleaner": maker(
        drain_form,
        FORM,
        [
            ("gel", "DRAINEX", "#c8161e #fff200 #1c1c20 #111111 #1c1c20 #1c1c20"),
            ("granules", "ROHRFIX", "#1d3f94 #ffffff #d8202c #1d3f94 #d8202c #d8202c"),
            ("gel", "PIPOX", "#26282c #ffffff #e8641c #c8161e #e8641c #e8641c"),
            ("handled", "TUBEX", "#e8641c #fff6c8 #26282c #111111 #26282c #26282c"),
            ("slim", "DRAINEX", "#7b2f9a #fff200 #c8161e #111111 #c8161e #f5f5f5"),
            ("tub", "ROHRFIX", "#f4f4f0 #f4f4f0 #c8161e #c8161e #c8161e #c8161e"),
            ("bag", "PIPOX", "#f2c52a #ffffff #c8161e #111111 #c8161e #c8161e"),
        ],
    ),
    "toilet_cleaner": maker(
        toilet_form,
        FORM,
        [
            ("classic", "Bowlix", "#1592b8 #ffffff #12356c #12356c #12356c #12356c"),
            ("classic", "RANDO", "#2f9a48 #f4ffe8 #125c28 #b01820 #ffffff #ffffff"),
            ("classic", "Bowlix", "#f2f2ee #e83a8a #5a1a6c #ffffff #5a1a6c #5a1a6c"),
            ("slim", "WC-STAR", "#1f4fa8 #ffffff #c8202c #143a8c #c8202c #c8202c"),
            ("wide", "RANDO", "#0f9a8a #ffffff #0c5a50 #0c5a50 #f08a1c #f08a1c"),
            ("straight", "WC-STAR", "#f4f4f0 #ffffff #2f7fd8 #143a8c #2f7fd8 #c8202c"),
            ("slim", "LIMETTO", "#8fc83a #ffffff #2f7a2a #1c5a1c #2f7a2a #2f7a2a"),
        ],
    ),
    "insect_spray": maker(
        insect_spray,
        ("shape", "words", "brand", "colours"),
        [
            ("tall", "INSECT SPRAY", "MOSKIL", "#2f9a48 #ffe81c #c8161e #111111 #c8161e #c8161e"),
            ("button", "FLY SPRAY", "ZAPPEX", "#1c1c20 #ffffff #c8161e #111111 #d8202c #d8202c"),
            ("short", "INSECT SPRAY", "TIKOFF", "#f08a1c #ffffff #1f5fa8 #111111 #1f5fa8 #f5f5f5"),
            ("squat", "INSECT KILLER", "GARDIX", "#f4f4f0 #ffe81c #2f7a2a #111111 #2f7a2a #c8161e"),
            ("fogger", "ROACH KILLER", "KAKROX", "#c8161e #ffe81c #1c1c20 #111111 #1c1c20 #f5f5f5"),
            ("tall", "ANT SPRAY", "FORMIX", "#c8161e #ffffff #1c1c20 #c8161e #1c1c20 #1c1c20"),
            ("button", "INSECT SPRAY", "MOSKIL", "#1f5fa8 #fff8c8 #2f9a48 #111111 #f5f5f5 #f5f5f5"),
        ],
    ),
}
