"""What furniture keeps clear: sights of openings by place and height, the floor before a piece."""

import math

import pytest
from sdgen.home.clearances import FRONT_INSET_M, WINDOW_SIGHT_M, front_of, sight_of
from sdgen.scene import Opening
from shapely.geometry import box

from tests.facts.scenes import INFOS

WINDOW = Opening(
    object_id=9,
    kind="window",
    room_ids=(1,),
    center_m=(2.0, 0.0, 0.9),
    along="x",
    width_m=1.2,
    height_m=1.2,
)


@pytest.mark.parametrize(
    ("y0", "low_m", "high_m", "hidden"),
    [
        (0.06, 0.0, 2.0, True),  # a wardrobe against its wall
        (0.06, 0.0, 0.9, False),  # a dresser as high as the sill
        (0.06, 0.0, 0.95, True),
        (0.06, 2.1, 2.4, False),  # above it
        (WINDOW_SIGHT_M + 0.01, 0.0, 2.0, False),  # away from its wall
    ],
)
def test_a_window_is_hidden_by_what_stands_before_it(y0, low_m, high_m, hidden):
    shape = box(1.8, y0, 2.2, y0 + 0.4)
    assert sight_of(WINDOW).hidden_by(shape, low_m, high_m) is hidden


def test_what_stands_beside_a_window_hides_nothing():
    assert not sight_of(WINDOW).hidden_by(box(2.61, 0.06, 3.0, 0.4), 0.0, 2.0)


def test_the_floor_before_a_piece_turns_with_it():
    sofa = INFOS["sofa"]  # 0.9 deep, 2.0 wide
    assert front_of(sofa, (0.0, 0.0, 0.0, 0.0), 0.0) is None
    ahead = front_of(sofa, (0.0, 0.0, 0.0, 0.0), 0.5)
    wide = 1.0 - FRONT_INSET_M
    assert ahead.bounds == pytest.approx((0.45, -wide, 0.95, wide))
    turned = front_of(sofa, (1.0, 2.0, 0.0, math.pi / 2), 0.5)
    assert turned.bounds == pytest.approx((1.0 - wide, 2.45, 1.0 + wide, 2.95))
