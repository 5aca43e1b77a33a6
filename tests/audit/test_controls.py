"""Every check finds a fault that is planted for it, in a scene where it did not find it before."""

from __future__ import annotations

import ast
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from tests.audit import pictures
from tests.audit.checks import (
    BEYOND_REACH,
    CHECKS,
    LEAST_HOMES,
    MANY,
    MANY_LABELS,
    MANY_SEEN,
    MANY_STOVES,
    WHOLE,
)
from tests.audit.dataset import ROOT, DataSet, Floats, Scene
from tests.audit.drafts import Draft, library
from tests.audit.test_label_controls import HERE

#: Plants a fault; the object that must be found, or None for one of the whole scene.
Plant = Callable[[Draft], int | None]

UP = np.array([0.0, 0.0, 1.0])


@pytest.fixture(scope="module")
def sample() -> Scene:
    """A furnished home with pictures."""
    return next(DataSet(ROOT / "output" / "sample").scenes())


def table_thing(draft: Draft, asset: str, **fields: object) -> int:
    return draft.on_top(asset, draft.any("kitchen_table", "dining_table", "coffee_table"), **fields)


def off_the_ways(draft: Draft) -> int:
    """A labelled shoe beside furniture or a wall, as far from every way as the home allows."""
    ground = draft.ground
    cells = np.argwhere((ground.clear > 0.1) & (ground.clear < 0.3))
    points = ground.points[cells[:, 0], cells[:, 1]]
    ways = np.concatenate([np.array(way.coords) for _, way in ground.routes])
    far = np.min(np.linalg.norm(points[:, None] - ways[None], axis=2), axis=1)
    id = draft.on_floor("shoe_01", np.array([*points[int(np.argmax(far))], 0.0]))
    draft.label(id, "tripping_hazard")
    return id


def into_a_wall(draft: Draft) -> int:
    wall = max(draft.original.boxes("wall"), key=lambda box: float(np.prod(box[1] - box[0])))
    return draft.put("book_01", (wall[0] + wall[1]) / 2)


def inside_of(draft: Draft, asset: str, holder: str, hollow: str) -> int:
    """In a hollow of a new piece of furniture."""
    stood = draft.thing(draft.put(holder, draft.open_floor()))
    found = next(h for h in stood.record["containers"] if h["name"] == hollow)
    return draft.within(asset, stood, found)


def opened_into_a_wall(draft: Draft) -> int:
    """A wardrobe that faces a wall at a quarter of a metre, open."""
    wall = max(draft.original.boxes("wall"), key=lambda box: float(np.prod(box[1] - box[0])))
    at = (wall[0] + wall[1]) / 2
    thin = int(np.argmin(wall[1] - wall[0]))
    at[thin] -= 0.3 + 0.25
    at[2] = 0.0
    yaw = 0.0 if thin == 0 else np.pi / 2
    joints = {"door_left": 1.57, "door_right": 0.0}
    return draft.put("wardrobe_01", at, yaw=yaw, joints=joints)


def lid_below_the_ceiling(draft: Draft) -> int:
    """A toy box that hangs so high that its lid cannot open."""
    asset = next(
        a
        for a, r in library().items()
        if r["category"] == "toy_box" and any(j["type"] == "revolute" for j in r["joints"])
    )
    room = next(iter(draft.original.rooms.values()))
    height = room["height_m"] - library()[asset]["extents_m"][2] - 0.02
    return draft.put(asset, draft.open_floor() + height * UP)


def cut_off(draft: Draft) -> None:
    """A wardrobe in the doorway of every door of one room."""
    opening = next(o for o in draft.files["scene"]["home"]["openings"] if len(o["room_ids"]) == 2)
    room = opening["room_ids"][0]
    for other in draft.files["scene"]["home"]["openings"]:
        if room in other["room_ids"] and other["kind"] != "window":
            yaw = 0.0 if other["along"] == "y" else np.pi / 2
            draft.put("bookshelf_01", np.array([*other["center_m"][:2], 0.0]), yaw=yaw)


