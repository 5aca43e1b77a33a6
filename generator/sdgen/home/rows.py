"""Rows: what people line up on shelves and racks, front to the front, side by side or in piles.

Every pose is computed: things start a millimetre above what carries them and touch nothing else,
so that settling moves none.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Sequence

import numpy as np

from sdgen.catalog.records import Category
from sdgen.catalog.row import Row
from sdgen.geometry import Vec2, yaw_of
from sdgen.home.context import HomeContext
from sdgen.home.layout import DROP_M, HEADROOM_LEFT_M, Bulk, Intent, Layout, Vec3Yaw, space_at
from sdgen.home.small_on_small import spot_square_on
from sdgen.home.stock import Abodes, Choices, Pick, Stock
from sdgen.home.surfaces import PlacingSurface
from sdgen.library.records import Asset
from sdgen.scene import ObjectInstance, Room
from sdgen.seeding import Rng

#: Between neighbours of a row, metres: they settle straight down and never touch.
ROW_GAP_M = 0.003
#: How far the row's front is behind the edge of the shelf, metres (by eye).
SET_BACK_M = (0.0, 0.03)
#: Poses are rounded: what ends at the very edge of a shelf may be a hair beyond it.
ROUND_M = 0.001
#: Kept free to both sides of what stood on the shelf before, and all before it, metres: a row
#: beside or in front of an anomaly would hide it from the views that were chosen to show it.
SIGHT_M = 0.05
#: Draws of a model for one place of a row: most that fail are too high or too deep for the shelf.
TRIES = 8
#: Where none of them goes, the row goes on this much further, metres.
STEP_M = 0.06
#: Boards whose heights differ by less are one level; those that do by less than the second are next
#: to each other, and a twin on the one of what stands on the other is passed over in so many draws.
LEVEL_M, NEXT_M, PASSED_OVER = 0.05, 0.45, 5
#: Models drawn for one place where the widest stands.
WIDE_DRAWS = 4
#: Draws of a model for a place of a pile: most that fail are larger than what they would lie on.
PILE_TRIES = 3
#: A shelf with room for fewer than so many of the narrowest things is short.
SHORT = 3
#: Between piles, which are not as straight.
PILE_GAP_M = 0.02
#: Of what is flatter, metres, nobody can say surely that it is INSIDE.
FLAT_M = 0.012
#: Surfaces with less of their bounding rectangle than this are no shelves to fill.
SQUARE_SHARE = 0.7


def fill_rows(
    layout: Layout,
    receptacle: ObjectInstance,
    room: Room,
    rows: Sequence[Row],
    abodes: Abodes,
    stock: Stock,
    context: HomeContext,
    rng: Rng,
) -> int:
    """Fill the shelves of a placed piece of furniture, each by the first of ``rows`` that is done
    there and finds room, over a share of its length drawn from the row's ``filled``. Returns how
    many things were put there."""
    placed = 0
    for surface in layout.surfaces_of(receptacle.id) if rows else ():
        shelf = _Shelf(layout, receptacle, surface, room, stock, context)
        there = _models_about(layout, receptacle.id, surface.z_m, LEVEL_M)
        for row in rows:
            elsewhere = row.rooms and room.type not in row.rooms
            on_top = surface.support.headroom_m is None and not row.top
            if elsewhere or on_top or rng.random() >= row.chance:
                continue
            shelf.at_back = row.at_back
            choices = abodes.choices(receptacle.category, room, row.of, relation=shelf.relation)
            if choices is not None:
                choices = shelf.room_for(choices, row.over_m)
            done = _fill(shelf, row, choices, there, rng) if choices is not None else 0
            placed += done
            if done and row.beside:
                more = abodes.choices(
                    receptacle.category, room, row.beside, relation=shelf.relation
                )
                placed += _set_beside(shelf, more, there, rng) if more is not None else 0
            if done:
                break
    return placed


def _models_about(layout: Layout, receptacle_id: int, z_m: float, reach_m: float) -> set[str]:
    """The models that stand about a height of a piece of furniture: the next compartment of a board
    shows its own too near for twins."""
    return {
        layout.items[key].asset
        for key, intent in layout.intents.items()
        if intent.target_id == receptacle_id
        and abs(layout.items[key].pose.position_m[2] - z_m) < reach_m
    }


class _Shelf:
    """A surface as a row sees it: ``along`` runs left to right, ``out`` to its front edge, from
    the origin of the piece of furniture."""

    def __init__(
        self,
        layout: Layout,
        receptacle: ObjectInstance,
        surface: PlacingSurface,
        room: Room,
        stock: Stock,
        context: HomeContext,
    ) -> None:
        self.layout, self.receptacle, self.surface = layout, receptacle, surface
        self.room, self.stock, self.context = room, stock, context
        self.yaw = yaw_of(receptacle.pose.quat_xyzw)
        cos, sin = math.cos(self.yaw), math.sin(self.yaw)
        self._out, self._along = (cos, sin), (-sin, cos)
        x, y, _ = receptacle.pose.position_m
        self._origin = x, y
        corners = np.array(surface.shape.exterior.coords)[:-1] - (x, y)
        out, along = corners @ self._out, corners @ self._along
        self.back, self.front = float(out.min()) + ROUND_M, float(out.max()) - ROUND_M
        self.left, self.right = float(along.min()) + ROUND_M, float(along.max()) - ROUND_M
        hollow = surface.support.container
        self.relation = "ON" if hollow is None else "INSIDE"
        info = layout.info(receptacle.id)
        self._leaf = any(c.name == hollow and c.closed_by for c in info.containers)
        # A fridge is as full when its door stands open as when no view looks in.
        shuts = not {"OPEN", "CLOSED"}.isdisjoint(receptacle.states)
        self._shut_in = hollow is not None and shuts
        #: The models of the boards above and below, too.
        self.next = _models_about(layout, receptacle.id, surface.z_m, NEXT_M)
        # Drawn once a shelf, by category: whether its things are to lie where views show them.
        self._shown: dict[str, bool] = {}
        #: Whether what is put there stands at the back, not at the front edge.
        self.at_back = False

    def spans(self) -> list[tuple[float, float]]:
        """Where along the shelf nothing stands yet, nor is seen past the row's end."""
        deep, wide = self.front - self.back, self.right - self.left
        if self.surface.support.area_m2 < SQUARE_SHARE * deep * wide:
            return []
        high = self.surface.support.headroom_m or SIGHT_M
        middle = self._at((self.front + self.back) / 2, (self.left + self.right) / 2)
        base = (*middle, self.surface.z_m)
        whole = space_at((deep, wide, high - DROP_M), base, self.yaw, 0.0, DROP_M)
        ends = [self.left]
        for key in sorted(set(self.layout.entered([whole])) - {self.receptacle.id}):
            for block in self.layout.space_of(key):
                along = (block.outline - self._origin) @ np.array(self._along)
                ends += [float(along.min()) - SIGHT_M, float(along.max()) + SIGHT_M]
        return _between(ends, self.right)

    def spot(self, asset: Asset, span: tuple[float, float], set_back: float) -> Vec3Yaw | None:
        """Where a thing stands at the left end of a span; None where it does not go."""
        deep, wide, _ = asset.extents_m
        left, right = span
        if left + wide > right:
            return None
        out = max(self.front - set_back - deep / 2, self.back + deep / 2)
        if self.at_back:
            out = min(self.back + set_back + deep / 2, out)
        point = self._at(out, left + wide / 2)
        # Of what may reach over the edge, the part over the shelf is looked at.
        over = max(0.0, out + deep / 2 - self.front)
        inner = self._at(out - over / 2, left + wide / 2)
        if not self.surface.carries((deep - over, wide, 0.0), inner, self.yaw):
            return None
        base = (*point, self.surface.z_m)
        block = space_at(asset.extents_m, base, self.yaw, ROW_GAP_M / 3, DROP_M)
        return (base, self.yaw) if self.layout.fits([block], self.receptacle.id) else None

    def air_m(self, z_m: float) -> float:
        """How high a thing that stands at ``z_m`` may be, a hand's room left above it."""
        headroom = self.surface.support.headroom_m
        return math.inf if headroom is None else self.surface.z_m + headroom - HEADROOM_LEFT_M - z_m

    def room_for(self, choices: Choices, over_m: float = 0.0) -> Choices | None:
        """What of these may be put and is no larger than the shelf, over whose edge it may reach so
        far."""
        size = (self.front - self.back + over_m, self.right - self.left)
        return choices.no_larger((*size, self.air_m(self.surface.z_m)), self.full)

    def full(self, category: Category) -> bool:
        """Whether the room, or the home, has as many of a category as it may."""
        return self.stock.full(category, self.room.id)

    def takes(self, asset: Asset, spot: Vec3Yaw, rng: Rng) -> bool:
        """Whether a thing may be at a spot of the shelf, by what it is and who sees or reaches
        it."""
        context, hollow = self.context, self.surface.support.container
        if hollow is None:
            fits = context.reach.beyond(asset, spot, self.room.id)
        else:
            fits = (
                asset.extents_m[2] >= FLAT_M
                and context.may_hold(asset.category, self.receptacle.category, hollow)
                and (self._leaf or context.reach.needed_m(asset) is None)
            )
        if not fits:
            return False
        if asset.category in self.layout.fronted and context.faces_wall(self.room.id, spot):
            return False
        if asset.category not in self._shown:
            keeps = not self._shut_in and context.keeps_to_views(asset.category, rng)
            self._shown[asset.category] = keeps
        return not self._shown[asset.category] or context.shows_at(Bulk(asset.extents_m), spot)

    def put(self, asset: Asset, spot: Vec3Yaw, intent: Intent) -> ObjectInstance:
        """A new thing at a spot."""
        item = self.layout.new_item(asset, spot, self.room.id)
        self.layout.put(item, intent)
        self.stock.add(item, self.receptacle.id)
        return item

    def _at(self, out: float, along: float) -> Vec2:
        (x, y), (a, b), (c, d) = self._origin, self._out, self._along
        return x + out * a + along * c, y + out * b + along * d


