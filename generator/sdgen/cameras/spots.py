"""Where a furnished home's small things would lie, and how often, before any of them exists.

Follows from the furniture and the catalogue alone: from the recipes of every hazard, drawn or not,
and from where its categories live.
"""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
import shapely
from shapely.geometry import Polygon
from shapely.geometry.base import BaseGeometry

from sdgen.actions import in_state
from sdgen.cameras.outdoors import outer_opening
from sdgen.catalog.records import Before, Near, PlaceRecipe, Recipe, SetRecipe
from sdgen.facts import Body
from sdgen.geometry import Array
from sdgen.home.context import HomeContext
from sdgen.home.layout import Layout, room_to_change
from sdgen.home.things import NO_THINGS, Things
from sdgen.home.vicinity import strip_before
from sdgen.library.states import state_parts
from sdgen.scene import ObjectInstance, Opening, Room
from sdgen.seeding import Rng
from sdgen.vocabulary import FLAT_M, OVERHEAD_M

Bools = npt.NDArray[np.bool_]
Ints = npt.NDArray[np.int64]

#: A small thing's middle is about this high above what it stands on.
ABOVE_M = 0.04
#: Points on each surface, and on each square metre of floor: the next one is a thing's width away.
_ON_SURFACE, _ON_FLOOR_M2 = 4, 3.0
#: Draws of a state, such as how wide a door stands open, until there is room for it; ways that a
#: piece is looked at in a state: a fridge has two doors, and one may open towards no view.
_DRAWS, _WAYS = 4, 2
#: What a hazard's near misses and all everyday things count, against one hazard's anomalies: a
#: choice. An anomaly must be seen; nothing breaks when an everyday thing is not.
_LOOKALIKES, _EVERYDAY = 0.5, 3.0
#: What the high places of each hazard count, where its near misses lie that must be out of reach:
#: where nobody looks at them, of what children must not reach only the hazards are seen, and its
#: name tells them. All on one piece or two, the same for as many hazards as it does: spread over
#: the six to eight of a home none would get a view of its own.
_HIGH, _HIGH_PIECES = 3.0, 2
#: Eyes are lifted somewhat above this; of what lies flat higher up views show little.
_SEEN_FROM_ABOVE_M = 1.7
#: Half the width of a thing that is to be near another, about.
_HALF_M = 0.15
#: What is set to a state counts so many times what is placed: it can be seen in one place only.
_STATES = 5.0
#: What all things that a home draws itself count, labelled ones and others alike.
_DRAWN = 10.0


@dataclass(frozen=True)
class Wanted:
    """What makes a spot likely for one placement: where it may lie."""

    relation: str
    target: str
    rooms: tuple[str, ...] = ()
    low_m: float | None = None
    high_m: float | None = None
    zone: tuple[str, ...] = ()
    avoid: tuple[str, ...] = ()
    #: Furniture that it is to be so near to, and what it is to be so far before.
    near: Near | None = None
    before: Before | None = None


@dataclass(frozen=True)
class SetTo:
    """An object of the home as it is once it is set to a state, the parts that show that, and how
    many pixels of the outdoors, at the reference size, through the ``opening`` that it fills."""

    item: ObjectInstance
    state: str
    parts: tuple[str, ...]
    outdoors: int = 0
    opening: Opening | None = None


@dataclass(frozen=True)
class Spots:
    """Points (N, 3) where small things would lie, on which furniture or on the floor of which room
    (ids, (N,)), what would be set to a state, and how likely each point is and then each of these,
    (N + states,), 1 in all."""

    points_m: Array
    target: Ints
    states: tuple[SetTo, ...]
    weight: Array


@dataclass(frozen=True)
class _Surface:
    """Points on one surface or floor: whose it is (None: a floor), how things lie there."""

    owner: ObjectInstance | None
    room: Room
    relation: str
    points_m: Array

    @property
    def category(self) -> str:
        """Category of the furniture; ``floor`` of a room."""
        return "floor" if self.owner is None else self.owner.category

    @property
    def target(self) -> int:
        """Id of the furniture, or of the room."""
        return self.room.id if self.owner is None else self.owner.id


