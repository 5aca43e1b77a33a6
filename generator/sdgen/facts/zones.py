"""Shares of zones, and what follows: BLOCKS, NEAR_HEAT, NEAR_WATER.

An object is in a zone by the share of its footprint, where its range of heights meets the zone's;
in zones of some kinds by the share that lies in all of them together, so that what lies across a
border is in neither less than it is in both.
A zone that starts at the floor has no lower limit: nothing is below the floor.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from typing import NamedTuple

import numpy as np
import shapely
from shapely.geometry import Polygon
from shapely.geometry.base import BaseGeometry

from sdgen.catalog.predicate import ZoneShare
from sdgen.facts.body import Body, rows
from sdgen.facts.thresholds import (
    BLOCKING_HEIGHT_M,
    NEAR_HEAT_M,
    NEAR_WATER_M,
    ZONE_LEVEL_M,
    ZONE_SHARE,
)
from sdgen.kleene import NO, YES, Kleene, all_of, any_of
from sdgen.scene import Zone

_NEAR = {"NEAR_HEAT": ("heat", NEAR_HEAT_M), "NEAR_WATER": ("water", NEAR_WATER_M)}
_BLOCKED = ("doorway", "swing")


class Near(NamedTuple):
    """Whether a thing is near a source, and the gap from its footprint to the nearest zone."""

    holds: Kleene
    gap_m: float


class ZoneIndex:
    """All zones of a scene."""

    def __init__(self, zones: Sequence[Zone]) -> None:
        self._zones = [(zone, shapely.polygons(zone.polygon_m)) for zone in zones]
        self._outlines = {zone.name: outline for zone, outline in self._zones}
        shapely.prepare(list(self._outlines.values()))
        self._unions: dict[tuple[str, ...], BaseGeometry] = {}
        self._boxes = rows(
            [
                (*outline.bounds, zone.z_min_m if zone.z_min_m > 0 else -np.inf, zone.z_max_m)
                for zone, outline in self._zones
            ],
            6,
        )

    def _near(self, body: Body, within_m: float) -> Iterable[tuple[Zone, Polygon, Kleene]]:
        """Zones whose boxes come near the body, and whether their heights meet its own."""
        x0, y0, x1, y1, low, high = self._boxes.T
        overlap = np.minimum(high - body.low[2], body.high[2] - low)
        meets = overlap > ZONE_LEVEL_M.below
        meets &= (body.low[0] <= x1 + within_m) & (body.high[0] >= x0 - within_m)
        meets &= (body.low[1] <= y1 + within_m) & (body.high[1] >= y0 - within_m)
        for index in np.flatnonzero(meets):
            yield (*self._zones[index], ZONE_LEVEL_M.at_least(float(overlap[index])))

    def shares(self, body: Body) -> Iterable[ZoneShare]:
        """Zones the footprint touches, but those the object makes itself."""
        if body.footprint.area <= 0:
            return
        for zone, outline, level in self._near(body, 0.0):
            if zone.source_id != body.item.id and outline.intersects(body.footprint):
                yield ZoneShare(zone.name, zone.kind, body.covered_by(outline), level)

    def together(
        self, body: Body, shares: Sequence[ZoneShare], kinds: Collection[str]
    ) -> Iterable[ZoneShare]:
        """Of a body's ``shares`` the zones of these kinds taken together, under the name and kind
        of the one that has most of it: those at its height, and all that may be."""
        mine = sorted((s for s in shares if s.kind in kinds), key=lambda s: (s.fraction, s.name))
        sure = [share for share in mine if share.level == YES]
        for among, level in ((sure, YES), (mine, any_of(share.level for share in mine))):
            if not among or (among is mine and len(sure) == len(mine)):
                continue
            most = among[-1]
            fraction = most.fraction
            if len(among) > 1 and fraction < 1.0:
                fraction = body.covered_by(self._union(tuple(share.name for share in among)))
            yield ZoneShare(most.name, most.kind, fraction, level)

    def gaps(
        self, body: Body, kinds: Collection[str], any_height: bool
    ) -> list[tuple[float, Zone, Kleene]]:
        """Gaps from the footprint to the zones of these kinds that the object does not make itself,
        nearest first, and whether their heights meet its own (or are not asked for)."""
        *_, low, high = self._boxes.T
        overlap = np.minimum(high - body.low[2], body.high[2] - low).tolist()
        found = [
            (
                float(outline.distance(body.footprint)),
                zone,
                YES if any_height else ZONE_LEVEL_M.at_least(meets),
            )
            for meets, (zone, outline) in zip(overlap, self._zones, strict=True)
            if zone.kind in kinds and zone.source_id != body.item.id
        ]
        found = [one for one in found if one[2] != NO]
        return sorted(found, key=lambda one: (one[0], one[1].name))

    def _union(self, names: tuple[str, ...]) -> BaseGeometry:
        """The zones of these names as one, computed once."""
        if names not in self._unions:
            shape = shapely.union_all([self._outlines[name] for name in names])
            shapely.prepare(shape)
            self._unions[names] = shape
        return self._unions[names]

    def blocks(self, body: Body, shares: Sequence[ZoneShare]) -> dict[int, Kleene]:
        """Doors in whose zones a loose thing stands, so high that it must be walked around."""
        if body.item.fixed:
            return {}
        tall = BLOCKING_HEIGHT_M.more(float(body.high[2] - body.low[2]))
        found: dict[int, list[Kleene]] = {}
        sources = {zone.name: zone.source_id for zone, _ in self._zones}
        for share in shares:
            source = sources[share.name]
            if share.kind in _BLOCKED and source is not None:
                inside = ZONE_SHARE.at_least(share.fraction)
                found.setdefault(source, []).append(all_of((tall, inside, share.level)))
        return _said(found)

    def near(self, body: Body, relation: str) -> dict[int, Near]:
        """Sources of heat or water that a loose thing is near, by id."""
        if body.item.fixed:
            return {}
        kind, limit = _NEAR[relation]
        found: dict[int, list[Kleene]] = {}
        gaps: dict[int, float] = {}
        for zone, outline, level in self._near(body, limit.above):
            if zone.kind == kind and zone.source_id not in (None, body.item.id):
                source, gap = zone.source_id or 0, float(outline.distance(body.footprint))
                found.setdefault(source, []).append(all_of((limit.less(gap), level)))
                gaps[source] = min(gap, gaps.get(source, gap))
        return {source: Near(holds, gaps[source]) for source, holds in _said(found).items()}


def _said(found: dict[int, list[Kleene]]) -> dict[int, Kleene]:
    """By source, what any of its zones says."""
    merged = {source: any_of(parts) for source, parts in sorted(found.items())}
    return {source: holds for source, holds in merged.items() if holds != NO}
