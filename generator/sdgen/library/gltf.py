"""The frame of glTF 2.0: chunks of a GLB, and what its JSON says of nodes, meshes and numbers.

Only what is read is looked at; names and types are those of glTF's schema.
"""

from __future__ import annotations

import json
import struct
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Annotated, Any, TypeVar

import numpy as np
from pydantic import BaseModel, ConfigDict, Field

#: componentType -> NumPy's name of it, type -> components.
COMPONENTS = {5120: "i1", 5121: "u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
WIDTH = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT2": 4, "MAT3": 9, "MAT4": 16}
#: Component types of indices: whole numbers from 0.
_COUNTING = (5121, 5123, 5125)
#: Types of the two chunks.
_JSON, _BIN = 0x4E4F534A, 0x004E4942
#: Nodes within nodes.
_DEEPEST = 200

T = TypeVar("T")
Index = Annotated[int, Field(ge=0)]
Number = Annotated[float, Field(allow_inf_nan=False)]


class _Part(BaseModel):
    model_config = ConfigDict(extra="ignore", strict=True, frozen=True)


class Buffer(_Part):
    """Bytes: those of the GLB's second chunk, or of the file that ``uri`` names."""

    byteLength: int = Field(ge=1)
    uri: str | None = None


class View(_Part):
    """A stretch of a buffer."""

    buffer: Index
    byteOffset: Index = 0
    byteLength: int = Field(ge=1)
    byteStride: int | None = Field(default=None, ge=1)


class Accessor(_Part):
    """Numbers in a view, and their least and greatest values."""

    bufferView: Index | None = None
    byteOffset: Index = 0
    componentType: int
    type: str
    count: int = Field(ge=1)
    normalized: bool = False
    min: list[Number] | None = None
    max: list[Number] | None = None
    sparse: Any = None


class Primitive(_Part):
    """Triangles (or points, or lines) by the accessors of their corners."""

    attributes: dict[str, Index]
    indices: Index | None = None
    mode: int = 4


class Mesh(_Part):
    """What nodes show."""

    name: str = ""
    primitives: list[Primitive]


class Node(_Part):
    """A node: its name, where it is in its parent, what is below it."""

    name: str = ""
    mesh: Index | None = None
    children: list[Index] = []
    matrix: list[Number] | None = Field(default=None, min_length=16, max_length=16)
    translation: list[Number] | None = Field(default=None, min_length=3, max_length=3)
    rotation: list[Number] | None = Field(default=None, min_length=4, max_length=4)
    scale: list[Number] | None = Field(default=None, min_length=3, max_length=3)
    extras: Any = None


class Scene(_Part):
    """The nodes that are shown."""

    nodes: list[Index] = []


class Document(_Part):
    """The JSON of a file."""

    buffers: list[Buffer] = []
    bufferViews: list[View] = []
    accessors: list[Accessor] = []
    meshes: list[Mesh] = []
    nodes: list[Node] = []
    scenes: list[Scene] = []
    scene: Index = 0


@dataclass(frozen=True)
class Rows:
    """Where an accessor's values lie in their buffer, a row each; all of ``View`` checked."""

    buffer: int
    kind: np.dtype[Any]
    shape: tuple[int, int]
    start: int
    stride: int

    @property
    def end(self) -> int:
        """The byte behind the last."""
        count, width = self.shape
        return self.start + self.stride * (count - 1) + self.kind.itemsize * width


def chunks_of(raw: bytes) -> tuple[bytes, bytes]:
    """The JSON of a GLB, and the chunk that holds its numbers, empty when there is none.

    Raises ValueError for what is no GLB, or is cut off.
    """
    if raw[:4] != b"glTF":
        raise ValueError("it is no GLB (binary glTF) file")
    if int.from_bytes(raw[4:8], "little") != 2:
        raise ValueError("it is not of glTF version 2")
    length = int.from_bytes(raw[8:12], "little")
    if length > len(raw):
        raise ValueError(f"it is cut off: {len(raw)} of {length} bytes are there")
    start = 20 + int.from_bytes(raw[12:16], "little")
    if int.from_bytes(raw[16:20], "little") != _JSON or start > len(raw):
        raise ValueError("its first chunk is no whole JSON chunk")
    if int.from_bytes(raw[start + 4 : start + 8], "little") != _BIN:
        return raw[20:start], b""
    end = start + 8 + int.from_bytes(raw[start : start + 4], "little")
    if end > len(raw):
        raise ValueError("its binary chunk is cut off")
    return raw[20:start], raw[start + 8 : end]


def glb_of(document: dict[str, Any], blob: bytes) -> bytes:
    """The GLB of a document and its numbers."""
    text = json.dumps(document, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    blob += b"\0" * (-len(blob) % 4)
    body = struct.pack("<II", len(text), _JSON) + text
    if blob:
        body += struct.pack("<II", len(blob), _BIN) + blob
    return b"glTF" + struct.pack("<II", 2, 12 + len(body)) + body


def item_of(items: Sequence[T], index: int, where: str) -> T:
    """One of ``items``. Raises ValueError, located, when there is none of this number."""
    if index >= len(items):
        raise ValueError(f"{where}: there is no {index}")
    return items[index]


def parents_of(document: Document) -> dict[int, int]:
    """Node -> the node above it.

    Raises ValueError unless nodes are trees, not too deep, and all that they name is there.
    """
    parent: dict[int, int] = {}
    for k, node in enumerate(document.nodes):
        if node.mesh is not None:
            item_of(document.meshes, node.mesh, f"nodes[{k}].mesh")
        for child in node.children:
            item_of(document.nodes, child, f"nodes[{k}].children")
            if child in parent:
                raise ValueError(f"nodes[{child}]: is a child twice")
            parent[child] = k
    for k in range(len(document.nodes)):
        at, below = k, {k}
        while at in parent:
            at = parent[at]
            if at in below:
                raise ValueError(f"nodes[{at}]: is a child of its own")
            below.add(at)
            if len(below) > _DEEPEST:
                raise ValueError(f"nodes[{k}]: is nested more than {_DEEPEST} deep")
    for n, scene in enumerate(document.scenes):
        for index in scene.nodes:
            item_of(document.nodes, index, f"scenes[{n}].nodes")
    return parent


def accessor_at(
    document: Document, index: int, where: str = "accessors", type_: str | None = None
) -> Accessor:
    """The accessor that is named at ``where``. Raises ValueError when there is none, or of types
    that glTF does not have, or of another than ``type_``."""
    accessor = item_of(document.accessors, index, where)
    if accessor.componentType not in COMPONENTS:
        raise ValueError(f"accessors[{index}].componentType: glTF has no {accessor.componentType}")
    if accessor.type not in WIDTH:
        raise ValueError(f"accessors[{index}].type: glTF has no {accessor.type[:40]!r}")
    if type_ is not None and accessor.type != type_:
        raise ValueError(f"{where}: not {type_}")
    return accessor


def check_indices(document: Document, index: int, where: str) -> None:
    """Raise ValueError unless an accessor, named at ``where``, may number corners."""
    accessor = accessor_at(document, index, where)
    if accessor.type != "SCALAR" or accessor.componentType not in _COUNTING:
        raise ValueError(f"{where}: not whole numbers from 0")


def rows_of(document: Document, index: int) -> Rows:
    """Where the values of an accessor lie. Raises ValueError unless it is plain and in its view."""
    where = f"accessors[{index}]"
    accessor = accessor_at(document, index)
    if accessor.sparse is not None or accessor.bufferView is None:
        raise ValueError(f"{where}: sparse or compressed data is not read; write it plain")
    view = item_of(document.bufferViews, accessor.bufferView, f"{where}.bufferView")
    item_of(document.buffers, view.buffer, f"bufferViews[{accessor.bufferView}].buffer")
    kind, width = np.dtype(COMPONENTS[accessor.componentType]), WIDTH[accessor.type]
    stride = view.byteStride or kind.itemsize * width
    if stride < kind.itemsize * width:
        raise ValueError(f"{where}: its stride is less than its width")
    start = view.byteOffset + accessor.byteOffset
    rows = Rows(view.buffer, kind, (accessor.count, width), start, stride)
    if rows.end > view.byteOffset + view.byteLength:
        raise ValueError(f"{where}: reaches beyond its bufferView")
    return rows