def spots_of(context: HomeContext, layout: Layout, rng: Rng, things: Things = NO_THINGS) -> Spots:
    """Spots on every support and floor of a furnished home, where the ``things`` are that it draws
    itself, and on what recipes set to a state."""
    surfaces = _Surfaces(
        [*_supports(context, layout, rng), *_floors(context, layout, rng)], context, layout
    )
    expected = defaultdict(float, _everyday(context, layout))
    were_set: defaultdict[tuple[int, str], float] = defaultdict(float)
    outdoors: defaultdict[tuple[int, str], int] = defaultdict(int)
    high: list[list[Recipe]] = []
    for hazard in context.catalog.hazards:
        high.append([one for one in hazard.lookalikes if _is_high(one)])
        lookalikes = [one for one in hazard.lookalikes if not _is_high(one)]
        for recipes, worth in ((hazard.anomalies, 1.0), (lookalikes, _LOOKALIKES)):
            could_place, could_set = _possible(recipes, context, layout)
            total = sum(could_place.values()) + sum(could_set.values())
            for wanted, weight in could_place.items():
                expected[wanted] += worth * weight / total
            for key, weight in could_set.items():
                were_set[key] += _STATES * worth * weight / total
                if recipes is hazard.anomalies:
                    outdoors[key] = max(outdoors[key], hazard.evidence_outdoors)
    placed = np.zeros(len(surfaces.points_m))
    for wanted, weight in expected.items():
        placed += weight * surfaces.share(wanted)
    pieces = np.unique(surfaces.target).tolist()
    rank = dict(zip(pieces, rng.permutation(len(pieces)).tolist(), strict=True))
    for recipes in high:
        placed += _HIGH * surfaces.few_of(recipes, _possible(recipes, context, layout)[0], rank)
    ways = {key: list(_ways(context, layout, *key, outdoors[key], rng)) for key in sorted(were_set)}
    likely = placed > 0
    weights = np.array(
        [
            *placed[likely],
            *(_DRAWN / len(things.items) for _ in things.items),
            *(were_set[key] / len(found) for key, found in ways.items() for _ in found),
        ]
    )
    return Spots(
        np.concatenate([surfaces.points_m[likely], *_middles(things)]),
        np.append(surfaces.target[likely], [_bearer(item, things) for item in things.items]).astype(
            np.int64
        ),
        tuple(one for found in ways.values() for one in found),
        weights / weights.sum(),
    )


def _middles(things: Things) -> Iterator[Array]:
    """A point near the middle of each thing, (1, 3)."""
    for item in things.items:
        x, y, z = item.pose.position_m
        yield np.array([[x, y, z + ABOVE_M]])


def _bearer(item: ObjectInstance, things: Things) -> int:
    """What furniture a thing is on or in; the room, of what is on its floor or on nothing."""
    intent = things.intents.get(item.id)
    return item.room_id if intent is None else intent.target_id


