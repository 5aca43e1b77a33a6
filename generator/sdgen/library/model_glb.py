"""A model as one small GLB for viewers: a node a part, its texture inside, whatever its own file.

Written anew from the checked arrays: nothing of a stranger's GLB but numbers reaches a viewer.
"""

from __future__ import annotations

import json
import struct
from typing import Any

import numpy as np
import numpy.typing as npt

from sdgen.geometry import Z_UP_FROM_Y_UP
from sdgen.library.library import Library
from sdgen.library.meshes import MeshData
from sdgen.library.raw import file_bytes

_FLOAT, _BYTE, _SHORT, _INT = 5126, 5120, 5123, 5125
_VERTICES, _INDICES = 34962, 34963
#: 16 bits count so many vertices.
_SHORT_REACHES = 65535


def model_glb(library: Library, asset_id: str) -> bytes:
    """A model's parts as nodes named by them, all joints at 0, below a root that is Y up as glTF
    is; the parts' own coordinates are Z up, as ours are.

    Positions and texture coordinates are floats, normals bytes (KHR_mesh_quantization). Factors of
    colour stay with the record: glTF has none above 1. Raises AssetError for a broken file.
    """
    asset = library.assets[asset_id]
    made = _Made()
    meshes = library.mesh(asset_id)
    for part in asset.parts:
        picture = file_bytes(library.file(asset_id, part.texture or asset.texture))
        made.part(part.name, meshes[part.name], picture)
    return made.glb()


class _Made:
    """A glTF in the making: its lists, and the bytes they speak of."""

    def __init__(self) -> None:
        self._blob = bytearray()
        self._lists: dict[str, list[dict[str, Any]]] = {
            name: [] for name in ("nodes", "meshes", "accessors", "bufferViews", "materials")
        }
        self._pictures: list[bytes] = []

    def part(self, name: str, mesh: MeshData, picture: bytes) -> None:
        """Add a part."""
        if picture not in self._pictures:
            self._pictures.append(picture)
        number = len(self._lists["nodes"])
        wide = len(mesh.vertices) > _SHORT_REACHES
        normals = np.zeros((len(mesh.normals), 4), dtype=np.int8)  # rows begin at fours
        normals[:, :3] = np.rint(mesh.normals * 127)
        points = mesh.vertices.astype("<f4")
        position = self._accessor(points, _FLOAT, "VEC3")
        bounds = {"min": points.min(axis=0).tolist(), "max": points.max(axis=0).tolist()}
        self._lists["accessors"][position] |= bounds
        # glTF counts v from the top of a picture.
        uvs = mesh.uvs * (1, -1) + (0, 1)
        attributes = {
            "POSITION": position,
            "NORMAL": self._accessor(normals, _BYTE, "VEC3", normalized=True),
            "TEXCOORD_0": self._accessor(uvs.astype("<f4"), _FLOAT, "VEC2"),
        }
        faces = mesh.faces.reshape(-1).astype("<u4" if wide else "<u2")
        indices = self._accessor(faces, _INT if wide else _SHORT, "SCALAR", _INDICES)
        material = self._pictures.index(picture)
        triangles = {"attributes": attributes, "indices": indices, "material": material}
        self._lists["nodes"].append({"name": name, "mesh": number})
        self._lists["meshes"].append({"primitives": [triangles]})

    def _accessor(
        self,
        values: npt.NDArray[Any],
        component: int,
        kind: str,
        target: int = _VERTICES,
        normalized: bool = False,
    ) -> int:
        view = self._view(values.tobytes(), {"target": target})
        if normalized:
            self._lists["bufferViews"][view]["byteStride"] = values.strides[0]
        found = {"bufferView": view, "componentType": component, "count": len(values), "type": kind}
        self._lists["accessors"].append(found | ({"normalized": True} if normalized else {}))
        return len(self._lists["accessors"]) - 1

    def _view(self, data: bytes, more: dict[str, Any]) -> int:
        start = len(self._blob)
        self._blob += data + b"\0" * (-len(data) % 4)
        view = {"buffer": 0, "byteOffset": start, "byteLength": len(data), **more}
        self._lists["bufferViews"].append(view)
        return len(self._lists["bufferViews"]) - 1

    def glb(self) -> bytes:
        """The file."""
        images = []
        for k, picture in enumerate(self._pictures):
            kind = "png" if picture.startswith(b"\x89PNG") else "jpeg"
            images.append({"bufferView": self._view(picture, {}), "mimeType": f"image/{kind}"})
            dull = {"baseColorTexture": {"index": k}, "metallicFactor": 0, "roughnessFactor": 0.8}
            self._lists["materials"].append({"pbrMetallicRoughness": dull})
        count = len(self._lists["nodes"])
        root = {"children": list(range(count)), "matrix": Z_UP_FROM_Y_UP.ravel().tolist()}
        document = {
            "asset": {"version": "2.0", "generator": "sdgen"},
            "extensionsUsed": ["KHR_mesh_quantization"],
            "extensionsRequired": ["KHR_mesh_quantization"],
            "scene": 0,
            "scenes": [{"nodes": [count]}],
            **self._lists,
            "nodes": [*self._lists["nodes"], root],
            "textures": [{"source": k} for k in range(len(images))],
            "images": images,
            "buffers": [{"byteLength": len(self._blob)}],
        }
        text = json.dumps(document, separators=(",", ":")).encode()
        text += b" " * (-len(text) % 4)
        total = 12 + 8 + len(text) + 8 + len(self._blob)
        return b"".join(
            (
                struct.pack("<4sII", b"glTF", 2, total),
                struct.pack("<I4s", len(text), b"JSON"),
                text,
                struct.pack("<I4s", len(self._blob), b"BIN\0"),
                self._blob,
            )
        )
