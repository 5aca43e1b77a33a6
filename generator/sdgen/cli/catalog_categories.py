"""``sdgen catalog categories``: the words that recipes and predicates may use."""

from __future__ import annotations

import json
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING

import click

from sdgen.cli.params import split_names
from sdgen.cli.shared_options import ASSETS, EXTENSIONS

if TYPE_CHECKING:
    from sdgen.catalog.inventory import Stocked


@click.command("categories")
@EXTENSIONS
@ASSETS
@click.option(
    "--name",
    "words",
    multiple=True,
    metavar="WORD,...",
    help="Only categories with such a word in their names; repeatable.",
)
@click.option("--json", "as_json", is_flag=True, help="Print one JSON array.")
@click.argument("paths", metavar="[PATH]...", nargs=-1, type=click.Path(path_type=Path))
def list_categories(
    extensions: tuple[str, ...],
    assets: tuple[Path, ...],
    words: tuple[str, ...],
    as_json: bool,
    paths: tuple[Path, ...],
) -> None:
    """List what recipes can name: categories, their states and parts, and where they are.

    Those of the shipped catalogue and of catalogue folders or files at PATH: how many models there
    are, the states and the parts that these have, whether things can be put ON them, which hollows
    things can be INSIDE of, and the types of rooms that have them.

    \b
    Example: sdgen catalog categories --name stove,pan
    Example: sdgen catalog categories my_hazards --assets my_models --json
    """
    from sdgen.catalog.inventory import inventory
    from sdgen.catalog.load import load_catalog
    from sdgen.library import load_library

    catalog = load_catalog(paths, extensions=split_names(extensions))
    library = load_library(assets)
    by_category = {name: library.by_category(name) for name in library.categories}
    wanted = split_names(words)
    found = [
        one
        for one in inventory(catalog, by_category)
        if not wanted or any(word in one.name for word in wanted)
    ]
    if as_json:
        click.echo(json.dumps([asdict(one) for one in found], indent=1))
        return
    for one in found:
        click.echo(f"{one.name:24} {one.kind:11} {one.models:4} models")
        for title, text in _rows(one):
            click.echo(f"  {title:8} {text}")
    click.echo(f"{len(found)} categories")


def _rows(one: Stocked) -> list[tuple[str, str]]:
    holds = [
        *(["ON"] if one.on else []),
        *(["INSIDE: " + ", ".join(one.inside)] if one.inside else []),
    ]
    rows = [
        ("states", ", ".join(one.states)),
        ("parts", ", ".join(one.parts)),
        ("holds", "; ".join(holds)),
        ("rooms", ", ".join(one.rooms)),
    ]
    return [(title, text) for title, text in rows if text]
