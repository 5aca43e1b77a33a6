"""Reads the GLB and hull files of a model into arrays."""

from __future__ import annotations

import io
import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Annotated, Any

import numpy as np
import numpy.typing as npt
from pydantic import BaseModel, ConfigDict, Field, ValidationError

from sdgen.errors import AssetError
from sdgen.geometry import Z_UP_FROM_Y_UP
from sdgen.library.glb import MAX_BYTES, glb_document
from sdgen.library.quantized import lacks_normals, plain_glb
from sdgen.library.raw import file_bytes
from sdgen.library.records import Asset
from sdgen.strict import explain
from sdgen.yaml_source import show_path

Floats = npt.NDArray[np.float64]
Ints = npt.NDArray[np.int64]

#: Left of a piece beyond its part's box: less than checks of penetration see, and enough that the
#: piece of a part without thickness (a leaf, a sheet) is no flat one.
HULL_SLACK_M = 0.002

#: Meshes are quantized, sizes written with four digits: 2 mm is more than both, less than any eye.
EXTENTS_SLACK_M = 0.002

#: glTF is Y up; our objects are Z up.
_OURS_FROM_GLTF = Z_UP_FROM_Y_UP[:3, :3]


@dataclass(frozen=True)
class MeshData:
    """A part's triangles in the object's frame, metres, Z up.

    ``vertices`` and ``normals`` (N, 3), ``uvs`` (N, 2) with v upwards, ``faces`` (M, 3).
    """

    vertices: Floats
    normals: Floats
    uvs: Floats
    faces: Ints

    @cached_property
    def bounds_m(self) -> Floats:
        """Lowest and highest corner of the part's box, (2, 3)."""
        return np.array([self.vertices.min(axis=0), self.vertices.max(axis=0)])


@dataclass(frozen=True)
class Hull:
    """A convex collision piece of a part: the hull of ``vertices_m`` (N, 3).

    ``complete`` says that the part's pieces are to be taken as they are.
    """

    part: str
    vertices_m: Floats
    complete: bool = False


class _Piece(BaseModel):
    model_config = ConfigDict(strict=True)
    part: str
    vertices_m: list[Annotated[list[float], Field(min_length=3, max_length=3)]]
    complete: bool = False


class _Pieces(BaseModel):
    model_config = ConfigDict(strict=True)
    pieces: list[_Piece]


def read_glb(path: Path, asset: Asset, raw: bytes | None = None) -> dict[str, MeshData]:
    """Meshes of all parts by name; ``raw`` are the file's bytes where they are known.

    Raises AssetError for a missing or broken file.
    """
    import trimesh

    raw = file_bytes(path, MAX_BYTES) if raw is None else raw
    unreadable = f"{path}: mesh of {asset.id} cannot be read"
    try:
        document = glb_document(raw)
    except ValueError as error:
        raise AssetError([f"{unreadable}: {error}"]) from None
    try:
        # Scales may be beyond all numbers: what comes of them is judged below.
        with np.errstate(all="ignore"):
            # Without normals trimesh asks scipy for them, and prints tracebacks where none is.
            plain = io.BytesIO(plain_glb(raw, document))
            scene = trimesh.load_scene(plain, file_type="glb", process=False)
            found = _by_node(scene, lacks_normals(document))
    except ModuleNotFoundError:
        raise
    except Exception as error:  # trimesh raises whatever its parsers meet in a broken file
        reason = " ".join(str(error).split())[:200] or type(error).__name__
        text = f"{unreadable}: not a valid GLB of triangles ({reason})"
        raise AssetError([text]) from None
    problems = []
    for part in asset.parts:
        data = found.get(part.name)
        if data is None:
            problems.append(f"{path}: {asset.id}: the mesh has no node {part.name!r}")
            continue
        numbers = (data.vertices, data.normals, data.uvs)
        if len(data.faces) == 0 or not all(np.isfinite(array).all() for array in numbers):
            problems.append(f"{path}: {asset.id}: part {part.name!r} is empty or not finite")
        elif data.faces.min() < 0 or data.faces.max() >= len(data.vertices):
            problems.append(f"{path}: {asset.id}: part {part.name!r} has faces without vertices")
        elif len(data.faces) != part.faces:
            problems.append(
                f"{path}: {asset.id}: part {part.name!r} has {len(data.faces)} faces, "
                f"the manifest says {part.faces}"
            )
    if problems:
        raise AssetError(problems)
    return {part.name: found[part.name] for part in asset.parts}


def _by_node(scene: Any, bare: bool) -> dict[str, MeshData]:
    """The meshes of a trimesh scene by the names of their nodes; ``bare`` ones lack normals."""
    found: dict[str, MeshData] = {}
    for node in scene.graph.nodes_geometry:
        transform, geometry = scene.graph[node]
        mesh = scene.geometry[geometry]
        rotation = _OURS_FROM_GLTF @ transform[:3, :3]
        uvs = getattr(mesh.visual, "uv", None)
        count = len(mesh.vertices)
        vertices = mesh.vertices @ rotation.T + _OURS_FROM_GLTF @ transform[:3, 3]
        faces = np.asarray(mesh.faces, dtype=np.int64)
        found[str(node)] = MeshData(
            vertices=vertices,
            normals=_smooth(vertices, faces) if bare else _unit(mesh.vertex_normals @ rotation.T),
            uvs=np.zeros((count, 2)) if uvs is None else np.asarray(uvs, dtype=np.float64),
            faces=faces,
        )
    return found


