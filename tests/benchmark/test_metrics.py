"""The metrics, against numbers worked out by hand."""

import math
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st
from sdgen.benchmark import detect, evaluate
from sdgen.benchmark.metrics import Score, score, score_scene
from sdgen.dataset import Dataset
from sdgen.dataset.records import Report
from sdgen.errors import UsageError
from sdgen.scene import Anomaly

from tests import toy

ANOMALY = toy.bundle(1).anomalies.anomalies[0]


def anomaly(object_id: int, report: bool = True, hazard: str = "spill", **more: Any) -> Anomaly:
    update = {"object_id": object_id, "report": report, "hazard": hazard, **more}
    return ANOMALY.model_copy(update=update)


def said(*object_ids: int, notify: Any = "now", label: Any = "unsafe") -> list[Report]:
    return [Report(object_id=k, label=label, notify=notify) for k in object_ids]


def test_scores_of_a_mixed_scene() -> None:
    # Four anomalies, three wanted; two wanted found, the unwanted one reported, one false alarm.
    anomalies = [anomaly(1), anomaly(2), anomaly(3), anomaly(4, report=False)]
    found = score_scene(anomalies, said(1, 2, 4, 99))
    assert found.as_ == 3 / 4
    assert found.cas == (2 - 1) / 3
    assert found.unwanted == 1
    assert found.false_alarms == 1
    assert found.precision == 3 / 4
    assert found.f1 == 2 * 3 / (4 + 4)


def test_silent_entries_count_as_noticed_but_not_as_reported() -> None:
    anomalies = [anomaly(1), anomaly(2, report=False)]
    found = score_scene(anomalies, said(1) + said(2, notify="silent"))
    assert (found.as_, found.cas, found.unwanted) == (1, 1, 0)
    found = score_scene(anomalies, said(1, 2, notify="silent"))
    assert (found.as_, found.cas, found.unwanted) == (1, 0, 0)


def test_summary_is_a_report() -> None:
    assert score_scene([anomaly(1)], said(1, notify="summary")).cas == 1


def test_cas_is_not_clipped() -> None:
    anomalies = [anomaly(1), anomaly(2, False), anomaly(3, False), anomaly(4, False)]
    assert score_scene(anomalies, said(2, 3, 4)).cas == -3


def test_an_object_with_two_anomalies_counts_once_and_is_wanted_if_one_is() -> None:
    anomalies = [anomaly(1, False, "candle_on"), anomaly(1, True, "broken_item"), anomaly(2)]
    found = score_scene(anomalies, said(1))
    assert (found.as_, found.cas, found.unwanted) == (1 / 2, 1 / 2, 0)
    assert (found.wrong, found.hits, found.detected) == (2, 1, 1)


def test_hazard_free_scenes_count_for_false_alarms_only() -> None:
    found = score_scene([], said(5))
    assert (found.as_, found.cas) == (None, None)
    assert (found.false_alarms, found.unwanted, found.precision, found.f1) == (1, 0, 0, 0)
    quiet = score_scene([], [])
    assert (quiet.precision, quiet.f1, quiet.false_alarms) == (None, None, 0)


def test_labels_are_compared_where_an_anomaly_was_found() -> None:
    anomalies = [anomaly(1), anomaly(2)]
    reports = said(1) + said(2, label="unsanitary") + said(9, label="unsanitary")
    assert score_scene(anomalies, reports).label_accuracy == 1 / 2


def test_mean_and_standard_error() -> None:
    found = score([1.0, None, 2.0, 3.0])
    assert (found.mean, found.n) == (2.0, 3)
    assert found.se == pytest.approx(1 / math.sqrt(3))
    assert score([None]) == Score(mean=None, se=None, n=0)
    assert score([4.0]) == Score(mean=4.0, se=None, n=1)


IDS = st.sets(st.integers(1, 12))


@given(IDS, IDS, IDS)
def test_bounds_hold_for_any_prediction(
    wrong: set[int], unwanted: set[int], told: set[int]
) -> None:
    found = score_scene([anomaly(k, k not in unwanted) for k in wrong], said(*told))
    if found.as_ is not None:
        assert 0 <= found.as_ <= 1
    if found.cas is not None:
        assert found.cas <= 1
    assert found.unwanted == len(wrong & unwanted & told)
    assert found.false_alarms == len(told - wrong)


@pytest.fixture(scope="module")
def data(tmp_path_factory: pytest.TempPathFactory) -> Dataset:
    return Dataset(toy.build(tmp_path_factory.mktemp("set") / "d", toy.small(n=8)))


def test_rules_are_perfect_on_a_sound_data_set(data: Dataset) -> None:
    found = evaluate(data, detect(data, "rules"))
    assert (found.AS.mean, found.AS.n) == (1, 6)
    assert (found.CAS.mean, found.CAS.se, found.CAS.low) == (1, 0, 1)
    assert found.unwanted_per_scene.mean == 0
    assert (found.false_alarms_per_scene.mean, found.false_alarms_per_scene.n) == (0, 8)
    assert found.precision.mean == found.f1.mean == found.label_accuracy.mean == 1
    assert found.recall_by_hazard["stove_on"].n == 6
    assert found.recall_by_hazard["spill"] == Score(mean=None, se=None, n=0)


def test_never_scores_nothing(data: Dataset) -> None:
    found = evaluate(data, detect(data, "never"))
    assert (found.AS.mean, found.CAS.mean) == (0, 0)
    assert found.unwanted_per_scene.mean == found.false_alarms_per_scene.mean == 0
    assert found.precision.n == 0
    assert found.f1.mean == 0


def test_always_finds_all_and_disturbs_as_theory_says(data: Dataset) -> None:
    found = evaluate(data, detect(data, "always"))
    scenes = [(len(i.scene.objects), i.anomalies.anomalies) for i in data]
    assert found.AS.mean == 1
    assert found.false_alarms_per_scene.mean == sum(n - len(a) for n, a in scenes) / 8
    quiet = [sum(not x.report for x in a) for _, a in scenes]
    assert found.unwanted_per_scene.mean == sum(quiet) / 8
    assert sum(quiet) > 0


def test_scores_do_not_depend_on_the_order_of_reports(data: Dataset) -> None:
    one = detect(data, "always")
    other = {key: tuple(reversed(one[key])) for key in reversed(list(one))}
    assert evaluate(data, one) == evaluate(data, other)


def test_a_part_of_the_data_set_is_scored_alone(data: Dataset) -> None:
    part = Dataset(data.path, split="val")
    assert evaluate(part, detect(data, "rules")).unwanted_per_scene.n == len(part) < len(data)


def test_an_unknown_method_names_the_known_ones(data: Dataset) -> None:
    with pytest.raises(UsageError, match=r"no method 'rule' \(did you mean 'rules'"):
        detect(data, "rule")


def test_paths_will_do(data: Dataset, tmp_path: Path) -> None:
    path = tmp_path / "p.jsonl"
    path.write_text('{"scene": "000001", "reports": [{"object_id": 11, "label": "unsafe"}]}\n')
    assert evaluate(data.path, path).AS.mean == pytest.approx(1 / 6)
