"""EGL allows one renderer a process: whoever draws in a module lets go of it at its end."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from tests.agent import homes


@pytest.fixture(scope="module", autouse=True)
def no_renderer_is_left() -> Iterator[None]:
    yield
    homes.let_go()
