"""Ray tests against what is drawn: the geometry that decides cameras and visibility."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from types import TracebackType

import numpy as np
import numpy.typing as npt

from sdgen.geometry import Array, apply, box_corners, quat_from_matrix, vec3
from sdgen.library import Library
from sdgen.library.states import object_from_part
from sdgen.physics.bodies import add_structures
from sdgen.physics.client import Client
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


class RayWorld:
    """The drawn triangles of a scene, standing still, for :meth:`cast`.

    A part is loaded when the first batch of rays comes near it: cameras look into few rooms.
    Context manager; or give it a ``client`` to use, which then stays open.
    """

    def __init__(self, library: Library, scene: Scene, client: Client | None = None) -> None:
        self._own = client is None
        self._client = Client() if client is None else client
        self._client.reset()
        self._library = library
        self._owner = {body: (key, 0) for body, key in add_structures(self._client, scene).items()}
        self._shapes: dict[tuple[str, str], int] = {}
        self._parts = list(_parts(library, scene))
        self._table = self._owners()

    def _owners(self) -> Ints:
        """Node id and part of every body, (N, 2); one row more, zeros, which a miss (−1) reads."""
        table = np.zeros((max(self._owner, default=-1) + 2, 2), dtype=np.int64)
        for body, pair in self._owner.items():
            table[body] = pair
        return table

    def _load(self, low: Array, high: Array) -> None:
        """Make the parts whose boxes reach into this one."""
        if not self._parts:
            return
        bounds = np.array([part.bounds for part in self._parts])
        near = ((bounds[:, 0] <= high + NEAR_M) & (bounds[:, 1] >= low - NEAR_M)).all(axis=1)
        for part in (self._parts[k] for k in np.flatnonzero(near).tolist()):
            if part.shape not in self._shapes:
                asset, name = part.shape
                self._shapes[part.shape] = self._client.trimesh(self._library.objs(asset)[name])
            body = self._client.body(
                self._shapes[part.shape],
                vec3(part.pose[:3, 3]),
                quat_from_matrix(part.pose[:3, :3]),
            )
            self._owner[body] = part.owner
        if near.any():
            self._parts = [self._parts[k] for k in np.flatnonzero(~near).tolist()]
            self._table = self._owners()

    def __enter__(self) -> RayWorld:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()

    def close(self) -> None:
        """Let go of the world if it is ours."""
        if self._own:
            self._client.close()

    def cast(self, origins_m: Array, targets_m: Array) -> Hits:
        """First thing each segment from (N, 3) origins to (N, 3) targets meets."""
        origins = np.ascontiguousarray(origins_m, dtype=np.float64)
        targets = np.ascontiguousarray(targets_m, dtype=np.float64)
        if len(origins):
            ends = np.concatenate([origins, targets])
            self._load(ends.min(axis=0), ends.max(axis=0))
        hits = self._client.rays(origins, targets)
        pair = self._table[hits.body]
        length = np.linalg.norm(targets - origins, axis=1)
        distance = np.where(hits.body >= 0, hits.fraction * length, np.inf)
        return Hits(object_id=pair[:, 0], part=pair[:, 1], distance_m=distance)


def _parts(library: Library, scene: Scene) -> Iterator[_Part]:
    for item in sorted(scene.objects, key=lambda o: o.id):
        info, meshes = library.info(item.asset), library.mesh(item.asset)
        world_from_object = item.pose.matrix()
        for number, name in enumerate(info.variants[item.variant], start=1):
            pose = world_from_object @ object_from_part(info, name, item.joints)
            corners = apply(pose, box_corners(*meshes[name].bounds_m.tolist()))
            bounds = np.array([corners.min(axis=0), corners.max(axis=0)])
            yield _Part((item.id, number), (item.asset, name), pose, bounds)
