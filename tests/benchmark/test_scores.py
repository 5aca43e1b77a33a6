"""Means, shares, ratios and their intervals."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from sdgen.benchmark.scores import means, ratio, scores_of, shares
from sdgen.seeding import lane


def test_a_ratio_is_of_sums_and_its_error_is_by_scene() -> None:
    # 3 of 4 and 0 of 1: 3/5; residuals 3 - 2.4 and 0 - 0.6, so se = sqrt(2 * 0.72) / 5.
    found = ratio([3, 0], [4, 1]).score
    assert (found.mean, found.n) == (0.6, 5)
    assert found.se == pytest.approx(math.sqrt(2 * 0.72) / 5)
    assert ratio([0], [0]).score.mean is None


def test_intervals_draw_scenes_not_things() -> None:
    # All that differs lies between scenes: each anomaly of one is found, none of the other. Of two
    # scenes drawn, both are the first, or both the second, one time in four each.
    found = scores_of({"x": shares(2, [(0, True)] * 50 + [(1, False)] * 50)}, lane(0, 0, "t"))["x"]
    assert (found.mean, found.n, found.low, found.high) == (0.5, 100, 0.0, 1.0)
    assert found.se is not None
    assert found.se < 0.06


def test_one_scene_has_no_interval() -> None:
    found = scores_of({"x": shares(2, [(1, True), (1, False)])}, lane(0, 0, "t"))["x"]
    assert (found.mean, found.low, found.high) == (0.5, None, None)
    nothing = scores_of({"x": means([None, None])}, lane(0, 0, "t"))["x"]
    assert (nothing.mean, nothing.n, nothing.low) == (None, 0, None)


def test_an_interval_of_a_mean_is_about_four_errors_wide() -> None:
    values = np.random.Generator(np.random.PCG64(5)).normal(3.0, 2.0, 400).tolist()
    found = scores_of({"x": means(values)}, lane(0, 0, "t"))["x"]
    assert found.low is not None
    assert found.high is not None
    assert found.se is not None
    assert found.high - found.low == pytest.approx(2 * 1.96 * found.se, rel=0.1)


@settings(deadline=None)
@given(st.lists(st.one_of(st.none(), st.floats(-5, 5)), max_size=30))
def test_intervals_are_the_same_every_time_and_hold_within_what_was_seen(
    values: list[float | None],
) -> None:
    one = scores_of({"x": means(values)}, lane(1, 0, "t"))["x"]
    assert one == scores_of({"x": means(values)}, lane(1, 0, "t"))["x"]
    kept = [value for value in values if value is not None]
    if one.low is not None and one.high is not None:
        assert min(kept) - 1e-9 <= one.low <= one.high <= max(kept) + 1e-9
    else:
        assert len(kept) < 2


def test_a_gap_is_a_difference_of_the_same_draws() -> None:
    # The second is the first less one tenth, scene by scene: no draw can tell anything else.
    values = [0.2, 0.5, 0.9, 0.4]
    columns = {"a": means(values), "b": means([value - 0.1 for value in values])}
    found = scores_of(columns, lane(0, 0, "t"), {"gap": ("a", "b")})["gap"]
    assert found.mean == pytest.approx(0.1)
    assert (found.low, found.high) == (pytest.approx(0.1), pytest.approx(0.1))
    assert found.se == pytest.approx(0, abs=1e-9)
    assert found.n == 8
