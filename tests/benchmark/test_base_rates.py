"""Homes at their real rates, and what mistakes cost, worked out by hand."""

from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from sdgen.benchmark import BaseRates, Costs, base_rates, detect, read_costs
from sdgen.benchmark.base_rates import rates_of
from sdgen.benchmark.collect import Collected
from sdgen.benchmark.truth import Truth, Ways
from sdgen.dataset import Dataset
from sdgen.dataset.records import Predictions
from sdgen.errors import InputError, UsageError

from tests import toy
from tests.benchmark.cases import outcomes, said, truth, wrong


@pytest.fixture(scope="module")
def data(tmp_path_factory: pytest.TempPathFactory) -> Dataset:
    return Dataset(toy.build_with_twins(tmp_path_factory.mktemp("set") / "d", n=4))


def rated(data: Dataset, truths: list[Truth], said_of: Predictions, **more: float) -> BaseRates:
    ways = Ways(frozenset(), frozenset())
    return rates_of(Collected(data, ways, {"": outcomes(truths, dict(said_of))}), "", **more)


def test_homes_are_weighted_to_the_share_that_is_asked_for(data: Dataset) -> None:
    truths = [truth("0", wrong(1), wrong(2, "silent")), truth("1", wrong(1)), truth("2")]
    found = rated(data, truths, {"0": said(1, 2, 50), "1": said(51), "2": said(60, 61, 62)})
    # Homes with a hazard: two with a false alarm each; the clean one: three.
    assert found.false_alarms_per_home_day.mean == pytest.approx(0.05 * 1 + 0.95 * 3)
    assert found.unwanted_per_home_day.mean == pytest.approx(0.05 * 0.5)
    assert found.recall.mean == pytest.approx(2 / 3)
    hits = 0.05 * 1.0
    assert found.precision.mean == pytest.approx(hits / (hits + 0.05 * 1 + 0.95 * 3))
    assert (found.homes_with_hazards, found.clean_homes, found.scored) == (2, 1, False)
    twice = rated(data, truths, {"2": said(60)}, hazard_share=0.5, inspections_a_day=2)
    assert twice.false_alarms_per_home_day.mean == pytest.approx(2 * 0.5 * 1)


def test_twins_that_were_looked_at_are_clean_homes(data: Dataset) -> None:
    truths = [truth("0", wrong(1), twin=True), truth("1", wrong(1), twin=True), truth("2")]
    found = rated(data, truths, {"0-twin": said(5, 6), "2": said(7)})
    assert (found.homes_with_hazards, found.clean_homes) == (2, 2)
    assert found.false_alarms_per_home_day.mean == pytest.approx(0.95 * 3 / 2)


def test_thresholds_give_the_fewest_false_alarms_at_a_recall(data: Dataset) -> None:
    truths = [truth("0", *(wrong(k) for k in range(1, 11))), truth("1")]
    hits = [report for k in range(1, 10) for report in said(k, sure=1 - k / 20)]
    false = said(50, sure=0.72) + said(51, sure=0.01)
    found = rated(data, truths, {"0": tuple(hits), "1": false})
    assert found.scored
    # Five hits are surer than 0.72; eight come after one false alarm; all nine before the second.
    assert found.at_recall["0.5"].mean == 0
    assert found.at_recall["0.8"].mean == pytest.approx(0.95)
    assert found.at_recall["0.9"].mean == pytest.approx(0.95)
    assert found.at_recall["0.95"].mean is None
    assert found.false_alarms_per_home_day.mean == pytest.approx(0.95 * 2)
    recalls = [point.recall for point in found.curve]
    rates = [point.false_alarms_per_home_day for point in found.curve]
    assert recalls == sorted(recalls)
    assert rates == sorted(rates)
    assert found.curve[0].threshold is None
    assert found.curve[0].precision is None
    assert found.curve[-1].recall == 0.9


def test_without_scores_there_is_one_point(data: Dataset) -> None:
    truths = [truth("0", wrong(1)), truth("1")]
    found = rated(data, truths, {"0": said(1), "1": said(50)})
    assert [point.threshold for point in found.curve] == [None, 1.0]
    assert found.at_recall["0.95"].mean == pytest.approx(0.95)


