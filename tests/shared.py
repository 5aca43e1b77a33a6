"""What several tests need and is dear to make: made once a run, by whichever worker comes first.

pytest-xdist runs tests in several processes that know nothing of each other; they meet in the
run's temporary folder. Values are pickled there, each under a lock of its own, so that workers
who need the same hundred scenes make a part of them each.
"""

from __future__ import annotations

import fcntl
import os
import pickle
import shutil
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, TypeVar

T = TypeVar("T")


class Shared:
    """A folder of things made once. Names must tell all that a thing depends on."""

    def __init__(self, root: Path) -> None:
        self._root = root
        root.mkdir(parents=True, exist_ok=True)

    def folder(self, name: str, make: Callable[[Path], object]) -> Path:
        """The folder that ``make`` fills (it is given a path that is not there yet).

        All who get it share it: copy it before changing anything.
        """
        done, place = self._root / f"{name}.done", self._root / name
        with self._locked(name):
            if not done.exists():
                shutil.rmtree(place, ignore_errors=True)  # half of one that failed
                make(place)
                done.touch()
        return place

    def value(self, name: str, make: Callable[[], T]) -> T:
        """What ``make`` returns, or returned in another process: a copy of one's own."""
        (found,) = self.values([name], lambda _: make())
        return found

    def values(self, names: Iterable[str], make: Callable[[str], T]) -> list[T]:
        """``make(name)`` of every name; processes that ask at the same time share the work."""
        names = list(names)
        for wait in (False, True):  # what nobody else is at first, then the rest
            for name in names:
                place = self._root / f"{name}.pickle"
                if place.exists():
                    continue
                with self._locked(name, wait) as ours:
                    if ours and not place.exists():
                        partial = place.with_suffix(".partial")
                        partial.write_bytes(pickle.dumps(make(name)))
                        os.replace(partial, place)
        return [pickle.loads((self._root / f"{name}.pickle").read_bytes()) for name in names]

    @contextmanager
    def _locked(self, name: str, wait: bool = True) -> Iterator[bool]:
        """True when the lock is ours; False when it is another's and we do not wait."""
        with (self._root / f"{name}.lock").open("w") as file:
            how: Any = fcntl.LOCK_EX if wait else fcntl.LOCK_EX | fcntl.LOCK_NB
            try:
                fcntl.flock(file, how)
            except BlockingIOError:
                yield False
                return
            yield True  # closing the file lets go of it
