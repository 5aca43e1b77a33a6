"""``sdgen stats``: what a data set holds."""

from __future__ import annotations

import json
from pathlib import Path

import click


@click.command(short_help="Count what a data set holds.")
@click.argument("dataset", type=click.Path(path_type=Path), metavar="DATASET")
@click.option("--json", "as_json", is_flag=True, help="Print one JSON object.")
def stats(dataset: Path, as_json: bool) -> None:
    """Count scenes, views, objects, anomalies by hazard, homes and splits.

    Example: sdgen stats output/sdgen-n12-s7
    """
    from sdgen.dataset import Dataset
    from sdgen.dataset.records import count

    data = Dataset(dataset)
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
        }
        click.echo(json.dumps(record, indent=1))
        return
    from rich.table import Table

    from sdgen.cli.table import echo_table

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
        table.add_row(f"scenes with {anomalies} anomalies", str(number))
    table.add_section()
    for split, number in counts.scenes_by_split.items():
        homes = len(info.splits.get(split, ()))
        table.add_row(f"scenes, {split}", _of(number, f"{homes} homes"))
    echo_table(table)


def _of(number: int, more: str) -> str:
    return f"{number} ({more})" if more else str(number)
