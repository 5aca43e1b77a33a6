"""The tables of detectors on a data set: the paper's two, rows that need no key, what perception
costs, and what detectors are worth where most homes are clean."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import cache
from typing import NamedTuple

import jinja2

from sdgen.benchmark.base_rates import BaseRates
from sdgen.benchmark.metrics import Evaluation, Score
from sdgen.benchmark.paper import METHODS, MODELS, REAL_ROBOT, Reported
from sdgen.dataset import Dataset
from sdgen.dataset.graph_views import GraphView
from sdgen.errors import one_line
from sdgen.options import command_of
from sdgen.scene import Record

#: The paper's own method.
BEST = "cot-sg-c"


class Row(Record):
    """One detector, what it was shown (``graph_view`` None: its author knows), and how it did.

    ``household``: how who lives there enters (``own``: by the catalogue's rule; ``filter``: after
    the labels; ``prompt``; ``none``). ``model`` is that of a prompt method; ``note`` says what else
    a reader must know.
    """

    detector: str
    graph_view: GraphView | None
    household: str
    model: str | None = None
    note: str = ""
    evaluation: Evaluation
    base_rates: BaseRates | None = None


class Board(Record):
    """A leaderboard: the scenes it is of, the share of homes with a hazard that its table of clean
    homes takes, and its rows."""

    command: str
    split: str
    scenes: int
    anomalies: int
    twins: int
    base_rate: float
    catalogue_sha256: str
    versions: dict[str, str]
    rows: tuple[Row, ...]


def board(data: Dataset, rows: Iterable[Row], base_rate: float) -> Board:
    """The leaderboard of a data set (one split of it, or all)."""
    return Board(
        command=command_of(data.info.options),
        split=data.split or "all",
        scenes=len(data),
        anomalies=sum(entry.anomalies for entry in data.shown),
        twins=sum(item.twin is not None for item in data),
        base_rate=base_rate,
        catalogue_sha256=data.info.catalogue_sha256,
        versions=dict(data.info.versions),
        rows=tuple(rows),
    )


class Beside(NamedTuple):
    """A row of the paper, and one of ours where there is one."""

    paper: Reported
    row: Row | None


class Drop(NamedTuple):
    """What one detector scores on the exact graph, and on what views let one make out of it."""

    title: str
    full: Evaluation
    perceived: Evaluation


def methods_beside(rows: Sequence[Row]) -> list[Beside]:
    """The paper's table of methods, each with our rows of that method on the full graph."""
    return [
        beside
        for method, paper in METHODS.items()
        for beside in _beside(paper, [row for row in _exact(rows) if row.detector == method])
    ]


def models_beside(rows: Sequence[Row]) -> list[Beside]:
    """The paper's table of models, each with our rows of its best method, and our other models."""
    ours = [row for row in _exact(rows) if row.detector == BEST]
    known = [
        beside
        for model, paper in MODELS.items()
        for beside in _beside(paper, [row for row in ours if _is(row, model)])
    ]
    others = [row for row in ours if not any(_is(row, model) for model in MODELS)]
    return known + [Beside(Reported(str(row.model), None, None), row) for row in others]


def drops(rows: Sequence[Row]) -> list[Drop]:
    """Detectors that were run on the full and on the perceived graph."""
    by_view = {
        view: {title(row): row for row in rows if row.graph_view == view}
        for view in ("full", "perceived")
    }
    return [
        Drop(name, row.evaluation, by_view["perceived"][name].evaluation)
        for name, row in by_view["full"].items()
        if name in by_view["perceived"]
    ]


def title(row: Row) -> str:
    """How tables call a row, its graph view apart."""
    return f"{row.detector}, {row.model}" if row.model else row.detector


def _exact(rows: Sequence[Row]) -> list[Row]:
    return [row for row in rows if row.graph_view == "full"]


def _beside(paper: Reported, rows: Sequence[Row]) -> list[Beside]:
    return [Beside(paper, row) for row in rows] or [Beside(paper, None)]


def _is(row: Row, model: str) -> bool:
    """True for a model of this name, whoever serves it (``openai/gpt-4``, ``gpt-4-0613``)."""
    said = (row.model or "").lower().split("/")[-1]
    return said == model or (said.startswith(f"{model}-") and said[len(model) + 1 :][:1].isdigit())


def markdown(made: Board) -> str:
    """A leaderboard as a page of Markdown."""
    template = _environment().get_template("leaderboard.md.j2")
    return template.render(
        board=made,
        methods=methods_beside(made.rows),
        models=models_beside(made.rows),
        keyless=[row for row in made.rows if row.detector not in METHODS],
        drops=drops(made.rows),
        robot=REAL_ROBOT,
    )


def _percent(score: Score | None) -> str:
    """A share as the paper writes it, with the 95 % interval."""
    if score is None or score.mean is None:
        return "–"
    mean = f"{100 * score.mean:.1f}"
    if score.low is None or score.high is None:
        return mean
    return f"{mean} ({100 * score.low:.1f} to {100 * score.high:.1f})"


def _number(score: Score | float | None) -> str:
    value = score.mean if isinstance(score, Score) else score
    return "–" if value is None else f"{value:.2f}"


def _cell(text: object) -> str:
    """Text of a stranger in a cell of a table."""
    return one_line(str(text)).replace("|", "\\|").replace("<", "&lt;")


@cache
def _environment() -> jinja2.Environment:
    made = jinja2.Environment(
        loader=jinja2.PackageLoader("sdgen.benchmark", "templates"),
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        autoescape=False,
    )
    made.filters |= {"view": lambda row: row.graph_view or "not said"}
    made.filters |= {"percent": _percent, "number": _number, "cell": _cell, "called": title}
    return made
