import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from sdgen.cameras.pinhole import project
from sdgen.render.opengl import (
    depth_from_buffer,
    projection_matrix,
    scaled,
    to_millimetres,
    view_matrix,
)

from tests.fakes import camera_at

coordinate = st.floats(-5, 5)


@given(st.tuples(coordinate, coordinate, coordinate))
def test_opengl_matrices_agree_with_k(point: tuple[float, float, float]) -> None:
    """The clip coordinates of any tile give the pixel that K gives."""
    camera = camera_at((0.1, -7.0, 1.3), (0.0, 0.0, 0.7))
    pixels, depth = project(camera, np.array([point]))
    view = np.reshape(view_matrix(np.asarray(camera.world_from_camera)), (4, 4)).T
    for factor in (1, 2):
        k = scaled(np.asarray(camera.K), factor)
        x0, y0, width, height = 64, 32, 500, 400
        lens = projection_matrix(k, x0, y0, width, height, camera.near_m, camera.far_m)
        clip = np.reshape(lens, (4, 4)).T @ view @ [*point, 1.0]
        u = (clip[0] / clip[3] + 1) / 2 * width + x0 - 0.5
        v = (1 - clip[1] / clip[3]) / 2 * height + y0 - 0.5
        centre = factor * (pixels[0] + 0.5) - 0.5
        assert [u, v] == pytest.approx(centre, abs=1e-6)
        buffer = (clip[2] / clip[3] + 1) / 2
        found = depth_from_buffer(np.array([buffer]), camera.near_m, camera.far_m)
        assert found == pytest.approx(depth, rel=1e-6)


def test_millimetres_round_and_leave_out_what_does_not_fit() -> None:
    depth = np.array([0.0004, 1.2344, 1.2346, 65.535, 65.6, 2.0])
    seen = np.array([True, True, True, True, True, False])
    assert to_millimetres(depth, seen).tolist() == [0, 1234, 1235, 65535, 0, 0]
