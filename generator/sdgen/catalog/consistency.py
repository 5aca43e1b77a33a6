"""Can a recipe make what its hazard's predicate asks for? Told before anything is built."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence

from sdgen.catalog.activity import Activity
from sdgen.catalog.cases import cases, placements
from sdgen.catalog.contradiction import always, never
from sdgen.catalog.entry import Entry
from sdgen.catalog.limits import MAX_PLACEMENTS, MAX_PLACEMENTS_IN_ALL
from sdgen.catalog.records import Category, Hazard, HouseholdTemplate, PlaceRecipe, Recipe
from sdgen.catalog.terms.term import Case
from sdgen.vocabulary import FLAT_M


def check_recipes(entry: Entry, hazard: Hazard) -> None:
    """Note a predicate that holds of nothing or of everything, anomalies that could never be one,
    and lookalikes that always would be."""
    number = sum(map(placements, (*hazard.anomalies, *hazard.lookalikes)))
    if number > MAX_PLACEMENTS:
        text = f"its recipes stand for {number} placements; at most {MAX_PLACEMENTS} will do"
        entry.problem(text, "anomalies")
        return
    if reason := never(hazard.predicate):
        entry.problem(f"can never hold: {reason}", "predicate")
        return
    if always(hazard.predicate):
        entry.problem("always holds, whatever it is asked of", "predicate")
        return
    for index, recipe in enumerate(hazard.anomalies):
        for case in cases(recipe):
            if not hazard.predicate.possible(case).be_true:
                message = f"{_words(case)} can never satisfy the predicate"
                entry.problem(message, "anomalies", index)
    for index, recipe in enumerate(hazard.lookalikes):
        for case in cases(recipe):
            if not hazard.predicate.possible(case).be_false:
                message = f"{_words(case)} satisfies the predicate: it would be an anomaly"
                entry.problem(message, "lookalikes", index)


def check_among(
    entries: Mapping[str, Entry], hazards: Sequence[Hazard], categories: Sequence[Category]
) -> None:
    """Note predicates that normal homes satisfy, and lookalikes that surely are a hazard.

    Only what follows from recipes alone; a build's first tries find the rest. Anomalies may be
    several hazards at once.
    """
    number = 0
    for hazard in hazards:
        number += sum(map(placements, (*hazard.anomalies, *hazard.lookalikes)))
        if number > MAX_PLACEMENTS_IN_ALL:
            text = f"with it, all recipes stand for more than {MAX_PLACEMENTS_IN_ALL} placements"
            entries[hazard.id].problem(text, "anomalies")
            return
    may_be = _by_category(hazards, [c.name for c in categories])
    high = {c.name for c in categories if c.extents_max_m[2] > FLAT_M and c.kind != "structure"}
    normal = [c.name for c in categories if c.lives or c.kind == "furniture"]
    for hazard in hazards:
        entry = entries[hazard.id]
        always = [name for name in normal if not hazard.predicate.possible(Case(name)).be_false]
        if always:
            names = ", ".join(always[:3]) + (" ..." if len(always) > 3 else "")
            text = f"is true of every {names} wherever it is, and normal homes hold such"
            entry.problem(text, "predicate")
        for key, recipes in (("anomalies", hazard.anomalies), ("lookalikes", hazard.lookalikes)):
            for index, recipe in enumerate(recipes):
                for zones, raised in _raised(recipe, high):
                    text = f"{zones} are of floors and of what lies flat there: {raised} does not"
                    entry.problem(text, key, index, "target")
        for index, recipe in enumerate(hazard.lookalikes):
            for case in cases(recipe):
                for other in may_be[case.category]:
                    # What a pack claims of shipped recipes is no mistake in their files.
                    blamed = hazard.pack != "core" or other.pack == "core"
                    if other.id == hazard.id or not blamed:
                        continue
                    if not other.predicate.possible(case).be_false:
                        text = f"{_words(case)} satisfies the hazard {other.id!r}"
                        entry.problem(f"{text}: it would be an anomaly", "lookalikes", index)


def _by_category(hazards: Sequence[Hazard], categories: Sequence[str]) -> dict[str, list[Hazard]]:
    """The hazards that a thing can be at all, by its category: few of many."""
    return {
        name: [one for one in hazards if one.predicate.possible(Case(name)).be_true]
        for name in categories
    }


def _raised(recipe: Recipe, high: Collection[str]) -> Iterator[tuple[str, str]]:
    """Zones that a recipe asks for or avoids, and a target that is no floor to walk on."""
    if isinstance(recipe, PlaceRecipe):
        zones = recipe.zone or recipe.avoid_zones
        if zones:
            yield from ((", ".join(zones), name) for name in recipe.targets if name in high)


def check_choices(
    entries: Mapping[str, Entry], households: Sequence[HouseholdTemplate], hazards: Sequence[Hazard]
) -> None:
    """Note households that may choose not to hear of what nobody is silent about."""
    loud = {hazard.id for hazard in hazards if hazard.never_silent}
    for template in households:
        for hazard, choices in template.notifications.items():
            if hazard in loud and "silent" in choices:
                text = f"nobody is silent about {hazard} (never_silent): choose now or summary"
                entries[template.name].problem(text, "notifications", hazard)


def check_activities(
    entries: Mapping[str, Entry], activities: Sequence[Activity], hazards: Sequence[Hazard]
) -> None:
    """Note members of activities that would be an anomaly wherever they lie as asked for."""
    for activity in activities:
        entry, rooms = entries[activity.name], activity.rooms
        number = max(1, len(activity.at)) * sum(len(member.thing) for member in activity.members)
        if number > MAX_PLACEMENTS:
            text = f"its members stand for {number} placements; at most {MAX_PLACEMENTS} will do"
            entry.problem(text, "members")
            continue
        for index, member in enumerate(activity.members):
            if member.on or member.inside:
                continue
            for target in activity.at or ("floor",):
                for category in member.thing:
                    avoids = ("doorway", "walkway") if target == "floor" else ()
                    case = Case(category, member.state, rooms, "ON", target, (), avoids)
                    for hazard in hazards:
                        # What a pack claims of shipped activities is no mistake in their files.
                        blamed = entry.pack != "core" or hazard.pack == "core"
                        if blamed and not hazard.predicate.possible(case).be_false:
                            text = f"{_words(case)} satisfies the hazard {hazard.id!r}"
                            entry.problem(text, "members", index)


def _words(case: Case) -> str:
    """``vase ON desk``, or ``stove ON`` of what is set."""
    return f"{case.category} {case.relation or case.state} {case.target or ''}".rstrip()
