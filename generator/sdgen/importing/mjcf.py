"""Reads MuJoCo XML (MJCF): bodies, joints and what is drawn, in the world's frame, Z up.

https://mujoco.readthedocs.io/en/stable/XMLreference.html. Includes stay inside the folder; of the
many elements only those are read that say where something is and how it looks.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from xml.etree.ElementTree import Element

import numpy as np

from sdgen.errors import AssetError
from sdgen.geometry import Array, inverse, rotation_matrix
from sdgen.importing import shapes
from sdgen.importing.mesh_files import MESHES, read_mesh
from sdgen.importing.pictures import checked_picture
from sdgen.importing.scan import Paint, Piece, Scan, ScanJoint
from sdgen.importing.tree import References
from sdgen.importing.xml_text import parse_xml

#: Files that a model includes, one in the other, and all together.
_MOST_DEEP, _MOST_INCLUDES = 8, 200
_GREY = (0.5, 0.5, 0.5, 1.0)
Attributes = Mapping[str, str]


@dataclass(frozen=True)
class Geom:
    """Something drawn or met: its element's attributes with defaults, where it is in the world."""

    given: Attributes
    at: Array

    @property
    def group(self) -> int:
        """Its group; viewers show 0 to 2."""
        return int(float(self.given.get("group", "0")))

    @property
    def met(self) -> bool:
        """True when something can bump into it."""
        return self.given.get("contype", "1") != "0" or self.given.get("conaffinity", "1") != "0"


@dataclass(frozen=True, eq=False)
class Body:
    """A body: ``at`` (4x4) its frame in the world, joints' attributes with their frame, geoms."""

    name: str
    parent: Body | None
    at: Array
    joints: tuple[Attributes, ...]
    geoms: tuple[Geom, ...]
    mass_kg: float | None
    element: Element = field(repr=False)

    def ancestors(self) -> Iterator[Body]:
        """The bodies it hangs on, nearest first."""
        body = self.parent
        while body is not None:
            yield body
            body = body.parent


@dataclass(frozen=True)
class Mjcf:
    """A file: its root with all includes in it, and what bodies refer to."""

    path: Path
    root: Element
    bodies: tuple[Body, ...]
    meshes: Mapping[str, Attributes]
    textures: Mapping[str, Attributes]
    materials: Mapping[str, Attributes]
    compiler: Attributes
    references: References

    def pieces_of(self, geom: Geom, link: str = "body") -> tuple[Piece, ...]:
        """Triangles of a geom in the world. Raises ValueError for what cannot be drawn."""
        paint = self._paint(geom.given)
        kind = geom.given.get("type", "mesh" if "mesh" in geom.given else "sphere")
        if kind == "mesh":
            found = self._mesh(geom.given.get("mesh", ""), paint)
            at = geom.at
        else:
            sizes = _numbers(geom.given.get("size", "0"))
            at = geom.at
            if "fromto" in geom.given:
                ends = _numbers(geom.given["fromto"], 6)
                between, length = shapes.from_to(ends[:3], ends[3:])
                at, sizes = at @ between, (sizes[0], length / 2)
            shape = _shape(kind, sizes, paint)
            found = () if shape is None else (shape,)
        return tuple(replace(piece.moved(at), link=link) for piece in found)

    def _mesh(self, name: str, paint: Paint | None) -> tuple[Piece, ...]:
        given = self.meshes.get(name)
        if given is None:
            raise ValueError(f"mesh {name!r} is not among its assets")
        file = self._file(given.get("file", ""), "meshdir")
        if file is None or file.suffix.lower() not in MESHES:
            raise ValueError(f"mesh {name!r}: {given.get('file', '')}: no such mesh")
        pieces, _ = read_mesh(file, self.references)
        scale = np.diag([*_numbers(given.get("scale", "1 1 1"), 3), 1.0])
        out = [piece.moved(scale) for piece in pieces]
        if paint is not None:
            out = [replace(piece, paint=paint) for piece in out]
        return tuple(out)

    def _paint(self, given: Attributes) -> Paint | None:
        material = self.materials.get(given.get("material", ""))
        colour = given.get("rgba")
        if material is None:
            return None if colour is None else Paint(colour=_rgba(colour))
        texture = self.textures.get(material.get("texture", ""))
        name = "" if texture is None else texture.get("file", "")
        file = self._file(name, "texturedir") if name else None
        if file is not None:
            shown = self.references.shown(file)
            # A tint below white darkens the picture, as MuJoCo draws it.
            return Paint(
                checked_picture(self.references.bytes_of(file), shown),
                _rgba(material.get("rgba", "1 1 1 1")),
            )
        return Paint(colour=_rgba(colour or material.get("rgba", "1 1 1 1")))

    def _file(self, name: str, folder: str) -> Path | None:
        base = self.compiler.get(folder) or self.compiler.get("assetdir") or ""
        return self.references.find(self.path.parent / base, name)


