"""The scenes that detectors did worst on, thing by thing, with pictures of each."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

from sdgen.benchmark.collect import Collected
from sdgen.benchmark.outcome import Item, Outcome
from sdgen.catalog.records import Hazard
from sdgen.dataset import Dataset, SceneItem
from sdgen.dataset.derived import derived_from
from sdgen.dataset.records import Report
from sdgen.gallery.labels import names_of
from sdgen.gallery.pictures import Box, Rgb, crop
from sdgen.gallery.seen import best_views, seen_in
from sdgen.gallery.words import measured, plain, who

#: Things of one scene that are shown; of more they are counted.
THINGS = 12


class Verdict(NamedTuple):
    """What a detector said of a thing, in words, and whether that was wrong."""

    detector: str
    text: str
    wrong: bool


@dataclass(frozen=True)
class ThingOnPage:
    """One thing: what it is, what is true of it and why, what was said, a JPEG of its best view
    (None where no picture shows it)."""

    kind: str
    name: str
    room: str
    true: tuple[str, ...]
    measured: tuple[tuple[str, str], ...]
    said: tuple[Verdict, ...]
    picture: bytes | None
    where: str


@dataclass(frozen=True)
class SceneOnPage:
    """A scene: its errors by detector, who lives there, and its things; ``more`` are not shown."""

    id: str
    home: str
    split: str
    who: str
    errors: tuple[tuple[str, int, int], ...]
    things: tuple[ThingOnPage, ...]
    more: int


def worst_scenes(found: Collected, most: int) -> Iterator[SceneOnPage]:
    """The scenes with most misses and false alarms, over all detectors, the worst first; those
    without any are left out. Raises InputError for a broken scene."""
    by_scene: dict[str, list[Outcome]] = {}
    for outcomes in found.outcomes.values():
        for one in outcomes:
            by_scene.setdefault(one.scene, []).append(one)
    ranked = sorted(by_scene, key=lambda key: (-sum(map(_errors, by_scene[key])), key))
    hazards = {hazard.id: hazard for hazard in found.data.catalog.hazards}
    for key in ranked[:most]:
        if not any(_errors(one) for one in by_scene[key]):
            return
        item = found.data.scene(key)
        with derived_from(found.data, item):
            page = _Scene(found.data, item, hazards)
            yield page.shown(dict(zip(found.outcomes, by_scene[key], strict=True)))


def _errors(one: Outcome) -> int:
    return one.scores.wrong - one.scores.hits + int(one.scores.false_alarms)


class _Scene:
    """What is needed to show the things of one scene."""

    def __init__(self, data: Dataset, item: SceneItem, hazards: Mapping[str, Hazard]) -> None:
        self._item = item
        self._hazards = hazards
        self._name: Callable[[int], str] = names_of(item)
        self._pictures: dict[int, Rgb] = {}
        self._things = {thing.id: thing for thing in item.scene.objects}
        best = best_views(item, seen_in(item))
        self._boxes: dict[int, tuple[int, Box]] = {}
        most: dict[int, int] = {}
        for view in item.visibility.views:
            for shown in view.objects:
                if shown.pixels > most.get(shown.object_id, 0):
                    most[shown.object_id] = shown.pixels
                    self._boxes[shown.object_id] = (view.view, shown.bbox)
        for anomaly in item.anomalies.anomalies:
            if anomaly.id in best:
                seen = best[anomaly.id]
                self._boxes[anomaly.object_id] = (seen.view, seen.box)

    def shown(self, outcomes: Mapping[str, Outcome]) -> SceneOnPage:
        """The scene with what became of it, by detector."""
        rows: dict[int, dict[str, list[Item]]] = {}
        for name, one in outcomes.items():
            for item in one.items:
                rows.setdefault(item.object_id, {}).setdefault(name, []).append(item)
        bad = {key: some for key, some in rows.items() if any(map(_is_wrong, _all(some)))}
        order = sorted(
            bad, key=lambda key: (min(map(_rank, _all(bad[key]))), key not in self._boxes, key)
        )
        return SceneOnPage(
            id=self._item.id,
            home=plain(self._item.entry.home),
            split=self._item.entry.split,
            who=who(self._item.household),
            errors=tuple(
                (name, one.scores.wrong - one.scores.hits, int(one.scores.false_alarms))
                for name, one in outcomes.items()
            ),
            things=tuple(self._thing(key, bad[key], list(outcomes)) for key in order[:THINGS]),
            more=max(0, len(order) - THINGS),
        )

    def _thing(
        self, key: int, some: Mapping[str, Sequence[Item]], detectors: Sequence[str]
    ) -> ThingOnPage:
        one = min(_all(some), key=_rank)
        picture, where = self._picture(key)
        true: list[str] = []
        evidence: tuple[tuple[str, str], ...] = ()
        for anomaly in self._item.anomalies.anomalies:
            if anomaly.object_id == key:
                title = self._title(anomaly.hazard)
                true.append(f"{title}: {anomaly.message}")
                wanted = "not to be told" if anomaly.notify == "silent" else anomaly.notify
                true.append(f"{anomaly.label}, {wanted}: {anomaly.reason}")
        for near in self._item.anomalies.lookalikes:
            if near.object_id == key and one.near_miss_of:
                true.append(
                    f"Lookalike of “{self._title(near.near_miss_of)}”, which it just is not."
                )
                evidence = (*evidence, *measured(near.evidence, self._name))
        thing = self._things.get(key)
        if not true and thing is None and one.category is None:
            true.append("There is no such object in the scene.")
        elif not true:
            true.append("Nothing is wrong with it.")
        if thing is not None and thing.states:
            evidence = (*evidence, ("states", ", ".join(map(plain, thing.states)).lower()))
        kinds = {"miss": "missed", "hit": "told wrongly", "false_alarm": "false alarm"}
        kind = "reported lookalike" if one.near_miss_of else kinds[one.kind]
        verdicts = (self._verdict(name, some.get(name, ())) for name in detectors)
        return ThingOnPage(
            kind=kind,
            name=self._name(key),
            room=plain(one.room or ""),
            true=tuple(true),
            measured=evidence,
            said=tuple(verdicts),
            picture=picture,
            where=where,
        )

    def _title(self, hazard: str) -> str:
        known = self._hazards.get(hazard)
        return known.title if known is not None else plain(hazard)

    def _verdict(self, detector: str, items: Sequence[Item]) -> Verdict:
        # What no row speaks of is a harmless thing that was left alone.
        wrong = any(map(_is_wrong, items))
        said = next((item.said for item in items if item.said is not None), None)
        return Verdict(detector, _in_words(said), wrong)

    def _picture(self, key: int) -> tuple[bytes | None, str]:
        if key not in self._boxes:
            return None, "no view shows it"
        view, box = self._boxes[key]
        if self._item.rgb_path(view) is None:
            return None, f"view {view}"
        if view not in self._pictures:
            self._pictures[view] = self._item.rgb(view)
        return crop(self._pictures[view], box)[0], f"view {view}"


def _all(some: Mapping[str, Sequence[Item]]) -> list[Item]:
    return [item for items in some.values() for item in items]


def _is_wrong(item: Item) -> bool:
    """Whether a detector did wrong by an item: missed it, made it up, or told what is unwanted."""
    told = item.said is not None and item.said.notify != "silent"
    unwanted = item.wrong is not None and item.wrong.notify == "silent" and told
    return item.kind in ("miss", "false_alarm") or unwanted


def _rank(item: Item) -> int:
    """In which order things are shown: misses, told lookalikes, other false alarms, the unwanted,
    and last what was done right by; of each first what some view shows."""
    if item.kind == "miss":
        return 0
    if item.kind == "false_alarm":
        return 1 if item.near_miss_of else 2
    return 3 if _is_wrong(item) else 4


def _in_words(said: Report | None) -> str:
    if said is None:
        return "nothing"
    sure = "" if said.score is None else f", score {said.score:.2f}"
    return f"{said.label}, {said.notify}{sure}"
