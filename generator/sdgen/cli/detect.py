"""``sdgen detect``: run a detector over a data set."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from sdgen.cli.asking_options import asking_options, given
from sdgen.cli.perception_options import Shown, shown_options
from sdgen.cli.quiet import QUIET, hint
from sdgen.errors import UsageError

if TYPE_CHECKING:
    from sdgen.dataset import Dataset
    from sdgen.detectors import Detector

#: Those that need no model of anybody's.
PLAIN = ("rules", "never", "always", "chance")
#: Those that ask one: the paper's seven, and one with pictures.
ASKING = (
    "object-list",
    "scene-description",
    "sg",
    "e-sg",
    "sg-c",
    "e-sg-c",
    "cot-sg-c",
    "views",
)
METHODS = (*PLAIN, *ASKING)


@click.command(short_help="Run a detector over a data set.")
@click.argument("dataset", type=click.Path(path_type=Path), metavar="DATASET")
@click.option(
    "--method",
    type=click.Choice(METHODS),
    help="rules: the catalogue's predicates over the files. never, always, chance: what they say. "
    "The others ask a language model (--model).",
)
@click.option(
    "--trained",
    type=click.Path(path_type=Path),
    metavar="FOLDER",
    help="A detector of your own training, in place of --method.",
)
@click.option(
    "-o",
    "--out",
    "--output",
    "output",
    type=click.Path(path_type=Path, dir_okay=False),
    help="Predictions file to write; - is standard output.",
)
@click.option("--split", help="Only the scenes of train, val or test.")
@click.option("--twins", is_flag=True, help="Also the benign twins, to tell pairs apart.")
@click.option(
    "--threshold",
    type=click.FloatRange(0.0, 1.0),
    metavar="T",
    help="Of --trained: report what it is at least so sure of [default: as it was trained].",
)
@shown_options
@asking_options
@QUIET
def detect(
    dataset: Path,
    method: str | None,
    trained: Path | None,
    output: Path | None,
    split: str | None,
    twins: bool,
    threshold: float | None,
    shown: Shown,
    **asking: Any,
) -> None:
    """Run a detector over a data set and write its predictions.

    Methods that ask a language model want --model and any OpenAI-compatible endpoint, with its key
    in OPENAI_API_KEY (any word, where it wants none). Beside the predictions they write how it
    went, FILE.account.json, and keep the answers in FILE.cache: the same command asks only what
    has no answer yet. Exit code 3: some scenes could not be asked.

    \b
    Example: sdgen detect output/sdgen-n12-s7 --method rules -o predictions.jsonl
    Example: sdgen detect homes --method cot-sg-c --model MODEL --estimate
    Example: sdgen detect homes --method cot-sg-c --model MODEL -o cot.jsonl
    """
    from sdgen.cli.bar import bar
    from sdgen.cli.scoring import scoring
    from sdgen.dataset.output_file import check_output, refuse_mixed

    context = click.get_current_context()
    if method is None and trained is None:
        raise _missing(context, "method")
    if method is not None and trained is not None:
        raise UsageError("--method and --trained: name one of them")
    if threshold is not None and trained is None:
        raise UsageError("--threshold goes with --trained")
    estimate_only = asking["estimate_only"]
    if output is None and not estimate_only:
        raise _missing(context, "output")
    if method not in ASKING and (unused := given(context)):
        raise UsageError(f"{unused[0]} is for methods that ask a language model: {_listed()}")
    if method in ASKING:
        from sdgen.cli.detect_asking import Asking, detect_asking

        wanted = Asking(**asking)
        wanted.check(output)  # before the work
        data = shown.open(dataset, split=split)
        detect_asking(data, str(method), output, twins, wanted)
        return
    from sdgen.benchmark import detect as run
    from sdgen.benchmark import prediction_bytes, write_predictions
    from sdgen.detectors.account import drop_account

    assert output is not None
    to_stdout = output == Path("-")
    if not to_stdout:
        check_output(output)  # before the work
        refuse_mixed([output], [trained] if trained else [])
    data = shown.open(dataset, split=split)
    detector = _trained(trained, threshold, data) if trained else str(method)
    with bar("detecting") as on_scene:
        found = run(data, detector, on_scene, twins)
    if to_stdout:
        click.echo(prediction_bytes(found), nl=False)
        return
    write_predictions(output, found)
    drop_account(output)
    reports = sum(len(said) for said in found.values())
    hint(f"{output}: {reports} reports in {len(found)} scenes")
    hint(f"score them: {scoring(data, output)}")


def _missing(context: click.Context, name: str) -> click.MissingParameter:
    """What click says of an option that is required."""
    param = next(param for param in context.command.params if param.name == name)
    return click.MissingParameter(ctx=context, param=param)


def _listed() -> str:
    return ", ".join(ASKING)


def _trained(folder: Path, threshold: float | None, data: Dataset) -> Detector:
    """A trained detector from its folder. Raises InputError."""
    from sdgen.detectors.trained import load_trained

    model = load_trained(folder, threshold)
    if model.graph_view != data.graph_view:
        learned, shown = model.graph_view, data.graph_view
        hint(f"{folder} learned from {learned} graphs, here it sees {shown} ones (--graph-view)")
    return model