def read_hulls(path: Path, asset: Asset, raw: bytes | None = None) -> tuple[Hull, ...]:
    """Convex pieces of a model; ``raw`` are the file's bytes where they are known.

    Raises AssetError for a missing or broken file.
    """
    raw = file_bytes(path, MAX_BYTES) if raw is None else raw
    try:
        hulls = tuple(
            Hull(piece.part, np.array(piece.vertices_m, dtype=np.float64), piece.complete)
            for piece in _pieces(raw)
        )
    except ValueError as error:
        raise AssetError([f"{path}: hulls of {asset.id} cannot be read: {error}"]) from None
    if not hulls:
        raise AssetError([f"{path}: {asset.id}: no piece: things would fall through it"])
    parts = {part.name for part in asset.parts}
    for hull in hulls:
        shape = hull.vertices_m.shape
        if (
            len(shape) != 2
            or shape[1] != 3
            or shape[0] < 4
            or not np.isfinite(hull.vertices_m).all()
        ):
            raise AssetError([f"{path}: {asset.id}: a piece needs four points of three numbers"])
        if np.linalg.matrix_rank(hull.vertices_m - hull.vertices_m[0], tol=1e-6) < 3:
            raise AssetError([f"{path}: {asset.id}: a piece is flat"])
        if hull.part not in parts:
            raise AssetError([f"{path}: {asset.id}: a piece names no part: {hull.part!r}"])
    return hulls


def _pieces(raw: bytes) -> list[_Piece]:
    """What a hulls file lists. Raises ValueError that says what is wrong."""
    try:
        data = json.loads(raw)
        return _Pieces.model_validate(data).pieces
    except ValidationError as error:
        path, text = next(explain(error, _Pieces, data))
        raise ValueError(f"{show_path(path)}: {text}" if path else text) from None
    except UnicodeDecodeError:
        raise ValueError("not UTF-8 text") from None
    except json.JSONDecodeError as error:
        raise ValueError(f"not JSON: {error.msg} (line {error.lineno})") from None
    except RecursionError:
        raise ValueError("nested too deeply") from None


def within_meshes(
    hulls: Sequence[Hull], meshes: Mapping[str, MeshData], asset: Asset
) -> tuple[Hull, ...]:
    """The pieces cut back to the box of the parts that move with theirs, all but ``HULL_SLACK_M``.

    Boxes around tilted backs and splayed legs stick out of the model by up to 6 cm, where nothing
    is drawn: furniture cut into walls and floors there that nobody could see. The parts of one
    joint count together, since a piece may stand for those of several variants.
    """
    joint_of = {part.name: part.joint for part in asset.parts}
    out = []
    for hull in hulls:
        moves = joint_of[hull.part]
        vertices = np.concatenate([meshes[k].vertices for k, v in joint_of.items() if v == moves])
        low, high = vertices.min(axis=0) - HULL_SLACK_M, vertices.max(axis=0) + HULL_SLACK_M
        out.append(Hull(hull.part, np.clip(hull.vertices_m, low, high), hull.complete))
    return tuple(out)


def check_extents(path: Path, asset: Asset, meshes: Mapping[str, MeshData]) -> None:
    """Raise AssetError where the default variant is not as large as its record says."""
    points = np.concatenate([meshes[part].vertices for part in asset.variants["default"]])
    measured = points.max(axis=0) - points.min(axis=0)
    if np.abs(measured - np.array(asset.extents_m)).max() <= EXTENTS_SLACK_M:
        return
    text = f"the mesh measures {_metres(measured)}, extents_m says {_metres(asset.extents_m)}"
    if np.abs(measured[[0, 2, 1]] - np.array(asset.extents_m)).max() <= EXTENTS_SLACK_M:
        text += "; it lies on its side: GLB files are read Y up, as glTF has it, not Z up"
    raise AssetError([f"{path}: {asset.id}: {text}"])


def _metres(values: Sequence[float] | Floats) -> str:
    return " x ".join(f"{float(v):.3f}" for v in values) + " m"


def _smooth(vertices: Floats, faces: Ints) -> Floats:
    """Normals of vertices: of the faces around each, the larger the more they count."""
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    normals = np.zeros_like(vertices)
    for k in range(3):
        np.add.at(normals, faces[:, k], np.cross(b - a, c - a))
    return _unit(normals)


def _unit(vectors: Floats) -> Floats:
    """Rows made unit (a node's scale stretches normals, too)."""
    length = np.linalg.norm(vectors, axis=1, keepdims=True)
    return np.asarray(vectors / np.where(length > 1e-12, length, 1.0), dtype=np.float64)
