"""What the options of a build mean together."""

import pytest
from sdgen.options import BuildOptions


@pytest.mark.parametrize(
    ("options", "draws"),
    [(BuildOptions(), True), (BuildOptions(views=0), False), (BuildOptions(sensors=()), False)],
)
def test_a_build_draws_when_it_has_views_and_sensors(options: BuildOptions, draws: bool) -> None:
    assert options.draws is draws
