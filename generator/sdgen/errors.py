"""Every error a user can meet, with the exit code it maps to.

Expected rejections (a placement that does not fit) are values, not exceptions; only broken
input, a spent attempt budget or a broken machine raises.
"""

from __future__ import annotations

import errno
from collections.abc import Iterator, Sequence
from contextlib import contextmanager

from sdgen.rejection import Causes, causes_in_words, most_frequent

#: Problems of one file, or of a whole data set, that are told; more of them rarely say more.
SHOWN = 100
#: No space left on the disk, or of what the user may have of it.
FULL = (errno.ENOSPC, errno.EDQUOT)


class SdgenError(Exception):
    """Root of all errors sdgen raises on purpose: one line, what and where, how to mend it."""

    exit_code = 1


class UsageError(SdgenError):
    """The command line asks for something that makes no sense."""

    exit_code = 2


class InputError(SdgenError):
    """A file from outside is bad. Carries all problems found, each located."""

    def __init__(self, problems: Sequence[str]) -> None:
        self.problems = tuple(problems)
        super().__init__("\n".join(self.problems))

    def __reduce__(self) -> tuple[type[InputError], tuple[tuple[str, ...]]]:
        # Exceptions are pickled by their text, which is not what this one is made from.
        return (type(self), (self.problems,))


class AssetError(InputError):
    """A mesh, texture or manifest is missing or broken."""


class SceneRejected(SdgenError):
    """A scene's stated attempt budget is spent.

    ``causes`` counts its rejections, most frequent first; ``home_attempts`` the homes really
    tried, 0 when nobody can tell (its worker died).
    """

    def __init__(self, scene_id: str, causes: Causes, home_attempts: int = 0) -> None:
        self.scene_id = scene_id
        self.home_attempts = home_attempts
        self.causes: Causes = dict(most_frequent(causes))
        top = causes_in_words(self.causes, 4)
        super().__init__(f"scene {scene_id}: could not be made ({top or 'no reason recorded'})")

    def __reduce__(self) -> tuple[type[SceneRejected], tuple[str, Causes, int]]:
        return (SceneRejected, (self.scene_id, self.causes, self.home_attempts))


class WorkerFault(SdgenError):
    """A programming error in a worker: its type, message and place. Trying again is in vain."""


class BuildIncomplete(SdgenError):
    """Some scenes could not be made; the rest of the data set is good."""

    exit_code = 3


class RendererError(SdgenError):
    """No renderer could be started."""


class Stopped(BaseException):
    """The user or the system asked this process to end (SIGINT, SIGTERM, SIGHUP).

    Not an ``Exception``: nothing on the way may take it for a failure and go on.
    """

    def __init__(self, number: int) -> None:
        self.number = number
        super().__init__(number)

    @property
    def exit_code(self) -> int:
        """What shells expect of a process that a signal ended."""
        return 128 + self.number


def os_error_in_words(error: OSError, place: object = None) -> str:
    """``/tmp/x: No space left on device``: the file that the error names, else ``place``.

    Of two files (a copy's) it is the second, which was to be written. What fails while it writes
    into an open file names none.
    """
    where = error.filename2 or error.filename or place
    why = error.strerror or " ".join(str(error).split()) or type(error).__name__
    return why if where is None else f"{where}: {why}"


@contextmanager
def naming(path: object) -> Iterator[None]:
    """What a full disk refuses while it is written into an open file names none: then this."""
    try:
        yield
    except OSError as error:
        if error.filename is None and error.errno in FULL:
            error.filename = str(path)
        raise


def nearest(word: str, choices: Sequence[str]) -> str | None:
    """The choice that the word was probably meant to be; None when none is near."""
    import difflib

    return next(iter(difflib.get_close_matches(word, choices, n=1)), None)


def did_you_mean(word: str, choices: Sequence[str]) -> str:
    """`` (did you mean x?)`` for the nearest choice, else the list of choices when short."""
    near = nearest(word, choices)
    if near is not None:
        return f" (did you mean {near!r}?)"
    if 0 < len(choices) <= 12:
        return f" (one of: {', '.join(sorted(choices))})"
    return ""


#: Of text by strangers, so much is repeated.
_LINE = 300


def one_line(text: str) -> str:
    """Text of a stranger as one line that ends no comment and moves no cursor."""
    plain = "".join(letter if letter.isprintable() else " " for letter in text[: 4 * _LINE])
    plain = " ".join(plain.split())
    return plain if len(plain) <= _LINE else f"{plain[:_LINE]}..."
