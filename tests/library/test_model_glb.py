"""A model written as one GLB, read back by our own strict reader and by trimesh."""

import io
from pathlib import Path

import numpy as np
import pytest
import trimesh
from sdgen.library.meshes import read_glb
from sdgen.library.model_glb import model_glb

from tests.shipped import shipped_library


@pytest.mark.parametrize("asset_id", ["stove_01", "fridge_01", "tea_light_01"])
def test_a_model_comes_back_as_it_was(asset_id: str) -> None:
    library = shipped_library()
    asset = library.assets[asset_id]
    found = read_glb(Path("made.glb"), asset, model_glb(library, asset_id))
    assert found.keys() == library.mesh(asset_id).keys()
    for part, mesh in library.mesh(asset_id).items():
        np.testing.assert_allclose(found[part].vertices, mesh.vertices, atol=1e-6)
        np.testing.assert_allclose(found[part].uvs, mesh.uvs, atol=1e-6)
        np.testing.assert_allclose(found[part].normals, mesh.normals, atol=0.02)
        np.testing.assert_array_equal(found[part].faces, mesh.faces)


def test_it_carries_its_texture_once_and_stands_upright() -> None:
    library = shipped_library()
    raw = model_glb(library, "fridge_01")
    scene = trimesh.load_scene(io.BytesIO(raw), file_type="glb", process=False)
    assert scene.extents[1] == pytest.approx(
        library.info("fridge_01").extents_m[2], abs=0.01
    )  # Y up
    texture = library.file("fridge_01", library.assets["fridge_01"].texture).read_bytes()
    assert raw.count(texture) == 1
    for mesh in scene.geometry.values():
        assert mesh.visual.material.baseColorTexture.size[0] > 1
    assert len(raw) < 200_000