def read_mjcf(path: Path, references: References) -> Mjcf:
    """All of an MJCF file. Raises AssetError, located."""
    shown = references.shown(path)
    root = _with_includes(path, references, (), [0])
    if root.tag != "mujoco":
        raise AssetError([f"{shown}: is no MJCF: its root is <{root.tag}>"])
    compiler: dict[str, str] = {}
    for element in root.findall("compiler"):
        compiler.update(element.attrib)
    defaults = _defaults(root)
    try:
        bodies = tuple(_bodies(root, compiler, defaults))
    except ValueError as error:
        raise AssetError([f"{shown}: {error}"]) from None
    named: dict[str, dict[str, Attributes]] = {"mesh": {}, "texture": {}, "material": {}}
    for assets in root.findall("asset"):
        for element in assets:
            if element.tag in named:
                given = {**_default(defaults, element, None), **element.attrib}
                name = given.get("name") or Path(given.get("file", "").replace("\\", "/")).stem
                named[element.tag][name] = given
    return Mjcf(
        path,
        root,
        bodies,
        named["mesh"],
        named["texture"],
        named["material"],
        compiler,
        references,
    )


def read_mjcf_model(path: Path, references: References) -> Scan:
    """The one object of an MJCF file, in the frame of its body (where it lies in the world is not
    its own), its joints at 0. Raises AssetError."""
    shown = references.shown(path)
    model = read_mjcf(path, references)
    drawn = _drawn(model.bodies)
    root = _root_of([body for body, _ in drawn])
    pieces: list[Piece] = []
    joints: dict[str, ScanJoint] = {}
    try:
        for body, geom in drawn:
            mover = _mover(body, root)
            link = "body" if mover is None else mover.name
            if mover is not None:
                joints[link] = mover
            pieces += model.pieces_of(geom, link)
    except ValueError as error:
        raise AssetError([f"{shown}: {error}"]) from None
    if not pieces:
        raise AssetError([f"{shown}: nothing of it is drawn"])
    mass = sum(body.mass_kg or 0.0 for body in model.bodies)
    scan = Scan(
        tuple(pieces),
        up="z",
        joints=tuple(joints.values()),
        mass_kg=mass or None,
        words=(model.root.get("model", ""),),
    )
    return scan if root is None else scan.moved(inverse(root.at))


def _drawn(bodies: Sequence[Body]) -> list[tuple[Body, Geom]]:
    """What viewers show: groups 0 to 2; of these what nothing bumps into, where there is any."""
    out = [
        (body, geom)
        for body in bodies
        for geom in body.geoms
        if geom.given.get("type") not in ("plane", "hfield")
    ]
    out = [pair for pair in out if pair[1].group <= 2] or out
    out = [pair for pair in out if not pair[1].met] or out
    once: dict[tuple[str, ...], tuple[Body, Geom]] = {}
    for body, geom in out:  # some draw one mesh twice, in two groups
        key = [geom.given.get(name, "") for name in ("type", "mesh", "size", "fromto")]
        once.setdefault((body.name, *key, repr(np.round(geom.at, 6).tolist())), (body, geom))
    return list(once.values())


def _root_of(bodies: Sequence[Body]) -> Body | None:
    """The body that all these hang on, or are; None for the world."""
    for body in bodies[:1]:
        for one in (body, *body.ancestors()):
            if one.parent is not None and all(
                other is one or one in other.ancestors() for other in bodies
            ):
                return one
    return None


