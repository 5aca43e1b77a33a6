"""Signals that ask a command to end: it cleans up, says one line, has its own exit code."""

from __future__ import annotations

import signal
import threading
from types import FrameType

from sdgen.errors import Stopped

#: A signal and what happened, in a word.
WORDS = {"SIGINT": "interrupted", "SIGTERM": "terminated", "SIGHUP": "hung up"}
#: For commands that go on where they were stopped.
ADVICE = "resume with the same command"


def listen() -> None:
    """From now on these signals raise Stopped; a second one ends the process at once.

    One that is ignored stays so (``nohup``, a job in the background of a script).
    """
    if threading.current_thread() is not threading.main_thread():
        return
    for name in WORDS:
        number = getattr(signal, name, None)
        if number is not None and signal.getsignal(number) is not signal.SIG_IGN:
            signal.signal(number, _stop)


def in_words(number: int, resumable: bool) -> str:
    """``terminated``, or ``terminated: resume with the same command``."""
    words = {getattr(signal, name, None): word for name, word in WORDS.items()}
    word = words.get(number, "stopped")
    return f"{word}: {ADVICE}" if resumable else word


def _stop(number: int, frame: FrameType | None) -> None:
    for name in WORDS:
        known = getattr(signal, name, None)
        if known is not None and signal.getsignal(known) is _stop:
            signal.signal(known, signal.SIG_DFL)
    raise Stopped(number)
