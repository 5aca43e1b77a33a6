"""The box of an articulated object, by its URDF: every joint at 0, its drawn meshes as they are."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np

from sdgen.errors import InputError
from sdgen.files import read_plain
from sdgen.geometry import Array, apply, box_corners, lowest_highest
from sdgen.importing.scenes.mesh_bounds import Bounds
from sdgen.importing.urdf_tree import UrdfTree, numbers, origin, urdf_tree
from sdgen.importing.xml_text import MAX_BYTES, parse_xml

Meshes = Callable[[Path, str], Bounds]


def urdf_box(path: Path, mesh: Meshes) -> Bounds:
    """Lowest and highest corner in the frame of the root link. ``mesh`` gives the box of the file
    that is named in a folder.

    Raises InputError, located, for a file that is broken or has no mesh.
    """
    root = parse_xml(read_plain(path, str(path), MAX_BYTES), str(path))
    try:
        corners = _corners(urdf_tree(root), path.parent, mesh)
    except ValueError as error:
        raise InputError([f"{path}: {error}"]) from None
    if not len(corners):
        raise InputError([f"{path}: has no mesh that can be read"])
    return lowest_highest(corners)


def _corners(tree: UrdfTree, folder: Path, mesh: Meshes) -> Array:
    """Corners (N, 3) of the boxes of all drawn meshes."""
    found = [np.zeros((0, 3))]
    for name, link in tree.links.items():
        for visual in link.findall("visual"):
            shape = visual.find("geometry/mesh")
            if shape is None:
                continue
            low, high = mesh(folder, shape.get("filename", ""))
            scale = numbers(shape, "scale", (1.0, 1.0, 1.0))
            corners = box_corners((low * scale).tolist(), (high * scale).tolist())
            found.append(apply(tree.placed(name) @ origin(visual), corners))
    return np.concatenate(found)
