"""What an evaluation writes: rows, a plot, a page."""

import csv
import html
import json
import re
from pathlib import Path
from xml.etree import ElementTree

import pytest
from sdgen.benchmark import base_rates, detect, evaluate
from sdgen.benchmark.base_rates import rates_of
from sdgen.benchmark.collect import Collected, collect
from sdgen.benchmark.items import COLUMNS, item_rows, write_items
from sdgen.benchmark.plot import curve_panel, recall_panel, svg, write_plot
from sdgen.benchmark.report import MARK, ReportOptions, write_report
from sdgen.benchmark.worst import worst_scenes
from sdgen.dataset import Dataset
from sdgen.errors import SdgenError, UsageError

from tests import toy
from tests.edits import edit_json, reseal


@pytest.fixture(scope="module")
def data(tmp_path_factory: pytest.TempPathFactory) -> Dataset:
    return Dataset(toy.build_with_twins(tmp_path_factory.mktemp("set") / "d", n=4))


@pytest.fixture(scope="module")
def found(data: Dataset) -> Collected:
    """``a`` finds nothing, ``b`` reports all, of twins too."""
    return collect(data, {"a": detect(data, "never"), "b": detect(data, "always", twins=True)})


def test_items_agree_with_the_scores(data: Dataset, found: Collected, tmp_path: Path) -> None:
    path = tmp_path / "i.jsonl"
    count = write_items(path, found)
    rows = [json.loads(line) for line in path.read_text(encoding="utf-8").splitlines()]
    assert len(rows) == count
    assert all(tuple(row) == COLUMNS for row in rows)
    kinds = {(row["detector"], row["kind"]) for row in rows}
    assert kinds == {("a", "miss"), ("a", "lookalike"), ("b", "hit"), ("b", "false_alarm")}
    scores = evaluate(data, detect(data, "always"))
    own = [row for row in rows if row["detector"] == "b" and "twin" not in row["scene"]]
    false = [row for row in own if row["kind"] == "false_alarm"]
    assert len(false) / len(data) == scores.false_alarms_per_scene.mean
    assert sum(row["near_miss_of"] is not None for row in false) == scores.lookalikes_reported.n
    hit = next(row for row in own if row["kind"] == "hit" and row["hazard"] == "stove_on")
    assert (hit["category"], hit["room"], hit["label_said"], hit["notify_said"], hit["score"]) == (
        "stove",
        "kitchen",
        "unsafe",
        "now",
        1.0,
    )
    assert hit["told_apart"] is False
    assert any(row["scene"].endswith("-twin") for row in rows)


def test_items_are_a_spreadsheet_too(found: Collected, tmp_path: Path) -> None:
    count = write_items(tmp_path / "i.csv", found)
    with (tmp_path / "i.csv").open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == count == len(list(item_rows(found)))
    assert set(rows[0]) == set(COLUMNS)
    with pytest.raises(UsageError, match="name it so"):
        write_items(tmp_path / "i.txt", found)


def test_the_plot_shows_a_dot_for_every_hazard_there_is(data: Dataset, tmp_path: Path) -> None:
    told = {name: detect(data, name, twins=True) for name in ("rules", "chance")}
    scores = {f"<{name}>": evaluate(data, one) for name, one in told.items()}
    rates = {f"<{name}>": base_rates(data, one) for name, one in told.items()}
    write_plot(tmp_path / "p.svg", scores, rates)
    root = ElementTree.parse(tmp_path / "p.svg").getroot()
    texts = [node.text for node in root.iter("{http://www.w3.org/2000/svg}text")]
    assert "<rules>" in texts
    hazards = sum(one.n > 0 for one in scores["<rules>"].recall_by_hazard.values())
    assert len(recall_panel(scores).marks) == 2 * hazards
    for panel in (recall_panel(scores), curve_panel(rates)):
        assert all(0 <= mark.x <= panel.width and 0 <= mark.y <= panel.low for mark in panel.marks)
    assert svg([recall_panel(scores)]) == svg([recall_panel(scores)])
    with pytest.raises(UsageError, match=r"name it \.svg"):
        write_plot(tmp_path / "p.png", scores, rates)


