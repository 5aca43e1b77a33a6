"""Tables on standard output."""

from __future__ import annotations

import click
from rich.console import Console
from rich.table import Table


def echo_table(table: Table) -> None:
    """Print a table as wide as the terminal. Through click: rich itself ends the process with 1
    when whoever reads has left."""
    console = Console(highlight=False)
    with console.capture() as captured:
        console.print(table)
    click.echo(captured.get(), nl=False)
