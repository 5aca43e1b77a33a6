"""The one place that talks to Bullet: every call carries its client id, tuples come out named."""

from __future__ import annotations

import hashlib
from collections import OrderedDict
from collections.abc import Sequence
from contextlib import ExitStack
from pathlib import Path
from typing import NamedTuple

import numpy as np

from sdgen.closing import Closing
from sdgen.geometry import Array, Quat, Vec3, vec3
from sdgen.physics.bullet import forget_files, pb
from sdgen.physics.still import Still
from sdgen.scratch import scratch_folder

#: On earth; steps as Bullet is tuned for (its default).
GRAVITY_M_S2 = 9.81
STEP_S = 1.0 / 240.0
#: Sweeps of the solver a step. Of 581 loose things that fell 2 cm in eight scenes (seed 7) all came
#: to rest with 20, after as many steps as with 50; with 10 two kept moving, with 5 eleven.
SOLVER_SWEEPS = 20
#: Share of its speed that a moving thing loses in a second, by itself: little against centimetres
#: of fall, and those eight scenes were at rest after 1,536 steps instead of 1,740 without.
LINEAR_DAMPING, ANGULAR_DAMPING = 0.05, 0.1
#: Of a body that says none, as in a model's record. Bullet multiplies the frictions of two bodies
#: that touch: 0.36 for two such things, which slide on each other at 20 degrees; tables have 0.25
#: to 0.5 for dry wood on wood.
FRICTION = 0.6
#: Bullet keeps this skin around every convex hull; taken off the pieces, or things float on it.
MARGIN_M = 0.001
#: Collision groups and masks that Bullet gives what moves and what stands: statics do not meet.
_MOVES, _STANDS = (1, -1), (2, -3)
#: Files of convex pieces whose parsed triangles Bullet may keep, and 0.2 ms to parse one again.
PARSED = 4000
#: Files of convex pieces kept, 8 kB each; drawn joint values are many.
WRITTEN = 4000


class BodyPose(NamedTuple):
    """World pose of a body's centre of mass."""

    position_m: Vec3
    quat_xyzw: Quat


class ContactPoint(NamedTuple):
    """Where two bodies meet. ``normal_on_b`` points from b to a; negative distance = overlap."""

    a: int
    b: int
    position_m: Vec3
    normal_on_b: Vec3
    distance_m: float


