"""Is a build that is killed again and again the same as one that is left alone?

Run: ``python benchmarks/kills.py [--n 40] [--kills 5] [--workers 2] [-- more build options]``.
Builds a data set, then the same one with all of the build's processes killed (SIGKILL) at random
moments, resumed by the same command each time, and compares every byte. Exit 1 when they differ.
"""

from __future__ import annotations

import argparse
import hashlib
import os
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Sequence
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


def start(out: Path, options: Sequence[str]) -> subprocess.Popen[bytes]:
    """A build in a process group of its own."""
    command = [sys.executable, "-c", MAIN, "build", *options, "--out", str(out)]
    return subprocess.Popen(
        command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, start_new_session=True
    )


def finish(out: Path, options: Sequence[str]) -> float:
    """Build to the end; seconds. RuntimeError with the build's words when it fails."""
    begin = time.monotonic()
    build = start(out, options)
    said = build.communicate()[1].decode(errors="replace")
    if build.returncode != 0:
        raise RuntimeError(f"build ended with {build.returncode}: {said[-2000:]}")
    return time.monotonic() - begin


def kill_after(out: Path, options: Sequence[str], seconds: float) -> bool:
    """Start a build and kill it with its workers; False when it had ended by itself."""
    build = start(out, options)
    try:
        build.communicate(timeout=seconds)
    except subprocess.TimeoutExpired:
        os.killpg(build.pid, signal.SIGKILL)
        build.communicate()
        return True
    return False


def compare(folder: Path, options: Sequence[str], kills: int, seed: int) -> tuple[list[str], int]:
    """Files that differ between a build left alone and one killed, and the kills that hit."""
    whole, killed = folder / "whole", folder / "killed"
    seconds = finish(whole, options)
    rng = np.random.default_rng(seed)
    # A resumed build has less to do: moments are drawn over a share of the time of a whole one.
    moments = rng.uniform(0.1, 1.0, kills) * seconds / max(1.0, kills / 2)
    # Starting up takes seconds; the later moments should lie within the work.
    hits = sum([kill_after(killed, options, float(s) + 2.0) for s in moments])
    finish(killed, options)
    one, two = digests(whole), digests(killed)
    return sorted(name for name in {*one, *two} if one.get(name) != two.get(name)), hits


def main() -> int:
    """Print one line; the exit status."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--n", type=int, default=40)
    parser.add_argument("--seed", type=int, default=7)
    parser.add_argument("--kills", type=int, default=5)
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("more", nargs="*", help="more options of sdgen build")
    args = parser.parse_args()
    options = [f"--n={args.n}", f"--seed={args.seed}", f"--workers={args.workers}", *args.more]
    with tempfile.TemporaryDirectory() as folder:
        differing, hits = compare(Path(folder), options, args.kills, args.seed)
    print(f"{hits} kills, {len(differing)} files differ", *differing[:20])
    return 1 if differing else 0


if __name__ == "__main__":
    sys.exit(main())
