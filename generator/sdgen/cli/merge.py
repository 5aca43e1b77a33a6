"""``sdgen merge``: pieces of ``--range`` become one data set."""

from __future__ import annotations

import json
from pathlib import Path

import click

from sdgen.cli.params import destination, parsed
from sdgen.cli.quiet import QUIET, hint
from sdgen.errors import BuildIncomplete


@click.command(short_help="Join pieces of --range into one data set.")
@click.argument(
    "pieces", nargs=-1, required=True, type=click.Path(path_type=Path), metavar="PIECE..."
)
@click.option(
    "-o",
    "--out",
    metavar="FOLDER",
    callback=parsed(destination),
    required=True,
    help="Destination, a folder of its own. The same command goes on after an interruption.",
)
@QUIET
@click.option("--json", "as_json", is_flag=True, help="Print one JSON object.")
def merge(pieces: tuple[Path, ...], out: Path, as_json: bool) -> None:
    """Join pieces that 'sdgen build --range A:B' made in folders of their own.

    The result has the same bytes as one build of all scenes. Pieces must be of the same
    catalogue, models, options and seed; scenes that no piece has are named (exit code 3).

    \b
    Example: sdgen merge piece-0 piece-1 piece-2 -o homes
    """
    from sdgen.cli.bar import bar
    from sdgen.cli.disk import check_destination
    from sdgen.dataset.merge import merge as join

    check_destination(out)
    with bar("joining") as on_scene:
        merged = join(pieces, out, on_scene)
    counts = merged.info.counts
    if as_json:
        record = {
            "out": str(out),
            "n": merged.info.n,
            "scenes": counts.scenes,
            "views": counts.views,
            "missing": [list(gap) for gap in merged.missing],
            "failed": sorted(merged.info.failed),
        }
        click.echo(json.dumps(record, indent=1, ensure_ascii=False))
    else:
        click.echo(f"{out}: {counts.scenes} of {merged.info.n} scenes, {counts.views} views")
    problems = [f"no piece has --range {first}:{end}" for first, end in merged.missing]
    if merged.info.failed:
        problems.append(f"could not be made: {', '.join(sorted(merged.info.failed)[:20])}")
    if problems:
        raise BuildIncomplete(f"{out}: {'; '.join(problems)}")
    if not as_json:
        hint(f"look at it: sdgen view {out}")
