"""What follows from poses and states: relations, tags and measured terms.

ON, INSIDE, CLOSE and FACING follow VirtualHome's geometry (Puig et al. 2018 and its graph code):
ON = bottom within 1 cm of a surface below and more than half of the footprint over it, INSIDE =
centre in the container's box, CLOSE = gap below 1.5 m, FACING = within 75 degrees. Every term
knows whether it is *sure*, that is, clear of its threshold by a margin, so that anyone's
re-evaluation of the files agrees.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np
import shapely
from shapely.geometry import Point, Polygon
from shapely.geometry.base import BaseGeometry

from sdgen.catalog.predicate import Related, ZoneShare
from sdgen.geometry import Array, Vec3, apply, inverse, matrix, vec3, yaw_of
from sdgen.library.records import AssetInfo
from sdgen.library.states import derive_states, object_from_part, rule_holds, undecided_states
from sdgen.scene import ObjectInstance, Room, Scene
from sdgen.vocabulary import CHILD_REACH_M, HALF_WALL_M

ON_GAP_M = 0.01
ON_SHARE = 0.5
ON_GAP_SURE_M = (0.007, 0.02)
ON_SHARE_SURE = (0.6, 0.4)
INSIDE_MARGIN_M = 0.003
CLOSE_M = 1.5
FACING_RAD = math.radians(75)
NEAR_HEAT_M = 0.3
NEAR_WATER_M = 0.5
NEAR_EDGE_M = 0.05
ZONE_SHARE = 0.5
UNDER_SHARE = 0.5
#: A thing lower than this can be stepped over without noticing and blocks nothing.
BLOCKING_HEIGHT_M = 0.03


class Edge(NamedTuple):
    """A relation between two nodes."""

    from_id: int
    to_id: int
    relation: str


@dataclass(frozen=True)
class _Surface:
    owner: int
    category: str
    z_m: float
    outline: BaseGeometry
    bounds: tuple[float, float, float, float]


@dataclass(frozen=True)
class _Hollow:
    owner: int
    category: str
    box_from_world: Array
    half: Array
    states: tuple[str, ...]
    undecided: tuple[str, ...]


class Body:
    """World geometry of one object: its outline in the world and what follows from it."""

    def __init__(self, item: ObjectInstance, info: AssetInfo) -> None:
        self.item = item
        self.info = info
        self.world_from_object = matrix(item.pose.position_m, item.pose.quat_xyzw)
        self.corners = apply(self.world_from_object, info.outermost_m)
        self.low = self.corners.min(axis=0)
        self.high = self.corners.max(axis=0)
        self.center = self.world_from_object[:3, 3] + self.world_from_object[:3, 2] * (
            info.extents_m[2] / 2
        )

    @cached_property
    def footprint(self) -> BaseGeometry:
        """The convex outline seen from above."""
        return shapely.convex_hull(shapely.multipoints(self.corners[:, :2]))


class Facts:
    """Measured facts of a scene, derived from poses, joints, variants and asset records alone.

    ``properties`` maps category to its catalogue properties (LOOKABLE, SITTABLE …), needed for
    FACING only.
    """

    def __init__(
        self,
        scene: Scene,
        infos: Mapping[str, AssetInfo],
        properties: Mapping[str, Collection[str]] | None = None,
    ) -> None:
        self.scene = scene
        self.properties = properties or {}
        self.bodies = {item.id: Body(item, infos[item.asset]) for item in scene.objects}
        self.rooms = {room.id: room for room in scene.home.rooms}
        self._floor_of = {s.room_id: s.id for s in scene.home.structures if s.category == "floor"}
        self._structures = {s.id: s for s in scene.home.structures}
        self._surfaces = list(self._find_surfaces())
        self._surface_boxes = _rows([(s.z_m, *s.bounds) for s in self._surfaces], 5)
        self._hollows = list(self._find_hollows())
        self._hollow_frames = _rows([h.box_from_world for h in self._hollows], 4, 4)
        self._hollow_halves = _rows([h.half for h in self._hollows], 3)
        self._zones = [(zone, Polygon(zone.polygon_m)) for zone in scene.zones]
        self._zone_boxes = _rows(
            [(*outline.bounds, zone.z_min_m, zone.z_max_m) for zone, outline in self._zones], 6
        )
        self._cache: dict[tuple[int, str], tuple[Related, ...]] = {}
        self._shares: dict[int, tuple[ZoneShare, ...]] = {}

    # --- what predicates ask (catalog.predicate.FactSource) --------------------------------------

    def category(self, object_id: int) -> str:
        """Category of an object or structure."""
        if object_id in self.bodies:
            return self.bodies[object_id].item.category
        return self._structures[object_id].category

    def states(self, object_id: int) -> tuple[str, ...]:
        """States that hold, from variant and joints."""
        body = self.bodies.get(object_id)
        if body is None:
            return ()
        return derive_states(body.info, body.item.variant, body.item.joints)

    def undecided_states(self, object_id: int) -> tuple[str, ...]:
        """States within the dead band between their limits."""
        body = self.bodies.get(object_id)
        if body is None:
            return ()
        return undecided_states(body.info, body.item.variant, body.item.joints)

    def room_type(self, object_id: int) -> str:
        """Type of the room the object is in."""
        return self.rooms[self.bodies[object_id].item.room_id].type

    def height(self, object_id: int) -> float:
        """Height of the object's lowest point above the floor, metres."""
        return float(self.bodies[object_id].low[2])

    def related(self, object_id: int, relation: str) -> tuple[Related, ...]:
        """Targets the object stands, or nearly stands, in ``relation`` to."""
        key = (object_id, relation)
        if key not in self._cache:
            if relation == "ON":
                found = tuple(self._on(object_id))
            elif relation == "INSIDE":
                found = tuple(self._inside(object_id))
            else:
                found = tuple(
                    Related(e.to_id, self.category(e.to_id), True, True)
                    for e in self._other_edges_from.get(object_id, ())
                    if e.relation == relation
                )
            self._cache[key] = found
        return self._cache[key]

    def distance(
        self, object_id: int, categories: Collection[str], state: str | None
    ) -> tuple[float, int | None]:
        """Gap to the nearest object of these categories (in ``state``); (inf, None) if none."""
        best, nearest = math.inf, None
        body = self.bodies[object_id]
        for other_id in self._ids_of(categories):
            other = self.bodies[other_id]
            if other_id == object_id:
                continue
            if state is not None and state not in self.states(other_id):
                continue
            gap = _gap(body, other)
            if gap < best:
                best, nearest = gap, other_id
        return best, nearest

    def _ids_of(self, categories: Collection[str]) -> list[int]:
        return [key for name in sorted(categories) for key in self._by_category.get(name, ())]

    @cached_property
    def _by_category(self) -> dict[str, list[int]]:
        out: dict[str, list[int]] = {}
        for key, body in self.bodies.items():
            out.setdefault(body.item.category, []).append(key)
        return out

    def zones(self, object_id: int) -> tuple[ZoneShare, ...]:
        """Zones the object's footprint touches, where its height range meets the zone's."""
        if object_id not in self._shares:
            self._shares[object_id] = tuple(self._find_zones(self.bodies[object_id]))
        return self._shares[object_id]

    def _find_zones(self, body: Body) -> Iterable[ZoneShare]:
        for index in self._zones_near(body, 0.0):
            zone, outline = self._zones[index]
            if zone.source_id == body.item.id or body.footprint.area <= 0:
                continue
            if outline.intersects(body.footprint):
                share = outline.intersection(body.footprint).area / body.footprint.area
                yield ZoneShare(zone.name, zone.kind, float(share))

    def _zones_near(self, body: Body, within_m: float) -> list[int]:
        """Indices of zones whose heights meet the body's, and whose boxes come near it."""
        x0, y0, x1, y1, low, high = self._zone_boxes.T
        meets = (body.low[2] <= high) & (body.high[2] >= low)
        meets &= (body.low[0] <= x1 + within_m) & (body.high[0] >= x0 - within_m)
        meets &= (body.low[1] <= y1 + within_m) & (body.high[1] >= y0 - within_m)
        return [int(k) for k in np.flatnonzero(meets)]

    # --- what the graph writes -------------------------------------------------------------------

    def bounding_box(self, object_id: int) -> tuple[Vec3, Vec3]:
        """World box of an object, structure or room: centre and size."""
        if object_id in self.bodies:
            low, high = self.bodies[object_id].low, self.bodies[object_id].high
        elif object_id in self.rooms:
            room = self.rooms[object_id]
            points = np.array(room.polygon_m)
            low = np.array([*points.min(axis=0), 0.0])
            high = np.array([*points.max(axis=0), room.height_m])
        else:
            pieces = self._structures[object_id].pieces
            centers = np.array([p.center_m for p in pieces])
            sizes = np.array([p.size_m for p in pieces])
            low, high = (centers - sizes / 2).min(axis=0), (centers + sizes / 2).max(axis=0)
        return vec3((low + high) / 2), vec3(high - low)

    def holds(self, object_id: int, relation: str) -> tuple[int, ...]:
        """Ids of the targets the relation holds to."""
        return tuple(r.target_id for r in self.related(object_id, relation) if r.holds)

    @cached_property
    def _edges(self) -> tuple[Edge, ...]:
        out: list[Edge] = []
        for object_id, body in self.bodies.items():
            out.append(Edge(object_id, body.item.room_id, "INSIDE"))
            for relation in ("ON", "INSIDE"):
                out += [Edge(object_id, t, relation) for t in self.holds(object_id, relation)]
        out += [Edge(s.id, s.room_id, "INSIDE") for s in self._structures.values()]
        out += self._other_edges
        return tuple(sorted(set(out), key=lambda e: (e.from_id, e.relation, e.to_id)))

    @cached_property
    def _other_edges_from(self) -> dict[int, list[Edge]]:
        out: dict[int, list[Edge]] = {}
        for edge in self._other_edges:
            out.setdefault(edge.from_id, []).append(edge)
        return out

    def edges(self) -> tuple[Edge, ...]:
        """All relations of the scene, sorted."""
        return self._edges

    def tags(self, object_id: int) -> tuple[str, ...]:
        """Unary facts of an object, sorted."""
        body = self.bodies.get(object_id)
        if body is None:
            return ()
        out = set()
        if body.low[2] <= CHILD_REACH_M and not self.shut_in(object_id) and not body.item.fixed:
            out.add("IN_REACH_OF_CHILD")
        kinds = {z.kind for z in self.zones(object_id) if z.fraction >= ZONE_SHARE}
        if "walkway" in kinds:
            out.add("IN_WALKWAY")
        if "doorway" in kinds:
            out.add("IN_DOORWAY")
        if self._near_edge(body):
            out.add("NEAR_EDGE")
        return tuple(sorted(out))

    def shut_in(self, object_id: int) -> bool:
        """True when the object is inside a container whose joint is closed."""
        for target in self.holds(object_id, "INSIDE"):
            owner = self.bodies[target]
            if "CLOSED" in self.states(target) and any(c.closed_by for c in owner.info.containers):
                return True
        return False

    # --- geometry --------------------------------------------------------------------------------

    def _find_surfaces(self) -> Iterable[_Surface]:
        for object_id, body in self.bodies.items():
            for support in body.info.supports:
                if support.part not in body.info.variants[body.item.variant]:
                    continue
                local = object_from_part(body.info, support.part, body.item.joints)
                points = apply(body.world_from_object @ local, support.edge_m)
                low, high = points.min(axis=0), points.max(axis=0)
                if high[2] - low[2] > 0.02:
                    continue  # the owner lies on its side: nothing stands on this any more
                yield _Surface(
                    object_id,
                    body.item.category,
                    float(points[:, 2].mean()),
                    shapely.polygons(points[:, :2]),
                    (float(low[0]), float(low[1]), float(high[0]), float(high[1])),
                )
        for room_id, floor_id in self._floor_of.items():
            outline = Polygon(self.rooms[room_id].polygon_m).buffer(HALF_WALL_M, join_style="mitre")
            yield _Surface(floor_id, "floor", 0.0, outline, outline.bounds)

    def _find_hollows(self) -> Iterable[_Hollow]:
        for object_id, body in self.bodies.items():
            for container in body.info.containers:
                if container.part not in body.info.variants[body.item.variant]:
                    continue
                moved = body.world_from_object @ object_from_part(
                    body.info, container.part, body.item.joints
                )
                moved[:3, 3] = apply(moved, [container.center_m])[0]
                half = np.asarray(container.size_m) / 2
                states, undecided = _leaf_states(body, container.closed_by)
                yield _Hollow(
                    object_id, body.item.category, inverse(moved), half, states, undecided
                )

    def _on(self, object_id: int) -> Iterable[Related]:
        body = self.bodies[object_id]
        best: dict[int, Related] = {}
        z, x0, y0, x1, y1 = self._surface_boxes.T
        near = np.abs(body.low[2] - z) < ON_GAP_SURE_M[1]
        near &= (body.low[0] <= x1) & (body.high[0] >= x0)
        near &= (body.low[1] <= y1) & (body.high[1] >= y0)
        for index in np.flatnonzero(near):
            surface = self._surfaces[index]
            if surface.owner == object_id:
                continue
            gap = float(body.low[2]) - surface.z_m
            share = surface.outline.intersection(body.footprint).area / max(
                body.footprint.area, 1e-9
            )
            if share <= 1 - ON_SHARE_SURE[0] and share <= ON_SHARE_SURE[1]:
                continue
            holds = abs(gap) <= ON_GAP_M and share > ON_SHARE
            sure = (
                abs(gap) <= ON_GAP_SURE_M[0] and share >= ON_SHARE_SURE[0]
                if holds
                else abs(gap) >= ON_GAP_SURE_M[1] or share <= ON_SHARE_SURE[1]
            )
            found = Related(
                surface.owner,
                surface.category,
                holds,
                sure,
                {"gap_m": round(gap, 5) + 0.0, "overlap": round(min(share, 1.0), 4)},
            )
            before = best.get(surface.owner)
            if before is None or (found.holds, found.sure) > (before.holds, before.sure):
                best[surface.owner] = found
        inside = {r.target_id for r in self.related(object_id, "INSIDE") if r.holds}
        # A thing on a plate is not on the table under it, though that may be within a centimetre:
        # the highest surface that surely carries it is the only one.
        carried = [r.evidence["gap_m"] for r in best.values() if r.holds and r.sure]
        nearest = min(carried, default=math.inf)
        for target in sorted(best):
            if target not in inside and best[target].evidence["gap_m"] <= nearest + 1e-3:
                yield best[target]

    def _inside(self, object_id: int) -> Iterable[Related]:
        body = self.bodies[object_id]
        best: dict[int, Related] = {}
        frames = self._hollow_frames
        local = np.abs(frames[:, :3, :3] @ body.center + frames[:, :3, 3])
        clearances = (self._hollow_halves - local).min(axis=1, initial=math.inf)
        for index in np.flatnonzero(clearances >= -INSIDE_MARGIN_M):
            hollow, clearance = self._hollows[index], float(clearances[index])
            if hollow.owner == object_id:
                continue
            found = Related(
                hollow.owner,
                hollow.category,
                clearance >= 0,
                abs(clearance) >= INSIDE_MARGIN_M,
                {"inside_by_m": round(clearance, 5)},
                hollow.states,
                hollow.undecided,
            )
            before = best.get(hollow.owner)
            if before is None or clearance > before.evidence["inside_by_m"]:
                best[hollow.owner] = found
        for target in sorted(best):
            yield best[target]

    @cached_property
    def _other_edges(self) -> list[Edge]:
        out: list[Edge] = []
        out += self._between()
        out += self._close()
        out += self._facing()
        for object_id, body in self.bodies.items():
            out += self._under(object_id, body)
            out += self._near_zones(object_id, body)
        return out

    def _between(self) -> list[Edge]:
        return [
            Edge(opening.object_id, room_id, "BETWEEN")
            for opening in self.scene.home.openings
            if opening.kind != "window"
            for room_id in opening.room_ids
        ]

    def _close(self) -> list[Edge]:
        out: list[Edge] = []
        for room_id in self.rooms:
            ids = [i for i, b in self.bodies.items() if b.item.room_id == room_id]
            if len(ids) < 2:
                continue
            low = np.array([self.bodies[i].low for i in ids])
            high = np.array([self.bodies[i].high for i in ids])
            gaps = np.maximum(low[:, None] - high[None], low[None] - high[:, None]).clip(min=0)
            near = np.linalg.norm(gaps, axis=2) < CLOSE_M
            out += [Edge(ids[a], ids[b], "CLOSE") for a, b in np.argwhere(near).tolist() if a != b]
        return out

    def _facing(self) -> list[Edge]:
        out: list[Edge] = []
        for object_id, body in self.bodies.items():
            if "SITTABLE" not in self.properties.get(body.item.category, ()):
                continue
            heading = yaw_of(body.item.pose.quat_xyzw)
            for other_id, other in self.bodies.items():
                if (
                    other_id == object_id
                    or other.item.room_id != body.item.room_id
                    or "LOOKABLE" not in self.properties.get(other.item.category, ())
                ):
                    continue
                dx, dy = (other.center - body.center)[:2]
                turn = math.atan2(dy, dx) - heading
                if abs(math.atan2(math.sin(turn), math.cos(turn))) < FACING_RAD:
                    out.append(Edge(object_id, other_id, "FACING"))
        return out

    def _under(self, object_id: int, body: Body) -> list[Edge]:
        if self.holds(object_id, "INSIDE"):
            return []
        out = []
        ids, tops, boxes = self._roofs
        over = tops > body.high[2] - 0.005
        over &= (boxes[:, 0] <= body.high[0]) & (boxes[:, 2] >= body.low[0])
        over &= (boxes[:, 1] <= body.high[1]) & (boxes[:, 3] >= body.low[1])
        for index in np.flatnonzero(over):
            other = self.bodies[ids[index]]
            if other is body or other.high[2] <= body.high[2]:
                continue
            share = other.footprint.intersection(body.footprint).area / body.footprint.area
            if share > UNDER_SHARE:
                out.append(Edge(object_id, ids[index], "UNDER"))
        return out

    @cached_property
    def _roofs(self) -> tuple[list[int], Array, Array]:
        """Built-in things with surfaces: ids, their highest surface (N,), and boxes (N, 4)."""
        tops: dict[int, float] = {}
        for surface in self._surfaces:
            owner = self.bodies.get(surface.owner)
            if owner is not None and owner.item.fixed:
                tops[surface.owner] = max(tops.get(surface.owner, -math.inf), surface.z_m)
        bodies = [self.bodies[key] for key in tops]
        boxes = _rows([(*body.low[:2], *body.high[:2]) for body in bodies], 4)
        return list(tops), np.array(list(tops.values())), boxes

    def _near_zones(self, object_id: int, body: Body) -> list[Edge]:
        if body.item.fixed:
            return []
        out = []
        tall = body.high[2] - body.low[2] > BLOCKING_HEIGHT_M
        shares = {z.name: z.fraction for z in self.zones(object_id)}
        for index in self._zones_near(body, max(NEAR_HEAT_M, NEAR_WATER_M)):
            zone, outline = self._zones[index]
            if zone.source_id is None or zone.source_id == object_id:
                continue
            if zone.kind in ("doorway", "swing"):
                if tall and shares.get(zone.name, 0.0) >= ZONE_SHARE:
                    out.append(Edge(object_id, zone.source_id, "BLOCKS"))
                continue
            limit = {"heat": NEAR_HEAT_M, "water": NEAR_WATER_M}.get(zone.kind)
            if limit is not None and outline.distance(body.footprint) < limit:
                relation = "NEAR_HEAT" if zone.kind == "heat" else "NEAR_WATER"
                out.append(Edge(object_id, zone.source_id, relation))
        return sorted(set(out), key=lambda e: (e.relation, e.to_id))

    def _near_edge(self, body: Body) -> bool:
        for target in self.holds(body.item.id, "ON"):
            if target not in self.bodies:
                continue
            for surface in self._surfaces:
                if surface.owner == target and abs(body.low[2] - surface.z_m) <= ON_GAP_M:
                    point = Point(body.center[:2])
                    if surface.outline.exterior.distance(point) < NEAR_EDGE_M:
                        return True
        return False


def _rows(values: Sequence[object], *shape: int) -> Array:
    """The values as an array (N, *shape), also when there are none."""
    return np.array(values, dtype=np.float64).reshape(len(values), *shape)


def _leaf_states(body: Body, joint: str | None) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """States of the leaf that shuts one container, and those it is too near to call."""
    if joint is None:
        return (), ()
    rules = [rule for rule in body.info.states if rule.joint == joint]
    holding = [r.state for r in rules if rule_holds(r, body.item.variant, body.item.joints)]
    return tuple(holding), () if holding else tuple(r.state for r in rules)


def _gap(a: Body, b: Body) -> float:
    """Distance between two axis-aligned world boxes, 0 when they touch."""
    apart = np.maximum(a.low - b.high, b.low - a.high).clip(min=0)
    return float(np.linalg.norm(apart))


def room_at(rooms: Iterable[Room], x: float, y: float) -> Room | None:
    """The room whose outline holds the point, or the one within a wall's half thickness."""
    point = Point(x, y)
    best: tuple[float, Room] | None = None
    for room in rooms:
        gap = Polygon(room.polygon_m).distance(point)
        if best is None or gap < best[0]:
            best = (gap, room)
    return best[1] if best is not None and best[0] <= 0.13 else None
