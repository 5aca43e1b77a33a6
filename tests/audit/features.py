"""What pictures and placement tell of each small thing besides its content."""

from __future__ import annotations

from collections.abc import Set
from dataclasses import dataclass, field

import numpy as np
import numpy.typing as npt
import shapely

from tests.audit.dataset import Floats, Scene, Thing
from tests.audit.graph import surfaces

Strings = npt.NDArray[np.str_]

#: A thing shows with so many pixels at 640 x 480: what the format asks of a label's evidence.
SEEN_PIXELS = 100
#: Things in a band of this height count as equally high, metres.
BAND_M = 0.3
#: What the definition of a class is made of (of all: height, by which children reach): of these a
#: detector may learn without having been given anything away.
DEFINING = {
    "*": {"height"},
    "tripping_hazard": {"from the wall", "from a doorway"},
}


@dataclass
class Rows:
    """One row an object: what it is told by (NaN: unknown), and what it is."""

    names: list[str]
    values: list[list[float]] = field(default_factory=list)
    about: list[dict[str, str | bool]] = field(default_factory=list)

    @property
    def features(self) -> Floats:
        return np.array(self.values, float).reshape(len(self.values), len(self.names))

    def free(self, kind: str) -> Floats:
        """The features without what the definition of each row's class is made of.

        What is compared within a ``kind`` (of ``about``) loses the same of all rows, or that they
        lack it would tell them.
        """
        features = self.features
        hazards, kinds = self.column("hazard").astype(str), self.column(kind).astype(str)
        for hazard, names in DEFINING.items():
            rows = np.ones(len(hazards), bool)
            if hazard != "*":
                rows = np.isin(kinds, kinds[hazards == hazard])
            for name in names & set(self.names):
                features[rows, self.names.index(name)] = np.nan
        return features

    def without(self, names: Set[str]) -> Rows:
        """The same rows without what these names tell."""
        kept = [k for k, name in enumerate(self.names) if name not in names]
        values = [[row[k] for k in kept] for row in self.values]
        return Rows([self.names[k] for k in kept], values, self.about)

    def column(self, key: str) -> npt.NDArray[np.generic]:
        return np.array([row[key] for row in self.about])


def what_it_is(scene: Scene, thing: Thing, near_miss: dict[int, str]) -> dict[str, str | bool]:
    """Its label, its class (a lookalike's is the one it is near to), home, height and zone."""
    hazards = sorted(scene.hazards_of.get(thing.id, set()))
    zone = any(tag in scene.nodes[thing.id]["tags"] for tag in ("IN_DOORWAY", "IN_WALKWAY"))
    # What the definitions hang on: how high, on what kind of ground, in a way, in which state.
    ground = "floor" if thing.bottom < 0.05 else f"{thing.bottom // BAND_M:.0f}"
    kind = "anomaly" if hazards else "lookalike" if thing.id in near_miss else "clutter"
    return {
        "kind": kind,
        "hazard": hazards[0] if hazards else near_miss.get(thing.id, ""),
        "category": thing.category,
        "band": ground,
        "zone": zone,
        "home": str(scene.scene["home"]["id"]),
        "scene": scene.id,
    }


#: Per size of the thing, these tell its shape: coins are flat and pieces of a cup lie wide.
SHAPE = {"pixels", "pixels of all views", "width", "height of box"}
PICTURE = [
    "views",
    "near views",
    "first view",
    "best view",
    "best view is near",
    "pixels",
    "pixels of all views",
    "fraction",
    "from the middle",
    "from the middle, at best",
    "across",
    "down",
    "width",
    "height of box",
    "distance",
    "height",
    "touches the border",
    "picture bytes",
    "rank of picture bytes",
    "camera height",
    "pitch",
]


def picture_rows(scenes: list[Scene]) -> Rows:
    """All that pictures tell of small things without what they show."""
    rows = Rows(PICTURE)
    for scene in scenes:
        near_miss = {item["object_id"]: item["near_miss_of"] for item in scene.labels["lookalikes"]}
        views = scene.views
        sizes = np.array([rgb_bytes(scene, number) for number in range(len(views))])
        seen: dict[int, list[tuple[int, dict[str, float], list[float]]]] = {}
        for view in scene.visibility["views"]:
            for item in view["objects"]:
                record = (view["view"], item, item["bbox"])
                seen.setdefault(item["object_id"], []).append(record)
        for thing in scene.small:
            shown = seen.get(thing.id, [])
            rows.values.append(picture_row(thing, shown, views, sizes))
            about = what_it_is(scene, thing, near_miss)
            scale = views[0]["width"] * views[0]["height"] / (640 * 480) if views else 1.0
            most = max((item["pixels"] for _, item, _ in shown), default=0)
            about["seen"] = bool(most >= SEEN_PIXELS * scale)
            rows.about.append(about)
        scene.forget()
    return rows


