"""Scores beyond a scene's own, against numbers worked out by hand."""

from pathlib import Path

import pytest
from sdgen.benchmark import Report, detect, evaluate
from sdgen.benchmark.collect import Collected
from sdgen.benchmark.metrics import Evaluation, evaluation
from sdgen.benchmark.truth import Truth, Ways
from sdgen.dataset import Dataset
from sdgen.dataset.records import Predictions

from tests import toy
from tests.benchmark.cases import outcomes, said, truth, wrong


@pytest.fixture(scope="module")
def data(tmp_path_factory: pytest.TempPathFactory) -> Dataset:
    return Dataset(toy.build_with_twins(tmp_path_factory.mktemp("set") / "d", n=4))


def scored(
    data: Dataset, truths: list[Truth], predictions: Predictions, ways: Ways | None = None
) -> Evaluation:
    ways = ways or Ways(frozenset(), frozenset())
    return evaluation(Collected(data, ways, {"": outcomes(truths, dict(predictions))}), "")


def test_objects_of_all_scenes_at_once_and_scene_by_scene(data: Dataset) -> None:
    truths = [truth("0", wrong(1), wrong(2), wrong(3), wrong(4)), truth("1", wrong(1)), truth("2")]
    found = scored(data, truths, {"0": said(1, 2, 50), "1": said(1), "2": said(60)})
    assert found.AS.mean == (2 / 4 + 1) / 2
    assert found.micro["recall"].mean == 3 / 5
    assert found.micro["precision"].mean == 3 / 5
    assert found.micro["f1"].mean == 2 * 3 / (5 + 5)
    assert found.precision.mean == pytest.approx((2 / 3 + 1 + 0) / 3)
    assert (found.hazard_free_alarmed.mean, found.hazard_free_alarmed.n) == (1.0, 1)


def test_recall_is_cut_by_anomalies(data: Dataset) -> None:
    truths = [
        truth("0", wrong(1, shown="not shown"), wrong(2, group="child_safety"), split="train"),
        truth("1", wrong(1, hazard="stove_on", label="unsanitary"), split="val"),
    ]
    found = scored(data, truths, {"0": said(2), "1": said(1)})
    assert (found.recall_by_hazard["spill"].mean, found.recall_by_hazard["spill"].n) == (0.5, 2)
    assert found.recall_by_hazard["stove_on"].mean == 1
    assert found.recall_by_group["child_safety"].mean == 1
    assert found.recall_by_group["safety"].mean == 0.5
    assert found.recall_by_label["unsanitary"].n == 1
    assert found.recall_by_visibility["not shown"].mean == 0
    assert found.recall_by_visibility["1 to 4 times"].mean == 1
    assert list(found.recall_by_split) == ["train", "val"]


def test_an_object_that_is_wrong_twice_counts_for_both_hazards(data: Dataset) -> None:
    both = truth("0", wrong(1, "silent", "candle_on"), wrong(1, "now", "broken_item"))
    found = scored(data, [both], {"0": said(1)})
    assert found.recall_by_hazard["candle_on"].n == found.recall_by_hazard["broken_item"].n == 1
    assert (found.CAS.mean, found.unwanted_per_scene.mean) == (1, 0)
    assert found.micro["recall"].n == 1


def test_ways_that_train_shows_are_told_from_those_it_does_not(data: Dataset) -> None:
    known, new, other = wrong(1, target="table"), wrong(2, target="chair"), wrong(3, category="pan")
    ways = Ways(frozenset({known.way}), frozenset({("spill", "cup")}))
    truths = [truth("0", known, new, other), truth("1", known, split="train")]
    found = scored(data, truths, {"0": said(1, 2), "1": ()}, ways)
    # What train itself holds is neither.
    assert (found.recall_by_seen["seen"].mean, found.recall_by_seen["seen"].n) == (1, 1)
    assert (found.recall_by_seen["unseen"].mean, found.recall_by_seen["unseen"].n) == (0.5, 2)
    assert found.seen_gap.mean == 0.5
    assert found.recall_by_category_seen["seen"].n == 2
    assert found.category_seen_gap.mean == 1
    # Without a train split nothing is seen or unseen.
    assert scored(data, truths[:1], {"0": said(1)}).recall_by_seen["unseen"].n == 0


