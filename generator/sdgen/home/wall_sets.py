"""What people hang on walls: over furniture, and in the middle of what would stay bare; one, or two
or three of one size side by side."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import shapely
from shapely.geometry.base import BaseGeometry

from sdgen.catalog.records import Fitting
from sdgen.freespace import opening_rectangle
from sdgen.geometry import Array, yaw_of
from sdgen.home.anchors import HUNG_GAP_M, PlacedAt, Side
from sdgen.home.clearances import Sight
from sdgen.home.layout import Layout, space_at
from sdgen.home.room_try import free_parts
from sdgen.library.records import Asset, AssetInfo
from sdgen.scene import ObjectInstance, Opening, Room
from sdgen.seeding import Rng
from sdgen.vocabulary import DOORS

#: From the back of a piece of furniture to the wall that it stands at.
AT_WALL_M = 0.1
#: Over furniture, under the ceiling and beside what else is at the wall, metres: pictures hang 20
#: to 30 cm over a sofa, whose cushions and lamps would hide them lower.
OVER_M, UNDER_CEILING_M, CLEAR_M = 0.22, 0.12, 0.12
#: What stands out of the wall or before it by less is in the way of what hangs.
BEFORE_WALL_M = 0.3
#: Between two of a set, and how much of the furniture below or of the stretch of wall it takes at
#: most; a set that takes less than the least looks lost, if there is a wider one.
APART_M = 0.09
LEAST_SHARE, MOST_SHARE = 0.35, 0.85
#: What hangs over furniture higher than this is not looked at.
HIGHEST_M = 1.75
#: Two sizes are one but for so much.
ONE_SIZE_M = 0.01

#: Models with where they hang.
Hung = list[tuple[Asset, PlacedAt]]


@dataclass(frozen=True)
class WallSets:
    """What a fitting hangs on the walls of a room, of these ``models``; ``swings``: where doors
    swing, ``sights``: what of doors and windows is not covered."""

    fitting: Fitting
    models: Sequence[Asset]
    room: Room
    layout: Layout
    sides: Sequence[Side]
    openings: Sequence[tuple[Opening, Sight]]
    swings: BaseGeometry
    rng: Rng

    def over(self, item: ObjectInstance) -> Hung:
        """A set over the middle of a piece of furniture at a wall; empty where none goes."""
        behind = wall_behind(item, self.layout, self.sides)
        if behind is None:
            return []
        side, along = behind
        top = max(
            self.layout.items[k].pose.position_m[2] + self.layout.info(k).extents_m[2]
            for k in self._standing_on(item.id)
        )
        wide = self.layout.info(item.id).extents_m[1] * MOST_SHARE
        for chosen in self._sets(wide):
            tall = chosen[0].extents_m[2]
            low = max(self.fitting.z_m - tall / 2, top + OVER_M)
            if low + tall > self.room.height_m - UNDER_CEILING_M or low > HIGHEST_M:
                continue
            half = _width(chosen) / 2
            for part in self._free(side, low, low + tall):
                start, _ = side.measure(part.start)
                if start <= along - half and along + half <= start + part.length_m:
                    return _side_by_side(chosen, side, along, low)
        return []

    def bare(self) -> Iterator[Hung]:
        """A set in the middle of each stretch of wall that is bare over ``least_m``, and again
        where a stretch beside it still is."""
        tall = max(m.extents_m[2] for m in self.models)
        low, high = self.fitting.z_m - tall / 2, self.fitting.z_m + tall / 2
        for side in self.sides:
            seen: set[tuple[float, ...]] = set()
            todo = self.bare_parts(side, low, high)
            while todo:
                part = max(todo, key=lambda p: p.length_m)
                seen.add(_key(part))
                chosen = next(self._sets(part.length_m * MOST_SHARE), None)
                if self.rng.random() < self.fitting.chance and chosen:
                    z = self.fitting.z_m - chosen[0].extents_m[2] / 2
                    yield _side_by_side(chosen, part, part.length_m / 2, z)
                todo = [p for p in self.bare_parts(side, low, high) if _key(p) not in seen]

    def bare_parts(self, side: Side, low: float, high: float) -> list[Side]:
        """The stretches of a wall that are bare over ``least_m`` between two heights."""
        least_m = self.fitting.least_m
        if side.length_m < least_m:
            return []
        parts = self._free(side, low, high)
        return [p for p in parts if p.length_m >= least_m - 2 * CLEAR_M]

    def _standing_on(self, item_id: int) -> list[int]:
        """A piece, and what furniture stands on it (a television)."""
        on = (k for k, intent in self.layout.intents.items() if intent.target_id == item_id)
        return [item_id, *on]

    def _sets(self, wide: float) -> Iterator[list[Asset]]:
        """Sets no wider than this, those first that are of what the room and the home have least
        of, and wide enough; as many of one size as are drawn."""
        there = Counter(item.asset for item in self.layout.items.values())
        inside = (k for k, i in self.layout.items.items() if i.room_id == self.room.id)
        here = {_shows(self.layout.info(k)) for k in inside}
        order = [self.models[k] for k in self.rng.permutation(len(self.models)).tolist()]
        order = [m for m in order if _shows(m) not in here and m.extents_m[1] <= wide]
        order.sort(key=lambda m: there[m.id])
        drawn = int(self.rng.integers(self.fitting.count[0], self.fitting.count[1] + 1))
        found: list[list[Asset]] = []
        for model in order:
            mates = [model]
            for other in order:
                if _of_one_size(other, model) and _shows(other) not in map(_shows, mates):
                    mates.append(other)
            fit = int((wide + APART_M) / (model.extents_m[1] + APART_M))
            found.append(mates[: max(1, min(drawn, fit))])
        # Stable: of those that are wide enough, what there is least of.
        yield from sorted(found, key=lambda s: _width(s) < LEAST_SHARE * wide)

    def _free(self, side: Side, low: float, high: float) -> list[Side]:
        """The stretches of a wall with nothing before them between two heights, nor swinging
        there, a little shorter than they are."""
        strip = space_at(
            (BEFORE_WALL_M, side.length_m, high - low),
            (*side.at(side.length_m / 2, BEFORE_WALL_M / 2), low),
            side.yaw,
            0.0,
        )
        taken: list[Array] = [
            block.outline
            for k in sorted(set(self.layout.entered([strip])))
            for block in self.layout.space_of(k)
            if block.box[2] < high and block.box[5] > low
        ]
        for opening, sight in self.openings:
            if sight.low_m < high and sight.high_m > low:
                taken.append(shapely.get_coordinates(opening_rectangle(opening, BEFORE_WALL_M)))
        if low < max((s.high_m for o, s in self.openings if o.kind in DOORS), default=0.0):
            swept = shapely.intersection(self.swings, strip.shape)
            taken += [shapely.get_coordinates(p) for p in shapely.get_parts(swept)]
        return [
            replace(p, start=p.at(CLEAR_M, 0.0), length_m=p.length_m - 2 * CLEAR_M)
            for p in free_parts(side, [t for t in taken if len(t)], BEFORE_WALL_M)
            if p.length_m > 2 * CLEAR_M
        ]


def wall_behind(
    item: ObjectInstance, layout: Layout, sides: Sequence[Side]
) -> tuple[Side, float] | None:
    """The wall at the back of a piece, and how far along it the piece's middle is."""
    deep = layout.info(item.id).extents_m[0]
    yaw = yaw_of(item.pose.quat_xyzw)
    for side in sides:
        along, away = side.measure(item.pose.position_m[:2])
        backed = math.cos(yaw - side.yaw) > 0.99 and away - deep / 2 < AT_WALL_M
        if backed and 0 < along < side.length_m:
            return side, along
    return None


def _side_by_side(chosen: Sequence[Asset], side: Side, along: float, z: float) -> Hung:
    """A set with its middle there."""
    out: Hung = []
    t = along - _width(chosen) / 2
    for model in chosen:
        deep, wide, _ = model.extents_m
        out.append((model, (*side.at(t + wide / 2, deep / 2 + HUNG_GAP_M), z, side.yaw)))
        t += wide + APART_M
    return out


def _shows(model: AssetInfo) -> str:
    """What a picture shows: its title ends with it ("poster, leaves"); several frames hold one."""
    return model.title.rpartition(", ")[2]


def _width(chosen: Sequence[Asset]) -> float:
    return sum(m.extents_m[1] for m in chosen) + APART_M * (len(chosen) - 1)


def _of_one_size(one: Asset, other: Asset) -> bool:
    pairs = zip(one.extents_m[1:], other.extents_m[1:], strict=True)
    return all(abs(a - b) < ONE_SIZE_M for a, b in pairs)


def _key(part: Side) -> tuple[float, ...]:
    return (*(round(v, 3) for v in part.start), round(part.length_m, 3))
