"""``sdgen assets fetch``: models from their source's own address, licence first."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING

import click

from sdgen.cli.bar import bar
from sdgen.cli.disk import check_destination
from sdgen.cli.params import destination, parsed
from sdgen.cli.quiet import QUIET
from sdgen.errors import AssetError, SdgenError, UsageError, did_you_mean

if TYPE_CHECKING:
    from sdgen.importing.sources import Source


@click.command("fetch")
@click.argument("source_id", metavar="SOURCE")
@click.argument("names", metavar="[MODEL]...", nargs=-1)
@click.option(
    "-o",
    "--out",
    metavar="FOLDER",
    callback=parsed(destination),
    help="Folder the models are put into.",
)
@click.option("--all", "everything", is_flag=True, help="Fetch every model of the source.")
@click.option("--list", "as_list", is_flag=True, help="Print the names of the source's models.")
@click.option("--accept-licence", is_flag=True, help="Accept the source's licence, unasked.")
@click.option("--base-url", metavar="URL", help="Fetch from a mirror that is laid out alike.")
@QUIET
def fetch_assets(
    source_id: str,
    names: tuple[str, ...],
    out: Path | None,
    everything: bool,
    as_list: bool,
    accept_licence: bool,
    base_url: str | None,
) -> None:
    """Download models of SOURCE: ycb, gso, replicacad or fantastic-breaks.

    Shows the licence and asks whether you accept it. A run that was stopped goes on where it was;
    a second one fetches what is missing, damaged or new. FOLDER is then as 'assets import' reads
    it. With ReplicaCAD, the MODEL 'scenes' is its furnished rooms.

    \b
    Example: sdgen assets fetch ycb --list
    Example: sdgen assets fetch ycb 025_mug 011_banana --out scans/ycb
    Example: sdgen assets fetch gso --all --out scans/gso --accept-licence
    """
    from sdgen.importing.fetch import chosen, client_of, fetch
    from sdgen.importing.listing import list_models
    from sdgen.importing.sources import load_sources

    sources = load_sources()
    if source_id not in sources:
        raise UsageError(f"no source {source_id!r}{did_you_mean(source_id, list(sources))}")
    source = sources[source_id]
    if base_url is not None:
        source = source.at(base_url)
    client = client_of(source)
    if as_list:
        for name in list_models(source, client):
            click.echo(name)
        return
    if everything == bool(names):
        raise UsageError("name models, or --all; --list prints their names")
    if out is None:
        raise UsageError("--out FOLDER: where shall the models be put?")
    check_destination(out)
    _agree(source, accept_licence)
    models = list_models(source, client)
    wanted = chosen(models, list(models) if everything else names)
    with bar("fetching") as on_model:
        report = fetch(source, wanted, out, client, on_model)
    total = len(report.fetched) + len(report.kept)
    click.echo(f"{out}: {total} models of {source.title}, {len(report.fetched)} fetched now")
    missing = [
        f"{name}: listed by {source.title}, which has no model of it" for name in report.absent
    ]
    if everything:
        for line in missing:
            click.echo(line, err=True)
        missing = []
    if report.problems or missing:
        raise AssetError([*report.problems, *missing])


def _agree(source: Source, accepted: bool) -> None:
    """Show the licence; go on only when it is accepted."""
    lines = [f"{source.title}: {source.homepage}", f"licence: {source.licence_name}"]
    lines += [f"         {source.licence_url}"] if source.licence_url else []
    lines += [f"asks:    {asked}" for asked in source.asks]
    lines += [f"note:    {source.note}"] if source.note else []
    lines += [f"credit:  {source.attribution}"]
    click.echo("\n".join(lines), err=True)
    if accepted:
        return
    if not sys.stdin.isatty():
        accepts = f"--accept-licence accepts {source.licence}"
        raise UsageError(f"read the licence above; {accepts} (nothing was fetched)")
    if not click.confirm("Do you accept it?", err=True):
        raise SdgenError("the licence was not accepted; nothing was fetched")
