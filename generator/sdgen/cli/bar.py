"""How far a walk over scenes or models is: a bar on a terminal, nothing elsewhere."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager

from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

from sdgen.cli.quiet import quiet


@contextmanager
def bar(what: str) -> Iterator[Callable[[int, int], None] | None]:
    """A callback ``(done, total)`` that moves a bar on stderr; None when nobody would
    see it, or with ``--quiet``."""
    console = Console(stderr=True)
    if not console.is_terminal or quiet():
        yield None
        return
    columns = (TextColumn(what), BarColumn(), MofNCompleteColumn(), TimeRemainingColumn())
    with Progress(*columns, console=console, transient=True) as progress:
        task = progress.add_task("", total=None)

        def show(done: int, total: int) -> None:
            progress.update(task, completed=done, total=total)

        yield show
