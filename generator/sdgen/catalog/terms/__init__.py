"""The terms of the predicate language: one file a term, and their registry.

A new term is a file with a class that keeps to :class:`~sdgen.catalog.terms.term.Term`, and its
line in ``TERMS``.
"""

from __future__ import annotations

from functools import reduce
from operator import or_
from typing import TYPE_CHECKING, Annotated

from pydantic import Field

from sdgen.catalog.terms.above import AboveTerm
from sdgen.catalog.terms.category import CategoryTerm
from sdgen.catalog.terms.combine import AllTerm, AnyTerm, NotTerm
from sdgen.catalog.terms.count import CountTerm
from sdgen.catalog.terms.distance import DistanceTerm
from sdgen.catalog.terms.edge import EdgeTerm
from sdgen.catalog.terms.facing import FacingTerm
from sdgen.catalog.terms.facing_away import FacingAwayTerm
from sdgen.catalog.terms.height import HeightTerm
from sdgen.catalog.terms.holds import HoldsTerm
from sdgen.catalog.terms.overhang import OverhangTerm
from sdgen.catalog.terms.relation import RelationTerm
from sdgen.catalog.terms.room import RoomTerm
from sdgen.catalog.terms.state import StateTerm
from sdgen.catalog.terms.term import Term
from sdgen.catalog.terms.zone import ZoneTerm

#: YAML key (and ``kind`` in ``catalogue.json``) -> its term, in the order they are read.
TERMS: dict[str, type[Term]] = {
    "category": CategoryTerm,
    "state": StateTerm,
    "room": RoomTerm,
    "relation": RelationTerm,
    "height": HeightTerm,
    "distance": DistanceTerm,
    "zone": ZoneTerm,
    "facing": FacingTerm,
    "facing_away": FacingAwayTerm,
    "overhang": OverhangTerm,
    "edge": EdgeTerm,
    "above": AboveTerm,
    "count": CountTerm,
    "holds": HoldsTerm,
    "all": AllTerm,
    "any": AnyTerm,
    "not": NotTerm,
}

if TYPE_CHECKING:
    Predicate = Term
else:
    # What pydantic validates and writes follows from the registry; mypy knows it as a Term.
    Predicate = Annotated[reduce(or_, TERMS.values()), Field(discriminator="kind")]
    for nested in (AllTerm, AnyTerm, NotTerm):
        nested.model_rebuild(_types_namespace={"Predicate": Predicate})

__all__ = [
    "TERMS",
    "AboveTerm",
    "AllTerm",
    "AnyTerm",
    "CategoryTerm",
    "CountTerm",
    "DistanceTerm",
    "EdgeTerm",
    "FacingAwayTerm",
    "FacingTerm",
    "HeightTerm",
    "HoldsTerm",
    "NotTerm",
    "OverhangTerm",
    "Predicate",
    "RelationTerm",
    "RoomTerm",
    "StateTerm",
    "Term",
    "ZoneTerm",
]
