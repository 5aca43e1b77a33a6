"""Data sets and scenes in a notebook: pictures in the page itself, words of strangers escaped."""

import base64
import io
import re
from pathlib import Path

import pytest
from PIL import Image
from sdgen.dataset import Dataset

from tests import toy
from tests.edits import reseal


@pytest.fixture(scope="module")
def path(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return toy.build(tmp_path_factory.mktemp("set") / "d", toy.small(n=8))


def pictures(html: str) -> list[Image.Image]:
    found = re.findall(r'src="data:image/jpeg;base64,([^"]+)"', html)
    return [Image.open(io.BytesIO(base64.b64decode(data))) for data in found]


def test_a_data_set_shows_its_first_scenes(path: Path) -> None:
    html = Dataset(path)._repr_html_()
    assert len(pictures(html)) == 6
    assert "and 2 more" in html
    assert "8 scenes" in html
    assert "http" not in html.replace("http://www.w3.org", "")


def test_a_scene_shows_all_views_with_boxes_and_words(path: Path) -> None:
    item = Dataset(path)[3]
    html = item._repr_html_()
    assert [picture.width for picture in pictures(html)] == [240, 240]
    for anomaly in item.anomalies.anomalies:
        assert anomaly.hazard in html
    seen = [o.object_id for v in item.visibility.views for o in v.objects]
    wrong = [a.object_id for a in item.anomalies.anomalies]
    assert html.count("#e03131") == sum(seen.count(number) for number in wrong)


def test_without_pictures_and_with_broken_ones_there_are_words(tmp_path: Path) -> None:
    blind = toy.build(tmp_path / "blind", toy.small(n=1, sensors=()))
    assert "no picture" in Dataset(blind)._repr_html_()
    path = toy.build(tmp_path / "broken", toy.small(n=1))
    (path / "scenes/000000/views/00/rgb.png").write_bytes(b"<script>")
    assert "rgb.png: changed since it was written" in Dataset(path)[0]._repr_html_()
    reseal(path)
    assert "not a readable picture" in Dataset(path)[0]._repr_html_()


def test_words_of_strangers_are_escaped(tmp_path: Path) -> None:
    path = toy.build(tmp_path / "<b>d", toy.small(n=1))
    assert "<b>d" not in Dataset(path)._repr_html_()
