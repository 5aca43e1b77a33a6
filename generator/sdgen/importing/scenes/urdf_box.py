"""The box of an articulated object, by its URDF: every joint at 0, its drawn meshes as they are."""

from __future__ import annotations

import math
import xml.etree.ElementTree as Tree
from collections.abc import Callable
from pathlib import Path

import numpy as np

from sdgen.errors import InputError
from sdgen.files import read_plain
from sdgen.geometry import (
    Array,
    apply,
    box_corners,
    lowest_highest,
    matrix,
    quat_from_axis_angle,
    quat_from_matrix,
    rotation_matrix,
)
from sdgen.importing.scenes.mesh_bounds import Bounds
from sdgen.importing.xml_text import MAX_BYTES, parse_xml

_DEEPEST = 50


def urdf_box(path: Path, mesh: Callable[[Path, str], Bounds]) -> Bounds:
    """Lowest and highest corner in the frame of the root link. ``mesh`` gives the box of the file
    that is named in a folder.

    Raises InputError, located, for a file that is broken or has no mesh.
    """
    root = parse_xml(read_plain(path, str(path), MAX_BYTES), str(path))
    reading = _Urdf(path, root, mesh)
    corners = reading.corners()
    if not len(corners):
        raise InputError([f"{path}: has no mesh that can be read"])
    return lowest_highest(corners)


class _Urdf:
    def __init__(self, path: Path, root: Tree.Element, mesh: Callable[[Path, str], Bounds]) -> None:
        self._path = path
        self._mesh = mesh
        self._links = {link.get("name", ""): link for link in root.findall("link")}
        self._joints: dict[str, list[tuple[str, Array]]] = {}
        children = set()
        for joint in root.findall("joint"):
            parent, child = joint.find("parent"), joint.find("child")
            if parent is None or child is None:
                continue
            names = parent.get("link", ""), child.get("link", "")
            self._joints.setdefault(names[0], []).append((names[1], self._origin(joint)))
            children.add(names[1])
        self._roots = [name for name in self._links if name not in children]

    def corners(self) -> Array:
        """Corners (N, 3) of the boxes of all drawn meshes."""
        found = [np.zeros((0, 3))]
        stack = [(name, np.eye(4), 0) for name in self._roots]
        while stack:
            name, here, depth = stack.pop()
            if depth > _DEEPEST or name not in self._links:
                continue
            for visual in self._links[name].findall("visual"):
                shape = visual.find("geometry/mesh")
                if shape is None:
                    continue
                low, high = self._mesh(self._path.parent, shape.get("filename", ""))
                scale = self._three(shape, "scale", (1.0, 1.0, 1.0))
                corners = box_corners((low * scale).tolist(), (high * scale).tolist())
                found.append(apply(here @ self._origin(visual), corners))
            for child, step in self._joints.get(name, ()):
                stack.append((child, here @ step, depth + 1))
        return np.concatenate(found)

    def _origin(self, element: Tree.Element) -> Array:
        origin = element.find("origin")
        if origin is None:
            return np.eye(4)
        roll, pitch, yaw = self._three(origin, "rpy", (0.0, 0.0, 0.0))
        turn = np.eye(3)
        for axis, angle in (((0, 0, 1), yaw), ((0, 1, 0), pitch), ((1, 0, 0), roll)):
            turn = turn @ rotation_matrix(quat_from_axis_angle(axis, angle))
        return matrix(self._three(origin, "xyz", (0.0, 0.0, 0.0)), quat_from_matrix(turn))

    def _three(
        self, element: Tree.Element, key: str, usual: tuple[float, float, float]
    ) -> tuple[float, float, float]:
        words = element.get(key, "").split()
        if not words:
            return usual
        try:
            x, y, z = (float(word) for word in words)
        except ValueError:
            raise InputError([f"{self._path}: {element.tag} {key}: not three numbers"]) from None
        if not all(map(math.isfinite, (x, y, z))):
            raise InputError([f"{self._path}: {element.tag} {key}: not three finite numbers"])
        return x, y, z
