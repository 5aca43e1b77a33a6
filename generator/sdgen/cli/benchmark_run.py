"""``sdgen benchmark DATASET``: the tables."""

from __future__ import annotations

from pathlib import Path

import click


@click.command()
@click.argument("dataset", type=click.Path(path_type=Path))
def run(dataset: Path) -> None:
    """Print the tables."""
