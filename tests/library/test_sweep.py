"""Where leaves and lids go: as far as people need, by what is drawn."""

import math

import numpy as np
import pytest
from sdgen.library.sweep import OPEN_RAD, PLAY_M, SURE_M, Reach

from tests.fakes import fake_library
from tests.shipped import shipped_library

LIBRARY = shipped_library()


@pytest.fixture
def fakes(tmp_path):
    return fake_library(tmp_path / "assets")


def test_a_leaf_goes_a_quarter_round_its_hinge(fakes):
    """A leaf 0.6 m wide and 3 cm thick, hinged at x 0.3, y 0.3, that could open to 2 rad."""
    way = fakes.way("cabinet_01")
    assert len(way.starts) == math.ceil(OPEN_RAD / math.radians(10))
    (x0, y0), (x1, y1) = way.points_m.min(axis=0), way.points_m.max(axis=0)
    assert x1 == pytest.approx(0.3 + math.hypot(0.6, 0.03), abs=0.01)
    assert (x0, y0) == pytest.approx((0.3, -0.3), abs=2 * PLAY_M)
    assert y1 == pytest.approx(0.33, abs=2 * PLAY_M), "its thickness, to the hinge's side"
    assert way.low_m.tolist() == [PLAY_M] * len(way.starts)
    assert fakes.reach("cabinet_01") == pytest.approx(
        Reach(left_m=0.03 - PLAY_M + SURE_M), abs=1e-6
    )
    assert fakes.way("table_01") is None
    assert fakes.reach("table_01") == Reach()


def test_a_lid_that_tilts_over_its_back_needs_room_behind_and_a_drawer_comes_out():
    lids = [LIBRARY.reach(a.id).back_m for a in LIBRARY.by_category("ottoman") if a.joints]
    assert len(lids) > 0
    assert min(lids) > 0.05
    assert LIBRARY.reach("child_bed_05").left_m == pytest.approx(0.4, abs=0.01)
    for asset in LIBRARY.by_category("dresser"):
        way = LIBRARY.way(asset.id)
        slides = [j.upper for j in asset.joints if j.type == "prismatic"]
        if way is not None and slides:
            assert way.points_m[:, 0].max() >= asset.extents_m[0] / 2 + max(slides) - 0.05


def test_all_that_opens_has_a_way():
    for asset in LIBRARY.assets.values():
        if asset.joints:
            way = LIBRARY.way(asset.id)
            assert way is not None, asset.id
            assert np.isfinite(way.points_m).all()
            assert (way.low_m < way.high_m).all()
