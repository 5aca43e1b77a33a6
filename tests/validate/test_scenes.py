"""Scenes checked by several processes: one that ends them is a problem with a name."""

from __future__ import annotations

import os
from types import SimpleNamespace

import pytest
from sdgen.errors import WorkerFault
from sdgen.validate.problems import Problem
from sdgen.validate.scenes import WORTH_WORKERS, scene_by_scene


class Checker:
    def __init__(self, deadly: int, clumsy: int) -> None:
        self._deadly, self._clumsy = deadly, clumsy

    def __call__(self, index: int) -> list[Problem]:
        if index == self._deadly:
            os._exit(9)
        if index == self._clumsy:
            raise KeyError("x")
        return [Problem("physics", f"{index}")]

    def close(self) -> None:
        pass


ENTRIES = [SimpleNamespace(id=f"{k:06d}") for k in range(WORTH_WORKERS)]


def test_a_scene_that_ends_its_worker_twice_is_named() -> None:
    found = list(scene_by_scene(Checker, (3, -1), ENTRIES, 2))
    texts = [problem.text for problems in found for problem in problems]
    assert texts[:3] + texts[4:] == [str(k) for k in range(WORTH_WORKERS) if k != 3]
    assert texts[3] == "scenes/000003: workers end at it (worker: died x2)"


def test_a_programming_error_is_no_problem_of_the_data() -> None:
    with pytest.raises(WorkerFault, match="unexpected KeyError"):
        list(scene_by_scene(Checker, (-1, 2), ENTRIES, 2))
