"""Tables of sources: which category each of their models is, and what else is known of it.

One YAML file a source lies in ``hazard_catalog/sources``; a table of the user's own comes before
it. A row names models whole or by a pattern with ``*``; of several that fit, a whole name comes
before patterns, and the pattern with most letters before others.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Annotated, Literal

from pydantic import model_validator

from sdgen.catalog.records import Catalog
from sdgen.catalog.words import Names, States, Text, between, names_of
from sdgen.errors import InputError, UsageError, did_you_mean
from sdgen.importing.words import Words, category_names, load_words
from sdgen.resources import data_path
from sdgen.scene import Record
from sdgen.strict import Expect, no_mapping, problem, read, refuse
from sdgen.vocabulary import Facing
from sdgen.yaml_source import Source, read_yaml

#: Sources with a table of their own; ``folder`` is for models that lie anywhere.
SOURCES = ("ycb", "gso", "replicacad", "fantastic-breaks", "folder")
#: Axes of a file, before it is turned to Z up.
Axis = Literal["+x", "-x", "+y", "-y", "+z", "-z"]
#: What collections write after a name: how large its textures are.
_RESOLUTION = re.compile(r"_(1|2|4|8|16)k$")


class Row(Record):
    """What a table says of some ``models``, named whole or by a pattern with ``*``.

    ``category``: ours, or several of which the size decides; without one, ``why`` says why we have
    none, or ``skip`` why it is no household thing and should not be imported at all.
    ``front``: the axis that its front looks along once it is turned to Z up. ``up``: the axis of
    the file that is up, where the file itself says wrong; ``scale``: likewise of its unit (metres
    a unit = what the file says, times this). ``states``: those it comes in (``[BROKEN]``).
    """

    models: Annotated[
        tuple[str, ...], names_of("model's name"), Expect("a model's name or a list of them")
    ]
    category: Annotated[tuple[str, ...], names_of("category", least=0)] = ()
    why: Text = ""
    skip: Text = ""
    front: Facing | None = None
    up: Axis | None = None
    mass_kg: Annotated[float | None, between(0.0001, 1000.0)] = None
    scale: Annotated[float | None, between(0.0001, 10000.0)] = None
    states: States = ()

    @model_validator(mode="after")
    def _says_one_thing(self) -> Row:
        said = [key for key in ("category", "why", "skip") if getattr(self, key)]
        if not said:
            refuse(problem((), "missing key 'category': expected one, or 'why' there is none"))
        if len(said) > 1:
            refuse(problem((said[-1],), f"does not go with {said[0]!r}"))
        return self


class _TableYaml(Record):
    """A table as people write it."""

    rows: Annotated[tuple[Row, ...], Expect("a list of rows")]


@dataclass(frozen=True)
class Table:
    """The rows of a source, in ``layers``: what an earlier one names, no later one does.

    ``words`` are for guessing what none of them names.
    """

    words: Words
    layers: tuple[tuple[Row, ...], ...] = ()

    def row(self, name: str) -> Row | None:
        """What is known of a model, by its name or by the last part of it (``fridge/body``)."""
        whole = model_key(name)
        parts = whole.rsplit("/", 1)
        for layer in self._lookups:
            for key in dict.fromkeys((whole, parts[-1])):
                found = layer.find(key) or layer.find(_RESOLUTION.sub("", key))
                if found is not None:
                    return found
        return None

    @cached_property
    def _lookups(self) -> tuple[_Lookup, ...]:
        return tuple(_Lookup(rows) for rows in self.layers)


class _Lookup:
    """The rows of one file by what they name."""

    def __init__(self, rows: Sequence[Row]) -> None:
        named = [(model_key(name), row) for row in rows for name in row.models]
        self._whole = {name: row for name, row in named if "*" not in name}
        patterns = [(name, row) for name, row in named if "*" in name]
        # Stable: of as many letters, the one written first.
        patterns.sort(key=lambda item: -len(item[0].replace("*", "")))
        self._patterns = [(_pattern(name), row) for name, row in patterns]

    def find(self, key: str) -> Row | None:
        if key in self._whole:
            return self._whole[key]
        return next((row for pattern, row in self._patterns if pattern.fullmatch(key)), None)


def model_key(name: str) -> str:
    """A name as names are compared: case, composed letters and blanks make no difference."""
    return "_".join(unicodedata.normalize("NFC", name).casefold().split())


def _pattern(name: str) -> re.Pattern[str]:
    return re.compile(".*".join(map(re.escape, name.split("*"))), re.DOTALL)


def load_table(source: str, catalog: Catalog, own: Sequence[Path] = ()) -> Table:
    """The table of a source, below the user's ``own`` (the first of them counts most).

    Raises UsageError for a source that nobody knows and InputError with every problem of the
    files, each ``file:line: key path: problem``.
    """
    if source not in SOURCES:
        raise UsageError(f"unknown source {source!r}{did_you_mean(source, SOURCES)}")
    file = f"{source}.yaml"
    shipped = data_path("hazard_catalog", "sources", file)
    files = [(path, str(path)) for path in own]
    files.append((shipped, f"hazard_catalog/sources/{file}"))
    names = category_names(catalog)
    layers: list[tuple[Row, ...]] = []
    problems: list[str] = []
    for path, shown in files:
        try:
            layers.append(read_table(read_yaml(path, shown), names))
        except InputError as error:
            problems += error.problems
    if problems:
        raise InputError(problems)
    return Table(load_words(catalog), tuple(layers))


def read_table(source: Source, names: Names) -> tuple[Row, ...]:
    """The rows of a parsed file. Raises InputError with all that is wrong in it."""
    written = None
    if source.value is None and not source.problems:
        source.problem((), no_mapping(source.value))
    elif source.value is not None:
        written = read(source, (), source.value, _TableYaml, names)
    if written is not None:
        for at, text in _named_twice(written.rows):
            source.problem(("rows", at, "models"), text)
    if source.problems or written is None:
        raise InputError(source.problems)
    return written.rows


def _named_twice(rows: Sequence[Row]) -> Iterator[tuple[int, str]]:
    """Rows that name what an earlier one names, and what to say of it."""
    first: dict[str, int] = {}
    for at, row in enumerate(rows):
        for name in row.models:
            key = model_key(name)
            if key in first:
                yield at, f"{name[:80]!r} is named by rows[{first[key]}] already"
            elif not key.strip("_"):
                yield at, f"{name[:80]!r} names no model"
            else:
                first[key] = at
