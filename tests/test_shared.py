"""What tests share is made once, and by all who need it together."""

from __future__ import annotations

import multiprocessing
import os
import time
from pathlib import Path

import pytest

from tests.shared import Shared

NAMES = [f"part-{k}" for k in range(6)]


def slowly(name: str) -> tuple[str, int]:
    time.sleep(0.2)
    return name, os.getpid()


def everything(root: Path) -> list[tuple[str, int]]:
    return Shared(root).values(NAMES, slowly)


def test_processes_share_the_work_and_get_the_same(tmp_path: Path) -> None:
    with multiprocessing.get_context("fork").Pool(2) as pool:
        one, two = pool.map(everything, [tmp_path, tmp_path], chunksize=1)
    assert one == two
    assert [name for name, _ in one] == NAMES
    assert len({process for _, process in one}) == 2


def test_a_folder_is_filled_once_and_anew_after_a_failure(tmp_path: Path) -> None:
    made: list[Path] = []

    def fail(place: Path) -> None:
        raise ZeroDivisionError

    shared = Shared(tmp_path)
    with pytest.raises(ZeroDivisionError):
        shared.folder("set", fail)
    assert shared.folder("set", made.append) == shared.folder("set", made.append)
    assert made == [tmp_path / "set"]


def test_a_value_is_a_copy(tmp_path: Path) -> None:
    shared = Shared(tmp_path)
    shared.value("list", lambda: [1]).append(2)
    assert shared.value("list", lambda: [7]) == [1]
