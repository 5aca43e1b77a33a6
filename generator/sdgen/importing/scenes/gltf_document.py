"""A glTF scene of strangers: its nodes, their boxes, and triangles where they are asked for.

Read within bounds. A box is what the file says of it (``min`` and ``max`` of positions, which
glTF 2.0 requires), so that a scene of a gigabyte need not be unpacked to know what stands where.
"""

from __future__ import annotations

import base64
import json
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from functools import cached_property
from pathlib import Path
from typing import Any
from urllib.parse import unquote

import numpy as np
from pydantic import ValidationError

from sdgen.errors import InputError
from sdgen.files import read_plain
from sdgen.geometry import Array, apply, box_corners, lowest_highest
from sdgen.importing.scenes.found import pose_of
from sdgen.importing.scenes.json_text import in_words
from sdgen.importing.tree import inside
from sdgen.library.gltf import (
    COMPONENTS,
    Accessor,
    Buffer,
    Document,
    Node,
    Primitive,
    accessor_at,
    check_indices,
    chunks_of,
    item_of,
    parents_of,
    rows_of,
)

#: A furnished home with textures takes tens of megabytes; the largest looked at had 300.
MAX_BYTES = 1_000_000_000
MAX_JSON = 100_000_000
#: Triangles of all floors and walls together.
MAX_TRIANGLES = 2_000_000
#: Triangles, strips and fans of them.
_MODES = (4, 5, 6)
_STRIP, _FAN = 5, 6
_FLOAT = 5126


def parent_from(node: Node) -> Array:
    """Where a node is in its parent, 4x4."""
    if node.matrix is not None:
        given: Array = np.array(node.matrix, dtype=float).reshape(4, 4).T
        return given
    out = pose_of(node.translation or (0.0, 0.0, 0.0), node.rotation or (0.0, 0.0, 0.0, 1.0))
    out[:3, :3] *= np.array(node.scale or (1.0, 1.0, 1.0))
    return out


