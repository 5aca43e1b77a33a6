"""``sdgen detect``: run a detector over a data set."""

from __future__ import annotations

from pathlib import Path

import click

from sdgen.cli.quiet import QUIET, hint

METHODS = ("rules", "never", "always")


@click.command(short_help="Run a detector over a data set.")
@click.argument("dataset", type=click.Path(path_type=Path), metavar="DATASET")
@click.option(
    "--method",
    type=click.Choice(METHODS),
    required=True,
    help="rules: the catalogue's predicates over the files. never, always: what they say.",
)
@click.option(
    "-o",
    "--out",
    "--output",
    "output",
    type=click.Path(path_type=Path, dir_okay=False),
    required=True,
    help="Predictions file to write; - is standard output.",
)
@click.option("--split", help="Only the scenes of train, val or test.")
@QUIET
def detect(dataset: Path, method: str, output: Path, split: str | None) -> None:
    """Run a detector over a data set and write its predictions.

    Example: sdgen detect output/sdgen-n12-s7 --method rules -o predictions.jsonl
    """
    from sdgen.benchmark import detect as run
    from sdgen.benchmark import prediction_bytes, write_predictions
    from sdgen.cli.bar import bar
    from sdgen.dataset import Dataset
    from sdgen.dataset.output_file import check_output

    to_stdout = output == Path("-")
    if not to_stdout:
        check_output(output)  # before the work
    data = Dataset(dataset, split=split)
    with bar("detecting") as on_scene:
        found = run(data, method, on_scene)
    if to_stdout:
        click.echo(prediction_bytes(found), nl=False)
        return
    write_predictions(output, found)
    reports = sum(len(said) for said in found.values())
    hint(f"{output}: {reports} reports in {len(found)} scenes")
    hint(f"score them: sdgen evaluate {dataset} {output}")
