"""Who lives in a home, and whether they want to hear of a hazard.

Predicates never read a household: what is an anomaly follows from the scene, ``report`` and
``notify`` follow from the household here.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from sdgen.catalog.records import Catalog, Hazard, HouseholdTemplate, ReachRow
from sdgen.scene import EvidenceValue, Household, Member, Notify
from sdgen.seeding import Rng
from sdgen.vocabulary import Urgency

#: Chance that a household has a pet or a condition its template allows. Not counted anywhere, but
#: chosen: both sides are equally common in a data set, and no label depends on it.
OPTIONAL_SHARE = 0.5

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
    )


def draw_template(
    catalog: Catalog, rng: Rng, may: Callable[[HouseholdTemplate], bool] = lambda _: True
) -> HouseholdTemplate:
    """A template by the weights of those that ``may`` be (of all, where none may). ``rng``: a lane
    of its own."""
    among = [template for template in catalog.households if may(template)] or catalog.households
    weights = np.array([template.weight for template in among])
    return among[int(rng.choice(len(weights), p=weights / weights.sum()))]


def sample_household(catalog: Catalog, template: HouseholdTemplate, rng: Rng) -> Household:
    """A household of a template. ``rng``: a lane of its own.

    A pet or a condition that matters to nothing in the catalogue is never drawn.
    """
    matters = _matters(catalog)
    return household_from(
        template,
        ages=_ages(template, rng),
        pets=[p for p in template.pets if rng.random() < OPTIONAL_SHARE and p in matters],
        conditions=[
            item
            for item in template.conditions
            if rng.random() < OPTIONAL_SHARE and item in matters
        ],
        notifications={
            hazard: choices[int(rng.integers(len(choices)))]
            for hazard, choices in sorted(template.notifications.items())
        },
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
    return {word for words in (*(r.living_with for r in raising), *owned) for word in words}


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
) -> Decision:
    """Whether this household wants an anomaly of ``hazard`` reported.

    First whom it concerns: everyone, or children who are young enough and, where the hazard says
    so, tall enough to reach ``evidence["reach_height_m"]``. A pet or a condition that it is
    ``raised_by`` makes it a matter of ``now``, whatever else holds. Otherwise the household's own
    choice for the hazard (of which there is none to be silent about what is ``never_silent``),
    else the default of its urgency.
    """
    concerned, reason = _concerned(hazard, evidence, household, reach)
    for_whom = _raised(hazard, household)
    if for_whom is not None:
        joint = "and" if concerned else "but"
        return Decision(
            True, "now", f"{reason}, {joint} {for_whom}: the household is told at once."
        )
    if not concerned:
        return Decision(False, "silent", f"{reason}.")
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
        for pet in household.pets:
            if pet in rule.living_with:
                return f"a {pet} lives here"
        for condition in household.conditions:
            if condition in rule.living_with:
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
