"""Body of a worker process: set up once, then one job after another."""

from __future__ import annotations

import contextlib
import ctypes
import gc
import itertools
import os
import pickle
import signal
import sys
import traceback
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any

from sdgen.engines.machine import give_back, held_mb, peak_mb
from sdgen.engines.protocol import Answer, Broken, Died, Factory, Ready
from sdgen.errors import SdgenError, WorkerFault, os_error_in_words

PACKAGE = Path(__file__).resolve().parents[1]
#: So many new objects, and not freed, before garbage is looked for: some megabytes.
_NEW_OBJECTS = 50_000
#: Freed memory is given back after so many jobs: after each, most would be asked for again.
_JOBS = 8


def main(handle: int, parent: int, order: str) -> None:
    """Serve the parent at the other end of the pipe; ``order`` is a file with the factory."""
    die_with_parent(parent)
    # Whoever stops the build tells the parent, and the parent ends its workers.
    for name in ("SIGINT", "SIGTERM", "SIGHUP"):
        if hasattr(signal, name):
            signal.signal(getattr(signal, name), signal.SIG_IGN)
    pipe = Connection(handle)
    with contextlib.suppress(EOFError, OSError):
        try:
            factory, args = pickle.loads(Path(order).read_bytes())
            work = set_up(factory, args)
        except Exception as error:
            pipe.send(Broken(understood(error)))
            return
        collect_seldom()
        pipe.send(Ready())
        for done in itertools.count(1):
            message = answer(work, pipe.recv())
            pipe.send(message)
            if isinstance(message, Died):
                return
            if done % _JOBS == 0:
                give_back()


def collect_seldom() -> None:
    """Look for garbage in circles as seldom as what a process makes allows.

    What a worker has set up (a catalogue, a library's records) stays as long as it does: looked
    through again at every full collection it cost 20 ms of a core a scene. A scene's records are
    frozen and hold no circles: Python's own threshold of 700 new objects took 4 % of its time.
    """
    gc.collect()
    gc.freeze()
    gc.set_threshold(_NEW_OBJECTS, 20, 20)


def set_up(factory: Factory, args: tuple[Any, ...]) -> Any:
    """What does the jobs. Raises SdgenError, WorkerFault for programming errors."""
    try:
        return factory(*args)
    except SdgenError:
        raise
    except Exception as error:
        raise understood(error) from error


def answer(work: Any, job: int) -> Answer | Died:
    """Do one job; whatever it raises becomes a message."""
    try:
        return Answer(work(job), None, held_mb(), peak_mb())
    except MemoryError:
        return Died("out_of_memory", "out of memory")
    except Exception as error:
        return Answer(None, understood(error), held_mb(), peak_mb())


def understood(error: Exception) -> SdgenError:
    """The error in words for a person.

    What the system refuses (a full disk, a folder that is gone) is the machine's, and no other
    job would fare better; what is neither that nor raised on purpose is a programming error.
    """
    if isinstance(error, SdgenError):
        return error
    if isinstance(error, OSError):
        if os.environ.get("SDGEN_DEBUG"):
            traceback.print_exception(error)
        return SdgenError(os_error_in_words(error))
    return fault(error)


def fault(error: Exception) -> WorkerFault:
    """A programming error with its place, without the machine's folders.

    The place is the innermost line of sdgen, and the innermost of all where that is another.
    """
    if os.environ.get("SDGEN_DEBUG"):
        traceback.print_exception(error)
    trace = traceback.extract_tb(error.__traceback__)
    frames = [frame for frame in trace if frame.filename != __file__]
    ours = [frame for frame in frames if PACKAGE in Path(frame.filename).parents]
    places = []
    for frame in (*ours[-1:], *frames[-1:]):
        path = Path(frame.filename)
        inside = PACKAGE in path.parents
        name = path.relative_to(PACKAGE.parent).as_posix() if inside else path.name
        places.append(f"{name}:{frame.lineno}")
    text = " ".join(str(error).split()) or "no message"
    where = " > ".join(dict.fromkeys(places)) or "unknown place"
    return WorkerFault(f"unexpected {type(error).__name__}: {text} ({where})")


def die_with_parent(parent: int) -> None:
    """Ask Linux to end this process with its parent, so that a killed build writes no more.

    Elsewhere a worker ends after its job, when it finds the pipe closed.
    """
    with contextlib.suppress(OSError, AttributeError):
        set_parent_death_signal = 1
        ctypes.CDLL(None).prctl(set_parent_death_signal, signal.SIGKILL)
    if os.getppid() != parent:
        sys.exit(1)  # it was gone before it could be asked for
