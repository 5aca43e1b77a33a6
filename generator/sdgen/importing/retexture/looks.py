"""The states that retexturing can give a model, and what each look means on what it is made of."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Literal

from sdgen.errors import UsageError, did_you_mean

#: What a model is made of, as the looks of ``assets/blender/wear.py`` tell apart.
Kind = Literal["produce", "bread", "meat", "ware", "thing"]

#: Words in names of categories, the first that fits counts. What comes in a pack shows its food
#: or its label: neither grows spots like a fruit.
_WORDS: tuple[tuple[Kind, tuple[str, ...]], ...] = (
    ("meat", ("meat", "steak", "ham", "sausage", "bacon", "chicken", "beef", "fish", "salmon")),
    ("bread", ("bread", "loaf", "bun", "toast", "bagel", "croissant", "muffin", "cake", "cookie")),
    ("bread", ("pizza", "pie", "cheese", "butter", "sandwich", "leftovers")),
    ("thing", ("box", "carton", "bottle", "can", "canned", "jar", "pack", "bag", "tub", "cup")),
    ("ware", ("plate", "bowl", "mug", "glass", "dish", "pot", "pan", "tray", "teapot", "pitcher")),
    ("ware", ("kettle", "toaster", "microwave", "blender")),
    ("ware", ("fork", "knife", "spoon", "spatula", "ladle", "colander", "cutter", "peeler")),
    ("ware", ("placemat", "coaster", "table", "counter", "stove", "board")),
    ("produce", ("fruit", "vegetable", "vegetables", "pepper")),
)
#: Cups hold drinks, all but those of yogurt and pudding.
_WARE = ("cup", "teacup", "coffee_cup", "wine_glass", "cutting_board", "baking_dish", "pen_cup")


@dataclass(frozen=True)
class Worn:
    """A state, the look of it and where it is at home: among food, elsewhere, or on both."""

    state: str
    look: str
    on_food: bool
    on_things: bool
    #: Some hazard, lookalike or activity of the shipped catalogue asks for it.
    asked_for: bool


#: Word -> state; the word also names the variant.
WORN: Mapping[str, Worn] = MappingProxyType(
    {
        "expired": Worn("EXPIRED", "expired", on_food=True, on_things=False, asked_for=True),
        "overripe": Worn("OVERRIPE", "overripe", on_food=True, on_things=False, asked_for=True),
        "dirty": Worn("DIRTY", "dirty", on_food=False, on_things=True, asked_for=True),
        "wet": Worn("WET", "wet", on_food=True, on_things=True, asked_for=True),
        "dusty": Worn("DUSTY", "dusty", on_food=False, on_things=True, asked_for=False),
    }
)
#: Other words for them.
_ALSO = {"rotten": "expired", "mouldy": "expired", "moldy": "expired", "stained": "dirty"}
#: States that are another shape, not another colour.
_SHAPES = ("broken", "cut", "open", "closed", "opened", "full", "empty", "spilled", "creamed")


def worn_word(word: str) -> str:
    """The key of ``WORN`` that a user's word means. Raises UsageError for all others."""
    low = word.strip().lower()
    low = _ALSO.get(low, low)
    if low in WORN:
        return low
    words = ", ".join(WORN)
    if low in _SHAPES:
        text = f"{word!r} is another shape, not another texture; retexturing makes {words}"
        if low == "broken":
            text += " (pairs of whole and broken scans are imported: 'sdgen assets import')"
        raise UsageError(text)
    raise UsageError(f"no look {word[:40]!r}{did_you_mean(low, list(WORN))}")


def kind_of(category: str, is_food: bool) -> Kind:
    """What a model of a category is made of, by the words of its name; other food is produce."""
    if category in _WARE:
        return "ware"
    words = category.split("_")
    for kind, names in _WORDS:
        if any(word in names for word in words):
            return kind
    return "produce" if is_food else "thing"


def oddity(worn: Worn, category: str, is_food: bool, is_known: bool) -> str | None:
    """What is strange about a state of a category, in words; None when nothing is."""
    if not worn.asked_for:
        return f"no hazard of the shipped catalogue asks for {worn.state}; one of yours may"
    if not is_known:
        return None
    if is_food and not worn.on_food:
        return f"a {category} is food: nobody expects it to be {worn.state}"
    if not is_food and not worn.on_things:
        return f"a {category} is no food: nobody expects it to be {worn.state}"
    return None
