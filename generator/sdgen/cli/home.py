"""``sdgen home``: one home, drawn, or written as a file to edit or to load elsewhere."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import click

from sdgen.cli.group import NamedGroup
from sdgen.cli.params import destination, parsed
from sdgen.cli.shared_options import ASSETS, CATALOGS, RENDERER, SIZE, VIEWS
from sdgen.errors import UsageError
from sdgen.options import MAX_SEED, BuildOptions

if TYPE_CHECKING:
    from rich.table import Table

    from sdgen.catalog.records import Catalog
    from sdgen.gallery.home_summary import RoomSummary
    from sdgen.library import Library
    from sdgen.pipeline.one_home import OneHome

#: Endings of a home's own file.
_YAML = (".yaml", ".yml")
#: Most frequent categories of a room that the table names.
_NAMED = 3

#: As ``sdgen.importing.scenes.read`` has them.
_FORMATS = ["gltf", "mjcf", "replicacad", "virtualhome"]

_SEED = click.option(
    "--seed",
    type=click.IntRange(min=0, max=MAX_SEED),
    metavar="N",
    default=0,
    show_default=True,
    help="Furnishes a base home: which optional pieces, models and things it has.",
)
_WHICH = click.argument("which", metavar="SEED|NAME|FILE.yaml")


def _sources(command: Callable[..., Any]) -> Callable[..., Any]:
    """Which home is meant, and where it is from."""
    return _WHICH(_SEED(CATALOGS(ASSETS(command))))


@click.group(cls=NamedGroup)
def home() -> None:
    """List base homes, draw one home, write it as YAML, GLB or MJCF, or import a scene.

    Example: sdgen home show 7
    """


@home.command("list")
@CATALOGS
@click.option("--json", "as_json", is_flag=True, help="Print one JSON array.")
def list_homes(catalogs: tuple[Path, ...], as_json: bool) -> None:
    """List the base homes.

    Example: sdgen home list
    """
    from sdgen.catalog.load import load_catalog

    homes = load_catalog(catalogs).homes
    if as_json:
        rows = [
            {"id": one.id, "title": one.title, "rooms": [room.type for room in one.rooms]}
            for one in homes
        ]
        click.echo(json.dumps(rows, indent=1, ensure_ascii=False))
        return
    for one in homes:
        pieces = sum(len(room.furniture) for room in one.rooms)
        click.echo(f"{one.id:22} {len(one.rooms):2} rooms {pieces:4} pieces  {one.title}")


@home.command("show")
@_sources
@click.option(
    "-o",
    "--out",
    metavar="FOLDER",
    callback=parsed(destination),
    help="Folder of the pictures [default: output/home-{NAME}].",
)
@VIEWS
@SIZE
@RENDERER
@click.option("--json", "as_json", is_flag=True, help="Print the rooms as JSON.")
def show_home(
    which: str,
    seed: int,
    catalogs: tuple[Path, ...],
    assets: tuple[Path, ...],
    out: Path | None,
    views: int,
    pixels: tuple[int, int],
    renderer: str,
    as_json: bool,
) -> None:
    """Furnish one home, with everyday things and no hazard; draw its plan and views.

    SEED draws the generated home of that seed, NAME a base home ('sdgen home list'), FILE.yaml a
    home of your own.

    \b
    Example: sdgen home show 7
    Example: sdgen home show apartment_1 --seed 3 --out flat
    """
    from sdgen.gallery.home_pictures import write_pictures
    from sdgen.gallery.home_summary import summary_of
    from sdgen.render import choose_renderer

    options = BuildOptions(seed=seed, views=views, width=pixels[0], height=pixels[1])
    made, library = _make(which, catalogs, assets, options)
    choice = choose_renderer(renderer)
    if choice.note:
        click.echo(choice.note, err=True)
    folder = out if out is not None else Path("output") / f"home-{made.spec.id}"
    drawn = list(write_pictures(made.bundle, library, folder, choice))
    rooms = summary_of(made.bundle.scene)
    if as_json:
        click.echo(json.dumps([_row(room) for room in rooms], indent=1))
        return
    from sdgen.cli.table import echo_table

    echo_table(_table(made.spec.title, rooms))
    click.echo(f"{folder}: {drawn[0].name} and {len(drawn) - 1} views")


@home.command("export")
@_sources
@click.option(
    "-o",
    "--out",
    type=click.Path(dir_okay=False, path_type=Path),
    required=True,
    metavar="FILE",
    help="FILE.yaml (rooms, openings, furniture by model), FILE.glb or FILE.xml (all of it).",
)
def export_home(
    which: str, seed: int, catalogs: tuple[Path, ...], assets: tuple[Path, ...], out: Path
) -> None:
    """Write one home as a YAML file to edit, or as GLB or MJCF for other tools.

    The YAML has the plan and every piece of furniture with its model and place; small things are
    drawn anew by every seed. The GLB has the small things too: textured, in metres, Y up. So has
    the MJCF (FILE.xml, for MuJoCo), with collision pieces, masses and joints; its meshes and
    textures are in the folder FILE_assets beside it.

    \b
    Example: sdgen home export 7 -o my_homes/homes/my_flat.yaml
    Example: sdgen home export apartment_1 -o flat.glb
    Example: sdgen home export apartment_1 -o flat.xml
    """
    from sdgen.catalog.words import NOT_A_NAME, WORD
    from sdgen.dataset.output_file import check_output, write_output
    from sdgen.export.beside import check_beside, folder_beside, written_beside
    from sdgen.export.home_glb import home_glb
    from sdgen.export.home_mjcf import write_home_mjcf
    from sdgen.export.home_yaml import home_yaml
    from sdgen.export.model_files import ModelFiles

    if out.suffix not in (*_YAML, ".glb", ".xml"):
        raise UsageError(f"{out}: expected a name that ends in .yaml, .glb or .xml")
    if out.suffix in _YAML and not WORD.fullmatch(out.stem):
        raise UsageError(f"{out}: a home is called as its file, and {out.stem!r} {NOT_A_NAME}")
    check_output(out)
    if out.suffix == ".xml":
        check_beside(out)
    made, library = _make(which, catalogs, assets, BuildOptions(seed=seed, views=0))
    scene, spec = made.bundle.scene, made.spec
    if out.suffix == ".glb":
        write_output(out, home_glb(scene, library, spec))
    elif out.suffix == ".xml":
        beside = folder_beside(out)
        with written_beside(out) as folder:
            data = write_home_mjcf(scene, library, ModelFiles(library, folder), beside.name, spec)
        write_output(out, data)
        click.echo(str(beside))
    else:
        write_output(out, home_yaml(out.stem, made.spec, made.furnished).encode())
    click.echo(str(out))


@home.command("import")
@click.argument("format_", metavar="FORMAT", type=click.Choice(_FORMATS))
@click.argument("path", type=click.Path(exists=True, dir_okay=False, path_type=Path))
@click.option(
    "-o",
    "--out",
    type=click.Path(dir_okay=False, path_type=Path),
    required=True,
    metavar="FILE.yaml",
    help="The base home to write; its id is the file's name.",
)
@click.option(
    "--library",
    "assets",
    type=click.Path(exists=True, path_type=Path),
    multiple=True,
    help="Asset folder with models of the scene, as 'assets import' writes them; repeatable.",
)
@click.option(
    "--violating",
    type=click.Choice(["remove", "label"]),
    default="remove",
    show_default=True,
    help="Things that are a hazard as they lie: left out, or kept and labelled in every scene.",
)
@CATALOGS
@click.option("--json", "as_json", is_flag=True, help="Print what was found as one JSON object.")
def import_scene(
    format_: str,
    path: Path,
    out: Path,
    assets: tuple[Path, ...],
    violating: Literal["remove", "label"],
    catalogs: tuple[Path, ...],
    as_json: bool,
) -> None:
    """Read somebody's furnished scene and write it as a base home.

    FORMAT is mjcf (MuJoCo's XML: ours, MolmoSpaces', RoboCasa's), gltf (named nodes, .glb or
    .gltf), virtualhome (a graph's JSON) or replicacad (a *.scene_instance.json). Rooms, openings
    and furniture are drawn as base homes have them; what cannot be is listed, and stands in the
    file's head.

    \b
    Example: sdgen home import gltf flat.glb -o my_flat.yaml
    Example: sdgen home import replicacad apt_0.scene_instance.json --library cad -o apt_0.yaml
    """
    from sdgen.catalog.load import load_catalog
    from sdgen.catalog.words import NOT_A_NAME, WORD
    from sdgen.dataset.output_file import check_output, write_output
    from sdgen.importing.scenes.read import import_home, text_of
    from sdgen.importing.scenes.table_namer import table_namer
    from sdgen.library import load_library

    if out.suffix not in _YAML or not WORD.fullmatch(out.stem):
        named = f"and {out.stem!r} {NOT_A_NAME}" if out.suffix in _YAML else "with .yaml at its end"
        raise UsageError(f"{out}: a home is called as its file, {named}")
    check_output(out)
    catalog = load_catalog(catalogs)
    if any(one.id == out.stem for one in catalog.homes):
        raise UsageError(f"{out}: there is a home called {out.stem!r} already; name another file")
    library = load_library(assets)
    namer = table_namer(format_, catalog)
    made = import_home(format_, path, out.stem, catalog, library, namer, violating)
    write_output(out, text_of(made, format_, path).encode())
    if as_json:
        lists = {"guessed": made.guessed, "assumed": made.told, "unresolved": made.unresolved}
        click.echo(json.dumps({"home": str(out), **made.counts, **lists}, indent=1))
        return
    for what, lines in (
        ("guessed", made.guessed),
        ("assumed", made.told),
        ("left out", made.unresolved),
    ):
        for line in lines:
            click.echo(f"{what}: {line}")
    counts = made.counts
    click.echo(
        f"{out}: {counts['rooms']} rooms, {counts['openings']} openings, {counts['furniture']} "
        f"pieces of furniture, {counts['things']} things ({counts['labelled']} labelled); "
        f"{len(made.unresolved)} of {counts['found']} left out"
    )


def _make(
    which: str, catalogs: Sequence[Path], assets: Sequence[Path], options: BuildOptions
) -> tuple[OneHome, Library]:
    # Imported here: simulator and meshes take a second that --help should not.
    from sdgen.library import load_library
    from sdgen.pipeline.one_home import one_home

    catalog, name, files = _catalog(which, catalogs)
    library = load_library(assets)
    if files:
        from sdgen.home.drawing_check import check_drawings

        check_drawings(catalog, library, files)
    return one_home(name, catalog, library, options), library


def _catalog(which: str, catalogs: Sequence[Path]) -> tuple[Catalog, str, Sequence[Path]]:
    """The catalogue, the home's name or seed in it, and the extra files that it was read from."""
    from sdgen.catalog.load import load_catalog

    path = Path(which)
    own = path.suffix in _YAML
    files = [*catalogs, path] if own else [*catalogs]
    return load_catalog(files), path.stem if own else which, files


def _row(room: RoomSummary) -> dict[str, Any]:
    return {
        "name": room.name,
        "type": room.type,
        "area_m2": round(room.area_m2, 2),
        "nodes": room.nodes,
        "furniture": dict(sorted(room.furniture.items())),
        "things": dict(sorted(room.things.items())),
    }


def _table(title: str, rooms: Sequence[RoomSummary]) -> Table:
    from rich.table import Table

    table = Table(title=title, show_footer=True)
    every: Counter[str] = Counter()
    for room in rooms:
        every += room.furniture + room.things
    numbers = {
        "m2": f"{sum(room.area_m2 for room in rooms):.1f}",
        "nodes": str(sum(room.nodes for room in rooms)),
        "furniture": str(sum(room.furniture.total() for room in rooms)),
        "things": str(sum(room.things.total() for room in rooms)),
        "categories": str(len(every)),
    }
    table.add_column("room", footer="all")
    for name, footer in numbers.items():
        table.add_column(name, footer=footer, justify="right")
    table.add_column("most of all")
    for room in rooms:
        held = room.furniture + room.things
        most = sorted(held.items(), key=lambda pair: (-pair[1], pair[0]))[:_NAMED]
        table.add_row(
            room.name,
            f"{room.area_m2:.1f}",
            str(room.nodes),
            str(room.furniture.total()),
            str(room.things.total()),
            str(len(held)),
            ", ".join(f"{count} {name}" for name, count in most).replace("_", " "),
        )
    return table
