"""A glTF scene of strangers: its nodes, their boxes, and triangles where they are asked for.

Read within bounds. A box is what the file says of it (``min`` and ``max`` of positions, which
glTF 2.0 requires), so that a scene of a gigabyte need not be unpacked to know what stands where.
"""

from __future__ import annotations

import base64
import binascii
import json
from collections.abc import Iterator, Sequence
from functools import cached_property
from pathlib import Path
from typing import Annotated, Any
from urllib.parse import unquote

import numpy as np
from pydantic import BaseModel, ConfigDict, Field, ValidationError

from sdgen.errors import InputError
from sdgen.files import read_plain
from sdgen.geometry import Array, matrix
from sdgen.importing.scenes.json_text import in_words
from sdgen.library.glb import BIN, COMPONENTS, JSON, WIDTH

#: A furnished home with textures takes tens of megabytes; the largest looked at had 300.
MAX_BYTES = 1_000_000_000
MAX_JSON = 100_000_000
#: Triangles of all floors and walls together.
MAX_TRIANGLES = 2_000_000
_DEEPEST = 200
_STRIP, _FAN = 5, 6

Index = Annotated[int, Field(ge=0)]
Number = Annotated[float, Field(allow_inf_nan=False)]


class _Part(BaseModel):
    model_config = ConfigDict(extra="ignore", strict=True, frozen=True)


class Accessor(_Part):
    """Numbers, and their least and greatest values."""

    bufferView: Index | None = None
    byteOffset: Index = 0
    componentType: int
    type: str
    count: int = Field(ge=1)
    normalized: bool = False
    min: list[Number] | None = None
    max: list[Number] | None = None
    sparse: Any = None


class _View(_Part):
    buffer: Index
    byteOffset: Index = 0
    byteLength: int = Field(ge=1)
    byteStride: int | None = Field(default=None, ge=1)


class _Buffer(_Part):
    byteLength: int = Field(ge=1)
    uri: str | None = None


class _Primitive(_Part):
    attributes: dict[str, Index]
    indices: Index | None = None
    mode: int = 4


class _Mesh(_Part):
    name: str = ""
    primitives: list[_Primitive]


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

    def parent_from_node(self) -> Array:
        """The node's own 4x4."""
        if self.matrix is not None:
            given: Array = np.array(self.matrix, dtype=float).reshape(4, 4).T
            return given
        rotation = self.rotation or (0.0, 0.0, 0.0, 1.0)
        if not np.any(rotation):
            rotation = (0.0, 0.0, 0.0, 1.0)
        out = matrix(self.translation or (0.0, 0.0, 0.0), rotation)
        out[:3, :3] *= np.array(self.scale or (1.0, 1.0, 1.0))
        return out


class _Scene(_Part):
    nodes: list[Index] = []


class _Document(_Part):
    buffers: list[_Buffer] = []
    bufferViews: list[_View] = []
    accessors: list[Accessor] = []
    meshes: list[_Mesh] = []
    nodes: list[Node] = []
    scenes: list[_Scene] = []
    scene: Index = 0


