"""A term from its text."""

from __future__ import annotations

from sdgen.catalog.predicate_yaml import read_predicate
from sdgen.catalog.terms import Term
from sdgen.yaml_source import parse_yaml

CATEGORIES = {"sofa", "bed", "tv", "plate", "bowl", "shelf", "floor"}


def read(text: str) -> tuple[Term, list[str]]:
    """The term, and what is wrong with it."""
    source = parse_yaml(text.encode(), "p.yaml")
    return read_predicate(source, (), source.value, CATEGORIES, set()), source.problems
