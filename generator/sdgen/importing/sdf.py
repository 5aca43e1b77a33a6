"""Reads SDF models as Gazebo has them: links of meshes and plain shapes, metres, Z up.

http://sdformat.org/spec. Gazebo takes the unit of COLLADA files and ignores their up axis, so
several of its models say Y up and stand upright.
"""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path
from xml.etree.ElementTree import Element

import numpy as np

from sdgen.errors import AssetError
from sdgen.geometry import Array
from sdgen.importing import shapes
from sdgen.importing.mesh_files import MESHES, read_mesh
from sdgen.importing.pictures import picture_of
from sdgen.importing.scan import Paint, Piece, Scan
from sdgen.importing.tree import References, files_below
from sdgen.importing.xml_text import parse_xml

_GREY = (0.7, 0.7, 0.7, 1.0)


def read_sdf(path: Path, references: References) -> Scan:
    """The first model of an SDF file. Raises AssetError, located."""
    shown = references.shown(path)
    root = parse_xml(references.bytes_of(path), shown)
    model = root if root.tag == "model" else root.find(".//model")
    if model is None:
        raise AssetError([f"{shown}: holds no model"])
    pieces: list[Piece] = []
    mass = 0.0
    drawn_by_mesh = False
    try:
        for link in model.findall("link"):
            at_link = _pose(link)
            mass += _number(link.findtext("inertial/mass"), 0.0)
            for visual in link.findall("visual"):
                found, mesh = _visual(visual, path, references)
                drawn_by_mesh |= mesh
                pieces += [piece.moved(at_link @ _pose(visual)) for piece in found]
    except ValueError as error:
        raise AssetError([f"{shown}: {error}"]) from None
    if model.find("joint") is not None:
        references.note("its joints are taken as fixed (SDF)")
    if not drawn_by_mesh and all(piece.paint.image is None for piece in pieces):
        pieces = _visual_mesh_beside(references) or pieces
    if not pieces:
        raise AssetError([f"{shown}: nothing of it is drawn"])
    words = (model.get("name", ""), *fuel_words(path.parent, references))
    mu = model.findtext("link/collision/surface/friction/ode/mu")
    friction = None if mu is None else _number(mu, -1.0)
    return Scan(tuple(pieces), up="z", mass_kg=mass or None, friction=friction, words=words)


def _visual(visual: Element, path: Path, references: References) -> tuple[list[Piece], bool]:
    """Pieces of a visual, and whether they are a mesh's."""
    geometry = visual.find("geometry")
    if geometry is None:
        return [], False
    mesh = geometry.find("mesh")
    if mesh is not None:
        uri = mesh.findtext("uri", "").strip()
        file = references.find(path.parent, uri)
        if file is None or file.suffix.lower() not in MESHES:
            raise ValueError(f"{uri}: no such mesh" if file is None else f"{uri}: is no mesh")
        pieces, _ = read_mesh(file, references)
        scale = _numbers(mesh.findtext("scale"), (1.0, 1.0, 1.0))
        if len(scale) != 3:
            raise ValueError(f"scale: {len(scale)} numbers, expected three")
        paint = _paint(visual, references)
        out = [piece.moved(np.diag([*scale, 1.0])) for piece in pieces]
        if paint is not None and all(piece.paint.image is None for piece in out):
            out = [replace(piece, paint=paint) for piece in out]
        return out, True
    paint = _paint(visual, references) or Paint(colour=_GREY)
    for name in ("box", "cylinder", "sphere", "capsule", "ellipsoid"):
        shape = geometry.find(name)
        if shape is None:
            continue
        radius = _number(shape.findtext("radius"), 0.0)
        length = _number(shape.findtext("length"), 0.0)
        if name == "box":
            return [shapes.box(_numbers(shape.findtext("size"), (0.0, 0.0, 0.0)), paint)], False
        if name == "cylinder":
            return [shapes.cylinder(radius, length, paint)], False
        if name == "capsule":
            return [shapes.capsule(radius, length, paint)], False
        if name == "ellipsoid":
            radii = _numbers(shape.findtext("radii"), (0.0, 0.0, 0.0))
            return [shapes.ellipsoid(radii, paint)], False
        return [shapes.sphere(radius, paint)], False
    return [], False


def _paint(visual: Element, references: References) -> Paint | None:
    """What an SDF material says: a texture of an OGRE script, or its diffuse colour."""
    material = visual.find("material")
    if material is None:
        return None
    albedo = material.findtext(".//albedo_map")
    name = material.findtext("script/name", "").strip()
    picture = references.find(references.folder, albedo) if albedo else None
    picture = picture or (_ogre_texture(name, references) if name else None)
    if picture is not None:
        image = picture_of(references.bytes_of(picture), references.shown(picture))
        return Paint(image)
    diffuse = material.findtext("diffuse")
    if diffuse is None:
        if name:
            references.note(f"material {name!r} is Gazebo's own: drawn grey")
        return Paint(colour=_GREY)
    r, g, b = _numbers(diffuse, (0.7, 0.7, 0.7, 1.0))[:3]
    return Paint(colour=(r, g, b, 1.0))


def _ogre_texture(name: str, references: References) -> Path | None:
    """The picture that a material of the model's OGRE scripts shows."""
    for file in files_below(references.folder):
        if file.suffix.lower() != ".material":
            continue
        text = references.bytes_of(file, 1_000_000).decode("utf-8", "replace")
        start = re.search(rf"material\s+{re.escape(name)}\b", text)
        found = re.search(r"\btexture\s+(\S+)", text[start.start() :]) if start else None
        if found:
            return references.find(file.parent, found.group(1))
    return None


def _visual_mesh_beside(references: References) -> list[Piece]:
    """The mesh that a model's folder has for its looks, where the wrapper draws bare shapes."""
    files = [
        file
        for file in files_below(references.folder)
        if file.suffix.lower() in MESHES and "visual" in file.stem.casefold()
    ]
    if len(files) != 1:
        return []
    pieces, _ = read_mesh(files[0], references)
    references.note(f"{references.shown(files[0])}: taken for the bare shapes that the SDF draws")
    return list(pieces)


def fuel_words(folder: Path, references: References) -> tuple[str, ...]:
    """Name and description of model.config, description and classes of Fuel's metadata.pbtxt."""
    out: list[str] = []
    config = folder / "model.config"
    if config.is_file():
        root = parse_xml(references.bytes_of(config, 1_000_000), references.shown(config))
        out += [" ".join(root.findtext(tag, "").split()) for tag in ("name", "description")]
    metadata = folder / "metadata.pbtxt"
    if metadata.is_file():
        text = references.bytes_of(metadata, 1_000_000).decode("utf-8", "replace")
        out += re.findall(
            r"^\s*(?:description|first|second)\s*:\s*\"([^\"]*)\"", text, re.MULTILINE
        )
    return tuple(dict.fromkeys(word for word in out if word))


def _pose(element: Element) -> Array:
    values = _numbers(element.findtext("pose"), (0.0,) * 6)
    if len(values) != 6:
        raise ValueError(f"pose: {len(values)} numbers, not 6")
    return shapes.pose(values[:3], shapes.rpy(values[3:]))


def _number(text: str | None, default: float) -> float:
    return _numbers(text, (default,))[0]


def _numbers(text: str | None, default: tuple[float, ...]) -> tuple[float, ...]:
    if text is None or not text.strip():
        return default
    values = tuple(float(word) for word in text.split())
    if not np.isfinite(values).all():
        raise ValueError(f"{text.strip()!r}: no numbers")
    return values
