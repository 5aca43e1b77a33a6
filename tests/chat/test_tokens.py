"""Tokens by a rule of thumb, and money."""

from __future__ import annotations

from sdgen.chat.question import Picture, Question
from sdgen.chat.tokens import Estimate, Price, estimate_of, question_tokens


def picture(width: int, height: int) -> Picture:
    return Picture("d", width, height, lambda: ("image/png", b""))


def test_letters_by_four_and_pictures_by_tiles() -> None:
    assert question_tokens(Question("12345")) == 2
    assert question_tokens(Question("", (picture(512, 384),))) == 85 + 170
    assert question_tokens(Question("", (picture(513, 1024), picture(1, 1)))) == 2 * 85 + 5 * 170


def test_an_estimate_and_what_it_costs() -> None:
    found = estimate_of([Question("x" * 400, answer_tokens=10), Question("x" * 400)])
    assert found == Estimate(questions=2, tokens_in=200, tokens_out=11)
    assert found.times(10) == Estimate(20, 2000, 110)
    assert Price(2.0, 8.0).of(1_000_000, 500_000) == 6.0
