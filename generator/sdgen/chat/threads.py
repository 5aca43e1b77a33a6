"""Work in threads that wait for others most of the time; a stop waits for none of them."""

from __future__ import annotations

import queue
import threading
from collections.abc import Callable, Iterable, Iterator
from typing import TypeVar

T = TypeVar("T")
R = TypeVar("R")


def in_threads(work: Iterable[T], do: Callable[[T], R], threads: int) -> Iterator[R]:
    """``do`` of each piece, as they get done; no more of ``work`` is drawn than is being done.

    What a piece raises is raised here, and ends the rest. The threads are daemons: whoever stops
    the process waits for no answer of a slow endpoint, so ``do`` must write whole files or none.
    """
    todo: queue.Queue[tuple[T] | None] = queue.Queue()
    done: queue.Queue[tuple[R] | BaseException] = queue.Queue()

    def run() -> None:
        while (piece := todo.get()) is not None:
            try:
                done.put((do(piece[0]),))
            except BaseException as error:
                done.put(error)

    for _ in range(threads):
        threading.Thread(target=run, daemon=True).start()
    pieces = iter(work)
    under_way = 0
    try:
        while True:
            while under_way < threads and (piece := next(pieces, _END)) is not _END:
                todo.put((piece,))  # type: ignore[arg-type]
                under_way += 1
            if not under_way:
                return
            found = done.get()
            under_way -= 1
            if isinstance(found, BaseException):
                raise found
            yield found[0]
    finally:
        for _ in range(threads):
            todo.put(None)


_END = object()
