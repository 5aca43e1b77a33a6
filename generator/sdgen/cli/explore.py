"""``sdgen explore``: walk through a home, or have it explored."""

from __future__ import annotations

import math
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import click

from sdgen.cli.params import parsed, size
from sdgen.cli.quiet import QUIET
from sdgen.cli.shared_options import ASSETS, RENDERER
from sdgen.errors import UsageError

if TYPE_CHECKING:
    from sdgen.detectors.run import Detector

#: As ``sdgen.agent.explorers`` and ``sdgen.detectors`` have them, loaded only when they are used.
EXPLORERS = ("random", "rooms", "frontier", "planner")
METHODS = ("rules", "never", "always", "chance")
#: As ``Lens`` has it.
LARGEST = 2048


@click.command(short_help="Walk through a home, or have it explored.")
@click.argument("dataset", type=click.Path(path_type=Path), metavar="DATASET")
@click.argument("scene", required=False, metavar="[SCENE]")
@click.option(
    "--do",
    "script",
    metavar="MOVES",
    help="What to do, such as 'forward 4, turn_left 3, scan', or @FILE with a move a line.",
)
@click.option(
    "--explorer",
    "explorers",
    type=click.Choice(EXPLORERS),
    multiple=True,
    help="Have it explored: random walk, room by room, nearest frontier, or a planner that knows "
    "from where the anomalies can be seen. Repeatable without SCENE [default there: all four].",
)
@click.option(
    "--method",
    "methods",
    type=click.Choice(METHODS),
    multiple=True,
    help="The detector that says what the explorer's pictures show [default: rules].",
)
@click.option(
    "--trained",
    "models",
    type=click.Path(path_type=Path),
    metavar="FOLDER",
    multiple=True,
    help="A detector of your own training, in its place; repeatable.",
)
@click.option(
    "-o",
    "--out",
    "--output",
    "output",
    type=click.Path(path_type=Path),
    help="Folder for the trajectory: pictures, poses, a video.",
)
@click.option(
    "--video",
    type=click.Choice(["gif", "mp4", "none"]),
    default="gif",
    show_default=True,
    help="The video in that folder; mp4 takes pip install 'sdgen[video]'.",
)
@click.option(
    "--lerobot",
    type=click.Path(path_type=Path),
    metavar="FOLDER",
    help="Also write the walk as a LeRobot data set (pip install 'sdgen[lerobot]').",
)
@click.option(
    "--plan",
    "plan_file",
    type=click.Path(path_type=Path, dir_okay=False),
    metavar="FILE.png",
    help="Also draw the walk, and from where the anomalies can be seen, on the plan.",
)
@click.option("--size", "pixels", metavar="WxH", callback=parsed(size), default="128x128",
              show_default=True, help="Pixels of the agent's camera.")  # fmt: skip
@click.option(
    "--fov",
    type=click.FloatRange(10.0, 150.0),
    default=90.0,
    show_default=True,
    metavar="DEGREES",
    help="Its horizontal field of view.",
)
@click.option(
    "--eye-height",
    type=click.FloatRange(0.1, 2.2),
    default=1.2,
    show_default=True,
    metavar="METRES",
    help="Its height above the floor.",
)
@click.option(
    "--pitch",
    type=click.FloatRange(-60.0, 60.0),
    default=0.0,
    metavar="DEGREES",
    help="Its pitch at the start; up is positive [default: 0].",
)
@click.option(
    "--start",
    type=click.Choice(["scene", "random"]),
    default="scene",
    show_default=True,
    help="Where the agent begins: where the scene says, or anywhere on the free floor.",
)
@click.option("--seed", type=click.IntRange(min=0), default=0, show_default=True,
              help="Of a random start and a random walk.")  # fmt: skip
