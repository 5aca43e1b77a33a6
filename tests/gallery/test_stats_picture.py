"""Distributions as a picture: one bar a bin, words of strangers escaped, whole or not at all."""

import re
import xml.etree.ElementTree as Tree
from pathlib import Path

import pytest
from sdgen.dataset import Dataset
from sdgen.dataset.distributions import Spread, distributions
from sdgen.errors import SdgenError
from sdgen.gallery.stats_picture import bars, charts, stats_svg, write_stats

from tests import toy


@pytest.fixture(scope="module")
def path(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return toy.build(tmp_path_factory.mktemp("set") / "d", toy.small(n=8))


def test_every_count_is_a_bar_with_its_number(path: Path) -> None:
    found = distributions(Dataset(path))
    text = stats_svg("<b>mine", found)
    assert "<b>mine" not in text
    Tree.fromstring(text)
    drawn = [bar for chart in charts(found) for bar in chart.bars]
    assert len(re.findall('class="bar"', text)) == len(drawn)
    for name, count in found.names["anomalies_by_hazard"].counts.items():
        assert f"<title>{name.replace('_', ' ')}: {count}</title>" in text
    assert text == stats_svg("<b>mine", found)


def spread(edges: tuple[float, ...], counts: tuple[int, ...]) -> Spread:
    return Spread(
        title="t", n=sum(counts), minimum=0, median=0, mean=0, maximum=0, edges=edges, counts=counts
    )


@pytest.mark.parametrize(
    ("edges", "counts", "wanted"),
    [
        ((0, 1, 2, 3), (0, 4, 0), [("1", 4)]),
        ((0, 10, 20, 30), (1, 0, 2), [("0 to 10", 1), ("10 to 20", 0), ("20 to 30", 2)]),
        ((0, 0.9, 1.0001), (0, 3), [("0.9 to 1", 3)]),
        ((0, 100, 1e9), (1, 3), [("0 to 100", 1), ("100 and more", 3)]),
        ((0, 1), (0,), []),
    ],
)
def test_bins_are_named_and_empty_ends_left_out(
    edges: tuple[float, ...], counts: tuple[int, ...], wanted: list[tuple[str, int]]
) -> None:
    assert bars(spread(edges, counts)) == wanted


def test_another_ending_is_refused(path: Path, tmp_path: Path) -> None:
    with pytest.raises(SdgenError, match=r"name it \.svg"):
        write_stats(tmp_path / "a.png", "t", distributions(Dataset(path)))
    assert not list(tmp_path.iterdir())