def _between(ends: Sequence[float], last: float) -> list[tuple[float, float]]:
    """What is left from the first of ``ends`` to ``last`` between the pairs (start, end) after."""
    at, free = ends[0], []
    for start, end in sorted(zip(ends[1::2], ends[2::2], strict=True)):
        if start > at:
            free.append((at, min(start, last)))
        at = max(at, end)
    return [*free, (at, last)] if at < last else free


def _fill(shelf: _Shelf, row: Row, choices: Choices, taken: set[str], rng: Rng) -> int:
    """Put things side by side until the row's share of the shelf's length is taken; how many."""
    set_back = float(rng.uniform(*SET_BACK_M))
    gap_m = PILE_GAP_M if row.pile[1] > 1 else ROW_GAP_M
    # What is left over is at one end, or in one gap between; on short shelves at the right end.
    length = shelf.right - shelf.left
    wanted = float(rng.uniform(*row.filled)) * length
    spare = length - wanted if length > SHORT * choices.narrowest_m else 0.0
    gap_at = shelf.left + float(rng.uniform(0.0, wanted))
    placed, only, narrowest_m = 0, None, choices.narrowest_m
    draws = WIDE_DRAWS if row.wide else 1
    spans = shelf.spans()
    while spans:
        at, right = spans.pop(0)
        # The last thing takes the row nearer to its share than it was.
        while wanted > narrowest_m / 2 and at + narrowest_m <= right:
            if spare and at >= gap_at:
                # Where too little fits beside the gap, the last of the row stands in it.
                spans.append((at, min(at + spare, right)))
                at, spare = at + spare, 0.0
                continue
            stood = _stand(shelf, choices, only, (at, right), set_back, taken, rng, draws)
            if stood is None:
                at += STEP_M
                continue
            item, picked = stood
            only = picked if row.same else None
            taken.add(picked.asset.id)
            high = int(rng.integers(row.pile[0], row.pile[1] + 1))
            placed += 1 + _pile(shelf, choices, picked, item, high - 1, taken, rng)
            at += picked.asset.extents_m[1] + gap_m
            wanted -= picked.asset.extents_m[1] + gap_m
    return placed


