"""What a scene's predictions are held against, read lightly: a thousand scenes in seconds.

``scene.json`` and ``graph.json`` are large, and of them only ids, categories and rooms matter here.
They are taken from the text without checking the rest; where that does not go, the file is read in
full, which says what is wrong with it.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import NamedTuple

from pydantic import BaseModel, ConfigDict, ValidationError

from sdgen.dataset import Dataset, SceneItem
from sdgen.dataset.records import VISIBILITY_FILE
from sdgen.dataset.text import read_bytes
from sdgen.errors import InputError, did_you_mean
from sdgen.scene import Anomaly, Graph, Notify, Scene, Visibility
from sdgen.truth.visibility import evidence_pixels, evidence_pixels_needed, shows

#: How well the best view shows an anomaly: its evidence's pixels there by those that are needed. In
#: steps of four, as an object half as far away, whose picture is four times as large.
NOT_SHOWN = "not shown"
BINS = ((4.0, "1 to 4 times"), (16.0, "4 to 16 times"), (float("inf"), "more than 16 times"))
#: So many ids are looked for in a text one by one.
_FEW = 100
SHOWN_BY = (NOT_SHOWN, *(name for _, name in BINS))


class Way(NamedTuple):
    """In what way something is wrong: an anomaly without the scene that it is in."""

    hazard: str
    category: str
    states: tuple[str, ...]
    relation: str | None
    target: str | None


class Wrong(NamedTuple):
    """An anomaly. ``shown`` is one of ``SHOWN_BY``, None without views; ``in_twin`` says that the
    benign twin has its object, and that some view shows it there and here."""

    id: str
    object_id: int
    group: str
    label: str
    room: str | None
    report: bool
    notify: Notify
    shown: str | None
    way: Way
    in_twin: bool


class _Light(BaseModel):
    """Of a file that is written by us only what is needed, three times as fast."""

    model_config = ConfigDict(extra="ignore", strict=True)


class _Room(_Light):
    id: int
    type: str


class _Node(_Light):
    id: int
    category: str
    room_id: int


class _Home(_Light):
    rooms: tuple[_Room, ...]
    structures: tuple[_Node, ...]


class _Scene(_Light):
    home: _Home
    objects: tuple[_Node, ...]


class _GraphNode(_Light):
    id: int


class _Graph(_Light):
    nodes: tuple[_GraphNode, ...]


class _Shown(_Light):
    object_id: int


class _View(_Light):
    objects: tuple[_Shown, ...]


class _Views(_Light):
    views: tuple[_View, ...]


class Thing(NamedTuple):
    """A node of a scene: its category, and the type of its room (None of a room)."""

    category: str
    room: str | None


@dataclass(frozen=True)
class Truth:
    """A scene's truth. ``lookalikes`` maps objects that are no anomalies to what they nearly are;
    ``things`` are its nodes, where it has anomalies or predictions."""

    id: str
    split: str
    anomalies: tuple[Wrong, ...]
    lookalikes: Mapping[int, tuple[str, ...]]
    things: Mapping[int, Thing]
    twin: Truth | None = None


class Ways(NamedTuple):
    """What the train split of a data set shows: ways to be wrong, and categories by hazard."""

    ways: frozenset[Way]
    categories: frozenset[tuple[str, str]]

    def seen(self, way: Way, split: str) -> bool | None:
        """Whether train shows this way; None in train itself, and where train shows nothing."""
        return None if split == "train" or not self.ways else way in self.ways

    def category_seen(self, way: Way, split: str) -> bool | None:
        """Whether train shows this category with this hazard; None as above."""
        if split == "train" or not self.ways:
            return None
        return (way.hazard, way.category) in self.categories


def unknown_objects(item: SceneItem, ids: Iterable[int]) -> frozenset[int]:
    """Those of ``ids`` that are no nodes of a scene. A few are looked for in the text of
    ``scene.json``, whose ids are all the graph's; for those not there, or many, the graph is
    read."""
    rest = frozenset(ids)
    if 0 < len(rest) <= _FEW:
        content = _content(item, "scene.json")
        rest = frozenset(key for key in rest if b'"id": %d,' % key not in content)
    return rest - _nodes_of(item) if rest else rest


def _nodes_of(item: SceneItem) -> frozenset[int]:
    graph: _Graph | Graph
    try:
        graph = _Graph.model_validate_json(_content(item, "graph.json"))
    except ValidationError:
        graph = item.scene_graph  # or it says what is wrong
    return frozenset(node.id for node in graph.nodes)


def things_of(item: SceneItem) -> Mapping[int, Thing]:
    """The nodes of a scene by id. InputError for a broken file."""
    scene: _Scene | Scene
    try:
        scene = _Scene.model_validate_json(_content(item, "scene.json"))
    except ValidationError:
        scene = item.scene  # or it says what is wrong
    types = {room.id: room.type for room in scene.home.rooms}
    out = {key: Thing(kind, None) for key, kind in types.items()}
    for one in (*scene.home.structures, *scene.objects):
        out[one.id] = Thing(one.category, types.get(one.room_id))
    return out


def _content(item: SceneItem, name: str) -> bytes:
    return item.file(name) if item.checked else read_bytes(item.folder / name, item.where(name))


def truths(data: Dataset, predicted: Collection[str]) -> Iterator[Truth]:
    """The truth of every scene, and of its benign twin where that is among the ``predicted``.
    Raises InputError for broken files."""
    for item in data:
        twin = item.twin
        if twin is not None and twin.id not in predicted:
            twin = None
        yield _truth(data, item, twin, predicted)


def ways_of(data: Dataset, known: Iterable[Truth]) -> Ways:
    """What train shows: of scenes that are ``known``, and of those of train that are not."""
    ways: set[Way] = set()
    have = set()
    for truth in known:
        have.add(truth.id)
        if truth.split == "train":
            ways.update(one.way for one in truth.anomalies)
    for entry in data.entries:
        if entry.kind == "scene" and entry.split == "train" and entry.id not in have:
            item = data.scene(entry.id)
            labels = _anomalies(data, item)
            things = things_of(item) if any(one.target_id is not None for one in labels) else {}
            ways.update(_way(one, things) for one in labels)
    return Ways(frozenset(ways), frozenset((way.hazard, way.category) for way in ways))


def _truth(
    data: Dataset, item: SceneItem, twin: SceneItem | None, predicted: Collection[str]
) -> Truth:
    labels = _anomalies(data, item)
    things = things_of(item) if labels or item.id in predicted else {}
    size = (data.info.options.width, data.info.options.height)
    seen = item.visibility if labels else None
    here = _seen_objects(seen) if seen is not None else frozenset()
    gone: set[int] = set()
    there: frozenset[int] = frozenset()
    benign = None
    if twin is not None:
        gone = {one.object_id for one in twin.anomalies.undone if one.removed}
        there = _objects_of(twin) if labels else frozenset()
        benign = _truth(data, twin, None, predicted)
    no_views = not data.info.options.sensors or not item.entry.views
    wrong = tuple(
        Wrong(
            id=one.id,
            object_id=one.object_id,
            group=one.group,
            label=one.label,
            room=_room(one, things),
            report=one.report,
            notify=one.notify,
            shown=None if seen is None or no_views else shown_by(seen, one, size),
            way=_way(one, things),
            in_twin=twin is not None
            and one.object_id not in gone
            and (no_views or (one.object_id in here and one.object_id in there)),
        )
        for one in labels
    )
    bad = {one.object_id for one in labels}
    near: dict[int, tuple[str, ...]] = {}
    for like in item.anomalies.lookalikes:
        if like.object_id not in bad:
            near[like.object_id] = (*near.get(like.object_id, ()), like.near_miss_of)
    return Truth(item.id, item.entry.split, wrong, near, things, benign)


def shown_by(seen: Visibility, anomaly: Anomaly, size: tuple[int, int]) -> str:
    """Which of ``SHOWN_BY`` an anomaly is, by the view that shows most of its evidence among those
    that show all that is needed of it; ``size`` is the pictures' width and height."""
    whole = [view for view in seen.views if shows(view, anomaly, *size)]
    if not whole:
        return NOT_SHOWN
    needed = evidence_pixels_needed(*size, anomaly.evidence_pixels_needed)
    times = max(evidence_pixels(view, anomaly) for view in whole) / needed
    return next(name for end, name in BINS if times < end)


