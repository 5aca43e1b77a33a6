"""Who lives in a home, and whether they want to hear of a hazard.

Predicates never read a household: what is an anomaly follows from the scene, ``report`` and
``notify`` follow from the household here.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from sdgen.catalog.records import (
    Catalog,
    Category,
    Hazard,
    HouseholdTemplate,
    PlaceRecipe,
    ReachRow,
    Recipe,
    Trait,
)
from sdgen.scene import EvidenceValue, Household, Member, Notify
from sdgen.seeding import Rng
from sdgen.vocabulary import Urgency

#: Of the scenes with a hazard that concerns who lives with some pet or condition, so many are of
#: households that do, where there are such: both sides are common then, and no label depends on it.
WISHED_SHARE = 0.5

#: How a hazard is notified when the household made no choice of its own. A judgement: only of low
#: urgency is what may wait till the day's summary, and an interruption for it would cost more.
DEFAULT_NOTIFY: Mapping[Urgency, Notify] = {"high": "now", "medium": "now", "low": "summary"}

#: Said to be on the floor: lower, metres, than anything a thing lies on.
ON_FLOOR_M = 0.02


class Decision(NamedTuple):
    """Whether a household wants an anomaly reported, how, and why (a sentence)."""

    report: bool
    notify: Notify
    reason: str


def household_from(
    template: HouseholdTemplate,
    ages: Sequence[int],
    pets: Sequence[str] = (),
    conditions: Sequence[str] = (),
    notifications: Mapping[str, Notify] | None = None,
    opt_outs: Sequence[str] = (),
) -> Household:
    """A household of a template with everything decided; ``ages`` follow ``template.members``."""
    return Household(
        template=template.name,
        members=tuple(
            Member(role=rule.role, age=age)
            for rule, age in zip(template.members, ages, strict=True)
        ),
        pets=tuple(pets),
        conditions=tuple(conditions),
        notifications=dict(notifications or {}),
        opt_outs=tuple(opt_outs),
    )


def draw_template(
    catalog: Catalog, rng: Rng, may: Callable[[HouseholdTemplate], bool] = lambda _: True
) -> HouseholdTemplate:
    """A template by the weights of those that ``may`` be (of all, where none may). ``rng``: a lane
    of its own."""
    among = [template for template in catalog.households if may(template)] or catalog.households
    weights = np.array([template.weight for template in among])
    return among[int(rng.choice(len(weights), p=weights / weights.sum()))]


def wished_traits(
    hazards: Iterable[Hazard], categories: Iterable[Category], rng: Rng
) -> tuple[str, ...]:
    """The pets and conditions of which a household is to have one, for the sake of the drawn
    hazards: in half of all scenes those that concern who lives with them, and wherever all that a
    hazard puts belongs to such, these: nobody has a bowl and no pet. ``rng``: a lane of its own."""
    drawn = list(hazards)
    belongs = {one.name: one.belongs_to for one in categories}
    wished = {word for hazard in drawn for word in hazard.concerns.living_with}
    if rng.random() >= WISHED_SHARE:
        wished = set()
    needed = {
        word
        for hazard in drawn
        if all(_owned(recipe, belongs) for recipe in hazard.anomalies)
        for recipe in hazard.anomalies
        for name in recipe.categories
        for word in belongs[name]
    }
    return tuple(sorted(needed or wished))


def _owned(recipe: Recipe, belongs: Mapping[str, Collection[str]]) -> bool:
    """Whether all that a recipe puts somewhere belongs to somebody, or to some pet."""
    return isinstance(recipe, PlaceRecipe) and all(belongs[name] for name in recipe.categories)


def sample_household(
    catalog: Catalog, template: HouseholdTemplate, rng: Rng, wished: Collection[str] = ()
) -> Household:
    """A household of a template. ``rng``: a lane of its own.

    A pet or a condition that matters to nothing in the catalogue is never drawn; of the ``wished``
    ones that the template may have it has one at least.
    """
    matters = _matters(catalog)
    may = [name for name in template.traits if name in wished and name in matters]
    must = may[int(rng.integers(len(may)))] if may else None

    def has(trait: Trait) -> bool:
        return (rng.random() < trait.share or trait.name == must) and trait.name in matters

    return household_from(
        template,
        ages=_ages(template, rng),
        pets=[trait.name for trait in template.pets if has(trait)],
        conditions=[trait.name for trait in template.conditions if has(trait)],
        notifications={
            hazard: choices[int(rng.integers(len(choices)))]
            for hazard, choices in sorted(template.notifications.items())
        },
        opt_outs=[one.name for one in template.opt_outs if rng.random() < one.share],
    )


def _ages(template: HouseholdTemplate, rng: Rng) -> list[int]:
    """An age for every member, each beside the one before."""
    ages: list[int] = []
    for rule in template.members:
        least, most = rule.ages(ages[-1] if ages else None)
        ages.append(int(rng.integers(least, most + 1)))
    return ages


def _matters(catalog: Catalog) -> set[str]:
    """The pets and conditions that raise a hazard, or bring things along."""
    raising = (rule for hazard in catalog.hazards for rule in hazard.concerns.raised_by)
    owned = (category.belongs_to for category in catalog.categories)
    concerned = (hazard.concerns.living_with for hazard in catalog.hazards)
    named = (*(r.living_with for r in raising), *owned, *concerned)
    return {word for words in named for word in words}


def reach_at(age: int, reach: Sequence[ReachRow]) -> float:
    """How high a child of this age grasps things, metres; infinite beyond the table."""
    row = _row_of(age, reach)
    return float("inf") if row is None else row.reach_m


def _row_of(age: int, reach: Sequence[ReachRow]) -> ReachRow | None:
    rows = (row for row in sorted(reach, key=lambda row: row.max_age) if age <= row.max_age)
    return next(rows, None)


def decide(
    hazard: Hazard,
    evidence: Mapping[str, EvidenceValue],
    household: Household,
    reach: Sequence[ReachRow],
    room: str = "",
) -> Decision:
    """Whether this household wants an anomaly of ``hazard`` in a room of this type reported.

    First whom it concerns: everyone; children who are young enough and, where the hazard says so,
    tall enough to reach ``evidence["reach_height_m"]``; people who are old enough; who lives with
    a pet or a condition; and of these, where the hazard names rooms, in those alone. A pet or a
    condition that it is ``raised_by`` makes it a matter of ``now``, whatever else holds. Who has
    opted out of it, or of its group, hears nothing of what is not ``never_silent``. Otherwise
    the household's own choice for the hazard (of which there is none to be silent about what is
    ``never_silent``), else the default of its urgency.
    """
    concerned, reason = _concerned(hazard, evidence, household, reach)
    if concerned and hazard.concerns.rooms and room not in hazard.concerns.rooms:
        rooms = " or ".join(name.replace("_", " ") for name in hazard.concerns.rooms)
        concerned, reason = False, f"It would concern them in the {rooms} alone"
    for_whom = _raised(hazard, household)
    if for_whom is not None:
        joint = "and" if concerned else "but"
        return Decision(
            True, "now", f"{reason}, {joint} {for_whom}: the household is told at once."
        )
    if not concerned:
        return Decision(False, "silent", f"{reason}.")
    for out in household.opt_outs:
        if out in (hazard.id, hazard.group) and not hazard.never_silent:
            of = hazard.group.replace("_", " ") if out == hazard.group else "this"
            return Decision(False, "silent", f"{reason}, but the household opted out of {of}.")
    chosen = household.notifications.get(hazard.id)
    if chosen == "silent" and hazard.never_silent:
        chosen = None
    if chosen is not None:
        return Decision(chosen != "silent", chosen, f"{reason}, {_CHOSEN[chosen]}.")
    return Decision(True, DEFAULT_NOTIFY[hazard.urgency], f"{reason}, {_DEFAULT[hazard.urgency]}.")


_CHOSEN: Mapping[Notify, str] = {
    "now": "and the household wants to be told at once",
    "summary": "and the household wants it in the summary of the day",
    "silent": "but the household does not want to hear of it",
}
_DEFAULT: Mapping[Urgency, str] = {
    "high": "and it is too urgent to wait",
    "medium": "and they are told as soon as it is seen",
    "low": "and it can wait for the summary of the day",
}


def _raised(hazard: Hazard, household: Household) -> str | None:
    """Which pet or which member the hazard is raised by, in words; None when by nobody."""
    for rule in hazard.concerns.raised_by:
        found = _living_with(rule.living_with, household)
        if found is not None:
            return found
    return None


def _living_with(traits: Collection[str], household: Household) -> str | None:
    """Which of these pets and conditions a household has, in words: its first."""
    for pet in household.pets:
        if pet in traits:
            return f"a {pet} lives here"
    for condition in household.conditions:
        if condition in traits:
            return f"somebody who lives here {condition}"
    return None


def _concerned(
    hazard: Hazard,
    evidence: Mapping[str, EvidenceValue],
    household: Household,
    reach: Sequence[ReachRow],
) -> tuple[bool, str]:
    """Whether a hazard concerns somebody of the household, and why, but for the full stop."""
    concern, oldest = hazard.concerns, hazard.concerns.max_age
    if concern.who == "living_with":
        found = _living_with(concern.living_with, household)
        if found is None:
            return False, f"It concerns who lives with this alone: {', '.join(concern.living_with)}"
        return True, found[0].upper() + found[1:]
    if concern.min_age is not None:
        old = sorted(member.age for member in household.members if member.age >= concern.min_age)
        if not old:
            return False, f"Nobody who lives here is {concern.min_age} or older"
        return True, f"Somebody of {old[-1]} lives here"
    if oldest is None:  # a concern of children has their age
        return True, "It concerns everyone who lives here"
    ages = sorted(member.age for member in household.members if member.age <= oldest)
    if not ages:
        younger = f"{oldest} or younger" if oldest else "under one"
        return False, f"Nobody who lives here is {younger}"
    if not concern.by_reach:
        return True, f"{_child(ages[0]).capitalize()} lives here"
    height = evidence.get("reach_height_m")
    if not isinstance(height, int | float):
        raise ValueError(f"{hazard.id}: evidence has no reach_height_m")
    # Where something stands beside it to climb on, its height above the floor is there, too.
    above_floor = evidence.get("height_m", height)
    if not isinstance(above_floor, int | float):
        raise ValueError(f"{hazard.id}: height_m of the evidence is no number")
    on_floor = above_floor < ON_FLOOR_M
    lies = "lies on the floor" if on_floor else f"lies at {above_floor:.2f} m"

    def needed(age: int) -> float:
        row = _row_of(age, reach)
        return height if row is None or row.climbs else above_floor

    able = [age for age in ages if reach_at(age, reach) >= needed(age)]
    age = able[0] if able else ages[-1]
    at = reach_at(age, reach)
    climbed = above_floor - needed(age) >= ON_FLOOR_M
    if not able:
        what = f"{lies}, {height:.2f} m above what stands beside it" if climbed else lies
        return False, f"It {what}, above the {at:.2f} m that {_child(age)} reaches"
    high = f"{at:.2f} m high" if at < float("inf") else "as high as a grown-up"
    # Said only where it matters: most things are low enough to take from the floor.
    if climbed and at < above_floor:
        high += f", from what it climbs on {above_floor - height:.2f} m higher"
    return True, f"{_child(age).capitalize()} reaches {high}, it {lies}"


def _child(age: int) -> str:
    return f"a child of {age}" if age else "a baby"
