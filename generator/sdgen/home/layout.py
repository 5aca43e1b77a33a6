"""The things placed so far, and where there is room for one more.

Placement is proposed in 2-D with height ranges (cheap); physics proves it later. Everything is a
value: a spot that does not fit is None.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass

import numpy as np
import shapely
from shapely.geometry import Point, Polygon
from shapely.geometry.base import BaseGeometry

from sdgen.actions import at_rest
from sdgen.freespace import opening_rectangle, random_point
from sdgen.geometry import (
    Array,
    Vec3,
    apply,
    box_corners,
    quat_from_yaw,
    round_position,
    round_quat,
    yaw_of,
)
from sdgen.library import Library
from sdgen.library.records import AssetInfo, Support
from sdgen.library.states import object_from_part
from sdgen.scene import Home, ObjectInstance, Opening, Pose
from sdgen.seeding import Rng
from sdgen.vocabulary import HALF_WALL_M, OPENINGS

#: Things start this far above what they stand on: a contact at the start would push them.
DROP_M = 0.001
#: Left between things: room to settle without touching.
GAP_M = 0.01
#: Spots drawn for a thing on one target; of 2,100 spots found two fifths were the first, one in a
#: hundred the twelfth.
TRIES = 12
#: What may reach into a wall: less than physics calls a penetration.
IN_WALL_M = 0.003
#: A hole in a wall reaches this far to both sides of its middle, past half a wall.
HOLE_DEPTH_M = HALF_WALL_M + 0.01


@dataclass(frozen=True)
class Block:
    """Space an object takes: a footprint and a height range."""

    owner: int
    shape: BaseGeometry
    low_m: float
    high_m: float


@dataclass(frozen=True)
class _Table:
    """Blocks in the order they were put, and (N, 6): their bounds seen from above and heights."""

    blocks: tuple[Block, ...]
    boxes: Array

    @staticmethod
    def of(blocks: Sequence[Block]) -> _Table:
        bounds = shapely.bounds(np.array([one.shape for one in blocks], dtype=object))
        heights = np.array([(one.low_m, one.high_m) for one in blocks])
        return _Table(tuple(blocks), np.hstack([bounds.reshape(-1, 4), heights.reshape(-1, 2)]))

    def more(self, blocks: Sequence[Block]) -> _Table:
        """The table with these blocks at its end."""
        added = _Table.of(blocks)
        return _Table(self.blocks + added.blocks, np.concatenate([self.boxes, added.boxes]))


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
        self._table: _Table | None = None

    def info(self, object_id: int) -> AssetInfo:
        """Asset record of a placed object."""
        return self.library.info(self.items[object_id].asset)

    def put(self, item: ObjectInstance, intent: Intent | None = None) -> None:
        """Add an object, or replace the one of the same id."""
        blocks = self.blocks_of(item)
        if self._table is not None:
            new = item.id not in self.items
            self._table = self._table.more(blocks) if new else None
        self.items[item.id] = item
        self._blocks[item.id] = blocks
        if intent is not None:
            self.intents[item.id] = intent

    def drop(self, object_id: int) -> None:
        """Take an object out again."""
        del self.items[object_id]
        self._blocks.pop(object_id, None)
        self._table = None
        self.intents.pop(object_id, None)

    def copy(self, ids: Iterator[int] | None = None) -> Layout:
        """An independent layout with the same objects; new ones get their ids from ``ids``, or
        from the same source."""
        out = Layout(self.library, ids or self.ids)
        out.items, out.intents = dict(self.items), dict(self.intents)
        out._blocks, out._table = dict(self._blocks), self._table
        return out

    def blocks_of(self, item: ObjectInstance) -> list[Block]:
        """Space of an object's body, and of each part that a joint holds open.

        Open-framed furniture (tables, chairs) takes the space of its collision pieces, so that a
        chair goes under a table; everything else takes its box.
        """
        info = self.library.info(item.asset)
        world = item.pose.matrix()
        drawn = info.variants[item.variant]
        # Openings sit in walls: only an open leaf takes space in a room.
        if item.fixed and not info.containers and item.category not in OPENINGS:
            moves = {part: world @ object_from_part(info, part, item.joints) for part in drawn}
            hulls = [hull for hull in self.library.hulls(item.asset) if hull.part in moves]
            if hulls:
                return _blocks(item.id, [apply(moves[h.part], h.vertices_m) for h in hulls])
        corners = []
        if item.category not in OPENINGS:
            x, y, z = info.extents_m
            box = box_corners((-x / 2, -y / 2, 0), (x / 2, y / 2, z))
            corners.append(apply(world, box))
        for name in drawn:
            joint = info.part(name).joint
            if joint is None or abs(item.joints.get(joint, 0.0)) < 0.05:
                continue
            vertices = self.library.mesh(item.asset)[name].vertices
            box = box_corners(vertices.min(axis=0).tolist(), vertices.max(axis=0).tolist())
            moved = world @ object_from_part(info, name, item.joints)
            corners.append(apply(moved, box))
        return _blocks(item.id, corners)

    def clashes(
        self, blocks: list[Block], ignore: Collection[int] = (), gap_m: float = GAP_M
    ) -> int | None:
        """Id of an object whose space these blocks would enter; None when they fit."""
        if self._table is None:
            self._table = _Table.of([one for found in self._blocks.values() for one in found])
        others = self._table.blocks
        a, b, c, d, lows, highs = self._table.boxes.T
        for block in blocks:
            x0, y0, x1, y1 = block.shape.bounds
            near = (x1 + gap_m > a) & (c > x0 - gap_m) & (y1 + gap_m > b) & (d > y0 - gap_m)
            near &= (block.low_m < highs - 1e-4) & (lows < block.high_m - 1e-4)
            shape: BaseGeometry | None = None
            for index in near.nonzero()[0].tolist():
                other: Block = others[index]
                if other.owner == block.owner or other.owner in ignore:
                    continue
                if shape is None:
                    grown = block.shape.buffer(gap_m, join_style="mitre") if gap_m else block.shape
                    shape = grown
                if shape.intersects(other.shape):
                    return other.owner
        return None

    # --- spots -----------------------------------------------------------------------------------

    def spot_on_object(
        self, asset: AssetInfo, target_id: int, relation: str, rng: Rng
    ) -> Vec3Yaw | None:
        """A free spot on (or inside) a placed object for a new thing of this asset."""
        target = self.items[target_id]
        info = self.info(target_id)
        drawn = info.variants[target.variant]
        world = target.pose.matrix()
        supports = [
            s
            for s in info.supports
            if s.part in drawn and (s.container is None) == (relation == "ON")
        ]
        if not supports:
            return self._spot_in_hollow(asset, target_id, rng) if relation == "INSIDE" else None
        shares = np.cumsum([s.area_m2 for s in supports])
        surfaces: dict[int, tuple[Polygon, float]] = {}
        for _ in range(TRIES):
            k = int(np.searchsorted(shares, rng.random() * shares[-1], side="right"))
            headroom = supports[k].headroom_m
            if headroom is not None and asset.extents_m[2] > headroom - 0.015:
                continue
            if k not in surfaces:
                surfaces[k] = _surface(info, supports[k], world, target)
            spot = self._try_surface(asset, target, *surfaces[k], rng)
            if spot is not None:
                return spot
        return None

    def _try_surface(
        self, asset: AssetInfo, target: ObjectInstance, surface: Polygon, z: float, rng: Rng
    ) -> Vec3Yaw | None:
        yaw = random_yaw(rng, yaw_of(target.pose.quat_xyzw))
        point = random_point(surface, rng)
        if point is None:
            return None
        print_ = footprint(asset, point[0], point[1], yaw)
        inside = surface.contains(print_)
        if not inside and print_.intersection(surface).area < 0.97 * print_.area:
            return None
        block = Block(-1, print_, z + 0.001, z + asset.extents_m[2] + DROP_M)
        if self.clashes([block], ignore=(target.id,)) is not None:
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
        world = target.pose.matrix()
        moved = world @ object_from_part(info, container.part, target.joints)
        bottom = list(container.center_m)
        bottom[2] -= container.size_m[2] / 2
        x, y, z = apply(moved, [bottom])[0]
        return (float(x), float(y), float(z)), random_yaw(rng)

    def spot_on_floor(
        self,
        asset: AssetInfo,
        area: BaseGeometry,
        outline: Polygon,
        rng: Rng,
        keep_share: float = 0.0,
        avoid: BaseGeometry | None = None,
        avoid_share: float = 0.25,
    ) -> Vec3Yaw | None:
        """A free spot on the floor with its centre in ``area``, all within the outline.

        At least ``keep_share`` of the footprint lies in ``area``, at most ``avoid_share`` in
        ``avoid``.
        """
        shapely.prepare(area)
        shapely.prepare(outline)
        if avoid is not None:
            shapely.prepare(avoid)
        for _ in range(TRIES):
            point = random_point(area, rng)
            yaw = random_yaw(rng)
            if point is None:
                return None
            print_ = footprint(asset, point[0], point[1], yaw)
            if not outline.covers(print_):
                continue
            if keep_share and print_.intersection(area).area < keep_share * print_.area:
                continue
            if (
                avoid is not None
                and avoid.intersects(print_)
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


def within_room(
    blocks: Sequence[Block], home: Home, room_id: int, opening: Opening | None = None
) -> bool:
    """True when these blocks reach into no wall and not through the ceiling of a room.

    ``opening`` is the hole they may hang in.
    """
    room = next(r for r in home.rooms if r.id == room_id)
    area: BaseGeometry = Polygon(room.polygon_m).buffer(IN_WALL_M, join_style="mitre")
    if opening is not None:
        area = area.union(opening_rectangle(opening, HOLE_DEPTH_M))
    return all(area.covers(b.shape) and b.high_m <= room.height_m for b in blocks)


def footprint(asset: AssetInfo, x: float, y: float, yaw: float) -> Polygon:
    """The asset's box seen from above at a place and heading."""
    w, d = asset.extents_m[0] / 2, asset.extents_m[1] / 2
    cos, sin = math.cos(yaw), math.sin(yaw)
    corners = ((-w, -d), (w, -d), (w, d), (-w, d))
    return shapely.polygons([(x + cos * u - sin * v, y + sin * u + cos * v) for u, v in corners])


def _surface(
    info: AssetInfo, support: Support, world: Array, target: ObjectInstance
) -> tuple[Polygon, float]:
    """A support of a placed object as it lies in the world: outline from above and height."""
    local = object_from_part(info, support.part, target.joints)
    points = apply(world @ local, [(x, y, support.z_m) for x, y in support.polygon_m])
    return shapely.polygons(points[:, :2]), float(points[:, 2].mean())


def _blocks(owner: int, pieces: Sequence[Array]) -> list[Block]:
    """The space of convex pieces, given as corners in the world (N, 3)."""
    if not pieces:
        return []
    piece_of = np.repeat(np.arange(len(pieces)), [len(corners) for corners in pieces])
    points = np.concatenate(pieces)[:, :2]
    # A line has the hull of its points, and needs no geometry of its own for each of them.
    shapes = shapely.convex_hull(shapely.linestrings(points, indices=piece_of))
    out = []
    for corners, shape, area in zip(pieces, shapes, shapely.area(shapes).tolist(), strict=True):
        if area < 1e-6:
            shape = Point(corners[:, :2].mean(axis=0)).buffer(0.005)
        heights = corners[:, 2]
        out.append(Block(owner, shape, float(heights.min()), float(heights.max())))
    return out
