"""``sdgen build``: the main job."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Literal

import click

from sdgen.cli.disk import bytes_needed, check_destination, disk_line
from sdgen.cli.params import (
    destination,
    hazard_count,
    homes_meant,
    metres,
    parsed,
    scene_range,
    sensor_list,
    split_names,
)
from sdgen.cli.shared_options import ASSETS, CATALOGS, EXTENSIONS, RENDERER, SIZE, VIEWS
from sdgen.errors import BuildIncomplete, UsageError
from sdgen.looks import PRESETS, CameraLook, look_of
from sdgen.options import (
    MAX_SCENES,
    MAX_SEED,
    BuildOptions,
    Sensor,
    check_index_range,
)

if TYPE_CHECKING:
    from sdgen.engines.report import BuildReport

FOLDER = click.Path(exists=True, path_type=Path)


#: The least and the most height of cameras, metres: a crawling robot's, under a door's lintel.
EYES_M = (0.1, 2.2)


def eye_height(text: str) -> float:
    """``1.2`` -> 1.2. ValueError for heights that no camera can have."""
    value = metres(text)
    if not EYES_M[0] < value <= EYES_M[1]:
        raise ValueError(f"is not above {EYES_M[0]} and up to {EYES_M[1]} metres")
    return value


@click.command(short_help="Build a data set of labelled homes.")
@click.option(
    "--n",
    type=click.IntRange(min=0, max=MAX_SCENES),
    metavar="N",
    default=10,
    show_default=True,
    help="Number of scenes.",
)
@click.option(
    "--seed",
    type=click.IntRange(min=0, max=MAX_SEED),
    metavar="N",
    default=0,
    show_default=True,
    help="Root seed; 0 is a seed like any other.",
)
@click.option(
    "-o",
    "--out",
    metavar="FOLDER",
    callback=parsed(destination),
    help="Destination [default: output/sdgen-n{N}-s{SEED}]. A larger --n on the same one "
    "extends it.",
)
@click.option(
    "--homes",
    metavar="base|procedural|mixed|FILE.yaml",
    callback=parsed(homes_meant),
    default="mixed",
    show_default=True,
    help="Base homes, generated ones, or both; or the home of a file, alone.",
)
@click.option(
    "--hazards",
    metavar="MIN-MAX",
    callback=parsed(hazard_count),
    default="0-5",
    show_default=True,
    help="Anomalies a scene.",
)
@click.option(
    "--only",
    multiple=True,
    metavar="HAZARD,...",
    help="Draw these hazards alone, and near misses of them; all others stay proved absent.",
)
@VIEWS
@click.option(
    "--views-mode",
    type=click.Choice(["chosen", "panorama"]),
    default="chosen",
    show_default=True,
    help="chosen: K views that show what there is to see; panorama: of each room a full turn of "
    "views from the place that sees most, whatever --views says. Scenes are the same.",
)
@click.option(
    "--equirect",
    is_flag=True,
    help="Also write each turn as one equirectangular picture and mask (with --views-mode "
    "panorama).",
)
@SIZE
@click.option(
    "--sensors",
    metavar="LIST",
    callback=parsed(sensor_list),
    default="rgb,depth,instance",
    show_default=True,
    help="What each view writes, or none.",
)
@click.option(
    "--eye-height",
    metavar="METRES",
    callback=parsed(eye_height),
    default="1.2",
    show_default=True,
    help="Usual height of the cameras: a robot's eyes (lifted to look onto high shelves).",
)
@click.option(
    "--rgb",
    type=click.Choice(["png", "jpg"]),
    default="png",
    show_default=True,
    help="Format of the colour pictures.",
)
@click.option(
    "--supersample",
    type=click.Choice(["1", "2"]),
    default="1",
    show_default=True,
    help="2 renders RGB at twice the size and averages.",
)
@click.option(
    "--look",
    metavar="|".join([*PRESETS, "NAME=STRENGTH,..."]),
    callback=parsed(look_of),
    default="none",
    show_default=True,
    help="What cameras do to the colours, drawn for each view: a look by name, strengths of noise, "
    "blur, vignetting, white_balance and exposure, or both (phone,noise=0.03). Masks and depth "
    "stay perfect.",
)
@RENDERER
@CATALOGS
@EXTENSIONS
@ASSETS
@click.option(
    "--assets-only",
    is_flag=True,
    help="Small things of the --assets folders alone, of every category that these have.",
)
@click.option(
    "--non-commercial",
    is_flag=True,
    help="Use models whose licence allows no trade; the data set's does not either, then.",
)
@click.option(
    "--twins",
    is_flag=True,
    help="Also write each scene's benign twin, its anomalies undone by their remedies.",
)
@click.option(
    "--toggles",
    is_flag=True,
    help="Also write, for each anomaly, the scene with that one alone undone.",
)
@click.option(
    "--observability",
    is_flag=True,
    help="Also write from which poses of the free floor an agent can see each anomaly.",
)
@click.option(
    "--draw",
    type=click.Choice(["balanced", "iid"]),
    default="balanced",
    show_default=True,
    help="How the number of anomalies and their classes are drawn.",
)
@click.option(
    "--workers",
    type=click.IntRange(min=1, max=1024),
    metavar="N",
    help="Processes [default: cores, fewer where memory is scarce; of a cluster all its cores].",
)
@click.option(
    "--engine",
    type=click.Choice(["local", "ray"]),
    default="local",
    show_default=True,
    help="Where the workers run: this machine, or a Ray cluster (pip install 'sdgen[ray]').",
)
@click.option("--ray-address", metavar="ADDRESS", help="Ray cluster to join (with --engine ray).")
@click.option(
    "--range",
    "index_range",
    metavar="A:B",
    callback=parsed(scene_range),
    help="Only scenes A to B-1, for array jobs.",
)
@click.option("--overwrite", is_flag=True, help="Start anew instead of resuming.")
@click.option("--quiet", is_flag=True, help="No progress: only notes, errors and the summary.")
@click.option("--json", "as_json", is_flag=True, help="Print the summary as one JSON object.")
def build(
    n: int,
    seed: int,
    out: Path | None,
    homes: Literal["base", "procedural", "mixed"] | Path,
    hazards: tuple[int, int],
    only: tuple[str, ...],
    views: int,
    views_mode: Literal["chosen", "panorama"],
    equirect: bool,
    pixels: tuple[int, int],
    sensors: tuple[Sensor, ...],
    eye_height: float,
    rgb: Literal["png", "jpg"],
    supersample: str,
    look: CameraLook,
    renderer: str,
    catalogs: tuple[Path, ...],
    extensions: tuple[str, ...],
    assets: tuple[Path, ...],
    assets_only: bool,
    non_commercial: bool,
    twins: bool,
    toggles: bool,
    observability: bool,
    draw: Literal["balanced", "iid"],
    workers: int | None,
    engine: Literal["local", "ray"],
    ray_address: str | None,
    index_range: tuple[int, int] | None,
    overwrite: bool,
    quiet: bool,
    as_json: bool,
) -> None:
    """Build a data set of labelled homes.

    The same command resumes where an earlier run stopped; scene i depends only on the
    catalogue, the models, the content options, the seed and i.

    \b
    Example: sdgen build --n 1000 --seed 7
    Example: sdgen build --n 50 --seed 7 --views 4 --size 320x240 --out small
    Example: sdgen build --n 10 --homes my_flat.yaml --out in_my_flat
    """
    if ray_address is not None and engine != "ray":
        raise UsageError("--ray-address goes with --engine ray")
    if assets_only and not assets:
        raise UsageError("--assets-only goes with --assets")
    if equirect and (views_mode != "panorama" or {"rgb", "instance"}.isdisjoint(sensors)):
        raise UsageError("--equirect goes with --views-mode panorama, and with rgb or instance")
    named = tuple(sorted(split_names(only)))
    if named and _by_default("hazards"):
        # Each is shown once a scene: of one hazard there are no five.
        hazards = (hazards[0], min(hazards[1], len(named)))
    options = BuildOptions(
        n=n,
        seed=seed,
        homes="base" if isinstance(homes, Path) else homes,
        hazards_min=hazards[0],
        hazards_max=hazards[1],
        draw=draw,
        extensions=split_names(extensions),
        only=named,
        views=views,
        views_mode=views_mode,
        equirect=equirect,
        width=pixels[0],
        height=pixels[1],
        sensors=sensors,
        rgb=rgb,
        supersample=2 if supersample == "2" else 1,
        look=look,
        renderer=renderer,
        eye_height_m=eye_height,
        twins=twins,
        toggles=toggles,
        observability=observability,
        assets_only=assets_only,
    )
    first, end = index_range if index_range is not None else (0, n)
    check_index_range(first, end, n)
    out = out if out is not None else Path("output") / f"sdgen-n{n}-s{seed}"
    check_destination(out)
    todo = end - first - (0 if overwrite else _present(out, first, end))
    if not quiet:
        click.echo(f"{out}: {end - first} scenes asked for, {todo} to build", err=True)
    line = disk_line(out, bytes_needed(options, todo))
    if not quiet:
        click.echo(line, err=True)
    where = Where(out, (first, end), overwrite, workers, engine, ray_address, non_commercial)
    alone = homes if isinstance(homes, Path) else None
    _close(carry_out(options, where, catalogs, assets, quiet, alone), as_json)


def _by_default(parameter: str) -> bool:
    """True when the command line does not say the parameter."""
    source = click.get_current_context().get_parameter_source(parameter)
    return source is click.core.ParameterSource.DEFAULT


@dataclass(frozen=True)
class Where:
    """All that a data set does not remember: where it goes and who makes it."""

    out: Path
    index_range: tuple[int, int]
    overwrite: bool
    workers: int | None
    engine: str
    address: str | None
    non_commercial: bool


def _present(out: Path, first: int, end: int) -> int:
    """Scene folders of the range that an earlier run left, for the disk estimate."""
    return sum((out / "scenes" / f"{index:06d}").is_dir() for index in range(first, end))


def carry_out(
    options: BuildOptions,
    where: Where,
    catalogs: tuple[Path, ...],
    assets: tuple[Path, ...],
    quiet: bool,
    home: Path | None = None,
) -> BuildReport:
    # Imported here: simulator and meshes take a second that --help should not.
    from sdgen.catalog.load import load_catalog
    from sdgen.cli.progress import watch
    from sdgen.engines.build import build as run_build
    from sdgen.engines.registry import EngineOptions
    from sdgen.home.drawing_check import check_drawings
    from sdgen.library import load_library
    from sdgen.pipeline.one_home import base_home

    files = [*catalogs] if home is None else [*catalogs, home]
    catalog = load_catalog(files, extensions=options.extensions)
    library = load_library(assets)
    check_drawings(catalog, library, files)
    if home is not None:
        catalog = catalog.model_copy(update={"homes": (base_home(home.stem, catalog),)})
    with watch(where.index_range[1] - where.index_range[0], quiet) as on_event:
        return run_build(
            options=options,
            out=where.out,
            catalog=catalog,
            library=library,
            workers=where.workers,
            index_range=where.index_range,
            overwrite=where.overwrite,
            on_event=on_event,
            engine=EngineOptions(where.engine, where.address),
            non_commercial=where.non_commercial,
        )


def _close(report: BuildReport, as_json: bool) -> None:
    from sdgen.cli.progress import as_record, summary

    click.echo(json.dumps(as_record(report), indent=1) if as_json else summary(report))
    if not report.complete:
        missing = report.requested - report.made - report.resumed
        names = ", ".join(failed.scene_id for failed in report.failed[:20])
        raise BuildIncomplete(f"{missing} of {report.requested} scenes could not be made: {names}")
    if not as_json:
        click.echo(f"look at it: sdgen view {report.out}")
