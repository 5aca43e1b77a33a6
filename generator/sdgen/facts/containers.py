"""Hollows things are inside of, and INSIDE: the centre lies within a hollow's box.

The state that counts for a thing inside is that of the very leaf that shuts its hollow: a thing
in the sink's basin is not shut in by the cupboard door below.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from typing import NamedTuple

import numpy as np

from sdgen.catalog.predicate import Related
from sdgen.facts.body import Body, rows
from sdgen.facts.thresholds import INSIDE_M
from sdgen.geometry import Array, apply, inverse
from sdgen.library.states import object_from_part, rule_holds


class Hollow(NamedTuple):
    """A box in the world that things can be in, and the states of the leaf that shuts it."""

    owner: int
    category: str
    box_from_world: Array
    half: Array
    states: tuple[str, ...]
    undecided: tuple[str, ...]


class Containers:
    """All hollows of a scene."""

    def __init__(self, bodies: Mapping[int, Body]) -> None:
        self._hollows = [hollow for body in bodies.values() for hollow in _hollows(body)]
        self._frames = rows([h.box_from_world for h in self._hollows], 4, 4)
        self._halves = rows([h.half for h in self._hollows], 3)

    def inside(self, body: Body) -> Iterable[Related]:
        """Hollows the object is INSIDE, or nearly: by owner, deepest first."""
        local = np.abs(self._frames[:, :3, :3] @ body.center + self._frames[:, :3, 3])
        depths = (self._halves - local).min(axis=1, initial=math.inf)
        near = [int(k) for k in np.flatnonzero(depths > INSIDE_M.below)]
        for index in sorted(near, key=lambda k: (self._hollows[k].owner, -depths[k])):
            hollow, depth = self._hollows[index], float(depths[index])
            if hollow.owner != body.item.id:
                yield Related(
                    hollow.owner,
                    hollow.category,
                    *INSIDE_M.at_least(depth),
                    {"inside_by_m": depth},
                    hollow.states,
                    hollow.undecided,
                )


def _hollows(body: Body) -> Iterable[Hollow]:
    drawn = body.info.variants[body.item.variant]
    for container in body.info.containers:
        if container.part in drawn:
            moved = body.world_from_object @ object_from_part(
                body.info, container.part, body.item.joints
            )
            moved[:3, 3] = apply(moved, [container.center_m])[0]
            half = np.asarray(container.size_m) / 2
            leaf = _leaf_states(body, container.closed_by)
            yield Hollow(body.item.id, body.item.category, inverse(moved), half, *leaf)


def _leaf_states(body: Body, joint: str | None) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """States of the leaf that shuts one container, and those it is too near to call."""
    if joint is None:
        return (), ()
    rules = [rule for rule in body.info.states if rule.joint == joint]
    holding = [r.state for r in rules if rule_holds(r, body.item.variant, body.item.joints)]
    return tuple(holding), () if holding else tuple(r.state for r in rules)
