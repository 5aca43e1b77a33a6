"""How many pixels of a picture each object would have with nothing in front of it."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from sdgen.cameras.parts import world_triangles
from sdgen.geometry import Array, apply, inverse
from sdgen.library import Library
from sdgen.render.coverage import coverages
from sdgen.scene import Camera, Scene


class AlonePixels:
    """Counts them for the views of one scene, whose triangles are placed once."""

    def __init__(self, library: Library, scene: Scene) -> None:
        self._library = library
        self._objects = {item.id: item for item in scene.objects}
        self._triangles: dict[int, Array] = {}

    def __call__(self, camera: Camera, instance: npt.NDArray[np.uint16]) -> dict[int, int]:
        """Pixels alone of the objects seen in ``instance`` (H, W), by id: those they are seen in,
        and those they would cover besides."""
        # Runs of equal pixels are a hundredth as many as pixels.
        flat = instance.ravel()
        starts = np.flatnonzero(np.append(True, flat[1:] != flat[:-1]))
        pixels = np.bincount(flat[starts], weights=np.diff(starts, append=flat.size))
        seen = [key for key in np.flatnonzero(pixels).tolist() if key in self._objects]
        camera_from_world = inverse(np.asarray(camera.world_from_camera))
        local = [apply(camera_from_world, self._corners(key)).reshape(-1, 3, 3) for key in seen]
        size = (camera.width, camera.height)
        covered = coverages(local, np.asarray(camera.K), *size, camera.near_m)
        return {
            key: int(pixels[key]) + int(np.count_nonzero(mask & (instance[rows, columns] != key)))
            for key, (mask, rows, columns) in zip(seen, covered, strict=True)
        }

    def _corners(self, node_id: int) -> Array:
        """The corners (3 N, 3) of an object's triangles in the world, found once."""
        if node_id not in self._triangles:
            triangles = world_triangles(self._library, self._objects[node_id])
            self._triangles[node_id] = triangles.reshape(-1, 3)
        return self._triangles[node_id]