class GltfDocument:
    """A file's nodes and numbers. Raises InputError, located, for what is broken."""

    def __init__(self, path: Path) -> None:
        self._path = path
        self._shown = str(path)
        raw = read_plain(path, self._shown, MAX_BYTES)
        text, self._chunk = self._chunks(raw) if raw[:4] == b"glTF" else (raw, b"")
        self._doc = self._parsed(text)
        self.nodes: Sequence[Node] = self._doc.nodes
        self._check_trees()
        self._read: dict[int, bytes] = {}
        self._triangles = 0

    def _wrong(self, text: str) -> InputError:
        return InputError([f"{self._shown}: {text}"])

    def _chunks(self, raw: bytes) -> tuple[bytes, bytes]:
        size = int.from_bytes(raw[12:16], "little")
        if int.from_bytes(raw[4:8], "little") != 2:
            raise self._wrong("it is not of glTF version 2")
        if int.from_bytes(raw[16:20], "little") != JSON or 20 + size > len(raw):
            raise self._wrong("it is cut off: its first chunk is no whole JSON chunk")
        start = 20 + size
        length = int.from_bytes(raw[start : start + 4], "little")
        if int.from_bytes(raw[start + 4 : start + 8], "little") != BIN:
            return raw[20:start], b""
        if start + 8 + length > len(raw):
            raise self._wrong("it is cut off: its binary chunk is not whole")
        return raw[20:start], raw[start + 8 : start + 8 + length]

    def _parsed(self, text: bytes) -> _Document:
        if len(text) > MAX_JSON:
            raise self._wrong(f"its JSON is larger than {MAX_JSON // 1_000_000} MB")
        try:
            value = json.loads(text)
        except (ValueError, RecursionError):
            raise self._wrong("it is no glTF: its JSON cannot be read") from None
        if not isinstance(value, dict) or not isinstance(value.get("asset"), dict):
            raise self._wrong("it is no glTF: the key 'asset' is missing")
        try:
            return _Document.model_validate(value)
        except ValidationError as error:
            raise InputError(in_words(error, _Document, value, self._shown)) from None

    def _check_trees(self) -> None:
        """Nodes are trees, not too deep; what they name is there."""
        nodes, parent = self.nodes, {}
        for k, node in enumerate(nodes):
            if node.mesh is not None and node.mesh >= len(self._doc.meshes):
                raise self._wrong(f"nodes[{k}].mesh: there is no {node.mesh}")
            for child in node.children:
                if child >= len(nodes):
                    raise self._wrong(f"nodes[{k}].children: there is no {child}")
                if child in parent:
                    raise self._wrong(f"nodes[{child}]: is a child twice")
                parent[child] = k
        for k in range(len(nodes)):
            at, steps = k, 0
            while at in parent:
                at, steps = parent[at], steps + 1
                if steps > _DEEPEST:
                    raise self._wrong(f"nodes[{k}]: is nested too deeply, or in itself")
        self._parent = parent

    @cached_property
    def roots(self) -> tuple[int, ...]:
        """The nodes of the scene; without one those that are no child."""
        scenes = self._doc.scenes
        if scenes:
            if self._doc.scene >= len(scenes):
                raise self._wrong(f"scene: there is no {self._doc.scene}")
            chosen = tuple(dict.fromkeys(scenes[self._doc.scene].nodes))
            for k in chosen:
                if k >= len(self.nodes):
                    raise self._wrong(f"scenes[{self._doc.scene}].nodes: there is no {k}")
            return tuple(k for k in chosen if k not in self._parent)
        return tuple(k for k in range(len(self.nodes)) if k not in self._parent)

    def name(self, index: int) -> str:
        """What a node is called, or its mesh when it has no name."""
        node = self.nodes[index]
        if node.name or node.mesh is None:
            return node.name
        return self._doc.meshes[node.mesh].name

    def boxes(self, mesh: int) -> Iterator[tuple[Array, Array]]:
        """Lowest and highest corner, in the mesh's frame, of each of its primitives."""
        for primitive in self._doc.meshes[mesh].primitives:
            at = primitive.attributes.get("POSITION")
            if at is None:
                continue
            accessor = self._accessor(at)
            if accessor.min is not None and accessor.max is not None:
                if len(accessor.min) == len(accessor.max) == 3:
                    yield self._scaled(accessor, accessor.min), self._scaled(accessor, accessor.max)
                    continue
                raise self._wrong(f"accessors[{at}]: min and max of positions have 3 numbers")
            points = self._numbers(at)
            yield points.min(axis=0), points.max(axis=0)

    def triangles(self, mesh: int) -> Array:
        """Triangles (N, 3, 3) of a mesh, in its frame."""
        found = [np.zeros((0, 3, 3))]
        for primitive in self._doc.meshes[mesh].primitives:
            at = primitive.attributes.get("POSITION")
            if at is None or primitive.mode < 4:
                continue
            points = self._numbers(at)
            if primitive.indices is None:
                order = np.arange(len(points))
            else:
                order = self._numbers(primitive.indices).astype(np.int64).ravel()
            if len(order) and order.max() >= len(points):
                raise self._wrong(f"meshes[{mesh}]: has triangles without corners")
            found.append(points[_corners(order, primitive.mode)])
        every = np.concatenate(found)
        self._triangles += len(every)
        if self._triangles > MAX_TRIANGLES:
            raise self._wrong(f"its floors and walls have more than {MAX_TRIANGLES} triangles")
        return every

    def _accessor(self, index: int) -> Accessor:
        if index >= len(self._doc.accessors):
            raise self._wrong(f"accessors: there is no {index}")
        accessor = self._doc.accessors[index]
        if accessor.componentType not in COMPONENTS or accessor.type not in WIDTH:
            raise self._wrong(f"accessors[{index}]: glTF has no such type")
        return accessor

    def _scaled(self, accessor: Accessor, values: Sequence[float] | Array) -> Array:
        numbers = np.array(values, dtype=float)
        if accessor.normalized and accessor.componentType != 5126:
            numbers /= np.iinfo(COMPONENTS[accessor.componentType]).max
        return numbers

    def _numbers(self, index: int) -> Array:
        """The values of an accessor, a row each."""
        accessor = self._accessor(index)
        where = f"accessors[{index}]"
        if accessor.sparse is not None or accessor.bufferView is None:
            raise self._wrong(f"{where}: sparse or compressed data is not read; write it plain")
        if accessor.bufferView >= len(self._doc.bufferViews):
            raise self._wrong(f"{where}.bufferView: there is no {accessor.bufferView}")
        view = self._doc.bufferViews[accessor.bufferView]
        kind = np.dtype(COMPONENTS[accessor.componentType])
        width = WIDTH[accessor.type]
        item = kind.itemsize * width
        stride = view.byteStride or item
        start = view.byteOffset + accessor.byteOffset
        data = self._buffer(view.buffer)
        last = start + stride * (accessor.count - 1) + item
        if stride < item or last > len(data) or last > view.byteOffset + view.byteLength:
            raise self._wrong(f"{where}: reaches beyond its bytes")
        rows = np.ndarray((accessor.count, width), kind, data, start, (stride, kind.itemsize))
        numbers = self._scaled(accessor, rows.astype(float))
        if not np.isfinite(numbers).all():
            raise self._wrong(f"{where}: has numbers that are not finite")
        return numbers

    def _buffer(self, index: int) -> bytes:
        if index not in self._read:
            if index >= len(self._doc.buffers):
                raise self._wrong(f"buffers: there is no {index}")
            self._read[index] = self._fetched(index, self._doc.buffers[index])
        return self._read[index]

    def _fetched(self, index: int, buffer: _Buffer) -> bytes:
        if buffer.uri is None:
            return self._chunk
        if buffer.uri.startswith("data:"):
            try:
                return base64.b64decode(buffer.uri.partition(",")[2], validate=True)
            except (ValueError, binascii.Error):
                raise self._wrong(f"buffers[{index}].uri: is no base64") from None
        name = unquote(buffer.uri)
        path = self._path.parent / name
        if ":" in name or "\0" in name or not _inside(self._path.parent, path):
            raise self._wrong(f"buffers[{index}].uri: {name[:80]!r} lies outside its folder")
        return read_plain(path, str(path), MAX_BYTES)


def _inside(folder: Path, path: Path) -> bool:
    try:
        return path.resolve().is_relative_to(folder.resolve())
    except (OSError, RuntimeError):
        return False


def _corners(order: np.ndarray[Any, np.dtype[np.int64]], mode: int) -> Any:
    """Numbers of the corners (N, 3) of triangles, strips or fans of them."""
    if mode == _STRIP:
        return np.column_stack([order[:-2], order[1:-1], order[2:]])
    if mode == _FAN:
        return np.column_stack([np.full(len(order) - 2, order[0]), order[1:-1], order[2:]])
    return order[: len(order) // 3 * 3].reshape(-1, 3)