class _Surfaces:
    """All surfaces with their points in one row."""

    def __init__(self, surfaces: Sequence[_Surface], context: HomeContext, layout: Layout) -> None:
        self._context = context
        self._layout = layout
        self._boxes_of: dict[tuple[str, ...], Array] = {}
        self.points_m = np.concatenate(
            [np.zeros((0, 3)), *(surface.points_m for surface in surfaces)]
        )
        self.target = np.repeat(
            np.array([surface.target for surface in surfaces], dtype=np.int64),
            [len(surface.points_m) for surface in surfaces],
        )
        #: The surfaces of each target and relation, and where their points are in the row.
        self._of: defaultdict[tuple[str, str], list[tuple[_Surface, slice]]] = defaultdict(list)
        end = 0
        for surface in surfaces:
            start, end = end, end + len(surface.points_m)
            self._of[surface.category, surface.relation].append((surface, slice(start, end)))

    def share(self, wanted: Wanted) -> Array:
        """How likely each point is for one such thing, (N,): owners (or rooms) evenly; 1 in all,
        or 0 where there is none."""
        return self._evenly(self._fitting(wanted))

    def few_of(
        self, recipes: Sequence[Recipe], wanted: Iterable[Wanted], rank: Mapping[int, int]
    ) -> Array:
        """How likely each point is where any of these may lie out of reach, (N,), as for
        :meth:`share`: on the first few pieces by ``rank`` (by id), lower ones before higher."""
        fitting = np.zeros(len(self.points_m), dtype=np.bool_)
        for one in wanted:
            fitting |= self._fitting(one)
        fitting &= self._beyond(recipes, fitting)
        above = self.points_m[:, 2] > _SEEN_FROM_ABOVE_M
        order = {
            owner: (bool(above[fitting & (self.target == owner)].all()), rank[owner])
            for owner in set(self.target[fitting].tolist())
        }
        owners = sorted(order, key=order.__getitem__)[:_HIGH_PIECES]
        return self._evenly(fitting & np.isin(self.target, owners))

    def _beyond(self, recipes: Sequence[Recipe], among: Bools) -> Bools:
        """Which of these points no child reaches, for the first thing that the recipes place."""
        out = np.zeros(len(self.points_m), dtype=np.bool_)
        models = [m for r in recipes for c in r.categories for m in self._context.models(c)[:1]]
        if not models:
            return out
        for rows_of in self._of.values():
            for surface, rows in rows_of:
                for k in (rows.start + np.flatnonzero(among[rows])).tolist():
                    x, y, z = self.points_m[k].tolist()
                    spot = ((x, y, z - ABOVE_M), 0.0)
                    out[k] = self._context.reach.beyond(models[0], spot, surface.room.id)
        return out

    def _fitting(self, wanted: Wanted) -> Bools:
        """The points where such a thing may lie, (N,)."""
        fitting = np.zeros(len(self.points_m), dtype=np.bool_)
        for surface, rows in self._of.get((wanted.target, wanted.relation), ()):
            if not wanted.rooms or surface.room.type in wanted.rooms:
                fitting[rows] = self._fits(surface, wanted)
        return fitting

    def _evenly(self, fitting: Bools) -> Array:
        out = np.zeros(len(self.points_m))
        if fitting.any():
            _, of, count = np.unique(self.target[fitting], return_inverse=True, return_counts=True)
            out[fitting] = 1.0 / count[of] / len(count)
        return out

    def _fits(self, surface: _Surface, wanted: Wanted) -> Bools:
        points = surface.points_m
        height = points[:, 2] - ABOVE_M
        fits = np.ones(len(points), dtype=np.bool_)
        if wanted.low_m is not None:
            fits &= height >= wanted.low_m
        if wanted.high_m is not None:
            fits &= height <= wanted.high_m
        if wanted.zone:
            fits &= self._within(wanted.zone, surface.room, points)
        if wanted.avoid:
            fits &= ~self._within(wanted.avoid, surface.room, points)
        if wanted.near is not None:
            fits &= self._near(wanted.near, points)
        if wanted.before is not None:
            fits &= self._before(wanted.before, points)
        return fits

    def _near(self, near: Near, points: Array) -> Bools:
        boxes = self._boxes(near.to)
        if not len(boxes):
            return np.zeros(len(points), dtype=np.bool_)
        outside = np.maximum(boxes[:, 0] - points[:, None], points[:, None] - boxes[:, 1])
        apart = np.linalg.norm(np.maximum(outside, 0.0)[..., near.axes], axis=-1)
        return np.asarray(apart.min(axis=1) <= near.max_m + _HALF_M)

    def _boxes(self, names: tuple[str, ...]) -> Array:
        """Lowest and highest corners of what is called so, (N, 2, 3)."""
        if names not in self._boxes_of:
            infos = self._layout.library
            bodies = [Body(item, infos.info(item.asset)) for item in self._called(names)]
            corners = [(body.low, body.high) for body in bodies]
            self._boxes_of[names] = np.reshape(corners, (-1, 2, 3)).astype(np.float64)
        return self._boxes_of[names]

    def _before(self, before: Before, points: Array) -> Bools:
        items = self._called(before.of)
        strips = [strip_before(item, before.max_m, self._layout) for item in items]
        shape = shapely.union_all(strips)
        return np.asarray(shapely.contains_xy(shape, points[:, 0], points[:, 1]))

    def _called(self, names: tuple[str, ...]) -> list[ObjectInstance]:
        return [item for item in self._layout.items.values() if item.category in names]

    def _within(self, kinds: tuple[str, ...], room: Room, points: Array) -> Bools:
        shape = self._context.zone_shape(kinds, room.id)
        return np.asarray(shapely.contains_xy(shape, points[:, 0], points[:, 1]))


def _possible(
    recipes: Sequence[Recipe], context: HomeContext, layout: Layout
) -> tuple[dict[Wanted, float], dict[tuple[int, str], float]]:
    """What these recipes could place where, and what they could set to which state, with weights:
    as :func:`sdgen.hazards.candidates.weighted_order` draws them."""
    present: dict[str, list[ObjectInstance]] = {}
    for item in layout.items.values():
        present.setdefault(item.category, []).append(item)
    placed: defaultdict[Wanted, float] = defaultdict(float)
    were_set: defaultdict[tuple[int, str], float] = defaultdict(float)
    for recipe in recipes:
        if isinstance(recipe, SetRecipe):
            for category in recipe.categories:
                found = [
                    item
                    for item in present.get(category, ())
                    if not recipe.rooms or context.room_type(item.room_id) in recipe.rooms
                ]
                for item in found:
                    were_set[item.id, recipe.state] += recipe.weight / len(found)
        else:
            targets = [t for t in recipe.targets if t == "floor" or t in present]
            wanted = [_wanted(recipe, target, context) for target in targets]
            for category in recipe.categories if targets else ():
                if context.models(category):
                    for one in wanted:
                        placed[one] += recipe.weight / len(targets)
    return placed, were_set


def _is_high(recipe: Recipe) -> bool:
    """Whether a recipe puts something on high places alone."""
    return isinstance(recipe, PlaceRecipe) and recipe.min_height_m is not None


