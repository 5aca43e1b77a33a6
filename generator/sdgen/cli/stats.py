"""``sdgen stats``: what a data set holds."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path

import click

from sdgen.cli.quiet import QUIET, hint

#: Characters of the longest bar.
_WIDTH = 30


@click.command(short_help="Count what a data set holds.")
@click.argument("dataset", type=click.Path(path_type=Path), metavar="DATASET")
@click.option("--split", help="Only the distributions of train, val or test.")
@click.option(
    "--plot",
    type=click.Path(path_type=Path, dir_okay=False),
    metavar="FILE.svg",
    help="Also draw the distributions.",
)
@QUIET
@click.option("--json", "as_json", is_flag=True, help="Print one JSON object.")
def stats(dataset: Path, split: str | None, plot: Path | None, as_json: bool) -> None:
    """Count scenes, views, objects, anomalies by hazard, homes and splits, and show how rooms,
    sizes, heights, visibility and drift are spread. Reads every scene's files, no picture.

    \b
    Example: sdgen stats output/sdgen-n12-s7
    Example: sdgen stats output/sdgen-n12-s7 --plot stats.svg
    """
    from sdgen.cli.bar import bar
    from sdgen.dataset import Dataset
    from sdgen.dataset.distributions import distributions
    from sdgen.dataset.output_file import check_output
    from sdgen.dataset.records import count

    if plot is not None:
        check_output(plot)  # before the work
    data = Dataset(dataset, split=split)
    with bar("reading") as on_scene:
        spread = distributions(data, on_scene)
    if plot is not None:
        from sdgen.gallery.stats_picture import write_stats

        part = f", {split}" if split is not None else ""
        title = f"{dataset.name}: n {data.info.n}, seed {data.info.seed}{part}"
        write_stats(plot, title, spread)
        hint(f"{plot}")
    info, counts = data.info, count(data.entries)
    hazards = {name: counts.anomalies_by_hazard.get(name, 0) for name in info.hazards_enabled}
    if as_json:
        record = {
            "format_version": info.format_version,
            "seed": info.seed,
            "n": info.n,
            **counts.model_dump(),
            "anomalies_by_hazard": hazards,
            "failed": sorted(info.failed),
            "renderers": list(info.renderers),
            "distributions": spread.model_dump(mode="json"),
        }
        click.echo(json.dumps(record, indent=1))
        return
    from rich.table import Table

    from sdgen.cli.table import echo_table
    from sdgen.gallery.stats_picture import bars, in_words

    scenes = max(counts.scenes, 1)
    numbers = {"twins": counts.twins, "toggles": counts.toggles}
    beside = [f"{number} {kind}" for kind, number in numbers.items() if number]
    table = Table(title=f"{dataset}: n {info.n}, seed {info.seed}", show_header=False)
    table.add_row("scenes", _of(counts.scenes, ", ".join(beside)))
    table.add_row("views", str(counts.views))
    table.add_row("objects", _of(counts.objects, f"{counts.objects / scenes:.1f} a scene"))
    table.add_row("anomalies", _of(counts.anomalies, f"{counts.anomalies / scenes:.2f} a scene"))
    table.add_row("lookalikes", str(counts.lookalikes))
    table.add_row("do not show every anomaly", f"{counts.scenes_not_all_visible} scenes")
    if info.failed:
        table.add_row("could not be made", ", ".join(sorted(info.failed)))
    table.add_section()
    for hazard, number in hazards.items():
        table.add_row(f"anomalies, {hazard}", str(number))
    table.add_section()
    for anomalies, number in sorted(counts.scenes_by_anomalies.items(), key=lambda i: int(i[0])):
        table.add_row(
            f"scenes with {anomalies} {'anomaly' if anomalies == '1' else 'anomalies'}", str(number)
        )
    table.add_section()
    for split, number in counts.scenes_by_split.items():
        homes = len(info.splits.get(split, ()))
        table.add_row(f"scenes, {split}", _of(number, f"{homes} homes"))
    echo_table(table)
    for tally in spread.names.values():
        if tally.title != "anomalies by hazard":  # above
            _echo_bars(tally.title, "", list(tally.counts.items()))
    for found in spread.numbers.values():
        _echo_bars(found.title, in_words(found), bars(found))


def _echo_bars(title: str, note: str, rows: Sequence[tuple[str, int]]) -> None:
    """A small table with a bar a row."""
    from rich.table import Table

    from sdgen.cli.table import echo_table

    most = max([number for _, number in rows] + [1])
    table = Table(title=f"{title}\n{note}".strip(), show_header=False, box=None, min_width=60)
    for name, number in rows:
        table.add_row(name.replace("_", " "), str(number), "█" * round(_WIDTH * number / most))
    echo_table(table)


def _of(number: int, more: str) -> str:
    return f"{number} ({more})" if more else str(number)
