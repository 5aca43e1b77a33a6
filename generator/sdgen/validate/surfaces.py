"""Camera, depth, mask and poses against each other: every pixel lies on what the mask says."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

import numpy as np
import numpy.typing as npt

from sdgen.dataset.item import SceneItem
from sdgen.geometry import Array, apply, inverse
from sdgen.library.drawn import drawn
from sdgen.library.records import AssetInfo
from sdgen.scene import Box, Camera, ObjectInstance

Pixels = npt.NDArray[np.uint16]

# How far a pixel may lie off its surface, for each metre of depth (from one metre on), and in
# pixels: whichever is more. Rounding and 32-bit depth make 1.8 mm at most with EGL; TinyRenderer
# snaps to corners of pixels, 0.7 of one (3.1 mm a metre at 320x240). In 240 views of 20 scenes; a
# camera 5 cm astray makes more somewhere in each of them.
_SLACK, _SLACK_PIXELS = 0.005, 1.0
#: Share of the pixels looked at, and number of them, that may still be off.
_SHARE, _FEW = 0.0005, 3
#: Pixels looked at in a view, about: a regular grid of them tells as much as all.
_LOOKED_AT = 20_000


def off_surface(
    item: SceneItem, infos: Mapping[str, AssetInfo], camera: Camera, depth_mm: Pixels, ids: Pixels
) -> str | None:
    """What is wrong when pixels, put into the world by camera and depth, are not on the walls,
    floors and objects (H, W) ``ids`` names; None when they are.

    Structures are met exactly; of an object the box of its outline, along its own axes.
    """
    step = max(1, round(math.sqrt(ids.size / _LOOKED_AT)))
    z, seen = depth_mm[::step, ::step].ravel() / 1000.0, ids[::step, ::step].ravel()
    points = _in_world(camera, z, step)
    off = np.zeros(len(z))
    structures = {structure.id: structure for structure in item.scene.home.structures}
    things = {thing.id: thing for thing in item.scene.objects}
    for node_id in np.unique(seen[z > 0]).tolist():
        here = (seen == node_id) & (z > 0)
        if node_id in structures:
            off[here] = _off_boxes(points[here], structures[node_id].pieces)
        elif node_id in things:
            off[here] = _off_object(points[here], things[node_id], infos)
    bad = off > max(_SLACK, _SLACK_PIXELS / camera.K[0][0]) * np.maximum(z, 1.0)
    if bad.sum() <= max(_FEW, _SHARE * len(z)):
        return None
    worst = int(np.bincount(seen[bad]).argmax())
    metres = float(np.median(off[bad & (seen == worst)]))
    return (
        f"{bad.sum() / len(z):.1%} of the pixels lie off what the mask says, those of {worst} by "
        f"{metres:.3f} m: camera, depth, mask and poses disagree"
    )


def _in_world(camera: Camera, z: Array, step: int) -> Array:
    """Points (N, 3) of every ``step``-th pixel at the depths ``z`` (N,)."""
    k = np.asarray(camera.K)
    rows, columns = np.mgrid[0 : camera.height : step, 0 : camera.width : step]
    x, y = (columns.ravel() - k[0, 2]) / k[0, 0], (rows.ravel() - k[1, 2]) / k[1, 1]
    return apply(np.asarray(camera.world_from_camera), np.stack([x * z, y * z, z], axis=1))


def _off_boxes(points: Array, boxes: Sequence[Box]) -> Array:
    """Distance (N,) to the nearest surface of some boxes, from outside or inside."""
    nearest = np.full(len(points), np.inf)
    for box in boxes:
        beyond = np.abs(points - box.center_m) - np.asarray(box.size_m) / 2
        outside = np.linalg.norm(np.maximum(beyond, 0), axis=1)
        inside = np.maximum(-beyond.max(axis=1), 0)
        nearest = np.minimum(nearest, np.maximum(outside, inside))
    return nearest


def _off_object(points: Array, thing: ObjectInstance, infos: Mapping[str, AssetInfo]) -> Array:
    """How far outside its box points (N,) of an object lie."""
    low, high = drawn(infos[thing.asset], thing.variant, thing.joints).box_m
    own = apply(inverse(thing.pose.matrix()), points)
    beyond = np.maximum(low - own, own - high)
    return np.asarray(np.maximum(beyond, 0).max(axis=1), dtype=np.float64)
