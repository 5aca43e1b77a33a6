"""Reads mesh files of strangers: OBJ, STL, PLY, GLB, glTF, DAE; by trimesh, within bounds.

trimesh follows references through a resolver: ours looks them up in the source's folder alone. It
drops without a word what it cannot read, so what is missing afterwards is noted here.
"""

from __future__ import annotations

import io
import json
import math
from collections.abc import Iterator, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any, cast

import numpy as np

from sdgen.errors import AssetError
from sdgen.geometry import Array
from sdgen.importing.collada_text import prepared
from sdgen.importing.pictures import PICTURES, bounded, checked_picture, picture_of
from sdgen.importing.scan import Paint, Piece, Up
from sdgen.importing.tree import References, files_below, inside
from sdgen.library.gltf import chunks_of, glb_of

#: Suffix of a mesh file -> which axis its format has up.
MESHES: Mapping[str, Up] = {
    ".obj": "unknown",
    ".stl": "unknown",
    ".ply": "unknown",
    ".glb": "y",
    ".gltf": "y",
    ".dae": "unknown",
}
#: Triangles of one file; scans of Fantastic Breaks have up to 2.5 million.
MAX_FACES = 4_000_000
#: Zeros of one accessor of glTF that has no bytes: sparse ones change some of them.
_MAX_ZEROS = 1_000_000
#: What a picture beside a mesh without a material is called.
_PICTURE_STEMS = ("texture", "texture_map", "diffuse", "albedo", "basecolor", "color")


def read_mesh(path: Path, references: References) -> tuple[tuple[Piece, ...], Up]:
    """Pieces of a mesh file in its own axes, metres where the format says so, and its up axis.

    Raises AssetError, located, for what is no mesh, has no triangles, or goes beyond the bounds.
    """
    kind = path.suffix.lower()
    shown = references.shown(path)
    raw = references.bytes_of(path)
    up = MESHES[kind]
    transforms: Mapping[str, Any] = {}
    textured: frozenset[str] = frozenset()
    scale = 1.0
    try:
        if kind in (".glb", ".gltf"):
            raw, transforms, textured = _named_materials(raw, kind)
        elif kind == ".dae":
            raw, scale, up = prepared(raw, shown, references)
        scene = _load(raw, kind, path, references)
        pieces = tuple(_pieces(scene, transforms, scale, shown))
        for name in _without_picture(scene, textured):
            references.note(f"{shown}: the picture of its {name} cannot be read: left out")
    except AssetError:
        raise
    except ModuleNotFoundError as error:
        text = f"{shown}: reading {kind} needs {error.name}: pip install 'sdgen[assets]'"
        raise AssetError([text]) from None
    except MemoryError:
        raise AssetError([f"{shown}: too large for this machine's memory"]) from None
    except RecursionError:
        raise AssetError([f"{shown}: nested too deeply"]) from None
    except Exception as error:  # whatever parsers meet in a broken file
        reason = " ".join(str(error).split())[:200] or type(error).__name__
        raise AssetError([f"{shown}: cannot be read ({reason})"]) from None
    if not pieces:
        raise AssetError([f"{shown}: holds no triangles"])
    _check(pieces, shown)
    if all(piece.paint.image is None for piece in pieces):
        pieces = _with_picture_beside(pieces, path, references)
    return pieces, up


def _load(raw: bytes, kind: str, path: Path, references: References) -> Any:
    import trimesh

    # Only what can be drawn: a cloud of points is no mesh, and numbers may be beyond all bounds.
    with np.errstate(all="ignore"):
        return trimesh.load_scene(
            io.BytesIO(raw),
            file_type=kind[1:],
            resolver=cast(Any, _Resolver(path.parent, references)),
            process=False,
        )


