"""``sdgen catalog test``: does everything that the recipes promise fit somewhere?"""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING

import click

from sdgen.cli.bar import bar
from sdgen.cli.params import split_names
from sdgen.cli.quiet import QUIET
from sdgen.cli.shared_options import ASSETS, EXTENSIONS, RENDERER
from sdgen.errors import UsageError
from sdgen.options import MAX_SEED

if TYPE_CHECKING:
    from sdgen.catalog.records import Catalog, UniqueAnomaly
    from sdgen.engines.trials import Tried

#: Lines about what does not fit on a terminal; the report has all.
_NAMED = 50


@click.command("test")
@EXTENSIONS
@ASSETS
@click.option(
    "--hazard", "hazards", multiple=True, metavar="ID,...", help="Only these hazards; repeatable."
)
@click.option(
    "--limit",
    type=click.IntRange(min=1),
    metavar="N",
    help="Only so many, spread over all hazards.",
)
@click.option(
    "--seed",
    type=click.IntRange(min=0, max=MAX_SEED),
    metavar="N",
    default=0,
    show_default=True,
    help="Seed of the homes.",
)
@click.option(
    "--attempts",
    type=click.IntRange(min=1, max=1000),
    metavar="N",
    default=20,
    show_default=True,
    help="Tries in each home; the default is a build's.",
)
@click.option(
    "--least",
    type=click.FloatRange(0, 100),
    metavar="PERCENT",
    default=98,
    show_default=True,
    help="So many must fit.",
)
@click.option(
    "-o",
    "--out",
    type=click.Path(file_okay=False, path_type=Path),
    metavar="FOLDER",
    help="Write a page, a report and a picture of each here.",
)
@click.option("--no-pictures", is_flag=True, help="The page and the report alone: half the time.")
@RENDERER
@click.option(
    "--workers",
    type=click.IntRange(min=1, max=1024),
    metavar="N",
    help="Processes [default: cores, fewer where memory is scarce].",
)
@QUIET
@click.option("--json", "as_json", is_flag=True, help="Print the report as one JSON object.")
@click.argument("paths", metavar="[PATH]...", nargs=-1, type=click.Path(path_type=Path))
def test_hazards(
    extensions: tuple[str, ...],
    assets: tuple[Path, ...],
    hazards: tuple[str, ...],
    limit: int | None,
    seed: int,
    attempts: int,
    least: float,
    out: Path | None,
    no_pictures: bool,
    renderer: str,
    workers: int | None,
    as_json: bool,
    paths: tuple[Path, ...],
) -> None:
    """Try every unique anomaly in furnished homes, and tell those that fit nowhere.

    Each is placed by its recipe, comes to rest, is proved, seen from around it and undone again,
    as in a build, in up to eight homes that have something for it, of forty. Of catalogue folders
    or files at PATH, and of packs, what they add is tested; without either, the shipped hazards.

    Exit code 3 when fewer than --least fit: those that do not are named, with what was in the way.

    \b
    Example: sdgen catalog test my_hazards --out tried
    Example: sdgen catalog test --extensions heat --limit 50
    """
    from sdgen.catalog.load import load_catalog
    from sdgen.engines.fit import check_buildable
    from sdgen.engines.machine import default_workers
    from sdgen.engines.trials import Trials, try_all
    from sdgen.gallery.trials_page import begin_trials, trials_report, write_trials
    from sdgen.home.drawing_check import check_drawings
    from sdgen.library import load_library
    from sdgen.library.cache import usable_cache
    from sdgen.render import choose_renderer

    catalog = load_catalog(paths, extensions=split_names(extensions))
    library = load_library(assets)
    check_drawings(catalog, library, paths)
    check_buildable(catalog, library)
    names = _meant(catalog, split_names(hazards), paths, split_names(extensions))
    choice = None if out is None or no_pictures else choose_renderer(renderer)
    pictures = begin_trials(out) if out is not None else None
    trials = Trials(
        catalog=catalog,
        library_folders=library.folders,
        library_sha256=library.sha256,
        unique=_some(catalog, names, limit),
        seed=seed,
        attempts=attempts,
        choice=choice,
        pictures=pictures,
    )
    with usable_cache(), bar("anomalies") as on_progress:
        tried = try_all(trials, workers or default_workers(), on_progress)
    page = None if out is None else write_trials(tried, catalog, library, out)
    report = trials_report(tried, library)
    if as_json:
        click.echo(json.dumps(report, indent=1))
    else:
        _say(tried, [why for why in report["anomalies"] if not why["fits"]])
        if page is not None:
            click.echo(f"look at it: {page}")
    if 100 * report["fit"] < least * report["tried"]:
        click.get_current_context().exit(3)


def _meant(
    catalog: Catalog, asked: tuple[str, ...], paths: tuple[Path, ...], extensions: tuple[str, ...]
) -> tuple[str, ...]:
    """The hazards to test: those ``asked`` for, else what paths and packs add, else all."""
    from sdgen.catalog.load import load_catalog
    from sdgen.hazards.hosting import check_named

    if asked:
        check_named(asked, catalog)
        return asked
    if not paths and not extensions:
        return tuple(hazard.id for hazard in catalog.hazards)
    shipped = load_catalog().hazards
    added = tuple(hazard.id for hazard in catalog.hazards if hazard not in shipped)
    if not added:
        where = ", ".join(str(path) for path in paths)
        raise UsageError(f"{where}: adds no hazard; name those to test with --hazard")
    return added


def _some(catalog: Catalog, names: tuple[str, ...], limit: int | None) -> tuple[UniqueAnomaly, ...]:
    """The unique anomalies of these hazards; ``limit`` of them, evenly spread in their order."""
    from sdgen.catalog.enumeration import enumerate_anomalies

    every = [one for one in enumerate_anomalies(catalog) if one.hazard in names]
    if limit is None or limit >= len(every):
        return tuple(every)
    return tuple(every[k * len(every) // limit] for k in range(limit))


def _say(tried: list[Tried], failed: list[dict[str, object]]) -> None:
    from sdgen.engines.trials import in_words

    totals: dict[str, list[bool]] = {}
    for one in tried:
        totals.setdefault(one.unique.hazard, []).append(one.fits)
    for name, fits in totals.items():
        click.echo(f"{name:32} {sum(fits):5} of {len(fits):5} fit")
    misfits = [one.unique for one in tried if not one.fits]
    for unique, why in list(zip(misfits, failed, strict=True))[:_NAMED]:
        click.echo(f"does not fit: {in_words(unique)}: {why['why_not']}")
    if len(failed) > _NAMED:
        click.echo(f"and {len(failed) - _NAMED} more, which the report of --out names")
    fit = len(tried) - len(failed)
    click.echo(f"{fit} of {len(tried)} unique anomalies fit ({fit / len(tried):.1%})")
