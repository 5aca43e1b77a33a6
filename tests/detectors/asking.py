"""Detectors whose model says what a test wants, without an endpoint."""

from __future__ import annotations

from collections.abc import Callable

from sdgen.chat.asker import Asker, Outcome
from sdgen.chat.endpoint import Endpoint
from sdgen.chat.question import Question


class Scripted(Asker):
    """Answers with what a function makes of the question; None: it fails."""

    def __init__(self, answer: Callable[[Question], str | None]) -> None:
        super().__init__(Endpoint("scripted", "k"))
        self._answer = answer
        self.questions: list[Question] = []

    def ask(self, question: Question, name: str = "a question") -> Outcome:
        self.questions.append(question)
        text = self._answer(question)
        if text is None:
            return Outcome(None, "503: gone", retries=2)
        return Outcome(text, tokens_in=10, tokens_out=5, counted=True)
