"""What all tests share, and the order in which workers take them."""

from __future__ import annotations

import os

import pytest

from tests.shared import Shared

if os.environ.get("PYTEST_XDIST_WORKER"):
    # As many workers as cores: more threads in Mesa would only get in each other's way.
    os.environ.setdefault("LP_NUM_THREADS", "1")


@pytest.fixture(scope="session")
def shared(tmp_path_factory: pytest.TempPathFactory) -> Shared:
    """Made once a run: the workers' temporary folders lie in one."""
    base = tmp_path_factory.getbasetemp()
    return Shared((base.parent if os.environ.get("PYTEST_XDIST_WORKER") else base) / "shared")


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Modules that take long come first, or the last worker would still be at one when all others
    wait. Modules stay whole, so that what their tests share is made once."""
    slow = {item.path for item in items if item.get_closest_marker("slow")}
    items.sort(key=lambda item: item.path not in slow)
