"""Near views: where to stand to look at one thing, by rays alone."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import shapely
from shapely.geometry.base import BaseGeometry

from sdgen.cameras.parts import part_numbers, part_points
from sdgen.cameras.sight import Cast, estimate_pixels, in_picture
from sdgen.cameras.view import HEIGHT_JITTER_M, View, clear, free_area
from sdgen.facts import room_at
from sdgen.geometry import Array, Vec2, look_at, rotation_matrix, vec3
from sdgen.library import Library
from sdgen.options import EYE_HEIGHT_M
from sdgen.scene import ObjectInstance, Scene
from sdgen.seeding import Rng
from sdgen.vocabulary import EVIDENCE_PIXELS

#: A near view counts when rays promise this many pixels at the reference size: twice what is
#: needed, since rays are few and pictures exact.
PIXELS_NEEDED = 2 * EVIDENCE_PIXELS

#: Near enough to tell what a thing is, far enough for a robot that wants to look at it.
_DISTANCE_M = (0.8, 2.2)
# Furniture is looked at from further away: this much of its size beyond a metre is added, or
# only a piece of it would be in the picture.
_DISTANCE_PER_SIZE = 0.6
# What stands on the floor is seen with the floor around it: whether it is in the way depends on
# where it lies. Small things and narrow things would be lost from there.
_FLOOR_FURTHER_M = 0.9
_FLOOR_LOW_M = 0.1
_FLOOR_TOP_M = 0.5
_FLOOR_WIDTH_M = 0.12
_FLOOR_ENOUGH_PIXELS = 2500.0
_CANDIDATES = 32
# Points thrown into the ring so that enough fall on the free floor, a fortieth of it at worst.
_DRAWS = 40 * _CANDIDATES
# Few rays choose among candidates, many count the pixels of the best until one is enough.
_ROUGH_GRID = 6
_FINALISTS = 8
# Beyond this many pixels, or half of the most, more is not better, so that near views differ.
_ENOUGH_PIXELS = 12000.0
# Candidates that show as much are told apart by chance: up to this share of the pixels is let go.
_FADE = (0.8, 1.0)
# How far beside the target a camera may aim, as tangents to the right and down: a fifth of the way
# to the picture's edges (tan 35 and tan 27.7 degrees).
_BESIDE = (0.14, 0.1)
# A view that cuts a thing off keeps a quarter of its worth, one from behind furniture 0.6.
_CUT_OFF = 0.25
_FRONT, _SIDE = 0.2, 0.8


@dataclass(frozen=True)
class Target:
    """Something a near view shows: an object, and the parts that matter (empty = all)."""

    object_id: int
    parts: tuple[str, ...] = ()


def best_near_pose(
    library: Library,
    scene: Scene,
    cast: Cast,
    target: Target,
    rng: Rng,
    eye_height_m: float = EYE_HEIGHT_M,
    pixels_needed: float = PIXELS_NEEDED,
    rounds: int = 1,
) -> View | None:
    """About the best of 32 views 0.8 to 2.2 m from a target, or None when none shows enough of it.

    The target is not quite in the middle of the picture. Up to ``rounds`` times 32 views are drawn,
    until some show enough. Only rays decide, so a placement can be rejected on None before any
    picture exists.
    """
    item = scene.object(target.object_id)
    points = part_points(library, item, target.parts)
    # Aimed at the whole object whatever its parts: a lit burner must not be more central than
    # a cold one is.
    whole = part_points(library, item, ())
    centre = (whole.min(axis=0) + whole.max(axis=0)) / 2
    _, width, size = np.sort(np.ptp(whole, axis=0)).tolist()
    further = _DISTANCE_PER_SIZE * max(size - 1.0, 0.0)
    low, top = float(whole[:, 2].min()), float(whole[:, 2].max())
    on_floor = low < _FLOOR_LOW_M and top < _FLOOR_TOP_M and width > _FLOOR_WIDTH_M
    if on_floor:
        further += _FLOOR_FURTHER_M
    numbers = part_numbers(library, item, target.parts)
    free = free_area(scene)
    for _ in range(rounds):
        stands = _stands_around(free, (float(centre[0]), float(centre[1])), further, rng)
        if len(stands) == 0:
            return None
        heights = eye_height_m + rng.uniform(-HEIGHT_JITTER_M, HEIGHT_JITTER_M, len(stands))
        aims = rng.uniform(-1.0, 1.0, (len(stands), 2))
        fade = rng.uniform(*_FADE, len(stands))
        eyes = np.column_stack([stands, heights])
        poses = [_aimed(eye, centre, aim) for eye, aim in zip(eyes, aims, strict=True)]
        rough = estimate_pixels(cast, poses, points, item.id, numbers, _ROUGH_GRID)
        enough = _FLOOR_ENOUGH_PIXELS if on_floor else max(_ENOUGH_PIXELS, 0.5 * float(rough.max()))
        worth = np.minimum(rough, enough) * fade
        shows = np.flatnonzero(worth > 0)
        worth[shows] *= clear(cast, eyes[shows])
        for k in np.flatnonzero(worth > 0).tolist():
            worth[k] *= _framing(poses[k], whole, item)
        for k in np.argsort(-worth, kind="stable")[:_FINALISTS].tolist():
            if worth[k] <= 0:
                break
            (pixels,) = estimate_pixels(cast, [poses[k]], points, item.id, numbers)
            if pixels >= pixels_needed:
                room = room_at(scene.home.rooms, *stands[k].tolist())
                if room is not None:
                    return View("near", room.id, poses[k])
    return None


def _framing(pose: Array, points_m: Array, item: ObjectInstance) -> float:
    """How well a view shows what the thing is: all of it in the picture, and from its front."""
    inside = float(in_picture(pose, points_m).mean())
    front = rotation_matrix(item.pose.quat_xyzw)[:2, 0]
    towards = pose[:2, 3] - np.asarray(item.pose.position_m[:2])
    facing = float(front @ towards) / max(float(np.linalg.norm(towards)), 1e-9)
    cut_off = _CUT_OFF + (1.0 - _CUT_OFF) * inside
    return cut_off * (_SIDE + _FRONT * facing if item.fixed else 1.0)


def _stands_around(free: BaseGeometry, centre: Vec2, further_m: float, rng: Rng) -> Array:
    """Up to 32 points of the free area in the ring around ``centre``, (N, 2)."""
    low, high = (limit + further_m for limit in _DISTANCE_M)
    distance = np.sqrt(rng.uniform(low**2, high**2, _DRAWS))
    angle = rng.uniform(-math.pi, math.pi, _DRAWS)
    points = np.array(centre) + distance[:, None] * np.column_stack([np.cos(angle), np.sin(angle)])
    inside = shapely.contains_xy(free, points[:, 0], points[:, 1])
    return np.asarray(points[inside][:_CANDIDATES], dtype=np.float64)


def _aimed(eye: Array, centre: Array, aim: Array) -> Array:
    """Look at ``centre`` or a little beside it: ``aim`` from (-1, -1) to (1, 1)."""
    straight = look_at(vec3(eye), vec3(centre))
    reach = float(np.linalg.norm(centre - eye))
    beside = straight[:3, 0] * aim[0] * _BESIDE[0] + straight[:3, 1] * aim[1] * _BESIDE[1]
    return look_at(vec3(eye), vec3(centre + reach * beside))
