"""A namer that asks the sources' tables, and guesses from names and sizes."""

from __future__ import annotations

from sdgen.catalog.records import Catalog
from sdgen.importing.categorise import Choice, categorise
from sdgen.importing.scenes.found import FoundPiece
from sdgen.importing.scenes.naming import Named, Namer, exact_namer
from sdgen.importing.table import load_table

#: Format -> whose names its things have.
_TABLES = {"replicacad": "replicacad"}
_ANYBODYS = "folder"
_CLOSED = ("virtualhome",)


def table_namer(format_: str, catalog: Catalog) -> Namer:
    """Knows our own names, then the rows of a format's table, then guesses. Of VirtualHome's, whose
    classes are all known, nothing is guessed."""
    exact = exact_namer(catalog)
    if format_ in _CLOSED:
        return exact
    table = load_table(_TABLES.get(format_, _ANYBODYS), catalog)

    def named(piece: FoundPiece) -> Named:
        ours = exact(piece)
        if ours.category is not None and table.row(piece.name) is None:
            return ours
        extents = piece.extents_m if piece.sized else None
        choice = categorise(piece.name, extents, table, catalog, piece.names)
        if choice.category is None and extents is not None and choice.how != "table":
            # Furniture may be longer than any of ours: counters, rows of cabinets.
            long = categorise(piece.name, None, table, catalog, piece.names)
            if long.category is not None and catalog.category(long.category).kind == "furniture":
                choice = long
        return _as_named(choice)

    return named


def _as_named(choice: Choice) -> Named:
    return Named(
        category=choice.category,
        why=choice.skip or choice.why,
        guessed=choice.how == "guess",
        front=choice.front,
    )
