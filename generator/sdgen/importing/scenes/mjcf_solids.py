"""The geoms of an MJCF scene as boxes."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from xml.etree.ElementTree import Element

import numpy as np

from sdgen.errors import InputError
from sdgen.geometry import Array, apply, box_corners, lowest_highest
from sdgen.importing.mjcf_document import Attributes, MjcfDocument, viewers_show
from sdgen.importing.scenes.mesh_bounds import Bounds, mesh_bounds

#: Types of geoms that are fitted to their mesh, where they name one.
_FITTED = ("mesh", "sdf", "box", "sphere", "capsule", "cylinder")
#: Type -> numbers of ``size`` that it takes; without ``fromto``.
_SIZES = {"sphere": 1, "capsule": 2, "cylinder": 2, "box": 3, "ellipsoid": 3}


@dataclass(frozen=True)
class Solid:
    """A geom: its box in its own frame, where that is in the body, and what it is called."""

    name: str
    low: Array
    high: Array
    body_from_geom: Array
    visual: bool
    shown: bool

    def corners(self, parent: Array) -> Array:
        """The corners (8, 3) of its box in the frame that ``parent`` leads to."""
        return apply(
            parent @ self.body_from_geom, box_corners(self.low.tolist(), self.high.tolist())
        )


@dataclass
class Solids:
    """The solids of a document; what is wrong with its geoms is noted there."""

    document: MjcfDocument
    _meshes: dict[str, Element] = field(init=False)
    _bounds: dict[str, Bounds | None] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self._meshes = self.document.assets("mesh")

    def of_body(self, body: Element, childclass: str | None) -> Iterator[Solid]:
        """The geoms of a body and of all bodies in it, in the body's frame."""
        stack = [(body, np.eye(4), childclass)]
        while stack:
            for element, within, inner in self.document.inside(*stack.pop()):
                if element.tag == "body":
                    below = within @ self.document.parent_from(element, element.attrib)
                    stack.append((element, below, element.get("childclass") or inner))
                elif element.tag == "geom":
                    solid = self.of_geom(element, within, inner)
                    if solid is not None:
                        yield solid

    def of_geom(self, geom: Element, here: Array, childclass: str | None) -> Solid | None:
        """A geom's box; None for what has none (a plane), is not seen or is noted as wrong."""
        given = self.document.given(geom, childclass)
        rgba = self.document.numbers(geom, given, "rgba")
        if rgba is not None and len(rgba) == 4 and rgba[3] == 0:
            return None
        place = self.document.parent_from(geom, given)
        ends = self.document.numbers(geom, given, "fromto", 6)
        bounds = self._box(geom, given, ends)
        if bounds is None:
            return None
        visual = given.get("contype") == "0" and given.get("conaffinity") == "0"
        name = given.get("name") or given.get("mesh") or ""
        shown = viewers_show(given)
        return Solid(name, *bounds, here if ends is not None else here @ place, visual, shown)

    def _box(self, geom: Element, given: Attributes, ends: list[float] | None) -> Bounds | None:
        kind = given.get("type", "sphere")
        if "mesh" in given and kind in _FITTED:
            return self._mesh(geom, given["mesh"])
        needed = _SIZES.get(kind)
        if needed is None:
            return None
        size = self.document.numbers(geom, given, "size") or []
        if ends is not None:
            needed = 1
        if len(size) < needed:
            self.document.problem(geom, f"size: a {kind} needs {needed} numbers")
            return None
        if ends is not None:
            points = np.array(ends).reshape(2, 3)
            return points.min(axis=0) - size[0], points.max(axis=0) + size[0]
        if needed == 1:
            size = size[:1] * 3
        elif needed == 2:
            size = [size[0], size[0], size[1] + (size[0] if kind == "capsule" else 0.0)]
        reach = np.array(size[:3])
        return -reach, reach

    def _mesh(self, geom: Element, name: str) -> Bounds | None:
        """The box of a mesh as a geom has it; None, and said once, when it cannot be had."""
        if name not in self._bounds:
            element = self._meshes.get(name)
            if element is None:
                self.document.problem(geom, f"mesh {name[:80]!r}: no such mesh in <asset>")
            self._bounds[name] = None if element is None else self._mesh_box(element)
        return self._bounds[name]

    def _mesh_box(self, element: Element) -> Bounds | None:
        given = self.document.given(element, None)
        moved = self.document.geom_from_mesh(element)
        points = self.document.numbers(element, given, "vertex")
        if points is not None:
            if len(points) % 3:
                self.document.problem(element, "vertex: its numbers are not three a point")
                return None
            return lowest_highest(apply(moved, np.array(points).reshape(-1, 3)))
        name = given.get("file", "")
        path = self.document.asset_file(given, "meshdir")
        if path is None:
            text = f"file {name[:80]!r}: no such file in the scene's folder"
            self.document.problem(element, text)
            return None
        return self._file_box(element, name, path, moved)

    def _file_box(self, element: Element, name: str, path: Path, moved: Array) -> Bounds | None:
        try:
            low, high = mesh_bounds(path, str(path))
        except ValueError as error:
            self.document.problem(element, f"file {name[:80]!r}: {error}")
            return None
        except InputError as error:
            self.document.problems += error.problems
            return None
        return lowest_highest(apply(moved, box_corners(low.tolist(), high.tolist())))
