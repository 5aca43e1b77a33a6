"""Generated homes: furniture by rules stands in its room, backs to walls, clear of doors."""

from __future__ import annotations

import math

import numpy as np
import pytest
from sdgen.actions import at_rest
from sdgen.catalog.load import load_catalog
from sdgen.catalog.records import FurnitureRule, HomeSpec
from sdgen.facts import bodies_of
from sdgen.freespace import free_shape, opening_rectangle, rounded_rings
from sdgen.geometry import yaw_of
from sdgen.hazards.splits import SplitModels
from sdgen.home.anchors import sides_of
from sdgen.home.arrange import _candidates, groups_of, rules_of
from sdgen.home.layout import corners_of
from sdgen.home.room_try import OFF_FRAME_M, TALL_M, empty_room, free_parts
from sdgen.home.run_shapes import BEHIND_M, NEARER_M
from sdgen.options import BuildOptions
from sdgen.physics.checks import penetrations
from sdgen.physics.world import standing
from sdgen.pipeline.furnished import FurnishedHome, furnished_home, pick_home
from sdgen.seeding import lane
from sdgen.vocabulary import OPENINGS
from sdgen.zones import derive_zones, floor_obstacles
from shapely.geometry import LineString, Polygon

from tests.shipped import shipped_library

CATALOG = load_catalog()
LIBRARY = shipped_library()
OPTIONS = BuildOptions(n=20, seed=9, homes="procedural")


def stage(index: int) -> FurnishedHome:
    choice = pick_home(CATALOG, OPTIONS, index)
    ids = iter((lane(9, index, "ids").permutation(65535) + 1).tolist())
    models = SplitModels(LIBRARY, "test")
    # As a build does: a home that did not come out is planned and furnished anew.
    for k in range(6):
        base = choice.spec(CATALOG, lane(9, index, f"plan:{k}"))
        assert isinstance(base, HomeSpec), base
        made = furnished_home(base, CATALOG, LIBRARY, models, ids, lane(9, index, f"furnish{k}"))
        if isinstance(made, FurnishedHome):
            return made
    raise AssertionError(f"home {index} did not come out")


@pytest.fixture(scope="module")
def stages() -> list[FurnishedHome]:
    return [stage(index) for index in range(6)]


def pieces(made: FurnishedHome):
    for item in made.layout.items.values():
        if item.category not in OPENINGS:
            yield item, made.layout.info(item.id)


def test_pieces_stand_in_their_rooms(stages):
    for made in stages:
        rooms = {room.id: Polygon(room.polygon_m) for room in made.context.home.rooms}
        for item, info in pieces(made):
            x, y, _ = item.pose.position_m
            shape = Polygon(corners_of(info, x, y, yaw_of(item.pose.quat_xyzw)))
            assert rooms[item.room_id].buffer(0.02).contains(shape), item.category


def test_no_furniture_cuts_into_anything(stages):
    """The check itself is tested in physics: here, that what is placed needs none."""
    for made in stages:
        with standing(LIBRARY, made.scene(0, made.layout.items)) as world:
            assert penetrations(world) == []


def test_what_opens_opens_as_far_as_people_need(stages):
    """By the simulator's own pieces, half way and all the way; seats are drawn back from desks."""
    beyond_m = 0.01  # pieces of collision are a little larger than what is drawn
    for made in stages[:2]:
        items = dict(made.layout.items)
        with standing(LIBRARY, made.scene(0, items)) as world:
            for item, info in pieces(made):
                for joint in info.joints:
                    far = joint.upper if joint.type == "prismatic" else min(joint.upper, 1.57)
                    for value in (far / 2, far):
                        joints = {**item.joints, joint.name: value}
                        opened = {**items, item.id: item.model_copy(update={"joints": joints})}
                        world.become(made.scene(0, opened), ())
                        met = {
                            items[k].category if k in items else "shell"
                            for violation in penetrations(world, [item.id], beyond_m)
                            for k in violation.objects
                            if k != item.id
                        }
                        assert met <= {"chair", "office_chair"}, (item.category, joint.name, met)


