"""What importing needs is there or named, and a stop while it loads counts afterwards."""

from __future__ import annotations

import signal

import pytest
from sdgen.importing.packages import signals_wait


def test_a_stop_while_packages_load_counts_when_they_have() -> None:
    done: list[str] = []
    # A suite started in the background is told to ignore the signal.
    before = signal.signal(signal.SIGINT, signal.default_int_handler)

    def load() -> None:
        with signals_wait():
            signal.raise_signal(signal.SIGINT)
            done.append("loaded")
        done.append("went on")

    try:
        with pytest.raises(KeyboardInterrupt):
            load()
        assert signal.getsignal(signal.SIGINT) is signal.default_int_handler
    finally:
        signal.signal(signal.SIGINT, before)
    assert done == ["loaded"]
