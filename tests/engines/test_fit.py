"""A hazard that fits nowhere, or only where another one does, is named before a build starts."""

import re

import pytest
from sdgen.catalog.load import load_catalog
from sdgen.engines import build as building
from sdgen.engines.fit import Misfits, misfits
from sdgen.engines.report import Note
from sdgen.errors import InputError, SdgenError
from sdgen.options import BuildOptions

from tests.engines.worlds import with_hazard
from tests.shipped import shipped_library

pytestmark = pytest.mark.slow


@pytest.fixture(scope="module")
def tools():
    return {"catalog": load_catalog(), "library": shipped_library()}


def changed(catalog, hazard_id, **changes):
    """The catalogue with every placing recipe of a hazard changed."""
    hazard = catalog.hazard(hazard_id)
    recipes = tuple(r.model_copy(update=changes) for r in hazard.anomalies if r.kind == "place")
    broken = hazard.model_copy(update={"anomalies": recipes})
    hazards = tuple(broken if h.id == hazard_id else h for h in catalog.hazards)
    return catalog.model_copy(update={"hazards": hazards})


def test_every_shipped_hazard_fits_somewhere(tools):
    assert misfits(**tools, options=BuildOptions(seed=1)) == Misfits()


def test_a_hazard_without_a_target_is_named_before_anything_is_written(
    tools, tmp_path, monkeypatch
):
    # As if the library had a model of it, and no room a place for it.
    catalog = changed(tools["catalog"], "sharp_object", targets=("stool_of_gold",))
    monkeypatch.setattr(building, "check_buildable", lambda *_: None)
    with pytest.raises(InputError, match=r"sharp_object.* in \d+ tries .*stool_of_gold"):
        building.build(BuildOptions(n=2), tmp_path / "set", catalog, tools["library"])
    assert list(tmp_path.iterdir()) == []


def test_a_hazard_whose_spot_never_fits_is_named(tools):
    catalog = changed(tools["catalog"], "sharp_object", rooms=("ballroom",))
    (problem,) = misfits(catalog, tools["library"], BuildOptions(seed=1)).problems
    assert "sharp_object" in problem
    assert "nothing fits" in problem


def test_a_hazard_that_is_never_proved_ends_the_build_early(tools, tmp_path, monkeypatch):
    """What is put is never accepted: no scene with it can be made."""
    catalog = tools["catalog"]
    hazard = catalog.hazard("sharp_object")
    never = hazard.model_copy(update={"predicate": catalog.hazard("stove_on").predicate})
    catalog = catalog.model_copy(update={"hazards": (never, catalog.hazard("spill"))})
    options = BuildOptions(n=40, seed=7, views=1, sensors=(), hazards_min=1, hazards_max=1)
    monkeypatch.setattr("sdgen.engines.registry.SceneWorker", ImpatientWorker)
    with pytest.raises(SdgenError, match=r"'sharp_object' fits nowhere: never made in \d+ tries"):
        building.build(options, tmp_path / "set", catalog, tools["library"], workers=2)
    assert len(list((tmp_path / "set" / "scenes").iterdir())) < 20


def ImpatientWorker(setup):
    """A worker that gives up a scene after few tries, so that the test ends soon."""
    from sdgen.engines.worker import SceneWorker
    from sdgen.pipeline import scene

    scene.HOME_ATTEMPTS, scene.PLACEMENT_ATTEMPTS = 1, 2
    return SceneWorker(setup)


def test_overlapping_hazards_are_told_and_built_all_the_same(tools):
    """A hazard that always is another one too: each of its objects is labelled as both."""
    catalog = tools["catalog"]
    shipped = catalog.hazard("poison_medication")
    mine = shipped.model_copy(update={"id": "pills_by_bed"})
    both = catalog.model_copy(update={"hazards": (*catalog.hazards, mine)})
    found = misfits(both, tools["library"], BuildOptions(seed=1))
    assert found.problems == ()
    overlaps = [line for line in found.warnings if "overlaps" in line]
    assert len(overlaps) == 2
    assert "'pills_by_bed' overlaps 'poison_medication'" in "".join(overlaps)
    assert "'poison_medication' overlaps 'pills_by_bed'" in "".join(overlaps)


def test_what_is_true_of_most_homes_as_they_stand_is_a_problem(tools, tmp_path):
    """Inner doors stand open: a scene of such a catalogue is proved in a tenth of the homes."""
    catalog = with_hazard(
        tmp_path,
        "{category: door, state: OPEN, relation: BETWEEN, target: bathroom}",
        "{set: door, state: OPEN, rooms: bathroom}",
    )
    (problem,) = misfits(catalog, tools["library"], BuildOptions()).problems
    found = re.search(r"'mine' is true of furniture \(door\) in (\d+) of (\d+) homes", problem)
    assert found is not None
    true, tried = map(int, found.groups())
    assert tried / 2 < true <= tried


def test_what_is_true_of_some_homes_is_a_warning_that_a_build_tells(tools, tmp_path):
    """A third of the televisions stands switched on."""
    catalog = with_hazard(tmp_path, "{category: tv, state: ON}", "{set: tv, state: ON}")
    found = misfits(catalog, tools["library"], BuildOptions())
    (warning,) = found.warnings
    assert found.problems == ()
    assert "'mine' is true of furniture (tv) in" in warning
    events = []
    building._check(BuildOptions(n=2), catalog, tools["library"], False, events.append)
    assert events == [Note(warning)]


def test_homes_in_doubt_count_as_lost(tools, tmp_path):
    """What stands on the floor is nearer to 2 cm than anybody measures."""
    catalog = with_hazard(
        tmp_path,
        "{category: fridge, state: CLOSED, height: {min_m: 0.02}}",
        "{set: fridge, state: CLOSED}",
    )
    (problem,) = misfits(catalog, tools["library"], BuildOptions()).problems
    assert re.search(r"'mine' is in doubt of furniture \(fridge\) in (\d+) of \1 homes", problem)


def test_a_state_that_all_have_already_is_said(tools, tmp_path):
    """Nothing is true of the homes, and nothing is left to be set."""
    catalog = with_hazard(
        tmp_path,
        "{category: fridge, state: CLOSED, relation: CLOSE, target: knife}",
        "{set: fridge, state: CLOSED}",
    )
    (problem,) = misfits(catalog, tools["library"], BuildOptions()).problems
    assert "'mine' fits nowhere" in problem
    assert "no fridge there that is not CLOSED already" in problem
