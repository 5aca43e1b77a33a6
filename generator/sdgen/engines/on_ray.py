"""Workers as actors of a Ray cluster: one that runs already, or one started for this build."""

from __future__ import annotations

import contextlib
import logging
import os
import signal
import socket
import tempfile
import threading
import time
from collections.abc import Iterator, Mapping, Sequence
from contextlib import ExitStack, contextmanager
from importlib import import_module
from pathlib import Path
from typing import Any

from sdgen.dataset.disk import replace_file
from sdgen.dataset.scene_folder import BUILD_FOLDER
from sdgen.dataset.versions import package_versions
from sdgen.engines.machine import default_workers, free_mb, usable_cores, worker_share_mb
from sdgen.engines.protocol import Answer, Broken, Died, Message, Ready, Worker
from sdgen.engines.remote import PROBE, Order, RemoteWorker, receive
from sdgen.engines.serve import answer, set_up
from sdgen.engines.worker import WorkerSetup
from sdgen.errors import SdgenError
from sdgen.library.cache import usable_cache
from sdgen.resources import data_path
from sdgen.scratch import clear_all_of, scratch_folder

#: Seconds between two looks at how many cores the cluster has: machines come and go.
LOOK_S = 5.0
#: Unix sockets have at most 107 characters; Ray's take 68 below its folder.
SOCKET_ROOM = 107 - 68
#: Seconds in which a cluster must take a connection.
REACH_S = 10.0
#: Killed actors end when their machine comes to it, and one may just be starting: their scratch
#: folders are gone for good when there has been none for QUIET_S. Busy machines get PATIENCE_S.
QUIET_S, PATIENCE_S = 0.5, 30.0


class Actor:
    """What runs on the cluster: a :class:`RemoteWorker` with a scratch folder of its own."""

    def __init__(self, build: str) -> None:
        self._stack = ExitStack()
        # For all that is made here, by whatever library.
        tempfile.tempdir = str(self._stack.enter_context(scratch_folder(of=build)))
        self._stack.enter_context(usable_cache())

    def start(self, order: Order) -> Ready | Broken:
        """Set up."""
        try:
            self._work = set_up(RemoteWorker, (order,))
        except SdgenError as error:
            return Broken(error)
        return Ready(worker_share_mb(_workers_here(order.workers), free_mb()))

    def do(self, job: int) -> Answer | Died:
        """Make a scene."""
        return answer(self._work, job)


class ActorWorker:
    """One actor and the message that is awaited from it."""

    def __init__(self, ray: Any, actor: Any, order: Any) -> None:
        self._ray = ray
        self._actor = actor
        self.awaited = actor.start.remote(order)

    def give(self, job: int) -> None:
        """Ask for a scene."""
        self.awaited = self._actor.do.remote(job)

    def held_mb(self) -> float:
        """Nobody can tell from here; Ray ends workers when a machine's memory runs out."""
        return 0.0

    def end(self) -> None:
        """Kill it."""
        with contextlib.suppress(Exception):
            self._ray.kill(self._actor, no_restart=True)


class Cluster:
    """Launches scene workers on a Ray cluster, one a core."""

    def __init__(
        self, setup: WorkerSetup, workers: int | None, address: str | None, send_home: bool | None
    ) -> None:
        """Join the cluster at ``address``, or start one here with ``workers`` cores.

        Raises SdgenError when there is none. ``send_home`` None: as the machines find.
        """
        self._root = setup.writer.root
        self._workers = workers
        self._cores, self._looked = 1, float("-inf")
        self._name = f"{os.urandom(4).hex()}-"
        self._stack = ExitStack()
        try:
            self._ray = self._stack.enter_context(_session(address, workers))
            probe = None if send_home else self._stack.enter_context(_probe(self._root))
            order = Order(setup, package_versions(), data_path("assets"), probe, workers)
            self._order = self._ray.put(order)
            self._actor = self._ray.remote(num_cpus=1, max_restarts=0)(Actor)
        except BaseException:
            self._stack.close()
            raise

    def size(self) -> int:
        """As many as were asked for, at most one a core of the cluster as it is now."""
        if time.monotonic() - self._looked > LOOK_S:
            self._looked = time.monotonic()
            self._cores = int(self._ray.cluster_resources().get("CPU", 0))
        return min(self._cores, self._workers or self._cores)

    def launch(self) -> ActorWorker:
        """Ask for an actor; it starts where a core is free."""
        return ActorWorker(self._ray, self._actor.remote(self._name), self._order)

    def wait(self, workers: Sequence[Worker], timeout_s: float) -> list[tuple[Worker, Message]]:
        """Messages that have come; a lost actor is one too. Scenes sent home are put in place."""
        by_ref = {one.awaited: one for one in workers if isinstance(one, ActorWorker)}
        if not by_ref:
            time.sleep(min(timeout_s, 0.1))
            return []
        refs = list(by_ref)
        first, _ = self._ray.wait(refs, num_returns=1, timeout=timeout_s)
        ready, _ = self._ray.wait(refs, num_returns=len(refs), timeout=0) if first else ([], refs)
        return [(by_ref[ref], self._message(ref)) for ref in ready]

    def close(self) -> None:
        """Clean up on every machine and leave the cluster, or end the one started here."""
        with contextlib.suppress(Exception):
            self._sweep()
        self._stack.close()

    def _message(self, ref: Any) -> Message:
        try:
            message: Message = self._ray.get(ref)
        except self._ray.exceptions.OutOfMemoryError:
            return Died("out_of_memory", "out of memory on its machine")
        except self._ray.exceptions.RayError as error:
            return Died("died", f"worker lost ({type(error).__name__})")
        if isinstance(message, Answer) and message.error is None:
            result = receive(self._root, message.result)
            return Answer(result, None, message.held_mb, message.peak_mb)
        return message

    def _sweep(self) -> None:
        ray = self._ray
        clear = ray.remote(num_cpus=0, max_retries=0)(clear_all_of)
        strategy = ray.util.scheduling_strategies.NodeAffinitySchedulingStrategy
        nodes = [node["NodeID"] for node in ray.nodes() if node["Alive"]]
        asked = [
            clear.options(scheduling_strategy=strategy(node, soft=False)).remote(
                self._name, QUIET_S, PATIENCE_S
            )
            for node in nodes
        ]
        ray.wait(asked, num_returns=len(asked), timeout=2 * PATIENCE_S)


