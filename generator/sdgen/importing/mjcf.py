"""Reads a model in MuJoCo XML (MJCF): bodies, joints and what is drawn, metres, Z up.

Of the many elements only those are read that say where something is and how it looks.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from xml.etree.ElementTree import Element

import numpy as np

from sdgen.errors import AssetError
from sdgen.geometry import Array, inverse
from sdgen.importing import shapes
from sdgen.importing.mesh_files import MESHES, read_mesh
from sdgen.importing.mjcf_document import Attributes, MjcfDocument, viewers_show
from sdgen.importing.pictures import picture_of
from sdgen.importing.scan import Paint, Piece, Scan, ScanJoint
from sdgen.importing.tree import References

_GREY = (0.5, 0.5, 0.5, 1.0)
_UNSEEN = ("plane", "hfield")
Colour = tuple[float, float, float, float]


@dataclass(frozen=True, eq=False)
class _Geom:
    """Something drawn or met: its element, its attributes with defaults, where it is (4x4)."""

    element: Element
    given: Attributes
    at: Array

    @property
    def met(self) -> bool:
        """True when something can bump into it."""
        return self.given.get("contype", "1") != "0" or self.given.get("conaffinity", "1") != "0"


@dataclass(frozen=True, eq=False)
class _Body:
    """A body: ``at`` (4x4) its frame in the world, what is in it, joints with their attributes."""

    name: str
    parent: _Body | None
    at: Array
    joints: tuple[tuple[Element, Attributes], ...]
    geoms: tuple[_Geom, ...]
    mass_kg: float

    def ancestors(self) -> Iterator[_Body]:
        """The bodies it hangs on, nearest first."""
        body = self.parent
        while body is not None:
            yield body
            body = body.parent


def read_mjcf_model(path: Path, references: References) -> Scan:
    """The one object of an MJCF file, in the frame of its body (where it lies in the world is not
    its own), its joints at 0. Raises AssetError, with all that is wrong with its elements."""
    document = MjcfDocument(path, references)
    reading = _Reading(document, references)
    bodies = [
        body
        for world in document.root.findall("worldbody")
        for body in reading.bodies(world, None, np.eye(4), None)
    ]
    drawn = _drawn(bodies)
    root = _root_of([body for body, _ in drawn])
    pieces: list[Piece] = []
    joints: dict[str, ScanJoint] = {}
    for body, geom in drawn:
        mover = reading.mover(body, root)
        link = "body" if mover is None else mover.name
        if mover is not None:
            joints[link] = mover
        pieces += (replace(piece, link=link) for piece in reading.pieces(geom))
    document.check()
    for text in document.left_out:
        references.note(f"{text} are not read")
    if not pieces:
        raise AssetError([f"{references.shown(path)}: nothing of it is drawn"])
    scan = Scan(
        tuple(pieces),
        up="z",
        joints=tuple(joints.values()),
        mass_kg=sum(body.mass_kg for body in bodies) or None,
        friction=reading.friction(bodies),
        words=(document.root.get("model", ""),),
    )
    return scan if root is None else scan.moved(inverse(root.at))


class _Reading:
    """What a document's elements are; what is wrong with them is noted there."""

    def __init__(self, document: MjcfDocument, references: References) -> None:
        self._document = document
        self._references = references
        self._meshes = document.assets("mesh")
        self._textures = document.assets("texture")
        self._materials = document.assets("material")

    def friction(self, bodies: Sequence[_Body]) -> float | None:
        """Sliding friction of the first geom that says one."""
        for geom in (geom for body in bodies for geom in body.geoms):
            said = self._document.numbers(geom.element, geom.given, "friction")
            if said:
                return said[0]
        return None

    def bodies(
        self, element: Element, parent: _Body | None, at: Array, childclass: str | None
    ) -> Iterator[_Body]:
        """A body, and all bodies in it."""
        childclass = element.get("childclass", childclass)
        joints, geoms, inner = [], [], []
        for child, here, inherited in self._document.inside(element, at, childclass):
            if child.tag == "body":
                inner.append((child, here, inherited))
            elif child.tag == "joint":
                joints.append((child, self._document.given(child, inherited)))
            elif child.tag == "geom":
                given = self._document.given(child, inherited)
                geoms.append(_Geom(child, given, here @ self._pose(child, given)))
        inertial = element.find("inertial")
        if inertial is not None:
            mass = self._number(inertial, inertial.attrib, "mass")
        else:
            mass = sum(self._number(geom.element, geom.given, "mass") for geom in geoms)
        name = element.get("name", element.tag)
        body = _Body(name, parent, at, tuple(joints), tuple(geoms), mass)
        yield body
        for child, here, inherited in inner:
            yield from self.bodies(child, body, here @ self._pose(child, child.attrib), inherited)

    def mover(self, body: _Body, root: _Body | None) -> ScanJoint | None:
        """The joint nearest the root body of an object that moves a body against it."""
        chain = [body, *body.ancestors()][::-1]
        for one in chain if root is None else chain[chain.index(root) + 1 :]:
            for element, given in one.joints:
                if given.get("type", "hinge") in ("hinge", "slide"):
                    return self._joint(element, given, one)
        return None

    def _joint(self, element: Element, given: Attributes, body: _Body) -> ScanJoint | None:
        hinge = given.get("type", "hinge") == "hinge"
        axis = np.array(self._document.numbers(element, given, "axis", 3) or (0.0, 0.0, 1.0))
        if np.linalg.norm(axis) < 1e-9:
            self._document.problem(element, "its axis has no direction")
            return None
        unit = self._document.angle_rad if hinge else 1.0
        limits = self._document.numbers(element, given, "range", 2) or (0.0, 0.0)
        lower, upper = (value * unit for value in limits)
        if lower == upper == 0.0:
            upper = math.pi / 2 if hinge else 0.0
        place = self._document.numbers(element, given, "pos", 3) or (0.0, 0.0, 0.0)
        return ScanJoint(
            given.get("name") or f"{body.name}_joint",
            "revolute" if hinge else "prismatic",
            body.at[:3, :3] @ place + body.at[:3, 3],
            body.at[:3, :3] @ (axis / np.linalg.norm(axis)),
            lower,
            upper,
        )

    def pieces(self, geom: _Geom) -> list[Piece]:
        """Triangles of a geom in the world."""
        try:
            return list(self._pieces(geom))
        except ValueError as error:
            self._document.problem(geom.element, str(error))
            return []

    def _pieces(self, geom: _Geom) -> Iterator[Piece]:
        paint = self._paint(geom)
        kind = geom.given.get("type", "mesh" if "mesh" in geom.given else "sphere")
        if kind == "mesh":
            for piece in self._mesh(geom.given.get("mesh", "")):
                yield (piece if paint is None else replace(piece, paint=paint)).moved(geom.at)
            return
        at = geom.at
        sizes = self._document.numbers(geom.element, geom.given, "size") or [0.0]
        ends = self._document.numbers(geom.element, geom.given, "fromto", 6)
        if ends is not None:
            between, length = shapes.from_to(ends[:3], ends[3:])
            across = 1 if kind in ("cylinder", "capsule") else 2
            at, sizes = at @ between, [*sizes[:1] * across, length / 2]
        shape = _shape(kind, sizes, Paint(colour=_GREY) if paint is None else paint)
        if shape is not None:
            yield shape.moved(at)

    def _mesh(self, name: str) -> tuple[Piece, ...]:
        element = self._meshes.get(name)
        if element is None:
            raise ValueError(f"mesh {name!r} is not among its assets")
        given = self._document.given(element, None)
        file = self._document.asset_file(given, "meshdir")
        if file is None or file.suffix.lower() not in MESHES:
            raise ValueError(f"mesh {name!r}: {given.get('file', '')}: no such mesh")
        pieces, _ = read_mesh(file, self._references)
        return tuple(piece.moved(self._document.geom_from_mesh(element)) for piece in pieces)

    def _paint(self, geom: _Geom) -> Paint | None:
        """A geom's own paint; None where its mesh has the say."""
        colour = self._colour(geom.element, geom.given)
        material = self._materials.get(geom.given.get("material", ""))
        if material is None:
            return None if colour is None else Paint(colour=colour)
        look = self._document.given(material, None)
        tint = self._colour(material, look) or (1.0, 1.0, 1.0, 1.0)
        texture = self._textures.get(look.get("texture", ""))
        file = None
        if texture is not None:
            given = self._document.given(texture, None)
            file = self._document.asset_file(given, "texturedir")
        if file is None:
            return Paint(colour=colour or tint)
        # A tint below white darkens the picture, as MuJoCo draws it.
        shown = self._references.shown(file)
        return Paint(picture_of(self._references.bytes_of(file), shown), tint)

    def _colour(self, element: Element, given: Attributes) -> Colour | None:
        found = self._document.numbers(element, given, "rgba", 4)
        return None if found is None else (found[0], found[1], found[2], found[3])

    def _number(self, element: Element, given: Attributes, key: str) -> float:
        return (self._document.numbers(element, given, key, 1) or (0.0,))[0]

    def _pose(self, element: Element, given: Attributes) -> Array:
        """Where an element is in its parent (4x4), quarter turns made exact."""
        at = self._document.parent_from(element, given)
        return shapes.pose(at[:3, 3].tolist(), at[:3, :3])


