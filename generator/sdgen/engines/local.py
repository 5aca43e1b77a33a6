"""Builds a data set on this machine: a supervised pool of worker processes, one folder."""

from __future__ import annotations

import time
from collections import Counter
from pathlib import Path

from sdgen.catalog.load import check_against_library
from sdgen.catalog.records import Catalog
from sdgen.dataset.writer import DatasetWriter
from sdgen.engines.early_stop import EarlyStop
from sdgen.engines.fit import misfits
from sdgen.engines.pool import Limits, Outcome, Pool, resident_mb
from sdgen.engines.report import (
    BuildReport,
    Note,
    OnEvent,
    SceneDone,
    SceneFailed,
    ignore_event,
)
from sdgen.engines.worker import SceneResult, SceneWorker, WorkerSetup
from sdgen.errors import InputError, SceneRejected, SdgenError
from sdgen.hazards.draw import check_range
from sdgen.library import Library
from sdgen.options import BuildOptions
from sdgen.pipeline.scene import HOME_ATTEMPTS
from sdgen.rejection import Cause
from sdgen.render import Choice, choose_renderer

#: Seconds a scene may take: so many, and these for each million pixels drawn. A scene takes a few
#: seconds; the rest is for slow and busy machines.
SCENE_S = 600.0
MEGAPIXEL_S = 5.0


def build(
    options: BuildOptions,
    out: Path,
    catalog: Catalog,
    library: Library,
    workers: int = 1,
    index_range: tuple[int, int] | None = None,
    overwrite: bool = False,
    on_event: OnEvent = ignore_event,
    limits: Limits | None = None,
    cores: int | None = None,
) -> BuildReport:
    """Build scenes ``index_range`` (all by default) of a data set into ``out``, or go on with it.

    Raises SdgenError for a folder that cannot be used, a catalogue that does not fit the library,
    a hazard that fits nowhere, a renderer that does not start, a full disk. A scene whose
    attempts are spent is in ``failed``, never silently missing. ``workers`` processes; with as
    many as ``cores`` each draws with one thread.
    """
    start = time.monotonic()
    check_against_library(catalog, library.states_by_category())
    check_range(options.hazards_min, options.hazards_max, len(catalog.hazards))
    first, end = index_range if index_range is not None else (0, options.n)
    wanted = {f"{index:06d}": index for index in range(first, end)}
    if options.hazards_max and not (out / "scenes").exists():
        problems = misfits(catalog, library, options)
        if problems:
            raise InputError(problems)
    choice = _renderer(options, on_event)
    with DatasetWriter.open(
        out, options, catalog, library.infos, library.sha256, overwrite=overwrite
    ) as writer:
        for scene_id in writer.repaired:
            on_event(Note(f"scene {scene_id} was damaged and will be made again"))
        anomalies: Counter[str] = Counter()
        counts: Counter[int] = Counter()
        stop = EarlyStop((hazard.id for hazard in catalog.hazards), wanted.values())
        resumed = [key for key in wanted if key in writer.done]
        for key in resumed:
            entry = writer.done[key]
            anomalies.update(entry.hazards)
            counts[entry.anomalies] += 1
            names = tuple(Counter(entry.hazards).elements())
            stop.made(entry.index, names)
            on_event(SceneDone(entry.index, entry.id, names, resumed=True))
        jobs = [index for key, index in wanted.items() if key not in writer.done]
        setup = WorkerSetup(
            catalog=catalog,
            library_folders=library.folders,
            library_sha256=library.sha256,
            options=options,
            writer=writer.scene_writer,
            choice=choice,
            one_thread=workers >= (cores or workers),
        )
        failed: list[SceneFailed] = []
        rejections: Counter[Cause] = Counter()
        made = frames = homes = 0
        memory: list[float] = []
        unseen: list[str] = []
        limits = limits or Limits(timeout_s=scene_timeout_s(options))
        with Pool(min(workers, max(1, len(jobs))), SceneWorker, (setup,), limits) as pool:
            for event in pool.run(jobs):
                if not isinstance(event, Outcome):
                    on_event(Note(f"worker replaced: {event.why}"))
                    continue
                if isinstance(event.error, SceneRejected):
                    failure = SceneFailed(event.job, f"{event.job:06d}", event.error.causes)
                    failed.append(failure)
                    rejections.update(event.error.causes)
                    homes += HOME_ATTEMPTS
                    on_event(failure)
                    vain = stop.failed(event.job, event.error.causes)
                    if vain is not None:
                        raise SdgenError(_mend(vain, made + len(resumed), out))
                    continue
                result = event.result
                assert isinstance(result, SceneResult)
                made += 1
                frames += result.frames
                homes += result.home_attempts
                rejections.update(result.rejections)
                anomalies.update(result.hazards)
                counts[len(result.hazards)] += 1
                vain = stop.made(event.job, result.hazards)
                if vain is not None:
                    raise SdgenError(_mend(vain, made + len(resumed), out))
                memory.append(event.memory_mb)
                if not result.all_visible and options.views > options.hazards_max:
                    unseen.append(result.scene_id)
                on_event(
                    SceneDone(
                        event.job,
                        result.scene_id,
                        result.hazards,
                        frames=result.frames,
                        seconds=result.seconds,
                        memory_mb=event.memory_mb,
                    )
                )
            peak = max(pool.peak_mb, resident_mb())
        if unseen and choice is not None:
            shown = ", ".join(unseen[:10])
            on_event(Note(f"{len(unseen)} scenes do not show every anomaly: {shown}"))
        writer.finish(
            renderers=(choice.renderer_string,) if choice is not None and made else (),
            failed={item.scene_id: item.causes for item in failed},
        )
    return BuildReport(
        out=out,
        requested=len(wanted),
        made=made,
        resumed=len(resumed),
        failed=tuple(sorted(failed, key=lambda item: item.index)),
        frames=frames,
        seconds=time.monotonic() - start,
        peak_memory_mb=peak,
        home_attempts=homes,
        rejections=dict(rejections),
        anomalies=dict(anomalies),
        renderer=choice.renderer_string if choice is not None else "none",
        anomaly_counts=dict(sorted(counts.items())),
        worker_mb=tuple(memory),
    )


def _mend(why: str, kept: int, out: Path) -> str:
    return f"{why}; mend it and start anew with --overwrite ({kept} scenes are kept in {out})"


def scene_timeout_s(options: BuildOptions) -> float:
    """Seconds after which a worker that is still at one scene counts as hung."""
    megapixels = options.views * options.width * options.height / 1e6 if options.sensors else 0.0
    megapixels *= options.supersample**2 * (2 if options.twins else 1)
    return SCENE_S + MEGAPIXEL_S * megapixels


def _renderer(options: BuildOptions, on_event: OnEvent) -> Choice | None:
    if not options.sensors or options.views == 0:
        return None
    choice = choose_renderer(options.renderer)
    if choice.note:
        on_event(Note(choice.note))
    return choice
