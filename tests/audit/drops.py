"""How far a thing reaches over an edge, and how far it is from one (`docs/relations.md`, *Firm
ground and drops*)."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

import shapely

from tests.audit.outlines import Body
from tests.audit.told import NO, YES, Limit, Told, about, every, some
from tests.audit.world import ON_GAP, World

CAUGHT = about(0.25, 0.02)
GAP = Limit(0.1, 0.08, 0.12)
#: An outline is asked at its corners and so often between them, metres.
STEP_M = 0.005


class Drop(NamedTuple):
    over_m: float
    edge_m: float


NOWHERE = Drop(0.0, math.inf)


def drops(world: World, id: int) -> list[Drop]:
    """As measured, and then all that it may be where something it hangs on is undecided."""
    body = world.bodies[id]
    on = some(one.told for one in world.related(id, "ON"))
    high = every([on, CAUGHT.more(float(body.low[2]))])
    rooms = world.rooms(id)
    if high == NO or not rooms:
        return [NOWHERE]
    found = [drop for room in rooms for drop in _in_room(world, body, room)]
    return [found[0] if high.holds else NOWHERE, *found, *([] if high.sure else [NOWHERE])]


def _in_room(world: World, body: Body, room: int) -> Iterator[Drop]:
    if room not in world.scene.floors:
        yield NOWHERE
        return
    catchers = list(_catchers(world, body, room))
    for asked, gap in ((None, GAP.at), (True, GAP.low), (False, GAP.high)):
        shapes = {
            key: shape
            for key, shape, told in catchers
            if (told.holds if asked is None else told == YES if asked else True)
        }
        yield _drop(world, body, room, shapes, gap)


def _reaches(other: Body, low: float) -> Told:
    begins = ON_GAP.at_most(float(other.low[2]) - low)
    return every([begins, CAUGHT.at_most(low - other.top)])


def _catchers(
    world: World, body: Body, room: int
) -> Iterator[tuple[tuple[int, int], shapely.Geometry, Told]]:
    """What would catch it: all that is fixed, what carries it, and the surfaces of the latter."""
    low = float(body.low[2])
    bounds = shapely.box(*world.scene.floors[room].bounds)
    carriers = {
        key: some(ways) for key, ways in world.carriers(body.id).items() if key in world.bodies
    }
    for other in world.bodies.values():
        if other.id == body.id or not (other.fixed or other.id in carriers):
            continue
        told = _reaches(other, low)
        if not other.fixed:
            told = every([told, carriers[other.id]])
        if told != NO and other.trunk.intersects(bounds):
            yield (other.id, -1), other.trunk, told
    for key, carries in carriers.items():
        for n, surface in enumerate(world.bodies[key].surfaces):
            below = ON_GAP.at_most(surface.z - low), CAUGHT.at_most(low - surface.z)
            told = every([carries, surface.level, *below])
            if told != NO:
                yield (key, n), surface.outline, told


def _drop(
    world: World,
    body: Body,
    room: int,
    shapes: dict[tuple[int, int], shapely.Geometry],
    gap: float,
) -> Drop:
    drop, firm = _ground(world, room, shapes, gap)
    if drop.is_empty:
        return NOWHERE
    apart = float(drop.distance(body.footprint))
    if apart > 0:
        return Drop(0.0, apart)
    if firm.is_empty:
        return NOWHERE
    outline = shapely.get_coordinates(shapely.segmentize(body.footprint, STEP_M))
    points = shapely.points(outline)
    over = points[shapely.intersects(drop, points)]
    return Drop(float(shapely.distance(over, firm).max(initial=0.0)), 0.0)


def _ground(
    world: World, room: int, shapes: dict[tuple[int, int], shapely.Geometry], gap: float
) -> tuple[shapely.Geometry, shapely.Geometry]:
    """Where in a room a drop is, and all else of it; things on one worktop share it."""
    key = (room, gap, *sorted(shapes))
    if key not in world.drops:
        floor = world.scene.floors[room]
        bare = floor.difference(shapely.union_all(list(shapes.values())))
        wide = bare.buffer(-gap / 2, join_style="mitre").buffer(gap / 2, join_style="mitre")
        drop = wide.intersection(bare)
        world.drops[key] = (drop, floor.difference(drop))
    return world.drops[key]
