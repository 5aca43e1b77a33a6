"""Two detectors on the same scenes."""

from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from sdgen.benchmark import compare, detect
from sdgen.benchmark.compare import FLIPS, sign_flip_p
from sdgen.dataset import Dataset
from sdgen.errors import UsageError
from sdgen.seeding import lane

from tests import toy


@pytest.fixture(scope="module")
def data(tmp_path_factory: pytest.TempPathFactory) -> Dataset:
    return Dataset(toy.build(tmp_path_factory.mktemp("set") / "d", toy.small(n=8)))


def p_of(values: list[float]) -> float | None:
    return sign_flip_p(values, lane(0, 0, "test"))


def test_equal_predictions_have_no_difference(data: Dataset) -> None:
    same = detect(data, "chance")
    (found,) = compare(data, {"a": same, "b": dict(same)})
    for one in found.differences.values():
        assert one.mean in (0, None)
        assert one.p == (1 if one.n else None)


def test_differences_are_the_second_less_the_first_over_scenes_that_have_both(
    data: Dataset,
) -> None:
    never, rules, always = (
        compare(data, {"base": detect(data, "never"), name: detect(data, name)})[0].differences
        for name in ("never", "rules", "always")
    )
    assert never["AS"].mean == 0
    assert (rules["AS"].mean, rules["AS"].n) == (1, 6)
    # never detects nothing: it has no precision to compare.
    assert (rules["precision"].mean, rules["precision"].n, rules["precision"].p) == (None, 0, None)
    assert always["false_alarms_per_scene"].mean is not None
    assert always["false_alarms_per_scene"].mean > 0


def test_p_is_the_share_of_signs_that_reach_as_far() -> None:
    # Of five equal differences only all plus and all minus reach as far: 2 of 32.
    found = p_of([1.0] * 5)
    assert found == pytest.approx(2 / 32, abs=0.01)
    assert p_of([1.0, -1.0]) == 1
    assert p_of([0.0, 0.0, 0.0]) == 1
    assert p_of([]) is None
    assert p_of([0.1] * 60) == 1 / (FLIPS + 1)


@settings(deadline=None)
@given(st.lists(st.floats(-1, 1), min_size=1, max_size=20))
def test_p_is_a_probability_and_knows_no_direction(values: list[float]) -> None:
    found = p_of(values)
    assert found is not None
    assert 0 < found <= 1
    assert found == p_of([-value for value in values])


def test_one_detector_cannot_be_compared(data: Dataset, tmp_path: Path) -> None:
    with pytest.raises(UsageError, match="needs the predictions of two"):
        compare(data, {"a": {}})
