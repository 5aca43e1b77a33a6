"""The drawn parts of an object as geometry in the world."""

from __future__ import annotations

from collections.abc import Collection

import numpy as np
import numpy.typing as npt

from sdgen.geometry import Array, apply
from sdgen.library import Library
from sdgen.library.states import object_from_part
from sdgen.scene import ObjectInstance


def part_points(library: Library, item: ObjectInstance, parts: Collection[str]) -> Array:
    """Vertices in the world of the drawn ``parts`` of an object (all when empty), (N, 3)."""
    meshes = library.mesh(item.asset)
    return np.concatenate(
        [
            apply(_world_from_part(library, item, name), meshes[name].vertices)
            for name in _wanted(library, item, parts)
        ]
    )


def part_area(library: Library, item: ObjectInstance, parts: Collection[str]) -> float:
    """Surface of the drawn ``parts`` of an object (all when empty), square metres."""
    total = 0.0
    for name in _wanted(library, item, parts):
        mesh = library.mesh(item.asset)[name]
        corners = mesh.vertices[mesh.faces]
        sides = corners[:, 1:] - corners[:, :1]
        total += float(np.linalg.norm(np.cross(sides[:, 0], sides[:, 1]), axis=1).sum()) / 2
    return total


def part_numbers(
    library: Library, item: ObjectInstance, parts: Collection[str]
) -> npt.NDArray[np.int64]:
    """1-based numbers of the drawn ``parts`` (all when none of them is drawn)."""
    drawn = library.info(item.asset).variants[item.variant]
    wanted = [k for k, name in enumerate(drawn, start=1) if name in parts]
    return np.array(wanted or range(1, len(drawn) + 1), dtype=np.int64)


def world_triangles(library: Library, item: ObjectInstance, parts: Collection[str] = ()) -> Array:
    """Triangles in the world of the drawn ``parts`` of an object (all when empty), (N, 3, 3)."""
    meshes = library.mesh(item.asset)
    return np.concatenate(
        [
            apply(_world_from_part(library, item, name), meshes[name].vertices)[meshes[name].faces]
            for name in _wanted(library, item, parts)
        ]
    )


def _wanted(library: Library, item: ObjectInstance, parts: Collection[str]) -> list[str]:
    drawn = library.info(item.asset).variants[item.variant]
    return [name for name in drawn if name in parts] or list(drawn)


def _world_from_part(library: Library, item: ObjectInstance, name: str) -> Array:
    world_from_object = item.pose.matrix()
    return world_from_object @ object_from_part(library.info(item.asset), name, item.joints)
