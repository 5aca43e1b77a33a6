"""Twins and toggles beside their scenes: what was undone obeys its remedy, all else is the same."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from tests.audit.dataset import Finding, Floats, Json, Scene, joint_motion, rotation
from tests.audit.labels import asked, world_of
from tests.audit.told import YES

#: Actions that put the object elsewhere, and how it then is to its target.
PUT = {"put_in": "INSIDE", "put_on": "ON", "throw_away": "INSIDE", "move_away": "ON"}
#: Actions that bring it back to rest where it is, and those after which it is gone.
SET_BACK = {"close", "switch_off", "put_out", "empty"}
GONE = {"wipe_up", "sweep_up", "throw_away", "take_away"}
#: What a twin's scene has of its own.
OWN = {"id", "twin_of", "objects"}
#: Poses are rounded to 1e-5 m and 1e-6 of a quaternion: what travels is as exact.
TRAVEL = 3e-5


def listed(base: Scene, twin: Scene) -> Iterator[Finding]:
    """Anomalies of the scene that are neither left nor undone, or both; what a toggle is for."""
    every = {one["id"]: (one["object_id"], one["hazard"]) for one in base.labels["anomalies"]}
    left = {one["id"]: (one["object_id"], one["hazard"]) for one in twin.labels["anomalies"]}
    undone = {u["anomaly_id"]: (u["object_id"], u["hazard"]) for u in twin.labels["undone"]}
    for id in sorted(every.keys() | left.keys() | undone.keys()):
        if [*filter(None, (left.get(id), undone.get(id)))] != [every.get(id)]:
            yield twin.found(None, f"{id} is not either left or undone")
    kind = twin.id.partition("-")[2]
    if kind == "twin" and left:
        yield twin.found(None, "a twin with anomalies", len(left))
    if kind.startswith("undo-") and kind.removeprefix("undo-") not in undone:
        yield twin.found(None, "a toggle that does not undo its anomaly")
    same = {one["id"]: one for one in base.labels["anomalies"]}
    for one in twin.labels["anomalies"]:
        was = same.get(one["id"], {})
        for key in ("hazard", "object_id", "drawn"):
            if was.get(key) != one[key]:
                yield twin.found(None, f"{one['id']}: {key} was {was.get(key)!r}")


def still(base: Scene, twin: Scene) -> Iterator[Finding]:
    """Anomalies said to be undone that are not surely gone, and pairs that did not hold before."""
    before = set(asked(base))
    for pair, (told, _) in asked(twin).items():
        undone = any((u["object_id"], u["hazard"]) == pair for u in twin.labels["undone"])
        if undone or pair not in before:
            what = "holds" if told == YES else "is undecided"
            yield twin.found(twin.things[pair[0]], f"{pair[1]} {what} in the twin")


def obeys(base: Scene, twin: Scene) -> Iterator[Finding]:
    """What was done against the remedies of the object's hazards."""
    world = world_of(twin)
    for one in twin.labels["undone"]:
        id, action, target = one["object_id"], one["action"], one["target_id"]
        was, now = base.things.get(id), twin.things.get(id)
        if was is None:
            yield twin.found(None, f"{one['anomaly_id']}: {id} was never there")
            continue
        rules = [
            rule
            for label in base.labels["anomalies"]
            if label["object_id"] == id
            for rule in base.catalogue.hazards[label["hazard"]]["remedy"]
            if rule["action"] == action
        ]

        def wrong(what: str, of: Json = one) -> Finding:
            return twin.found(base.things[of["object_id"]], f"{of['anomaly_id']}: {what}")

        if (now is None) != one["removed"]:
            yield wrong("is gone" if now is None else "is there and said to be gone")
            continue
        if action is None:
            continue
        if action != "take_away" and not rules:
            yield wrong(f"{action} is none of its remedies")
        if now is None:
            if action not in GONE or target is not None:
                yield wrong(f"{action} should leave it there")
            continue
        placed = any(
            u["object_id"] == id and u["action"] in PUT and u["target_id"] is not None
            for u in twin.labels["undone"]
        )
        moved = now.json["pose"] != was.json["pose"]
        if placed and not (moved and one["moved"]):
            yield wrong("was put nowhere else")
        if target is None:
            if action in PUT and not placed:
                yield wrong(f"{action} without a target")
            if action in SET_BACK and now.json["variant"] == was.json["variant"]:
                rest = now.json["joints"] == was.json["joints"]
                if rest:
                    yield wrong(f"{action} changed nothing of it")
            continue
        allowed = {name for rule in rules for name in rule["targets"]}
        allowed |= {"floor"} if action == "move_away" else set()
        related = world.related(id, PUT.get(action, "ON"))
        if action not in PUT or world.category(target) not in allowed:
            yield wrong(f"{target} is no target of {action}")
        elif not any(r.target == target and r.told == YES for r in related):
            yield wrong(f"is not {PUT[action]} {target}")


