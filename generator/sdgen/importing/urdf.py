"""Reads URDF models: links of meshes and plain shapes, and the joints of doors and drawers.

The up axis is the reader's (ROS has Z up, Habitat Y up).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from xml.etree.ElementTree import Element

import numpy as np

from sdgen.errors import AssetError
from sdgen.geometry import Z_UP_FROM_Y_UP, Array
from sdgen.importing import shapes
from sdgen.importing.mesh_files import MESHES, read_mesh
from sdgen.importing.pictures import picture_of
from sdgen.importing.scan import Box, LinkBox, Paint, Piece, Scan, ScanJoint, Up
from sdgen.importing.tree import References
from sdgen.importing.urdf_tree import UrdfTree, name_in, numbers, origin, urdf_tree
from sdgen.importing.xml_text import parse_xml

_MOVES = {"revolute": "revolute", "continuous": "revolute", "prismatic": "prismatic"}


def read_urdf(
    path: Path, references: References, up: Up = "z", boxes: Sequence[LinkBox] = ()
) -> Scan:
    """The model of a URDF file, its joints at 0, with the receptacle ``boxes`` of its links that
    nothing moves. Raises AssetError, located."""
    shown = references.shown(path)
    root = parse_xml(references.bytes_of(path), shown)
    try:
        return _scan(urdf_tree(root), path, references, up, boxes)
    except ValueError as error:
        raise AssetError([f"{shown}: {error}"]) from None


def _scan(
    tree: UrdfTree, path: Path, references: References, up: Up, boxes: Sequence[LinkBox]
) -> Scan:
    paints: dict[str, Paint] = {}
    for material in tree.root.findall("material"):
        paint = _paint(material, {}, path, references)
        if paint is not None:
            paints[material.get("name", "")] = paint
    pieces: list[Piece] = []
    receptacles: list[Box] = []
    moving: list[ScanJoint] = []
    mass = 0.0
    for name, link in tree.links.items():
        at_link, mover = _placed(tree.chain(name), references)
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
            at = at_link @ origin(visual)
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
        words=(tree.root.get("name", ""),),
    )


def _placed(chain: Sequence[Element], references: References) -> tuple[Array, ScanJoint | None]:
    """Where the link at the end of a chain of joints is with all of them at 0, and the joint
    nearest the root that moves it."""
    at = np.eye(4)
    mover: ScanJoint | None = None
    for joint in chain:
        at = at @ origin(joint)
        kind = _MOVES.get(joint.get("type", "fixed"))
        if kind is None:
            continue
        if mover is not None:
            references.note(f"joint {joint.get('name')!r} moves on another joint: taken as fixed")
            continue
        axis = joint.find("axis")
        direction = np.array(numbers(axis, "xyz", (1.0, 0.0, 0.0)))
        if np.linalg.norm(direction) < 1e-9:
            raise ValueError(f"joint {joint.get('name')!r}: its axis has no direction")
        limit = joint.find("limit")
        (lower,), (upper,) = (numbers(limit, key, (0.0,)) for key in ("lower", "upper"))
        if joint.get("type") == "continuous":
            lower, upper = 0.0, math.pi / 2
        mover = ScanJoint(
            joint.get("name") or name_in(joint.find("child"), "link"),
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
        scale = np.diag([*numbers(shape, "scale", (1.0, 1.0, 1.0)), 1.0])
        if file.suffix.lower() == ".dae" and up == "y":
            scale = scale @ Z_UP_FROM_Y_UP  # assimp, which ROS reads meshes with, turns these
        out = [piece.moved(scale) for piece in pieces]
        if paint is not None and all(piece.paint.image is None for piece in out):
            out = [replace(piece, paint=paint) for piece in out]
        return out
    if shape.tag == "box":
        return [shapes.box(numbers(shape, "size", (0.0, 0.0, 0.0)), bare)]
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
            return Paint(picture_of(references.bytes_of(file), references.shown(file)))
    colour = material.find("color")
    if colour is not None:
        r, g, b = numbers(colour, "rgba", (0.7, 0.7, 0.7, 1.0))[:3]
        return Paint(colour=(r, g, b, 1.0))
    return known.get(material.get("name", ""))
