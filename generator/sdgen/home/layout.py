"""The things placed so far, and where there is room for one more.

Placement is proposed in 2-D with height ranges (cheap); physics proves it later. Everything is a
value: a spot that does not fit is None.
"""

from __future__ import annotations

import math
from bisect import bisect_right
from collections.abc import Callable, Collection, Iterator, Sequence
from dataclasses import dataclass
from itertools import accumulate
from typing import NamedTuple

import numpy as np
import shapely
from shapely.geometry import Polygon
from shapely.geometry.base import BaseGeometry

from sdgen.actions import at_rest
from sdgen.freespace import opening_rectangle
from sdgen.geometry import (
    Array,
    Vec2,
    Vec3,
    apply,
    quat_from_yaw,
    round_position,
    round_quat,
    yaw_of,
)
from sdgen.home.blocks import NOBODY, Block, Table, blocks_of
from sdgen.home.ground import Ground
from sdgen.home.headings import FRONT_SPREAD_RAD, random_yaw
from sdgen.home.surfaces import PlacingSurface, placing_surfaces
from sdgen.home.ways import Ways
from sdgen.library import Library
from sdgen.library.drawn import drawn
from sdgen.library.records import AssetInfo
from sdgen.library.states import object_from_part
from sdgen.scene import Home, ObjectInstance, Opening, Pose
from sdgen.seeding import Rng
from sdgen.vocabulary import HALF_WALL_M, OPENINGS, PRESSED_M

#: Things start this far above what they stand on: a contact at the start would push them.
DROP_M = 0.001
#: Left between things: room to settle without touching.
GAP_M = 0.01
#: On the floor, of which there is more.
FLOOR_GAP_M = 0.03
#: Spots drawn for a thing on one target; of 2,100 spots found two fifths were the first, one in a
#: hundred the twelfth.
TRIES = 12
#: Left above a thing on a shelf: a hand gets it in and out.
HEADROOM_LEFT_M = 0.015
#: What may reach into a wall: less than physics calls a penetration.
IN_WALL_M = 0.003
#: A hole in a wall reaches this far to both sides of its middle, past half a wall.
HOLE_DEPTH_M = HALF_WALL_M + 0.01


class Bulk(NamedTuple):
    """The box that a thing fills, in its own frame: its size, and the middle of its base."""

    size_m: Vec3
    middle_m: Vec2 = (0.0, 0.0)

    def origin(self, middle: Vec2, yaw: float) -> Vec2:
        """Where the thing's frame is when the middle of its base is at a point."""
        (x, y), cos, sin = self.middle_m, math.cos(yaw), math.sin(yaw)
        return middle[0] - (cos * x - sin * y), middle[1] - (sin * x + cos * y)

    def corners(self, spot: Vec3Yaw) -> Array:
        """Corners (8, 3) of what the thing fills when its frame is at a spot."""
        (x, y, z), yaw = spot
        (u, v), cos, sin = self.middle_m, math.cos(yaw), math.sin(yaw)
        ring = _ring(self.size_m, x + cos * u - sin * v, y + sin * u + cos * v, yaw)
        return np.array([(*corner, z + up) for up in (0.0, self.size_m[2]) for corner in ring])


@dataclass(frozen=True)
class Intent:
    """What a placement is meant to be: checked again after settling."""

    relation: str
    target_id: int


