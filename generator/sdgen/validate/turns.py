"""Turns and panoramas of one scene: whole, level, all the way round, stitched of their views."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

import numpy as np

from sdgen.cameras.turn import ROOM_TURN, panoramas_of, rings
from sdgen.dataset.item import SceneItem
from sdgen.dataset.scene_folder import panorama_folder, view_folder
from sdgen.errors import InputError
from sdgen.geometry import Array
from sdgen.options import BuildOptions
from sdgen.render.equirect import seen_by_turn, stitched_ids, stitched_rgb
from sdgen.scene import Camera, Panorama
from sdgen.validate.labels import known_ids
from sdgen.validate.problems import Problem

#: Poses of a turn are as exact as sums of eight digits.
_EXACT = 1e-6


def check_turns(item: SceneItem, options: BuildOptions) -> Iterator[Problem]:
    """Every turn against what a turn is, and every panorama against its views."""
    for camera in item.cameras:
        wrong = _kind(camera, options)
        if wrong is not None:
            where = item.where(f"{view_folder(camera.index)}/view.json")
            yield Problem("view", f"{where}: {wrong}")
            return
    if options.views_mode == "chosen":
        return
    found = rings(item.cameras)
    for ring in found:
        wrong = _turn(ring)
        if wrong is not None:
            where = item.where(f"{view_folder(ring[0].index)}/view.json")
            yield Problem("view", f"{where}: {wrong}")
            return
    turned = [ring[0].room_id for ring in found]
    if len(found) * ROOM_TURN != len(item.cameras) or len(set(turned)) != len(turned):
        text = f"views: {len(item.cameras)}, not a turn of {ROOM_TURN} in each of some rooms"
        yield Problem("view", f"manifest.jsonl: scene {item.id}: {text}")
    elif options.stitches:
        yield from _panoramas(item, options, found)


def _kind(camera: Camera, options: BuildOptions) -> str | None:
    if (camera.kind == "turn") != (camera.turn is not None):
        return "turn: only views of kind 'turn' have their place in one, and all of them"
    if (camera.kind == "turn") != (options.views_mode == "panorama"):
        return f"kind: {camera.kind!r}, the options say --views-mode {options.views_mode}"
    return None


def _turn(ring: Sequence[Camera]) -> str | None:
    places = [(one.turn.step, one.turn.of) for one in ring if one.turn is not None]
    if places != [(step, ROOM_TURN) for step in range(ROOM_TURN)]:
        return f"turn: not {ROOM_TURN} views one after another"
    if len({one.room_id for one in ring}) > 1:
        return "room_id: not that of the whole turn"
    poses = [np.asarray(one.world_from_camera) for one in ring]
    for step, pose in enumerate(poses):
        if not np.allclose(pose, _turned(poses[0], step), atol=_EXACT):
            return f"world_from_camera: step {step} is not level, in place and an equal step on"
    return None


def _turned(first: Array, step: int) -> Array:
    """A level pose that looks where the first one does, and ``step`` steps to the left."""
    yaw = math.atan2(first[1, 2], first[0, 2]) + step * 2 * math.pi / ROOM_TURN
    cosine, sine = math.cos(yaw), math.sin(yaw)
    out = np.eye(4)
    out[:3, :3] = [[sine, 0.0, cosine], [-cosine, 0.0, sine], [0.0, -1.0, 0.0]]
    out[:3, 3] = first[:3, 3]
    return out


def _panoramas(
    item: SceneItem, options: BuildOptions, found: Sequence[Sequence[Camera]]
) -> Iterator[Problem]:
    try:
        stored = [one.model_copy(update={"look": None}) for one in item.panoramas]
        if stored != list(panoramas_of(item.cameras)):
            yield Problem("view", f"{item.where('panoramas')}: not those of the turns")
            return
        for panorama, ring in zip(item.panoramas, found, strict=True):
            where = item.where(panorama_folder(panorama.index))
            for text in _panorama(item, options, panorama, ring):
                yield Problem("view", f"{where}/{text}")
    except InputError as error:
        yield from (Problem("view", text) for text in error.problems)


def _panorama(
    item: SceneItem, options: BuildOptions, panorama: Panorama, ring: Sequence[Camera]
) -> Iterator[str]:
    if (panorama.look is not None) != bool(options.look):
        given = "none" if panorama.look is None else "one"
        yield f"panorama.json: look: {given}, the options say {options.look}"
    turn = seen_by_turn(panorama, ring[0])
    if "instance" in options.sensors:
        ids = item.panorama_instance(panorama.index)
        masks = [item.instance(one.index) for one in ring]
        if not np.array_equal(ids[turn], stitched_ids(panorama, ring[0], masks)[turn]):
            yield "instance.png: not the masks of its views"
        for number in sorted(set(np.unique(ids).tolist()) - known_ids(item.scene) - {0}):
            yield f"instance.png: id {number} is no node of graph.json"
    if "rgb" in options.sensors:
        rgb = item.panorama_rgb(panorama.index)
        # Neither of pictures that were packed with loss nor of those with noise of their own.
        if options.rgb == "png" and panorama.look is None:
            pictures = [item.rgb(one.index) for one in ring]
            if not np.array_equal(rgb[turn], stitched_rgb(panorama, ring[0], pictures)[turn]):
                yield "rgb.png: not the pictures of its views"
