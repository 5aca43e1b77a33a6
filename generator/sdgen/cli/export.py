"""``sdgen export``: a data set for other tools."""

from __future__ import annotations

from pathlib import Path

import click

from sdgen.cli.disk import human_bytes

FORMATS = ("tar",)


@click.command(short_help="Pack a data set for other tools.")
@click.argument("dataset", type=click.Path(path_type=Path), metavar="DATASET")
@click.option(
    "--format",
    "name",
    type=click.Choice(FORMATS),
    default=FORMATS[0],
    show_default=True,
    help="What to write.",
)
@click.option(
    "-o",
    "--output",
    type=click.Path(path_type=Path),
    required=True,
    help="File to write; its ending (.tar, .tar.gz) decides the compression.",
)
def export(dataset: Path, name: str, output: Path) -> None:
    """Pack a data set: the same bytes for the same data set, safe to unpack.

    Example: sdgen export output/sdgen-n12-s7 -o homes.tar
    """
    from sdgen.cli.bar import bar
    from sdgen.dataset import Dataset
    from sdgen.dataset.output_file import check_output
    from sdgen.export import export as write

    check_output(output)  # before the work
    with bar("packing") as on_scene:
        write(Dataset(dataset), name, output, on_scene)
    click.echo(f"{output}: {human_bytes(output.stat().st_size)}")
