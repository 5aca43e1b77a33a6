"""Walls of a home from the mesh of its empty shell, by level cuts through it."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from sdgen.errors import InputError
from sdgen.geometry import Array
from sdgen.importing.scenes.found import KNEE_M, FoundWall, check_reach, triangles_at
from sdgen.importing.scenes.gltf_document import GltfDocument

#: Cuts: above doors, where walls are whole, and where they are not.
_OVER_DOORS_M, _CHEST_M = 2.25, 1.0
#: Half of what a cut line is made as thick as, metres.
_HALF_M = 0.04
#: Floors are level within this slope, and found in bins so high, metres.
_LEVEL, _BIN_M = 0.95, 0.05
#: The lowest level with this share of the largest one's area is the floor.
_SHARE = 0.3


def stage_walls(path: Path, ours_from_file: Array) -> list[FoundWall]:
    """The walls of a shell; their foot is its floor's level.

    Raises InputError, located, for a file that cannot be read.
    """
    document = GltfDocument(path)
    triangles = document.triangles(document.all_meshes(ours_from_file))
    if not len(triangles):
        return []
    try:
        check_reach(triangles)
    except ValueError as error:
        raise InputError([f"{path}: {error}"]) from None
    level = _floor_level(triangles)
    top = float(triangles[:, :, 2].max())
    cut = level + (_OVER_DOORS_M if top > level + _OVER_DOORS_M + 0.05 else _CHEST_M)
    thick = triangles_at(triangles, cut).buffer(_HALF_M, cap_style="square", join_style="mitre")
    low = triangles_at(triangles, level + KNEE_M).buffer(_HALF_M, join_style="mitre")
    return [FoundWall(path.stem, thick, level, top, low)]


def _floor_level(triangles: Array) -> float:
    """The level of the lowest large floor."""
    normals = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    sizes = np.linalg.norm(normals, axis=1)
    up = normals[:, 2] > _LEVEL * np.maximum(sizes, 1e-12)
    if not up.any():
        return float(triangles[:, :, 2].min())
    heights = triangles[up][:, :, 2].mean(axis=1)
    bins = np.round(heights / _BIN_M).astype(int)
    levels, at = np.unique(bins, return_inverse=True)
    areas = np.bincount(at, weights=sizes[up])
    lowest = int(np.flatnonzero(areas > _SHARE * areas.max())[0])
    return float(np.median(heights[bins == levels[lowest]]))
