"""What of an answer could be the hazard at all, by words alone: one placement at a time."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any, Literal, NamedTuple

from sdgen.catalog.cases import cases, unique_anomaly
from sdgen.catalog.enumeration import cannot_be_made
from sdgen.catalog.hazard_yaml import PlaceYaml, SetYaml
from sdgen.catalog.records import Catalog, Hazard, Recipe, SetRecipe
from sdgen.catalog.terms.term import Case
from sdgen.catalog.words import Names
from sdgen.errors import InputError, did_you_mean, one_line
from sdgen.library import Library
from sdgen.strict import no_mapping, read, shown, unknown_key
from sdgen.vocabulary import OPENINGS
from sdgen.yaml_source import Source

#: Placements that one answer may stand for: a prompt's 40 lines, with dozens of targets each.
MAX_IDEAS = 1000

#: Words that name nothing; lines that are no recipe; what no model or predicate allows; objects
#: that the predicate knows nothing of, which may be worth a word there; what the hazard has
#: already; what found no place in any home.
Why = Literal["unknown", "malformed", "impossible", "beyond", "duplicate", "unfit"]

_PLACE = "place state relation target rooms zone avoid_zones min_height_m max_height_m reason"
_SET = "set state rooms reason"


class Refused(NamedTuple):
    """A placement, or a whole line of the answer, that is not taken, and why."""

    line: int
    what: str
    why: Why
    detail: str


@dataclass(frozen=True)
class Idea:
    """A placement that may be the hazard: a recipe of one case, from a line of the answer;
    ``also`` are other hazards that it is, too."""

    line: int
    recipe: Recipe
    reason: str
    also: tuple[str, ...] = ()

    @property
    def what(self) -> str:
        """``vase ON desk``."""
        return in_words(cases(self.recipe)[0])


@dataclass
class Checked:
    """The placements of an answer that are worth a try, and what is left out already."""

    ideas: list[Idea] = field(default_factory=list)
    refused: list[Refused] = field(default_factory=list)


def checked(source: Source, hazard: Hazard, catalog: Catalog, library: Library) -> Checked:
    """Every placement of an answer, as far as it can be judged without a home.

    Raises InputError where it stands for more than ``MAX_IDEAS``.
    """
    judge = _Judge(hazard, catalog, library)
    out = Checked()
    for index, item in enumerate(source.value):
        line = source.line((index,))
        for found in judge.line(source, index, item, line):
            (out.ideas if isinstance(found, Idea) else out.refused).append(found)  # type: ignore[arg-type]
        if len(out.ideas) + len(out.refused) > MAX_IDEAS:
            text = f"the list stands for more than {MAX_IDEAS} placements"
            raise InputError([f"{source.file}:{line}: {text}"])
    return out


def in_words(case: Case) -> str:
    """``broken vase ON desk``, ``stove ON in a kitchen``."""
    if case.relation is None:
        return f"{case.category} {case.state}{_rooms(case)}"
    state = f"{case.state} " if case.state else ""
    return f"{state}{case.category} {case.relation} {case.target}{_rooms(case)}"


def _rooms(case: Case) -> str:
    return f" in a {' or '.join(case.rooms)}" if case.rooms else ""


class _Judge:
    """What a hazard has, and what may be asked for."""

    def __init__(self, hazard: Hazard, catalog: Catalog, library: Library) -> None:
        self.hazard = hazard
        self.catalog = catalog
        self.categories = tuple(sorted(c.name for c in catalog.categories))
        self.rooms = tuple(sorted(room.name for room in catalog.room_types))
        self.states = library.states_by_category()
        self.holding = library.holding()
        self.had = {unique_anomaly(hazard.id, case) for r in hazard.anomalies for case in cases(r)}
        #: What is placed may not be set, too, nor the other way round.
        self.kinds = {c: r.kind for r in hazard.anomalies for c in r.categories}

    def line(self, source: Source, index: int, item: Any, line: int) -> Iterator[Idea | Refused]:
        """Every placement that a line of the answer stands for."""
        if not isinstance(item, dict):
            yield Refused(line, shown(item), "malformed", no_mapping(item))
            return
        sets = "set" in item and "place" not in item
        known = (_SET if sets else _PLACE).split()
        for key in (key for key in item if key not in known):
            yield Refused(line, one_line(key), "malformed", unknown_key(key[:80], known))
        reason = item.get("reason")
        written = {key: value for key, value in item.items() if key in known and key != "reason"}
        unknown = list(self._without_unknown(written, line))
        yield from unknown
        own = Source(source.file, source.value, source.lines)
        names = Names(self.categories, self.rooms)
        kind: type[SetYaml] | type[PlaceYaml] = SetYaml if sets else PlaceYaml
        recipe = read(own, (index,), written, kind, names)
        if recipe is None:
            # Of a line whose words were all unknown enough is said.
            emptied = any(written.get(key) == [] for key in ("place", "set", "target", "rooms"))
            if not (unknown and emptied):
                text = one_line("; ".join(text for _, text in own.noted))
                yield Refused(line, "", "malformed", text)
            return
        said = one_line(reason) if isinstance(reason, str) else ""
        yield from self._placements(recipe.record(), line, said)

    def _without_unknown(self, written: dict[str, Any], line: int) -> Iterator[Refused]:
        """Take out words that name nothing; rooms that are none do not become all rooms."""
        for key, what, choices in (
            ("place", "category", self.categories),
            ("set", "category", self.categories),
            ("target", "category", self.categories),
            ("rooms", "room type", self.rooms),
        ):
            words = [written[key]] if isinstance(written.get(key), str) else written.get(key)
            if not isinstance(words, list):
                continue
            wrong = [word for word in words if isinstance(word, str) and word not in choices]
            for word in wrong:
                near = did_you_mean(word[:80], choices)
                text = f"unknown {what} {one_line(word[:80])!r}{near}"
                yield Refused(line, one_line(word[:80]), "unknown", text)
            if wrong:
                left = [word for word in words if word not in wrong]
                written[key] = left
                if not left and key == "rooms":
                    del written["rooms"]
                    written["place"] = written["set"] = []

    def _placements(self, recipe: Recipe, line: int, reason: str) -> Iterator[Idea | Refused]:
        for case in cases(recipe):
            what = in_words(case)
            if text := self._impossible(recipe, case):
                yield Refused(line, what, "impossible", text)
                continue
            if not self.hazard.predicate.possible(Case(case.category)).be_true:
                text = f"the predicate is never true of a {case.category}; if it should be, add it"
                yield Refused(line, what, "beyond", text)
                continue
            if not self.hazard.predicate.possible(case).be_true:
                text = f"can never satisfy the predicate: {self.hazard.predicate.in_words()}"
                yield Refused(line, what, "impossible", text)
                continue
            unique = unique_anomaly(self.hazard.id, case)
            anywhere = unique.model_copy(update={"room": None})
            if unique in self.had or anywhere in self.had:
                yield Refused(line, what, "duplicate", "the hazard has it, or the list had it")
                continue
            self.had.add(unique)
            self.kinds.setdefault(case.category, recipe.kind)
            also = tuple(
                other.id
                for other in self.catalog.hazards
                if other.id != self.hazard.id and not other.predicate.possible(case).be_false
            )
            yield Idea(line, one_case(recipe, case), reason, also)

    def _impossible(self, recipe: Recipe, case: Case) -> str:
        """Why no build could make it this hazard; empty where it might."""
        if text := cannot_be_made(case, self.states, self.holding):
            return text
        if self.kinds.get(case.category, recipe.kind) != recipe.kind:
            return f"{case.category} is {_DONE[self.kinds[case.category]]} by another recipe"
        if isinstance(recipe, SetRecipe) and self.hazard.evidence_outdoors:
            return (
                "" if case.category in OPENINGS else "is no opening that one sees outdoors through"
            )
        return ""


_DONE = {"place": "placed", "set": "set"}


def one_case(recipe: Recipe, case: Case) -> Recipe:
    """The recipe, of this case alone."""
    changes: dict[str, object] = {"categories": (case.category,), "rooms": case.rooms}
    if not isinstance(recipe, SetRecipe):
        changes["targets"] = (case.target,)
    return recipe.model_copy(update=changes)