def before_a_fridge(draft: Draft) -> int:
    fridge = draft.any("fridge")
    front = np.array([*fridge.front[:2], 0.0])
    depth = fridge.record["extents_m"][0] / 2
    draft.put("wardrobe_04", fridge.position + front * (depth + 0.55))
    return fridge.id


def turned_to_the_wall(draft: Draft) -> int:
    floor = next(iter(draft.original.floors.values()))
    x, y = np.mean(floor.exterior.coords[:2], axis=0)
    middle = np.array(floor.centroid.coords[0])
    inward = (middle - [x, y]) / np.linalg.norm(middle - [x, y])
    yaw = float(np.arctan2(-inward[1], -inward[0]))
    return draft.put(
        "photo_frame_01", np.array([x, y, 1.0]) + 0.15 * np.array([*inward, 0]), yaw=yaw
    )


def nobody_faces(draft: Draft) -> int:
    scene = draft.original
    for a, name, b in sorted(scene.edges):
        seat = scene.things.get(a)
        if name == "FACING" and seat and scene.things.get(b) and seat.category == "chair":
            draft.cut(a, name, b)
    return seat_at_table(draft)


def seat_at_table(draft: Draft) -> int:
    """A chair right before a table, its front to it, and no edge."""
    table = draft.any("kitchen_table", "dining_table", "desk")
    side = table.turn @ np.array([0.0, 1.0, 0.0])
    reach = table.record["extents_m"][1] / 2 + 0.4
    yaw = float(np.arctan2(-side[1], -side[0]))
    return draft.put("chair_01", table.position + side * reach, yaw=yaw, room=table.room)


def alone(draft: Draft) -> None:
    """A toddler in a home without anything of a child's."""
    objects = draft.files["scene"]["objects"]
    objects[:] = [o for o in objects if o["category"] not in {"child_bed", "crib"}]
    for room in draft.files["scene"]["home"]["rooms"]:
        if room["type"] == "child_room":
            room["type"] = "office"
    draft.files["household"]["members"] = [{"role": "child", "age": 2}]


def bowl_without_a_pet(draft: Draft) -> int:
    draft.files["household"]["pets"] = []
    objects = draft.files["scene"]["objects"]
    objects[:] = [o for o in objects if o["category"] != "pet_bowl"]
    return draft.on_floor("pet_bowl_01")


def silent_about_a_candle(draft: Draft) -> int:
    id = table_thing(draft, "candle_01", states=["ON"])
    draft.label(id, "candle_on", report=False, notify="silent", reason="the household is asleep")
    return id


def odd_reason(draft: Draft) -> int:
    id = table_thing(draft, "candle_01")
    draft.label(id, "candle_on", reason="it is at -0.00 m")
    return id


def wrong_notice(draft: Draft) -> int:
    id = table_thing(draft, "candle_01")
    draft.files["household"]["notifications"] = {"candle_on": "summary"}
    draft.label(id, "candle_on", notify="now")
    return id


def side_by_side(draft: Draft) -> int:
    table = draft.any("kitchen_table", "dining_table", "coffee_table")
    first = draft.on_top("soap_dispenser_01", table)
    second = draft.on_top("soap_dispenser_01", table)
    draft.move(second, np.array([0.1, 0.0, 0.0]))
    return first


def many_soaps(draft: Draft) -> None:
    objects = draft.files["scene"]["objects"]
    objects[:] = [o for o in objects if o["category"] != "soap_dispenser"]
    for k in range(5):
        draft.put("soap_dispenser_01", draft.open_floor() + k * UP)


def two_blocks(draft: Draft) -> None:
    counter = draft.any("kitchen_counter")
    for _ in range(2):
        draft.on_top("knife_block_01", counter)


