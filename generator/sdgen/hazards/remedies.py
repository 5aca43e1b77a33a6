"""How an anomaly can be undone by its remedy, way by way: only proposed here, physics and the
predicates say which of them will do.

The hazard's rules come in their order, within a rule its categories in theirs, of these the
nearest object first. What is put on something is first put where such things are put; into which
hollow a thing may go is what everyday things go by, and a leaf that stood open is shut behind it.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterable, Iterator
from dataclasses import dataclass
from functools import partial
from itertools import chain, islice

from sdgen.actions import at_rest, settled_states
from sdgen.catalog.records import Catalog, PlaceRecipe, RemedyRule
from sdgen.facts import Facts
from sdgen.geometry import (
    Vec2,
    apply,
    lowest_highest,
    quat_from_axis_angle,
    quat_from_matrix,
    quat_from_yaw,
    rotation_matrix,
    round_position,
    round_quat,
)
from sdgen.hazards.twin import GONE, PUT, SET_BACK, set_back, with_changes
from sdgen.home.context import KEEP_CLEAR, HomeContext
from sdgen.home.layout import DROP_M, Bulk, Layout, Vec3Yaw, at_spot
from sdgen.library.records import AssetInfo
from sdgen.library.states import object_from_part
from sdgen.scene import ObjectInstance, Pose, Room
from sdgen.seeding import Rng

#: Bounds of the search: objects of a category, rooms, and spots on or in each. Nearly all things
#: are taken by the first target that has room, and stay at the first spot.
TARGETS_TRIED = 6
ROOMS_TRIED = 6
SPOTS_TRIED = 2
#: Looks for a spot on or in one object, or on a floor: a fridge may be all but full.
LOOKS = 8


@dataclass(frozen=True)
class Step:
    """One way to undo an anomaly: its object after it (None: gone), what it was put on or into,
    and that thing with the leaf shut which stood open before the hollow."""

    action: str
    item: ObjectInstance | None
    target_id: int | None = None
    shut: ObjectInstance | None = None


def stocked(layout: Layout, objects: Iterable[ObjectInstance]) -> Layout:
    """A copy of a home's layout that holds these objects as they are, and no others."""
    out = layout.copy(iter(()))
    wanted = {item.id: item for item in objects}
    for key in [key for key in out.items if key not in wanted]:
        out.drop(key)
    for key, item in wanted.items():
        if out.items.get(key) is not item:
            out.put(item)
    return out


