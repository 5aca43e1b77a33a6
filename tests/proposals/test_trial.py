"""What is left of an answer is tried as a build would try it."""

from __future__ import annotations

from dataclasses import replace

import pytest
from sdgen.catalog.load import load_catalog
from sdgen.proposals import trial
from sdgen.proposals.answer import read_answer
from sdgen.proposals.check import Idea, Refused, checked
from sdgen.proposals.trial import tried

from tests.shipped import shipped_library


def outcomes(text: str, hazard: str) -> list[Idea | Refused]:
    catalog, library = load_catalog(), shipped_library()
    found = catalog.hazard(hazard)
    ideas = checked(read_answer(text.encode(), "a"), found, catalog, library).ideas
    assert ideas
    return list(tried(ideas, found, catalog, library))


def test_what_fits_is_told_from_what_does_not(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(trial, "HOMES_TRIED", 3)
    text = (
        "- {place: candle, state: ON, relation: ON, target: wardrobe}\n"
        "- {place: tea_light, state: ON, relation: ON, target: wardrobe, rooms: toilet}\n"
    )
    fits, not_there = outcomes(text, "candle_on")
    assert isinstance(fits, Idea)
    assert isinstance(not_there, Refused)
    assert (not_there.why, not_there.line) == ("unfit", 2)
    assert not_there.detail.startswith("no place in ")


def test_what_it_turns_out_to_be_too_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(trial, "HOMES_TRIED", 3)
    catalog, library = load_catalog(), shipped_library()
    candle = catalog.hazard("candle_on")
    mine = candle.model_copy(update={"id": "mine"})
    both = catalog.model_copy(update={"hazards": (*catalog.hazards, mine)})
    source = read_answer(b"- {place: candle, state: ON, relation: ON, target: wardrobe}", "a")
    (idea,) = checked(source, mine, both, library).ideas
    (found,) = tried([replace(idea, also=())], mine, both, library)
    assert isinstance(found, Idea)
    assert found.also == ("candle_on",)
