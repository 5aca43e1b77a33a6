"""``sdgen validate``: is a data set what it promises to be?"""

from __future__ import annotations

from pathlib import Path

import click

from sdgen.engines.machine import usable_cores
from sdgen.errors import SHOWN


@click.command(short_help="Check a data set: schemas, hashes, masks, every label again.")
@click.argument("dataset", type=click.Path(path_type=Path), metavar="DATASET")
@click.option(
    "--rebuild",
    type=click.IntRange(min=0),
    metavar="K",
    default=0,
    help="Also make K scenes again and compare them byte for byte.",
)
@click.option(
    "--catalog",
    "catalogs",
    type=click.Path(exists=True, path_type=Path),
    multiple=True,
    help="Evaluate this catalogue's predicates instead of the data set's own; repeatable.",
)
@click.option(
    "--assets",
    type=click.Path(exists=True, path_type=Path),
    multiple=True,
    help="Extra asset folder the build used (for --rebuild); repeatable.",
)
@click.option(
    "--workers", type=click.IntRange(min=1), metavar="N", help="Processes [default: cores]."
)
def validate(
    dataset: Path,
    rebuild: int,
    catalogs: tuple[Path, ...],
    assets: tuple[Path, ...],
    workers: int | None,
) -> None:
    """Check a data set from its files alone.

    Schemas, digests, masks against graph and visibility, depth against boxes, every relation,
    zone and predicate evaluated again. Exit code 1 when anything is wrong.

    \b
    Example: sdgen validate output/sdgen-n12-s7
    Example: sdgen validate output/sdgen-n12-s7 --rebuild 3
    """
    from sdgen.cli.bar import bar
    from sdgen.dataset import Dataset
    from sdgen.validate import validate as check

    catalog = None
    if catalogs:
        from sdgen.catalog.load import load_catalog

        extensions = Dataset(dataset, partial=True).info.options.extensions
        catalog = load_catalog(catalogs, extensions=extensions)
    with bar("checking") as on_scene:
        problems = check(dataset, catalog, on_scene, workers or usable_cores())
    if rebuild and not problems:
        from sdgen.library import load_library
        from sdgen.validate.rebuild import rebuild as make_again

        with bar("making again") as on_scene:
            problems = make_again(Dataset(dataset), load_library(assets), rebuild, on_scene)
    for problem in problems[:SHOWN]:
        click.echo(str(problem))
    if problems:
        noun = "problem" if len(problems) == 1 else "problems"
        rest = f" ({SHOWN} shown)" if len(problems) > SHOWN else ""
        skipped = "; nothing was made again" if rebuild and problems[0].check != "rebuild" else ""
        click.echo(f"{dataset}: {len(problems)} {noun}{rest}{skipped}", err=True)
        click.get_current_context().exit(1)
    scenes = len(Dataset(dataset).entries)
    again = f", {min(rebuild, scenes)} made again" if rebuild else ""
    click.echo(f"{dataset}: {scenes} scenes checked{again}, no problem found")
