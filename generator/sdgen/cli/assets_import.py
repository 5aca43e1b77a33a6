"""``sdgen assets import``: a download of scans becomes a library of models."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import click

from sdgen.cli.bar import bar
from sdgen.cli.quiet import QUIET
from sdgen.cli.shared_options import CATALOGS
from sdgen.importing.member_names import plain, shown_name

if TYPE_CHECKING:
    from rich.table import Table

    from sdgen.importing.run import Report

_SOURCES = ("ycb", "gso", "replicacad", "fantastic-breaks", "folder")


@click.command("import")
@click.option(
    "-o",
    "--out",
    "library",
    type=click.Path(file_okay=False, path_type=Path),
    required=True,
    metavar="LIBRARY",
    help="Folder of the library; made, or filled further.",
)
@click.option(
    "--model", "names", multiple=True, metavar="NAME", help="Only this model; repeatable."
)
@click.option(
    "--table",
    "tables",
    type=click.Path(exists=True, dir_okay=False, path_type=Path),
    multiple=True,
    help="YAML of your own that says which category models are; repeatable.",
)
@CATALOGS
@click.option("--licence", metavar="SPDX", help="Licence of the models, where no file says it.")
@click.option("--attribution", metavar="TEXT", help="Whom to name for them.")
@click.option(
    "--non-commercial", is_flag=True, help="Take models that may be used for no trade, too."
)
@click.option("--faces", type=click.IntRange(20, 100_000), help="Faces a model [800, large 2500].")
@click.option(
    "--texture",
    type=click.IntRange(32, 4096),
    default=512,
    show_default=True,
    help="Pixels a side of a texture, at most.",
)
@click.option("--overwrite", is_flag=True, help="Make anew what is there already.")
@click.option(
    "--workers", type=click.IntRange(min=1), metavar="N", help="Processes [default: cores]."
)
@QUIET
@click.option("--json", "as_json", is_flag=True, help="Print one JSON object.")
@click.argument("source", type=click.Choice(_SOURCES))
@click.argument("path", type=click.Path(exists=True, path_type=Path))
def import_assets(
    library: Path,
    names: tuple[str, ...],
    tables: tuple[Path, ...],
    catalogs: tuple[Path, ...],
    licence: str | None,
    attribution: str | None,
    non_commercial: bool,
    faces: int | None,
    texture: int,
    overwrite: bool,
    workers: int | None,
    as_json: bool,
    source: str,
    path: Path,
) -> None:
    """Turn a download of SOURCE at PATH (a folder, zip or tar) into models that build.

    Meshes are stood upright, made light and closed, textures baked to one a model, collision
    pieces, supports and hollows found, the category looked up or guessed. A second run imports
    only what is new. Exit code 3 when some models could not be imported: they are named.

    \b
    Example: sdgen assets import ycb downloads/ycb --out my_models
    Example: sdgen assets import folder meshes.zip --licence CC0-1.0 --out my_models
    """
    from sdgen.catalog.load import load_catalog
    from sdgen.engines.machine import usable_cores
    from sdgen.importing.model import Budget
    from sdgen.importing.run import Import, import_models

    asked = Import(
        source,
        path,
        library,
        Budget(faces, texture),
        tables,
        licence,
        attribution,
        non_commercial,
        overwrite,
    )
    with bar("importing") as on_model:
        workers = workers or usable_cores()
        report = import_models(asked, load_catalog(catalogs), on_model, workers, names)
    if as_json:
        click.echo(json.dumps(_as_json(report), indent=1))
    else:
        _say(report, library)
    if report.refused:
        click.get_current_context().exit(3)


def _as_json(report: Report) -> dict[str, object]:
    from sdgen.importing.shelf import report_json

    return {
        "made": [report_json(origin) for origin in report.made],
        "kept": [report_json(origin) for origin in report.kept],
        "refused": [{"name": item.name, "why": item.why} for item in report.refused],
    }


def _say(report: Report, library: Path) -> None:
    from sdgen.cli.table import echo_table

    if report.made:
        echo_table(_table(report))
    for origin in report.made:
        for note in origin.notes:
            click.echo(f"{shown_name(origin.name)}: {plain(note)}")
    _say_by_reason("not placed", [(o.name, o.why) for o in report.made if not o.placed])
    _say_by_reason("not imported", [(item.name, item.why) for item in report.refused])
    placed = sum(origin.placed for origin in (*report.made, *report.kept))
    click.echo(
        f"{library}: {len(report.made)} imported, {len(report.kept)} there already, "
        f"{len(report.refused)} not imported; builds place {placed} of them"
    )
    if placed:
        click.echo(f"Build with them: sdgen build --assets {library}")


def _say_by_reason(what: str, named: Sequence[tuple[str, str]]) -> None:
    """A line for each reason, with all that it holds for."""
    for why in dict.fromkeys(why for _, why in named):
        names = [shown_name(name) for name, its_why in named if its_why == why]
        click.echo(f"{what}: {', '.join(names)}: {plain(why)}")


def _table(report: Report) -> Table:
    from rich.table import Table

    table = Table(box=None)
    table.add_column("model", overflow="fold")
    for title in ("category", "how", "size (cm)", "faces", "licence"):
        table.add_column(title, no_wrap=True)
    for origin in report.made:
        asset = origin.asset
        size = " x ".join(f"{100 * value:.1f}" for value in asset.extents_m)
        row = (asset.category, origin.how, size, str(asset.faces), asset.licence)
        table.add_row(shown_name(origin.name), *row)
    return table
