"""The predicate language as people write it, read into the tagged records of ``terms/``.

``{category: [knife], height: {max_m: 1.3}}`` means that all of it holds; ``all``, ``any`` and
``not`` nest. See ``hazard_catalog/README.md``.
"""

from __future__ import annotations

from collections.abc import Collection
from typing import Any

from sdgen.catalog.limits import MAX_TERMS
from sdgen.catalog.reader import Reader
from sdgen.catalog.terms import TERMS, AllTerm, Predicate
from sdgen.catalog.terms.term import Scope
from sdgen.yaml_source import Path_, Source


def read_predicate(
    source: Source, path: Path_, value: Any, categories: Collection[str], rooms: Collection[str]
) -> Predicate:
    """Read one predicate; problems are noted in ``source`` and a stand-in is returned."""
    count = 0

    def read(source: Source, path: Path_, value: Any) -> Predicate:
        nonlocal count
        count += 1
        if count > MAX_TERMS:
            if count == MAX_TERMS + 1:
                source.problem(path, f"the predicate has more than {MAX_TERMS} terms")
            return AllTerm(terms=())
        if isinstance(value, list):
            terms = [read(source, (*path, index), item) for index, item in enumerate(value)]
            if not terms:
                source.problem(path, "expected at least one term")
            return AllTerm(terms=tuple(terms))
        reader = Reader(source, path, value)
        if reader.ok and not reader.data:
            reader.problem(f"expected one of the terms {', '.join(TERMS)}")
        scope = Scope(categories, rooms, read)
        found = [one for term in TERMS.values() if (one := term.read(reader, scope)) is not None]
        for key in reader.data:
            if key in TERMS and reader.data[key] is None:
                reader.problem("is empty", key)
        reader.done()
        return found[0] if len(found) == 1 else AllTerm(terms=tuple(found))

    return read(source, path, value)
