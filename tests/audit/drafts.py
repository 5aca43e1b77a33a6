"""Scenes with one fault planted, to see that a check finds it."""

from __future__ import annotations

from copy import deepcopy
from functools import cached_property
from typing import Any

import numpy as np
import shapely
import yaml

from tests.audit.dataset import ROOT, Floats, Json, Scene, Thing
from tests.audit.routes import Ground


class Draft:
    """A copy of a scene in memory, to be changed; ``scene`` is what checks then read."""

    def __init__(self, original: Scene) -> None:
        self.original = original
        self.files = {
            name: deepcopy(getattr(original, name))
            for name in ("scene", "graph", "labels", "household", "visibility")
        }
        self._next = 70000

    @cached_property
    def scene(self) -> Scene:
        made = Scene(self.original.folder, self.original.models, self.original.catalogue)
        made.__dict__.update(self.files)
        return made

    @cached_property
    def ground(self) -> Ground:
        return Ground(self.original)

    def floor_id(self, room: int) -> int:
        return next(
            int(s["id"])
            for s in self.files["scene"]["home"]["structures"]
            if s["category"] == "floor" and s["room_id"] == room
        )

    def room(self, kind: str) -> int:
        return next(id for id, room in self.original.rooms.items() if room["type"] == kind)

    def thing(self, id: int) -> Thing:
        """An object as it is now, a new one too."""
        item = self.object(id)
        return Thing(item, library()[item["asset"]], self.original.models.parts(item["asset"]))

    def any(self, *categories: str) -> Thing:
        """Some thing of these categories, or some small one."""
        things = self.original.things.values()
        return next(t for t in things if t.category in categories or not (categories or t.fixed))

    def open_floor(self) -> Floats:
        """The point that is farthest from walls and furniture and in nobody's doorway."""
        clear = self.ground.clear
        at = np.unravel_index(int(np.argmax(clear)), clear.shape)
        return np.array([*self.ground.points[at], 0.0])

    def put(
        self,
        asset: str,
        at: Floats,
        *,
        yaw: float = 0.0,
        on: int | None = None,
        inside: int | None = None,
        room: int | None = None,
        joints: dict[str, float] | None = None,
        **fields: Any,
    ) -> int:
        """A new thing of a model of the library; its id."""
        record = self.original.models.records.setdefault(asset, library()[asset])
        if "outlines_m" not in record:  # of a model that the data set does not have
            meshes = self.original.models.parts(asset)
            record["outlines_m"] = {p: [m.vertices.tolist()] for p, m in meshes.items()}
        self._next += 1
        if room is None:
            point = shapely.Point(at[:2])
            floors = self.original.floors
            room = min(floors, key=lambda id: floors[id].distance(point))
        kind = self.original.catalogue.kind.get(record["category"], "small")
        item = {
            "id": self._next,
            "category": record["category"],
            "asset": asset,
            "pose": {
                "position_m": [float(v) for v in at],
                "quat_xyzw": [0.0, 0.0, float(np.sin(yaw / 2)), float(np.cos(yaw / 2))],
            },
            "room_id": room,
            "joints": {joint["name"]: 0.0 for joint in record["joints"]} | (joints or {}),
            "variant": "default",
            "states": [],
            "parts": record["variants"]["default"],
            "fixed": kind != "small",
        } | fields
        self.files["scene"]["objects"].append(item)
        thing = Thing(item, record, self.original.models.parts(asset))
        box = thing.box
        self.files["graph"]["nodes"].append(
            {
                "id": self._next,
                "class_name": record["category"],
                "category": "Props",
                "states": item["states"],
                "tags": [],
                "bounding_box": {
                    "center": ((box[0] + box[1]) / 2).tolist(),
                    "size": (box[1] - box[0]).tolist(),
                },
            }
        )
        if on is not None:
            self.edge(self._next, "ON", on)
        if inside is not None:
            self.edge(self._next, "INSIDE", inside)
        return self._next

    def on_floor(self, asset: str, at: Floats | None = None, **fields: Any) -> int:
        at = self.open_floor() if at is None else at
        point = shapely.Point(at[:2])
        room = min(self.original.floors, key=lambda r: self.original.floors[r].distance(point))
        return self.put(asset, at, on=self.floor_id(room), room=room, **fields)

    def on_top(self, asset: str, holder: Thing, rise: float = 0.0, **fields: Any) -> int:
        """On the middle of the largest level surface of a piece of furniture."""
        support = max(holder.record["supports"], key=lambda s: shapely.Polygon(s["polygon_m"]).area)
        middle = shapely.Polygon(support["polygon_m"]).centroid
        local = np.array([middle.x, middle.y, support["z_m"] + rise])
        at = holder.turn @ local + holder.position
        return self.put(asset, at, on=holder.id, room=holder.room, **fields)

    def within(self, asset: str, holder: Thing, hollow: Json, **fields: Any) -> int:
        """In the middle of a hollow of a piece of furniture."""
        at = holder.turn @ np.array(hollow["center_m"]) + holder.position
        at = at - np.array([0, 0, library()[asset]["extents_m"][2] / 2])
        return self.put(asset, at, inside=holder.id, room=holder.room, **fields)

    def edge(self, a: int, relation: str, b: int) -> None:
        self.files["graph"]["edges"].append({"from_id": a, "relation_type": relation, "to_id": b})

    def cut(self, a: int, relation: str, b: int) -> None:
        edges = self.files["graph"]["edges"]
        gone = {"from_id": a, "relation_type": relation, "to_id": b}
        edges[:] = [edge for edge in edges if edge != gone]

    def object(self, id: int) -> Json:
        found: Json = next(o for o in self.files["scene"]["objects"] if o["id"] == id)
        return found

    def move(self, id: int, by: Floats | None = None, yaw: float | None = None) -> None:
        pose = self.object(id)["pose"]
        if by is not None:
            pose["position_m"] = (np.array(pose["position_m"]) + by).tolist()
        if yaw is not None:
            pose["quat_xyzw"] = [0.0, 0.0, float(np.sin(yaw / 2)), float(np.cos(yaw / 2))]

    def label(self, id: int, hazard: str, **fields: Any) -> None:
        record = {
            "id": "planted",
            "hazard": hazard,
            "object_id": id,
            "evidence": {},
            "evidence_parts": [],
            "report": True,
            "notify": "now",
            "reason": "it concerns everyone; 'now' by default at high urgency",
            "message": "Something is wrong.",
        }
        self.files["labels"]["anomalies"].append(record | fields)


_LIBRARY: dict[str, Json] = {}


def library() -> dict[str, Json]:
    """The records of all models, with the keys that ``assets.jsonl`` has."""
    if not _LIBRARY:
        text = (ROOT / "assets" / "manifest.yaml").read_text("utf-8")
        for record in yaml.load(text, yaml.CSafeLoader)["assets"]:
            for part in record["parts"]:
                part.setdefault("joint", None)
            for rule in record["states"]:
                for key, least in {"joint": None, "min": None, "max": None, "variants": []}.items():
                    rule.setdefault(key, least)
            for support in record["supports"]:
                support.setdefault("part", "body")
            for hollow in record["containers"]:
                hollow.setdefault("closed_by", None)
            _LIBRARY[record["id"]] = record
    return _LIBRARY
