"""The unique anomalies of a catalogue, and its fit with an asset library."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping

from sdgen.catalog.cases import cases, unique_anomaly
from sdgen.catalog.contradiction import models_object, never
from sdgen.catalog.records import Catalog, Hazard, PlaceRecipe, UniqueAnomaly
from sdgen.catalog.terms.term import Case
from sdgen.errors import InputError, did_you_mean
from sdgen.vocabulary import UNCATEGORISED


def enumerate_anomalies(catalog: Catalog) -> tuple[UniqueAnomaly, ...]:
    """All unique anomalies, sorted and without repeats: what could be asked for."""
    found = {
        unique_anomaly(hazard.id, case)
        for hazard in catalog.hazards
        for recipe in hazard.anomalies
        for case in cases(recipe)
    }
    return tuple(sorted(found, key=_key))


def _key(item: UniqueAnomaly) -> tuple[str, ...]:
    return tuple(part or "" for part in item.model_dump().values())


def check_against_library(
    catalog: Catalog,
    library_states: Mapping[str, Collection[str]],
    library_parts: Mapping[str, Collection[str]] | None = None,
    library_holding: Mapping[str, Collection[str]] | None = None,
) -> None:
    """Check that every hazard can be made with the models there are.

    ``library_states`` maps each category that has a model to the states its models can be in.
    A recipe may name categories without a model (they are skipped) as long as one has one; a
    state that none of its models knows is a problem, and so is a model of a category that nobody
    defines: it would never be used. ``library_parts``, where given, maps the categories to the
    parts that their models have, and some part that shows a hazard must be among them.
    ``library_holding``, where given, says what takes things ``ON`` and ``INSIDE``: no recipe may
    put something so on or into what never does, and no predicate ask for it. Raises InputError
    with all problems.
    """
    known_categories = [category.name for category in catalog.categories]
    problems = [
        f"models of category {name!r}, which no catalogue defines"
        f"{did_you_mean(name, known_categories)}"
        for name in sorted(library_states)
        if name not in known_categories and name != UNCATEGORISED
    ]
    for hazard in catalog.hazards:
        made = 0
        for index, recipe in enumerate(hazard.anomalies):
            where = f"hazard {hazard.id}: anomalies[{index}]"
            present = [c for c in recipe.categories if c in library_states]
            fitting = [c for c in present if _knows(recipe.state, library_states[c])]
            if present and not fitting:
                known = sorted({s for c in present for s in library_states[c]})
                near = did_you_mean(recipe.state or "", known)
                problems.append(
                    f"{where}: no model of {', '.join(present)} can be {recipe.state}{near}"
                )
                made += 1
            elif fitting and isinstance(recipe, PlaceRecipe):
                targets = [t for t in recipe.targets if t == "floor" or t in library_states]
                if not targets:
                    problems.append(
                        f"{where}: no model of any target ({', '.join(recipe.targets)})"
                    )
                made += 1
            elif fitting:
                made += 1
        if not made:
            names = sorted({c for recipe in hazard.anomalies for c in recipe.categories})
            problems.append(
                f"hazard {hazard.id}: no model of any of its objects ({', '.join(names)}): name "
                "the folder of your models with --assets"
            )
        problems += _unknown_parts(hazard, library_parts)
        if library_holding is not None:
            problems += _never_held(hazard, library_states, library_holding)
    if problems:
        raise InputError(problems)


def _unknown_parts(
    hazard: Hazard, library_parts: Mapping[str, Collection[str]] | None
) -> Iterator[str]:
    """A problem where no model of what a hazard's recipes make has a part that is to show it; of
    some of the names there may be no model, as of categories."""
    if library_parts is None or not hazard.evidence_parts:
        return
    objects = {name for recipe in hazard.anomalies for name in recipe.categories}
    known = sorted({part for name in objects for part in library_parts.get(name, ())})
    if known and not set(known) & set(hazard.evidence_parts):
        names = ", ".join(hazard.evidence_parts)
        near = did_you_mean(hazard.evidence_parts[0], known)
        yield f"hazard {hazard.id}: evidence_parts: no model of its objects has a {names}{near}"


def _never_held(
    hazard: Hazard,
    library_states: Mapping[str, Collection[str]],
    library_holding: Mapping[str, Collection[str]],
) -> Iterator[str]:
    """A problem for each target that holds nothing so, and for a predicate that no model can be
    what it asks for."""
    if reason := never(hazard.predicate, models_object(library_states, library_holding)):
        yield f"hazard {hazard.id}: predicate: can never hold: {reason}"
    for key, recipes in (("anomalies", hazard.anomalies), ("lookalikes", hazard.lookalikes)):
        for index, recipe in enumerate(recipes):
            if not isinstance(recipe, PlaceRecipe):
                continue
            for target in recipe.targets:
                text = cannot_hold(recipe.relation, target, library_holding)
                if text and target in library_states:
                    yield f"hazard {hazard.id}: {key}[{index}].target: {text}"


def _knows(state: str | None, states: Collection[str]) -> bool:
    return state is None or state in states


def cannot_be_made(
    case: Case,
    library_states: Mapping[str, Collection[str]],
    library_holding: Mapping[str, Collection[str]],
) -> str:
    """Why no model can make a case; empty where some can. ``library_holding`` gives, by ``ON`` and
    ``INSIDE``, the categories that take things so."""
    states = library_states.get(case.category)
    if states is None:
        return f"the library has no model of {case.category}"
    if not _knows(case.state, states):
        near = did_you_mean(case.state or "", sorted(states))
        return f"no model of {case.category} can be {case.state}{near}"
    if case.target is None or case.relation is None or case.on_the_floor:
        return ""
    if case.target not in library_states:
        return f"the library has no model of {case.target}"
    return cannot_hold(case.relation, case.target, library_holding)


def cannot_hold(relation: str, target: str, library_holding: Mapping[str, Collection[str]]) -> str:
    """Why nothing can be put so ``relation`` a target; empty where something can."""
    if target in library_holding[relation] or (relation, target) == ("ON", "floor"):
        return ""
    lacks = {"ON": "a surface that things stand on", "INSIDE": "a hollow that things fit into"}
    return f"no model of {target} has {lacks[relation]}"
