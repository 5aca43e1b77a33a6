"""Is a build that is stopped again and again the same as one that is left alone?

Run: ``python benchmarks/kills.py [--n 40] [--kills 8] [--workers 2] [-- more build options]``.
Builds a data set, then the same one stopped at random moments of its progress, in turn by SIGKILL
to all of its processes, SIGTERM, SIGKILL to the parent alone and SIGINT, resumed by the same
command each time. Compares every byte, and looks for what stays behind: processes,
temporary folders, tracebacks.
Exit 1 when anything differs or stays.
"""

from __future__ import annotations

import argparse
import contextlib
import hashlib
import os
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

MAIN = "from sdgen.cli.main import main; main()"


def digests(folder: Path) -> dict[str, str]:
    """SHA-256 of every file below a folder."""
    return {
        p.relative_to(folder).as_posix(): hashlib.sha256(p.read_bytes()).hexdigest()
        for p in sorted(folder.rglob("*"))
        if p.is_file()
    }


@dataclass(frozen=True)
class Stop:
    """How a build is stopped: the signal, to whom, and the exit code it must lead to."""

    number: int
    to_all: bool
    code: int
    line: str = ""


STOPS = (
    Stop(signal.SIGKILL, True, -signal.SIGKILL),
    Stop(signal.SIGTERM, False, 143, "terminated: resume with the same command"),
    Stop(signal.SIGKILL, False, -signal.SIGKILL),
    Stop(signal.SIGINT, True, 130, "interrupted: resume with the same command"),
)
#: Seconds in which workers must be gone after the build.
GONE_S = 1.0
#: How often progress is looked at, and how long it is waited for.
LOOK_S = 0.01
LONGEST_S = 600.0


@dataclass(frozen=True)
class Found:
    """Files that differ, how many stops hit a running build, and what stayed behind."""

    differing: list[str]
    hits: int
    stayed: list[str]


def start(out: Path, options: Sequence[str], scratch: Path) -> subprocess.Popen[bytes]:
    """A build in a process group of its own, with its own place for temporary files."""
    command = [sys.executable, "-c", MAIN, "build", *options, "--out", str(out)]
    return subprocess.Popen(
        command,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
        start_new_session=True,
        env={**os.environ, "TMPDIR": str(scratch)},
        # As in a terminal, whatever the caller ignores.
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.default_int_handler) and None,
    )


def finish(out: Path, options: Sequence[str], scratch: Path) -> float:
    """Build to the end; seconds. RuntimeError with the build's words when it fails."""
    begin = time.monotonic()
    build = start(out, options, scratch)
    said = build.communicate()[1].decode(errors="replace")
    if build.returncode != 0:
        raise RuntimeError(f"build ended with {build.returncode}: {said[-2000:]}")
    return time.monotonic() - begin


@dataclass(frozen=True)
class Moment:
    """When to stop a build: so many seconds after it has this many scenes, and has workers."""

    scenes: int
    seconds: float


def stop_at(
    out: Path, options: Sequence[str], scratch: Path, moment: Moment, stop: Stop
) -> list[str] | None:
    """Start a build and stop it; what is wrong then. None when it had ended by itself."""
    build = start(out, options, scratch)
    deadline = time.monotonic() + LONGEST_S
    while build.poll() is None and time.monotonic() < deadline:
        if begun(build.pid) and len(list(out.glob("scenes/*"))) >= moment.scenes:
            break
        time.sleep(LOOK_S)
    try:
        build.communicate(timeout=moment.seconds)
        return None
    except subprocess.TimeoutExpired:
        (os.killpg if stop.to_all else os.kill)(build.pid, stop.number)
        said = build.communicate()[1].decode(errors="replace")
    wrong = []
    if build.returncode != stop.code:
        wrong.append(f"exit code {build.returncode}, not {stop.code}")
    if "Traceback" in said or "Error" in said or not said.rstrip().endswith(stop.line):
        wrong.append(f"said: {said[-1000:]}")
    deadline = time.monotonic() + GONE_S
    while (left := living(scratch)) and time.monotonic() < deadline:
        time.sleep(0.02)
    wrong += [f"process {number} lives on" for number in left]
    if stop.number != signal.SIGKILL:
        wrong += [f"{path} stays" for path in scratch.iterdir()]
    return wrong


def begun(pid: int) -> bool:
    """True once a build has a worker: before that it is Python that starts."""
    with contextlib.suppress(OSError):
        return bool(Path(f"/proc/{pid}/task/{pid}/children").read_text())
    return False


def living(scratch: Path) -> list[int]:
    """Processes that have this folder, or one in it, for their temporary files."""
    found = []
    for path in Path("/proc").glob("[0-9]*/environ"):
        with contextlib.suppress(OSError):
            if f"TMPDIR={scratch}".encode() in path.read_bytes():
                found.append(int(path.parent.name))
    return found


def compare(folder: Path, options: Sequence[str], kills: int, seed: int) -> Found:
    """A build left alone against one that is stopped ``kills`` times."""
    whole, stopped, scratch = folder / "whole", folder / "stopped", folder / "tmp"
    scratch.mkdir()
    seconds = finish(whole, options, scratch)
    stayed = [f"{path} stays after a whole build" for path in scratch.iterdir()]
    scenes = len(list(whole.glob("scenes/*")))
    rng = np.random.default_rng(seed)
    # Never after the last scene but one: the stop is to hit a build that has work left, however
    # quick the machine is.
    goals = sorted(int(n) for n in rng.integers(0, max(1, scenes - 1), kills))
    hits = 0
    for number, goal in enumerate(goals):
        stop = STOPS[number % len(STOPS)]
        moment = Moment(goal, float(rng.uniform(0.0, seconds / scenes)))
        wrong = stop_at(stopped, options, scratch, moment, stop)
        hits += wrong is not None
        name = signal.Signals(stop.number).name
        stayed += [f"{name} at {moment}: {text}" for text in wrong or ()]
    finish(stopped, options, scratch)
    stayed += [f"{path} stays at the end" for path in scratch.iterdir()]
    one, two = digests(whole), digests(stopped)
    differing = sorted(name for name in {*one, *two} if one.get(name) != two.get(name))
    return Found(differing, hits, stayed)


def main() -> int:
    """Print one line; the exit status."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--n", type=int, default=40)
    parser.add_argument("--seed", type=int, default=7)
    parser.add_argument("--kills", type=int, default=8)
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("more", nargs="*", help="more options of sdgen build")
    args = parser.parse_args()
    options = [f"--n={args.n}", f"--seed={args.seed}", f"--workers={args.workers}", *args.more]
    with tempfile.TemporaryDirectory() as folder:
        found = compare(Path(folder), options, args.kills, args.seed)
    print(f"{found.hits} stops hit, {len(found.differing)} files differ", *found.differing[:20])
    print(f"{len(found.stayed)} things stayed behind", *found.stayed, sep="\n  ")
    return 1 if found.differing or found.stayed else 0


if __name__ == "__main__":
    sys.exit(main())
