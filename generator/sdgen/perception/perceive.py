"""The scene that can be made out of a home from its pictures, in a scene's own records.

Given are, as to a robot that lives there: the plan (rooms, walls, doors, windows), where the
cameras stood, and a recogniser that names each object it is shown, which way round it is, which
parts of it stand open, and the states whose evidence is in view. What is where, how large it is
and what stands on or in what is made out from depth alone.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

import numpy as np

from sdgen.catalog.records import Catalog
from sdgen.facts import bodies_of
from sdgen.facts.rooms import Rooms
from sdgen.freespace import free_shape, rounded_rings
from sdgen.library.records import AssetInfo
from sdgen.library.states import rule_holds
from sdgen.perception.clouds import Cloud, View, clouds
from sdgen.perception.coarse import coarse
from sdgen.perception.kinds import Kinds
from sdgen.perception.noise import Draws
from sdgen.perception.options import Perception
from sdgen.perception.perceived import Perceived
from sdgen.perception.records import records_of
from sdgen.perception.standing import settle
from sdgen.perception.things import Thing, thing_of
from sdgen.scene import ObjectInstance, Scene, Zone
from sdgen.truth.visibility import evidence_pixels_needed
from sdgen.zones import derive_zones, floor_obstacles

#: Of the pixels that make an object seen, so many of a part tell the state that it shows.
PART_SHARE = 0.2


def perceive(
    scene: Scene,
    infos: Mapping[str, AssetInfo],
    kinds: Kinds,
    views: Sequence[View],
    perception: Perception,
) -> Perceived:
    """What these views show of a scene. Of the scene itself only the plan and what a recogniser
    tells are used; ``infos`` name the states and parts of its models.

    KeyError for a class or model that nobody defined.
    """
    draws = Draws(perception, scene.index)
    found = clouds(views, (item.id for item in scene.objects))
    least = min((_least(view, perception.pixels) for view in views), default=1)
    openings = {opening.object_id: opening for opening in scene.home.openings}
    things: dict[int, Thing] = {}
    for item in scene.objects:
        cloud = found.get(item.id)
        if cloud is None or cloud.pixels < least or draws.missed(item.id):
            continue
        name = draws.name(item.id, item.category, kinds)
        info = infos[item.asset]
        kind, opening = kinds[name], openings.get(item.id)
        thing = thing_of(item, name, kind, item.fixed, cloud, _open_parts(item, info), opening)
        if perception.states:
            thing.states = _states(item, info, cloud, least)
        things[item.id] = thing
    settle(things)
    made = [records_of(things[key]) for key in sorted(things)]
    models = {info.id: info for _, info in made}
    whole = _scene(scene, [item for item, _ in made], models, kinds.catalog)
    out = Perceived(whole, models, kinds.catalog)
    return coarse(out) if perception.coarse else out


def _least(view: View, pixels: int) -> int:
    return evidence_pixels_needed(view.camera.width, view.camera.height, pixels)


def _open_parts(item: ObjectInstance, info: AssetInfo) -> list[tuple[int, bool]]:
    """The parts of an object that stand open, by their values in the mask, and whether each
    slides."""
    out = []
    for value, name in enumerate(item.parts, start=1):
        joint = info.part(name).joint
        if joint is not None and item.joints.get(joint, 0.0):
            out.append((value, info.joint(joint).type == "prismatic"))
    return out


def _states(item: ObjectInstance, info: AssetInfo, cloud: Cloud, least: int) -> tuple[str, ...]:
    """The states of an object that the views tell: those with enough pixels of a part that shows
    them."""
    value_of = {name: value for value, name in enumerate(item.parts, start=1)}
    enough = max(1, round(PART_SHARE * least))
    seen = []
    for state in item.states:
        rules = [
            rule
            for rule in info.states
            if rule.state == state and rule_holds(rule, item.variant, item.joints)
        ]
        for rule in rules:
            drawn = [value_of[name] for name in rule.parts if name in value_of]
            if not drawn or sum(cloud.part_pixels.get(v, 0) for v in drawn) >= enough:
                seen.append(state)
                break
    return tuple(sorted(set(seen)))


def _scene(
    scene: Scene,
    objects: Sequence[ObjectInstance],
    models: Mapping[str, AssetInfo],
    catalog: Catalog,
) -> Scene:
    """The perceived objects in their rooms, with the zones that follow from them."""
    home = scene.home
    rooms = Rooms(home).room_ids(objects, models)
    first = home.rooms[0].id
    inside = tuple(item.model_copy(update={"room_id": rooms[item.id] or first}) for item in objects)
    furniture = bodies_of((item for item in inside if item.fixed), models)
    free = free_shape(home, floor_obstacles(furniture))
    properties = {c.name: c.properties for c in catalog.categories}
    # GEOS divides by nothing where outlines of perceived things nearly touch, and recovers.
    with np.errstate(divide="ignore", invalid="ignore"):
        zones = derive_zones(home, furniture, free, properties)
    return scene.model_copy(
        update={
            "zones": tuple(_known(zones, {item.id for item in inside})),
            "free_space": rounded_rings(free),
            "objects": inside,
        }
    )


def _known(zones: Iterable[Zone], seen: set[int]) -> Iterable[Zone]:
    """Zones, those of doors that are only on the plan without a source."""
    for zone in zones:
        known = zone.source_id is None or zone.source_id in seen
        yield zone if known else zone.model_copy(update={"source_id": None})
