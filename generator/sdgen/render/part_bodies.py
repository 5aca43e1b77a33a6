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


@dataclass(frozen=True)
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

    With ``handles`` they are made in the order that gives them rising handles in the EGL plugin;
    Bullet's own renderer draws things in the order in which they are made. ``resetSimulation``
    makes this object worthless: make a new one.
    """

    def __init__(self, client: int, handles: bool) -> None:
        self._client = client
        self._bodies: list[int] = []
        self._handles = _Handles() if handles else None
        self._name_nobody()

    def put(self, parts: Sequence[Part]) -> None:
        """Put parts into the world, which holds none yet."""
        made = parts if self._handles is None else self._handles.in_order(parts)
        for first in range(0, len(made), _LINKS):
            links = made[first : first + _LINKS]
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
            self._node_of[body, 1 : count + 1] = [part.node_id for part in links]
            self._part_of[body, 1 : count + 1] = [part.number for part in links]

    def remove(self) -> None:
        """Take all parts out of the world."""
        # Last in, first out: so bodies have the same numbers in every scene.
        for body in reversed(self._bodies):
            pb.removeBody(body, physicsClientId=self._client)
        self._bodies = []
        if self._handles is not None:
            self._handles.all_removed()
        self._name_nobody()

    def owners(
        self, mask: npt.NDArray[np.int32]
    ) -> tuple[npt.NDArray[np.uint16], npt.NDArray[np.uint8]]:
        """Node id and part number of every pixel of a mask drawn with ``WITH_LINKS``."""
        row = (mask & (_BODIES - 1)) * (_LINKS + 1)
        row += mask >> _LINK_SHIFT
        return np.take(self._node_of, row), np.take(self._part_of, row)

    def _name_nobody(self) -> None:
        self._node_of = np.zeros((_BODIES, _LINKS + 1), dtype=np.uint16)
        self._part_of = np.zeros((_BODIES, _LINKS + 1), dtype=np.uint8)


class _Handles:
    """Mirrors the order in which the EGL plugin gives instances their handles: the one that came
    back last goes out first, new ones rise.

    Where several parts share a shape, the plugin sorts it by the one with the lowest handle. So
    handles must rise as the parts do, or pictures would depend on what the process drew before.
    """

    def __init__(self) -> None:
        self._free: list[int] = []
        self._new = 0
        self._out: list[int] = []

    def in_order(self, parts: Sequence[Part]) -> list[Part]:
        """``parts`` in the order in which to make them, so that their handles rise as here."""
        missing = max(0, len(parts) - len(self._free))
        self._free[:0] = reversed(range(self._new, self._new + missing))
        self._new += missing
        self._out = [self._free.pop() for _ in parts]
        rising = sorted(range(len(parts)), key=self._out.__getitem__)
        made = list(parts)
        for part, place in zip(parts, rising, strict=True):
            made[place] = part
        return made

    def all_removed(self) -> None:
        """What was made last is gone: the last body first, and of each its first link first."""
        for first in reversed(range(0, len(self._out), _LINKS)):
            self._free += self._out[first : first + _LINKS]
        self._out = []