def _set_beside(shelf: _Shelf, choices: Choices, taken: Collection[str], rng: Rng) -> int:
    """Set one thing in the middle of the widest gap that a row leaves; how many were."""
    fitting = shelf.room_for(choices)
    gap = max(shelf.spans(), key=lambda span: span[1] - span[0], default=None)
    if gap is None or fitting is None:
        return 0
    middle, wide = (gap[0] + gap[1]) / 2, gap[1] - gap[0]
    for _ in range(TRIES):
        picked = fitting.draw(rng)
        half = picked.asset.extents_m[1] / 2
        twin = picked.asset.id in taken and not picked.category.alike
        if twin or 2 * half > wide:
            continue
        span = (middle - half, middle + half + ROUND_M)
        if _stand(shelf, fitting, picked, span, max(SET_BACK_M), taken, rng) is not None:
            return 1
    return 0


def _stand(
    shelf: _Shelf,
    choices: Choices,
    only: Pick | None,
    span: tuple[float, float],
    set_back: float,
    taken: Collection[str],
    rng: Rng,
    draws: int = 1,
) -> tuple[ObjectInstance, Pick] | None:
    """Stand one thing at the left end of a span of a shelf, ``only`` this model if one is given,
    none that is ``taken`` unless it comes in several; the widest of some ``draws``. None where none
    goes."""
    for trial in range(TRIES if only is None else 1):
        picked = only or _widest([choices.draw(rng) for _ in range(draws)], span[1] - span[0])
        known = picked.asset.id in taken or (trial < PASSED_OVER and picked.asset.id in shelf.next)
        twin = known and not (only or picked.category.alike)
        if twin or shelf.full(picked.category):
            continue
        spot = shelf.spot(picked.asset, span, set_back)
        if spot is None or not shelf.takes(picked.asset, spot, rng):
            continue
        intent = Intent(picked.abode.relation, shelf.receptacle.id)
        return shelf.put(picked.asset, spot, intent), picked
    return None


