"""How much of a home's graph can be made out from its pictures: recall and precision of the
perceived graph's relations, tags and states, and seconds a scene.

    python benchmarks/perceived.py DATASET [--limit N] [--noise]

Seen are objects of which some view shows 100 pixels at 640x480 (in proportion elsewhere). Counted
are the edges of ``graph.json`` between two of them, or one and a room, a floor, a wall or a
ceiling; INSIDE a room is told from INSIDE a thing. CLOSE outnumbers all else, so the mean over
relations is given beside what all edges together come to. ``--noise``: a row for each way of
perceiving worse, over the same edges, and what the rules detector then finds.
"""

from __future__ import annotations

import argparse
import sys
import time
from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from itertools import islice
from pathlib import Path

from sdgen import Dataset, Perception
from sdgen.benchmark import evaluate
from sdgen.dataset import SceneItem
from sdgen.dataset.eyes import Eyes
from sdgen.detectors.rules import rules
from sdgen.scene import Graph
from sdgen.truth.visibility import evidence_pixels_needed

#: Ways of perceiving worse.
NOISE = {
    "no noise": Perception(),
    "missed 10 %": Perception(missed=0.1),
    "missed 20 %": Perception(missed=0.2),
    "confused 10 %": Perception(confused=0.1),
    "confused 20 %": Perception(confused=0.2),
    "no states": Perception(states=False),
    "coarse classes": Perception(coarse=True),
    "room views only": Perception(views="room"),
}


@dataclass
class Tally:
    """What is true, said, and both, counted by kind."""

    true: Counter[str] = field(default_factory=Counter)
    said: Counter[str] = field(default_factory=Counter)
    both: Counter[str] = field(default_factory=Counter)

    def add(self, true: Mapping[tuple[object, ...], str], said: Mapping[tuple[object, ...], str]):
        """Count facts, each with the kind it is of."""
        self.true.update(true.values())
        self.said.update(said.values())
        self.both.update(true[key] for key in true.keys() & said.keys())

    def recall(self, *kinds: str) -> float:
        """Share of what is true that is said."""
        return _share(self.both, self.true, kinds)

    def precision(self, *kinds: str) -> float:
        """Share of what is said that is true."""
        return _share(self.both, self.said, kinds)


def _share(part: Counter[str], of: Counter[str], kinds: tuple[str, ...]) -> float:
    whole = sum(of[kind] for kind in kinds)
    return sum(part[kind] for kind in kinds) / whole if whole else float("nan")


def seen(item: SceneItem) -> set[int]:
    """Ids of the objects of which some view shows enough."""
    return {
        thing.object_id
        for view, camera in zip(item.visibility.views, item.cameras, strict=True)
        for thing in view.objects
        if thing.pixels >= evidence_pixels_needed(camera.width, camera.height)
    }


def edges(graph: Graph, objects: set[int], home: set[int], rooms: set[int]) -> dict:
    """Edges from these objects to others of them or to what the home is made of, by kind."""
    return {
        (e.from_id, e.to_id, e.relation_type): (
            "INSIDE room" if e.relation_type == "INSIDE" and e.to_id in rooms else e.relation_type
        )
        for e in graph.edges
        if e.from_id in objects and (e.to_id in objects or e.to_id in home)
    }


def words(graph: Graph, objects: set[int], what: str) -> dict:
    """Tags or states of these objects."""
    return {
        (node.id, word): f"{what} {word}"
        for node in graph.nodes
        if node.id in objects
        for word in getattr(node, what)
    }


def compare(item: SceneItem, said: Graph, tally: Tally) -> None:
    """Count what a graph says of a scene."""
    objects = seen(item)
    things = {thing.id for thing in item.scene.objects}
    home = {node.id for node in item.scene_graph.nodes} - things
    rooms = {room.id for room in item.scene.home.rooms}
    true = item.scene_graph
    tally.add(edges(true, objects, home, rooms), edges(said, objects, home, rooms))
    for what in ("tags", "states"):
        tally.add(words(true, objects, what), words(said, objects, what))


