"""Lets small things come to rest, so that labels are proved on poses that stand."""

from __future__ import annotations

import math
from collections.abc import Collection
from dataclasses import dataclass

import numpy as np

from sdgen.geometry import Array, matrix, rotation_matrix, vec3
from sdgen.library import Library
from sdgen.physics.bodies import add_object, add_structures
from sdgen.physics.client import BodyPose, Client
from sdgen.scene import Contact, Pose, Scene

MAX_STEPS = 480
_WINDOW = 12
_STILL_M = 5e-5
_STILL_RAD = 5e-4

#: Moved or tilted further than this is not where it was put (Habitat 2.0, SceneSmith).
DRIFT_LIMIT_M = 0.1
TILT_LIMIT_RAD = math.radians(45)


@dataclass(frozen=True)
class Settled:
    """What came to rest where.

    ``poses`` of the object frame, not rounded; ``drift_m`` how far the object's centre of mass
    moved; ``tilt_rad`` how far its up axis turned; ``unstable`` ids still moving after the last
    step, or beyond the limits of drift and tilt.
    """

    poses: dict[int, Pose]
    drift_m: dict[int, float]
    tilt_rad: dict[int, float]
    contacts: tuple[Contact, ...]
    steps: int
    unstable: tuple[int, ...]


def settle(
    library: Library,
    scene: Scene,
    dynamic_ids: Collection[int],
    client: Client | None = None,
    max_steps: int = MAX_STEPS,
) -> Settled:
    """Simulate ``dynamic_ids`` until all are still, at most ``max_steps`` of 1/240 s.

    Everything else is static. The result depends on the arguments only, also on a client that
    has been used before. Raises AssetError for an object without collision pieces.
    """
    if client is None:
        with Client() as own:
            return settle(library, scene, dynamic_ids, own, max_steps)
    client.reset()
    owner = add_structures(client, scene)
    wanted = frozenset(dynamic_ids)
    bodies: dict[int, tuple[int, Array]] = {}
    for item in sorted(scene.objects, key=lambda o: o.id):
        body, com = add_object(client, library, item, item.id in wanted)
        owner[body] = item.id
        if item.id in wanted:
            bodies[item.id] = (body, com)
    missing = sorted(wanted - bodies.keys())
    if missing:
        raise KeyError(missing[0])
    start = {key: client.pose(body) for key, (body, _) in bodies.items()}
    steps, moving = _run(client, {key: body for key, (body, _) in bodies.items()}, max_steps)
    poses: dict[int, Pose] = {}
    drift: dict[int, float] = {}
    tilt: dict[int, float] = {}
    for key, (body, com) in bodies.items():
        end = client.pose(body)
        offset = rotation_matrix(end.quat_xyzw) @ com
        poses[key] = Pose(
            position_m=vec3(np.asarray(end.position_m) - offset), quat_xyzw=end.quat_xyzw
        )
        drift[key] = _apart(start[key], end)
        tilt[key] = _up_angle(start[key], end)
    beyond = {k for k in poses if drift[k] > DRIFT_LIMIT_M or tilt[k] > TILT_LIMIT_RAD}
    return Settled(
        poses=poses,
        drift_m=drift,
        tilt_rad=tilt,
        contacts=_contacts(client, owner),
        steps=steps,
        unstable=tuple(sorted(moving | beyond)),
    )


def _run(client: Client, bodies: dict[int, int], max_steps: int) -> tuple[int, set[int]]:
    """Step until nothing moved over two windows running; ids that still moved at the end.

    What is beyond the limit of drift is not waited for: it is unstable wherever it comes to rest.
    """
    if not bodies:
        client.detect()
        return 0, set()
    before = start = {key: client.pose(body) for key, body in bodies.items()}
    moving = set(bodies)
    steps = quiet = 0
    while steps < max_steps and quiet < 2:
        client.step(_WINDOW)
        steps += _WINDOW
        after = {key: client.pose(body) for key, body in bodies.items()}
        moving = {key for key in bodies if _moved(before[key], after[key])}
        awaited = [key for key in moving if _apart(start[key], after[key]) <= DRIFT_LIMIT_M]
        quiet = 0 if awaited else quiet + 1
        before = after
    return steps, moving


def _moved(before: BodyPose, after: BodyPose) -> bool:
    # 1 − |q·p| ≈ angle²/8 for a small turn.
    dot = abs(sum(a * b for a, b in zip(before.quat_xyzw, after.quat_xyzw, strict=True)))
    turned = 1.0 - dot > _STILL_RAD**2 / 8
    return turned or _apart(before, after) > _STILL_M


def _apart(before: BodyPose, after: BodyPose) -> float:
    return math.dist(before.position_m, after.position_m)


def _up_angle(before: BodyPose, after: BodyPose) -> float:
    up_before = matrix((0, 0, 0), before.quat_xyzw)[:3, 2]
    up_after = matrix((0, 0, 0), after.quat_xyzw)[:3, 2]
    return math.acos(float(np.clip(up_before @ up_after, -1.0, 1.0)))


def _contacts(client: Client, owner: dict[int, int]) -> tuple[Contact, ...]:
    """The deepest contact of each pair that touches, sorted by ids."""
    nearest: dict[tuple[int, int], float] = {}
    for point in client.contacts():
        a, b = sorted((owner[point.a], owner[point.b]))
        if a != b:
            nearest[a, b] = min(nearest.get((a, b), math.inf), point.distance_m)
    return tuple(
        Contact(a=a, b=b, distance_m=round(d, 6) + 0.0) for (a, b), d in sorted(nearest.items())
    )
