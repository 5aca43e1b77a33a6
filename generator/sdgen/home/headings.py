"""Which way round things are put."""

from __future__ import annotations

import math

from sdgen.seeding import Rng

#: By eye: so often a thing lies square to what is under it, give or take so many radians (about
#: 5 degrees, nobody measures); otherwise any way round.
SQUARE_CHANCE, SQUARE_SPREAD_RAD = 0.6, 0.08
#: What is looked at has its front the way that of its support faces, give or take so many radians
#: (17 degrees): by eye, a photo or a clock turned a little to where people sit or lie.
FRONT_SPREAD_RAD = 0.3


def random_yaw(rng: Rng, square_to: float = 0.0) -> float:
    """A heading: people put things roughly square to what is under them, or any way round."""
    if rng.random() < SQUARE_CHANCE:
        return float(square_to + rng.integers(4) * math.pi / 2 + rng.normal(0.0, SQUARE_SPREAD_RAD))
    return float(rng.uniform(-math.pi, math.pi))