def test_doorways_stay_clear(stages):
    for made in stages:
        for item, info in pieces(made):
            if info.extents_m[2] <= 0.03 or item.pose.position_m[2] > 1.2:
                continue
            x, y, _ = item.pose.position_m
            shape = Polygon(corners_of(info, x, y, yaw_of(item.pose.quat_xyzw)))
            for opening in made.context.home.openings:
                if opening.kind != "window":
                    assert not shape.intersects(opening_rectangle(opening, 0.6)), item.category


def test_nothing_tall_stands_at_the_frame_of_a_door(stages):
    for made in stages:
        for item, info in pieces(made):
            if info.extents_m[2] <= TALL_M or item.pose.position_m[2] > 0.1:
                continue
            x, y, _ = item.pose.position_m
            shape = Polygon(corners_of(info, x, y, yaw_of(item.pose.quat_xyzw)))
            for opening in made.context.home.openings:
                if opening.kind != "window":
                    wide = {"width_m": opening.width_m + 2 * OFF_FRAME_M - 0.01}
                    frame = opening_rectangle(opening.model_copy(update=wide), 0.5)
                    assert not shape.intersects(frame), item.category


def test_no_table_stands_without_chairs_and_no_lamp_or_rug_alone(stages):
    for room, found in in_rooms(stages):
        tables = [*found.get("dining_table", ()), *found.get("kitchen_table", ())]
        # Islands have bar stools, desks their own chairs.
        assert len(found.get("chair", ())) >= 2 * len(tables)
        if "floor_lamp" in found:
            assert not {"sofa", "armchair", "desk"}.isdisjoint(found)
        by_itself = any(
            r.category == "rug" and r.where == "middle" for r in rules_of(room, CATALOG)
        )
        if "rug" in found and not by_itself:
            assert not {"coffee_table", "bed", "dining_table", "desk"}.isdisjoint(found)


def test_rugs_lie_on_free_floor_and_no_door_swings_over_them(stages):
    for made in stages:
        for item, info in pieces(made):
            if item.category != "rug":
                continue
            x, y, _ = item.pose.position_m
            shape = Polygon(corners_of(info, x, y, yaw_of(item.pose.quat_xyzw)))
            room = next(r for r in made.context.home.rooms if r.id == item.room_id)
            assert Polygon(room.polygon_m).covers(shape)
            for opening in made.context.home.openings:
                if opening.kind == "door" and opening.room_ids[0] == room.id:
                    leaf = opening_rectangle(opening, opening.width_m)
                    assert not shape.intersects(leaf)


def test_large_rugs_mostly_come_first_where_a_rule_says_so():
    home = stage(0)
    room = home.context.home.rooms[0]
    rug = FurnitureRule(category="rug", where="middle", largest=True)
    firsts = []
    for seed in range(20):
        tried = empty_room(
            home.context.home, room, home.layout, CATALOG, LIBRARY.by_category, lane(seed, 0, "rug")
        )
        firsts.append(_candidates(rug, None, tried)[0].extents_m)
    assert min(deep * wide for deep, wide, _ in firsts) > 2.0
    assert len(set(firsts)) > 1


