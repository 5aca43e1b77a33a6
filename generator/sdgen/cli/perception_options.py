"""Options of commands whose detectors may be shown less than all of a scene graph."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import wraps
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

import click

from sdgen.errors import UsageError

if TYPE_CHECKING:
    from sdgen.dataset import Dataset
    from sdgen.dataset.graph_views import GraphView

R = TypeVar("R")

#: As ``sdgen.dataset.graph_views`` has them, which is loaded only when a data set is.
VIEWS = ("full", "neutral", "perceived")
_SHARE = click.FloatRange(0.0, 1.0)
_OPTIONS = (
    click.option(
        "--graph-view",
        type=click.Choice(VIEWS),
        default="full",
        show_default=True,
        help="full: all of graph.json. neutral: no states, no tags. perceived: what can be made "
        "out from depth, masks and camera poses.",
    ),
    click.option(
        "--missed",
        type=_SHARE,
        metavar="SHARE",
        default=0.0,
        help="Of a perceived graph: the share of objects that are overlooked.",
    ),
    click.option(
        "--confused",
        type=_SHARE,
        metavar="SHARE",
        default=0.0,
        help="Of a perceived graph: the share of objects that are taken for another class.",
    ),
    click.option(
        "--coarse",
        is_flag=True,
        help="Of a perceived graph: classes are their superclasses, as Food.",
    ),
    click.option("--no-states", is_flag=True, help="Of a perceived graph: it tells no states."),
)


@dataclass(frozen=True)
class Shown:
    """What detectors are shown of scenes, as it was asked for."""

    graph_view: GraphView = "full"
    missed: float = 0.0
    confused: float = 0.0
    coarse: bool = False
    no_states: bool = False

    def __post_init__(self) -> None:
        for name, share in (("--missed", self.missed), ("--confused", self.confused)):
            if not 0.0 <= share <= 1.0:  # nor is nan
                raise UsageError(f"{name}: {share} is not in the range 0 to 1")
        noise = self.missed or self.confused or self.coarse or self.no_states
        if noise and self.graph_view != "perceived":
            raise UsageError(
                "--missed, --confused, --coarse and --no-states are of a perceived graph: add "
                "--graph-view perceived"
            )

    def open(self, path: Path, **how: Any) -> Dataset:
        """The data set at ``path``, shown so; ``how`` as ``sdgen.Dataset`` has it."""
        from sdgen.dataset import Dataset
        from sdgen.perception import Perception

        perception = Perception(
            missed=self.missed,
            confused=self.confused,
            coarse=self.coarse,
            states=not self.no_states,
        )
        return Dataset(path, graph_view=self.graph_view, perception=perception, **how)


def shown_options(command: Callable[..., R]) -> Callable[..., R]:
    """Give a command ``--graph-view`` and how badly is perceived; it is handed all of that as one
    keyword, ``shown``, whose ``open(path, split=...)`` is the data set."""

    @wraps(command)
    def run(
        *args: Any,
        graph_view: GraphView,
        missed: float,
        confused: float,
        coarse: bool,
        no_states: bool,
        **more: Any,
    ) -> R:
        shown = Shown(graph_view, missed, confused, coarse, no_states)
        return command(*args, shown=shown, **more)

    for option in reversed(_OPTIONS):
        run = option(run)
    return run
