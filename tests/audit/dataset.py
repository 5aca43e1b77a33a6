"""A data set as its files tell it: JSON and models, read here with code of the audit's own."""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cache, cached_property
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
import shapely
import yaml

from tests.audit.meshes import Mesh, join, read_glb

Floats = npt.NDArray[np.float64]
Json = dict[str, Any]

#: What has parts that are flames.
BURNS = {"stove"}

#: What lies flat on floors, under things and feet.
MATS = frozenset({"rug", "bath_mat", "doormat"})
ROOT = Path(__file__).resolve().parents[2]


@dataclass(frozen=True)
class Finding:
    """Something wrong: where, with which object (None: the whole scene), what, how much."""

    scene: str
    object_id: int | None
    what: str
    measured: float | None = None

    def __str__(self) -> str:
        where = self.scene if self.object_id is None else f"{self.scene}/{self.object_id}"
        shown = "" if self.measured is None else f" ({self.measured:.3g})"
        return f"{where} {self.what}{shown}"


@cache
def manifest(assets: Path) -> list[Json]:
    """The records of a folder of models: seconds to read, and the same for every data set."""
    listed = yaml.load((assets / "manifest.yaml").read_text("utf-8"), yaml.CSafeLoader)
    return list(listed["assets"])


class Models:
    """The models of a data set (``assets.jsonl``) and their meshes (from the folder of models)."""

    def __init__(self, folder: Path, assets: Path) -> None:
        lines = (folder / "assets.jsonl").read_text("utf-8").splitlines()
        self.records: dict[str, Json] = {r["id"]: r for r in map(json.loads, lines)}
        listed = manifest(assets)
        self._files = {r["id"]: assets / r["mesh"] for r in listed}
        self.library = {r["category"] for r in listed}
        self._meshes: dict[Path, dict[str, Mesh]] = {}

    def parts(self, asset: str) -> dict[str, Mesh]:
        """The meshes of a model by part, in the model's frame with all joints at 0."""
        file = self._files[asset]
        if file not in self._meshes:
            self._meshes[file] = read_glb(file)
        return self._meshes[file]


def rotation(quat_xyzw: list[float]) -> Floats:
    x, y, z, w = np.array(quat_xyzw) / np.linalg.norm(quat_xyzw)
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )


def joint_motion(joint: Json, value: float) -> tuple[Floats, Floats]:
    """Rotation (3, 3) and shift (3,) in the model's frame of a part whose joint is at ``value``."""
    axis = np.array(joint["axis"], float) / np.linalg.norm(joint["axis"])
    if joint["type"] == "prismatic":
        return np.eye(3), axis * value
    turned = rotation([*(axis * np.sin(value / 2)), np.cos(value / 2)])
    origin = np.array(joint["origin_m"], float)
    return turned, origin - turned @ origin


@dataclass(frozen=True)
class Part:
    """A part where it is: ``world = turn @ local + shift``."""

    name: str
    mesh: Mesh
    turn: Floats
    shift: Floats
    joint: str | None

    def world(self, points: Floats) -> Floats:
        return np.asarray(points @ self.turn.T + self.shift)

    def local(self, points: Floats) -> Floats:
        return np.asarray((points - self.shift) @ self.turn)

    @cached_property
    def vertices(self) -> Floats:
        return self.world(self.mesh.vertices)

    @cached_property
    def triangles(self) -> Floats:
        """(F, 3, 3) corners in the world."""
        return self.vertices[self.mesh.faces]

    @cached_property
    def box(self) -> Floats:
        """(2, 3): least and most of each coordinate."""
        return np.stack([self.vertices.min(0), self.vertices.max(0)])


