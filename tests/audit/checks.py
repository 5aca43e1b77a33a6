"""All checks by name, and those that the suite enforces."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from tests.audit import (
    clutter,
    facing,
    graph,
    hazards,
    household,
    leaves,
    physics,
    pictures,
    walking,
)
from tests.audit.dataset import DataSet, Finding, Scene

Check = Callable[[Scene], Iterator[Finding]]

#: Every check of one scene, in the order of the table.
CHECKS: dict[str, Check] = {
    "tripping: in the way, unlabelled": walking.in_the_way,
    "tripping: labelled, in nobody's way": walking.in_nobodys_way,
    "reach: unlabelled and within reach": hazards.within_reach,
    "food: cut, opened or cream, out": hazards.food_out,
    "food: frozen, in the fridge": hazards.frozen_thaws,
    "sharp: bare blades on a stand": hazards.bare_blades,
    "alcohol: filled glasses": hazards.alcohol,
    "choking: grapes": hazards.grapes,
    "choking: labelled, too large": hazards.too_large_to_choke,
    "expired: overripe, unlabelled": hazards.overripe,
    "physics: in the air": physics.floating,
    "physics: shards in the air": physics.shards_in_air,
    "physics: into walls": physics.into_walls,
    "physics: small things in things": physics.entangled,
    "physics: furniture in furniture": physics.furniture_in_furniture,
    "physics: through rugs and mats": physics.through_rugs,
    "leaves: cannot open": leaves.cannot_open,
    "rooms: unreachable": walking.unreachable,
    "rooms: no room before it": walking.cannot_be_used,
    "facing: frames and screens at a wall": facing.faces_wall,
    "facing: chairs and their tables": facing.chairs_at_tables,
    "household: does not live there": household.nowhere_to_live,
    "household: pets and bowls": household.pets,
    "household: silent about fire": household.silent_about_fire,
    "household: reasons as text": household.reasons,
    "household: report and notify": household.report,
    "clutter: copies side by side": clutter.copies,
    "clutter: soaps": clutter.soaps,
    "clutter: two knife blocks": clutter.knife_blocks,
    "clutter: not frozen, in a freezer": clutter.in_the_freezer,
    "clutter: odd places": clutter.odd_places,
    "clutter: odd on a floor": clutter.odd_floors,
    "graph: boxes": graph.boxes,
    "graph: CLOSE": graph.close,
    "graph: ON": graph.on,
    "graph: INSIDE": graph.inside,
    "graph: FACING": graph.facing,
    "graph: zones and BLOCKS": graph.zones,
    "pictures: masks and visibility": pictures.visibility,
}


#: So many homes show what a data set lacks.
MANY = 300
#: And so many labels: one in seven stands ajar, so that none of them does in 2 of 1,000 data sets.
MANY_LABELS = 40


def never_seen(data: DataSet, scenes: list[Scene]) -> Iterator[Finding]:
    """Categories of the library that no scene of many shows."""
    if len(scenes) < MANY:
        return
    seen = {o["category"] for scene in scenes for o in scene.scene["objects"]}
    for category in sorted(data.models.library - seen):
        yield Finding("all", None, f"{category} in none of {len(scenes)} homes")


def always_wide_open(data: DataSet, scenes: list[Scene]) -> Iterator[Finding]:
    """Labelled doors and fridges: is some ajar (opened less than 0.5 rad)?"""
    for hazard in ("front_door_open", "fridge_open"):
        least = [
            max(abs(value) for value in scene.things[id].json["joints"].values())
            for scene in scenes
            for id, names in scene.hazards_of.items()
            if hazard in names
        ]
        if len(least) >= MANY_LABELS and min(least) > 0.5:
            yield Finding("all", None, f"{hazard}: all {len(least)} wide open", min(least))


def ages_stop_short(data: DataSet, scenes: list[Scene]) -> Iterator[Finding]:
    """Is there any infant among many households?"""
    ages = [m["age"] for scene in scenes for m in scene.household["members"]]
    if len(scenes) >= MANY and min(ages) > 0:
        yield Finding("all", None, "nobody is younger than a year", min(ages))


#: Of a class by reach, so many things that a view shows say whether its name alone tells it, and so
#: many of them at least lie where no child gets to (a judgement: a detector that calls all of them
#: hazards is wrong for one in five).
MANY_SEEN, BEYOND_REACH = 30, 0.2


def told_by_name(data: DataSet, scenes: list[Scene]) -> Iterator[Finding]:
    """Classes by reach: is what views show of their categories nearly always a hazard?"""
    for hazard in hazards.BY_REACH:
        seen = [label for scene in scenes for label in hazards.seen_of(scene, hazard)]
        beyond = seen.count(False) / max(len(seen), 1)
        if len(seen) >= MANY_SEEN and beyond < BEYOND_REACH:
            what = f"{hazard}: {seen.count(True)} of {len(seen)} that views show are labelled"
            yield Finding("all", None, what, beyond)


#: Checks of a whole data set; what takes many homes to say is silent on few.
WHOLE: dict[str, Callable[[DataSet, list[Scene]], Iterator[Finding]]] = {
    "variety: categories never seen": never_seen,
    "variety: always wide open": always_wide_open,
    "variety: ages": ages_stop_short,
    "variety: hazards by their name": told_by_name,
}


def run(data: DataSet, limit: int | None = None, only: str = "") -> dict[str, list[Finding]]:
    """The findings of every check (whose name holds ``only``) on a data set, by its name."""
    names = [name for name in (*CHECKS, *WHOLE) if only in name]
    found: dict[str, list[Finding]] = {name: [] for name in names}
    looked_at = []
    for scene in data.scenes():
        if limit is not None and len(looked_at) == limit:
            break
        for name in found.keys() & CHECKS.keys():
            found[name].extend(CHECKS[name](scene))
        # Meshes where they stand are many: only what whole checks need is kept.
        looked_at.append(Scene(scene.folder, scene.models, scene.catalogue))
    for name in found.keys() & WHOLE.keys():
        found[name].extend(WHOLE[name](data, looked_at))
    return found
