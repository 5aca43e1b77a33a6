"""What is measured between the objects of one scene, by the tables of `docs/relations.md`.

Nothing here reads `graph.json`: what it says of relations and tags is compared with this.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator, Mapping
from functools import cached_property
from types import MappingProxyType
from typing import Any, NamedTuple

import numpy as np
import shapely

from tests.audit.dataset import Floats, Scene
from tests.audit.outlines import LEAST_M2, Body, Surface
from tests.audit.told import NO, YES, Limit, Told, about, every, some

Evidence = Mapping[str, Any]

#: `docs/relations.md`, Limits.
ON_GAP = Limit(0.01, 0.007, 0.02)
ON_SHARE = about(0.5, 0.1)
ON_LEVEL = about(0.001, 0.0005)
INSIDE = about(0.0, 0.003)
CLOSE = about(1.5, 0.05)
FACING = about(75.0, 5.0)
SAT_AT = about(0.5, 0.05)
UNDER_SHARE = about(0.5, 0.1)
UNDER = about(0.0, 0.005)
BLOCKS_SHARE = about(0.5, 0.15)
BLOCKS_HEIGHT = about(0.03, 0.005)
NEAR = {"NEAR_HEAT": ("heat", about(0.3, 0.05)), "NEAR_WATER": ("water", about(0.5, 0.05))}
ZONES = about(0.0, 0.02)
REACH = about(0.5, 0.05)
ROOM = about(0.0, 0.04)
OUTDOORS = about(0.13, 0.02)
#: Bearings: the other's centre at least so far off, metres, and a front that level (cosine).
BEARING_M, BEARING_COSINE = 0.1, 0.5
#: Floors reach to the middle of the walls, metres.
HALF_WALL_M = 0.06
#: A surface this near to `climb_m` is what a child stands on, metres.
OWN_TOP_M = 0.25
#: `NEAR_EDGE`: from the centre to the surface's edge, metres.
NEAR_EDGE_M = 0.05
CHILD_REACH_M = 1.29


class Related(NamedTuple):
    """Something an object is, or may be, related to; ``leaf`` are the states of its hollow."""

    target: int
    category: str
    told: Told
    evidence: Evidence = MappingProxyType({})
    leaf: tuple[frozenset[str], frozenset[str]] | None = None


class Zone(NamedTuple):
    name: str
    kind: str
    outline: shapely.Polygon
    low: float
    high: float
    room: int
    source: int | None


class World:
    """The objects of a scene as their records outline them, and how they stand to each other."""

    def __init__(self, scene: Scene) -> None:
        self.scene = scene
        self.bodies: dict[int, Body] = {
            item["id"]: Body(item, scene.models.records[item["asset"]])
            for item in scene.scene["objects"]
        }
        self.zones = [
            Zone(
                z["name"],
                z["kind"],
                shapely.Polygon(z["polygon_m"]),
                z["z_min_m"] if z["z_min_m"] > 0 else -math.inf,
                z["z_max_m"],
                z["room_id"],
                z["source_id"],
            )
            for z in scene.scene["zones"]
        ]
        self._related: dict[tuple[int, str], list[Related]] = {}
        self._rooms: dict[int, tuple[int, ...]] = {}
        self._carriers: dict[int, dict[int, tuple[Told, Told]]] = {}
        self._shares: dict[int, list[tuple[Zone, float, Told]]] = {}
        self.drops: dict[tuple[Any, ...], tuple[shapely.Geometry, shapely.Geometry]] = {}

    def category(self, id: int) -> str:
        if id in self.bodies:
            return self.bodies[id].category
        if id in self.scene.rooms:
            return str(self.scene.rooms[id]["type"])
        return self._structures.get(id, "nothing")

    @cached_property
    def _structures(self) -> dict[int, str]:
        return {s["id"]: s["category"] for s in self.scene.scene["home"]["structures"]}

    def of(self, categories: Collection[str]) -> list[Body]:
        return [body for name in sorted(categories) for body in self._of_category.get(name, [])]

    @cached_property
    def _of_category(self) -> dict[str, list[Body]]:
        found: dict[str, list[Body]] = {}
        for body in self.bodies.values():
            found.setdefault(body.category, []).append(body)
        return found

    # --- rooms -----------------------------------------------------------------------------------

    @cached_property
    def _openings(self) -> dict[int, Any]:
        return {o["object_id"]: o for o in self.scene.scene["home"]["openings"]}

    def rooms(self, id: int) -> tuple[int, ...]:
        """Rooms an object may be in, the nearest first; 0 for outdoors, nothing where surely."""
        if id not in self._rooms:
            self._rooms[id] = self._rooms_of(id)
        return self._rooms[id]

    def _rooms_of(self, id: int) -> tuple[int, ...]:
        if id in self._openings:
            return tuple(self._openings[id]["room_ids"][:1])
        point = shapely.Point(self.bodies[id].center[:2])
        far = {room: floor.distance(point) for room, floor in self.scene.floors.items()}
        order = sorted(far, key=far.__getitem__)
        nearest = far[order[0]]
        outdoors = OUTDOORS.at_least(nearest)
        if outdoors == YES:
            return ()
        maybe = [room for room in order if far[room] - nearest < ROOM.high]
        if outdoors == NO:
            return tuple(maybe)
        return (0, *maybe) if outdoors.holds else (*maybe, 0)

    def room_types(self, id: int) -> list[str]:
        rooms = self.scene.rooms
        return [str(rooms[k]["type"]) if k in rooms else "" for k in self.rooms(id)]

    def together(self, a: int, b: int) -> Told:
        return _one_room(self.rooms(a), self.rooms(b))

    # --- relations -------------------------------------------------------------------------------

    def related(self, id: int, relation: str) -> list[Related]:
        """All that an object is, or may be, in this relation to; what it surely is not is left
        out."""
        key = (id, relation)
        if key not in self._related:
            find = getattr(self, f"_{relation.lower()}", None)
            found = self._near(id, relation) if find is None else find(id)
            self._related[key] = [one for one in found if one.told != NO]
        return self._related[key]

    @cached_property
    def _surfaces(self) -> tuple[list[Surface], Floats]:
        found = [s for body in self.bodies.values() for s in body.surfaces]
        for structure in self.scene.scene["home"]["structures"]:
            if structure["category"] == "floor":
                outline = self.scene.floors[structure["room_id"]]
                wide = outline.buffer(HALF_WALL_M, join_style="mitre")
                found.append(Surface(structure["id"], "floor", 0.0, wide, YES))
        boxes = np.array([[s.z, *s.outline.bounds] for s in found]).reshape(-1, 5)
        return found, boxes

    def _on(self, id: int) -> Iterator[Related]:
        body = self.bodies[id]
        surfaces, boxes = self._surfaces
        z, x0, y0, x1, y1 = boxes.T
        near = np.abs(body.low[2] - z) < ON_GAP.high
        near &= (body.low[0] <= x1) & (body.high[0] >= x0)
        near &= (body.low[1] <= y1) & (body.high[1] >= y0)
        best: dict[int, tuple[Surface, float, float, Told]] = {}
        for k in np.flatnonzero(near).tolist():
            surface = surfaces[k]
            if surface.owner == id:
                continue
            gap = float(body.low[2]) - surface.z
            share = body.share_in(surface.outline)
            told = every([surface.level, ON_GAP.at_most(abs(gap)), ON_SHARE.more(share)])
            before = best.get(surface.owner)
            if told != NO and (before is None or _surer(told, before[3])):
                best[surface.owner] = (surface, gap, share, told)
        inside = self._inside_told(id)
        for owner, (surface, gap, share, told) in sorted(best.items()):
            higher = [
                every([other[3], ON_LEVEL.more(gap - other[1])])
                for key, other in best.items()
                if key != owner
            ]
            off = [part.denied() for part in [*higher, inside.get(owner, NO)]]
            evidence = {"gap_m": gap, "overlap": min(share, 1.0)}
            yield Related(owner, surface.category, every([told, *off]), evidence)

    @cached_property
    def _hollows(self) -> list[Any]:
        return [hollow for body in self.bodies.values() for hollow in body.hollows]

    def _inside(self, id: int) -> Iterator[Related]:
        """What is fixed is in nothing loose."""
        body = self.bodies[id]
        deep = [(hollow.depth(body.center), hollow) for hollow in self._hollows]
        found = [one for one in deep if one[0] > INSIDE.low and one[1].owner != id]
        for depth, hollow in sorted(found, key=lambda one: (one[1].owner, -one[0])):
            if hollow.fixed or not body.fixed:
                told = INSIDE.at_least(depth)
                leaf = (hollow.states, hollow.undecided)
                yield Related(hollow.owner, hollow.category, told, {"inside_by_m": depth}, leaf)

    def _inside_told(self, id: int) -> dict[int, Told]:
        found: dict[int, list[Told]] = {}
        for one in self.related(id, "INSIDE"):
            found.setdefault(one.target, []).append(one.told)
        return {owner: some(parts) for owner, parts in found.items()}

    def _between(self, id: int) -> Iterator[Related]:
        opening = self._openings.get(id)
        if opening is not None and opening["kind"] != "window":
            for room in opening["room_ids"]:
                yield Related(room, self.category(room), YES)

    @cached_property
    def _boxes(self) -> tuple[list[int], Floats, Floats]:
        bodies = list(self.bodies.values())
        return (
            [body.id for body in bodies],
            np.array([body.low for body in bodies]).reshape(-1, 3),
            np.array([body.high for body in bodies]).reshape(-1, 3),
        )

    def gap(self, a: Body, b: Body) -> float:
        return float(np.linalg.norm(np.maximum(0, np.maximum(b.low - a.high, a.low - b.high))))

    def _close(self, id: int) -> Iterator[Related]:
        body = self.bodies[id]
        ids, lows, highs = self._boxes
        apart = np.maximum(0, np.maximum(lows - body.high, body.low - highs))
        gaps = np.linalg.norm(apart, axis=1)
        for k in np.flatnonzero(gaps < CLOSE.high).tolist():
            if ids[k] != id:
                told = every([self.together(id, ids[k]), CLOSE.less(float(gaps[k]))])
                yield Related(ids[k], self.category(ids[k]), told, {"gap_m": float(gaps[k])})

    def bearing(self, a: Body, b: Body) -> tuple[float, Told]:
        """Degrees between the front of one and the centre of another, seen from above, and whether
        that says anything."""
        front, towards = a.turn[:2, 0], (b.center - a.center)[:2]
        across = front[0] * towards[1] - front[1] * towards[0]
        angle = math.degrees(math.atan2(abs(across), float(front @ towards)))
        far, level = float(np.hypot(*towards)), float(np.hypot(*front))
        return angle, Told(True, far >= BEARING_M and level >= BEARING_COSINE)

    def _having(self, word: str) -> list[Body]:
        properties = self.scene.catalogue.properties
        return [body for body in self.bodies.values() if word in properties[body.category]]

    def _facing(self, id: int) -> Iterator[Related]:
        body = self.bodies[id]
        if "SITTABLE" not in self.scene.catalogue.properties[body.category]:
            return
        shown = self._having("LOOKABLE")
        ids = {other.id for other in shown}
        for other in [*shown, *(b for b in self._having("SAT_AT") if b.id not in ids)]:
            if other.id == id:
                continue
            angle, clear = self.bearing(body, other)
            ahead = FACING.less(angle)
            parts = [self.together(id, other.id), Told(ahead.holds, ahead.sure and clear.sure)]
            evidence: dict[str, float] = {"facing_deg": angle}
            if other.id not in ids:
                evidence["gap_m"] = self.gap(body, other)
                parts.append(SAT_AT.less(evidence["gap_m"]))
            yield Related(other.id, other.category, every(parts), evidence)

    def _under(self, id: int) -> Iterator[Related]:
        body = self.bodies[id]
        free = [one.told.denied() for one in self.related(id, "INSIDE")]
        on = {one.target: one.told for one in self.related(id, "ON")}
        for other in self.bodies.values():
            if not other.fixed or other.id == id or not other.surfaces:
                continue
            below = max(s.z for s in other.surfaces) - float(body.high[2])
            aside = (other.low[:2] > body.high[:2]) | (other.high[:2] < body.low[:2])
            if below <= UNDER.low or aside.any():
                continue
            over = some(
                every([s.level, UNDER.at_least(s.z - float(body.high[2]))]) for s in other.surfaces
            )
            share = body.share_in(other.trunk)
            parts = [*free, on.get(other.id, NO).denied(), over, UNDER_SHARE.more(share)]
            evidence = {"overlap": min(share, 1.0), "below_m": below}
            yield Related(other.id, other.category, every(parts), evidence)

    # --- zones -----------------------------------------------------------------------------------

    def level(self, body: Body, zone: Zone) -> Told:
        overlap = min(zone.high - float(body.low[2]), float(body.high[2]) - zone.low)
        return ZONES.at_least(overlap)

    def zone_shares(self, id: int) -> list[tuple[Zone, float, Told]]:
        """Zones that an object's footprint touches, how much of it, and whether heights meet."""
        if id not in self._shares:
            body, found = self.bodies[id], []
            if body.footprint.area > 0:
                for zone in self.zones:
                    told = self.level(body, zone)
                    mine = zone.source == id or told == NO
                    if not mine and zone.outline.intersects(body.footprint):
                        found.append((zone, body.share_in(zone.outline), told))
            self._shares[id] = found
        return self._shares[id]

    def in_zones(self, id: int, kinds: Collection[str]) -> list[tuple[Zone, float, Told]]:
        """What of it lies in zones of these kinds, taken together: in those surely at its height
        and, where there are more, in all that may be; under the name of the one with most."""
        mine = [one for one in self.zone_shares(id) if one[0].kind in kinds]
        sure = [one for one in mine if one[2] == YES]
        found = []
        for among in (sure, mine) if len(mine) > len(sure) else (sure,):
            if among:
                most = max(among, key=lambda one: (one[1], one[0].name))[0]
                union = shapely.union_all([one[0].outline for one in among])
                share = self.bodies[id].share_in(union)
                told = YES if among is sure else some(one[2] for one in among)
                found.append((most, share, told))
        return found

    def _blocks(self, id: int) -> Iterator[Related]:
        body = self.bodies[id]
        if body.fixed:
            return
        tall = BLOCKS_HEIGHT.more(float(body.high[2] - body.low[2]))
        found: dict[int, list[Told]] = {}
        for zone, share, level in self.zone_shares(id):
            if zone.kind in ("doorway", "swing") and zone.source is not None:
                parts = [tall, BLOCKS_SHARE.at_least(share), level]
                found.setdefault(zone.source, []).append(every(parts))
        for door, ways in sorted(found.items()):
            yield Related(door, self.category(door), some(ways))

    def _near(self, id: int, relation: str) -> Iterator[Related]:
        body = self.bodies[id]
        kind, limit = NEAR[relation]
        found: dict[int, list[tuple[float, Told]]] = {}
        for zone in [] if body.fixed else self.zones:
            if zone.kind == kind and zone.source not in (None, id):
                gap = float(zone.outline.distance(body.footprint))
                told = every([limit.less(gap), self.level(body, zone)])
                if self.level(body, zone) != NO and gap < limit.high:
                    found.setdefault(zone.source or 0, []).append((gap, told))
        for source, ways in sorted(found.items()):
            told = some(one for _, one in ways)
            yield Related(source, self.category(source), told, {"gap_m": min(ways)[0]})

    # --- who carries whom ------------------------------------------------------------------------

    def carriers(self, id: int) -> dict[int, tuple[Told, Told]]:
        """What carries an object, by what is on it and by what is in it: what it is ON or INSIDE
        and, where that is loose, what carries that."""
        if id not in self._carriers:
            found: dict[int, tuple[Told, Told]] = {}
            todo = [(id, YES)]
            while todo:
                key, so_far = todo.pop()
                for way, relation in enumerate(("ON", "INSIDE")):
                    for one in self.related(key, relation):
                        told = every([so_far, one.told])
                        if told == NO or one.target == id:
                            continue
                        before = found.get(one.target, (NO, NO))
                        after = [*before]
                        after[way] = some([before[way], told])
                        if tuple(after) != before:
                            found[one.target] = (after[0], after[1])
                            holder = self.bodies.get(one.target)
                            if holder is not None and not holder.fixed:
                                todo.append((one.target, some(after)))
            self._carriers[id] = found
        return self._carriers[id]

    # --- reach -----------------------------------------------------------------------------------

    @cached_property
    def _steps(self) -> list[tuple[Body, float]]:
        """What a child climbs on, and how high it stands there, metres above the floor."""
        found = []
        for body in self.bodies.values():
            climb = self.scene.catalogue.climbs.get(body.category)
            if climb is not None:
                about_m = float(body.low[2]) + climb
                near = min((s.z for s in body.surfaces), key=lambda z: abs(z - about_m), default=0)
                own = body.surfaces and abs(near - about_m) <= OWN_TOP_M
                found.append((body, near if own else about_m))
        return found

    def reach(self, id: int) -> tuple[float, float, float, int | None]:
        """How high above where a child gets to stand: as measured, at least and at most, and what
        it climbs on."""
        body = self.bodies[id]
        low = float(body.low[2])
        near = []
        for other, stand in self._steps:
            apart = np.maximum(0, np.maximum(other.low - body.high, body.low - other.high))
            gap = float(np.linalg.norm(apart[:2]))
            if other.id != id and gap < REACH.high and stand <= low:
                told = every([self.together(id, other.id), REACH.at_most(gap)])
                if told != NO:
                    near.append((stand, other.id, told))
        measured = max((one for one in near if one[2].holds), default=(0.0, None, YES))
        surely = max((s for s, _, told in near if told == YES), default=0.0)
        perhaps = max((s for s, _, _ in near), default=0.0)
        return low - measured[0], low - perhaps, low - surely, measured[1]


def _one_room(a: tuple[int, ...], b: tuple[int, ...]) -> Told:
    if not set(a) & set(b):
        return NO
    return Told(a[0] == b[0], len(a) == len(b) == 1)


def _surer(told: Told, before: Told) -> bool:
    """Rather surely true than perhaps, rather perhaps than surely not."""
    rank = [(one.holds, one.sure == one.holds) for one in (told, before)]
    return rank[0] > rank[1]


__all__ = ["LEAST_M2", "Body", "Evidence", "Related", "World", "Zone"]
