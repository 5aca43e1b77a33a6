"""Which of our categories a model is: by its source's table, or by a guess that says it is one."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Literal

from sdgen.catalog.records import Catalog, Category
from sdgen.geometry import Vec3
from sdgen.importing.sizes import difference, fits, in_metres, misfit, turned, unit_suspected
from sdgen.importing.table import Axis, Row, Table
from sdgen.importing.words import Found, Words
from sdgen.vocabulary import Facing

#: Characters shown of a name.
_LONGEST_NAME = 100


@dataclass(frozen=True)
class Choice:
    """Which category a model is (None: none of ours), how that was found, and ``why``: one line.

    ``doubts``: what a person should look at; ``unit``: the scale with which it would be as large
    as such things are, where it is not. The rest is what the table knows of it, see ``Row``;
    ``skip`` says why it should not be imported at all.
    """

    category: str | None
    how: Literal["table", "guess", "none"]
    why: str
    doubts: tuple[str, ...] = ()
    unit: float | None = None
    skip: str = ""
    front: Facing | None = None
    up: Axis | None = None
    mass_kg: float | None = None
    scale: float | None = None
    states: tuple[str, ...] = ()


def categorise(
    name: str,
    extents_m: Vec3 | None,
    table: Table,
    catalog: Catalog,
    hints: Sequence[str] = (),
) -> Choice:
    """The category of a model.

    ``name`` is what its source calls it. ``extents_m``: deep, wide, high in metres, Z up, with the
    ``up`` and ``scale`` of its row (:meth:`Table.row`) applied; None when nobody knows. A row's
    category is trusted whatever the size, and a difference told. Without a row the name is asked,
    then each of the ``hints`` (descriptions, classes of the source), and the size must be
    plausible, within a factor of 1.25 of what such things have.
    """
    row = table.row(name)
    if row is None:
        return _guess(name, extents_m, table, catalog, hints)
    choice = _by_table(row, extents_m, catalog)
    return replace(
        choice,
        skip=row.skip,
        front=row.front,
        up=row.up,
        mass_kg=row.mass_kg,
        scale=row.scale,
        states=row.states,
    )


def _by_table(row: Row, extents_m: Vec3 | None, catalog: Catalog) -> Choice:
    if not row.category:
        return Choice(None, "table", f"table: {row.skip or row.why}")
    if extents_m is None:
        return Choice(row.category[0], "table", f"table: {row.category[0]}")
    category = _nearest(row.category, extents_m, catalog)
    why = f"table: {category.name}"
    doubts = tuple(filter(None, (difference(extents_m, category),)))
    unit = unit_suspected(extents_m, category)
    return Choice(category.name, "table", why, doubts=doubts, unit=unit)


def _guess(
    name: str, extents_m: Vec3 | None, table: Table, catalog: Catalog, hints: Sequence[str]
) -> Choice:
    said = _said(name, hints, table.words)
    if not said:
        return Choice(None, "none", "no category fits: the name says nothing that we know")
    where, found = said[0]
    if not found.categories:
        why = f"no category fits: {found.phrase!r} in {where} is none of ours"
        return Choice(None, "none", why)
    if extents_m is None:
        why = f"guess from {found.phrase!r} in {where}"
        return Choice(found.categories[0], "guess", why, doubts=("nobody knows its size",))
    for where, found in said:
        category = _nearest(found.categories, extents_m, catalog)
        if fits(extents_m, category) or turned(extents_m, category):
            why = f"guess from {found.phrase!r} in {where} and the size"
            doubts = (difference(extents_m, category), *_denials(category, said))
            return Choice(category.name, "guess", why, doubts=tuple(filter(None, doubts)))
    return _unfit(*said[0], extents_m, catalog)


def _said(name: str, hints: Sequence[str], words: Words) -> list[tuple[str, Found]]:
    """What the name and the hints say, likeliest first, with words for where.

    A name may say that it is none of ours; of a hint that says little.
    """
    named = words.find(name)
    if named and not named[0].categories:
        return [("the name", named[0])]
    texts = [("the name", named)]
    texts += [(f"the hint {_shown(hint)}", words.find(hint)) for hint in hints]
    return [(where, found) for where, all_ in texts for found in all_ if found.categories]


def _denials(category: Category, said: Sequence[tuple[str, Found]]) -> Iterator[str]:
    for where, found in said:
        if category.name not in found.categories:
            yield f"{found.phrase!r} in {where} says otherwise"


def _unfit(where: str, found: Found, extents_m: Vec3, catalog: Catalog) -> Choice:
    """It is called something that is never so large, or so small."""
    category = _nearest(found.categories, extents_m, catalog)
    units = (unit_suspected(extents_m, catalog.category(name)) for name in found.categories)
    unit = next((unit for unit in units if unit is not None), None)
    why = f"no category fits: {found.phrase!r} in {where}, but {in_metres(extents_m)}"
    return Choice(None, "none", f"{why}: {difference(extents_m, category)}", unit=unit)


def _nearest(names: Sequence[str], extents_m: Vec3, catalog: Catalog) -> Category:
    """The category whose range the size is in or nearest to; of several, the one named first."""
    return min(map(catalog.category, names), key=lambda category: misfit(extents_m, category))


def _shown(name: str) -> str:
    """A name from a stranger's file on one line."""
    return repr(name if len(name) <= _LONGEST_NAME else f"{name[:_LONGEST_NAME]}...")[1:-1]
