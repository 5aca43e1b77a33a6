"""Light convex hulls for collision."""

from __future__ import annotations

import itertools
from collections.abc import Sequence

import numpy as np


def few_corners(points: np.ndarray, directions: int = 26) -> np.ndarray:
    """The extreme points in evenly spread directions."""
    k = np.arange(directions) + 0.5
    z, a = 1 - 2 * k / directions, np.pi * (1 + 5**0.5) * k
    rays = np.c_[np.cos(a) * np.sqrt(1 - z * z), np.sin(a) * np.sqrt(1 - z * z), z]
    return points[np.unique((points @ rays.T).argmax(0))]


def lying(points: Sequence, radius: float) -> list[np.ndarray]:
    """A piece for each stretch between two of the points, (x, y, z), of a cable that lies on
    z = 0."""
    around = [(a, b) for a in (-radius, radius) for b in (-radius, radius)]
    return [
        np.array([(p[0] + a, p[1] + b, z) for p in two for a, b in around for z in (0, 2 * radius)])
        for two in itertools.pairwise(points)
    ]
