"""A scene graph as a table of numbers: a row a thing, columns as a layout has them."""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from sdgen.detectors.layout import AROUND, COUNTS, SHAPE, Layout
from sdgen.detectors.told import things
from sdgen.scene import Graph, GraphNode
from sdgen.vocabulary import ROOM_SUPERCLASS, STRUCTURE_SUPERCLASS

Floats = npt.NDArray[np.float32]

#: What is further off than this, metres, is as good as not there.
FAR_M = 4.0
#: Furniture is what stands on the floor, is higher than this, metres, and covers so many square
#: metres: it bounds where people walk.
FURNITURE_TOP_M, FURNITURE_M2 = 0.3, 0.1
#: What a child climbs on has its top between these, metres, and is so near.
CLIMB_LOW_M, CLIMB_HIGH_M, CLIMB_GAP_M = 0.15, 0.9, 0.5
#: Containers in containers in containers, at most.
_DEEPEST = 8


@dataclass(frozen=True)
class Rows:
    """Things of a graph: ids, numbers of category and superclass (see ``Layout``), and columns."""

    ids: tuple[int, ...]
    category: npt.NDArray[np.int64]
    kind: npt.NDArray[np.int64]
    x: Floats


def rows_of(graph: Graph, layout: Layout) -> Rows:
    """The rows of all things of a graph, in its order; an unknown word has no column."""
    nodes = things(graph)
    x = np.zeros((len(nodes), len(layout.columns)), dtype=np.float32)
    held = _Held(graph)
    for row, node in zip(x, nodes, strict=True):
        for column, value in _words(node, held, layout):
            row[column] += value
    columns = layout.columns
    x[:, _slice(columns, "shape", SHAPE)] = _shapes(nodes)
    x[:, _slice(columns, "around", AROUND)] = _around(nodes, graph)
    x[:, _slice(columns, "count", COUNTS)] = _counts(nodes, held)
    none, other = len(layout.categories), len(layout.kinds)
    return Rows(
        ids=tuple(node.id for node in nodes),
        category=np.array(
            [layout.category_number.get(n.class_name, none) for n in nodes], dtype=np.int64
        ),
        kind=np.array([layout.kind_number.get(n.category, other) for n in nodes], dtype=np.int64),
        x=x,
    )


def _slice(columns: Mapping[tuple[str, str], int], block: str, names: Sequence[str]) -> slice:
    first = columns[block, names[0]]
    return slice(first, first + len(names))


class _Held:
    """What each thing is on, in, and in which room; how often it takes part in a relation."""

    def __init__(self, graph: Graph) -> None:
        self.nodes = {node.id: node for node in graph.nodes}
        self.room: dict[int, GraphNode] = {}
        self.on: dict[int, list[GraphNode]] = defaultdict(list)
        self.inside: dict[int, list[GraphNode]] = defaultdict(list)
        self.relations: dict[int, Counter[tuple[str, str]]] = defaultdict(Counter)
        for edge in graph.edges:
            target, name = self.nodes.get(edge.to_id), edge.relation_type
            self.relations[edge.to_id]["to", name] += 1
            if target is None:
                continue
            if name == "INSIDE" and target.category == ROOM_SUPERCLASS:
                self.room.setdefault(edge.from_id, target)
                continue
            self.relations[edge.from_id]["from", name] += 1
            if name == "ON":
                self.on[edge.from_id].append(target)
            elif name == "INSIDE":
                self.inside[edge.from_id].append(target)

    def shut_in(self, node_id: int) -> bool:
        """True when something closed is around it: what it is in, or what that, or what it is on,
        is in."""
        seen, now = {node_id}, [node_id]
        for _ in range(_DEEPEST):
            around = [n for k in now for n in self.inside.get(k, ())]
            if any("CLOSED" in node.states for node in around):
                return True
            held = [*around, *(n for k in now for n in self.on.get(k, ()))]
            now = [node.id for node in held if node.id not in seen]
            seen.update(now)
        return False


def _words(node: GraphNode, held: _Held, layout: Layout) -> Iterable[tuple[int, float]]:
    """Columns of what is said of a node in words, with what to add to each."""
    said: list[tuple[str, str]] = [("kind", node.category)]
    said += [("state", word) for word in node.states]
    said += [("property", word) for word in node.properties]
    said += [("tag", word) for word in node.tags]
    room = held.room.get(node.id)
    if room is not None:
        said.append(("room", room.class_name))
    for block, holders in (("on", held.on), ("inside", held.inside)):
        for holder in holders.get(node.id, ()):
            said += [(block, holder.class_name), ("held", block)]
            said += [(f"{block}_state", word) for word in holder.states]
    if held.shut_in(node.id):
        said.append(("held", "shut_in"))
    columns = layout.columns
    yield from ((columns[word], 1.0) for word in said if word in columns)
    for word, count in held.relations.get(node.id, {}).items():
        if word in columns:
            yield columns[word], float(count)


