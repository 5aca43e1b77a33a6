"""What a person sees of a build: a bar on a terminal, plain lines elsewhere, a closing table."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

import click
from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

from sdgen.cli.disk import human_bytes
from sdgen.engines.report import BuildEvent, BuildReport, Note, OnEvent, SceneDone, SceneFailed


@contextmanager
def watch(total: int) -> Iterator[OnEvent]:
    """A callback that shows events of a build of ``total`` scenes, on stderr."""
    console = Console(stderr=True, highlight=False)
    if not console.is_terminal:
        yield _plain_lines(total)
        return
    columns = (
        TextColumn("scenes"),
        BarColumn(),
        MofNCompleteColumn(),
        TimeRemainingColumn(),
        TextColumn("{task.description}"),
    )
    with Progress(*columns, console=console) as progress:
        task = progress.add_task("", total=total)

        def show(event: BuildEvent) -> None:
            if isinstance(event, SceneDone):
                progress.update(task, advance=1, description=f"last: {event.scene_id}")
                return
            progress.console.print(_line(event), markup=False)
            if isinstance(event, SceneFailed):
                progress.advance(task)

        yield show


def _plain_lines(total: int) -> OnEvent:
    done = 0

    def show(event: BuildEvent) -> None:
        nonlocal done
        if isinstance(event, Note):
            click.echo(event.text, err=True)
            return
        done += 1
        if isinstance(event, SceneDone) and event.resumed:
            return
        click.echo(f"{done}/{total} {_line(event)}", err=True)

    return show


def _line(event: BuildEvent) -> str:
    if isinstance(event, Note):
        return event.text
    if isinstance(event, SceneFailed):
        return f"scene {event.scene_id} could not be made: {_counts(event.reasons)}"
    return f"scene {event.scene_id} in {event.seconds:.1f} s: {_hazards(event)}"


def _hazards(event: SceneDone) -> str:
    return ", ".join(event.hazards) or "no hazard"


def _counts(counts: dict[str, int]) -> str:
    pairs = sorted(counts.items(), key=lambda pair: (-pair[1], pair[0]))
    return ", ".join(f"{name} x{count}" for name, count in pairs) or "none"


def summary(report: BuildReport) -> str:
    """The closing table of a build, as plain text."""
    good = report.made + report.resumed
    rows = [
        ("scenes", f"{good} of {report.requested}" + _resumed(report)),
        ("homes/h", f"{report.homes_per_hour:.0f}"),
        ("frames/s", f"{report.frames_per_second:.2f}"),
        ("peak memory", human_bytes(report.peak_memory_mb * 1e6)),
        ("accepted", f"{report.acceptance_rate:.0%} of {report.home_attempts} homes tried"),
        ("rejections", _counts(report.rejections)),
        ("anomalies", _counts(report.anomalies)),
        ("renderer", report.renderer or "none"),
    ]
    if report.made == 0:
        rows = [row for row in rows if row[0] not in ("homes/h", "frames/s", "accepted")]
    return "\n".join(f"{name:12} {value}" for name, value in rows)


def _resumed(report: BuildReport) -> str:
    return f" ({report.resumed} were there already)" if report.resumed else ""
