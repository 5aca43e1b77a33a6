"""How much the shipped catalogue enumerates: what the README and the docs promise."""

from __future__ import annotations

from collections import Counter

from sdgen.catalog.enumeration import enumerate_anomalies
from sdgen.catalog.load import load_catalog

from tests.shipped import shipped_library

CATALOG = load_catalog()
FOUND = enumerate_anomalies(CATALOG)
#: Classes that put things somewhere; the other three set what the home has.
SET = {"front_door_open", "stove_on", "fridge_open"}


def test_three_thousand_unique_anomalies_and_enough_of_each_class() -> None:
    counts = Counter(one.hazard for one in FOUND)
    assert sum(counts.values()) >= 3000
    assert len(counts) == 13
    for hazard, count in counts.items():
        assert count >= (6 if hazard in SET else 120), hazard


def test_without_telling_rooms_apart_there_are_three_thousand_too() -> None:
    """A floor and what is set are told apart by their room: nothing rests on that alone."""
    assert len({one.model_copy(update={"room": None}) for one in FOUND}) >= 3000


def test_every_unique_anomaly_has_a_model_in_its_state_and_a_target() -> None:
    library = shipped_library()
    states = library.states_by_category()
    for one in FOUND:
        assert library.by_category(one.category), one
        assert one.state is None or one.state in states[one.category], one
        assert one.target in (None, "floor") or library.by_category(one.target), one
