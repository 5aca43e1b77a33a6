"""What is looked at must be seen, and who sits at a table faces it."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import numpy.typing as npt
import shapely

from tests.audit.dataset import Finding, Scene, Thing

Floats = npt.NDArray[np.float64]

#: What shows something on its front.
SHOWS = {"photo_frame", "alarm_clock", "laptop", "monitor", "tv", "picture_frame", "wall_clock"}
#: A picture this near to a wall shows it to nobody, metres.
WALL_M = 0.6
TABLES = {"kitchen_table", "dining_table", "desk"}
CHAIRS = {"chair", "office_chair"}
#: A chair this near to a table stands at it, metres.
AT_TABLE_M = 0.35


def stands_up(thing: Thing) -> bool:
    return bool(thing.turn[2, 2] > 0.9)


def faces_wall(scene: Scene) -> Iterator[Finding]:
    """Frames, clocks and screens that look at a wall."""
    for thing in scene.things.values():
        if thing.category not in SHOWS or not stands_up(thing) or "BROKEN" in thing.states:
            continue
        if scene.inside.get(thing.id) or thing.room not in scene.floors:
            continue
        start = (thing.box[0] + thing.box[1])[:2] / 2
        front = thing.front[:2] / np.linalg.norm(thing.front[:2])
        ray = shapely.LineString([start, start + front * WALL_M])
        # A table beneath a window or in the middle: only the room's own outline counts.
        outline = scene.floors[thing.room].exterior
        if ray.intersects(outline):
            yield scene.found(thing, "faces a wall", float(ray.project(ray.intersection(outline))))


def angle_to(thing: Thing, other: Thing) -> float:
    """Degrees between its front and the middle of another, seen from above."""
    middles = [(t.box[0] + t.box[1])[:2] / 2 for t in (thing, other)]
    towards = middles[1] - middles[0]
    front = thing.front[:2]
    cosine = towards @ front / (np.linalg.norm(towards) * np.linalg.norm(front) + 1e-12)
    return float(np.degrees(np.arccos(np.clip(cosine, -1, 1))))


def chairs_at_tables(scene: Scene) -> Iterator[Finding]:
    """Chairs at a table that do not face it, or do so without an edge in the graph."""
    tables = [thing for thing in scene.furniture if thing.category in TABLES]
    for chair in scene.furniture:
        if chair.category not in CHAIRS:
            continue
        near = [(t.footprint.distance(chair.footprint), t.id, t) for t in tables]
        near = [item for item in near if item[0] <= AT_TABLE_M]
        if not near:
            continue
        gap, _, table = min(near)
        if angle_to(chair, table) > 80:
            yield scene.found(chair, f"is turned away from its {table.category} {table.id}", gap)
        elif (chair.id, "FACING", table.id) not in scene.edges:
            yield scene.found(chair, f"no edge FACING {table.category} {table.id}", gap)
