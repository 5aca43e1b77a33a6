"""Generated homes: a floor plan with openings, to be furnished by the rooms' rules."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from sdgen.catalog.records import Catalog, HomeMix, HomeSpec, OpeningSpec, RoomSpec
from sdgen.home.plan import Plan, plans_random
from sdgen.home.plan_openings import openings_random
from sdgen.rejection import Rejection, reject
from sdgen.seeding import Rng

#: Ceilings of flats: Germany's model building code (MBO, section 47) allows no less than 2.4 m.
HEIGHTS_M = (2.4, 2.5, 2.6, 2.7)
#: Mixes of rooms drawn for one home, and draws of the openings of one plan.
TRIES = 6
OPENING_TRIES = 4


@dataclass(frozen=True)
class Planned:
    """A floor plan of a mix of rooms, with its openings."""

    mix: HomeMix
    plan: Plan
    openings: tuple[OpeningSpec, ...]


def generate_home(
    home_id: str, mixes: Sequence[HomeMix], catalog: Catalog, rng: Rng
) -> HomeSpec | Rejection:
    """A home of one of these mixes of rooms; why the last of some tries was none."""
    planned = generate_plan(mixes, catalog, rng)
    if isinstance(planned, Rejection):
        return planned
    rooms = planned.plan.rooms
    return HomeSpec(
        id=home_id,
        title=f"generated home of {len(rooms)} rooms ({planned.mix.name})",
        kind="procedural",
        height_m=HEIGHTS_M[int(rng.integers(len(HEIGHTS_M)))],
        rooms=tuple(
            RoomSpec(name=room.name, type=room.type, rectangles_m=room.rectangles_m)
            for room in rooms
        ),
        openings=planned.openings,
    )


def generate_plan(mixes: Sequence[HomeMix], catalog: Catalog, rng: Rng) -> Planned | Rejection:
    """A floor plan of one of these mixes, drawn by weight; why the last of some tries was none."""
    last = reject("home", "no_floor_plan")
    weights = np.array([mix.weight for mix in mixes])
    for _ in range(TRIES):
        mix = mixes[int(rng.choice(len(weights), p=weights / weights.sum()))]
        plans = plans_random(mix, catalog.room_types, rng)
        found = next(_opened(plans, rng), None)
        if found is not None:
            return Planned(mix, *found)
        last = reject("home", "no_place", category="door") if plans else last
    return last


def _opened(plans: Sequence[Plan], rng: Rng) -> Iterator[tuple[Plan, tuple[OpeningSpec, ...]]]:
    """Those of these plans whose rooms all have their doors and windows, with them."""
    for plan in plans:
        for _ in range(OPENING_TRIES):
            openings = openings_random(plan, rng)
            if not isinstance(openings, Rejection):
                yield plan, openings
