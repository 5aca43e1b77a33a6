"""A detector of your own, on the scene graph alone.

    python examples/my_detector.py homes predictions.jsonl
    sdgen evaluate homes predictions.jsonl

It knows three rules of thumb and nothing of the catalogue, so it finds some anomalies, misses
others and falls for some lookalikes. It reads the states of the full graph (a stove that is ON):
whether a detector may is up to the study; ``Dataset(..., graph_view="neutral")`` has none.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Iterator

import sdgen
from sdgen.dataset import SceneItem

COLD = {"milk_carton", "cheese", "egg_carton", "yogurt_cup", "raw_meat"}
SHARP = {"knife", "scissors"}


def detect(item: SceneItem) -> Iterator[dict[str, object]]:
    """Reports of one scene."""
    graph = item.scene_graph
    name = {node.id: node.class_name for node in graph.nodes}
    inside = {
        (edge.from_id, name[edge.to_id]) for edge in graph.edges if edge.relation_type == "INSIDE"
    }
    for node in graph.nodes:
        if "ON" in node.states and node.class_name == "stove":
            yield {"object_id": node.id, "label": "unsafe"}
        if node.class_name in COLD and (node.id, "fridge") not in inside:
            yield {"object_id": node.id, "label": "unsanitary"}
        if node.class_name in SHARP and node.bounding_box.center[2] < 1.0:
            yield {"object_id": node.id, "label": "unsafe for children", "notify": "summary"}


def main(dataset: str, out: str) -> None:
    """Write one line of predictions a scene."""
    with open(out, "w", encoding="utf-8") as file:
        for item in sdgen.Dataset(dataset):
            line = {"scene": item.id, "reports": list(detect(item))}
            file.write(json.dumps(line) + "\n")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit("usage: my_detector.py DATASET OUT")
    main(sys.argv[1], sys.argv[2])
