"""Anomalies and lookalikes as a page shows them."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import NamedTuple

from sdgen.catalog.records import Hazard
from sdgen.dataset import SceneItem
from sdgen.facts import Facts
from sdgen.gallery.pictures import crop
from sdgen.gallery.reasons import Rule, rules_of
from sdgen.gallery.seen import Best
from sdgen.gallery.words import measured, plain
from sdgen.scene import Anomaly, Lookalike


class Crop(NamedTuple):
    """A picture of a thing cut out of a view: its file's name and bytes, and whether the thing is
    in its right half."""

    name: str
    data: bytes
    right: bool


@dataclass(frozen=True)
class LabelOnPage:
    """An anomaly or a lookalike: its record, what was measured, the clauses of its hazard, the view
    that shows it best and its crop there. ``key`` names its card on the page."""

    key: str
    kind: str
    record: Anomaly | Lookalike
    hazard: str
    title: str
    what: str
    measured: tuple[tuple[str, str], ...]
    rules: tuple[Rule, ...]
    best: Best | None = None
    crop: Crop | None = None


def names_of(item: SceneItem, *others: SceneItem) -> Callable[[int], str]:
    """What a node is called: ``kitchen table 77``; ``others`` name what this scene lacks."""
    things = [thing for one in (*others, item) for thing in one.scene.objects]
    names = {thing.id: f"{plain(thing.category)} {thing.id}" for thing in things}
    names |= {one.id: one.category for one in item.scene.home.structures}
    names |= {room.id: plain(room.name) for room in item.scene.home.rooms}
    return lambda key: names.get(key, f"node {key}")


def labels_of(
    item: SceneItem,
    facts: Facts,
    hazards: Mapping[str, Hazard],
    best: Mapping[str, Best],
    name: Callable[[int], str],
) -> list[LabelOnPage]:
    """The anomalies of a scene, then its lookalikes, with crops where a colour picture shows them.

    A hazard that the catalogue does not have has no clauses.
    """
    out: list[LabelOnPage] = []
    records: list[Anomaly | Lookalike] = [*item.anomalies.anomalies, *item.anomalies.lookalikes]
    for number, record in enumerate(records):
        hazard_id = record.hazard if isinstance(record, Anomaly) else record.near_miss_of
        seen = best.get(record.id) if isinstance(record, Anomaly) else None
        kind = "anomaly" if isinstance(record, Anomaly) else "lookalike"
        hazard = hazards.get(hazard_id)
        predicate = hazard.predicate if hazard is not None else None
        out.append(
            LabelOnPage(
                key=f"{kind}-{number}",
                kind=kind,
                record=record,
                hazard=hazard_id,
                title=hazard.title if hazard is not None else plain(hazard_id),
                what=name(record.object_id),
                measured=measured(record.evidence, name),
                rules=rules_of(predicate, record.object_id, facts, name) if predicate else (),
                best=seen,
                crop=_crop(item, f"crop-{number}.jpg", seen) if seen is not None else None,
            )
        )
    return out


def _crop(item: SceneItem, name: str, seen: Best) -> Crop | None:
    if item.rgb_path(seen.view) is None:
        return None
    return Crop(name, *crop(item.rgb(seen.view), seen.box))
