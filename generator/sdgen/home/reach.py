"""What must lie out of children's reach, and whether a spot does.

Everyday things and lookalikes that would be a hazard within reach are put where no child gets to
them, not even by climbing. Only proposed here: the facts of the settled scene prove it.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

import numpy as np

from sdgen.catalog.records import Catalog
from sdgen.catalog.terms import HeightTerm, StateTerm, Term
from sdgen.catalog.terms.term import Case
from sdgen.facts import Body
from sdgen.facts.reach import Climbs
from sdgen.home.layout import Vec3Yaw, corners_of
from sdgen.library.records import AssetInfo
from sdgen.library.states import rest_states

#: Room to settle, metres: less than every margin.
SLACK_M = 0.01


class Reach:
    """What children reach in a home as it is furnished."""

    def __init__(self, catalog: Catalog, furniture: Iterable[Body]) -> None:
        self._rules = [
            (hazard.predicate, _asked(hazard.predicate), max(limits))
            for hazard in catalog.hazards
            if hazard.concerns.by_reach and (limits := list(_limits(hazard.predicate)))
        ]
        bodies = list(furniture)
        self._climbs = Climbs(bodies, catalog.climbs)
        self._rooms = {body.item.id: (body.item.room_id,) for body in bodies}
        self._needed: dict[str, float | None] = {}

    def needed_m(self, asset: AssetInfo) -> float | None:
        """How high above where a child gets to stand a model must lie, as it comes, to be no
        hazard by reach; None where it never is one."""
        if asset.id not in self._needed:
            states = frozenset(rest_states(asset))
            self._needed[asset.id] = max(
                (
                    limit
                    for predicate, asked, limit in self._rules
                    if _concerned(predicate, asset.category, asked - states)
                ),
                default=None,
            )
        return self._needed[asset.id]

    def beyond(self, asset: AssetInfo, spot: Vec3Yaw, room_id: int) -> bool:
        """Whether a new thing at a spot is out of reach, if it needs to be."""
        needed = self.needed_m(asset)
        if needed is None:
            return True
        (x, y, z), yaw = spot
        if z < needed:
            return False
        corners = np.array(corners_of(asset, x, y, yaw))
        low = np.array([*corners.min(axis=0), z])
        high = np.array([*corners.max(axis=0), z + asset.extents_m[2]])
        # 0 is nobody's id.
        rooms = {**self._rooms, 0: (room_id,)}
        return self._climbs.heights(low, high, rooms, own=0).least_m >= needed


def _terms(term: Term) -> Iterator[Term]:
    yield term
    for inner in term.within():
        yield from _terms(inner)


def _limits(predicate: Term) -> Iterator[float]:
    """From how high on a predicate's height terms for reach surely do not hold."""
    for term in _terms(predicate):
        if isinstance(term, HeightTerm) and term.evidence == "reach_height_m" and term.max_m:
            yield term.max_m + term.margin_m + SLACK_M


def _asked(predicate: Term) -> frozenset[str]:
    """The states that a predicate asks for."""
    return frozenset(
        state for term in _terms(predicate) if isinstance(term, StateTerm) for state in term.any_of
    )


def _concerned(predicate: Term, category: str, not_state: frozenset[str]) -> bool:
    """Whether a predicate can hold of a thing of a category that is in none of these states."""
    return predicate.possible(Case(category, not_state=tuple(sorted(not_state)))).be_true
