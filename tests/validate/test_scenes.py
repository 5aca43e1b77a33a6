"""Scenes checked by several processes: one that ends them is a problem with a name."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace

import pytest
from sdgen.catalog.load import load_catalog
from sdgen.dataset import Dataset
from sdgen.errors import WorkerFault
from sdgen.library import load_library
from sdgen.validate import scenes, validate
from sdgen.validate.assets import check_assets
from sdgen.validate.physics import check_physics
from sdgen.validate.problems import Problem
from sdgen.validate.scenes import WORTH_WORKERS, scene_by_scene

SAMPLE = Path(__file__).parents[2] / "output" / "sample"


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


@pytest.mark.parametrize("what", ["files", "physics", "models"])
def test_who_is_told_and_stops_ends_the_workers_while_the_error_is_held(
    what: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A notebook keeps its last error, and with it everything that was under way."""
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    monkeypatch.setattr(scenes, "WORTH_WORKERS", 1)
    seen = []

    def stop(done: int, total: int) -> None:
        seen.extend(tmp_path.iterdir())
        raise KeyboardInterrupt

    check: dict[str, Callable[[], object]] = {
        "files": lambda: validate(SAMPLE, on_scene=stop, workers=2),
        "physics": lambda: check_physics(Dataset(SAMPLE), load_library(), 2, stop),
        "models": lambda: check_assets((), load_catalog(), stop, 2, ["mug", "plate"]),
    }
    with pytest.raises(KeyboardInterrupt) as held:
        check[what]()
    assert held.value is not None
    assert len(seen) == 1, "processes were at work"
    assert list(tmp_path.iterdir()) == []
