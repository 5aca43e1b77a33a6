"""How fast whole data sets are built: homes an hour, frames a second, memory, disk.

Run: ``python benchmarks/build.py [--n 24] [--workers 2]``. Builds the same scenes into temporary
folders with all sensors under EGL, with the CPU renderer, and with no sensors (labels only), and
prints a Markdown table.
"""

from __future__ import annotations

import argparse
import os
import sys
import tempfile
from pathlib import Path

from sdgen.catalog.load import load_catalog
from sdgen.engines.build import build as run_build
from sdgen.library import load_library
from sdgen.options import BuildOptions

CASES = {
    "all sensors, EGL": {"renderer": "auto"},
    "all sensors, `--renderer cpu`": {"renderer": "cpu"},
    "`--sensors none` (labels only)": {"sensors": ()},
}


def folder_mb(folder: Path) -> float:
    """Size of all files below a folder, megabytes."""
    return sum(f.stat().st_size for f in folder.rglob("*") if f.is_file()) / 1e6


def main() -> None:
    """Print one row a case."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--n", type=int, default=24)
    parser.add_argument("--seed", type=int, default=7)
    parser.add_argument("--workers", type=int, default=os.cpu_count() or 1)
    args = parser.parse_args()
    catalog, library = load_catalog(), load_library()
    out = sys.stdout.write
    out("| what | homes/h | frames/s | peak memory | disk a scene |\n|---|---|---|---|---|\n")
    for name, changes in CASES.items():
        options = BuildOptions.model_validate({"n": args.n, "seed": args.seed, **changes})
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "set"
            report = run_build(options, path, catalog, library, workers=args.workers)
            disk = folder_mb(path) / max(args.n, 1)
        out(
            f"| {name} | {report.homes_per_hour:.0f} | {report.frames_per_second:.2f} "
            f"| {report.peak_memory_mb / 1000:.1f} GB | {disk:.1f} MB |\n"
        )


if __name__ == "__main__":
    main()
