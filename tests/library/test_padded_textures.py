"""Textures lie over padded seats and mattresses as cloth does: drawn out to a point they would
show a star."""

from __future__ import annotations

import numpy as np
import pytest
from sdgen.geometry import Array
from sdgen.library.meshes import MeshData
from sdgen.library.records import Support

from tests.shipped import shipped_library

LIBRARY = shipped_library()
#: Faces within this of a support's level are its, metres; they look up.
NEAR_M, UP = 0.03, 0.9
#: A texture is drawn out that is so many times as long as wide, and how much of a seat may be so.
DRAWN_OUT, SHARE = 3.0, 0.15


def drawn_out(mesh: MeshData, support: Support) -> float:
    """The share of a support's area whose texture is drawn out."""
    corners = np.asarray(mesh.vertices, dtype=np.float64)[mesh.faces]
    uvs = np.asarray(mesh.uvs, dtype=np.float64)[mesh.faces]
    sides, turned = corners[:, 1:] - corners[:, :1], uvs[:, 1:] - uvs[:, :1]
    normals = np.cross(sides[:, 0], sides[:, 1])
    area = np.linalg.norm(normals, axis=1)
    level = np.abs(corners[:, :, 2].mean(axis=1) - support.z_m) < NEAR_M
    level &= (area > 1e-7) & (normals[:, 2] > UP * area)
    sides, turned, area = sides[level], turned[level], area[level]
    normals = normals[level] / area[:, None]
    x = sides[:, 0] / np.linalg.norm(sides[:, 0], axis=1, keepdims=True)
    axes: Array = np.stack([x, np.cross(normals, x)], axis=2)
    scales = np.linalg.svd(np.linalg.solve(sides @ axes, turned), compute_uv=False)
    return float(area[scales[:, 0] > DRAWN_OUT * scales[:, 1]].sum() / area.sum())


@pytest.mark.parametrize("category", ["armchair", "sofa", "bed"])
def test_no_seat_or_mattress_has_a_star(category: str) -> None:
    looked = 0
    for model in LIBRARY.by_category(category):
        for support in LIBRARY.info(model.id).supports:
            if support.name.startswith(("seat", "top")):
                mesh = LIBRARY.mesh(model.id)[support.part]
                assert drawn_out(mesh, support) < SHARE, f"{model.id} {support.name}"
                looked += 1
    assert looked >= 8
