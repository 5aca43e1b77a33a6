"""Homes: how their plans come out, what is in them, and what one costs, without pictures.

Run: ``python benchmarks/homes.py plans [--seeds 500]`` for floor plans alone, or
``python benchmarks/homes.py homes [--seeds 500] [--peer PYTHON]`` for whole homes: furnished,
filled with things, settled and certified. ``--peer`` is the interpreter of an environment with
``scene_synthesizer`` (NVIDIA, https://github.com/NVlabs/scene_synthesizer): its kitchens are made
in turn with our homes and compared by the time of an object. Prints Markdown.
"""

from __future__ import annotations

import argparse
import statistics
import subprocess
import sys
import time
from collections import Counter
from collections.abc import Sequence

from sdgen.catalog.load import load_catalog
from sdgen.catalog.records import Catalog
from sdgen.engines.serve import collect_seldom
from sdgen.errors import SceneRejected
from sdgen.home.generate import generate_plan
from sdgen.home.plan import Plan
from sdgen.library import Library, load_library
from sdgen.options import BuildOptions
from sdgen.physics.client import Client
from sdgen.pipeline.scene import make_scene
from sdgen.rejection import Rejection
from sdgen.seeding import lane
from shapely.geometry import Polygon

#: What an area may differ from its type's limits by (issue of the plans).
AREA_SHARE = 0.15
PEER = """
import sys, time
from scene_synthesizer import procedural_scenes
for line in sys.stdin:
    start = time.process_time()
    scene = procedural_scenes.kitchen(seed=int(line))
    print(time.process_time() - start, len(scene.get_object_names()), flush=True)
"""


def say(text: str) -> None:
    """One line."""
    sys.stdout.write(text + "\n")
    sys.stdout.flush()


def shape_of(plan: Plan) -> tuple[object, ...]:
    """What makes two plans the same one: types and rectangles, wherever it is turned to."""
    turned = []
    for swap in (False, True):
        for sx in (1, -1):
            for sy in (1, -1):
                rooms = []
                for room in plan.rooms:
                    rects = []
                    for x0, y0, x1, y1 in room.rectangles_m:
                        xs, ys = sorted((sx * x0, sx * x1)), sorted((sy * y0, sy * y1))
                        xs, ys = (ys, xs) if swap else (xs, ys)
                        rects.append(tuple(round(v, 2) for v in (xs[0], ys[0], xs[1], ys[1])))
                    rooms.append((room.type, tuple(sorted(rects))))
                turned.append(tuple(sorted(rooms)))
    return min(turned)


def faults(plan: Plan, private: Sequence[str]) -> int:
    """Rooms that one only gets to through a private one (but what belongs to that alone)."""
    return sum(
        plan.rooms[parent].type in private and plan.rooms[k].type not in ("bathroom", "storage")
        for k, parent in enumerate(plan.parents)
        if parent >= 0
    )


def plans(catalog: Catalog, seeds: int) -> None:
    """The table of floor plans."""
    private = ("bedroom", "child_room", "bathroom", "toilet", "storage", "laundry", "office")
    found: list[Plan] = []
    times: list[float] = []
    none = 0
    for seed in range(seeds):
        start = time.process_time()
        made = generate_plan(catalog.mixes, catalog, lane(seed, 0, "plan"))
        times.append(time.process_time() - start)
        if isinstance(made, Rejection):
            none += 1
        else:
            found.append(made.plan)
    rooms = [room for plan in found for room in plan.rooms]
    right = [
        (1 - AREA_SHARE) * low <= room.area_m2 <= (1 + AREA_SHARE) * high
        for room in rooms
        for low, high in (room.spec.area_m2,)
    ]
    inside = [r.spec.area_m2[0] <= r.area_m2 <= r.spec.area_m2[1] for r in rooms]
    wishes = [met for plan in found for _, _, met in plan.wishes()]
    outlines = Counter(len(room.rectangles_m) for room in rooms)
    say("| floor plans | |\n|---|---|")
    say(f"| asked for, not come out | {seeds}, {none} |")
    say(f"| distinct | {len({shape_of(plan) for plan in found})} |")
    counts = Counter(len(plan.rooms) for plan in found)
    say(f"| rooms: plans | {', '.join(f'{n}: {counts[n]}' for n in sorted(counts))} |")
    say(f"| room types | {len({room.type for room in rooms})} |")
    say(f"| rooms of an L | {outlines[2]} of {len(rooms)} |")
    passed = sum(faults(plan, private) for plan in found)
    say(f"| rooms that one only gets to through a private one | {passed} |")
    say(f"| areas within 15 % of what the type asks | {mean(right):.1%} |")
    say(f"| areas within what the type asks | {mean(inside):.1%} |")
    say(f"| neighbours wished for | {mean(wishes):.1%} of {len(wishes)} |")
    say(f"| milliseconds of a core, median (95 %) | {quantiles(times, 1000)} |")


