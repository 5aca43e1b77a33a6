"""Small helpers to draw parameters from an explicit numpy Generator."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeVar

import numpy as np

T = TypeVar("T")


def pick(rng: np.random.Generator, choices: Sequence[T]) -> T:
    """One of `choices`, uniformly (repeat an entry to make it likelier)."""
    return choices[int(rng.integers(len(choices)))]


def uniform(rng: np.random.Generator, low: float, high: float) -> float:
    """A plain float between low and high."""
    return float(rng.uniform(low, high))


def seed_of(rng: np.random.Generator) -> int:
    """A seed to hand to a deterministic maker for its noise."""
    return int(rng.integers(1_000_000_000))


def noise_offset(rng: np.random.Generator) -> tuple[float, float, float]:
    """A random place in noise space, so that no two models share their mottling."""
    return tuple(float(x) for x in rng.uniform(-50, 50, 3))
