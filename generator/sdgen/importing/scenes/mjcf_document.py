"""An MJCF file of strangers as one tree: includes followed, defaults and compiler settings known.

Read within bounds: files of its own folder only, no file within itself, no entities.
"""

from __future__ import annotations

import math
import xml.etree.ElementTree as Tree
from collections.abc import Iterator, Mapping
from pathlib import Path

import numpy as np

from sdgen.errors import SHOWN, InputError
from sdgen.files import read_plain
from sdgen.geometry import Array, matrix, quat_from_axis_angle, quat_from_matrix, rotation_matrix
from sdgen.importing.scenes.mesh_bounds import Bounds, mesh_bounds
from sdgen.importing.xml_text import MAX_BYTES, parse_xml

#: Includes within includes, and files in all: homes of thousands of objects include one each.
_DEEPEST, _MOST_FILES = 20, 5000
#: Elements of the whole tree.
_MOST_ELEMENTS = 2_000_000
_DEFAULT = "main"


class MjcfDocument:
    """The elements of a file with its includes. Raises InputError, located, for what is broken.

    ``problems`` gathers what is wrong with single elements: :meth:`check` raises them together.
    """

    def __init__(self, path: Path) -> None:
        self._path = path
        self._root_folder = path.parent.resolve()
        self.problems: list[str] = []
        self._files = 0
        self._elements = 0
        self.root = self._file(path, ())
        if self.root.tag != "mujoco":
            raise InputError([f"{path}: is no MJCF: its root is <{self.root.tag[:40]}>"])
        self._compiler: dict[str, str] = {}
        for found in self.root.findall("compiler"):
            self._compiler.update(found.attrib)
        self._defaults: dict[str, dict[str, dict[str, str]]] = {_DEFAULT: {}}
        for found in self.root.findall("default"):
            self._default(found, {}, top=True)
        self._meshes = self._named_meshes()
        self._bounds: dict[str, Bounds | None] = {}

    # --- files -----------------------------------------------------------------------------------

    def _file(self, path: Path, above: tuple[Path, ...]) -> Tree.Element:
        shown = str(path)
        here = path.resolve()
        if here in above:
            raise InputError([f"{above[-1]}: includes {path.name}, which includes it"])
        if len(above) > _DEEPEST:
            raise InputError([f"{shown}: is included more than {_DEEPEST} deep"])
        self._files += 1
        if self._files > _MOST_FILES:
            raise InputError([f"{self._path}: includes more than {_MOST_FILES} files"])
        root = parse_xml(read_plain(path, shown, MAX_BYTES), shown)
        self._elements += sum(1 for _ in root.iter())
        if self._elements > _MOST_ELEMENTS:
            raise InputError([f"{shown}: more than {_MOST_ELEMENTS} elements in all"])
        self._included(root, path, (*above, here))
        return root

    def _included(self, element: Tree.Element, path: Path, above: tuple[Path, ...]) -> None:
        """Put what is included in the place of ``<include file=...>``, in an element and below."""
        for child in list(element):
            if child.tag != "include":
                self._included(child, path, above)
                continue
            # MuJoCo looks from the folder of the main file, some tools from that of the including.
            name = child.get("file", "")
            found = self.inside(path.parent, name) or self.inside(self._path.parent, name)
            if found is None:
                raise InputError([f"{path}: include {name[:80]!r}: lies outside {path.parent}"])
            if not found.exists():
                other = self.inside(self._path.parent, name)
                found = other if other is not None else found
            at = list(element).index(child)
            element.remove(child)
            for number, one in enumerate(self._file(found, above)):
                element.insert(at + number, one)

    def inside(self, folder: Path, name: str) -> Path | None:
        """A file that is named in ``folder``; None for one out of the scene's folder."""
        if not name or "\0" in name or "://" in name:
            return None
        path = folder / name.replace("\\", "/")
        try:
            return path if path.resolve().is_relative_to(self._root_folder) else None
        except (OSError, RuntimeError, ValueError):
            return None

    def problem(self, element: Tree.Element, text: str) -> None:
        """Note what is wrong with an element."""
        name = element.get("name", "")
        called = f"{element.tag} {name[:60]!r}" if name else element.tag
        self.problems.append(f"{self._path}: {called}: {text}")

    def check(self) -> None:
        """Raise InputError with all that was noted."""
        if self.problems:
            raise InputError(list(dict.fromkeys(self.problems))[:SHOWN])

    # --- defaults --------------------------------------------------------------------------------

    def _default(
        self, element: Tree.Element, above: Mapping[str, Mapping[str, str]], top: bool = False
    ) -> None:
        name = element.get("class", _DEFAULT if top else "")
        mine = {tag: dict(given) for tag, given in above.items()}
        if top and name == _DEFAULT:
            mine = self._defaults[_DEFAULT]
        for child in element:
            if child.tag != "default":
                mine.setdefault(child.tag, {}).update(child.attrib)
        self._defaults[name] = mine
        for child in element.findall("default"):
            self._default(child, mine)

    def given(self, element: Tree.Element, childclass: str | None) -> Mapping[str, str]:
        """The attributes of an element, with those of its class or of the bodies above."""
        name = element.get("class") or childclass or _DEFAULT
        found = self._defaults.get(name)
        if found is None:
            self.problem(element, f"there is no default class {name[:60]!r}")
            found = {}
        return {**found.get(element.tag, {}), **element.attrib}

    # --- numbers ---------------------------------------------------------------------------------

    def numbers(
        self, element: Tree.Element, given: Mapping[str, str], key: str, count: int | None
    ) -> list[float] | None:
        """The finite numbers of an attribute; None when it is not there, or noted as wrong."""
        text = given.get(key)
        if text is None:
            return None
        try:
            values = [float(word) for word in text.split()]
        except ValueError:
            values = []
        if not values or not all(map(math.isfinite, values)) or (count and len(values) != count):
            wanted = f"{count} finite numbers" if count else "finite numbers"
            self.problem(element, f"{key}: {text[:60]!r} is not {wanted}")
            return None
        return values

    def parent_from(self, element: Tree.Element, given: Mapping[str, str]) -> Array:
        """Where an element is in its parent, 4x4."""
        position = self.numbers(element, given, "pos", 3) or [0.0, 0.0, 0.0]
        return matrix(position, self._quat(element, given))

    def _quat(self, element: Tree.Element, given: Mapping[str, str]) -> tuple[float, ...]:
        radians = 1.0 if self._compiler.get("angle") == "radian" else math.pi / 180
        try:
            if (q := self.numbers(element, given, "quat", 4)) is not None:
                if not any(q):
                    raise ValueError("quat is zero")
                return (q[1], q[2], q[3], q[0])
            if (a := self.numbers(element, given, "axisangle", 4)) is not None:
                return quat_from_axis_angle(_unit(a[:3]).tolist(), a[3] * radians)
            if (e := self.numbers(element, given, "euler", 3)) is not None:
                return self._euler([value * radians for value in e])
            if (x := self.numbers(element, given, "xyaxes", 6)) is not None:
                first = _unit(x[:3])
                second = _unit(np.array(x[3:]) - first * (first @ x[3:]))
                return quat_from_matrix(np.column_stack([first, second, np.cross(first, second)]))
            if (z := self.numbers(element, given, "zaxis", 3)) is not None:
                return _turn_to(_unit(z))
        except ValueError as error:
            self.problem(element, str(error))
        return (0.0, 0.0, 0.0, 1.0)

    def _euler(self, angles: list[float]) -> tuple[float, ...]:
        order = self._compiler.get("eulerseq", "xyz")
        if len(order) != 3 or set(order.lower()) - set("xyz"):
            raise ValueError(f"compiler eulerseq {order[:10]!r} is not three of x, y, z")
        turned = np.eye(3)
        for axis, angle in zip(order, angles, strict=True):
            unit = [float(axis.lower() == one) for one in "xyz"]
            step = rotation_matrix(quat_from_axis_angle(unit, angle))
            # Lower case turns about the turned axes, upper case about the fixed ones.
            turned = turned @ step if axis.islower() else step @ turned
        return quat_from_matrix(turned)

    # --- meshes ----------------------------------------------------------------------------------

    def _named_meshes(self) -> dict[str, Tree.Element]:
        out = {}
        for assets in self.root.findall("asset"):
            for mesh in assets.findall("mesh"):
                out[mesh.get("name") or Path(mesh.get("file", "")).stem] = mesh
        return out

    def mesh(self, name: str) -> Bounds | None:
        """The box of a mesh as a geom has it; None, and said once, when it cannot be had."""
        if name not in self._bounds:
            element = self._meshes.get(name)
            self._bounds[name] = None if element is None else self._mesh_box(element)
        return self._bounds[name]

    def _mesh_box(self, element: Tree.Element) -> Bounds | None:
        given = self.given(element, None)
        scale = np.array(self.numbers(element, given, "scale", 3) or [1.0, 1.0, 1.0])
        points = self.numbers(element, given, "vertex", None)
        if points is not None:
            if len(points) % 3:
                self.problem(element, "vertex: its numbers are not three a point")
                return None
            rows = np.array(points).reshape(-1, 3) * scale
            return rows.min(axis=0), rows.max(axis=0)
        name = given.get("file", "")
        folder = self._compiler.get("meshdir", self._compiler.get("assetdir", ""))
        if self._compiler.get("strippath") == "true":
            name = Path(name.replace("\\", "/")).name
        path = self.inside(self._path.parent / folder, name)
        if path is None:
            self.problem(element, f"file {name[:80]!r}: lies outside the scene's folder")
            return None
        try:
            low, high = mesh_bounds(path, str(path))
        except ValueError as error:
            self.problem(element, f"file {name[:80]!r}: {error}")
            return None
        except InputError as error:
            self.problems += error.problems
            return None
        ends = np.array([low * scale, high * scale])
        return ends.min(axis=0), ends.max(axis=0)

    def texts(self) -> Iterator[tuple[str, str]]:
        """Custom text, by name."""
        for custom in self.root.findall("custom"):
            for text in custom.findall("text"):
                yield text.get("name", ""), text.get("data", "")


def _unit(values: list[float] | Array) -> Array:
    vector = np.asarray(values, dtype=float)
    size = float(np.linalg.norm(vector))
    if size < 1e-12:
        raise ValueError("a direction is zero")
    return np.asarray(vector / size)


def _turn_to(z: Array) -> tuple[float, ...]:
    """The least turn that makes +z look along ``z``."""
    axis = np.cross((0.0, 0.0, 1.0), z)
    size = float(np.linalg.norm(axis))
    if size < 1e-9:
        return (0.0, 0.0, 0.0, 1.0) if z[2] > 0 else (1.0, 0.0, 0.0, 0.0)
    return quat_from_axis_angle((axis / size).tolist(), math.atan2(size, float(z[2])))
