"""Can one get everywhere, and what lies in the way there?"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import shapely

from tests.audit.dataset import MATS, Finding, Scene, Thing
from tests.audit.leaves import is_pulled_away
from tests.audit.routes import FLAT_M, Ground

#: So far from walls and furniture, a thing lies in the open floor, metres (the review's).
OPEN_M = 0.4
#: A foot that walks along a way strikes what is this near to its middle, metres: half the width
#: of two feet side by side.
FOOT_M = 0.05
#: What is farther than this from every way is on none, metres: half a body and a hand's breadth.
OFF_M = 0.35
#: What hangs higher than this leaves room to stand before it, metres.
SHOULDER_M = 1.2


def on_floor(scene: Scene, thing: Thing) -> bool:
    if thing.bottom > FLAT_M or thing.category in MATS:
        return False
    return all(
        b not in scene.things or scene.things[b].category in MATS for b in scene.on[thing.id]
    )


def can_be_tripped_over(thing: Thing) -> bool:
    """Large enough to catch a foot: a palm's width, or higher than a sole's clearance."""
    size = thing.box[1] - thing.box[0]
    return bool(size[:2].max() >= 0.08 and size[2] >= 0.008)


def in_the_way(scene: Scene) -> Iterator[Finding]:
    """Unlabelled things in the open floor or on two ways or more."""
    ground = Ground(scene)
    for thing in scene.small:
        labels = scene.hazards_of.get(thing.id, set())
        if labels or thing.id not in scene.on or not on_floor(scene, thing):
            continue
        if not can_be_tripped_over(thing):
            continue
        free = ground.room_about(thing.footprint)
        ways = len(ground.routes_by(thing.footprint, FOOT_M))
        kind = "lookalike" if thing.id in scene.lookalikes else "clutter"
        if free >= OPEN_M:
            yield scene.found(thing, f"{kind} in the open floor, on {ways} ways", free)
        elif ways >= 2:
            yield scene.found(thing, f"{kind} on {ways} ways", free)


def in_nobodys_way(scene: Scene) -> Iterator[Finding]:
    """Tripping labels of things that no way comes near and that stand by a wall or furniture."""
    ground = Ground(scene)
    for id, hazards in scene.hazards_of.items():
        if "tripping_hazard" in hazards:
            thing = scene.things[id]
            free = ground.room_about(thing.footprint)
            if free < OPEN_M and not ground.routes_by(thing.footprint, OFF_M):
                yield scene.found(thing, "labelled as tripping, on no way", free)


def unreachable(scene: Scene) -> Iterator[Finding]:
    """Rooms that a body of 0.5 m cannot enter from the front door."""
    ground = Ground(scene)
    start = next(
        (ground.nearest(at, 0.6) for id, rooms, at in ground.doors() if len(rooms) == 1), None
    )
    if start is None:
        yield scene.found(None, "no way in at the front door")
        return
    home = ground.island[start]
    reached = ground.points[ground.island == home]
    for id, floor in scene.floors.items():
        inside = shapely.contains_xy(floor, reached[:, 0], reached[:, 1])
        if inside.sum() * 0.05**2 < 0.25:
            room = scene.rooms[id]["type"]
            yield scene.found(None, f"{room} {id} cannot be reached", float(inside.sum()))


def cannot_be_used(scene: Scene) -> Iterator[Finding]:
    """Fridges, cupboards and the like with less than half a metre to stand in before them."""
    ground = Ground(scene)
    floor = ground.floor
    for thing in scene.furniture:
        if not thing.has("CAN_OPEN", scene.catalogue) or thing.bottom > FLAT_M:
            continue
        at = ground.blocks.get(thing.id)
        if at is None or not thing.record["joints"] or thing.category in {"trash_bin"}:
            continue
        if thing.category == "corner_counter":  # opened from its notch, between the two legs
            continue
        front = thing.front[:2]
        side = np.array([-front[1], front[0]])
        edge = np.array(at.exterior.coords)
        ahead, across = edge @ front, edge @ side
        middle, half = (across.min() + across.max()) / 2, np.ptp(across) / 4
        corners = [
            front * x + side * y
            for x, y in (
                (ahead.max() + 0.02, middle - half),
                (ahead.max() + 0.02, middle + half),
                (ahead.max() + 0.5, middle + half),
                (ahead.max() + 0.5, middle - half),
            )
        ]
        need = shapely.Polygon(corners)
        for id, other in ground.blocks.items():
            if scene.things[id].bottom > SHOULDER_M:
                continue
            movable = is_pulled_away(scene.things[id])
            if id != thing.id and not movable and other.intersection(need).area > 0.01:
                gap = float(other.distance(at))
                yield scene.found(thing, f"faces {scene.things[id].category} {id}", gap)
        if need.difference(floor).area > 0.01:
            yield scene.found(thing, "faces a wall", float(at.distance(floor.boundary)))
