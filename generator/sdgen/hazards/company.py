"""What a recipe wants a thing to be near or before: found in the home, brought into a state for
it, or brought along."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass
from itertools import islice
from typing import NamedTuple

import numpy as np
import shapely
from shapely.geometry.base import BaseGeometry

from sdgen.catalog.records import Near, PlaceRecipe, SetRecipe
from sdgen.facts import Body
from sdgen.facts.body import gaps
from sdgen.geometry import Array
from sdgen.hazards.states import changed
from sdgen.home.context import HomeContext
from sdgen.home.layout import Bulk, Layout, Vec3Yaw, room_to_change
from sdgen.home.vicinity import strip_before
from sdgen.scene import ObjectInstance
from sdgen.seeding import Rng
from sdgen.vocabulary import OPENINGS

#: Bounds the search: things looked at for one to be near, and before.
COMPANY_TRIED = 4


class Companion(NamedTuple):
    """What a thing is put near: as it is to be, and as it was where it has to change for that."""

    item: ObjectInstance
    before: ObjectInstance | None = None


def companions(
    near: Near, layout: Layout, context: HomeContext, taken: Collection[int], rng: Rng
) -> Iterator[Companion]:
    """What of the home a thing may be put near, in a random order, at most COMPANY_TRIED.

    What is in another state is brought into the wanted one where the recipe may ``bring`` it, and
    nothing else has use of it (``taken``).
    """
    found = [item for item in layout.items.values() if item.category in near.to]
    order = (found[k] for k in rng.permutation(len(found)).tolist())
    yield from islice(_fit(near, order, layout, context, taken, rng), COMPANY_TRIED)


def _fit(
    near: Near,
    items: Iterator[ObjectInstance],
    layout: Layout,
    context: HomeContext,
    taken: Collection[int],
    rng: Rng,
) -> Iterator[Companion]:
    for item in items:
        if near.to_state is None or near.to_state in item.states:
            yield Companion(item)
        elif near.bring and item.id not in taken:
            after = changed(item, near.to_state, layout, context, rng)
            if (
                after is not None
                and near.to_state in after.states
                and room_to_change(layout, context.home, item, after)
            ):
                yield Companion(after, item)


@dataclass(frozen=True)
class Nook:
    """Where a thing may be for its company's sake: in the room ``room_id``, as ``near`` as that to
    the box from ``low`` to ``high`` (3,), and on a floor with its middle in ``before``; None: there
    is no such wish."""

    near: Near | None = None
    low: Array | None = None
    high: Array | None = None
    room_id: int | None = None
    before: BaseGeometry | None = None

    def takes(self, bulk: Bulk, spot: Vec3Yaw) -> bool:
        """Whether what fills this is near enough at a spot."""
        if self.low is None:
            return True
        corners = bulk.corners(spot)
        return self._within(corners.min(axis=0), corners.max(axis=0))

    def in_reach(self, item: ObjectInstance, layout: Layout) -> bool:
        """Whether something on or in a piece of furniture may be near enough at all."""
        if self.low is None:
            return True
        if self.room_id not in (None, item.room_id):
            return False
        body = Body(item, layout.library.info(item.asset))
        return self._within(body.low, body.high)

    def floor(self, bulk: Bulk) -> BaseGeometry | None:
        """Where on a floor the middle of what fills this may be; None: anywhere."""
        if self.near is None or self.low is None or self.high is None:
            return self.before
        reach = self.near.max_m + max(bulk.size_m[:2]) / 2
        around = shapely.box(*self.low[:2], *self.high[:2]).buffer(reach, quad_segs=4)
        return around if self.before is None else around.intersection(self.before)

    def _within(self, low: Array, high: Array) -> bool:
        if self.near is None or self.low is None or self.high is None:
            return True
        axes = self.near.axes
        apart = gaps(low[axes], high[axes], self.low[None, axes], self.high[None, axes])[0]
        return bool(apart <= self.near.max_m)


def _room_of(item: ObjectInstance) -> int | None:
    """The room in which things are near it; None: a door or a window is near in both of its own."""
    return None if item.category in OPENINGS else item.room_id


def nook_by(recipe: PlaceRecipe, item: ObjectInstance | None, layout: Layout) -> Nook | None:
    """Where the recipe wants its thing, near ``item`` (if it has a ``near``); None: what it is to
    be before is not there."""
    before: BaseGeometry | None = None
    if recipe.before is not None:
        found = [one for one in layout.items.values() if one.category in recipe.before.of]
        if not found:
            return None
        before = shapely.union_all(
            [strip_before(one, recipe.before.max_m, layout) for one in found]
        )
    if recipe.near is None or item is None:
        return Nook(before=before)
    body = Body(item, layout.library.info(item.asset))
    return Nook(recipe.near, body.low, body.high, _room_of(item), before)


def near_some(
    recipe: SetRecipe, items: Sequence[ObjectInstance], layout: Layout
) -> list[ObjectInstance]:
    """Those that are as near to what the recipe names as it asks for; all where it asks nothing."""
    near = recipe.near
    if near is None:
        return list(items)
    axes = near.axes
    others = [
        Body(one, layout.library.info(one.asset))
        for one in layout.items.values()
        if one.category in near.to and (near.to_state is None or near.to_state in one.states)
    ]
    out = []
    for item in items:
        body = Body(item, layout.library.info(item.asset))
        apart = (
            gaps(body.low[axes], body.high[axes], other.low[None, axes], other.high[None, axes])[0]
            for other in others
            if other.item.id != item.id and _room_of(other.item) in (None, item.room_id)
        )
        if min(apart, default=np.inf) <= near.max_m:
            out.append(item)
    return out
