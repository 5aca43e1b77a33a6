"""Writes a model's meshes as GLB: a node a part, the texture beside it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from sdgen.geometry import Z_UP_FROM_Y_UP
from sdgen.library.meshes import MeshData


def model_glb(meshes: Mapping[str, MeshData], texture: str) -> bytes:
    """The GLB of a model's parts, Y up as glTF is; ``texture`` is where its picture lies, as seen
    from the file. Any viewer shows it."""
    import trimesh

    scene: Any = trimesh.Scene(base_frame="model")
    looks: Any = trimesh.visual
    material = looks.material.PBRMaterial(name="texture", metallicFactor=0.0, roughnessFactor=0.8)
    for part, mesh in meshes.items():
        scene.add_geometry(
            trimesh.Trimesh(
                vertices=mesh.vertices @ Z_UP_FROM_Y_UP[:3, :3],
                faces=mesh.faces,
                vertex_normals=mesh.normals @ Z_UP_FROM_Y_UP[:3, :3],
                visual=looks.TextureVisuals(uv=mesh.uvs, material=material),
                process=False,
            ),
            node_name=part,
            geom_name=part,
        )

    def with_picture(tree: dict[str, Any]) -> None:
        tree["images"] = [{"uri": texture}]
        tree["textures"] = [{"source": 0}]
        for one in tree.get("materials", []):
            one.setdefault("pbrMetallicRoughness", {})["baseColorTexture"] = {"index": 0}

    data: bytes = scene.export(
        file_type="glb", tree_postprocessor=with_picture, include_normals=True
    )
    return data
