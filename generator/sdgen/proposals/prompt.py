"""What a language model is asked: the hazard, and all the words that an answer may use."""

from __future__ import annotations

from functools import cache

import jinja2

from sdgen.catalog.records import Catalog, Category
from sdgen.library import Library
from sdgen.proposals.recipe_text import recipe_line


def prompt_of(hazard_id: str, catalog: Catalog, library: Library) -> str:
    """The prompt for further recipes of a hazard: plain text."""
    hazard = catalog.hazard(hazard_id)
    there = [c for c in catalog.categories if library.by_category(c.name)]
    return (
        _environment()
        .get_template("prompt.txt.j2")
        .render(
            hazard=hazard,
            recipes=[recipe_line(recipe) for recipe in hazard.anomalies],
            things=_states([c for c in there if c.kind in ("small", "hazard_only")], library),
            furniture=_states([c for c in there if c.kind in ("furniture", "opening")], library),
            supports=sorted(library.holding()["ON"]),
            hollows=sorted(library.holding()["INSIDE"]),
            rooms=[room.name for room in catalog.room_types],
        )
    )


def _states(categories: list[Category], library: Library) -> dict[str, list[str]]:
    known = library.states_by_category()
    return {c.name: sorted(known[c.name]) for c in categories}


@cache
def _environment() -> jinja2.Environment:
    return jinja2.Environment(
        loader=jinja2.PackageLoader("sdgen.proposals", "templates"),
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        autoescape=False,
    )