def test_needed_pieces_are_there_and_chairs_face_their_table(stages):
    for made in stages:
        types = {room.id: room.type for room in made.context.home.rooms}
        by_room: dict[str, set[str]] = {}
        for item, _ in pieces(made):
            by_room.setdefault(types[item.room_id], set()).add(item.category)
        assert {"stove", "fridge", "sink_cabinet", "kitchen_counter"} <= by_room["kitchen"]
        assert {"bed", "wardrobe", "nightstand"} <= by_room["bedroom"]
        assert {"toilet", "washbasin"} <= by_room["bathroom"]
        tables = [i for i, _ in pieces(made) if i.category in ("kitchen_table", "dining_table")]
        for table in tables:
            tx, ty, _ = table.pose.position_m
            for chair, _ in pieces(made):
                x, y, _ = chair.pose.position_m
                apart = math.hypot(tx - x, ty - y)
                same = chair.room_id == table.room_id
                if chair.category == "chair" and same and apart < 0.9:
                    yaw = yaw_of(chair.pose.quat_xyzw)
                    ahead = math.cos(yaw) * (tx - x) + math.sin(yaw) * (ty - y)
                    assert ahead > 0, "a chair turns its back on its table"


def in_rooms(stages):
    """Of each room its pieces by category."""
    for made in stages:
        for room in made.context.home.rooms:
            found: dict[str, list] = {}
            for item, _ in pieces(made):
                if item.room_id == room.id:
                    found.setdefault(item.category, []).append(item)
            yield room, found


def seen_from(item, other):
    """Where another piece is, seen from one: (ahead, to the left), metres."""
    yaw = yaw_of(item.pose.quat_xyzw)
    dx, dy = (b - a for a, b in zip(item.pose.position_m, other.pose.position_m[:2], strict=False))
    return dx * math.cos(yaw) + dy * math.sin(yaw), dy * math.cos(yaw) - dx * math.sin(yaw)


def test_seats_and_bedside_tables_of_a_group_are_of_one_model(stages):
    compared = 0
    for room, found in in_rooms(stages):
        alike = [found.get("nightstand", [])]
        if room.type in ("kitchen", "dining_room"):
            alike.append(found.get("chair", []))
        for some in alike:
            compared += len(some) > 1
            assert len({item.asset for item in some}) <= 1
    assert compared


def test_every_desk_has_a_chair_that_one_can_sit_on(stages):
    desks = 0
    for _, found in in_rooms(stages):
        seats = [*found.get("chair", ()), *found.get("office_chair", ())]
        for desk in found.get("desk", ()):
            desks += 1
            near = [seen_from(desk, seat) for seat in seats]
            assert any(0.0 < ahead < 1.0 and abs(left) < 0.3 for ahead, left in near)
    assert desks


def test_a_sofa_sees_its_television(stages):
    seen = 0
    for _, found in in_rooms(stages):
        for tv in found.get("tv", ()):
            (sofa,) = found["sofa"]
            seen += 1
            ahead, left = seen_from(sofa, tv)
            assert ahead > 1.0
            assert abs(left) < 1.0
            assert math.cos(yaw_of(sofa.pose.quat_xyzw) - yaw_of(tv.pose.quat_xyzw)) < -0.9
            view = LineString([sofa.pose.position_m[:2], tv.pose.position_m[:2]])
            for category in ("dining_table", "armchair", "bookshelf", "desk", "chair"):
                for other in found.get(category, ()):
                    x, y, _ = other.pose.position_m
                    shape = corners_of(
                        LIBRARY.info(other.asset), x, y, yaw_of(other.pose.quat_xyzw)
                    )
                    assert not Polygon(shape).intersects(view), category
    assert seen


def test_rules_about_a_piece_placed_before_are_of_its_group():
    def rule(category: str, *of: str) -> FurnitureRule:
        return FurnitureRule(category=category, where="beside" if of else "wall", of=of)

    rules = [
        rule("bed"),
        rule("nightstand", "bed"),
        rule("lamp", "nightstand"),
        rule("wardrobe"),
        rule("picture", "bed"),
        rule("vase", "picture", "dresser"),
    ]
    names = [[rule.category for rule in group] for group in groups_of(rules)]
    assert names == [["bed", "nightstand", "lamp"], ["wardrobe"], ["picture", "vase"]]