@dataclass(frozen=True)
class Thing:
    """An object of ``scene.json`` with its model."""

    json: Json
    record: Json
    meshes: dict[str, Mesh]

    @property
    def id(self) -> int:
        return int(self.json["id"])

    @property
    def category(self) -> str:
        return str(self.json["category"])

    @property
    def asset(self) -> str:
        return str(self.json["asset"])

    @property
    def title(self) -> str:
        return str(self.record["title"])

    @property
    def fixed(self) -> bool:
        return bool(self.json["fixed"])

    @property
    def room(self) -> int:
        return int(self.json["room_id"])

    @property
    def states(self) -> list[str]:
        return list(self.json["states"])

    @cached_property
    def position(self) -> Floats:
        return np.array(self.json["pose"]["position_m"], float)

    @cached_property
    def turn(self) -> Floats:
        return rotation(self.json["pose"]["quat_xyzw"])

    @property
    def front(self) -> Floats:
        """The way it faces, a unit vector."""
        return self.turn[:, 0]

    @cached_property
    def parts(self) -> list[Part]:
        return self.posed(self.json["joints"])

    def posed(self, joints: dict[str, float]) -> list[Part]:
        """The drawn parts with the joints at these values."""
        by_name = {joint["name"]: joint for joint in self.record["joints"]}
        joint_of = {part["name"]: part["joint"] for part in self.record["parts"]}
        posed = []
        for name in self.record["variants"][self.json["variant"]]:
            turn, shift = np.eye(3), np.zeros(3)
            if joint_of[name] is not None:
                turn, shift = joint_motion(by_name[joint_of[name]], joints[joint_of[name]])
            posed.append(
                Part(
                    name,
                    self.meshes[name],
                    self.turn @ turn,
                    self.turn @ shift + self.position,
                    joint_of[name],
                )
            )
        return posed

    @cached_property
    def solids(self) -> list[Part]:
        """What moves together as one: a fridge's shell and its interior close each other. Flames
        are no solid: a pot stands in those of its burner."""
        names: dict[str | None, list[str]] = {}
        for part in self.parts:
            if not (self.category in BURNS and part.name.startswith("burner")):
                names.setdefault(part.joint, []).append(part.name)
        by_name = {part.name: part for part in self.parts}
        return [
            replace(by_name[same[0]], name=same[0], mesh=self.joined(tuple(same)))
            for same in names.values()
        ]

    def joined(self, names: tuple[str, ...]) -> Mesh:
        """Some of its parts as one mesh, made once for all objects of the model."""
        if len(names) == 1:
            return self.meshes[names[0]]
        key = " ".join(names)
        if key not in self.meshes:
            self.meshes[key] = join([self.meshes[name] for name in names])
        return self.meshes[key]

    @cached_property
    def box(self) -> Floats:
        boxes = np.array([part.box for part in self.parts])
        return np.stack([boxes[:, 0].min(0), boxes[:, 1].max(0)])

    @property
    def bottom(self) -> float:
        return float(self.box[0, 2])

    @property
    def height(self) -> float:
        return float(self.box[1, 2] - self.box[0, 2])

    @cached_property
    def footprint(self) -> shapely.Geometry:
        """The hull of all that is drawn, from above."""
        points = np.concatenate([part.vertices[:, :2] for part in self.parts])
        return shapely.convex_hull(shapely.multipoints(points))

    def has(self, prop: str, catalogue: Catalogue) -> bool:
        return prop in catalogue.properties.get(self.category, ())


class Catalogue:
    """What of ``catalogue.json`` the audit reads."""

    def __init__(self, json: Json) -> None:
        self.hazards: dict[str, Json] = {h["id"]: h for h in json["hazards"]}
        self.properties: dict[str, list[str]] = {
            c["name"]: c["properties"] for c in json["categories"]
        }
        self.kind: dict[str, str] = {c["name"]: c["kind"] for c in json["categories"]}
        self.climbs: dict[str, float] = {
            c["name"]: c["climb_m"] for c in json["categories"] if c["climb_m"] is not None
        }
        self.lives: dict[str, list[Json]] = {c["name"]: c["lives"] for c in json["categories"]}
        self.households: dict[str, Json] = {t["name"]: t for t in json["households"]}
        #: What belongs to whom of a household: pets, conditions, groups of ages.
        self.belongs_to: dict[str, list[str]] = {
            c["name"]: c["belongs_to"] for c in json["categories"]
        }
        self.grasps: list[Json] = sorted(json["reach"], key=lambda row: row["max_age"])
        self.reach_rows = sorted((r["max_age"], r["reach_m"]) for r in json["reach"])

    def reach(self, age: int) -> float:
        """How high a child of that age grasps; infinite beyond the table."""
        return next((m for oldest, m in self.reach_rows if age <= oldest), float("inf"))

    def categories_of(self, hazard: str) -> set[str]:
        """All categories named in the hazard's predicate outside of ``not``."""
        found: set[str] = set()

        def walk(term: Json) -> None:
            if term["kind"] == "category":
                found.update(term["any_of"])
            for below in term.get("terms", []):
                walk(below)

        if hazard in self.hazards:
            walk(self.hazards[hazard]["predicate"])
        return found