def _mover(body: Body, root: Body | None) -> ScanJoint | None:
    """The joint nearest the root body of an object that moves a body against it."""
    chain = [body, *body.ancestors()][::-1]
    for one in chain if root is None else chain[chain.index(root) + 1 :]:
        for given in one.joints:
            kind = given.get("type", "hinge")
            if kind not in ("hinge", "slide"):
                continue
            axis = np.array(_numbers(given.get("axis", "0 0 1"), 3))
            if np.linalg.norm(axis) < 1e-9:
                raise ValueError(f"joint {given.get('name')!r}: its axis has no direction")
            limits = _numbers(given.get("range", "0 0"), 2)
            if limits == (0.0, 0.0):
                limits = (0.0, math.pi / 2 if kind == "hinge" else 0.0)
            at = one.at
            return ScanJoint(
                given.get("name") or f"{one.name}_joint",
                "revolute" if kind == "hinge" else "prismatic",
                at[:3, :3] @ np.array(_numbers(given.get("pos", "0 0 0"), 3)) + at[:3, 3],
                at[:3, :3] @ (axis / np.linalg.norm(axis)),
                *limits,
            )
    return None


def _with_includes(
    path: Path, references: References, above: tuple[Path, ...], count: list[int]
) -> Element:
    shown = references.shown(path)
    if path in above:
        raise AssetError([f"{shown}: includes itself"])
    if len(above) >= _MOST_DEEP or count[0] > _MOST_INCLUDES:
        raise AssetError([f"{shown}: includes too many files"])
    count[0] += 1
    root = parse_xml(references.bytes_of(path), shown)
    for parent in list(root.iter()):
        for index, child in reversed(list(enumerate(parent))):
            if child.tag != "include":
                continue
            name = child.get("file", "")
            # Relative to the main file, as MuJoCo has it.
            base = (above[0] if above else path).parent
            found = references.find(base, name) or references.find(path.parent, name)
            if found is None:
                raise AssetError([f"{shown}: include {name!r}: no such file in the folder"])
            inner = _with_includes(found, references, (*above, path), count)
            parent.remove(child)
            for offset, element in enumerate(inner):
                parent.insert(index + offset, element)
    return root


Defaults = dict[str, dict[str, dict[str, str]]]


def _defaults(root: Element) -> Defaults:
    """class -> tag -> attributes, what the class above says included."""
    out: Defaults = {"main": {}}

    def collect(element: Element, name: str, inherited: dict[str, dict[str, str]]) -> None:
        own = {tag: dict(given) for tag, given in inherited.items()}
        for child in element:
            if child.tag != "default":
                own[child.tag] = {**own.get(child.tag, {}), **child.attrib}
        out[name] = {**out.get(name, {}), **own}
        for child in element.findall("default"):
            collect(child, child.get("class", ""), own)

    for element in root.findall("default"):
        collect(element, element.get("class", "main"), out["main"])
    return out


def _default(defaults: Defaults, element: Element, childclass: str | None) -> dict[str, str]:
    name = element.get("class") or childclass or "main"
    return defaults.get(name, defaults["main"]).get(element.tag, {})


def _bodies(root: Element, compiler: Attributes, defaults: Defaults) -> Iterator[Body]:
    frame = _Frame(compiler)

    def walk(
        element: Element, parent: Body | None, at: Array, childclass: str | None
    ) -> Iterator[Body]:
        childclass = element.get("childclass", childclass)
        joints, geoms, inner = [], [], []

        def look(container: Element, here: Array, inherited: str | None) -> None:
            for child in container:
                given = {**_default(defaults, child, inherited), **child.attrib}
                if child.tag == "joint":
                    joints.append(frame.joint(given))
                elif child.tag == "geom":
                    geoms.append(Geom(given, here @ frame.pose(given)))
                elif child.tag == "frame":
                    look(child, here @ frame.pose(given), child.get("childclass", inherited))
                elif child.tag == "body":
                    inner.append((child, here, inherited))

        look(element, at, childclass)
        inertial = element.find("inertial")
        masses = [float(g.given["mass"]) for g in geoms if "mass" in g.given]
        mass = float(inertial.get("mass", "0")) if inertial is not None else sum(masses)
        name = element.get("name", element.tag)
        body = Body(name, parent, at, tuple(joints), tuple(geoms), mass or None, element)
        yield body
        for child, here, inherited in inner:
            yield from walk(child, body, here @ frame.pose(child.attrib), inherited)

    for world in root.findall("worldbody"):
        yield from walk(world, None, np.eye(4), None)


