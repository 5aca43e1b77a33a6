"""Where the agent begins and how the scene came to rest, against the scene: no simulator needed."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import islice

from shapely.geometry import Point, Polygon

from sdgen.dataset.item import SceneItem
from sdgen.scene import Contact
from sdgen.validate.labels import known_ids
from sdgen.validate.problems import SHOWN, Problem
from sdgen.validate.whose_room import not_in_room
from sdgen.vocabulary import DRIFT_LIMIT_M

#: The start is drawn from the free floor; the polygons written of it are that floor simplified by
#: up to 1 cm, and both are rounded to millimetres.
START_M = 0.015


def check_start(item: SceneItem) -> Iterator[Problem]:
    """The agent begins on free floor, in the room it is said to be in."""
    scene, start = item.scene, item.scene.agent_start
    where = f"{item.where('scene.json')}: agent_start"
    x, y, z = start.position_m
    point = Point(x, y)
    if z != 0.0:
        yield Problem("scene", f"{where}.position_m: {z} m high, not on the floor")
    gap = min((Polygon(ring).distance(point) for ring in scene.free_space), default=0.0)
    if gap > START_M:
        yield Problem("scene", f"{where}.position_m: {gap:.2f} m outside the free space")
    wrong = not_in_room(scene.home, start.room_id, x, y)
    if wrong is not None:
        yield Problem("scene", f"{where}: {wrong}")


def check_report(item: SceneItem) -> Iterator[Problem]:
    """``physics.json`` speaks of exactly the loose things, within the limit of drift, and each of
    them touches something that is there."""
    for text in islice(_report(item), SHOWN):
        yield Problem("scene", f"{item.where('physics.json')}: {text}")


def _report(item: SceneItem) -> Iterator[str]:
    scene, report = item.scene, item.physics
    loose = {str(thing.id): thing for thing in scene.objects if not thing.fixed}
    for key, drift in report.settled_drift_m.items():
        if key not in loose:
            yield f"settled_drift_m: {key} is no object of the scene that is loose"
        elif not 0 <= drift <= DRIFT_LIMIT_M:
            yield f"settled_drift_m.{key}: {drift} is not in 0 to {DRIFT_LIMIT_M}"
    for key, thing in loose.items():
        if key not in report.settled_drift_m:
            yield f"settled_drift_m: nothing of object {key} ({thing.category})"
    yield from _contacts(report.contacts, known_ids(scene))
    touching = {key for contact in report.contacts for key in (contact.a, contact.b)}
    if scene.twin_of is None:  # what a twin's things touched may be gone
        for thing in loose.values():
            if thing.id not in touching:
                yield f"contacts: object {thing.id} ({thing.category}) touches nothing"


def _contacts(contacts: Sequence[Contact], known: set[int]) -> Iterator[str]:
    for k, contact in enumerate(contacts):
        for key in (contact.a, contact.b):
            if key not in known:
                yield f"contacts[{k}]: {key} is no object of the scene"
    pairs = [(contact.a, contact.b) for contact in contacts]
    if pairs != sorted(set(pairs)) or any(a >= b for a, b in pairs):
        yield "contacts: not one a pair, sorted by ids"