def _pieces(scene: Any, transforms: Mapping[str, Any], scale: float, shown: str) -> Iterator[Piece]:
    import trimesh

    total = 0
    pictures: dict[int, Any] = {}
    for node in scene.graph.nodes_geometry:
        matrix, name = scene.graph[node]
        mesh = scene.geometry[name]
        if not isinstance(mesh, trimesh.Trimesh) or len(mesh.faces) == 0:
            continue
        total += len(mesh.faces)
        if total > MAX_FACES:
            raise ValueError(f"{total} triangles and more, at most {MAX_FACES}")
        turned = np.array(matrix, dtype=np.float64)
        turned[:3] *= scale
        vertices = np.asarray(mesh.vertices, dtype=np.float64)
        faces = np.asarray(mesh.faces, dtype=np.int64)
        if faces.min() < 0 or faces.max() >= len(vertices):
            raise ValueError("a face names a corner that is not there")
        uvs, colours, paint = _looks(mesh, transforms)
        if paint.image is not None:
            # One for all pieces that it is on; the key is the one that the scene holds.
            if id(paint.image) not in pictures:
                pictures[id(paint.image)] = bounded(paint.image, shown)
            paint = replace(paint, image=pictures[id(paint.image)])
        yield Piece(vertices, faces, uvs, colours, paint).moved(turned)


def _looks(mesh: Any, transforms: Mapping[str, Any]) -> tuple[Array | None, Array | None, Paint]:
    """Texture coordinates, colours of vertices and paint of a trimesh mesh."""
    visual = mesh.visual
    if visual.kind == "vertex":
        return None, np.asarray(visual.vertex_colors[:, :3], dtype=np.float64) / 255.0, Paint()
    if visual.kind == "face":
        average = np.asarray(visual.face_colors, dtype=np.float64).mean(axis=0) / 255.0
        return None, None, Paint(colour=_rgba(average))
    material = getattr(visual, "material", None)
    if material is None:
        return None, None, Paint(colour=(0.7, 0.7, 0.7, 1.0))
    image = getattr(material, "baseColorTexture", None)
    colour = getattr(material, "baseColorFactor", None)
    if image is None and hasattr(material, "image"):
        image = material.image
        if image is not None and max(image.size) <= 2:
            image = None  # made up by trimesh where a material is missing
        colour = None if image is not None else getattr(material, "diffuse", None)
    uvs = None if visual.uv is None else np.asarray(visual.uv, dtype=np.float64)
    if uvs is not None and (uvs.ndim != 2 or len(uvs) != len(mesh.vertices) or uvs.shape[1] < 2):
        uvs = None
    if uvs is not None:
        uvs = np.where(np.isfinite(uvs[:, :2]), uvs[:, :2], 0.0)
    uv = transforms.get(str(getattr(material, "name", "")))
    if uvs is None:
        image = None
    return uvs, None, Paint(image, _rgba(colour), uv)


def _rgba(colour: Any) -> tuple[float, float, float, float]:
    if colour is None:
        return (1.0, 1.0, 1.0, 1.0)
    values = np.ravel(np.asarray(colour))
    if values.dtype.kind in "ui" or values.max(initial=0.0) > 1.001:
        values = values / 255.0
    padded = np.append(values.astype(np.float64), [1.0] * max(0, 4 - len(values)))[:4]
    r, g, b, a = (float(v) for v in np.clip(np.nan_to_num(padded, nan=0.7), 0.0, 1.0))
    return (r, g, b, a)


def _check(pieces: tuple[Piece, ...], shown: str) -> None:
    for piece in pieces:
        used = piece.vertices[np.unique(piece.faces)]
        if not np.isfinite(used).all():
            raise AssetError([f"{shown}: some vertices are no numbers (NaN or infinite)"])
        if np.abs(used).max() > 1e7:
            raise AssetError([f"{shown}: vertices lie {np.abs(used).max():.2g} units out"])


def _with_picture_beside(
    pieces: tuple[Piece, ...], path: Path, references: References
) -> tuple[Piece, ...]:
    """The pieces with the picture that lies beside a mesh whose material is missing."""
    if not any(piece.uvs is not None for piece in pieces):
        return pieces
    stems = (path.stem.casefold(), *_PICTURE_STEMS)
    near = [
        file
        for file in files_below(references.folder)
        if file.suffix.lower() in PICTURES
        and file.stem.casefold() in stems
        and inside(references.root, file)
    ]
    near.sort(key=lambda f: (stems.index(f.stem.casefold()), f.as_posix()))
    if not near:
        return pieces
    shown = references.shown(near[0])
    image = picture_of(references.bytes_of(near[0]), shown)
    references.note(f"{shown}: taken as the texture, no material names it")
    return tuple(
        replace(piece, paint=Paint(image)) if piece.uvs is not None else piece for piece in pieces
    )