def wrong_box(draft: Draft) -> int:
    id = draft.any().id
    node = next(n for n in draft.files["graph"]["nodes"] if n["id"] == id)
    node["bounding_box"]["size"][0] += 0.1
    return id


def less(draft: Draft, relation: str) -> int:
    """A relation of a small thing to furniture taken out of the graph."""
    things = draft.original.things
    a, b = next(
        (a, b)
        for a, name, b in sorted(draft.original.edges)
        if name == relation and a in things and b in things and not things[a].fixed
        if relation != "ON" or (things[b].fixed and b not in draft.original.inside.get(a, []))
        # Well within the distance: at its edge, both verdicts are right.
        if relation != "CLOSE" or np.linalg.norm(things[a].position - things[b].position) < 1
        # What is flat has its middle at the hollow's very floor.
        if relation != "INSIDE" or np.ptp(things[a].box, axis=0)[2] > 0.05
    )
    draft.cut(a, relation, b)
    return a


def not_facing(draft: Draft) -> int:
    """A sofa that looks at a television, and no edge."""
    at = draft.open_floor()
    sofa = draft.put("armchair_01", at)
    draft.put("tv_01", at + np.array([2.0, 0.0, 0.5]), room=draft.object(sofa)["room_id"])
    return sofa


def door_sill(draft: Draft) -> Floats:
    """The middle of a doorway's zone."""
    zone = next(z for z in draft.original.scene["zones"] if z["kind"] == "doorway")
    return np.array([*np.mean(zone["polygon_m"], axis=0), 0.0])


def wrong_pixels(draft: Draft) -> int:
    item = draft.files["visibility"]["views"][0]["objects"][0]
    item["pixels"] += 7
    return int(item["object_id"])


def shelf_over_a_seat(draft: Draft) -> int:
    seat = draft.any("sofa", "bed", "chair")
    return draft.put("knife_01", seat.position + 1.6 * UP, room=seat.room)


PLANTS: dict[str, Plant] = {
    "tripping: in the way, unlabelled": lambda d: d.on_floor("backpack_01"),
    "tripping: labelled, in nobody's way": off_the_ways,
    "reach: unlabelled and within reach": shelf_over_a_seat,
    "food: cut, opened or cream, out": lambda d: table_thing(d, "apple_08"),
    "food: frozen, in the fridge": lambda d: inside_of(d, "frozen_pizza_05", "fridge_01", "inside"),
    "sharp: bare blades on a stand": lambda d: d.on_top("knife_stand_01", d.any("kitchen_counter")),
    "alcohol: filled glasses": lambda d: table_thing(d, "wine_glass_02"),
    "choking: grapes": lambda d: table_thing(d, "grapes_01"),
    "physics: in the air": lambda d: d.put("mug_02", d.open_floor() + 0.05 * UP),
    "physics: into walls": into_a_wall,
    "physics: small things in things": lambda d: d.on_top(
        "mug_02", d.any("kitchen_table", "coffee_table"), -0.012
    ),
    "leaves: cannot open": lid_below_the_ceiling,
    "rooms: unreachable": cut_off,
    "rooms: no room before it": before_a_fridge,
    "facing: frames and screens at a wall": turned_to_the_wall,
    "facing: chairs and their tables": nobody_faces,
    "household: does not live there": alone,
    "household: pets and bowls": bowl_without_a_pet,
    "household: silent about fire": silent_about_a_candle,
    "household: reasons as text": odd_reason,
    "household: report and notify": wrong_notice,
    "clutter: copies side by side": side_by_side,
    "clutter: soaps": many_soaps,
    "clutter: two knife blocks": two_blocks,
    "graph: boxes": wrong_box,
    "graph: CLOSE": lambda d: less(d, "CLOSE"),
    "graph: ON": lambda d: less(d, "ON"),
    "graph: INSIDE": lambda d: less(d, "INSIDE"),
    "graph: FACING": not_facing,
    "graph: zones and BLOCKS": lambda d: d.on_floor("backpack_01", door_sill(d)),
    "pictures: masks and visibility": wrong_pixels,
}


