"""How perception fails: objects overlooked, and taken for others.

Each object draws from a lane of its own, by the scene's index and the object's id: a scene and its
twins draw the same for the same object, so that no failure tells one from the other.
"""

from __future__ import annotations

from sdgen.perception.kinds import Kinds
from sdgen.perception.options import Perception
from sdgen.seeding import lane


class Draws:
    """What becomes of the objects of the scene (and its twins) of this ``index``."""

    def __init__(self, perception: Perception, index: int) -> None:
        self._perception = perception
        self._index = index
        self._drawn: dict[int, tuple[float, float, float]] = {}

    def _of(self, object_id: int) -> tuple[float, float, float]:
        if object_id not in self._drawn:
            rng = lane(self._perception.seed, self._index, f"perceive:{object_id}")
            missed, confused, which = rng.random(3).tolist()
            self._drawn[object_id] = (missed, confused, which)
        return self._drawn[object_id]

    def missed(self, object_id: int) -> bool:
        """The object is overlooked."""
        return self._perception.missed > 0 and self._of(object_id)[0] < self._perception.missed

    def name(self, object_id: int, true: str, kinds: Kinds) -> str:
        """The class that the object is taken for: nearly always its own."""
        if self._perception.confused == 0:
            return true
        _, confused, which = self._of(object_id)
        others = kinds.alike(true) if confused < self._perception.confused else ()
        return others[int(which * len(others))] if others else true
