"""``sdgen evaluate``: how good predictions are."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

if TYPE_CHECKING:
    from sdgen.benchmark import BaseRates, Comparison, Evaluation, Score
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
    from sdgen.dataset import Dataset
    from sdgen.errors import UsageError

    called = _names(predictions, names)
    _check_outputs(items, plot, report)  # before the work
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
    for note in notes:
        click.echo(note, err=True)
    if items is not None:
        from sdgen.benchmark.items import write_items

        count = write_items(items, found)
        click.echo(f"{items}: {count} rows", err=True)
    if plot is not None:
        from sdgen.benchmark.plot import write_plot

        write_plot(plot, scores, rates)
        click.echo(f"{plot}", err=True)
    if report is not None:
        from sdgen.benchmark.report import ReportOptions, write_report

        options = ReportOptions(worst=worst, gallery=gallery, notes=tuple(notes))
        click.echo(f"{write_report(found, rates, report, options)}", err=True)
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
    _echo(scores, compared, told)


def _names(files: Sequence[Path], names: Sequence[str]) -> dict[str, Path]:
    """What each file is called. Raises UsageError for too few or repeated names."""
    from sdgen.errors import UsageError

    if names and len(names) != len(files):
        raise UsageError(f"--name was given {len(names)} times for {len(files)} files")
    called = dict(zip(names or [file.stem for file in files], files, strict=True))
    if len(called) < len(files):
        raise UsageError("several files have one name; give each its --name")
    return called


def _check_outputs(items: Path | None, plot: Path | None, report: Path | None) -> None:
    from sdgen.benchmark.items import check_items
    from sdgen.benchmark.plot import check_plot
    from sdgen.dataset.output_file import check_output

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


def _echo(
    scores: Mapping[str, Evaluation],
    compared: Sequence[Comparison],
    rates: Mapping[str, BaseRates],
) -> None:
    """The tables."""
    from rich.table import Table

    from sdgen.benchmark.tables import ROWS, in_words, p_in_words
    from sdgen.cli.table import echo_table

    several = len(scores) > 1
    columns = list(scores) if several else ["mean ± se", "95 % interval"]
    table = Table("score", *columns, "over")
    for title, over, found in _rows(list(scores.values())):
        if title is None:
            table.add_section()
            continue
        cells = [_shown(one) for one in found] if several else [_shown(found[0]), _ends(found[0])]
        table.add_row(title, *cells, f"{found[0].n} {over}".strip())
    echo_table(table)
    for one in compared:
        titles = {name: title for title, name in ROWS.items()}
        table = Table(f"{one.detector} less {one.baseline}", "difference", "p", "over")
        for name, difference in one.differences.items():
            p, over = p_in_words(difference.p), f"{difference.n} scenes"
            table.add_row(titles[name], in_words(difference), p, over)
        echo_table(table)
    if rates:
        first = next(iter(rates.values()))
        share = f"{100 * first.hazard_share:.3g} % of homes with a hazard"
        table = Table(share, *rates)
        for title, row in _rate_rows(first):
            table.add_row(title, *(row(one) for one in rates.values()))
        echo_table(table)


def _rows(found: Sequence[Evaluation]) -> Iterator[tuple[str | None, str, list[Score]]]:
    """Rows of the table: title, of what there are so many, scores; a title of None: a line."""
    from sdgen.benchmark.tables import CUTS, FIXED, MICRO, ROWS

    for title, name in ROWS.items():
        scores: list[Score] = [getattr(one, name) for one in found]
        if name in FIXED or any(one.n for one in scores):
            yield title, FIXED.get(name, ""), scores
    for title, key in MICRO.items():
        yield title, "", [one.micro[key] for one in found]
    for title, field in CUTS.items():
        keys = list(getattr(found[0], field))
        rows = [(key, [getattr(one, field)[key] for one in found]) for key in keys]
        if field != "recall_by_hazard":
            rows = [(key, scores) for key, scores in rows if any(one.n for one in scores)]
        if rows:
            yield None, "", []
        for key, scores in rows:
            over = "anomalies" if field.startswith("recall") else "lookalikes"
            short = "recall" if field == "recall_by_hazard" else title
            yield f"{short}, {key}", over, scores


def _rate_rows(first: BaseRates) -> Iterator[tuple[str, Any]]:
    """Rows of the table of base rates: a title, and what a detector's cell says."""
    from sdgen.benchmark.tables import in_words

    yield "recall of all that was said", lambda one: in_words(one.recall)
    yield "precision", lambda one: in_words(one.precision)
    yield "false alarms a home-day", lambda one: in_words(one.false_alarms_per_home_day)
    yield "unwanted a home-day", lambda one: in_words(one.unwanted_per_home_day)
    for level in first.at_recall:

        def cell(one: BaseRates, level: str = level) -> str:
            score = one.at_recall[level]
            return "never reached" if score.mean is None else in_words(score)

        yield f"false alarms a home-day at recall {level}", cell
    costs = {
        "detector": "cost a home-day",
        "best_threshold": "cost at its best threshold",
        "never": "cost of silence",
    }
    for key, title in costs.items():

        def cost(one: BaseRates, key: str = key) -> str:
            return in_words(one.cost_per_home_day[key])

        yield title, cost


def _shown(value: Score) -> str:
    if value.mean is None:
        return "-"
    return f"{value.mean:.3f}" + (f" ± {value.se:.3f}" if value.se is not None else "")


def _ends(value: Score) -> str:
    if value.low is None or value.high is None:
        return "-"
    return f"{value.low:.3f} to {value.high:.3f}"
