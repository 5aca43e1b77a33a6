"""An object as `assets.jsonl` outlines it: box, footprint, surfaces, hollows and states.

Labels are measured on ``outlines_m``, not on meshes: what a reader of the files alone has.
"""

from __future__ import annotations

from functools import cached_property
from typing import NamedTuple

import numpy as np
import shapely

from tests.audit.dataset import Floats, Json, joint_motion, rotation
from tests.audit.told import NO, Limit, Told, about

#: Pieces no further apart than this, seen from above as the model stands, are one, metres.
APART_M = 0.002
#: Surfaces are stored drawn in by so much, metres.
DRAWN_IN_M = 0.01
#: From a surface's lowest corner to its highest, metres: what is tilted more carries nothing.
TILT_M = about(0.02, 0.005)
#: A footprint of less has no share in anything, square metres.
LEAST_M2 = 1e-9


class Surface(NamedTuple):
    """A level surface where it is: of whom, how high, its outline from above, whether level."""

    owner: int
    category: str
    z: float
    outline: shapely.Geometry
    level: Told


class Hollow(NamedTuple):
    """A box that things can be in, in the frame of its part, and the states of its very leaf."""

    owner: int
    category: str
    fixed: bool
    turn: Floats
    shift: Floats
    center: Floats
    half: Floats
    states: frozenset[str]
    undecided: frozenset[str]

    def depth(self, point: Floats) -> float:
        """How deep a point of the world lies within the box, metres; negative outside."""
        local = (point - self.shift) @ self.turn
        return float((self.half - np.abs(local - self.center)).min())


class Rule(NamedTuple):
    """What one rule of the model says of a state: its joint (if any) and whether it holds."""

    state: str
    joint: str | None
    holds: bool


