"""A source of models on this machine."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from tests.importing.file_server import Site, serving


@pytest.fixture
def site(monkeypatch: pytest.MonkeyPatch) -> Iterator[Site]:
    monkeypatch.setenv("no_proxy", "127.0.0.1")
    with serving() as one:
        yield one
