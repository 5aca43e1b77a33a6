"""Doors, lids and drawers: what they stand in, and whether they can open."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import numpy.typing as npt

from tests.audit.dataset import Finding, Part, Scene, Thing
from tests.audit.physics import deepest, depth_in_box, overlap

Floats = npt.NDArray[np.float64]

#: So far people open a leaf to use what is behind it: 60 degrees, or half of a drawer's way; less
#: where the model itself opens less (judgement).
NEEDED_RAD, NEEDED_SHARE = 1.05, 0.5
STEPS = 4
#: Leaves touch what is beside them: this much is no obstacle, metres.
TOUCH_M = 0.01


def moved(thing: Thing, joint: str, value: float) -> list[Part]:
    """The parts on one joint at a value, the others as they are."""
    joints = dict(thing.json["joints"]) | {joint: value}
    return [part for part in thing.posed(joints) if part.joint == joint]


def is_pulled_away(other: Thing) -> bool:
    """Chairs and stools give way to a drawer."""
    return other.category in {"chair", "office_chair", "stool", "bar_stool", "high_chair"}


def obstacle(scene: Scene, thing: Thing, parts: list[Part]) -> tuple[float, str]:
    """How deep moved parts stand in a wall, a ceiling or in other fixed things, and in what."""
    worst, name = 0.0, ""
    boxes = np.concatenate([scene.boxes("wall"), scene.boxes("ceiling")])
    for part in parts:
        points = np.concatenate([part.vertices, part.world(part.mesh.samples[0])])
        for box in boxes:
            if overlap(box, part.box, TOUCH_M):
                depth = depth_in_box(points, box)
                if depth > worst:
                    worst, name = depth, "a wall"
        for other in scene.things.values():
            if other.id == thing.id or not other.fixed or is_pulled_away(other):
                continue
            if not overlap(other.box, part.box, TOUCH_M):
                continue
            for solid in other.solids:  # leaves of others can be shut
                if solid.joint is not None or not overlap(solid.box, part.box, TOUCH_M):
                    continue
                depth = deepest(points, solid, TOUCH_M)
                if depth > worst:
                    worst, name = depth, f"{other.category} {other.id}"
    return worst, name


def cannot_open(scene: Scene) -> Iterator[Finding]:
    """Leaves, lids and drawers that something stops before they are open enough to be used."""
    for thing in scene.things.values():
        if not thing.fixed or thing.category == "window":
            continue
        for joint in thing.record["joints"]:
            upper = joint["upper"]
            share = NEEDED_SHARE * upper
            needed = min(NEEDED_RAD, upper) if joint["type"] == "revolute" else share
            start = thing.json["joints"].get(joint["name"], 0.0)
            if start >= needed:
                continue
            for value in np.linspace(start, needed, STEPS + 1)[1:]:
                depth, name = obstacle(scene, thing, moved(thing, joint["name"], float(value)))
                if depth > TOUCH_M:
                    yield scene.found(thing, f"{joint['name']} is stopped by {name}", float(value))
                    break
