"""The page of one scene: its labels, views, plan, graph and what a 3-D view needs."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path, PurePosixPath
from typing import Any
from urllib.parse import quote

from jinja2 import Environment

from sdgen.dataset import Dataset, SceneItem
from sdgen.dataset.scene_folder import view_folder
from sdgen.facts import Facts
from sdgen.gallery.boxes import BoxOnView, boxes_of
from sdgen.gallery.drawing import draw_home
from sdgen.gallery.files import INDEX, folder_of, put
from sdgen.gallery.labels import LabelOnPage, labels_of, names_of
from sdgen.gallery.marks import marks_of
from sdgen.gallery.models import Models
from sdgen.gallery.pictures import depth_png, mask_png, thumbnail
from sdgen.gallery.script import call
from sdgen.gallery.seen import best_views, cover, seen_in
from sdgen.gallery.space import scene_space
from sdgen.gallery.words import deed, who
from sdgen.hazards.certify import facts_of

DATA, OVERVIEW, PLAN = "data.js", "overview.jpg", "plan.svg"


@dataclass(frozen=True)
class ViewOnPage:
    """One view: its pictures as links relative to the page, None where there is none. ``others``
    are the same view's pictures of the scenes it is compared with, in their order."""

    index: int
    kind: str
    room: str
    width: int
    height: int
    rgb: str | None
    mask: str | None
    depth: str | None
    others: tuple[str | None, ...]
    boxes: tuple[BoxOnView, ...]


@dataclass(frozen=True)
class Around:
    """The scenes before and after one, and those of its family: its twin, and those in which one
    anomaly is undone; of these, the scene itself."""

    before: str | None
    after: str | None
    family: tuple[tuple[str, SceneItem], ...]


class ScenePages:
    """Writes the pages of one data set's scenes into the folders of a gallery."""

    def __init__(self, data: Dataset, models: Models, out: Path, environment: Environment) -> None:
        self._data = data
        self._models = models
        self._out = out
        self._page = environment.get_template("scene.html.j2")
        self._plan = environment.get_template("plan.svg.j2")
        self._hazards = {hazard.id: hazard for hazard in data.catalog.hazards}

    def write(self, item: SceneItem, around: Around) -> dict[str, Any]:
        """Write a page; what the index says of it. Raises InputError for a broken scene."""
        folder = folder_of(self._out, item.id)
        shown = seen_in(item)
        best = best_views(item, shown)
        facts = facts_of(item.scene, self._data.infos, self._data.catalog)
        name = names_of(item)
        labels = labels_of(item, facts, self._hazards, best, name)
        for label in labels:
            if label.crop is not None:
                put(folder / label.crop.name, label.crop.data)
        self._write_data(item, facts, folder, labels)
        view = cover(shown, item.entry.views)
        picture = bool(item.entry.views) and item.rgb_path(view) is not None
        drawing = draw_home(
            item.scene,
            self._data.infos,
            item.cameras,
            [a.object_id for a in item.anomalies.anomalies],
            [a.object_id for a in item.anomalies.lookalikes],
        )
        if picture:
            put(folder / OVERVIEW, thumbnail(item.rgb(view)))
        else:
            put(folder / PLAN, self._plan.render(drawing=drawing).encode("utf-8"))
        rooms = {room.id: room.name for room in item.scene.home.rooms}
        text = self._page.render(
            item=item,
            around=around,
            views=[
                self._view(item, folder, k, rooms, around.family) for k in range(item.entry.views)
            ],
            drawing=drawing,
            wrong=[label for label in labels if label.kind == "anomaly"],
            near=[label for label in labels if label.kind == "lookalike"],
            name=names_of(item, *(other for _, other in around.family)),
            deed=deed,
            who=who(item.household),
            rooms=rooms,
            titles={key: hazard.title for key, hazard in self._hazards.items()},
        )
        put(folder / INDEX, text.encode("utf-8"))
        # The index shows the anomaly that is seen best.
        ranked = sorted(labels, key=lambda one: -one.best.pixels if one.best is not None else 0)
        crops = [label.crop for label in ranked if label.crop is not None]
        return {
            "id": item.id,
            "kind": item.entry.kind,
            "home": item.entry.home,
            "split": item.entry.split,
            "household": item.household.template,
            "rooms": sorted({room.type for room in item.scene.home.rooms}),
            "hazards": item.entry.hazards,
            "crop": crops[0].name if crops else "",
            "inset": "left" if crops and crops[0].right else "right",
            "overview": OVERVIEW if picture else PLAN,
            "hidden": not item.entry.all_visible,
            "twins": len(around.family) if item.entry.twin_of is None else 0,
        }

    def _write_data(
        self, item: SceneItem, facts: Facts, folder: Path, labels: Sequence[LabelOnPage]
    ) -> None:
        boxes = {node.id: node.bounding_box for node in item.scene_graph.nodes}
        used = sorted({thing.asset for thing in item.scene.objects})
        why = {asset: self._models.why_box(asset) for asset in used}
        data = scene_space(item, self._data.infos)
        data["models"] = [asset for asset in used if not why[asset]]
        data["boxes"] = {
            asset: {"size": self._data.infos[asset].extents_m, "why": text}
            for asset, text in why.items()
            if text
        }
        data["others"] = self._models.others
        data["surfaces"] = self._models.surfaces(item.scene.home.structures)
        data["labels"] = []
        for label in labels:
            hazard = self._hazards.get(label.hazard)
            predicate = hazard.predicate if hazard is not None else None
            number, evidence = label.record.object_id, label.record.evidence
            marks = marks_of(number, evidence, predicate, facts, boxes)
            row = {"id": number, "kind": label.kind, "hazard": label.hazard, "key": label.key}
            data["labels"].append({**row, "title": label.title, "marks": marks})
        put(folder / DATA, call("scene", data))

    def _view(
        self,
        item: SceneItem,
        folder: Path,
        view: int,
        rooms: Mapping[int, str],
        family: Sequence[tuple[str, SceneItem]],
    ) -> ViewOnPage:
        camera = item.cameras[view]
        mask = depth = None
        if item.has(view, "instance.png"):
            mask = f"{view:02d}-mask.png"
            put(folder / mask, mask_png(item.instance(view)))
        if item.has(view, "depth.png"):
            depth = f"{view:02d}-depth.png"
            put(folder / depth, depth_png(item.depth_mm(view)))
        return ViewOnPage(
            index=view,
            kind=camera.kind,
            room=rooms.get(camera.room_id, "?"),
            width=camera.width,
            height=camera.height,
            rgb=_picture(folder, item, view),
            mask=mask,
            depth=depth,
            others=tuple(_picture(folder, other, view) for _, other in family),
            boxes=boxes_of(item, view),
        )


def _picture(folder: Path, item: SceneItem, view: int) -> str | None:
    """A view's colour picture as a link from a page's folder."""
    path = item.rgb_path(view)
    if path is None:
        return None
    target = item.folder / view_folder(view) / path.name
    relative = os.path.relpath(target.resolve(), folder.resolve())
    return quote(PurePosixPath(Path(relative).as_posix()).as_posix())
