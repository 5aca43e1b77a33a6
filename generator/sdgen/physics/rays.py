"""Ray tests against what is drawn: the geometry that decides cameras and visibility."""

from __future__ import annotations

from dataclasses import dataclass
from types import TracebackType

import numpy as np
import numpy.typing as npt

from sdgen.geometry import Array, quat_from_matrix, vec3
from sdgen.library import Library
from sdgen.library.states import object_from_part
from sdgen.physics.bodies import add_structures
from sdgen.physics.client import Client
from sdgen.scene import Scene

Ints = npt.NDArray[np.int64]


@dataclass(frozen=True)
class Hits:
    """What N rays met first: node id (0 = nothing), part (1-based index into the object's drawn
    parts, 0 for structures) and distance in metres (inf = nothing)."""

    object_id: Ints
    part: Ints
    distance_m: Array


class RayWorld:
    """The drawn triangles of a scene, standing still, for :meth:`cast`.

    Context manager; or give it a ``client`` to use, which then stays open.
    """

    def __init__(self, library: Library, scene: Scene, client: Client | None = None) -> None:
        self._own = client is None
        self._client = Client() if client is None else client
        self._client.reset()
        owner = {body: (key, 0) for body, key in add_structures(self._client, scene).items()}
        shapes: dict[tuple[str, str], int] = {}
        for item in sorted(scene.objects, key=lambda o: o.id):
            info = library.info(item.asset)
            world_from_object = item.pose.matrix()
            for number, part in enumerate(info.variants[item.variant], start=1):
                if (item.asset, part) not in shapes:
                    path = library.objs(item.asset)[part]
                    shapes[item.asset, part] = self._client.trimesh(path)
                pose = world_from_object @ object_from_part(info, part, item.joints)
                body = self._client.body(
                    shapes[item.asset, part], vec3(pose[:3, 3]), quat_from_matrix(pose[:3, :3])
                )
                owner[body] = (item.id, number)
        # One row more, zeros, which a miss (body −1) reads.
        table = np.zeros((max(owner, default=-1) + 2, 2), dtype=np.int64)
        for body, pair in owner.items():
            table[body] = pair
        self._table = table

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
        hits = self._client.rays(origins, targets)
        pair = self._table[hits.body]
        length = np.linalg.norm(targets - origins, axis=1)
        distance = np.where(hits.body >= 0, hits.fraction * length, np.inf)
        return Hits(object_id=pair[:, 0], part=pair[:, 1], distance_m=distance)