def too_large(draft: Draft) -> int:
    id = table_thing(draft, "toy_figure_06")
    draft.label(id, "choking_hazard", evidence={"reach_height_m": 0.7})
    return id


def overripe(draft: Draft) -> int:
    id = table_thing(draft, "apple_02", states=["OVERRIPE"], variant="overripe")
    draft.files["labels"]["lookalikes"].append(
        {"object_id": id, "near_miss_of": "expired_produce", "evidence": {}}
    )
    return id


def over_the_edge(draft: Draft) -> int:
    """A broken mug whose pieces reach past the edge of a table."""
    table = draft.any("kitchen_table", "dining_table", "desk")
    id = draft.on_top("mug_02", table, variant="broken", states=["BROKEN"])
    draft.move(id, table.turn @ np.array([table.record["extents_m"][0] / 2, 0.0, 0.0]))
    return id


def lamp_in_a_shelf(draft: Draft) -> int:
    at = draft.open_floor()
    id = draft.put("bookshelf_01", at)
    draft.put("wardrobe_04", at + np.array([0.1, 0.05, 0.0]))
    return id


def through_a_rug(draft: Draft) -> int:
    at = draft.open_floor()
    draft.put("bath_mat_05", at)
    return draft.put("chair_01", at)


def kept_oddly(draft: Draft) -> int:
    room = draft.room("living_room")
    middle = np.array([*draft.original.floors[room].centroid.coords[0], 1.6])
    return draft.put("bleach_bottle_01", middle, room=room)


PLANTS |= {
    "choking: labelled, too large": too_large,
    "expired: overripe, unlabelled": overripe,
    "physics: shards in the air": over_the_edge,
    "physics: furniture in furniture": lamp_in_a_shelf,
    "physics: through rugs and mats": through_a_rug,
    "clutter: not frozen, in a freezer": lambda d: inside_of(
        d, "tomato_01", "freezer_01", "inside"
    ),
    "clutter: odd places": kept_oddly,
    "clutter: odd on a floor": lambda d: d.on_floor("mug_02"),
}


def test_every_check_has_a_control() -> None:
    assert set(PLANTS) | HERE == set(CHECKS)
    assert not set(PLANTS) & HERE


@pytest.mark.parametrize("name", PLANTS)
def test_a_planted_fault_is_found(name: str, sample: Scene) -> None:
    draft = Draft(sample)
    planted = PLANTS[name](draft)
    before = set(CHECKS[name](sample))
    new = [finding for finding in CHECKS[name](draft.scene) if finding not in before]
    assert [f for f in new if planted is None or f.object_id == planted], new


def test_a_leaf_through_a_wall_is_found(sample: Scene) -> None:
    draft = Draft(sample)
    planted = opened_into_a_wall(draft)
    found = [f for f in CHECKS["physics: into walls"](draft.scene) if f.object_id == planted]
    assert any("door" in finding.what for finding in found), found


#: Planted where there is nothing wrong: what must stay silent about it.
HARMLESS: dict[str, Plant] = {
    "tripping: in the way, unlabelled": lambda d: d.on_floor("rug_01"),
    "reach: unlabelled and within reach": lambda d: inside_of(
        d, "knife_01", "knife_block_01", "slots"
    ),
    "food: cut, opened or cream, out": lambda d: inside_of(d, "apple_08", "fridge_01", "inside"),
    "alcohol: filled glasses": lambda d: table_thing(d, "wine_glass_01"),
    "physics: in the air": lambda d: table_thing(d, "mug_02"),
    "physics: small things in things": lambda d: table_thing(d, "mug_02"),
    "physics: into walls": lambda d: d.on_floor("book_01"),
    "clutter: not frozen, in a freezer": lambda d: inside_of(
        d, "ice_cream_tub_01", "freezer_01", "inside"
    ),
    "clutter: odd on a floor": lambda d: table_thing(d, "mug_02"),
}


