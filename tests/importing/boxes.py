"""A small asset folder, made here: a mug-like box, and a cupboard with a door and a lamp in it."""

from __future__ import annotations

import io
import json
from pathlib import Path

import numpy as np
import trimesh
import yaml
from PIL import Image
from sdgen.importing.glb_file import model_glb
from sdgen.library.meshes import MeshData

CUPBOARD = {
    "id": "cupboard",
    "category": "wall_cabinet",
    "licence": "CC-BY-4.0",
    "source": "test",
    "extents_m": [0.3, 0.4, 0.5],
    "mass_kg": 9.0,
    "mesh": "meshes/cupboard.glb",
    "hulls": "meshes/cupboard.hulls.json",
    "texture": "textures/cupboard.jpg",
    "parts": [
        {"name": "body", "faces": 12},
        {"name": "door", "faces": 12, "joint": "door", "texture": "textures/door.png"},
        {"name": "lamp", "faces": 12, "rgba": [1.7, 1.7, 1.7, 1.0]},
    ],
    "joints": [
        {
            **{"name": "door", "type": "revolute", "origin_m": [0.15, 0.2, 0.0]},
            **{"axis": [0, 0, 1], "lower": 0.0, "upper": 1.5},
        }
    ],
    "variants": {"default": ["body", "door", "lamp"]},
    "states": [
        {"state": "CLOSED", "joint": "door", "max": 0.03, "parts": ["door"]},
        {"state": "OPEN", "joint": "door", "min": 0.3, "parts": ["body"]},
        {"state": "EMPTY", "variants": ["default"], "parts": ["body"]},
    ],
    "supports": [
        {
            **{"name": "shelf", "part": "body", "z_m": 0.5, "container": "inside"},
            "polygon_m": [[-0.1, -0.1], [0.1, -0.1], [0.1, 0.1], [-0.1, 0.1]],
        }
    ],
    "containers": [
        {
            **{"name": "inside", "part": "body", "closed_by": "door"},
            **{"center_m": [0, 0, 0.25], "size_m": [0.2, 0.3, 0.4]},
        }
    ],
}
MUG = {
    "id": "mug_a",
    "category": "mug",
    "title": "on",
    "licence": "CC-BY-4.0",
    "source": "test",
    "extents_m": [0.08, 0.08, 0.1],
    "mass_kg": 0.3,
    "mesh": "meshes/mug_a.glb",
    "hulls": "meshes/mug_a.hulls.json",
    "texture": "textures/mug_a.jpg",
    "parts": [{"name": "body", "faces": 12}],
    "variants": {"default": ["body"]},
}


def box(low: tuple[float, ...], high: tuple[float, ...], tiles: float = 1.0) -> MeshData:
    """A box whose sides lie apart in the texture, three by two, ``tiles`` times over."""
    solid = trimesh.creation.box(bounds=[low, high])
    corners = solid.vertices[solid.faces].reshape(-1, 3)
    normals = np.repeat(solid.face_normals, 3, axis=0)
    axis = np.abs(normals).argmax(axis=1)
    side = axis + 3 * (normals[np.arange(len(axis)), axis] > 0)
    share = (corners - low) / (np.array(high) - low)
    flat = np.array([share[k][[i for i in range(3) if i != a]] for k, a in enumerate(axis)])
    uvs = (np.c_[side % 3, side // 3] + 0.05 + 0.9 * flat) / [3, 2] * tiles
    return MeshData(corners, normals, uvs, np.arange(len(corners)).reshape(-1, 3))


def picture(kind: str, seed: int, side: int = 64) -> bytes:
    """A texture of warm, mottled colours."""
    rng = np.random.default_rng(seed)
    pixels = rng.normal([200, 150, 110], 12, (side, side, 3)).clip(0, 255).astype(np.uint8)
    out = io.BytesIO()
    Image.fromarray(pixels).save(out, kind)
    return out.getvalue()


def pieces(**boxes: MeshData) -> str:
    """Collision pieces: each part's corners."""
    listed = [
        {"part": name, "vertices_m": np.unique(mesh.vertices, axis=0).tolist()}
        for name, mesh in boxes.items()
    ]
    return json.dumps({"pieces": listed})


def write_library(folder: Path) -> Path:
    """The two models as an asset folder."""
    for name in ("meshes", "textures"):
        (folder / name).mkdir(parents=True)
    mug = {"body": box((-0.04, -0.04, 0), (0.04, 0.04, 0.1))}
    cupboard = {
        "body": box((-0.15, -0.2, 0), (0.13, 0.2, 0.5)),
        "door": box((0.13, -0.2, 0), (0.15, 0.2, 0.5), tiles=2.0),
        "lamp": box((0, 0, 0.4), (0.05, 0.05, 0.45)),
    }
    for name, meshes in (("mug_a", mug), ("cupboard", cupboard)):
        (folder / f"meshes/{name}.glb").write_bytes(model_glb(meshes, f"../textures/{name}.jpg"))
        (folder / f"meshes/{name}.hulls.json").write_text(pieces(**meshes))
        (folder / f"textures/{name}.jpg").write_bytes(picture("JPEG", len(name)))
    (folder / "textures/door.png").write_bytes(picture("PNG", 3))
    head = "# my things\n# for tests\n"
    text = yaml.safe_dump({"assets": [MUG, CUPBOARD], "surfaces": []}, sort_keys=False)
    (folder / "manifest.yaml").write_text(head + text)
    return folder
