"""All hollows of a scene, and INSIDE: the centre lies within a hollow's box."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping

import numpy as np

from sdgen.catalog.predicate import Related
from sdgen.facts.body import Body, rows
from sdgen.facts.thresholds import INSIDE_M


class Containers:
    """All hollows of a scene."""

    def __init__(self, bodies: Mapping[int, Body]) -> None:
        self._hollows = [hollow for body in bodies.values() for hollow in body.hollows]
        self._frames = rows([h.box_from_world for h in self._hollows], 4, 4)
        self._halves = rows([h.half for h in self._hollows], 3)

    def part_around(self, body: Body, owner: int) -> str | None:
        """The part of ``owner`` in whose hollow the object is deepest; None when in none."""
        there = [(depth, k) for k, depth in self._near(body) if self._hollows[k].owner == owner]
        return self._hollows[max(there)[1]].part if there else None

    def inside(self, body: Body) -> Iterable[Related]:
        """Hollows the object is INSIDE, or nearly: by owner, deepest first."""
        near = sorted(self._near(body), key=lambda one: (self._hollows[one[0]].owner, -one[1]))
        for index, depth in near:
            hollow = self._hollows[index]
            # A shelf's middle may lie in the jar that stands on it.
            if hollow.owner != body.item.id and (hollow.fixed or not body.item.fixed):
                yield Related(
                    hollow.owner,
                    hollow.category,
                    *INSIDE_M.at_least(depth),
                    {"inside_by_m": depth},
                    hollow.states,
                    hollow.undecided,
                )

    def _near(self, body: Body) -> list[tuple[int, float]]:
        """The hollows that the object's centre is in, or nearly, and how deep."""
        local = np.abs(self._frames[:, :3, :3] @ body.center + self._frames[:, :3, 3])
        depths = (self._halves - local).min(axis=1, initial=math.inf)
        return [(int(k), float(depths[k])) for k in np.flatnonzero(depths > INSIDE_M.below)]
