"""Small downloads in the layouts of their sources, made of boxes and balls of our own."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import trimesh
from PIL import Image

#: Left half red, right half green.
HALVES = np.zeros((64, 64, 3), np.uint8)
HALVES[:, :32] = (220, 30, 30)
HALVES[:, 32:] = (30, 200, 40)


def picture(path: Path, pixels: np.ndarray = HALVES) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    Image.fromarray(pixels).save(path)


def obj(
    path: Path,
    size: tuple[float, float, float] = (0.07, 0.16, 0.21),
    material: str | None = "textured.mtl",
    dense: bool = False,
) -> None:
    """A box or, ``dense``, a ball of 5,120 faces, base at 0; red where x is below the middle."""
    path.parent.mkdir(parents=True, exist_ok=True)
    mesh = trimesh.creation.icosphere(subdivisions=4) if dense else trimesh.creation.box()
    low, high = mesh.bounds
    vertices = (mesh.vertices - low) / (high - low) * size - np.array([size[0] / 2, size[1] / 2, 0])
    u = np.where(vertices[:, 0] < 0, 0.2, 0.8)
    lines = [f"mtllib {material}", "usemtl m"] if material else []
    lines += [f"v {x:.6f} {y:.6f} {z:.6f}" for x, y, z in vertices]
    lines += [f"vt {a:.4f} 0.5" for a in u]
    lines += [f"f {a}/{a} {b}/{b} {c}/{c}" for a, b, c in mesh.faces + 1]
    path.write_text("\n".join(lines) + "\n")
    if material and "/" not in material:
        (path.parent / material).write_text("newmtl m\nmap_Kd texture_map.png \n")


def ycb(root: Path, name: str = "003_cracker_box", dense: bool = False) -> Path:
    folder = root / name / "google_16k"
    obj(folder / "textured.obj", dense=dense)
    picture(folder / "texture_map.png")
    return root


def gso(root: Path, name: str = "Room_Essentials_Mug_White_Yellow") -> Path:
    folder = root / name
    obj(folder / "meshes" / "model.obj", (0.12, 0.09, 0.1), "model.mtl", dense=True)
    (folder / "meshes" / "model.mtl").write_text("newmtl m\nmap_Kd texture.png\n")
    picture(folder / "materials" / "textures" / "texture.png")
    (folder / "metadata.pbtxt").write_text('categories {\n  first: "Consumer Goods"\n}\n')
    return root


def replicacad(root: Path, name: str = "frl_apartment_table_01") -> Path:
    """A table of a top and four legs, Y up as GLB is, with a receptacle on it."""
    parts = [
        trimesh.creation.box(
            (1.4, 0.04, 0.8), trimesh.transformations.translation_matrix((0, 0.72, 0))
        )
    ]
    for x in (-0.65, 0.65):
        for z in (-0.35, 0.35):
            at = trimesh.transformations.translation_matrix((x, 0.35, z))
            parts.append(trimesh.creation.box((0.06, 0.7, 0.06), at))
    mesh = trimesh.util.concatenate(parts)
    mesh.visual = trimesh.visual.TextureVisuals(
        uv=(mesh.vertices[:, [0, 2]] + 1) / 2,
        material=trimesh.visual.material.PBRMaterial(baseColorTexture=Image.fromarray(HALVES)),
    )
    (root / "objects").mkdir(parents=True, exist_ok=True)
    mesh.export(root / "objects" / f"{name}.glb")
    configs = root / "configs" / "objects"
    configs.mkdir(parents=True, exist_ok=True)
    box = {"position": [0.0, 0.85, 0.0], "scale": [0.69, 0.1, 0.39]}
    given = {
        "render_asset": f"../../objects/{name}.glb",
        "mass": 18,
        "user_defined": {"receptacle_aabb_top": box},
    }
    (configs / f"{name}.object_config.json").write_text(json.dumps(given))
    return root


def fantastic_breaks(root: Path) -> Path:
    """A cup as a ball, and most of it; normalised, 9 cm large by its transform."""
    folder = root / "05" / "00012"
    folder.mkdir(parents=True)
    whole = trimesh.creation.icosphere(subdivisions=3, radius=0.5)
    whole.visual.vertex_colors = np.full((len(whole.vertices), 4), (30, 60, 200, 255), np.uint8)
    whole.export(folder / "model_c.ply")
    rest = whole.slice_plane((0, 0, 0.1), (0, 0, -1))
    rest.visual.vertex_colors = np.full((len(rest.vertices), 4), (30, 60, 200, 255), np.uint8)
    rest.export(folder / "model_b_0.ply")
    matrix = np.diag([0.09, 0.09, 0.09, 1.0])[None]
    np.savez(folder / "meta_0.npz", transform=matrix, mask=np.zeros(len(rest.vertices)))
    return root


CABINET = """<robot name="cabinet">
  <link name="base"><visual><geometry><mesh filename="body.obj"/></geometry></visual></link>
  <link name="leaf"><visual><origin xyz="0 0.2 0"/><geometry><box size="0.02 0.4 0.5"/></geometry>
    <material name="white"><color rgba="0.9 0.9 0.9 1"/></material></visual></link>
  <joint name="door hinge" type="revolute"><parent link="base"/><child link="leaf"/>
    <origin xyz="0.16 -0.2 0.25"/><axis xyz="0 0 1"/>
    <limit lower="-1.6" upper="0" effort="1" velocity="1"/></joint>
</robot>
"""


def cabinet(root: Path) -> Path:
    """A nightstand open to +X with a leaf before it, as URDF."""
    root.mkdir(parents=True, exist_ok=True)
    (root / "LICENSE").write_text("Creative Commons Attribution 4.0 International")
    boards = [
        ((0.3, 0.4, 0.02), (0, 0, 0.01)),
        ((0.3, 0.4, 0.02), (0, 0, 0.25)),
        ((0.3, 0.4, 0.02), (0, 0, 0.49)),
        ((0.3, 0.02, 0.5), (0, -0.19, 0.25)),
        ((0.3, 0.02, 0.5), (0, 0.19, 0.25)),
        ((0.02, 0.4, 0.5), (-0.14, 0, 0.25)),
    ]
    parts = [
        trimesh.creation.box(size, trimesh.transformations.translation_matrix(at))
        for size, at in boards
    ]
    trimesh.util.concatenate(parts).export(root / "body.obj")
    (root / "nightstand.urdf").write_text(CABINET)
    return root
