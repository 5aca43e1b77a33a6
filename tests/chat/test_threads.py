"""Work in threads."""

from __future__ import annotations

import threading
from collections.abc import Iterator

import pytest
from sdgen.chat.threads import in_threads


def test_all_is_done_once() -> None:
    assert sorted(in_threads(range(50), lambda k: k * k, 4)) == [k * k for k in range(50)]
    assert list(in_threads([], lambda k: k, 4)) == []


def test_so_many_at_a_time_and_no_more_drawn() -> None:
    together = threading.Barrier(3, timeout=10)
    drawn: list[int] = []

    def work() -> Iterator[int]:
        for k in range(6):
            drawn.append(k)
            yield k

    def do(k: int) -> int:
        assert len(drawn) <= 6
        together.wait()  # fails unless three are at it at once
        return k

    assert sorted(in_threads(work(), do, 3)) == list(range(6))


def test_what_a_piece_raises_ends_the_rest() -> None:
    done: list[int] = []

    def do(k: int) -> int:
        if k == 3:
            raise ValueError("three")
        done.append(k)
        return k

    with pytest.raises(ValueError, match="three"):
        list(in_threads(range(1000), do, 2))
    assert len(done) < 10
