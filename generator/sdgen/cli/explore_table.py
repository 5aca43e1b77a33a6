"""``sdgen explore DATASET``: explorers and detectors compared over all homes."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

import click

from sdgen.cli.bar import bar
from sdgen.cli.quiet import hint
from sdgen.cli.table import echo_table

if TYPE_CHECKING:
    from sdgen.agent.compare import Row
    from sdgen.agent.options import AgentOptions
    from sdgen.benchmark.scores import Score
    from sdgen.dataset import Dataset
    from sdgen.detectors.run import Detector
    from sdgen.library import Library


def explore_table(
    data: Dataset,
    library: Library,
    explorers: Sequence[str],
    detectors: Mapping[str, Detector],
    options: AgentOptions,
    seed: int,
    renderer: str,
    limit: int | None,
    as_json: bool,
) -> None:
    """Run them, and print a row each."""
    from sdgen.agent.compare import compare

    with bar("exploring") as on_scene:
        rows = compare(
            data, library, explorers, detectors, options, seed, renderer, limit, on_scene
        )
    if as_json:
        click.echo(json.dumps([row.model_dump(mode="json") for row in rows], indent=1))
        return
    from rich import box
    from rich.table import Table

    table = Table("explorer", "detector", *HEADS, box=box.SIMPLE, padding=(0, 1, 0, 0))
    for column in table.columns[2:]:
        column.justify = "right"
    for row in rows:
        table.add_row(*cells(row))
    echo_table(table)
    hint(
        "percent, but for false alarms (FA), steps and metres (m) a home; shown and found of what "
        "can be seen; way: the shortest tour by it; seen: of the floor; standard errors with --json"
    )


#: Of the numbers of a row.
HEADS = ("AS", "CAS", "FA", "shown", "found", "steps", "m", "way", "seen")


def cells(row: Row) -> tuple[str, ...]:
    """A row as texts."""
    who = row.explorer or {"views": "(its views)", "everything": "(all of it)"}[row.before]
    return (
        who,
        row.detector,
        _said(row.AS, 100),
        _said(row.CAS, 100),
        _said(row.false_alarms),
        _said(row.shown, 100),
        _said(row.found, 100),
        _said(row.steps, digits=0),
        _said(row.path_m),
        _said(row.path_ratio, 100, digits=0),
        _said(row.coverage, 100, digits=0),
    )


def _said(score: Score | None, times: float = 1.0, digits: int = 1) -> str:
    if score is None or score.mean is None:
        return "-"
    return f"{score.mean * times:.{digits}f}"
