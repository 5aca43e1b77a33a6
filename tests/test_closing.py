"""What closes itself does so once, after an error too."""

import pytest
from sdgen.closing import Closing


class Door(Closing):
    def __init__(self) -> None:
        self.closed = 0

    def close(self) -> None:
        self.closed += 1


def test_with_gives_the_thing_and_closes_it() -> None:
    with Door() as door:
        assert isinstance(door, Door)
        assert door.closed == 0
    assert door.closed == 1


def test_it_is_closed_after_an_error_which_goes_on() -> None:
    door = Door()

    def fails() -> None:
        with door:
            raise ValueError

    with pytest.raises(ValueError):
        fails()
    assert door.closed == 1
