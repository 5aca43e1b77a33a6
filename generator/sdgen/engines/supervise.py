"""An engine on any launcher: a worker that crashes, hangs or bloats costs its job one retry."""

from __future__ import annotations

import time
from collections import Counter, deque
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field

from sdgen.closing import Closing
from sdgen.engines.machine import held_mb
from sdgen.engines.protocol import (
    Answer,
    Broken,
    Died,
    Launcher,
    Message,
    Outcome,
    Ready,
    Replaced,
    Worker,
)
from sdgen.errors import SceneRejected, SdgenError, WorkerFault
from sdgen.rejection import Cause

#: Workers that may die at their start in a row: one may be chance, three have a reason. With no
#: other worker left the build ends then; with others it goes on, and tries again so much later (a
#: start costs a core one or two seconds, a machine that was full or lost is back in minutes).
STARTS = 3
START_PAUSE_S = 60.0
_POLL_S = 1.0


@dataclass(frozen=True)
class Limits:
    """When a worker is given up: seconds a job, megabytes it holds after a job or within one.

    ``retries`` of a job whose worker crashed or hung: one by default, since a crash that comes
    from the job comes again. ``start_s``: a worker must be ready so many seconds after its start,
    unless another one is; without any machine to start one on, so long a build waits for one.
    """

    timeout_s: float = 900.0
    memory_mb: float = float("inf")
    bloat_mb: float = float("inf")
    retries: int = 1
    start_s: float = 900.0


@dataclass
class _Place:
    """A worker and what it is at."""

    worker: Worker
    ready: bool = False
    share_mb: float = float("inf")
    job: int | None = None
    since: float = field(default_factory=time.monotonic)
    peak_mb: float = 0.0


class Supervised(Closing):
    """Runs jobs with a launcher's workers. Use as a context manager."""

    def __init__(self, launcher: Launcher, limits: Limits | None = None) -> None:
        self._launcher = launcher
        self._limits = limits or Limits()
        self._places: list[_Place] = []
        self._failed_starts = 0
        self._next_start = float("-inf")
        self._changed = time.monotonic()
        self.peak_mb = 0.0

    def close(self) -> None:
        """End every worker at once and let the launcher clean up."""
        for place in self._places:
            place.worker.end()
        self._places.clear()
        self._launcher.close()

    def run(self, jobs: Iterable[int]) -> Iterator[Outcome | Replaced]:
        """Outcomes in the order they come; see :class:`~sdgen.engines.protocol.Engine`."""
        waiting = deque(jobs)
        left = len(waiting)
        tries: Counter[int] = Counter()
        self._changed = time.monotonic()
        while left:
            self._hand_out(waiting)
            for place, message in self._listen():
                job, place.job = place.job, None
                if isinstance(message, Broken):
                    raise message.error
                if isinstance(message, Ready):
                    place.ready, place.share_mb = True, message.share_mb
                    self._failed_starts = 0
                elif isinstance(message, Died):
                    self._end(place)
                    if job is None:
                        self._start_failed(message)
                        continue
                    yield Replaced(f"scene {job:06d}: {message.why}")
                    tries[job] += 1
                    if tries[job] <= self._limits.retries:
                        waiting.appendleft(job)
                        continue
                    left -= 1
                    causes = {Cause("worker", message.check): tries[job]}
                    yield Outcome(job, error=SceneRejected(f"{job:06d}", causes))
                elif job is not None:
                    left -= 1
                    yield from self._ended(place, job, message)

    def _ended(self, place: _Place, job: int, answer: Answer) -> Iterator[Outcome | Replaced]:
        error = answer.error
        if error is not None and not isinstance(error, SceneRejected | WorkerFault):
            raise error
        yield Outcome(job, answer.result, error, answer.peak_mb)
        if isinstance(error, WorkerFault):
            self._end(place)  # nobody knows in what state the error left it
        elif answer.held_mb > (share := min(place.share_mb, self._limits.memory_mb)):
            self._end(place)
            yield Replaced(f"a worker held {answer.held_mb:.0f} MB, its share is {share:.0f}")

    def _hand_out(self, waiting: deque[int]) -> None:
        """Jobs to those who wait for one; as many workers as there are jobs and places for."""
        for place in self._places:
            if waiting and place.ready and place.job is None:
                place.job, place.since = waiting.popleft(), time.monotonic()
                place.worker.give(place.job)
        if time.monotonic() < self._next_start and self._any_ready():
            return
        starting = sum(not place.ready for place in self._places)
        wanted = min(self._launcher.size() - len(self._places), len(waiting) - starting)
        for _ in range(wanted):
            self._places.append(_Place(self._launcher.launch()))
            self._changed = time.monotonic()

    def _listen(self) -> list[tuple[_Place, Message]]:
        by_worker = {id(p.worker): p for p in self._places if p.job is not None or not p.ready}
        busy = [place.worker for place in by_worker.values()]
        found = self._launcher.wait(busy, _POLL_S)
        heard = [(by_worker.pop(id(worker)), message) for worker, message in found]
        for place, message in heard:
            self._changed = time.monotonic()
            if isinstance(message, Answer):
                place.peak_mb = max(place.peak_mb, message.peak_mb)
        for place in by_worker.values():
            trouble = self._trouble(place)
            if trouble is not None:
                heard.append((place, trouble))
        self.peak_mb = max(self.peak_mb, held_mb() + sum(p.peak_mb for p in self._places))
        self._nobody_left()
        return heard

    def _trouble(self, place: _Place) -> Died | None:
        """What is wrong with a worker that is still at its job, if anything."""
        if place.job is None:
            return None
        if time.monotonic() - place.since > self._limits.timeout_s:
            return Died("no_answer", f"no answer in {self._limits.timeout_s:.0f} s")
        held = place.worker.held_mb()
        place.peak_mb = max(place.peak_mb, held)
        if held > self._limits.bloat_mb:
            why = f"held {held:.0f} MB, more than {self._limits.bloat_mb:.0f}"
            return Died("too_much_memory", why)
        return None

    def _any_ready(self) -> bool:
        return any(place.ready for place in self._places)

    def _nobody_left(self) -> None:
        """Raise when no worker is ready, and none came, went or was started for too long."""
        silent = time.monotonic() - self._changed
        if silent > self._limits.start_s and not self._any_ready():
            raise SdgenError(f"no worker has started in {silent:.0f} s")

    def _start_failed(self, message: Died) -> None:
        self._failed_starts += 1
        if self._failed_starts < STARTS:
            return
        if not self._any_ready():
            raise SdgenError(
                f"workers do not start: {message.why}; SDGEN_DEBUG=1 shows what they say"
            )
        self._next_start = time.monotonic() + START_PAUSE_S

    def _end(self, place: _Place) -> None:
        self._places.remove(place)
        place.worker.end()
        self._changed = time.monotonic()
