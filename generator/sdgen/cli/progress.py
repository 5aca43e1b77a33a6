"""What a person sees of a build: a bar on a terminal, plain lines elsewhere, a closing table."""

from __future__ import annotations

import time
from collections import Counter
from collections.abc import Iterator, Mapping
from contextlib import contextmanager

import click
from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn

from sdgen.cli.disk import human_bytes
from sdgen.engines.report import (
    BuildEvent,
    BuildReport,
    Note,
    OnEvent,
    SceneDone,
    SceneFailed,
)
from sdgen.rejection import Causes, causes_in_words
from sdgen.scene import cause_counts

#: Scenes made between two lines about the pace, where there is no bar.
LINES_BETWEEN = 20


@contextmanager
def watch(total: int, quiet: bool = False) -> Iterator[OnEvent]:
    """A callback that shows events of a build of ``total`` scenes, on stderr; ``quiet`` leaves
    only notes and failed scenes."""
    if quiet:
        yield _troubles
        return
    console = Console(stderr=True, highlight=False)
    if not console.is_terminal:
        yield _plain_lines(total)
        return
    columns = (
        TextColumn("scenes"),
        BarColumn(),
        MofNCompleteColumn(),
        TextColumn("{task.description}"),
    )
    with Progress(*columns, console=console) as progress:
        task = progress.add_task("", total=total)
        pace = _Pace(total)

        def show(event: BuildEvent) -> None:
            pace.saw(event)
            if isinstance(event, SceneDone):
                progress.update(task, advance=1, description=pace.text())
                return
            progress.console.print(_line(event), markup=False)
            if isinstance(event, SceneFailed):
                progress.advance(task)

        yield show


def _troubles(event: BuildEvent) -> None:
    if not isinstance(event, SceneDone):
        click.echo(_line(event), err=True)


def _plain_lines(total: int) -> OnEvent:
    pace = _Pace(total)

    def show(event: BuildEvent) -> None:
        pace.saw(event)
        if isinstance(event, Note):
            click.echo(event.text, err=True)
            return
        if isinstance(event, SceneDone) and event.resumed:
            return
        click.echo(f"{pace.done}/{total} {_line(event)}", err=True)
        if pace.made and pace.made % LINES_BETWEEN == 0:
            click.echo(pace.text(), err=True)

    return show


class _Pace:
    """How fast this run goes; scenes found whole from an earlier one do not count."""

    def __init__(self, total: int) -> None:
        self._total = total
        self._start = time.monotonic()
        self.done = 0
        self.made = 0

    def saw(self, event: BuildEvent) -> None:
        """Take in an event."""
        self.done += not isinstance(event, Note)
        self.made += not isinstance(event, Note) and not getattr(event, "resumed", False)

    def text(self) -> str:
        """``1234 homes/h, 25 min left``."""
        each = (time.monotonic() - self._start) / self.made if self.made else 0.0
        if each <= 0.0:
            return ""
        return f"{3600 / each:.0f} homes/h, {_span((self._total - self.done) * each)} left"


def _span(seconds: float) -> str:
    if seconds < 90:
        return f"{seconds:.0f} s"
    return f"{seconds / 60:.0f} min" if seconds < 5400 else f"{seconds / 3600:.1f} h"


def _line(event: BuildEvent) -> str:
    if isinstance(event, Note):
        return event.text
    if isinstance(event, SceneFailed):
        return (
            f"scene {event.scene_id} could not be made: {causes_in_words(event.causes) or 'none'}"
        )
    return f"scene {event.scene_id} in {event.seconds:.1f} s: {_hazards(event)}"


def _hazards(event: SceneDone) -> str:
    return ", ".join(event.hazards) or "no hazard"


def _counts(counts: Mapping[str, int]) -> str:
    pairs = sorted(counts.items(), key=lambda pair: (-pair[1], pair[0]))
    return ", ".join(f"{name} x{count}" for name, count in pairs) or "none"


def as_record(report: BuildReport) -> dict[str, object]:
    """The closing account for programs; numbers unrounded, memory in megabytes, causes counted."""
    return {
        "out": str(report.out),
        "requested": report.requested,
        "made": report.made,
        "resumed": report.resumed,
        "failed": {item.scene_id: _counted(item.causes) for item in report.failed},
        "frames": report.frames,
        "seconds": report.seconds,
        "homes_per_hour": report.homes_per_hour,
        "frames_per_second": report.frames_per_second,
        "peak_memory_mb": report.peak_memory_mb,
        "home_attempts": report.home_attempts,
        "rejections": _counted(report.rejections),
        "anomalies": report.anomalies,
        "scenes_by_anomalies": {str(key): n for key, n in report.anomaly_counts.items()},
        "renderer": report.renderer,
    }


def _counted(causes: Causes) -> list[dict[str, object]]:
    """Causes as ``dataset.json`` has them: in fields, none read back from words."""
    return [count.model_dump() for count in cause_counts(causes)]


def summary(report: BuildReport) -> str:
    """The closing table of a build, as plain text."""
    good = report.made + report.resumed
    rows = [
        ("scenes", f"{good} of {report.requested}" + _resumed(report)),
        ("homes/h", f"{report.homes_per_hour:.0f}"),
        ("frames/s", f"{report.frames_per_second:.2f}"),
        ("peak memory", human_bytes(report.peak_memory_mb * 1e6)),
        ("accepted", f"{report.acceptance_rate:.0%} of {report.home_attempts} homes tried"),
        ("workers", _memory(report)),
        ("rejections", _by_hazard(report.rejections)),
        ("anomalies", _counts(report.anomalies)),
        ("a scene", _histogram(report.anomaly_counts)),
        ("renderer", report.renderer or "none"),
    ]
    if report.made == 0:
        missing = ("homes/h", "frames/s", "accepted", "workers")
        rows = [row for row in rows if row[0] not in missing]
    return "\n".join(f"{name:12} {value}" for name, value in rows)


def _resumed(report: BuildReport) -> str:
    return f" ({report.resumed} were there already)" if report.resumed else ""


def _by_hazard(causes: Causes) -> str:
    """Rejections, those of a hazard together: ``spill x5 (no place x3, not proved x2)``."""
    groups: dict[str, Counter[str]] = {}
    for cause, count in causes.items():
        whose = cause.hazard or cause.stage
        groups.setdefault(whose, Counter())[cause.what()] += count
    shown = [
        f"{whose} x{checks.total()} ({_counts(checks)})"
        for whose, checks in sorted(groups.items(), key=lambda pair: (-pair[1].total(), pair[0]))
    ]
    return ", ".join(shown) or "none"


def _histogram(counts: dict[int, int]) -> str:
    """``0 in 3, 1 in 4 scenes``: scenes by their number of anomalies."""
    pairs = ", ".join(f"{number} in {scenes}" for number, scenes in sorted(counts.items()))
    return f"{pairs} scenes" if pairs else "none"


def _memory(report: BuildReport) -> str:
    """What a worker held at most, early and late: it grows with the models met so far."""
    early = human_bytes(report.worker_first_mb * 1e6)
    late = human_bytes(report.worker_last_mb * 1e6)
    span = report.memory_span
    return f"held at most {early} in the first {span}, {late} in the last {span} scenes made"
