"""Writing a model: GLB (a node per part), JPEG, and the record assemble.py merges."""

from __future__ import annotations

import json
import math
import struct
from pathlib import Path

import bpy
import numpy as np
from PIL import Image

from .model import Model
from .uv_bake import face_attribute


class Frame:
    """Maker's coordinates -> the contract's: front to +X, origin at the bottom centre."""

    def __init__(self, model: Model):
        self.turn = {"+x": 0.0, "-y": math.pi / 2, "-x": math.pi, "+y": -math.pi / 2}[model.front]
        c, s = round(math.cos(self.turn)), round(math.sin(self.turn))
        self.matrix = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1.0]])
        points = np.concatenate(
            [
                m.v[sorted({i for f in m.f for i in f})]
                for n in model.default_parts
                for m in model.parts[n].meshes
            ]
        )
        points = points @ self.matrix.T
        low, high = points.min(0), points.max(0)
        self.origin = np.array([(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, low[2]])
        self.extents = high - low

    def points(self, p) -> np.ndarray:
        return np.asarray(p, float) @ self.matrix.T - self.origin

    def directions(self, d) -> np.ndarray:
        return np.asarray(d, float) @ self.matrix.T

    def sizes(self, s) -> np.ndarray:
        return np.abs(np.asarray(s, float) @ self.matrix.T)


def triangles(obj) -> dict[str, np.ndarray]:
    """Per triangle corner: position, normal, UV; per triangle: part number."""
    evaluated = obj.evaluated_get(bpy.context.evaluated_depsgraph_get())
    data = evaluated.to_mesh()
    data.calc_loop_triangles()
    data.calc_normals_split()
    count = len(data.loop_triangles)

    def read(items, name, length, kind):
        out = np.zeros(length, kind)
        items.foreach_get(name, out)
        return out

    loops = read(data.loop_triangles, "loops", count * 3, int)
    polygon = read(data.loop_triangles, "polygon_index", count, int)
    vertex = read(data.loops, "vertex_index", len(data.loops), int)
    positions = read(data.vertices, "co", len(data.vertices) * 3, float).reshape(-1, 3)
    normals = read(data.loops, "normal", len(data.loops) * 3, float).reshape(-1, 3)
    uv = read(data.uv_layers["bake"].data, "uv", len(data.loops) * 2, float).reshape(-1, 2)
    baked = read(obj.data.uv_layers["bake"].data, "uv", len(data.loops) * 2, float).reshape(-1, 2)
    if np.abs(uv - baked).max() > 0.004:  # the evaluated copy can lag behind the last rescaling
        uv = baked
    result = {
        "p": positions[vertex[loops]].reshape(-1, 3, 3),
        "n": normals[loops].reshape(-1, 3, 3),
        "t": uv[loops].reshape(-1, 3, 2),
        "part": face_attribute(data, "part")[polygon],
    }
    evaluated.to_mesh_clear()
    area = np.linalg.norm(
        np.cross(result["p"][:, 1] - result["p"][:, 0], result["p"][:, 2] - result["p"][:, 0]),
        axis=1,
    )
    solid = area > 1e-12
    return {k: v[solid] for k, v in result.items()}


def write_glb(path: Path, parts: dict[str, dict[str, np.ndarray]], texture_uri: str) -> None:
    """glTF 2.0, Y up as its specification says: (x, y, z) here becomes (x, z, -y)."""
    views, accessors, meshes, nodes, blob = [], [], [], [], b""

    def add(array: np.ndarray, kind: str, component: int, target: int, bounds: bool = False) -> int:
        nonlocal blob
        raw = array.tobytes()
        views.append(
            {"buffer": 0, "byteOffset": len(blob), "byteLength": len(raw), "target": target}
        )
        blob += raw + b"\0" * (-len(raw) % 4)
        accessor = {
            "bufferView": len(views) - 1,
            "componentType": component,
            "count": len(array),
            "type": kind,
        }
        if bounds:
            accessor |= {"min": array.min(0).tolist(), "max": array.max(0).tolist()}
        accessors.append(accessor)
        return len(accessors) - 1

    for name, data in parts.items():
        p = data["p"].reshape(-1, 3)[:, [0, 2, 1]] * [1, 1, -1]
        n = data["n"].reshape(-1, 3)[:, [0, 2, 1]] * [1, 1, -1]
        t = data["t"].reshape(-1, 2) * [1, -1] + [0, 1]
        key = np.round(np.c_[p * 1e6, n * 100, t * 4e4]).astype(int)
        _, first, index = np.unique(key, axis=0, return_index=True, return_inverse=True)
        attributes = {
            "POSITION": add(p[first].astype("<f4"), "VEC3", 5126, 34962, bounds=True),
            "NORMAL": add(n[first].astype("<f4"), "VEC3", 5126, 34962),
            "TEXCOORD_0": add(t[first].astype("<f4"), "VEC2", 5126, 34962),
        }
        indices = add(index.ravel().astype("<u2"), "SCALAR", 5123, 34963)
        meshes.append(
            {
                "name": name,
                "primitives": [{"attributes": attributes, "indices": indices, "material": 0}],
            }
        )
        nodes.append({"name": name, "mesh": len(meshes) - 1})
    surface = {"baseColorTexture": {"index": 0}, "metallicFactor": 0, "roughnessFactor": 0.8}
    document = {
        "asset": {"version": "2.0", "generator": "sdgen"},
        "scene": 0,
        "scenes": [{"nodes": list(range(len(nodes)))}],
        "nodes": nodes,
        "meshes": meshes,
        "materials": [{"pbrMetallicRoughness": surface}],
        "textures": [{"source": 0}],
        "images": [{"uri": texture_uri}],
        "bufferViews": views,
        "accessors": accessors,
        "buffers": [{"byteLength": len(blob)}],
    }
    text = json.dumps(document, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    total = 12 + 8 + len(text) + 8 + len(blob)
    header = struct.pack("<III", 0x46546C67, 2, total) + struct.pack("<II", len(text), 0x4E4F534A)
    path.write_bytes(header + text + struct.pack("<II", len(blob), 0x004E4942) + blob)


def write_jpeg(path: Path, pixels: np.ndarray) -> None:
    """Less than half a PNG's bytes; full colour resolution, or red letters on white would blur."""
    Image.fromarray(pixels).save(path, quality=90, subsampling=0, optimize=True)


def _rounded(values) -> list[float]:
    return [round(float(v), 4) + 0.0 for v in np.asarray(values, float)]


def record(
    model: Model, frame: Frame, asset_id: str, category: str, source: str, faces: dict[str, int]
) -> dict:
    """The manifest entry, plus `collision` for assemble.py; all in the contract's frame."""
    parts, collision = [], {}
    for name, part in model.parts.items():
        entry: dict = {"name": name, "faces": faces[name]}
        if part.joint:
            entry["joint"] = part.joint
        if part.rgba:
            entry["rgba"] = [float(v) for v in part.rgba]
        if part.open:
            entry["open"] = True
        parts.append(entry)
        if isinstance(part.collision, str):
            collision[name] = part.collision
        else:
            collision[name] = [
                [_rounded(p) for p in frame.points(piece)] for piece in part.collision
            ]
    joints = [
        {
            "name": name,
            "type": j.type,
            "origin_m": _rounded(frame.points(j.origin)),
            "axis": _rounded(frame.directions(j.axis)),
            "lower": j.lower,
            "upper": round(j.upper, 4),
        }
        for name, j in model.joints.items()
    ]
    supports = []
    for s in model.supports:
        corners = frame.points([(x, y, s.z) for x, y in s.polygon])
        supports.append(
            {
                "name": s.name,
                "part": s.part,
                "z_m": round(float(corners[0][2]), 4),
                "polygon_m": [_rounded(c[:2]) for c in corners],
                "headroom_m": None if s.headroom is None else round(s.headroom, 4),
                "container": s.container,
            }
        )
    containers = [
        {
            "name": c.name,
            "part": c.part,
            "center_m": _rounded(frame.points(c.center)),
            "size_m": _rounded(frame.sizes(c.size)),
            "closed_by": c.closed_by,
        }
        for c in model.containers
    ]
    return {
        "id": asset_id,
        "category": category,
        "title": model.title,
        "licence": "CC-BY-4.0",
        "source": source,
        "extents_m": _rounded(frame.extents),
        "mass_kg": round(model.mass, 4),
        "friction": model.friction,
        "mesh": f"meshes/{asset_id}.glb",
        "hulls": f"meshes/{asset_id}.hulls.json",
        "texture": f"textures/{asset_id}.jpg",
        "parts": parts,
        "joints": joints,
        "variants": model.variants,
        "states": model.states,
        "supports": supports,
        "containers": containers,
        "collision": collision,
    }
