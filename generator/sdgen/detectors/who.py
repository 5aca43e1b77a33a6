"""A household in words, for a prompt that is to heed it."""

from __future__ import annotations

from typing import Literal

from sdgen.catalog.records import Catalog
from sdgen.errors import one_line
from sdgen.scene import Household, Notify

#: How a household enters: what is told is decided after the labels, by the model, or not at all.
Entry = Literal["filter", "prompt", "none"]

_TELL = (
    "Behind each class other than 'normal' say in brackets how this household is to be told of it: "
    "(now), (summary) for once a day, or (silent) where it does not concern them or they do not "
    "want to hear of it."
)
_TELL_NO_CLASS = (
    "Behind each one that you name say in brackets how this household is to be told of it: (now), "
    "(summary) for once a day, or (silent) where it does not concern them or they do not want to "
    "hear of it."
)


def who_lives_here(household: Household, catalog: Catalog, categories: bool = True) -> str:
    """A paragraph: members, pets, conditions, what they want to hear of, and how to answer.

    What they want is told by the titles of the catalogue's hazards, never by what the scene holds.
    """
    titles = {hazard.id: hazard.title for hazard in catalog.hazards}
    titles |= {group: group.replace("_", " ") for group in (h.group for h in catalog.hazards)}
    members = ", ".join(f"{_said(m.role)} ({m.age} years)" for m in household.members) or "nobody"
    lines = [f"Who lives in this home: {members}."]
    if household.pets:
        lines.append(f"Pets: {', '.join(map(_said, household.pets))}.")
    if household.conditions:
        lines.append(f"Somebody who lives here {' and '.join(map(_said, household.conditions))}.")
    wanted: dict[Notify, list[str]] = {}
    for hazard, notify in sorted(household.notifications.items()):
        wanted.setdefault(notify, []).append(_said(titles.get(hazard, hazard)))
    silent = [_said(titles.get(name, name)) for name in household.opt_outs]
    silent += wanted.get("silent", [])
    if silent:
        lines.append(f"They do not want to hear of: {'; '.join(dict.fromkeys(silent))}.")
    ways: tuple[tuple[Notify, str], ...] = (("summary", "once a day"), ("now", "at once"))
    for notify, words in ways:
        if wanted.get(notify):
            lines.append(f"They want to hear {words} of: {'; '.join(wanted[notify])}.")
    return " ".join([*lines, _TELL if categories else _TELL_NO_CLASS])


def _said(word: str) -> str:
    return one_line(word.replace("_", " "))
