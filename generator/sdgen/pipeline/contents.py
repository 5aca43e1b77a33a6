"""What one try puts into a home, as a value: every step returns new contents or a rejection."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

from sdgen.catalog.records import Catalog
from sdgen.hazards.inject import add_lookalikes, inject
from sdgen.hazards.placing import Injected
from sdgen.home.clutter import add_clutter
from sdgen.home.layout import Intent, Layout
from sdgen.pipeline.furnished import FurnishedHome
from sdgen.rejection import Rejection, Stage, reject
from sdgen.scene import ObjectInstance, Pose
from sdgen.seeding import Rng


class Culprit(NamedTuple):
    """Why an object is no everyday thing: it was put there, or brought into a state, for
    ``hazard``, and is to be an anomaly of each of the ``drawn`` ones (of none: it was brought
    along)."""

    hazard: str
    drawn: tuple[str, ...] = ()


@dataclass(frozen=True)
class Contents:
    """Every object of a scene by id, what placed ones are meant to lie on or in, and which were
    put (or switched) there for the drawn anomalies, and as lookalikes."""

    items: Mapping[int, ObjectInstance]
    intents: Mapping[int, Intent]
    anomalies: Mapping[int, Culprit]
    lookalikes: Mapping[int, Injected]

    def benign(self) -> list[ObjectInstance]:
        """All but the anomalies."""
        return [item for item in self.items.values() if item.id not in self.anomalies]

    def objection(
        self,
        object_id: int,
        stage: Stage,
        check: str,
        *,
        other: str | None = None,
        measured: float | None = None,
        limit: float | None = None,
    ) -> Rejection:
        """A rejection for the sake of one object; its hazard is at fault if it is an anomaly."""
        culprit = self.anomalies.get(object_id)
        return reject(
            stage,
            check,
            hazard=None if culprit is None else culprit.hazard,
            category=self.items[object_id].category,
            other=other,
            objects=(object_id,),
            measured=measured,
            limit=limit,
        )

    def posed(self, poses: Mapping[int, Pose]) -> Contents:
        """The same things at these poses."""
        moved = {
            key: item.model_copy(update={"pose": poses[key]}) if key in poses else item
            for key, item in self.items.items()
        }
        return replace(self, items=moved)

    def housed(self, rooms: Mapping[int, int]) -> Contents:
        """The same things, in these rooms."""
        items = {
            key: item
            if item.room_id == rooms[key]
            else item.model_copy(update={"room_id": rooms[key]})
            for key, item in self.items.items()
        }
        return replace(self, items=items)


def place_contents(
    hazards: Sequence[str],
    home: FurnishedHome,
    layout: Layout,
    training: bool,
    rng: Rng,
    only: Collection[str] = (),
) -> Contents | Rejection:
    """The home's own things, anomalies of the drawn hazards, lookalikes and clutter, placed in
    ``layout`` (taken over); of a home that is as it is drawn neither of the last two.

    ``training`` leaves withheld unique anomalies out; ``only`` are the hazards of which there are
    near misses, empty: all.
    """
    for item in home.things.items:
        layout.put(item, home.things.intents.get(item.id))
    anomalies = inject(hazards, layout, home.context, training, rng)
    if isinstance(anomalies, Rejection):
        return anomalies
    lookalikes: tuple[Injected, ...] = ()
    if not home.as_drawn:
        lookalikes = add_lookalikes(layout, home.context, anomalies, rng, only)
        add_clutter(layout, home.context, rng, culprits(anomalies))
    labelled = [Injected(name, key, None) for key, name in home.things.anomalies.items()]
    return Contents(
        items=dict(layout.items),
        intents=dict(layout.intents),
        anomalies=culprits((*labelled, *anomalies)),
        lookalikes={injected.object_id: injected for injected in lookalikes},
    )


def culprits(anomalies: Sequence[Injected]) -> dict[int, Culprit]:
    """By id, what these anomalies put, changed and brought along."""
    out: dict[int, Culprit] = {}
    for one in anomalies:
        first, drawn = out.get(one.object_id, Culprit(one.hazard))
        out[one.object_id] = Culprit(first, (*drawn, one.hazard))
        for other in one.brought:
            out.setdefault(other, Culprit(one.hazard))
    return out


def lost(before: Contents, after: Contents, catalog: Catalog) -> Rejection | None:
    """A rejection where what a household always has was taken away, to the last one: a cat's
    bowl."""
    left = {item.category for item in after.items.values()}
    gone = {item.category for item in before.items.values()} - left
    for category in catalog.categories:
        if category.always and category.name in gone:
            return reject("physics", "always_there", category=category.name)
    return None


@dataclass(frozen=True)
class Reduced:
    """Contents after things were taken away, and why each of them went."""

    contents: Contents
    taken_away: tuple[Rejection, ...]


def without(contents: Contents, offenders: Mapping[int, Rejection]) -> Reduced | Rejection:
    """Contents without these clutter things and lookalikes, and without what stands on them.

    A lookalike by state is switched back. Rejected when an anomaly or furniture is at fault.
    """
    going = _with_dependents(contents, offenders)
    for object_id, rejection in going.items():
        item = contents.items[object_id]
        if object_id in contents.anomalies:
            return rejection
        if item.fixed and object_id not in contents.lookalikes:
            return rejection
    items, intents = dict(contents.items), dict(contents.intents)
    for object_id in going:
        injected = contents.lookalikes.get(object_id)
        if injected is not None and injected.before is not None:
            items[object_id] = injected.before
            continue
        del items[object_id]
        intents.pop(object_id, None)
    lookalikes = {k: injected for k, injected in contents.lookalikes.items() if k not in going}
    left = Contents(items, intents, contents.anomalies, lookalikes)
    return Reduced(left, tuple(going.values()))


def _with_dependents(
    contents: Contents, offenders: Mapping[int, Rejection]
) -> dict[int, Rejection]:
    """Offenders, and whatever lies on or in one that will go."""
    going = dict(offenders)
    grew = True
    while grew:
        grew = False
        for object_id, intent in contents.intents.items():
            target = contents.items.get(intent.target_id)
            if object_id in going or intent.target_id not in going:
                continue
            if target is not None and not target.fixed:
                going[object_id] = contents.objection(object_id, "physics", "lost_its_support")
                grew = True
    return going
