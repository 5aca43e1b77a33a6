"""What an agent sees: a home drawn from where it stands, of what it asks for."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from sdgen.agent.walk import shut_doors
from sdgen.cameras.lens import Gaze, Lens, camera_at
from sdgen.cameras.portals import Portals
from sdgen.closing import Closing
from sdgen.facts import bodies_of
from sdgen.library import Library
from sdgen.render.opengl import to_millimetres
from sdgen.render.process import ProcessRenderer
from sdgen.scene import Camera, Scene
from sdgen.vocabulary import DOORS, LEAVES

#: Rooms that are out of sight are let go of after so many pictures: to draw them costs more by
#: then than it will to bring them back.
_PATIENCE = 6


@dataclass(frozen=True, eq=False)
class Look:
    """One picture, and how one stood and looked: ``rgb`` (H, W, 3), ``depth_mm`` (H, W) planar,
    0 = none, ``instance`` (H, W) node ids, 0 = nothing, ``part`` (H, W) 1-based parts of each."""

    gaze: Gaze
    camera: Camera
    rgb: npt.NDArray[np.uint8]
    depth_mm: npt.NDArray[np.uint16]
    instance: npt.NDArray[np.uint16]
    part: npt.NDArray[np.uint8]


class Eyes(Closing):
    """Draws one home, which may change; a context manager.

    With ``whole_home`` all of it is loaded, else the rooms that can be seen from where the camera
    stands. All eyes of a process share its one renderer, and load their home anew after others.
    """

    def __init__(self, library: Library, renderer: ProcessRenderer, whole_home: bool = False):
        self._library = library
        self._renderer = renderer
        self._whole = whole_home
        #: The rooms whose things are drawn; None: of all of them.
        self._rooms: frozenset[int] | None = None
        self._idle = 0

    def show(self, scene: Scene) -> None:
        """Look at this scene from now on, in place of the one before."""
        self._scene = scene
        tight = _tight(scene)
        self._portals = Portals(scene.home, tight)
        self._rooms_of = {} if self._whole else self._reached(scene, tight)
        self._renderer.release(self)

    def _reached(self, scene: Scene, tight: set[int]) -> dict[int, frozenset[int]]:
        """The rooms that each node is drawn with: those that a thing is in, that a wall is of; all
        for doors and windows, which stand in two walls. A home's walls are seen from outside, too,
        so through an open front door all of them; and those beyond a shut door through its cracks,
        a pixel in one of thirty pictures taken before one."""
        beyond = {room.id: {room.id} for room in scene.home.rooms}
        for opening in scene.home.openings:
            if opening.object_id in tight:
                a, b = opening.room_ids
                beyond[a].add(b)
                beyond[b].add(a)
        out = {one.id: frozenset(beyond[one.room_id]) for one in scene.home.structures}
        for opening in scene.home.openings:
            if len(opening.room_ids) == 1 and opening.kind in DOORS:
                states = scene.object(opening.object_id).states
                if "CLOSED" not in states:
                    out = {key: rooms | {opening.room_ids[0]} for key, rooms in out.items()}
        every = frozenset(room.id for room in scene.home.rooms)
        out |= {opening.object_id: every for opening in scene.home.openings}
        for body in bodies_of(scene.objects, self._library.infos):
            item = body.item
            if item.id not in out:
                (x0, y0, _), (x1, y1, _) = body.low.tolist(), body.high.tolist()
                out[item.id] = frozenset(self._portals.around((x0, y0), (x1, y1), item.room_id))
        return out

    def look(self, gaze: Gaze, room_id: int, lens: Lens, colours: bool = True) -> Look:
        """What one sees of the scene who stands and looks so; without ``colours``, ``rgb`` is
        black."""
        camera = camera_at(gaze, room_id, lens)
        self._load(camera)
        picture = self._renderer.draw(camera, colours)
        depth_mm = to_millimetres(picture.depth_m, picture.instance > 0)
        return Look(gaze, camera, picture.rgb, depth_mm, picture.instance, picture.part)

    def _load(self, camera: Camera) -> None:
        """See to it that all that this camera sees is drawn."""
        if self._renderer.holder is not self:
            self._renderer.load(self, self._library, self._scene)
            self._rooms = None
        if self._whole:
            return
        rooms = self._portals.rooms(camera)
        if self._rooms is not None and self._rooms >= rooms:
            self._idle = 0 if self._rooms == rooms else self._idle + 1
            if self._idle < _PATIENCE:
                return
        self._renderer.show_only(
            {key for key, within in self._rooms_of.items() if not rooms.isdisjoint(within)}
        )
        self._rooms, self._idle = rooms, 0

    def close(self) -> None:
        """Let go of the renderer, which is closed when nobody uses it; a second call does
        nothing."""
        self._renderer.give_back(self)


def _tight(scene: Scene) -> set[int]:
    """Ids of the shut doors through which nothing is seen: those of one leaf, as between two there
    is a slit."""
    shut = shut_doors(scene)
    openings = (one for one in scene.home.openings if one.object_id in shut)
    return {one.object_id for one in openings if LEAVES.get(one.kind) == 1}
