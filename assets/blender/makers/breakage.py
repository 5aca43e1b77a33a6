"""Broken variants of vessels."""

from __future__ import annotations

import math

import numpy as np
from toolkit.fracture import fracture, scatter
from toolkit.materials import Material
from toolkit.model import (
    Part,
)

BROKEN = [{"state": "BROKEN", "variants": ["broken"], "parts": ["shards"]}]


def broken(
    meshes,
    raw: Material,
    seeds,
    base_weight: float,
    seed: int,
    rgba=None,
    roughness=0.003,
    edge=0.03,
) -> Part:
    """The shards of a vessel: the first seed's piece stays standing, the others lie around it."""
    weights = [base_weight] + [0.0] * (len(seeds) - 1)
    shards = fracture(meshes, seeds, raw, weights, seed, roughness, edge)
    pieces = scatter(shards, np.random.default_rng(seed))
    return Part(shards, collision=pieces, rgba=rgba)


def wall_seeds(radius: float, height: float, count: int, rng) -> list[tuple[float, float, float]]:
    """Points for shards: one low in the middle, the others round the wall at various heights."""
    turn = rng.uniform(0, 2 * math.pi)
    seeds = [(-0.4 * radius * math.cos(turn), -0.4 * radius * math.sin(turn), height * 0.12)]
    for i in range(count):
        a = turn + 2 * math.pi * (i + rng.normal(0, 0.12)) / count
        z = height * (0.9 if i % 2 else 0.55)
        seeds.append((radius * 1.1 * math.cos(a), radius * 1.1 * math.sin(a), z))
    return seeds