class Layout:
    """Objects placed so far with the space they take. One per attempt; not shared.

    ``fronted`` categories are put with their front the way that of their support faces.
    """

    def __init__(self, library: Library, ids: Iterator[int], fronted: Collection[str] = ()) -> None:
        self.library = library
        self.fronted = fronted
        self.ids = ids
        self.items: dict[int, ObjectInstance] = {}
        self.intents: dict[int, Intent] = {}
        self.ways = Ways()
        self._blocks: dict[int, list[Block]] = {}
        self._surfaces: dict[int, tuple[ObjectInstance, list[PlacingSurface]]] = {}
        self._table: Table | None = Table()

    def info(self, object_id: int) -> AssetInfo:
        """Asset record of a placed object."""
        return self.library.info(self.items[object_id].asset)

    def put(
        self,
        item: ObjectInstance,
        intent: Intent | None = None,
        blocks: list[Block] | None = None,
    ) -> None:
        """Add an object, or replace the one of the same id; ``blocks`` are its space, if known."""
        if blocks is None:
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
        out = Layout(self.library, ids or self.ids, self.fronted)
        out.items, out.intents = dict(self.items), dict(self.intents)
        out.ways = self.ways
        out._blocks, out._table = dict(self._blocks), self._table
        # Shared: what is known of one object as it stands holds in every layout.
        out._surfaces = self._surfaces
        return out

    def space_of(self, object_id: int) -> list[Block]:
        """Space of a placed object as it stands."""
        return self._blocks[object_id]

    def blocks_of(self, item: ObjectInstance) -> list[Block]:
        """Space of an object's body, and of each part that a joint holds open."""
        return blocks_of(item, self.library.info(item.asset), self.library)

    def entered(self, blocks: Sequence[Block]) -> Iterator[int]:
        """Ids of the objects whose space these blocks would enter; some more than once."""
        if self._table is None:
            every = (block for found in self._blocks.values() for block in found)
            self._table = Table().more(every)
        return self._table.entered(blocks)

    def fits(self, blocks: Sequence[Block], ignore: int | None = None) -> bool:
        """True unless these blocks enter the space of an object that is not ignored."""
        return all(owner == ignore for owner in self.entered(blocks))

    # --- spots -----------------------------------------------------------------------------------

    def spot_on_object(
        self,
        asset: AssetInfo,
        target_id: int,
        relation: str,
        rng: Rng,
        hollows: Callable[[str], bool] = lambda _: True,
        bulk: Bulk | None = None,
    ) -> Vec3Yaw | None:
        """A free spot on (or inside) a placed object for a new thing of this asset.

        ``hollows`` says into which of its hollows, by name, such a thing may go; ``bulk`` what it
        fills, if it is not at rest.
        """
        bulk = bulk or Bulk(asset.extents_m)
        target = self.items[target_id]
        surfaces = [
            surface
            for surface in self.surfaces_of(target_id)
            if (surface.support.container is None) == (relation == "ON")
        ]
        if not surfaces and relation == "INSIDE":
            return self._spot_in_hollow(bulk, target_id, rng, hollows)
        if relation == "INSIDE":
            surfaces = [s for s in surfaces if hollows(s.support.container or "")]
        if not surfaces:
            return None
        shares = list(accumulate(surface.support.area_m2 for surface in surfaces))
        for _ in range(TRIES):
            surface = surfaces[bisect_right(shares, rng.random() * shares[-1])]
            headroom = surface.support.headroom_m
            if headroom is not None and bulk.size_m[2] > headroom - HEADROOM_LEFT_M:
                continue
            yaw = self._heading(asset, target, rng)
            looked_at = asset.category in self.fronted
            spot = self._try_surface(bulk, yaw, target, surface, rng, inward=looked_at)
            if spot is not None:
                return spot
        return None

    def surfaces_of(self, object_id: int) -> list[PlacingSurface]:
        """The supports of a placed object that surely lie level, found once as it stands."""
        item = self.items[object_id]
        known = self._surfaces.get(object_id)
        if known is None or known[0] is not item:
            known = self._surfaces[object_id] = item, placing_surfaces(item, self.info(object_id))
        return known[1]

    def _try_surface(
        self,
        bulk: Bulk,
        yaw: float,
        target: ObjectInstance,
        surface: PlacingSurface,
        rng: Rng,
        inward: bool,
    ) -> Vec3Yaw | None:
        point = surface.random_point(rng)
        if point is not None and inward:
            yaw = _inward(yaw, target, point)
        if point is None or not surface.carries(bulk.size_m, point, yaw):
            return None
        spot = (*bulk.origin(point, yaw), surface.z_m), yaw
        block = space_at(bulk.size_m, (*point, surface.z_m), yaw, GAP_M, DROP_M)
        return spot if self.fits([block], ignore=target.id) else None

    def _heading(self, asset: AssetInfo, target: ObjectInstance, rng: Rng) -> float:
        front = yaw_of(target.pose.quat_xyzw)
        if asset.category in self.fronted:
            return front + float(rng.normal(0.0, FRONT_SPREAD_RAD))
        return random_yaw(rng, front)

    def _spot_in_hollow(
        self, bulk: Bulk, target_id: int, rng: Rng, hollows: Callable[[str], bool]
    ) -> Vec3Yaw | None:
        target, info = self.items[target_id], self.info(target_id)
        containers = [c for c in info.containers if hollows(c.name)]
        if not containers:
            return None
        container = containers[int(rng.integers(len(containers)))]
        if any(a > b for a, b in zip(bulk.size_m, container.size_m, strict=True)):
            return None
        if any(intent == Intent("INSIDE", target_id) for intent in self.intents.values()):
            return None
        world = target.pose.matrix()
        moved = world @ object_from_part(info, container.part, target.joints)
        bottom = list(container.center_m)
        bottom[2] -= container.size_m[2] / 2
        x, y, z = apply(moved, [bottom])[0]
        yaw = random_yaw(rng)
        return (*bulk.origin((float(x), float(y)), yaw), float(z)), yaw

    def spot_on_floor(
        self,
        asset: AssetInfo,
        ground: Ground,
        rng: Rng,
        bulk: Bulk | None = None,
        gap_m: float = FLOOR_GAP_M,
    ) -> Vec3Yaw | None:
        """A free spot on this floor, ``gap_m`` from what stands there.

        ``bulk`` is what the thing fills, if it is not at rest.
        """
        bulk = bulk or Bulk(asset.extents_m)
        looked_at = asset.category in self.fronted
        for _ in range(TRIES):
            drawn_at = ground.draw(bulk.size_m, looked_at, rng)
            if drawn_at is None:
                return None
            point, yaw = drawn_at
            print_ = shapely.polygons(_ring(bulk.size_m, *point, yaw))
            if not ground.takes(print_, point, yaw, looked_at):
                continue
            floor_m = self._floor_at(space_at(bulk.size_m, (*point, 0.0), yaw, gap_m))
            if floor_m is not None:
                return (*bulk.origin(point, yaw), floor_m), yaw
        return None

    def _floor_at(self, block: Block) -> float | None:
        """How high the floor is below a thing's space: as thick as a flat-woven rug that is under
        all of it; None where something is in the way, or the thing would lie over the rug's edge.

        What lies on such a rug lies on the floor, by its measures and to whoever walks there.
        """
        met = list(dict.fromkeys(self.entered([block])))
        if not met:
            return 0.0
        thick_m = self.info(met[0]).extents_m[2]
        if len(met) > 1 or not self.items[met[0]].fixed or thick_m > PRESSED_M:
            return None
        whole = any(other.shape.covers(block.shape) for other in self.space_of(met[0]))
        return thick_m if whole else None

    def new_item(
        self, asset: AssetInfo, spot: Vec3Yaw, room_id: int, lift_m: float = DROP_M
    ) -> ObjectInstance:
        """A new object of ``asset`` at a spot, ``lift_m`` above its surface."""
        return at_spot(self.new_thing(asset), spot, room_id, lift_m)

    def new_thing(self, asset: AssetInfo) -> ObjectInstance:
        """A new object of ``asset``, at rest, that is nowhere yet."""
        nowhere = Pose(position_m=(0.0, 0.0, 0.0), quat_xyzw=(0.0, 0.0, 0.0, 1.0))
        item = ObjectInstance(
            id=next(self.ids), category=asset.category, asset=asset.id, pose=nowhere, room_id=0
        )
        return at_rest(item, asset)

    def box_of(self, item: ObjectInstance) -> tuple[Vec3, Vec3]:
        """The lowest and the highest corner, in its own frame, of an object as it is drawn."""
        low, high = drawn(self.library.info(item.asset), item.variant, item.joints).box_m.tolist()
        return tuple(low), tuple(high)

    def bulk_of(self, item: ObjectInstance) -> Bulk:
        """What an object fills as it is drawn."""
        low, high = self.box_of(item)
        x, y, z = np.subtract(high, low).tolist()
        return Bulk((x, y, z), ((low[0] + high[0]) / 2, (low[1] + high[1]) / 2))


