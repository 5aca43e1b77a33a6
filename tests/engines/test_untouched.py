"""Which hazards need homes to be cleared of being true of furniture alone."""

import pytest
from sdgen.catalog.load import load_catalog
from sdgen.engines import fit
from sdgen.engines.untouched import Untouched, at_risk, stands
from sdgen.options import BuildOptions
from sdgen.pipeline.furnished import FurnishedHome

from tests.engines.worlds import with_hazard
from tests.shipped import shipped_library


def homes(catalog, count):
    made = (
        fit.home_to_try(k, catalog, shipped_library(), BuildOptions(seed=1)) for k in range(count)
    )
    return [home for home in made if isinstance(home, FurnishedHome)]


def test_no_shipped_hazard_costs_the_trial_more_homes():
    assert at_risk(load_catalog(), shipped_library()) == frozenset()


@pytest.mark.parametrize(
    ("predicate", "anomaly", "risky"),
    [
        ("{category: door, state: OPEN}", "{set: door, state: OPEN}", True),
        ("{category: tv, state: ON}", "{set: tv, state: ON}", True),
        ("{category: wardrobe, state: OPEN}", "{set: wardrobe, state: OPEN}", True),
        ("{category: dishwasher, state: OPEN}", "{set: dishwasher, state: OPEN}", False),
        ("{state: OPEN}", "{set: door, state: OPEN}", True),
        (
            "{category: knife, relation: ON, target: bed}",
            "{place: knife, relation: ON, target: bed}",
            False,
        ),
    ],
)
def test_only_states_that_furniture_stands_in_are_a_risk(tmp_path, predicate, anomaly, risky):
    catalog = with_hazard(tmp_path, predicate, anomaly)
    assert ("mine" in at_risk(catalog, shipped_library())) == risky


def test_doors_that_no_home_leaves_open_are_no_risk(tmp_path, monkeypatch):
    catalog = with_hazard(tmp_path, "{category: door, state: OPEN}", "{set: door, state: OPEN}")
    assert "mine" in at_risk(catalog, shipped_library())
    monkeypatch.setattr("sdgen.home.furnish.DOOR_OPEN_SHARE", 0.0)
    assert "mine" not in at_risk(catalog, shipped_library())


def test_furniture_of_homes_stands_in_the_states_that_are_reckoned_with():
    catalog, library = load_catalog(), shipped_library()
    known = {c.name: set(stands(c, library)) for c in catalog.categories}
    kinds = {c.name: c.kind for c in catalog.categories}
    for home in homes(catalog, 4):
        for item in home.layout.items.values():
            assert kinds[item.category] in ("furniture", "opening")
            assert item.states in known[item.category]


def test_homes_are_counted_once_whatever_stands_in_them(tmp_path):
    catalog = with_hazard(tmp_path, "{category: door, state: OPEN}", "{set: door, state: OPEN}")
    untouched = Untouched(catalog, shipped_library())
    looked = [untouched.look(home) for home in homes(catalog, 3)]
    hit = sum("mine" in found for found in looked)
    assert hit
    said = {**untouched.problems(), **untouched.warnings()}
    assert f"true of furniture (door) in {hit} of {len(looked)} homes" in said["mine"]
