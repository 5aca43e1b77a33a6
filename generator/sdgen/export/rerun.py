"""Scenes as recordings for the Rerun viewer: ``000041.rrd`` each.

``world/rooms`` are outlines, ``world/objects`` boxes named by category, ``world/anomalies`` and
``world/lookalikes`` those boxes again in red and blue, with what is wrong. Below
``world/cameras/00`` are a view's camera, its picture, depth, mask and the boxes of hazards in it.
``household`` is text. https://rerun.io/docs
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from sdgen.dataset import Dataset, SceneItem
from sdgen.dataset.derived import derived_from
from sdgen.dataset.output_folder import output_folder
from sdgen.export.formats import OnScene
from sdgen.export.rows import picture_files
from sdgen.export.shards import groups, scenes_in
from sdgen.scene import Camera

RED, BLUE, GREY = (220, 40, 50), (40, 110, 230), (150, 150, 150)


def export_rerun(data: Dataset, output: Path, on_scene: OnScene = None) -> None:
    """Write a recording a scene, twins too, into a new folder.

    Rerun numbers what it writes anew each time: the same data set gives other bytes. Raises
    SdgenError for a bad place, InputError for a file that is missing or changed,
    ModuleNotFoundError without rerun (pip install sdgen[rerun]).
    """
    import rerun

    total, done = scenes_in(data), 0
    with output_folder(output) as folder:
        for _, _, items in groups(data):
            for item in items:
                with derived_from(data, item):
                    _write(rerun, data, item, folder / f"{item.id}.rrd")
                # What a recording holds is kept until this is asked for (0.41): 3 MB a scene.
                rerun.bindings.flush_and_cleanup_orphaned_recordings()  # type: ignore[attr-defined]
                done += 1
                if on_scene is not None:
                    on_scene(done, total)


def _write(rerun: Any, data: Dataset, item: SceneItem, path: Path) -> None:
    name = f"sdgen-n{data.info.n}-s{data.info.seed}"
    stream = rerun.RecordingStream(name, recording_id=f"{name}-{item.id}")
    stream.save(path)
    _Recording(rerun, stream, item).write()
    stream.disconnect()


class _Recording:
    """One scene's recording in the making. Nothing in it moves: all is static."""

    def __init__(self, rerun: Any, stream: Any, item: SceneItem) -> None:
        self._rr = rerun
        self._stream = stream
        self._item = item
        self._nodes = {node.id: node for node in item.scene_graph.nodes}

    def write(self) -> None:
        """Log everything."""
        rr, item = self._rr, self._item
        self._log("world", rr.ViewCoordinates.RIGHT_HAND_Z_UP)
        names = [
            rr.AnnotationInfo(id=node.id, label=node.class_name) for node in self._nodes.values()
        ]
        self._log("world", rr.AnnotationContext(names))
        self._log("household", rr.TextDocument(_household(item), media_type="text/markdown"))
        rooms = item.scene.home.rooms
        outlines = [[(*point, 0.0) for point in (*r.polygon_m, r.polygon_m[0])] for r in rooms]
        labels = [room.name for room in rooms]
        self._log("world/rooms", rr.LineStrips3D(outlines, labels=labels, colors=[GREY]))
        things = [thing.id for thing in item.scene.objects]
        self._boxes("world/objects", things, [self._nodes[i].class_name for i in things], GREY)
        wrong = {a.object_id: f"{a.hazard}: {a.message}" for a in item.anomalies.anomalies}
        self._boxes("world/anomalies", list(wrong), list(wrong.values()), RED)
        near = {n.object_id: f"no {n.near_miss_of}" for n in item.anomalies.lookalikes}
        self._boxes("world/lookalikes", list(near), list(near.values()), BLUE)
        for camera in item.cameras:
            self._view(camera, wrong, near)

    def _log(self, path: str, thing: Any) -> None:
        self._stream.log(path, thing, static=True)

    def _boxes(
        self, path: str, ids: Sequence[int], labels: Sequence[str], color: tuple[int, int, int]
    ) -> None:
        if not ids:
            return
        boxes = [self._nodes[number].bounding_box for number in ids]
        self._log(
            path,
            self._rr.Boxes3D(
                centers=[box.center for box in boxes],
                sizes=[box.size for box in boxes],
                labels=labels,
                colors=[color],
                show_labels=color != GREY,
            ),
        )

    def _view(self, camera: Camera, wrong: dict[int, str], near: dict[int, str]) -> None:
        rr, item, index = self._rr, self._item, camera.index
        path = f"world/cameras/{index:02d}"
        pose = np.asarray(camera.world_from_camera)
        self._log(path, rr.Transform3D(translation=pose[:3, 3], mat3x3=pose[:3, :3]))
        self._log(
            path,
            rr.Pinhole(
                image_from_camera=np.asarray(camera.K),
                resolution=(camera.width, camera.height),
                camera_xyz=rr.ViewCoordinates.RDF,
            ),
        )
        pictures = picture_files(item, index)
        files = {column: item.file(name) for column, name in pictures.items()}
        if "image" in files:
            kind = "image/png" if pictures["image"].endswith("png") else "image/jpeg"
            self._log(f"{path}/rgb", rr.EncodedImage(contents=files["image"], media_type=kind))
        if "depth" in files:
            depth = rr.EncodedDepthImage(blob=files["depth"], media_type="image/png", meter=1000.0)
            self._log(f"{path}/depth", depth)
        if "instance" in files:
            self._log(f"{path}/mask", rr.SegmentationImage(item.instance(index)))
        seen = {
            o.object_id: o.bbox for v in item.visibility.views if v.view == index for o in v.objects
        }
        shown = [number for number in (*wrong, *near) if number in seen]
        if shown:
            self._log(
                f"{path}/hazards",
                rr.Boxes2D(
                    array=[seen[number] for number in shown],
                    array_format=rr.Box2DFormat.XYWH,
                    labels=[(wrong | near)[number] for number in shown],
                    colors=[RED if number in wrong else BLUE for number in shown],
                ),
            )


def _household(item: SceneItem) -> str:
    household = item.household
    people = ", ".join(f"{member.role} ({member.age})" for member in household.members)
    wishes = [f"- {hazard}: {choice}" for hazard, choice in sorted(household.notifications.items())]
    lines = [f"**{household.template}**: {people}", *household.pets, *household.conditions, *wishes]
    return "\n\n".join(lines)
