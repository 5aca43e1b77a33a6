"""Unique anomalies are tried as a build makes them, each whatever others are tried."""

import numpy as np
import pytest
from sdgen.catalog.enumeration import enumerate_anomalies
from sdgen.catalog.load import load_catalog
from sdgen.engines import trials
from sdgen.engines.trials import Trials, home_in_turn, in_words, try_all, why_not

from tests.shipped import shipped_library

CATALOG = load_catalog()


def unique(words):
    """The unique anomaly that these words name."""
    return next(one for one in enumerate_anomalies(CATALOG) if in_words(one) == words)


def tried(words, catalog=CATALOG, attempts=20):
    library = shipped_library()
    names = tuple(unique(one) for one in words)
    some = Trials(catalog, library.folders, library.sha256, names, attempts=attempts)
    return dict(zip(words, try_all(some, 1), strict=True))


@pytest.fixture
def one_home(monkeypatch):
    """Of the first three homes the first that can be furnished is tried."""
    monkeypatch.setattr(trials, "MOST_HOMES", 3)
    monkeypatch.setattr(trials, "HOMES_TRIED", 1)


@pytest.mark.usefixtures("one_home")
@pytest.mark.slow
def test_what_fits_fits_alone_and_among_others():
    mine = "spill: SPILLED coffee_puddle ON floor (kitchen)"
    alone = tried([mine])[mine]
    assert (alone.fits, alone.homes) == (True, 1)
    assert alone.message
    others = ["fridge_open: OPEN fridge (kitchen)", "candle_on: ON candle ON coffee_table", mine]
    among = tried(others)
    assert among[mine] == alone
    assert among[others[0]].fits


@pytest.mark.usefixtures("one_home")
@pytest.mark.slow
def test_what_its_predicate_refuses_never_fits_and_says_so():
    mine = "spill: SPILLED coffee_puddle ON floor (kitchen)"
    never = CATALOG.hazard("spill").model_copy(
        update={"predicate": CATALOG.hazard("stove_on").predicate}
    )
    hazards = tuple(never if h.id == "spill" else h for h in CATALOG.hazards)
    found = tried([mine], CATALOG.model_copy(update={"hazards": hazards}), attempts=3)[mine]
    assert not found.fits
    assert found.tries == 3
    why = why_not(found, shipped_library())
    assert "not proved" in why
    assert "its recipes make what its predicate does not accept" in why


def test_what_no_home_has_is_told_from_what_has_no_model():
    one = unique("fridge_open: OPEN fridge (kitchen)")
    assert "none of 40 homes" in why_not(trials.Tried(one), shipped_library())
    gone = one.model_copy(update={"category": "icebox"})
    assert why_not(trials.Tried(gone), shipped_library()) == "there is no model of icebox"


def test_handfuls_cover_all():
    every = enumerate_anomalies(CATALOG)
    some = Trials(CATALOG, (), "", every)
    assert (some.jobs - 1) * trials.HANDFUL < len(every) <= some.jobs * trials.HANDFUL
    assert np.isclose(Trials(CATALOG, (), "", ()).jobs, 0)


def test_every_room_and_base_home_comes_in_turn():
    turns = [home_in_turn(CATALOG, 3, index) for index in range(trials.MOST_HOMES)]
    assert {one.base.id for one in turns if one.base} == {home.id for home in CATALOG.homes}
    mixes = [mix for one in turns for mix in one.mixes]
    assert set(CATALOG.mixes) == set(mixes)
    assert len({one.id for one in turns}) == len(turns)