class _Resolver:
    """What trimesh asks for the files that a mesh names."""

    def __init__(self, base: Path, references: References) -> None:
        self._base = base
        self._references = references

    def get(self, name: str) -> bytes:
        """Bytes of a file by the name a mesh gives it. Raises ValueError for what is not there."""
        found = self._references.find(self._base, name)
        if found is None:
            self._references.note(f"{name.strip()}: named, but not there")
            raise ValueError(f"{name.strip()}: no such file")
        data = self._references.bytes_of(found)
        if found.suffix.lower() in PICTURES:
            try:
                checked_picture(data, self._references.shown(found))
            except AssetError as error:
                self._references.note(error.problems[0])
                raise ValueError(error.problems[0]) from None
        return data

    def __getitem__(self, name: str) -> bytes:
        return self.get(name)

    def keys(self) -> list[str]:
        """Nothing is listed: meshes name what they need."""
        return []

    def namespaced(self, namespace: str) -> _Resolver:
        """A resolver for a folder below."""
        return _Resolver(self._base / namespace, self._references)

    def write(self, name: str, data: bytes) -> None:
        """Nothing is written."""
        raise ValueError(f"{name}: nothing is written into a source")


def _without_picture(scene: Any, textured: frozenset[str]) -> list[str]:
    """Names of materials that should have a picture, of which trimesh has read none."""
    bare: set[str] = set()
    for mesh in scene.geometry.values():
        material: Any = getattr(getattr(mesh, "visual", None), "material", None)
        if getattr(material, "baseColorTexture", "") is None:
            bare.add(str(material.name))
    return sorted(bare & textured)


def _named_materials(raw: bytes, kind: str) -> tuple[bytes, dict[str, Any], frozenset[str]]:
    """A glTF file whose materials have names of ours, the texture transforms by these names, and
    the names of those that have a picture.

    trimesh tells materials by name only, and leaves out KHR_texture_transform.
    """
    text, blob = chunks_of(raw) if kind == ".glb" else (raw, b"")
    document = json.loads(text)
    if not isinstance(document, dict):
        raise ValueError("its JSON is no object")
    needed = document.get("extensionsRequired") or []
    for name in ("KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_texture_basisu"):
        if name in needed:
            raise ValueError(f"needs {name}: export it uncompressed (gltf-transform, Blender)")
    for index, accessor in enumerate(document.get("accessors") or []):
        # Numbers that no bytes stand for are zeros, as many as it says.
        if "bufferView" not in accessor and not 0 < int(accessor["count"]) <= _MAX_ZEROS:
            raise ValueError(f"accessors: {index}: {accessor['count']} numbers of no buffer")
    transforms: dict[str, Any] = {}
    textured: set[str] = set()
    for index, material in enumerate(document.get("materials") or []):
        if not isinstance(material, dict):
            raise ValueError(f"materials: {index} is no object")
        material["name"] = f"material-{index}"
        texture = (material.get("pbrMetallicRoughness") or {}).get("baseColorTexture") or {}
        found = (texture.get("extensions") or {}).get("KHR_texture_transform")
        if texture:
            textured.add(material["name"])
        if isinstance(found, dict):
            transforms[material["name"]] = _uv_matrix(found)
    if kind == ".glb":
        return glb_of(document, blob), transforms, frozenset(textured)
    return json.dumps(document).encode(), transforms, frozenset(textured)


def _uv_matrix(given: Mapping[str, Any]) -> tuple[tuple[float, ...], ...]:
    """KHR_texture_transform as a matrix of coordinates with v upwards (glTF's runs downwards)."""
    (u, v), (su, sv) = given.get("offset", (0.0, 0.0)), given.get("scale", (1.0, 1.0))
    turn = float(given.get("rotation", 0.0))
    c, s = math.cos(turn), math.sin(turn)
    shift = np.array([[1, 0, u], [0, 1, v], [0, 0, 1.0]])
    rotate = np.array([[c, s, 0], [-s, c, 0], [0, 0, 1.0]])
    flip = np.array([[1, 0, 0], [0, -1, 1], [0, 0, 1.0]])
    matrix = flip @ shift @ rotate @ np.diag([su, sv, 1.0]) @ flip
    return tuple(tuple(float(x) for x in row) for row in matrix)