def _wanted(recipe: PlaceRecipe, target: str, context: HomeContext) -> Wanted:
    """What a recipe asks for of a target."""
    return Wanted(
        recipe.relation,
        target,
        recipe.rooms,
        recipe.min_height_m,
        recipe.max_height_m,
        recipe.zone,
        recipe.avoid_zones,
        _near_furniture(recipe, context),
        recipe.before,
    )


def _near_furniture(recipe: PlaceRecipe, context: HomeContext) -> Near | None:
    """The furniture that a recipe's thing is to be near; None where it is small things that it
    brings along: these may lie wherever it does."""
    near = recipe.near
    fixed = near is not None and all(
        context.catalog.category(name).kind in ("furniture", "opening") for name in near.to
    )
    return near if fixed else None


def _everyday(context: HomeContext, layout: Layout) -> dict[Wanted, float]:
    """Where everyday things of the categories that recipes name would lie, by the rooms' priors."""
    made = context.made_categories
    types = {room_type.name: room_type for room_type in context.catalog.room_types}
    wanted: defaultdict[Wanted, float] = defaultdict(float)
    for room in context.home.rooms:
        room_type = types.get(room.type)
        if room_type is None:
            continue
        among = Counter(item.category for item in layout.items.values() if item.room_id == room.id)
        counts = {
            prior.receptacle: among[prior.receptacle] * (prior.count_min + prior.count_max) / 2
            for prior in room_type.clutter
        }
        counts["floor"] = (room_type.floor_clutter_min + room_type.floor_clutter_max) / 2
        lives: defaultdict[tuple[str, str], float] = defaultdict(float)
        total: defaultdict[str, float] = defaultdict(float)
        for category in context.catalog.categories:
            for abode in category.lives if category.kind == "small" else ():
                for target in abode.targets:
                    if counts.get(target) and (not abode.rooms or room.type in abode.rooms):
                        total[target] += abode.weight
                        if category.name in made:
                            lives[abode.relation, target] += abode.weight
        for (relation, target), weight in lives.items():
            wanted[Wanted(relation, target, (room.type,))] += (
                counts[target] * weight / total[target]
            )
    whole = sum(wanted.values())
    return {one: _EVERYDAY * count / whole for one, count in wanted.items()}


def _supports(context: HomeContext, layout: Layout, rng: Rng) -> Iterator[_Surface]:
    rooms = {room.id: room for room in context.home.rooms}
    for item in layout.items.values():
        for surface in layout.surfaces_of(item.id):
            found = [surface.random_point(rng) for _ in range(_ON_SURFACE)]
            points = np.array([(*p, surface.z_m + ABOVE_M) for p in found if p is not None])
            relation = "ON" if surface.support.container is None else "INSIDE"
            if len(points):
                yield _Surface(item, rooms[item.room_id], relation, points)


def _floors(context: HomeContext, layout: Layout, rng: Rng) -> Iterator[_Surface]:
    standing = list(_standing(layout))
    for room in context.home.rooms:
        floor = context.floor(room.id)
        x0, y0, x1, y1 = Polygon(room.polygon_m).bounds
        drawn = round((x1 - x0) * (y1 - y0) * _ON_FLOOR_M2)
        points = np.column_stack([rng.uniform((x0, y0), (x1, y1), (drawn, 2)), np.zeros(drawn)])
        points[:, 2] = ABOVE_M
        free = shapely.contains_xy(floor, points[:, 0], points[:, 1])
        points = points[free]
        if standing and len(points):
            on_them = shapely.STRtree(shapely.points(points[:, :2])).query(standing, "contains")
            points = np.delete(points, on_them[1], axis=0)
        if len(points):
            yield _Surface(None, room, "ON", points)


def _standing(layout: Layout) -> Iterator[BaseGeometry]:
    """What takes floor: not what lies flat on it, nor what hangs over it."""
    for object_id in layout.items:
        for block in layout.space_of(object_id):
            if block.box[2] < OVERHEAD_M and block.box[5] > FLAT_M:
                yield block.shape


def _ways(
    context: HomeContext, layout: Layout, object_id: int, state: str, outdoors: int, rng: Rng
) -> Iterator[SetTo]:
    """The object in a state, with room for it and past it into every room, by this leaf or that;
    nothing when a few draws find none."""
    item, info = layout.items[object_id], layout.info(object_id)
    opening = outer_opening(context.home, object_id)
    found: set[tuple[str, ...]] = set()
    for _ in range(_DRAWS):
        changed = item if state in item.states else in_state(item, info, state, rng)
        if changed is None or len(found) == _WAYS:
            return
        parts = state_parts(info, state, changed.variant, changed.joints)
        if parts in found or not room_to_change(layout, context.home, item, changed):
            continue
        if changed.joints == item.joints or not context.cuts_off(changed, info):
            found.add(parts)
            yield SetTo(changed, state, parts, outdoors, opening)