def homes(catalog: Catalog, library: Library, seeds: int, peer: str | None) -> None:
    """The table of whole homes."""
    options = BuildOptions(homes="procedural", sensors=(), views=0, hazards_min=0, hazards_max=0)
    others = None
    if peer is not None:
        others = subprocess.Popen(
            [peer, "-c", PEER], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
        )
    times: list[float] = []
    theirs: list[float] = []
    nodes: list[int] = []
    categories: list[int] = []
    rooms: list[int] = []
    areas: list[int] = []
    used: list[set[str]] = []
    tries: list[int] = []
    lost: Counter[str] = Counter()
    kinds: Counter[str] = Counter()
    # As in a worker of a build: one client for all, and what is loaded is not looked through again.
    client = Client()
    collect_seldom()
    for seed in range(seeds):
        start = time.process_time()
        try:
            asked = options.model_copy(update={"seed": seed})
            bundle = make_scene(0, catalog, library, asked, client)
        except SceneRejected as error:
            lost[str(error)] += 1
            continue
        times.append(time.process_time() - start)
        scene = bundle.scene
        nodes.append(len(bundle.graph.nodes))
        kinds.update(item.category for item in scene.objects if not item.fixed)
        used.append({item.category for item in scene.objects})
        categories.append(len(used[-1]))
        rooms.append(len(scene.home.rooms))
        areas.append(round(sum(Polygon(room.polygon_m).area for room in scene.home.rooms)))
        tries.append(bundle.physics.home_attempts)
        if others is not None and others.stdin and others.stdout:
            others.stdin.write(f"{seed}\n")
            others.stdin.flush()
            spent, count = others.stdout.readline().split()
            theirs.append(float(spent) / int(count))
    client.close()
    if others is not None and others.stdin:
        others.stdin.close()
        others.wait()
    per_object = statistics.median(t / n for t, n in zip(times, nodes, strict=True))
    name, most = kinds.most_common(1)[0]
    say("| whole homes | |\n|---|---|")
    say(f"| asked for, rejected for good | {seeds}, {sum(lost.values())} |")
    say(f"| came out at the first try | {mean([t == 1 for t in tries]):.1%} |")
    say(f"| nodes of the graph, median (5 %, 95 %) | {spread(nodes)} |")
    say(f"| rooms, median (5 %, 95 %) | {spread(rooms)} |")
    say(f"| square metres, median (5 %, 95 %) | {spread(areas)} |")
    say(f"| categories a home, median (5 %, 95 %) | {spread(categories)} |")
    say(f"| categories in the first {len(used[:100])} homes | {len(set().union(*used[:100]))} |")
    share = most / sum(kinds.values())
    say(f"| commonest of {sum(kinds.values())} small things | {name}, {share:.1%} |")
    say(f"| categories of small things | {len(kinds)} |")
    say(f"| seconds of a core, median (95 %), all tries counted | {quantiles(times, 1)} |")
    say(f"| milliseconds an object, median | {per_object * 1000:.1f} |")
    if theirs:
        other = statistics.median(theirs) * 1000
        say(f"| scene_synthesizer, kitchens: milliseconds an object, median | {other:.1f} |")


def mean(values: Sequence[bool]) -> float:
    """The share that is true."""
    return sum(values) / max(len(values), 1)


def quantiles(seconds: Sequence[float], unit: float) -> str:
    """Median and 95 % of times in seconds, in a unit."""
    last = sorted(seconds)[int(0.95 * (len(seconds) - 1))]
    return f"{statistics.median(seconds) * unit:.3g} ({last * unit:.3g})"


def spread(values: Sequence[int]) -> str:
    """Median and what all but one in twenty at each end lie within."""
    ordered = sorted(values)
    low, high = (ordered[int(share * (len(ordered) - 1))] for share in (0.05, 0.95))
    return f"{statistics.median(ordered):g} ({low}, {high})"


def main() -> None:
    """Print one table."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("what", choices=("plans", "homes"))
    parser.add_argument("--seeds", type=int, default=500)
    parser.add_argument("--peer", help="interpreter with scene_synthesizer")
    args = parser.parse_args()
    catalog = load_catalog()
    if args.what == "plans":
        plans(catalog, args.seeds)
    else:
        homes(catalog, load_library(), args.seeds, args.peer)


if __name__ == "__main__":
    main()
