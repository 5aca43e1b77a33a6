"""Results come in the order of the jobs, errors as what they are; workers end with the iterator."""

from __future__ import annotations

import os
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path

import pytest
from sdgen.engines.in_order import in_order
from sdgen.errors import InputError, SceneRejected, WorkerFault
from sdgen.scratch import PREFIX


class Work:
    """Squares jobs, the first ones slowest; misbehaves on some."""

    def __init__(self, bad: dict[int, str]) -> None:
        self.bad = bad
        self.closed = 0

    def __call__(self, job: int) -> tuple[int, int]:
        how = self.bad.get(job)
        if how == "die":
            os._exit(9)
        if how == "raise":
            raise ZeroDivisionError("oops")
        if how == "broken file":
            raise InputError(["a.yaml:3: first", "a.yaml:4: second"])
        if how == "hang":
            time.sleep(60)
        time.sleep(0.2 if job == 0 else 0.0)
        return job * job, os.getpid()

    def close(self) -> None:
        self.closed += 1


@pytest.fixture(autouse=True)
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """Whatever a test leaves among the temporary files is a failure."""
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    yield tmp_path
    assert list(tmp_path.iterdir()) == []


def test_results_of_several_processes_come_in_order() -> None:
    found = list(in_order(Work, ({},), 6, 2))
    assert [outcome.job for outcome in found] == list(range(6))
    assert [outcome.result[0] for outcome in found] == [0, 1, 4, 9, 16, 25]
    assert os.getpid() not in {outcome.result[1] for outcome in found}


@pytest.mark.parametrize(("jobs", "workers"), [(3, 1), (1, 4)])
def test_one_worker_works_here_and_is_closed(jobs: int, workers: int) -> None:
    work = Work({})
    found = list(in_order(lambda: work, (), jobs, workers))
    assert {outcome.result[1] for outcome in found} == {os.getpid()}
    assert work.closed == 1


def test_errors_cross_the_border_whole() -> None:
    found = list(in_order(Work, ({1: "raise", 2: "die"},), 4, 2))
    assert [outcome.error is None for outcome in found] == [True, False, False, True]
    assert isinstance(found[1].error, WorkerFault)
    assert str(found[1].error).startswith("unexpected ZeroDivisionError: oops (test_in_order.py:")
    assert isinstance(found[2].error, SceneRejected)
    with pytest.raises(InputError) as caught:
        list(in_order(Work, ({1: "broken file"},), 4, 2))
    assert list(caught.value.problems) == ["a.yaml:3: first", "a.yaml:4: second"]


def test_whoever_stops_listening_stops_the_workers(place: Path) -> None:
    running = in_order(Work, ({3: "hang"},), 4, 2)
    assert next(running).job == 0
    assert [path.name.startswith(PREFIX) for path in place.iterdir()] == [True]
    begin = time.monotonic()
    running.close()
    assert time.monotonic() - begin < 5
