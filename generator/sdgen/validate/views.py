"""One scene's views against its records: masks, boxes, evidence, depth."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from itertools import islice

import numpy as np

from sdgen.cameras.outdoors import outer_openings
from sdgen.cameras.pinhole import FOV_X_RAD, intrinsics
from sdgen.dataset import Dataset
from sdgen.dataset.item import SceneItem
from sdgen.dataset.scene_folder import view_folder
from sdgen.errors import InputError
from sdgen.library.records import AssetInfo
from sdgen.scene import Camera, Home, ViewVisibility
from sdgen.truth.visibility import assemble, measure_masks, outdoors_seen, part_names
from sdgen.validate.colours import (
    AHEAD_FAINT,
    LEAST_FAINT,
    Ids,
    Rgb,
    follows_mask,
    looked_follows_mask,
)
from sdgen.validate.labels import known_ids
from sdgen.validate.problems import SHOWN, Problem, differences
from sdgen.validate.surfaces import off_surface
from sdgen.validate.turns import check_turns
from sdgen.validate.whose_room import not_in_room


def check_views(
    data: Dataset, item: SceneItem, infos: Mapping[str, AssetInfo]
) -> Iterator[Problem]:
    """Cameras, masks against graph and visibility, depth against boxes, pictures readable."""
    options, shown = data.info.options, item.visibility
    cameras = item.cameras
    if options.views_mode == "chosen" and item.entry.views != options.views:
        text = f"views: {item.entry.views}, the options say {options.views}"
        yield Problem("view", f"manifest.jsonl: scene {item.id}: {text}")
    yield from check_turns(item, options)
    for k, camera in enumerate(cameras):
        where = item.where(f"{view_folder(k)}/view.json")
        for text in _camera(camera, k, data, item.scene.home):
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


def _camera(camera: Camera, k: int, data: Dataset, home: Home) -> Iterator[str]:
    options = data.info.options
    if camera.index != k:
        yield f"index: {camera.index}, expected {k}"
    if (camera.width, camera.height) != (options.width, options.height):
        yield f"size {camera.width}x{camera.height}: not that of the options"
    pose = np.asarray(camera.world_from_camera)
    wrong = not_in_room(home, camera.room_id, float(pose[0, 3]), float(pose[1, 3]))
    if wrong is not None:
        yield wrong
    turn = pose[:3, :3]
    if not np.allclose(turn @ turn.T, np.eye(3), atol=1e-5) or np.linalg.det(turn) < 0:
        yield "world_from_camera: not a rotation"
    if not np.array_equal(pose[3], [0, 0, 0, 1]):
        yield "world_from_camera: last row is not 0 0 0 1"
    if not np.allclose(camera.K, intrinsics(camera.width, camera.height), rtol=1e-9, atol=1e-9):
        angle = math.degrees(FOV_X_RAD)
        yield f"K: not a pinhole camera of this size whose field of view is {angle:g} degrees"
    if camera.daylight not in (None, home.daylight):
        yield "daylight: not that of the home in scene.json"
    if not 0 < camera.near_m < camera.far_m:
        yield "near_m and far_m: not 0 < near < far"
    if (camera.look is not None) != bool(options.look):
        yield f"look: {'none' if camera.look is None else 'one'}, the options say {options.look}"


def _view(
    data: Dataset, item: SceneItem, infos: Mapping[str, AssetInfo], view: ViewVisibility
) -> Iterator[Problem]:
    k, sensors = view.view, data.info.options.sensors
    try:
        ids = item.instance(k) if "instance" in sensors else None
        if "rgb" in sensors:
            where = item.where(f"{view_folder(k)}/rgb.{data.info.options.rgb}")
            texts = _rgb(item.rgb(k), ids, item.cameras[k])
            yield from (Problem("view", f"{where}: {text}") for text in texts)
        depth = item.depth_mm(k) if "depth" in sensors else None
        if ids is not None:
            yield from _masks(item, view, ids)
        if ids is not None and depth is not None:
            where = item.where(f"{view_folder(k)}/depth.png")
            for text in _depth(item, infos, item.cameras[k], depth, ids):
                yield Problem("view", f"{where}: {text}")
    except InputError as error:
        yield from (Problem("view", text) for text in error.problems)


def _rgb(rgb: Rgb, ids: Ids | None, camera: Camera) -> Iterator[str]:
    if not np.ptp(rgb):
        # Somewhere on a turn there may be nothing but a wall.
        if camera.turn is None or (ids is not None and np.ptp(ids)):
            yield "one colour everywhere"
        return
    if ids is not None and not _follows(rgb, ids, camera):
        yield "shows something else than instance.png: its colours do not change where things end"


def _follows(rgb: Rgb, ids: Ids, camera: Camera) -> bool:
    if camera.look is not None:
        return looked_follows_mask(rgb, ids, camera.look)
    if camera.turn is not None:
        return follows_mask(rgb, ids, LEAST_FAINT, AHEAD_FAINT)
    return follows_mask(rgb, ids)


def _depth(
    item: SceneItem, infos: Mapping[str, AssetInfo], camera: Camera, depth_mm: Ids, ids: Ids
) -> Iterator[str]:
    if np.any((depth_mm > 0) != (ids > 0)):
        yield "depth and mask do not cover the same pixels"
    text = off_surface(item, infos, camera, depth_mm, ids)
    if text is not None:
        yield text


def _masks(item: SceneItem, view: ViewVisibility, ids: Ids) -> Iterator[Problem]:
    where = item.where(f"{view_folder(view.view)}/instance.png")
    parts_of = part_names(item.scene)
    found = measure_masks(ids, item.part(view.view), parts_of)
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
    path = f"views[{view.view}]"
    for text in islice(differences(stored, derived, f"{path}.objects"), SHOWN):
        yield Problem("view", f"{item.where('visibility.json')}: {text}")
    if view.outdoors is not None:
        openings = outer_openings(item.scene.home)
        outdoors = outdoors_seen(ids, item.cameras[view.view], openings)
        for text in islice(differences(view.outdoors, outdoors, f"{path}.outdoors"), SHOWN):
            yield Problem("view", f"{item.where('visibility.json')}: {text}")
    path += ".objects"
    listed = [thing.object_id for thing in view.objects]
    if listed != sorted(set(listed)):
        yield Problem("view", f"{item.where('visibility.json')}: {path}: not sorted by id")
    for thing in view.objects:
        if not 0 < thing.fraction <= 1:
            text = f"{path}: {thing.object_id}: fraction {thing.fraction} is not in (0, 1]"
            yield Problem("view", f"{item.where('visibility.json')}: {text}")
