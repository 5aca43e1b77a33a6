"""What a value of the catalogue may be: names that exist, states, numbers within limits.

Annotated types for records. Names are looked up in the validation context, a :class:`Names`; a
catalogue read back from a data set has none, and was checked when it was written.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Annotated, Any

from pydantic import AfterValidator, BeforeValidator, ValidationInfo

from sdgen.errors import did_you_mean, nearest
from sdgen.geometry import Quat, Vec2, Vec3
from sdgen.strict import Expect, problem, refuse, shown, unknown
from sdgen.vocabulary import ZONE_KINDS
from sdgen.yaml_source import Path_

WORD = re.compile(r"[a-z][a-z0-9_]*")
_STATE = re.compile(r"[A-Z][A-Z_]*")
NOT_A_NAME = "is not a name (lower case letters, digits, _)"


_LOOKED_UP = (
    "category",
    "room type",
    "hazard",
    "style",
    "activity",
    "pet or condition",
    "pet, condition or age group",
)


@dataclass(frozen=True)
class Names:
    """What entries may refer to. ``like`` gives, by room type, those that are kinds of it: a rule
    that names it holds in them too."""

    categories: tuple[str, ...]
    rooms: tuple[str, ...]
    hazards: tuple[str, ...] = ()
    traits: tuple[str, ...] = ()
    groups: tuple[str, ...] = ()
    styles: tuple[str, ...] = ()
    activities: tuple[str, ...] = ()
    like: Mapping[str, tuple[str, ...]] = field(default_factory=dict)

    def of(self, what: str) -> tuple[str, ...]:
        """The names of one kind, sorted."""
        kinds = {
            "category": self.categories,
            "room type": self.rooms,
            "hazard": self.hazards,
            "style": self.styles,
            "activity": self.activities,
            "pet or condition": self.traits,
            "pet, condition or age group": tuple(sorted({*self.traits, *self.groups})),
        }
        return kinds[what]


def state_problem(text: str) -> str:
    """Why a word is no state, and how to write it; empty when it is one."""
    if _STATE.fullmatch(text):
        return ""
    better = re.sub(r"[^A-Z]+", "_", text.upper()).strip("_")
    hint = f": write {better}" if better else ""
    return f"{text[:80]!r} is not a state; states are UPPER CASE words{hint}"


def name_of(what: str) -> BeforeValidator:
    """One name of a kind."""

    def check(value: Any, info: ValidationInfo) -> Any:
        if isinstance(value, str) and isinstance(info.context, Names):
            choices = info.context.of(what)
            if value not in choices:
                refuse(unknown((), what, value, choices))
        return value

    return BeforeValidator(check)


def one_of(choices: tuple[str, ...]) -> BeforeValidator:
    """One of some words."""

    def fits(text: str) -> str:
        if text in choices:
            return ""
        hint = did_you_mean(text, choices) if nearest(text, choices) else ""
        return f"{text[:40]!r} is not one of {', '.join(choices)}{hint}"

    return _matching(fits)


def names_of(what: str, least: int = 1, choices: tuple[str, ...] | None = None) -> BeforeValidator:
    """One name or a list of names, without repeats, each of a kind or among ``choices``."""

    def check(value: Any, info: ValidationInfo) -> Any:
        if not isinstance(value, str | list | tuple):
            refuse(problem((), f"expected a {what} or a list of them, got {shown(value)}"))
        known = choices
        if known is None and isinstance(info.context, Names) and what in _LOOKED_UP:
            known = info.context.of(what)
        found: list[Any] = []
        seen: set[str] = set()
        for index, item in enumerate((value,) if isinstance(value, str) else value):
            path: Path_ = () if isinstance(value, str) else (index,)
            if not isinstance(item, str):
                found.append(problem(path, f"expected a {what}, got {shown(item)}"))
            elif known is not None and item not in known:
                found.append(unknown(path, what, item, known))
            elif what == "state" and (why := state_problem(item)):
                found.append(problem(path, why))
            elif item in seen:
                found.append(problem(path, f"{item!r} is listed twice"))
            else:
                seen.add(item)
        if found:
            refuse(*found)
        if len(seen) < least:
            refuse(problem((), f"expected at least one {what}"))
        return (value,) if isinstance(value, str) else tuple(value)

    return BeforeValidator(check)


def _with_kinds(rooms: tuple[str, ...], info: ValidationInfo) -> tuple[str, ...]:
    """Room types, and after them those that are like one of them."""
    if not isinstance(info.context, Names):
        return rooms
    return tuple(
        dict.fromkeys((*rooms, *(kind for r in rooms for kind in info.context.like.get(r, ()))))
    )


def _matching(fits: Callable[[str], str]) -> BeforeValidator:
    """A validator of text: ``fits`` says what is wrong with it, or nothing."""

    def check(value: Any) -> Any:
        if isinstance(value, str) and (why := fits(value)):
            refuse(problem((), why))
        return value

    return BeforeValidator(check)


def _folded(value: Any) -> Any:
    return " ".join(value.split()) if isinstance(value, str) else value


def between(low: float, high: float) -> BeforeValidator:
    """A number within limits (inclusive)."""

    def check(value: Any) -> Any:
        if isinstance(value, int | float) and not isinstance(value, bool):
            _within(value, low, high)
        return value

    return BeforeValidator(check)


def _within(value: float, low: float, high: float, path: Path_ = ()) -> None:
    if not low <= value <= high:
        refuse(problem(path, f"{value} is not between {low:g} and {high:g}"))


def numbers(
    count: int, low: float, high: float, rising: bool = False, whole: bool = False
) -> BeforeValidator:
    """``count`` numbers within limits."""

    def check(value: Any) -> Any:
        if not isinstance(value, list | tuple) or len(value) != count:
            got = f"{len(value)} items" if isinstance(value, list | tuple) else shown(value)
            empty = "is empty: " if value is None else ""
            wanted = f"{empty}expected a list of {count} numbers"
            refuse(problem((), wanted if empty else f"{wanted}, got {got}"))
        for index, item in enumerate(value):
            if isinstance(item, bool) or not isinstance(item, int | float):
                refuse(problem((index,), f"expected a number, got {shown(item)}"))
            _within(item, low, high, (index,))
        if whole and any(item != int(item) for item in value):
            refuse(problem((), "expected whole numbers"))
        if rising and value[0] > value[1]:
            text = f"the first number ({value[0]:g}) is above the second ({value[1]:g})"
            refuse(problem((), text))
        return tuple(int(item) if whole else float(item) for item in value)

    return BeforeValidator(check)


def span(low: float, high: float, whole: bool = False) -> BeforeValidator:
    """``[least, most]`` within limits."""
    return numbers(2, low, high, rising=True, whole=whole)


PAIR = Expect("a list of 2 numbers")

Text = Annotated[str, BeforeValidator(_folded)]
"""Free text, one line or many; white space is folded."""

Word = Annotated[
    str,
    _matching(lambda text: "" if WORD.fullmatch(text) else f"{text[:80]!r} {NOT_A_NAME}"),
    Expect("a lower case name"),
]
"""A lower case name such as ``milk_carton``."""

State = Annotated[str, _matching(state_problem), Expect("a state such as ON or OPEN")]

CategoryName = Annotated[str, name_of("category"), Expect("a category")]
RoomName = Annotated[str, name_of("room type"), Expect("a room type")]
HazardName = Annotated[str, name_of("hazard")]
StyleName = Annotated[str, name_of("style"), Expect("a style")]

Categories = Annotated[
    tuple[str, ...], names_of("category"), Expect("a category or a list of them")
]
OptionalCategories = Annotated[tuple[str, ...], names_of("category", least=0)]
States = Annotated[tuple[str, ...], names_of("state", least=0)]
RoomNames = Annotated[tuple[str, ...], AfterValidator(_with_kinds), names_of("room type", least=0)]
Belongs = Annotated[tuple[str, ...], names_of("pet, condition or age group", least=0)]
#: Of models: what they call their parts is known to the library alone.
PartNames = Annotated[tuple[str, ...], names_of("part"), Expect("a part or a list of them")]
Zones = Annotated[tuple[str, ...], names_of("zone", 0, ZONE_KINDS)]

#: How often, beside others: a thousandth to a thousand times the usual 1.
Weight = Annotated[float, between(0.001, 1000.0)]
Counts = Annotated[tuple[int, int], span(0, 100, whole=True), PAIR]
#: Depth, width, height: nothing of a home is longer than 50 m.
Size = Annotated[Vec3, numbers(3, 0.0, 50.0), Expect("a list of 3 numbers")]
#: Places in a home: no drawing is a kilometre wide.
Point3 = Annotated[Vec3, numbers(3, -1000.0, 1000.0), Expect("a list of 3 numbers")]
Quaternion = Annotated[Quat, numbers(4, -1.0, 1.0), Expect("a list of 4 numbers, xyzw")]
Point2 = Annotated[Vec2, numbers(2, -1000.0, 1000.0), PAIR]
Rectangle = Annotated[
    tuple[float, float, float, float],
    numbers(4, -1000.0, 1000.0),
    Expect("a list of 4 numbers"),
]
