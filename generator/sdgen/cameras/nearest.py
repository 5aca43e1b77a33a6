"""How near to the camera drawing begins.

A depth buffer may have as few as sixteen bits. What one step of such a buffer measures goes with
1 / the nearest depth it can hold: from 0.05 m on, 7.6 mm at a distance of 5 m, and a pane 2 mm in
front of its door is drawn through it in a moiré; from 0.4 m on, 0.9 mm.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from sdgen.geometry import Array, apply, lowest_highest, moved_boxes
from sdgen.library import Library
from sdgen.library.states import object_from_part
from sdgen.scene import Camera, Scene

#: Depths to begin at, the best first. From 0.4 m on little is won, and few views have room for it.
_STEPS_M = (0.4, 0.3, 0.2, 0.1)


def drawn_boxes(library: Library, scene: Scene) -> Array:
    """World boxes, low and high corners (N, 2, 3), of all that is drawn: never too small."""
    pieces = [piece for structure in scene.home.structures for piece in structure.pieces]
    middles = np.array([piece.center_m for piece in pieces]).reshape(-1, 3)
    halves = np.array([piece.size_m for piece in pieces]).reshape(-1, 3) / 2
    shell = np.stack([middles - halves, middles + halves], axis=1)
    poses, boxes = [], []
    for item in scene.objects:
        info, box_of, pose = (
            library.info(item.asset),
            library.bounds(item.asset),
            item.pose.matrix(),
        )
        for name in info.variants[item.variant]:
            poses.append(pose @ object_from_part(info, name, item.joints))
            boxes.append(box_of[name])
    turns = np.array(poses).reshape(-1, 4, 4)
    return np.concatenate([shell, moved_boxes(turns, np.array(boxes).reshape(-1, 2, 3))])


def with_near_planes(cameras: Sequence[Camera], boxes: Array) -> tuple[Camera, ...]:
    """The cameras, each with the furthest near plane that none of the ``boxes`` (N, 2, 3) reaches
    before; its own where there is no better."""
    return tuple(
        camera.model_copy(update={"near_m": _nearest_depth_m(camera, boxes)}) for camera in cameras
    )


def cut_by_near_planes(cameras: Sequence[Camera], boxes: Array) -> bool:
    """Whether one of the ``boxes`` (N, 2, 3) may reach before the near plane of a camera."""
    return any(_reached(camera, camera.near_m, boxes) for camera in cameras)


def _nearest_depth_m(camera: Camera, boxes: Array) -> float:
    for depth in _STEPS_M:
        if depth <= camera.near_m:
            break
        if not _reached(camera, depth, boxes):
            return depth
    return camera.near_m


def _reached(camera: Camera, depth_m: float, boxes: Array) -> bool:
    """Whether a box reaches between a camera's eye and its picture ``depth_m`` away."""
    k, pose = np.asarray(camera.K), np.asarray(camera.world_from_camera)
    ends = np.array([(-0.5, -0.5), (camera.width - 0.5, camera.height - 0.5)])
    (left, top), (right, bottom) = (ends - k[:2, 2]) / k[[0, 1], [0, 1]]
    corners = np.array([(x, y, 1.0) for x in (left, right) for y in (top, bottom)])
    low, high = lowest_highest(apply(pose, [(0.0, 0.0, 0.0), *(corners * depth_m)]))
    meets = (boxes[:, 0] <= high).all(axis=1) & (boxes[:, 1] >= low).all(axis=1)
    return bool(meets.any())
