"""What an agent has seen so far: of the anomalies, and of the home."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
import shapely
from shapely.geometry import Polygon

from sdgen.agent.eyes import Look
from sdgen.cameras.outdoors import outer_openings
from sdgen.cameras.pinhole import project
from sdgen.geometry import Array
from sdgen.perception.clouds import unproject
from sdgen.scene import Anomaly, Frame, Scene
from sdgen.truth.visibility import part_names, shows, view_visibility

#: Of the floor plan, cells of this side are counted as seen or not; of each picture, every so many
#: pixels along each side are looked at for it.
CELL_M, _EVERY = 0.25, 4


class Account:
    """Kept during one episode of a scene whose anomalies are known to the keeper alone.

    ``first_shown``: the step of the first picture that shows enough of an anomaly, by its id.
    ``looked_at``: those whose object was before the camera in its room, or seen in part.
    """

    def __init__(self, scene: Scene, anomalies: Sequence[Anomaly]) -> None:
        self.first_shown: dict[str, int] = {}
        self.looked_at: set[str] = set()
        self._anomalies = anomalies
        self._openings = outer_openings(scene.home)
        self._cells = Cells(scene)

    @property
    def coverage(self) -> float:
        """The share of the floor plan's cells in which some picture has shown a surface."""
        return self._cells.share

    @property
    def cells(self) -> Cells:
        """The floor plan, and what of it was seen."""
        return self._cells

    def see(self, look: Look, scene: Scene, room_id: int, step: int) -> None:
        """Count one picture of the scene as it is now."""
        self._cells.see(look)
        waiting = [one for one in self._anomalies if one.id not in self.first_shown]
        if not waiting:
            return
        camera = look.camera
        frame = Frame(camera, look.rgb, look.depth_mm, look.instance, look.part, {})
        view = view_visibility(frame, part_names(scene), self._openings)
        seen = {item.object_id for item in view.objects}
        for one in waiting:
            if shows(view, one, camera.width, camera.height):
                self.first_shown[one.id] = step
            if one.object_id in seen or (
                one.room_id == room_id and _before(look, scene, one.object_id)
            ):
                self.looked_at.add(one.id)


class Cells:
    """The floor plan in square cells, and which of them some picture has shown a surface in."""

    def __init__(self, scene: Scene) -> None:
        rooms = shapely.union_all([Polygon(room.polygon_m) for room in scene.home.rooms])
        x0, y0, x1, y1 = rooms.bounds
        self.corner_m = np.array([x0, y0])
        shape = (math.ceil((x1 - x0) / CELL_M), math.ceil((y1 - y0) / CELL_M))
        u, v = np.meshgrid(*(np.arange(n) + 0.5 for n in shape), indexing="ij")
        self.home = shapely.contains_xy(rooms, x0 + u * CELL_M, y0 + v * CELL_M)
        self.seen = np.zeros(shape, dtype=np.bool_)

    @property
    def share(self) -> float:
        """How much of the home was seen, 0 to 1."""
        return float((self.seen & self.home).sum() / max(1, self.home.sum()))

    def see(self, look: Look) -> None:
        """Count the surfaces of one picture."""
        depth = look.depth_mm[::_EVERY, ::_EVERY]
        rows, columns = np.nonzero(depth)
        every, far = np.float64(_EVERY), np.asarray(depth[rows, columns] / 1e3, dtype=np.float64)
        at = unproject(look.camera, rows * every, columns * every, far)
        i, j = self.index(at[:, :2])
        inside = (i >= 0) & (i < self.seen.shape[0]) & (j >= 0) & (j < self.seen.shape[1])
        self.seen[i[inside], j[inside]] = True

    def index(self, points_m: Array) -> tuple[Array, Array]:
        """The cells of points (N, 2)."""
        cell = np.floor((points_m - self.corner_m) / CELL_M).astype(int)
        return cell[:, 0], cell[:, 1]


def _before(look: Look, scene: Scene, object_id: int) -> bool:
    """Whether a thing's place lies in the picture, whatever hides it."""
    for item in scene.objects:
        if item.id == object_id:
            (pixel,), (depth,) = project(look.camera, np.array([item.pose.position_m]))
            u, v = pixel.tolist()
            inside = 0 <= u < look.camera.width and 0 <= v < look.camera.height
            return bool(depth > 0 and inside)
    return False
