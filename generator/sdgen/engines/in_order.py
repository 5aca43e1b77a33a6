"""Jobs shared by processes of this machine, their results in the order of the jobs."""

from __future__ import annotations

from collections.abc import Generator
from contextlib import closing
from typing import Any

from sdgen.engines.processes import Processes
from sdgen.engines.protocol import Factory, Outcome
from sdgen.engines.supervise import Supervised


def in_order(
    factory: Factory, args: tuple[Any, ...], jobs: int, workers: int
) -> Generator[Outcome, None, None]:
    """How each of the jobs 0 .. ``jobs`` - 1 ended, in this order.

    With one worker (or job) one ``factory(*args)`` does them here, and every error is raised.
    Processes tell of errors that concern one job (see :class:`Outcome`) and raise the others;
    they end with the iterator, whatever ends it: close it, since an error of who listens keeps it
    alive for as long as anybody keeps the error.
    """
    if min(workers, jobs) <= 1:
        with closing(factory(*args)) as work:
            for job in range(jobs):
                yield Outcome(job, work(job))
        return
    early: dict[int, Outcome] = {}
    following = 0
    with Supervised(Processes(min(workers, jobs), factory, args)) as engine:
        for event in engine.run(range(jobs)):
            if isinstance(event, Outcome):
                early[event.job] = event
            while following in early:
                yield early.pop(following)
                following += 1
