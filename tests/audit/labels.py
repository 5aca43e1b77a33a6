"""Every predicate of `catalogue.json` asked anew of every object: labels, their proof, near misses,
and the graph's edges and tags."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import shapely

from tests.audit.dataset import Finding, Json, Scene
from tests.audit.terms import answer, measured
from tests.audit.told import NO, YES, Told
from tests.audit.world import CHILD_REACH_M, NEAR, NEAR_EDGE_M, ON_GAP, Evidence, World

#: Evidence is told to 1e-4: what is measured here may be rounded to the other side.
SLACK = 1.5e-4
#: Of an angle, degrees: rounded, too, but of numbers a hundred times as large.
RELATIONS = ("ON", "INSIDE", "BETWEEN", "CLOSE", "FACING", "UNDER", "BLOCKS", *NEAR)


def world_of(scene: Scene) -> World:
    """What is measured of a scene, once for all checks."""
    if "_world" not in scene.__dict__:
        scene.__dict__["_world"] = World(scene)
    found: World = scene.__dict__["_world"]
    return found


def asked(scene: Scene) -> dict[tuple[int, str], tuple[Told, Evidence]]:
    """Of each pair of object and hazard what its predicate says, but those surely false."""
    if "_asked" not in scene.__dict__:
        world, found = world_of(scene), {}
        for name, hazard in scene.catalogue.hazards.items():
            for id in world.bodies:
                told = answer(hazard["predicate"], world, id)
                if told.told != NO:
                    found[id, name] = (told.told, told.evidence)
        scene.__dict__["_asked"] = found
    kept: dict[tuple[int, str], tuple[Told, Evidence]] = scene.__dict__["_asked"]
    return kept


def listed(scene: Scene) -> Iterator[Finding]:
    """Listed labels whose predicate does not surely hold, and pairs listed twice."""
    pairs = [(one["object_id"], one["hazard"]) for one in scene.labels["anomalies"]]
    for pair in dict.fromkeys(pairs):
        id, hazard = pair
        told = asked(scene).get(pair, (NO, {}))[0]
        if told != YES:
            what = "is undecided" if not told.sure else "does not hold"
            gone = "" if id in scene.things else f"{id}, which is not there: "
            yield scene.found(scene.things.get(id), f"{gone}{hazard} {what}")
        if pairs.count(pair) > 1:
            yield scene.found(scene.things.get(id), f"{hazard} is listed twice", pairs.count(pair))


def unlisted(scene: Scene) -> Iterator[Finding]:
    """Pairs of object and hazard that hold, or may, and are not listed."""
    pairs = {(one["object_id"], one["hazard"]) for one in scene.labels["anomalies"]}
    for pair, (told, _) in asked(scene).items():
        if pair not in pairs:
            what = "holds" if told == YES else "is undecided"
            yield scene.found(scene.things[pair[0]], f"{pair[1]} {what}, unlisted")


def evidence(scene: Scene) -> Iterator[Finding]:
    """Evidence that is not what is measured here, of labels and of near misses."""
    world, known = world_of(scene), asked(scene)
    for label in scene.labels["anomalies"]:
        pair = (label["object_id"], label["hazard"])
        if pair in known:
            yield from _differences(scene, *pair, label["evidence"], known[pair][1])
    for miss in scene.labels["lookalikes"]:
        id, hazard = miss["object_id"], miss["near_miss_of"]
        if id not in world.bodies:
            yield scene.found(None, f"near miss {id} is not there")
            continue
        found = measured(scene.catalogue.hazards[hazard]["predicate"], world, id)
        yield from _differences(scene, id, hazard, miss["evidence"], found)


def _differences(
    scene: Scene, id: int, hazard: str, told: Json, found: Evidence
) -> Iterator[Finding]:
    for key in sorted(told.keys() | found.keys()):
        a, b = told.get(key), found.get(key)
        if not _alike(a, b):
            number = float(b) if isinstance(b, float) else None
            yield scene.found(scene.things[id], f"{hazard}: {key} is told as {a!r}", number)


def _alike(a: Any, b: Any) -> bool:
    if isinstance(a, float) and isinstance(b, float | int):
        return math.isclose(a, b, abs_tol=SLACK, rel_tol=1e-6)
    return bool(a == b)


def states(scene: Scene) -> Iterator[Finding]:
    """States that are not what the variant and the joints say."""
    for body in world_of(scene).bodies.values():
        told = [body.item["states"], scene.nodes[body.id]["states"]]
        told += [a["states"] for a in scene.labels["anomalies"] if a["object_id"] == body.id]
        if any(set(one) != body.states for one in told):
            yield scene.found(scene.things[body.id], f"is {', '.join(sorted(body.states))}")


def edges(scene: Scene) -> Iterator[Finding]:
    """Edges that do not hold, and relations that hold without an edge."""
    world = world_of(scene)
    rooms = {(id, "INSIDE", world.rooms(id)[0]) for id in world.bodies if world.rooms(id)}
    found = {
        (id, relation, one.target)
        for id in world.bodies
        for relation in RELATIONS
        for one in world.related(id, relation)
        if one.told.holds
    }
    found |= {edge for edge in rooms if edge[2]}
    told = {edge for edge in scene.edges if edge[0] in world.bodies}
    for id, relation, other in sorted(found ^ told):
        word = "not " if (id, relation, other) in found else ""
        what = f"{word}{relation} {world.category(other)} {other} in the graph"
        yield scene.found(scene.things[id], what)


def tags(scene: Scene) -> Iterator[Finding]:
    """Tags of objects against what is measured."""
    world = world_of(scene)
    for body in world.bodies.values():
        expected = _tags(world, body.id)
        told = set(scene.nodes[body.id]["tags"])
        for tag in sorted(expected ^ told):
            word = "not " if tag in expected else ""
            yield scene.found(scene.things[body.id], f"{word}{tag} in the graph")


def _tags(world: World, id: int) -> set[str]:
    body = world.bodies[id]
    found = {
        f"IN_{kind.upper()}"
        for kind in ("doorway", "walkway")
        # As measured: of what is surely at its height and of all that may be, either will do.
        if any(share >= 0.5 - 1e-9 and t.holds for _, share, t in world.in_zones(id, [kind]))
    }
    shut = any(
        one.told.holds and one.leaf is not None and "CLOSED" in one.leaf[0]
        for one in world.related(id, "INSIDE")
    )
    if not body.fixed and not shut and world.reach(id)[0] <= CHILD_REACH_M + 1e-9:
        found.add("IN_REACH_OF_CHILD")
    point = shapely.Point(body.center[:2])
    on = [world.bodies[o.target] for o in world.related(id, "ON") if o.target in world.bodies]
    on = [b for b in on if any(o.target == b.id and o.told.holds for o in world.related(id, "ON"))]
    for surface in (s for holder in on for s in holder.surfaces):
        near = ON_GAP.at_most(abs(float(body.low[2]) - surface.z)).holds and surface.level.holds
        if near and surface.outline.exterior.distance(point) < NEAR_EDGE_M:
            found.add("NEAR_EDGE")
    return found
