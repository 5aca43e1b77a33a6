"""Splits and what train never shows are fixed by hash, before anything is sampled."""

from collections import Counter

from sdgen.catalog.enumeration import enumerate_anomalies
from sdgen.catalog.load import load_catalog
from sdgen.hazards.splits import SplitModels, split_of_home, withheld_anomaly, withholds

from tests.shipped import shipped_library

LIBRARY = shipped_library()


def test_homes_spread_over_the_splits():
    counts = Counter(split_of_home(f"procedural:{k}") for k in range(2000))
    assert 0.65 < counts["train"] / 2000 < 0.75
    assert 0.12 < counts["val"] / 2000 < 0.18
    assert 0.12 < counts["test"] / 2000 < 0.18


def test_train_never_shows_withheld_models_and_keeps_every_category():
    train, test = SplitModels(LIBRARY, "train"), SplitModels(LIBRARY, "test")
    withheld = 0
    for category in LIBRARY.categories:
        shown = {model.id for model in train(category)}
        models = {model.id for model in LIBRARY.by_category(category)}
        assert shown
        assert shown <= models
        assert len(models - shown) <= len(models) / 3
        assert {model.id for model in test(category)} == models
        withheld += len(models - shown)
    assert 0 < withheld < 0.3 * len(LIBRARY.assets)


def test_some_unique_anomalies_are_withheld_but_no_hazard_as_a_whole():
    unique = enumerate_anomalies(load_catalog())
    held = [one for one in unique if withheld_anomaly(one)]
    assert 0 < len(held) < 0.35 * len(unique)
    assert {one.hazard for one in unique if not withheld_anomaly(one)} == {
        one.hazard for one in unique
    }


def test_a_hazard_of_few_ways_withholds_none() -> None:
    """Or one of a single way, as an author's first is, would happen in no training home."""
    catalog = load_catalog(extensions=["water", "heat"])
    few, many = catalog.hazard("wet_floor"), catalog.hazard("candle_on")
    assert any(
        withheld_anomaly(one) for one in enumerate_anomalies(catalog) if one.hazard == few.id
    )
    assert not withholds(few)
    assert withholds(many)


def test_a_suite_is_withheld_as_a_whole():
    train = SplitModels(LIBRARY, "train")
    kitchen = ("kitchen_counter", "sink_cabinet", "wall_cabinet")
    shown = [{model.suite for model in train(category) if model.suite} for category in kitchen]
    every = [
        {model.suite for model in LIBRARY.by_category(category) if model.suite}
        for category in kitchen
    ]
    assert shown[0] == shown[1] == shown[2]
    assert shown[0] < every[0]
