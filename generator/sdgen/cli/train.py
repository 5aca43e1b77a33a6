"""``sdgen train``: the offline baselines."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click

from sdgen.cli.quiet import QUIET, hint

if TYPE_CHECKING:
    from sdgen.dataset.graph_views import GraphView
    from sdgen.detectors.model_file import Kind

#: As ``sdgen.detectors.training`` has them.
KINDS: tuple[Kind, ...] = ("prior", "objects", "description", "graph", "image", "cnn")


@click.command(short_help="Train the offline baselines.")
@click.argument("dataset", type=click.Path(path_type=Path), metavar="DATASET")
@click.option(
    "--kind",
    "asked",
    type=click.Choice([*KINDS, "all"]),
    multiple=True,
    required=True,
    help="What it sees: categories alone; the object list; words; the graph; pictures (trees, or a "
    "net with torch). Repeatable.",
)
@click.option(
    "-o",
    "--out",
    "--output",
    "output",
    type=click.Path(path_type=Path, file_okay=False),
    required=True,
    help="Folder to write; of several kinds, each one's folder is in it.",
)
@click.option(
    "--graph-view",
    type=click.Choice(["full", "neutral", "perceived"]),
    default="full",
    show_default=True,
    help="What it is shown of each scene graph.",
)
@click.option(
    "--seed",
    type=click.IntRange(min=0, max=2**31 - 1),
    default=0,
    show_default=True,
    help="Seed of what is drawn in training.",
)
@click.option("--json", "as_json", is_flag=True, help="Print one array of objects, one a detector.")
@QUIET
def train(
    dataset: Path,
    asked: tuple[str, ...],
    output: Path,
    graph_view: GraphView,
    seed: int,
    as_json: bool,
) -> None:
    """Train detectors on the train split, with the threshold that is best on val.

    A detector's folder has its numbers (model.npz), what they mean (model.json) and a card.

    Example: sdgen train output/sdgen-n1000-s7 --kind graph -o graph-detector
    """
    import json

    from sdgen.cli.steps import steps
    from sdgen.dataset import Dataset
    from sdgen.dataset.output_folder import check_output_folder
    from sdgen.detectors.model_file import RECORD
    from sdgen.detectors.training import Lessons, check_needs
    from sdgen.detectors.training import train as run
    from sdgen.errors import SdgenError

    kinds = tuple(k for k in KINDS if k in asked or "all" in asked)
    places = {kind: output if len(kinds) == 1 else output / kind for kind in kinds}
    for place in places.values():
        check_output_folder(place)  # before the work
    if len(kinds) > 1 and (output / RECORD).exists():
        raise SdgenError(f"{output}: holds a model; name another folder for several")
    data = Dataset(dataset, graph_view=graph_view)
    check_needs(data, kinds)
    said = []
    with steps() as told:
        lessons = Lessons(data, seed, told)
        for kind in kinds:
            model = run(lessons, kind, places[kind])
            said.append(
                {
                    "kind": kind,
                    "out": str(places[kind]),
                    "threshold": model.threshold,
                    "val": model.val.model_dump(),
                    "examples": model.examples,
                }
            )
            if not as_json:
                score = "-" if model.val.f1 is None else f"{model.val.f1:.3f}"
                click.echo(f"{places[kind]}: {kind}, F1 on {model.val.split} {score}")
    if as_json:
        click.echo(json.dumps(said, indent=1))
        return
    last = places[kinds[-1]]
    view = "" if graph_view == "full" else f" --graph-view {graph_view}"
    hint(f"use it: sdgen detect {dataset} --split test --trained {last}{view} -o predictions.jsonl")