def _widest(drawn: Sequence[Pick], room_m: float) -> Pick:
    """The widest of what was drawn that has room; the narrowest where none has."""
    wide = sorted(drawn, key=lambda pick: pick.asset.extents_m[1])
    return next((p for p in reversed(wide) if p.asset.extents_m[1] <= room_m), wide[0])


def _pile(
    shelf: _Shelf,
    choices: Choices,
    picked: Pick,
    below: ObjectInstance,
    more: int,
    taken: set[str],
    rng: Rng,
) -> int:
    """Put more on one that lies, of its model if it comes in several, else of others of its
    category that are not ``taken``; how many find room."""
    for placed in range(more):
        put = None
        for _ in range(1 if picked.category.alike else PILE_TRIES):
            upper = picked if picked.category.alike else choices.draw(rng)
            twin = upper.asset.id in taken and not upper.category.alike
            if upper.category == picked.category and not twin:
                put = _lay_on(shelf, upper, below, rng)
            if put is not None:
                break
        if put is None:
            return placed
        taken.add(put.asset)
        below = put
    return more


def _lay_on(shelf: _Shelf, picked: Pick, below: ObjectInstance, rng: Rng) -> ObjectInstance | None:
    """Lay one thing square on another; None where it does not go."""
    asset = picked.asset
    spot = spot_square_on(shelf.layout, asset, below.id, shelf.receptacle.id, rng)
    if spot is None or asset.extents_m[2] > shelf.air_m(spot[0][2]):
        return None
    if shelf.full(picked.category) or not shelf.takes(asset, spot, rng):
        return None
    return shelf.put(asset, spot, Intent("ON", below.id))
