"""GLBs with small vertices (glTF's KHR_mesh_quantization), made plain for trimesh.

trimesh reads integers as they are and overlooks ``normalized``: normals and texture coordinates
came out 127 and 65,535 times too long.
"""

from __future__ import annotations

import copy
from typing import Any

import numpy as np

from sdgen.library.gltf import COMPONENTS, WIDTH, chunks_of, glb_of

_FLOAT = 5126


def lacks_normals(document: dict[str, Any]) -> bool:
    """True when some primitive has no normals."""
    primitives = [p for mesh in document.get("meshes", ()) for p in mesh["primitives"]]
    return any("NORMAL" not in primitive["attributes"] for primitive in primitives)


def plain_glb(raw: bytes, document: dict[str, Any]) -> bytes:
    """The same GLB with every normalized integer accessor as float32; itself when it has none.

    ``document`` is what ``glb_document`` found in it, and found sound.
    """
    if not any(map(_is_small, document.get("accessors", ()))):
        return raw
    document = copy.deepcopy(document)
    _, blob = chunks_of(raw)
    added: list[bytes] = []
    end = len(blob)
    for accessor in filter(_is_small, document["accessors"]):
        kind = np.dtype(COMPONENTS[accessor["componentType"]])
        view = document["bufferViews"][accessor["bufferView"]]
        item = WIDTH[accessor["type"]] * kind.itemsize
        start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        stride = view.get("byteStride") or item
        count = accessor["count"]
        needed = stride * (count - 1) + item
        rows = np.lib.stride_tricks.as_strided(
            np.frombuffer(blob, np.uint8, needed, start), (count, item), (stride, 1)
        )
        values = np.ascontiguousarray(rows).view(kind).astype(np.float64) / np.iinfo(kind).max
        data = np.maximum(values, -1.0).astype("<f4").tobytes()
        document["bufferViews"].append({"buffer": 0, "byteOffset": end, "byteLength": len(data)})
        accessor |= {"bufferView": len(document["bufferViews"]) - 1, "componentType": _FLOAT}
        accessor.pop("byteOffset", None)
        accessor.pop("normalized")
        added.append(data)
        end += len(data)
    document["buffers"][0]["byteLength"] = end
    return glb_of(document, blob + b"".join(added))


def _is_small(accessor: dict[str, Any]) -> bool:
    """True for fractions written as whole numbers; glTF has none of four bytes."""
    kind = np.dtype(COMPONENTS[accessor["componentType"]])
    return bool(accessor.get("normalized")) and kind.kind != "f" and kind.itemsize < 4
