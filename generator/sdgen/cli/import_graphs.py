"""``sdgen import``: scene graphs of others as a data set."""

from __future__ import annotations

import json
from pathlib import Path

import click

from sdgen.cli.quiet import QUIET

FORMATS = ("virtualhome",)
#: What is told of each graph, lines.
SHOWN = 5


@click.command("import", short_help="Make a data set of others' scene graphs.")
@click.argument("format_", type=click.Choice(FORMATS), metavar="FORMAT")
@click.argument("paths", type=click.Path(exists=True, path_type=Path), nargs=-1, required=True)
@click.option(
    "-o",
    "--out",
    type=click.Path(path_type=Path, file_okay=False),
    required=True,
    help="Folder of the data set.",
)
@click.option(
    "--seed",
    type=click.IntRange(min=0),
    default=0,
    show_default=True,
    metavar="S",
    help="Draws the households, and where an agent starts.",
)
@click.option("--household", metavar="KIND", help="Who lives in all of them [default: drawn].")
@QUIET
@click.option("--json", "as_json", is_flag=True, help="Print one JSON object.")
def import_graphs(
    format_: str,
    paths: tuple[Path, ...],
    out: Path,
    seed: int,
    household: str | None,
    as_json: bool,
) -> None:
    """Make scenes without pictures of graphs: boxes, relations, and what the catalogue's rules say
    of them. FORMAT is virtualhome; 'detect', 'evaluate', 'stats' and 'validate' take the result.

    For homes that builds can furnish use 'sdgen home import'.

    \b
    Example: sdgen import virtualhome TestScene1.json TestScene3.json -o virtualhome
    """
    from sdgen.catalog.load import load_catalog
    from sdgen.cli.bar import bar
    from sdgen.importing.graphs.data_set import import_graphs as run

    with bar("importing") as on_scene:
        found = run(format_, paths, out, load_catalog(), seed, household, on_scene)
    if as_json:
        record = {
            "scenes": found.scenes,
            "anomalies_by_hazard": dict(sorted(found.anomalies.items())),
            "undecided_by_hazard": dict(sorted(found.undecided.items())),
            "told": found.told,
        }
        click.echo(json.dumps(record, indent=1, ensure_ascii=False))
        return
    for path, told in found.told.items():
        for line in told[:SHOWN]:
            click.echo(f"{path}: {line}", err=True)
        if len(told) > SHOWN:
            click.echo(f"{path}: and {len(told) - SHOWN} more", err=True)
    for hazard, number in found.anomalies.most_common():
        click.echo(f"{number:5} {hazard}")
    unsure = sum(found.undecided.values())
    click.echo(
        f"{out}: {found.scenes} scenes, {sum(found.anomalies.values())} anomalies"
        + (f", {unsure} pairs in doubt that are not labelled" if unsure else "")
    )
