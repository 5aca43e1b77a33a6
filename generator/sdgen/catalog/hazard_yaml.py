"""A file of ``hazards/`` as people write it, and the record it stands for."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from typing import Annotated, Any, Literal

from pydantic import Discriminator, Field, Tag, model_validator
from pydantic_core import InitErrorDetails

from sdgen.catalog.consistency import check_recipes
from sdgen.catalog.entry import Entry, as_record
from sdgen.catalog.limits import MAX_RECIPES
from sdgen.catalog.predicate_yaml import read_predicate
from sdgen.catalog.records import (
    Before,
    Concern,
    Group,
    Guidance,
    Hazard,
    Label,
    Near,
    PlaceRecipe,
    RemedyRule,
    SetRecipe,
    Severity,
)
from sdgen.catalog.terms import AllTerm, AnyTerm, HeightTerm, Predicate, RelationTerm
from sdgen.catalog.words import (
    Categories,
    Names,
    OptionalCategories,
    PartNames,
    RoomNames,
    State,
    States,
    Text,
    Weight,
    Word,
    Zones,
    between,
)
from sdgen.scene import Record
from sdgen.strict import Expect, problem, refuse
from sdgen.vocabulary import EVIDENCE_PIXELS, HOLDING, OPENINGS, HoldingRelation, Urgency

#: The label each group carries, and its order in listings.
LABELS: dict[Group, Label] = {
    "safety": "unsafe",
    "sanitation": "unsanitary",
    "child_safety": "unsafe for children",
}
Action = Literal[
    "close",
    "switch_off",
    "put_out",
    "empty",
    "put_in",
    "put_on",
    "move_away",
    "wipe_up",
    "sweep_up",
    "throw_away",
]
_PLACEHOLDERS = ("object", "target", "room")
#: No room is higher.
_Height = Annotated[float, between(0.0, 10.0)]


_NEAR = Annotated[Near | None, Expect("{to: [categories], max_m: metres}")]


class OverEdge(Record):
    """How far over the edge of what it is on a thing reaches, metres; below 0: so far within."""

    min_m: Annotated[float, between(-0.3, 0.5)]
    max_m: Annotated[float, between(-0.3, 0.5)]

    @model_validator(mode="after")
    def _check(self) -> OverEdge:
        if self.min_m > self.max_m:
            refuse(problem(("min_m",), f"min_m ({self.min_m:g}) is above max_m ({self.max_m:g})"))
        return self


class PlaceYaml(Record):
    """A recipe that puts a new object somewhere."""

    place: Categories
    state: State | None = None
    not_state: States = ()
    relation: HoldingRelation
    target: Categories
    zone: Zones = ()
    across: bool = False
    avoid_zones: Zones = ()
    rooms: RoomNames = ()
    min_height_m: _Height | None = None
    max_height_m: _Height | None = None
    near: _NEAR = None
    before: Annotated[Before | None, Expect("{of: [categories], max_m: metres}")] = None
    over_edge: Annotated[OverEdge | None, Expect("{min_m: metres, max_m: metres}")] = None
    weight: Weight = 1.0

    @model_validator(mode="after")
    def _check(self) -> PlaceYaml:
        low, high = self.min_height_m, self.max_height_m
        if low is not None and high is not None and low > high:
            text = f"min_height_m ({low:g}) is above max_height_m ({high:g})"
            refuse(problem(("min_height_m",), text))
        if self.relation == "INSIDE":
            # Nothing looks at zones where things are put into furniture.
            for key, zones in (("zone", self.zone), ("avoid_zones", self.avoid_zones)):
                if zones:
                    refuse(problem((key,), f"{key} needs 'relation: ON'"))
        if self.before is not None and self.target != ("floor",):
            refuse(problem(("before",), "before needs 'target: floor'"))
        if self.over_edge is not None and (self.relation != "ON" or "floor" in self.target):
            refuse(problem(("over_edge",), "over_edge needs 'relation: ON' and furniture to be on"))
        if self.across and not self.zone:
            refuse(problem(("across",), "across needs a zone that it lies across"))
        if self.zone and self.avoid_zones:
            refuse(problem(("avoid_zones",), "avoid_zones does nothing beside a zone"))
        return self

    def record(self) -> PlaceRecipe:
        """The record of it."""
        edge = self.over_edge and (self.over_edge.min_m, self.over_edge.max_m)
        return as_record(
            self, PlaceRecipe, categories=self.place, targets=self.target, over_edge=edge
        )


class SetYaml(Record):
    """A recipe that brings an object of the home into a state."""

    set: Categories
    state: State
    rooms: RoomNames = ()
    near: _NEAR = None
    weight: Weight = 1.0

    @model_validator(mode="after")
    def _check(self) -> SetYaml:
        if self.near is not None and self.near.bring:
            refuse(problem(("near", "bring"), "only what is placed brings something along"))
        return self

    def record(self) -> SetRecipe:
        """The record of it."""
        return as_record(self, SetRecipe, categories=self.set)


def _kind(value: Any) -> str | None:
    if isinstance(value, dict):
        return "<set>" if "set" in value else "<place>" if "place" in value else None
    return None


RecipeYaml = Annotated[
    # The tags are no keys, so that they cannot be taken for a step of a key path.
    Annotated[PlaceYaml, Tag("<place>")] | Annotated[SetYaml, Tag("<set>")],
    Discriminator(
        _kind,
        custom_error_type="recipe",
        custom_error_message="expected 'place: [categories]' or 'set: [categories]'",
    ),
]


class RemedyYaml(Record):
    """One step that undoes the anomaly."""

    action: Action
    target: OptionalCategories = ()

    @model_validator(mode="after")
    def _check(self) -> RemedyYaml:
        if self.action in ("put_in", "put_on") and not self.target:
            refuse(problem((), f"action {self.action} needs a target"))
        return self


class HazardYaml(Record):
    """The whole file; the predicate is read by its terms."""

    id: Word
    title: Text
    paper_class: Text = ""
    group: Group
    label: Label | None = None
    concerns: Annotated[Concern, Expect("{who: everyone}, or children, older_people, living_with")]
    urgency: Urgency
    never_silent: bool = False
    message: Text
    source: Annotated[
        Text | Annotated[tuple[Guidance, ...], Field(min_length=1)],
        Expect("text, or a list of {body: ..., title: ..., says: ...}"),
    ]
    severity: Annotated[Severity | None, Expect("{harm: ..., source: ...}")] = None
    predicate: Annotated[Any, Expect("terms: when is it true?")]
    relation: HoldingRelation | None = None
    evidence_state: State | None = None
    evidence_parts: PartNames = ()
    evidence_pixels: Annotated[int, between(1, 1000)] = EVIDENCE_PIXELS
    evidence_outdoors: Annotated[int, between(0, 10_000)] = 0
    anomalies: Annotated[
        tuple[RecipeYaml, ...],
        Field(min_length=1, max_length=MAX_RECIPES),
        Expect(f"at least one recipe, and at most {MAX_RECIPES}"),
    ]
    lookalikes: Annotated[
        tuple[RecipeYaml, ...],
        Field(max_length=MAX_RECIPES),
        Expect(f"at most {MAX_RECIPES} recipes"),
    ] = ()
    remedy: Annotated[tuple[RemedyYaml, ...], Field(min_length=1), Expect("at least one step")]
    replaces: bool = False

    @model_validator(mode="after")
    def _check(self) -> HazardYaml:
        found = [problem(("message",), text) for text in self._message()]
        wanted = LABELS[self.group]
        if self.label not in (None, wanted):
            found.append(problem(("label",), f"the label of group {self.group} is {wanted!r}"))
        found += [
            problem(("anomalies", index, "set"), f"{name} is placed by another recipe: not both")
            for index, recipe in enumerate(self.anomalies)
            if isinstance(recipe, SetYaml)
            for name in recipe.set
            if name in self._placed()
        ]
        found += self._evidence()
        if found:
            refuse(*found)
        return self

    def _evidence(self) -> Iterator[InitErrorDetails]:
        """What is wrong with the keys that say what shows it."""
        if self.evidence_state is not None and self.evidence_parts:
            text = "evidence_state names parts already: give one of the two"
            yield problem(("evidence_parts",), text)
        if "evidence_pixels" in self.model_fields_set and not (
            self.evidence_state is not None or self.evidence_parts
        ):
            text = f"of the whole thing {EVIDENCE_PIXELS} are needed: name its parts, too"
            yield problem(("evidence_pixels",), f"{text} (evidence_state or evidence_parts)")
        fills = all(
            isinstance(recipe, SetYaml) and set(recipe.set) <= {*OPENINGS}
            for recipe in self.anomalies
        )
        if self.evidence_outdoors and not fills:
            names = ", ".join(sorted(OPENINGS))
            text = f"only through openings: every anomaly must be a 'set' of some of {names}"
            yield problem(("evidence_outdoors",), text)

    def _placed(self) -> set[str]:
        """What its anomalies put there. None of it may also be set: the twin takes away the one
        and sets back the other, and must know which is which."""
        recipes = (recipe for recipe in self.anomalies if isinstance(recipe, PlaceYaml))
        return {name for recipe in recipes for name in recipe.place}

    def _message(self) -> list[str]:
        """What is wrong with the placeholders of the message."""
        out = []
        for name in re.findall(r"\{([^{}]*)\}", self.message):
            if name not in _PLACEHOLDERS:
                allowed = ", ".join(f"{{{word}}}" for word in _PLACEHOLDERS)
                out.append(f"unknown placeholder {{{name}}} (allowed: {allowed})")
            if name == "target" and self.relation is None:
                out.append("{target} needs 'relation: ON' or 'relation: INSIDE'")
        if re.search(r"[{}]", re.sub(r"\{[^{}]*\}", "", self.message)):
            out.append("has a brace without its pair")
        return out


def read_hazard(entry: Entry, names: Names) -> Hazard | None:
    """Read one hazard; None when problems were noted in the entry's source."""
    predicate: Predicate | None = None
    below = entry.key("predicate")
    if below is not None:
        path = (*entry.path, "predicate")
        known = set(names.categories), set(names.rooms)
        predicate = read_predicate(entry.source, path, below, *known)
    written = entry.read(HazardYaml, names)
    if written is None or predicate is None or entry.source.problems:
        return None
    if written.concerns.by_reach and not _always(predicate, _measures_reach):
        text = "by_reach needs a term 'height: {…, evidence: reach_height_m}' in the predicate"
        entry.problem(f"{text}, in every branch of an 'any'", "concerns", "by_reach")
    changes = any(isinstance(recipe, SetYaml) for recipe in written.anomalies)
    if changes and "{target}" in written.message and not _always(predicate, _stands_somewhere):
        # What a home has may hang on a wall, or be a door: nothing says that it is on something.
        text = "{target} of a thing that is set needs 'relation: ON' or 'INSIDE'"
        entry.problem(f"{text} in the predicate, too", "message")
    hazard = as_record(
        written,
        Hazard,
        label=LABELS[written.group],
        source=_in_words(written.source),
        guidance=() if isinstance(written.source, str) else written.source,
        predicate=predicate,
        anomalies=tuple(recipe.record() for recipe in written.anomalies),
        lookalikes=tuple(recipe.record() for recipe in written.lookalikes),
        remedy=tuple(RemedyRule(action=r.action, targets=r.target) for r in written.remedy),
        pack=entry.pack,
    )
    check_recipes(entry, hazard)
    return hazard


def _in_words(source: str | tuple[Guidance, ...]) -> str:
    return source if isinstance(source, str) else "; ".join(map(str, source)) + "."


def _always(predicate: Predicate, has: Callable[[Predicate], bool]) -> bool:
    """Whether such a term holds wherever the predicate does: it is some part of an ``all``, and
    one of every branch of an ``any`` (only one branch's evidence is kept)."""
    if isinstance(predicate, AllTerm):
        return any(_always(term, has) for term in predicate.within())
    if isinstance(predicate, AnyTerm):
        return all(_always(term, has) for term in predicate.within())
    return has(predicate)


def _measures_reach(term: Predicate) -> bool:
    return isinstance(term, HeightTerm) and term.evidence == "reach_height_m"


def _stands_somewhere(term: Predicate) -> bool:
    return isinstance(term, RelationTerm) and term.relation in HOLDING
