"""How fast a data set is exported, and how much memory that takes, for every format.

    python benchmarks/exports.py DATASET [--formats tar,webdataset,...] [--rounds 3]

Each format writes the whole data set in a process of its own, in turns with ``cp -r`` and ``sync``
of the same folder: the disk's copy speed in the same run. Prints medians. Memory is the peak of the
process, for all scenes and for a quarter of them.
"""

from __future__ import annotations

import argparse
import resource
import shutil
import statistics
import subprocess
import sys
import time
from pathlib import Path
from tempfile import TemporaryDirectory

from sdgen.dataset import Dataset
from sdgen.export import FORMATS, export
from sdgen.library import load_library

WORKER = "--worker"


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("dataset", type=Path)
    parser.add_argument("--formats", default=",".join(FORMATS))
    parser.add_argument("--rounds", type=int, default=3)
    args = parser.parse_args()
    data = Dataset(args.dataset)
    views = sum(entry.views for entry in data.entries)
    size = sum(path.stat().st_size for path in args.dataset.rglob("*") if path.is_file())
    print(f"{args.dataset}: {len(data.entries)} scenes, {views} views, {size / 1e6:.0f} MB")
    for name in args.formats.split(","):
        took, copied, peaks = [], [], []
        for _ in range(args.rounds):
            copied.append(copy(args.dataset))
            seconds, peak = run(args.dataset, name, len(data))
            took.append(seconds)
            peaks.append(peak)
        seconds, disk = statistics.median(took), statistics.median(copied)
        _, few = run(args.dataset, name, max(1, len(data) // 4))
        print(
            f"{name:12} {seconds:7.2f} s  {views / seconds:7.1f} views/s  "
            f"{len(data.entries) / seconds:6.1f} scenes/s  {size / seconds / 1e6:6.0f} MB/s  "
            f"copy and sync {size / disk / 1e6:5.0f} MB/s ({disk / seconds:.2f} of it)  "
            f"memory {max(peaks):.0f} MB, a quarter of the scenes {few:.0f} MB",
            flush=True,
        )


def copy(folder: Path) -> float:
    """Seconds that a copy takes until it is on the disk."""
    with TemporaryDirectory(dir=folder.parent) as name:
        begin = time.perf_counter()
        shutil.copytree(folder, Path(name) / "copy")
        subprocess.run(["sync"], check=True)
        return time.perf_counter() - begin


def run(folder: Path, name: str, scenes: int) -> tuple[float, float]:
    """Seconds of one export in a process of its own, and its peak of memory in MB."""
    command = [sys.executable, __file__, WORKER, str(folder), name, str(scenes)]
    done = subprocess.run(command, check=True, capture_output=True, text=True)
    seconds, peak = done.stdout.split()[-2:]
    return float(seconds), float(peak)


def worker(folder: Path, name: str, scenes: int) -> None:
    """Export the first scenes of a data set; print seconds and peak of memory."""
    data = Dataset(folder)
    data.shown = data.shown[:scenes]
    library = load_library() if FORMATS[name].models else None
    with TemporaryDirectory(dir=folder.parent) as place:
        out = Path(place) / ("x.tar" if FORMATS[name].output == "file" else "x")
        begin = time.perf_counter()
        export(data, name, out, library=library)
        seconds = time.perf_counter() - begin
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1000
    print(seconds, peak)


if __name__ == "__main__":
    if sys.argv[1:2] == [WORKER]:
        worker(Path(sys.argv[2]), sys.argv[3], int(sys.argv[4]))
    else:
        main()
