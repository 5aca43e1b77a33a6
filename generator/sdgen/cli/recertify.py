"""``sdgen validate --catalog``: what another catalogue says of a data set's labels."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING

import click

from sdgen.errors import SHOWN

if TYPE_CHECKING:
    from sdgen.validate.recertify import Recertified


def certify_again(
    dataset: Path,
    catalogs: Sequence[Path],
    extensions: tuple[str, ...],
    workers: int,
    as_json: bool,
) -> bool:
    """Say what the catalogue of these folders and packs finds otherwise than the labels do; True
    when nothing. Without ``extensions`` the packs are the data set's own."""
    from sdgen.catalog.load import load_catalog
    from sdgen.cli.bar import bar
    from sdgen.dataset import Dataset
    from sdgen.validate.recertify import recertify

    data = Dataset(dataset, partial=True)
    catalog = load_catalog(catalogs, extensions=extensions or data.info.options.extensions)
    with bar("certifying") as on_scene:
        found = recertify(data, catalog, on_scene, workers)
    if as_json:
        click.echo(json.dumps(_record(found), indent=1, ensure_ascii=False))
    else:
        _say(dataset, found)
    return found.certifies


def _record(found: Recertified) -> dict[str, object]:
    return {
        "scenes": found.scenes,
        "certifies": found.certifies,
        "by_hazard": found.by_hazard(),
        "changed": [asdict(one) for one in found.changed],
        "unknown_categories": dict(sorted(found.foreign.items())),
        "redefined_categories": list(found.redefined),
        "problems": list(found.problems),
    }


def _say(dataset: Path, found: Recertified) -> None:
    lines = [*found.problems, *map(str, found.changed)]
    for line in lines[:SHOWN]:
        click.echo(line)
    if len(lines) > SHOWN:
        click.echo(f"and {len(lines) - SHOWN} more, which --json lists")
    for name, counts in found.by_hazard().items():
        words = f"{counts['kept']} labels hold"
        for change, what in (
            ("lost", "no longer do"),
            ("new", "hold unlabelled"),
            ("undecided", "undecided"),
        ):
            words += f", {counts[change]} {what}" if counts[change] else ""
        click.echo(f"{name:24} {words}")
    if found.foreign:
        words = ", ".join(f"{name} x{count}" for name, count in sorted(found.foreign.items()))
        click.echo(f"the catalogue has no category for {words}: it cannot certify these scenes")
    if found.redefined:
        names = ", ".join(found.redefined)
        click.echo(f"note: of other properties in the catalogue: {names}; zones are as stored")
    verdict = "certified" if found.certifies else "not certified: built with it, they would differ"
    click.echo(f"{dataset}: {found.scenes} scenes, {verdict}")
