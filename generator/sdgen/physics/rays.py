"""Ray tests against what is drawn: the geometry that decides cameras and visibility."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from sdgen.closing import Closing
from sdgen.geometry import Array, lowest_highest, moved_boxes, quat_from_matrix, vec3
from sdgen.library import Library
from sdgen.library.states import object_from_part
from sdgen.physics.still import Piece, Still
from sdgen.scene import Scene

Ints = npt.NDArray[np.int64]

#: Bullet sees a mesh from its OBJ file, which is rounded to 0.01 mm.
NEAR_M = 0.001


@dataclass(frozen=True)
class Hits:
    """What N rays met first: node id (0 = nothing), part (1-based index into the object's drawn
    parts, 0 for structures) and distance in metres (inf = nothing)."""

    object_id: Ints
    part: Ints
    distance_m: Array


@dataclass(frozen=True)
class _Part:
    """A drawn part that no ray came near yet: whose it is, where, and its box, (2, 3)."""

    owner: tuple[int, int]
    shape: tuple[str, str]
    pose: Array
    bounds: Array


class RayWorld(Closing):
    """The drawn triangles of a scene, standing still, for :meth:`cast`.

    A part is loaded when the first batch of rays comes near it: cameras look into few rooms.
    Context manager; or give it a ``still`` world to use, which then stays open.
    """

    def __init__(self, library: Library, scene: Scene, still: Still | None = None) -> None:
        self._own = still is None
        self._still = Still() if still is None else still
        self._still.clear()
        self._library = library
        #: Node id and part of each piece in the order in which they were added.
        self._owners: list[tuple[int, int]] = []
        self._add_shell(scene)
        self._parts = _parts(library, scene)
        self._bounds = np.array([part.bounds for part in self._parts]).reshape(-1, 2, 3)
        self._waiting = np.ones(len(self._parts), dtype=np.bool_)
        self._table = self._owner_table()

    def _add_shell(self, scene: Scene) -> None:
        """All boxes of floors, walls and ceilings."""
        boxes = [
            (structure.id, piece)
            for structure in sorted(scene.home.structures, key=lambda s: s.id)
            for piece in structure.pieces
        ]
        self._still.add([Piece(self._still.box(box.size_m), box.center_m) for _, box in boxes])
        self._owners += [(key, 0) for key, _ in boxes]

    def _owner_table(self) -> Ints:
        """The owners, (N + 1, 2); the last row, zeros, is what a miss (−1) reads."""
        return np.array([*self._owners, (0, 0)], dtype=np.int64)

    def _load(self, low: Array, high: Array) -> None:
        """Make the parts whose boxes reach into this one."""
        near = (self._bounds[:, 0] <= high + NEAR_M) & (self._bounds[:, 1] >= low - NEAR_M)
        coming = np.flatnonzero(near.all(axis=1) & self._waiting)
        if len(coming) == 0:
            return
        parts = [self._parts[k] for k in coming.tolist()]
        self._still.add([self._piece(part) for part in parts])
        self._owners += [part.owner for part in parts]
        self._waiting[coming] = False
        self._table = self._owner_table()

    def _piece(self, part: _Part) -> Piece:
        asset, name = part.shape
        return Piece(
            self._still.trimesh(self._library.objs(asset)[name]),
            vec3(part.pose[:3, 3]),
            quat_from_matrix(part.pose[:3, :3]),
        )

    def close(self) -> None:
        """Let go of the world if it is ours."""
        if self._own:
            self._still.close()

    def cast(self, origins_m: Array, targets_m: Array) -> Hits:
        """First thing each segment from (N, 3) origins to (N, 3) targets meets."""
        origins = np.ascontiguousarray(origins_m, dtype=np.float64)
        targets = np.ascontiguousarray(targets_m, dtype=np.float64)
        if len(origins):
            ends = np.concatenate([origins, targets])
            self._load(*lowest_highest(ends))
        hits = self._still.cast(origins, targets)
        pair = self._table[hits.piece]
        length = np.linalg.norm(targets - origins, axis=1)
        distance = np.where(hits.piece >= 0, hits.fraction * length, np.inf)
        return Hits(object_id=pair[:, 0], part=pair[:, 1], distance_m=distance)


def _parts(library: Library, scene: Scene) -> list[_Part]:
    """Every drawn part of a scene, by object; their boxes are found in one go."""
    owners, shapes, poses, boxes = [], [], [], []
    for item in sorted(scene.objects, key=lambda o: o.id):
        info, bounds_of = library.info(item.asset), library.bounds(item.asset)
        world_from_object = item.pose.matrix()
        for number, name in enumerate(info.variants[item.variant], start=1):
            owners.append((item.id, number))
            shapes.append((item.asset, name))
            poses.append(world_from_object @ object_from_part(info, name, item.joints))
            boxes.append(bounds_of[name])
    turns = np.array(poses).reshape(-1, 4, 4)
    bounds = moved_boxes(turns, np.array(boxes).reshape(-1, 2, 3))
    return [_Part(*one) for one in zip(owners, shapes, poses, bounds, strict=True)]