class Client(Closing):
    """A Bullet world without graphics. Use as a context manager, one a process, and reuse it:
    :meth:`reset` gives a fresh world whose results do not depend on what ran before. ``still`` is
    a world of its own beside it, for rays."""

    def __init__(self) -> None:
        self._id: int = pb.connect(pb.DIRECT)
        self.still = Still()
        self._held = ExitStack()
        self._folder = self._held.enter_context(scratch_folder())
        self._written: OrderedDict[str, None] = OrderedDict()
        self._parsed: set[str] = set()
        self.reset()

    def close(self) -> None:
        """Disconnect; a second call does nothing."""
        self.still.close()
        if self._id >= 0:
            pb.disconnect(physicsClientId=self._id)
            self._id = -1
            self._held.close()

    def reset(self) -> None:
        """Empty the world. Parameters are set anew, since Bullet forgets them."""
        self._shapes: dict[str, int] = {}
        pb.resetSimulation(physicsClientId=self._id)
        if len(self._parsed) > PARSED:
            forget_files(self._id)
            self._parsed.clear()
        pb.setGravity(0.0, 0.0, -GRAVITY_M_S2, physicsClientId=self._id)
        pb.setPhysicsEngineParameter(
            fixedTimeStep=STEP_S,
            numSolverIterations=SOLVER_SWEEPS,
            deterministicOverlappingPairs=1,
            physicsClientId=self._id,
        )
        # Without one, Bullet's software renderer turns each body's collision mesh into a picture's:
        # half of what a body costs, and some 370 kB each.
        self._unseen = pb.createVisualShape(
            pb.GEOM_BOX, halfExtents=[MARGIN_M] * 3, physicsClientId=self._id
        )

    def box(self, size_m: Sequence[float]) -> int:
        """Collision shape of a box with these edge lengths."""
        half = [0.5 * float(v) for v in size_m]
        shape = pb.createCollisionShape(pb.GEOM_BOX, halfExtents=half, physicsClientId=self._id)
        return int(shape)

    def convex(self, obj: str) -> int:
        """Collision shape of convex pieces, given as :func:`convex_obj` writes them."""
        # By content: Bullet keeps what it parsed by the file's name.
        raw = obj.encode("ascii")
        name = hashlib.sha256(raw).hexdigest()[:20]
        if name not in self._shapes:
            path = self._parse(self._file(name, raw))
            self._shapes[name] = pb.createCollisionShape(
                pb.GEOM_MESH, fileName=path, physicsClientId=self._id
            )
        return int(self._shapes[name])

    def body(
        self,
        shape: int,
        position_m: Sequence[float],
        quat_xyzw: Sequence[float] = (0.0, 0.0, 0.0, 1.0),
        mass_kg: float = 0.0,
        friction: float = FRICTION,
    ) -> int:
        """A body; mass 0 makes it static. The shape's origin is its centre of mass."""
        body = pb.createMultiBody(
            mass_kg,
            shape,
            self._unseen,
            basePosition=list(position_m),
            baseOrientation=list(quat_xyzw),
            # Bodies without links: as plain rigid bodies they step three times as fast.
            useMaximalCoordinates=1,
            physicsClientId=self._id,
        )
        if mass_kg > 0:
            # A little rolling friction, or bottles and balls never come to rest.
            pb.changeDynamics(
                body,
                -1,
                lateralFriction=friction,
                rollingFriction=0.002,
                spinningFriction=0.002,
                restitution=0.0,
                linearDamping=LINEAR_DAMPING,
                angularDamping=ANGULAR_DAMPING,
                # Or a neighbour that moves could not wake it.
                activationState=pb.ACTIVATION_STATE_ENABLE_SLEEPING,
                physicsClientId=self._id,
            )
        else:
            pb.changeDynamics(
                body,
                -1,
                lateralFriction=friction,
                # Or Bullet collides what sleeps with what it stands on, step by step.
                activationState=pb.ACTIVATION_STATE_SLEEP,
                physicsClientId=self._id,
            )
        return int(body)

    def remove(self, body: int) -> None:
        """Take a body out of the world; its shape stays for others."""
        pb.removeBody(body, physicsClientId=self._id)

    def place(self, body: int, position_m: Sequence[float], quat_xyzw: Sequence[float]) -> None:
        """Put a body's centre of mass somewhere, at rest; a sleeping one sleeps on."""
        pb.resetBasePositionAndOrientation(
            body, list(position_m), list(quat_xyzw), physicsClientId=self._id
        )

    def wake(self, body: int) -> None:
        """Let a body move again."""
        pb.changeDynamics(
            body, -1, activationState=pb.ACTIVATION_STATE_WAKE_UP, physicsClientId=self._id
        )

    def forget(self, body: int, moves: bool) -> None:
        """Let go of all that a body touches, as if it were new in the world; contacts are found
        again at the next step. ``moves`` says whether it has a mass."""
        group, mask = _MOVES if moves else _STANDS
        # Its own ones again: what is done besides is that Bullet takes it out and in.
        pb.setCollisionFilterGroupMask(body, -1, group, mask, physicsClientId=self._id)

    def sleep(self, body: int) -> None:
        """Leave a body out of the simulation until one that moves touches it."""
        pb.changeDynamics(
            body, -1, activationState=pb.ACTIVATION_STATE_SLEEP, physicsClientId=self._id
        )

    def pose(self, body: int) -> BodyPose:
        """World pose of a body's centre of mass."""
        return BodyPose(*pb.getBasePositionAndOrientation(body, physicsClientId=self._id))

    def step(self, count: int = 1) -> None:
        """Advance by ``count`` steps of 1/240 s."""
        for _ in range(count):
            pb.stepSimulation(physicsClientId=self._id)

    def detect(self) -> None:
        """Find contacts without moving anything."""
        pb.performCollisionDetection(physicsClientId=self._id)

    def contacts(self) -> tuple[ContactPoint, ...]:
        """Contacts of the last step."""
        return tuple(_contact(item) for item in pb.getContactPoints(physicsClientId=self._id))

    def closest(self, a: int, b: int, within_m: float) -> tuple[ContactPoint, ...]:
        """Points where a and b are nearer than ``within_m``."""
        found = pb.getClosestPoints(a, b, within_m, physicsClientId=self._id)
        return tuple(_contact(item) for item in found or ())

    def _file(self, name: str, raw: bytes) -> Path:
        """The file of this name and content, among those used last."""
        path = self._folder / f"{name}.obj"
        if name not in self._written:
            path.write_bytes(raw)
        self._written[name] = None
        self._written.move_to_end(name)
        if len(self._written) > WRITTEN:
            oldest, _ = self._written.popitem(last=False)
            (path.parent / f"{oldest}.obj").unlink()
        return path

    def _parse(self, path: Path) -> str:
        """The name of a file that Bullet is about to parse, unless it did before."""
        self._parsed.add(str(path))
        return str(path)


def convex_obj(pieces: Sequence[Array]) -> str:
    """OBJ text of convex pieces, the hulls of (N, 3) point sets, without Bullet's skin.

    Bullet makes one convex hull a group of an OBJ file; its Python call takes one point set only.
    """
    lines: list[str] = []
    base = 1
    for number, piece in enumerate(map(_without_margin, pieces)):
        lines.append(f"o p{number}")
        lines += [f"v {x:.7g} {y:.7g} {z:.7g}" for x, y, z in piece.tolist()]
        last = base + len(piece) - 1
        lines += [f"f {k} {min(k + 1, last)} {min(k + 2, last)}" for k in range(base, last + 1, 3)]
        base = last + 1
    return "\n".join(lines) + "\n"


def _without_margin(piece: Array) -> Array:
    """The piece drawn in by the margin along each axis, by a third where it is thinner."""
    low, high = piece.min(axis=0), piece.max(axis=0)
    half = (high - low) / 2
    inset = np.minimum(MARGIN_M, half * 0.34)
    scale = 1.0 - inset / np.maximum(half, 1e-9)
    centre = (low + high) / 2
    return np.asarray(centre + (piece - centre) * scale, dtype=np.float64)


def _contact(item: Sequence[object]) -> ContactPoint:
    a, b, on_a, normal, distance = item[1], item[2], item[5], item[7], item[8]
    return ContactPoint(
        int(a),  # type: ignore[call-overload]
        int(b),  # type: ignore[call-overload]
        vec3(on_a),  # type: ignore[arg-type]
        vec3(normal),  # type: ignore[arg-type]
        float(distance),  # type: ignore[arg-type]
    )