class GltfDocument:
    """A file's nodes and numbers. Raises InputError, located, for what is broken."""

    def __init__(self, path: Path) -> None:
        self._path = path
        self._shown = str(path)
        raw = read_plain(path, self._shown, MAX_BYTES)
        with self._located():
            text, self._chunk = chunks_of(raw) if raw[:4] == b"glTF" else (raw, b"")
            self._doc = self._parsed(text)
            self._parents = parents_of(self._doc)
        self.nodes: Sequence[Node] = self._doc.nodes
        self._read: dict[int, bytes] = {}
        self._triangles = 0

    @contextmanager
    def _located(self) -> Iterator[None]:
        try:
            yield
        except ValueError as error:
            raise InputError([f"{self._shown}: {error}"]) from None

    def _parsed(self, text: bytes) -> Document:
        if len(text) > MAX_JSON:
            raise ValueError(f"its JSON is larger than {MAX_JSON // 1_000_000} MB")
        try:
            value = json.loads(text)
        except (ValueError, RecursionError):
            raise ValueError("it is no glTF: its JSON cannot be read") from None
        if not isinstance(value, dict) or not isinstance(value.get("asset"), dict):
            raise ValueError("it is no glTF: the key 'asset' is missing")
        try:
            return Document.model_validate(value)
        except ValidationError as error:
            raise InputError(in_words(error, Document, value, self._shown)) from None

    @cached_property
    def roots(self) -> tuple[int, ...]:
        """The nodes of the scene; without one those that are no child."""
        chosen: Iterable[int] = range(len(self.nodes))
        if self._doc.scenes:
            with self._located():
                chosen = item_of(self._doc.scenes, self._doc.scene, "scene").nodes
        return tuple(k for k in dict.fromkeys(chosen) if k not in self._parents)

    def name(self, index: int) -> str:
        """What a node is called, or its mesh when it has no name."""
        node = self.nodes[index]
        if node.name or node.mesh is None:
            return node.name
        return self._doc.meshes[node.mesh].name

    def meshes(self, index: int, here: Array) -> Iterator[tuple[int, Array]]:
        """The meshes of a node and of all below it, each with where it is; ``here`` is the node's
        own place, 4x4."""
        node = self.nodes[index]
        if node.mesh is not None:
            yield node.mesh, here
        for child in node.children:
            yield from self.meshes(child, here @ parent_from(self.nodes[child]))

    def all_meshes(self, world_from_file: Array) -> Iterator[tuple[int, Array]]:
        """The meshes of the whole scene, each with where it is, 4x4."""
        for root in self.roots:
            yield from self.meshes(root, world_from_file @ parent_from(self.nodes[root]))

    def corners(self, meshes: Iterable[tuple[int, Array]]) -> Array:
        """Corners (N, 3) of the boxes of primitives, of meshes with their places."""
        found = [np.zeros((0, 3))]
        with self._located():
            for mesh, here in meshes:
                found += [
                    apply(here, box_corners(low.tolist(), high.tolist()))
                    for low, high in self._boxes(mesh)
                ]
        return np.concatenate(found)

    def triangles(self, meshes: Iterable[tuple[int, Array]]) -> Array:
        """Triangles (N, 3, 3) of meshes with their places."""
        found = [np.zeros((0, 3, 3))]
        with self._located():
            for mesh, here in meshes:
                for points in self._triangles_of(mesh):
                    self._triangles += len(points)
                    if self._triangles > MAX_TRIANGLES:
                        most = f"more than {MAX_TRIANGLES} triangles"
                        raise ValueError(f"its floors and walls have {most}")
                    found.append(apply(here, points.reshape(-1, 3)).reshape(-1, 3, 3))
        return np.concatenate(found)

    def _positions(self, mesh: int) -> Iterator[tuple[str, Primitive, int]]:
        """The primitives of a mesh that have positions: where, which, the positions' accessor."""
        for n, primitive in enumerate(self._doc.meshes[mesh].primitives):
            where = f"meshes[{mesh}].primitives[{n}]"
            at = primitive.attributes.get("POSITION")
            if at is not None:
                accessor_at(self._doc, at, f"{where}.attributes.POSITION", "VEC3")
                yield where, primitive, at

    def _boxes(self, mesh: int) -> Iterator[tuple[Array, Array]]:
        """Lowest and highest corner of each primitive of a mesh, in its frame."""
        for _, _, at in self._positions(mesh):
            accessor = self._doc.accessors[at]
            if accessor.min is None or accessor.max is None:
                yield lowest_highest(self._numbers(at))
            elif len(accessor.min) == len(accessor.max) == 3:
                yield _scaled(accessor, accessor.min), _scaled(accessor, accessor.max)
            else:
                raise ValueError(f"accessors[{at}]: min and max of positions have 3 numbers")

    def _triangles_of(self, mesh: int) -> Iterator[Array]:
        """Triangles (N, 3, 3) of each primitive of a mesh, in its frame."""
        for where, primitive, at in self._positions(mesh):
            if primitive.mode not in _MODES:
                continue  # points, lines
            points = self._numbers(at)
            order = np.arange(len(points))
            if primitive.indices is not None:
                check_indices(self._doc, primitive.indices, f"{where}.indices")
                order = self._numbers(primitive.indices).astype(np.int64).ravel()
            if order.max() >= len(points):
                raise ValueError(f"{where}: has triangles without corners")
            yield points[_corners(order, primitive.mode)]

    def _numbers(self, index: int) -> Array:
        """The values of an accessor, a row each."""
        found = rows_of(self._doc, index)
        data = self._buffer(found.buffer)
        if found.end > len(data):
            raise ValueError(f"accessors[{index}]: reaches beyond its bytes")
        strides = (found.stride, found.kind.itemsize)
        rows = np.ndarray(found.shape, found.kind, data, found.start, strides)
        numbers = _scaled(self._doc.accessors[index], rows)
        if not np.isfinite(numbers).all():
            raise ValueError(f"accessors[{index}]: has numbers that are not finite")
        return numbers

    def _buffer(self, index: int) -> bytes:
        if index not in self._read:
            self._read[index] = self._fetched(index, self._doc.buffers[index])
        return self._read[index]

    def _fetched(self, index: int, buffer: Buffer) -> bytes:
        if buffer.uri is None:
            return self._chunk
        if buffer.uri.startswith("data:"):
            try:
                return base64.b64decode(buffer.uri.partition(",")[2], validate=True)
            except ValueError:
                raise ValueError(f"buffers[{index}].uri: is no base64") from None
        name = unquote(buffer.uri)
        path = self._path.parent / name
        if ":" in name or "\0" in name or not inside(self._path.parent, path):
            raise ValueError(f"buffers[{index}].uri: {name[:80]!r} lies outside its folder")
        return read_plain(path, str(path), MAX_BYTES)


def _scaled(accessor: Accessor, values: Sequence[float] | np.ndarray[Any, Any]) -> Array:
    numbers = np.array(values, dtype=float)
    if accessor.normalized and accessor.componentType != _FLOAT:
        numbers /= np.iinfo(COMPONENTS[accessor.componentType]).max
    return numbers


def _corners(order: np.ndarray[Any, np.dtype[np.int64]], mode: int) -> Any:
    """Numbers of the corners (N, 3) of triangles, strips or fans of them."""
    if mode == _STRIP:
        return np.column_stack([order[:-2], order[1:-1], order[2:]])
    if mode == _FAN:
        return np.column_stack([np.full_like(order[2:], order[0]), order[1:-1], order[2:]])
    return order[: len(order) // 3 * 3].reshape(-1, 3)
