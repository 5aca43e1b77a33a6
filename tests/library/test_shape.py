"""Measures on meshes and hulls."""

import numpy as np
import pytest
import trimesh
from hypothesis import given, settings
from hypothesis import strategies as st
from sdgen.geometry import box_corners
from sdgen.library.shape import hull_volume, outside_share, see_through, surface_points


def triangles(mesh: trimesh.Trimesh) -> np.ndarray:
    return np.asarray(mesh.vertices)[np.asarray(mesh.faces)]


def test_closed_meshes_show_no_back_face() -> None:
    for mesh in (
        trimesh.creation.box((1, 2, 3)),
        trimesh.creation.icosphere(2),
        trimesh.creation.annulus(0.3, 0.5, 1.0),
    ):
        assert see_through(triangles(mesh)) == 0.0


def test_a_missing_side_is_seen_and_a_missing_bottom_is_not() -> None:
    mesh = trimesh.creation.box((1, 1, 1))
    for axis, seen in (((1, 0, 0), True), ((0, 0, 1), True), ((0, 0, -1), False)):
        kept = triangles(mesh)[mesh.face_normals @ axis < 0.9]
        assert (see_through(kept) > 0.1) is seen


def test_the_two_sides_of_a_leaf_are_no_hole() -> None:
    front = np.array([[(0, -1, 0), (0, 1, 0), (0, 0, 1.0)]])
    assert see_through(np.concatenate([front, front[:, ::-1]])) == 0.0
    assert see_through(front) == 1.0  # seen from behind


@settings(max_examples=25, deadline=None)
@given(st.integers(0, 10_000))
def test_points_are_spread_by_area(seed: int) -> None:
    rng = np.random.default_rng(seed)
    soup = rng.random((12, 3, 3))
    points, face = surface_points(soup, 4000)
    area = np.linalg.norm(np.cross(soup[:, 1] - soup[:, 0], soup[:, 2] - soup[:, 0]), axis=1)
    assert np.bincount(face, minlength=12) / 4000 == pytest.approx(area / area.sum(), abs=2e-3)
    normal = np.cross(soup[face, 1] - soup[face, 0], soup[face, 2] - soup[face, 0])
    assert np.abs(((points - soup[face, 0]) * normal).sum(axis=1)).max() < 1e-9
    low, high = soup[face].min(axis=1), soup[face].max(axis=1)
    assert ((points > low - 1e-9) & (points < high + 1e-9)).all()


def test_outside_share_and_volume() -> None:
    cube = box_corners((0, 0, 0), (1, 1, 1))
    points = np.array([(0.5, 0.5, 0.5), (1.05, 0.5, 0.5), (1.2, 0.5, 0.5), (3, 3, 3)])
    assert outside_share(points, [cube], 0.1) == 0.5
    assert outside_share(points, [cube, cube + 2.5], 0.1) == 0.25
    assert hull_volume(cube) == pytest.approx(1.0)
