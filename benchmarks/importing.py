"""How fast models come in: models a minute and peak memory of ``sdgen assets import``.

    python benchmarks/importing.py ycb=downloads/ycb gso=downloads/gso [--workers 2]

Each SOURCE=PATH is imported into a new library that is thrown away. Numbers of the last run are in
docs/performance.md.
"""

from __future__ import annotations

import argparse
import resource
import tempfile
import time
from pathlib import Path

from sdgen.catalog.load import load_catalog
from sdgen.importing.run import Import, import_models


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("sources", nargs="+", metavar="SOURCE=PATH")
    parser.add_argument("--workers", type=int, default=2)
    options = parser.parse_args()
    catalog = load_catalog()
    total, seconds = 0, 0.0
    for pair in options.sources:
        source, _, path = pair.partition("=")
        with tempfile.TemporaryDirectory() as library:
            asked = Import(
                source, Path(path), Path(library), licence="CC-BY-4.0", non_commercial=True
            )
            start = time.perf_counter()
            report = import_models(asked, catalog, workers=options.workers)
            spent = time.perf_counter() - start
        total, seconds = total + len(report.made), seconds + spent
        rate = 60 * len(report.made) / spent
        print(
            f"{pair}: {len(report.made)} models, {len(report.refused)} refused, {rate:.0f} a minute"
        )
    peak = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024
    print(f"all: {total} models in {seconds:.0f} s, {60 * total / seconds:.0f} a minute")
    print(f"the largest process held {peak:.0f} MB")


if __name__ == "__main__":
    main()
