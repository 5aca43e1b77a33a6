"""``sdgen validate``: is a data set what it promises to be?"""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import click

from sdgen.engines.machine import usable_cores
from sdgen.errors import SHOWN, InputError

if TYPE_CHECKING:
    from sdgen.validate import Problem


@click.command(short_help="Check a data set: schemas, hashes, masks, every label again.")
@click.argument("dataset", type=click.Path(path_type=Path), metavar="DATASET")
@click.option(
    "--rebuild",
    type=click.IntRange(min=0),
    metavar="K",
    default=0,
    help="Also make K scenes again and compare every file, pictures too where the renderer is "
    "the one that drew them.",
)
@click.option(
    "--physics",
    is_flag=True,
    help="Also load each scene into Bullet anew: nothing cuts into anything, floats or moves.",
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
    help="Extra asset folder the build used (for --rebuild and --physics); repeatable.",
)
@click.option(
    "--workers", type=click.IntRange(min=1), metavar="N", help="Processes [default: cores]."
)
@click.option("--json", "as_json", is_flag=True, help="Print one JSON object, all problems in it.")
def validate(
    dataset: Path,
    rebuild: int,
    physics: bool,
    catalogs: tuple[Path, ...],
    assets: tuple[Path, ...],
    workers: int | None,
    as_json: bool,
) -> None:
    """Check a data set from its files alone.

    Schemas, digests, masks against graph and visibility, cameras and depth against walls and
    boxes, colours against masks, every relation, zone and predicate evaluated again. Exit code 1
    when anything is wrong.

    \b
    Example: sdgen validate output/sdgen-n12-s7
    Example: sdgen validate output/sdgen-n12-s7 --rebuild 3
    Example: sdgen validate output/sdgen-n12-s7 --physics
    """
    from sdgen.cli.bar import bar
    from sdgen.dataset import Dataset
    from sdgen.validate import validate as check

    catalog, note, stood, made = None, "", 0, 0
    if catalogs:
        from sdgen.catalog.load import load_catalog

        extensions = Dataset(dataset, partial=True).info.options.extensions
        catalog = load_catalog(catalogs, extensions=extensions)
    with bar("checking") as on_scene:
        problems = check(dataset, catalog, on_scene, workers or usable_cores())
    if physics and not problems:
        from sdgen.library import load_library
        from sdgen.validate.physics import check_physics

        cores = workers or usable_cores()
        with bar("letting stand") as on_scene:
            found = check_physics(Dataset(dataset), load_library(assets), cores, on_scene)
        problems, stood = found
    if rebuild and not problems:
        from sdgen.library import load_library
        from sdgen.validate.rebuild import rebuild as make_again

        with bar("making again") as on_scene:
            again = make_again(Dataset(dataset), load_library(assets), rebuild, on_scene)
        problems, note, made = again
    if as_json:
        _print(dataset, problems, stood, made, note)
        click.get_current_context().exit(1 if problems else 0)
    for problem in problems[:SHOWN]:
        click.echo(str(problem))
    if problems:
        noun = "problem" if len(problems) == 1 else "problems"
        rest = f" ({SHOWN} shown)" if len(problems) > SHOWN else ""
        skipped = "; nothing was let stand" if physics and not stood else ""
        skipped += "; nothing was made again" if rebuild and not made else ""
        click.echo(f"{dataset}: {len(problems)} {noun}{rest}{skipped}", err=True)
        click.get_current_context().exit(1)
    scenes = len(Dataset(dataset).entries)
    deeper = ", let stand" if physics else ""
    deeper += f", {made} made again" if rebuild else ""
    click.echo(f"{dataset}: {scenes} scenes checked{deeper}, no problem found")
    if note:
        click.echo(note, err=True)


def _print(dataset: Path, problems: Sequence[Problem], stood: int, made: int, note: str) -> None:
    """What was found, as one object; ``scenes`` is null when the folder is no data set. ``stood``
    and ``made`` count what was let stand and made again: 0 where it was not asked for, too."""
    from sdgen.dataset import Dataset

    try:
        scenes = len(Dataset(dataset, partial=True).entries)
    except InputError:
        scenes = None
    record = {
        "scenes": scenes,
        "let_stand": stood,
        "made_again": made,
        "note": note,
        "problems": [{"check": problem.check, "text": problem.text} for problem in problems],
    }
    click.echo(json.dumps(record, indent=1, ensure_ascii=False))
