"""Light convex hulls for collision."""

from __future__ import annotations

import numpy as np


def few_corners(points: np.ndarray, directions: int = 26) -> np.ndarray:
    """The extreme points in evenly spread directions."""
    k = np.arange(directions) + 0.5
    z, a = 1 - 2 * k / directions, np.pi * (1 + 5**0.5) * k
    rays = np.c_[np.cos(a) * np.sqrt(1 - z * z), np.sin(a) * np.sqrt(1 - z * z), z]
    return points[np.unique((points @ rays.T).argmax(0))]
