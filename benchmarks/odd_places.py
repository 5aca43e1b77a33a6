"""Small things of homes, drawn by hash: would a person keep this here?

Run: ``python benchmarks/odd_places.py [--seed 7] [--homes 40] [--things 200]``. Builds homes with
hazards as usual, without pictures, and prints one JSON line for each thing drawn among all small
ones but anomalies, what is shut in, and what stands in rows (half of all, and no more than shelves
that are full): what it is, in which room, on or in what, beside what, and how it came there
(``activity``, ``lookalike`` of a hazard, else ``clutter``). A person adds ``"odd": true`` or
``false``; ``--judged FILE`` then counts. The answers are in ``docs/odd-places/``.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import statistics
import sys
from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import partial
from pathlib import Path
from typing import Any
from unittest.mock import patch

from sdgen.catalog.load import load_catalog
from sdgen.errors import SceneRejected
from sdgen.home import clutter
from sdgen.library import load_library
from sdgen.options import BuildOptions
from sdgen.physics.client import Client
from sdgen.pipeline.scene import make_scene
from sdgen.scene import SceneBundle

#: Things so near one another, metres, are named as standing beside it, the nearest so many.
BESIDE_M, BESIDE_MOST = 0.35, 3


@contextmanager
def watched(made: dict[int, str]) -> Iterator[None]:
    """While it lasts, ``made`` says of things of the latest try whether an activity or a row put
    them there: scenes do not remember."""

    def watching(done: Callable[..., Any], how: str, *args: Any) -> Any:
        layout = args[0]
        if how == "activity":  # once a try, before all rows
            made.clear()
        before = set(layout.items)
        result = done(*args)
        made.update((key, how) for key in layout.items if key not in before)
        return result

    activities = partial(watching, clutter.add_activities, "activity")
    rows = partial(watching, clutter.fill_rows, "row")
    with (
        patch.object(clutter, "add_activities", activities),
        patch.object(clutter, "fill_rows", rows),
    ):
        yield


def things(bundle: SceneBundle, made: dict[int, str]) -> list[dict[str, object]]:
    """What there is to say of each small thing in sight that is no anomaly."""
    scene, marked = bundle.scene, bundle.anomalies
    anomalies = {a.object_id for a in marked.anomalies}
    near_misses = {one.object_id: one.near_miss_of for one in marked.lookalikes}
    names = {node.id: node.class_name for node in bundle.graph.nodes}
    rooms = {room.id: room.type for room in scene.home.rooms}
    shut = {item.id for item in scene.objects if "CLOSED" in item.states}
    held = {
        edge.from_id: (edge.relation_type, edge.to_id)
        for edge in bundle.graph.edges
        if edge.relation_type in ("ON", "INSIDE") and edge.to_id not in rooms
    }
    rows = []
    for item in scene.objects:
        relation, target = held.get(item.id, ("", 0))
        if item.fixed or item.id in anomalies or (relation == "INSIDE" and target in shut):
            continue
        x, y, z = item.pose.position_m
        beside = sorted(
            (((x - a) ** 2 + (y - b) ** 2) ** 0.5, other.category)
            for other in scene.objects
            for a, b, c in (other.pose.position_m,)
            if other.id != item.id and held.get(other.id, ("", 0))[1] == target
            if abs(z - c) < BESIDE_M
        )
        how = made.get(item.id, "clutter")
        if item.id in near_misses:
            how = f"lookalike of {near_misses[item.id]}"
        rows.append(
            {
                "thing": f"{scene.id}/{item.id}",
                "category": item.category,
                "model": item.asset,
                "states": [s for s in item.states if s not in ("CLEAN", "OFF", "CLOSED", "WHOLE")],
                "room": rooms[item.room_id],
                "relation": relation,
                "target": names.get(target, "?"),
                "at_m": round(z, 2),
                "beside": [name for far, name in beside[:BESIDE_MOST] if far < BESIDE_M],
                "how": how,
            }
        )
    return rows


def draw(found: list[dict[str, object]], many: int) -> list[dict[str, object]]:
    """So many of them, by a hash of what they are called."""
    ordered = sorted(found, key=lambda row: hashlib.sha256(str(row["thing"]).encode()).digest())
    return ordered[:many]


def build(seed: int, homes: int, many: int) -> None:
    """Build homes, print the things drawn, and on stderr what homes there were."""
    catalog, library = load_catalog(), load_library()
    options = BuildOptions(n=homes, seed=seed, sensors=())
    found: list[dict[str, object]] = []
    nodes, kinds, tries, lost = [], [], [], 0
    made: dict[int, str] = {}
    with watched(made), Client() as client:
        for index in range(homes):
            try:
                bundle = make_scene(index, catalog, library, options, client)
            except SceneRejected:
                lost += 1
                continue
            found += things(bundle, made)
            nodes.append(len(bundle.graph.nodes))
            kinds.append(len({item.category for item in bundle.scene.objects}))
            tries.append(bundle.physics.placement_attempts)
    loose = [row for row in found if row["how"] != "row"]
    for number, row in enumerate(draw(loose, many)):
        sys.stdout.write(json.dumps({"n": number, **row}) + "\n")
    medians = statistics.median(nodes), statistics.median(kinds), statistics.mean(tries)
    sys.stderr.write(
        f"{homes} homes, {lost} rejected; nodes {medians[0]:g}, categories {medians[1]:g} "
        f"(medians); "
        f"{medians[2]:.2f} tries a home; {len(found)} things: "
        f"{dict(Counter(str(row['how']).split()[0] for row in found))}\n"
    )


def count(path: Path) -> None:
    """Print the share judged odd, by how things came there."""
    rows = [json.loads(line) for line in path.read_text("utf-8").splitlines()]
    hows = Counter(row["how"].split()[0] for row in rows)
    odd = Counter(row["how"].split()[0] for row in rows if row["odd"])
    for how in sorted(hows):
        sys.stdout.write(f"{how}: {odd[how]} odd of {hows[how]}\n")
    sys.stdout.write(f"all: {odd.total()} odd of {len(rows)}, {odd.total() / len(rows):.1%}\n")


def main() -> None:
    """Print what was drawn, or count what was judged."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--seed", type=int, default=7)
    parser.add_argument("--homes", type=int, default=40)
    parser.add_argument("--things", type=int, default=200)
    parser.add_argument("--judged", type=Path, help="answers to count, in place of building homes")
    args = parser.parse_args()
    if args.judged is None:
        build(args.seed, args.homes, args.things)
    else:
        count(args.judged)


if __name__ == "__main__":
    main()
