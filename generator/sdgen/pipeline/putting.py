"""One thing put somewhere in a scene that stands: it comes to rest alone, all others fixed."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from sdgen.catalog.records import Catalog
from sdgen.facts import Facts, bodies_of, entered_structures
from sdgen.geometry import round_position, round_quat
from sdgen.hazards.certify import facts_of
from sdgen.hazards.twin import After, with_changes
from sdgen.library import Library
from sdgen.library.records import AssetInfo
from sdgen.physics.client import Client
from sdgen.physics.settle import MAX_STEPS, moving, settle
from sdgen.physics.world import World
from sdgen.pipeline.rest import STAYS_SHARE
from sdgen.pipeline.undoing import near_boxes
from sdgen.scene import Contact, ObjectInstance, Pose, Scene
from sdgen.vocabulary import DRIFT_LIMIT_M
from sdgen.zones import swing_blocked


@dataclass(frozen=True)
class Rest:
    """How what was put elsewhere came to rest: how far it drifted, and what it touches."""

    drift_m: float
    contacts: tuple[Contact, ...]

    def without(self, key: int) -> Rest:
        """The same, of a scene where an object is gone or elsewhere."""
        return replace(self, contacts=tuple(c for c in self.contacts if key not in (c.a, c.b)))


def facts_after(
    facts: Facts, changes: After, infos: Mapping[str, AssetInfo], catalog: Catalog
) -> Facts:
    """Facts of the scene with these objects changed or gone, and with what they carry along."""
    objects = with_changes(facts.scene, changes, infos, facts)
    scene = facts.scene.model_copy(update={"objects": objects})
    return facts_of(scene, infos, catalog, facts)


def come_to_rest(
    item: ObjectInstance,
    changes: After,
    facts: Facts,
    anyhow: bool,
    library: Library,
    client: Client,
) -> tuple[ObjectInstance, Rest] | None:
    """A thing settled where it was put, all others fixed, its pose rounded as it is written; None
    where it does not come to rest, or not as it was put (``anyhow``: it may have toppled).

    ``facts`` are of the scene before, with the thing wherever it was.
    """
    scene = _around_new(item, changes, facts, library)
    world = World(library, client)
    world.become(scene, (item.id,))
    settled = settle(world)
    toppled = settled.steps < MAX_STEPS and settled.drift_m[item.id] <= DRIFT_LIMIT_M
    if settled.unstable and not (anyhow and toppled):
        return None
    pose = settled.poses[item.id]
    pose = Pose(position_m=round_position(pose.position_m), quat_xyzw=round_quat(pose.quat_xyzw))
    rested = item.model_copy(update={"pose": pose})
    room_id = facts.rooms.room_ids([rested], library.infos)[item.id]
    contacts = tuple(
        one.model_copy(update={"distance_m": round(one.distance_m, 5)})
        for one in settled.contacts
        if item.id in (one.a, one.b)
    )
    return (
        rested.model_copy(update={"room_id": room_id}),
        Rest(settled.drift_m[item.id], contacts),
    )


def _around_new(item: ObjectInstance, changes: After, facts: Facts, library: Library) -> Scene:
    """What a thing could touch where it was put, and the thing: the scene after these changes."""
    (body,) = bodies_of([item], library.infos)
    there = near_boxes([((body.low + body.high) / 2, body.high - body.low)], facts)
    near, before = {one.id for one in there.objects}, {one.id: one for one in facts.scene.objects}
    after = with_changes(facts.scene, {**changes, item.id: item}, library.infos, facts)
    # What a leaf that was shut took along may have come from further away.
    objects = tuple(one for one in after if one.id in near or one is not before[one.id])
    return there.model_copy(update={"objects": objects})


def stands_there(key: int, relation: str, target_id: int | None, facts: Facts) -> bool:
    """Whether a thing surely is in this relation to its target, in no wall and in no door's way."""
    related = facts.related(key, relation)
    if not any(r.target_id == target_id and r.holds and r.sure for r in related):
        return False
    if any(key in violation.objects for violation in entered_structures(facts)):
        return False
    return key not in swing_blocked(list(facts.bodies.values()))


def stays(key: int, facts: Facts, library: Library, client: Client) -> bool:
    """Whether a loose thing that was changed stays as it is written, all others fixed."""
    middle, size = facts.bounding_box(key)
    world = World(library, client)
    world.become(near_boxes([(np.array(middle), np.array(size))], facts), (key,))
    return not moving(world, STAYS_SHARE, all_awake=False)
