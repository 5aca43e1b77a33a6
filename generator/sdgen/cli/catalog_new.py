"""``sdgen catalog new``: a hazard of one's own, begun with an example that works."""

from __future__ import annotations

import shlex
from pathlib import Path
from typing import TYPE_CHECKING

import click

from sdgen.errors import SdgenError

if TYPE_CHECKING:
    from sdgen.catalog.starter import Kind


@click.command("new")
@click.option(
    "--kind",
    type=click.Choice(["place", "set"]),
    default="place",
    show_default=True,
    help="Whether a thing lies where it should not, or something is in a state.",
)
@click.option(
    "-o",
    "--out",
    type=click.Path(file_okay=False, path_type=Path),
    default=Path("my_hazards"),
    show_default=True,
    metavar="FOLDER",
    help="Catalogue folder; made, or added to.",
)
@click.argument("name", metavar="NAME")
def new_hazard(kind: Kind, out: Path, name: str) -> None:
    """Write a new hazard that builds as it is, each field explained, to be changed.

    The file is FOLDER/hazards/NAME.yaml. Nothing is written over.

    \b
    Example: sdgen catalog new glass_on_floor --out my_hazards
    Example: sdgen catalog new dishwasher_open --kind set
    """
    from sdgen.catalog.folder import extension_names
    from sdgen.catalog.load import load_catalog
    from sdgen.catalog.starter import check_new_name, starter_files
    from sdgen.dataset.output_file import write_output

    packs = extension_names()
    shipped = [hazard.id for hazard in load_catalog(extensions=packs).hazards]
    check_new_name(name, [*shipped, *packs])
    folder = shlex.quote(str(out))
    files = starter_files(name, kind, folder)
    hazard, readme = (out / path for path in files)
    for there in (hazard, hazard.with_suffix(".yml")):
        if there.exists() or there.is_symlink():
            raise SdgenError(f"{there}: is there already; choose another NAME or --out")
    for path, text in zip((hazard, readme), files.values(), strict=True):
        if not path.exists():
            write_output(path, text.encode("utf-8"))
    click.echo(f"{hazard}: change it, then")
    click.echo(f"  sdgen catalog validate {folder}")
    click.echo(f"  sdgen catalog test {folder} --out tried")
    click.echo(f"  sdgen build --n 6 --catalog {folder} --only {name} --hazards 1-1 --out my_homes")
