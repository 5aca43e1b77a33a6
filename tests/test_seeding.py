"""Lanes are independent of one another and of the order they are used in."""

import numpy as np
import pytest
from sdgen.seeding import lane, unit_hash, weighted_keys


def test_a_lane_depends_on_seed_scene_and_name_only():
    first = lane(7, 3, "clutter").random(5)
    lane(7, 3, "another").random(100)
    assert np.array_equal(first, lane(7, 3, "clutter").random(5))
    for other in (lane(8, 3, "clutter"), lane(7, 4, "clutter"), lane(7, 3, "clutters")):
        assert not np.array_equal(first, other.random(5))


def test_zero_is_a_seed_like_any_other():
    assert not np.array_equal(lane(0, 0, "x").random(3), lane(1, 0, "x").random(3))


def test_lanes_are_pinned():
    # A change here changes every data set ever built: it needs a format version.
    assert lane(7, 17, "draw").integers(0, 1000, 4).tolist() == PINNED
    assert round(unit_hash("home", "apartment_1"), 6) == PINNED_HASH


def test_unit_hash_is_even():
    values = [unit_hash("asset", k) for k in range(2000)]
    assert 0.45 < float(np.mean(values)) < 0.55
    assert min(values) >= 0
    assert max(values) < 1


PINNED = [206, 461, 206, 73]
PINNED_HASH = 0.504669


def test_keys_sort_as_powers_do_where_those_can_be_told_apart():
    weights = [0.5, 3.0, 1.0, 2.0]
    keys = weighted_keys(lane(1, 2, "w"), weights)
    powers = lane(1, 2, "w").random(4) ** (1.0 / np.array(weights))
    assert np.argsort(keys).tolist() == np.argsort(powers).tolist()


@pytest.mark.parametrize("scale", [1.0, 1e-9, 1e-300])
def test_small_weights_keep_their_shares(scale):
    """u^(1/w) is 0 for every small w: the first of the list would always come first."""
    first = [int(weighted_keys(lane(k, 0, "w"), [scale, 3 * scale]).argmax()) for k in range(2000)]
    assert np.mean(first) == pytest.approx(0.75, abs=0.03)


def test_a_drawn_zero_has_a_key():
    class Zero:
        def random(self, count):
            return np.zeros(count)

    assert np.isfinite(weighted_keys(Zero(), [1.0, 1e-3])).all()
