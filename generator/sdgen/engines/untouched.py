"""Which hazards are true of the furniture alone, before anything is put or switched?

Whatever satisfies a predicate is an anomaly, whoever put it there: in a home whose furniture does
so as it stands, or might (a verdict in doubt), every scene is rejected, whatever it is to show.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterator

from sdgen.catalog.records import Catalog, Category, Hazard
from sdgen.catalog.terms.term import Case
from sdgen.hazards.certify import categories_of, survey
from sdgen.home.furnish import may_stand
from sdgen.library import Library
from sdgen.pipeline.furnished import FurnishedHome
from sdgen.scene import ObjectInstance, Pose

#: A hazard must leave at least half of the homes: each lost one costs a scene up to twenty tries,
#: and the other hazards that it is asked for must find their places in what is left.
MOST_LOST = 0.5

_POSE = Pose(position_m=(0.0, 0.0, 0.0), quat_xyzw=(0.0, 0.0, 0.0, 1.0))


class Untouched:
    """Counts, over furnished homes, those that a hazard makes useless."""

    def __init__(self, catalog: Catalog, library: Library) -> None:
        self._catalog = catalog
        self.at_risk = at_risk(catalog, library)
        self._homes = 0
        self._true: Counter[str] = Counter()
        self._in_doubt: Counter[str] = Counter()
        self._of: dict[str, Counter[str]] = {}

    def look(self, home: FurnishedHome) -> frozenset[str]:
        """Take in a home; the hazards that its furniture satisfies or may satisfy."""
        found: dict[str, bool] = {}
        concerned: set[tuple[str, str]] = set()
        for positive in survey(home.facts, self._catalog).positives:
            sure = positive.verdict.sure
            found[positive.hazard] = found.get(positive.hazard, False) or sure
            concerned.add((positive.hazard, home.layout.items[positive.object_id].category))
        self._homes += 1
        for hazard, sure in found.items():
            (self._true if sure else self._in_doubt)[hazard] += 1
        for hazard, category in sorted(concerned):
            self._of.setdefault(hazard, Counter())[category] += 1
        return frozenset(found)

    def problems(self) -> dict[str, str]:
        """By hazard, what to say of those that leave too few homes."""
        return {name: self._line(name) for name in self._seen() if self._lost(name) > MOST_LOST}

    def warnings(self) -> dict[str, str]:
        """By hazard, what to say of those that cost some homes."""
        return {name: self._line(name) for name in self._seen() if self._lost(name) <= MOST_LOST}

    def _seen(self) -> list[str]:
        return sorted(self._of)

    def _lost(self, hazard: str) -> float:
        return (self._true[hazard] + self._in_doubt[hazard]) / self._homes

    def _line(self, hazard: str) -> str:
        true, in_doubt = self._true[hazard], self._in_doubt[hazard]
        counts = [
            f"{word} of furniture ({', '.join(sorted(self._of[hazard])[:6])}) in {count}"
            for word, count in (("true", true), ("in doubt", in_doubt))
            if count
        ]
        return (
            f"hazard {hazard!r} is {' and '.join(counts)} of {self._homes} homes before anything "
            "is done; such homes are rejected: narrow its predicate to what homes do not hold"
        )


def at_risk(catalog: Catalog, library: Library) -> frozenset[str]:
    """Hazards that furniture, in a state it stands in, may satisfy as far as categories and states
    tell; the others need no home to be cleared."""
    standing = {c.name: c for c in catalog.categories if c.kind in ("furniture", "opening")}
    states_of = library.states_by_category()
    return frozenset(
        hazard.id
        for hazard in catalog.hazards
        if any(
            _possible(hazard, name, states, states_of.get(name, ()))
            for name in sorted(_names(hazard, standing))
            for states in sorted(stands(standing[name], library))
        )
    )


def _names(hazard: Hazard, standing: dict[str, Category]) -> set[str]:
    concerned = categories_of(hazard.predicate)
    return set(standing) if concerned is None else set(standing).intersection(concerned)


def _possible(
    hazard: Hazard, category: str, states: tuple[str, ...], known: Collection[str]
) -> bool:
    others = tuple(sorted(set(known).difference(states)))
    cases = [Case(category, state, not_state=others) for state in states or (None,)]
    return all(hazard.predicate.possible(case).be_true for case in cases)


def stands(category: Category, library: Library) -> Iterator[tuple[str, ...]]:
    """The states that homes leave such furniture in, whatever its model."""
    for asset in library.by_category(category.name):
        item = ObjectInstance(
            id=0, category=category.name, asset=asset.id, pose=_POSE, room_id=0, fixed=True
        )
        yield from may_stand(item, asset, category)
