"""``sdgen evaluate``: how good predictions are."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click

if TYPE_CHECKING:
    from sdgen.benchmark import Score

#: Row of the table -> field of the evaluation.
ROWS = {
    "AS (Anomaly Success)": "AS",
    "CAS (Conditioned Anomaly Success)": "CAS",
    "unwanted a scene": "unwanted_per_scene",
    "false alarms a scene": "false_alarms_per_scene",
    "precision": "precision",
    "recall": "recall",
    "F1": "f1",
    "label accuracy": "label_accuracy",
}


@click.command(short_help="Score predictions against a data set.")
@click.argument("dataset", type=click.Path(path_type=Path), metavar="DATASET")
@click.argument("predictions", type=click.Path(path_type=Path), metavar="PREDICTIONS")
@click.option("--split", help="Score only the scenes of train, val or test.")
@click.option("--json", "as_json", is_flag=True, help="Print one JSON object.")
def evaluate(dataset: Path, predictions: Path, split: str | None, as_json: bool) -> None:
    """Score a predictions file against a data set.

    Every score is a mean over scenes (hazards: over anomalies) with its standard error. A scene
    without a line counts as silence.

    Example: sdgen evaluate output/sdgen-n12-s7 predictions.jsonl --json
    """
    from sdgen.benchmark import evaluate as score
    from sdgen.dataset import Dataset

    found = score(Dataset(dataset, split=split), predictions)
    if as_json:
        click.echo(found.model_dump_json(indent=1))
        return
    from rich.table import Table

    from sdgen.cli.table import echo_table

    table = Table("score", "mean ± se", "over")
    for title, name in ROWS.items():
        value: Score = getattr(found, name)
        table.add_row(title, _shown(value), f"{value.n} scenes")
    table.add_section()
    for hazard, value in found.recall_by_hazard.items():
        table.add_row(f"recall, {hazard}", _shown(value), f"{value.n} anomalies")
    echo_table(table)


def _shown(value: Score) -> str:
    if value.mean is None:
        return "-"
    return f"{value.mean:.3f}" + (f" ± {value.se:.3f}" if value.se is not None else "")