def test_free_stretches_of_a_wall_are_what_nothing_near_takes():
    side = sides_of([(0.0, 0.0), (5.0, 0.0), (5.0, 4.0), (0.0, 4.0)])[0]
    near = np.array([(1.0, 0.1), (2.0, 0.1), (2.0, 0.6), (1.0, 0.6)])
    far = near + np.array([1.5, 1.0])
    free = [(part.start[0], part.length_m) for part in free_parts(side, [near, far], 0.6)]
    assert free == [(0.0, 1.0), (2.0, 3.0)]
    assert list(free_parts(side, [], 0.6)) == [side]
    across = np.array([(-1.0, 0.2), (6.0, 0.2), (6.0, 0.4), (-1.0, 0.4)])
    assert list(free_parts(side, [across], 0.6)) == []


def test_cupboards_have_their_backs_to_a_wall(stages):
    backed = ("wardrobe", "bookshelf", "fridge", "stove", "sofa", "dresser", "toilet")
    for made in stages:
        rooms = {room.id: room for room in made.context.home.rooms}
        for item, info in pieces(made):
            if item.category not in backed:
                continue
            x, y, _ = item.pose.position_m
            gaps = []
            for side in sides_of(rooms[item.room_id].polygon_m):
                t, away = side.measure((x, y))
                turn = yaw_of(item.pose.quat_xyzw) - side.yaw
                if abs(math.sin(turn)) < 1e-3 and math.cos(turn) > 0 and 0 < t < side.length_m:
                    gaps.append(away - info.extents_m[0] / 2)
            # The units at both ends of a U stand a little off, where they do not fill its wall, or
            # nearer, where they just fit.
            unit = item.category in ("fridge", "stove")
            near, off = (NEARER_M, BEHIND_M) if unit else (0.0, 0.0)
            assert 0.028 - near < min(gaps) < 0.032 + off, item.category


def test_a_dish_rack_stands_by_the_sink(stages):
    """On the nearest worktop that has room: of two side by side, or across from each other, none is
    much nearer."""
    racks = 0
    for made in stages:
        items = made.layout.items
        for rack in (item for item in items.values() if item.category == "dish_rack"):
            racks += 1
            at = items[made.layout.intents[rack.id].target_id]
            sinks = [i for i in items.values() if i.category == "sink_cabinet"]
            tops = [i for i in items.values() if i.category == at.category]
            apart = {
                top.id: min(math.dist(top.pose.position_m, s.pose.position_m) for s in sinks)
                for top in tops
                if top.room_id == rack.room_id
            }
            assert apart[at.id] <= min(apart.values()) + 0.15
    assert racks > 2


def test_homes_differ_and_have_three_to_ten_rooms(stages):
    counts = {len(made.context.home.rooms) for made in stages}
    assert counts <= set(range(3, 11))
    assert len(counts) > 1
    assert len({made.context.home.rooms[0].polygon_m for made in stages}) == len(stages)


def test_a_generated_home_keeps_its_id_and_split_through_attempts():
    choice = pick_home(CATALOG, OPTIONS, 3)
    first, second = (choice.spec(CATALOG, lane(9, 3, f"plan:{k}")) for k in range(2))
    assert isinstance(first, HomeSpec)
    assert isinstance(second, HomeSpec)
    assert first.id == second.id == choice.id
    assert first.rooms != second.rooms


def test_what_is_left_free_is_what_a_reader_of_the_scene_finds(stages):
    for made in stages:
        scene = made.scene(0, made.layout.items)
        # As nobody left it: what stands open is no part of the home.
        shut = [at_rest(item, LIBRARY.info(item.asset)) for item in scene.objects]
        furniture = bodies_of(shut, LIBRARY.infos)
        free = free_shape(scene.home, floor_obstacles(furniture))
        assert rounded_rings(free) == made.free_space
        traits = {c.name: c.properties for c in CATALOG.categories}
        zones = derive_zones(scene.home, furniture, free, traits)
        assert zones == tuple(made.context.zones)
