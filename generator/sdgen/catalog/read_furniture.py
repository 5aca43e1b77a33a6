"""The furniture rules of a room type (``furniture`` in ``rooms.yaml``)."""

from __future__ import annotations

from sdgen.catalog.reader import Reader
from sdgen.catalog.records import FurnitureRule

_ALONE = ("wall", "corner", "middle", "row")
_RELATIVE = ("on", "beside", "before", "under", "around", "above", "opposite")


def read_rules(reader: Reader, categories: set[str]) -> tuple[FurnitureRule, ...]:
    """All rules of a room type, in order; problems are noted in the reader's source."""
    rules: list[FurnitureRule] = []
    for row in reader.rows("furniture", None):
        rule = _rule(row, categories)
        placed = {c for earlier in rules for c in (earlier.category, *earlier.row)}
        for name in rule.of:
            if name not in placed:
                row.problem(f"no {name} is placed before it in this room", "of")
        rules.append(rule)
    return tuple(rules)


def _rule(reader: Reader, categories: set[str]) -> FurnitureRule:
    where = reader.choice("where", (*_ALONE, *_RELATIVE))
    names: tuple[str, ...] = ()
    row: tuple[str, ...] = ()
    if where == "row":
        row = _row(reader, categories)
    else:
        names = reader.words("category", choices=categories, what="category")
    of: tuple[str, ...] = ()
    if where in _RELATIVE:
        of = reader.words("of", choices=categories, what="category")
    rule = FurnitureRule(
        category=names[0] if names else "",
        row=row,
        where=where,
        of=of,
        count=_count(reader),
        chance=reader.number("chance", 1.0, low=0.0, high=1.0),
        needed=reader.flag("needed"),
        front_m=reader.number("front_m", 0.5, low=0.0, high=5.0),
        gap_m=reader.number("gap_m", 0.0, low=-2.0, high=5.0),
        z_m=reader.number("z_m", 0.0, low=0.0, high=5.0),
    )
    reader.done()
    return rule


def _row(reader: Reader, categories: set[str]) -> tuple[str, ...]:
    out: list[str] = []
    for index, item in enumerate(reader.listed("row", "categories")):
        if item in categories:
            out.append(item)
        else:
            reader.problem(f"unknown category {item!r}", "row", index)
    return tuple(out)


def _count(reader: Reader) -> tuple[int, int]:
    if not reader.has("count"):
        return 1, 1
    least, most = reader.span("count", low=0, high=20)
    if least != int(least) or most != int(most):
        reader.problem("expected whole numbers", "count")
    return int(least), int(most)
