"""Perceiving the scenes of a data set: their pictures, handed to :mod:`sdgen.perception`."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Protocol

import numpy as np
import numpy.typing as npt
from shapely.errors import ShapelyError

from sdgen.dataset.knowledge import Knowledge
from sdgen.dataset.scene_folder import view_folder
from sdgen.errors import InputError, UsageError
from sdgen.perception import Kinds, Perceived, Perception, View, perceive
from sdgen.scene import Camera, Scene

_NEEDED = ("depth.png", "instance.png")


class Pictured(Protocol):
    """What is asked of a scene of a data set."""

    @property
    def id(self) -> str:
        """Its id."""
        ...

    @property
    def scene(self) -> Scene:
        """Its ``scene.json``."""
        ...

    @property
    def cameras(self) -> Sequence[Camera]:
        """Its cameras."""
        ...

    def has(self, view: int, name: str) -> bool:
        """A view has a file of this name."""
        ...

    def depth_mm(self, view: int) -> npt.NDArray[np.uint16]:
        """Its depth."""
        ...

    def instance(self, view: int) -> npt.NDArray[np.uint16]:
        """Its mask."""
        ...

    def part(self, view: int) -> npt.NDArray[np.uint8]:
        """Its mask of parts."""
        ...


@dataclass(frozen=True)
class Eyes:
    """Perceives scenes of one data set, all in the same way."""

    knowledge: Knowledge
    perception: Perception

    def __reduce__(self) -> tuple[type[Eyes], tuple[Knowledge, Perception]]:
        return type(self), (self.knowledge, self.perception)

    @cached_property
    def _kinds(self) -> Kinds:
        return Kinds(self.knowledge.catalog, self.knowledge.infos.values())

    def perceive(self, item: Pictured) -> Perceived:
        """What is made out of a scene. InputError where its pictures are not there, or its files
        disagree; UsageError for views that it does not have."""
        views = list(self._views(item))
        infos, kinds = self.knowledge.infos, self._kinds
        try:
            perceived = perceive(item.scene, infos, kinds, views, self.perception)
            # At once: what disagrees is then told here, with its file.
            _ = perceived.graph
            return perceived
        except (LookupError, ValueError, ArithmeticError, ShapelyError) as error:
            found = isinstance(error, KeyError)
            reason = f"it names {error}, which is not there" if found else error
            where = f"scenes/{item.id}/scene.json"
            raise InputError(
                [f"{where}: cannot be perceived: {reason} (see sdgen validate)"]
            ) from None

    def _views(self, item: Pictured) -> Iterator[View]:
        for camera in self._cameras(item):
            k = camera.index
            missing = [name for name in _NEEDED if not item.has(k, name)]
            if missing:
                raise InputError([f"scenes/{item.id}/{view_folder(k)}: no {missing[0]}{_MEND}"])
            if not (camera.K[0][0] > 0 and camera.K[1][1] > 0):
                where = f"scenes/{item.id}/{view_folder(k)}/view.json"
                raise InputError([f"{where}: K: its focal lengths are not positive"])
            part = item.part(k) if item.has(k, "part.png") else None
            yield View(camera, item.instance(k), item.depth_mm(k), part)

    def _cameras(self, item: Pictured) -> Sequence[Camera]:
        cameras, wanted = item.cameras, self.perception.views
        if not cameras:
            raise InputError([f"scenes/{item.id}: no views{_MEND}"])
        if wanted is None:
            return cameras
        if wanted == "room":
            return [camera for camera in cameras if camera.kind != "near"]
        wrong = [k for k in wanted if k >= len(cameras)]
        if wrong:
            raise UsageError(
                f"perception: views: scene {item.id} has no view {wrong[0]}, only 0 to "
                f"{len(cameras) - 1}"
            )
        return [cameras[k] for k in dict.fromkeys(wanted)]


_MEND = (
    ": a perceived graph is made of depth and instance pictures (sdgen build writes both unless "
    "--sensors leaves them out)"
)
