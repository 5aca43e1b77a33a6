"""What engines are made of: an engine runs jobs, a launcher starts its workers.

``supervise.Supervised`` is an engine for any launcher, so that a new place for workers to run is
one launcher and a line in ``registry.ENGINES``. Everything here is light to import and pickles.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any, Protocol

from sdgen.errors import SdgenError

#: ``make(*args)`` runs once in a worker and returns what does the jobs: a callable of the job's
#: number with a ``close()``.
Factory = Callable[..., Any]


@dataclass(frozen=True)
class Outcome:
    """How one job ended: a ``result``, or an ``error`` (SceneRejected or WorkerFault).

    ``memory_mb`` is the most its worker held meanwhile.
    """

    job: int
    result: Any = None
    error: SdgenError | None = None
    memory_mb: float = 0.0


@dataclass(frozen=True)
class Replaced:
    """A worker was replaced, and why."""

    why: str


class Engine(Protocol):
    """Runs jobs somewhere. ``peak_mb`` is the most its processes held together so far; pages that
    they share (mapped files) count in each."""

    peak_mb: float

    def run(self, jobs: Iterable[int]) -> Iterator[Outcome | Replaced]:
        """Outcomes in the order they come, one a job.

        Raises SdgenError when workers cannot be set up, or when a job meets an error that
        concerns all (a full disk, a broken file).
        """
        ...

    def close(self) -> None:
        """End every worker at once and leave nothing behind."""
        ...


# --- what workers say --------------------------------------------------------------------------


@dataclass(frozen=True)
class Ready:
    """The worker is set up and waits for a job. ``share_mb`` is what its machine has for it."""

    share_mb: float = float("inf")


@dataclass(frozen=True)
class Answer:
    """A job is done (``error`` None) or failed by an error that has been understood.

    ``held_mb`` is what the worker alone holds now, ``peak_mb`` the most it held during the job,
    shared pages too.
    """

    result: Any = None
    error: SdgenError | None = None
    held_mb: float = 0.0
    peak_mb: float = 0.0


@dataclass(frozen=True)
class Broken:
    """The worker cannot be set up, nor could another."""

    error: SdgenError


@dataclass(frozen=True)
class Died:
    """The worker is gone: the check that failed, in one word, and in a sentence."""

    check: str
    why: str


Message = Ready | Answer | Broken | Died


class Worker(Protocol):
    """One process that does one job at a time."""

    def give(self, job: int) -> None:
        """Hand over a job; returns at once. A worker that has died is told by ``wait``."""
        ...

    def held_mb(self) -> float:
        """Memory it holds now; 0 when nobody can tell."""
        ...

    def end(self) -> None:
        """End it at once, with what it had in its scratch folder."""
        ...


class Launcher(Protocol):
    """Starts workers and hears them."""

    def size(self) -> int:
        """How many workers there should be now."""
        ...

    def launch(self) -> Worker:
        """A new worker; it says Ready (or Broken, or Died) when it is time."""
        ...

    def wait(self, workers: Sequence[Worker], timeout_s: float) -> list[tuple[Worker, Message]]:
        """What these workers have to say, at most one message each; empty after the timeout."""
        ...

    def close(self) -> None:
        """Let go of everything."""
        ...