@dataclass(frozen=True)
class Remedies:
    """The ways to undo one anomaly in a scene as it is (``facts``).

    ``layout`` holds the scene's objects without the anomaly's. ``kept`` are the objects of
    anomalies that stay: no leaf of theirs is shut.
    """

    facts: Facts
    layout: Layout
    context: HomeContext
    kept: Collection[int]
    rng: Rng

    def steps(self, rules: Iterable[RemedyRule], item: ObjectInstance) -> Iterator[Step]:
        """All ways by these rules, best first: last of all what should go into a bin and fits into
        none is gone."""
        rules = tuple(rules)
        ways = [self._by_rule(rule, item, sensible=True) for rule in rules]
        ways += [self._by_rule(r, item, sensible=False) for r in rules if r.action == "put_on"]
        gone = [Step(rule.action, None) for rule in rules if rule.action == "throw_away"]
        return chain(*ways, gone[:1])

    def _by_rule(self, rule: RemedyRule, item: ObjectInstance, sensible: bool) -> Iterator[Step]:
        info = self.layout.library.info(item.asset)
        if rule.action in SET_BACK:
            yield from (Step(rule.action, after) for after in set_back(item, info, rule.action))
        elif rule.action in GONE:
            yield Step(rule.action, None)
        elif item.fixed:
            return  # what is built in, and what was spilled, is not carried about
        elif rule.action == "move_away":
            yield from self._moved_away(item, info)
        else:
            for category in rule.targets:
                usual = rule.action != "put_on" or goes_on(
                    self.context.catalog, item.category, category
                )
                if usual == sensible:
                    for target in self._nearest(category, item)[:TARGETS_TRIED]:
                        yield from self._put(rule.action, item, target)

    def _nearest(self, category: str, item: ObjectInstance) -> list[ObjectInstance]:
        """The furniture of a category, the nearest to a thing first."""
        here = self.facts.bodies[item.id].center.tolist()
        bodies = (self.facts.bodies[key] for key in self.facts.ids_of([category]))
        found = [body for body in bodies if body.item.fixed and body.item.id != item.id]
        found.sort(key=lambda body: (math.dist(here, body.center.tolist()), body.item.id))
        return [body.item for body in found]

    def _put(self, action: str, item: ObjectInstance, target: ObjectInstance) -> Iterator[Step]:
        inside = PUT[action] == "INSIDE"
        for after, hollows in self._leaves(target) if inside else [(target, _any)]:
            shut = None if after is target else after
            layout = self.layout if shut is None else self._with_leaf_shut(shut)
            takes = partial(self._takes, item.category, target.category, hollows)
            for put in self.put_at(action, item, after, takes, layout):
                yield Step(action, put, target.id, shut)

    def put_at(
        self,
        action: str,
        item: ObjectInstance,
        target: ObjectInstance,
        takes: Callable[[str], bool],
        layout: Layout,
        tried: int = SPOTS_TRIED,
        looks: int = LOOKS,
    ) -> Iterator[ObjectInstance]:
        """A thing at spots on or in a target as it is in ``layout`` (which the thing is not in), in
        hollows that ``takes`` says, by name; what is thrown away also on end."""
        info, room_id = layout.library.info(item.asset), target.room_id
        bulk = layout.bulk_of(item)
        drawn = (
            layout.spot_on_object(info, target.id, PUT[action], self.rng, takes, bulk)
            for _ in range(looks)
        )
        found = (s for s in drawn if s is not None and self._looks_right(item, room_id, s))
        for spot in islice(found, tried):
            yield at_spot(item, spot, room_id)
        if action == "throw_away" and "BROKEN" not in item.states:
            yield from self._upended(item, bulk, target, takes)

    def _upended(
        self, item: ObjectInstance, bulk: Bulk, target: ObjectInstance, takes: Callable[[str], bool]
    ) -> Iterator[ObjectInstance]:
        """A thing on end in each hollow that takes it so: bins are narrow, and what is thrown away
        need not lie flat."""
        info = self.layout.library.info(target.asset)
        deep, wide, high = bulk.size_m
        across = (high, wide) if deep >= wide else (deep, high)
        for hollow in info.containers:
            x, y, z = hollow.size_m
            if not takes(hollow.name) or max(deep, wide) > z or math.hypot(*across) > min(x, y):
                continue
            on_end = quat_from_axis_angle((0, 1, 0) if deep >= wide else (1, 0, 0), math.pi / 2)
            yaw = quat_from_yaw(float(self.rng.uniform(0.0, 2 * math.pi)))
            turn = rotation_matrix(yaw) @ rotation_matrix(on_end)
            low, top = lowest_highest(bulk.corners(((0.0, 0.0, 0.0), 0.0)) @ turn.T)
            moved = target.pose.matrix() @ object_from_part(info, hollow.part, target.joints)
            center = hollow.center_m
            base = apply(moved, [(center[0], center[1], center[2] - z / 2 + DROP_M)])[0]
            at = base - [*(low + top)[:2] / 2, low[2]]
            pose = Pose(position_m=round_position(at), quat_xyzw=round_quat(quat_from_matrix(turn)))
            yield item.model_copy(update={"pose": pose, "room_id": target.room_id})

    def _takes(self, category: str, target: str, hollows: Callable[[str], bool], name: str) -> bool:
        return hollows(name) and self.context.may_hold(category, target, name)

    def _leaves(
        self, target: ObjectInstance
    ) -> Iterator[tuple[ObjectInstance, Callable[[str], bool]]]:
        """The target as it is, for the hollows that are shut or have no leaf, and then for those
        before which a leaf stands open, shut (as it is, where it is to stay so)."""
        info = self.layout.library.info(target.asset)
        rest = at_rest(target, info).joints
        leaf = {hollow.name: hollow.closed_by for hollow in info.containers}
        opened = [
            joint.name
            for joint in info.joints
            if joint.name in leaf.values() and target.joints[joint.name] != rest[joint.name]
        ]
        yield target, lambda name: leaf.get(name) not in opened
        for joint in opened:
            after = target
            if target.id not in self.kept:
                joints = {**target.joints, joint: rest[joint]}
                after = settled_states(target.model_copy(update={"joints": joints}), info)
            yield after, lambda name, joint=joint: leaf.get(name) == joint  # type: ignore[misc]

    def _with_leaf_shut(self, shut: ObjectInstance) -> Layout:
        scene, infos = self.facts.scene, self.layout.library.infos
        layout = self.layout.copy()
        for item in with_changes(scene, {shut.id: shut}, infos, self.facts):
            if item.id in layout.items and layout.items[item.id] is not item:
                layout.put(item)
        return layout

    def _moved_away(self, item: ObjectInstance, info: AssetInfo) -> Iterator[Step]:
        """Aside on a floor, at a wall: in its room, else in the nearest."""
        bulk = self.layout.bulk_of(item)
        for room in self._rooms(item)[:ROOMS_TRIED]:
            ground = self.context.ground(room.id, KEEP_CLEAR)
            looks = (self.layout.spot_on_floor(info, ground, self.rng, bulk) for _ in range(LOOKS))
            for spot in islice(filter(None, looks), SPOTS_TRIED):
                yield Step(
                    "move_away", at_spot(item, spot, room.id), self.context.floor_id(room.id)
                )

    def _rooms(self, item: ObjectInstance) -> list[Room]:
        x, y, _ = self.facts.bodies[item.id].center.tolist()

        def far(room: Room) -> tuple[bool, float, int]:
            return room.id != item.room_id, _distance((x, y), room), room.id

        return sorted(self.context.home.rooms, key=far)

    def _looks_right(self, item: ObjectInstance, room_id: int, spot: Vec3Yaw) -> bool:
        """What is looked at looks at no wall."""
        return item.category not in self.layout.fronted or not self.context.faces_wall(
            room_id, spot
        )


def goes_on(catalog: Catalog, category: str, target: str) -> bool:
    """Whether such a thing lives on such a target, or lies there as a near miss."""
    lives = catalog.category(category).lives
    if any(abode.relation == "ON" and target in abode.targets for abode in lives):
        return True
    return any(
        isinstance(recipe, PlaceRecipe)
        and recipe.relation == "ON"
        and category in recipe.categories
        and target in recipe.targets
        for hazard in catalog.hazards
        for recipe in hazard.lookalikes
    )


def _distance(point: Vec2, room: Room) -> float:
    xs, ys = zip(*room.polygon_m, strict=True)
    return math.dist(point, (sum(xs) / len(xs), sum(ys) / len(ys)))


def _any(_name: str) -> bool:
    return True
