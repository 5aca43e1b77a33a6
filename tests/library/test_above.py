"""Space seen from above: collision pieces, and what they leave out of what is drawn."""

import numpy as np
import pytest
import shapely
from sdgen.library.above import seen_from_above, with_left_out
from sdgen.library.meshes import MeshData
from sdgen.library.reaching import STANDS_OUT_M

from tests.shipped import shipped_library

LIBRARY = shipped_library()


def box(low, high):
    """A box's mesh and corners."""
    corners = np.array(
        [
            [x, y, z]
            for x in (low[0], high[0])
            for y in (low[1], high[1])
            for z in (low[2], high[2])
        ],
        dtype=float,
    )
    quads = ((0, 1, 3, 2), (4, 5, 7, 6), (0, 1, 5, 4), (2, 3, 7, 6), (0, 2, 6, 4), (1, 3, 7, 5))
    faces = np.array([t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))])
    return MeshData(corners, np.zeros((8, 3)), np.zeros((8, 2)), faces), corners


def covers(space, point):
    ends = [*space.starts[1:].tolist(), len(space.points_m)]
    return any(
        low <= point[2] <= high
        and shapely.Polygon(space.points_m[a:b]).covers(shapely.Point(point[:2]))
        for a, b, low, high in zip(
            space.starts.tolist(), ends, space.low_m, space.high_m, strict=True
        )
    )


def test_an_arm_that_no_piece_covers_takes_space_and_a_moulding_does_not():
    post, corners = box((-0.05, -0.05, 0.0), (0.05, 0.05, 1.5))
    arm, _ = box((0.05, -0.02, 1.4), (0.8, 0.02, 1.44))
    pieces = seen_from_above([corners])
    space = with_left_out(pieces, [post, arm])
    for x in (0.2, 0.45, 0.79):
        assert covers(space, (x, 0.0, 1.42))
        assert not covers(pieces, (x, 0.0, 1.42))
        assert not covers(space, (x, 0.0, 1.3)), "no more than the arm"


def test_a_moulding_widens_the_piece_it_is_on():
    post, corners = box((-0.05, -0.05, 0.0), (0.05, 0.05, 1.5))
    moulding, _ = box((-0.07, -0.07, -0.01), (0.07, 0.07, 0.1))
    pieces = seen_from_above([corners])
    space = with_left_out(pieces, [post, moulding])
    assert len(space.starts) == len(pieces.starts)
    assert covers(space, (0.069, -0.069, -0.005))
    assert not covers(space, (0.075, 0.0, 0.05))
    assert np.array_equal(with_left_out(pieces, [post]).points_m, pieces.points_m)


@pytest.mark.parametrize(
    "category", ["floor_lamp", "coat_rack", "crib", "armchair", "sofa", "ottoman"]
)
def test_all_that_is_drawn_of_what_is_framed_takes_space(category):
    for asset in LIBRARY.by_category(category):
        space = LIBRARY.above(asset.id, asset.variants["default"])
        for part in asset.variants["default"]:
            low, high = LIBRARY.bounds(asset.id)[part]
            assert space.low_m.min() <= low[2] + STANDS_OUT_M
            assert space.high_m.max() >= high[2] - STANDS_OUT_M
            assert (space.points_m.min(axis=0) <= low[:2] + STANDS_OUT_M).all(), asset.id
            assert (space.points_m.max(axis=0) >= high[:2] - STANDS_OUT_M).all(), asset.id
