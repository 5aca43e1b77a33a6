"""Where a scene's things stand, by their poses and outlines alone: no model is loaded."""

from __future__ import annotations

from collections.abc import Iterator

from sdgen.dataset.item import SceneItem
from sdgen.facts import Facts, entered_structures, in_the_air, unheld
from sdgen.validate.problems import Problem
from sdgen.zones import swing_blocked


def check_standing(item: SceneItem, facts: Facts) -> Iterator[Problem]:
    """Everything is in its room, rests on something, reaches into no wall and lets doors swing."""
    where = item.where("scene.json")
    for key, text in _found(item, facts):
        named = f"object {key} ({facts.category(key)})"
        yield Problem("scene", f"{where}: {named}{text}")


def _found(item: SceneItem, facts: Facts) -> Iterator[tuple[int, str]]:
    """Objects, and what is wrong with where each of them is."""
    for thing in item.scene.objects:
        rooms = facts.room_ids(thing.id)
        if thing.room_id not in rooms:  # one of those it may be in
            yield thing.id, f": room_id: {thing.room_id} stored, {list(rooms)} derived"
    for key in unheld(facts):  # twins' things, too
        held = any(found.holds for found in facts.on(key))
        yield key, ": a piece of it rests on nothing" if held else ": rests on nothing"
    for violation in entered_structures(facts):
        key, structure = violation.objects
        depth = f"{violation.measured * 1000:.0f} mm (limit {violation.limit * 1000:.0f})"
        yield key, f": reaches {depth} into {facts.category(structure)} {structure}"
    for violation in in_the_air(facts):
        gap = f"{violation.measured:.2f} m from the nearest wall or ceiling"
        yield violation.objects[0], f": is fixed in the air: on nothing, {gap}"
    guilty = {anomaly.object_id for anomaly in item.anomalies.anomalies}
    benign = [body for key, body in facts.bodies.items() if key not in guilty]
    for key in swing_blocked(benign):
        yield key, " stands where a door must swing"
