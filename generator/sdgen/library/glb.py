"""What a GLB says of itself, checked before trimesh follows it: it asserts, or trusts.

Only what is read is looked at: nodes, meshes, accessors and the buffers below them (names and
types are those of glTF 2.0's schema). Everything a model needs must lie in its file.
"""

from __future__ import annotations

import json
from typing import Annotated, Any

from pydantic import BaseModel, ConfigDict, Field, ValidationError

from sdgen.strict import explain
from sdgen.yaml_source import show_path

_JSON = 0x4E4F534A
#: componentType -> bytes, type -> components.
_BYTES = {5120: 1, 5121: 1, 5122: 2, 5123: 2, 5125: 4, 5126: 4}
_WIDTH = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT2": 4, "MAT3": 9, "MAT4": 16}
#: Triangles, and strips of them.
_MODES = (4, 5)
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
    """The JSON chunk of a GLB, whose frame, accessors and nodes are sound.

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
    if int.from_bytes(raw[16:20], "little") != _JSON or 20 + size > len(raw):
        raise ValueError("its first chunk is no whole JSON chunk")
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
    _check_accessors(found)
    _check_meshes(found)
    _check_nodes(found)
    return document


def _check_accessors(found: _Document) -> None:
    for k, buffer in enumerate(found.buffers):
        if buffer.uri is not None:
            raise ValueError(f"buffers[{k}].uri: another file; all must lie in the GLB")
    for k, view in enumerate(found.bufferViews):
        where = f"bufferViews[{k}]"
        buffer = _at(found.buffers, view.buffer, f"{where}.buffer")
        if view.byteOffset + view.byteLength > buffer.byteLength:
            raise ValueError(f"{where}: reaches beyond its buffer")
    for k, accessor in enumerate(found.accessors):
        where = f"accessors[{k}]"
        if accessor.componentType not in _BYTES:
            raise ValueError(f"{where}.componentType: glTF has no {accessor.componentType}")
        if accessor.type not in _WIDTH:
            raise ValueError(f"{where}.type: glTF has no {accessor.type[:40]!r}")
        if accessor.sparse is not None or accessor.bufferView is None:
            raise ValueError(f"{where}: sparse or compressed data is not read; write it plain")
        view = _at(found.bufferViews, accessor.bufferView, f"{where}.bufferView")
        item = _BYTES[accessor.componentType] * _WIDTH[accessor.type]
        stride = view.byteStride or item
        if stride < item:
            raise ValueError(f"{where}: its stride is less than its width")
        if accessor.byteOffset + stride * (accessor.count - 1) + item > view.byteLength:
            raise ValueError(f"{where}: reaches beyond its bufferView")


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


def _at(items: list[Any], index: int, where: str) -> Any:
    if index >= len(items):
        raise ValueError(f"{where}: there is no {index}")
    return items[index]
