"""An MJCF file of strangers as one tree: includes followed, defaults and compiler settings known.

https://mujoco.readthedocs.io/en/stable/XMLreference.html. Read within bounds: files that its
:class:`Files` find, none within itself, no entities.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Protocol
from xml.etree.ElementTree import Element

import numpy as np

from sdgen.errors import SHOWN, AssetError
from sdgen.geometry import Array, quat_from_axis_angle, rotation_matrix
from sdgen.importing import shapes
from sdgen.importing.xml_text import MAX_BYTES, parse_xml

#: Elements within elements, an include counted as one; files and elements in all: homes of
#: thousands of objects include one each.
_DEEPEST, _MOST_FILES, _MOST_ELEMENTS = 200, 5000, 2_000_000
_MAIN = "main"
#: Ways to write a rotation; an element has one.
_TURNS = ("quat", "axisangle", "euler", "xyaxes", "zaxis")

Attributes = Mapping[str, str]


class Files(Protocol):
    """Where a document's files are: nothing but what lies in the folder that was imported."""

    def find(self, base: Path, reference: str, /) -> Path | None:
        """The file that ``reference`` means in a file of the folder ``base``; None for none."""

    def bytes_of(self, path: Path, max_bytes: int, /) -> bytes:
        """Its bytes. Raises InputError, located."""

    def shown(self, path: Path, /) -> str:
        """Its path as people know it."""