def same(base: Scene, twin: Scene) -> Iterator[Finding]:
    """All that a twin has otherwise than its scene and nobody said so: objects, home, household,
    cameras, near misses."""
    for key in (base.scene.keys() | twin.scene.keys()) - OWN:
        if base.scene.get(key) != twin.scene.get(key):
            yield twin.found(None, f"{key} of scene.json is another")
    if base.household != twin.household:
        yield twin.found(None, "another household")
    if base.views != twin.views:
        yield twin.found(None, "other cameras")
    yield from _objects(base, twin)
    known = {(one["object_id"], one["near_miss_of"]) for one in base.labels["lookalikes"]}
    told = {(one["object_id"], one["near_miss_of"]) for one in twin.labels["lookalikes"]}
    changed = {id for id, _ in known if _item(base, id) != _item(twin, id)}
    for id, miss in sorted(known ^ told):
        if (id, miss) in told or id not in changed:
            yield twin.found(base.things.get(id), "is another near miss in the twin")


def _item(scene: Scene, id: int) -> Json | None:
    return scene.things[id].json if id in scene.things else None


def _objects(base: Scene, twin: Scene) -> Iterator[Finding]:
    undone = twin.labels["undone"]
    targets = {u["target_id"] for u in undone if u["action"] in ("put_in", "throw_away")}
    done: dict[int, list[Json]] = {}
    for one in undone:
        done.setdefault(one["object_id"], []).append(one)
    motions = _motions(base, twin)
    for id in twin.things.keys() - base.things.keys():
        yield twin.found(twin.things[id], "is new in the twin")
    for id, was in base.things.items():
        now = twin.things.get(id)
        if now is None:
            if not any(u["removed"] for u in done.get(id, [])):
                yield twin.found(was, "is gone, and nobody said so")
            continue
        other = {key for key in was.json if was.json[key] != now.json.get(key)}
        actions = {u["action"] for u in done.get(id, [])}
        allowed: set[str] = set()
        if any(u["moved"] for u in done.get(id, [])):
            allowed |= {"pose", "room_id"}
        if actions & (SET_BACK | {"take_away"}):
            allowed |= {"joints", "variant", "states", "parts"}
        if id in targets and _only_shut(was.json, now.json, was.record):
            allowed |= {"joints", "states"}
        if other - allowed and not (other <= {"pose", "room_id"} and _travels(was, now, motions)):
            yield twin.found(was, f"is another in the twin: {', '.join(sorted(other - allowed))}")


def _only_shut(was: Json, now: Json, record: Json) -> bool:
    """Of a thing's joints those that differ are leaves of its hollows, and at rest now."""
    leaves = {hollow["closed_by"] for hollow in record["containers"]}
    differ = {name for name in was["joints"] if was["joints"][name] != now["joints"].get(name)}
    return differ <= leaves and all(now["joints"][name] == 0.0 for name in differ)


def _motions(base: Scene, twin: Scene) -> list[tuple[Floats, Floats]]:
    """How the parts that joints have moved are moved, in the world: rotations and shifts."""
    found = []
    for id, was in base.things.items():
        now = twin.things.get(id)
        if now is None or now.json["joints"] == was.json["joints"]:
            continue
        for joint in was.record["joints"]:
            values = [t.json["joints"].get(joint["name"], 0.0) for t in (was, now)]
            if values[0] != values[1]:
                (a, p), (b, q) = (joint_motion(joint, value) for value in values)
                turn = was.turn @ b @ a.T @ was.turn.T
                start, end = (was.turn @ shift + was.position for shift in (p, q))
                found.append((turn, end - turn @ start))
    return found


def _travels(was: Any, now: Any, motions: list[tuple[Floats, Floats]]) -> bool:
    """It has moved as a part did that a joint moved: with the drawer it lies in."""
    for turn, shift in motions:
        there = turn @ was.position + shift
        turned = np.abs(turn @ was.turn - rotation(now.json["pose"]["quat_xyzw"])).max()
        if np.abs(there - now.position).max() < TRAVEL and turned < TRAVEL:
            return True
    return False
