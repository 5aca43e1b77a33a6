"""The things placed so far, and where there is room for one more.

Placement is proposed in 2-D with height ranges (cheap); physics proves it later. Everything is a
value: a spot that does not fit is None.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from shapely.affinity import rotate, translate
from shapely.geometry import MultiPoint, Point, Polygon
from shapely.geometry import box as shapely_box
from shapely.geometry.base import BaseGeometry
from shapely.prepared import prep

from sdgen.actions import at_rest
from sdgen.freespace import random_point
from sdgen.geometry import (
    Vec3,
    apply,
    box_corners,
    matrix,
    quat_from_yaw,
    round_position,
    round_quat,
    yaw_of,
)
from sdgen.library import Library
from sdgen.library.records import AssetInfo, Support
from sdgen.library.states import object_from_part
from sdgen.scene import ObjectInstance, Pose
from sdgen.seeding import Rng

DROP_M = 0.003
GAP_M = 0.01
TRIES = 12
#: Openings sit in walls: only an open leaf takes space in a room.
OPENINGS = ("door", "front_door", "window")
#: Objects this thin lie flat and may be stood on by furniture (rugs, mats).
FLAT_M = 0.03


@dataclass(frozen=True)
class Block:
    """Space an object takes: a footprint and a height range."""

    owner: int
    shape: BaseGeometry
    low_m: float
    high_m: float


@dataclass(frozen=True)
class Intent:
    """What a placement is meant to be: checked again after settling."""

    relation: str
    target_id: int


class Layout:
    """Objects placed so far with the space they take. One per attempt; not shared."""

    def __init__(self, library: Library, ids: Iterator[int]) -> None:
        self.library = library
        self.ids = ids
        self.items: dict[int, ObjectInstance] = {}
        self.intents: dict[int, Intent] = {}
        self._blocks: dict[int, list[Block]] = {}

    def info(self, object_id: int) -> AssetInfo:
        """Asset record of a placed object."""
        return self.library.info(self.items[object_id].asset)

    def put(self, item: ObjectInstance, intent: Intent | None = None) -> None:
        """Add an object, or replace the one of the same id."""
        self.items[item.id] = item
        self._blocks[item.id] = self.blocks_of(item)
        if intent is not None:
            self.intents[item.id] = intent

    def drop(self, object_id: int) -> None:
        """Take an object out again."""
        del self.items[object_id]
        self._blocks.pop(object_id, None)
        self.intents.pop(object_id, None)

    def copy(self) -> Layout:
        """An independent layout with the same objects (ids are drawn from the same source)."""
        out = Layout(self.library, self.ids)
        out.items, out.intents = dict(self.items), dict(self.intents)
        out._blocks = dict(self._blocks)
        return out

    def blocks_of(self, item: ObjectInstance) -> list[Block]:
        """Space of an object's body, and of each part that a joint holds open.

        Open-framed furniture (tables, chairs) takes the space of its collision pieces, so that a
        chair goes under a table; everything else takes its box.
        """
        info = self.library.info(item.asset)
        world = matrix(item.pose.position_m, item.pose.quat_xyzw)
        drawn = info.variants[item.variant]
        out = []
        if item.fixed and not info.containers and item.category not in OPENINGS:
            for hull in self.library.hulls(item.asset):
                if hull.part in drawn:
                    moved = world @ object_from_part(info, hull.part, item.joints)
                    out.append(_block(item.id, apply(moved, hull.vertices_m)))
            if out:
                return out
        if item.category not in OPENINGS:
            x, y, z = info.extents_m
            corners = apply(world, box_corners((-x / 2, -y / 2, 0), (x / 2, y / 2, z)))
            out.append(_block(item.id, corners))
        for name in drawn:
            joint = info.part(name).joint
            if joint is None or abs(item.joints.get(joint, 0.0)) < 0.05:
                continue
            vertices = self.library.mesh(item.asset)[name].vertices
            corners = box_corners(vertices.min(axis=0).tolist(), vertices.max(axis=0).tolist())
            moved = world @ object_from_part(info, name, item.joints)
            out.append(_block(item.id, apply(moved, corners)))
        return out

    def clashes(
        self, blocks: list[Block], ignore: tuple[int, ...] = (), gap_m: float = GAP_M
    ) -> int | None:
        """Id of an object whose space these blocks would enter; None when they fit."""
        for block in blocks:
            shape = block.shape.buffer(gap_m, join_style="mitre") if gap_m else block.shape
            x0, y0, x1, y1 = shape.bounds
            for owner, others in self._blocks.items():
                if owner == block.owner or owner in ignore:
                    continue
                for other in others:
                    if block.low_m >= other.high_m - 1e-4 or other.low_m >= block.high_m - 1e-4:
                        continue
                    a, b, c, d = other.shape.bounds
                    if x1 <= a or c <= x0 or y1 <= b or d <= y0:
                        continue
                    if shape.intersects(other.shape):
                        return owner
        return None

    # --- spots -----------------------------------------------------------------------------------

    def spot_on_object(
        self, asset: AssetInfo, target_id: int, relation: str, rng: Rng
    ) -> Vec3Yaw | None:
        """A free spot on (or inside) a placed object for a new thing of this asset."""
        target = self.items[target_id]
        info = self.info(target_id)
        drawn = info.variants[target.variant]
        world = matrix(target.pose.position_m, target.pose.quat_xyzw)
        supports = [
            s
            for s in info.supports
            if s.part in drawn and (s.container is None) == (relation == "ON")
        ]
        if not supports:
            return self._spot_in_hollow(asset, target_id, rng) if relation == "INSIDE" else None
        areas = np.array([Polygon(s.polygon_m).area for s in supports])
        for _ in range(TRIES):
            support = supports[int(rng.choice(len(supports), p=areas / areas.sum()))]
            spot = self._try_support(asset, target_id, info, support, world, rng)
            if spot is not None:
                return spot
        return None

    def _try_support(
        self,
        asset: AssetInfo,
        target_id: int,
        info: AssetInfo,
        support: Support,
        world: np.ndarray[tuple[int, ...], np.dtype[np.float64]],
        rng: Rng,
    ) -> Vec3Yaw | None:
        yaw = random_yaw(rng, yaw_of(self.items[target_id].pose.quat_xyzw))
        if support.headroom_m is not None and asset.extents_m[2] > support.headroom_m - 0.015:
            return None
        local = object_from_part(info, support.part, self.items[target_id].joints)
        points = apply(world @ local, [(x, y, support.z_m) for x, y in support.polygon_m])
        surface = Polygon(points[:, :2])
        z = float(points[:, 2].mean())
        point = random_point(surface, rng)
        if point is None:
            return None
        print_ = footprint(asset, point[0], point[1], yaw)
        if print_.intersection(surface).area < 0.97 * print_.area:
            return None
        block = Block(-1, print_, z + 0.001, z + asset.extents_m[2] + DROP_M)
        if self.clashes([block], ignore=(target_id,)) is not None:
            return None
        return (point[0], point[1], z), yaw

    def _spot_in_hollow(self, asset: AssetInfo, target_id: int, rng: Rng) -> Vec3Yaw | None:
        target, info = self.items[target_id], self.info(target_id)
        if not info.containers:
            return None
        container = info.containers[int(rng.integers(len(info.containers)))]
        if any(a > b for a, b in zip(asset.extents_m, container.size_m, strict=True)):
            return None
        if any(intent == Intent("INSIDE", target_id) for intent in self.intents.values()):
            return None
        world = matrix(target.pose.position_m, target.pose.quat_xyzw)
        moved = world @ object_from_part(info, container.part, target.joints)
        bottom = list(container.center_m)
        bottom[2] -= container.size_m[2] / 2
        x, y, z = apply(moved, [bottom])[0]
        return (float(x), float(y), float(z)), random_yaw(rng)

    def spot_on_floor(
        self,
        asset: AssetInfo,
        area: BaseGeometry,
        rng: Rng,
        keep_share: float = 0.0,
        avoid: BaseGeometry | None = None,
        avoid_share: float = 0.25,
    ) -> Vec3Yaw | None:
        """A free spot on the floor with its centre in ``area``.

        At least ``keep_share`` of the footprint lies in ``area``, at most ``avoid_share`` in
        ``avoid``.
        """
        barred = prep(avoid) if avoid is not None and not avoid.is_empty else None
        for _ in range(TRIES):
            point = random_point(area, rng)
            yaw = random_yaw(rng)
            if point is None:
                return None
            print_ = footprint(asset, point[0], point[1], yaw)
            if keep_share and print_.intersection(area).area < keep_share * print_.area:
                continue
            if (
                avoid is not None
                and barred is not None
                and barred.intersects(print_)
                and print_.intersection(avoid).area > avoid_share * print_.area
            ):
                continue
            block = Block(-1, print_, 0.0, asset.extents_m[2] + DROP_M)
            if self.clashes([block], gap_m=0.03) is None:
                return (point[0], point[1], 0.0), yaw
        return None

    def new_item(
        self, asset: AssetInfo, spot: Vec3Yaw, room_id: int, lift_m: float = DROP_M
    ) -> ObjectInstance:
        """A new object of ``asset`` at a spot, ``lift_m`` above its surface."""
        (x, y, z), yaw = spot
        item = ObjectInstance(
            id=next(self.ids),
            category=asset.category,
            asset=asset.id,
            pose=Pose(
                position_m=round_position((x, y, z + lift_m)),
                quat_xyzw=round_quat(quat_from_yaw(yaw)),
            ),
            room_id=room_id,
        )
        return at_rest(item, asset)


Vec3Yaw = tuple[Vec3, float]


def random_yaw(rng: Rng, square_to: float = 0.0) -> float:
    """A heading: people put things roughly square to what is under them, or any way round."""
    if rng.random() < 0.6:
        return float(square_to + rng.integers(4) * math.pi / 2 + rng.normal(0.0, 0.08))
    return float(rng.uniform(-math.pi, math.pi))


def footprint(asset: AssetInfo, x: float, y: float, yaw: float) -> Polygon:
    """The asset's box seen from above at a place and heading."""
    w, d = asset.extents_m[0] / 2, asset.extents_m[1] / 2
    shape = rotate(shapely_box(-w, -d, w, d), yaw, origin=(0, 0), use_radians=True)
    return translate(shape, x, y)


def _block(owner: int, corners: np.ndarray[tuple[int, ...], np.dtype[np.float64]]) -> Block:
    shape = MultiPoint(corners[:, :2]).convex_hull
    if shape.area < 1e-6:
        shape = Point(corners[:, :2].mean(axis=0)).buffer(0.005)
    return Block(owner, shape, float(corners[:, 2].min()), float(corners[:, 2].max()))
