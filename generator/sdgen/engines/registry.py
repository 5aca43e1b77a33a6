"""The engines by name. A new one is a function here: a set-up and options in, an Engine out."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from dataclasses import dataclass
from importlib.util import find_spec

from sdgen.engines.machine import default_workers, free_mb, usable_cores, worker_share_mb
from sdgen.engines.processes import Processes
from sdgen.engines.protocol import Engine
from sdgen.engines.supervise import Limits, Supervised
from sdgen.engines.worker import SceneWorker, WorkerSetup
from sdgen.errors import UsageError, did_you_mean
from sdgen.options import BuildOptions

#: Seconds a scene may take: so many, and these for each million pixels drawn. A scene takes a few
#: seconds; the rest is for slow and busy machines.
SCENE_S = 600.0
MEGAPIXEL_S = 5.0
#: Within a scene a worker may hold this many times what it may keep after it: for two workers or
#: more, half a share is no more than what USABLE leaves of the free memory, so that one of them at
#: its worst still fits beside the others.
BLOAT = 1.5


@dataclass(frozen=True)
class EngineOptions:
    """Which engine, and for ``ray`` the address of a cluster that runs already.

    ``send_home``: whether workers send finished scenes instead of writing them into a folder
    that all machines share; None finds out.
    """

    name: str = "local"
    address: str | None = None
    send_home: bool | None = None


def local(setup: WorkerSetup, workers: int | None, options: EngineOptions) -> Engine:
    """Worker processes of this machine; None: one a core, as far as the memory goes."""
    workers = workers or default_workers()
    # With as many workers as cores, more threads in Mesa would only get in each other's way.
    setup = dataclasses.replace(setup, one_thread=workers >= usable_cores())
    share = worker_share_mb(workers, free_mb())
    limits = Limits(scene_timeout_s(setup.options), share, BLOAT * share)
    return Supervised(Processes(workers, SceneWorker, (setup,)), limits)


def scene_timeout_s(options: BuildOptions) -> float:
    """Seconds after which a worker that is still at one scene counts as hung."""
    megapixels = (
        options.views_about * options.width * options.height / 1e6 if options.sensors else 0.0
    )
    megapixels *= options.supersample**2 * options.most_folders
    return SCENE_S + MEGAPIXEL_S * megapixels


def ray(setup: WorkerSetup, workers: int | None, options: EngineOptions) -> Engine:
    """Workers on a Ray cluster, or on one that is started here for this build."""
    from sdgen.engines.on_ray import Cluster

    # A machine that is lost looks like a crash of all its workers: more tries than one.
    limits = Limits(scene_timeout_s(setup.options), retries=3)
    return Supervised(Cluster(setup, workers, options.address, options.send_home), limits)


ENGINES: dict[str, Callable[[WorkerSetup, int | None, EngineOptions], Engine]] = {
    "local": local,
    "ray": ray,
}


def check_engine(options: EngineOptions) -> None:
    """Raise UsageError for an engine that is not known or not installed."""
    if options.name not in ENGINES:
        raise UsageError(f"no engine {options.name!r}{did_you_mean(options.name, list(ENGINES))}")
    if options.name == "ray" and find_spec("ray") is None:
        raise UsageError("--engine ray needs Ray: pip install 'sdgen[ray]'")
