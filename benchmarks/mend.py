"""How well planners mend the scenes of a data set, hazard by hazard.

``mend.py DATASET [--scenes 100] [--seed 0] [--assets PATH]`` mends the first so many scenes that
have an anomaly, each anew with every planner: ``remedy`` carries out what the catalogue says,
``careless`` tidies up and never asks who lives there, ``careless, shut`` shuts what it has opened.
Prints tables: what was removed of each hazard, what was caused, and what it took.
"""

from __future__ import annotations

import argparse
import statistics
import sys
import time
from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from functools import partial
from itertools import islice
from pathlib import Path

from sdgen import Dataset
from sdgen.agent.mend import (
    Left,
    Mending,
    MendScore,
    careless_planner,
    mending_of,
    remedy_planner,
    score,
)
from sdgen.library import load_library
from sdgen.physics.client import Client

PLANNERS: dict[str, Callable[[Mending], tuple[Left, ...]]] = {
    "remedy": remedy_planner,
    "careless": careless_planner,
    "careless, shut": partial(careless_planner, shuts=True),
}


@dataclass
class Tally:
    """What one planner did, over all scenes."""

    scores: list[MendScore] = field(default_factory=list)
    seconds: list[float] = field(default_factory=list)
    there: Counter[str] = field(default_factory=Counter)
    removed: Counter[str] = field(default_factory=Counter)
    caused: Counter[str] = field(default_factory=Counter)
    why: list[str] = field(default_factory=list)

    def add(self, mending: Mending, left: tuple[Left, ...], seconds: float) -> None:
        """One scene more."""
        before, now = mending.start.pairs, mending.pairs
        self.scores.append(score(mending))
        self.seconds.append(seconds)
        self.there.update(hazard for _, hazard in before)
        self.removed.update(hazard for _, hazard in before.keys() - now.keys())
        self.caused.update(hazard for _, hazard in now.keys() - before.keys())
        self.why += [f"{mending.scene.id} {one.pair}: {one.why}" for one in left]

    def total(self, name: str) -> float:
        """A sum over all scores."""
        return sum(getattr(one, name) for one in self.scores)


def rows(tallies: dict[str, Tally]) -> Iterator[str]:
    """The tables, line by line."""
    yield "| hazard | anomalies | " + " | ".join(f"{name}: removed | caused" for name in tallies)
    yield "|---|---" + "|---|---" * len(tallies) + "|"
    for hazard in sorted(next(iter(tallies.values())).there):
        cells = [f"{hazard} | {next(iter(tallies.values())).there[hazard]}"]
        for tally in tallies.values():
            share = tally.removed[hazard] / tally.there[hazard]
            cells.append(f"{share:.1%} | {tally.caused[hazard]}")
        yield "| " + " | ".join(cells) + " |"
    yield ""
    yield "| | " + " | ".join(tallies) + " |"
    yield "|---" * (len(tallies) + 1) + "|"
    sums = ("anomalies", "removed", "unadvised", "unadvised_reported", "left_reported", "caused")
    for name in (*sums, "caused_reported", "actions", "refused", "remedy_actions"):
        cells = [f"{tally.total(name):g}" for tally in tallies.values()]
        yield f"| {name} | " + " | ".join(cells) + " |"
    for words, value in (
        ("actions / remedy actions", lambda t: t.total("actions") / t.total("remedy_actions")),
        ("metres walked a scene", lambda t: t.total("walked_m") / len(t.scores)),
        ("seconds a scene, median", lambda t: statistics.median(t.seconds)),
        ("seconds a scene, most", lambda t: max(t.seconds)),
    ):
        yield f"| {words} | " + " | ".join(f"{value(t):.2f}" for t in tallies.values()) + " |"
    for name, tally in tallies.items():
        yield f"\nleft by {name}: {len(tally.why)}"
        yield from (f"- {line}" for line in tally.why[:20])


def main() -> None:
    """Print the tables."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("dataset", type=Path)
    parser.add_argument("--scenes", type=int, default=100)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--assets", type=Path, action="append", default=[])
    args = parser.parse_args()
    data, library = Dataset(args.dataset), load_library(args.assets)
    tallies = {name: Tally() for name in PLANNERS}
    wrong = (item for item in data if item.entry.anomalies)
    with Client() as client:
        for item in islice(wrong, args.scenes):
            for name, planner in PLANNERS.items():
                start = time.perf_counter()
                mending = mending_of(data, item, library, client, args.seed)
                left = planner(mending)
                tallies[name].add(mending, left, time.perf_counter() - start)
    for row in rows(tallies):
        sys.stdout.write(row + "\n")


if __name__ == "__main__":
    main()
