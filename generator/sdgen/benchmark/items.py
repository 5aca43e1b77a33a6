"""Per-item results: a row for every anomaly, false alarm and lookalike left alone."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from sdgen.benchmark.collect import Collected
from sdgen.benchmark.outcome import Item
from sdgen.benchmark.truth import Ways
from sdgen.dataset.output_file import output_file
from sdgen.dataset.text import compact
from sdgen.errors import UsageError

#: The columns, in their order; docs/metrics.md says what they hold.
COLUMNS = (
    "detector",
    "scene",
    "split",
    "kind",
    "object_id",
    "category",
    "room",
    "anomaly",
    "hazard",
    "near_miss_of",
    "label",
    "label_said",
    "notify",
    "notify_said",
    "score",
    "visibility",
    "seen",
    "category_seen",
    "told_apart",
)
SUFFIXES = (".jsonl", ".csv")


def item_rows(found: Collected) -> Iterator[dict[str, Any]]:
    """The rows of all detectors, scenes in their order, each followed by its twin where somebody
    looked at that."""
    for name, outcomes in found.outcomes.items():
        for one in outcomes:
            twin = one.twin
            again = None
            if twin is not None:
                again = {item.object_id for item in twin.items if item.said is not None}
            for item in one.items:
                yield {
                    "detector": name,
                    **_row(item, found.ways),
                    "told_apart": _apart(item, again),
                }
            for item in twin.items if twin is not None else ():
                yield {"detector": name, **_row(item, found.ways), "told_apart": None}


def _row(item: Item, ways: Ways) -> dict[str, Any]:
    wrong, said = item.wrong, item.said
    return {
        "scene": item.scene,
        "split": item.split,
        "kind": item.kind,
        "object_id": item.object_id,
        "category": item.category,
        "room": item.room,
        "anomaly": wrong.id if wrong is not None else None,
        "hazard": wrong.way.hazard if wrong is not None else None,
        "near_miss_of": ",".join(item.near_miss_of) or None,
        "label": wrong.label if wrong is not None else None,
        "label_said": said.label if said is not None else None,
        "notify": wrong.notify if wrong is not None else None,
        "notify_said": said.notify if said is not None else None,
        "score": said.score if said is not None else None,
        "visibility": wrong.shown if wrong is not None else None,
        "seen": ways.seen(wrong.way, item.split) if wrong is not None else None,
        "category_seen": ways.category_seen(wrong.way, item.split) if wrong is not None else None,
    }


def _apart(item: Item, again: set[int] | None) -> bool | None:
    """Whether an anomaly was told from its undone self; None where that cannot be asked."""
    if item.wrong is None or again is None or not item.wrong.in_twin:
        return None
    return item.kind == "hit" and item.object_id not in again


def check_items(path: Path) -> None:
    """Raises UsageError for a name that is neither ``.jsonl`` nor ``.csv``."""
    if path.suffix not in SUFFIXES:
        raise UsageError(f"{path}: items are written as {' or '.join(SUFFIXES)}; name it so")


def write_items(path: Path, found: Collected) -> int:
    """Write the rows, whole or not at all, as the name's ending says; how many there are. Raises
    UsageError for another ending, SdgenError where ``output_file`` does."""
    check_items(path)
    count = 0
    with output_file(path) as file:
        if path.suffix == ".jsonl":
            for row in item_rows(found):
                file.write((compact(row) + "\n").encode("utf-8"))
                count += 1
            return count
        text = io.TextIOWrapper(file, encoding="utf-8", newline="")
        table = csv.DictWriter(text, COLUMNS, lineterminator="\n")
        table.writeheader()
        for row in item_rows(found):
            table.writerow({key: _cell(value) for key, value in row.items()})
            count += 1
        text.flush()
        text.detach()
    return count


def _cell(value: Any) -> Any:
    """A value for a spreadsheet: flags as in JSON, and no text that it would reckon with."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str) and value[:1] in ("=", "+", "-", "@"):
        return f"'{value}"
    return value
