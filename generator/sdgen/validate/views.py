"""One scene's views against its records: masks, boxes, evidence, depth."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import islice

import numpy as np

from sdgen.dataset import Dataset
from sdgen.dataset.reader import SceneItem
from sdgen.dataset.scene_folder import view_folder
from sdgen.errors import InputError
from sdgen.geometry import apply, inverse, matrix
from sdgen.library.records import AssetInfo
from sdgen.scene import Camera, ViewVisibility
from sdgen.truth.visibility import assemble, measure_masks, part_names
from sdgen.validate.labels import known_ids
from sdgen.validate.problems import SHOWN, Problem, differences

#: How far in front of or behind an object's box its pixels may lie: bevels, depth rounding, the
#: half pixel of an oblique face.
DEPTH_SLACK_M = 0.06
#: Share of an object's pixels that may lie farther off (silhouettes).
DEPTH_OUTLIERS = 0.02


def check_views(
    data: Dataset, item: SceneItem, infos: Mapping[str, AssetInfo]
) -> Iterator[Problem]:
    """Cameras, masks against graph and visibility, depth against boxes, pictures readable."""
    options, shown = data.info.options, item.visibility
    cameras = item.cameras
    if item.entry.views != options.views:
        text = f"views: {item.entry.views}, the options say {options.views}"
        yield Problem("view", f"manifest.jsonl: scene {item.id}: {text}")
    for k, camera in enumerate(cameras):
        where = item.where(f"{view_folder(k)}/view.json")
        for text in _camera(camera, k, data, {room.id for room in item.scene.home.rooms}):
            yield Problem("view", f"{where}: {text}")
    expected_views = list(range(len(cameras))) if options.sensors else []
    where = item.where("visibility.json")
    if [view.view for view in shown.views] != expected_views:
        yield Problem("view", f"{where}: views: not one entry a view, in order")
        return
    for view in shown.views:
        yield from _view(data, item, infos, view)
    derived = assemble(shown.views, item.anomalies.anomalies, options.width, options.height)
    for text in islice(differences(shown, derived), SHOWN):
        yield Problem("view", f"{where}: {text}")
    if item.entry.all_visible != derived.all_visible:
        yield Problem("view", f"manifest.jsonl: scene {item.id}: all_visible is not its files'")


def _camera(camera: Camera, k: int, data: Dataset, rooms: set[int]) -> Iterator[str]:
    options = data.info.options
    if camera.index != k:
        yield f"index: {camera.index}, expected {k}"
    if (camera.width, camera.height) != (options.width, options.height):
        yield f"size {camera.width}x{camera.height}: not that of the options"
    if camera.room_id not in rooms:
        yield f"room_id: no room {camera.room_id}"
    pose = np.asarray(camera.world_from_camera)
    turn = pose[:3, :3]
    if not np.allclose(turn @ turn.T, np.eye(3), atol=1e-5) or np.linalg.det(turn) < 0:
        yield "world_from_camera: not a rotation"
    if not np.array_equal(pose[3], [0, 0, 0, 1]):
        yield "world_from_camera: last row is not 0 0 0 1"
    (fx, skew, cx), (zero, fy, cy), last = camera.K
    centred = abs(cx - (camera.width - 1) / 2) < 1e-6 and abs(cy - (camera.height - 1) / 2) < 1e-6
    if not (fx > 0 and fy > 0 and centred and (skew, zero, *last) == (0, 0, 0, 0, 1)):
        yield "K: not a pinhole camera whose centre is the picture's"
    if not 0 < camera.near_m < camera.far_m:
        yield "near_m and far_m: not 0 < near < far"


def _view(
    data: Dataset, item: SceneItem, infos: Mapping[str, AssetInfo], view: ViewVisibility
) -> Iterator[Problem]:
    k, sensors = view.view, data.info.options.sensors
    try:
        if "rgb" in sensors and not np.ptp(item.rgb(k)):
            name = f"{view_folder(k)}/rgb.{data.info.options.rgb}"
            yield Problem("view", f"{item.where(name)}: one colour everywhere")
        depth = item.depth_mm(k) if "depth" in sensors else None
        if "instance" in sensors:
            yield from _masks(item, view)
            if depth is not None:
                yield from _depth(item, infos, k, depth, item.instance(k))
    except InputError as error:
        yield from (Problem("view", text) for text in error.problems)


def _masks(item: SceneItem, view: ViewVisibility) -> Iterator[Problem]:
    where = item.where(f"{view_folder(view.view)}/instance.png")
    parts_of = part_names(item.scene)
    found = measure_masks(item.instance(view.view), item.part(view.view), parts_of)
    for node_id in sorted(set(found) - known_ids(item.scene)):
        yield Problem("view", f"{where}: id {node_id} is no node of graph.json")
    stored = {
        thing.object_id: {"bbox": thing.bbox, "pixels": thing.pixels, "parts": thing.parts}
        for thing in view.objects
    }
    derived = {
        node_id: {"bbox": box, "pixels": pixels, "parts": parts}
        for node_id, (box, pixels, parts) in found.items()
        if node_id in parts_of
    }
    path = f"views[{view.view}].objects"
    for text in islice(differences(stored, derived, path), SHOWN):
        yield Problem("view", f"{item.where('visibility.json')}: {text}")
    ids = [thing.object_id for thing in view.objects]
    if ids != sorted(set(ids)):
        yield Problem("view", f"{item.where('visibility.json')}: {path}: not sorted by id")
    for thing in view.objects:
        if not 0 < thing.fraction <= 1:
            text = f"{path}: {thing.object_id}: fraction {thing.fraction} is not in (0, 1]"
            yield Problem("view", f"{item.where('visibility.json')}: {text}")


def _depth(
    item: SceneItem,
    infos: Mapping[str, AssetInfo],
    view: int,
    depth_mm: np.ndarray[tuple[int, ...], np.dtype[np.uint16]],
    instance: np.ndarray[tuple[int, ...], np.dtype[np.uint16]],
) -> Iterator[Problem]:
    where = item.where(f"{view_folder(view)}/depth.png")
    camera = item.cameras[view]
    if np.any((depth_mm > 0) & (instance == 0)) or np.any((depth_mm == 0) & (instance > 0)):
        yield Problem("view", f"{where}: depth and mask do not cover the same pixels")
    low, high = np.zeros(65536), np.full(65536, np.inf)
    camera_from_world = inverse(np.asarray(camera.world_from_camera))
    for thing in item.scene.objects:
        corners = _box_corners(thing.id, item, infos)
        if corners is not None:
            z = apply(camera_from_world, corners)[:, 2]
            low[thing.id], high[thing.id] = z.min() - DEPTH_SLACK_M, z.max() + DEPTH_SLACK_M
    metres = depth_mm / 1000.0
    off = ((metres < low[instance]) | (metres > high[instance])) & (depth_mm > 0)
    wrong = np.bincount(instance[off], minlength=65536)
    total = np.bincount(instance.reshape(-1), minlength=65536)
    for node_id in np.flatnonzero(wrong > np.maximum(8, DEPTH_OUTLIERS * total)).tolist():
        text = f"object {node_id}: {wrong[node_id]} of {total[node_id]} pixels are off its box"
        yield Problem("view", f"{where}: {text}")


def _box_corners(
    object_id: int, item: SceneItem, infos: Mapping[str, AssetInfo]
) -> np.ndarray[tuple[int, ...], np.dtype[np.float64]] | None:
    """Corners of an object's box; None when an open joint or another variant reaches beyond it."""
    thing = item.scene.object(object_id)
    if any(thing.joints.values()) or thing.variant != "default":
        return None
    x, y, z = infos[thing.asset].extents_m
    world = matrix(thing.pose.position_m, thing.pose.quat_xyzw)
    corners = [(a, b, c) for a in (-x / 2, x / 2) for b in (-y / 2, y / 2) for c in (0.0, z)]
    return apply(world, corners)
