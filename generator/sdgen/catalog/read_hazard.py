"""A file of ``hazards/`` read into a :class:`Hazard`."""

from __future__ import annotations

import re

from sdgen.catalog.consistency import check_recipes
from sdgen.catalog.predicate_yaml import read_predicate
from sdgen.catalog.reader import Reader
from sdgen.catalog.records import (
    Concern,
    Group,
    Hazard,
    Label,
    PlaceRecipe,
    Recipe,
    RemedyRule,
    SetRecipe,
)
from sdgen.catalog.terms import AllTerm, AnyTerm, HeightTerm, Predicate
from sdgen.vocabulary import ZONE_KINDS

#: The label each group carries, and its order in listings.
LABELS: dict[Group, Label] = {
    "safety": "unsafe",
    "sanitation": "unsanitary",
    "child_safety": "unsafe for children",
}
ACTIONS = ("close", "switch_off", "put_out", "put_in", "put_on", "wipe_up", "throw_away")
_PLACEHOLDERS = ("object", "target", "room")


def read_hazard(reader: Reader, categories: set[str], rooms: set[str], pack: str) -> Hazard:
    """Read one hazard; problems are noted in the reader's source."""
    group: Group = reader.choice("group", tuple(LABELS))
    label = reader.choice("label", tuple(LABELS.values()), LABELS[group])
    if label != LABELS[group]:
        reader.problem(f"the label of group {group} is {LABELS[group]!r}", "label")
    relation = reader.choice("relation", ("ON", "INSIDE"), None)
    predicate: Predicate = AllTerm(terms=())
    if reader.has("predicate"):
        path = (*reader.path, "predicate")
        below = reader.data["predicate"]
        predicate = read_predicate(reader.source, path, below, categories, rooms)
    elif reader.ok:
        reader.problem("missing key 'predicate': when is it true?")
    concerns = _concern(reader.child("concerns"))
    if concerns.by_reach and not _measures_reach(predicate):
        reader.problem(
            "by_reach needs a term 'height: {…, evidence: reach_height_m}' in the predicate",
            "concerns",
            "by_reach",
        )
    hazard = Hazard(
        id=reader.word("id"),
        title=reader.text("title"),
        paper_class=reader.text("paper_class", ""),
        group=group,
        label=LABELS[group],
        concerns=concerns,
        urgency=reader.choice("urgency", ("high", "medium", "low")),
        message=_message(reader, relation is not None),
        source=reader.text("source"),
        predicate=predicate,
        relation=relation,
        evidence_state=reader.state("evidence_state", None),
        anomalies=tuple(_recipe(row, categories, rooms) for row in reader.rows("anomalies")),
        lookalikes=tuple(
            _recipe(row, categories, rooms) for row in reader.rows("lookalikes", None)
        ),
        remedy=tuple(_remedy(row, categories) for row in reader.rows("remedy")),
        pack=pack,
    )
    reader.flag("replaces")
    reader.done()
    if not reader.source.problems:
        check_recipes(reader, hazard)
    return hazard


def _concern(reader: Reader) -> Concern:
    who = reader.choice("who", ("everyone", "children"))
    age = reader.integer("max_age", None, low=0, high=17)
    by_reach = reader.flag("by_reach")
    if who == "children" and age is None and reader.ok:
        reader.problem("who: children needs max_age (years)")
    if who == "everyone" and (age is not None or by_reach):
        reader.problem("max_age and by_reach belong to who: children")
    reader.done()
    return Concern(who=who, max_age=age, by_reach=by_reach)


def _message(reader: Reader, has_target: bool) -> str:
    text = reader.text("message")
    for name in re.findall(r"\{([^{}]*)\}", text):
        if name not in _PLACEHOLDERS:
            allowed = ", ".join(f"{{{word}}}" for word in _PLACEHOLDERS)
            reader.problem(f"unknown placeholder {{{name}}} (allowed: {allowed})", "message")
        if name == "target" and not has_target:
            reader.problem("{target} needs 'relation: ON' or 'relation: INSIDE'", "message")
    if re.search(r"[{}]", re.sub(r"\{[^{}]*\}", "", text)):
        reader.problem("has a brace without its pair", "message")
    return text


def _recipe(reader: Reader, categories: set[str], rooms: set[str]) -> Recipe:
    setting = reader.has("set")
    if setting or not reader.has("place"):
        if not setting and reader.ok:
            reader.problem("expected 'place: [categories]' or 'set: [categories]'")
        names = reader.words("set", (), choices=categories, what="category")
        recipe: Recipe = SetRecipe(
            categories=names,
            state=reader.state("state") or "",
            rooms=reader.words("rooms", (), choices=rooms, what="room type"),
            weight=reader.number("weight", 1.0, low=0.001, high=1000.0),
        )
    else:
        recipe = _place(reader, categories, rooms)
    reader.done()
    return recipe


def _place(reader: Reader, categories: set[str], rooms: set[str]) -> PlaceRecipe:
    low = reader.number("min_height_m", None, low=0.0, high=10.0)
    high = reader.number("max_height_m", None, low=0.0, high=10.0)
    if low is not None and high is not None and low > high:
        reader.problem(f"min_height_m ({low:g}) is above max_height_m ({high:g})", "min_height_m")
    targets = reader.words("target", choices=categories, what="category")
    zone = reader.words("zone", (), choices=ZONE_KINDS, what="zone")
    if zone and targets != ("floor",):
        reader.problem("zone needs 'target: floor'", "zone")
    return PlaceRecipe(
        categories=reader.words("place", choices=categories, what="category"),
        state=reader.state("state", None),
        relation=reader.choice("relation", ("ON", "INSIDE")),
        targets=targets,
        zone=zone,
        avoid_zones=reader.words("avoid_zones", (), choices=ZONE_KINDS, what="zone"),
        rooms=reader.words("rooms", (), choices=rooms, what="room type"),
        min_height_m=low,
        max_height_m=high,
        weight=reader.number("weight", 1.0, low=0.001, high=1000.0),
    )


def _remedy(reader: Reader, categories: set[str]) -> RemedyRule:
    action = reader.choice("action", ACTIONS)
    targets = reader.words("target", (), choices=categories, what="category")
    if action in ("put_in", "put_on") and reader.ok and not reader.has("target"):
        reader.problem(f"action {action} needs a target")
    reader.done()
    return RemedyRule(action=action, targets=targets)


def _measures_reach(predicate: Predicate) -> bool:
    if isinstance(predicate, AllTerm | AnyTerm):
        return any(_measures_reach(term) for term in predicate.within())
    return isinstance(predicate, HeightTerm) and predicate.evidence == "reach_height_m"
