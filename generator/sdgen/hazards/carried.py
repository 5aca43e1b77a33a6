"""What a moving part takes along: things that stand on it or in it, and what stands on those."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from sdgen.facts import Measured
from sdgen.geometry import Array, inverse, quat_from_matrix, round_position, round_quat
from sdgen.library.records import AssetInfo
from sdgen.library.states import object_from_part
from sdgen.scene import ObjectInstance, Pose


def parts_moved(before: ObjectInstance, after: ObjectInstance, info: AssetInfo) -> dict[str, Array]:
    """``after_from_before`` (4, 4) in the world, by name, of each part that other joint values
    put elsewhere."""
    world = before.pose.matrix()
    out = {}
    for part in info.parts:
        old, new = (object_from_part(info, part.name, item.joints) for item in (before, after))
        if not np.array_equal(old, new):
            out[part.name] = world @ new @ inverse(world @ old)
    return out


def carried_along(
    moved: Mapping[int, Mapping[str, Array]], facts: Measured
) -> dict[int, ObjectInstance]:
    """The things that travel with the ``moved`` parts of some objects, at their new poses (rounded
    as written) and in the rooms these say.

    ``facts`` are those of the scene before. A thing travels with the part it is ON or INSIDE of,
    by the surface that carries it, and else by the hollow it is in; and with a thing that travels.
    What is fixed is held by the home, not by a part.
    """
    travels: dict[int, Array] = {}
    loose = [key for key, body in facts.bodies.items() if not body.item.fixed]
    found = True
    while found:
        further = {
            key: motion
            for key in loose
            if key not in travels and (motion := _motion(key, moved, travels, facts)) is not None
        }
        travels |= further
        found = bool(further)
    items = [_at(facts.bodies[key].item, motion) for key, motion in sorted(travels.items())]
    if not items:
        return {}
    rooms = facts.rooms.room_ids(items, {i.asset: facts.bodies[i.id].info for i in items})
    return {item.id: item.model_copy(update={"room_id": rooms[item.id]}) for item in items}


def _motion(
    key: int,
    moved: Mapping[int, Mapping[str, Array]],
    travels: Mapping[int, Array],
    facts: Measured,
) -> Array | None:
    for held in (*facts.on(key), *facts.inside(key)):
        if not held.holds:
            continue
        if held.target_id in travels:
            return travels[held.target_id]
        part = facts.part_holding(key, held.target_id) if held.target_id in moved else None
        if part is not None and part in moved[held.target_id]:
            return moved[held.target_id][part]
    return None


def _at(item: ObjectInstance, motion: Array) -> ObjectInstance:
    world = motion @ item.pose.matrix()
    pose = Pose(
        position_m=round_position(world[:3, 3]),
        quat_xyzw=round_quat(quat_from_matrix(world[:3, :3])),
    )
    return item.model_copy(update={"pose": pose})