class Body:
    """One object of ``scene.json`` as its record outlines it, where its joints put its parts."""

    def __init__(self, item: Json, record: Json) -> None:
        self.item, self.record = item, record
        self.id, self.category, self.fixed = int(item["id"]), item["category"], item["fixed"]
        self.turn = rotation(item["pose"]["quat_xyzw"])
        self.position = np.array(item["pose"]["position_m"], float)
        self._drawn: list[str] = record["variants"][item["variant"]]
        self._joint_of = {part["name"]: part["joint"] for part in record["parts"]}
        joints = item["joints"]
        moved = [p for p in self._drawn if joints.get(self._joint_of[p] or "", 0.0) != 0.0]
        still = [p for p in self._drawn if p not in moved and self._points(p)]
        leaves = [p for p in moved if self._points(p)]
        rest = self._grouped([piece for part in still for piece in self._points(part)])
        if not rest and not leaves:
            x, y, z = record["extents_m"]
            ends = [(a, b, c) for a in (-x / 2, x / 2) for b in (-y / 2, y / 2) for c in (0.0, z)]
            rest = [np.array(ends)]
        self._rest = [self.world(points) for points in rest]
        self._leaves = [self.part_world(p, np.concatenate(self._points(p))) for p in leaves]
        corners = np.concatenate([*self._rest, *self._leaves])
        self.low, self.high = corners.min(0), corners.max(0)

    def world(self, points: Floats) -> Floats:
        return np.asarray(points @ self.turn.T + self.position)

    def _motion(self, part: str) -> tuple[Floats, Floats]:
        """From a part's frame to the world: rotation and shift."""
        name = self._joint_of[part]
        if name is None:
            return self.turn, self.position
        joint = next(j for j in self.record["joints"] if j["name"] == name)
        turn, shift = joint_motion(joint, self.item["joints"].get(name, 0.0))
        return self.turn @ turn, self.turn @ shift + self.position

    def part_world(self, part: str, points: Floats) -> Floats:
        turn, shift = self._motion(part)
        return np.asarray(points @ turn.T + shift)

    def _points(self, part: str) -> list[Floats]:
        return [np.array(piece) for piece in self.record["outlines_m"].get(part, []) if piece]

    @staticmethod
    def _grouped(pieces: list[Floats]) -> list[Floats]:
        """Pieces that touch from above (in the model's frame) as one."""
        groups: list[tuple[shapely.Geometry, list[Floats]]] = []
        for piece in pieces:
            shape = shapely.convex_hull(shapely.multipoints(piece[:, :2]))
            together = [piece]
            apart = []
            for other, found in groups:
                if shapely.dwithin(shape, other, APART_M):
                    together += found
                    shape = shapely.union_all([shape, other])
                else:
                    apart.append((other, found))
            groups = [*apart, (shape, together)]
        return [np.concatenate(found) for _, found in groups]

    @cached_property
    def center(self) -> Floats:
        """The middle of the box of its variant, joints at 0."""
        points = [piece for part in self._drawn for piece in self._points(part)]
        if not points:
            return self.world(np.array([[0.0, 0.0, self.record["extents_m"][2] / 2]]))[0]
        corners = np.concatenate(points)
        return self.world((corners.min(0) + corners.max(0))[None] / 2)[0]

    @cached_property
    def trunk(self) -> shapely.Geometry:
        """What it covers from above but for the parts that joints have moved."""
        return _covered(self._rest or self._leaves)

    @cached_property
    def footprint(self) -> shapely.Geometry:
        return _covered([*self._rest, *self._leaves])

    def share_in(self, shape: shapely.Geometry) -> float:
        shared = shape.intersection(self.footprint).area
        return float(shared / max(self.footprint.area, LEAST_M2))

    @cached_property
    def surfaces(self) -> list[Surface]:
        """What things stand on, as far as it lies level."""
        found = []
        for support in self.record["supports"]:
            if support["part"] not in self._drawn:
                continue
            edge = shapely.Polygon(support["polygon_m"]).buffer(DRAWN_IN_M, join_style="mitre")
            ring = np.array(edge.exterior.coords)[:-1]
            ring = np.column_stack([ring, np.full(len(ring), support["z_m"])])
            there = self.part_world(support["part"], ring)
            level = TILT_M.at_most(float(np.ptp(there[:, 2])))
            if level != NO:
                z = float(there[:, 2].mean())
                found.append(
                    Surface(self.id, self.category, z, shapely.Polygon(there[:, :2]), level)
                )
        return found

    @cached_property
    def top(self) -> float:
        """How high what people use of it is: its highest level surface, else the top of its box."""
        return max((s.z for s in self.surfaces if s.level.holds), default=float(self.high[2]))

    @cached_property
    def rules(self) -> list[Rule]:
        """The rules of its model that say something of its variant."""
        found = []
        for rule in self.record["states"]:
            if rule["variants"] and self.item["variant"] not in rule["variants"]:
                continue
            holds = bool(rule["variants"])
            if rule["joint"] is not None:
                value = self.item["joints"].get(rule["joint"], 0.0)
                least = -np.inf if rule["min"] is None else rule["min"]
                most = np.inf if rule["max"] is None else rule["max"]
                holds = bool(least <= value <= most)
            found.append(Rule(rule["state"], rule["joint"], holds))
        return found

    @cached_property
    def states(self) -> frozenset[str]:
        """States that hold: OPEN when any leaf is, CLOSED when all are shut."""
        found = {rule.state for rule in self.rules if rule.holds}
        if any(rule.state == "CLOSED" and not rule.holds for rule in self.rules):
            found.discard("CLOSED")
        return frozenset(found)

    @cached_property
    def undecided(self) -> frozenset[str]:
        """States of joints between their two limits."""
        names = {rule.joint for rule in self.rules if rule.joint is not None}
        return frozenset().union(*(self._of_leaf(name)[1] for name in names))

    def _of_leaf(self, joint: str | None) -> tuple[frozenset[str], frozenset[str]]:
        rules = [rule for rule in self.rules if joint is not None and rule.joint == joint]
        holding = frozenset(rule.state for rule in rules if rule.holds)
        return holding, frozenset() if holding else frozenset(rule.state for rule in rules)

    @cached_property
    def hollows(self) -> list[Hollow]:
        found = []
        for hollow in self.record["containers"]:
            if hollow["part"] in self._drawn:
                turn, shift = self._motion(hollow["part"])
                center, half = np.array(hollow["center_m"]), np.array(hollow["size_m"]) / 2
                leaf = self._of_leaf(hollow["closed_by"])
                found.append(
                    Hollow(self.id, self.category, self.fixed, turn, shift, center, half, *leaf)
                )
        return found


def _covered(pieces: list[Floats]) -> shapely.Geometry:
    hulls = [shapely.convex_hull(shapely.multipoints(points[:, :2])) for points in pieces]
    return hulls[0] if len(hulls) == 1 else shapely.union_all(hulls)


def state_told(wanted: list[str], states: frozenset[str], undecided: frozenset[str]) -> Told:
    """Whether one of some states holds."""
    if states & set(wanted):
        return Told(True)
    return Told(False, not undecided & set(wanted))


__all__ = ["LEAST_M2", "Body", "Hollow", "Limit", "Surface", "state_told"]
