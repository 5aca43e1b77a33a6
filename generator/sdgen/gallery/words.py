"""Records in words: what was measured, who lives there."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping

from sdgen.scene import EvidenceValue, Household

#: What a measured term is called; a key that is not here is its own name.
_NAMES = {
    "height_m": "height",
    "reach_height_m": "above where a child can stand",
    "climbed_id": "climbed on",
    "distance_m": "distance",
    "nearest_id": "nearest",
    "gap_m": "gap",
    "overlap": "resting on it",
    "target_id": "to",
    "zone_overlap": "in the zone",
    "edge_m": "from the edge",
    "overhang_m": "over the edge",
    "above_id": "above",
    "above_gap_m": "beside it by",
    "above_drop_m": "higher by",
    "facing_deg": "turned towards it by",
    "facing_id": "facing",
    "away_deg": "turned away by",
    "away_from_id": "away from",
}
#: What undoes an anomaly, with a place and without one.
_ACTIONS = {
    "close": ("close it", "close it"),
    "switch_off": ("switch it off", "switch it off"),
    "put_out": ("put it out", "put it out"),
    "empty": ("empty it", "empty it"),
    "put_in": ("put it into {}", "put it where such things are kept"),
    "put_on": ("put it on {}", "put it where such things stand"),
    "move_away": ("move it away to {}", "move it away"),
    "wipe_up": ("wipe it up", "wipe it up"),
    "sweep_up": ("sweep it up", "sweep it up"),
    "throw_away": ("throw it into {}", "throw it away"),
    "take_away": ("take it away", "take it away"),
}
#: Said by others: a relation by its clause, a category by a name, a zone's name by its kind.
_LEFT_OUT = {"relation", "target_category", "zone_name"}


def plain(text: object) -> str:
    """A name of ours as words."""
    return str(text).replace("_", " ")


def split_key(key: str) -> tuple[str, str]:
    """The name of a measured term, and which of several it is (``_2``; empty for the first)."""
    found = re.fullmatch(r"(.+?)(_\d+)?", key)
    return (key, "") if found is None else (found[1], found[2] or "")


def measured(
    evidence: Mapping[str, EvidenceValue], name: Callable[[int], str]
) -> tuple[tuple[str, str], ...]:
    """What was measured, as pairs of words; ``name`` says what a node is."""
    out = []
    for key, value in evidence.items():
        base, _ = split_key(key)
        if base in _LEFT_OUT:
            continue
        out.append((_NAMES.get(base, plain(base.removesuffix("_m"))), _value(base, value, name)))
    return tuple(out)


def _value(key: str, value: EvidenceValue, name: Callable[[int], str]) -> str:
    if isinstance(value, bool | str):
        return plain(value)
    if key.endswith("_id"):
        return name(int(value))
    if key.endswith("_m"):
        return f"{value:.2f} m"
    if key.endswith("_deg"):
        return f"{value:.0f}°"
    return f"{value:.0%}" if key.endswith("overlap") else f"{value:g}"


def deed(action: str, place: str | None) -> str:
    """What undoes an anomaly, in words; ``place`` is what its object is put on or into."""
    with_place, without = _ACTIONS.get(action, (f"{plain(action)} {{}}", plain(action)))
    return without if place is None else with_place.format(place)


def who(household: Household) -> str:
    """Who lives there, in a sentence."""
    people = [f"{_article(one.role)} {plain(one.role)} of {one.age}" for one in household.members]
    pets = [f"{_article(pet)} {plain(pet)}" for pet in household.pets]
    text = f"{_listed(people)} live here" if len(people) > 1 else f"{_listed(people)} lives here"
    text = text[0].upper() + text[1:]
    if pets:
        text += f", with {_listed(pets)}"
    if household.conditions:
        text += f"; somebody {_listed([plain(one) for one in household.conditions])}"
    return text + "."


def _article(word: str) -> str:
    return "an" if word[:1].lower() in "aeiou" else "a"


def _listed(words: list[str]) -> str:
    if not words:
        return "nobody"
    return words[0] if len(words) == 1 else f"{', '.join(words[:-1])} and {words[-1]}"