def test_the_worst_scenes_come_first_and_say_what_is_true(found: Collected) -> None:
    shown = list(worst_scenes(found, 10))
    sums = [sum(missed + false for _, missed, false in one.errors) for one in shown]
    assert sums == sorted(sums, reverse=True)
    assert len(shown) == 4
    things = [thing for one in shown for thing in one.things]
    missed = next(thing for thing in things if thing.kind == "missed" and "stove" in thing.name)
    assert missed.picture is not None
    assert [(v.detector, v.text, v.wrong) for v in missed.said] == [
        ("a", "nothing", True),
        ("b", "unsafe, now, score 1.00", False),
    ]
    knife = next(thing for thing in things if thing.kind == "reported lookalike")
    assert any("Lookalike of" in line for line in knife.true)
    assert list(worst_scenes(found, 0)) == []


def test_a_detector_without_errors_has_no_worst_scenes(data: Dataset, tmp_path: Path) -> None:
    perfect = collect(data, {"rules": detect(data, "rules")})
    assert list(worst_scenes(perfect, 10)) == []
    page = write_report(perfect, {}, tmp_path / "r").read_text(encoding="utf-8")
    assert "Nothing was missed" in page
    assert not (tmp_path / "r" / "curve.svg").exists()


def test_a_report_is_whole_and_needs_nothing_else(found: Collected, tmp_path: Path) -> None:
    out = tmp_path / "new" / "report"
    rates = {name: rates_of(found, name) for name in found.outcomes}
    options = ReportOptions(worst=2, gallery=str(tmp_path / "view"), notes=("one & two",))
    page = write_report(found, rates, out, options).read_text(encoding="utf-8")
    links = [html.unescape(link) for link in re.findall(r'(?:src|href)="([^"#]+)"', page)]
    assert links
    gallery = [link for link in links if link.startswith("..")]
    assert len(gallery) == 2
    assert all(re.fullmatch(r"\.\./\.\./view/0000\d\d/index\.html", link) for link in gallery)
    assert all((out / link).is_file() for link in links if link not in gallery)
    assert "one &amp; two" in page
    numbers = json.loads((out / "evaluation.json").read_text(encoding="utf-8"))
    assert set(numbers) == {"detectors", "base_rates", "compared"}
    assert [path.name for path in out.parent.iterdir()] == ["report"]
    # An older report makes way, with the pictures that are no longer shown.
    before = len(list((out / "pictures").iterdir()))
    write_report(found, {}, out, ReportOptions(worst=1))
    assert 0 < len(list((out / "pictures").iterdir())) < before
    assert not (out / "curve.svg").exists()


def test_a_report_takes_no_place_of_others(found: Collected, data: Dataset, tmp_path: Path) -> None:
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "thesis.tex").write_text("x")
    with pytest.raises(SdgenError, match="is not empty"):
        write_report(found, {}, tmp_path / "mine")
    out = write_report(found, {}, tmp_path / "report", ReportOptions(worst=1)).parent
    (out / "pictures" / "holiday.jpg").write_text("x")
    with pytest.raises(SdgenError, match=r"holds 'holiday.jpg', which is of no report"):
        write_report(found, {}, out)
    assert (out / "style.css").read_bytes().startswith(MARK)
    with pytest.raises(SdgenError, match="belongs to the data set"):
        write_report(found, {}, data.path / "scenes" / "report")
    (tmp_path / "link").symlink_to(out)
    with pytest.raises(SdgenError, match="symbolic link"):
        write_report(found, {}, tmp_path / "link")


def test_words_of_strangers_are_text_and_a_broken_scene_leaves_nothing(tmp_path: Path) -> None:
    path = toy.build(tmp_path / "d", toy.small(n=2))
    bad = "<script>alert(1)</script>"

    def edit(labels: dict[str, list[dict[str, str]]]) -> None:
        labels["anomalies"][0]["message"] = bad

    edit_json(path / "scenes" / "000001" / "anomalies.json", edit)
    reseal(path)
    data = Dataset(path)
    found = collect(data, {bad: {}})
    page = write_report(found, {}, tmp_path / "r").read_text(encoding="utf-8")
    assert "<script>" not in page
    assert page.count(html.escape(bad)) >= 2
    picture = next((path / "scenes" / "000001" / "views").glob("*/rgb.*"))
    for one in picture.parent.parent.glob("*/rgb.*"):
        one.write_bytes(b"no picture")
    with pytest.raises(SdgenError, match="changed since it was written"):
        write_report(found, {}, tmp_path / "other")
    assert not [one for one in tmp_path.iterdir() if "other" in one.name]
