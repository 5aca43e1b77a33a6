"""Near views are as many in every scene and fall on benign things too."""

import pytest
from sdgen.cameras.choice import glance_pixels, high_count, near_count
from sdgen.options import BuildOptions


@pytest.mark.parametrize(
    ("views", "most", "near"), [(8, 5, 5), (12, 5, 8), (4, 5, 3), (1, 5, 0), (0, 5, 0), (6, 1, 4)]
)
def test_the_number_of_near_views_follows_from_the_options_alone(views, most, near):
    options = BuildOptions(views=views, hazards_max=most)
    assert near_count(options) == near
    assert high_count(options) == (1 if views - near > 2 else 0)


def test_large_things_must_show_more_than_small_ones():
    sizes = [glance_pixels(d) for d in (0.01, 0.08, 0.3, 1.0, 5.0)]
    assert sizes == sorted(sizes)
    assert sizes[0] == sizes[1] >= 200
