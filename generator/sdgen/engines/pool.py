"""A supervised pool of spawned processes: one job each at a time, recycled by measured memory.

A worker that crashes, hangs or bloats costs its job one retry, not the build.
"""

from __future__ import annotations

import contextlib
import ctypes
import multiprocessing
import os
import signal
import sys
import time
import traceback
from collections import deque
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field
from multiprocessing.connection import Connection, wait
from multiprocessing.context import SpawnProcess
from typing import Any

from sdgen.errors import SceneRejected, SdgenError
from sdgen.rejection import Cause

RETRIES = 1
_POLL_S = 1.0


@dataclass(frozen=True)
class Limits:
    """When a worker is given up: seconds a job, megabytes it holds after a job or within one."""

    timeout_s: float = 900.0
    memory_mb: float = 1350.0
    bloat_mb: float = 4000.0


@dataclass(frozen=True)
class Outcome:
    """How one job ended: a ``result``, or an ``error`` (a rejection keeps its type).

    ``memory_mb`` is the most its worker held meanwhile.
    """

    job: int
    result: Any = None
    error: SdgenError | None = None
    memory_mb: float = 0.0


@dataclass(frozen=True)
class Recycled:
    """A worker was replaced, and why."""

    why: str


#: ``make()`` runs once in a worker and returns what does the jobs, with a ``close()``.
Factory = Callable[..., Any]


def resident_mb(process: int | str = "self") -> float:
    """Memory a process holds now, megabytes; 0 when nobody can tell."""
    try:
        with open(f"/proc/{process}/statm", encoding="ascii") as file:
            pages = int(file.read().split()[1])
        return pages * os.sysconf("SC_PAGE_SIZE") / 1e6
    except (OSError, ValueError, IndexError):
        if process != "self":
            return 0.0
        import resource

        return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024 / 1e6


def peak_mb() -> float:
    """The most memory this process has held since the last call (on Linux; else ever)."""
    peak = resident_mb()
    with contextlib.suppress(OSError, ValueError):
        with open("/proc/self/status", encoding="ascii", errors="replace") as file:
            lines = [line for line in file if line.startswith("VmHWM:")]
        peak = max([peak, *(int(line.split()[1]) * 1024 / 1e6 for line in lines)])
        reset_high_water_mark = "5"
        with open("/proc/self/clear_refs", "w", encoding="ascii") as file:
            file.write(reset_high_water_mark)
    return peak


