"""What holds something and lets go of it: a context manager by its ``close`` alone."""

from __future__ import annotations

from types import TracebackType
from typing import Protocol, TypeVar

C = TypeVar("C", bound="Closing")


class Closing(Protocol):
    """To derive from: ``with`` gives the object itself, and closes it whatever happened."""

    def close(self) -> None:
        """Let go."""
        ...

    def __enter__(self: C) -> C:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()
