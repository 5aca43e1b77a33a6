"""``sdgen benchmark DATASET``: the tables."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click

from sdgen.cli.quiet import QUIET, hint
from sdgen.errors import UsageError

if TYPE_CHECKING:
    from sdgen.dataset.graph_views import GraphView

FOLDER = click.Path(path_type=Path, file_okay=False, exists=True)


@click.command("run", short_help="Print the tables of detectors on a data set.")
@click.argument("dataset", type=click.Path(path_type=Path), metavar="DATASET")
@click.option("--split", default="test", show_default=True, help="The scenes to score, or all.")
@click.option(
    "--trained",
    multiple=True,
    type=FOLDER,
    help="A model of sdgen train, or a folder of several; repeatable.",
)
@click.option(
    "--runs",
    multiple=True,
    type=FOLDER,
    help="A folder of predictions (*.jsonl), with the accounts of prompt methods; repeatable.",
)
@click.option(
    "--graph-view",
    "views",
    multiple=True,
    type=click.Choice(("full", "neutral", "perceived")),
    help="What of the graph detectors see [default: full, and perceived where there are pictures]; "
    "repeatable.",
)
@click.option(
    "--base-rate",
    type=click.FloatRange(0.0, 1.0, min_open=True, max_open=True),
    default=0.05,
    show_default=True,
    help="The share of homes with a hazard, of the table of clean homes.",
)
@click.option(
    "-o",
    "--out",
    "--output",
    "output",
    type=click.Path(path_type=Path, dir_okay=False),
    help="Write the tables as Markdown; without it they are printed.",
)
@click.option("--json", "as_json", is_flag=True, help="Print one JSON object.")
@QUIET
def run(
    dataset: Path,
    split: str,
    trained: tuple[Path, ...],
    runs: tuple[Path, ...],
    views: tuple[GraphView, ...],
    base_rate: float,
    output: Path | None,
    as_json: bool,
) -> None:
    """Print the tables of detectors on a data set.

    Rows that need no key are made here: rules, never, always, chance and what sdgen train made.
    Rows of language models, and your own, are read from the predictions in --runs.

    Example: sdgen benchmark homes --trained models --runs runs -o leaderboard.md
    """
    from sdgen.benchmark.leaderboard import board, markdown
    from sdgen.benchmark.rows import offline_rows, pictured, rows_of_runs, trained_in
    from sdgen.cli.bar import bar
    from sdgen.dataset import Dataset
    from sdgen.dataset.output_file import check_output, refuse_mixed, write_output

    if output is not None:
        check_output(output)
        refuse_mixed([output], [*runs, *trained])
    data = Dataset(dataset, split=None if split == "all" else split)
    if not len(data):
        raise UsageError(f"{dataset}: no scene of the split {split!r}; say --split all")
    if not views:
        views = ("full", "perceived") if pictured(data) else ("full",)
        if len(views) == 1:
            hint("without depth and instance pictures there is no perceived graph to score")
    models = trained_in(dict.fromkeys(trained))
    rows = []
    for view in dict.fromkeys(views):
        with bar(f"{view} graph") as on_scene:
            rows += offline_rows(
                Dataset(dataset, data.split, graph_view=view), models, base_rate, on_scene
            )
    rows += [row for folder in dict.fromkeys(runs) for row in rows_of_runs(data, folder, base_rate)]
    made = board(data, rows, base_rate)
    if output is not None:
        write_output(output, markdown(made).encode("utf-8"))
        hint(f"{output}: {len(rows)} rows")
    if as_json:
        click.echo(made.model_dump_json(indent=1))
    elif output is None:
        click.echo(markdown(made), nl=False)
