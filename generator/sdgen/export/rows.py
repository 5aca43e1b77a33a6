"""A scene as rows of plain values, the same ones in every table: one a view, one for the whole."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from sdgen.dataset import SceneItem
from sdgen.dataset.scene_folder import view_folder
from sdgen.dataset.tables import (
    anomaly_rows,
    as_json,
    hazards_of,
    near_misses_of,
    object_rows,
    view_rows,
)

#: Column of a row of a view -> its file, without what kind of picture it is.
PICTURES = {"image": "rgb", "depth": "depth", "instance": "instance", "part": "part"}
#: Columns of our tables that say again what the row they are in says.
_SAID = ("scene", "split")


def picture_files(item: SceneItem, view: int) -> dict[str, str]:
    """The pictures a view has, by column: names of its files in the scene's folder."""
    folder = view_folder(view)
    names = {column: f"{folder}/{stem}.png" for column, stem in PICTURES.items()}
    names["image"] = next(
        (n for n in (f"{folder}/rgb.png", f"{folder}/rgb.jpg") if n in item.entry.files), ""
    )
    return {column: name for column, name in names.items() if name in item.entry.files}


def rows_of_views(item: SceneItem) -> Iterator[dict[str, Any]]:
    """A row a view, without its pictures: the camera, and what it shows of each object."""
    category = {thing.id: thing.category for thing in item.scene.objects}
    hazards, near = hazards_of(item), near_misses_of(item)
    shown = {view.view: view.objects for view in item.visibility.views}
    for row in view_rows(item):
        objects = [
            {
                "object_id": seen.object_id,
                "category": category[seen.object_id],
                "bbox": list(seen.bbox),
                "pixels": seen.pixels,
                "fraction": seen.fraction,
                "hazards": hazards.get(seen.object_id, []),
                "near_miss_of": near.get(seen.object_id, []),
            }
            for seen in shown.get(row["view"], ())
        ]
        kept = {name: row[name] for name in row if name != "rgb"}
        yield {**kept, "twin_of": item.entry.twin_of, "home": item.entry.home, "objects": objects}


def rows_of_anomalies(item: SceneItem) -> Iterator[dict[str, Any]]:
    """A row an anomaly; what has no fixed fields as JSON."""
    for row in anomaly_rows(item):
        yield {**row, "evidence": as_json(row["evidence"]), "remedy": as_json(row["remedy"])}


def row_of_scene(item: SceneItem) -> dict[str, Any]:
    """The row of a scene: who lives there, what is in it and what is wrong with it; its graph and
    ``scene.json`` as JSON, for they have no fixed columns."""
    category = {thing.id: thing.category for thing in item.scene.objects}
    household = item.household
    return {
        "scene": item.id,
        "split": item.entry.split,
        "index": item.entry.index,
        "twin_of": item.entry.twin_of,
        "home": item.entry.home,
        "household": {
            "template": household.template,
            "members": [{"role": m.role, "age": m.age} for m in household.members],
            "pets": list(household.pets),
            "conditions": list(household.conditions),
            "notifications": [
                {"hazard": name, "notify": choice}
                for name, choice in sorted(household.notifications.items())
            ],
            "opt_outs": list(household.opt_outs),
        },
        "rooms": [
            {
                "id": room.id,
                "name": room.name,
                "type": room.type,
                "polygon_m": [list(point) for point in room.polygon_m],
            }
            for room in item.scene.home.rooms
        ],
        "anomalies": [_less(row) for row in rows_of_anomalies(item)],
        "lookalikes": [
            {
                "object_id": near.object_id,
                "category": category[near.object_id],
                "near_miss_of": near.near_miss_of,
                "evidence": as_json(near.evidence),
            }
            for near in item.anomalies.lookalikes
        ],
        "objects": [_less(row) for row in object_rows(item)],
        "graph": item.file("graph.json").decode("utf-8"),
        "scene_json": item.file("scene.json").decode("utf-8"),
    }


def _less(row: Any) -> dict[str, Any]:
    return {name: value for name, value in row.items() if name not in _SAID}