class MjcfDocument:
    """The elements of a file with its includes. Raises InputError, located, for what is broken.

    ``problems`` gathers what is wrong with single elements: :meth:`check` raises them together.
    ``left_out`` is what nobody looks at.
    """

    def __init__(self, path: Path, files: Files) -> None:
        self.path = path
        self.files = files
        self.problems: list[str] = []
        self.left_out: list[str] = []
        self._shown = files.shown(path)
        self._files = 0
        self._elements = 0
        self.root = self._file(path, (), 0)
        if self.root.tag != "mujoco":
            raise AssetError([f"{self._shown}: is no MJCF: its root is <{self.root.tag[:40]}>"])
        self._compiler: dict[str, str] = {}
        for found in self.root.findall("compiler"):
            self._compiler.update(found.attrib)
        #: What a unit of an angle is, radians.
        self.angle_rad = 1.0 if self._compiler.get("angle") == "radian" else math.pi / 180
        self._order = self._compiler.get("eulerseq", "xyz")
        if len(self._order) != 3 or set(self._order.lower()) - set("xyz"):
            text = f"compiler eulerseq {self._order[:10]!r} is not three of x, y, z"
            raise AssetError([f"{self._shown}: {text}"])
        self._defaults: dict[str, dict[str, Attributes]] = {_MAIN: {}}
        for found in self.root.findall("default"):
            self._default(found, found.get("class", _MAIN), self._defaults[_MAIN])

    # --- files -----------------------------------------------------------------------------------

    def _file(self, path: Path, above: tuple[Path, ...], depth: int) -> Element:
        if path in above:
            including = self.files.shown(above[-1])
            raise AssetError([f"{including}: includes {path.name}, which includes it"])
        self._files += 1
        if self._files > _MOST_FILES:
            raise AssetError([f"{self._shown}: includes more than {_MOST_FILES} files"])
        root = parse_xml(self.files.bytes_of(path, MAX_BYTES), self.files.shown(path))
        self._elements += sum(1 for _ in root.iter())
        if self._elements > _MOST_ELEMENTS:
            raise AssetError([f"{self._shown}: more than {_MOST_ELEMENTS} elements in all"])
        self._include(root, (*above, path), depth)
        return root

    def _include(self, element: Element, within: tuple[Path, ...], depth: int) -> None:
        """Put what is included in the place of ``<include file=...>``, in an element and below."""
        shown = self.files.shown(within[-1])
        if depth > _DEEPEST:
            raise AssetError([f"{shown}: is nested too deeply"])
        children: list[Element] = []
        for child in element:
            if child.tag != "include":
                self._include(child, within, depth + 1)
                children.append(child)
                continue
            # MuJoCo looks from the folder of the main file, some tools from that of the including.
            name = child.get("file", "")
            folders = (within[0].parent, within[-1].parent)
            tried = (self.files.find(folder, name) for folder in dict.fromkeys(folders))
            found = next((path for path in tried if path is not None), None)
            if found is None:
                raise AssetError([f"{shown}: include {name[:80]!r}: no such file in its folder"])
            children += self._file(found, within, depth + 1)
        element[:] = children

    def problem(self, element: Element, text: str) -> None:
        """Note what is wrong with an element."""
        name = element.get("name", "")
        called = f"{element.tag} {name[:60]!r}" if name else element.tag
        self.problems.append(f"{self._shown}: {called}: {text}")

    def check(self) -> None:
        """Raise AssetError with all that was noted."""
        if self.problems:
            raise AssetError(list(dict.fromkeys(self.problems))[:SHOWN])

    # --- elements --------------------------------------------------------------------------------

    def inside(
        self, parent: Element, here: Array, childclass: str | None
    ) -> Iterator[tuple[Element, Array, str | None]]:
        """What is in a body, frames opened, each with where it hangs (4x4) and its class of
        defaults, when it names none."""
        for child in parent:
            if child.tag == "frame":
                within = here @ self.parent_from(child, child.attrib)
                yield from self.inside(child, within, child.get("childclass") or childclass)
            elif child.tag == "replicate":
                # Its own numbers are what lies between two copies.
                self._leave_out("replicate: all of its copies but the first")
                yield from self.inside(child, here, child.get("childclass") or childclass)
            elif child.tag == "attach":
                self._leave_out(f"attach {child.get('model', '')!r}: models within models")
            else:
                yield child, here, childclass

    def _leave_out(self, text: str) -> None:
        if text not in self.left_out:
            self.left_out.append(text)

    def assets(self, tag: str) -> dict[str, Element]:
        """Meshes, textures or materials by their names, or those of their files."""
        return {
            one.get("name") or Path(one.get("file", "").replace("\\", "/")).stem: one
            for one in self.root.findall(f"asset/{tag}")
        }

    def asset_file(self, given: Attributes, folder: str) -> Path | None:
        """The file of an asset, which lies in the folder that the compiler's ``folder`` names."""
        name = given.get("file", "").replace("\\", "/")
        if self._compiler.get("strippath") == "true":
            name = name.rsplit("/", 1)[-1]
        base = self._compiler.get(folder) or self._compiler.get("assetdir") or ""
        return self.files.find(self.path.parent / base, name)

    def _default(self, element: Element, name: str, above: Mapping[str, Attributes]) -> None:
        own = dict(above)
        for child in element:
            if child.tag != "default":
                own[child.tag] = _over(own.get(child.tag, {}), child.attrib)
        self._defaults[name] = own
        for child in element.findall("default"):
            self._default(child, child.get("class", ""), own)

    def given(self, element: Element, childclass: str | None) -> Attributes:
        """The attributes of an element, with those of its class or of the bodies above."""
        name = element.get("class") or childclass or _MAIN
        if name not in self._defaults:
            self.problem(element, f"there is no default class {name[:60]!r}")
        return _over(self._defaults.get(name, {}).get(element.tag, {}), element.attrib)

    # --- numbers ---------------------------------------------------------------------------------

    def geom_from_mesh(self, mesh: Element) -> Array:
        """4x4 that takes the vertices of an ``<asset>`` mesh as they are in its file to those of
        the geom: past its reference frame first, then scaled, as MuJoCo does."""
        given = self.given(mesh, None)
        out = np.eye(4)
        out[:3, 3] = -np.array(self.numbers(mesh, given, "refpos", 3) or (0.0, 0.0, 0.0))
        quat = self.numbers(mesh, given, "refquat", 4)
        if quat is not None and math.hypot(*quat) > 0:
            w, x, y, z = quat
            out[:3] = rotation_matrix((x, y, z, w)).T @ out[:3]
        scale = self.numbers(mesh, given, "scale", 3) or (1.0, 1.0, 1.0)
        return np.asarray(np.diag([*scale, 1.0]) @ out)

    def numbers(
        self, element: Element, given: Attributes, key: str, count: int | None = None
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

    def parent_from(self, element: Element, given: Attributes) -> Array:
        """Where an element is in its parent, 4x4."""
        out = np.eye(4)
        out[:3, 3] = self.numbers(element, given, "pos", 3) or (0.0, 0.0, 0.0)
        try:
            out[:3, :3] = self._rotation(element, given)
        except ValueError as error:
            self.problem(element, str(error))
        return out

    def _rotation(self, element: Element, given: Attributes) -> Array:
        if (q := self.numbers(element, given, "quat", 4)) is not None:
            return rotation_matrix(_unit([*q[1:], q[0]], "quat").tolist())
        if (a := self.numbers(element, given, "axisangle", 4)) is not None:
            axis = _unit(a[:3], "axisangle").tolist()
            return rotation_matrix(quat_from_axis_angle(axis, a[3] * self.angle_rad))
        if (e := self.numbers(element, given, "euler", 3)) is not None:
            return shapes.euler([value * self.angle_rad for value in e], self._order)
        if (v := self.numbers(element, given, "xyaxes", 6)) is not None:
            x = _unit(v[:3], "xyaxes")
            y = _unit(np.array(v[3:]) - x * (x @ v[3:]), "xyaxes")
            return np.column_stack([x, y, np.cross(x, y)])
        if (z := self.numbers(element, given, "zaxis", 3)) is not None:
            return shapes.least_turn((0.0, 0.0, 1.0), _unit(z, "zaxis"))
        return np.eye(3)


def viewers_show(geom: Attributes) -> bool:
    """True for a geom of the groups that MuJoCo's viewer shows unasked; others only collide."""
    return geom.get("group", "0").strip() in ("0", "1", "2")


def _over(usual: Attributes, own: Attributes) -> Attributes:
    """Attributes over those of a class; a rotation goes over one that is written another way."""
    if any(key in own for key in _TURNS):
        usual = {key: value for key, value in usual.items() if key not in _TURNS}
    return {**usual, **own}


def _unit(values: list[float] | Array, key: str) -> Array:
    vector = np.asarray(values, dtype=float)
    size = float(np.linalg.norm(vector))
    if not 1e-12 < size < math.inf:
        raise ValueError(f"{key} is zero" if size < 1 else f"{key} has no direction")
    return np.asarray(vector / size)
