"""Recall by hazard and operating curves as one picture: an SVG, by coordinates reckoned here."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from jinja2 import Environment, PackageLoader, StrictUndefined

from sdgen.benchmark.base_rates import BaseRates
from sdgen.benchmark.metrics import Evaluation
from sdgen.dataset.output_file import write_output
from sdgen.errors import UsageError

#: Units of the drawing: a panel, what names take of it, a row, and of it a detector's part.
WIDTH, LABEL, GAP, LANE = 480, 168, 10, 11
#: The field of the operating curve; what zero takes at its left, decades that are shown at most.
LEFT, HIGH, ZERO, DECADES = 52, 300, 34, 4
#: Space for the title, and below for the axis.
HEAD, FOOT = 34, 44
#: Colours there are; a further detector has the first one again.
COLOURS = 6


@dataclass(frozen=True)
class Panel:
    """A drawing of its own: size, title, and what the template draws."""

    kind: str
    title: str
    height: float
    names: tuple[tuple[str, int], ...]
    x_ticks: tuple[tuple[float, str], ...]
    y_ticks: tuple[tuple[float, str], ...]
    marks: tuple[Mark, ...]
    left: float
    right: float
    low: float
    x_title: str
    width: float = WIDTH


@dataclass(frozen=True)
class Mark:
    """A dot of a detector with its interval, or a line (``path``); ``text`` tells its numbers."""

    colour: int
    x: float
    y: float
    low: float | None
    high: float | None
    text: str
    path: str = ""


def recall_panel(found: Mapping[str, Evaluation]) -> Panel:
    """Recall by hazard, a dot and a 95 % interval for each detector."""
    counts: dict[str, int] = {}
    for one in found.values():
        for key, told in one.recall_by_hazard.items():
            counts[key] = max(told.n, counts.get(key, 0))
    hazards = [key for key, count in counts.items() if count]
    named = _named(found)
    top = HEAD + _legend(named)
    row = LANE * len(found) + GAP
    right = WIDTH - 20.0

    def x(value: float) -> float:
        return round(LABEL + value * (right - LABEL), 1)

    marks = []
    for k, (name, one) in enumerate(found.items()):
        for j, hazard in enumerate(hazards):
            score = one.recall_by_hazard.get(hazard)
            if score is None or score.mean is None:
                continue
            bounded = score.low is not None and score.high is not None
            text = f"{name}, {_plain(hazard)}: {score.mean:.3f}, n {score.n}"
            marks.append(
                Mark(
                    colour=k % COLOURS,
                    x=x(score.mean),
                    y=top + j * row + GAP / 2 + (k + 0.5) * LANE,
                    low=x(score.low) if bounded and score.low is not None else None,
                    high=x(score.high) if bounded and score.high is not None else None,
                    text=text,
                )
            )
    low = top + row * len(hazards)
    return Panel(
        kind="rows",
        title="Recall by hazard (anomalies), with 95 % intervals",
        height=low + FOOT,
        names=named,
        x_ticks=tuple((x(k / 5), f"{k / 5:g}") for k in range(6)),
        y_ticks=tuple(
            (top + (j + 0.5) * row, f"{_plain(h)} ({counts[h]})") for j, h in enumerate(hazards)
        ),
        marks=tuple(marks),
        left=LABEL,
        right=right,
        low=low,
        x_title="share of its anomalies that were detected",
    )


def curve_panel(found: Mapping[str, BaseRates]) -> Panel:
    """Recall against false alarms a home-day, a step line for each detector that is sure of
    something by degrees, and a dot at all it says."""
    named = _named(found)
    top = HEAD + _legend(named)
    right, low = WIDTH - 20.0, top + float(HIGH)
    rates = [p.false_alarms_per_home_day for one in found.values() for p in one.curve]
    positive = [rate for rate in rates if rate > 0]
    last = math.ceil(math.log10(max(positive, default=1.0)) + 1e-9)
    first = max(math.floor(math.log10(min(positive, default=0.1))), last - DECADES)
    first = min(first, last - 1)
    zero = LEFT + 8.0

    def x(rate: float) -> float:
        if rate <= 0:
            return zero
        part = (math.log10(rate) - first) / (last - first)
        return round(LEFT + ZERO + max(part, 0.0) * (right - LEFT - ZERO), 1)

    def y(recall: float) -> float:
        return round(low - recall * (low - top), 1)

    marks = []
    for k, (name, one) in enumerate(found.items()):
        end = one.curve[-1]
        text = (
            f"{name}: recall {end.recall:.3f}, "
            f"{end.false_alarms_per_home_day:.3g} false alarms a home-day"
        )
        path = ""
        if one.scored:
            steps = [f"M {zero} {y(0)}"]
            for point in one.curve:
                steps.append(f"H {x(point.false_alarms_per_home_day)} V {y(point.recall)}")
            path = " ".join(steps)
        px, py = x(end.false_alarms_per_home_day), y(end.recall)
        marks.append(Mark(k % COLOURS, px, py, None, None, text, path))
    setting = next(iter(found.values()), None)
    where = "false alarms a home-day"
    if setting is not None:
        where += f", {100 * setting.hazard_share:.3g} % of homes with a hazard, log scale"
    ticks = [(zero, "0"), *((x(10.0**k), f"{10.0**k:g}") for k in range(first, last + 1))]
    return Panel(
        kind="field",
        title="Recall (upwards) against false alarms",
        height=low + FOOT,
        names=named,
        x_ticks=tuple(ticks),
        y_ticks=tuple((y(k / 5), f"{k / 5:g}") for k in range(6)),
        marks=tuple(marks),
        left=LEFT,
        right=right,
        low=low,
        x_title=where,
    )


def _named(found: Mapping[str, object]) -> tuple[tuple[str, int], ...]:
    """Detectors with their colours; none where there is but one."""
    names = [(name[:24], k % COLOURS) for k, name in enumerate(found)]
    return tuple(names) if len(names) > 1 else ()


def _legend(named: Sequence[object]) -> int:
    """The height of the names of detectors, three beside each other."""
    return 4 + 14 * math.ceil(len(named) / 3) if named else 0


def _plain(name: str) -> str:
    return name.replace("_", " ")


def svg(panels: Sequence[Panel]) -> str:
    """Panels one below the other, as SVG text."""
    tops = [sum(panel.height for panel in panels[:k]) for k in range(len(panels))]
    environment = Environment(
        loader=PackageLoader("sdgen.benchmark", "templates"),
        undefined=StrictUndefined,
        autoescape=True,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    return environment.get_template("plot.svg.j2").render(
        panels=list(zip(tops, panels, strict=True)),
        width=WIDTH,
        height=sum(panel.height for panel in panels),
    )


def check_plot(path: Path) -> None:
    """Raises UsageError for a name that is no ``.svg``."""
    if path.suffix != ".svg":
        raise UsageError(f"{path}: the picture is an SVG; name it .svg")


def write_plot(
    path: Path, evaluations: Mapping[str, Evaluation], rates: Mapping[str, BaseRates]
) -> None:
    """Write the picture, whole or not at all; without ``rates`` of recall alone. Raises UsageError
    for another ending, SdgenError where ``output_file`` does."""
    check_plot(path)
    panels = [recall_panel(evaluations)] + ([curve_panel(rates)] if rates else [])
    write_output(path, svg(panels).encode("utf-8"))
