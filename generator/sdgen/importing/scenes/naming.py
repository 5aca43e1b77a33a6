"""What names of a scene say: parts of the building, kinds of rooms, categories of things.

Which category a thing is of is asked of a :data:`Namer`; :func:`exact_namer` knows our own words
only, with numbers behind them.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Literal

from sdgen.catalog.records import Catalog
from sdgen.importing.scenes.found import FoundPiece
from sdgen.vocabulary import STRUCTURES, Facing, StructureKind

#: Other words for a part of the building, and for an opening.
_BUILDING: Mapping[str, StructureKind] = {
    **{kind: kind for kind in STRUCTURES},
    "floors": "floor",
    "ground": "floor",
    "walls": "wall",
    "ceilings": "ceiling",
    "roof": "ceiling",
}
#: Of our own export: a part of the building with its number and room, and a band of it.
_OURS = re.compile(r"(floor|wall|ceiling)_[0-9]+_([a-z][a-z0-9_]*)(?:/.*)?")
OpeningWord = Literal["door", "double_door", "front_door", "passage", "wide_passage", "window"]
_OPENINGS: Mapping[str, OpeningWord] = {
    "door": "door",
    "double_door": "double_door",
    "front_door": "front_door",
    "entrance_door": "front_door",
    "entry_door": "front_door",
    "main_door": "front_door",
    "door_frame": "passage",
    "doorjamb": "passage",
    "doorway": "passage",
    "passage": "passage",
    "archway": "passage",
    "wide_passage": "wide_passage",
    "window": "window",
}
#: Other words for our types of rooms; only those that the catalogue has are used.
_ROOMS: Mapping[str, str] = {
    "livingroom": "living_room",
    "lounge": "living_room",
    "sitting_room": "living_room",
    "family_room": "living_room",
    "main_room": "living_room",
    "diningroom": "dining_room",
    "bed_room": "bedroom",
    "master_bedroom": "bedroom",
    "guest_room": "bedroom",
    "kids_room": "child_room",
    "kidsroom": "child_room",
    "childrens_room": "child_room",
    "nursery": "child_room",
    "bath": "bathroom",
    "bath_room": "bathroom",
    "shower_room": "bathroom",
    "wc": "toilet",
    "restroom": "toilet",
    "hallway": "hall",
    "entrance": "hall",
    "entry": "hall",
    "foyer": "hall",
    "lobby": "hall",
    "study": "office",
    "home_office": "office",
    "home_offices": "office",
    "laundry_room": "laundry",
    "utility_room": "laundry",
    "pantry": "storage",
    "closet": "storage",
    "garage": "storage",
    "attic": "storage",
    "basement": "storage",
    "cellar": "storage",
    "store_room": "storage",
}
#: Words that say nothing of what a thing is.
_SIDES = frozenset(
    [
        "left",
        "right",
        "front",
        "back",
        "north",
        "south",
        "east",
        "west",
        "inner",
        "outer",
        "inside",
        "outside",
        "main",
        "room",
        "top",
        "bottom",
        "backing",
        "visual",
        "collision",
        "mesh",
        "geom",
        "group",
        "body",
        "link",
        "root",
        "node",
        "obj",
        "object",
        "a",
        "b",
        "c",
        "d",
    ]
)


@dataclass(frozen=True)
class Named:
    """Of which category a thing is (None: of none of ours), and why. ``guessed``: a person should
    look at it. ``front``: which way it looks in its own frame, where the namer knows."""

    category: str | None
    why: str
    guessed: bool = False
    front: Facing | None = None


#: Asked for the category of what is found.
Namer = Callable[[FoundPiece], Named]


def words_of(name: str) -> tuple[str, ...]:
    """``Kitchen_Counter-03 (1)`` -> kitchen, counter: lower case, without numbers."""
    plain = unicodedata.normalize("NFKC", name)
    plain = re.sub(r"(?<=[a-z])(?=[A-Z])", "_", plain).casefold()
    return tuple(word for word in re.split(r"[\W_]+|\d+", plain) if word)


def exact_namer(catalog: Catalog) -> Namer:
    """Knows the catalogue's own names, and nothing else."""
    known = {category.name for category in catalog.categories}

    def named(piece: FoundPiece) -> Named:
        for name in (piece.name, *piece.names):
            word = "_".join(words_of(name))
            if word in known:
                return Named(word, f"it is called {name!r}")
        called = " or ".join(repr(name) for name in (piece.name, *piece.names)[:3])
        return Named(None, f"no category is called {called}")

    return named


def structure_of(name: str, catalog: Catalog) -> StructureKind | None:
    """The part of the building that a name means: ``floor_12_kitchen``, ``Wall North``; None for
    a thing, ``wall_cabinet`` too."""
    ours = _OURS.fullmatch(name)
    if ours is not None:
        return _BUILDING[ours[1]]
    words = words_of(name.split("/")[0])
    if not words or "_".join(words[:2]) in {category.name for category in catalog.categories}:
        return None if not words or len(words) > 1 else _BUILDING.get(words[0])
    types = {room.name for room in catalog.room_types}
    for at in (0, len(words) - 1):
        beside = [word for k, word in enumerate(words) if k != at]
        plain = [word for word in beside if word not in _SIDES]
        rooms = {_ROOMS.get(name, name) for name in ("_".join(beside), "_".join(plain))}
        if words[at] in _BUILDING and (not plain or rooms & types):
            return _BUILDING[words[at]]
    return None


def room_in(name: str) -> str | None:
    """The room's name in what our own export calls a floor or wall: ``floor_12_kitchen``."""
    ours = _OURS.fullmatch(name)
    return None if ours is None else ours[2]


def opening_of(name: str) -> OpeningWord | None:
    """The opening that a name means: ``Door_03``, ``kitchen window``; None for other things."""
    words = words_of(name)
    for said in (words, [word for word in words if word not in _SIDES]):
        for k in range(len(said)):
            kind = _OPENINGS.get("_".join(said[k:]))
            if kind is not None:
                return kind
    return None


def room_type_of(name: str, catalog: Catalog) -> str | None:
    """The type of room that a name means, by its last words; None when it says none."""
    types = {room.name for room in catalog.room_types}
    words = words_of(name)
    for end in range(len(words), 0, -1):
        for start in range(end):
            word = "_".join(words[start:end])
            found = _ROOMS.get(word, word)
            if found in types:
                return found
    return None


def room_word(name: str, fallback: str) -> str:
    """A name for a room's ``name`` in YAML: lower case letters, digits and ``_``."""
    word = "_".join(re.findall(r"[a-z0-9]+", unicodedata.normalize("NFKD", name).casefold()))
    return word if re.fullmatch(r"[a-z][a-z0-9_]{0,59}", word) else fallback
