"""The draw is balanced, distinct within a scene, and knows only seed and index."""

from collections import Counter

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from sdgen.errors import UsageError
from sdgen.hazards.draw import block_size, check_range, draw

SIX = ["spill", "stove_on", "fridge_open", "sharp_object", "tripping_hazard", "food_out"]


@settings(max_examples=40, deadline=None)
@given(
    st.integers(0, 10**9),
    st.integers(1, 13),
    st.integers(0, 5),
    st.integers(0, 5),
)
def test_each_whole_block_is_exactly_even(seed, classes, low, high):
    low, high = min(low, high, classes), min(max(low, high), classes)
    names = [f"h{k}" for k in range(classes)]
    size = block_size(classes, low, high)
    scenes = [draw(seed, k, names, low, high, "balanced") for k in range(size)]
    counts = Counter(len(s) for s in scenes)
    per_class = Counter(name for scene in scenes for name in scene)
    assert set(counts) == set(range(low, high + 1))
    assert len(set(counts.values())) == 1
    assert len({per_class[name] for name in names}) == 1
    assert all(len(set(scene)) == len(scene) for scene in scenes)


def test_a_scene_draws_the_same_alone_and_whatever_the_order_of_classes():
    assert draw(7, 17, SIX, 0, 5, "balanced") == draw(7, 17, SIX[::-1], 0, 5, "balanced")
    assert draw(7, 17, SIX, 0, 5, "balanced") != draw(8, 17, SIX, 0, 5, "balanced") or draw(
        7, 18, SIX, 0, 5, "balanced"
    ) != draw(8, 18, SIX, 0, 5, "balanced")


def test_iid_covers_all_counts():
    counts = {len(draw(1, k, SIX, 0, 5, "iid")) for k in range(200)}
    assert counts == set(range(6))


@pytest.mark.parametrize(("low", "high"), [(5, 2), (0, 7)])
def test_a_range_that_cannot_be_drawn_is_a_usage_error(low, high):
    with pytest.raises(UsageError):
        draw(0, 0, SIX, low, high, "balanced")


def test_more_than_the_enabled_classes_is_refused_with_what_can_be_had():
    check_range(0, 6, 6)
    for low, high in ((0, 7), (0, 500)):
        with pytest.raises(
            UsageError, match=r"a scene shows each class once and 6 are enabled.*0-6"
        ):
            check_range(low, high, 6)
