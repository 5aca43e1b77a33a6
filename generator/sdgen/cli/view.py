"""``sdgen view``: a page that shows a data set."""

from __future__ import annotations

from pathlib import Path

import click

from sdgen.cli.quiet import QUIET, hint
from sdgen.cli.shared_options import ASSETS

#: Each scene shown is a page of its own with all its pictures drawn anew.
LIMIT = 200


@click.command(short_help="Make a page that shows a data set.")
@click.argument("dataset", type=click.Path(path_type=Path), metavar="DATASET")
@click.option(
    "-o",
    "--out",
    "--output",
    "output",
    type=click.Path(path_type=Path),
    help="Folder of the page [default: DATASET/view].",
)
@click.option(
    "--limit",
    type=click.IntRange(min=0),
    default=LIMIT,
    show_default=True,
    metavar="N",
    help="Show only the first N scenes; 0 shows all.",
)
@click.option("--split", help="Show only the scenes of train, val or test.")
@ASSETS
@click.option("--serve", "serving", is_flag=True, help="Serve it on 127.0.0.1 until interrupted.")
@click.option(
    "--port",
    type=click.IntRange(min=0, max=65535),
    default=8000,
    show_default=True,
    help="Port of --serve; 0 takes a free one.",
)
@QUIET
def view(
    dataset: Path,
    output: Path | None,
    limit: int,
    split: str | None,
    assets: tuple[Path, ...],
    serving: bool,
    port: int,
) -> None:
    """Make a gallery: a page of all scenes, and for each its views, labels, plan, graph and 3-D.

    Its pages open from disk. Models come from the shipped library and the folders of --assets;
    boxes stand for those that are not there, or not as the data set has them.

    \b
    Example: sdgen view output/sdgen-n12-s7
    Example: sdgen view output/sdgen-n12-s7 --serve
    """
    from sdgen.cli.bar import bar
    from sdgen.dataset import Dataset
    from sdgen.errors import UsageError
    from sdgen.gallery import serve, write_gallery
    from sdgen.library import load_library

    if serving and output is not None:
        raise UsageError("--serve shows the data set's own page: leave -o out")
    data = Dataset(dataset, split=split)
    library = load_library(assets)
    with bar("drawing") as on_scene:
        shown = write_gallery(data, output or dataset / "view", limit or None, on_scene, library)
    if shown.scenes < shown.total:
        hint(f"shows the first {shown.scenes} of {shown.total} scenes (--limit)")
    if serving:
        serve(dataset, shown.index, port, lambda url: click.echo(f"{url} (stop with Ctrl-C)"))
        return
    click.echo(str(shown.index.resolve()))
