"""Workers as processes of this machine.

Started by hand and not by ``multiprocessing`` or ``pebble``: a worker must be quiet and know
which signals are its own from its first line on, or an interrupt prints tracebacks of half
started ones; it must not import the user's script again; and it gets a scratch folder of its own
as the place for temporary files, which is taken away with it however it ends.
"""

from __future__ import annotations

import contextlib
import os
import pickle
import shutil
import subprocess
import sys
from collections.abc import Sequence
from contextlib import ExitStack
from multiprocessing import Pipe
from multiprocessing.connection import Connection, wait
from pathlib import Path
from typing import Any

from sdgen.engines.machine import held_mb
from sdgen.engines.protocol import Died, Factory, Message, Worker
from sdgen.errors import SdgenError, os_error_in_words
from sdgen.scratch import scratch_folder

_BOOT = "import sys; sys.path[:] = {path!r}; from sdgen.engines.serve import main; main({args})"


class Process:
    """One worker process and the pipe to it."""

    def __init__(self, order: Path, scratch: Path) -> None:
        self._scratch = scratch
        scratch.mkdir()
        self.pipe, theirs = Pipe()
        args = f"{theirs.fileno()}, {os.getpid()}, {str(order)!r}"
        # The simulator and its drivers write to the C streams; the parent owns the terminal.
        stream = None if os.environ.get("SDGEN_DEBUG") else subprocess.DEVNULL
        self._process = subprocess.Popen(
            [sys.executable, "-c", _BOOT.format(path=sys.path, args=args)],
            stdin=subprocess.DEVNULL,
            stdout=stream,
            stderr=stream,
            env={**os.environ, "TMPDIR": str(scratch)},
            pass_fds=(theirs.fileno(),),
            # Out of the terminal's group: Ctrl-C goes to the parent, which ends the workers.
            start_new_session=True,
        )
        theirs.close()

    def give(self, job: int) -> None:
        """Send the job's number."""
        with contextlib.suppress(OSError):
            self.pipe.send(job)

    def held_mb(self) -> float:
        """Its own memory now."""
        return held_mb(self._process.pid)

    def hear(self) -> Message:
        """What it says, or how it died."""
        try:
            message: Message = self.pipe.recv()
            return message
        except (EOFError, OSError):
            with contextlib.suppress(subprocess.TimeoutExpired):
                self._process.wait(1)
            return Died("died", f"worker died ({_ended(self._process.returncode)})")

    def end(self) -> None:
        """Kill it; its scratch folder goes too."""
        self._process.kill()
        self._process.wait()
        self.pipe.close()
        shutil.rmtree(self._scratch, ignore_errors=True)


class Processes:
    """Launches ``count`` worker processes that do what ``factory(*args)`` makes.

    Raises SdgenError when there is no room for their order.
    """

    def __init__(self, count: int, factory: Factory, args: tuple[Any, ...]) -> None:
        self._count = max(1, count)
        order = pickle.dumps((factory, args))
        with ExitStack() as held:
            self._scratch = held.enter_context(scratch_folder())
            self._order = self._scratch / "order"
            try:
                self._order.write_bytes(order)
            except OSError as error:
                raise SdgenError(os_error_in_words(error, self._order)) from None
            self._held = held.pop_all()
        self._started = 0

    def size(self) -> int:
        """As many as were asked for."""
        return self._count

    def launch(self) -> Process:
        """Start a process."""
        self._started += 1
        return Process(self._order, self._scratch / f"worker-{self._started}")

    def wait(self, workers: Sequence[Worker], timeout_s: float) -> list[tuple[Worker, Message]]:
        """Messages that have come; a closed pipe is one too."""
        by_pipe = {id(one.pipe): one for one in workers if isinstance(one, Process)}
        ready = wait([one.pipe for one in by_pipe.values()], timeout=timeout_s)
        heard = [by_pipe[id(pipe)] for pipe in ready if isinstance(pipe, Connection)]
        return [(one, one.hear()) for one in heard]

    def close(self) -> None:
        """Take the scratch folder away."""
        self._held.close()


def _ended(code: int | None) -> str:
    if code is None:
        return "it closed its pipe"
    return f"signal {-code}" if code < 0 else f"exit code {code}"
