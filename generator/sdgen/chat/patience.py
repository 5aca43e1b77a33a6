"""How often to ask again, and how long to wait before."""

from __future__ import annotations

from dataclasses import dataclass

from sdgen.chat.endpoint import AskFailed
from sdgen.seeding import Rng

#: What may be another answer the next time: too slow, in the way, too many, broken over there.
_PASSING = frozenset({408, 409, 425, 429})


@dataclass(frozen=True)
class Patience:
    """``retries`` after the first try; waits double from ``first_s`` and end at ``longest_s``,
    which bounds what an endpoint asks for, too."""

    retries: int = 5
    first_s: float = 1.0
    longest_s: float = 60.0

    def wait_s(self, attempt: int, failure: AskFailed, rng: Rng) -> float:
        """Seconds before the try after this one (the first is 0): between half of and the whole of
        the doubled wait, so that those who were refused together do not come back together; no
        less than what the endpoint asks for."""
        doubled = min(self.longest_s, self.first_s * 2.0 ** min(attempt, 30))
        drawn = doubled * (0.5 + 0.5 * float(rng.random()))
        return min(self.longest_s, max(drawn, failure.retry_after_s or 0.0))


def passing(failure: AskFailed) -> bool:
    """True for a failure that may be gone when it is tried again."""
    if failure.final:
        return False
    return failure.status is None or failure.status in _PASSING or failure.status >= 500
