"""Tokens and money: what an endpoint counts, else a rule of thumb."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass

from sdgen.chat.question import Question

#: OpenAI's rule of thumb for English text.
LETTERS_A_TOKEN = 4
#: Pictures by tiles of 512 x 512, as OpenAI counts those of GPT-4o in full detail; others count
#: otherwise.
TILE_PX, TILE_TOKENS, PICTURE_TOKENS = 512, 170, 85


def tokens_of(text: str) -> int:
    """About so many tokens: letters by four, rounded up."""
    return -(-len(text) // LETTERS_A_TOKEN)


def question_tokens(question: Question) -> int:
    """About so many tokens a question has, with its pictures."""
    return tokens_of(question.text) + sum(
        PICTURE_TOKENS
        + TILE_TOKENS * math.ceil(picture.width / TILE_PX) * math.ceil(picture.height / TILE_PX)
        for picture in question.pictures
    )


@dataclass(frozen=True)
class Price:
    """Money for a million tokens, in whatever currency it was given."""

    per_million_in: float
    per_million_out: float

    def of(self, tokens_in: float, tokens_out: float) -> float:
        """What so many tokens cost."""
        return (tokens_in * self.per_million_in + tokens_out * self.per_million_out) / 1e6


@dataclass(frozen=True)
class Estimate:
    """What is about to be asked."""

    questions: int = 0
    tokens_in: int = 0
    tokens_out: int = 0

    def __add__(self, other: Estimate) -> Estimate:
        return Estimate(
            self.questions + other.questions,
            self.tokens_in + other.tokens_in,
            self.tokens_out + other.tokens_out,
        )

    def times(self, factor: float) -> Estimate:
        """The same of so many times as much."""
        return Estimate(
            round(self.questions * factor),
            round(self.tokens_in * factor),
            round(self.tokens_out * factor),
        )


def estimate_of(questions: Iterable[Question]) -> Estimate:
    """What these questions are about to take."""
    out = Estimate()
    for question in questions:
        out += Estimate(1, question_tokens(question), question.answer_tokens)
    return out