@click.option(
    "--max-steps",
    type=click.IntRange(1, 1_000_000),
    default=1000,
    show_default=True,
    metavar="N",
    help="Steps after which it ends.",
)
@click.option("--split", help="Without SCENE: only the scenes of train, val or test.")
@click.option(
    "--limit", type=click.IntRange(min=1), metavar="N", help="Without SCENE: only the first N."
)
@ASSETS
@RENDERER
@QUIET
@click.option("--json", "as_json", is_flag=True, help="Print one JSON object.")
def explore(
    dataset: Path,
    scene: str | None,
    script: str | None,
    explorers: tuple[str, ...],
    methods: tuple[str, ...],
    models: tuple[Path, ...],
    output: Path | None,
    video: Literal["gif", "mp4", "none"],
    lerobot: Path | None,
    plan_file: Path | None,
    pixels: tuple[int, int],
    fov: float,
    eye_height: float,
    pitch: float,
    start: Literal["scene", "random"],
    seed: int,
    max_steps: int,
    split: str | None,
    limit: int | None,
    assets: tuple[Path, ...],
    renderer: str,
    as_json: bool,
) -> None:
    """Walk through a home of a data set, or have it explored.

    With SCENE (its id, such as 000003) by keys in a terminal, by --do or by an --explorer; it ends
    with the scores of the walk: what was found, how far was walked, and why the rest was missed.
    Without SCENE, explorers and detectors are compared over all homes.

    \b
    Example: sdgen explore output/sdgen-n12-s7 000003
    Example: sdgen explore homes 3 --do "go_to 17, scan, report 17 unsafe now" -o walk
    Example: sdgen explore homes 3 --explorer rooms -o walk --plan walk.png
    Example: sdgen explore homes --explorer rooms --explorer planner --limit 50
    """
    from sdgen.agent.options import AgentOptions
    from sdgen.cameras.lens import Lens
    from sdgen.dataset import Dataset
    from sdgen.library import load_library

    alone = scene is not None
    _check(alone, script, explorers, methods, models, output, lerobot, plan_file, split, limit)
    if max(pixels) > LARGEST:
        raise UsageError(f"--size: an agent's camera has at most {LARGEST} pixels along a side")
    for name, value in (("fov", fov), ("eye-height", eye_height), ("pitch", pitch)):
        if not math.isfinite(value):
            raise UsageError(f"--{name} {value}: no number")
    options = AgentOptions(
        camera=Lens(width=pixels[0], height=pixels[1], fov_x_deg=fov, height_m=eye_height),
        pitch_deg=pitch,
        start=start,
        max_steps=max_steps,
    )
    data = Dataset(dataset, split=split, graph_view="perceived")
    detectors = _detectors(methods, models)
    library = load_library(assets)
    if scene is None:
        from sdgen.cli.explore_table import explore_table

        names = explorers or EXPLORERS
        explore_table(data, library, names, detectors, options, seed, renderer, limit, as_json)
        return
    from sdgen.cli.explore_one import Walk, explore_one

    item = data.scene(_scene_id(scene))
    if script is None and not explorers and not (sys.stdin.isatty() and sys.stdout.isatty()):
        raise UsageError("no terminal to take keys from: say --do MOVES or --explorer NAME")
    walk = Walk(script, explorers[0] if explorers else None, detectors, output, video, lerobot,
                plan_file)  # fmt: skip
    explore_one(data, item, library, walk, options, seed, renderer, as_json)


def _check(
    alone: bool,
    script: str | None,
    explorers: tuple[str, ...],
    methods: tuple[str, ...],
    models: tuple[Path, ...],
    output: Path | None,
    lerobot: Path | None,
    plan_file: Path | None,
    split: str | None,
    limit: int | None,
) -> None:
    """Raises UsageError for options that do not go together, and for outputs that cannot be."""
    from sdgen.dataset.output_file import check_output, refuse_mixed
    from sdgen.dataset.output_folder import check_output_folder

    context = click.get_current_context()
    if alone:
        for name, given in (("split", split), ("limit", limit)):
            if given is not None:
                raise UsageError(f"--{name} goes without a SCENE")
        if len(explorers) > 1:
            raise UsageError("--explorer: one, for one scene")
        if script is not None and explorers:
            raise UsageError("--do and --explorer: name one of them")
        if len(methods) + len(models) > 1:
            raise UsageError("--method and --trained: one of them, for one scene")
        if (methods or models) and not explorers:
            raise UsageError("--method and --trained go with --explorer")
        source = context.get_parameter_source("video")
        if source is click.core.ParameterSource.COMMANDLINE and output is None:
            raise UsageError("--video goes with --out")
    else:
        names = ("script", "output", "lerobot", "plan_file", "video")
        flags = ("--do", "--out", "--lerobot", "--plan", "--video")
        for name, flag in zip(names, flags, strict=True):
            source = context.get_parameter_source(name)
            if source is click.core.ParameterSource.COMMANDLINE:
                raise UsageError(f"{flag} goes with a SCENE")
    refuse_mixed([path for path in (output, lerobot, plan_file) if path is not None], models)
    if output is not None:
        check_output_folder(output)
    if lerobot is not None:
        check_output_folder(lerobot)
    if plan_file is not None:
        if plan_file.suffix.lower() != ".png":
            raise UsageError(f"--plan {plan_file}: a .png is written")
        check_output(plan_file)


def _scene_id(text: str) -> str:
    """``3`` is scene 000003."""
    return f"{int(text):06d}" if text.isascii() and text.isdigit() and len(text) < 6 else text


def _detectors(methods: tuple[str, ...], models: tuple[Path, ...]) -> dict[str, Detector]:
    from sdgen.detectors import DETECTORS
    from sdgen.detectors.trained import load_trained

    names = methods or (() if models else ("rules",))
    found: dict[str, Any] = {name: DETECTORS[name] for name in names}
    for folder in models:
        if folder.name in found:
            raise UsageError(f"two detectors are called {folder.name}")
        found[folder.name] = load_trained(folder)
    return found
