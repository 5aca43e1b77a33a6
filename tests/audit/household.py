"""Do the people of a scene live in its home, and is what they want reported told rightly?"""

from __future__ import annotations

import re
from collections.abc import Iterator

from tests.audit.dataset import Finding, Json, Scene

#: An adult's bed this wide sleeps two, metres (a European double is 1.4 and wider).
DOUBLE_M = 1.3
BEDS = {"bed", "child_bed", "crib"}
#: A baby climbs on nothing: children get onto chairs by 18 months (CDC, developmental milestones).
CLIMBS_AT = 1
#: Nobody is silent about these: fire, and a home that stands open.
NEVER_SILENT = {"candle_on", "stove_on", "front_door_open"}
#: Children up to this age sleep in a child's room, a crib or a child's bed of their own.
OLDEST_CHILD = 12


def lives_here(member: Json) -> bool:
    return "visiting" not in str(member["role"])


def nowhere_to_live(scene: Scene) -> Iterator[Finding]:
    """Children without a room or bed of theirs, and more people than beds."""
    members = [m for m in scene.household["members"] if lives_here(m)]
    children = [m for m in members if m["age"] <= OLDEST_CHILD]
    beds = [t for t in scene.furniture if t.category in BEDS]
    kinds = {t.category for t in beds}
    types = {room["type"] for room in scene.rooms.values()}
    if children and "child_room" not in types and not kinds & {"child_bed", "crib"}:
        yield scene.found(None, "a child lives here without a child's room, bed or crib")
    if "child_room" in types and not [m for m in scene.household["members"] if m["age"] <= 17]:
        yield scene.found(None, "a child's room in a home of adults")
    places = sum(
        2 if t.category == "bed" and sorted(t.record["extents_m"][:2])[0] >= DOUBLE_M else 1
        for t in beds
    )
    if places < len(members):
        yield scene.found(None, f"{len(members)} people and beds for {places}")


def pets(scene: Scene) -> Iterator[Finding]:
    """Bowls without a pet, pets without a bowl."""
    bowls = [t for t in scene.things.values() if t.category == "pet_bowl"]
    if bowls and not scene.household["pets"]:
        yield scene.found(bowls[0], "a pet's bowl and no pet")
    if scene.household["pets"] and not bowls:
        yield scene.found(None, f"{scene.household['pets'][0]} without a bowl")


def silent_about_fire(scene: Scene) -> Iterator[Finding]:
    """Labels of fire or an open front door that nobody is told."""
    for label in scene.labels["anomalies"]:
        if label["hazard"] in NEVER_SILENT and not label["report"]:
            yield scene.found(scene.things[label["object_id"]], f"silent: {label['reason']}")
    for hazard, choice in scene.household["notifications"].items():
        if hazard in NEVER_SILENT and choice == "silent":
            yield scene.found(None, f"the household is silent about {hazard}")


def reasons(scene: Scene) -> Iterator[Finding]:
    """Reasons and messages that do not read like sentences."""
    for label in scene.labels["anomalies"]:
        for name in ("reason", "message"):
            text = label[name]
            if re.search(r"-0\.0+\b|\b(None|nan)\b|\s\s|[{}]|_", text):
                yield scene.found(scene.things[label["object_id"]], f"{name}: {text!r}")


def report(scene: Scene) -> Iterator[Finding]:
    """``report`` and ``notify`` against the documented rule: concern, choice, urgency.

    Where one lives with a pet or a condition that raises a hazard, it is told at once.
    """
    lived_with = {*scene.household["pets"], *scene.household["conditions"]}
    ages = [member["age"] for member in scene.household["members"]]
    for label in scene.labels["anomalies"]:
        hazard = scene.catalogue.hazards[label["hazard"]]
        oldest = hazard["concerns"]["max_age"]
        young = [age for age in ages if oldest is None or age <= oldest]
        if hazard["concerns"]["by_reach"]:
            height = label["evidence"].get("reach_height_m", 0.0)
            above_floor = label["evidence"].get("height_m", height)
            young = [
                age
                for age in young
                if scene.catalogue.reach(age) >= (height if age >= CLIMBS_AT else above_floor)
            ]
        chosen = scene.household["notifications"].get(label["hazard"])
        notify = chosen or ("summary" if hazard["urgency"] == "low" else "now")
        if not young:
            notify = "silent"
        for raised in hazard["concerns"].get("raised_by", []):
            if lived_with & set(raised["living_with"]):
                notify = "now"
        if (label["notify"], label["report"]) != (notify, notify != "silent"):
            told = f"notify {label['notify']}, report {label['report']}, by the rule {notify}"
            yield scene.found(scene.things[label["object_id"]], f"{label['hazard']}: {told}")
