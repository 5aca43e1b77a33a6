"""``sdgen assets``: what the library holds."""

from __future__ import annotations

import json
from pathlib import Path

import click

from sdgen.cli.assets_fetch import fetch_assets
from sdgen.cli.assets_import import import_assets
from sdgen.cli.assets_retexture import retexture_model
from sdgen.cli.bar import bar
from sdgen.cli.group import NamedGroup
from sdgen.cli.quiet import QUIET
from sdgen.errors import UsageError, did_you_mean
from sdgen.library import Library, load_library
from sdgen.library.records import Asset
from sdgen.library.select import select
from sdgen.render.registry import AUTO, RENDERERS
from sdgen.resources import data_path

EXTRA = click.option(
    "--assets",
    "extra",
    type=click.Path(exists=True, file_okay=False),
    multiple=True,
    help="Extra asset folder; repeatable.",
)


@click.group(cls=NamedGroup)
def assets() -> None:
    """List, show, draw, check, fetch, import and retexture models.

    Example: sdgen assets list --json
    """


assets.add_command(fetch_assets)
assets.add_command(import_assets)
assets.add_command(retexture_model)


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
    for pose in asset.resting:
        click.echo(f"  rests       {_pointing(pose.up)} up: {pose.share:.0%}")


@assets.command("sheet")
@EXTRA
@click.option(
    "-o",
    "--out",
    type=click.Path(dir_okay=False, path_type=Path),
    default=Path("assets.png"),
    show_default=True,
    help="Picture to write, PNG or JPEG; of more than one page, each gets its number.",
)
@click.option("--states", is_flag=True, help="Every variant, and joints open, beside the default.")
@click.option(
    "--size",
    type=click.IntRange(32, 1024),
    default=128,
    show_default=True,
    help="Pixels a side of each picture.",
)
@click.option(
    "--columns",
    type=click.IntRange(1, 64),
    default=14,
    show_default=True,
    help="Pictures in a row.",
)
@click.option(
    "--per-page",
    type=click.IntRange(1, 2000),
    default=224,
    show_default=True,
    help="Pictures on a page.",
)
@click.option(
    "--renderer",
    type=click.Choice([AUTO, *RENDERERS]),
    default="auto",
    show_default=True,
    help="What draws the models.",
)
@QUIET
@click.argument("words", metavar="[LIBRARY|ID|CATEGORY]...", nargs=-1)
def sheet(
    extra: tuple[str, ...],
    out: Path,
    states: bool,
    size: int,
    columns: int,
    per_page: int,
    renderer: str,
    words: tuple[str, ...],
) -> None:
    """Draw models alone on a floor, as scenes draw them, with their names.

    LIBRARY is a folder that 'assets import' filled: each of its models as it was in its source, as
    far as that is still there, and beside it as it came out.

    \b
    Example: sdgen assets sheet -o mugs.png mug --states
    Example: sdgen assets sheet -o library.jpg
    Example: sdgen assets sheet -o imported.jpg my_models
    """
    from PIL import Image

    from sdgen.cli.before_tile import before_tile
    from sdgen.dataset.output_file import check_output, output_file
    from sdgen.gallery.sheet import contact_sheet, pages
    from sdgen.render import open_renderer
    from sdgen.render.portraits import looks_of, portrait

    if out.suffix.lower() not in (".png", ".jpg", ".jpeg"):
        raise UsageError(f"{out}: a sheet is a .png or a .jpg")
    if not out.parent.is_dir():
        raise UsageError(f"{out.parent}: no such folder")
    check_output(out)
    folders = [Path(word) for word in words if (Path(word) / "manifest.yaml").is_file()]
    words = tuple(word for word in words if Path(word) not in folders)
    library = _library((*extra, *map(str, folders)))
    chosen = list(select(library, words)) if words or not folders else []
    chosen += [name for name in library.assets if library.folder_of(name) in folders]
    wanted = []
    for asset_id in dict.fromkeys(chosen):
        looks = looks_of(library.info(asset_id))
        for look in looks if states else looks[:1]:
            label = asset_id if look.name == "default" else f"{asset_id} {look.name}"
            wanted.append((asset_id, look, label))
    split = list(pages(len(wanted), per_page))
    with open_renderer(renderer) as drawn_by, bar("drawing") as on_model:
        for number, page in enumerate(split, start=1):
            tiles = []
            for k in page:
                asset_id, look, label = wanted[k]
                if look.name == "default" and library.folder_of(asset_id) in folders:
                    tiles += before_tile(drawn_by, library, asset_id, size)
                tiles.append((label, portrait(drawn_by, library, asset_id, look, size)))
                if on_model is not None:
                    on_model(k + 1, len(wanted))
            path = out if len(split) == 1 else out.with_stem(f"{out.stem}-{number:02d}")
            kind = "PNG" if path.suffix.lower() == ".png" else "JPEG"
            with output_file(path) as file:
                Image.fromarray(contact_sheet(tiles, columns)).save(file, kind, quality=88)
            click.echo(f"{path}: {len(tiles)} pictures")


@assets.command("validate")
@click.option(
    "--catalog",
    "catalogs",
    type=click.Path(exists=True, path_type=Path),
    multiple=True,
    help="Catalogue folder with sizes of further categories; repeatable.",
)
@click.option("--only", metavar="ID|CATEGORY", multiple=True, help="Check these; repeatable.")
@click.option(
    "--workers", type=click.IntRange(min=1), metavar="N", help="Processes [default: cores]."
)
@QUIET
@click.argument(
    "folders",
    type=click.Path(exists=True, file_okay=False, path_type=Path),
    metavar="[PATH]...",
    nargs=-1,
)
def validate_assets(
    catalogs: tuple[Path, ...],
    only: tuple[str, ...],
    workers: int | None,
    folders: tuple[Path, ...],
) -> None:
    """Check every model of asset folders (none given: of the shipped library).

    Scale against the category's range, faces, no holes unless declared open, texture and its
    coordinates, licence, collision pieces against the visual mesh, stable rest, joints that clear
    the body, supports on the mesh. Exit code 1 when anything is wrong.

    \b
    Example: sdgen assets validate
    Example: sdgen assets validate my_assets --catalog my_hazards
    """
    from sdgen.catalog.load import load_catalog
    from sdgen.engines.machine import usable_cores
    from sdgen.validate.assets import check_assets

    library = Library([data_path("assets"), *folders])  # its files are read by what checks them
    count = sum(
        not folders or library.folder_of(asset_id) in folders for asset_id in select(library, only)
    )
    with bar("checking") as on_model:
        problems = check_assets(
            folders, load_catalog(catalogs), on_model, workers or usable_cores(), only
        )
    for problem in problems:
        click.echo(problem)
    if problems:
        noun = "problem" if len(problems) == 1 else "problems"
        click.echo(f"{count} models checked, {len(problems)} {noun}", err=True)
        click.get_current_context().exit(1)
    click.echo(f"{count} models checked, no problem found")


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


def _pointing(up: tuple[float, float, float]) -> str:
    axis = max(range(3), key=lambda k: abs(up[k]))
    if abs(up[axis]) > 0.97:
        return ("+" if up[axis] > 0 else "-") + "xyz"[axis]
    return "(" + ", ".join(f"{value:.2f}" for value in up) + ")"
