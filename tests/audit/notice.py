"""Is each label told to the household as `hazard_catalog/README.md` says, and in its hazard's
words?"""

from __future__ import annotations

from collections.abc import Iterator
from math import dist, inf

from tests.audit.dataset import Finding, Json, Scene
from tests.audit.labels import world_of

#: What each urgency comes to where the household made no choice of its own.
DEFAULT = {"high": "now", "medium": "now", "low": "summary"}
#: What a label copies of its hazard.
COPIED = ("group", "label", "urgency")


def concerned(scene: Scene, hazard: Json, label: Json) -> bool:
    """Whether somebody of the household is concerned by a label of a hazard."""
    told, concerns = scene.household, hazard["concerns"]
    ages = [member["age"] for member in told["members"]]
    thing = scene.things.get(label["object_id"])
    room = None if thing is None else scene.room_type(thing)
    if concerns["rooms"] and room not in concerns["rooms"]:
        return False
    if concerns["who"] == "living_with":
        return bool({*told["pets"], *told["conditions"]} & set(concerns["living_with"]))
    if concerns["who"] == "older_people":
        return any(age >= concerns["min_age"] for age in ages)
    if concerns["who"] == "everyone":
        return True
    young = [age for age in ages if age <= concerns["max_age"]]
    if not concerns["by_reach"]:
        return bool(young)
    from_step = label["evidence"]["reach_height_m"]
    from_floor = label["evidence"].get("height_m", from_step)
    return any(grasps(scene, age, from_floor, from_step) for age in young)


def grasps(scene: Scene, age: int, from_floor: float, from_step: float) -> bool:
    """Whether a child of that age reaches so high: from what it climbs on where it climbs."""
    row = next((r for r in scene.catalogue.grasps if age <= r["max_age"]), None)
    if row is None:
        return True
    return bool(row["reach_m"] >= (from_step if row["climbs"] else from_floor))


def rule(scene: Scene, hazard: Json, label: Json) -> str:
    """How a label is to be notified."""
    told = scene.household
    lives_with = {*told["pets"], *told["conditions"]}
    if any(lives_with & set(by["living_with"]) for by in hazard["concerns"]["raised_by"]):
        return "now"
    if not concerned(scene, hazard, label):
        return "silent"
    if not hazard["never_silent"] and {hazard["id"], hazard["group"]} & set(told["opt_outs"]):
        return "silent"
    chosen = told["notifications"].get(hazard["id"])
    if chosen is None or (chosen == "silent" and hazard["never_silent"]):
        return DEFAULT[hazard["urgency"]]
    return str(chosen)


def report(scene: Scene) -> Iterator[Finding]:
    """``report`` and ``notify`` against the documented rule: concern, opt-out, choice, urgency.

    Where one lives with a pet or a condition that raises a hazard, it is told at once.
    """
    for label in scene.labels["anomalies"]:
        hazard = scene.catalogue.hazards[label["hazard"]]
        notify = rule(scene, hazard, label)
        if (label["notify"], label["report"]) != (notify, notify != "silent"):
            told = f"notify {label['notify']}, report {label['report']}, by the rule {notify}"
            yield scene.found(scene.things.get(label["object_id"]), f"{label['hazard']}: {told}")


def words(scene: Scene) -> Iterator[Finding]:
    """What a label says of its hazard and its object: group, urgency, severity, message, remedy."""
    world = world_of(scene)
    for label in scene.labels["anomalies"]:
        thing = scene.things.get(label["object_id"])
        if thing is None:
            continue  # its predicate is not true
        hazard = scene.catalogue.hazards[label["hazard"]]
        severity = hazard["severity"] and hazard["severity"]["harm"]
        target = label["target_id"]
        message = hazard["message"]
        for key, word in {
            "object": thing.category,
            "target": "" if target is None else world.category(target),
            "room": scene.room_type(thing),
        }.items():
            message = message.replace("{" + key + "}", word.replace("_", " "))
        remedy = [
            {
                "action": one["action"],
                "object_id": thing.id,
                "target_id": near(scene, thing.id, one),
            }
            for one in hazard["remedy"]
        ]
        asked = {key: hazard[key] for key in COPIED} | {
            "severity": severity,
            "message": message,
            "remedy": remedy,
            "category": thing.category,
            "room_id": thing.room,
        }
        for key, value in asked.items():
            if label[key] != value:
                yield scene.found(thing, f"{label['hazard']}: {key} is {label[key]!r}")
        held = label["relation"] is None and target is None
        if not held and (thing.id, label["relation"], target) not in scene.edges:
            yield scene.found(thing, f"is not {label['relation']} {target}")


def near(scene: Scene, id: int, remedy: Json) -> int | None:
    """The nearest thing of a remedy's target categories, from centre to centre."""
    world = world_of(scene)
    here = world.bodies[id].center
    best, found = inf, None
    for other in sorted(world.of(remedy["targets"]), key=lambda body: body.id):
        if other.id != id and dist(here, other.center) < best:
            best, found = dist(here, other.center), other.id
    return found