def _serve(pipe: Connection, factory: Factory, args: tuple[Any, ...], quiet: bool) -> None:
    """Body of a worker process."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    _die_with_parent()
    if quiet:
        # The simulator and its drivers write to the C streams; the parent owns the terminal.
        sink = os.open(os.devnull, os.O_WRONLY)
        os.dup2(sink, 1)
        os.dup2(sink, 2)
    try:
        work = factory(*args)
    except SdgenError as error:
        pipe.send(("broken", -1, error, 0.0, 0.0))
        return
    except BaseException:
        pipe.send(("broken", -1, SdgenError(_last_line()), 0.0, 0.0))
        return
    with contextlib.suppress(EOFError, KeyboardInterrupt):
        while True:
            job = pipe.recv()
            if job is None:
                break
            try:
                pipe.send(("done", job, work(job), resident_mb(), peak_mb()))
            except SdgenError as error:
                pipe.send(("error", job, error, resident_mb(), peak_mb()))
            except BaseException:
                pipe.send(("crash", job, ("raised", _last_line()), resident_mb(), peak_mb()))
                break
    with contextlib.suppress(Exception):
        work.close()


def _die_with_parent() -> None:
    """Ask Linux to end this process with its parent, so that a killed build writes no more."""
    with contextlib.suppress(OSError, AttributeError):
        set_parent_death_signal = 1
        ctypes.CDLL(None).prctl(set_parent_death_signal, signal.SIGKILL)


def _last_line() -> str:
    text = traceback.format_exc()
    if os.environ.get("SDGEN_DEBUG"):
        return text
    # The innermost place, without the machine's folders: this ends up in the data set's records.
    frame = traceback.extract_tb(sys.exc_info()[2])[-1]
    return f"{text.strip().splitlines()[-1]} ({os.path.basename(frame.filename)}:{frame.lineno})"


@dataclass
class _Worker:
    process: SpawnProcess
    pipe: Connection
    job: int | None = None
    since: float = field(default_factory=time.monotonic)
    resident_mb: float = 0.0
    peak_mb: float = 0.0
    job_peak_mb: float = 0.0


class Pool:
    """Runs jobs (integers) in ``workers`` processes. Use as a context manager."""

    def __init__(
        self, workers: int, factory: Factory, args: tuple[Any, ...], limits: Limits | None = None
    ) -> None:
        self._context = multiprocessing.get_context("spawn")
        self._factory = factory
        self._args = args
        self._limits = limits or Limits()
        self._count = max(1, workers)
        self._workers: list[_Worker] = []
        self.peak_mb = 0.0

    def __enter__(self) -> Pool:
        return self

    def __exit__(self, *error: object) -> None:
        self.close()

    def close(self) -> None:
        """End every worker at once."""
        for worker in self._workers:
            worker.process.terminate()
        for worker in self._workers:
            worker.process.join(5)
            if worker.process.is_alive():
                worker.process.kill()
            worker.pipe.close()
        self._workers.clear()

    def run(self, jobs: Iterable[int]) -> Iterator[Outcome | Recycled]:
        """Outcomes in the order they come. A broken worker set-up raises its SdgenError."""
        waiting = deque(jobs)
        tries: dict[int, int] = {}
        open_jobs = len(waiting)
        while open_jobs:
            self._hand_out(waiting)
            for worker, message in self._listen():
                kind, job, payload = message
                if kind == "broken":
                    raise payload
                if kind in ("done", "error"):
                    open_jobs -= 1
                    error = payload if kind == "error" else None
                    if error is not None and not isinstance(error, SceneRejected):
                        raise error
                    memory = worker.job_peak_mb
                    yield Outcome(job, None if error else payload, error, memory)
                    if worker.resident_mb > self._limits.memory_mb:
                        self._retire(worker, gently=True)
                        yield Recycled(f"a worker held {worker.resident_mb:.0f} MB")
                    continue
                self._retire(worker, gently=False)
                tries[job] = tries.get(job, 0) + 1
                check, text = payload
                yield Recycled(f"scene {job:06d}: {text}")
                if tries[job] <= RETRIES:
                    waiting.appendleft(job)
                else:
                    open_jobs -= 1
                    causes = {Cause("worker", check): tries[job]}
                    yield Outcome(job, error=SceneRejected(f"{job:06d}", causes))

    def _hand_out(self, waiting: deque[int]) -> None:
        idle = [worker for worker in self._workers if worker.job is None]
        while waiting and (idle or len(self._workers) < self._count):
            worker = idle.pop() if idle else self._spawn()
            worker.job = waiting.popleft()
            worker.since = time.monotonic()
            # A worker that died meanwhile is found by its sentinel.
            with contextlib.suppress(OSError):
                worker.pipe.send(worker.job)

    def _spawn(self) -> _Worker:
        ours, theirs = self._context.Pipe()
        quiet = not os.environ.get("SDGEN_DEBUG")
        process = self._context.Process(
            target=_serve, args=(theirs, self._factory, self._args, quiet), daemon=True
        )
        process.start()
        theirs.close()
        worker = _Worker(process, ours)
        self._workers.append(worker)
        return worker

    def _retire(self, worker: _Worker, gently: bool) -> None:
        self._workers.remove(worker)
        if gently:
            with contextlib.suppress(OSError):
                worker.pipe.send(None)
            worker.process.join(10)
        if worker.process.is_alive():
            worker.process.kill()
            worker.process.join()
        worker.pipe.close()

    def _listen(self) -> list[tuple[_Worker, tuple[str, int, Any]]]:
        busy = [worker for worker in self._workers if worker.job is not None]
        by_pipe = {id(worker.pipe): worker for worker in busy}
        by_sentinel = {worker.process.sentinel: worker for worker in busy}
        ready = wait([w.pipe for w in busy] + list(by_sentinel), timeout=_POLL_S)
        out: list[tuple[_Worker, tuple[str, int, Any]]] = []
        heard: set[int] = set()
        for item in sorted(ready, key=lambda r: not isinstance(r, Connection)):
            worker = by_pipe[id(item)] if isinstance(item, Connection) else None
            if worker is None:
                assert isinstance(item, int)
                worker = by_sentinel[item]
            if id(worker) in heard:
                continue
            heard.add(id(worker))
            out.append((worker, self._hear(worker)))
        for worker in busy:
            trouble = self._trouble(worker) if id(worker) not in heard else None
            if trouble is not None and worker.job is not None:
                out.append((worker, ("crash", worker.job, trouble)))
        return out

    def _trouble(self, worker: _Worker) -> tuple[str, str] | None:
        """What is wrong with a worker that is still at its job, if anything: check and words."""
        if time.monotonic() - worker.since > self._limits.timeout_s:
            return "no_answer", f"no answer in {self._limits.timeout_s:.0f} s"
        held = resident_mb(worker.process.pid or 0)
        worker.peak_mb = max(worker.peak_mb, held)
        if held > self._limits.bloat_mb:
            text = f"held {held:.0f} MB, more than {self._limits.bloat_mb:.0f}"
            return "too_much_memory", text
        return None

    def _hear(self, worker: _Worker) -> tuple[str, int, Any]:
        assert worker.job is not None
        try:
            kind, job, payload, resident, peak = worker.pipe.recv()
        except (EOFError, OSError):
            worker.process.join(1)
            text = f"worker died (exit code {worker.process.exitcode})"
            return "crash", worker.job, ("died", text)
        worker.resident_mb, worker.job_peak_mb = resident, peak
        worker.peak_mb = max(worker.peak_mb, peak)
        self.peak_mb = max(self.peak_mb, resident_mb() + sum(w.peak_mb for w in self._workers))
        worker.job = None
        return kind, job if kind != "broken" else -1, payload