def scenes(data: Dataset, perception: Perception, limit: int | None) -> Iterator[SceneItem]:
    """Scenes of the data set, perceived so."""
    for item in islice(data, limit):
        assert item.eyes is not None
        eyes = Eyes(item.eyes.knowledge, perception)
        yield replace(item, graph_view="perceived", eyes=eyes)


def say(line: str = "") -> None:
    """A line of the report."""
    sys.stdout.write(line + "\n")
    sys.stdout.flush()


def table(data: Dataset, limit: int | None) -> None:
    """Every kind of fact of the graph without noise."""
    tally, times = Tally(), []
    for item in scenes(data, Perception(), limit):
        compare(item, item.scene_graph, Tally())  # its files are read
        start = time.process_time()  # others may use the machine, too
        said = item.shown_graph
        times.append(time.process_time() - start)
        compare(item, said, tally)
    say(f"| {'of what is seen':<22} | {'true':>7} | recall | precision |")
    say("|---|---|---|---|")
    kinds = [kind for kind in tally.true if not kind.startswith(("tags", "states"))]
    for kind in sorted(tally.true.keys() | tally.said.keys(), key=lambda k: (k not in kinds, k)):
        recall, precision = tally.recall(kind), tally.precision(kind)
        say(f"| {kind:<22} | {tally.true[kind]:>7} | {recall:.3f} | {precision:.3f} |")
    total = sum(tally.true[kind] for kind in kinds)
    recall, precision = tally.recall(*kinds), tally.precision(*kinds)
    say(f"| {'all relations':<22} | {total:>7} | {recall:.3f} | {precision:.3f} |")
    say(f"| {'mean over relations':<22} | {len(kinds):>7} | {_mean(tally, kinds):.3f} | |")
    times.sort()
    say()
    say(
        f"{len(times)} scenes, {sum(times) / len(times):.2f} s of a core each to perceive (median "
        f"{times[len(times) // 2]:.2f}), pictures read from the disk"
    )


def _mean(tally: Tally, kinds: list[str]) -> float:
    return sum(tally.recall(kind) for kind in kinds) / len(kinds)


def noise(data: Dataset, path: Path, limit: int | None) -> None:
    """A row for each way of perceiving."""
    say("| perceived | objects | all relations | mean over relations | states | rules: AS | CAS |")
    say("|---|---|---|---|---|---|---|")
    for name, perception in NOISE.items():
        tally, found, there = Tally(), 0, 0
        shown = Dataset(path, graph_view="perceived", perception=perception, partial=data.partial)
        shown.shown = shown.shown[:limit]
        reports = {}
        for item in scenes(data, perception, limit):
            compare(item, item.shown_graph, tally)
            objects = seen(item)
            there += len(objects)
            found += len(objects & {node.id for node in item.shown_graph.nodes})
            reports[item.id] = rules(shown, item)
        scores = evaluate(shown, reports)
        kinds = [kind for kind in tally.true if not kind.startswith(("tags", "states"))]
        states = [kind for kind in tally.true if kind.startswith("states")]
        say(
            f"| {name} | {found / there:.3f} | {tally.recall(*kinds):.3f} | "
            f"{_mean(tally, kinds):.3f} | {tally.recall(*states):.3f} | "
            f"{scores.AS.mean:.3f} | {scores.CAS.mean:.3f} |"
        )


def main() -> None:
    """Print the tables."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("dataset", type=Path, help="with depth and instance pictures")
    parser.add_argument("--limit", type=int, help="only the first so many scenes")
    parser.add_argument("--noise", action="store_true", help="also a row for each kind of noise")
    args = parser.parse_args()
    data = Dataset(args.dataset)
    table(data, args.limit)
    if args.noise:
        say()
        noise(data, args.dataset, args.limit)


if __name__ == "__main__":
    main()
