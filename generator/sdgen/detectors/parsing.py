"""What a model's free text says of the strings it was asked about. Any text: nothing is believed.

Only strings that were asked come back. Quotes of any kind, small and capital letters, spaces,
markdown, bullets, numbers and JSON are understood; so are labels before, behind and below a
string, and headings. Of two labels for one string the first counts.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Literal, get_args

from sdgen.catalog.records import Label
from sdgen.detectors.answer_lines import LONGEST, lines_of_answer
from sdgen.scene import Notify

#: The paper's four classes.
Verdict = Literal[Label, "normal"]

#: Of a stranger's words, so many letters are kept for the second step.
_WORDS = 1_000

_LABEL = re.compile(
    r"(?<![a-z])(?<!not )(?P<child>unsafe[ -]for[ -](?:children|kids|a child|child|toddlers))"
    r"|(?<![a-z])(?<!not )(?P<dirty>unsanitary|insanitary)"
    r"|(?<![a-z])(?<!not )(?P<unsafe>unsafe)(?![a-z])"
    r"|(?<![a-z])(?<!not )(?P<normal>normal)(?![a-z])"
)
NOTIFY: tuple[Notify, ...] = get_args(Notify)
_VERDICTS: Mapping[str, Verdict] = {
    "child": "unsafe for children",
    "dirty": "unsanitary",
    "unsafe": "unsafe",
    "normal": "normal",
}
_NOTIFY = re.compile(
    r"\((now|summary|silent)\)|'(now|summary|silent)'|[:,;–—-] ?(now|summary|silent)\b"
)
_QUOTES = str.maketrans(dict.fromkeys('"`´‘’‚‛“”„‟«»‹›′″', "'") | {"_": " ", "\u00a0": " "})
_MARKS = re.compile(r"[*#]+")
#: What may stand around the label of a heading.
_FILLER = re.compile(
    r"[\W\d]+|\b(?:the|following|objects?|relations?|items?|things?|class|are|is)\b"
)
#: An answer that there is nothing.
_NONE = re.compile(
    r"\W*(?:answer\W+|a\W+)?(?:none|nothing|n/a|\[\s*\]|\{\s*\}|no (?:such |object |relation )*"
    r"(?:anomal|hazard|issue|problem|object|relation|thing|unsafe)[^.]*|(?:all|everything)\b[^.]*"
    r"\b(?:normal|fine|safe|ok)\b[^.]*)\W*"
)
#: What a line begins with when it answers for something.
_LEAD = re.compile(r"\W*(?:\d+\W+)?'(?P<name>[^']{2,200})'")
_SHAPED = re.compile(r"\b(?:INSIDE|ON|UNDER|NEAR\w*)\b")


@dataclass(frozen=True)
class Said:
    """What is said of one string: a class or None, whom to tell or None, and in which words."""

    verdict: Verdict | None
    notify: Notify | None = None
    words: str = ""


@dataclass(frozen=True)
class Reading:
    """An answer, read. ``said``: by the strings that were asked, those that are named;
    ``invented``: what it answers for and nobody asked; ``nothing``: it says that there is none."""

    said: Mapping[str, Said]
    invented: tuple[str, ...] = ()
    nothing: bool = False

    @property
    def readable(self) -> bool:
        """False for an answer that answers nothing."""
        return bool(self.said) or self.nothing


def verdict_in(text: str) -> Verdict | None:
    """The first of the four classes that a text names, None where it names none."""
    match = _LABEL.search(_normal(text[:LONGEST]))
    return _verdict(match) if match else None


def notify_in(text: str) -> Notify | None:
    """``now``, ``summary`` or ``silent`` where a text says so in brackets or quotes."""
    match = _NOTIFY.search(_normal(text[:LONGEST]))
    word = next(filter(None, match.groups()), None) if match else None
    return next((known for known in NOTIFY if known == word), None)


def says_nothing(line: str) -> bool:
    """True for a line that says that there is none."""
    return _NONE.fullmatch(_normal(line)[:300]) is not None


def read_answer(text: str, asked: Sequence[str], loose: bool = True) -> Reading:
    """What an answer says of the strings that were asked. ``loose``: they are found anywhere in a
    line; else only where a line answers for them (a name alone stands in many a reason)."""
    reader = _Reader(asked, loose)
    for line in lines_of_answer(text):
        reader.line(line)
    return Reading(reader.said, tuple(reader.invented), reader.nothing)


class _Reader:
    """Goes through an answer line by line."""

    def __init__(self, asked: Sequence[str], loose: bool) -> None:
        self.said: dict[str, Said] = {}
        self.invented: dict[str, None] = {}
        self.nothing = False
        self._loose = loose
        self._meant: dict[str, list[str]] = {}
        for string in asked:
            self._meant.setdefault(_normal(string), []).append(string)
        # The longest first: one string may begin with another.
        words = sorted(filter(None, self._meant), key=len, reverse=True)
        either = "|".join(map(re.escape, words))
        self._asked = re.compile(rf"(?<!\w)(?:{either})(?!\w)") if words else None
        self._heading: Verdict | None = None
        self._pending: tuple[str, ...] = ()

    def line(self, line: str) -> None:
        normal = _normal(line)
        matches = self._matches(normal)
        if matches:
            self._answers(normal, matches, line)
            return
        labels = {_verdict(match) for match in _LABEL.finditer(normal)}
        if len(labels) == 1 and not _FILLER.sub("", _LABEL.sub("", normal)):
            (label,) = labels
            if self._pending and self._heading is None:
                self._below(label, line)
            else:
                self._heading = label
            return
        lead = _LEAD.match(normal)
        if (lead and not _LABEL.search(lead["name"])) or _SHAPED.search(line):
            self.invented.setdefault(lead["name"] if lead else normal[:200])
        elif labels and self._pending and self._heading is None:
            first = _LABEL.search(normal)
            self._below(_verdict(first) if first else None, line)
        elif says_nothing(line):
            self.nothing = True

    def _matches(self, normal: str) -> list[re.Match[str]]:
        if self._asked is None:
            return []
        found = list(self._asked.finditer(normal))
        if self._loose:
            return found
        return [match for match in found if _anchored(normal, match)]

    def _answers(self, normal: str, matches: list[re.Match[str]], line: str) -> None:
        """A line that names strings."""
        starts = [*(match.start() for match in matches[1:]), len(normal)]
        behind = [normal[m.end() : end] for m, end in zip(matches, starts, strict=True)]
        before = normal[: matches[0].start()]
        front = {_verdict(match) for match in _LABEL.finditer(before)}
        labels: list[Verdict | None]
        if len(front) == 1 and not _LABEL.search(behind[-1]):
            labels = []
            (last,) = front
            for words in behind:  # the label first: 'unsafe': a, b; 'normal': c
                labels.append(last)
                last = ([last] + [_verdict(m) for m in _LABEL.finditer(words)])[-1]
        else:
            labels = [_verdict(m) if (m := _LABEL.search(words)) else None for words in behind]
            for k in range(len(labels) - 2, -1, -1):  # 'a', 'b' and 'c': 'unsafe'
                if labels[k] is None and not re.search(r"\w", behind[k].replace("and", "")):
                    labels[k] = labels[k + 1]
        names = [name for match in matches for name in self._meant[match.group()]]
        for match, label, words in zip(matches, labels, behind, strict=True):
            own = line if len(matches) == 1 else f"'{match.group()}{words}"
            for name in self._meant[match.group()]:
                self._note(name, label or self._heading, notify_in(words), own)
        self._pending = () if any(labels) else tuple(names)

    def _below(self, label: Verdict | None, line: str) -> None:
        """A line that says what those of the line before are."""
        for name in self._pending:
            self._note(name, label, notify_in(line), f"{self.said[name].words} {line}")
        self._pending = ()

    def _note(self, name: str, label: Verdict | None, notify: Notify | None, words: str) -> None:
        before = self.said.get(name)
        if before is None or before.verdict is None:
            self.said[name] = Said(label, notify, words.strip()[:_WORDS])
        elif before.notify is None and notify is not None and before.verdict == label:
            self.said[name] = replace(before, notify=notify)


def _anchored(normal: str, match: re.Match[str]) -> bool:
    """True where a line answers for a name: at its head, in quotes or behind a comma, and with a
    quote, a colon, a label or nothing behind it."""
    before, after = normal[: match.start()], normal[match.end() :]
    head = re.fullmatch(r"\W*(?:\d+\W+)?", before) is not None or before.rstrip()[-1:] in "',;["
    return (
        head and re.match(r"'|\s*(?:[:=–—|,;\-\]]|$|is\b|are\b|\(|unsa|normal)", after) is not None
    )


def _normal(text: str) -> str:
    """Small letters, one kind of quotes, single spaces, no markdown."""
    return " ".join(_MARKS.sub("", text.translate(_QUOTES)).lower().split())


def _verdict(match: re.Match[str]) -> Verdict:
    return _VERDICTS[match.lastgroup or "normal"]
