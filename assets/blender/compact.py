"""Halves our GLBs: positions in 16 bits, normals in 8, texture coordinates in 16.

As glTF's KHR_mesh_quantization allows (https://github.com/KhronosGroup/glTF, ratified 2020).
"""

from __future__ import annotations

import json
import struct

import numpy as np

_EXTENSION = "KHR_mesh_quantization"
_COMPONENTS = {5121: "<u1", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
_WIDTH = {"SCALAR": 1, "VEC2": 2, "VEC3": 3}


def compact(raw: bytes) -> bytes:
    """A GLB as export.py writes it (float32, one primitive a node) with small vertices."""
    length = int.from_bytes(raw[12:16], "little")
    document, blob = json.loads(raw[20 : 20 + length]), raw[28 + length :]

    def read(index: int) -> np.ndarray:
        a = document["accessors"][index]
        width = _WIDTH[a["type"]]
        start = document["bufferViews"][a["bufferView"]]["byteOffset"]
        kind = _COMPONENTS[a["componentType"]]
        return np.frombuffer(blob, kind, a["count"] * width, start).reshape(-1, width)

    parts = []
    for mesh in document["meshes"]:
        primitive = mesh["primitives"][0]
        names = ("POSITION", "NORMAL", "TEXCOORD_0")
        arrays = [read(primitive["attributes"][name]).astype(float) for name in names]
        parts.append((*arrays, read(primitive["indices"]).ravel()))
    # One grid for all parts: faces that lie in one plane stay in one plane.
    points = np.concatenate([part[0] for part in parts])
    low, high = points.min(axis=0), points.max(axis=0)
    middle = (low + high) / 2
    step = float(np.float32((high - low).max() / 65000))
    views: list[dict] = []
    accessors: list[dict] = []
    chunks: list[bytes] = []

    def add(array: np.ndarray, kind: str, component: int, **more: object) -> int:
        data = np.ascontiguousarray(array).tobytes()
        view = {"buffer": 0, "byteOffset": sum(map(len, chunks)), "byteLength": len(data)}
        if kind != "SCALAR":
            view["byteStride"] = len(data) // len(array)
        view["target"] = 34963 if kind == "SCALAR" else 34962
        views.append(view)
        chunks.append(data + b"\0" * (-len(data) % 4))
        accessor = {
            "bufferView": len(views) - 1,
            "componentType": component,
            "count": len(array),
            "type": kind,
        }
        accessors.append(accessor | more)
        return len(accessors) - 1

    for mesh, (position, normal, uv, index) in zip(document["meshes"], parts, strict=True):
        grid = np.round((position - middle) / step).astype("<i2")
        unit = normal / (np.linalg.norm(normal, axis=1, keepdims=True) + 1e-12)
        small = np.round(unit * 127).astype("i1")
        spread = np.round(uv.clip(0, 1) * 65535).astype("<u2")
        # Vertices that fell onto one another are one.
        table, first, inverse = np.unique(
            np.concatenate([grid, small, spread.astype(int)], axis=1),
            axis=0,
            return_index=True,
            return_inverse=True,
        )
        order = np.argsort(first, kind="stable")  # in the order they were in
        rank = np.empty(len(table), int)
        rank[order] = np.arange(len(table))
        index, first = rank[inverse.ravel()[index]], first[order]
        padding = np.zeros((len(first), 1))
        bounds = {"min": grid[first].min(0).tolist(), "max": grid[first].max(0).tolist()}
        attributes = {
            "POSITION": add(np.c_[grid[first], padding].astype("<i2"), "VEC3", 5122, **bounds),
            "NORMAL": add(np.c_[small[first], padding].astype("i1"), "VEC3", 5120, normalized=True),
            "TEXCOORD_0": add(spread[first], "VEC2", 5123, normalized=True),
        }
        primitive = mesh["primitives"][0]
        primitive["attributes"] = attributes
        primitive["indices"] = add(index.astype("<u2"), "SCALAR", 5123)
    for node in document["nodes"]:
        node |= {"translation": middle.tolist(), "scale": [step] * 3}
    blob = b"".join(chunks)
    document |= {
        "bufferViews": views,
        "accessors": accessors,
        "buffers": [{"byteLength": len(blob)}],
        "extensionsUsed": [_EXTENSION],
        "extensionsRequired": [_EXTENSION],
    }
    text = json.dumps(document, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    header = struct.pack("<III", 0x46546C67, 2, 20 + len(text) + 8 + len(blob))
    lead = struct.pack("<II", len(text), 0x4E4F534A)
    return header + lead + text + struct.pack("<II", len(blob), 0x004E4942) + blob
