"""Level surfaces and outlines of points."""

import numpy as np
import pytest
import shapely
from sdgen.perception.levels import levels_of, outline_of

RNG = np.random.default_rng(1)


def flat(z, size=(0.6, 0.4), n=3000, noise=0.0005, at=(2.0, -1.0)):
    xy = RNG.uniform(-0.5, 0.5, (n, 2)) * size + at
    return np.column_stack([xy, np.full(n, z) + RNG.normal(0, noise, n)]).astype(np.float32)


def none(points):
    return np.zeros(len(points), dtype=bool)


def test_shelves_are_levels_from_the_top_down():
    points = np.concatenate([flat(0.3), flat(0.8), flat(1.4, n=500)])
    found = levels_of(points, np.ones(len(points), bool), none(points))
    assert [level.z_m for level in found] == pytest.approx([1.4, 0.8, 0.3], abs=0.002)
    for level in found:
        assert level.outline.area == pytest.approx(0.24, rel=0.05)


def test_what_does_not_look_up_is_no_level():
    points = flat(0.8)
    assert levels_of(points, none(points), none(points)) == []


def test_a_slope_is_no_level():
    points = flat(0.8)
    points[:, 2] += 0.5 * (points[:, 0] - 2.0)  # 30 cm over its length
    found = levels_of(points, np.ones(len(points), bool), none(points))
    assert found == []


def test_an_outline_is_that_of_all_points():
    points = flat(0.8, n=5000)
    corners = np.array([[1.7, -1.2], [2.3, -1.2], [2.3, -0.8], [1.7, -0.8]])
    points[:4, :2] = corners
    rim = none(points)
    rim[:4] = True
    outline = outline_of(points, rim)
    assert outline.covers(shapely.Polygon(corners))
    assert outline.area == pytest.approx(0.24, rel=0.03)


@pytest.mark.parametrize("points", [[[1, 2, 3]], [[1, 2, 3], [1, 2, 4]], [[0, 0, 0], [1, 1, 0]]])
def test_a_point_or_a_line_has_an_area_all_the_same(points):
    outline = outline_of(np.array(points, dtype=np.float32), np.zeros(len(points), bool))
    assert outline.geom_type == "Polygon"
    assert outline.area > 0
