"""Generated homes: a floor plan with openings, to be furnished by the rooms' rules."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from sdgen.catalog.records import Catalog, HomeMix, HomeSpec, RoomSpec
from sdgen.home.plan import plan_random
from sdgen.home.plan_openings import openings_random
from sdgen.rejection import Rejection, reject
from sdgen.seeding import Rng

#: Ceilings of flats: Germany's model building code (MBO, section 47) allows no less than 2.4 m.
HEIGHTS_M = (2.4, 2.5, 2.6, 2.7)
#: Mixes of rooms drawn for one home; of 150 homes 145 came of the first, one of the third.
TRIES = 6


def generate_home(
    home_id: str, mixes: Sequence[HomeMix], catalog: Catalog, rng: Rng
) -> HomeSpec | Rejection:
    """A home of one of these mixes of rooms; why the last of some tries was none."""
    last = reject("home", "no_floor_plan")
    weights = np.array([mix.weight for mix in mixes])
    for _ in range(TRIES):
        mix = mixes[int(rng.choice(len(weights), p=weights / weights.sum()))]
        plan = plan_random(mix, catalog.room_types, rng)
        if plan is None:
            last = reject("home", "no_floor_plan")
            continue
        openings = openings_random(plan, rng)
        if isinstance(openings, Rejection):
            last = openings
            continue
        return HomeSpec(
            id=home_id,
            title=f"generated home of {len(plan.rooms)} rooms ({mix.name})",
            kind="procedural",
            height_m=HEIGHTS_M[int(rng.integers(len(HEIGHTS_M)))],
            rooms=tuple(
                RoomSpec(name=room.name, type=room.type, rectangles_m=room.rectangles_m)
                for room in plan.rooms
            ),
            openings=openings,
        )
    return last
