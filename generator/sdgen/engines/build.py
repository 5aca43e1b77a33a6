"""Builds a data set: one folder, and an engine that makes the scenes that are not there yet."""

from __future__ import annotations

import dataclasses
import time
from pathlib import Path

from sdgen.catalog.records import Catalog
from sdgen.dataset.vocabularies import vocabularies
from sdgen.dataset.writer import DatasetWriter
from sdgen.engines.early_stop import EarlyStop
from sdgen.engines.fit import check_buildable, misfits
from sdgen.engines.machine import held_mb
from sdgen.engines.protocol import Engine, Outcome
from sdgen.engines.registry import ENGINES, EngineOptions, check_engine
from sdgen.engines.report import BuildReport, Note, OnEvent, ignore_event
from sdgen.engines.tally import Tally
from sdgen.engines.worker import SceneResult, WorkerSetup
from sdgen.errors import AssetError, InputError, SdgenError, UsageError, WorkerFault
from sdgen.hazards.draw import check_range
from sdgen.hazards.hosting import check_named, hosted
from sdgen.library import Library
from sdgen.library.cache import usable_cache
from sdgen.library.licences import NON_COMMERCIAL
from sdgen.options import BuildOptions, check_index_range
from sdgen.pipeline.furnished import homes_of
from sdgen.render import Choice, choose_renderer

#: Scenes lost to programming errors that end a build: one or two may be rare cases, three are not.
FAULTS = 3


def build(
    options: BuildOptions,
    out: str | Path,
    catalog: Catalog,
    library: Library,
    workers: int | None = 1,
    index_range: tuple[int, int] | None = None,
    overwrite: bool = False,
    on_event: OnEvent = ignore_event,
    engine: EngineOptions | None = None,
    non_commercial: bool = False,
) -> BuildReport:
    """Build scenes ``index_range`` (all by default) of a data set into ``out``, or go on with it.

    Raises UsageError for scenes that a data set of ``options.n`` does not have, SdgenError for a
    folder that cannot be used, a catalogue that does not fit the library, a hazard that fits
    nowhere or that most homes hold, a renderer that does not start, a full disk. A scene whose
    attempts are spent is in ``failed``, never silently missing. ``workers`` processes (None: as
    many as there is room for), by the engine that ``engine`` names (this machine when None).
    ``non_commercial``: models may be used whose licence allows no trade; else they are refused.
    """
    start, out = time.monotonic(), Path(out)
    if options.homes == "imported":
        raise UsageError("homes: 'imported' ones come from 'sdgen import', no build makes them")
    engine = engine or EngineOptions()
    check_engine(engine)
    first, end = index_range if index_range is not None else (0, options.n)
    check_index_range(first, end, options.n)
    if not non_commercial:
        _check_licences(library)
    begun = (out / "scenes").exists() and not overwrite
    _check(options, catalog, library, begun, on_event)
    wanted = {f"{index:06d}": index for index in range(first, end)}
    choice = _renderer(options, on_event)
    with (
        usable_cache() as warning,
        DatasetWriter.open(
            out, options, catalog, library.infos, library.sha256, overwrite=overwrite
        ) as writer,
    ):
        for line in (*writer.notes, *([warning] if warning else [])):
            on_event(Note(line))
        tally = Tally(len(wanted))
        stop = EarlyStop((hazard.id for hazard in catalog.hazards), wanted.values())
        for key in wanted:
            if key in writer.done:
                event = tally.take_resumed(writer.done[key])
                stop.made(event.index, event.hazards)
                on_event(event)
        jobs = [index for key, index in wanted.items() if key not in writer.done]
        setup = WorkerSetup(
            catalog=catalog,
            library_folders=library.folders,
            library_sha256=library.sha256,
            options=options,
            writer=dataclasses.replace(
                writer.scene_writer, renderer=choice.renderer_string if choice else None
            ),
            choice=choice,
            one_thread=True,
        )
        peak_mb = held_mb()
        if jobs:
            runner = ENGINES[engine.name](setup, workers, engine)
            try:
                _run(runner, jobs, out, tally, stop, on_event)
            finally:
                runner.close()
            peak_mb = max(peak_mb, runner.peak_mb)
        promised = options.views_mode == "chosen" and options.views > options.hazards_max
        if tally.unseen and promised and choice is not None:
            shown = ", ".join(tally.unseen[:10])
            on_event(Note(f"{len(tally.unseen)} scenes do not show every anomaly: {shown}"))
        # The library's records as they are: their outlines would cost reading all models.
        words = vocabularies(catalog, library.assets)
        writer.finish(failed={item.scene_id: item.causes for item in tally.failed}, words=words)
    renderer = choice.renderer_string if choice is not None else "none"
    return tally.report(out, time.monotonic() - start, peak_mb, renderer)


def _run(
    engine: Engine, jobs: list[int], out: Path, tally: Tally, stop: EarlyStop, on_event: OnEvent
) -> None:
    """Take in what the engine makes. SdgenError when going on is in vain."""
    faults = 0
    for event in engine.run(jobs):
        if not isinstance(event, Outcome):
            on_event(Note(f"worker replaced: {event.why}"))
            continue
        result, error = event.result, event.error
        if error is None and isinstance(result, SceneResult):
            on_event(tally.take_made(event.job, result, event.memory_mb))
            vain = stop.made(event.job, result.hazards)
        else:
            if isinstance(error, WorkerFault):
                faults += 1
                on_event(Note(f"scene {event.job:06d}: {error}"))
                if faults == FAULTS:
                    raise WorkerFault(f"{error}; {FAULTS} scenes met such errors (a bug in sdgen)")
            failure = tally.take_failed(event)
            on_event(failure)
            vain = stop.failed(event.job, failure.causes)
        if vain is not None:
            raise SdgenError(
                f"{vain}; mend it and start anew with --overwrite "
                f"({tally.made + tally.resumed} scenes are kept in {out})"
            )


def _check_licences(library: Library) -> None:
    """Raise AssetError for models that a data set for everyone cannot have."""
    closed = [asset for asset in library.assets.values() if asset.licence in NON_COMMERCIAL]
    if closed:
        one = closed[0]
        raise AssetError(
            [
                f"{library.folder_of(one.id)}: {len(closed)} models may be used for no trade "
                f"({one.id}: {one.licence}), nor may a data set with them: say so by "
                "--non-commercial, or leave them out"
            ]
        )


def _check(
    options: BuildOptions, catalog: Catalog, library: Library, begun: bool, on_event: OnEvent
) -> None:
    """Raise SdgenError, before anything is written, for what can never be built.

    A build that goes on (``begun``) has found the hazards' places before.
    """
    check_named(options.only, catalog)
    check_buildable(catalog, library)
    bases, mixes = homes_of(catalog, options)
    classes = hosted(catalog, bases, bool(mixes), options.only)
    check_range(options.hazards_min, options.hazards_max, len(classes))
    if options.hazards_max and not begun:
        found = misfits(catalog, library, options)
        if found.problems:
            raise InputError(list(found.problems))
        for line in found.warnings:
            on_event(Note(line))


def _renderer(options: BuildOptions, on_event: OnEvent) -> Choice | None:
    if not options.draws:
        return None
    choice = choose_renderer(options.renderer)
    if choice.note:
        on_event(Note(choice.note))
    return choice