def _drawn(bodies: Sequence[_Body]) -> list[tuple[_Body, _Geom]]:
    """What viewers show; of these what nothing bumps into, where there is any."""
    out = [
        (body, geom)
        for body in bodies
        for geom in body.geoms
        if geom.given.get("type") not in _UNSEEN
    ]
    out = [pair for pair in out if viewers_show(pair[1].given)] or out
    out = [pair for pair in out if not pair[1].met] or out
    once: dict[tuple[str, ...], tuple[_Body, _Geom]] = {}
    for body, geom in out:  # some draw one mesh twice, in two groups
        key = [geom.given.get(name, "") for name in ("type", "mesh", "size", "fromto")]
        once.setdefault((body.name, *key, repr(np.round(geom.at, 6).tolist())), (body, geom))
    return list(once.values())


def _root_of(bodies: Sequence[_Body]) -> _Body | None:
    """The body that all these hang on, or are; None for the world."""
    for body in bodies[:1]:
        for one in (body, *body.ancestors()):
            if one.parent is not None and all(
                other is one or one in other.ancestors() for other in bodies
            ):
                return one
    return None


def _shape(kind: str, sizes: Sequence[float], paint: Paint) -> Piece | None:
    if kind == "box":
        return shapes.box([2 * v for v in sizes[:3]], paint)
    if kind == "sphere":
        return shapes.sphere(sizes[0], paint)
    if kind in ("cylinder", "capsule") and len(sizes) > 1:
        made = shapes.cylinder if kind == "cylinder" else shapes.capsule
        return made(sizes[0], 2 * sizes[1], paint)
    if kind == "ellipsoid":
        return shapes.ellipsoid(sizes[:3], paint)
    return None
