"""Whether a build is given up follows from the scenes' numbers, not from who is first."""

import itertools

import pytest
from sdgen.engines.early_stop import FAILURES, EarlyStop
from sdgen.rejection import Cause

HAZARDS = ("spill", "stove_on", "tripping_hazard")
NOT_PROVED = Cause("proof", "not_proved", "spill", "puddle")
NO_FLOOR = Cause("home", "no_free_floor")


def first_verdict(outcomes, order, indices=None):
    """What a build hears that gets these outcomes (hazards, or causes) in this order."""
    stop = EarlyStop(HAZARDS, indices or sorted(outcomes))
    for index in order:
        what = outcomes[index]
        said = stop.failed(index, what) if isinstance(what, dict) else stop.made(index, what)
        if said is not None:
            return said
    return None


def test_enough_scenes_that_failed_for_one_hazard_name_it_the_tries_and_why():
    outcomes = {k: {NOT_PROVED: 90, NO_FLOOR: 10} for k in range(FAILURES)}
    said = first_verdict(outcomes, outcomes)
    assert f"'spill' fits nowhere: never made in {90 * FAILURES} tries" in said
    assert f"for {FAILURES} scenes (spill: not proved (puddle) x{90 * FAILURES})" in said
    assert "its predicate does not accept" in said
    assert first_verdict({k: outcomes[k] for k in range(FAILURES - 1)}, range(FAILURES - 1)) is None


def test_the_order_of_completion_decides_nothing():
    outcomes = {k: {NOT_PROVED: 100} for k in range(FAILURES)}
    # One before them shows the hazard: it does fit. However late it comes, the build goes on.
    shown = {0: ("spill",), **{k + 1: causes for k, causes in outcomes.items()}}
    for order in itertools.permutations(shown):
        assert first_verdict(shown, order) is None
    # One behind them that shows it must not save it only if it happens to be the first to come.
    behind = {**outcomes, FAILURES: ("spill",)}
    said = {first_verdict(behind, order) for order in itertools.permutations(behind)}
    assert len(said) == 1
    assert None not in said


def test_nothing_is_decided_while_an_earlier_scene_is_open():
    outcomes = {k: {NOT_PROVED: 100} for k in range(1, 1 + FAILURES)}
    assert first_verdict(outcomes, outcomes, indices=range(10)) is None


def test_failures_for_other_reasons_blame_no_hazard():
    outcomes = {k: {NOT_PROVED: 40, NO_FLOOR: 60} for k in range(2 * FAILURES)}
    assert first_verdict(outcomes, outcomes) is None


@pytest.mark.parametrize(
    ("cause", "hint"),
    [
        (Cause("hazards", "no_place", "spill"), "zones and heights of its recipes"),
        (
            Cause("hazards", "already_set", "spill", "door", state="OPEN"),
            "no door there that is not OPEN already",
        ),
        (Cause("views", "unseen", "spill"), "no camera sees enough"),
        (
            Cause("proof", "accidental", "spill", "puddle", "tripping_hazard"),
            "also is tripping_hazard: make the predicates exclude each other",
        ),
        (Cause("physics", "would_not_stand", "spill"), "recipes and models"),
    ],
)
def test_it_says_what_to_look_at(cause, hint):
    outcomes = {k: {cause: 100} for k in range(FAILURES)}
    assert hint in first_verdict(outcomes, outcomes)
