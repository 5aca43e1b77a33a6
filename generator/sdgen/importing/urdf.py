"""Reads URDF models: links of meshes and plain shapes, and the joints of doors and drawers.

http://wiki.ros.org/urdf/XML. Metres and radians; the up axis is the reader's (ROS has Z up, Habitat
Y up).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from xml.etree.ElementTree import Element

import numpy as np

from sdgen.errors import AssetError
from sdgen.geometry import Array
from sdgen.importing import shapes
from sdgen.importing.mesh_files import MESHES, read_mesh
from sdgen.importing.pictures import checked_picture
from sdgen.importing.scan import Box, LinkBox, Paint, Piece, Scan, ScanJoint, Up
from sdgen.importing.tree import References
from sdgen.importing.xml_text import parse_xml

_MOVES = {"revolute": "revolute", "continuous": "revolute", "prismatic": "prismatic"}
_Y_UP = np.array([[1.0, 0, 0, 0], [0, 0, -1, 0], [0, 1, 0, 0], [0, 0, 0, 1]])


def read_urdf(
    path: Path, references: References, up: Up = "z", boxes: Sequence[LinkBox] = ()
) -> Scan:
    """The model of a URDF file, its joints at 0, with the receptacle ``boxes`` of its links that
    nothing moves. Raises AssetError, located."""
    shown = references.shown(path)
    root = parse_xml(references.bytes_of(path), shown)
    if root.tag != "robot":
        raise AssetError([f"{shown}: is no URDF: its root is <{root.tag}>"])
    try:
        return _scan(root, path, references, up, boxes)
    except ValueError as error:
        raise AssetError([f"{shown}: {error}"]) from None


def _scan(
    root: Element, path: Path, references: References, up: Up, boxes: Sequence[LinkBox]
) -> Scan:
    links = {link.get("name", ""): link for link in root.findall("link")}
    joints = {_name(joint.find("child"), "link"): joint for joint in root.findall("joint")}
    paints: dict[str, Paint] = {}
    for material in root.findall("material"):
        paint = _paint(material, {}, path, references)
        if paint is not None:
            paints[material.get("name", "")] = paint
    pieces: list[Piece] = []
    receptacles: list[Box] = []
    moving: list[ScanJoint] = []
    mass = 0.0
    for name, link in links.items():
        at_link, mover = _placed(name, joints, references)
        if mover is not None and mover.name not in {joint.name for joint in moving}:
            moving.append(mover)
        its_boxes = [given.box.moved(at_link) for given in boxes if given.link == name]
        if mover is None:
            receptacles += its_boxes
        elif its_boxes:
            references.note(f"receptacle box in {name!r}: not used, for that moves")
        value = link.find("inertial/mass")
        mass += float(value.get("value", 0.0)) if value is not None else 0.0
        for visual in link.findall("visual"):
            at = at_link @ _origin(visual)
            for piece in _visual(visual, paints, path, references):
                mover_name = "body" if mover is None else mover.name
                pieces.append(replace(piece.moved(at), link=mover_name))
    if not pieces:
        raise ValueError("nothing of it is drawn")
    drawn = {piece.link for piece in pieces}
    if "body" not in drawn:  # a leaf alone moves against nothing of its own
        pieces = [replace(piece, link="body") for piece in pieces]
    kept = tuple(joint for joint in moving if joint.name in drawn)
    return Scan(
        tuple(pieces),
        up=up,
        joints=kept if "body" in drawn else (),
        mass_kg=mass if math.isfinite(mass) and mass > 0 else None,
        receptacles=tuple(receptacles),
        words=(root.get("name", ""),),
    )


def _placed(
    link: str, joints: dict[str, Element], references: References
) -> tuple[Array, ScanJoint | None]:
    """Where a link is with all joints at 0, and the joint nearest the root that moves it."""
    chain: list[Element] = []
    seen = {link}
    while link in joints:
        joint = joints[link]
        chain.append(joint)
        link = _name(joint.find("parent"), "link")
        if link in seen:
            raise ValueError(f"joint {joint.get('name')!r}: links go round in a circle")
        seen.add(link)
    at = np.eye(4)
    mover: ScanJoint | None = None
    for joint in reversed(chain):
        at = at @ _origin(joint)
        kind = _MOVES.get(joint.get("type", "fixed"))
        if kind is None:
            continue
        if mover is not None:
            references.note(f"joint {joint.get('name')!r} moves on another joint: taken as fixed")
            continue
        axis = joint.find("axis")
        direction = np.array(_numbers(axis, "xyz", (1.0, 0.0, 0.0)))
        if np.linalg.norm(direction) < 1e-9:
            raise ValueError(f"joint {joint.get('name')!r}: its axis has no direction")
        limit = joint.find("limit")
        lower = float(limit.get("lower", 0.0)) if limit is not None else 0.0
        upper = float(limit.get("upper", 0.0)) if limit is not None else 0.0
        if joint.get("type") == "continuous":
            lower, upper = 0.0, math.pi / 2
        mover = ScanJoint(
            joint.get("name") or link,
            "revolute" if kind == "revolute" else "prismatic",
            at[:3, 3].copy(),
            at[:3, :3] @ (direction / np.linalg.norm(direction)),
            lower,
            upper,
        )
    return at, mover


def _visual(
    visual: Element, paints: dict[str, Paint], path: Path, references: References
) -> list[Piece]:
    paint = _paint(visual.find("material"), paints, path, references)
    geometry = visual.find("geometry")
    shape = next(iter(geometry), None) if geometry is not None else None
    if shape is None:
        return []
    bare = paint if paint is not None else Paint(colour=(0.7, 0.7, 0.7, 1.0))
    if shape.tag == "mesh":
        name = shape.get("filename", "")
        file = references.find(path.parent, name)
        if file is None or file.suffix.lower() not in MESHES:
            raise ValueError(f"{name}: no such mesh" if file is None else f"{name}: is no mesh")
        pieces, up = read_mesh(file, references)
        scale = np.diag([*_numbers(shape, "scale", (1.0, 1.0, 1.0)), 1.0])
        if file.suffix.lower() == ".dae" and up == "y":
            scale = scale @ _Y_UP  # assimp, which ROS reads meshes with, turns these
        out = [piece.moved(scale) for piece in pieces]
        if paint is not None and all(piece.paint.image is None for piece in out):
            out = [replace(piece, paint=paint) for piece in out]
        return out
    if shape.tag == "box":
        return [shapes.box(_numbers(shape, "size", (0.0, 0.0, 0.0)), bare)]
    if shape.tag == "cylinder":
        sizes = float(shape.get("radius", 0)), float(shape.get("length", 0))
        return [shapes.cylinder(*sizes, bare)]
    if shape.tag == "sphere":
        return [shapes.sphere(float(shape.get("radius", 0)), bare)]
    return []


def _paint(
    material: Element | None, known: dict[str, Paint], path: Path, references: References
) -> Paint | None:
    if material is None:
        return None
    texture = material.find("texture")
    if texture is not None:
        file = references.find(path.parent, texture.get("filename", ""))
        if file is not None:
            return Paint(checked_picture(references.bytes_of(file), references.shown(file)))
    colour = material.find("color")
    if colour is not None:
        r, g, b = _numbers(colour, "rgba", (0.7, 0.7, 0.7, 1.0))[:3]
        return Paint(colour=(r, g, b, 1.0))
    return known.get(material.get("name", ""))


def _origin(element: Element) -> Array:
    origin = element.find("origin")
    at = _numbers(origin, "xyz", (0.0, 0.0, 0.0))
    turn = _numbers(origin, "rpy", (0.0, 0.0, 0.0))
    return shapes.pose(at, shapes.rpy(turn))


def _numbers(element: Element | None, key: str, default: tuple[float, ...]) -> tuple[float, ...]:
    text = element.get(key) if element is not None else None
    if text is None or not text.strip():
        return default
    values = tuple(float(word) for word in text.replace(",", " ").split())
    if len(values) != len(default) or not all(map(math.isfinite, values)):
        raise ValueError(f"{key}={text!r}: expected {len(default)} numbers")
    return values


def _name(element: Element | None, key: str) -> str:
    return element.get(key, "") if element is not None else ""