@dataclass(frozen=True)
class Scene:
    """One home of a data set, read when asked for."""

    folder: Path
    models: Models
    catalogue: Catalogue

    @property
    def id(self) -> str:
        return self.folder.name

    def _json(self, name: str) -> Json:
        loaded: Json = json.loads((self.folder / name).read_text("utf-8"))
        return loaded

    @cached_property
    def scene(self) -> Json:
        return self._json("scene.json")

    @cached_property
    def graph(self) -> Json:
        return self._json("graph.json")

    @cached_property
    def labels(self) -> Json:
        return self._json("anomalies.json")

    @cached_property
    def household(self) -> Json:
        return self._json("household.json")

    @cached_property
    def visibility(self) -> Json:
        return self._json("visibility.json")

    @cached_property
    def views(self) -> list[Json]:
        return [self._json(f"views/{p.parent.name}/view.json") for p in self.view_files]

    @property
    def view_files(self) -> list[Path]:
        return sorted((self.folder / "views").glob("*/view.json"))

    @cached_property
    def things(self) -> dict[int, Thing]:
        return {
            o["id"]: Thing(o, self.models.records[o["asset"]], self.models.parts(o["asset"]))
            for o in self.scene["objects"]
        }

    @property
    def small(self) -> list[Thing]:
        return [thing for thing in self.things.values() if not thing.fixed]

    @property
    def furniture(self) -> list[Thing]:
        """All that is fixed but doors and windows."""
        return [t for t in self.things.values() if t.fixed and not self.is_opening(t)]

    def is_opening(self, thing: Thing) -> bool:
        return self.catalogue.kind.get(thing.category) == "opening"

    @cached_property
    def rooms(self) -> dict[int, Json]:
        return {room["id"]: room for room in self.scene["home"]["rooms"]}

    @cached_property
    def floors(self) -> dict[int, shapely.Polygon]:
        """The inner outline of each room."""
        return {id: shapely.Polygon(room["polygon_m"]) for id, room in self.rooms.items()}

    def room_type(self, thing: Thing) -> str:
        return str(self.rooms[thing.room]["type"]) if thing.room in self.rooms else "outdoors"

    def boxes(self, category: str) -> Floats:
        """(N, 2, 3): corners of all pieces of walls, ceilings or floors."""
        pieces = [
            (np.array(p["center_m"]), np.array(p["size_m"]))
            for s in self.scene["home"]["structures"]
            if s["category"] == category
            for p in s["pieces"]
        ]
        return np.array([[c - s / 2, c + s / 2] for c, s in pieces]).reshape(-1, 2, 3)

    @cached_property
    def edges(self) -> set[tuple[int, str, int]]:
        return {(e["from_id"], e["relation_type"], e["to_id"]) for e in self.graph["edges"]}

    @cached_property
    def nodes(self) -> dict[int, Json]:
        return {node["id"]: node for node in self.graph["nodes"]}

    def related(self, relation: str) -> dict[int, list[int]]:
        """By object, to what it is so related."""
        found: dict[int, list[int]] = {}
        for a, name, b in self.edges:
            if name == relation:
                found.setdefault(a, []).append(b)
        return found

    @cached_property
    def on(self) -> dict[int, list[int]]:
        return self.related("ON")

    @cached_property
    def inside(self) -> dict[int, list[int]]:
        """By object, the furniture or vessels it is in (rooms are left out)."""
        return {
            a: within
            for a, bs in self.related("INSIDE").items()
            if (within := [b for b in bs if b in self.things])
        }

    @cached_property
    def hazards_of(self) -> dict[int, set[str]]:
        """By object, the hazards that its labels name."""
        found: dict[int, set[str]] = {}
        for label in self.labels["anomalies"]:
            found.setdefault(label["object_id"], set()).add(label["hazard"])
        return found

    @cached_property
    def lookalikes(self) -> set[int]:
        return {item["object_id"] for item in self.labels["lookalikes"]}

    def forget(self) -> None:
        """Let go of meshes where they stand: of hundreds of homes they fill the memory."""
        self.__dict__.pop("things", None)

    def found(self, thing: Thing | None, what: str, measured: float | None = None) -> Finding:
        if thing is not None:
            what = f"{thing.category} ({self.room_type(thing)}): {what}"
        return Finding(self.id, thing.id if thing else None, what, measured)


class DataSet:
    """A folder that ``sdgen build`` wrote."""

    def __init__(self, folder: Path, assets: Path = ROOT / "assets") -> None:
        self.folder = folder
        self.models = Models(folder, assets)
        self.about: Json = json.loads((folder / "dataset.json").read_text("utf-8"))
        self.catalogue = Catalogue(json.loads((folder / "catalogue.json").read_text("utf-8")))
        lines = (folder / "manifest.jsonl").read_text("utf-8").splitlines()
        self.manifest: list[Json] = [json.loads(line) for line in lines]

    def scenes(self) -> Iterator[Scene]:
        """Its scenes, one after another; twins are left out."""
        for row in self.manifest:
            if row["twin_of"] is None:
                yield Scene(self.folder / "scenes" / row["id"], self.models, self.catalogue)

    def twins_of(self, scene: Scene) -> Iterator[Scene]:
        """The twin and the toggles of a scene."""
        for row in self._twins.get(scene.id, []):
            yield Scene(self.folder / "scenes" / row["id"], self.models, self.catalogue)

    @cached_property
    def _twins(self) -> dict[str, list[Json]]:
        found: dict[str, list[Json]] = {}
        for row in self.manifest:
            if row["twin_of"] is not None:
                found.setdefault(row["twin_of"], []).append(row)
        return found