def _boxes(nodes: Sequence[GraphNode]) -> npt.NDArray[np.float64]:
    """Least and most of each box, (n, 6) metres."""
    if not nodes:
        return np.zeros((0, 6))
    box = np.array([(*n.bounding_box.center, *n.bounding_box.size) for n in nodes])
    half = box[:, 3:] / 2
    return np.hstack([box[:, :3] - half, box[:, :3] + half])


def _shapes(nodes: Sequence[GraphNode]) -> npt.NDArray[np.float64]:
    """Heights above the floor, sizes, footprint, and the cosine of the tilt: as ``SHAPE`` has
    them."""
    box = _boxes(nodes)
    size = box[:, 3:] - box[:, :3]
    tilt = [
        1 - 2 * (n.obj_transform.rotation[0] ** 2 + n.obj_transform.rotation[1] ** 2) for n in nodes
    ]
    across = np.sort(size[:, :2], axis=1)
    return np.column_stack(
        [
            box[:, 2],
            box[:, 5],
            across[:, 1],
            across[:, 0],
            size[:, 2],
            across[:, 0] * across[:, 1],
            np.array(tilt).reshape(len(nodes)),
        ]
    )


def _around(nodes: Sequence[GraphNode], graph: Graph) -> npt.NDArray[np.float64]:
    """Gaps to doors, furniture, heat and water, room to pass, and height above what can be climbed
    on: as ``AROUND`` has them."""
    box = _boxes(nodes)
    size = box[:, 3:] - box[:, :3]
    area = size[:, 0] * size[:, 1]
    low = box[:, 2] < 0.25
    furniture = low & (box[:, 5] > FURNITURE_TOP_M) & (area > FURNITURE_M2)
    climbed = low & (box[:, 5] > CLIMB_LOW_M) & (box[:, 5] < CLIMB_HIGH_M) & (area > 0.04)
    walls = [n for n in graph.nodes if n.category == STRUCTURE_SUPERCLASS["wall"]]
    doors = np.array([n.category == "Doors" for n in nodes], dtype=bool)
    heat = np.array(["HEAT_SOURCE" in n.properties for n in nodes], dtype=bool)
    water = np.array(["WATER_SOURCE" in n.properties for n in nodes], dtype=bool)
    gaps = _gaps(box, box)
    np.fill_diagonal(gaps, FAR_M)

    def least(which: npt.NDArray[np.bool_]) -> npt.NDArray[np.float64]:
        return np.asarray(np.min(gaps[:, which], axis=1, initial=FAR_M))

    bounds = np.vstack([box[furniture & ~doors], _boxes(walls)])
    free = _free(box, bounds)
    tops = np.where((gaps < CLIMB_GAP_M) & climbed[None, :], box[None, :, 5], 0.0)
    below = np.where(tops < box[:, None, 2] + 0.02, tops, 0.0)
    return np.column_stack(
        [
            least(doors),
            least(furniture & ~doors),
            least(heat),
            least(water),
            free,
            box[:, 2] - np.max(below, axis=1, initial=0.0),
        ]
    )


def _gaps(a: npt.NDArray[np.float64], b: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
    """Gaps between boxes as seen from above, (len(a), len(b)) metres, at most ``FAR_M``."""
    apart = np.maximum(a[:, None, :2] - b[None, :, 3:5], b[None, :, :2] - a[:, None, 3:5])
    apart = np.maximum(apart, 0.0)
    return np.asarray(np.minimum(np.hypot(apart[..., 0], apart[..., 1]), FAR_M))


def _free(box: npt.NDArray[np.float64], bounds: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
    """How much room there is past the middle of each box, along x and y, between what bounds it,
    and how near the nearest of these is; (n, 3) metres."""
    middle = (box[:, :2] + box[:, 3:5]) / 2
    out = np.full((len(box), 4), FAR_M)
    for axis in (0, 1):
        across = 1 - axis
        beside = (bounds[None, :, across] <= middle[:, None, across]) & (
            middle[:, None, across] <= bounds[None, :, 3 + across]
        )
        before = middle[:, None, axis] - bounds[None, :, 3 + axis]
        behind = bounds[None, :, axis] - middle[:, None, axis]
        for side, way in enumerate((before, behind)):
            clear = np.where(beside & (way >= 0), way, FAR_M)
            out[:, 2 * axis + side] = np.min(clear, axis=1, initial=FAR_M)
    return np.column_stack([out[:, 0] + out[:, 1], out[:, 2] + out[:, 3], out.min(axis=1)])


def _counts(nodes: Sequence[GraphNode], held: _Held) -> npt.NDArray[np.float64]:
    """How many of its category are in its room and in the home, and how many things: as ``COUNTS``
    has them."""
    rooms = [held.room[n.id].id if n.id in held.room else 0 for n in nodes]
    same = Counter(n.class_name for n in nodes)
    here = Counter((room, n.class_name) for room, n in zip(rooms, nodes, strict=True))
    full = Counter(rooms)
    rows = [
        (here[room, n.class_name], same[n.class_name], full[room], len(nodes))
        for room, n in zip(rooms, nodes, strict=True)
    ]
    return np.array(rows, dtype=np.float64).reshape(len(nodes), len(COUNTS))
