"""Options of ``sdgen detect`` for methods that ask a language model."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import click

from sdgen.cli.params import parsed


def temperature(text: str) -> float | str:
    """``0.7``, or ``none``: not sent, for models that take none. ValueError for anything else."""
    if text == "none":
        return text
    try:
        value = float(text)
    except ValueError:
        raise ValueError("is no number, nor none") from None
    if not 0.0 <= value <= 2.0:
        raise ValueError("is out of range: 0 to 2")
    return value


#: Name of the parameter -> its option.
_OPTIONS: dict[str, Callable[[Any], Any]] = {
    "models": click.option(
        "--model",
        "models",
        metavar="NAME",
        multiple=True,
        help="The model to ask; repeatable, with {model} in the name of the output.",
    ),
    "base_url": click.option(
        "--base-url",
        metavar="URL",
        envvar="OPENAI_BASE_URL",
        help="An OpenAI-compatible endpoint [env: OPENAI_BASE_URL].",
    ),
    "household": click.option(
        "--household",
        type=click.Choice(["filter", "prompt", "none"]),
        default="filter",
        show_default=True,
        help="Who lives there: a filter after the labels, in the prompt, or not at all.",
    ),
    "batch": click.option(
        "--batch",
        type=click.IntRange(0, 10_000),
        metavar="N",
        help="Strings a question [default: 60]; 0: all of a scene at once.",
    ),
    "plain_names": click.option(
        "--plain-names", is_flag=True, help="Names without the states that the graph shows."
    ),
    "relations": click.option(
        "--relations",
        type=click.Choice(["paper", "more"]),
        default="paper",
        show_default=True,
        help="more: with the graph's tags and further relations.",
    ),
    "parser": click.option(
        "--parser",
        metavar="NAME",
        help="A second model that makes one word of each line of an answer.",
    ),
    "per": click.option(
        "--per",
        type=click.Choice(["room", "view"]),
        default="room",
        show_default=True,
        help="views: a question shows all views of a room, or one view.",
    ),
    "with_graph": click.option(
        "--with-graph/--without-graph",
        default=False,
        show_default=True,
        help="views: the strings of the graph beside the pictures.",
    ),
    "boxes": click.option(
        "--boxes",
        type=click.Choice(["pixels", "thousandths"]),
        default="pixels",
        show_default=True,
        help="views: what the model is to measure in.",
    ),
    "picture_width": click.option(
        "--picture-width",
        type=click.IntRange(16, 4096),
        metavar="PX",
        default=512,
        show_default=True,
        help="views: pictures are sent no wider than this.",
    ),
    "temperature": click.option(
        "--temperature",
        metavar="T",
        default="0",
        show_default=True,
        callback=parsed(temperature),
        help="0 to 2, or none: not sent.",
    ),
    "max_tokens": click.option(
        "--max-tokens",
        type=click.IntRange(1, 1_000_000),
        metavar="N",
        help="Longest answer [default: as the endpoint has it].",
    ),
    "timeout": click.option(
        "--timeout",
        type=click.FloatRange(0.1, 3600.0),
        metavar="S",
        default=120.0,
        show_default=True,
        help="Seconds that an answer may take.",
    ),
    "concurrency": click.option(
        "--concurrency",
        type=click.IntRange(1, 256),
        metavar="N",
        default=4,
        show_default=True,
        help="Scenes asked about at the same time.",
    ),
    "retries": click.option(
        "--retries",
        type=click.IntRange(0, 100),
        metavar="N",
        default=5,
        show_default=True,
        help="Further tries of a question that fails in passing, with growing waits.",
    ),
    "longest_wait": click.option(
        "--longest-wait",
        type=click.FloatRange(0.0, 3600.0),
        metavar="S",
        default=60.0,
        show_default=True,
        help="Seconds between two tries at most, whatever the endpoint asks for.",
    ),
    "price_in": click.option(
        "--price-in",
        type=click.FloatRange(min=0.0),
        metavar="P",
        help="Price of a million tokens asked.",
    ),
    "price_out": click.option(
        "--price-out",
        type=click.FloatRange(min=0.0),
        metavar="P",
        help="Price of a million tokens answered.",
    ),
    "estimate_only": click.option(
        "--estimate", "estimate_only", is_flag=True, help="Say what it would take, and ask nothing."
    ),
    "cache": click.option(
        "--cache",
        type=click.Path(path_type=Path, file_okay=False),
        metavar="FOLDER",
        help="Where answers are kept [default: beside the output].",
    ),
    "replay": click.option(
        "--replay", is_flag=True, help="Only answers that are kept; nobody is asked."
    ),
}


def asking_options(command: Callable[..., Any]) -> Callable[..., Any]:
    """A command with all of them."""
    for option in reversed(_OPTIONS.values()):
        command = option(command)
    return command


def given(context: click.Context) -> list[str]:
    """Those of them that the command line names, as it does."""
    by_hand = click.core.ParameterSource.COMMANDLINE
    return [
        parameter.opts[0]
        for parameter in context.command.params
        if parameter.name in _OPTIONS
        and context.get_parameter_source(parameter.name or "") is by_hand
    ]
