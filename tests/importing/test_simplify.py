"""Whatever a mesh is made of, it comes out within its budget, and in its shape."""

from __future__ import annotations

import numpy as np
import pytest
import trimesh
from hypothesis import given, settings
from hypothesis import strategies as st
from sdgen.importing.simplify import Solid, light


def solid(mesh: trimesh.Trimesh) -> Solid:
    return Solid(np.asarray(mesh.vertices, float), np.asarray(mesh.faces, np.int64))


SHAPES = {
    "fans of needles": trimesh.creation.cylinder(0.04, 0.1, sections=3000),
    "ball": trimesh.creation.icosphere(subdivisions=5, radius=0.05),
    "ring": trimesh.creation.torus(0.05, 0.01, major_sections=80, minor_sections=60),
    "crumbs": trimesh.util.concatenate(
        [
            trimesh.creation.box(
                (0.005, 0.005, 0.005), trimesh.transformations.translation_matrix((x, y, z))
            )
            for x in np.linspace(0, 0.1, 6)
            for y in np.linspace(0, 0.1, 6)
            for z in np.linspace(0, 0.1, 6)
        ]
    ),
}


@pytest.mark.parametrize("name", SHAPES)
def test_every_mesh_comes_out_within_the_budget(name: str) -> None:
    mesh = solid(SHAPES[name])
    (thin,) = light({"body": mesh}, 800).values()
    assert 12 <= len(thin.faces) <= 800
    assert np.isfinite(thin.vertices).all()
    size = np.ptp(mesh.vertices, axis=0)
    assert np.allclose(np.ptp(thin.vertices, axis=0), size, atol=0.04 * size.max())


@settings(max_examples=25, deadline=None)
@given(st.integers(0, 2**32 - 1), st.integers(900, 4000))
def test_soups_of_triangles_too(seed: int, count: int) -> None:
    rng = np.random.default_rng(seed)
    corners = rng.random((count, 1, 3)) + 0.05 * rng.random((count, 3, 3))
    soup = Solid(corners.reshape(-1, 3), np.arange(3 * count).reshape(-1, 3))
    (thin,) = light({"body": soup}, 800).values()
    assert len(thin.faces) <= 800