def _workers_here(asked: int | None) -> int:
    """The most workers that this build may have on this actor's machine."""
    ray: Any = import_module("ray")
    return workers_on(ray.nodes(), ray.get_runtime_context().get_node_id(), asked)


def workers_on(nodes: Sequence[Mapping[str, Any]], node_id: str, asked: int | None) -> int:
    """One worker a core that the cluster has of a machine, not more than were ``asked`` for.

    ``nodes`` is what ``ray.nodes()`` says.
    """
    of_node = [node["Resources"] for node in nodes if node["NodeID"] == node_id]
    cores = max(1, int(of_node[0].get("CPU", 0))) if of_node else usable_cores()
    return min(cores, asked or cores)


@contextmanager
def _session(address: str | None, workers: int | None) -> Iterator[Any]:
    """The module ``ray``, connected. What is started here ends here and leaves no files."""
    os.environ["RAY_USAGE_STATS_ENABLED"] = "0"  # no telemetry
    os.environ.setdefault("RAY_ACCEL_ENV_VAR_OVERRIDE_ON_ZERO", "0")  # else a warning to ignore
    import ray
    import ray.util.scheduling_strategies  # loads what the sweep asks of ray.util

    common: dict[str, Any] = {"log_to_driver": False, "logging_level": logging.ERROR}
    heard = signal.getsignal(signal.SIGTERM)
    with ExitStack() as stack:
        try:
            if address is not None:
                _reachable(address)
                ray.init(address=address, **common)
            else:
                folder = stack.enter_context(_short_scratch())
                cores = workers or default_workers()
                ray.init(num_cpus=cores, include_dashboard=False, _temp_dir=str(folder), **common)
        except (ConnectionError, RuntimeError, ValueError, OSError) as error:
            where = f"--ray-address {address}" if address is not None else "--engine ray"
            text = " ".join(str(error).split())
            raise SdgenError(f"{where}: no cluster to work on ({text})") from None
        finally:
            # Ray takes SIGTERM for itself; who listened before shall hear it.
            if threading.current_thread() is threading.main_thread():
                signal.signal(signal.SIGTERM, heard)
        try:
            yield ray
        finally:
            ray.shutdown()


def _reachable(address: str) -> None:
    """OSError when nobody listens at ``HOST:PORT``; Ray itself would try for many minutes."""
    host, _, port = address.rpartition(":")
    if host and port.isdecimal() and "/" not in address:
        socket.create_connection((host, int(port)), timeout=REACH_S).close()


@contextmanager
def _short_scratch() -> Iterator[Path]:
    """A scratch folder whose name leaves room for Ray's sockets."""
    before = tempfile.tempdir
    if len(tempfile.gettempdir()) + len("/sdgen-scratch-12345678") > SOCKET_ROOM:
        tempfile.tempdir = "/tmp"
    with ExitStack() as held:
        try:
            folder = held.enter_context(scratch_folder())
        finally:
            tempfile.tempdir = before
        yield folder


@contextmanager
def _probe(root: Path) -> Iterator[str]:
    """A file with words that nobody can guess, by which machines find that they share ``root``."""
    words = os.urandom(16).hex()
    path = root / BUILD_FOLDER / PROBE
    replace_file(path, words.encode("ascii"))
    try:
        yield words
    finally:
        path.unlink(missing_ok=True)
