"""Living traces: what people do, as groups of things that belong together where they do it.

The rules are data (``activities/*.yaml``). What does not fit is left out, as all clutter is; what
would be a hazard by reach, or lie in somebody's way, is never put there.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import partial
from itertools import islice

from sdgen.actions import in_state
from sdgen.catalog.activity import Activity, Member
from sdgen.geometry import Vec2, yaw_of
from sdgen.home.context import IN_VIEW_SHARE, KEEP_CLEAR, HomeContext
from sdgen.home.frames import Frame, beside, frames, half_reach, main_surface, near
from sdgen.home.ground import Ground
from sdgen.home.layout import (
    DROP_M,
    HEADROOM_LEFT_M,
    Bulk,
    Intent,
    Layout,
    Vec3Yaw,
    at_spot,
    space_at,
)
from sdgen.home.small_on_small import spot_on_small, spot_square_on
from sdgen.home.stock import Stock
from sdgen.home.surfaces import PlacingSurface
from sdgen.library.records import Asset
from sdgen.library.states import rest_states
from sdgen.scene import ObjectInstance, Room
from sdgen.seeding import Rng, weighted_keys

#: Places tried for an activity on one piece where there is no end of them, and spots for a member.
PLACES_TRIED, SPOTS_TRIED = 4, 3
#: Models tried for a member, and for what lies on or in one: most are too large for that.
MODELS_TRIED, HELD_TRIES = 3, 6
#: On a floor the first of a group lies so near the middle of a piece it is by, metres, the others
#: so near the first.
NEAR_M, TOGETHER_M = 2.2, 0.8
#: Left between things of a group: they stand closer than strangers.
GAP_M = 0.005
#: How much tidy and (in addition) messy people leave things off line, metres and radians: by eye.
TIDY_OFF, MESSY_OFF = (0.003, 0.03), (0.02, 0.3)


def add_activities(layout: Layout, context: HomeContext, stock: Stock, rng: Rng) -> Counter[int]:
    """Leave traces of activities in every room; how many things came onto each piece (by id)."""
    catalog = context.catalog
    done: Counter[str] = Counter()
    busy: Counter[int] = Counter()
    for room in context.home.rooms:
        here = [a for a in catalog.activities if _may_be(a, room, context)]
        pieces = [item for item in layout.items.values() if item.fixed and item.room_id == room.id]
        floor = context.floor_id(room.id)
        for target in (*pieces, None):
            there: list[Activity] = []
            fitting = [
                a
                for a in here
                if (a.where == "floor" if target is None else target.category in a.at)
            ]
            for activity in _in_turn(fitting, rng):
                if rng.random() >= activity.chance or done[activity.name] == activity.in_home:
                    continue
                if any(a.name in activity.excludes or activity.name in a.excludes for a in there):
                    continue
                group = _Group(activity, layout, context, stock, room, rng)
                many = group.on_floor(floor) if target is None else group.on_piece(target)
                if many:
                    there.append(activity)
                    done[activity.name] += 1
                    busy[floor if target is None else target.id] += many
    return busy


def _may_be(activity: Activity, room: Room, context: HomeContext) -> bool:
    low, high = activity.tidiness
    return (not activity.rooms or room.type in activity.rooms) and low <= context.tidiness <= high


def _in_turn(among: Sequence[Activity], rng: Rng) -> list[Activity]:
    """Activities in a random order, the frequent ones mostly first."""
    if len(among) < 2:
        return list(among)
    keys = weighted_keys(rng, [max(a.chance, 1e-3) for a in among])
    return [among[int(k)] for k in (-keys).argsort(kind="stable")]


@dataclass
class _Group:
    """One occurrence of an activity: its models, and what of it stands already."""

    activity: Activity
    layout: Layout
    context: HomeContext
    stock: Stock
    room: Room
    rng: Rng
    in_view: bool = False
    #: By name, what stands at the place that is being filled.
    placed: dict[str, ObjectInstance] = field(default_factory=dict)
    #: Every id there.
    ids: list[int] = field(default_factory=list)
    #: By category, the model that all of the group are of, such as plates of a set.
    models: dict[str, Asset] = field(default_factory=dict)

    def on_piece(self, piece: ObjectInstance) -> int:
        """Put the group onto a piece of furniture; how many things stand there."""
        activity, layout = self.activity, self.layout
        surface = main_surface(layout, piece.id)
        if surface is None or (activity.near and not near(layout, piece, activity.near)):
            return 0
        if not self._seen(piece.id):
            return 0
        low, high = activity.places
        places = int(self.rng.integers(low, high + 1))
        found = frames(layout, piece, surface, activity.where, self.context.catalog, self.rng)
        total = 0
        for frame in islice(found, None if activity.where == "seat" else PLACES_TRIED):
            moved = frame.moved(*self._off())
            many = self._fill(partial(self._spot_on, piece, surface, moved), piece.id)
            total += many
            places -= many > 0
            if places == 0:
                break
        return total

    def on_floor(self, floor_id: int) -> int:
        """Put the group aside on the room's floor; how many things lie there."""
        close = [
            item.pose.position_m[:2]
            for item in self.layout.items.values()
            if item.room_id == self.room.id and item.category in self.activity.near
        ]
        if (self.activity.near and not close) or not self._seen(self.room.id):
            return 0
        ground = self.context.ground(self.room.id, KEEP_CLEAR)
        return self._fill(partial(self._spot_aside, ground, close), floor_id)

    def _seen(self, target_id: int) -> bool:
        """Draws whether what of it may be taken for an anomaly is to be seen; False where it cannot
        be then, and is not without."""
        self.in_view = self.rng.random() < IN_VIEW_SHARE
        made = self.context.made_categories
        needed = (member.thing for member in self.activity.members if member.needed)
        if not self.in_view or not any(made.issuperset(things) for things in needed):
            return True
        return self.context.shows.anything_on(target_id)

    def _fill(self, spot_for: Callable[[Member, Asset], Vec3Yaw | None], target_id: int) -> int:
        """Put the members there, in their order; how many stand."""
        self.placed.clear()
        self.ids.clear()
        for member in self.activity.members:
            stands = False
            for _ in range(self._count(member)):
                put = self._held if member.on or member.inside else self._stand
                item = put(member, spot_for, target_id)
                if item is None:
                    break
                stands = True
                self.ids.append(item.id)
                self.placed[member.called] = item
            if member.needed and not stands:
                for thing_id in self.ids:
                    self.layout.drop(thing_id)
                return 0
        for thing_id in self.ids:
            self.stock.add(self.layout.items[thing_id], self.layout.intents[thing_id].target_id)
        return len(self.ids)

    def _count(self, member: Member) -> int:
        if self.rng.random() >= member.chance:
            return 0
        return int(self.rng.integers(member.count[0], member.count[1] + 1))

    def _stand(
        self,
        member: Member,
        spot_for: Callable[[Member, Asset], Vec3Yaw | None],
        target_id: int,
    ) -> ObjectInstance | None:
        """Put a thing of a member where its place is; None where it does not go."""
        for _ in range(MODELS_TRIED):
            asset = self._model(member, target_id)
            if asset is None:
                return None
            spot = spot_for(member, asset)
            if spot is not None:
                return self._put(member, asset, spot, Intent("ON", target_id))
            if not self.ids:
                # Nothing of a set stands yet: another may be smaller.
                self.models.pop(asset.category, None)
        return None

    def _held(self, member: Member, _spot_for: object, target_id: int) -> ObjectInstance | None:
        """Put a thing of a member on or in another; None where it does not go."""
        # The next of a pile lies on the one before.
        holder = self.placed.get(member.called) if member.pile else None
        holder = holder or self.placed.get(member.on or member.inside or "")
        relation = "ON" if member.on else "INSIDE"
        for _ in range(HELD_TRIES if holder else 0):
            asset = self._model(member, target_id)
            if asset is None or holder is None:
                return None
            info = self.layout.library.info(asset.id)
            if member.pile:
                spot = spot_square_on(self.layout, info, holder.id, target_id, self.rng)
            else:
                spot = spot_on_small(self.layout, info, holder.id, relation, self.rng)
            if spot is not None and self._allowed(asset, spot):
                return self._put(member, asset, spot, Intent(relation, holder.id))
            self.models.pop(asset.category, None)
        return None

    def _put(
        self, member: Member, asset: Asset, spot: Vec3Yaw, intent: Intent
    ) -> ObjectInstance | None:
        thing: ObjectInstance | None = self.layout.new_thing(asset)
        if thing is not None and member.state is not None:
            thing = in_state(thing, self.layout.library.info(asset.id), member.state, self.rng)
        if thing is None:
            return None
        item = at_spot(thing, spot, self.room.id)
        self.layout.put(item, intent)
        return item

    def _model(self, member: Member, target_id: int) -> Asset | None:
        """A model for a member: the one the group has already, where it comes in several; else
        none of what the target holds."""
        name = member.thing[int(self.rng.integers(len(member.thing)))]
        category, known = self.context.catalog.category(name), self.models.get(name)
        mine = sum(self.layout.items[key].category == category.name for key in self.ids)
        if self.stock.full(category, self.room.id, mine):
            return None
        if known is not None:
            return known
        # What comes in a state that says where it lives (a cut apple) is not left about.
        kept = {abode.state for abode in category.lives} - {None}
        there = {self.layout.items[key].asset for key in self.ids}
        among = [
            model
            for model in self.context.models(category.name)
            if kept.isdisjoint(rest_states(model))
            and (member.state is None or member.state in model.state_names)
            and (category.alike or not (model.id in there or self._seen_enough(model, target_id)))
        ]
        if not among:
            return None
        asset = among[int(self.rng.integers(len(among)))]
        if category.alike:
            self.models[name] = asset
        return asset

    def _seen_enough(self, model: Asset, target_id: int) -> bool:
        """Whether a visitor would notice that there is one more of a model."""
        return self.stock.stands_on(target_id, model.id) or self.stock.too_common(model.id)

    # --- spots -----------------------------------------------------------------------------------

    def _spot_on(
        self,
        piece: ObjectInstance,
        surface: PlacingSurface,
        frame: Frame,
        member: Member,
        asset: Asset,
    ) -> Vec3Yaw | None:
        """A spot for a member on the surface of a piece, or none."""
        size, headroom = asset.extents_m, surface.support.headroom_m
        if headroom is not None and size[2] > headroom - HEADROOM_LEFT_M:
            return None
        turn = math.pi + math.radians(member.turn_deg)
        for _ in range(SPOTS_TRIED):
            point = self._point(surface, frame, member, asset, turn)
            shift, askew = self._off()
            if point is None:
                return None
            x, y = Frame(point, frame.heading).point(shift)
            yaw = frame.heading + turn + askew
            if not surface.carries(size, (x, y), yaw):
                continue
            spot = (x, y, surface.z_m), yaw
            block = space_at(size, *spot, GAP_M, DROP_M)
            if self.layout.fits([block], ignore=piece.id) and self._allowed(asset, spot):
                return spot
        return None

    def _point(
        self, surface: PlacingSurface, frame: Frame, member: Member, asset: Asset, turn: float
    ) -> Vec2 | None:
        """Where the middle of a member is to be; None where what it stands beside is not there."""
        if not member.beside:
            return surface.random_point(self.rng) if member.at is None else frame.point(member.at)
        other = self.placed.get(member.beside)
        if other is None:
            return None
        theirs = yaw_of(other.pose.quat_xyzw) - frame.heading
        half = half_reach(self.layout.info(other.id).extents_m, theirs)
        own = half_reach(asset.extents_m, turn)
        point = beside(other.pose.position_m[:2], half, own, member.side, member.gap_m, frame)
        return Frame(point, frame.heading).point(member.at or (0.0, 0.0))

    def _spot_aside(
        self, ground: Ground, close: Sequence[Vec2], member: Member, asset: Asset
    ) -> Vec3Yaw | None:
        """A spot at a wall by what is there of the group, the first by these points (if any)."""
        there = [self.layout.items[k].pose.position_m[:2] for k in self.ids[:1]]
        points, reach = (there, TOGETHER_M) if there else (close, NEAR_M)
        spot = self.layout.spot_on_floor(asset, ground.near(points, reach), self.rng)
        return spot if spot is not None and self._allowed(asset, spot) else None

    def _allowed(self, asset: Asset, spot: Vec3Yaw) -> bool:
        """Whether a thing there is out of reach and in view, if it must be, and faces no wall."""
        context = self.context
        if not context.reach.beyond(asset, spot, self.room.id):
            return False
        if asset.category in self.layout.fronted and context.faces_wall(self.room.id, spot):
            return False
        if self.in_view and asset.category in context.made_categories:
            return context.shows_at(Bulk(asset.extents_m), spot)
        return True

    def _off(self) -> tuple[Vec2, float]:
        """How far off line something is left here: a shift and a turn."""
        messy = 1.0 - self.context.tidiness
        across, turned = (
            tidy + more * messy for tidy, more in zip(TIDY_OFF, MESSY_OFF, strict=True)
        )
        x, y, turn = self.rng.normal(0.0, 0.5, 3).tolist()
        return (x * across, y * across), turn * turned
