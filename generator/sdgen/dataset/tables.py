"""Flat tables of a data set: a row an anomaly, an object or a view, all values plain."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import cached_property
from html import escape
from typing import TYPE_CHECKING, Any, TypeAlias

from sdgen.dataset.text import compact, plain

if TYPE_CHECKING:
    import pandas as pd

    from sdgen.dataset.item import SceneItem

Row: TypeAlias = Mapping[str, Any]

#: Rows of a table that its HTML shows.
SHOWN = 10


class Table(Sequence[Row]):
    """Rows as mappings from column to value, read from the scenes' files on first use.

    ``len``, indexing and iteration as of a list; ``column(name)`` gives one column,
    ``to_pandas()`` a ``pandas.DataFrame`` (extra: pip install sdgen[pandas]). Pickles.
    """

    def __init__(
        self, columns: Sequence[str], scenes: Iterable[SceneItem], rows_of: RowsOf
    ) -> None:
        self.columns = tuple(columns)
        self._scenes = scenes
        self._rows_of = rows_of

    @cached_property
    def _rows(self) -> tuple[Row, ...]:
        return tuple(row for item in self._scenes for row in self._rows_of(item))

    def __len__(self) -> int:
        return len(self._rows)

    def __getitem__(self, index: int) -> Row:  # type: ignore[override]
        return self._rows[index]

    def __iter__(self) -> Iterator[Row]:
        return iter(self._rows)

    def column(self, name: str) -> list[Any]:
        """The values of one column. KeyError for one that is not there."""
        if name not in self.columns:
            raise KeyError(name)
        return [row[name] for row in self._rows]

    def to_pandas(self) -> pd.DataFrame:
        """The table as a ``pandas.DataFrame``. ModuleNotFoundError without pandas."""
        import pandas as pd

        frame: pd.DataFrame = pd.DataFrame(list(self._rows), columns=list(self.columns))
        return frame

    def __repr__(self) -> str:
        return f"<sdgen table: {len(self)} rows of {', '.join(self.columns)}>"

    def _repr_html_(self) -> str:
        head = "".join(f"<th>{escape(name)}</th>" for name in self.columns)
        lines = [
            "<tr>"
            + "".join(f"<td>{escape(str(row[name]))}</td>" for name in self.columns)
            + "</tr>"
            for row in self._rows[:SHOWN]
        ]
        rest = f"<p>{len(self)} rows</p>" if len(self) > SHOWN else ""
        return f"<table><tr>{head}</tr>{''.join(lines)}</table>{rest}"


RowsOf: TypeAlias = Callable[["SceneItem"], Iterable[Row]]

ANOMALY_COLUMNS = (
    "scene",
    "split",
    "id",
    "hazard",
    "group",
    "label",
    "object_id",
    "category",
    "states",
    "relation",
    "target_id",
    "target_category",
    "room_id",
    "room_type",
    "report",
    "notify",
    "reason",
    "urgency",
    "severity",
    "message",
    "evidence",
    "remedy",
    "best_view",
    "best_pixels",
)
OBJECT_COLUMNS = (
    "scene",
    "split",
    "object_id",
    "category",
    "superclass",
    "asset",
    "room_id",
    "room_type",
    "states",
    "fixed",
    "position_m",
    "quat_xyzw",
    "center_m",
    "size_m",
    "hazards",
    "near_miss_of",
    "views",
    "best_pixels",
)
VIEW_COLUMNS = (
    "scene",
    "split",
    "view",
    "kind",
    "room_id",
    "room_type",
    "width",
    "height",
    "K",
    "world_from_camera",
    "rgb",
    "objects",
    "hazards",
)


def anomaly_rows(item: SceneItem) -> Iterator[Row]:
    """A row an anomaly; ``evidence`` a mapping, ``remedy`` a list of steps, ``best_view`` the view
    that shows most of its evidence (None: no view shows any)."""
    scene = item.scene
    rooms = {room.id: room.type for room in scene.home.rooms}
    category = {thing.id: thing.category for thing in scene.objects}
    pixels = {seen.anomaly_id: seen.evidence_pixels for seen in item.visibility.anomalies}
    for anomaly in item.anomalies.anomalies:
        shown = pixels.get(anomaly.id, ())
        most = max(shown, default=0)
        yield {
            "scene": item.id,
            "split": item.entry.split,
            "id": anomaly.id,
            "hazard": anomaly.hazard,
            "group": anomaly.group,
            "label": anomaly.label,
            "object_id": anomaly.object_id,
            "category": anomaly.category,
            "states": list(anomaly.states),
            "relation": anomaly.relation,
            "target_id": anomaly.target_id,
            "target_category": category.get(anomaly.target_id or 0),
            "room_id": anomaly.room_id,
            "room_type": rooms.get(anomaly.room_id),
            "report": anomaly.report,
            "notify": anomaly.notify,
            "reason": anomaly.reason,
            "urgency": anomaly.urgency,
            "severity": anomaly.severity,
            "message": anomaly.message,
            "evidence": plain(anomaly.evidence),
            "remedy": plain(anomaly.remedy),
            "best_view": shown.index(most) if most else None,
            "best_pixels": most,
        }


def object_rows(item: SceneItem) -> Iterator[Row]:
    """A row an object; ``hazards`` that it is, ``near_miss_of`` those it looks like, ``views``
    that show it, ``center_m`` and ``size_m`` of its box in the world."""
    scene = item.scene
    rooms = {room.id: room.type for room in scene.home.rooms}
    nodes = {node.id: node for node in item.scene_graph.nodes}
    hazards, near = hazards_of(item), near_misses_of(item)
    views: dict[int, list[int]] = {}
    most: dict[int, int] = {}
    for view in item.visibility.views:
        for seen in view.objects:
            views.setdefault(seen.object_id, []).append(view.view)
            most[seen.object_id] = max(most.get(seen.object_id, 0), seen.pixels)
    for thing in scene.objects:
        node = nodes.get(thing.id)
        yield {
            "scene": item.id,
            "split": item.entry.split,
            "object_id": thing.id,
            "category": thing.category,
            "superclass": node.category if node else None,
            "asset": thing.asset,
            "room_id": thing.room_id,
            "room_type": rooms.get(thing.room_id),
            "states": list(thing.states),
            "fixed": thing.fixed,
            "position_m": list(thing.pose.position_m),
            "quat_xyzw": list(thing.pose.quat_xyzw),
            "center_m": list(node.bounding_box.center) if node else None,
            "size_m": list(node.bounding_box.size) if node else None,
            "hazards": list(hazards.get(thing.id, ())),
            "near_miss_of": list(near.get(thing.id, ())),
            "views": views.get(thing.id, []),
            "best_pixels": most.get(thing.id, 0),
        }


def view_rows(item: SceneItem) -> Iterator[Row]:
    """A row a view; ``rgb`` is its colour picture's path in the data set (None: none written),
    ``objects`` how many it shows, ``hazards`` those of the objects it shows."""
    rooms = {room.id: room.type for room in item.scene.home.rooms}
    hazards = hazards_of(item)
    shown = {view.view: view.objects for view in item.visibility.views}
    for camera in item.cameras:
        path = item.rgb_path(camera.index)
        seen = shown.get(camera.index, ())
        yield {
            "scene": item.id,
            "split": item.entry.split,
            "view": camera.index,
            "kind": camera.kind,
            "room_id": camera.room_id,
            "room_type": rooms.get(camera.room_id),
            "width": camera.width,
            "height": camera.height,
            "K": [list(row) for row in camera.K],
            "world_from_camera": [list(row) for row in camera.world_from_camera],
            "rgb": None if path is None else path.relative_to(item.root).as_posix(),
            "objects": len(seen),
            "hazards": sorted({h for o in seen for h in hazards.get(o.object_id, ())}),
        }


def hazards_of(item: SceneItem) -> dict[int, list[str]]:
    """Hazards by the object that is one."""
    out: dict[int, list[str]] = {}
    for anomaly in item.anomalies.anomalies:
        out.setdefault(anomaly.object_id, []).append(anomaly.hazard)
    return out


def near_misses_of(item: SceneItem) -> dict[int, list[str]]:
    """Hazards by the object that is a near miss of them."""
    out: dict[int, list[str]] = {}
    for near in item.anomalies.lookalikes:
        out.setdefault(near.object_id, []).append(near.near_miss_of)
    return out


def as_json(value: Any) -> str:
    """A record, or plain values, as one line of JSON: for columns that hold no fixed fields."""
    return compact(plain(value))
