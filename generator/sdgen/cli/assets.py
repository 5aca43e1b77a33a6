"""``sdgen assets``: what the library holds."""

from __future__ import annotations

import json
from pathlib import Path

import click

from sdgen.errors import UsageError, did_you_mean
from sdgen.library import Library, load_library
from sdgen.library.records import Asset

EXTRA = click.option(
    "--assets",
    "extra",
    type=click.Path(exists=True, file_okay=False),
    multiple=True,
    help="Extra asset folder; repeatable.",
)


@click.group()
def assets() -> None:
    """List and show the models.

    Example: sdgen assets list --json
    """


@assets.command("list")
@EXTRA
@click.option("--json", "as_json", is_flag=True, help="Print one JSON array.")
def list_assets(extra: tuple[str, ...], as_json: bool) -> None:
    """List every model.

    Example: sdgen assets list
    """
    models = [asset for _, asset in sorted(_library(extra).assets.items())]
    if as_json:
        click.echo(json.dumps([_row(asset) for asset in models], indent=1))
        return
    for asset in models:
        size = " x ".join(f"{length:.2f}" for length in asset.extents_m)
        line = f"{asset.id:24} {asset.faces:6} faces  {size} m  {asset.mass_kg:7.3g} kg  "
        click.echo((line + ", ".join(asset.state_names)).rstrip())
    click.echo(f"{len(models)} models in {len({asset.category for asset in models})} categories")


@assets.command("show")
@EXTRA
@click.option("--json", "as_json", is_flag=True, help="Print one JSON object.")
@click.argument("asset_id", metavar="ID")
def show_asset(extra: tuple[str, ...], as_json: bool, asset_id: str) -> None:
    """Show all that is known of one model.

    Example: sdgen assets show fridge_01
    """
    library = _library(extra)
    if asset_id not in library.assets:
        raise UsageError(f"no asset {asset_id!r}{did_you_mean(asset_id, sorted(library.assets))}")
    asset = library.assets[asset_id]
    if as_json:
        click.echo(json.dumps(asset.model_dump(mode="json"), indent=1))
        return
    click.echo(f"{asset.id}: {asset.title or asset.category}")
    for key, value in _row(asset).items():
        if key != "id":
            click.echo(f"  {key:11} {_plain(value)}")
    click.echo(f"  {'parts':11} {', '.join(part.name for part in asset.parts)}")
    for name, parts in asset.variants.items():
        click.echo(f"  variant     {name}: {', '.join(parts)}")
    for joint in asset.joints:
        click.echo(f"  joint       {joint.name}: {joint.type}, {joint.lower:g} to {joint.upper:g}")
    for support in asset.supports:
        inside = f", in {support.container}" if support.container else ""
        click.echo(f"  support     {support.name}: at {support.z_m:.2f} m{inside}")
    for container in asset.containers:
        shut = f", shut by {container.closed_by}" if container.closed_by else ""
        click.echo(f"  container   {container.name}{shut}")


def _library(extra: tuple[str, ...]) -> Library:
    return load_library([Path(folder) for folder in extra])


def _row(asset: Asset) -> dict[str, object]:
    return {
        "id": asset.id,
        "category": asset.category,
        "states": list(asset.state_names),
        "faces": asset.faces,
        "extents_m": list(asset.extents_m),
        "mass_kg": asset.mass_kg,
        "licence": asset.licence,
        "source": asset.source,
    }


def _plain(value: object) -> str:
    return ", ".join(str(item) for item in value) if isinstance(value, list) else str(value)
