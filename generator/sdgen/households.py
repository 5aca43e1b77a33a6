"""Who lives in a home, and whether they want to hear of a hazard.

Predicates never read a household: what is an anomaly follows from the scene, ``report`` and
``notify`` follow from the household here.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
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


class Decision(NamedTuple):
    """Whether a household wants an anomaly reported, how, and why (one sentence)."""

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
            Member(role=role, age=age)
            for (role, _, _), age in zip(template.members, ages, strict=True)
        ),
        pets=tuple(pets),
        conditions=tuple(conditions),
        notifications=dict(notifications or {}),
    )


def sample_household(catalog: Catalog, rng: Rng) -> Household:
    """A household of a random template. ``rng``: a lane of its own."""
    weights = np.array([template.weight for template in catalog.households])
    index = int(rng.choice(len(weights), p=weights / weights.sum()))
    template = catalog.households[index]
    return household_from(
        template,
        ages=[int(rng.integers(least, most + 1)) for _, least, most in template.members],
        pets=[pet for pet in template.pets if rng.random() < OPTIONAL_SHARE],
        conditions=[item for item in template.conditions if rng.random() < OPTIONAL_SHARE],
        notifications={
            hazard: choices[int(rng.integers(len(choices)))]
            for hazard, choices in sorted(template.notifications.items())
        },
    )


def reach_at(age: int, reach: Sequence[ReachRow]) -> float:
    """How high a child of this age grasps things, metres; infinite beyond the table."""
    for row in sorted(reach, key=lambda row: row.max_age):
        if age <= row.max_age:
            return row.reach_m
    return float("inf")


def decide(
    hazard: Hazard,
    evidence: Mapping[str, EvidenceValue],
    household: Household,
    reach: Sequence[ReachRow],
) -> Decision:
    """Whether this household wants an anomaly of ``hazard`` reported.

    First whom it concerns (everyone, or children who are young enough and, where the hazard
    says so, tall enough to reach ``evidence["reach_height_m"]``), then the household's own
    choice for the hazard, else the default of its urgency.
    """
    concerned, reason = _concerned(hazard, evidence, household, reach)
    if not concerned:
        return Decision(False, "silent", reason)
    chosen = household.notifications.get(hazard.id)
    if chosen == "silent":
        return Decision(False, "silent", f"{reason}; the household does not want to hear of it")
    if chosen is not None:
        return Decision(True, chosen, f"{reason}; the household chose {chosen!r}")
    notify = DEFAULT_NOTIFY[hazard.urgency]
    return Decision(True, notify, f"{reason}; {notify!r} by default at {hazard.urgency} urgency")


def _concerned(
    hazard: Hazard,
    evidence: Mapping[str, EvidenceValue],
    household: Household,
    reach: Sequence[ReachRow],
) -> tuple[bool, str]:
    concern, oldest = hazard.concerns, hazard.concerns.max_age
    if oldest is None:  # a concern of children has their age
        return True, "it concerns everyone"
    ages = sorted(member.age for member in household.members if member.age <= oldest)
    if not ages:
        return False, f"nobody in the household is {oldest} or younger"
    if not concern.by_reach:
        return True, f"a child of {ages[0]} lives here"
    height = evidence.get("reach_height_m")
    if not isinstance(height, int | float):
        raise ValueError(f"{hazard.id}: evidence has no reach_height_m")
    shown = round(height, 2) + 0.0  # settled a hair into the floor, it still is at 0.00 m
    able = [age for age in ages if reach_at(age, reach) >= height]
    if not able:
        best = reach_at(ages[-1], reach)
        return (
            False,
            f"at {shown:.2f} m it is above the {best:.2f} m a child of {ages[-1]} reaches",
        )
    at = reach_at(able[0], reach)
    return True, f"a child of {able[0]} reaches {at:.2f} m and it is at {shown:.2f} m"