def rgb_bytes(scene: Scene, number: int) -> float:
    file = scene.view_files[number].parent
    pictures = [file / "rgb.png", file / "rgb.jpg"]
    return float(next((p.stat().st_size for p in pictures if p.exists()), 0))


def picture_row(
    thing: Thing,
    shown: list[tuple[int, dict[str, float], list[float]]],
    views: list[dict[str, object]],
    sizes: Floats,
) -> list[float]:
    """One row; places count from the picture's middle, 1 at the border of its short side."""
    if not shown:
        return [0.0, 0.0, *[np.nan] * 13, thing.bottom, *[np.nan] * 5]
    offsets = []
    for number, _, (x, y, w, h) in shown:
        view = views[number]
        middle = np.array([x + w / 2, y + h / 2])
        size = np.array([view["width"], view["height"]], float)
        offsets.append((middle - size / 2) / (size.min() / 2))
    far = [float(np.hypot(*offset)) for offset in offsets]
    best = int(np.argmax([item["pixels"] for _, item, _ in shown]))
    number, item, (x, y, w, h) = shown[best]
    # Sizes are told per size of the thing: how large a knife is beside a spoon is content.
    own = float(np.linalg.norm(thing.box[1] - thing.box[0]))
    view = views[number]
    camera = np.array(view["world_from_camera"])
    size = np.array([view["width"], view["height"]], float)
    return [
        len(shown),
        sum(views[n]["kind"] == "near" for n, _, _ in shown),
        min(n for n, _, _ in shown),
        number,
        view["kind"] == "near",
        item["pixels"] / own**2,
        sum(i["pixels"] for _, i, _ in shown) / own**2,
        item["fraction"],
        min(far),
        far[best],
        *np.abs(offsets[best]),
        w / own,
        h / own,
        float(np.linalg.norm(thing.position - camera[:3, 3])),
        thing.bottom,
        x <= 0 or y <= 0 or x + w >= size[0] or y + h >= size[1],
        sizes[number],
        int((sizes < sizes[number]).sum()),
        camera[2, 3],
        camera[2, 2],
    ]


PLACEMENT = [
    "support",
    "room",
    "inside",
    "height",
    "from the edge",
    "from the wall",
    "from a doorway",
    "from a seat",
    "on the support",
    "within 0.3 m",
    "within 1 m",
    "of its category within 1 m",
    "of its superclass within 1 m",
    "nearest",
    "turned",
    "its category at home here",
]


def placement_rows(scenes: list[Scene]) -> Rows:
    """Where small things are, and in whose company."""
    rows = Rows(PLACEMENT)
    code: dict[str, int] = {}

    def coded(name: str) -> int:
        return code.setdefault(name, len(code))

    at_home = usual_places(scenes)
    for scene in scenes:
        near_miss = {item["object_id"]: item["near_miss_of"] for item in scene.labels["lookalikes"]}
        small = scene.small
        middles = np.array([(t.box[0] + t.box[1]) / 2 for t in small]).reshape(-1, 3)
        classes = np.array([scene.nodes[t.id]["category"] for t in small])
        categories = np.array([t.category for t in small])
        doors = [
            shapely.Point(o["center_m"][:2])
            for o in scene.scene["home"]["openings"]
            if o["kind"] != "window"
        ]
        seats = [t for t in scene.furniture if t.has("SITTABLE", scene.catalogue)]
        shared: dict[int, int] = {}
        for thing in small:
            for holder in scene.on.get(thing.id, []):
                shared[holder] = shared.get(holder, 0) + 1
        for i, thing in enumerate(small):
            holders = [b for b in scene.on.get(thing.id, []) if b in scene.nodes]
            support = scene.nodes[holders[0]]["class_name"] if holders else "nothing"
            far = np.linalg.norm(middles - middles[i], axis=1)
            far[i] = np.inf
            point = shapely.Point(middles[i, :2])
            floor = scene.floors.get(thing.room)
            rows.values.append(
                [
                    coded(support),
                    coded(scene.room_type(thing)),
                    bool(scene.inside.get(thing.id)),
                    thing.bottom,
                    from_edge(scene, thing, holders),
                    float(floor.exterior.distance(thing.footprint)) if floor else np.nan,
                    min(door.distance(point) for door in doors),
                    min((s.footprint.distance(point) for s in seats), default=9.0),
                    shared.get(holders[0], 0) if holders else 0,
                    (far < 0.3).sum(),
                    (far < 1).sum(),
                    ((far < 1) & (categories == thing.category)).sum(),
                    ((far < 1) & (classes == classes[i])).sum(),
                    far.min() if len(far) > 1 else np.nan,
                    float(np.arctan2(thing.turn[1, 0], thing.turn[0, 0])),
                    at_home.get((thing.category, support), 0.0),
                ]
            )
            rows.about.append(what_it_is(scene, thing, near_miss) | {"seen": True})
        scene.forget()
    return rows


