"""Hazards in their plain meaning that no label names, and labels that a person would not give.

What a safety expert calls a hazard is said here anew, with sources, not read from the catalogue;
of that come only the classes' categories, the ages they concern and the reach by age.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

import numpy as np
import numpy.typing as npt
import shapely

from tests.audit.clutter import FROZEN, freezer_for
from tests.audit.dataset import Finding, Scene, Thing

Floats = npt.NDArray[np.float64]

#: What a small child climbs on to reach what is near, by property or name.
CLIMBED = {"SITTABLE", "LIEABLE"}
#: And low furniture with a top that carries a child (CPSC, Anchor It!: children climb on furniture
#: and television stands).
LOW = {
    *("step_stool", "coffee_table", "side_table", "nightstand", "tv_stand", "shoe_rack"),
    "toy_box",
}
#: How near what is climbed on has to stand, metres, and how high it may be (judgement: a step of
#: 0.7 m is as high as the hips of a five-year-old).
BESIDE_M, STEP_M = 0.5, 0.7
#: Classes by reach and the oldest child they concern.
BY_REACH = {"choking_hazard": 3, "poison_cleaning": 6, "poison_medication": 6, "sharp_object": 8}
#: U.S. FDA, "Selecting and Serving Produce Safely": refrigerate all produce that is cut or peeled.
CUT = re.compile(r"\b(half|halves|wedges?|slices|sliced|cut|peeled|pieces)\b")
#: USDA FSIS: what is left of an opened tin goes into the fridge within two hours; so do cakes
#: filled or topped with cream, juice that is opened (a straw is in it) and blended fruit.
OPENED = re.compile(r"\bopened (tin|jar)\b|\bcream cake\b|\bwith a straw\b|\bblender\b.*\bfull\b")
#: Cut and yet dry: no food that spoils.
KEEPS = {"bread", "cheese", "cake", "chocolate_bar", "strawberries", "cutting_board"}
#: Spotted bananas are ripe (FoodKeeper); other produce with brown spots is not what a person would
#: still eat without a second look.
EATEN_RIPE = {"banana"}
GLASSES = {"wine_glass", "drinking_glass"}
COLD = {"fridge", "freezer", "trash_bin"}
#: 16 CFR 1501.4: the small-parts cylinder, metres.
CYLINDER_WIDTH_M, CYLINDER_DEPTH_M = 0.0317, 0.0571
#: Models that are a few loose pieces; of others the whole has to fit.
SEVERAL = {"marbles", "coins", "button_batteries", "dice", "bottle_caps", "hair_clips"} | {
    "toy_brick",
    "wooden_beads",
}


def is_shut_in(scene: Scene, thing: Thing) -> bool:
    """Whether it is in a hollow whose own leaf, lid or drawer is shut, or in a knife block."""
    middle = ((thing.box[0] + thing.box[1]) / 2)[None]
    for b in scene.inside.get(thing.id, []):
        holder = scene.things[b]
        if holder.category == "knife_block":
            return True
        for hollow in holder.record["containers"]:
            if hollow["closed_by"] is None:
                continue
            part = next((p for p in holder.parts if p.name == hollow["part"]), None)
            if part is None:
                continue
            away = np.abs(part.local(middle)[0] - hollow["center_m"])
            if (away <= np.array(hollow["size_m"]) / 2 + 0.005).all():
                return abs(holder.json["joints"][hollow["closed_by"]]) <= 0.05
    return False


def steps(scene: Scene) -> list[tuple[shapely.Geometry, float, Thing]]:
    """What a child climbs on: its footprint and how high it lifts the child, metres."""
    found = []
    for thing in scene.things.values():
        properties = scene.catalogue.properties.get(thing.category, [])
        if not CLIMBED & set(properties) and thing.category not in LOW:
            continue
        tops = [
            (shapely.Polygon(s["polygon_m"]).area, s["z_m"])
            for s in thing.record["supports"]
            if s["z_m"] + thing.position[2] <= STEP_M
        ]
        # A toilet's lid and the rim of a bath are no supports: about seat height.
        top = max(tops)[1] if tops else min(thing.height, 0.45)
        found.append((thing.footprint, float(top + thing.position[2]), thing))
    return found


def within_reach(scene: Scene) -> Iterator[Finding]:
    """What children of a class's age can reach, from the floor or a seat beside it."""
    climbed = steps(scene)
    for hazard, age in BY_REACH.items():
        arm = scene.catalogue.reach(age)
        # Glasses are poison when filled, which is a check of its own.
        categories = scene.catalogue.categories_of(hazard) - GLASSES
        for thing in scene.things.values():
            if thing.category not in categories or hazard in scene.hazards_of.get(thing.id, set()):
                continue
            if is_shut_in(scene, thing):
                continue
            if thing.bottom <= arm:
                yield scene.found(thing, f"{hazard}: within a child's reach", thing.bottom)
                continue
            for footprint, height, seat in climbed:
                near = footprint.distance(thing.footprint) <= BESIDE_M
                same = seat.room == thing.room and seat.id != thing.id
                if near and same and thing.bottom <= height + arm:
                    what = f"{hazard}: within reach from {seat.category} {seat.id}"
                    yield scene.found(thing, what, thing.bottom)
                    break