def test_lookalikes_count_once_each_and_by_what_they_nearly_are(data: Dataset) -> None:
    near = {7: ("spill",), 8: ("spill", "stove_on"), 9: ("stove_on",)}
    found = scored(data, [truth("0", wrong(1), near=near)], {"0": said(1, 8, 50)})
    assert (found.lookalikes_reported.mean, found.lookalikes_reported.n) == (
        pytest.approx(1 / 3),
        3,
    )
    assert found.lookalikes_reported_by_hazard["spill"].mean == 0.5
    assert found.lookalikes_reported_by_hazard["stove_on"].n == 2
    assert found.false_alarms_per_scene.mean == 2


def test_twins_are_told_apart_only_by_silence_about_what_is_undone(data: Dataset) -> None:
    pairs = [wrong(k, in_twin=True) for k in (1, 2, 3)] + [wrong(4)]
    truths = [truth("0", *pairs, twin=True), truth("1", wrong(1, in_twin=True), twin=True)]
    # 1 is found and its undone self left alone; 2 is said of both; 3 of neither; 4 is gone there.
    found = scored(data, truths, {"0": said(1, 2, 4), "0-twin": said(2, 60), "1": said(1)})
    assert (found.twins_told_apart.mean, found.twins_told_apart.n) == (pytest.approx(1 / 3), 3)
    # Of the second scene's twin nothing was predicted: nobody looked at it.
    assert (found.twin_false_alarms.mean, found.twin_false_alarms.n) == (2, 1)


def test_twins_and_lookalikes_of_a_data_set(data: Dataset) -> None:
    perfect = evaluate(data, detect(data, "rules", twins=True))
    assert (perfect.twins_told_apart.mean, perfect.twin_false_alarms.mean) == (1, 0)
    assert (perfect.lookalikes_reported.mean, perfect.hazard_free_alarmed.mean) == (0, 0)
    loud = evaluate(data, detect(data, "always", twins=True))
    assert (loud.twins_told_apart.mean, loud.lookalikes_reported.mean) == (0, 1)
    # In the twins knives are taken away and milk is in the fridge: stoves alone can be told apart.
    anomalies = [a for item in data for a in item.anomalies.anomalies]
    stoves = sum(a.hazard == "stove_on" for a in anomalies)
    assert 0 < loud.twins_told_apart.n == stoves < len(anomalies)
    assert evaluate(data, detect(data, "rules")).twins_told_apart.n == 0


def test_what_train_shows_is_read_where_it_is_not_scored(data: Dataset) -> None:
    part = Dataset(data.path, split="val")
    found = evaluate(part, detect(part, "rules"))
    assert found.recall_by_seen["seen"].n + found.recall_by_seen["unseen"].n == found.AS.n
    assert found.recall_by_seen["seen"].mean == 1


def test_anomalies_fall_into_bins_by_their_best_view(data: Dataset) -> None:
    found = evaluate(data, detect(data, "rules"))
    bins = {key: one.n for key, one in found.recall_by_visibility.items()}
    assert list(bins) == ["not shown", "1 to 4 times", "4 to 16 times", "more than 16 times"]
    assert sum(bins.values()) == sum(one.n for one in found.recall_by_hazard.values())
    blind = sum(not item.entry.all_visible for item in data)
    assert (bins["not shown"] > 0) == (blind > 0)


def test_without_pictures_nothing_is_shown_or_hidden(tmp_path: Path) -> None:
    dark = Dataset(toy.build(tmp_path / "d", toy.small(n=4, sensors=())))
    found = evaluate(dark, detect(dark, "rules"))
    assert found.AS.mean == 1
    assert all(one.n == 0 for one in found.recall_by_visibility.values())


def test_scores_are_the_same_every_time(data: Dataset) -> None:
    said_of = detect(data, "chance")
    assert evaluate(data, said_of) == evaluate(data, said_of)


def test_an_object_that_does_not_exist_is_a_false_alarm(data: Dataset) -> None:
    found = evaluate(data, {"000001": (Report(object_id=9999, label="unsafe"),)})
    assert found.false_alarms_per_scene.mean == 1 / 4
