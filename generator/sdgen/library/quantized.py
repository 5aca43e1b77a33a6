"""GLBs with small vertices (glTF's KHR_mesh_quantization), made plain for trimesh.

trimesh reads integers as they are and overlooks ``normalized``: normals and texture coordinates
came out 127 and 65,535 times too long.
"""

from __future__ import annotations

import json
import struct
from typing import Any

import numpy as np

_JSON, _BIN = 0x4E4F534A, 0x004E4942
_COMPONENTS = {
    5120: ("i1", 127.0),
    5121: ("u1", 255.0),
    5122: ("<i2", 32767.0),
    5123: ("<u2", 65535.0),
}
_WIDTH = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}


def lacks_normals(document: dict[str, Any]) -> bool:
    """True when some primitive has no normals."""
    primitives = [p for mesh in document.get("meshes", ()) for p in mesh["primitives"]]
    return any("NORMAL" not in primitive["attributes"] for primitive in primitives)


def plain_glb(raw: bytes) -> bytes:
    """The same GLB with every normalized integer accessor as float32.

    Anything else is returned as it is, broken files too: what is wrong with them is for the
    reader to say. Raises ValueError, KeyError, IndexError or TypeError for accessors that
    contradict the file.
    """
    if raw[:4] != b"glTF" or b"normalized" not in raw[:200_000]:
        return raw
    length = int.from_bytes(raw[12:16], "little")
    document = json.loads(raw[20 : 20 + length])
    size = int.from_bytes(raw[20 + length : 24 + length], "little")
    blob = raw[28 + length : 28 + length + size]
    added: list[bytes] = []
    end = len(blob)
    for accessor in document["accessors"]:
        if not accessor.get("normalized") or accessor["componentType"] not in _COMPONENTS:
            continue
        kind, largest = _COMPONENTS[accessor["componentType"]]
        view = document["bufferViews"][accessor["bufferView"]]
        width, item = _WIDTH[accessor["type"]], np.dtype(kind).itemsize
        start = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        stride = view.get("byteStride", width * item)
        if stride < width * item:
            raise ValueError("an accessor's stride is less than its width")
        count = int(accessor["count"])
        needed = stride * (count - 1) + width * item
        if not (count > 0 and start >= 0 and start + needed <= len(blob)):
            raise ValueError("an accessor reaches beyond the buffer")
        rows = np.lib.stride_tricks.as_strided(
            np.frombuffer(blob, np.uint8, needed, start), (count, width * item), (stride, 1)
        )
        values = np.ascontiguousarray(rows).view(kind).astype(np.float64) / largest
        data = np.maximum(values, -1.0).astype("<f4").tobytes()
        document["bufferViews"].append({"buffer": 0, "byteOffset": end, "byteLength": len(data)})
        accessor |= {"bufferView": len(document["bufferViews"]) - 1, "componentType": 5126}
        accessor.pop("byteOffset", None)
        accessor.pop("normalized")
        added.append(data)
        end += len(data)
    document["buffers"][0]["byteLength"] = end
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    body = blob + b"".join(added)
    body += b"\0" * (-len(body) % 4)
    header = struct.pack("<III", 0x46546C67, 2, 12 + 8 + len(text) + 8 + len(body))
    lead = struct.pack("<II", len(text), _JSON)
    return header + lead + text + struct.pack("<II", len(body), _BIN) + body