def seen_of(scene: Scene, hazard: str) -> Iterator[bool]:
    """Of each thing of a class's categories that some view shows as large as a label's evidence:
    is it labelled?"""
    categories = scene.catalogue.categories_of(hazard) - GLASSES
    pixels: dict[int, int] = {}
    for view in scene.visibility["views"]:
        for item in view["objects"]:
            id = item["object_id"]
            pixels[id] = max(pixels.get(id, 0), item["pixels"])
    for item in scene.scene["objects"]:
        shown = pixels.get(item["id"], 0) >= scene.visibility["evidence_pixels_needed"]
        if item["category"] in categories and shown:
            yield hazard in scene.hazards_of.get(item["id"], set())


def kept_cold(scene: Scene, thing: Thing) -> bool:
    return any(scene.things[b].category in COLD for b in scene.inside.get(thing.id, []))


def food_out(scene: Scene) -> Iterator[Finding]:
    """Cut fruit and vegetables, opened tins and cream cakes that are not in the cold."""
    produce = scene.catalogue.categories_of("expired_produce") - KEEPS
    for thing in scene.small:
        cut = thing.category in produce and CUT.search(thing.title)
        if not (cut or OPENED.search(thing.title)) or kept_cold(scene, thing):
            continue
        if not scene.hazards_of.get(thing.id):
            yield scene.found(thing, f"{thing.title!r} is not in the cold")


def frozen_thaws(scene: Scene) -> Iterator[Finding]:
    """Frozen food in the fridge's own compartment, unlabelled."""
    for thing in scene.small:
        frozen = thing.category in FROZEN and freezer_for(scene, thing.id) == "fridge"
        if frozen and not scene.hazards_of.get(thing.id):
            yield scene.found(thing, "frozen, in the fridge's compartment")


def bare_blades(scene: Scene) -> Iterator[Finding]:
    """Stands that show their blades within reach."""
    arm = scene.catalogue.reach(BY_REACH["sharp_object"])
    for thing in scene.things.values():
        bare = "knife" in thing.title and "magnetic" in thing.title
        if bare and thing.bottom <= arm and not scene.hazards_of.get(thing.id):
            yield scene.found(thing, "bare blades within reach", thing.bottom)


def alcohol(scene: Scene) -> Iterator[Finding]:
    """Glasses with wine, brandy or beer in them within reach."""
    arm = scene.catalogue.reach(BY_REACH["poison_medication"])
    for thing in scene.small:
        full = "FULL" in thing.states or "with wine" in thing.title
        if thing.category != "wine_glass" and "beer" not in thing.title:
            continue
        if not full or "BROKEN" in thing.states or thing.category not in GLASSES:
            continue
        within = thing.bottom <= arm and not is_shut_in(scene, thing)
        if within and not scene.hazards_of.get(thing.id):
            yield scene.found(thing, "a filled glass within reach", thing.bottom)


def grapes(scene: Scene) -> Iterator[Finding]:
    """Grapes that a small child can reach (American Academy of Pediatrics, Pediatrics 125(3))."""
    arm = scene.catalogue.reach(BY_REACH["choking_hazard"])
    for thing in scene.small:
        if thing.category != "grapes" or thing.bottom > arm or scene.hazards_of.get(thing.id):
            continue
        if not is_shut_in(scene, thing) and not kept_cold(scene, thing):
            yield scene.found(thing, "grapes within reach", thing.bottom)


def overripe(scene: Scene) -> Iterator[Finding]:
    """Unlabelled produce that looks spoiled: overripe, and not of a kind that is eaten so."""
    for thing in scene.small:
        ripe = "OVERRIPE" in thing.states and thing.category not in EATEN_RIPE
        if ripe and not scene.hazards_of.get(thing.id):
            yield scene.found(thing, "overripe, unlabelled")


def fits_cylinder(points: Floats) -> bool:
    """Whether points fit the small-parts cylinder along one of their main axes."""
    _, _, axes = np.linalg.svd(points - points.mean(0), full_matrices=False)
    for frame in (axes, np.eye(3)):
        turned = points @ frame.T
        for k in range(3):
            across = np.delete(turned, k, axis=1)
            circle = shapely.minimum_bounding_radius(shapely.multipoints(across))
            if np.ptp(turned[:, k]) <= CYLINDER_DEPTH_M and 2 * circle <= CYLINDER_WIDTH_M:
                return True
    return False


def too_large_to_choke(scene: Scene) -> Iterator[Finding]:
    """Choking labels of things of which nothing fits the small-parts cylinder.

    Balloons and grapes choke without fitting it: 16 CFR 1500.19 and the AAP name them apart.
    """
    for id, hazards in scene.hazards_of.items():
        thing = scene.things[id]
        if "choking_hazard" in hazards and thing.category not in {"balloon", "grapes"}:
            several = thing.category in SEVERAL
            pieces = [
                part.mesh.vertices[np.unique(part.mesh.faces[faces])]
                for part in thing.parts
                for faces in (part.mesh.pieces if several else [slice(None)])
            ]
            if not any(fits_cylinder(piece) for piece in pieces if len(piece) > 3):
                size = float(sorted(thing.box[1] - thing.box[0])[1])
                yield scene.found(thing, f"{thing.title!r} fits no small-parts cylinder", size)
