"""``sdgen evaluate``: how good predictions are."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from sdgen.cli.quiet import QUIET, hint

if TYPE_CHECKING:
    from sdgen.benchmark import BaseRates
    from sdgen.dataset import Dataset
    from sdgen.dataset.records import Predictions


@click.command(short_help="Score predictions against a data set.")
@click.argument("dataset", type=click.Path(path_type=Path), metavar="DATASET")
@click.argument(
    "predictions",
    type=click.Path(path_type=Path),
    metavar="PREDICTIONS...",
    nargs=-1,
    required=True,
)
@click.option("--split", help="Score only the scenes of train, val or test.")
@click.option(
    "--name",
    "names",
    multiple=True,
    help="What tables call a file, in their order; repeatable [default: the files' names].",
)
@click.option(
    "--lenient",
    is_flag=True,
    help="Skip and count bad lines and reports; objects that do not exist are false alarms.",
)
@click.option(
    "--base-rate",
    type=float,
    metavar="SHARE",
    help="Also score where so few of the homes have a hazard, such as 0.05.",
)
@click.option(
    "--inspections",
    type=float,
    default=1.0,
    show_default=True,
    metavar="N",
    help="Times a day that a home is looked at, for the base rate.",
)
@click.option(
    "--costs",
    type=click.Path(path_type=Path, dir_okay=False),
    metavar="FILE.yaml",
    help="What mistakes cost, for the base rate [default: those in the documents].",
)
@click.option(
    "--items",
    type=click.Path(path_type=Path, dir_okay=False),
    metavar="FILE",
    help="Also write a row an anomaly, false alarm and lookalike, as .jsonl or .csv.",
)
@click.option(
    "--plot",
    type=click.Path(path_type=Path, dir_okay=False),
    metavar="FILE.svg",
    help="Also draw recall by hazard and the operating curve.",
)
@click.option(
    "--report",
    type=click.Path(path_type=Path, file_okay=False),
    metavar="FOLDER",
    help="Also write a page with all this, and the worst scenes with pictures.",
)
@click.option(
    "--worst",
    type=click.IntRange(min=0, max=1000),
    default=12,
    show_default=True,
    metavar="N",
    help="Scenes that the report shows.",
)
@click.option("--gallery", metavar="FOLDER", help="The gallery that the report's scenes link to.")
@QUIET
@click.option("--json", "as_json", is_flag=True, help="Print one JSON object.")
def evaluate(
    dataset: Path,
    predictions: tuple[Path, ...],
    split: str | None,
    names: tuple[str, ...],
    lenient: bool,
    base_rate: float | None,
    inspections: float,
    costs: Path | None,
    items: Path | None,
    plot: Path | None,
    report: Path | None,
    worst: int,
    gallery: str | None,
    as_json: bool,
) -> None:
    """Score predictions files against a data set.

    Every score is a mean over scenes (hazards: over anomalies) with its standard error and a 95 %
    interval. A scene without a line counts as silence. Further files are compared with the first,
    scene by scene.

    \b
    Example: sdgen evaluate output/sdgen-n12-s7 predictions.jsonl --json
    Example: sdgen evaluate output/sdgen-n12-s7 mine.jsonl theirs.jsonl --report report
    """
    from sdgen.benchmark import read_costs
    from sdgen.benchmark.base_rates import rates_of
    from sdgen.benchmark.collect import collect, opened
    from sdgen.benchmark.compare import comparisons
    from sdgen.benchmark.metrics import evaluation
    from sdgen.benchmark.predictions import silence
    from sdgen.cli.evaluation_tables import echo_evaluations
    from sdgen.dataset import Dataset
    from sdgen.errors import UsageError

    context = click.get_current_context()
    called = _names(predictions, names)
    _check_options(context, base_rate, costs, report, gallery)
    pages = None if gallery is None or _address(gallery) else Path(gallery)
    _check_outputs(items, plot, report, [*predictions, *filter(None, (costs, pages))])
    table = read_costs(costs) if costs is not None else None
    data = opened(Dataset(dataset, split=split))
    read, skipped = _read(data, called, lenient)
    found = collect(data, read)
    scores = {name: evaluation(found, name) for name in called}
    rates: dict[str, BaseRates] = {}
    if base_rate is not None or costs is not None or plot is not None or report is not None:
        share = 0.05 if base_rate is None else base_rate
        try:
            rates = {name: rates_of(found, name, share, inspections, table) for name in called}
        except UsageError:
            if base_rate is not None or costs is not None:
                raise  # else nobody asked for them
    compared = comparisons(found)
    notes = [
        f"{called[name]}: {note}" for name, lenience in skipped.items() for note in lenience.notes()
    ]
    notes += [
        f"{called[name]}: {note}" for name, said in read.items() if (note := silence(said, data))
    ]
    for note in notes:
        click.echo(note, err=True)
    if items is not None:
        from sdgen.benchmark.items import write_items

        count = write_items(items, found)
        hint(f"{items}: {count} rows")
    if plot is not None:
        from sdgen.benchmark.plot import write_plot

        write_plot(plot, scores, rates)
        hint(f"{plot}")
    if report is not None:
        from sdgen.benchmark.report import ReportOptions, write_report

        options = ReportOptions(worst=worst, gallery=gallery, notes=tuple(notes))
        hint(f"{write_report(found, rates, report, options)}")
    told = rates if base_rate is not None or costs is not None else {}
    if as_json:
        parts = {
            name: {
                **one.model_dump(mode="json"),
                **({"base_rates": told[name].model_dump(mode="json")} if told else {}),
                **({"skipped": dict(skipped[name].counts)} if lenient else {}),
            }
            for name, one in scores.items()
        }
        for one in compared:
            parts[one.detector]["compared"] = one.model_dump(mode="json")
        click.echo(json.dumps(parts if len(parts) > 1 else next(iter(parts.values())), indent=1))
        return
    echo_evaluations(scores, compared, told)


def _names(files: Sequence[Path], names: Sequence[str]) -> dict[str, Path]:
    """What each file is called. Raises UsageError for too few or repeated names."""
    from sdgen.errors import UsageError

    if names and len(names) != len(files):
        raise UsageError(f"--name was given {len(names)} times for {len(files)} files")
    if not all(name.strip() for name in names):
        raise UsageError("--name: a name of nothing")
    called = dict(zip(names or [file.stem for file in files], files, strict=True))
    if len(called) < len(files):
        raise UsageError("several files have one name; give each its --name")
    return called


def _check_options(
    context: click.Context,
    base_rate: float | None,
    costs: Path | None,
    report: Path | None,
    gallery: str | None,
) -> None:
    """Raises UsageError for options that would change nothing."""
    from sdgen.errors import UsageError

    for name, wanted, there in (
        ("inspections", "--base-rate, --costs or --report", base_rate or costs or report),
        ("worst", "--report", report),
        ("gallery", "--report", report),
    ):
        source = context.get_parameter_source(name)
        if source is click.core.ParameterSource.COMMANDLINE and not there:
            raise UsageError(f"--{name} goes with {wanted}")
    if gallery is not None and not _address(gallery) and not Path(gallery).is_dir():
        raise UsageError(f"--gallery {gallery}: no such folder; make it first: sdgen view")


def _address(gallery: str) -> bool:
    return gallery.startswith(("http://", "https://"))


def _check_outputs(
    items: Path | None, plot: Path | None, report: Path | None, inputs: Sequence[Path]
) -> None:
    """All of them before the work, so that none is written where another cannot be."""
    from sdgen.benchmark.items import check_items
    from sdgen.benchmark.plot import check_plot
    from sdgen.dataset.output_file import check_output, refuse_mixed

    refuse_mixed([path for path in (items, plot, report) if path is not None], inputs)
    if items is not None:
        check_items(items)
        check_output(items)
    if plot is not None:
        check_plot(plot)
        check_output(plot)
    if report is not None:
        from sdgen.benchmark.report import check_report

        check_report(report)


def _read(
    data: Dataset, called: Mapping[str, Path], lenient: bool
) -> tuple[dict[str, Predictions], dict[str, Any]]:
    from sdgen.benchmark import read_leniently, read_predictions

    if not lenient:
        return {name: read_predictions(path, data) for name, path in called.items()}, {}
    found = {name: read_leniently(path, data) for name, path in called.items()}
    return {name: one.predictions for name, one in found.items()}, found
