"""A data set's labels against another catalogue: what would be labelled, were it built with that?

Nothing moves: the predicates of the other catalogue are evaluated on the poses as they are stored.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from contextlib import closing
from dataclasses import dataclass
from typing import Literal

from sdgen.catalog.records import Catalog
from sdgen.dataset import Dataset, SceneItem
from sdgen.dataset.derived import derived_from
from sdgen.engines.in_order import in_order
from sdgen.errors import InputError, SceneRejected
from sdgen.hazards.certify import facts_of, survey
from sdgen.validate.run import OnScene
from sdgen.validate.scenes import WORTH_WORKERS

#: ``lost``: labelled, and does not hold; ``new``: holds, and is not labelled; ``undecided``: lies
#: so near a threshold that nobody can say, labelled or not.
Change = Literal["lost", "new", "undecided"]
CHANGES: tuple[Change, ...] = ("lost", "new", "undecided")
IN_WORDS = {
    "lost": "is labelled and does not hold",
    "new": "holds and is not labelled",
    "undecided": "lies within a dead band",
}


@dataclass(frozen=True)
class Changed:
    """One pair of object and hazard about which a catalogue says otherwise than the labels."""

    scene: str
    object_id: int
    category: str
    hazard: str
    change: Change

    def __str__(self) -> str:
        thing = f"object {self.object_id} ({self.category})"
        return f"scenes/{self.scene}: {thing}, {self.hazard}: {IN_WORDS[self.change]}"


@dataclass(frozen=True)
class SceneAgain:
    """What another catalogue says of a scene: pairs that changed, the hazards of those that stayed
    (by number), and how many objects it has no category for; or why the scene cannot be read."""

    changed: tuple[Changed, ...] = ()
    kept: tuple[tuple[str, int], ...] = ()
    foreign: tuple[tuple[str, int], ...] = ()
    problems: tuple[str, ...] = ()


@dataclass(frozen=True)
class Recertified:
    """What another catalogue says of a data set.

    ``kept`` counts labels that still hold, by hazard; ``foreign`` objects of categories that the
    catalogue does not define; ``redefined`` are categories that it describes in another way;
    ``problems`` are of files that could not be read.
    """

    scenes: int
    changed: tuple[Changed, ...]
    kept: Counter[str]
    foreign: Counter[str]
    redefined: tuple[str, ...]
    problems: tuple[str, ...]

    @property
    def certifies(self) -> bool:
        """True when each label holds, and nothing else does or may."""
        return not (self.changed or self.foreign or self.problems)

    def by_hazard(self) -> dict[str, dict[str, int]]:
        """How many pairs of each hazard stayed, and how many changed in which way."""
        names = sorted({*self.kept, *(one.hazard for one in self.changed)})
        out = {name: {"kept": self.kept[name], **dict.fromkeys(CHANGES, 0)} for name in names}
        for one in self.changed:
            out[one.hazard][one.change] += 1
        return out


def recertify(
    data: Dataset, catalog: Catalog, on_scene: OnScene | None = None, workers: int = 1
) -> Recertified:
    """Evaluate the predicates of ``catalog`` in every scene of a data set, twins too.

    Zones are those that are stored: they follow from the properties that the data set's own
    catalogue gives its furniture. Raises InputError where the data set cannot be opened.
    """
    found: list[SceneAgain] = []
    total = len(data.entries)
    _ = data.infos
    args, workers = (str(data.path), catalog), workers if total >= WORTH_WORKERS else 1
    with closing(in_order(_Again, args, total, workers)) as outcomes:
        for outcome in outcomes:
            if isinstance(outcome.error, SceneRejected):
                text = f"scenes/{data.entries[outcome.job].id}: workers end at it"
                found.append(SceneAgain(problems=(text,)))
            elif outcome.error is not None:
                raise outcome.error
            else:
                found.append(outcome.result)
            if on_scene is not None:
                on_scene(len(found), total)
    return Recertified(
        scenes=total,
        changed=tuple(one for again in found for one in again.changed),
        kept=_sum(again.kept for again in found),
        foreign=_sum(again.foreign for again in found),
        redefined=_redefined(data.catalog, catalog),
        problems=tuple(text for again in found for text in again.problems),
    )


class _Again:
    """Looks at scenes by their place in the manifest."""

    def __init__(self, path: str, catalog: Catalog) -> None:
        self._data = Dataset(path, partial=True)
        self._catalog = catalog

    def __call__(self, index: int) -> SceneAgain:
        item = SceneItem(self._data.path, self._data.entries[index], checked=False)
        try:
            with derived_from(self._data, item):
                return _again(self._data, item, self._catalog)
        except InputError as error:
            return SceneAgain(problems=error.problems)

    def close(self) -> None:
        """Nothing to let go of."""


def _again(data: Dataset, item: SceneItem, catalog: Catalog) -> SceneAgain:
    known = {category.name for category in catalog.categories}
    category = {thing.id: thing.category for thing in item.scene.objects}
    labelled = {(one.object_id, one.hazard) for one in item.anomalies.anomalies}
    positives = survey(facts_of(item.scene, data.infos, catalog), catalog).positives
    sure = {(one.object_id, one.hazard) for one in positives if one.verdict.sure}
    doubted = {(one.object_id, one.hazard) for one in positives} - sure
    changes: dict[Change, set[tuple[int, str]]] = {
        "lost": labelled - sure - doubted,
        "new": sure - labelled,
        "undecided": doubted,
    }
    return SceneAgain(
        changed=tuple(
            Changed(item.id, key, category.get(key, "?"), hazard, change)
            for change in CHANGES
            for key, hazard in sorted(changes[change])
        ),
        kept=tuple(sorted(Counter(hazard for _, hazard in labelled & sure).items())),
        foreign=tuple(
            sorted(Counter(name for name in category.values() if name not in known).items())
        ),
    )


def _redefined(before: Catalog, now: Catalog) -> tuple[str, ...]:
    """Categories of both catalogues of which predicates may find something else: properties tell
    where zones are, and ``climb_m`` how high children reach."""
    theirs = {one.name: (one.properties, one.climb_m) for one in now.categories}
    return tuple(
        one.name
        for one in before.categories
        if one.name in theirs and theirs[one.name] != (one.properties, one.climb_m)
    )


def _sum(counts: Iterator[tuple[tuple[str, int], ...]]) -> Counter[str]:
    total: Counter[str] = Counter()
    for some in counts:
        total.update(dict(some))
    return total
