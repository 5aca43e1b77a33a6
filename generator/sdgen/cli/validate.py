"""``sdgen validate``: is a data set what it promises to be?"""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import click

from sdgen.cli.params import split_names
from sdgen.cli.quiet import QUIET
from sdgen.cli.recertify import certify_again
from sdgen.engines.machine import usable_cores
from sdgen.errors import SHOWN, InputError, UsageError

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
    help="Only ask whether this catalogue would label the same: its predicates are evaluated on "
    "the stored poses. Folder or file; repeatable.",
)
@click.option(
    "--extensions",
    multiple=True,
    metavar="NAME,...",
    help="The same with these shipped packs of hazards [default with --catalog: the data set's].",
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
@QUIET
@click.option("--json", "as_json", is_flag=True, help="Print one JSON object, all problems in it.")
def validate(
    dataset: Path,
    rebuild: int,
    physics: bool,
    catalogs: tuple[Path, ...],
    extensions: tuple[str, ...],
    assets: tuple[Path, ...],
    workers: int | None,
    as_json: bool,
) -> None:
    """Check a data set from its files alone.

    Schemas, digests, masks against graph and visibility, cameras and depth against walls and
    boxes, colours against masks, every relation, zone and predicate evaluated again. Exit code 1
    when anything is wrong.

    With --catalog or --extensions it is certified against another catalogue instead: labels that
    no longer hold, pairs of object and hazard that hold and are not labelled, and undecided ones
    are listed, and counted by hazard. Exit code 1 when there are any.

    \b
    Example: sdgen validate output/sdgen-n12-s7
    Example: sdgen validate output/sdgen-n12-s7 --rebuild 3
    Example: sdgen validate output/sdgen-n12-s7 --physics
    Example: sdgen validate output/sdgen-n12-s7 --catalog my_hazards
    """
    from sdgen.cli.bar import bar
    from sdgen.dataset import Dataset
    from sdgen.validate import validate as check
    from sdgen.validate.run import older

    if catalogs or extensions:
        if rebuild or physics:
            raise UsageError("--catalog and --extensions go without --rebuild and --physics")
        packs, cores = split_names(extensions), workers or usable_cores()
        good = certify_again(dataset, catalogs, packs, cores, as_json)
        click.get_current_context().exit(0 if good else 1)
    note, stood, made = "", 0, 0
    with bar("checking") as on_scene:
        problems = check(dataset, on_scene, workers or usable_cores())
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
    data = Dataset(dataset)
    scenes = len(data.entries)
    if older(data):
        version = data.info.format_version
        click.echo(
            f"format {version}: its labels were not derived again, by rules not ours", err=True
        )
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
