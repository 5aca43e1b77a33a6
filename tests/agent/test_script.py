"""Moves as text: read strictly, all that is wrong at once."""

from __future__ import annotations

import contextlib

import pytest
from hypothesis import given
from hypothesis import strategies as st
from sdgen.agent.script import Line, read_script
from sdgen.errors import InputError, UsageError

from tests.agent import homes


def test_a_script_says_what_to_do() -> None:
    text = "forward 4, turn_left\n# a remark\nscan\nreport 17 unsafe for children summary\nstop"
    assert read_script(text, "here") == (
        Line("forward", 4),
        Line("turn_left"),
        Line("scan"),
        Line("report", target=17, label="unsafe for children", notify="summary"),
        Line("stop"),
    )


def test_all_that_is_wrong_is_told_with_its_line() -> None:
    with pytest.raises(InputError) as error:
        read_script("fly\nforward 0\ngo_to\nreport 3 dirty\nturn_left 1 2", "walk.txt")
    assert [problem.split(": ")[0] for problem in error.value.problems] == [
        f"walk.txt:{k}" for k in range(1, 6)
    ]


@given(st.text())
def test_any_text_is_moves_or_an_error(text: str) -> None:
    with contextlib.suppress(InputError):
        assert all(line.times >= 1 for line in read_script(text, "x"))


def test_it_ends_with_the_episode() -> None:
    episode = homes.episode(options=homes.OPTIONS.model_copy(update={"max_steps": 5}))
    assert len([*Line("turn_left", 100).do(episode)]) == 5


def test_things_are_called_by_name() -> None:
    episode = homes.episode(options=homes.OPTIONS.model_copy(update={"max_steps": 1000}))
    (to_kitchen, to_fridge, nowhere) = read_script("go_to kitchen, go_to fridge, open unicorn", "x")
    (result,) = to_kitchen.do(episode)
    assert result.refused is None
    kinds = {room.id: room.type for room in episode.stage.scene.home.rooms}
    assert kinds[episode.room_id] == "kitchen"
    (result,) = to_fridge.do(episode)
    fridge = episode.house.bodies[int(result.argument["object_id"])].item
    assert fridge.category == "fridge"
    with pytest.raises(UsageError, match="unicorn"):
        list(nowhere.do(episode))