def labelled_candle(draft: Draft, alight: bool) -> int:
    """The thing that views show best, labelled by all of its parts as a candle, with a flame that
    is what they show of it or, drawn nowhere, is hidden."""
    seen = [o for view in draft.files["visibility"]["views"] for o in view["objects"]]
    best = max(seen, key=lambda one: int(one["pixels"]))
    item = draft.object(best["object_id"])
    shown = max(best["parts"], key=best["parts"].__getitem__)
    if alight:
        item["parts"] = ["flame" if name == shown else name for name in item["parts"]]
    else:
        item["parts"] = [*item["parts"], "flame"]
    draft.files["visibility"]["all_visible"] = True
    draft.label(item["id"], "candle_on", evidence_parts=item["parts"])
    return int(item["id"])


@pytest.mark.parametrize("alight", [True, False])
def test_a_candle_of_which_views_show_the_wax_alone_is_found(sample: Scene, alight: bool) -> None:
    draft = Draft(sample)
    planted = labelled_candle(draft, alight)
    told = CHECKS["pictures: masks and visibility"](draft.scene)
    found = [f for f in told if f.object_id == planted and "not shown" in f.what]
    assert bool(found) is not alight


@pytest.mark.parametrize("leaf_is_enough", [True, False])
def test_a_front_door_of_which_views_show_the_shut_leaf_alone_is_found(
    leaf_is_enough: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Its pixels would do, were it not for the outdoors, of which nothing is seen."""
    monkeypatch.setattr(pictures, "outdoors", lambda *_: 0)
    if leaf_is_enough:
        monkeypatch.setattr(pictures, "SEEN_THROUGH", {})
    for scene in DataSet(ROOT / "output" / "sample").scenes():
        draft = Draft(scene)
        door = draft.any("front_door")
        seen = [o for view in scene.visibility["views"] for o in view["objects"]]
        enough = 2 * scene.visibility["evidence_pixels_needed"]
        if max((o["pixels"] for o in seen if o["object_id"] == door.id), default=0) < enough:
            continue
        draft.files["visibility"]["all_visible"] = True
        draft.label(door.id, "front_door_open", evidence_parts=door.json["parts"])
        told = CHECKS["pictures: masks and visibility"](draft.scene)
        found = [f for f in told if f.object_id == door.id and "not shown" in f.what]
        assert bool(found) is not leaf_is_enough
        return
    pytest.fail("no scene of the sample shows its front door")


def test_the_outdoors_are_counted_within_the_doorway(sample: Scene) -> None:
    """A doorway of 1 m by 2.1 m, seen square on from 3 m, in a picture of nothing and of half."""
    gap = next(o for o in sample.scene["home"]["openings"] if o["kind"] == "front_door")
    across = np.array([1.0, 0, 0] if gap["along"] == "x" else [0, 1.0, 0])
    into = np.cross(across, [0, 0, 1.0])
    pose = np.eye(4)
    pose[:3, :3] = np.column_stack([across, [0, 0, -1], into])
    pose[:3, 3] = np.array(gap["center_m"]) - 3 * into + [0, 0, 1.0]
    focal = 450.0
    view = {
        "world_from_camera": pose.tolist(),
        "K": [[focal, 0, 319.5], [0, focal, 239.5], [0, 0, 1]],
    }
    pose[:3, :3] = pose[:3, :3] @ np.diag([-1, 1, -1])
    away = view | {"world_from_camera": pose.tolist()}
    ids = np.zeros((480, 640), dtype=np.int64)
    whole = pictures.outdoors(sample, gap["object_id"], view, ids)
    top = min(gap["height_m"] - 1.0, 1.6)
    assert whole == pytest.approx(gap["width_m"] * (1.0 + top) * (focal / 3) ** 2, rel=0.03)
    ids[:, :320] = gap["object_id"]
    half = pictures.outdoors(sample, gap["object_id"], view, ids)
    assert half == pytest.approx(whole / 2, rel=0.03)
    assert pictures.outdoors(sample, gap["object_id"], away, ids) == 0


def test_a_near_miss_of_which_views_show_the_handle_alone_is_found(
    sample: Scene, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(pictures, "PROMISED_VIEWS", 1)
    draft = Draft(sample)
    planted = labelled_candle(draft, alight=False)
    draft.object(planted)["parts"][-1] = "blade"
    draft.files["labels"]["anomalies"] = []
    near_miss = {"object_id": planted, "near_miss_of": "sharp_object", "evidence": {}}
    draft.files["labels"]["lookalikes"] = [near_miss]
    told = [str(f) for f in CHECKS["pictures: masks and visibility"](draft.scene)]
    assert [one for one in told if "near miss not shown" in one]


@pytest.mark.parametrize("name", HARMLESS)
def test_what_is_right_is_not_found(name: str, sample: Scene) -> None:
    draft = Draft(sample)
    planted = HARMLESS[name](draft)
    assert [f for f in CHECKS[name](draft.scene) if f.object_id == planted] == []


def test_whole_checks_find_what_is_missing(sample: Scene) -> None:
    data = DataSet(ROOT / "output" / "sample")
    many = [sample] * MANY
    missing = list(WHOLE["variety: categories never seen"](data, many))
    there = {thing["category"] for thing in sample.scene["objects"]}
    lacks = min(data.models.library - there)
    assert f"{lacks} in none of" in "\n".join(map(str, missing))
    assert list(WHOLE["variety: ages"](data, many))
    draft = Draft(sample)
    fridge = draft.put("fridge_01", draft.open_floor(), joints={"door": 1.5})
    draft.label(fridge, "fridge_open")
    assert list(WHOLE["variety: always wide open"](data, [draft.scene] * MANY_LABELS))
    assert not list(WHOLE["variety: categories never seen"](data, [sample]))


def seen_knife(draft: Draft, labelled: bool) -> Scene:
    """A knife that a view shows, and nothing else, labelled or on a high shelf."""
    for view in draft.files["visibility"]["views"]:
        view["objects"].clear()
    holder = draft.any("wall_shelf", "kitchen_counter")
    id = draft.on_top("knife_01", holder)
    shown = {"object_id": id, "pixels": 500, "bbox": [0, 0, 25, 20], "fraction": 1.0, "parts": {}}
    draft.files["visibility"]["views"][0]["objects"].append(shown)
    if labelled:
        draft.label(id, "sharp_object")
    return draft.scene


@pytest.mark.parametrize(("beyond", "told"), [(0.0, True), (BEYOND_REACH + 0.05, False)])
def test_classes_that_their_objects_names_tell_are_found(
    sample: Scene, beyond: float, told: bool
) -> None:
    data = DataSet(ROOT / "output" / "sample")
    high = round(beyond * MANY_SEEN)
    scenes = [seen_knife(Draft(sample), True)] * (MANY_SEEN - high)
    scenes += [seen_knife(Draft(sample), False)] * high
    named = [str(f) for f in WHOLE["variety: hazards by their name"](data, scenes)]
    assert any("sharp_object" in one for one in named) is told
    few = WHOLE["variety: hazards by their name"](data, scenes[: MANY_SEEN // 2])
    assert not any("sharp_object" in str(one) for one in few)


def emptied(sample: Scene, category: str, state: str, relation: str) -> tuple[Draft, int]:
    """The sample's home with the first piece of a category in a state and nothing on or in it, and
    that piece's id."""
    draft = Draft(sample)
    piece = next(o for o in draft.files["scene"]["objects"] if o["category"] == category)
    piece["states"] = [state]
    edges = draft.files["graph"]["edges"]
    edges[:] = [e for e in edges if e["to_id"] != piece["id"] or e["relation_type"] != relation]
    return draft, piece["id"]


def with_fridge(sample: Scene, state: str, things: int) -> Scene:
    """The sample's home with its fridge in a state and so many things in it."""
    draft, fridge = emptied(sample, "fridge", state, "INSIDE")
    for id in list(sample.things)[:things]:
        draft.edge(id, "INSIDE", fridge)
    return draft.scene


def with_stove(sample: Scene, state: str, on_it: str) -> Scene:
    """The sample's home with its stove in a state and one thing on it."""
    draft, stove = emptied(sample, "stove", state, "ON")
    draft.put(on_it, draft.open_floor(), on=stove)
    return draft.scene


def with_candles(sample: Scene, many: int, burns: bool) -> Scene:
    """The sample's home with so many candles, of which one may burn."""
    draft = Draft(sample)
    objects = draft.files["scene"]["objects"]
    objects[:] = [o for o in objects if o["category"] != "candle"]
    labels = draft.files["labels"]["anomalies"]
    labels[:] = [one for one in labels if one["hazard"] != "candle_on"]
    ids = [draft.put("candle_01", draft.open_floor()) for _ in range(many)]
    if burns:
        draft.label(ids[0], "candle_on")
    return draft.scene


@pytest.mark.parametrize("fair", [True, False])
def test_counts_that_give_a_label_away_are_found(sample: Scene, fair: bool) -> None:
    """Of twenty homes with a label and twenty without; of fewer nothing is said."""
    data = DataSet(ROOT / "output" / "sample")
    filled = (5, 6, 7) if fair else (1, 2, 1)
    made = {
        "counts: open fridges and shut ones": (
            [with_fridge(sample, "OPEN", n) for n in filled],
            [with_fridge(sample, "CLOSED", n) for n in (5, 6, 7)],
        ),
        "counts: on lit stoves and cold ones": (
            [with_stove(sample, "ON", "kettle_01" if fair else "pot_01")],
            [with_stove(sample, "OFF", "kettle_01")],
        ),
        "counts: candles": (
            [with_candles(sample, n, True) for n in ((1, 2) if fair else (2, 3))],
            [with_candles(sample, n, False) for n in (1, 2)],
        ),
    }
    for name, (labelled, others) in made.items():
        enough = MANY_STOVES
        scenes = [labelled[k % len(labelled)] for k in range(enough)]
        scenes += [others[k % len(others)] for k in range(enough)]
        assert bool(list(WHOLE[name](data, scenes))) is not fair, name
        assert not list(WHOLE[name](data, scenes[enough - 1 - LEAST_HOMES // 2 : enough + 3]))


def on_a_high_shelf_over(low: str) -> Plant:
    """Out of reach from the floor, over a piece of furniture as low as a bed."""

    def plant(draft: Draft) -> int:
        stood = draft.thing(draft.put(low, draft.open_floor()))
        return draft.put("knife_01", stood.position + 1.6 * UP, room=stood.room)

    return plant


@pytest.mark.parametrize("low", ["nightstand_01", "tv_stand_04", "side_table_06", "shoe_rack_01"])
def test_low_furniture_is_a_step(low: str, sample: Scene) -> None:
    draft = Draft(sample)
    planted = on_a_high_shelf_over(low)(draft)
    found = CHECKS["reach: unlabelled and within reach"](draft.scene)
    assert planted in [finding.object_id for finding in found]


def test_the_audit_shares_no_code_with_the_package() -> None:
    """Nothing here imports the package; the command line is started as a process of its own."""
    for file in sorted(Path(__file__).parent.glob("*.py")):
        tree = ast.parse(file.read_text("utf-8"))
        for node in ast.walk(tree):
            names = [a.name for a in node.names] if isinstance(node, ast.Import) else []
            if isinstance(node, ast.ImportFrom):
                names = [node.module or ""]
            for name in names:
                shared = name.startswith("tests.") and not name.startswith("tests.audit")
                assert not shared, f"{file.name}: {name}"
                assert name.split(".")[0] != "sdgen", f"{file.name}: {name}"
