"""What is not wrong, but seldom meant: what a hazard's recipes leave to chance that its predicate
asks for, and homes without light.

What is left to chance comes about now and then; but of a build's tries at such a hazard most come
to nothing.
"""

from __future__ import annotations

from collections.abc import Iterator

from sdgen.catalog.records import Hazard, HomeSpec, PlaceRecipe
from sdgen.catalog.terms import AllTerm, DistanceTerm, StateTerm, Term
from sdgen.catalog.terms.term import either


def advice(hazard: Hazard) -> Iterator[str]:
    """One line for each wish of the predicate that a recipe of the anomalies does not see to."""
    predicate = hazard.predicate
    terms = predicate.terms if isinstance(predicate, AllTerm) else (predicate,)
    for index, recipe in enumerate(hazard.anomalies):
        # A recipe that sets a state finds its things where they are.
        if isinstance(recipe, PlaceRecipe):
            for term in terms:
                for text in _left_to_chance(term, recipe):
                    yield f"hazard {hazard.id!r}: anomalies[{index}]: {text}"


def home_advice(home: HomeSpec) -> Iterator[str]:
    """A line when a home has neither windows nor lamps: others are given lamps, this has what is
    drawn."""
    drawn = {item.category for room in home.rooms for item in room.furniture}
    windows = any(opening.kind == "window" for opening in home.openings)
    if home.as_drawn and not windows and not any(name.endswith("lamp") for name in drawn):
        yield f"home {home.id!r}: it has neither a window nor a lamp: its pictures are dim"


def _left_to_chance(term: Term, recipe: PlaceRecipe) -> Iterator[str]:
    if isinstance(term, StateTerm) and recipe.state is None and not recipe.not_state:
        yield f"the predicate asks that {term.in_words()}, and the recipe names no state"
    if isinstance(term, DistanceTerm) and term.to and term.max_m is not None:
        near = recipe.near
        if near is not None and set(near.to) <= set(term.to):
            if near.max_m > term.max_m:
                yield (
                    f"near.max_m is {near.max_m:g}, and the predicate asks for at most "
                    f"{term.max_m:g} m"
                )
        elif not (set(recipe.targets) <= set(term.to) or _before(recipe, term)):
            yield (
                f"the predicate asks for {either(term.to)} at most {term.max_m:g} m away: say "
                f"'near: {{to: {term.to[0]}, max_m: {term.max_m - term.margin_m:g}}}'"
            )


def _before(recipe: PlaceRecipe, term: DistanceTerm) -> bool:
    """Whether it is put before what it is to be near."""
    return recipe.before is not None and set(recipe.before.of) <= set(term.to)
