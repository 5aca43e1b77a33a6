"""All checks by name, and those that the suite enforces."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np

from tests.audit import (
    clutter,
    drawn,
    facing,
    graph,
    hazards,
    household,
    labels,
    leaves,
    notice,
    physics,
    pictures,
    undone,
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
    "household: report and notify": notice.report,
    "household: not of its template": household.template,
    "labels: words": notice.words,
    "clutter: copies side by side": clutter.copies,
    "clutter: soaps": clutter.soaps,
    "clutter: two knife blocks": clutter.knife_blocks,
    "clutter: not frozen, in a freezer": clutter.in_the_freezer,
    "clutter: odd places": clutter.odd_places,
    "clutter: odd on a floor": clutter.odd_floors,
    "labels: do not hold": labels.listed,
    "labels: unlisted": labels.unlisted,
    "labels: evidence": labels.evidence,
    "labels: states": labels.states,
    "labels: implied by nothing": drawn.implied,
    "graph: boxes": graph.boxes,
    "graph: CLOSE": graph.close,
    "graph: ON": graph.on,
    "graph: INSIDE": graph.inside,
    "graph: FACING": graph.facing,
    "graph: zones and BLOCKS": graph.zones,
    "graph: edges anew": labels.edges,
    "graph: tags anew": labels.tags,
    "pictures: masks and visibility": pictures.visibility,
}


#: What is asked of a twin or a toggle beside its scene.
TWINS: dict[str, Callable[[Scene, Scene], Iterator[Finding]]] = {
    "twins: left or undone": undone.listed,
    "twins: still true": undone.still,
    "twins: against the remedy": undone.obeys,
    "twins: not as their scene": undone.same,
}
#: And of it alone, as of a scene: labels and graph are of what stands there now.
OF_TWINS = {name for name in CHECKS if name.startswith("labels") or name.endswith("anew")}
OF_TWINS |= {"household: report and notify"}
OF_TWINS -= {"labels: implied by nothing"}  # what implied it may be undone


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
#: hazards is wrong for two in five; 80 homes of seed 7 had 69 % and more).
MANY_SEEN, BEYOND_REACH = 30, 0.4


def told_by_name(data: DataSet, scenes: list[Scene]) -> Iterator[Finding]:
    """Classes by reach: is what views show of their categories nearly always a hazard?"""
    for hazard in hazards.BY_REACH:
        seen = [label for scene in scenes for label in hazards.seen_of(scene, hazard)]
        beyond = seen.count(False) / max(len(seen), 1)
        if len(seen) >= MANY_SEEN and beyond < BEYOND_REACH:
            what = f"{hazard}: {seen.count(True)} of {len(seen)} that views show are labelled"
            yield Finding("all", None, what, beyond)


#: A count differs when it does so by more than so many standard errors: by chance in 1 of 16,000.
ERRORS = 4.0
#: So few homes of either kind say nothing: of 8 open fridges the standard error is 0.6 things.
LEAST_HOMES = 8
#: What a fifth of cold stoves carry none of so many lit ones does in 1 of 100 data sets.
MANY_STOVES = 20


def emptied_when_open(data: DataSet, scenes: list[Scene]) -> Iterator[Finding]:
    """Fridges and freezers that stand open: do they hold less than shut ones?"""
    for category in ("fridge", "freezer"):
        held: dict[bool, list[float]] = {True: [], False: []}
        for scene in scenes:
            inside = [b for bs in scene.related("INSIDE").values() for b in bs]
            for item in scene.scene["objects"]:
                if item["category"] == category:
                    held["OPEN" in item["states"]].append(inside.count(item["id"]))
        if differ(held[True], held[False]):
            what = f"{category}: {np.mean(held[True]):.2f} things in open ones, in shut ones"
            yield Finding("all", None, what, float(np.mean(held[False])))


def never_on_a_lit_stove(data: DataSet, scenes: list[Scene]) -> Iterator[Finding]:
    """What stands on cold stoves, but on no lit one."""
    on: dict[bool, list[set[str]]] = {True: [], False: []}
    for scene in scenes:
        kinds = {item["id"]: item["category"] for item in scene.scene["objects"]}
        for item in scene.scene["objects"]:
            if item["category"] == "stove":
                there = {kinds[a] for a, bs in scene.on.items() if item["id"] in bs and a in kinds}
                on["ON" in item["states"]].append(there)
    lit, cold = on[True], on[False]
    for kind in sorted(set().union(*cold)) if len(lit) >= MANY_STOVES else ():
        share = sum(kind in there for there in cold) / len(cold)
        if share > 0.2 and not any(kind in there for there in lit):
            yield Finding("all", None, f"{kind} on none of {len(lit)} lit stoves, of cold", share)


def counted(data: DataSet, scenes: list[Scene]) -> Iterator[Finding]:
    """Candles that stand in homes where one burns, and in others: does their number tell?"""
    number: dict[bool, list[float]] = {True: [], False: []}
    for scene in scenes:
        kinds = [item["category"] for item in scene.scene["objects"]]
        burns = any("candle_on" in names for names in scene.hazards_of.values())
        number[burns].append(kinds.count("candle"))
    if differ(number[True], number[False]):
        what = f"{np.mean(number[True]):.2f} candles in homes where one burns, in others"
        yield Finding("all", None, what, float(np.mean(number[False])))


def differ(some: list[float], others: list[float]) -> bool:
    """Whether the means of two samples differ by more than chance does (Welch)."""
    if min(len(some), len(others)) < LEAST_HOMES:
        return False
    error = np.sqrt(np.var(some, ddof=1) / len(some) + np.var(others, ddof=1) / len(others))
    return bool(abs(np.mean(some) - np.mean(others)) > max(ERRORS * error, 0.25))


#: Checks of a whole data set; what takes many homes to say is silent on few.
WHOLE: dict[str, Callable[[DataSet, list[Scene]], Iterator[Finding]]] = {
    "drawn: not as asked": drawn.as_asked,
    "drawn: dealt unevenly": drawn.dealt_evenly,
    "drawn: counted in the manifest": drawn.counted_in_manifest,
    "household: trait shares": drawn.trait_shares,
    "variety: categories never seen": never_seen,
    "variety: always wide open": always_wide_open,
    "variety: ages": ages_stop_short,
    "variety: hazards by their name": told_by_name,
    "counts: open fridges and shut ones": emptied_when_open,
    "counts: on lit stoves and cold ones": never_on_a_lit_stove,
    "counts: candles": counted,
}


def run(data: DataSet, limit: int | None = None, only: str = "") -> dict[str, list[Finding]]:
    """The findings of every check (whose name holds ``only``) on a data set, by its name."""
    names = [name for name in (*CHECKS, *TWINS, *WHOLE) if only in name]
    found: dict[str, list[Finding]] = {name: [] for name in names}
    looked_at = []
    for scene in data.scenes():
        if limit is not None and len(looked_at) == limit:
            break
        for name in found.keys() & CHECKS.keys():
            found[name].extend(CHECKS[name](scene))
        for twin in data.twins_of(scene) if found.keys() & (OF_TWINS | TWINS.keys()) else ():
            for name in found.keys() & OF_TWINS:
                found[name].extend(CHECKS[name](twin))
            for name in found.keys() & TWINS.keys():
                found[name].extend(TWINS[name](scene, twin))
        # Meshes where they stand are many: only what whole checks need is kept.
        looked_at.append(Scene(scene.folder, scene.models, scene.catalogue))
    for name in found.keys() & WHOLE.keys():
        found[name].extend(WHOLE[name](data, looked_at))
    return found