def _seen_objects(seen: Visibility | _Views) -> frozenset[int]:
    return frozenset(thing.object_id for view in seen.views for thing in view.objects)


def _objects_of(item: SceneItem) -> frozenset[int]:
    try:
        return _seen_objects(_Views.model_validate_json(_content(item, VISIBILITY_FILE)))
    except ValidationError:
        return _seen_objects(item.visibility)


def _way(anomaly: Anomaly, things: Mapping[int, Thing]) -> Way:
    target = None
    if anomaly.target_id is not None:
        found = things.get(anomaly.target_id)
        target = found.category if found is not None else None
    states = tuple(sorted(anomaly.states))
    return Way(anomaly.hazard, anomaly.category, states, anomaly.relation, target)


def _room(anomaly: Anomaly, things: Mapping[int, Thing]) -> str | None:
    found = things.get(anomaly.room_id)
    return found.category if found is not None else None


def _anomalies(data: Dataset, item: SceneItem) -> tuple[Anomaly, ...]:
    for anomaly in item.anomalies.anomalies:
        if anomaly.hazard not in data.info.hazards_enabled:
            known = list(data.info.hazards_enabled)
            hint = did_you_mean(anomaly.hazard, known)
            where = item.where("anomalies.json")
            raise InputError([f"{where}: {anomaly.id}: no hazard {anomaly.hazard!r}{hint}"])
    return item.anomalies.anomalies
