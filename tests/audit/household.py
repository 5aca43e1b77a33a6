"""Do the people of a scene live in its home, and is what they want reported told rightly?"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator

from tests.audit.dataset import Finding, Json, Scene

#: An adult's bed this wide sleeps two, metres (a European double is 1.4 and wider).
DOUBLE_M = 1.3
BEDS = {"bed", "child_bed", "crib"}
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


def template(scene: Scene) -> Iterator[Finding]:
    """Members, rooms, traits, choices and opt-outs that the household's template does not give."""
    told = scene.household
    rule = scene.catalogue.households[told["template"]]
    if len(told["members"]) != len(rule["members"]):
        yield scene.found(None, "other members than its template's", len(told["members"]))
        return
    before: int | None = None
    for member, asked in zip(told["members"], rule["members"], strict=True):
        age, after = member["age"], asked["years_after"]
        younger = 0 if after is None or before is None else before - age
        least, most = asked["age"]
        if member["role"] != asked["role"] or not least <= age <= most:
            yield scene.found(None, f"{asked['role']} of {least} to {most} is {member}")
        elif after is not None and not after[0] <= younger <= after[1]:
            yield scene.found(
                None, f"{asked['role']} of {age}, younger than the one before", younger
            )
        before = age
    have = Counter(room["type"] for room in scene.rooms.values())
    for kind, many in Counter(rule["rooms"]).items():
        if have[kind] < many:
            yield scene.found(None, f"lives in a home with {kind}s of {many}", have[kind])
    for kind in ("pets", "conditions", "opt_outs"):
        for word in set(told[kind]) - {trait["name"] for trait in rule[kind]}:
            yield scene.found(None, f"{kind}: {word} is none of {rule['name']}'s")
    for hazard, choices in rule["notifications"].items():
        known = hazard in scene.catalogue.hazards
        if known and told["notifications"].get(hazard) not in choices:
            yield scene.found(None, f"chose nothing of {choices} for {hazard}")
    for hazard in told["notifications"].keys() - rule["notifications"].keys():
        yield scene.found(None, f"chose for {hazard}, of which its template says nothing")


def pets(scene: Scene) -> Iterator[Finding]:
    """Bowls without a pet, pets without a bowl."""
    bowls = [t for t in scene.things.values() if t.category == "pet_bowl"]
    # Hazards are drawn before households: a bowl on a table may be a visitor's.
    put = scene.hazards_of.keys() | scene.lookalikes
    if [t for t in bowls if t.id not in put] and not scene.household["pets"]:
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
