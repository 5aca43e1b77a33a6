"""How long is waited, and for what."""

from __future__ import annotations

import pytest
from sdgen.chat.endpoint import AskFailed
from sdgen.chat.patience import Patience, passing
from sdgen.seeding import lane

RNG = lane(0, 0, "test")


def test_waits_double_with_a_drawn_part_and_end() -> None:
    patience = Patience(first_s=1.0, longest_s=10.0)
    for attempt, most in enumerate((1.0, 2.0, 4.0, 8.0, 10.0, 10.0)):
        waits = [patience.wait_s(attempt, AskFailed("", ""), RNG) for _ in range(50)]
        assert all(most / 2 <= wait <= most for wait in waits)
        assert max(waits) > min(waits)
    assert patience.wait_s(10**9, AskFailed("", ""), RNG) <= 10.0


def test_what_the_endpoint_asks_for_is_heeded_up_to_a_bound() -> None:
    patience = Patience(first_s=0.1, longest_s=10.0)
    assert patience.wait_s(0, AskFailed("", "", 429, retry_after_s=7.0), RNG) == 7.0
    assert patience.wait_s(0, AskFailed("", "", 429, retry_after_s=9999.0), RNG) == 10.0


@pytest.mark.parametrize(
    ("status", "again"),
    [(None, True), (429, True), (500, True), (503, True), (408, True)]
    + [(code, False) for code in (400, 401, 403, 404, 422)],
)
def test_only_what_passes_is_tried_again(status: int | None, again: bool) -> None:
    assert passing(AskFailed("", "", status)) is again
    assert not passing(AskFailed("", "", status, final=True))
