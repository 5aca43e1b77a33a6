"""Asks questions one by one, patiently, remembers the answers, and knows when to give up."""

from __future__ import annotations

import threading
import time
from collections import defaultdict
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from sdgen.chat.cache import Cache
from sdgen.chat.endpoint import Answer, AskFailed, Endpoint, answer_to, client_of
from sdgen.chat.patience import Patience, passing
from sdgen.chat.question import Question, digest_of, request_of
from sdgen.chat.tokens import question_tokens, tokens_of
from sdgen.errors import InputError, SdgenError
from sdgen.seeding import lane

#: Refused so often for who asks or what is asked for, and never answered: nobody is asked further.
GIVE_UP_AFTER = 3
#: So many in a row failed for good, each after its retries: the endpoint is gone, and the rest of
#: the questions are not asked.
GONE_AFTER = 20


@dataclass(frozen=True)
class Outcome:
    """What became of a question. ``text`` None: it failed for good, and ``why``. Tokens are those
    the endpoint counts (``counted``), else estimated; of a failure none. ``cached``: it was
    answered before."""

    text: str | None
    why: str = ""
    tokens_in: int = 0
    tokens_out: int = 0
    counted: bool = False
    retries: int = 0
    cached: bool = False
    cut: bool = False


class Asker:
    """Asks one model; threads may share it.

    ``cache`` None remembers nothing. ``replay``: only what was answered before, nothing is asked.
    """

    def __init__(
        self,
        endpoint: Endpoint,
        cache: Cache | None = None,
        patience: Patience | None = None,
        replay: bool = False,
        sleep: Callable[[float], None] = time.sleep,
    ) -> None:
        self.endpoint = endpoint
        self.cache = cache
        self.patience = patience or Patience()
        self.replay = replay
        self._sleep = sleep
        self._client: Any = None
        self._lock = threading.Lock()
        #: Two threads with the same question: the second finds the answer of the first.
        self._asking: defaultdict[str, threading.Lock] = defaultdict(threading.Lock)
        self._answered = False
        self._refused: list[AskFailed] = []
        self._failed_in_a_row = 0

    def knows(self, question: Question) -> bool:
        """True when the answer is at hand. Raises InputError for a bad file of the cache."""
        found = self.cache.get(request_of(self.endpoint, question)) if self.cache else None
        return found is not None

    def ask(self, question: Question, name: str = "a question") -> Outcome:
        """What becomes of a question; ``name`` is how errors call it.

        Raises SdgenError once all the first questions were refused for who asks (401, 403, 404, or
        money that is gone), InputError for a bad file of the cache, and where only what is known
        is to be had and this is not.
        """
        request = request_of(self.endpoint, question)
        with self._lock:
            turn = self._asking[digest_of(request)]
        with turn:
            found = self.cache.get(request) if self.cache else None
            if found is not None:
                return self._outcome(question, found, 0, cached=True)
            if self.replay:
                where = self.cache.path(request) if self.cache else "no cache"
                raise InputError([f"{where}: no such answer: {name} was never answered (--replay)"])
            return self._asked(question, request)

    def _asked(self, question: Question, request: dict[str, Any]) -> Outcome:
        # A lane of its own for each question: threads take nothing from each other's.
        rng = lane(0, 0, f"chat:{digest_of(request)}")
        messages = question.messages()
        attempt = 0
        while True:
            self._give_up_in_vain()
            if self._failed_in_a_row >= GONE_AFTER:
                why = f"not asked: the {GONE_AFTER} questions before it failed"
                return Outcome(None, why, retries=attempt)
            try:
                answer = answer_to(self.endpoint, messages, self._at_hand())
                break
            except AskFailed as error:
                if not passing(error):
                    self._note(error)
                if not passing(error) or attempt >= self.patience.retries:
                    with self._lock:
                        self._failed_in_a_row += 1
                    return Outcome(None, error.why, retries=attempt)
                wait = self.patience.wait_s(attempt, error, rng)
            self._sleep(wait)
            attempt += 1
        with self._lock:
            self._answered, self._failed_in_a_row = True, 0
        if self.cache is not None:
            self.cache.put(request, answer)
        return self._outcome(question, answer, attempt, cached=False)

    def _at_hand(self) -> Any:
        with self._lock:
            if self._client is None:
                self._client = client_of(self.endpoint)
            return self._client

    def _note(self, error: AskFailed) -> None:
        if error.final or error.status in (401, 403, 404):
            self._refused.append(error)

    def _give_up_in_vain(self) -> None:
        if not self._answered and len(self._refused) >= GIVE_UP_AFTER:
            raise SdgenError(
                f"{self._refused[0]} (the first {GIVE_UP_AFTER} questions were refused; "
                "nobody is asked further)"
            )

    def _outcome(self, question: Question, answer: Answer, retries: int, cached: bool) -> Outcome:
        counted = answer.tokens_in is not None and answer.tokens_out is not None
        return Outcome(
            text=answer.text,
            tokens_in=question_tokens(question) if answer.tokens_in is None else answer.tokens_in,
            tokens_out=tokens_of(answer.text) if answer.tokens_out is None else answer.tokens_out,
            counted=counted,
            retries=retries,
            cached=cached,
            cut=answer.cut,
        )