class _Frame:
    """Positions and rotations as the compiler's options say."""

    def __init__(self, compiler: Attributes) -> None:
        self._turn = 1.0 if compiler.get("angle", "degree") == "radian" else math.pi / 180
        self._order = compiler.get("eulerseq", "xyz")
        if len(self._order) != 3 or set(self._order.lower()) - set("xyz"):
            raise ValueError(f"eulerseq {self._order!r}: expected three of x, y, z, X, Y, Z")

    def pose(self, given: Attributes) -> Array:
        """4x4 of pos and whichever way a rotation is written."""
        at = _numbers(given.get("pos", "0 0 0"), 3)
        return shapes.pose(at, self._rotation(given))

    def joint(self, given: Attributes) -> dict[str, str]:
        """A joint's attributes, its range in radians."""
        out = dict(given)
        if out.get("type", "hinge") == "hinge" and "range" in out:
            out["range"] = " ".join(str(v * self._turn) for v in _numbers(out["range"], 2))
        return out

    def _rotation(self, given: Attributes) -> Array:
        if "quat" in given:
            w, x, y, z = _numbers(given["quat"], 4)
            length = math.sqrt(w * w + x * x + y * y + z * z)
            if length < 1e-9:
                raise ValueError("quat: is nought")
            return rotation_matrix([x / length, y / length, z / length, w / length])
        if "euler" in given:
            angles = [v * self._turn for v in _numbers(given["euler"], 3)]
            return shapes.euler(angles, self._order)
        if "axisangle" in given:
            *axis, angle = _numbers(given["axisangle"], 4)
            unit = np.array(axis) / max(float(np.linalg.norm(axis)), 1e-12)
            half = angle * self._turn / 2
            return rotation_matrix([*(unit * math.sin(half)), math.cos(half)])
        if "xyaxes" in given:
            values = np.array(_numbers(given["xyaxes"], 6))
            x = values[:3] / np.linalg.norm(values[:3])
            y = values[3:] - x * (x @ values[3:])
            y /= np.linalg.norm(y)
            return np.column_stack([x, y, np.cross(x, y)])
        if "zaxis" in given:
            return shapes.from_to((0, 0, 0), _numbers(given["zaxis"], 3))[0][:3, :3]
        return np.eye(3)


def _shape(kind: str, sizes: Sequence[float], paint: Paint | None) -> Piece | None:
    bare = paint if paint is not None else Paint(colour=_GREY)
    if kind == "box":
        return shapes.box([2 * v for v in sizes[:3]], bare)
    if kind == "sphere":
        return shapes.sphere(sizes[0], bare)
    if kind in ("cylinder", "capsule") and len(sizes) > 1:
        made = shapes.cylinder if kind == "cylinder" else shapes.capsule
        return made(sizes[0], 2 * sizes[1], bare)
    if kind == "ellipsoid":
        return shapes.ellipsoid(sizes[:3], bare)
    return None


def _rgba(text: str) -> tuple[float, float, float, float]:
    r, g, b, a = _numbers(text, 4)
    return (r, g, b, a)


def _numbers(text: str, count: int | None = None) -> tuple[float, ...]:
    try:
        values = tuple(float(word) for word in text.split())
    except ValueError:
        raise ValueError(f"{text!r}: expected numbers") from None
    if count is not None and len(values) != count:
        raise ValueError(f"{text!r}: expected {count} numbers")
    if not values or not all(map(math.isfinite, values)):
        raise ValueError(f"{text!r}: expected numbers")
    return values