Vec3Yaw = tuple[Vec3, float]


def at_spot(
    item: ObjectInstance, spot: Vec3Yaw, room_id: int, lift_m: float = DROP_M
) -> ObjectInstance:
    """The object at a spot, ``lift_m`` above its surface."""
    (x, y, z), yaw = spot
    pose = Pose(
        position_m=round_position((x, y, z + lift_m)), quat_xyzw=round_quat(quat_from_yaw(yaw))
    )
    return item.model_copy(update={"pose": pose, "room_id": room_id})


def _inward(yaw: float, target: ObjectInstance, point: Vec2) -> float:
    """The heading of what stands on ``target`` turned the same way off its front, but towards its
    middle: at the end of a chest, nothing looks at the wall beside it."""
    front = yaw_of(target.pose.quat_xyzw)
    dx, dy = point[0] - target.pose.position_m[0], point[1] - target.pose.position_m[1]
    left = math.cos(front) * dy - math.sin(front) * dx
    return front - math.copysign(yaw - front, left)


def room_to_change(
    layout: Layout, home: Home, before: ObjectInstance, after: ObjectInstance
) -> bool:
    """True when what moves between two states of a placed object has room where it comes."""
    stood = layout.blocks_of(before)
    opened = [
        block
        for block in layout.blocks_of(after)
        if not any(block.same_space(other) for other in stood)
    ]
    if not layout.fits(opened):
        return False
    return before.category in OPENINGS or within_room(opened, home, before.room_id)


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


def space_at(size: Vec3, base: Vec3, yaw: float, gap_m: float, over_m: float = 0.0) -> Block:
    """The space a new thing of a size takes whose base has its middle there, from ``over_m`` above
    its surface, and a gap around.

    Its box has the gap along the axes alone: two corners may come a little nearer than it.
    """
    x, y, z = base
    xs, ys = zip(*_ring(size, x, y, yaw), strict=True)
    low = (min(xs) - gap_m, min(ys) - gap_m, z + over_m)
    high = (max(xs) + gap_m, max(ys) + gap_m, z + size[2] + DROP_M)
    return Block(NOBODY, np.array(_ring(size, x, y, yaw, gap_m)), np.array([*low, *high]))


def corners_of(asset: AssetInfo, x: float, y: float, yaw: float) -> list[Vec2]:
    """Corners of the asset's box seen from above."""
    return _ring(asset.extents_m, x, y, yaw)


def _ring(size: Vec3, x: float, y: float, yaw: float, gap_m: float = 0.0) -> list[Vec2]:
    """Corners of a box of a size seen from above, with a gap left around it."""
    w, d = size[0] / 2 + gap_m, size[1] / 2 + gap_m
    cos, sin = math.cos(yaw), math.sin(yaw)
    corners = ((-w, -d), (w, -d), (w, d), (-w, d))
    return [(x + cos * u - sin * v, y + sin * u + cos * v) for u, v in corners]
