"""Mangoes, kiwis, aubergines, pumpkins, garlic: all from the table of fruit and vegetables."""

from __future__ import annotations

import numpy as np
from toolkit.model import Maker, Model
from toolkit.sampling import seed_of, uniform

from makers import table_fruit, table_roots
from makers.produce_forms import served, with_forms


def any_random(rng: np.random.Generator) -> dict:
    return {"size": uniform(rng, 0.95, 1.05), "seed": seed_of(rng)}


def _maker(name: str):
    def make(**parameters) -> Model:
        raise NotImplementedError(f"a {name} comes from the table, by a preset")

    make.__name__ = name
    return with_forms(make)


def _from_table(name: str, presets: list[dict]) -> Maker:
    return Maker(_maker(name), any_random, len(presets), presets)


MODELS = {
    "mango": _from_table(
        "mango",
        [
            served(table_fruit.MANGO, "one", "red", 1),
            served(table_fruit.MANGO, "half", "yellow", 2),
            served(table_fruit.MANGO, "pair", "green", 3),
            served(table_fruit.MANGO, "halves", "red", 4),
            served(table_fruit.MANGO, "three", "red", 5),
            served(table_fruit.MANGO, "whole_half", "red", 6),
            served(table_fruit.MANGO, "one", "green", 1),
        ],
    ),
    "kiwi": _from_table(
        "kiwi",
        [
            served(table_fruit.KIWI, "one", "green", 1),
            served(table_fruit.KIWI, "half", "green", 2),
            served(table_fruit.KIWI, "whole_half", "green", 3),
            served(table_fruit.KIWI, "three", "green", 4),
            served(table_fruit.KIWI, "tray", "green", 5),
            served(table_fruit.KIWI, "slices", "green", 6),
            served(table_fruit.KIWI, "half", "gold", 2),
        ],
    ),
    "eggplant": _from_table(
        "eggplant",
        [
            served(table_roots.EGGPLANT, "one", "purple", 1),
            served(table_roots.EGGPLANT_ROUND, "upright", "purple", 2),
            served(table_roots.EGGPLANT_LONG, "three", "purple", 3),
            served(table_roots.EGGPLANT, "half", "purple", 4),
            served(table_roots.EGGPLANT, "pair", "purple", 5),
            served(table_roots.EGGPLANT_ROUND, "upright", "striped", 2),
            served(table_roots.EGGPLANT, "slices", "purple", 6),
        ],
    ),
    "pumpkin": _from_table(
        "pumpkin",
        [
            served(table_roots.PUMPKIN, "one", "orange", 1),
            served(table_roots.PUMPKIN_TALL, "one", "orange", 2),
            served(table_roots.PUMPKIN_FLAT, "one", "green", 3),
            served(table_roots.PUMPKIN, "half", "orange", 4),
            served(table_roots.PUMPKIN_SMALL, "three", "orange", 5),
            served(table_roots.PUMPKIN_FLAT, "one", "orange", 3),
            served(table_roots.PUMPKIN, "wedges", "orange", 7),
        ],
    ),
    "garlic": _from_table(
        "garlic",
        [
            served(table_roots.GARLIC, "one", "white", 1),
            served(table_roots.GARLIC, "three", "white", 2),
            served(table_roots.GARLIC, "half", "purple", 3),
            served(table_roots.GARLIC, "net", "white", 4),
            served(table_roots.GARLIC, "pair", "purple", 5),
            served(table_roots.GARLIC, "one", "purple", 1),
        ],
    ),
}
