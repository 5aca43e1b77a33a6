"""What a model's GLB says of itself, checked before trimesh follows it: it asserts, or trusts.

Everything a model needs must lie in its file.
"""

from __future__ import annotations

import json
from typing import Any

from pydantic import ValidationError

from sdgen.library.gltf import (
    Document,
    Primitive,
    accessor_at,
    check_indices,
    chunks_of,
    item_of,
    parents_of,
    rows_of,
)
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

#: Triangles, and strips of them.
_MODES = (4, 5)
_STRIP = 5
_ATTRIBUTES = {"POSITION": "VEC3", "NORMAL": "VEC3", "TEXCOORD_0": "VEC2"}


def glb_document(raw: bytes) -> dict[str, Any]:
    """The JSON chunk of a GLB, whose frame, accessors and nodes are sound and ask for no more
    memory than a model may have.

    Raises ValueError that says what is wrong.
    """
    text, blob = chunks_of(raw)
    if len(text) > MAX_JSON:
        raise ValueError(f"its JSON chunk has {len(text)} bytes, at most {MAX_JSON}")
    try:
        document = json.loads(text)
    except (ValueError, RecursionError):
        raise ValueError("its JSON chunk is damaged") from None
    if not isinstance(document, dict):
        raise ValueError("its JSON chunk is damaged")
    try:
        found = Document.model_validate(document)
    except ValidationError as error:
        first = error.errors()[0]  # of lists that are too short nothing is explained
        path, why = next(explain(error, Document, document), (first["loc"], first["msg"]))
        raise ValueError(f"{show_path(path)}: {why}") from None
    _check_buffers(found, len(blob))
    _check_numbers(found)
    _check_meshes(found)
    parents_of(found)
    _check_sizes(found)
    return document


def _check_buffers(found: Document, there: int) -> None:
    for k, buffer in enumerate(found.buffers):
        if buffer.uri is not None:
            raise ValueError(f"buffers[{k}].uri: another file; all must lie in the GLB")
        if k > 0:
            raise ValueError(f"buffers[{k}]: a GLB has one")
        if buffer.byteLength > there:
            raise ValueError(f"buffers[{k}]: {there} of {buffer.byteLength} bytes are there")


def _check_numbers(found: Document) -> None:
    for k, view in enumerate(found.bufferViews):
        where = f"bufferViews[{k}]"
        buffer = item_of(found.buffers, view.buffer, f"{where}.buffer")
        if view.byteOffset + view.byteLength > buffer.byteLength:
            raise ValueError(f"{where}: reaches beyond its buffer")
    for k in range(len(found.accessors)):
        rows_of(found, k)


def _check_meshes(found: Document) -> None:
    for k, mesh in enumerate(found.meshes):
        for n, primitive in enumerate(mesh.primitives):
            where = f"meshes[{k}].primitives[{n}]"
            if primitive.mode not in _MODES:
                raise ValueError(f"{where}.mode: {primitive.mode} is not triangles (4)")
            if "POSITION" not in primitive.attributes:
                raise ValueError(f"{where}.attributes: no POSITION")
            counts = set()
            for name, index in primitive.attributes.items():
                place = f"{where}.attributes.{name[:40]}"
                counts.add(accessor_at(found, index, place, _ATTRIBUTES.get(name)).count)
            if len(counts) > 1:
                raise ValueError(f"{where}.attributes: not all have as many values")
            if primitive.indices is not None:
                check_indices(found, primitive.indices, f"{where}.indices")


def _check_sizes(found: Document) -> None:
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
        ("accessors", sum(_bytes(found, k) for k in range(len(found.accessors)))),
    ):
        if total > MAX_BYTES:
            raise ValueError(f"{name}: {total} bytes together, at most {MAX_BYTES}")


def _bytes(found: Document, accessor: int) -> int:
    """Bytes of what an accessor is read into."""
    rows = rows_of(found, accessor)
    return rows.kind.itemsize * rows.shape[0] * rows.shape[1]


def _count(found: Document, accessor: int) -> int:
    return found.accessors[accessor].count


def _corners(found: Document, primitive: Primitive) -> int:
    """Corners of a primitive's triangles; in a strip nearly every one belongs to three."""
    named = primitive.attributes["POSITION"] if primitive.indices is None else primitive.indices
    return _count(found, named) * (3 if primitive.mode == _STRIP else 1)
