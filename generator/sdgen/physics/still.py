"""A Bullet world for rays alone: nothing in it moves, and its shapes outlive scenes."""

from __future__ import annotations

from collections.abc import Sequence
from operator import itemgetter
from pathlib import Path
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from sdgen.geometry import Array, Quat, Vec3
from sdgen.physics.bullet import forget_files, pb

#: Triangle shapes kept, some 65 kB each: 200 MB. A scene needs 200, the first hundred 2,300.
KEPT = 3000
#: A box takes a fiftieth of what a triangle shape does.
_BOX = 0.02
#: Bullet takes up to 128 links in one call, the base included.
_LINKS = 127
_RAYS = int(pb.MAX_RAY_INTERSECTION_BATCH_SIZE) - 1


class Piece(NamedTuple):
    """A shape, and where it stands."""

    shape: int
    position_m: Vec3
    quat_xyzw: Quat = (0.0, 0.0, 0.0, 1.0)


class RayHits(NamedTuple):
    """Nearest piece in the order in which they were added (−1 = none), and distance along each ray
    as a fraction of its length."""

    piece: npt.NDArray[np.int64]
    fraction: Array


class Still:
    """Pieces that stand, as links of few bodies: one by one they would cost Bullet ten times more.

    :meth:`clear` empties it. Shapes stay, so that a model becomes a Bullet shape once a process and
    not once a scene; hits follow from the pieces and their order, not from what stood before.
    """

    def __init__(self) -> None:
        self._id: int = pb.connect(pb.DIRECT)
        self._shapes: dict[tuple[float, ...] | Path, int] = {}
        self._held = 0.0
        self._bodies: list[int] = []
        #: Number of the first piece of each body, by body.
        self._first = np.zeros(1, dtype=np.int64)
        self._count = 0
        self._unseen = self._unseen_shape()

    def close(self) -> None:
        """Disconnect; a second call does nothing."""
        if self._id >= 0:
            pb.disconnect(physicsClientId=self._id)
            self._id = -1

    def clear(self) -> None:
        """Take all pieces out; their shapes go only when too many are held, then all of them."""
        for body in self._bodies:
            pb.removeBody(body, physicsClientId=self._id)
        self._bodies.clear()
        self._count = 0
        if self._held > KEPT:
            # Bullet frees no single shape that was used.
            pb.resetSimulation(physicsClientId=self._id)
            forget_files(self._id)
            self._shapes.clear()
            self._held = 0.0
            self._unseen = self._unseen_shape()

    def box(self, size_m: Sequence[float]) -> int:
        """Shape of a box with these edge lengths."""
        half = tuple(0.5 * float(v) for v in size_m)
        if half not in self._shapes:
            self._held += _BOX
            self._shapes[half] = int(
                pb.createCollisionShape(pb.GEOM_BOX, halfExtents=half, physicsClientId=self._id)
            )
        return self._shapes[half]

    def trimesh(self, path: Path) -> int:
        """Shape of an OBJ file's triangles as they are."""
        if path not in self._shapes:
            self._held += 1.0
            # From a file: given as lists, PyBullet never lets go of the numbers (15 MB a scene).
            self._shapes[path] = int(
                pb.createCollisionShape(
                    pb.GEOM_MESH,
                    fileName=str(path),
                    flags=pb.GEOM_FORCE_CONCAVE_TRIMESH,
                    physicsClientId=self._id,
                )
            )
        return self._shapes[path]

    def add(self, pieces: Sequence[Piece]) -> None:
        """More pieces, numbered on."""
        for start in range(0, len(pieces), _LINKS):
            self._add(pieces[start : start + _LINKS])

    def _add(self, pieces: Sequence[Piece]) -> None:
        count = len(pieces)
        origins, unturned = [(0.0, 0.0, 0.0)] * count, [(0.0, 0.0, 0.0, 1.0)] * count
        body = int(
            pb.createMultiBody(
                linkMasses=[0.0] * count,
                linkCollisionShapeIndices=[piece.shape for piece in pieces],
                linkVisualShapeIndices=[self._unseen] * count,
                linkPositions=[piece.position_m for piece in pieces],
                linkOrientations=[piece.quat_xyzw for piece in pieces],
                linkInertialFramePositions=origins,
                linkInertialFrameOrientations=unturned,
                linkParentIndices=[0] * count,
                linkJointTypes=[pb.JOINT_FIXED] * count,
                linkJointAxis=[(0.0, 0.0, 1.0)] * count,
                physicsClientId=self._id,
            )
        )
        self._bodies.append(body)
        if body >= len(self._first):
            self._first = np.append(self._first, np.zeros(body + 1 - len(self._first), np.int64))
        self._first[body] = self._count
        self._count += count

    def cast(self, origins_m: Array, targets_m: Array) -> RayHits:
        """First piece each segment from (N, 3) origins to (N, 3) targets meets."""
        piece = np.full(len(origins_m), -1, dtype=np.int64)
        fraction = np.ones(len(origins_m))
        for start in range(0, len(origins_m), _RAYS):
            chunk = slice(start, start + _RAYS)
            found = pb.rayTestBatch(
                origins_m[chunk], targets_m[chunk], numThreads=1, physicsClientId=self._id
            )
            body, link = (
                np.fromiter(map(itemgetter(k), found), np.int64, len(found)) for k in (0, 1)
            )
            piece[chunk] = np.where(body >= 0, self._first[body] + link, -1)
            fraction[chunk] = np.fromiter(map(itemgetter(2), found), np.float64, len(found))
        return RayHits(piece, fraction)

    def _unseen_shape(self) -> int:
        """What is drawn of a piece: else Bullet's software renderer takes its triangles."""
        tiny = [1e-3] * 3
        return int(pb.createVisualShape(pb.GEOM_BOX, halfExtents=tiny, physicsClientId=self._id))
