"""A scene's drawn parts as bodies of Bullet, and whose the pixels of its masks are."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from sdgen.geometry import Quat
from sdgen.physics.bullet import pb

# Bullet takes at most 127 links beside a body's base.
_LINKS = 127

#: The flag with which masks tell links apart: values are body + ((link + 1) << 24), and -1 where
#: nothing is. A scene's bodies have the numbers from 0 on, so 255, the last byte of -1, is none.
WITH_LINKS = pb.ER_SEGMENTATION_MASK_OBJECT_AND_LINKINDEX
_LINK_SHIFT = 24
_BODIES = 256

#: The index of what is no part.
NOBODY = -1


@dataclass(frozen=True, eq=False)
class Part:
    """A visual shape of Bullet, where its origin goes, and whose it is: ``number`` counts an
    object's drawn parts from 1, and is 0 for structures."""

    node_id: int
    number: int
    shape: int
    position_m: list[float]
    orientation: Quat


class PartBodies:
    """The parts of one scene as links of a few bodies in an empty world: a body costs Bullet 0.2
    milliseconds, a link 0.01, and a scene has some 350 parts.

    Things are drawn in the order in which they are put. ``resetSimulation`` makes this object
    worthless: make a new one.
    """

    def __init__(self, client: int) -> None:
        self._client = client
        self._bodies: list[int] = []
        self._name_nobody()

    def put(self, parts: Sequence[Part]) -> None:
        """Put parts into the world, which holds none yet."""
        for first in range(0, len(parts), _LINKS):
            links = parts[first : first + _LINKS]
            count = len(links)
            body = int(
                pb.createMultiBody(
                    0,
                    linkMasses=[0] * count,
                    linkCollisionShapeIndices=[-1] * count,
                    linkVisualShapeIndices=[part.shape for part in links],
                    linkPositions=[part.position_m for part in links],
                    linkOrientations=[part.orientation for part in links],
                    linkInertialFramePositions=[(0, 0, 0)] * count,
                    linkInertialFrameOrientations=[(0, 0, 0, 1)] * count,
                    linkParentIndices=[0] * count,
                    linkJointTypes=[pb.JOINT_FIXED] * count,
                    linkJointAxis=[(0, 0, 1)] * count,
                    physicsClientId=self._client,
                )
            )
            self._bodies.append(body)
            self._index_of[body, 1 : count + 1] = np.arange(first, first + count)
        # The last one is nobody's.
        self._node_of = np.array([*(part.node_id for part in parts), 0], dtype=np.uint16)
        self._part_of = np.array([*(part.number for part in parts), 0], dtype=np.uint8)

    def remove(self) -> None:
        """Take all parts out of the world."""
        # Last in, first out: so bodies have the same numbers in every scene.
        for body in reversed(self._bodies):
            pb.removeBody(body, physicsClientId=self._client)
        self._bodies = []
        self._name_nobody()

    def index_of(self, mask: npt.NDArray[np.int32]) -> npt.NDArray[np.int32]:
        """Which of the parts that were put every pixel of a mask drawn with ``WITH_LINKS`` is of;
        NOBODY: none."""
        row = (mask & (_BODIES - 1)) * (_LINKS + 1)
        row += mask >> _LINK_SHIFT
        return np.take(self._index_of, row)

    def owners(
        self, index: npt.NDArray[np.int32]
    ) -> tuple[npt.NDArray[np.uint16], npt.NDArray[np.uint8]]:
        """Node id and part number by the index of the part; 0 where it is NOBODY's."""
        return np.take(self._node_of, index), np.take(self._part_of, index)

    def _name_nobody(self) -> None:
        self._index_of = np.full((_BODIES, _LINKS + 1), NOBODY, dtype=np.int32)
        self._node_of = np.zeros(1, dtype=np.uint16)
        self._part_of = np.zeros(1, dtype=np.uint8)
