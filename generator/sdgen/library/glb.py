"""What a GLB says of itself, checked before trimesh follows it: it asserts, or trusts.

Only what is read is looked at: nodes, meshes, accessors and the buffers below them (names and
types are those of glTF 2.0's schema). Everything a model needs must lie in its file.
"""

from __future__ import annotations

import json
from typing import Annotated, Any

import numpy as np
from pydantic import BaseModel, ConfigDict, Field, ValidationError

from sdgen.strict import explain
from sdgen.yaml_source import show_path

#: A model beyond this many vertices would crowd all others out of the renderer's one buffer
#: (3.7 million a scene), which then drops shapes without a word.
MAX_VERTICES = 300_000
#: A closed mesh has twice as many triangles as vertices, of three corners each.
MAX_CORNERS = 6 * MAX_VERTICES
#: A file larger than this holds no model of so many vertices. Nor do all its views together, or
#: its accessors: several may speak of the same bytes, and each is read into arrays of its own.
MAX_BYTES = 200_000_000
#: A node, a mesh and their accessors take 1 kB, and no model has as many as a thousand parts.
MAX_JSON = 2_000_000

#: Types of the two chunks.
JSON, BIN = 0x4E4F534A, 0x004E4942
#: componentType -> NumPy's name of it, type -> components.
COMPONENTS = {5120: "i1", 5121: "u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
WIDTH = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT2": 4, "MAT3": 9, "MAT4": 16}
#: Triangles, and strips of them.
_MODES = (4, 5)
_STRIP = 5
_ATTRIBUTES = {"POSITION": "VEC3", "NORMAL": "VEC3", "TEXCOORD_0": "VEC2"}

Index = Annotated[int, Field(ge=0)]
Number = Annotated[float, Field(allow_inf_nan=False)]


class _Part(BaseModel):
    model_config = ConfigDict(extra="ignore", strict=True, frozen=True)


class _Buffer(_Part):
    byteLength: int = Field(ge=1)
    uri: str | None = None


class _View(_Part):
    buffer: Index
    byteOffset: Index = 0
    byteLength: int = Field(ge=1)
    byteStride: int | None = Field(default=None, ge=1)


class _Accessor(_Part):
    bufferView: Index | None = None
    byteOffset: Index = 0
    componentType: int
    type: str
    count: int = Field(ge=1)
    sparse: Any = None


class _Primitive(_Part):
    attributes: dict[str, Index]
    indices: Index | None = None
    mode: int = 4


class _Mesh(_Part):
    primitives: list[_Primitive]


class _Node(_Part):
    mesh: Index | None = None
    children: list[Index] = []
    matrix: list[Number] | None = Field(default=None, min_length=16, max_length=16)
    translation: list[Number] | None = Field(default=None, min_length=3, max_length=3)
    rotation: list[Number] | None = Field(default=None, min_length=4, max_length=4)
    scale: list[Number] | None = Field(default=None, min_length=3, max_length=3)


class _Scene(_Part):
    nodes: list[Index] = []


class _Document(_Part):
    buffers: list[_Buffer] = []
    bufferViews: list[_View] = []
    accessors: list[_Accessor] = []
    meshes: list[_Mesh] = []
    nodes: list[_Node] = []
    scenes: list[_Scene] = []


def glb_document(raw: bytes) -> dict[str, Any]:
    """The JSON chunk of a GLB, whose frame, accessors and nodes are sound and ask for no more
    memory than a model may have.

    Raises ValueError that says what is wrong.
    """
    if raw[:4] != b"glTF":
        raise ValueError("it is no GLB (binary glTF) file")
    if int.from_bytes(raw[4:8], "little") != 2:
        raise ValueError("it is not of glTF version 2")
    length = int.from_bytes(raw[8:12], "little")
    if length > len(raw):
        raise ValueError(f"it is cut off: {len(raw)} of {length} bytes are there")
    size = int.from_bytes(raw[12:16], "little")
    if int.from_bytes(raw[16:20], "little") != JSON or 20 + size > len(raw):
        raise ValueError("its first chunk is no whole JSON chunk")
    if size > MAX_JSON:
        raise ValueError(f"its JSON chunk has {size} bytes, at most {MAX_JSON}")
    try:
        document = json.loads(raw[20 : 20 + size])
    except (ValueError, RecursionError):
        raise ValueError("its JSON chunk is damaged") from None
    if not isinstance(document, dict):
        raise ValueError("its JSON chunk is damaged")
    try:
        found = _Document.model_validate(document)
    except ValidationError as error:
        path, text = next(explain(error, _Document, document))
        raise ValueError(f"{show_path(path)}: {text}") from None
    _check_buffers(found, len(binary_chunk(raw)))
    _check_accessors(found)
    _check_meshes(found)
    _check_nodes(found)
    _check_sizes(found)
    return document


def binary_chunk(raw: bytes) -> bytes:
    """The second chunk of a GLB, which holds the numbers; empty when there is none.

    Raises ValueError when it is cut off.
    """
    start = 20 + int.from_bytes(raw[12:16], "little")
    size = int.from_bytes(raw[start : start + 4], "little")
    if int.from_bytes(raw[start + 4 : start + 8], "little") != BIN:
        return b""
    if start + 8 + size > len(raw):
        raise ValueError("its binary chunk is cut off")
    return raw[start + 8 : start + 8 + size]


def _check_buffers(found: _Document, there: int) -> None:
    for k, buffer in enumerate(found.buffers):
        if buffer.uri is not None:
            raise ValueError(f"buffers[{k}].uri: another file; all must lie in the GLB")
        if k > 0:
            raise ValueError(f"buffers[{k}]: a GLB has one")
        if buffer.byteLength > there:
            raise ValueError(f"buffers[{k}]: {there} of {buffer.byteLength} bytes are there")


def _check_accessors(found: _Document) -> None:
    for k, view in enumerate(found.bufferViews):
        where = f"bufferViews[{k}]"
        buffer = _at(found.buffers, view.buffer, f"{where}.buffer")
        if view.byteOffset + view.byteLength > buffer.byteLength:
            raise ValueError(f"{where}: reaches beyond its buffer")
    for k, accessor in enumerate(found.accessors):
        where = f"accessors[{k}]"
        if accessor.componentType not in COMPONENTS:
            raise ValueError(f"{where}.componentType: glTF has no {accessor.componentType}")
        if accessor.type not in WIDTH:
            raise ValueError(f"{where}.type: glTF has no {accessor.type[:40]!r}")
        if accessor.sparse is not None or accessor.bufferView is None:
            raise ValueError(f"{where}: sparse or compressed data is not read; write it plain")
        view = _at(found.bufferViews, accessor.bufferView, f"{where}.bufferView")
        item = _item_bytes(accessor)
        stride = view.byteStride or item
        if stride < item:
            raise ValueError(f"{where}: its stride is less than its width")
        if accessor.byteOffset + stride * (accessor.count - 1) + item > view.byteLength:
            raise ValueError(f"{where}: reaches beyond its bufferView")


def _item_bytes(accessor: _Accessor) -> int:
    return np.dtype(COMPONENTS[accessor.componentType]).itemsize * WIDTH[accessor.type]


def _check_meshes(found: _Document) -> None:
    for k, mesh in enumerate(found.meshes):
        for n, primitive in enumerate(mesh.primitives):
            where = f"meshes[{k}].primitives[{n}]"
            if primitive.mode not in _MODES:
                raise ValueError(f"{where}.mode: {primitive.mode} is not triangles (4)")
            if "POSITION" not in primitive.attributes:
                raise ValueError(f"{where}.attributes: no POSITION")
            counts = set()
            for name, index in primitive.attributes.items():
                accessor = _at(found.accessors, index, f"{where}.attributes.{name[:40]}")
                counts.add(accessor.count)
                if accessor.type != _ATTRIBUTES.get(name, accessor.type):
                    raise ValueError(f"{where}.attributes.{name}: not {_ATTRIBUTES[name]}")
            if len(counts) > 1:
                raise ValueError(f"{where}.attributes: not all have as many values")
            if primitive.indices is not None:
                indices = _at(found.accessors, primitive.indices, f"{where}.indices")
                if indices.type != "SCALAR" or indices.componentType not in (5121, 5123, 5125):
                    raise ValueError(f"{where}.indices: not whole numbers from 0")


def _check_nodes(found: _Document) -> None:
    """Nodes are trees: none has two parents, none is below itself."""
    parent: dict[int, int] = {}
    for k, node in enumerate(found.nodes):
        if node.mesh is not None:
            _at(found.meshes, node.mesh, f"nodes[{k}].mesh")
        for child in node.children:
            _at(found.nodes, child, f"nodes[{k}].children")
            if child in parent:
                raise ValueError(f"nodes[{child}]: is a child twice")
            parent[child] = k
    above: set[int] = set()  # nodes known to lead up to a root
    for k in range(len(found.nodes)):
        way: set[int] = set()
        while k not in above:
            if k in way:
                raise ValueError(f"nodes[{k}]: is a child of its own")
            way.add(k)
            if k not in parent:
                break
            k = parent[k]
        above |= way
    for n, scene in enumerate(found.scenes):
        for index in scene.nodes:
            _at(found.nodes, index, f"scenes[{n}].nodes")


def _check_sizes(found: _Document) -> None:
    """A small file may ask for any amount of memory: by nodes that share a mesh, primitives and
    accessors that share their numbers."""
    vertices, corners = [], []
    for mesh in found.meshes:
        vertices.append(sum(_count(found, p.attributes["POSITION"]) for p in mesh.primitives))
        corners.append(sum(_corners(found, primitive) for primitive in mesh.primitives))
    drawn = [node.mesh for node in found.nodes if node.mesh is not None]
    for what, of_mesh, most in (
        ("vertices", vertices, MAX_VERTICES),
        ("corners of triangles", corners, MAX_CORNERS),
    ):
        # All meshes are read, those that no node shows, too.
        total = max(sum(of_mesh), sum(of_mesh[k] for k in drawn))
        if total > most:
            raise ValueError(f"{total} {what}, at most {most}")
    for name, total in (
        ("bufferViews", sum(view.byteLength for view in found.bufferViews)),
        ("accessors", sum(_item_bytes(item) * item.count for item in found.accessors)),
    ):
        if total > MAX_BYTES:
            raise ValueError(f"{name}: {total} bytes together, at most {MAX_BYTES}")


def _count(found: _Document, accessor: int) -> int:
    return found.accessors[accessor].count


def _corners(found: _Document, primitive: _Primitive) -> int:
    """Corners of a primitive's triangles; in a strip nearly every one belongs to three."""
    named = primitive.attributes["POSITION"] if primitive.indices is None else primitive.indices
    return _count(found, named) * (3 if primitive.mode == _STRIP else 1)


def _at(items: list[Any], index: int, where: str) -> Any:
    if index >= len(items):
        raise ValueError(f"{where}: there is no {index}")
    return items[index]
