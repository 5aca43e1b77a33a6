"""What every term of a predicate can do."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Collection
from typing import Any, ClassVar, NamedTuple

from sdgen.catalog.predicate import Evidence, FactSource, Verdict
from sdgen.catalog.reader import Reader
from sdgen.scene import Record
from sdgen.vocabulary import ZONE_KEEP_SHARE
from sdgen.yaml_source import Path_, Source


class Case(NamedTuple):
    """What a recipe says of the object it makes: a category, a target, and its limits."""

    category: str
    state: str | None = None
    rooms: tuple[str, ...] = ()
    #: ``None`` where the recipe changes an object that the home has.
    relation: str | None = None
    target: str | None = None
    zone: tuple[str, ...] = ()
    avoid_zones: tuple[str, ...] = ()
    min_height_m: float | None = None
    max_height_m: float | None = None
    not_state: tuple[str, ...] = ()
    #: How much of it is in the zone that is asked for, at least.
    zone_share: float = ZONE_KEEP_SHARE

    @property
    def on_the_floor(self) -> bool:
        """The recipe puts it there."""
        return self.relation == "ON" and self.target == "floor"


class Can(NamedTuple):
    """What a predicate could be of an object that follows a recipe, as far as the recipe says."""

    be_true: bool
    be_false: bool


EITHER, ALWAYS, NEVER = Can(True, True), Can(True, False), Can(False, True)


class Scope(NamedTuple):
    """What reading a term needs: the names there are, and how terms within it are read."""

    categories: Collection[str]
    rooms: Collection[str]
    read: Callable[[Source, Path_, Any], Term]


class Term(Record, ABC):
    """One term: read from YAML, evaluated and measured on facts, said in words, and checked
    against what recipes make. Its record is what ``catalogue.json`` holds, tagged by ``kind``."""

    #: Looked up rather than measured: such terms are asked first, and most pairs end there.
    cheap: ClassVar[bool] = False
    #: A floor plan is made for it: such terms are asked last.
    dear: ClassVar[bool] = False

    @classmethod
    @abstractmethod
    def read(cls, reader: Reader, scope: Scope) -> Term | None:
        """The term a mapping asks for, None when it has none; problems are noted."""

    @abstractmethod
    def evaluate(self, object_id: int, facts: FactSource) -> Verdict:
        """Whether it holds for an object, how surely, and what was measured."""

    def measure(self, object_id: int, facts: FactSource) -> Evidence:
        """What it measures of an object whether or not it holds: the evidence of a near miss,
        such as the height of a knife on a high shelf."""
        return dict(self.evaluate(object_id, facts).evidence)

    @abstractmethod
    def in_words(self) -> str:
        """A clause for people, such as ``it is ON``."""

    def possible(self, case: Case) -> Can:
        """What it could be of what a recipe makes; ``EITHER`` where the recipe leaves it open."""
        return EITHER

    def within(self) -> tuple[Term, ...]:
        """The terms it is made of."""
        return ()


def either(words: Collection[str]) -> str:
    """Names in a sentence: ``knife or fork``."""
    return " or ".join(words)