def usual_places(scenes: list[Scene]) -> dict[tuple[str, str], float]:
    """By category and support, how much more often the catalogue lets it live there than not."""
    catalogue = scenes[0].catalogue
    found: dict[tuple[str, str], float] = {}
    for category, lives in catalogue.lives.items():
        for entry in lives:
            for target in entry["targets"]:
                key = (category, target)
                found[key] = found.get(key, 0.0) + entry["weight"]
    return found


def from_edge(scene: Scene, thing: Thing, holders: list[int]) -> float:
    """From its middle to the edge of the surface it is on, metres; NaN on a floor."""
    if not holders or holders[0] not in scene.things:
        return float("nan")
    point = shapely.Point(*((thing.box[0] + thing.box[1])[:2] / 2))
    gaps = [
        outline.exterior.distance(point)
        for outline, height in surfaces(scene.things[holders[0]])
        if abs(height - thing.bottom) < 0.03 and isinstance(outline, shapely.Polygon)
    ]
    return min(gaps, default=float("nan"))


def record_rows(scenes: list[Scene]) -> Rows:
    """Ids, order, names of models and last digits: all that must be neutral."""
    rows = Rows(["rank", "id", "id mod 10", "prefab", *[f"digits {k}" for k in range(7)]])
    for scene in scenes:
        near_miss = {item["object_id"]: item["near_miss_of"] for item in scene.labels["lookalikes"]}
        order = [item["id"] for item in scene.scene["objects"]]
        for thing in scene.small:
            prefab = scene.nodes[thing.id]["prefab_name"]
            pose = thing.json["pose"]
            digits = [round(v * 1e5) % 10 for v in pose["position_m"]]
            digits += [round(abs(v) * 1e6) % 10 for v in pose["quat_xyzw"]]
            rank = order.index(thing.id) / len(order)
            rows.values.append([rank, thing.id, thing.id % 10, int(prefab[-6:], 16), *digits])
            rows.about.append(what_it_is(scene, thing, near_miss) | {"seen": True})
        scene.forget()
    return rows


def scene_tables(scenes: list[Scene]) -> tuple[dict[str, Floats], npt.NDArray[np.int64], Strings]:
    """By what tells it, the rows of scenes; the number of hazards of each, and its home."""
    names = sorted({o["category"] for s in scenes for o in s.scene["objects"]})
    column = {name: k for k, name in enumerate(names)}
    counts = np.zeros((len(scenes), len(names)))
    files, kinds = [], []
    for k, scene in enumerate(scenes):
        # What a label added is the label; a fridge stands there whether or not it is open.
        added = {a["object_id"] for a in scene.labels["anomalies"] if a["target_id"] is not None}
        for item in scene.scene["objects"]:
            if item["id"] not in added:
                counts[k, column[item["category"]]] += 1
        views = scene.views
        sizes = [rgb_bytes(scene, n) for n in range(len(views))]
        files.append([*sorted(sizes), sum(sizes), *sizes])
        near = [view["kind"] == "near" for view in views]
        rooms = [view["room_id"] for view in views]
        heights = [view["world_from_camera"][2][3] for view in views]
        pitches = [view["world_from_camera"][2][2] for view in views]
        kinds.append([sum(near), len(set(rooms)), *near, *sorted(heights), *sorted(pitches)])
    tables = {
        "counts of categories": counts,
        "sizes of picture files": ragged(files),
        "kinds, order and cameras of views": ragged(kinds),
    }
    hazards = np.array([len(scene.labels["anomalies"]) for scene in scenes])
    return tables, hazards, np.array([str(s.scene["home"]["id"]) for s in scenes])


def ragged(rows: list[list[float]]) -> Floats:
    width = max(len(row) for row in rows)
    return np.array([[*row, *[np.nan] * (width - len(row))] for row in rows], float)
