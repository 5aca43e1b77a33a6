"""A detector of your own, on what an explorer saw.

    python examples/agent_detector.py homes

A detector takes a data set and one of its scenes, and gives reports. An explorer's pictures are a
scene like any other: its views are what the agent saw, its graph is made out of them.
"""

from __future__ import annotations

import sys

from sdgen.agent.compare import Row, compare
from sdgen.agent.options import AgentOptions
from sdgen.cameras.lens import Lens
from sdgen.dataset import Dataset, SceneItem
from sdgen.dataset.records import Report
from sdgen.detectors import DETECTORS
from sdgen.library import load_library


def on_or_open(data: Dataset, item: SceneItem) -> tuple[Report, ...]:
    """Whatever is on or open is unsafe: it finds stoves, candles and fridges, and more."""
    return tuple(
        Report(object_id=node.id, label="unsafe")
        for node in item.shown_graph.nodes
        if {"ON", "OPEN"} & {*node.states} and "door" not in node.class_name
    )


def told(row: Row) -> str:
    """A row in a line."""
    who = row.explorer or row.before
    return f"{who:10} {row.detector:10} AS {row.AS.mean} false alarms {row.false_alarms.mean}"


def main(dataset: str) -> None:
    """Compare it with the rules, seen by two explorers."""
    rows = compare(
        Dataset(dataset, graph_view="perceived"),
        load_library(),
        ["rooms", "planner"],
        {"on_or_open": on_or_open, "rules": DETECTORS["rules"]},
        AgentOptions(camera=Lens(width=96, height=96), max_steps=400),
        limit=2,
    )
    for row in rows:
        print(told(row))


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: agent_detector.py DATASET")
    main(sys.argv[1])