def test_costs_are_by_what_the_household_wants(data: Dataset) -> None:
    truths = [
        truth("0", wrong(1), wrong(2, "summary"), wrong(3, "silent"), wrong(4)),
        truth("1"),
    ]
    predictions = {
        "0": said(1, notify="summary") + said(2, 3, 50) + said(4, notify="silent"),
        "1": said(60) + said(61, notify="summary") + said(62, notify="silent"),
    }
    found = rated(data, truths, predictions)
    # late, early, unwanted now, false alarm now, missed now; and two false alarms.
    told = 0.05 * (3 + 0.5 + 1 + 1 + 10) + 0.95 * (1 + 0.2)
    assert found.cost_per_home_day["detector"].mean == pytest.approx(told)
    silence = 0.05 * (10 + 3 + 0 + 10)
    assert found.cost_per_home_day["never"].mean == pytest.approx(silence)
    assert found.cost_per_home_day["oracle"].mean == 0
    # All is said with one score: it is cheaper to be silent.
    assert found.cost_per_home_day["best_threshold"].mean == pytest.approx(silence)
    assert found.best_threshold is None


def test_the_oracle_and_silence_of_a_data_set(data: Dataset) -> None:
    perfect = base_rates(data, detect(data, "rules", twins=True))
    assert (perfect.cost_per_home_day["detector"].mean, perfect.recall.mean) == (0, 1)
    assert perfect.false_alarms_per_home_day.mean == 0
    assert perfect.precision.mean == 1
    quiet = base_rates(data, detect(data, "never"))
    assert quiet.cost_per_home_day["detector"] == quiet.cost_per_home_day["never"]
    assert quiet.precision.mean is None
    assert quiet == base_rates(data, detect(data, "never"))


def test_homes_of_one_kind_alone_have_no_base_rate(data: Dataset) -> None:
    with pytest.raises(UsageError, match="none here is without a hazard"):
        rated(data, [truth("0", wrong(1))], {})
    with pytest.raises(UsageError, match="none here is with a hazard"):
        rated(data, [truth("0")], {})
    for share in (0, 1, -0.1, float("nan")):
        with pytest.raises(UsageError, match="between 0 and 1"):
            rated(data, [truth("0", wrong(1)), truth("1")], {}, hazard_share=share)
    with pytest.raises(UsageError, match="inspections a day"):
        rated(data, [truth("0", wrong(1)), truth("1")], {}, inspections_a_day=0)


def test_of_one_home_of_a_kind_there_is_no_interval(data: Dataset) -> None:
    many = [truth("0", wrong(1)), truth("1", wrong(1)), truth("2"), truth("3")]
    few = many[:-1]
    for truths, spread in ((many, True), (few, False)):
        found = rated(data, truths, {"0": said(1), "2": said(9)})
        assert found.recall.mean == 0.5
        assert (found.recall.low is not None) is spread
        assert (found.false_alarms_per_home_day.se is not None) is spread


SURE = st.dictionaries(st.integers(1, 12), st.floats(0, 1), max_size=8)


@settings(deadline=None)
@given(SURE, SURE, st.floats(0.01, 0.99))
def test_a_threshold_never_costs_more_than_silence_or_speech(
    data: Dataset, one: dict[int, float], other: dict[int, float], share: float
) -> None:
    truths = [truth("0", *(wrong(k) for k in range(1, 6))), truth("1")]
    reports = {
        name: tuple(report for key, sure in some.items() for report in said(key, sure=sure))
        for name, some in (("0", one), ("1", other))
    }
    costs = rated(data, truths, reports, hazard_share=share).cost_per_home_day
    assert costs["best_threshold"].mean is not None
    for key in ("detector", "never"):
        mean = costs[key].mean
        assert mean is not None
        assert costs["best_threshold"].mean <= mean + 1e-9


def test_costs_are_read_from_a_file(tmp_path: Path) -> None:
    path = tmp_path / "costs.yaml"
    path.write_text("missed_now: 100\nfalse_alarm_now: 0.5\n")
    assert read_costs(path) == Costs(missed_now=100, false_alarm_now=0.5)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("missed_noww: 1\n", ":1: missed_noww: unknown key (did you mean 'missed_now'?)"),
        ("late: 1\nearly: soon\n", ":2: early: expected a number, got text 'soon'"),
        ("late: -1\n", ":1: late: "),
        ("- 1\n", ":1: expected a mapping"),
        ("late: .inf\n", ":1: late: expected a number"),
        ("late: 1\nlate: 2\n", "duplicate key 'late'"),
        ("", "is empty"),
    ],
)
def test_bad_costs_are_located(tmp_path: Path, text: str, words: str) -> None:
    path = tmp_path / "costs.yaml"
    path.write_text(text)
    with pytest.raises(InputError) as caught:
        read_costs(path)
    assert any(words in problem for problem in caught.value.problems), caught.value.problems
