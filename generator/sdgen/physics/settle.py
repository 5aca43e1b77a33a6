"""Lets small things come to rest, so that labels are proved on poses that stand."""

from __future__ import annotations

import math
from collections.abc import Collection
from dataclasses import dataclass

import numpy as np

from sdgen.geometry import matrix
from sdgen.library import Library
from sdgen.physics.client import BodyPose, Client
from sdgen.physics.world import World
from sdgen.scene import Contact, Pose, Scene, Violation
from sdgen.vocabulary import DRIFT_LIMIT_M

#: Two seconds; 16 scenes were still after 24 to 180 steps.
MAX_STEPS = 480
#: Looked at every fortieth of a second; still is what moves by less than 2 mm/s and turns by less
#: than 0.02 rad/s over two such windows: a thing that falls 3 mm and rocks is not still meanwhile.
_WINDOW = 6
_QUIET_WINDOWS = 2
_STILL_M = 5e-5
_STILL_RAD = 5e-4

#: In a world that starts anew contacts play for some steps. Of 18,000 things that then moved and
#: turned less than this in a window none went on by more than 0.7 mm.
_PLAY_WINDOWS = 2
_AT_REST_M = 2e-5
_AT_REST_RAD = 2e-4

#: What stands stays within these limits for half a second. In a world that starts anew contacts
#: play by less than a millimetre; what tips or falls moves by centimetres.
STILL_STEPS = 120
MOVED_LIMIT_M = 0.005
TURNED_LIMIT_RAD = math.radians(3)

#: Tilted further than this is not where it was put, as with the limit of drift.
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

    def beyond(self, key: int) -> tuple[float, float] | None:
        """What took an object beyond a limit, and the limit: its drift (m), else its tilt (rad);
        None for what was only still moving."""
        return _beyond(self.drift_m[key], self.tilt_rad[key])


def _beyond(drift_m: float, tilt_rad: float) -> tuple[float, float] | None:
    for measured, limit in ((drift_m, DRIFT_LIMIT_M), (tilt_rad, TILT_LIMIT_RAD)):
        if measured > limit:
            return measured, limit
    return None


def settle(world: World, max_steps: int = MAX_STEPS) -> Settled:
    """Simulate the loose things of a world until all are still, at most ``max_steps`` of 1/240 s.

    What did not move over two windows running sleeps until something that moves touches it, so
    that the last thing to come to rest is simulated alone: the same rule for every loose thing.
    """
    client, loose = world.client, world.loose
    bodies = {key: one.body for key, one in loose.items()}
    start = {key: client.pose(body) for key, body in bodies.items()}
    steps, moving = _run(client, bodies, max_steps)
    drift: dict[int, float] = {}
    tilt: dict[int, float] = {}
    for key, body in bodies.items():
        end = client.pose(body)
        drift[key] = _apart(start[key], end)
        tilt[key] = _up_angle(start[key], end)
    beyond = {k for k in bodies if _beyond(drift[k], tilt[k]) is not None}
    return Settled(
        poses={key: world.pose(key) for key in bodies},
        drift_m=drift,
        tilt_rad=tilt,
        contacts=_contacts(client, {one.body: one.owner for one in world.placed}),
        steps=steps,
        unstable=tuple(sorted(moving | beyond)),
    )


def moving(world: World, share: float = 1.0, all_awake: bool = True) -> list[Violation]:
    """Loose things that do not stay within ``share`` of the limits for half a second: ``moves`` (m)
    or ``tips`` (rad), by id. Unless they are to be ``all_awake``, what has come to rest sleeps."""
    bodies = {key: one.body for key, one in world.loose.items()}
    start = {key: world.client.pose(body) for key, body in bodies.items()}
    if all_awake:
        world.client.step(STILL_STEPS)
    else:
        _step_while_any_moves(world.client, bodies)
    found = []
    for key, body in bodies.items():
        end = world.client.pose(body)
        for check, measured, limit in (
            ("moves", _apart(start[key], end), MOVED_LIMIT_M * share),
            ("tips", _up_angle(start[key], end), TURNED_LIMIT_RAD * share),
        ):
            if measured > limit:
                violation = Violation(check=check, objects=(key,), measured=measured, limit=limit)
                found.append(violation)
                break
    return found


def settle_scene(
    library: Library,
    scene: Scene,
    dynamic_ids: Collection[int],
    client: Client | None = None,
    max_steps: int = MAX_STEPS,
) -> Settled:
    """Let ``dynamic_ids`` of a scene come to rest in a world of their own; all else is static.

    The result depends on the arguments only, also on a client that has been used before. Raises
    AssetError for an object without collision pieces.
    """
    if client is None:
        with Client() as own:
            return settle_scene(library, scene, dynamic_ids, own, max_steps)
    world = World(library, client)
    world.become(scene, dynamic_ids)
    return settle(world, max_steps)


def _run(client: Client, bodies: dict[int, int], max_steps: int) -> tuple[int, set[int]]:
    """Step until all sleep; ids that still moved at the end.

    What is beyond the limit of drift is not waited for: it is unstable wherever it comes to rest.
    """
    if not bodies:
        client.detect()
        return 0, set()
    before = start = {key: client.pose(body) for key, body in bodies.items()}
    quiet = dict.fromkeys(bodies, 0)
    steps, awaited = 0, True
    while steps < max_steps and awaited:
        client.step(_WINDOW)
        steps += _WINDOW
        after = {key: client.pose(body) for key, body in bodies.items()}
        for key, body in bodies.items():
            quiet[key] = 0 if _moved(before[key], after[key]) else quiet[key] + 1
            if quiet[key] == _QUIET_WINDOWS:
                client.sleep(body)
        awaited = any(
            quiet[key] < _QUIET_WINDOWS and _apart(start[key], after[key]) <= DRIFT_LIMIT_M
            for key in bodies
        )
        before = after
    return steps, {key for key in bodies if quiet[key] < _QUIET_WINDOWS}


def _step_while_any_moves(client: Client, bodies: dict[int, int]) -> None:
    """STILL_STEPS at most; what is at rest after the first windows sleeps."""
    client.step(_PLAY_WINDOWS * _WINDOW)
    before = {key: client.pose(body) for key, body in bodies.items()}
    for _ in range(STILL_STEPS // _WINDOW - _PLAY_WINDOWS):
        client.step(_WINDOW)
        after = {key: client.pose(body) for key, body in bodies.items()}
        at_rest = [k for k in bodies if not _moved(before[k], after[k], _AT_REST_M, _AT_REST_RAD)]
        if len(at_rest) == len(bodies):
            return
        for key in at_rest:
            client.sleep(bodies[key])
        before = after


def _moved(
    before: BodyPose, after: BodyPose, by_m: float = _STILL_M, by_rad: float = _STILL_RAD
) -> bool:
    # 1 − |q·p| ≈ angle²/8 for a small turn.
    (a, b, c, d), (e, f, g, h) = before.quat_xyzw, after.quat_xyzw
    dot = abs(a * e + b * f + c * g + d * h)
    return 1.0 - dot > by_rad**2 / 8 or _apart(before, after) > by_m


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
