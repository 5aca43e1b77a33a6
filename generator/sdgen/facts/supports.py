"""Surfaces things stand on, and ON: the highest surface that carries an object.

A thing on a plate is not on the table under it, though that may be within a centimetre; what is
inside a container is not on it.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import NamedTuple

import numpy as np
from shapely.geometry import Point, Polygon
from shapely.geometry.base import BaseGeometry

from sdgen.catalog.predicate import Related
from sdgen.facts.body import LEAST_M2, Body, rows
from sdgen.facts.surfaces import Surface
from sdgen.facts.thresholds import (
    NEAR_EDGE_M,
    ON_GAP_M,
    ON_LEVEL_M,
    ON_SHARE,
    UNDER_M,
)
from sdgen.geometry import Array
from sdgen.kleene import NO, Kleene, all_of, any_of
from sdgen.scene import Home
from sdgen.vocabulary import HALF_WALL_M


class _Carried(NamedTuple):
    """One owner's best surface below an object, and whether it would carry it."""

    surface: Surface
    gap_m: float
    share: float
    holds: Kleene


class Supports:
    """All surfaces of a scene, floors too."""

    def __init__(self, bodies: Mapping[int, Body], home: Home) -> None:
        found = [surface for body in bodies.values() for surface in body.surfaces]
        self.surfaces = [*found, *_floors(home)]
        self._by_owner: dict[int, list[Surface]] = {}
        for surface in self.surfaces:
            self._by_owner.setdefault(surface.owner, []).append(surface)
        self._boxes = rows([(s.z_m, *s.bounds) for s in self.surfaces], 5)

    def _below(self, body: Body) -> Iterable[Surface]:
        z, x0, y0, x1, y1 = self._boxes.T
        near = np.abs(body.low[2] - z) < ON_GAP_M.above
        near &= (body.low[0] <= x1) & (body.high[0] >= x0)
        near &= (body.low[1] <= y1) & (body.high[1] >= y0)
        for index in np.flatnonzero(near):
            if self.surfaces[index].owner != body.item.id:
                yield self.surfaces[index]

    def _carriers(self, body: Body) -> list[_Carried]:
        best: dict[int, _Carried] = {}
        for surface in self._below(body):
            gap = float(body.low[2]) - surface.z_m
            share = body.covered_by(surface.outline)
            holds = all_of((surface.level, ON_GAP_M.at_most(abs(gap)), ON_SHARE.more(share)))
            found = _Carried(surface, gap, share, holds)
            before = best.get(surface.owner)
            if holds != NO and (before is None or _rank(holds) > _rank(before.holds)):
                best[surface.owner] = found
        return [best[owner] for owner in sorted(best)]

    def on(self, body: Body, inside: Mapping[int, Kleene]) -> Iterable[Related]:
        """What the object is ON, or nearly; ``inside`` says for whom it is INSIDE."""
        carriers = self._carriers(body)
        for one in carriers:
            lower = (_below(one, other) for other in carriers if other is not one)
            within = inside.get(one.surface.owner, NO)
            holds = all_of((one.holds, within.negated(), *(part.negated() for part in lower)))
            if holds != NO:
                evidence = {"gap_m": one.gap_m, "overlap": min(one.share, 1.0)}
                yield Related(one.surface.owner, one.surface.category, *holds, evidence)

    def part_under(self, body: Body, owner: int) -> str | None:
        """The part of ``owner`` whose surface carries the object, whatever it is INSIDE too."""
        for one in self._carriers(body):
            if one.surface.owner == owner:
                return one.surface.part
        return None

    def of(self, owner: int) -> Sequence[Surface]:
        """The surfaces of a thing, or of a room's floor."""
        return self._by_owner.get(owner, ())

    def carried_share(self, outline: BaseGeometry, low_m: float, own: int) -> float:
        """Largest share of an outline that lies over one surface, of any but its own, near
        ``low_m``."""
        x0, y0, x1, y1 = outline.bounds
        z, *box = self._boxes.T
        near = (np.abs(low_m - z) < ON_GAP_M.above) & (x0 <= box[2]) & (x1 >= box[0])
        near &= (y0 <= box[3]) & (y1 >= box[1])
        found = [self.surfaces[k] for k in np.flatnonzero(near).tolist()]
        areas = [outline.intersection(s.outline).area for s in found if s.owner != own]
        return float(max(areas, default=0.0) / max(outline.area, LEAST_M2))

    def near_edge(self, body: Body, target: int) -> bool:
        """The centre is near the edge of a surface of ``target`` that the object is on."""
        point = Point(body.center[:2])
        return any(
            surface.level.value
            and ON_GAP_M.at_most(abs(float(body.low[2]) - surface.z_m)).value
            and surface.outline.exterior.distance(point) < NEAR_EDGE_M
            for surface in self._by_owner.get(target, ())
        )

    def over(self, owner: int, top_m: float) -> Kleene:
        """A level surface of ``owner`` lies over what is as high as ``top_m``."""
        surfaces = sorted(self._by_owner.get(owner, ()), key=lambda s: s.z_m, reverse=True)
        return any_of(all_of((s.level, UNDER_M.at_least(s.z_m - top_m))) for s in surfaces)

    def roofs(self, bodies: Mapping[int, Body]) -> tuple[list[int], Array, Array]:
        """Built-in things with surfaces: ids, their highest surface (N,), and boxes (N, 4).

        Those that may be too tilted count, too: :meth:`over` says how surely.
        """
        tops: dict[int, float] = {}
        for surface in self.surfaces:
            owner = bodies.get(surface.owner)
            if owner is not None and owner.item.fixed:
                tops[surface.owner] = max(tops.get(surface.owner, surface.z_m), surface.z_m)
        boxes = rows([(*bodies[k].low[:2], *bodies[k].high[:2]) for k in tops], 4)
        return list(tops), np.array(list(tops.values())), boxes


def _rank(holds: Kleene) -> tuple[bool, bool]:
    """Order of Kleene's "or": surely true, unsurely true, unsurely false, surely false."""
    return holds.value, holds.sure == holds.value


def _below(one: _Carried, other: _Carried) -> Kleene:
    """``other`` carries the object and is a level higher than ``one``."""
    return all_of((other.holds, ON_LEVEL_M.more(one.gap_m - other.gap_m)))


def _floors(home: Home) -> Iterable[Surface]:
    """Each room's floor, to the middle of its walls: doorways have a floor, too."""
    rooms = {room.id: room for room in home.rooms}
    floors = {s.room_id: s.id for s in home.structures if s.category == "floor"}
    for room_id, floor_id in floors.items():
        outline = Polygon(rooms[room_id].polygon_m).buffer(HALF_WALL_M, join_style="mitre")
        yield Surface(floor_id, "floor", 0.0, outline, outline.bounds)
