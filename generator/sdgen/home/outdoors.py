"""Where a home lies and when it is seen: what its windows show. It decides no label."""

from __future__ import annotations

from sdgen.scene import Outdoors
from sdgen.seeding import Rng
from sdgen.vocabulary import SEASONS, WEATHERS

#: How often a home lies so high, by storey: about as flats and houses do.
STOREYS = {0: 0.45, 1: 0.2, 2: 0.15, 3: 0.1, 5: 0.1}
#: Worlds of each kind: enough that neighbours differ, few enough that each is painted but once.
VARIANTS = 3


def outdoors_random(rng: Rng) -> Outdoors:
    """Storey, season and weather of one home."""
    return Outdoors(
        storey=int(rng.choice(tuple(STOREYS), p=tuple(STOREYS.values()))),
        season=SEASONS[int(rng.integers(len(SEASONS)))],
        weather=WEATHERS[int(rng.integers(len(WEATHERS)))],
        variant=int(rng.integers(VARIANTS)),
    )
