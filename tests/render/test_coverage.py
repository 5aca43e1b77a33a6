import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from sdgen.render.coverage import clip_near, coverage

K = np.array([[100.0, 0, 31.5], [0, 100.0, 23.5], [0, 0, 1]])


def covered(
    triangles: np.ndarray, k: np.ndarray, width: int, height: int, near_m: float
) -> np.ndarray:
    """Pixels (H, W) of the whole picture that the triangles cover."""
    mask = np.zeros((height, width), dtype=bool)
    part, rows, columns = coverage(triangles, k, width, height, near_m)
    mask[rows, columns] = part
    return mask


def triangle(*pixels: tuple[float, float], depth: float = 2.0) -> np.ndarray:
    """A camera-frame triangle with these corners in the picture."""
    corners = [((u - 31.5) / 100 * depth, (v - 23.5) / 100 * depth, depth) for u, v in pixels]
    return np.array([corners])


def test_a_rectangle_covers_the_pixels_whose_centres_it_holds() -> None:
    a, b, c, d = (9.5, 4.5), (9.5, 14.5), (29.5, 14.5), (29.5, 4.5)
    quad = np.concatenate([triangle(a, b, c), triangle(a, c, d)])
    mask = covered(quad, K, 64, 48, 0.05)
    assert mask.sum() == 20 * 10
    assert mask[5:15, 10:30].all()


def test_back_faces_and_what_is_behind_cover_nothing() -> None:
    front = triangle((10, 5), (10, 15), (30, 15))
    assert covered(front, K, 64, 48, 0.05).any()
    assert not covered(front[:, ::-1], K, 64, 48, 0.05).any()
    assert not covered(front - [0, 0, 4.0], K, 64, 48, 0.05).any()
    assert not covered(np.empty((0, 3, 3)), K, 64, 48, 0.05).any()


@given(st.lists(st.floats(-3, 3), min_size=9, max_size=9))
def test_clipping_keeps_what_lies_beyond_the_plane(values: list[float]) -> None:
    """Area beyond the near plane is what is left, whatever the number of corners inside."""
    before = np.reshape(values, (1, 3, 3))
    after = clip_near(before, 0.5)
    assert (after[:, :, 2] >= 0.5 - 1e-9).all()
    assert _area(after) <= _area(before) + 1e-9
    share = _sampled_share_beyond(before[0], 0.5)
    assert _area(after) == pytest.approx(share * _area(before), abs=0.03 * _area(before) + 1e-9)


def _area(triangles: np.ndarray) -> float:
    cross = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    return float(np.linalg.norm(cross, axis=-1).sum() / 2)


def _sampled_share_beyond(corners: np.ndarray, near: float) -> float:
    steps = (np.arange(400) + 0.5) / 400
    u, v = np.meshgrid(steps, steps)
    u, v = u[u + v < 1], v[u + v < 1]
    z = corners[0, 2] * (1 - u - v) + corners[1, 2] * u + corners[2, 2] * v
    return float((z >= near - 1e-9).mean())


def test_the_cut_out_mask_is_the_whole_one_without_its_empty_rim() -> None:
    shape = triangle((-20.0, 10.0), (30.0, 40.0), (50.0, -9.0))[:, ::-1]
    shape = shape if covered(shape, K, 64, 48, 0.05).any() else shape[:, ::-1]
    mask = covered(shape, K, 64, 48, 0.05)
    part, rows, columns = coverage(shape, K, 64, 48, 0.05)
    assert part.sum() == mask.sum() > 0
    assert np.array_equal(mask[rows, columns], part)
    assert part[0].any()
    assert part[:, 0].any()
    assert part[-1].any()
    assert part[:, -1].any()
